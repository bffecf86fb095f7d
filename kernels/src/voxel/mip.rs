//! Radiance and coverage of levels ≥ 1, in one or six directions.
//!
//! One invocation computes all directions of one record, so that what lies below is read once. `voxel_mip_base` makes level 1
//! from facets, `voxel_mip` a level from the level below; `…_isotropic` do so for one direction. A record's value in a direction
//! is what a viewer who looks along it sees: radiance times coverage (premultiplied), and coverage: the share of a voxel's
//! face that is hidden.
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
use super::facet::{ByteKinds, facets_of_byte};
use super::grid::below;
use super::view::{SIDES, at_most_covered, facets_seen_along_axes, facets_seen_from_everywhere};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::kernel::{fetch, fetch_if};
use crate::math::float::{max, min};
use glam::Vec4;
use interreflect_shared::voxel::{VoxelFacet, VoxelParams, VoxelSides};

/// Two voxels one behind the other; each premultiplied radiance and coverage up to 1.
#[inline(always)]
pub fn over(front: Vec4, back: Vec4) -> Vec4 {
    let free = 1.0 - front.w;
    front + back * min(free / max(back.w, f32::MIN_POSITIVE), 1.0)
}

/// Eight voxels, seen along each of the six directions.
struct Octet {
    voxels: [[Vec4; SIDES]; 8],
    sums: [Vec4; SIDES],
}

impl Octet {
    #[inline(always)]
    fn new() -> Self {
        Self { voxels: [[Vec4::ZERO; SIDES]; 8], sums: [Vec4::ZERO; SIDES] }
    }

    /// The next voxel, `K` = 0 to 7 in turn: bits 0, 1, 2 are its place along x, y, z. Where it is the far one of a pair along an
    /// axis, the pair is complete. (All at once after the eighth would keep 48 values.)
    #[inline(always)]
    fn add<const K: usize>(&mut self, high: [Vec4; SIDES]) {
        self.voxels[K] = high;
        unroll!(AXIS in 0, 1, 2 => {
            if K >> AXIS & 1 == 1 {
                let low = &self.voxels[K & !(1 << AXIS)];
                self.sums[2 * AXIS] += over(low[2 * AXIS], high[2 * AXIS]);
                self.sums[2 * AXIS + 1] += over(high[2 * AXIS + 1], low[2 * AXIS + 1]);
            }
        });
    }

    /// The mean of the four pairs along each direction.
    #[inline(always)]
    fn seen(&self) -> VoxelSides {
        let s = &self.sums;
        VoxelSides { sides: [s[0] * 0.25, s[1] * 0.25, s[2] * 0.25, s[3] * 0.25, s[4] * 0.25, s[5] * 0.25] }
    }
}

/// Occupancy of the eight voxels below a record (bits 0 to 7), and the first record among them.
#[inline(always)]
fn octet_below(record: u32, cells: &[u32], children: &[u32]) -> (u32, u32) {
    let child = *fetch(children, record as usize);
    let cell = 2 * (child >> 2) as usize;
    let first_bit = 8 * (child & 3);
    let word = *fetch(cells, cell);
    (word >> first_bit, *fetch(cells, cell + 1) + (word & below(first_bit)).count_ones())
}

/// Record `p.first + i` of the levels ≥ 1 of one parity, from the level below. `children`: what [`super::cells::children`]
/// made; `finer`: values of the other parity, record by record, direction by direction.
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
#[inline(always)]
pub fn mip(i: u32, p: &VoxelParams, cells: &[u32], children: &[u32], finer: &[Vec4]) -> VoxelSides {
    let (bits, mut next) = octet_below(p.first + i, cells, children);
    let mut octet = Octet::new();
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7 => {
        let there = bits >> K & 1;
        let mut voxel = [Vec4::ZERO; SIDES];
        unroll!(SIDE in 0, 1, 2, 3, 4, 5 => {
            voxel[SIDE] = fetch_if(there == 1, finer, next as usize * SIDES + SIDE, Vec4::ZERO);
        });
        octet.add::<K>(voxel);
        next += there;
    });
    octet.seen()
}

/// As [`mip`] without regard to direction: eight voxels' sum over four, cut at full coverage.
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
#[inline(always)]
pub fn mip_isotropic(i: u32, p: &VoxelParams, cells: &[u32], children: &[u32], finer: &[Vec4]) -> Vec4 {
    let (bits, mut next) = octet_below(p.first + i, cells, children);
    let mut sum = Vec4::ZERO;
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7 => {
        let there = bits >> K & 1;
        sum += fetch_if(there == 1, finer, next as usize, Vec4::ZERO);
        next += there;
    });
    at_most_covered(sum * 0.25)
}

