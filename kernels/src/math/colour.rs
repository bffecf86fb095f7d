//! Colour: linear Rec. 709 everywhere inside; sRGB only in textures that come in and pictures that go out.

use super::float::{max, pow, saturate};
use super::pack::unpack_unorm8x4;
use glam::Vec3;

/// Luminance weights of linear Rec. 709 primaries (ITU-R BT.709-6).
pub const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);

/// Luminance of a linear Rec. 709 colour, in the colour's unit.
#[inline(always)]
pub fn luminance(rgb: Vec3) -> f32 {
    rgb.dot(LUMINANCE)
}

/// Linear value of an sRGB-coded one in [0, 1] (IEC 61966-2-1, piecewise), relative error 8e-7; clamped below at 0.
#[inline(always)]
pub fn linear_from_srgb(coded: f32) -> f32 {
    if coded <= 0.040_45 { max(coded, 0.0) * (1.0 / 12.92) } else { pow((coded + 0.055) * (1.0 / 1.055), 2.4) }
}

/// sRGB code in [0, 1] of a linear value (IEC 61966-2-1, piecewise), absolute error 4e-7; clamped to [0, 1], NaN as 0.
#[inline(always)]
pub fn srgb_from_linear(linear: f32) -> f32 {
    let x = saturate(linear);
    if x <= 0.003_130_8 { x * 12.92 } else { 1.055 * pow(x, 1.0 / 2.4) - 0.055 }
}

/// Linear colour and alpha of a texel 0xAABBGGRR with sRGB-coded colour and linear alpha.
#[inline(always)]
pub fn linear_from_rgba8(texel: u32) -> (Vec3, f32) {
    let (r, g, b, a) = unpack_unorm8x4(texel);
    (Vec3::new(linear_from_srgb(r), linear_from_srgb(g), linear_from_srgb(b)), a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::pack::unorm8;

    #[test]
    fn srgb_follows_its_definition() {
        for k in 0..=100_000 {
            let x = k as f32 / 100_000.0;
            let d = f64::from(x);
            let linear = if d <= 0.04045 { d / 12.92 } else { ((d + 0.055) / 1.055).powf(2.4) };
            assert!((f64::from(linear_from_srgb(x)) - linear).abs() <= 8e-7 * linear, "{x}");
            let coded = if d <= 0.003_130_8 { d * 12.92 } else { 1.055 * d.powf(1.0 / 2.4) - 0.055 };
            assert!((f64::from(srgb_from_linear(x)) - coded).abs() < 4e-7, "{x}");
        }
    }

    #[test]
    fn every_byte_survives_decoding_and_coding() {
        for k in 0..=255u32 {
            let (rgb, alpha) = linear_from_rgba8(k * 0x0101_0101);
            assert_eq!((unorm8(srgb_from_linear(rgb.x)), unorm8(srgb_from_linear(rgb.z)), unorm8(alpha)), (k, k, k));
        }
        assert_eq!((linear_from_rgba8(0xFFFF_FFFF).0 - 1.0).abs().max_element(), 0.0);
        assert_eq!((srgb_from_linear(f32::NAN), linear_from_srgb(-1.0)), (0.0, 0.0));
        assert!((srgb_from_linear(2.0) - 1.0).abs() < 1e-6);
    }

    #[test]
    fn white_has_luminance_one() {
        assert!((luminance(Vec3::ONE) - 1.0).abs() < 1e-7 && luminance(Vec3::Y) == 0.7152);
    }
}
