//! Addresses in the voxel pyramid: bricks of 4 × 4 × 2 voxels, one bit each, with ranks.
//!
//! A *cell* is a brick's pair of words (occupancy bits, rank). Bits are ordered so that the eight voxels below one voxel
//! of the next coarser level are the eight bits of one byte: x, y, z are bits 0, 1, 2 of the place in the byte, and bits
//! 3, 4 count the bytes along x and y. The records of these eight voxels are then neighbours in memory.

use crate::kernel::fetch;
use crate::math::float::{abs, floor};
use glam::{UVec3, UVec4, Vec3, Vec4};
use interreflect_shared::voxel::VoxelParams;
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::voxel::{AREA_SCALE, BRICK, MAX_LEVELS};

/// What kernels ask a uniform record that describes a pyramid.
pub trait Grid {
    /// Corner (m); w: side of a voxel (m).
    fn origin_size(&self) -> Vec4;
    /// Voxels along each axis; w: number of levels.
    fn dims_levels(&self) -> UVec4;
    /// Bricks along x, bricks of a z layer, first cell, number of cells.
    fn level(&self, level: u32) -> UVec4;
    /// Directions stored in levels ≥ 1.
    fn direction_count(&self) -> u32;
}

impl Grid for VoxelParams {
    #[inline(always)]
    fn origin_size(&self) -> Vec4 {
        self.origin_size
    }
    #[inline(always)]
    fn dims_levels(&self) -> UVec4 {
        self.dims_levels
    }
    #[inline(always)]
    fn level(&self, level: u32) -> UVec4 {
        *fetch(&self.levels, level as usize)
    }
    #[inline(always)]
    fn direction_count(&self) -> u32 {
        self.direction_count
    }
}

/// Voxels along each axis of a level: each level halves, rounding up.
#[inline(always)]
pub fn level_dims<G: Grid>(grid: &G, level: u32) -> UVec3 {
    let round_up = (1u32 << level) - 1;
    let d = grid.dims_levels();
    UVec3::new((d.x + round_up) >> level, (d.y + round_up) >> level, (d.z + round_up) >> level)
}

/// Position in voxels of level 0 from the grid's corner.
#[inline(always)]
pub fn grid_from_world<G: Grid>(grid: &G, p: Vec3) -> Vec3 {
    let o = grid.origin_size();
    (p - o.truncate()) / o.w
}

/// Place of a voxel: its cell and its bit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Place {
    /// Index of the cell.
    pub cell: u32,
    /// Bit in the cell's word.
    pub bit: u32,
}

/// Place of a voxel of a level given by [`Grid::level`].
#[inline(always)]
pub fn place(level: UVec4, x: u32, y: u32, z: u32) -> Place {
    Place {
        cell: level.z + (x >> 2) + level.x * (y >> 2) + level.y * (z >> 1),
        bit: (x & 1) | (y & 1) << 1 | (z & 1) << 2 | (x & 2) << 2 | (y & 2) << 3,
    }
}

/// Voxel coordinates of a cell (index within its level) and a bit.
#[inline(always)]
pub fn voxel_of(level: UVec4, cell_in_level: u32, bit: u32) -> UVec3 {
    let z = cell_in_level / level.y;
    let rest = cell_in_level - z * level.y;
    let y = rest / level.x;
    let x = rest - y * level.x;
    UVec3::new(x << 2 | (bit & 1) | (bit >> 2) & 2, y << 2 | (bit >> 1) & 1 | (bit >> 3) & 2, z << 1 | (bit >> 2) & 1)
}

/// Bits below a bit.
#[inline(always)]
pub fn below(bit: u32) -> u32 {
    (1 << bit) - 1
}

/// Place of the n-th set bit of a word (n from 0); the word has more than n.
#[inline(always)]
#[allow(unused_assignments, reason = "the last step of the unrolled loop")]
pub fn nth_set_bit(word: u32, n: u32) -> u32 {
    let (mut rest, mut n, mut place) = (word, n, 0);
    // By halves of what is left; as many steps for every word.
    unroll!(STEP in 4, 3, 2, 1, 0 => {
        let half = 1 << STEP;
        let count = (rest & below(half)).count_ones();
        let is_above = n >= count;
        rest = if is_above { rest >> half } else { rest };
        n = if is_above { n - count } else { n };
        place += if is_above { half } else { 0 };
    });
    place
}

/// Largest index whose value is at most `key`, in a non-decreasing array of `count` ≥ 1 elements from `first` on that
/// starts at or below `key`; the values lie `stride` words apart.
#[inline(always)]
pub fn last_at_most(values: &[u32], first: u32, count: u32, stride: u32, offset: u32, key: u32) -> u32 {
    let (mut low, mut rest) = (first, count);
    // As many steps for every key, and no branch that depends on it.
    while rest > 1 {
        let half = rest / 2;
        let middle = low + half;
        low = if values[(middle * stride + offset) as usize] <= key { middle } else { low };
        rest -= half;
    }
    low
}

/// Kind of a facet: twice the dominant axis of the front normal (the first of equals), plus 1 where it points down the
/// axis.
#[inline(always)]
pub fn facet_kind(normal: Vec3) -> u32 {
    let axis = dominant_axis(normal);
    let component = if axis == 0 {
        normal.x
    } else if axis == 1 {
        normal.y
    } else {
        normal.z
    };
    2 * axis + (component < 0.0) as u32
}

