//! Numbers in fewer bits: half floats, normalized integers, shared exponents, fixed point. Integer code, so that every
//! target gives the same bits.

use super::float::{clamp, exp2_int, floor, max, round, saturate};

/// Bits of the IEEE 754 half float nearest to `x` (ties to even), in the low half of the word. Beyond 65,520 in
/// magnitude ±∞; NaN stays NaN; denormal halves are kept. The same bits as the `half` crate's `f16::from_f32`.
#[inline(always)]
pub fn f16_from_f32(x: f32) -> u32 {
    let bits = x.to_bits();
    let sign = (bits >> 16) & 0x8000;
    let magnitude = bits & 0x7FFF_FFFF;
    if magnitude > 0x7F80_0000 {
        // NaN: made quiet, with the upper bits of its payload.
        sign | 0x7E00 | ((magnitude >> 13) & 0x3FF)
    } else if magnitude >= 0x477F_F000 {
        // 65,520 and more round up to infinity.
        sign | 0x7C00
    } else if magnitude >= 0x3880_0000 {
        // Normal: rebias the exponent by 127 − 15, round the 13 bits that go.
        sign | round_shift(magnitude - 0x3800_0000, 13)
    } else if magnitude >= 0x3300_0000 {
        // Denormal half, a multiple of 2⁻²⁴: shift the mantissa with its leading one.
        sign | round_shift((magnitude & 0x007F_FFFF) | 0x0080_0000, 126 - (magnitude >> 23))
    } else {
        sign
    }
}
/// `value / 2^shift` rounded to nearest, ties to even.
#[inline(always)]
fn round_shift(value: u32, shift: u32) -> u32 {
    let half_less_one = (1 << (shift - 1)) - 1;
    (value + half_less_one + ((value >> shift) & 1)) >> shift
}
/// The number that the half float in the low 16 bits stands for, exact.
#[inline(always)]
pub fn f32_from_f16(half: u32) -> f32 {
    let sign = (half & 0x8000) << 16;
    let (exponent, mantissa) = ((half >> 10) & 0x1F, half & 0x3FF);
    if exponent == 0 {
        // Denormal: the mantissa counts 2⁻²⁴.
        f32::from_bits(sign | (mantissa as f32 * exp2_int(-24)).to_bits())
    } else {
        let exponent = if exponent == 0x1F { 0xFF } else { exponent + 112 };
        // A signalling NaN becomes quiet, as in hardware.
        let quiet = if exponent == 0xFF && mantissa != 0 { 0x0040_0000 } else { 0 };
        f32::from_bits(sign | (exponent << 23) | (mantissa << 13) | quiet)
    }
}
/// Two half floats, `a` in the low bits.
#[inline(always)]
pub fn pack_f16x2(a: f32, b: f32) -> u32 {
    f16_from_f32(a) | (f16_from_f32(b) << 16)
}
/// Two half floats for lane-generic kernels, which read them without a branch: magnitudes below the smallest normal half
/// (2⁻¹⁴) become 0, those above the largest (65,504) become that, NaN becomes 0.
#[inline(always)]
pub fn pack_f16x2_flushed(a: f32, b: f32) -> u32 {
    let half = |x: f32| {
        let x = clamp(if x.is_nan() { 0.0 } else { x }, -F16_MAX, F16_MAX);
        let half = f16_from_f32(x);
        if half & 0x7C00 == 0 { 0 } else { half }
    };
    half(a) | (half(b) << 16)
}
/// Largest half float.
pub const F16_MAX: f32 = 65_504.0;
/// What [`pack_f16x2`] stored.
#[inline(always)]
pub fn unpack_f16x2(word: u32) -> (f32, f32) {
    (f32_from_f16(word & 0xFFFF), f32_from_f16(word >> 16))
}

