//! The Blue-Orange Box.

use super::SceneBuilder;
use crate::scene::{Light, Scene};
use glam::Vec3;

/// A box like the Cornell box, but longer, with a blue and an orange wall, with blocks close to its surfaces, and lit by
/// one directional light through its open front: the test scene of the thesis on an implementation of sparse radiance
/// probes (§6.1, table 6.2), which describes it in these words and gives 96 triangles. The dimensions are not published:
/// these are ours, with the same number of triangles (five slabs and three blocks).
///
/// For: indirect shadows between blocks and walls, and colour bleeding, where all light in the far half is indirect.
pub fn blue_orange_box() -> Scene {
    const WIDTH: f32 = 2.0;
    const HEIGHT: f32 = 2.0;
    const LENGTH: f32 = 4.5;
    const SLAB: f32 = 0.1;
    let mut b = SceneBuilder::new("blue-orange-box");
    let white = b.diffuse("white", [0.75, 0.75, 0.75]);
    let blue = b.diffuse("blue", [0.08, 0.2, 0.65]);
    let orange = b.diffuse("orange", [0.8, 0.35, 0.05]);
    b.block([-SLAB, -SLAB, 0.0], [WIDTH + SLAB, 0.0, LENGTH], white);
    b.block([-SLAB, HEIGHT, 0.0], [WIDTH + SLAB, HEIGHT + SLAB, LENGTH], white);
    b.block([-SLAB, 0.0, 0.0], [0.0, HEIGHT, LENGTH], blue);
    b.block([WIDTH, 0.0, 0.0], [WIDTH + SLAB, HEIGHT, LENGTH], orange);
    b.block([-SLAB, -SLAB, -SLAB], [WIDTH + SLAB, HEIGHT + SLAB, 0.0], white);
    // Close to the blue wall, close to the orange wall, and floating just below the ceiling.
    b.block([0.06, 0.04, 2.0], [0.56, 1.2, 2.5], white);
    b.cuboid(Vec3::new(1.34, 0.03, 1.3), Vec3::new(0.5, 0.0, -0.12), Vec3::Y * 0.6, Vec3::new(0.12, 0.0, 0.5), white);
    b.block([0.8, 1.75, 0.7], [1.4, 1.94, 1.3], white);
    let direction = Vec3::new(0.2, -0.62, -0.9).normalize();
    b.light(Light::Directional { direction, irradiance: Vec3::new(20.0, 19.0, 17.5) });
    b.camera("front", [1.0, 1.0, 7.4], [1.0, 0.95, 0.0], 38.0);
    b.camera("inside", [1.0, 1.1, 4.2], [1.0, 0.9, 0.0], 65.0);
    b.finish()
}
