//! What a viewer sees of one voxel's facets.

use crate::kernel::{fetch, prefetch};
use crate::math::float::{max, min};
use crate::math::vector::length;
use glam::{Vec3, Vec4};
use interreflect_shared::voxel::{FACET_KINDS, VoxelFacet};

/// Unit vector along an axis, or against it.
#[inline(always)]
pub fn axis_direction(axis: u32, down: bool) -> Vec3 {
    let sign = if down { -1.0 } else { 1.0 };
    Vec3::new(
        if axis == 0 { sign } else { 0.0 },
        if axis == 1 { sign } else { 0.0 },
        if axis == 2 { sign } else { 0.0 },
    )
}

/// Directions that a record of levels ≥ 1 is seen along: +x, −x, +y, −y, +z, −z, the way the viewer looks.
pub const SIDES: usize = 6;

/// Premultiplied radiance and coverage with the coverage cut at 1.
#[inline(always)]
pub fn at_most_covered(seen: Vec4) -> Vec4 {
    // By factors, here and below: nothing would foresee the branches.
    (seen.truncate() * (1.0 / max(seen.w, 1.0))).extend(min(seen.w, 1.0))
}

/// Number of facets of a voxel of level 0.
#[inline(always)]
pub fn facet_total(facet_bits: &[u32], cell: u32, bit: u32) -> u32 {
    let first = (cell * FACET_KINDS) as usize;
    (*fetch(facet_bits, first) >> bit & 1)
        + (*fetch(facet_bits, first + 1) >> bit & 1)
        + (*fetch(facet_bits, first + 2) >> bit & 1)
        + (*fetch(facet_bits, first + 3) >> bit & 1)
        + (*fetch(facet_bits, first + 4) >> bit & 1)
        + (*fetch(facet_bits, first + 5) >> bit & 1)
}

/// Facets `first .. first + count` of one voxel, at least one, looked at along a unit direction: radiance times coverage, and
/// coverage, the facets' projected area in voxel faces (not cut at 1).
///
/// Fronts and backs that the viewer sees hide each other: the larger of the two sums covers, fronts first. A facet seen
/// from behind whose wall has its other sheet in the same voxel adds nothing; a single sheet shows its back. `isotropic`:
/// without regard to direction, the brighter side of each stands for both, and its whole area covers.
///
/// One loop for both, tested at its end: devices that mask branches pay for every loop, and for the round in which a test
/// at its start fails.
#[inline(always)]
pub fn facets_seen(
    first: u32,
    count: u32,
    looking: Vec3,
    isotropic: bool,
    facets: &[VoxelFacet],
    radiance: &[Vec4],
) -> Vec4 {
    let (mut front, mut back) = (Vec4::ZERO, Vec4::ZERO);
    let mut facet = first;
    loop {
        let normal = Vec3::from_array(fetch(facets, facet as usize).normal);
        let (a, b) = (*fetch(radiance, (2 * facet) as usize), *fetch(radiance, (2 * facet + 1) as usize));
        let towards = -looking.dot(normal);
        if isotropic {
            front += brighter(a, b) * length(normal);
        } else {
            // Both, one of them with no weight: no branch, which nothing would foresee.
            front += a.truncate().extend(1.0) * max(towards, 0.0);
            back += b.truncate().extend(1.0) * max(-towards, 0.0);
        }
        facet += 1;
        if facet >= first + count {
            break;
        }
    }
    seen_of(front, back)
}

/// The brighter side's radiance, and coverage 1.
#[inline(always)]
fn brighter(a: Vec4, b: Vec4) -> Vec4 {
    Vec4::new(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z), 1.0)
}

/// Fronts and backs that hide each other: the larger of the two sums covers, fronts first.
#[inline(always)]
fn seen_of(front: Vec4, back: Vec4) -> Vec4 {
    front + back * (max(back.w - front.w, 0.0) / max(back.w, f32::MIN_POSITIVE))
}

