//! (f) Ringing, (j) unusual lights.

use super::{Make, studio};
use crate::error::Error;
use crate::scene::built_in::SceneBuilder;
use crate::scene::{Light, Scene};
use crate::stress::lab::{SIDE_PX, mean, picture};
use crate::stress::{Answer, Danger, Entry, Lab, Measured, Question};
use glam::Vec3;

/// Samples of the truth for a mean over a picture.
const TRUTH_SPP: u32 = 64;

/// Windows on bands, where a method has them, and the orders at which they are tried.
const WINDOWS: [&str; 2] = ["lanczos", "hanning"];
const WINDOWED_ORDERS: [u32; 3] = [2, 4, 7];

/// A dark room whose floor has a bright patch: a spot of a narrow cone (half angle in degrees).
fn patch(half_angle_deg: f32) -> Scene {
    let mut b = SceneBuilder::new("patch");
    let grey = b.diffuse("grey", [0.5; 3]);
    b.room([0.0; 3], [3.0; 3], [grey; 6]);
    let cos = half_angle_deg.to_radians().cos();
    b.light(Light::Spot {
        position: Vec3::new(0.8, 2.8, 0.8),
        direction: -Vec3::Y,
        intensity: Vec3::splat(5.0 / (1.0 - cos)),
        cos_inner: cos,
        cos_outer: (1.2 * half_angle_deg).to_radians().cos(),
    });
    b.camera("across", [2.8, 1.6, 2.8], [0.6, 1.0, 0.6], 75.0);
    b.finish()
}

pub fn ringing(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let negative = Question {
        variant: "most negative",
        measure: "the most negative irradiance over the mean",
        parameter: "half angle of the light",
        unit: "degrees",
        bound: 0.001,
        percent: true,
        danger: Danger::Low,
    };
    let contrast = Question {
        variant: "contrast",
        measure: "the contrast lost against the truth",
        bound: 0.25,
        ..negative.clone()
    };
    let angles = [2.0, 5.0, 10.0, 20.0];
    let mut entries = Vec::new();
    let below = negative.sweep(lab, "ringing", &angles, 0, |lab, angle| {
        let (measured, _) = patch_values(lab, angle, false)?;
        Ok(most_negative(&measured).into())
    })?;
    entries.push(below);
    entries.push(contrast.sweep(lab, "ringing", &angles, 0, |lab, angle| {
        let (measured, truth) = patch_values(lab, angle, true)?;
        let values = measured.values;
        let words = format!("A patch lit under {angle}°: light on walls beside it.");
        Ok(Answer {
            value: (1.0 - spread(&values) / spread(&truth)).max(0.0),
            picture: picture(&values, &truth).map(|png| (png, words)),
        })
    })?);
    entries.extend(per_order(lab, &negative, &contrast)?);
    entries.extend(super::windows::run(lab, &orders(lab)));
    Ok(entries)
}

/// Orders of spherical harmonics that a search would try; none where the method has no order to set.
fn orders(lab: &Lab) -> Vec<u32> {
    let axis = crate::fit::axes(lab.row, &lab.settings).into_iter().find(|a| a.key == "order");
    axis.map(|a| a.values.iter().filter_map(|v| v.parse().ok()).collect()).unwrap_or_default()
}

/// What the method makes of the patch at each order.
fn per_order(lab: &mut Lab, negative: &Question, contrast: &Question) -> Result<Vec<Entry>, Error> {
    let cases = |variant, question: &Question| Question {
        variant,
        parameter: "",
        unit: "",
        danger: Danger::Cases,
        ..question.clone()
    };
    let negative = cases("per order: most negative", negative);
    let contrast = cases("per order: contrast", contrast);
    let orders = orders(lab);
    if orders.is_empty() {
        let reason = "the method has no order to set";
        return Ok([negative, contrast].map(|q| q.not_applicable(lab, "ringing", reason)).into());
    }
    let scene = patch(5.0);
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    let truth = spread(&lab.truth(&scene, &surfels, 8 * TRUTH_SPP)?);
    let mut pictures = Vec::new();
    let mut names = Vec::new();
    for order in &orders {
        let text = order.to_string();
        let mut variants = vec![(format!("order {order}"), vec![("order", text.as_str())])];
        let windowed =
            |window| (format!("order {order}, {window}"), vec![("order", text.as_str()), ("window", window)]);
        if WINDOWED_ORDERS.contains(order) {
            variants.extend(WINDOWS.map(windowed));
        }
        for (name, changes) in variants {
            // A method without windows has the plain order alone.
            let Some(settings) = lab.changed(&changes) else { continue };
            pictures.push(lab.measure_with(&settings, &scene, &surfels)?);
            names.push(name);
        }
    }
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let below = negative.cases(lab, "ringing", &names, |_, k| Ok(most_negative(&pictures[k]).into()));
    let lost =
        contrast.cases(lab, "ringing", &names, |_, k| Ok((1.0 - spread(&pictures[k].values) / truth).max(0.0).into()));
    Ok(vec![below, lost])
}

fn patch_values(lab: &mut Lab, angle_deg: f64, with_truth: bool) -> Result<(Measured, Vec<Vec3>), Error> {
    let scene = patch(angle_deg as f32);
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    let measured = lab.measure(&scene, &surfels)?;
    let truth = if with_truth { lab.truth(&scene, &surfels, 8 * TRUTH_SPP)? } else { Vec::new() };
    Ok((measured, truth))
}

