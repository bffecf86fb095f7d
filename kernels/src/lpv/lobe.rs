//! Intensities of order 1: the flux that they send through the faces of the neighbouring cells.
//!
//! A cell's light is a constant `a` and a vector `b`: the intensity in direction ω is `max(0, a + b·ω)` (W/sr). Around a
//! cell lie six neighbours, each with one face opposite (facing) and four sides: 30 faces, whose solid angles seen from
//! the cell's centre add up to the whole sphere (Kaplanyan & Dachsbacher 2010, §4.3, figure 4).

use crate::real::Real;
use interreflect_shared::lpv::LpvParams;

/// Solid angle (sr) of the facing face of a neighbour: `4·atan(¼ / (3/2·√11/2))`.
pub const FACING_SR: f32 = 0.400_669_68;
/// Solid angle (sr) of a side face of a neighbour: `2·(atan(3/√11) − atan(1/√3))`.
pub const SIDE_SR: f32 = 0.423_431_35;
/// Component of the direction to a side face along the way to the neighbour: 2/√5.
pub const ALONG: f32 = 0.894_427_2;
/// Component of the direction to a side face across that way: 1/√5.
pub const ACROSS: f32 = 0.447_213_6;

/// Intensities (W/sr) towards the faces of one neighbour: flux per solid angle.
#[derive(Clone, Copy)]
pub struct Sent<R> {
    /// Towards the facing face.
    pub facing: R,
    /// Sum of those towards the four sides.
    pub sides: R,
    /// Towards the side in the positive direction of the next axis in cyclic order, less that towards the opposite one.
    pub next: R,
    /// The same for the axis after that.
    pub last: R,
}

impl<R: Real> Sent<R> {
    /// From the constant, and the vector's components along the way to the neighbour and across it.
    #[inline(always)]
    pub fn new(a: R, along: R, next: R, last: R) -> Self {
        let side = along.mul_add(R::splat(ALONG), a);
        let (up, down) = (R::splat(ACROSS), R::splat(-ACROSS));
        let (n0, n1) = (next.mul_add(up, side).positive(), next.mul_add(down, side).positive());
        let (l0, l1) = (last.mul_add(up, side).positive(), last.mul_add(down, side).positive());
        Self { facing: (a + along).positive(), sides: (n0 + n1) + (l0 + l1), next: n0 - n1, last: l0 - l1 }
    }
    /// Flux (W) through all five faces.
    #[inline(always)]
    pub fn flux(&self) -> R {
        self.facing.mul_add(R::splat(FACING_SR), self.sides * R::splat(SIDE_SR))
    }
}

/// What an intensity sends to all neighbours.
#[derive(Clone, Copy)]
pub struct Outflow<R> {
    /// Flux (W) to the neighbours +x, −x, +y, −y, +z, −z.
    pub to: [R; 6],
    /// All of it.
    pub flux: R,
    /// Its first moment: Σ flux · direction to the face.
    pub moment: [R; 3],
}

/// Sends an intensity through all 30 faces.
#[inline(always)]
pub fn outflow<R: Real>(a: R, b: [R; 3]) -> Outflow<R> {
    let mut to = [R::splat(0.0); 6];
    // In units of what an intensity towards a side adds across the way.
    let mut moment = [R::splat(0.0); 3];
    unroll!(AXIS in 0, 1, 2 => {
        const NEXT: usize = (AXIS + 1) % 3;
        const LAST: usize = (AXIS + 2) % 3;
        let up = Sent::new(a, b[AXIS], b[NEXT], b[LAST]);
        let down = Sent::new(a, -b[AXIS], b[NEXT], b[LAST]);
        to[2 * AXIS] = up.flux();
        to[2 * AXIS + 1] = down.flux();
        let sides = (up.sides - down.sides).mul_add(R::splat(ALONG / ACROSS), moment[AXIS]);
        moment[AXIS] = (up.facing - down.facing).mul_add(R::splat(FACING_SR / (SIDE_SR * ACROSS)), sides);
        moment[NEXT] = moment[NEXT] + (up.next + down.next);
        moment[LAST] = moment[LAST] + (up.last + down.last);
    });
    let flux = ((to[0] + to[1]) + (to[2] + to[3])) + (to[4] + to[5]);
    let unit = R::splat(SIDE_SR * ACROSS);
    Outflow { to, flux, moment: [moment[0] * unit, moment[1] * unit, moment[2] * unit] }
}

