//! Approximate glossy reflection from order-1 radiance.
//!
//! One invocation: the reflected radiance of one point. Grid: points. Silvennoinen & Lehtinen 2017, §5.1 "Glossy Materials":
//! the linear terms of the expansion are taken for one directional light (Sloan 2008, "Stupid Spherical Harmonics Tricks",
//! "Extracting dominant light sources"), seen through Cook–Torrance with the GGX distribution and Smith's masking
//! (Walter et al. 2007; the height-correlated form of Heitz 2014) and Schlick's Fresnel factor. Good for rough surfaces
//! under one dominant light; a mirror sees one blurred light and nothing of the scene. Before:
//! [`super::reconstruct`] (`srp_reconstruct_directional`).

use super::normals::blended;
use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{PI, clamp, max, sqrt};
use crate::math::vector::normalize_or;
use glam::{Vec3, Vec4};
use interreflect_shared::scene::Surfel;
use interreflect_shared::srp::{SrpBlend, SrpGloss, SrpResolveParams};

/// Points.
pub fn points(p: &SrpResolveParams) -> Rows {
    Rows::all(p.count)
}

/// Length of the linear coefficients of a directional light of irradiance 1: `√(3/4π)`.
const LINEAR: f32 = 0.488_602_5;
/// Luminance of linear Rec. 709.
const LUMINANCE: Vec3 = Vec3::new(0.2126, 0.7152, 0.0722);
/// Narrowest GGX distribution: below it a lobe is narrower than floats of its formula resolve.
const SMALLEST_ALPHA: f32 = 0.01;

/// The directional light that order-1 radiance stands for: unit direction towards it (the luminance's), and its
/// perpendicular irradiance (W/m²). Arguments: the four coefficients of each channel. Without linear terms: no light.
#[inline(always)]
pub fn dominant_light(red: [f32; 4], green: [f32; 4], blue: [f32; 4]) -> (Vec3, Vec3) {
    // Y₁ is (y, z, x).
    let (r, g, b) = (
        Vec3::new(red[3], red[1], red[2]),
        Vec3::new(green[3], green[1], green[2]),
        Vec3::new(blue[3], blue[1], blue[2]),
    );
    let direction = normalize_or(r * LUMINANCE.x + g * LUMINANCE.y + b * LUMINANCE.z, Vec3::Y);
    let along = |linear: Vec3| max(linear.dot(direction), 0.0) * (1.0 / LINEAR);
    (direction, Vec3::new(along(r), along(g), along(b)))
}

/// Radiance towards `wo` of a surface under a directional light from `wi` of perpendicular irradiance 1: the GGX lobe times
/// the cosine, without Fresnel's factor, and the cosine between half vector and light. Zero from behind.
#[inline(always)]
pub fn ggx(wi: Vec3, wo: Vec3, normal: Vec3, alpha: f32) -> (f32, f32) {
    let (n_i, n_o) = (normal.dot(wi), normal.dot(wo));
    let half = normalize_or(wi + wo, normal);
    let (n_h, i_h) = (clamp(normal.dot(half), 0.0, 1.0), clamp(wi.dot(half), 0.0, 1.0));
    let a2 = max(alpha, SMALLEST_ALPHA) * max(alpha, SMALLEST_ALPHA);
    // sin² + α² cos², which keeps its digits where the half vector is close to the normal.
    let across = normal.cross(half);
    let spread = across.dot(across) + a2 * n_h * n_h;
    let distribution = a2 / (PI * max(spread * spread, f32::MIN_POSITIVE));
    let masked_i = n_o * sqrt(max(n_i * n_i * (1.0 - a2) + a2, 0.0));
    let masked_o = n_i * sqrt(max(n_o * n_o * (1.0 - a2) + a2, 0.0));
    let lit = n_i > 0.0 && n_o > 0.0;
    let value = distribution * 0.5 / max(masked_i + masked_o, f32::MIN_POSITIVE) * n_i;
    (if lit { value } else { 0.0 }, i_h)
}

/// Schlick's approximation of Fresnel's factor.
#[inline(always)]
pub fn schlick(f0: Vec3, cosine: f32) -> Vec3 {
    let x = 1.0 - cosine;
    f0 + (Vec3::ONE - f0) * (x * x * x * x * x)
}

