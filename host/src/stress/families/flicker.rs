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
/// Frames of a motion, at least.
const FRAMES: usize = 7;
/// Units that a motion covers at least: what it does not cross it cannot flicker at.
const COVERED: f64 = 1.2;
/// Samples of each of the truth's two pictures of a frame: the noise of its own flicker must stay well below the bound squared.
const TRUTH_SPP: u32 = 512;
/// Rows of pixels.
const SIDE_PX: u32 = 16;

/// Mean product of the second differences in time of two runs of the same frames, over the square of the mean: of a run
/// with itself the mean square, of two independent ones the mean square without their noise.
fn second_differences(frames: &[Vec<Vec3>], again: &[Vec<Vec3>]) -> f64 {
    let bend = |f: &[Vec<Vec3>], k: usize, i: usize| f[k - 1][i] - 2.0 * f[k][i] + f[k + 1][i];
    let (mut product, mut count) = (0.0, 0.0);
    for k in 1..frames.len() - 1 {
        for i in 0..frames[k].len() {
            product += f64::from(bend(frames, k, i).dot(bend(again, k, i)));
            count += 3.0;
        }
    }
    let scale = frames.iter().map(|f| mean(f)).sum::<f64>() / frames.len() as f64;
    if scale > 0.0 { product / f64::max(count, 1.0) / (scale * scale) } else { 0.0 }
}

fn beyond(method: &[Vec<Vec3>], truth_square: f64) -> f64 {
    (second_differences(method, method) - truth_square.max(0.0)).max(0.0).sqrt()
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
        let scenes = motion(step, |k| studio(LIGHT + Vec3::X * (k as f64 * step * metres) as f32, BLOCK_X));
        let settings = lab.settings.clone();
        let frames = lab.session(&settings, &scenes[0], &walls, |session| {
            let frame = |scene: &Scene| {
                session.relight(scene)?;
                session.light_change(scene)?;
                session.frame(scene)
            };
            scenes.iter().map(frame).collect::<Result<Vec<_>, Error>>()
        })?;
        Ok(beyond(&frames, truth_of(lab, &scenes, &walls)?).into())
    })?;
    let object = question("object", "object motion per frame").sweep(lab, "flicker", &GRID, 1, |lab, step| {
        let scenes = motion(step, |k| studio(LIGHT, BLOCK_X + (k as f64 * step * metres) as f32));
        let frame = |lab: &mut Lab, scene: &Scene| {
            let points = lab.attach(scene, &walls)?;
            Ok(lab.measure(scene, &points)?.values)
        };
        let frames: Vec<_> = scenes.iter().map(|s| frame(lab, s)).collect::<Result<_, Error>>()?;
        Ok(beyond(&frames, truth_of(lab, &scenes, &walls)?).into())
    })?;
    let seen = question("camera", "camera motion per frame").sweep(lab, "flicker", &GRID, 1, |lab, step| {
        let frames = camera_motion(lab, &still, &surfels, &camera, step * metres)?;
        // The truth at a point does not depend on who looks.
        let worst = frames.last().and_then(|f| picture(f, &frames[0]));
        let words = format!("A frame of a camera that moves by {step} {unit} per frame.");
        Ok(crate::stress::Answer { value: beyond(&frames, 0.0), picture: worst.map(|png| (png, words)) })
    })?;
    Ok(vec![light, object, seen])
}

fn on_wall(s: &Surfel) -> bool {
    let near = |x: f32, wall: f32| (x - wall).abs() < 1e-3;
    let [x, _, z] = s.position;
    near(x, 0.0) || near(x, 4.0) || near(z, 0.0) || near(z, 4.0)
}

/// Frames of a motion by steps of `step` units.
fn motion(step: f64, scene: impl Fn(usize) -> Scene) -> Vec<Scene> {
    (0..FRAMES.max((COVERED / step).ceil() as usize + 1)).map(scene).collect()
}

