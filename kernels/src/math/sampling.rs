//! Sampling: for each shape a function from the unit square, its density, and its inverse; and point sets.
//!
//! Points of the unit square lie in [0, 1). Directions are unit vectors in a frame whose axis is +Z (see
//! [`super::frame::Frame`]). Densities of directions are per steradian, of points per unit area of the shape. The maps
//! are continuous, so that well spread points stay well spread. Maps as in Pharr, Jakob & Humphreys 2023, "Physically
//! Based Rendering" (4th edition), appendix A.5, where no other source is named.

use super::float::{PI, abs, acos, atan2, clamp, cos, max, min, sin_cos, sqrt};
use super::rng::unit;
use glam::{Vec2, Vec3};

const INV_PI: f32 = core::f32::consts::FRAC_1_PI;
/// Solid angle of the whole sphere, 4π sr.
pub const SPHERE_SR: f32 = 4.0 * PI;
/// Largest `f32` below 1: what an inverse may return at most.
const ONE_BELOW: f32 = 1.0 - f32::EPSILON / 2.0;

#[inline(always)]
fn in_unit(x: f32) -> f32 {
    clamp(x, 0.0, ONE_BELOW)
}
/// Azimuth of (x, y) in turns, in [0, 1).
#[inline(always)]
fn turns(y: f32, x: f32) -> f32 {
    let t = atan2(y, x) * (0.5 * INV_PI);
    in_unit(if t < 0.0 { t + 1.0 } else { t })
}

/// A point of the unit disk by concentric squares (Shirley & Chiu 1997).
#[inline(always)]
pub fn disk(u: Vec2) -> Vec2 {
    let (x, y) = (2.0 * u.x - 1.0, 2.0 * u.y - 1.0);
    if x == 0.0 && y == 0.0 {
        Vec2::ZERO
    } else if abs(x) > abs(y) {
        let (s, c) = sin_cos(0.25 * PI * (y / x));
        Vec2::new(x * c, x * s)
    } else {
        // cos(π/2 − a) = sin a: the same octant mirrored.
        let (s, c) = sin_cos(0.25 * PI * (x / y));
        Vec2::new(y * s, y * c)
    }
}
/// Density of [`disk`] per unit area.
pub const DISK_PDF: f32 = INV_PI;
/// The point of the unit square that [`disk`] maps to `p`.
#[inline(always)]
pub fn disk_invert(p: Vec2) -> Vec2 {
    let radius = sqrt(p.dot(p));
    let (x, y) = if abs(p.x) > abs(p.y) {
        let r = if p.x < 0.0 { -radius } else { radius };
        (r, r * (4.0 * INV_PI) * atan2(p.y / p.x, 1.0))
    } else if radius > 0.0 {
        let r = if p.y < 0.0 { -radius } else { radius };
        (r * (4.0 * INV_PI) * atan2(p.x / p.y, 1.0), r)
    } else {
        (0.0, 0.0)
    };
    Vec2::new(in_unit(0.5 * (x + 1.0)), in_unit(0.5 * (y + 1.0)))
}

/// A direction of the hemisphere +Z with density cos θ/π (Malley's method).
#[inline(always)]
pub fn cosine_hemisphere(u: Vec2) -> Vec3 {
    let p = disk(u);
    Vec3::new(p.x, p.y, sqrt(max(1.0 - p.dot(p), 0.0)))
}
/// Density of [`cosine_hemisphere`] per steradian.
#[inline(always)]
pub fn cosine_hemisphere_pdf(cos_theta: f32) -> f32 {
    max(cos_theta, 0.0) * INV_PI
}
/// The point of the unit square that [`cosine_hemisphere`] maps to `w`.
#[inline(always)]
pub fn cosine_hemisphere_invert(w: Vec3) -> Vec2 {
    disk_invert(w.truncate())
}

/// A direction with a given cosine to +Z and azimuth in turns.
#[inline(always)]
fn ring(cos_theta: f32, turn: f32) -> Vec3 {
    let (s, c) = sin_cos(2.0 * PI * turn);
    let radius = sqrt(max(1.0 - cos_theta * cos_theta, 0.0));
    Vec3::new(radius * c, radius * s, cos_theta)
}

