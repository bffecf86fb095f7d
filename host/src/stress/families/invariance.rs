//! (h) Scale and offset, (i) rotation: the light is the same, the picture must be too.

use crate::error::Error;
use crate::scene::Scene;
use crate::scene::built_in::cornell_box;
use crate::stress::lab::{SIDE_PX, difference, picture, transformed};
use crate::stress::{Answer, Danger, Entry, Lab, Question};
use glam::{Quat, Vec3};
use interreflect_shared::scene::Surfel;

/// Largest difference that counts as the same picture.
const SAME: f64 = 0.01;

/// Surface points moved with the scene, which has been brought near its origin: exactly the same points, whatever the
/// camera rays would have hit.
fn moved(surfels: &[Surfel], scale: f32, angle_rad: f32, offset: Vec3, scene: &Scene) -> Vec<Surfel> {
    let turn = Quat::from_rotation_y(angle_rad);
    let place = |p: [f32; 3]| scene.local((turn * (Vec3::from(p) * scale)).as_dvec3() + offset.as_dvec3()).to_array();
    let direct = |n: [f32; 3]| (turn * Vec3::from(n)).to_array();
    surfels
        .iter()
        .map(|s| Surfel {
            position: place(s.position),
            normal: direct(s.normal),
            geometric_normal: direct(s.geometric_normal),
            distance: s.distance * scale,
            error: s.error * scale,
            ..*s
        })
        .collect()
}

fn compare(
    lab: &mut Lab,
    base: (&Scene, &[Surfel], &[Vec3]),
    (scale, angle_rad, offset): (f32, f32, Vec3),
    words: String,
) -> Result<Answer, Error> {
    let (scene, surfels, values) = base;
    let mut other = transformed(scene, scale, angle_rad, offset);
    // As import does: what the coordinates' rounding has done to the shape stays.
    other.recentre();
    let points = lab.attach(&other, &moved(surfels, scale, angle_rad, offset, &other))?;
    let got = lab.measure(&other, &points)?.values;
    Ok(Answer { value: difference(&got, values), picture: picture(&got, values).map(|png| (png, words)) })
}

pub fn scale(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let scene = cornell_box();
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    let values = lab.measure(&scene, &surfels)?.values;
    let larger = Question {
        variant: "larger",
        measure: "the change of the picture",
        parameter: "size factor",
        unit: "",
        bound: SAME,
        percent: true,
        danger: Danger::High,
    };
    let smaller = Question { variant: "smaller", danger: Danger::Low, ..larger.clone() };
    let mut ask = |lab: &mut Lab, factor: f64| {
        let words = format!("The box at {factor} times its size.");
        compare(lab, (&scene, &surfels, &values), (factor as f32, 0.0, Vec3::ZERO), words)
    };
    let up = larger.sweep(lab, "scale", &[1.0, 10.0, 100.0, 1e3, 1e4], 0, &mut ask)?;
    let down = smaller.sweep(lab, "scale", &[1e-3, 1e-2, 1e-1, 1.0], 0, &mut ask)?;
    Ok(vec![up, down])
}

pub fn offset(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    // Ten times the box: a room of 5.5 m.
    let scene = transformed(&cornell_box(), 10.0, 0.0, Vec3::ZERO);
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    let values = lab.measure(&scene, &surfels)?.values;
    let question = Question {
        variant: "",
        measure: "the change of the picture",
        parameter: "distance from the origin",
        unit: "m",
        bound: SAME,
        percent: true,
        danger: Danger::High,
    };
    let entry = question.sweep(lab, "offset", &[10.0, 100.0, 1e3, 1e4, 1e5], 1, |lab, distance| {
        let away = Vec3::new(0.6, 0.0, 0.8) * distance as f32;
        let words = format!("A room of 5.5 m, {distance} m from the origin.");
        compare(lab, (&scene, &surfels, &values), (1.0, 0.0, away), words)
    })?;
    Ok(vec![entry])
}

pub fn rotation(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let scene = cornell_box();
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    let values = lab.measure(&scene, &surfels)?.values;
    let question = Question {
        variant: "",
        measure: "the change of the picture",
        parameter: "angle about the vertical axis",
        unit: "degrees",
        bound: 0.1,
        percent: true,
        danger: Danger::High,
    };
    let entry = question.sweep(lab, "rotation", &[1.0, 5.0, 15.0, 30.0, 45.0], 1, |lab, degrees| {
        let words = format!("The box turned by {degrees:.0}° within the grid.");
        compare(lab, (&scene, &surfels, &values), (1.0, (degrees as f32).to_radians(), Vec3::ZERO), words)
    })?;
    Ok(vec![entry])
}
