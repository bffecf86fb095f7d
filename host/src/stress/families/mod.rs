//! The families, one function each; [`FAMILIES`] lists them.

mod energy;
mod flicker;
mod invariance;
mod leak;
mod lights;
mod shapes;
mod windows;

use super::{Entry, Lab};
use crate::error::Error;
use crate::scene::built_in::SceneBuilder;
use crate::scene::{Light, Scene};
use glam::Vec3;

/// A family of scenes with one thing that goes wrong.
pub struct Family {
    /// Name on the command line.
    pub key: &'static str,
    /// What goes wrong.
    pub title: &'static str,
    /// How it is measured, for a person.
    pub what: &'static str,
    /// Measures a method.
    pub run: fn(&mut Lab) -> Result<Vec<Entry>, Error>,
}

/// Makes a scene.
type Make = fn() -> Scene;

/// Every family.
pub const FAMILIES: &[Family] = &[
    Family {
        key: "leak",
        title: "light through a sealed wall",
        what: "Two rooms with a wall between them that has no opening; a lamp in one. The number is the mean indirect light \
               in the dark room over that in the lit one: the truth is 0.",
        run: leak::run,
    },
    Family {
        key: "flicker",
        title: "flicker under slow motion",
        what: "A light, an object or the camera moves by a part of the method's unit per frame. The number is the standard \
               deviation of the second difference in time, beyond the truth's own, over the mean.",
        run: flicker::run,
    },
    Family {
        key: "popping",
        title: "jumps along a wall",
        what: "Irradiance at points a tenth of a unit apart along a wall. The number is the largest second difference beyond \
               the truth's, over the mean: cascades, clusters and cells show as steps.",
        run: flicker::popping,
    },
    Family {
        key: "furnace",
        title: "energy in a closed box",
        what: "A closed cube that emits 1 and reflects a part of what arrives. The number is the deviation of the mean from \
               the closed form π·Lₑ·ρ/(1 − ρ), or its partial sum for a number of bounces.",
        run: energy::furnace,
    },
    Family {
        key: "feedback",
        title: "gain of the bounce loop",
        what: "A closed box is lit for 500 frames, then its light is doubled. The numbers are the part of its light that each \
               further bounce keeps, measured from frame to frame or as the method states it (at 1 the light grows without \
               bound), what the later half of the frames still changes, and how many frames a step in the light takes.",
        run: energy::feedback,
    },
    Family {
        key: "iteration",
        title: "dependence on iterations and steps",
        what: "The same picture with other numbers of iterations or sizes of steps. The numbers are the difference from the \
               finest, and the light gained by iterating on beyond what the method itself chooses: what blows up does so \
               late.",
        run: energy::iteration,
    },
    Family {
        key: "ringing",
        title: "ringing of spherical harmonics",
        what: "A small bright patch lights a dark room. The numbers are the most negative irradiance over the mean, and the \
               contrast lost against the truth, also per order where the method has one; and in closed form what windows \
               would save and cost at each of its orders. Where a method cuts negative values off, what it holds before that \
               counts.",
        run: lights::ringing,
    },
    Family {
        key: "geometry",
        title: "geometry finer than the method",
        what: "Bars thinner than a unit, sheets, slivers, edges of many faces, interpenetrating and doubled surfaces, \
               receivers inside walls. The numbers are the error of the mean against the truth, and the share of \
               impossible values.",
        run: shapes::geometry,
    },
    Family {
        key: "scale",
        title: "size of the scene",
        what: "The same box from a thousandth to ten thousand times its size. The number is the difference from the picture \
               at its own size: the truth is 0.",
        run: invariance::scale,
    },
    Family {
        key: "offset",
        title: "distance from the origin",
        what: "A room of 5 m moved away from the origin. The number is the difference from the picture at the origin: the \
               truth is 0.",
        run: invariance::offset,
    },
    Family {
        key: "rotation",
        title: "orientation of the scene",
        what: "The same box turned about the vertical axis. The number is the difference from the picture of the box that is \
               aligned with the axes: the truth is 0.",
        run: invariance::rotation,
    },
    Family {
        key: "lights",
        title: "unusual lights",
        what: "A light close to a wall, within it, very small, many lights, none. The numbers are the error of the mean \
               against the truth, and light where there must be none.",
        run: lights::run,
    },
    Family {
        key: "degenerate",
        title: "degenerate input",
        what: "Identical receivers, a single one, none on a surface, receivers far outside, specks of a single texel, a cavity \
               that nothing sees into, a scene of one triangle, black surfaces; then every setting at the least that the \
               method takes. The number is the share of values that are not finite, negative or not what they must be.",
        run: shapes::degenerate,
    },
];

/// A room of 4 × 3 × 4 m with two coloured walls, a block at `block_x`, and a point light.
fn studio(light: Vec3, block_x: f32) -> Scene {
    let mut b = SceneBuilder::new("studio");
    let white = b.diffuse("white", [0.75; 3]);
    let red = b.diffuse("red", [0.6, 0.15, 0.12]);
    let green = b.diffuse("green", [0.15, 0.5, 0.2]);
    b.room([0.0; 3], [4.0, 3.0, 4.0], [red, green, white, white, white, white]);
    b.block([block_x, 0.0, 1.2], [block_x + 0.8, 1.2, 2.0], white);
    b.light(Light::Point { position: light, intensity: Vec3::splat(20.0) });
    b.camera("corner", [3.6, 1.6, 3.6], [1.0, 1.0, 0.6], 70.0);
    b.finish()
}