/// Record `i` of level 1, from facets. `radiance`: two per facet, front and back.
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
#[inline(always)]
pub fn mip_base(
    i: u32,
    _p: &VoxelParams,
    cells: &[u32],
    facet_bits: &[u32],
    facets: &[VoxelFacet],
    radiance: &[Vec4],
    children: &[u32],
) -> VoxelSides {
    let (mut next, bits, kinds) = facets_below(i, cells, facet_bits, children);
    let mut octet = Octet::new();
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7 => {
        let mut voxel = [Vec4::ZERO; SIDES];
        if bits >> K & 1 == 1 {
            let count = kinds.count(K as u32);
            voxel = facets_seen_along_axes(next, count, facets, radiance);
            next += count;
        }
        octet.add::<K>(voxel);
    });
    octet.seen()
}

/// As [`mip_base`] without regard to direction.
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
#[inline(always)]
pub fn mip_base_isotropic(
    i: u32,
    _p: &VoxelParams,
    cells: &[u32],
    facet_bits: &[u32],
    facets: &[VoxelFacet],
    radiance: &[Vec4],
    children: &[u32],
) -> Vec4 {
    let (mut next, bits, kinds) = facets_below(i, cells, facet_bits, children);
    let mut sum = Vec4::ZERO;
    unroll!(K in 0, 1, 2, 3, 4, 5, 6, 7 => {
        if bits >> K & 1 == 1 {
            let count = kinds.count(K as u32);
            sum += facets_seen_from_everywhere(next, count, facets, radiance);
            next += count;
        }
    });
    at_most_covered(sum * 0.25)
}

/// First facet, occupancy (bits 0 to 7) and facets' kinds of the eight voxels below a record of level 1.
#[inline(always)]
fn facets_below(record: u32, cells: &[u32], facet_bits: &[u32], children: &[u32]) -> (u32, u32, ByteKinds) {
    let child = *fetch(children, record as usize);
    let (cell, first_bit) = (child >> 2, 8 * (child & 3));
    let (first, kinds) = facets_of_byte(cells, facet_bits, cell, first_bit);
    (first, *fetch(cells, (2 * cell) as usize) >> first_bit, kinds)
}

#[cfg(not(target_arch = "spirv"))]
fn mip_case(input: &mut CaseInput) -> Case {
    level_case(input, 6)
}
#[cfg(not(target_arch = "spirv"))]
fn mip_isotropic_case(input: &mut CaseInput) -> Case {
    level_case(input, 1)
}
#[cfg(not(target_arch = "spirv"))]
fn level_case(input: &mut CaseInput, direction_count: u32) -> Case {
    let pyramid = CasePyramid::lit_along(input, direction_count);
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
    base_case(input, 6)
}
#[cfg(not(target_arch = "spirv"))]
fn mip_base_isotropic_case(input: &mut CaseInput) -> Case {
    base_case(input, 1)
}
#[cfg(not(target_arch = "spirv"))]
fn base_case(input: &mut CaseInput, direction_count: u32) -> Case {
    let pyramid = CasePyramid::lit_along(input, direction_count);
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
    /// A level of radiance and coverage from the level below, in six directions.
    mod voxel_mip = super::mip; entry "voxel_mip" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 children: u32;
    read 3 finer: Vec4;
    write 4 out: VoxelSides;
    over super::pass_rows;
    case super::mip_case; tolerance Tolerance::RelAbs(1e-5, 1e-35), "a division and four products of positive numbers; fused on some devices";
}

kernel! {
    /// A level of radiance and coverage from the level below, without regard to direction.
    mod voxel_mip_isotropic = super::mip_isotropic; entry "voxel_mip_isotropic" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 children: u32;
    read 3 finer: Vec4;
    write 4 out: Vec4;
    over super::pass_rows;
    case super::mip_isotropic_case; tolerance Tolerance::RelAbs(1e-5, 1e-35), "a division, which devices may round otherwise";
}

kernel! {
    /// Level 1 of radiance and coverage from facets, in six directions.
    mod voxel_mip_base = super::mip_base; entry "voxel_mip_base" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 facets: VoxelFacet;
    read 4 radiance: Vec4;
    read 5 children: u32;
    write 6 out: VoxelSides;
    over super::pass_rows;
    case super::mip_base_case; tolerance Tolerance::RelAbs(1e-4, 1e-35), "back faces show by a difference of coverages, which cancels";
}

kernel! {
    /// Level 1 of radiance and coverage from facets, without regard to direction.
    mod voxel_mip_base_isotropic = super::mip_base_isotropic; entry "voxel_mip_base_isotropic" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 facets: VoxelFacet;
    read 4 radiance: Vec4;
    read 5 children: u32;
    write 6 out: Vec4;
    over super::pass_rows;
    case super::mip_base_isotropic_case; tolerance Tolerance::RelAbs(1e-5, 1e-35), "a division, which devices may round otherwise, and products that they may fuse";
}
