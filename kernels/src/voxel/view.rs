//! What a viewer sees of one voxel's facets.

use crate::kernel::fetch;
use crate::math::float::max;
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

/// Premultiplied radiance and coverage with the coverage cut at 1.
#[inline(always)]
pub fn at_most_covered(seen: Vec4) -> Vec4 {
    if seen.w > 1.0 { (seen.truncate() / seen.w).extend(1.0) } else { seen }
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
            front += Vec4::new(max(a.x, b.x), max(a.y, b.y), max(a.z, b.z), 1.0) * length(normal);
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
    if back.w > front.w { front + back * ((back.w - front.w) / back.w) } else { front }
}
