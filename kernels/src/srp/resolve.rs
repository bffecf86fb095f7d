//! Receivers to lightmap texels, with dilation, and to arbitrary points.
//!
//! `srp_atlas`: one invocation writes one texel of the lightmap: a receiver's irradiance, or for texels that a bilinear
//! lookup beside a receiver may touch a mean of neighbours (the dilation of the implementation study, §5.5, with weights
//! from precomputation instead of a search), or nothing (w = 0). `srp_resolve`: one invocation writes the irradiance of
//! one point, a mean of up to four receivers that precomputation chose. Both are bound by bandwidth. Before:
//! [`super::reconstruct`].

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::max;
use glam::Vec4;
use interreflect_shared::srp::{SRP_BLENDED, SRP_EMPTY, SrpBlend, SrpResolveParams};

/// Texels or points.
pub fn elements(p: &SrpResolveParams) -> Rows {
    Rows::all(p.count)
}

/// Irradiance with what a truncated series and its compression ring below zero cut off, and `w`.
#[inline(always)]
fn positive(irradiance: Vec4, w: f32) -> Vec4 {
    Vec4::new(max(irradiance.x, 0.0), max(irradiance.y, 0.0), max(irradiance.z, 0.0), w)
}

/// Irradiance (W/m²) of a blend of slots, w = 1; zero with w = 0 where all weights are 0. `irradiance` in planes
/// `[channel][slot]`.
#[inline(always)]
pub fn blended(blend: &SrpBlend, irradiance: &[f32], slot_count: u32) -> Vec4 {
    // A scene without surfaces.
    if slot_count == 0 {
        return Vec4::ZERO;
    }
    let plane = slot_count as usize;
    let (mut sum, mut weight) = (Vec4::ZERO, 0.0);
    unroll!(K in 0, 1, 2, 3 => {
        let (slot, w) = (blend.slots[K] as usize, blend.weights[K]);
        sum += w * Vec4::new(irradiance[slot], irradiance[plane + slot], irradiance[2 * plane + slot], 0.0);
        weight += w;
    });
    positive(sum, if weight > 0.0 { 1.0 } else { 0.0 })
}

/// Irradiance (W/m²) of texel `i`, w = 1 where there is any. `map`: per texel a slot, [`SRP_BLENDED`] and an index of
/// `blends`, or [`SRP_EMPTY`].
#[inline(always)]
pub fn texel(i: u32, p: &SrpResolveParams, map: &[u32], blends: &[SrpBlend], irradiance: &[f32]) -> Vec4 {
    let source = map[i as usize];
    if source == SRP_EMPTY {
        return Vec4::ZERO;
    }
    if source & SRP_BLENDED != 0 {
        return blended(&blends[(source & !SRP_BLENDED) as usize], irradiance, p.slot_count);
    }
    let (slot, plane) = (source as usize, p.slot_count as usize);
    positive(Vec4::new(irradiance[slot], irradiance[plane + slot], irradiance[2 * plane + slot], 0.0), 1.0)
}

/// Irradiance (W/m²) of point `i`, w = 0 as methods give it.
#[inline(always)]
pub fn point(i: u32, p: &SrpResolveParams, blends: &[SrpBlend], irradiance: &[f32]) -> Vec4 {
    let blend = blends[i as usize];
    blended(&blend, irradiance, p.slot_count).truncate().extend(0.0)
}

#[cfg(not(target_arch = "spirv"))]
pub(super) fn case_blends(input: &mut CaseInput, count: usize, slot_count: u32) -> alloc::vec::Vec<SrpBlend> {
    let blend = |input: &mut CaseInput| {
        let scale = if input.bits().is_multiple_of(5) { 0.0 } else { 0.25 };
        SrpBlend {
            slots: core::array::from_fn(|_| input.bits() % slot_count),
            weights: core::array::from_fn(|_| scale * input.unit()),
        }
    };
    (0..count).map(|_| blend(input)).collect()
}
#[cfg(not(target_arch = "spirv"))]
fn case_atlas(input: &mut CaseInput) -> Case {
    let slot_count = 64;
    let p = SrpResolveParams { count: input.count as u32, slot_count, _pad0: 0, _pad1: 0 };
    let word = |input: &mut CaseInput| match input.bits() % 3 {
        0 => SRP_EMPTY,
        1 => SRP_BLENDED | (input.bits() % 32),
        _ => input.bits() % slot_count,
    };
    let map: alloc::vec::Vec<u32> = (0..input.count).map(|_| word(input)).collect();
    let blends = case_blends(input, 32, slot_count);
    let irradiance = super::case_floats(input, 3 * slot_count as usize);
    Case::default().uniform(&p).read(&map).read(&blends).read(&irradiance).zeroed::<Vec4>(input.count)
}
#[cfg(not(target_arch = "spirv"))]
fn case_points(input: &mut CaseInput) -> Case {
    let slot_count = 64;
    let p = SrpResolveParams { count: input.count as u32, slot_count, _pad0: 0, _pad1: 0 };
    let blends = case_blends(input, input.count, slot_count);
    let irradiance = super::case_floats(input, 3 * slot_count as usize);
    Case::default().uniform(&p).read(&blends).read(&irradiance).zeroed::<Vec4>(input.count)
}

kernel! {
    /// Irradiance at receivers to the lightmap.
    mod srp_atlas = super::texel; entry "srp_atlas" threads(64);
    uniform 0 params: SrpResolveParams;
    read 1 map: u32;
    read 2 blends: SrpBlend;
    read 3 irradiance: f32;
    write 4 texels: Vec4;
    over super::elements;
    case super::case_atlas; tolerance Tolerance::RelAbs(1e-6, 1e-6), "four multiply-adds of numbers below 1 that may cancel; a device may fuse each";
}

kernel! {
    /// Irradiance at receivers to points.
    mod srp_resolve = super::point; entry "srp_resolve" threads(64);
    uniform 0 params: SrpResolveParams;
    read 1 blends: SrpBlend;
    read 2 irradiance: f32;
    write 3 points: Vec4;
    over super::elements;
    case super::case_points; tolerance Tolerance::RelAbs(1e-6, 1e-6), "four multiply-adds of numbers below 1 that may cancel; a device may fuse each";
}
