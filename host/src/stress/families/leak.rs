//! (a) Light through a sealed wall.

use crate::error::Error;
use crate::scene::built_in::two_rooms;
use crate::stress::lab::{SIDE_PX, mean, picture};
use crate::stress::{Answer, Danger, Entry, Lab, Question};

/// Wall thicknesses in units.
const GRID: [f64; 8] = [0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 4.0];

pub fn run(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let sample = two_rooms(0.1, 0.0);
    let surfels = lab.seen(&sample, &sample.cameras[0], 4)?;
    let (unit, metres) = lab.unit(&sample, &surfels)?;
    let question = Question {
        variant: "",
        measure: "light through a sealed wall",
        parameter: "wall thickness",
        unit,
        bound: 0.01,
        percent: true,
        danger: Danger::Low,
    };
    let leak = |lab: &mut Lab, thickness: f64| -> Result<Answer, Error> {
        // The unit grows with the scene, and the scene with its wall: one correction is enough.
        let first = two_rooms((thickness * metres) as f32, 0.0);
        let (_, metres) = lab.unit(&first, &surfels)?;
        let scene = two_rooms((thickness * metres) as f32, 0.0);
        let dark = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
        let lit = lab.seen(&scene, &scene.cameras[1], SIDE_PX)?;
        let both: Vec<_> = dark.iter().chain(&lit).copied().collect();
        let values = lab.measure(&scene, &both)?.values;
        let (dark, lit) = values.split_at(dark.len());
        // Without any indirect light nothing leaks.
        let value = if mean(lit) > 0.0 { mean(dark) / mean(lit) } else { 0.0 };
        let words = format!("The dark room behind a wall of {thickness:.2} {unit}; it must be black.");
        Ok(Answer { value, picture: picture(dark, lit).map(|png| (png, words)) })
    };
    Ok(vec![question.sweep(lab, "leak", &GRID, 3, leak)?])
}