/// A number of [−1, 1] in 16 bits: `round(32767·x)`; beyond that range clamped, NaN as −1.
#[inline(always)]
pub fn snorm16(x: f32) -> u32 {
    (round(clamp(x, -1.0, 1.0) * 32_767.0) as i32 as u32) & 0xFFFF
}
/// Two numbers of [−1, 1], `a` in the low bits.
#[inline(always)]
pub fn pack_snorm16x2(a: f32, b: f32) -> u32 {
    snorm16(a) | (snorm16(b) << 16)
}
/// What [`pack_snorm16x2`] stored; −32768 counts as −32767.
#[inline(always)]
pub fn unpack_snorm16x2(word: u32) -> (f32, f32) {
    let (a, b) = (((word << 16) as i32) >> 16, (word as i32) >> 16);
    (max(a as f32 * (1.0 / 32_767.0), -1.0), max(b as f32 * (1.0 / 32_767.0), -1.0))
}
/// Two numbers of [0, 1] in 16 bits each, `a` in the low bits; clamped, NaN as 0.
#[inline(always)]
pub fn pack_unorm16x2(a: f32, b: f32) -> u32 {
    (round(saturate(a) * 65_535.0) as u32) | ((round(saturate(b) * 65_535.0) as u32) << 16)
}
/// What [`pack_unorm16x2`] stored.
#[inline(always)]
pub fn unpack_unorm16x2(word: u32) -> (f32, f32) {
    ((word & 0xFFFF) as f32 * (1.0 / 65_535.0), (word >> 16) as f32 * (1.0 / 65_535.0))
}
/// A number of [0, 1] in 8 bits; clamped, NaN as 0.
#[inline(always)]
pub fn unorm8(x: f32) -> u32 {
    round(saturate(x) * 255.0) as u32
}
/// Four numbers of [0, 1] in 8 bits each, the first in the lowest bits.
#[inline(always)]
pub fn pack_unorm8x4(r: f32, g: f32, b: f32, a: f32) -> u32 {
    unorm8(r) | (unorm8(g) << 8) | (unorm8(b) << 16) | (unorm8(a) << 24)
}
/// What [`pack_unorm8x4`] stored.
#[inline(always)]
pub fn unpack_unorm8x4(word: u32) -> (f32, f32, f32, f32) {
    const STEP: f32 = 1.0 / 255.0;
    let byte = |shift: u32| ((word >> shift) & 0xFF) as f32 * STEP;
    (byte(0), byte(8), byte(16), byte(24))
}

/// Largest component that [`pack_rgb9e5`] can hold: (2⁹ − 1)/2⁹ · 2¹⁶.
pub const RGB9E5_MAX: f32 = 65_408.0;
/// Three non-negative numbers with 9 bits each and one common exponent of 5 bits (the format E5B9G9R9 of Vulkan, D3D and
/// OpenGL: EXT_texture_shared_exponent). Error at most 1/512 of the largest component (and at least 2⁻²⁵); clamped to
/// `[0, RGB9E5_MAX]`, NaN as 0.
#[inline(always)]
pub fn pack_rgb9e5(r: f32, g: f32, b: f32) -> u32 {
    let (r, g, b) = (clamp(r, 0.0, RGB9E5_MAX), clamp(g, 0.0, RGB9E5_MAX), clamp(b, 0.0, RGB9E5_MAX));
    let largest = max(max(r, g), b);
    // floor(log2) from the exponent bits, not below the format's smallest exponent.
    let log = (largest.to_bits() >> 23) as i32 - 127;
    let mut shared = if log < -16 { 0 } else { log + 16 };
    // Rounding may carry the largest component to 512: then the next exponent.
    if floor(largest * exp2_int(24 - shared) + 0.5) >= 512.0 {
        shared += 1;
    }
    let scale = exp2_int(24 - shared);
    let digits = |x: f32| floor(x * scale + 0.5) as u32;
    digits(r) | (digits(g) << 9) | (digits(b) << 18) | ((shared as u32) << 27)
}
/// What [`pack_rgb9e5`] stored.
#[inline(always)]
pub fn unpack_rgb9e5(word: u32) -> (f32, f32, f32) {
    let scale = exp2_int((word >> 27) as i32 - 24);
    ((word & 0x1FF) as f32 * scale, ((word >> 9) & 0x1FF) as f32 * scale, ((word >> 18) & 0x1FF) as f32 * scale)
}

