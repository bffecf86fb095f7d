//! (b) Flicker of slow motion, and jumps in space.

use super::studio;
use crate::error::Error;
use crate::scene::{Camera, Scene};
use crate::stress::lab::{mean, picture};
use crate::stress::{Danger, Entry, Lab, Question};
use glam::Vec3;
use interreflect_shared::scene::Surfel;

/// Steps per frame in units.
const GRID: [f64; 4] = [0.1, 0.25, 0.5, 1.0];
/// Frames of a motion.
const FRAMES: usize = 7;
/// Samples of the truth: with the same random numbers in each frame most of its noise cancels.
const TRUTH_SPP: u32 = 128;
/// Rows of pixels.
const SIDE_PX: u32 = 16;

/// Root mean square of second differences in time over the mean.
fn second_differences(frames: &[Vec<Vec3>]) -> f64 {
    let mut square = 0.0;
    let mut count = 0.0;
    for k in 1..frames.len() - 1 {
        for ((a, b), c) in frames[k - 1].iter().zip(&frames[k]).zip(&frames[k + 1]) {
            square += f64::from((*a - 2.0 * *b + *c).length_squared());
            count += 3.0;
        }
    }
    let scale = frames.iter().map(|f| mean(f)).sum::<f64>() / frames.len() as f64;
    if scale > 0.0 { (square / f64::max(count, 1.0)).sqrt() / scale } else { 0.0 }
}

fn beyond(method: f64, truth: f64) -> f64 {
    (method * method - truth * truth).max(0.0).sqrt()
}

const LIGHT: Vec3 = Vec3::new(2.3, 2.4, 2.6);
const BLOCK_X: f32 = 1.1;

pub fn run(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let still = studio(LIGHT, BLOCK_X);
    let camera = still.cameras[0].clone();
    let surfels = lab.seen(&still, &camera, SIDE_PX)?;
    let (unit, metres) = lab.unit(&still, &surfels)?;
    let question = |variant, parameter| Question {
        variant,
        measure: "flicker",
        parameter,
        unit,
        bound: 0.02,
        percent: true,
        danger: Danger::High,
    };
    // Points on walls stay visible while the block moves below and beside them.
    let walls: Vec<Surfel> = surfels.iter().filter(|s| s.normal[1].abs() < 0.5 && on_wall(s)).copied().collect();
    let light = question("light", "light motion per frame").sweep(lab, "flicker", &GRID, 1, |lab, step| {
        let scenes = motion(|k| studio(LIGHT + Vec3::X * (k as f64 * step * metres) as f32, BLOCK_X));
        let settings = lab.settings.clone();
        let frames = lab.session(&settings, &scenes[0], &walls, |session| {
            let frame = |scene: &Scene| {
                session.relight(scene)?;
                session.light_change(scene)?;
                session.frame(scene)
            };
            scenes.iter().map(frame).collect::<Result<Vec<_>, Error>>()
        })?;
        Ok(beyond(second_differences(&frames), truth_of(lab, &scenes, &walls)?).into())
    })?;
    let object = question("object", "object motion per frame").sweep(lab, "flicker", &GRID, 1, |lab, step| {
        let scenes = motion(|k| studio(LIGHT, BLOCK_X + (k as f64 * step * metres) as f32));
        let frames: Vec<_> = scenes.iter().map(|s| Ok(lab.measure(s, &walls)?.values)).collect::<Result<_, Error>>()?;
        Ok(beyond(second_differences(&frames), truth_of(lab, &scenes, &walls)?).into())
    })?;
    let seen = question("camera", "camera motion per frame").sweep(lab, "flicker", &GRID, 1, |lab, step| {
        let frames = camera_motion(lab, &still, &surfels, &camera, step * metres)?;
        // The truth at a point does not depend on who looks.
        let worst = frames.last().and_then(|f| picture(f, &frames[0]));
        let words = format!("A frame of a camera that moves by {step} {unit} per frame.");
        Ok(crate::stress::Answer { value: second_differences(&frames), picture: worst.map(|png| (png, words)) })
    })?;
    Ok(vec![light, object, seen])
}

