//! The Cornell box.

use super::SceneBuilder;
use crate::scene::Scene;
use glam::Vec3;

/// Linear sRGB reflectances of the published spectra (CIE 1931 observer, under D65, a perfect reflector = 1 1 1).
const WHITE: [f32; 3] = [0.7384, 0.7358, 0.7399];
const GREEN: [f32; 3] = [0.0686, 0.3979, 0.0867];
const RED: [f32; 3] = [0.4936, 0.0492, 0.0512];
/// Reflectance of the lamp.
const LAMP: f32 = 0.78;
/// Radiance of the lamp (relative): its published spectrum weighted by the observer, over the integral of ȳ.
const LAMP_RADIANCE: [f32; 3] = [20.7259, 10.8607, 2.7725];

/// Corners of a face in millimetres, as published.
type FaceMm = [[f32; 3]; 4];

const FLOOR: FaceMm = [[552.8, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 559.2], [549.6, 0.0, 559.2]];
const CEILING: FaceMm = [[556.0, 548.8, 0.0], [556.0, 548.8, 559.2], [0.0, 548.8, 559.2], [0.0, 548.8, 0.0]];
const BACK: FaceMm = [[549.6, 0.0, 559.2], [0.0, 0.0, 559.2], [0.0, 548.8, 559.2], [556.0, 548.8, 559.2]];
const RIGHT: FaceMm = [[0.0, 0.0, 559.2], [0.0, 0.0, 0.0], [0.0, 548.8, 0.0], [0.0, 548.8, 559.2]];
const LEFT: FaceMm = [[552.8, 0.0, 0.0], [549.6, 0.0, 559.2], [556.0, 548.8, 559.2], [556.0, 548.8, 0.0]];
/// Half a millimetre below the published height, so that the lamp does not lie in the ceiling.
const LAMP_FACE: FaceMm = [[343.0, 548.3, 227.0], [343.0, 548.3, 332.0], [213.0, 548.3, 332.0], [213.0, 548.3, 227.0]];
/// The top faces of the two blocks, counter-clockwise from above: their sides are vertical.
const SHORT_BLOCK: FaceMm = [[130.0, 165.0, 65.0], [82.0, 165.0, 225.0], [240.0, 165.0, 272.0], [290.0, 165.0, 114.0]];
const TALL_BLOCK: FaceMm = [[423.0, 330.0, 247.0], [265.0, 330.0, 296.0], [314.0, 330.0, 456.0], [472.0, 330.0, 406.0]];

/// The Cornell box with the data that the Cornell University Program of Computer Graphics measured and published.
///
/// For: colour bleeding, soft shadows, a small area light; the scene on which everybody compares. Open towards the
/// camera. Deviation: the lamp hangs 0.5 mm below the ceiling, in which it would lie otherwise.
pub fn cornell_box() -> Scene {
    let mut b = SceneBuilder::new("cornell-box");
    let white = b.diffuse("white", WHITE);
    let green = b.diffuse("green", GREEN);
    let red = b.diffuse("red", RED);
    let lamp = b.emitter("light", [LAMP; 3], LAMP_RADIANCE);
    for (face, material) in [(FLOOR, white), (CEILING, white), (BACK, white), (RIGHT, green), (LEFT, red)] {
        b.quad(face.map(metres), material);
    }
    for top in [SHORT_BLOCK, TALL_BLOCK] {
        b.quad(top.map(metres), white);
        for side in 0..4 {
            let (from, to) = (metres(top[side]), metres(top[(side + 3) % 4]));
            let ground = |p: Vec3| Vec3::new(p.x, 0.0, p.z);
            b.quad([ground(from), from, to, ground(to)], white);
        }
    }
    b.quad(LAMP_FACE.map(metres), lamp);
    b.camera("published", [0.278, 0.273, -0.8], [0.278, 0.273, 0.0], 39.3077);
    b.finish()
}

fn metres(mm: [f32; 3]) -> Vec3 {
    Vec3::from_array(mm.map(|c| (f64::from(c) / 1000.0) as f32))
}
