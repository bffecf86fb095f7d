//! One cone through a voxel pyramid.
//!
//! Crassin et al. 2011, §7: samples along the axis, from voxels as large as the cone is wide, front to back.
//!
//! Deviation, the law of opacity. The usual correction for a step of s voxels, 1 − (1 − α)^s, treats what a voxel holds as
//! mist: a wall that two voxels share, half each, lets ¼ of the light through, and grazing light passes walls, because
//! weights dᵢ² shrink faster than the way through them grows. Here coverage is an area per length of the way: facets of
//! projected area A·|n·d| in a voxel of side h cover A·|n·d|/h³ · ds of a beam, and within one crossing coverages add up,
//! as those of neighbouring pieces of one surface do. A plane then covers exactly 1, at any angle, wherever it lies in its
//! voxels, for any step; and a small thing covers as much as its projected area. Once the beam has left a surface (a
//! sample without any coverage), the next one is independent of it: transmittances multiply.

use crate::math::float::{abs, max, min};
use crate::voxel::grid::Grid;
use crate::voxel::query::VoxelPyramid;
use glam::{Vec3, Vec4};

/// How cones march; see [`interreflect_shared::cone::ConeParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeMarch {
    /// Size of the voxels read, per distance.
    pub spread: f32,
    /// Size of the voxels read, at most, at the start, in voxels of level 0.
    pub clear: f32,
    /// Growth of that bound per distance.
    pub clear_slope: f32,
    /// Step in voxels of that size.
    pub step: f32,
}

impl ConeMarch {
    /// Size of the voxels to read at a distance: the cone's width, but no more than the height above the surface that the
    /// cone leaves allows.
    #[inline(always)]
    fn size(&self, t: f32) -> f32 {
        max(min(self.spread * t, self.clear + self.clear_slope * t), 1.0)
    }
}

/// Transmittance below which a cone has seen enough.
const OPAQUE: f32 = 1e-3;
/// Steps of one cone, at most: more than the longest way through 512 voxels one by one, twice.
const MAX_STEPS: u32 = 2048;

/// Radiance that a cone gathers (rgb, W/(sr m²)) and the share of it that leaves the grid (w). `origin` in voxels of level
/// 0 from the grid's corner, `direction` unit.
pub fn trace_cone<G: Grid>(
    grid: &G,
    pyramid: &VoxelPyramid<'_>,
    origin: Vec3,
    direction: Vec3,
    march: &ConeMarch,
) -> Vec4 {
    let d = grid.dims_levels();
    let size = Vec3::new(d.x as f32, d.y as f32, d.z as f32);
    // A surface near the grid's side reaches as far out as half a voxel and a voxel's filter of the size read there.
    let margin = Vec3::splat(1.5 * march.size(exit(origin, direction, size)));
    let end = exit(origin + margin, direction, size + margin * 2.0);
    let mut radiance = Vec3::ZERO;
    // Transmittance up to the surface being crossed, and how much of the beam that surface has covered.
    let (mut reaching, mut covered) = (1.0, 0.0);
    let mut t = 0.0;
    for _ in 0..MAX_STEPS {
        if t >= end || reaching * (1.0 - covered) < OPAQUE {
            break;
        }
        let length = march.step * march.size(t);
        let middle = t + 0.5 * length;
        let seen = pyramid.sample(grid, origin + direction * middle, march.size(middle), direction);
        let coverage = seen.w * length;
        if coverage > 0.0 {
            let fresh = min(coverage, 1.0 - covered);
            radiance += seen.truncate() * (length * reaching * fresh / coverage);
            covered += fresh;
        } else {
            reaching *= 1.0 - covered;
            covered = 0.0;
        }
        t += length;
    }
    radiance.extend(reaching * (1.0 - covered))
}

/// Distance at which a ray leaves the box from 0 to `size`; 0 where it starts outside and leaves.
#[inline(always)]
fn exit(origin: Vec3, direction: Vec3, size: Vec3) -> f32 {
    let x = exit_axis(origin.x, direction.x, size.x);
    let y = exit_axis(origin.y, direction.y, size.y);
    let z = exit_axis(origin.z, direction.z, size.z);
    max(min(min(x, y), z), 0.0)
}

#[inline(always)]
fn exit_axis(origin: f32, direction: f32, size: f32) -> f32 {
    if abs(direction) < 1e-9 {
        return f32::MAX;
    }
    (if direction > 0.0 { size - origin } else { -origin }) / direction
}
