struct type_9 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: array<u32>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
    member_6: array<f32, 3>,
    member_7: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_27 {
    member: array<vec4<f32>>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
    member_2: vec4<f32>,
    member_3: vec4<f32>,
    member_4: vec4<f32>,
    member_5: vec4<f32>,
    member_6: array<u32, 4>,
    member_7: vec4<f32>,
}

struct type_35 {
    member: array<type_33>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 3>,
    member_5: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_43 {
    member: array<f32, 6>,
    member_1: array<u32, 3>,
    member_2: array<u32, 3>,
}

struct type_45 {
    member: array<type_43>,
}

struct type_47 {
    member: f32,
    member_1: u32,
    member_2: f32,
    member_3: f32,
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

struct type_61 {
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

struct type_62 {
    member: type_61,
}

var<private> gid_1: vec3<u32>;
@group(0) @binding(7) 
var<storage, read_write> out: type_27;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(3) 
var<storage> attributes: type_45;
@group(0) @binding(4) 
var<storage> surfaces: type_12;
@group(0) @binding(5) 
var<storage> lights: type_56;
@group(0) @binding(0) 
var<uniform> params: type_62;
@group(0) @binding(6) 
var<storage> facets: type_24;

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
    var phi_1367_: vec3<f32>;
    var phi_1374_: vec3<f32>;
    var phi_16401_: bool;
    var phi_6095_: type_9;
    var phi_6098_: vec3<f32>;
    var phi_6096_: type_9;
    var phi_6121_: type_9;
    var phi_6135_: u32;
    var phi_6138_: u32;
    var phi_6162_: u32;
    var phi_6136_: u32;
    var phi_6139_: u32;
    var phi_16397_: bool;
    var local_21: u32;
    var local_22: u32;
    var phi_9360_: f32;
    var phi_9381_: f32;
    var phi_9410_: bool;
    var phi_9420_: u32;
    var phi_9423_: bool;
    var phi_9434_: u32;
    var phi_9564_: f32;
    var phi_9572_: f32;
    var phi_9580_: f32;
    var phi_16412_: bool;
    var phi_9583_: u32;
    var phi_9586_: u32;
    var phi_10011_: type_9;
    var phi_10012_: type_9;
    var phi_10035_: type_9;
    var phi_10151_: f32;
    var phi_10162_: f32;
    var phi_10173_: f32;
    var phi_10188_: f32;
    var phi_10189_: f32;
    var phi_10190_: bool;
    var phi_10191_: f32;
    var phi_10192_: bool;
    var phi_10211_: f32;
    var phi_10212_: bool;
    var phi_10213_: f32;
    var phi_10214_: bool;
    var phi_10215_: bool;
    var phi_10220_: f32;
    var phi_10221_: bool;
    var phi_10307_: array<f32, 3>;
    var phi_10308_: array<f32, 3>;
    var phi_10309_: array<f32, 3>;
    var phi_10310_: array<f32, 3>;
    var phi_10311_: bool;
    var phi_10312_: array<f32, 3>;
    var phi_10313_: array<f32, 3>;
    var phi_10314_: bool;
    var phi_10315_: bool;
    var phi_10320_: array<f32, 3>;
    var phi_10325_: array<f32, 3>;
    var phi_10535_: u32;
    var phi_10541_: u32;
    var phi_10571_: u32;
    var phi_10577_: u32;
    var phi_10652_: bool;
    var phi_10657_: bool;
    var phi_10662_: type_47;
    var phi_10664_: type_47;
    var phi_10666_: bool;
    var phi_10667_: type_47;
    var phi_10669_: bool;
    var phi_10670_: bool;
    var phi_10671_: type_47;
    var phi_10672_: bool;
    var phi_10673_: bool;
    var phi_10674_: bool;
    var phi_10687_: type_47;
    var phi_10694_: bool;
    var phi_16408_: bool;
    var phi_12542_: bool;
    var phi_9971_: u32;
    var phi_9983_: u32;
    var phi_9995_: u32;
    var phi_10007_: u32;
    var phi_16476_: bool;
    var phi_10699_: u32;
    var phi_10700_: bool;
    var phi_10716_: u32;
    var phi_10717_: u32;
    var phi_9584_: u32;
    var phi_9587_: u32;
    var phi_10719_: bool;
    var phi_10720_: bool;
    var phi_16474_: bool;
    var phi_12543_: bool;
    var phi_10737_: vec3<f32>;
    var phi_16801_: bool;
    var phi_10739_: vec3<f32>;
    var phi_10740_: bool;
    var phi_7929_: f32;
    var phi_7958_: bool;
    var phi_7968_: u32;
    var phi_7971_: bool;
    var phi_7982_: u32;
    var phi_8112_: f32;
    var phi_8120_: f32;
    var phi_8128_: f32;
    var phi_16538_: bool;
    var phi_8131_: u32;
    var phi_8134_: u32;
    var phi_8559_: type_9;
    var phi_8560_: type_9;
    var phi_8583_: type_9;
    var phi_8699_: f32;
    var phi_8710_: f32;
    var phi_8721_: f32;
    var phi_8736_: f32;
    var phi_8737_: f32;
    var phi_8738_: bool;
    var phi_8739_: f32;
    var phi_8740_: bool;
    var phi_8759_: f32;
    var phi_8760_: bool;
    var phi_8761_: f32;
    var phi_8762_: bool;
    var phi_8763_: bool;
    var phi_8768_: f32;
    var phi_8769_: bool;
    var phi_8855_: array<f32, 3>;
    var phi_8856_: array<f32, 3>;
    var phi_8857_: array<f32, 3>;
    var phi_8858_: array<f32, 3>;
    var phi_8859_: bool;
    var phi_8860_: array<f32, 3>;
    var phi_8861_: array<f32, 3>;
    var phi_8862_: bool;
    var phi_8863_: bool;
    var phi_8868_: array<f32, 3>;
    var phi_8873_: array<f32, 3>;
    var phi_9083_: u32;
    var phi_9089_: u32;
    var phi_9119_: u32;
    var phi_9125_: u32;
    var phi_9200_: bool;
    var phi_9205_: bool;
    var phi_9210_: type_47;
    var phi_9212_: type_47;
    var phi_9214_: bool;
    var phi_9215_: type_47;
    var phi_9217_: bool;
    var phi_9218_: bool;
    var phi_9219_: type_47;
    var phi_9220_: bool;
    var phi_9221_: bool;
    var phi_9222_: bool;
    var phi_9235_: type_47;
    var phi_9242_: bool;
    var phi_16534_: bool;
    var phi_12544_: bool;
    var phi_8519_: u32;
    var phi_8531_: u32;
    var phi_8543_: u32;
    var phi_8555_: u32;
    var phi_16596_: bool;
    var phi_9247_: u32;
    var phi_9248_: bool;
    var phi_9264_: u32;
    var phi_9265_: u32;
    var phi_8132_: u32;
    var phi_8135_: u32;
    var phi_9267_: bool;
    var phi_9268_: bool;
    var phi_16594_: bool;
    var phi_12545_: bool;
    var phi_9284_: vec3<f32>;
    var phi_16806_: bool;
    var phi_9285_: vec3<f32>;
    var phi_9286_: bool;
    var phi_16799_: bool;
    var phi_10745_: vec3<f32>;
    var phi_10746_: vec3<f32>;
    var phi_6269_: vec3<f32>;
    var phi_6271_: vec3<f32>;
    var phi_6272_: bool;
    var phi_16680_: bool;
    var phi_6294_: type_9;
    var phi_6299_: f32;
    var phi_6295_: type_9;
    var phi_6324_: type_9;
    var phi_13049_: f32;
    var phi_13057_: f32;
    var phi_6385_: vec2<f32>;
    var phi_6488_: f32;
    var phi_6517_: bool;
    var phi_6527_: u32;
    var phi_6530_: bool;
    var phi_6541_: u32;
    var phi_6671_: f32;
    var phi_6679_: f32;
    var phi_6687_: f32;
    var phi_16658_: bool;
    var phi_6690_: u32;
    var phi_6693_: u32;
    var phi_7118_: type_9;
    var phi_7119_: type_9;
    var phi_7142_: type_9;
    var phi_7258_: f32;
    var phi_7269_: f32;
    var phi_7280_: f32;
    var phi_7295_: f32;
    var phi_7296_: f32;
    var phi_7297_: bool;
    var phi_7298_: f32;
    var phi_7299_: bool;
    var phi_7318_: f32;
    var phi_7319_: bool;
    var phi_7320_: f32;
    var phi_7321_: bool;
    var phi_7322_: bool;
    var phi_7327_: f32;
    var phi_7328_: bool;
    var phi_7414_: array<f32, 3>;
    var phi_7415_: array<f32, 3>;
    var phi_7416_: array<f32, 3>;
    var phi_7417_: array<f32, 3>;
    var phi_7418_: bool;
    var phi_7419_: array<f32, 3>;
    var phi_7420_: array<f32, 3>;
    var phi_7421_: bool;
    var phi_7422_: bool;
    var phi_7427_: array<f32, 3>;
    var phi_7432_: array<f32, 3>;
    var phi_7642_: u32;
    var phi_7648_: u32;
    var phi_7678_: u32;
    var phi_7684_: u32;
    var phi_7759_: bool;
    var phi_7764_: bool;
    var phi_7769_: type_47;
    var phi_7771_: type_47;
    var phi_7773_: bool;
    var phi_7774_: type_47;
    var phi_7776_: bool;
    var phi_7777_: bool;
    var phi_7778_: type_47;
    var phi_7779_: bool;
    var phi_7780_: bool;
    var phi_7781_: bool;
    var phi_7794_: type_47;
    var phi_7801_: bool;
    var phi_16654_: bool;
    var phi_12546_: bool;
    var phi_7078_: u32;
    var phi_7090_: u32;
    var phi_7102_: u32;
    var phi_7114_: u32;
    var phi_16730_: bool;
    var phi_7806_: u32;
    var phi_7807_: bool;
    var phi_7823_: u32;
    var phi_7824_: u32;
    var phi_6691_: u32;
    var phi_6694_: u32;
    var phi_7826_: bool;
    var phi_7827_: bool;
    var phi_16728_: bool;
    var phi_12547_: bool;
    var phi_7841_: f32;
    var phi_16790_: bool;
    var phi_7842_: f32;
    var phi_16789_: bool;
    var phi_6300_: f32;
    var phi_16788_: bool;
    var local_23: f32;
    var local_24: f32;
    var phi_7871_: f32;
    var phi_16811_: bool;
    var phi_7877_: f32;
    var phi_16798_: bool;
    var phi_10747_: vec3<f32>;
    var phi_10748_: vec3<f32>;
    var phi_10749_: bool;
    var phi_16796_: bool;
    var phi_10769_: vec3<f32>;
    var phi_16795_: bool;
    var phi_6099_: vec3<f32>;
    var phi_16794_: bool;
    var phi_16923_: bool;
    var phi_1446_: type_9;
    var phi_1449_: vec3<f32>;
    var phi_1447_: type_9;
    var phi_1472_: type_9;
    var phi_4676_: f32;
    var phi_4697_: f32;
    var phi_4726_: bool;
    var phi_4736_: u32;
    var phi_4739_: bool;
    var phi_4750_: u32;
    var phi_4880_: f32;
    var phi_4888_: f32;
    var phi_4896_: f32;
    var phi_16906_: bool;
    var phi_4899_: u32;
    var phi_4902_: u32;
    var phi_5327_: type_9;
    var phi_5328_: type_9;
    var phi_5351_: type_9;
    var phi_5467_: f32;
    var phi_5478_: f32;
    var phi_5489_: f32;
    var phi_5504_: f32;
    var phi_5505_: f32;
    var phi_5506_: bool;
    var phi_5507_: f32;
    var phi_5508_: bool;
    var phi_5527_: f32;
    var phi_5528_: bool;
    var phi_5529_: f32;
    var phi_5530_: bool;
    var phi_5531_: bool;
    var phi_5536_: f32;
    var phi_5537_: bool;
    var phi_5623_: array<f32, 3>;
    var phi_5624_: array<f32, 3>;
    var phi_5625_: array<f32, 3>;
    var phi_5626_: array<f32, 3>;
    var phi_5627_: bool;
    var phi_5628_: array<f32, 3>;
    var phi_5629_: array<f32, 3>;
    var phi_5630_: bool;
    var phi_5631_: bool;
    var phi_5636_: array<f32, 3>;
    var phi_5641_: array<f32, 3>;
    var phi_5851_: u32;
    var phi_5857_: u32;
    var phi_5887_: u32;
    var phi_5893_: u32;
    var phi_5968_: bool;
    var phi_5973_: bool;
    var phi_5978_: type_47;
    var phi_5980_: type_47;
    var phi_5982_: bool;
    var phi_5983_: type_47;
    var phi_5985_: bool;
    var phi_5986_: bool;
    var phi_5987_: type_47;
    var phi_5988_: bool;
    var phi_5989_: bool;
    var phi_5990_: bool;
    var phi_6003_: type_47;
    var phi_6010_: bool;
    var phi_16902_: bool;
    var phi_12548_: bool;
    var phi_5287_: u32;
    var phi_5299_: u32;
    var phi_5311_: u32;
    var phi_5323_: u32;
    var phi_16972_: bool;
    var phi_6015_: u32;
    var phi_6016_: bool;
    var phi_6032_: u32;
    var phi_6033_: u32;
    var phi_4900_: u32;
    var phi_4903_: u32;
    var phi_6035_: bool;
    var phi_6036_: bool;
    var phi_16970_: bool;
    var phi_12549_: bool;
    var phi_6053_: vec3<f32>;
    var phi_17296_: bool;
    var phi_6055_: vec3<f32>;
    var phi_6056_: bool;
    var phi_3245_: f32;
    var phi_3274_: bool;
    var phi_3284_: u32;
    var phi_3287_: bool;
    var phi_3298_: u32;
    var phi_3428_: f32;
    var phi_3436_: f32;
    var phi_3444_: f32;
    var phi_17034_: bool;
    var phi_3447_: u32;
    var phi_3450_: u32;
    var phi_3875_: type_9;
    var phi_3876_: type_9;
    var phi_3899_: type_9;
    var phi_4015_: f32;
    var phi_4026_: f32;
    var phi_4037_: f32;
    var phi_4052_: f32;
    var phi_4053_: f32;
    var phi_4054_: bool;
    var phi_4055_: f32;
    var phi_4056_: bool;
    var phi_4075_: f32;
    var phi_4076_: bool;
    var phi_4077_: f32;
    var phi_4078_: bool;
    var phi_4079_: bool;
    var phi_4084_: f32;
    var phi_4085_: bool;
    var phi_4171_: array<f32, 3>;
    var phi_4172_: array<f32, 3>;
    var phi_4173_: array<f32, 3>;
    var phi_4174_: array<f32, 3>;
    var phi_4175_: bool;
    var phi_4176_: array<f32, 3>;
    var phi_4177_: array<f32, 3>;
    var phi_4178_: bool;
    var phi_4179_: bool;
    var phi_4184_: array<f32, 3>;
    var phi_4189_: array<f32, 3>;
    var phi_4399_: u32;
    var phi_4405_: u32;
    var phi_4435_: u32;
    var phi_4441_: u32;
    var phi_4516_: bool;
    var phi_4521_: bool;
    var phi_4526_: type_47;
    var phi_4528_: type_47;
    var phi_4530_: bool;
    var phi_4531_: type_47;
    var phi_4533_: bool;
    var phi_4534_: bool;
    var phi_4535_: type_47;
    var phi_4536_: bool;
    var phi_4537_: bool;
    var phi_4538_: bool;
    var phi_4551_: type_47;
    var phi_4558_: bool;
    var phi_17030_: bool;
    var phi_12550_: bool;
    var phi_3835_: u32;
    var phi_3847_: u32;
    var phi_3859_: u32;
    var phi_3871_: u32;
    var phi_17092_: bool;
    var phi_4563_: u32;
    var phi_4564_: bool;
    var phi_4580_: u32;
    var phi_4581_: u32;
    var phi_3448_: u32;
    var phi_3451_: u32;
    var phi_4583_: bool;
    var phi_4584_: bool;
    var phi_17090_: bool;
    var phi_12551_: bool;
    var phi_4600_: vec3<f32>;
    var phi_17301_: bool;
    var phi_4601_: vec3<f32>;
    var phi_4602_: bool;
    var phi_17294_: bool;
    var phi_6061_: vec3<f32>;
    var phi_6062_: vec3<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1587_: vec3<f32>;
    var phi_1588_: bool;
    var phi_17176_: bool;
    var phi_1610_: type_9;
    var phi_1613_: f32;
    var phi_1615_: f32;
    var phi_1617_: f32;
    var phi_1611_: type_9;
    var phi_1640_: type_9;
    var phi_14840_: f32;
    var phi_14848_: f32;
    var phi_1701_: vec2<f32>;
    var phi_1804_: f32;
    var phi_1833_: bool;
    var phi_1843_: u32;
    var phi_1846_: bool;
    var phi_1857_: u32;
    var phi_1987_: f32;
    var phi_1995_: f32;
    var phi_2003_: f32;
    var phi_17154_: bool;
    var phi_2006_: u32;
    var phi_2009_: u32;
    var phi_2434_: type_9;
    var phi_2435_: type_9;
    var phi_2458_: type_9;
    var phi_2574_: f32;
    var phi_2585_: f32;
    var phi_2596_: f32;
    var phi_2611_: f32;
    var phi_2612_: f32;
    var phi_2613_: bool;
    var phi_2614_: f32;
    var phi_2615_: bool;
    var phi_2634_: f32;
    var phi_2635_: bool;
    var phi_2636_: f32;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2643_: f32;
    var phi_2644_: bool;
    var phi_2730_: array<f32, 3>;
    var phi_2731_: array<f32, 3>;
    var phi_2732_: array<f32, 3>;
    var phi_2733_: array<f32, 3>;
    var phi_2734_: bool;
    var phi_2735_: array<f32, 3>;
    var phi_2736_: array<f32, 3>;
    var phi_2737_: bool;
    var phi_2738_: bool;
    var phi_2743_: array<f32, 3>;
    var phi_2748_: array<f32, 3>;
    var phi_2958_: u32;
    var phi_2964_: u32;
    var phi_2994_: u32;
    var phi_3000_: u32;
    var phi_3075_: bool;
    var phi_3080_: bool;
    var phi_3085_: type_47;
    var phi_3087_: type_47;
    var phi_3089_: bool;
    var phi_3090_: type_47;
    var phi_3092_: bool;
    var phi_3093_: bool;
    var phi_3094_: type_47;
    var phi_3095_: bool;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3110_: type_47;
    var phi_3117_: bool;
    var phi_17150_: bool;
    var phi_12552_: bool;
    var phi_2394_: u32;
    var phi_2406_: u32;
    var phi_2418_: u32;
    var phi_2430_: u32;
    var phi_17226_: bool;
    var phi_3122_: u32;
    var phi_3123_: bool;
    var phi_3139_: u32;
    var phi_3140_: u32;
    var phi_2007_: u32;
    var phi_2010_: u32;
    var phi_3142_: bool;
    var phi_3143_: bool;
    var phi_17224_: bool;
    var phi_12553_: bool;
    var phi_3157_: f32;
    var phi_17286_: bool;
    var phi_3158_: f32;
    var phi_17285_: bool;
    var phi_1614_: f32;
    var phi_1616_: f32;
    var phi_1618_: f32;
    var phi_17284_: bool;
    var local_25: f32;
    var local_26: f32;
    var phi_15158_: bool;
    var phi_15169_: bool;
    var phi_15190_: type_60;
    var phi_15194_: type_60;
    var phi_15195_: vec3<f32>;
    var phi_15196_: vec3<f32>;
    var phi_15236_: vec3<f32>;
    var phi_15239_: vec3<f32>;
    var phi_15240_: bool;
    var phi_15284_: vec3<f32>;
    var phi_15287_: vec3<f32>;
    var phi_15288_: bool;
    var phi_15355_: f32;
    var phi_15363_: f32;
    var phi_15378_: f32;
    var phi_15384_: f32;
    var phi_15392_: f32;
    var phi_15402_: f32;
    var phi_15407_: type_60;
    var phi_15417_: bool;
    var phi_15428_: bool;
    var phi_15449_: type_60;
    var phi_15453_: type_60;
    var phi_15454_: vec3<f32>;
    var phi_15455_: vec3<f32>;
    var phi_15495_: vec3<f32>;
    var phi_15498_: vec3<f32>;
    var phi_15499_: bool;
    var phi_15543_: vec3<f32>;
    var phi_15546_: vec3<f32>;
    var phi_15547_: bool;
    var phi_15614_: f32;
    var phi_15622_: f32;
    var phi_15637_: f32;
    var phi_15643_: f32;
    var phi_15651_: f32;
    var phi_15661_: f32;
    var phi_15666_: type_60;
    var phi_15676_: bool;
    var phi_15708_: type_60;
    var phi_15712_: type_60;
    var phi_15713_: vec3<f32>;
    var phi_15714_: vec3<f32>;
    var phi_15754_: vec3<f32>;
    var phi_15757_: vec3<f32>;
    var phi_15758_: bool;
    var phi_15802_: vec3<f32>;
    var phi_15805_: vec3<f32>;
    var phi_15806_: bool;
    var phi_15873_: f32;
    var phi_15881_: f32;
    var phi_15896_: f32;
    var phi_15902_: f32;
    var phi_15910_: f32;
    var phi_15920_: f32;
    var phi_15925_: type_60;
    var phi_15967_: vec3<f32>;
    var phi_15970_: vec3<f32>;
    var phi_15971_: bool;
    var phi_16015_: vec3<f32>;
    var phi_16018_: vec3<f32>;
    var phi_16019_: bool;
    var phi_16086_: f32;
    var phi_16094_: f32;
    var phi_16109_: f32;
    var phi_16115_: f32;
    var phi_16123_: f32;
    var phi_16133_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_3176_: f32;
    var phi_3177_: f32;
    var phi_3178_: bool;
    var local_29: f32;
    var phi_3186_: f32;
    var phi_3187_: f32;
    var phi_3188_: f32;
    var phi_3189_: bool;
    var phi_17306_: bool;
    var phi_3193_: f32;
    var phi_3194_: f32;
    var phi_3195_: bool;
    var phi_17293_: bool;
    var phi_6063_: vec3<f32>;
    var phi_6064_: vec3<f32>;
    var phi_6065_: bool;
    var phi_17291_: bool;
    var phi_1450_: vec3<f32>;
    var phi_17290_: bool;
    var phi_17421_: bool;
    var phi_10770_: vec3<f32>;
    var phi_17420_: bool;
    var phi_10827_: type_9;
    var phi_10830_: i32;
    var phi_10828_: type_9;
    var phi_10853_: type_9;
    var phi_16145_: f32;
    var phi_16153_: f32;
    var phi_10917_: vec2<f32>;
    var phi_10918_: bool;
    var phi_11048_: f32;
    var phi_11056_: f32;
    var phi_10982_: f32;
    var phi_10990_: f32;
    var phi_11060_: vec2<f32>;
    var phi_11061_: vec2<f32>;
    var phi_11105_: f32;
    var phi_11131_: bool;
    var phi_11141_: u32;
    var phi_11144_: bool;
    var phi_11155_: u32;
    var phi_11285_: f32;
    var phi_11293_: f32;
    var phi_11301_: f32;
    var phi_17401_: bool;
    var phi_11304_: u32;
    var phi_11307_: u32;
    var phi_11732_: type_9;
    var phi_11733_: type_9;
    var phi_11756_: type_9;
    var phi_11872_: f32;
    var phi_11883_: f32;
    var phi_11894_: f32;
    var phi_11909_: f32;
    var phi_11910_: f32;
    var phi_11911_: bool;
    var phi_11912_: f32;
    var phi_11913_: bool;
    var phi_11932_: f32;
    var phi_11933_: bool;
    var phi_11934_: f32;
    var phi_11935_: bool;
    var phi_11936_: bool;
    var phi_11941_: f32;
    var phi_11942_: bool;
    var phi_12028_: array<f32, 3>;
    var phi_12029_: array<f32, 3>;
    var phi_12030_: array<f32, 3>;
    var phi_12031_: array<f32, 3>;
    var phi_12032_: bool;
    var phi_12033_: array<f32, 3>;
    var phi_12034_: array<f32, 3>;
    var phi_12035_: bool;
    var phi_12036_: bool;
    var phi_12041_: array<f32, 3>;
    var phi_12046_: array<f32, 3>;
    var phi_12256_: u32;
    var phi_12262_: u32;
    var phi_12292_: u32;
    var phi_12298_: u32;
    var phi_12373_: bool;
    var phi_12378_: bool;
    var phi_12383_: type_47;
    var phi_12385_: type_47;
    var phi_12387_: bool;
    var phi_12388_: type_47;
    var phi_12390_: bool;
    var phi_12391_: bool;
    var phi_12392_: type_47;
    var phi_12393_: bool;
    var phi_12394_: bool;
    var phi_12395_: bool;
    var phi_12408_: type_47;
    var phi_12415_: bool;
    var phi_17397_: bool;
    var phi_12554_: bool;
    var phi_11692_: u32;
    var phi_11704_: u32;
    var phi_11716_: u32;
    var phi_11728_: u32;
    var phi_17474_: bool;
    var phi_12420_: u32;
    var phi_12421_: bool;
    var phi_12437_: u32;
    var phi_12438_: u32;
    var phi_11305_: u32;
    var phi_11308_: u32;
    var phi_12440_: bool;
    var phi_12441_: bool;
    var phi_17472_: bool;
    var phi_12555_: bool;
    var phi_12454_: i32;
    var phi_17533_: bool;
    var phi_10831_: i32;
    var phi_17532_: bool;
    var local_30: i32;
    var phi_12476_: vec3<f32>;
    var local_31: vec3<f32>;
    var local_32: vec3<f32>;

    switch bitcast<i32>(0u) {
        default: {
            let _e135 = gid_1;
            let _e138 = arrayLength((&nodes.member));
            let _e141 = arrayLength((&triangles.member));
            let _e144 = arrayLength((&attributes.member));
            let _e147 = arrayLength((&surfaces.member));
            let _e149 = arrayLength((&lights.member));
            let _e157 = (_e135.x + (_e135.y * 2097152u));
            let _e158 = (_e157 < arrayLength((&out.member)));
            if _e158 {
                let _e159 = (_e157 / 2u);
                if (_e159 < arrayLength((&facets.member))) {
                } else {
                    break;
                }
                let _e163 = facets.member[_e159];
                let _e173 = sqrt((((_e163.member_2[0] * _e163.member_2[0]) + (_e163.member_2[1] * _e163.member_2[1])) + (_e163.member_2[2] * _e163.member_2[2])));
                if (_e173 > 0.000000000001f) {
                    phi_1367_ = vec3<f32>((_e163.member_2[0] / _e173), (_e163.member_2[1] / _e173), (_e163.member_2[2] / _e173));
                } else {
                    phi_1367_ = vec3<f32>(0f, 1f, 0f);
                }
                let _e180 = phi_1367_;
                if ((_e157 & 1u) == 0u) {
                    phi_1374_ = _e180;
                } else {
                    phi_1374_ = -(_e180);
                }
                let _e185 = phi_1374_;
                let _e190 = vec3<f32>(_e163.member[0], _e163.member[1], _e163.member[2]);
                let _e195 = (1f - (_e173 / select(0.000000000001f, _e163.member_1, (_e163.member_1 > 0.000000000001f))));
                let _e197 = select(0f, _e195, (_e195 > 0f));
                let _e206 = params.member.member[3u];
                let _e207 = ((0.001f + (0.61f * sqrt(select(0.5f, _e197, (_e197 < 0.5f))))) * _e206);
                let _e211 = params.member.member_17[0u];
                let _e215 = params.member.member_17[1u];
                let _e219 = params.member.member_17[3u];
                let _e223 = ((_e157 ^ (_e157 >> bitcast<u32>(16i))) * 2146121005u);
                let _e227 = ((_e223 ^ (_e223 >> bitcast<u32>(15i))) * 2221713035u);
                let _e231 = (_e219 ^ (_e227 ^ (_e227 >> bitcast<u32>(16i))));
                let _e235 = ((_e231 ^ (_e231 >> bitcast<u32>(16i))) * 2146121005u);
                let _e239 = ((_e235 ^ (_e235 >> bitcast<u32>(15i))) * 2221713035u);
                let _e242 = (_e239 ^ (_e239 >> bitcast<u32>(16i)));
                if (_e211 <= 64u) {
                    phi_16923_ = false;
                    phi_1446_ = type_9(0u, _e211);
                    phi_1449_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e3796 = phi_16923_;
                        let _e3798 = phi_1446_;
                        let _e3800 = phi_1449_;
                        local_31 = _e3800;
                        if (_e3798.member < _e3798.member_1) {
                            phi_1447_ = type_9((_e3798.member + 1u), _e3798.member_1);
                            phi_1472_ = type_9(1u, _e3798.member);
                        } else {
                            phi_1447_ = _e3798;
                            phi_1472_ = type_9(0u, type_9().member_1);
                        }
                        let _e3813 = phi_1447_;
                        let _e3815 = phi_1472_;
                        let _e3819 = (bitcast<i32>(_e3815.member) != 0i);
                        if _e3819 {
                            if (_e3815.member_1 < _e149) {
                            } else {
                                phi_17290_ = true;
                                break;
                            }
                            let _e3823 = lights.member[_e3815.member_1];
                            let _e3827 = ((_e3815.member_1 ^ (_e3815.member_1 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e3831 = ((_e3827 ^ (_e3827 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e3835 = (_e242 ^ (_e3831 ^ (_e3831 >> bitcast<u32>(16i))));
                            let _e3839 = ((_e3835 ^ (_e3835 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e3843 = ((_e3839 ^ (_e3839 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e3846 = (_e3843 ^ (_e3843 >> bitcast<u32>(16i)));
                            if (_e3823.member_1 == 3u) {
                                let _e6012 = (_e3823.member_2[0] - _e3823.member[0]);
                                let _e6013 = (_e3823.member_2[1] - _e3823.member[1]);
                                let _e6014 = (_e3823.member_2[2] - _e3823.member[2]);
                                let _e6015 = (_e3823.member_4[0] - _e3823.member[0]);
                                let _e6016 = (_e3823.member_4[1] - _e3823.member[1]);
                                let _e6017 = (_e3823.member_4[2] - _e3823.member[2]);
                                let _e6020 = ((_e6013 * _e6017) - (_e6016 * _e6014));
                                let _e6023 = ((_e6014 * _e6015) - (_e6017 * _e6012));
                                let _e6026 = ((_e6012 * _e6016) - (_e6015 * _e6013));
                                let _e6027 = abs(_e6020);
                                let _e6028 = abs(_e6023);
                                let _e6030 = select(_e6028, _e6027, (_e6027 > _e6028));
                                let _e6031 = abs(_e6026);
                                let _e6033 = select(_e6031, _e6030, (_e6030 > _e6031));
                                if (_e6033 > 0.000000000000000000000000000000000000011754944f) {
                                    let _e6035 = (_e6033 < 340282350000000000000000000000000000000f);
                                    if _e6035 {
                                        let _e6036 = (_e6020 / _e6033);
                                        let _e6037 = (_e6023 / _e6033);
                                        let _e6038 = (_e6026 / _e6033);
                                        let _e6044 = sqrt((((_e6036 * _e6036) + (_e6037 * _e6037)) + (_e6038 * _e6038)));
                                        phi_1585_ = vec3<f32>((_e6036 / _e6044), (_e6037 / _e6044), (_e6038 / _e6044));
                                    } else {
                                        phi_1585_ = vec3<f32>();
                                    }
                                    let _e6050 = phi_1585_;
                                    phi_1587_ = _e6050;
                                    phi_1588_ = select(true, false, _e6035);
                                } else {
                                    phi_1587_ = vec3<f32>();
                                    phi_1588_ = true;
                                }
                                let _e6053 = phi_1587_;
                                let _e6055 = phi_1588_;
                                let _e6057 = select(_e6053, vec3<f32>(0f, 0f, 0f), vec3(_e6055));
                                let _e6068 = (((_e6057.x * (_e163.member[0] - _e3823.member[0])) + (_e6057.y * (_e163.member[1] - _e3823.member[1]))) + (_e6057.z * (_e163.member[2] - _e3823.member[2])));
                                if (_e6068 <= 0f) {
                                    phi_17306_ = _e3796;
                                    phi_3193_ = 0f;
                                    phi_3194_ = f32();
                                    phi_3195_ = true;
                                } else {
                                    phi_17176_ = _e3796;
                                    phi_1610_ = type_9(0u, _e215);
                                    phi_1613_ = 340282350000000000000000000000000000000f;
                                    phi_1615_ = 0f;
                                    phi_1617_ = 0f;
                                    loop {
                                        let _e6072 = phi_17176_;
                                        let _e6074 = phi_1610_;
                                        let _e6076 = phi_1613_;
                                        let _e6078 = phi_1615_;
                                        let _e6080 = phi_1617_;
                                        local_25 = _e6078;
                                        local_26 = _e6076;
                                        local_27 = _e6078;
                                        local_28 = _e6080;
                                        local_29 = _e6078;
                                        if (_e6074.member < _e6074.member_1) {
                                            phi_1611_ = type_9((_e6074.member + 1u), _e6074.member_1);
                                            phi_1640_ = type_9(1u, _e6074.member);
                                        } else {
                                            phi_1611_ = _e6074;
                                            phi_1640_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e6093 = phi_1611_;
                                        let _e6095 = phi_1640_;
                                        let _e6099 = (bitcast<i32>(_e6095.member) != 0i);
                                        if _e6099 {
                                            let _e6103 = ((_e3846 ^ (_e3846 >> bitcast<u32>(16i))) * 2146121005u);
                                            let _e6107 = ((_e6103 ^ (_e6103 >> bitcast<u32>(15i))) * 2221713035u);
                                            let _e6114 = (_e3846 ^ 2654435769u);
                                            let _e6118 = ((_e6114 ^ (_e6114 >> bitcast<u32>(16i))) * 2146121005u);
                                            let _e6122 = ((_e6118 ^ (_e6118 >> bitcast<u32>(15i))) * 2221713035u);
                                            let _e6140 = (0.000000059604645f * (f32(((2147483648u + (_e6095.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e6107 ^ (_e6107 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e6140 >= 1f) {
                                                phi_14840_ = (_e6140 - 1f);
                                            } else {
                                                phi_14840_ = _e6140;
                                            }
                                            let _e6144 = phi_14840_;
                                            let _e6146 = (0.000000059604645f * (f32(((2147483648u + (_e6095.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e6122 ^ (_e6122 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e6146 >= 1f) {
                                                phi_14848_ = (_e6146 - 1f);
                                            } else {
                                                phi_14848_ = _e6146;
                                            }
                                            let _e6150 = phi_14848_;
                                            if (_e6144 < _e6150) {
                                                let _e6155 = (0.5f * _e6144);
                                                phi_1701_ = vec2<f32>(_e6155, (_e6150 - _e6155));
                                            } else {
                                                let _e6152 = (0.5f * _e6150);
                                                phi_1701_ = vec2<f32>((_e6144 - _e6152), _e6152);
                                            }
                                            let _e6159 = phi_1701_;
                                            let _e6171 = ((_e3823.member[0] + (_e6012 * _e6159.x)) + (_e6015 * _e6159.y));
                                            let _e6172 = ((_e3823.member[1] + (_e6013 * _e6159.x)) + (_e6016 * _e6159.y));
                                            let _e6173 = ((_e3823.member[2] + (_e6014 * _e6159.x)) + (_e6017 * _e6159.y));
                                            let _e6174 = (_e6171 - _e163.member[0]);
                                            let _e6175 = (_e6172 - _e163.member[1]);
                                            let _e6176 = (_e6173 - _e163.member[2]);
                                            let _e6181 = (((_e6174 * _e6174) + (_e6175 * _e6175)) + (_e6176 * _e6176));
                                            let _e6191 = (((_e185.x * _e6174) + (_e185.y * _e6175)) + (_e185.z * _e6176));
                                            let _e6195 = (_e6181 * _e6181);
                                            let _e6198 = ((select(0f, _e6191, (_e6191 > 0f)) * _e6068) / select(0.000000000000000000000000000000000000011754944f, _e6195, (_e6195 > 0.000000000000000000000000000000000000011754944f)));
                                            if (_e6198 > 0f) {
                                                let _e6201 = abs(_e6171);
                                                let _e6202 = abs(_e6172);
                                                let _e6204 = select(_e6202, _e6201, (_e6201 > _e6202));
                                                let _e6205 = abs(_e6173);
                                                let _e6211 = ((select(_e6205, _e6204, (_e6204 > _e6205)) + sqrt(_e3823.member_3)) * 0.0000009536743f);
                                                let _e6215 = (_e6171 + (_e6057.x * _e6211));
                                                let _e6216 = (_e6172 + (_e6057.y * _e6211));
                                                let _e6217 = (_e6173 + (_e6057.z * _e6211));
                                                if ((((_e185.x * (_e6215 - _e163.member[0])) + (_e185.y * (_e6216 - _e163.member[1]))) + (_e185.z * (_e6217 - _e163.member[2]))) < 0f) {
                                                    phi_1804_ = -(_e207);
                                                } else {
                                                    phi_1804_ = _e207;
                                                }
                                                let _e6229 = phi_1804_;
                                                let _e6233 = (_e163.member[0] + (_e185.x * _e6229));
                                                let _e6234 = (_e163.member[1] + (_e185.y * _e6229));
                                                let _e6235 = (_e163.member[2] + (_e185.z * _e6229));
                                                let _e6236 = (_e6215 - _e6233);
                                                let _e6237 = (_e6216 - _e6234);
                                                let _e6238 = (_e6217 - _e6235);
                                                let _e6239 = abs(_e6236);
                                                let _e6240 = abs(_e6237);
                                                let _e6241 = abs(_e6238);
                                                let _e6242 = (_e6239 > _e6240);
                                                if _e6242 {
                                                    phi_1833_ = (_e6239 > _e6241);
                                                } else {
                                                    phi_1833_ = (_e6240 > _e6241);
                                                }
                                                let _e6246 = phi_1833_;
                                                let _e6247 = select(1u, 0u, _e6242);
                                                if _e6246 {
                                                    let _e6248 = (_e6247 + 1u);
                                                    phi_1843_ = _e6248;
                                                    phi_1846_ = select(true, false, (_e6248 == 2u));
                                                } else {
                                                    phi_1843_ = u32();
                                                    phi_1846_ = false;
                                                }
                                                let _e6252 = phi_1843_;
                                                let _e6254 = phi_1846_;
                                                let _e6255 = select(true, false, _e6246);
                                                let _e6256 = select(_e6252, 0u, _e6255);
                                                let _e6258 = select(_e6254, true, _e6255);
                                                if _e6258 {
                                                    phi_1857_ = (_e6256 + 1u);
                                                } else {
                                                    phi_1857_ = 0u;
                                                }
                                                let _e6261 = phi_1857_;
                                                let _e6262 = select(_e6252, _e6256, _e6258);
                                                let _e6263 = select(_e6247, select(_e6247, 2u, _e6255), _e6258);
                                                local_19 = array<f32, 3>(_e6236, _e6237, _e6238);
                                                local_20 = array<f32, 3>(_e6233, _e6234, _e6235);
                                                let _e6266 = (_e6263 < 3u);
                                                if _e6266 {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6268 = local_19[_e6263];
                                                let _e6269 = (1f / _e6268);
                                                let _e6270 = (_e6262 < 3u);
                                                if _e6270 {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6272 = local_19[_e6262];
                                                let _e6273 = (_e6272 * _e6269);
                                                let _e6274 = (_e6261 < 3u);
                                                if _e6274 {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6276 = local_19[_e6261];
                                                let _e6277 = (_e6276 * _e6269);
                                                if _e6270 {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6279 = local_20[_e6262];
                                                if _e6274 {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6281 = local_20[_e6261];
                                                if _e6266 {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6283 = local_20[_e6263];
                                                if (0u < _e138) {
                                                } else {
                                                    phi_17284_ = true;
                                                    break;
                                                }
                                                let _e6288 = nodes.member[0u].member_7[0u];
                                                let _e6292 = nodes.member[0u].member_7[1u];
                                                let _e6296 = nodes.member[0u].member_7[2u];
                                                let _e6300 = nodes.member[0u].member_7[3u];
                                                let _e6302 = abs((_e6233 - _e6288));
                                                let _e6304 = abs((_e6234 - _e6292));
                                                let _e6306 = select(_e6304, _e6302, (_e6302 > _e6304));
                                                let _e6308 = abs((_e6235 - _e6296));
                                                let _e6312 = ((select(_e6308, _e6306, (_e6306 > _e6308)) + _e6300) * 0.0000009536743f);
                                                let _e6319 = (_e6312 + (abs(_e6233) * 0.00000023841858f));
                                                let _e6320 = (_e6312 + (abs(_e6234) * 0.00000023841858f));
                                                let _e6321 = (_e6312 + (abs(_e6235) * 0.00000023841858f));
                                                let _e6322 = select(_e6240, _e6239, _e6242);
                                                let _e6324 = select(_e6241, _e6322, (_e6322 > _e6241));
                                                let _e6325 = (_e6324 * 0.000000000001f);
                                                let _e6326 = (_e6233 + _e6319);
                                                let _e6327 = (_e6234 + _e6320);
                                                let _e6328 = (_e6235 + _e6321);
                                                let _e6329 = (_e6233 - _e6319);
                                                let _e6330 = (_e6234 - _e6320);
                                                let _e6331 = (_e6235 - _e6321);
                                                if (_e6239 > _e6325) {
                                                    phi_1987_ = (1f / _e6236);
                                                } else {
                                                    phi_1987_ = (1000000000000f / _e6324);
                                                }
                                                let _e6336 = phi_1987_;
                                                if (_e6240 > _e6325) {
                                                    phi_1995_ = (1f / _e6237);
                                                } else {
                                                    phi_1995_ = (1000000000000f / _e6324);
                                                }
                                                let _e6341 = phi_1995_;
                                                if (_e6241 > _e6325) {
                                                    phi_2003_ = (1f / _e6238);
                                                } else {
                                                    phi_2003_ = (1000000000000f / _e6324);
                                                }
                                                let _e6346 = phi_2003_;
                                                local_18 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                phi_17154_ = _e6072;
                                                phi_2006_ = 0u;
                                                phi_2009_ = 0u;
                                                loop {
                                                    let _e6348 = phi_17154_;
                                                    let _e6350 = phi_2006_;
                                                    let _e6352 = phi_2009_;
                                                    let _e6353 = (_e6350 & 15u);
                                                    let _e6355 = (_e6350 >> bitcast<u32>(4u));
                                                    if (_e6353 == 0u) {
                                                        if (_e6355 < _e138) {
                                                        } else {
                                                            phi_17224_ = true;
                                                            phi_12553_ = bool();
                                                            break;
                                                        }
                                                        let _e6985 = nodes.member[_e6355].member;
                                                        let _e6994 = ((_e6985.x - _e6326) * _e6336);
                                                        let _e6995 = ((_e6985.y - _e6326) * _e6336);
                                                        let _e6996 = ((_e6985.z - _e6326) * _e6336);
                                                        let _e6997 = ((_e6985.w - _e6326) * _e6336);
                                                        let _e7000 = nodes.member[_e6355].member_3;
                                                        let _e7009 = ((_e7000.x - _e6329) * _e6336);
                                                        let _e7010 = ((_e7000.y - _e6329) * _e6336);
                                                        let _e7011 = ((_e7000.z - _e6329) * _e6336);
                                                        let _e7012 = ((_e7000.w - _e6329) * _e6336);
                                                        let _e7015 = nodes.member[_e6355].member_1;
                                                        let _e7024 = ((_e7015.x - _e6327) * _e6341);
                                                        let _e7025 = ((_e7015.y - _e6327) * _e6341);
                                                        let _e7026 = ((_e7015.z - _e6327) * _e6341);
                                                        let _e7027 = ((_e7015.w - _e6327) * _e6341);
                                                        let _e7030 = nodes.member[_e6355].member_4;
                                                        let _e7039 = ((_e7030.x - _e6330) * _e6341);
                                                        let _e7040 = ((_e7030.y - _e6330) * _e6341);
                                                        let _e7041 = ((_e7030.z - _e6330) * _e6341);
                                                        let _e7042 = ((_e7030.w - _e6330) * _e6341);
                                                        let _e7045 = nodes.member[_e6355].member_2;
                                                        let _e7054 = ((_e7045.x - _e6328) * _e6346);
                                                        let _e7055 = ((_e7045.y - _e6328) * _e6346);
                                                        let _e7056 = ((_e7045.z - _e6328) * _e6346);
                                                        let _e7057 = ((_e7045.w - _e6328) * _e6346);
                                                        let _e7060 = nodes.member[_e6355].member_5;
                                                        let _e7069 = ((_e7060.x - _e6331) * _e6346);
                                                        let _e7070 = ((_e7060.y - _e6331) * _e6346);
                                                        let _e7071 = ((_e7060.z - _e6331) * _e6346);
                                                        let _e7072 = ((_e7060.w - _e6331) * _e6346);
                                                        let _e7074 = select(_e7009, _e6994, (_e6994 < _e7009));
                                                        let _e7076 = select(_e7010, _e6995, (_e6995 < _e7010));
                                                        let _e7078 = select(_e7011, _e6996, (_e6996 < _e7011));
                                                        let _e7080 = select(_e7012, _e6997, (_e6997 < _e7012));
                                                        let _e7082 = select(_e7039, _e7024, (_e7024 < _e7039));
                                                        let _e7084 = select(_e7040, _e7025, (_e7025 < _e7040));
                                                        let _e7086 = select(_e7041, _e7026, (_e7026 < _e7041));
                                                        let _e7088 = select(_e7042, _e7027, (_e7027 < _e7042));
                                                        let _e7090 = select(_e7082, _e7074, (_e7074 > _e7082));
                                                        let _e7092 = select(_e7084, _e7076, (_e7076 > _e7084));
                                                        let _e7094 = select(_e7086, _e7078, (_e7078 > _e7086));
                                                        let _e7096 = select(_e7088, _e7080, (_e7080 > _e7088));
                                                        let _e7098 = select(_e7069, _e7054, (_e7054 < _e7069));
                                                        let _e7100 = select(_e7070, _e7055, (_e7055 < _e7070));
                                                        let _e7102 = select(_e7071, _e7056, (_e7056 < _e7071));
                                                        let _e7104 = select(_e7072, _e7057, (_e7057 < _e7072));
                                                        let _e7106 = select(_e7098, _e7090, (_e7090 > _e7098));
                                                        let _e7108 = select(_e7100, _e7092, (_e7092 > _e7100));
                                                        let _e7110 = select(_e7102, _e7094, (_e7094 > _e7102));
                                                        let _e7112 = select(_e7104, _e7096, (_e7096 > _e7104));
                                                        let _e7114 = select(0f, _e7106, (_e7106 > 0f));
                                                        let _e7116 = select(0f, _e7108, (_e7108 > 0f));
                                                        let _e7118 = select(0f, _e7110, (_e7110 > 0f));
                                                        let _e7120 = select(0f, _e7112, (_e7112 > 0f));
                                                        let _e7122 = select(_e7009, _e6994, (_e6994 > _e7009));
                                                        let _e7124 = select(_e7010, _e6995, (_e6995 > _e7010));
                                                        let _e7126 = select(_e7011, _e6996, (_e6996 > _e7011));
                                                        let _e7128 = select(_e7012, _e6997, (_e6997 > _e7012));
                                                        let _e7130 = select(_e7039, _e7024, (_e7024 > _e7039));
                                                        let _e7132 = select(_e7040, _e7025, (_e7025 > _e7040));
                                                        let _e7134 = select(_e7041, _e7026, (_e7026 > _e7041));
                                                        let _e7136 = select(_e7042, _e7027, (_e7027 > _e7042));
                                                        let _e7138 = select(_e7130, _e7122, (_e7122 < _e7130));
                                                        let _e7140 = select(_e7132, _e7124, (_e7124 < _e7132));
                                                        let _e7142 = select(_e7134, _e7126, (_e7126 < _e7134));
                                                        let _e7144 = select(_e7136, _e7128, (_e7128 < _e7136));
                                                        let _e7146 = select(_e7069, _e7054, (_e7054 > _e7069));
                                                        let _e7148 = select(_e7070, _e7055, (_e7055 > _e7070));
                                                        let _e7150 = select(_e7071, _e7056, (_e7056 > _e7071));
                                                        let _e7152 = select(_e7072, _e7057, (_e7057 > _e7072));
                                                        let _e7154 = select(_e7146, _e7138, (_e7138 < _e7146));
                                                        let _e7156 = select(_e7148, _e7140, (_e7140 < _e7148));
                                                        let _e7158 = select(_e7150, _e7142, (_e7142 < _e7150));
                                                        let _e7160 = select(_e7152, _e7144, (_e7144 < _e7152));
                                                        let _e7180 = nodes.member[_e6355].member_6[0u];
                                                        let _e7184 = nodes.member[_e6355].member_6[1u];
                                                        let _e7188 = nodes.member[_e6355].member_6[2u];
                                                        let _e7192 = nodes.member[_e6355].member_6[3u];
                                                        if (select(340282350000000000000000000000000000000f, _e7120, (_e7120 <= select(0.9999995f, _e7160, (_e7160 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e6352 < 64u) {
                                                            } else {
                                                                phi_17224_ = true;
                                                                phi_12553_ = bool();
                                                                break;
                                                            }
                                                            local_18[_e6352] = _e7192;
                                                            phi_2394_ = (_e6352 + 1u);
                                                        } else {
                                                            phi_2394_ = _e6352;
                                                        }
                                                        let _e7198 = phi_2394_;
                                                        if (select(340282350000000000000000000000000000000f, _e7118, (_e7118 <= select(0.9999995f, _e7158, (_e7158 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e7198 < 64u) {
                                                            } else {
                                                                phi_17224_ = true;
                                                                phi_12553_ = bool();
                                                                break;
                                                            }
                                                            local_18[_e7198] = _e7188;
                                                            phi_2406_ = (_e7198 + 1u);
                                                        } else {
                                                            phi_2406_ = _e7198;
                                                        }
                                                        let _e7204 = phi_2406_;
                                                        if (select(340282350000000000000000000000000000000f, _e7116, (_e7116 <= select(0.9999995f, _e7156, (_e7156 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e7204 < 64u) {
                                                            } else {
                                                                phi_17224_ = true;
                                                                phi_12553_ = bool();
                                                                break;
                                                            }
                                                            local_18[_e7204] = _e7184;
                                                            phi_2418_ = (_e7204 + 1u);
                                                        } else {
                                                            phi_2418_ = _e7204;
                                                        }
                                                        let _e7210 = phi_2418_;
                                                        if (select(340282350000000000000000000000000000000f, _e7114, (_e7114 <= select(0.9999995f, _e7154, (_e7154 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                            if (_e7210 < 64u) {
                                                            } else {
                                                                phi_17224_ = true;
                                                                phi_12553_ = bool();
                                                                break;
                                                            }
                                                            local_18[_e7210] = _e7180;
                                                            phi_2430_ = (_e7210 + 1u);
                                                        } else {
                                                            phi_2430_ = _e7210;
                                                        }
                                                        let _e7216 = phi_2430_;
                                                        phi_17226_ = _e6348;
                                                        phi_3122_ = _e7216;
                                                        phi_3123_ = true;
                                                    } else {
                                                        phi_2434_ = type_9(_e6355, (_e6355 + _e6353));
                                                        loop {
                                                            let _e6360 = phi_2434_;
                                                            if (_e6360.member < _e6360.member_1) {
                                                                phi_2435_ = type_9((_e6360.member + 1u), _e6360.member_1);
                                                                phi_2458_ = type_9(1u, _e6360.member);
                                                            } else {
                                                                phi_2435_ = _e6360;
                                                                phi_2458_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e6373 = phi_2435_;
                                                            let _e6375 = phi_2458_;
                                                            let _e6379 = (bitcast<i32>(_e6375.member) != 0i);
                                                            if _e6379 {
                                                                let _e6380 = (_e6375.member_1 < _e141);
                                                                if _e6380 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                if _e6266 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6384 = triangles.member[_e6375.member_1].member[_e6263];
                                                                let _e6385 = (_e6384 - _e6283);
                                                                if _e6266 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6389 = triangles.member[_e6375.member_1].member_2[_e6263];
                                                                let _e6390 = (_e6389 - _e6283);
                                                                if _e6266 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6394 = triangles.member[_e6375.member_1].member_4[_e6263];
                                                                let _e6395 = (_e6394 - _e6283);
                                                                if _e6270 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6399 = triangles.member[_e6375.member_1].member[_e6262];
                                                                let _e6402 = ((_e6399 - _e6279) - (_e6273 * _e6385));
                                                                if _e6274 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6406 = triangles.member[_e6375.member_1].member[_e6261];
                                                                let _e6409 = ((_e6406 - _e6281) - (_e6277 * _e6385));
                                                                if _e6270 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6413 = triangles.member[_e6375.member_1].member_2[_e6262];
                                                                let _e6416 = ((_e6413 - _e6279) - (_e6273 * _e6390));
                                                                if _e6274 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6420 = triangles.member[_e6375.member_1].member_2[_e6261];
                                                                let _e6423 = ((_e6420 - _e6281) - (_e6277 * _e6390));
                                                                if _e6270 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6427 = triangles.member[_e6375.member_1].member_4[_e6262];
                                                                let _e6430 = ((_e6427 - _e6279) - (_e6273 * _e6395));
                                                                if _e6274 {
                                                                } else {
                                                                    phi_17150_ = true;
                                                                    phi_12552_ = bool();
                                                                    break;
                                                                }
                                                                let _e6434 = triangles.member[_e6375.member_1].member_4[_e6261];
                                                                let _e6437 = ((_e6434 - _e6281) - (_e6277 * _e6395));
                                                                let _e6438 = (_e6430 * _e6423);
                                                                let _e6439 = (_e6437 * _e6416);
                                                                if (_e6438 != _e6439) {
                                                                    phi_2574_ = (_e6438 - _e6439);
                                                                } else {
                                                                    let _e6441 = (_e6430 * 4097f);
                                                                    let _e6443 = (_e6441 - (_e6441 - _e6430));
                                                                    let _e6444 = (_e6423 * 4097f);
                                                                    let _e6446 = (_e6444 - (_e6444 - _e6423));
                                                                    let _e6447 = (_e6430 - _e6443);
                                                                    let _e6448 = (_e6423 - _e6446);
                                                                    let _e6457 = (_e6437 * 4097f);
                                                                    let _e6459 = (_e6457 - (_e6457 - _e6437));
                                                                    let _e6460 = (_e6416 * 4097f);
                                                                    let _e6462 = (_e6460 - (_e6460 - _e6416));
                                                                    let _e6463 = (_e6437 - _e6459);
                                                                    let _e6464 = (_e6416 - _e6462);
                                                                    phi_2574_ = ((((((_e6443 * _e6446) - _e6438) + (_e6443 * _e6448)) + (_e6447 * _e6446)) + (_e6447 * _e6448)) - (((((_e6459 * _e6462) - _e6439) + (_e6459 * _e6464)) + (_e6463 * _e6462)) + (_e6463 * _e6464)));
                                                                }
                                                                let _e6476 = phi_2574_;
                                                                let _e6477 = (_e6402 * _e6437);
                                                                let _e6478 = (_e6409 * _e6430);
                                                                if (_e6477 != _e6478) {
                                                                    phi_2585_ = (_e6477 - _e6478);
                                                                } else {
                                                                    let _e6480 = (_e6402 * 4097f);
                                                                    let _e6482 = (_e6480 - (_e6480 - _e6402));
                                                                    let _e6483 = (_e6437 * 4097f);
                                                                    let _e6485 = (_e6483 - (_e6483 - _e6437));
                                                                    let _e6486 = (_e6402 - _e6482);
                                                                    let _e6487 = (_e6437 - _e6485);
                                                                    let _e6496 = (_e6409 * 4097f);
                                                                    let _e6498 = (_e6496 - (_e6496 - _e6409));
                                                                    let _e6499 = (_e6430 * 4097f);
                                                                    let _e6501 = (_e6499 - (_e6499 - _e6430));
                                                                    let _e6502 = (_e6409 - _e6498);
                                                                    let _e6503 = (_e6430 - _e6501);
                                                                    phi_2585_ = ((((((_e6482 * _e6485) - _e6477) + (_e6482 * _e6487)) + (_e6486 * _e6485)) + (_e6486 * _e6487)) - (((((_e6498 * _e6501) - _e6478) + (_e6498 * _e6503)) + (_e6502 * _e6501)) + (_e6502 * _e6503)));
                                                                }
                                                                let _e6515 = phi_2585_;
                                                                let _e6516 = (_e6416 * _e6409);
                                                                let _e6517 = (_e6423 * _e6402);
                                                                if (_e6516 != _e6517) {
                                                                    phi_2596_ = (_e6516 - _e6517);
                                                                } else {
                                                                    let _e6519 = (_e6416 * 4097f);
                                                                    let _e6521 = (_e6519 - (_e6519 - _e6416));
                                                                    let _e6522 = (_e6409 * 4097f);
                                                                    let _e6524 = (_e6522 - (_e6522 - _e6409));
                                                                    let _e6525 = (_e6416 - _e6521);
                                                                    let _e6526 = (_e6409 - _e6524);
                                                                    let _e6535 = (_e6423 * 4097f);
                                                                    let _e6537 = (_e6535 - (_e6535 - _e6423));
                                                                    let _e6538 = (_e6402 * 4097f);
                                                                    let _e6540 = (_e6538 - (_e6538 - _e6402));
                                                                    let _e6541 = (_e6423 - _e6537);
                                                                    let _e6542 = (_e6402 - _e6540);
                                                                    phi_2596_ = ((((((_e6521 * _e6524) - _e6516) + (_e6521 * _e6526)) + (_e6525 * _e6524)) + (_e6525 * _e6526)) - (((((_e6537 * _e6540) - _e6517) + (_e6537 * _e6542)) + (_e6541 * _e6540)) + (_e6541 * _e6542)));
                                                                }
                                                                let _e6554 = phi_2596_;
                                                                if (_e6476 < 0f) {
                                                                    phi_2614_ = f32();
                                                                    phi_2615_ = true;
                                                                } else {
                                                                    if (_e6515 < 0f) {
                                                                        phi_2612_ = f32();
                                                                        phi_2613_ = true;
                                                                    } else {
                                                                        let _e6557 = (_e6554 < 0f);
                                                                        if _e6557 {
                                                                            phi_2611_ = f32();
                                                                        } else {
                                                                            phi_2611_ = ((_e6476 + _e6515) + _e6554);
                                                                        }
                                                                        let _e6561 = phi_2611_;
                                                                        phi_2612_ = _e6561;
                                                                        phi_2613_ = _e6557;
                                                                    }
                                                                    let _e6563 = phi_2612_;
                                                                    let _e6565 = phi_2613_;
                                                                    phi_2614_ = _e6563;
                                                                    phi_2615_ = _e6565;
                                                                }
                                                                let _e6567 = phi_2614_;
                                                                let _e6569 = phi_2615_;
                                                                if _e6569 {
                                                                    if (_e6476 > 0f) {
                                                                        phi_2636_ = f32();
                                                                        phi_2637_ = true;
                                                                        phi_2638_ = false;
                                                                    } else {
                                                                        let _e6571 = (_e6515 > 0f);
                                                                        if _e6571 {
                                                                            phi_2634_ = f32();
                                                                            phi_2635_ = false;
                                                                        } else {
                                                                            phi_2634_ = ((_e6476 + _e6515) + _e6554);
                                                                            phi_2635_ = select(true, false, (_e6554 > 0f));
                                                                        }
                                                                        let _e6577 = phi_2634_;
                                                                        let _e6579 = phi_2635_;
                                                                        phi_2636_ = _e6577;
                                                                        phi_2637_ = _e6571;
                                                                        phi_2638_ = _e6579;
                                                                    }
                                                                    let _e6581 = phi_2636_;
                                                                    let _e6583 = phi_2637_;
                                                                    let _e6585 = phi_2638_;
                                                                    phi_2643_ = _e6581;
                                                                    phi_2644_ = select(_e6585, false, _e6583);
                                                                } else {
                                                                    phi_2643_ = _e6567;
                                                                    phi_2644_ = true;
                                                                }
                                                                let _e6588 = phi_2643_;
                                                                let _e6590 = phi_2644_;
                                                                if _e6590 {
                                                                    let _e6591 = (_e6588 == 0f);
                                                                    if _e6591 {
                                                                        phi_2732_ = array<f32, 3>();
                                                                        phi_2733_ = array<f32, 3>();
                                                                        phi_2734_ = false;
                                                                    } else {
                                                                        let _e6592 = (_e6385 * _e6269);
                                                                        let _e6593 = (_e6390 * _e6269);
                                                                        let _e6594 = (_e6395 * _e6269);
                                                                        let _e6597 = (1f / ((_e6476 + _e6515) + _e6554));
                                                                        let _e6598 = (_e6515 * _e6597);
                                                                        let _e6599 = (_e6554 * _e6597);
                                                                        let _e6605 = ((((_e6476 * _e6597) * _e6592) + (_e6598 * _e6593)) + (_e6599 * _e6594));
                                                                        let _e6606 = abs(_e6402);
                                                                        let _e6607 = abs(_e6416);
                                                                        let _e6609 = select(_e6607, _e6606, (_e6606 > _e6607));
                                                                        let _e6610 = abs(_e6430);
                                                                        let _e6613 = abs(_e6409);
                                                                        let _e6614 = abs(_e6423);
                                                                        let _e6616 = select(_e6614, _e6613, (_e6613 > _e6614));
                                                                        let _e6617 = abs(_e6437);
                                                                        let _e6621 = abs(_e6592);
                                                                        let _e6622 = abs(_e6593);
                                                                        let _e6624 = select(_e6622, _e6621, (_e6621 > _e6622));
                                                                        let _e6625 = abs(_e6594);
                                                                        let _e6632 = (((select(_e6610, _e6609, (_e6609 > _e6610)) * select(_e6617, _e6616, (_e6616 > _e6617))) * select(_e6625, _e6624, (_e6624 > _e6625))) <= (abs((_e6588 * _e6605)) * 256f));
                                                                        if _e6632 {
                                                                            phi_2730_ = array<f32, 3>(_e6605, _e6598, _e6599);
                                                                            phi_2731_ = array<f32, 3>();
                                                                        } else {
                                                                            let _e6634 = (_e6430 * 4097f);
                                                                            let _e6636 = (_e6634 - (_e6634 - _e6430));
                                                                            let _e6637 = (_e6423 * 4097f);
                                                                            let _e6639 = (_e6637 - (_e6637 - _e6423));
                                                                            let _e6640 = (_e6430 - _e6636);
                                                                            let _e6641 = (_e6423 - _e6639);
                                                                            let _e6650 = (_e6437 * 4097f);
                                                                            let _e6652 = (_e6650 - (_e6650 - _e6437));
                                                                            let _e6653 = (_e6416 * 4097f);
                                                                            let _e6655 = (_e6653 - (_e6653 - _e6416));
                                                                            let _e6656 = (_e6437 - _e6652);
                                                                            let _e6657 = (_e6416 - _e6655);
                                                                            let _e6667 = ((_e6438 - _e6439) + ((((((_e6636 * _e6639) - _e6438) + (_e6636 * _e6641)) + (_e6640 * _e6639)) + (_e6640 * _e6641)) - (((((_e6652 * _e6655) - _e6439) + (_e6652 * _e6657)) + (_e6656 * _e6655)) + (_e6656 * _e6657))));
                                                                            let _e6669 = (_e6402 * 4097f);
                                                                            let _e6671 = (_e6669 - (_e6669 - _e6402));
                                                                            let _e6672 = (_e6402 - _e6671);
                                                                            let _e6681 = (_e6409 * 4097f);
                                                                            let _e6683 = (_e6681 - (_e6681 - _e6409));
                                                                            let _e6684 = (_e6409 - _e6683);
                                                                            let _e6694 = ((_e6477 - _e6478) + ((((((_e6671 * _e6652) - _e6477) + (_e6671 * _e6656)) + (_e6672 * _e6652)) + (_e6672 * _e6656)) - (((((_e6683 * _e6636) - _e6478) + (_e6683 * _e6640)) + (_e6684 * _e6636)) + (_e6684 * _e6640))));
                                                                            let _e6713 = ((_e6516 - _e6517) + ((((((_e6655 * _e6683) - _e6516) + (_e6655 * _e6684)) + (_e6657 * _e6683)) + (_e6657 * _e6684)) - (((((_e6639 * _e6671) - _e6517) + (_e6639 * _e6672)) + (_e6641 * _e6671)) + (_e6641 * _e6672))));
                                                                            let _e6716 = (1f / ((_e6667 + _e6694) + _e6713));
                                                                            let _e6717 = (_e6694 * _e6716);
                                                                            let _e6718 = (_e6713 * _e6716);
                                                                            phi_2730_ = array<f32, 3>();
                                                                            phi_2731_ = array<f32, 3>(((((_e6667 * _e6716) * _e6592) + (_e6717 * _e6593)) + (_e6718 * _e6594)), _e6717, _e6718);
                                                                        }
                                                                        let _e6728 = phi_2730_;
                                                                        let _e6730 = phi_2731_;
                                                                        phi_2732_ = _e6728;
                                                                        phi_2733_ = _e6730;
                                                                        phi_2734_ = _e6632;
                                                                    }
                                                                    let _e6732 = phi_2732_;
                                                                    let _e6734 = phi_2733_;
                                                                    let _e6736 = phi_2734_;
                                                                    phi_2735_ = _e6732;
                                                                    phi_2736_ = _e6734;
                                                                    phi_2737_ = _e6591;
                                                                    phi_2738_ = _e6736;
                                                                } else {
                                                                    phi_2735_ = array<f32, 3>();
                                                                    phi_2736_ = array<f32, 3>();
                                                                    phi_2737_ = true;
                                                                    phi_2738_ = false;
                                                                }
                                                                let _e6738 = phi_2735_;
                                                                let _e6740 = phi_2736_;
                                                                let _e6742 = phi_2737_;
                                                                let _e6744 = phi_2738_;
                                                                if _e6742 {
                                                                    phi_2743_ = array<f32, 3>(-1f, 0f, 0f);
                                                                } else {
                                                                    phi_2743_ = _e6738;
                                                                }
                                                                let _e6746 = phi_2743_;
                                                                if select(_e6744, true, _e6742) {
                                                                    phi_2748_ = _e6746;
                                                                } else {
                                                                    phi_2748_ = _e6740;
                                                                }
                                                                let _e6749 = phi_2748_;
                                                                let _e6753 = (_e6749[0] >= 0f);
                                                                if _e6753 {
                                                                    let _e6754 = (_e6749[0] < 0.9999995f);
                                                                    if _e6754 {
                                                                        if _e6753 {
                                                                            if _e6380 {
                                                                            } else {
                                                                                phi_17150_ = true;
                                                                                phi_12552_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e6757 = triangles.member[_e6375.member_1].member_3;
                                                                            if ((_e6757 & 1u) == 0u) {
                                                                                phi_3080_ = true;
                                                                            } else {
                                                                                if _e6380 {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6762 = triangles.member[_e6375.member_1].member_1;
                                                                                let _e6763 = (_e6762 * 12u);
                                                                                if ((256u + _e6763) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 257u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 258u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6770 = (_e6763 + 259u);
                                                                                if (_e6770 < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6773 = surfaces.member[_e6770];
                                                                                if ((_e6763 + 260u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 261u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 262u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6780 = (_e6763 + 263u);
                                                                                if (_e6780 < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6783 = surfaces.member[_e6780];
                                                                                let _e6784 = (_e6763 + 264u);
                                                                                if (_e6784 < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6787 = surfaces.member[_e6784];
                                                                                let _e6788 = bitcast<f32>(_e6787);
                                                                                let _e6789 = (_e6763 + 265u);
                                                                                if (_e6789 < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6792 = surfaces.member[_e6789];
                                                                                let _e6793 = bitcast<f32>(_e6792);
                                                                                if ((_e6763 + 266u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 267u) < _e147) {
                                                                                } else {
                                                                                    phi_17150_ = true;
                                                                                    phi_12552_ = bool();
                                                                                    break;
                                                                                }
                                                                                if (_e6773 == 4294967295u) {
                                                                                    phi_3075_ = (_e6788 < _e6793);
                                                                                } else {
                                                                                    if (_e6375.member_1 < _e144) {
                                                                                    } else {
                                                                                        phi_17150_ = true;
                                                                                        phi_12552_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6801 = ((1f - _e6749[1]) - _e6749[2]);
                                                                                    let _e6805 = attributes.member[_e6375.member_1].member[0u];
                                                                                    let _e6810 = attributes.member[_e6375.member_1].member[2u];
                                                                                    let _e6816 = attributes.member[_e6375.member_1].member[4u];
                                                                                    let _e6818 = (((_e6805 * _e6801) + (_e6810 * _e6749[1])) + (_e6816 * _e6749[2]));
                                                                                    let _e6822 = attributes.member[_e6375.member_1].member[1u];
                                                                                    let _e6827 = attributes.member[_e6375.member_1].member[3u];
                                                                                    let _e6833 = attributes.member[_e6375.member_1].member[5u];
                                                                                    let _e6835 = (((_e6822 * _e6801) + (_e6827 * _e6749[1])) + (_e6833 * _e6749[2]));
                                                                                    let _e6836 = (_e6783 & 65535u);
                                                                                    let _e6838 = (_e6783 >> bitcast<u32>(16i));
                                                                                    let _e6840 = (_e6818 - floor(_e6818));
                                                                                    let _e6845 = ((select(0f, _e6840, (_e6840 <= 1f)) * f32(_e6836)) - 0.5f);
                                                                                    let _e6846 = floor(_e6845);
                                                                                    let _e6847 = (_e6845 - _e6846);
                                                                                    let _e6848 = (_e6836 - 1u);
                                                                                    if (_e6846 < 0f) {
                                                                                        phi_2958_ = _e6848;
                                                                                    } else {
                                                                                        let _e6854 = select(select(u32(_e6846), 0u, (_e6846 < 0f)), 4294967295u, (_e6846 > 4294967000f));
                                                                                        phi_2958_ = select(_e6854, _e6848, (_e6848 < _e6854));
                                                                                    }
                                                                                    let _e6858 = phi_2958_;
                                                                                    if (_e6858 == _e6848) {
                                                                                        phi_2964_ = 0u;
                                                                                    } else {
                                                                                        phi_2964_ = (_e6858 + 1u);
                                                                                    }
                                                                                    let _e6862 = phi_2964_;
                                                                                    let _e6864 = (_e6835 - floor(_e6835));
                                                                                    let _e6869 = ((select(0f, _e6864, (_e6864 <= 1f)) * f32(_e6838)) - 0.5f);
                                                                                    let _e6870 = floor(_e6869);
                                                                                    let _e6871 = (_e6869 - _e6870);
                                                                                    let _e6872 = (_e6838 - 1u);
                                                                                    if (_e6870 < 0f) {
                                                                                        phi_2994_ = _e6872;
                                                                                    } else {
                                                                                        let _e6878 = select(select(u32(_e6870), 0u, (_e6870 < 0f)), 4294967295u, (_e6870 > 4294967000f));
                                                                                        phi_2994_ = select(_e6878, _e6872, (_e6872 < _e6878));
                                                                                    }
                                                                                    let _e6882 = phi_2994_;
                                                                                    if (_e6882 == _e6872) {
                                                                                        phi_3000_ = 0u;
                                                                                    } else {
                                                                                        phi_3000_ = (_e6882 + 1u);
                                                                                    }
                                                                                    let _e6886 = phi_3000_;
                                                                                    let _e6888 = (_e6773 + (_e6882 * _e6836));
                                                                                    let _e6890 = (_e6773 + (_e6886 * _e6836));
                                                                                    let _e6891 = (_e6888 + _e6858);
                                                                                    let _e6892 = (_e6888 + _e6862);
                                                                                    let _e6893 = (_e6890 + _e6858);
                                                                                    let _e6894 = (_e6890 + _e6862);
                                                                                    if (_e6891 < _e147) {
                                                                                    } else {
                                                                                        phi_17150_ = true;
                                                                                        phi_12552_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6897 = surfaces.member[_e6891];
                                                                                    if (_e6892 < _e147) {
                                                                                    } else {
                                                                                        phi_17150_ = true;
                                                                                        phi_12552_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6900 = surfaces.member[_e6892];
                                                                                    if (_e6893 < _e147) {
                                                                                    } else {
                                                                                        phi_17150_ = true;
                                                                                        phi_12552_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6903 = surfaces.member[_e6893];
                                                                                    if (_e6894 < _e147) {
                                                                                    } else {
                                                                                        phi_17150_ = true;
                                                                                        phi_12552_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6906 = surfaces.member[_e6894];
                                                                                    let _e6923 = (1f - _e6847);
                                                                                    phi_3075_ = ((_e6788 * (((((f32((_e6897 >> bitcast<u32>(24i))) * 0.003921569f) * _e6923) + ((f32((_e6900 >> bitcast<u32>(24i))) * 0.003921569f) * _e6847)) * (1f - _e6871)) + ((((f32((_e6903 >> bitcast<u32>(24i))) * 0.003921569f) * _e6923) + ((f32((_e6906 >> bitcast<u32>(24i))) * 0.003921569f) * _e6847)) * _e6871))) < _e6793);
                                                                                }
                                                                                let _e6938 = phi_3075_;
                                                                                phi_3080_ = select(true, false, _e6938);
                                                                            }
                                                                            let _e6941 = phi_3080_;
                                                                            if _e6941 {
                                                                                phi_3085_ = type_47(_e6749[0], _e6375.member_1, _e6749[1], _e6749[2]);
                                                                            } else {
                                                                                phi_3085_ = type_47();
                                                                            }
                                                                            let _e6944 = phi_3085_;
                                                                            phi_3087_ = _e6944;
                                                                            phi_3089_ = select(true, false, _e6941);
                                                                        } else {
                                                                            phi_3087_ = type_47();
                                                                            phi_3089_ = false;
                                                                        }
                                                                        let _e6947 = phi_3087_;
                                                                        let _e6949 = phi_3089_;
                                                                        phi_3090_ = _e6947;
                                                                        phi_3092_ = select(true, false, _e6753);
                                                                        phi_3093_ = _e6949;
                                                                    } else {
                                                                        phi_3090_ = type_47();
                                                                        phi_3092_ = false;
                                                                        phi_3093_ = false;
                                                                    }
                                                                    let _e6952 = phi_3090_;
                                                                    let _e6954 = phi_3092_;
                                                                    let _e6956 = phi_3093_;
                                                                    phi_3094_ = _e6952;
                                                                    phi_3095_ = select(true, false, _e6754);
                                                                    phi_3096_ = _e6954;
                                                                    phi_3097_ = _e6956;
                                                                } else {
                                                                    phi_3094_ = type_47();
                                                                    phi_3095_ = true;
                                                                    phi_3096_ = false;
                                                                    phi_3097_ = false;
                                                                }
                                                                let _e6959 = phi_3094_;
                                                                let _e6961 = phi_3095_;
                                                                let _e6963 = phi_3096_;
                                                                let _e6965 = phi_3097_;
                                                                if select(select(_e6965, false, _e6961), true, select(_e6963, true, _e6961)) {
                                                                    phi_3110_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                                } else {
                                                                    phi_3110_ = _e6959;
                                                                }
                                                                let _e6970 = phi_3110_;
                                                                phi_3117_ = select(true, false, (_e6970.member_1 != 4294967295u));
                                                            } else {
                                                                phi_3117_ = false;
                                                            }
                                                            let _e6975 = phi_3117_;
                                                            continue;
                                                            continuing {
                                                                phi_2434_ = _e6373;
                                                                phi_17150_ = _e6348;
                                                                phi_12552_ = select(true, false, _e6379);
                                                                break if !(_e6975);
                                                            }
                                                        }
                                                        let _e6979 = phi_17150_;
                                                        let _e6981 = phi_12552_;
                                                        phi_17224_ = _e6979;
                                                        phi_12553_ = bool();
                                                        if _e6979 {
                                                            break;
                                                        }
                                                        phi_17226_ = _e6979;
                                                        phi_3122_ = _e6352;
                                                        phi_3123_ = _e6981;
                                                    }
                                                    let _e7218 = phi_17226_;
                                                    let _e7220 = phi_3122_;
                                                    let _e7222 = phi_3123_;
                                                    if _e7222 {
                                                        let _e7223 = (_e7220 == 0u);
                                                        if _e7223 {
                                                            phi_3139_ = u32();
                                                            phi_3140_ = u32();
                                                        } else {
                                                            let _e7224 = (_e7220 - 1u);
                                                            if (_e7224 < 64u) {
                                                            } else {
                                                                phi_17224_ = true;
                                                                phi_12553_ = bool();
                                                                break;
                                                            }
                                                            let _e7227 = local_18[_e7224];
                                                            phi_3139_ = _e7227;
                                                            phi_3140_ = _e7224;
                                                        }
                                                        let _e7229 = phi_3139_;
                                                        let _e7231 = phi_3140_;
                                                        phi_2007_ = _e7229;
                                                        phi_2010_ = _e7231;
                                                        phi_3142_ = select(true, false, _e7223);
                                                        phi_3143_ = _e7223;
                                                    } else {
                                                        phi_2007_ = u32();
                                                        phi_2010_ = u32();
                                                        phi_3142_ = false;
                                                        phi_3143_ = false;
                                                    }
                                                    let _e7234 = phi_2007_;
                                                    let _e7236 = phi_2010_;
                                                    let _e7238 = phi_3142_;
                                                    let _e7240 = phi_3143_;
                                                    continue;
                                                    continuing {
                                                        phi_17154_ = _e7218;
                                                        phi_2006_ = _e7234;
                                                        phi_2009_ = _e7236;
                                                        phi_17224_ = _e7218;
                                                        phi_12553_ = _e7240;
                                                        break if !(_e7238);
                                                    }
                                                }
                                                let _e7243 = phi_17224_;
                                                let _e7245 = phi_12553_;
                                                phi_17284_ = _e7243;
                                                if _e7243 {
                                                    break;
                                                }
                                                if !(select(false, true, select(true, false, _e7245))) {
                                                    phi_3157_ = (_e6078 + _e6198);
                                                } else {
                                                    phi_3157_ = _e6078;
                                                }
                                                let _e7251 = phi_3157_;
                                                phi_17286_ = _e7243;
                                                phi_3158_ = _e7251;
                                            } else {
                                                phi_17286_ = _e6072;
                                                phi_3158_ = _e6078;
                                            }
                                            let _e7253 = phi_17286_;
                                            let _e7255 = phi_3158_;
                                            phi_17285_ = _e7253;
                                            phi_1614_ = select(_e6181, _e6076, (_e6076 < _e6181));
                                            phi_1616_ = _e7255;
                                            phi_1618_ = (_e6080 + _e6198);
                                        } else {
                                            phi_17285_ = _e6072;
                                            phi_1614_ = f32();
                                            phi_1616_ = f32();
                                            phi_1618_ = f32();
                                        }
                                        let _e7257 = phi_17285_;
                                        let _e7259 = phi_1614_;
                                        let _e7261 = phi_1616_;
                                        let _e7263 = phi_1618_;
                                        continue;
                                        continuing {
                                            phi_17176_ = _e7257;
                                            phi_1610_ = _e6093;
                                            phi_1613_ = _e7259;
                                            phi_1615_ = _e7261;
                                            phi_1617_ = _e7263;
                                            phi_17284_ = _e7257;
                                            break if !(_e6099);
                                        }
                                    }
                                    let _e7266 = phi_17284_;
                                    phi_17290_ = _e7266;
                                    if _e7266 {
                                        break;
                                    }
                                    let _e7268 = local_25;
                                    if (_e7268 <= 0f) {
                                        phi_3187_ = 0f;
                                        phi_3188_ = f32();
                                        phi_3189_ = true;
                                    } else {
                                        if (_e215 == 1u) {
                                            phi_3177_ = f32();
                                            phi_3178_ = true;
                                        } else {
                                            let _e7273 = local_26;
                                            let _e7275 = (_e3823.member_3 < (0.01f * _e7273));
                                            if _e7275 {
                                                phi_3176_ = f32();
                                            } else {
                                                let _e7276 = (_e3823.member[0] - _e163.member[0]);
                                                let _e7277 = (_e3823.member[1] - _e163.member[1]);
                                                let _e7278 = (_e3823.member[2] - _e163.member[2]);
                                                let _e7279 = (vec3<f32>(_e3823.member[0], _e3823.member[1], _e3823.member[2]) - _e190);
                                                let _e7280 = (_e3823.member_2[0] - _e163.member[0]);
                                                let _e7281 = (_e3823.member_2[1] - _e163.member[1]);
                                                let _e7282 = (_e3823.member_2[2] - _e163.member[2]);
                                                let _e7283 = (vec3<f32>(_e3823.member_2[0], _e3823.member_2[1], _e3823.member_2[2]) - _e190);
                                                let _e7284 = (_e3823.member_4[0] - _e163.member[0]);
                                                let _e7285 = (_e3823.member_4[1] - _e163.member[1]);
                                                let _e7286 = (_e3823.member_4[2] - _e163.member[2]);
                                                let _e7287 = (vec3<f32>(_e3823.member_4[0], _e3823.member_4[1], _e3823.member_4[2]) - _e190);
                                                let _e7295 = (((_e185.x * _e7276) + (_e185.y * _e7277)) + (_e185.z * _e7278));
                                                let _e7300 = (((_e185.x * _e7280) + (_e185.y * _e7281)) + (_e185.z * _e7282));
                                                let _e7305 = (((_e185.x * _e7284) + (_e185.y * _e7285)) + (_e185.z * _e7286));
                                                let _e7306 = (_e7295 <= 0f);
                                                if _e7306 {
                                                    phi_15158_ = select(true, false, (_e7300 <= 0f));
                                                } else {
                                                    phi_15158_ = true;
                                                }
                                                let _e7310 = phi_15158_;
                                                if _e7310 {
                                                    if _e7306 {
                                                        phi_15169_ = true;
                                                    } else {
                                                        phi_15169_ = (_e7300 <= 0f);
                                                    }
                                                    let _e7313 = phi_15169_;
                                                    if _e7313 {
                                                        let _e7318 = (_e7295 / (_e7295 - _e7300));
                                                        let _e7325 = vec3<f32>((_e7276 + ((_e7280 - _e7276) * _e7318)), (_e7277 + ((_e7281 - _e7277) * _e7318)), (_e7278 + ((_e7282 - _e7278) * _e7318)));
                                                        if _e7306 {
                                                            phi_15190_ = type_60(0f, vec3<f32>(0f, 0f, 0f), _e7325);
                                                        } else {
                                                            phi_15190_ = type_60(0f, _e7325, vec3<f32>(0f, 0f, 0f));
                                                        }
                                                        let _e7329 = phi_15190_;
                                                        let _e7330 = vec3(_e7306);
                                                        phi_15194_ = _e7329;
                                                        phi_15195_ = select(_e7325, _e7283, _e7330);
                                                        phi_15196_ = select(_e7279, _e7325, _e7330);
                                                    } else {
                                                        phi_15194_ = type_60(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                        phi_15195_ = _e7283;
                                                        phi_15196_ = _e7279;
                                                    }
                                                    let _e7334 = phi_15194_;
                                                    let _e7336 = phi_15195_;
                                                    let _e7338 = phi_15196_;
                                                    let _e7340 = abs(_e7338.x);
                                                    let _e7342 = abs(_e7338.y);
                                                    let _e7344 = select(_e7342, _e7340, (_e7340 > _e7342));
                                                    let _e7346 = abs(_e7338.z);
                                                    let _e7348 = select(_e7346, _e7344, (_e7344 > _e7346));
                                                    if (_e7348 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7350 = (_e7348 < 340282350000000000000000000000000000000f);
                                                        if _e7350 {
                                                            let _e7351 = (_e7338.x / _e7348);
                                                            let _e7352 = (_e7338.y / _e7348);
                                                            let _e7353 = (_e7338.z / _e7348);
                                                            let _e7359 = sqrt((((_e7351 * _e7351) + (_e7352 * _e7352)) + (_e7353 * _e7353)));
                                                            phi_15236_ = vec3<f32>((_e7351 / _e7359), (_e7352 / _e7359), (_e7353 / _e7359));
                                                        } else {
                                                            phi_15236_ = vec3<f32>();
                                                        }
                                                        let _e7365 = phi_15236_;
                                                        phi_15239_ = _e7365;
                                                        phi_15240_ = select(true, false, _e7350);
                                                    } else {
                                                        phi_15239_ = vec3<f32>();
                                                        phi_15240_ = true;
                                                    }
                                                    let _e7368 = phi_15239_;
                                                    let _e7370 = phi_15240_;
                                                    let _e7372 = select(_e7368, vec3<f32>(0f, 0f, 0f), vec3(_e7370));
                                                    let _e7374 = abs(_e7336.x);
                                                    let _e7376 = abs(_e7336.y);
                                                    let _e7378 = select(_e7376, _e7374, (_e7374 > _e7376));
                                                    let _e7380 = abs(_e7336.z);
                                                    let _e7382 = select(_e7380, _e7378, (_e7378 > _e7380));
                                                    if (_e7382 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7384 = (_e7382 < 340282350000000000000000000000000000000f);
                                                        if _e7384 {
                                                            let _e7385 = (_e7336.x / _e7382);
                                                            let _e7386 = (_e7336.y / _e7382);
                                                            let _e7387 = (_e7336.z / _e7382);
                                                            let _e7393 = sqrt((((_e7385 * _e7385) + (_e7386 * _e7386)) + (_e7387 * _e7387)));
                                                            phi_15284_ = vec3<f32>((_e7385 / _e7393), (_e7386 / _e7393), (_e7387 / _e7393));
                                                        } else {
                                                            phi_15284_ = vec3<f32>();
                                                        }
                                                        let _e7399 = phi_15284_;
                                                        phi_15287_ = _e7399;
                                                        phi_15288_ = select(true, false, _e7384);
                                                    } else {
                                                        phi_15287_ = vec3<f32>();
                                                        phi_15288_ = true;
                                                    }
                                                    let _e7402 = phi_15287_;
                                                    let _e7404 = phi_15288_;
                                                    let _e7406 = select(_e7402, vec3<f32>(0f, 0f, 0f), vec3(_e7404));
                                                    let _e7413 = ((_e7372.y * _e7406.z) - (_e7406.y * _e7372.z));
                                                    let _e7418 = ((_e7372.z * _e7406.x) - (_e7406.z * _e7372.x));
                                                    let _e7421 = ((_e7372.x * _e7406.y) - (_e7406.x * _e7372.y));
                                                    let _e7427 = sqrt((((_e7413 * _e7413) + (_e7418 * _e7418)) + (_e7421 * _e7421)));
                                                    if (_e7427 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_15402_ = 0f;
                                                    } else {
                                                        let _e7439 = (((_e7372.x * _e7406.x) + (_e7372.y * _e7406.y)) + (_e7372.z * _e7406.z));
                                                        let _e7440 = abs(_e7439);
                                                        let _e7441 = abs(_e7427);
                                                        let _e7442 = (_e7441 > _e7440);
                                                        let _e7443 = select(_e7440, _e7441, _e7442);
                                                        if (_e7443 > 0f) {
                                                            phi_15355_ = (select(_e7441, _e7440, _e7442) / _e7443);
                                                        } else {
                                                            phi_15355_ = 0f;
                                                        }
                                                        let _e7448 = phi_15355_;
                                                        let _e7449 = (_e7448 > 0.41421357f);
                                                        if _e7449 {
                                                            phi_15363_ = ((_e7448 - 1f) / (_e7448 + 1f));
                                                        } else {
                                                            phi_15363_ = _e7448;
                                                        }
                                                        let _e7454 = phi_15363_;
                                                        let _e7455 = (_e7454 * _e7454);
                                                        let _e7464 = (_e7454 + ((_e7454 * _e7455) * (-0.3333295f + (_e7455 * (0.19977711f + (_e7455 * (-0.13877685f + (_e7455 * 0.080537446f))))))));
                                                        if _e7449 {
                                                            phi_15378_ = (_e7464 + 0.7853982f);
                                                        } else {
                                                            phi_15378_ = _e7464;
                                                        }
                                                        let _e7467 = phi_15378_;
                                                        if _e7442 {
                                                            phi_15384_ = (1.5707964f - _e7467);
                                                        } else {
                                                            phi_15384_ = _e7467;
                                                        }
                                                        let _e7470 = phi_15384_;
                                                        if ((bitcast<u32>(_e7439) & 2147483648u) == 0u) {
                                                            phi_15392_ = _e7470;
                                                        } else {
                                                            phi_15392_ = (3.1415927f - _e7470);
                                                        }
                                                        let _e7476 = phi_15392_;
                                                        phi_15402_ = (((((_e185.x * _e7413) + (_e185.y * _e7418)) + (_e185.z * _e7421)) / _e7427) * bitcast<f32>(((bitcast<u32>(_e7476) & 2147483647u) | (bitcast<u32>(_e7427) & 2147483648u))));
                                                    }
                                                    let _e7485 = phi_15402_;
                                                    phi_15407_ = type_60((_e7334.member + _e7485), _e7334.member_1, _e7334.member_2);
                                                } else {
                                                    phi_15407_ = type_60(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                }
                                                let _e7493 = phi_15407_;
                                                let _e7494 = (_e7300 <= 0f);
                                                if _e7494 {
                                                    phi_15417_ = select(true, false, (_e7305 <= 0f));
                                                } else {
                                                    phi_15417_ = true;
                                                }
                                                let _e7498 = phi_15417_;
                                                if _e7498 {
                                                    if _e7494 {
                                                        phi_15428_ = true;
                                                    } else {
                                                        phi_15428_ = (_e7305 <= 0f);
                                                    }
                                                    let _e7501 = phi_15428_;
                                                    if _e7501 {
                                                        let _e7506 = (_e7300 / (_e7300 - _e7305));
                                                        let _e7513 = vec3<f32>((_e7280 + ((_e7284 - _e7280) * _e7506)), (_e7281 + ((_e7285 - _e7281) * _e7506)), (_e7282 + ((_e7286 - _e7282) * _e7506)));
                                                        if _e7494 {
                                                            phi_15449_ = type_60(_e7493.member, _e7493.member_1, _e7513);
                                                        } else {
                                                            phi_15449_ = type_60(_e7493.member, _e7513, _e7493.member_2);
                                                        }
                                                        let _e7523 = phi_15449_;
                                                        let _e7524 = vec3(_e7494);
                                                        phi_15453_ = _e7523;
                                                        phi_15454_ = select(_e7513, _e7287, _e7524);
                                                        phi_15455_ = select(_e7283, _e7513, _e7524);
                                                    } else {
                                                        phi_15453_ = _e7493;
                                                        phi_15454_ = _e7287;
                                                        phi_15455_ = _e7283;
                                                    }
                                                    let _e7528 = phi_15453_;
                                                    let _e7530 = phi_15454_;
                                                    let _e7532 = phi_15455_;
                                                    let _e7534 = abs(_e7532.x);
                                                    let _e7536 = abs(_e7532.y);
                                                    let _e7538 = select(_e7536, _e7534, (_e7534 > _e7536));
                                                    let _e7540 = abs(_e7532.z);
                                                    let _e7542 = select(_e7540, _e7538, (_e7538 > _e7540));
                                                    if (_e7542 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7544 = (_e7542 < 340282350000000000000000000000000000000f);
                                                        if _e7544 {
                                                            let _e7545 = (_e7532.x / _e7542);
                                                            let _e7546 = (_e7532.y / _e7542);
                                                            let _e7547 = (_e7532.z / _e7542);
                                                            let _e7553 = sqrt((((_e7545 * _e7545) + (_e7546 * _e7546)) + (_e7547 * _e7547)));
                                                            phi_15495_ = vec3<f32>((_e7545 / _e7553), (_e7546 / _e7553), (_e7547 / _e7553));
                                                        } else {
                                                            phi_15495_ = vec3<f32>();
                                                        }
                                                        let _e7559 = phi_15495_;
                                                        phi_15498_ = _e7559;
                                                        phi_15499_ = select(true, false, _e7544);
                                                    } else {
                                                        phi_15498_ = vec3<f32>();
                                                        phi_15499_ = true;
                                                    }
                                                    let _e7562 = phi_15498_;
                                                    let _e7564 = phi_15499_;
                                                    let _e7566 = select(_e7562, vec3<f32>(0f, 0f, 0f), vec3(_e7564));
                                                    let _e7568 = abs(_e7530.x);
                                                    let _e7570 = abs(_e7530.y);
                                                    let _e7572 = select(_e7570, _e7568, (_e7568 > _e7570));
                                                    let _e7574 = abs(_e7530.z);
                                                    let _e7576 = select(_e7574, _e7572, (_e7572 > _e7574));
                                                    if (_e7576 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7578 = (_e7576 < 340282350000000000000000000000000000000f);
                                                        if _e7578 {
                                                            let _e7579 = (_e7530.x / _e7576);
                                                            let _e7580 = (_e7530.y / _e7576);
                                                            let _e7581 = (_e7530.z / _e7576);
                                                            let _e7587 = sqrt((((_e7579 * _e7579) + (_e7580 * _e7580)) + (_e7581 * _e7581)));
                                                            phi_15543_ = vec3<f32>((_e7579 / _e7587), (_e7580 / _e7587), (_e7581 / _e7587));
                                                        } else {
                                                            phi_15543_ = vec3<f32>();
                                                        }
                                                        let _e7593 = phi_15543_;
                                                        phi_15546_ = _e7593;
                                                        phi_15547_ = select(true, false, _e7578);
                                                    } else {
                                                        phi_15546_ = vec3<f32>();
                                                        phi_15547_ = true;
                                                    }
                                                    let _e7596 = phi_15546_;
                                                    let _e7598 = phi_15547_;
                                                    let _e7600 = select(_e7596, vec3<f32>(0f, 0f, 0f), vec3(_e7598));
                                                    let _e7607 = ((_e7566.y * _e7600.z) - (_e7600.y * _e7566.z));
                                                    let _e7612 = ((_e7566.z * _e7600.x) - (_e7600.z * _e7566.x));
                                                    let _e7615 = ((_e7566.x * _e7600.y) - (_e7600.x * _e7566.y));
                                                    let _e7621 = sqrt((((_e7607 * _e7607) + (_e7612 * _e7612)) + (_e7615 * _e7615)));
                                                    if (_e7621 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_15661_ = 0f;
                                                    } else {
                                                        let _e7633 = (((_e7566.x * _e7600.x) + (_e7566.y * _e7600.y)) + (_e7566.z * _e7600.z));
                                                        let _e7634 = abs(_e7633);
                                                        let _e7635 = abs(_e7621);
                                                        let _e7636 = (_e7635 > _e7634);
                                                        let _e7637 = select(_e7634, _e7635, _e7636);
                                                        if (_e7637 > 0f) {
                                                            phi_15614_ = (select(_e7635, _e7634, _e7636) / _e7637);
                                                        } else {
                                                            phi_15614_ = 0f;
                                                        }
                                                        let _e7642 = phi_15614_;
                                                        let _e7643 = (_e7642 > 0.41421357f);
                                                        if _e7643 {
                                                            phi_15622_ = ((_e7642 - 1f) / (_e7642 + 1f));
                                                        } else {
                                                            phi_15622_ = _e7642;
                                                        }
                                                        let _e7648 = phi_15622_;
                                                        let _e7649 = (_e7648 * _e7648);
                                                        let _e7658 = (_e7648 + ((_e7648 * _e7649) * (-0.3333295f + (_e7649 * (0.19977711f + (_e7649 * (-0.13877685f + (_e7649 * 0.080537446f))))))));
                                                        if _e7643 {
                                                            phi_15637_ = (_e7658 + 0.7853982f);
                                                        } else {
                                                            phi_15637_ = _e7658;
                                                        }
                                                        let _e7661 = phi_15637_;
                                                        if _e7636 {
                                                            phi_15643_ = (1.5707964f - _e7661);
                                                        } else {
                                                            phi_15643_ = _e7661;
                                                        }
                                                        let _e7664 = phi_15643_;
                                                        if ((bitcast<u32>(_e7633) & 2147483648u) == 0u) {
                                                            phi_15651_ = _e7664;
                                                        } else {
                                                            phi_15651_ = (3.1415927f - _e7664);
                                                        }
                                                        let _e7670 = phi_15651_;
                                                        phi_15661_ = (((((_e185.x * _e7607) + (_e185.y * _e7612)) + (_e185.z * _e7615)) / _e7621) * bitcast<f32>(((bitcast<u32>(_e7670) & 2147483647u) | (bitcast<u32>(_e7621) & 2147483648u))));
                                                    }
                                                    let _e7679 = phi_15661_;
                                                    phi_15666_ = type_60((_e7528.member + _e7679), _e7528.member_1, _e7528.member_2);
                                                } else {
                                                    phi_15666_ = _e7493;
                                                }
                                                let _e7687 = phi_15666_;
                                                let _e7688 = (_e7305 <= 0f);
                                                if _e7688 {
                                                    phi_15676_ = select(true, false, _e7306);
                                                } else {
                                                    phi_15676_ = true;
                                                }
                                                let _e7691 = phi_15676_;
                                                if _e7691 {
                                                    if select(_e7306, true, _e7688) {
                                                        let _e7697 = (_e7305 / (_e7305 - _e7295));
                                                        let _e7704 = vec3<f32>((_e7284 + ((_e7276 - _e7284) * _e7697)), (_e7285 + ((_e7277 - _e7285) * _e7697)), (_e7286 + ((_e7278 - _e7286) * _e7697)));
                                                        if _e7688 {
                                                            phi_15708_ = type_60(_e7687.member, _e7687.member_1, _e7704);
                                                        } else {
                                                            phi_15708_ = type_60(_e7687.member, _e7704, _e7687.member_2);
                                                        }
                                                        let _e7714 = phi_15708_;
                                                        let _e7715 = vec3(_e7688);
                                                        phi_15712_ = _e7714;
                                                        phi_15713_ = select(_e7704, _e7279, _e7715);
                                                        phi_15714_ = select(_e7287, _e7704, _e7715);
                                                    } else {
                                                        phi_15712_ = _e7687;
                                                        phi_15713_ = _e7279;
                                                        phi_15714_ = _e7287;
                                                    }
                                                    let _e7719 = phi_15712_;
                                                    let _e7721 = phi_15713_;
                                                    let _e7723 = phi_15714_;
                                                    let _e7725 = abs(_e7723.x);
                                                    let _e7727 = abs(_e7723.y);
                                                    let _e7729 = select(_e7727, _e7725, (_e7725 > _e7727));
                                                    let _e7731 = abs(_e7723.z);
                                                    let _e7733 = select(_e7731, _e7729, (_e7729 > _e7731));
                                                    if (_e7733 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7735 = (_e7733 < 340282350000000000000000000000000000000f);
                                                        if _e7735 {
                                                            let _e7736 = (_e7723.x / _e7733);
                                                            let _e7737 = (_e7723.y / _e7733);
                                                            let _e7738 = (_e7723.z / _e7733);
                                                            let _e7744 = sqrt((((_e7736 * _e7736) + (_e7737 * _e7737)) + (_e7738 * _e7738)));
                                                            phi_15754_ = vec3<f32>((_e7736 / _e7744), (_e7737 / _e7744), (_e7738 / _e7744));
                                                        } else {
                                                            phi_15754_ = vec3<f32>();
                                                        }
                                                        let _e7750 = phi_15754_;
                                                        phi_15757_ = _e7750;
                                                        phi_15758_ = select(true, false, _e7735);
                                                    } else {
                                                        phi_15757_ = vec3<f32>();
                                                        phi_15758_ = true;
                                                    }
                                                    let _e7753 = phi_15757_;
                                                    let _e7755 = phi_15758_;
                                                    let _e7757 = select(_e7753, vec3<f32>(0f, 0f, 0f), vec3(_e7755));
                                                    let _e7759 = abs(_e7721.x);
                                                    let _e7761 = abs(_e7721.y);
                                                    let _e7763 = select(_e7761, _e7759, (_e7759 > _e7761));
                                                    let _e7765 = abs(_e7721.z);
                                                    let _e7767 = select(_e7765, _e7763, (_e7763 > _e7765));
                                                    if (_e7767 > 0.000000000000000000000000000000000000011754944f) {
                                                        let _e7769 = (_e7767 < 340282350000000000000000000000000000000f);
                                                        if _e7769 {
                                                            let _e7770 = (_e7721.x / _e7767);
                                                            let _e7771 = (_e7721.y / _e7767);
                                                            let _e7772 = (_e7721.z / _e7767);
                                                            let _e7778 = sqrt((((_e7770 * _e7770) + (_e7771 * _e7771)) + (_e7772 * _e7772)));
                                                            phi_15802_ = vec3<f32>((_e7770 / _e7778), (_e7771 / _e7778), (_e7772 / _e7778));
                                                        } else {
                                                            phi_15802_ = vec3<f32>();
                                                        }
                                                        let _e7784 = phi_15802_;
                                                        phi_15805_ = _e7784;
                                                        phi_15806_ = select(true, false, _e7769);
                                                    } else {
                                                        phi_15805_ = vec3<f32>();
                                                        phi_15806_ = true;
                                                    }
                                                    let _e7787 = phi_15805_;
                                                    let _e7789 = phi_15806_;
                                                    let _e7791 = select(_e7787, vec3<f32>(0f, 0f, 0f), vec3(_e7789));
                                                    let _e7798 = ((_e7757.y * _e7791.z) - (_e7791.y * _e7757.z));
                                                    let _e7803 = ((_e7757.z * _e7791.x) - (_e7791.z * _e7757.x));
                                                    let _e7806 = ((_e7757.x * _e7791.y) - (_e7791.x * _e7757.y));
                                                    let _e7812 = sqrt((((_e7798 * _e7798) + (_e7803 * _e7803)) + (_e7806 * _e7806)));
                                                    if (_e7812 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_15920_ = 0f;
                                                    } else {
                                                        let _e7824 = (((_e7757.x * _e7791.x) + (_e7757.y * _e7791.y)) + (_e7757.z * _e7791.z));
                                                        let _e7825 = abs(_e7824);
                                                        let _e7826 = abs(_e7812);
                                                        let _e7827 = (_e7826 > _e7825);
                                                        let _e7828 = select(_e7825, _e7826, _e7827);
                                                        if (_e7828 > 0f) {
                                                            phi_15873_ = (select(_e7826, _e7825, _e7827) / _e7828);
                                                        } else {
                                                            phi_15873_ = 0f;
                                                        }
                                                        let _e7833 = phi_15873_;
                                                        let _e7834 = (_e7833 > 0.41421357f);
                                                        if _e7834 {
                                                            phi_15881_ = ((_e7833 - 1f) / (_e7833 + 1f));
                                                        } else {
                                                            phi_15881_ = _e7833;
                                                        }
                                                        let _e7839 = phi_15881_;
                                                        let _e7840 = (_e7839 * _e7839);
                                                        let _e7849 = (_e7839 + ((_e7839 * _e7840) * (-0.3333295f + (_e7840 * (0.19977711f + (_e7840 * (-0.13877685f + (_e7840 * 0.080537446f))))))));
                                                        if _e7834 {
                                                            phi_15896_ = (_e7849 + 0.7853982f);
                                                        } else {
                                                            phi_15896_ = _e7849;
                                                        }
                                                        let _e7852 = phi_15896_;
                                                        if _e7827 {
                                                            phi_15902_ = (1.5707964f - _e7852);
                                                        } else {
                                                            phi_15902_ = _e7852;
                                                        }
                                                        let _e7855 = phi_15902_;
                                                        if ((bitcast<u32>(_e7824) & 2147483648u) == 0u) {
                                                            phi_15910_ = _e7855;
                                                        } else {
                                                            phi_15910_ = (3.1415927f - _e7855);
                                                        }
                                                        let _e7861 = phi_15910_;
                                                        phi_15920_ = (((((_e185.x * _e7798) + (_e185.y * _e7803)) + (_e185.z * _e7806)) / _e7812) * bitcast<f32>(((bitcast<u32>(_e7861) & 2147483647u) | (bitcast<u32>(_e7812) & 2147483648u))));
                                                    }
                                                    let _e7870 = phi_15920_;
                                                    phi_15925_ = type_60((_e7719.member + _e7870), _e7719.member_1, _e7719.member_2);
                                                } else {
                                                    phi_15925_ = _e7687;
                                                }
                                                let _e7878 = phi_15925_;
                                                let _e7882 = abs(_e7878.member_1.x);
                                                let _e7884 = abs(_e7878.member_1.y);
                                                let _e7886 = select(_e7884, _e7882, (_e7882 > _e7884));
                                                let _e7888 = abs(_e7878.member_1.z);
                                                let _e7890 = select(_e7888, _e7886, (_e7886 > _e7888));
                                                if (_e7890 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e7892 = (_e7890 < 340282350000000000000000000000000000000f);
                                                    if _e7892 {
                                                        let _e7893 = (_e7878.member_1.x / _e7890);
                                                        let _e7894 = (_e7878.member_1.y / _e7890);
                                                        let _e7895 = (_e7878.member_1.z / _e7890);
                                                        let _e7901 = sqrt((((_e7893 * _e7893) + (_e7894 * _e7894)) + (_e7895 * _e7895)));
                                                        phi_15967_ = vec3<f32>((_e7893 / _e7901), (_e7894 / _e7901), (_e7895 / _e7901));
                                                    } else {
                                                        phi_15967_ = vec3<f32>();
                                                    }
                                                    let _e7907 = phi_15967_;
                                                    phi_15970_ = _e7907;
                                                    phi_15971_ = select(true, false, _e7892);
                                                } else {
                                                    phi_15970_ = vec3<f32>();
                                                    phi_15971_ = true;
                                                }
                                                let _e7910 = phi_15970_;
                                                let _e7912 = phi_15971_;
                                                let _e7914 = select(_e7910, vec3<f32>(0f, 0f, 0f), vec3(_e7912));
                                                let _e7916 = abs(_e7878.member_2.x);
                                                let _e7918 = abs(_e7878.member_2.y);
                                                let _e7920 = select(_e7918, _e7916, (_e7916 > _e7918));
                                                let _e7922 = abs(_e7878.member_2.z);
                                                let _e7924 = select(_e7922, _e7920, (_e7920 > _e7922));
                                                if (_e7924 > 0.000000000000000000000000000000000000011754944f) {
                                                    let _e7926 = (_e7924 < 340282350000000000000000000000000000000f);
                                                    if _e7926 {
                                                        let _e7927 = (_e7878.member_2.x / _e7924);
                                                        let _e7928 = (_e7878.member_2.y / _e7924);
                                                        let _e7929 = (_e7878.member_2.z / _e7924);
                                                        let _e7935 = sqrt((((_e7927 * _e7927) + (_e7928 * _e7928)) + (_e7929 * _e7929)));
                                                        phi_16015_ = vec3<f32>((_e7927 / _e7935), (_e7928 / _e7935), (_e7929 / _e7935));
                                                    } else {
                                                        phi_16015_ = vec3<f32>();
                                                    }
                                                    let _e7941 = phi_16015_;
                                                    phi_16018_ = _e7941;
                                                    phi_16019_ = select(true, false, _e7926);
                                                } else {
                                                    phi_16018_ = vec3<f32>();
                                                    phi_16019_ = true;
                                                }
                                                let _e7944 = phi_16018_;
                                                let _e7946 = phi_16019_;
                                                let _e7948 = select(_e7944, vec3<f32>(0f, 0f, 0f), vec3(_e7946));
                                                let _e7955 = ((_e7914.y * _e7948.z) - (_e7948.y * _e7914.z));
                                                let _e7960 = ((_e7914.z * _e7948.x) - (_e7948.z * _e7914.x));
                                                let _e7963 = ((_e7914.x * _e7948.y) - (_e7948.x * _e7914.y));
                                                let _e7969 = sqrt((((_e7955 * _e7955) + (_e7960 * _e7960)) + (_e7963 * _e7963)));
                                                if (_e7969 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_16133_ = 0f;
                                                } else {
                                                    let _e7981 = (((_e7914.x * _e7948.x) + (_e7914.y * _e7948.y)) + (_e7914.z * _e7948.z));
                                                    let _e7982 = abs(_e7981);
                                                    let _e7983 = abs(_e7969);
                                                    let _e7984 = (_e7983 > _e7982);
                                                    let _e7985 = select(_e7982, _e7983, _e7984);
                                                    if (_e7985 > 0f) {
                                                        phi_16086_ = (select(_e7983, _e7982, _e7984) / _e7985);
                                                    } else {
                                                        phi_16086_ = 0f;
                                                    }
                                                    let _e7990 = phi_16086_;
                                                    let _e7991 = (_e7990 > 0.41421357f);
                                                    if _e7991 {
                                                        phi_16094_ = ((_e7990 - 1f) / (_e7990 + 1f));
                                                    } else {
                                                        phi_16094_ = _e7990;
                                                    }
                                                    let _e7996 = phi_16094_;
                                                    let _e7997 = (_e7996 * _e7996);
                                                    let _e8006 = (_e7996 + ((_e7996 * _e7997) * (-0.3333295f + (_e7997 * (0.19977711f + (_e7997 * (-0.13877685f + (_e7997 * 0.080537446f))))))));
                                                    if _e7991 {
                                                        phi_16109_ = (_e8006 + 0.7853982f);
                                                    } else {
                                                        phi_16109_ = _e8006;
                                                    }
                                                    let _e8009 = phi_16109_;
                                                    if _e7984 {
                                                        phi_16115_ = (1.5707964f - _e8009);
                                                    } else {
                                                        phi_16115_ = _e8009;
                                                    }
                                                    let _e8012 = phi_16115_;
                                                    if ((bitcast<u32>(_e7981) & 2147483648u) == 0u) {
                                                        phi_16123_ = _e8012;
                                                    } else {
                                                        phi_16123_ = (3.1415927f - _e8012);
                                                    }
                                                    let _e8018 = phi_16123_;
                                                    phi_16133_ = (((((_e185.x * _e7955) + (_e185.y * _e7960)) + (_e185.z * _e7963)) / _e7969) * bitcast<f32>(((bitcast<u32>(_e8018) & 2147483647u) | (bitcast<u32>(_e7969) & 2147483648u))));
                                                }
                                                let _e8027 = phi_16133_;
                                                let _e8033 = local_27;
                                                let _e8035 = local_28;
                                                phi_3176_ = ((abs((_e7878.member + _e8027)) * 0.5f) * (_e8033 / _e8035));
                                            }
                                            let _e8039 = phi_3176_;
                                            phi_3177_ = _e8039;
                                            phi_3178_ = _e7275;
                                        }
                                        let _e8041 = phi_3177_;
                                        let _e8043 = phi_3178_;
                                        if _e8043 {
                                            let _e8046 = local_29;
                                            phi_3186_ = ((_e8046 * _e3823.member_3) / f32(_e215));
                                        } else {
                                            phi_3186_ = f32();
                                        }
                                        let _e8051 = phi_3186_;
                                        phi_3187_ = _e8051;
                                        phi_3188_ = _e8041;
                                        phi_3189_ = _e8043;
                                    }
                                    let _e8053 = phi_3187_;
                                    let _e8055 = phi_3188_;
                                    let _e8057 = phi_3189_;
                                    phi_17306_ = _e7266;
                                    phi_3193_ = _e8053;
                                    phi_3194_ = _e8055;
                                    phi_3195_ = _e8057;
                                }
                                let _e8059 = phi_17306_;
                                let _e8061 = phi_3193_;
                                let _e8063 = phi_3194_;
                                let _e8065 = phi_3195_;
                                let _e8066 = select(_e8063, _e8061, _e8065);
                                phi_17293_ = _e8059;
                                phi_6063_ = vec3<f32>((_e3823.member_6[0] * _e8066), (_e3823.member_6[1] * _e8066), (_e3823.member_6[2] * _e8066));
                                phi_6064_ = vec3<f32>();
                                phi_6065_ = true;
                            } else {
                                let _e3861 = (_e3823.member_1 == 2u);
                                if _e3861 {
                                    let _e4952 = -(_e3823.member_2[0]);
                                    let _e4953 = -(_e3823.member_2[1]);
                                    let _e4954 = -(_e3823.member_2[2]);
                                    let _e4962 = (((_e185.x * _e4952) + (_e185.y * _e4953)) + (_e185.z * _e4954));
                                    let _e4964 = select(0f, _e4962, (_e4962 > 0f));
                                    if (_e4964 > 0f) {
                                        if (_e4962 < 0f) {
                                            phi_3245_ = -(_e207);
                                        } else {
                                            phi_3245_ = _e207;
                                        }
                                        let _e4969 = phi_3245_;
                                        let _e4973 = (_e163.member[0] + (_e185.x * _e4969));
                                        let _e4974 = (_e163.member[1] + (_e185.y * _e4969));
                                        let _e4975 = (_e163.member[2] + (_e185.z * _e4969));
                                        let _e4976 = abs(_e4952);
                                        let _e4977 = abs(_e4953);
                                        let _e4978 = abs(_e4954);
                                        let _e4979 = (_e4976 > _e4977);
                                        if _e4979 {
                                            phi_3274_ = (_e4976 > _e4978);
                                        } else {
                                            phi_3274_ = (_e4977 > _e4978);
                                        }
                                        let _e4983 = phi_3274_;
                                        let _e4984 = select(1u, 0u, _e4979);
                                        if _e4983 {
                                            let _e4985 = (_e4984 + 1u);
                                            phi_3284_ = _e4985;
                                            phi_3287_ = select(true, false, (_e4985 == 2u));
                                        } else {
                                            phi_3284_ = u32();
                                            phi_3287_ = false;
                                        }
                                        let _e4989 = phi_3284_;
                                        let _e4991 = phi_3287_;
                                        let _e4992 = select(true, false, _e4983);
                                        let _e4993 = select(_e4989, 0u, _e4992);
                                        let _e4995 = select(_e4991, true, _e4992);
                                        if _e4995 {
                                            phi_3298_ = (_e4993 + 1u);
                                        } else {
                                            phi_3298_ = 0u;
                                        }
                                        let _e4998 = phi_3298_;
                                        let _e4999 = select(_e4989, _e4993, _e4995);
                                        let _e5000 = select(_e4984, select(_e4984, 2u, _e4992), _e4995);
                                        local_16 = array<f32, 3>(_e4952, _e4953, _e4954);
                                        local_17 = array<f32, 3>(_e4973, _e4974, _e4975);
                                        let _e5003 = (_e5000 < 3u);
                                        if _e5003 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5005 = local_16[_e5000];
                                        let _e5006 = (1f / _e5005);
                                        let _e5007 = (_e4999 < 3u);
                                        if _e5007 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5009 = local_16[_e4999];
                                        let _e5010 = (_e5009 * _e5006);
                                        let _e5011 = (_e4998 < 3u);
                                        if _e5011 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5013 = local_16[_e4998];
                                        let _e5014 = (_e5013 * _e5006);
                                        if _e5007 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5016 = local_17[_e4999];
                                        if _e5011 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5018 = local_17[_e4998];
                                        if _e5003 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5020 = local_17[_e5000];
                                        if (0u < _e138) {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e5025 = nodes.member[0u].member_7[0u];
                                        let _e5029 = nodes.member[0u].member_7[1u];
                                        let _e5033 = nodes.member[0u].member_7[2u];
                                        let _e5037 = nodes.member[0u].member_7[3u];
                                        let _e5039 = abs((_e4973 - _e5025));
                                        let _e5041 = abs((_e4974 - _e5029));
                                        let _e5043 = select(_e5041, _e5039, (_e5039 > _e5041));
                                        let _e5045 = abs((_e4975 - _e5033));
                                        let _e5049 = ((select(_e5045, _e5043, (_e5043 > _e5045)) + _e5037) * 0.0000009536743f);
                                        let _e5056 = (_e5049 + (abs(_e4973) * 0.00000023841858f));
                                        let _e5057 = (_e5049 + (abs(_e4974) * 0.00000023841858f));
                                        let _e5058 = (_e5049 + (abs(_e4975) * 0.00000023841858f));
                                        let _e5059 = select(_e4977, _e4976, _e4979);
                                        let _e5061 = select(_e4978, _e5059, (_e5059 > _e4978));
                                        let _e5062 = (_e5061 * 0.000000000001f);
                                        let _e5063 = (_e4973 + _e5056);
                                        let _e5064 = (_e4974 + _e5057);
                                        let _e5065 = (_e4975 + _e5058);
                                        let _e5066 = (_e4973 - _e5056);
                                        let _e5067 = (_e4974 - _e5057);
                                        let _e5068 = (_e4975 - _e5058);
                                        if (_e4976 > _e5062) {
                                            phi_3428_ = (-1f / _e3823.member_2[0]);
                                        } else {
                                            phi_3428_ = (1000000000000f / _e5061);
                                        }
                                        let _e5073 = phi_3428_;
                                        if (_e4977 > _e5062) {
                                            phi_3436_ = (-1f / _e3823.member_2[1]);
                                        } else {
                                            phi_3436_ = (1000000000000f / _e5061);
                                        }
                                        let _e5078 = phi_3436_;
                                        if (_e4978 > _e5062) {
                                            phi_3444_ = (-1f / _e3823.member_2[2]);
                                        } else {
                                            phi_3444_ = (1000000000000f / _e5061);
                                        }
                                        let _e5083 = phi_3444_;
                                        local_15 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_17034_ = _e3796;
                                        phi_3447_ = 0u;
                                        phi_3450_ = 0u;
                                        loop {
                                            let _e5085 = phi_17034_;
                                            let _e5087 = phi_3447_;
                                            let _e5089 = phi_3450_;
                                            let _e5090 = (_e5087 & 15u);
                                            let _e5092 = (_e5087 >> bitcast<u32>(4u));
                                            if (_e5090 == 0u) {
                                                if (_e5092 < _e138) {
                                                } else {
                                                    phi_17090_ = true;
                                                    phi_12551_ = bool();
                                                    break;
                                                }
                                                let _e5722 = nodes.member[_e5092].member;
                                                let _e5731 = ((_e5722.x - _e5063) * _e5073);
                                                let _e5732 = ((_e5722.y - _e5063) * _e5073);
                                                let _e5733 = ((_e5722.z - _e5063) * _e5073);
                                                let _e5734 = ((_e5722.w - _e5063) * _e5073);
                                                let _e5737 = nodes.member[_e5092].member_3;
                                                let _e5746 = ((_e5737.x - _e5066) * _e5073);
                                                let _e5747 = ((_e5737.y - _e5066) * _e5073);
                                                let _e5748 = ((_e5737.z - _e5066) * _e5073);
                                                let _e5749 = ((_e5737.w - _e5066) * _e5073);
                                                let _e5752 = nodes.member[_e5092].member_1;
                                                let _e5761 = ((_e5752.x - _e5064) * _e5078);
                                                let _e5762 = ((_e5752.y - _e5064) * _e5078);
                                                let _e5763 = ((_e5752.z - _e5064) * _e5078);
                                                let _e5764 = ((_e5752.w - _e5064) * _e5078);
                                                let _e5767 = nodes.member[_e5092].member_4;
                                                let _e5776 = ((_e5767.x - _e5067) * _e5078);
                                                let _e5777 = ((_e5767.y - _e5067) * _e5078);
                                                let _e5778 = ((_e5767.z - _e5067) * _e5078);
                                                let _e5779 = ((_e5767.w - _e5067) * _e5078);
                                                let _e5782 = nodes.member[_e5092].member_2;
                                                let _e5791 = ((_e5782.x - _e5065) * _e5083);
                                                let _e5792 = ((_e5782.y - _e5065) * _e5083);
                                                let _e5793 = ((_e5782.z - _e5065) * _e5083);
                                                let _e5794 = ((_e5782.w - _e5065) * _e5083);
                                                let _e5797 = nodes.member[_e5092].member_5;
                                                let _e5806 = ((_e5797.x - _e5068) * _e5083);
                                                let _e5807 = ((_e5797.y - _e5068) * _e5083);
                                                let _e5808 = ((_e5797.z - _e5068) * _e5083);
                                                let _e5809 = ((_e5797.w - _e5068) * _e5083);
                                                let _e5811 = select(_e5746, _e5731, (_e5731 < _e5746));
                                                let _e5813 = select(_e5747, _e5732, (_e5732 < _e5747));
                                                let _e5815 = select(_e5748, _e5733, (_e5733 < _e5748));
                                                let _e5817 = select(_e5749, _e5734, (_e5734 < _e5749));
                                                let _e5819 = select(_e5776, _e5761, (_e5761 < _e5776));
                                                let _e5821 = select(_e5777, _e5762, (_e5762 < _e5777));
                                                let _e5823 = select(_e5778, _e5763, (_e5763 < _e5778));
                                                let _e5825 = select(_e5779, _e5764, (_e5764 < _e5779));
                                                let _e5827 = select(_e5819, _e5811, (_e5811 > _e5819));
                                                let _e5829 = select(_e5821, _e5813, (_e5813 > _e5821));
                                                let _e5831 = select(_e5823, _e5815, (_e5815 > _e5823));
                                                let _e5833 = select(_e5825, _e5817, (_e5817 > _e5825));
                                                let _e5835 = select(_e5806, _e5791, (_e5791 < _e5806));
                                                let _e5837 = select(_e5807, _e5792, (_e5792 < _e5807));
                                                let _e5839 = select(_e5808, _e5793, (_e5793 < _e5808));
                                                let _e5841 = select(_e5809, _e5794, (_e5794 < _e5809));
                                                let _e5843 = select(_e5835, _e5827, (_e5827 > _e5835));
                                                let _e5845 = select(_e5837, _e5829, (_e5829 > _e5837));
                                                let _e5847 = select(_e5839, _e5831, (_e5831 > _e5839));
                                                let _e5849 = select(_e5841, _e5833, (_e5833 > _e5841));
                                                let _e5851 = select(0f, _e5843, (_e5843 > 0f));
                                                let _e5853 = select(0f, _e5845, (_e5845 > 0f));
                                                let _e5855 = select(0f, _e5847, (_e5847 > 0f));
                                                let _e5857 = select(0f, _e5849, (_e5849 > 0f));
                                                let _e5859 = select(_e5746, _e5731, (_e5731 > _e5746));
                                                let _e5861 = select(_e5747, _e5732, (_e5732 > _e5747));
                                                let _e5863 = select(_e5748, _e5733, (_e5733 > _e5748));
                                                let _e5865 = select(_e5749, _e5734, (_e5734 > _e5749));
                                                let _e5867 = select(_e5776, _e5761, (_e5761 > _e5776));
                                                let _e5869 = select(_e5777, _e5762, (_e5762 > _e5777));
                                                let _e5871 = select(_e5778, _e5763, (_e5763 > _e5778));
                                                let _e5873 = select(_e5779, _e5764, (_e5764 > _e5779));
                                                let _e5875 = select(_e5867, _e5859, (_e5859 < _e5867));
                                                let _e5877 = select(_e5869, _e5861, (_e5861 < _e5869));
                                                let _e5879 = select(_e5871, _e5863, (_e5863 < _e5871));
                                                let _e5881 = select(_e5873, _e5865, (_e5865 < _e5873));
                                                let _e5883 = select(_e5806, _e5791, (_e5791 > _e5806));
                                                let _e5885 = select(_e5807, _e5792, (_e5792 > _e5807));
                                                let _e5887 = select(_e5808, _e5793, (_e5793 > _e5808));
                                                let _e5889 = select(_e5809, _e5794, (_e5794 > _e5809));
                                                let _e5891 = select(_e5883, _e5875, (_e5875 < _e5883));
                                                let _e5893 = select(_e5885, _e5877, (_e5877 < _e5885));
                                                let _e5895 = select(_e5887, _e5879, (_e5879 < _e5887));
                                                let _e5897 = select(_e5889, _e5881, (_e5881 < _e5889));
                                                let _e5917 = nodes.member[_e5092].member_6[0u];
                                                let _e5921 = nodes.member[_e5092].member_6[1u];
                                                let _e5925 = nodes.member[_e5092].member_6[2u];
                                                let _e5929 = nodes.member[_e5092].member_6[3u];
                                                if (select(340282350000000000000000000000000000000f, _e5857, (_e5857 <= select(340282350000000000000000000000000000000f, _e5897, (_e5897 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5089 < 64u) {
                                                    } else {
                                                        phi_17090_ = true;
                                                        phi_12551_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5089] = _e5929;
                                                    phi_3835_ = (_e5089 + 1u);
                                                } else {
                                                    phi_3835_ = _e5089;
                                                }
                                                let _e5935 = phi_3835_;
                                                if (select(340282350000000000000000000000000000000f, _e5855, (_e5855 <= select(340282350000000000000000000000000000000f, _e5895, (_e5895 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5935 < 64u) {
                                                    } else {
                                                        phi_17090_ = true;
                                                        phi_12551_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5935] = _e5925;
                                                    phi_3847_ = (_e5935 + 1u);
                                                } else {
                                                    phi_3847_ = _e5935;
                                                }
                                                let _e5941 = phi_3847_;
                                                if (select(340282350000000000000000000000000000000f, _e5853, (_e5853 <= select(340282350000000000000000000000000000000f, _e5893, (_e5893 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5941 < 64u) {
                                                    } else {
                                                        phi_17090_ = true;
                                                        phi_12551_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5941] = _e5921;
                                                    phi_3859_ = (_e5941 + 1u);
                                                } else {
                                                    phi_3859_ = _e5941;
                                                }
                                                let _e5947 = phi_3859_;
                                                if (select(340282350000000000000000000000000000000f, _e5851, (_e5851 <= select(340282350000000000000000000000000000000f, _e5891, (_e5891 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5947 < 64u) {
                                                    } else {
                                                        phi_17090_ = true;
                                                        phi_12551_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5947] = _e5917;
                                                    phi_3871_ = (_e5947 + 1u);
                                                } else {
                                                    phi_3871_ = _e5947;
                                                }
                                                let _e5953 = phi_3871_;
                                                phi_17092_ = _e5085;
                                                phi_4563_ = _e5953;
                                                phi_4564_ = true;
                                            } else {
                                                phi_3875_ = type_9(_e5092, (_e5092 + _e5090));
                                                loop {
                                                    let _e5097 = phi_3875_;
                                                    if (_e5097.member < _e5097.member_1) {
                                                        phi_3876_ = type_9((_e5097.member + 1u), _e5097.member_1);
                                                        phi_3899_ = type_9(1u, _e5097.member);
                                                    } else {
                                                        phi_3876_ = _e5097;
                                                        phi_3899_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e5110 = phi_3876_;
                                                    let _e5112 = phi_3899_;
                                                    let _e5116 = (bitcast<i32>(_e5112.member) != 0i);
                                                    if _e5116 {
                                                        let _e5117 = (_e5112.member_1 < _e141);
                                                        if _e5117 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        if _e5003 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5121 = triangles.member[_e5112.member_1].member[_e5000];
                                                        let _e5122 = (_e5121 - _e5020);
                                                        if _e5003 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5126 = triangles.member[_e5112.member_1].member_2[_e5000];
                                                        let _e5127 = (_e5126 - _e5020);
                                                        if _e5003 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5131 = triangles.member[_e5112.member_1].member_4[_e5000];
                                                        let _e5132 = (_e5131 - _e5020);
                                                        if _e5007 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5136 = triangles.member[_e5112.member_1].member[_e4999];
                                                        let _e5139 = ((_e5136 - _e5016) - (_e5010 * _e5122));
                                                        if _e5011 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5143 = triangles.member[_e5112.member_1].member[_e4998];
                                                        let _e5146 = ((_e5143 - _e5018) - (_e5014 * _e5122));
                                                        if _e5007 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5150 = triangles.member[_e5112.member_1].member_2[_e4999];
                                                        let _e5153 = ((_e5150 - _e5016) - (_e5010 * _e5127));
                                                        if _e5011 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5157 = triangles.member[_e5112.member_1].member_2[_e4998];
                                                        let _e5160 = ((_e5157 - _e5018) - (_e5014 * _e5127));
                                                        if _e5007 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5164 = triangles.member[_e5112.member_1].member_4[_e4999];
                                                        let _e5167 = ((_e5164 - _e5016) - (_e5010 * _e5132));
                                                        if _e5011 {
                                                        } else {
                                                            phi_17030_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e5171 = triangles.member[_e5112.member_1].member_4[_e4998];
                                                        let _e5174 = ((_e5171 - _e5018) - (_e5014 * _e5132));
                                                        let _e5175 = (_e5167 * _e5160);
                                                        let _e5176 = (_e5174 * _e5153);
                                                        if (_e5175 != _e5176) {
                                                            phi_4015_ = (_e5175 - _e5176);
                                                        } else {
                                                            let _e5178 = (_e5167 * 4097f);
                                                            let _e5180 = (_e5178 - (_e5178 - _e5167));
                                                            let _e5181 = (_e5160 * 4097f);
                                                            let _e5183 = (_e5181 - (_e5181 - _e5160));
                                                            let _e5184 = (_e5167 - _e5180);
                                                            let _e5185 = (_e5160 - _e5183);
                                                            let _e5194 = (_e5174 * 4097f);
                                                            let _e5196 = (_e5194 - (_e5194 - _e5174));
                                                            let _e5197 = (_e5153 * 4097f);
                                                            let _e5199 = (_e5197 - (_e5197 - _e5153));
                                                            let _e5200 = (_e5174 - _e5196);
                                                            let _e5201 = (_e5153 - _e5199);
                                                            phi_4015_ = ((((((_e5180 * _e5183) - _e5175) + (_e5180 * _e5185)) + (_e5184 * _e5183)) + (_e5184 * _e5185)) - (((((_e5196 * _e5199) - _e5176) + (_e5196 * _e5201)) + (_e5200 * _e5199)) + (_e5200 * _e5201)));
                                                        }
                                                        let _e5213 = phi_4015_;
                                                        let _e5214 = (_e5139 * _e5174);
                                                        let _e5215 = (_e5146 * _e5167);
                                                        if (_e5214 != _e5215) {
                                                            phi_4026_ = (_e5214 - _e5215);
                                                        } else {
                                                            let _e5217 = (_e5139 * 4097f);
                                                            let _e5219 = (_e5217 - (_e5217 - _e5139));
                                                            let _e5220 = (_e5174 * 4097f);
                                                            let _e5222 = (_e5220 - (_e5220 - _e5174));
                                                            let _e5223 = (_e5139 - _e5219);
                                                            let _e5224 = (_e5174 - _e5222);
                                                            let _e5233 = (_e5146 * 4097f);
                                                            let _e5235 = (_e5233 - (_e5233 - _e5146));
                                                            let _e5236 = (_e5167 * 4097f);
                                                            let _e5238 = (_e5236 - (_e5236 - _e5167));
                                                            let _e5239 = (_e5146 - _e5235);
                                                            let _e5240 = (_e5167 - _e5238);
                                                            phi_4026_ = ((((((_e5219 * _e5222) - _e5214) + (_e5219 * _e5224)) + (_e5223 * _e5222)) + (_e5223 * _e5224)) - (((((_e5235 * _e5238) - _e5215) + (_e5235 * _e5240)) + (_e5239 * _e5238)) + (_e5239 * _e5240)));
                                                        }
                                                        let _e5252 = phi_4026_;
                                                        let _e5253 = (_e5153 * _e5146);
                                                        let _e5254 = (_e5160 * _e5139);
                                                        if (_e5253 != _e5254) {
                                                            phi_4037_ = (_e5253 - _e5254);
                                                        } else {
                                                            let _e5256 = (_e5153 * 4097f);
                                                            let _e5258 = (_e5256 - (_e5256 - _e5153));
                                                            let _e5259 = (_e5146 * 4097f);
                                                            let _e5261 = (_e5259 - (_e5259 - _e5146));
                                                            let _e5262 = (_e5153 - _e5258);
                                                            let _e5263 = (_e5146 - _e5261);
                                                            let _e5272 = (_e5160 * 4097f);
                                                            let _e5274 = (_e5272 - (_e5272 - _e5160));
                                                            let _e5275 = (_e5139 * 4097f);
                                                            let _e5277 = (_e5275 - (_e5275 - _e5139));
                                                            let _e5278 = (_e5160 - _e5274);
                                                            let _e5279 = (_e5139 - _e5277);
                                                            phi_4037_ = ((((((_e5258 * _e5261) - _e5253) + (_e5258 * _e5263)) + (_e5262 * _e5261)) + (_e5262 * _e5263)) - (((((_e5274 * _e5277) - _e5254) + (_e5274 * _e5279)) + (_e5278 * _e5277)) + (_e5278 * _e5279)));
                                                        }
                                                        let _e5291 = phi_4037_;
                                                        if (_e5213 < 0f) {
                                                            phi_4055_ = f32();
                                                            phi_4056_ = true;
                                                        } else {
                                                            if (_e5252 < 0f) {
                                                                phi_4053_ = f32();
                                                                phi_4054_ = true;
                                                            } else {
                                                                let _e5294 = (_e5291 < 0f);
                                                                if _e5294 {
                                                                    phi_4052_ = f32();
                                                                } else {
                                                                    phi_4052_ = ((_e5213 + _e5252) + _e5291);
                                                                }
                                                                let _e5298 = phi_4052_;
                                                                phi_4053_ = _e5298;
                                                                phi_4054_ = _e5294;
                                                            }
                                                            let _e5300 = phi_4053_;
                                                            let _e5302 = phi_4054_;
                                                            phi_4055_ = _e5300;
                                                            phi_4056_ = _e5302;
                                                        }
                                                        let _e5304 = phi_4055_;
                                                        let _e5306 = phi_4056_;
                                                        if _e5306 {
                                                            if (_e5213 > 0f) {
                                                                phi_4077_ = f32();
                                                                phi_4078_ = true;
                                                                phi_4079_ = false;
                                                            } else {
                                                                let _e5308 = (_e5252 > 0f);
                                                                if _e5308 {
                                                                    phi_4075_ = f32();
                                                                    phi_4076_ = false;
                                                                } else {
                                                                    phi_4075_ = ((_e5213 + _e5252) + _e5291);
                                                                    phi_4076_ = select(true, false, (_e5291 > 0f));
                                                                }
                                                                let _e5314 = phi_4075_;
                                                                let _e5316 = phi_4076_;
                                                                phi_4077_ = _e5314;
                                                                phi_4078_ = _e5308;
                                                                phi_4079_ = _e5316;
                                                            }
                                                            let _e5318 = phi_4077_;
                                                            let _e5320 = phi_4078_;
                                                            let _e5322 = phi_4079_;
                                                            phi_4084_ = _e5318;
                                                            phi_4085_ = select(_e5322, false, _e5320);
                                                        } else {
                                                            phi_4084_ = _e5304;
                                                            phi_4085_ = true;
                                                        }
                                                        let _e5325 = phi_4084_;
                                                        let _e5327 = phi_4085_;
                                                        if _e5327 {
                                                            let _e5328 = (_e5325 == 0f);
                                                            if _e5328 {
                                                                phi_4173_ = array<f32, 3>();
                                                                phi_4174_ = array<f32, 3>();
                                                                phi_4175_ = false;
                                                            } else {
                                                                let _e5329 = (_e5122 * _e5006);
                                                                let _e5330 = (_e5127 * _e5006);
                                                                let _e5331 = (_e5132 * _e5006);
                                                                let _e5334 = (1f / ((_e5213 + _e5252) + _e5291));
                                                                let _e5335 = (_e5252 * _e5334);
                                                                let _e5336 = (_e5291 * _e5334);
                                                                let _e5342 = ((((_e5213 * _e5334) * _e5329) + (_e5335 * _e5330)) + (_e5336 * _e5331));
                                                                let _e5343 = abs(_e5139);
                                                                let _e5344 = abs(_e5153);
                                                                let _e5346 = select(_e5344, _e5343, (_e5343 > _e5344));
                                                                let _e5347 = abs(_e5167);
                                                                let _e5350 = abs(_e5146);
                                                                let _e5351 = abs(_e5160);
                                                                let _e5353 = select(_e5351, _e5350, (_e5350 > _e5351));
                                                                let _e5354 = abs(_e5174);
                                                                let _e5358 = abs(_e5329);
                                                                let _e5359 = abs(_e5330);
                                                                let _e5361 = select(_e5359, _e5358, (_e5358 > _e5359));
                                                                let _e5362 = abs(_e5331);
                                                                let _e5369 = (((select(_e5347, _e5346, (_e5346 > _e5347)) * select(_e5354, _e5353, (_e5353 > _e5354))) * select(_e5362, _e5361, (_e5361 > _e5362))) <= (abs((_e5325 * _e5342)) * 256f));
                                                                if _e5369 {
                                                                    phi_4171_ = array<f32, 3>(_e5342, _e5335, _e5336);
                                                                    phi_4172_ = array<f32, 3>();
                                                                } else {
                                                                    let _e5371 = (_e5167 * 4097f);
                                                                    let _e5373 = (_e5371 - (_e5371 - _e5167));
                                                                    let _e5374 = (_e5160 * 4097f);
                                                                    let _e5376 = (_e5374 - (_e5374 - _e5160));
                                                                    let _e5377 = (_e5167 - _e5373);
                                                                    let _e5378 = (_e5160 - _e5376);
                                                                    let _e5387 = (_e5174 * 4097f);
                                                                    let _e5389 = (_e5387 - (_e5387 - _e5174));
                                                                    let _e5390 = (_e5153 * 4097f);
                                                                    let _e5392 = (_e5390 - (_e5390 - _e5153));
                                                                    let _e5393 = (_e5174 - _e5389);
                                                                    let _e5394 = (_e5153 - _e5392);
                                                                    let _e5404 = ((_e5175 - _e5176) + ((((((_e5373 * _e5376) - _e5175) + (_e5373 * _e5378)) + (_e5377 * _e5376)) + (_e5377 * _e5378)) - (((((_e5389 * _e5392) - _e5176) + (_e5389 * _e5394)) + (_e5393 * _e5392)) + (_e5393 * _e5394))));
                                                                    let _e5406 = (_e5139 * 4097f);
                                                                    let _e5408 = (_e5406 - (_e5406 - _e5139));
                                                                    let _e5409 = (_e5139 - _e5408);
                                                                    let _e5418 = (_e5146 * 4097f);
                                                                    let _e5420 = (_e5418 - (_e5418 - _e5146));
                                                                    let _e5421 = (_e5146 - _e5420);
                                                                    let _e5431 = ((_e5214 - _e5215) + ((((((_e5408 * _e5389) - _e5214) + (_e5408 * _e5393)) + (_e5409 * _e5389)) + (_e5409 * _e5393)) - (((((_e5420 * _e5373) - _e5215) + (_e5420 * _e5377)) + (_e5421 * _e5373)) + (_e5421 * _e5377))));
                                                                    let _e5450 = ((_e5253 - _e5254) + ((((((_e5392 * _e5420) - _e5253) + (_e5392 * _e5421)) + (_e5394 * _e5420)) + (_e5394 * _e5421)) - (((((_e5376 * _e5408) - _e5254) + (_e5376 * _e5409)) + (_e5378 * _e5408)) + (_e5378 * _e5409))));
                                                                    let _e5453 = (1f / ((_e5404 + _e5431) + _e5450));
                                                                    let _e5454 = (_e5431 * _e5453);
                                                                    let _e5455 = (_e5450 * _e5453);
                                                                    phi_4171_ = array<f32, 3>();
                                                                    phi_4172_ = array<f32, 3>(((((_e5404 * _e5453) * _e5329) + (_e5454 * _e5330)) + (_e5455 * _e5331)), _e5454, _e5455);
                                                                }
                                                                let _e5465 = phi_4171_;
                                                                let _e5467 = phi_4172_;
                                                                phi_4173_ = _e5465;
                                                                phi_4174_ = _e5467;
                                                                phi_4175_ = _e5369;
                                                            }
                                                            let _e5469 = phi_4173_;
                                                            let _e5471 = phi_4174_;
                                                            let _e5473 = phi_4175_;
                                                            phi_4176_ = _e5469;
                                                            phi_4177_ = _e5471;
                                                            phi_4178_ = _e5328;
                                                            phi_4179_ = _e5473;
                                                        } else {
                                                            phi_4176_ = array<f32, 3>();
                                                            phi_4177_ = array<f32, 3>();
                                                            phi_4178_ = true;
                                                            phi_4179_ = false;
                                                        }
                                                        let _e5475 = phi_4176_;
                                                        let _e5477 = phi_4177_;
                                                        let _e5479 = phi_4178_;
                                                        let _e5481 = phi_4179_;
                                                        if _e5479 {
                                                            phi_4184_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_4184_ = _e5475;
                                                        }
                                                        let _e5483 = phi_4184_;
                                                        if select(_e5481, true, _e5479) {
                                                            phi_4189_ = _e5483;
                                                        } else {
                                                            phi_4189_ = _e5477;
                                                        }
                                                        let _e5486 = phi_4189_;
                                                        let _e5490 = (_e5486[0] >= 0f);
                                                        if _e5490 {
                                                            let _e5491 = (_e5486[0] < 340282350000000000000000000000000000000f);
                                                            if _e5491 {
                                                                if _e5490 {
                                                                    if _e5117 {
                                                                    } else {
                                                                        phi_17030_ = true;
                                                                        phi_12550_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e5494 = triangles.member[_e5112.member_1].member_3;
                                                                    if ((_e5494 & 1u) == 0u) {
                                                                        phi_4521_ = true;
                                                                    } else {
                                                                        if _e5117 {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5499 = triangles.member[_e5112.member_1].member_1;
                                                                        let _e5500 = (_e5499 * 12u);
                                                                        if ((256u + _e5500) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 257u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 258u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5507 = (_e5500 + 259u);
                                                                        if (_e5507 < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5510 = surfaces.member[_e5507];
                                                                        if ((_e5500 + 260u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 261u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 262u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5517 = (_e5500 + 263u);
                                                                        if (_e5517 < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5520 = surfaces.member[_e5517];
                                                                        let _e5521 = (_e5500 + 264u);
                                                                        if (_e5521 < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5524 = surfaces.member[_e5521];
                                                                        let _e5525 = bitcast<f32>(_e5524);
                                                                        let _e5526 = (_e5500 + 265u);
                                                                        if (_e5526 < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5529 = surfaces.member[_e5526];
                                                                        let _e5530 = bitcast<f32>(_e5529);
                                                                        if ((_e5500 + 266u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 267u) < _e147) {
                                                                        } else {
                                                                            phi_17030_ = true;
                                                                            phi_12550_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e5510 == 4294967295u) {
                                                                            phi_4516_ = (_e5525 < _e5530);
                                                                        } else {
                                                                            if (_e5112.member_1 < _e144) {
                                                                            } else {
                                                                                phi_17030_ = true;
                                                                                phi_12550_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5538 = ((1f - _e5486[1]) - _e5486[2]);
                                                                            let _e5542 = attributes.member[_e5112.member_1].member[0u];
                                                                            let _e5547 = attributes.member[_e5112.member_1].member[2u];
                                                                            let _e5553 = attributes.member[_e5112.member_1].member[4u];
                                                                            let _e5555 = (((_e5542 * _e5538) + (_e5547 * _e5486[1])) + (_e5553 * _e5486[2]));
                                                                            let _e5559 = attributes.member[_e5112.member_1].member[1u];
                                                                            let _e5564 = attributes.member[_e5112.member_1].member[3u];
                                                                            let _e5570 = attributes.member[_e5112.member_1].member[5u];
                                                                            let _e5572 = (((_e5559 * _e5538) + (_e5564 * _e5486[1])) + (_e5570 * _e5486[2]));
                                                                            let _e5573 = (_e5520 & 65535u);
                                                                            let _e5575 = (_e5520 >> bitcast<u32>(16i));
                                                                            let _e5577 = (_e5555 - floor(_e5555));
                                                                            let _e5582 = ((select(0f, _e5577, (_e5577 <= 1f)) * f32(_e5573)) - 0.5f);
                                                                            let _e5583 = floor(_e5582);
                                                                            let _e5584 = (_e5582 - _e5583);
                                                                            let _e5585 = (_e5573 - 1u);
                                                                            if (_e5583 < 0f) {
                                                                                phi_4399_ = _e5585;
                                                                            } else {
                                                                                let _e5591 = select(select(u32(_e5583), 0u, (_e5583 < 0f)), 4294967295u, (_e5583 > 4294967000f));
                                                                                phi_4399_ = select(_e5591, _e5585, (_e5585 < _e5591));
                                                                            }
                                                                            let _e5595 = phi_4399_;
                                                                            if (_e5595 == _e5585) {
                                                                                phi_4405_ = 0u;
                                                                            } else {
                                                                                phi_4405_ = (_e5595 + 1u);
                                                                            }
                                                                            let _e5599 = phi_4405_;
                                                                            let _e5601 = (_e5572 - floor(_e5572));
                                                                            let _e5606 = ((select(0f, _e5601, (_e5601 <= 1f)) * f32(_e5575)) - 0.5f);
                                                                            let _e5607 = floor(_e5606);
                                                                            let _e5608 = (_e5606 - _e5607);
                                                                            let _e5609 = (_e5575 - 1u);
                                                                            if (_e5607 < 0f) {
                                                                                phi_4435_ = _e5609;
                                                                            } else {
                                                                                let _e5615 = select(select(u32(_e5607), 0u, (_e5607 < 0f)), 4294967295u, (_e5607 > 4294967000f));
                                                                                phi_4435_ = select(_e5615, _e5609, (_e5609 < _e5615));
                                                                            }
                                                                            let _e5619 = phi_4435_;
                                                                            if (_e5619 == _e5609) {
                                                                                phi_4441_ = 0u;
                                                                            } else {
                                                                                phi_4441_ = (_e5619 + 1u);
                                                                            }
                                                                            let _e5623 = phi_4441_;
                                                                            let _e5625 = (_e5510 + (_e5619 * _e5573));
                                                                            let _e5627 = (_e5510 + (_e5623 * _e5573));
                                                                            let _e5628 = (_e5625 + _e5595);
                                                                            let _e5629 = (_e5625 + _e5599);
                                                                            let _e5630 = (_e5627 + _e5595);
                                                                            let _e5631 = (_e5627 + _e5599);
                                                                            if (_e5628 < _e147) {
                                                                            } else {
                                                                                phi_17030_ = true;
                                                                                phi_12550_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5634 = surfaces.member[_e5628];
                                                                            if (_e5629 < _e147) {
                                                                            } else {
                                                                                phi_17030_ = true;
                                                                                phi_12550_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5637 = surfaces.member[_e5629];
                                                                            if (_e5630 < _e147) {
                                                                            } else {
                                                                                phi_17030_ = true;
                                                                                phi_12550_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5640 = surfaces.member[_e5630];
                                                                            if (_e5631 < _e147) {
                                                                            } else {
                                                                                phi_17030_ = true;
                                                                                phi_12550_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5643 = surfaces.member[_e5631];
                                                                            let _e5660 = (1f - _e5584);
                                                                            phi_4516_ = ((_e5525 * (((((f32((_e5634 >> bitcast<u32>(24i))) * 0.003921569f) * _e5660) + ((f32((_e5637 >> bitcast<u32>(24i))) * 0.003921569f) * _e5584)) * (1f - _e5608)) + ((((f32((_e5640 >> bitcast<u32>(24i))) * 0.003921569f) * _e5660) + ((f32((_e5643 >> bitcast<u32>(24i))) * 0.003921569f) * _e5584)) * _e5608))) < _e5530);
                                                                        }
                                                                        let _e5675 = phi_4516_;
                                                                        phi_4521_ = select(true, false, _e5675);
                                                                    }
                                                                    let _e5678 = phi_4521_;
                                                                    if _e5678 {
                                                                        phi_4526_ = type_47(_e5486[0], _e5112.member_1, _e5486[1], _e5486[2]);
                                                                    } else {
                                                                        phi_4526_ = type_47();
                                                                    }
                                                                    let _e5681 = phi_4526_;
                                                                    phi_4528_ = _e5681;
                                                                    phi_4530_ = select(true, false, _e5678);
                                                                } else {
                                                                    phi_4528_ = type_47();
                                                                    phi_4530_ = false;
                                                                }
                                                                let _e5684 = phi_4528_;
                                                                let _e5686 = phi_4530_;
                                                                phi_4531_ = _e5684;
                                                                phi_4533_ = select(true, false, _e5490);
                                                                phi_4534_ = _e5686;
                                                            } else {
                                                                phi_4531_ = type_47();
                                                                phi_4533_ = false;
                                                                phi_4534_ = false;
                                                            }
                                                            let _e5689 = phi_4531_;
                                                            let _e5691 = phi_4533_;
                                                            let _e5693 = phi_4534_;
                                                            phi_4535_ = _e5689;
                                                            phi_4536_ = select(true, false, _e5491);
                                                            phi_4537_ = _e5691;
                                                            phi_4538_ = _e5693;
                                                        } else {
                                                            phi_4535_ = type_47();
                                                            phi_4536_ = true;
                                                            phi_4537_ = false;
                                                            phi_4538_ = false;
                                                        }
                                                        let _e5696 = phi_4535_;
                                                        let _e5698 = phi_4536_;
                                                        let _e5700 = phi_4537_;
                                                        let _e5702 = phi_4538_;
                                                        if select(select(_e5702, false, _e5698), true, select(_e5700, true, _e5698)) {
                                                            phi_4551_ = type_47(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_4551_ = _e5696;
                                                        }
                                                        let _e5707 = phi_4551_;
                                                        phi_4558_ = select(true, false, (_e5707.member_1 != 4294967295u));
                                                    } else {
                                                        phi_4558_ = false;
                                                    }
                                                    let _e5712 = phi_4558_;
                                                    continue;
                                                    continuing {
                                                        phi_3875_ = _e5110;
                                                        phi_17030_ = _e5085;
                                                        phi_12550_ = select(true, false, _e5116);
                                                        break if !(_e5712);
                                                    }
                                                }
                                                let _e5716 = phi_17030_;
                                                let _e5718 = phi_12550_;
                                                phi_17090_ = _e5716;
                                                phi_12551_ = bool();
                                                if _e5716 {
                                                    break;
                                                }
                                                phi_17092_ = _e5716;
                                                phi_4563_ = _e5089;
                                                phi_4564_ = _e5718;
                                            }
                                            let _e5955 = phi_17092_;
                                            let _e5957 = phi_4563_;
                                            let _e5959 = phi_4564_;
                                            if _e5959 {
                                                let _e5960 = (_e5957 == 0u);
                                                if _e5960 {
                                                    phi_4580_ = u32();
                                                    phi_4581_ = u32();
                                                } else {
                                                    let _e5961 = (_e5957 - 1u);
                                                    if (_e5961 < 64u) {
                                                    } else {
                                                        phi_17090_ = true;
                                                        phi_12551_ = bool();
                                                        break;
                                                    }
                                                    let _e5964 = local_15[_e5961];
                                                    phi_4580_ = _e5964;
                                                    phi_4581_ = _e5961;
                                                }
                                                let _e5966 = phi_4580_;
                                                let _e5968 = phi_4581_;
                                                phi_3448_ = _e5966;
                                                phi_3451_ = _e5968;
                                                phi_4583_ = select(true, false, _e5960);
                                                phi_4584_ = _e5960;
                                            } else {
                                                phi_3448_ = u32();
                                                phi_3451_ = u32();
                                                phi_4583_ = false;
                                                phi_4584_ = false;
                                            }
                                            let _e5971 = phi_3448_;
                                            let _e5973 = phi_3451_;
                                            let _e5975 = phi_4583_;
                                            let _e5977 = phi_4584_;
                                            continue;
                                            continuing {
                                                phi_17034_ = _e5955;
                                                phi_3447_ = _e5971;
                                                phi_3450_ = _e5973;
                                                phi_17090_ = _e5955;
                                                phi_12551_ = _e5977;
                                                break if !(_e5975);
                                            }
                                        }
                                        let _e5980 = phi_17090_;
                                        let _e5982 = phi_12551_;
                                        phi_17290_ = _e5980;
                                        if _e5980 {
                                            break;
                                        }
                                        let _e5984 = select(false, true, select(true, false, _e5982));
                                        if _e5984 {
                                            phi_4600_ = vec3<f32>();
                                        } else {
                                            phi_4600_ = vec3<f32>((_e3823.member_6[0] * _e4964), (_e3823.member_6[1] * _e4964), (_e3823.member_6[2] * _e4964));
                                        }
                                        let _e5990 = phi_4600_;
                                        phi_17301_ = _e5980;
                                        phi_4601_ = _e5990;
                                        phi_4602_ = _e5984;
                                    } else {
                                        phi_17301_ = _e3796;
                                        phi_4601_ = vec3<f32>();
                                        phi_4602_ = true;
                                    }
                                    let _e5992 = phi_17301_;
                                    let _e5994 = phi_4601_;
                                    let _e5996 = phi_4602_;
                                    phi_17294_ = _e5992;
                                    phi_6061_ = select(_e5994, vec3<f32>(0f, 0f, 0f), vec3(_e5996));
                                    phi_6062_ = vec3<f32>();
                                } else {
                                    let _e3862 = (_e3823.member[0] - _e163.member[0]);
                                    let _e3863 = (_e3823.member[1] - _e163.member[1]);
                                    let _e3864 = (_e3823.member[2] - _e163.member[2]);
                                    let _e3870 = sqrt((((_e3862 * _e3862) + (_e3863 * _e3863)) + (_e3864 * _e3864)));
                                    let _e3878 = (((_e185.x * _e3862) + (_e185.y * _e3863)) + (_e185.z * _e3864));
                                    let _e3882 = ((_e3870 * _e3870) * _e3870);
                                    let _e3885 = (select(0f, _e3878, (_e3878 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e3882, (_e3882 > 0.000000000000000000000000000000000000011754944f)));
                                    if (_e3823.member_1 == 1u) {
                                        let _e3901 = (_e3823.member_4[0] - _e3823.member_4[1]);
                                        let _e3904 = (((-((((_e3862 * _e3823.member_2[0]) + (_e3863 * _e3823.member_2[1])) + (_e3864 * _e3823.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e3870, (_e3870 > 0.000000000000000000000000000000000000011754944f))) - _e3823.member_4[1]) / select(0.001f, _e3901, (_e3901 > 0.001f)));
                                        let _e3906 = select(0f, _e3904, (_e3904 > 0f));
                                        let _e3908 = select(1f, _e3906, (_e3906 < 1f));
                                        phi_4676_ = (_e3885 * (_e3908 * _e3908));
                                    } else {
                                        phi_4676_ = _e3885;
                                    }
                                    let _e3912 = phi_4676_;
                                    if (_e3912 > 0f) {
                                        if (_e3878 < 0f) {
                                            phi_4697_ = -(_e207);
                                        } else {
                                            phi_4697_ = _e207;
                                        }
                                        let _e3917 = phi_4697_;
                                        let _e3921 = (_e163.member[0] + (_e185.x * _e3917));
                                        let _e3922 = (_e163.member[1] + (_e185.y * _e3917));
                                        let _e3923 = (_e163.member[2] + (_e185.z * _e3917));
                                        let _e3924 = (_e3823.member[0] - _e3921);
                                        let _e3925 = (_e3823.member[1] - _e3922);
                                        let _e3926 = (_e3823.member[2] - _e3923);
                                        let _e3927 = abs(_e3924);
                                        let _e3928 = abs(_e3925);
                                        let _e3929 = abs(_e3926);
                                        let _e3930 = (_e3927 > _e3928);
                                        if _e3930 {
                                            phi_4726_ = (_e3927 > _e3929);
                                        } else {
                                            phi_4726_ = (_e3928 > _e3929);
                                        }
                                        let _e3934 = phi_4726_;
                                        let _e3935 = select(1u, 0u, _e3930);
                                        if _e3934 {
                                            let _e3936 = (_e3935 + 1u);
                                            phi_4736_ = _e3936;
                                            phi_4739_ = select(true, false, (_e3936 == 2u));
                                        } else {
                                            phi_4736_ = u32();
                                            phi_4739_ = false;
                                        }
                                        let _e3940 = phi_4736_;
                                        let _e3942 = phi_4739_;
                                        let _e3943 = select(true, false, _e3934);
                                        let _e3944 = select(_e3940, 0u, _e3943);
                                        let _e3946 = select(_e3942, true, _e3943);
                                        if _e3946 {
                                            phi_4750_ = (_e3944 + 1u);
                                        } else {
                                            phi_4750_ = 0u;
                                        }
                                        let _e3949 = phi_4750_;
                                        let _e3950 = select(_e3940, _e3944, _e3946);
                                        let _e3951 = select(_e3935, select(_e3935, 2u, _e3943), _e3946);
                                        local_13 = array<f32, 3>(_e3924, _e3925, _e3926);
                                        local_14 = array<f32, 3>(_e3921, _e3922, _e3923);
                                        let _e3954 = (_e3951 < 3u);
                                        if _e3954 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3956 = local_13[_e3951];
                                        let _e3957 = (1f / _e3956);
                                        let _e3958 = (_e3950 < 3u);
                                        if _e3958 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3960 = local_13[_e3950];
                                        let _e3961 = (_e3960 * _e3957);
                                        let _e3962 = (_e3949 < 3u);
                                        if _e3962 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3964 = local_13[_e3949];
                                        let _e3965 = (_e3964 * _e3957);
                                        if _e3958 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3967 = local_14[_e3950];
                                        if _e3962 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3969 = local_14[_e3949];
                                        if _e3954 {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3971 = local_14[_e3951];
                                        if (0u < _e138) {
                                        } else {
                                            phi_17290_ = true;
                                            break;
                                        }
                                        let _e3976 = nodes.member[0u].member_7[0u];
                                        let _e3980 = nodes.member[0u].member_7[1u];
                                        let _e3984 = nodes.member[0u].member_7[2u];
                                        let _e3988 = nodes.member[0u].member_7[3u];
                                        let _e3990 = abs((_e3921 - _e3976));
                                        let _e3992 = abs((_e3922 - _e3980));
                                        let _e3994 = select(_e3992, _e3990, (_e3990 > _e3992));
                                        let _e3996 = abs((_e3923 - _e3984));
                                        let _e4000 = ((select(_e3996, _e3994, (_e3994 > _e3996)) + _e3988) * 0.0000009536743f);
                                        let _e4007 = (_e4000 + (abs(_e3921) * 0.00000023841858f));
                                        let _e4008 = (_e4000 + (abs(_e3922) * 0.00000023841858f));
                                        let _e4009 = (_e4000 + (abs(_e3923) * 0.00000023841858f));
                                        let _e4010 = select(_e3928, _e3927, _e3930);
                                        let _e4012 = select(_e3929, _e4010, (_e4010 > _e3929));
                                        let _e4013 = (_e4012 * 0.000000000001f);
                                        let _e4014 = (_e3921 + _e4007);
                                        let _e4015 = (_e3922 + _e4008);
                                        let _e4016 = (_e3923 + _e4009);
                                        let _e4017 = (_e3921 - _e4007);
                                        let _e4018 = (_e3922 - _e4008);
                                        let _e4019 = (_e3923 - _e4009);
                                        if (_e3927 > _e4013) {
                                            phi_4880_ = (1f / _e3924);
                                        } else {
                                            phi_4880_ = (1000000000000f / _e4012);
                                        }
                                        let _e4024 = phi_4880_;
                                        if (_e3928 > _e4013) {
                                            phi_4888_ = (1f / _e3925);
                                        } else {
                                            phi_4888_ = (1000000000000f / _e4012);
                                        }
                                        let _e4029 = phi_4888_;
                                        if (_e3929 > _e4013) {
                                            phi_4896_ = (1f / _e3926);
                                        } else {
                                            phi_4896_ = (1000000000000f / _e4012);
                                        }
                                        let _e4034 = phi_4896_;
                                        local_12 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_16906_ = _e3796;
                                        phi_4899_ = 0u;
                                        phi_4902_ = 0u;
                                        loop {
                                            let _e4036 = phi_16906_;
                                            let _e4038 = phi_4899_;
                                            let _e4040 = phi_4902_;
                                            let _e4041 = (_e4038 & 15u);
                                            let _e4043 = (_e4038 >> bitcast<u32>(4u));
                                            if (_e4041 == 0u) {
                                                if (_e4043 < _e138) {
                                                } else {
                                                    phi_16970_ = true;
                                                    phi_12549_ = bool();
                                                    break;
                                                }
                                                let _e4673 = nodes.member[_e4043].member;
                                                let _e4682 = ((_e4673.x - _e4014) * _e4024);
                                                let _e4683 = ((_e4673.y - _e4014) * _e4024);
                                                let _e4684 = ((_e4673.z - _e4014) * _e4024);
                                                let _e4685 = ((_e4673.w - _e4014) * _e4024);
                                                let _e4688 = nodes.member[_e4043].member_3;
                                                let _e4697 = ((_e4688.x - _e4017) * _e4024);
                                                let _e4698 = ((_e4688.y - _e4017) * _e4024);
                                                let _e4699 = ((_e4688.z - _e4017) * _e4024);
                                                let _e4700 = ((_e4688.w - _e4017) * _e4024);
                                                let _e4703 = nodes.member[_e4043].member_1;
                                                let _e4712 = ((_e4703.x - _e4015) * _e4029);
                                                let _e4713 = ((_e4703.y - _e4015) * _e4029);
                                                let _e4714 = ((_e4703.z - _e4015) * _e4029);
                                                let _e4715 = ((_e4703.w - _e4015) * _e4029);
                                                let _e4718 = nodes.member[_e4043].member_4;
                                                let _e4727 = ((_e4718.x - _e4018) * _e4029);
                                                let _e4728 = ((_e4718.y - _e4018) * _e4029);
                                                let _e4729 = ((_e4718.z - _e4018) * _e4029);
                                                let _e4730 = ((_e4718.w - _e4018) * _e4029);
                                                let _e4733 = nodes.member[_e4043].member_2;
                                                let _e4742 = ((_e4733.x - _e4016) * _e4034);
                                                let _e4743 = ((_e4733.y - _e4016) * _e4034);
                                                let _e4744 = ((_e4733.z - _e4016) * _e4034);
                                                let _e4745 = ((_e4733.w - _e4016) * _e4034);
                                                let _e4748 = nodes.member[_e4043].member_5;
                                                let _e4757 = ((_e4748.x - _e4019) * _e4034);
                                                let _e4758 = ((_e4748.y - _e4019) * _e4034);
                                                let _e4759 = ((_e4748.z - _e4019) * _e4034);
                                                let _e4760 = ((_e4748.w - _e4019) * _e4034);
                                                let _e4762 = select(_e4697, _e4682, (_e4682 < _e4697));
                                                let _e4764 = select(_e4698, _e4683, (_e4683 < _e4698));
                                                let _e4766 = select(_e4699, _e4684, (_e4684 < _e4699));
                                                let _e4768 = select(_e4700, _e4685, (_e4685 < _e4700));
                                                let _e4770 = select(_e4727, _e4712, (_e4712 < _e4727));
                                                let _e4772 = select(_e4728, _e4713, (_e4713 < _e4728));
                                                let _e4774 = select(_e4729, _e4714, (_e4714 < _e4729));
                                                let _e4776 = select(_e4730, _e4715, (_e4715 < _e4730));
                                                let _e4778 = select(_e4770, _e4762, (_e4762 > _e4770));
                                                let _e4780 = select(_e4772, _e4764, (_e4764 > _e4772));
                                                let _e4782 = select(_e4774, _e4766, (_e4766 > _e4774));
                                                let _e4784 = select(_e4776, _e4768, (_e4768 > _e4776));
                                                let _e4786 = select(_e4757, _e4742, (_e4742 < _e4757));
                                                let _e4788 = select(_e4758, _e4743, (_e4743 < _e4758));
                                                let _e4790 = select(_e4759, _e4744, (_e4744 < _e4759));
                                                let _e4792 = select(_e4760, _e4745, (_e4745 < _e4760));
                                                let _e4794 = select(_e4786, _e4778, (_e4778 > _e4786));
                                                let _e4796 = select(_e4788, _e4780, (_e4780 > _e4788));
                                                let _e4798 = select(_e4790, _e4782, (_e4782 > _e4790));
                                                let _e4800 = select(_e4792, _e4784, (_e4784 > _e4792));
                                                let _e4802 = select(0f, _e4794, (_e4794 > 0f));
                                                let _e4804 = select(0f, _e4796, (_e4796 > 0f));
                                                let _e4806 = select(0f, _e4798, (_e4798 > 0f));
                                                let _e4808 = select(0f, _e4800, (_e4800 > 0f));
                                                let _e4810 = select(_e4697, _e4682, (_e4682 > _e4697));
                                                let _e4812 = select(_e4698, _e4683, (_e4683 > _e4698));
                                                let _e4814 = select(_e4699, _e4684, (_e4684 > _e4699));
                                                let _e4816 = select(_e4700, _e4685, (_e4685 > _e4700));
                                                let _e4818 = select(_e4727, _e4712, (_e4712 > _e4727));
                                                let _e4820 = select(_e4728, _e4713, (_e4713 > _e4728));
                                                let _e4822 = select(_e4729, _e4714, (_e4714 > _e4729));
                                                let _e4824 = select(_e4730, _e4715, (_e4715 > _e4730));
                                                let _e4826 = select(_e4818, _e4810, (_e4810 < _e4818));
                                                let _e4828 = select(_e4820, _e4812, (_e4812 < _e4820));
                                                let _e4830 = select(_e4822, _e4814, (_e4814 < _e4822));
                                                let _e4832 = select(_e4824, _e4816, (_e4816 < _e4824));
                                                let _e4834 = select(_e4757, _e4742, (_e4742 > _e4757));
                                                let _e4836 = select(_e4758, _e4743, (_e4743 > _e4758));
                                                let _e4838 = select(_e4759, _e4744, (_e4744 > _e4759));
                                                let _e4840 = select(_e4760, _e4745, (_e4745 > _e4760));
                                                let _e4842 = select(_e4834, _e4826, (_e4826 < _e4834));
                                                let _e4844 = select(_e4836, _e4828, (_e4828 < _e4836));
                                                let _e4846 = select(_e4838, _e4830, (_e4830 < _e4838));
                                                let _e4848 = select(_e4840, _e4832, (_e4832 < _e4840));
                                                let _e4868 = nodes.member[_e4043].member_6[0u];
                                                let _e4872 = nodes.member[_e4043].member_6[1u];
                                                let _e4876 = nodes.member[_e4043].member_6[2u];
                                                let _e4880 = nodes.member[_e4043].member_6[3u];
                                                if (select(340282350000000000000000000000000000000f, _e4808, (_e4808 <= select(0.9999995f, _e4848, (_e4848 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4040 < 64u) {
                                                    } else {
                                                        phi_16970_ = true;
                                                        phi_12549_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4040] = _e4880;
                                                    phi_5287_ = (_e4040 + 1u);
                                                } else {
                                                    phi_5287_ = _e4040;
                                                }
                                                let _e4886 = phi_5287_;
                                                if (select(340282350000000000000000000000000000000f, _e4806, (_e4806 <= select(0.9999995f, _e4846, (_e4846 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4886 < 64u) {
                                                    } else {
                                                        phi_16970_ = true;
                                                        phi_12549_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4886] = _e4876;
                                                    phi_5299_ = (_e4886 + 1u);
                                                } else {
                                                    phi_5299_ = _e4886;
                                                }
                                                let _e4892 = phi_5299_;
                                                if (select(340282350000000000000000000000000000000f, _e4804, (_e4804 <= select(0.9999995f, _e4844, (_e4844 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4892 < 64u) {
                                                    } else {
                                                        phi_16970_ = true;
                                                        phi_12549_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4892] = _e4872;
                                                    phi_5311_ = (_e4892 + 1u);
                                                } else {
                                                    phi_5311_ = _e4892;
                                                }
                                                let _e4898 = phi_5311_;
                                                if (select(340282350000000000000000000000000000000f, _e4802, (_e4802 <= select(0.9999995f, _e4842, (_e4842 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4898 < 64u) {
                                                    } else {
                                                        phi_16970_ = true;
                                                        phi_12549_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4898] = _e4868;
                                                    phi_5323_ = (_e4898 + 1u);
                                                } else {
                                                    phi_5323_ = _e4898;
                                                }
                                                let _e4904 = phi_5323_;
                                                phi_16972_ = _e4036;
                                                phi_6015_ = _e4904;
                                                phi_6016_ = true;
                                            } else {
                                                phi_5327_ = type_9(_e4043, (_e4043 + _e4041));
                                                loop {
                                                    let _e4048 = phi_5327_;
                                                    if (_e4048.member < _e4048.member_1) {
                                                        phi_5328_ = type_9((_e4048.member + 1u), _e4048.member_1);
                                                        phi_5351_ = type_9(1u, _e4048.member);
                                                    } else {
                                                        phi_5328_ = _e4048;
                                                        phi_5351_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e4061 = phi_5328_;
                                                    let _e4063 = phi_5351_;
                                                    let _e4067 = (bitcast<i32>(_e4063.member) != 0i);
                                                    if _e4067 {
                                                        let _e4068 = (_e4063.member_1 < _e141);
                                                        if _e4068 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        if _e3954 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4072 = triangles.member[_e4063.member_1].member[_e3951];
                                                        let _e4073 = (_e4072 - _e3971);
                                                        if _e3954 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4077 = triangles.member[_e4063.member_1].member_2[_e3951];
                                                        let _e4078 = (_e4077 - _e3971);
                                                        if _e3954 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4082 = triangles.member[_e4063.member_1].member_4[_e3951];
                                                        let _e4083 = (_e4082 - _e3971);
                                                        if _e3958 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4087 = triangles.member[_e4063.member_1].member[_e3950];
                                                        let _e4090 = ((_e4087 - _e3967) - (_e3961 * _e4073));
                                                        if _e3962 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4094 = triangles.member[_e4063.member_1].member[_e3949];
                                                        let _e4097 = ((_e4094 - _e3969) - (_e3965 * _e4073));
                                                        if _e3958 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4101 = triangles.member[_e4063.member_1].member_2[_e3950];
                                                        let _e4104 = ((_e4101 - _e3967) - (_e3961 * _e4078));
                                                        if _e3962 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4108 = triangles.member[_e4063.member_1].member_2[_e3949];
                                                        let _e4111 = ((_e4108 - _e3969) - (_e3965 * _e4078));
                                                        if _e3958 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4115 = triangles.member[_e4063.member_1].member_4[_e3950];
                                                        let _e4118 = ((_e4115 - _e3967) - (_e3961 * _e4083));
                                                        if _e3962 {
                                                        } else {
                                                            phi_16902_ = true;
                                                            phi_12548_ = bool();
                                                            break;
                                                        }
                                                        let _e4122 = triangles.member[_e4063.member_1].member_4[_e3949];
                                                        let _e4125 = ((_e4122 - _e3969) - (_e3965 * _e4083));
                                                        let _e4126 = (_e4118 * _e4111);
                                                        let _e4127 = (_e4125 * _e4104);
                                                        if (_e4126 != _e4127) {
                                                            phi_5467_ = (_e4126 - _e4127);
                                                        } else {
                                                            let _e4129 = (_e4118 * 4097f);
                                                            let _e4131 = (_e4129 - (_e4129 - _e4118));
                                                            let _e4132 = (_e4111 * 4097f);
                                                            let _e4134 = (_e4132 - (_e4132 - _e4111));
                                                            let _e4135 = (_e4118 - _e4131);
                                                            let _e4136 = (_e4111 - _e4134);
                                                            let _e4145 = (_e4125 * 4097f);
                                                            let _e4147 = (_e4145 - (_e4145 - _e4125));
                                                            let _e4148 = (_e4104 * 4097f);
                                                            let _e4150 = (_e4148 - (_e4148 - _e4104));
                                                            let _e4151 = (_e4125 - _e4147);
                                                            let _e4152 = (_e4104 - _e4150);
                                                            phi_5467_ = ((((((_e4131 * _e4134) - _e4126) + (_e4131 * _e4136)) + (_e4135 * _e4134)) + (_e4135 * _e4136)) - (((((_e4147 * _e4150) - _e4127) + (_e4147 * _e4152)) + (_e4151 * _e4150)) + (_e4151 * _e4152)));
                                                        }
                                                        let _e4164 = phi_5467_;
                                                        let _e4165 = (_e4090 * _e4125);
                                                        let _e4166 = (_e4097 * _e4118);
                                                        if (_e4165 != _e4166) {
                                                            phi_5478_ = (_e4165 - _e4166);
                                                        } else {
                                                            let _e4168 = (_e4090 * 4097f);
                                                            let _e4170 = (_e4168 - (_e4168 - _e4090));
                                                            let _e4171 = (_e4125 * 4097f);
                                                            let _e4173 = (_e4171 - (_e4171 - _e4125));
                                                            let _e4174 = (_e4090 - _e4170);
                                                            let _e4175 = (_e4125 - _e4173);
                                                            let _e4184 = (_e4097 * 4097f);
                                                            let _e4186 = (_e4184 - (_e4184 - _e4097));
                                                            let _e4187 = (_e4118 * 4097f);
                                                            let _e4189 = (_e4187 - (_e4187 - _e4118));
                                                            let _e4190 = (_e4097 - _e4186);
                                                            let _e4191 = (_e4118 - _e4189);
                                                            phi_5478_ = ((((((_e4170 * _e4173) - _e4165) + (_e4170 * _e4175)) + (_e4174 * _e4173)) + (_e4174 * _e4175)) - (((((_e4186 * _e4189) - _e4166) + (_e4186 * _e4191)) + (_e4190 * _e4189)) + (_e4190 * _e4191)));
                                                        }
                                                        let _e4203 = phi_5478_;
                                                        let _e4204 = (_e4104 * _e4097);
                                                        let _e4205 = (_e4111 * _e4090);
                                                        if (_e4204 != _e4205) {
                                                            phi_5489_ = (_e4204 - _e4205);
                                                        } else {
                                                            let _e4207 = (_e4104 * 4097f);
                                                            let _e4209 = (_e4207 - (_e4207 - _e4104));
                                                            let _e4210 = (_e4097 * 4097f);
                                                            let _e4212 = (_e4210 - (_e4210 - _e4097));
                                                            let _e4213 = (_e4104 - _e4209);
                                                            let _e4214 = (_e4097 - _e4212);
                                                            let _e4223 = (_e4111 * 4097f);
                                                            let _e4225 = (_e4223 - (_e4223 - _e4111));
                                                            let _e4226 = (_e4090 * 4097f);
                                                            let _e4228 = (_e4226 - (_e4226 - _e4090));
                                                            let _e4229 = (_e4111 - _e4225);
                                                            let _e4230 = (_e4090 - _e4228);
                                                            phi_5489_ = ((((((_e4209 * _e4212) - _e4204) + (_e4209 * _e4214)) + (_e4213 * _e4212)) + (_e4213 * _e4214)) - (((((_e4225 * _e4228) - _e4205) + (_e4225 * _e4230)) + (_e4229 * _e4228)) + (_e4229 * _e4230)));
                                                        }
                                                        let _e4242 = phi_5489_;
                                                        if (_e4164 < 0f) {
                                                            phi_5507_ = f32();
                                                            phi_5508_ = true;
                                                        } else {
                                                            if (_e4203 < 0f) {
                                                                phi_5505_ = f32();
                                                                phi_5506_ = true;
                                                            } else {
                                                                let _e4245 = (_e4242 < 0f);
                                                                if _e4245 {
                                                                    phi_5504_ = f32();
                                                                } else {
                                                                    phi_5504_ = ((_e4164 + _e4203) + _e4242);
                                                                }
                                                                let _e4249 = phi_5504_;
                                                                phi_5505_ = _e4249;
                                                                phi_5506_ = _e4245;
                                                            }
                                                            let _e4251 = phi_5505_;
                                                            let _e4253 = phi_5506_;
                                                            phi_5507_ = _e4251;
                                                            phi_5508_ = _e4253;
                                                        }
                                                        let _e4255 = phi_5507_;
                                                        let _e4257 = phi_5508_;
                                                        if _e4257 {
                                                            if (_e4164 > 0f) {
                                                                phi_5529_ = f32();
                                                                phi_5530_ = true;
                                                                phi_5531_ = false;
                                                            } else {
                                                                let _e4259 = (_e4203 > 0f);
                                                                if _e4259 {
                                                                    phi_5527_ = f32();
                                                                    phi_5528_ = false;
                                                                } else {
                                                                    phi_5527_ = ((_e4164 + _e4203) + _e4242);
                                                                    phi_5528_ = select(true, false, (_e4242 > 0f));
                                                                }
                                                                let _e4265 = phi_5527_;
                                                                let _e4267 = phi_5528_;
                                                                phi_5529_ = _e4265;
                                                                phi_5530_ = _e4259;
                                                                phi_5531_ = _e4267;
                                                            }
                                                            let _e4269 = phi_5529_;
                                                            let _e4271 = phi_5530_;
                                                            let _e4273 = phi_5531_;
                                                            phi_5536_ = _e4269;
                                                            phi_5537_ = select(_e4273, false, _e4271);
                                                        } else {
                                                            phi_5536_ = _e4255;
                                                            phi_5537_ = true;
                                                        }
                                                        let _e4276 = phi_5536_;
                                                        let _e4278 = phi_5537_;
                                                        if _e4278 {
                                                            let _e4279 = (_e4276 == 0f);
                                                            if _e4279 {
                                                                phi_5625_ = array<f32, 3>();
                                                                phi_5626_ = array<f32, 3>();
                                                                phi_5627_ = false;
                                                            } else {
                                                                let _e4280 = (_e4073 * _e3957);
                                                                let _e4281 = (_e4078 * _e3957);
                                                                let _e4282 = (_e4083 * _e3957);
                                                                let _e4285 = (1f / ((_e4164 + _e4203) + _e4242));
                                                                let _e4286 = (_e4203 * _e4285);
                                                                let _e4287 = (_e4242 * _e4285);
                                                                let _e4293 = ((((_e4164 * _e4285) * _e4280) + (_e4286 * _e4281)) + (_e4287 * _e4282));
                                                                let _e4294 = abs(_e4090);
                                                                let _e4295 = abs(_e4104);
                                                                let _e4297 = select(_e4295, _e4294, (_e4294 > _e4295));
                                                                let _e4298 = abs(_e4118);
                                                                let _e4301 = abs(_e4097);
                                                                let _e4302 = abs(_e4111);
                                                                let _e4304 = select(_e4302, _e4301, (_e4301 > _e4302));
                                                                let _e4305 = abs(_e4125);
                                                                let _e4309 = abs(_e4280);
                                                                let _e4310 = abs(_e4281);
                                                                let _e4312 = select(_e4310, _e4309, (_e4309 > _e4310));
                                                                let _e4313 = abs(_e4282);
                                                                let _e4320 = (((select(_e4298, _e4297, (_e4297 > _e4298)) * select(_e4305, _e4304, (_e4304 > _e4305))) * select(_e4313, _e4312, (_e4312 > _e4313))) <= (abs((_e4276 * _e4293)) * 256f));
                                                                if _e4320 {
                                                                    phi_5623_ = array<f32, 3>(_e4293, _e4286, _e4287);
                                                                    phi_5624_ = array<f32, 3>();
                                                                } else {
                                                                    let _e4322 = (_e4118 * 4097f);
                                                                    let _e4324 = (_e4322 - (_e4322 - _e4118));
                                                                    let _e4325 = (_e4111 * 4097f);
                                                                    let _e4327 = (_e4325 - (_e4325 - _e4111));
                                                                    let _e4328 = (_e4118 - _e4324);
                                                                    let _e4329 = (_e4111 - _e4327);
                                                                    let _e4338 = (_e4125 * 4097f);
                                                                    let _e4340 = (_e4338 - (_e4338 - _e4125));
                                                                    let _e4341 = (_e4104 * 4097f);
                                                                    let _e4343 = (_e4341 - (_e4341 - _e4104));
                                                                    let _e4344 = (_e4125 - _e4340);
                                                                    let _e4345 = (_e4104 - _e4343);
                                                                    let _e4355 = ((_e4126 - _e4127) + ((((((_e4324 * _e4327) - _e4126) + (_e4324 * _e4329)) + (_e4328 * _e4327)) + (_e4328 * _e4329)) - (((((_e4340 * _e4343) - _e4127) + (_e4340 * _e4345)) + (_e4344 * _e4343)) + (_e4344 * _e4345))));
                                                                    let _e4357 = (_e4090 * 4097f);
                                                                    let _e4359 = (_e4357 - (_e4357 - _e4090));
                                                                    let _e4360 = (_e4090 - _e4359);
                                                                    let _e4369 = (_e4097 * 4097f);
                                                                    let _e4371 = (_e4369 - (_e4369 - _e4097));
                                                                    let _e4372 = (_e4097 - _e4371);
                                                                    let _e4382 = ((_e4165 - _e4166) + ((((((_e4359 * _e4340) - _e4165) + (_e4359 * _e4344)) + (_e4360 * _e4340)) + (_e4360 * _e4344)) - (((((_e4371 * _e4324) - _e4166) + (_e4371 * _e4328)) + (_e4372 * _e4324)) + (_e4372 * _e4328))));
                                                                    let _e4401 = ((_e4204 - _e4205) + ((((((_e4343 * _e4371) - _e4204) + (_e4343 * _e4372)) + (_e4345 * _e4371)) + (_e4345 * _e4372)) - (((((_e4327 * _e4359) - _e4205) + (_e4327 * _e4360)) + (_e4329 * _e4359)) + (_e4329 * _e4360))));
                                                                    let _e4404 = (1f / ((_e4355 + _e4382) + _e4401));
                                                                    let _e4405 = (_e4382 * _e4404);
                                                                    let _e4406 = (_e4401 * _e4404);
                                                                    phi_5623_ = array<f32, 3>();
                                                                    phi_5624_ = array<f32, 3>(((((_e4355 * _e4404) * _e4280) + (_e4405 * _e4281)) + (_e4406 * _e4282)), _e4405, _e4406);
                                                                }
                                                                let _e4416 = phi_5623_;
                                                                let _e4418 = phi_5624_;
                                                                phi_5625_ = _e4416;
                                                                phi_5626_ = _e4418;
                                                                phi_5627_ = _e4320;
                                                            }
                                                            let _e4420 = phi_5625_;
                                                            let _e4422 = phi_5626_;
                                                            let _e4424 = phi_5627_;
                                                            phi_5628_ = _e4420;
                                                            phi_5629_ = _e4422;
                                                            phi_5630_ = _e4279;
                                                            phi_5631_ = _e4424;
                                                        } else {
                                                            phi_5628_ = array<f32, 3>();
                                                            phi_5629_ = array<f32, 3>();
                                                            phi_5630_ = true;
                                                            phi_5631_ = false;
                                                        }
                                                        let _e4426 = phi_5628_;
                                                        let _e4428 = phi_5629_;
                                                        let _e4430 = phi_5630_;
                                                        let _e4432 = phi_5631_;
                                                        if _e4430 {
                                                            phi_5636_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_5636_ = _e4426;
                                                        }
                                                        let _e4434 = phi_5636_;
                                                        if select(_e4432, true, _e4430) {
                                                            phi_5641_ = _e4434;
                                                        } else {
                                                            phi_5641_ = _e4428;
                                                        }
                                                        let _e4437 = phi_5641_;
                                                        let _e4441 = (_e4437[0] >= 0f);
                                                        if _e4441 {
                                                            let _e4442 = (_e4437[0] < 0.9999995f);
                                                            if _e4442 {
                                                                if _e4441 {
                                                                    if _e4068 {
                                                                    } else {
                                                                        phi_16902_ = true;
                                                                        phi_12548_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e4445 = triangles.member[_e4063.member_1].member_3;
                                                                    if ((_e4445 & 1u) == 0u) {
                                                                        phi_5973_ = true;
                                                                    } else {
                                                                        if _e4068 {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4450 = triangles.member[_e4063.member_1].member_1;
                                                                        let _e4451 = (_e4450 * 12u);
                                                                        if ((256u + _e4451) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 257u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 258u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4458 = (_e4451 + 259u);
                                                                        if (_e4458 < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4461 = surfaces.member[_e4458];
                                                                        if ((_e4451 + 260u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 261u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 262u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4468 = (_e4451 + 263u);
                                                                        if (_e4468 < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4471 = surfaces.member[_e4468];
                                                                        let _e4472 = (_e4451 + 264u);
                                                                        if (_e4472 < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4475 = surfaces.member[_e4472];
                                                                        let _e4476 = bitcast<f32>(_e4475);
                                                                        let _e4477 = (_e4451 + 265u);
                                                                        if (_e4477 < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4480 = surfaces.member[_e4477];
                                                                        let _e4481 = bitcast<f32>(_e4480);
                                                                        if ((_e4451 + 266u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 267u) < _e147) {
                                                                        } else {
                                                                            phi_16902_ = true;
                                                                            phi_12548_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e4461 == 4294967295u) {
                                                                            phi_5968_ = (_e4476 < _e4481);
                                                                        } else {
                                                                            if (_e4063.member_1 < _e144) {
                                                                            } else {
                                                                                phi_16902_ = true;
                                                                                phi_12548_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4489 = ((1f - _e4437[1]) - _e4437[2]);
                                                                            let _e4493 = attributes.member[_e4063.member_1].member[0u];
                                                                            let _e4498 = attributes.member[_e4063.member_1].member[2u];
                                                                            let _e4504 = attributes.member[_e4063.member_1].member[4u];
                                                                            let _e4506 = (((_e4493 * _e4489) + (_e4498 * _e4437[1])) + (_e4504 * _e4437[2]));
                                                                            let _e4510 = attributes.member[_e4063.member_1].member[1u];
                                                                            let _e4515 = attributes.member[_e4063.member_1].member[3u];
                                                                            let _e4521 = attributes.member[_e4063.member_1].member[5u];
                                                                            let _e4523 = (((_e4510 * _e4489) + (_e4515 * _e4437[1])) + (_e4521 * _e4437[2]));
                                                                            let _e4524 = (_e4471 & 65535u);
                                                                            let _e4526 = (_e4471 >> bitcast<u32>(16i));
                                                                            let _e4528 = (_e4506 - floor(_e4506));
                                                                            let _e4533 = ((select(0f, _e4528, (_e4528 <= 1f)) * f32(_e4524)) - 0.5f);
                                                                            let _e4534 = floor(_e4533);
                                                                            let _e4535 = (_e4533 - _e4534);
                                                                            let _e4536 = (_e4524 - 1u);
                                                                            if (_e4534 < 0f) {
                                                                                phi_5851_ = _e4536;
                                                                            } else {
                                                                                let _e4542 = select(select(u32(_e4534), 0u, (_e4534 < 0f)), 4294967295u, (_e4534 > 4294967000f));
                                                                                phi_5851_ = select(_e4542, _e4536, (_e4536 < _e4542));
                                                                            }
                                                                            let _e4546 = phi_5851_;
                                                                            if (_e4546 == _e4536) {
                                                                                phi_5857_ = 0u;
                                                                            } else {
                                                                                phi_5857_ = (_e4546 + 1u);
                                                                            }
                                                                            let _e4550 = phi_5857_;
                                                                            let _e4552 = (_e4523 - floor(_e4523));
                                                                            let _e4557 = ((select(0f, _e4552, (_e4552 <= 1f)) * f32(_e4526)) - 0.5f);
                                                                            let _e4558 = floor(_e4557);
                                                                            let _e4559 = (_e4557 - _e4558);
                                                                            let _e4560 = (_e4526 - 1u);
                                                                            if (_e4558 < 0f) {
                                                                                phi_5887_ = _e4560;
                                                                            } else {
                                                                                let _e4566 = select(select(u32(_e4558), 0u, (_e4558 < 0f)), 4294967295u, (_e4558 > 4294967000f));
                                                                                phi_5887_ = select(_e4566, _e4560, (_e4560 < _e4566));
                                                                            }
                                                                            let _e4570 = phi_5887_;
                                                                            if (_e4570 == _e4560) {
                                                                                phi_5893_ = 0u;
                                                                            } else {
                                                                                phi_5893_ = (_e4570 + 1u);
                                                                            }
                                                                            let _e4574 = phi_5893_;
                                                                            let _e4576 = (_e4461 + (_e4570 * _e4524));
                                                                            let _e4578 = (_e4461 + (_e4574 * _e4524));
                                                                            let _e4579 = (_e4576 + _e4546);
                                                                            let _e4580 = (_e4576 + _e4550);
                                                                            let _e4581 = (_e4578 + _e4546);
                                                                            let _e4582 = (_e4578 + _e4550);
                                                                            if (_e4579 < _e147) {
                                                                            } else {
                                                                                phi_16902_ = true;
                                                                                phi_12548_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4585 = surfaces.member[_e4579];
                                                                            if (_e4580 < _e147) {
                                                                            } else {
                                                                                phi_16902_ = true;
                                                                                phi_12548_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4588 = surfaces.member[_e4580];
                                                                            if (_e4581 < _e147) {
                                                                            } else {
                                                                                phi_16902_ = true;
                                                                                phi_12548_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4591 = surfaces.member[_e4581];
                                                                            if (_e4582 < _e147) {
                                                                            } else {
                                                                                phi_16902_ = true;
                                                                                phi_12548_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4594 = surfaces.member[_e4582];
                                                                            let _e4611 = (1f - _e4535);
                                                                            phi_5968_ = ((_e4476 * (((((f32((_e4585 >> bitcast<u32>(24i))) * 0.003921569f) * _e4611) + ((f32((_e4588 >> bitcast<u32>(24i))) * 0.003921569f) * _e4535)) * (1f - _e4559)) + ((((f32((_e4591 >> bitcast<u32>(24i))) * 0.003921569f) * _e4611) + ((f32((_e4594 >> bitcast<u32>(24i))) * 0.003921569f) * _e4535)) * _e4559))) < _e4481);
                                                                        }
                                                                        let _e4626 = phi_5968_;
                                                                        phi_5973_ = select(true, false, _e4626);
                                                                    }
                                                                    let _e4629 = phi_5973_;
                                                                    if _e4629 {
                                                                        phi_5978_ = type_47(_e4437[0], _e4063.member_1, _e4437[1], _e4437[2]);
                                                                    } else {
                                                                        phi_5978_ = type_47();
                                                                    }
                                                                    let _e4632 = phi_5978_;
                                                                    phi_5980_ = _e4632;
                                                                    phi_5982_ = select(true, false, _e4629);
                                                                } else {
                                                                    phi_5980_ = type_47();
                                                                    phi_5982_ = false;
                                                                }
                                                                let _e4635 = phi_5980_;
                                                                let _e4637 = phi_5982_;
                                                                phi_5983_ = _e4635;
                                                                phi_5985_ = select(true, false, _e4441);
                                                                phi_5986_ = _e4637;
                                                            } else {
                                                                phi_5983_ = type_47();
                                                                phi_5985_ = false;
                                                                phi_5986_ = false;
                                                            }
                                                            let _e4640 = phi_5983_;
                                                            let _e4642 = phi_5985_;
                                                            let _e4644 = phi_5986_;
                                                            phi_5987_ = _e4640;
                                                            phi_5988_ = select(true, false, _e4442);
                                                            phi_5989_ = _e4642;
                                                            phi_5990_ = _e4644;
                                                        } else {
                                                            phi_5987_ = type_47();
                                                            phi_5988_ = true;
                                                            phi_5989_ = false;
                                                            phi_5990_ = false;
                                                        }
                                                        let _e4647 = phi_5987_;
                                                        let _e4649 = phi_5988_;
                                                        let _e4651 = phi_5989_;
                                                        let _e4653 = phi_5990_;
                                                        if select(select(_e4653, false, _e4649), true, select(_e4651, true, _e4649)) {
                                                            phi_6003_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_6003_ = _e4647;
                                                        }
                                                        let _e4658 = phi_6003_;
                                                        phi_6010_ = select(true, false, (_e4658.member_1 != 4294967295u));
                                                    } else {
                                                        phi_6010_ = false;
                                                    }
                                                    let _e4663 = phi_6010_;
                                                    continue;
                                                    continuing {
                                                        phi_5327_ = _e4061;
                                                        phi_16902_ = _e4036;
                                                        phi_12548_ = select(true, false, _e4067);
                                                        break if !(_e4663);
                                                    }
                                                }
                                                let _e4667 = phi_16902_;
                                                let _e4669 = phi_12548_;
                                                phi_16970_ = _e4667;
                                                phi_12549_ = bool();
                                                if _e4667 {
                                                    break;
                                                }
                                                phi_16972_ = _e4667;
                                                phi_6015_ = _e4040;
                                                phi_6016_ = _e4669;
                                            }
                                            let _e4906 = phi_16972_;
                                            let _e4908 = phi_6015_;
                                            let _e4910 = phi_6016_;
                                            if _e4910 {
                                                let _e4911 = (_e4908 == 0u);
                                                if _e4911 {
                                                    phi_6032_ = u32();
                                                    phi_6033_ = u32();
                                                } else {
                                                    let _e4912 = (_e4908 - 1u);
                                                    if (_e4912 < 64u) {
                                                    } else {
                                                        phi_16970_ = true;
                                                        phi_12549_ = bool();
                                                        break;
                                                    }
                                                    let _e4915 = local_12[_e4912];
                                                    phi_6032_ = _e4915;
                                                    phi_6033_ = _e4912;
                                                }
                                                let _e4917 = phi_6032_;
                                                let _e4919 = phi_6033_;
                                                phi_4900_ = _e4917;
                                                phi_4903_ = _e4919;
                                                phi_6035_ = select(true, false, _e4911);
                                                phi_6036_ = _e4911;
                                            } else {
                                                phi_4900_ = u32();
                                                phi_4903_ = u32();
                                                phi_6035_ = false;
                                                phi_6036_ = false;
                                            }
                                            let _e4922 = phi_4900_;
                                            let _e4924 = phi_4903_;
                                            let _e4926 = phi_6035_;
                                            let _e4928 = phi_6036_;
                                            continue;
                                            continuing {
                                                phi_16906_ = _e4906;
                                                phi_4899_ = _e4922;
                                                phi_4902_ = _e4924;
                                                phi_16970_ = _e4906;
                                                phi_12549_ = _e4928;
                                                break if !(_e4926);
                                            }
                                        }
                                        let _e4931 = phi_16970_;
                                        let _e4933 = phi_12549_;
                                        phi_17290_ = _e4931;
                                        if _e4931 {
                                            break;
                                        }
                                        let _e4936 = !(select(false, true, select(true, false, _e4933)));
                                        if _e4936 {
                                            phi_6053_ = vec3<f32>((_e3823.member_6[0] * _e3912), (_e3823.member_6[1] * _e3912), (_e3823.member_6[2] * _e3912));
                                        } else {
                                            phi_6053_ = vec3<f32>();
                                        }
                                        let _e4942 = phi_6053_;
                                        phi_17296_ = _e4931;
                                        phi_6055_ = _e4942;
                                        phi_6056_ = select(true, false, _e4936);
                                    } else {
                                        phi_17296_ = _e3796;
                                        phi_6055_ = vec3<f32>();
                                        phi_6056_ = true;
                                    }
                                    let _e4945 = phi_17296_;
                                    let _e4947 = phi_6055_;
                                    let _e4949 = phi_6056_;
                                    phi_17294_ = _e4945;
                                    phi_6061_ = vec3<f32>();
                                    phi_6062_ = select(_e4947, vec3<f32>(0f, 0f, 0f), vec3(_e4949));
                                }
                                let _e6000 = phi_17294_;
                                let _e6002 = phi_6061_;
                                let _e6004 = phi_6062_;
                                phi_17293_ = _e6000;
                                phi_6063_ = _e6002;
                                phi_6064_ = _e6004;
                                phi_6065_ = _e3861;
                            }
                            let _e8072 = phi_17293_;
                            let _e8074 = phi_6063_;
                            let _e8076 = phi_6064_;
                            let _e8078 = phi_6065_;
                            phi_17291_ = _e8072;
                            phi_1450_ = (_e3800 + select(_e8076, _e8074, vec3(_e8078)));
                        } else {
                            phi_17291_ = _e3796;
                            phi_1450_ = vec3<f32>();
                        }
                        let _e8083 = phi_17291_;
                        let _e8085 = phi_1450_;
                        continue;
                        continuing {
                            phi_16923_ = _e8083;
                            phi_1446_ = _e3813;
                            phi_1449_ = _e8085;
                            phi_17290_ = _e8083;
                            break if !(_e3819);
                        }
                    }
                    let _e8088 = phi_17290_;
                    if _e8088 {
                        break;
                    }
                    phi_17421_ = _e8088;
                    let _e10064 = local_31;
                    phi_10770_ = _e10064;
                } else {
                    let _e247 = ((_e242 ^ (_e242 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e251 = ((_e247 ^ (_e247 >> bitcast<u32>(15i))) * 2221713035u);
                    phi_16401_ = false;
                    phi_6095_ = type_9(0u, _e215);
                    phi_6098_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e261 = phi_16401_;
                        let _e263 = phi_6095_;
                        let _e265 = phi_6098_;
                        local_32 = _e265;
                        if (_e263.member < _e263.member_1) {
                            phi_6096_ = type_9((_e263.member + 1u), _e263.member_1);
                            phi_6121_ = type_9(1u, _e263.member);
                        } else {
                            phi_6096_ = _e263;
                            phi_6121_ = type_9(0u, type_9().member_1);
                        }
                        let _e278 = phi_6096_;
                        let _e280 = phi_6121_;
                        let _e284 = (bitcast<i32>(_e280.member) != 0i);
                        if _e284 {
                            let _e287 = f32(_e215);
                            phi_6135_ = (_e211 - 1u);
                            phi_6138_ = 0u;
                            loop {
                                let _e291 = phi_6135_;
                                let _e293 = phi_6138_;
                                local_21 = _e293;
                                local_22 = _e293;
                                let _e294 = (_e293 < _e291);
                                if _e294 {
                                    let _e296 = ((_e293 + _e291) / 2u);
                                    if (_e296 < _e149) {
                                    } else {
                                        phi_16397_ = true;
                                        break;
                                    }
                                    let _e301 = lights.member[_e296].member_5;
                                    let _e302 = (_e301 > ((f32(_e280.member_1) + (f32(((_e251 ^ (_e251 >> bitcast<u32>(16i))) >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e287));
                                    if _e302 {
                                        phi_6162_ = _e293;
                                    } else {
                                        phi_6162_ = (_e296 + 1u);
                                    }
                                    let _e305 = phi_6162_;
                                    phi_6136_ = select(_e291, _e296, _e302);
                                    phi_6139_ = _e305;
                                } else {
                                    phi_6136_ = u32();
                                    phi_6139_ = u32();
                                }
                                let _e308 = phi_6136_;
                                let _e310 = phi_6139_;
                                continue;
                                continuing {
                                    phi_6135_ = _e308;
                                    phi_6138_ = _e310;
                                    phi_16397_ = _e261;
                                    break if !(_e294);
                                }
                            }
                            let _e313 = phi_16397_;
                            phi_16794_ = _e313;
                            if _e313 {
                                break;
                            }
                            let _e315 = local_21;
                            if (_e315 < _e149) {
                            } else {
                                phi_16794_ = true;
                                break;
                            }
                            let _e319 = local_22;
                            let _e321 = lights.member[_e319];
                            if (_e321.member_7 > 0f) {
                                let _e325 = (1f / (_e321.member_7 * _e287));
                                let _e326 = (_e242 + _e280.member_1);
                                let _e330 = ((_e326 ^ (_e326 >> bitcast<u32>(16i))) * 2146121005u);
                                let _e334 = ((_e330 ^ (_e330 >> bitcast<u32>(15i))) * 2221713035u);
                                let _e337 = (_e334 ^ (_e334 >> bitcast<u32>(16i)));
                                if (_e321.member_1 == 3u) {
                                    let _e2500 = (_e321.member_2[0] - _e321.member[0]);
                                    let _e2501 = (_e321.member_2[1] - _e321.member[1]);
                                    let _e2502 = (_e321.member_2[2] - _e321.member[2]);
                                    let _e2503 = (_e321.member_4[0] - _e321.member[0]);
                                    let _e2504 = (_e321.member_4[1] - _e321.member[1]);
                                    let _e2505 = (_e321.member_4[2] - _e321.member[2]);
                                    let _e2508 = ((_e2501 * _e2505) - (_e2504 * _e2502));
                                    let _e2511 = ((_e2502 * _e2503) - (_e2505 * _e2500));
                                    let _e2514 = ((_e2500 * _e2504) - (_e2503 * _e2501));
                                    let _e2515 = abs(_e2508);
                                    let _e2516 = abs(_e2511);
                                    let _e2518 = select(_e2516, _e2515, (_e2515 > _e2516));
                                    let _e2519 = abs(_e2514);
                                    let _e2521 = select(_e2519, _e2518, (_e2518 > _e2519));
                                    if (_e2521 > 0.000000000000000000000000000000000000011754944f) {
                                        let _e2523 = (_e2521 < 340282350000000000000000000000000000000f);
                                        if _e2523 {
                                            let _e2524 = (_e2508 / _e2521);
                                            let _e2525 = (_e2511 / _e2521);
                                            let _e2526 = (_e2514 / _e2521);
                                            let _e2532 = sqrt((((_e2524 * _e2524) + (_e2525 * _e2525)) + (_e2526 * _e2526)));
                                            phi_6269_ = vec3<f32>((_e2524 / _e2532), (_e2525 / _e2532), (_e2526 / _e2532));
                                        } else {
                                            phi_6269_ = vec3<f32>();
                                        }
                                        let _e2538 = phi_6269_;
                                        phi_6271_ = _e2538;
                                        phi_6272_ = select(true, false, _e2523);
                                    } else {
                                        phi_6271_ = vec3<f32>();
                                        phi_6272_ = true;
                                    }
                                    let _e2541 = phi_6271_;
                                    let _e2543 = phi_6272_;
                                    let _e2545 = select(_e2541, vec3<f32>(0f, 0f, 0f), vec3(_e2543));
                                    let _e2556 = (((_e2545.x * (_e163.member[0] - _e321.member[0])) + (_e2545.y * (_e163.member[1] - _e321.member[1]))) + (_e2545.z * (_e163.member[2] - _e321.member[2])));
                                    if (_e2556 <= 0f) {
                                        phi_16811_ = _e313;
                                        phi_7877_ = 0f;
                                    } else {
                                        phi_16680_ = _e313;
                                        phi_6294_ = type_9(0u, 1u);
                                        phi_6299_ = 0f;
                                        loop {
                                            let _e2559 = phi_16680_;
                                            let _e2561 = phi_6294_;
                                            let _e2563 = phi_6299_;
                                            local_23 = _e2563;
                                            local_24 = _e2563;
                                            if (_e2561.member < _e2561.member_1) {
                                                phi_6295_ = type_9((_e2561.member + 1u), _e2561.member_1);
                                                phi_6324_ = type_9(1u, _e2561.member);
                                            } else {
                                                phi_6295_ = _e2561;
                                                phi_6324_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2576 = phi_6295_;
                                            let _e2578 = phi_6324_;
                                            let _e2582 = (bitcast<i32>(_e2578.member) != 0i);
                                            if _e2582 {
                                                let _e2586 = ((_e337 ^ (_e337 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e2590 = ((_e2586 ^ (_e2586 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e2597 = (_e337 ^ 2654435769u);
                                                let _e2601 = ((_e2597 ^ (_e2597 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e2605 = ((_e2601 ^ (_e2601 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e2623 = (0.000000059604645f * (f32(((2147483648u + (_e2578.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e2590 ^ (_e2590 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e2623 >= 1f) {
                                                    phi_13049_ = (_e2623 - 1f);
                                                } else {
                                                    phi_13049_ = _e2623;
                                                }
                                                let _e2627 = phi_13049_;
                                                let _e2629 = (0.000000059604645f * (f32(((2147483648u + (_e2578.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e2605 ^ (_e2605 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e2629 >= 1f) {
                                                    phi_13057_ = (_e2629 - 1f);
                                                } else {
                                                    phi_13057_ = _e2629;
                                                }
                                                let _e2633 = phi_13057_;
                                                if (_e2627 < _e2633) {
                                                    let _e2638 = (0.5f * _e2627);
                                                    phi_6385_ = vec2<f32>(_e2638, (_e2633 - _e2638));
                                                } else {
                                                    let _e2635 = (0.5f * _e2633);
                                                    phi_6385_ = vec2<f32>((_e2627 - _e2635), _e2635);
                                                }
                                                let _e2642 = phi_6385_;
                                                let _e2654 = ((_e321.member[0] + (_e2500 * _e2642.x)) + (_e2503 * _e2642.y));
                                                let _e2655 = ((_e321.member[1] + (_e2501 * _e2642.x)) + (_e2504 * _e2642.y));
                                                let _e2656 = ((_e321.member[2] + (_e2502 * _e2642.x)) + (_e2505 * _e2642.y));
                                                let _e2657 = (_e2654 - _e163.member[0]);
                                                let _e2658 = (_e2655 - _e163.member[1]);
                                                let _e2659 = (_e2656 - _e163.member[2]);
                                                let _e2664 = (((_e2657 * _e2657) + (_e2658 * _e2658)) + (_e2659 * _e2659));
                                                let _e2672 = (((_e185.x * _e2657) + (_e185.y * _e2658)) + (_e185.z * _e2659));
                                                let _e2676 = (_e2664 * _e2664);
                                                let _e2679 = ((select(0f, _e2672, (_e2672 > 0f)) * _e2556) / select(0.000000000000000000000000000000000000011754944f, _e2676, (_e2676 > 0.000000000000000000000000000000000000011754944f)));
                                                if (_e2679 > 0f) {
                                                    let _e2681 = abs(_e2654);
                                                    let _e2682 = abs(_e2655);
                                                    let _e2684 = select(_e2682, _e2681, (_e2681 > _e2682));
                                                    let _e2685 = abs(_e2656);
                                                    let _e2691 = ((select(_e2685, _e2684, (_e2684 > _e2685)) + sqrt(_e321.member_3)) * 0.0000009536743f);
                                                    let _e2695 = (_e2654 + (_e2545.x * _e2691));
                                                    let _e2696 = (_e2655 + (_e2545.y * _e2691));
                                                    let _e2697 = (_e2656 + (_e2545.z * _e2691));
                                                    if ((((_e185.x * (_e2695 - _e163.member[0])) + (_e185.y * (_e2696 - _e163.member[1]))) + (_e185.z * (_e2697 - _e163.member[2]))) < 0f) {
                                                        phi_6488_ = -(_e207);
                                                    } else {
                                                        phi_6488_ = _e207;
                                                    }
                                                    let _e2709 = phi_6488_;
                                                    let _e2713 = (_e163.member[0] + (_e185.x * _e2709));
                                                    let _e2714 = (_e163.member[1] + (_e185.y * _e2709));
                                                    let _e2715 = (_e163.member[2] + (_e185.z * _e2709));
                                                    let _e2716 = (_e2695 - _e2713);
                                                    let _e2717 = (_e2696 - _e2714);
                                                    let _e2718 = (_e2697 - _e2715);
                                                    let _e2719 = abs(_e2716);
                                                    let _e2720 = abs(_e2717);
                                                    let _e2721 = abs(_e2718);
                                                    let _e2722 = (_e2719 > _e2720);
                                                    if _e2722 {
                                                        phi_6517_ = (_e2719 > _e2721);
                                                    } else {
                                                        phi_6517_ = (_e2720 > _e2721);
                                                    }
                                                    let _e2726 = phi_6517_;
                                                    let _e2727 = select(1u, 0u, _e2722);
                                                    if _e2726 {
                                                        let _e2728 = (_e2727 + 1u);
                                                        phi_6527_ = _e2728;
                                                        phi_6530_ = select(true, false, (_e2728 == 2u));
                                                    } else {
                                                        phi_6527_ = u32();
                                                        phi_6530_ = false;
                                                    }
                                                    let _e2732 = phi_6527_;
                                                    let _e2734 = phi_6530_;
                                                    let _e2735 = select(true, false, _e2726);
                                                    let _e2736 = select(_e2732, 0u, _e2735);
                                                    let _e2738 = select(_e2734, true, _e2735);
                                                    if _e2738 {
                                                        phi_6541_ = (_e2736 + 1u);
                                                    } else {
                                                        phi_6541_ = 0u;
                                                    }
                                                    let _e2741 = phi_6541_;
                                                    let _e2742 = select(_e2732, _e2736, _e2738);
                                                    let _e2743 = select(_e2727, select(_e2727, 2u, _e2735), _e2738);
                                                    local_10 = array<f32, 3>(_e2716, _e2717, _e2718);
                                                    local_11 = array<f32, 3>(_e2713, _e2714, _e2715);
                                                    let _e2746 = (_e2743 < 3u);
                                                    if _e2746 {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2748 = local_10[_e2743];
                                                    let _e2749 = (1f / _e2748);
                                                    let _e2750 = (_e2742 < 3u);
                                                    if _e2750 {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2752 = local_10[_e2742];
                                                    let _e2753 = (_e2752 * _e2749);
                                                    let _e2754 = (_e2741 < 3u);
                                                    if _e2754 {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2756 = local_10[_e2741];
                                                    let _e2757 = (_e2756 * _e2749);
                                                    if _e2750 {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2759 = local_11[_e2742];
                                                    if _e2754 {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2761 = local_11[_e2741];
                                                    if _e2746 {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2763 = local_11[_e2743];
                                                    if (0u < _e138) {
                                                    } else {
                                                        phi_16788_ = true;
                                                        break;
                                                    }
                                                    let _e2768 = nodes.member[0u].member_7[0u];
                                                    let _e2772 = nodes.member[0u].member_7[1u];
                                                    let _e2776 = nodes.member[0u].member_7[2u];
                                                    let _e2780 = nodes.member[0u].member_7[3u];
                                                    let _e2782 = abs((_e2713 - _e2768));
                                                    let _e2784 = abs((_e2714 - _e2772));
                                                    let _e2786 = select(_e2784, _e2782, (_e2782 > _e2784));
                                                    let _e2788 = abs((_e2715 - _e2776));
                                                    let _e2792 = ((select(_e2788, _e2786, (_e2786 > _e2788)) + _e2780) * 0.0000009536743f);
                                                    let _e2799 = (_e2792 + (abs(_e2713) * 0.00000023841858f));
                                                    let _e2800 = (_e2792 + (abs(_e2714) * 0.00000023841858f));
                                                    let _e2801 = (_e2792 + (abs(_e2715) * 0.00000023841858f));
                                                    let _e2802 = select(_e2720, _e2719, _e2722);
                                                    let _e2804 = select(_e2721, _e2802, (_e2802 > _e2721));
                                                    let _e2805 = (_e2804 * 0.000000000001f);
                                                    let _e2806 = (_e2713 + _e2799);
                                                    let _e2807 = (_e2714 + _e2800);
                                                    let _e2808 = (_e2715 + _e2801);
                                                    let _e2809 = (_e2713 - _e2799);
                                                    let _e2810 = (_e2714 - _e2800);
                                                    let _e2811 = (_e2715 - _e2801);
                                                    if (_e2719 > _e2805) {
                                                        phi_6671_ = (1f / _e2716);
                                                    } else {
                                                        phi_6671_ = (1000000000000f / _e2804);
                                                    }
                                                    let _e2816 = phi_6671_;
                                                    if (_e2720 > _e2805) {
                                                        phi_6679_ = (1f / _e2717);
                                                    } else {
                                                        phi_6679_ = (1000000000000f / _e2804);
                                                    }
                                                    let _e2821 = phi_6679_;
                                                    if (_e2721 > _e2805) {
                                                        phi_6687_ = (1f / _e2718);
                                                    } else {
                                                        phi_6687_ = (1000000000000f / _e2804);
                                                    }
                                                    let _e2826 = phi_6687_;
                                                    local_9 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                    phi_16658_ = _e2559;
                                                    phi_6690_ = 0u;
                                                    phi_6693_ = 0u;
                                                    loop {
                                                        let _e2828 = phi_16658_;
                                                        let _e2830 = phi_6690_;
                                                        let _e2832 = phi_6693_;
                                                        let _e2833 = (_e2830 & 15u);
                                                        let _e2835 = (_e2830 >> bitcast<u32>(4u));
                                                        if (_e2833 == 0u) {
                                                            if (_e2835 < _e138) {
                                                            } else {
                                                                phi_16728_ = true;
                                                                phi_12547_ = bool();
                                                                break;
                                                            }
                                                            let _e3465 = nodes.member[_e2835].member;
                                                            let _e3474 = ((_e3465.x - _e2806) * _e2816);
                                                            let _e3475 = ((_e3465.y - _e2806) * _e2816);
                                                            let _e3476 = ((_e3465.z - _e2806) * _e2816);
                                                            let _e3477 = ((_e3465.w - _e2806) * _e2816);
                                                            let _e3480 = nodes.member[_e2835].member_3;
                                                            let _e3489 = ((_e3480.x - _e2809) * _e2816);
                                                            let _e3490 = ((_e3480.y - _e2809) * _e2816);
                                                            let _e3491 = ((_e3480.z - _e2809) * _e2816);
                                                            let _e3492 = ((_e3480.w - _e2809) * _e2816);
                                                            let _e3495 = nodes.member[_e2835].member_1;
                                                            let _e3504 = ((_e3495.x - _e2807) * _e2821);
                                                            let _e3505 = ((_e3495.y - _e2807) * _e2821);
                                                            let _e3506 = ((_e3495.z - _e2807) * _e2821);
                                                            let _e3507 = ((_e3495.w - _e2807) * _e2821);
                                                            let _e3510 = nodes.member[_e2835].member_4;
                                                            let _e3519 = ((_e3510.x - _e2810) * _e2821);
                                                            let _e3520 = ((_e3510.y - _e2810) * _e2821);
                                                            let _e3521 = ((_e3510.z - _e2810) * _e2821);
                                                            let _e3522 = ((_e3510.w - _e2810) * _e2821);
                                                            let _e3525 = nodes.member[_e2835].member_2;
                                                            let _e3534 = ((_e3525.x - _e2808) * _e2826);
                                                            let _e3535 = ((_e3525.y - _e2808) * _e2826);
                                                            let _e3536 = ((_e3525.z - _e2808) * _e2826);
                                                            let _e3537 = ((_e3525.w - _e2808) * _e2826);
                                                            let _e3540 = nodes.member[_e2835].member_5;
                                                            let _e3549 = ((_e3540.x - _e2811) * _e2826);
                                                            let _e3550 = ((_e3540.y - _e2811) * _e2826);
                                                            let _e3551 = ((_e3540.z - _e2811) * _e2826);
                                                            let _e3552 = ((_e3540.w - _e2811) * _e2826);
                                                            let _e3554 = select(_e3489, _e3474, (_e3474 < _e3489));
                                                            let _e3556 = select(_e3490, _e3475, (_e3475 < _e3490));
                                                            let _e3558 = select(_e3491, _e3476, (_e3476 < _e3491));
                                                            let _e3560 = select(_e3492, _e3477, (_e3477 < _e3492));
                                                            let _e3562 = select(_e3519, _e3504, (_e3504 < _e3519));
                                                            let _e3564 = select(_e3520, _e3505, (_e3505 < _e3520));
                                                            let _e3566 = select(_e3521, _e3506, (_e3506 < _e3521));
                                                            let _e3568 = select(_e3522, _e3507, (_e3507 < _e3522));
                                                            let _e3570 = select(_e3562, _e3554, (_e3554 > _e3562));
                                                            let _e3572 = select(_e3564, _e3556, (_e3556 > _e3564));
                                                            let _e3574 = select(_e3566, _e3558, (_e3558 > _e3566));
                                                            let _e3576 = select(_e3568, _e3560, (_e3560 > _e3568));
                                                            let _e3578 = select(_e3549, _e3534, (_e3534 < _e3549));
                                                            let _e3580 = select(_e3550, _e3535, (_e3535 < _e3550));
                                                            let _e3582 = select(_e3551, _e3536, (_e3536 < _e3551));
                                                            let _e3584 = select(_e3552, _e3537, (_e3537 < _e3552));
                                                            let _e3586 = select(_e3578, _e3570, (_e3570 > _e3578));
                                                            let _e3588 = select(_e3580, _e3572, (_e3572 > _e3580));
                                                            let _e3590 = select(_e3582, _e3574, (_e3574 > _e3582));
                                                            let _e3592 = select(_e3584, _e3576, (_e3576 > _e3584));
                                                            let _e3594 = select(0f, _e3586, (_e3586 > 0f));
                                                            let _e3596 = select(0f, _e3588, (_e3588 > 0f));
                                                            let _e3598 = select(0f, _e3590, (_e3590 > 0f));
                                                            let _e3600 = select(0f, _e3592, (_e3592 > 0f));
                                                            let _e3602 = select(_e3489, _e3474, (_e3474 > _e3489));
                                                            let _e3604 = select(_e3490, _e3475, (_e3475 > _e3490));
                                                            let _e3606 = select(_e3491, _e3476, (_e3476 > _e3491));
                                                            let _e3608 = select(_e3492, _e3477, (_e3477 > _e3492));
                                                            let _e3610 = select(_e3519, _e3504, (_e3504 > _e3519));
                                                            let _e3612 = select(_e3520, _e3505, (_e3505 > _e3520));
                                                            let _e3614 = select(_e3521, _e3506, (_e3506 > _e3521));
                                                            let _e3616 = select(_e3522, _e3507, (_e3507 > _e3522));
                                                            let _e3618 = select(_e3610, _e3602, (_e3602 < _e3610));
                                                            let _e3620 = select(_e3612, _e3604, (_e3604 < _e3612));
                                                            let _e3622 = select(_e3614, _e3606, (_e3606 < _e3614));
                                                            let _e3624 = select(_e3616, _e3608, (_e3608 < _e3616));
                                                            let _e3626 = select(_e3549, _e3534, (_e3534 > _e3549));
                                                            let _e3628 = select(_e3550, _e3535, (_e3535 > _e3550));
                                                            let _e3630 = select(_e3551, _e3536, (_e3536 > _e3551));
                                                            let _e3632 = select(_e3552, _e3537, (_e3537 > _e3552));
                                                            let _e3634 = select(_e3626, _e3618, (_e3618 < _e3626));
                                                            let _e3636 = select(_e3628, _e3620, (_e3620 < _e3628));
                                                            let _e3638 = select(_e3630, _e3622, (_e3622 < _e3630));
                                                            let _e3640 = select(_e3632, _e3624, (_e3624 < _e3632));
                                                            let _e3660 = nodes.member[_e2835].member_6[0u];
                                                            let _e3664 = nodes.member[_e2835].member_6[1u];
                                                            let _e3668 = nodes.member[_e2835].member_6[2u];
                                                            let _e3672 = nodes.member[_e2835].member_6[3u];
                                                            if (select(340282350000000000000000000000000000000f, _e3600, (_e3600 <= select(0.9999995f, _e3640, (_e3640 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e2832 < 64u) {
                                                                } else {
                                                                    phi_16728_ = true;
                                                                    phi_12547_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e2832] = _e3672;
                                                                phi_7078_ = (_e2832 + 1u);
                                                            } else {
                                                                phi_7078_ = _e2832;
                                                            }
                                                            let _e3678 = phi_7078_;
                                                            if (select(340282350000000000000000000000000000000f, _e3598, (_e3598 <= select(0.9999995f, _e3638, (_e3638 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e3678 < 64u) {
                                                                } else {
                                                                    phi_16728_ = true;
                                                                    phi_12547_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e3678] = _e3668;
                                                                phi_7090_ = (_e3678 + 1u);
                                                            } else {
                                                                phi_7090_ = _e3678;
                                                            }
                                                            let _e3684 = phi_7090_;
                                                            if (select(340282350000000000000000000000000000000f, _e3596, (_e3596 <= select(0.9999995f, _e3636, (_e3636 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e3684 < 64u) {
                                                                } else {
                                                                    phi_16728_ = true;
                                                                    phi_12547_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e3684] = _e3664;
                                                                phi_7102_ = (_e3684 + 1u);
                                                            } else {
                                                                phi_7102_ = _e3684;
                                                            }
                                                            let _e3690 = phi_7102_;
                                                            if (select(340282350000000000000000000000000000000f, _e3594, (_e3594 <= select(0.9999995f, _e3634, (_e3634 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e3690 < 64u) {
                                                                } else {
                                                                    phi_16728_ = true;
                                                                    phi_12547_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e3690] = _e3660;
                                                                phi_7114_ = (_e3690 + 1u);
                                                            } else {
                                                                phi_7114_ = _e3690;
                                                            }
                                                            let _e3696 = phi_7114_;
                                                            phi_16730_ = _e2828;
                                                            phi_7806_ = _e3696;
                                                            phi_7807_ = true;
                                                        } else {
                                                            phi_7118_ = type_9(_e2835, (_e2835 + _e2833));
                                                            loop {
                                                                let _e2840 = phi_7118_;
                                                                if (_e2840.member < _e2840.member_1) {
                                                                    phi_7119_ = type_9((_e2840.member + 1u), _e2840.member_1);
                                                                    phi_7142_ = type_9(1u, _e2840.member);
                                                                } else {
                                                                    phi_7119_ = _e2840;
                                                                    phi_7142_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e2853 = phi_7119_;
                                                                let _e2855 = phi_7142_;
                                                                let _e2859 = (bitcast<i32>(_e2855.member) != 0i);
                                                                if _e2859 {
                                                                    let _e2860 = (_e2855.member_1 < _e141);
                                                                    if _e2860 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    if _e2746 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2864 = triangles.member[_e2855.member_1].member[_e2743];
                                                                    let _e2865 = (_e2864 - _e2763);
                                                                    if _e2746 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2869 = triangles.member[_e2855.member_1].member_2[_e2743];
                                                                    let _e2870 = (_e2869 - _e2763);
                                                                    if _e2746 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2874 = triangles.member[_e2855.member_1].member_4[_e2743];
                                                                    let _e2875 = (_e2874 - _e2763);
                                                                    if _e2750 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2879 = triangles.member[_e2855.member_1].member[_e2742];
                                                                    let _e2882 = ((_e2879 - _e2759) - (_e2753 * _e2865));
                                                                    if _e2754 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2886 = triangles.member[_e2855.member_1].member[_e2741];
                                                                    let _e2889 = ((_e2886 - _e2761) - (_e2757 * _e2865));
                                                                    if _e2750 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2893 = triangles.member[_e2855.member_1].member_2[_e2742];
                                                                    let _e2896 = ((_e2893 - _e2759) - (_e2753 * _e2870));
                                                                    if _e2754 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2900 = triangles.member[_e2855.member_1].member_2[_e2741];
                                                                    let _e2903 = ((_e2900 - _e2761) - (_e2757 * _e2870));
                                                                    if _e2750 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2907 = triangles.member[_e2855.member_1].member_4[_e2742];
                                                                    let _e2910 = ((_e2907 - _e2759) - (_e2753 * _e2875));
                                                                    if _e2754 {
                                                                    } else {
                                                                        phi_16654_ = true;
                                                                        phi_12546_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2914 = triangles.member[_e2855.member_1].member_4[_e2741];
                                                                    let _e2917 = ((_e2914 - _e2761) - (_e2757 * _e2875));
                                                                    let _e2918 = (_e2910 * _e2903);
                                                                    let _e2919 = (_e2917 * _e2896);
                                                                    if (_e2918 != _e2919) {
                                                                        phi_7258_ = (_e2918 - _e2919);
                                                                    } else {
                                                                        let _e2921 = (_e2910 * 4097f);
                                                                        let _e2923 = (_e2921 - (_e2921 - _e2910));
                                                                        let _e2924 = (_e2903 * 4097f);
                                                                        let _e2926 = (_e2924 - (_e2924 - _e2903));
                                                                        let _e2927 = (_e2910 - _e2923);
                                                                        let _e2928 = (_e2903 - _e2926);
                                                                        let _e2937 = (_e2917 * 4097f);
                                                                        let _e2939 = (_e2937 - (_e2937 - _e2917));
                                                                        let _e2940 = (_e2896 * 4097f);
                                                                        let _e2942 = (_e2940 - (_e2940 - _e2896));
                                                                        let _e2943 = (_e2917 - _e2939);
                                                                        let _e2944 = (_e2896 - _e2942);
                                                                        phi_7258_ = ((((((_e2923 * _e2926) - _e2918) + (_e2923 * _e2928)) + (_e2927 * _e2926)) + (_e2927 * _e2928)) - (((((_e2939 * _e2942) - _e2919) + (_e2939 * _e2944)) + (_e2943 * _e2942)) + (_e2943 * _e2944)));
                                                                    }
                                                                    let _e2956 = phi_7258_;
                                                                    let _e2957 = (_e2882 * _e2917);
                                                                    let _e2958 = (_e2889 * _e2910);
                                                                    if (_e2957 != _e2958) {
                                                                        phi_7269_ = (_e2957 - _e2958);
                                                                    } else {
                                                                        let _e2960 = (_e2882 * 4097f);
                                                                        let _e2962 = (_e2960 - (_e2960 - _e2882));
                                                                        let _e2963 = (_e2917 * 4097f);
                                                                        let _e2965 = (_e2963 - (_e2963 - _e2917));
                                                                        let _e2966 = (_e2882 - _e2962);
                                                                        let _e2967 = (_e2917 - _e2965);
                                                                        let _e2976 = (_e2889 * 4097f);
                                                                        let _e2978 = (_e2976 - (_e2976 - _e2889));
                                                                        let _e2979 = (_e2910 * 4097f);
                                                                        let _e2981 = (_e2979 - (_e2979 - _e2910));
                                                                        let _e2982 = (_e2889 - _e2978);
                                                                        let _e2983 = (_e2910 - _e2981);
                                                                        phi_7269_ = ((((((_e2962 * _e2965) - _e2957) + (_e2962 * _e2967)) + (_e2966 * _e2965)) + (_e2966 * _e2967)) - (((((_e2978 * _e2981) - _e2958) + (_e2978 * _e2983)) + (_e2982 * _e2981)) + (_e2982 * _e2983)));
                                                                    }
                                                                    let _e2995 = phi_7269_;
                                                                    let _e2996 = (_e2896 * _e2889);
                                                                    let _e2997 = (_e2903 * _e2882);
                                                                    if (_e2996 != _e2997) {
                                                                        phi_7280_ = (_e2996 - _e2997);
                                                                    } else {
                                                                        let _e2999 = (_e2896 * 4097f);
                                                                        let _e3001 = (_e2999 - (_e2999 - _e2896));
                                                                        let _e3002 = (_e2889 * 4097f);
                                                                        let _e3004 = (_e3002 - (_e3002 - _e2889));
                                                                        let _e3005 = (_e2896 - _e3001);
                                                                        let _e3006 = (_e2889 - _e3004);
                                                                        let _e3015 = (_e2903 * 4097f);
                                                                        let _e3017 = (_e3015 - (_e3015 - _e2903));
                                                                        let _e3018 = (_e2882 * 4097f);
                                                                        let _e3020 = (_e3018 - (_e3018 - _e2882));
                                                                        let _e3021 = (_e2903 - _e3017);
                                                                        let _e3022 = (_e2882 - _e3020);
                                                                        phi_7280_ = ((((((_e3001 * _e3004) - _e2996) + (_e3001 * _e3006)) + (_e3005 * _e3004)) + (_e3005 * _e3006)) - (((((_e3017 * _e3020) - _e2997) + (_e3017 * _e3022)) + (_e3021 * _e3020)) + (_e3021 * _e3022)));
                                                                    }
                                                                    let _e3034 = phi_7280_;
                                                                    if (_e2956 < 0f) {
                                                                        phi_7298_ = f32();
                                                                        phi_7299_ = true;
                                                                    } else {
                                                                        if (_e2995 < 0f) {
                                                                            phi_7296_ = f32();
                                                                            phi_7297_ = true;
                                                                        } else {
                                                                            let _e3037 = (_e3034 < 0f);
                                                                            if _e3037 {
                                                                                phi_7295_ = f32();
                                                                            } else {
                                                                                phi_7295_ = ((_e2956 + _e2995) + _e3034);
                                                                            }
                                                                            let _e3041 = phi_7295_;
                                                                            phi_7296_ = _e3041;
                                                                            phi_7297_ = _e3037;
                                                                        }
                                                                        let _e3043 = phi_7296_;
                                                                        let _e3045 = phi_7297_;
                                                                        phi_7298_ = _e3043;
                                                                        phi_7299_ = _e3045;
                                                                    }
                                                                    let _e3047 = phi_7298_;
                                                                    let _e3049 = phi_7299_;
                                                                    if _e3049 {
                                                                        if (_e2956 > 0f) {
                                                                            phi_7320_ = f32();
                                                                            phi_7321_ = true;
                                                                            phi_7322_ = false;
                                                                        } else {
                                                                            let _e3051 = (_e2995 > 0f);
                                                                            if _e3051 {
                                                                                phi_7318_ = f32();
                                                                                phi_7319_ = false;
                                                                            } else {
                                                                                phi_7318_ = ((_e2956 + _e2995) + _e3034);
                                                                                phi_7319_ = select(true, false, (_e3034 > 0f));
                                                                            }
                                                                            let _e3057 = phi_7318_;
                                                                            let _e3059 = phi_7319_;
                                                                            phi_7320_ = _e3057;
                                                                            phi_7321_ = _e3051;
                                                                            phi_7322_ = _e3059;
                                                                        }
                                                                        let _e3061 = phi_7320_;
                                                                        let _e3063 = phi_7321_;
                                                                        let _e3065 = phi_7322_;
                                                                        phi_7327_ = _e3061;
                                                                        phi_7328_ = select(_e3065, false, _e3063);
                                                                    } else {
                                                                        phi_7327_ = _e3047;
                                                                        phi_7328_ = true;
                                                                    }
                                                                    let _e3068 = phi_7327_;
                                                                    let _e3070 = phi_7328_;
                                                                    if _e3070 {
                                                                        let _e3071 = (_e3068 == 0f);
                                                                        if _e3071 {
                                                                            phi_7416_ = array<f32, 3>();
                                                                            phi_7417_ = array<f32, 3>();
                                                                            phi_7418_ = false;
                                                                        } else {
                                                                            let _e3072 = (_e2865 * _e2749);
                                                                            let _e3073 = (_e2870 * _e2749);
                                                                            let _e3074 = (_e2875 * _e2749);
                                                                            let _e3077 = (1f / ((_e2956 + _e2995) + _e3034));
                                                                            let _e3078 = (_e2995 * _e3077);
                                                                            let _e3079 = (_e3034 * _e3077);
                                                                            let _e3085 = ((((_e2956 * _e3077) * _e3072) + (_e3078 * _e3073)) + (_e3079 * _e3074));
                                                                            let _e3086 = abs(_e2882);
                                                                            let _e3087 = abs(_e2896);
                                                                            let _e3089 = select(_e3087, _e3086, (_e3086 > _e3087));
                                                                            let _e3090 = abs(_e2910);
                                                                            let _e3093 = abs(_e2889);
                                                                            let _e3094 = abs(_e2903);
                                                                            let _e3096 = select(_e3094, _e3093, (_e3093 > _e3094));
                                                                            let _e3097 = abs(_e2917);
                                                                            let _e3101 = abs(_e3072);
                                                                            let _e3102 = abs(_e3073);
                                                                            let _e3104 = select(_e3102, _e3101, (_e3101 > _e3102));
                                                                            let _e3105 = abs(_e3074);
                                                                            let _e3112 = (((select(_e3090, _e3089, (_e3089 > _e3090)) * select(_e3097, _e3096, (_e3096 > _e3097))) * select(_e3105, _e3104, (_e3104 > _e3105))) <= (abs((_e3068 * _e3085)) * 256f));
                                                                            if _e3112 {
                                                                                phi_7414_ = array<f32, 3>(_e3085, _e3078, _e3079);
                                                                                phi_7415_ = array<f32, 3>();
                                                                            } else {
                                                                                let _e3114 = (_e2910 * 4097f);
                                                                                let _e3116 = (_e3114 - (_e3114 - _e2910));
                                                                                let _e3117 = (_e2903 * 4097f);
                                                                                let _e3119 = (_e3117 - (_e3117 - _e2903));
                                                                                let _e3120 = (_e2910 - _e3116);
                                                                                let _e3121 = (_e2903 - _e3119);
                                                                                let _e3130 = (_e2917 * 4097f);
                                                                                let _e3132 = (_e3130 - (_e3130 - _e2917));
                                                                                let _e3133 = (_e2896 * 4097f);
                                                                                let _e3135 = (_e3133 - (_e3133 - _e2896));
                                                                                let _e3136 = (_e2917 - _e3132);
                                                                                let _e3137 = (_e2896 - _e3135);
                                                                                let _e3147 = ((_e2918 - _e2919) + ((((((_e3116 * _e3119) - _e2918) + (_e3116 * _e3121)) + (_e3120 * _e3119)) + (_e3120 * _e3121)) - (((((_e3132 * _e3135) - _e2919) + (_e3132 * _e3137)) + (_e3136 * _e3135)) + (_e3136 * _e3137))));
                                                                                let _e3149 = (_e2882 * 4097f);
                                                                                let _e3151 = (_e3149 - (_e3149 - _e2882));
                                                                                let _e3152 = (_e2882 - _e3151);
                                                                                let _e3161 = (_e2889 * 4097f);
                                                                                let _e3163 = (_e3161 - (_e3161 - _e2889));
                                                                                let _e3164 = (_e2889 - _e3163);
                                                                                let _e3174 = ((_e2957 - _e2958) + ((((((_e3151 * _e3132) - _e2957) + (_e3151 * _e3136)) + (_e3152 * _e3132)) + (_e3152 * _e3136)) - (((((_e3163 * _e3116) - _e2958) + (_e3163 * _e3120)) + (_e3164 * _e3116)) + (_e3164 * _e3120))));
                                                                                let _e3193 = ((_e2996 - _e2997) + ((((((_e3135 * _e3163) - _e2996) + (_e3135 * _e3164)) + (_e3137 * _e3163)) + (_e3137 * _e3164)) - (((((_e3119 * _e3151) - _e2997) + (_e3119 * _e3152)) + (_e3121 * _e3151)) + (_e3121 * _e3152))));
                                                                                let _e3196 = (1f / ((_e3147 + _e3174) + _e3193));
                                                                                let _e3197 = (_e3174 * _e3196);
                                                                                let _e3198 = (_e3193 * _e3196);
                                                                                phi_7414_ = array<f32, 3>();
                                                                                phi_7415_ = array<f32, 3>(((((_e3147 * _e3196) * _e3072) + (_e3197 * _e3073)) + (_e3198 * _e3074)), _e3197, _e3198);
                                                                            }
                                                                            let _e3208 = phi_7414_;
                                                                            let _e3210 = phi_7415_;
                                                                            phi_7416_ = _e3208;
                                                                            phi_7417_ = _e3210;
                                                                            phi_7418_ = _e3112;
                                                                        }
                                                                        let _e3212 = phi_7416_;
                                                                        let _e3214 = phi_7417_;
                                                                        let _e3216 = phi_7418_;
                                                                        phi_7419_ = _e3212;
                                                                        phi_7420_ = _e3214;
                                                                        phi_7421_ = _e3071;
                                                                        phi_7422_ = _e3216;
                                                                    } else {
                                                                        phi_7419_ = array<f32, 3>();
                                                                        phi_7420_ = array<f32, 3>();
                                                                        phi_7421_ = true;
                                                                        phi_7422_ = false;
                                                                    }
                                                                    let _e3218 = phi_7419_;
                                                                    let _e3220 = phi_7420_;
                                                                    let _e3222 = phi_7421_;
                                                                    let _e3224 = phi_7422_;
                                                                    if _e3222 {
                                                                        phi_7427_ = array<f32, 3>(-1f, 0f, 0f);
                                                                    } else {
                                                                        phi_7427_ = _e3218;
                                                                    }
                                                                    let _e3226 = phi_7427_;
                                                                    if select(_e3224, true, _e3222) {
                                                                        phi_7432_ = _e3226;
                                                                    } else {
                                                                        phi_7432_ = _e3220;
                                                                    }
                                                                    let _e3229 = phi_7432_;
                                                                    let _e3233 = (_e3229[0] >= 0f);
                                                                    if _e3233 {
                                                                        let _e3234 = (_e3229[0] < 0.9999995f);
                                                                        if _e3234 {
                                                                            if _e3233 {
                                                                                if _e2860 {
                                                                                } else {
                                                                                    phi_16654_ = true;
                                                                                    phi_12546_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e3237 = triangles.member[_e2855.member_1].member_3;
                                                                                if ((_e3237 & 1u) == 0u) {
                                                                                    phi_7764_ = true;
                                                                                } else {
                                                                                    if _e2860 {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3242 = triangles.member[_e2855.member_1].member_1;
                                                                                    let _e3243 = (_e3242 * 12u);
                                                                                    if ((256u + _e3243) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 257u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 258u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3250 = (_e3243 + 259u);
                                                                                    if (_e3250 < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3253 = surfaces.member[_e3250];
                                                                                    if ((_e3243 + 260u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 261u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 262u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3260 = (_e3243 + 263u);
                                                                                    if (_e3260 < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3263 = surfaces.member[_e3260];
                                                                                    let _e3264 = (_e3243 + 264u);
                                                                                    if (_e3264 < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3267 = surfaces.member[_e3264];
                                                                                    let _e3268 = bitcast<f32>(_e3267);
                                                                                    let _e3269 = (_e3243 + 265u);
                                                                                    if (_e3269 < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3272 = surfaces.member[_e3269];
                                                                                    let _e3273 = bitcast<f32>(_e3272);
                                                                                    if ((_e3243 + 266u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 267u) < _e147) {
                                                                                    } else {
                                                                                        phi_16654_ = true;
                                                                                        phi_12546_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if (_e3253 == 4294967295u) {
                                                                                        phi_7759_ = (_e3268 < _e3273);
                                                                                    } else {
                                                                                        if (_e2855.member_1 < _e144) {
                                                                                        } else {
                                                                                            phi_16654_ = true;
                                                                                            phi_12546_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3281 = ((1f - _e3229[1]) - _e3229[2]);
                                                                                        let _e3285 = attributes.member[_e2855.member_1].member[0u];
                                                                                        let _e3290 = attributes.member[_e2855.member_1].member[2u];
                                                                                        let _e3296 = attributes.member[_e2855.member_1].member[4u];
                                                                                        let _e3298 = (((_e3285 * _e3281) + (_e3290 * _e3229[1])) + (_e3296 * _e3229[2]));
                                                                                        let _e3302 = attributes.member[_e2855.member_1].member[1u];
                                                                                        let _e3307 = attributes.member[_e2855.member_1].member[3u];
                                                                                        let _e3313 = attributes.member[_e2855.member_1].member[5u];
                                                                                        let _e3315 = (((_e3302 * _e3281) + (_e3307 * _e3229[1])) + (_e3313 * _e3229[2]));
                                                                                        let _e3316 = (_e3263 & 65535u);
                                                                                        let _e3318 = (_e3263 >> bitcast<u32>(16i));
                                                                                        let _e3320 = (_e3298 - floor(_e3298));
                                                                                        let _e3325 = ((select(0f, _e3320, (_e3320 <= 1f)) * f32(_e3316)) - 0.5f);
                                                                                        let _e3326 = floor(_e3325);
                                                                                        let _e3327 = (_e3325 - _e3326);
                                                                                        let _e3328 = (_e3316 - 1u);
                                                                                        if (_e3326 < 0f) {
                                                                                            phi_7642_ = _e3328;
                                                                                        } else {
                                                                                            let _e3334 = select(select(u32(_e3326), 0u, (_e3326 < 0f)), 4294967295u, (_e3326 > 4294967000f));
                                                                                            phi_7642_ = select(_e3334, _e3328, (_e3328 < _e3334));
                                                                                        }
                                                                                        let _e3338 = phi_7642_;
                                                                                        if (_e3338 == _e3328) {
                                                                                            phi_7648_ = 0u;
                                                                                        } else {
                                                                                            phi_7648_ = (_e3338 + 1u);
                                                                                        }
                                                                                        let _e3342 = phi_7648_;
                                                                                        let _e3344 = (_e3315 - floor(_e3315));
                                                                                        let _e3349 = ((select(0f, _e3344, (_e3344 <= 1f)) * f32(_e3318)) - 0.5f);
                                                                                        let _e3350 = floor(_e3349);
                                                                                        let _e3351 = (_e3349 - _e3350);
                                                                                        let _e3352 = (_e3318 - 1u);
                                                                                        if (_e3350 < 0f) {
                                                                                            phi_7678_ = _e3352;
                                                                                        } else {
                                                                                            let _e3358 = select(select(u32(_e3350), 0u, (_e3350 < 0f)), 4294967295u, (_e3350 > 4294967000f));
                                                                                            phi_7678_ = select(_e3358, _e3352, (_e3352 < _e3358));
                                                                                        }
                                                                                        let _e3362 = phi_7678_;
                                                                                        if (_e3362 == _e3352) {
                                                                                            phi_7684_ = 0u;
                                                                                        } else {
                                                                                            phi_7684_ = (_e3362 + 1u);
                                                                                        }
                                                                                        let _e3366 = phi_7684_;
                                                                                        let _e3368 = (_e3253 + (_e3362 * _e3316));
                                                                                        let _e3370 = (_e3253 + (_e3366 * _e3316));
                                                                                        let _e3371 = (_e3368 + _e3338);
                                                                                        let _e3372 = (_e3368 + _e3342);
                                                                                        let _e3373 = (_e3370 + _e3338);
                                                                                        let _e3374 = (_e3370 + _e3342);
                                                                                        if (_e3371 < _e147) {
                                                                                        } else {
                                                                                            phi_16654_ = true;
                                                                                            phi_12546_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3377 = surfaces.member[_e3371];
                                                                                        if (_e3372 < _e147) {
                                                                                        } else {
                                                                                            phi_16654_ = true;
                                                                                            phi_12546_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3380 = surfaces.member[_e3372];
                                                                                        if (_e3373 < _e147) {
                                                                                        } else {
                                                                                            phi_16654_ = true;
                                                                                            phi_12546_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3383 = surfaces.member[_e3373];
                                                                                        if (_e3374 < _e147) {
                                                                                        } else {
                                                                                            phi_16654_ = true;
                                                                                            phi_12546_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3386 = surfaces.member[_e3374];
                                                                                        let _e3403 = (1f - _e3327);
                                                                                        phi_7759_ = ((_e3268 * (((((f32((_e3377 >> bitcast<u32>(24i))) * 0.003921569f) * _e3403) + ((f32((_e3380 >> bitcast<u32>(24i))) * 0.003921569f) * _e3327)) * (1f - _e3351)) + ((((f32((_e3383 >> bitcast<u32>(24i))) * 0.003921569f) * _e3403) + ((f32((_e3386 >> bitcast<u32>(24i))) * 0.003921569f) * _e3327)) * _e3351))) < _e3273);
                                                                                    }
                                                                                    let _e3418 = phi_7759_;
                                                                                    phi_7764_ = select(true, false, _e3418);
                                                                                }
                                                                                let _e3421 = phi_7764_;
                                                                                if _e3421 {
                                                                                    phi_7769_ = type_47(_e3229[0], _e2855.member_1, _e3229[1], _e3229[2]);
                                                                                } else {
                                                                                    phi_7769_ = type_47();
                                                                                }
                                                                                let _e3424 = phi_7769_;
                                                                                phi_7771_ = _e3424;
                                                                                phi_7773_ = select(true, false, _e3421);
                                                                            } else {
                                                                                phi_7771_ = type_47();
                                                                                phi_7773_ = false;
                                                                            }
                                                                            let _e3427 = phi_7771_;
                                                                            let _e3429 = phi_7773_;
                                                                            phi_7774_ = _e3427;
                                                                            phi_7776_ = select(true, false, _e3233);
                                                                            phi_7777_ = _e3429;
                                                                        } else {
                                                                            phi_7774_ = type_47();
                                                                            phi_7776_ = false;
                                                                            phi_7777_ = false;
                                                                        }
                                                                        let _e3432 = phi_7774_;
                                                                        let _e3434 = phi_7776_;
                                                                        let _e3436 = phi_7777_;
                                                                        phi_7778_ = _e3432;
                                                                        phi_7779_ = select(true, false, _e3234);
                                                                        phi_7780_ = _e3434;
                                                                        phi_7781_ = _e3436;
                                                                    } else {
                                                                        phi_7778_ = type_47();
                                                                        phi_7779_ = true;
                                                                        phi_7780_ = false;
                                                                        phi_7781_ = false;
                                                                    }
                                                                    let _e3439 = phi_7778_;
                                                                    let _e3441 = phi_7779_;
                                                                    let _e3443 = phi_7780_;
                                                                    let _e3445 = phi_7781_;
                                                                    if select(select(_e3445, false, _e3441), true, select(_e3443, true, _e3441)) {
                                                                        phi_7794_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                                    } else {
                                                                        phi_7794_ = _e3439;
                                                                    }
                                                                    let _e3450 = phi_7794_;
                                                                    phi_7801_ = select(true, false, (_e3450.member_1 != 4294967295u));
                                                                } else {
                                                                    phi_7801_ = false;
                                                                }
                                                                let _e3455 = phi_7801_;
                                                                continue;
                                                                continuing {
                                                                    phi_7118_ = _e2853;
                                                                    phi_16654_ = _e2828;
                                                                    phi_12546_ = select(true, false, _e2859);
                                                                    break if !(_e3455);
                                                                }
                                                            }
                                                            let _e3459 = phi_16654_;
                                                            let _e3461 = phi_12546_;
                                                            phi_16728_ = _e3459;
                                                            phi_12547_ = bool();
                                                            if _e3459 {
                                                                break;
                                                            }
                                                            phi_16730_ = _e3459;
                                                            phi_7806_ = _e2832;
                                                            phi_7807_ = _e3461;
                                                        }
                                                        let _e3698 = phi_16730_;
                                                        let _e3700 = phi_7806_;
                                                        let _e3702 = phi_7807_;
                                                        if _e3702 {
                                                            let _e3703 = (_e3700 == 0u);
                                                            if _e3703 {
                                                                phi_7823_ = u32();
                                                                phi_7824_ = u32();
                                                            } else {
                                                                let _e3704 = (_e3700 - 1u);
                                                                if (_e3704 < 64u) {
                                                                } else {
                                                                    phi_16728_ = true;
                                                                    phi_12547_ = bool();
                                                                    break;
                                                                }
                                                                let _e3707 = local_9[_e3704];
                                                                phi_7823_ = _e3707;
                                                                phi_7824_ = _e3704;
                                                            }
                                                            let _e3709 = phi_7823_;
                                                            let _e3711 = phi_7824_;
                                                            phi_6691_ = _e3709;
                                                            phi_6694_ = _e3711;
                                                            phi_7826_ = select(true, false, _e3703);
                                                            phi_7827_ = _e3703;
                                                        } else {
                                                            phi_6691_ = u32();
                                                            phi_6694_ = u32();
                                                            phi_7826_ = false;
                                                            phi_7827_ = false;
                                                        }
                                                        let _e3714 = phi_6691_;
                                                        let _e3716 = phi_6694_;
                                                        let _e3718 = phi_7826_;
                                                        let _e3720 = phi_7827_;
                                                        continue;
                                                        continuing {
                                                            phi_16658_ = _e3698;
                                                            phi_6690_ = _e3714;
                                                            phi_6693_ = _e3716;
                                                            phi_16728_ = _e3698;
                                                            phi_12547_ = _e3720;
                                                            break if !(_e3718);
                                                        }
                                                    }
                                                    let _e3723 = phi_16728_;
                                                    let _e3725 = phi_12547_;
                                                    phi_16788_ = _e3723;
                                                    if _e3723 {
                                                        break;
                                                    }
                                                    if !(select(false, true, select(true, false, _e3725))) {
                                                        phi_7841_ = (_e2563 + _e2679);
                                                    } else {
                                                        phi_7841_ = _e2563;
                                                    }
                                                    let _e3731 = phi_7841_;
                                                    phi_16790_ = _e3723;
                                                    phi_7842_ = _e3731;
                                                } else {
                                                    phi_16790_ = _e2559;
                                                    phi_7842_ = _e2563;
                                                }
                                                let _e3733 = phi_16790_;
                                                let _e3735 = phi_7842_;
                                                phi_16789_ = _e3733;
                                                phi_6300_ = _e3735;
                                            } else {
                                                phi_16789_ = _e2559;
                                                phi_6300_ = f32();
                                            }
                                            let _e3737 = phi_16789_;
                                            let _e3739 = phi_6300_;
                                            continue;
                                            continuing {
                                                phi_16680_ = _e3737;
                                                phi_6294_ = _e2576;
                                                phi_6299_ = _e3739;
                                                phi_16788_ = _e3737;
                                                break if !(_e2582);
                                            }
                                        }
                                        let _e3742 = phi_16788_;
                                        phi_16794_ = _e3742;
                                        if _e3742 {
                                            break;
                                        }
                                        let _e3744 = local_23;
                                        if (_e3744 <= 0f) {
                                            phi_7871_ = 0f;
                                        } else {
                                            let _e3748 = local_24;
                                            phi_7871_ = (_e3748 * _e321.member_3);
                                        }
                                        let _e3751 = phi_7871_;
                                        phi_16811_ = _e3742;
                                        phi_7877_ = _e3751;
                                    }
                                    let _e3753 = phi_16811_;
                                    let _e3755 = phi_7877_;
                                    phi_16798_ = _e3753;
                                    phi_10747_ = vec3<f32>((_e321.member_6[0] * _e3755), (_e321.member_6[1] * _e3755), (_e321.member_6[2] * _e3755));
                                    phi_10748_ = vec3<f32>();
                                    phi_10749_ = true;
                                } else {
                                    let _e352 = (_e321.member_1 == 2u);
                                    if _e352 {
                                        let _e1443 = -(_e321.member_2[0]);
                                        let _e1444 = -(_e321.member_2[1]);
                                        let _e1445 = -(_e321.member_2[2]);
                                        let _e1453 = (((_e185.x * _e1443) + (_e185.y * _e1444)) + (_e185.z * _e1445));
                                        let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                        if (_e1455 > 0f) {
                                            if (_e1453 < 0f) {
                                                phi_7929_ = -(_e207);
                                            } else {
                                                phi_7929_ = _e207;
                                            }
                                            let _e1460 = phi_7929_;
                                            let _e1464 = (_e163.member[0] + (_e185.x * _e1460));
                                            let _e1465 = (_e163.member[1] + (_e185.y * _e1460));
                                            let _e1466 = (_e163.member[2] + (_e185.z * _e1460));
                                            let _e1467 = abs(_e1443);
                                            let _e1468 = abs(_e1444);
                                            let _e1469 = abs(_e1445);
                                            let _e1470 = (_e1467 > _e1468);
                                            if _e1470 {
                                                phi_7958_ = (_e1467 > _e1469);
                                            } else {
                                                phi_7958_ = (_e1468 > _e1469);
                                            }
                                            let _e1474 = phi_7958_;
                                            let _e1475 = select(1u, 0u, _e1470);
                                            if _e1474 {
                                                let _e1476 = (_e1475 + 1u);
                                                phi_7968_ = _e1476;
                                                phi_7971_ = select(true, false, (_e1476 == 2u));
                                            } else {
                                                phi_7968_ = u32();
                                                phi_7971_ = false;
                                            }
                                            let _e1480 = phi_7968_;
                                            let _e1482 = phi_7971_;
                                            let _e1483 = select(true, false, _e1474);
                                            let _e1484 = select(_e1480, 0u, _e1483);
                                            let _e1486 = select(_e1482, true, _e1483);
                                            if _e1486 {
                                                phi_7982_ = (_e1484 + 1u);
                                            } else {
                                                phi_7982_ = 0u;
                                            }
                                            let _e1489 = phi_7982_;
                                            let _e1490 = select(_e1480, _e1484, _e1486);
                                            let _e1491 = select(_e1475, select(_e1475, 2u, _e1483), _e1486);
                                            local_7 = array<f32, 3>(_e1443, _e1444, _e1445);
                                            local_8 = array<f32, 3>(_e1464, _e1465, _e1466);
                                            let _e1494 = (_e1491 < 3u);
                                            if _e1494 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1496 = local_7[_e1491];
                                            let _e1497 = (1f / _e1496);
                                            let _e1498 = (_e1490 < 3u);
                                            if _e1498 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1500 = local_7[_e1490];
                                            let _e1501 = (_e1500 * _e1497);
                                            let _e1502 = (_e1489 < 3u);
                                            if _e1502 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1504 = local_7[_e1489];
                                            let _e1505 = (_e1504 * _e1497);
                                            if _e1498 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1507 = local_8[_e1490];
                                            if _e1502 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1509 = local_8[_e1489];
                                            if _e1494 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1511 = local_8[_e1491];
                                            if (0u < _e138) {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e1516 = nodes.member[0u].member_7[0u];
                                            let _e1520 = nodes.member[0u].member_7[1u];
                                            let _e1524 = nodes.member[0u].member_7[2u];
                                            let _e1528 = nodes.member[0u].member_7[3u];
                                            let _e1530 = abs((_e1464 - _e1516));
                                            let _e1532 = abs((_e1465 - _e1520));
                                            let _e1534 = select(_e1532, _e1530, (_e1530 > _e1532));
                                            let _e1536 = abs((_e1466 - _e1524));
                                            let _e1540 = ((select(_e1536, _e1534, (_e1534 > _e1536)) + _e1528) * 0.0000009536743f);
                                            let _e1547 = (_e1540 + (abs(_e1464) * 0.00000023841858f));
                                            let _e1548 = (_e1540 + (abs(_e1465) * 0.00000023841858f));
                                            let _e1549 = (_e1540 + (abs(_e1466) * 0.00000023841858f));
                                            let _e1550 = select(_e1468, _e1467, _e1470);
                                            let _e1552 = select(_e1469, _e1550, (_e1550 > _e1469));
                                            let _e1553 = (_e1552 * 0.000000000001f);
                                            let _e1554 = (_e1464 + _e1547);
                                            let _e1555 = (_e1465 + _e1548);
                                            let _e1556 = (_e1466 + _e1549);
                                            let _e1557 = (_e1464 - _e1547);
                                            let _e1558 = (_e1465 - _e1548);
                                            let _e1559 = (_e1466 - _e1549);
                                            if (_e1467 > _e1553) {
                                                phi_8112_ = (-1f / _e321.member_2[0]);
                                            } else {
                                                phi_8112_ = (1000000000000f / _e1552);
                                            }
                                            let _e1564 = phi_8112_;
                                            if (_e1468 > _e1553) {
                                                phi_8120_ = (-1f / _e321.member_2[1]);
                                            } else {
                                                phi_8120_ = (1000000000000f / _e1552);
                                            }
                                            let _e1569 = phi_8120_;
                                            if (_e1469 > _e1553) {
                                                phi_8128_ = (-1f / _e321.member_2[2]);
                                            } else {
                                                phi_8128_ = (1000000000000f / _e1552);
                                            }
                                            let _e1574 = phi_8128_;
                                            local_6 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_16538_ = _e313;
                                            phi_8131_ = 0u;
                                            phi_8134_ = 0u;
                                            loop {
                                                let _e1576 = phi_16538_;
                                                let _e1578 = phi_8131_;
                                                let _e1580 = phi_8134_;
                                                let _e1581 = (_e1578 & 15u);
                                                let _e1583 = (_e1578 >> bitcast<u32>(4u));
                                                if (_e1581 == 0u) {
                                                    if (_e1583 < _e138) {
                                                    } else {
                                                        phi_16594_ = true;
                                                        phi_12545_ = bool();
                                                        break;
                                                    }
                                                    let _e2213 = nodes.member[_e1583].member;
                                                    let _e2222 = ((_e2213.x - _e1554) * _e1564);
                                                    let _e2223 = ((_e2213.y - _e1554) * _e1564);
                                                    let _e2224 = ((_e2213.z - _e1554) * _e1564);
                                                    let _e2225 = ((_e2213.w - _e1554) * _e1564);
                                                    let _e2228 = nodes.member[_e1583].member_3;
                                                    let _e2237 = ((_e2228.x - _e1557) * _e1564);
                                                    let _e2238 = ((_e2228.y - _e1557) * _e1564);
                                                    let _e2239 = ((_e2228.z - _e1557) * _e1564);
                                                    let _e2240 = ((_e2228.w - _e1557) * _e1564);
                                                    let _e2243 = nodes.member[_e1583].member_1;
                                                    let _e2252 = ((_e2243.x - _e1555) * _e1569);
                                                    let _e2253 = ((_e2243.y - _e1555) * _e1569);
                                                    let _e2254 = ((_e2243.z - _e1555) * _e1569);
                                                    let _e2255 = ((_e2243.w - _e1555) * _e1569);
                                                    let _e2258 = nodes.member[_e1583].member_4;
                                                    let _e2267 = ((_e2258.x - _e1558) * _e1569);
                                                    let _e2268 = ((_e2258.y - _e1558) * _e1569);
                                                    let _e2269 = ((_e2258.z - _e1558) * _e1569);
                                                    let _e2270 = ((_e2258.w - _e1558) * _e1569);
                                                    let _e2273 = nodes.member[_e1583].member_2;
                                                    let _e2282 = ((_e2273.x - _e1556) * _e1574);
                                                    let _e2283 = ((_e2273.y - _e1556) * _e1574);
                                                    let _e2284 = ((_e2273.z - _e1556) * _e1574);
                                                    let _e2285 = ((_e2273.w - _e1556) * _e1574);
                                                    let _e2288 = nodes.member[_e1583].member_5;
                                                    let _e2297 = ((_e2288.x - _e1559) * _e1574);
                                                    let _e2298 = ((_e2288.y - _e1559) * _e1574);
                                                    let _e2299 = ((_e2288.z - _e1559) * _e1574);
                                                    let _e2300 = ((_e2288.w - _e1559) * _e1574);
                                                    let _e2302 = select(_e2237, _e2222, (_e2222 < _e2237));
                                                    let _e2304 = select(_e2238, _e2223, (_e2223 < _e2238));
                                                    let _e2306 = select(_e2239, _e2224, (_e2224 < _e2239));
                                                    let _e2308 = select(_e2240, _e2225, (_e2225 < _e2240));
                                                    let _e2310 = select(_e2267, _e2252, (_e2252 < _e2267));
                                                    let _e2312 = select(_e2268, _e2253, (_e2253 < _e2268));
                                                    let _e2314 = select(_e2269, _e2254, (_e2254 < _e2269));
                                                    let _e2316 = select(_e2270, _e2255, (_e2255 < _e2270));
                                                    let _e2318 = select(_e2310, _e2302, (_e2302 > _e2310));
                                                    let _e2320 = select(_e2312, _e2304, (_e2304 > _e2312));
                                                    let _e2322 = select(_e2314, _e2306, (_e2306 > _e2314));
                                                    let _e2324 = select(_e2316, _e2308, (_e2308 > _e2316));
                                                    let _e2326 = select(_e2297, _e2282, (_e2282 < _e2297));
                                                    let _e2328 = select(_e2298, _e2283, (_e2283 < _e2298));
                                                    let _e2330 = select(_e2299, _e2284, (_e2284 < _e2299));
                                                    let _e2332 = select(_e2300, _e2285, (_e2285 < _e2300));
                                                    let _e2334 = select(_e2326, _e2318, (_e2318 > _e2326));
                                                    let _e2336 = select(_e2328, _e2320, (_e2320 > _e2328));
                                                    let _e2338 = select(_e2330, _e2322, (_e2322 > _e2330));
                                                    let _e2340 = select(_e2332, _e2324, (_e2324 > _e2332));
                                                    let _e2342 = select(0f, _e2334, (_e2334 > 0f));
                                                    let _e2344 = select(0f, _e2336, (_e2336 > 0f));
                                                    let _e2346 = select(0f, _e2338, (_e2338 > 0f));
                                                    let _e2348 = select(0f, _e2340, (_e2340 > 0f));
                                                    let _e2350 = select(_e2237, _e2222, (_e2222 > _e2237));
                                                    let _e2352 = select(_e2238, _e2223, (_e2223 > _e2238));
                                                    let _e2354 = select(_e2239, _e2224, (_e2224 > _e2239));
                                                    let _e2356 = select(_e2240, _e2225, (_e2225 > _e2240));
                                                    let _e2358 = select(_e2267, _e2252, (_e2252 > _e2267));
                                                    let _e2360 = select(_e2268, _e2253, (_e2253 > _e2268));
                                                    let _e2362 = select(_e2269, _e2254, (_e2254 > _e2269));
                                                    let _e2364 = select(_e2270, _e2255, (_e2255 > _e2270));
                                                    let _e2366 = select(_e2358, _e2350, (_e2350 < _e2358));
                                                    let _e2368 = select(_e2360, _e2352, (_e2352 < _e2360));
                                                    let _e2370 = select(_e2362, _e2354, (_e2354 < _e2362));
                                                    let _e2372 = select(_e2364, _e2356, (_e2356 < _e2364));
                                                    let _e2374 = select(_e2297, _e2282, (_e2282 > _e2297));
                                                    let _e2376 = select(_e2298, _e2283, (_e2283 > _e2298));
                                                    let _e2378 = select(_e2299, _e2284, (_e2284 > _e2299));
                                                    let _e2380 = select(_e2300, _e2285, (_e2285 > _e2300));
                                                    let _e2382 = select(_e2374, _e2366, (_e2366 < _e2374));
                                                    let _e2384 = select(_e2376, _e2368, (_e2368 < _e2376));
                                                    let _e2386 = select(_e2378, _e2370, (_e2370 < _e2378));
                                                    let _e2388 = select(_e2380, _e2372, (_e2372 < _e2380));
                                                    let _e2408 = nodes.member[_e1583].member_6[0u];
                                                    let _e2412 = nodes.member[_e1583].member_6[1u];
                                                    let _e2416 = nodes.member[_e1583].member_6[2u];
                                                    let _e2420 = nodes.member[_e1583].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e2348, (_e2348 <= select(340282350000000000000000000000000000000f, _e2388, (_e2388 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1580 < 64u) {
                                                        } else {
                                                            phi_16594_ = true;
                                                            phi_12545_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e1580] = _e2420;
                                                        phi_8519_ = (_e1580 + 1u);
                                                    } else {
                                                        phi_8519_ = _e1580;
                                                    }
                                                    let _e2426 = phi_8519_;
                                                    if (select(340282350000000000000000000000000000000f, _e2346, (_e2346 <= select(340282350000000000000000000000000000000f, _e2386, (_e2386 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2426 < 64u) {
                                                        } else {
                                                            phi_16594_ = true;
                                                            phi_12545_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e2426] = _e2416;
                                                        phi_8531_ = (_e2426 + 1u);
                                                    } else {
                                                        phi_8531_ = _e2426;
                                                    }
                                                    let _e2432 = phi_8531_;
                                                    if (select(340282350000000000000000000000000000000f, _e2344, (_e2344 <= select(340282350000000000000000000000000000000f, _e2384, (_e2384 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2432 < 64u) {
                                                        } else {
                                                            phi_16594_ = true;
                                                            phi_12545_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e2432] = _e2412;
                                                        phi_8543_ = (_e2432 + 1u);
                                                    } else {
                                                        phi_8543_ = _e2432;
                                                    }
                                                    let _e2438 = phi_8543_;
                                                    if (select(340282350000000000000000000000000000000f, _e2342, (_e2342 <= select(340282350000000000000000000000000000000f, _e2382, (_e2382 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2438 < 64u) {
                                                        } else {
                                                            phi_16594_ = true;
                                                            phi_12545_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e2438] = _e2408;
                                                        phi_8555_ = (_e2438 + 1u);
                                                    } else {
                                                        phi_8555_ = _e2438;
                                                    }
                                                    let _e2444 = phi_8555_;
                                                    phi_16596_ = _e1576;
                                                    phi_9247_ = _e2444;
                                                    phi_9248_ = true;
                                                } else {
                                                    phi_8559_ = type_9(_e1583, (_e1583 + _e1581));
                                                    loop {
                                                        let _e1588 = phi_8559_;
                                                        if (_e1588.member < _e1588.member_1) {
                                                            phi_8560_ = type_9((_e1588.member + 1u), _e1588.member_1);
                                                            phi_8583_ = type_9(1u, _e1588.member);
                                                        } else {
                                                            phi_8560_ = _e1588;
                                                            phi_8583_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e1601 = phi_8560_;
                                                        let _e1603 = phi_8583_;
                                                        let _e1607 = (bitcast<i32>(_e1603.member) != 0i);
                                                        if _e1607 {
                                                            let _e1608 = (_e1603.member_1 < _e141);
                                                            if _e1608 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            if _e1494 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1612 = triangles.member[_e1603.member_1].member[_e1491];
                                                            let _e1613 = (_e1612 - _e1511);
                                                            if _e1494 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1617 = triangles.member[_e1603.member_1].member_2[_e1491];
                                                            let _e1618 = (_e1617 - _e1511);
                                                            if _e1494 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1622 = triangles.member[_e1603.member_1].member_4[_e1491];
                                                            let _e1623 = (_e1622 - _e1511);
                                                            if _e1498 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1627 = triangles.member[_e1603.member_1].member[_e1490];
                                                            let _e1630 = ((_e1627 - _e1507) - (_e1501 * _e1613));
                                                            if _e1502 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1634 = triangles.member[_e1603.member_1].member[_e1489];
                                                            let _e1637 = ((_e1634 - _e1509) - (_e1505 * _e1613));
                                                            if _e1498 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1641 = triangles.member[_e1603.member_1].member_2[_e1490];
                                                            let _e1644 = ((_e1641 - _e1507) - (_e1501 * _e1618));
                                                            if _e1502 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1648 = triangles.member[_e1603.member_1].member_2[_e1489];
                                                            let _e1651 = ((_e1648 - _e1509) - (_e1505 * _e1618));
                                                            if _e1498 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1655 = triangles.member[_e1603.member_1].member_4[_e1490];
                                                            let _e1658 = ((_e1655 - _e1507) - (_e1501 * _e1623));
                                                            if _e1502 {
                                                            } else {
                                                                phi_16534_ = true;
                                                                phi_12544_ = bool();
                                                                break;
                                                            }
                                                            let _e1662 = triangles.member[_e1603.member_1].member_4[_e1489];
                                                            let _e1665 = ((_e1662 - _e1509) - (_e1505 * _e1623));
                                                            let _e1666 = (_e1658 * _e1651);
                                                            let _e1667 = (_e1665 * _e1644);
                                                            if (_e1666 != _e1667) {
                                                                phi_8699_ = (_e1666 - _e1667);
                                                            } else {
                                                                let _e1669 = (_e1658 * 4097f);
                                                                let _e1671 = (_e1669 - (_e1669 - _e1658));
                                                                let _e1672 = (_e1651 * 4097f);
                                                                let _e1674 = (_e1672 - (_e1672 - _e1651));
                                                                let _e1675 = (_e1658 - _e1671);
                                                                let _e1676 = (_e1651 - _e1674);
                                                                let _e1685 = (_e1665 * 4097f);
                                                                let _e1687 = (_e1685 - (_e1685 - _e1665));
                                                                let _e1688 = (_e1644 * 4097f);
                                                                let _e1690 = (_e1688 - (_e1688 - _e1644));
                                                                let _e1691 = (_e1665 - _e1687);
                                                                let _e1692 = (_e1644 - _e1690);
                                                                phi_8699_ = ((((((_e1671 * _e1674) - _e1666) + (_e1671 * _e1676)) + (_e1675 * _e1674)) + (_e1675 * _e1676)) - (((((_e1687 * _e1690) - _e1667) + (_e1687 * _e1692)) + (_e1691 * _e1690)) + (_e1691 * _e1692)));
                                                            }
                                                            let _e1704 = phi_8699_;
                                                            let _e1705 = (_e1630 * _e1665);
                                                            let _e1706 = (_e1637 * _e1658);
                                                            if (_e1705 != _e1706) {
                                                                phi_8710_ = (_e1705 - _e1706);
                                                            } else {
                                                                let _e1708 = (_e1630 * 4097f);
                                                                let _e1710 = (_e1708 - (_e1708 - _e1630));
                                                                let _e1711 = (_e1665 * 4097f);
                                                                let _e1713 = (_e1711 - (_e1711 - _e1665));
                                                                let _e1714 = (_e1630 - _e1710);
                                                                let _e1715 = (_e1665 - _e1713);
                                                                let _e1724 = (_e1637 * 4097f);
                                                                let _e1726 = (_e1724 - (_e1724 - _e1637));
                                                                let _e1727 = (_e1658 * 4097f);
                                                                let _e1729 = (_e1727 - (_e1727 - _e1658));
                                                                let _e1730 = (_e1637 - _e1726);
                                                                let _e1731 = (_e1658 - _e1729);
                                                                phi_8710_ = ((((((_e1710 * _e1713) - _e1705) + (_e1710 * _e1715)) + (_e1714 * _e1713)) + (_e1714 * _e1715)) - (((((_e1726 * _e1729) - _e1706) + (_e1726 * _e1731)) + (_e1730 * _e1729)) + (_e1730 * _e1731)));
                                                            }
                                                            let _e1743 = phi_8710_;
                                                            let _e1744 = (_e1644 * _e1637);
                                                            let _e1745 = (_e1651 * _e1630);
                                                            if (_e1744 != _e1745) {
                                                                phi_8721_ = (_e1744 - _e1745);
                                                            } else {
                                                                let _e1747 = (_e1644 * 4097f);
                                                                let _e1749 = (_e1747 - (_e1747 - _e1644));
                                                                let _e1750 = (_e1637 * 4097f);
                                                                let _e1752 = (_e1750 - (_e1750 - _e1637));
                                                                let _e1753 = (_e1644 - _e1749);
                                                                let _e1754 = (_e1637 - _e1752);
                                                                let _e1763 = (_e1651 * 4097f);
                                                                let _e1765 = (_e1763 - (_e1763 - _e1651));
                                                                let _e1766 = (_e1630 * 4097f);
                                                                let _e1768 = (_e1766 - (_e1766 - _e1630));
                                                                let _e1769 = (_e1651 - _e1765);
                                                                let _e1770 = (_e1630 - _e1768);
                                                                phi_8721_ = ((((((_e1749 * _e1752) - _e1744) + (_e1749 * _e1754)) + (_e1753 * _e1752)) + (_e1753 * _e1754)) - (((((_e1765 * _e1768) - _e1745) + (_e1765 * _e1770)) + (_e1769 * _e1768)) + (_e1769 * _e1770)));
                                                            }
                                                            let _e1782 = phi_8721_;
                                                            if (_e1704 < 0f) {
                                                                phi_8739_ = f32();
                                                                phi_8740_ = true;
                                                            } else {
                                                                if (_e1743 < 0f) {
                                                                    phi_8737_ = f32();
                                                                    phi_8738_ = true;
                                                                } else {
                                                                    let _e1785 = (_e1782 < 0f);
                                                                    if _e1785 {
                                                                        phi_8736_ = f32();
                                                                    } else {
                                                                        phi_8736_ = ((_e1704 + _e1743) + _e1782);
                                                                    }
                                                                    let _e1789 = phi_8736_;
                                                                    phi_8737_ = _e1789;
                                                                    phi_8738_ = _e1785;
                                                                }
                                                                let _e1791 = phi_8737_;
                                                                let _e1793 = phi_8738_;
                                                                phi_8739_ = _e1791;
                                                                phi_8740_ = _e1793;
                                                            }
                                                            let _e1795 = phi_8739_;
                                                            let _e1797 = phi_8740_;
                                                            if _e1797 {
                                                                if (_e1704 > 0f) {
                                                                    phi_8761_ = f32();
                                                                    phi_8762_ = true;
                                                                    phi_8763_ = false;
                                                                } else {
                                                                    let _e1799 = (_e1743 > 0f);
                                                                    if _e1799 {
                                                                        phi_8759_ = f32();
                                                                        phi_8760_ = false;
                                                                    } else {
                                                                        phi_8759_ = ((_e1704 + _e1743) + _e1782);
                                                                        phi_8760_ = select(true, false, (_e1782 > 0f));
                                                                    }
                                                                    let _e1805 = phi_8759_;
                                                                    let _e1807 = phi_8760_;
                                                                    phi_8761_ = _e1805;
                                                                    phi_8762_ = _e1799;
                                                                    phi_8763_ = _e1807;
                                                                }
                                                                let _e1809 = phi_8761_;
                                                                let _e1811 = phi_8762_;
                                                                let _e1813 = phi_8763_;
                                                                phi_8768_ = _e1809;
                                                                phi_8769_ = select(_e1813, false, _e1811);
                                                            } else {
                                                                phi_8768_ = _e1795;
                                                                phi_8769_ = true;
                                                            }
                                                            let _e1816 = phi_8768_;
                                                            let _e1818 = phi_8769_;
                                                            if _e1818 {
                                                                let _e1819 = (_e1816 == 0f);
                                                                if _e1819 {
                                                                    phi_8857_ = array<f32, 3>();
                                                                    phi_8858_ = array<f32, 3>();
                                                                    phi_8859_ = false;
                                                                } else {
                                                                    let _e1820 = (_e1613 * _e1497);
                                                                    let _e1821 = (_e1618 * _e1497);
                                                                    let _e1822 = (_e1623 * _e1497);
                                                                    let _e1825 = (1f / ((_e1704 + _e1743) + _e1782));
                                                                    let _e1826 = (_e1743 * _e1825);
                                                                    let _e1827 = (_e1782 * _e1825);
                                                                    let _e1833 = ((((_e1704 * _e1825) * _e1820) + (_e1826 * _e1821)) + (_e1827 * _e1822));
                                                                    let _e1834 = abs(_e1630);
                                                                    let _e1835 = abs(_e1644);
                                                                    let _e1837 = select(_e1835, _e1834, (_e1834 > _e1835));
                                                                    let _e1838 = abs(_e1658);
                                                                    let _e1841 = abs(_e1637);
                                                                    let _e1842 = abs(_e1651);
                                                                    let _e1844 = select(_e1842, _e1841, (_e1841 > _e1842));
                                                                    let _e1845 = abs(_e1665);
                                                                    let _e1849 = abs(_e1820);
                                                                    let _e1850 = abs(_e1821);
                                                                    let _e1852 = select(_e1850, _e1849, (_e1849 > _e1850));
                                                                    let _e1853 = abs(_e1822);
                                                                    let _e1860 = (((select(_e1838, _e1837, (_e1837 > _e1838)) * select(_e1845, _e1844, (_e1844 > _e1845))) * select(_e1853, _e1852, (_e1852 > _e1853))) <= (abs((_e1816 * _e1833)) * 256f));
                                                                    if _e1860 {
                                                                        phi_8855_ = array<f32, 3>(_e1833, _e1826, _e1827);
                                                                        phi_8856_ = array<f32, 3>();
                                                                    } else {
                                                                        let _e1862 = (_e1658 * 4097f);
                                                                        let _e1864 = (_e1862 - (_e1862 - _e1658));
                                                                        let _e1865 = (_e1651 * 4097f);
                                                                        let _e1867 = (_e1865 - (_e1865 - _e1651));
                                                                        let _e1868 = (_e1658 - _e1864);
                                                                        let _e1869 = (_e1651 - _e1867);
                                                                        let _e1878 = (_e1665 * 4097f);
                                                                        let _e1880 = (_e1878 - (_e1878 - _e1665));
                                                                        let _e1881 = (_e1644 * 4097f);
                                                                        let _e1883 = (_e1881 - (_e1881 - _e1644));
                                                                        let _e1884 = (_e1665 - _e1880);
                                                                        let _e1885 = (_e1644 - _e1883);
                                                                        let _e1895 = ((_e1666 - _e1667) + ((((((_e1864 * _e1867) - _e1666) + (_e1864 * _e1869)) + (_e1868 * _e1867)) + (_e1868 * _e1869)) - (((((_e1880 * _e1883) - _e1667) + (_e1880 * _e1885)) + (_e1884 * _e1883)) + (_e1884 * _e1885))));
                                                                        let _e1897 = (_e1630 * 4097f);
                                                                        let _e1899 = (_e1897 - (_e1897 - _e1630));
                                                                        let _e1900 = (_e1630 - _e1899);
                                                                        let _e1909 = (_e1637 * 4097f);
                                                                        let _e1911 = (_e1909 - (_e1909 - _e1637));
                                                                        let _e1912 = (_e1637 - _e1911);
                                                                        let _e1922 = ((_e1705 - _e1706) + ((((((_e1899 * _e1880) - _e1705) + (_e1899 * _e1884)) + (_e1900 * _e1880)) + (_e1900 * _e1884)) - (((((_e1911 * _e1864) - _e1706) + (_e1911 * _e1868)) + (_e1912 * _e1864)) + (_e1912 * _e1868))));
                                                                        let _e1941 = ((_e1744 - _e1745) + ((((((_e1883 * _e1911) - _e1744) + (_e1883 * _e1912)) + (_e1885 * _e1911)) + (_e1885 * _e1912)) - (((((_e1867 * _e1899) - _e1745) + (_e1867 * _e1900)) + (_e1869 * _e1899)) + (_e1869 * _e1900))));
                                                                        let _e1944 = (1f / ((_e1895 + _e1922) + _e1941));
                                                                        let _e1945 = (_e1922 * _e1944);
                                                                        let _e1946 = (_e1941 * _e1944);
                                                                        phi_8855_ = array<f32, 3>();
                                                                        phi_8856_ = array<f32, 3>(((((_e1895 * _e1944) * _e1820) + (_e1945 * _e1821)) + (_e1946 * _e1822)), _e1945, _e1946);
                                                                    }
                                                                    let _e1956 = phi_8855_;
                                                                    let _e1958 = phi_8856_;
                                                                    phi_8857_ = _e1956;
                                                                    phi_8858_ = _e1958;
                                                                    phi_8859_ = _e1860;
                                                                }
                                                                let _e1960 = phi_8857_;
                                                                let _e1962 = phi_8858_;
                                                                let _e1964 = phi_8859_;
                                                                phi_8860_ = _e1960;
                                                                phi_8861_ = _e1962;
                                                                phi_8862_ = _e1819;
                                                                phi_8863_ = _e1964;
                                                            } else {
                                                                phi_8860_ = array<f32, 3>();
                                                                phi_8861_ = array<f32, 3>();
                                                                phi_8862_ = true;
                                                                phi_8863_ = false;
                                                            }
                                                            let _e1966 = phi_8860_;
                                                            let _e1968 = phi_8861_;
                                                            let _e1970 = phi_8862_;
                                                            let _e1972 = phi_8863_;
                                                            if _e1970 {
                                                                phi_8868_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_8868_ = _e1966;
                                                            }
                                                            let _e1974 = phi_8868_;
                                                            if select(_e1972, true, _e1970) {
                                                                phi_8873_ = _e1974;
                                                            } else {
                                                                phi_8873_ = _e1968;
                                                            }
                                                            let _e1977 = phi_8873_;
                                                            let _e1981 = (_e1977[0] >= 0f);
                                                            if _e1981 {
                                                                let _e1982 = (_e1977[0] < 340282350000000000000000000000000000000f);
                                                                if _e1982 {
                                                                    if _e1981 {
                                                                        if _e1608 {
                                                                        } else {
                                                                            phi_16534_ = true;
                                                                            phi_12544_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1985 = triangles.member[_e1603.member_1].member_3;
                                                                        if ((_e1985 & 1u) == 0u) {
                                                                            phi_9205_ = true;
                                                                        } else {
                                                                            if _e1608 {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1990 = triangles.member[_e1603.member_1].member_1;
                                                                            let _e1991 = (_e1990 * 12u);
                                                                            if ((256u + _e1991) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 257u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 258u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1998 = (_e1991 + 259u);
                                                                            if (_e1998 < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2001 = surfaces.member[_e1998];
                                                                            if ((_e1991 + 260u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 261u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 262u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2008 = (_e1991 + 263u);
                                                                            if (_e2008 < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2011 = surfaces.member[_e2008];
                                                                            let _e2012 = (_e1991 + 264u);
                                                                            if (_e2012 < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2015 = surfaces.member[_e2012];
                                                                            let _e2016 = bitcast<f32>(_e2015);
                                                                            let _e2017 = (_e1991 + 265u);
                                                                            if (_e2017 < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2020 = surfaces.member[_e2017];
                                                                            let _e2021 = bitcast<f32>(_e2020);
                                                                            if ((_e1991 + 266u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 267u) < _e147) {
                                                                            } else {
                                                                                phi_16534_ = true;
                                                                                phi_12544_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e2001 == 4294967295u) {
                                                                                phi_9200_ = (_e2016 < _e2021);
                                                                            } else {
                                                                                if (_e1603.member_1 < _e144) {
                                                                                } else {
                                                                                    phi_16534_ = true;
                                                                                    phi_12544_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2029 = ((1f - _e1977[1]) - _e1977[2]);
                                                                                let _e2033 = attributes.member[_e1603.member_1].member[0u];
                                                                                let _e2038 = attributes.member[_e1603.member_1].member[2u];
                                                                                let _e2044 = attributes.member[_e1603.member_1].member[4u];
                                                                                let _e2046 = (((_e2033 * _e2029) + (_e2038 * _e1977[1])) + (_e2044 * _e1977[2]));
                                                                                let _e2050 = attributes.member[_e1603.member_1].member[1u];
                                                                                let _e2055 = attributes.member[_e1603.member_1].member[3u];
                                                                                let _e2061 = attributes.member[_e1603.member_1].member[5u];
                                                                                let _e2063 = (((_e2050 * _e2029) + (_e2055 * _e1977[1])) + (_e2061 * _e1977[2]));
                                                                                let _e2064 = (_e2011 & 65535u);
                                                                                let _e2066 = (_e2011 >> bitcast<u32>(16i));
                                                                                let _e2068 = (_e2046 - floor(_e2046));
                                                                                let _e2073 = ((select(0f, _e2068, (_e2068 <= 1f)) * f32(_e2064)) - 0.5f);
                                                                                let _e2074 = floor(_e2073);
                                                                                let _e2075 = (_e2073 - _e2074);
                                                                                let _e2076 = (_e2064 - 1u);
                                                                                if (_e2074 < 0f) {
                                                                                    phi_9083_ = _e2076;
                                                                                } else {
                                                                                    let _e2082 = select(select(u32(_e2074), 0u, (_e2074 < 0f)), 4294967295u, (_e2074 > 4294967000f));
                                                                                    phi_9083_ = select(_e2082, _e2076, (_e2076 < _e2082));
                                                                                }
                                                                                let _e2086 = phi_9083_;
                                                                                if (_e2086 == _e2076) {
                                                                                    phi_9089_ = 0u;
                                                                                } else {
                                                                                    phi_9089_ = (_e2086 + 1u);
                                                                                }
                                                                                let _e2090 = phi_9089_;
                                                                                let _e2092 = (_e2063 - floor(_e2063));
                                                                                let _e2097 = ((select(0f, _e2092, (_e2092 <= 1f)) * f32(_e2066)) - 0.5f);
                                                                                let _e2098 = floor(_e2097);
                                                                                let _e2099 = (_e2097 - _e2098);
                                                                                let _e2100 = (_e2066 - 1u);
                                                                                if (_e2098 < 0f) {
                                                                                    phi_9119_ = _e2100;
                                                                                } else {
                                                                                    let _e2106 = select(select(u32(_e2098), 0u, (_e2098 < 0f)), 4294967295u, (_e2098 > 4294967000f));
                                                                                    phi_9119_ = select(_e2106, _e2100, (_e2100 < _e2106));
                                                                                }
                                                                                let _e2110 = phi_9119_;
                                                                                if (_e2110 == _e2100) {
                                                                                    phi_9125_ = 0u;
                                                                                } else {
                                                                                    phi_9125_ = (_e2110 + 1u);
                                                                                }
                                                                                let _e2114 = phi_9125_;
                                                                                let _e2116 = (_e2001 + (_e2110 * _e2064));
                                                                                let _e2118 = (_e2001 + (_e2114 * _e2064));
                                                                                let _e2119 = (_e2116 + _e2086);
                                                                                let _e2120 = (_e2116 + _e2090);
                                                                                let _e2121 = (_e2118 + _e2086);
                                                                                let _e2122 = (_e2118 + _e2090);
                                                                                if (_e2119 < _e147) {
                                                                                } else {
                                                                                    phi_16534_ = true;
                                                                                    phi_12544_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2125 = surfaces.member[_e2119];
                                                                                if (_e2120 < _e147) {
                                                                                } else {
                                                                                    phi_16534_ = true;
                                                                                    phi_12544_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2128 = surfaces.member[_e2120];
                                                                                if (_e2121 < _e147) {
                                                                                } else {
                                                                                    phi_16534_ = true;
                                                                                    phi_12544_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2131 = surfaces.member[_e2121];
                                                                                if (_e2122 < _e147) {
                                                                                } else {
                                                                                    phi_16534_ = true;
                                                                                    phi_12544_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2134 = surfaces.member[_e2122];
                                                                                let _e2151 = (1f - _e2075);
                                                                                phi_9200_ = ((_e2016 * (((((f32((_e2125 >> bitcast<u32>(24i))) * 0.003921569f) * _e2151) + ((f32((_e2128 >> bitcast<u32>(24i))) * 0.003921569f) * _e2075)) * (1f - _e2099)) + ((((f32((_e2131 >> bitcast<u32>(24i))) * 0.003921569f) * _e2151) + ((f32((_e2134 >> bitcast<u32>(24i))) * 0.003921569f) * _e2075)) * _e2099))) < _e2021);
                                                                            }
                                                                            let _e2166 = phi_9200_;
                                                                            phi_9205_ = select(true, false, _e2166);
                                                                        }
                                                                        let _e2169 = phi_9205_;
                                                                        if _e2169 {
                                                                            phi_9210_ = type_47(_e1977[0], _e1603.member_1, _e1977[1], _e1977[2]);
                                                                        } else {
                                                                            phi_9210_ = type_47();
                                                                        }
                                                                        let _e2172 = phi_9210_;
                                                                        phi_9212_ = _e2172;
                                                                        phi_9214_ = select(true, false, _e2169);
                                                                    } else {
                                                                        phi_9212_ = type_47();
                                                                        phi_9214_ = false;
                                                                    }
                                                                    let _e2175 = phi_9212_;
                                                                    let _e2177 = phi_9214_;
                                                                    phi_9215_ = _e2175;
                                                                    phi_9217_ = select(true, false, _e1981);
                                                                    phi_9218_ = _e2177;
                                                                } else {
                                                                    phi_9215_ = type_47();
                                                                    phi_9217_ = false;
                                                                    phi_9218_ = false;
                                                                }
                                                                let _e2180 = phi_9215_;
                                                                let _e2182 = phi_9217_;
                                                                let _e2184 = phi_9218_;
                                                                phi_9219_ = _e2180;
                                                                phi_9220_ = select(true, false, _e1982);
                                                                phi_9221_ = _e2182;
                                                                phi_9222_ = _e2184;
                                                            } else {
                                                                phi_9219_ = type_47();
                                                                phi_9220_ = true;
                                                                phi_9221_ = false;
                                                                phi_9222_ = false;
                                                            }
                                                            let _e2187 = phi_9219_;
                                                            let _e2189 = phi_9220_;
                                                            let _e2191 = phi_9221_;
                                                            let _e2193 = phi_9222_;
                                                            if select(select(_e2193, false, _e2189), true, select(_e2191, true, _e2189)) {
                                                                phi_9235_ = type_47(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_9235_ = _e2187;
                                                            }
                                                            let _e2198 = phi_9235_;
                                                            phi_9242_ = select(true, false, (_e2198.member_1 != 4294967295u));
                                                        } else {
                                                            phi_9242_ = false;
                                                        }
                                                        let _e2203 = phi_9242_;
                                                        continue;
                                                        continuing {
                                                            phi_8559_ = _e1601;
                                                            phi_16534_ = _e1576;
                                                            phi_12544_ = select(true, false, _e1607);
                                                            break if !(_e2203);
                                                        }
                                                    }
                                                    let _e2207 = phi_16534_;
                                                    let _e2209 = phi_12544_;
                                                    phi_16594_ = _e2207;
                                                    phi_12545_ = bool();
                                                    if _e2207 {
                                                        break;
                                                    }
                                                    phi_16596_ = _e2207;
                                                    phi_9247_ = _e1580;
                                                    phi_9248_ = _e2209;
                                                }
                                                let _e2446 = phi_16596_;
                                                let _e2448 = phi_9247_;
                                                let _e2450 = phi_9248_;
                                                if _e2450 {
                                                    let _e2451 = (_e2448 == 0u);
                                                    if _e2451 {
                                                        phi_9264_ = u32();
                                                        phi_9265_ = u32();
                                                    } else {
                                                        let _e2452 = (_e2448 - 1u);
                                                        if (_e2452 < 64u) {
                                                        } else {
                                                            phi_16594_ = true;
                                                            phi_12545_ = bool();
                                                            break;
                                                        }
                                                        let _e2455 = local_6[_e2452];
                                                        phi_9264_ = _e2455;
                                                        phi_9265_ = _e2452;
                                                    }
                                                    let _e2457 = phi_9264_;
                                                    let _e2459 = phi_9265_;
                                                    phi_8132_ = _e2457;
                                                    phi_8135_ = _e2459;
                                                    phi_9267_ = select(true, false, _e2451);
                                                    phi_9268_ = _e2451;
                                                } else {
                                                    phi_8132_ = u32();
                                                    phi_8135_ = u32();
                                                    phi_9267_ = false;
                                                    phi_9268_ = false;
                                                }
                                                let _e2462 = phi_8132_;
                                                let _e2464 = phi_8135_;
                                                let _e2466 = phi_9267_;
                                                let _e2468 = phi_9268_;
                                                continue;
                                                continuing {
                                                    phi_16538_ = _e2446;
                                                    phi_8131_ = _e2462;
                                                    phi_8134_ = _e2464;
                                                    phi_16594_ = _e2446;
                                                    phi_12545_ = _e2468;
                                                    break if !(_e2466);
                                                }
                                            }
                                            let _e2471 = phi_16594_;
                                            let _e2473 = phi_12545_;
                                            phi_16794_ = _e2471;
                                            if _e2471 {
                                                break;
                                            }
                                            let _e2475 = select(false, true, select(true, false, _e2473));
                                            if _e2475 {
                                                phi_9284_ = vec3<f32>();
                                            } else {
                                                phi_9284_ = vec3<f32>((_e321.member_6[0] * _e1455), (_e321.member_6[1] * _e1455), (_e321.member_6[2] * _e1455));
                                            }
                                            let _e2481 = phi_9284_;
                                            phi_16806_ = _e2471;
                                            phi_9285_ = _e2481;
                                            phi_9286_ = _e2475;
                                        } else {
                                            phi_16806_ = _e313;
                                            phi_9285_ = vec3<f32>();
                                            phi_9286_ = true;
                                        }
                                        let _e2483 = phi_16806_;
                                        let _e2485 = phi_9285_;
                                        let _e2487 = phi_9286_;
                                        phi_16799_ = _e2483;
                                        phi_10745_ = select(_e2485, vec3<f32>(0f, 0f, 0f), vec3(_e2487));
                                        phi_10746_ = vec3<f32>();
                                    } else {
                                        let _e353 = (_e321.member[0] - _e163.member[0]);
                                        let _e354 = (_e321.member[1] - _e163.member[1]);
                                        let _e355 = (_e321.member[2] - _e163.member[2]);
                                        let _e361 = sqrt((((_e353 * _e353) + (_e354 * _e354)) + (_e355 * _e355)));
                                        let _e369 = (((_e185.x * _e353) + (_e185.y * _e354)) + (_e185.z * _e355));
                                        let _e373 = ((_e361 * _e361) * _e361);
                                        let _e376 = (select(0f, _e369, (_e369 > 0f)) / select(0.000000000000000000000000000000000000011754944f, _e373, (_e373 > 0.000000000000000000000000000000000000011754944f)));
                                        if (_e321.member_1 == 1u) {
                                            let _e392 = (_e321.member_4[0] - _e321.member_4[1]);
                                            let _e395 = (((-((((_e353 * _e321.member_2[0]) + (_e354 * _e321.member_2[1])) + (_e355 * _e321.member_2[2]))) / select(0.000000000000000000000000000000000000011754944f, _e361, (_e361 > 0.000000000000000000000000000000000000011754944f))) - _e321.member_4[1]) / select(0.001f, _e392, (_e392 > 0.001f)));
                                            let _e397 = select(0f, _e395, (_e395 > 0f));
                                            let _e399 = select(1f, _e397, (_e397 < 1f));
                                            phi_9360_ = (_e376 * (_e399 * _e399));
                                        } else {
                                            phi_9360_ = _e376;
                                        }
                                        let _e403 = phi_9360_;
                                        if (_e403 > 0f) {
                                            if (_e369 < 0f) {
                                                phi_9381_ = -(_e207);
                                            } else {
                                                phi_9381_ = _e207;
                                            }
                                            let _e408 = phi_9381_;
                                            let _e412 = (_e163.member[0] + (_e185.x * _e408));
                                            let _e413 = (_e163.member[1] + (_e185.y * _e408));
                                            let _e414 = (_e163.member[2] + (_e185.z * _e408));
                                            let _e415 = (_e321.member[0] - _e412);
                                            let _e416 = (_e321.member[1] - _e413);
                                            let _e417 = (_e321.member[2] - _e414);
                                            let _e418 = abs(_e415);
                                            let _e419 = abs(_e416);
                                            let _e420 = abs(_e417);
                                            let _e421 = (_e418 > _e419);
                                            if _e421 {
                                                phi_9410_ = (_e418 > _e420);
                                            } else {
                                                phi_9410_ = (_e419 > _e420);
                                            }
                                            let _e425 = phi_9410_;
                                            let _e426 = select(1u, 0u, _e421);
                                            if _e425 {
                                                let _e427 = (_e426 + 1u);
                                                phi_9420_ = _e427;
                                                phi_9423_ = select(true, false, (_e427 == 2u));
                                            } else {
                                                phi_9420_ = u32();
                                                phi_9423_ = false;
                                            }
                                            let _e431 = phi_9420_;
                                            let _e433 = phi_9423_;
                                            let _e434 = select(true, false, _e425);
                                            let _e435 = select(_e431, 0u, _e434);
                                            let _e437 = select(_e433, true, _e434);
                                            if _e437 {
                                                phi_9434_ = (_e435 + 1u);
                                            } else {
                                                phi_9434_ = 0u;
                                            }
                                            let _e440 = phi_9434_;
                                            let _e441 = select(_e431, _e435, _e437);
                                            let _e442 = select(_e426, select(_e426, 2u, _e434), _e437);
                                            local_4 = array<f32, 3>(_e415, _e416, _e417);
                                            local_5 = array<f32, 3>(_e412, _e413, _e414);
                                            let _e445 = (_e442 < 3u);
                                            if _e445 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e447 = local_4[_e442];
                                            let _e448 = (1f / _e447);
                                            let _e449 = (_e441 < 3u);
                                            if _e449 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e451 = local_4[_e441];
                                            let _e452 = (_e451 * _e448);
                                            let _e453 = (_e440 < 3u);
                                            if _e453 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e455 = local_4[_e440];
                                            let _e456 = (_e455 * _e448);
                                            if _e449 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e458 = local_5[_e441];
                                            if _e453 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e460 = local_5[_e440];
                                            if _e445 {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e462 = local_5[_e442];
                                            if (0u < _e138) {
                                            } else {
                                                phi_16794_ = true;
                                                break;
                                            }
                                            let _e467 = nodes.member[0u].member_7[0u];
                                            let _e471 = nodes.member[0u].member_7[1u];
                                            let _e475 = nodes.member[0u].member_7[2u];
                                            let _e479 = nodes.member[0u].member_7[3u];
                                            let _e481 = abs((_e412 - _e467));
                                            let _e483 = abs((_e413 - _e471));
                                            let _e485 = select(_e483, _e481, (_e481 > _e483));
                                            let _e487 = abs((_e414 - _e475));
                                            let _e491 = ((select(_e487, _e485, (_e485 > _e487)) + _e479) * 0.0000009536743f);
                                            let _e498 = (_e491 + (abs(_e412) * 0.00000023841858f));
                                            let _e499 = (_e491 + (abs(_e413) * 0.00000023841858f));
                                            let _e500 = (_e491 + (abs(_e414) * 0.00000023841858f));
                                            let _e501 = select(_e419, _e418, _e421);
                                            let _e503 = select(_e420, _e501, (_e501 > _e420));
                                            let _e504 = (_e503 * 0.000000000001f);
                                            let _e505 = (_e412 + _e498);
                                            let _e506 = (_e413 + _e499);
                                            let _e507 = (_e414 + _e500);
                                            let _e508 = (_e412 - _e498);
                                            let _e509 = (_e413 - _e499);
                                            let _e510 = (_e414 - _e500);
                                            if (_e418 > _e504) {
                                                phi_9564_ = (1f / _e415);
                                            } else {
                                                phi_9564_ = (1000000000000f / _e503);
                                            }
                                            let _e515 = phi_9564_;
                                            if (_e419 > _e504) {
                                                phi_9572_ = (1f / _e416);
                                            } else {
                                                phi_9572_ = (1000000000000f / _e503);
                                            }
                                            let _e520 = phi_9572_;
                                            if (_e420 > _e504) {
                                                phi_9580_ = (1f / _e417);
                                            } else {
                                                phi_9580_ = (1000000000000f / _e503);
                                            }
                                            let _e525 = phi_9580_;
                                            local_3 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_16412_ = _e313;
                                            phi_9583_ = 0u;
                                            phi_9586_ = 0u;
                                            loop {
                                                let _e527 = phi_16412_;
                                                let _e529 = phi_9583_;
                                                let _e531 = phi_9586_;
                                                let _e532 = (_e529 & 15u);
                                                let _e534 = (_e529 >> bitcast<u32>(4u));
                                                if (_e532 == 0u) {
                                                    if (_e534 < _e138) {
                                                    } else {
                                                        phi_16474_ = true;
                                                        phi_12543_ = bool();
                                                        break;
                                                    }
                                                    let _e1164 = nodes.member[_e534].member;
                                                    let _e1173 = ((_e1164.x - _e505) * _e515);
                                                    let _e1174 = ((_e1164.y - _e505) * _e515);
                                                    let _e1175 = ((_e1164.z - _e505) * _e515);
                                                    let _e1176 = ((_e1164.w - _e505) * _e515);
                                                    let _e1179 = nodes.member[_e534].member_3;
                                                    let _e1188 = ((_e1179.x - _e508) * _e515);
                                                    let _e1189 = ((_e1179.y - _e508) * _e515);
                                                    let _e1190 = ((_e1179.z - _e508) * _e515);
                                                    let _e1191 = ((_e1179.w - _e508) * _e515);
                                                    let _e1194 = nodes.member[_e534].member_1;
                                                    let _e1203 = ((_e1194.x - _e506) * _e520);
                                                    let _e1204 = ((_e1194.y - _e506) * _e520);
                                                    let _e1205 = ((_e1194.z - _e506) * _e520);
                                                    let _e1206 = ((_e1194.w - _e506) * _e520);
                                                    let _e1209 = nodes.member[_e534].member_4;
                                                    let _e1218 = ((_e1209.x - _e509) * _e520);
                                                    let _e1219 = ((_e1209.y - _e509) * _e520);
                                                    let _e1220 = ((_e1209.z - _e509) * _e520);
                                                    let _e1221 = ((_e1209.w - _e509) * _e520);
                                                    let _e1224 = nodes.member[_e534].member_2;
                                                    let _e1233 = ((_e1224.x - _e507) * _e525);
                                                    let _e1234 = ((_e1224.y - _e507) * _e525);
                                                    let _e1235 = ((_e1224.z - _e507) * _e525);
                                                    let _e1236 = ((_e1224.w - _e507) * _e525);
                                                    let _e1239 = nodes.member[_e534].member_5;
                                                    let _e1248 = ((_e1239.x - _e510) * _e525);
                                                    let _e1249 = ((_e1239.y - _e510) * _e525);
                                                    let _e1250 = ((_e1239.z - _e510) * _e525);
                                                    let _e1251 = ((_e1239.w - _e510) * _e525);
                                                    let _e1253 = select(_e1188, _e1173, (_e1173 < _e1188));
                                                    let _e1255 = select(_e1189, _e1174, (_e1174 < _e1189));
                                                    let _e1257 = select(_e1190, _e1175, (_e1175 < _e1190));
                                                    let _e1259 = select(_e1191, _e1176, (_e1176 < _e1191));
                                                    let _e1261 = select(_e1218, _e1203, (_e1203 < _e1218));
                                                    let _e1263 = select(_e1219, _e1204, (_e1204 < _e1219));
                                                    let _e1265 = select(_e1220, _e1205, (_e1205 < _e1220));
                                                    let _e1267 = select(_e1221, _e1206, (_e1206 < _e1221));
                                                    let _e1269 = select(_e1261, _e1253, (_e1253 > _e1261));
                                                    let _e1271 = select(_e1263, _e1255, (_e1255 > _e1263));
                                                    let _e1273 = select(_e1265, _e1257, (_e1257 > _e1265));
                                                    let _e1275 = select(_e1267, _e1259, (_e1259 > _e1267));
                                                    let _e1277 = select(_e1248, _e1233, (_e1233 < _e1248));
                                                    let _e1279 = select(_e1249, _e1234, (_e1234 < _e1249));
                                                    let _e1281 = select(_e1250, _e1235, (_e1235 < _e1250));
                                                    let _e1283 = select(_e1251, _e1236, (_e1236 < _e1251));
                                                    let _e1285 = select(_e1277, _e1269, (_e1269 > _e1277));
                                                    let _e1287 = select(_e1279, _e1271, (_e1271 > _e1279));
                                                    let _e1289 = select(_e1281, _e1273, (_e1273 > _e1281));
                                                    let _e1291 = select(_e1283, _e1275, (_e1275 > _e1283));
                                                    let _e1293 = select(0f, _e1285, (_e1285 > 0f));
                                                    let _e1295 = select(0f, _e1287, (_e1287 > 0f));
                                                    let _e1297 = select(0f, _e1289, (_e1289 > 0f));
                                                    let _e1299 = select(0f, _e1291, (_e1291 > 0f));
                                                    let _e1301 = select(_e1188, _e1173, (_e1173 > _e1188));
                                                    let _e1303 = select(_e1189, _e1174, (_e1174 > _e1189));
                                                    let _e1305 = select(_e1190, _e1175, (_e1175 > _e1190));
                                                    let _e1307 = select(_e1191, _e1176, (_e1176 > _e1191));
                                                    let _e1309 = select(_e1218, _e1203, (_e1203 > _e1218));
                                                    let _e1311 = select(_e1219, _e1204, (_e1204 > _e1219));
                                                    let _e1313 = select(_e1220, _e1205, (_e1205 > _e1220));
                                                    let _e1315 = select(_e1221, _e1206, (_e1206 > _e1221));
                                                    let _e1317 = select(_e1309, _e1301, (_e1301 < _e1309));
                                                    let _e1319 = select(_e1311, _e1303, (_e1303 < _e1311));
                                                    let _e1321 = select(_e1313, _e1305, (_e1305 < _e1313));
                                                    let _e1323 = select(_e1315, _e1307, (_e1307 < _e1315));
                                                    let _e1325 = select(_e1248, _e1233, (_e1233 > _e1248));
                                                    let _e1327 = select(_e1249, _e1234, (_e1234 > _e1249));
                                                    let _e1329 = select(_e1250, _e1235, (_e1235 > _e1250));
                                                    let _e1331 = select(_e1251, _e1236, (_e1236 > _e1251));
                                                    let _e1333 = select(_e1325, _e1317, (_e1317 < _e1325));
                                                    let _e1335 = select(_e1327, _e1319, (_e1319 < _e1327));
                                                    let _e1337 = select(_e1329, _e1321, (_e1321 < _e1329));
                                                    let _e1339 = select(_e1331, _e1323, (_e1323 < _e1331));
                                                    let _e1359 = nodes.member[_e534].member_6[0u];
                                                    let _e1363 = nodes.member[_e534].member_6[1u];
                                                    let _e1367 = nodes.member[_e534].member_6[2u];
                                                    let _e1371 = nodes.member[_e534].member_6[3u];
                                                    if (select(340282350000000000000000000000000000000f, _e1299, (_e1299 <= select(0.9999995f, _e1339, (_e1339 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e531 < 64u) {
                                                        } else {
                                                            phi_16474_ = true;
                                                            phi_12543_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e531] = _e1371;
                                                        phi_9971_ = (_e531 + 1u);
                                                    } else {
                                                        phi_9971_ = _e531;
                                                    }
                                                    let _e1377 = phi_9971_;
                                                    if (select(340282350000000000000000000000000000000f, _e1297, (_e1297 <= select(0.9999995f, _e1337, (_e1337 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1377 < 64u) {
                                                        } else {
                                                            phi_16474_ = true;
                                                            phi_12543_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e1377] = _e1367;
                                                        phi_9983_ = (_e1377 + 1u);
                                                    } else {
                                                        phi_9983_ = _e1377;
                                                    }
                                                    let _e1383 = phi_9983_;
                                                    if (select(340282350000000000000000000000000000000f, _e1295, (_e1295 <= select(0.9999995f, _e1335, (_e1335 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1383 < 64u) {
                                                        } else {
                                                            phi_16474_ = true;
                                                            phi_12543_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e1383] = _e1363;
                                                        phi_9995_ = (_e1383 + 1u);
                                                    } else {
                                                        phi_9995_ = _e1383;
                                                    }
                                                    let _e1389 = phi_9995_;
                                                    if (select(340282350000000000000000000000000000000f, _e1293, (_e1293 <= select(0.9999995f, _e1333, (_e1333 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1389 < 64u) {
                                                        } else {
                                                            phi_16474_ = true;
                                                            phi_12543_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e1389] = _e1359;
                                                        phi_10007_ = (_e1389 + 1u);
                                                    } else {
                                                        phi_10007_ = _e1389;
                                                    }
                                                    let _e1395 = phi_10007_;
                                                    phi_16476_ = _e527;
                                                    phi_10699_ = _e1395;
                                                    phi_10700_ = true;
                                                } else {
                                                    phi_10011_ = type_9(_e534, (_e534 + _e532));
                                                    loop {
                                                        let _e539 = phi_10011_;
                                                        if (_e539.member < _e539.member_1) {
                                                            phi_10012_ = type_9((_e539.member + 1u), _e539.member_1);
                                                            phi_10035_ = type_9(1u, _e539.member);
                                                        } else {
                                                            phi_10012_ = _e539;
                                                            phi_10035_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e552 = phi_10012_;
                                                        let _e554 = phi_10035_;
                                                        let _e558 = (bitcast<i32>(_e554.member) != 0i);
                                                        if _e558 {
                                                            let _e559 = (_e554.member_1 < _e141);
                                                            if _e559 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            if _e445 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e563 = triangles.member[_e554.member_1].member[_e442];
                                                            let _e564 = (_e563 - _e462);
                                                            if _e445 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e568 = triangles.member[_e554.member_1].member_2[_e442];
                                                            let _e569 = (_e568 - _e462);
                                                            if _e445 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e573 = triangles.member[_e554.member_1].member_4[_e442];
                                                            let _e574 = (_e573 - _e462);
                                                            if _e449 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e578 = triangles.member[_e554.member_1].member[_e441];
                                                            let _e581 = ((_e578 - _e458) - (_e452 * _e564));
                                                            if _e453 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e585 = triangles.member[_e554.member_1].member[_e440];
                                                            let _e588 = ((_e585 - _e460) - (_e456 * _e564));
                                                            if _e449 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e592 = triangles.member[_e554.member_1].member_2[_e441];
                                                            let _e595 = ((_e592 - _e458) - (_e452 * _e569));
                                                            if _e453 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e599 = triangles.member[_e554.member_1].member_2[_e440];
                                                            let _e602 = ((_e599 - _e460) - (_e456 * _e569));
                                                            if _e449 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e606 = triangles.member[_e554.member_1].member_4[_e441];
                                                            let _e609 = ((_e606 - _e458) - (_e452 * _e574));
                                                            if _e453 {
                                                            } else {
                                                                phi_16408_ = true;
                                                                phi_12542_ = bool();
                                                                break;
                                                            }
                                                            let _e613 = triangles.member[_e554.member_1].member_4[_e440];
                                                            let _e616 = ((_e613 - _e460) - (_e456 * _e574));
                                                            let _e617 = (_e609 * _e602);
                                                            let _e618 = (_e616 * _e595);
                                                            if (_e617 != _e618) {
                                                                phi_10151_ = (_e617 - _e618);
                                                            } else {
                                                                let _e620 = (_e609 * 4097f);
                                                                let _e622 = (_e620 - (_e620 - _e609));
                                                                let _e623 = (_e602 * 4097f);
                                                                let _e625 = (_e623 - (_e623 - _e602));
                                                                let _e626 = (_e609 - _e622);
                                                                let _e627 = (_e602 - _e625);
                                                                let _e636 = (_e616 * 4097f);
                                                                let _e638 = (_e636 - (_e636 - _e616));
                                                                let _e639 = (_e595 * 4097f);
                                                                let _e641 = (_e639 - (_e639 - _e595));
                                                                let _e642 = (_e616 - _e638);
                                                                let _e643 = (_e595 - _e641);
                                                                phi_10151_ = ((((((_e622 * _e625) - _e617) + (_e622 * _e627)) + (_e626 * _e625)) + (_e626 * _e627)) - (((((_e638 * _e641) - _e618) + (_e638 * _e643)) + (_e642 * _e641)) + (_e642 * _e643)));
                                                            }
                                                            let _e655 = phi_10151_;
                                                            let _e656 = (_e581 * _e616);
                                                            let _e657 = (_e588 * _e609);
                                                            if (_e656 != _e657) {
                                                                phi_10162_ = (_e656 - _e657);
                                                            } else {
                                                                let _e659 = (_e581 * 4097f);
                                                                let _e661 = (_e659 - (_e659 - _e581));
                                                                let _e662 = (_e616 * 4097f);
                                                                let _e664 = (_e662 - (_e662 - _e616));
                                                                let _e665 = (_e581 - _e661);
                                                                let _e666 = (_e616 - _e664);
                                                                let _e675 = (_e588 * 4097f);
                                                                let _e677 = (_e675 - (_e675 - _e588));
                                                                let _e678 = (_e609 * 4097f);
                                                                let _e680 = (_e678 - (_e678 - _e609));
                                                                let _e681 = (_e588 - _e677);
                                                                let _e682 = (_e609 - _e680);
                                                                phi_10162_ = ((((((_e661 * _e664) - _e656) + (_e661 * _e666)) + (_e665 * _e664)) + (_e665 * _e666)) - (((((_e677 * _e680) - _e657) + (_e677 * _e682)) + (_e681 * _e680)) + (_e681 * _e682)));
                                                            }
                                                            let _e694 = phi_10162_;
                                                            let _e695 = (_e595 * _e588);
                                                            let _e696 = (_e602 * _e581);
                                                            if (_e695 != _e696) {
                                                                phi_10173_ = (_e695 - _e696);
                                                            } else {
                                                                let _e698 = (_e595 * 4097f);
                                                                let _e700 = (_e698 - (_e698 - _e595));
                                                                let _e701 = (_e588 * 4097f);
                                                                let _e703 = (_e701 - (_e701 - _e588));
                                                                let _e704 = (_e595 - _e700);
                                                                let _e705 = (_e588 - _e703);
                                                                let _e714 = (_e602 * 4097f);
                                                                let _e716 = (_e714 - (_e714 - _e602));
                                                                let _e717 = (_e581 * 4097f);
                                                                let _e719 = (_e717 - (_e717 - _e581));
                                                                let _e720 = (_e602 - _e716);
                                                                let _e721 = (_e581 - _e719);
                                                                phi_10173_ = ((((((_e700 * _e703) - _e695) + (_e700 * _e705)) + (_e704 * _e703)) + (_e704 * _e705)) - (((((_e716 * _e719) - _e696) + (_e716 * _e721)) + (_e720 * _e719)) + (_e720 * _e721)));
                                                            }
                                                            let _e733 = phi_10173_;
                                                            if (_e655 < 0f) {
                                                                phi_10191_ = f32();
                                                                phi_10192_ = true;
                                                            } else {
                                                                if (_e694 < 0f) {
                                                                    phi_10189_ = f32();
                                                                    phi_10190_ = true;
                                                                } else {
                                                                    let _e736 = (_e733 < 0f);
                                                                    if _e736 {
                                                                        phi_10188_ = f32();
                                                                    } else {
                                                                        phi_10188_ = ((_e655 + _e694) + _e733);
                                                                    }
                                                                    let _e740 = phi_10188_;
                                                                    phi_10189_ = _e740;
                                                                    phi_10190_ = _e736;
                                                                }
                                                                let _e742 = phi_10189_;
                                                                let _e744 = phi_10190_;
                                                                phi_10191_ = _e742;
                                                                phi_10192_ = _e744;
                                                            }
                                                            let _e746 = phi_10191_;
                                                            let _e748 = phi_10192_;
                                                            if _e748 {
                                                                if (_e655 > 0f) {
                                                                    phi_10213_ = f32();
                                                                    phi_10214_ = true;
                                                                    phi_10215_ = false;
                                                                } else {
                                                                    let _e750 = (_e694 > 0f);
                                                                    if _e750 {
                                                                        phi_10211_ = f32();
                                                                        phi_10212_ = false;
                                                                    } else {
                                                                        phi_10211_ = ((_e655 + _e694) + _e733);
                                                                        phi_10212_ = select(true, false, (_e733 > 0f));
                                                                    }
                                                                    let _e756 = phi_10211_;
                                                                    let _e758 = phi_10212_;
                                                                    phi_10213_ = _e756;
                                                                    phi_10214_ = _e750;
                                                                    phi_10215_ = _e758;
                                                                }
                                                                let _e760 = phi_10213_;
                                                                let _e762 = phi_10214_;
                                                                let _e764 = phi_10215_;
                                                                phi_10220_ = _e760;
                                                                phi_10221_ = select(_e764, false, _e762);
                                                            } else {
                                                                phi_10220_ = _e746;
                                                                phi_10221_ = true;
                                                            }
                                                            let _e767 = phi_10220_;
                                                            let _e769 = phi_10221_;
                                                            if _e769 {
                                                                let _e770 = (_e767 == 0f);
                                                                if _e770 {
                                                                    phi_10309_ = array<f32, 3>();
                                                                    phi_10310_ = array<f32, 3>();
                                                                    phi_10311_ = false;
                                                                } else {
                                                                    let _e771 = (_e564 * _e448);
                                                                    let _e772 = (_e569 * _e448);
                                                                    let _e773 = (_e574 * _e448);
                                                                    let _e776 = (1f / ((_e655 + _e694) + _e733));
                                                                    let _e777 = (_e694 * _e776);
                                                                    let _e778 = (_e733 * _e776);
                                                                    let _e784 = ((((_e655 * _e776) * _e771) + (_e777 * _e772)) + (_e778 * _e773));
                                                                    let _e785 = abs(_e581);
                                                                    let _e786 = abs(_e595);
                                                                    let _e788 = select(_e786, _e785, (_e785 > _e786));
                                                                    let _e789 = abs(_e609);
                                                                    let _e792 = abs(_e588);
                                                                    let _e793 = abs(_e602);
                                                                    let _e795 = select(_e793, _e792, (_e792 > _e793));
                                                                    let _e796 = abs(_e616);
                                                                    let _e800 = abs(_e771);
                                                                    let _e801 = abs(_e772);
                                                                    let _e803 = select(_e801, _e800, (_e800 > _e801));
                                                                    let _e804 = abs(_e773);
                                                                    let _e811 = (((select(_e789, _e788, (_e788 > _e789)) * select(_e796, _e795, (_e795 > _e796))) * select(_e804, _e803, (_e803 > _e804))) <= (abs((_e767 * _e784)) * 256f));
                                                                    if _e811 {
                                                                        phi_10307_ = array<f32, 3>(_e784, _e777, _e778);
                                                                        phi_10308_ = array<f32, 3>();
                                                                    } else {
                                                                        let _e813 = (_e609 * 4097f);
                                                                        let _e815 = (_e813 - (_e813 - _e609));
                                                                        let _e816 = (_e602 * 4097f);
                                                                        let _e818 = (_e816 - (_e816 - _e602));
                                                                        let _e819 = (_e609 - _e815);
                                                                        let _e820 = (_e602 - _e818);
                                                                        let _e829 = (_e616 * 4097f);
                                                                        let _e831 = (_e829 - (_e829 - _e616));
                                                                        let _e832 = (_e595 * 4097f);
                                                                        let _e834 = (_e832 - (_e832 - _e595));
                                                                        let _e835 = (_e616 - _e831);
                                                                        let _e836 = (_e595 - _e834);
                                                                        let _e846 = ((_e617 - _e618) + ((((((_e815 * _e818) - _e617) + (_e815 * _e820)) + (_e819 * _e818)) + (_e819 * _e820)) - (((((_e831 * _e834) - _e618) + (_e831 * _e836)) + (_e835 * _e834)) + (_e835 * _e836))));
                                                                        let _e848 = (_e581 * 4097f);
                                                                        let _e850 = (_e848 - (_e848 - _e581));
                                                                        let _e851 = (_e581 - _e850);
                                                                        let _e860 = (_e588 * 4097f);
                                                                        let _e862 = (_e860 - (_e860 - _e588));
                                                                        let _e863 = (_e588 - _e862);
                                                                        let _e873 = ((_e656 - _e657) + ((((((_e850 * _e831) - _e656) + (_e850 * _e835)) + (_e851 * _e831)) + (_e851 * _e835)) - (((((_e862 * _e815) - _e657) + (_e862 * _e819)) + (_e863 * _e815)) + (_e863 * _e819))));
                                                                        let _e892 = ((_e695 - _e696) + ((((((_e834 * _e862) - _e695) + (_e834 * _e863)) + (_e836 * _e862)) + (_e836 * _e863)) - (((((_e818 * _e850) - _e696) + (_e818 * _e851)) + (_e820 * _e850)) + (_e820 * _e851))));
                                                                        let _e895 = (1f / ((_e846 + _e873) + _e892));
                                                                        let _e896 = (_e873 * _e895);
                                                                        let _e897 = (_e892 * _e895);
                                                                        phi_10307_ = array<f32, 3>();
                                                                        phi_10308_ = array<f32, 3>(((((_e846 * _e895) * _e771) + (_e896 * _e772)) + (_e897 * _e773)), _e896, _e897);
                                                                    }
                                                                    let _e907 = phi_10307_;
                                                                    let _e909 = phi_10308_;
                                                                    phi_10309_ = _e907;
                                                                    phi_10310_ = _e909;
                                                                    phi_10311_ = _e811;
                                                                }
                                                                let _e911 = phi_10309_;
                                                                let _e913 = phi_10310_;
                                                                let _e915 = phi_10311_;
                                                                phi_10312_ = _e911;
                                                                phi_10313_ = _e913;
                                                                phi_10314_ = _e770;
                                                                phi_10315_ = _e915;
                                                            } else {
                                                                phi_10312_ = array<f32, 3>();
                                                                phi_10313_ = array<f32, 3>();
                                                                phi_10314_ = true;
                                                                phi_10315_ = false;
                                                            }
                                                            let _e917 = phi_10312_;
                                                            let _e919 = phi_10313_;
                                                            let _e921 = phi_10314_;
                                                            let _e923 = phi_10315_;
                                                            if _e921 {
                                                                phi_10320_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_10320_ = _e917;
                                                            }
                                                            let _e925 = phi_10320_;
                                                            if select(_e923, true, _e921) {
                                                                phi_10325_ = _e925;
                                                            } else {
                                                                phi_10325_ = _e919;
                                                            }
                                                            let _e928 = phi_10325_;
                                                            let _e932 = (_e928[0] >= 0f);
                                                            if _e932 {
                                                                let _e933 = (_e928[0] < 0.9999995f);
                                                                if _e933 {
                                                                    if _e932 {
                                                                        if _e559 {
                                                                        } else {
                                                                            phi_16408_ = true;
                                                                            phi_12542_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e936 = triangles.member[_e554.member_1].member_3;
                                                                        if ((_e936 & 1u) == 0u) {
                                                                            phi_10657_ = true;
                                                                        } else {
                                                                            if _e559 {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e941 = triangles.member[_e554.member_1].member_1;
                                                                            let _e942 = (_e941 * 12u);
                                                                            if ((256u + _e942) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 257u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 258u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e949 = (_e942 + 259u);
                                                                            if (_e949 < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e952 = surfaces.member[_e949];
                                                                            if ((_e942 + 260u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 261u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 262u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e959 = (_e942 + 263u);
                                                                            if (_e959 < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e962 = surfaces.member[_e959];
                                                                            let _e963 = (_e942 + 264u);
                                                                            if (_e963 < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e966 = surfaces.member[_e963];
                                                                            let _e967 = bitcast<f32>(_e966);
                                                                            let _e968 = (_e942 + 265u);
                                                                            if (_e968 < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e971 = surfaces.member[_e968];
                                                                            let _e972 = bitcast<f32>(_e971);
                                                                            if ((_e942 + 266u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 267u) < _e147) {
                                                                            } else {
                                                                                phi_16408_ = true;
                                                                                phi_12542_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e952 == 4294967295u) {
                                                                                phi_10652_ = (_e967 < _e972);
                                                                            } else {
                                                                                if (_e554.member_1 < _e144) {
                                                                                } else {
                                                                                    phi_16408_ = true;
                                                                                    phi_12542_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e980 = ((1f - _e928[1]) - _e928[2]);
                                                                                let _e984 = attributes.member[_e554.member_1].member[0u];
                                                                                let _e989 = attributes.member[_e554.member_1].member[2u];
                                                                                let _e995 = attributes.member[_e554.member_1].member[4u];
                                                                                let _e997 = (((_e984 * _e980) + (_e989 * _e928[1])) + (_e995 * _e928[2]));
                                                                                let _e1001 = attributes.member[_e554.member_1].member[1u];
                                                                                let _e1006 = attributes.member[_e554.member_1].member[3u];
                                                                                let _e1012 = attributes.member[_e554.member_1].member[5u];
                                                                                let _e1014 = (((_e1001 * _e980) + (_e1006 * _e928[1])) + (_e1012 * _e928[2]));
                                                                                let _e1015 = (_e962 & 65535u);
                                                                                let _e1017 = (_e962 >> bitcast<u32>(16i));
                                                                                let _e1019 = (_e997 - floor(_e997));
                                                                                let _e1024 = ((select(0f, _e1019, (_e1019 <= 1f)) * f32(_e1015)) - 0.5f);
                                                                                let _e1025 = floor(_e1024);
                                                                                let _e1026 = (_e1024 - _e1025);
                                                                                let _e1027 = (_e1015 - 1u);
                                                                                if (_e1025 < 0f) {
                                                                                    phi_10535_ = _e1027;
                                                                                } else {
                                                                                    let _e1033 = select(select(u32(_e1025), 0u, (_e1025 < 0f)), 4294967295u, (_e1025 > 4294967000f));
                                                                                    phi_10535_ = select(_e1033, _e1027, (_e1027 < _e1033));
                                                                                }
                                                                                let _e1037 = phi_10535_;
                                                                                if (_e1037 == _e1027) {
                                                                                    phi_10541_ = 0u;
                                                                                } else {
                                                                                    phi_10541_ = (_e1037 + 1u);
                                                                                }
                                                                                let _e1041 = phi_10541_;
                                                                                let _e1043 = (_e1014 - floor(_e1014));
                                                                                let _e1048 = ((select(0f, _e1043, (_e1043 <= 1f)) * f32(_e1017)) - 0.5f);
                                                                                let _e1049 = floor(_e1048);
                                                                                let _e1050 = (_e1048 - _e1049);
                                                                                let _e1051 = (_e1017 - 1u);
                                                                                if (_e1049 < 0f) {
                                                                                    phi_10571_ = _e1051;
                                                                                } else {
                                                                                    let _e1057 = select(select(u32(_e1049), 0u, (_e1049 < 0f)), 4294967295u, (_e1049 > 4294967000f));
                                                                                    phi_10571_ = select(_e1057, _e1051, (_e1051 < _e1057));
                                                                                }
                                                                                let _e1061 = phi_10571_;
                                                                                if (_e1061 == _e1051) {
                                                                                    phi_10577_ = 0u;
                                                                                } else {
                                                                                    phi_10577_ = (_e1061 + 1u);
                                                                                }
                                                                                let _e1065 = phi_10577_;
                                                                                let _e1067 = (_e952 + (_e1061 * _e1015));
                                                                                let _e1069 = (_e952 + (_e1065 * _e1015));
                                                                                let _e1070 = (_e1067 + _e1037);
                                                                                let _e1071 = (_e1067 + _e1041);
                                                                                let _e1072 = (_e1069 + _e1037);
                                                                                let _e1073 = (_e1069 + _e1041);
                                                                                if (_e1070 < _e147) {
                                                                                } else {
                                                                                    phi_16408_ = true;
                                                                                    phi_12542_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1076 = surfaces.member[_e1070];
                                                                                if (_e1071 < _e147) {
                                                                                } else {
                                                                                    phi_16408_ = true;
                                                                                    phi_12542_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1079 = surfaces.member[_e1071];
                                                                                if (_e1072 < _e147) {
                                                                                } else {
                                                                                    phi_16408_ = true;
                                                                                    phi_12542_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1082 = surfaces.member[_e1072];
                                                                                if (_e1073 < _e147) {
                                                                                } else {
                                                                                    phi_16408_ = true;
                                                                                    phi_12542_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1085 = surfaces.member[_e1073];
                                                                                let _e1102 = (1f - _e1026);
                                                                                phi_10652_ = ((_e967 * (((((f32((_e1076 >> bitcast<u32>(24i))) * 0.003921569f) * _e1102) + ((f32((_e1079 >> bitcast<u32>(24i))) * 0.003921569f) * _e1026)) * (1f - _e1050)) + ((((f32((_e1082 >> bitcast<u32>(24i))) * 0.003921569f) * _e1102) + ((f32((_e1085 >> bitcast<u32>(24i))) * 0.003921569f) * _e1026)) * _e1050))) < _e972);
                                                                            }
                                                                            let _e1117 = phi_10652_;
                                                                            phi_10657_ = select(true, false, _e1117);
                                                                        }
                                                                        let _e1120 = phi_10657_;
                                                                        if _e1120 {
                                                                            phi_10662_ = type_47(_e928[0], _e554.member_1, _e928[1], _e928[2]);
                                                                        } else {
                                                                            phi_10662_ = type_47();
                                                                        }
                                                                        let _e1123 = phi_10662_;
                                                                        phi_10664_ = _e1123;
                                                                        phi_10666_ = select(true, false, _e1120);
                                                                    } else {
                                                                        phi_10664_ = type_47();
                                                                        phi_10666_ = false;
                                                                    }
                                                                    let _e1126 = phi_10664_;
                                                                    let _e1128 = phi_10666_;
                                                                    phi_10667_ = _e1126;
                                                                    phi_10669_ = select(true, false, _e932);
                                                                    phi_10670_ = _e1128;
                                                                } else {
                                                                    phi_10667_ = type_47();
                                                                    phi_10669_ = false;
                                                                    phi_10670_ = false;
                                                                }
                                                                let _e1131 = phi_10667_;
                                                                let _e1133 = phi_10669_;
                                                                let _e1135 = phi_10670_;
                                                                phi_10671_ = _e1131;
                                                                phi_10672_ = select(true, false, _e933);
                                                                phi_10673_ = _e1133;
                                                                phi_10674_ = _e1135;
                                                            } else {
                                                                phi_10671_ = type_47();
                                                                phi_10672_ = true;
                                                                phi_10673_ = false;
                                                                phi_10674_ = false;
                                                            }
                                                            let _e1138 = phi_10671_;
                                                            let _e1140 = phi_10672_;
                                                            let _e1142 = phi_10673_;
                                                            let _e1144 = phi_10674_;
                                                            if select(select(_e1144, false, _e1140), true, select(_e1142, true, _e1140)) {
                                                                phi_10687_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_10687_ = _e1138;
                                                            }
                                                            let _e1149 = phi_10687_;
                                                            phi_10694_ = select(true, false, (_e1149.member_1 != 4294967295u));
                                                        } else {
                                                            phi_10694_ = false;
                                                        }
                                                        let _e1154 = phi_10694_;
                                                        continue;
                                                        continuing {
                                                            phi_10011_ = _e552;
                                                            phi_16408_ = _e527;
                                                            phi_12542_ = select(true, false, _e558);
                                                            break if !(_e1154);
                                                        }
                                                    }
                                                    let _e1158 = phi_16408_;
                                                    let _e1160 = phi_12542_;
                                                    phi_16474_ = _e1158;
                                                    phi_12543_ = bool();
                                                    if _e1158 {
                                                        break;
                                                    }
                                                    phi_16476_ = _e1158;
                                                    phi_10699_ = _e531;
                                                    phi_10700_ = _e1160;
                                                }
                                                let _e1397 = phi_16476_;
                                                let _e1399 = phi_10699_;
                                                let _e1401 = phi_10700_;
                                                if _e1401 {
                                                    let _e1402 = (_e1399 == 0u);
                                                    if _e1402 {
                                                        phi_10716_ = u32();
                                                        phi_10717_ = u32();
                                                    } else {
                                                        let _e1403 = (_e1399 - 1u);
                                                        if (_e1403 < 64u) {
                                                        } else {
                                                            phi_16474_ = true;
                                                            phi_12543_ = bool();
                                                            break;
                                                        }
                                                        let _e1406 = local_3[_e1403];
                                                        phi_10716_ = _e1406;
                                                        phi_10717_ = _e1403;
                                                    }
                                                    let _e1408 = phi_10716_;
                                                    let _e1410 = phi_10717_;
                                                    phi_9584_ = _e1408;
                                                    phi_9587_ = _e1410;
                                                    phi_10719_ = select(true, false, _e1402);
                                                    phi_10720_ = _e1402;
                                                } else {
                                                    phi_9584_ = u32();
                                                    phi_9587_ = u32();
                                                    phi_10719_ = false;
                                                    phi_10720_ = false;
                                                }
                                                let _e1413 = phi_9584_;
                                                let _e1415 = phi_9587_;
                                                let _e1417 = phi_10719_;
                                                let _e1419 = phi_10720_;
                                                continue;
                                                continuing {
                                                    phi_16412_ = _e1397;
                                                    phi_9583_ = _e1413;
                                                    phi_9586_ = _e1415;
                                                    phi_16474_ = _e1397;
                                                    phi_12543_ = _e1419;
                                                    break if !(_e1417);
                                                }
                                            }
                                            let _e1422 = phi_16474_;
                                            let _e1424 = phi_12543_;
                                            phi_16794_ = _e1422;
                                            if _e1422 {
                                                break;
                                            }
                                            let _e1427 = !(select(false, true, select(true, false, _e1424)));
                                            if _e1427 {
                                                phi_10737_ = vec3<f32>((_e321.member_6[0] * _e403), (_e321.member_6[1] * _e403), (_e321.member_6[2] * _e403));
                                            } else {
                                                phi_10737_ = vec3<f32>();
                                            }
                                            let _e1433 = phi_10737_;
                                            phi_16801_ = _e1422;
                                            phi_10739_ = _e1433;
                                            phi_10740_ = select(true, false, _e1427);
                                        } else {
                                            phi_16801_ = _e313;
                                            phi_10739_ = vec3<f32>();
                                            phi_10740_ = true;
                                        }
                                        let _e1436 = phi_16801_;
                                        let _e1438 = phi_10739_;
                                        let _e1440 = phi_10740_;
                                        phi_16799_ = _e1436;
                                        phi_10745_ = vec3<f32>();
                                        phi_10746_ = select(_e1438, vec3<f32>(0f, 0f, 0f), vec3(_e1440));
                                    }
                                    let _e2491 = phi_16799_;
                                    let _e2493 = phi_10745_;
                                    let _e2495 = phi_10746_;
                                    phi_16798_ = _e2491;
                                    phi_10747_ = _e2493;
                                    phi_10748_ = _e2495;
                                    phi_10749_ = _e352;
                                }
                                let _e3761 = phi_16798_;
                                let _e3763 = phi_10747_;
                                let _e3765 = phi_10748_;
                                let _e3767 = phi_10749_;
                                let _e3769 = select(_e3765, _e3763, vec3(_e3767));
                                phi_16796_ = _e3761;
                                phi_10769_ = vec3<f32>((_e265.x + (_e3769.x * _e325)), (_e265.y + (_e3769.y * _e325)), (_e265.z + (_e3769.z * _e325)));
                            } else {
                                phi_16796_ = _e313;
                                phi_10769_ = _e265;
                            }
                            let _e3784 = phi_16796_;
                            let _e3786 = phi_10769_;
                            phi_16795_ = _e3784;
                            phi_6099_ = _e3786;
                        } else {
                            phi_16795_ = _e261;
                            phi_6099_ = vec3<f32>();
                        }
                        let _e3788 = phi_16795_;
                        let _e3790 = phi_6099_;
                        continue;
                        continuing {
                            phi_16401_ = _e3788;
                            phi_6095_ = _e278;
                            phi_6098_ = _e3790;
                            phi_16794_ = _e3788;
                            break if !(_e284);
                        }
                    }
                    let _e3793 = phi_16794_;
                    if _e3793 {
                        break;
                    }
                    phi_17421_ = _e3793;
                    let _e10066 = local_32;
                    phi_10770_ = _e10066;
                }
                let _e8090 = phi_17421_;
                let _e8092 = phi_10770_;
                let _e8096 = params.member.member_17[2u];
                if (_e8096 > 0u) {
                    let _e8100 = params.member.member_15;
                    let _e8107 = ((_e242 ^ (_e242 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e8111 = ((_e8107 ^ (_e8107 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e8114 = (_e8111 ^ (_e8111 >> bitcast<u32>(16i)));
                    let _e8119 = bitcast<f32>((1065353216u | (bitcast<u32>(_e185.z) & 2147483648u)));
                    let _e8121 = (-1f / (_e8119 + _e185.z));
                    let _e8125 = ((_e185.x * _e185.y) * _e8121);
                    phi_17420_ = _e8090;
                    phi_10827_ = type_9(0u, _e8096);
                    phi_10830_ = 0i;
                    loop {
                        let _e8139 = phi_17420_;
                        let _e8141 = phi_10827_;
                        let _e8143 = phi_10830_;
                        local_30 = _e8143;
                        if (_e8141.member < _e8141.member_1) {
                            phi_10828_ = type_9((_e8141.member + 1u), _e8141.member_1);
                            phi_10853_ = type_9(1u, _e8141.member);
                        } else {
                            phi_10828_ = _e8141;
                            phi_10853_ = type_9(0u, type_9().member_1);
                        }
                        let _e8156 = phi_10828_;
                        let _e8158 = phi_10853_;
                        let _e8162 = (bitcast<i32>(_e8158.member) != 0i);
                        if _e8162 {
                            let _e8166 = ((_e8114 ^ (_e8114 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e8170 = ((_e8166 ^ (_e8166 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e8177 = (_e8114 ^ 2654435769u);
                            let _e8181 = ((_e8177 ^ (_e8177 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e8185 = ((_e8181 ^ (_e8181 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e8203 = (0.000000059604645f * (f32(((2147483648u + (_e8158.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e8170 ^ (_e8170 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                            if (_e8203 >= 1f) {
                                phi_16145_ = (_e8203 - 1f);
                            } else {
                                phi_16145_ = _e8203;
                            }
                            let _e8207 = phi_16145_;
                            let _e8209 = (0.000000059604645f * (f32(((2147483648u + (_e8158.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e8185 ^ (_e8185 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                            if (_e8209 >= 1f) {
                                phi_16153_ = (_e8209 - 1f);
                            } else {
                                phi_16153_ = _e8209;
                            }
                            let _e8213 = phi_16153_;
                            let _e8215 = ((2f * _e8207) - 1f);
                            let _e8217 = ((2f * _e8213) - 1f);
                            if (_e8215 == 0f) {
                                let _e8219 = (_e8217 == 0f);
                                phi_10917_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e8219));
                                phi_10918_ = select(true, false, _e8219);
                            } else {
                                phi_10917_ = vec2<f32>();
                                phi_10918_ = true;
                            }
                            let _e8224 = phi_10917_;
                            let _e8226 = phi_10918_;
                            if _e8226 {
                                if (abs(_e8215) > abs(_e8217)) {
                                    let _e8283 = (_e8217 / _e8215);
                                    let _e8287 = floor(((_e8283 * 0.5f) + 0.5f));
                                    let _e8293 = ((((0.7853982f * _e8283) - (_e8287 * 1.5703125f)) - (_e8287 * 0.0004837513f)) - (_e8287 * 0.0000000754979f));
                                    let _e8294 = (_e8293 * _e8293);
                                    let _e8301 = (_e8293 + ((_e8293 * _e8294) * (-0.16666655f + (_e8294 * (0.008332161f + (_e8294 * -0.00019515296f))))));
                                    let _e8310 = ((1f - (0.5f * _e8294)) + ((_e8294 * _e8294) * (0.041666646f + (_e8294 * (-0.0013887316f + (_e8294 * 0.000024433157f))))));
                                    let _e8317 = select(0i, select(select(i32(_e8287), i32(-2147483648), (_e8287 < -2147483600f)), 2147483647i, (_e8287 > 2147483500f)), (_e8287 == _e8287));
                                    let _e8319 = ((_e8317 & 1i) == 0i);
                                    let _e8320 = select(_e8310, _e8301, _e8319);
                                    let _e8321 = select(_e8301, _e8310, _e8319);
                                    if ((_e8317 & 2i) == 0i) {
                                        phi_10982_ = _e8320;
                                    } else {
                                        phi_10982_ = -(_e8320);
                                    }
                                    let _e8326 = phi_10982_;
                                    if (((_e8317 + 1i) & 2i) == 0i) {
                                        phi_10990_ = _e8321;
                                    } else {
                                        phi_10990_ = -(_e8321);
                                    }
                                    let _e8332 = phi_10990_;
                                    phi_11060_ = vec2<f32>((_e8215 * _e8332), (_e8215 * _e8326));
                                } else {
                                    let _e8230 = (_e8215 / _e8217);
                                    let _e8234 = floor(((_e8230 * 0.5f) + 0.5f));
                                    let _e8240 = ((((0.7853982f * _e8230) - (_e8234 * 1.5703125f)) - (_e8234 * 0.0004837513f)) - (_e8234 * 0.0000000754979f));
                                    let _e8241 = (_e8240 * _e8240);
                                    let _e8248 = (_e8240 + ((_e8240 * _e8241) * (-0.16666655f + (_e8241 * (0.008332161f + (_e8241 * -0.00019515296f))))));
                                    let _e8257 = ((1f - (0.5f * _e8241)) + ((_e8241 * _e8241) * (0.041666646f + (_e8241 * (-0.0013887316f + (_e8241 * 0.000024433157f))))));
                                    let _e8264 = select(0i, select(select(i32(_e8234), i32(-2147483648), (_e8234 < -2147483600f)), 2147483647i, (_e8234 > 2147483500f)), (_e8234 == _e8234));
                                    let _e8266 = ((_e8264 & 1i) == 0i);
                                    let _e8267 = select(_e8257, _e8248, _e8266);
                                    let _e8268 = select(_e8248, _e8257, _e8266);
                                    if ((_e8264 & 2i) == 0i) {
                                        phi_11048_ = _e8267;
                                    } else {
                                        phi_11048_ = -(_e8267);
                                    }
                                    let _e8273 = phi_11048_;
                                    if (((_e8264 + 1i) & 2i) == 0i) {
                                        phi_11056_ = _e8268;
                                    } else {
                                        phi_11056_ = -(_e8268);
                                    }
                                    let _e8279 = phi_11056_;
                                    phi_11060_ = vec2<f32>((_e8217 * _e8273), (_e8217 * _e8279));
                                }
                                let _e8337 = phi_11060_;
                                phi_11061_ = _e8337;
                            } else {
                                phi_11061_ = _e8224;
                            }
                            let _e8339 = phi_11061_;
                            let _e8345 = (1f - ((_e8339.x * _e8339.x) + (_e8339.y * _e8339.y)));
                            let _e8348 = sqrt(select(0f, _e8345, (_e8345 > 0f)));
                            let _e8361 = ((((1f + (((_e8119 * _e185.x) * _e185.x) * _e8121)) * _e8339.x) + (_e8125 * _e8339.y)) + (_e185.x * _e8348));
                            let _e8362 = ((((_e8119 * _e8125) * _e8339.x) + ((_e8119 + ((_e185.y * _e185.y) * _e8121)) * _e8339.y)) + (_e185.y * _e8348));
                            let _e8363 = ((((-(_e8119) * _e185.x) * _e8339.x) + (-(_e185.y) * _e8339.y)) + (_e185.z * _e8348));
                            if ((((_e185.x * _e8361) + (_e185.y * _e8362)) + (_e185.z * _e8363)) < 0f) {
                                phi_11105_ = -(_e207);
                            } else {
                                phi_11105_ = _e207;
                            }
                            let _e8372 = phi_11105_;
                            let _e8376 = (_e163.member[0] + (_e185.x * _e8372));
                            let _e8377 = (_e163.member[1] + (_e185.y * _e8372));
                            let _e8378 = (_e163.member[2] + (_e185.z * _e8372));
                            let _e8379 = abs(_e8361);
                            let _e8380 = abs(_e8362);
                            let _e8381 = abs(_e8363);
                            let _e8382 = (_e8379 > _e8380);
                            if _e8382 {
                                phi_11131_ = (_e8379 > _e8381);
                            } else {
                                phi_11131_ = (_e8380 > _e8381);
                            }
                            let _e8386 = phi_11131_;
                            let _e8387 = select(1u, 0u, _e8382);
                            if _e8386 {
                                let _e8388 = (_e8387 + 1u);
                                phi_11141_ = _e8388;
                                phi_11144_ = select(true, false, (_e8388 == 2u));
                            } else {
                                phi_11141_ = u32();
                                phi_11144_ = false;
                            }
                            let _e8392 = phi_11141_;
                            let _e8394 = phi_11144_;
                            let _e8395 = select(true, false, _e8386);
                            let _e8396 = select(_e8392, 0u, _e8395);
                            let _e8398 = select(_e8394, true, _e8395);
                            if _e8398 {
                                phi_11155_ = (_e8396 + 1u);
                            } else {
                                phi_11155_ = 0u;
                            }
                            let _e8401 = phi_11155_;
                            let _e8402 = select(_e8392, _e8396, _e8398);
                            let _e8403 = select(_e8387, select(_e8387, 2u, _e8395), _e8398);
                            local_1 = array<f32, 3>(_e8361, _e8362, _e8363);
                            local_2 = array<f32, 3>(_e8376, _e8377, _e8378);
                            let _e8406 = (_e8403 < 3u);
                            if _e8406 {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8408 = local_1[_e8403];
                            let _e8409 = (1f / _e8408);
                            let _e8410 = (_e8402 < 3u);
                            if _e8410 {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8412 = local_1[_e8402];
                            let _e8413 = (_e8412 * _e8409);
                            let _e8414 = (_e8401 < 3u);
                            if _e8414 {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8416 = local_1[_e8401];
                            let _e8417 = (_e8416 * _e8409);
                            if _e8410 {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8419 = local_2[_e8402];
                            if _e8414 {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8421 = local_2[_e8401];
                            if _e8406 {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8423 = local_2[_e8403];
                            if (0u < _e138) {
                            } else {
                                phi_17532_ = true;
                                break;
                            }
                            let _e8428 = nodes.member[0u].member_7[0u];
                            let _e8432 = nodes.member[0u].member_7[1u];
                            let _e8436 = nodes.member[0u].member_7[2u];
                            let _e8440 = nodes.member[0u].member_7[3u];
                            let _e8442 = abs((_e8376 - _e8428));
                            let _e8444 = abs((_e8377 - _e8432));
                            let _e8446 = select(_e8444, _e8442, (_e8442 > _e8444));
                            let _e8448 = abs((_e8378 - _e8436));
                            let _e8452 = ((select(_e8448, _e8446, (_e8446 > _e8448)) + _e8440) * 0.0000009536743f);
                            let _e8459 = (_e8452 + (abs(_e8376) * 0.00000023841858f));
                            let _e8460 = (_e8452 + (abs(_e8377) * 0.00000023841858f));
                            let _e8461 = (_e8452 + (abs(_e8378) * 0.00000023841858f));
                            let _e8462 = select(_e8380, _e8379, _e8382);
                            let _e8464 = select(_e8381, _e8462, (_e8462 > _e8381));
                            let _e8465 = (_e8464 * 0.000000000001f);
                            let _e8466 = (_e8376 + _e8459);
                            let _e8467 = (_e8377 + _e8460);
                            let _e8468 = (_e8378 + _e8461);
                            let _e8469 = (_e8376 - _e8459);
                            let _e8470 = (_e8377 - _e8460);
                            let _e8471 = (_e8378 - _e8461);
                            if (_e8379 > _e8465) {
                                phi_11285_ = (1f / _e8361);
                            } else {
                                phi_11285_ = (1000000000000f / _e8464);
                            }
                            let _e8476 = phi_11285_;
                            if (_e8380 > _e8465) {
                                phi_11293_ = (1f / _e8362);
                            } else {
                                phi_11293_ = (1000000000000f / _e8464);
                            }
                            let _e8481 = phi_11293_;
                            if (_e8381 > _e8465) {
                                phi_11301_ = (1f / _e8363);
                            } else {
                                phi_11301_ = (1000000000000f / _e8464);
                            }
                            let _e8486 = phi_11301_;
                            local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                            phi_17401_ = _e8139;
                            phi_11304_ = 0u;
                            phi_11307_ = 0u;
                            loop {
                                let _e8488 = phi_17401_;
                                let _e8490 = phi_11304_;
                                let _e8492 = phi_11307_;
                                let _e8493 = (_e8490 & 15u);
                                let _e8495 = (_e8490 >> bitcast<u32>(4u));
                                if (_e8493 == 0u) {
                                    if (_e8495 < _e138) {
                                    } else {
                                        phi_17472_ = true;
                                        phi_12555_ = bool();
                                        break;
                                    }
                                    let _e9125 = nodes.member[_e8495].member;
                                    let _e9134 = ((_e9125.x - _e8466) * _e8476);
                                    let _e9135 = ((_e9125.y - _e8466) * _e8476);
                                    let _e9136 = ((_e9125.z - _e8466) * _e8476);
                                    let _e9137 = ((_e9125.w - _e8466) * _e8476);
                                    let _e9140 = nodes.member[_e8495].member_3;
                                    let _e9149 = ((_e9140.x - _e8469) * _e8476);
                                    let _e9150 = ((_e9140.y - _e8469) * _e8476);
                                    let _e9151 = ((_e9140.z - _e8469) * _e8476);
                                    let _e9152 = ((_e9140.w - _e8469) * _e8476);
                                    let _e9155 = nodes.member[_e8495].member_1;
                                    let _e9164 = ((_e9155.x - _e8467) * _e8481);
                                    let _e9165 = ((_e9155.y - _e8467) * _e8481);
                                    let _e9166 = ((_e9155.z - _e8467) * _e8481);
                                    let _e9167 = ((_e9155.w - _e8467) * _e8481);
                                    let _e9170 = nodes.member[_e8495].member_4;
                                    let _e9179 = ((_e9170.x - _e8470) * _e8481);
                                    let _e9180 = ((_e9170.y - _e8470) * _e8481);
                                    let _e9181 = ((_e9170.z - _e8470) * _e8481);
                                    let _e9182 = ((_e9170.w - _e8470) * _e8481);
                                    let _e9185 = nodes.member[_e8495].member_2;
                                    let _e9194 = ((_e9185.x - _e8468) * _e8486);
                                    let _e9195 = ((_e9185.y - _e8468) * _e8486);
                                    let _e9196 = ((_e9185.z - _e8468) * _e8486);
                                    let _e9197 = ((_e9185.w - _e8468) * _e8486);
                                    let _e9200 = nodes.member[_e8495].member_5;
                                    let _e9209 = ((_e9200.x - _e8471) * _e8486);
                                    let _e9210 = ((_e9200.y - _e8471) * _e8486);
                                    let _e9211 = ((_e9200.z - _e8471) * _e8486);
                                    let _e9212 = ((_e9200.w - _e8471) * _e8486);
                                    let _e9214 = select(_e9149, _e9134, (_e9134 < _e9149));
                                    let _e9216 = select(_e9150, _e9135, (_e9135 < _e9150));
                                    let _e9218 = select(_e9151, _e9136, (_e9136 < _e9151));
                                    let _e9220 = select(_e9152, _e9137, (_e9137 < _e9152));
                                    let _e9222 = select(_e9179, _e9164, (_e9164 < _e9179));
                                    let _e9224 = select(_e9180, _e9165, (_e9165 < _e9180));
                                    let _e9226 = select(_e9181, _e9166, (_e9166 < _e9181));
                                    let _e9228 = select(_e9182, _e9167, (_e9167 < _e9182));
                                    let _e9230 = select(_e9222, _e9214, (_e9214 > _e9222));
                                    let _e9232 = select(_e9224, _e9216, (_e9216 > _e9224));
                                    let _e9234 = select(_e9226, _e9218, (_e9218 > _e9226));
                                    let _e9236 = select(_e9228, _e9220, (_e9220 > _e9228));
                                    let _e9238 = select(_e9209, _e9194, (_e9194 < _e9209));
                                    let _e9240 = select(_e9210, _e9195, (_e9195 < _e9210));
                                    let _e9242 = select(_e9211, _e9196, (_e9196 < _e9211));
                                    let _e9244 = select(_e9212, _e9197, (_e9197 < _e9212));
                                    let _e9246 = select(_e9238, _e9230, (_e9230 > _e9238));
                                    let _e9248 = select(_e9240, _e9232, (_e9232 > _e9240));
                                    let _e9250 = select(_e9242, _e9234, (_e9234 > _e9242));
                                    let _e9252 = select(_e9244, _e9236, (_e9236 > _e9244));
                                    let _e9254 = select(0f, _e9246, (_e9246 > 0f));
                                    let _e9256 = select(0f, _e9248, (_e9248 > 0f));
                                    let _e9258 = select(0f, _e9250, (_e9250 > 0f));
                                    let _e9260 = select(0f, _e9252, (_e9252 > 0f));
                                    let _e9262 = select(_e9149, _e9134, (_e9134 > _e9149));
                                    let _e9264 = select(_e9150, _e9135, (_e9135 > _e9150));
                                    let _e9266 = select(_e9151, _e9136, (_e9136 > _e9151));
                                    let _e9268 = select(_e9152, _e9137, (_e9137 > _e9152));
                                    let _e9270 = select(_e9179, _e9164, (_e9164 > _e9179));
                                    let _e9272 = select(_e9180, _e9165, (_e9165 > _e9180));
                                    let _e9274 = select(_e9181, _e9166, (_e9166 > _e9181));
                                    let _e9276 = select(_e9182, _e9167, (_e9167 > _e9182));
                                    let _e9278 = select(_e9270, _e9262, (_e9262 < _e9270));
                                    let _e9280 = select(_e9272, _e9264, (_e9264 < _e9272));
                                    let _e9282 = select(_e9274, _e9266, (_e9266 < _e9274));
                                    let _e9284 = select(_e9276, _e9268, (_e9268 < _e9276));
                                    let _e9286 = select(_e9209, _e9194, (_e9194 > _e9209));
                                    let _e9288 = select(_e9210, _e9195, (_e9195 > _e9210));
                                    let _e9290 = select(_e9211, _e9196, (_e9196 > _e9211));
                                    let _e9292 = select(_e9212, _e9197, (_e9197 > _e9212));
                                    let _e9294 = select(_e9286, _e9278, (_e9278 < _e9286));
                                    let _e9296 = select(_e9288, _e9280, (_e9280 < _e9288));
                                    let _e9298 = select(_e9290, _e9282, (_e9282 < _e9290));
                                    let _e9300 = select(_e9292, _e9284, (_e9284 < _e9292));
                                    let _e9320 = nodes.member[_e8495].member_6[0u];
                                    let _e9324 = nodes.member[_e8495].member_6[1u];
                                    let _e9328 = nodes.member[_e8495].member_6[2u];
                                    let _e9332 = nodes.member[_e8495].member_6[3u];
                                    if (select(340282350000000000000000000000000000000f, _e9260, (_e9260 <= select(340282350000000000000000000000000000000f, _e9300, (_e9300 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e8492 < 64u) {
                                        } else {
                                            phi_17472_ = true;
                                            phi_12555_ = bool();
                                            break;
                                        }
                                        local[_e8492] = _e9332;
                                        phi_11692_ = (_e8492 + 1u);
                                    } else {
                                        phi_11692_ = _e8492;
                                    }
                                    let _e9338 = phi_11692_;
                                    if (select(340282350000000000000000000000000000000f, _e9258, (_e9258 <= select(340282350000000000000000000000000000000f, _e9298, (_e9298 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e9338 < 64u) {
                                        } else {
                                            phi_17472_ = true;
                                            phi_12555_ = bool();
                                            break;
                                        }
                                        local[_e9338] = _e9328;
                                        phi_11704_ = (_e9338 + 1u);
                                    } else {
                                        phi_11704_ = _e9338;
                                    }
                                    let _e9344 = phi_11704_;
                                    if (select(340282350000000000000000000000000000000f, _e9256, (_e9256 <= select(340282350000000000000000000000000000000f, _e9296, (_e9296 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e9344 < 64u) {
                                        } else {
                                            phi_17472_ = true;
                                            phi_12555_ = bool();
                                            break;
                                        }
                                        local[_e9344] = _e9324;
                                        phi_11716_ = (_e9344 + 1u);
                                    } else {
                                        phi_11716_ = _e9344;
                                    }
                                    let _e9350 = phi_11716_;
                                    if (select(340282350000000000000000000000000000000f, _e9254, (_e9254 <= select(340282350000000000000000000000000000000f, _e9294, (_e9294 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e9350 < 64u) {
                                        } else {
                                            phi_17472_ = true;
                                            phi_12555_ = bool();
                                            break;
                                        }
                                        local[_e9350] = _e9320;
                                        phi_11728_ = (_e9350 + 1u);
                                    } else {
                                        phi_11728_ = _e9350;
                                    }
                                    let _e9356 = phi_11728_;
                                    phi_17474_ = _e8488;
                                    phi_12420_ = _e9356;
                                    phi_12421_ = true;
                                } else {
                                    phi_11732_ = type_9(_e8495, (_e8495 + _e8493));
                                    loop {
                                        let _e8500 = phi_11732_;
                                        if (_e8500.member < _e8500.member_1) {
                                            phi_11733_ = type_9((_e8500.member + 1u), _e8500.member_1);
                                            phi_11756_ = type_9(1u, _e8500.member);
                                        } else {
                                            phi_11733_ = _e8500;
                                            phi_11756_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e8513 = phi_11733_;
                                        let _e8515 = phi_11756_;
                                        let _e8519 = (bitcast<i32>(_e8515.member) != 0i);
                                        if _e8519 {
                                            let _e8520 = (_e8515.member_1 < _e141);
                                            if _e8520 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            if _e8406 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8524 = triangles.member[_e8515.member_1].member[_e8403];
                                            let _e8525 = (_e8524 - _e8423);
                                            if _e8406 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8529 = triangles.member[_e8515.member_1].member_2[_e8403];
                                            let _e8530 = (_e8529 - _e8423);
                                            if _e8406 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8534 = triangles.member[_e8515.member_1].member_4[_e8403];
                                            let _e8535 = (_e8534 - _e8423);
                                            if _e8410 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8539 = triangles.member[_e8515.member_1].member[_e8402];
                                            let _e8542 = ((_e8539 - _e8419) - (_e8413 * _e8525));
                                            if _e8414 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8546 = triangles.member[_e8515.member_1].member[_e8401];
                                            let _e8549 = ((_e8546 - _e8421) - (_e8417 * _e8525));
                                            if _e8410 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8553 = triangles.member[_e8515.member_1].member_2[_e8402];
                                            let _e8556 = ((_e8553 - _e8419) - (_e8413 * _e8530));
                                            if _e8414 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8560 = triangles.member[_e8515.member_1].member_2[_e8401];
                                            let _e8563 = ((_e8560 - _e8421) - (_e8417 * _e8530));
                                            if _e8410 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8567 = triangles.member[_e8515.member_1].member_4[_e8402];
                                            let _e8570 = ((_e8567 - _e8419) - (_e8413 * _e8535));
                                            if _e8414 {
                                            } else {
                                                phi_17397_ = true;
                                                phi_12554_ = bool();
                                                break;
                                            }
                                            let _e8574 = triangles.member[_e8515.member_1].member_4[_e8401];
                                            let _e8577 = ((_e8574 - _e8421) - (_e8417 * _e8535));
                                            let _e8578 = (_e8570 * _e8563);
                                            let _e8579 = (_e8577 * _e8556);
                                            if (_e8578 != _e8579) {
                                                phi_11872_ = (_e8578 - _e8579);
                                            } else {
                                                let _e8581 = (_e8570 * 4097f);
                                                let _e8583 = (_e8581 - (_e8581 - _e8570));
                                                let _e8584 = (_e8563 * 4097f);
                                                let _e8586 = (_e8584 - (_e8584 - _e8563));
                                                let _e8587 = (_e8570 - _e8583);
                                                let _e8588 = (_e8563 - _e8586);
                                                let _e8597 = (_e8577 * 4097f);
                                                let _e8599 = (_e8597 - (_e8597 - _e8577));
                                                let _e8600 = (_e8556 * 4097f);
                                                let _e8602 = (_e8600 - (_e8600 - _e8556));
                                                let _e8603 = (_e8577 - _e8599);
                                                let _e8604 = (_e8556 - _e8602);
                                                phi_11872_ = ((((((_e8583 * _e8586) - _e8578) + (_e8583 * _e8588)) + (_e8587 * _e8586)) + (_e8587 * _e8588)) - (((((_e8599 * _e8602) - _e8579) + (_e8599 * _e8604)) + (_e8603 * _e8602)) + (_e8603 * _e8604)));
                                            }
                                            let _e8616 = phi_11872_;
                                            let _e8617 = (_e8542 * _e8577);
                                            let _e8618 = (_e8549 * _e8570);
                                            if (_e8617 != _e8618) {
                                                phi_11883_ = (_e8617 - _e8618);
                                            } else {
                                                let _e8620 = (_e8542 * 4097f);
                                                let _e8622 = (_e8620 - (_e8620 - _e8542));
                                                let _e8623 = (_e8577 * 4097f);
                                                let _e8625 = (_e8623 - (_e8623 - _e8577));
                                                let _e8626 = (_e8542 - _e8622);
                                                let _e8627 = (_e8577 - _e8625);
                                                let _e8636 = (_e8549 * 4097f);
                                                let _e8638 = (_e8636 - (_e8636 - _e8549));
                                                let _e8639 = (_e8570 * 4097f);
                                                let _e8641 = (_e8639 - (_e8639 - _e8570));
                                                let _e8642 = (_e8549 - _e8638);
                                                let _e8643 = (_e8570 - _e8641);
                                                phi_11883_ = ((((((_e8622 * _e8625) - _e8617) + (_e8622 * _e8627)) + (_e8626 * _e8625)) + (_e8626 * _e8627)) - (((((_e8638 * _e8641) - _e8618) + (_e8638 * _e8643)) + (_e8642 * _e8641)) + (_e8642 * _e8643)));
                                            }
                                            let _e8655 = phi_11883_;
                                            let _e8656 = (_e8556 * _e8549);
                                            let _e8657 = (_e8563 * _e8542);
                                            if (_e8656 != _e8657) {
                                                phi_11894_ = (_e8656 - _e8657);
                                            } else {
                                                let _e8659 = (_e8556 * 4097f);
                                                let _e8661 = (_e8659 - (_e8659 - _e8556));
                                                let _e8662 = (_e8549 * 4097f);
                                                let _e8664 = (_e8662 - (_e8662 - _e8549));
                                                let _e8665 = (_e8556 - _e8661);
                                                let _e8666 = (_e8549 - _e8664);
                                                let _e8675 = (_e8563 * 4097f);
                                                let _e8677 = (_e8675 - (_e8675 - _e8563));
                                                let _e8678 = (_e8542 * 4097f);
                                                let _e8680 = (_e8678 - (_e8678 - _e8542));
                                                let _e8681 = (_e8563 - _e8677);
                                                let _e8682 = (_e8542 - _e8680);
                                                phi_11894_ = ((((((_e8661 * _e8664) - _e8656) + (_e8661 * _e8666)) + (_e8665 * _e8664)) + (_e8665 * _e8666)) - (((((_e8677 * _e8680) - _e8657) + (_e8677 * _e8682)) + (_e8681 * _e8680)) + (_e8681 * _e8682)));
                                            }
                                            let _e8694 = phi_11894_;
                                            if (_e8616 < 0f) {
                                                phi_11912_ = f32();
                                                phi_11913_ = true;
                                            } else {
                                                if (_e8655 < 0f) {
                                                    phi_11910_ = f32();
                                                    phi_11911_ = true;
                                                } else {
                                                    let _e8697 = (_e8694 < 0f);
                                                    if _e8697 {
                                                        phi_11909_ = f32();
                                                    } else {
                                                        phi_11909_ = ((_e8616 + _e8655) + _e8694);
                                                    }
                                                    let _e8701 = phi_11909_;
                                                    phi_11910_ = _e8701;
                                                    phi_11911_ = _e8697;
                                                }
                                                let _e8703 = phi_11910_;
                                                let _e8705 = phi_11911_;
                                                phi_11912_ = _e8703;
                                                phi_11913_ = _e8705;
                                            }
                                            let _e8707 = phi_11912_;
                                            let _e8709 = phi_11913_;
                                            if _e8709 {
                                                if (_e8616 > 0f) {
                                                    phi_11934_ = f32();
                                                    phi_11935_ = true;
                                                    phi_11936_ = false;
                                                } else {
                                                    let _e8711 = (_e8655 > 0f);
                                                    if _e8711 {
                                                        phi_11932_ = f32();
                                                        phi_11933_ = false;
                                                    } else {
                                                        phi_11932_ = ((_e8616 + _e8655) + _e8694);
                                                        phi_11933_ = select(true, false, (_e8694 > 0f));
                                                    }
                                                    let _e8717 = phi_11932_;
                                                    let _e8719 = phi_11933_;
                                                    phi_11934_ = _e8717;
                                                    phi_11935_ = _e8711;
                                                    phi_11936_ = _e8719;
                                                }
                                                let _e8721 = phi_11934_;
                                                let _e8723 = phi_11935_;
                                                let _e8725 = phi_11936_;
                                                phi_11941_ = _e8721;
                                                phi_11942_ = select(_e8725, false, _e8723);
                                            } else {
                                                phi_11941_ = _e8707;
                                                phi_11942_ = true;
                                            }
                                            let _e8728 = phi_11941_;
                                            let _e8730 = phi_11942_;
                                            if _e8730 {
                                                let _e8731 = (_e8728 == 0f);
                                                if _e8731 {
                                                    phi_12030_ = array<f32, 3>();
                                                    phi_12031_ = array<f32, 3>();
                                                    phi_12032_ = false;
                                                } else {
                                                    let _e8732 = (_e8525 * _e8409);
                                                    let _e8733 = (_e8530 * _e8409);
                                                    let _e8734 = (_e8535 * _e8409);
                                                    let _e8737 = (1f / ((_e8616 + _e8655) + _e8694));
                                                    let _e8738 = (_e8655 * _e8737);
                                                    let _e8739 = (_e8694 * _e8737);
                                                    let _e8745 = ((((_e8616 * _e8737) * _e8732) + (_e8738 * _e8733)) + (_e8739 * _e8734));
                                                    let _e8746 = abs(_e8542);
                                                    let _e8747 = abs(_e8556);
                                                    let _e8749 = select(_e8747, _e8746, (_e8746 > _e8747));
                                                    let _e8750 = abs(_e8570);
                                                    let _e8753 = abs(_e8549);
                                                    let _e8754 = abs(_e8563);
                                                    let _e8756 = select(_e8754, _e8753, (_e8753 > _e8754));
                                                    let _e8757 = abs(_e8577);
                                                    let _e8761 = abs(_e8732);
                                                    let _e8762 = abs(_e8733);
                                                    let _e8764 = select(_e8762, _e8761, (_e8761 > _e8762));
                                                    let _e8765 = abs(_e8734);
                                                    let _e8772 = (((select(_e8750, _e8749, (_e8749 > _e8750)) * select(_e8757, _e8756, (_e8756 > _e8757))) * select(_e8765, _e8764, (_e8764 > _e8765))) <= (abs((_e8728 * _e8745)) * 256f));
                                                    if _e8772 {
                                                        phi_12028_ = array<f32, 3>(_e8745, _e8738, _e8739);
                                                        phi_12029_ = array<f32, 3>();
                                                    } else {
                                                        let _e8774 = (_e8570 * 4097f);
                                                        let _e8776 = (_e8774 - (_e8774 - _e8570));
                                                        let _e8777 = (_e8563 * 4097f);
                                                        let _e8779 = (_e8777 - (_e8777 - _e8563));
                                                        let _e8780 = (_e8570 - _e8776);
                                                        let _e8781 = (_e8563 - _e8779);
                                                        let _e8790 = (_e8577 * 4097f);
                                                        let _e8792 = (_e8790 - (_e8790 - _e8577));
                                                        let _e8793 = (_e8556 * 4097f);
                                                        let _e8795 = (_e8793 - (_e8793 - _e8556));
                                                        let _e8796 = (_e8577 - _e8792);
                                                        let _e8797 = (_e8556 - _e8795);
                                                        let _e8807 = ((_e8578 - _e8579) + ((((((_e8776 * _e8779) - _e8578) + (_e8776 * _e8781)) + (_e8780 * _e8779)) + (_e8780 * _e8781)) - (((((_e8792 * _e8795) - _e8579) + (_e8792 * _e8797)) + (_e8796 * _e8795)) + (_e8796 * _e8797))));
                                                        let _e8809 = (_e8542 * 4097f);
                                                        let _e8811 = (_e8809 - (_e8809 - _e8542));
                                                        let _e8812 = (_e8542 - _e8811);
                                                        let _e8821 = (_e8549 * 4097f);
                                                        let _e8823 = (_e8821 - (_e8821 - _e8549));
                                                        let _e8824 = (_e8549 - _e8823);
                                                        let _e8834 = ((_e8617 - _e8618) + ((((((_e8811 * _e8792) - _e8617) + (_e8811 * _e8796)) + (_e8812 * _e8792)) + (_e8812 * _e8796)) - (((((_e8823 * _e8776) - _e8618) + (_e8823 * _e8780)) + (_e8824 * _e8776)) + (_e8824 * _e8780))));
                                                        let _e8853 = ((_e8656 - _e8657) + ((((((_e8795 * _e8823) - _e8656) + (_e8795 * _e8824)) + (_e8797 * _e8823)) + (_e8797 * _e8824)) - (((((_e8779 * _e8811) - _e8657) + (_e8779 * _e8812)) + (_e8781 * _e8811)) + (_e8781 * _e8812))));
                                                        let _e8856 = (1f / ((_e8807 + _e8834) + _e8853));
                                                        let _e8857 = (_e8834 * _e8856);
                                                        let _e8858 = (_e8853 * _e8856);
                                                        phi_12028_ = array<f32, 3>();
                                                        phi_12029_ = array<f32, 3>(((((_e8807 * _e8856) * _e8732) + (_e8857 * _e8733)) + (_e8858 * _e8734)), _e8857, _e8858);
                                                    }
                                                    let _e8868 = phi_12028_;
                                                    let _e8870 = phi_12029_;
                                                    phi_12030_ = _e8868;
                                                    phi_12031_ = _e8870;
                                                    phi_12032_ = _e8772;
                                                }
                                                let _e8872 = phi_12030_;
                                                let _e8874 = phi_12031_;
                                                let _e8876 = phi_12032_;
                                                phi_12033_ = _e8872;
                                                phi_12034_ = _e8874;
                                                phi_12035_ = _e8731;
                                                phi_12036_ = _e8876;
                                            } else {
                                                phi_12033_ = array<f32, 3>();
                                                phi_12034_ = array<f32, 3>();
                                                phi_12035_ = true;
                                                phi_12036_ = false;
                                            }
                                            let _e8878 = phi_12033_;
                                            let _e8880 = phi_12034_;
                                            let _e8882 = phi_12035_;
                                            let _e8884 = phi_12036_;
                                            if _e8882 {
                                                phi_12041_ = array<f32, 3>(-1f, 0f, 0f);
                                            } else {
                                                phi_12041_ = _e8878;
                                            }
                                            let _e8886 = phi_12041_;
                                            if select(_e8884, true, _e8882) {
                                                phi_12046_ = _e8886;
                                            } else {
                                                phi_12046_ = _e8880;
                                            }
                                            let _e8889 = phi_12046_;
                                            let _e8893 = (_e8889[0] >= 0f);
                                            if _e8893 {
                                                let _e8894 = (_e8889[0] < 340282350000000000000000000000000000000f);
                                                if _e8894 {
                                                    if _e8893 {
                                                        if _e8520 {
                                                        } else {
                                                            phi_17397_ = true;
                                                            phi_12554_ = bool();
                                                            break;
                                                        }
                                                        let _e8897 = triangles.member[_e8515.member_1].member_3;
                                                        if ((_e8897 & 1u) == 0u) {
                                                            phi_12378_ = true;
                                                        } else {
                                                            if _e8520 {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8902 = triangles.member[_e8515.member_1].member_1;
                                                            let _e8903 = (_e8902 * 12u);
                                                            if ((256u + _e8903) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 257u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 258u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8910 = (_e8903 + 259u);
                                                            if (_e8910 < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8913 = surfaces.member[_e8910];
                                                            if ((_e8903 + 260u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 261u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 262u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8920 = (_e8903 + 263u);
                                                            if (_e8920 < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8923 = surfaces.member[_e8920];
                                                            let _e8924 = (_e8903 + 264u);
                                                            if (_e8924 < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8927 = surfaces.member[_e8924];
                                                            let _e8928 = bitcast<f32>(_e8927);
                                                            let _e8929 = (_e8903 + 265u);
                                                            if (_e8929 < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            let _e8932 = surfaces.member[_e8929];
                                                            let _e8933 = bitcast<f32>(_e8932);
                                                            if ((_e8903 + 266u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 267u) < _e147) {
                                                            } else {
                                                                phi_17397_ = true;
                                                                phi_12554_ = bool();
                                                                break;
                                                            }
                                                            if (_e8913 == 4294967295u) {
                                                                phi_12373_ = (_e8928 < _e8933);
                                                            } else {
                                                                if (_e8515.member_1 < _e144) {
                                                                } else {
                                                                    phi_17397_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                let _e8941 = ((1f - _e8889[1]) - _e8889[2]);
                                                                let _e8945 = attributes.member[_e8515.member_1].member[0u];
                                                                let _e8950 = attributes.member[_e8515.member_1].member[2u];
                                                                let _e8956 = attributes.member[_e8515.member_1].member[4u];
                                                                let _e8958 = (((_e8945 * _e8941) + (_e8950 * _e8889[1])) + (_e8956 * _e8889[2]));
                                                                let _e8962 = attributes.member[_e8515.member_1].member[1u];
                                                                let _e8967 = attributes.member[_e8515.member_1].member[3u];
                                                                let _e8973 = attributes.member[_e8515.member_1].member[5u];
                                                                let _e8975 = (((_e8962 * _e8941) + (_e8967 * _e8889[1])) + (_e8973 * _e8889[2]));
                                                                let _e8976 = (_e8923 & 65535u);
                                                                let _e8978 = (_e8923 >> bitcast<u32>(16i));
                                                                let _e8980 = (_e8958 - floor(_e8958));
                                                                let _e8985 = ((select(0f, _e8980, (_e8980 <= 1f)) * f32(_e8976)) - 0.5f);
                                                                let _e8986 = floor(_e8985);
                                                                let _e8987 = (_e8985 - _e8986);
                                                                let _e8988 = (_e8976 - 1u);
                                                                if (_e8986 < 0f) {
                                                                    phi_12256_ = _e8988;
                                                                } else {
                                                                    let _e8994 = select(select(u32(_e8986), 0u, (_e8986 < 0f)), 4294967295u, (_e8986 > 4294967000f));
                                                                    phi_12256_ = select(_e8994, _e8988, (_e8988 < _e8994));
                                                                }
                                                                let _e8998 = phi_12256_;
                                                                if (_e8998 == _e8988) {
                                                                    phi_12262_ = 0u;
                                                                } else {
                                                                    phi_12262_ = (_e8998 + 1u);
                                                                }
                                                                let _e9002 = phi_12262_;
                                                                let _e9004 = (_e8975 - floor(_e8975));
                                                                let _e9009 = ((select(0f, _e9004, (_e9004 <= 1f)) * f32(_e8978)) - 0.5f);
                                                                let _e9010 = floor(_e9009);
                                                                let _e9011 = (_e9009 - _e9010);
                                                                let _e9012 = (_e8978 - 1u);
                                                                if (_e9010 < 0f) {
                                                                    phi_12292_ = _e9012;
                                                                } else {
                                                                    let _e9018 = select(select(u32(_e9010), 0u, (_e9010 < 0f)), 4294967295u, (_e9010 > 4294967000f));
                                                                    phi_12292_ = select(_e9018, _e9012, (_e9012 < _e9018));
                                                                }
                                                                let _e9022 = phi_12292_;
                                                                if (_e9022 == _e9012) {
                                                                    phi_12298_ = 0u;
                                                                } else {
                                                                    phi_12298_ = (_e9022 + 1u);
                                                                }
                                                                let _e9026 = phi_12298_;
                                                                let _e9028 = (_e8913 + (_e9022 * _e8976));
                                                                let _e9030 = (_e8913 + (_e9026 * _e8976));
                                                                let _e9031 = (_e9028 + _e8998);
                                                                let _e9032 = (_e9028 + _e9002);
                                                                let _e9033 = (_e9030 + _e8998);
                                                                let _e9034 = (_e9030 + _e9002);
                                                                if (_e9031 < _e147) {
                                                                } else {
                                                                    phi_17397_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                let _e9037 = surfaces.member[_e9031];
                                                                if (_e9032 < _e147) {
                                                                } else {
                                                                    phi_17397_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                let _e9040 = surfaces.member[_e9032];
                                                                if (_e9033 < _e147) {
                                                                } else {
                                                                    phi_17397_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                let _e9043 = surfaces.member[_e9033];
                                                                if (_e9034 < _e147) {
                                                                } else {
                                                                    phi_17397_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                let _e9046 = surfaces.member[_e9034];
                                                                let _e9063 = (1f - _e8987);
                                                                phi_12373_ = ((_e8928 * (((((f32((_e9037 >> bitcast<u32>(24i))) * 0.003921569f) * _e9063) + ((f32((_e9040 >> bitcast<u32>(24i))) * 0.003921569f) * _e8987)) * (1f - _e9011)) + ((((f32((_e9043 >> bitcast<u32>(24i))) * 0.003921569f) * _e9063) + ((f32((_e9046 >> bitcast<u32>(24i))) * 0.003921569f) * _e8987)) * _e9011))) < _e8933);
                                                            }
                                                            let _e9078 = phi_12373_;
                                                            phi_12378_ = select(true, false, _e9078);
                                                        }
                                                        let _e9081 = phi_12378_;
                                                        if _e9081 {
                                                            phi_12383_ = type_47(_e8889[0], _e8515.member_1, _e8889[1], _e8889[2]);
                                                        } else {
                                                            phi_12383_ = type_47();
                                                        }
                                                        let _e9084 = phi_12383_;
                                                        phi_12385_ = _e9084;
                                                        phi_12387_ = select(true, false, _e9081);
                                                    } else {
                                                        phi_12385_ = type_47();
                                                        phi_12387_ = false;
                                                    }
                                                    let _e9087 = phi_12385_;
                                                    let _e9089 = phi_12387_;
                                                    phi_12388_ = _e9087;
                                                    phi_12390_ = select(true, false, _e8893);
                                                    phi_12391_ = _e9089;
                                                } else {
                                                    phi_12388_ = type_47();
                                                    phi_12390_ = false;
                                                    phi_12391_ = false;
                                                }
                                                let _e9092 = phi_12388_;
                                                let _e9094 = phi_12390_;
                                                let _e9096 = phi_12391_;
                                                phi_12392_ = _e9092;
                                                phi_12393_ = select(true, false, _e8894);
                                                phi_12394_ = _e9094;
                                                phi_12395_ = _e9096;
                                            } else {
                                                phi_12392_ = type_47();
                                                phi_12393_ = true;
                                                phi_12394_ = false;
                                                phi_12395_ = false;
                                            }
                                            let _e9099 = phi_12392_;
                                            let _e9101 = phi_12393_;
                                            let _e9103 = phi_12394_;
                                            let _e9105 = phi_12395_;
                                            if select(select(_e9105, false, _e9101), true, select(_e9103, true, _e9101)) {
                                                phi_12408_ = type_47(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                            } else {
                                                phi_12408_ = _e9099;
                                            }
                                            let _e9110 = phi_12408_;
                                            phi_12415_ = select(true, false, (_e9110.member_1 != 4294967295u));
                                        } else {
                                            phi_12415_ = false;
                                        }
                                        let _e9115 = phi_12415_;
                                        continue;
                                        continuing {
                                            phi_11732_ = _e8513;
                                            phi_17397_ = _e8488;
                                            phi_12554_ = select(true, false, _e8519);
                                            break if !(_e9115);
                                        }
                                    }
                                    let _e9119 = phi_17397_;
                                    let _e9121 = phi_12554_;
                                    phi_17472_ = _e9119;
                                    phi_12555_ = bool();
                                    if _e9119 {
                                        break;
                                    }
                                    phi_17474_ = _e9119;
                                    phi_12420_ = _e8492;
                                    phi_12421_ = _e9121;
                                }
                                let _e9358 = phi_17474_;
                                let _e9360 = phi_12420_;
                                let _e9362 = phi_12421_;
                                if _e9362 {
                                    let _e9363 = (_e9360 == 0u);
                                    if _e9363 {
                                        phi_12437_ = u32();
                                        phi_12438_ = u32();
                                    } else {
                                        let _e9364 = (_e9360 - 1u);
                                        if (_e9364 < 64u) {
                                        } else {
                                            phi_17472_ = true;
                                            phi_12555_ = bool();
                                            break;
                                        }
                                        let _e9367 = local[_e9364];
                                        phi_12437_ = _e9367;
                                        phi_12438_ = _e9364;
                                    }
                                    let _e9369 = phi_12437_;
                                    let _e9371 = phi_12438_;
                                    phi_11305_ = _e9369;
                                    phi_11308_ = _e9371;
                                    phi_12440_ = select(true, false, _e9363);
                                    phi_12441_ = _e9363;
                                } else {
                                    phi_11305_ = u32();
                                    phi_11308_ = u32();
                                    phi_12440_ = false;
                                    phi_12441_ = false;
                                }
                                let _e9374 = phi_11305_;
                                let _e9376 = phi_11308_;
                                let _e9378 = phi_12440_;
                                let _e9380 = phi_12441_;
                                continue;
                                continuing {
                                    phi_17401_ = _e9358;
                                    phi_11304_ = _e9374;
                                    phi_11307_ = _e9376;
                                    phi_17472_ = _e9358;
                                    phi_12555_ = _e9380;
                                    break if !(_e9378);
                                }
                            }
                            let _e9383 = phi_17472_;
                            let _e9385 = phi_12555_;
                            phi_17532_ = _e9383;
                            if _e9383 {
                                break;
                            }
                            if select(false, true, select(true, false, _e9385)) {
                                phi_12454_ = _e8143;
                            } else {
                                phi_12454_ = (_e8143 + 1i);
                            }
                            let _e9390 = phi_12454_;
                            phi_17533_ = _e9383;
                            phi_10831_ = _e9390;
                        } else {
                            phi_17533_ = _e8139;
                            phi_10831_ = i32();
                        }
                        let _e9392 = phi_17533_;
                        let _e9394 = phi_10831_;
                        continue;
                        continuing {
                            phi_17420_ = _e9392;
                            phi_10827_ = _e8156;
                            phi_10830_ = _e9394;
                            phi_17532_ = _e9392;
                            break if !(_e8162);
                        }
                    }
                    let _e9397 = phi_17532_;
                    if _e9397 {
                        break;
                    }
                    let _e9399 = local_30;
                    let _e9402 = f32(_e8096);
                    let _e9405 = ((3.1415927f * f32(_e9399)) / select(1f, _e9402, (_e9402 > 1f)));
                    phi_12476_ = vec3<f32>((_e8092.x + (_e8100.x * _e9405)), (_e8092.y + (_e8100.y * _e9405)), (_e8092.z + (_e8100.z * _e9405)));
                } else {
                    phi_12476_ = _e8092;
                }
                let _e9417 = phi_12476_;
                if _e158 {
                } else {
                    break;
                }
                out.member[_e157] = vec4<f32>(_e9417.x, _e9417.y, _e9417.z, 0f);
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn voxel_inject(@builtin(global_invocation_id) gid: vec3<u32>) {
    gid_1 = gid;
    function_();
}
