//! (g) Geometry finer than the method and non-manifold geometry, (k) degenerate input.

use super::{Make, studio};
use crate::error::Error;
use crate::methods::Setting;
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

/// Five sheets that share one edge: no side of any of them is the inside of something.
fn fan() -> Scene {
    let mut b = room();
    let red = b.diffuse("sheets", [0.7, 0.2, 0.2]);
    for k in 0..5 {
        let (sin, cos) = (0.4 + k as f32 * std::f32::consts::TAU / 5.0).sin_cos();
        let (x, z) = (1.2 + 0.8 * cos, 1.6 + 0.8 * sin);
        b.quad([[1.2, 0.0, 1.6], [x, 0.0, z], [x, 1.8, z], [1.2, 1.8, 1.6]], red);
    }
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
    let cases: [(&str, Make); 5] = [
        ("a two-sided sheet", sheet),
        ("five sheets on one edge", fan),
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
        measure: "the share of impossible values at receivers inside walls",
        bound: 0.0,
        ..odd
    };
    // The block spans x 1.1…1.9, y 0…1.2, z 1.2…2; the room ends at x = 0.
    let places = [[1.5, 0.6, 1.6], [-0.1, 1.5, 2.0]];
    let names = ["receivers 40 cm inside a block", "receivers 10 cm behind a wall"];
    let buried = inside.cases(lab, "geometry", &names, |lab, k| {
        let scene = studio(LIGHT, 1.1);
        let surfels = lab.seen(&scene, &scene.cameras[0], SIDE_PX)?;
        let buried: Vec<Surfel> = surfels.iter().map(|s| Surfel { position: places[k], ..*s }).collect();
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

const CASES: [&str; 9] = [
    "identical receivers",
    "a single receiver",
    "receivers on no surface",
    "receivers a kilometre outside",
    "a scene of one triangle",
    "black surfaces",
    "a scene without triangles",
    "specks of a single texel",
    "a cavity that nothing sees into",
];

/// Times the brightest value of a plain room: more is impossible.
const HEADROOM: f32 = 2.0;

pub fn degenerate(lab: &mut Lab) -> Result<Vec<Entry>, Error> {
    let question = Question {
        variant: "input",
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
    let most = HEADROOM * lit.iter().map(|v| v.max_element()).fold(0.0, f32::max);
    let entry = question.cases(lab, "degenerate", &CASES, |lab, k| {
        let (scene, points, most) = case(lab, k, &scene, &surfels, most)?;
        Ok(impossible(&lab.measure(&scene, &points)?.values, most).into())
    });
    Ok(vec![entry, least_settings(lab, &question, (&scene, &surfels), most)])
}

/// Every setting that is a number at the least that the method takes, one after the other, and shares (of an error, of a
/// flux) at the whole: no probes to speak of, order 0, rank 0. What the method refuses in words is no failure.
fn least_settings(lab: &mut Lab, question: &Question, (scene, surfels): (&Scene, &[Surfel]), most: f32) -> Entry {
    const LEAST: [&str; 9] = ["0", "0.01", "1", "2", "4", "5", "8", "16", "64"];
    let question = Question { variant: "least settings", ..question.clone() };
    let numeric = lab.row.settings.iter().filter(|s| s.default.parse::<f64>().is_ok());
    let least = |key: &'static str| LEAST.iter().find(|v| lab.changed(&[(key, **v)]).is_some()).map(|v| (key, *v));
    let changes: Vec<(&str, &str)> = numeric.clone().filter_map(|s| least(s.key)).collect();
    let whole = |s: &Setting| s.default.parse::<f64>().is_ok_and(|x| 0.0 < x && x < 1.0);
    let wholes = numeric.filter(|s| whole(s)).map(|s| (s.key, "1")).filter(|c| lab.changed(&[*c]).is_some());
    let changes: Vec<(&str, &str)> = changes.into_iter().chain(wholes).collect();
    if changes.is_empty() {
        return question.not_applicable(lab, "degenerate", "the method has no settings that are numbers");
    }
    let names: Vec<String> = changes.iter().map(|(key, value)| format!("{key} = {value}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    question.cases(lab, "degenerate", &names, |lab, k| {
        let settings = lab.changed(&[changes[k]]).unwrap_or_else(|| lab.settings.clone());
        match lab.measure_with(&settings, scene, surfels) {
            // Fewer of anything may well make it brighter, not beyond all measure.
            Ok(measured) => Ok(impossible(&measured.values, HEADROOM * most).into()),
            Err(Error::Method(_)) => Ok(0.0.into()),
            Err(other) => Err(other),
        }
    })
}

/// Scene, receivers, and the largest value that is possible there.
fn case(
    lab: &mut Lab,
    k: usize,
    scene: &Scene,
    surfels: &[Surfel],
    most: f32,
) -> Result<(Scene, Vec<Surfel>, f32), Error> {
    let nothing = Surfel { triangle: NO_SURFACE, normal: [0.0; 3], geometric_normal: [0.0; 3], ..surfels[0] };
    let seen = |lab: &mut Lab, scene: Scene, most: f32| {
        let points = lab.seen(&scene, &scene.cameras[0], 16)?;
        Ok((scene, points, most))
    };
    match k {
        0 => Ok((scene.clone(), vec![surfels[0]; 256], most)),
        1 => Ok((scene.clone(), vec![surfels[surfels.len() / 2]], most)),
        2 => Ok((scene.clone(), vec![nothing; 64], most)),
        3 => {
            let far = |s: &Surfel| Surfel { position: [1e3, 1e3, 1e3], ..*s };
            Ok((scene.clone(), surfels.iter().map(far).collect(), most))
        }
        4 => {
            let mut b = SceneBuilder::new("one triangle");
            let white = b.diffuse("white", [0.7; 3]);
            // Beneath what the camera looks at.
            b.polygon(&[Vec3::ZERO, Vec3::new(0.0, 0.0, 3.0), Vec3::new(3.0, 0.0, 0.0)], white);
            // Nothing can be lit twice: a method may only lose itself a little in its own grid.
            seen(lab, finish(b, LIGHT), 0.5 * most)
        }
        5 => {
            let mut black = scene.clone();
            black.materials.iter_mut().for_each(|m| m.albedo = Vec3::ZERO);
            // Rounding of stored albedo may leave a trace.
            Ok((black, surfels.to_vec(), 1e-3 * most))
        }
        6 => {
            let empty = Scene { cameras: scene.cameras.clone(), lights: scene.lights.clone(), ..Scene::default() };
            Ok((empty, vec![nothing; 64], 0.0))
        }
        7 => seen(lab, specks(), most),
        _ => Ok((cavity(), seen(lab, cavity(), most)?.1, most)),
    }
}

/// A room with three hundred separate triangles of 1 cm in the air.
fn specks() -> Scene {
    let mut b = room();
    let grey = b.diffuse("specks", [0.6; 3]);
    for k in 0..300 {
        let p = Vec3::new((k % 10) as f32, (k / 10 % 6) as f32, (k / 60) as f32) * 0.2 + 0.3;
        b.polygon(&[p, p + Vec3::new(0.01, 0.0, 0.0), p + Vec3::new(0.0, 0.01, 0.005)], grey);
    }
    finish(b, LIGHT)
}

/// A room with a closed box in it, seen from within the box.
fn cavity() -> Scene {
    let mut b = room();
    let grey = b.diffuse("cavity", [0.6; 3]);
    b.block([2.6, 0.5, 2.6], [3.2, 1.1, 3.2], grey);
    b.light(Light::Point { position: LIGHT, intensity: Vec3::splat(20.0) });
    b.camera("within", [2.9, 0.8, 2.9], [3.2, 0.7, 2.7], 75.0);
    b.finish()
}
