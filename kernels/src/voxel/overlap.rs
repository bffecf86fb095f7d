//! Exact overlap of a triangle and a voxel, and the part of the triangle inside it.
//!
//! [`touches`]: separating axis test (Akenine-Möller 2001, "Fast 3D Triangle-Box Overlap Testing"): 3 box normals, 9
//! cross products of edges, the triangle's normal. Both sets are closed: touching counts. Deviation: the plane test has
//! a margin for the rounding of a long, thin triangle's normal, so that slivers keep their voxels; the other twelve axes
//! decide there.
//!
//! [`clip`]: Sutherland & Hodgman 1974 against the six sides. A piece that lies in a side belongs to the voxel above it,
//! so that areas add up to the triangle's whichever way it lies.

use super::grid::of_axis;
use crate::math::float::{abs, max, min};
use crate::math::vector::length;
use glam::Vec3;

/// Rounding of the normal and of its product with a corner, relative to the product of their largest terms: 2⁻²⁴ times
/// six operations.
const PLANE_ROUNDING: f32 = 3.6e-7;

/// Whether a triangle touches the closed unit cube around the origin; corners relative to the cube's centre.
#[inline(always)]
pub fn touches(a: Vec3, b: Vec3, c: Vec3) -> bool {
    let low = Vec3::new(min(min(a.x, b.x), c.x), min(min(a.y, b.y), c.y), min(min(a.z, b.z), c.z));
    let high = Vec3::new(max(max(a.x, b.x), c.x), max(max(a.y, b.y), c.y), max(max(a.z, b.z), c.z));
    if low.x > 0.5 || low.y > 0.5 || low.z > 0.5 || high.x < -0.5 || high.y < -0.5 || high.z < -0.5 {
        return false;
    }
    let (ab, bc, ca) = (b - a, c - b, a - c);
    if edge_separates(ab, a, c) || edge_separates(bc, b, a) || edge_separates(ca, c, b) {
        return false;
    }
    // The two shorter edges: their cross product rounds least.
    let (dab, dbc, dca) = (sum_abs(ab), sum_abs(bc), sum_abs(ca));
    let (first, second) = if dab >= dbc && dab >= dca {
        (bc, ca)
    } else if dbc >= dca {
        (ca, ab)
    } else {
        (ab, bc)
    };
    let n = first.cross(second);
    let reach = 0.5 * (abs(n.x) + abs(n.y) + abs(n.z));
    let (la, lb, lc) = (sum_abs(a), sum_abs(b), sum_abs(c));
    // The corner nearest to the cube rounds least.
    let nearest = if la <= lb && la <= lc {
        a
    } else if lb <= lc {
        b
    } else {
        c
    };
    let margin = PLANE_ROUNDING * min(min(la, lb), lc) * sum_abs(first) * sum_abs(second);
    abs(n.dot(nearest)) <= reach + margin
}

#[inline(always)]
fn sum_abs(v: Vec3) -> f32 {
    abs(v.x) + abs(v.y) + abs(v.z)
}

/// Whether one of the axes `edge × x`, `edge × y`, `edge × z` separates; `on` lies on the edge, `off` is the third corner.
#[inline(always)]
fn edge_separates(edge: Vec3, on: Vec3, off: Vec3) -> bool {
    axis_separates(edge.y, edge.z, on.y, on.z, off.y, off.z)
        || axis_separates(edge.z, edge.x, on.z, on.x, off.z, off.x)
        || axis_separates(edge.x, edge.y, on.x, on.y, off.x, off.y)
}

/// The projection of the triangle on the normal of an edge in one coordinate plane, against the square's.
#[inline(always)]
pub fn axis_separates(edge_u: f32, edge_v: f32, on_u: f32, on_v: f32, off_u: f32, off_v: f32) -> bool {
    let p = edge_u * on_v - edge_v * on_u;
    let q = edge_u * off_v - edge_v * off_u;
    let reach = 0.5 * (abs(edge_u) + abs(edge_v));
    min(p, q) > reach || max(p, q) < -reach
}

/// Corners of a triangle clipped by six planes, at most; one more while a plane is at work.
const MAX_CORNERS: usize = 10;

/// A convex polygon.
#[derive(Clone, Copy)]
pub struct Polygon {
    corners: [Vec3; MAX_CORNERS],
    count: usize,
}

/// The part of a triangle inside a voxel.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Piece {
    /// Area in voxel faces.
    pub area: f32,
    /// Centroid; without area, a point of the piece or the nearest corner of the triangle's part.
    pub centroid: Vec3,
}

