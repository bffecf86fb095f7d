//! A room behind louvres.

use super::SceneBuilder;
use crate::scene::{Light, Scene};
use glam::Vec3;

/// A room of 4 × 2.8 × 5 m with one window, before which 27 slats hang, each 1 mm thick, lit by sun and sky through them.
///
/// For: surfaces thinner than any voxel. A voxel grid either loses the slats (too much light) or closes the gaps (too
/// little); the stripes on the floor show what is left of them.
pub fn louvres() -> Scene {
    let size = Vec3::new(4.0, 2.8, 5.0);
    let mut b = SceneBuilder::new("louvres");
    let plaster = b.diffuse("plaster", [0.78, 0.76, 0.72]);
    let wood = b.diffuse("floor boards", [0.5, 0.32, 0.18]);
    let red = b.diffuse("red wall", [0.62, 0.16, 0.12]);
    let slat = b.diffuse("slat", [0.65, 0.65, 0.62]);
    let table = b.diffuse("table", [0.35, 0.22, 0.12]);
    shell(&mut b, size, [plaster, wood, red]);
    // Tilted so that the lower edge is inside: the sun comes through at 35°, the eye does not.
    let tilt = 30.0_f32.to_radians();
    let across = Vec3::new(-tilt.cos(), tilt.sin(), 0.0) * 0.05;
    let thickness = Vec3::new(tilt.sin(), tilt.cos(), 0.0) * 0.001;
    for i in 0..27 {
        let inner_edge = Vec3::new(-0.06, 0.82 + 0.06 * i as f32, 0.5);
        b.cuboid(inner_edge, Vec3::Z * 4.0, thickness, across * -1.0 + across * 2.0, slat);
    }
    b.block([1.6, 0.7, 1.6], [2.8, 0.74, 3.2], table);
    for (x, z) in [(1.65, 1.65), (2.7, 1.65), (1.65, 3.1), (2.7, 3.1)] {
        b.block([x, 0.0, z], [x + 0.05, 0.7, z + 0.05], table);
    }
    let direction = Vec3::new(1.0, -0.6, 0.25).normalize();
    b.light(Light::Directional { direction, irradiance: Vec3::new(30.0, 28.5, 26.0) });
    b.environment(Vec3::new(1.2, 1.5, 2.0));
    b.camera("inside", [3.8, 1.5, 4.7], [0.6, 1.0, 1.4], 68.0);
    b.finish()
}

/// Floor, ceiling and walls, 0.2 m thick, around the room from 0 to `size`; a window of 4 × 1.6 m in the wall at x = 0.
fn shell(b: &mut SceneBuilder, size: Vec3, [plaster, floor, red]: [u32; 3]) {
    const T: f32 = 0.2;
    b.block([-T, -T, -T], [size.x + T, 0.0, size.z + T], floor);
    b.block([-T, size.y, -T], [size.x + T, size.y + T, size.z + T], plaster);
    b.block([-T, 0.0, -T], [size.x + T, size.y, 0.0], red);
    b.block([-T, 0.0, size.z], [size.x + T, size.y, size.z + T], plaster);
    b.block([size.x, 0.0, 0.0], [size.x + T, size.y, size.z], plaster);
    b.block([-T, 0.0, 0.0], [0.0, 0.8, size.z], plaster);
    b.block([-T, 2.4, 0.0], [0.0, size.y, size.z], plaster);
    b.block([-T, 0.8, 0.0], [0.0, 2.4, 0.5], plaster);
    b.block([-T, 0.8, 4.5], [0.0, 2.4, size.z], plaster);
}
