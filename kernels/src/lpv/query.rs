//! What another renderer imports to shade with light propagation volumes: [`irradiance`].
//!
//! The light at a receiver is trilinear between the cells around a point half a cell above it, without the cells behind the receiver's plane: those
//! lie inside or beyond the wall that the receiver is on. Irradiance is the clamped cosine over the radiance that the flux through a cell stands for:
//! intensity over the cell's mean cross-section, 3/2 of a face.

use super::grid::cells_from_world;
use crate::math::float::{clamp, floor, max, min};
use crate::math::pack::f32_from_f16;
use crate::math::sh;
use glam::{IVec4, UVec4, Vec3, Vec4};
use interreflect_shared::lpv::LpvLayout;

/// Mean cross-section of a cube, over a face: the mean of |x| + |y| + |z| over directions.
pub const CROSS_SECTION: f32 = 1.5;
/// Height above the receiver's plane, in cells, from which on a cell counts fully.
const CLEAR: f32 = 0.5;

/// Six coefficients of each colour channel of each cell: value by value, and in each channel by channel.
pub trait Coefficients {
    /// Coefficient `index` of an element (channel and cell) of a grid whose values have `value` elements.
    fn coefficient(&self, value: u32, index: u32, element: u32) -> f32;
}

/// Stored as floats.
pub struct Floats<'a>(pub &'a [f32]);
impl Coefficients for Floats<'_> {
    #[inline(always)]
    fn coefficient(&self, value: u32, index: u32, element: u32) -> f32 {
        self.0[(index * value + element) as usize]
    }
}

/// Stored as pairs of half floats: coefficients 0 and 1, then 2 and 3, then 4 and 5, the first in the low half; all times the inverse of the scale.
pub struct Halves<'a>(pub &'a [u32], pub f32);
impl Coefficients for Halves<'_> {
    #[inline(always)]
    fn coefficient(&self, value: u32, index: u32, element: u32) -> f32 {
        let word = self.0[(index / 2 * value + element) as usize];
        f32_from_f16(word >> (16 * (index & 1)) & 0xFFFF) * self.1
    }
}

/// A grid: as the fields of `LpvParams`.
#[derive(Clone, Copy)]
pub struct Grid {
    /// Anchor (m) and side of a cell (m).
    pub anchor_size: Vec4,
    /// Cell that is cell 0.
    pub first_cell: IVec4,
    /// Cells along each axis.
    pub dims: UVec4,
}

/// Two cells along an axis and the weight of the second.
#[derive(Clone, Copy)]
struct Tap {
    low: u32,
    high: u32,
    weight: f32,
    /// Centres of the two cells, in cells from the anchor.
    low_centre: f32,
    high_centre: f32,
}

#[inline(always)]
fn tap(q: f32, first: i32, count: u32) -> Tap {
    let base = floor(q - 0.5);
    let last = count as i32 - 1;
    let low = (base as i32 - first).max(0).min(last);
    let high = (base as i32 - first + 1).max(0).min(last);
    Tap {
        low: low as u32,
        high: high as u32,
        weight: q - 0.5 - base,
        low_centre: (low + first) as f32 + 0.5,
        high_centre: (high + first) as f32 + 0.5,
    }
}

/// Weight of a grid at a position: 1 inside, falling to 0 over `blend` cells towards its border.
#[inline(always)]
pub fn coverage(grid: &Grid, position: Vec3, blend: f32) -> f32 {
    let q = cells_from_world(grid.anchor_size, position);
    let f = grid.first_cell;
    let local = q - Vec3::new(f.x as f32, f.y as f32, f.z as f32);
    let d = Vec3::new(grid.dims.x as f32, grid.dims.y as f32, grid.dims.z as f32);
    let low = min(local.x, min(local.y, local.z));
    let high = min(d.x - local.x, min(d.y - local.y, d.z - local.z));
    clamp(min(low, high) / max(blend, 1e-3), 0.0, 1.0)
}

/// Coefficients of the intensity that passes around a receiver; zero outside the grid.
#[inline(always)]
pub fn intensity<C: Coefficients>(grid: &Grid, c: &C, position: Vec3, normal: Vec3, offset: f32) -> [[f32; 6]; 3] {
    let layout = LpvLayout::new(grid.dims);
    let q = cells_from_world(grid.anchor_size, position);
    let at = q + normal * offset;
    let f = grid.first_cell;
    let x = tap(at.x, f.x, grid.dims.x);
    let y = tap(at.y, f.y, grid.dims.y);
    let z = tap(at.z, f.z, grid.dims.z);
    let mut sum = [[0.0; 6]; 3];
    let mut total = 0.0;
    for corner in 0..8u32 {
        let (hx, hy, hz) = (corner & 1 == 1, corner & 2 == 2, corner & 4 == 4);
        let centre = Vec3::new(
            if hx { x.high_centre } else { x.low_centre },
            if hy { y.high_centre } else { y.low_centre },
            if hz { z.high_centre } else { z.low_centre },
        );
        let trilinear = if hx { x.weight } else { 1.0 - x.weight }
            * if hy { y.weight } else { 1.0 - y.weight }
            * if hz { z.weight } else { 1.0 - z.weight };
        let weight = trilinear * clamp((centre - q).dot(normal) / CLEAR, 0.0, 1.0);
        if weight > 0.0 {
            let i = layout.at(
                if hx { x.high } else { x.low },
                if hy { y.high } else { y.low },
                if hz { z.high } else { z.low },
            );
            total += weight;
            unroll!(CHANNEL in 0, 1, 2 => {
                unroll!(K in 0, 1, 2, 3, 4, 5 => {
                    sum[CHANNEL][K] += c.coefficient(layout.value(), K as u32, CHANNEL as u32 * layout.plane + i) * weight;
                });
            });
        }
    }
    let scale = if total > 0.0 { 1.0 / total } else { 0.0 };
    unroll!(CHANNEL in 0, 1, 2 => {
        unroll!(K in 0, 1, 2, 3, 4, 5 => { sum[CHANNEL][K] *= scale; });
    });
    sum
}

/// All nine coefficients of order 2.
#[inline(always)]
pub fn expansion(c: &[f32; 6]) -> [f32; 9] {
    [c[0], c[1], c[2], c[3], 0.0, 0.0, c[4], 0.0, c[5]]
}

/// Indirect irradiance (W/m²) at a receiver with a unit normal, from one grid. `offset`: height above the surface at which light is fetched, in cells.
#[inline(always)]
pub fn irradiance<C: Coefficients>(grid: &Grid, c: &C, position: Vec3, normal: Vec3, offset: f32) -> Vec3 {
    let i = intensity(grid, c, position, normal, offset);
    let size = grid.anchor_size.w;
    let per_area = 1.0 / (CROSS_SECTION * size) / size;
    // Light that arrives travels against the normal.
    let against = [-normal.x, -normal.y, -normal.z];
    Vec3::new(
        max(sh::irradiance(&expansion(&i[0]), against), 0.0),
        max(sh::irradiance(&expansion(&i[1]), against), 0.0),
        max(sh::irradiance(&expansion(&i[2]), against), 0.0),
    ) * per_area
}