/// Facets ahead of which passes over all voxels ask for the next ones: some 4 KiB, a page, at whose end processors stop fetching
/// ahead by themselves.
const AHEAD: usize = 64;

#[inline(always)]
fn ask_ahead(facet: u32, facets: &[VoxelFacet], radiance: &[Vec4]) {
    let ahead = facet as usize + AHEAD;
    prefetch(facets, ahead);
    prefetch(radiance, 2 * ahead);
}

/// As [`facets_seen`] without regard to direction and cut at full coverage, in a pass over all voxels. (Cones jump from voxel to
/// voxel: what lies ahead is of no use to them, and a device shall have one loop for both of theirs.)
#[inline(always)]
pub fn facets_seen_from_everywhere(first: u32, count: u32, facets: &[VoxelFacet], radiance: &[Vec4]) -> Vec4 {
    let mut seen = Vec4::ZERO;
    let mut facet = first;
    loop {
        ask_ahead(facet, facets, radiance);
        let normal = Vec3::from_array(fetch(facets, facet as usize).normal);
        let (a, b) = (*fetch(radiance, (2 * facet) as usize), *fetch(radiance, (2 * facet + 1) as usize));
        seen += brighter(a, b) * length(normal);
        facet += 1;
        if facet >= first + count {
            break;
        }
    }
    at_most_covered(seen)
}

/// As [`facets_seen_from_everywhere`], along all six directions at once. What looks along an axis sees fronts by
/// that component of their normals that points against it, backs by the other; looking the other way the two change places,
/// and the same area covers.
#[inline(always)]
pub fn facets_seen_along_axes(first: u32, count: u32, facets: &[VoxelFacet], radiance: &[Vec4]) -> [Vec4; SIDES] {
    let (mut front, mut back) = ([Vec4::ZERO; SIDES], [Vec4::ZERO; SIDES]);
    let (mut area_along, mut area_against) = (Vec4::ZERO, Vec4::ZERO);
    let mut facet = first;
    loop {
        ask_ahead(facet, facets, radiance);
        let normal = Vec3::from_array(fetch(facets, facet as usize).normal).extend(0.0);
        let (a, b) = (*fetch(radiance, (2 * facet) as usize), *fetch(radiance, (2 * facet + 1) as usize));
        let (along, against) = (normal.max(Vec4::ZERO), (-normal).max(Vec4::ZERO));
        area_along += along;
        area_against += against;
        let (along, against) = (along.to_array(), against.to_array());
        unroll!(AXIS in 0, 1, 2 => {
            front[2 * AXIS] += a * against[AXIS];
            back[2 * AXIS] += b * along[AXIS];
            front[2 * AXIS + 1] += a * along[AXIS];
            back[2 * AXIS + 1] += b * against[AXIS];
        });
        facet += 1;
        if facet >= first + count {
            break;
        }
    }
    let least = Vec4::splat(f32::MIN_POSITIVE);
    let back_along = ((area_along - area_against).max(Vec4::ZERO) / area_along.max(least)).to_array();
    let back_against = ((area_against - area_along).max(Vec4::ZERO) / area_against.max(least)).to_array();
    let area = area_along.max(area_against);
    let (share, coverage) = ((Vec4::ONE / area.max(Vec4::ONE)).to_array(), area.min(Vec4::ONE).to_array());
    unroll!(AXIS in 0, 1, 2 => {
        let (along, against) = (2 * AXIS, 2 * AXIS + 1);
        front[along] = with_coverage((front[along] + back[along] * back_along[AXIS]) * share[AXIS], coverage[AXIS]);
        front[against] = with_coverage((front[against] + back[against] * back_against[AXIS]) * share[AXIS], coverage[AXIS]);
    });
    front
}

#[inline(always)]
fn with_coverage(radiance: Vec4, coverage: f32) -> Vec4 {
    radiance.truncate().extend(coverage)
}
