//! Further bounces, and reflections: light from the grid back onto the voxelized scene's facets.
//!
//! `lpv_bounce`: one invocation reflects, at one side of one facet, the irradiance that the grid gives there into the cell in front of it, as
//! `inject.rs` does with texels. Energy of a bounce is what the facets' albedo leaves of the last one's. `lpv_reflect`: one invocation gives one facet's side the
//! radiance that it reflects of all light, faded towards the end of the grid's range: the reflection grid (Doghramachi 2013; thesis on voxel techniques,
//! §3.4.4), which `voxel_mip` then filters and `cone_glossy` reads. There only light from the grid is applied; we add what lights send
//! directly. Pass before: `levels.rs`. Pass after: `inject.rs` (`lpv_resolve`), or the voxels' mipmap.

use super::inject::add_lobe;
use super::query::{Floats, Grid, irradiance};
use crate::kernel::AtomicWords;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{max, min};
use crate::math::vector::length;
use crate::voxel::facet::facet_normal;
use core::f32::consts::FRAC_1_PI;
use glam::{Vec3, Vec4};
use interreflect_shared::lpv::LpvParams;
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::lpv::{LpvLayout, PASSED_VALUES};
use interreflect_shared::voxel::VoxelFacet;

/// Height above a facet at which light is fetched, in cells.
const OFFSET: f32 = 0.5;

/// Normal of side `i & 1` of facet `i / 2`, and the irradiance (W/m²) of the grid there.
#[inline(always)]
fn side_light(i: u32, p: &LpvParams, facet: &VoxelFacet, coefs: &[f32]) -> (Vec3, Vec3) {
    let front = facet_normal(facet);
    let normal = if i & 1 == 0 { front } else { -front };
    let grid = Grid { anchor_size: p.anchor_size, first_cell: p.first_cell, dims: p.dims };
    (normal, irradiance(&grid, &Floats(coefs), Vec3::from_array(facet.position), normal, OFFSET))
}

/// Sides of facets.
pub fn sides(p: &LpvParams) -> u32 {
    p.count
}

/// Reflects light at side `i`.
#[inline(always)]
pub fn bounce(i: u32, p: &LpvParams, facets: &[VoxelFacet], coefs: &[f32], words: &mut impl AtomicWords) {
    let facet = &facets[(i / 2) as usize];
    let (normal, light) = side_light(i, p, facet, coefs);
    let area = facet.area * p.voxel_size * p.voxel_size;
    add_lobe(p, Vec3::from_array(facet.position), normal, Vec3::from_array(facet.albedo) * light * area, words);
}

/// Radiance (W/(sr m²), w = 0) of side `i`; `direct`: irradiance of both sides of every facet by lights.
#[inline(always)]
pub fn reflect(i: u32, p: &LpvParams, facets: &[VoxelFacet], coefs: &[f32], direct: &[Vec4]) -> Vec4 {
    let facet = &facets[(i / 2) as usize];
    let (_, light) = side_light(i, p, facet, coefs);
    let far = length(Vec3::from_array(facet.position) - p.fade.truncate()) / max(p.fade.w, f32::MIN_POSITIVE);
    // Full in the inner half of the range, nothing at its end.
    let fade = min(max(2.0 - 2.0 * far, 0.0), 1.0);
    (Vec3::from_array(facet.albedo) * (light + direct[i as usize].truncate()) * (FRAC_1_PI * fade)).extend(0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn facets(input: &mut CaseInput) -> (LpvParams, alloc::vec::Vec<VoxelFacet>, alloc::vec::Vec<f32>) {
    let pyramid = crate::voxel::case::CasePyramid::resolved(input);
    let p = LpvParams {
        count: 2 * pyramid.facets.len() as u32,
        // A facet reflects about what its cell holds, whatever the size of voxels: area times flux per area.
        flux_scale: 1e3,
        ..super::case::params_over(input, &pyramid.params)
    };
    let value = LpvLayout::new(p.dims).value() as usize;
    let coefs = (0..value * PASSED_VALUES as usize).map(|i| if i < value { input.unit() } else { 0.0 }).collect();
    (p, pyramid.facets, coefs)
}

#[cfg(not(target_arch = "spirv"))]
fn bounce_case(input: &mut CaseInput) -> Case {
    let (p, facets, coefs) = facets(input);
    let words = super::inject::word_count(&p) + 1;
    Case::default().uniform(&p).read(&facets).read(&coefs).zeroed::<u32>(words as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn reflect_case(input: &mut CaseInput) -> Case {
    let (p, facets, coefs) = facets(input);
    let direct: alloc::vec::Vec<Vec4> = (0..2 * facets.len()).map(|_| Vec4::splat(input.unit())).collect();
    Case::default().uniform(&p).read(&facets).read(&coefs).read(&direct).zeroed::<Vec4>(direct.len())
}

scatter! {
    /// Light of the grid, reflected by the scene into the grid again.
    mod lpv_bounce = super::bounce; entry "lpv_bounce" threads(64);
    uniform 0 params: LpvParams; items super::sides;
    read 1 facets: VoxelFacet;
    read 2 coefs: f32;
    atomic 3 words;
    case super::bounce_case; tolerance Tolerance::FixedPoint(64), "interpolated irradiances may differ in the last digits; sums of some facets per cell";
}

kernel! {
    /// Light of the grid on the scene, for reflections.
    mod lpv_reflect = super::reflect; entry "lpv_reflect" threads(64);
    uniform 0 params: LpvParams;
    read 1 facets: VoxelFacet;
    read 2 coefs: f32;
    read 3 direct: Vec4;
    write 4 out: Vec4;
    case super::reflect_case; tolerance Tolerance::RelAbs(1e-4, 1e-5), "weights near cells' planes lose digits to differences of positions";
}
