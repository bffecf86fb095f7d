//! (c) Furnace, (d) feedback, (e) iterations and steps.

use super::studio;
use crate::error::Error;
use crate::scene::Scene;
use crate::scene::built_in::furnace as furnace_scene;
use crate::stress::lab::{SIDE_PX, difference, mean, picture};
use crate::stress::{Answer, Danger, Effort, Entry, Lab, NOT_FINITE, Question};
use glam::Vec3;
use std::f64::consts::PI;

/// Reflectances.
const ALBEDOS: [f64; 7] = [0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99];
/// Frames of a loop under one light.
const FRAMES: usize = 500;

pub fn furnace(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let closed = Question {
        variant: "all bounces",
        measure: "the error of the energy in a closed box",
        parameter: "albedo",
        unit: "",
        bound: 0.1,
        percent: true,
        danger: Danger::High,
    };
    let all = closed.sweep(lab, "furnace", &ALBEDOS, 2, |lab, albedo| {
        let scene = furnace_scene(albedo as f32, 1.0);
        let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
        let values = lab.measure(&scene, &surfels)?.values;
        let expected = PI * albedo / (1.0 - albedo);
        let words = format!("Inside a box of albedo {albedo:.2}: the truth is one flat colour.");
        let flat = vec![Vec3::splat(expected as f32); values.len()];
        Ok(Answer {
            value: (mean(&values) / expected - 1.0).abs(),
            picture: picture(&values, &flat).map(|png| (png, words)),
        })
    })?;
    let counted = Question {
        variant: "counted bounces",
        measure: "the error of the energy of a number of bounces at albedo 0.5",
        parameter: "bounces",
        ..closed
    };
    let tail: &[(&str, &str)] = if lab.settings.contains_key("tail") { &[("tail", "0")] } else { &[] };
    if lab.changed(&[tail, &[("bounces", "1")]].concat()).is_none() {
        let reason = "the method has no number of bounces to set";
        return Ok(vec![all, counted.not_applicable(lab, "furnace", reason)]);
    }
    let scene = furnace_scene(0.5, 1.0);
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    let some = counted.sweep(lab, "furnace", &[1.0, 2.0, 3.0, 5.0, 8.0], 0, |lab, bounces| {
        let text = format!("{bounces}");
        let Some(settings) = lab.changed(&[tail, &[("bounces", text.as_str())]].concat()) else {
            return Ok(NOT_FINITE.into());
        };
        let values = lab.measure_with(&settings, &scene, &surfels)?.values;
        // Every reflection sends on half: ½ + ¼ + … of π·Lₑ.
        let expected = PI * (1.0 - 0.5_f64.powf(bounces));
        Ok((mean(&values) / expected - 1.0).abs().into())
    })?;
    Ok(vec![all, some])
}

/// What many frames of a loop did.
struct Loop {
    /// Ratio of successive changes; 0 where the second frame was the first.
    gain: f64,
    /// Range of the later half of the frames over their mean: 0 where the loop has settled, large where it grows or swings.
    unrest: f64,
    /// Frames after which 95 % of a step in the lights have arrived.
    response: usize,
}

/// Albedos of the box.
const LOOP_ALBEDOS: [f64; 4] = [0.5, 0.8, 0.95, 0.99];

