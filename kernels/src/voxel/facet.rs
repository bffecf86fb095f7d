//! Facets: what one voxel holds of the surfaces that face one way.
//!
//! `voxel_accumulate`: one invocation walks one tile, clips the triangle to every voxel it touches, and adds area, normal,
//! centroid, reflectance and emission, weighted by area, to the voxel's facet: fixed point through integer atomics, so
//! that the sums are the same bits in any order. `voxel_resolve`: one invocation turns one facet's sums into a
//! [`VoxelFacet`].
//!
//! Fixed point: `area_scale` units (2²⁰ by default) per voxel face; every other quantity is bounded by the area times 1.
//! Where an area reaches 2³¹ units (2048 voxel faces in one voxel) the last word of the sums is set, and the host repeats
//! the pass with a coarser scale: never a silent overflow. A touched voxel's area is at least one unit.
//!
//! Six facet kinds instead of one record per voxel: in a corner each wall keeps its own normal, and the two sheets of a
//! wall thinner than a voxel keep their own sides (Crassin et al. 2011 average them, which lights the dark side).
//!
//! Pass before: ranks (`cells.rs`). Pass after: light (`light.rs`).

#[cfg(not(target_arch = "spirv"))]
use super::case::CasePyramid;
use super::grid::{Grid, below, facet_kind, from_axis, last_at_most, place, voxel_of};
use super::mark::{tile_items, tile_owner};
use super::overlap::clip;
use super::tile::{GridTriangle, TileWalk};
use super::view::facet_total;
use crate::kernel::{AtomicWords, fetch};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{abs, floor, max, min};
use crate::math::vector::{length, normalize};
use crate::trace::surface::{base_colour, material};
use glam::{UVec3, Vec3};
use interreflect_shared::scene::{SceneMaterial, SceneTriangle, TriangleAttributes};
use interreflect_shared::voxel::{AREA_LIMIT, FACET_KINDS, FACET_WORDS, VoxelFacet, VoxelParams};

/// Index of a voxel's facet of one kind: facets lie in the order of cells, bits and kinds.
#[inline(always)]
pub fn facet_index(cells: &[u32], facet_bits: &[u32], cell: u32, bit: u32, kind: u32) -> u32 {
    let first = (cell * FACET_KINDS) as usize;
    let mut index = *fetch(cells, (2 * cell + 1) as usize);
    for k in 0..FACET_KINDS {
        let word = *fetch(facet_bits, first + k as usize);
        index += (word & below(bit)).count_ones();
        if k < kind {
            index += word >> bit & 1;
        }
    }
    index
}

/// Index of a voxel's first facet, and how many it has.
#[inline(always)]
pub fn facets_of(cells: &[u32], facet_bits: &[u32], cell: u32, bit: u32) -> (u32, u32) {
    let first_word = (cell * FACET_KINDS) as usize;
    let (mut first, mut count) = (*fetch(cells, (2 * cell + 1) as usize), 0);
    unroll!(KIND in 0, 1, 2, 3, 4, 5 => {
        let word = *fetch(facet_bits, first_word + KIND);
        first += (word & below(bit)).count_ones();
        count += word >> bit & 1;
    });
    (first, count)
}

/// Which kinds of facets the eight voxels of one byte of a cell hold, a byte per kind.
#[derive(Clone, Copy)]
pub struct ByteKinds {
    /// Kinds 0 to 3.
    low: u32,
    /// Kinds 4 and 5.
    high: u32,
}

impl ByteKinds {
    /// Number of facets of one of the voxels.
    #[inline(always)]
    pub fn count(self, voxel: u32) -> u32 {
        (self.low >> voxel & 0x0101_0101).count_ones() + (self.high >> voxel & 0x0101).count_ones()
    }
}

/// Index of the first facet of the eight voxels from `first_bit` on, and the kinds that they hold.
#[inline(always)]
pub fn facets_of_byte(cells: &[u32], facet_bits: &[u32], cell: u32, first_bit: u32) -> (u32, ByteKinds) {
    let first_word = (cell * FACET_KINDS) as usize;
    let mut first = *fetch(cells, (2 * cell + 1) as usize);
    let mut kinds = ByteKinds { low: 0, high: 0 };
    unroll!(KIND in 0, 1, 2, 3, 4, 5 => {
        let word = *fetch(facet_bits, first_word + KIND);
        first += (word & below(first_bit)).count_ones();
        let byte = (word >> first_bit & 0xFF) << (8 * (KIND as u32 % 4));
        if KIND < 4 { kinds.low |= byte } else { kinds.high |= byte }
    });
    (first, kinds)
}

