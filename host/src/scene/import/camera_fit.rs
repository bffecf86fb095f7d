//! A camera for scenes that bring none: inside a room, before the open side of a box, or outside of everything.
//!
//! Rays along the axes from a grid of points tell which: they need no acceleration structure.

use super::super::{Camera, Scene};
use glam::Vec3;

/// Vertical field of view of made-up cameras outside and before a box (rad).
const FOVY_RAD: f32 = 0.7;
/// Vertical field of view inside rooms (rad).
const FOVY_INSIDE_RAD: f32 = 1.1;
/// Height of the eye above the floor (m), and the largest part of a room's height that it may be.
const EYE_HEIGHT_M: f32 = 1.6;
const EYE_PART: f32 = 0.5;
/// Points of the grid along X, Y and Z.
const GRID: [usize; 3] = [9, 3, 9];
/// Part of the grid's points at which a room, or a box, must be found.
const ENOUGH: f32 = 0.12;
/// The horizontal axes' directions, each beside its opposite, and up.
const AROUND: [Vec3; 5] = [Vec3::X, Vec3::NEG_X, Vec3::Z, Vec3::NEG_Z, Vec3::Y];

/// A camera that shows the scene.
pub fn fit(scene: &Scene) -> Camera {
    let eyes = eyes(scene);
    let seen = cast(scene, &eyes, &AROUND);
    // Which of the four directions end on the front of a surface, for each eye.
    let walls: Vec<[bool; 4]> = seen.iter().map(|hits| std::array::from_fn(|i| hits[i].is_front)).collect();
    let enough = (ENOUGH * (GRID[0] * GRID[1] * GRID[2]) as f32) as usize;
    let rooms: Vec<usize> = (0..eyes.len()).filter(|&e| walls[e] == [true; 4]).collect();
    if rooms.len() >= enough {
        return inside(scene, &eyes, &seen, &rooms);
    }
    let open_side = (0..4).find(|&open| {
        let is_box =
            |e: &usize| (0..4).all(|i| if i == open { seen[*e][i].distance == f32::MAX } else { walls[*e][i] });
        (0..eyes.len()).filter(is_box).count() >= enough
    });
    match open_side {
        Some(side) => before(scene, AROUND[side]),
        None => outside(scene),
    }
}

/// Where a ray ends.
#[derive(Clone, Copy)]
struct End {
    /// `f32::MAX` where it meets nothing.
    distance: f32,
    /// Whether it meets a front.
    is_front: bool,
}

/// Points at eye height above the floors below a grid of points; points without a floor are left out.
fn eyes(scene: &Scene) -> Vec<Vec3> {
    let (lo, hi) = scene.bounds();
    let mut points = Vec::new();
    for i in 0..GRID[0] * GRID[1] * GRID[2] {
        let cell = [i % GRID[0], i / GRID[0] % GRID[1], i / (GRID[0] * GRID[1])];
        // Off the middle: symmetric scenes have edges there.
        let part = |axis: usize| (cell[axis] as f32 + 0.53) / GRID[axis] as f32;
        points.push(lo + (hi - lo) * Vec3::new(part(0), part(1), part(2)));
    }
    let vertical = cast(scene, &points, &[Vec3::NEG_Y, Vec3::Y]);
    let with_floor = points.into_iter().zip(vertical).filter(|(_, ends)| ends[0].is_front);
    let at_eye_height = with_floor.map(|(point, ends)| {
        let height = ends[0].distance + ends[1].distance.min(2.0 * EYE_HEIGHT_M);
        point.with_y(point.y - ends[0].distance + EYE_HEIGHT_M.min(EYE_PART * height))
    });
    at_eye_height.collect()
}

/// For each point, where rays along some axis directions end.
fn cast(scene: &Scene, points: &[Vec3], directions: &[Vec3]) -> Vec<Vec<End>> {
    let mut ends = vec![vec![End { distance: f32::MAX, is_front: false }; directions.len()]; points.len()];
    for triangle in &scene.triangles {
        let corners = scene.corners(triangle);
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let min = corners[0].min(corners[1]).min(corners[2]);
        let max = corners[0].max(corners[1]).max(corners[2]);
        for (d, &direction) in directions.iter().enumerate() {
            let across = Vec3::ONE - direction.abs();
            for (point, ends) in points.iter().zip(&mut ends) {
                // Whether the point lies beside the triangle's box, seen along the ray.
                if ((*point - min) * across).min_element() < 0.0 || ((max - *point) * across).min_element() < 0.0 {
                    continue;
                }
                if let Some(distance) = intersect(*point, direction, corners, normal)
                    && distance < ends[d].distance
                {
                    ends[d] = End { distance, is_front: normal.dot(direction) < 0.0 };
                }
            }
        }
    }
    ends
}

