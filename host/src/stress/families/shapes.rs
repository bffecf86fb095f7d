//! (g) Geometry finer than the method and non-manifold geometry, (k) degenerate input.

use super::{Make, studio};
use crate::error::Error;
use crate::scene::built_in::SceneBuilder;
use crate::scene::{Light, Scene};
use crate::stress::lab::{SIDE_PX, mean, picture};
use crate::stress::{Answer, Danger, Entry, Lab, Question};
use glam::Vec3;
use interreflect_shared::scene::{NO_SURFACE, Surfel};

const TRUTH_SPP: u32 = 128;
const LIGHT: Vec3 = Vec3::new(2.0, 2.6, 2.0);

/// A room with a partition of vertical bars of `width_m` and gaps as wide, lit on one side.
fn bars(width_m: f32) -> Scene {
    let mut b = room();
    let white = b.diffuse("bars", [0.7; 3]);
    let mut z = 0.0;
    while z < 4.0 {
        b.block([1.99, 0.0, z], [2.01, 3.0, (z + width_m).min(4.0)], white);
        z += 2.0 * width_m;
    }
    finish(b, Vec3::new(3.2, 2.4, 2.2))
}

fn room() -> SceneBuilder {
    let mut b = SceneBuilder::new("shapes");
    let white = b.diffuse("white", [0.7; 3]);
    b.room([0.0; 3], [4.0, 3.0, 4.0], [white; 6]);
    b
}

fn finish(mut b: SceneBuilder, light: Vec3) -> Scene {
    b.light(Light::Point { position: light, intensity: Vec3::splat(20.0) });
    b.camera("dim side", [1.7, 1.5, 3.6], [0.4, 1.2, 0.6], 75.0);
    b.finish()
}

/// A free-standing sheet of two triangles, seen and lit from both sides.
fn sheet() -> Scene {
    let mut b = room();
    let red = b.diffuse("sheet", [0.7, 0.2, 0.2]);
    b.quad([[1.0, 0.0, 1.0], [1.0, 0.0, 3.0], [1.0, 2.0, 3.0], [1.0, 2.0, 1.0]], red);
    finish(b, LIGHT)
}

/// Two blocks that interpenetrate, and one that sinks into the floor.
fn interpenetrating() -> Scene {
    let mut b = room();
    let grey = b.diffuse("blocks", [0.6; 3]);
    b.block([0.8, 0.0, 0.8], [1.6, 1.5, 1.6], grey);
    b.block([1.2, 0.3, 1.2], [2.0, 1.0, 2.0], grey);
    b.block([0.4, -0.5, 2.2], [1.0, 0.4, 2.8], grey);
    finish(b, LIGHT)
}

/// Every wall of a block twice in the same place.
fn doubled() -> Scene {
    let mut b = room();
    let grey = b.diffuse("block", [0.6; 3]);
    for _ in 0..2 {
        b.block([0.8, 0.0, 0.8], [1.6, 1.5, 1.6], grey);
    }
    finish(b, LIGHT)
}

/// A fan of triangles a tenth of a millimetre wide, without area to speak of.
fn slivers() -> Scene {
    let mut b = room();
    let grey = b.diffuse("slivers", [0.6; 3]);
    for k in 0..200 {
        let z = 1.0 + 0.01 * k as f32;
        b.polygon(&[Vec3::new(1.0, 0.0, z), Vec3::new(1.0, 0.0, z + 1e-4), Vec3::new(1.0, 2.0, z)], grey);
    }
    finish(b, LIGHT)
}