/// Axis of the largest component by magnitude, the first of equals.
#[inline(always)]
pub fn dominant_axis(v: Vec3) -> u32 {
    let (x, y, z) = (abs(v.x), abs(v.y), abs(v.z));
    if x >= y && x >= z {
        0
    } else if y >= z {
        1
    } else {
        2
    }
}

/// One of three values, by axis.
#[inline(always)]
pub fn of_axis<T: Copy>(axis: u32, x: T, y: T, z: T) -> T {
    let x_or_y = if axis == 0 { x } else { y };
    if axis == 2 { z } else { x_or_y }
}

/// Coordinates turned so that `axis` becomes z, in cyclic order.
#[inline(always)]
pub fn to_axis(v: Vec3, axis: u32) -> Vec3 {
    if axis == 0 {
        Vec3::new(v.y, v.z, v.x)
    } else if axis == 1 {
        Vec3::new(v.z, v.x, v.y)
    } else {
        v
    }
}

/// Inverse of [`to_axis`]: turning about one axis is turning back about the other.
#[inline(always)]
pub fn from_axis(v: Vec3, axis: u32) -> Vec3 {
    to_axis(v, if axis == 2 { 2 } else { 1 - axis })
}

/// First and last voxel (closed boxes) that an interval in grid units touches, cut to `0 .. count`; the first is above the
/// last where it touches none.
#[inline(always)]
pub fn touched(low: f32, high: f32, count: f32) -> (i32, i32) {
    let first = -floor(-low) - 1.0;
    let last = floor(high);
    let top = count - 1.0;
    let first = if first > 0.0 { first } else { 0.0 };
    let last = if last < top { last } else { top };
    (first as i32, last as i32)
}

/// The empty pyramid of a grid: levels down to a single voxel, at most [`MAX_LEVELS`]; everything that counts content is
/// zero, directions are six, scales the defaults.
#[cfg(not(target_arch = "spirv"))]
pub fn pyramid(origin: Vec3, voxel_size: f32, dims: UVec3) -> VoxelParams {
    let halvings = 32 - (dims.max_element().max(1) - 1).leading_zeros();
    let level_count = (halvings + 1).min(MAX_LEVELS as u32);
    let mut params = VoxelParams {
        origin_size: origin.extend(voxel_size),
        dims_levels: dims.extend(level_count),
        levels: [UVec4::ZERO; MAX_LEVELS],
        triangle_count: 0,
        tile_count: 0,
        facet_count: 0,
        direction_count: 6,
        area_scale: AREA_SCALE,
        emission_scale: 1.0,
        emission_weight: 0.0,
        even_cells: 0,
        level: 0,
        first: 0,
        count: 0,
        _pad: 0,
        environment: Vec4::ZERO,
        bounce_gain: Vec4::ONE,
        light: UVec4::ZERO,
    };
    let mut next = 0;
    for parity in 0..2 {
        for level in (parity..level_count).step_by(2) {
            let d = level_dims(&params, level);
            let bricks = UVec3::new(d.x.div_ceil(BRICK[0]), d.y.div_ceil(BRICK[1]), d.z.div_ceil(BRICK[2]));
            let layer = bricks.x * bricks.y;
            params.levels[level as usize] = UVec4::new(bricks.x, layer, next, layer * bricks.z);
            next += layer * bricks.z;
        }
        if parity == 0 {
            params.even_cells = next;
        }
    }
    params
}

/// Cells of all levels together.
#[cfg(not(target_arch = "spirv"))]
pub fn cell_count(params: &VoxelParams) -> u32 {
    params.levels.iter().map(|level| level.w).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_voxels_are_inverse_and_octets_are_bytes() {
        let level = UVec4::new(3, 3 * 2, 7, 3 * 2 * 4);
        let mut seen = std::collections::HashSet::new();
        for (z, y, x) in (0..8).flat_map(|z| (0..8).flat_map(move |y| (0..12).map(move |x| (z, y, x)))) {
            let p = place(level, x, y, z);
            assert!(p.bit < 32 && p.cell >= 7 && p.cell < 7 + level.w && seen.insert((p.cell, p.bit)));
            assert_eq!(voxel_of(level, p.cell - 7, p.bit), UVec3::new(x, y, z));
            let first = place(level, x & !1, y & !1, z & !1);
            assert_eq!((p.cell, p.bit / 8), (first.cell, first.bit / 8));
        }
    }

    #[test]
    fn searches_find_owners_past_empty_elements() {
        let firsts = [0, 0, 3, 3, 3, 5];
        let owners: Vec<u32> = (0..6).map(|k| last_at_most(&firsts, 0, 6, 1, 0, k)).collect();
        assert_eq!(owners, [1, 1, 1, 4, 4, 5]);
        assert_eq!(last_at_most(&firsts[..1], 0, 1, 1, 0, 9), 0);
        for word in (0..32).map(|k| 0x9E37_79B9_u32.rotate_left(k) >> (k / 2)).chain([1, 1 << 31, u32::MAX]) {
            let places: Vec<u32> = (0..32).filter(|place| word >> place & 1 == 1).collect();
            let found: Vec<u32> = (0..word.count_ones()).map(|n| nth_set_bit(word, n)).collect();
            assert_eq!(found, places, "{word:b}");
        }
    }

    #[test]
    fn touched_intervals_are_closed() {
        assert_eq!(touched(3.0, 3.0, 8.0), (2, 3));
        assert_eq!(touched(2.5, 2.75, 8.0), (2, 2));
        assert_eq!(touched(-4.0, 100.0, 8.0), (0, 7));
        let (first, last) = touched(9.5, 9.75, 8.0);
        assert!(first > last);
    }
}