/// Distance along a ray to a triangle.
fn intersect(origin: Vec3, direction: Vec3, [a, b, c]: [Vec3; 3], normal: Vec3) -> Option<f32> {
    let slope = normal.dot(direction);
    let side = |p: Vec3, q: Vec3| (q - p).cross(origin - p).dot(direction);
    let sides = [side(a, b), side(b, c), side(c, a)];
    let is_inside = sides.iter().all(|&s| s >= 0.0) || sides.iter().all(|&s| s <= 0.0);
    let distance = normal.dot(a - origin) / slope;
    (is_inside && slope != 0.0 && distance > 0.0).then_some(distance)
}

/// At one end of a large room in the middle of the scene, looking along it.
fn inside(scene: &Scene, eyes: &[Vec3], seen: &[Vec<End>], rooms: &[usize]) -> Camera {
    /// Part of the room's length that the camera stands away from the wall behind it.
    const FROM_WALL: f32 = 0.06;
    let extent = |e: usize, axis: usize| seen[e][2 * axis].distance + seen[e][2 * axis + 1].distance;
    let (lo, hi) = scene.bounds();
    let height = |e: usize| EYE_HEIGHT_M + seen[e][4].distance.min(hi.y - eyes[e].y);
    // What lies at a scene's edge, behind its rooms, is seldom what it was made for.
    let from_middle = |e: usize| ((eyes[e] - 0.5 * (lo + hi)) / (hi - lo).max(Vec3::splat(1e-6))).with_y(0.0).length();
    let score = |e: &usize| extent(*e, 0) * extent(*e, 1) * height(*e) * (1.0 - from_middle(*e)).powi(4);
    let best = rooms.iter().copied().max_by(|a, b| score(a).total_cmp(&score(b))).unwrap_or(0);
    let axis = usize::from(extent(best, 1) > extent(best, 0));
    let length = extent(best, axis);
    let back = seen[best][2 * axis + 1].distance - FROM_WALL * length;
    let position = eyes[best] - AROUND[2 * axis] * back;
    Camera::look_at("fitted inside", position, position + AROUND[2 * axis] * length, FOVY_INSIDE_RAD)
}

/// Before the open side of a box, so that the opening fills the picture.
fn before(scene: &Scene, open: Vec3) -> Camera {
    let (lo, hi) = scene.bounds();
    let (centre, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let opening = half.y.max(half.dot(Vec3::ONE - Vec3::Y - open.abs()));
    let distance = half.dot(open.abs()) + 1.05 * opening / (0.5 * FOVY_RAD).tan();
    Camera::look_at("fitted before", centre + open * distance, centre, FOVY_RAD)
}

/// Outside, slightly above, so that the whole scene is seen.
fn outside(scene: &Scene) -> Camera {
    let (lo, hi) = scene.bounds();
    let centre = 0.5 * (lo + hi);
    let radius = (0.5 * (hi - lo).length()).max(1e-6);
    let back = Vec3::new(0.5, 0.45, 1.0).normalize();
    Camera::look_at("fitted outside", centre + back * radius / (0.5 * FOVY_RAD).sin(), centre, FOVY_RAD)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in;

    #[test]
    fn a_closed_room_is_seen_from_inside() {
        let scene = built_in::two_rooms(0.2, 0.0);
        let camera = fit(&scene);
        let (lo, hi) = scene.bounds();
        assert!(camera.position.cmpgt(lo).all() && camera.position.cmplt(hi).all(), "{camera:?}");
        assert_eq!(camera.name, "fitted inside");
    }

    #[test]
    fn a_box_with_an_open_side_is_seen_through_it() {
        let camera = fit(&built_in::cornell_box());
        assert_eq!((camera.name.as_str(), camera.forward), ("fitted before", Vec3::Z));
        assert!(camera.position.z < -0.3, "{camera:?}");
    }

    #[test]
    fn an_object_is_seen_from_outside_as_a_whole() {
        let mut b = built_in::SceneBuilder::new("block");
        let grey = b.diffuse("grey", [0.5; 3]);
        b.block([0.0; 3], [1.0, 2.0, 1.0], grey);
        let scene = b.finish();
        let camera = fit(&scene);
        assert_eq!(camera.name, "fitted outside");
        let centre = Vec3::new(0.5, 1.0, 0.5);
        for &corner in &scene.positions {
            let cos = (corner - camera.position).normalize().dot((centre - camera.position).normalize());
            assert!(cos > (0.5 * camera.fovy_rad).cos(), "{corner} is outside the picture");
        }
    }
}