pub fn geometry(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let sample = bars(0.2);
    let surfels = lab.seen(&sample, &sample.cameras[0], SIDE_PX)?;
    let (unit, metres) = lab.unit(&sample, &surfels)?;
    let thin = Question {
        variant: "bars",
        measure: "the error of the mean behind bars",
        parameter: "width of bars and gaps",
        unit,
        bound: 0.3,
        percent: true,
        danger: Danger::Low,
    };
    let behind = thin.sweep(lab, "geometry", &[0.25, 0.5, 1.0, 2.0, 4.0], 1, |lab, width| {
        // Bars thinner than 4 mm would be more than a thousand.
        let scene = bars(((width * metres) as f32).max(0.004));
        error_of_mean(lab, &scene, format!("Behind bars {width:.2} {unit} wide."))
    })?;
    let cases: [(&str, Make); 4] = [
        ("a two-sided sheet", sheet),
        ("interpenetrating blocks", interpenetrating),
        ("a block of doubled faces", doubled),
        ("slivers", slivers),
    ];
    let names = cases.map(|c| c.0);
    let odd = Question { variant: "odd meshes", parameter: "", unit: "", danger: Danger::Cases, ..thin };
    let odd = Question { measure: "the error of the mean", ..odd };
    let meshes = odd.cases(lab, "geometry", &names, |lab, k| error_of_mean(lab, &(cases[k].1)(), names[k].into()));
    let inside = Question {
        variant: "inside walls",
        measure: "the share of impossible values at receivers inside a block",
        bound: 0.0,
        ..odd
    };
    let buried = inside.cases(lab, "geometry", &["receivers 20 cm inside a block"], |lab, _| {
        let scene = studio(LIGHT, 1.1);
        let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
        let buried: Vec<Surfel> = surfels.iter().map(|s| Surfel { position: [1.5, 0.6, 1.6], ..*s }).collect();
        let lit = lab.measure(&scene, &surfels)?.values;
        let brightest = lit.iter().map(|v| v.max_element()).fold(0.0, f32::max);
        let values = lab.measure(&scene, &buried)?.values;
        Ok(impossible(&values, 2.0 * brightest).into())
    });
    Ok(vec![behind, meshes, buried])
}

/// Share of values that are not finite, negative, or above `most`.
fn impossible(values: &[Vec3], most: f32) -> f64 {
    let bad = values.iter().filter(|v| !v.is_finite() || v.min_element() < -1e-3 * most || v.max_element() > most);
    bad.count() as f64 / values.len().max(1) as f64
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

const CASES: [&str; 7] = [
    "identical receivers",
    "a single receiver",
    "receivers on no surface",
    "receivers a kilometre outside",
    "a scene of one triangle",
    "black surfaces",
    "a scene without triangles",
];

pub fn degenerate(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let question = Question {
        variant: "",
        measure: "the share of impossible values",
        parameter: "",
        unit: "",
        bound: 0.0,
        percent: true,
        danger: Danger::Cases,
    };
    let scene = studio(LIGHT, 1.1);
    let surfels = lab.seen(&scene, &scene.cameras[0], 16)?;
    let lit = lab.measure(&scene, &surfels)?.values;
    let most = 2.0 * lit.iter().map(|v| v.max_element()).fold(0.0, f32::max);
    let entry = question.cases(lab, "degenerate", &CASES, |lab, k| {
        let (scene, points, most) = case(k, &scene, &surfels, most);
        Ok(impossible(&lab.measure(&scene, &points)?.values, most).into())
    });
    Ok(vec![entry])
}

/// Scene, receivers, and the largest value that is possible there.
fn case(k: usize, scene: &Scene, surfels: &[Surfel], most: f32) -> (Scene, Vec<Surfel>, f32) {
    let nothing = Surfel { triangle: NO_SURFACE, normal: [0.0; 3], geometric_normal: [0.0; 3], ..surfels[0] };
    match k {
        0 => (scene.clone(), vec![surfels[0]; 256], most),
        1 => (scene.clone(), vec![surfels[surfels.len() / 2]], most),
        2 => (scene.clone(), vec![nothing; 64], most),
        3 => {
            let far = |s: &Surfel| Surfel { position: [1e3, 1e3, 1e3], ..*s };
            (scene.clone(), surfels.iter().map(far).collect(), most)
        }
        4 => {
            let mut b = SceneBuilder::new("one triangle");
            let white = b.diffuse("white", [0.7; 3]);
            b.polygon(&[Vec3::ZERO, Vec3::X, Vec3::Z], white);
            // Nothing can be lit twice: all must be dark.
            (finish(b, LIGHT), surfels.to_vec(), most)
        }
        5 => {
            let mut black = scene.clone();
            black.materials.iter_mut().for_each(|m| m.albedo = Vec3::ZERO);
            // Rounding of stored albedo may leave a trace.
            (black, surfels.to_vec(), 1e-3 * most)
        }
        _ => {
            let empty = Scene { cameras: scene.cameras.clone(), lights: scene.lights.clone(), ..Scene::default() };
            (empty, vec![nothing; 64], 0.0)
        }
    }
}