/// Adds the part of a triangle in each voxel of one tile to its facets. `sums`: [`FACET_WORDS`] words per facet and one
/// word that tells of an overflow.
#[inline(always)]
pub fn accumulate(
    i: u32,
    p: &VoxelParams,
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
    tile_first: &[u32],
    cells: &[u32],
    facet_bits: &[u32],
    sums: &mut impl AtomicWords,
) {
    let owner = tile_owner(p, tile_first, i);
    let source = &triangles[owner as usize];
    let triangle = GridTriangle::new(p, source);
    let kind = facet_kind(triangle.normal);
    let normal = normalize(triangle.normal);
    let m = material(surfaces, source.material);
    let mut walk = TileWalk::new(triangle, i - tile_first[owner as usize]);
    while walk.advance() {
        let voxel = walk.voxel();
        let corner = walk.corner();
        let piece = clip(triangle.a - corner, triangle.b - corner, triangle.c - corner);
        let (albedo, opacity) = colour(&triangle, piece.centroid + corner, &attributes[owner as usize], surfaces, &m);
        let centroid = from_axis(piece.centroid, triangle.axis);
        let at = place(p.levels[0], voxel.x, voxel.y, voxel.z);
        let facet = facet_index(cells, facet_bits, at.cell, at.bit, kind);
        add_piece(p, sums, facet, piece.area * opacity, normal, centroid, albedo, Vec3::from_array(m.emission));
    }
}

/// Reflectance at a point of the triangle's plane, and 0 where the material's alpha cuts it out, else 1.
#[inline(always)]
fn colour(
    t: &GridTriangle,
    point: Vec3,
    attributes: &TriangleAttributes,
    surfaces: &[u32],
    m: &SceneMaterial,
) -> (Vec3, f32) {
    // Weights of the corners in the projection on the plane that the triangle faces most.
    let (ab, ac, ap) = (t.b - t.a, t.c - t.a, point - t.a);
    let area = ab.x * ac.y - ab.y * ac.x;
    let scale = if abs(area) > 0.0 { 1.0 / area } else { 0.0 };
    let u = min(max((ap.x * ac.y - ap.y * ac.x) * scale, 0.0), 1.0);
    let v = min(max((ab.x * ap.y - ab.y * ap.x) * scale, 0.0), 1.0);
    let base = base_colour(surfaces, m, attributes, u, v);
    let albedo = Vec3::new(min(base.albedo.x, 1.0), min(base.albedo.y, 1.0), min(base.albedo.z, 1.0));
    (albedo, if base.alpha < m.alpha_cutoff { 0.0 } else { 1.0 })
}

/// Adds one piece's area and area-weighted attributes in fixed point.
#[inline(always)]
fn add_piece(
    p: &VoxelParams,
    sums: &mut impl AtomicWords,
    facet: u32,
    area: f32,
    normal: Vec3,
    centroid: Vec3,
    albedo: Vec3,
    emission: Vec3,
) {
    let first = facet * FACET_WORDS;
    let units = floor(area * p.area_scale + 0.5);
    // A touched voxel never has no area.
    let units = if units < 1.0 { 1.0 } else { units };
    let area_word = units as u32;
    if sums.add(first, area_word) >= AREA_LIMIT - area_word.min(AREA_LIMIT) {
        sums.or(p.facet_count * FACET_WORDS, 1);
    }
    add3(sums, first + 1, normal * units);
    add3(sums, first + 4, centroid * units);
    add3(sums, first + 7, albedo * units);
    add3(sums, first + 10, emission * (units / p.emission_scale));
}

/// Adds three numbers, rounded to nearest, as two's-complement words.
#[inline(always)]
fn add3(sums: &mut impl AtomicWords, first: u32, v: Vec3) {
    sums.add(first, floor(v.x + 0.5) as i32 as u32);
    sums.add(first + 1, floor(v.y + 0.5) as i32 as u32);
    sums.add(first + 2, floor(v.z + 0.5) as i32 as u32);
}

