//! Scenes made in code: nothing to download, the same everywhere. Each has a default camera, and its function's doc
//! says what it is for. All are in metres.

mod blue_orange_box;
mod build;
mod colonnade;
mod cornell;
mod corridor;
mod furnace;
mod louvres;
mod many_lights;
mod rooms;
mod slit;

pub use blue_orange_box::blue_orange_box;
pub use build::SceneBuilder;
pub(crate) use build::hash_unit;
pub use colonnade::colonnade;
pub use cornell::cornell_box;
pub use corridor::corridor;
pub use furnace::{furnace, parallel_squares, sphere_furnace};
pub use louvres::louvres;
pub use many_lights::many_lights;
pub use rooms::two_rooms;
pub use slit::slit;

use super::Scene;

/// A scene made in code.
#[derive(Clone, Copy, Debug)]
pub struct BuiltIn {
    /// Name on the command line.
    pub name: &'static str,
    /// What it is for, in a line.
    pub summary: &'static str,
    /// Makes it.
    pub make: fn() -> Scene,
}

/// All built-in scenes.
pub const BUILT_IN: &[BuiltIn] = &[
    BuiltIn {
        name: "cornell-box",
        summary: "the Cornell box as measured: colour bleeding, soft shadows, a small lamp",
        make: cornell_box,
    },
    BuiltIn {
        name: "furnace",
        summary: "closed cube that emits 1 and reflects half: radiance is 2 everywhere, to check energy",
        make: || furnace(0.5, 1.0),
    },
    BuiltIn {
        name: "two-rooms",
        summary: "a lit room and a dark one behind a 5 cm wall with a door gap: light leaks",
        make: || two_rooms(0.05, 0.3),
    },
    BuiltIn {
        name: "colonnade",
        summary: "arcaded courtyard in the sun: a large scene with fine detail, lit far from where the sun falls",
        make: colonnade,
    },
    BuiltIn {
        name: "louvres",
        summary: "sun through slats 1 mm thick, thinner than any voxel: light must neither leak nor be lost",
        make: louvres,
    },
    BuiltIn {
        name: "many-lights",
        summary: "a hall with 256 small coloured point lights: the cost of lights, saturated colours",
        make: || many_lights(256),
    },
    BuiltIn {
        name: "slit",
        summary: "a sunlit strip 3 cm wide beside a wall: a secondary source too small for sparse probes",
        make: slit,
    },
    BuiltIn {
        name: "corridor",
        summary: "a corridor with two bends, lit from one end: light that needs many bounces",
        make: corridor,
    },
    BuiltIn {
        name: "blue-orange-box",
        summary: "a long box with blue and orange walls, blocks close to them, one sun: indirect shadows",
        make: blue_orange_box,
    },
];
