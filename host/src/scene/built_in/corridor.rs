//! A long corridor with bends.

use super::SceneBuilder;
use crate::scene::Scene;
use glam::Vec3;

/// Side of a cell of the plan, and height of the corridor (m).
const CELL: f32 = 1.5;
const HEIGHT: f32 = 2.5;

/// A closed corridor of three legs, 37.5 m along its middle, whose one end wall emits.
///
/// For: light that arrives only after many bounces: the last leg sees nothing that is lit directly.
pub fn corridor() -> Scene {
    let first = (0..9).map(|z| (0, z));
    let second = (1..9).map(|x| (x, 8));
    let third = (9..17).map(|z| (8, z));
    let cells: Vec<(i32, i32)> = first.chain(second).chain(third).collect();
    let mut b = SceneBuilder::new("corridor");
    let lamp = b.emitter("lit end", [0.5; 3], [30.0, 28.0, 25.0]);
    let white = b.diffuse("ceiling", [0.82, 0.82, 0.82]);
    let floor = b.diffuse("floor", [0.55, 0.5, 0.45]);
    let walls = [
        b.diffuse("first leg", [0.8, 0.78, 0.72]),
        b.diffuse("second leg", [0.8, 0.6, 0.4]),
        b.diffuse("third leg", [0.55, 0.65, 0.8]),
    ];
    for (i, &(x, z)) in cells.iter().enumerate() {
        let corner = Vec3::new(x as f32, 0.0, z as f32) * CELL;
        let (along_x, along_z, up) = (Vec3::X * CELL, Vec3::Z * CELL, Vec3::Y * HEIGHT);
        let wall = walls[if i < 9 {
            0
        } else if i < 17 {
            1
        } else {
            2
        }];
        b.parallelogram(corner, along_z, along_x, floor);
        b.parallelogram(corner + up, along_x, along_z, white);
        let sides = [
            ((x - 1, z), corner, up, along_z),
            ((x + 1, z), corner + along_x, along_z, up),
            ((x, z - 1), corner, along_x, up),
            ((x, z + 1), corner + along_z, up, along_x),
        ];
        for (neighbour, from, u, v) in sides {
            if !cells.contains(&neighbour) {
                b.parallelogram(from, u, v, if (i, neighbour) == (0, (0, -1)) { lamp } else { wall });
            }
        }
    }
    let middle = 8.5 * CELL;
    b.camera("second leg", [1.6, 1.5, middle - 0.3], [middle, 1.2, middle + 0.2], 60.0);
    b.camera("last leg", [middle + 0.3, 1.5, 15.9 * CELL], [middle, 1.2, middle], 60.0);
    b.camera("lit end", [0.9, 1.5, 8.0 * CELL], [CELL * 0.5, 1.2, 0.0], 60.0);
    b.finish()
}
