//! Radiance and coverage of levels ≥ 1, in one or six directions.
//!
//! One invocation computes one stored direction of one record. `voxel_mip_base` makes level 1 from facets, `voxel_mip` a
//! level from the level below. A record's value in a direction is what a viewer who looks along it sees: radiance times
//! coverage (premultiplied), and coverage: the share of a voxel's face that is hidden.
//!
//! Crassin et al. 2011 (§4, anisotropic voxels): over each pair of voxels along the direction front to back, then the mean
//! of the four pairs. Deviation: where a pair's coverages add up to no more than 1 they are taken as pieces side by side,
//! not as random ones (the "disjoint over" of Porter & Duff 1984 instead of "over"): a wall that crosses from one voxel
//! into the next stays opaque, α + (1 − α) = 1, where the usual operator leaves α(1 − α) ≤ ¼ of it open on every level
//! anew. For coverages 0 and 1 the two are the same.
//!
//! With one direction (isotropic, Crassin & Green 2012) the coverage of eight voxels is their sum over four, as if half of
//! them lay behind the others; cheaper by six, and light leaks through thin walls, because lit and dark sides are averaged.
//!
//! Pass before: `light.rs` (level 1), the level below (others). Pass after: cones.

#[cfg(not(target_arch = "spirv"))]
use super::case::CasePyramid;
use super::cells::pass_rows;
use super::facet::facets_of_byte;
use super::grid::below;
use super::view::{at_most_covered, axis_direction, facets_seen};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::kernel::{fetch, fetch_if};
use crate::math::float::{max, min};
use glam::Vec4;
use interreflect_shared::voxel::{VoxelFacet, VoxelParams};

/// Two voxels one behind the other; each premultiplied radiance and coverage up to 1.
#[inline(always)]
pub fn over(front: Vec4, back: Vec4) -> Vec4 {
    let free = 1.0 - front.w;
    front + back * min(free / max(back.w, f32::MIN_POSITIVE), 1.0)
}

/// The first, second or third by an axis.
#[inline(always)]
fn by_axis(axis: u32, x: Vec4, y: Vec4, z: Vec4) -> Vec4 {
    if axis == 0 {
        x
    } else if axis == 1 {
        y
    } else {
        z
    }
}

/// Two voxels side by side along an axis, seen along it or, `reversed`, against it.
#[inline(always)]
fn pair(reversed: bool, low: Vec4, high: Vec4) -> Vec4 {
    if reversed { over(high, low) } else { over(low, high) }
}

/// Eight voxels seen along one axis, `reversed` against it; bits 0, 1, 2 of an index are the place along x, y, z. (Indices that
/// depend on the axis would put the eight into memory on a device.)
#[inline(always)]
fn seen_along(axis: u32, reversed: bool, v: &[Vec4; 8]) -> Vec4 {
    let sum = pair(reversed, v[0], by_axis(axis, v[1], v[2], v[4]))
        + pair(reversed, by_axis(axis, v[2], v[1], v[1]), by_axis(axis, v[3], v[3], v[5]))
        + pair(reversed, by_axis(axis, v[4], v[4], v[2]), by_axis(axis, v[5], v[6], v[6]))
        + pair(reversed, by_axis(axis, v[6], v[5], v[3]), v[7]);
    sum * 0.25
}

/// Eight voxels seen from everywhere: their sum over four, cut at full coverage.
#[inline(always)]
fn seen_from_everywhere(v: &[Vec4; 8]) -> Vec4 {
    let sum = (((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]))) * 0.25;
    if sum.w > 1.0 { sum / sum.w } else { sum }
}

#[inline(always)]
fn combine(p: &VoxelParams, direction: u32, v: &[Vec4; 8]) -> Vec4 {
    if p.direction_count == 1 { seen_from_everywhere(v) } else { seen_along(direction >> 1, direction & 1 == 1, v) }
}