/// Facet `i` from its sums.
#[inline(always)]
pub fn resolve(i: u32, p: &VoxelParams, cells: &[u32], facet_bits: &[u32], sums: &[u32]) -> VoxelFacet {
    let cell = last_at_most(cells, 0, p.levels[0].w, 2, 1, i);
    let bit = facet_bit(cells[(2 * cell) as usize], cell, facet_bits, i - cells[(2 * cell + 1) as usize]);
    let voxel: UVec3 = voxel_of(p.levels[0], cell, bit);
    let first = (i * FACET_WORDS) as usize;
    let area = max(sums[first] as f32, 1.0);
    let centroid = sum3(sums, first + 4) / area;
    let position = p.origin_size.truncate()
        + (Vec3::new(voxel.x as f32, voxel.y as f32, voxel.z as f32) + centroid) * p.origin_size.w;
    let d = p.dims_levels();
    VoxelFacet {
        position: position.to_array(),
        area: area / p.area_scale,
        normal: (sum3(sums, first + 1) / p.area_scale).to_array(),
        voxel: voxel.x + d.x * (voxel.y + d.y * voxel.z),
        albedo: (sum3(sums, first + 7) / area).to_array(),
        _pad0: 0,
        emission: (sum3(sums, first + 10) * (p.emission_scale / area)).to_array(),
        _pad1: 0,
    }
}

#[inline(always)]
fn sum3(sums: &[u32], first: usize) -> Vec3 {
    Vec3::new(sums[first] as i32 as f32, sums[first + 1] as i32 as f32, sums[first + 2] as i32 as f32)
}

/// Bit of the voxel that holds facet `n` of a cell.
#[inline(always)]
fn facet_bit(occupied: u32, cell: u32, facet_bits: &[u32], n: u32) -> u32 {
    let mut rest = n;
    let mut voxels = occupied;
    let mut bit = voxels.trailing_zeros() & 31;
    let mut here = facet_total(facet_bits, cell, bit);
    while rest >= here && voxels != 0 {
        rest -= here;
        voxels &= voxels.wrapping_sub(1);
        bit = voxels.trailing_zeros() & 31;
        here = facet_total(facet_bits, cell, bit);
    }
    bit
}

/// Unit normal of a facet's front; up where its normals cancel.
#[inline(always)]
pub fn facet_normal(facet: &VoxelFacet) -> Vec3 {
    let n = Vec3::from_array(facet.normal);
    let l = length(n);
    if l > 1e-12 { n / l } else { Vec3::Y }
}

#[cfg(not(target_arch = "spirv"))]
fn accumulate_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    Case::default()
        .uniform(&pyramid.params)
        .read(&pyramid.triangles)
        .read(&pyramid.attributes)
        .read(&pyramid.surfaces)
        .read(&pyramid.tile_first)
        .read(&pyramid.cells)
        .read(&pyramid.facet_bits)
        .zeroed::<u32>((pyramid.params.facet_count * FACET_WORDS + 1) as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn resolve_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::resolved(input);
    Case::default()
        .uniform(&pyramid.params)
        .read(&pyramid.cells)
        .read(&pyramid.facet_bits)
        .read(&pyramid.sums)
        .zeroed::<VoxelFacet>(pyramid.facets.len())
}

scatter! {
    /// Surface attributes of facets in fixed point.
    mod voxel_accumulate = super::accumulate; entry "voxel_accumulate" threads(64);
    uniform 0 params: VoxelParams; items super::tile_items;
    read 1 triangles: SceneTriangle;
    read 2 attributes: TriangleAttributes;
    read 3 surfaces: u32;
    read 4 tile_first: u32;
    read 5 cells: u32;
    read 6 facet_bits: u32;
    atomic 7 sums;
    case super::accumulate_case; tolerance Tolerance::FixedPoint(64), "a device may reassociate: each piece of a sum, of at most 2^20 units, may round the other way";
}

kernel! {
    /// Facets from their sums.
    mod voxel_resolve = super::resolve; entry "voxel_resolve" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 sums: u32;
    write 4 out: VoxelFacet;
    case super::resolve_case; tolerance Tolerance::RelAbs(1e-6, 1e-30), "divisions may be off by two units in the last place on a device";
}