/// A direction, uniform over the sphere.
#[inline(always)]
pub fn sphere(u: Vec2) -> Vec3 {
    ring(1.0 - 2.0 * u.x, u.y)
}
/// Density of [`sphere`] per steradian.
pub const SPHERE_PDF: f32 = 0.25 * INV_PI;
/// The point of the unit square that [`sphere`] maps to `w`.
#[inline(always)]
pub fn sphere_invert(w: Vec3) -> Vec2 {
    Vec2::new(in_unit(0.5 * (1.0 - w.z)), turns(w.y, w.x))
}

/// A direction, uniform over the hemisphere +Z.
#[inline(always)]
pub fn hemisphere(u: Vec2) -> Vec3 {
    ring(1.0 - u.x, u.y)
}
/// Density of [`hemisphere`] per steradian.
pub const HEMISPHERE_PDF: f32 = 0.5 * INV_PI;
/// The point of the unit square that [`hemisphere`] maps to `w`.
#[inline(always)]
pub fn hemisphere_invert(w: Vec3) -> Vec2 {
    Vec2::new(in_unit(1.0 - w.z), turns(w.y, w.x))
}

/// A direction, uniform over the cone of half angle θ around +Z; `one_minus_cos` = 1 − cos θ (see [`one_minus_cos`]), in
/// which narrow cones keep their precision.
#[inline(always)]
pub fn cone(u: Vec2, one_minus_cos: f32) -> Vec3 {
    let h = u.x * one_minus_cos;
    let (s, c) = sin_cos(2.0 * PI * u.y);
    // sin²θ = (1 − cos θ)(1 + cos θ) without cancellation.
    let radius = sqrt(h * (2.0 - h));
    Vec3::new(radius * c, radius * s, 1.0 - h)
}
/// Density of [`cone`] per steradian.
#[inline(always)]
pub fn cone_pdf(one_minus_cos: f32) -> f32 {
    0.5 * INV_PI / one_minus_cos
}
/// The point of the unit square that [`cone`] maps to `w`.
#[inline(always)]
pub fn cone_invert(w: Vec3, one_minus_cos: f32) -> Vec2 {
    // 1 − cos θ from sin²θ, which near the axis is the more precise of the two.
    let h = w.truncate().dot(w.truncate()) / (1.0 + w.z);
    Vec2::new(in_unit(h / one_minus_cos), turns(w.y, w.x))
}
/// `1 − cos θ` of an angle without cancellation: `2 sin²(θ/2)`.
#[inline(always)]
pub fn one_minus_cos(theta: f32) -> f32 {
    let (s, _) = sin_cos(0.5 * theta);
    2.0 * s * s
}

/// Barycentric coordinates `(b0, b1)` of a point uniform over a triangle, `b2 = 1 − b0 − b1` (Heitz 2019, "A
/// Low-Distortion Map Between Triangle and Square"). The point is `b0·v0 + b1·v1 + b2·v2`.
#[inline(always)]
pub fn triangle(u: Vec2) -> Vec2 {
    if u.x < u.y { Vec2::new(0.5 * u.x, u.y - 0.5 * u.x) } else { Vec2::new(u.x - 0.5 * u.y, 0.5 * u.y) }
}
/// Density of [`triangle`] per unit of the triangle's area.
#[inline(always)]
pub fn triangle_pdf(area: f32) -> f32 {
    1.0 / area
}
/// The point of the unit square that [`triangle`] maps to the barycentric coordinates `(b0, b1)`.
#[inline(always)]
pub fn triangle_invert(b: Vec2) -> Vec2 {
    let u = if b.x > b.y { Vec2::new(b.x + b.y, 2.0 * b.y) } else { Vec2::new(2.0 * b.x, b.x + b.y) };
    Vec2::new(in_unit(u.x), in_unit(u.y))
}
/// Density per steradian, seen from a point, of a density per area: `pdf·d²/cos` (cosine at the surface; 0 at grazing).
#[inline(always)]
pub fn solid_angle_pdf(area_pdf: f32, distance_squared: f32, cos_surface: f32) -> f32 {
    let c = abs(cos_surface);
    if c > 0.0 { area_pdf * distance_squared / c } else { 0.0 }
}