fn on_wall(s: &Surfel) -> bool {
    let near = |x: f32, wall: f32| (x - wall).abs() < 1e-3;
    let [x, _, z] = s.position;
    near(x, 0.0) || near(x, 4.0) || near(z, 0.0) || near(z, 4.0)
}

fn motion(scene: impl Fn(usize) -> Scene) -> Vec<Scene> {
    (0..FRAMES).map(scene).collect()
}

fn truth_of(lab: &Lab, scenes: &[Scene], surfels: &[Surfel]) -> Result<f64, Error> {
    let frames: Vec<_> = scenes.iter().map(|s| lab.truth(s, surfels, TRUTH_SPP)).collect::<Result<_, Error>>()?;
    Ok(second_differences(&frames))
}

/// The same points, seen from a moving camera: each moves on by a pixel per frame, and the scene's camera with it.
fn camera_motion(
    lab: &mut Lab,
    scene: &Scene,
    surfels: &[Surfel],
    camera: &Camera,
    step_m: f64,
) -> Result<Vec<Vec<Vec3>>, Error> {
    let settings = lab.settings.clone();
    lab.session(&settings, scene, surfels, |session| {
        session.light_change(scene)?;
        let mut frames = Vec::new();
        for k in 0..FRAMES {
            let mut moved = scene.clone();
            let right = camera.forward.cross(camera.up);
            moved.cameras[0].position = camera.position - right * (k as f64 * step_m) as f32;
            let mut shifted = surfels.to_vec();
            shifted.rotate_right(k);
            for s in &mut shifted {
                s.distance = Vec3::from(s.position).distance(moved.cameras[0].position);
            }
            session.look_at(&shifted)?;
            let mut values = session.frame(&moved)?;
            values.rotate_left(k);
            frames.push(values);
        }
        Ok(frames)
    })
}

/// Pixels at which each point of a line is asked.
const PIXELS: usize = 128;

/// Points along the back wall, a tenth of a unit apart.
pub fn popping(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let scene = studio(LIGHT, BLOCK_X);
    let camera = scene.cameras[0].clone();
    let surfels = lab.seen(&scene, &camera, SIDE_PX)?;
    let (unit, metres) = lab.unit(&scene, &surfels)?;
    let question = Question {
        variant: "",
        measure: "the largest jump between neighbours",
        parameter: "distance between them",
        unit,
        bound: 0.1,
        percent: true,
        danger: Danger::High,
    };
    let Some(template) = surfels.iter().find(|s| on_wall(s)).copied() else {
        return Ok(vec![question.not_applicable(lab, "popping", "the camera sees no wall")]);
    };
    let entry = question.sweep(lab, "popping", &[0.1, 0.25, 0.5, 1.0], 0, |lab, distance| {
        let step = (distance * metres) as f32;
        let count = ((3.0 / step) as usize).clamp(5, 100);
        let line: Vec<Surfel> = (0..count)
            .map(|k| Surfel {
                position: [0.5 + step * k as f32, 1.7, 0.0],
                normal: [0.0, 0.0, 1.0],
                geometric_normal: [0.0, 0.0, 1.0],
                ..template
            })
            .collect();
        // Every point at many pixels: their jitter is noise, which the mean takes away, and no jump.
        let many: Vec<Surfel> = line.iter().flat_map(|s| [*s; PIXELS]).collect();
        let got = lab.measure(&scene, &many)?.values;
        let got: Vec<Vec3> = got.chunks(PIXELS).map(|c| c.iter().sum::<Vec3>() / PIXELS as f32).collect();
        let truth = lab.truth(&scene, &line, 2048)?;
        Ok((largest_jump(&got) - largest_jump(&truth)).max(0.0).into())
    })?;
    Ok(vec![entry])
}

/// Largest second difference along a line over the mean; a few neighbours are averaged against what noise is left.
fn largest_jump(values: &[Vec3]) -> f64 {
    const WINDOW: usize = 3;
    let smooth: Vec<f64> = values.windows(WINDOW).map(mean).collect();
    let jump = smooth.windows(WINDOW).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs()).fold(0.0, f64::max);
    let scale = mean(values);
    if scale > 0.0 { jump / scale } else { 0.0 }
}