/// Reflected radiance (rgb, W/(sr m²), w = 0) of point `i` towards its viewer. `radiance` in planes
/// `[3·coefficient + channel][slot]`.
#[inline(always)]
pub fn glossy(
    i: u32,
    p: &SrpResolveParams,
    blends: &[SrpBlend],
    radiance: &[f32],
    surfels: &[Surfel],
    gloss: &[SrpGloss],
) -> Vec4 {
    let (blend, gloss) = (blends[i as usize], gloss[i as usize]);
    let normal = Vec3::from_array(surfels[i as usize].normal);
    let (wi, irradiance) = dominant_light(
        blended(&blend, 0, radiance, p.slot_count),
        blended(&blend, 1, radiance, p.slot_count),
        blended(&blend, 2, radiance, p.slot_count),
    );
    let (lobe, cosine) = ggx(wi, Vec3::from_array(gloss.wo), normal, gloss.alpha);
    (irradiance * schlick(Vec3::from_array(gloss.f0), cosine) * lobe).extend(0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let slot_count = 64;
    let p = SrpResolveParams { count: input.count as u32, slot_count, _pad0: 0, _pad1: 0 };
    let blends = super::resolve::case_blends(input, input.count, slot_count);
    // Light from above throughout: the direction of what nearly cancels is anybody's.
    let mut radiance = super::case_floats(input, 12 * slot_count as usize);
    let above = 6 * slot_count as usize..9 * slot_count as usize;
    radiance[above].iter_mut().for_each(|x| *x = 4.0 * x.abs() + if *x == 0.0 { 0.0 } else { 2.0 * x.abs().max(1e-3) });
    let gloss = |input: &mut CaseInput| SrpGloss {
        wo: input.direction().to_array(),
        alpha: 0.2 + 0.8 * input.unit(),
        f0: [input.unit(), input.unit(), input.unit()],
        _pad0: 0,
    };
    let gloss: alloc::vec::Vec<SrpGloss> = (0..input.count).map(|_| gloss(input)).collect();
    let surfels: alloc::vec::Vec<Surfel> = (0..input.count).map(|_| crate::trace::case::surfel(input)).collect();
    let case = Case::default().uniform(&p).read(&blends).read(&radiance).read(&surfels).read(&gloss);
    case.zeroed::<Vec4>(input.count)
}

kernel! {
    /// Order-1 radiance to glossy reflection.
    mod srp_glossy = super::glossy; entry "srp_glossy" threads(64);
    uniform 0 params: SrpResolveParams;
    read 1 blends: SrpBlend;
    read 2 radiance: f32;
    read 3 surfels: Surfel;
    read 4 gloss: SrpGloss;
    write 5 reflected: Vec4;
    over super::points;
    case super::case; tolerance Tolerance::RelAbs(1e-3, 1e-4), "a direction from sums that cancel in part, its error magnified by the slope of a lobe of width 0.2 (25 times) and by grazing masking";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_directional_light_is_found_again() {
        let direction = Vec3::new(0.48, -0.6, 0.64);
        let y: [f32; 4] = crate::math::sh::basis(direction.to_array());
        let (found, irradiance) = dominant_light(y.map(|y| 2.0 * y), y.map(|y| 3.0 * y), y.map(|y| 0.5 * y));
        assert!((found - direction).length() < 1e-6);
        assert!((irradiance - Vec3::new(2.0, 3.0, 0.5)).abs().max_element() < 1e-5);
        assert_eq!(dominant_light([1.0, 0.0, 0.0, 0.0], [1.0; 4].map(|_| 0.0), [0.0; 4]).1, Vec3::ZERO);
    }

    #[test]
    fn reflected_light_never_exceeds_what_arrives() {
        // Directional albedo: the lobe integrated over all viewers, by a fine grid of the hemisphere.
        for (alpha, cosine) in [(0.1f32, 0.9f32), (0.3, 0.5), (0.7, 0.3), (1.0, 0.999_999)] {
            let wi = Vec3::new((1.0 - cosine * cosine).sqrt(), 0.0, cosine);
            let (mut sum, steps) = (0.0f64, 600);
            for t in 0..steps {
                for f in 0..steps {
                    let z = (t as f32 + 0.5) / steps as f32;
                    let phi = (f as f32 + 0.5) / steps as f32 * 2.0 * PI;
                    let s = (1.0 - z * z).sqrt();
                    let wo = Vec3::new(s * phi.cos(), s * phi.sin(), z);
                    // The value holds the light's cosine: divide it out, and take the viewer's instead (reciprocity).
                    sum += f64::from(ggx(wi, wo, Vec3::Z, alpha).0 / cosine * z);
                }
            }
            let albedo = sum * 2.0 * std::f64::consts::PI / f64::from(steps * steps);
            // Single scattering keeps nearly all light on smooth surfaces and loses some on rough ones.
            let range = match alpha {
                ..0.2 => 0.97..1.005,
                // In closed form for light from above: ∫ μ/(1 + μ) dμ over the cosine of all viewers.
                1.0.. => 1.0 - std::f64::consts::LN_2 - 1e-3..1.0 - std::f64::consts::LN_2 + 1e-3,
                _ => 0.5..1.0,
            };
            assert!(range.contains(&albedo), "alpha {alpha}, cosine {cosine}: {albedo}");
        }
    }
}