/// A direction around +Z with density `(n + 1)/(2π)·cosⁿθ` (Phong lobe), `n ≥ 0`.
#[inline(always)]
pub fn cosine_power(u: Vec2, n: f32) -> Vec3 {
    ring(super::float::pow(1.0 - u.x, 1.0 / (n + 1.0)), u.y)
}
/// Density of [`cosine_power`] per steradian.
#[inline(always)]
pub fn cosine_power_pdf(cos_theta: f32, n: f32) -> f32 {
    if cos_theta > 0.0 { (n + 1.0) * (0.5 * INV_PI) * super::float::pow(cos_theta, n) } else { 0.0 }
}
/// The point of the unit square that [`cosine_power`] maps to `w`.
#[inline(always)]
pub fn cosine_power_invert(w: Vec3, n: f32) -> Vec2 {
    Vec2::new(in_unit(1.0 - super::float::pow(w.z, n + 1.0)), turns(w.y, w.x))
}

/// Point `i` of the van der Corput sequence in base 2: the bits mirrored at the binary point.
#[inline(always)]
pub fn van_der_corput(i: u32) -> f32 {
    unit(i.reverse_bits())
}
/// Point `i` of the `count` points of the Hammersley set.
#[inline(always)]
pub fn hammersley(i: u32, count: u32) -> Vec2 {
    Vec2::new(min(i as f32 / count as f32, ONE_BELOW), van_der_corput(i))
}
/// Point `i` of the R2 sequence (Roberts 2018, "The Unreasonable Effectiveness of Quasirandom Sequences"): multiples of
/// 1/g and 1/g², g³ = g + 1, in 32-bit fixed point, exact for every `i`.
#[inline(always)]
pub fn r2(i: u32) -> Vec2 {
    const HALF: u32 = 1 << 31;
    let step = |a: u32| unit(HALF.wrapping_add(i.wrapping_mul(a)));
    Vec2::new(step(3_242_174_889), step(2_447_445_414))
}
/// Direction `i` of `count` that cover the sphere evenly: a Fibonacci spiral (Keinert et al. 2015, "Spherical Fibonacci
/// Mapping", eq. 2 and 3).
#[inline(always)]
pub fn spherical_fibonacci(i: u32, count: u32) -> Vec3 {
    // The golden ratio's fraction in 32-bit fixed point.
    let turn = unit(i.wrapping_mul(2_654_435_769));
    ring(1.0 - (2 * i + 1) as f32 / count as f32, turn)
}
/// Solid angle of a cone of a given half angle (rad).
#[inline(always)]
pub fn cone_solid_angle(half_angle: f32) -> f32 {
    2.0 * PI * one_minus_cos(half_angle)
}
/// Half angle (rad) of the cone of a given solid angle.
#[inline(always)]
pub fn cone_half_angle(solid_angle: f32) -> f32 {
    acos(1.0 - solid_angle * (0.5 * INV_PI))
}
/// Solid angle of a triangle seen from the origin (Van Oosterom & Strackee 1983), its corners as unit vectors. Positive
/// where the corners turn counter-clockwise as seen from the origin's far side; negative otherwise.
#[inline(always)]
pub fn triangle_solid_angle(a: Vec3, b: Vec3, c: Vec3) -> f32 {
    2.0 * atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a))
}