/// Mean square of the truth's own second differences, from two independent sets of paths.
fn truth_of(lab: &Lab, scenes: &[Scene], surfels: &[Surfel]) -> Result<f64, Error> {
    let run = |seed: u32| -> Result<Vec<Vec<Vec3>>, Error> {
        scenes.iter().map(|s| lab.truth_by(s, surfels, TRUTH_SPP, seed)).collect()
    };
    Ok(second_differences(&run(77)?, &run(78)?))
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

/// Pixels at which each point of a line is asked: what jitter is left of their mean is a fifth of the bound.
const PIXELS: usize = 1024;
/// Ends of the line along the back wall (m).
const LINE: [f32; 2] = [0.5, 3.5];

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
        bound: 0.05,
        percent: true,
        danger: Danger::High,
    };
    let Some(template) = surfels.iter().find(|s| on_wall(s)).copied() else {
        return Ok(vec![question.not_applicable(lab, "popping", "the camera sees no wall")]);
    };
    let at = |x: f32| Surfel {
        position: [x, 1.7, 0.0],
        normal: [0.0, 0.0, 1.0],
        geometric_normal: [0.0, 0.0, 1.0],
        ..template
    };
    let truth = SmoothTruth::new(lab, &scene, at)?;
    let entry = question.sweep(lab, "popping", &[0.1, 0.25, 0.5, 1.0], 0, |lab, distance| {
        let step = (distance * metres) as f32;
        let count = (((LINE[1] - LINE[0]) / step) as usize).clamp(5, 100);
        let places: Vec<f32> = (0..count).map(|k| LINE[0] + step * k as f32).collect();
        let line: Vec<Surfel> = places.iter().map(|x| at(*x)).collect();
        let line = lab.attach(&scene, &line)?;
        // Every point at many pixels: their jitter is noise, which the mean takes away, and no jump.
        let many: Vec<Surfel> = line.iter().flat_map(|s| [*s; PIXELS]).collect();
        let got = lab.measure(&scene, &many)?.values;
        let got: Vec<f64> = got.chunks(PIXELS).map(mean).collect();
        let expected: Vec<f64> = places.iter().map(|x| truth.at(*x)).collect();
        Ok((largest_jump(&got) - largest_jump(&expected)).max(0.0).into())
    })?;
    Ok(vec![entry])
}

/// Largest second difference along a line over the mean; a few neighbours are averaged against what noise is left.
fn largest_jump(values: &[f64]) -> f64 {
    const WINDOW: usize = 3;
    let average = |v: &[f64]| v.iter().sum::<f64>() / v.len().max(1) as f64;
    let smooth: Vec<f64> = values.windows(WINDOW).map(average).collect();
    let jump = smooth.windows(WINDOW).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs()).fold(0.0, f64::max);
    let scale = average(values);
    if scale > 0.0 { jump / scale } else { 0.0 }
}

/// The truth along [`LINE`], where nothing but walls is near and it is smooth: a sum of Chebyshev polynomials through many
/// noisy points, whose own second differences show no noise. The points do not depend on the method.
struct SmoothTruth {
    coefficients: [f64; Self::DEGREE + 1],
}

impl SmoothTruth {
    const DEGREE: usize = 8;
    const NODES: usize = 64;
    const SPP: u32 = 4096;

    fn new(lab: &Lab, scene: &Scene, at: impl Fn(f32) -> Surfel) -> Result<Self, Error> {
        let angle = |j: usize| std::f64::consts::PI * (j as f64 + 0.5) / Self::NODES as f64;
        let place = |j: usize| Self::place(angle(j).cos());
        let nodes: Vec<Surfel> = (0..Self::NODES).map(|j| at(place(j))).collect();
        let values: Vec<f64> = lab.truth(scene, &nodes, Self::SPP)?.iter().map(|v| mean(&[*v])).collect();
        // Orthogonal over these nodes.
        let coefficient = |k: usize| {
            let sum: f64 = values.iter().enumerate().map(|(j, v)| v * (k as f64 * angle(j)).cos()).sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / Self::NODES as f64
        };
        Ok(Self { coefficients: std::array::from_fn(coefficient) })
    }

    /// From −1…1 to the line.
    fn place(t: f64) -> f32 {
        0.5 * (LINE[0] + LINE[1]) + 0.5 * (LINE[1] - LINE[0]) * t as f32
    }

    fn at(&self, x: f32) -> f64 {
        let t = f64::from((2.0 * x - LINE[0] - LINE[1]) / (LINE[1] - LINE[0])).clamp(-1.0, 1.0);
        self.coefficients.iter().enumerate().map(|(k, c)| c * (k as f64 * t.acos()).cos()).sum()
    }
}