/// Value `p.first + i` of the levels ≥ 1 of one parity, from the level below: record by record, direction by direction
/// (+x, −x, +y, −y, +z, −z: the way the viewer looks). `children`: what [`super::cells::children`] made; `finer`: values of
/// the other parity.
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
#[inline(always)]
pub fn mip(i: u32, p: &VoxelParams, cells: &[u32], children: &[u32], finer: &[Vec4]) -> Vec4 {
    let element = p.first + i;
    let record = element / p.direction_count;
    let direction = element - record * p.direction_count;
    let child = *fetch(children, record as usize);
    let cell = 2 * (child >> 2) as usize;
    let byte = child & 3;
    let word = *fetch(cells, cell);
    let bits = word >> (8 * byte);
    let mut next = *fetch(cells, cell + 1) + (word & below(8 * byte)).count_ones();
    let mut v = [Vec4::ZERO; 8];
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7 => {
        let there = bits >> K & 1;
        let at = (next * p.direction_count + direction) as usize;
        v[K] = fetch_if(there == 1, finer, at, Vec4::ZERO);
        next += there;
    });
    combine(p, direction, &v)
}

/// Value `i` of level 1, from facets. `radiance`: two per facet, front and back.
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
#[inline(always)]
pub fn mip_base(
    i: u32,
    p: &VoxelParams,
    cells: &[u32],
    facet_bits: &[u32],
    facets: &[VoxelFacet],
    radiance: &[Vec4],
    children: &[u32],
) -> Vec4 {
    let record = i / p.direction_count;
    let direction = i - record * p.direction_count;
    let child = *fetch(children, record as usize);
    let cell = child >> 2;
    let first_bit = 8 * (child & 3);
    let bits = *fetch(cells, (2 * cell) as usize) >> first_bit;
    let (mut next, kinds) = facets_of_byte(cells, facet_bits, cell, first_bit);
    let looking = axis_direction(direction >> 1, direction & 1 == 1);
    let mut v = [Vec4::ZERO; 8];
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7 => {
        if bits >> K & 1 == 1 {
            let count = kinds.count(K as u32);
            let seen = facets_seen(next, count, looking, p.direction_count == 1, facets, radiance);
            v[K] = at_most_covered(seen);
            next += count;
        }
    });
    combine(p, direction, &v)
}

#[cfg(not(target_arch = "spirv"))]
fn mip_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::lit(input);
    let level = pyramid.some_level(input, 2);
    let params = pyramid.record_pass(level);
    let (children, finer, out) = if level & 1 == 1 {
        (&pyramid.odd_children, &pyramid.even_mips, &pyramid.odd_mips)
    } else {
        (&pyramid.even_children, &pyramid.odd_mips, &pyramid.even_mips)
    };
    Case::default().uniform(&params).read(&pyramid.cells).read(children).read(finer).zeroed::<Vec4>(out.len())
}

#[cfg(not(target_arch = "spirv"))]
fn mip_base_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::lit(input);
    Case::default()
        .uniform(&pyramid.record_pass(1))
        .read(&pyramid.cells)
        .read(&pyramid.facet_bits)
        .read(&pyramid.facets)
        .read(&pyramid.radiance)
        .read(&pyramid.odd_children)
        .zeroed::<Vec4>(pyramid.odd_mips.len())
}

kernel! {
    /// A level of radiance and coverage from the level below.
    mod voxel_mip = super::mip; entry "voxel_mip" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 children: u32;
    read 3 finer: Vec4;
    write 4 out: Vec4;
    over super::pass_rows;
    case super::mip_case; tolerance Tolerance::RelAbs(1e-5, 1e-35), "a division and four products of positive numbers; fused on some devices";
}

kernel! {
    /// Level 1 of radiance and coverage from facets.
    mod voxel_mip_base = super::mip_base; entry "voxel_mip_base" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 facets: VoxelFacet;
    read 4 radiance: Vec4;
    read 5 children: u32;
    write 6 out: Vec4;
    over super::pass_rows;
    case super::mip_base_case; tolerance Tolerance::RelAbs(1e-4, 1e-35), "back faces show by a difference of coverages, which cancels";
}
