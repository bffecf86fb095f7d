//! Two rooms and the wall between them.

use super::SceneBuilder;
use crate::scene::Scene;

/// Depth to which inner walls reach into the outer ones (m), so that no ray slips through the joint.
const EMBEDDED_M: f32 = 0.01;

/// Two rooms of 3 × 3 × 3 m, side by side along X, with a wall of `wall_m` metres centred on x = 0 between them. The left
/// one (x < 0) has a ceiling lamp. The wall has a gap of `door_m` metres at its +Z end, 2.1 m high; 0 seals the dark room.
///
/// For: light leaks through thin walls (sealed: the dark room must be black), and light through a narrow opening. The
/// default camera stands in the dark room; `lit` in the lit one.
pub fn two_rooms(wall_m: f32, door_m: f32) -> Scene {
    const SIDE: f32 = 3.0;
    const DOOR_HEIGHT: f32 = 2.1;
    let mut b = SceneBuilder::new("two-rooms");
    let plaster = b.diffuse("plaster", [0.75, 0.74, 0.72]);
    let floor = b.diffuse("floor", [0.45, 0.35, 0.25]);
    let red = b.diffuse("red wall", [0.6, 0.15, 0.1]);
    let blue = b.diffuse("blue wall", [0.15, 0.25, 0.6]);
    let inner = b.diffuse("inner wall", [0.75, 0.75, 0.75]);
    let crate_ = b.diffuse("crate", [0.55, 0.5, 0.2]);
    let lamp = b.emitter("lamp", [0.0; 3], [12.0, 11.0, 9.5]);
    let half = 0.5 * wall_m;
    let reach = SIDE + half;
    b.room([-reach, 0.0, 0.0], [reach, SIDE, SIDE], [red, blue, floor, plaster, plaster, plaster]);
    let (low, high) = (-EMBEDDED_M, SIDE + EMBEDDED_M);
    let door_m = door_m.clamp(0.0, SIDE);
    if door_m > 0.0 {
        let hinge = SIDE - door_m;
        b.block([-half, low, low], [half, high, hinge], inner);
        b.block([-half, DOOR_HEIGHT, hinge], [half, high, high], inner);
    } else {
        b.block([-half, low, low], [half, high, high], inner);
    }
    let lamp_y = SIDE - 0.01;
    let lamp_x = -half - 0.5 * SIDE;
    b.quad(
        [
            [lamp_x - 0.5, lamp_y, 1.0],
            [lamp_x + 0.5, lamp_y, 1.0],
            [lamp_x + 0.5, lamp_y, 2.0],
            [lamp_x - 0.5, lamp_y, 2.0],
        ],
        lamp,
    );
    b.block([half + 1.6, 0.0, 0.5], [half + 2.3, 0.7, 1.2], crate_);
    b.camera("dark", [reach - 0.2, 1.5, 0.3], [half, 1.0, 2.2], 65.0);
    b.camera("lit", [-reach + 0.2, 1.5, 0.3], [-half, 1.0, 2.2], 65.0);
    b.finish()
}
