//! The detectors of `stress` on methods made to fail in known ways, and every method's known ranges.

use glam::{Vec3, Vec4};
use interreflect::error::Error;
use interreflect::exec::{BufferId, CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::{Input, METHODS, Method, MethodError, MethodRow, Settings, StageClock, Unit};
use interreflect::stress::{self, Entry, FAMILIES, Lab, NOT_FINITE, Safe, State};
use interreflect_shared::scene::Surfel;
use std::f32::consts::PI;

/// A method that is wrong in one way.
struct Fake {
    value: fn(&Fake, &Surfel, &Input<'_>, usize) -> f32,
    /// New state from the old one and the scene's emission.
    update: fn(f32, f32) -> f32,
    unit_m: Option<f32>,
    state: f32,
}

fn emission(input: &Input<'_>) -> f32 {
    input.scene.materials.iter().map(|m| m.emission.max_element()).fold(0.0, f32::max)
}

impl Method for Fake {
    fn precompute(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Ok(())
    }

    fn light_change(&mut self, _: &mut dyn Executor, input: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        self.state = (self.update)(self.state, emission(input));
        Ok(())
    }

    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        _: &mut StageClock,
    ) -> Result<(), MethodError> {
        let surfels = exec.read_slice::<Surfel>(gbuffer)?;
        let out: Vec<Vec4> =
            surfels.iter().enumerate().map(|(k, s)| Vec3::splat((self.value)(self, s, input, k)).extend(0.0)).collect();
        Ok(exec.write(irradiance, bytemuck::cast_slice(&out))?)
    }

    fn unit(&self) -> Option<Unit> {
        self.unit_m.map(|metres| Unit { name: "yards", metres })
    }
}

macro_rules! fake {
    ($name:ident, $unit:expr, $update:expr, $value:expr) => {
        const $name: MethodRow = MethodRow {
            name: stringify!($name),
            control: false,
            summary: "",
            good_when: "",
            fails_when: "",
            settings: &[],
            ladder: &[("only", &[])],
            new: |_: &Settings| {
                Ok(Box::new(Fake { value: $value, update: $update, unit_m: $unit, state: 0.0 }) as Box<dyn Method>)
            },
        };
    };
}

const KEEP: fn(f32, f32) -> f32 = |_, e| e;
fake!(CONSTANT, None, KEEP, |_, _, _, _| 1.0);
fake!(NOT_A_NUMBER, None, KEEP, |_, _, _, _| f32::NAN);
fake!(NEGATIVE, None, KEEP, |_, s, _, _| if s.position[0] > 1.0 { -0.5 } else { 1.0 });
// What a furnace gives: π·Lₑ·ρ/(1 − ρ).
fake!(ENERGY, None, KEEP, |f, s, _, _| PI * f.state * s.albedo[0] / (1.0 - s.albedo[0]));
fake!(HALF_ENERGY, None, KEEP, |f, s, _, _| 0.5 * PI * f.state * s.albedo[0] / (1.0 - s.albedo[0]));
// A loop that grows by 5 % per frame, and one that keeps nine tenths.
fake!(GROWING, None, |x, e| 1.05 * x + e, |f, _, _, _| f.state);
fake!(SLOW, None, |x, e| x + 0.1 * (e - x), |f, _, _, _| f.state);
// Steps of 0.73 m in world space: jumps, and depends on where and how the scene lies.
fake!(STEPS, Some(0.5), KEEP, |_, s, _, _| 1.0
    + s.position.iter().map(|x| (1.37 * x).floor().rem_euclid(2.0)).sum::<f32>());
// Noise that belongs to the pixel and not to the point.
fake!(NOISY, Some(0.1), KEEP, |_, _, _, k| 1.0 + 0.3 * ((k * 7919 % 101) as f32 / 101.0 - 0.5));
/// Size of LEAKY's unit, and the wall in units at which a hundredth of the light comes through.
const UNIT_M: f32 = 0.1;
const LEAK_AT: f32 = 1.2;
fake!(LEAKY, Some(UNIT_M), KEEP, |_, s, input, _| {
    let wall = 2.0 * (input.scene.bounds().1.x - 3.0);
    if s.position[0] > 0.0 { 0.01f32.powf(wall / UNIT_M / LEAK_AT) } else { 1.0 }
});

fn measure(row: &'static MethodRow, families: &[&str], rung: usize) -> Vec<Entry> {
    // Truths are kept for the next run of the tests.
    let cache = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("stress-truths");
    let changes = row.ladder[rung.min(row.ladder.len() - 1)].1;
    let settings = row.with(changes.iter().copied()).expect("a ladder's settings");
    let mut lab = Lab { row, settings, seed: 1, cache, exec: Box::new(CpuExecutor::new()), not_finite: false };
    let chosen: Vec<_> = FAMILIES.iter().filter(|f| families.contains(&f.key)).collect();
    assert_eq!(chosen.len(), families.len());
    let entries = stress::run(&mut lab, &chosen, &mut |e| println!("{}", e.sentence));
    assert!(entries.iter().all(|e| e.state != State::Broken), "{entries:#?}");
    entries
}

fn only(row: &'static MethodRow, family: &str, variant: &str) -> Entry {
    let entries = measure(row, &[family], 0);
    entries.into_iter().find(|e| e.variant == variant).unwrap_or_else(|| panic!("{family} has no {variant}"))
}

#[test]
fn bisection_finds_the_wall_at_which_a_leak_begins() {
    let entry = only(&LEAKY, "leak", "");
    let Safe::From { at } = entry.safe else { panic!("{:?}", entry.safe) };
    // Three halvings of 1…1.5 in the logarithm.
    let step = 1.5_f64.powf(1.0 / 8.0);
    let from = f64::from(LEAK_AT);
    assert!((from..=from * step * 1.01).contains(&at), "{at}");
    assert!(entry.sentence.contains("exceeds 1 % below 1.2") && entry.sentence.contains("yards"), "{}", entry.sentence);
    assert!(entry.picture.is_some());
    assert_eq!(only(&CONSTANT, "leak", "").safe, Safe::Nowhere);
}

#[test]
fn energy_is_held_to_the_closed_form() {
    let right = only(&ENERGY, "furnace", "all bounces");
    assert_eq!(right.safe, Safe::Everywhere);
    assert!(right.samples.iter().all(|s| s.value < 1e-3), "{:?}", right.samples);
    let wrong = only(&HALF_ENERGY, "furnace", "all bounces");
    assert_eq!(wrong.safe, Safe::Nowhere);
    assert!(wrong.samples.iter().all(|s| (s.value - 0.5).abs() < 1e-3), "{:?}", wrong.samples);
    assert_eq!(only(&ENERGY, "furnace", "counted bounces").state, State::NotApplicable);
}

#[test]
fn loops_that_grow_are_told_from_loops_that_settle() {
    let growing = measure(&GROWING, &["feedback"], 0);
    assert_eq!(growing[0].safe, Safe::Nowhere);
    assert!(growing[0].samples.iter().all(|s| (s.value - 1.05).abs() < 0.01), "{:?}", growing[0].samples);
    let slow = measure(&SLOW, &["feedback"], 0);
    assert_eq!(slow[0].safe, Safe::Everywhere);
    assert!(slow[0].samples.iter().all(|s| (s.value - 0.9).abs() < 0.01), "{:?}", slow[0].samples);
    // 0.9ⁿ ≤ 0.05 first at n = 29.
    assert!(slow[1].samples.iter().all(|s| (s.value - 29.0).abs() <= 1.0), "{:?}", slow[1].samples);
    let instant = measure(&ENERGY, &["feedback"], 0);
    assert!(instant[0].samples.iter().all(|s| s.value == 0.0) && instant[1].samples.iter().all(|s| s.value == 1.0));
}

#[test]
fn what_depends_on_place_or_pixel_is_noticed() {
    for family in ["popping", "rotation", "offset"] {
        let entry = only(&STEPS, family, "");
        assert!(!matches!(entry.safe, Safe::Everywhere), "{family}: {}", entry.sentence);
        let constant = only(&CONSTANT, family, "");
        assert_eq!(constant.safe, Safe::Everywhere, "{family}: {}", constant.sentence);
        assert!(constant.samples.iter().all(|s| s.value == 0.0), "{family}: {:?}", constant.samples);
    }
    assert_eq!(only(&NOISY, "flicker", "camera").safe, Safe::Nowhere);
    assert_eq!(only(&CONSTANT, "flicker", "camera").safe, Safe::Everywhere);
}

#[test]
fn impossible_values_are_noticed() {
    let families = ["leak", "flicker", "popping", "furnace", "ringing", "geometry", "scale", "lights", "degenerate"];
    for entry in measure(&NOT_A_NUMBER, &families, 0).into_iter().filter(|e| e.state == State::Measured) {
        assert_eq!(entry.safe, Safe::Nowhere, "{}", entry.sentence);
        assert!(entry.samples.iter().all(|s| s.value == NOT_FINITE), "{:?}", entry.samples);
    }
    let negative = only(&NEGATIVE, "ringing", "most negative");
    assert_eq!(negative.safe, Safe::Nowhere);
    let dark = only(&CONSTANT, "lights", "must be dark");
    assert_eq!(dark.safe, Safe::Nowhere, "{}", dark.sentence);
    let buried = only(&NEGATIVE, "geometry", "inside walls");
    assert_eq!(buried.samples[0].value, 1.0, "{}", buried.sentence);
}

#[test]
fn a_method_that_panics_is_an_entry() {
    const PANICS: MethodRow = MethodRow { new: |_| panic!("on purpose"), ..CONSTANT };
    let mut lab = Lab {
        row: &PANICS,
        settings: Settings::new(),
        seed: 1,
        cache: std::env::temp_dir(),
        exec: Box::new(CpuExecutor::new()),
        not_finite: false,
    };
    let families: Vec<_> = FAMILIES.iter().filter(|f| f.key == "leak").collect();
    let entries = stress::run(&mut lab, &families, &mut |_| {});
    assert_eq!(entries[0].state, State::Broken);
    assert!(entries[0].reason.as_ref().unwrap().contains("on purpose"));
    // The same for one that refuses.
    const REFUSES: MethodRow = MethodRow {
        new: |_| Err(MethodError::TooLarge { method: "r", needed_bytes: 2, limit_bytes: 1, hint: "h".into() }),
        ..CONSTANT
    };
    lab.row = &REFUSES;
    let entries = stress::run(&mut lab, &families, &mut |_| {});
    assert!(entries[0].state == State::Broken && entries[0].reason.as_ref().unwrap().contains("2 bytes"));
}

/// Every line of `known-ranges.txt`: what a method is known to do at its cheapest rung. A range that was safe must stay
/// safe; a failure must still be seen.
#[test]
fn known_ranges_hold_and_known_failures_are_still_seen() -> Result<(), Error> {
    let known: Vec<Vec<&str>> = include_str!("known-ranges.txt")
        .lines()
        .filter(|l| !l.trim().is_empty() && !l.starts_with('#'))
        .map(|l| l.split('|').map(str::trim).collect())
        .collect();
    for row in METHODS.iter().filter(|m| !m.control) {
        let lines: Vec<_> = known.iter().filter(|l| l[0] == row.name).collect();
        if lines.is_empty() {
            println!("{}: nothing is known; `stress` measures it, and known-ranges.txt may hold it to that", row.name);
            continue;
        }
        let mut families: Vec<&str> = lines.iter().map(|l| l[1]).collect();
        families.dedup();
        let entries = measure(row, &families, 0);
        for line in lines {
            let [_, family, variant, kind, number] = line[..] else { panic!("five columns: {line:?}") };
            let entry = entries
                .iter()
                .find(|e| e.family == family && e.variant == variant)
                .unwrap_or_else(|| panic!("no entry for {line:?}"));
            holds(entry, kind, number.parse().unwrap_or(f64::NAN));
        }
    }
    Ok(())
}

/// `safe-from x`, `safe-up-to x`: every measurement on that side is within the bound. `fails-below x`, `fails-above x`: one
/// on that side is not. `safe`: all are; `fails`: one is not.
fn holds(entry: &Entry, kind: &str, at: f64) {
    let bad = |inside: &dyn Fn(f64) -> bool| {
        entry.samples.iter().filter(|s| inside(s.parameter)).any(|s| s.value > entry.bound)
    };
    let any = |inside: &dyn Fn(f64) -> bool| entry.samples.iter().any(|s| inside(s.parameter));
    let right = match kind {
        "safe" => !bad(&|_| true),
        "fails" => bad(&|_| true),
        "safe-from" => any(&|p| p >= at) && !bad(&|p| p >= at),
        "safe-up-to" => any(&|p| p <= at) && !bad(&|p| p <= at),
        "fails-below" => bad(&|p| p <= at),
        "fails-above" => bad(&|p| p >= at),
        other => panic!("unknown kind {other}"),
    };
    assert!(right, "{} {} {kind} {at}: {} {:?}", entry.family, entry.variant, entry.sentence, entry.samples);
}
