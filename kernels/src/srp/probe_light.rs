//! Light of the probes at points that no transport was precomputed for: dynamic objects.
//!
//! One invocation: the irradiance at one point with a normal. Grid: points. Silvennoinen & Lehtinen 2017, §3 ("dynamic objects
//! can receive indirect illumination by … (ir)radiance volumes") and the comparison of GI methods cited as "000", §5.10:
//! every probe in whose support the point lies gives its irradiance for the normal (Ramamoorthi & Hanrahan 2001, eq. 13, up
//! to order 2), weighted by distance (eq. 10). Blind to what stands between probe and point, so that light leaks through
//! walls thinner than the support; zero where no probe reaches. Before: [`super::probe_sum`].

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::max;
use crate::math::sh::{self, clamped_cosine_factor};
use crate::math::vector::length;
use glam::{Vec3, Vec4};
use interreflect_shared::scene::Surfel;
use interreflect_shared::srp::SrpProbeLightParams;

/// Points.
pub fn points(p: &SrpProbeLightParams) -> Rows {
    Rows::all(p.count)
}

/// The support's weight at a share of its radius: `2t³ − 3t² + 1`, 0 beyond (Silvennoinen & Lehtinen 2017, eq. 10).
#[inline(always)]
pub fn support(t: f32) -> f32 {
    if t < 1.0 { (2.0 * t - 3.0) * t * t + 1.0 } else { 0.0 }
}

/// Factors of order-2 coefficients of radiance whose sum is irradiance for a normal.
#[inline(always)]
pub fn cosine_lobe(normal: Vec3) -> [f32; 9] {
    let y: [f32; 9] = sh::basis(normal.to_array());
    let mut lobe = [0.0; 9];
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7, 8 => { lobe[K] = y[K] * const { clamped_cosine_factor(sh::band(K)) }; });
    lobe
}

/// Irradiance (W/m²) that one probe's coefficients give; `first`: index of its first coefficient of a channel.
#[inline(always)]
fn channel(lobe: &[f32; 9], coefs: &[f32], first: usize, count: u32) -> f32 {
    let mut sum = 0.0;
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7, 8 => {
        if (K as u32) < count {
            sum += lobe[K] * coefs[first + K];
        }
    });
    sum
}

/// Irradiance (W/m², not negative, w = 0) at point `i`. `probes`: positions (w unused); `coefs`: λ in planes `[channel]`.
#[inline(always)]
pub fn light(i: u32, p: &SrpProbeLightParams, probes: &[Vec4], coefs: &[f32], surfels: &[Surfel]) -> Vec4 {
    let position = Vec3::from_array(surfels[i as usize].position);
    let lobe = cosine_lobe(Vec3::from_array(surfels[i as usize].normal));
    let (mut sum, mut weight) = (Vec3::ZERO, 0.0);
    let plane = p.coef_plane as usize;
    for probe in 0..p.probe_count {
        let w = support(length(probes[probe as usize].truncate() - position) / p.radius);
        if w > 0.0 {
            let first = (probe * p.coefficient_count) as usize;
            sum += w * Vec3::new(
                channel(&lobe, coefs, first, p.coefficient_count),
                channel(&lobe, coefs, plane + first, p.coefficient_count),
                channel(&lobe, coefs, 2 * plane + first, p.coefficient_count),
            );
            weight += w;
        }
    }
    let mean = if weight > 0.0 { sum / weight } else { Vec3::ZERO };
    Vec4::new(max(mean.x, 0.0), max(mean.y, 0.0), max(mean.z, 0.0), 0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let order = input.bits() % 4;
    let probe_count = 1 + input.bits() % 12;
    let coefficient_count = (order + 1) * (order + 1);
    let coef_plane = probe_count * coefficient_count + 16;
    let p = SrpProbeLightParams {
        count: input.count as u32,
        probe_count,
        coefficient_count,
        coef_plane,
        radius: 1.0 + input.unit(),
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
    };
    let probes: alloc::vec::Vec<Vec4> = (0..probe_count).map(|_| (1.5 * input.direction()).extend(0.0)).collect();
    let mut coefs = super::case_floats(input, 3 * coef_plane as usize);
    if input.flavour == crate::kernel::Flavour::Huge {
        // Only band 0: terms of both signs that cancel have no digit in common on two devices.
        for (at, c) in coefs.iter_mut().enumerate() {
            *c *= if (at as u32 % coef_plane).is_multiple_of(coefficient_count) { 1.0 } else { 0.0 };
        }
    }
    let surfels: alloc::vec::Vec<Surfel> = (0..input.count).map(|_| crate::trace::case::surfel(input)).collect();
    Case::default().uniform(&p).read(&probes).read(&coefs).read(&surfels).zeroed::<Vec4>(input.count)
}

kernel! {
    /// Probe coefficients to irradiance at free points.
    mod srp_probe_light = super::light; entry "srp_probe_light" threads(64);
    uniform 0 params: SrpProbeLightParams;
    read 1 probes: Vec4;
    read 2 coefs: f32;
    read 3 surfels: Surfel;
    write 4 irradiance: Vec4;
    over super::points;
    case super::case; tolerance Tolerance::RelAbs(1e-4, 2e-5), "weights at the rim of a support that divide each other; nine terms that may cancel";
}
