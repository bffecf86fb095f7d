//! What another renderer imports to look into a voxel pyramid: [`VoxelPyramid::crossing`].

use super::facet::facets_of;
use super::grid::{Grid, Place, below, of_axis};
use super::view::{at_most_covered, axis_direction, facets_seen};
use crate::kernel::fetch;
use crate::math::float::{floor, to_i32};
use glam::{UVec3, UVec4, Vec3, Vec4};
use interreflect_shared::voxel::VoxelFacet;

/// The buffers of a pyramid with light in it.
#[derive(Clone, Copy)]
pub struct VoxelPyramid<'a> {
    /// Bits and rank of every cell.
    pub cells: &'a [u32],
    /// Six words per cell of level 0.
    pub facet_bits: &'a [u32],
    /// Facets of level 0.
    pub facets: &'a [VoxelFacet],
    /// Radiance of each facet's front and back.
    pub radiance: &'a [Vec4],
    /// Records of levels 1, 3, ….
    pub odd: &'a [Vec4],
    /// Records of levels 2, 4, ….
    pub even: &'a [Vec4],
}

/// The two voxels around a coordinate along one axis: shares of the cell index, of the bit index, and weights. Outside the
/// grid both weights are 0.
#[derive(Clone, Copy)]
struct Tap {
    cell0: u32,
    cell1: u32,
    bit0: u32,
    bit1: u32,
    weight0: f32,
    weight1: f32,
}

impl Tap {
    /// `shift`: log₂ of the bricks' side along the axis; `pitch`: cells per brick; `low_bit`: place of the coordinate's lowest
    /// bit in the bit index.
    #[inline(always)]
    fn new(x: f32, count: u32, shift: u32, pitch: u32, low_bit: u32) -> Self {
        let base = floor(x);
        let fraction = x - base;
        let first = to_i32(base);
        let last = count as i32 - 1;
        let inside = (x >= -0.5) & (x <= last as f32 + 0.5);
        let i0 = first.max(0).min(last) as u32;
        let i1 = (first + 1).max(0).min(last) as u32;
        // In the outer half of an outer voxel there is no neighbour: that voxel counts alone.
        let weight1 = if first < last { fraction } else { 0.0 };
        let weight1 = if first < 0 { 1.0 } else { weight1 };
        Self {
            cell0: (i0 >> shift) * pitch,
            cell1: (i1 >> shift) * pitch,
            bit0: bits_of(i0, shift, low_bit),
            bit1: bits_of(i1, shift, low_bit),
            weight0: if inside { 1.0 - weight1 } else { 0.0 },
            weight1: if inside { weight1 } else { 0.0 },
        }
    }
}

/// Bits of a coordinate in the bit index; `shift` 2: two of them, 1: one.
#[inline(always)]
fn bits_of(i: u32, shift: u32, low_bit: u32) -> u32 {
    (i & 1) << low_bit | (i >> 1 & (shift - 1)) << (low_bit + 3)
}

impl VoxelPyramid<'_> {
    /// What a viewer who looks along an axis (`down`: against it) sees of one voxel: premultiplied radiance and coverage.
    #[inline(always)]
    fn voxel<G: Grid>(&self, grid: &G, level: u32, at: Place, word: u32, axis: u32, down: bool) -> Vec4 {
        let isotropic = grid.direction_count() == 1;
        if level == 0 {
            let (first, count) = facets_of(self.cells, self.facet_bits, at.cell, at.bit);
            let looking = axis_direction(axis, down);
            let seen = facets_seen(first, count, looking, isotropic, self.facets, self.radiance);
            return at_most_covered(seen);
        }
        let record = *fetch(self.cells, (2 * at.cell + 1) as usize) + (word & below(at.bit)).count_ones();
        let i = if isotropic { record } else { 6 * record + 2 * axis + down as u32 } as usize;
        if level & 1 == 1 { *fetch(self.odd, i) } else { *fetch(self.even, i) }
    }

    /// What a ray sees in the layer of voxels whose middles it crosses: premultiplied radiance and coverage, bilinear in the
    /// layer. `axis`: across the layer; `layer`: its index; `position` in voxels of level 0 where the ray crosses it.
    ///
    /// A ray that crosses all layers along all axes, one after another, sees exactly a voxel's coverage once: a plane across
    /// an axis hides all of it, at any angle. Nothing is seen of a layer before or after its middle, so that a ray which
    /// leaves a surface, or passes along one, is not darkened by that surface's back, however large the voxels; with samples
    /// of trilinear filters that takes a tenth to a third of the light per bounce in a closed room.
    #[inline(always)]
    pub fn crossing<G: Grid>(&self, grid: &G, level: u32, axis: u32, layer: i32, down: bool, position: Vec3) -> Vec4 {
        let table: UVec4 = grid.level(level);
        let dims: UVec3 = super::grid::level_dims(grid, level);
        if (layer < 0) | (layer >= of_axis(axis, dims.x, dims.y, dims.z) as i32) {
            return Vec4::ZERO;
        }
        let scale = 1.0 / (1u32 << level) as f32;
        let (x, y, z) = (position.x * scale - 0.5, position.y * scale - 0.5, position.z * scale - 0.5);
        // Along the axis one layer, along the two after it (in cyclic order) two voxels each.
        let across = Place {
            cell: (layer as u32 >> of_axis(axis, 2, 2, 1)) * of_axis(axis, 1, table.x, table.y),
            bit: bits_of(layer as u32, of_axis(axis, 2, 2, 1), axis),
        };
        let u = Tap::new(
            of_axis(axis, y, z, x),
            of_axis(axis, dims.y, dims.z, dims.x),
            of_axis(axis, 2, 1, 2),
            of_axis(axis, table.x, table.y, 1),
            of_axis(axis, 1, 2, 0),
        );
        let v = Tap::new(
            of_axis(axis, z, x, y),
            of_axis(axis, dims.z, dims.x, dims.y),
            of_axis(axis, 1, 2, 2),
            of_axis(axis, table.y, 1, table.x),
            of_axis(axis, 2, 0, 1),
        );
        let mut sum = Vec4::ZERO;
        let mut corner = 0u32;
        loop {
            let (u1, v1) = (corner & 1 == 1, corner & 2 == 2);
            let weight = if u1 { u.weight1 } else { u.weight0 } * if v1 { v.weight1 } else { v.weight0 };
            let at = Place {
                cell: table.z + across.cell + if u1 { u.cell1 } else { u.cell0 } + if v1 { v.cell1 } else { v.cell0 },
                bit: across.bit | if u1 { u.bit1 } else { u.bit0 } | if v1 { v.bit1 } else { v.bit0 },
            };
            let word = *fetch(self.cells, (2 * at.cell) as usize);
            if (weight > 0.0) & (word >> at.bit & 1 == 1) {
                sum += self.voxel(grid, level, at, word, axis, down) * weight;
            }
            corner += 1;
            // Tested at the end: see `facets_seen`.
            if corner == 4 {
                break;
            }
        }
        sum
    }
}
