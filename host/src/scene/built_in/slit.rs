//! A dark room with a slit in its roof.

use super::SceneBuilder;
use crate::scene::{Light, Scene};
use glam::Vec3;

/// A closed room of 3 × 2.5 × 3 m, lit only by the sun through a slit of 3 cm in its roof: the sunlit strip on the floor,
/// beside a wall and a low plinth, is a small and bright secondary source next to its receivers.
///
/// For: the failure of sparse radiance probes (Silvennoinen and Timonen 2015, fig. 12): probes too sparse, and of too
/// few coefficients, for light that varies over centimetres.
pub fn slit() -> Scene {
    const T: f32 = 0.1;
    const SLIT: (f32, f32) = (2.45, 2.48);
    let size = Vec3::new(3.0, 2.5, 3.0);
    let mut b = SceneBuilder::new("slit");
    let white = b.diffuse("white", [0.75, 0.75, 0.75]);
    let green = b.diffuse("green plinth", [0.2, 0.55, 0.2]);
    let floor = b.diffuse("floor", [0.8, 0.78, 0.7]);
    let red = b.diffuse("red block", [0.65, 0.15, 0.1]);
    b.block([-T, -T, -T], [size.x + T, 0.0, size.z + T], floor);
    b.block([-T, 0.0, -T], [size.x + T, size.y + T, 0.0], white);
    b.block([-T, 0.0, size.z], [size.x + T, size.y + T, size.z + T], white);
    b.block([-T, 0.0, 0.0], [0.0, size.y + T, size.z], white);
    b.block([size.x, 0.0, 0.0], [size.x + T, size.y + T, size.z], white);
    // The roof is a thin sheet at the slit, so that the strip is as wide as the slit.
    b.block([0.0, size.y, 0.0], [SLIT.0, size.y + 0.002, size.z], white);
    b.block([SLIT.1, size.y, 0.0], [size.x, size.y + 0.002, size.z], white);
    b.block([2.2, 0.0, 1.0], [2.62, 0.25, 1.9], green);
    b.block([1.0, 0.0, 0.4], [1.6, 0.8, 1.0], red);
    // 0.35 m towards the wall on the way down: the strip lies 15 to 20 cm from it.
    let direction = Vec3::new(0.35, -size.y, 0.0).normalize();
    b.light(Light::Directional { direction, irradiance: Vec3::new(400.0, 380.0, 350.0) });
    b.camera("corner", [0.9, 1.3, 2.7], [2.75, 0.3, 1.2], 55.0);
    b.finish()
}