/// The most negative irradiance over the mean, of the picture or of what the method holds before it cuts that off.
fn most_negative(measured: &Measured) -> f64 {
    let low = measured.values.iter().map(|v| f64::from(v.min_element())).fold(0.0, f64::min);
    let share = |[low, scale]: [f64; 2]| if scale > 0.0 { low.min(0.0).abs() / scale } else { 0.0 };
    share([low, mean(&measured.values)]).max(measured.uncut.map_or(0.0, share))
}

/// Contrast: difference of the 95th and the 5th percentile over the mean.
fn spread(values: &[Vec3]) -> f64 {
    let mut sums: Vec<f32> = values.iter().map(|v| v.element_sum() / 3.0).collect();
    sums.sort_by(f32::total_cmp);
    let at = |share: f64| f64::from(sums[(share * (sums.len() - 1) as f64).round() as usize]);
    let scale = mean(values);
    if scale > 0.0 { (at(0.95) - at(0.05)) / scale } else { 0.0 }
}

/// The studio without its light, and these instead.
fn lit_by(lights: Vec<Light>) -> Scene {
    Scene { lights, ..studio(Vec3::ONE, 1.1) }
}

fn point(position: Vec3, intensity: f32) -> Light {
    Light::Point { position, intensity: Vec3::splat(intensity) }
}

/// Distances of a light from a wall, in units; at the first it all but touches.
const TOUCHING: [f64; 5] = [0.01, 0.1, 0.3, 1.0, 3.0];

pub fn run(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let sample = studio(Vec3::new(2.0, 2.4, 2.0), 1.1);
    let surfels = lab.seen(&sample, &sample.cameras[0], SIDE_PX)?;
    let (unit, metres) = lab.unit(&sample, &surfels)?;
    let near = Question {
        variant: "close to a wall",
        measure: "the error of the mean",
        parameter: "distance of the light from a wall",
        unit,
        bound: 0.25,
        percent: true,
        danger: Danger::Low,
    };
    let close = near.sweep(lab, "lights", &TOUCHING, 1, |lab, distance| {
        let scene = lit_by(vec![point(Vec3::new((distance * metres) as f32, 1.8, 2.4), 5.0)]);
        error_of_mean(lab, &scene, format!("A light {distance:.2} {unit} from the left wall."))
    })?;
    let error = Question { variant: "number and size", parameter: "", unit: "", danger: Danger::Cases, ..near };
    let cases: [(&str, Make); 4] = [
        ("one light", || lit_by(spread_lights(1))),
        ("a hundred lights", || lit_by(spread_lights(100))),
        ("a thousand lights", || lit_by(spread_lights(1000))),
        ("a lamp of 1 mm", tiny_lamp),
    ];
    let names = cases.map(|c| c.0);
    let many = error.cases(lab, "lights", &names, |lab, k| error_of_mean(lab, &(cases[k].1)(), names[k].into()));
    let dark = Question { variant: "must be dark", measure: "light where there must be none", bound: 0.01, ..error };
    let bright = lab.measure(&sample, &surfels)?.values;
    // Inside the block (x 1.1…1.9, y 0…1.2, z 1.2…2), and inside the solid behind a wall.
    let sources: [(&str, Vec<Light>); 3] = [
        ("no light", vec![]),
        ("a light inside a block", vec![point(Vec3::new(1.5, 0.6, 1.6), 20.0)]),
        ("a light outside the room", vec![point(Vec3::new(-1.0, 1.5, 2.0), 20.0)]),
    ];
    let names = [sources[0].0, sources[1].0, sources[2].0];
    let black = dark.cases(lab, "lights", &names, |lab, k| {
        let scene = lit_by(sources[k].1.clone());
        let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
        let values = lab.measure(&scene, &surfels)?.values;
        let words = format!("{}: every point must be black.", names[k]);
        Ok(Answer { value: mean(&values) / mean(&bright), picture: picture(&values, &bright).map(|p| (p, words)) })
    });
    Ok(vec![close, many, black])
}

/// Lights on a grid below the ceiling, 20 W/sr together.
fn spread_lights(count: u32) -> Vec<Light> {
    let side = f64::from(count).sqrt().ceil() as u32;
    let at = |k: u32| {
        let (i, j) = (k % side, k / side);
        Vec3::new(0.5 + 3.0 * (i as f32 + 0.5) / side as f32, 2.4, 0.5 + 3.0 * (j as f32 + 0.5) / side as f32)
    };
    (0..count).map(|k| point(at(k), 20.0 / count as f32)).collect()
}

/// A lamp of 1 mm that gives what a point of 20 W/sr would below it.
fn tiny_lamp() -> Scene {
    let mut b = SceneBuilder::new("tiny lamp");
    let white = b.diffuse("white", [0.75; 3]);
    b.room([0.0; 3], [4.0, 3.0, 4.0], [white; 6]);
    let lamp = b.emitter("lamp", [0.0; 3], [2e7; 3]);
    let (low, high) = (1.9995, 2.0005);
    b.quad([[low, 2.5, low], [high, 2.5, low], [high, 2.5, high], [low, 2.5, high]], lamp);
    b.camera("corner", [3.6, 1.6, 3.6], [1.0, 1.0, 0.6], 70.0);
    b.finish()
}

fn error_of_mean(lab: &mut Lab, scene: &Scene, words: String) -> Result<Answer, Error> {
    let surfels = lab.seen(scene, &scene.cameras[0], SIDE_PX)?;
    let values = lab.measure(scene, &surfels)?.values;
    let truth = lab.truth(scene, &surfels, TRUTH_SPP)?;
    Ok(Answer {
        value: (mean(&values) / mean(&truth) - 1.0).abs(),
        picture: picture(&values, &truth).map(|p| (p, words)),
    })
}
