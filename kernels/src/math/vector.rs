//! Lengths and directions of [`Vec3`] by the float functions of [`super::float`].

use super::float::{max, sqrt};
use glam::Vec3;

/// Length of a vector whose square is a finite normal number.
#[inline(always)]
pub fn length(v: Vec3) -> f32 {
    sqrt(v.dot(v))
}

/// The vector at length 1; `fallback` where its squared length is zero, denormal or NaN.
#[inline(always)]
pub fn normalize_or(v: Vec3, fallback: Vec3) -> Vec3 {
    let squared = v.dot(v);
    if squared >= f32::MIN_POSITIVE { v * (1.0 / sqrt(squared)) } else { fallback }
}

/// The vector at length 1; the zero vector where it has no direction (see [`normalize_or`]).
#[inline(always)]
pub fn normalize(v: Vec3) -> Vec3 {
    normalize_or(v, Vec3::ZERO)
}

/// Mirror direction of `wo` about the unit normal `n`; both results and arguments point away from the surface.
#[inline(always)]
pub fn reflect(wo: Vec3, n: Vec3) -> Vec3 {
    n * (2.0 * wo.dot(n)) - wo
}

/// The largest component.
#[inline(always)]
pub fn max_component(v: Vec3) -> f32 {
    max(max(v.x, v.y), v.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_have_length_one_and_bad_ones_the_fallback() {
        for v in [Vec3::new(3.0, -4.0, 12.0), Vec3::splat(1e-18), Vec3::splat(1e18)] {
            let n = normalize(v);
            assert!((n.length() - 1.0).abs() < 2e-7 && (n * length(v) / v - 1.0).abs().max_element() < 4e-7, "{v}");
        }
        for v in [Vec3::ZERO, Vec3::splat(1e-30), Vec3::new(f32::NAN, 0.0, 0.0)] {
            assert_eq!((normalize(v), normalize_or(v, Vec3::Y)), (Vec3::ZERO, Vec3::Y));
        }
    }

    #[test]
    fn reflection_keeps_the_angle_to_the_normal() {
        let n = normalize(Vec3::new(0.2, 1.0, -0.4));
        let wo = normalize(Vec3::new(1.0, 0.5, 0.3));
        let r = reflect(wo, n);
        assert!((r.dot(n) - wo.dot(n)).abs() < 1e-6 && (r.length() - 1.0).abs() < 1e-6);
        assert!(r.cross(n).dot(wo.cross(n)) < 0.0, "on the other side of the normal");
        assert_eq!(max_component(Vec3::new(-1.0, 7.0, 2.0)), 7.0);
    }
}
