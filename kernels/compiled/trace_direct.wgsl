struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: array<u32>,
}

struct type_20 {
    member: array<vec4<f32>>,
}

struct type_24 {
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
    member: array<type_24>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_40 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_42 {
    member: array<type_40>,
}

struct type_44 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
}

struct type_51 {
    member: vec4<f32>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
    member_5: u32,
    member_6: u32,
    member_7: u32,
    member_8: u32,
}

struct type_52 {
    member: type_51,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: f32,
    member_4: array<f32, 3>,
    member_5: f32,
    member_6: array<f32, 3>,
    member_7: f32,
}

struct type_56 {
    member: array<type_54>,
}

struct type_60 {
    member: f32,
    member_1: vec3<f32>,
    member_2: vec3<f32>,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> nodes: type_32;
@group(0) @binding(2) 
var<storage> triangles: type_36;
@group(0) @binding(3) 
var<storage> attributes: type_42;
@group(0) @binding(4) 
var<storage> surfaces: type_11;
@group(0) @binding(0) 
var<uniform> params: type_52;
@group(0) @binding(5) 
var<storage> lights: type_56;
@group(0) @binding(6) 
var<storage> surfels: type_26;
@group(0) @binding(7) 
var<storage, read_write> irradiance: type_20;

fn function_() {
    var local: array<u32, 64>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<u32, 64>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<u32, 64>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<u32, 64>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<u32, 64>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<u32, 64>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var local_18: array<u32, 64>;
    var local_19: array<f32, 3>;
    var local_20: array<f32, 3>;
    var phi_16276_: bool;
    var phi_4959_: type_8;
    var phi_4962_: vec3<f32>;
    var phi_4960_: type_8;
    var phi_4985_: type_8;
    var phi_4999_: u32;
    var phi_5002_: u32;
    var phi_5026_: u32;
    var phi_5000_: u32;
    var phi_5003_: u32;
    var phi_16272_: bool;
    var local_21: u32;
    var local_22: u32;
    var phi_8203_: f32;
    var phi_8221_: f32;
    var phi_8247_: bool;
    var phi_8257_: u32;
    var phi_8260_: bool;
    var phi_8271_: u32;
    var phi_8401_: f32;
    var phi_8409_: f32;
    var phi_8417_: f32;
    var phi_16282_: bool;
    var phi_8420_: u32;
    var phi_8423_: u32;
    var phi_8848_: type_8;
    var phi_8849_: type_8;
    var phi_8872_: type_8;
    var phi_8988_: f32;
    var phi_8999_: f32;
    var phi_9010_: f32;
    var phi_9025_: f32;
    var phi_9026_: f32;
    var phi_9027_: bool;
    var phi_9028_: f32;
    var phi_9029_: bool;
    var phi_9048_: f32;
    var phi_9049_: bool;
    var phi_9050_: f32;
    var phi_9051_: bool;
    var phi_9052_: bool;
    var phi_9057_: f32;
    var phi_9058_: bool;
    var phi_9144_: array<f32, 3>;
    var phi_9145_: array<f32, 3>;
    var phi_9146_: array<f32, 3>;
    var phi_9147_: array<f32, 3>;
    var phi_9148_: bool;
    var phi_9149_: array<f32, 3>;
    var phi_9150_: array<f32, 3>;
    var phi_9151_: bool;
    var phi_9152_: bool;
    var phi_9157_: array<f32, 3>;
    var phi_9162_: array<f32, 3>;
    var phi_9372_: u32;
    var phi_9378_: u32;
    var phi_9408_: u32;
    var phi_9414_: u32;
    var phi_9489_: bool;
    var phi_9494_: bool;
    var phi_9499_: type_44;
    var phi_9501_: type_44;
    var phi_9503_: bool;
    var phi_9504_: type_44;
    var phi_9506_: bool;
    var phi_9507_: bool;
    var phi_9508_: type_44;
    var phi_9509_: bool;
    var phi_9510_: bool;
    var phi_9511_: bool;
    var phi_9524_: type_44;
    var phi_9531_: bool;
    var phi_16278_: bool;
    var phi_12417_: bool;
    var phi_8808_: u32;
    var phi_8820_: u32;
    var phi_8832_: u32;
    var phi_8844_: u32;
    var phi_16346_: bool;
    var phi_9536_: u32;
    var phi_9537_: bool;
    var phi_9553_: u32;
    var phi_9554_: u32;
    var phi_8421_: u32;
    var phi_8424_: u32;
    var phi_9556_: bool;
    var phi_9557_: bool;
    var phi_16344_: bool;
    var phi_12418_: bool;
    var phi_9574_: vec3<f32>;
    var phi_16671_: bool;
    var phi_9576_: vec3<f32>;
    var phi_9577_: bool;
    var phi_6778_: f32;
    var phi_6804_: bool;
    var phi_6814_: u32;
    var phi_6817_: bool;
    var phi_6828_: u32;
    var phi_6958_: f32;
    var phi_6966_: f32;
    var phi_6974_: f32;
    var phi_16408_: bool;
    var phi_6977_: u32;
    var phi_6980_: u32;
    var phi_7405_: type_8;
    var phi_7406_: type_8;
    var phi_7429_: type_8;
    var phi_7545_: f32;
    var phi_7556_: f32;
    var phi_7567_: f32;
    var phi_7582_: f32;
    var phi_7583_: f32;
    var phi_7584_: bool;
    var phi_7585_: f32;
    var phi_7586_: bool;
    var phi_7605_: f32;
    var phi_7606_: bool;
    var phi_7607_: f32;
    var phi_7608_: bool;
    var phi_7609_: bool;
    var phi_7614_: f32;
    var phi_7615_: bool;
    var phi_7701_: array<f32, 3>;
    var phi_7702_: array<f32, 3>;
    var phi_7703_: array<f32, 3>;
    var phi_7704_: array<f32, 3>;
    var phi_7705_: bool;
    var phi_7706_: array<f32, 3>;
    var phi_7707_: array<f32, 3>;
    var phi_7708_: bool;
    var phi_7709_: bool;
    var phi_7714_: array<f32, 3>;
    var phi_7719_: array<f32, 3>;
    var phi_7929_: u32;
    var phi_7935_: u32;
    var phi_7965_: u32;
    var phi_7971_: u32;
    var phi_8046_: bool;
    var phi_8051_: bool;
    var phi_8056_: type_44;
    var phi_8058_: type_44;
    var phi_8060_: bool;
    var phi_8061_: type_44;
    var phi_8063_: bool;
    var phi_8064_: bool;
    var phi_8065_: type_44;
    var phi_8066_: bool;
    var phi_8067_: bool;
    var phi_8068_: bool;
    var phi_8081_: type_44;
    var phi_8088_: bool;
    var phi_16404_: bool;
    var phi_12419_: bool;
    var phi_7365_: u32;
    var phi_7377_: u32;
    var phi_7389_: u32;
    var phi_7401_: u32;
    var phi_16466_: bool;
    var phi_8093_: u32;
    var phi_8094_: bool;
    var phi_8110_: u32;
    var phi_8111_: u32;
    var phi_6978_: u32;
    var phi_6981_: u32;
    var phi_8113_: bool;
    var phi_8114_: bool;
    var phi_16464_: bool;
    var phi_12420_: bool;
    var phi_8130_: vec3<f32>;
    var phi_16676_: bool;
    var phi_8131_: vec3<f32>;
    var phi_8132_: bool;
    var phi_16669_: bool;
    var phi_9582_: vec3<f32>;
    var phi_9583_: vec3<f32>;
    var phi_5133_: vec3<f32>;
    var phi_5135_: vec3<f32>;
    var phi_5136_: bool;
    var phi_16550_: bool;
    var phi_5158_: type_8;
    var phi_5163_: f32;
    var phi_5159_: type_8;
    var phi_5188_: type_8;
    var phi_12924_: f32;
    var phi_12932_: f32;
    var phi_5249_: vec2<f32>;
    var phi_5346_: f32;
    var phi_5372_: bool;
    var phi_5382_: u32;
    var phi_5385_: bool;
    var phi_5396_: u32;
    var phi_5526_: f32;
    var phi_5534_: f32;
    var phi_5542_: f32;
    var phi_16528_: bool;
    var phi_5545_: u32;
    var phi_5548_: u32;
    var phi_5973_: type_8;
    var phi_5974_: type_8;
    var phi_5997_: type_8;
    var phi_6113_: f32;
    var phi_6124_: f32;
    var phi_6135_: f32;
    var phi_6150_: f32;
    var phi_6151_: f32;
    var phi_6152_: bool;
    var phi_6153_: f32;
    var phi_6154_: bool;
    var phi_6173_: f32;
    var phi_6174_: bool;
    var phi_6175_: f32;
    var phi_6176_: bool;
    var phi_6177_: bool;
    var phi_6182_: f32;
    var phi_6183_: bool;
    var phi_6269_: array<f32, 3>;
    var phi_6270_: array<f32, 3>;
    var phi_6271_: array<f32, 3>;
    var phi_6272_: array<f32, 3>;
    var phi_6273_: bool;
    var phi_6274_: array<f32, 3>;
    var phi_6275_: array<f32, 3>;
    var phi_6276_: bool;
    var phi_6277_: bool;
    var phi_6282_: array<f32, 3>;
    var phi_6287_: array<f32, 3>;
    var phi_6497_: u32;
    var phi_6503_: u32;
    var phi_6533_: u32;
    var phi_6539_: u32;
    var phi_6614_: bool;
    var phi_6619_: bool;
    var phi_6624_: type_44;
    var phi_6626_: type_44;
    var phi_6628_: bool;
    var phi_6629_: type_44;
    var phi_6631_: bool;
    var phi_6632_: bool;
    var phi_6633_: type_44;
    var phi_6634_: bool;
    var phi_6635_: bool;
    var phi_6636_: bool;
    var phi_6649_: type_44;
    var phi_6656_: bool;
    var phi_16524_: bool;
    var phi_12421_: bool;
    var phi_5933_: u32;
    var phi_5945_: u32;
    var phi_5957_: u32;
    var phi_5969_: u32;
    var phi_16600_: bool;
    var phi_6661_: u32;
    var phi_6662_: bool;
    var phi_6678_: u32;
    var phi_6679_: u32;
    var phi_5546_: u32;
    var phi_5549_: u32;
    var phi_6681_: bool;
    var phi_6682_: bool;
    var phi_16598_: bool;
    var phi_12422_: bool;
    var phi_6696_: f32;
    var phi_16660_: bool;
    var phi_6697_: f32;
    var phi_16659_: bool;
    var phi_5164_: f32;
    var phi_16658_: bool;
    var local_23: f32;
    var local_24: f32;
    var phi_6726_: f32;
    var phi_16681_: bool;
    var phi_6732_: f32;
    var phi_16668_: bool;
    var phi_9584_: vec3<f32>;
    var phi_9585_: vec3<f32>;
    var phi_9586_: bool;
    var phi_16666_: bool;
    var phi_9606_: vec3<f32>;
    var phi_16665_: bool;
    var phi_4963_: vec3<f32>;
    var phi_16664_: bool;
    var phi_16793_: bool;
    var phi_337_: type_8;
    var phi_340_: vec3<f32>;
    var phi_338_: type_8;
    var phi_363_: type_8;
    var phi_3546_: f32;
    var phi_3564_: f32;
    var phi_3590_: bool;
    var phi_3600_: u32;
    var phi_3603_: bool;
    var phi_3614_: u32;
    var phi_3744_: f32;
    var phi_3752_: f32;
    var phi_3760_: f32;
    var phi_16776_: bool;
    var phi_3763_: u32;
    var phi_3766_: u32;
    var phi_4191_: type_8;
    var phi_4192_: type_8;
    var phi_4215_: type_8;
    var phi_4331_: f32;
    var phi_4342_: f32;
    var phi_4353_: f32;
    var phi_4368_: f32;
    var phi_4369_: f32;
    var phi_4370_: bool;
    var phi_4371_: f32;
    var phi_4372_: bool;
    var phi_4391_: f32;
    var phi_4392_: bool;
    var phi_4393_: f32;
    var phi_4394_: bool;
    var phi_4395_: bool;
    var phi_4400_: f32;
    var phi_4401_: bool;
    var phi_4487_: array<f32, 3>;
    var phi_4488_: array<f32, 3>;
    var phi_4489_: array<f32, 3>;
    var phi_4490_: array<f32, 3>;
    var phi_4491_: bool;
    var phi_4492_: array<f32, 3>;
    var phi_4493_: array<f32, 3>;
    var phi_4494_: bool;
    var phi_4495_: bool;
    var phi_4500_: array<f32, 3>;
    var phi_4505_: array<f32, 3>;
    var phi_4715_: u32;
    var phi_4721_: u32;
    var phi_4751_: u32;
    var phi_4757_: u32;
    var phi_4832_: bool;
    var phi_4837_: bool;
    var phi_4842_: type_44;
    var phi_4844_: type_44;
    var phi_4846_: bool;
    var phi_4847_: type_44;
    var phi_4849_: bool;
    var phi_4850_: bool;
    var phi_4851_: type_44;
    var phi_4852_: bool;
    var phi_4853_: bool;
    var phi_4854_: bool;
    var phi_4867_: type_44;
    var phi_4874_: bool;
    var phi_16772_: bool;
    var phi_12423_: bool;
    var phi_4151_: u32;
    var phi_4163_: u32;
    var phi_4175_: u32;
    var phi_4187_: u32;
    var phi_16842_: bool;
    var phi_4879_: u32;
    var phi_4880_: bool;
    var phi_4896_: u32;
    var phi_4897_: u32;
    var phi_3764_: u32;
    var phi_3767_: u32;
    var phi_4899_: bool;
    var phi_4900_: bool;
    var phi_16840_: bool;
    var phi_12424_: bool;
    var phi_4917_: vec3<f32>;
    var phi_17166_: bool;
    var phi_4919_: vec3<f32>;
    var phi_4920_: bool;
    var phi_2121_: f32;
    var phi_2147_: bool;
    var phi_2157_: u32;
    var phi_2160_: bool;
    var phi_2171_: u32;
    var phi_2301_: f32;
    var phi_2309_: f32;
    var phi_2317_: f32;
    var phi_16904_: bool;
    var phi_2320_: u32;
    var phi_2323_: u32;
    var phi_2748_: type_8;
    var phi_2749_: type_8;
    var phi_2772_: type_8;
    var phi_2888_: f32;
    var phi_2899_: f32;
    var phi_2910_: f32;
    var phi_2925_: f32;
    var phi_2926_: f32;
    var phi_2927_: bool;
    var phi_2928_: f32;
    var phi_2929_: bool;
    var phi_2948_: f32;
    var phi_2949_: bool;
    var phi_2950_: f32;
    var phi_2951_: bool;
    var phi_2952_: bool;
    var phi_2957_: f32;
    var phi_2958_: bool;
    var phi_3044_: array<f32, 3>;
    var phi_3045_: array<f32, 3>;
    var phi_3046_: array<f32, 3>;
    var phi_3047_: array<f32, 3>;
    var phi_3048_: bool;
    var phi_3049_: array<f32, 3>;
    var phi_3050_: array<f32, 3>;
    var phi_3051_: bool;
    var phi_3052_: bool;
    var phi_3057_: array<f32, 3>;
    var phi_3062_: array<f32, 3>;
    var phi_3272_: u32;
    var phi_3278_: u32;
    var phi_3308_: u32;
    var phi_3314_: u32;
    var phi_3389_: bool;
    var phi_3394_: bool;
    var phi_3399_: type_44;
    var phi_3401_: type_44;
    var phi_3403_: bool;
    var phi_3404_: type_44;
    var phi_3406_: bool;
    var phi_3407_: bool;
    var phi_3408_: type_44;
    var phi_3409_: bool;
    var phi_3410_: bool;
    var phi_3411_: bool;
    var phi_3424_: type_44;
    var phi_3431_: bool;
    var phi_16900_: bool;
    var phi_12425_: bool;
    var phi_2708_: u32;
    var phi_2720_: u32;
    var phi_2732_: u32;
    var phi_2744_: u32;
    var phi_16962_: bool;
    var phi_3436_: u32;
    var phi_3437_: bool;
    var phi_3453_: u32;
    var phi_3454_: u32;
    var phi_2321_: u32;
    var phi_2324_: u32;
    var phi_3456_: bool;
    var phi_3457_: bool;
    var phi_16960_: bool;
    var phi_12426_: bool;
    var phi_3473_: vec3<f32>;
    var phi_17171_: bool;
    var phi_3474_: vec3<f32>;
    var phi_3475_: bool;
    var phi_17164_: bool;
    var phi_4925_: vec3<f32>;
    var phi_4926_: vec3<f32>;
    var phi_476_: vec3<f32>;
    var phi_478_: vec3<f32>;
    var phi_479_: bool;
    var phi_17046_: bool;
    var phi_501_: type_8;
    var phi_504_: f32;
    var phi_506_: f32;
    var phi_508_: f32;
    var phi_502_: type_8;
    var phi_531_: type_8;
    var phi_14715_: f32;
    var phi_14723_: f32;
    var phi_592_: vec2<f32>;
    var phi_689_: f32;
    var phi_715_: bool;
    var phi_725_: u32;
    var phi_728_: bool;
    var phi_739_: u32;
    var phi_869_: f32;
    var phi_877_: f32;
    var phi_885_: f32;
    var phi_17024_: bool;
    var phi_888_: u32;
    var phi_891_: u32;
    var phi_1316_: type_8;
    var phi_1317_: type_8;
    var phi_1340_: type_8;
    var phi_1456_: f32;
    var phi_1467_: f32;
    var phi_1478_: f32;
    var phi_1493_: f32;
    var phi_1494_: f32;
    var phi_1495_: bool;
    var phi_1496_: f32;
    var phi_1497_: bool;
    var phi_1516_: f32;
    var phi_1517_: bool;
    var phi_1518_: f32;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1525_: f32;
    var phi_1526_: bool;
    var phi_1612_: array<f32, 3>;
    var phi_1613_: array<f32, 3>;
    var phi_1614_: array<f32, 3>;
    var phi_1615_: array<f32, 3>;
    var phi_1616_: bool;
    var phi_1617_: array<f32, 3>;
    var phi_1618_: array<f32, 3>;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1625_: array<f32, 3>;
    var phi_1630_: array<f32, 3>;
    var phi_1840_: u32;
    var phi_1846_: u32;
    var phi_1876_: u32;
    var phi_1882_: u32;
    var phi_1957_: bool;
    var phi_1962_: bool;
    var phi_1967_: type_44;
    var phi_1969_: type_44;
    var phi_1971_: bool;
    var phi_1972_: type_44;
    var phi_1974_: bool;
    var phi_1975_: bool;
    var phi_1976_: type_44;
    var phi_1977_: bool;
    var phi_1978_: bool;
    var phi_1979_: bool;
    var phi_1992_: type_44;
    var phi_1999_: bool;
    var phi_17020_: bool;
    var phi_12427_: bool;
    var phi_1276_: u32;
    var phi_1288_: u32;
    var phi_1300_: u32;
    var phi_1312_: u32;
    var phi_17096_: bool;
    var phi_2004_: u32;
    var phi_2005_: bool;
    var phi_2021_: u32;
    var phi_2022_: u32;
    var phi_889_: u32;
    var phi_892_: u32;
    var phi_2024_: bool;
    var phi_2025_: bool;
    var phi_17094_: bool;
    var phi_12428_: bool;
    var phi_2039_: f32;
    var phi_17156_: bool;
    var phi_2040_: f32;
    var phi_17155_: bool;
    var phi_505_: f32;
    var phi_507_: f32;
    var phi_509_: f32;
    var phi_17154_: bool;
    var local_25: f32;
    var local_26: f32;
    var phi_15033_: bool;
    var phi_15044_: bool;
    var phi_15065_: type_60;
    var phi_15069_: type_60;
    var phi_15070_: vec3<f32>;
    var phi_15071_: vec3<f32>;
    var phi_15111_: vec3<f32>;
    var phi_15114_: vec3<f32>;
    var phi_15115_: bool;
    var phi_15159_: vec3<f32>;
    var phi_15162_: vec3<f32>;
    var phi_15163_: bool;
    var phi_15230_: f32;
    var phi_15238_: f32;
    var phi_15253_: f32;
    var phi_15259_: f32;
    var phi_15267_: f32;
    var phi_15277_: f32;
    var phi_15282_: type_60;
    var phi_15292_: bool;
    var phi_15303_: bool;
    var phi_15324_: type_60;
    var phi_15328_: type_60;
    var phi_15329_: vec3<f32>;
    var phi_15330_: vec3<f32>;
    var phi_15370_: vec3<f32>;
    var phi_15373_: vec3<f32>;
    var phi_15374_: bool;
    var phi_15418_: vec3<f32>;
    var phi_15421_: vec3<f32>;
    var phi_15422_: bool;
    var phi_15489_: f32;
    var phi_15497_: f32;
    var phi_15512_: f32;
    var phi_15518_: f32;
    var phi_15526_: f32;
    var phi_15536_: f32;
    var phi_15541_: type_60;
    var phi_15551_: bool;
    var phi_15583_: type_60;
    var phi_15587_: type_60;
    var phi_15588_: vec3<f32>;
    var phi_15589_: vec3<f32>;
    var phi_15629_: vec3<f32>;
    var phi_15632_: vec3<f32>;
    var phi_15633_: bool;
    var phi_15677_: vec3<f32>;
    var phi_15680_: vec3<f32>;
    var phi_15681_: bool;
    var phi_15748_: f32;
    var phi_15756_: f32;
    var phi_15771_: f32;
    var phi_15777_: f32;
    var phi_15785_: f32;
    var phi_15795_: f32;
    var phi_15800_: type_60;
    var phi_15842_: vec3<f32>;
    var phi_15845_: vec3<f32>;
    var phi_15846_: bool;
    var phi_15890_: vec3<f32>;
    var phi_15893_: vec3<f32>;
    var phi_15894_: bool;
    var phi_15961_: f32;
    var phi_15969_: f32;
    var phi_15984_: f32;
    var phi_15990_: f32;
    var phi_15998_: f32;
    var phi_16008_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_2058_: f32;
    var phi_2059_: f32;
    var phi_2060_: bool;
    var local_29: f32;
    var phi_2068_: f32;
    var phi_2069_: f32;
    var phi_2070_: f32;
    var phi_2071_: bool;
    var phi_17176_: bool;
    var phi_2075_: f32;
    var phi_2076_: f32;
    var phi_2077_: bool;
    var phi_17163_: bool;
    var phi_4927_: vec3<f32>;
    var phi_4928_: vec3<f32>;
    var phi_4929_: bool;
    var phi_17161_: bool;
    var phi_341_: vec3<f32>;
    var phi_17160_: bool;
    var phi_17291_: bool;
    var phi_9607_: vec3<f32>;
    var phi_17290_: bool;
    var phi_9647_: type_8;
    var phi_9650_: i32;
    var phi_9648_: type_8;
    var phi_9673_: type_8;
    var phi_16020_: f32;
    var phi_16028_: f32;
    var phi_9737_: vec2<f32>;
    var phi_9738_: bool;
    var phi_9868_: f32;
    var phi_9876_: f32;
    var phi_9802_: f32;
    var phi_9810_: f32;
    var phi_9880_: vec2<f32>;
    var phi_9881_: vec2<f32>;
    var phi_9919_: f32;
    var phi_9942_: bool;
    var phi_9952_: u32;
    var phi_9955_: bool;
    var phi_9966_: u32;
    var phi_10096_: f32;
    var phi_10104_: f32;
    var phi_10112_: f32;
    var phi_17271_: bool;
    var phi_10115_: u32;
    var phi_10118_: u32;
    var phi_10543_: type_8;
    var phi_10544_: type_8;
    var phi_10567_: type_8;
    var phi_10683_: f32;
    var phi_10694_: f32;
    var phi_10705_: f32;
    var phi_10720_: f32;
    var phi_10721_: f32;
    var phi_10722_: bool;
    var phi_10723_: f32;
    var phi_10724_: bool;
    var phi_10743_: f32;
    var phi_10744_: bool;
    var phi_10745_: f32;
    var phi_10746_: bool;
    var phi_10747_: bool;
    var phi_10752_: f32;
    var phi_10753_: bool;
    var phi_10839_: array<f32, 3>;
    var phi_10840_: array<f32, 3>;
    var phi_10841_: array<f32, 3>;
    var phi_10842_: array<f32, 3>;
    var phi_10843_: bool;
    var phi_10844_: array<f32, 3>;
    var phi_10845_: array<f32, 3>;
    var phi_10846_: bool;
    var phi_10847_: bool;
    var phi_10852_: array<f32, 3>;
    var phi_10857_: array<f32, 3>;
    var phi_11067_: u32;
    var phi_11073_: u32;
    var phi_11103_: u32;
    var phi_11109_: u32;
    var phi_11184_: bool;
    var phi_11189_: bool;
    var phi_11194_: type_44;
    var phi_11196_: type_44;
    var phi_11198_: bool;
    var phi_11199_: type_44;
    var phi_11201_: bool;
    var phi_11202_: bool;
    var phi_11203_: type_44;
    var phi_11204_: bool;
    var phi_11205_: bool;
    var phi_11206_: bool;
    var phi_11219_: type_44;
    var phi_11226_: bool;
    var phi_17267_: bool;
    var phi_12429_: bool;
    var phi_10503_: u32;
    var phi_10515_: u32;
    var phi_10527_: u32;
    var phi_10539_: u32;
    var phi_17344_: bool;
    var phi_11231_: u32;
    var phi_11232_: bool;
    var phi_11248_: u32;
    var phi_11249_: u32;
    var phi_10116_: u32;
    var phi_10119_: u32;
    var phi_11251_: bool;
    var phi_11252_: bool;
    var phi_17342_: bool;
    var phi_12430_: bool;
    var phi_11265_: i32;
    var phi_17403_: bool;
    var phi_9651_: i32;
    var phi_17402_: bool;
    var local_30: i32;
    var phi_11292_: vec3<f32>;
    var phi_11297_: vec4<f32>;
    var local_31: vec3<f32>;
    var local_32: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e132 = gid_1;
            let _e135 = arrayLength((&nodes.member));
            let _e138 = arrayLength((&triangles.member));
            let _e141 = arrayLength((&attributes.member));
            let _e144 = arrayLength((&surfaces.member));
            let _e146 = arrayLength((&lights.member));
            let _e153 = params.member.member_1;
            let _e157 = (_e132.x + (_e132.y * 2097152u));
            if (_e157 < _e153) {
                if (_e157 < arrayLength((&surfels.member))) {
                } else {
                    break;
                }
                let _e162 = surfels.member[_e157];
                if (_e162.member_1 == 4294967295u) {
                    phi_11297_ = vec4<f32>(0f, 0f, 0f, 0f);
                } else {
                    let _e169 = vec3<f32>(_e162.member[0], _e162.member[1], _e162.member[2]);
                    let _e181 = params.member.member_2;
                    let _e184 = params.member.member_3;
                    let _e187 = params.member.member_5;
                    let _e190 = params.member.member_6;
                    let _e194 = ((_e157 ^ (_e157 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e198 = ((_e194 ^ (_e194 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e202 = (_e190 ^ (_e198 ^ (_e198 >> bitcast<u32>(16i))));
                    let _e206 = ((_e202 ^ (_e202 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e210 = ((_e206 ^ (_e206 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e213 = (_e210 ^ (_e210 >> bitcast<u32>(16i)));
                    if (_e181 <= _e187) {
                        phi_16793_ = false;
                        phi_337_ = type_8(0u, _e181);
                        phi_340_ = vec3<f32>(0f, 0f, 0f);
                        loop {
                            let _e3768 = phi_16793_;
                            let _e3770 = phi_337_;
                            let _e3772 = phi_340_;
                            local_31 = _e3772;
                            if (_e3770.member < _e3770.member_1) {
                                phi_338_ = type_8((_e3770.member + 1u), _e3770.member_1);
                                phi_363_ = type_8(1u, _e3770.member);
                            } else {
                                phi_338_ = _e3770;
                                phi_363_ = type_8(0u, type_8().member_1);
                            }
                            let _e3785 = phi_338_;
                            let _e3787 = phi_363_;
                            let _e3791 = (bitcast<i32>(_e3787.member) != 0i);
                            if _e3791 {
                                if (_e3787.member_1 < _e146) {
                                } else {
                                    phi_17160_ = true;
                                    break;
                                }
                                let _e3795 = lights.member[_e3787.member_1];
                                let _e3799 = ((_e3787.member_1 ^ (_e3787.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e3803 = ((_e3799 ^ (_e3799 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e3807 = (_e213 ^ (_e3803 ^ (_e3803 >> bitcast<u32>(16i))));
                                let _e3811 = ((_e3807 ^ (_e3807 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e3815 = ((_e3811 ^ (_e3811 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e3818 = (_e3815 ^ (_e3815 >> bitcast<u32>(16i)));
                                if (_e3795.member_1 == 3u) {
                                    let _e5988 = (_e3795.member_2[0] - _e3795.member[0]);
                                    let _e5989 = (_e3795.member_2[1] - _e3795.member[1]);
                                    let _e5990 = (_e3795.member_2[2] - _e3795.member[2]);
                                    let _e5991 = (_e3795.member_4[0] - _e3795.member[0]);
                                    let _e5992 = (_e3795.member_4[1] - _e3795.member[1]);
                                    let _e5993 = (_e3795.member_4[2] - _e3795.member[2]);
                                    let _e5996 = ((_e5989 * _e5993) - (_e5992 * _e5990));
                                    let _e5999 = ((_e5990 * _e5991) - (_e5993 * _e5988));
                                    let _e6002 = ((_e5988 * _e5992) - (_e5991 * _e5989));
                                    let _e6003 = abs(_e5996);
                                    let _e6004 = abs(_e5999);
                                    let _e6006 = select(_e6004, _e6003, (_e6003 > _e6004));
                                    let _e6007 = abs(_e6002);
                                    let _e6009 = select(_e6007, _e6006, (_e6006 > _e6007));
                                    if (_e6009 > 0.000000000000000000000000000000000000011754944f) {
                                        let _e6011 = (_e6009 < 340282350000000000000000000000000000000f);
                                        if _e6011 {
                                            let _e6012 = (_e5996 / _e6009);
                                            let _e6013 = (_e5999 / _e6009);
                                            let _e6014 = (_e6002 / _e6009);
                                            let _e6020 = sqrt((((_e6012 * _e6012) + (_e6013 * _e6013)) + (_e6014 * _e6014)));
                                            phi_476_ = vec3<f32>((_e6012 / _e6020), (_e6013 / _e6020), (_e6014 / _e6020));
                                        } else {
                                            phi_476_ = vec3<f32>();
                                        }
                                        let _e6026 = phi_476_;
                                        phi_478_ = _e6026;
                                        phi_479_ = select(true, false, _e6011);
                                    } else {
                                        phi_478_ = vec3<f32>();
                                        phi_479_ = true;
                                    }
                                    let _e6029 = phi_478_;
                                    let _e6031 = phi_479_;
                                    let _e6033 = select(_e6029, vec3<f32>(0f, 0f, 0f), vec3(_e6031));
                                    let _e6044 = (((_e6033.x * (_e162.member[0] - _e3795.member[0])) + (_e6033.y * (_e162.member[1] - _e3795.member[1]))) + (_e6033.z * (_e162.member[2] - _e3795.member[2])));
                                    if (_e6044 <= 0f) {
                                        phi_17176_ = _e3768;
                                        phi_2075_ = 0f;
                                        phi_2076_ = f32();
                                        phi_2077_ = true;
                                    } else {
                                        phi_17046_ = _e3768;
                                        phi_501_ = type_8(0u, _e184);
                                        phi_504_ = 340282350000000000000000000000000000000f;
                                        phi_506_ = 0f;
                                        phi_508_ = 0f;
                                        loop {
                                            let _e6048 = phi_17046_;
                                            let _e6050 = phi_501_;
                                            let _e6052 = phi_504_;
                                            let _e6054 = phi_506_;
                                            let _e6056 = phi_508_;
                                            local_25 = _e6054;
                                            local_26 = _e6052;
                                            local_27 = _e6054;
                                            local_28 = _e6056;
                                            local_29 = _e6054;
                                            if (_e6050.member < _e6050.member_1) {
                                                phi_502_ = type_8((_e6050.member + 1u), _e6050.member_1);
                                                phi_531_ = type_8(1u, _e6050.member);
                                            } else {
                                                phi_502_ = _e6050;
                                                phi_531_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e6069 = phi_502_;
                                            let _e6071 = phi_531_;
                                            let _e6075 = (bitcast<i32>(_e6071.member) != 0i);
                                            if _e6075 {
                                                let _e6079 = ((_e3818 ^ (_e3818 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e6083 = ((_e6079 ^ (_e6079 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e6090 = (_e3818 ^ 2654435769u);
                                                let _e6094 = ((_e6090 ^ (_e6090 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e6098 = ((_e6094 ^ (_e6094 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e6116 = (0.000000059604645f * (f32(((2147483648u + (_e6071.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e6083 ^ (_e6083 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e6116 >= 1f) {
                                                    phi_14715_ = (_e6116 - 1f);
                                                } else {
                                                    phi_14715_ = _e6116;
                                                }
                                                let _e6120 = phi_14715_;
                                                let _e6122 = (0.000000059604645f * (f32(((2147483648u + (_e6071.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e6098 ^ (_e6098 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e6122 >= 1f) {
                                                    phi_14723_ = (_e6122 - 1f);
                                                } else {
                                                    phi_14723_ = _e6122;
                                                }
                                                let _e6126 = phi_14723_;
                                                if (_e6120 < _e6126) {
                                                    let _e6131 = (0.5f * _e6120);
                                                    phi_592_ = vec2<f32>(_e6131, (_e6126 - _e6131));
                                                } else {
                                                    let _e6128 = (0.5f * _e6126);
                                                    phi_592_ = vec2<f32>((_e6120 - _e6128), _e6128);
                                                }
                                                let _e6135 = phi_592_;
                                                let _e6147 = ((_e3795.member[0] + (_e5988 * _e6135.x)) + (_e5991 * _e6135.y));
                                                let _e6148 = ((_e3795.member[1] + (_e5989 * _e6135.x)) + (_e5992 * _e6135.y));
                                                let _e6149 = ((_e3795.member[2] + (_e5990 * _e6135.x)) + (_e5993 * _e6135.y));
                                                let _e6150 = (_e6147 - _e162.member[0]);
                                                let _e6151 = (_e6148 - _e162.member[1]);
                                                let _e6152 = (_e6149 - _e162.member[2]);
                                                let _e6157 = (((_e6150 * _e6150) + (_e6151 * _e6151)) + (_e6152 * _e6152));
                                                let _e6164 = (((_e162.member_2[0] * _e6150) + (_e162.member_2[1] * _e6151)) + (_e162.member_2[2] * _e6152));
                                                let _e6168 = (_e6157 * _e6157);
                                                let _e6171 = ((select(0f, _e6164, (_e6164 > 0f)) * _e6044) / select(0.000000000000000000000000000000000000011754944f, _e6168, (_e6168 > 0.000000000000000000000000000000000000011754944f)));
                                                if (_e6171 > 0f) {
                                                    let _e6174 = abs(_e6147);
                                                    let _e6175 = abs(_e6148);
                                                    let _e6177 = select(_e6175, _e6174, (_e6174 > _e6175));
                                                    let _e6178 = abs(_e6149);
                                                    let _e6184 = ((select(_e6178, _e6177, (_e6177 > _e6178)) + sqrt(_e3795.member_3)) * 0.0000009536743f);
                                                    let _e6188 = (_e6147 + (_e6033.x * _e6184));
                                                    let _e6189 = (_e6148 + (_e6033.y * _e6184));
                                                    let _e6190 = (_e6149 + (_e6033.z * _e6184));
                                                    if ((((_e162.member_4[0] * (_e6188 - _e162.member[0])) + (_e162.member_4[1] * (_e6189 - _e162.member[1]))) + (_e162.member_4[2] * (_e6190 - _e162.member[2]))) < 0f) {
                                                        phi_689_ = -(_e162.member_9);
                                                    } else {
                                                        phi_689_ = _e162.member_9;
                                                    }
                                                    let _e6202 = phi_689_;
                                                    let _e6206 = (_e162.member[0] + (_e162.member_4[0] * _e6202));
                                                    let _e6207 = (_e162.member[1] + (_e162.member_4[1] * _e6202));
                                                    let _e6208 = (_e162.member[2] + (_e162.member_4[2] * _e6202));
                                                    let _e6209 = (_e6188 - _e6206);
                                                    let _e6210 = (_e6189 - _e6207);
                                                    let _e6211 = (_e6190 - _e6208);
                                                    let _e6212 = abs(_e6209);
                                                    let _e6213 = abs(_e6210);
                                                    let _e6214 = abs(_e6211);
                                                    let _e6215 = (_e6212 > _e6213);
                                                    if _e6215 {
                                                        phi_715_ = (_e6212 > _e6214);
                                                    } else {
                                                        phi_715_ = (_e6213 > _e6214);
                                                    }
                                                    let _e6219 = phi_715_;
                                                    let _e6220 = select(1u, 0u, _e6215);
                                                    if _e6219 {
                                                        let _e6221 = (_e6220 + 1u);
                                                        phi_725_ = _e6221;
                                                        phi_728_ = select(true, false, (_e6221 == 2u));
                                                    } else {
                                                        phi_725_ = u32();
                                                        phi_728_ = false;
                                                    }
                                                    let _e6225 = phi_725_;
                                                    let _e6227 = phi_728_;
                                                    let _e6228 = select(true, false, _e6219);
                                                    let _e6229 = select(_e6225, 0u, _e6228);
                                                    let _e6231 = select(_e6227, true, _e6228);
                                                    if _e6231 {
                                                        phi_739_ = (_e6229 + 1u);
                                                    } else {
                                                        phi_739_ = 0u;
                                                    }
                                                    let _e6234 = phi_739_;
                                                    let _e6235 = select(_e6225, _e6229, _e6231);
                                                    let _e6236 = select(_e6220, select(_e6220, 2u, _e6228), _e6231);
                                                    local_19 = array<f32, 3>(_e6209, _e6210, _e6211);
                                                    local_20 = array<f32, 3>(_e6206, _e6207, _e6208);
                                                    let _e6239 = (_e6236 < 3u);
                                                    if _e6239 {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6241 = local_19[_e6236];
                                                    let _e6242 = (1f / _e6241);
                                                    let _e6243 = (_e6235 < 3u);
                                                    if _e6243 {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6245 = local_19[_e6235];
                                                    let _e6246 = (_e6245 * _e6242);
                                                    let _e6247 = (_e6234 < 3u);
                                                    if _e6247 {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6249 = local_19[_e6234];
                                                    let _e6250 = (_e6249 * _e6242);
                                                    if _e6243 {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6252 = local_20[_e6235];
                                                    if _e6247 {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6254 = local_20[_e6234];
                                                    if _e6239 {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6256 = local_20[_e6236];
                                                    if (0u < _e135) {
                                                    } else {
                                                        phi_17154_ = true;
                                                        break;
                                                    }
                                                    let _e6261 = nodes.member[0u].member_7[0u];
                                                    let _e6265 = nodes.member[0u].member_7[1u];
                                                    let _e6269 = nodes.member[0u].member_7[2u];
                                                    let _e6273 = nodes.member[0u].member_7[3u];
                                                    let _e6275 = abs((_e6206 - _e6261));
                                                    let _e6277 = abs((_e6207 - _e6265));
                                                    let _e6279 = select(_e6277, _e6275, (_e6275 > _e6277));
                                                    let _e6281 = abs((_e6208 - _e6269));
                                                    let _e6285 = ((select(_e6281, _e6279, (_e6279 > _e6281)) + _e6273) * 0.0000009536743f);
                                                    let _e6292 = (_e6285 + (abs(_e6206) * 0.00000023841858f));
                                                    let _e6293 = (_e6285 + (abs(_e6207) * 0.00000023841858f));
                                                    let _e6294 = (_e6285 + (abs(_e6208) * 0.00000023841858f));
                                                    let _e6295 = select(_e6213, _e6212, _e6215);
                                                    let _e6297 = select(_e6214, _e6295, (_e6295 > _e6214));
                                                    let _e6298 = (_e6297 * 0.000000000001f);
                                                    let _e6299 = (_e6206 + _e6292);
                                                    let _e6300 = (_e6207 + _e6293);
                                                    let _e6301 = (_e6208 + _e6294);
                                                    let _e6302 = (_e6206 - _e6292);
                                                    let _e6303 = (_e6207 - _e6293);
                                                    let _e6304 = (_e6208 - _e6294);
                                                    if (_e6212 > _e6298) {
                                                        phi_869_ = (1f / _e6209);
                                                    } else {
                                                        phi_869_ = (1000000000000f / _e6297);
                                                    }
                                                    let _e6309 = phi_869_;
                                                    if (_e6213 > _e6298) {
                                                        phi_877_ = (1f / _e6210);
                                                    } else {
                                                        phi_877_ = (1000000000000f / _e6297);
                                                    }
                                                    let _e6314 = phi_877_;
                                                    if (_e6214 > _e6298) {
                                                        phi_885_ = (1f / _e6211);
                                                    } else {
                                                        phi_885_ = (1000000000000f / _e6297);
                                                    }
                                                    let _e6319 = phi_885_;
                                                    local_18 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                    phi_17024_ = _e6048;
                                                    phi_888_ = 0u;
                                                    phi_891_ = 0u;
                                                    loop {
                                                        let _e6321 = phi_17024_;
                                                        let _e6323 = phi_888_;
                                                        let _e6325 = phi_891_;
                                                        let _e6326 = (_e6323 & 15u);
                                                        let _e6328 = (_e6323 >> bitcast<u32>(4u));
                                                        if (_e6326 == 0u) {
                                                            if (_e6328 < _e135) {
                                                            } else {
                                                                phi_17094_ = true;
                                                                phi_12428_ = bool();
                                                                break;
                                                            }
                                                            let _e6958 = nodes.member[_e6328].member;
                                                            let _e6967 = ((_e6958.x - _e6299) * _e6309);
                                                            let _e6968 = ((_e6958.y - _e6299) * _e6309);
                                                            let _e6969 = ((_e6958.z - _e6299) * _e6309);
                                                            let _e6970 = ((_e6958.w - _e6299) * _e6309);
                                                            let _e6973 = nodes.member[_e6328].member_3;
                                                            let _e6982 = ((_e6973.x - _e6302) * _e6309);
                                                            let _e6983 = ((_e6973.y - _e6302) * _e6309);
                                                            let _e6984 = ((_e6973.z - _e6302) * _e6309);
                                                            let _e6985 = ((_e6973.w - _e6302) * _e6309);
                                                            let _e6988 = nodes.member[_e6328].member_1;
                                                            let _e6997 = ((_e6988.x - _e6300) * _e6314);
                                                            let _e6998 = ((_e6988.y - _e6300) * _e6314);
                                                            let _e6999 = ((_e6988.z - _e6300) * _e6314);
                                                            let _e7000 = ((_e6988.w - _e6300) * _e6314);
                                                            let _e7003 = nodes.member[_e6328].member_4;
                                                            let _e7012 = ((_e7003.x - _e6303) * _e6314);
                                                            let _e7013 = ((_e7003.y - _e6303) * _e6314);
                                                            let _e7014 = ((_e7003.z - _e6303) * _e6314);
                                                            let _e7015 = ((_e7003.w - _e6303) * _e6314);
                                                            let _e7018 = nodes.member[_e6328].member_2;
                                                            let _e7027 = ((_e7018.x - _e6301) * _e6319);
                                                            let _e7028 = ((_e7018.y - _e6301) * _e6319);
                                                            let _e7029 = ((_e7018.z - _e6301) * _e6319);
                                                            let _e7030 = ((_e7018.w - _e6301) * _e6319);
                                                            let _e7033 = nodes.member[_e6328].member_5;
                                                            let _e7042 = ((_e7033.x - _e6304) * _e6319);
                                                            let _e7043 = ((_e7033.y - _e6304) * _e6319);
                                                            let _e7044 = ((_e7033.z - _e6304) * _e6319);
                                                            let _e7045 = ((_e7033.w - _e6304) * _e6319);
                                                            let _e7047 = select(_e6982, _e6967, (_e6967 < _e6982));
                                                            let _e7049 = select(_e6983, _e6968, (_e6968 < _e6983));
                                                            let _e7051 = select(_e6984, _e6969, (_e6969 < _e6984));
                                                            let _e7053 = select(_e6985, _e6970, (_e6970 < _e6985));
                                                            let _e7055 = select(_e7012, _e6997, (_e6997 < _e7012));
                                                            let _e7057 = select(_e7013, _e6998, (_e6998 < _e7013));
                                                            let _e7059 = select(_e7014, _e6999, (_e6999 < _e7014));
                                                            let _e7061 = select(_e7015, _e7000, (_e7000 < _e7015));
                                                            let _e7063 = select(_e7055, _e7047, (_e7047 > _e7055));
                                                            let _e7065 = select(_e7057, _e7049, (_e7049 > _e7057));
                                                            let _e7067 = select(_e7059, _e7051, (_e7051 > _e7059));
                                                            let _e7069 = select(_e7061, _e7053, (_e7053 > _e7061));
                                                            let _e7071 = select(_e7042, _e7027, (_e7027 < _e7042));
                                                            let _e7073 = select(_e7043, _e7028, (_e7028 < _e7043));
                                                            let _e7075 = select(_e7044, _e7029, (_e7029 < _e7044));
                                                            let _e7077 = select(_e7045, _e7030, (_e7030 < _e7045));
                                                            let _e7079 = select(_e7071, _e7063, (_e7063 > _e7071));
                                                            let _e7081 = select(_e7073, _e7065, (_e7065 > _e7073));
                                                            let _e7083 = select(_e7075, _e7067, (_e7067 > _e7075));
                                                            let _e7085 = select(_e7077, _e7069, (_e7069 > _e7077));
                                                            let _e7087 = select(0f, _e7079, (_e7079 > 0f));
                                                            let _e7089 = select(0f, _e7081, (_e7081 > 0f));
                                                            let _e7091 = select(0f, _e7083, (_e7083 > 0f));
                                                            let _e7093 = select(0f, _e7085, (_e7085 > 0f));
                                                            let _e7095 = select(_e6982, _e6967, (_e6967 > _e6982));
                                                            let _e7097 = select(_e6983, _e6968, (_e6968 > _e6983));
                                                            let _e7099 = select(_e6984, _e6969, (_e6969 > _e6984));
                                                            let _e7101 = select(_e6985, _e6970, (_e6970 > _e6985));
                                                            let _e7103 = select(_e7012, _e6997, (_e6997 > _e7012));
                                                            let _e7105 = select(_e7013, _e6998, (_e6998 > _e7013));
                                                            let _e7107 = select(_e7014, _e6999, (_e6999 > _e7014));
                                                            let _e7109 = select(_e7015, _e7000, (_e7000 > _e7015));
                                                            let _e7111 = select(_e7103, _e7095, (_e7095 < _e7103));
                                                            let _e7113 = select(_e7105, _e7097, (_e7097 < _e7105));
                                                            let _e7115 = select(_e7107, _e7099, (_e7099 < _e7107));
                                                            let _e7117 = select(_e7109, _e7101, (_e7101 < _e7109));
                                                            let _e7119 = select(_e7042, _e7027, (_e7027 > _e7042));
                                                            let _e7121 = select(_e7043, _e7028, (_e7028 > _e7043));
                                                            let _e7123 = select(_e7044, _e7029, (_e7029 > _e7044));
                                                            let _e7125 = select(_e7045, _e7030, (_e7030 > _e7045));
                                                            let _e7127 = select(_e7119, _e7111, (_e7111 < _e7119));
                                                            let _e7129 = select(_e7121, _e7113, (_e7113 < _e7121));
                                                            let _e7131 = select(_e7123, _e7115, (_e7115 < _e7123));
                                                            let _e7133 = select(_e7125, _e7117, (_e7117 < _e7125));
                                                            let _e7153 = nodes.member[_e6328].member_6[0u];
                                                            let _e7157 = nodes.member[_e6328].member_6[1u];
                                                            let _e7161 = nodes.member[_e6328].member_6[2u];
                                                            let _e7165 = nodes.member[_e6328].member_6[3u];
                                                            if (select(340282350000000000000000000000000000000f, _e7093, (_e7093 <= select(0.9999995f, _e7133, (_e7133 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e6325 < 64u) {
                                                                } else {
                                                                    phi_17094_ = true;
                                                                    phi_12428_ = bool();
                                                                    break;
                                                                }
                                                                local_18[_e6325] = _e7165;
                                                                phi_1276_ = (_e6325 + 1u);
                                                            } else {
                                                                phi_1276_ = _e6325;
                                                            }
                                                            let _e7171 = phi_1276_;
                                                            if (select(340282350000000000000000000000000000000f, _e7091, (_e7091 <= select(0.9999995f, _e7131, (_e7131 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e7171 < 64u) {
                                                                } else {
                                                                    phi_17094_ = true;
                                                                    phi_12428_ = bool();
                                                                    break;
                                                                }
                                                                local_18[_e7171] = _e7161;
                                                                phi_1288_ = (_e7171 + 1u);
                                                            } else {
                                                                phi_1288_ = _e7171;
                                                            }
                                                            let _e7177 = phi_1288_;
                                                            if (select(340282350000000000000000000000000000000f, _e7089, (_e7089 <= select(0.9999995f, _e7129, (_e7129 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e7177 < 64u) {
                                                                } else {
                                                                    phi_17094_ = true;
                                                                    phi_12428_ = bool();
                                                                    break;
                                                                }
                                                                local_18[_e7177] = _e7157;
                                                                phi_1300_ = (_e7177 + 1u);
                                                            } else {
                                                                phi_1300_ = _e7177;
                                                            }
                                                            let _e7183 = phi_1300_;
                                                            if (select(340282350000000000000000000000000000000f, _e7087, (_e7087 <= select(0.9999995f, _e7127, (_e7127 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e7183 < 64u) {
                                                                } else {
                                                                    phi_17094_ = true;
                                                                    phi_12428_ = bool();
                                                                    break;
                                                                }
                                                                local_18[_e7183] = _e7153;
                                                                phi_1312_ = (_e7183 + 1u);
                                                            } else {
                                                                phi_1312_ = _e7183;
                                                            }
                                                            let _e7189 = phi_1312_;
                                                            phi_17096_ = _e6321;
                                                            phi_2004_ = _e7189;
                                                            phi_2005_ = true;
                                                        } else {
                                                            phi_1316_ = type_8(_e6328, (_e6328 + _e6326));
                                                            loop {
                                                                let _e6333 = phi_1316_;
                                                                if (_e6333.member < _e6333.member_1) {
                                                                    phi_1317_ = type_8((_e6333.member + 1u), _e6333.member_1);
                                                                    phi_1340_ = type_8(1u, _e6333.member);
                                                                } else {
                                                                    phi_1317_ = _e6333;
                                                                    phi_1340_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e6346 = phi_1317_;
                                                                let _e6348 = phi_1340_;
                                                                let _e6352 = (bitcast<i32>(_e6348.member) != 0i);
                                                                if _e6352 {
                                                                    let _e6353 = (_e6348.member_1 < _e138);
                                                                    if _e6353 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    if _e6239 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6357 = triangles.member[_e6348.member_1].member[_e6236];
                                                                    let _e6358 = (_e6357 - _e6256);
                                                                    if _e6239 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6362 = triangles.member[_e6348.member_1].member_2[_e6236];
                                                                    let _e6363 = (_e6362 - _e6256);
                                                                    if _e6239 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6367 = triangles.member[_e6348.member_1].member_4[_e6236];
                                                                    let _e6368 = (_e6367 - _e6256);
                                                                    if _e6243 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6372 = triangles.member[_e6348.member_1].member[_e6235];
                                                                    let _e6375 = ((_e6372 - _e6252) - (_e6246 * _e6358));
                                                                    if _e6247 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6379 = triangles.member[_e6348.member_1].member[_e6234];
                                                                    let _e6382 = ((_e6379 - _e6254) - (_e6250 * _e6358));
                                                                    if _e6243 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6386 = triangles.member[_e6348.member_1].member_2[_e6235];
                                                                    let _e6389 = ((_e6386 - _e6252) - (_e6246 * _e6363));
                                                                    if _e6247 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6393 = triangles.member[_e6348.member_1].member_2[_e6234];
                                                                    let _e6396 = ((_e6393 - _e6254) - (_e6250 * _e6363));
                                                                    if _e6243 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6400 = triangles.member[_e6348.member_1].member_4[_e6235];
                                                                    let _e6403 = ((_e6400 - _e6252) - (_e6246 * _e6368));
                                                                    if _e6247 {
                                                                    } else {
                                                                        phi_17020_ = true;
                                                                        phi_12427_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e6407 = triangles.member[_e6348.member_1].member_4[_e6234];
                                                                    let _e6410 = ((_e6407 - _e6254) - (_e6250 * _e6368));
                                                                    let _e6411 = (_e6403 * _e6396);
                                                                    let _e6412 = (_e6410 * _e6389);
                                                                    if (_e6411 != _e6412) {
                                                                        phi_1456_ = (_e6411 - _e6412);
                                                                    } else {
                                                                        let _e6414 = (_e6403 * 4097f);
                                                                        let _e6416 = (_e6414 - (_e6414 - _e6403));
                                                                        let _e6417 = (_e6396 * 4097f);
                                                                        let _e6419 = (_e6417 - (_e6417 - _e6396));
                                                                        let _e6420 = (_e6403 - _e6416);
                                                                        let _e6421 = (_e6396 - _e6419);
                                                                        let _e6430 = (_e6410 * 4097f);
                                                                        let _e6432 = (_e6430 - (_e6430 - _e6410));
                                                                        let _e6433 = (_e6389 * 4097f);
                                                                        let _e6435 = (_e6433 - (_e6433 - _e6389));
                                                                        let _e6436 = (_e6410 - _e6432);
                                                                        let _e6437 = (_e6389 - _e6435);
                                                                        phi_1456_ = ((((((_e6416 * _e6419) - _e6411) + (_e6416 * _e6421)) + (_e6420 * _e6419)) + (_e6420 * _e6421)) - (((((_e6432 * _e6435) - _e6412) + (_e6432 * _e6437)) + (_e6436 * _e6435)) + (_e6436 * _e6437)));
                                                                    }
                                                                    let _e6449 = phi_1456_;
                                                                    let _e6450 = (_e6375 * _e6410);
                                                                    let _e6451 = (_e6382 * _e6403);
                                                                    if (_e6450 != _e6451) {
                                                                        phi_1467_ = (_e6450 - _e6451);
                                                                    } else {
                                                                        let _e6453 = (_e6375 * 4097f);
                                                                        let _e6455 = (_e6453 - (_e6453 - _e6375));
                                                                        let _e6456 = (_e6410 * 4097f);
                                                                        let _e6458 = (_e6456 - (_e6456 - _e6410));
                                                                        let _e6459 = (_e6375 - _e6455);
                                                                        let _e6460 = (_e6410 - _e6458);
                                                                        let _e6469 = (_e6382 * 4097f);
                                                                        let _e6471 = (_e6469 - (_e6469 - _e6382));
                                                                        let _e6472 = (_e6403 * 4097f);
                                                                        let _e6474 = (_e6472 - (_e6472 - _e6403));
                                                                        let _e6475 = (_e6382 - _e6471);
                                                                        let _e6476 = (_e6403 - _e6474);
                                                                        phi_1467_ = ((((((_e6455 * _e6458) - _e6450) + (_e6455 * _e6460)) + (_e6459 * _e6458)) + (_e6459 * _e6460)) - (((((_e6471 * _e6474) - _e6451) + (_e6471 * _e6476)) + (_e6475 * _e6474)) + (_e6475 * _e6476)));
                                                                    }
                                                                    let _e6488 = phi_1467_;
                                                                    let _e6489 = (_e6389 * _e6382);
                                                                    let _e6490 = (_e6396 * _e6375);
                                                                    if (_e6489 != _e6490) {
                                                                        phi_1478_ = (_e6489 - _e6490);
                                                                    } else {
                                                                        let _e6492 = (_e6389 * 4097f);
                                                                        let _e6494 = (_e6492 - (_e6492 - _e6389));
                                                                        let _e6495 = (_e6382 * 4097f);
                                                                        let _e6497 = (_e6495 - (_e6495 - _e6382));
                                                                        let _e6498 = (_e6389 - _e6494);
                                                                        let _e6499 = (_e6382 - _e6497);
                                                                        let _e6508 = (_e6396 * 4097f);
                                                                        let _e6510 = (_e6508 - (_e6508 - _e6396));
                                                                        let _e6511 = (_e6375 * 4097f);
                                                                        let _e6513 = (_e6511 - (_e6511 - _e6375));
                                                                        let _e6514 = (_e6396 - _e6510);
                                                                        let _e6515 = (_e6375 - _e6513);
                                                                        phi_1478_ = ((((((_e6494 * _e6497) - _e6489) + (_e6494 * _e6499)) + (_e6498 * _e6497)) + (_e6498 * _e6499)) - (((((_e6510 * _e6513) - _e6490) + (_e6510 * _e6515)) + (_e6514 * _e6513)) + (_e6514 * _e6515)));
                                                                    }
                                                                    let _e6527 = phi_1478_;
                                                                    if (_e6449 < 0f) {
                                                                        phi_1496_ = f32();
                                                                        phi_1497_ = true;
                                                                    } else {
                                                                        if (_e6488 < 0f) {
                                                                            phi_1494_ = f32();
                                                                            phi_1495_ = true;
                                                                        } else {
                                                                            let _e6530 = (_e6527 < 0f);
                                                                            if _e6530 {
                                                                                phi_1493_ = f32();
                                                                            } else {
                                                                                phi_1493_ = ((_e6449 + _e6488) + _e6527);
                                                                            }
                                                                            let _e6534 = phi_1493_;
                                                                            phi_1494_ = _e6534;
                                                                            phi_1495_ = _e6530;
                                                                        }
                                                                        let _e6536 = phi_1494_;
                                                                        let _e6538 = phi_1495_;
                                                                        phi_1496_ = _e6536;
                                                                        phi_1497_ = _e6538;
                                                                    }
                                                                    let _e6540 = phi_1496_;
                                                                    let _e6542 = phi_1497_;
                                                                    if _e6542 {
                                                                        if (_e6449 > 0f) {
                                                                            phi_1518_ = f32();
                                                                            phi_1519_ = true;
                                                                            phi_1520_ = false;
                                                                        } else {
                                                                            let _e6544 = (_e6488 > 0f);
                                                                            if _e6544 {
                                                                                phi_1516_ = f32();
                                                                                phi_1517_ = false;
                                                                            } else {
                                                                                phi_1516_ = ((_e6449 + _e6488) + _e6527);
                                                                                phi_1517_ = select(true, false, (_e6527 > 0f));
                                                                            }
                                                                            let _e6550 = phi_1516_;
                                                                            let _e6552 = phi_1517_;
                                                                            phi_1518_ = _e6550;
                                                                            phi_1519_ = _e6544;
                                                                            phi_1520_ = _e6552;
                                                                        }
                                                                        let _e6554 = phi_1518_;
                                                                        let _e6556 = phi_1519_;
                                                                        let _e6558 = phi_1520_;
                                                                        phi_1525_ = _e6554;
                                                                        phi_1526_ = select(_e6558, false, _e6556);
                                                                    } else {
                                                                        phi_1525_ = _e6540;
                                                                        phi_1526_ = true;
                                                                    }
                                                                    let _e6561 = phi_1525_;
                                                                    let _e6563 = phi_1526_;
                                                                    if _e6563 {
                                                                        let _e6564 = (_e6561 == 0f);
                                                                        if _e6564 {
                                                                            phi_1614_ = array<f32, 3>();
                                                                            phi_1615_ = array<f32, 3>();
                                                                            phi_1616_ = false;
                                                                        } else {
                                                                            let _e6565 = (_e6358 * _e6242);
                                                                            let _e6566 = (_e6363 * _e6242);
                                                                            let _e6567 = (_e6368 * _e6242);
                                                                            let _e6570 = (1f / ((_e6449 + _e6488) + _e6527));
                                                                            let _e6571 = (_e6488 * _e6570);
                                                                            let _e6572 = (_e6527 * _e6570);
                                                                            let _e6578 = ((((_e6449 * _e6570) * _e6565) + (_e6571 * _e6566)) + (_e6572 * _e6567));
                                                                            let _e6579 = abs(_e6375);
                                                                            let _e6580 = abs(_e6389);
                                                                            let _e6582 = select(_e6580, _e6579, (_e6579 > _e6580));
                                                                            let _e6583 = abs(_e6403);
                                                                            let _e6586 = abs(_e6382);
                                                                            let _e6587 = abs(_e6396);
                                                                            let _e6589 = select(_e6587, _e6586, (_e6586 > _e6587));
                                                                            let _e6590 = abs(_e6410);
                                                                            let _e6594 = abs(_e6565);
                                                                            let _e6595 = abs(_e6566);
                                                                            let _e6597 = select(_e6595, _e6594, (_e6594 > _e6595));
                                                                            let _e6598 = abs(_e6567);
                                                                            let _e6605 = (((select(_e6583, _e6582, (_e6582 > _e6583)) * select(_e6590, _e6589, (_e6589 > _e6590))) * select(_e6598, _e6597, (_e6597 > _e6598))) <= (abs((_e6561 * _e6578)) * 256f));
                                                                            if _e6605 {
                                                                                phi_1612_ = array<f32, 3>(_e6578, _e6571, _e6572);
                                                                                phi_1613_ = array<f32, 3>();
                                                                            } else {
                                                                                let _e6607 = (_e6403 * 4097f);
                                                                                let _e6609 = (_e6607 - (_e6607 - _e6403));
                                                                                let _e6610 = (_e6396 * 4097f);
                                                                                let _e6612 = (_e6610 - (_e6610 - _e6396));
                                                                                let _e6613 = (_e6403 - _e6609);
                                                                                let _e6614 = (_e6396 - _e6612);
                                                                                let _e6623 = (_e6410 * 4097f);
                                                                                let _e6625 = (_e6623 - (_e6623 - _e6410));
                                                                                let _e6626 = (_e6389 * 4097f);
                                                                                let _e6628 = (_e6626 - (_e6626 - _e6389));
                                                                                let _e6629 = (_e6410 - _e6625);
                                                                                let _e6630 = (_e6389 - _e6628);
                                                                                let _e6640 = ((_e6411 - _e6412) + ((((((_e6609 * _e6612) - _e6411) + (_e6609 * _e6614)) + (_e6613 * _e6612)) + (_e6613 * _e6614)) - (((((_e6625 * _e6628) - _e6412) + (_e6625 * _e6630)) + (_e6629 * _e6628)) + (_e6629 * _e6630))));
                                                                                let _e6642 = (_e6375 * 4097f);
                                                                                let _e6644 = (_e6642 - (_e6642 - _e6375));
                                                                                let _e6645 = (_e6375 - _e6644);
                                                                                let _e6654 = (_e6382 * 4097f);
                                                                                let _e6656 = (_e6654 - (_e6654 - _e6382));
                                                                                let _e6657 = (_e6382 - _e6656);
                                                                                let _e6667 = ((_e6450 - _e6451) + ((((((_e6644 * _e6625) - _e6450) + (_e6644 * _e6629)) + (_e6645 * _e6625)) + (_e6645 * _e6629)) - (((((_e6656 * _e6609) - _e6451) + (_e6656 * _e6613)) + (_e6657 * _e6609)) + (_e6657 * _e6613))));
                                                                                let _e6686 = ((_e6489 - _e6490) + ((((((_e6628 * _e6656) - _e6489) + (_e6628 * _e6657)) + (_e6630 * _e6656)) + (_e6630 * _e6657)) - (((((_e6612 * _e6644) - _e6490) + (_e6612 * _e6645)) + (_e6614 * _e6644)) + (_e6614 * _e6645))));
                                                                                let _e6689 = (1f / ((_e6640 + _e6667) + _e6686));
                                                                                let _e6690 = (_e6667 * _e6689);
                                                                                let _e6691 = (_e6686 * _e6689);
                                                                                phi_1612_ = array<f32, 3>();
                                                                                phi_1613_ = array<f32, 3>(((((_e6640 * _e6689) * _e6565) + (_e6690 * _e6566)) + (_e6691 * _e6567)), _e6690, _e6691);
                                                                            }
                                                                            let _e6701 = phi_1612_;
                                                                            let _e6703 = phi_1613_;
                                                                            phi_1614_ = _e6701;
                                                                            phi_1615_ = _e6703;
                                                                            phi_1616_ = _e6605;
                                                                        }
                                                                        let _e6705 = phi_1614_;
                                                                        let _e6707 = phi_1615_;
                                                                        let _e6709 = phi_1616_;
                                                                        phi_1617_ = _e6705;
                                                                        phi_1618_ = _e6707;
                                                                        phi_1619_ = _e6564;
                                                                        phi_1620_ = _e6709;
                                                                    } else {
                                                                        phi_1617_ = array<f32, 3>();
                                                                        phi_1618_ = array<f32, 3>();
                                                                        phi_1619_ = true;
                                                                        phi_1620_ = false;
                                                                    }
                                                                    let _e6711 = phi_1617_;
                                                                    let _e6713 = phi_1618_;
                                                                    let _e6715 = phi_1619_;
                                                                    let _e6717 = phi_1620_;
                                                                    if _e6715 {
                                                                        phi_1625_ = array<f32, 3>(-1f, 0f, 0f);
                                                                    } else {
                                                                        phi_1625_ = _e6711;
                                                                    }
                                                                    let _e6719 = phi_1625_;
                                                                    if select(_e6717, true, _e6715) {
                                                                        phi_1630_ = _e6719;
                                                                    } else {
                                                                        phi_1630_ = _e6713;
                                                                    }
                                                                    let _e6722 = phi_1630_;
                                                                    let _e6726 = (_e6722[0] >= 0f);
                                                                    if _e6726 {
                                                                        let _e6727 = (_e6722[0] < 0.9999995f);
                                                                        if _e6727 {
                                                                            if _e6726 {
                                                                                if _e6353 {
                                                                                } else {
                                                                                    phi_17020_ = true;
                                                                                    phi_12427_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6730 = triangles.member[_e6348.member_1].member_3;
                                                                                if ((_e6730 & 1u) == 0u) {
                                                                                    phi_1962_ = true;
                                                                                } else {
                                                                                    if _e6353 {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6735 = triangles.member[_e6348.member_1].member_1;
                                                                                    let _e6736 = (_e6735 * 12u);
                                                                                    if ((256u + _e6736) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e6736 + 257u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e6736 + 258u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6743 = (_e6736 + 259u);
                                                                                    if (_e6743 < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6746 = surfaces.member[_e6743];
                                                                                    if ((_e6736 + 260u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e6736 + 261u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e6736 + 262u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6753 = (_e6736 + 263u);
                                                                                    if (_e6753 < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6756 = surfaces.member[_e6753];
                                                                                    let _e6757 = (_e6736 + 264u);
                                                                                    if (_e6757 < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6760 = surfaces.member[_e6757];
                                                                                    let _e6761 = bitcast<f32>(_e6760);
                                                                                    let _e6762 = (_e6736 + 265u);
                                                                                    if (_e6762 < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6765 = surfaces.member[_e6762];
                                                                                    let _e6766 = bitcast<f32>(_e6765);
                                                                                    if ((_e6736 + 266u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e6736 + 267u) < _e144) {
                                                                                    } else {
                                                                                        phi_17020_ = true;
                                                                                        phi_12427_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if (_e6746 == 4294967295u) {
                                                                                        phi_1957_ = (_e6761 < _e6766);
                                                                                    } else {
                                                                                        if (_e6348.member_1 < _e141) {
                                                                                        } else {
                                                                                            phi_17020_ = true;
                                                                                            phi_12427_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e6774 = ((1f - _e6722[1]) - _e6722[2]);
                                                                                        let _e6778 = attributes.member[_e6348.member_1].member[0u];
                                                                                        let _e6783 = attributes.member[_e6348.member_1].member[2u];
                                                                                        let _e6789 = attributes.member[_e6348.member_1].member[4u];
                                                                                        let _e6791 = (((_e6778 * _e6774) + (_e6783 * _e6722[1])) + (_e6789 * _e6722[2]));
                                                                                        let _e6795 = attributes.member[_e6348.member_1].member[1u];
                                                                                        let _e6800 = attributes.member[_e6348.member_1].member[3u];
                                                                                        let _e6806 = attributes.member[_e6348.member_1].member[5u];
                                                                                        let _e6808 = (((_e6795 * _e6774) + (_e6800 * _e6722[1])) + (_e6806 * _e6722[2]));
                                                                                        let _e6809 = (_e6756 & 65535u);
                                                                                        let _e6811 = (_e6756 >> bitcast<u32>(16i));
                                                                                        let _e6813 = (_e6791 - floor(_e6791));
                                                                                        let _e6818 = ((select(0f, _e6813, (_e6813 <= 1f)) * f32(_e6809)) - 0.5f);
                                                                                        let _e6819 = floor(_e6818);
                                                                                        let _e6820 = (_e6818 - _e6819);
                                                                                        let _e6821 = (_e6809 - 1u);
                                                                                        if (_e6819 < 0f) {
                                                                                            phi_1840_ = _e6821;
                                                                                        } else {
                                                                                            let _e6827 = select(select(u32(_e6819), 0u, (_e6819 < 0f)), 4294967295u, (_e6819 > 4294967000f));
                                                                                            phi_1840_ = select(_e6827, _e6821, (_e6821 < _e6827));
                                                                                        }
                                                                                        let _e6831 = phi_1840_;
                                                                                        if (_e6831 == _e6821) {
                                                                                            phi_1846_ = 0u;
                                                                                        } else {
                                                                                            phi_1846_ = (_e6831 + 1u);
                                                                                        }
                                                                                        let _e6835 = phi_1846_;
                                                                                        let _e6837 = (_e6808 - floor(_e6808));
                                                                                        let _e6842 = ((select(0f, _e6837, (_e6837 <= 1f)) * f32(_e6811)) - 0.5f);
                                                                                        let _e6843 = floor(_e6842);
                                                                                        let _e6844 = (_e6842 - _e6843);
                                                                                        let _e6845 = (_e6811 - 1u);
                                                                                        if (_e6843 < 0f) {
                                                                                            phi_1876_ = _e6845;
                                                                                        } else {
                                                                                            let _e6851 = select(select(u32(_e6843), 0u, (_e6843 < 0f)), 4294967295u, (_e6843 > 4294967000f));
                                                                                            phi_1876_ = select(_e6851, _e6845, (_e6845 < _e6851));
                                                                                        }
                                                                                        let _e6855 = phi_1876_;
                                                                                        if (_e6855 == _e6845) {
                                                                                            phi_1882_ = 0u;
                                                                                        } else {
                                                                                            phi_1882_ = (_e6855 + 1u);
                                                                                        }
                                                                                        let _e6859 = phi_1882_;
                                                                                        let _e6861 = (_e6746 + (_e6855 * _e6809));
                                                                                        let _e6863 = (_e6746 + (_e6859 * _e6809));
                                                                                        let _e6864 = (_e6861 + _e6831);
                                                                                        let _e6865 = (_e6861 + _e6835);
                                                                                        let _e6866 = (_e6863 + _e6831);
                                                                                        let _e6867 = (_e6863 + _e6835);
                                                                                        if (_e6864 < _e144) {
                                                                                        } else {
                                                                                            phi_17020_ = true;
                                                                                            phi_12427_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e6870 = surfaces.member[_e6864];
                                                                                        if (_e6865 < _e144) {
                                                                                        } else {
                                                                                            phi_17020_ = true;
                                                                                            phi_12427_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e6873 = surfaces.member[_e6865];
                                                                                        if (_e6866 < _e144) {
                                                                                        } else {
                                                                                            phi_17020_ = true;
                                                                                            phi_12427_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e6876 = surfaces.member[_e6866];
                                                                                        if (_e6867 < _e144) {
                                                                                        } else {
                                                                                            phi_17020_ = true;
                                                                                            phi_12427_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e6879 = surfaces.member[_e6867];
                                                                                        let _e6896 = (1f - _e6820);
                                                                                        phi_1957_ = ((_e6761 * (((((f32((_e6870 >> bitcast<u32>(24i))) * 0.003921569f) * _e6896) + ((f32((_e6873 >> bitcast<u32>(24i))) * 0.003921569f) * _e6820)) * (1f - _e6844)) + ((((f32((_e6876 >> bitcast<u32>(24i))) * 0.003921569f) * _e6896) + ((f32((_e6879 >> bitcast<u32>(24i))) * 0.003921569f) * _e6820)) * _e6844))) < _e6766);
                                                                                    }
                                                                                    let _e6911 = phi_1957_;
                                                                                    phi_1962_ = select(true, false, _e6911);
                                                                                }
                                                                                let _e6914 = phi_1962_;
                                                                                if _e6914 {
                                                                                    phi_1967_ = type_44(_e6722[0], _e6348.member_1, _e6722[1], _e6722[2]);
                                                                                } else {
                                                                                    phi_1967_ = type_44();
                                                                                }
                                                                                let _e6917 = phi_1967_;
                                                                                phi_1969_ = _e6917;
                                                                                phi_1971_ = select(true, false, _e6914);
                                                                            } else {
                                                                                phi_1969_ = type_44();
                                                                                phi_1971_ = false;
                                                                            }
                                                                            let _e6920 = phi_1969_;
                                                                            let _e6922 = phi_1971_;
                                                                            phi_1972_ = _e6920;
                                                                            phi_1974_ = select(true, false, _e6726);
                                                                            phi_1975_ = _e6922;
                                                                        } else {
                                                                            phi_1972_ = type_44();
                                                                            phi_1974_ = false;
                                                                            phi_1975_ = false;
                                                                        }
                                                                        let _e6925 = phi_1972_;
                                                                        let _e6927 = phi_1974_;
                                                                        let _e6929 = phi_1975_;
                                                                        phi_1976_ = _e6925;
                                                                        phi_1977_ = select(true, false, _e6727);
                                                                        phi_1978_ = _e6927;
                                                                        phi_1979_ = _e6929;
                                                                    } else {
                                                                        phi_1976_ = type_44();
                                                                        phi_1977_ = true;
                                                                        phi_1978_ = false;
                                                                        phi_1979_ = false;
                                                                    }
                                                                    let _e6932 = phi_1976_;
                                                                    let _e6934 = phi_1977_;
                                                                    let _e6936 = phi_1978_;
                                                                    let _e6938 = phi_1979_;
                                                                    if select(select(_e6938, false, _e6934), true, select(_e6936, true, _e6934)) {
                                                                        phi_1992_ = type_44(0.9999995f, 4294967295u, 0f, 0f);
                                                                    } else {
                                                                        phi_1992_ = _e6932;
                                                                    }
                                                                    let _e6943 = phi_1992_;
                                                                    phi_1999_ = select(true, false, (_e6943.member_1 != 4294967295u));
                                                                } else {
                                                                    phi_1999_ = false;
                                                                }
                                                                let _e6948 = phi_1999_;
                                                                continue;
                                                                continuing {
                                                                    phi_1316_ = _e6346;
                                                                    phi_17020_ = _e6321;
                                                                    phi_12427_ = select(true, false, _e6352);
                                                                    break if !(_e6948);
                                                                }
                                                            }
                                                            let _e6952 = phi_17020_;
                                                            let _e6954 = phi_12427_;
                                                            phi_17094_ = _e6952;
                                                            phi_12428_ = bool();
                                                            if _e6952 {
                                                                break;
                                                            }
                                                            phi_17096_ = _e6952;
                                                            phi_2004_ = _e6325;
                                                            phi_2005_ = _e6954;
                                                        }
                                                        let _e7191 = phi_17096_;
                                                        let _e7193 = phi_2004_;
                                                        let _e7195 = phi_2005_;
                                                        if _e7195 {
                                                            let _e7196 = (_e7193 == 0u);
                                                            if _e7196 {
                                                                phi_2021_ = u32();
                                                                phi_2022_ = u32();
                                                            } else {
                                                                let _e7197 = (_e7193 - 1u);
                                                                if (_e7197 < 64u) {
                                                                } else {
                                                                    phi_17094_ = true;
                                                                    phi_12428_ = bool();
                                                                    break;
                                                                }
                                                                let _e7200 = local_18[_e7197];
                                                                phi_2021_ = _e7200;
                                                                phi_2022_ = _e7197;
                                                            }
                                                            let _e7202 = phi_2021_;
                                                            let _e7204 = phi_2022_;
                                                            phi_889_ = _e7202;
                                                            phi_892_ = _e7204;
                                                            phi_2024_ = select(true, false, _e7196);
                                                            phi_2025_ = _e7196;
                                                        } else {
                                                            phi_889_ = u32();
                                                            phi_892_ = u32();
                                                            phi_2024_ = false;
                                                            phi_2025_ = false;
                                                        }
                                                        let _e7207 = phi_889_;
                                                        let _e7209 = phi_892_;
                                                        let _e7211 = phi_2024_;
                                                        let _e7213 = phi_2025_;
                                                        continue;
                                                        continuing {
                                                            phi_17024_ = _e7191;
                                                            phi_888_ = _e7207;
                                                            phi_891_ = _e7209;
                                                            phi_17094_ = _e7191;
                                                            phi_12428_ = _e7213;
                                                            break if !(_e7211);
                                                        }
                                                    }
                                                    let _e7216 = phi_17094_;
                                                    let _e7218 = phi_12428_;
                                                    phi_17154_ = _e7216;
                                                    if _e7216 {
                                                        break;
                                                    }
                                                    if !(select(false, true, select(true, false, _e7218))) {
                                                        phi_2039_ = (_e6054 + _e6171);
                                                    } else {
                                                        phi_2039_ = _e6054;
                                                    }
                                                    let _e7224 = phi_2039_;
                                                    phi_17156_ = _e7216;
                                                    phi_2040_ = _e7224;
                                                } else {
                                                    phi_17156_ = _e6048;
                                                    phi_2040_ = _e6054;
                                                }
                                                let _e7226 = phi_17156_;
                                                let _e7228 = phi_2040_;
                                                phi_17155_ = _e7226;
                                                phi_505_ = select(_e6157, _e6052, (_e6052 < _e6157));
                                                phi_507_ = _e7228;
                                                phi_509_ = (_e6056 + _e6171);
                                            } else {
                                                phi_17155_ = _e6048;
                                                phi_505_ = f32();
                                                phi_507_ = f32();
                                                phi_509_ = f32();
                                            }
                                            let _e7230 = phi_17155_;
                                            let _e7232 = phi_505_;
                                            let _e7234 = phi_507_;
                                            let _e7236 = phi_509_;
                                            continue;
                                            continuing {
                                                phi_17046_ = _e7230;
                                                phi_501_ = _e6069;
                                                phi_504_ = _e7232;
                                                phi_506_ = _e7234;
                                                phi_508_ = _e7236;
                                                phi_17154_ = _e7230;
                                                break if !(_e6075);
                                            }
                                        }
                                        let _e7239 = phi_17154_;
                                        phi_17160_ = _e7239;
                                        if _e7239 {
                                            break;
                                        }
                                        let _e7241 = local_25;
                                        if (_e7241 <= 0f) {
                                            phi_2069_ = 0f;
                                            phi_2070_ = f32();
                                            phi_2071_ = true;
                                        } else {
                                            if (_e184 == 1u) {
                                                phi_2059_ = f32();
                                                phi_2060_ = true;
                                            } else {
                                                let _e7246 = local_26;
                                                let _e7248 = (_e3795.member_3 < (0.01f * _e7246));
                                                if _e7248 {
                                                    phi_2058_ = f32();
                                                } else {
                                                    let _e7249 = (_e3795.member[0] - _e162.member[0]);
                                                    let _e7250 = (_e3795.member[1] - _e162.member[1]);
                                                    let _e7251 = (_e3795.member[2] - _e162.member[2]);
                                                    let _e7252 = (vec3<f32>(_e3795.member[0], _e3795.member[1], _e3795.member[2]) - _e169);
                                                    let _e7253 = (_e3795.member_2[0] - _e162.member[0]);
                                                    let _e7254 = (_e3795.member_2[1] - _e162.member[1]);
                                                    let _e7255 = (_e3795.member_2[2] - _e162.member[2]);
                                                    let _e7256 = (vec3<f32>(_e3795.member_2[0], _e3795.member_2[1], _e3795.member_2[2]) - _e169);
                                                    let _e7257 = (_e3795.member_4[0] - _e162.member[0]);
                                                    let _e7258 = (_e3795.member_4[1] - _e162.member[1]);
                                                    let _e7259 = (_e3795.member_4[2] - _e162.member[2]);
                                                    let _e7260 = (vec3<f32>(_e3795.member_4[0], _e3795.member_4[1], _e3795.member_4[2]) - _e169);
                                                    let _e7265 = (((_e162.member_2[0] * _e7249) + (_e162.member_2[1] * _e7250)) + (_e162.member_2[2] * _e7251));
                                                    let _e7270 = (((_e162.member_2[0] * _e7253) + (_e162.member_2[1] * _e7254)) + (_e162.member_2[2] * _e7255));
                                                    let _e7275 = (((_e162.member_2[0] * _e7257) + (_e162.member_2[1] * _e7258)) + (_e162.member_2[2] * _e7259));
                                                    let _e7276 = (_e7265 <= 0f);
                                                    if _e7276 {
                                                        phi_15033_ = select(true, false, (_e7270 <= 0f));
                                                    } else {
                                                        phi_15033_ = true;
                                                    }
                                                    let _e7280 = phi_15033_;
                                                    if _e7280 {
                                                        if _e7276 {
                                                            phi_15044_ = true;
                                                        } else {
                                                            phi_15044_ = (_e7270 <= 0f);
                                                        }
                                                        let _e7283 = phi_15044_;
                                                        if _e7283 {
                                                            let _e7288 = (_e7265 / (_e7265 - _e7270));
                                                            let _e7295 = vec3<f32>((_e7249 + ((_e7253 - _e7249) * _e7288)), (_e7250 + ((_e7254 - _e7250) * _e7288)), (_e7251 + ((_e7255 - _e7251) * _e7288)));
                                                            if _e7276 {
                                                                phi_15065_ = type_60(0f, vec3<f32>(0f, 0f, 0f), _e7295);
                                                            } else {
                                                                phi_15065_ = type_60(0f, _e7295, vec3<f32>(0f, 0f, 0f));
                                                            }
                                                            let _e7299 = phi_15065_;
                                                            let _e7300 = vec3(_e7276);
                                                            phi_15069_ = _e7299;
                                                            phi_15070_ = select(_e7295, _e7256, _e7300);
                                                            phi_15071_ = select(_e7252, _e7295, _e7300);
                                                        } else {
                                                            phi_15069_ = type_60(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                            phi_15070_ = _e7256;
                                                            phi_15071_ = _e7252;
                                                        }
                                                        let _e7304 = phi_15069_;
                                                        let _e7306 = phi_15070_;
                                                        let _e7308 = phi_15071_;
                                                        let _e7310 = abs(_e7308.x);
                                                        let _e7312 = abs(_e7308.y);
                                                        let _e7314 = select(_e7312, _e7310, (_e7310 > _e7312));
                                                        let _e7316 = abs(_e7308.z);
                                                        let _e7318 = select(_e7316, _e7314, (_e7314 > _e7316));
                                                        if (_e7318 > 0.000000000000000000000000000000000000011754944f) {
                                                            let _e7320 = (_e7318 < 340282350000000000000000000000000000000f);
                                                            if _e7320 {
                                                                let _e7321 = (_e7308.x / _e7318);
                                                                let _e7322 = (_e7308.y / _e7318);
                                                                let _e7323 = (_e7308.z / _e7318);
                                                                let _e7329 = sqrt((((_e7321 * _e7321) + (_e7322 * _e7322)) + (_e7323 * _e7323)));
                                                                phi_15111_ = vec3<f32>((_e7321 / _e7329), (_e7322 / _e7329), (_e7323 / _e7329));
                                                            } else {
                                                                phi_15111_ = vec3<f32>();
                                                            }
                                                            let _e7335 = phi_15111_;
                                                            phi_15114_ = _e7335;
                                                            phi_15115_ = select(true, false, _e7320);
                                                        } else {
                                                            phi_15114_ = vec3<f32>();
                                                            phi_15115_ = true;
                                                        }
                                                        let _e7338 = phi_15114_;
                                                        let _e7340 = phi_15115_;
                                                        let _e7342 = select(_e7338, vec3<f32>(0f, 0f, 0f), vec3(_e7340));
                                                        let _e7344 = abs(_e7306.x);
                                                        let _e7346 = abs(_e7306.y);
                                                        let _e7348 = select(_e7346, _e7344, (_e7344 > _e7346));
                                                        let _e7350 = abs(_e7306.z);
                                                        let _e7352 = select(_e7350, _e7348, (_e7348 > _e7350));
                                                        if (_e7352 > 0.000000000000000000000000000000000000011754944f) {
                                                            let _e7354 = (_e7352 < 340282350000000000000000000000000000000f);
                                                            if _e7354 {
                                                                let _e7355 = (_e7306.x / _e7352);
                                                                let _e7356 = (_e7306.y / _e7352);
                                                                let _e7357 = (_e7306.z / _e7352);
                                                                let _e7363 = sqrt((((_e7355 * _e7355) + (_e7356 * _e7356)) + (_e7357 * _e7357)));
                                                                phi_15159_ = vec3<f32>((_e7355 / _e7363), (_e7356 / _e7363), (_e7357 / _e7363));
                                                            } else {
                                                                phi_15159_ = vec3<f32>();
                                                            }
                                                            let _e7369 = phi_15159_;
                                                            phi_15162_ = _e7369;
                                                            phi_15163_ = select(true, false, _e7354);
                                                        } else {
                                                            phi_15162_ = vec3<f32>();
                                                            phi_15163_ = true;
                                                        }
                                                        let _e7372 = phi_15162_;
                                                        let _e7374 = phi_15163_;
                                                        let _e7376 = select(_e7372, vec3<f32>(0f, 0f, 0f), vec3(_e7374));
                                                        let _e7383 = ((_e7342.y * _e7376.z) - (_e7376.y * _e7342.z));
                                                        let _e7388 = ((_e7342.z * _e7376.x) - (_e7376.z * _e7342.x));
                                                        let _e7391 = ((_e7342.x * _e7376.y) - (_e7376.x * _e7342.y));
                                                        let _e7397 = sqrt((((_e7383 * _e7383) + (_e7388 * _e7388)) + (_e7391 * _e7391)));
                                                        if (_e7397 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_15277_ = 0f;
                                                        } else {
                                                            let _e7409 = (((_e7342.x * _e7376.x) + (_e7342.y * _e7376.y)) + (_e7342.z * _e7376.z));
                                                            let _e7410 = abs(_e7409);
                                                            let _e7411 = abs(_e7397);
                                                            let _e7412 = (_e7411 > _e7410);
                                                            let _e7413 = select(_e7410, _e7411, _e7412);
                                                            if (_e7413 > 0f) {
                                                                phi_15230_ = (select(_e7411, _e7410, _e7412) / _e7413);
                                                            } else {
                                                                phi_15230_ = 0f;
                                                            }
                                                            let _e7418 = phi_15230_;
                                                            let _e7419 = (_e7418 > 0.41421357f);
                                                            if _e7419 {
                                                                phi_15238_ = ((_e7418 - 1f) / (_e7418 + 1f));
                                                            } else {
                                                                phi_15238_ = _e7418;
                                                            }
                                                            let _e7424 = phi_15238_;
                                                            let _e7425 = (_e7424 * _e7424);
                                                            let _e7434 = (_e7424 + ((_e7424 * _e7425) * (-0.3333295f + (_e7425 * (0.19977711f + (_e7425 * (-0.13877685f + (_e7425 * 0.080537446f))))))));
                                                            if _e7419 {
                                                                phi_15253_ = (_e7434 + 0.7853982f);
                                                            } else {
                                                                phi_15253_ = _e7434;
                                                            }
                                                            let _e7437 = phi_15253_;
                                                            if _e7412 {
                                                                phi_15259_ = (1.5707964f - _e7437);
                                                            } else {
                                                                phi_15259_ = _e7437;
                                                            }
                                                            let _e7440 = phi_15259_;
                                                            if ((bitcast<u32>(_e7409) & 2147483648u) == 0u) {
                                                                phi_15267_ = _e7440;
                                                            } else {
                                                                phi_15267_ = (3.1415927f - _e7440);
                                                            }
                                                            let _e7446 = phi_15267_;
                                                            phi_15277_ = (((((_e162.member_2[0] * _e7383) + (_e162.member_2[1] * _e7388)) + (_e162.member_2[2] * _e7391)) / _e7397) * bitcast<f32>(((bitcast<u32>(_e7446) & 2147483647u) | (bitcast<u32>(_e7397) & 2147483648u))));
                                                        }
                                                        let _e7455 = phi_15277_;
                                                        phi_15282_ = type_60((_e7304.member + _e7455), _e7304.member_1, _e7304.member_2);
                                                    } else {
                                                        phi_15282_ = type_60(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                    }
                                                    let _e7463 = phi_15282_;
                                                    let _e7464 = (_e7270 <= 0f);
                                                    if _e7464 {
                                                        phi_15292_ = select(true, false, (_e7275 <= 0f));
                                                    } else {
                                                        phi_15292_ = true;
                                                    }
                                                    let _e7468 = phi_15292_;
                                                    if _e7468 {
                                                        if _e7464 {
                                                            phi_15303_ = true;
                                                        } else {
                                                            phi_15303_ = (_e7275 <= 0f);
                                                        }
                                                        let _e7471 = phi_15303_;
                                                        if _e7471 {
                                                            let _e7476 = (_e7270 / (_e7270 - _e7275));
                                                            let _e7483 = vec3<f32>((_e7253 + ((_e7257 - _e7253) * _e7476)), (_e7254 + ((_e7258 - _e7254) * _e7476)), (_e7255 + ((_e7259 - _e7255) * _e7476)));
                                                            if _e7464 {
                                                                phi_15324_ = type_60(_e7463.member, _e7463.member_1, _e7483);
                                                            } else {
                                                                phi_15324_ = type_60(_e7463.member, _e7483, _e7463.member_2);
                                                            }
                                                            let _e7493 = phi_15324_;
                                                            let _e7494 = vec3(_e7464);
                                                            phi_15328_ = _e7493;
                                                            phi_15329_ = select(_e7483, _e7260, _e7494);
                                                            phi_15330_ = select(_e7256, _e7483, _e7494);
                                                        } else {
                                                            phi_15328_ = _e7463;
                                                            phi_15329_ = _e7260;
                                                            phi_15330_ = _e7256;
                                                        }
                                                        let _e7498 = phi_15328_;
                                                        let _e7500 = phi_15329_;
                                                        let _e7502 = phi_15330_;
                                                        let _e7504 = abs(_e7502.x);
                                                        let _e7506 = abs(_e7502.y);
                                                        let _e7508 = select(_e7506, _e7504, (_e7504 > _e7506));
                                                        let _e7510 = abs(_e7502.z);
                                                        let _e7512 = select(_e7510, _e7508, (_e7508 > _e7510));
                                                        if (_e7512 > 0.000000000000000000000000000000000000011754944f) {
                                                            let _e7514 = (_e7512 < 340282350000000000000000000000000000000f);
                                                            if _e7514 {
                                                                let _e7515 = (_e7502.x / _e7512);
                                                                let _e7516 = (_e7502.y / _e7512);
                                                                let _e7517 = (_e7502.z / _e7512);
                                                                let _e7523 = sqrt((((_e7515 * _e7515) + (_e7516 * _e7516)) + (_e7517 * _e7517)));
                                                                phi_15370_ = vec3<f32>((_e7515 / _e7523), (_e7516 / _e7523), (_e7517 / _e7523));
                                                            } else {
                                                                phi_15370_ = vec3<f32>();
                                                            }
                                                            let _e7529 = phi_15370_;
                                                            phi_15373_ = _e7529;
                                                            phi_15374_ = select(true, false, _e7514);
                                                        } else {
                                                            phi_15373_ = vec3<f32>();
                                                            phi_15374_ = true;
                                                        }
                                                        let _e7532 = phi_15373_;
                                                        let _e7534 = phi_15374_;
                                                        let _e7536 = select(_e7532, vec3<f32>(0f, 0f, 0f), vec3(_e7534));
                                                        let _e7538 = abs(_e7500.x);
                                                        let _e7540 = abs(_e7500.y);
                                                        let _e7542 = select(_e7540, _e7538, (_e7538 > _e7540));
                                                        let _e7544 = abs(_e7500.z);
                                                        let _e7546 = select(_e7544, _e7542, (_e7542 > _e7544));
                                                        if (_e7546 > 0.000000000000000000000000000000000000011754944f) {
                                                            let _e7548 = (_e7546 < 340282350000000000000000000000000000000f);
                                                            if _e7548 {
                                                                let _e7549 = (_e7500.x / _e7546);
                                                                let _e7550 = (_e7500.y / _e7546);
                                                                let _e7551 = (_e7500.z / _e7546);
                                                                let _e7557 = sqrt((((_e7549 * _e7549) + (_e7550 * _e7550)) + (_e7551 * _e7551)));
                                                                phi_15418_ = vec3<f32>((_e7549 / _e7557), (_e7550 / _e7557), (_e7551 / _e7557));
                                                            } else {
                                                                phi_15418_ = vec3<f32>();
                                                            }
                                                            let _e7563 = phi_15418_;
                                                            phi_15421_ = _e7563;
                                                            phi_15422_ = select(true, false, _e7548);
                                                        } else {
                                                            phi_15421_ = vec3<f32>();
                                                            phi_15422_ = true;
                                                        }
                                                        let _e7566 = phi_15421_;
                                                        let _e7568 = phi_15422_;
                                                        let _e7570 = select(_e7566, vec3<f32>(0f, 0f, 0f), vec3(_e7568));
                                                        let _e7577 = ((_e7536.y * _e7570.z) - (_e7570.y * _e7536.z));
                                                        let _e7582 = ((_e7536.z * _e7570.x) - (_e7570.z * _e7536.x));
                                                        let _e7585 = ((_e7536.x * _e7570.y) - (_e7570.x * _e7536.y));
                                                        let _e7591 = sqrt((((_e7577 * _e7577) + (_e7582 * _e7582)) + (_e7585 * _e7585)));
                                                        if (_e7591 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_15536_ = 0f;
                                                        } else {
                                                            let _e7603 = (((_e7536.x * _e7570.x) + (_e7536.y * _e7570.y)) + (_e7536.z * _e7570.z));
                                                            let _e7604 = abs(_e7603);
                                                            let _e7605 = abs(_e7591);
                                                            let _e7606 = (_e7605 > _e7604);
                                                            let _e7607 = select(_e7604, _e7605, _e7606);
                                                            if (_e7607 > 0f) {
                                                                phi_15489_ = (select(_e7605, _e7604, _e7606) / _e7607);
                                                            } else {
                                                                phi_15489_ = 0f;
                                                            }
                                                            let _e7612 = phi_15489_;
                                                            let _e7613 = (_e7612 > 0.41421357f);
                                                            if _e7613 {
                                                                phi_15497_ = ((_e7612 - 1f) / (_e7612 + 1f));
                                                            } else {
                                                                phi_15497_ = _e7612;
                                                            }
                                                            let _e7618 = phi_15497_;
                                                            let _e7619 = (_e7618 * _e7618);
                                                            let _e7628 = (_e7618 + ((_e7618 * _e7619) * (-0.3333295f + (_e7619 * (0.19977711f + (_e7619 * (-0.13877685f + (_e7619 * 0.080537446f))))))));
                                                            if _e7613 {
                                                                phi_15512_ = (_e7628 + 0.7853982f);
                                                            } else {
                                                                phi_15512_ = _e7628;
                                                            }
                                                            let _e7631 = phi_15512_;
                                                            if _e7606 {
                                                                phi_15518_ = (1.5707964f - _e7631);
                                                            } else {
                                                                phi_15518_ = _e7631;
                                                            }
                                                            let _e7634 = phi_15518_;
                                                            if ((bitcast<u32>(_e7603) & 2147483648u) == 0u) {
                                                                phi_15526_ = _e7634;
                                                            } else {
                                                                phi_15526_ = (3.1415927f - _e7634);
                                                            }
                                                            let _e7640 = phi_15526_;
                                                            phi_15536_ = (((((_e162.member_2[0] * _e7577) + (_e162.member_2[1] * _e7582)) + (_e162.member_2[2] * _e7585)) / _e7591) * bitcast<f32>(((bitcast<u32>(_e7640) & 2147483647u) | (bitcast<u32>(_e7591) & 2147483648u))));
                                                        }
                                                        let _e7649 = phi_15536_;
                                                        phi_15541_ = type_60((_e7498.member + _e7649), _e7498.member_1, _e7498.member_2);
                                                    } else {
                                                        phi_15541_ = _e7463;
                                                    }
                                                    let _e7657 = phi_15541_;
                                                    let _e7658 = (_e7275 <= 0f);
                                                    if _e7658 {
                                                        phi_15551_ = select(true, false, _e7276);
                                                    } else {
                                                        phi_15551_ = true;
                                                    }
                                                    let _e7661 = phi_15551_;
                                                    if _e7661 {
                                                        if select(_e7276, true, _e7658) {
                                                            let _e7667 = (_e7275 / (_e7275 - _e7265));
                                                            let _e7674 = vec3<f32>((_e7257 + ((_e7249 - _e7257) * _e7667)), (_e7258 + ((_e7250 - _e7258) * _e7667)), (_e7259 + ((_e7251 - _e7259) * _e7667)));
                                                            if _e7658 {
                                                                phi_15583_ = type_60(_e7657.member, _e7657.member_1, _e7674);
                                                            } else {
                                                                phi_15583_ = type_60(_e7657.member, _e7674, _e7657.member_2);
                                                            }
                                                            let _e7684 = phi_15583_;
                                                            let _e7685 = vec3(_e7658);
                                                            phi_15587_ = _e7684;
                                                            phi_15588_ = select(_e7674, _e7252, _e7685);
                                                            phi_15589_ = select(_e7260, _e7674, _e7685);
                                                        } else {
                                                            phi_15587_ = _e7657;
                                                            phi_15588_ = _e7252;
                                                            phi_15589_ = _e7260;
                                                        }
                                                        let _e7689 = phi_15587_;
                                                        let _e7691 = phi_15588_;
                                                        let _e7693 = phi_15589_;
                                                        let _e7695 = abs(_e7693.x);
                                                        let _e7697 = abs(_e7693.y);
                                                        let _e7699 = select(_e7697, _e7695, (_e7695 > _e7697));
                                                        let _e7701 = abs(_e7693.z);
                                                        let _e7703 = select(_e7701, _e7699, (_e7699 > _e7701));
                                                        if (_e7703 > 0.000000000000000000000000000000000000011754944f) {
                                                            let _e7705 = (_e7703 < 340282350000000000000000000000000000000f);
                                                            if _e7705 {
                                                                let _e7706 = (_e7693.x / _e7703);
                                                                let _e7707 = (_e7693.y / _e7703);
                                                                let _e7708 = (_e7693.z / _e7703);
                                                                let _e7714 = sqrt((((_e7706 * _e7706) + (_e7707 * _e7707)) + (_e7708 * _e7708)));
                                                                phi_15629_ = vec3<f32>((_e7706 / _e7714), (_e7707 / _e7714), (_e7708 / _e7714));
                                                            } else {
                                                                phi_15629_ = vec3<f32>();
                                                            }
                                                            let _e7720 = phi_15629_;
                                                            phi_15632_ = _e7720;
                                                            phi_15633_ = select(true, false, _e7705);
                                                        } else {
                                                            phi_15632_ = vec3<f32>();
                                                            phi_15633_ = true;
                                                        }
                                                        let _e7723 = phi_15632_;
                                                        let _e7725 = phi_15633_;
                                                        let _e7727 = select(_e7723, vec3<f32>(0f, 0f, 0f), vec3(_e7725));
                                                        let _e7729 = abs(_e7691.x);
                                                        let _e7731 = abs(_e7691.y);
                                                        let _e7733 = select(_e7731, _e7729, (_e7729 > _e7731));
                                                        let _e7735 = abs(_e7691.z);
                                                        let _e7737 = select(_e7735, _e7733, (_e7733 > _e7735));
                                                        if (_e7737 > 0.000000000000000000000000000000000000011754944f) {
                                                            let _e7739 = (_e7737 < 340282350000000000000000000000000000000f);
                                                            if _e7739 {
                                                                let _e7740 = (_e7691.x / _e7737);
                                                                let _e7741 = (_e7691.y / _e7737);
                                                                let _e7742 = (_e7691.z / _e7737);
                                                                let _e7748 = sqrt((((_e7740 * _e7740) + (_e7741 * _e7741)) + (_e7742 * _e7742)));
                                                                phi_15677_ = vec3<f32>((_e7740 / _e7748), (_e7741 / _e7748), (_e7742 / _e7748));
                                                            } else {
                                                                phi_15677_ = vec3<f32>();
                                                            }
                                                            let _e7754 = phi_15677_;
                                                            phi_15680_ = _e7754;
                                                            phi_15681_ = select(true, false, _e7739);
                                                        } else {
                                                            phi_15680_ = vec3<f32>();
                                                            phi_15681_ = true;
                                                        }
                                                        let _e7757 = phi_15680_;
                                                        let _e7759 = phi_15681_;
                                                        let _e7761 = select(_e7757, vec3<f32>(0f, 0f, 0f), vec3(_e7759));
                                                        let _e7768 = ((_e7727.y * _e7761.z) - (_e7761.y * _e7727.z));
                                                        let _e7773 = ((_e7727.z * _e7761.x) - (_e7761.z * _e7727.x));
                                                        let _e7776 = ((_e7727.x * _e7761.y) - (_e7761.x * _e7727.y));
                                                        let _e7782 = sqrt((((_e7768 * _e7768) + (_e7773 * _e7773)) + (_e7776 * _e7776)));
                                                        if (_e7782 <= 0.000000000000000000000000000000000000011754944f) {
                                                            phi_15795_ = 0f;
                                                        } else {
                                                            let _e7794 = (((_e7727.x * _e7761.x) + (_e7727.y * _e7761.y)) + (_e7727.z * _e7761.z));
                                                            let _e7795 = abs(_e7794);
                                                            let _e7796 = abs(_e7782);
                                                            let _e7797 = (_e7796 > _e7795);
                                                            let _e7798 = select(_e7795, _e7796, _e7797);
                                                            if (_e7798 > 0f) {
                                                                phi_15748_ = (select(_e7796, _e7795, _e7797) / _e7798);
                                                            } else {
                                                                phi_15748_ = 0f;
                                                            }
                                                            let _e7803 = phi_15748_;
                                                            let _e7804 = (_e7803 > 0.41421357f);
                                                            if _e7804 {
                                                                phi_15756_ = ((_e7803 - 1f) / (_e7803 + 1f));
                                                            } else {
                                                                phi_15756_ = _e7803;
                                                            }
                                                            let _e7809 = phi_15756_;
                                                            let _e7810 = (_e7809 * _e7809);
                                                            let _e7819 = (_e7809 + ((_e7809 * _e7810) * (-0.3333295f + (_e7810 * (0.19977711f + (_e7810 * (-0.13877685f + (_e7810 * 0.080537446f))))))));
                                                            if _e7804 {
                                                                phi_15771_ = (_e7819 + 0.7853982f);
                                                            } else {
                                                                phi_15771_ = _e7819;
                                                            }
                                                            let _e7822 = phi_15771_;
                                                            if _e7797 {
                                                                phi_15777_ = (1.5707964f - _e7822);
                                                            } else {
                                                                phi_15777_ = _e7822;
                                                            }
                                                            let _e7825 = phi_15777_;
                                                            if ((bitcast<u32>(_e7794) & 2147483648u) == 0u) {
                                                                phi_15785_ = _e7825;
                                                            } else {
                                                                phi_15785_ = (3.1415927f - _e7825);
                                                            }
                                                            let _e7831 = phi_15785_;
                                                            phi_15795_ = (((((_e162.member_2[0] * _e7768) + (_e162.member_2[1] * _e7773)) + (_e162.member_2[2] * _e7776)) / _e7782) * bitcast<f32>(((bitcast<u32>(_e7831) & 2147483647u) | (bitcast<u32>(_e7782) & 2147483648u))));
                                                        }
                                                        let _e7840 = phi_15795_;
                                                        phi_15800_ = type_60((_e7689.member + _e7840), _e7689.member_1, _e7689.member_2);
                                                    } else {
                                                        phi_15800_ = _e7657;
                                                    }
                                                    let _e7848 = phi_15800_;
                                                    let _e7852 = abs(_e7848.member_1.x);
                                                    let _e7854 = abs(_e7848.member_1.y);
                                                    let _e7856 = select(_e7854, _e7852, (_e7852 > _e7854));
                                                    let _e7858 = abs(_e7848.member_1.z);
                                                    let _e7860 = select(_e7858, _e7856, (_e7856 > _e7858));
                                                    if (_e7860 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7862 = (_e7860 < 340282350000000000000000000000000000000f);
                                                        if _e7862 {
                                                            let _e7863 = (_e7848.member_1.x / _e7860);
                                                            let _e7864 = (_e7848.member_1.y / _e7860);
                                                            let _e7865 = (_e7848.member_1.z / _e7860);
                                                            let _e7871 = sqrt((((_e7863 * _e7863) + (_e7864 * _e7864)) + (_e7865 * _e7865)));
                                                            phi_15842_ = vec3<f32>((_e7863 / _e7871), (_e7864 / _e7871), (_e7865 / _e7871));
                                                        } else {
                                                            phi_15842_ = vec3<f32>();
                                                        }
                                                        let _e7877 = phi_15842_;
                                                        phi_15845_ = _e7877;
                                                        phi_15846_ = select(true, false, _e7862);
                                                    } else {
                                                        phi_15845_ = vec3<f32>();
                                                        phi_15846_ = true;
                                                    }
                                                    let _e7880 = phi_15845_;
                                                    let _e7882 = phi_15846_;
                                                    let _e7884 = select(_e7880, vec3<f32>(0f, 0f, 0f), vec3(_e7882));
                                                    let _e7886 = abs(_e7848.member_2.x);
                                                    let _e7888 = abs(_e7848.member_2.y);
                                                    let _e7890 = select(_e7888, _e7886, (_e7886 > _e7888));
                                                    let _e7892 = abs(_e7848.member_2.z);
                                                    let _e7894 = select(_e7892, _e7890, (_e7890 > _e7892));
                                                    if (_e7894 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7896 = (_e7894 < 340282350000000000000000000000000000000f);
                                                        if _e7896 {
                                                            let _e7897 = (_e7848.member_2.x / _e7894);
                                                            let _e7898 = (_e7848.member_2.y / _e7894);
                                                            let _e7899 = (_e7848.member_2.z / _e7894);
                                                            let _e7905 = sqrt((((_e7897 * _e7897) + (_e7898 * _e7898)) + (_e7899 * _e7899)));
                                                            phi_15890_ = vec3<f32>((_e7897 / _e7905), (_e7898 / _e7905), (_e7899 / _e7905));
                                                        } else {
                                                            phi_15890_ = vec3<f32>();
                                                        }
                                                        let _e7911 = phi_15890_;
                                                        phi_15893_ = _e7911;
                                                        phi_15894_ = select(true, false, _e7896);
                                                    } else {
                                                        phi_15893_ = vec3<f32>();
                                                        phi_15894_ = true;
                                                    }
                                                    let _e7914 = phi_15893_;
                                                    let _e7916 = phi_15894_;
                                                    let _e7918 = select(_e7914, vec3<f32>(0f, 0f, 0f), vec3(_e7916));
                                                    let _e7925 = ((_e7884.y * _e7918.z) - (_e7918.y * _e7884.z));
                                                    let _e7930 = ((_e7884.z * _e7918.x) - (_e7918.z * _e7884.x));
                                                    let _e7933 = ((_e7884.x * _e7918.y) - (_e7918.x * _e7884.y));
                                                    let _e7939 = sqrt((((_e7925 * _e7925) + (_e7930 * _e7930)) + (_e7933 * _e7933)));
                                                    if (_e7939 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_16008_ = 0f;
                                                    } else {
                                                        let _e7951 = (((_e7884.x * _e7918.x) + (_e7884.y * _e7918.y)) + (_e7884.z * _e7918.z));
                                                        let _e7952 = abs(_e7951);
                                                        let _e7953 = abs(_e7939);
                                                        let _e7954 = (_e7953 > _e7952);
                                                        let _e7955 = select(_e7952, _e7953, _e7954);
                                                        if (_e7955 > 0f) {
                                                            phi_15961_ = (select(_e7953, _e7952, _e7954) / _e7955);
                                                        } else {
                                                            phi_15961_ = 0f;
                                                        }
                                                        let _e7960 = phi_15961_;
                                                        let _e7961 = (_e7960 > 0.41421357f);
                                                        if _e7961 {
                                                            phi_15969_ = ((_e7960 - 1f) / (_e7960 + 1f));
                                                        } else {
                                                            phi_15969_ = _e7960;
                                                        }
                                                        let _e7966 = phi_15969_;
                                                        let _e7967 = (_e7966 * _e7966);
                                                        let _e7976 = (_e7966 + ((_e7966 * _e7967) * (-0.3333295f + (_e7967 * (0.19977711f + (_e7967 * (-0.13877685f + (_e7967 * 0.080537446f))))))));
                                                        if _e7961 {
                                                            phi_15984_ = (_e7976 + 0.7853982f);
                                                        } else {
                                                            phi_15984_ = _e7976;
                                                        }
                                                        let _e7979 = phi_15984_;
                                                        if _e7954 {
                                                            phi_15990_ = (1.5707964f - _e7979);
                                                        } else {
                                                            phi_15990_ = _e7979;
                                                        }
                                                        let _e7982 = phi_15990_;
                                                        if ((bitcast<u32>(_e7951) & 2147483648u) == 0u) {
                                                            phi_15998_ = _e7982;
                                                        } else {
                                                            phi_15998_ = (3.1415927f - _e7982);
                                                        }
                                                        let _e7988 = phi_15998_;
                                                        phi_16008_ = (((((_e162.member_2[0] * _e7925) + (_e162.member_2[1] * _e7930)) + (_e162.member_2[2] * _e7933)) / _e7939) * bitcast<f32>(((bitcast<u32>(_e7988) & 2147483647u) | (bitcast<u32>(_e7939) & 2147483648u))));
                                                    }
                                                    let _e7997 = phi_16008_;
                                                    let _e8003 = local_27;
                                                    let _e8005 = local_28;
                                                    phi_2058_ = ((abs((_e7848.member + _e7997)) * 0.5f) * (_e8003 / _e8005));
                                                }
                                                let _e8009 = phi_2058_;
                                                phi_2059_ = _e8009;
                                                phi_2060_ = _e7248;
                                            }
                                            let _e8011 = phi_2059_;
                                            let _e8013 = phi_2060_;
                                            if _e8013 {
                                                let _e8016 = local_29;
                                                phi_2068_ = ((_e8016 * _e3795.member_3) / f32(_e184));
                                            } else {
                                                phi_2068_ = f32();
                                            }
                                            let _e8021 = phi_2068_;
                                            phi_2069_ = _e8021;
                                            phi_2070_ = _e8011;
                                            phi_2071_ = _e8013;
                                        }
                                        let _e8023 = phi_2069_;
                                        let _e8025 = phi_2070_;
                                        let _e8027 = phi_2071_;
                                        phi_17176_ = _e7239;
                                        phi_2075_ = _e8023;
                                        phi_2076_ = _e8025;
                                        phi_2077_ = _e8027;
                                    }
                                    let _e8029 = phi_17176_;
                                    let _e8031 = phi_2075_;
                                    let _e8033 = phi_2076_;
                                    let _e8035 = phi_2077_;
                                    let _e8036 = select(_e8033, _e8031, _e8035);
                                    phi_17163_ = _e8029;
                                    phi_4927_ = vec3<f32>((_e3795.member_6[0] * _e8036), (_e3795.member_6[1] * _e8036), (_e3795.member_6[2] * _e8036));
                                    phi_4928_ = vec3<f32>();
                                    phi_4929_ = true;
                                } else {
                                    let _e3833 = (_e3795.member_1 == 2u);
                                    if _e3833 {
                                        let _e4926 = -(_e3795.member_2[0]);
                                        let _e4927 = -(_e3795.member_2[1]);
                                        let _e4928 = -(_e3795.member_2[2]);
                                        let _e4933 = (((_e162.member_2[0] * _e4926) + (_e162.member_2[1] * _e4927)) + (_e162.member_2[2] * _e4928));
                                        let _e4935 = select(0f, _e4933, (_e4933 > 0f));
                                        if (_e4935 > 0f) {
                                            if ((((_e162.member_4[0] * _e4926) + (_e162.member_4[1] * _e4927)) + (_e162.member_4[2] * _e4928)) < 0f) {
                                                phi_2121_ = -(_e162.member_9);
                                            } else {
                                                phi_2121_ = _e162.member_9;
                                            }
                                            let _e4945 = phi_2121_;
                                            let _e4949 = (_e162.member[0] + (_e162.member_4[0] * _e4945));
                                            let _e4950 = (_e162.member[1] + (_e162.member_4[1] * _e4945));
                                            let _e4951 = (_e162.member[2] + (_e162.member_4[2] * _e4945));
                                            let _e4952 = abs(_e4926);
                                            let _e4953 = abs(_e4927);
                                            let _e4954 = abs(_e4928);
                                            let _e4955 = (_e4952 > _e4953);
                                            if _e4955 {
                                                phi_2147_ = (_e4952 > _e4954);
                                            } else {
                                                phi_2147_ = (_e4953 > _e4954);
                                            }
                                            let _e4959 = phi_2147_;
                                            let _e4960 = select(1u, 0u, _e4955);
                                            if _e4959 {
                                                let _e4961 = (_e4960 + 1u);
                                                phi_2157_ = _e4961;
                                                phi_2160_ = select(true, false, (_e4961 == 2u));
                                            } else {
                                                phi_2157_ = u32();
                                                phi_2160_ = false;
                                            }
                                            let _e4965 = phi_2157_;
                                            let _e4967 = phi_2160_;
                                            let _e4968 = select(true, false, _e4959);
                                            let _e4969 = select(_e4965, 0u, _e4968);
                                            let _e4971 = select(_e4967, true, _e4968);
                                            if _e4971 {
                                                phi_2171_ = (_e4969 + 1u);
                                            } else {
                                                phi_2171_ = 0u;
                                            }
                                            let _e4974 = phi_2171_;
                                            let _e4975 = select(_e4965, _e4969, _e4971);
                                            let _e4976 = select(_e4960, select(_e4960, 2u, _e4968), _e4971);
                                            local_16 = array<f32, 3>(_e4926, _e4927, _e4928);
                                            local_17 = array<f32, 3>(_e4949, _e4950, _e4951);
                                            let _e4979 = (_e4976 < 3u);
                                            if _e4979 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e4981 = local_16[_e4976];
                                            let _e4982 = (1f / _e4981);
                                            let _e4983 = (_e4975 < 3u);
                                            if _e4983 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e4985 = local_16[_e4975];
                                            let _e4986 = (_e4985 * _e4982);
                                            let _e4987 = (_e4974 < 3u);
                                            if _e4987 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e4989 = local_16[_e4974];
                                            let _e4990 = (_e4989 * _e4982);
                                            if _e4983 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e4992 = local_17[_e4975];
                                            if _e4987 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e4994 = local_17[_e4974];
                                            if _e4979 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e4996 = local_17[_e4976];
                                            if (0u < _e135) {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e5001 = nodes.member[0u].member_7[0u];
                                            let _e5005 = nodes.member[0u].member_7[1u];
                                            let _e5009 = nodes.member[0u].member_7[2u];
                                            let _e5013 = nodes.member[0u].member_7[3u];
                                            let _e5015 = abs((_e4949 - _e5001));
                                            let _e5017 = abs((_e4950 - _e5005));
                                            let _e5019 = select(_e5017, _e5015, (_e5015 > _e5017));
                                            let _e5021 = abs((_e4951 - _e5009));
                                            let _e5025 = ((select(_e5021, _e5019, (_e5019 > _e5021)) + _e5013) * 0.0000009536743f);
                                            let _e5032 = (_e5025 + (abs(_e4949) * 0.00000023841858f));
                                            let _e5033 = (_e5025 + (abs(_e4950) * 0.00000023841858f));
                                            let _e5034 = (_e5025 + (abs(_e4951) * 0.00000023841858f));
                                            let _e5035 = select(_e4953, _e4952, _e4955);
                                            let _e5037 = select(_e4954, _e5035, (_e5035 > _e4954));
                                            let _e5038 = (_e5037 * 0.000000000001f);
                                            let _e5039 = (_e4949 + _e5032);
                                            let _e5040 = (_e4950 + _e5033);
                                            let _e5041 = (_e4951 + _e5034);
                                            let _e5042 = (_e4949 - _e5032);
                                            let _e5043 = (_e4950 - _e5033);
                                            let _e5044 = (_e4951 - _e5034);
                                            if (_e4952 > _e5038) {
                                                phi_2301_ = (-1f / _e3795.member_2[0]);
                                            } else {
                                                phi_2301_ = (1000000000000f / _e5037);
                                            }
                                            let _e5049 = phi_2301_;
                                            if (_e4953 > _e5038) {
                                                phi_2309_ = (-1f / _e3795.member_2[1]);
                                            } else {
                                                phi_2309_ = (1000000000000f / _e5037);
                                            }
                                            let _e5054 = phi_2309_;
                                            if (_e4954 > _e5038) {
                                                phi_2317_ = (-1f / _e3795.member_2[2]);
                                            } else {
                                                phi_2317_ = (1000000000000f / _e5037);
                                            }
                                            let _e5059 = phi_2317_;
                                            local_15 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_16904_ = _e3768;
                                            phi_2320_ = 0u;
                                            phi_2323_ = 0u;
                                            loop {
                                                let _e5061 = phi_16904_;
                                                let _e5063 = phi_2320_;
                                                let _e5065 = phi_2323_;
                                                let _e5066 = (_e5063 & 15u);
                                                let _e5068 = (_e5063 >> bitcast<u32>(4u));
                                                if (_e5066 == 0u) {
                                                    if (_e5068 < _e135) {
                                                    } else {
                                                        phi_16960_ = true;
                                                        phi_12426_ = bool();
                                                        break;
                                                    }
                                                    let _e5698 = nodes.member[_e5068].member;
                                                    let _e5707 = ((_e5698.x - _e5039) * _e5049);
                                                    let _e5708 = ((_e5698.y - _e5039) * _e5049);
                                                    let _e5709 = ((_e5698.z - _e5039) * _e5049);
                                                    let _e5710 = ((_e5698.w - _e5039) * _e5049);
                                                    let _e5713 = nodes.member[_e5068].member_3;
                                                    let _e5722 = ((_e5713.x - _e5042) * _e5049);
                                                    let _e5723 = ((_e5713.y - _e5042) * _e5049);
                                                    let _e5724 = ((_e5713.z - _e5042) * _e5049);
                                                    let _e5725 = ((_e5713.w - _e5042) * _e5049);
                                                    let _e5728 = nodes.member[_e5068].member_1;
                                                    let _e5737 = ((_e5728.x - _e5040) * _e5054);
                                                    let _e5738 = ((_e5728.y - _e5040) * _e5054);
                                                    let _e5739 = ((_e5728.z - _e5040) * _e5054);
                                                    let _e5740 = ((_e5728.w - _e5040) * _e5054);
                                                    let _e5743 = nodes.member[_e5068].member_4;
                                                    let _e5752 = ((_e5743.x - _e5043) * _e5054);
                                                    let _e5753 = ((_e5743.y - _e5043) * _e5054);
                                                    let _e5754 = ((_e5743.z - _e5043) * _e5054);
                                                    let _e5755 = ((_e5743.w - _e5043) * _e5054);
                                                    let _e5758 = nodes.member[_e5068].member_2;
                                                    let _e5767 = ((_e5758.x - _e5041) * _e5059);
                                                    let _e5768 = ((_e5758.y - _e5041) * _e5059);
                                                    let _e5769 = ((_e5758.z - _e5041) * _e5059);
                                                    let _e5770 = ((_e5758.w - _e5041) * _e5059);
                                                    let _e5773 = nodes.member[_e5068].member_5;
                                                    let _e5782 = ((_e5773.x - _e5044) * _e5059);
                                                    let _e5783 = ((_e5773.y - _e5044) * _e5059);
                                                    let _e5784 = ((_e5773.z - _e5044) * _e5059);
                                                    let _e5785 = ((_e5773.w - _e5044) * _e5059);
                                                    let _e5787 = select(_e5722, _e5707, (_e5707 < _e5722));
                                                    let _e5789 = select(_e5723, _e5708, (_e5708 < _e5723));
                                                    let _e5791 = select(_e5724, _e5709, (_e5709 < _e5724));
                                                    let _e5793 = select(_e5725, _e5710, (_e5710 < _e5725));
                                                    let _e5795 = select(_e5752, _e5737, (_e5737 < _e5752));
                                                    let _e5797 = select(_e5753, _e5738, (_e5738 < _e5753));
                                                    let _e5799 = select(_e5754, _e5739, (_e5739 < _e5754));
                                                    let _e5801 = select(_e5755, _e5740, (_e5740 < _e5755));
                                                    let _e5803 = select(_e5795, _e5787, (_e5787 > _e5795));
                                                    let _e5805 = select(_e5797, _e5789, (_e5789 > _e5797));
                                                    let _e5807 = select(_e5799, _e5791, (_e5791 > _e5799));
                                                    let _e5809 = select(_e5801, _e5793, (_e5793 > _e5801));
                                                    let _e5811 = select(_e5782, _e5767, (_e5767 < _e5782));
                                                    let _e5813 = select(_e5783, _e5768, (_e5768 < _e5783));
                                                    let _e5815 = select(_e5784, _e5769, (_e5769 < _e5784));
                                                    let _e5817 = select(_e5785, _e5770, (_e5770 < _e5785));
                                                    let _e5819 = select(_e5811, _e5803, (_e5803 > _e5811));
                                                    let _e5821 = select(_e5813, _e5805, (_e5805 > _e5813));
                                                    let _e5823 = select(_e5815, _e5807, (_e5807 > _e5815));
                                                    let _e5825 = select(_e5817, _e5809, (_e5809 > _e5817));
                                                    let _e5827 = select(0f, _e5819, (_e5819 > 0f));
                                                    let _e5829 = select(0f, _e5821, (_e5821 > 0f));
                                                    let _e5831 = select(0f, _e5823, (_e5823 > 0f));
                                                    let _e5833 = select(0f, _e5825, (_e5825 > 0f));
                                                    let _e5835 = select(_e5722, _e5707, (_e5707 > _e5722));
                                                    let _e5837 = select(_e5723, _e5708, (_e5708 > _e5723));
                                                    let _e5839 = select(_e5724, _e5709, (_e5709 > _e5724));
                                                    let _e5841 = select(_e5725, _e5710, (_e5710 > _e5725));
                                                    let _e5843 = select(_e5752, _e5737, (_e5737 > _e5752));
                                                    let _e5845 = select(_e5753, _e5738, (_e5738 > _e5753));
                                                    let _e5847 = select(_e5754, _e5739, (_e5739 > _e5754));
                                                    let _e5849 = select(_e5755, _e5740, (_e5740 > _e5755));
                                                    let _e5851 = select(_e5843, _e5835, (_e5835 < _e5843));
                                                    let _e5853 = select(_e5845, _e5837, (_e5837 < _e5845));
                                                    let _e5855 = select(_e5847, _e5839, (_e5839 < _e5847));
                                                    let _e5857 = select(_e5849, _e5841, (_e5841 < _e5849));
                                                    let _e5859 = select(_e5782, _e5767, (_e5767 > _e5782));
                                                    let _e5861 = select(_e5783, _e5768, (_e5768 > _e5783));
                                                    let _e5863 = select(_e5784, _e5769, (_e5769 > _e5784));
                                                    let _e5865 = select(_e5785, _e5770, (_e5770 > _e5785));
                                                    let _e5867 = select(_e5859, _e5851, (_e5851 < _e5859));
                                                    let _e5869 = select(_e5861, _e5853, (_e5853 < _e5861));
                                                    let _e5871 = select(_e5863, _e5855, (_e5855 < _e5863));
                                                    let _e5873 = select(_e5865, _e5857, (_e5857 < _e5865));
                                                    let _e5893 = nodes.member[_e5068].member_6[0u];
                                                    let _e5897 = nodes.member[_e5068].member_6[1u];
                                                    let _e5901 = nodes.member[_e5068].member_6[2u];
                                                    let _e5905 = nodes.member[_e5068].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e5833, (_e5833 <= select(340282350000000000000000000000000000000f, _e5873, (_e5873 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e5065 < 64u) {
                                                        } else {
                                                            phi_16960_ = true;
                                                            phi_12426_ = bool();
                                                            break;
                                                        }
                                                        local_15[_e5065] = _e5905;
                                                        phi_2708_ = (_e5065 + 1u);
                                                    } else {
                                                        phi_2708_ = _e5065;
                                                    }
                                                    let _e5911 = phi_2708_;
                                                    if (select(340282350000000000000000000000000000000f, _e5831, (_e5831 <= select(340282350000000000000000000000000000000f, _e5871, (_e5871 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e5911 < 64u) {
                                                        } else {
                                                            phi_16960_ = true;
                                                            phi_12426_ = bool();
                                                            break;
                                                        }
                                                        local_15[_e5911] = _e5901;
                                                        phi_2720_ = (_e5911 + 1u);
                                                    } else {
                                                        phi_2720_ = _e5911;
                                                    }
                                                    let _e5917 = phi_2720_;
                                                    if (select(340282350000000000000000000000000000000f, _e5829, (_e5829 <= select(340282350000000000000000000000000000000f, _e5869, (_e5869 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e5917 < 64u) {
                                                        } else {
                                                            phi_16960_ = true;
                                                            phi_12426_ = bool();
                                                            break;
                                                        }
                                                        local_15[_e5917] = _e5897;
                                                        phi_2732_ = (_e5917 + 1u);
                                                    } else {
                                                        phi_2732_ = _e5917;
                                                    }
                                                    let _e5923 = phi_2732_;
                                                    if (select(340282350000000000000000000000000000000f, _e5827, (_e5827 <= select(340282350000000000000000000000000000000f, _e5867, (_e5867 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e5923 < 64u) {
                                                        } else {
                                                            phi_16960_ = true;
                                                            phi_12426_ = bool();
                                                            break;
                                                        }
                                                        local_15[_e5923] = _e5893;
                                                        phi_2744_ = (_e5923 + 1u);
                                                    } else {
                                                        phi_2744_ = _e5923;
                                                    }
                                                    let _e5929 = phi_2744_;
                                                    phi_16962_ = _e5061;
                                                    phi_3436_ = _e5929;
                                                    phi_3437_ = true;
                                                } else {
                                                    phi_2748_ = type_8(_e5068, (_e5068 + _e5066));
                                                    loop {
                                                        let _e5073 = phi_2748_;
                                                        if (_e5073.member < _e5073.member_1) {
                                                            phi_2749_ = type_8((_e5073.member + 1u), _e5073.member_1);
                                                            phi_2772_ = type_8(1u, _e5073.member);
                                                        } else {
                                                            phi_2749_ = _e5073;
                                                            phi_2772_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e5086 = phi_2749_;
                                                        let _e5088 = phi_2772_;
                                                        let _e5092 = (bitcast<i32>(_e5088.member) != 0i);
                                                        if _e5092 {
                                                            let _e5093 = (_e5088.member_1 < _e138);
                                                            if _e5093 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            if _e4979 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5097 = triangles.member[_e5088.member_1].member[_e4976];
                                                            let _e5098 = (_e5097 - _e4996);
                                                            if _e4979 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5102 = triangles.member[_e5088.member_1].member_2[_e4976];
                                                            let _e5103 = (_e5102 - _e4996);
                                                            if _e4979 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5107 = triangles.member[_e5088.member_1].member_4[_e4976];
                                                            let _e5108 = (_e5107 - _e4996);
                                                            if _e4983 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5112 = triangles.member[_e5088.member_1].member[_e4975];
                                                            let _e5115 = ((_e5112 - _e4992) - (_e4986 * _e5098));
                                                            if _e4987 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5119 = triangles.member[_e5088.member_1].member[_e4974];
                                                            let _e5122 = ((_e5119 - _e4994) - (_e4990 * _e5098));
                                                            if _e4983 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5126 = triangles.member[_e5088.member_1].member_2[_e4975];
                                                            let _e5129 = ((_e5126 - _e4992) - (_e4986 * _e5103));
                                                            if _e4987 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5133 = triangles.member[_e5088.member_1].member_2[_e4974];
                                                            let _e5136 = ((_e5133 - _e4994) - (_e4990 * _e5103));
                                                            if _e4983 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5140 = triangles.member[_e5088.member_1].member_4[_e4975];
                                                            let _e5143 = ((_e5140 - _e4992) - (_e4986 * _e5108));
                                                            if _e4987 {
                                                            } else {
                                                                phi_16900_ = true;
                                                                phi_12425_ = bool();
                                                                break;
                                                            }
                                                            let _e5147 = triangles.member[_e5088.member_1].member_4[_e4974];
                                                            let _e5150 = ((_e5147 - _e4994) - (_e4990 * _e5108));
                                                            let _e5151 = (_e5143 * _e5136);
                                                            let _e5152 = (_e5150 * _e5129);
                                                            if (_e5151 != _e5152) {
                                                                phi_2888_ = (_e5151 - _e5152);
                                                            } else {
                                                                let _e5154 = (_e5143 * 4097f);
                                                                let _e5156 = (_e5154 - (_e5154 - _e5143));
                                                                let _e5157 = (_e5136 * 4097f);
                                                                let _e5159 = (_e5157 - (_e5157 - _e5136));
                                                                let _e5160 = (_e5143 - _e5156);
                                                                let _e5161 = (_e5136 - _e5159);
                                                                let _e5170 = (_e5150 * 4097f);
                                                                let _e5172 = (_e5170 - (_e5170 - _e5150));
                                                                let _e5173 = (_e5129 * 4097f);
                                                                let _e5175 = (_e5173 - (_e5173 - _e5129));
                                                                let _e5176 = (_e5150 - _e5172);
                                                                let _e5177 = (_e5129 - _e5175);
                                                                phi_2888_ = ((((((_e5156 * _e5159) - _e5151) + (_e5156 * _e5161)) + (_e5160 * _e5159)) + (_e5160 * _e5161)) - (((((_e5172 * _e5175) - _e5152) + (_e5172 * _e5177)) + (_e5176 * _e5175)) + (_e5176 * _e5177)));
                                                            }
                                                            let _e5189 = phi_2888_;
                                                            let _e5190 = (_e5115 * _e5150);
                                                            let _e5191 = (_e5122 * _e5143);
                                                            if (_e5190 != _e5191) {
                                                                phi_2899_ = (_e5190 - _e5191);
                                                            } else {
                                                                let _e5193 = (_e5115 * 4097f);
                                                                let _e5195 = (_e5193 - (_e5193 - _e5115));
                                                                let _e5196 = (_e5150 * 4097f);
                                                                let _e5198 = (_e5196 - (_e5196 - _e5150));
                                                                let _e5199 = (_e5115 - _e5195);
                                                                let _e5200 = (_e5150 - _e5198);
                                                                let _e5209 = (_e5122 * 4097f);
                                                                let _e5211 = (_e5209 - (_e5209 - _e5122));
                                                                let _e5212 = (_e5143 * 4097f);
                                                                let _e5214 = (_e5212 - (_e5212 - _e5143));
                                                                let _e5215 = (_e5122 - _e5211);
                                                                let _e5216 = (_e5143 - _e5214);
                                                                phi_2899_ = ((((((_e5195 * _e5198) - _e5190) + (_e5195 * _e5200)) + (_e5199 * _e5198)) + (_e5199 * _e5200)) - (((((_e5211 * _e5214) - _e5191) + (_e5211 * _e5216)) + (_e5215 * _e5214)) + (_e5215 * _e5216)));
                                                            }
                                                            let _e5228 = phi_2899_;
                                                            let _e5229 = (_e5129 * _e5122);
                                                            let _e5230 = (_e5136 * _e5115);
                                                            if (_e5229 != _e5230) {
                                                                phi_2910_ = (_e5229 - _e5230);
                                                            } else {
                                                                let _e5232 = (_e5129 * 4097f);
                                                                let _e5234 = (_e5232 - (_e5232 - _e5129));
                                                                let _e5235 = (_e5122 * 4097f);
                                                                let _e5237 = (_e5235 - (_e5235 - _e5122));
                                                                let _e5238 = (_e5129 - _e5234);
                                                                let _e5239 = (_e5122 - _e5237);
                                                                let _e5248 = (_e5136 * 4097f);
                                                                let _e5250 = (_e5248 - (_e5248 - _e5136));
                                                                let _e5251 = (_e5115 * 4097f);
                                                                let _e5253 = (_e5251 - (_e5251 - _e5115));
                                                                let _e5254 = (_e5136 - _e5250);
                                                                let _e5255 = (_e5115 - _e5253);
                                                                phi_2910_ = ((((((_e5234 * _e5237) - _e5229) + (_e5234 * _e5239)) + (_e5238 * _e5237)) + (_e5238 * _e5239)) - (((((_e5250 * _e5253) - _e5230) + (_e5250 * _e5255)) + (_e5254 * _e5253)) + (_e5254 * _e5255)));
                                                            }
                                                            let _e5267 = phi_2910_;
                                                            if (_e5189 < 0f) {
                                                                phi_2928_ = f32();
                                                                phi_2929_ = true;
                                                            } else {
                                                                if (_e5228 < 0f) {
                                                                    phi_2926_ = f32();
                                                                    phi_2927_ = true;
                                                                } else {
                                                                    let _e5270 = (_e5267 < 0f);
                                                                    if _e5270 {
                                                                        phi_2925_ = f32();
                                                                    } else {
                                                                        phi_2925_ = ((_e5189 + _e5228) + _e5267);
                                                                    }
                                                                    let _e5274 = phi_2925_;
                                                                    phi_2926_ = _e5274;
                                                                    phi_2927_ = _e5270;
                                                                }
                                                                let _e5276 = phi_2926_;
                                                                let _e5278 = phi_2927_;
                                                                phi_2928_ = _e5276;
                                                                phi_2929_ = _e5278;
                                                            }
                                                            let _e5280 = phi_2928_;
                                                            let _e5282 = phi_2929_;
                                                            if _e5282 {
                                                                if (_e5189 > 0f) {
                                                                    phi_2950_ = f32();
                                                                    phi_2951_ = true;
                                                                    phi_2952_ = false;
                                                                } else {
                                                                    let _e5284 = (_e5228 > 0f);
                                                                    if _e5284 {
                                                                        phi_2948_ = f32();
                                                                        phi_2949_ = false;
                                                                    } else {
                                                                        phi_2948_ = ((_e5189 + _e5228) + _e5267);
                                                                        phi_2949_ = select(true, false, (_e5267 > 0f));
                                                                    }
                                                                    let _e5290 = phi_2948_;
                                                                    let _e5292 = phi_2949_;
                                                                    phi_2950_ = _e5290;
                                                                    phi_2951_ = _e5284;
                                                                    phi_2952_ = _e5292;
                                                                }
                                                                let _e5294 = phi_2950_;
                                                                let _e5296 = phi_2951_;
                                                                let _e5298 = phi_2952_;
                                                                phi_2957_ = _e5294;
                                                                phi_2958_ = select(_e5298, false, _e5296);
                                                            } else {
                                                                phi_2957_ = _e5280;
                                                                phi_2958_ = true;
                                                            }
                                                            let _e5301 = phi_2957_;
                                                            let _e5303 = phi_2958_;
                                                            if _e5303 {
                                                                let _e5304 = (_e5301 == 0f);
                                                                if _e5304 {
                                                                    phi_3046_ = array<f32, 3>();
                                                                    phi_3047_ = array<f32, 3>();
                                                                    phi_3048_ = false;
                                                                } else {
                                                                    let _e5305 = (_e5098 * _e4982);
                                                                    let _e5306 = (_e5103 * _e4982);
                                                                    let _e5307 = (_e5108 * _e4982);
                                                                    let _e5310 = (1f / ((_e5189 + _e5228) + _e5267));
                                                                    let _e5311 = (_e5228 * _e5310);
                                                                    let _e5312 = (_e5267 * _e5310);
                                                                    let _e5318 = ((((_e5189 * _e5310) * _e5305) + (_e5311 * _e5306)) + (_e5312 * _e5307));
                                                                    let _e5319 = abs(_e5115);
                                                                    let _e5320 = abs(_e5129);
                                                                    let _e5322 = select(_e5320, _e5319, (_e5319 > _e5320));
                                                                    let _e5323 = abs(_e5143);
                                                                    let _e5326 = abs(_e5122);
                                                                    let _e5327 = abs(_e5136);
                                                                    let _e5329 = select(_e5327, _e5326, (_e5326 > _e5327));
                                                                    let _e5330 = abs(_e5150);
                                                                    let _e5334 = abs(_e5305);
                                                                    let _e5335 = abs(_e5306);
                                                                    let _e5337 = select(_e5335, _e5334, (_e5334 > _e5335));
                                                                    let _e5338 = abs(_e5307);
                                                                    let _e5345 = (((select(_e5323, _e5322, (_e5322 > _e5323)) * select(_e5330, _e5329, (_e5329 > _e5330))) * select(_e5338, _e5337, (_e5337 > _e5338))) <= (abs((_e5301 * _e5318)) * 256f));
                                                                    if _e5345 {
                                                                        phi_3044_ = array<f32, 3>(_e5318, _e5311, _e5312);
                                                                        phi_3045_ = array<f32, 3>();
                                                                    } else {
                                                                        let _e5347 = (_e5143 * 4097f);
                                                                        let _e5349 = (_e5347 - (_e5347 - _e5143));
                                                                        let _e5350 = (_e5136 * 4097f);
                                                                        let _e5352 = (_e5350 - (_e5350 - _e5136));
                                                                        let _e5353 = (_e5143 - _e5349);
                                                                        let _e5354 = (_e5136 - _e5352);
                                                                        let _e5363 = (_e5150 * 4097f);
                                                                        let _e5365 = (_e5363 - (_e5363 - _e5150));
                                                                        let _e5366 = (_e5129 * 4097f);
                                                                        let _e5368 = (_e5366 - (_e5366 - _e5129));
                                                                        let _e5369 = (_e5150 - _e5365);
                                                                        let _e5370 = (_e5129 - _e5368);
                                                                        let _e5380 = ((_e5151 - _e5152) + ((((((_e5349 * _e5352) - _e5151) + (_e5349 * _e5354)) + (_e5353 * _e5352)) + (_e5353 * _e5354)) - (((((_e5365 * _e5368) - _e5152) + (_e5365 * _e5370)) + (_e5369 * _e5368)) + (_e5369 * _e5370))));
                                                                        let _e5382 = (_e5115 * 4097f);
                                                                        let _e5384 = (_e5382 - (_e5382 - _e5115));
                                                                        let _e5385 = (_e5115 - _e5384);
                                                                        let _e5394 = (_e5122 * 4097f);
                                                                        let _e5396 = (_e5394 - (_e5394 - _e5122));
                                                                        let _e5397 = (_e5122 - _e5396);
                                                                        let _e5407 = ((_e5190 - _e5191) + ((((((_e5384 * _e5365) - _e5190) + (_e5384 * _e5369)) + (_e5385 * _e5365)) + (_e5385 * _e5369)) - (((((_e5396 * _e5349) - _e5191) + (_e5396 * _e5353)) + (_e5397 * _e5349)) + (_e5397 * _e5353))));
                                                                        let _e5426 = ((_e5229 - _e5230) + ((((((_e5368 * _e5396) - _e5229) + (_e5368 * _e5397)) + (_e5370 * _e5396)) + (_e5370 * _e5397)) - (((((_e5352 * _e5384) - _e5230) + (_e5352 * _e5385)) + (_e5354 * _e5384)) + (_e5354 * _e5385))));
                                                                        let _e5429 = (1f / ((_e5380 + _e5407) + _e5426));
                                                                        let _e5430 = (_e5407 * _e5429);
                                                                        let _e5431 = (_e5426 * _e5429);
                                                                        phi_3044_ = array<f32, 3>();
                                                                        phi_3045_ = array<f32, 3>(((((_e5380 * _e5429) * _e5305) + (_e5430 * _e5306)) + (_e5431 * _e5307)), _e5430, _e5431);
                                                                    }
                                                                    let _e5441 = phi_3044_;
                                                                    let _e5443 = phi_3045_;
                                                                    phi_3046_ = _e5441;
                                                                    phi_3047_ = _e5443;
                                                                    phi_3048_ = _e5345;
                                                                }
                                                                let _e5445 = phi_3046_;
                                                                let _e5447 = phi_3047_;
                                                                let _e5449 = phi_3048_;
                                                                phi_3049_ = _e5445;
                                                                phi_3050_ = _e5447;
                                                                phi_3051_ = _e5304;
                                                                phi_3052_ = _e5449;
                                                            } else {
                                                                phi_3049_ = array<f32, 3>();
                                                                phi_3050_ = array<f32, 3>();
                                                                phi_3051_ = true;
                                                                phi_3052_ = false;
                                                            }
                                                            let _e5451 = phi_3049_;
                                                            let _e5453 = phi_3050_;
                                                            let _e5455 = phi_3051_;
                                                            let _e5457 = phi_3052_;
                                                            if _e5455 {
                                                                phi_3057_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_3057_ = _e5451;
                                                            }
                                                            let _e5459 = phi_3057_;
                                                            if select(_e5457, true, _e5455) {
                                                                phi_3062_ = _e5459;
                                                            } else {
                                                                phi_3062_ = _e5453;
                                                            }
                                                            let _e5462 = phi_3062_;
                                                            let _e5466 = (_e5462[0] >= 0f);
                                                            if _e5466 {
                                                                let _e5467 = (_e5462[0] < 340282350000000000000000000000000000000f);
                                                                if _e5467 {
                                                                    if _e5466 {
                                                                        if _e5093 {
                                                                        } else {
                                                                            phi_16900_ = true;
                                                                            phi_12425_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5470 = triangles.member[_e5088.member_1].member_3;
                                                                        if ((_e5470 & 1u) == 0u) {
                                                                            phi_3394_ = true;
                                                                        } else {
                                                                            if _e5093 {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5475 = triangles.member[_e5088.member_1].member_1;
                                                                            let _e5476 = (_e5475 * 12u);
                                                                            if ((256u + _e5476) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e5476 + 257u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e5476 + 258u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5483 = (_e5476 + 259u);
                                                                            if (_e5483 < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5486 = surfaces.member[_e5483];
                                                                            if ((_e5476 + 260u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e5476 + 261u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e5476 + 262u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5493 = (_e5476 + 263u);
                                                                            if (_e5493 < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5496 = surfaces.member[_e5493];
                                                                            let _e5497 = (_e5476 + 264u);
                                                                            if (_e5497 < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5500 = surfaces.member[_e5497];
                                                                            let _e5501 = bitcast<f32>(_e5500);
                                                                            let _e5502 = (_e5476 + 265u);
                                                                            if (_e5502 < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5505 = surfaces.member[_e5502];
                                                                            let _e5506 = bitcast<f32>(_e5505);
                                                                            if ((_e5476 + 266u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e5476 + 267u) < _e144) {
                                                                            } else {
                                                                                phi_16900_ = true;
                                                                                phi_12425_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e5486 == 4294967295u) {
                                                                                phi_3389_ = (_e5501 < _e5506);
                                                                            } else {
                                                                                if (_e5088.member_1 < _e141) {
                                                                                } else {
                                                                                    phi_16900_ = true;
                                                                                    phi_12425_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e5514 = ((1f - _e5462[1]) - _e5462[2]);
                                                                                let _e5518 = attributes.member[_e5088.member_1].member[0u];
                                                                                let _e5523 = attributes.member[_e5088.member_1].member[2u];
                                                                                let _e5529 = attributes.member[_e5088.member_1].member[4u];
                                                                                let _e5531 = (((_e5518 * _e5514) + (_e5523 * _e5462[1])) + (_e5529 * _e5462[2]));
                                                                                let _e5535 = attributes.member[_e5088.member_1].member[1u];
                                                                                let _e5540 = attributes.member[_e5088.member_1].member[3u];
                                                                                let _e5546 = attributes.member[_e5088.member_1].member[5u];
                                                                                let _e5548 = (((_e5535 * _e5514) + (_e5540 * _e5462[1])) + (_e5546 * _e5462[2]));
                                                                                let _e5549 = (_e5496 & 65535u);
                                                                                let _e5551 = (_e5496 >> bitcast<u32>(16i));
                                                                                let _e5553 = (_e5531 - floor(_e5531));
                                                                                let _e5558 = ((select(0f, _e5553, (_e5553 <= 1f)) * f32(_e5549)) - 0.5f);
                                                                                let _e5559 = floor(_e5558);
                                                                                let _e5560 = (_e5558 - _e5559);
                                                                                let _e5561 = (_e5549 - 1u);
                                                                                if (_e5559 < 0f) {
                                                                                    phi_3272_ = _e5561;
                                                                                } else {
                                                                                    let _e5567 = select(select(u32(_e5559), 0u, (_e5559 < 0f)), 4294967295u, (_e5559 > 4294967000f));
                                                                                    phi_3272_ = select(_e5567, _e5561, (_e5561 < _e5567));
                                                                                }
                                                                                let _e5571 = phi_3272_;
                                                                                if (_e5571 == _e5561) {
                                                                                    phi_3278_ = 0u;
                                                                                } else {
                                                                                    phi_3278_ = (_e5571 + 1u);
                                                                                }
                                                                                let _e5575 = phi_3278_;
                                                                                let _e5577 = (_e5548 - floor(_e5548));
                                                                                let _e5582 = ((select(0f, _e5577, (_e5577 <= 1f)) * f32(_e5551)) - 0.5f);
                                                                                let _e5583 = floor(_e5582);
                                                                                let _e5584 = (_e5582 - _e5583);
                                                                                let _e5585 = (_e5551 - 1u);
                                                                                if (_e5583 < 0f) {
                                                                                    phi_3308_ = _e5585;
                                                                                } else {
                                                                                    let _e5591 = select(select(u32(_e5583), 0u, (_e5583 < 0f)), 4294967295u, (_e5583 > 4294967000f));
                                                                                    phi_3308_ = select(_e5591, _e5585, (_e5585 < _e5591));
                                                                                }
                                                                                let _e5595 = phi_3308_;
                                                                                if (_e5595 == _e5585) {
                                                                                    phi_3314_ = 0u;
                                                                                } else {
                                                                                    phi_3314_ = (_e5595 + 1u);
                                                                                }
                                                                                let _e5599 = phi_3314_;
                                                                                let _e5601 = (_e5486 + (_e5595 * _e5549));
                                                                                let _e5603 = (_e5486 + (_e5599 * _e5549));
                                                                                let _e5604 = (_e5601 + _e5571);
                                                                                let _e5605 = (_e5601 + _e5575);
                                                                                let _e5606 = (_e5603 + _e5571);
                                                                                let _e5607 = (_e5603 + _e5575);
                                                                                if (_e5604 < _e144) {
                                                                                } else {
                                                                                    phi_16900_ = true;
                                                                                    phi_12425_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e5610 = surfaces.member[_e5604];
                                                                                if (_e5605 < _e144) {
                                                                                } else {
                                                                                    phi_16900_ = true;
                                                                                    phi_12425_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e5613 = surfaces.member[_e5605];
                                                                                if (_e5606 < _e144) {
                                                                                } else {
                                                                                    phi_16900_ = true;
                                                                                    phi_12425_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e5616 = surfaces.member[_e5606];
                                                                                if (_e5607 < _e144) {
                                                                                } else {
                                                                                    phi_16900_ = true;
                                                                                    phi_12425_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e5619 = surfaces.member[_e5607];
                                                                                let _e5636 = (1f - _e5560);
                                                                                phi_3389_ = ((_e5501 * (((((f32((_e5610 >> bitcast<u32>(24i))) * 0.003921569f) * _e5636) + ((f32((_e5613 >> bitcast<u32>(24i))) * 0.003921569f) * _e5560)) * (1f - _e5584)) + ((((f32((_e5616 >> bitcast<u32>(24i))) * 0.003921569f) * _e5636) + ((f32((_e5619 >> bitcast<u32>(24i))) * 0.003921569f) * _e5560)) * _e5584))) < _e5506);
                                                                            }
                                                                            let _e5651 = phi_3389_;
                                                                            phi_3394_ = select(true, false, _e5651);
                                                                        }
                                                                        let _e5654 = phi_3394_;
                                                                        if _e5654 {
                                                                            phi_3399_ = type_44(_e5462[0], _e5088.member_1, _e5462[1], _e5462[2]);
                                                                        } else {
                                                                            phi_3399_ = type_44();
                                                                        }
                                                                        let _e5657 = phi_3399_;
                                                                        phi_3401_ = _e5657;
                                                                        phi_3403_ = select(true, false, _e5654);
                                                                    } else {
                                                                        phi_3401_ = type_44();
                                                                        phi_3403_ = false;
                                                                    }
                                                                    let _e5660 = phi_3401_;
                                                                    let _e5662 = phi_3403_;
                                                                    phi_3404_ = _e5660;
                                                                    phi_3406_ = select(true, false, _e5466);
                                                                    phi_3407_ = _e5662;
                                                                } else {
                                                                    phi_3404_ = type_44();
                                                                    phi_3406_ = false;
                                                                    phi_3407_ = false;
                                                                }
                                                                let _e5665 = phi_3404_;
                                                                let _e5667 = phi_3406_;
                                                                let _e5669 = phi_3407_;
                                                                phi_3408_ = _e5665;
                                                                phi_3409_ = select(true, false, _e5467);
                                                                phi_3410_ = _e5667;
                                                                phi_3411_ = _e5669;
                                                            } else {
                                                                phi_3408_ = type_44();
                                                                phi_3409_ = true;
                                                                phi_3410_ = false;
                                                                phi_3411_ = false;
                                                            }
                                                            let _e5672 = phi_3408_;
                                                            let _e5674 = phi_3409_;
                                                            let _e5676 = phi_3410_;
                                                            let _e5678 = phi_3411_;
                                                            if select(select(_e5678, false, _e5674), true, select(_e5676, true, _e5674)) {
                                                                phi_3424_ = type_44(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_3424_ = _e5672;
                                                            }
                                                            let _e5683 = phi_3424_;
                                                            phi_3431_ = select(true, false, (_e5683.member_1 != 4294967295u));
                                                        } else {
                                                            phi_3431_ = false;
                                                        }
                                                        let _e5688 = phi_3431_;
                                                        continue;
                                                        continuing {
                                                            phi_2748_ = _e5086;
                                                            phi_16900_ = _e5061;
                                                            phi_12425_ = select(true, false, _e5092);
                                                            break if !(_e5688);
                                                        }
                                                    }
                                                    let _e5692 = phi_16900_;
                                                    let _e5694 = phi_12425_;
                                                    phi_16960_ = _e5692;
                                                    phi_12426_ = bool();
                                                    if _e5692 {
                                                        break;
                                                    }
                                                    phi_16962_ = _e5692;
                                                    phi_3436_ = _e5065;
                                                    phi_3437_ = _e5694;
                                                }
                                                let _e5931 = phi_16962_;
                                                let _e5933 = phi_3436_;
                                                let _e5935 = phi_3437_;
                                                if _e5935 {
                                                    let _e5936 = (_e5933 == 0u);
                                                    if _e5936 {
                                                        phi_3453_ = u32();
                                                        phi_3454_ = u32();
                                                    } else {
                                                        let _e5937 = (_e5933 - 1u);
                                                        if (_e5937 < 64u) {
                                                        } else {
                                                            phi_16960_ = true;
                                                            phi_12426_ = bool();
                                                            break;
                                                        }
                                                        let _e5940 = local_15[_e5937];
                                                        phi_3453_ = _e5940;
                                                        phi_3454_ = _e5937;
                                                    }
                                                    let _e5942 = phi_3453_;
                                                    let _e5944 = phi_3454_;
                                                    phi_2321_ = _e5942;
                                                    phi_2324_ = _e5944;
                                                    phi_3456_ = select(true, false, _e5936);
                                                    phi_3457_ = _e5936;
                                                } else {
                                                    phi_2321_ = u32();
                                                    phi_2324_ = u32();
                                                    phi_3456_ = false;
                                                    phi_3457_ = false;
                                                }
                                                let _e5947 = phi_2321_;
                                                let _e5949 = phi_2324_;
                                                let _e5951 = phi_3456_;
                                                let _e5953 = phi_3457_;
                                                continue;
                                                continuing {
                                                    phi_16904_ = _e5931;
                                                    phi_2320_ = _e5947;
                                                    phi_2323_ = _e5949;
                                                    phi_16960_ = _e5931;
                                                    phi_12426_ = _e5953;
                                                    break if !(_e5951);
                                                }
                                            }
                                            let _e5956 = phi_16960_;
                                            let _e5958 = phi_12426_;
                                            phi_17160_ = _e5956;
                                            if _e5956 {
                                                break;
                                            }
                                            let _e5960 = select(false, true, select(true, false, _e5958));
                                            if _e5960 {
                                                phi_3473_ = vec3<f32>();
                                            } else {
                                                phi_3473_ = vec3<f32>((_e3795.member_6[0] * _e4935), (_e3795.member_6[1] * _e4935), (_e3795.member_6[2] * _e4935));
                                            }
                                            let _e5966 = phi_3473_;
                                            phi_17171_ = _e5956;
                                            phi_3474_ = _e5966;
                                            phi_3475_ = _e5960;
                                        } else {
                                            phi_17171_ = _e3768;
                                            phi_3474_ = vec3<f32>();
                                            phi_3475_ = true;
                                        }
                                        let _e5968 = phi_17171_;
                                        let _e5970 = phi_3474_;
                                        let _e5972 = phi_3475_;
                                        phi_17164_ = _e5968;
                                        phi_4925_ = select(_e5970, vec3<f32>(0f, 0f, 0f), vec3(_e5972));
                                        phi_4926_ = vec3<f32>();
                                    } else {
                                        let _e3834 = (_e3795.member[0] - _e162.member[0]);
                                        let _e3835 = (_e3795.member[1] - _e162.member[1]);
                                        let _e3836 = (_e3795.member[2] - _e162.member[2]);
                                        let _e3842 = sqrt((((_e3834 * _e3834) + (_e3835 * _e3835)) + (_e3836 * _e3836)));
                                        let _e3847 = (((_e162.member_2[0] * _e3834) + (_e162.member_2[1] * _e3835)) + (_e162.member_2[2] * _e3836));
                                        let _e3851 = ((_e3842 * _e3842) * _e3842);
                                        let _e3854 = (select(0f, _e3847, (_e3847 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e3851, (_e3851 > 0.000000000000000000000000000000000000011754944f)));
                                        if (_e3795.member_1 == 1u) {
                                            let _e3870 = (_e3795.member_4[0] - _e3795.member_4[1]);
                                            let _e3873 = (((-((((_e3834 * _e3795.member_2[0]) + (_e3835 * _e3795.member_2[1])) + (_e3836 * _e3795.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e3842, (_e3842 > 0.000000000000000000000000000000000000011754944f))) - _e3795.member_4[1]) / select(0.001f, _e3870, (_e3870 > 0.001f)));
                                            let _e3875 = select(0f, _e3873, (_e3873 > 0f));
                                            let _e3877 = select(1f, _e3875, (_e3875 < 1f));
                                            phi_3546_ = (_e3854 * (_e3877 * _e3877));
                                        } else {
                                            phi_3546_ = _e3854;
                                        }
                                        let _e3881 = phi_3546_;
                                        if (_e3881 > 0f) {
                                            if ((((_e162.member_4[0] * _e3834) + (_e162.member_4[1] * _e3835)) + (_e162.member_4[2] * _e3836)) < 0f) {
                                                phi_3564_ = -(_e162.member_9);
                                            } else {
                                                phi_3564_ = _e162.member_9;
                                            }
                                            let _e3891 = phi_3564_;
                                            let _e3895 = (_e162.member[0] + (_e162.member_4[0] * _e3891));
                                            let _e3896 = (_e162.member[1] + (_e162.member_4[1] * _e3891));
                                            let _e3897 = (_e162.member[2] + (_e162.member_4[2] * _e3891));
                                            let _e3898 = (_e3795.member[0] - _e3895);
                                            let _e3899 = (_e3795.member[1] - _e3896);
                                            let _e3900 = (_e3795.member[2] - _e3897);
                                            let _e3901 = abs(_e3898);
                                            let _e3902 = abs(_e3899);
                                            let _e3903 = abs(_e3900);
                                            let _e3904 = (_e3901 > _e3902);
                                            if _e3904 {
                                                phi_3590_ = (_e3901 > _e3903);
                                            } else {
                                                phi_3590_ = (_e3902 > _e3903);
                                            }
                                            let _e3908 = phi_3590_;
                                            let _e3909 = select(1u, 0u, _e3904);
                                            if _e3908 {
                                                let _e3910 = (_e3909 + 1u);
                                                phi_3600_ = _e3910;
                                                phi_3603_ = select(true, false, (_e3910 == 2u));
                                            } else {
                                                phi_3600_ = u32();
                                                phi_3603_ = false;
                                            }
                                            let _e3914 = phi_3600_;
                                            let _e3916 = phi_3603_;
                                            let _e3917 = select(true, false, _e3908);
                                            let _e3918 = select(_e3914, 0u, _e3917);
                                            let _e3920 = select(_e3916, true, _e3917);
                                            if _e3920 {
                                                phi_3614_ = (_e3918 + 1u);
                                            } else {
                                                phi_3614_ = 0u;
                                            }
                                            let _e3923 = phi_3614_;
                                            let _e3924 = select(_e3914, _e3918, _e3920);
                                            let _e3925 = select(_e3909, select(_e3909, 2u, _e3917), _e3920);
                                            local_13 = array<f32, 3>(_e3898, _e3899, _e3900);
                                            local_14 = array<f32, 3>(_e3895, _e3896, _e3897);
                                            let _e3928 = (_e3925 < 3u);
                                            if _e3928 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3930 = local_13[_e3925];
                                            let _e3931 = (1f / _e3930);
                                            let _e3932 = (_e3924 < 3u);
                                            if _e3932 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3934 = local_13[_e3924];
                                            let _e3935 = (_e3934 * _e3931);
                                            let _e3936 = (_e3923 < 3u);
                                            if _e3936 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3938 = local_13[_e3923];
                                            let _e3939 = (_e3938 * _e3931);
                                            if _e3932 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3941 = local_14[_e3924];
                                            if _e3936 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3943 = local_14[_e3923];
                                            if _e3928 {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3945 = local_14[_e3925];
                                            if (0u < _e135) {
                                            } else {
                                                phi_17160_ = true;
                                                break;
                                            }
                                            let _e3950 = nodes.member[0u].member_7[0u];
                                            let _e3954 = nodes.member[0u].member_7[1u];
                                            let _e3958 = nodes.member[0u].member_7[2u];
                                            let _e3962 = nodes.member[0u].member_7[3u];
                                            let _e3964 = abs((_e3895 - _e3950));
                                            let _e3966 = abs((_e3896 - _e3954));
                                            let _e3968 = select(_e3966, _e3964, (_e3964 > _e3966));
                                            let _e3970 = abs((_e3897 - _e3958));
                                            let _e3974 = ((select(_e3970, _e3968, (_e3968 > _e3970)) + _e3962) * 0.0000009536743f);
                                            let _e3981 = (_e3974 + (abs(_e3895) * 0.00000023841858f));
                                            let _e3982 = (_e3974 + (abs(_e3896) * 0.00000023841858f));
                                            let _e3983 = (_e3974 + (abs(_e3897) * 0.00000023841858f));
                                            let _e3984 = select(_e3902, _e3901, _e3904);
                                            let _e3986 = select(_e3903, _e3984, (_e3984 > _e3903));
                                            let _e3987 = (_e3986 * 0.000000000001f);
                                            let _e3988 = (_e3895 + _e3981);
                                            let _e3989 = (_e3896 + _e3982);
                                            let _e3990 = (_e3897 + _e3983);
                                            let _e3991 = (_e3895 - _e3981);
                                            let _e3992 = (_e3896 - _e3982);
                                            let _e3993 = (_e3897 - _e3983);
                                            if (_e3901 > _e3987) {
                                                phi_3744_ = (1f / _e3898);
                                            } else {
                                                phi_3744_ = (1000000000000f / _e3986);
                                            }
                                            let _e3998 = phi_3744_;
                                            if (_e3902 > _e3987) {
                                                phi_3752_ = (1f / _e3899);
                                            } else {
                                                phi_3752_ = (1000000000000f / _e3986);
                                            }
                                            let _e4003 = phi_3752_;
                                            if (_e3903 > _e3987) {
                                                phi_3760_ = (1f / _e3900);
                                            } else {
                                                phi_3760_ = (1000000000000f / _e3986);
                                            }
                                            let _e4008 = phi_3760_;
                                            local_12 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_16776_ = _e3768;
                                            phi_3763_ = 0u;
                                            phi_3766_ = 0u;
                                            loop {
                                                let _e4010 = phi_16776_;
                                                let _e4012 = phi_3763_;
                                                let _e4014 = phi_3766_;
                                                let _e4015 = (_e4012 & 15u);
                                                let _e4017 = (_e4012 >> bitcast<u32>(4u));
                                                if (_e4015 == 0u) {
                                                    if (_e4017 < _e135) {
                                                    } else {
                                                        phi_16840_ = true;
                                                        phi_12424_ = bool();
                                                        break;
                                                    }
                                                    let _e4647 = nodes.member[_e4017].member;
                                                    let _e4656 = ((_e4647.x - _e3988) * _e3998);
                                                    let _e4657 = ((_e4647.y - _e3988) * _e3998);
                                                    let _e4658 = ((_e4647.z - _e3988) * _e3998);
                                                    let _e4659 = ((_e4647.w - _e3988) * _e3998);
                                                    let _e4662 = nodes.member[_e4017].member_3;
                                                    let _e4671 = ((_e4662.x - _e3991) * _e3998);
                                                    let _e4672 = ((_e4662.y - _e3991) * _e3998);
                                                    let _e4673 = ((_e4662.z - _e3991) * _e3998);
                                                    let _e4674 = ((_e4662.w - _e3991) * _e3998);
                                                    let _e4677 = nodes.member[_e4017].member_1;
                                                    let _e4686 = ((_e4677.x - _e3989) * _e4003);
                                                    let _e4687 = ((_e4677.y - _e3989) * _e4003);
                                                    let _e4688 = ((_e4677.z - _e3989) * _e4003);
                                                    let _e4689 = ((_e4677.w - _e3989) * _e4003);
                                                    let _e4692 = nodes.member[_e4017].member_4;
                                                    let _e4701 = ((_e4692.x - _e3992) * _e4003);
                                                    let _e4702 = ((_e4692.y - _e3992) * _e4003);
                                                    let _e4703 = ((_e4692.z - _e3992) * _e4003);
                                                    let _e4704 = ((_e4692.w - _e3992) * _e4003);
                                                    let _e4707 = nodes.member[_e4017].member_2;
                                                    let _e4716 = ((_e4707.x - _e3990) * _e4008);
                                                    let _e4717 = ((_e4707.y - _e3990) * _e4008);
                                                    let _e4718 = ((_e4707.z - _e3990) * _e4008);
                                                    let _e4719 = ((_e4707.w - _e3990) * _e4008);
                                                    let _e4722 = nodes.member[_e4017].member_5;
                                                    let _e4731 = ((_e4722.x - _e3993) * _e4008);
                                                    let _e4732 = ((_e4722.y - _e3993) * _e4008);
                                                    let _e4733 = ((_e4722.z - _e3993) * _e4008);
                                                    let _e4734 = ((_e4722.w - _e3993) * _e4008);
                                                    let _e4736 = select(_e4671, _e4656, (_e4656 < _e4671));
                                                    let _e4738 = select(_e4672, _e4657, (_e4657 < _e4672));
                                                    let _e4740 = select(_e4673, _e4658, (_e4658 < _e4673));
                                                    let _e4742 = select(_e4674, _e4659, (_e4659 < _e4674));
                                                    let _e4744 = select(_e4701, _e4686, (_e4686 < _e4701));
                                                    let _e4746 = select(_e4702, _e4687, (_e4687 < _e4702));
                                                    let _e4748 = select(_e4703, _e4688, (_e4688 < _e4703));
                                                    let _e4750 = select(_e4704, _e4689, (_e4689 < _e4704));
                                                    let _e4752 = select(_e4744, _e4736, (_e4736 > _e4744));
                                                    let _e4754 = select(_e4746, _e4738, (_e4738 > _e4746));
                                                    let _e4756 = select(_e4748, _e4740, (_e4740 > _e4748));
                                                    let _e4758 = select(_e4750, _e4742, (_e4742 > _e4750));
                                                    let _e4760 = select(_e4731, _e4716, (_e4716 < _e4731));
                                                    let _e4762 = select(_e4732, _e4717, (_e4717 < _e4732));
                                                    let _e4764 = select(_e4733, _e4718, (_e4718 < _e4733));
                                                    let _e4766 = select(_e4734, _e4719, (_e4719 < _e4734));
                                                    let _e4768 = select(_e4760, _e4752, (_e4752 > _e4760));
                                                    let _e4770 = select(_e4762, _e4754, (_e4754 > _e4762));
                                                    let _e4772 = select(_e4764, _e4756, (_e4756 > _e4764));
                                                    let _e4774 = select(_e4766, _e4758, (_e4758 > _e4766));
                                                    let _e4776 = select(0f, _e4768, (_e4768 > 0f));
                                                    let _e4778 = select(0f, _e4770, (_e4770 > 0f));
                                                    let _e4780 = select(0f, _e4772, (_e4772 > 0f));
                                                    let _e4782 = select(0f, _e4774, (_e4774 > 0f));
                                                    let _e4784 = select(_e4671, _e4656, (_e4656 > _e4671));
                                                    let _e4786 = select(_e4672, _e4657, (_e4657 > _e4672));
                                                    let _e4788 = select(_e4673, _e4658, (_e4658 > _e4673));
                                                    let _e4790 = select(_e4674, _e4659, (_e4659 > _e4674));
                                                    let _e4792 = select(_e4701, _e4686, (_e4686 > _e4701));
                                                    let _e4794 = select(_e4702, _e4687, (_e4687 > _e4702));
                                                    let _e4796 = select(_e4703, _e4688, (_e4688 > _e4703));
                                                    let _e4798 = select(_e4704, _e4689, (_e4689 > _e4704));
                                                    let _e4800 = select(_e4792, _e4784, (_e4784 < _e4792));
                                                    let _e4802 = select(_e4794, _e4786, (_e4786 < _e4794));
                                                    let _e4804 = select(_e4796, _e4788, (_e4788 < _e4796));
                                                    let _e4806 = select(_e4798, _e4790, (_e4790 < _e4798));
                                                    let _e4808 = select(_e4731, _e4716, (_e4716 > _e4731));
                                                    let _e4810 = select(_e4732, _e4717, (_e4717 > _e4732));
                                                    let _e4812 = select(_e4733, _e4718, (_e4718 > _e4733));
                                                    let _e4814 = select(_e4734, _e4719, (_e4719 > _e4734));
                                                    let _e4816 = select(_e4808, _e4800, (_e4800 < _e4808));
                                                    let _e4818 = select(_e4810, _e4802, (_e4802 < _e4810));
                                                    let _e4820 = select(_e4812, _e4804, (_e4804 < _e4812));
                                                    let _e4822 = select(_e4814, _e4806, (_e4806 < _e4814));
                                                    let _e4842 = nodes.member[_e4017].member_6[0u];
                                                    let _e4846 = nodes.member[_e4017].member_6[1u];
                                                    let _e4850 = nodes.member[_e4017].member_6[2u];
                                                    let _e4854 = nodes.member[_e4017].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e4782, (_e4782 <= select(0.9999995f, _e4822, (_e4822 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e4014 < 64u) {
                                                        } else {
                                                            phi_16840_ = true;
                                                            phi_12424_ = bool();
                                                            break;
                                                        }
                                                        local_12[_e4014] = _e4854;
                                                        phi_4151_ = (_e4014 + 1u);
                                                    } else {
                                                        phi_4151_ = _e4014;
                                                    }
                                                    let _e4860 = phi_4151_;
                                                    if (select(340282350000000000000000000000000000000f, _e4780, (_e4780 <= select(0.9999995f, _e4820, (_e4820 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e4860 < 64u) {
                                                        } else {
                                                            phi_16840_ = true;
                                                            phi_12424_ = bool();
                                                            break;
                                                        }
                                                        local_12[_e4860] = _e4850;
                                                        phi_4163_ = (_e4860 + 1u);
                                                    } else {
                                                        phi_4163_ = _e4860;
                                                    }
                                                    let _e4866 = phi_4163_;
                                                    if (select(340282350000000000000000000000000000000f, _e4778, (_e4778 <= select(0.9999995f, _e4818, (_e4818 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e4866 < 64u) {
                                                        } else {
                                                            phi_16840_ = true;
                                                            phi_12424_ = bool();
                                                            break;
                                                        }
                                                        local_12[_e4866] = _e4846;
                                                        phi_4175_ = (_e4866 + 1u);
                                                    } else {
                                                        phi_4175_ = _e4866;
                                                    }
                                                    let _e4872 = phi_4175_;
                                                    if (select(340282350000000000000000000000000000000f, _e4776, (_e4776 <= select(0.9999995f, _e4816, (_e4816 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e4872 < 64u) {
                                                        } else {
                                                            phi_16840_ = true;
                                                            phi_12424_ = bool();
                                                            break;
                                                        }
                                                        local_12[_e4872] = _e4842;
                                                        phi_4187_ = (_e4872 + 1u);
                                                    } else {
                                                        phi_4187_ = _e4872;
                                                    }
                                                    let _e4878 = phi_4187_;
                                                    phi_16842_ = _e4010;
                                                    phi_4879_ = _e4878;
                                                    phi_4880_ = true;
                                                } else {
                                                    phi_4191_ = type_8(_e4017, (_e4017 + _e4015));
                                                    loop {
                                                        let _e4022 = phi_4191_;
                                                        if (_e4022.member < _e4022.member_1) {
                                                            phi_4192_ = type_8((_e4022.member + 1u), _e4022.member_1);
                                                            phi_4215_ = type_8(1u, _e4022.member);
                                                        } else {
                                                            phi_4192_ = _e4022;
                                                            phi_4215_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e4035 = phi_4192_;
                                                        let _e4037 = phi_4215_;
                                                        let _e4041 = (bitcast<i32>(_e4037.member) != 0i);
                                                        if _e4041 {
                                                            let _e4042 = (_e4037.member_1 < _e138);
                                                            if _e4042 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            if _e3928 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4046 = triangles.member[_e4037.member_1].member[_e3925];
                                                            let _e4047 = (_e4046 - _e3945);
                                                            if _e3928 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4051 = triangles.member[_e4037.member_1].member_2[_e3925];
                                                            let _e4052 = (_e4051 - _e3945);
                                                            if _e3928 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4056 = triangles.member[_e4037.member_1].member_4[_e3925];
                                                            let _e4057 = (_e4056 - _e3945);
                                                            if _e3932 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4061 = triangles.member[_e4037.member_1].member[_e3924];
                                                            let _e4064 = ((_e4061 - _e3941) - (_e3935 * _e4047));
                                                            if _e3936 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4068 = triangles.member[_e4037.member_1].member[_e3923];
                                                            let _e4071 = ((_e4068 - _e3943) - (_e3939 * _e4047));
                                                            if _e3932 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4075 = triangles.member[_e4037.member_1].member_2[_e3924];
                                                            let _e4078 = ((_e4075 - _e3941) - (_e3935 * _e4052));
                                                            if _e3936 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4082 = triangles.member[_e4037.member_1].member_2[_e3923];
                                                            let _e4085 = ((_e4082 - _e3943) - (_e3939 * _e4052));
                                                            if _e3932 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4089 = triangles.member[_e4037.member_1].member_4[_e3924];
                                                            let _e4092 = ((_e4089 - _e3941) - (_e3935 * _e4057));
                                                            if _e3936 {
                                                            } else {
                                                                phi_16772_ = true;
                                                                phi_12423_ = bool();
                                                                break;
                                                            }
                                                            let _e4096 = triangles.member[_e4037.member_1].member_4[_e3923];
                                                            let _e4099 = ((_e4096 - _e3943) - (_e3939 * _e4057));
                                                            let _e4100 = (_e4092 * _e4085);
                                                            let _e4101 = (_e4099 * _e4078);
                                                            if (_e4100 != _e4101) {
                                                                phi_4331_ = (_e4100 - _e4101);
                                                            } else {
                                                                let _e4103 = (_e4092 * 4097f);
                                                                let _e4105 = (_e4103 - (_e4103 - _e4092));
                                                                let _e4106 = (_e4085 * 4097f);
                                                                let _e4108 = (_e4106 - (_e4106 - _e4085));
                                                                let _e4109 = (_e4092 - _e4105);
                                                                let _e4110 = (_e4085 - _e4108);
                                                                let _e4119 = (_e4099 * 4097f);
                                                                let _e4121 = (_e4119 - (_e4119 - _e4099));
                                                                let _e4122 = (_e4078 * 4097f);
                                                                let _e4124 = (_e4122 - (_e4122 - _e4078));
                                                                let _e4125 = (_e4099 - _e4121);
                                                                let _e4126 = (_e4078 - _e4124);
                                                                phi_4331_ = ((((((_e4105 * _e4108) - _e4100) + (_e4105 * _e4110)) + (_e4109 * _e4108)) + (_e4109 * _e4110)) - (((((_e4121 * _e4124) - _e4101) + (_e4121 * _e4126)) + (_e4125 * _e4124)) + (_e4125 * _e4126)));
                                                            }
                                                            let _e4138 = phi_4331_;
                                                            let _e4139 = (_e4064 * _e4099);
                                                            let _e4140 = (_e4071 * _e4092);
                                                            if (_e4139 != _e4140) {
                                                                phi_4342_ = (_e4139 - _e4140);
                                                            } else {
                                                                let _e4142 = (_e4064 * 4097f);
                                                                let _e4144 = (_e4142 - (_e4142 - _e4064));
                                                                let _e4145 = (_e4099 * 4097f);
                                                                let _e4147 = (_e4145 - (_e4145 - _e4099));
                                                                let _e4148 = (_e4064 - _e4144);
                                                                let _e4149 = (_e4099 - _e4147);
                                                                let _e4158 = (_e4071 * 4097f);
                                                                let _e4160 = (_e4158 - (_e4158 - _e4071));
                                                                let _e4161 = (_e4092 * 4097f);
                                                                let _e4163 = (_e4161 - (_e4161 - _e4092));
                                                                let _e4164 = (_e4071 - _e4160);
                                                                let _e4165 = (_e4092 - _e4163);
                                                                phi_4342_ = ((((((_e4144 * _e4147) - _e4139) + (_e4144 * _e4149)) + (_e4148 * _e4147)) + (_e4148 * _e4149)) - (((((_e4160 * _e4163) - _e4140) + (_e4160 * _e4165)) + (_e4164 * _e4163)) + (_e4164 * _e4165)));
                                                            }
                                                            let _e4177 = phi_4342_;
                                                            let _e4178 = (_e4078 * _e4071);
                                                            let _e4179 = (_e4085 * _e4064);
                                                            if (_e4178 != _e4179) {
                                                                phi_4353_ = (_e4178 - _e4179);
                                                            } else {
                                                                let _e4181 = (_e4078 * 4097f);
                                                                let _e4183 = (_e4181 - (_e4181 - _e4078));
                                                                let _e4184 = (_e4071 * 4097f);
                                                                let _e4186 = (_e4184 - (_e4184 - _e4071));
                                                                let _e4187 = (_e4078 - _e4183);
                                                                let _e4188 = (_e4071 - _e4186);
                                                                let _e4197 = (_e4085 * 4097f);
                                                                let _e4199 = (_e4197 - (_e4197 - _e4085));
                                                                let _e4200 = (_e4064 * 4097f);
                                                                let _e4202 = (_e4200 - (_e4200 - _e4064));
                                                                let _e4203 = (_e4085 - _e4199);
                                                                let _e4204 = (_e4064 - _e4202);
                                                                phi_4353_ = ((((((_e4183 * _e4186) - _e4178) + (_e4183 * _e4188)) + (_e4187 * _e4186)) + (_e4187 * _e4188)) - (((((_e4199 * _e4202) - _e4179) + (_e4199 * _e4204)) + (_e4203 * _e4202)) + (_e4203 * _e4204)));
                                                            }
                                                            let _e4216 = phi_4353_;
                                                            if (_e4138 < 0f) {
                                                                phi_4371_ = f32();
                                                                phi_4372_ = true;
                                                            } else {
                                                                if (_e4177 < 0f) {
                                                                    phi_4369_ = f32();
                                                                    phi_4370_ = true;
                                                                } else {
                                                                    let _e4219 = (_e4216 < 0f);
                                                                    if _e4219 {
                                                                        phi_4368_ = f32();
                                                                    } else {
                                                                        phi_4368_ = ((_e4138 + _e4177) + _e4216);
                                                                    }
                                                                    let _e4223 = phi_4368_;
                                                                    phi_4369_ = _e4223;
                                                                    phi_4370_ = _e4219;
                                                                }
                                                                let _e4225 = phi_4369_;
                                                                let _e4227 = phi_4370_;
                                                                phi_4371_ = _e4225;
                                                                phi_4372_ = _e4227;
                                                            }
                                                            let _e4229 = phi_4371_;
                                                            let _e4231 = phi_4372_;
                                                            if _e4231 {
                                                                if (_e4138 > 0f) {
                                                                    phi_4393_ = f32();
                                                                    phi_4394_ = true;
                                                                    phi_4395_ = false;
                                                                } else {
                                                                    let _e4233 = (_e4177 > 0f);
                                                                    if _e4233 {
                                                                        phi_4391_ = f32();
                                                                        phi_4392_ = false;
                                                                    } else {
                                                                        phi_4391_ = ((_e4138 + _e4177) + _e4216);
                                                                        phi_4392_ = select(true, false, (_e4216 > 0f));
                                                                    }
                                                                    let _e4239 = phi_4391_;
                                                                    let _e4241 = phi_4392_;
                                                                    phi_4393_ = _e4239;
                                                                    phi_4394_ = _e4233;
                                                                    phi_4395_ = _e4241;
                                                                }
                                                                let _e4243 = phi_4393_;
                                                                let _e4245 = phi_4394_;
                                                                let _e4247 = phi_4395_;
                                                                phi_4400_ = _e4243;
                                                                phi_4401_ = select(_e4247, false, _e4245);
                                                            } else {
                                                                phi_4400_ = _e4229;
                                                                phi_4401_ = true;
                                                            }
                                                            let _e4250 = phi_4400_;
                                                            let _e4252 = phi_4401_;
                                                            if _e4252 {
                                                                let _e4253 = (_e4250 == 0f);
                                                                if _e4253 {
                                                                    phi_4489_ = array<f32, 3>();
                                                                    phi_4490_ = array<f32, 3>();
                                                                    phi_4491_ = false;
                                                                } else {
                                                                    let _e4254 = (_e4047 * _e3931);
                                                                    let _e4255 = (_e4052 * _e3931);
                                                                    let _e4256 = (_e4057 * _e3931);
                                                                    let _e4259 = (1f / ((_e4138 + _e4177) + _e4216));
                                                                    let _e4260 = (_e4177 * _e4259);
                                                                    let _e4261 = (_e4216 * _e4259);
                                                                    let _e4267 = ((((_e4138 * _e4259) * _e4254) + (_e4260 * _e4255)) + (_e4261 * _e4256));
                                                                    let _e4268 = abs(_e4064);
                                                                    let _e4269 = abs(_e4078);
                                                                    let _e4271 = select(_e4269, _e4268, (_e4268 > _e4269));
                                                                    let _e4272 = abs(_e4092);
                                                                    let _e4275 = abs(_e4071);
                                                                    let _e4276 = abs(_e4085);
                                                                    let _e4278 = select(_e4276, _e4275, (_e4275 > _e4276));
                                                                    let _e4279 = abs(_e4099);
                                                                    let _e4283 = abs(_e4254);
                                                                    let _e4284 = abs(_e4255);
                                                                    let _e4286 = select(_e4284, _e4283, (_e4283 > _e4284));
                                                                    let _e4287 = abs(_e4256);
                                                                    let _e4294 = (((select(_e4272, _e4271, (_e4271 > _e4272)) * select(_e4279, _e4278, (_e4278 > _e4279))) * select(_e4287, _e4286, (_e4286 > _e4287))) <= (abs((_e4250 * _e4267)) * 256f));
                                                                    if _e4294 {
                                                                        phi_4487_ = array<f32, 3>(_e4267, _e4260, _e4261);
                                                                        phi_4488_ = array<f32, 3>();
                                                                    } else {
                                                                        let _e4296 = (_e4092 * 4097f);
                                                                        let _e4298 = (_e4296 - (_e4296 - _e4092));
                                                                        let _e4299 = (_e4085 * 4097f);
                                                                        let _e4301 = (_e4299 - (_e4299 - _e4085));
                                                                        let _e4302 = (_e4092 - _e4298);
                                                                        let _e4303 = (_e4085 - _e4301);
                                                                        let _e4312 = (_e4099 * 4097f);
                                                                        let _e4314 = (_e4312 - (_e4312 - _e4099));
                                                                        let _e4315 = (_e4078 * 4097f);
                                                                        let _e4317 = (_e4315 - (_e4315 - _e4078));
                                                                        let _e4318 = (_e4099 - _e4314);
                                                                        let _e4319 = (_e4078 - _e4317);
                                                                        let _e4329 = ((_e4100 - _e4101) + ((((((_e4298 * _e4301) - _e4100) + (_e4298 * _e4303)) + (_e4302 * _e4301)) + (_e4302 * _e4303)) - (((((_e4314 * _e4317) - _e4101) + (_e4314 * _e4319)) + (_e4318 * _e4317)) + (_e4318 * _e4319))));
                                                                        let _e4331 = (_e4064 * 4097f);
                                                                        let _e4333 = (_e4331 - (_e4331 - _e4064));
                                                                        let _e4334 = (_e4064 - _e4333);
                                                                        let _e4343 = (_e4071 * 4097f);
                                                                        let _e4345 = (_e4343 - (_e4343 - _e4071));
                                                                        let _e4346 = (_e4071 - _e4345);
                                                                        let _e4356 = ((_e4139 - _e4140) + ((((((_e4333 * _e4314) - _e4139) + (_e4333 * _e4318)) + (_e4334 * _e4314)) + (_e4334 * _e4318)) - (((((_e4345 * _e4298) - _e4140) + (_e4345 * _e4302)) + (_e4346 * _e4298)) + (_e4346 * _e4302))));
                                                                        let _e4375 = ((_e4178 - _e4179) + ((((((_e4317 * _e4345) - _e4178) + (_e4317 * _e4346)) + (_e4319 * _e4345)) + (_e4319 * _e4346)) - (((((_e4301 * _e4333) - _e4179) + (_e4301 * _e4334)) + (_e4303 * _e4333)) + (_e4303 * _e4334))));
                                                                        let _e4378 = (1f / ((_e4329 + _e4356) + _e4375));
                                                                        let _e4379 = (_e4356 * _e4378);
                                                                        let _e4380 = (_e4375 * _e4378);
                                                                        phi_4487_ = array<f32, 3>();
                                                                        phi_4488_ = array<f32, 3>(((((_e4329 * _e4378) * _e4254) + (_e4379 * _e4255)) + (_e4380 * _e4256)), _e4379, _e4380);
                                                                    }
                                                                    let _e4390 = phi_4487_;
                                                                    let _e4392 = phi_4488_;
                                                                    phi_4489_ = _e4390;
                                                                    phi_4490_ = _e4392;
                                                                    phi_4491_ = _e4294;
                                                                }
                                                                let _e4394 = phi_4489_;
                                                                let _e4396 = phi_4490_;
                                                                let _e4398 = phi_4491_;
                                                                phi_4492_ = _e4394;
                                                                phi_4493_ = _e4396;
                                                                phi_4494_ = _e4253;
                                                                phi_4495_ = _e4398;
                                                            } else {
                                                                phi_4492_ = array<f32, 3>();
                                                                phi_4493_ = array<f32, 3>();
                                                                phi_4494_ = true;
                                                                phi_4495_ = false;
                                                            }
                                                            let _e4400 = phi_4492_;
                                                            let _e4402 = phi_4493_;
                                                            let _e4404 = phi_4494_;
                                                            let _e4406 = phi_4495_;
                                                            if _e4404 {
                                                                phi_4500_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_4500_ = _e4400;
                                                            }
                                                            let _e4408 = phi_4500_;
                                                            if select(_e4406, true, _e4404) {
                                                                phi_4505_ = _e4408;
                                                            } else {
                                                                phi_4505_ = _e4402;
                                                            }
                                                            let _e4411 = phi_4505_;
                                                            let _e4415 = (_e4411[0] >= 0f);
                                                            if _e4415 {
                                                                let _e4416 = (_e4411[0] < 0.9999995f);
                                                                if _e4416 {
                                                                    if _e4415 {
                                                                        if _e4042 {
                                                                        } else {
                                                                            phi_16772_ = true;
                                                                            phi_12423_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4419 = triangles.member[_e4037.member_1].member_3;
                                                                        if ((_e4419 & 1u) == 0u) {
                                                                            phi_4837_ = true;
                                                                        } else {
                                                                            if _e4042 {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4424 = triangles.member[_e4037.member_1].member_1;
                                                                            let _e4425 = (_e4424 * 12u);
                                                                            if ((256u + _e4425) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e4425 + 257u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e4425 + 258u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4432 = (_e4425 + 259u);
                                                                            if (_e4432 < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4435 = surfaces.member[_e4432];
                                                                            if ((_e4425 + 260u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e4425 + 261u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e4425 + 262u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4442 = (_e4425 + 263u);
                                                                            if (_e4442 < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4445 = surfaces.member[_e4442];
                                                                            let _e4446 = (_e4425 + 264u);
                                                                            if (_e4446 < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4449 = surfaces.member[_e4446];
                                                                            let _e4450 = bitcast<f32>(_e4449);
                                                                            let _e4451 = (_e4425 + 265u);
                                                                            if (_e4451 < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4454 = surfaces.member[_e4451];
                                                                            let _e4455 = bitcast<f32>(_e4454);
                                                                            if ((_e4425 + 266u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e4425 + 267u) < _e144) {
                                                                            } else {
                                                                                phi_16772_ = true;
                                                                                phi_12423_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e4435 == 4294967295u) {
                                                                                phi_4832_ = (_e4450 < _e4455);
                                                                            } else {
                                                                                if (_e4037.member_1 < _e141) {
                                                                                } else {
                                                                                    phi_16772_ = true;
                                                                                    phi_12423_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e4463 = ((1f - _e4411[1]) - _e4411[2]);
                                                                                let _e4467 = attributes.member[_e4037.member_1].member[0u];
                                                                                let _e4472 = attributes.member[_e4037.member_1].member[2u];
                                                                                let _e4478 = attributes.member[_e4037.member_1].member[4u];
                                                                                let _e4480 = (((_e4467 * _e4463) + (_e4472 * _e4411[1])) + (_e4478 * _e4411[2]));
                                                                                let _e4484 = attributes.member[_e4037.member_1].member[1u];
                                                                                let _e4489 = attributes.member[_e4037.member_1].member[3u];
                                                                                let _e4495 = attributes.member[_e4037.member_1].member[5u];
                                                                                let _e4497 = (((_e4484 * _e4463) + (_e4489 * _e4411[1])) + (_e4495 * _e4411[2]));
                                                                                let _e4498 = (_e4445 & 65535u);
                                                                                let _e4500 = (_e4445 >> bitcast<u32>(16i));
                                                                                let _e4502 = (_e4480 - floor(_e4480));
                                                                                let _e4507 = ((select(0f, _e4502, (_e4502 <= 1f)) * f32(_e4498)) - 0.5f);
                                                                                let _e4508 = floor(_e4507);
                                                                                let _e4509 = (_e4507 - _e4508);
                                                                                let _e4510 = (_e4498 - 1u);
                                                                                if (_e4508 < 0f) {
                                                                                    phi_4715_ = _e4510;
                                                                                } else {
                                                                                    let _e4516 = select(select(u32(_e4508), 0u, (_e4508 < 0f)), 4294967295u, (_e4508 > 4294967000f));
                                                                                    phi_4715_ = select(_e4516, _e4510, (_e4510 < _e4516));
                                                                                }
                                                                                let _e4520 = phi_4715_;
                                                                                if (_e4520 == _e4510) {
                                                                                    phi_4721_ = 0u;
                                                                                } else {
                                                                                    phi_4721_ = (_e4520 + 1u);
                                                                                }
                                                                                let _e4524 = phi_4721_;
                                                                                let _e4526 = (_e4497 - floor(_e4497));
                                                                                let _e4531 = ((select(0f, _e4526, (_e4526 <= 1f)) * f32(_e4500)) - 0.5f);
                                                                                let _e4532 = floor(_e4531);
                                                                                let _e4533 = (_e4531 - _e4532);
                                                                                let _e4534 = (_e4500 - 1u);
                                                                                if (_e4532 < 0f) {
                                                                                    phi_4751_ = _e4534;
                                                                                } else {
                                                                                    let _e4540 = select(select(u32(_e4532), 0u, (_e4532 < 0f)), 4294967295u, (_e4532 > 4294967000f));
                                                                                    phi_4751_ = select(_e4540, _e4534, (_e4534 < _e4540));
                                                                                }
                                                                                let _e4544 = phi_4751_;
                                                                                if (_e4544 == _e4534) {
                                                                                    phi_4757_ = 0u;
                                                                                } else {
                                                                                    phi_4757_ = (_e4544 + 1u);
                                                                                }
                                                                                let _e4548 = phi_4757_;
                                                                                let _e4550 = (_e4435 + (_e4544 * _e4498));
                                                                                let _e4552 = (_e4435 + (_e4548 * _e4498));
                                                                                let _e4553 = (_e4550 + _e4520);
                                                                                let _e4554 = (_e4550 + _e4524);
                                                                                let _e4555 = (_e4552 + _e4520);
                                                                                let _e4556 = (_e4552 + _e4524);
                                                                                if (_e4553 < _e144) {
                                                                                } else {
                                                                                    phi_16772_ = true;
                                                                                    phi_12423_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e4559 = surfaces.member[_e4553];
                                                                                if (_e4554 < _e144) {
                                                                                } else {
                                                                                    phi_16772_ = true;
                                                                                    phi_12423_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e4562 = surfaces.member[_e4554];
                                                                                if (_e4555 < _e144) {
                                                                                } else {
                                                                                    phi_16772_ = true;
                                                                                    phi_12423_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e4565 = surfaces.member[_e4555];
                                                                                if (_e4556 < _e144) {
                                                                                } else {
                                                                                    phi_16772_ = true;
                                                                                    phi_12423_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e4568 = surfaces.member[_e4556];
                                                                                let _e4585 = (1f - _e4509);
                                                                                phi_4832_ = ((_e4450 * (((((f32((_e4559 >> bitcast<u32>(24i))) * 0.003921569f) * _e4585) + ((f32((_e4562 >> bitcast<u32>(24i))) * 0.003921569f) * _e4509)) * (1f - _e4533)) + ((((f32((_e4565 >> bitcast<u32>(24i))) * 0.003921569f) * _e4585) + ((f32((_e4568 >> bitcast<u32>(24i))) * 0.003921569f) * _e4509)) * _e4533))) < _e4455);
                                                                            }
                                                                            let _e4600 = phi_4832_;
                                                                            phi_4837_ = select(true, false, _e4600);
                                                                        }
                                                                        let _e4603 = phi_4837_;
                                                                        if _e4603 {
                                                                            phi_4842_ = type_44(_e4411[0], _e4037.member_1, _e4411[1], _e4411[2]);
                                                                        } else {
                                                                            phi_4842_ = type_44();
                                                                        }
                                                                        let _e4606 = phi_4842_;
                                                                        phi_4844_ = _e4606;
                                                                        phi_4846_ = select(true, false, _e4603);
                                                                    } else {
                                                                        phi_4844_ = type_44();
                                                                        phi_4846_ = false;
                                                                    }
                                                                    let _e4609 = phi_4844_;
                                                                    let _e4611 = phi_4846_;
                                                                    phi_4847_ = _e4609;
                                                                    phi_4849_ = select(true, false, _e4415);
                                                                    phi_4850_ = _e4611;
                                                                } else {
                                                                    phi_4847_ = type_44();
                                                                    phi_4849_ = false;
                                                                    phi_4850_ = false;
                                                                }
                                                                let _e4614 = phi_4847_;
                                                                let _e4616 = phi_4849_;
                                                                let _e4618 = phi_4850_;
                                                                phi_4851_ = _e4614;
                                                                phi_4852_ = select(true, false, _e4416);
                                                                phi_4853_ = _e4616;
                                                                phi_4854_ = _e4618;
                                                            } else {
                                                                phi_4851_ = type_44();
                                                                phi_4852_ = true;
                                                                phi_4853_ = false;
                                                                phi_4854_ = false;
                                                            }
                                                            let _e4621 = phi_4851_;
                                                            let _e4623 = phi_4852_;
                                                            let _e4625 = phi_4853_;
                                                            let _e4627 = phi_4854_;
                                                            if select(select(_e4627, false, _e4623), true, select(_e4625, true, _e4623)) {
                                                                phi_4867_ = type_44(0.9999995f, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_4867_ = _e4621;
                                                            }
                                                            let _e4632 = phi_4867_;
                                                            phi_4874_ = select(true, false, (_e4632.member_1 != 4294967295u));
                                                        } else {
                                                            phi_4874_ = false;
                                                        }
                                                        let _e4637 = phi_4874_;
                                                        continue;
                                                        continuing {
                                                            phi_4191_ = _e4035;
                                                            phi_16772_ = _e4010;
                                                            phi_12423_ = select(true, false, _e4041);
                                                            break if !(_e4637);
                                                        }
                                                    }
                                                    let _e4641 = phi_16772_;
                                                    let _e4643 = phi_12423_;
                                                    phi_16840_ = _e4641;
                                                    phi_12424_ = bool();
                                                    if _e4641 {
                                                        break;
                                                    }
                                                    phi_16842_ = _e4641;
                                                    phi_4879_ = _e4014;
                                                    phi_4880_ = _e4643;
                                                }
                                                let _e4880 = phi_16842_;
                                                let _e4882 = phi_4879_;
                                                let _e4884 = phi_4880_;
                                                if _e4884 {
                                                    let _e4885 = (_e4882 == 0u);
                                                    if _e4885 {
                                                        phi_4896_ = u32();
                                                        phi_4897_ = u32();
                                                    } else {
                                                        let _e4886 = (_e4882 - 1u);
                                                        if (_e4886 < 64u) {
                                                        } else {
                                                            phi_16840_ = true;
                                                            phi_12424_ = bool();
                                                            break;
                                                        }
                                                        let _e4889 = local_12[_e4886];
                                                        phi_4896_ = _e4889;
                                                        phi_4897_ = _e4886;
                                                    }
                                                    let _e4891 = phi_4896_;
                                                    let _e4893 = phi_4897_;
                                                    phi_3764_ = _e4891;
                                                    phi_3767_ = _e4893;
                                                    phi_4899_ = select(true, false, _e4885);
                                                    phi_4900_ = _e4885;
                                                } else {
                                                    phi_3764_ = u32();
                                                    phi_3767_ = u32();
                                                    phi_4899_ = false;
                                                    phi_4900_ = false;
                                                }
                                                let _e4896 = phi_3764_;
                                                let _e4898 = phi_3767_;
                                                let _e4900 = phi_4899_;
                                                let _e4902 = phi_4900_;
                                                continue;
                                                continuing {
                                                    phi_16776_ = _e4880;
                                                    phi_3763_ = _e4896;
                                                    phi_3766_ = _e4898;
                                                    phi_16840_ = _e4880;
                                                    phi_12424_ = _e4902;
                                                    break if !(_e4900);
                                                }
                                            }
                                            let _e4905 = phi_16840_;
                                            let _e4907 = phi_12424_;
                                            phi_17160_ = _e4905;
                                            if _e4905 {
                                                break;
                                            }
                                            let _e4910 = !(select(false, true, select(true, false, _e4907)));
                                            if _e4910 {
                                                phi_4917_ = vec3<f32>((_e3795.member_6[0] * _e3881), (_e3795.member_6[1] * _e3881), (_e3795.member_6[2] * _e3881));
                                            } else {
                                                phi_4917_ = vec3<f32>();
                                            }
                                            let _e4916 = phi_4917_;
                                            phi_17166_ = _e4905;
                                            phi_4919_ = _e4916;
                                            phi_4920_ = select(true, false, _e4910);
                                        } else {
                                            phi_17166_ = _e3768;
                                            phi_4919_ = vec3<f32>();
                                            phi_4920_ = true;
                                        }
                                        let _e4919 = phi_17166_;
                                        let _e4921 = phi_4919_;
                                        let _e4923 = phi_4920_;
                                        phi_17164_ = _e4919;
                                        phi_4925_ = vec3<f32>();
                                        phi_4926_ = select(_e4921, vec3<f32>(0f, 0f, 0f), vec3(_e4923));
                                    }
                                    let _e5976 = phi_17164_;
                                    let _e5978 = phi_4925_;
                                    let _e5980 = phi_4926_;
                                    phi_17163_ = _e5976;
                                    phi_4927_ = _e5978;
                                    phi_4928_ = _e5980;
                                    phi_4929_ = _e3833;
                                }
                                let _e8042 = phi_17163_;
                                let _e8044 = phi_4927_;
                                let _e8046 = phi_4928_;
                                let _e8048 = phi_4929_;
                                phi_17161_ = _e8042;
                                phi_341_ = (_e3772 + select(_e8046, _e8044, vec3(_e8048)));
                            } else {
                                phi_17161_ = _e3768;
                                phi_341_ = vec3<f32>();
                            }
                            let _e8053 = phi_17161_;
                            let _e8055 = phi_341_;
                            continue;
                            continuing {
                                phi_16793_ = _e8053;
                                phi_337_ = _e3785;
                                phi_340_ = _e8055;
                                phi_17160_ = _e8053;
                                break if !(_e3791);
                            }
                        }
                        let _e8058 = phi_17160_;
                        if _e8058 {
                            break;
                        }
                        phi_17291_ = _e8058;
                        let _e10031 = local_31;
                        phi_9607_ = _e10031;
                    } else {
                        let _e218 = ((_e213 ^ (_e213 >> bitcast<u32>(16i))) * 2146121005u);
                        let _e222 = ((_e218 ^ (_e218 >> bitcast<u32>(15i))) * 2221713035u);
                        phi_16276_ = false;
                        phi_4959_ = type_8(0u, _e184);
                        phi_4962_ = vec3<f32>(0f, 0f, 0f);
                        loop {
                            let _e232 = phi_16276_;
                            let _e234 = phi_4959_;
                            let _e236 = phi_4962_;
                            local_32 = _e236;
                            if (_e234.member < _e234.member_1) {
                                phi_4960_ = type_8((_e234.member + 1u), _e234.member_1);
                                phi_4985_ = type_8(1u, _e234.member);
                            } else {
                                phi_4960_ = _e234;
                                phi_4985_ = type_8(0u, type_8().member_1);
                            }
                            let _e249 = phi_4960_;
                            let _e251 = phi_4985_;
                            let _e255 = (bitcast<i32>(_e251.member) != 0i);
                            if _e255 {
                                let _e258 = f32(_e184);
                                phi_4999_ = (_e181 - 1u);
                                phi_5002_ = 0u;
                                loop {
                                    let _e262 = phi_4999_;
                                    let _e264 = phi_5002_;
                                    local_21 = _e264;
                                    local_22 = _e264;
                                    let _e265 = (_e264 < _e262);
                                    if _e265 {
                                        let _e267 = ((_e264 + _e262) / 2u);
                                        if (_e267 < _e146) {
                                        } else {
                                            phi_16272_ = true;
                                            break;
                                        }
                                        let _e272 = lights.member[_e267].member_5;
                                        let _e273 = (_e272 > ((f32(_e251.member_1) + (f32(((_e222 ^ (_e222 >> bitcast<u32>(16i))) >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e258));
                                        if _e273 {
                                            phi_5026_ = _e264;
                                        } else {
                                            phi_5026_ = (_e267 + 1u);
                                        }
                                        let _e276 = phi_5026_;
                                        phi_5000_ = select(_e262, _e267, _e273);
                                        phi_5003_ = _e276;
                                    } else {
                                        phi_5000_ = u32();
                                        phi_5003_ = u32();
                                    }
                                    let _e279 = phi_5000_;
                                    let _e281 = phi_5003_;
                                    continue;
                                    continuing {
                                        phi_4999_ = _e279;
                                        phi_5002_ = _e281;
                                        phi_16272_ = _e232;
                                        break if !(_e265);
                                    }
                                }
                                let _e284 = phi_16272_;
                                phi_16664_ = _e284;
                                if _e284 {
                                    break;
                                }
                                let _e286 = local_21;
                                if (_e286 < _e146) {
                                } else {
                                    phi_16664_ = true;
                                    break;
                                }
                                let _e290 = local_22;
                                let _e292 = lights.member[_e290];
                                if (_e292.member_7 > 0f) {
                                    let _e296 = (1f / (_e292.member_7 * _e258));
                                    let _e297 = (_e213 + _e251.member_1);
                                    let _e301 = ((_e297 ^ (_e297 >> bitcast<u32>(16i))) * 2146121005u);
                                    let _e305 = ((_e301 ^ (_e301 >> bitcast<u32>(15i))) * 2221713035u);
                                    let _e308 = (_e305 ^ (_e305 >> bitcast<u32>(16i)));
                                    if (_e292.member_1 == 3u) {
                                        let _e2475 = (_e292.member_2[0] - _e292.member[0]);
                                        let _e2476 = (_e292.member_2[1] - _e292.member[1]);
                                        let _e2477 = (_e292.member_2[2] - _e292.member[2]);
                                        let _e2478 = (_e292.member_4[0] - _e292.member[0]);
                                        let _e2479 = (_e292.member_4[1] - _e292.member[1]);
                                        let _e2480 = (_e292.member_4[2] - _e292.member[2]);
                                        let _e2483 = ((_e2476 * _e2480) - (_e2479 * _e2477));
                                        let _e2486 = ((_e2477 * _e2478) - (_e2480 * _e2475));
                                        let _e2489 = ((_e2475 * _e2479) - (_e2478 * _e2476));
                                        let _e2490 = abs(_e2483);
                                        let _e2491 = abs(_e2486);
                                        let _e2493 = select(_e2491, _e2490, (_e2490 > _e2491));
                                        let _e2494 = abs(_e2489);
                                        let _e2496 = select(_e2494, _e2493, (_e2493 > _e2494));
                                        if (_e2496 > 0.000000000000000000000000000000000000011754944f) {
                                            let _e2498 = (_e2496 < 340282350000000000000000000000000000000f);
                                            if _e2498 {
                                                let _e2499 = (_e2483 / _e2496);
                                                let _e2500 = (_e2486 / _e2496);
                                                let _e2501 = (_e2489 / _e2496);
                                                let _e2507 = sqrt((((_e2499 * _e2499) + (_e2500 * _e2500)) + (_e2501 * _e2501)));
                                                phi_5133_ = vec3<f32>((_e2499 / _e2507), (_e2500 / _e2507), (_e2501 / _e2507));
                                            } else {
                                                phi_5133_ = vec3<f32>();
                                            }
                                            let _e2513 = phi_5133_;
                                            phi_5135_ = _e2513;
                                            phi_5136_ = select(true, false, _e2498);
                                        } else {
                                            phi_5135_ = vec3<f32>();
                                            phi_5136_ = true;
                                        }
                                        let _e2516 = phi_5135_;
                                        let _e2518 = phi_5136_;
                                        let _e2520 = select(_e2516, vec3<f32>(0f, 0f, 0f), vec3(_e2518));
                                        let _e2531 = (((_e2520.x * (_e162.member[0] - _e292.member[0])) + (_e2520.y * (_e162.member[1] - _e292.member[1]))) + (_e2520.z * (_e162.member[2] - _e292.member[2])));
                                        if (_e2531 <= 0f) {
                                            phi_16681_ = _e284;
                                            phi_6732_ = 0f;
                                        } else {
                                            phi_16550_ = _e284;
                                            phi_5158_ = type_8(0u, 1u);
                                            phi_5163_ = 0f;
                                            loop {
                                                let _e2534 = phi_16550_;
                                                let _e2536 = phi_5158_;
                                                let _e2538 = phi_5163_;
                                                local_23 = _e2538;
                                                local_24 = _e2538;
                                                if (_e2536.member < _e2536.member_1) {
                                                    phi_5159_ = type_8((_e2536.member + 1u), _e2536.member_1);
                                                    phi_5188_ = type_8(1u, _e2536.member);
                                                } else {
                                                    phi_5159_ = _e2536;
                                                    phi_5188_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e2551 = phi_5159_;
                                                let _e2553 = phi_5188_;
                                                let _e2557 = (bitcast<i32>(_e2553.member) != 0i);
                                                if _e2557 {
                                                    let _e2561 = ((_e308 ^ (_e308 >> bitcast<u32>(16i))) * 2146121005u);
                                                    let _e2565 = ((_e2561 ^ (_e2561 >> bitcast<u32>(15i))) * 2221713035u);
                                                    let _e2572 = (_e308 ^ 2654435769u);
                                                    let _e2576 = ((_e2572 ^ (_e2572 >> bitcast<u32>(16i))) * 2146121005u);
                                                    let _e2580 = ((_e2576 ^ (_e2576 >> bitcast<u32>(15i))) * 2221713035u);
                                                    let _e2598 = (0.000000059604645f * (f32(((2147483648u + (_e2553.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e2565 ^ (_e2565 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e2598 >= 1f) {
                                                        phi_12924_ = (_e2598 - 1f);
                                                    } else {
                                                        phi_12924_ = _e2598;
                                                    }
                                                    let _e2602 = phi_12924_;
                                                    let _e2604 = (0.000000059604645f * (f32(((2147483648u + (_e2553.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e2580 ^ (_e2580 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                    if (_e2604 >= 1f) {
                                                        phi_12932_ = (_e2604 - 1f);
                                                    } else {
                                                        phi_12932_ = _e2604;
                                                    }
                                                    let _e2608 = phi_12932_;
                                                    if (_e2602 < _e2608) {
                                                        let _e2613 = (0.5f * _e2602);
                                                        phi_5249_ = vec2<f32>(_e2613, (_e2608 - _e2613));
                                                    } else {
                                                        let _e2610 = (0.5f * _e2608);
                                                        phi_5249_ = vec2<f32>((_e2602 - _e2610), _e2610);
                                                    }
                                                    let _e2617 = phi_5249_;
                                                    let _e2629 = ((_e292.member[0] + (_e2475 * _e2617.x)) + (_e2478 * _e2617.y));
                                                    let _e2630 = ((_e292.member[1] + (_e2476 * _e2617.x)) + (_e2479 * _e2617.y));
                                                    let _e2631 = ((_e292.member[2] + (_e2477 * _e2617.x)) + (_e2480 * _e2617.y));
                                                    let _e2632 = (_e2629 - _e162.member[0]);
                                                    let _e2633 = (_e2630 - _e162.member[1]);
                                                    let _e2634 = (_e2631 - _e162.member[2]);
                                                    let _e2639 = (((_e2632 * _e2632) + (_e2633 * _e2633)) + (_e2634 * _e2634));
                                                    let _e2644 = (((_e162.member_2[0] * _e2632) + (_e162.member_2[1] * _e2633)) + (_e162.member_2[2] * _e2634));
                                                    let _e2648 = (_e2639 * _e2639);
                                                    let _e2651 = ((select(0f, _e2644, (_e2644 > 0f)) * _e2531) / select(0.000000000000000000000000000000000000011754944f, _e2648, (_e2648 > 0.000000000000000000000000000000000000011754944f)));
                                                    if (_e2651 > 0f) {
                                                        let _e2653 = abs(_e2629);
                                                        let _e2654 = abs(_e2630);
                                                        let _e2656 = select(_e2654, _e2653, (_e2653 > _e2654));
                                                        let _e2657 = abs(_e2631);
                                                        let _e2663 = ((select(_e2657, _e2656, (_e2656 > _e2657)) + sqrt(_e292.member_3)) * 0.0000009536743f);
                                                        let _e2667 = (_e2629 + (_e2520.x * _e2663));
                                                        let _e2668 = (_e2630 + (_e2520.y * _e2663));
                                                        let _e2669 = (_e2631 + (_e2520.z * _e2663));
                                                        if ((((_e162.member_4[0] * (_e2667 - _e162.member[0])) + (_e162.member_4[1] * (_e2668 - _e162.member[1]))) + (_e162.member_4[2] * (_e2669 - _e162.member[2]))) < 0f) {
                                                            phi_5346_ = -(_e162.member_9);
                                                        } else {
                                                            phi_5346_ = _e162.member_9;
                                                        }
                                                        let _e2681 = phi_5346_;
                                                        let _e2685 = (_e162.member[0] + (_e162.member_4[0] * _e2681));
                                                        let _e2686 = (_e162.member[1] + (_e162.member_4[1] * _e2681));
                                                        let _e2687 = (_e162.member[2] + (_e162.member_4[2] * _e2681));
                                                        let _e2688 = (_e2667 - _e2685);
                                                        let _e2689 = (_e2668 - _e2686);
                                                        let _e2690 = (_e2669 - _e2687);
                                                        let _e2691 = abs(_e2688);
                                                        let _e2692 = abs(_e2689);
                                                        let _e2693 = abs(_e2690);
                                                        let _e2694 = (_e2691 > _e2692);
                                                        if _e2694 {
                                                            phi_5372_ = (_e2691 > _e2693);
                                                        } else {
                                                            phi_5372_ = (_e2692 > _e2693);
                                                        }
                                                        let _e2698 = phi_5372_;
                                                        let _e2699 = select(1u, 0u, _e2694);
                                                        if _e2698 {
                                                            let _e2700 = (_e2699 + 1u);
                                                            phi_5382_ = _e2700;
                                                            phi_5385_ = select(true, false, (_e2700 == 2u));
                                                        } else {
                                                            phi_5382_ = u32();
                                                            phi_5385_ = false;
                                                        }
                                                        let _e2704 = phi_5382_;
                                                        let _e2706 = phi_5385_;
                                                        let _e2707 = select(true, false, _e2698);
                                                        let _e2708 = select(_e2704, 0u, _e2707);
                                                        let _e2710 = select(_e2706, true, _e2707);
                                                        if _e2710 {
                                                            phi_5396_ = (_e2708 + 1u);
                                                        } else {
                                                            phi_5396_ = 0u;
                                                        }
                                                        let _e2713 = phi_5396_;
                                                        let _e2714 = select(_e2704, _e2708, _e2710);
                                                        let _e2715 = select(_e2699, select(_e2699, 2u, _e2707), _e2710);
                                                        local_10 = array<f32, 3>(_e2688, _e2689, _e2690);
                                                        local_11 = array<f32, 3>(_e2685, _e2686, _e2687);
                                                        let _e2718 = (_e2715 < 3u);
                                                        if _e2718 {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2720 = local_10[_e2715];
                                                        let _e2721 = (1f / _e2720);
                                                        let _e2722 = (_e2714 < 3u);
                                                        if _e2722 {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2724 = local_10[_e2714];
                                                        let _e2725 = (_e2724 * _e2721);
                                                        let _e2726 = (_e2713 < 3u);
                                                        if _e2726 {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2728 = local_10[_e2713];
                                                        let _e2729 = (_e2728 * _e2721);
                                                        if _e2722 {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2731 = local_11[_e2714];
                                                        if _e2726 {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2733 = local_11[_e2713];
                                                        if _e2718 {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2735 = local_11[_e2715];
                                                        if (0u < _e135) {
                                                        } else {
                                                            phi_16658_ = true;
                                                            break;
                                                        }
                                                        let _e2740 = nodes.member[0u].member_7[0u];
                                                        let _e2744 = nodes.member[0u].member_7[1u];
                                                        let _e2748 = nodes.member[0u].member_7[2u];
                                                        let _e2752 = nodes.member[0u].member_7[3u];
                                                        let _e2754 = abs((_e2685 - _e2740));
                                                        let _e2756 = abs((_e2686 - _e2744));
                                                        let _e2758 = select(_e2756, _e2754, (_e2754 > _e2756));
                                                        let _e2760 = abs((_e2687 - _e2748));
                                                        let _e2764 = ((select(_e2760, _e2758, (_e2758 > _e2760)) + _e2752) * 0.0000009536743f);
                                                        let _e2771 = (_e2764 + (abs(_e2685) * 0.00000023841858f));
                                                        let _e2772 = (_e2764 + (abs(_e2686) * 0.00000023841858f));
                                                        let _e2773 = (_e2764 + (abs(_e2687) * 0.00000023841858f));
                                                        let _e2774 = select(_e2692, _e2691, _e2694);
                                                        let _e2776 = select(_e2693, _e2774, (_e2774 > _e2693));
                                                        let _e2777 = (_e2776 * 0.000000000001f);
                                                        let _e2778 = (_e2685 + _e2771);
                                                        let _e2779 = (_e2686 + _e2772);
                                                        let _e2780 = (_e2687 + _e2773);
                                                        let _e2781 = (_e2685 - _e2771);
                                                        let _e2782 = (_e2686 - _e2772);
                                                        let _e2783 = (_e2687 - _e2773);
                                                        if (_e2691 > _e2777) {
                                                            phi_5526_ = (1f / _e2688);
                                                        } else {
                                                            phi_5526_ = (1000000000000f / _e2776);
                                                        }
                                                        let _e2788 = phi_5526_;
                                                        if (_e2692 > _e2777) {
                                                            phi_5534_ = (1f / _e2689);
                                                        } else {
                                                            phi_5534_ = (1000000000000f / _e2776);
                                                        }
                                                        let _e2793 = phi_5534_;
                                                        if (_e2693 > _e2777) {
                                                            phi_5542_ = (1f / _e2690);
                                                        } else {
                                                            phi_5542_ = (1000000000000f / _e2776);
                                                        }
                                                        let _e2798 = phi_5542_;
                                                        local_9 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                        phi_16528_ = _e2534;
                                                        phi_5545_ = 0u;
                                                        phi_5548_ = 0u;
                                                        loop {
                                                            let _e2800 = phi_16528_;
                                                            let _e2802 = phi_5545_;
                                                            let _e2804 = phi_5548_;
                                                            let _e2805 = (_e2802 & 15u);
                                                            let _e2807 = (_e2802 >> bitcast<u32>(4u));
                                                            if (_e2805 == 0u) {
                                                                if (_e2807 < _e135) {
                                                                } else {
                                                                    phi_16598_ = true;
                                                                    phi_12422_ = bool();
                                                                    break;
                                                                }
                                                                let _e3437 = nodes.member[_e2807].member;
                                                                let _e3446 = ((_e3437.x - _e2778) * _e2788);
                                                                let _e3447 = ((_e3437.y - _e2778) * _e2788);
                                                                let _e3448 = ((_e3437.z - _e2778) * _e2788);
                                                                let _e3449 = ((_e3437.w - _e2778) * _e2788);
                                                                let _e3452 = nodes.member[_e2807].member_3;
                                                                let _e3461 = ((_e3452.x - _e2781) * _e2788);
                                                                let _e3462 = ((_e3452.y - _e2781) * _e2788);
                                                                let _e3463 = ((_e3452.z - _e2781) * _e2788);
                                                                let _e3464 = ((_e3452.w - _e2781) * _e2788);
                                                                let _e3467 = nodes.member[_e2807].member_1;
                                                                let _e3476 = ((_e3467.x - _e2779) * _e2793);
                                                                let _e3477 = ((_e3467.y - _e2779) * _e2793);
                                                                let _e3478 = ((_e3467.z - _e2779) * _e2793);
                                                                let _e3479 = ((_e3467.w - _e2779) * _e2793);
                                                                let _e3482 = nodes.member[_e2807].member_4;
                                                                let _e3491 = ((_e3482.x - _e2782) * _e2793);
                                                                let _e3492 = ((_e3482.y - _e2782) * _e2793);
                                                                let _e3493 = ((_e3482.z - _e2782) * _e2793);
                                                                let _e3494 = ((_e3482.w - _e2782) * _e2793);
                                                                let _e3497 = nodes.member[_e2807].member_2;
                                                                let _e3506 = ((_e3497.x - _e2780) * _e2798);
                                                                let _e3507 = ((_e3497.y - _e2780) * _e2798);
                                                                let _e3508 = ((_e3497.z - _e2780) * _e2798);
                                                                let _e3509 = ((_e3497.w - _e2780) * _e2798);
                                                                let _e3512 = nodes.member[_e2807].member_5;
                                                                let _e3521 = ((_e3512.x - _e2783) * _e2798);
                                                                let _e3522 = ((_e3512.y - _e2783) * _e2798);
                                                                let _e3523 = ((_e3512.z - _e2783) * _e2798);
                                                                let _e3524 = ((_e3512.w - _e2783) * _e2798);
                                                                let _e3526 = select(_e3461, _e3446, (_e3446 < _e3461));
                                                                let _e3528 = select(_e3462, _e3447, (_e3447 < _e3462));
                                                                let _e3530 = select(_e3463, _e3448, (_e3448 < _e3463));
                                                                let _e3532 = select(_e3464, _e3449, (_e3449 < _e3464));
                                                                let _e3534 = select(_e3491, _e3476, (_e3476 < _e3491));
                                                                let _e3536 = select(_e3492, _e3477, (_e3477 < _e3492));
                                                                let _e3538 = select(_e3493, _e3478, (_e3478 < _e3493));
                                                                let _e3540 = select(_e3494, _e3479, (_e3479 < _e3494));
                                                                let _e3542 = select(_e3534, _e3526, (_e3526 > _e3534));
                                                                let _e3544 = select(_e3536, _e3528, (_e3528 > _e3536));
                                                                let _e3546 = select(_e3538, _e3530, (_e3530 > _e3538));
                                                                let _e3548 = select(_e3540, _e3532, (_e3532 > _e3540));
                                                                let _e3550 = select(_e3521, _e3506, (_e3506 < _e3521));
                                                                let _e3552 = select(_e3522, _e3507, (_e3507 < _e3522));
                                                                let _e3554 = select(_e3523, _e3508, (_e3508 < _e3523));
                                                                let _e3556 = select(_e3524, _e3509, (_e3509 < _e3524));
                                                                let _e3558 = select(_e3550, _e3542, (_e3542 > _e3550));
                                                                let _e3560 = select(_e3552, _e3544, (_e3544 > _e3552));
                                                                let _e3562 = select(_e3554, _e3546, (_e3546 > _e3554));
                                                                let _e3564 = select(_e3556, _e3548, (_e3548 > _e3556));
                                                                let _e3566 = select(0f, _e3558, (_e3558 > 0f));
                                                                let _e3568 = select(0f, _e3560, (_e3560 > 0f));
                                                                let _e3570 = select(0f, _e3562, (_e3562 > 0f));
                                                                let _e3572 = select(0f, _e3564, (_e3564 > 0f));
                                                                let _e3574 = select(_e3461, _e3446, (_e3446 > _e3461));
                                                                let _e3576 = select(_e3462, _e3447, (_e3447 > _e3462));
                                                                let _e3578 = select(_e3463, _e3448, (_e3448 > _e3463));
                                                                let _e3580 = select(_e3464, _e3449, (_e3449 > _e3464));
                                                                let _e3582 = select(_e3491, _e3476, (_e3476 > _e3491));
                                                                let _e3584 = select(_e3492, _e3477, (_e3477 > _e3492));
                                                                let _e3586 = select(_e3493, _e3478, (_e3478 > _e3493));
                                                                let _e3588 = select(_e3494, _e3479, (_e3479 > _e3494));
                                                                let _e3590 = select(_e3582, _e3574, (_e3574 < _e3582));
                                                                let _e3592 = select(_e3584, _e3576, (_e3576 < _e3584));
                                                                let _e3594 = select(_e3586, _e3578, (_e3578 < _e3586));
                                                                let _e3596 = select(_e3588, _e3580, (_e3580 < _e3588));
                                                                let _e3598 = select(_e3521, _e3506, (_e3506 > _e3521));
                                                                let _e3600 = select(_e3522, _e3507, (_e3507 > _e3522));
                                                                let _e3602 = select(_e3523, _e3508, (_e3508 > _e3523));
                                                                let _e3604 = select(_e3524, _e3509, (_e3509 > _e3524));
                                                                let _e3606 = select(_e3598, _e3590, (_e3590 < _e3598));
                                                                let _e3608 = select(_e3600, _e3592, (_e3592 < _e3600));
                                                                let _e3610 = select(_e3602, _e3594, (_e3594 < _e3602));
                                                                let _e3612 = select(_e3604, _e3596, (_e3596 < _e3604));
                                                                let _e3632 = nodes.member[_e2807].member_6[0u];
                                                                let _e3636 = nodes.member[_e2807].member_6[1u];
                                                                let _e3640 = nodes.member[_e2807].member_6[2u];
                                                                let _e3644 = nodes.member[_e2807].member_6[3u];
                                                                if (select(340282350000000000000000000000000000000f, _e3572, (_e3572 <= select(0.9999995f, _e3612, (_e3612 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                    if (_e2804 < 64u) {
                                                                    } else {
                                                                        phi_16598_ = true;
                                                                        phi_12422_ = bool();
                                                                        break;
                                                                    }
                                                                    local_9[_e2804] = _e3644;
                                                                    phi_5933_ = (_e2804 + 1u);
                                                                } else {
                                                                    phi_5933_ = _e2804;
                                                                }
                                                                let _e3650 = phi_5933_;
                                                                if (select(340282350000000000000000000000000000000f, _e3570, (_e3570 <= select(0.9999995f, _e3610, (_e3610 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                    if (_e3650 < 64u) {
                                                                    } else {
                                                                        phi_16598_ = true;
                                                                        phi_12422_ = bool();
                                                                        break;
                                                                    }
                                                                    local_9[_e3650] = _e3640;
                                                                    phi_5945_ = (_e3650 + 1u);
                                                                } else {
                                                                    phi_5945_ = _e3650;
                                                                }
                                                                let _e3656 = phi_5945_;
                                                                if (select(340282350000000000000000000000000000000f, _e3568, (_e3568 <= select(0.9999995f, _e3608, (_e3608 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                    if (_e3656 < 64u) {
                                                                    } else {
                                                                        phi_16598_ = true;
                                                                        phi_12422_ = bool();
                                                                        break;
                                                                    }
                                                                    local_9[_e3656] = _e3636;
                                                                    phi_5957_ = (_e3656 + 1u);
                                                                } else {
                                                                    phi_5957_ = _e3656;
                                                                }
                                                                let _e3662 = phi_5957_;
                                                                if (select(340282350000000000000000000000000000000f, _e3566, (_e3566 <= select(0.9999995f, _e3606, (_e3606 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                    if (_e3662 < 64u) {
                                                                    } else {
                                                                        phi_16598_ = true;
                                                                        phi_12422_ = bool();
                                                                        break;
                                                                    }
                                                                    local_9[_e3662] = _e3632;
                                                                    phi_5969_ = (_e3662 + 1u);
                                                                } else {
                                                                    phi_5969_ = _e3662;
                                                                }
                                                                let _e3668 = phi_5969_;
                                                                phi_16600_ = _e2800;
                                                                phi_6661_ = _e3668;
                                                                phi_6662_ = true;
                                                            } else {
                                                                phi_5973_ = type_8(_e2807, (_e2807 + _e2805));
                                                                loop {
                                                                    let _e2812 = phi_5973_;
                                                                    if (_e2812.member < _e2812.member_1) {
                                                                        phi_5974_ = type_8((_e2812.member + 1u), _e2812.member_1);
                                                                        phi_5997_ = type_8(1u, _e2812.member);
                                                                    } else {
                                                                        phi_5974_ = _e2812;
                                                                        phi_5997_ = type_8(0u, type_8().member_1);
                                                                    }
                                                                    let _e2825 = phi_5974_;
                                                                    let _e2827 = phi_5997_;
                                                                    let _e2831 = (bitcast<i32>(_e2827.member) != 0i);
                                                                    if _e2831 {
                                                                        let _e2832 = (_e2827.member_1 < _e138);
                                                                        if _e2832 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        if _e2718 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2836 = triangles.member[_e2827.member_1].member[_e2715];
                                                                        let _e2837 = (_e2836 - _e2735);
                                                                        if _e2718 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2841 = triangles.member[_e2827.member_1].member_2[_e2715];
                                                                        let _e2842 = (_e2841 - _e2735);
                                                                        if _e2718 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2846 = triangles.member[_e2827.member_1].member_4[_e2715];
                                                                        let _e2847 = (_e2846 - _e2735);
                                                                        if _e2722 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2851 = triangles.member[_e2827.member_1].member[_e2714];
                                                                        let _e2854 = ((_e2851 - _e2731) - (_e2725 * _e2837));
                                                                        if _e2726 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2858 = triangles.member[_e2827.member_1].member[_e2713];
                                                                        let _e2861 = ((_e2858 - _e2733) - (_e2729 * _e2837));
                                                                        if _e2722 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2865 = triangles.member[_e2827.member_1].member_2[_e2714];
                                                                        let _e2868 = ((_e2865 - _e2731) - (_e2725 * _e2842));
                                                                        if _e2726 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2872 = triangles.member[_e2827.member_1].member_2[_e2713];
                                                                        let _e2875 = ((_e2872 - _e2733) - (_e2729 * _e2842));
                                                                        if _e2722 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2879 = triangles.member[_e2827.member_1].member_4[_e2714];
                                                                        let _e2882 = ((_e2879 - _e2731) - (_e2725 * _e2847));
                                                                        if _e2726 {
                                                                        } else {
                                                                            phi_16524_ = true;
                                                                            phi_12421_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e2886 = triangles.member[_e2827.member_1].member_4[_e2713];
                                                                        let _e2889 = ((_e2886 - _e2733) - (_e2729 * _e2847));
                                                                        let _e2890 = (_e2882 * _e2875);
                                                                        let _e2891 = (_e2889 * _e2868);
                                                                        if (_e2890 != _e2891) {
                                                                            phi_6113_ = (_e2890 - _e2891);
                                                                        } else {
                                                                            let _e2893 = (_e2882 * 4097f);
                                                                            let _e2895 = (_e2893 - (_e2893 - _e2882));
                                                                            let _e2896 = (_e2875 * 4097f);
                                                                            let _e2898 = (_e2896 - (_e2896 - _e2875));
                                                                            let _e2899 = (_e2882 - _e2895);
                                                                            let _e2900 = (_e2875 - _e2898);
                                                                            let _e2909 = (_e2889 * 4097f);
                                                                            let _e2911 = (_e2909 - (_e2909 - _e2889));
                                                                            let _e2912 = (_e2868 * 4097f);
                                                                            let _e2914 = (_e2912 - (_e2912 - _e2868));
                                                                            let _e2915 = (_e2889 - _e2911);
                                                                            let _e2916 = (_e2868 - _e2914);
                                                                            phi_6113_ = ((((((_e2895 * _e2898) - _e2890) + (_e2895 * _e2900)) + (_e2899 * _e2898)) + (_e2899 * _e2900)) - (((((_e2911 * _e2914) - _e2891) + (_e2911 * _e2916)) + (_e2915 * _e2914)) + (_e2915 * _e2916)));
                                                                        }
                                                                        let _e2928 = phi_6113_;
                                                                        let _e2929 = (_e2854 * _e2889);
                                                                        let _e2930 = (_e2861 * _e2882);
                                                                        if (_e2929 != _e2930) {
                                                                            phi_6124_ = (_e2929 - _e2930);
                                                                        } else {
                                                                            let _e2932 = (_e2854 * 4097f);
                                                                            let _e2934 = (_e2932 - (_e2932 - _e2854));
                                                                            let _e2935 = (_e2889 * 4097f);
                                                                            let _e2937 = (_e2935 - (_e2935 - _e2889));
                                                                            let _e2938 = (_e2854 - _e2934);
                                                                            let _e2939 = (_e2889 - _e2937);
                                                                            let _e2948 = (_e2861 * 4097f);
                                                                            let _e2950 = (_e2948 - (_e2948 - _e2861));
                                                                            let _e2951 = (_e2882 * 4097f);
                                                                            let _e2953 = (_e2951 - (_e2951 - _e2882));
                                                                            let _e2954 = (_e2861 - _e2950);
                                                                            let _e2955 = (_e2882 - _e2953);
                                                                            phi_6124_ = ((((((_e2934 * _e2937) - _e2929) + (_e2934 * _e2939)) + (_e2938 * _e2937)) + (_e2938 * _e2939)) - (((((_e2950 * _e2953) - _e2930) + (_e2950 * _e2955)) + (_e2954 * _e2953)) + (_e2954 * _e2955)));
                                                                        }
                                                                        let _e2967 = phi_6124_;
                                                                        let _e2968 = (_e2868 * _e2861);
                                                                        let _e2969 = (_e2875 * _e2854);
                                                                        if (_e2968 != _e2969) {
                                                                            phi_6135_ = (_e2968 - _e2969);
                                                                        } else {
                                                                            let _e2971 = (_e2868 * 4097f);
                                                                            let _e2973 = (_e2971 - (_e2971 - _e2868));
                                                                            let _e2974 = (_e2861 * 4097f);
                                                                            let _e2976 = (_e2974 - (_e2974 - _e2861));
                                                                            let _e2977 = (_e2868 - _e2973);
                                                                            let _e2978 = (_e2861 - _e2976);
                                                                            let _e2987 = (_e2875 * 4097f);
                                                                            let _e2989 = (_e2987 - (_e2987 - _e2875));
                                                                            let _e2990 = (_e2854 * 4097f);
                                                                            let _e2992 = (_e2990 - (_e2990 - _e2854));
                                                                            let _e2993 = (_e2875 - _e2989);
                                                                            let _e2994 = (_e2854 - _e2992);
                                                                            phi_6135_ = ((((((_e2973 * _e2976) - _e2968) + (_e2973 * _e2978)) + (_e2977 * _e2976)) + (_e2977 * _e2978)) - (((((_e2989 * _e2992) - _e2969) + (_e2989 * _e2994)) + (_e2993 * _e2992)) + (_e2993 * _e2994)));
                                                                        }
                                                                        let _e3006 = phi_6135_;
                                                                        if (_e2928 < 0f) {
                                                                            phi_6153_ = f32();
                                                                            phi_6154_ = true;
                                                                        } else {
                                                                            if (_e2967 < 0f) {
                                                                                phi_6151_ = f32();
                                                                                phi_6152_ = true;
                                                                            } else {
                                                                                let _e3009 = (_e3006 < 0f);
                                                                                if _e3009 {
                                                                                    phi_6150_ = f32();
                                                                                } else {
                                                                                    phi_6150_ = ((_e2928 + _e2967) + _e3006);
                                                                                }
                                                                                let _e3013 = phi_6150_;
                                                                                phi_6151_ = _e3013;
                                                                                phi_6152_ = _e3009;
                                                                            }
                                                                            let _e3015 = phi_6151_;
                                                                            let _e3017 = phi_6152_;
                                                                            phi_6153_ = _e3015;
                                                                            phi_6154_ = _e3017;
                                                                        }
                                                                        let _e3019 = phi_6153_;
                                                                        let _e3021 = phi_6154_;
                                                                        if _e3021 {
                                                                            if (_e2928 > 0f) {
                                                                                phi_6175_ = f32();
                                                                                phi_6176_ = true;
                                                                                phi_6177_ = false;
                                                                            } else {
                                                                                let _e3023 = (_e2967 > 0f);
                                                                                if _e3023 {
                                                                                    phi_6173_ = f32();
                                                                                    phi_6174_ = false;
                                                                                } else {
                                                                                    phi_6173_ = ((_e2928 + _e2967) + _e3006);
                                                                                    phi_6174_ = select(true, false, (_e3006 > 0f));
                                                                                }
                                                                                let _e3029 = phi_6173_;
                                                                                let _e3031 = phi_6174_;
                                                                                phi_6175_ = _e3029;
                                                                                phi_6176_ = _e3023;
                                                                                phi_6177_ = _e3031;
                                                                            }
                                                                            let _e3033 = phi_6175_;
                                                                            let _e3035 = phi_6176_;
                                                                            let _e3037 = phi_6177_;
                                                                            phi_6182_ = _e3033;
                                                                            phi_6183_ = select(_e3037, false, _e3035);
                                                                        } else {
                                                                            phi_6182_ = _e3019;
                                                                            phi_6183_ = true;
                                                                        }
                                                                        let _e3040 = phi_6182_;
                                                                        let _e3042 = phi_6183_;
                                                                        if _e3042 {
                                                                            let _e3043 = (_e3040 == 0f);
                                                                            if _e3043 {
                                                                                phi_6271_ = array<f32, 3>();
                                                                                phi_6272_ = array<f32, 3>();
                                                                                phi_6273_ = false;
                                                                            } else {
                                                                                let _e3044 = (_e2837 * _e2721);
                                                                                let _e3045 = (_e2842 * _e2721);
                                                                                let _e3046 = (_e2847 * _e2721);
                                                                                let _e3049 = (1f / ((_e2928 + _e2967) + _e3006));
                                                                                let _e3050 = (_e2967 * _e3049);
                                                                                let _e3051 = (_e3006 * _e3049);
                                                                                let _e3057 = ((((_e2928 * _e3049) * _e3044) + (_e3050 * _e3045)) + (_e3051 * _e3046));
                                                                                let _e3058 = abs(_e2854);
                                                                                let _e3059 = abs(_e2868);
                                                                                let _e3061 = select(_e3059, _e3058, (_e3058 > _e3059));
                                                                                let _e3062 = abs(_e2882);
                                                                                let _e3065 = abs(_e2861);
                                                                                let _e3066 = abs(_e2875);
                                                                                let _e3068 = select(_e3066, _e3065, (_e3065 > _e3066));
                                                                                let _e3069 = abs(_e2889);
                                                                                let _e3073 = abs(_e3044);
                                                                                let _e3074 = abs(_e3045);
                                                                                let _e3076 = select(_e3074, _e3073, (_e3073 > _e3074));
                                                                                let _e3077 = abs(_e3046);
                                                                                let _e3084 = (((select(_e3062, _e3061, (_e3061 > _e3062)) * select(_e3069, _e3068, (_e3068 > _e3069))) * select(_e3077, _e3076, (_e3076 > _e3077))) <= (abs((_e3040 * _e3057)) * 256f));
                                                                                if _e3084 {
                                                                                    phi_6269_ = array<f32, 3>(_e3057, _e3050, _e3051);
                                                                                    phi_6270_ = array<f32, 3>();
                                                                                } else {
                                                                                    let _e3086 = (_e2882 * 4097f);
                                                                                    let _e3088 = (_e3086 - (_e3086 - _e2882));
                                                                                    let _e3089 = (_e2875 * 4097f);
                                                                                    let _e3091 = (_e3089 - (_e3089 - _e2875));
                                                                                    let _e3092 = (_e2882 - _e3088);
                                                                                    let _e3093 = (_e2875 - _e3091);
                                                                                    let _e3102 = (_e2889 * 4097f);
                                                                                    let _e3104 = (_e3102 - (_e3102 - _e2889));
                                                                                    let _e3105 = (_e2868 * 4097f);
                                                                                    let _e3107 = (_e3105 - (_e3105 - _e2868));
                                                                                    let _e3108 = (_e2889 - _e3104);
                                                                                    let _e3109 = (_e2868 - _e3107);
                                                                                    let _e3119 = ((_e2890 - _e2891) + ((((((_e3088 * _e3091) - _e2890) + (_e3088 * _e3093)) + (_e3092 * _e3091)) + (_e3092 * _e3093)) - (((((_e3104 * _e3107) - _e2891) + (_e3104 * _e3109)) + (_e3108 * _e3107)) + (_e3108 * _e3109))));
                                                                                    let _e3121 = (_e2854 * 4097f);
                                                                                    let _e3123 = (_e3121 - (_e3121 - _e2854));
                                                                                    let _e3124 = (_e2854 - _e3123);
                                                                                    let _e3133 = (_e2861 * 4097f);
                                                                                    let _e3135 = (_e3133 - (_e3133 - _e2861));
                                                                                    let _e3136 = (_e2861 - _e3135);
                                                                                    let _e3146 = ((_e2929 - _e2930) + ((((((_e3123 * _e3104) - _e2929) + (_e3123 * _e3108)) + (_e3124 * _e3104)) + (_e3124 * _e3108)) - (((((_e3135 * _e3088) - _e2930) + (_e3135 * _e3092)) + (_e3136 * _e3088)) + (_e3136 * _e3092))));
                                                                                    let _e3165 = ((_e2968 - _e2969) + ((((((_e3107 * _e3135) - _e2968) + (_e3107 * _e3136)) + (_e3109 * _e3135)) + (_e3109 * _e3136)) - (((((_e3091 * _e3123) - _e2969) + (_e3091 * _e3124)) + (_e3093 * _e3123)) + (_e3093 * _e3124))));
                                                                                    let _e3168 = (1f / ((_e3119 + _e3146) + _e3165));
                                                                                    let _e3169 = (_e3146 * _e3168);
                                                                                    let _e3170 = (_e3165 * _e3168);
                                                                                    phi_6269_ = array<f32, 3>();
                                                                                    phi_6270_ = array<f32, 3>(((((_e3119 * _e3168) * _e3044) + (_e3169 * _e3045)) + (_e3170 * _e3046)), _e3169, _e3170);
                                                                                }
                                                                                let _e3180 = phi_6269_;
                                                                                let _e3182 = phi_6270_;
                                                                                phi_6271_ = _e3180;
                                                                                phi_6272_ = _e3182;
                                                                                phi_6273_ = _e3084;
                                                                            }
                                                                            let _e3184 = phi_6271_;
                                                                            let _e3186 = phi_6272_;
                                                                            let _e3188 = phi_6273_;
                                                                            phi_6274_ = _e3184;
                                                                            phi_6275_ = _e3186;
                                                                            phi_6276_ = _e3043;
                                                                            phi_6277_ = _e3188;
                                                                        } else {
                                                                            phi_6274_ = array<f32, 3>();
                                                                            phi_6275_ = array<f32, 3>();
                                                                            phi_6276_ = true;
                                                                            phi_6277_ = false;
                                                                        }
                                                                        let _e3190 = phi_6274_;
                                                                        let _e3192 = phi_6275_;
                                                                        let _e3194 = phi_6276_;
                                                                        let _e3196 = phi_6277_;
                                                                        if _e3194 {
                                                                            phi_6282_ = array<f32, 3>(-1f, 0f, 0f);
                                                                        } else {
                                                                            phi_6282_ = _e3190;
                                                                        }
                                                                        let _e3198 = phi_6282_;
                                                                        if select(_e3196, true, _e3194) {
                                                                            phi_6287_ = _e3198;
                                                                        } else {
                                                                            phi_6287_ = _e3192;
                                                                        }
                                                                        let _e3201 = phi_6287_;
                                                                        let _e3205 = (_e3201[0] >= 0f);
                                                                        if _e3205 {
                                                                            let _e3206 = (_e3201[0] < 0.9999995f);
                                                                            if _e3206 {
                                                                                if _e3205 {
                                                                                    if _e2832 {
                                                                                    } else {
                                                                                        phi_16524_ = true;
                                                                                        phi_12421_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3209 = triangles.member[_e2827.member_1].member_3;
                                                                                    if ((_e3209 & 1u) == 0u) {
                                                                                        phi_6619_ = true;
                                                                                    } else {
                                                                                        if _e2832 {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3214 = triangles.member[_e2827.member_1].member_1;
                                                                                        let _e3215 = (_e3214 * 12u);
                                                                                        if ((256u + _e3215) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        if ((_e3215 + 257u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        if ((_e3215 + 258u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3222 = (_e3215 + 259u);
                                                                                        if (_e3222 < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3225 = surfaces.member[_e3222];
                                                                                        if ((_e3215 + 260u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        if ((_e3215 + 261u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        if ((_e3215 + 262u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3232 = (_e3215 + 263u);
                                                                                        if (_e3232 < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3235 = surfaces.member[_e3232];
                                                                                        let _e3236 = (_e3215 + 264u);
                                                                                        if (_e3236 < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3239 = surfaces.member[_e3236];
                                                                                        let _e3240 = bitcast<f32>(_e3239);
                                                                                        let _e3241 = (_e3215 + 265u);
                                                                                        if (_e3241 < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3244 = surfaces.member[_e3241];
                                                                                        let _e3245 = bitcast<f32>(_e3244);
                                                                                        if ((_e3215 + 266u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        if ((_e3215 + 267u) < _e144) {
                                                                                        } else {
                                                                                            phi_16524_ = true;
                                                                                            phi_12421_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        if (_e3225 == 4294967295u) {
                                                                                            phi_6614_ = (_e3240 < _e3245);
                                                                                        } else {
                                                                                            if (_e2827.member_1 < _e141) {
                                                                                            } else {
                                                                                                phi_16524_ = true;
                                                                                                phi_12421_ = bool();
                                                                                                break;
                                                                                            }
                                                                                            let _e3253 = ((1f - _e3201[1]) - _e3201[2]);
                                                                                            let _e3257 = attributes.member[_e2827.member_1].member[0u];
                                                                                            let _e3262 = attributes.member[_e2827.member_1].member[2u];
                                                                                            let _e3268 = attributes.member[_e2827.member_1].member[4u];
                                                                                            let _e3270 = (((_e3257 * _e3253) + (_e3262 * _e3201[1])) + (_e3268 * _e3201[2]));
                                                                                            let _e3274 = attributes.member[_e2827.member_1].member[1u];
                                                                                            let _e3279 = attributes.member[_e2827.member_1].member[3u];
                                                                                            let _e3285 = attributes.member[_e2827.member_1].member[5u];
                                                                                            let _e3287 = (((_e3274 * _e3253) + (_e3279 * _e3201[1])) + (_e3285 * _e3201[2]));
                                                                                            let _e3288 = (_e3235 & 65535u);
                                                                                            let _e3290 = (_e3235 >> bitcast<u32>(16i));
                                                                                            let _e3292 = (_e3270 - floor(_e3270));
                                                                                            let _e3297 = ((select(0f, _e3292, (_e3292 <= 1f)) * f32(_e3288)) - 0.5f);
                                                                                            let _e3298 = floor(_e3297);
                                                                                            let _e3299 = (_e3297 - _e3298);
                                                                                            let _e3300 = (_e3288 - 1u);
                                                                                            if (_e3298 < 0f) {
                                                                                                phi_6497_ = _e3300;
                                                                                            } else {
                                                                                                let _e3306 = select(select(u32(_e3298), 0u, (_e3298 < 0f)), 4294967295u, (_e3298 > 4294967000f));
                                                                                                phi_6497_ = select(_e3306, _e3300, (_e3300 < _e3306));
                                                                                            }
                                                                                            let _e3310 = phi_6497_;
                                                                                            if (_e3310 == _e3300) {
                                                                                                phi_6503_ = 0u;
                                                                                            } else {
                                                                                                phi_6503_ = (_e3310 + 1u);
                                                                                            }
                                                                                            let _e3314 = phi_6503_;
                                                                                            let _e3316 = (_e3287 - floor(_e3287));
                                                                                            let _e3321 = ((select(0f, _e3316, (_e3316 <= 1f)) * f32(_e3290)) - 0.5f);
                                                                                            let _e3322 = floor(_e3321);
                                                                                            let _e3323 = (_e3321 - _e3322);
                                                                                            let _e3324 = (_e3290 - 1u);
                                                                                            if (_e3322 < 0f) {
                                                                                                phi_6533_ = _e3324;
                                                                                            } else {
                                                                                                let _e3330 = select(select(u32(_e3322), 0u, (_e3322 < 0f)), 4294967295u, (_e3322 > 4294967000f));
                                                                                                phi_6533_ = select(_e3330, _e3324, (_e3324 < _e3330));
                                                                                            }
                                                                                            let _e3334 = phi_6533_;
                                                                                            if (_e3334 == _e3324) {
                                                                                                phi_6539_ = 0u;
                                                                                            } else {
                                                                                                phi_6539_ = (_e3334 + 1u);
                                                                                            }
                                                                                            let _e3338 = phi_6539_;
                                                                                            let _e3340 = (_e3225 + (_e3334 * _e3288));
                                                                                            let _e3342 = (_e3225 + (_e3338 * _e3288));
                                                                                            let _e3343 = (_e3340 + _e3310);
                                                                                            let _e3344 = (_e3340 + _e3314);
                                                                                            let _e3345 = (_e3342 + _e3310);
                                                                                            let _e3346 = (_e3342 + _e3314);
                                                                                            if (_e3343 < _e144) {
                                                                                            } else {
                                                                                                phi_16524_ = true;
                                                                                                phi_12421_ = bool();
                                                                                                break;
                                                                                            }
                                                                                            let _e3349 = surfaces.member[_e3343];
                                                                                            if (_e3344 < _e144) {
                                                                                            } else {
                                                                                                phi_16524_ = true;
                                                                                                phi_12421_ = bool();
                                                                                                break;
                                                                                            }
                                                                                            let _e3352 = surfaces.member[_e3344];
                                                                                            if (_e3345 < _e144) {
                                                                                            } else {
                                                                                                phi_16524_ = true;
                                                                                                phi_12421_ = bool();
                                                                                                break;
                                                                                            }
                                                                                            let _e3355 = surfaces.member[_e3345];
                                                                                            if (_e3346 < _e144) {
                                                                                            } else {
                                                                                                phi_16524_ = true;
                                                                                                phi_12421_ = bool();
                                                                                                break;
                                                                                            }
                                                                                            let _e3358 = surfaces.member[_e3346];
                                                                                            let _e3375 = (1f - _e3299);
                                                                                            phi_6614_ = ((_e3240 * (((((f32((_e3349 >> bitcast<u32>(24i))) * 0.003921569f) * _e3375) + ((f32((_e3352 >> bitcast<u32>(24i))) * 0.003921569f) * _e3299)) * (1f - _e3323)) + ((((f32((_e3355 >> bitcast<u32>(24i))) * 0.003921569f) * _e3375) + ((f32((_e3358 >> bitcast<u32>(24i))) * 0.003921569f) * _e3299)) * _e3323))) < _e3245);
                                                                                        }
                                                                                        let _e3390 = phi_6614_;
                                                                                        phi_6619_ = select(true, false, _e3390);
                                                                                    }
                                                                                    let _e3393 = phi_6619_;
                                                                                    if _e3393 {
                                                                                        phi_6624_ = type_44(_e3201[0], _e2827.member_1, _e3201[1], _e3201[2]);
                                                                                    } else {
                                                                                        phi_6624_ = type_44();
                                                                                    }
                                                                                    let _e3396 = phi_6624_;
                                                                                    phi_6626_ = _e3396;
                                                                                    phi_6628_ = select(true, false, _e3393);
                                                                                } else {
                                                                                    phi_6626_ = type_44();
                                                                                    phi_6628_ = false;
                                                                                }
                                                                                let _e3399 = phi_6626_;
                                                                                let _e3401 = phi_6628_;
                                                                                phi_6629_ = _e3399;
                                                                                phi_6631_ = select(true, false, _e3205);
                                                                                phi_6632_ = _e3401;
                                                                            } else {
                                                                                phi_6629_ = type_44();
                                                                                phi_6631_ = false;
                                                                                phi_6632_ = false;
                                                                            }
                                                                            let _e3404 = phi_6629_;
                                                                            let _e3406 = phi_6631_;
                                                                            let _e3408 = phi_6632_;
                                                                            phi_6633_ = _e3404;
                                                                            phi_6634_ = select(true, false, _e3206);
                                                                            phi_6635_ = _e3406;
                                                                            phi_6636_ = _e3408;
                                                                        } else {
                                                                            phi_6633_ = type_44();
                                                                            phi_6634_ = true;
                                                                            phi_6635_ = false;
                                                                            phi_6636_ = false;
                                                                        }
                                                                        let _e3411 = phi_6633_;
                                                                        let _e3413 = phi_6634_;
                                                                        let _e3415 = phi_6635_;
                                                                        let _e3417 = phi_6636_;
                                                                        if select(select(_e3417, false, _e3413), true, select(_e3415, true, _e3413)) {
                                                                            phi_6649_ = type_44(0.9999995f, 4294967295u, 0f, 0f);
                                                                        } else {
                                                                            phi_6649_ = _e3411;
                                                                        }
                                                                        let _e3422 = phi_6649_;
                                                                        phi_6656_ = select(true, false, (_e3422.member_1 != 4294967295u));
                                                                    } else {
                                                                        phi_6656_ = false;
                                                                    }
                                                                    let _e3427 = phi_6656_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_5973_ = _e2825;
                                                                        phi_16524_ = _e2800;
                                                                        phi_12421_ = select(true, false, _e2831);
                                                                        break if !(_e3427);
                                                                    }
                                                                }
                                                                let _e3431 = phi_16524_;
                                                                let _e3433 = phi_12421_;
                                                                phi_16598_ = _e3431;
                                                                phi_12422_ = bool();
                                                                if _e3431 {
                                                                    break;
                                                                }
                                                                phi_16600_ = _e3431;
                                                                phi_6661_ = _e2804;
                                                                phi_6662_ = _e3433;
                                                            }
                                                            let _e3670 = phi_16600_;
                                                            let _e3672 = phi_6661_;
                                                            let _e3674 = phi_6662_;
                                                            if _e3674 {
                                                                let _e3675 = (_e3672 == 0u);
                                                                if _e3675 {
                                                                    phi_6678_ = u32();
                                                                    phi_6679_ = u32();
                                                                } else {
                                                                    let _e3676 = (_e3672 - 1u);
                                                                    if (_e3676 < 64u) {
                                                                    } else {
                                                                        phi_16598_ = true;
                                                                        phi_12422_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e3679 = local_9[_e3676];
                                                                    phi_6678_ = _e3679;
                                                                    phi_6679_ = _e3676;
                                                                }
                                                                let _e3681 = phi_6678_;
                                                                let _e3683 = phi_6679_;
                                                                phi_5546_ = _e3681;
                                                                phi_5549_ = _e3683;
                                                                phi_6681_ = select(true, false, _e3675);
                                                                phi_6682_ = _e3675;
                                                            } else {
                                                                phi_5546_ = u32();
                                                                phi_5549_ = u32();
                                                                phi_6681_ = false;
                                                                phi_6682_ = false;
                                                            }
                                                            let _e3686 = phi_5546_;
                                                            let _e3688 = phi_5549_;
                                                            let _e3690 = phi_6681_;
                                                            let _e3692 = phi_6682_;
                                                            continue;
                                                            continuing {
                                                                phi_16528_ = _e3670;
                                                                phi_5545_ = _e3686;
                                                                phi_5548_ = _e3688;
                                                                phi_16598_ = _e3670;
                                                                phi_12422_ = _e3692;
                                                                break if !(_e3690);
                                                            }
                                                        }
                                                        let _e3695 = phi_16598_;
                                                        let _e3697 = phi_12422_;
                                                        phi_16658_ = _e3695;
                                                        if _e3695 {
                                                            break;
                                                        }
                                                        if !(select(false, true, select(true, false, _e3697))) {
                                                            phi_6696_ = (_e2538 + _e2651);
                                                        } else {
                                                            phi_6696_ = _e2538;
                                                        }
                                                        let _e3703 = phi_6696_;
                                                        phi_16660_ = _e3695;
                                                        phi_6697_ = _e3703;
                                                    } else {
                                                        phi_16660_ = _e2534;
                                                        phi_6697_ = _e2538;
                                                    }
                                                    let _e3705 = phi_16660_;
                                                    let _e3707 = phi_6697_;
                                                    phi_16659_ = _e3705;
                                                    phi_5164_ = _e3707;
                                                } else {
                                                    phi_16659_ = _e2534;
                                                    phi_5164_ = f32();
                                                }
                                                let _e3709 = phi_16659_;
                                                let _e3711 = phi_5164_;
                                                continue;
                                                continuing {
                                                    phi_16550_ = _e3709;
                                                    phi_5158_ = _e2551;
                                                    phi_5163_ = _e3711;
                                                    phi_16658_ = _e3709;
                                                    break if !(_e2557);
                                                }
                                            }
                                            let _e3714 = phi_16658_;
                                            phi_16664_ = _e3714;
                                            if _e3714 {
                                                break;
                                            }
                                            let _e3716 = local_23;
                                            if (_e3716 <= 0f) {
                                                phi_6726_ = 0f;
                                            } else {
                                                let _e3720 = local_24;
                                                phi_6726_ = (_e3720 * _e292.member_3);
                                            }
                                            let _e3723 = phi_6726_;
                                            phi_16681_ = _e3714;
                                            phi_6732_ = _e3723;
                                        }
                                        let _e3725 = phi_16681_;
                                        let _e3727 = phi_6732_;
                                        phi_16668_ = _e3725;
                                        phi_9584_ = vec3<f32>((_e292.member_6[0] * _e3727), (_e292.member_6[1] * _e3727), (_e292.member_6[2] * _e3727));
                                        phi_9585_ = vec3<f32>();
                                        phi_9586_ = true;
                                    } else {
                                        let _e323 = (_e292.member_1 == 2u);
                                        if _e323 {
                                            let _e1416 = -(_e292.member_2[0]);
                                            let _e1417 = -(_e292.member_2[1]);
                                            let _e1418 = -(_e292.member_2[2]);
                                            let _e1423 = (((_e162.member_2[0] * _e1416) + (_e162.member_2[1] * _e1417)) + (_e162.member_2[2] * _e1418));
                                            let _e1425 = select(0f, _e1423, (_e1423 > 0f));
                                            if (_e1425 > 0f) {
                                                if ((((_e162.member_4[0] * _e1416) + (_e162.member_4[1] * _e1417)) + (_e162.member_4[2] * _e1418)) < 0f) {
                                                    phi_6778_ = -(_e162.member_9);
                                                } else {
                                                    phi_6778_ = _e162.member_9;
                                                }
                                                let _e1435 = phi_6778_;
                                                let _e1439 = (_e162.member[0] + (_e162.member_4[0] * _e1435));
                                                let _e1440 = (_e162.member[1] + (_e162.member_4[1] * _e1435));
                                                let _e1441 = (_e162.member[2] + (_e162.member_4[2] * _e1435));
                                                let _e1442 = abs(_e1416);
                                                let _e1443 = abs(_e1417);
                                                let _e1444 = abs(_e1418);
                                                let _e1445 = (_e1442 > _e1443);
                                                if _e1445 {
                                                    phi_6804_ = (_e1442 > _e1444);
                                                } else {
                                                    phi_6804_ = (_e1443 > _e1444);
                                                }
                                                let _e1449 = phi_6804_;
                                                let _e1450 = select(1u, 0u, _e1445);
                                                if _e1449 {
                                                    let _e1451 = (_e1450 + 1u);
                                                    phi_6814_ = _e1451;
                                                    phi_6817_ = select(true, false, (_e1451 == 2u));
                                                } else {
                                                    phi_6814_ = u32();
                                                    phi_6817_ = false;
                                                }
                                                let _e1455 = phi_6814_;
                                                let _e1457 = phi_6817_;
                                                let _e1458 = select(true, false, _e1449);
                                                let _e1459 = select(_e1455, 0u, _e1458);
                                                let _e1461 = select(_e1457, true, _e1458);
                                                if _e1461 {
                                                    phi_6828_ = (_e1459 + 1u);
                                                } else {
                                                    phi_6828_ = 0u;
                                                }
                                                let _e1464 = phi_6828_;
                                                let _e1465 = select(_e1455, _e1459, _e1461);
                                                let _e1466 = select(_e1450, select(_e1450, 2u, _e1458), _e1461);
                                                local_7 = array<f32, 3>(_e1416, _e1417, _e1418);
                                                local_8 = array<f32, 3>(_e1439, _e1440, _e1441);
                                                let _e1469 = (_e1466 < 3u);
                                                if _e1469 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1471 = local_7[_e1466];
                                                let _e1472 = (1f / _e1471);
                                                let _e1473 = (_e1465 < 3u);
                                                if _e1473 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1475 = local_7[_e1465];
                                                let _e1476 = (_e1475 * _e1472);
                                                let _e1477 = (_e1464 < 3u);
                                                if _e1477 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1479 = local_7[_e1464];
                                                let _e1480 = (_e1479 * _e1472);
                                                if _e1473 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1482 = local_8[_e1465];
                                                if _e1477 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1484 = local_8[_e1464];
                                                if _e1469 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1486 = local_8[_e1466];
                                                if (0u < _e135) {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e1491 = nodes.member[0u].member_7[0u];
                                                let _e1495 = nodes.member[0u].member_7[1u];
                                                let _e1499 = nodes.member[0u].member_7[2u];
                                                let _e1503 = nodes.member[0u].member_7[3u];
                                                let _e1505 = abs((_e1439 - _e1491));
                                                let _e1507 = abs((_e1440 - _e1495));
                                                let _e1509 = select(_e1507, _e1505, (_e1505 > _e1507));
                                                let _e1511 = abs((_e1441 - _e1499));
                                                let _e1515 = ((select(_e1511, _e1509, (_e1509 > _e1511)) + _e1503) * 0.0000009536743f);
                                                let _e1522 = (_e1515 + (abs(_e1439) * 0.00000023841858f));
                                                let _e1523 = (_e1515 + (abs(_e1440) * 0.00000023841858f));
                                                let _e1524 = (_e1515 + (abs(_e1441) * 0.00000023841858f));
                                                let _e1525 = select(_e1443, _e1442, _e1445);
                                                let _e1527 = select(_e1444, _e1525, (_e1525 > _e1444));
                                                let _e1528 = (_e1527 * 0.000000000001f);
                                                let _e1529 = (_e1439 + _e1522);
                                                let _e1530 = (_e1440 + _e1523);
                                                let _e1531 = (_e1441 + _e1524);
                                                let _e1532 = (_e1439 - _e1522);
                                                let _e1533 = (_e1440 - _e1523);
                                                let _e1534 = (_e1441 - _e1524);
                                                if (_e1442 > _e1528) {
                                                    phi_6958_ = (-1f / _e292.member_2[0]);
                                                } else {
                                                    phi_6958_ = (1000000000000f / _e1527);
                                                }
                                                let _e1539 = phi_6958_;
                                                if (_e1443 > _e1528) {
                                                    phi_6966_ = (-1f / _e292.member_2[1]);
                                                } else {
                                                    phi_6966_ = (1000000000000f / _e1527);
                                                }
                                                let _e1544 = phi_6966_;
                                                if (_e1444 > _e1528) {
                                                    phi_6974_ = (-1f / _e292.member_2[2]);
                                                } else {
                                                    phi_6974_ = (1000000000000f / _e1527);
                                                }
                                                let _e1549 = phi_6974_;
                                                local_6 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                phi_16408_ = _e284;
                                                phi_6977_ = 0u;
                                                phi_6980_ = 0u;
                                                loop {
                                                    let _e1551 = phi_16408_;
                                                    let _e1553 = phi_6977_;
                                                    let _e1555 = phi_6980_;
                                                    let _e1556 = (_e1553 & 15u);
                                                    let _e1558 = (_e1553 >> bitcast<u32>(4u));
                                                    if (_e1556 == 0u) {
                                                        if (_e1558 < _e135) {
                                                        } else {
                                                            phi_16464_ = true;
                                                            phi_12420_ = bool();
                                                            break;
                                                        }
                                                        let _e2188 = nodes.member[_e1558].member;
                                                        let _e2197 = ((_e2188.x - _e1529) * _e1539);
                                                        let _e2198 = ((_e2188.y - _e1529) * _e1539);
                                                        let _e2199 = ((_e2188.z - _e1529) * _e1539);
                                                        let _e2200 = ((_e2188.w - _e1529) * _e1539);
                                                        let _e2203 = nodes.member[_e1558].member_3;
                                                        let _e2212 = ((_e2203.x - _e1532) * _e1539);
                                                        let _e2213 = ((_e2203.y - _e1532) * _e1539);
                                                        let _e2214 = ((_e2203.z - _e1532) * _e1539);
                                                        let _e2215 = ((_e2203.w - _e1532) * _e1539);
                                                        let _e2218 = nodes.member[_e1558].member_1;
                                                        let _e2227 = ((_e2218.x - _e1530) * _e1544);
                                                        let _e2228 = ((_e2218.y - _e1530) * _e1544);
                                                        let _e2229 = ((_e2218.z - _e1530) * _e1544);
                                                        let _e2230 = ((_e2218.w - _e1530) * _e1544);
                                                        let _e2233 = nodes.member[_e1558].member_4;
                                                        let _e2242 = ((_e2233.x - _e1533) * _e1544);
                                                        let _e2243 = ((_e2233.y - _e1533) * _e1544);
                                                        let _e2244 = ((_e2233.z - _e1533) * _e1544);
                                                        let _e2245 = ((_e2233.w - _e1533) * _e1544);
                                                        let _e2248 = nodes.member[_e1558].member_2;
                                                        let _e2257 = ((_e2248.x - _e1531) * _e1549);
                                                        let _e2258 = ((_e2248.y - _e1531) * _e1549);
                                                        let _e2259 = ((_e2248.z - _e1531) * _e1549);
                                                        let _e2260 = ((_e2248.w - _e1531) * _e1549);
                                                        let _e2263 = nodes.member[_e1558].member_5;
                                                        let _e2272 = ((_e2263.x - _e1534) * _e1549);
                                                        let _e2273 = ((_e2263.y - _e1534) * _e1549);
                                                        let _e2274 = ((_e2263.z - _e1534) * _e1549);
                                                        let _e2275 = ((_e2263.w - _e1534) * _e1549);
                                                        let _e2277 = select(_e2212, _e2197, (_e2197 < _e2212));
                                                        let _e2279 = select(_e2213, _e2198, (_e2198 < _e2213));
                                                        let _e2281 = select(_e2214, _e2199, (_e2199 < _e2214));
                                                        let _e2283 = select(_e2215, _e2200, (_e2200 < _e2215));
                                                        let _e2285 = select(_e2242, _e2227, (_e2227 < _e2242));
                                                        let _e2287 = select(_e2243, _e2228, (_e2228 < _e2243));
                                                        let _e2289 = select(_e2244, _e2229, (_e2229 < _e2244));
                                                        let _e2291 = select(_e2245, _e2230, (_e2230 < _e2245));
                                                        let _e2293 = select(_e2285, _e2277, (_e2277 > _e2285));
                                                        let _e2295 = select(_e2287, _e2279, (_e2279 > _e2287));
                                                        let _e2297 = select(_e2289, _e2281, (_e2281 > _e2289));
                                                        let _e2299 = select(_e2291, _e2283, (_e2283 > _e2291));
                                                        let _e2301 = select(_e2272, _e2257, (_e2257 < _e2272));
                                                        let _e2303 = select(_e2273, _e2258, (_e2258 < _e2273));
                                                        let _e2305 = select(_e2274, _e2259, (_e2259 < _e2274));
                                                        let _e2307 = select(_e2275, _e2260, (_e2260 < _e2275));
                                                        let _e2309 = select(_e2301, _e2293, (_e2293 > _e2301));
                                                        let _e2311 = select(_e2303, _e2295, (_e2295 > _e2303));
                                                        let _e2313 = select(_e2305, _e2297, (_e2297 > _e2305));
                                                        let _e2315 = select(_e2307, _e2299, (_e2299 > _e2307));
                                                        let _e2317 = select(0f, _e2309, (_e2309 > 0f));
                                                        let _e2319 = select(0f, _e2311, (_e2311 > 0f));
                                                        let _e2321 = select(0f, _e2313, (_e2313 > 0f));
                                                        let _e2323 = select(0f, _e2315, (_e2315 > 0f));
                                                        let _e2325 = select(_e2212, _e2197, (_e2197 > _e2212));
                                                        let _e2327 = select(_e2213, _e2198, (_e2198 > _e2213));
                                                        let _e2329 = select(_e2214, _e2199, (_e2199 > _e2214));
                                                        let _e2331 = select(_e2215, _e2200, (_e2200 > _e2215));
                                                        let _e2333 = select(_e2242, _e2227, (_e2227 > _e2242));
                                                        let _e2335 = select(_e2243, _e2228, (_e2228 > _e2243));
                                                        let _e2337 = select(_e2244, _e2229, (_e2229 > _e2244));
                                                        let _e2339 = select(_e2245, _e2230, (_e2230 > _e2245));
                                                        let _e2341 = select(_e2333, _e2325, (_e2325 < _e2333));
                                                        let _e2343 = select(_e2335, _e2327, (_e2327 < _e2335));
                                                        let _e2345 = select(_e2337, _e2329, (_e2329 < _e2337));
                                                        let _e2347 = select(_e2339, _e2331, (_e2331 < _e2339));
                                                        let _e2349 = select(_e2272, _e2257, (_e2257 > _e2272));
                                                        let _e2351 = select(_e2273, _e2258, (_e2258 > _e2273));
                                                        let _e2353 = select(_e2274, _e2259, (_e2259 > _e2274));
                                                        let _e2355 = select(_e2275, _e2260, (_e2260 > _e2275));
                                                        let _e2357 = select(_e2349, _e2341, (_e2341 < _e2349));
                                                        let _e2359 = select(_e2351, _e2343, (_e2343 < _e2351));
                                                        let _e2361 = select(_e2353, _e2345, (_e2345 < _e2353));
                                                        let _e2363 = select(_e2355, _e2347, (_e2347 < _e2355));
                                                        let _e2383 = nodes.member[_e1558].member_6[0u];
                                                        let _e2387 = nodes.member[_e1558].member_6[1u];
                                                        let _e2391 = nodes.member[_e1558].member_6[2u];
                                                        let _e2395 = nodes.member[_e1558].member_6[3u];
                                                        if (select(340282350000000000000000000000000000000f, _e2323, (_e2323 <= select(340282350000000000000000000000000000000f, _e2363, (_e2363 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e1555 < 64u) {
                                                            } else {
                                                                phi_16464_ = true;
                                                                phi_12420_ = bool();
                                                                break;
                                                            }
                                                            local_6[_e1555] = _e2395;
                                                            phi_7365_ = (_e1555 + 1u);
                                                        } else {
                                                            phi_7365_ = _e1555;
                                                        }
                                                        let _e2401 = phi_7365_;
                                                        if (select(340282350000000000000000000000000000000f, _e2321, (_e2321 <= select(340282350000000000000000000000000000000f, _e2361, (_e2361 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e2401 < 64u) {
                                                            } else {
                                                                phi_16464_ = true;
                                                                phi_12420_ = bool();
                                                                break;
                                                            }
                                                            local_6[_e2401] = _e2391;
                                                            phi_7377_ = (_e2401 + 1u);
                                                        } else {
                                                            phi_7377_ = _e2401;
                                                        }
                                                        let _e2407 = phi_7377_;
                                                        if (select(340282350000000000000000000000000000000f, _e2319, (_e2319 <= select(340282350000000000000000000000000000000f, _e2359, (_e2359 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e2407 < 64u) {
                                                            } else {
                                                                phi_16464_ = true;
                                                                phi_12420_ = bool();
                                                                break;
                                                            }
                                                            local_6[_e2407] = _e2387;
                                                            phi_7389_ = (_e2407 + 1u);
                                                        } else {
                                                            phi_7389_ = _e2407;
                                                        }
                                                        let _e2413 = phi_7389_;
                                                        if (select(340282350000000000000000000000000000000f, _e2317, (_e2317 <= select(340282350000000000000000000000000000000f, _e2357, (_e2357 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e2413 < 64u) {
                                                            } else {
                                                                phi_16464_ = true;
                                                                phi_12420_ = bool();
                                                                break;
                                                            }
                                                            local_6[_e2413] = _e2383;
                                                            phi_7401_ = (_e2413 + 1u);
                                                        } else {
                                                            phi_7401_ = _e2413;
                                                        }
                                                        let _e2419 = phi_7401_;
                                                        phi_16466_ = _e1551;
                                                        phi_8093_ = _e2419;
                                                        phi_8094_ = true;
                                                    } else {
                                                        phi_7405_ = type_8(_e1558, (_e1558 + _e1556));
                                                        loop {
                                                            let _e1563 = phi_7405_;
                                                            if (_e1563.member < _e1563.member_1) {
                                                                phi_7406_ = type_8((_e1563.member + 1u), _e1563.member_1);
                                                                phi_7429_ = type_8(1u, _e1563.member);
                                                            } else {
                                                                phi_7406_ = _e1563;
                                                                phi_7429_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1576 = phi_7406_;
                                                            let _e1578 = phi_7429_;
                                                            let _e1582 = (bitcast<i32>(_e1578.member) != 0i);
                                                            if _e1582 {
                                                                let _e1583 = (_e1578.member_1 < _e138);
                                                                if _e1583 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                if _e1469 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1587 = triangles.member[_e1578.member_1].member[_e1466];
                                                                let _e1588 = (_e1587 - _e1486);
                                                                if _e1469 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1592 = triangles.member[_e1578.member_1].member_2[_e1466];
                                                                let _e1593 = (_e1592 - _e1486);
                                                                if _e1469 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1597 = triangles.member[_e1578.member_1].member_4[_e1466];
                                                                let _e1598 = (_e1597 - _e1486);
                                                                if _e1473 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1602 = triangles.member[_e1578.member_1].member[_e1465];
                                                                let _e1605 = ((_e1602 - _e1482) - (_e1476 * _e1588));
                                                                if _e1477 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1609 = triangles.member[_e1578.member_1].member[_e1464];
                                                                let _e1612 = ((_e1609 - _e1484) - (_e1480 * _e1588));
                                                                if _e1473 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1616 = triangles.member[_e1578.member_1].member_2[_e1465];
                                                                let _e1619 = ((_e1616 - _e1482) - (_e1476 * _e1593));
                                                                if _e1477 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1623 = triangles.member[_e1578.member_1].member_2[_e1464];
                                                                let _e1626 = ((_e1623 - _e1484) - (_e1480 * _e1593));
                                                                if _e1473 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1630 = triangles.member[_e1578.member_1].member_4[_e1465];
                                                                let _e1633 = ((_e1630 - _e1482) - (_e1476 * _e1598));
                                                                if _e1477 {
                                                                } else {
                                                                    phi_16404_ = true;
                                                                    phi_12419_ = bool();
                                                                    break;
                                                                }
                                                                let _e1637 = triangles.member[_e1578.member_1].member_4[_e1464];
                                                                let _e1640 = ((_e1637 - _e1484) - (_e1480 * _e1598));
                                                                let _e1641 = (_e1633 * _e1626);
                                                                let _e1642 = (_e1640 * _e1619);
                                                                if (_e1641 != _e1642) {
                                                                    phi_7545_ = (_e1641 - _e1642);
                                                                } else {
                                                                    let _e1644 = (_e1633 * 4097f);
                                                                    let _e1646 = (_e1644 - (_e1644 - _e1633));
                                                                    let _e1647 = (_e1626 * 4097f);
                                                                    let _e1649 = (_e1647 - (_e1647 - _e1626));
                                                                    let _e1650 = (_e1633 - _e1646);
                                                                    let _e1651 = (_e1626 - _e1649);
                                                                    let _e1660 = (_e1640 * 4097f);
                                                                    let _e1662 = (_e1660 - (_e1660 - _e1640));
                                                                    let _e1663 = (_e1619 * 4097f);
                                                                    let _e1665 = (_e1663 - (_e1663 - _e1619));
                                                                    let _e1666 = (_e1640 - _e1662);
                                                                    let _e1667 = (_e1619 - _e1665);
                                                                    phi_7545_ = ((((((_e1646 * _e1649) - _e1641) + (_e1646 * _e1651)) + (_e1650 * _e1649)) + (_e1650 * _e1651)) - (((((_e1662 * _e1665) - _e1642) + (_e1662 * _e1667)) + (_e1666 * _e1665)) + (_e1666 * _e1667)));
                                                                }
                                                                let _e1679 = phi_7545_;
                                                                let _e1680 = (_e1605 * _e1640);
                                                                let _e1681 = (_e1612 * _e1633);
                                                                if (_e1680 != _e1681) {
                                                                    phi_7556_ = (_e1680 - _e1681);
                                                                } else {
                                                                    let _e1683 = (_e1605 * 4097f);
                                                                    let _e1685 = (_e1683 - (_e1683 - _e1605));
                                                                    let _e1686 = (_e1640 * 4097f);
                                                                    let _e1688 = (_e1686 - (_e1686 - _e1640));
                                                                    let _e1689 = (_e1605 - _e1685);
                                                                    let _e1690 = (_e1640 - _e1688);
                                                                    let _e1699 = (_e1612 * 4097f);
                                                                    let _e1701 = (_e1699 - (_e1699 - _e1612));
                                                                    let _e1702 = (_e1633 * 4097f);
                                                                    let _e1704 = (_e1702 - (_e1702 - _e1633));
                                                                    let _e1705 = (_e1612 - _e1701);
                                                                    let _e1706 = (_e1633 - _e1704);
                                                                    phi_7556_ = ((((((_e1685 * _e1688) - _e1680) + (_e1685 * _e1690)) + (_e1689 * _e1688)) + (_e1689 * _e1690)) - (((((_e1701 * _e1704) - _e1681) + (_e1701 * _e1706)) + (_e1705 * _e1704)) + (_e1705 * _e1706)));
                                                                }
                                                                let _e1718 = phi_7556_;
                                                                let _e1719 = (_e1619 * _e1612);
                                                                let _e1720 = (_e1626 * _e1605);
                                                                if (_e1719 != _e1720) {
                                                                    phi_7567_ = (_e1719 - _e1720);
                                                                } else {
                                                                    let _e1722 = (_e1619 * 4097f);
                                                                    let _e1724 = (_e1722 - (_e1722 - _e1619));
                                                                    let _e1725 = (_e1612 * 4097f);
                                                                    let _e1727 = (_e1725 - (_e1725 - _e1612));
                                                                    let _e1728 = (_e1619 - _e1724);
                                                                    let _e1729 = (_e1612 - _e1727);
                                                                    let _e1738 = (_e1626 * 4097f);
                                                                    let _e1740 = (_e1738 - (_e1738 - _e1626));
                                                                    let _e1741 = (_e1605 * 4097f);
                                                                    let _e1743 = (_e1741 - (_e1741 - _e1605));
                                                                    let _e1744 = (_e1626 - _e1740);
                                                                    let _e1745 = (_e1605 - _e1743);
                                                                    phi_7567_ = ((((((_e1724 * _e1727) - _e1719) + (_e1724 * _e1729)) + (_e1728 * _e1727)) + (_e1728 * _e1729)) - (((((_e1740 * _e1743) - _e1720) + (_e1740 * _e1745)) + (_e1744 * _e1743)) + (_e1744 * _e1745)));
                                                                }
                                                                let _e1757 = phi_7567_;
                                                                if (_e1679 < 0f) {
                                                                    phi_7585_ = f32();
                                                                    phi_7586_ = true;
                                                                } else {
                                                                    if (_e1718 < 0f) {
                                                                        phi_7583_ = f32();
                                                                        phi_7584_ = true;
                                                                    } else {
                                                                        let _e1760 = (_e1757 < 0f);
                                                                        if _e1760 {
                                                                            phi_7582_ = f32();
                                                                        } else {
                                                                            phi_7582_ = ((_e1679 + _e1718) + _e1757);
                                                                        }
                                                                        let _e1764 = phi_7582_;
                                                                        phi_7583_ = _e1764;
                                                                        phi_7584_ = _e1760;
                                                                    }
                                                                    let _e1766 = phi_7583_;
                                                                    let _e1768 = phi_7584_;
                                                                    phi_7585_ = _e1766;
                                                                    phi_7586_ = _e1768;
                                                                }
                                                                let _e1770 = phi_7585_;
                                                                let _e1772 = phi_7586_;
                                                                if _e1772 {
                                                                    if (_e1679 > 0f) {
                                                                        phi_7607_ = f32();
                                                                        phi_7608_ = true;
                                                                        phi_7609_ = false;
                                                                    } else {
                                                                        let _e1774 = (_e1718 > 0f);
                                                                        if _e1774 {
                                                                            phi_7605_ = f32();
                                                                            phi_7606_ = false;
                                                                        } else {
                                                                            phi_7605_ = ((_e1679 + _e1718) + _e1757);
                                                                            phi_7606_ = select(true, false, (_e1757 > 0f));
                                                                        }
                                                                        let _e1780 = phi_7605_;
                                                                        let _e1782 = phi_7606_;
                                                                        phi_7607_ = _e1780;
                                                                        phi_7608_ = _e1774;
                                                                        phi_7609_ = _e1782;
                                                                    }
                                                                    let _e1784 = phi_7607_;
                                                                    let _e1786 = phi_7608_;
                                                                    let _e1788 = phi_7609_;
                                                                    phi_7614_ = _e1784;
                                                                    phi_7615_ = select(_e1788, false, _e1786);
                                                                } else {
                                                                    phi_7614_ = _e1770;
                                                                    phi_7615_ = true;
                                                                }
                                                                let _e1791 = phi_7614_;
                                                                let _e1793 = phi_7615_;
                                                                if _e1793 {
                                                                    let _e1794 = (_e1791 == 0f);
                                                                    if _e1794 {
                                                                        phi_7703_ = array<f32, 3>();
                                                                        phi_7704_ = array<f32, 3>();
                                                                        phi_7705_ = false;
                                                                    } else {
                                                                        let _e1795 = (_e1588 * _e1472);
                                                                        let _e1796 = (_e1593 * _e1472);
                                                                        let _e1797 = (_e1598 * _e1472);
                                                                        let _e1800 = (1f / ((_e1679 + _e1718) + _e1757));
                                                                        let _e1801 = (_e1718 * _e1800);
                                                                        let _e1802 = (_e1757 * _e1800);
                                                                        let _e1808 = ((((_e1679 * _e1800) * _e1795) + (_e1801 * _e1796)) + (_e1802 * _e1797));
                                                                        let _e1809 = abs(_e1605);
                                                                        let _e1810 = abs(_e1619);
                                                                        let _e1812 = select(_e1810, _e1809, (_e1809 > _e1810));
                                                                        let _e1813 = abs(_e1633);
                                                                        let _e1816 = abs(_e1612);
                                                                        let _e1817 = abs(_e1626);
                                                                        let _e1819 = select(_e1817, _e1816, (_e1816 > _e1817));
                                                                        let _e1820 = abs(_e1640);
                                                                        let _e1824 = abs(_e1795);
                                                                        let _e1825 = abs(_e1796);
                                                                        let _e1827 = select(_e1825, _e1824, (_e1824 > _e1825));
                                                                        let _e1828 = abs(_e1797);
                                                                        let _e1835 = (((select(_e1813, _e1812, (_e1812 > _e1813)) * select(_e1820, _e1819, (_e1819 > _e1820))) * select(_e1828, _e1827, (_e1827 > _e1828))) <= (abs((_e1791 * _e1808)) * 256f));
                                                                        if _e1835 {
                                                                            phi_7701_ = array<f32, 3>(_e1808, _e1801, _e1802);
                                                                            phi_7702_ = array<f32, 3>();
                                                                        } else {
                                                                            let _e1837 = (_e1633 * 4097f);
                                                                            let _e1839 = (_e1837 - (_e1837 - _e1633));
                                                                            let _e1840 = (_e1626 * 4097f);
                                                                            let _e1842 = (_e1840 - (_e1840 - _e1626));
                                                                            let _e1843 = (_e1633 - _e1839);
                                                                            let _e1844 = (_e1626 - _e1842);
                                                                            let _e1853 = (_e1640 * 4097f);
                                                                            let _e1855 = (_e1853 - (_e1853 - _e1640));
                                                                            let _e1856 = (_e1619 * 4097f);
                                                                            let _e1858 = (_e1856 - (_e1856 - _e1619));
                                                                            let _e1859 = (_e1640 - _e1855);
                                                                            let _e1860 = (_e1619 - _e1858);
                                                                            let _e1870 = ((_e1641 - _e1642) + ((((((_e1839 * _e1842) - _e1641) + (_e1839 * _e1844)) + (_e1843 * _e1842)) + (_e1843 * _e1844)) - (((((_e1855 * _e1858) - _e1642) + (_e1855 * _e1860)) + (_e1859 * _e1858)) + (_e1859 * _e1860))));
                                                                            let _e1872 = (_e1605 * 4097f);
                                                                            let _e1874 = (_e1872 - (_e1872 - _e1605));
                                                                            let _e1875 = (_e1605 - _e1874);
                                                                            let _e1884 = (_e1612 * 4097f);
                                                                            let _e1886 = (_e1884 - (_e1884 - _e1612));
                                                                            let _e1887 = (_e1612 - _e1886);
                                                                            let _e1897 = ((_e1680 - _e1681) + ((((((_e1874 * _e1855) - _e1680) + (_e1874 * _e1859)) + (_e1875 * _e1855)) + (_e1875 * _e1859)) - (((((_e1886 * _e1839) - _e1681) + (_e1886 * _e1843)) + (_e1887 * _e1839)) + (_e1887 * _e1843))));
                                                                            let _e1916 = ((_e1719 - _e1720) + ((((((_e1858 * _e1886) - _e1719) + (_e1858 * _e1887)) + (_e1860 * _e1886)) + (_e1860 * _e1887)) - (((((_e1842 * _e1874) - _e1720) + (_e1842 * _e1875)) + (_e1844 * _e1874)) + (_e1844 * _e1875))));
                                                                            let _e1919 = (1f / ((_e1870 + _e1897) + _e1916));
                                                                            let _e1920 = (_e1897 * _e1919);
                                                                            let _e1921 = (_e1916 * _e1919);
                                                                            phi_7701_ = array<f32, 3>();
                                                                            phi_7702_ = array<f32, 3>(((((_e1870 * _e1919) * _e1795) + (_e1920 * _e1796)) + (_e1921 * _e1797)), _e1920, _e1921);
                                                                        }
                                                                        let _e1931 = phi_7701_;
                                                                        let _e1933 = phi_7702_;
                                                                        phi_7703_ = _e1931;
                                                                        phi_7704_ = _e1933;
                                                                        phi_7705_ = _e1835;
                                                                    }
                                                                    let _e1935 = phi_7703_;
                                                                    let _e1937 = phi_7704_;
                                                                    let _e1939 = phi_7705_;
                                                                    phi_7706_ = _e1935;
                                                                    phi_7707_ = _e1937;
                                                                    phi_7708_ = _e1794;
                                                                    phi_7709_ = _e1939;
                                                                } else {
                                                                    phi_7706_ = array<f32, 3>();
                                                                    phi_7707_ = array<f32, 3>();
                                                                    phi_7708_ = true;
                                                                    phi_7709_ = false;
                                                                }
                                                                let _e1941 = phi_7706_;
                                                                let _e1943 = phi_7707_;
                                                                let _e1945 = phi_7708_;
                                                                let _e1947 = phi_7709_;
                                                                if _e1945 {
                                                                    phi_7714_ = array<f32, 3>(-1f, 0f, 0f);
                                                                } else {
                                                                    phi_7714_ = _e1941;
                                                                }
                                                                let _e1949 = phi_7714_;
                                                                if select(_e1947, true, _e1945) {
                                                                    phi_7719_ = _e1949;
                                                                } else {
                                                                    phi_7719_ = _e1943;
                                                                }
                                                                let _e1952 = phi_7719_;
                                                                let _e1956 = (_e1952[0] >= 0f);
                                                                if _e1956 {
                                                                    let _e1957 = (_e1952[0] < 340282350000000000000000000000000000000f);
                                                                    if _e1957 {
                                                                        if _e1956 {
                                                                            if _e1583 {
                                                                            } else {
                                                                                phi_16404_ = true;
                                                                                phi_12419_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1960 = triangles.member[_e1578.member_1].member_3;
                                                                            if ((_e1960 & 1u) == 0u) {
                                                                                phi_8051_ = true;
                                                                            } else {
                                                                                if _e1583 {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1965 = triangles.member[_e1578.member_1].member_1;
                                                                                let _e1966 = (_e1965 * 12u);
                                                                                if ((256u + _e1966) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e1966 + 257u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e1966 + 258u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1973 = (_e1966 + 259u);
                                                                                if (_e1973 < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1976 = surfaces.member[_e1973];
                                                                                if ((_e1966 + 260u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e1966 + 261u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e1966 + 262u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1983 = (_e1966 + 263u);
                                                                                if (_e1983 < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1986 = surfaces.member[_e1983];
                                                                                let _e1987 = (_e1966 + 264u);
                                                                                if (_e1987 < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1990 = surfaces.member[_e1987];
                                                                                let _e1991 = bitcast<f32>(_e1990);
                                                                                let _e1992 = (_e1966 + 265u);
                                                                                if (_e1992 < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1995 = surfaces.member[_e1992];
                                                                                let _e1996 = bitcast<f32>(_e1995);
                                                                                if ((_e1966 + 266u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e1966 + 267u) < _e144) {
                                                                                } else {
                                                                                    phi_16404_ = true;
                                                                                    phi_12419_ = bool();
                                                                                    break;
                                                                                }
                                                                                if (_e1976 == 4294967295u) {
                                                                                    phi_8046_ = (_e1991 < _e1996);
                                                                                } else {
                                                                                    if (_e1578.member_1 < _e141) {
                                                                                    } else {
                                                                                        phi_16404_ = true;
                                                                                        phi_12419_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e2004 = ((1f - _e1952[1]) - _e1952[2]);
                                                                                    let _e2008 = attributes.member[_e1578.member_1].member[0u];
                                                                                    let _e2013 = attributes.member[_e1578.member_1].member[2u];
                                                                                    let _e2019 = attributes.member[_e1578.member_1].member[4u];
                                                                                    let _e2021 = (((_e2008 * _e2004) + (_e2013 * _e1952[1])) + (_e2019 * _e1952[2]));
                                                                                    let _e2025 = attributes.member[_e1578.member_1].member[1u];
                                                                                    let _e2030 = attributes.member[_e1578.member_1].member[3u];
                                                                                    let _e2036 = attributes.member[_e1578.member_1].member[5u];
                                                                                    let _e2038 = (((_e2025 * _e2004) + (_e2030 * _e1952[1])) + (_e2036 * _e1952[2]));
                                                                                    let _e2039 = (_e1986 & 65535u);
                                                                                    let _e2041 = (_e1986 >> bitcast<u32>(16i));
                                                                                    let _e2043 = (_e2021 - floor(_e2021));
                                                                                    let _e2048 = ((select(0f, _e2043, (_e2043 <= 1f)) * f32(_e2039)) - 0.5f);
                                                                                    let _e2049 = floor(_e2048);
                                                                                    let _e2050 = (_e2048 - _e2049);
                                                                                    let _e2051 = (_e2039 - 1u);
                                                                                    if (_e2049 < 0f) {
                                                                                        phi_7929_ = _e2051;
                                                                                    } else {
                                                                                        let _e2057 = select(select(u32(_e2049), 0u, (_e2049 < 0f)), 4294967295u, (_e2049 > 4294967000f));
                                                                                        phi_7929_ = select(_e2057, _e2051, (_e2051 < _e2057));
                                                                                    }
                                                                                    let _e2061 = phi_7929_;
                                                                                    if (_e2061 == _e2051) {
                                                                                        phi_7935_ = 0u;
                                                                                    } else {
                                                                                        phi_7935_ = (_e2061 + 1u);
                                                                                    }
                                                                                    let _e2065 = phi_7935_;
                                                                                    let _e2067 = (_e2038 - floor(_e2038));
                                                                                    let _e2072 = ((select(0f, _e2067, (_e2067 <= 1f)) * f32(_e2041)) - 0.5f);
                                                                                    let _e2073 = floor(_e2072);
                                                                                    let _e2074 = (_e2072 - _e2073);
                                                                                    let _e2075 = (_e2041 - 1u);
                                                                                    if (_e2073 < 0f) {
                                                                                        phi_7965_ = _e2075;
                                                                                    } else {
                                                                                        let _e2081 = select(select(u32(_e2073), 0u, (_e2073 < 0f)), 4294967295u, (_e2073 > 4294967000f));
                                                                                        phi_7965_ = select(_e2081, _e2075, (_e2075 < _e2081));
                                                                                    }
                                                                                    let _e2085 = phi_7965_;
                                                                                    if (_e2085 == _e2075) {
                                                                                        phi_7971_ = 0u;
                                                                                    } else {
                                                                                        phi_7971_ = (_e2085 + 1u);
                                                                                    }
                                                                                    let _e2089 = phi_7971_;
                                                                                    let _e2091 = (_e1976 + (_e2085 * _e2039));
                                                                                    let _e2093 = (_e1976 + (_e2089 * _e2039));
                                                                                    let _e2094 = (_e2091 + _e2061);
                                                                                    let _e2095 = (_e2091 + _e2065);
                                                                                    let _e2096 = (_e2093 + _e2061);
                                                                                    let _e2097 = (_e2093 + _e2065);
                                                                                    if (_e2094 < _e144) {
                                                                                    } else {
                                                                                        phi_16404_ = true;
                                                                                        phi_12419_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e2100 = surfaces.member[_e2094];
                                                                                    if (_e2095 < _e144) {
                                                                                    } else {
                                                                                        phi_16404_ = true;
                                                                                        phi_12419_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e2103 = surfaces.member[_e2095];
                                                                                    if (_e2096 < _e144) {
                                                                                    } else {
                                                                                        phi_16404_ = true;
                                                                                        phi_12419_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e2106 = surfaces.member[_e2096];
                                                                                    if (_e2097 < _e144) {
                                                                                    } else {
                                                                                        phi_16404_ = true;
                                                                                        phi_12419_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e2109 = surfaces.member[_e2097];
                                                                                    let _e2126 = (1f - _e2050);
                                                                                    phi_8046_ = ((_e1991 * (((((f32((_e2100 >> bitcast<u32>(24i))) * 0.003921569f) * _e2126) + ((f32((_e2103 >> bitcast<u32>(24i))) * 0.003921569f) * _e2050)) * (1f - _e2074)) + ((((f32((_e2106 >> bitcast<u32>(24i))) * 0.003921569f) * _e2126) + ((f32((_e2109 >> bitcast<u32>(24i))) * 0.003921569f) * _e2050)) * _e2074))) < _e1996);
                                                                                }
                                                                                let _e2141 = phi_8046_;
                                                                                phi_8051_ = select(true, false, _e2141);
                                                                            }
                                                                            let _e2144 = phi_8051_;
                                                                            if _e2144 {
                                                                                phi_8056_ = type_44(_e1952[0], _e1578.member_1, _e1952[1], _e1952[2]);
                                                                            } else {
                                                                                phi_8056_ = type_44();
                                                                            }
                                                                            let _e2147 = phi_8056_;
                                                                            phi_8058_ = _e2147;
                                                                            phi_8060_ = select(true, false, _e2144);
                                                                        } else {
                                                                            phi_8058_ = type_44();
                                                                            phi_8060_ = false;
                                                                        }
                                                                        let _e2150 = phi_8058_;
                                                                        let _e2152 = phi_8060_;
                                                                        phi_8061_ = _e2150;
                                                                        phi_8063_ = select(true, false, _e1956);
                                                                        phi_8064_ = _e2152;
                                                                    } else {
                                                                        phi_8061_ = type_44();
                                                                        phi_8063_ = false;
                                                                        phi_8064_ = false;
                                                                    }
                                                                    let _e2155 = phi_8061_;
                                                                    let _e2157 = phi_8063_;
                                                                    let _e2159 = phi_8064_;
                                                                    phi_8065_ = _e2155;
                                                                    phi_8066_ = select(true, false, _e1957);
                                                                    phi_8067_ = _e2157;
                                                                    phi_8068_ = _e2159;
                                                                } else {
                                                                    phi_8065_ = type_44();
                                                                    phi_8066_ = true;
                                                                    phi_8067_ = false;
                                                                    phi_8068_ = false;
                                                                }
                                                                let _e2162 = phi_8065_;
                                                                let _e2164 = phi_8066_;
                                                                let _e2166 = phi_8067_;
                                                                let _e2168 = phi_8068_;
                                                                if select(select(_e2168, false, _e2164), true, select(_e2166, true, _e2164)) {
                                                                    phi_8081_ = type_44(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                                } else {
                                                                    phi_8081_ = _e2162;
                                                                }
                                                                let _e2173 = phi_8081_;
                                                                phi_8088_ = select(true, false, (_e2173.member_1 != 4294967295u));
                                                            } else {
                                                                phi_8088_ = false;
                                                            }
                                                            let _e2178 = phi_8088_;
                                                            continue;
                                                            continuing {
                                                                phi_7405_ = _e1576;
                                                                phi_16404_ = _e1551;
                                                                phi_12419_ = select(true, false, _e1582);
                                                                break if !(_e2178);
                                                            }
                                                        }
                                                        let _e2182 = phi_16404_;
                                                        let _e2184 = phi_12419_;
                                                        phi_16464_ = _e2182;
                                                        phi_12420_ = bool();
                                                        if _e2182 {
                                                            break;
                                                        }
                                                        phi_16466_ = _e2182;
                                                        phi_8093_ = _e1555;
                                                        phi_8094_ = _e2184;
                                                    }
                                                    let _e2421 = phi_16466_;
                                                    let _e2423 = phi_8093_;
                                                    let _e2425 = phi_8094_;
                                                    if _e2425 {
                                                        let _e2426 = (_e2423 == 0u);
                                                        if _e2426 {
                                                            phi_8110_ = u32();
                                                            phi_8111_ = u32();
                                                        } else {
                                                            let _e2427 = (_e2423 - 1u);
                                                            if (_e2427 < 64u) {
                                                            } else {
                                                                phi_16464_ = true;
                                                                phi_12420_ = bool();
                                                                break;
                                                            }
                                                            let _e2430 = local_6[_e2427];
                                                            phi_8110_ = _e2430;
                                                            phi_8111_ = _e2427;
                                                        }
                                                        let _e2432 = phi_8110_;
                                                        let _e2434 = phi_8111_;
                                                        phi_6978_ = _e2432;
                                                        phi_6981_ = _e2434;
                                                        phi_8113_ = select(true, false, _e2426);
                                                        phi_8114_ = _e2426;
                                                    } else {
                                                        phi_6978_ = u32();
                                                        phi_6981_ = u32();
                                                        phi_8113_ = false;
                                                        phi_8114_ = false;
                                                    }
                                                    let _e2437 = phi_6978_;
                                                    let _e2439 = phi_6981_;
                                                    let _e2441 = phi_8113_;
                                                    let _e2443 = phi_8114_;
                                                    continue;
                                                    continuing {
                                                        phi_16408_ = _e2421;
                                                        phi_6977_ = _e2437;
                                                        phi_6980_ = _e2439;
                                                        phi_16464_ = _e2421;
                                                        phi_12420_ = _e2443;
                                                        break if !(_e2441);
                                                    }
                                                }
                                                let _e2446 = phi_16464_;
                                                let _e2448 = phi_12420_;
                                                phi_16664_ = _e2446;
                                                if _e2446 {
                                                    break;
                                                }
                                                let _e2450 = select(false, true, select(true, false, _e2448));
                                                if _e2450 {
                                                    phi_8130_ = vec3<f32>();
                                                } else {
                                                    phi_8130_ = vec3<f32>((_e292.member_6[0] * _e1425), (_e292.member_6[1] * _e1425), (_e292.member_6[2] * _e1425));
                                                }
                                                let _e2456 = phi_8130_;
                                                phi_16676_ = _e2446;
                                                phi_8131_ = _e2456;
                                                phi_8132_ = _e2450;
                                            } else {
                                                phi_16676_ = _e284;
                                                phi_8131_ = vec3<f32>();
                                                phi_8132_ = true;
                                            }
                                            let _e2458 = phi_16676_;
                                            let _e2460 = phi_8131_;
                                            let _e2462 = phi_8132_;
                                            phi_16669_ = _e2458;
                                            phi_9582_ = select(_e2460, vec3<f32>(0f, 0f, 0f), vec3(_e2462));
                                            phi_9583_ = vec3<f32>();
                                        } else {
                                            let _e324 = (_e292.member[0] - _e162.member[0]);
                                            let _e325 = (_e292.member[1] - _e162.member[1]);
                                            let _e326 = (_e292.member[2] - _e162.member[2]);
                                            let _e332 = sqrt((((_e324 * _e324) + (_e325 * _e325)) + (_e326 * _e326)));
                                            let _e337 = (((_e162.member_2[0] * _e324) + (_e162.member_2[1] * _e325)) + (_e162.member_2[2] * _e326));
                                            let _e341 = ((_e332 * _e332) * _e332);
                                            let _e344 = (select(0f, _e337, (_e337 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e341, (_e341 > 0.000000000000000000000000000000000000011754944f)));
                                            if (_e292.member_1 == 1u) {
                                                let _e360 = (_e292.member_4[0] - _e292.member_4[1]);
                                                let _e363 = (((-((((_e324 * _e292.member_2[0]) + (_e325 * _e292.member_2[1])) + (_e326 * _e292.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e332, (_e332 > 0.000000000000000000000000000000000000011754944f))) - _e292.member_4[1]) / select(0.001f, _e360, (_e360 > 0.001f)));
                                                let _e365 = select(0f, _e363, (_e363 > 0f));
                                                let _e367 = select(1f, _e365, (_e365 < 1f));
                                                phi_8203_ = (_e344 * (_e367 * _e367));
                                            } else {
                                                phi_8203_ = _e344;
                                            }
                                            let _e371 = phi_8203_;
                                            if (_e371 > 0f) {
                                                if ((((_e162.member_4[0] * _e324) + (_e162.member_4[1] * _e325)) + (_e162.member_4[2] * _e326)) < 0f) {
                                                    phi_8221_ = -(_e162.member_9);
                                                } else {
                                                    phi_8221_ = _e162.member_9;
                                                }
                                                let _e381 = phi_8221_;
                                                let _e385 = (_e162.member[0] + (_e162.member_4[0] * _e381));
                                                let _e386 = (_e162.member[1] + (_e162.member_4[1] * _e381));
                                                let _e387 = (_e162.member[2] + (_e162.member_4[2] * _e381));
                                                let _e388 = (_e292.member[0] - _e385);
                                                let _e389 = (_e292.member[1] - _e386);
                                                let _e390 = (_e292.member[2] - _e387);
                                                let _e391 = abs(_e388);
                                                let _e392 = abs(_e389);
                                                let _e393 = abs(_e390);
                                                let _e394 = (_e391 > _e392);
                                                if _e394 {
                                                    phi_8247_ = (_e391 > _e393);
                                                } else {
                                                    phi_8247_ = (_e392 > _e393);
                                                }
                                                let _e398 = phi_8247_;
                                                let _e399 = select(1u, 0u, _e394);
                                                if _e398 {
                                                    let _e400 = (_e399 + 1u);
                                                    phi_8257_ = _e400;
                                                    phi_8260_ = select(true, false, (_e400 == 2u));
                                                } else {
                                                    phi_8257_ = u32();
                                                    phi_8260_ = false;
                                                }
                                                let _e404 = phi_8257_;
                                                let _e406 = phi_8260_;
                                                let _e407 = select(true, false, _e398);
                                                let _e408 = select(_e404, 0u, _e407);
                                                let _e410 = select(_e406, true, _e407);
                                                if _e410 {
                                                    phi_8271_ = (_e408 + 1u);
                                                } else {
                                                    phi_8271_ = 0u;
                                                }
                                                let _e413 = phi_8271_;
                                                let _e414 = select(_e404, _e408, _e410);
                                                let _e415 = select(_e399, select(_e399, 2u, _e407), _e410);
                                                local_4 = array<f32, 3>(_e388, _e389, _e390);
                                                local_5 = array<f32, 3>(_e385, _e386, _e387);
                                                let _e418 = (_e415 < 3u);
                                                if _e418 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e420 = local_4[_e415];
                                                let _e421 = (1f / _e420);
                                                let _e422 = (_e414 < 3u);
                                                if _e422 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e424 = local_4[_e414];
                                                let _e425 = (_e424 * _e421);
                                                let _e426 = (_e413 < 3u);
                                                if _e426 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e428 = local_4[_e413];
                                                let _e429 = (_e428 * _e421);
                                                if _e422 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e431 = local_5[_e414];
                                                if _e426 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e433 = local_5[_e413];
                                                if _e418 {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e435 = local_5[_e415];
                                                if (0u < _e135) {
                                                } else {
                                                    phi_16664_ = true;
                                                    break;
                                                }
                                                let _e440 = nodes.member[0u].member_7[0u];
                                                let _e444 = nodes.member[0u].member_7[1u];
                                                let _e448 = nodes.member[0u].member_7[2u];
                                                let _e452 = nodes.member[0u].member_7[3u];
                                                let _e454 = abs((_e385 - _e440));
                                                let _e456 = abs((_e386 - _e444));
                                                let _e458 = select(_e456, _e454, (_e454 > _e456));
                                                let _e460 = abs((_e387 - _e448));
                                                let _e464 = ((select(_e460, _e458, (_e458 > _e460)) + _e452) * 0.0000009536743f);
                                                let _e471 = (_e464 + (abs(_e385) * 0.00000023841858f));
                                                let _e472 = (_e464 + (abs(_e386) * 0.00000023841858f));
                                                let _e473 = (_e464 + (abs(_e387) * 0.00000023841858f));
                                                let _e474 = select(_e392, _e391, _e394);
                                                let _e476 = select(_e393, _e474, (_e474 > _e393));
                                                let _e477 = (_e476 * 0.000000000001f);
                                                let _e478 = (_e385 + _e471);
                                                let _e479 = (_e386 + _e472);
                                                let _e480 = (_e387 + _e473);
                                                let _e481 = (_e385 - _e471);
                                                let _e482 = (_e386 - _e472);
                                                let _e483 = (_e387 - _e473);
                                                if (_e391 > _e477) {
                                                    phi_8401_ = (1f / _e388);
                                                } else {
                                                    phi_8401_ = (1000000000000f / _e476);
                                                }
                                                let _e488 = phi_8401_;
                                                if (_e392 > _e477) {
                                                    phi_8409_ = (1f / _e389);
                                                } else {
                                                    phi_8409_ = (1000000000000f / _e476);
                                                }
                                                let _e493 = phi_8409_;
                                                if (_e393 > _e477) {
                                                    phi_8417_ = (1f / _e390);
                                                } else {
                                                    phi_8417_ = (1000000000000f / _e476);
                                                }
                                                let _e498 = phi_8417_;
                                                local_3 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                phi_16282_ = _e284;
                                                phi_8420_ = 0u;
                                                phi_8423_ = 0u;
                                                loop {
                                                    let _e500 = phi_16282_;
                                                    let _e502 = phi_8420_;
                                                    let _e504 = phi_8423_;
                                                    let _e505 = (_e502 & 15u);
                                                    let _e507 = (_e502 >> bitcast<u32>(4u));
                                                    if (_e505 == 0u) {
                                                        if (_e507 < _e135) {
                                                        } else {
                                                            phi_16344_ = true;
                                                            phi_12418_ = bool();
                                                            break;
                                                        }
                                                        let _e1137 = nodes.member[_e507].member;
                                                        let _e1146 = ((_e1137.x - _e478) * _e488);
                                                        let _e1147 = ((_e1137.y - _e478) * _e488);
                                                        let _e1148 = ((_e1137.z - _e478) * _e488);
                                                        let _e1149 = ((_e1137.w - _e478) * _e488);
                                                        let _e1152 = nodes.member[_e507].member_3;
                                                        let _e1161 = ((_e1152.x - _e481) * _e488);
                                                        let _e1162 = ((_e1152.y - _e481) * _e488);
                                                        let _e1163 = ((_e1152.z - _e481) * _e488);
                                                        let _e1164 = ((_e1152.w - _e481) * _e488);
                                                        let _e1167 = nodes.member[_e507].member_1;
                                                        let _e1176 = ((_e1167.x - _e479) * _e493);
                                                        let _e1177 = ((_e1167.y - _e479) * _e493);
                                                        let _e1178 = ((_e1167.z - _e479) * _e493);
                                                        let _e1179 = ((_e1167.w - _e479) * _e493);
                                                        let _e1182 = nodes.member[_e507].member_4;
                                                        let _e1191 = ((_e1182.x - _e482) * _e493);
                                                        let _e1192 = ((_e1182.y - _e482) * _e493);
                                                        let _e1193 = ((_e1182.z - _e482) * _e493);
                                                        let _e1194 = ((_e1182.w - _e482) * _e493);
                                                        let _e1197 = nodes.member[_e507].member_2;
                                                        let _e1206 = ((_e1197.x - _e480) * _e498);
                                                        let _e1207 = ((_e1197.y - _e480) * _e498);
                                                        let _e1208 = ((_e1197.z - _e480) * _e498);
                                                        let _e1209 = ((_e1197.w - _e480) * _e498);
                                                        let _e1212 = nodes.member[_e507].member_5;
                                                        let _e1221 = ((_e1212.x - _e483) * _e498);
                                                        let _e1222 = ((_e1212.y - _e483) * _e498);
                                                        let _e1223 = ((_e1212.z - _e483) * _e498);
                                                        let _e1224 = ((_e1212.w - _e483) * _e498);
                                                        let _e1226 = select(_e1161, _e1146, (_e1146 < _e1161));
                                                        let _e1228 = select(_e1162, _e1147, (_e1147 < _e1162));
                                                        let _e1230 = select(_e1163, _e1148, (_e1148 < _e1163));
                                                        let _e1232 = select(_e1164, _e1149, (_e1149 < _e1164));
                                                        let _e1234 = select(_e1191, _e1176, (_e1176 < _e1191));
                                                        let _e1236 = select(_e1192, _e1177, (_e1177 < _e1192));
                                                        let _e1238 = select(_e1193, _e1178, (_e1178 < _e1193));
                                                        let _e1240 = select(_e1194, _e1179, (_e1179 < _e1194));
                                                        let _e1242 = select(_e1234, _e1226, (_e1226 > _e1234));
                                                        let _e1244 = select(_e1236, _e1228, (_e1228 > _e1236));
                                                        let _e1246 = select(_e1238, _e1230, (_e1230 > _e1238));
                                                        let _e1248 = select(_e1240, _e1232, (_e1232 > _e1240));
                                                        let _e1250 = select(_e1221, _e1206, (_e1206 < _e1221));
                                                        let _e1252 = select(_e1222, _e1207, (_e1207 < _e1222));
                                                        let _e1254 = select(_e1223, _e1208, (_e1208 < _e1223));
                                                        let _e1256 = select(_e1224, _e1209, (_e1209 < _e1224));
                                                        let _e1258 = select(_e1250, _e1242, (_e1242 > _e1250));
                                                        let _e1260 = select(_e1252, _e1244, (_e1244 > _e1252));
                                                        let _e1262 = select(_e1254, _e1246, (_e1246 > _e1254));
                                                        let _e1264 = select(_e1256, _e1248, (_e1248 > _e1256));
                                                        let _e1266 = select(0f, _e1258, (_e1258 > 0f));
                                                        let _e1268 = select(0f, _e1260, (_e1260 > 0f));
                                                        let _e1270 = select(0f, _e1262, (_e1262 > 0f));
                                                        let _e1272 = select(0f, _e1264, (_e1264 > 0f));
                                                        let _e1274 = select(_e1161, _e1146, (_e1146 > _e1161));
                                                        let _e1276 = select(_e1162, _e1147, (_e1147 > _e1162));
                                                        let _e1278 = select(_e1163, _e1148, (_e1148 > _e1163));
                                                        let _e1280 = select(_e1164, _e1149, (_e1149 > _e1164));
                                                        let _e1282 = select(_e1191, _e1176, (_e1176 > _e1191));
                                                        let _e1284 = select(_e1192, _e1177, (_e1177 > _e1192));
                                                        let _e1286 = select(_e1193, _e1178, (_e1178 > _e1193));
                                                        let _e1288 = select(_e1194, _e1179, (_e1179 > _e1194));
                                                        let _e1290 = select(_e1282, _e1274, (_e1274 < _e1282));
                                                        let _e1292 = select(_e1284, _e1276, (_e1276 < _e1284));
                                                        let _e1294 = select(_e1286, _e1278, (_e1278 < _e1286));
                                                        let _e1296 = select(_e1288, _e1280, (_e1280 < _e1288));
                                                        let _e1298 = select(_e1221, _e1206, (_e1206 > _e1221));
                                                        let _e1300 = select(_e1222, _e1207, (_e1207 > _e1222));
                                                        let _e1302 = select(_e1223, _e1208, (_e1208 > _e1223));
                                                        let _e1304 = select(_e1224, _e1209, (_e1209 > _e1224));
                                                        let _e1306 = select(_e1298, _e1290, (_e1290 < _e1298));
                                                        let _e1308 = select(_e1300, _e1292, (_e1292 < _e1300));
                                                        let _e1310 = select(_e1302, _e1294, (_e1294 < _e1302));
                                                        let _e1312 = select(_e1304, _e1296, (_e1296 < _e1304));
                                                        let _e1332 = nodes.member[_e507].member_6[0u];
                                                        let _e1336 = nodes.member[_e507].member_6[1u];
                                                        let _e1340 = nodes.member[_e507].member_6[2u];
                                                        let _e1344 = nodes.member[_e507].member_6[3u];
                                                        if (select(340282350000000000000000000000000000000f, _e1272, (_e1272 <= select(0.9999995f, _e1312, (_e1312 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e504 < 64u) {
                                                            } else {
                                                                phi_16344_ = true;
                                                                phi_12418_ = bool();
                                                                break;
                                                            }
                                                            local_3[_e504] = _e1344;
                                                            phi_8808_ = (_e504 + 1u);
                                                        } else {
                                                            phi_8808_ = _e504;
                                                        }
                                                        let _e1350 = phi_8808_;
                                                        if (select(340282350000000000000000000000000000000f, _e1270, (_e1270 <= select(0.9999995f, _e1310, (_e1310 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e1350 < 64u) {
                                                            } else {
                                                                phi_16344_ = true;
                                                                phi_12418_ = bool();
                                                                break;
                                                            }
                                                            local_3[_e1350] = _e1340;
                                                            phi_8820_ = (_e1350 + 1u);
                                                        } else {
                                                            phi_8820_ = _e1350;
                                                        }
                                                        let _e1356 = phi_8820_;
                                                        if (select(340282350000000000000000000000000000000f, _e1268, (_e1268 <= select(0.9999995f, _e1308, (_e1308 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e1356 < 64u) {
                                                            } else {
                                                                phi_16344_ = true;
                                                                phi_12418_ = bool();
                                                                break;
                                                            }
                                                            local_3[_e1356] = _e1336;
                                                            phi_8832_ = (_e1356 + 1u);
                                                        } else {
                                                            phi_8832_ = _e1356;
                                                        }
                                                        let _e1362 = phi_8832_;
                                                        if (select(340282350000000000000000000000000000000f, _e1266, (_e1266 <= select(0.9999995f, _e1306, (_e1306 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e1362 < 64u) {
                                                            } else {
                                                                phi_16344_ = true;
                                                                phi_12418_ = bool();
                                                                break;
                                                            }
                                                            local_3[_e1362] = _e1332;
                                                            phi_8844_ = (_e1362 + 1u);
                                                        } else {
                                                            phi_8844_ = _e1362;
                                                        }
                                                        let _e1368 = phi_8844_;
                                                        phi_16346_ = _e500;
                                                        phi_9536_ = _e1368;
                                                        phi_9537_ = true;
                                                    } else {
                                                        phi_8848_ = type_8(_e507, (_e507 + _e505));
                                                        loop {
                                                            let _e512 = phi_8848_;
                                                            if (_e512.member < _e512.member_1) {
                                                                phi_8849_ = type_8((_e512.member + 1u), _e512.member_1);
                                                                phi_8872_ = type_8(1u, _e512.member);
                                                            } else {
                                                                phi_8849_ = _e512;
                                                                phi_8872_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e525 = phi_8849_;
                                                            let _e527 = phi_8872_;
                                                            let _e531 = (bitcast<i32>(_e527.member) != 0i);
                                                            if _e531 {
                                                                let _e532 = (_e527.member_1 < _e138);
                                                                if _e532 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                if _e418 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e536 = triangles.member[_e527.member_1].member[_e415];
                                                                let _e537 = (_e536 - _e435);
                                                                if _e418 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e541 = triangles.member[_e527.member_1].member_2[_e415];
                                                                let _e542 = (_e541 - _e435);
                                                                if _e418 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e546 = triangles.member[_e527.member_1].member_4[_e415];
                                                                let _e547 = (_e546 - _e435);
                                                                if _e422 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e551 = triangles.member[_e527.member_1].member[_e414];
                                                                let _e554 = ((_e551 - _e431) - (_e425 * _e537));
                                                                if _e426 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e558 = triangles.member[_e527.member_1].member[_e413];
                                                                let _e561 = ((_e558 - _e433) - (_e429 * _e537));
                                                                if _e422 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e565 = triangles.member[_e527.member_1].member_2[_e414];
                                                                let _e568 = ((_e565 - _e431) - (_e425 * _e542));
                                                                if _e426 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e572 = triangles.member[_e527.member_1].member_2[_e413];
                                                                let _e575 = ((_e572 - _e433) - (_e429 * _e542));
                                                                if _e422 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e579 = triangles.member[_e527.member_1].member_4[_e414];
                                                                let _e582 = ((_e579 - _e431) - (_e425 * _e547));
                                                                if _e426 {
                                                                } else {
                                                                    phi_16278_ = true;
                                                                    phi_12417_ = bool();
                                                                    break;
                                                                }
                                                                let _e586 = triangles.member[_e527.member_1].member_4[_e413];
                                                                let _e589 = ((_e586 - _e433) - (_e429 * _e547));
                                                                let _e590 = (_e582 * _e575);
                                                                let _e591 = (_e589 * _e568);
                                                                if (_e590 != _e591) {
                                                                    phi_8988_ = (_e590 - _e591);
                                                                } else {
                                                                    let _e593 = (_e582 * 4097f);
                                                                    let _e595 = (_e593 - (_e593 - _e582));
                                                                    let _e596 = (_e575 * 4097f);
                                                                    let _e598 = (_e596 - (_e596 - _e575));
                                                                    let _e599 = (_e582 - _e595);
                                                                    let _e600 = (_e575 - _e598);
                                                                    let _e609 = (_e589 * 4097f);
                                                                    let _e611 = (_e609 - (_e609 - _e589));
                                                                    let _e612 = (_e568 * 4097f);
                                                                    let _e614 = (_e612 - (_e612 - _e568));
                                                                    let _e615 = (_e589 - _e611);
                                                                    let _e616 = (_e568 - _e614);
                                                                    phi_8988_ = ((((((_e595 * _e598) - _e590) + (_e595 * _e600)) + (_e599 * _e598)) + (_e599 * _e600)) - (((((_e611 * _e614) - _e591) + (_e611 * _e616)) + (_e615 * _e614)) + (_e615 * _e616)));
                                                                }
                                                                let _e628 = phi_8988_;
                                                                let _e629 = (_e554 * _e589);
                                                                let _e630 = (_e561 * _e582);
                                                                if (_e629 != _e630) {
                                                                    phi_8999_ = (_e629 - _e630);
                                                                } else {
                                                                    let _e632 = (_e554 * 4097f);
                                                                    let _e634 = (_e632 - (_e632 - _e554));
                                                                    let _e635 = (_e589 * 4097f);
                                                                    let _e637 = (_e635 - (_e635 - _e589));
                                                                    let _e638 = (_e554 - _e634);
                                                                    let _e639 = (_e589 - _e637);
                                                                    let _e648 = (_e561 * 4097f);
                                                                    let _e650 = (_e648 - (_e648 - _e561));
                                                                    let _e651 = (_e582 * 4097f);
                                                                    let _e653 = (_e651 - (_e651 - _e582));
                                                                    let _e654 = (_e561 - _e650);
                                                                    let _e655 = (_e582 - _e653);
                                                                    phi_8999_ = ((((((_e634 * _e637) - _e629) + (_e634 * _e639)) + (_e638 * _e637)) + (_e638 * _e639)) - (((((_e650 * _e653) - _e630) + (_e650 * _e655)) + (_e654 * _e653)) + (_e654 * _e655)));
                                                                }
                                                                let _e667 = phi_8999_;
                                                                let _e668 = (_e568 * _e561);
                                                                let _e669 = (_e575 * _e554);
                                                                if (_e668 != _e669) {
                                                                    phi_9010_ = (_e668 - _e669);
                                                                } else {
                                                                    let _e671 = (_e568 * 4097f);
                                                                    let _e673 = (_e671 - (_e671 - _e568));
                                                                    let _e674 = (_e561 * 4097f);
                                                                    let _e676 = (_e674 - (_e674 - _e561));
                                                                    let _e677 = (_e568 - _e673);
                                                                    let _e678 = (_e561 - _e676);
                                                                    let _e687 = (_e575 * 4097f);
                                                                    let _e689 = (_e687 - (_e687 - _e575));
                                                                    let _e690 = (_e554 * 4097f);
                                                                    let _e692 = (_e690 - (_e690 - _e554));
                                                                    let _e693 = (_e575 - _e689);
                                                                    let _e694 = (_e554 - _e692);
                                                                    phi_9010_ = ((((((_e673 * _e676) - _e668) + (_e673 * _e678)) + (_e677 * _e676)) + (_e677 * _e678)) - (((((_e689 * _e692) - _e669) + (_e689 * _e694)) + (_e693 * _e692)) + (_e693 * _e694)));
                                                                }
                                                                let _e706 = phi_9010_;
                                                                if (_e628 < 0f) {
                                                                    phi_9028_ = f32();
                                                                    phi_9029_ = true;
                                                                } else {
                                                                    if (_e667 < 0f) {
                                                                        phi_9026_ = f32();
                                                                        phi_9027_ = true;
                                                                    } else {
                                                                        let _e709 = (_e706 < 0f);
                                                                        if _e709 {
                                                                            phi_9025_ = f32();
                                                                        } else {
                                                                            phi_9025_ = ((_e628 + _e667) + _e706);
                                                                        }
                                                                        let _e713 = phi_9025_;
                                                                        phi_9026_ = _e713;
                                                                        phi_9027_ = _e709;
                                                                    }
                                                                    let _e715 = phi_9026_;
                                                                    let _e717 = phi_9027_;
                                                                    phi_9028_ = _e715;
                                                                    phi_9029_ = _e717;
                                                                }
                                                                let _e719 = phi_9028_;
                                                                let _e721 = phi_9029_;
                                                                if _e721 {
                                                                    if (_e628 > 0f) {
                                                                        phi_9050_ = f32();
                                                                        phi_9051_ = true;
                                                                        phi_9052_ = false;
                                                                    } else {
                                                                        let _e723 = (_e667 > 0f);
                                                                        if _e723 {
                                                                            phi_9048_ = f32();
                                                                            phi_9049_ = false;
                                                                        } else {
                                                                            phi_9048_ = ((_e628 + _e667) + _e706);
                                                                            phi_9049_ = select(true, false, (_e706 > 0f));
                                                                        }
                                                                        let _e729 = phi_9048_;
                                                                        let _e731 = phi_9049_;
                                                                        phi_9050_ = _e729;
                                                                        phi_9051_ = _e723;
                                                                        phi_9052_ = _e731;
                                                                    }
                                                                    let _e733 = phi_9050_;
                                                                    let _e735 = phi_9051_;
                                                                    let _e737 = phi_9052_;
                                                                    phi_9057_ = _e733;
                                                                    phi_9058_ = select(_e737, false, _e735);
                                                                } else {
                                                                    phi_9057_ = _e719;
                                                                    phi_9058_ = true;
                                                                }
                                                                let _e740 = phi_9057_;
                                                                let _e742 = phi_9058_;
                                                                if _e742 {
                                                                    let _e743 = (_e740 == 0f);
                                                                    if _e743 {
                                                                        phi_9146_ = array<f32, 3>();
                                                                        phi_9147_ = array<f32, 3>();
                                                                        phi_9148_ = false;
                                                                    } else {
                                                                        let _e744 = (_e537 * _e421);
                                                                        let _e745 = (_e542 * _e421);
                                                                        let _e746 = (_e547 * _e421);
                                                                        let _e749 = (1f / ((_e628 + _e667) + _e706));
                                                                        let _e750 = (_e667 * _e749);
                                                                        let _e751 = (_e706 * _e749);
                                                                        let _e757 = ((((_e628 * _e749) * _e744) + (_e750 * _e745)) + (_e751 * _e746));
                                                                        let _e758 = abs(_e554);
                                                                        let _e759 = abs(_e568);
                                                                        let _e761 = select(_e759, _e758, (_e758 > _e759));
                                                                        let _e762 = abs(_e582);
                                                                        let _e765 = abs(_e561);
                                                                        let _e766 = abs(_e575);
                                                                        let _e768 = select(_e766, _e765, (_e765 > _e766));
                                                                        let _e769 = abs(_e589);
                                                                        let _e773 = abs(_e744);
                                                                        let _e774 = abs(_e745);
                                                                        let _e776 = select(_e774, _e773, (_e773 > _e774));
                                                                        let _e777 = abs(_e746);
                                                                        let _e784 = (((select(_e762, _e761, (_e761 > _e762)) * select(_e769, _e768, (_e768 > _e769))) * select(_e777, _e776, (_e776 > _e777))) <= (abs((_e740 * _e757)) * 256f));
                                                                        if _e784 {
                                                                            phi_9144_ = array<f32, 3>(_e757, _e750, _e751);
                                                                            phi_9145_ = array<f32, 3>();
                                                                        } else {
                                                                            let _e786 = (_e582 * 4097f);
                                                                            let _e788 = (_e786 - (_e786 - _e582));
                                                                            let _e789 = (_e575 * 4097f);
                                                                            let _e791 = (_e789 - (_e789 - _e575));
                                                                            let _e792 = (_e582 - _e788);
                                                                            let _e793 = (_e575 - _e791);
                                                                            let _e802 = (_e589 * 4097f);
                                                                            let _e804 = (_e802 - (_e802 - _e589));
                                                                            let _e805 = (_e568 * 4097f);
                                                                            let _e807 = (_e805 - (_e805 - _e568));
                                                                            let _e808 = (_e589 - _e804);
                                                                            let _e809 = (_e568 - _e807);
                                                                            let _e819 = ((_e590 - _e591) + ((((((_e788 * _e791) - _e590) + (_e788 * _e793)) + (_e792 * _e791)) + (_e792 * _e793)) - (((((_e804 * _e807) - _e591) + (_e804 * _e809)) + (_e808 * _e807)) + (_e808 * _e809))));
                                                                            let _e821 = (_e554 * 4097f);
                                                                            let _e823 = (_e821 - (_e821 - _e554));
                                                                            let _e824 = (_e554 - _e823);
                                                                            let _e833 = (_e561 * 4097f);
                                                                            let _e835 = (_e833 - (_e833 - _e561));
                                                                            let _e836 = (_e561 - _e835);
                                                                            let _e846 = ((_e629 - _e630) + ((((((_e823 * _e804) - _e629) + (_e823 * _e808)) + (_e824 * _e804)) + (_e824 * _e808)) - (((((_e835 * _e788) - _e630) + (_e835 * _e792)) + (_e836 * _e788)) + (_e836 * _e792))));
                                                                            let _e865 = ((_e668 - _e669) + ((((((_e807 * _e835) - _e668) + (_e807 * _e836)) + (_e809 * _e835)) + (_e809 * _e836)) - (((((_e791 * _e823) - _e669) + (_e791 * _e824)) + (_e793 * _e823)) + (_e793 * _e824))));
                                                                            let _e868 = (1f / ((_e819 + _e846) + _e865));
                                                                            let _e869 = (_e846 * _e868);
                                                                            let _e870 = (_e865 * _e868);
                                                                            phi_9144_ = array<f32, 3>();
                                                                            phi_9145_ = array<f32, 3>(((((_e819 * _e868) * _e744) + (_e869 * _e745)) + (_e870 * _e746)), _e869, _e870);
                                                                        }
                                                                        let _e880 = phi_9144_;
                                                                        let _e882 = phi_9145_;
                                                                        phi_9146_ = _e880;
                                                                        phi_9147_ = _e882;
                                                                        phi_9148_ = _e784;
                                                                    }
                                                                    let _e884 = phi_9146_;
                                                                    let _e886 = phi_9147_;
                                                                    let _e888 = phi_9148_;
                                                                    phi_9149_ = _e884;
                                                                    phi_9150_ = _e886;
                                                                    phi_9151_ = _e743;
                                                                    phi_9152_ = _e888;
                                                                } else {
                                                                    phi_9149_ = array<f32, 3>();
                                                                    phi_9150_ = array<f32, 3>();
                                                                    phi_9151_ = true;
                                                                    phi_9152_ = false;
                                                                }
                                                                let _e890 = phi_9149_;
                                                                let _e892 = phi_9150_;
                                                                let _e894 = phi_9151_;
                                                                let _e896 = phi_9152_;
                                                                if _e894 {
                                                                    phi_9157_ = array<f32, 3>(-1f, 0f, 0f);
                                                                } else {
                                                                    phi_9157_ = _e890;
                                                                }
                                                                let _e898 = phi_9157_;
                                                                if select(_e896, true, _e894) {
                                                                    phi_9162_ = _e898;
                                                                } else {
                                                                    phi_9162_ = _e892;
                                                                }
                                                                let _e901 = phi_9162_;
                                                                let _e905 = (_e901[0] >= 0f);
                                                                if _e905 {
                                                                    let _e906 = (_e901[0] < 0.9999995f);
                                                                    if _e906 {
                                                                        if _e905 {
                                                                            if _e532 {
                                                                            } else {
                                                                                phi_16278_ = true;
                                                                                phi_12417_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e909 = triangles.member[_e527.member_1].member_3;
                                                                            if ((_e909 & 1u) == 0u) {
                                                                                phi_9494_ = true;
                                                                            } else {
                                                                                if _e532 {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e914 = triangles.member[_e527.member_1].member_1;
                                                                                let _e915 = (_e914 * 12u);
                                                                                if ((256u + _e915) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e915 + 257u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e915 + 258u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e922 = (_e915 + 259u);
                                                                                if (_e922 < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e925 = surfaces.member[_e922];
                                                                                if ((_e915 + 260u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e915 + 261u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e915 + 262u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e932 = (_e915 + 263u);
                                                                                if (_e932 < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e935 = surfaces.member[_e932];
                                                                                let _e936 = (_e915 + 264u);
                                                                                if (_e936 < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e939 = surfaces.member[_e936];
                                                                                let _e940 = bitcast<f32>(_e939);
                                                                                let _e941 = (_e915 + 265u);
                                                                                if (_e941 < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e944 = surfaces.member[_e941];
                                                                                let _e945 = bitcast<f32>(_e944);
                                                                                if ((_e915 + 266u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e915 + 267u) < _e144) {
                                                                                } else {
                                                                                    phi_16278_ = true;
                                                                                    phi_12417_ = bool();
                                                                                    break;
                                                                                }
                                                                                if (_e925 == 4294967295u) {
                                                                                    phi_9489_ = (_e940 < _e945);
                                                                                } else {
                                                                                    if (_e527.member_1 < _e141) {
                                                                                    } else {
                                                                                        phi_16278_ = true;
                                                                                        phi_12417_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e953 = ((1f - _e901[1]) - _e901[2]);
                                                                                    let _e957 = attributes.member[_e527.member_1].member[0u];
                                                                                    let _e962 = attributes.member[_e527.member_1].member[2u];
                                                                                    let _e968 = attributes.member[_e527.member_1].member[4u];
                                                                                    let _e970 = (((_e957 * _e953) + (_e962 * _e901[1])) + (_e968 * _e901[2]));
                                                                                    let _e974 = attributes.member[_e527.member_1].member[1u];
                                                                                    let _e979 = attributes.member[_e527.member_1].member[3u];
                                                                                    let _e985 = attributes.member[_e527.member_1].member[5u];
                                                                                    let _e987 = (((_e974 * _e953) + (_e979 * _e901[1])) + (_e985 * _e901[2]));
                                                                                    let _e988 = (_e935 & 65535u);
                                                                                    let _e990 = (_e935 >> bitcast<u32>(16i));
                                                                                    let _e992 = (_e970 - floor(_e970));
                                                                                    let _e997 = ((select(0f, _e992, (_e992 <= 1f)) * f32(_e988)) - 0.5f);
                                                                                    let _e998 = floor(_e997);
                                                                                    let _e999 = (_e997 - _e998);
                                                                                    let _e1000 = (_e988 - 1u);
                                                                                    if (_e998 < 0f) {
                                                                                        phi_9372_ = _e1000;
                                                                                    } else {
                                                                                        let _e1006 = select(select(u32(_e998), 0u, (_e998 < 0f)), 4294967295u, (_e998 > 4294967000f));
                                                                                        phi_9372_ = select(_e1006, _e1000, (_e1000 < _e1006));
                                                                                    }
                                                                                    let _e1010 = phi_9372_;
                                                                                    if (_e1010 == _e1000) {
                                                                                        phi_9378_ = 0u;
                                                                                    } else {
                                                                                        phi_9378_ = (_e1010 + 1u);
                                                                                    }
                                                                                    let _e1014 = phi_9378_;
                                                                                    let _e1016 = (_e987 - floor(_e987));
                                                                                    let _e1021 = ((select(0f, _e1016, (_e1016 <= 1f)) * f32(_e990)) - 0.5f);
                                                                                    let _e1022 = floor(_e1021);
                                                                                    let _e1023 = (_e1021 - _e1022);
                                                                                    let _e1024 = (_e990 - 1u);
                                                                                    if (_e1022 < 0f) {
                                                                                        phi_9408_ = _e1024;
                                                                                    } else {
                                                                                        let _e1030 = select(select(u32(_e1022), 0u, (_e1022 < 0f)), 4294967295u, (_e1022 > 4294967000f));
                                                                                        phi_9408_ = select(_e1030, _e1024, (_e1024 < _e1030));
                                                                                    }
                                                                                    let _e1034 = phi_9408_;
                                                                                    if (_e1034 == _e1024) {
                                                                                        phi_9414_ = 0u;
                                                                                    } else {
                                                                                        phi_9414_ = (_e1034 + 1u);
                                                                                    }
                                                                                    let _e1038 = phi_9414_;
                                                                                    let _e1040 = (_e925 + (_e1034 * _e988));
                                                                                    let _e1042 = (_e925 + (_e1038 * _e988));
                                                                                    let _e1043 = (_e1040 + _e1010);
                                                                                    let _e1044 = (_e1040 + _e1014);
                                                                                    let _e1045 = (_e1042 + _e1010);
                                                                                    let _e1046 = (_e1042 + _e1014);
                                                                                    if (_e1043 < _e144) {
                                                                                    } else {
                                                                                        phi_16278_ = true;
                                                                                        phi_12417_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e1049 = surfaces.member[_e1043];
                                                                                    if (_e1044 < _e144) {
                                                                                    } else {
                                                                                        phi_16278_ = true;
                                                                                        phi_12417_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e1052 = surfaces.member[_e1044];
                                                                                    if (_e1045 < _e144) {
                                                                                    } else {
                                                                                        phi_16278_ = true;
                                                                                        phi_12417_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e1055 = surfaces.member[_e1045];
                                                                                    if (_e1046 < _e144) {
                                                                                    } else {
                                                                                        phi_16278_ = true;
                                                                                        phi_12417_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e1058 = surfaces.member[_e1046];
                                                                                    let _e1075 = (1f - _e999);
                                                                                    phi_9489_ = ((_e940 * (((((f32((_e1049 >> bitcast<u32>(24i))) * 0.003921569f) * _e1075) + ((f32((_e1052 >> bitcast<u32>(24i))) * 0.003921569f) * _e999)) * (1f - _e1023)) + ((((f32((_e1055 >> bitcast<u32>(24i))) * 0.003921569f) * _e1075) + ((f32((_e1058 >> bitcast<u32>(24i))) * 0.003921569f) * _e999)) * _e1023))) < _e945);
                                                                                }
                                                                                let _e1090 = phi_9489_;
                                                                                phi_9494_ = select(true, false, _e1090);
                                                                            }
                                                                            let _e1093 = phi_9494_;
                                                                            if _e1093 {
                                                                                phi_9499_ = type_44(_e901[0], _e527.member_1, _e901[1], _e901[2]);
                                                                            } else {
                                                                                phi_9499_ = type_44();
                                                                            }
                                                                            let _e1096 = phi_9499_;
                                                                            phi_9501_ = _e1096;
                                                                            phi_9503_ = select(true, false, _e1093);
                                                                        } else {
                                                                            phi_9501_ = type_44();
                                                                            phi_9503_ = false;
                                                                        }
                                                                        let _e1099 = phi_9501_;
                                                                        let _e1101 = phi_9503_;
                                                                        phi_9504_ = _e1099;
                                                                        phi_9506_ = select(true, false, _e905);
                                                                        phi_9507_ = _e1101;
                                                                    } else {
                                                                        phi_9504_ = type_44();
                                                                        phi_9506_ = false;
                                                                        phi_9507_ = false;
                                                                    }
                                                                    let _e1104 = phi_9504_;
                                                                    let _e1106 = phi_9506_;
                                                                    let _e1108 = phi_9507_;
                                                                    phi_9508_ = _e1104;
                                                                    phi_9509_ = select(true, false, _e906);
                                                                    phi_9510_ = _e1106;
                                                                    phi_9511_ = _e1108;
                                                                } else {
                                                                    phi_9508_ = type_44();
                                                                    phi_9509_ = true;
                                                                    phi_9510_ = false;
                                                                    phi_9511_ = false;
                                                                }
                                                                let _e1111 = phi_9508_;
                                                                let _e1113 = phi_9509_;
                                                                let _e1115 = phi_9510_;
                                                                let _e1117 = phi_9511_;
                                                                if select(select(_e1117, false, _e1113), true, select(_e1115, true, _e1113)) {
                                                                    phi_9524_ = type_44(0.9999995f, 4294967295u, 0f, 0f);
                                                                } else {
                                                                    phi_9524_ = _e1111;
                                                                }
                                                                let _e1122 = phi_9524_;
                                                                phi_9531_ = select(true, false, (_e1122.member_1 != 4294967295u));
                                                            } else {
                                                                phi_9531_ = false;
                                                            }
                                                            let _e1127 = phi_9531_;
                                                            continue;
                                                            continuing {
                                                                phi_8848_ = _e525;
                                                                phi_16278_ = _e500;
                                                                phi_12417_ = select(true, false, _e531);
                                                                break if !(_e1127);
                                                            }
                                                        }
                                                        let _e1131 = phi_16278_;
                                                        let _e1133 = phi_12417_;
                                                        phi_16344_ = _e1131;
                                                        phi_12418_ = bool();
                                                        if _e1131 {
                                                            break;
                                                        }
                                                        phi_16346_ = _e1131;
                                                        phi_9536_ = _e504;
                                                        phi_9537_ = _e1133;
                                                    }
                                                    let _e1370 = phi_16346_;
                                                    let _e1372 = phi_9536_;
                                                    let _e1374 = phi_9537_;
                                                    if _e1374 {
                                                        let _e1375 = (_e1372 == 0u);
                                                        if _e1375 {
                                                            phi_9553_ = u32();
                                                            phi_9554_ = u32();
                                                        } else {
                                                            let _e1376 = (_e1372 - 1u);
                                                            if (_e1376 < 64u) {
                                                            } else {
                                                                phi_16344_ = true;
                                                                phi_12418_ = bool();
                                                                break;
                                                            }
                                                            let _e1379 = local_3[_e1376];
                                                            phi_9553_ = _e1379;
                                                            phi_9554_ = _e1376;
                                                        }
                                                        let _e1381 = phi_9553_;
                                                        let _e1383 = phi_9554_;
                                                        phi_8421_ = _e1381;
                                                        phi_8424_ = _e1383;
                                                        phi_9556_ = select(true, false, _e1375);
                                                        phi_9557_ = _e1375;
                                                    } else {
                                                        phi_8421_ = u32();
                                                        phi_8424_ = u32();
                                                        phi_9556_ = false;
                                                        phi_9557_ = false;
                                                    }
                                                    let _e1386 = phi_8421_;
                                                    let _e1388 = phi_8424_;
                                                    let _e1390 = phi_9556_;
                                                    let _e1392 = phi_9557_;
                                                    continue;
                                                    continuing {
                                                        phi_16282_ = _e1370;
                                                        phi_8420_ = _e1386;
                                                        phi_8423_ = _e1388;
                                                        phi_16344_ = _e1370;
                                                        phi_12418_ = _e1392;
                                                        break if !(_e1390);
                                                    }
                                                }
                                                let _e1395 = phi_16344_;
                                                let _e1397 = phi_12418_;
                                                phi_16664_ = _e1395;
                                                if _e1395 {
                                                    break;
                                                }
                                                let _e1400 = !(select(false, true, select(true, false, _e1397)));
                                                if _e1400 {
                                                    phi_9574_ = vec3<f32>((_e292.member_6[0] * _e371), (_e292.member_6[1] * _e371), (_e292.member_6[2] * _e371));
                                                } else {
                                                    phi_9574_ = vec3<f32>();
                                                }
                                                let _e1406 = phi_9574_;
                                                phi_16671_ = _e1395;
                                                phi_9576_ = _e1406;
                                                phi_9577_ = select(true, false, _e1400);
                                            } else {
                                                phi_16671_ = _e284;
                                                phi_9576_ = vec3<f32>();
                                                phi_9577_ = true;
                                            }
                                            let _e1409 = phi_16671_;
                                            let _e1411 = phi_9576_;
                                            let _e1413 = phi_9577_;
                                            phi_16669_ = _e1409;
                                            phi_9582_ = vec3<f32>();
                                            phi_9583_ = select(_e1411, vec3<f32>(0f, 0f, 0f), vec3(_e1413));
                                        }
                                        let _e2466 = phi_16669_;
                                        let _e2468 = phi_9582_;
                                        let _e2470 = phi_9583_;
                                        phi_16668_ = _e2466;
                                        phi_9584_ = _e2468;
                                        phi_9585_ = _e2470;
                                        phi_9586_ = _e323;
                                    }
                                    let _e3733 = phi_16668_;
                                    let _e3735 = phi_9584_;
                                    let _e3737 = phi_9585_;
                                    let _e3739 = phi_9586_;
                                    let _e3741 = select(_e3737, _e3735, vec3(_e3739));
                                    phi_16666_ = _e3733;
                                    phi_9606_ = vec3<f32>((_e236.x + (_e3741.x * _e296)), (_e236.y + (_e3741.y * _e296)), (_e236.z + (_e3741.z * _e296)));
                                } else {
                                    phi_16666_ = _e284;
                                    phi_9606_ = _e236;
                                }
                                let _e3756 = phi_16666_;
                                let _e3758 = phi_9606_;
                                phi_16665_ = _e3756;
                                phi_4963_ = _e3758;
                            } else {
                                phi_16665_ = _e232;
                                phi_4963_ = vec3<f32>();
                            }
                            let _e3760 = phi_16665_;
                            let _e3762 = phi_4963_;
                            continue;
                            continuing {
                                phi_16276_ = _e3760;
                                phi_4959_ = _e249;
                                phi_4962_ = _e3762;
                                phi_16664_ = _e3760;
                                break if !(_e255);
                            }
                        }
                        let _e3765 = phi_16664_;
                        if _e3765 {
                            break;
                        }
                        phi_17291_ = _e3765;
                        let _e10033 = local_32;
                        phi_9607_ = _e10033;
                    }
                    let _e8060 = phi_17291_;
                    let _e8062 = phi_9607_;
                    let _e8065 = params.member.member_4;
                    if (_e8065 > 0u) {
                        let _e8070 = ((_e213 ^ (_e213 >> bitcast<u32>(16i))) * 2146121005u);
                        let _e8074 = ((_e8070 ^ (_e8070 >> bitcast<u32>(15i))) * 2221713035u);
                        let _e8077 = (_e8074 ^ (_e8074 >> bitcast<u32>(16i)));
                        let _e8081 = bitcast<f32>((1065353216u | (bitcast<u32>(_e162.member_2[2]) & 2147483648u)));
                        let _e8083 = (-1f / (_e8081 + _e162.member_2[2]));
                        let _e8085 = ((_e162.member_2[0] * _e162.member_2[1]) * _e8083);
                        phi_17290_ = _e8060;
                        phi_9647_ = type_8(0u, _e8065);
                        phi_9650_ = 0i;
                        loop {
                            let _e8099 = phi_17290_;
                            let _e8101 = phi_9647_;
                            let _e8103 = phi_9650_;
                            local_30 = _e8103;
                            if (_e8101.member < _e8101.member_1) {
                                phi_9648_ = type_8((_e8101.member + 1u), _e8101.member_1);
                                phi_9673_ = type_8(1u, _e8101.member);
                            } else {
                                phi_9648_ = _e8101;
                                phi_9673_ = type_8(0u, type_8().member_1);
                            }
                            let _e8116 = phi_9648_;
                            let _e8118 = phi_9673_;
                            let _e8122 = (bitcast<i32>(_e8118.member) != 0i);
                            if _e8122 {
                                let _e8126 = ((_e8077 ^ (_e8077 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e8130 = ((_e8126 ^ (_e8126 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e8137 = (_e8077 ^ 2654435769u);
                                let _e8141 = ((_e8137 ^ (_e8137 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e8145 = ((_e8141 ^ (_e8141 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e8163 = (0.000000059604645f * (f32(((2147483648u + (_e8118.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e8130 ^ (_e8130 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                if (_e8163 >= 1f) {
                                    phi_16020_ = (_e8163 - 1f);
                                } else {
                                    phi_16020_ = _e8163;
                                }
                                let _e8167 = phi_16020_;
                                let _e8169 = (0.000000059604645f * (f32(((2147483648u + (_e8118.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e8145 ^ (_e8145 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                if (_e8169 >= 1f) {
                                    phi_16028_ = (_e8169 - 1f);
                                } else {
                                    phi_16028_ = _e8169;
                                }
                                let _e8173 = phi_16028_;
                                let _e8175 = ((2f * _e8167) - 1f);
                                let _e8177 = ((2f * _e8173) - 1f);
                                if (_e8175 == 0f) {
                                    let _e8179 = (_e8177 == 0f);
                                    phi_9737_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e8179));
                                    phi_9738_ = select(true, false, _e8179);
                                } else {
                                    phi_9737_ = vec2<f32>();
                                    phi_9738_ = true;
                                }
                                let _e8184 = phi_9737_;
                                let _e8186 = phi_9738_;
                                if _e8186 {
                                    if (abs(_e8175) > abs(_e8177)) {
                                        let _e8243 = (_e8177 / _e8175);
                                        let _e8247 = floor(((_e8243 * 0.5f) + 0.5f));
                                        let _e8253 = ((((0.7853982f * _e8243) - (_e8247 * 1.5703125f)) - (_e8247 * 0.0004837513f)) - (_e8247 * 0.0000000754979f));
                                        let _e8254 = (_e8253 * _e8253);
                                        let _e8261 = (_e8253 + ((_e8253 * _e8254) * (-0.16666655f + (_e8254 * (0.008332161f + (_e8254 * -0.00019515296f))))));
                                        let _e8270 = ((1f - (0.5f * _e8254)) + ((_e8254 * _e8254) * (0.041666646f + (_e8254 * (-0.0013887316f + (_e8254 * 0.000024433157f))))));
                                        let _e8277 = select(0i, select(select(i32(_e8247), i32(-2147483648), (_e8247 < -2147483600f)), 2147483647i, (_e8247 > 2147483500f)), (_e8247 == _e8247));
                                        let _e8279 = ((_e8277 & 1i) == 0i);
                                        let _e8280 = select(_e8270, _e8261, _e8279);
                                        let _e8281 = select(_e8261, _e8270, _e8279);
                                        if ((_e8277 & 2i) == 0i) {
                                            phi_9802_ = _e8280;
                                        } else {
                                            phi_9802_ = -(_e8280);
                                        }
                                        let _e8286 = phi_9802_;
                                        if (((_e8277 + 1i) & 2i) == 0i) {
                                            phi_9810_ = _e8281;
                                        } else {
                                            phi_9810_ = -(_e8281);
                                        }
                                        let _e8292 = phi_9810_;
                                        phi_9880_ = vec2<f32>((_e8175 * _e8292), (_e8175 * _e8286));
                                    } else {
                                        let _e8190 = (_e8175 / _e8177);
                                        let _e8194 = floor(((_e8190 * 0.5f) + 0.5f));
                                        let _e8200 = ((((0.7853982f * _e8190) - (_e8194 * 1.5703125f)) - (_e8194 * 0.0004837513f)) - (_e8194 * 0.0000000754979f));
                                        let _e8201 = (_e8200 * _e8200);
                                        let _e8208 = (_e8200 + ((_e8200 * _e8201) * (-0.16666655f + (_e8201 * (0.008332161f + (_e8201 * -0.00019515296f))))));
                                        let _e8217 = ((1f - (0.5f * _e8201)) + ((_e8201 * _e8201) * (0.041666646f + (_e8201 * (-0.0013887316f + (_e8201 * 0.000024433157f))))));
                                        let _e8224 = select(0i, select(select(i32(_e8194), i32(-2147483648), (_e8194 < -2147483600f)), 2147483647i, (_e8194 > 2147483500f)), (_e8194 == _e8194));
                                        let _e8226 = ((_e8224 & 1i) == 0i);
                                        let _e8227 = select(_e8217, _e8208, _e8226);
                                        let _e8228 = select(_e8208, _e8217, _e8226);
                                        if ((_e8224 & 2i) == 0i) {
                                            phi_9868_ = _e8227;
                                        } else {
                                            phi_9868_ = -(_e8227);
                                        }
                                        let _e8233 = phi_9868_;
                                        if (((_e8224 + 1i) & 2i) == 0i) {
                                            phi_9876_ = _e8228;
                                        } else {
                                            phi_9876_ = -(_e8228);
                                        }
                                        let _e8239 = phi_9876_;
                                        phi_9880_ = vec2<f32>((_e8177 * _e8233), (_e8177 * _e8239));
                                    }
                                    let _e8297 = phi_9880_;
                                    phi_9881_ = _e8297;
                                } else {
                                    phi_9881_ = _e8184;
                                }
                                let _e8299 = phi_9881_;
                                let _e8305 = (1f - ((_e8299.x * _e8299.x) + (_e8299.y * _e8299.y)));
                                let _e8308 = sqrt(select(0f, _e8305, (_e8305 > 0f)));
                                let _e8321 = ((((1f + (((_e8081 * _e162.member_2[0]) * _e162.member_2[0]) * _e8083)) * _e8299.x) + (_e8085 * _e8299.y)) + (_e162.member_2[0] * _e8308));
                                let _e8322 = ((((_e8081 * _e8085) * _e8299.x) + ((_e8081 + ((_e162.member_2[1] * _e162.member_2[1]) * _e8083)) * _e8299.y)) + (_e162.member_2[1] * _e8308));
                                let _e8323 = ((((-(_e8081) * _e162.member_2[0]) * _e8299.x) + (-(_e162.member_2[1]) * _e8299.y)) + (_e162.member_2[2] * _e8308));
                                if ((((_e162.member_4[0] * _e8321) + (_e162.member_4[1] * _e8322)) + (_e162.member_4[2] * _e8323)) < 0f) {
                                    phi_9919_ = -(_e162.member_9);
                                } else {
                                    phi_9919_ = _e162.member_9;
                                }
                                let _e8332 = phi_9919_;
                                let _e8336 = (_e162.member[0] + (_e162.member_4[0] * _e8332));
                                let _e8337 = (_e162.member[1] + (_e162.member_4[1] * _e8332));
                                let _e8338 = (_e162.member[2] + (_e162.member_4[2] * _e8332));
                                let _e8339 = abs(_e8321);
                                let _e8340 = abs(_e8322);
                                let _e8341 = abs(_e8323);
                                let _e8342 = (_e8339 > _e8340);
                                if _e8342 {
                                    phi_9942_ = (_e8339 > _e8341);
                                } else {
                                    phi_9942_ = (_e8340 > _e8341);
                                }
                                let _e8346 = phi_9942_;
                                let _e8347 = select(1u, 0u, _e8342);
                                if _e8346 {
                                    let _e8348 = (_e8347 + 1u);
                                    phi_9952_ = _e8348;
                                    phi_9955_ = select(true, false, (_e8348 == 2u));
                                } else {
                                    phi_9952_ = u32();
                                    phi_9955_ = false;
                                }
                                let _e8352 = phi_9952_;
                                let _e8354 = phi_9955_;
                                let _e8355 = select(true, false, _e8346);
                                let _e8356 = select(_e8352, 0u, _e8355);
                                let _e8358 = select(_e8354, true, _e8355);
                                if _e8358 {
                                    phi_9966_ = (_e8356 + 1u);
                                } else {
                                    phi_9966_ = 0u;
                                }
                                let _e8361 = phi_9966_;
                                let _e8362 = select(_e8352, _e8356, _e8358);
                                let _e8363 = select(_e8347, select(_e8347, 2u, _e8355), _e8358);
                                local_1 = array<f32, 3>(_e8321, _e8322, _e8323);
                                local_2 = array<f32, 3>(_e8336, _e8337, _e8338);
                                let _e8366 = (_e8363 < 3u);
                                if _e8366 {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8368 = local_1[_e8363];
                                let _e8369 = (1f / _e8368);
                                let _e8370 = (_e8362 < 3u);
                                if _e8370 {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8372 = local_1[_e8362];
                                let _e8373 = (_e8372 * _e8369);
                                let _e8374 = (_e8361 < 3u);
                                if _e8374 {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8376 = local_1[_e8361];
                                let _e8377 = (_e8376 * _e8369);
                                if _e8370 {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8379 = local_2[_e8362];
                                if _e8374 {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8381 = local_2[_e8361];
                                if _e8366 {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8383 = local_2[_e8363];
                                if (0u < _e135) {
                                } else {
                                    phi_17402_ = true;
                                    break;
                                }
                                let _e8388 = nodes.member[0u].member_7[0u];
                                let _e8392 = nodes.member[0u].member_7[1u];
                                let _e8396 = nodes.member[0u].member_7[2u];
                                let _e8400 = nodes.member[0u].member_7[3u];
                                let _e8402 = abs((_e8336 - _e8388));
                                let _e8404 = abs((_e8337 - _e8392));
                                let _e8406 = select(_e8404, _e8402, (_e8402 > _e8404));
                                let _e8408 = abs((_e8338 - _e8396));
                                let _e8412 = ((select(_e8408, _e8406, (_e8406 > _e8408)) + _e8400) * 0.0000009536743f);
                                let _e8419 = (_e8412 + (abs(_e8336) * 0.00000023841858f));
                                let _e8420 = (_e8412 + (abs(_e8337) * 0.00000023841858f));
                                let _e8421 = (_e8412 + (abs(_e8338) * 0.00000023841858f));
                                let _e8422 = select(_e8340, _e8339, _e8342);
                                let _e8424 = select(_e8341, _e8422, (_e8422 > _e8341));
                                let _e8425 = (_e8424 * 0.000000000001f);
                                let _e8426 = (_e8336 + _e8419);
                                let _e8427 = (_e8337 + _e8420);
                                let _e8428 = (_e8338 + _e8421);
                                let _e8429 = (_e8336 - _e8419);
                                let _e8430 = (_e8337 - _e8420);
                                let _e8431 = (_e8338 - _e8421);
                                if (_e8339 > _e8425) {
                                    phi_10096_ = (1f / _e8321);
                                } else {
                                    phi_10096_ = (1000000000000f / _e8424);
                                }
                                let _e8436 = phi_10096_;
                                if (_e8340 > _e8425) {
                                    phi_10104_ = (1f / _e8322);
                                } else {
                                    phi_10104_ = (1000000000000f / _e8424);
                                }
                                let _e8441 = phi_10104_;
                                if (_e8341 > _e8425) {
                                    phi_10112_ = (1f / _e8323);
                                } else {
                                    phi_10112_ = (1000000000000f / _e8424);
                                }
                                let _e8446 = phi_10112_;
                                local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                phi_17271_ = _e8099;
                                phi_10115_ = 0u;
                                phi_10118_ = 0u;
                                loop {
                                    let _e8448 = phi_17271_;
                                    let _e8450 = phi_10115_;
                                    let _e8452 = phi_10118_;
                                    let _e8453 = (_e8450 & 15u);
                                    let _e8455 = (_e8450 >> bitcast<u32>(4u));
                                    if (_e8453 == 0u) {
                                        if (_e8455 < _e135) {
                                        } else {
                                            phi_17342_ = true;
                                            phi_12430_ = bool();
                                            break;
                                        }
                                        let _e9085 = nodes.member[_e8455].member;
                                        let _e9094 = ((_e9085.x - _e8426) * _e8436);
                                        let _e9095 = ((_e9085.y - _e8426) * _e8436);
                                        let _e9096 = ((_e9085.z - _e8426) * _e8436);
                                        let _e9097 = ((_e9085.w - _e8426) * _e8436);
                                        let _e9100 = nodes.member[_e8455].member_3;
                                        let _e9109 = ((_e9100.x - _e8429) * _e8436);
                                        let _e9110 = ((_e9100.y - _e8429) * _e8436);
                                        let _e9111 = ((_e9100.z - _e8429) * _e8436);
                                        let _e9112 = ((_e9100.w - _e8429) * _e8436);
                                        let _e9115 = nodes.member[_e8455].member_1;
                                        let _e9124 = ((_e9115.x - _e8427) * _e8441);
                                        let _e9125 = ((_e9115.y - _e8427) * _e8441);
                                        let _e9126 = ((_e9115.z - _e8427) * _e8441);
                                        let _e9127 = ((_e9115.w - _e8427) * _e8441);
                                        let _e9130 = nodes.member[_e8455].member_4;
                                        let _e9139 = ((_e9130.x - _e8430) * _e8441);
                                        let _e9140 = ((_e9130.y - _e8430) * _e8441);
                                        let _e9141 = ((_e9130.z - _e8430) * _e8441);
                                        let _e9142 = ((_e9130.w - _e8430) * _e8441);
                                        let _e9145 = nodes.member[_e8455].member_2;
                                        let _e9154 = ((_e9145.x - _e8428) * _e8446);
                                        let _e9155 = ((_e9145.y - _e8428) * _e8446);
                                        let _e9156 = ((_e9145.z - _e8428) * _e8446);
                                        let _e9157 = ((_e9145.w - _e8428) * _e8446);
                                        let _e9160 = nodes.member[_e8455].member_5;
                                        let _e9169 = ((_e9160.x - _e8431) * _e8446);
                                        let _e9170 = ((_e9160.y - _e8431) * _e8446);
                                        let _e9171 = ((_e9160.z - _e8431) * _e8446);
                                        let _e9172 = ((_e9160.w - _e8431) * _e8446);
                                        let _e9174 = select(_e9109, _e9094, (_e9094 < _e9109));
                                        let _e9176 = select(_e9110, _e9095, (_e9095 < _e9110));
                                        let _e9178 = select(_e9111, _e9096, (_e9096 < _e9111));
                                        let _e9180 = select(_e9112, _e9097, (_e9097 < _e9112));
                                        let _e9182 = select(_e9139, _e9124, (_e9124 < _e9139));
                                        let _e9184 = select(_e9140, _e9125, (_e9125 < _e9140));
                                        let _e9186 = select(_e9141, _e9126, (_e9126 < _e9141));
                                        let _e9188 = select(_e9142, _e9127, (_e9127 < _e9142));
                                        let _e9190 = select(_e9182, _e9174, (_e9174 > _e9182));
                                        let _e9192 = select(_e9184, _e9176, (_e9176 > _e9184));
                                        let _e9194 = select(_e9186, _e9178, (_e9178 > _e9186));
                                        let _e9196 = select(_e9188, _e9180, (_e9180 > _e9188));
                                        let _e9198 = select(_e9169, _e9154, (_e9154 < _e9169));
                                        let _e9200 = select(_e9170, _e9155, (_e9155 < _e9170));
                                        let _e9202 = select(_e9171, _e9156, (_e9156 < _e9171));
                                        let _e9204 = select(_e9172, _e9157, (_e9157 < _e9172));
                                        let _e9206 = select(_e9198, _e9190, (_e9190 > _e9198));
                                        let _e9208 = select(_e9200, _e9192, (_e9192 > _e9200));
                                        let _e9210 = select(_e9202, _e9194, (_e9194 > _e9202));
                                        let _e9212 = select(_e9204, _e9196, (_e9196 > _e9204));
                                        let _e9214 = select(0f, _e9206, (_e9206 > 0f));
                                        let _e9216 = select(0f, _e9208, (_e9208 > 0f));
                                        let _e9218 = select(0f, _e9210, (_e9210 > 0f));
                                        let _e9220 = select(0f, _e9212, (_e9212 > 0f));
                                        let _e9222 = select(_e9109, _e9094, (_e9094 > _e9109));
                                        let _e9224 = select(_e9110, _e9095, (_e9095 > _e9110));
                                        let _e9226 = select(_e9111, _e9096, (_e9096 > _e9111));
                                        let _e9228 = select(_e9112, _e9097, (_e9097 > _e9112));
                                        let _e9230 = select(_e9139, _e9124, (_e9124 > _e9139));
                                        let _e9232 = select(_e9140, _e9125, (_e9125 > _e9140));
                                        let _e9234 = select(_e9141, _e9126, (_e9126 > _e9141));
                                        let _e9236 = select(_e9142, _e9127, (_e9127 > _e9142));
                                        let _e9238 = select(_e9230, _e9222, (_e9222 < _e9230));
                                        let _e9240 = select(_e9232, _e9224, (_e9224 < _e9232));
                                        let _e9242 = select(_e9234, _e9226, (_e9226 < _e9234));
                                        let _e9244 = select(_e9236, _e9228, (_e9228 < _e9236));
                                        let _e9246 = select(_e9169, _e9154, (_e9154 > _e9169));
                                        let _e9248 = select(_e9170, _e9155, (_e9155 > _e9170));
                                        let _e9250 = select(_e9171, _e9156, (_e9156 > _e9171));
                                        let _e9252 = select(_e9172, _e9157, (_e9157 > _e9172));
                                        let _e9254 = select(_e9246, _e9238, (_e9238 < _e9246));
                                        let _e9256 = select(_e9248, _e9240, (_e9240 < _e9248));
                                        let _e9258 = select(_e9250, _e9242, (_e9242 < _e9250));
                                        let _e9260 = select(_e9252, _e9244, (_e9244 < _e9252));
                                        let _e9280 = nodes.member[_e8455].member_6[0u];
                                        let _e9284 = nodes.member[_e8455].member_6[1u];
                                        let _e9288 = nodes.member[_e8455].member_6[2u];
                                        let _e9292 = nodes.member[_e8455].member_6[3u];
                                        if (select(340282350000000000000000000000000000000f, _e9220, (_e9220 <= select(340282350000000000000000000000000000000f, _e9260, (_e9260 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                            if (_e8452 < 64u) {
                                            } else {
                                                phi_17342_ = true;
                                                phi_12430_ = bool();
                                                break;
                                            }
                                            local[_e8452] = _e9292;
                                            phi_10503_ = (_e8452 + 1u);
                                        } else {
                                            phi_10503_ = _e8452;
                                        }
                                        let _e9298 = phi_10503_;
                                        if (select(340282350000000000000000000000000000000f, _e9218, (_e9218 <= select(340282350000000000000000000000000000000f, _e9258, (_e9258 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                            if (_e9298 < 64u) {
                                            } else {
                                                phi_17342_ = true;
                                                phi_12430_ = bool();
                                                break;
                                            }
                                            local[_e9298] = _e9288;
                                            phi_10515_ = (_e9298 + 1u);
                                        } else {
                                            phi_10515_ = _e9298;
                                        }
                                        let _e9304 = phi_10515_;
                                        if (select(340282350000000000000000000000000000000f, _e9216, (_e9216 <= select(340282350000000000000000000000000000000f, _e9256, (_e9256 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                            if (_e9304 < 64u) {
                                            } else {
                                                phi_17342_ = true;
                                                phi_12430_ = bool();
                                                break;
                                            }
                                            local[_e9304] = _e9284;
                                            phi_10527_ = (_e9304 + 1u);
                                        } else {
                                            phi_10527_ = _e9304;
                                        }
                                        let _e9310 = phi_10527_;
                                        if (select(340282350000000000000000000000000000000f, _e9214, (_e9214 <= select(340282350000000000000000000000000000000f, _e9254, (_e9254 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                            if (_e9310 < 64u) {
                                            } else {
                                                phi_17342_ = true;
                                                phi_12430_ = bool();
                                                break;
                                            }
                                            local[_e9310] = _e9280;
                                            phi_10539_ = (_e9310 + 1u);
                                        } else {
                                            phi_10539_ = _e9310;
                                        }
                                        let _e9316 = phi_10539_;
                                        phi_17344_ = _e8448;
                                        phi_11231_ = _e9316;
                                        phi_11232_ = true;
                                    } else {
                                        phi_10543_ = type_8(_e8455, (_e8455 + _e8453));
                                        loop {
                                            let _e8460 = phi_10543_;
                                            if (_e8460.member < _e8460.member_1) {
                                                phi_10544_ = type_8((_e8460.member + 1u), _e8460.member_1);
                                                phi_10567_ = type_8(1u, _e8460.member);
                                            } else {
                                                phi_10544_ = _e8460;
                                                phi_10567_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e8473 = phi_10544_;
                                            let _e8475 = phi_10567_;
                                            let _e8479 = (bitcast<i32>(_e8475.member) != 0i);
                                            if _e8479 {
                                                let _e8480 = (_e8475.member_1 < _e138);
                                                if _e8480 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                if _e8366 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8484 = triangles.member[_e8475.member_1].member[_e8363];
                                                let _e8485 = (_e8484 - _e8383);
                                                if _e8366 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8489 = triangles.member[_e8475.member_1].member_2[_e8363];
                                                let _e8490 = (_e8489 - _e8383);
                                                if _e8366 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8494 = triangles.member[_e8475.member_1].member_4[_e8363];
                                                let _e8495 = (_e8494 - _e8383);
                                                if _e8370 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8499 = triangles.member[_e8475.member_1].member[_e8362];
                                                let _e8502 = ((_e8499 - _e8379) - (_e8373 * _e8485));
                                                if _e8374 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8506 = triangles.member[_e8475.member_1].member[_e8361];
                                                let _e8509 = ((_e8506 - _e8381) - (_e8377 * _e8485));
                                                if _e8370 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8513 = triangles.member[_e8475.member_1].member_2[_e8362];
                                                let _e8516 = ((_e8513 - _e8379) - (_e8373 * _e8490));
                                                if _e8374 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8520 = triangles.member[_e8475.member_1].member_2[_e8361];
                                                let _e8523 = ((_e8520 - _e8381) - (_e8377 * _e8490));
                                                if _e8370 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8527 = triangles.member[_e8475.member_1].member_4[_e8362];
                                                let _e8530 = ((_e8527 - _e8379) - (_e8373 * _e8495));
                                                if _e8374 {
                                                } else {
                                                    phi_17267_ = true;
                                                    phi_12429_ = bool();
                                                    break;
                                                }
                                                let _e8534 = triangles.member[_e8475.member_1].member_4[_e8361];
                                                let _e8537 = ((_e8534 - _e8381) - (_e8377 * _e8495));
                                                let _e8538 = (_e8530 * _e8523);
                                                let _e8539 = (_e8537 * _e8516);
                                                if (_e8538 != _e8539) {
                                                    phi_10683_ = (_e8538 - _e8539);
                                                } else {
                                                    let _e8541 = (_e8530 * 4097f);
                                                    let _e8543 = (_e8541 - (_e8541 - _e8530));
                                                    let _e8544 = (_e8523 * 4097f);
                                                    let _e8546 = (_e8544 - (_e8544 - _e8523));
                                                    let _e8547 = (_e8530 - _e8543);
                                                    let _e8548 = (_e8523 - _e8546);
                                                    let _e8557 = (_e8537 * 4097f);
                                                    let _e8559 = (_e8557 - (_e8557 - _e8537));
                                                    let _e8560 = (_e8516 * 4097f);
                                                    let _e8562 = (_e8560 - (_e8560 - _e8516));
                                                    let _e8563 = (_e8537 - _e8559);
                                                    let _e8564 = (_e8516 - _e8562);
                                                    phi_10683_ = ((((((_e8543 * _e8546) - _e8538) + (_e8543 * _e8548)) + (_e8547 * _e8546)) + (_e8547 * _e8548)) - (((((_e8559 * _e8562) - _e8539) + (_e8559 * _e8564)) + (_e8563 * _e8562)) + (_e8563 * _e8564)));
                                                }
                                                let _e8576 = phi_10683_;
                                                let _e8577 = (_e8502 * _e8537);
                                                let _e8578 = (_e8509 * _e8530);
                                                if (_e8577 != _e8578) {
                                                    phi_10694_ = (_e8577 - _e8578);
                                                } else {
                                                    let _e8580 = (_e8502 * 4097f);
                                                    let _e8582 = (_e8580 - (_e8580 - _e8502));
                                                    let _e8583 = (_e8537 * 4097f);
                                                    let _e8585 = (_e8583 - (_e8583 - _e8537));
                                                    let _e8586 = (_e8502 - _e8582);
                                                    let _e8587 = (_e8537 - _e8585);
                                                    let _e8596 = (_e8509 * 4097f);
                                                    let _e8598 = (_e8596 - (_e8596 - _e8509));
                                                    let _e8599 = (_e8530 * 4097f);
                                                    let _e8601 = (_e8599 - (_e8599 - _e8530));
                                                    let _e8602 = (_e8509 - _e8598);
                                                    let _e8603 = (_e8530 - _e8601);
                                                    phi_10694_ = ((((((_e8582 * _e8585) - _e8577) + (_e8582 * _e8587)) + (_e8586 * _e8585)) + (_e8586 * _e8587)) - (((((_e8598 * _e8601) - _e8578) + (_e8598 * _e8603)) + (_e8602 * _e8601)) + (_e8602 * _e8603)));
                                                }
                                                let _e8615 = phi_10694_;
                                                let _e8616 = (_e8516 * _e8509);
                                                let _e8617 = (_e8523 * _e8502);
                                                if (_e8616 != _e8617) {
                                                    phi_10705_ = (_e8616 - _e8617);
                                                } else {
                                                    let _e8619 = (_e8516 * 4097f);
                                                    let _e8621 = (_e8619 - (_e8619 - _e8516));
                                                    let _e8622 = (_e8509 * 4097f);
                                                    let _e8624 = (_e8622 - (_e8622 - _e8509));
                                                    let _e8625 = (_e8516 - _e8621);
                                                    let _e8626 = (_e8509 - _e8624);
                                                    let _e8635 = (_e8523 * 4097f);
                                                    let _e8637 = (_e8635 - (_e8635 - _e8523));
                                                    let _e8638 = (_e8502 * 4097f);
                                                    let _e8640 = (_e8638 - (_e8638 - _e8502));
                                                    let _e8641 = (_e8523 - _e8637);
                                                    let _e8642 = (_e8502 - _e8640);
                                                    phi_10705_ = ((((((_e8621 * _e8624) - _e8616) + (_e8621 * _e8626)) + (_e8625 * _e8624)) + (_e8625 * _e8626)) - (((((_e8637 * _e8640) - _e8617) + (_e8637 * _e8642)) + (_e8641 * _e8640)) + (_e8641 * _e8642)));
                                                }
                                                let _e8654 = phi_10705_;
                                                if (_e8576 < 0f) {
                                                    phi_10723_ = f32();
                                                    phi_10724_ = true;
                                                } else {
                                                    if (_e8615 < 0f) {
                                                        phi_10721_ = f32();
                                                        phi_10722_ = true;
                                                    } else {
                                                        let _e8657 = (_e8654 < 0f);
                                                        if _e8657 {
                                                            phi_10720_ = f32();
                                                        } else {
                                                            phi_10720_ = ((_e8576 + _e8615) + _e8654);
                                                        }
                                                        let _e8661 = phi_10720_;
                                                        phi_10721_ = _e8661;
                                                        phi_10722_ = _e8657;
                                                    }
                                                    let _e8663 = phi_10721_;
                                                    let _e8665 = phi_10722_;
                                                    phi_10723_ = _e8663;
                                                    phi_10724_ = _e8665;
                                                }
                                                let _e8667 = phi_10723_;
                                                let _e8669 = phi_10724_;
                                                if _e8669 {
                                                    if (_e8576 > 0f) {
                                                        phi_10745_ = f32();
                                                        phi_10746_ = true;
                                                        phi_10747_ = false;
                                                    } else {
                                                        let _e8671 = (_e8615 > 0f);
                                                        if _e8671 {
                                                            phi_10743_ = f32();
                                                            phi_10744_ = false;
                                                        } else {
                                                            phi_10743_ = ((_e8576 + _e8615) + _e8654);
                                                            phi_10744_ = select(true, false, (_e8654 > 0f));
                                                        }
                                                        let _e8677 = phi_10743_;
                                                        let _e8679 = phi_10744_;
                                                        phi_10745_ = _e8677;
                                                        phi_10746_ = _e8671;
                                                        phi_10747_ = _e8679;
                                                    }
                                                    let _e8681 = phi_10745_;
                                                    let _e8683 = phi_10746_;
                                                    let _e8685 = phi_10747_;
                                                    phi_10752_ = _e8681;
                                                    phi_10753_ = select(_e8685, false, _e8683);
                                                } else {
                                                    phi_10752_ = _e8667;
                                                    phi_10753_ = true;
                                                }
                                                let _e8688 = phi_10752_;
                                                let _e8690 = phi_10753_;
                                                if _e8690 {
                                                    let _e8691 = (_e8688 == 0f);
                                                    if _e8691 {
                                                        phi_10841_ = array<f32, 3>();
                                                        phi_10842_ = array<f32, 3>();
                                                        phi_10843_ = false;
                                                    } else {
                                                        let _e8692 = (_e8485 * _e8369);
                                                        let _e8693 = (_e8490 * _e8369);
                                                        let _e8694 = (_e8495 * _e8369);
                                                        let _e8697 = (1f / ((_e8576 + _e8615) + _e8654));
                                                        let _e8698 = (_e8615 * _e8697);
                                                        let _e8699 = (_e8654 * _e8697);
                                                        let _e8705 = ((((_e8576 * _e8697) * _e8692) + (_e8698 * _e8693)) + (_e8699 * _e8694));
                                                        let _e8706 = abs(_e8502);
                                                        let _e8707 = abs(_e8516);
                                                        let _e8709 = select(_e8707, _e8706, (_e8706 > _e8707));
                                                        let _e8710 = abs(_e8530);
                                                        let _e8713 = abs(_e8509);
                                                        let _e8714 = abs(_e8523);
                                                        let _e8716 = select(_e8714, _e8713, (_e8713 > _e8714));
                                                        let _e8717 = abs(_e8537);
                                                        let _e8721 = abs(_e8692);
                                                        let _e8722 = abs(_e8693);
                                                        let _e8724 = select(_e8722, _e8721, (_e8721 > _e8722));
                                                        let _e8725 = abs(_e8694);
                                                        let _e8732 = (((select(_e8710, _e8709, (_e8709 > _e8710)) * select(_e8717, _e8716, (_e8716 > _e8717))) * select(_e8725, _e8724, (_e8724 > _e8725))) <= (abs((_e8688 * _e8705)) * 256f));
                                                        if _e8732 {
                                                            phi_10839_ = array<f32, 3>(_e8705, _e8698, _e8699);
                                                            phi_10840_ = array<f32, 3>();
                                                        } else {
                                                            let _e8734 = (_e8530 * 4097f);
                                                            let _e8736 = (_e8734 - (_e8734 - _e8530));
                                                            let _e8737 = (_e8523 * 4097f);
                                                            let _e8739 = (_e8737 - (_e8737 - _e8523));
                                                            let _e8740 = (_e8530 - _e8736);
                                                            let _e8741 = (_e8523 - _e8739);
                                                            let _e8750 = (_e8537 * 4097f);
                                                            let _e8752 = (_e8750 - (_e8750 - _e8537));
                                                            let _e8753 = (_e8516 * 4097f);
                                                            let _e8755 = (_e8753 - (_e8753 - _e8516));
                                                            let _e8756 = (_e8537 - _e8752);
                                                            let _e8757 = (_e8516 - _e8755);
                                                            let _e8767 = ((_e8538 - _e8539) + ((((((_e8736 * _e8739) - _e8538) + (_e8736 * _e8741)) + (_e8740 * _e8739)) + (_e8740 * _e8741)) - (((((_e8752 * _e8755) - _e8539) + (_e8752 * _e8757)) + (_e8756 * _e8755)) + (_e8756 * _e8757))));
                                                            let _e8769 = (_e8502 * 4097f);
                                                            let _e8771 = (_e8769 - (_e8769 - _e8502));
                                                            let _e8772 = (_e8502 - _e8771);
                                                            let _e8781 = (_e8509 * 4097f);
                                                            let _e8783 = (_e8781 - (_e8781 - _e8509));
                                                            let _e8784 = (_e8509 - _e8783);
                                                            let _e8794 = ((_e8577 - _e8578) + ((((((_e8771 * _e8752) - _e8577) + (_e8771 * _e8756)) + (_e8772 * _e8752)) + (_e8772 * _e8756)) - (((((_e8783 * _e8736) - _e8578) + (_e8783 * _e8740)) + (_e8784 * _e8736)) + (_e8784 * _e8740))));
                                                            let _e8813 = ((_e8616 - _e8617) + ((((((_e8755 * _e8783) - _e8616) + (_e8755 * _e8784)) + (_e8757 * _e8783)) + (_e8757 * _e8784)) - (((((_e8739 * _e8771) - _e8617) + (_e8739 * _e8772)) + (_e8741 * _e8771)) + (_e8741 * _e8772))));
                                                            let _e8816 = (1f / ((_e8767 + _e8794) + _e8813));
                                                            let _e8817 = (_e8794 * _e8816);
                                                            let _e8818 = (_e8813 * _e8816);
                                                            phi_10839_ = array<f32, 3>();
                                                            phi_10840_ = array<f32, 3>(((((_e8767 * _e8816) * _e8692) + (_e8817 * _e8693)) + (_e8818 * _e8694)), _e8817, _e8818);
                                                        }
                                                        let _e8828 = phi_10839_;
                                                        let _e8830 = phi_10840_;
                                                        phi_10841_ = _e8828;
                                                        phi_10842_ = _e8830;
                                                        phi_10843_ = _e8732;
                                                    }
                                                    let _e8832 = phi_10841_;
                                                    let _e8834 = phi_10842_;
                                                    let _e8836 = phi_10843_;
                                                    phi_10844_ = _e8832;
                                                    phi_10845_ = _e8834;
                                                    phi_10846_ = _e8691;
                                                    phi_10847_ = _e8836;
                                                } else {
                                                    phi_10844_ = array<f32, 3>();
                                                    phi_10845_ = array<f32, 3>();
                                                    phi_10846_ = true;
                                                    phi_10847_ = false;
                                                }
                                                let _e8838 = phi_10844_;
                                                let _e8840 = phi_10845_;
                                                let _e8842 = phi_10846_;
                                                let _e8844 = phi_10847_;
                                                if _e8842 {
                                                    phi_10852_ = array<f32, 3>(-1f, 0f, 0f);
                                                } else {
                                                    phi_10852_ = _e8838;
                                                }
                                                let _e8846 = phi_10852_;
                                                if select(_e8844, true, _e8842) {
                                                    phi_10857_ = _e8846;
                                                } else {
                                                    phi_10857_ = _e8840;
                                                }
                                                let _e8849 = phi_10857_;
                                                let _e8853 = (_e8849[0] >= 0f);
                                                if _e8853 {
                                                    let _e8854 = (_e8849[0] < 340282350000000000000000000000000000000f);
                                                    if _e8854 {
                                                        if _e8853 {
                                                            if _e8480 {
                                                            } else {
                                                                phi_17267_ = true;
                                                                phi_12429_ = bool();
                                                                break;
                                                            }
                                                            let _e8857 = triangles.member[_e8475.member_1].member_3;
                                                            if ((_e8857 & 1u) == 0u) {
                                                                phi_11189_ = true;
                                                            } else {
                                                                if _e8480 {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8862 = triangles.member[_e8475.member_1].member_1;
                                                                let _e8863 = (_e8862 * 12u);
                                                                if ((256u + _e8863) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                if ((_e8863 + 257u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                if ((_e8863 + 258u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8870 = (_e8863 + 259u);
                                                                if (_e8870 < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8873 = surfaces.member[_e8870];
                                                                if ((_e8863 + 260u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                if ((_e8863 + 261u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                if ((_e8863 + 262u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8880 = (_e8863 + 263u);
                                                                if (_e8880 < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8883 = surfaces.member[_e8880];
                                                                let _e8884 = (_e8863 + 264u);
                                                                if (_e8884 < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8887 = surfaces.member[_e8884];
                                                                let _e8888 = bitcast<f32>(_e8887);
                                                                let _e8889 = (_e8863 + 265u);
                                                                if (_e8889 < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                let _e8892 = surfaces.member[_e8889];
                                                                let _e8893 = bitcast<f32>(_e8892);
                                                                if ((_e8863 + 266u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                if ((_e8863 + 267u) < _e144) {
                                                                } else {
                                                                    phi_17267_ = true;
                                                                    phi_12429_ = bool();
                                                                    break;
                                                                }
                                                                if (_e8873 == 4294967295u) {
                                                                    phi_11184_ = (_e8888 < _e8893);
                                                                } else {
                                                                    if (_e8475.member_1 < _e141) {
                                                                    } else {
                                                                        phi_17267_ = true;
                                                                        phi_12429_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e8901 = ((1f - _e8849[1]) - _e8849[2]);
                                                                    let _e8905 = attributes.member[_e8475.member_1].member[0u];
                                                                    let _e8910 = attributes.member[_e8475.member_1].member[2u];
                                                                    let _e8916 = attributes.member[_e8475.member_1].member[4u];
                                                                    let _e8918 = (((_e8905 * _e8901) + (_e8910 * _e8849[1])) + (_e8916 * _e8849[2]));
                                                                    let _e8922 = attributes.member[_e8475.member_1].member[1u];
                                                                    let _e8927 = attributes.member[_e8475.member_1].member[3u];
                                                                    let _e8933 = attributes.member[_e8475.member_1].member[5u];
                                                                    let _e8935 = (((_e8922 * _e8901) + (_e8927 * _e8849[1])) + (_e8933 * _e8849[2]));
                                                                    let _e8936 = (_e8883 & 65535u);
                                                                    let _e8938 = (_e8883 >> bitcast<u32>(16i));
                                                                    let _e8940 = (_e8918 - floor(_e8918));
                                                                    let _e8945 = ((select(0f, _e8940, (_e8940 <= 1f)) * f32(_e8936)) - 0.5f);
                                                                    let _e8946 = floor(_e8945);
                                                                    let _e8947 = (_e8945 - _e8946);
                                                                    let _e8948 = (_e8936 - 1u);
                                                                    if (_e8946 < 0f) {
                                                                        phi_11067_ = _e8948;
                                                                    } else {
                                                                        let _e8954 = select(select(u32(_e8946), 0u, (_e8946 < 0f)), 4294967295u, (_e8946 > 4294967000f));
                                                                        phi_11067_ = select(_e8954, _e8948, (_e8948 < _e8954));
                                                                    }
                                                                    let _e8958 = phi_11067_;
                                                                    if (_e8958 == _e8948) {
                                                                        phi_11073_ = 0u;
                                                                    } else {
                                                                        phi_11073_ = (_e8958 + 1u);
                                                                    }
                                                                    let _e8962 = phi_11073_;
                                                                    let _e8964 = (_e8935 - floor(_e8935));
                                                                    let _e8969 = ((select(0f, _e8964, (_e8964 <= 1f)) * f32(_e8938)) - 0.5f);
                                                                    let _e8970 = floor(_e8969);
                                                                    let _e8971 = (_e8969 - _e8970);
                                                                    let _e8972 = (_e8938 - 1u);
                                                                    if (_e8970 < 0f) {
                                                                        phi_11103_ = _e8972;
                                                                    } else {
                                                                        let _e8978 = select(select(u32(_e8970), 0u, (_e8970 < 0f)), 4294967295u, (_e8970 > 4294967000f));
                                                                        phi_11103_ = select(_e8978, _e8972, (_e8972 < _e8978));
                                                                    }
                                                                    let _e8982 = phi_11103_;
                                                                    if (_e8982 == _e8972) {
                                                                        phi_11109_ = 0u;
                                                                    } else {
                                                                        phi_11109_ = (_e8982 + 1u);
                                                                    }
                                                                    let _e8986 = phi_11109_;
                                                                    let _e8988 = (_e8873 + (_e8982 * _e8936));
                                                                    let _e8990 = (_e8873 + (_e8986 * _e8936));
                                                                    let _e8991 = (_e8988 + _e8958);
                                                                    let _e8992 = (_e8988 + _e8962);
                                                                    let _e8993 = (_e8990 + _e8958);
                                                                    let _e8994 = (_e8990 + _e8962);
                                                                    if (_e8991 < _e144) {
                                                                    } else {
                                                                        phi_17267_ = true;
                                                                        phi_12429_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e8997 = surfaces.member[_e8991];
                                                                    if (_e8992 < _e144) {
                                                                    } else {
                                                                        phi_17267_ = true;
                                                                        phi_12429_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e9000 = surfaces.member[_e8992];
                                                                    if (_e8993 < _e144) {
                                                                    } else {
                                                                        phi_17267_ = true;
                                                                        phi_12429_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e9003 = surfaces.member[_e8993];
                                                                    if (_e8994 < _e144) {
                                                                    } else {
                                                                        phi_17267_ = true;
                                                                        phi_12429_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e9006 = surfaces.member[_e8994];
                                                                    let _e9023 = (1f - _e8947);
                                                                    phi_11184_ = ((_e8888 * (((((f32((_e8997 >> bitcast<u32>(24i))) * 0.003921569f) * _e9023) + ((f32((_e9000 >> bitcast<u32>(24i))) * 0.003921569f) * _e8947)) * (1f - _e8971)) + ((((f32((_e9003 >> bitcast<u32>(24i))) * 0.003921569f) * _e9023) + ((f32((_e9006 >> bitcast<u32>(24i))) * 0.003921569f) * _e8947)) * _e8971))) < _e8893);
                                                                }
                                                                let _e9038 = phi_11184_;
                                                                phi_11189_ = select(true, false, _e9038);
                                                            }
                                                            let _e9041 = phi_11189_;
                                                            if _e9041 {
                                                                phi_11194_ = type_44(_e8849[0], _e8475.member_1, _e8849[1], _e8849[2]);
                                                            } else {
                                                                phi_11194_ = type_44();
                                                            }
                                                            let _e9044 = phi_11194_;
                                                            phi_11196_ = _e9044;
                                                            phi_11198_ = select(true, false, _e9041);
                                                        } else {
                                                            phi_11196_ = type_44();
                                                            phi_11198_ = false;
                                                        }
                                                        let _e9047 = phi_11196_;
                                                        let _e9049 = phi_11198_;
                                                        phi_11199_ = _e9047;
                                                        phi_11201_ = select(true, false, _e8853);
                                                        phi_11202_ = _e9049;
                                                    } else {
                                                        phi_11199_ = type_44();
                                                        phi_11201_ = false;
                                                        phi_11202_ = false;
                                                    }
                                                    let _e9052 = phi_11199_;
                                                    let _e9054 = phi_11201_;
                                                    let _e9056 = phi_11202_;
                                                    phi_11203_ = _e9052;
                                                    phi_11204_ = select(true, false, _e8854);
                                                    phi_11205_ = _e9054;
                                                    phi_11206_ = _e9056;
                                                } else {
                                                    phi_11203_ = type_44();
                                                    phi_11204_ = true;
                                                    phi_11205_ = false;
                                                    phi_11206_ = false;
                                                }
                                                let _e9059 = phi_11203_;
                                                let _e9061 = phi_11204_;
                                                let _e9063 = phi_11205_;
                                                let _e9065 = phi_11206_;
                                                if select(select(_e9065, false, _e9061), true, select(_e9063, true, _e9061)) {
                                                    phi_11219_ = type_44(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                } else {
                                                    phi_11219_ = _e9059;
                                                }
                                                let _e9070 = phi_11219_;
                                                phi_11226_ = select(true, false, (_e9070.member_1 != 4294967295u));
                                            } else {
                                                phi_11226_ = false;
                                            }
                                            let _e9075 = phi_11226_;
                                            continue;
                                            continuing {
                                                phi_10543_ = _e8473;
                                                phi_17267_ = _e8448;
                                                phi_12429_ = select(true, false, _e8479);
                                                break if !(_e9075);
                                            }
                                        }
                                        let _e9079 = phi_17267_;
                                        let _e9081 = phi_12429_;
                                        phi_17342_ = _e9079;
                                        phi_12430_ = bool();
                                        if _e9079 {
                                            break;
                                        }
                                        phi_17344_ = _e9079;
                                        phi_11231_ = _e8452;
                                        phi_11232_ = _e9081;
                                    }
                                    let _e9318 = phi_17344_;
                                    let _e9320 = phi_11231_;
                                    let _e9322 = phi_11232_;
                                    if _e9322 {
                                        let _e9323 = (_e9320 == 0u);
                                        if _e9323 {
                                            phi_11248_ = u32();
                                            phi_11249_ = u32();
                                        } else {
                                            let _e9324 = (_e9320 - 1u);
                                            if (_e9324 < 64u) {
                                            } else {
                                                phi_17342_ = true;
                                                phi_12430_ = bool();
                                                break;
                                            }
                                            let _e9327 = local[_e9324];
                                            phi_11248_ = _e9327;
                                            phi_11249_ = _e9324;
                                        }
                                        let _e9329 = phi_11248_;
                                        let _e9331 = phi_11249_;
                                        phi_10116_ = _e9329;
                                        phi_10119_ = _e9331;
                                        phi_11251_ = select(true, false, _e9323);
                                        phi_11252_ = _e9323;
                                    } else {
                                        phi_10116_ = u32();
                                        phi_10119_ = u32();
                                        phi_11251_ = false;
                                        phi_11252_ = false;
                                    }
                                    let _e9334 = phi_10116_;
                                    let _e9336 = phi_10119_;
                                    let _e9338 = phi_11251_;
                                    let _e9340 = phi_11252_;
                                    continue;
                                    continuing {
                                        phi_17271_ = _e9318;
                                        phi_10115_ = _e9334;
                                        phi_10118_ = _e9336;
                                        phi_17342_ = _e9318;
                                        phi_12430_ = _e9340;
                                        break if !(_e9338);
                                    }
                                }
                                let _e9343 = phi_17342_;
                                let _e9345 = phi_12430_;
                                phi_17402_ = _e9343;
                                if _e9343 {
                                    break;
                                }
                                if select(false, true, select(true, false, _e9345)) {
                                    phi_11265_ = _e8103;
                                } else {
                                    phi_11265_ = (_e8103 + 1i);
                                }
                                let _e9350 = phi_11265_;
                                phi_17403_ = _e9343;
                                phi_9651_ = _e9350;
                            } else {
                                phi_17403_ = _e8099;
                                phi_9651_ = i32();
                            }
                            let _e9352 = phi_17403_;
                            let _e9354 = phi_9651_;
                            continue;
                            continuing {
                                phi_17290_ = _e9352;
                                phi_9647_ = _e8116;
                                phi_9650_ = _e9354;
                                phi_17402_ = _e9352;
                                break if !(_e8122);
                            }
                        }
                        let _e9357 = phi_17402_;
                        if _e9357 {
                            break;
                        }
                        let _e9359 = local_30;
                        let _e9362 = f32(_e8065);
                        let _e9365 = ((3.1415927f * f32(_e9359)) / select(1f, _e9362, (_e9362 > 1f)));
                        let _e9368 = params.member.member;
                        phi_11292_ = vec3<f32>((_e8062.x + (_e9368.x * _e9365)), (_e8062.y + (_e9368.y * _e9365)), (_e8062.z + (_e9368.z * _e9365)));
                    } else {
                        phi_11292_ = _e8062;
                    }
                    let _e9383 = phi_11292_;
                    phi_11297_ = vec4<f32>(_e9383.x, _e9383.y, _e9383.z, 0f);
                }
                let _e9389 = phi_11297_;
                if (_e157 < arrayLength((&irradiance.member))) {
                } else {
                    break;
                }
                irradiance.member[_e157] = _e9389;
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_direct(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