/// One colour channel of a cell: what travels on, and what it adds to the light that has passed.
#[derive(Clone, Copy)]
pub struct Travelling<R> {
    /// Constant of the intensity (W/sr).
    pub a: R,
    /// Vector of the intensity.
    pub b: [R; 3],
    /// Factor of the moment of whatever arrives from here.
    pub moment_factor: R,
    /// Spherical-harmonics coefficients (1; y, z, x; 3z² − 1, x² − y²) of the intensity whose clamped cosine gives the
    /// flux through each of the cell's six faces.
    pub passed: [R; 6],
}

/// Square of the moment per flux below which its factor is not told from 1.
const SMALL_MOMENT: f32 = 1e-4;
/// Mean cosine up to which a lobe of order 1 is nowhere negative.
const WIDEST: f32 = 1.0 / 3.0;
/// Least flux that is kept: its square is a normal number.
const LEAST_FLUX: f32 = 1e-18;
const INV_4_PI: f32 = 0.25 * core::f32::consts::FRAC_1_PI;
/// `Y₀₀`.
const Y0: f32 = 0.282_094_8;
/// `√(4π/3)·9/(8π)`: from net flux through opposite faces to a coefficient of band 1. A clamped cosine over the radiance
/// `I / (3/2 s²)` then gives half the net flux per face; the constant gives a sixth of the flux.
const BAND1_PER_NET: f32 = 0.732_903_8;
/// `6/√(5π)`: from the flux through both faces of the z axis, beyond a third of all, to the coefficient of 3z² − 1.
const BAND2_PER_EXCESS: f32 = 1.513_880_5;
/// `6/√(15π)`: from the flux through the x faces beyond that through the y faces to the coefficient of x² − y².
const BAND2_PER_DIFFERENCE: f32 = 0.874_039_3;

/// How lobes are made of flux and moment.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Lobes {
    /// 1: a cell sends exactly its flux; 0: what the clamp makes of it.
    pub gain: f32,
    /// 1: the first moment is kept; 0: what the clamp leaves of it.
    pub restore: f32,
    /// Largest mean cosine of a lobe; up to a third: lobes are order-1 spherical harmonics.
    pub focus: f32,
}

impl Lobes {
    /// Those of a pass.
    #[inline(always)]
    pub fn of(p: &LpvParams) -> Self {
        Self { gain: p.gain, restore: p.lobe.w, focus: p.focus }
    }
}

/// A lobe of unit flux: its constant, and its vector over the moment that it is made of.
#[derive(Clone, Copy)]
struct Line<R> {
    constant: R,
    slope: R,
}

impl<R: Real> Line<R> {
    /// From the mean cosine `f`, the moment's length and its factor to unit flux, so that `f` is their product. `u` is t + 1 of
    /// [`travel`], as far as `focus` goes; the line's slope is 4 / (4π u²).
    #[inline(always)]
    fn new(f: R, length: R, per_moment: R, focus: f32) -> Self {
        let u = f.min(R::splat(focus.max(WIDEST))).mul_add(R::splat(-3.0), R::splat(3.0));
        let narrow = R::splat(4.0 * INV_4_PI) / (u * u * length);
        let narrow_constant = (u - R::splat(1.0)) * (narrow * length);
        let is_wide = f.lt(R::splat(if focus > WIDEST { WIDEST } else { 2.0 }));
        Self {
            constant: R::select(is_wide, R::splat(INV_4_PI), narrow_constant),
            slope: R::select(is_wide, R::splat(3.0 * INV_4_PI) * per_moment, narrow),
        }
    }
}

/// `|v|²`.
#[inline(always)]
fn square_length<R: Real>(v: [R; 3]) -> R {
    v[2].mul_add(v[2], v[1].mul_add(v[1], v[0] * v[0]))
}

