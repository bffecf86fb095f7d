//! Work of voxelization: tiles of 4 × 4 columns of voxels.
//!
//! A triangle is seen along the axis that its plane faces most. Its columns along that axis are cut into tiles, and one
//! invocation walks one tile: a column holds at most four voxels of the triangle's plane (slope ≤ 1 along both sides), so
//! that work per invocation is bounded whatever the triangle's size, and a triangle across the scene is spread over many
//! invocations. (A tree of boxes would skip empty tiles of a diagonal triangle; half of its tiles are empty, and each
//! costs one test.)

use super::grid::{Grid, dominant_axis, from_axis, grid_from_world, to_axis, touched};
use super::overlap::{axis_separates, touches};
use crate::math::float::{abs, floor, max, min};
use glam::{UVec3, Vec3};
use interreflect_shared::scene::SceneTriangle;
use interreflect_shared::voxel::TILE;

/// A triangle in voxels of level 0, turned so that z is the axis that its plane faces most, and the columns it touches.
#[derive(Clone, Copy)]
pub struct GridTriangle {
    /// Corners.
    pub a: Vec3,
    /// Second corner.
    pub b: Vec3,
    /// Third corner.
    pub c: Vec3,
    /// Cross product of two edges in the grid's own axes: front normal times twice the area.
    pub normal: Vec3,
    /// Axis that became z.
    pub axis: u32,
    /// Voxels along the turned axes.
    pub dims: Vec3,
    u_first: i32,
    u_last: i32,
    v_first: i32,
    v_last: i32,
}

impl GridTriangle {
    /// Turns a triangle.
    #[inline(always)]
    pub fn new<G: Grid>(grid: &G, triangle: &SceneTriangle) -> Self {
        let a = grid_from_world(grid, Vec3::from_array(triangle.v0));
        let b = grid_from_world(grid, Vec3::from_array(triangle.v1));
        let c = grid_from_world(grid, Vec3::from_array(triangle.v2));
        let normal = (b - a).cross(c - a);
        let axis = dominant_axis(normal);
        let d = grid.dims_levels();
        let dims = to_axis(Vec3::new(d.x as f32, d.y as f32, d.z as f32), axis);
        let (a, b, c) = (to_axis(a, axis), to_axis(b, axis), to_axis(c, axis));
        let (u_first, u_last) = touched(min(min(a.x, b.x), c.x), max(max(a.x, b.x), c.x), dims.x);
        let (v_first, v_last) = touched(min(min(a.y, b.y), c.y), max(max(a.y, b.y), c.y), dims.y);
        Self { a, b, c, normal, axis, dims, u_first, u_last, v_first, v_last }
    }

    #[inline(always)]
    fn tiles_along_u(&self) -> u32 {
        if self.u_last < self.u_first { 0 } else { (self.u_last - self.u_first) as u32 / TILE + 1 }
    }

    /// Number of tiles.
    #[inline(always)]
    pub fn tiles(&self) -> u32 {
        let along_v = if self.v_last < self.v_first { 0 } else { (self.v_last - self.v_first) as u32 / TILE + 1 };
        self.tiles_along_u() * along_v
    }
}

/// Walks the voxels of one tile that the triangle touches.
pub struct TileWalk {
    triangle: GridTriangle,
    ill_conditioned: bool,
    u_first: i32,
    u_end: i32,
    v_end: i32,
    w_first: i32,
    w_last: i32,
    u: i32,
    v: i32,
    w: i32,
    column_w_last: i32,
}

/// Below this share of the product of its edges' lengths and the longest of them (in voxels), a cross product is too
/// inexact to tell the plane's depth within a quarter of a voxel: four times the rounding of its terms.
const ILL_CONDITIONED: f32 = 4e-6;

impl TileWalk {
    /// Starts at tile `tile` of a triangle.
    #[inline(always)]
    pub fn new(triangle: GridTriangle, tile: u32) -> Self {
        let along_u = triangle.tiles_along_u().max(1);
        let tile_v = tile / along_u;
        let u_first = triangle.u_first + ((tile - tile_v * along_u) * TILE) as i32;
        let v_first = triangle.v_first + (tile_v * TILE) as i32;
        let (a, b, c) = (triangle.a, triangle.b, triangle.c);
        let (w_first, w_last) = touched(min(min(a.z, b.z), c.z), max(max(a.z, b.z), c.z), triangle.dims.z);
        let (ab, ac) = (sum_abs(b - a), sum_abs(c - a));
        let n = triangle.normal;
        let largest = max(max(abs(n.x), abs(n.y)), abs(n.z));
        let mut walk = Self {
            triangle,
            ill_conditioned: largest <= ILL_CONDITIONED * ab * ac * max(ab, ac),
            u_first,
            u_end: (u_first + TILE as i32).min(triangle.u_last + 1),
            v_end: (v_first + TILE as i32).min(triangle.v_last + 1),
            w_first,
            w_last,
            u: u_first - 1,
            v: v_first,
            w: 0,
            column_w_last: -1,
        };
        if walk.tile_is_empty() {
            walk.v_end = v_first;
        }
        walk
    }