/// Cosine between +Z and the edge of the cone that `count` equal cones around the hemisphere would have.
#[inline(always)]
pub fn even_cone_cosine(count: u32) -> f32 {
    cos(cone_half_angle(2.0 * PI / count as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of the open square, in a regular grid of `n²` cells.
    fn grid(n: u32) -> impl Iterator<Item = Vec2> {
        (0..n * n).map(move |i| Vec2::new((i % n) as f32 + 0.5, (i / n) as f32 + 0.5) / n as f32)
    }
    /// Sample, invert, and compare with where it began.
    fn assert_inverts(name: &str, sample: impl Fn(Vec2) -> Vec3, invert: impl Fn(Vec3) -> Vec2, tolerance: f32) {
        for u in grid(101) {
            let back = invert(sample(u));
            assert!((back - u).abs().max_element() < tolerance, "{name}: {u} -> {} -> {back}", sample(u));
            assert!((sample(back) - sample(u)).length() < 4e-6, "{name}: {u}");
        }
    }
    /// Samples must fall into bins of the sphere (16 in z, 16 in azimuth) as often as the density says: the histogram of
    /// 2²⁰ grid samples against the density integrated by 16×16 midpoints per bin.
    fn assert_density(name: &str, sample: impl Fn(Vec2) -> Vec3, pdf: impl Fn(Vec3) -> f32) {
        const BINS: usize = 16;
        let (mut share, mut total) = ([[0f64; BINS]; BINS], 0f64);
        let n = 1024;
        for u in grid(n) {
            let w = sample(u);
            assert!((w.length() - 1.0).abs() < 1e-6, "{name}: {u} -> {w}");
            let (z, t) = (((w.z + 1.0) * 8.0) as usize, (turns(w.y, w.x) * 16.0) as usize);
            share[z.min(BINS - 1)][t] += 1.0 / f64::from(n * n);
        }
        for (i, row) in share.iter().enumerate() {
            for (j, sampled) in row.iter().enumerate() {
                let expected: f64 = grid(16)
                    .map(|p| ring((i as f32 + p.x) / 8.0 - 1.0, (j as f32 + p.y) / 16.0))
                    .map(|w| f64::from(pdf(w)) * f64::from(SPHERE_SR) / 256.0 / 256.0)
                    .sum();
                total += expected;
                assert!((sampled - expected).abs() < 4e-4, "{name} bin {i},{j}: {sampled} against {expected}");
            }
        }
        assert!((total - 1.0).abs() < 2e-3, "{name}: the density integrates to {total}");
    }

    #[test]
    fn densities_are_what_samples_follow() {
        assert_density("cosine", cosine_hemisphere, |w| cosine_hemisphere_pdf(w.z));
        assert_density("sphere", sphere, |_| SPHERE_PDF);
        assert_density("hemisphere", hemisphere, |w| if w.z > 0.0 { HEMISPHERE_PDF } else { 0.0 });
        let h = 0.75; // an edge of the histogram's bins
        assert_density("cone", |u| cone(u, h), |w| if w.z > 1.0 - h { cone_pdf(h) } else { 0.0 });
        for n in [0.0, 1.0, 20.0] {
            assert_density("power", |u| cosine_power(u, n), |w| cosine_power_pdf(w.z, n));
        }
    }

    #[test]
    fn inverses_return_to_the_square() {
        assert_inverts("disk", |u| disk(u).extend(0.0), |w| disk_invert(w.truncate()), 1e-6);
        assert_inverts("cosine", cosine_hemisphere, cosine_hemisphere_invert, 1e-6);
        assert_inverts("sphere", sphere, sphere_invert, 1e-6);
        assert_inverts("hemisphere", hemisphere, hemisphere_invert, 1e-6);
        assert_inverts("triangle", |u| triangle(u).extend(0.0), |w| triangle_invert(w.truncate()), 1e-6);
        assert_inverts("power", |u| cosine_power(u, 5.0), |w| cosine_power_invert(w, 5.0), 2e-5);
        for theta in [1e-4, 0.02, 0.5, 3.0] {
            let h = one_minus_cos(theta);
            assert_inverts("cone", |u| cone(u, h), |w| cone_invert(w, h), 3e-6);
        }
    }

    #[test]
    fn square_corners_stay_inside() {
        for u in [Vec2::ZERO, Vec2::splat(ONE_BELOW), Vec2::new(0.0, ONE_BELOW), Vec2::new(0.5, 0.5)] {
            for w in [cosine_hemisphere(u), hemisphere(u), cone(u, 1.0)] {
                assert!(w.z >= 0.0 && (w.length() - 1.0).abs() < 1e-6, "{u} -> {w}");
            }
            let (b, back) = (triangle(u), disk_invert(disk(u)));
            assert!(b.min_element() >= 0.0 && b.x + b.y <= 1.0, "{b}");
            assert!(back.min_element() >= 0.0 && back.max_element() < 1.0 && (back - u).length() < 1e-6, "{back}");
        }
    }

    #[test]
    fn triangle_samples_are_uniform() {
        // Uniform over a triangle: mean 1/3 and variance 1/18 of each coordinate; a quarter of the area lies in each
        // half-size corner.
        let (mut mean, mut square, mut corner) = (Vec2::ZERO, Vec2::ZERO, 0);
        let n = 512;
        for b in grid(n).map(triangle) {
            mean += b / (n * n) as f32;
            square += b * b / (n * n) as f32;
            corner += u32::from(b.x > 0.5);
        }
        assert!((mean - 1.0 / 3.0).abs().max_element() < 1e-3, "{mean}");
        assert!((square - mean * mean - 1.0 / 18.0).abs().max_element() < 1e-3);
        assert!((f64::from(corner) / f64::from(n * n) - 0.25).abs() < 2e-3);
        let area_pdf = triangle_pdf(0.5);
        assert_eq!((area_pdf, solid_angle_pdf(area_pdf, 4.0, -0.5), solid_angle_pdf(1.0, 1.0, 0.0)), (2.0, 16.0, 0.0));
    }

    #[test]
    fn point_sets_are_spread_evenly() {
        assert_eq!([0, 1, 2, 3].map(van_der_corput), [0.0, 0.5, 0.25, 0.75]);
        assert_eq!(hammersley(3, 8), Vec2::new(0.375, 0.75));
        // The star discrepancy over boxes at the origin, for 1024 points: random points reach about 0.03.
        for (name, set) in [("r2", (|i| r2(i)) as fn(u32) -> Vec2), ("hammersley", |i| hammersley(i, 1024))] {
            let points: alloc::vec::Vec<Vec2> = (0..1024).map(set).collect();
            for corner in grid(33).map(|p| p + 0.5 / 33.0) {
                let inside = points.iter().filter(|p| p.x < corner.x && p.y < corner.y).count() as f32 / 1024.0;
                assert!((inside - corner.x * corner.y).abs() < 0.008, "{name} {corner}: {inside}");
            }
        }
        // The constants are 2³²/g and 2³²/g² for the real root of g³ = g + 1.
        let g = 1.324_717_957_244_746_f64;
        assert_eq!((4_294_967_296.0 / g).round(), 3_242_174_889.0);
        assert_eq!((4_294_967_296.0 / g / g).round(), 2_447_445_414.0);
    }

    #[test]
    fn fibonacci_directions_integrate_polynomials() {
        let n = 1000;
        let mean = |f: fn(Vec3) -> f32| (0..n).map(|i| f(spherical_fibonacci(i, n))).sum::<f32>() / n as f32;
        assert!(mean(|w| w.x).abs() < 1e-3 && mean(|w| w.z).abs() < 1e-5 && mean(|w| w.x * w.y).abs() < 1e-3);
        assert!((mean(|w| w.z * w.z) - 1.0 / 3.0).abs() < 1e-5 && (mean(|w| w.x * w.x) - 1.0 / 3.0).abs() < 1e-3);
        let nearest = (1..n).map(|i| (spherical_fibonacci(i, n) - spherical_fibonacci(0, n)).length());
        assert!(nearest.fold(9.0, f32::min) > 0.06, "no two directions coincide");
    }

    #[test]
    fn solid_angles_have_their_closed_forms() {
        assert!((triangle_solid_angle(Vec3::X, Vec3::Y, Vec3::Z) - PI / 2.0).abs() < 1e-6);
        assert!((triangle_solid_angle(Vec3::X, Vec3::Z, Vec3::Y) + PI / 2.0).abs() < 1e-6);
        assert!((cone_solid_angle(PI) - SPHERE_SR).abs() < 2e-6 && (cone_half_angle(2.0 * PI) - PI / 2.0).abs() < 1e-6);
        assert!((cone_half_angle(cone_solid_angle(0.4)) - 0.4).abs() < 1e-6);
        assert!((even_cone_cosine(6) - 5.0 / 6.0).abs() < 1e-6);
    }
}
