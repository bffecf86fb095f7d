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
    member_16: vec4<u32>,
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
    var phi_16408_: bool;
    var phi_6098_: type_9;
    var phi_6101_: vec3<f32>;
    var phi_6099_: type_9;
    var phi_6124_: type_9;
    var phi_6138_: u32;
    var phi_6141_: u32;
    var phi_6165_: u32;
    var phi_6139_: u32;
    var phi_6142_: u32;
    var phi_16404_: bool;
    var local_21: u32;
    var local_22: u32;
    var phi_9365_: f32;
    var phi_9386_: f32;
    var phi_9415_: bool;
    var phi_9425_: u32;
    var phi_9428_: bool;
    var phi_9439_: u32;
    var phi_9569_: f32;
    var phi_9577_: f32;
    var phi_9585_: f32;
    var phi_16419_: bool;
    var phi_9588_: u32;
    var phi_9591_: u32;
    var phi_10016_: type_9;
    var phi_10017_: type_9;
    var phi_10040_: type_9;
    var phi_10156_: f32;
    var phi_10167_: f32;
    var phi_10178_: f32;
    var phi_10193_: f32;
    var phi_10194_: f32;
    var phi_10195_: bool;
    var phi_10196_: f32;
    var phi_10197_: bool;
    var phi_10216_: f32;
    var phi_10217_: bool;
    var phi_10218_: f32;
    var phi_10219_: bool;
    var phi_10220_: bool;
    var phi_10225_: f32;
    var phi_10226_: bool;
    var phi_10312_: array<f32, 3>;
    var phi_10313_: array<f32, 3>;
    var phi_10314_: array<f32, 3>;
    var phi_10315_: array<f32, 3>;
    var phi_10316_: bool;
    var phi_10317_: array<f32, 3>;
    var phi_10318_: array<f32, 3>;
    var phi_10319_: bool;
    var phi_10320_: bool;
    var phi_10325_: array<f32, 3>;
    var phi_10330_: array<f32, 3>;
    var phi_10541_: u32;
    var phi_10547_: u32;
    var phi_10577_: u32;
    var phi_10583_: u32;
    var phi_10658_: bool;
    var phi_10663_: bool;
    var phi_10668_: type_47;
    var phi_10670_: type_47;
    var phi_10672_: bool;
    var phi_10673_: type_47;
    var phi_10675_: bool;
    var phi_10676_: bool;
    var phi_10677_: type_47;
    var phi_10678_: bool;
    var phi_10679_: bool;
    var phi_10680_: bool;
    var phi_10693_: type_47;
    var phi_10700_: bool;
    var phi_16415_: bool;
    var phi_12549_: bool;
    var phi_9976_: u32;
    var phi_9988_: u32;
    var phi_10000_: u32;
    var phi_10012_: u32;
    var phi_16483_: bool;
    var phi_10705_: u32;
    var phi_10706_: bool;
    var phi_10722_: u32;
    var phi_10723_: u32;
    var phi_9589_: u32;
    var phi_9592_: u32;
    var phi_10725_: bool;
    var phi_10726_: bool;
    var phi_16481_: bool;
    var phi_12550_: bool;
    var phi_10743_: vec3<f32>;
    var phi_16808_: bool;
    var phi_10745_: vec3<f32>;
    var phi_10746_: bool;
    var phi_7933_: f32;
    var phi_7962_: bool;
    var phi_7972_: u32;
    var phi_7975_: bool;
    var phi_7986_: u32;
    var phi_8116_: f32;
    var phi_8124_: f32;
    var phi_8132_: f32;
    var phi_16545_: bool;
    var phi_8135_: u32;
    var phi_8138_: u32;
    var phi_8563_: type_9;
    var phi_8564_: type_9;
    var phi_8587_: type_9;
    var phi_8703_: f32;
    var phi_8714_: f32;
    var phi_8725_: f32;
    var phi_8740_: f32;
    var phi_8741_: f32;
    var phi_8742_: bool;
    var phi_8743_: f32;
    var phi_8744_: bool;
    var phi_8763_: f32;
    var phi_8764_: bool;
    var phi_8765_: f32;
    var phi_8766_: bool;
    var phi_8767_: bool;
    var phi_8772_: f32;
    var phi_8773_: bool;
    var phi_8859_: array<f32, 3>;
    var phi_8860_: array<f32, 3>;
    var phi_8861_: array<f32, 3>;
    var phi_8862_: array<f32, 3>;
    var phi_8863_: bool;
    var phi_8864_: array<f32, 3>;
    var phi_8865_: array<f32, 3>;
    var phi_8866_: bool;
    var phi_8867_: bool;
    var phi_8872_: array<f32, 3>;
    var phi_8877_: array<f32, 3>;
    var phi_9088_: u32;
    var phi_9094_: u32;
    var phi_9124_: u32;
    var phi_9130_: u32;
    var phi_9205_: bool;
    var phi_9210_: bool;
    var phi_9215_: type_47;
    var phi_9217_: type_47;
    var phi_9219_: bool;
    var phi_9220_: type_47;
    var phi_9222_: bool;
    var phi_9223_: bool;
    var phi_9224_: type_47;
    var phi_9225_: bool;
    var phi_9226_: bool;
    var phi_9227_: bool;
    var phi_9240_: type_47;
    var phi_9247_: bool;
    var phi_16541_: bool;
    var phi_12551_: bool;
    var phi_8523_: u32;
    var phi_8535_: u32;
    var phi_8547_: u32;
    var phi_8559_: u32;
    var phi_16603_: bool;
    var phi_9252_: u32;
    var phi_9253_: bool;
    var phi_9269_: u32;
    var phi_9270_: u32;
    var phi_8136_: u32;
    var phi_8139_: u32;
    var phi_9272_: bool;
    var phi_9273_: bool;
    var phi_16601_: bool;
    var phi_12552_: bool;
    var phi_9289_: vec3<f32>;
    var phi_16813_: bool;
    var phi_9290_: vec3<f32>;
    var phi_9291_: bool;
    var phi_16806_: bool;
    var phi_10751_: vec3<f32>;
    var phi_10752_: vec3<f32>;
    var phi_6272_: vec3<f32>;
    var phi_6274_: vec3<f32>;
    var phi_6275_: bool;
    var phi_16687_: bool;
    var phi_6297_: type_9;
    var phi_6302_: f32;
    var phi_6298_: type_9;
    var phi_6327_: type_9;
    var phi_13056_: f32;
    var phi_13064_: f32;
    var phi_6388_: vec2<f32>;
    var phi_6491_: f32;
    var phi_6520_: bool;
    var phi_6530_: u32;
    var phi_6533_: bool;
    var phi_6544_: u32;
    var phi_6674_: f32;
    var phi_6682_: f32;
    var phi_6690_: f32;
    var phi_16665_: bool;
    var phi_6693_: u32;
    var phi_6696_: u32;
    var phi_7121_: type_9;
    var phi_7122_: type_9;
    var phi_7145_: type_9;
    var phi_7261_: f32;
    var phi_7272_: f32;
    var phi_7283_: f32;
    var phi_7298_: f32;
    var phi_7299_: f32;
    var phi_7300_: bool;
    var phi_7301_: f32;
    var phi_7302_: bool;
    var phi_7321_: f32;
    var phi_7322_: bool;
    var phi_7323_: f32;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7330_: f32;
    var phi_7331_: bool;
    var phi_7417_: array<f32, 3>;
    var phi_7418_: array<f32, 3>;
    var phi_7419_: array<f32, 3>;
    var phi_7420_: array<f32, 3>;
    var phi_7421_: bool;
    var phi_7422_: array<f32, 3>;
    var phi_7423_: array<f32, 3>;
    var phi_7424_: bool;
    var phi_7425_: bool;
    var phi_7430_: array<f32, 3>;
    var phi_7435_: array<f32, 3>;
    var phi_7646_: u32;
    var phi_7652_: u32;
    var phi_7682_: u32;
    var phi_7688_: u32;
    var phi_7763_: bool;
    var phi_7768_: bool;
    var phi_7773_: type_47;
    var phi_7775_: type_47;
    var phi_7777_: bool;
    var phi_7778_: type_47;
    var phi_7780_: bool;
    var phi_7781_: bool;
    var phi_7782_: type_47;
    var phi_7783_: bool;
    var phi_7784_: bool;
    var phi_7785_: bool;
    var phi_7798_: type_47;
    var phi_7805_: bool;
    var phi_16661_: bool;
    var phi_12553_: bool;
    var phi_7081_: u32;
    var phi_7093_: u32;
    var phi_7105_: u32;
    var phi_7117_: u32;
    var phi_16737_: bool;
    var phi_7810_: u32;
    var phi_7811_: bool;
    var phi_7827_: u32;
    var phi_7828_: u32;
    var phi_6694_: u32;
    var phi_6697_: u32;
    var phi_7830_: bool;
    var phi_7831_: bool;
    var phi_16735_: bool;
    var phi_12554_: bool;
    var phi_7845_: f32;
    var phi_16797_: bool;
    var phi_7846_: f32;
    var phi_16796_: bool;
    var phi_6303_: f32;
    var phi_16795_: bool;
    var local_23: f32;
    var local_24: f32;
    var phi_7875_: f32;
    var phi_16818_: bool;
    var phi_7881_: f32;
    var phi_16805_: bool;
    var phi_10753_: vec3<f32>;
    var phi_10754_: vec3<f32>;
    var phi_10755_: bool;
    var phi_16803_: bool;
    var phi_10775_: vec3<f32>;
    var phi_16802_: bool;
    var phi_6102_: vec3<f32>;
    var phi_16801_: bool;
    var phi_16930_: bool;
    var phi_1446_: type_9;
    var phi_1449_: vec3<f32>;
    var phi_1447_: type_9;
    var phi_1472_: type_9;
    var phi_4678_: f32;
    var phi_4699_: f32;
    var phi_4728_: bool;
    var phi_4738_: u32;
    var phi_4741_: bool;
    var phi_4752_: u32;
    var phi_4882_: f32;
    var phi_4890_: f32;
    var phi_4898_: f32;
    var phi_16913_: bool;
    var phi_4901_: u32;
    var phi_4904_: u32;
    var phi_5329_: type_9;
    var phi_5330_: type_9;
    var phi_5353_: type_9;
    var phi_5469_: f32;
    var phi_5480_: f32;
    var phi_5491_: f32;
    var phi_5506_: f32;
    var phi_5507_: f32;
    var phi_5508_: bool;
    var phi_5509_: f32;
    var phi_5510_: bool;
    var phi_5529_: f32;
    var phi_5530_: bool;
    var phi_5531_: f32;
    var phi_5532_: bool;
    var phi_5533_: bool;
    var phi_5538_: f32;
    var phi_5539_: bool;
    var phi_5625_: array<f32, 3>;
    var phi_5626_: array<f32, 3>;
    var phi_5627_: array<f32, 3>;
    var phi_5628_: array<f32, 3>;
    var phi_5629_: bool;
    var phi_5630_: array<f32, 3>;
    var phi_5631_: array<f32, 3>;
    var phi_5632_: bool;
    var phi_5633_: bool;
    var phi_5638_: array<f32, 3>;
    var phi_5643_: array<f32, 3>;
    var phi_5854_: u32;
    var phi_5860_: u32;
    var phi_5890_: u32;
    var phi_5896_: u32;
    var phi_5971_: bool;
    var phi_5976_: bool;
    var phi_5981_: type_47;
    var phi_5983_: type_47;
    var phi_5985_: bool;
    var phi_5986_: type_47;
    var phi_5988_: bool;
    var phi_5989_: bool;
    var phi_5990_: type_47;
    var phi_5991_: bool;
    var phi_5992_: bool;
    var phi_5993_: bool;
    var phi_6006_: type_47;
    var phi_6013_: bool;
    var phi_16909_: bool;
    var phi_12555_: bool;
    var phi_5289_: u32;
    var phi_5301_: u32;
    var phi_5313_: u32;
    var phi_5325_: u32;
    var phi_16979_: bool;
    var phi_6018_: u32;
    var phi_6019_: bool;
    var phi_6035_: u32;
    var phi_6036_: u32;
    var phi_4902_: u32;
    var phi_4905_: u32;
    var phi_6038_: bool;
    var phi_6039_: bool;
    var phi_16977_: bool;
    var phi_12556_: bool;
    var phi_6056_: vec3<f32>;
    var phi_17303_: bool;
    var phi_6058_: vec3<f32>;
    var phi_6059_: bool;
    var phi_3246_: f32;
    var phi_3275_: bool;
    var phi_3285_: u32;
    var phi_3288_: bool;
    var phi_3299_: u32;
    var phi_3429_: f32;
    var phi_3437_: f32;
    var phi_3445_: f32;
    var phi_17041_: bool;
    var phi_3448_: u32;
    var phi_3451_: u32;
    var phi_3876_: type_9;
    var phi_3877_: type_9;
    var phi_3900_: type_9;
    var phi_4016_: f32;
    var phi_4027_: f32;
    var phi_4038_: f32;
    var phi_4053_: f32;
    var phi_4054_: f32;
    var phi_4055_: bool;
    var phi_4056_: f32;
    var phi_4057_: bool;
    var phi_4076_: f32;
    var phi_4077_: bool;
    var phi_4078_: f32;
    var phi_4079_: bool;
    var phi_4080_: bool;
    var phi_4085_: f32;
    var phi_4086_: bool;
    var phi_4172_: array<f32, 3>;
    var phi_4173_: array<f32, 3>;
    var phi_4174_: array<f32, 3>;
    var phi_4175_: array<f32, 3>;
    var phi_4176_: bool;
    var phi_4177_: array<f32, 3>;
    var phi_4178_: array<f32, 3>;
    var phi_4179_: bool;
    var phi_4180_: bool;
    var phi_4185_: array<f32, 3>;
    var phi_4190_: array<f32, 3>;
    var phi_4401_: u32;
    var phi_4407_: u32;
    var phi_4437_: u32;
    var phi_4443_: u32;
    var phi_4518_: bool;
    var phi_4523_: bool;
    var phi_4528_: type_47;
    var phi_4530_: type_47;
    var phi_4532_: bool;
    var phi_4533_: type_47;
    var phi_4535_: bool;
    var phi_4536_: bool;
    var phi_4537_: type_47;
    var phi_4538_: bool;
    var phi_4539_: bool;
    var phi_4540_: bool;
    var phi_4553_: type_47;
    var phi_4560_: bool;
    var phi_17037_: bool;
    var phi_12557_: bool;
    var phi_3836_: u32;
    var phi_3848_: u32;
    var phi_3860_: u32;
    var phi_3872_: u32;
    var phi_17099_: bool;
    var phi_4565_: u32;
    var phi_4566_: bool;
    var phi_4582_: u32;
    var phi_4583_: u32;
    var phi_3449_: u32;
    var phi_3452_: u32;
    var phi_4585_: bool;
    var phi_4586_: bool;
    var phi_17097_: bool;
    var phi_12558_: bool;
    var phi_4602_: vec3<f32>;
    var phi_17308_: bool;
    var phi_4603_: vec3<f32>;
    var phi_4604_: bool;
    var phi_17301_: bool;
    var phi_6064_: vec3<f32>;
    var phi_6065_: vec3<f32>;
    var phi_1585_: vec3<f32>;
    var phi_1587_: vec3<f32>;
    var phi_1588_: bool;
    var phi_17183_: bool;
    var phi_1610_: type_9;
    var phi_1613_: f32;
    var phi_1615_: f32;
    var phi_1617_: f32;
    var phi_1611_: type_9;
    var phi_1640_: type_9;
    var phi_14847_: f32;
    var phi_14855_: f32;
    var phi_1701_: vec2<f32>;
    var phi_1804_: f32;
    var phi_1833_: bool;
    var phi_1843_: u32;
    var phi_1846_: bool;
    var phi_1857_: u32;
    var phi_1987_: f32;
    var phi_1995_: f32;
    var phi_2003_: f32;
    var phi_17161_: bool;
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
    var phi_2959_: u32;
    var phi_2965_: u32;
    var phi_2995_: u32;
    var phi_3001_: u32;
    var phi_3076_: bool;
    var phi_3081_: bool;
    var phi_3086_: type_47;
    var phi_3088_: type_47;
    var phi_3090_: bool;
    var phi_3091_: type_47;
    var phi_3093_: bool;
    var phi_3094_: bool;
    var phi_3095_: type_47;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3111_: type_47;
    var phi_3118_: bool;
    var phi_17157_: bool;
    var phi_12559_: bool;
    var phi_2394_: u32;
    var phi_2406_: u32;
    var phi_2418_: u32;
    var phi_2430_: u32;
    var phi_17233_: bool;
    var phi_3123_: u32;
    var phi_3124_: bool;
    var phi_3140_: u32;
    var phi_3141_: u32;
    var phi_2007_: u32;
    var phi_2010_: u32;
    var phi_3143_: bool;
    var phi_3144_: bool;
    var phi_17231_: bool;
    var phi_12560_: bool;
    var phi_3158_: f32;
    var phi_17293_: bool;
    var phi_3159_: f32;
    var phi_17292_: bool;
    var phi_1614_: f32;
    var phi_1616_: f32;
    var phi_1618_: f32;
    var phi_17291_: bool;
    var local_25: f32;
    var local_26: f32;
    var phi_15165_: bool;
    var phi_15176_: bool;
    var phi_15197_: type_60;
    var phi_15201_: type_60;
    var phi_15202_: vec3<f32>;
    var phi_15203_: vec3<f32>;
    var phi_15243_: vec3<f32>;
    var phi_15246_: vec3<f32>;
    var phi_15247_: bool;
    var phi_15291_: vec3<f32>;
    var phi_15294_: vec3<f32>;
    var phi_15295_: bool;
    var phi_15362_: f32;
    var phi_15370_: f32;
    var phi_15385_: f32;
    var phi_15391_: f32;
    var phi_15399_: f32;
    var phi_15409_: f32;
    var phi_15414_: type_60;
    var phi_15424_: bool;
    var phi_15435_: bool;
    var phi_15456_: type_60;
    var phi_15460_: type_60;
    var phi_15461_: vec3<f32>;
    var phi_15462_: vec3<f32>;
    var phi_15502_: vec3<f32>;
    var phi_15505_: vec3<f32>;
    var phi_15506_: bool;
    var phi_15550_: vec3<f32>;
    var phi_15553_: vec3<f32>;
    var phi_15554_: bool;
    var phi_15621_: f32;
    var phi_15629_: f32;
    var phi_15644_: f32;
    var phi_15650_: f32;
    var phi_15658_: f32;
    var phi_15668_: f32;
    var phi_15673_: type_60;
    var phi_15683_: bool;
    var phi_15715_: type_60;
    var phi_15719_: type_60;
    var phi_15720_: vec3<f32>;
    var phi_15721_: vec3<f32>;
    var phi_15761_: vec3<f32>;
    var phi_15764_: vec3<f32>;
    var phi_15765_: bool;
    var phi_15809_: vec3<f32>;
    var phi_15812_: vec3<f32>;
    var phi_15813_: bool;
    var phi_15880_: f32;
    var phi_15888_: f32;
    var phi_15903_: f32;
    var phi_15909_: f32;
    var phi_15917_: f32;
    var phi_15927_: f32;
    var phi_15932_: type_60;
    var phi_15974_: vec3<f32>;
    var phi_15977_: vec3<f32>;
    var phi_15978_: bool;
    var phi_16022_: vec3<f32>;
    var phi_16025_: vec3<f32>;
    var phi_16026_: bool;
    var phi_16093_: f32;
    var phi_16101_: f32;
    var phi_16116_: f32;
    var phi_16122_: f32;
    var phi_16130_: f32;
    var phi_16140_: f32;
    var local_27: f32;
    var local_28: f32;
    var phi_3177_: f32;
    var phi_3178_: f32;
    var phi_3179_: bool;
    var local_29: f32;
    var phi_3187_: f32;
    var phi_3188_: f32;
    var phi_3189_: f32;
    var phi_3190_: bool;
    var phi_17313_: bool;
    var phi_3194_: f32;
    var phi_3195_: f32;
    var phi_3196_: bool;
    var phi_17300_: bool;
    var phi_6066_: vec3<f32>;
    var phi_6067_: vec3<f32>;
    var phi_6068_: bool;
    var phi_17298_: bool;
    var phi_1450_: vec3<f32>;
    var phi_17297_: bool;
    var phi_17428_: bool;
    var phi_10776_: vec3<f32>;
    var phi_17427_: bool;
    var phi_10833_: type_9;
    var phi_10836_: i32;
    var phi_10834_: type_9;
    var phi_10859_: type_9;
    var phi_16152_: f32;
    var phi_16160_: f32;
    var phi_10923_: vec2<f32>;
    var phi_10924_: bool;
    var phi_11054_: f32;
    var phi_11062_: f32;
    var phi_10988_: f32;
    var phi_10996_: f32;
    var phi_11066_: vec2<f32>;
    var phi_11067_: vec2<f32>;
    var phi_11111_: f32;
    var phi_11137_: bool;
    var phi_11147_: u32;
    var phi_11150_: bool;
    var phi_11161_: u32;
    var phi_11291_: f32;
    var phi_11299_: f32;
    var phi_11307_: f32;
    var phi_17408_: bool;
    var phi_11310_: u32;
    var phi_11313_: u32;
    var phi_11738_: type_9;
    var phi_11739_: type_9;
    var phi_11762_: type_9;
    var phi_11878_: f32;
    var phi_11889_: f32;
    var phi_11900_: f32;
    var phi_11915_: f32;
    var phi_11916_: f32;
    var phi_11917_: bool;
    var phi_11918_: f32;
    var phi_11919_: bool;
    var phi_11938_: f32;
    var phi_11939_: bool;
    var phi_11940_: f32;
    var phi_11941_: bool;
    var phi_11942_: bool;
    var phi_11947_: f32;
    var phi_11948_: bool;
    var phi_12034_: array<f32, 3>;
    var phi_12035_: array<f32, 3>;
    var phi_12036_: array<f32, 3>;
    var phi_12037_: array<f32, 3>;
    var phi_12038_: bool;
    var phi_12039_: array<f32, 3>;
    var phi_12040_: array<f32, 3>;
    var phi_12041_: bool;
    var phi_12042_: bool;
    var phi_12047_: array<f32, 3>;
    var phi_12052_: array<f32, 3>;
    var phi_12263_: u32;
    var phi_12269_: u32;
    var phi_12299_: u32;
    var phi_12305_: u32;
    var phi_12380_: bool;
    var phi_12385_: bool;
    var phi_12390_: type_47;
    var phi_12392_: type_47;
    var phi_12394_: bool;
    var phi_12395_: type_47;
    var phi_12397_: bool;
    var phi_12398_: bool;
    var phi_12399_: type_47;
    var phi_12400_: bool;
    var phi_12401_: bool;
    var phi_12402_: bool;
    var phi_12415_: type_47;
    var phi_12422_: bool;
    var phi_17404_: bool;
    var phi_12561_: bool;
    var phi_11698_: u32;
    var phi_11710_: u32;
    var phi_11722_: u32;
    var phi_11734_: u32;
    var phi_17481_: bool;
    var phi_12427_: u32;
    var phi_12428_: bool;
    var phi_12444_: u32;
    var phi_12445_: u32;
    var phi_11311_: u32;
    var phi_11314_: u32;
    var phi_12447_: bool;
    var phi_12448_: bool;
    var phi_17479_: bool;
    var phi_12562_: bool;
    var phi_12461_: i32;
    var phi_17540_: bool;
    var phi_10837_: i32;
    var phi_17539_: bool;
    var local_30: i32;
    var phi_12483_: vec3<f32>;
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
                let _e211 = params.member.member_16[0u];
                let _e215 = params.member.member_16[1u];
                let _e219 = params.member.member_16[3u];
                let _e223 = ((_e157 ^ (_e157 >> bitcast<u32>(16i))) * 2146121005u);
                let _e227 = ((_e223 ^ (_e223 >> bitcast<u32>(15i))) * 2221713035u);
                let _e231 = (_e219 ^ (_e227 ^ (_e227 >> bitcast<u32>(16i))));
                let _e235 = ((_e231 ^ (_e231 >> bitcast<u32>(16i))) * 2146121005u);
                let _e239 = ((_e235 ^ (_e235 >> bitcast<u32>(15i))) * 2221713035u);
                let _e242 = (_e239 ^ (_e239 >> bitcast<u32>(16i)));
                if (_e211 <= 64u) {
                    phi_16930_ = false;
                    phi_1446_ = type_9(0u, _e211);
                    phi_1449_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e3796 = phi_16930_;
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
                                phi_17297_ = true;
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
                                    phi_17313_ = _e3796;
                                    phi_3194_ = 0f;
                                    phi_3195_ = f32();
                                    phi_3196_ = true;
                                } else {
                                    phi_17183_ = _e3796;
                                    phi_1610_ = type_9(0u, _e215);
                                    phi_1613_ = 340282350000000000000000000000000000000f;
                                    phi_1615_ = 0f;
                                    phi_1617_ = 0f;
                                    loop {
                                        let _e6072 = phi_17183_;
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
                                                phi_14847_ = (_e6140 - 1f);
                                            } else {
                                                phi_14847_ = _e6140;
                                            }
                                            let _e6144 = phi_14847_;
                                            let _e6146 = (0.000000059604645f * (f32(((2147483648u + (_e6095.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e6122 ^ (_e6122 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                            if (_e6146 >= 1f) {
                                                phi_14855_ = (_e6146 - 1f);
                                            } else {
                                                phi_14855_ = _e6146;
                                            }
                                            let _e6150 = phi_14855_;
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
                                                    phi_17291_ = true;
                                                    break;
                                                }
                                                let _e6268 = local_19[_e6263];
                                                let _e6269 = (1f / _e6268);
                                                let _e6270 = (_e6262 < 3u);
                                                if _e6270 {
                                                } else {
                                                    phi_17291_ = true;
                                                    break;
                                                }
                                                let _e6272 = local_19[_e6262];
                                                let _e6273 = (_e6272 * _e6269);
                                                let _e6274 = (_e6261 < 3u);
                                                if _e6274 {
                                                } else {
                                                    phi_17291_ = true;
                                                    break;
                                                }
                                                let _e6276 = local_19[_e6261];
                                                let _e6277 = (_e6276 * _e6269);
                                                if _e6270 {
                                                } else {
                                                    phi_17291_ = true;
                                                    break;
                                                }
                                                let _e6279 = local_20[_e6262];
                                                if _e6274 {
                                                } else {
                                                    phi_17291_ = true;
                                                    break;
                                                }
                                                let _e6281 = local_20[_e6261];
                                                if _e6266 {
                                                } else {
                                                    phi_17291_ = true;
                                                    break;
                                                }
                                                let _e6283 = local_20[_e6263];
                                                if (0u < _e138) {
                                                } else {
                                                    phi_17291_ = true;
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
                                                phi_17161_ = _e6072;
                                                phi_2006_ = 0u;
                                                phi_2009_ = 0u;
                                                loop {
                                                    let _e6348 = phi_17161_;
                                                    let _e6350 = phi_2006_;
                                                    let _e6352 = phi_2009_;
                                                    let _e6353 = (_e6350 & 15u);
                                                    let _e6355 = (_e6350 >> bitcast<u32>(4u));
                                                    if (_e6353 == 0u) {
                                                        if (_e6355 < _e138) {
                                                        } else {
                                                            phi_17231_ = true;
                                                            phi_12560_ = bool();
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
                                                                phi_17231_ = true;
                                                                phi_12560_ = bool();
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
                                                                phi_17231_ = true;
                                                                phi_12560_ = bool();
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
                                                                phi_17231_ = true;
                                                                phi_12560_ = bool();
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
                                                                phi_17231_ = true;
                                                                phi_12560_ = bool();
                                                                break;
                                                            }
                                                            local_18[_e7210] = _e7180;
                                                            phi_2430_ = (_e7210 + 1u);
                                                        } else {
                                                            phi_2430_ = _e7210;
                                                        }
                                                        let _e7216 = phi_2430_;
                                                        phi_17233_ = _e6348;
                                                        phi_3123_ = _e7216;
                                                        phi_3124_ = true;
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
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                if _e6266 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6384 = triangles.member[_e6375.member_1].member[_e6263];
                                                                let _e6385 = (_e6384 - _e6283);
                                                                if _e6266 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6389 = triangles.member[_e6375.member_1].member_2[_e6263];
                                                                let _e6390 = (_e6389 - _e6283);
                                                                if _e6266 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6394 = triangles.member[_e6375.member_1].member_4[_e6263];
                                                                let _e6395 = (_e6394 - _e6283);
                                                                if _e6270 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6399 = triangles.member[_e6375.member_1].member[_e6262];
                                                                let _e6402 = ((_e6399 - _e6279) - (_e6273 * _e6385));
                                                                if _e6274 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6406 = triangles.member[_e6375.member_1].member[_e6261];
                                                                let _e6409 = ((_e6406 - _e6281) - (_e6277 * _e6385));
                                                                if _e6270 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6413 = triangles.member[_e6375.member_1].member_2[_e6262];
                                                                let _e6416 = ((_e6413 - _e6279) - (_e6273 * _e6390));
                                                                if _e6274 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6420 = triangles.member[_e6375.member_1].member_2[_e6261];
                                                                let _e6423 = ((_e6420 - _e6281) - (_e6277 * _e6390));
                                                                if _e6270 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
                                                                    break;
                                                                }
                                                                let _e6427 = triangles.member[_e6375.member_1].member_4[_e6262];
                                                                let _e6430 = ((_e6427 - _e6279) - (_e6273 * _e6395));
                                                                if _e6274 {
                                                                } else {
                                                                    phi_17157_ = true;
                                                                    phi_12559_ = bool();
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
                                                                                phi_17157_ = true;
                                                                                phi_12559_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e6757 = triangles.member[_e6375.member_1].member_3;
                                                                            if ((_e6757 & 1u) == 0u) {
                                                                                phi_3081_ = true;
                                                                            } else {
                                                                                if _e6380 {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6762 = triangles.member[_e6375.member_1].member_1;
                                                                                let _e6763 = (_e6762 * 12u);
                                                                                if ((256u + _e6763) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 257u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 258u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6770 = (_e6763 + 259u);
                                                                                if (_e6770 < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6773 = surfaces.member[_e6770];
                                                                                if ((_e6763 + 260u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 261u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 262u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6780 = (_e6763 + 263u);
                                                                                if (_e6780 < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6783 = surfaces.member[_e6780];
                                                                                let _e6784 = (_e6763 + 264u);
                                                                                if (_e6784 < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6787 = surfaces.member[_e6784];
                                                                                let _e6788 = bitcast<f32>(_e6787);
                                                                                let _e6789 = (_e6763 + 265u);
                                                                                if (_e6789 < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e6792 = surfaces.member[_e6789];
                                                                                let _e6793 = bitcast<f32>(_e6792);
                                                                                if ((_e6763 + 266u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                if ((_e6763 + 267u) < _e147) {
                                                                                } else {
                                                                                    phi_17157_ = true;
                                                                                    phi_12559_ = bool();
                                                                                    break;
                                                                                }
                                                                                if (_e6773 == 4294967295u) {
                                                                                    phi_3076_ = (_e6788 < _e6793);
                                                                                } else {
                                                                                    if (_e6375.member_1 < _e144) {
                                                                                    } else {
                                                                                        phi_17157_ = true;
                                                                                        phi_12559_ = bool();
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
                                                                                        phi_2959_ = _e6848;
                                                                                    } else {
                                                                                        let _e6854 = select(select(u32(_e6846), 0u, (_e6846 < 0f)), 4294967295u, (_e6846 > 4294967000f));
                                                                                        phi_2959_ = select(_e6854, _e6848, (_e6848 < _e6854));
                                                                                    }
                                                                                    let _e6858 = phi_2959_;
                                                                                    if (_e6858 == _e6848) {
                                                                                        phi_2965_ = 0u;
                                                                                    } else {
                                                                                        phi_2965_ = (_e6858 + 1u);
                                                                                    }
                                                                                    let _e6862 = phi_2965_;
                                                                                    let _e6864 = (_e6835 - floor(_e6835));
                                                                                    let _e6869 = ((select(0f, _e6864, (_e6864 <= 1f)) * f32(_e6838)) - 0.5f);
                                                                                    let _e6870 = floor(_e6869);
                                                                                    let _e6871 = (_e6869 - _e6870);
                                                                                    let _e6872 = (_e6838 - 1u);
                                                                                    if (_e6870 < 0f) {
                                                                                        phi_2995_ = _e6872;
                                                                                    } else {
                                                                                        let _e6878 = select(select(u32(_e6870), 0u, (_e6870 < 0f)), 4294967295u, (_e6870 > 4294967000f));
                                                                                        phi_2995_ = select(_e6878, _e6872, (_e6872 < _e6878));
                                                                                    }
                                                                                    let _e6882 = phi_2995_;
                                                                                    if (_e6882 == _e6872) {
                                                                                        phi_3001_ = 0u;
                                                                                    } else {
                                                                                        phi_3001_ = (_e6882 + 1u);
                                                                                    }
                                                                                    let _e6886 = phi_3001_;
                                                                                    let _e6888 = (_e6773 + (_e6882 * _e6836));
                                                                                    let _e6890 = (_e6773 + (_e6886 * _e6836));
                                                                                    let _e6891 = (_e6888 + _e6858);
                                                                                    let _e6892 = (_e6888 + _e6862);
                                                                                    let _e6893 = (_e6890 + _e6858);
                                                                                    let _e6894 = (_e6890 + _e6862);
                                                                                    if (_e6891 < _e147) {
                                                                                    } else {
                                                                                        phi_17157_ = true;
                                                                                        phi_12559_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6897 = surfaces.member[_e6891];
                                                                                    if (_e6892 < _e147) {
                                                                                    } else {
                                                                                        phi_17157_ = true;
                                                                                        phi_12559_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6900 = surfaces.member[_e6892];
                                                                                    if (_e6893 < _e147) {
                                                                                    } else {
                                                                                        phi_17157_ = true;
                                                                                        phi_12559_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6903 = surfaces.member[_e6893];
                                                                                    if (_e6894 < _e147) {
                                                                                    } else {
                                                                                        phi_17157_ = true;
                                                                                        phi_12559_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e6906 = surfaces.member[_e6894];
                                                                                    let _e6923 = (1f - _e6847);
                                                                                    phi_3076_ = ((_e6788 * (((((f32((_e6897 >> bitcast<u32>(24i))) * 0.003921569f) * _e6923) + ((f32((_e6900 >> bitcast<u32>(24i))) * 0.003921569f) * _e6847)) * (1f - _e6871)) + ((((f32((_e6903 >> bitcast<u32>(24i))) * 0.003921569f) * _e6923) + ((f32((_e6906 >> bitcast<u32>(24i))) * 0.003921569f) * _e6847)) * _e6871))) < _e6793);
                                                                                }
                                                                                let _e6938 = phi_3076_;
                                                                                phi_3081_ = select(true, false, _e6938);
                                                                            }
                                                                            let _e6941 = phi_3081_;
                                                                            if _e6941 {
                                                                                phi_3086_ = type_47(_e6749[0], _e6375.member_1, _e6749[1], _e6749[2]);
                                                                            } else {
                                                                                phi_3086_ = type_47();
                                                                            }
                                                                            let _e6944 = phi_3086_;
                                                                            phi_3088_ = _e6944;
                                                                            phi_3090_ = select(true, false, _e6941);
                                                                        } else {
                                                                            phi_3088_ = type_47();
                                                                            phi_3090_ = false;
                                                                        }
                                                                        let _e6947 = phi_3088_;
                                                                        let _e6949 = phi_3090_;
                                                                        phi_3091_ = _e6947;
                                                                        phi_3093_ = select(true, false, _e6753);
                                                                        phi_3094_ = _e6949;
                                                                    } else {
                                                                        phi_3091_ = type_47();
                                                                        phi_3093_ = false;
                                                                        phi_3094_ = false;
                                                                    }
                                                                    let _e6952 = phi_3091_;
                                                                    let _e6954 = phi_3093_;
                                                                    let _e6956 = phi_3094_;
                                                                    phi_3095_ = _e6952;
                                                                    phi_3096_ = select(true, false, _e6754);
                                                                    phi_3097_ = _e6954;
                                                                    phi_3098_ = _e6956;
                                                                } else {
                                                                    phi_3095_ = type_47();
                                                                    phi_3096_ = true;
                                                                    phi_3097_ = false;
                                                                    phi_3098_ = false;
                                                                }
                                                                let _e6959 = phi_3095_;
                                                                let _e6961 = phi_3096_;
                                                                let _e6963 = phi_3097_;
                                                                let _e6965 = phi_3098_;
                                                                if select(select(_e6965, false, _e6961), true, select(_e6963, true, _e6961)) {
                                                                    phi_3111_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                                } else {
                                                                    phi_3111_ = _e6959;
                                                                }
                                                                let _e6970 = phi_3111_;
                                                                phi_3118_ = select(true, false, (_e6970.member_1 != 4294967295u));
                                                            } else {
                                                                phi_3118_ = false;
                                                            }
                                                            let _e6975 = phi_3118_;
                                                            continue;
                                                            continuing {
                                                                phi_2434_ = _e6373;
                                                                phi_17157_ = _e6348;
                                                                phi_12559_ = select(true, false, _e6379);
                                                                break if !(_e6975);
                                                            }
                                                        }
                                                        let _e6979 = phi_17157_;
                                                        let _e6981 = phi_12559_;
                                                        phi_17231_ = _e6979;
                                                        phi_12560_ = bool();
                                                        if _e6979 {
                                                            break;
                                                        }
                                                        phi_17233_ = _e6979;
                                                        phi_3123_ = _e6352;
                                                        phi_3124_ = _e6981;
                                                    }
                                                    let _e7218 = phi_17233_;
                                                    let _e7220 = phi_3123_;
                                                    let _e7222 = phi_3124_;
                                                    if _e7222 {
                                                        let _e7223 = (_e7220 == 0u);
                                                        if _e7223 {
                                                            phi_3140_ = u32();
                                                            phi_3141_ = u32();
                                                        } else {
                                                            let _e7224 = (_e7220 - 1u);
                                                            if (_e7224 < 64u) {
                                                            } else {
                                                                phi_17231_ = true;
                                                                phi_12560_ = bool();
                                                                break;
                                                            }
                                                            let _e7227 = local_18[_e7224];
                                                            phi_3140_ = _e7227;
                                                            phi_3141_ = _e7224;
                                                        }
                                                        let _e7229 = phi_3140_;
                                                        let _e7231 = phi_3141_;
                                                        phi_2007_ = _e7229;
                                                        phi_2010_ = _e7231;
                                                        phi_3143_ = select(true, false, _e7223);
                                                        phi_3144_ = _e7223;
                                                    } else {
                                                        phi_2007_ = u32();
                                                        phi_2010_ = u32();
                                                        phi_3143_ = false;
                                                        phi_3144_ = false;
                                                    }
                                                    let _e7234 = phi_2007_;
                                                    let _e7236 = phi_2010_;
                                                    let _e7238 = phi_3143_;
                                                    let _e7240 = phi_3144_;
                                                    continue;
                                                    continuing {
                                                        phi_17161_ = _e7218;
                                                        phi_2006_ = _e7234;
                                                        phi_2009_ = _e7236;
                                                        phi_17231_ = _e7218;
                                                        phi_12560_ = _e7240;
                                                        break if !(_e7238);
                                                    }
                                                }
                                                let _e7243 = phi_17231_;
                                                let _e7245 = phi_12560_;
                                                phi_17291_ = _e7243;
                                                if _e7243 {
                                                    break;
                                                }
                                                if !(select(false, true, select(true, false, _e7245))) {
                                                    phi_3158_ = (_e6078 + _e6198);
                                                } else {
                                                    phi_3158_ = _e6078;
                                                }
                                                let _e7251 = phi_3158_;
                                                phi_17293_ = _e7243;
                                                phi_3159_ = _e7251;
                                            } else {
                                                phi_17293_ = _e6072;
                                                phi_3159_ = _e6078;
                                            }
                                            let _e7253 = phi_17293_;
                                            let _e7255 = phi_3159_;
                                            phi_17292_ = _e7253;
                                            phi_1614_ = select(_e6181, _e6076, (_e6076 < _e6181));
                                            phi_1616_ = _e7255;
                                            phi_1618_ = (_e6080 + _e6198);
                                        } else {
                                            phi_17292_ = _e6072;
                                            phi_1614_ = f32();
                                            phi_1616_ = f32();
                                            phi_1618_ = f32();
                                        }
                                        let _e7257 = phi_17292_;
                                        let _e7259 = phi_1614_;
                                        let _e7261 = phi_1616_;
                                        let _e7263 = phi_1618_;
                                        continue;
                                        continuing {
                                            phi_17183_ = _e7257;
                                            phi_1610_ = _e6093;
                                            phi_1613_ = _e7259;
                                            phi_1615_ = _e7261;
                                            phi_1617_ = _e7263;
                                            phi_17291_ = _e7257;
                                            break if !(_e6099);
                                        }
                                    }
                                    let _e7266 = phi_17291_;
                                    phi_17297_ = _e7266;
                                    if _e7266 {
                                        break;
                                    }
                                    let _e7268 = local_25;
                                    if (_e7268 <= 0f) {
                                        phi_3188_ = 0f;
                                        phi_3189_ = f32();
                                        phi_3190_ = true;
                                    } else {
                                        if (_e215 == 1u) {
                                            phi_3178_ = f32();
                                            phi_3179_ = true;
                                        } else {
                                            let _e7273 = local_26;
                                            let _e7275 = (_e3823.member_3 < (0.01f * _e7273));
                                            if _e7275 {
                                                phi_3177_ = f32();
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
                                                    phi_15165_ = select(true, false, (_e7300 <= 0f));
                                                } else {
                                                    phi_15165_ = true;
                                                }
                                                let _e7310 = phi_15165_;
                                                if _e7310 {
                                                    if _e7306 {
                                                        phi_15176_ = true;
                                                    } else {
                                                        phi_15176_ = (_e7300 <= 0f);
                                                    }
                                                    let _e7313 = phi_15176_;
                                                    if _e7313 {
                                                        let _e7318 = (_e7295 / (_e7295 - _e7300));
                                                        let _e7325 = vec3<f32>((_e7276 + ((_e7280 - _e7276) * _e7318)), (_e7277 + ((_e7281 - _e7277) * _e7318)), (_e7278 + ((_e7282 - _e7278) * _e7318)));
                                                        if _e7306 {
                                                            phi_15197_ = type_60(0f, vec3<f32>(0f, 0f, 0f), _e7325);
                                                        } else {
                                                            phi_15197_ = type_60(0f, _e7325, vec3<f32>(0f, 0f, 0f));
                                                        }
                                                        let _e7329 = phi_15197_;
                                                        let _e7330 = vec3(_e7306);
                                                        phi_15201_ = _e7329;
                                                        phi_15202_ = select(_e7325, _e7283, _e7330);
                                                        phi_15203_ = select(_e7279, _e7325, _e7330);
                                                    } else {
                                                        phi_15201_ = type_60(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                        phi_15202_ = _e7283;
                                                        phi_15203_ = _e7279;
                                                    }
                                                    let _e7334 = phi_15201_;
                                                    let _e7336 = phi_15202_;
                                                    let _e7338 = phi_15203_;
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
                                                            phi_15243_ = vec3<f32>((_e7351 / _e7359), (_e7352 / _e7359), (_e7353 / _e7359));
                                                        } else {
                                                            phi_15243_ = vec3<f32>();
                                                        }
                                                        let _e7365 = phi_15243_;
                                                        phi_15246_ = _e7365;
                                                        phi_15247_ = select(true, false, _e7350);
                                                    } else {
                                                        phi_15246_ = vec3<f32>();
                                                        phi_15247_ = true;
                                                    }
                                                    let _e7368 = phi_15246_;
                                                    let _e7370 = phi_15247_;
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
                                                            phi_15291_ = vec3<f32>((_e7385 / _e7393), (_e7386 / _e7393), (_e7387 / _e7393));
                                                        } else {
                                                            phi_15291_ = vec3<f32>();
                                                        }
                                                        let _e7399 = phi_15291_;
                                                        phi_15294_ = _e7399;
                                                        phi_15295_ = select(true, false, _e7384);
                                                    } else {
                                                        phi_15294_ = vec3<f32>();
                                                        phi_15295_ = true;
                                                    }
                                                    let _e7402 = phi_15294_;
                                                    let _e7404 = phi_15295_;
                                                    let _e7406 = select(_e7402, vec3<f32>(0f, 0f, 0f), vec3(_e7404));
                                                    let _e7413 = ((_e7372.y * _e7406.z) - (_e7406.y * _e7372.z));
                                                    let _e7418 = ((_e7372.z * _e7406.x) - (_e7406.z * _e7372.x));
                                                    let _e7421 = ((_e7372.x * _e7406.y) - (_e7406.x * _e7372.y));
                                                    let _e7427 = sqrt((((_e7413 * _e7413) + (_e7418 * _e7418)) + (_e7421 * _e7421)));
                                                    if (_e7427 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_15409_ = 0f;
                                                    } else {
                                                        let _e7439 = (((_e7372.x * _e7406.x) + (_e7372.y * _e7406.y)) + (_e7372.z * _e7406.z));
                                                        let _e7440 = abs(_e7439);
                                                        let _e7441 = abs(_e7427);
                                                        let _e7442 = (_e7441 > _e7440);
                                                        let _e7443 = select(_e7440, _e7441, _e7442);
                                                        if (_e7443 > 0f) {
                                                            phi_15362_ = (select(_e7441, _e7440, _e7442) / _e7443);
                                                        } else {
                                                            phi_15362_ = 0f;
                                                        }
                                                        let _e7448 = phi_15362_;
                                                        let _e7449 = (_e7448 > 0.41421357f);
                                                        if _e7449 {
                                                            phi_15370_ = ((_e7448 - 1f) / (_e7448 + 1f));
                                                        } else {
                                                            phi_15370_ = _e7448;
                                                        }
                                                        let _e7454 = phi_15370_;
                                                        let _e7455 = (_e7454 * _e7454);
                                                        let _e7464 = (_e7454 + ((_e7454 * _e7455) * (-0.3333295f + (_e7455 * (0.19977711f + (_e7455 * (-0.13877685f + (_e7455 * 0.080537446f))))))));
                                                        if _e7449 {
                                                            phi_15385_ = (_e7464 + 0.7853982f);
                                                        } else {
                                                            phi_15385_ = _e7464;
                                                        }
                                                        let _e7467 = phi_15385_;
                                                        if _e7442 {
                                                            phi_15391_ = (1.5707964f - _e7467);
                                                        } else {
                                                            phi_15391_ = _e7467;
                                                        }
                                                        let _e7470 = phi_15391_;
                                                        if ((bitcast<u32>(_e7439) & 2147483648u) == 0u) {
                                                            phi_15399_ = _e7470;
                                                        } else {
                                                            phi_15399_ = (3.1415927f - _e7470);
                                                        }
                                                        let _e7476 = phi_15399_;
                                                        phi_15409_ = (((((_e185.x * _e7413) + (_e185.y * _e7418)) + (_e185.z * _e7421)) / _e7427) * bitcast<f32>(((bitcast<u32>(_e7476) & 2147483647u) | (bitcast<u32>(_e7427) & 2147483648u))));
                                                    }
                                                    let _e7485 = phi_15409_;
                                                    phi_15414_ = type_60((_e7334.member + _e7485), _e7334.member_1, _e7334.member_2);
                                                } else {
                                                    phi_15414_ = type_60(0f, vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                                                }
                                                let _e7493 = phi_15414_;
                                                let _e7494 = (_e7300 <= 0f);
                                                if _e7494 {
                                                    phi_15424_ = select(true, false, (_e7305 <= 0f));
                                                } else {
                                                    phi_15424_ = true;
                                                }
                                                let _e7498 = phi_15424_;
                                                if _e7498 {
                                                    if _e7494 {
                                                        phi_15435_ = true;
                                                    } else {
                                                        phi_15435_ = (_e7305 <= 0f);
                                                    }
                                                    let _e7501 = phi_15435_;
                                                    if _e7501 {
                                                        let _e7506 = (_e7300 / (_e7300 - _e7305));
                                                        let _e7513 = vec3<f32>((_e7280 + ((_e7284 - _e7280) * _e7506)), (_e7281 + ((_e7285 - _e7281) * _e7506)), (_e7282 + ((_e7286 - _e7282) * _e7506)));
                                                        if _e7494 {
                                                            phi_15456_ = type_60(_e7493.member, _e7493.member_1, _e7513);
                                                        } else {
                                                            phi_15456_ = type_60(_e7493.member, _e7513, _e7493.member_2);
                                                        }
                                                        let _e7523 = phi_15456_;
                                                        let _e7524 = vec3(_e7494);
                                                        phi_15460_ = _e7523;
                                                        phi_15461_ = select(_e7513, _e7287, _e7524);
                                                        phi_15462_ = select(_e7283, _e7513, _e7524);
                                                    } else {
                                                        phi_15460_ = _e7493;
                                                        phi_15461_ = _e7287;
                                                        phi_15462_ = _e7283;
                                                    }
                                                    let _e7528 = phi_15460_;
                                                    let _e7530 = phi_15461_;
                                                    let _e7532 = phi_15462_;
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
                                                            phi_15502_ = vec3<f32>((_e7545 / _e7553), (_e7546 / _e7553), (_e7547 / _e7553));
                                                        } else {
                                                            phi_15502_ = vec3<f32>();
                                                        }
                                                        let _e7559 = phi_15502_;
                                                        phi_15505_ = _e7559;
                                                        phi_15506_ = select(true, false, _e7544);
                                                    } else {
                                                        phi_15505_ = vec3<f32>();
                                                        phi_15506_ = true;
                                                    }
                                                    let _e7562 = phi_15505_;
                                                    let _e7564 = phi_15506_;
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
                                                            phi_15550_ = vec3<f32>((_e7579 / _e7587), (_e7580 / _e7587), (_e7581 / _e7587));
                                                        } else {
                                                            phi_15550_ = vec3<f32>();
                                                        }
                                                        let _e7593 = phi_15550_;
                                                        phi_15553_ = _e7593;
                                                        phi_15554_ = select(true, false, _e7578);
                                                    } else {
                                                        phi_15553_ = vec3<f32>();
                                                        phi_15554_ = true;
                                                    }
                                                    let _e7596 = phi_15553_;
                                                    let _e7598 = phi_15554_;
                                                    let _e7600 = select(_e7596, vec3<f32>(0f, 0f, 0f), vec3(_e7598));
                                                    let _e7607 = ((_e7566.y * _e7600.z) - (_e7600.y * _e7566.z));
                                                    let _e7612 = ((_e7566.z * _e7600.x) - (_e7600.z * _e7566.x));
                                                    let _e7615 = ((_e7566.x * _e7600.y) - (_e7600.x * _e7566.y));
                                                    let _e7621 = sqrt((((_e7607 * _e7607) + (_e7612 * _e7612)) + (_e7615 * _e7615)));
                                                    if (_e7621 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_15668_ = 0f;
                                                    } else {
                                                        let _e7633 = (((_e7566.x * _e7600.x) + (_e7566.y * _e7600.y)) + (_e7566.z * _e7600.z));
                                                        let _e7634 = abs(_e7633);
                                                        let _e7635 = abs(_e7621);
                                                        let _e7636 = (_e7635 > _e7634);
                                                        let _e7637 = select(_e7634, _e7635, _e7636);
                                                        if (_e7637 > 0f) {
                                                            phi_15621_ = (select(_e7635, _e7634, _e7636) / _e7637);
                                                        } else {
                                                            phi_15621_ = 0f;
                                                        }
                                                        let _e7642 = phi_15621_;
                                                        let _e7643 = (_e7642 > 0.41421357f);
                                                        if _e7643 {
                                                            phi_15629_ = ((_e7642 - 1f) / (_e7642 + 1f));
                                                        } else {
                                                            phi_15629_ = _e7642;
                                                        }
                                                        let _e7648 = phi_15629_;
                                                        let _e7649 = (_e7648 * _e7648);
                                                        let _e7658 = (_e7648 + ((_e7648 * _e7649) * (-0.3333295f + (_e7649 * (0.19977711f + (_e7649 * (-0.13877685f + (_e7649 * 0.080537446f))))))));
                                                        if _e7643 {
                                                            phi_15644_ = (_e7658 + 0.7853982f);
                                                        } else {
                                                            phi_15644_ = _e7658;
                                                        }
                                                        let _e7661 = phi_15644_;
                                                        if _e7636 {
                                                            phi_15650_ = (1.5707964f - _e7661);
                                                        } else {
                                                            phi_15650_ = _e7661;
                                                        }
                                                        let _e7664 = phi_15650_;
                                                        if ((bitcast<u32>(_e7633) & 2147483648u) == 0u) {
                                                            phi_15658_ = _e7664;
                                                        } else {
                                                            phi_15658_ = (3.1415927f - _e7664);
                                                        }
                                                        let _e7670 = phi_15658_;
                                                        phi_15668_ = (((((_e185.x * _e7607) + (_e185.y * _e7612)) + (_e185.z * _e7615)) / _e7621) * bitcast<f32>(((bitcast<u32>(_e7670) & 2147483647u) | (bitcast<u32>(_e7621) & 2147483648u))));
                                                    }
                                                    let _e7679 = phi_15668_;
                                                    phi_15673_ = type_60((_e7528.member + _e7679), _e7528.member_1, _e7528.member_2);
                                                } else {
                                                    phi_15673_ = _e7493;
                                                }
                                                let _e7687 = phi_15673_;
                                                let _e7688 = (_e7305 <= 0f);
                                                if _e7688 {
                                                    phi_15683_ = select(true, false, _e7306);
                                                } else {
                                                    phi_15683_ = true;
                                                }
                                                let _e7691 = phi_15683_;
                                                if _e7691 {
                                                    if select(_e7306, true, _e7688) {
                                                        let _e7697 = (_e7305 / (_e7305 - _e7295));
                                                        let _e7704 = vec3<f32>((_e7284 + ((_e7276 - _e7284) * _e7697)), (_e7285 + ((_e7277 - _e7285) * _e7697)), (_e7286 + ((_e7278 - _e7286) * _e7697)));
                                                        if _e7688 {
                                                            phi_15715_ = type_60(_e7687.member, _e7687.member_1, _e7704);
                                                        } else {
                                                            phi_15715_ = type_60(_e7687.member, _e7704, _e7687.member_2);
                                                        }
                                                        let _e7714 = phi_15715_;
                                                        let _e7715 = vec3(_e7688);
                                                        phi_15719_ = _e7714;
                                                        phi_15720_ = select(_e7704, _e7279, _e7715);
                                                        phi_15721_ = select(_e7287, _e7704, _e7715);
                                                    } else {
                                                        phi_15719_ = _e7687;
                                                        phi_15720_ = _e7279;
                                                        phi_15721_ = _e7287;
                                                    }
                                                    let _e7719 = phi_15719_;
                                                    let _e7721 = phi_15720_;
                                                    let _e7723 = phi_15721_;
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
                                                            phi_15761_ = vec3<f32>((_e7736 / _e7744), (_e7737 / _e7744), (_e7738 / _e7744));
                                                        } else {
                                                            phi_15761_ = vec3<f32>();
                                                        }
                                                        let _e7750 = phi_15761_;
                                                        phi_15764_ = _e7750;
                                                        phi_15765_ = select(true, false, _e7735);
                                                    } else {
                                                        phi_15764_ = vec3<f32>();
                                                        phi_15765_ = true;
                                                    }
                                                    let _e7753 = phi_15764_;
                                                    let _e7755 = phi_15765_;
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
                                                            phi_15809_ = vec3<f32>((_e7770 / _e7778), (_e7771 / _e7778), (_e7772 / _e7778));
                                                        } else {
                                                            phi_15809_ = vec3<f32>();
                                                        }
                                                        let _e7784 = phi_15809_;
                                                        phi_15812_ = _e7784;
                                                        phi_15813_ = select(true, false, _e7769);
                                                    } else {
                                                        phi_15812_ = vec3<f32>();
                                                        phi_15813_ = true;
                                                    }
                                                    let _e7787 = phi_15812_;
                                                    let _e7789 = phi_15813_;
                                                    let _e7791 = select(_e7787, vec3<f32>(0f, 0f, 0f), vec3(_e7789));
                                                    let _e7798 = ((_e7757.y * _e7791.z) - (_e7791.y * _e7757.z));
                                                    let _e7803 = ((_e7757.z * _e7791.x) - (_e7791.z * _e7757.x));
                                                    let _e7806 = ((_e7757.x * _e7791.y) - (_e7791.x * _e7757.y));
                                                    let _e7812 = sqrt((((_e7798 * _e7798) + (_e7803 * _e7803)) + (_e7806 * _e7806)));
                                                    if (_e7812 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_15927_ = 0f;
                                                    } else {
                                                        let _e7824 = (((_e7757.x * _e7791.x) + (_e7757.y * _e7791.y)) + (_e7757.z * _e7791.z));
                                                        let _e7825 = abs(_e7824);
                                                        let _e7826 = abs(_e7812);
                                                        let _e7827 = (_e7826 > _e7825);
                                                        let _e7828 = select(_e7825, _e7826, _e7827);
                                                        if (_e7828 > 0f) {
                                                            phi_15880_ = (select(_e7826, _e7825, _e7827) / _e7828);
                                                        } else {
                                                            phi_15880_ = 0f;
                                                        }
                                                        let _e7833 = phi_15880_;
                                                        let _e7834 = (_e7833 > 0.41421357f);
                                                        if _e7834 {
                                                            phi_15888_ = ((_e7833 - 1f) / (_e7833 + 1f));
                                                        } else {
                                                            phi_15888_ = _e7833;
                                                        }
                                                        let _e7839 = phi_15888_;
                                                        let _e7840 = (_e7839 * _e7839);
                                                        let _e7849 = (_e7839 + ((_e7839 * _e7840) * (-0.3333295f + (_e7840 * (0.19977711f + (_e7840 * (-0.13877685f + (_e7840 * 0.080537446f))))))));
                                                        if _e7834 {
                                                            phi_15903_ = (_e7849 + 0.7853982f);
                                                        } else {
                                                            phi_15903_ = _e7849;
                                                        }
                                                        let _e7852 = phi_15903_;
                                                        if _e7827 {
                                                            phi_15909_ = (1.5707964f - _e7852);
                                                        } else {
                                                            phi_15909_ = _e7852;
                                                        }
                                                        let _e7855 = phi_15909_;
                                                        if ((bitcast<u32>(_e7824) & 2147483648u) == 0u) {
                                                            phi_15917_ = _e7855;
                                                        } else {
                                                            phi_15917_ = (3.1415927f - _e7855);
                                                        }
                                                        let _e7861 = phi_15917_;
                                                        phi_15927_ = (((((_e185.x * _e7798) + (_e185.y * _e7803)) + (_e185.z * _e7806)) / _e7812) * bitcast<f32>(((bitcast<u32>(_e7861) & 2147483647u) | (bitcast<u32>(_e7812) & 2147483648u))));
                                                    }
                                                    let _e7870 = phi_15927_;
                                                    phi_15932_ = type_60((_e7719.member + _e7870), _e7719.member_1, _e7719.member_2);
                                                } else {
                                                    phi_15932_ = _e7687;
                                                }
                                                let _e7878 = phi_15932_;
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
                                                        phi_15974_ = vec3<f32>((_e7893 / _e7901), (_e7894 / _e7901), (_e7895 / _e7901));
                                                    } else {
                                                        phi_15974_ = vec3<f32>();
                                                    }
                                                    let _e7907 = phi_15974_;
                                                    phi_15977_ = _e7907;
                                                    phi_15978_ = select(true, false, _e7892);
                                                } else {
                                                    phi_15977_ = vec3<f32>();
                                                    phi_15978_ = true;
                                                }
                                                let _e7910 = phi_15977_;
                                                let _e7912 = phi_15978_;
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
                                                        phi_16022_ = vec3<f32>((_e7927 / _e7935), (_e7928 / _e7935), (_e7929 / _e7935));
                                                    } else {
                                                        phi_16022_ = vec3<f32>();
                                                    }
                                                    let _e7941 = phi_16022_;
                                                    phi_16025_ = _e7941;
                                                    phi_16026_ = select(true, false, _e7926);
                                                } else {
                                                    phi_16025_ = vec3<f32>();
                                                    phi_16026_ = true;
                                                }
                                                let _e7944 = phi_16025_;
                                                let _e7946 = phi_16026_;
                                                let _e7948 = select(_e7944, vec3<f32>(0f, 0f, 0f), vec3(_e7946));
                                                let _e7955 = ((_e7914.y * _e7948.z) - (_e7948.y * _e7914.z));
                                                let _e7960 = ((_e7914.z * _e7948.x) - (_e7948.z * _e7914.x));
                                                let _e7963 = ((_e7914.x * _e7948.y) - (_e7948.x * _e7914.y));
                                                let _e7969 = sqrt((((_e7955 * _e7955) + (_e7960 * _e7960)) + (_e7963 * _e7963)));
                                                if (_e7969 <= 0.000000000000000000000000000000000000011754944f) {
                                                    phi_16140_ = 0f;
                                                } else {
                                                    let _e7981 = (((_e7914.x * _e7948.x) + (_e7914.y * _e7948.y)) + (_e7914.z * _e7948.z));
                                                    let _e7982 = abs(_e7981);
                                                    let _e7983 = abs(_e7969);
                                                    let _e7984 = (_e7983 > _e7982);
                                                    let _e7985 = select(_e7982, _e7983, _e7984);
                                                    if (_e7985 > 0f) {
                                                        phi_16093_ = (select(_e7983, _e7982, _e7984) / _e7985);
                                                    } else {
                                                        phi_16093_ = 0f;
                                                    }
                                                    let _e7990 = phi_16093_;
                                                    let _e7991 = (_e7990 > 0.41421357f);
                                                    if _e7991 {
                                                        phi_16101_ = ((_e7990 - 1f) / (_e7990 + 1f));
                                                    } else {
                                                        phi_16101_ = _e7990;
                                                    }
                                                    let _e7996 = phi_16101_;
                                                    let _e7997 = (_e7996 * _e7996);
                                                    let _e8006 = (_e7996 + ((_e7996 * _e7997) * (-0.3333295f + (_e7997 * (0.19977711f + (_e7997 * (-0.13877685f + (_e7997 * 0.080537446f))))))));
                                                    if _e7991 {
                                                        phi_16116_ = (_e8006 + 0.7853982f);
                                                    } else {
                                                        phi_16116_ = _e8006;
                                                    }
                                                    let _e8009 = phi_16116_;
                                                    if _e7984 {
                                                        phi_16122_ = (1.5707964f - _e8009);
                                                    } else {
                                                        phi_16122_ = _e8009;
                                                    }
                                                    let _e8012 = phi_16122_;
                                                    if ((bitcast<u32>(_e7981) & 2147483648u) == 0u) {
                                                        phi_16130_ = _e8012;
                                                    } else {
                                                        phi_16130_ = (3.1415927f - _e8012);
                                                    }
                                                    let _e8018 = phi_16130_;
                                                    phi_16140_ = (((((_e185.x * _e7955) + (_e185.y * _e7960)) + (_e185.z * _e7963)) / _e7969) * bitcast<f32>(((bitcast<u32>(_e8018) & 2147483647u) | (bitcast<u32>(_e7969) & 2147483648u))));
                                                }
                                                let _e8027 = phi_16140_;
                                                let _e8033 = local_27;
                                                let _e8035 = local_28;
                                                phi_3177_ = ((abs((_e7878.member + _e8027)) * 0.5f) * (_e8033 / _e8035));
                                            }
                                            let _e8039 = phi_3177_;
                                            phi_3178_ = _e8039;
                                            phi_3179_ = _e7275;
                                        }
                                        let _e8041 = phi_3178_;
                                        let _e8043 = phi_3179_;
                                        if _e8043 {
                                            let _e8046 = local_29;
                                            phi_3187_ = ((_e8046 * _e3823.member_3) / f32(_e215));
                                        } else {
                                            phi_3187_ = f32();
                                        }
                                        let _e8051 = phi_3187_;
                                        phi_3188_ = _e8051;
                                        phi_3189_ = _e8041;
                                        phi_3190_ = _e8043;
                                    }
                                    let _e8053 = phi_3188_;
                                    let _e8055 = phi_3189_;
                                    let _e8057 = phi_3190_;
                                    phi_17313_ = _e7266;
                                    phi_3194_ = _e8053;
                                    phi_3195_ = _e8055;
                                    phi_3196_ = _e8057;
                                }
                                let _e8059 = phi_17313_;
                                let _e8061 = phi_3194_;
                                let _e8063 = phi_3195_;
                                let _e8065 = phi_3196_;
                                let _e8066 = select(_e8063, _e8061, _e8065);
                                phi_17300_ = _e8059;
                                phi_6066_ = vec3<f32>((_e3823.member_6[0] * _e8066), (_e3823.member_6[1] * _e8066), (_e3823.member_6[2] * _e8066));
                                phi_6067_ = vec3<f32>();
                                phi_6068_ = true;
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
                                            phi_3246_ = -(_e207);
                                        } else {
                                            phi_3246_ = _e207;
                                        }
                                        let _e4969 = phi_3246_;
                                        let _e4973 = (_e163.member[0] + (_e185.x * _e4969));
                                        let _e4974 = (_e163.member[1] + (_e185.y * _e4969));
                                        let _e4975 = (_e163.member[2] + (_e185.z * _e4969));
                                        let _e4976 = abs(_e4952);
                                        let _e4977 = abs(_e4953);
                                        let _e4978 = abs(_e4954);
                                        let _e4979 = (_e4976 > _e4977);
                                        if _e4979 {
                                            phi_3275_ = (_e4976 > _e4978);
                                        } else {
                                            phi_3275_ = (_e4977 > _e4978);
                                        }
                                        let _e4983 = phi_3275_;
                                        let _e4984 = select(1u, 0u, _e4979);
                                        if _e4983 {
                                            let _e4985 = (_e4984 + 1u);
                                            phi_3285_ = _e4985;
                                            phi_3288_ = select(true, false, (_e4985 == 2u));
                                        } else {
                                            phi_3285_ = u32();
                                            phi_3288_ = false;
                                        }
                                        let _e4989 = phi_3285_;
                                        let _e4991 = phi_3288_;
                                        let _e4992 = select(true, false, _e4983);
                                        let _e4993 = select(_e4989, 0u, _e4992);
                                        let _e4995 = select(_e4991, true, _e4992);
                                        if _e4995 {
                                            phi_3299_ = (_e4993 + 1u);
                                        } else {
                                            phi_3299_ = 0u;
                                        }
                                        let _e4998 = phi_3299_;
                                        let _e4999 = select(_e4989, _e4993, _e4995);
                                        let _e5000 = select(_e4984, select(_e4984, 2u, _e4992), _e4995);
                                        local_16 = array<f32, 3>(_e4952, _e4953, _e4954);
                                        local_17 = array<f32, 3>(_e4973, _e4974, _e4975);
                                        let _e5003 = (_e5000 < 3u);
                                        if _e5003 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e5005 = local_16[_e5000];
                                        let _e5006 = (1f / _e5005);
                                        let _e5007 = (_e4999 < 3u);
                                        if _e5007 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e5009 = local_16[_e4999];
                                        let _e5010 = (_e5009 * _e5006);
                                        let _e5011 = (_e4998 < 3u);
                                        if _e5011 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e5013 = local_16[_e4998];
                                        let _e5014 = (_e5013 * _e5006);
                                        if _e5007 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e5016 = local_17[_e4999];
                                        if _e5011 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e5018 = local_17[_e4998];
                                        if _e5003 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e5020 = local_17[_e5000];
                                        if (0u < _e138) {
                                        } else {
                                            phi_17297_ = true;
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
                                            phi_3429_ = (-1f / _e3823.member_2[0]);
                                        } else {
                                            phi_3429_ = (1000000000000f / _e5061);
                                        }
                                        let _e5073 = phi_3429_;
                                        if (_e4977 > _e5062) {
                                            phi_3437_ = (-1f / _e3823.member_2[1]);
                                        } else {
                                            phi_3437_ = (1000000000000f / _e5061);
                                        }
                                        let _e5078 = phi_3437_;
                                        if (_e4978 > _e5062) {
                                            phi_3445_ = (-1f / _e3823.member_2[2]);
                                        } else {
                                            phi_3445_ = (1000000000000f / _e5061);
                                        }
                                        let _e5083 = phi_3445_;
                                        local_15 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_17041_ = _e3796;
                                        phi_3448_ = 0u;
                                        phi_3451_ = 0u;
                                        loop {
                                            let _e5085 = phi_17041_;
                                            let _e5087 = phi_3448_;
                                            let _e5089 = phi_3451_;
                                            let _e5090 = (_e5087 & 15u);
                                            let _e5092 = (_e5087 >> bitcast<u32>(4u));
                                            if (_e5090 == 0u) {
                                                if (_e5092 < _e138) {
                                                } else {
                                                    phi_17097_ = true;
                                                    phi_12558_ = bool();
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
                                                        phi_17097_ = true;
                                                        phi_12558_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5089] = _e5929;
                                                    phi_3836_ = (_e5089 + 1u);
                                                } else {
                                                    phi_3836_ = _e5089;
                                                }
                                                let _e5935 = phi_3836_;
                                                if (select(340282350000000000000000000000000000000f, _e5855, (_e5855 <= select(340282350000000000000000000000000000000f, _e5895, (_e5895 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5935 < 64u) {
                                                    } else {
                                                        phi_17097_ = true;
                                                        phi_12558_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5935] = _e5925;
                                                    phi_3848_ = (_e5935 + 1u);
                                                } else {
                                                    phi_3848_ = _e5935;
                                                }
                                                let _e5941 = phi_3848_;
                                                if (select(340282350000000000000000000000000000000f, _e5853, (_e5853 <= select(340282350000000000000000000000000000000f, _e5893, (_e5893 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5941 < 64u) {
                                                    } else {
                                                        phi_17097_ = true;
                                                        phi_12558_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5941] = _e5921;
                                                    phi_3860_ = (_e5941 + 1u);
                                                } else {
                                                    phi_3860_ = _e5941;
                                                }
                                                let _e5947 = phi_3860_;
                                                if (select(340282350000000000000000000000000000000f, _e5851, (_e5851 <= select(340282350000000000000000000000000000000f, _e5891, (_e5891 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e5947 < 64u) {
                                                    } else {
                                                        phi_17097_ = true;
                                                        phi_12558_ = bool();
                                                        break;
                                                    }
                                                    local_15[_e5947] = _e5917;
                                                    phi_3872_ = (_e5947 + 1u);
                                                } else {
                                                    phi_3872_ = _e5947;
                                                }
                                                let _e5953 = phi_3872_;
                                                phi_17099_ = _e5085;
                                                phi_4565_ = _e5953;
                                                phi_4566_ = true;
                                            } else {
                                                phi_3876_ = type_9(_e5092, (_e5092 + _e5090));
                                                loop {
                                                    let _e5097 = phi_3876_;
                                                    if (_e5097.member < _e5097.member_1) {
                                                        phi_3877_ = type_9((_e5097.member + 1u), _e5097.member_1);
                                                        phi_3900_ = type_9(1u, _e5097.member);
                                                    } else {
                                                        phi_3877_ = _e5097;
                                                        phi_3900_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e5110 = phi_3877_;
                                                    let _e5112 = phi_3900_;
                                                    let _e5116 = (bitcast<i32>(_e5112.member) != 0i);
                                                    if _e5116 {
                                                        let _e5117 = (_e5112.member_1 < _e141);
                                                        if _e5117 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        if _e5003 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5121 = triangles.member[_e5112.member_1].member[_e5000];
                                                        let _e5122 = (_e5121 - _e5020);
                                                        if _e5003 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5126 = triangles.member[_e5112.member_1].member_2[_e5000];
                                                        let _e5127 = (_e5126 - _e5020);
                                                        if _e5003 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5131 = triangles.member[_e5112.member_1].member_4[_e5000];
                                                        let _e5132 = (_e5131 - _e5020);
                                                        if _e5007 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5136 = triangles.member[_e5112.member_1].member[_e4999];
                                                        let _e5139 = ((_e5136 - _e5016) - (_e5010 * _e5122));
                                                        if _e5011 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5143 = triangles.member[_e5112.member_1].member[_e4998];
                                                        let _e5146 = ((_e5143 - _e5018) - (_e5014 * _e5122));
                                                        if _e5007 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5150 = triangles.member[_e5112.member_1].member_2[_e4999];
                                                        let _e5153 = ((_e5150 - _e5016) - (_e5010 * _e5127));
                                                        if _e5011 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5157 = triangles.member[_e5112.member_1].member_2[_e4998];
                                                        let _e5160 = ((_e5157 - _e5018) - (_e5014 * _e5127));
                                                        if _e5007 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5164 = triangles.member[_e5112.member_1].member_4[_e4999];
                                                        let _e5167 = ((_e5164 - _e5016) - (_e5010 * _e5132));
                                                        if _e5011 {
                                                        } else {
                                                            phi_17037_ = true;
                                                            phi_12557_ = bool();
                                                            break;
                                                        }
                                                        let _e5171 = triangles.member[_e5112.member_1].member_4[_e4998];
                                                        let _e5174 = ((_e5171 - _e5018) - (_e5014 * _e5132));
                                                        let _e5175 = (_e5167 * _e5160);
                                                        let _e5176 = (_e5174 * _e5153);
                                                        if (_e5175 != _e5176) {
                                                            phi_4016_ = (_e5175 - _e5176);
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
                                                            phi_4016_ = ((((((_e5180 * _e5183) - _e5175) + (_e5180 * _e5185)) + (_e5184 * _e5183)) + (_e5184 * _e5185)) - (((((_e5196 * _e5199) - _e5176) + (_e5196 * _e5201)) + (_e5200 * _e5199)) + (_e5200 * _e5201)));
                                                        }
                                                        let _e5213 = phi_4016_;
                                                        let _e5214 = (_e5139 * _e5174);
                                                        let _e5215 = (_e5146 * _e5167);
                                                        if (_e5214 != _e5215) {
                                                            phi_4027_ = (_e5214 - _e5215);
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
                                                            phi_4027_ = ((((((_e5219 * _e5222) - _e5214) + (_e5219 * _e5224)) + (_e5223 * _e5222)) + (_e5223 * _e5224)) - (((((_e5235 * _e5238) - _e5215) + (_e5235 * _e5240)) + (_e5239 * _e5238)) + (_e5239 * _e5240)));
                                                        }
                                                        let _e5252 = phi_4027_;
                                                        let _e5253 = (_e5153 * _e5146);
                                                        let _e5254 = (_e5160 * _e5139);
                                                        if (_e5253 != _e5254) {
                                                            phi_4038_ = (_e5253 - _e5254);
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
                                                            phi_4038_ = ((((((_e5258 * _e5261) - _e5253) + (_e5258 * _e5263)) + (_e5262 * _e5261)) + (_e5262 * _e5263)) - (((((_e5274 * _e5277) - _e5254) + (_e5274 * _e5279)) + (_e5278 * _e5277)) + (_e5278 * _e5279)));
                                                        }
                                                        let _e5291 = phi_4038_;
                                                        if (_e5213 < 0f) {
                                                            phi_4056_ = f32();
                                                            phi_4057_ = true;
                                                        } else {
                                                            if (_e5252 < 0f) {
                                                                phi_4054_ = f32();
                                                                phi_4055_ = true;
                                                            } else {
                                                                let _e5294 = (_e5291 < 0f);
                                                                if _e5294 {
                                                                    phi_4053_ = f32();
                                                                } else {
                                                                    phi_4053_ = ((_e5213 + _e5252) + _e5291);
                                                                }
                                                                let _e5298 = phi_4053_;
                                                                phi_4054_ = _e5298;
                                                                phi_4055_ = _e5294;
                                                            }
                                                            let _e5300 = phi_4054_;
                                                            let _e5302 = phi_4055_;
                                                            phi_4056_ = _e5300;
                                                            phi_4057_ = _e5302;
                                                        }
                                                        let _e5304 = phi_4056_;
                                                        let _e5306 = phi_4057_;
                                                        if _e5306 {
                                                            if (_e5213 > 0f) {
                                                                phi_4078_ = f32();
                                                                phi_4079_ = true;
                                                                phi_4080_ = false;
                                                            } else {
                                                                let _e5308 = (_e5252 > 0f);
                                                                if _e5308 {
                                                                    phi_4076_ = f32();
                                                                    phi_4077_ = false;
                                                                } else {
                                                                    phi_4076_ = ((_e5213 + _e5252) + _e5291);
                                                                    phi_4077_ = select(true, false, (_e5291 > 0f));
                                                                }
                                                                let _e5314 = phi_4076_;
                                                                let _e5316 = phi_4077_;
                                                                phi_4078_ = _e5314;
                                                                phi_4079_ = _e5308;
                                                                phi_4080_ = _e5316;
                                                            }
                                                            let _e5318 = phi_4078_;
                                                            let _e5320 = phi_4079_;
                                                            let _e5322 = phi_4080_;
                                                            phi_4085_ = _e5318;
                                                            phi_4086_ = select(_e5322, false, _e5320);
                                                        } else {
                                                            phi_4085_ = _e5304;
                                                            phi_4086_ = true;
                                                        }
                                                        let _e5325 = phi_4085_;
                                                        let _e5327 = phi_4086_;
                                                        if _e5327 {
                                                            let _e5328 = (_e5325 == 0f);
                                                            if _e5328 {
                                                                phi_4174_ = array<f32, 3>();
                                                                phi_4175_ = array<f32, 3>();
                                                                phi_4176_ = false;
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
                                                                    phi_4172_ = array<f32, 3>(_e5342, _e5335, _e5336);
                                                                    phi_4173_ = array<f32, 3>();
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
                                                                    phi_4172_ = array<f32, 3>();
                                                                    phi_4173_ = array<f32, 3>(((((_e5404 * _e5453) * _e5329) + (_e5454 * _e5330)) + (_e5455 * _e5331)), _e5454, _e5455);
                                                                }
                                                                let _e5465 = phi_4172_;
                                                                let _e5467 = phi_4173_;
                                                                phi_4174_ = _e5465;
                                                                phi_4175_ = _e5467;
                                                                phi_4176_ = _e5369;
                                                            }
                                                            let _e5469 = phi_4174_;
                                                            let _e5471 = phi_4175_;
                                                            let _e5473 = phi_4176_;
                                                            phi_4177_ = _e5469;
                                                            phi_4178_ = _e5471;
                                                            phi_4179_ = _e5328;
                                                            phi_4180_ = _e5473;
                                                        } else {
                                                            phi_4177_ = array<f32, 3>();
                                                            phi_4178_ = array<f32, 3>();
                                                            phi_4179_ = true;
                                                            phi_4180_ = false;
                                                        }
                                                        let _e5475 = phi_4177_;
                                                        let _e5477 = phi_4178_;
                                                        let _e5479 = phi_4179_;
                                                        let _e5481 = phi_4180_;
                                                        if _e5479 {
                                                            phi_4185_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_4185_ = _e5475;
                                                        }
                                                        let _e5483 = phi_4185_;
                                                        if select(_e5481, true, _e5479) {
                                                            phi_4190_ = _e5483;
                                                        } else {
                                                            phi_4190_ = _e5477;
                                                        }
                                                        let _e5486 = phi_4190_;
                                                        let _e5490 = (_e5486[0] >= 0f);
                                                        if _e5490 {
                                                            let _e5491 = (_e5486[0] < 340282350000000000000000000000000000000f);
                                                            if _e5491 {
                                                                if _e5490 {
                                                                    if _e5117 {
                                                                    } else {
                                                                        phi_17037_ = true;
                                                                        phi_12557_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e5494 = triangles.member[_e5112.member_1].member_3;
                                                                    if ((_e5494 & 1u) == 0u) {
                                                                        phi_4523_ = true;
                                                                    } else {
                                                                        if _e5117 {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5499 = triangles.member[_e5112.member_1].member_1;
                                                                        let _e5500 = (_e5499 * 12u);
                                                                        if ((256u + _e5500) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 257u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 258u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5507 = (_e5500 + 259u);
                                                                        if (_e5507 < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5510 = surfaces.member[_e5507];
                                                                        if ((_e5500 + 260u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 261u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 262u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5517 = (_e5500 + 263u);
                                                                        if (_e5517 < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5520 = surfaces.member[_e5517];
                                                                        let _e5521 = (_e5500 + 264u);
                                                                        if (_e5521 < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5524 = surfaces.member[_e5521];
                                                                        let _e5525 = bitcast<f32>(_e5524);
                                                                        let _e5526 = (_e5500 + 265u);
                                                                        if (_e5526 < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e5529 = surfaces.member[_e5526];
                                                                        let _e5530 = bitcast<f32>(_e5529);
                                                                        if ((_e5500 + 266u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e5500 + 267u) < _e147) {
                                                                        } else {
                                                                            phi_17037_ = true;
                                                                            phi_12557_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e5510 == 4294967295u) {
                                                                            phi_4518_ = (_e5525 < _e5530);
                                                                        } else {
                                                                            if (_e5112.member_1 < _e144) {
                                                                            } else {
                                                                                phi_17037_ = true;
                                                                                phi_12557_ = bool();
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
                                                                                phi_4401_ = _e5585;
                                                                            } else {
                                                                                let _e5591 = select(select(u32(_e5583), 0u, (_e5583 < 0f)), 4294967295u, (_e5583 > 4294967000f));
                                                                                phi_4401_ = select(_e5591, _e5585, (_e5585 < _e5591));
                                                                            }
                                                                            let _e5595 = phi_4401_;
                                                                            if (_e5595 == _e5585) {
                                                                                phi_4407_ = 0u;
                                                                            } else {
                                                                                phi_4407_ = (_e5595 + 1u);
                                                                            }
                                                                            let _e5599 = phi_4407_;
                                                                            let _e5601 = (_e5572 - floor(_e5572));
                                                                            let _e5606 = ((select(0f, _e5601, (_e5601 <= 1f)) * f32(_e5575)) - 0.5f);
                                                                            let _e5607 = floor(_e5606);
                                                                            let _e5608 = (_e5606 - _e5607);
                                                                            let _e5609 = (_e5575 - 1u);
                                                                            if (_e5607 < 0f) {
                                                                                phi_4437_ = _e5609;
                                                                            } else {
                                                                                let _e5615 = select(select(u32(_e5607), 0u, (_e5607 < 0f)), 4294967295u, (_e5607 > 4294967000f));
                                                                                phi_4437_ = select(_e5615, _e5609, (_e5609 < _e5615));
                                                                            }
                                                                            let _e5619 = phi_4437_;
                                                                            if (_e5619 == _e5609) {
                                                                                phi_4443_ = 0u;
                                                                            } else {
                                                                                phi_4443_ = (_e5619 + 1u);
                                                                            }
                                                                            let _e5623 = phi_4443_;
                                                                            let _e5625 = (_e5510 + (_e5619 * _e5573));
                                                                            let _e5627 = (_e5510 + (_e5623 * _e5573));
                                                                            let _e5628 = (_e5625 + _e5595);
                                                                            let _e5629 = (_e5625 + _e5599);
                                                                            let _e5630 = (_e5627 + _e5595);
                                                                            let _e5631 = (_e5627 + _e5599);
                                                                            if (_e5628 < _e147) {
                                                                            } else {
                                                                                phi_17037_ = true;
                                                                                phi_12557_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5634 = surfaces.member[_e5628];
                                                                            if (_e5629 < _e147) {
                                                                            } else {
                                                                                phi_17037_ = true;
                                                                                phi_12557_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5637 = surfaces.member[_e5629];
                                                                            if (_e5630 < _e147) {
                                                                            } else {
                                                                                phi_17037_ = true;
                                                                                phi_12557_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5640 = surfaces.member[_e5630];
                                                                            if (_e5631 < _e147) {
                                                                            } else {
                                                                                phi_17037_ = true;
                                                                                phi_12557_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e5643 = surfaces.member[_e5631];
                                                                            let _e5660 = (1f - _e5584);
                                                                            phi_4518_ = ((_e5525 * (((((f32((_e5634 >> bitcast<u32>(24i))) * 0.003921569f) * _e5660) + ((f32((_e5637 >> bitcast<u32>(24i))) * 0.003921569f) * _e5584)) * (1f - _e5608)) + ((((f32((_e5640 >> bitcast<u32>(24i))) * 0.003921569f) * _e5660) + ((f32((_e5643 >> bitcast<u32>(24i))) * 0.003921569f) * _e5584)) * _e5608))) < _e5530);
                                                                        }
                                                                        let _e5675 = phi_4518_;
                                                                        phi_4523_ = select(true, false, _e5675);
                                                                    }
                                                                    let _e5678 = phi_4523_;
                                                                    if _e5678 {
                                                                        phi_4528_ = type_47(_e5486[0], _e5112.member_1, _e5486[1], _e5486[2]);
                                                                    } else {
                                                                        phi_4528_ = type_47();
                                                                    }
                                                                    let _e5681 = phi_4528_;
                                                                    phi_4530_ = _e5681;
                                                                    phi_4532_ = select(true, false, _e5678);
                                                                } else {
                                                                    phi_4530_ = type_47();
                                                                    phi_4532_ = false;
                                                                }
                                                                let _e5684 = phi_4530_;
                                                                let _e5686 = phi_4532_;
                                                                phi_4533_ = _e5684;
                                                                phi_4535_ = select(true, false, _e5490);
                                                                phi_4536_ = _e5686;
                                                            } else {
                                                                phi_4533_ = type_47();
                                                                phi_4535_ = false;
                                                                phi_4536_ = false;
                                                            }
                                                            let _e5689 = phi_4533_;
                                                            let _e5691 = phi_4535_;
                                                            let _e5693 = phi_4536_;
                                                            phi_4537_ = _e5689;
                                                            phi_4538_ = select(true, false, _e5491);
                                                            phi_4539_ = _e5691;
                                                            phi_4540_ = _e5693;
                                                        } else {
                                                            phi_4537_ = type_47();
                                                            phi_4538_ = true;
                                                            phi_4539_ = false;
                                                            phi_4540_ = false;
                                                        }
                                                        let _e5696 = phi_4537_;
                                                        let _e5698 = phi_4538_;
                                                        let _e5700 = phi_4539_;
                                                        let _e5702 = phi_4540_;
                                                        if select(select(_e5702, false, _e5698), true, select(_e5700, true, _e5698)) {
                                                            phi_4553_ = type_47(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_4553_ = _e5696;
                                                        }
                                                        let _e5707 = phi_4553_;
                                                        phi_4560_ = select(true, false, (_e5707.member_1 != 4294967295u));
                                                    } else {
                                                        phi_4560_ = false;
                                                    }
                                                    let _e5712 = phi_4560_;
                                                    continue;
                                                    continuing {
                                                        phi_3876_ = _e5110;
                                                        phi_17037_ = _e5085;
                                                        phi_12557_ = select(true, false, _e5116);
                                                        break if !(_e5712);
                                                    }
                                                }
                                                let _e5716 = phi_17037_;
                                                let _e5718 = phi_12557_;
                                                phi_17097_ = _e5716;
                                                phi_12558_ = bool();
                                                if _e5716 {
                                                    break;
                                                }
                                                phi_17099_ = _e5716;
                                                phi_4565_ = _e5089;
                                                phi_4566_ = _e5718;
                                            }
                                            let _e5955 = phi_17099_;
                                            let _e5957 = phi_4565_;
                                            let _e5959 = phi_4566_;
                                            if _e5959 {
                                                let _e5960 = (_e5957 == 0u);
                                                if _e5960 {
                                                    phi_4582_ = u32();
                                                    phi_4583_ = u32();
                                                } else {
                                                    let _e5961 = (_e5957 - 1u);
                                                    if (_e5961 < 64u) {
                                                    } else {
                                                        phi_17097_ = true;
                                                        phi_12558_ = bool();
                                                        break;
                                                    }
                                                    let _e5964 = local_15[_e5961];
                                                    phi_4582_ = _e5964;
                                                    phi_4583_ = _e5961;
                                                }
                                                let _e5966 = phi_4582_;
                                                let _e5968 = phi_4583_;
                                                phi_3449_ = _e5966;
                                                phi_3452_ = _e5968;
                                                phi_4585_ = select(true, false, _e5960);
                                                phi_4586_ = _e5960;
                                            } else {
                                                phi_3449_ = u32();
                                                phi_3452_ = u32();
                                                phi_4585_ = false;
                                                phi_4586_ = false;
                                            }
                                            let _e5971 = phi_3449_;
                                            let _e5973 = phi_3452_;
                                            let _e5975 = phi_4585_;
                                            let _e5977 = phi_4586_;
                                            continue;
                                            continuing {
                                                phi_17041_ = _e5955;
                                                phi_3448_ = _e5971;
                                                phi_3451_ = _e5973;
                                                phi_17097_ = _e5955;
                                                phi_12558_ = _e5977;
                                                break if !(_e5975);
                                            }
                                        }
                                        let _e5980 = phi_17097_;
                                        let _e5982 = phi_12558_;
                                        phi_17297_ = _e5980;
                                        if _e5980 {
                                            break;
                                        }
                                        let _e5984 = select(false, true, select(true, false, _e5982));
                                        if _e5984 {
                                            phi_4602_ = vec3<f32>();
                                        } else {
                                            phi_4602_ = vec3<f32>((_e3823.member_6[0] * _e4964), (_e3823.member_6[1] * _e4964), (_e3823.member_6[2] * _e4964));
                                        }
                                        let _e5990 = phi_4602_;
                                        phi_17308_ = _e5980;
                                        phi_4603_ = _e5990;
                                        phi_4604_ = _e5984;
                                    } else {
                                        phi_17308_ = _e3796;
                                        phi_4603_ = vec3<f32>();
                                        phi_4604_ = true;
                                    }
                                    let _e5992 = phi_17308_;
                                    let _e5994 = phi_4603_;
                                    let _e5996 = phi_4604_;
                                    phi_17301_ = _e5992;
                                    phi_6064_ = select(_e5994, vec3<f32>(0f, 0f, 0f), vec3(_e5996));
                                    phi_6065_ = vec3<f32>();
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
                                        phi_4678_ = (_e3885 * (_e3908 * _e3908));
                                    } else {
                                        phi_4678_ = _e3885;
                                    }
                                    let _e3912 = phi_4678_;
                                    if (_e3912 > 0f) {
                                        if (_e3878 < 0f) {
                                            phi_4699_ = -(_e207);
                                        } else {
                                            phi_4699_ = _e207;
                                        }
                                        let _e3917 = phi_4699_;
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
                                            phi_4728_ = (_e3927 > _e3929);
                                        } else {
                                            phi_4728_ = (_e3928 > _e3929);
                                        }
                                        let _e3934 = phi_4728_;
                                        let _e3935 = select(1u, 0u, _e3930);
                                        if _e3934 {
                                            let _e3936 = (_e3935 + 1u);
                                            phi_4738_ = _e3936;
                                            phi_4741_ = select(true, false, (_e3936 == 2u));
                                        } else {
                                            phi_4738_ = u32();
                                            phi_4741_ = false;
                                        }
                                        let _e3940 = phi_4738_;
                                        let _e3942 = phi_4741_;
                                        let _e3943 = select(true, false, _e3934);
                                        let _e3944 = select(_e3940, 0u, _e3943);
                                        let _e3946 = select(_e3942, true, _e3943);
                                        if _e3946 {
                                            phi_4752_ = (_e3944 + 1u);
                                        } else {
                                            phi_4752_ = 0u;
                                        }
                                        let _e3949 = phi_4752_;
                                        let _e3950 = select(_e3940, _e3944, _e3946);
                                        let _e3951 = select(_e3935, select(_e3935, 2u, _e3943), _e3946);
                                        local_13 = array<f32, 3>(_e3924, _e3925, _e3926);
                                        local_14 = array<f32, 3>(_e3921, _e3922, _e3923);
                                        let _e3954 = (_e3951 < 3u);
                                        if _e3954 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e3956 = local_13[_e3951];
                                        let _e3957 = (1f / _e3956);
                                        let _e3958 = (_e3950 < 3u);
                                        if _e3958 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e3960 = local_13[_e3950];
                                        let _e3961 = (_e3960 * _e3957);
                                        let _e3962 = (_e3949 < 3u);
                                        if _e3962 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e3964 = local_13[_e3949];
                                        let _e3965 = (_e3964 * _e3957);
                                        if _e3958 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e3967 = local_14[_e3950];
                                        if _e3962 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e3969 = local_14[_e3949];
                                        if _e3954 {
                                        } else {
                                            phi_17297_ = true;
                                            break;
                                        }
                                        let _e3971 = local_14[_e3951];
                                        if (0u < _e138) {
                                        } else {
                                            phi_17297_ = true;
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
                                            phi_4882_ = (1f / _e3924);
                                        } else {
                                            phi_4882_ = (1000000000000f / _e4012);
                                        }
                                        let _e4024 = phi_4882_;
                                        if (_e3928 > _e4013) {
                                            phi_4890_ = (1f / _e3925);
                                        } else {
                                            phi_4890_ = (1000000000000f / _e4012);
                                        }
                                        let _e4029 = phi_4890_;
                                        if (_e3929 > _e4013) {
                                            phi_4898_ = (1f / _e3926);
                                        } else {
                                            phi_4898_ = (1000000000000f / _e4012);
                                        }
                                        let _e4034 = phi_4898_;
                                        local_12 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                        phi_16913_ = _e3796;
                                        phi_4901_ = 0u;
                                        phi_4904_ = 0u;
                                        loop {
                                            let _e4036 = phi_16913_;
                                            let _e4038 = phi_4901_;
                                            let _e4040 = phi_4904_;
                                            let _e4041 = (_e4038 & 15u);
                                            let _e4043 = (_e4038 >> bitcast<u32>(4u));
                                            if (_e4041 == 0u) {
                                                if (_e4043 < _e138) {
                                                } else {
                                                    phi_16977_ = true;
                                                    phi_12556_ = bool();
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
                                                        phi_16977_ = true;
                                                        phi_12556_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4040] = _e4880;
                                                    phi_5289_ = (_e4040 + 1u);
                                                } else {
                                                    phi_5289_ = _e4040;
                                                }
                                                let _e4886 = phi_5289_;
                                                if (select(340282350000000000000000000000000000000f, _e4806, (_e4806 <= select(0.9999995f, _e4846, (_e4846 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4886 < 64u) {
                                                    } else {
                                                        phi_16977_ = true;
                                                        phi_12556_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4886] = _e4876;
                                                    phi_5301_ = (_e4886 + 1u);
                                                } else {
                                                    phi_5301_ = _e4886;
                                                }
                                                let _e4892 = phi_5301_;
                                                if (select(340282350000000000000000000000000000000f, _e4804, (_e4804 <= select(0.9999995f, _e4844, (_e4844 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4892 < 64u) {
                                                    } else {
                                                        phi_16977_ = true;
                                                        phi_12556_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4892] = _e4872;
                                                    phi_5313_ = (_e4892 + 1u);
                                                } else {
                                                    phi_5313_ = _e4892;
                                                }
                                                let _e4898 = phi_5313_;
                                                if (select(340282350000000000000000000000000000000f, _e4802, (_e4802 <= select(0.9999995f, _e4842, (_e4842 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                    if (_e4898 < 64u) {
                                                    } else {
                                                        phi_16977_ = true;
                                                        phi_12556_ = bool();
                                                        break;
                                                    }
                                                    local_12[_e4898] = _e4868;
                                                    phi_5325_ = (_e4898 + 1u);
                                                } else {
                                                    phi_5325_ = _e4898;
                                                }
                                                let _e4904 = phi_5325_;
                                                phi_16979_ = _e4036;
                                                phi_6018_ = _e4904;
                                                phi_6019_ = true;
                                            } else {
                                                phi_5329_ = type_9(_e4043, (_e4043 + _e4041));
                                                loop {
                                                    let _e4048 = phi_5329_;
                                                    if (_e4048.member < _e4048.member_1) {
                                                        phi_5330_ = type_9((_e4048.member + 1u), _e4048.member_1);
                                                        phi_5353_ = type_9(1u, _e4048.member);
                                                    } else {
                                                        phi_5330_ = _e4048;
                                                        phi_5353_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e4061 = phi_5330_;
                                                    let _e4063 = phi_5353_;
                                                    let _e4067 = (bitcast<i32>(_e4063.member) != 0i);
                                                    if _e4067 {
                                                        let _e4068 = (_e4063.member_1 < _e141);
                                                        if _e4068 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        if _e3954 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4072 = triangles.member[_e4063.member_1].member[_e3951];
                                                        let _e4073 = (_e4072 - _e3971);
                                                        if _e3954 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4077 = triangles.member[_e4063.member_1].member_2[_e3951];
                                                        let _e4078 = (_e4077 - _e3971);
                                                        if _e3954 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4082 = triangles.member[_e4063.member_1].member_4[_e3951];
                                                        let _e4083 = (_e4082 - _e3971);
                                                        if _e3958 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4087 = triangles.member[_e4063.member_1].member[_e3950];
                                                        let _e4090 = ((_e4087 - _e3967) - (_e3961 * _e4073));
                                                        if _e3962 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4094 = triangles.member[_e4063.member_1].member[_e3949];
                                                        let _e4097 = ((_e4094 - _e3969) - (_e3965 * _e4073));
                                                        if _e3958 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4101 = triangles.member[_e4063.member_1].member_2[_e3950];
                                                        let _e4104 = ((_e4101 - _e3967) - (_e3961 * _e4078));
                                                        if _e3962 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4108 = triangles.member[_e4063.member_1].member_2[_e3949];
                                                        let _e4111 = ((_e4108 - _e3969) - (_e3965 * _e4078));
                                                        if _e3958 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4115 = triangles.member[_e4063.member_1].member_4[_e3950];
                                                        let _e4118 = ((_e4115 - _e3967) - (_e3961 * _e4083));
                                                        if _e3962 {
                                                        } else {
                                                            phi_16909_ = true;
                                                            phi_12555_ = bool();
                                                            break;
                                                        }
                                                        let _e4122 = triangles.member[_e4063.member_1].member_4[_e3949];
                                                        let _e4125 = ((_e4122 - _e3969) - (_e3965 * _e4083));
                                                        let _e4126 = (_e4118 * _e4111);
                                                        let _e4127 = (_e4125 * _e4104);
                                                        if (_e4126 != _e4127) {
                                                            phi_5469_ = (_e4126 - _e4127);
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
                                                            phi_5469_ = ((((((_e4131 * _e4134) - _e4126) + (_e4131 * _e4136)) + (_e4135 * _e4134)) + (_e4135 * _e4136)) - (((((_e4147 * _e4150) - _e4127) + (_e4147 * _e4152)) + (_e4151 * _e4150)) + (_e4151 * _e4152)));
                                                        }
                                                        let _e4164 = phi_5469_;
                                                        let _e4165 = (_e4090 * _e4125);
                                                        let _e4166 = (_e4097 * _e4118);
                                                        if (_e4165 != _e4166) {
                                                            phi_5480_ = (_e4165 - _e4166);
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
                                                            phi_5480_ = ((((((_e4170 * _e4173) - _e4165) + (_e4170 * _e4175)) + (_e4174 * _e4173)) + (_e4174 * _e4175)) - (((((_e4186 * _e4189) - _e4166) + (_e4186 * _e4191)) + (_e4190 * _e4189)) + (_e4190 * _e4191)));
                                                        }
                                                        let _e4203 = phi_5480_;
                                                        let _e4204 = (_e4104 * _e4097);
                                                        let _e4205 = (_e4111 * _e4090);
                                                        if (_e4204 != _e4205) {
                                                            phi_5491_ = (_e4204 - _e4205);
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
                                                            phi_5491_ = ((((((_e4209 * _e4212) - _e4204) + (_e4209 * _e4214)) + (_e4213 * _e4212)) + (_e4213 * _e4214)) - (((((_e4225 * _e4228) - _e4205) + (_e4225 * _e4230)) + (_e4229 * _e4228)) + (_e4229 * _e4230)));
                                                        }
                                                        let _e4242 = phi_5491_;
                                                        if (_e4164 < 0f) {
                                                            phi_5509_ = f32();
                                                            phi_5510_ = true;
                                                        } else {
                                                            if (_e4203 < 0f) {
                                                                phi_5507_ = f32();
                                                                phi_5508_ = true;
                                                            } else {
                                                                let _e4245 = (_e4242 < 0f);
                                                                if _e4245 {
                                                                    phi_5506_ = f32();
                                                                } else {
                                                                    phi_5506_ = ((_e4164 + _e4203) + _e4242);
                                                                }
                                                                let _e4249 = phi_5506_;
                                                                phi_5507_ = _e4249;
                                                                phi_5508_ = _e4245;
                                                            }
                                                            let _e4251 = phi_5507_;
                                                            let _e4253 = phi_5508_;
                                                            phi_5509_ = _e4251;
                                                            phi_5510_ = _e4253;
                                                        }
                                                        let _e4255 = phi_5509_;
                                                        let _e4257 = phi_5510_;
                                                        if _e4257 {
                                                            if (_e4164 > 0f) {
                                                                phi_5531_ = f32();
                                                                phi_5532_ = true;
                                                                phi_5533_ = false;
                                                            } else {
                                                                let _e4259 = (_e4203 > 0f);
                                                                if _e4259 {
                                                                    phi_5529_ = f32();
                                                                    phi_5530_ = false;
                                                                } else {
                                                                    phi_5529_ = ((_e4164 + _e4203) + _e4242);
                                                                    phi_5530_ = select(true, false, (_e4242 > 0f));
                                                                }
                                                                let _e4265 = phi_5529_;
                                                                let _e4267 = phi_5530_;
                                                                phi_5531_ = _e4265;
                                                                phi_5532_ = _e4259;
                                                                phi_5533_ = _e4267;
                                                            }
                                                            let _e4269 = phi_5531_;
                                                            let _e4271 = phi_5532_;
                                                            let _e4273 = phi_5533_;
                                                            phi_5538_ = _e4269;
                                                            phi_5539_ = select(_e4273, false, _e4271);
                                                        } else {
                                                            phi_5538_ = _e4255;
                                                            phi_5539_ = true;
                                                        }
                                                        let _e4276 = phi_5538_;
                                                        let _e4278 = phi_5539_;
                                                        if _e4278 {
                                                            let _e4279 = (_e4276 == 0f);
                                                            if _e4279 {
                                                                phi_5627_ = array<f32, 3>();
                                                                phi_5628_ = array<f32, 3>();
                                                                phi_5629_ = false;
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
                                                                    phi_5625_ = array<f32, 3>(_e4293, _e4286, _e4287);
                                                                    phi_5626_ = array<f32, 3>();
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
                                                                    phi_5625_ = array<f32, 3>();
                                                                    phi_5626_ = array<f32, 3>(((((_e4355 * _e4404) * _e4280) + (_e4405 * _e4281)) + (_e4406 * _e4282)), _e4405, _e4406);
                                                                }
                                                                let _e4416 = phi_5625_;
                                                                let _e4418 = phi_5626_;
                                                                phi_5627_ = _e4416;
                                                                phi_5628_ = _e4418;
                                                                phi_5629_ = _e4320;
                                                            }
                                                            let _e4420 = phi_5627_;
                                                            let _e4422 = phi_5628_;
                                                            let _e4424 = phi_5629_;
                                                            phi_5630_ = _e4420;
                                                            phi_5631_ = _e4422;
                                                            phi_5632_ = _e4279;
                                                            phi_5633_ = _e4424;
                                                        } else {
                                                            phi_5630_ = array<f32, 3>();
                                                            phi_5631_ = array<f32, 3>();
                                                            phi_5632_ = true;
                                                            phi_5633_ = false;
                                                        }
                                                        let _e4426 = phi_5630_;
                                                        let _e4428 = phi_5631_;
                                                        let _e4430 = phi_5632_;
                                                        let _e4432 = phi_5633_;
                                                        if _e4430 {
                                                            phi_5638_ = array<f32, 3>(-1f, 0f, 0f);
                                                        } else {
                                                            phi_5638_ = _e4426;
                                                        }
                                                        let _e4434 = phi_5638_;
                                                        if select(_e4432, true, _e4430) {
                                                            phi_5643_ = _e4434;
                                                        } else {
                                                            phi_5643_ = _e4428;
                                                        }
                                                        let _e4437 = phi_5643_;
                                                        let _e4441 = (_e4437[0] >= 0f);
                                                        if _e4441 {
                                                            let _e4442 = (_e4437[0] < 0.9999995f);
                                                            if _e4442 {
                                                                if _e4441 {
                                                                    if _e4068 {
                                                                    } else {
                                                                        phi_16909_ = true;
                                                                        phi_12555_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e4445 = triangles.member[_e4063.member_1].member_3;
                                                                    if ((_e4445 & 1u) == 0u) {
                                                                        phi_5976_ = true;
                                                                    } else {
                                                                        if _e4068 {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4450 = triangles.member[_e4063.member_1].member_1;
                                                                        let _e4451 = (_e4450 * 12u);
                                                                        if ((256u + _e4451) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 257u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 258u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4458 = (_e4451 + 259u);
                                                                        if (_e4458 < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4461 = surfaces.member[_e4458];
                                                                        if ((_e4451 + 260u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 261u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 262u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4468 = (_e4451 + 263u);
                                                                        if (_e4468 < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4471 = surfaces.member[_e4468];
                                                                        let _e4472 = (_e4451 + 264u);
                                                                        if (_e4472 < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4475 = surfaces.member[_e4472];
                                                                        let _e4476 = bitcast<f32>(_e4475);
                                                                        let _e4477 = (_e4451 + 265u);
                                                                        if (_e4477 < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e4480 = surfaces.member[_e4477];
                                                                        let _e4481 = bitcast<f32>(_e4480);
                                                                        if ((_e4451 + 266u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        if ((_e4451 + 267u) < _e147) {
                                                                        } else {
                                                                            phi_16909_ = true;
                                                                            phi_12555_ = bool();
                                                                            break;
                                                                        }
                                                                        if (_e4461 == 4294967295u) {
                                                                            phi_5971_ = (_e4476 < _e4481);
                                                                        } else {
                                                                            if (_e4063.member_1 < _e144) {
                                                                            } else {
                                                                                phi_16909_ = true;
                                                                                phi_12555_ = bool();
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
                                                                                phi_5854_ = _e4536;
                                                                            } else {
                                                                                let _e4542 = select(select(u32(_e4534), 0u, (_e4534 < 0f)), 4294967295u, (_e4534 > 4294967000f));
                                                                                phi_5854_ = select(_e4542, _e4536, (_e4536 < _e4542));
                                                                            }
                                                                            let _e4546 = phi_5854_;
                                                                            if (_e4546 == _e4536) {
                                                                                phi_5860_ = 0u;
                                                                            } else {
                                                                                phi_5860_ = (_e4546 + 1u);
                                                                            }
                                                                            let _e4550 = phi_5860_;
                                                                            let _e4552 = (_e4523 - floor(_e4523));
                                                                            let _e4557 = ((select(0f, _e4552, (_e4552 <= 1f)) * f32(_e4526)) - 0.5f);
                                                                            let _e4558 = floor(_e4557);
                                                                            let _e4559 = (_e4557 - _e4558);
                                                                            let _e4560 = (_e4526 - 1u);
                                                                            if (_e4558 < 0f) {
                                                                                phi_5890_ = _e4560;
                                                                            } else {
                                                                                let _e4566 = select(select(u32(_e4558), 0u, (_e4558 < 0f)), 4294967295u, (_e4558 > 4294967000f));
                                                                                phi_5890_ = select(_e4566, _e4560, (_e4560 < _e4566));
                                                                            }
                                                                            let _e4570 = phi_5890_;
                                                                            if (_e4570 == _e4560) {
                                                                                phi_5896_ = 0u;
                                                                            } else {
                                                                                phi_5896_ = (_e4570 + 1u);
                                                                            }
                                                                            let _e4574 = phi_5896_;
                                                                            let _e4576 = (_e4461 + (_e4570 * _e4524));
                                                                            let _e4578 = (_e4461 + (_e4574 * _e4524));
                                                                            let _e4579 = (_e4576 + _e4546);
                                                                            let _e4580 = (_e4576 + _e4550);
                                                                            let _e4581 = (_e4578 + _e4546);
                                                                            let _e4582 = (_e4578 + _e4550);
                                                                            if (_e4579 < _e147) {
                                                                            } else {
                                                                                phi_16909_ = true;
                                                                                phi_12555_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4585 = surfaces.member[_e4579];
                                                                            if (_e4580 < _e147) {
                                                                            } else {
                                                                                phi_16909_ = true;
                                                                                phi_12555_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4588 = surfaces.member[_e4580];
                                                                            if (_e4581 < _e147) {
                                                                            } else {
                                                                                phi_16909_ = true;
                                                                                phi_12555_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4591 = surfaces.member[_e4581];
                                                                            if (_e4582 < _e147) {
                                                                            } else {
                                                                                phi_16909_ = true;
                                                                                phi_12555_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e4594 = surfaces.member[_e4582];
                                                                            let _e4611 = (1f - _e4535);
                                                                            phi_5971_ = ((_e4476 * (((((f32((_e4585 >> bitcast<u32>(24i))) * 0.003921569f) * _e4611) + ((f32((_e4588 >> bitcast<u32>(24i))) * 0.003921569f) * _e4535)) * (1f - _e4559)) + ((((f32((_e4591 >> bitcast<u32>(24i))) * 0.003921569f) * _e4611) + ((f32((_e4594 >> bitcast<u32>(24i))) * 0.003921569f) * _e4535)) * _e4559))) < _e4481);
                                                                        }
                                                                        let _e4626 = phi_5971_;
                                                                        phi_5976_ = select(true, false, _e4626);
                                                                    }
                                                                    let _e4629 = phi_5976_;
                                                                    if _e4629 {
                                                                        phi_5981_ = type_47(_e4437[0], _e4063.member_1, _e4437[1], _e4437[2]);
                                                                    } else {
                                                                        phi_5981_ = type_47();
                                                                    }
                                                                    let _e4632 = phi_5981_;
                                                                    phi_5983_ = _e4632;
                                                                    phi_5985_ = select(true, false, _e4629);
                                                                } else {
                                                                    phi_5983_ = type_47();
                                                                    phi_5985_ = false;
                                                                }
                                                                let _e4635 = phi_5983_;
                                                                let _e4637 = phi_5985_;
                                                                phi_5986_ = _e4635;
                                                                phi_5988_ = select(true, false, _e4441);
                                                                phi_5989_ = _e4637;
                                                            } else {
                                                                phi_5986_ = type_47();
                                                                phi_5988_ = false;
                                                                phi_5989_ = false;
                                                            }
                                                            let _e4640 = phi_5986_;
                                                            let _e4642 = phi_5988_;
                                                            let _e4644 = phi_5989_;
                                                            phi_5990_ = _e4640;
                                                            phi_5991_ = select(true, false, _e4442);
                                                            phi_5992_ = _e4642;
                                                            phi_5993_ = _e4644;
                                                        } else {
                                                            phi_5990_ = type_47();
                                                            phi_5991_ = true;
                                                            phi_5992_ = false;
                                                            phi_5993_ = false;
                                                        }
                                                        let _e4647 = phi_5990_;
                                                        let _e4649 = phi_5991_;
                                                        let _e4651 = phi_5992_;
                                                        let _e4653 = phi_5993_;
                                                        if select(select(_e4653, false, _e4649), true, select(_e4651, true, _e4649)) {
                                                            phi_6006_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                        } else {
                                                            phi_6006_ = _e4647;
                                                        }
                                                        let _e4658 = phi_6006_;
                                                        phi_6013_ = select(true, false, (_e4658.member_1 != 4294967295u));
                                                    } else {
                                                        phi_6013_ = false;
                                                    }
                                                    let _e4663 = phi_6013_;
                                                    continue;
                                                    continuing {
                                                        phi_5329_ = _e4061;
                                                        phi_16909_ = _e4036;
                                                        phi_12555_ = select(true, false, _e4067);
                                                        break if !(_e4663);
                                                    }
                                                }
                                                let _e4667 = phi_16909_;
                                                let _e4669 = phi_12555_;
                                                phi_16977_ = _e4667;
                                                phi_12556_ = bool();
                                                if _e4667 {
                                                    break;
                                                }
                                                phi_16979_ = _e4667;
                                                phi_6018_ = _e4040;
                                                phi_6019_ = _e4669;
                                            }
                                            let _e4906 = phi_16979_;
                                            let _e4908 = phi_6018_;
                                            let _e4910 = phi_6019_;
                                            if _e4910 {
                                                let _e4911 = (_e4908 == 0u);
                                                if _e4911 {
                                                    phi_6035_ = u32();
                                                    phi_6036_ = u32();
                                                } else {
                                                    let _e4912 = (_e4908 - 1u);
                                                    if (_e4912 < 64u) {
                                                    } else {
                                                        phi_16977_ = true;
                                                        phi_12556_ = bool();
                                                        break;
                                                    }
                                                    let _e4915 = local_12[_e4912];
                                                    phi_6035_ = _e4915;
                                                    phi_6036_ = _e4912;
                                                }
                                                let _e4917 = phi_6035_;
                                                let _e4919 = phi_6036_;
                                                phi_4902_ = _e4917;
                                                phi_4905_ = _e4919;
                                                phi_6038_ = select(true, false, _e4911);
                                                phi_6039_ = _e4911;
                                            } else {
                                                phi_4902_ = u32();
                                                phi_4905_ = u32();
                                                phi_6038_ = false;
                                                phi_6039_ = false;
                                            }
                                            let _e4922 = phi_4902_;
                                            let _e4924 = phi_4905_;
                                            let _e4926 = phi_6038_;
                                            let _e4928 = phi_6039_;
                                            continue;
                                            continuing {
                                                phi_16913_ = _e4906;
                                                phi_4901_ = _e4922;
                                                phi_4904_ = _e4924;
                                                phi_16977_ = _e4906;
                                                phi_12556_ = _e4928;
                                                break if !(_e4926);
                                            }
                                        }
                                        let _e4931 = phi_16977_;
                                        let _e4933 = phi_12556_;
                                        phi_17297_ = _e4931;
                                        if _e4931 {
                                            break;
                                        }
                                        let _e4936 = !(select(false, true, select(true, false, _e4933)));
                                        if _e4936 {
                                            phi_6056_ = vec3<f32>((_e3823.member_6[0] * _e3912), (_e3823.member_6[1] * _e3912), (_e3823.member_6[2] * _e3912));
                                        } else {
                                            phi_6056_ = vec3<f32>();
                                        }
                                        let _e4942 = phi_6056_;
                                        phi_17303_ = _e4931;
                                        phi_6058_ = _e4942;
                                        phi_6059_ = select(true, false, _e4936);
                                    } else {
                                        phi_17303_ = _e3796;
                                        phi_6058_ = vec3<f32>();
                                        phi_6059_ = true;
                                    }
                                    let _e4945 = phi_17303_;
                                    let _e4947 = phi_6058_;
                                    let _e4949 = phi_6059_;
                                    phi_17301_ = _e4945;
                                    phi_6064_ = vec3<f32>();
                                    phi_6065_ = select(_e4947, vec3<f32>(0f, 0f, 0f), vec3(_e4949));
                                }
                                let _e6000 = phi_17301_;
                                let _e6002 = phi_6064_;
                                let _e6004 = phi_6065_;
                                phi_17300_ = _e6000;
                                phi_6066_ = _e6002;
                                phi_6067_ = _e6004;
                                phi_6068_ = _e3861;
                            }
                            let _e8072 = phi_17300_;
                            let _e8074 = phi_6066_;
                            let _e8076 = phi_6067_;
                            let _e8078 = phi_6068_;
                            phi_17298_ = _e8072;
                            phi_1450_ = (_e3800 + select(_e8076, _e8074, vec3(_e8078)));
                        } else {
                            phi_17298_ = _e3796;
                            phi_1450_ = vec3<f32>();
                        }
                        let _e8083 = phi_17298_;
                        let _e8085 = phi_1450_;
                        continue;
                        continuing {
                            phi_16930_ = _e8083;
                            phi_1446_ = _e3813;
                            phi_1449_ = _e8085;
                            phi_17297_ = _e8083;
                            break if !(_e3819);
                        }
                    }
                    let _e8088 = phi_17297_;
                    if _e8088 {
                        break;
                    }
                    phi_17428_ = _e8088;
                    let _e10064 = local_31;
                    phi_10776_ = _e10064;
                } else {
                    let _e247 = ((_e242 ^ (_e242 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e251 = ((_e247 ^ (_e247 >> bitcast<u32>(15i))) * 2221713035u);
                    phi_16408_ = false;
                    phi_6098_ = type_9(0u, _e215);
                    phi_6101_ = vec3<f32>(0f, 0f, 0f);
                    loop {
                        let _e261 = phi_16408_;
                        let _e263 = phi_6098_;
                        let _e265 = phi_6101_;
                        local_32 = _e265;
                        if (_e263.member < _e263.member_1) {
                            phi_6099_ = type_9((_e263.member + 1u), _e263.member_1);
                            phi_6124_ = type_9(1u, _e263.member);
                        } else {
                            phi_6099_ = _e263;
                            phi_6124_ = type_9(0u, type_9().member_1);
                        }
                        let _e278 = phi_6099_;
                        let _e280 = phi_6124_;
                        let _e284 = (bitcast<i32>(_e280.member) != 0i);
                        if _e284 {
                            let _e287 = f32(_e215);
                            phi_6138_ = (_e211 - 1u);
                            phi_6141_ = 0u;
                            loop {
                                let _e291 = phi_6138_;
                                let _e293 = phi_6141_;
                                local_21 = _e293;
                                local_22 = _e293;
                                let _e294 = (_e293 < _e291);
                                if _e294 {
                                    let _e296 = ((_e293 + _e291) / 2u);
                                    if (_e296 < _e149) {
                                    } else {
                                        phi_16404_ = true;
                                        break;
                                    }
                                    let _e301 = lights.member[_e296].member_5;
                                    let _e302 = (_e301 > ((f32(_e280.member_1) + (f32(((_e251 ^ (_e251 >> bitcast<u32>(16i))) >> bitcast<u32>(8i))) * 0.000000059604645f)) / _e287));
                                    if _e302 {
                                        phi_6165_ = _e293;
                                    } else {
                                        phi_6165_ = (_e296 + 1u);
                                    }
                                    let _e305 = phi_6165_;
                                    phi_6139_ = select(_e291, _e296, _e302);
                                    phi_6142_ = _e305;
                                } else {
                                    phi_6139_ = u32();
                                    phi_6142_ = u32();
                                }
                                let _e308 = phi_6139_;
                                let _e310 = phi_6142_;
                                continue;
                                continuing {
                                    phi_6138_ = _e308;
                                    phi_6141_ = _e310;
                                    phi_16404_ = _e261;
                                    break if !(_e294);
                                }
                            }
                            let _e313 = phi_16404_;
                            phi_16801_ = _e313;
                            if _e313 {
                                break;
                            }
                            let _e315 = local_21;
                            if (_e315 < _e149) {
                            } else {
                                phi_16801_ = true;
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
                                            phi_6272_ = vec3<f32>((_e2524 / _e2532), (_e2525 / _e2532), (_e2526 / _e2532));
                                        } else {
                                            phi_6272_ = vec3<f32>();
                                        }
                                        let _e2538 = phi_6272_;
                                        phi_6274_ = _e2538;
                                        phi_6275_ = select(true, false, _e2523);
                                    } else {
                                        phi_6274_ = vec3<f32>();
                                        phi_6275_ = true;
                                    }
                                    let _e2541 = phi_6274_;
                                    let _e2543 = phi_6275_;
                                    let _e2545 = select(_e2541, vec3<f32>(0f, 0f, 0f), vec3(_e2543));
                                    let _e2556 = (((_e2545.x * (_e163.member[0] - _e321.member[0])) + (_e2545.y * (_e163.member[1] - _e321.member[1]))) + (_e2545.z * (_e163.member[2] - _e321.member[2])));
                                    if (_e2556 <= 0f) {
                                        phi_16818_ = _e313;
                                        phi_7881_ = 0f;
                                    } else {
                                        phi_16687_ = _e313;
                                        phi_6297_ = type_9(0u, 1u);
                                        phi_6302_ = 0f;
                                        loop {
                                            let _e2559 = phi_16687_;
                                            let _e2561 = phi_6297_;
                                            let _e2563 = phi_6302_;
                                            local_23 = _e2563;
                                            local_24 = _e2563;
                                            if (_e2561.member < _e2561.member_1) {
                                                phi_6298_ = type_9((_e2561.member + 1u), _e2561.member_1);
                                                phi_6327_ = type_9(1u, _e2561.member);
                                            } else {
                                                phi_6298_ = _e2561;
                                                phi_6327_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e2576 = phi_6298_;
                                            let _e2578 = phi_6327_;
                                            let _e2582 = (bitcast<i32>(_e2578.member) != 0i);
                                            if _e2582 {
                                                let _e2586 = ((_e337 ^ (_e337 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e2590 = ((_e2586 ^ (_e2586 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e2597 = (_e337 ^ 2654435769u);
                                                let _e2601 = ((_e2597 ^ (_e2597 >> bitcast<u32>(16i))) * 2146121005u);
                                                let _e2605 = ((_e2601 ^ (_e2601 >> bitcast<u32>(15i))) * 2221713035u);
                                                let _e2623 = (0.000000059604645f * (f32(((2147483648u + (_e2578.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e2590 ^ (_e2590 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e2623 >= 1f) {
                                                    phi_13056_ = (_e2623 - 1f);
                                                } else {
                                                    phi_13056_ = _e2623;
                                                }
                                                let _e2627 = phi_13056_;
                                                let _e2629 = (0.000000059604645f * (f32(((2147483648u + (_e2578.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e2605 ^ (_e2605 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                                                if (_e2629 >= 1f) {
                                                    phi_13064_ = (_e2629 - 1f);
                                                } else {
                                                    phi_13064_ = _e2629;
                                                }
                                                let _e2633 = phi_13064_;
                                                if (_e2627 < _e2633) {
                                                    let _e2638 = (0.5f * _e2627);
                                                    phi_6388_ = vec2<f32>(_e2638, (_e2633 - _e2638));
                                                } else {
                                                    let _e2635 = (0.5f * _e2633);
                                                    phi_6388_ = vec2<f32>((_e2627 - _e2635), _e2635);
                                                }
                                                let _e2642 = phi_6388_;
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
                                                        phi_6491_ = -(_e207);
                                                    } else {
                                                        phi_6491_ = _e207;
                                                    }
                                                    let _e2709 = phi_6491_;
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
                                                        phi_6520_ = (_e2719 > _e2721);
                                                    } else {
                                                        phi_6520_ = (_e2720 > _e2721);
                                                    }
                                                    let _e2726 = phi_6520_;
                                                    let _e2727 = select(1u, 0u, _e2722);
                                                    if _e2726 {
                                                        let _e2728 = (_e2727 + 1u);
                                                        phi_6530_ = _e2728;
                                                        phi_6533_ = select(true, false, (_e2728 == 2u));
                                                    } else {
                                                        phi_6530_ = u32();
                                                        phi_6533_ = false;
                                                    }
                                                    let _e2732 = phi_6530_;
                                                    let _e2734 = phi_6533_;
                                                    let _e2735 = select(true, false, _e2726);
                                                    let _e2736 = select(_e2732, 0u, _e2735);
                                                    let _e2738 = select(_e2734, true, _e2735);
                                                    if _e2738 {
                                                        phi_6544_ = (_e2736 + 1u);
                                                    } else {
                                                        phi_6544_ = 0u;
                                                    }
                                                    let _e2741 = phi_6544_;
                                                    let _e2742 = select(_e2732, _e2736, _e2738);
                                                    let _e2743 = select(_e2727, select(_e2727, 2u, _e2735), _e2738);
                                                    local_10 = array<f32, 3>(_e2716, _e2717, _e2718);
                                                    local_11 = array<f32, 3>(_e2713, _e2714, _e2715);
                                                    let _e2746 = (_e2743 < 3u);
                                                    if _e2746 {
                                                    } else {
                                                        phi_16795_ = true;
                                                        break;
                                                    }
                                                    let _e2748 = local_10[_e2743];
                                                    let _e2749 = (1f / _e2748);
                                                    let _e2750 = (_e2742 < 3u);
                                                    if _e2750 {
                                                    } else {
                                                        phi_16795_ = true;
                                                        break;
                                                    }
                                                    let _e2752 = local_10[_e2742];
                                                    let _e2753 = (_e2752 * _e2749);
                                                    let _e2754 = (_e2741 < 3u);
                                                    if _e2754 {
                                                    } else {
                                                        phi_16795_ = true;
                                                        break;
                                                    }
                                                    let _e2756 = local_10[_e2741];
                                                    let _e2757 = (_e2756 * _e2749);
                                                    if _e2750 {
                                                    } else {
                                                        phi_16795_ = true;
                                                        break;
                                                    }
                                                    let _e2759 = local_11[_e2742];
                                                    if _e2754 {
                                                    } else {
                                                        phi_16795_ = true;
                                                        break;
                                                    }
                                                    let _e2761 = local_11[_e2741];
                                                    if _e2746 {
                                                    } else {
                                                        phi_16795_ = true;
                                                        break;
                                                    }
                                                    let _e2763 = local_11[_e2743];
                                                    if (0u < _e138) {
                                                    } else {
                                                        phi_16795_ = true;
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
                                                        phi_6674_ = (1f / _e2716);
                                                    } else {
                                                        phi_6674_ = (1000000000000f / _e2804);
                                                    }
                                                    let _e2816 = phi_6674_;
                                                    if (_e2720 > _e2805) {
                                                        phi_6682_ = (1f / _e2717);
                                                    } else {
                                                        phi_6682_ = (1000000000000f / _e2804);
                                                    }
                                                    let _e2821 = phi_6682_;
                                                    if (_e2721 > _e2805) {
                                                        phi_6690_ = (1f / _e2718);
                                                    } else {
                                                        phi_6690_ = (1000000000000f / _e2804);
                                                    }
                                                    let _e2826 = phi_6690_;
                                                    local_9 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                                    phi_16665_ = _e2559;
                                                    phi_6693_ = 0u;
                                                    phi_6696_ = 0u;
                                                    loop {
                                                        let _e2828 = phi_16665_;
                                                        let _e2830 = phi_6693_;
                                                        let _e2832 = phi_6696_;
                                                        let _e2833 = (_e2830 & 15u);
                                                        let _e2835 = (_e2830 >> bitcast<u32>(4u));
                                                        if (_e2833 == 0u) {
                                                            if (_e2835 < _e138) {
                                                            } else {
                                                                phi_16735_ = true;
                                                                phi_12554_ = bool();
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
                                                                    phi_16735_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e2832] = _e3672;
                                                                phi_7081_ = (_e2832 + 1u);
                                                            } else {
                                                                phi_7081_ = _e2832;
                                                            }
                                                            let _e3678 = phi_7081_;
                                                            if (select(340282350000000000000000000000000000000f, _e3598, (_e3598 <= select(0.9999995f, _e3638, (_e3638 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e3678 < 64u) {
                                                                } else {
                                                                    phi_16735_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e3678] = _e3668;
                                                                phi_7093_ = (_e3678 + 1u);
                                                            } else {
                                                                phi_7093_ = _e3678;
                                                            }
                                                            let _e3684 = phi_7093_;
                                                            if (select(340282350000000000000000000000000000000f, _e3596, (_e3596 <= select(0.9999995f, _e3636, (_e3636 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e3684 < 64u) {
                                                                } else {
                                                                    phi_16735_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e3684] = _e3664;
                                                                phi_7105_ = (_e3684 + 1u);
                                                            } else {
                                                                phi_7105_ = _e3684;
                                                            }
                                                            let _e3690 = phi_7105_;
                                                            if (select(340282350000000000000000000000000000000f, _e3594, (_e3594 <= select(0.9999995f, _e3634, (_e3634 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                                if (_e3690 < 64u) {
                                                                } else {
                                                                    phi_16735_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                local_9[_e3690] = _e3660;
                                                                phi_7117_ = (_e3690 + 1u);
                                                            } else {
                                                                phi_7117_ = _e3690;
                                                            }
                                                            let _e3696 = phi_7117_;
                                                            phi_16737_ = _e2828;
                                                            phi_7810_ = _e3696;
                                                            phi_7811_ = true;
                                                        } else {
                                                            phi_7121_ = type_9(_e2835, (_e2835 + _e2833));
                                                            loop {
                                                                let _e2840 = phi_7121_;
                                                                if (_e2840.member < _e2840.member_1) {
                                                                    phi_7122_ = type_9((_e2840.member + 1u), _e2840.member_1);
                                                                    phi_7145_ = type_9(1u, _e2840.member);
                                                                } else {
                                                                    phi_7122_ = _e2840;
                                                                    phi_7145_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e2853 = phi_7122_;
                                                                let _e2855 = phi_7145_;
                                                                let _e2859 = (bitcast<i32>(_e2855.member) != 0i);
                                                                if _e2859 {
                                                                    let _e2860 = (_e2855.member_1 < _e141);
                                                                    if _e2860 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    if _e2746 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2864 = triangles.member[_e2855.member_1].member[_e2743];
                                                                    let _e2865 = (_e2864 - _e2763);
                                                                    if _e2746 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2869 = triangles.member[_e2855.member_1].member_2[_e2743];
                                                                    let _e2870 = (_e2869 - _e2763);
                                                                    if _e2746 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2874 = triangles.member[_e2855.member_1].member_4[_e2743];
                                                                    let _e2875 = (_e2874 - _e2763);
                                                                    if _e2750 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2879 = triangles.member[_e2855.member_1].member[_e2742];
                                                                    let _e2882 = ((_e2879 - _e2759) - (_e2753 * _e2865));
                                                                    if _e2754 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2886 = triangles.member[_e2855.member_1].member[_e2741];
                                                                    let _e2889 = ((_e2886 - _e2761) - (_e2757 * _e2865));
                                                                    if _e2750 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2893 = triangles.member[_e2855.member_1].member_2[_e2742];
                                                                    let _e2896 = ((_e2893 - _e2759) - (_e2753 * _e2870));
                                                                    if _e2754 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2900 = triangles.member[_e2855.member_1].member_2[_e2741];
                                                                    let _e2903 = ((_e2900 - _e2761) - (_e2757 * _e2870));
                                                                    if _e2750 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2907 = triangles.member[_e2855.member_1].member_4[_e2742];
                                                                    let _e2910 = ((_e2907 - _e2759) - (_e2753 * _e2875));
                                                                    if _e2754 {
                                                                    } else {
                                                                        phi_16661_ = true;
                                                                        phi_12553_ = bool();
                                                                        break;
                                                                    }
                                                                    let _e2914 = triangles.member[_e2855.member_1].member_4[_e2741];
                                                                    let _e2917 = ((_e2914 - _e2761) - (_e2757 * _e2875));
                                                                    let _e2918 = (_e2910 * _e2903);
                                                                    let _e2919 = (_e2917 * _e2896);
                                                                    if (_e2918 != _e2919) {
                                                                        phi_7261_ = (_e2918 - _e2919);
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
                                                                        phi_7261_ = ((((((_e2923 * _e2926) - _e2918) + (_e2923 * _e2928)) + (_e2927 * _e2926)) + (_e2927 * _e2928)) - (((((_e2939 * _e2942) - _e2919) + (_e2939 * _e2944)) + (_e2943 * _e2942)) + (_e2943 * _e2944)));
                                                                    }
                                                                    let _e2956 = phi_7261_;
                                                                    let _e2957 = (_e2882 * _e2917);
                                                                    let _e2958 = (_e2889 * _e2910);
                                                                    if (_e2957 != _e2958) {
                                                                        phi_7272_ = (_e2957 - _e2958);
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
                                                                        phi_7272_ = ((((((_e2962 * _e2965) - _e2957) + (_e2962 * _e2967)) + (_e2966 * _e2965)) + (_e2966 * _e2967)) - (((((_e2978 * _e2981) - _e2958) + (_e2978 * _e2983)) + (_e2982 * _e2981)) + (_e2982 * _e2983)));
                                                                    }
                                                                    let _e2995 = phi_7272_;
                                                                    let _e2996 = (_e2896 * _e2889);
                                                                    let _e2997 = (_e2903 * _e2882);
                                                                    if (_e2996 != _e2997) {
                                                                        phi_7283_ = (_e2996 - _e2997);
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
                                                                        phi_7283_ = ((((((_e3001 * _e3004) - _e2996) + (_e3001 * _e3006)) + (_e3005 * _e3004)) + (_e3005 * _e3006)) - (((((_e3017 * _e3020) - _e2997) + (_e3017 * _e3022)) + (_e3021 * _e3020)) + (_e3021 * _e3022)));
                                                                    }
                                                                    let _e3034 = phi_7283_;
                                                                    if (_e2956 < 0f) {
                                                                        phi_7301_ = f32();
                                                                        phi_7302_ = true;
                                                                    } else {
                                                                        if (_e2995 < 0f) {
                                                                            phi_7299_ = f32();
                                                                            phi_7300_ = true;
                                                                        } else {
                                                                            let _e3037 = (_e3034 < 0f);
                                                                            if _e3037 {
                                                                                phi_7298_ = f32();
                                                                            } else {
                                                                                phi_7298_ = ((_e2956 + _e2995) + _e3034);
                                                                            }
                                                                            let _e3041 = phi_7298_;
                                                                            phi_7299_ = _e3041;
                                                                            phi_7300_ = _e3037;
                                                                        }
                                                                        let _e3043 = phi_7299_;
                                                                        let _e3045 = phi_7300_;
                                                                        phi_7301_ = _e3043;
                                                                        phi_7302_ = _e3045;
                                                                    }
                                                                    let _e3047 = phi_7301_;
                                                                    let _e3049 = phi_7302_;
                                                                    if _e3049 {
                                                                        if (_e2956 > 0f) {
                                                                            phi_7323_ = f32();
                                                                            phi_7324_ = true;
                                                                            phi_7325_ = false;
                                                                        } else {
                                                                            let _e3051 = (_e2995 > 0f);
                                                                            if _e3051 {
                                                                                phi_7321_ = f32();
                                                                                phi_7322_ = false;
                                                                            } else {
                                                                                phi_7321_ = ((_e2956 + _e2995) + _e3034);
                                                                                phi_7322_ = select(true, false, (_e3034 > 0f));
                                                                            }
                                                                            let _e3057 = phi_7321_;
                                                                            let _e3059 = phi_7322_;
                                                                            phi_7323_ = _e3057;
                                                                            phi_7324_ = _e3051;
                                                                            phi_7325_ = _e3059;
                                                                        }
                                                                        let _e3061 = phi_7323_;
                                                                        let _e3063 = phi_7324_;
                                                                        let _e3065 = phi_7325_;
                                                                        phi_7330_ = _e3061;
                                                                        phi_7331_ = select(_e3065, false, _e3063);
                                                                    } else {
                                                                        phi_7330_ = _e3047;
                                                                        phi_7331_ = true;
                                                                    }
                                                                    let _e3068 = phi_7330_;
                                                                    let _e3070 = phi_7331_;
                                                                    if _e3070 {
                                                                        let _e3071 = (_e3068 == 0f);
                                                                        if _e3071 {
                                                                            phi_7419_ = array<f32, 3>();
                                                                            phi_7420_ = array<f32, 3>();
                                                                            phi_7421_ = false;
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
                                                                                phi_7417_ = array<f32, 3>(_e3085, _e3078, _e3079);
                                                                                phi_7418_ = array<f32, 3>();
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
                                                                                phi_7417_ = array<f32, 3>();
                                                                                phi_7418_ = array<f32, 3>(((((_e3147 * _e3196) * _e3072) + (_e3197 * _e3073)) + (_e3198 * _e3074)), _e3197, _e3198);
                                                                            }
                                                                            let _e3208 = phi_7417_;
                                                                            let _e3210 = phi_7418_;
                                                                            phi_7419_ = _e3208;
                                                                            phi_7420_ = _e3210;
                                                                            phi_7421_ = _e3112;
                                                                        }
                                                                        let _e3212 = phi_7419_;
                                                                        let _e3214 = phi_7420_;
                                                                        let _e3216 = phi_7421_;
                                                                        phi_7422_ = _e3212;
                                                                        phi_7423_ = _e3214;
                                                                        phi_7424_ = _e3071;
                                                                        phi_7425_ = _e3216;
                                                                    } else {
                                                                        phi_7422_ = array<f32, 3>();
                                                                        phi_7423_ = array<f32, 3>();
                                                                        phi_7424_ = true;
                                                                        phi_7425_ = false;
                                                                    }
                                                                    let _e3218 = phi_7422_;
                                                                    let _e3220 = phi_7423_;
                                                                    let _e3222 = phi_7424_;
                                                                    let _e3224 = phi_7425_;
                                                                    if _e3222 {
                                                                        phi_7430_ = array<f32, 3>(-1f, 0f, 0f);
                                                                    } else {
                                                                        phi_7430_ = _e3218;
                                                                    }
                                                                    let _e3226 = phi_7430_;
                                                                    if select(_e3224, true, _e3222) {
                                                                        phi_7435_ = _e3226;
                                                                    } else {
                                                                        phi_7435_ = _e3220;
                                                                    }
                                                                    let _e3229 = phi_7435_;
                                                                    let _e3233 = (_e3229[0] >= 0f);
                                                                    if _e3233 {
                                                                        let _e3234 = (_e3229[0] < 0.9999995f);
                                                                        if _e3234 {
                                                                            if _e3233 {
                                                                                if _e2860 {
                                                                                } else {
                                                                                    phi_16661_ = true;
                                                                                    phi_12553_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e3237 = triangles.member[_e2855.member_1].member_3;
                                                                                if ((_e3237 & 1u) == 0u) {
                                                                                    phi_7768_ = true;
                                                                                } else {
                                                                                    if _e2860 {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3242 = triangles.member[_e2855.member_1].member_1;
                                                                                    let _e3243 = (_e3242 * 12u);
                                                                                    if ((256u + _e3243) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 257u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 258u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3250 = (_e3243 + 259u);
                                                                                    if (_e3250 < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3253 = surfaces.member[_e3250];
                                                                                    if ((_e3243 + 260u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 261u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 262u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3260 = (_e3243 + 263u);
                                                                                    if (_e3260 < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3263 = surfaces.member[_e3260];
                                                                                    let _e3264 = (_e3243 + 264u);
                                                                                    if (_e3264 < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3267 = surfaces.member[_e3264];
                                                                                    let _e3268 = bitcast<f32>(_e3267);
                                                                                    let _e3269 = (_e3243 + 265u);
                                                                                    if (_e3269 < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    let _e3272 = surfaces.member[_e3269];
                                                                                    let _e3273 = bitcast<f32>(_e3272);
                                                                                    if ((_e3243 + 266u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if ((_e3243 + 267u) < _e147) {
                                                                                    } else {
                                                                                        phi_16661_ = true;
                                                                                        phi_12553_ = bool();
                                                                                        break;
                                                                                    }
                                                                                    if (_e3253 == 4294967295u) {
                                                                                        phi_7763_ = (_e3268 < _e3273);
                                                                                    } else {
                                                                                        if (_e2855.member_1 < _e144) {
                                                                                        } else {
                                                                                            phi_16661_ = true;
                                                                                            phi_12553_ = bool();
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
                                                                                            phi_7646_ = _e3328;
                                                                                        } else {
                                                                                            let _e3334 = select(select(u32(_e3326), 0u, (_e3326 < 0f)), 4294967295u, (_e3326 > 4294967000f));
                                                                                            phi_7646_ = select(_e3334, _e3328, (_e3328 < _e3334));
                                                                                        }
                                                                                        let _e3338 = phi_7646_;
                                                                                        if (_e3338 == _e3328) {
                                                                                            phi_7652_ = 0u;
                                                                                        } else {
                                                                                            phi_7652_ = (_e3338 + 1u);
                                                                                        }
                                                                                        let _e3342 = phi_7652_;
                                                                                        let _e3344 = (_e3315 - floor(_e3315));
                                                                                        let _e3349 = ((select(0f, _e3344, (_e3344 <= 1f)) * f32(_e3318)) - 0.5f);
                                                                                        let _e3350 = floor(_e3349);
                                                                                        let _e3351 = (_e3349 - _e3350);
                                                                                        let _e3352 = (_e3318 - 1u);
                                                                                        if (_e3350 < 0f) {
                                                                                            phi_7682_ = _e3352;
                                                                                        } else {
                                                                                            let _e3358 = select(select(u32(_e3350), 0u, (_e3350 < 0f)), 4294967295u, (_e3350 > 4294967000f));
                                                                                            phi_7682_ = select(_e3358, _e3352, (_e3352 < _e3358));
                                                                                        }
                                                                                        let _e3362 = phi_7682_;
                                                                                        if (_e3362 == _e3352) {
                                                                                            phi_7688_ = 0u;
                                                                                        } else {
                                                                                            phi_7688_ = (_e3362 + 1u);
                                                                                        }
                                                                                        let _e3366 = phi_7688_;
                                                                                        let _e3368 = (_e3253 + (_e3362 * _e3316));
                                                                                        let _e3370 = (_e3253 + (_e3366 * _e3316));
                                                                                        let _e3371 = (_e3368 + _e3338);
                                                                                        let _e3372 = (_e3368 + _e3342);
                                                                                        let _e3373 = (_e3370 + _e3338);
                                                                                        let _e3374 = (_e3370 + _e3342);
                                                                                        if (_e3371 < _e147) {
                                                                                        } else {
                                                                                            phi_16661_ = true;
                                                                                            phi_12553_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3377 = surfaces.member[_e3371];
                                                                                        if (_e3372 < _e147) {
                                                                                        } else {
                                                                                            phi_16661_ = true;
                                                                                            phi_12553_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3380 = surfaces.member[_e3372];
                                                                                        if (_e3373 < _e147) {
                                                                                        } else {
                                                                                            phi_16661_ = true;
                                                                                            phi_12553_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3383 = surfaces.member[_e3373];
                                                                                        if (_e3374 < _e147) {
                                                                                        } else {
                                                                                            phi_16661_ = true;
                                                                                            phi_12553_ = bool();
                                                                                            break;
                                                                                        }
                                                                                        let _e3386 = surfaces.member[_e3374];
                                                                                        let _e3403 = (1f - _e3327);
                                                                                        phi_7763_ = ((_e3268 * (((((f32((_e3377 >> bitcast<u32>(24i))) * 0.003921569f) * _e3403) + ((f32((_e3380 >> bitcast<u32>(24i))) * 0.003921569f) * _e3327)) * (1f - _e3351)) + ((((f32((_e3383 >> bitcast<u32>(24i))) * 0.003921569f) * _e3403) + ((f32((_e3386 >> bitcast<u32>(24i))) * 0.003921569f) * _e3327)) * _e3351))) < _e3273);
                                                                                    }
                                                                                    let _e3418 = phi_7763_;
                                                                                    phi_7768_ = select(true, false, _e3418);
                                                                                }
                                                                                let _e3421 = phi_7768_;
                                                                                if _e3421 {
                                                                                    phi_7773_ = type_47(_e3229[0], _e2855.member_1, _e3229[1], _e3229[2]);
                                                                                } else {
                                                                                    phi_7773_ = type_47();
                                                                                }
                                                                                let _e3424 = phi_7773_;
                                                                                phi_7775_ = _e3424;
                                                                                phi_7777_ = select(true, false, _e3421);
                                                                            } else {
                                                                                phi_7775_ = type_47();
                                                                                phi_7777_ = false;
                                                                            }
                                                                            let _e3427 = phi_7775_;
                                                                            let _e3429 = phi_7777_;
                                                                            phi_7778_ = _e3427;
                                                                            phi_7780_ = select(true, false, _e3233);
                                                                            phi_7781_ = _e3429;
                                                                        } else {
                                                                            phi_7778_ = type_47();
                                                                            phi_7780_ = false;
                                                                            phi_7781_ = false;
                                                                        }
                                                                        let _e3432 = phi_7778_;
                                                                        let _e3434 = phi_7780_;
                                                                        let _e3436 = phi_7781_;
                                                                        phi_7782_ = _e3432;
                                                                        phi_7783_ = select(true, false, _e3234);
                                                                        phi_7784_ = _e3434;
                                                                        phi_7785_ = _e3436;
                                                                    } else {
                                                                        phi_7782_ = type_47();
                                                                        phi_7783_ = true;
                                                                        phi_7784_ = false;
                                                                        phi_7785_ = false;
                                                                    }
                                                                    let _e3439 = phi_7782_;
                                                                    let _e3441 = phi_7783_;
                                                                    let _e3443 = phi_7784_;
                                                                    let _e3445 = phi_7785_;
                                                                    if select(select(_e3445, false, _e3441), true, select(_e3443, true, _e3441)) {
                                                                        phi_7798_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                                    } else {
                                                                        phi_7798_ = _e3439;
                                                                    }
                                                                    let _e3450 = phi_7798_;
                                                                    phi_7805_ = select(true, false, (_e3450.member_1 != 4294967295u));
                                                                } else {
                                                                    phi_7805_ = false;
                                                                }
                                                                let _e3455 = phi_7805_;
                                                                continue;
                                                                continuing {
                                                                    phi_7121_ = _e2853;
                                                                    phi_16661_ = _e2828;
                                                                    phi_12553_ = select(true, false, _e2859);
                                                                    break if !(_e3455);
                                                                }
                                                            }
                                                            let _e3459 = phi_16661_;
                                                            let _e3461 = phi_12553_;
                                                            phi_16735_ = _e3459;
                                                            phi_12554_ = bool();
                                                            if _e3459 {
                                                                break;
                                                            }
                                                            phi_16737_ = _e3459;
                                                            phi_7810_ = _e2832;
                                                            phi_7811_ = _e3461;
                                                        }
                                                        let _e3698 = phi_16737_;
                                                        let _e3700 = phi_7810_;
                                                        let _e3702 = phi_7811_;
                                                        if _e3702 {
                                                            let _e3703 = (_e3700 == 0u);
                                                            if _e3703 {
                                                                phi_7827_ = u32();
                                                                phi_7828_ = u32();
                                                            } else {
                                                                let _e3704 = (_e3700 - 1u);
                                                                if (_e3704 < 64u) {
                                                                } else {
                                                                    phi_16735_ = true;
                                                                    phi_12554_ = bool();
                                                                    break;
                                                                }
                                                                let _e3707 = local_9[_e3704];
                                                                phi_7827_ = _e3707;
                                                                phi_7828_ = _e3704;
                                                            }
                                                            let _e3709 = phi_7827_;
                                                            let _e3711 = phi_7828_;
                                                            phi_6694_ = _e3709;
                                                            phi_6697_ = _e3711;
                                                            phi_7830_ = select(true, false, _e3703);
                                                            phi_7831_ = _e3703;
                                                        } else {
                                                            phi_6694_ = u32();
                                                            phi_6697_ = u32();
                                                            phi_7830_ = false;
                                                            phi_7831_ = false;
                                                        }
                                                        let _e3714 = phi_6694_;
                                                        let _e3716 = phi_6697_;
                                                        let _e3718 = phi_7830_;
                                                        let _e3720 = phi_7831_;
                                                        continue;
                                                        continuing {
                                                            phi_16665_ = _e3698;
                                                            phi_6693_ = _e3714;
                                                            phi_6696_ = _e3716;
                                                            phi_16735_ = _e3698;
                                                            phi_12554_ = _e3720;
                                                            break if !(_e3718);
                                                        }
                                                    }
                                                    let _e3723 = phi_16735_;
                                                    let _e3725 = phi_12554_;
                                                    phi_16795_ = _e3723;
                                                    if _e3723 {
                                                        break;
                                                    }
                                                    if !(select(false, true, select(true, false, _e3725))) {
                                                        phi_7845_ = (_e2563 + _e2679);
                                                    } else {
                                                        phi_7845_ = _e2563;
                                                    }
                                                    let _e3731 = phi_7845_;
                                                    phi_16797_ = _e3723;
                                                    phi_7846_ = _e3731;
                                                } else {
                                                    phi_16797_ = _e2559;
                                                    phi_7846_ = _e2563;
                                                }
                                                let _e3733 = phi_16797_;
                                                let _e3735 = phi_7846_;
                                                phi_16796_ = _e3733;
                                                phi_6303_ = _e3735;
                                            } else {
                                                phi_16796_ = _e2559;
                                                phi_6303_ = f32();
                                            }
                                            let _e3737 = phi_16796_;
                                            let _e3739 = phi_6303_;
                                            continue;
                                            continuing {
                                                phi_16687_ = _e3737;
                                                phi_6297_ = _e2576;
                                                phi_6302_ = _e3739;
                                                phi_16795_ = _e3737;
                                                break if !(_e2582);
                                            }
                                        }
                                        let _e3742 = phi_16795_;
                                        phi_16801_ = _e3742;
                                        if _e3742 {
                                            break;
                                        }
                                        let _e3744 = local_23;
                                        if (_e3744 <= 0f) {
                                            phi_7875_ = 0f;
                                        } else {
                                            let _e3748 = local_24;
                                            phi_7875_ = (_e3748 * _e321.member_3);
                                        }
                                        let _e3751 = phi_7875_;
                                        phi_16818_ = _e3742;
                                        phi_7881_ = _e3751;
                                    }
                                    let _e3753 = phi_16818_;
                                    let _e3755 = phi_7881_;
                                    phi_16805_ = _e3753;
                                    phi_10753_ = vec3<f32>((_e321.member_6[0] * _e3755), (_e321.member_6[1] * _e3755), (_e321.member_6[2] * _e3755));
                                    phi_10754_ = vec3<f32>();
                                    phi_10755_ = true;
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
                                                phi_7933_ = -(_e207);
                                            } else {
                                                phi_7933_ = _e207;
                                            }
                                            let _e1460 = phi_7933_;
                                            let _e1464 = (_e163.member[0] + (_e185.x * _e1460));
                                            let _e1465 = (_e163.member[1] + (_e185.y * _e1460));
                                            let _e1466 = (_e163.member[2] + (_e185.z * _e1460));
                                            let _e1467 = abs(_e1443);
                                            let _e1468 = abs(_e1444);
                                            let _e1469 = abs(_e1445);
                                            let _e1470 = (_e1467 > _e1468);
                                            if _e1470 {
                                                phi_7962_ = (_e1467 > _e1469);
                                            } else {
                                                phi_7962_ = (_e1468 > _e1469);
                                            }
                                            let _e1474 = phi_7962_;
                                            let _e1475 = select(1u, 0u, _e1470);
                                            if _e1474 {
                                                let _e1476 = (_e1475 + 1u);
                                                phi_7972_ = _e1476;
                                                phi_7975_ = select(true, false, (_e1476 == 2u));
                                            } else {
                                                phi_7972_ = u32();
                                                phi_7975_ = false;
                                            }
                                            let _e1480 = phi_7972_;
                                            let _e1482 = phi_7975_;
                                            let _e1483 = select(true, false, _e1474);
                                            let _e1484 = select(_e1480, 0u, _e1483);
                                            let _e1486 = select(_e1482, true, _e1483);
                                            if _e1486 {
                                                phi_7986_ = (_e1484 + 1u);
                                            } else {
                                                phi_7986_ = 0u;
                                            }
                                            let _e1489 = phi_7986_;
                                            let _e1490 = select(_e1480, _e1484, _e1486);
                                            let _e1491 = select(_e1475, select(_e1475, 2u, _e1483), _e1486);
                                            local_7 = array<f32, 3>(_e1443, _e1444, _e1445);
                                            local_8 = array<f32, 3>(_e1464, _e1465, _e1466);
                                            let _e1494 = (_e1491 < 3u);
                                            if _e1494 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e1496 = local_7[_e1491];
                                            let _e1497 = (1f / _e1496);
                                            let _e1498 = (_e1490 < 3u);
                                            if _e1498 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e1500 = local_7[_e1490];
                                            let _e1501 = (_e1500 * _e1497);
                                            let _e1502 = (_e1489 < 3u);
                                            if _e1502 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e1504 = local_7[_e1489];
                                            let _e1505 = (_e1504 * _e1497);
                                            if _e1498 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e1507 = local_8[_e1490];
                                            if _e1502 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e1509 = local_8[_e1489];
                                            if _e1494 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e1511 = local_8[_e1491];
                                            if (0u < _e138) {
                                            } else {
                                                phi_16801_ = true;
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
                                                phi_8116_ = (-1f / _e321.member_2[0]);
                                            } else {
                                                phi_8116_ = (1000000000000f / _e1552);
                                            }
                                            let _e1564 = phi_8116_;
                                            if (_e1468 > _e1553) {
                                                phi_8124_ = (-1f / _e321.member_2[1]);
                                            } else {
                                                phi_8124_ = (1000000000000f / _e1552);
                                            }
                                            let _e1569 = phi_8124_;
                                            if (_e1469 > _e1553) {
                                                phi_8132_ = (-1f / _e321.member_2[2]);
                                            } else {
                                                phi_8132_ = (1000000000000f / _e1552);
                                            }
                                            let _e1574 = phi_8132_;
                                            local_6 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_16545_ = _e313;
                                            phi_8135_ = 0u;
                                            phi_8138_ = 0u;
                                            loop {
                                                let _e1576 = phi_16545_;
                                                let _e1578 = phi_8135_;
                                                let _e1580 = phi_8138_;
                                                let _e1581 = (_e1578 & 15u);
                                                let _e1583 = (_e1578 >> bitcast<u32>(4u));
                                                if (_e1581 == 0u) {
                                                    if (_e1583 < _e138) {
                                                    } else {
                                                        phi_16601_ = true;
                                                        phi_12552_ = bool();
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
                                                            phi_16601_ = true;
                                                            phi_12552_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e1580] = _e2420;
                                                        phi_8523_ = (_e1580 + 1u);
                                                    } else {
                                                        phi_8523_ = _e1580;
                                                    }
                                                    let _e2426 = phi_8523_;
                                                    if (select(340282350000000000000000000000000000000f, _e2346, (_e2346 <= select(340282350000000000000000000000000000000f, _e2386, (_e2386 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2426 < 64u) {
                                                        } else {
                                                            phi_16601_ = true;
                                                            phi_12552_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e2426] = _e2416;
                                                        phi_8535_ = (_e2426 + 1u);
                                                    } else {
                                                        phi_8535_ = _e2426;
                                                    }
                                                    let _e2432 = phi_8535_;
                                                    if (select(340282350000000000000000000000000000000f, _e2344, (_e2344 <= select(340282350000000000000000000000000000000f, _e2384, (_e2384 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2432 < 64u) {
                                                        } else {
                                                            phi_16601_ = true;
                                                            phi_12552_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e2432] = _e2412;
                                                        phi_8547_ = (_e2432 + 1u);
                                                    } else {
                                                        phi_8547_ = _e2432;
                                                    }
                                                    let _e2438 = phi_8547_;
                                                    if (select(340282350000000000000000000000000000000f, _e2342, (_e2342 <= select(340282350000000000000000000000000000000f, _e2382, (_e2382 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e2438 < 64u) {
                                                        } else {
                                                            phi_16601_ = true;
                                                            phi_12552_ = bool();
                                                            break;
                                                        }
                                                        local_6[_e2438] = _e2408;
                                                        phi_8559_ = (_e2438 + 1u);
                                                    } else {
                                                        phi_8559_ = _e2438;
                                                    }
                                                    let _e2444 = phi_8559_;
                                                    phi_16603_ = _e1576;
                                                    phi_9252_ = _e2444;
                                                    phi_9253_ = true;
                                                } else {
                                                    phi_8563_ = type_9(_e1583, (_e1583 + _e1581));
                                                    loop {
                                                        let _e1588 = phi_8563_;
                                                        if (_e1588.member < _e1588.member_1) {
                                                            phi_8564_ = type_9((_e1588.member + 1u), _e1588.member_1);
                                                            phi_8587_ = type_9(1u, _e1588.member);
                                                        } else {
                                                            phi_8564_ = _e1588;
                                                            phi_8587_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e1601 = phi_8564_;
                                                        let _e1603 = phi_8587_;
                                                        let _e1607 = (bitcast<i32>(_e1603.member) != 0i);
                                                        if _e1607 {
                                                            let _e1608 = (_e1603.member_1 < _e141);
                                                            if _e1608 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            if _e1494 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1612 = triangles.member[_e1603.member_1].member[_e1491];
                                                            let _e1613 = (_e1612 - _e1511);
                                                            if _e1494 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1617 = triangles.member[_e1603.member_1].member_2[_e1491];
                                                            let _e1618 = (_e1617 - _e1511);
                                                            if _e1494 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1622 = triangles.member[_e1603.member_1].member_4[_e1491];
                                                            let _e1623 = (_e1622 - _e1511);
                                                            if _e1498 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1627 = triangles.member[_e1603.member_1].member[_e1490];
                                                            let _e1630 = ((_e1627 - _e1507) - (_e1501 * _e1613));
                                                            if _e1502 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1634 = triangles.member[_e1603.member_1].member[_e1489];
                                                            let _e1637 = ((_e1634 - _e1509) - (_e1505 * _e1613));
                                                            if _e1498 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1641 = triangles.member[_e1603.member_1].member_2[_e1490];
                                                            let _e1644 = ((_e1641 - _e1507) - (_e1501 * _e1618));
                                                            if _e1502 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1648 = triangles.member[_e1603.member_1].member_2[_e1489];
                                                            let _e1651 = ((_e1648 - _e1509) - (_e1505 * _e1618));
                                                            if _e1498 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1655 = triangles.member[_e1603.member_1].member_4[_e1490];
                                                            let _e1658 = ((_e1655 - _e1507) - (_e1501 * _e1623));
                                                            if _e1502 {
                                                            } else {
                                                                phi_16541_ = true;
                                                                phi_12551_ = bool();
                                                                break;
                                                            }
                                                            let _e1662 = triangles.member[_e1603.member_1].member_4[_e1489];
                                                            let _e1665 = ((_e1662 - _e1509) - (_e1505 * _e1623));
                                                            let _e1666 = (_e1658 * _e1651);
                                                            let _e1667 = (_e1665 * _e1644);
                                                            if (_e1666 != _e1667) {
                                                                phi_8703_ = (_e1666 - _e1667);
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
                                                                phi_8703_ = ((((((_e1671 * _e1674) - _e1666) + (_e1671 * _e1676)) + (_e1675 * _e1674)) + (_e1675 * _e1676)) - (((((_e1687 * _e1690) - _e1667) + (_e1687 * _e1692)) + (_e1691 * _e1690)) + (_e1691 * _e1692)));
                                                            }
                                                            let _e1704 = phi_8703_;
                                                            let _e1705 = (_e1630 * _e1665);
                                                            let _e1706 = (_e1637 * _e1658);
                                                            if (_e1705 != _e1706) {
                                                                phi_8714_ = (_e1705 - _e1706);
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
                                                                phi_8714_ = ((((((_e1710 * _e1713) - _e1705) + (_e1710 * _e1715)) + (_e1714 * _e1713)) + (_e1714 * _e1715)) - (((((_e1726 * _e1729) - _e1706) + (_e1726 * _e1731)) + (_e1730 * _e1729)) + (_e1730 * _e1731)));
                                                            }
                                                            let _e1743 = phi_8714_;
                                                            let _e1744 = (_e1644 * _e1637);
                                                            let _e1745 = (_e1651 * _e1630);
                                                            if (_e1744 != _e1745) {
                                                                phi_8725_ = (_e1744 - _e1745);
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
                                                                phi_8725_ = ((((((_e1749 * _e1752) - _e1744) + (_e1749 * _e1754)) + (_e1753 * _e1752)) + (_e1753 * _e1754)) - (((((_e1765 * _e1768) - _e1745) + (_e1765 * _e1770)) + (_e1769 * _e1768)) + (_e1769 * _e1770)));
                                                            }
                                                            let _e1782 = phi_8725_;
                                                            if (_e1704 < 0f) {
                                                                phi_8743_ = f32();
                                                                phi_8744_ = true;
                                                            } else {
                                                                if (_e1743 < 0f) {
                                                                    phi_8741_ = f32();
                                                                    phi_8742_ = true;
                                                                } else {
                                                                    let _e1785 = (_e1782 < 0f);
                                                                    if _e1785 {
                                                                        phi_8740_ = f32();
                                                                    } else {
                                                                        phi_8740_ = ((_e1704 + _e1743) + _e1782);
                                                                    }
                                                                    let _e1789 = phi_8740_;
                                                                    phi_8741_ = _e1789;
                                                                    phi_8742_ = _e1785;
                                                                }
                                                                let _e1791 = phi_8741_;
                                                                let _e1793 = phi_8742_;
                                                                phi_8743_ = _e1791;
                                                                phi_8744_ = _e1793;
                                                            }
                                                            let _e1795 = phi_8743_;
                                                            let _e1797 = phi_8744_;
                                                            if _e1797 {
                                                                if (_e1704 > 0f) {
                                                                    phi_8765_ = f32();
                                                                    phi_8766_ = true;
                                                                    phi_8767_ = false;
                                                                } else {
                                                                    let _e1799 = (_e1743 > 0f);
                                                                    if _e1799 {
                                                                        phi_8763_ = f32();
                                                                        phi_8764_ = false;
                                                                    } else {
                                                                        phi_8763_ = ((_e1704 + _e1743) + _e1782);
                                                                        phi_8764_ = select(true, false, (_e1782 > 0f));
                                                                    }
                                                                    let _e1805 = phi_8763_;
                                                                    let _e1807 = phi_8764_;
                                                                    phi_8765_ = _e1805;
                                                                    phi_8766_ = _e1799;
                                                                    phi_8767_ = _e1807;
                                                                }
                                                                let _e1809 = phi_8765_;
                                                                let _e1811 = phi_8766_;
                                                                let _e1813 = phi_8767_;
                                                                phi_8772_ = _e1809;
                                                                phi_8773_ = select(_e1813, false, _e1811);
                                                            } else {
                                                                phi_8772_ = _e1795;
                                                                phi_8773_ = true;
                                                            }
                                                            let _e1816 = phi_8772_;
                                                            let _e1818 = phi_8773_;
                                                            if _e1818 {
                                                                let _e1819 = (_e1816 == 0f);
                                                                if _e1819 {
                                                                    phi_8861_ = array<f32, 3>();
                                                                    phi_8862_ = array<f32, 3>();
                                                                    phi_8863_ = false;
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
                                                                        phi_8859_ = array<f32, 3>(_e1833, _e1826, _e1827);
                                                                        phi_8860_ = array<f32, 3>();
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
                                                                        phi_8859_ = array<f32, 3>();
                                                                        phi_8860_ = array<f32, 3>(((((_e1895 * _e1944) * _e1820) + (_e1945 * _e1821)) + (_e1946 * _e1822)), _e1945, _e1946);
                                                                    }
                                                                    let _e1956 = phi_8859_;
                                                                    let _e1958 = phi_8860_;
                                                                    phi_8861_ = _e1956;
                                                                    phi_8862_ = _e1958;
                                                                    phi_8863_ = _e1860;
                                                                }
                                                                let _e1960 = phi_8861_;
                                                                let _e1962 = phi_8862_;
                                                                let _e1964 = phi_8863_;
                                                                phi_8864_ = _e1960;
                                                                phi_8865_ = _e1962;
                                                                phi_8866_ = _e1819;
                                                                phi_8867_ = _e1964;
                                                            } else {
                                                                phi_8864_ = array<f32, 3>();
                                                                phi_8865_ = array<f32, 3>();
                                                                phi_8866_ = true;
                                                                phi_8867_ = false;
                                                            }
                                                            let _e1966 = phi_8864_;
                                                            let _e1968 = phi_8865_;
                                                            let _e1970 = phi_8866_;
                                                            let _e1972 = phi_8867_;
                                                            if _e1970 {
                                                                phi_8872_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_8872_ = _e1966;
                                                            }
                                                            let _e1974 = phi_8872_;
                                                            if select(_e1972, true, _e1970) {
                                                                phi_8877_ = _e1974;
                                                            } else {
                                                                phi_8877_ = _e1968;
                                                            }
                                                            let _e1977 = phi_8877_;
                                                            let _e1981 = (_e1977[0] >= 0f);
                                                            if _e1981 {
                                                                let _e1982 = (_e1977[0] < 340282350000000000000000000000000000000f);
                                                                if _e1982 {
                                                                    if _e1981 {
                                                                        if _e1608 {
                                                                        } else {
                                                                            phi_16541_ = true;
                                                                            phi_12551_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e1985 = triangles.member[_e1603.member_1].member_3;
                                                                        if ((_e1985 & 1u) == 0u) {
                                                                            phi_9210_ = true;
                                                                        } else {
                                                                            if _e1608 {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1990 = triangles.member[_e1603.member_1].member_1;
                                                                            let _e1991 = (_e1990 * 12u);
                                                                            if ((256u + _e1991) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 257u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 258u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e1998 = (_e1991 + 259u);
                                                                            if (_e1998 < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2001 = surfaces.member[_e1998];
                                                                            if ((_e1991 + 260u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 261u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 262u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2008 = (_e1991 + 263u);
                                                                            if (_e2008 < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2011 = surfaces.member[_e2008];
                                                                            let _e2012 = (_e1991 + 264u);
                                                                            if (_e2012 < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2015 = surfaces.member[_e2012];
                                                                            let _e2016 = bitcast<f32>(_e2015);
                                                                            let _e2017 = (_e1991 + 265u);
                                                                            if (_e2017 < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e2020 = surfaces.member[_e2017];
                                                                            let _e2021 = bitcast<f32>(_e2020);
                                                                            if ((_e1991 + 266u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e1991 + 267u) < _e147) {
                                                                            } else {
                                                                                phi_16541_ = true;
                                                                                phi_12551_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e2001 == 4294967295u) {
                                                                                phi_9205_ = (_e2016 < _e2021);
                                                                            } else {
                                                                                if (_e1603.member_1 < _e144) {
                                                                                } else {
                                                                                    phi_16541_ = true;
                                                                                    phi_12551_ = bool();
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
                                                                                    phi_9088_ = _e2076;
                                                                                } else {
                                                                                    let _e2082 = select(select(u32(_e2074), 0u, (_e2074 < 0f)), 4294967295u, (_e2074 > 4294967000f));
                                                                                    phi_9088_ = select(_e2082, _e2076, (_e2076 < _e2082));
                                                                                }
                                                                                let _e2086 = phi_9088_;
                                                                                if (_e2086 == _e2076) {
                                                                                    phi_9094_ = 0u;
                                                                                } else {
                                                                                    phi_9094_ = (_e2086 + 1u);
                                                                                }
                                                                                let _e2090 = phi_9094_;
                                                                                let _e2092 = (_e2063 - floor(_e2063));
                                                                                let _e2097 = ((select(0f, _e2092, (_e2092 <= 1f)) * f32(_e2066)) - 0.5f);
                                                                                let _e2098 = floor(_e2097);
                                                                                let _e2099 = (_e2097 - _e2098);
                                                                                let _e2100 = (_e2066 - 1u);
                                                                                if (_e2098 < 0f) {
                                                                                    phi_9124_ = _e2100;
                                                                                } else {
                                                                                    let _e2106 = select(select(u32(_e2098), 0u, (_e2098 < 0f)), 4294967295u, (_e2098 > 4294967000f));
                                                                                    phi_9124_ = select(_e2106, _e2100, (_e2100 < _e2106));
                                                                                }
                                                                                let _e2110 = phi_9124_;
                                                                                if (_e2110 == _e2100) {
                                                                                    phi_9130_ = 0u;
                                                                                } else {
                                                                                    phi_9130_ = (_e2110 + 1u);
                                                                                }
                                                                                let _e2114 = phi_9130_;
                                                                                let _e2116 = (_e2001 + (_e2110 * _e2064));
                                                                                let _e2118 = (_e2001 + (_e2114 * _e2064));
                                                                                let _e2119 = (_e2116 + _e2086);
                                                                                let _e2120 = (_e2116 + _e2090);
                                                                                let _e2121 = (_e2118 + _e2086);
                                                                                let _e2122 = (_e2118 + _e2090);
                                                                                if (_e2119 < _e147) {
                                                                                } else {
                                                                                    phi_16541_ = true;
                                                                                    phi_12551_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2125 = surfaces.member[_e2119];
                                                                                if (_e2120 < _e147) {
                                                                                } else {
                                                                                    phi_16541_ = true;
                                                                                    phi_12551_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2128 = surfaces.member[_e2120];
                                                                                if (_e2121 < _e147) {
                                                                                } else {
                                                                                    phi_16541_ = true;
                                                                                    phi_12551_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2131 = surfaces.member[_e2121];
                                                                                if (_e2122 < _e147) {
                                                                                } else {
                                                                                    phi_16541_ = true;
                                                                                    phi_12551_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e2134 = surfaces.member[_e2122];
                                                                                let _e2151 = (1f - _e2075);
                                                                                phi_9205_ = ((_e2016 * (((((f32((_e2125 >> bitcast<u32>(24i))) * 0.003921569f) * _e2151) + ((f32((_e2128 >> bitcast<u32>(24i))) * 0.003921569f) * _e2075)) * (1f - _e2099)) + ((((f32((_e2131 >> bitcast<u32>(24i))) * 0.003921569f) * _e2151) + ((f32((_e2134 >> bitcast<u32>(24i))) * 0.003921569f) * _e2075)) * _e2099))) < _e2021);
                                                                            }
                                                                            let _e2166 = phi_9205_;
                                                                            phi_9210_ = select(true, false, _e2166);
                                                                        }
                                                                        let _e2169 = phi_9210_;
                                                                        if _e2169 {
                                                                            phi_9215_ = type_47(_e1977[0], _e1603.member_1, _e1977[1], _e1977[2]);
                                                                        } else {
                                                                            phi_9215_ = type_47();
                                                                        }
                                                                        let _e2172 = phi_9215_;
                                                                        phi_9217_ = _e2172;
                                                                        phi_9219_ = select(true, false, _e2169);
                                                                    } else {
                                                                        phi_9217_ = type_47();
                                                                        phi_9219_ = false;
                                                                    }
                                                                    let _e2175 = phi_9217_;
                                                                    let _e2177 = phi_9219_;
                                                                    phi_9220_ = _e2175;
                                                                    phi_9222_ = select(true, false, _e1981);
                                                                    phi_9223_ = _e2177;
                                                                } else {
                                                                    phi_9220_ = type_47();
                                                                    phi_9222_ = false;
                                                                    phi_9223_ = false;
                                                                }
                                                                let _e2180 = phi_9220_;
                                                                let _e2182 = phi_9222_;
                                                                let _e2184 = phi_9223_;
                                                                phi_9224_ = _e2180;
                                                                phi_9225_ = select(true, false, _e1982);
                                                                phi_9226_ = _e2182;
                                                                phi_9227_ = _e2184;
                                                            } else {
                                                                phi_9224_ = type_47();
                                                                phi_9225_ = true;
                                                                phi_9226_ = false;
                                                                phi_9227_ = false;
                                                            }
                                                            let _e2187 = phi_9224_;
                                                            let _e2189 = phi_9225_;
                                                            let _e2191 = phi_9226_;
                                                            let _e2193 = phi_9227_;
                                                            if select(select(_e2193, false, _e2189), true, select(_e2191, true, _e2189)) {
                                                                phi_9240_ = type_47(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_9240_ = _e2187;
                                                            }
                                                            let _e2198 = phi_9240_;
                                                            phi_9247_ = select(true, false, (_e2198.member_1 != 4294967295u));
                                                        } else {
                                                            phi_9247_ = false;
                                                        }
                                                        let _e2203 = phi_9247_;
                                                        continue;
                                                        continuing {
                                                            phi_8563_ = _e1601;
                                                            phi_16541_ = _e1576;
                                                            phi_12551_ = select(true, false, _e1607);
                                                            break if !(_e2203);
                                                        }
                                                    }
                                                    let _e2207 = phi_16541_;
                                                    let _e2209 = phi_12551_;
                                                    phi_16601_ = _e2207;
                                                    phi_12552_ = bool();
                                                    if _e2207 {
                                                        break;
                                                    }
                                                    phi_16603_ = _e2207;
                                                    phi_9252_ = _e1580;
                                                    phi_9253_ = _e2209;
                                                }
                                                let _e2446 = phi_16603_;
                                                let _e2448 = phi_9252_;
                                                let _e2450 = phi_9253_;
                                                if _e2450 {
                                                    let _e2451 = (_e2448 == 0u);
                                                    if _e2451 {
                                                        phi_9269_ = u32();
                                                        phi_9270_ = u32();
                                                    } else {
                                                        let _e2452 = (_e2448 - 1u);
                                                        if (_e2452 < 64u) {
                                                        } else {
                                                            phi_16601_ = true;
                                                            phi_12552_ = bool();
                                                            break;
                                                        }
                                                        let _e2455 = local_6[_e2452];
                                                        phi_9269_ = _e2455;
                                                        phi_9270_ = _e2452;
                                                    }
                                                    let _e2457 = phi_9269_;
                                                    let _e2459 = phi_9270_;
                                                    phi_8136_ = _e2457;
                                                    phi_8139_ = _e2459;
                                                    phi_9272_ = select(true, false, _e2451);
                                                    phi_9273_ = _e2451;
                                                } else {
                                                    phi_8136_ = u32();
                                                    phi_8139_ = u32();
                                                    phi_9272_ = false;
                                                    phi_9273_ = false;
                                                }
                                                let _e2462 = phi_8136_;
                                                let _e2464 = phi_8139_;
                                                let _e2466 = phi_9272_;
                                                let _e2468 = phi_9273_;
                                                continue;
                                                continuing {
                                                    phi_16545_ = _e2446;
                                                    phi_8135_ = _e2462;
                                                    phi_8138_ = _e2464;
                                                    phi_16601_ = _e2446;
                                                    phi_12552_ = _e2468;
                                                    break if !(_e2466);
                                                }
                                            }
                                            let _e2471 = phi_16601_;
                                            let _e2473 = phi_12552_;
                                            phi_16801_ = _e2471;
                                            if _e2471 {
                                                break;
                                            }
                                            let _e2475 = select(false, true, select(true, false, _e2473));
                                            if _e2475 {
                                                phi_9289_ = vec3<f32>();
                                            } else {
                                                phi_9289_ = vec3<f32>((_e321.member_6[0] * _e1455), (_e321.member_6[1] * _e1455), (_e321.member_6[2] * _e1455));
                                            }
                                            let _e2481 = phi_9289_;
                                            phi_16813_ = _e2471;
                                            phi_9290_ = _e2481;
                                            phi_9291_ = _e2475;
                                        } else {
                                            phi_16813_ = _e313;
                                            phi_9290_ = vec3<f32>();
                                            phi_9291_ = true;
                                        }
                                        let _e2483 = phi_16813_;
                                        let _e2485 = phi_9290_;
                                        let _e2487 = phi_9291_;
                                        phi_16806_ = _e2483;
                                        phi_10751_ = select(_e2485, vec3<f32>(0f, 0f, 0f), vec3(_e2487));
                                        phi_10752_ = vec3<f32>();
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
                                            phi_9365_ = (_e376 * (_e399 * _e399));
                                        } else {
                                            phi_9365_ = _e376;
                                        }
                                        let _e403 = phi_9365_;
                                        if (_e403 > 0f) {
                                            if (_e369 < 0f) {
                                                phi_9386_ = -(_e207);
                                            } else {
                                                phi_9386_ = _e207;
                                            }
                                            let _e408 = phi_9386_;
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
                                                phi_9415_ = (_e418 > _e420);
                                            } else {
                                                phi_9415_ = (_e419 > _e420);
                                            }
                                            let _e425 = phi_9415_;
                                            let _e426 = select(1u, 0u, _e421);
                                            if _e425 {
                                                let _e427 = (_e426 + 1u);
                                                phi_9425_ = _e427;
                                                phi_9428_ = select(true, false, (_e427 == 2u));
                                            } else {
                                                phi_9425_ = u32();
                                                phi_9428_ = false;
                                            }
                                            let _e431 = phi_9425_;
                                            let _e433 = phi_9428_;
                                            let _e434 = select(true, false, _e425);
                                            let _e435 = select(_e431, 0u, _e434);
                                            let _e437 = select(_e433, true, _e434);
                                            if _e437 {
                                                phi_9439_ = (_e435 + 1u);
                                            } else {
                                                phi_9439_ = 0u;
                                            }
                                            let _e440 = phi_9439_;
                                            let _e441 = select(_e431, _e435, _e437);
                                            let _e442 = select(_e426, select(_e426, 2u, _e434), _e437);
                                            local_4 = array<f32, 3>(_e415, _e416, _e417);
                                            local_5 = array<f32, 3>(_e412, _e413, _e414);
                                            let _e445 = (_e442 < 3u);
                                            if _e445 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e447 = local_4[_e442];
                                            let _e448 = (1f / _e447);
                                            let _e449 = (_e441 < 3u);
                                            if _e449 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e451 = local_4[_e441];
                                            let _e452 = (_e451 * _e448);
                                            let _e453 = (_e440 < 3u);
                                            if _e453 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e455 = local_4[_e440];
                                            let _e456 = (_e455 * _e448);
                                            if _e449 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e458 = local_5[_e441];
                                            if _e453 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e460 = local_5[_e440];
                                            if _e445 {
                                            } else {
                                                phi_16801_ = true;
                                                break;
                                            }
                                            let _e462 = local_5[_e442];
                                            if (0u < _e138) {
                                            } else {
                                                phi_16801_ = true;
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
                                                phi_9569_ = (1f / _e415);
                                            } else {
                                                phi_9569_ = (1000000000000f / _e503);
                                            }
                                            let _e515 = phi_9569_;
                                            if (_e419 > _e504) {
                                                phi_9577_ = (1f / _e416);
                                            } else {
                                                phi_9577_ = (1000000000000f / _e503);
                                            }
                                            let _e520 = phi_9577_;
                                            if (_e420 > _e504) {
                                                phi_9585_ = (1f / _e417);
                                            } else {
                                                phi_9585_ = (1000000000000f / _e503);
                                            }
                                            let _e525 = phi_9585_;
                                            local_3 = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                                            phi_16419_ = _e313;
                                            phi_9588_ = 0u;
                                            phi_9591_ = 0u;
                                            loop {
                                                let _e527 = phi_16419_;
                                                let _e529 = phi_9588_;
                                                let _e531 = phi_9591_;
                                                let _e532 = (_e529 & 15u);
                                                let _e534 = (_e529 >> bitcast<u32>(4u));
                                                if (_e532 == 0u) {
                                                    if (_e534 < _e138) {
                                                    } else {
                                                        phi_16481_ = true;
                                                        phi_12550_ = bool();
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
                                                            phi_16481_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e531] = _e1371;
                                                        phi_9976_ = (_e531 + 1u);
                                                    } else {
                                                        phi_9976_ = _e531;
                                                    }
                                                    let _e1377 = phi_9976_;
                                                    if (select(340282350000000000000000000000000000000f, _e1297, (_e1297 <= select(0.9999995f, _e1337, (_e1337 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1377 < 64u) {
                                                        } else {
                                                            phi_16481_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e1377] = _e1367;
                                                        phi_9988_ = (_e1377 + 1u);
                                                    } else {
                                                        phi_9988_ = _e1377;
                                                    }
                                                    let _e1383 = phi_9988_;
                                                    if (select(340282350000000000000000000000000000000f, _e1295, (_e1295 <= select(0.9999995f, _e1335, (_e1335 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1383 < 64u) {
                                                        } else {
                                                            phi_16481_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e1383] = _e1363;
                                                        phi_10000_ = (_e1383 + 1u);
                                                    } else {
                                                        phi_10000_ = _e1383;
                                                    }
                                                    let _e1389 = phi_10000_;
                                                    if (select(340282350000000000000000000000000000000f, _e1293, (_e1293 <= select(0.9999995f, _e1333, (_e1333 < 0.9999995f)))) < 340282350000000000000000000000000000000f) {
                                                        if (_e1389 < 64u) {
                                                        } else {
                                                            phi_16481_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        local_3[_e1389] = _e1359;
                                                        phi_10012_ = (_e1389 + 1u);
                                                    } else {
                                                        phi_10012_ = _e1389;
                                                    }
                                                    let _e1395 = phi_10012_;
                                                    phi_16483_ = _e527;
                                                    phi_10705_ = _e1395;
                                                    phi_10706_ = true;
                                                } else {
                                                    phi_10016_ = type_9(_e534, (_e534 + _e532));
                                                    loop {
                                                        let _e539 = phi_10016_;
                                                        if (_e539.member < _e539.member_1) {
                                                            phi_10017_ = type_9((_e539.member + 1u), _e539.member_1);
                                                            phi_10040_ = type_9(1u, _e539.member);
                                                        } else {
                                                            phi_10017_ = _e539;
                                                            phi_10040_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e552 = phi_10017_;
                                                        let _e554 = phi_10040_;
                                                        let _e558 = (bitcast<i32>(_e554.member) != 0i);
                                                        if _e558 {
                                                            let _e559 = (_e554.member_1 < _e141);
                                                            if _e559 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            if _e445 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e563 = triangles.member[_e554.member_1].member[_e442];
                                                            let _e564 = (_e563 - _e462);
                                                            if _e445 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e568 = triangles.member[_e554.member_1].member_2[_e442];
                                                            let _e569 = (_e568 - _e462);
                                                            if _e445 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e573 = triangles.member[_e554.member_1].member_4[_e442];
                                                            let _e574 = (_e573 - _e462);
                                                            if _e449 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e578 = triangles.member[_e554.member_1].member[_e441];
                                                            let _e581 = ((_e578 - _e458) - (_e452 * _e564));
                                                            if _e453 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e585 = triangles.member[_e554.member_1].member[_e440];
                                                            let _e588 = ((_e585 - _e460) - (_e456 * _e564));
                                                            if _e449 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e592 = triangles.member[_e554.member_1].member_2[_e441];
                                                            let _e595 = ((_e592 - _e458) - (_e452 * _e569));
                                                            if _e453 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e599 = triangles.member[_e554.member_1].member_2[_e440];
                                                            let _e602 = ((_e599 - _e460) - (_e456 * _e569));
                                                            if _e449 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e606 = triangles.member[_e554.member_1].member_4[_e441];
                                                            let _e609 = ((_e606 - _e458) - (_e452 * _e574));
                                                            if _e453 {
                                                            } else {
                                                                phi_16415_ = true;
                                                                phi_12549_ = bool();
                                                                break;
                                                            }
                                                            let _e613 = triangles.member[_e554.member_1].member_4[_e440];
                                                            let _e616 = ((_e613 - _e460) - (_e456 * _e574));
                                                            let _e617 = (_e609 * _e602);
                                                            let _e618 = (_e616 * _e595);
                                                            if (_e617 != _e618) {
                                                                phi_10156_ = (_e617 - _e618);
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
                                                                phi_10156_ = ((((((_e622 * _e625) - _e617) + (_e622 * _e627)) + (_e626 * _e625)) + (_e626 * _e627)) - (((((_e638 * _e641) - _e618) + (_e638 * _e643)) + (_e642 * _e641)) + (_e642 * _e643)));
                                                            }
                                                            let _e655 = phi_10156_;
                                                            let _e656 = (_e581 * _e616);
                                                            let _e657 = (_e588 * _e609);
                                                            if (_e656 != _e657) {
                                                                phi_10167_ = (_e656 - _e657);
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
                                                                phi_10167_ = ((((((_e661 * _e664) - _e656) + (_e661 * _e666)) + (_e665 * _e664)) + (_e665 * _e666)) - (((((_e677 * _e680) - _e657) + (_e677 * _e682)) + (_e681 * _e680)) + (_e681 * _e682)));
                                                            }
                                                            let _e694 = phi_10167_;
                                                            let _e695 = (_e595 * _e588);
                                                            let _e696 = (_e602 * _e581);
                                                            if (_e695 != _e696) {
                                                                phi_10178_ = (_e695 - _e696);
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
                                                                phi_10178_ = ((((((_e700 * _e703) - _e695) + (_e700 * _e705)) + (_e704 * _e703)) + (_e704 * _e705)) - (((((_e716 * _e719) - _e696) + (_e716 * _e721)) + (_e720 * _e719)) + (_e720 * _e721)));
                                                            }
                                                            let _e733 = phi_10178_;
                                                            if (_e655 < 0f) {
                                                                phi_10196_ = f32();
                                                                phi_10197_ = true;
                                                            } else {
                                                                if (_e694 < 0f) {
                                                                    phi_10194_ = f32();
                                                                    phi_10195_ = true;
                                                                } else {
                                                                    let _e736 = (_e733 < 0f);
                                                                    if _e736 {
                                                                        phi_10193_ = f32();
                                                                    } else {
                                                                        phi_10193_ = ((_e655 + _e694) + _e733);
                                                                    }
                                                                    let _e740 = phi_10193_;
                                                                    phi_10194_ = _e740;
                                                                    phi_10195_ = _e736;
                                                                }
                                                                let _e742 = phi_10194_;
                                                                let _e744 = phi_10195_;
                                                                phi_10196_ = _e742;
                                                                phi_10197_ = _e744;
                                                            }
                                                            let _e746 = phi_10196_;
                                                            let _e748 = phi_10197_;
                                                            if _e748 {
                                                                if (_e655 > 0f) {
                                                                    phi_10218_ = f32();
                                                                    phi_10219_ = true;
                                                                    phi_10220_ = false;
                                                                } else {
                                                                    let _e750 = (_e694 > 0f);
                                                                    if _e750 {
                                                                        phi_10216_ = f32();
                                                                        phi_10217_ = false;
                                                                    } else {
                                                                        phi_10216_ = ((_e655 + _e694) + _e733);
                                                                        phi_10217_ = select(true, false, (_e733 > 0f));
                                                                    }
                                                                    let _e756 = phi_10216_;
                                                                    let _e758 = phi_10217_;
                                                                    phi_10218_ = _e756;
                                                                    phi_10219_ = _e750;
                                                                    phi_10220_ = _e758;
                                                                }
                                                                let _e760 = phi_10218_;
                                                                let _e762 = phi_10219_;
                                                                let _e764 = phi_10220_;
                                                                phi_10225_ = _e760;
                                                                phi_10226_ = select(_e764, false, _e762);
                                                            } else {
                                                                phi_10225_ = _e746;
                                                                phi_10226_ = true;
                                                            }
                                                            let _e767 = phi_10225_;
                                                            let _e769 = phi_10226_;
                                                            if _e769 {
                                                                let _e770 = (_e767 == 0f);
                                                                if _e770 {
                                                                    phi_10314_ = array<f32, 3>();
                                                                    phi_10315_ = array<f32, 3>();
                                                                    phi_10316_ = false;
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
                                                                        phi_10312_ = array<f32, 3>(_e784, _e777, _e778);
                                                                        phi_10313_ = array<f32, 3>();
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
                                                                        phi_10312_ = array<f32, 3>();
                                                                        phi_10313_ = array<f32, 3>(((((_e846 * _e895) * _e771) + (_e896 * _e772)) + (_e897 * _e773)), _e896, _e897);
                                                                    }
                                                                    let _e907 = phi_10312_;
                                                                    let _e909 = phi_10313_;
                                                                    phi_10314_ = _e907;
                                                                    phi_10315_ = _e909;
                                                                    phi_10316_ = _e811;
                                                                }
                                                                let _e911 = phi_10314_;
                                                                let _e913 = phi_10315_;
                                                                let _e915 = phi_10316_;
                                                                phi_10317_ = _e911;
                                                                phi_10318_ = _e913;
                                                                phi_10319_ = _e770;
                                                                phi_10320_ = _e915;
                                                            } else {
                                                                phi_10317_ = array<f32, 3>();
                                                                phi_10318_ = array<f32, 3>();
                                                                phi_10319_ = true;
                                                                phi_10320_ = false;
                                                            }
                                                            let _e917 = phi_10317_;
                                                            let _e919 = phi_10318_;
                                                            let _e921 = phi_10319_;
                                                            let _e923 = phi_10320_;
                                                            if _e921 {
                                                                phi_10325_ = array<f32, 3>(-1f, 0f, 0f);
                                                            } else {
                                                                phi_10325_ = _e917;
                                                            }
                                                            let _e925 = phi_10325_;
                                                            if select(_e923, true, _e921) {
                                                                phi_10330_ = _e925;
                                                            } else {
                                                                phi_10330_ = _e919;
                                                            }
                                                            let _e928 = phi_10330_;
                                                            let _e932 = (_e928[0] >= 0f);
                                                            if _e932 {
                                                                let _e933 = (_e928[0] < 0.9999995f);
                                                                if _e933 {
                                                                    if _e932 {
                                                                        if _e559 {
                                                                        } else {
                                                                            phi_16415_ = true;
                                                                            phi_12549_ = bool();
                                                                            break;
                                                                        }
                                                                        let _e936 = triangles.member[_e554.member_1].member_3;
                                                                        if ((_e936 & 1u) == 0u) {
                                                                            phi_10663_ = true;
                                                                        } else {
                                                                            if _e559 {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e941 = triangles.member[_e554.member_1].member_1;
                                                                            let _e942 = (_e941 * 12u);
                                                                            if ((256u + _e942) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 257u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 258u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e949 = (_e942 + 259u);
                                                                            if (_e949 < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e952 = surfaces.member[_e949];
                                                                            if ((_e942 + 260u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 261u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 262u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e959 = (_e942 + 263u);
                                                                            if (_e959 < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e962 = surfaces.member[_e959];
                                                                            let _e963 = (_e942 + 264u);
                                                                            if (_e963 < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e966 = surfaces.member[_e963];
                                                                            let _e967 = bitcast<f32>(_e966);
                                                                            let _e968 = (_e942 + 265u);
                                                                            if (_e968 < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            let _e971 = surfaces.member[_e968];
                                                                            let _e972 = bitcast<f32>(_e971);
                                                                            if ((_e942 + 266u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            if ((_e942 + 267u) < _e147) {
                                                                            } else {
                                                                                phi_16415_ = true;
                                                                                phi_12549_ = bool();
                                                                                break;
                                                                            }
                                                                            if (_e952 == 4294967295u) {
                                                                                phi_10658_ = (_e967 < _e972);
                                                                            } else {
                                                                                if (_e554.member_1 < _e144) {
                                                                                } else {
                                                                                    phi_16415_ = true;
                                                                                    phi_12549_ = bool();
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
                                                                                    phi_10541_ = _e1027;
                                                                                } else {
                                                                                    let _e1033 = select(select(u32(_e1025), 0u, (_e1025 < 0f)), 4294967295u, (_e1025 > 4294967000f));
                                                                                    phi_10541_ = select(_e1033, _e1027, (_e1027 < _e1033));
                                                                                }
                                                                                let _e1037 = phi_10541_;
                                                                                if (_e1037 == _e1027) {
                                                                                    phi_10547_ = 0u;
                                                                                } else {
                                                                                    phi_10547_ = (_e1037 + 1u);
                                                                                }
                                                                                let _e1041 = phi_10547_;
                                                                                let _e1043 = (_e1014 - floor(_e1014));
                                                                                let _e1048 = ((select(0f, _e1043, (_e1043 <= 1f)) * f32(_e1017)) - 0.5f);
                                                                                let _e1049 = floor(_e1048);
                                                                                let _e1050 = (_e1048 - _e1049);
                                                                                let _e1051 = (_e1017 - 1u);
                                                                                if (_e1049 < 0f) {
                                                                                    phi_10577_ = _e1051;
                                                                                } else {
                                                                                    let _e1057 = select(select(u32(_e1049), 0u, (_e1049 < 0f)), 4294967295u, (_e1049 > 4294967000f));
                                                                                    phi_10577_ = select(_e1057, _e1051, (_e1051 < _e1057));
                                                                                }
                                                                                let _e1061 = phi_10577_;
                                                                                if (_e1061 == _e1051) {
                                                                                    phi_10583_ = 0u;
                                                                                } else {
                                                                                    phi_10583_ = (_e1061 + 1u);
                                                                                }
                                                                                let _e1065 = phi_10583_;
                                                                                let _e1067 = (_e952 + (_e1061 * _e1015));
                                                                                let _e1069 = (_e952 + (_e1065 * _e1015));
                                                                                let _e1070 = (_e1067 + _e1037);
                                                                                let _e1071 = (_e1067 + _e1041);
                                                                                let _e1072 = (_e1069 + _e1037);
                                                                                let _e1073 = (_e1069 + _e1041);
                                                                                if (_e1070 < _e147) {
                                                                                } else {
                                                                                    phi_16415_ = true;
                                                                                    phi_12549_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1076 = surfaces.member[_e1070];
                                                                                if (_e1071 < _e147) {
                                                                                } else {
                                                                                    phi_16415_ = true;
                                                                                    phi_12549_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1079 = surfaces.member[_e1071];
                                                                                if (_e1072 < _e147) {
                                                                                } else {
                                                                                    phi_16415_ = true;
                                                                                    phi_12549_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1082 = surfaces.member[_e1072];
                                                                                if (_e1073 < _e147) {
                                                                                } else {
                                                                                    phi_16415_ = true;
                                                                                    phi_12549_ = bool();
                                                                                    break;
                                                                                }
                                                                                let _e1085 = surfaces.member[_e1073];
                                                                                let _e1102 = (1f - _e1026);
                                                                                phi_10658_ = ((_e967 * (((((f32((_e1076 >> bitcast<u32>(24i))) * 0.003921569f) * _e1102) + ((f32((_e1079 >> bitcast<u32>(24i))) * 0.003921569f) * _e1026)) * (1f - _e1050)) + ((((f32((_e1082 >> bitcast<u32>(24i))) * 0.003921569f) * _e1102) + ((f32((_e1085 >> bitcast<u32>(24i))) * 0.003921569f) * _e1026)) * _e1050))) < _e972);
                                                                            }
                                                                            let _e1117 = phi_10658_;
                                                                            phi_10663_ = select(true, false, _e1117);
                                                                        }
                                                                        let _e1120 = phi_10663_;
                                                                        if _e1120 {
                                                                            phi_10668_ = type_47(_e928[0], _e554.member_1, _e928[1], _e928[2]);
                                                                        } else {
                                                                            phi_10668_ = type_47();
                                                                        }
                                                                        let _e1123 = phi_10668_;
                                                                        phi_10670_ = _e1123;
                                                                        phi_10672_ = select(true, false, _e1120);
                                                                    } else {
                                                                        phi_10670_ = type_47();
                                                                        phi_10672_ = false;
                                                                    }
                                                                    let _e1126 = phi_10670_;
                                                                    let _e1128 = phi_10672_;
                                                                    phi_10673_ = _e1126;
                                                                    phi_10675_ = select(true, false, _e932);
                                                                    phi_10676_ = _e1128;
                                                                } else {
                                                                    phi_10673_ = type_47();
                                                                    phi_10675_ = false;
                                                                    phi_10676_ = false;
                                                                }
                                                                let _e1131 = phi_10673_;
                                                                let _e1133 = phi_10675_;
                                                                let _e1135 = phi_10676_;
                                                                phi_10677_ = _e1131;
                                                                phi_10678_ = select(true, false, _e933);
                                                                phi_10679_ = _e1133;
                                                                phi_10680_ = _e1135;
                                                            } else {
                                                                phi_10677_ = type_47();
                                                                phi_10678_ = true;
                                                                phi_10679_ = false;
                                                                phi_10680_ = false;
                                                            }
                                                            let _e1138 = phi_10677_;
                                                            let _e1140 = phi_10678_;
                                                            let _e1142 = phi_10679_;
                                                            let _e1144 = phi_10680_;
                                                            if select(select(_e1144, false, _e1140), true, select(_e1142, true, _e1140)) {
                                                                phi_10693_ = type_47(0.9999995f, 4294967295u, 0f, 0f);
                                                            } else {
                                                                phi_10693_ = _e1138;
                                                            }
                                                            let _e1149 = phi_10693_;
                                                            phi_10700_ = select(true, false, (_e1149.member_1 != 4294967295u));
                                                        } else {
                                                            phi_10700_ = false;
                                                        }
                                                        let _e1154 = phi_10700_;
                                                        continue;
                                                        continuing {
                                                            phi_10016_ = _e552;
                                                            phi_16415_ = _e527;
                                                            phi_12549_ = select(true, false, _e558);
                                                            break if !(_e1154);
                                                        }
                                                    }
                                                    let _e1158 = phi_16415_;
                                                    let _e1160 = phi_12549_;
                                                    phi_16481_ = _e1158;
                                                    phi_12550_ = bool();
                                                    if _e1158 {
                                                        break;
                                                    }
                                                    phi_16483_ = _e1158;
                                                    phi_10705_ = _e531;
                                                    phi_10706_ = _e1160;
                                                }
                                                let _e1397 = phi_16483_;
                                                let _e1399 = phi_10705_;
                                                let _e1401 = phi_10706_;
                                                if _e1401 {
                                                    let _e1402 = (_e1399 == 0u);
                                                    if _e1402 {
                                                        phi_10722_ = u32();
                                                        phi_10723_ = u32();
                                                    } else {
                                                        let _e1403 = (_e1399 - 1u);
                                                        if (_e1403 < 64u) {
                                                        } else {
                                                            phi_16481_ = true;
                                                            phi_12550_ = bool();
                                                            break;
                                                        }
                                                        let _e1406 = local_3[_e1403];
                                                        phi_10722_ = _e1406;
                                                        phi_10723_ = _e1403;
                                                    }
                                                    let _e1408 = phi_10722_;
                                                    let _e1410 = phi_10723_;
                                                    phi_9589_ = _e1408;
                                                    phi_9592_ = _e1410;
                                                    phi_10725_ = select(true, false, _e1402);
                                                    phi_10726_ = _e1402;
                                                } else {
                                                    phi_9589_ = u32();
                                                    phi_9592_ = u32();
                                                    phi_10725_ = false;
                                                    phi_10726_ = false;
                                                }
                                                let _e1413 = phi_9589_;
                                                let _e1415 = phi_9592_;
                                                let _e1417 = phi_10725_;
                                                let _e1419 = phi_10726_;
                                                continue;
                                                continuing {
                                                    phi_16419_ = _e1397;
                                                    phi_9588_ = _e1413;
                                                    phi_9591_ = _e1415;
                                                    phi_16481_ = _e1397;
                                                    phi_12550_ = _e1419;
                                                    break if !(_e1417);
                                                }
                                            }
                                            let _e1422 = phi_16481_;
                                            let _e1424 = phi_12550_;
                                            phi_16801_ = _e1422;
                                            if _e1422 {
                                                break;
                                            }
                                            let _e1427 = !(select(false, true, select(true, false, _e1424)));
                                            if _e1427 {
                                                phi_10743_ = vec3<f32>((_e321.member_6[0] * _e403), (_e321.member_6[1] * _e403), (_e321.member_6[2] * _e403));
                                            } else {
                                                phi_10743_ = vec3<f32>();
                                            }
                                            let _e1433 = phi_10743_;
                                            phi_16808_ = _e1422;
                                            phi_10745_ = _e1433;
                                            phi_10746_ = select(true, false, _e1427);
                                        } else {
                                            phi_16808_ = _e313;
                                            phi_10745_ = vec3<f32>();
                                            phi_10746_ = true;
                                        }
                                        let _e1436 = phi_16808_;
                                        let _e1438 = phi_10745_;
                                        let _e1440 = phi_10746_;
                                        phi_16806_ = _e1436;
                                        phi_10751_ = vec3<f32>();
                                        phi_10752_ = select(_e1438, vec3<f32>(0f, 0f, 0f), vec3(_e1440));
                                    }
                                    let _e2491 = phi_16806_;
                                    let _e2493 = phi_10751_;
                                    let _e2495 = phi_10752_;
                                    phi_16805_ = _e2491;
                                    phi_10753_ = _e2493;
                                    phi_10754_ = _e2495;
                                    phi_10755_ = _e352;
                                }
                                let _e3761 = phi_16805_;
                                let _e3763 = phi_10753_;
                                let _e3765 = phi_10754_;
                                let _e3767 = phi_10755_;
                                let _e3769 = select(_e3765, _e3763, vec3(_e3767));
                                phi_16803_ = _e3761;
                                phi_10775_ = vec3<f32>((_e265.x + (_e3769.x * _e325)), (_e265.y + (_e3769.y * _e325)), (_e265.z + (_e3769.z * _e325)));
                            } else {
                                phi_16803_ = _e313;
                                phi_10775_ = _e265;
                            }
                            let _e3784 = phi_16803_;
                            let _e3786 = phi_10775_;
                            phi_16802_ = _e3784;
                            phi_6102_ = _e3786;
                        } else {
                            phi_16802_ = _e261;
                            phi_6102_ = vec3<f32>();
                        }
                        let _e3788 = phi_16802_;
                        let _e3790 = phi_6102_;
                        continue;
                        continuing {
                            phi_16408_ = _e3788;
                            phi_6098_ = _e278;
                            phi_6101_ = _e3790;
                            phi_16801_ = _e3788;
                            break if !(_e284);
                        }
                    }
                    let _e3793 = phi_16801_;
                    if _e3793 {
                        break;
                    }
                    phi_17428_ = _e3793;
                    let _e10066 = local_32;
                    phi_10776_ = _e10066;
                }
                let _e8090 = phi_17428_;
                let _e8092 = phi_10776_;
                let _e8096 = params.member.member_16[2u];
                if (_e8096 > 0u) {
                    let _e8100 = params.member.member_15;
                    let _e8107 = ((_e242 ^ (_e242 >> bitcast<u32>(16i))) * 2146121005u);
                    let _e8111 = ((_e8107 ^ (_e8107 >> bitcast<u32>(15i))) * 2221713035u);
                    let _e8114 = (_e8111 ^ (_e8111 >> bitcast<u32>(16i)));
                    let _e8119 = bitcast<f32>((1065353216u | (bitcast<u32>(_e185.z) & 2147483648u)));
                    let _e8121 = (-1f / (_e8119 + _e185.z));
                    let _e8125 = ((_e185.x * _e185.y) * _e8121);
                    phi_17427_ = _e8090;
                    phi_10833_ = type_9(0u, _e8096);
                    phi_10836_ = 0i;
                    loop {
                        let _e8139 = phi_17427_;
                        let _e8141 = phi_10833_;
                        let _e8143 = phi_10836_;
                        local_30 = _e8143;
                        if (_e8141.member < _e8141.member_1) {
                            phi_10834_ = type_9((_e8141.member + 1u), _e8141.member_1);
                            phi_10859_ = type_9(1u, _e8141.member);
                        } else {
                            phi_10834_ = _e8141;
                            phi_10859_ = type_9(0u, type_9().member_1);
                        }
                        let _e8156 = phi_10834_;
                        let _e8158 = phi_10859_;
                        let _e8162 = (bitcast<i32>(_e8158.member) != 0i);
                        if _e8162 {
                            let _e8166 = ((_e8114 ^ (_e8114 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e8170 = ((_e8166 ^ (_e8166 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e8177 = (_e8114 ^ 2654435769u);
                            let _e8181 = ((_e8177 ^ (_e8177 >> bitcast<u32>(16i))) * 2146121005u);
                            let _e8185 = ((_e8181 ^ (_e8181 >> bitcast<u32>(15i))) * 2221713035u);
                            let _e8203 = (0.000000059604645f * (f32(((2147483648u + (_e8158.member_1 * 3242174889u)) >> bitcast<u32>(8i))) + f32(((_e8170 ^ (_e8170 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                            if (_e8203 >= 1f) {
                                phi_16152_ = (_e8203 - 1f);
                            } else {
                                phi_16152_ = _e8203;
                            }
                            let _e8207 = phi_16152_;
                            let _e8209 = (0.000000059604645f * (f32(((2147483648u + (_e8158.member_1 * 2447445414u)) >> bitcast<u32>(8i))) + f32(((_e8185 ^ (_e8185 >> bitcast<u32>(16i))) >> bitcast<u32>(8i)))));
                            if (_e8209 >= 1f) {
                                phi_16160_ = (_e8209 - 1f);
                            } else {
                                phi_16160_ = _e8209;
                            }
                            let _e8213 = phi_16160_;
                            let _e8215 = ((2f * _e8207) - 1f);
                            let _e8217 = ((2f * _e8213) - 1f);
                            if (_e8215 == 0f) {
                                let _e8219 = (_e8217 == 0f);
                                phi_10923_ = select(vec2<f32>(), vec2<f32>(0f, 0f), vec2(_e8219));
                                phi_10924_ = select(true, false, _e8219);
                            } else {
                                phi_10923_ = vec2<f32>();
                                phi_10924_ = true;
                            }
                            let _e8224 = phi_10923_;
                            let _e8226 = phi_10924_;
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
                                        phi_10988_ = _e8320;
                                    } else {
                                        phi_10988_ = -(_e8320);
                                    }
                                    let _e8326 = phi_10988_;
                                    if (((_e8317 + 1i) & 2i) == 0i) {
                                        phi_10996_ = _e8321;
                                    } else {
                                        phi_10996_ = -(_e8321);
                                    }
                                    let _e8332 = phi_10996_;
                                    phi_11066_ = vec2<f32>((_e8215 * _e8332), (_e8215 * _e8326));
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
                                        phi_11054_ = _e8267;
                                    } else {
                                        phi_11054_ = -(_e8267);
                                    }
                                    let _e8273 = phi_11054_;
                                    if (((_e8264 + 1i) & 2i) == 0i) {
                                        phi_11062_ = _e8268;
                                    } else {
                                        phi_11062_ = -(_e8268);
                                    }
                                    let _e8279 = phi_11062_;
                                    phi_11066_ = vec2<f32>((_e8217 * _e8273), (_e8217 * _e8279));
                                }
                                let _e8337 = phi_11066_;
                                phi_11067_ = _e8337;
                            } else {
                                phi_11067_ = _e8224;
                            }
                            let _e8339 = phi_11067_;
                            let _e8345 = (1f - ((_e8339.x * _e8339.x) + (_e8339.y * _e8339.y)));
                            let _e8348 = sqrt(select(0f, _e8345, (_e8345 > 0f)));
                            let _e8361 = ((((1f + (((_e8119 * _e185.x) * _e185.x) * _e8121)) * _e8339.x) + (_e8125 * _e8339.y)) + (_e185.x * _e8348));
                            let _e8362 = ((((_e8119 * _e8125) * _e8339.x) + ((_e8119 + ((_e185.y * _e185.y) * _e8121)) * _e8339.y)) + (_e185.y * _e8348));
                            let _e8363 = ((((-(_e8119) * _e185.x) * _e8339.x) + (-(_e185.y) * _e8339.y)) + (_e185.z * _e8348));
                            if ((((_e185.x * _e8361) + (_e185.y * _e8362)) + (_e185.z * _e8363)) < 0f) {
                                phi_11111_ = -(_e207);
                            } else {
                                phi_11111_ = _e207;
                            }
                            let _e8372 = phi_11111_;
                            let _e8376 = (_e163.member[0] + (_e185.x * _e8372));
                            let _e8377 = (_e163.member[1] + (_e185.y * _e8372));
                            let _e8378 = (_e163.member[2] + (_e185.z * _e8372));
                            let _e8379 = abs(_e8361);
                            let _e8380 = abs(_e8362);
                            let _e8381 = abs(_e8363);
                            let _e8382 = (_e8379 > _e8380);
                            if _e8382 {
                                phi_11137_ = (_e8379 > _e8381);
                            } else {
                                phi_11137_ = (_e8380 > _e8381);
                            }
                            let _e8386 = phi_11137_;
                            let _e8387 = select(1u, 0u, _e8382);
                            if _e8386 {
                                let _e8388 = (_e8387 + 1u);
                                phi_11147_ = _e8388;
                                phi_11150_ = select(true, false, (_e8388 == 2u));
                            } else {
                                phi_11147_ = u32();
                                phi_11150_ = false;
                            }
                            let _e8392 = phi_11147_;
                            let _e8394 = phi_11150_;
                            let _e8395 = select(true, false, _e8386);
                            let _e8396 = select(_e8392, 0u, _e8395);
                            let _e8398 = select(_e8394, true, _e8395);
                            if _e8398 {
                                phi_11161_ = (_e8396 + 1u);
                            } else {
                                phi_11161_ = 0u;
                            }
                            let _e8401 = phi_11161_;
                            let _e8402 = select(_e8392, _e8396, _e8398);
                            let _e8403 = select(_e8387, select(_e8387, 2u, _e8395), _e8398);
                            local_1 = array<f32, 3>(_e8361, _e8362, _e8363);
                            local_2 = array<f32, 3>(_e8376, _e8377, _e8378);
                            let _e8406 = (_e8403 < 3u);
                            if _e8406 {
                            } else {
                                phi_17539_ = true;
                                break;
                            }
                            let _e8408 = local_1[_e8403];
                            let _e8409 = (1f / _e8408);
                            let _e8410 = (_e8402 < 3u);
                            if _e8410 {
                            } else {
                                phi_17539_ = true;
                                break;
                            }
                            let _e8412 = local_1[_e8402];
                            let _e8413 = (_e8412 * _e8409);
                            let _e8414 = (_e8401 < 3u);
                            if _e8414 {
                            } else {
                                phi_17539_ = true;
                                break;
                            }
                            let _e8416 = local_1[_e8401];
                            let _e8417 = (_e8416 * _e8409);
                            if _e8410 {
                            } else {
                                phi_17539_ = true;
                                break;
                            }
                            let _e8419 = local_2[_e8402];
                            if _e8414 {
                            } else {
                                phi_17539_ = true;
                                break;
                            }
                            let _e8421 = local_2[_e8401];
                            if _e8406 {
                            } else {
                                phi_17539_ = true;
                                break;
                            }
                            let _e8423 = local_2[_e8403];
                            if (0u < _e138) {
                            } else {
                                phi_17539_ = true;
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
                                phi_11291_ = (1f / _e8361);
                            } else {
                                phi_11291_ = (1000000000000f / _e8464);
                            }
                            let _e8476 = phi_11291_;
                            if (_e8380 > _e8465) {
                                phi_11299_ = (1f / _e8362);
                            } else {
                                phi_11299_ = (1000000000000f / _e8464);
                            }
                            let _e8481 = phi_11299_;
                            if (_e8381 > _e8465) {
                                phi_11307_ = (1f / _e8363);
                            } else {
                                phi_11307_ = (1000000000000f / _e8464);
                            }
                            let _e8486 = phi_11307_;
                            local = array<u32, 64>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                            phi_17408_ = _e8139;
                            phi_11310_ = 0u;
                            phi_11313_ = 0u;
                            loop {
                                let _e8488 = phi_17408_;
                                let _e8490 = phi_11310_;
                                let _e8492 = phi_11313_;
                                let _e8493 = (_e8490 & 15u);
                                let _e8495 = (_e8490 >> bitcast<u32>(4u));
                                if (_e8493 == 0u) {
                                    if (_e8495 < _e138) {
                                    } else {
                                        phi_17479_ = true;
                                        phi_12562_ = bool();
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
                                            phi_17479_ = true;
                                            phi_12562_ = bool();
                                            break;
                                        }
                                        local[_e8492] = _e9332;
                                        phi_11698_ = (_e8492 + 1u);
                                    } else {
                                        phi_11698_ = _e8492;
                                    }
                                    let _e9338 = phi_11698_;
                                    if (select(340282350000000000000000000000000000000f, _e9258, (_e9258 <= select(340282350000000000000000000000000000000f, _e9298, (_e9298 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e9338 < 64u) {
                                        } else {
                                            phi_17479_ = true;
                                            phi_12562_ = bool();
                                            break;
                                        }
                                        local[_e9338] = _e9328;
                                        phi_11710_ = (_e9338 + 1u);
                                    } else {
                                        phi_11710_ = _e9338;
                                    }
                                    let _e9344 = phi_11710_;
                                    if (select(340282350000000000000000000000000000000f, _e9256, (_e9256 <= select(340282350000000000000000000000000000000f, _e9296, (_e9296 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e9344 < 64u) {
                                        } else {
                                            phi_17479_ = true;
                                            phi_12562_ = bool();
                                            break;
                                        }
                                        local[_e9344] = _e9324;
                                        phi_11722_ = (_e9344 + 1u);
                                    } else {
                                        phi_11722_ = _e9344;
                                    }
                                    let _e9350 = phi_11722_;
                                    if (select(340282350000000000000000000000000000000f, _e9254, (_e9254 <= select(340282350000000000000000000000000000000f, _e9294, (_e9294 < 340282350000000000000000000000000000000f)))) < 340282350000000000000000000000000000000f) {
                                        if (_e9350 < 64u) {
                                        } else {
                                            phi_17479_ = true;
                                            phi_12562_ = bool();
                                            break;
                                        }
                                        local[_e9350] = _e9320;
                                        phi_11734_ = (_e9350 + 1u);
                                    } else {
                                        phi_11734_ = _e9350;
                                    }
                                    let _e9356 = phi_11734_;
                                    phi_17481_ = _e8488;
                                    phi_12427_ = _e9356;
                                    phi_12428_ = true;
                                } else {
                                    phi_11738_ = type_9(_e8495, (_e8495 + _e8493));
                                    loop {
                                        let _e8500 = phi_11738_;
                                        if (_e8500.member < _e8500.member_1) {
                                            phi_11739_ = type_9((_e8500.member + 1u), _e8500.member_1);
                                            phi_11762_ = type_9(1u, _e8500.member);
                                        } else {
                                            phi_11739_ = _e8500;
                                            phi_11762_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e8513 = phi_11739_;
                                        let _e8515 = phi_11762_;
                                        let _e8519 = (bitcast<i32>(_e8515.member) != 0i);
                                        if _e8519 {
                                            let _e8520 = (_e8515.member_1 < _e141);
                                            if _e8520 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            if _e8406 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8524 = triangles.member[_e8515.member_1].member[_e8403];
                                            let _e8525 = (_e8524 - _e8423);
                                            if _e8406 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8529 = triangles.member[_e8515.member_1].member_2[_e8403];
                                            let _e8530 = (_e8529 - _e8423);
                                            if _e8406 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8534 = triangles.member[_e8515.member_1].member_4[_e8403];
                                            let _e8535 = (_e8534 - _e8423);
                                            if _e8410 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8539 = triangles.member[_e8515.member_1].member[_e8402];
                                            let _e8542 = ((_e8539 - _e8419) - (_e8413 * _e8525));
                                            if _e8414 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8546 = triangles.member[_e8515.member_1].member[_e8401];
                                            let _e8549 = ((_e8546 - _e8421) - (_e8417 * _e8525));
                                            if _e8410 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8553 = triangles.member[_e8515.member_1].member_2[_e8402];
                                            let _e8556 = ((_e8553 - _e8419) - (_e8413 * _e8530));
                                            if _e8414 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8560 = triangles.member[_e8515.member_1].member_2[_e8401];
                                            let _e8563 = ((_e8560 - _e8421) - (_e8417 * _e8530));
                                            if _e8410 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8567 = triangles.member[_e8515.member_1].member_4[_e8402];
                                            let _e8570 = ((_e8567 - _e8419) - (_e8413 * _e8535));
                                            if _e8414 {
                                            } else {
                                                phi_17404_ = true;
                                                phi_12561_ = bool();
                                                break;
                                            }
                                            let _e8574 = triangles.member[_e8515.member_1].member_4[_e8401];
                                            let _e8577 = ((_e8574 - _e8421) - (_e8417 * _e8535));
                                            let _e8578 = (_e8570 * _e8563);
                                            let _e8579 = (_e8577 * _e8556);
                                            if (_e8578 != _e8579) {
                                                phi_11878_ = (_e8578 - _e8579);
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
                                                phi_11878_ = ((((((_e8583 * _e8586) - _e8578) + (_e8583 * _e8588)) + (_e8587 * _e8586)) + (_e8587 * _e8588)) - (((((_e8599 * _e8602) - _e8579) + (_e8599 * _e8604)) + (_e8603 * _e8602)) + (_e8603 * _e8604)));
                                            }
                                            let _e8616 = phi_11878_;
                                            let _e8617 = (_e8542 * _e8577);
                                            let _e8618 = (_e8549 * _e8570);
                                            if (_e8617 != _e8618) {
                                                phi_11889_ = (_e8617 - _e8618);
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
                                                phi_11889_ = ((((((_e8622 * _e8625) - _e8617) + (_e8622 * _e8627)) + (_e8626 * _e8625)) + (_e8626 * _e8627)) - (((((_e8638 * _e8641) - _e8618) + (_e8638 * _e8643)) + (_e8642 * _e8641)) + (_e8642 * _e8643)));
                                            }
                                            let _e8655 = phi_11889_;
                                            let _e8656 = (_e8556 * _e8549);
                                            let _e8657 = (_e8563 * _e8542);
                                            if (_e8656 != _e8657) {
                                                phi_11900_ = (_e8656 - _e8657);
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
                                                phi_11900_ = ((((((_e8661 * _e8664) - _e8656) + (_e8661 * _e8666)) + (_e8665 * _e8664)) + (_e8665 * _e8666)) - (((((_e8677 * _e8680) - _e8657) + (_e8677 * _e8682)) + (_e8681 * _e8680)) + (_e8681 * _e8682)));
                                            }
                                            let _e8694 = phi_11900_;
                                            if (_e8616 < 0f) {
                                                phi_11918_ = f32();
                                                phi_11919_ = true;
                                            } else {
                                                if (_e8655 < 0f) {
                                                    phi_11916_ = f32();
                                                    phi_11917_ = true;
                                                } else {
                                                    let _e8697 = (_e8694 < 0f);
                                                    if _e8697 {
                                                        phi_11915_ = f32();
                                                    } else {
                                                        phi_11915_ = ((_e8616 + _e8655) + _e8694);
                                                    }
                                                    let _e8701 = phi_11915_;
                                                    phi_11916_ = _e8701;
                                                    phi_11917_ = _e8697;
                                                }
                                                let _e8703 = phi_11916_;
                                                let _e8705 = phi_11917_;
                                                phi_11918_ = _e8703;
                                                phi_11919_ = _e8705;
                                            }
                                            let _e8707 = phi_11918_;
                                            let _e8709 = phi_11919_;
                                            if _e8709 {
                                                if (_e8616 > 0f) {
                                                    phi_11940_ = f32();
                                                    phi_11941_ = true;
                                                    phi_11942_ = false;
                                                } else {
                                                    let _e8711 = (_e8655 > 0f);
                                                    if _e8711 {
                                                        phi_11938_ = f32();
                                                        phi_11939_ = false;
                                                    } else {
                                                        phi_11938_ = ((_e8616 + _e8655) + _e8694);
                                                        phi_11939_ = select(true, false, (_e8694 > 0f));
                                                    }
                                                    let _e8717 = phi_11938_;
                                                    let _e8719 = phi_11939_;
                                                    phi_11940_ = _e8717;
                                                    phi_11941_ = _e8711;
                                                    phi_11942_ = _e8719;
                                                }
                                                let _e8721 = phi_11940_;
                                                let _e8723 = phi_11941_;
                                                let _e8725 = phi_11942_;
                                                phi_11947_ = _e8721;
                                                phi_11948_ = select(_e8725, false, _e8723);
                                            } else {
                                                phi_11947_ = _e8707;
                                                phi_11948_ = true;
                                            }
                                            let _e8728 = phi_11947_;
                                            let _e8730 = phi_11948_;
                                            if _e8730 {
                                                let _e8731 = (_e8728 == 0f);
                                                if _e8731 {
                                                    phi_12036_ = array<f32, 3>();
                                                    phi_12037_ = array<f32, 3>();
                                                    phi_12038_ = false;
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
                                                        phi_12034_ = array<f32, 3>(_e8745, _e8738, _e8739);
                                                        phi_12035_ = array<f32, 3>();
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
                                                        phi_12034_ = array<f32, 3>();
                                                        phi_12035_ = array<f32, 3>(((((_e8807 * _e8856) * _e8732) + (_e8857 * _e8733)) + (_e8858 * _e8734)), _e8857, _e8858);
                                                    }
                                                    let _e8868 = phi_12034_;
                                                    let _e8870 = phi_12035_;
                                                    phi_12036_ = _e8868;
                                                    phi_12037_ = _e8870;
                                                    phi_12038_ = _e8772;
                                                }
                                                let _e8872 = phi_12036_;
                                                let _e8874 = phi_12037_;
                                                let _e8876 = phi_12038_;
                                                phi_12039_ = _e8872;
                                                phi_12040_ = _e8874;
                                                phi_12041_ = _e8731;
                                                phi_12042_ = _e8876;
                                            } else {
                                                phi_12039_ = array<f32, 3>();
                                                phi_12040_ = array<f32, 3>();
                                                phi_12041_ = true;
                                                phi_12042_ = false;
                                            }
                                            let _e8878 = phi_12039_;
                                            let _e8880 = phi_12040_;
                                            let _e8882 = phi_12041_;
                                            let _e8884 = phi_12042_;
                                            if _e8882 {
                                                phi_12047_ = array<f32, 3>(-1f, 0f, 0f);
                                            } else {
                                                phi_12047_ = _e8878;
                                            }
                                            let _e8886 = phi_12047_;
                                            if select(_e8884, true, _e8882) {
                                                phi_12052_ = _e8886;
                                            } else {
                                                phi_12052_ = _e8880;
                                            }
                                            let _e8889 = phi_12052_;
                                            let _e8893 = (_e8889[0] >= 0f);
                                            if _e8893 {
                                                let _e8894 = (_e8889[0] < 340282350000000000000000000000000000000f);
                                                if _e8894 {
                                                    if _e8893 {
                                                        if _e8520 {
                                                        } else {
                                                            phi_17404_ = true;
                                                            phi_12561_ = bool();
                                                            break;
                                                        }
                                                        let _e8897 = triangles.member[_e8515.member_1].member_3;
                                                        if ((_e8897 & 1u) == 0u) {
                                                            phi_12385_ = true;
                                                        } else {
                                                            if _e8520 {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8902 = triangles.member[_e8515.member_1].member_1;
                                                            let _e8903 = (_e8902 * 12u);
                                                            if ((256u + _e8903) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 257u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 258u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8910 = (_e8903 + 259u);
                                                            if (_e8910 < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8913 = surfaces.member[_e8910];
                                                            if ((_e8903 + 260u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 261u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 262u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8920 = (_e8903 + 263u);
                                                            if (_e8920 < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8923 = surfaces.member[_e8920];
                                                            let _e8924 = (_e8903 + 264u);
                                                            if (_e8924 < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8927 = surfaces.member[_e8924];
                                                            let _e8928 = bitcast<f32>(_e8927);
                                                            let _e8929 = (_e8903 + 265u);
                                                            if (_e8929 < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            let _e8932 = surfaces.member[_e8929];
                                                            let _e8933 = bitcast<f32>(_e8932);
                                                            if ((_e8903 + 266u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            if ((_e8903 + 267u) < _e147) {
                                                            } else {
                                                                phi_17404_ = true;
                                                                phi_12561_ = bool();
                                                                break;
                                                            }
                                                            if (_e8913 == 4294967295u) {
                                                                phi_12380_ = (_e8928 < _e8933);
                                                            } else {
                                                                if (_e8515.member_1 < _e144) {
                                                                } else {
                                                                    phi_17404_ = true;
                                                                    phi_12561_ = bool();
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
                                                                    phi_12263_ = _e8988;
                                                                } else {
                                                                    let _e8994 = select(select(u32(_e8986), 0u, (_e8986 < 0f)), 4294967295u, (_e8986 > 4294967000f));
                                                                    phi_12263_ = select(_e8994, _e8988, (_e8988 < _e8994));
                                                                }
                                                                let _e8998 = phi_12263_;
                                                                if (_e8998 == _e8988) {
                                                                    phi_12269_ = 0u;
                                                                } else {
                                                                    phi_12269_ = (_e8998 + 1u);
                                                                }
                                                                let _e9002 = phi_12269_;
                                                                let _e9004 = (_e8975 - floor(_e8975));
                                                                let _e9009 = ((select(0f, _e9004, (_e9004 <= 1f)) * f32(_e8978)) - 0.5f);
                                                                let _e9010 = floor(_e9009);
                                                                let _e9011 = (_e9009 - _e9010);
                                                                let _e9012 = (_e8978 - 1u);
                                                                if (_e9010 < 0f) {
                                                                    phi_12299_ = _e9012;
                                                                } else {
                                                                    let _e9018 = select(select(u32(_e9010), 0u, (_e9010 < 0f)), 4294967295u, (_e9010 > 4294967000f));
                                                                    phi_12299_ = select(_e9018, _e9012, (_e9012 < _e9018));
                                                                }
                                                                let _e9022 = phi_12299_;
                                                                if (_e9022 == _e9012) {
                                                                    phi_12305_ = 0u;
                                                                } else {
                                                                    phi_12305_ = (_e9022 + 1u);
                                                                }
                                                                let _e9026 = phi_12305_;
                                                                let _e9028 = (_e8913 + (_e9022 * _e8976));
                                                                let _e9030 = (_e8913 + (_e9026 * _e8976));
                                                                let _e9031 = (_e9028 + _e8998);
                                                                let _e9032 = (_e9028 + _e9002);
                                                                let _e9033 = (_e9030 + _e8998);
                                                                let _e9034 = (_e9030 + _e9002);
                                                                if (_e9031 < _e147) {
                                                                } else {
                                                                    phi_17404_ = true;
                                                                    phi_12561_ = bool();
                                                                    break;
                                                                }
                                                                let _e9037 = surfaces.member[_e9031];
                                                                if (_e9032 < _e147) {
                                                                } else {
                                                                    phi_17404_ = true;
                                                                    phi_12561_ = bool();
                                                                    break;
                                                                }
                                                                let _e9040 = surfaces.member[_e9032];
                                                                if (_e9033 < _e147) {
                                                                } else {
                                                                    phi_17404_ = true;
                                                                    phi_12561_ = bool();
                                                                    break;
                                                                }
                                                                let _e9043 = surfaces.member[_e9033];
                                                                if (_e9034 < _e147) {
                                                                } else {
                                                                    phi_17404_ = true;
                                                                    phi_12561_ = bool();
                                                                    break;
                                                                }
                                                                let _e9046 = surfaces.member[_e9034];
                                                                let _e9063 = (1f - _e8987);
                                                                phi_12380_ = ((_e8928 * (((((f32((_e9037 >> bitcast<u32>(24i))) * 0.003921569f) * _e9063) + ((f32((_e9040 >> bitcast<u32>(24i))) * 0.003921569f) * _e8987)) * (1f - _e9011)) + ((((f32((_e9043 >> bitcast<u32>(24i))) * 0.003921569f) * _e9063) + ((f32((_e9046 >> bitcast<u32>(24i))) * 0.003921569f) * _e8987)) * _e9011))) < _e8933);
                                                            }
                                                            let _e9078 = phi_12380_;
                                                            phi_12385_ = select(true, false, _e9078);
                                                        }
                                                        let _e9081 = phi_12385_;
                                                        if _e9081 {
                                                            phi_12390_ = type_47(_e8889[0], _e8515.member_1, _e8889[1], _e8889[2]);
                                                        } else {
                                                            phi_12390_ = type_47();
                                                        }
                                                        let _e9084 = phi_12390_;
                                                        phi_12392_ = _e9084;
                                                        phi_12394_ = select(true, false, _e9081);
                                                    } else {
                                                        phi_12392_ = type_47();
                                                        phi_12394_ = false;
                                                    }
                                                    let _e9087 = phi_12392_;
                                                    let _e9089 = phi_12394_;
                                                    phi_12395_ = _e9087;
                                                    phi_12397_ = select(true, false, _e8893);
                                                    phi_12398_ = _e9089;
                                                } else {
                                                    phi_12395_ = type_47();
                                                    phi_12397_ = false;
                                                    phi_12398_ = false;
                                                }
                                                let _e9092 = phi_12395_;
                                                let _e9094 = phi_12397_;
                                                let _e9096 = phi_12398_;
                                                phi_12399_ = _e9092;
                                                phi_12400_ = select(true, false, _e8894);
                                                phi_12401_ = _e9094;
                                                phi_12402_ = _e9096;
                                            } else {
                                                phi_12399_ = type_47();
                                                phi_12400_ = true;
                                                phi_12401_ = false;
                                                phi_12402_ = false;
                                            }
                                            let _e9099 = phi_12399_;
                                            let _e9101 = phi_12400_;
                                            let _e9103 = phi_12401_;
                                            let _e9105 = phi_12402_;
                                            if select(select(_e9105, false, _e9101), true, select(_e9103, true, _e9101)) {
                                                phi_12415_ = type_47(340282350000000000000000000000000000000f, 4294967295u, 0f, 0f);
                                            } else {
                                                phi_12415_ = _e9099;
                                            }
                                            let _e9110 = phi_12415_;
                                            phi_12422_ = select(true, false, (_e9110.member_1 != 4294967295u));
                                        } else {
                                            phi_12422_ = false;
                                        }
                                        let _e9115 = phi_12422_;
                                        continue;
                                        continuing {
                                            phi_11738_ = _e8513;
                                            phi_17404_ = _e8488;
                                            phi_12561_ = select(true, false, _e8519);
                                            break if !(_e9115);
                                        }
                                    }
                                    let _e9119 = phi_17404_;
                                    let _e9121 = phi_12561_;
                                    phi_17479_ = _e9119;
                                    phi_12562_ = bool();
                                    if _e9119 {
                                        break;
                                    }
                                    phi_17481_ = _e9119;
                                    phi_12427_ = _e8492;
                                    phi_12428_ = _e9121;
                                }
                                let _e9358 = phi_17481_;
                                let _e9360 = phi_12427_;
                                let _e9362 = phi_12428_;
                                if _e9362 {
                                    let _e9363 = (_e9360 == 0u);
                                    if _e9363 {
                                        phi_12444_ = u32();
                                        phi_12445_ = u32();
                                    } else {
                                        let _e9364 = (_e9360 - 1u);
                                        if (_e9364 < 64u) {
                                        } else {
                                            phi_17479_ = true;
                                            phi_12562_ = bool();
                                            break;
                                        }
                                        let _e9367 = local[_e9364];
                                        phi_12444_ = _e9367;
                                        phi_12445_ = _e9364;
                                    }
                                    let _e9369 = phi_12444_;
                                    let _e9371 = phi_12445_;
                                    phi_11311_ = _e9369;
                                    phi_11314_ = _e9371;
                                    phi_12447_ = select(true, false, _e9363);
                                    phi_12448_ = _e9363;
                                } else {
                                    phi_11311_ = u32();
                                    phi_11314_ = u32();
                                    phi_12447_ = false;
                                    phi_12448_ = false;
                                }
                                let _e9374 = phi_11311_;
                                let _e9376 = phi_11314_;
                                let _e9378 = phi_12447_;
                                let _e9380 = phi_12448_;
                                continue;
                                continuing {
                                    phi_17408_ = _e9358;
                                    phi_11310_ = _e9374;
                                    phi_11313_ = _e9376;
                                    phi_17479_ = _e9358;
                                    phi_12562_ = _e9380;
                                    break if !(_e9378);
                                }
                            }
                            let _e9383 = phi_17479_;
                            let _e9385 = phi_12562_;
                            phi_17539_ = _e9383;
                            if _e9383 {
                                break;
                            }
                            if select(false, true, select(true, false, _e9385)) {
                                phi_12461_ = _e8143;
                            } else {
                                phi_12461_ = (_e8143 + 1i);
                            }
                            let _e9390 = phi_12461_;
                            phi_17540_ = _e9383;
                            phi_10837_ = _e9390;
                        } else {
                            phi_17540_ = _e8139;
                            phi_10837_ = i32();
                        }
                        let _e9392 = phi_17540_;
                        let _e9394 = phi_10837_;
                        continue;
                        continuing {
                            phi_17427_ = _e9392;
                            phi_10833_ = _e8156;
                            phi_10836_ = _e9394;
                            phi_17539_ = _e9392;
                            break if !(_e8162);
                        }
                    }
                    let _e9397 = phi_17539_;
                    if _e9397 {
                        break;
                    }
                    let _e9399 = local_30;
                    let _e9402 = f32(_e8096);
                    let _e9405 = ((3.1415927f * f32(_e9399)) / select(1f, _e9402, (_e9402 > 1f)));
                    phi_12483_ = vec3<f32>((_e8092.x + (_e8100.x * _e9405)), (_e8092.y + (_e8100.y * _e9405)), (_e8092.z + (_e8100.z * _e9405)));
                } else {
                    phi_12483_ = _e8092;
                }
                let _e9417 = phi_12483_;
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