    /// Whether one of the triangle's edges has the whole tile on its outer side.
    #[inline(always)]
    fn tile_is_empty(&self) -> bool {
        let half = 0.5 * TILE as f32;
        let centre = Vec3::new(self.u_first as f32 + half, self.v as f32 + half, 0.0);
        // In units of the tile's side, with a margin for rounding: a tile too many costs nothing but time.
        let scale = 1.0 / (TILE as f32 + 0.01);
        let t = &self.triangle;
        let (a, b, c) = ((t.a - centre) * scale, (t.b - centre) * scale, (t.c - centre) * scale);
        let separates = |p: Vec3, q: Vec3, off: Vec3| axis_separates(q.x - p.x, q.y - p.y, p.x, p.y, off.x, off.y);
        separates(a, b, c) || separates(b, c, a) || separates(c, a, b)
    }

    /// Goes to the next voxel; false after the last.
    #[inline(always)]
    pub fn advance(&mut self) -> bool {
        while self.v < self.v_end {
            while self.w < self.column_w_last {
                self.w += 1;
                let centre = self.corner() + Vec3::splat(0.5);
                let t = &self.triangle;
                if touches(t.a - centre, t.b - centre, t.c - centre) {
                    return true;
                }
            }
            self.u += 1;
            if self.u >= self.u_end {
                self.u = self.u_first;
                self.v += 1;
            }
            self.start_column();
        }
        false
    }

    /// Lower corner of the present voxel in the turned axes.
    #[inline(always)]
    pub fn corner(&self) -> Vec3 {
        Vec3::new(self.u as f32, self.v as f32, self.w as f32)
    }

    /// The present voxel in the grid's own axes.
    #[inline(always)]
    pub fn voxel(&self) -> UVec3 {
        let v = from_axis(self.corner(), self.triangle.axis);
        UVec3::new(v.x as u32, v.y as u32, v.z as u32)
    }

    /// Finds the voxels of the column that the triangle's plane may touch.
    #[inline(always)]
    fn start_column(&mut self) {
        let (low, high) = if self.ill_conditioned { self.edge_depths() } else { self.plane_depths() };
        self.w = max(low, self.w_first as f32) as i32 - 1;
        self.column_w_last = min(high, self.w_last as f32) as i32;
    }

    /// First and last voxel that the plane touches in the column, and up to one more on each side for rounding.
    #[inline(always)]
    fn plane_depths(&self) -> (f32, f32) {
        let t = &self.triangle;
        let n = to_axis(t.normal, t.axis);
        let (u, v) = (self.u as f32 + 0.5, self.v as f32 + 0.5);
        let depth = t.a.z - (n.x * (u - t.a.x) + n.y * (v - t.a.y)) / n.z;
        let half = 0.5 * (abs(n.x) + abs(n.y)) / abs(n.z) + PLANE_SLACK;
        (-floor(half - depth) - 1.0, floor(depth + half))
    }

    /// The depths of the triangle's edges over the column, and one voxel more on each side: for triangles too thin for
    /// their plane to be known, all of whose points lie near an edge.
    fn edge_depths(&self) -> (f32, f32) {
        let t = &self.triangle;
        let (low_ab, high_ab) = self.edge_depth(t.a, t.b);
        let (low_bc, high_bc) = self.edge_depth(t.b, t.c);
        let (low_ca, high_ca) = self.edge_depth(t.c, t.a);
        (floor(min(min(low_ab, low_bc), low_ca)) - 1.0, floor(max(max(high_ab, high_bc), high_ca)) + 1.0)
    }

    /// Depth interval of the part of a segment over the column; an inverted one where there is none.
    #[inline(always)]
    fn edge_depth(&self, from: Vec3, to: Vec3) -> (f32, f32) {
        let d = to - from;
        let (u0, u1) = slab(from.x, d.x, self.u as f32);
        let (v0, v1) = slab(from.y, d.y, self.v as f32);
        let (first, last) = (max(max(u0, v0), 0.0), min(min(u1, v1), 1.0));
        if first > last {
            return (self.triangle.dims.z, -2.0);
        }
        let (p, q) = (from.z + d.z * first, from.z + d.z * last);
        (min(p, q), max(p, q))
    }
}

/// Share of a voxel that a well-conditioned plane's depth may be off.
const PLANE_SLACK: f32 = 0.3;

/// Parameters at which a coordinate enters and leaves a voxel, widened by a hundredth of a voxel.
#[inline(always)]
fn slab(from: f32, step: f32, voxel: f32) -> (f32, f32) {
    let (low, high) = (voxel - 0.01 - from, voxel + 1.01 - from);
    if abs(step) < 1e-6 {
        return if low <= 0.0 && high >= 0.0 { (0.0, 1.0) } else { (1.0, 0.0) };
    }
    let (p, q) = (low / step, high / step);
    (min(p, q), max(p, q))
}

#[inline(always)]
fn sum_abs(v: Vec3) -> f32 {
    abs(v.x) + abs(v.y) + abs(v.z)
}
