//! Order-1 radiance to irradiance: at every receiver for its own normal, and at points for any normal.
//!
//! `srp_receiver_irradiance`: one invocation, one receiver; feeds further bounces where receivers hold four rows.
//! `srp_normal_mapped`: one invocation, one point with the shading normal of a normal map. Silvennoinen & Lehtinen 2017,
//! §5.1: the order-1 version of Ramamoorthi & Hanrahan 2001. Good for bumps; an order-1 expansion of a sharp light is too
//! smooth, and negative away from it: the result is clamped at the point, never in the loop of bounces. Before:
//! [`super::reconstruct`] (`srp_reconstruct_directional`).

use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::max;
use crate::math::sh;
use crate::real::Real;
use glam::Vec4;
use interreflect_shared::scene::Surfel;
use interreflect_shared::srp::{SRP_LANES, SrpBlend, SrpResolveParams};

/// One row per vector of slots.
pub fn rows(p: &SrpResolveParams) -> Rows {
    Rows { count: p.slot_count / SRP_LANES, len: SRP_LANES, pitch: SRP_LANES, first: 0, plane: p.slot_count }
}
/// Points.
pub fn points(p: &SrpResolveParams) -> Rows {
    Rows::all(p.count)
}

/// Irradiance (W/m²) at a receiver. `normals` in planes `[axis][slot]`, `radiance` in planes `[3·coefficient + channel]`.
#[inline(always)]
pub fn irradiance<R: Real>(at: At, p: &SrpResolveParams, normals: &[f32], radiance: &[f32]) -> [R; 3] {
    let plane = p.slot_count as usize;
    let normal = [R::load(normals, at.i), R::load(normals, plane + at.i), R::load(normals, 2 * plane + at.i)];
    let mut sum = [R::splat(0.0); 3];
    unroll!(C in 0, 1, 2 => {
        let i = C * plane + at.i;
        let coefs = [
            R::load(radiance, i),
            R::load(radiance, i + 3 * plane),
            R::load(radiance, i + 6 * plane),
            R::load(radiance, i + 9 * plane),
        ];
        sum[C] = sh::irradiance(&coefs, normal);
    });
    sum
}

/// Four coefficients of a channel of a blend of receivers.
#[inline(always)]
pub fn blended(blend: &SrpBlend, channel: usize, radiance: &[f32], slot_count: u32) -> [f32; 4] {
    let plane = slot_count as usize;
    let mut sum = [0.0; 4];
    unroll!(J in 0, 1, 2, 3 => {
        let (slot, weight) = (blend.slots[J] as usize, blend.weights[J]);
        unroll!(K in 0, 1, 2, 3 => { sum[K] += weight * radiance[(3 * K + channel) * plane + slot]; });
    });
    sum
}

/// Irradiance (W/m², w = 0) at point `i` for its shading normal; not negative.
#[inline(always)]
pub fn normal_mapped(i: u32, p: &SrpResolveParams, blends: &[SrpBlend], radiance: &[f32], surfels: &[Surfel]) -> Vec4 {
    let (blend, normal) = (blends[i as usize], surfels[i as usize].normal);
    let red = sh::irradiance(&blended(&blend, 0, radiance, p.slot_count), normal);
    let green = sh::irradiance(&blended(&blend, 1, radiance, p.slot_count), normal);
    let blue = sh::irradiance(&blended(&blend, 2, radiance, p.slot_count), normal);
    Vec4::new(max(red, 0.0), max(green, 0.0), max(blue, 0.0), 0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn case_receivers(input: &mut CaseInput) -> Case {
    let slot_count = (input.count as u32).div_ceil(SRP_LANES) * SRP_LANES;
    let p = SrpResolveParams { count: 0, slot_count, _pad0: 0, _pad1: 0 };
    let n = slot_count as usize;
    let mut normals = alloc::vec![0.0; 3 * n];
    for i in 0..n {
        let d = input.direction().to_array();
        (0..3).for_each(|axis| normals[axis * n + i] = d[axis]);
    }
    let radiance = super::case_radiance4(input, slot_count);
    Case::default().uniform(&p).read(&normals).read(&radiance).zeroed::<f32>(3 * n)
}
#[cfg(not(target_arch = "spirv"))]
fn case_points(input: &mut CaseInput) -> Case {
    let slot_count = 64;
    let p = SrpResolveParams { count: input.count as u32, slot_count, _pad0: 0, _pad1: 0 };
    let blends = super::resolve::case_blends(input, input.count, slot_count);
    let radiance = super::case_radiance4(input, slot_count);
    let surfels: alloc::vec::Vec<Surfel> = (0..input.count).map(|_| crate::trace::case::surfel(input)).collect();
    Case::default().uniform(&p).read(&blends).read(&radiance).read(&surfels).zeroed::<Vec4>(input.count)
}

kernel! {
    /// Order-1 radiance to irradiance at receivers.
    lanes mod srp_receiver_irradiance = super::irradiance; entry "srp_receiver_irradiance" threads(64);
    uniform 0 params: SrpResolveParams;
    read 1 normals: f32;
    read 2 radiance: f32;
    write 3 irradiance: f32 x 3;
    over super::rows;
    case super::case_receivers; tolerance Tolerance::RelAbs(2e-6, 4e-6), "four multiply-adds of numbers up to 3 that may cancel; a device may fuse each";
}

kernel! {
    /// Order-1 radiance to irradiance at points with their own normals.
    mod srp_normal_mapped = super::normal_mapped; entry "srp_normal_mapped" threads(64);
    uniform 0 params: SrpResolveParams;
    read 1 blends: SrpBlend;
    read 2 radiance: f32;
    read 3 surfels: Surfel;
    write 4 irradiance: Vec4;
    over super::points;
    case super::case_points; tolerance Tolerance::RelAbs(2e-6, 4e-6), "sixteen multiply-adds of numbers up to 3 that may cancel; a device may fuse each";
}
