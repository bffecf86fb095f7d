//! A camera for scenes that bring none.

use super::super::{Camera, Scene};
use glam::Vec3;

/// Vertical field of view of made-up cameras (rad).
const FOVY_RAD: f32 = 0.9;

/// A camera that sees the whole scene from outside, slightly from above.
pub fn fit(scene: &Scene) -> Camera {
    let (lo, hi) = scene.bounds();
    let centre = 0.5 * (lo + hi);
    let radius = (0.5 * (hi - lo).length()).max(1e-6);
    let back = Vec3::new(0.5, 0.45, 1.0).normalize();
    let distance = radius / (0.5 * FOVY_RAD).sin();
    Camera::look_at("fitted", centre + back * distance, centre, FOVY_RAD)
}