pub fn feedback(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let gain = Question {
        variant: "gain",
        measure: "the gain of the bounce loop",
        parameter: "albedo",
        unit: "",
        bound: 0.999,
        percent: false,
        danger: Danger::High,
    };
    let unrest = Question {
        variant: "500 frames",
        measure: "the change over the later 250 of 500 frames of one light",
        bound: 0.001,
        percent: true,
        ..gain.clone()
    };
    let response = Question {
        variant: "step response",
        measure: "the number of frames after which 95 % of a step in the lights have arrived",
        bound: 60.0,
        ..gain.clone()
    };
    let mut loops: Vec<(f64, Loop)> = Vec::new();
    let gains = gain.sweep(lab, "feedback", &LOOP_ALBEDOS, 0, |lab, albedo| {
        let scene = furnace_scene(albedo as f32, 1.0);
        let surfels = lab.seen(&scene, &scene.cameras[0], 8)?;
        // The light is the same from every point of a lamp here: one shadow ray tells as much as many.
        let settings = lab.changed(&[("light_samples", "1")]).unwrap_or_else(|| lab.settings.clone());
        let patient = lab.effort == Effort::Full || albedo == LOOP_ALBEDOS[LOOP_ALBEDOS.len() - 1];
        let (observed, stated) = lab.session(&settings, &scene, &surfels, |session| {
            let observed = many_frames(session, albedo, &scene, patient)?;
            Ok((observed, session.method.feedback_gain()))
        })?;
        let gain = observed.gain.max(stated.unwrap_or(0.0));
        loops.push((albedo, observed));
        Ok(gain.into())
    })?;
    let of = |albedo: f64, number: fn(&Loop) -> f64| {
        loops.iter().find(|l| l.0 == albedo).map_or(NOT_FINITE, |l| number(&l.1)).into()
    };
    let rest = unrest.sweep(lab, "feedback", &LOOP_ALBEDOS, 0, |_, albedo| Ok(of(albedo, |l| l.unrest)))?;
    let steps = response.sweep(lab, "feedback", &LOOP_ALBEDOS, 0, |_, albedo| Ok(of(albedo, |l| l.response as f64)))?;
    Ok(vec![gains, rest, steps])
}

/// Runs the loop under one light, until it settles where patience ends there, then doubles the lights and counts.
fn many_frames(
    session: &mut crate::stress::Session<'_>,
    albedo: f64,
    scene: &Scene,
    patient: bool,
) -> Result<Loop, Error> {
    let mut history: Vec<f64> = Vec::with_capacity(FRAMES);
    let settled = |h: &[f64]| matches!(h, [.., a, b] if (b - a).abs() <= 1e-6 * b.abs());
    while history.len() < FRAMES && (patient || !settled(&history)) {
        session.light_change(scene)?;
        history.push(mean(&session.frame(scene)?));
        if history.last().is_some_and(|v| !v.is_finite()) {
            return Ok(Loop { gain: NOT_FINITE, unrest: NOT_FINITE, response: FRAMES });
        }
    }
    let late = &history[history.len() / 2..];
    let (low, high) = late.iter().fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(*v), h.max(*v)));
    let scale = late.iter().map(|v| v.abs()).sum::<f64>() / late.len() as f64;
    let unrest = if scale > 0.0 { (high - low) / scale } else { 0.0 };
    let settled = history[history.len() - 1];
    let brighter = furnace_scene(albedo as f32, 2.0);
    session.relight(&brighter)?;
    let mut response = FRAMES;
    for k in 0..FRAMES {
        session.light_change(&brighter)?;
        if mean(&session.frame(&brighter)?) - settled >= 0.95 * settled {
            response = k + 1;
            break;
        }
    }
    Ok(Loop { gain: growth(&history), unrest, response })
}

/// Ratio of successive changes over the later half of those that are larger than rounding.
fn growth(history: &[f64]) -> f64 {
    let changes: Vec<f64> = history.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
    let scale = history.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let real = changes.windows(2).filter(|w| w[0] > 1e-5 * scale && w[1] > 1e-6 * scale);
    let ratios: Vec<f64> = real.map(|w| w[1] / w[0]).collect();
    crate::evaluate::median(ratios[ratios.len() / 2..].to_vec())
}

/// Settings that hold a number of iterations, more of them being finer.
const COUNTS: [&str; 3] = ["iterations", "max_iterations", "steps"];
/// Settings that hold the size of a step.
const SIZES: [&str; 2] = ["aperture", "step"];
/// Numbers of iterations to try, as far as the method takes them; the last are far beyond what any scene here needs,
/// because what blows up does so late.
const ITERATIONS: [f64; 8] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 256.0];

pub fn iteration(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let mut entries = Vec::new();
    let scene = studio(Vec3::new(2.3, 2.4, 2.6), 1.1);
    let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
    for key in with_settings(lab, &COUNTS) {
        entries.extend(by_count(lab, key, (&scene, &surfels))?);
    }
    for key in with_settings(lab, &SIZES) {
        entries.extend(by_size(lab, key, (&scene, &surfels))?);
    }
    if entries.is_empty() {
        entries.push(from_finest("").not_applicable(lab, "iteration", "the method has no iterations or steps to set"));
    }
    Ok(entries)
}

