//! Scenes made in code: nothing to download, the same everywhere. Each has a default camera, and its function's doc
//! says what it is for. All are in metres.

mod build;
mod cornell;
mod furnace;
mod rooms;

pub use build::SceneBuilder;
pub use cornell::cornell_box;
pub use furnace::{furnace, parallel_squares, sphere_furnace};
pub use rooms::two_rooms;

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
];
