//! The geometry volume: how much of the way from cell to cell is blocked.
//!
//! Kaplanyan & Dachsbacher (2010, §4.4) keep a blocking potential in a grid that is moved by half a cell, so that its centres lie
//! between those of the light, and look it up in the direction of travel. Light travels between neighbouring centres only, so we keep
//! just what these three directions need: per axis the area, projected on the axis and over a cell's face, of the surfaces between two
//! neighbouring centres. Each axis is a grid moved by half a cell along that axis. Compared with the papers' two bands of spherical harmonics per corner: no interpolation that spreads walls,
//! three numbers instead of four, both sides of a surface block, and a wall blocks nothing that travels along it.
//! A surface blocks between the two centres that it lies between; light is injected, half a cell above the surface, on its own side.
//!
//! `lpv_block_facets`: one invocation adds one facet of the voxelized scene, seen by a light or not. `lpv_block_texels`: one
//! invocation adds one lit texel: surfaces that were not voxelized (moving objects). `lpv_opacity`: one invocation makes one opacity of both: the facets', or the texels'
//! where it is larger and texels count. Areas are sums in fixed point.
//!
//! Fails for walls that several facets at an angle share (their areas add up, at most to full). Pass before: `rsm.rs`, voxel facets. Pass after: `propagate.rs`.

use super::grid::{cell_of, cells_from_world, element, inside};
use super::inject::TIE;
use crate::kernel::AtomicWords;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{abs, floor, min};
use crate::math::vector::normalize;
use glam::{IVec3, Vec3};
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::lpv::OPACITY_PLANES;
use interreflect_shared::lpv::{AREA_MOST, AREA_UNITS, LpvLayout, LpvParams, RsmTexel};
use interreflect_shared::voxel::VoxelFacet;

/// Adds a surface element: `area` is its normal times its area, in cell faces.
#[inline(always)]
fn add_area(p: &LpvParams, position: Vec3, area: Vec3, words: &mut impl AtomicWords) {
    let q = cells_from_world(p.anchor_size, position);
    if !is_near(p, q) {
        return;
    }
    let q = q - normalize(area) * TIE;
    // Along each axis in turn the cell whose centre lies before the surface.
    let (cell, before) = (cell_of(p.first_cell, q), cell_of(p.first_cell, q - 0.5));
    add_axis(p, IVec3::new(before.x, cell.y, cell.z), 0, abs(area.x), words);
    add_axis(p, IVec3::new(cell.x, before.y, cell.z), 1, abs(area.y), words);
    add_axis(p, IVec3::new(cell.x, cell.y, before.z), 2, abs(area.z), words);
}

/// Whether a position, in cells from the anchor, can lie in the grid: half a cell and a tie more than it reaches. Cheaper to ask than to
/// find its cells; most surfaces lie outside a cascade.
#[inline(always)]
fn is_near(p: &LpvParams, q: Vec3) -> bool {
    let x = q.x - p.first_cell.x as f32;
    let y = q.y - p.first_cell.y as f32;
    let z = q.z - p.first_cell.z as f32;
    let (dx, dy, dz) = (p.dims.x as f32, p.dims.y as f32, p.dims.z as f32);
    (x > -1.0) & (x < dx + 1.0) & (y > -1.0) & (y < dy + 1.0) & (z > -1.0) & (z < dz + 1.0)
}

/// The face above a cell: between its centre and the next one's.
#[inline(always)]
fn add_axis(p: &LpvParams, cell: IVec3, axis: u32, area: f32, words: &mut impl AtomicWords) {
    let units = floor(min(area, AREA_MOST) * AREA_UNITS + 0.5) as u32;
    if inside(p.dims, cell) && units > 0 {
        let layout = LpvLayout::new(p.dims);
        words.add(axis * layout.plane + element(&layout, cell), units);
    }
}

/// Adds facet `i`.
#[inline(always)]
pub fn block_facet(i: u32, p: &LpvParams, facets: &[VoxelFacet], words: &mut impl AtomicWords) {
    let facet = &facets[i as usize];
    let side = p.voxel_size / p.anchor_size.w;
    add_area(p, Vec3::from_array(facet.position), Vec3::from_array(facet.normal) * (side * side), words);
}

/// Adds texel `i`.
#[inline(always)]
pub fn block_texel(i: u32, p: &LpvParams, texels: &[RsmTexel], words: &mut impl AtomicWords) {
    let t = &texels[i as usize];
    if t.hit == 1 {
        let faces = t.area / p.anchor_size.w / p.anchor_size.w;
        add_area(p, Vec3::from_array(t.position), Vec3::from_array(t.normal) * min(faces, AREA_MOST), words);
    }
}

/// Opacity of element `i` from the areas of facets and of texels.
#[inline(always)]
pub fn opacity(i: u32, p: &LpvParams, facet_words: &[u32], texel_words: &[u32]) -> f32 {
    let facets = if p.opacity_sources & 1 == 1 { facet_words[i as usize] } else { 0 };
    let texels = if p.opacity_sources & 2 == 2 { texel_words[i as usize] } else { 0 };
    // What is voxelized is known exactly; overlapping maps would count it several times.
    let area = if facets > 0 { facets } else { texels };
    min(area as f32 / AREA_UNITS, 1.0)
}

#[cfg(not(target_arch = "spirv"))]
fn facet_case(input: &mut CaseInput) -> Case {
    let pyramid = crate::voxel::case::CasePyramid::resolved(input);
    let p = super::case::params_over(input, &pyramid.params);
    let p = LpvParams { count: pyramid.facets.len() as u32, ..p };
    let words = OPACITY_PLANES * LpvLayout::new(p.dims).plane;
    Case::default().uniform(&p).read(&pyramid.facets).zeroed::<u32>(words as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn texel_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, 8);
    let texels = super::case::texels(input, &p);
    let words = OPACITY_PLANES * LpvLayout::new(p.dims).plane;
    let p = LpvParams { count: texels.len() as u32, ..p };
    Case::default().uniform(&p).read(&texels).zeroed::<u32>(words as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn opacity_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let plane = LpvLayout::new(p.dims).plane as usize * OPACITY_PLANES as usize;
    let mut words = || -> alloc::vec::Vec<u32> {
        (0..plane).map(|_| if input.bits() & 1 == 0 { 0 } else { input.bits() >> 15 }).collect()
    };
    Case::default().uniform(&p).read(&words()).read(&words()).zeroed::<f32>(plane)
}

scatter! {
    /// Facets to blocked area.
    mod lpv_block_facets = super::block_facet; entry "lpv_block_facets" threads(64);
    uniform 0 params: LpvParams; items super::super::inject::items;
    read 1 facets: VoxelFacet;
    atomic 2 words;
    case super::facet_case; tolerance Tolerance::FixedPoint(64), "one product per facet may round the other way";
}

scatter! {
    /// Lit texels to blocked area.
    mod lpv_block_texels = super::block_texel; entry "lpv_block_texels" threads(64);
    uniform 0 params: LpvParams; items super::super::inject::items;
    read 1 texels: RsmTexel;
    atomic 2 words;
    case super::texel_case; tolerance Tolerance::FixedPoint(64), "two divisions and a product per texel may round the other way";
}

kernel! {
    /// Blocked area to opacity.
    mod lpv_opacity = super::opacity; entry "lpv_opacity" threads(64);
    uniform 0 params: LpvParams;
    read 1 facet_words: u32;
    read 2 texel_words: u32;
    write 3 out: f32;
    case super::opacity_case; tolerance Tolerance::Exact, "a division by a power of two";
}
