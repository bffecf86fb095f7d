//! From linear light to pictures on a screen: tone map, sRGB encoding, colour scales of error maps.

use super::{Image, luminance};
use glam::Vec3;

/// An 8-bit sRGB picture.
pub type Rgb8 = image::RgbImage;

/// Exposure and tone curve. All pictures of one comparison share the truth's, so that they can be compared by eye and
/// by FLIP.
///
/// `display = f(exposure * linear)` per channel with Reinhard's extended operator `f(v) = v (1 + v/w²) / (1 + v)`
/// (Reinhard et al. 2002, eq. 4), clamped to 0…1, then the sRGB transfer function.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ToneMap {
    /// Factor on linear values before the curve.
    pub exposure: f32,
    /// Exposed value that becomes white (`w`).
    pub white: f32,
}

impl ToneMap {
    /// The tone map that only clamps: display = sRGB(linear).
    pub const LINEAR: Self = Self { exposure: 1.0, white: f32::MAX };
    /// Percentile of the truth's luminance that is exposed to 1: bright surfaces, not the few pixels of a lamp.
    pub const PERCENTILE: f64 = 0.95;
    /// Value that becomes white, in units of that percentile: two stops of highlights above it keep their drawing.
    pub const WHITE: f32 = 4.0;

    /// The tone map of a comparison, chosen from its truth: the 95th percentile of luminance among the lit pixels
    /// where `visible` is exposed to 1 (which the curve and sRGB bring to code 193 of 255). A black truth gets
    /// exposure 1. `visible` may be empty: all pixels.
    pub fn from_truth(truth: &Image, visible: &[bool]) -> Self {
        let lit = |(k, p): (usize, &Vec3)| {
            let l = luminance(*p);
            (visible.get(k).copied().unwrap_or(true) && l.is_finite() && l > 0.0).then_some(l)
        };
        let mut lit: Vec<f32> = truth.pixels().iter().enumerate().filter_map(lit).collect();
        if lit.is_empty() {
            return Self { exposure: 1.0, white: Self::WHITE };
        }
        let rank = ((lit.len() - 1) as f64 * Self::PERCENTILE).round() as usize;
        let (_, percentile, _) = lit.select_nth_unstable_by(rank, f32::total_cmp);
        Self { exposure: (1.0 / *percentile).min(f32::MAX), white: Self::WHITE }
    }

    /// Linear value of the display, 0…1.
    pub fn curve(&self, linear: Vec3) -> Vec3 {
        if *self == Self::LINEAR {
            return linear.clamp(Vec3::ZERO, Vec3::ONE);
        }
        // Beyond white the result is clamped to 1 anyway; the bound keeps v² finite.
        let v = (linear * self.exposure).clamp(Vec3::ZERO, Vec3::splat(self.white));
        (v * (Vec3::ONE + v / (self.white * self.white)) / (Vec3::ONE + v)).clamp(Vec3::ZERO, Vec3::ONE)
    }

    /// The 8-bit sRGB picture.
    pub fn apply(&self, picture: &Image) -> Rgb8 {
        let [width, height] = picture.size();
        Rgb8::from_fn(width, height, |x, y| image::Rgb(srgb_codes(self.curve(picture.pixel(x, y)))))
    }

    /// One sentence for reports.
    pub fn describe(&self) -> String {
        if *self == Self::LINEAR {
            return "clamped to 0…1, sRGB".into();
        }
        format!(
            "exposure {:.4} (95th percentile of the truth's luminance to 1), Reinhard's extended curve with white at \
             {}, sRGB",
            self.exposure, self.white
        )
    }
}

/// sRGB codes of linear values in 0…1 (IEC 61966-2-1).
fn srgb_codes(linear: Vec3) -> [u8; 3] {
    let encode = |v: f32| {
        let v = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
        (v * 255.0 + 0.5) as u8
    };
    linear.to_array().map(encode)
}

/// Colour of pixels that show no surface in an error map.
const NO_SURFACE: [u8; 3] = [122, 122, 122];

/// Signed relative error in luminance as a picture: `(estimate − truth) / max(truth, guard)`, ±`range` at the ends of
/// [`colour_of_signed`]; grey where `visible` is false. All three must have the same number of pixels.
pub fn error_map(truth: &Image, estimate: &Image, visible: &[bool], guard: f32, range: f32) -> Rgb8 {
    let [width, height] = truth.size();
    Rgb8::from_fn(width, height, |x, y| {
        let k = y as usize * width as usize + x as usize;
        if !visible[k] {
            return image::Rgb(NO_SURFACE);
        }
        let t = luminance(truth.pixels()[k]);
        let error = (luminance(estimate.pixels()[k]) - t) / t.max(guard).max(f32::MIN_POSITIVE);
        image::Rgb(colour_of_signed(error / range))
    })
}

/// Names of the two ends of [`colour_of_signed`].
pub const DIVERGING_ENDS: [&str; 2] = ["too dark", "too bright"];

/// Diverging colour scale: blue at −1, near white at 0, red-brown at +1, clamped outside. Lightness falls evenly on
/// both sides in Oklab (Ottosson 2020), so that equal steps of error look equal and both signs weigh the same.
pub fn colour_of_signed(value: f32) -> [u8; 3] {
    let t = value.abs().min(1.0);
    let hue_rad = if value < 0.0 { 4.45_f32 } else { 0.70 };
    let lightness = 0.965 - 0.585 * t;
    let chroma = 0.15 * (1.6 * t).min(1.0) * (1.0 - 0.15 * t);
    let linear = linear_from_oklab(Vec3::new(lightness, chroma * hue_rad.cos(), chroma * hue_rad.sin()));
    srgb_codes(linear.clamp(Vec3::ZERO, Vec3::ONE))
}

/// Linear sRGB of an Oklab colour (Ottosson 2020, "A perceptual color space for image processing").
fn linear_from_oklab(lab: Vec3) -> Vec3 {
    let l = lab.x + 0.396_337_78 * lab.y + 0.215_803_76 * lab.z;
    let m = lab.x - 0.105_561_346 * lab.y - 0.063_854_17 * lab.z;
    let s = lab.x - 0.089_484_18 * lab.y - 1.291_485_5 * lab.z;
    let (l, m, s) = (l * l * l, m * m * m, s * s * s);
    Vec3::new(
        4.076_741_7 * l - 3.307_711_6 * m + 0.230_969_94 * s,
        -1.268_438 * l + 2.609_757_4 * m - 0.341_319_4 * s,
        -0.004_196_086_3 * l - 0.703_418_6 * m + 1.707_614_7 * s,
    )
}

/// The perceptually uniform scale "magma" at a value in 0…1, clamped: the one that FLIP's authors show errors in.
pub fn magma() -> impl Fn(f32) -> [u8; 3] {
    let table = nv_flip::magma_lut().to_vec();
    move |value| {
        let k = (value.clamp(0.0, 1.0) * 255.0 + 0.5) as usize * 3;
        [table[k], table[k + 1], table[k + 2]]
    }
}

/// A FLIP error map (0…1 per pixel, row by row) in [`magma`]. `values` must hold `width * height` numbers.
pub fn flip_map(width: u32, height: u32, values: &[f32]) -> Rgb8 {
    let magma = magma();
    Rgb8::from_fn(width, height, |x, y| image::Rgb(magma(values[y as usize * width as usize + x as usize])))
}
