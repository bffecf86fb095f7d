//! Interpolation by hand, generic over [`Real`]: buffers instead of images, so that every target filters alike.

use super::float::{clamp, floor};
use crate::real::Real;

/// `a + (b − a)·t`.
#[inline(always)]
pub fn lerp<R: Real>(a: R, b: R, t: R) -> R {
    a + (b - a) * t
}
/// Value at `(x, y)` in a unit square; corner `(i, j)` is `c[i + 2·j]`.
#[inline(always)]
pub fn bilinear<R: Real>(c: [R; 4], x: R, y: R) -> R {
    lerp(lerp(c[0], c[1], x), lerp(c[2], c[3], x), y)
}
/// Value at `(x, y, z)` in a unit cube; corner `(i, j, k)` is `c[i + 2·j + 4·k]`.
#[inline(always)]
pub fn trilinear<R: Real>(c: [R; 8], x: R, y: R, z: R) -> R {
    lerp(bilinear([c[0], c[1], c[2], c[3]], x, y), bilinear([c[4], c[5], c[6], c[7]], x, y), z)
}

/// The two cells between whose centres a coordinate lies, and how far it is on the way from the first to the second.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tap {
    /// Cell whose weight is `1 − fraction`.
    pub low: u32,
    /// Cell whose weight is `fraction`.
    pub high: u32,
    /// In [0, 1].
    pub fraction: f32,
}
/// Cells for linear interpolation along one axis: `x` in cells from the edge of cell 0 (its centre is 0.5), `count ≥ 1`
/// cells, clamped at both ends. NaN counts as 0.
#[inline(always)]
pub fn tap_clamped(x: f32, count: u32) -> Tap {
    let last = count - 1;
    let t = clamp(x - 0.5, 0.0, last as f32);
    let low = floor(t);
    let cell = low as u32;
    Tap { low: cell, high: if cell < last { cell + 1 } else { last }, fraction: t - low }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_reproduces_multilinear_functions() {
        let f = |x: f32, y: f32, z: f32| 1.0 + 2.0 * x - 3.0 * y + 0.5 * z + x * y - 2.0 * x * y * z;
        let corners = core::array::from_fn(|i| f((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32));
        for (x, y, z) in [(0.0, 0.0, 0.0), (1.0, 1.0, 1.0), (0.25, 0.5, 0.75), (0.9, 0.1, 0.4)] {
            assert!((trilinear(corners, x, y, z) - f(x, y, z)).abs() < 1e-6);
        }
    }

    #[test]
    fn taps_are_clamped_at_both_ends() {
        let tap = |low, high, fraction| Tap { low, high, fraction };
        assert_eq!(tap_clamped(-3.0, 4), tap(0, 1, 0.0));
        assert_eq!(tap_clamped(0.5, 4), tap(0, 1, 0.0));
        assert_eq!(tap_clamped(1.75, 4), tap(1, 2, 0.25));
        assert_eq!(tap_clamped(9.0, 4), tap(3, 3, 0.0));
        assert_eq!(tap_clamped(f32::NAN, 4), tap(0, 1, 0.0));
        assert_eq!(tap_clamped(0.9, 1), tap(0, 0, 0.0));
    }
}
