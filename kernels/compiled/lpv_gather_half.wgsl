struct type_8 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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
var<storage> a: type_8;
@group(0) @binding(2) 
var<storage> b: type_8;
@group(0) @binding(3) 
var<storage> c: type_8;
@group(0) @binding(4) 
var<storage> d: type_8;

fn function_() {
    var phi_216_: f32;
    var phi_497_: type_12;
    var phi_500_: f32;
    var phi_502_: array<array<f32, 6>, 3>;
    var phi_498_: type_12;
    var phi_525_: type_12;
    var phi_555_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_657_: u32;
    var phi_658_: u32;
    var phi_659_: bool;
    var phi_668_: bool;
    var phi_680_: f32;
    var phi_733_: u32;
    var phi_734_: u32;
    var phi_735_: bool;
    var phi_744_: bool;
    var phi_756_: f32;
    var phi_809_: u32;
    var phi_810_: u32;
    var phi_811_: bool;
    var phi_820_: bool;
    var phi_832_: f32;
    var phi_885_: u32;
    var phi_886_: u32;
    var phi_887_: bool;
    var phi_896_: bool;
    var phi_908_: f32;
    var phi_961_: u32;
    var phi_962_: u32;
    var phi_963_: bool;
    var phi_972_: bool;
    var phi_984_: f32;
    var phi_1037_: u32;
    var phi_1038_: u32;
    var phi_1039_: bool;
    var phi_1048_: bool;
    var phi_1060_: f32;
    var phi_1113_: u32;
    var phi_1114_: u32;
    var phi_1115_: bool;
    var phi_1124_: bool;
    var phi_1136_: f32;
    var phi_1189_: u32;
    var phi_1190_: u32;
    var phi_1191_: bool;
    var phi_1200_: bool;
    var phi_1212_: f32;
    var phi_1265_: u32;
    var phi_1266_: u32;
    var phi_1267_: bool;
    var phi_1276_: bool;
    var phi_1288_: f32;
    var phi_1341_: u32;
    var phi_1342_: u32;
    var phi_1343_: bool;
    var phi_1352_: bool;
    var phi_1364_: f32;
    var phi_1417_: u32;
    var phi_1418_: u32;
    var phi_1419_: bool;
    var phi_1428_: bool;
    var phi_1440_: f32;
    var phi_1493_: u32;
    var phi_1494_: u32;
    var phi_1495_: bool;
    var phi_1504_: bool;
    var phi_1516_: f32;
    var phi_1569_: u32;
    var phi_1570_: u32;
    var phi_1571_: bool;
    var phi_1580_: bool;
    var phi_1592_: f32;
    var phi_1645_: u32;
    var phi_1646_: u32;
    var phi_1647_: bool;
    var phi_1656_: bool;
    var phi_1668_: f32;
    var phi_1721_: u32;
    var phi_1722_: u32;
    var phi_1723_: bool;
    var phi_1732_: bool;
    var phi_1744_: f32;
    var phi_1797_: u32;
    var phi_1798_: u32;
    var phi_1799_: bool;
    var phi_1808_: bool;
    var phi_1820_: f32;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1875_: bool;
    var phi_1884_: bool;
    var phi_1896_: f32;
    var phi_1949_: u32;
    var phi_1950_: u32;
    var phi_1951_: bool;
    var phi_1960_: bool;
    var phi_1972_: f32;
    var phi_1978_: f32;
    var phi_1979_: array<array<f32, 6>, 3>;
    var phi_501_: f32;
    var phi_503_: array<array<f32, 6>, 3>;
    var phi_16674_: bool;
    var local: f32;
    var local_1: f32;
    var phi_1985_: f32;
    var local_2: array<array<f32, 6>, 3>;
    var local_3: array<array<f32, 6>, 3>;
    var local_4: array<array<f32, 6>, 3>;
    var local_5: array<array<f32, 6>, 3>;
    var local_6: array<array<f32, 6>, 3>;
    var local_7: array<array<f32, 6>, 3>;
    var local_8: array<array<f32, 6>, 3>;
    var local_9: array<array<f32, 6>, 3>;
    var local_10: array<array<f32, 6>, 3>;
    var local_11: array<array<f32, 6>, 3>;
    var local_12: array<array<f32, 6>, 3>;
    var local_13: array<array<f32, 6>, 3>;
    var local_14: array<array<f32, 6>, 3>;
    var local_15: array<array<f32, 6>, 3>;
    var local_16: array<array<f32, 6>, 3>;
    var local_17: array<array<f32, 6>, 3>;
    var local_18: array<array<f32, 6>, 3>;
    var local_19: array<array<f32, 6>, 3>;
    var phi_16811_: bool;
    var phi_4273_: vec4<f32>;
    var phi_16809_: bool;
    var phi_4275_: vec4<f32>;
    var phi_4336_: f32;
    var phi_4617_: type_12;
    var phi_4620_: f32;
    var phi_4622_: array<array<f32, 6>, 3>;
    var phi_4618_: type_12;
    var phi_4645_: type_12;
    var phi_4675_: f32;
    var phi_4680_: f32;
    var phi_4686_: f32;
    var phi_4777_: u32;
    var phi_4778_: u32;
    var phi_4779_: bool;
    var phi_4788_: bool;
    var phi_4800_: f32;
    var phi_4853_: u32;
    var phi_4854_: u32;
    var phi_4855_: bool;
    var phi_4864_: bool;
    var phi_4876_: f32;
    var phi_4929_: u32;
    var phi_4930_: u32;
    var phi_4931_: bool;
    var phi_4940_: bool;
    var phi_4952_: f32;
    var phi_5005_: u32;
    var phi_5006_: u32;
    var phi_5007_: bool;
    var phi_5016_: bool;
    var phi_5028_: f32;
    var phi_5081_: u32;
    var phi_5082_: u32;
    var phi_5083_: bool;
    var phi_5092_: bool;
    var phi_5104_: f32;
    var phi_5157_: u32;
    var phi_5158_: u32;
    var phi_5159_: bool;
    var phi_5168_: bool;
    var phi_5180_: f32;
    var phi_5233_: u32;
    var phi_5234_: u32;
    var phi_5235_: bool;
    var phi_5244_: bool;
    var phi_5256_: f32;
    var phi_5309_: u32;
    var phi_5310_: u32;
    var phi_5311_: bool;
    var phi_5320_: bool;
    var phi_5332_: f32;
    var phi_5385_: u32;
    var phi_5386_: u32;
    var phi_5387_: bool;
    var phi_5396_: bool;
    var phi_5408_: f32;
    var phi_5461_: u32;
    var phi_5462_: u32;
    var phi_5463_: bool;
    var phi_5472_: bool;
    var phi_5484_: f32;
    var phi_5537_: u32;
    var phi_5538_: u32;
    var phi_5539_: bool;
    var phi_5548_: bool;
    var phi_5560_: f32;
    var phi_5613_: u32;
    var phi_5614_: u32;
    var phi_5615_: bool;
    var phi_5624_: bool;
    var phi_5636_: f32;
    var phi_5689_: u32;
    var phi_5690_: u32;
    var phi_5691_: bool;
    var phi_5700_: bool;
    var phi_5712_: f32;
    var phi_5765_: u32;
    var phi_5766_: u32;
    var phi_5767_: bool;
    var phi_5776_: bool;
    var phi_5788_: f32;
    var phi_5841_: u32;
    var phi_5842_: u32;
    var phi_5843_: bool;
    var phi_5852_: bool;
    var phi_5864_: f32;
    var phi_5917_: u32;
    var phi_5918_: u32;
    var phi_5919_: bool;
    var phi_5928_: bool;
    var phi_5940_: f32;
    var phi_5993_: u32;
    var phi_5994_: u32;
    var phi_5995_: bool;
    var phi_6004_: bool;
    var phi_6016_: f32;
    var phi_6069_: u32;
    var phi_6070_: u32;
    var phi_6071_: bool;
    var phi_6080_: bool;
    var phi_6092_: f32;
    var phi_6098_: f32;
    var phi_6099_: array<array<f32, 6>, 3>;
    var phi_4621_: f32;
    var phi_4623_: array<array<f32, 6>, 3>;
    var phi_16783_: bool;
    var local_20: f32;
    var local_21: f32;
    var phi_6105_: f32;
    var local_22: array<array<f32, 6>, 3>;
    var local_23: array<array<f32, 6>, 3>;
    var local_24: array<array<f32, 6>, 3>;
    var local_25: array<array<f32, 6>, 3>;
    var local_26: array<array<f32, 6>, 3>;
    var local_27: array<array<f32, 6>, 3>;
    var local_28: array<array<f32, 6>, 3>;
    var local_29: array<array<f32, 6>, 3>;
    var local_30: array<array<f32, 6>, 3>;
    var local_31: array<array<f32, 6>, 3>;
    var local_32: array<array<f32, 6>, 3>;
    var local_33: array<array<f32, 6>, 3>;
    var local_34: array<array<f32, 6>, 3>;
    var local_35: array<array<f32, 6>, 3>;
    var local_36: array<array<f32, 6>, 3>;
    var local_37: array<array<f32, 6>, 3>;
    var local_38: array<array<f32, 6>, 3>;
    var local_39: array<array<f32, 6>, 3>;
    var phi_17150_: bool;
    var phi_8393_: vec4<f32>;
    var phi_17149_: bool;
    var phi_8394_: vec4<f32>;
    var phi_17148_: bool;
    var phi_8395_: vec4<f32>;
    var phi_8396_: bool;
    var phi_8456_: f32;
    var phi_8737_: type_12;
    var phi_8740_: f32;
    var phi_8742_: array<array<f32, 6>, 3>;
    var phi_8738_: type_12;
    var phi_8765_: type_12;
    var phi_8795_: f32;
    var phi_8800_: f32;
    var phi_8806_: f32;
    var phi_8897_: u32;
    var phi_8898_: u32;
    var phi_8899_: bool;
    var phi_8908_: bool;
    var phi_8920_: f32;
    var phi_8973_: u32;
    var phi_8974_: u32;
    var phi_8975_: bool;
    var phi_8984_: bool;
    var phi_8996_: f32;
    var phi_9049_: u32;
    var phi_9050_: u32;
    var phi_9051_: bool;
    var phi_9060_: bool;
    var phi_9072_: f32;
    var phi_9125_: u32;
    var phi_9126_: u32;
    var phi_9127_: bool;
    var phi_9136_: bool;
    var phi_9148_: f32;
    var phi_9201_: u32;
    var phi_9202_: u32;
    var phi_9203_: bool;
    var phi_9212_: bool;
    var phi_9224_: f32;
    var phi_9277_: u32;
    var phi_9278_: u32;
    var phi_9279_: bool;
    var phi_9288_: bool;
    var phi_9300_: f32;
    var phi_9353_: u32;
    var phi_9354_: u32;
    var phi_9355_: bool;
    var phi_9364_: bool;
    var phi_9376_: f32;
    var phi_9429_: u32;
    var phi_9430_: u32;
    var phi_9431_: bool;
    var phi_9440_: bool;
    var phi_9452_: f32;
    var phi_9505_: u32;
    var phi_9506_: u32;
    var phi_9507_: bool;
    var phi_9516_: bool;
    var phi_9528_: f32;
    var phi_9581_: u32;
    var phi_9582_: u32;
    var phi_9583_: bool;
    var phi_9592_: bool;
    var phi_9604_: f32;
    var phi_9657_: u32;
    var phi_9658_: u32;
    var phi_9659_: bool;
    var phi_9668_: bool;
    var phi_9680_: f32;
    var phi_9733_: u32;
    var phi_9734_: u32;
    var phi_9735_: bool;
    var phi_9744_: bool;
    var phi_9756_: f32;
    var phi_9809_: u32;
    var phi_9810_: u32;
    var phi_9811_: bool;
    var phi_9820_: bool;
    var phi_9832_: f32;
    var phi_9885_: u32;
    var phi_9886_: u32;
    var phi_9887_: bool;
    var phi_9896_: bool;
    var phi_9908_: f32;
    var phi_9961_: u32;
    var phi_9962_: u32;
    var phi_9963_: bool;
    var phi_9972_: bool;
    var phi_9984_: f32;
    var phi_10037_: u32;
    var phi_10038_: u32;
    var phi_10039_: bool;
    var phi_10048_: bool;
    var phi_10060_: f32;
    var phi_10113_: u32;
    var phi_10114_: u32;
    var phi_10115_: bool;
    var phi_10124_: bool;
    var phi_10136_: f32;
    var phi_10189_: u32;
    var phi_10190_: u32;
    var phi_10191_: bool;
    var phi_10200_: bool;
    var phi_10212_: f32;
    var phi_10218_: f32;
    var phi_10219_: array<array<f32, 6>, 3>;
    var phi_8741_: f32;
    var phi_8743_: array<array<f32, 6>, 3>;
    var phi_17122_: bool;
    var local_40: f32;
    var local_41: f32;
    var phi_10225_: f32;
    var local_42: array<array<f32, 6>, 3>;
    var local_43: array<array<f32, 6>, 3>;
    var local_44: array<array<f32, 6>, 3>;
    var local_45: array<array<f32, 6>, 3>;
    var local_46: array<array<f32, 6>, 3>;
    var local_47: array<array<f32, 6>, 3>;
    var local_48: array<array<f32, 6>, 3>;
    var local_49: array<array<f32, 6>, 3>;
    var local_50: array<array<f32, 6>, 3>;
    var local_51: array<array<f32, 6>, 3>;
    var local_52: array<array<f32, 6>, 3>;
    var local_53: array<array<f32, 6>, 3>;
    var local_54: array<array<f32, 6>, 3>;
    var local_55: array<array<f32, 6>, 3>;
    var local_56: array<array<f32, 6>, 3>;
    var local_57: array<array<f32, 6>, 3>;
    var local_58: array<array<f32, 6>, 3>;
    var local_59: array<array<f32, 6>, 3>;
    var phi_17489_: bool;
    var phi_12513_: vec4<f32>;
    var phi_17488_: bool;
    var phi_12514_: vec4<f32>;
    var phi_17487_: bool;
    var phi_12515_: vec4<f32>;
    var phi_12516_: bool;
    var phi_12576_: f32;
    var phi_12857_: type_12;
    var phi_12860_: f32;
    var phi_12862_: array<array<f32, 6>, 3>;
    var phi_12858_: type_12;
    var phi_12885_: type_12;
    var phi_12915_: f32;
    var phi_12920_: f32;
    var phi_12926_: f32;
    var phi_13017_: u32;
    var phi_13018_: u32;
    var phi_13019_: bool;
    var phi_13028_: bool;
    var phi_13040_: f32;
    var phi_13093_: u32;
    var phi_13094_: u32;
    var phi_13095_: bool;
    var phi_13104_: bool;
    var phi_13116_: f32;
    var phi_13169_: u32;
    var phi_13170_: u32;
    var phi_13171_: bool;
    var phi_13180_: bool;
    var phi_13192_: f32;
    var phi_13245_: u32;
    var phi_13246_: u32;
    var phi_13247_: bool;
    var phi_13256_: bool;
    var phi_13268_: f32;
    var phi_13321_: u32;
    var phi_13322_: u32;
    var phi_13323_: bool;
    var phi_13332_: bool;
    var phi_13344_: f32;
    var phi_13397_: u32;
    var phi_13398_: u32;
    var phi_13399_: bool;
    var phi_13408_: bool;
    var phi_13420_: f32;
    var phi_13473_: u32;
    var phi_13474_: u32;
    var phi_13475_: bool;
    var phi_13484_: bool;
    var phi_13496_: f32;
    var phi_13549_: u32;
    var phi_13550_: u32;
    var phi_13551_: bool;
    var phi_13560_: bool;
    var phi_13572_: f32;
    var phi_13625_: u32;
    var phi_13626_: u32;
    var phi_13627_: bool;
    var phi_13636_: bool;
    var phi_13648_: f32;
    var phi_13701_: u32;
    var phi_13702_: u32;
    var phi_13703_: bool;
    var phi_13712_: bool;
    var phi_13724_: f32;
    var phi_13777_: u32;
    var phi_13778_: u32;
    var phi_13779_: bool;
    var phi_13788_: bool;
    var phi_13800_: f32;
    var phi_13853_: u32;
    var phi_13854_: u32;
    var phi_13855_: bool;
    var phi_13864_: bool;
    var phi_13876_: f32;
    var phi_13929_: u32;
    var phi_13930_: u32;
    var phi_13931_: bool;
    var phi_13940_: bool;
    var phi_13952_: f32;
    var phi_14005_: u32;
    var phi_14006_: u32;
    var phi_14007_: bool;
    var phi_14016_: bool;
    var phi_14028_: f32;
    var phi_14081_: u32;
    var phi_14082_: u32;
    var phi_14083_: bool;
    var phi_14092_: bool;
    var phi_14104_: f32;
    var phi_14157_: u32;
    var phi_14158_: u32;
    var phi_14159_: bool;
    var phi_14168_: bool;
    var phi_14180_: f32;
    var phi_14233_: u32;
    var phi_14234_: u32;
    var phi_14235_: bool;
    var phi_14244_: bool;
    var phi_14256_: f32;
    var phi_14309_: u32;
    var phi_14310_: u32;
    var phi_14311_: bool;
    var phi_14320_: bool;
    var phi_14332_: f32;
    var phi_14338_: f32;
    var phi_14339_: array<array<f32, 6>, 3>;
    var phi_12861_: f32;
    var phi_12863_: array<array<f32, 6>, 3>;
    var phi_17461_: bool;
    var local_60: f32;
    var local_61: f32;
    var phi_14345_: f32;
    var local_62: array<array<f32, 6>, 3>;
    var local_63: array<array<f32, 6>, 3>;
    var local_64: array<array<f32, 6>, 3>;
    var local_65: array<array<f32, 6>, 3>;
    var local_66: array<array<f32, 6>, 3>;
    var local_67: array<array<f32, 6>, 3>;
    var local_68: array<array<f32, 6>, 3>;
    var local_69: array<array<f32, 6>, 3>;
    var local_70: array<array<f32, 6>, 3>;
    var local_71: array<array<f32, 6>, 3>;
    var local_72: array<array<f32, 6>, 3>;
    var local_73: array<array<f32, 6>, 3>;
    var local_74: array<array<f32, 6>, 3>;
    var local_75: array<array<f32, 6>, 3>;
    var local_76: array<array<f32, 6>, 3>;
    var local_77: array<array<f32, 6>, 3>;
    var local_78: array<array<f32, 6>, 3>;
    var local_79: array<array<f32, 6>, 3>;
    var phi_16633_: vec4<f32>;
    var phi_16634_: vec4<f32>;
    var phi_16635_: vec4<f32>;
    var phi_16636_: bool;
    var phi_16645_: vec4<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e65 = gid_1;
            let _e68 = arrayLength((&a.member));
            let _e71 = arrayLength((&b.member));
            let _e74 = arrayLength((&c.member));
            let _e77 = arrayLength((&d.member));
            let _e85 = (_e65.x + (_e65.y * 2097152u));
            let _e86 = (_e85 < arrayLength((&irradiance.member)));
            if _e86 {
                if (_e85 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e90 = surfels.member[_e85];
                if (_e90.member_1 == 4294967295u) {
                    phi_16645_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e95 = params.member.member_7;
                    let _e96 = (1f / _e95);
                    let _e99 = params.member.member_3;
                    let _e100 = (0u >= _e99);
                    if _e100 {
                        phi_16809_ = false;
                        phi_4275_ = vec4<f32>();
                    } else {
                        let _e104 = params.member.member[0u];
                        let _e108 = params.member.member_1[0u];
                        let _e112 = params.member.member_2[0u];
                        if (1u == _e99) {
                            phi_216_ = 0f;
                        } else {
                            let _e124 = params.member.member_5;
                            phi_216_ = _e124;
                        }
                        let _e126 = phi_216_;
                        let _e134 = ((_e90.member[0] - _e104.x) / _e104.w);
                        let _e135 = ((_e90.member[1] - _e104.y) / _e104.w);
                        let _e136 = ((_e90.member[2] - _e104.z) / _e104.w);
                        let _e143 = (_e134 - f32(_e108.x));
                        let _e144 = (_e135 - f32(_e108.y));
                        let _e145 = (_e136 - f32(_e108.z));
                        let _e153 = select(_e145, _e144, (_e144 < _e145));
                        let _e155 = select(_e153, _e143, (_e143 < _e153));
                        let _e156 = (f32(_e112.x) - _e143);
                        let _e157 = (f32(_e112.y) - _e144);
                        let _e158 = (f32(_e112.z) - _e145);
                        let _e160 = select(_e158, _e157, (_e157 < _e158));
                        let _e162 = select(_e160, _e156, (_e156 < _e160));
                        let _e167 = (select(_e162, _e155, (_e155 < _e162)) / select(0.001f, _e126, (_e126 > 0.001f)));
                        let _e169 = select(0f, _e167, (_e167 > 0f));
                        let _e171 = select(1f, _e169, (_e169 < 1f));
                        if (_e171 <= 0f) {
                            phi_16811_ = false;
                            phi_4273_ = vec4<f32>(0f, 0f, 0f, 1f);
                        } else {
                            let _e175 = params.member.member_6;
                            let _e176 = (_e112.x + 1u);
                            let _e178 = ((_e112.y + 1u) * _e176);
                            let _e179 = (_e178 + _e176);
                            let _e182 = (_e179 + ((_e112.z + 1u) * _e178));
                            let _e189 = ((_e134 + (_e90.member_2[0] * _e175)) - 0.5f);
                            let _e190 = floor(_e189);
                            let _e192 = (bitcast<i32>(_e112.x) - 1i);
                            let _e200 = (select(0i, select(select(i32(_e190), i32(-2147483648), (_e190 < -2147483600f)), 2147483647i, (_e190 > 2147483500f)), (_e190 == _e190)) - _e108.x);
                            let _e202 = select(0i, _e200, (0i < _e200));
                            let _e204 = select(_e202, _e192, (_e192 < _e202));
                            let _e205 = (_e200 + 1i);
                            let _e207 = select(0i, _e205, (0i < _e205));
                            let _e209 = select(_e207, _e192, (_e192 < _e207));
                            let _e212 = (_e189 - _e190);
                            let _e219 = ((_e135 + (_e90.member_2[1] * _e175)) - 0.5f);
                            let _e220 = floor(_e219);
                            let _e222 = (bitcast<i32>(_e112.y) - 1i);
                            let _e230 = (select(0i, select(select(i32(_e220), i32(-2147483648), (_e220 < -2147483600f)), 2147483647i, (_e220 > 2147483500f)), (_e220 == _e220)) - _e108.y);
                            let _e232 = select(0i, _e230, (0i < _e230));
                            let _e234 = select(_e232, _e222, (_e222 < _e232));
                            let _e235 = (_e230 + 1i);
                            let _e237 = select(0i, _e235, (0i < _e235));
                            let _e239 = select(_e237, _e222, (_e222 < _e237));
                            let _e242 = (_e219 - _e220);
                            let _e249 = ((_e136 + (_e90.member_2[2] * _e175)) - 0.5f);
                            let _e250 = floor(_e249);
                            let _e252 = (bitcast<i32>(_e112.z) - 1i);
                            let _e260 = (select(0i, select(select(i32(_e250), i32(-2147483648), (_e250 < -2147483600f)), 2147483647i, (_e250 > 2147483500f)), (_e250 == _e250)) - _e108.z);
                            let _e262 = select(0i, _e260, (0i < _e260));
                            let _e264 = select(_e262, _e252, (_e252 < _e262));
                            let _e265 = (_e260 + 1i);
                            let _e267 = select(0i, _e265, (0i < _e265));
                            let _e269 = select(_e267, _e252, (_e252 < _e267));
                            let _e272 = (_e249 - _e250);
                            phi_497_ = type_12(0u, 8u);
                            phi_500_ = 0f;
                            phi_502_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                            loop {
                                let _e280 = phi_497_;
                                let _e282 = phi_500_;
                                let _e284 = phi_502_;
                                local = _e282;
                                local_1 = _e282;
                                local_2 = _e284;
                                local_3 = _e284;
                                local_4 = _e284;
                                local_5 = _e284;
                                local_6 = _e284;
                                local_7 = _e284;
                                local_8 = _e284;
                                local_9 = _e284;
                                local_10 = _e284;
                                local_11 = _e284;
                                local_12 = _e284;
                                local_13 = _e284;
                                local_14 = _e284;
                                local_15 = _e284;
                                local_16 = _e284;
                                local_17 = _e284;
                                local_18 = _e284;
                                local_19 = _e284;
                                if (_e280.member < _e280.member_1) {
                                    phi_498_ = type_12((_e280.member + 1u), _e280.member_1);
                                    phi_525_ = type_12(1u, _e280.member);
                                } else {
                                    phi_498_ = _e280;
                                    phi_525_ = type_12(0u, type_12().member_1);
                                }
                                let _e297 = phi_498_;
                                let _e299 = phi_525_;
                                let _e303 = (bitcast<i32>(_e299.member) != 0i);
                                if _e303 {
                                    let _e305 = ((_e299.member_1 & 1u) == 1u);
                                    let _e307 = ((_e299.member_1 & 2u) == 2u);
                                    let _e309 = ((_e299.member_1 & 4u) == 4u);
                                    if _e305 {
                                        phi_555_ = _e212;
                                    } else {
                                        phi_555_ = (1f - _e212);
                                    }
                                    let _e315 = phi_555_;
                                    if _e307 {
                                        phi_560_ = _e242;
                                    } else {
                                        phi_560_ = (1f - _e242);
                                    }
                                    let _e318 = phi_560_;
                                    if _e309 {
                                        phi_566_ = _e272;
                                    } else {
                                        phi_566_ = (1f - _e272);
                                    }
                                    let _e322 = phi_566_;
                                    let _e332 = (((((select((f32((_e204 + _e108.x)) + 0.5f), (f32((_e209 + _e108.x)) + 0.5f), _e305) - _e134) * _e90.member_2[0]) + ((select((f32((_e234 + _e108.y)) + 0.5f), (f32((_e239 + _e108.y)) + 0.5f), _e307) - _e135) * _e90.member_2[1])) + ((select((f32((_e264 + _e108.z)) + 0.5f), (f32((_e269 + _e108.z)) + 0.5f), _e309) - _e136) * _e90.member_2[2])) * 2f);
                                    let _e334 = select(0f, _e332, (_e332 > 0f));
                                    let _e337 = (((_e315 * _e318) * _e322) * select(1f, _e334, (_e334 < 1f)));
                                    if (_e337 > 0f) {
                                        let _e346 = (((_e179 + select(bitcast<u32>(_e204), bitcast<u32>(_e209), _e305)) + (select(bitcast<u32>(_e234), bitcast<u32>(_e239), _e307) * _e176)) + (select(bitcast<u32>(_e264), bitcast<u32>(_e269), _e309) * _e178));
                                        let _e348 = (_e346 < _e68);
                                        if _e348 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e350 = a.member[_e346];
                                        let _e351 = (_e350 & 65535u);
                                        let _e354 = ((_e351 & 32768u) << bitcast<u32>(16i));
                                        let _e357 = ((_e351 >> bitcast<u32>(10i)) & 31u);
                                        let _e358 = (_e351 & 1023u);
                                        if (_e357 == 0u) {
                                            phi_680_ = bitcast<f32>((_e354 | bitcast<u32>((f32(_e358) * 0.000000059604645f))));
                                        } else {
                                            if (_e357 == 31u) {
                                                phi_657_ = 255u;
                                                phi_658_ = u32();
                                                phi_659_ = true;
                                            } else {
                                                let _e361 = (_e357 + 112u);
                                                phi_657_ = _e361;
                                                phi_658_ = _e361;
                                                phi_659_ = (_e361 == 255u);
                                            }
                                            let _e364 = phi_657_;
                                            let _e366 = phi_658_;
                                            let _e368 = phi_659_;
                                            if _e368 {
                                                phi_668_ = (_e358 == 0u);
                                            } else {
                                                phi_668_ = true;
                                            }
                                            let _e371 = phi_668_;
                                            phi_680_ = bitcast<f32>((((_e354 | (select(_e364, select(_e366, _e364, _e368), _e371) << bitcast<u32>(23i))) | (_e358 << bitcast<u32>(13i))) | select(4194304u, 0u, _e371)));
                                        }
                                        let _e389 = phi_680_;
                                        if _e348 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e397 = ((_e350 >> bitcast<u32>(16u)) & 65535u);
                                        let _e400 = ((_e397 & 32768u) << bitcast<u32>(16i));
                                        let _e403 = ((_e397 >> bitcast<u32>(10i)) & 31u);
                                        let _e404 = (_e397 & 1023u);
                                        if (_e403 == 0u) {
                                            phi_756_ = bitcast<f32>((_e400 | bitcast<u32>((f32(_e404) * 0.000000059604645f))));
                                        } else {
                                            if (_e403 == 31u) {
                                                phi_733_ = 255u;
                                                phi_734_ = u32();
                                                phi_735_ = true;
                                            } else {
                                                let _e407 = (_e403 + 112u);
                                                phi_733_ = _e407;
                                                phi_734_ = _e407;
                                                phi_735_ = (_e407 == 255u);
                                            }
                                            let _e410 = phi_733_;
                                            let _e412 = phi_734_;
                                            let _e414 = phi_735_;
                                            if _e414 {
                                                phi_744_ = (_e404 == 0u);
                                            } else {
                                                phi_744_ = true;
                                            }
                                            let _e417 = phi_744_;
                                            phi_756_ = bitcast<f32>((((_e400 | (select(_e410, select(_e412, _e410, _e414), _e417) << bitcast<u32>(23i))) | (_e404 << bitcast<u32>(13i))) | select(4194304u, 0u, _e417)));
                                        }
                                        let _e435 = phi_756_;
                                        let _e441 = (3u * _e182);
                                        let _e442 = (_e441 + _e346);
                                        let _e443 = (_e442 < _e68);
                                        if _e443 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e445 = a.member[_e442];
                                        let _e446 = (_e445 & 65535u);
                                        let _e449 = ((_e446 & 32768u) << bitcast<u32>(16i));
                                        let _e452 = ((_e446 >> bitcast<u32>(10i)) & 31u);
                                        let _e453 = (_e446 & 1023u);
                                        if (_e452 == 0u) {
                                            phi_832_ = bitcast<f32>((_e449 | bitcast<u32>((f32(_e453) * 0.000000059604645f))));
                                        } else {
                                            if (_e452 == 31u) {
                                                phi_809_ = 255u;
                                                phi_810_ = u32();
                                                phi_811_ = true;
                                            } else {
                                                let _e456 = (_e452 + 112u);
                                                phi_809_ = _e456;
                                                phi_810_ = _e456;
                                                phi_811_ = (_e456 == 255u);
                                            }
                                            let _e459 = phi_809_;
                                            let _e461 = phi_810_;
                                            let _e463 = phi_811_;
                                            if _e463 {
                                                phi_820_ = (_e453 == 0u);
                                            } else {
                                                phi_820_ = true;
                                            }
                                            let _e466 = phi_820_;
                                            phi_832_ = bitcast<f32>((((_e449 | (select(_e459, select(_e461, _e459, _e463), _e466) << bitcast<u32>(23i))) | (_e453 << bitcast<u32>(13i))) | select(4194304u, 0u, _e466)));
                                        }
                                        let _e484 = phi_832_;
                                        if _e443 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e492 = ((_e445 >> bitcast<u32>(16u)) & 65535u);
                                        let _e495 = ((_e492 & 32768u) << bitcast<u32>(16i));
                                        let _e498 = ((_e492 >> bitcast<u32>(10i)) & 31u);
                                        let _e499 = (_e492 & 1023u);
                                        if (_e498 == 0u) {
                                            phi_908_ = bitcast<f32>((_e495 | bitcast<u32>((f32(_e499) * 0.000000059604645f))));
                                        } else {
                                            if (_e498 == 31u) {
                                                phi_885_ = 255u;
                                                phi_886_ = u32();
                                                phi_887_ = true;
                                            } else {
                                                let _e502 = (_e498 + 112u);
                                                phi_885_ = _e502;
                                                phi_886_ = _e502;
                                                phi_887_ = (_e502 == 255u);
                                            }
                                            let _e505 = phi_885_;
                                            let _e507 = phi_886_;
                                            let _e509 = phi_887_;
                                            if _e509 {
                                                phi_896_ = (_e499 == 0u);
                                            } else {
                                                phi_896_ = true;
                                            }
                                            let _e512 = phi_896_;
                                            phi_908_ = bitcast<f32>((((_e495 | (select(_e505, select(_e507, _e505, _e509), _e512) << bitcast<u32>(23i))) | (_e499 << bitcast<u32>(13i))) | select(4194304u, 0u, _e512)));
                                        }
                                        let _e530 = phi_908_;
                                        let _e536 = (_e182 * 6u);
                                        let _e537 = (_e536 + _e346);
                                        let _e538 = (_e537 < _e68);
                                        if _e538 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e540 = a.member[_e537];
                                        let _e541 = (_e540 & 65535u);
                                        let _e544 = ((_e541 & 32768u) << bitcast<u32>(16i));
                                        let _e547 = ((_e541 >> bitcast<u32>(10i)) & 31u);
                                        let _e548 = (_e541 & 1023u);
                                        if (_e547 == 0u) {
                                            phi_984_ = bitcast<f32>((_e544 | bitcast<u32>((f32(_e548) * 0.000000059604645f))));
                                        } else {
                                            if (_e547 == 31u) {
                                                phi_961_ = 255u;
                                                phi_962_ = u32();
                                                phi_963_ = true;
                                            } else {
                                                let _e551 = (_e547 + 112u);
                                                phi_961_ = _e551;
                                                phi_962_ = _e551;
                                                phi_963_ = (_e551 == 255u);
                                            }
                                            let _e554 = phi_961_;
                                            let _e556 = phi_962_;
                                            let _e558 = phi_963_;
                                            if _e558 {
                                                phi_972_ = (_e548 == 0u);
                                            } else {
                                                phi_972_ = true;
                                            }
                                            let _e561 = phi_972_;
                                            phi_984_ = bitcast<f32>((((_e544 | (select(_e554, select(_e556, _e554, _e558), _e561) << bitcast<u32>(23i))) | (_e548 << bitcast<u32>(13i))) | select(4194304u, 0u, _e561)));
                                        }
                                        let _e579 = phi_984_;
                                        if _e538 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e587 = ((_e540 >> bitcast<u32>(16u)) & 65535u);
                                        let _e590 = ((_e587 & 32768u) << bitcast<u32>(16i));
                                        let _e593 = ((_e587 >> bitcast<u32>(10i)) & 31u);
                                        let _e594 = (_e587 & 1023u);
                                        if (_e593 == 0u) {
                                            phi_1060_ = bitcast<f32>((_e590 | bitcast<u32>((f32(_e594) * 0.000000059604645f))));
                                        } else {
                                            if (_e593 == 31u) {
                                                phi_1037_ = 255u;
                                                phi_1038_ = u32();
                                                phi_1039_ = true;
                                            } else {
                                                let _e597 = (_e593 + 112u);
                                                phi_1037_ = _e597;
                                                phi_1038_ = _e597;
                                                phi_1039_ = (_e597 == 255u);
                                            }
                                            let _e600 = phi_1037_;
                                            let _e602 = phi_1038_;
                                            let _e604 = phi_1039_;
                                            if _e604 {
                                                phi_1048_ = (_e594 == 0u);
                                            } else {
                                                phi_1048_ = true;
                                            }
                                            let _e607 = phi_1048_;
                                            phi_1060_ = bitcast<f32>((((_e590 | (select(_e600, select(_e602, _e600, _e604), _e607) << bitcast<u32>(23i))) | (_e594 << bitcast<u32>(13i))) | select(4194304u, 0u, _e607)));
                                        }
                                        let _e625 = phi_1060_;
                                        let _e632 = (_e182 + _e346);
                                        let _e633 = (_e632 < _e68);
                                        if _e633 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e635 = a.member[_e632];
                                        let _e636 = (_e635 & 65535u);
                                        let _e639 = ((_e636 & 32768u) << bitcast<u32>(16i));
                                        let _e642 = ((_e636 >> bitcast<u32>(10i)) & 31u);
                                        let _e643 = (_e636 & 1023u);
                                        if (_e642 == 0u) {
                                            phi_1136_ = bitcast<f32>((_e639 | bitcast<u32>((f32(_e643) * 0.000000059604645f))));
                                        } else {
                                            if (_e642 == 31u) {
                                                phi_1113_ = 255u;
                                                phi_1114_ = u32();
                                                phi_1115_ = true;
                                            } else {
                                                let _e646 = (_e642 + 112u);
                                                phi_1113_ = _e646;
                                                phi_1114_ = _e646;
                                                phi_1115_ = (_e646 == 255u);
                                            }
                                            let _e649 = phi_1113_;
                                            let _e651 = phi_1114_;
                                            let _e653 = phi_1115_;
                                            if _e653 {
                                                phi_1124_ = (_e643 == 0u);
                                            } else {
                                                phi_1124_ = true;
                                            }
                                            let _e656 = phi_1124_;
                                            phi_1136_ = bitcast<f32>((((_e639 | (select(_e649, select(_e651, _e649, _e653), _e656) << bitcast<u32>(23i))) | (_e643 << bitcast<u32>(13i))) | select(4194304u, 0u, _e656)));
                                        }
                                        let _e674 = phi_1136_;
                                        if _e633 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e682 = ((_e635 >> bitcast<u32>(16u)) & 65535u);
                                        let _e685 = ((_e682 & 32768u) << bitcast<u32>(16i));
                                        let _e688 = ((_e682 >> bitcast<u32>(10i)) & 31u);
                                        let _e689 = (_e682 & 1023u);
                                        if (_e688 == 0u) {
                                            phi_1212_ = bitcast<f32>((_e685 | bitcast<u32>((f32(_e689) * 0.000000059604645f))));
                                        } else {
                                            if (_e688 == 31u) {
                                                phi_1189_ = 255u;
                                                phi_1190_ = u32();
                                                phi_1191_ = true;
                                            } else {
                                                let _e692 = (_e688 + 112u);
                                                phi_1189_ = _e692;
                                                phi_1190_ = _e692;
                                                phi_1191_ = (_e692 == 255u);
                                            }
                                            let _e695 = phi_1189_;
                                            let _e697 = phi_1190_;
                                            let _e699 = phi_1191_;
                                            if _e699 {
                                                phi_1200_ = (_e689 == 0u);
                                            } else {
                                                phi_1200_ = true;
                                            }
                                            let _e702 = phi_1200_;
                                            phi_1212_ = bitcast<f32>((((_e685 | (select(_e695, select(_e697, _e695, _e699), _e702) << bitcast<u32>(23i))) | (_e689 << bitcast<u32>(13i))) | select(4194304u, 0u, _e702)));
                                        }
                                        let _e720 = phi_1212_;
                                        let _e726 = (_e441 + _e632);
                                        let _e727 = (_e726 < _e68);
                                        if _e727 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e729 = a.member[_e726];
                                        let _e730 = (_e729 & 65535u);
                                        let _e733 = ((_e730 & 32768u) << bitcast<u32>(16i));
                                        let _e736 = ((_e730 >> bitcast<u32>(10i)) & 31u);
                                        let _e737 = (_e730 & 1023u);
                                        if (_e736 == 0u) {
                                            phi_1288_ = bitcast<f32>((_e733 | bitcast<u32>((f32(_e737) * 0.000000059604645f))));
                                        } else {
                                            if (_e736 == 31u) {
                                                phi_1265_ = 255u;
                                                phi_1266_ = u32();
                                                phi_1267_ = true;
                                            } else {
                                                let _e740 = (_e736 + 112u);
                                                phi_1265_ = _e740;
                                                phi_1266_ = _e740;
                                                phi_1267_ = (_e740 == 255u);
                                            }
                                            let _e743 = phi_1265_;
                                            let _e745 = phi_1266_;
                                            let _e747 = phi_1267_;
                                            if _e747 {
                                                phi_1276_ = (_e737 == 0u);
                                            } else {
                                                phi_1276_ = true;
                                            }
                                            let _e750 = phi_1276_;
                                            phi_1288_ = bitcast<f32>((((_e733 | (select(_e743, select(_e745, _e743, _e747), _e750) << bitcast<u32>(23i))) | (_e737 << bitcast<u32>(13i))) | select(4194304u, 0u, _e750)));
                                        }
                                        let _e768 = phi_1288_;
                                        if _e727 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e776 = ((_e729 >> bitcast<u32>(16u)) & 65535u);
                                        let _e779 = ((_e776 & 32768u) << bitcast<u32>(16i));
                                        let _e782 = ((_e776 >> bitcast<u32>(10i)) & 31u);
                                        let _e783 = (_e776 & 1023u);
                                        if (_e782 == 0u) {
                                            phi_1364_ = bitcast<f32>((_e779 | bitcast<u32>((f32(_e783) * 0.000000059604645f))));
                                        } else {
                                            if (_e782 == 31u) {
                                                phi_1341_ = 255u;
                                                phi_1342_ = u32();
                                                phi_1343_ = true;
                                            } else {
                                                let _e786 = (_e782 + 112u);
                                                phi_1341_ = _e786;
                                                phi_1342_ = _e786;
                                                phi_1343_ = (_e786 == 255u);
                                            }
                                            let _e789 = phi_1341_;
                                            let _e791 = phi_1342_;
                                            let _e793 = phi_1343_;
                                            if _e793 {
                                                phi_1352_ = (_e783 == 0u);
                                            } else {
                                                phi_1352_ = true;
                                            }
                                            let _e796 = phi_1352_;
                                            phi_1364_ = bitcast<f32>((((_e779 | (select(_e789, select(_e791, _e789, _e793), _e796) << bitcast<u32>(23i))) | (_e783 << bitcast<u32>(13i))) | select(4194304u, 0u, _e796)));
                                        }
                                        let _e814 = phi_1364_;
                                        let _e820 = (_e536 + _e632);
                                        let _e821 = (_e820 < _e68);
                                        if _e821 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e823 = a.member[_e820];
                                        let _e824 = (_e823 & 65535u);
                                        let _e827 = ((_e824 & 32768u) << bitcast<u32>(16i));
                                        let _e830 = ((_e824 >> bitcast<u32>(10i)) & 31u);
                                        let _e831 = (_e824 & 1023u);
                                        if (_e830 == 0u) {
                                            phi_1440_ = bitcast<f32>((_e827 | bitcast<u32>((f32(_e831) * 0.000000059604645f))));
                                        } else {
                                            if (_e830 == 31u) {
                                                phi_1417_ = 255u;
                                                phi_1418_ = u32();
                                                phi_1419_ = true;
                                            } else {
                                                let _e834 = (_e830 + 112u);
                                                phi_1417_ = _e834;
                                                phi_1418_ = _e834;
                                                phi_1419_ = (_e834 == 255u);
                                            }
                                            let _e837 = phi_1417_;
                                            let _e839 = phi_1418_;
                                            let _e841 = phi_1419_;
                                            if _e841 {
                                                phi_1428_ = (_e831 == 0u);
                                            } else {
                                                phi_1428_ = true;
                                            }
                                            let _e844 = phi_1428_;
                                            phi_1440_ = bitcast<f32>((((_e827 | (select(_e837, select(_e839, _e837, _e841), _e844) << bitcast<u32>(23i))) | (_e831 << bitcast<u32>(13i))) | select(4194304u, 0u, _e844)));
                                        }
                                        let _e862 = phi_1440_;
                                        if _e821 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e870 = ((_e823 >> bitcast<u32>(16u)) & 65535u);
                                        let _e873 = ((_e870 & 32768u) << bitcast<u32>(16i));
                                        let _e876 = ((_e870 >> bitcast<u32>(10i)) & 31u);
                                        let _e877 = (_e870 & 1023u);
                                        if (_e876 == 0u) {
                                            phi_1516_ = bitcast<f32>((_e873 | bitcast<u32>((f32(_e877) * 0.000000059604645f))));
                                        } else {
                                            if (_e876 == 31u) {
                                                phi_1493_ = 255u;
                                                phi_1494_ = u32();
                                                phi_1495_ = true;
                                            } else {
                                                let _e880 = (_e876 + 112u);
                                                phi_1493_ = _e880;
                                                phi_1494_ = _e880;
                                                phi_1495_ = (_e880 == 255u);
                                            }
                                            let _e883 = phi_1493_;
                                            let _e885 = phi_1494_;
                                            let _e887 = phi_1495_;
                                            if _e887 {
                                                phi_1504_ = (_e877 == 0u);
                                            } else {
                                                phi_1504_ = true;
                                            }
                                            let _e890 = phi_1504_;
                                            phi_1516_ = bitcast<f32>((((_e873 | (select(_e883, select(_e885, _e883, _e887), _e890) << bitcast<u32>(23i))) | (_e877 << bitcast<u32>(13i))) | select(4194304u, 0u, _e890)));
                                        }
                                        let _e908 = phi_1516_;
                                        let _e916 = ((2u * _e182) + _e346);
                                        let _e917 = (_e916 < _e68);
                                        if _e917 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e919 = a.member[_e916];
                                        let _e920 = (_e919 & 65535u);
                                        let _e923 = ((_e920 & 32768u) << bitcast<u32>(16i));
                                        let _e926 = ((_e920 >> bitcast<u32>(10i)) & 31u);
                                        let _e927 = (_e920 & 1023u);
                                        if (_e926 == 0u) {
                                            phi_1592_ = bitcast<f32>((_e923 | bitcast<u32>((f32(_e927) * 0.000000059604645f))));
                                        } else {
                                            if (_e926 == 31u) {
                                                phi_1569_ = 255u;
                                                phi_1570_ = u32();
                                                phi_1571_ = true;
                                            } else {
                                                let _e930 = (_e926 + 112u);
                                                phi_1569_ = _e930;
                                                phi_1570_ = _e930;
                                                phi_1571_ = (_e930 == 255u);
                                            }
                                            let _e933 = phi_1569_;
                                            let _e935 = phi_1570_;
                                            let _e937 = phi_1571_;
                                            if _e937 {
                                                phi_1580_ = (_e927 == 0u);
                                            } else {
                                                phi_1580_ = true;
                                            }
                                            let _e940 = phi_1580_;
                                            phi_1592_ = bitcast<f32>((((_e923 | (select(_e933, select(_e935, _e933, _e937), _e940) << bitcast<u32>(23i))) | (_e927 << bitcast<u32>(13i))) | select(4194304u, 0u, _e940)));
                                        }
                                        let _e958 = phi_1592_;
                                        if _e917 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e966 = ((_e919 >> bitcast<u32>(16u)) & 65535u);
                                        let _e969 = ((_e966 & 32768u) << bitcast<u32>(16i));
                                        let _e972 = ((_e966 >> bitcast<u32>(10i)) & 31u);
                                        let _e973 = (_e966 & 1023u);
                                        if (_e972 == 0u) {
                                            phi_1668_ = bitcast<f32>((_e969 | bitcast<u32>((f32(_e973) * 0.000000059604645f))));
                                        } else {
                                            if (_e972 == 31u) {
                                                phi_1645_ = 255u;
                                                phi_1646_ = u32();
                                                phi_1647_ = true;
                                            } else {
                                                let _e976 = (_e972 + 112u);
                                                phi_1645_ = _e976;
                                                phi_1646_ = _e976;
                                                phi_1647_ = (_e976 == 255u);
                                            }
                                            let _e979 = phi_1645_;
                                            let _e981 = phi_1646_;
                                            let _e983 = phi_1647_;
                                            if _e983 {
                                                phi_1656_ = (_e973 == 0u);
                                            } else {
                                                phi_1656_ = true;
                                            }
                                            let _e986 = phi_1656_;
                                            phi_1668_ = bitcast<f32>((((_e969 | (select(_e979, select(_e981, _e979, _e983), _e986) << bitcast<u32>(23i))) | (_e973 << bitcast<u32>(13i))) | select(4194304u, 0u, _e986)));
                                        }
                                        let _e1004 = phi_1668_;
                                        let _e1010 = (_e441 + _e916);
                                        let _e1011 = (_e1010 < _e68);
                                        if _e1011 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e1013 = a.member[_e1010];
                                        let _e1014 = (_e1013 & 65535u);
                                        let _e1017 = ((_e1014 & 32768u) << bitcast<u32>(16i));
                                        let _e1020 = ((_e1014 >> bitcast<u32>(10i)) & 31u);
                                        let _e1021 = (_e1014 & 1023u);
                                        if (_e1020 == 0u) {
                                            phi_1744_ = bitcast<f32>((_e1017 | bitcast<u32>((f32(_e1021) * 0.000000059604645f))));
                                        } else {
                                            if (_e1020 == 31u) {
                                                phi_1721_ = 255u;
                                                phi_1722_ = u32();
                                                phi_1723_ = true;
                                            } else {
                                                let _e1024 = (_e1020 + 112u);
                                                phi_1721_ = _e1024;
                                                phi_1722_ = _e1024;
                                                phi_1723_ = (_e1024 == 255u);
                                            }
                                            let _e1027 = phi_1721_;
                                            let _e1029 = phi_1722_;
                                            let _e1031 = phi_1723_;
                                            if _e1031 {
                                                phi_1732_ = (_e1021 == 0u);
                                            } else {
                                                phi_1732_ = true;
                                            }
                                            let _e1034 = phi_1732_;
                                            phi_1744_ = bitcast<f32>((((_e1017 | (select(_e1027, select(_e1029, _e1027, _e1031), _e1034) << bitcast<u32>(23i))) | (_e1021 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1034)));
                                        }
                                        let _e1052 = phi_1744_;
                                        if _e1011 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e1060 = ((_e1013 >> bitcast<u32>(16u)) & 65535u);
                                        let _e1063 = ((_e1060 & 32768u) << bitcast<u32>(16i));
                                        let _e1066 = ((_e1060 >> bitcast<u32>(10i)) & 31u);
                                        let _e1067 = (_e1060 & 1023u);
                                        if (_e1066 == 0u) {
                                            phi_1820_ = bitcast<f32>((_e1063 | bitcast<u32>((f32(_e1067) * 0.000000059604645f))));
                                        } else {
                                            if (_e1066 == 31u) {
                                                phi_1797_ = 255u;
                                                phi_1798_ = u32();
                                                phi_1799_ = true;
                                            } else {
                                                let _e1070 = (_e1066 + 112u);
                                                phi_1797_ = _e1070;
                                                phi_1798_ = _e1070;
                                                phi_1799_ = (_e1070 == 255u);
                                            }
                                            let _e1073 = phi_1797_;
                                            let _e1075 = phi_1798_;
                                            let _e1077 = phi_1799_;
                                            if _e1077 {
                                                phi_1808_ = (_e1067 == 0u);
                                            } else {
                                                phi_1808_ = true;
                                            }
                                            let _e1080 = phi_1808_;
                                            phi_1820_ = bitcast<f32>((((_e1063 | (select(_e1073, select(_e1075, _e1073, _e1077), _e1080) << bitcast<u32>(23i))) | (_e1067 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1080)));
                                        }
                                        let _e1098 = phi_1820_;
                                        let _e1104 = (_e536 + _e916);
                                        let _e1105 = (_e1104 < _e68);
                                        if _e1105 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e1107 = a.member[_e1104];
                                        let _e1108 = (_e1107 & 65535u);
                                        let _e1111 = ((_e1108 & 32768u) << bitcast<u32>(16i));
                                        let _e1114 = ((_e1108 >> bitcast<u32>(10i)) & 31u);
                                        let _e1115 = (_e1108 & 1023u);
                                        if (_e1114 == 0u) {
                                            phi_1896_ = bitcast<f32>((_e1111 | bitcast<u32>((f32(_e1115) * 0.000000059604645f))));
                                        } else {
                                            if (_e1114 == 31u) {
                                                phi_1873_ = 255u;
                                                phi_1874_ = u32();
                                                phi_1875_ = true;
                                            } else {
                                                let _e1118 = (_e1114 + 112u);
                                                phi_1873_ = _e1118;
                                                phi_1874_ = _e1118;
                                                phi_1875_ = (_e1118 == 255u);
                                            }
                                            let _e1121 = phi_1873_;
                                            let _e1123 = phi_1874_;
                                            let _e1125 = phi_1875_;
                                            if _e1125 {
                                                phi_1884_ = (_e1115 == 0u);
                                            } else {
                                                phi_1884_ = true;
                                            }
                                            let _e1128 = phi_1884_;
                                            phi_1896_ = bitcast<f32>((((_e1111 | (select(_e1121, select(_e1123, _e1121, _e1125), _e1128) << bitcast<u32>(23i))) | (_e1115 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1128)));
                                        }
                                        let _e1146 = phi_1896_;
                                        if _e1105 {
                                        } else {
                                            phi_16674_ = true;
                                            break;
                                        }
                                        let _e1154 = ((_e1107 >> bitcast<u32>(16u)) & 65535u);
                                        let _e1157 = ((_e1154 & 32768u) << bitcast<u32>(16i));
                                        let _e1160 = ((_e1154 >> bitcast<u32>(10i)) & 31u);
                                        let _e1161 = (_e1154 & 1023u);
                                        if (_e1160 == 0u) {
                                            phi_1972_ = bitcast<f32>((_e1157 | bitcast<u32>((f32(_e1161) * 0.000000059604645f))));
                                        } else {
                                            if (_e1160 == 31u) {
                                                phi_1949_ = 255u;
                                                phi_1950_ = u32();
                                                phi_1951_ = true;
                                            } else {
                                                let _e1164 = (_e1160 + 112u);
                                                phi_1949_ = _e1164;
                                                phi_1950_ = _e1164;
                                                phi_1951_ = (_e1164 == 255u);
                                            }
                                            let _e1167 = phi_1949_;
                                            let _e1169 = phi_1950_;
                                            let _e1171 = phi_1951_;
                                            if _e1171 {
                                                phi_1960_ = (_e1161 == 0u);
                                            } else {
                                                phi_1960_ = true;
                                            }
                                            let _e1174 = phi_1960_;
                                            phi_1972_ = bitcast<f32>((((_e1157 | (select(_e1167, select(_e1169, _e1167, _e1171), _e1174) << bitcast<u32>(23i))) | (_e1161 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1174)));
                                        }
                                        let _e1192 = phi_1972_;
                                        phi_1978_ = (_e282 + _e337);
                                        phi_1979_ = array<array<f32, 6>, 3>(array<f32, 6>((_e284[0][0] + ((_e389 * _e96) * _e337)), (_e284[0][1] + ((_e435 * _e96) * _e337)), (_e284[0][2] + ((_e484 * _e96) * _e337)), (_e284[0][3] + ((_e530 * _e96) * _e337)), (_e284[0][4] + ((_e579 * _e96) * _e337)), (_e284[0][5] + ((_e625 * _e96) * _e337))), array<f32, 6>((_e284[1][0] + ((_e674 * _e96) * _e337)), (_e284[1][1] + ((_e720 * _e96) * _e337)), (_e284[1][2] + ((_e768 * _e96) * _e337)), (_e284[1][3] + ((_e814 * _e96) * _e337)), (_e284[1][4] + ((_e862 * _e96) * _e337)), (_e284[1][5] + ((_e908 * _e96) * _e337))), array<f32, 6>((_e284[2][0] + ((_e958 * _e96) * _e337)), (_e284[2][1] + ((_e1004 * _e96) * _e337)), (_e284[2][2] + ((_e1052 * _e96) * _e337)), (_e284[2][3] + ((_e1098 * _e96) * _e337)), (_e284[2][4] + ((_e1146 * _e96) * _e337)), (_e284[2][5] + ((_e1192 * _e96) * _e337))));
                                    } else {
                                        phi_1978_ = _e282;
                                        phi_1979_ = _e284;
                                    }
                                    let _e1201 = phi_1978_;
                                    let _e1203 = phi_1979_;
                                    phi_501_ = _e1201;
                                    phi_503_ = _e1203;
                                } else {
                                    phi_501_ = f32();
                                    phi_503_ = array<array<f32, 6>, 3>();
                                }
                                let _e1205 = phi_501_;
                                let _e1207 = phi_503_;
                                continue;
                                continuing {
                                    phi_497_ = _e297;
                                    phi_500_ = _e1205;
                                    phi_502_ = _e1207;
                                    phi_16674_ = false;
                                    break if !(_e303);
                                }
                            }
                            let _e1210 = phi_16674_;
                            if _e1210 {
                                break;
                            }
                            let _e1212 = local;
                            if (_e1212 > 0f) {
                                let _e1215 = local_1;
                                phi_1985_ = (1f / _e1215);
                            } else {
                                phi_1985_ = 0f;
                            }
                            let _e1218 = phi_1985_;
                            let _e1220 = local_2;
                            let _e1225 = local_3;
                            let _e1230 = local_4;
                            let _e1235 = local_5;
                            let _e1240 = local_6;
                            let _e1245 = local_7;
                            let _e1250 = local_8;
                            let _e1255 = local_9;
                            let _e1260 = local_10;
                            let _e1265 = local_11;
                            let _e1270 = local_12;
                            let _e1275 = local_13;
                            let _e1280 = local_14;
                            let _e1285 = local_15;
                            let _e1290 = local_16;
                            let _e1295 = local_17;
                            let _e1300 = local_18;
                            let _e1305 = local_19;
                            let _e1310 = ((0.6666667f / _e104.w) / _e104.w);
                            let _e1311 = -(_e90.member_2[0]);
                            let _e1312 = -(_e90.member_2[1]);
                            let _e1315 = (_e90.member_2[2] * -1.0233268f);
                            let _e1321 = ((((_e90.member_2[2] * -1.9364917f) * (_e90.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                            let _e1324 = (_e90.member_2[0] * -1.0233268f);
                            let _e1327 = (_e90.member_2[1] * -1.0233268f);
                            let _e1333 = (((_e1311 * _e1311) - (_e1312 * _e1312)) * 0.4290428f);
                            let _e1335 = (((((((_e1220[0][0] * _e1218) * 0.886227f) + ((_e1230[0][2] * _e1218) * _e1315)) + ((_e1240[0][4] * _e1218) * _e1321)) + ((_e1235[0][3] * _e1218) * _e1324)) + ((_e1225[0][1] * _e1218) * _e1327)) + ((_e1245[0][5] * _e1218) * _e1333));
                            let _e1348 = (((((((_e1250[1][0] * _e1218) * 0.886227f) + ((_e1260[1][2] * _e1218) * _e1315)) + ((_e1270[1][4] * _e1218) * _e1321)) + ((_e1265[1][3] * _e1218) * _e1324)) + ((_e1255[1][1] * _e1218) * _e1327)) + ((_e1275[1][5] * _e1218) * _e1333));
                            let _e1361 = (((((((_e1280[2][0] * _e1218) * 0.886227f) + ((_e1290[2][2] * _e1218) * _e1315)) + ((_e1300[2][4] * _e1218) * _e1321)) + ((_e1295[2][3] * _e1218) * _e1324)) + ((_e1285[2][1] * _e1218) * _e1327)) + ((_e1305[2][5] * _e1218) * _e1333));
                            phi_16811_ = _e1210;
                            phi_4273_ = vec4<f32>(((select(0f, _e1335, (_e1335 > 0f)) * _e1310) * _e171), ((select(0f, _e1348, (_e1348 > 0f)) * _e1310) * _e171), ((select(0f, _e1361, (_e1361 > 0f)) * _e1310) * _e171), (1f - _e171));
                        }
                        let _e1373 = phi_16811_;
                        let _e1375 = phi_4273_;
                        phi_16809_ = _e1373;
                        phi_4275_ = _e1375;
                    }
                    let _e1377 = phi_16809_;
                    let _e1379 = phi_4275_;
                    let _e1382 = select(_e1379, vec4<f32>(0f, 0f, 0f, 1f), vec4(select(false, true, _e100)));
                    if (1u >= _e99) {
                        phi_17148_ = _e1377;
                        phi_8395_ = vec4<f32>();
                        phi_8396_ = true;
                    } else {
                        let _e1385 = (_e1382.w <= 0f);
                        if _e1385 {
                            phi_17149_ = _e1377;
                            phi_8394_ = vec4<f32>();
                        } else {
                            let _e1389 = params.member.member[1u];
                            let _e1393 = params.member.member_1[1u];
                            let _e1397 = params.member.member_2[1u];
                            if (2u == _e99) {
                                phi_4336_ = 0f;
                            } else {
                                let _e1409 = params.member.member_5;
                                phi_4336_ = _e1409;
                            }
                            let _e1411 = phi_4336_;
                            let _e1419 = ((_e90.member[0] - _e1389.x) / _e1389.w);
                            let _e1420 = ((_e90.member[1] - _e1389.y) / _e1389.w);
                            let _e1421 = ((_e90.member[2] - _e1389.z) / _e1389.w);
                            let _e1428 = (_e1419 - f32(_e1393.x));
                            let _e1429 = (_e1420 - f32(_e1393.y));
                            let _e1430 = (_e1421 - f32(_e1393.z));
                            let _e1438 = select(_e1430, _e1429, (_e1429 < _e1430));
                            let _e1440 = select(_e1438, _e1428, (_e1428 < _e1438));
                            let _e1441 = (f32(_e1397.x) - _e1428);
                            let _e1442 = (f32(_e1397.y) - _e1429);
                            let _e1443 = (f32(_e1397.z) - _e1430);
                            let _e1445 = select(_e1443, _e1442, (_e1442 < _e1443));
                            let _e1447 = select(_e1445, _e1441, (_e1441 < _e1445));
                            let _e1452 = (select(_e1447, _e1440, (_e1440 < _e1447)) / select(0.001f, _e1411, (_e1411 > 0.001f)));
                            let _e1454 = select(0f, _e1452, (_e1452 > 0f));
                            let _e1457 = (_e1382.w * select(1f, _e1454, (_e1454 < 1f)));
                            if (_e1457 <= 0f) {
                                phi_17150_ = _e1377;
                                phi_8393_ = _e1382;
                            } else {
                                let _e1464 = params.member.member_6;
                                let _e1465 = (_e1397.x + 1u);
                                let _e1467 = ((_e1397.y + 1u) * _e1465);
                                let _e1468 = (_e1467 + _e1465);
                                let _e1471 = (_e1468 + ((_e1397.z + 1u) * _e1467));
                                let _e1478 = ((_e1419 + (_e90.member_2[0] * _e1464)) - 0.5f);
                                let _e1479 = floor(_e1478);
                                let _e1481 = (bitcast<i32>(_e1397.x) - 1i);
                                let _e1489 = (select(0i, select(select(i32(_e1479), i32(-2147483648), (_e1479 < -2147483600f)), 2147483647i, (_e1479 > 2147483500f)), (_e1479 == _e1479)) - _e1393.x);
                                let _e1491 = select(0i, _e1489, (0i < _e1489));
                                let _e1493 = select(_e1491, _e1481, (_e1481 < _e1491));
                                let _e1494 = (_e1489 + 1i);
                                let _e1496 = select(0i, _e1494, (0i < _e1494));
                                let _e1498 = select(_e1496, _e1481, (_e1481 < _e1496));
                                let _e1501 = (_e1478 - _e1479);
                                let _e1508 = ((_e1420 + (_e90.member_2[1] * _e1464)) - 0.5f);
                                let _e1509 = floor(_e1508);
                                let _e1511 = (bitcast<i32>(_e1397.y) - 1i);
                                let _e1519 = (select(0i, select(select(i32(_e1509), i32(-2147483648), (_e1509 < -2147483600f)), 2147483647i, (_e1509 > 2147483500f)), (_e1509 == _e1509)) - _e1393.y);
                                let _e1521 = select(0i, _e1519, (0i < _e1519));
                                let _e1523 = select(_e1521, _e1511, (_e1511 < _e1521));
                                let _e1524 = (_e1519 + 1i);
                                let _e1526 = select(0i, _e1524, (0i < _e1524));
                                let _e1528 = select(_e1526, _e1511, (_e1511 < _e1526));
                                let _e1531 = (_e1508 - _e1509);
                                let _e1538 = ((_e1421 + (_e90.member_2[2] * _e1464)) - 0.5f);
                                let _e1539 = floor(_e1538);
                                let _e1541 = (bitcast<i32>(_e1397.z) - 1i);
                                let _e1549 = (select(0i, select(select(i32(_e1539), i32(-2147483648), (_e1539 < -2147483600f)), 2147483647i, (_e1539 > 2147483500f)), (_e1539 == _e1539)) - _e1393.z);
                                let _e1551 = select(0i, _e1549, (0i < _e1549));
                                let _e1553 = select(_e1551, _e1541, (_e1541 < _e1551));
                                let _e1554 = (_e1549 + 1i);
                                let _e1556 = select(0i, _e1554, (0i < _e1554));
                                let _e1558 = select(_e1556, _e1541, (_e1541 < _e1556));
                                let _e1561 = (_e1538 - _e1539);
                                phi_4617_ = type_12(0u, 8u);
                                phi_4620_ = 0f;
                                phi_4622_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                                loop {
                                    let _e1569 = phi_4617_;
                                    let _e1571 = phi_4620_;
                                    let _e1573 = phi_4622_;
                                    local_20 = _e1571;
                                    local_21 = _e1571;
                                    local_22 = _e1573;
                                    local_23 = _e1573;
                                    local_24 = _e1573;
                                    local_25 = _e1573;
                                    local_26 = _e1573;
                                    local_27 = _e1573;
                                    local_28 = _e1573;
                                    local_29 = _e1573;
                                    local_30 = _e1573;
                                    local_31 = _e1573;
                                    local_32 = _e1573;
                                    local_33 = _e1573;
                                    local_34 = _e1573;
                                    local_35 = _e1573;
                                    local_36 = _e1573;
                                    local_37 = _e1573;
                                    local_38 = _e1573;
                                    local_39 = _e1573;
                                    if (_e1569.member < _e1569.member_1) {
                                        phi_4618_ = type_12((_e1569.member + 1u), _e1569.member_1);
                                        phi_4645_ = type_12(1u, _e1569.member);
                                    } else {
                                        phi_4618_ = _e1569;
                                        phi_4645_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e1586 = phi_4618_;
                                    let _e1588 = phi_4645_;
                                    let _e1592 = (bitcast<i32>(_e1588.member) != 0i);
                                    if _e1592 {
                                        let _e1594 = ((_e1588.member_1 & 1u) == 1u);
                                        let _e1596 = ((_e1588.member_1 & 2u) == 2u);
                                        let _e1598 = ((_e1588.member_1 & 4u) == 4u);
                                        if _e1594 {
                                            phi_4675_ = _e1501;
                                        } else {
                                            phi_4675_ = (1f - _e1501);
                                        }
                                        let _e1604 = phi_4675_;
                                        if _e1596 {
                                            phi_4680_ = _e1531;
                                        } else {
                                            phi_4680_ = (1f - _e1531);
                                        }
                                        let _e1607 = phi_4680_;
                                        if _e1598 {
                                            phi_4686_ = _e1561;
                                        } else {
                                            phi_4686_ = (1f - _e1561);
                                        }
                                        let _e1611 = phi_4686_;
                                        let _e1621 = (((((select((f32((_e1493 + _e1393.x)) + 0.5f), (f32((_e1498 + _e1393.x)) + 0.5f), _e1594) - _e1419) * _e90.member_2[0]) + ((select((f32((_e1523 + _e1393.y)) + 0.5f), (f32((_e1528 + _e1393.y)) + 0.5f), _e1596) - _e1420) * _e90.member_2[1])) + ((select((f32((_e1553 + _e1393.z)) + 0.5f), (f32((_e1558 + _e1393.z)) + 0.5f), _e1598) - _e1421) * _e90.member_2[2])) * 2f);
                                        let _e1623 = select(0f, _e1621, (_e1621 > 0f));
                                        let _e1626 = (((_e1604 * _e1607) * _e1611) * select(1f, _e1623, (_e1623 < 1f)));
                                        if (_e1626 > 0f) {
                                            let _e1635 = (((_e1468 + select(bitcast<u32>(_e1493), bitcast<u32>(_e1498), _e1594)) + (select(bitcast<u32>(_e1523), bitcast<u32>(_e1528), _e1596) * _e1465)) + (select(bitcast<u32>(_e1553), bitcast<u32>(_e1558), _e1598) * _e1467));
                                            let _e1637 = (_e1635 < _e71);
                                            if _e1637 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1639 = b.member[_e1635];
                                            let _e1640 = (_e1639 & 65535u);
                                            let _e1643 = ((_e1640 & 32768u) << bitcast<u32>(16i));
                                            let _e1646 = ((_e1640 >> bitcast<u32>(10i)) & 31u);
                                            let _e1647 = (_e1640 & 1023u);
                                            if (_e1646 == 0u) {
                                                phi_4800_ = bitcast<f32>((_e1643 | bitcast<u32>((f32(_e1647) * 0.000000059604645f))));
                                            } else {
                                                if (_e1646 == 31u) {
                                                    phi_4777_ = 255u;
                                                    phi_4778_ = u32();
                                                    phi_4779_ = true;
                                                } else {
                                                    let _e1650 = (_e1646 + 112u);
                                                    phi_4777_ = _e1650;
                                                    phi_4778_ = _e1650;
                                                    phi_4779_ = (_e1650 == 255u);
                                                }
                                                let _e1653 = phi_4777_;
                                                let _e1655 = phi_4778_;
                                                let _e1657 = phi_4779_;
                                                if _e1657 {
                                                    phi_4788_ = (_e1647 == 0u);
                                                } else {
                                                    phi_4788_ = true;
                                                }
                                                let _e1660 = phi_4788_;
                                                phi_4800_ = bitcast<f32>((((_e1643 | (select(_e1653, select(_e1655, _e1653, _e1657), _e1660) << bitcast<u32>(23i))) | (_e1647 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1660)));
                                            }
                                            let _e1678 = phi_4800_;
                                            if _e1637 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1686 = ((_e1639 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1689 = ((_e1686 & 32768u) << bitcast<u32>(16i));
                                            let _e1692 = ((_e1686 >> bitcast<u32>(10i)) & 31u);
                                            let _e1693 = (_e1686 & 1023u);
                                            if (_e1692 == 0u) {
                                                phi_4876_ = bitcast<f32>((_e1689 | bitcast<u32>((f32(_e1693) * 0.000000059604645f))));
                                            } else {
                                                if (_e1692 == 31u) {
                                                    phi_4853_ = 255u;
                                                    phi_4854_ = u32();
                                                    phi_4855_ = true;
                                                } else {
                                                    let _e1696 = (_e1692 + 112u);
                                                    phi_4853_ = _e1696;
                                                    phi_4854_ = _e1696;
                                                    phi_4855_ = (_e1696 == 255u);
                                                }
                                                let _e1699 = phi_4853_;
                                                let _e1701 = phi_4854_;
                                                let _e1703 = phi_4855_;
                                                if _e1703 {
                                                    phi_4864_ = (_e1693 == 0u);
                                                } else {
                                                    phi_4864_ = true;
                                                }
                                                let _e1706 = phi_4864_;
                                                phi_4876_ = bitcast<f32>((((_e1689 | (select(_e1699, select(_e1701, _e1699, _e1703), _e1706) << bitcast<u32>(23i))) | (_e1693 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1706)));
                                            }
                                            let _e1724 = phi_4876_;
                                            let _e1730 = (3u * _e1471);
                                            let _e1731 = (_e1730 + _e1635);
                                            let _e1732 = (_e1731 < _e71);
                                            if _e1732 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1734 = b.member[_e1731];
                                            let _e1735 = (_e1734 & 65535u);
                                            let _e1738 = ((_e1735 & 32768u) << bitcast<u32>(16i));
                                            let _e1741 = ((_e1735 >> bitcast<u32>(10i)) & 31u);
                                            let _e1742 = (_e1735 & 1023u);
                                            if (_e1741 == 0u) {
                                                phi_4952_ = bitcast<f32>((_e1738 | bitcast<u32>((f32(_e1742) * 0.000000059604645f))));
                                            } else {
                                                if (_e1741 == 31u) {
                                                    phi_4929_ = 255u;
                                                    phi_4930_ = u32();
                                                    phi_4931_ = true;
                                                } else {
                                                    let _e1745 = (_e1741 + 112u);
                                                    phi_4929_ = _e1745;
                                                    phi_4930_ = _e1745;
                                                    phi_4931_ = (_e1745 == 255u);
                                                }
                                                let _e1748 = phi_4929_;
                                                let _e1750 = phi_4930_;
                                                let _e1752 = phi_4931_;
                                                if _e1752 {
                                                    phi_4940_ = (_e1742 == 0u);
                                                } else {
                                                    phi_4940_ = true;
                                                }
                                                let _e1755 = phi_4940_;
                                                phi_4952_ = bitcast<f32>((((_e1738 | (select(_e1748, select(_e1750, _e1748, _e1752), _e1755) << bitcast<u32>(23i))) | (_e1742 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1755)));
                                            }
                                            let _e1773 = phi_4952_;
                                            if _e1732 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1781 = ((_e1734 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1784 = ((_e1781 & 32768u) << bitcast<u32>(16i));
                                            let _e1787 = ((_e1781 >> bitcast<u32>(10i)) & 31u);
                                            let _e1788 = (_e1781 & 1023u);
                                            if (_e1787 == 0u) {
                                                phi_5028_ = bitcast<f32>((_e1784 | bitcast<u32>((f32(_e1788) * 0.000000059604645f))));
                                            } else {
                                                if (_e1787 == 31u) {
                                                    phi_5005_ = 255u;
                                                    phi_5006_ = u32();
                                                    phi_5007_ = true;
                                                } else {
                                                    let _e1791 = (_e1787 + 112u);
                                                    phi_5005_ = _e1791;
                                                    phi_5006_ = _e1791;
                                                    phi_5007_ = (_e1791 == 255u);
                                                }
                                                let _e1794 = phi_5005_;
                                                let _e1796 = phi_5006_;
                                                let _e1798 = phi_5007_;
                                                if _e1798 {
                                                    phi_5016_ = (_e1788 == 0u);
                                                } else {
                                                    phi_5016_ = true;
                                                }
                                                let _e1801 = phi_5016_;
                                                phi_5028_ = bitcast<f32>((((_e1784 | (select(_e1794, select(_e1796, _e1794, _e1798), _e1801) << bitcast<u32>(23i))) | (_e1788 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1801)));
                                            }
                                            let _e1819 = phi_5028_;
                                            let _e1825 = (_e1471 * 6u);
                                            let _e1826 = (_e1825 + _e1635);
                                            let _e1827 = (_e1826 < _e71);
                                            if _e1827 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1829 = b.member[_e1826];
                                            let _e1830 = (_e1829 & 65535u);
                                            let _e1833 = ((_e1830 & 32768u) << bitcast<u32>(16i));
                                            let _e1836 = ((_e1830 >> bitcast<u32>(10i)) & 31u);
                                            let _e1837 = (_e1830 & 1023u);
                                            if (_e1836 == 0u) {
                                                phi_5104_ = bitcast<f32>((_e1833 | bitcast<u32>((f32(_e1837) * 0.000000059604645f))));
                                            } else {
                                                if (_e1836 == 31u) {
                                                    phi_5081_ = 255u;
                                                    phi_5082_ = u32();
                                                    phi_5083_ = true;
                                                } else {
                                                    let _e1840 = (_e1836 + 112u);
                                                    phi_5081_ = _e1840;
                                                    phi_5082_ = _e1840;
                                                    phi_5083_ = (_e1840 == 255u);
                                                }
                                                let _e1843 = phi_5081_;
                                                let _e1845 = phi_5082_;
                                                let _e1847 = phi_5083_;
                                                if _e1847 {
                                                    phi_5092_ = (_e1837 == 0u);
                                                } else {
                                                    phi_5092_ = true;
                                                }
                                                let _e1850 = phi_5092_;
                                                phi_5104_ = bitcast<f32>((((_e1833 | (select(_e1843, select(_e1845, _e1843, _e1847), _e1850) << bitcast<u32>(23i))) | (_e1837 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1850)));
                                            }
                                            let _e1868 = phi_5104_;
                                            if _e1827 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1876 = ((_e1829 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1879 = ((_e1876 & 32768u) << bitcast<u32>(16i));
                                            let _e1882 = ((_e1876 >> bitcast<u32>(10i)) & 31u);
                                            let _e1883 = (_e1876 & 1023u);
                                            if (_e1882 == 0u) {
                                                phi_5180_ = bitcast<f32>((_e1879 | bitcast<u32>((f32(_e1883) * 0.000000059604645f))));
                                            } else {
                                                if (_e1882 == 31u) {
                                                    phi_5157_ = 255u;
                                                    phi_5158_ = u32();
                                                    phi_5159_ = true;
                                                } else {
                                                    let _e1886 = (_e1882 + 112u);
                                                    phi_5157_ = _e1886;
                                                    phi_5158_ = _e1886;
                                                    phi_5159_ = (_e1886 == 255u);
                                                }
                                                let _e1889 = phi_5157_;
                                                let _e1891 = phi_5158_;
                                                let _e1893 = phi_5159_;
                                                if _e1893 {
                                                    phi_5168_ = (_e1883 == 0u);
                                                } else {
                                                    phi_5168_ = true;
                                                }
                                                let _e1896 = phi_5168_;
                                                phi_5180_ = bitcast<f32>((((_e1879 | (select(_e1889, select(_e1891, _e1889, _e1893), _e1896) << bitcast<u32>(23i))) | (_e1883 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1896)));
                                            }
                                            let _e1914 = phi_5180_;
                                            let _e1921 = (_e1471 + _e1635);
                                            let _e1922 = (_e1921 < _e71);
                                            if _e1922 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1924 = b.member[_e1921];
                                            let _e1925 = (_e1924 & 65535u);
                                            let _e1928 = ((_e1925 & 32768u) << bitcast<u32>(16i));
                                            let _e1931 = ((_e1925 >> bitcast<u32>(10i)) & 31u);
                                            let _e1932 = (_e1925 & 1023u);
                                            if (_e1931 == 0u) {
                                                phi_5256_ = bitcast<f32>((_e1928 | bitcast<u32>((f32(_e1932) * 0.000000059604645f))));
                                            } else {
                                                if (_e1931 == 31u) {
                                                    phi_5233_ = 255u;
                                                    phi_5234_ = u32();
                                                    phi_5235_ = true;
                                                } else {
                                                    let _e1935 = (_e1931 + 112u);
                                                    phi_5233_ = _e1935;
                                                    phi_5234_ = _e1935;
                                                    phi_5235_ = (_e1935 == 255u);
                                                }
                                                let _e1938 = phi_5233_;
                                                let _e1940 = phi_5234_;
                                                let _e1942 = phi_5235_;
                                                if _e1942 {
                                                    phi_5244_ = (_e1932 == 0u);
                                                } else {
                                                    phi_5244_ = true;
                                                }
                                                let _e1945 = phi_5244_;
                                                phi_5256_ = bitcast<f32>((((_e1928 | (select(_e1938, select(_e1940, _e1938, _e1942), _e1945) << bitcast<u32>(23i))) | (_e1932 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1945)));
                                            }
                                            let _e1963 = phi_5256_;
                                            if _e1922 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e1971 = ((_e1924 >> bitcast<u32>(16u)) & 65535u);
                                            let _e1974 = ((_e1971 & 32768u) << bitcast<u32>(16i));
                                            let _e1977 = ((_e1971 >> bitcast<u32>(10i)) & 31u);
                                            let _e1978 = (_e1971 & 1023u);
                                            if (_e1977 == 0u) {
                                                phi_5332_ = bitcast<f32>((_e1974 | bitcast<u32>((f32(_e1978) * 0.000000059604645f))));
                                            } else {
                                                if (_e1977 == 31u) {
                                                    phi_5309_ = 255u;
                                                    phi_5310_ = u32();
                                                    phi_5311_ = true;
                                                } else {
                                                    let _e1981 = (_e1977 + 112u);
                                                    phi_5309_ = _e1981;
                                                    phi_5310_ = _e1981;
                                                    phi_5311_ = (_e1981 == 255u);
                                                }
                                                let _e1984 = phi_5309_;
                                                let _e1986 = phi_5310_;
                                                let _e1988 = phi_5311_;
                                                if _e1988 {
                                                    phi_5320_ = (_e1978 == 0u);
                                                } else {
                                                    phi_5320_ = true;
                                                }
                                                let _e1991 = phi_5320_;
                                                phi_5332_ = bitcast<f32>((((_e1974 | (select(_e1984, select(_e1986, _e1984, _e1988), _e1991) << bitcast<u32>(23i))) | (_e1978 << bitcast<u32>(13i))) | select(4194304u, 0u, _e1991)));
                                            }
                                            let _e2009 = phi_5332_;
                                            let _e2015 = (_e1730 + _e1921);
                                            let _e2016 = (_e2015 < _e71);
                                            if _e2016 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2018 = b.member[_e2015];
                                            let _e2019 = (_e2018 & 65535u);
                                            let _e2022 = ((_e2019 & 32768u) << bitcast<u32>(16i));
                                            let _e2025 = ((_e2019 >> bitcast<u32>(10i)) & 31u);
                                            let _e2026 = (_e2019 & 1023u);
                                            if (_e2025 == 0u) {
                                                phi_5408_ = bitcast<f32>((_e2022 | bitcast<u32>((f32(_e2026) * 0.000000059604645f))));
                                            } else {
                                                if (_e2025 == 31u) {
                                                    phi_5385_ = 255u;
                                                    phi_5386_ = u32();
                                                    phi_5387_ = true;
                                                } else {
                                                    let _e2029 = (_e2025 + 112u);
                                                    phi_5385_ = _e2029;
                                                    phi_5386_ = _e2029;
                                                    phi_5387_ = (_e2029 == 255u);
                                                }
                                                let _e2032 = phi_5385_;
                                                let _e2034 = phi_5386_;
                                                let _e2036 = phi_5387_;
                                                if _e2036 {
                                                    phi_5396_ = (_e2026 == 0u);
                                                } else {
                                                    phi_5396_ = true;
                                                }
                                                let _e2039 = phi_5396_;
                                                phi_5408_ = bitcast<f32>((((_e2022 | (select(_e2032, select(_e2034, _e2032, _e2036), _e2039) << bitcast<u32>(23i))) | (_e2026 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2039)));
                                            }
                                            let _e2057 = phi_5408_;
                                            if _e2016 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2065 = ((_e2018 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2068 = ((_e2065 & 32768u) << bitcast<u32>(16i));
                                            let _e2071 = ((_e2065 >> bitcast<u32>(10i)) & 31u);
                                            let _e2072 = (_e2065 & 1023u);
                                            if (_e2071 == 0u) {
                                                phi_5484_ = bitcast<f32>((_e2068 | bitcast<u32>((f32(_e2072) * 0.000000059604645f))));
                                            } else {
                                                if (_e2071 == 31u) {
                                                    phi_5461_ = 255u;
                                                    phi_5462_ = u32();
                                                    phi_5463_ = true;
                                                } else {
                                                    let _e2075 = (_e2071 + 112u);
                                                    phi_5461_ = _e2075;
                                                    phi_5462_ = _e2075;
                                                    phi_5463_ = (_e2075 == 255u);
                                                }
                                                let _e2078 = phi_5461_;
                                                let _e2080 = phi_5462_;
                                                let _e2082 = phi_5463_;
                                                if _e2082 {
                                                    phi_5472_ = (_e2072 == 0u);
                                                } else {
                                                    phi_5472_ = true;
                                                }
                                                let _e2085 = phi_5472_;
                                                phi_5484_ = bitcast<f32>((((_e2068 | (select(_e2078, select(_e2080, _e2078, _e2082), _e2085) << bitcast<u32>(23i))) | (_e2072 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2085)));
                                            }
                                            let _e2103 = phi_5484_;
                                            let _e2109 = (_e1825 + _e1921);
                                            let _e2110 = (_e2109 < _e71);
                                            if _e2110 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2112 = b.member[_e2109];
                                            let _e2113 = (_e2112 & 65535u);
                                            let _e2116 = ((_e2113 & 32768u) << bitcast<u32>(16i));
                                            let _e2119 = ((_e2113 >> bitcast<u32>(10i)) & 31u);
                                            let _e2120 = (_e2113 & 1023u);
                                            if (_e2119 == 0u) {
                                                phi_5560_ = bitcast<f32>((_e2116 | bitcast<u32>((f32(_e2120) * 0.000000059604645f))));
                                            } else {
                                                if (_e2119 == 31u) {
                                                    phi_5537_ = 255u;
                                                    phi_5538_ = u32();
                                                    phi_5539_ = true;
                                                } else {
                                                    let _e2123 = (_e2119 + 112u);
                                                    phi_5537_ = _e2123;
                                                    phi_5538_ = _e2123;
                                                    phi_5539_ = (_e2123 == 255u);
                                                }
                                                let _e2126 = phi_5537_;
                                                let _e2128 = phi_5538_;
                                                let _e2130 = phi_5539_;
                                                if _e2130 {
                                                    phi_5548_ = (_e2120 == 0u);
                                                } else {
                                                    phi_5548_ = true;
                                                }
                                                let _e2133 = phi_5548_;
                                                phi_5560_ = bitcast<f32>((((_e2116 | (select(_e2126, select(_e2128, _e2126, _e2130), _e2133) << bitcast<u32>(23i))) | (_e2120 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2133)));
                                            }
                                            let _e2151 = phi_5560_;
                                            if _e2110 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2159 = ((_e2112 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2162 = ((_e2159 & 32768u) << bitcast<u32>(16i));
                                            let _e2165 = ((_e2159 >> bitcast<u32>(10i)) & 31u);
                                            let _e2166 = (_e2159 & 1023u);
                                            if (_e2165 == 0u) {
                                                phi_5636_ = bitcast<f32>((_e2162 | bitcast<u32>((f32(_e2166) * 0.000000059604645f))));
                                            } else {
                                                if (_e2165 == 31u) {
                                                    phi_5613_ = 255u;
                                                    phi_5614_ = u32();
                                                    phi_5615_ = true;
                                                } else {
                                                    let _e2169 = (_e2165 + 112u);
                                                    phi_5613_ = _e2169;
                                                    phi_5614_ = _e2169;
                                                    phi_5615_ = (_e2169 == 255u);
                                                }
                                                let _e2172 = phi_5613_;
                                                let _e2174 = phi_5614_;
                                                let _e2176 = phi_5615_;
                                                if _e2176 {
                                                    phi_5624_ = (_e2166 == 0u);
                                                } else {
                                                    phi_5624_ = true;
                                                }
                                                let _e2179 = phi_5624_;
                                                phi_5636_ = bitcast<f32>((((_e2162 | (select(_e2172, select(_e2174, _e2172, _e2176), _e2179) << bitcast<u32>(23i))) | (_e2166 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2179)));
                                            }
                                            let _e2197 = phi_5636_;
                                            let _e2205 = ((2u * _e1471) + _e1635);
                                            let _e2206 = (_e2205 < _e71);
                                            if _e2206 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2208 = b.member[_e2205];
                                            let _e2209 = (_e2208 & 65535u);
                                            let _e2212 = ((_e2209 & 32768u) << bitcast<u32>(16i));
                                            let _e2215 = ((_e2209 >> bitcast<u32>(10i)) & 31u);
                                            let _e2216 = (_e2209 & 1023u);
                                            if (_e2215 == 0u) {
                                                phi_5712_ = bitcast<f32>((_e2212 | bitcast<u32>((f32(_e2216) * 0.000000059604645f))));
                                            } else {
                                                if (_e2215 == 31u) {
                                                    phi_5689_ = 255u;
                                                    phi_5690_ = u32();
                                                    phi_5691_ = true;
                                                } else {
                                                    let _e2219 = (_e2215 + 112u);
                                                    phi_5689_ = _e2219;
                                                    phi_5690_ = _e2219;
                                                    phi_5691_ = (_e2219 == 255u);
                                                }
                                                let _e2222 = phi_5689_;
                                                let _e2224 = phi_5690_;
                                                let _e2226 = phi_5691_;
                                                if _e2226 {
                                                    phi_5700_ = (_e2216 == 0u);
                                                } else {
                                                    phi_5700_ = true;
                                                }
                                                let _e2229 = phi_5700_;
                                                phi_5712_ = bitcast<f32>((((_e2212 | (select(_e2222, select(_e2224, _e2222, _e2226), _e2229) << bitcast<u32>(23i))) | (_e2216 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2229)));
                                            }
                                            let _e2247 = phi_5712_;
                                            if _e2206 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2255 = ((_e2208 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2258 = ((_e2255 & 32768u) << bitcast<u32>(16i));
                                            let _e2261 = ((_e2255 >> bitcast<u32>(10i)) & 31u);
                                            let _e2262 = (_e2255 & 1023u);
                                            if (_e2261 == 0u) {
                                                phi_5788_ = bitcast<f32>((_e2258 | bitcast<u32>((f32(_e2262) * 0.000000059604645f))));
                                            } else {
                                                if (_e2261 == 31u) {
                                                    phi_5765_ = 255u;
                                                    phi_5766_ = u32();
                                                    phi_5767_ = true;
                                                } else {
                                                    let _e2265 = (_e2261 + 112u);
                                                    phi_5765_ = _e2265;
                                                    phi_5766_ = _e2265;
                                                    phi_5767_ = (_e2265 == 255u);
                                                }
                                                let _e2268 = phi_5765_;
                                                let _e2270 = phi_5766_;
                                                let _e2272 = phi_5767_;
                                                if _e2272 {
                                                    phi_5776_ = (_e2262 == 0u);
                                                } else {
                                                    phi_5776_ = true;
                                                }
                                                let _e2275 = phi_5776_;
                                                phi_5788_ = bitcast<f32>((((_e2258 | (select(_e2268, select(_e2270, _e2268, _e2272), _e2275) << bitcast<u32>(23i))) | (_e2262 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2275)));
                                            }
                                            let _e2293 = phi_5788_;
                                            let _e2299 = (_e1730 + _e2205);
                                            let _e2300 = (_e2299 < _e71);
                                            if _e2300 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2302 = b.member[_e2299];
                                            let _e2303 = (_e2302 & 65535u);
                                            let _e2306 = ((_e2303 & 32768u) << bitcast<u32>(16i));
                                            let _e2309 = ((_e2303 >> bitcast<u32>(10i)) & 31u);
                                            let _e2310 = (_e2303 & 1023u);
                                            if (_e2309 == 0u) {
                                                phi_5864_ = bitcast<f32>((_e2306 | bitcast<u32>((f32(_e2310) * 0.000000059604645f))));
                                            } else {
                                                if (_e2309 == 31u) {
                                                    phi_5841_ = 255u;
                                                    phi_5842_ = u32();
                                                    phi_5843_ = true;
                                                } else {
                                                    let _e2313 = (_e2309 + 112u);
                                                    phi_5841_ = _e2313;
                                                    phi_5842_ = _e2313;
                                                    phi_5843_ = (_e2313 == 255u);
                                                }
                                                let _e2316 = phi_5841_;
                                                let _e2318 = phi_5842_;
                                                let _e2320 = phi_5843_;
                                                if _e2320 {
                                                    phi_5852_ = (_e2310 == 0u);
                                                } else {
                                                    phi_5852_ = true;
                                                }
                                                let _e2323 = phi_5852_;
                                                phi_5864_ = bitcast<f32>((((_e2306 | (select(_e2316, select(_e2318, _e2316, _e2320), _e2323) << bitcast<u32>(23i))) | (_e2310 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2323)));
                                            }
                                            let _e2341 = phi_5864_;
                                            if _e2300 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2349 = ((_e2302 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2352 = ((_e2349 & 32768u) << bitcast<u32>(16i));
                                            let _e2355 = ((_e2349 >> bitcast<u32>(10i)) & 31u);
                                            let _e2356 = (_e2349 & 1023u);
                                            if (_e2355 == 0u) {
                                                phi_5940_ = bitcast<f32>((_e2352 | bitcast<u32>((f32(_e2356) * 0.000000059604645f))));
                                            } else {
                                                if (_e2355 == 31u) {
                                                    phi_5917_ = 255u;
                                                    phi_5918_ = u32();
                                                    phi_5919_ = true;
                                                } else {
                                                    let _e2359 = (_e2355 + 112u);
                                                    phi_5917_ = _e2359;
                                                    phi_5918_ = _e2359;
                                                    phi_5919_ = (_e2359 == 255u);
                                                }
                                                let _e2362 = phi_5917_;
                                                let _e2364 = phi_5918_;
                                                let _e2366 = phi_5919_;
                                                if _e2366 {
                                                    phi_5928_ = (_e2356 == 0u);
                                                } else {
                                                    phi_5928_ = true;
                                                }
                                                let _e2369 = phi_5928_;
                                                phi_5940_ = bitcast<f32>((((_e2352 | (select(_e2362, select(_e2364, _e2362, _e2366), _e2369) << bitcast<u32>(23i))) | (_e2356 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2369)));
                                            }
                                            let _e2387 = phi_5940_;
                                            let _e2393 = (_e1825 + _e2205);
                                            let _e2394 = (_e2393 < _e71);
                                            if _e2394 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2396 = b.member[_e2393];
                                            let _e2397 = (_e2396 & 65535u);
                                            let _e2400 = ((_e2397 & 32768u) << bitcast<u32>(16i));
                                            let _e2403 = ((_e2397 >> bitcast<u32>(10i)) & 31u);
                                            let _e2404 = (_e2397 & 1023u);
                                            if (_e2403 == 0u) {
                                                phi_6016_ = bitcast<f32>((_e2400 | bitcast<u32>((f32(_e2404) * 0.000000059604645f))));
                                            } else {
                                                if (_e2403 == 31u) {
                                                    phi_5993_ = 255u;
                                                    phi_5994_ = u32();
                                                    phi_5995_ = true;
                                                } else {
                                                    let _e2407 = (_e2403 + 112u);
                                                    phi_5993_ = _e2407;
                                                    phi_5994_ = _e2407;
                                                    phi_5995_ = (_e2407 == 255u);
                                                }
                                                let _e2410 = phi_5993_;
                                                let _e2412 = phi_5994_;
                                                let _e2414 = phi_5995_;
                                                if _e2414 {
                                                    phi_6004_ = (_e2404 == 0u);
                                                } else {
                                                    phi_6004_ = true;
                                                }
                                                let _e2417 = phi_6004_;
                                                phi_6016_ = bitcast<f32>((((_e2400 | (select(_e2410, select(_e2412, _e2410, _e2414), _e2417) << bitcast<u32>(23i))) | (_e2404 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2417)));
                                            }
                                            let _e2435 = phi_6016_;
                                            if _e2394 {
                                            } else {
                                                phi_16783_ = true;
                                                break;
                                            }
                                            let _e2443 = ((_e2396 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2446 = ((_e2443 & 32768u) << bitcast<u32>(16i));
                                            let _e2449 = ((_e2443 >> bitcast<u32>(10i)) & 31u);
                                            let _e2450 = (_e2443 & 1023u);
                                            if (_e2449 == 0u) {
                                                phi_6092_ = bitcast<f32>((_e2446 | bitcast<u32>((f32(_e2450) * 0.000000059604645f))));
                                            } else {
                                                if (_e2449 == 31u) {
                                                    phi_6069_ = 255u;
                                                    phi_6070_ = u32();
                                                    phi_6071_ = true;
                                                } else {
                                                    let _e2453 = (_e2449 + 112u);
                                                    phi_6069_ = _e2453;
                                                    phi_6070_ = _e2453;
                                                    phi_6071_ = (_e2453 == 255u);
                                                }
                                                let _e2456 = phi_6069_;
                                                let _e2458 = phi_6070_;
                                                let _e2460 = phi_6071_;
                                                if _e2460 {
                                                    phi_6080_ = (_e2450 == 0u);
                                                } else {
                                                    phi_6080_ = true;
                                                }
                                                let _e2463 = phi_6080_;
                                                phi_6092_ = bitcast<f32>((((_e2446 | (select(_e2456, select(_e2458, _e2456, _e2460), _e2463) << bitcast<u32>(23i))) | (_e2450 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2463)));
                                            }
                                            let _e2481 = phi_6092_;
                                            phi_6098_ = (_e1571 + _e1626);
                                            phi_6099_ = array<array<f32, 6>, 3>(array<f32, 6>((_e1573[0][0] + ((_e1678 * _e96) * _e1626)), (_e1573[0][1] + ((_e1724 * _e96) * _e1626)), (_e1573[0][2] + ((_e1773 * _e96) * _e1626)), (_e1573[0][3] + ((_e1819 * _e96) * _e1626)), (_e1573[0][4] + ((_e1868 * _e96) * _e1626)), (_e1573[0][5] + ((_e1914 * _e96) * _e1626))), array<f32, 6>((_e1573[1][0] + ((_e1963 * _e96) * _e1626)), (_e1573[1][1] + ((_e2009 * _e96) * _e1626)), (_e1573[1][2] + ((_e2057 * _e96) * _e1626)), (_e1573[1][3] + ((_e2103 * _e96) * _e1626)), (_e1573[1][4] + ((_e2151 * _e96) * _e1626)), (_e1573[1][5] + ((_e2197 * _e96) * _e1626))), array<f32, 6>((_e1573[2][0] + ((_e2247 * _e96) * _e1626)), (_e1573[2][1] + ((_e2293 * _e96) * _e1626)), (_e1573[2][2] + ((_e2341 * _e96) * _e1626)), (_e1573[2][3] + ((_e2387 * _e96) * _e1626)), (_e1573[2][4] + ((_e2435 * _e96) * _e1626)), (_e1573[2][5] + ((_e2481 * _e96) * _e1626))));
                                        } else {
                                            phi_6098_ = _e1571;
                                            phi_6099_ = _e1573;
                                        }
                                        let _e2490 = phi_6098_;
                                        let _e2492 = phi_6099_;
                                        phi_4621_ = _e2490;
                                        phi_4623_ = _e2492;
                                    } else {
                                        phi_4621_ = f32();
                                        phi_4623_ = array<array<f32, 6>, 3>();
                                    }
                                    let _e2494 = phi_4621_;
                                    let _e2496 = phi_4623_;
                                    continue;
                                    continuing {
                                        phi_4617_ = _e1586;
                                        phi_4620_ = _e2494;
                                        phi_4622_ = _e2496;
                                        phi_16783_ = _e1377;
                                        break if !(_e1592);
                                    }
                                }
                                let _e2499 = phi_16783_;
                                if _e2499 {
                                    break;
                                }
                                let _e2501 = local_20;
                                if (_e2501 > 0f) {
                                    let _e2504 = local_21;
                                    phi_6105_ = (1f / _e2504);
                                } else {
                                    phi_6105_ = 0f;
                                }
                                let _e2507 = phi_6105_;
                                let _e2509 = local_22;
                                let _e2514 = local_23;
                                let _e2519 = local_24;
                                let _e2524 = local_25;
                                let _e2529 = local_26;
                                let _e2534 = local_27;
                                let _e2539 = local_28;
                                let _e2544 = local_29;
                                let _e2549 = local_30;
                                let _e2554 = local_31;
                                let _e2559 = local_32;
                                let _e2564 = local_33;
                                let _e2569 = local_34;
                                let _e2574 = local_35;
                                let _e2579 = local_36;
                                let _e2584 = local_37;
                                let _e2589 = local_38;
                                let _e2594 = local_39;
                                let _e2599 = ((0.6666667f / _e1389.w) / _e1389.w);
                                let _e2600 = -(_e90.member_2[0]);
                                let _e2601 = -(_e90.member_2[1]);
                                let _e2604 = (_e90.member_2[2] * -1.0233268f);
                                let _e2610 = ((((_e90.member_2[2] * -1.9364917f) * (_e90.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                                let _e2613 = (_e90.member_2[0] * -1.0233268f);
                                let _e2616 = (_e90.member_2[1] * -1.0233268f);
                                let _e2622 = (((_e2600 * _e2600) - (_e2601 * _e2601)) * 0.4290428f);
                                let _e2624 = (((((((_e2509[0][0] * _e2507) * 0.886227f) + ((_e2519[0][2] * _e2507) * _e2604)) + ((_e2529[0][4] * _e2507) * _e2610)) + ((_e2524[0][3] * _e2507) * _e2613)) + ((_e2514[0][1] * _e2507) * _e2616)) + ((_e2534[0][5] * _e2507) * _e2622));
                                let _e2637 = (((((((_e2539[1][0] * _e2507) * 0.886227f) + ((_e2549[1][2] * _e2507) * _e2604)) + ((_e2559[1][4] * _e2507) * _e2610)) + ((_e2554[1][3] * _e2507) * _e2613)) + ((_e2544[1][1] * _e2507) * _e2616)) + ((_e2564[1][5] * _e2507) * _e2622));
                                let _e2650 = (((((((_e2569[2][0] * _e2507) * 0.886227f) + ((_e2579[2][2] * _e2507) * _e2604)) + ((_e2589[2][4] * _e2507) * _e2610)) + ((_e2584[2][3] * _e2507) * _e2613)) + ((_e2574[2][1] * _e2507) * _e2616)) + ((_e2594[2][5] * _e2507) * _e2622));
                                phi_17150_ = _e2499;
                                phi_8393_ = vec4<f32>((_e1382.x + ((select(0f, _e2624, (_e2624 > 0f)) * _e2599) * _e1457)), (_e1382.y + ((select(0f, _e2637, (_e2637 > 0f)) * _e2599) * _e1457)), (_e1382.z + ((select(0f, _e2650, (_e2650 > 0f)) * _e2599) * _e1457)), (_e1382.w - _e1457));
                            }
                            let _e2665 = phi_17150_;
                            let _e2667 = phi_8393_;
                            phi_17149_ = _e2665;
                            phi_8394_ = _e2667;
                        }
                        let _e2669 = phi_17149_;
                        let _e2671 = phi_8394_;
                        phi_17148_ = _e2669;
                        phi_8395_ = _e2671;
                        phi_8396_ = _e1385;
                    }
                    let _e2673 = phi_17148_;
                    let _e2675 = phi_8395_;
                    let _e2677 = phi_8396_;
                    let _e2679 = select(_e2675, _e1382, vec4(_e2677));
                    if (2u >= _e99) {
                        phi_17487_ = _e2673;
                        phi_12515_ = vec4<f32>();
                        phi_12516_ = true;
                    } else {
                        let _e2682 = (_e2679.w <= 0f);
                        if _e2682 {
                            phi_17488_ = _e2673;
                            phi_12514_ = vec4<f32>();
                        } else {
                            let _e2686 = params.member.member[2u];
                            let _e2690 = params.member.member_1[2u];
                            let _e2694 = params.member.member_2[2u];
                            if (3u == _e99) {
                                phi_8456_ = 0f;
                            } else {
                                let _e2706 = params.member.member_5;
                                phi_8456_ = _e2706;
                            }
                            let _e2708 = phi_8456_;
                            let _e2716 = ((_e90.member[0] - _e2686.x) / _e2686.w);
                            let _e2717 = ((_e90.member[1] - _e2686.y) / _e2686.w);
                            let _e2718 = ((_e90.member[2] - _e2686.z) / _e2686.w);
                            let _e2725 = (_e2716 - f32(_e2690.x));
                            let _e2726 = (_e2717 - f32(_e2690.y));
                            let _e2727 = (_e2718 - f32(_e2690.z));
                            let _e2735 = select(_e2727, _e2726, (_e2726 < _e2727));
                            let _e2737 = select(_e2735, _e2725, (_e2725 < _e2735));
                            let _e2738 = (f32(_e2694.x) - _e2725);
                            let _e2739 = (f32(_e2694.y) - _e2726);
                            let _e2740 = (f32(_e2694.z) - _e2727);
                            let _e2742 = select(_e2740, _e2739, (_e2739 < _e2740));
                            let _e2744 = select(_e2742, _e2738, (_e2738 < _e2742));
                            let _e2749 = (select(_e2744, _e2737, (_e2737 < _e2744)) / select(0.001f, _e2708, (_e2708 > 0.001f)));
                            let _e2751 = select(0f, _e2749, (_e2749 > 0f));
                            let _e2754 = (_e2679.w * select(1f, _e2751, (_e2751 < 1f)));
                            if (_e2754 <= 0f) {
                                phi_17489_ = _e2673;
                                phi_12513_ = _e2679;
                            } else {
                                let _e2761 = params.member.member_6;
                                let _e2762 = (_e2694.x + 1u);
                                let _e2764 = ((_e2694.y + 1u) * _e2762);
                                let _e2765 = (_e2764 + _e2762);
                                let _e2768 = (_e2765 + ((_e2694.z + 1u) * _e2764));
                                let _e2775 = ((_e2716 + (_e90.member_2[0] * _e2761)) - 0.5f);
                                let _e2776 = floor(_e2775);
                                let _e2778 = (bitcast<i32>(_e2694.x) - 1i);
                                let _e2786 = (select(0i, select(select(i32(_e2776), i32(-2147483648), (_e2776 < -2147483600f)), 2147483647i, (_e2776 > 2147483500f)), (_e2776 == _e2776)) - _e2690.x);
                                let _e2788 = select(0i, _e2786, (0i < _e2786));
                                let _e2790 = select(_e2788, _e2778, (_e2778 < _e2788));
                                let _e2791 = (_e2786 + 1i);
                                let _e2793 = select(0i, _e2791, (0i < _e2791));
                                let _e2795 = select(_e2793, _e2778, (_e2778 < _e2793));
                                let _e2798 = (_e2775 - _e2776);
                                let _e2805 = ((_e2717 + (_e90.member_2[1] * _e2761)) - 0.5f);
                                let _e2806 = floor(_e2805);
                                let _e2808 = (bitcast<i32>(_e2694.y) - 1i);
                                let _e2816 = (select(0i, select(select(i32(_e2806), i32(-2147483648), (_e2806 < -2147483600f)), 2147483647i, (_e2806 > 2147483500f)), (_e2806 == _e2806)) - _e2690.y);
                                let _e2818 = select(0i, _e2816, (0i < _e2816));
                                let _e2820 = select(_e2818, _e2808, (_e2808 < _e2818));
                                let _e2821 = (_e2816 + 1i);
                                let _e2823 = select(0i, _e2821, (0i < _e2821));
                                let _e2825 = select(_e2823, _e2808, (_e2808 < _e2823));
                                let _e2828 = (_e2805 - _e2806);
                                let _e2835 = ((_e2718 + (_e90.member_2[2] * _e2761)) - 0.5f);
                                let _e2836 = floor(_e2835);
                                let _e2838 = (bitcast<i32>(_e2694.z) - 1i);
                                let _e2846 = (select(0i, select(select(i32(_e2836), i32(-2147483648), (_e2836 < -2147483600f)), 2147483647i, (_e2836 > 2147483500f)), (_e2836 == _e2836)) - _e2690.z);
                                let _e2848 = select(0i, _e2846, (0i < _e2846));
                                let _e2850 = select(_e2848, _e2838, (_e2838 < _e2848));
                                let _e2851 = (_e2846 + 1i);
                                let _e2853 = select(0i, _e2851, (0i < _e2851));
                                let _e2855 = select(_e2853, _e2838, (_e2838 < _e2853));
                                let _e2858 = (_e2835 - _e2836);
                                phi_8737_ = type_12(0u, 8u);
                                phi_8740_ = 0f;
                                phi_8742_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                                loop {
                                    let _e2866 = phi_8737_;
                                    let _e2868 = phi_8740_;
                                    let _e2870 = phi_8742_;
                                    local_40 = _e2868;
                                    local_41 = _e2868;
                                    local_42 = _e2870;
                                    local_43 = _e2870;
                                    local_44 = _e2870;
                                    local_45 = _e2870;
                                    local_46 = _e2870;
                                    local_47 = _e2870;
                                    local_48 = _e2870;
                                    local_49 = _e2870;
                                    local_50 = _e2870;
                                    local_51 = _e2870;
                                    local_52 = _e2870;
                                    local_53 = _e2870;
                                    local_54 = _e2870;
                                    local_55 = _e2870;
                                    local_56 = _e2870;
                                    local_57 = _e2870;
                                    local_58 = _e2870;
                                    local_59 = _e2870;
                                    if (_e2866.member < _e2866.member_1) {
                                        phi_8738_ = type_12((_e2866.member + 1u), _e2866.member_1);
                                        phi_8765_ = type_12(1u, _e2866.member);
                                    } else {
                                        phi_8738_ = _e2866;
                                        phi_8765_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2883 = phi_8738_;
                                    let _e2885 = phi_8765_;
                                    let _e2889 = (bitcast<i32>(_e2885.member) != 0i);
                                    if _e2889 {
                                        let _e2891 = ((_e2885.member_1 & 1u) == 1u);
                                        let _e2893 = ((_e2885.member_1 & 2u) == 2u);
                                        let _e2895 = ((_e2885.member_1 & 4u) == 4u);
                                        if _e2891 {
                                            phi_8795_ = _e2798;
                                        } else {
                                            phi_8795_ = (1f - _e2798);
                                        }
                                        let _e2901 = phi_8795_;
                                        if _e2893 {
                                            phi_8800_ = _e2828;
                                        } else {
                                            phi_8800_ = (1f - _e2828);
                                        }
                                        let _e2904 = phi_8800_;
                                        if _e2895 {
                                            phi_8806_ = _e2858;
                                        } else {
                                            phi_8806_ = (1f - _e2858);
                                        }
                                        let _e2908 = phi_8806_;
                                        let _e2918 = (((((select((f32((_e2790 + _e2690.x)) + 0.5f), (f32((_e2795 + _e2690.x)) + 0.5f), _e2891) - _e2716) * _e90.member_2[0]) + ((select((f32((_e2820 + _e2690.y)) + 0.5f), (f32((_e2825 + _e2690.y)) + 0.5f), _e2893) - _e2717) * _e90.member_2[1])) + ((select((f32((_e2850 + _e2690.z)) + 0.5f), (f32((_e2855 + _e2690.z)) + 0.5f), _e2895) - _e2718) * _e90.member_2[2])) * 2f);
                                        let _e2920 = select(0f, _e2918, (_e2918 > 0f));
                                        let _e2923 = (((_e2901 * _e2904) * _e2908) * select(1f, _e2920, (_e2920 < 1f)));
                                        if (_e2923 > 0f) {
                                            let _e2932 = (((_e2765 + select(bitcast<u32>(_e2790), bitcast<u32>(_e2795), _e2891)) + (select(bitcast<u32>(_e2820), bitcast<u32>(_e2825), _e2893) * _e2762)) + (select(bitcast<u32>(_e2850), bitcast<u32>(_e2855), _e2895) * _e2764));
                                            let _e2934 = (_e2932 < _e74);
                                            if _e2934 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e2936 = c.member[_e2932];
                                            let _e2937 = (_e2936 & 65535u);
                                            let _e2940 = ((_e2937 & 32768u) << bitcast<u32>(16i));
                                            let _e2943 = ((_e2937 >> bitcast<u32>(10i)) & 31u);
                                            let _e2944 = (_e2937 & 1023u);
                                            if (_e2943 == 0u) {
                                                phi_8920_ = bitcast<f32>((_e2940 | bitcast<u32>((f32(_e2944) * 0.000000059604645f))));
                                            } else {
                                                if (_e2943 == 31u) {
                                                    phi_8897_ = 255u;
                                                    phi_8898_ = u32();
                                                    phi_8899_ = true;
                                                } else {
                                                    let _e2947 = (_e2943 + 112u);
                                                    phi_8897_ = _e2947;
                                                    phi_8898_ = _e2947;
                                                    phi_8899_ = (_e2947 == 255u);
                                                }
                                                let _e2950 = phi_8897_;
                                                let _e2952 = phi_8898_;
                                                let _e2954 = phi_8899_;
                                                if _e2954 {
                                                    phi_8908_ = (_e2944 == 0u);
                                                } else {
                                                    phi_8908_ = true;
                                                }
                                                let _e2957 = phi_8908_;
                                                phi_8920_ = bitcast<f32>((((_e2940 | (select(_e2950, select(_e2952, _e2950, _e2954), _e2957) << bitcast<u32>(23i))) | (_e2944 << bitcast<u32>(13i))) | select(4194304u, 0u, _e2957)));
                                            }
                                            let _e2975 = phi_8920_;
                                            if _e2934 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e2983 = ((_e2936 >> bitcast<u32>(16u)) & 65535u);
                                            let _e2986 = ((_e2983 & 32768u) << bitcast<u32>(16i));
                                            let _e2989 = ((_e2983 >> bitcast<u32>(10i)) & 31u);
                                            let _e2990 = (_e2983 & 1023u);
                                            if (_e2989 == 0u) {
                                                phi_8996_ = bitcast<f32>((_e2986 | bitcast<u32>((f32(_e2990) * 0.000000059604645f))));
                                            } else {
                                                if (_e2989 == 31u) {
                                                    phi_8973_ = 255u;
                                                    phi_8974_ = u32();
                                                    phi_8975_ = true;
                                                } else {
                                                    let _e2993 = (_e2989 + 112u);
                                                    phi_8973_ = _e2993;
                                                    phi_8974_ = _e2993;
                                                    phi_8975_ = (_e2993 == 255u);
                                                }
                                                let _e2996 = phi_8973_;
                                                let _e2998 = phi_8974_;
                                                let _e3000 = phi_8975_;
                                                if _e3000 {
                                                    phi_8984_ = (_e2990 == 0u);
                                                } else {
                                                    phi_8984_ = true;
                                                }
                                                let _e3003 = phi_8984_;
                                                phi_8996_ = bitcast<f32>((((_e2986 | (select(_e2996, select(_e2998, _e2996, _e3000), _e3003) << bitcast<u32>(23i))) | (_e2990 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3003)));
                                            }
                                            let _e3021 = phi_8996_;
                                            let _e3027 = (3u * _e2768);
                                            let _e3028 = (_e3027 + _e2932);
                                            let _e3029 = (_e3028 < _e74);
                                            if _e3029 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3031 = c.member[_e3028];
                                            let _e3032 = (_e3031 & 65535u);
                                            let _e3035 = ((_e3032 & 32768u) << bitcast<u32>(16i));
                                            let _e3038 = ((_e3032 >> bitcast<u32>(10i)) & 31u);
                                            let _e3039 = (_e3032 & 1023u);
                                            if (_e3038 == 0u) {
                                                phi_9072_ = bitcast<f32>((_e3035 | bitcast<u32>((f32(_e3039) * 0.000000059604645f))));
                                            } else {
                                                if (_e3038 == 31u) {
                                                    phi_9049_ = 255u;
                                                    phi_9050_ = u32();
                                                    phi_9051_ = true;
                                                } else {
                                                    let _e3042 = (_e3038 + 112u);
                                                    phi_9049_ = _e3042;
                                                    phi_9050_ = _e3042;
                                                    phi_9051_ = (_e3042 == 255u);
                                                }
                                                let _e3045 = phi_9049_;
                                                let _e3047 = phi_9050_;
                                                let _e3049 = phi_9051_;
                                                if _e3049 {
                                                    phi_9060_ = (_e3039 == 0u);
                                                } else {
                                                    phi_9060_ = true;
                                                }
                                                let _e3052 = phi_9060_;
                                                phi_9072_ = bitcast<f32>((((_e3035 | (select(_e3045, select(_e3047, _e3045, _e3049), _e3052) << bitcast<u32>(23i))) | (_e3039 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3052)));
                                            }
                                            let _e3070 = phi_9072_;
                                            if _e3029 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3078 = ((_e3031 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3081 = ((_e3078 & 32768u) << bitcast<u32>(16i));
                                            let _e3084 = ((_e3078 >> bitcast<u32>(10i)) & 31u);
                                            let _e3085 = (_e3078 & 1023u);
                                            if (_e3084 == 0u) {
                                                phi_9148_ = bitcast<f32>((_e3081 | bitcast<u32>((f32(_e3085) * 0.000000059604645f))));
                                            } else {
                                                if (_e3084 == 31u) {
                                                    phi_9125_ = 255u;
                                                    phi_9126_ = u32();
                                                    phi_9127_ = true;
                                                } else {
                                                    let _e3088 = (_e3084 + 112u);
                                                    phi_9125_ = _e3088;
                                                    phi_9126_ = _e3088;
                                                    phi_9127_ = (_e3088 == 255u);
                                                }
                                                let _e3091 = phi_9125_;
                                                let _e3093 = phi_9126_;
                                                let _e3095 = phi_9127_;
                                                if _e3095 {
                                                    phi_9136_ = (_e3085 == 0u);
                                                } else {
                                                    phi_9136_ = true;
                                                }
                                                let _e3098 = phi_9136_;
                                                phi_9148_ = bitcast<f32>((((_e3081 | (select(_e3091, select(_e3093, _e3091, _e3095), _e3098) << bitcast<u32>(23i))) | (_e3085 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3098)));
                                            }
                                            let _e3116 = phi_9148_;
                                            let _e3122 = (_e2768 * 6u);
                                            let _e3123 = (_e3122 + _e2932);
                                            let _e3124 = (_e3123 < _e74);
                                            if _e3124 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3126 = c.member[_e3123];
                                            let _e3127 = (_e3126 & 65535u);
                                            let _e3130 = ((_e3127 & 32768u) << bitcast<u32>(16i));
                                            let _e3133 = ((_e3127 >> bitcast<u32>(10i)) & 31u);
                                            let _e3134 = (_e3127 & 1023u);
                                            if (_e3133 == 0u) {
                                                phi_9224_ = bitcast<f32>((_e3130 | bitcast<u32>((f32(_e3134) * 0.000000059604645f))));
                                            } else {
                                                if (_e3133 == 31u) {
                                                    phi_9201_ = 255u;
                                                    phi_9202_ = u32();
                                                    phi_9203_ = true;
                                                } else {
                                                    let _e3137 = (_e3133 + 112u);
                                                    phi_9201_ = _e3137;
                                                    phi_9202_ = _e3137;
                                                    phi_9203_ = (_e3137 == 255u);
                                                }
                                                let _e3140 = phi_9201_;
                                                let _e3142 = phi_9202_;
                                                let _e3144 = phi_9203_;
                                                if _e3144 {
                                                    phi_9212_ = (_e3134 == 0u);
                                                } else {
                                                    phi_9212_ = true;
                                                }
                                                let _e3147 = phi_9212_;
                                                phi_9224_ = bitcast<f32>((((_e3130 | (select(_e3140, select(_e3142, _e3140, _e3144), _e3147) << bitcast<u32>(23i))) | (_e3134 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3147)));
                                            }
                                            let _e3165 = phi_9224_;
                                            if _e3124 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3173 = ((_e3126 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3176 = ((_e3173 & 32768u) << bitcast<u32>(16i));
                                            let _e3179 = ((_e3173 >> bitcast<u32>(10i)) & 31u);
                                            let _e3180 = (_e3173 & 1023u);
                                            if (_e3179 == 0u) {
                                                phi_9300_ = bitcast<f32>((_e3176 | bitcast<u32>((f32(_e3180) * 0.000000059604645f))));
                                            } else {
                                                if (_e3179 == 31u) {
                                                    phi_9277_ = 255u;
                                                    phi_9278_ = u32();
                                                    phi_9279_ = true;
                                                } else {
                                                    let _e3183 = (_e3179 + 112u);
                                                    phi_9277_ = _e3183;
                                                    phi_9278_ = _e3183;
                                                    phi_9279_ = (_e3183 == 255u);
                                                }
                                                let _e3186 = phi_9277_;
                                                let _e3188 = phi_9278_;
                                                let _e3190 = phi_9279_;
                                                if _e3190 {
                                                    phi_9288_ = (_e3180 == 0u);
                                                } else {
                                                    phi_9288_ = true;
                                                }
                                                let _e3193 = phi_9288_;
                                                phi_9300_ = bitcast<f32>((((_e3176 | (select(_e3186, select(_e3188, _e3186, _e3190), _e3193) << bitcast<u32>(23i))) | (_e3180 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3193)));
                                            }
                                            let _e3211 = phi_9300_;
                                            let _e3218 = (_e2768 + _e2932);
                                            let _e3219 = (_e3218 < _e74);
                                            if _e3219 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3221 = c.member[_e3218];
                                            let _e3222 = (_e3221 & 65535u);
                                            let _e3225 = ((_e3222 & 32768u) << bitcast<u32>(16i));
                                            let _e3228 = ((_e3222 >> bitcast<u32>(10i)) & 31u);
                                            let _e3229 = (_e3222 & 1023u);
                                            if (_e3228 == 0u) {
                                                phi_9376_ = bitcast<f32>((_e3225 | bitcast<u32>((f32(_e3229) * 0.000000059604645f))));
                                            } else {
                                                if (_e3228 == 31u) {
                                                    phi_9353_ = 255u;
                                                    phi_9354_ = u32();
                                                    phi_9355_ = true;
                                                } else {
                                                    let _e3232 = (_e3228 + 112u);
                                                    phi_9353_ = _e3232;
                                                    phi_9354_ = _e3232;
                                                    phi_9355_ = (_e3232 == 255u);
                                                }
                                                let _e3235 = phi_9353_;
                                                let _e3237 = phi_9354_;
                                                let _e3239 = phi_9355_;
                                                if _e3239 {
                                                    phi_9364_ = (_e3229 == 0u);
                                                } else {
                                                    phi_9364_ = true;
                                                }
                                                let _e3242 = phi_9364_;
                                                phi_9376_ = bitcast<f32>((((_e3225 | (select(_e3235, select(_e3237, _e3235, _e3239), _e3242) << bitcast<u32>(23i))) | (_e3229 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3242)));
                                            }
                                            let _e3260 = phi_9376_;
                                            if _e3219 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3268 = ((_e3221 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3271 = ((_e3268 & 32768u) << bitcast<u32>(16i));
                                            let _e3274 = ((_e3268 >> bitcast<u32>(10i)) & 31u);
                                            let _e3275 = (_e3268 & 1023u);
                                            if (_e3274 == 0u) {
                                                phi_9452_ = bitcast<f32>((_e3271 | bitcast<u32>((f32(_e3275) * 0.000000059604645f))));
                                            } else {
                                                if (_e3274 == 31u) {
                                                    phi_9429_ = 255u;
                                                    phi_9430_ = u32();
                                                    phi_9431_ = true;
                                                } else {
                                                    let _e3278 = (_e3274 + 112u);
                                                    phi_9429_ = _e3278;
                                                    phi_9430_ = _e3278;
                                                    phi_9431_ = (_e3278 == 255u);
                                                }
                                                let _e3281 = phi_9429_;
                                                let _e3283 = phi_9430_;
                                                let _e3285 = phi_9431_;
                                                if _e3285 {
                                                    phi_9440_ = (_e3275 == 0u);
                                                } else {
                                                    phi_9440_ = true;
                                                }
                                                let _e3288 = phi_9440_;
                                                phi_9452_ = bitcast<f32>((((_e3271 | (select(_e3281, select(_e3283, _e3281, _e3285), _e3288) << bitcast<u32>(23i))) | (_e3275 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3288)));
                                            }
                                            let _e3306 = phi_9452_;
                                            let _e3312 = (_e3027 + _e3218);
                                            let _e3313 = (_e3312 < _e74);
                                            if _e3313 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3315 = c.member[_e3312];
                                            let _e3316 = (_e3315 & 65535u);
                                            let _e3319 = ((_e3316 & 32768u) << bitcast<u32>(16i));
                                            let _e3322 = ((_e3316 >> bitcast<u32>(10i)) & 31u);
                                            let _e3323 = (_e3316 & 1023u);
                                            if (_e3322 == 0u) {
                                                phi_9528_ = bitcast<f32>((_e3319 | bitcast<u32>((f32(_e3323) * 0.000000059604645f))));
                                            } else {
                                                if (_e3322 == 31u) {
                                                    phi_9505_ = 255u;
                                                    phi_9506_ = u32();
                                                    phi_9507_ = true;
                                                } else {
                                                    let _e3326 = (_e3322 + 112u);
                                                    phi_9505_ = _e3326;
                                                    phi_9506_ = _e3326;
                                                    phi_9507_ = (_e3326 == 255u);
                                                }
                                                let _e3329 = phi_9505_;
                                                let _e3331 = phi_9506_;
                                                let _e3333 = phi_9507_;
                                                if _e3333 {
                                                    phi_9516_ = (_e3323 == 0u);
                                                } else {
                                                    phi_9516_ = true;
                                                }
                                                let _e3336 = phi_9516_;
                                                phi_9528_ = bitcast<f32>((((_e3319 | (select(_e3329, select(_e3331, _e3329, _e3333), _e3336) << bitcast<u32>(23i))) | (_e3323 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3336)));
                                            }
                                            let _e3354 = phi_9528_;
                                            if _e3313 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3362 = ((_e3315 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3365 = ((_e3362 & 32768u) << bitcast<u32>(16i));
                                            let _e3368 = ((_e3362 >> bitcast<u32>(10i)) & 31u);
                                            let _e3369 = (_e3362 & 1023u);
                                            if (_e3368 == 0u) {
                                                phi_9604_ = bitcast<f32>((_e3365 | bitcast<u32>((f32(_e3369) * 0.000000059604645f))));
                                            } else {
                                                if (_e3368 == 31u) {
                                                    phi_9581_ = 255u;
                                                    phi_9582_ = u32();
                                                    phi_9583_ = true;
                                                } else {
                                                    let _e3372 = (_e3368 + 112u);
                                                    phi_9581_ = _e3372;
                                                    phi_9582_ = _e3372;
                                                    phi_9583_ = (_e3372 == 255u);
                                                }
                                                let _e3375 = phi_9581_;
                                                let _e3377 = phi_9582_;
                                                let _e3379 = phi_9583_;
                                                if _e3379 {
                                                    phi_9592_ = (_e3369 == 0u);
                                                } else {
                                                    phi_9592_ = true;
                                                }
                                                let _e3382 = phi_9592_;
                                                phi_9604_ = bitcast<f32>((((_e3365 | (select(_e3375, select(_e3377, _e3375, _e3379), _e3382) << bitcast<u32>(23i))) | (_e3369 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3382)));
                                            }
                                            let _e3400 = phi_9604_;
                                            let _e3406 = (_e3122 + _e3218);
                                            let _e3407 = (_e3406 < _e74);
                                            if _e3407 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3409 = c.member[_e3406];
                                            let _e3410 = (_e3409 & 65535u);
                                            let _e3413 = ((_e3410 & 32768u) << bitcast<u32>(16i));
                                            let _e3416 = ((_e3410 >> bitcast<u32>(10i)) & 31u);
                                            let _e3417 = (_e3410 & 1023u);
                                            if (_e3416 == 0u) {
                                                phi_9680_ = bitcast<f32>((_e3413 | bitcast<u32>((f32(_e3417) * 0.000000059604645f))));
                                            } else {
                                                if (_e3416 == 31u) {
                                                    phi_9657_ = 255u;
                                                    phi_9658_ = u32();
                                                    phi_9659_ = true;
                                                } else {
                                                    let _e3420 = (_e3416 + 112u);
                                                    phi_9657_ = _e3420;
                                                    phi_9658_ = _e3420;
                                                    phi_9659_ = (_e3420 == 255u);
                                                }
                                                let _e3423 = phi_9657_;
                                                let _e3425 = phi_9658_;
                                                let _e3427 = phi_9659_;
                                                if _e3427 {
                                                    phi_9668_ = (_e3417 == 0u);
                                                } else {
                                                    phi_9668_ = true;
                                                }
                                                let _e3430 = phi_9668_;
                                                phi_9680_ = bitcast<f32>((((_e3413 | (select(_e3423, select(_e3425, _e3423, _e3427), _e3430) << bitcast<u32>(23i))) | (_e3417 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3430)));
                                            }
                                            let _e3448 = phi_9680_;
                                            if _e3407 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3456 = ((_e3409 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3459 = ((_e3456 & 32768u) << bitcast<u32>(16i));
                                            let _e3462 = ((_e3456 >> bitcast<u32>(10i)) & 31u);
                                            let _e3463 = (_e3456 & 1023u);
                                            if (_e3462 == 0u) {
                                                phi_9756_ = bitcast<f32>((_e3459 | bitcast<u32>((f32(_e3463) * 0.000000059604645f))));
                                            } else {
                                                if (_e3462 == 31u) {
                                                    phi_9733_ = 255u;
                                                    phi_9734_ = u32();
                                                    phi_9735_ = true;
                                                } else {
                                                    let _e3466 = (_e3462 + 112u);
                                                    phi_9733_ = _e3466;
                                                    phi_9734_ = _e3466;
                                                    phi_9735_ = (_e3466 == 255u);
                                                }
                                                let _e3469 = phi_9733_;
                                                let _e3471 = phi_9734_;
                                                let _e3473 = phi_9735_;
                                                if _e3473 {
                                                    phi_9744_ = (_e3463 == 0u);
                                                } else {
                                                    phi_9744_ = true;
                                                }
                                                let _e3476 = phi_9744_;
                                                phi_9756_ = bitcast<f32>((((_e3459 | (select(_e3469, select(_e3471, _e3469, _e3473), _e3476) << bitcast<u32>(23i))) | (_e3463 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3476)));
                                            }
                                            let _e3494 = phi_9756_;
                                            let _e3502 = ((2u * _e2768) + _e2932);
                                            let _e3503 = (_e3502 < _e74);
                                            if _e3503 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3505 = c.member[_e3502];
                                            let _e3506 = (_e3505 & 65535u);
                                            let _e3509 = ((_e3506 & 32768u) << bitcast<u32>(16i));
                                            let _e3512 = ((_e3506 >> bitcast<u32>(10i)) & 31u);
                                            let _e3513 = (_e3506 & 1023u);
                                            if (_e3512 == 0u) {
                                                phi_9832_ = bitcast<f32>((_e3509 | bitcast<u32>((f32(_e3513) * 0.000000059604645f))));
                                            } else {
                                                if (_e3512 == 31u) {
                                                    phi_9809_ = 255u;
                                                    phi_9810_ = u32();
                                                    phi_9811_ = true;
                                                } else {
                                                    let _e3516 = (_e3512 + 112u);
                                                    phi_9809_ = _e3516;
                                                    phi_9810_ = _e3516;
                                                    phi_9811_ = (_e3516 == 255u);
                                                }
                                                let _e3519 = phi_9809_;
                                                let _e3521 = phi_9810_;
                                                let _e3523 = phi_9811_;
                                                if _e3523 {
                                                    phi_9820_ = (_e3513 == 0u);
                                                } else {
                                                    phi_9820_ = true;
                                                }
                                                let _e3526 = phi_9820_;
                                                phi_9832_ = bitcast<f32>((((_e3509 | (select(_e3519, select(_e3521, _e3519, _e3523), _e3526) << bitcast<u32>(23i))) | (_e3513 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3526)));
                                            }
                                            let _e3544 = phi_9832_;
                                            if _e3503 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3552 = ((_e3505 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3555 = ((_e3552 & 32768u) << bitcast<u32>(16i));
                                            let _e3558 = ((_e3552 >> bitcast<u32>(10i)) & 31u);
                                            let _e3559 = (_e3552 & 1023u);
                                            if (_e3558 == 0u) {
                                                phi_9908_ = bitcast<f32>((_e3555 | bitcast<u32>((f32(_e3559) * 0.000000059604645f))));
                                            } else {
                                                if (_e3558 == 31u) {
                                                    phi_9885_ = 255u;
                                                    phi_9886_ = u32();
                                                    phi_9887_ = true;
                                                } else {
                                                    let _e3562 = (_e3558 + 112u);
                                                    phi_9885_ = _e3562;
                                                    phi_9886_ = _e3562;
                                                    phi_9887_ = (_e3562 == 255u);
                                                }
                                                let _e3565 = phi_9885_;
                                                let _e3567 = phi_9886_;
                                                let _e3569 = phi_9887_;
                                                if _e3569 {
                                                    phi_9896_ = (_e3559 == 0u);
                                                } else {
                                                    phi_9896_ = true;
                                                }
                                                let _e3572 = phi_9896_;
                                                phi_9908_ = bitcast<f32>((((_e3555 | (select(_e3565, select(_e3567, _e3565, _e3569), _e3572) << bitcast<u32>(23i))) | (_e3559 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3572)));
                                            }
                                            let _e3590 = phi_9908_;
                                            let _e3596 = (_e3027 + _e3502);
                                            let _e3597 = (_e3596 < _e74);
                                            if _e3597 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3599 = c.member[_e3596];
                                            let _e3600 = (_e3599 & 65535u);
                                            let _e3603 = ((_e3600 & 32768u) << bitcast<u32>(16i));
                                            let _e3606 = ((_e3600 >> bitcast<u32>(10i)) & 31u);
                                            let _e3607 = (_e3600 & 1023u);
                                            if (_e3606 == 0u) {
                                                phi_9984_ = bitcast<f32>((_e3603 | bitcast<u32>((f32(_e3607) * 0.000000059604645f))));
                                            } else {
                                                if (_e3606 == 31u) {
                                                    phi_9961_ = 255u;
                                                    phi_9962_ = u32();
                                                    phi_9963_ = true;
                                                } else {
                                                    let _e3610 = (_e3606 + 112u);
                                                    phi_9961_ = _e3610;
                                                    phi_9962_ = _e3610;
                                                    phi_9963_ = (_e3610 == 255u);
                                                }
                                                let _e3613 = phi_9961_;
                                                let _e3615 = phi_9962_;
                                                let _e3617 = phi_9963_;
                                                if _e3617 {
                                                    phi_9972_ = (_e3607 == 0u);
                                                } else {
                                                    phi_9972_ = true;
                                                }
                                                let _e3620 = phi_9972_;
                                                phi_9984_ = bitcast<f32>((((_e3603 | (select(_e3613, select(_e3615, _e3613, _e3617), _e3620) << bitcast<u32>(23i))) | (_e3607 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3620)));
                                            }
                                            let _e3638 = phi_9984_;
                                            if _e3597 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3646 = ((_e3599 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3649 = ((_e3646 & 32768u) << bitcast<u32>(16i));
                                            let _e3652 = ((_e3646 >> bitcast<u32>(10i)) & 31u);
                                            let _e3653 = (_e3646 & 1023u);
                                            if (_e3652 == 0u) {
                                                phi_10060_ = bitcast<f32>((_e3649 | bitcast<u32>((f32(_e3653) * 0.000000059604645f))));
                                            } else {
                                                if (_e3652 == 31u) {
                                                    phi_10037_ = 255u;
                                                    phi_10038_ = u32();
                                                    phi_10039_ = true;
                                                } else {
                                                    let _e3656 = (_e3652 + 112u);
                                                    phi_10037_ = _e3656;
                                                    phi_10038_ = _e3656;
                                                    phi_10039_ = (_e3656 == 255u);
                                                }
                                                let _e3659 = phi_10037_;
                                                let _e3661 = phi_10038_;
                                                let _e3663 = phi_10039_;
                                                if _e3663 {
                                                    phi_10048_ = (_e3653 == 0u);
                                                } else {
                                                    phi_10048_ = true;
                                                }
                                                let _e3666 = phi_10048_;
                                                phi_10060_ = bitcast<f32>((((_e3649 | (select(_e3659, select(_e3661, _e3659, _e3663), _e3666) << bitcast<u32>(23i))) | (_e3653 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3666)));
                                            }
                                            let _e3684 = phi_10060_;
                                            let _e3690 = (_e3122 + _e3502);
                                            let _e3691 = (_e3690 < _e74);
                                            if _e3691 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3693 = c.member[_e3690];
                                            let _e3694 = (_e3693 & 65535u);
                                            let _e3697 = ((_e3694 & 32768u) << bitcast<u32>(16i));
                                            let _e3700 = ((_e3694 >> bitcast<u32>(10i)) & 31u);
                                            let _e3701 = (_e3694 & 1023u);
                                            if (_e3700 == 0u) {
                                                phi_10136_ = bitcast<f32>((_e3697 | bitcast<u32>((f32(_e3701) * 0.000000059604645f))));
                                            } else {
                                                if (_e3700 == 31u) {
                                                    phi_10113_ = 255u;
                                                    phi_10114_ = u32();
                                                    phi_10115_ = true;
                                                } else {
                                                    let _e3704 = (_e3700 + 112u);
                                                    phi_10113_ = _e3704;
                                                    phi_10114_ = _e3704;
                                                    phi_10115_ = (_e3704 == 255u);
                                                }
                                                let _e3707 = phi_10113_;
                                                let _e3709 = phi_10114_;
                                                let _e3711 = phi_10115_;
                                                if _e3711 {
                                                    phi_10124_ = (_e3701 == 0u);
                                                } else {
                                                    phi_10124_ = true;
                                                }
                                                let _e3714 = phi_10124_;
                                                phi_10136_ = bitcast<f32>((((_e3697 | (select(_e3707, select(_e3709, _e3707, _e3711), _e3714) << bitcast<u32>(23i))) | (_e3701 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3714)));
                                            }
                                            let _e3732 = phi_10136_;
                                            if _e3691 {
                                            } else {
                                                phi_17122_ = true;
                                                break;
                                            }
                                            let _e3740 = ((_e3693 >> bitcast<u32>(16u)) & 65535u);
                                            let _e3743 = ((_e3740 & 32768u) << bitcast<u32>(16i));
                                            let _e3746 = ((_e3740 >> bitcast<u32>(10i)) & 31u);
                                            let _e3747 = (_e3740 & 1023u);
                                            if (_e3746 == 0u) {
                                                phi_10212_ = bitcast<f32>((_e3743 | bitcast<u32>((f32(_e3747) * 0.000000059604645f))));
                                            } else {
                                                if (_e3746 == 31u) {
                                                    phi_10189_ = 255u;
                                                    phi_10190_ = u32();
                                                    phi_10191_ = true;
                                                } else {
                                                    let _e3750 = (_e3746 + 112u);
                                                    phi_10189_ = _e3750;
                                                    phi_10190_ = _e3750;
                                                    phi_10191_ = (_e3750 == 255u);
                                                }
                                                let _e3753 = phi_10189_;
                                                let _e3755 = phi_10190_;
                                                let _e3757 = phi_10191_;
                                                if _e3757 {
                                                    phi_10200_ = (_e3747 == 0u);
                                                } else {
                                                    phi_10200_ = true;
                                                }
                                                let _e3760 = phi_10200_;
                                                phi_10212_ = bitcast<f32>((((_e3743 | (select(_e3753, select(_e3755, _e3753, _e3757), _e3760) << bitcast<u32>(23i))) | (_e3747 << bitcast<u32>(13i))) | select(4194304u, 0u, _e3760)));
                                            }
                                            let _e3778 = phi_10212_;
                                            phi_10218_ = (_e2868 + _e2923);
                                            phi_10219_ = array<array<f32, 6>, 3>(array<f32, 6>((_e2870[0][0] + ((_e2975 * _e96) * _e2923)), (_e2870[0][1] + ((_e3021 * _e96) * _e2923)), (_e2870[0][2] + ((_e3070 * _e96) * _e2923)), (_e2870[0][3] + ((_e3116 * _e96) * _e2923)), (_e2870[0][4] + ((_e3165 * _e96) * _e2923)), (_e2870[0][5] + ((_e3211 * _e96) * _e2923))), array<f32, 6>((_e2870[1][0] + ((_e3260 * _e96) * _e2923)), (_e2870[1][1] + ((_e3306 * _e96) * _e2923)), (_e2870[1][2] + ((_e3354 * _e96) * _e2923)), (_e2870[1][3] + ((_e3400 * _e96) * _e2923)), (_e2870[1][4] + ((_e3448 * _e96) * _e2923)), (_e2870[1][5] + ((_e3494 * _e96) * _e2923))), array<f32, 6>((_e2870[2][0] + ((_e3544 * _e96) * _e2923)), (_e2870[2][1] + ((_e3590 * _e96) * _e2923)), (_e2870[2][2] + ((_e3638 * _e96) * _e2923)), (_e2870[2][3] + ((_e3684 * _e96) * _e2923)), (_e2870[2][4] + ((_e3732 * _e96) * _e2923)), (_e2870[2][5] + ((_e3778 * _e96) * _e2923))));
                                        } else {
                                            phi_10218_ = _e2868;
                                            phi_10219_ = _e2870;
                                        }
                                        let _e3787 = phi_10218_;
                                        let _e3789 = phi_10219_;
                                        phi_8741_ = _e3787;
                                        phi_8743_ = _e3789;
                                    } else {
                                        phi_8741_ = f32();
                                        phi_8743_ = array<array<f32, 6>, 3>();
                                    }
                                    let _e3791 = phi_8741_;
                                    let _e3793 = phi_8743_;
                                    continue;
                                    continuing {
                                        phi_8737_ = _e2883;
                                        phi_8740_ = _e3791;
                                        phi_8742_ = _e3793;
                                        phi_17122_ = _e2673;
                                        break if !(_e2889);
                                    }
                                }
                                let _e3796 = phi_17122_;
                                if _e3796 {
                                    break;
                                }
                                let _e3798 = local_40;
                                if (_e3798 > 0f) {
                                    let _e3801 = local_41;
                                    phi_10225_ = (1f / _e3801);
                                } else {
                                    phi_10225_ = 0f;
                                }
                                let _e3804 = phi_10225_;
                                let _e3806 = local_42;
                                let _e3811 = local_43;
                                let _e3816 = local_44;
                                let _e3821 = local_45;
                                let _e3826 = local_46;
                                let _e3831 = local_47;
                                let _e3836 = local_48;
                                let _e3841 = local_49;
                                let _e3846 = local_50;
                                let _e3851 = local_51;
                                let _e3856 = local_52;
                                let _e3861 = local_53;
                                let _e3866 = local_54;
                                let _e3871 = local_55;
                                let _e3876 = local_56;
                                let _e3881 = local_57;
                                let _e3886 = local_58;
                                let _e3891 = local_59;
                                let _e3896 = ((0.6666667f / _e2686.w) / _e2686.w);
                                let _e3897 = -(_e90.member_2[0]);
                                let _e3898 = -(_e90.member_2[1]);
                                let _e3901 = (_e90.member_2[2] * -1.0233268f);
                                let _e3907 = ((((_e90.member_2[2] * -1.9364917f) * (_e90.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                                let _e3910 = (_e90.member_2[0] * -1.0233268f);
                                let _e3913 = (_e90.member_2[1] * -1.0233268f);
                                let _e3919 = (((_e3897 * _e3897) - (_e3898 * _e3898)) * 0.4290428f);
                                let _e3921 = (((((((_e3806[0][0] * _e3804) * 0.886227f) + ((_e3816[0][2] * _e3804) * _e3901)) + ((_e3826[0][4] * _e3804) * _e3907)) + ((_e3821[0][3] * _e3804) * _e3910)) + ((_e3811[0][1] * _e3804) * _e3913)) + ((_e3831[0][5] * _e3804) * _e3919));
                                let _e3934 = (((((((_e3836[1][0] * _e3804) * 0.886227f) + ((_e3846[1][2] * _e3804) * _e3901)) + ((_e3856[1][4] * _e3804) * _e3907)) + ((_e3851[1][3] * _e3804) * _e3910)) + ((_e3841[1][1] * _e3804) * _e3913)) + ((_e3861[1][5] * _e3804) * _e3919));
                                let _e3947 = (((((((_e3866[2][0] * _e3804) * 0.886227f) + ((_e3876[2][2] * _e3804) * _e3901)) + ((_e3886[2][4] * _e3804) * _e3907)) + ((_e3881[2][3] * _e3804) * _e3910)) + ((_e3871[2][1] * _e3804) * _e3913)) + ((_e3891[2][5] * _e3804) * _e3919));
                                phi_17489_ = _e3796;
                                phi_12513_ = vec4<f32>((_e2679.x + ((select(0f, _e3921, (_e3921 > 0f)) * _e3896) * _e2754)), (_e2679.y + ((select(0f, _e3934, (_e3934 > 0f)) * _e3896) * _e2754)), (_e2679.z + ((select(0f, _e3947, (_e3947 > 0f)) * _e3896) * _e2754)), (_e2679.w - _e2754));
                            }
                            let _e3962 = phi_17489_;
                            let _e3964 = phi_12513_;
                            phi_17488_ = _e3962;
                            phi_12514_ = _e3964;
                        }
                        let _e3966 = phi_17488_;
                        let _e3968 = phi_12514_;
                        phi_17487_ = _e3966;
                        phi_12515_ = _e3968;
                        phi_12516_ = _e2682;
                    }
                    let _e3970 = phi_17487_;
                    let _e3972 = phi_12515_;
                    let _e3974 = phi_12516_;
                    let _e3976 = select(_e3972, _e2679, vec4(_e3974));
                    if (3u >= _e99) {
                        phi_16635_ = vec4<f32>();
                        phi_16636_ = true;
                    } else {
                        let _e3979 = (_e3976.w <= 0f);
                        if _e3979 {
                            phi_16634_ = vec4<f32>();
                        } else {
                            let _e3983 = params.member.member[3u];
                            let _e3987 = params.member.member_1[3u];
                            let _e3991 = params.member.member_2[3u];
                            if (4u == _e99) {
                                phi_12576_ = 0f;
                            } else {
                                let _e4003 = params.member.member_5;
                                phi_12576_ = _e4003;
                            }
                            let _e4005 = phi_12576_;
                            let _e4013 = ((_e90.member[0] - _e3983.x) / _e3983.w);
                            let _e4014 = ((_e90.member[1] - _e3983.y) / _e3983.w);
                            let _e4015 = ((_e90.member[2] - _e3983.z) / _e3983.w);
                            let _e4022 = (_e4013 - f32(_e3987.x));
                            let _e4023 = (_e4014 - f32(_e3987.y));
                            let _e4024 = (_e4015 - f32(_e3987.z));
                            let _e4032 = select(_e4024, _e4023, (_e4023 < _e4024));
                            let _e4034 = select(_e4032, _e4022, (_e4022 < _e4032));
                            let _e4035 = (f32(_e3991.x) - _e4022);
                            let _e4036 = (f32(_e3991.y) - _e4023);
                            let _e4037 = (f32(_e3991.z) - _e4024);
                            let _e4039 = select(_e4037, _e4036, (_e4036 < _e4037));
                            let _e4041 = select(_e4039, _e4035, (_e4035 < _e4039));
                            let _e4046 = (select(_e4041, _e4034, (_e4034 < _e4041)) / select(0.001f, _e4005, (_e4005 > 0.001f)));
                            let _e4048 = select(0f, _e4046, (_e4046 > 0f));
                            let _e4051 = (_e3976.w * select(1f, _e4048, (_e4048 < 1f)));
                            if (_e4051 <= 0f) {
                                phi_16633_ = _e3976;
                            } else {
                                let _e4058 = params.member.member_6;
                                let _e4059 = (_e3991.x + 1u);
                                let _e4061 = ((_e3991.y + 1u) * _e4059);
                                let _e4062 = (_e4061 + _e4059);
                                let _e4065 = (_e4062 + ((_e3991.z + 1u) * _e4061));
                                let _e4072 = ((_e4013 + (_e90.member_2[0] * _e4058)) - 0.5f);
                                let _e4073 = floor(_e4072);
                                let _e4075 = (bitcast<i32>(_e3991.x) - 1i);
                                let _e4083 = (select(0i, select(select(i32(_e4073), i32(-2147483648), (_e4073 < -2147483600f)), 2147483647i, (_e4073 > 2147483500f)), (_e4073 == _e4073)) - _e3987.x);
                                let _e4085 = select(0i, _e4083, (0i < _e4083));
                                let _e4087 = select(_e4085, _e4075, (_e4075 < _e4085));
                                let _e4088 = (_e4083 + 1i);
                                let _e4090 = select(0i, _e4088, (0i < _e4088));
                                let _e4092 = select(_e4090, _e4075, (_e4075 < _e4090));
                                let _e4095 = (_e4072 - _e4073);
                                let _e4102 = ((_e4014 + (_e90.member_2[1] * _e4058)) - 0.5f);
                                let _e4103 = floor(_e4102);
                                let _e4105 = (bitcast<i32>(_e3991.y) - 1i);
                                let _e4113 = (select(0i, select(select(i32(_e4103), i32(-2147483648), (_e4103 < -2147483600f)), 2147483647i, (_e4103 > 2147483500f)), (_e4103 == _e4103)) - _e3987.y);
                                let _e4115 = select(0i, _e4113, (0i < _e4113));
                                let _e4117 = select(_e4115, _e4105, (_e4105 < _e4115));
                                let _e4118 = (_e4113 + 1i);
                                let _e4120 = select(0i, _e4118, (0i < _e4118));
                                let _e4122 = select(_e4120, _e4105, (_e4105 < _e4120));
                                let _e4125 = (_e4102 - _e4103);
                                let _e4132 = ((_e4015 + (_e90.member_2[2] * _e4058)) - 0.5f);
                                let _e4133 = floor(_e4132);
                                let _e4135 = (bitcast<i32>(_e3991.z) - 1i);
                                let _e4143 = (select(0i, select(select(i32(_e4133), i32(-2147483648), (_e4133 < -2147483600f)), 2147483647i, (_e4133 > 2147483500f)), (_e4133 == _e4133)) - _e3987.z);
                                let _e4145 = select(0i, _e4143, (0i < _e4143));
                                let _e4147 = select(_e4145, _e4135, (_e4135 < _e4145));
                                let _e4148 = (_e4143 + 1i);
                                let _e4150 = select(0i, _e4148, (0i < _e4148));
                                let _e4152 = select(_e4150, _e4135, (_e4135 < _e4150));
                                let _e4155 = (_e4132 - _e4133);
                                phi_12857_ = type_12(0u, 8u);
                                phi_12860_ = 0f;
                                phi_12862_ = array<array<f32, 6>, 3>(array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f), array<f32, 6>(0f, 0f, 0f, 0f, 0f, 0f));
                                loop {
                                    let _e4163 = phi_12857_;
                                    let _e4165 = phi_12860_;
                                    let _e4167 = phi_12862_;
                                    local_60 = _e4165;
                                    local_61 = _e4165;
                                    local_62 = _e4167;
                                    local_63 = _e4167;
                                    local_64 = _e4167;
                                    local_65 = _e4167;
                                    local_66 = _e4167;
                                    local_67 = _e4167;
                                    local_68 = _e4167;
                                    local_69 = _e4167;
                                    local_70 = _e4167;
                                    local_71 = _e4167;
                                    local_72 = _e4167;
                                    local_73 = _e4167;
                                    local_74 = _e4167;
                                    local_75 = _e4167;
                                    local_76 = _e4167;
                                    local_77 = _e4167;
                                    local_78 = _e4167;
                                    local_79 = _e4167;
                                    if (_e4163.member < _e4163.member_1) {
                                        phi_12858_ = type_12((_e4163.member + 1u), _e4163.member_1);
                                        phi_12885_ = type_12(1u, _e4163.member);
                                    } else {
                                        phi_12858_ = _e4163;
                                        phi_12885_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e4180 = phi_12858_;
                                    let _e4182 = phi_12885_;
                                    let _e4186 = (bitcast<i32>(_e4182.member) != 0i);
                                    if _e4186 {
                                        let _e4188 = ((_e4182.member_1 & 1u) == 1u);
                                        let _e4190 = ((_e4182.member_1 & 2u) == 2u);
                                        let _e4192 = ((_e4182.member_1 & 4u) == 4u);
                                        if _e4188 {
                                            phi_12915_ = _e4095;
                                        } else {
                                            phi_12915_ = (1f - _e4095);
                                        }
                                        let _e4198 = phi_12915_;
                                        if _e4190 {
                                            phi_12920_ = _e4125;
                                        } else {
                                            phi_12920_ = (1f - _e4125);
                                        }
                                        let _e4201 = phi_12920_;
                                        if _e4192 {
                                            phi_12926_ = _e4155;
                                        } else {
                                            phi_12926_ = (1f - _e4155);
                                        }
                                        let _e4205 = phi_12926_;
                                        let _e4215 = (((((select((f32((_e4087 + _e3987.x)) + 0.5f), (f32((_e4092 + _e3987.x)) + 0.5f), _e4188) - _e4013) * _e90.member_2[0]) + ((select((f32((_e4117 + _e3987.y)) + 0.5f), (f32((_e4122 + _e3987.y)) + 0.5f), _e4190) - _e4014) * _e90.member_2[1])) + ((select((f32((_e4147 + _e3987.z)) + 0.5f), (f32((_e4152 + _e3987.z)) + 0.5f), _e4192) - _e4015) * _e90.member_2[2])) * 2f);
                                        let _e4217 = select(0f, _e4215, (_e4215 > 0f));
                                        let _e4220 = (((_e4198 * _e4201) * _e4205) * select(1f, _e4217, (_e4217 < 1f)));
                                        if (_e4220 > 0f) {
                                            let _e4229 = (((_e4062 + select(bitcast<u32>(_e4087), bitcast<u32>(_e4092), _e4188)) + (select(bitcast<u32>(_e4117), bitcast<u32>(_e4122), _e4190) * _e4059)) + (select(bitcast<u32>(_e4147), bitcast<u32>(_e4152), _e4192) * _e4061));
                                            let _e4231 = (_e4229 < _e77);
                                            if _e4231 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4233 = d.member[_e4229];
                                            let _e4234 = (_e4233 & 65535u);
                                            let _e4237 = ((_e4234 & 32768u) << bitcast<u32>(16i));
                                            let _e4240 = ((_e4234 >> bitcast<u32>(10i)) & 31u);
                                            let _e4241 = (_e4234 & 1023u);
                                            if (_e4240 == 0u) {
                                                phi_13040_ = bitcast<f32>((_e4237 | bitcast<u32>((f32(_e4241) * 0.000000059604645f))));
                                            } else {
                                                if (_e4240 == 31u) {
                                                    phi_13017_ = 255u;
                                                    phi_13018_ = u32();
                                                    phi_13019_ = true;
                                                } else {
                                                    let _e4244 = (_e4240 + 112u);
                                                    phi_13017_ = _e4244;
                                                    phi_13018_ = _e4244;
                                                    phi_13019_ = (_e4244 == 255u);
                                                }
                                                let _e4247 = phi_13017_;
                                                let _e4249 = phi_13018_;
                                                let _e4251 = phi_13019_;
                                                if _e4251 {
                                                    phi_13028_ = (_e4241 == 0u);
                                                } else {
                                                    phi_13028_ = true;
                                                }
                                                let _e4254 = phi_13028_;
                                                phi_13040_ = bitcast<f32>((((_e4237 | (select(_e4247, select(_e4249, _e4247, _e4251), _e4254) << bitcast<u32>(23i))) | (_e4241 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4254)));
                                            }
                                            let _e4272 = phi_13040_;
                                            if _e4231 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4280 = ((_e4233 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4283 = ((_e4280 & 32768u) << bitcast<u32>(16i));
                                            let _e4286 = ((_e4280 >> bitcast<u32>(10i)) & 31u);
                                            let _e4287 = (_e4280 & 1023u);
                                            if (_e4286 == 0u) {
                                                phi_13116_ = bitcast<f32>((_e4283 | bitcast<u32>((f32(_e4287) * 0.000000059604645f))));
                                            } else {
                                                if (_e4286 == 31u) {
                                                    phi_13093_ = 255u;
                                                    phi_13094_ = u32();
                                                    phi_13095_ = true;
                                                } else {
                                                    let _e4290 = (_e4286 + 112u);
                                                    phi_13093_ = _e4290;
                                                    phi_13094_ = _e4290;
                                                    phi_13095_ = (_e4290 == 255u);
                                                }
                                                let _e4293 = phi_13093_;
                                                let _e4295 = phi_13094_;
                                                let _e4297 = phi_13095_;
                                                if _e4297 {
                                                    phi_13104_ = (_e4287 == 0u);
                                                } else {
                                                    phi_13104_ = true;
                                                }
                                                let _e4300 = phi_13104_;
                                                phi_13116_ = bitcast<f32>((((_e4283 | (select(_e4293, select(_e4295, _e4293, _e4297), _e4300) << bitcast<u32>(23i))) | (_e4287 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4300)));
                                            }
                                            let _e4318 = phi_13116_;
                                            let _e4324 = (3u * _e4065);
                                            let _e4325 = (_e4324 + _e4229);
                                            let _e4326 = (_e4325 < _e77);
                                            if _e4326 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4328 = d.member[_e4325];
                                            let _e4329 = (_e4328 & 65535u);
                                            let _e4332 = ((_e4329 & 32768u) << bitcast<u32>(16i));
                                            let _e4335 = ((_e4329 >> bitcast<u32>(10i)) & 31u);
                                            let _e4336 = (_e4329 & 1023u);
                                            if (_e4335 == 0u) {
                                                phi_13192_ = bitcast<f32>((_e4332 | bitcast<u32>((f32(_e4336) * 0.000000059604645f))));
                                            } else {
                                                if (_e4335 == 31u) {
                                                    phi_13169_ = 255u;
                                                    phi_13170_ = u32();
                                                    phi_13171_ = true;
                                                } else {
                                                    let _e4339 = (_e4335 + 112u);
                                                    phi_13169_ = _e4339;
                                                    phi_13170_ = _e4339;
                                                    phi_13171_ = (_e4339 == 255u);
                                                }
                                                let _e4342 = phi_13169_;
                                                let _e4344 = phi_13170_;
                                                let _e4346 = phi_13171_;
                                                if _e4346 {
                                                    phi_13180_ = (_e4336 == 0u);
                                                } else {
                                                    phi_13180_ = true;
                                                }
                                                let _e4349 = phi_13180_;
                                                phi_13192_ = bitcast<f32>((((_e4332 | (select(_e4342, select(_e4344, _e4342, _e4346), _e4349) << bitcast<u32>(23i))) | (_e4336 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4349)));
                                            }
                                            let _e4367 = phi_13192_;
                                            if _e4326 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4375 = ((_e4328 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4378 = ((_e4375 & 32768u) << bitcast<u32>(16i));
                                            let _e4381 = ((_e4375 >> bitcast<u32>(10i)) & 31u);
                                            let _e4382 = (_e4375 & 1023u);
                                            if (_e4381 == 0u) {
                                                phi_13268_ = bitcast<f32>((_e4378 | bitcast<u32>((f32(_e4382) * 0.000000059604645f))));
                                            } else {
                                                if (_e4381 == 31u) {
                                                    phi_13245_ = 255u;
                                                    phi_13246_ = u32();
                                                    phi_13247_ = true;
                                                } else {
                                                    let _e4385 = (_e4381 + 112u);
                                                    phi_13245_ = _e4385;
                                                    phi_13246_ = _e4385;
                                                    phi_13247_ = (_e4385 == 255u);
                                                }
                                                let _e4388 = phi_13245_;
                                                let _e4390 = phi_13246_;
                                                let _e4392 = phi_13247_;
                                                if _e4392 {
                                                    phi_13256_ = (_e4382 == 0u);
                                                } else {
                                                    phi_13256_ = true;
                                                }
                                                let _e4395 = phi_13256_;
                                                phi_13268_ = bitcast<f32>((((_e4378 | (select(_e4388, select(_e4390, _e4388, _e4392), _e4395) << bitcast<u32>(23i))) | (_e4382 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4395)));
                                            }
                                            let _e4413 = phi_13268_;
                                            let _e4419 = (_e4065 * 6u);
                                            let _e4420 = (_e4419 + _e4229);
                                            let _e4421 = (_e4420 < _e77);
                                            if _e4421 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4423 = d.member[_e4420];
                                            let _e4424 = (_e4423 & 65535u);
                                            let _e4427 = ((_e4424 & 32768u) << bitcast<u32>(16i));
                                            let _e4430 = ((_e4424 >> bitcast<u32>(10i)) & 31u);
                                            let _e4431 = (_e4424 & 1023u);
                                            if (_e4430 == 0u) {
                                                phi_13344_ = bitcast<f32>((_e4427 | bitcast<u32>((f32(_e4431) * 0.000000059604645f))));
                                            } else {
                                                if (_e4430 == 31u) {
                                                    phi_13321_ = 255u;
                                                    phi_13322_ = u32();
                                                    phi_13323_ = true;
                                                } else {
                                                    let _e4434 = (_e4430 + 112u);
                                                    phi_13321_ = _e4434;
                                                    phi_13322_ = _e4434;
                                                    phi_13323_ = (_e4434 == 255u);
                                                }
                                                let _e4437 = phi_13321_;
                                                let _e4439 = phi_13322_;
                                                let _e4441 = phi_13323_;
                                                if _e4441 {
                                                    phi_13332_ = (_e4431 == 0u);
                                                } else {
                                                    phi_13332_ = true;
                                                }
                                                let _e4444 = phi_13332_;
                                                phi_13344_ = bitcast<f32>((((_e4427 | (select(_e4437, select(_e4439, _e4437, _e4441), _e4444) << bitcast<u32>(23i))) | (_e4431 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4444)));
                                            }
                                            let _e4462 = phi_13344_;
                                            if _e4421 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4470 = ((_e4423 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4473 = ((_e4470 & 32768u) << bitcast<u32>(16i));
                                            let _e4476 = ((_e4470 >> bitcast<u32>(10i)) & 31u);
                                            let _e4477 = (_e4470 & 1023u);
                                            if (_e4476 == 0u) {
                                                phi_13420_ = bitcast<f32>((_e4473 | bitcast<u32>((f32(_e4477) * 0.000000059604645f))));
                                            } else {
                                                if (_e4476 == 31u) {
                                                    phi_13397_ = 255u;
                                                    phi_13398_ = u32();
                                                    phi_13399_ = true;
                                                } else {
                                                    let _e4480 = (_e4476 + 112u);
                                                    phi_13397_ = _e4480;
                                                    phi_13398_ = _e4480;
                                                    phi_13399_ = (_e4480 == 255u);
                                                }
                                                let _e4483 = phi_13397_;
                                                let _e4485 = phi_13398_;
                                                let _e4487 = phi_13399_;
                                                if _e4487 {
                                                    phi_13408_ = (_e4477 == 0u);
                                                } else {
                                                    phi_13408_ = true;
                                                }
                                                let _e4490 = phi_13408_;
                                                phi_13420_ = bitcast<f32>((((_e4473 | (select(_e4483, select(_e4485, _e4483, _e4487), _e4490) << bitcast<u32>(23i))) | (_e4477 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4490)));
                                            }
                                            let _e4508 = phi_13420_;
                                            let _e4515 = (_e4065 + _e4229);
                                            let _e4516 = (_e4515 < _e77);
                                            if _e4516 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4518 = d.member[_e4515];
                                            let _e4519 = (_e4518 & 65535u);
                                            let _e4522 = ((_e4519 & 32768u) << bitcast<u32>(16i));
                                            let _e4525 = ((_e4519 >> bitcast<u32>(10i)) & 31u);
                                            let _e4526 = (_e4519 & 1023u);
                                            if (_e4525 == 0u) {
                                                phi_13496_ = bitcast<f32>((_e4522 | bitcast<u32>((f32(_e4526) * 0.000000059604645f))));
                                            } else {
                                                if (_e4525 == 31u) {
                                                    phi_13473_ = 255u;
                                                    phi_13474_ = u32();
                                                    phi_13475_ = true;
                                                } else {
                                                    let _e4529 = (_e4525 + 112u);
                                                    phi_13473_ = _e4529;
                                                    phi_13474_ = _e4529;
                                                    phi_13475_ = (_e4529 == 255u);
                                                }
                                                let _e4532 = phi_13473_;
                                                let _e4534 = phi_13474_;
                                                let _e4536 = phi_13475_;
                                                if _e4536 {
                                                    phi_13484_ = (_e4526 == 0u);
                                                } else {
                                                    phi_13484_ = true;
                                                }
                                                let _e4539 = phi_13484_;
                                                phi_13496_ = bitcast<f32>((((_e4522 | (select(_e4532, select(_e4534, _e4532, _e4536), _e4539) << bitcast<u32>(23i))) | (_e4526 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4539)));
                                            }
                                            let _e4557 = phi_13496_;
                                            if _e4516 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4565 = ((_e4518 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4568 = ((_e4565 & 32768u) << bitcast<u32>(16i));
                                            let _e4571 = ((_e4565 >> bitcast<u32>(10i)) & 31u);
                                            let _e4572 = (_e4565 & 1023u);
                                            if (_e4571 == 0u) {
                                                phi_13572_ = bitcast<f32>((_e4568 | bitcast<u32>((f32(_e4572) * 0.000000059604645f))));
                                            } else {
                                                if (_e4571 == 31u) {
                                                    phi_13549_ = 255u;
                                                    phi_13550_ = u32();
                                                    phi_13551_ = true;
                                                } else {
                                                    let _e4575 = (_e4571 + 112u);
                                                    phi_13549_ = _e4575;
                                                    phi_13550_ = _e4575;
                                                    phi_13551_ = (_e4575 == 255u);
                                                }
                                                let _e4578 = phi_13549_;
                                                let _e4580 = phi_13550_;
                                                let _e4582 = phi_13551_;
                                                if _e4582 {
                                                    phi_13560_ = (_e4572 == 0u);
                                                } else {
                                                    phi_13560_ = true;
                                                }
                                                let _e4585 = phi_13560_;
                                                phi_13572_ = bitcast<f32>((((_e4568 | (select(_e4578, select(_e4580, _e4578, _e4582), _e4585) << bitcast<u32>(23i))) | (_e4572 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4585)));
                                            }
                                            let _e4603 = phi_13572_;
                                            let _e4609 = (_e4324 + _e4515);
                                            let _e4610 = (_e4609 < _e77);
                                            if _e4610 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4612 = d.member[_e4609];
                                            let _e4613 = (_e4612 & 65535u);
                                            let _e4616 = ((_e4613 & 32768u) << bitcast<u32>(16i));
                                            let _e4619 = ((_e4613 >> bitcast<u32>(10i)) & 31u);
                                            let _e4620 = (_e4613 & 1023u);
                                            if (_e4619 == 0u) {
                                                phi_13648_ = bitcast<f32>((_e4616 | bitcast<u32>((f32(_e4620) * 0.000000059604645f))));
                                            } else {
                                                if (_e4619 == 31u) {
                                                    phi_13625_ = 255u;
                                                    phi_13626_ = u32();
                                                    phi_13627_ = true;
                                                } else {
                                                    let _e4623 = (_e4619 + 112u);
                                                    phi_13625_ = _e4623;
                                                    phi_13626_ = _e4623;
                                                    phi_13627_ = (_e4623 == 255u);
                                                }
                                                let _e4626 = phi_13625_;
                                                let _e4628 = phi_13626_;
                                                let _e4630 = phi_13627_;
                                                if _e4630 {
                                                    phi_13636_ = (_e4620 == 0u);
                                                } else {
                                                    phi_13636_ = true;
                                                }
                                                let _e4633 = phi_13636_;
                                                phi_13648_ = bitcast<f32>((((_e4616 | (select(_e4626, select(_e4628, _e4626, _e4630), _e4633) << bitcast<u32>(23i))) | (_e4620 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4633)));
                                            }
                                            let _e4651 = phi_13648_;
                                            if _e4610 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4659 = ((_e4612 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4662 = ((_e4659 & 32768u) << bitcast<u32>(16i));
                                            let _e4665 = ((_e4659 >> bitcast<u32>(10i)) & 31u);
                                            let _e4666 = (_e4659 & 1023u);
                                            if (_e4665 == 0u) {
                                                phi_13724_ = bitcast<f32>((_e4662 | bitcast<u32>((f32(_e4666) * 0.000000059604645f))));
                                            } else {
                                                if (_e4665 == 31u) {
                                                    phi_13701_ = 255u;
                                                    phi_13702_ = u32();
                                                    phi_13703_ = true;
                                                } else {
                                                    let _e4669 = (_e4665 + 112u);
                                                    phi_13701_ = _e4669;
                                                    phi_13702_ = _e4669;
                                                    phi_13703_ = (_e4669 == 255u);
                                                }
                                                let _e4672 = phi_13701_;
                                                let _e4674 = phi_13702_;
                                                let _e4676 = phi_13703_;
                                                if _e4676 {
                                                    phi_13712_ = (_e4666 == 0u);
                                                } else {
                                                    phi_13712_ = true;
                                                }
                                                let _e4679 = phi_13712_;
                                                phi_13724_ = bitcast<f32>((((_e4662 | (select(_e4672, select(_e4674, _e4672, _e4676), _e4679) << bitcast<u32>(23i))) | (_e4666 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4679)));
                                            }
                                            let _e4697 = phi_13724_;
                                            let _e4703 = (_e4419 + _e4515);
                                            let _e4704 = (_e4703 < _e77);
                                            if _e4704 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4706 = d.member[_e4703];
                                            let _e4707 = (_e4706 & 65535u);
                                            let _e4710 = ((_e4707 & 32768u) << bitcast<u32>(16i));
                                            let _e4713 = ((_e4707 >> bitcast<u32>(10i)) & 31u);
                                            let _e4714 = (_e4707 & 1023u);
                                            if (_e4713 == 0u) {
                                                phi_13800_ = bitcast<f32>((_e4710 | bitcast<u32>((f32(_e4714) * 0.000000059604645f))));
                                            } else {
                                                if (_e4713 == 31u) {
                                                    phi_13777_ = 255u;
                                                    phi_13778_ = u32();
                                                    phi_13779_ = true;
                                                } else {
                                                    let _e4717 = (_e4713 + 112u);
                                                    phi_13777_ = _e4717;
                                                    phi_13778_ = _e4717;
                                                    phi_13779_ = (_e4717 == 255u);
                                                }
                                                let _e4720 = phi_13777_;
                                                let _e4722 = phi_13778_;
                                                let _e4724 = phi_13779_;
                                                if _e4724 {
                                                    phi_13788_ = (_e4714 == 0u);
                                                } else {
                                                    phi_13788_ = true;
                                                }
                                                let _e4727 = phi_13788_;
                                                phi_13800_ = bitcast<f32>((((_e4710 | (select(_e4720, select(_e4722, _e4720, _e4724), _e4727) << bitcast<u32>(23i))) | (_e4714 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4727)));
                                            }
                                            let _e4745 = phi_13800_;
                                            if _e4704 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4753 = ((_e4706 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4756 = ((_e4753 & 32768u) << bitcast<u32>(16i));
                                            let _e4759 = ((_e4753 >> bitcast<u32>(10i)) & 31u);
                                            let _e4760 = (_e4753 & 1023u);
                                            if (_e4759 == 0u) {
                                                phi_13876_ = bitcast<f32>((_e4756 | bitcast<u32>((f32(_e4760) * 0.000000059604645f))));
                                            } else {
                                                if (_e4759 == 31u) {
                                                    phi_13853_ = 255u;
                                                    phi_13854_ = u32();
                                                    phi_13855_ = true;
                                                } else {
                                                    let _e4763 = (_e4759 + 112u);
                                                    phi_13853_ = _e4763;
                                                    phi_13854_ = _e4763;
                                                    phi_13855_ = (_e4763 == 255u);
                                                }
                                                let _e4766 = phi_13853_;
                                                let _e4768 = phi_13854_;
                                                let _e4770 = phi_13855_;
                                                if _e4770 {
                                                    phi_13864_ = (_e4760 == 0u);
                                                } else {
                                                    phi_13864_ = true;
                                                }
                                                let _e4773 = phi_13864_;
                                                phi_13876_ = bitcast<f32>((((_e4756 | (select(_e4766, select(_e4768, _e4766, _e4770), _e4773) << bitcast<u32>(23i))) | (_e4760 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4773)));
                                            }
                                            let _e4791 = phi_13876_;
                                            let _e4799 = ((2u * _e4065) + _e4229);
                                            let _e4800 = (_e4799 < _e77);
                                            if _e4800 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4802 = d.member[_e4799];
                                            let _e4803 = (_e4802 & 65535u);
                                            let _e4806 = ((_e4803 & 32768u) << bitcast<u32>(16i));
                                            let _e4809 = ((_e4803 >> bitcast<u32>(10i)) & 31u);
                                            let _e4810 = (_e4803 & 1023u);
                                            if (_e4809 == 0u) {
                                                phi_13952_ = bitcast<f32>((_e4806 | bitcast<u32>((f32(_e4810) * 0.000000059604645f))));
                                            } else {
                                                if (_e4809 == 31u) {
                                                    phi_13929_ = 255u;
                                                    phi_13930_ = u32();
                                                    phi_13931_ = true;
                                                } else {
                                                    let _e4813 = (_e4809 + 112u);
                                                    phi_13929_ = _e4813;
                                                    phi_13930_ = _e4813;
                                                    phi_13931_ = (_e4813 == 255u);
                                                }
                                                let _e4816 = phi_13929_;
                                                let _e4818 = phi_13930_;
                                                let _e4820 = phi_13931_;
                                                if _e4820 {
                                                    phi_13940_ = (_e4810 == 0u);
                                                } else {
                                                    phi_13940_ = true;
                                                }
                                                let _e4823 = phi_13940_;
                                                phi_13952_ = bitcast<f32>((((_e4806 | (select(_e4816, select(_e4818, _e4816, _e4820), _e4823) << bitcast<u32>(23i))) | (_e4810 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4823)));
                                            }
                                            let _e4841 = phi_13952_;
                                            if _e4800 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4849 = ((_e4802 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4852 = ((_e4849 & 32768u) << bitcast<u32>(16i));
                                            let _e4855 = ((_e4849 >> bitcast<u32>(10i)) & 31u);
                                            let _e4856 = (_e4849 & 1023u);
                                            if (_e4855 == 0u) {
                                                phi_14028_ = bitcast<f32>((_e4852 | bitcast<u32>((f32(_e4856) * 0.000000059604645f))));
                                            } else {
                                                if (_e4855 == 31u) {
                                                    phi_14005_ = 255u;
                                                    phi_14006_ = u32();
                                                    phi_14007_ = true;
                                                } else {
                                                    let _e4859 = (_e4855 + 112u);
                                                    phi_14005_ = _e4859;
                                                    phi_14006_ = _e4859;
                                                    phi_14007_ = (_e4859 == 255u);
                                                }
                                                let _e4862 = phi_14005_;
                                                let _e4864 = phi_14006_;
                                                let _e4866 = phi_14007_;
                                                if _e4866 {
                                                    phi_14016_ = (_e4856 == 0u);
                                                } else {
                                                    phi_14016_ = true;
                                                }
                                                let _e4869 = phi_14016_;
                                                phi_14028_ = bitcast<f32>((((_e4852 | (select(_e4862, select(_e4864, _e4862, _e4866), _e4869) << bitcast<u32>(23i))) | (_e4856 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4869)));
                                            }
                                            let _e4887 = phi_14028_;
                                            let _e4893 = (_e4324 + _e4799);
                                            let _e4894 = (_e4893 < _e77);
                                            if _e4894 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4896 = d.member[_e4893];
                                            let _e4897 = (_e4896 & 65535u);
                                            let _e4900 = ((_e4897 & 32768u) << bitcast<u32>(16i));
                                            let _e4903 = ((_e4897 >> bitcast<u32>(10i)) & 31u);
                                            let _e4904 = (_e4897 & 1023u);
                                            if (_e4903 == 0u) {
                                                phi_14104_ = bitcast<f32>((_e4900 | bitcast<u32>((f32(_e4904) * 0.000000059604645f))));
                                            } else {
                                                if (_e4903 == 31u) {
                                                    phi_14081_ = 255u;
                                                    phi_14082_ = u32();
                                                    phi_14083_ = true;
                                                } else {
                                                    let _e4907 = (_e4903 + 112u);
                                                    phi_14081_ = _e4907;
                                                    phi_14082_ = _e4907;
                                                    phi_14083_ = (_e4907 == 255u);
                                                }
                                                let _e4910 = phi_14081_;
                                                let _e4912 = phi_14082_;
                                                let _e4914 = phi_14083_;
                                                if _e4914 {
                                                    phi_14092_ = (_e4904 == 0u);
                                                } else {
                                                    phi_14092_ = true;
                                                }
                                                let _e4917 = phi_14092_;
                                                phi_14104_ = bitcast<f32>((((_e4900 | (select(_e4910, select(_e4912, _e4910, _e4914), _e4917) << bitcast<u32>(23i))) | (_e4904 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4917)));
                                            }
                                            let _e4935 = phi_14104_;
                                            if _e4894 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4943 = ((_e4896 >> bitcast<u32>(16u)) & 65535u);
                                            let _e4946 = ((_e4943 & 32768u) << bitcast<u32>(16i));
                                            let _e4949 = ((_e4943 >> bitcast<u32>(10i)) & 31u);
                                            let _e4950 = (_e4943 & 1023u);
                                            if (_e4949 == 0u) {
                                                phi_14180_ = bitcast<f32>((_e4946 | bitcast<u32>((f32(_e4950) * 0.000000059604645f))));
                                            } else {
                                                if (_e4949 == 31u) {
                                                    phi_14157_ = 255u;
                                                    phi_14158_ = u32();
                                                    phi_14159_ = true;
                                                } else {
                                                    let _e4953 = (_e4949 + 112u);
                                                    phi_14157_ = _e4953;
                                                    phi_14158_ = _e4953;
                                                    phi_14159_ = (_e4953 == 255u);
                                                }
                                                let _e4956 = phi_14157_;
                                                let _e4958 = phi_14158_;
                                                let _e4960 = phi_14159_;
                                                if _e4960 {
                                                    phi_14168_ = (_e4950 == 0u);
                                                } else {
                                                    phi_14168_ = true;
                                                }
                                                let _e4963 = phi_14168_;
                                                phi_14180_ = bitcast<f32>((((_e4946 | (select(_e4956, select(_e4958, _e4956, _e4960), _e4963) << bitcast<u32>(23i))) | (_e4950 << bitcast<u32>(13i))) | select(4194304u, 0u, _e4963)));
                                            }
                                            let _e4981 = phi_14180_;
                                            let _e4987 = (_e4419 + _e4799);
                                            let _e4988 = (_e4987 < _e77);
                                            if _e4988 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e4990 = d.member[_e4987];
                                            let _e4991 = (_e4990 & 65535u);
                                            let _e4994 = ((_e4991 & 32768u) << bitcast<u32>(16i));
                                            let _e4997 = ((_e4991 >> bitcast<u32>(10i)) & 31u);
                                            let _e4998 = (_e4991 & 1023u);
                                            if (_e4997 == 0u) {
                                                phi_14256_ = bitcast<f32>((_e4994 | bitcast<u32>((f32(_e4998) * 0.000000059604645f))));
                                            } else {
                                                if (_e4997 == 31u) {
                                                    phi_14233_ = 255u;
                                                    phi_14234_ = u32();
                                                    phi_14235_ = true;
                                                } else {
                                                    let _e5001 = (_e4997 + 112u);
                                                    phi_14233_ = _e5001;
                                                    phi_14234_ = _e5001;
                                                    phi_14235_ = (_e5001 == 255u);
                                                }
                                                let _e5004 = phi_14233_;
                                                let _e5006 = phi_14234_;
                                                let _e5008 = phi_14235_;
                                                if _e5008 {
                                                    phi_14244_ = (_e4998 == 0u);
                                                } else {
                                                    phi_14244_ = true;
                                                }
                                                let _e5011 = phi_14244_;
                                                phi_14256_ = bitcast<f32>((((_e4994 | (select(_e5004, select(_e5006, _e5004, _e5008), _e5011) << bitcast<u32>(23i))) | (_e4998 << bitcast<u32>(13i))) | select(4194304u, 0u, _e5011)));
                                            }
                                            let _e5029 = phi_14256_;
                                            if _e4988 {
                                            } else {
                                                phi_17461_ = true;
                                                break;
                                            }
                                            let _e5037 = ((_e4990 >> bitcast<u32>(16u)) & 65535u);
                                            let _e5040 = ((_e5037 & 32768u) << bitcast<u32>(16i));
                                            let _e5043 = ((_e5037 >> bitcast<u32>(10i)) & 31u);
                                            let _e5044 = (_e5037 & 1023u);
                                            if (_e5043 == 0u) {
                                                phi_14332_ = bitcast<f32>((_e5040 | bitcast<u32>((f32(_e5044) * 0.000000059604645f))));
                                            } else {
                                                if (_e5043 == 31u) {
                                                    phi_14309_ = 255u;
                                                    phi_14310_ = u32();
                                                    phi_14311_ = true;
                                                } else {
                                                    let _e5047 = (_e5043 + 112u);
                                                    phi_14309_ = _e5047;
                                                    phi_14310_ = _e5047;
                                                    phi_14311_ = (_e5047 == 255u);
                                                }
                                                let _e5050 = phi_14309_;
                                                let _e5052 = phi_14310_;
                                                let _e5054 = phi_14311_;
                                                if _e5054 {
                                                    phi_14320_ = (_e5044 == 0u);
                                                } else {
                                                    phi_14320_ = true;
                                                }
                                                let _e5057 = phi_14320_;
                                                phi_14332_ = bitcast<f32>((((_e5040 | (select(_e5050, select(_e5052, _e5050, _e5054), _e5057) << bitcast<u32>(23i))) | (_e5044 << bitcast<u32>(13i))) | select(4194304u, 0u, _e5057)));
                                            }
                                            let _e5075 = phi_14332_;
                                            phi_14338_ = (_e4165 + _e4220);
                                            phi_14339_ = array<array<f32, 6>, 3>(array<f32, 6>((_e4167[0][0] + ((_e4272 * _e96) * _e4220)), (_e4167[0][1] + ((_e4318 * _e96) * _e4220)), (_e4167[0][2] + ((_e4367 * _e96) * _e4220)), (_e4167[0][3] + ((_e4413 * _e96) * _e4220)), (_e4167[0][4] + ((_e4462 * _e96) * _e4220)), (_e4167[0][5] + ((_e4508 * _e96) * _e4220))), array<f32, 6>((_e4167[1][0] + ((_e4557 * _e96) * _e4220)), (_e4167[1][1] + ((_e4603 * _e96) * _e4220)), (_e4167[1][2] + ((_e4651 * _e96) * _e4220)), (_e4167[1][3] + ((_e4697 * _e96) * _e4220)), (_e4167[1][4] + ((_e4745 * _e96) * _e4220)), (_e4167[1][5] + ((_e4791 * _e96) * _e4220))), array<f32, 6>((_e4167[2][0] + ((_e4841 * _e96) * _e4220)), (_e4167[2][1] + ((_e4887 * _e96) * _e4220)), (_e4167[2][2] + ((_e4935 * _e96) * _e4220)), (_e4167[2][3] + ((_e4981 * _e96) * _e4220)), (_e4167[2][4] + ((_e5029 * _e96) * _e4220)), (_e4167[2][5] + ((_e5075 * _e96) * _e4220))));
                                        } else {
                                            phi_14338_ = _e4165;
                                            phi_14339_ = _e4167;
                                        }
                                        let _e5084 = phi_14338_;
                                        let _e5086 = phi_14339_;
                                        phi_12861_ = _e5084;
                                        phi_12863_ = _e5086;
                                    } else {
                                        phi_12861_ = f32();
                                        phi_12863_ = array<array<f32, 6>, 3>();
                                    }
                                    let _e5088 = phi_12861_;
                                    let _e5090 = phi_12863_;
                                    continue;
                                    continuing {
                                        phi_12857_ = _e4180;
                                        phi_12860_ = _e5088;
                                        phi_12862_ = _e5090;
                                        phi_17461_ = _e3970;
                                        break if !(_e4186);
                                    }
                                }
                                let _e5093 = phi_17461_;
                                if _e5093 {
                                    break;
                                }
                                let _e5095 = local_60;
                                if (_e5095 > 0f) {
                                    let _e5098 = local_61;
                                    phi_14345_ = (1f / _e5098);
                                } else {
                                    phi_14345_ = 0f;
                                }
                                let _e5101 = phi_14345_;
                                let _e5103 = local_62;
                                let _e5108 = local_63;
                                let _e5113 = local_64;
                                let _e5118 = local_65;
                                let _e5123 = local_66;
                                let _e5128 = local_67;
                                let _e5133 = local_68;
                                let _e5138 = local_69;
                                let _e5143 = local_70;
                                let _e5148 = local_71;
                                let _e5153 = local_72;
                                let _e5158 = local_73;
                                let _e5163 = local_74;
                                let _e5168 = local_75;
                                let _e5173 = local_76;
                                let _e5178 = local_77;
                                let _e5183 = local_78;
                                let _e5188 = local_79;
                                let _e5193 = ((0.6666667f / _e3983.w) / _e3983.w);
                                let _e5194 = -(_e90.member_2[0]);
                                let _e5195 = -(_e90.member_2[1]);
                                let _e5198 = (_e90.member_2[2] * -1.0233268f);
                                let _e5204 = ((((_e90.member_2[2] * -1.9364917f) * (_e90.member_2[2] * -0.48860252f)) - 0.3153916f) * 0.7853982f);
                                let _e5207 = (_e90.member_2[0] * -1.0233268f);
                                let _e5210 = (_e90.member_2[1] * -1.0233268f);
                                let _e5216 = (((_e5194 * _e5194) - (_e5195 * _e5195)) * 0.4290428f);
                                let _e5218 = (((((((_e5103[0][0] * _e5101) * 0.886227f) + ((_e5113[0][2] * _e5101) * _e5198)) + ((_e5123[0][4] * _e5101) * _e5204)) + ((_e5118[0][3] * _e5101) * _e5207)) + ((_e5108[0][1] * _e5101) * _e5210)) + ((_e5128[0][5] * _e5101) * _e5216));
                                let _e5231 = (((((((_e5133[1][0] * _e5101) * 0.886227f) + ((_e5143[1][2] * _e5101) * _e5198)) + ((_e5153[1][4] * _e5101) * _e5204)) + ((_e5148[1][3] * _e5101) * _e5207)) + ((_e5138[1][1] * _e5101) * _e5210)) + ((_e5158[1][5] * _e5101) * _e5216));
                                let _e5244 = (((((((_e5163[2][0] * _e5101) * 0.886227f) + ((_e5173[2][2] * _e5101) * _e5198)) + ((_e5183[2][4] * _e5101) * _e5204)) + ((_e5178[2][3] * _e5101) * _e5207)) + ((_e5168[2][1] * _e5101) * _e5210)) + ((_e5188[2][5] * _e5101) * _e5216));
                                phi_16633_ = vec4<f32>((_e3976.x + ((select(0f, _e5218, (_e5218 > 0f)) * _e5193) * _e4051)), (_e3976.y + ((select(0f, _e5231, (_e5231 > 0f)) * _e5193) * _e4051)), (_e3976.z + ((select(0f, _e5244, (_e5244 > 0f)) * _e5193) * _e4051)), f32());
                            }
                            let _e5258 = phi_16633_;
                            phi_16634_ = _e5258;
                        }
                        let _e5260 = phi_16634_;
                        phi_16635_ = _e5260;
                        phi_16636_ = _e3979;
                    }
                    let _e5262 = phi_16635_;
                    let _e5264 = phi_16636_;
                    let _e5266 = select(_e5262, _e3976, vec4(_e5264));
                    phi_16645_ = vec4<f32>(_e5266.x, _e5266.y, _e5266.z, 0f);
                }
                let _e5272 = phi_16645_;
                if _e86 {
                } else {
                    break;
                }
                irradiance.member[_e85] = _e5272;
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