/// Area and centroid of the part of a triangle inside the cube 0 … 1, in the cube's coordinates. The centroid lies inside
/// the cube.
#[inline(always)]
pub fn clip(a: Vec3, b: Vec3, c: Vec3) -> Piece {
    let mut corners = [Vec3::ZERO; MAX_CORNERS];
    corners[0] = a;
    corners[1] = b;
    corners[2] = c;
    let mut polygon = Polygon { corners, count: 3 };
    for side in 0..6 {
        cut(&mut polygon, side);
    }
    measure(&polygon)
}

/// Distance of a point from a side of the cube (x = 0, x = 1, y = 0, …), positive on the cube's.
#[inline(always)]
fn distance_within(p: Vec3, side: u32) -> f32 {
    let along = of_axis(side >> 1, p.x, p.y, p.z);
    if side & 1 == 1 { 1.0 - along } else { along }
}

/// Keeps what lies on the cube's side of one of its sides.
#[inline(always)]
fn cut(polygon: &mut Polygon, side: u32) {
    let mut lowest = 0.0f32;
    for i in 0..polygon.count {
        lowest = min(lowest, distance_within(polygon.corners[i], side));
    }
    if lowest >= 0.0 || polygon.count == 0 {
        return;
    }
    let mut kept = [Vec3::ZERO; MAX_CORNERS];
    let mut count = 0;
    let mut previous = polygon.corners[polygon.count - 1];
    let mut previous_distance = distance_within(previous, side);
    for i in 0..polygon.count {
        let corner = polygon.corners[i];
        let distance = distance_within(corner, side);
        if (distance < 0.0) != (previous_distance < 0.0) && count < MAX_CORNERS {
            kept[count] = previous + (corner - previous) * (previous_distance / (previous_distance - distance));
            count += 1;
        }
        if distance >= 0.0 && count < MAX_CORNERS {
            kept[count] = corner;
            count += 1;
        }
        previous = corner;
        previous_distance = distance;
    }
    polygon.corners = kept;
    polygon.count = count;
}

/// Area and centroid by a fan of triangles.
#[inline(always)]
fn measure(polygon: &Polygon) -> Piece {
    let first = polygon.corners[0];
    let mut lowest = first;
    let (mut area, mut moment) = (0.0, Vec3::ZERO);
    for i in 1..polygon.count {
        let corner = polygon.corners[i];
        lowest = Vec3::new(min(lowest.x, corner.x), min(lowest.y, corner.y), min(lowest.z, corner.z));
        if i + 1 < polygon.count {
            let next = polygon.corners[i + 1];
            let part = 0.5 * length((corner - first).cross(next - first));
            area += part;
            moment += (corner + next - first * 2.0) * (part / 3.0);
        }
    }
    // A piece in the upper sides is the next voxel's.
    let shared = polygon.count == 0 || lowest.x >= 1.0 || lowest.y >= 1.0 || lowest.z >= 1.0;
    let centroid = if area > 0.0 { first + moment / area } else { first };
    Piece { area: if shared { 0.0 } else { area }, centroid: unit_cube(centroid) }
}

#[inline(always)]
fn unit_cube(p: Vec3) -> Vec3 {
    Vec3::new(min(max(p.x, 0.0), 1.0), min(max(p.y, 0.0), 1.0), min(max(p.z, 0.0), 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_in_a_side_touches_both_voxels_and_has_its_area_in_one() {
        let t = |x: f32| [Vec3::new(x, -2.0, -2.0), Vec3::new(x, 4.0, -2.0), Vec3::new(x, -2.0, 4.0)];
        for (x, area) in [(0.0, 1.0), (1.0, 0.0), (0.5, 1.0)] {
            let [a, b, c] = t(x);
            let half = Vec3::splat(0.5);
            assert!(touches(a - half, b - half, c - half), "{x}");
            let piece = clip(a, b, c);
            assert_eq!((piece.area, piece.centroid), (area, Vec3::new(x, 0.5, 0.5)));
        }
        let [a, b, c] = t(1.5);
        assert!(!touches(a - 0.5, b - 0.5, c - 0.5));
    }

    #[test]
    fn the_largest_section_of_a_cube_is_found() {
        // x + y + z = 3/2: a regular hexagon of area 3√3/4.
        let n = Vec3::splat(0.5);
        let (u, v) = (Vec3::new(1.0, -1.0, 0.0) * 9.0, Vec3::new(1.0, 1.0, -2.0) * 9.0);
        let piece = clip(n - u - v, n + u - v, n + v);
        assert!((piece.area - 0.75 * 3.0f32.sqrt()).abs() < 1e-5 && (piece.centroid - n).length() < 1e-5);
    }
}
