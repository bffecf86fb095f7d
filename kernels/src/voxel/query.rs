//! What another renderer imports to look into a voxel pyramid: [`VoxelPyramid::sample`].

use super::facet::facet_index;
use super::grid::{Grid, below};
use super::view::{facet_total, facets_seen, facets_seen_from_everywhere};
use crate::math::float::{abs, floor};
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

/// The two voxels around a coordinate along one axis: shares of the cell index, of the bit index, and weights. A voxel
/// outside the grid has weight 0.
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
        let first = base as i32;
        let last = count as i32 - 1;
        let in0 = first >= 0 && first <= last;
        let in1 = first >= -1 && first < last;
        let i0 = if in0 { first as u32 } else { 0 };
        let i1 = if in1 { (first + 1) as u32 } else { 0 };
        Self {
            cell0: (i0 >> shift) * pitch,
            cell1: (i1 >> shift) * pitch,
            bit0: bits_of(i0, shift, low_bit),
            bit1: bits_of(i1, shift, low_bit),
            weight0: if in0 { 1.0 - fraction } else { 0.0 },
            weight1: if in1 { fraction } else { 0.0 },
        }
    }
}

#[inline(always)]
fn bits_of(i: u32, shift: u32, low_bit: u32) -> u32 {
    let high = if shift == 2 { (i >> 1 & 1) << (low_bit + 3) } else { 0 };
    (i & 1) << low_bit | high
}

impl VoxelPyramid<'_> {
    /// What a viewer who looks along the unit vector `looking` sees of one voxel: premultiplied radiance and coverage, both
    /// per voxel's length of the viewer's ray.
    #[inline(always)]
    fn voxel<G: Grid>(&self, grid: &G, level: u32, cell: u32, bit: u32, word: u32, looking: Vec3) -> Vec4 {
        if level == 0 {
            let first = facet_index(self.cells, self.facet_bits, cell, bit, 0);
            let count = facet_total(self.facet_bits, cell, bit);
            return if grid.direction_count() == 1 {
                facets_seen_from_everywhere(first, count, self.facets, self.radiance)
            } else {
                facets_seen(first, count, looking, self.facets, self.radiance)
            };
        }
        let record = self.cells[(2 * cell + 1) as usize] + (word & below(bit)).count_ones();
        if grid.direction_count() == 1 {
            return self.record(level, record);
        }
        let first = record * 6;
        self.record(level, first + (looking.x < 0.0) as u32) * abs(looking.x)
            + self.record(level, first + 2 + (looking.y < 0.0) as u32) * abs(looking.y)
            + self.record(level, first + 4 + (looking.z < 0.0) as u32) * abs(looking.z)
    }

    #[inline(always)]
    fn record(&self, level: u32, i: u32) -> Vec4 {
        if level & 1 == 1 { self.odd[i as usize] } else { self.even[i as usize] }
    }

    /// Trilinear sample of one level at a position in voxels of level 0, looking along a unit vector: premultiplied radiance
    /// and coverage per length of a voxel of *that* level.
    #[inline(always)]
    pub fn sample_level<G: Grid>(&self, grid: &G, level: u32, position: Vec3, looking: Vec3) -> Vec4 {
        let table: UVec4 = grid.level(level);
        let dims: UVec3 = super::grid::level_dims(grid, level);
        let scale = 1.0 / (1u32 << level) as f32;
        let x = Tap::new(position.x * scale - 0.5, dims.x, 2, 1, 0);
        let y = Tap::new(position.y * scale - 0.5, dims.y, 2, table.x, 1);
        let z = Tap::new(position.z * scale - 0.5, dims.z, 1, table.y, 2);
        let mut sum = Vec4::ZERO;
        for corner in 0..8u32 {
            let (x1, y1, z1) = (corner & 1 == 1, corner & 2 == 2, corner & 4 == 4);
            let weight = if x1 { x.weight1 } else { x.weight0 }
                * if y1 { y.weight1 } else { y.weight0 }
                * if z1 { z.weight1 } else { z.weight0 };
            let cell = table.z
                + if x1 { x.cell1 } else { x.cell0 }
                + if y1 { y.cell1 } else { y.cell0 }
                + if z1 { z.cell1 } else { z.cell0 };
            let bit =
                if x1 { x.bit1 } else { x.bit0 } | if y1 { y.bit1 } else { y.bit0 } | if z1 { z.bit1 } else { z.bit0 };
            let word = self.cells[(2 * cell) as usize];
            if weight > 0.0 && word >> bit & 1 == 1 {
                sum += self.voxel(grid, level, cell, bit, word, looking) * weight;
            }
        }
        sum
    }

    /// Quadrilinear sample for a footprint of `size` voxels of level 0 (at least 1): premultiplied radiance and coverage per
    /// length of a voxel of level 0. Between the levels around log₂ `size` linearly in `size`.
    #[inline(always)]
    pub fn sample<G: Grid>(&self, grid: &G, position: Vec3, size: f32, looking: Vec3) -> Vec4 {
        // The exponent of a float is the floor of its base-2 logarithm, exactly and on every target.
        let exponent = (size.to_bits() >> 23) as i32 - 127;
        let coarsest = grid.dims_levels().w - 1;
        let level = if exponent > 0 { (exponent as u32).min(coarsest) } else { 0 };
        let unit = 1.0 / (1u32 << level) as f32;
        let fraction = size * unit - 1.0;
        if level == coarsest || fraction <= 0.0 {
            return self.sample_level(grid, level, position, looking) * unit;
        }
        // Where the coarser level is empty around the position, so is the finer one: its voxels lie below the coarser's.
        let coarse = self.sample_level(grid, level + 1, position, looking);
        if coarse.w <= 0.0 {
            return Vec4::ZERO;
        }
        let fine = self.sample_level(grid, level, position, looking);
        fine * ((1.0 - fraction) * unit) + coarse * (fraction * 0.5 * unit)
    }
}