/// Those that the method has.
fn with_settings(lab: &Lab, keys: &[&'static str]) -> Vec<&'static str> {
    keys.iter().copied().filter(|key| lab.settings.contains_key(*key)).collect()
}

fn from_finest(key: &'static str) -> Question {
    Question {
        variant: key,
        measure: "the difference from the finest",
        parameter: key,
        unit: "",
        bound: 0.1,
        percent: true,
        danger: Danger::Low,
    }
}

/// The settings with a number of iterations; none of them ends early by itself.
fn iterated(lab: &Lab, key: &str, count: f64) -> Option<crate::methods::Settings> {
    let text = format!("{count}");
    let stubborn: &[(&str, &str)] = if lab.settings.contains_key("tolerance") { &[("tolerance", "0")] } else { &[] };
    lab.changed(&[stubborn, &[(key, text.as_str())]].concat())
}

/// Too few iterations, and too many: how far the picture is from that of the most, and how much light it gains on that of
/// the method's own choice.
fn by_count(
    lab: &mut Lab,
    key: &'static str,
    (scene, surfels): (&Scene, &[interreflect_shared::scene::Surfel]),
) -> Result<Vec<Entry>, Error> {
    let grid: Vec<f64> = ITERATIONS.into_iter().filter(|n| iterated(lab, key, *n).is_some()).collect();
    let own = lab.measure(scene, surfels)?.values;
    let mut all: Vec<(f64, Vec<Vec3>)> = Vec::new();
    for count in &grid {
        let Some(settings) = iterated(lab, key, *count) else { continue };
        all.push((*count, lab.measure_with(&settings, scene, surfels)?.values));
    }
    let Some((_, finest)) = all.last().cloned() else { return Ok(Vec::new()) };
    let of = |count: f64| all.iter().find(|(n, _)| *n == count).map(|(_, values)| values.as_slice()).unwrap_or(&finest);
    let few = from_finest(key).sweep(lab, "iteration", &grid, 0, |_, count| {
        let words = format!("{key} {count}: light has not arrived everywhere yet.");
        let got = of(count);
        Ok(Answer { value: difference(got, &finest), picture: picture(got, &finest).map(|png| (png, words)) })
    })?;
    let gain = Question {
        variant: if key == "steps" { "blow-up by steps" } else { "blow-up" },
        measure: "light gained by more iterations than the method chooses",
        danger: Danger::High,
        ..from_finest(key)
    };
    let many = gain.sweep(lab, "iteration", &grid, 0, |_, count| {
        let (got, own) = (mean(of(count)), mean(&own));
        Ok((if own > 0.0 { (got / own - 1.0).max(0.0) } else { got.abs() }).into())
    })?;
    Ok(vec![few, many])
}

/// The sizes of steps that a search would try.
fn by_size(
    lab: &mut Lab,
    key: &'static str,
    (scene, surfels): (&Scene, &[interreflect_shared::scene::Surfel]),
) -> Result<Option<Entry>, Error> {
    let axes = crate::fit::axes(lab.row, &lab.settings);
    let mut values: Vec<String> = axes.into_iter().find(|a| a.key == key).map(|a| a.values).unwrap_or_default();
    values.retain(|v| lab.changed(&[(key, v.as_str())]).is_some());
    let Some(finest) = values.last().and_then(|v| lab.changed(&[(key, v.as_str())])) else { return Ok(None) };
    let finest = lab.measure_with(&finest, scene, surfels)?.values;
    let names: Vec<&str> = values.iter().map(String::as_str).collect();
    let question = Question { parameter: "", danger: Danger::Cases, ..from_finest(key) };
    Ok(Some(question.cases(lab, "iteration", &names, |lab, k| {
        let settings = lab.changed(&[(key, names[k])]).unwrap_or_else(|| lab.settings.clone());
        let got = lab.measure_with(&settings, scene, surfels)?.values;
        let words = format!("{key} = {}", names[k]);
        Ok(Answer { value: difference(&got, &finest), picture: picture(&got, &finest).map(|png| (png, words)) })
    })))
}
