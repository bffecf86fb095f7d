//! Counter-based random numbers: a hash of (seed, element, dimension), so that no state is stored and the same seed gives
//! the same bits in any order on any target.
//!
//! `element` is what an invocation owns (a pixel, a probe); `dimension` numbers the decisions along its path. No 64-bit
//! integers: devices need not have them.

use glam::{Vec2, Vec3, Vec4};

/// A permutation of 32-bit words with low bias (Wellons 2018, "Prospecting for Hash Functions", `lowbias32`).
#[inline(always)]
pub fn hash(x: u32) -> u32 {
    let x = (x ^ (x >> 16)).wrapping_mul(0x7FEB_352D);
    let x = (x ^ (x >> 15)).wrapping_mul(0x846C_A68B);
    x ^ (x >> 16)
}

/// Four words from four, each output depending on every input (Jarzynski & Olano 2020, "Hash Functions for GPU
/// Rendering", `pcg4d`).
#[inline(always)]
pub fn pcg4d(x: u32, y: u32, z: u32, w: u32) -> (u32, u32, u32, u32) {
    let step = |v: u32| v.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
    let (x, y, z, w) = (step(x), step(y), step(z), step(w));
    let x = x.wrapping_add(y.wrapping_mul(w));
    let y = y.wrapping_add(z.wrapping_mul(x));
    let z = z.wrapping_add(x.wrapping_mul(y));
    let w = w.wrapping_add(y.wrapping_mul(z));
    let (x, y, z, w) = (x ^ (x >> 16), y ^ (y >> 16), z ^ (z >> 16), w ^ (w >> 16));
    let x = x.wrapping_add(y.wrapping_mul(w));
    let y = y.wrapping_add(z.wrapping_mul(x));
    let z = z.wrapping_add(x.wrapping_mul(y));
    let w = w.wrapping_add(y.wrapping_mul(z));
    (x, y, z, w)
}

/// A word as a number of [0, 1): its upper 24 bits, exact.
#[inline(always)]
pub fn unit(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// 32 random bits.
#[inline(always)]
pub fn rand_bits(seed: u32, element: u32, dimension: u32) -> u32 {
    pcg4d(seed, element, dimension, 0).0
}
/// A random number, uniform in [0, 1).
#[inline(always)]
pub fn rand(seed: u32, element: u32, dimension: u32) -> f32 {
    unit(rand_bits(seed, element, dimension))
}
/// A random point of the unit square.
#[inline(always)]
pub fn rand2(seed: u32, element: u32, dimension: u32) -> Vec2 {
    let (x, y, _, _) = pcg4d(seed, element, dimension, 0);
    Vec2::new(unit(x), unit(y))
}
/// A random point of the unit cube.
#[inline(always)]
pub fn rand3(seed: u32, element: u32, dimension: u32) -> Vec3 {
    let (x, y, z, _) = pcg4d(seed, element, dimension, 0);
    Vec3::new(unit(x), unit(y), unit(z))
}
/// Four random numbers for the price of one hash. The first ones are those of [`rand`], [`rand2`] and [`rand3`].
#[inline(always)]
pub fn rand4(seed: u32, element: u32, dimension: u32) -> Vec4 {
    let (x, y, z, w) = pcg4d(seed, element, dimension, 0);
    Vec4::new(unit(x), unit(y), unit(z), unit(w))
}
/// `point + offset` modulo 1: a low-discrepancy point turned by a random one (Cranley & Patterson 1976).
#[inline(always)]
pub fn rotate(point: Vec2, offset: Vec2) -> Vec2 {
    let wrap = |x: f32| if x >= 1.0 { x - 1.0 } else { x };
    Vec2::new(wrap(point.x + offset.x), wrap(point.y + offset.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_have_their_published_values() {
        // lowbias32 fixes 0; the others were made with the published code transcribed to Python.
        assert_eq!((hash(0), hash(1), hash(0xDEAD_BEEF)), (0, 1_753_845_952, 3_861_431_939));
        assert_eq!(pcg4d(0, 1, 2, 3), PCG4D_OF_0123);
    }
    const PCG4D_OF_0123: (u32, u32, u32, u32) = (933_639_991, 2_252_496_459, 1_324_331_964, 1_990_701_187);

    /// χ² of `bins` equally likely bins.
    fn chi_squared(counts: &[u32]) -> f64 {
        let expected = f64::from(counts.iter().sum::<u32>()) / counts.len() as f64;
        counts.iter().map(|&c| (f64::from(c) - expected).powi(2) / expected).sum()
    }

    #[test]
    fn numbers_are_uniform_and_pairs_independent() {
        // Along each argument in turn, neighbouring values fill a 16×16 grid evenly.
        let along: [fn(u32) -> Vec2; 3] = [|i| rand2(i, 7, 3), |i| rand2(1, i, 3), |i| rand2(1, 7, i)];
        for (axis, point) in along.iter().enumerate() {
            let mut counts = [0u32; 256];
            let (mut mean, n) = (Vec2::ZERO, 1 << 18);
            for p in (0..n).map(point) {
                assert!(p.min_element() >= 0.0 && p.max_element() < 1.0);
                counts[(p.x * 16.0) as usize * 16 + (p.y * 16.0) as usize] += 1;
                mean += p / n as f32;
            }
            // 255 degrees of freedom: mean 255, deviation 22.6; five deviations.
            assert!(chi_squared(&counts) < 255.0 + 5.0 * 22.6, "axis {axis}: {}", chi_squared(&counts));
            assert!((mean - 0.5).abs().max_element() < 5.0 * (1.0f32 / 12.0 / n as f32).sqrt() + 2e-4, "{mean}");
        }
    }

    #[test]
    fn neighbouring_dimensions_and_elements_are_uncorrelated() {
        let n = 1 << 16;
        for other in [(0u32, 1u32), (1, 0), (1, 1)] {
            let sum: f64 =
                (0..n).map(|i| f64::from(rand(9, i, 0) - 0.5) * f64::from(rand(9, i + other.0, other.1) - 0.5)).sum();
            // The product of two uniforms has variance 1/144.
            assert!(sum.abs() / f64::from(n) < 5.0 / 12.0 / f64::from(n).sqrt(), "{other:?}: {sum}");
        }
    }

    #[test]
    fn one_hash_serves_all_widths() {
        let p = rand4(1, 2, 3);
        assert_eq!((rand(1, 2, 3), rand2(1, 2, 3), rand3(1, 2, 3)), (p.x, p.truncate().truncate(), p.truncate()));
        assert_eq!((unit(0), unit(u32::MAX)), (0.0, 1.0 - 1.0 / 16_777_216.0));
        assert_eq!(rotate(Vec2::new(0.75, 0.25), Vec2::new(0.5, 0.5)), Vec2::new(0.25, 0.75));
    }
}