/// Makes flux and first moment (`[Φ, Mx, My, Mz]`) travel.
///
/// `gain` 1: the intensity is scaled so that the 30 faces receive exactly Φ. The clamp alone would make more of it: a
/// clamped-cosine lobe along an axis, kept to order 1, sends 1.1382 times its flux. `restore` 1: moments of what arrives
/// are scaled so that the first moment is kept as well, as in free flight; the clamp would turn light away from its
/// direction at every step.
///
/// Up to a mean cosine f of a third the lobe is order 1, `(1 + 3f cos θ)/4π`. Beyond, order 1 would be negative behind, and the clamp
/// would leave less than f; with `focus` the lobe is the clamped line that has it: `max(0, t + cos θ)` with t = 2 − 3f, which is the
/// clamped cosine of a diffuse surface at f = ⅔, and narrower for light from a small source.
#[inline(always)]
pub fn travel<R: Real>(flux: [R; 4], lobes: &Lobes) -> Travelling<R> {
    let (zero, one) = (R::splat(0.0), R::splat(1.0));
    let lit = R::splat(LEAST_FLUX).lt(flux[0]);
    let phi = R::select(lit, flux[0], zero);
    let moment = [flux[1], flux[2], flux[3]];
    // Mean cosine; no light is more than fully directed.
    let length = square_length(moment).sqrt();
    let per_moment = one / R::select(lit, phi, one).max(length);
    let f = length * per_moment;
    let line = Line::new(f, length, per_moment, lobes.focus);
    let sent = outflow(line.constant, [moment[0] * line.slope, moment[1] * line.slope, moment[2] * line.slope]);
    // Every quotient by what is sent at once: a division waits for the one before it.
    let exact = phi / sent.flux;
    let scaled = sent.flux.mul_add(R::splat(1.0 - lobes.gain), R::splat(lobes.gain));
    let (small, sent_square) = (R::splat(SMALL_MOMENT), sent.flux * sent.flux);
    let kept = (square_length(sent.moment) * scaled).mul_add(scaled, small * sent_square);
    let factor = (f.mul_add(f, small) * sent_square / kept).sqrt();
    let factor = factor.mul_add(R::splat(lobes.restore), R::splat(1.0 - lobes.restore));
    let strength = exact * scaled;
    let slope = strength * line.slope;
    Travelling {
        a: strength * line.constant,
        b: [moment[0] * slope, moment[1] * slope, moment[2] * slope],
        moment_factor: R::select(lit, factor, one),
        passed: passed(phi, exact, &sent.to, f.lt(R::splat(WIDEST))),
    }
}

/// [`Travelling::passed`] of flux `phi`, of which the six neighbours get `to` times `exact`. What is wide has no band 2: there it would be
/// the rounding of a difference of equal numbers.
#[inline(always)]
fn passed<R: Real>(phi: R, exact: R, to: &[R; 6], is_wide: R::Mask) -> [R; 6] {
    let net = exact * R::splat(BAND1_PER_NET);
    let [x, y, z] = [to[0] + to[1], to[2] + to[3], to[4] + to[5]];
    let excess = z.mul_add(exact, phi * R::splat(-1.0 / 3.0));
    [
        phi * R::splat(Y0),
        (to[2] - to[3]) * net,
        (to[4] - to[5]) * net,
        (to[0] - to[1]) * net,
        R::select(is_wide, R::splat(0.0), excess * R::splat(BAND2_PER_EXCESS)),
        R::select(is_wide, R::splat(0.0), (x - y) * (exact * R::splat(BAND2_PER_DIFFERENCE))),
    ]
}

#[cfg(test)]
mod tests {
    use super::super::query::expansion;
    use super::*;
    use crate::math::sampling::spherical_fibonacci;
    use core::f64::consts::PI;

    const PAPER: Lobes = Lobes { gain: 0.0, restore: 0.0, focus: 0.0 };
    const KEPT: Lobes = Lobes { gain: 1.0, restore: 1.0, focus: 0.85 };

    /// Solid angle of a rectangle from (0, 0) to (x, y) in a plane at height h.
    fn corner(x: f64, y: f64, h: f64) -> f64 {
        (x * y / (h * (x * x + y * y + h * h).sqrt())).atan()
    }

