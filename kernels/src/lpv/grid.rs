//! Cells of a grid and rows over them.

use crate::kernel::{At, Rows};
use crate::math::float::floor;
use glam::{IVec3, IVec4, UVec4, Vec3, Vec4};
use interreflect_shared::lpv::{LpvLayout, LpvParams};

/// Position in cells from the grid's anchor.
#[inline(always)]
pub fn cells_from_world(anchor_size: Vec4, position: Vec3) -> Vec3 {
    (position - anchor_size.truncate()) / anchor_size.w
}

/// Cell of the grid that holds a position given in cells from the anchor. Whole cells are subtracted after rounding down,
/// so that a grid that moves by whole cells gives every position the same neighbours.
#[inline(always)]
pub fn cell_of(first_cell: IVec4, q: Vec3) -> IVec3 {
    IVec3::new(floor(q.x) as i32, floor(q.y) as i32, floor(q.z) as i32) - first_cell.truncate()
}

/// Whether a cell lies in the grid.
#[inline(always)]
pub fn inside(dims: UVec4, cell: IVec3) -> bool {
    cell.x >= 0
        && cell.y >= 0
        && cell.z >= 0
        && cell.x < dims.x as i32
        && cell.y < dims.y as i32
        && cell.z < dims.z as i32
}

/// Element of a cell inside the grid.
#[inline(always)]
pub fn element(layout: &LpvLayout, cell: IVec3) -> u32 {
    layout.at(cell.x as u32, cell.y as u32, cell.z as u32)
}

/// Rows of all three channels, one after the other, halo rows included (which are kept zero).
#[inline(always)]
pub fn grid_rows(dims: UVec4) -> Rows {
    let l = LpvLayout::new(dims);
    let count = if dims.x > 0 { 3 * l.rows() } else { 0 };
    Rows { count, len: dims.x, pitch: l.pitch, first: 0, plane: l.value() }
}

/// Rows of a pass over the grid.
pub fn rows(p: &LpvParams) -> Rows {
    grid_rows(p.dims)
}

/// Rows of a pass over the coarser grid.
pub fn coarse_rows(p: &LpvParams) -> Rows {
    grid_rows(p.coarse_dims)
}

/// A row of cells.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CellRow {
    /// Whether it is one, not a halo row.
    pub real: bool,
    /// Colour channel.
    pub channel: u32,
    /// Row in its layer.
    pub y: u32,
    /// Layer.
    pub z: u32,
}

/// What row an invocation of [`grid_rows`] is in.
#[inline(always)]
pub fn cell_row(at: At, dims: UVec4, l: &LpvLayout) -> CellRow {
    let channel = at.row / l.rows();
    let row = at.row - channel * l.rows();
    let per_layer = dims.y + 1;
    // One halo layer and one row before the first cell.
    let before = per_layer + 1;
    let cells = row.max(before) - before;
    let z = cells / per_layer;
    let y = cells - z * per_layer;
    CellRow { real: row >= before && y < dims.y && z < dims.z, channel, y, z }
}