/// A non-negative number as a multiple of `1/unit`, for sums by integer atomics: rounded, negative and NaN as 0,
/// saturating. A sum of n terms is exact to n/2 units and must stay below 2³²: choose `unit` as a power of two of at most
/// 2³²/(n·largest).
#[inline(always)]
pub fn to_fixed(x: f32, unit: f32) -> u32 {
    floor(max(x, 0.0) * unit + 0.5) as u32
}
/// The number that a sum of [`to_fixed`] stands for.
#[inline(always)]
pub fn from_fixed(sum: u32, unit: f32) -> f32 {
    sum as f32 / unit
}
/// A number of either sign as a multiple of `1/unit` in two's complement: wrapping adds give signed sums, which must
/// stay within ±2³¹. NaN as 0, saturating.
#[inline(always)]
pub fn to_fixed_signed(x: f32, unit: f32) -> u32 {
    round(x * unit) as i32 as u32
}
/// The number that a sum of [`to_fixed_signed`] stands for.
#[inline(always)]
pub fn from_fixed_signed(sum: u32, unit: f32) -> f32 {
    sum as i32 as f32 / unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_half_float_unpacks_and_packs_to_itself() {
        for half in 0..=0xFFFFu32 {
            let x = f32_from_f16(half);
            assert_eq!(x.to_bits(), half::f16::from_bits(half as u16).to_f32().to_bits(), "{half:#06x}");
            let back = f16_from_f32(x);
            let quiet = if half & 0x7C00 == 0x7C00 && half & 0x3FF != 0 { half | 0x200 } else { half };
            assert_eq!(back, quiet, "{half:#06x}");
        }
    }

    #[test]
    fn half_floats_round_as_the_half_crate_does() {
        // Every exponent and sign with mantissas around the rounding boundaries and a stride through the rest.
        for high in 0..0x200u32 {
            let edges =
                [0, 1, 0xFFF, 0x1000, 0x1001, 0x1FFF, 0x2000, 0x2FFF, 0x3000, 0x3001, 0x7F_EFFF, 0x7F_F000, 0x7F_FFFF];
            for low in edges.into_iter().chain((0..0x80_0000).step_by(6151)) {
                let x = f32::from_bits((high << 23) | low);
                assert_eq!(f16_from_f32(x), u32::from(half::f16::from_f32(x).to_bits()), "{:#010x}", x.to_bits());
            }
        }
        assert_eq!(unpack_f16x2(pack_f16x2(-1.5, 1024.0)), (-1.5, 1024.0));
    }

    #[test]
    fn lanes_read_flushed_halves() {
        use crate::real::{Lanes, Real};
        for start in (0..0x10000u32).step_by(16) {
            let halves: [f32; 16] = core::array::from_fn(|lane| f32_from_f16(start + lane as u32));
            let words = halves.map(|x| pack_f16x2_flushed(x, -x));
            let [low, high] = Lanes::<16>::load_f16x2(&words, 0);
            for lane in 0..16 {
                let x = halves[lane];
                let flushed = if x.is_nan() || x.abs() < 2f32.powi(-14) { 0.0 } else { x.clamp(-F16_MAX, F16_MAX) };
                assert_eq!((low.0[lane], high.0[lane]), (flushed, -flushed), "{x:e}");
                assert_eq!(f32::load_f16x2(&words, lane), [low.0[lane], high.0[lane]]);
            }
        }
    }

    #[test]
    fn normalized_integers_round_trip() {
        for k in -32_767..=32_767i32 {
            let x = k as f32 / 32_767.0;
            assert_eq!(snorm16(x), k as u32 & 0xFFFF);
            let (a, b) = unpack_snorm16x2(pack_snorm16x2(x, -x));
            assert!((a - x).abs() < 1e-7 && a == -b, "{k}");
        }
        for k in 0..=65_535u32 {
            let (a, b) = unpack_unorm16x2(k | ((65_535 - k) << 16));
            assert_eq!(pack_unorm16x2(a, b), k | ((65_535 - k) << 16));
        }
        for k in 0..=255u32 {
            let word = k | ((255 - k) << 8) | ((k / 2) << 16) | ((k / 3) << 24);
            let (r, g, b, a) = unpack_unorm8x4(word);
            assert_eq!(pack_unorm8x4(r, g, b, a), word);
        }
        assert_eq!((snorm16(-2.0), snorm16(f32::NAN), unorm8(f32::NAN), unorm8(9.0)), (0x8001, 0x8001, 0, 255));
        assert_eq!(unpack_snorm16x2(0x8000_8000), (-1.0, -1.0));
    }

    #[test]
    fn shared_exponents_keep_every_component_to_half_a_step() {
        let mut x = 1e-8f32;
        while x < RGB9E5_MAX {
            let (r, g, b) = unpack_rgb9e5(pack_rgb9e5(x, 0.37 * x, 0.0));
            let step = (x / 512.0).max(2f32.powi(-25));
            assert!((r - x).abs() <= step && (g - 0.37 * x).abs() <= step && b == 0.0, "{x}: {r} {g} {b}");
            x *= 1.0137;
        }
        // 511.5/512 of a power of two carries into the next exponent.
        assert_eq!(unpack_rgb9e5(pack_rgb9e5(0.999_5, 0.0, 0.0)).0, 1.0);
        assert_eq!(unpack_rgb9e5(pack_rgb9e5(1e30, -1.0, f32::NAN)), (RGB9E5_MAX, 0.0, 0.0));
        // The example of the OpenGL specification: 1.0 is mantissa 256 with exponent 16.
        assert_eq!(pack_rgb9e5(1.0, 1.0, 1.0), 256 | (256 << 9) | (256 << 18) | (16 << 27));
    }

    #[test]
    fn fixed_point_sums_are_exact() {
        let unit = 65_536.0;
        let sum = (0..1000u32).fold(0u32, |sum, i| sum.wrapping_add(to_fixed(i as f32 / 16.0, unit)));
        assert_eq!(from_fixed(sum, unit), 999.0 * 1000.0 / 32.0);
        let signed = (0..1000).fold(0u32, |sum, i| sum.wrapping_add(to_fixed_signed((i as f32 - 600.0) / 16.0, unit)));
        assert_eq!(from_fixed_signed(signed, unit), (999.0 * 500.0 - 600_000.0) / 16.0);
        assert_eq!((to_fixed(-1.0, unit), to_fixed(f32::NAN, unit), to_fixed(1e30, unit)), (0, 0, u32::MAX));
        assert_eq!((to_fixed_signed(f32::NAN, unit), to_fixed_signed(-1e30, unit)), (0, i32::MIN as u32));
    }
}