    #[test]
    fn solid_angles_are_those_of_the_faces() {
        // Facing: a unit square at distance 3/2. Side: from 1/2 to 3/2 away in the plane at distance 1/2.
        let facing = 4.0 * corner(0.5, 0.5, 1.5);
        let side = 2.0 * (corner(1.5, 0.5, 0.5) - corner(0.5, 0.5, 0.5));
        assert!((facing - 0.400_669_684_6).abs() < 1e-9 && (f64::from(FACING_SR) - facing).abs() < 3e-8, "{facing}");
        // The papers print 0.4234413544 for the side; the fifth digit must be a 3, or the faces would cover 2·10⁻⁵ more than
        // the sphere, and every step of propagation would gain as much.
        assert!((side - 0.423_431_354_4).abs() < 1e-9 && (f64::from(SIDE_SR) - side).abs() < 3e-8, "{side}");
        // Thirty faces and nothing else cover the sphere.
        assert!((6.0 * (facing + 4.0 * side) - 4.0 * PI).abs() < 1e-12);
        // By counting directions: the share of the sphere that leaves through the side of the neighbour at +x.
        let n = 400_000;
        let hits = (0..n).map(|i| spherical_fibonacci(i, n)).filter(|d| {
            d.x > 0.0 && {
                let at = d.y.abs().max(d.z.abs()) / d.x;
                at < 1.0 && d.y > d.z.abs() && d.y / d.x * 1.5 > 0.5
            }
        });
        let counted = hits.count() as f64 * 4.0 * PI / f64::from(n);
        assert!((counted - side).abs() < 1e-3, "{counted} {side}");
    }

    fn cosine_lobe(d: [f32; 3]) -> [f32; 4] {
        [1.0, d[0] * 2.0 / 3.0, d[1] * 2.0 / 3.0, d[2] * 2.0 / 3.0]
    }

    #[test]
    fn the_clamp_gains_what_the_negative_lobe_would_take() {
        let lobe = travel::<f32>(cosine_lobe([0.0, 1.0, 0.0]), &PAPER);
        let sent = outflow(lobe.a, lobe.b).flux;
        // Negative towards the neighbour behind: facing −1/4, sides 1/4 − 1/√5, per π and unit flux.
        let behind = 0.25 * 0.400_669_684_6 + 4.0 * 0.423_431_354_4 * (0.447_213_595_5 - 0.25);
        let expected = 1.0 + behind / PI;
        assert!((f64::from(sent) - expected).abs() < 1e-6 && (expected - 1.1382).abs() < 1e-4, "{sent} {expected}");
        // In any direction, and at any strength, between 1 and the bound of a fully directed lobe.
        for i in 0..2000 {
            let d = spherical_fibonacci(i, 2000).to_array();
            for f in [0.0, 0.2, 1.0 / 3.0, 0.5, 2.0 / 3.0, 1.0] {
                let t = travel::<f32>([1.0, d[0] * f, d[1] * f, d[2] * f], &PAPER);
                let gain = outflow(t.a, t.b).flux;
                assert!(gain > 1.0 - 1e-6 && gain < 1.4, "{d:?} {f}: {gain}");
                assert!(f > 0.33 || (gain - 1.0).abs() < 1e-6, "nothing is clamped at {f}: {gain}");
            }
        }
    }

    #[test]
    fn corrected_lobes_send_their_flux_and_moment() {
        for i in 0..2000 {
            let d = spherical_fibonacci(i, 2000).to_array();
            for f in [0.0, 0.2, 0.5, 2.0 / 3.0, 1.0] {
                let t = travel::<f32>([3.0, 3.0 * d[0] * f, 3.0 * d[1] * f, 3.0 * d[2] * f], &KEPT);
                let sent = outflow(t.a, t.b);
                assert!((sent.flux - 3.0).abs() < 3e-6, "{d:?} {f}: {}", sent.flux);
                let m = sent.moment.map(|m| m * t.moment_factor / 3.0);
                let length = (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]).sqrt();
                assert!((length - f).abs() < 2e-3, "{d:?} {f}: {length}");
                // The flux through each face comes back from the coefficients by a clamped cosine over the cell's cross-section.
                for (k, &to) in sent.to.iter().enumerate() {
                    let mut way = [0.0; 3];
                    way[k / 2] = if k % 2 == 0 { 1.0 } else { -1.0 };
                    let e = crate::math::sh::irradiance(&expansion(&t.passed), way) / 1.5;
                    assert!((e - to).abs() < 1e-5, "{d:?} {f}, face {k}: {e} {to}");
                }
            }
        }
        let dark = travel::<f32>([0.0; 4], &KEPT);
        assert_eq!((dark.a, dark.b, dark.passed, dark.moment_factor), (0.0, [0.0; 3], [0.0; 6], 1.0));
    }
}
