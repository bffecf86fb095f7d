//! The detectors of `stress` on methods made to fail in known ways, and every method's known ranges.

use glam::{Vec3, Vec4};
use interreflect::exec::{BufferId, CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::{Input, METHODS, Method, MethodError, MethodRow, Settings, StageClock, Unit};
use interreflect::stress::{self, Effort, Entry, FAMILIES, Lab, NOT_FINITE, Safe, State};
use interreflect_shared::scene::Surfel;
use std::f32::consts::PI;

/// A method that is wrong in one way.
struct Fake {
    value: fn(&Fake, &Surfel, &Input<'_>, usize) -> f32,
    /// New state from the old one and the scene's emission.
    update: fn(f32, f32) -> f32,
    unit_m: Option<f32>,
    state: f32,
    /// Least irradiance over the mean that it cuts off.
    hides: Option<f64>,
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

    fn lowest_uncut(&self, _: &mut dyn Executor) -> Result<Option<[f64; 2]>, MethodError> {
        Ok(self.hides.map(|low| [low, 1.0]))
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
                let hides = None;
                Ok(Box::new(Fake { value: $value, update: $update, unit_m: $unit, state: 0.0, hides })
                    as Box<dyn Method>)
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
// 1, 3, 1, 3… for an emission of 4.
fake!(SWINGS, None, |x, e| if x == 0.25 * e { 0.75 * e } else { 0.25 * e }, |f, _, _, _| f.state);
fake!(SLOW, None, |x, e| x + 0.1 * (e - x), |f, _, _, _| f.state);
// Steps of 0.73 m in world space: jumps, and depends on where and how the scene lies.
fake!(STEPS, Some(0.5), KEEP, |_, s, _, _| 1.0
    + s.position.iter().map(|x| (1.37 * x).floor().rem_euclid(2.0)).sum::<f32>());
// Noise that belongs to the pixel and not to the point.
fake!(NOISY, Some(0.1), KEEP, |_, _, _, k| 1.0 + 0.3 * ((k * 7919 % 101) as f32 / 101.0 - 0.5));
// Fine to look at, because it cuts off what rings.
const HIDES_RINGING: MethodRow = MethodRow {
    name: "HIDES_RINGING",
    new: |_: &Settings| {
        Ok(Box::new(Fake { value: |_, _, _, _| 1.0, update: KEEP, unit_m: None, state: 0.0, hides: Some(-0.5) }))
    },
    ..CONSTANT
};
/// Size of LEAKY's unit, and the wall in units at which a hundredth of the light comes through.
const UNIT_M: f32 = 0.1;
const LEAK_AT: f32 = 1.2;
fake!(LEAKY, Some(UNIT_M), KEEP, |_, s, input, _| {
    let wall = 2.0 * (input.scene.bounds().1.x - 3.0);
    if s.position[0] > 0.0 { 0.01f32.powf(wall / UNIT_M / LEAK_AT) } else { 1.0 }
});

fn measure(row: &'static MethodRow, families: &[&str]) -> Vec<Entry> {
    measure_with(row, families, Effort::Full)
}

/// At the cheapest rung, with what `known-ranges.txt` changes of it.
fn measure_with(row: &'static MethodRow, families: &[&str], effort: Effort) -> Vec<Entry> {
    // Truths are kept for the next run of the tests.
    let cache = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("stress-truths");
    let changes = row.ladder[0].1.iter().copied().chain(Known::changes(row.name));
    let settings = row.with(changes).expect("a ladder's settings");
    let mut lab = Lab {
        row,
        settings,
        seed: 1,
        cache,
        exec: Box::new(CpuExecutor::new()),
        effort,
        not_finite: false,
        last: None,
    };
    let chosen: Vec<_> = FAMILIES.iter().filter(|f| families.contains(&f.key)).collect();
    assert_eq!(chosen.len(), families.len());
    let entries = stress::run(&mut lab, &chosen, &mut |e| println!("{}", e.sentence));
    assert!(entries.iter().all(|e| e.state != State::Broken), "{entries:#?}");
    entries
}

fn only(row: &'static MethodRow, family: &str, variant: &str) -> Entry {
    let entries = measure(row, &[family]);
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
    let of = |row| {
        let entries = measure(row, &["feedback"]);
        ["gain", "500 frames", "step response"]
            .map(|v| entries.iter().find(|e| e.variant == v).unwrap_or_else(|| panic!("no {v}")).clone())
    };
    let [gain, unrest, _] = of(&GROWING);
    assert_eq!(gain.safe, Safe::Nowhere);
    assert!(gain.samples.iter().all(|s| (s.value - 1.05).abs() < 0.01), "{:?}", gain.samples);
    assert_eq!(unrest.safe, Safe::Nowhere);
    // The last 250 frames hold 1.05²⁵⁰ times as much as those before: nearly all of the range is the last frames.
    assert!(unrest.samples.iter().all(|s| s.value > 10.0), "{:?}", unrest.samples);
    let [gain, unrest, step] = of(&SLOW);
    assert_eq!((gain.safe, unrest.safe), (Safe::Everywhere, Safe::Everywhere));
    assert!(gain.samples.iter().all(|s| (s.value - 0.9).abs() < 0.01), "{:?}", gain.samples);
    // 0.9ⁿ ≤ 0.05 first at n = 29.
    assert!(step.samples.iter().all(|s| (s.value - 29.0).abs() <= 1.0), "{:?}", step.samples);
    // Neither grows nor settles.
    let [_, unrest, _] = of(&SWINGS);
    assert_eq!(unrest.safe, Safe::Nowhere);
    assert!(unrest.samples.iter().all(|s| (s.value - 1.0).abs() < 0.01), "{:?}", unrest.samples);
    let [gain, unrest, step] = of(&ENERGY);
    assert!(gain.samples.iter().chain(&unrest.samples).all(|s| s.value == 0.0), "{gain:?} {unrest:?}");
    assert!(step.samples.iter().all(|s| s.value == 1.0), "{step:?}");
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
    for entry in measure(&NOT_A_NUMBER, &families).into_iter().filter(|e| e.state == State::Measured) {
        assert_eq!(entry.safe, Safe::Nowhere, "{}", entry.sentence);
        assert!(entry.samples.iter().all(|s| s.value == NOT_FINITE), "{:?}", entry.samples);
    }
    let negative = only(&NEGATIVE, "ringing", "most negative");
    assert_eq!(negative.safe, Safe::Nowhere);
    let hidden = only(&HIDES_RINGING, "ringing", "most negative");
    assert!(hidden.samples.iter().all(|s| s.value == 0.5), "{:?}", hidden.samples);
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
        effort: Effort::Full,
        not_finite: false,
        last: None,
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

const KNOWN: &str = include_str!("known-ranges.txt");

/// A line of `known-ranges.txt`.
struct Known<'a> {
    method: &'a str,
    family: &'a str,
    variant: &'a str,
    kind: &'a str,
    argument: &'a str,
}

impl<'a> Known<'a> {
    fn all(text: &'a str) -> Vec<Self> {
        let lines = text.lines().filter(|l| !l.trim().is_empty() && !l.starts_with('#'));
        lines
            .map(|line| {
                let columns: Vec<&str> = line.split('|').map(str::trim).collect();
                let [method, family, variant, kind, argument] = columns[..] else { panic!("five columns: {line}") };
                Known { method, family, variant, kind, argument }
            })
            .collect()
    }

    /// Settings that a method's lines are for, beside its cheapest rung's: the argument of `with`.
    fn changes(method: &str) -> Vec<(&'static str, &'static str)> {
        let with = Known::all(KNOWN).into_iter().find(|l| l.method == method && l.kind == "with");
        let pairs =
            with.map(|l| l.argument.split_whitespace().map(|p| p.split_once('=').expect("key=value")).collect());
        pairs.unwrap_or_default()
    }

    fn number(&self) -> f64 {
        self.argument.parse().unwrap_or_else(|_| panic!("{} {}: no number", self.family, self.kind))
    }

    /// Whether the entry is as the line says.
    fn holds(&self, entry: &Entry) -> bool {
        let bad = |inside: &dyn Fn(f64) -> bool| {
            entry.samples.iter().filter(|s| inside(s.parameter)).any(|s| s.value > entry.bound)
        };
        let safe = |inside: &dyn Fn(f64) -> bool| {
            entry.samples.iter().any(|s| inside(s.parameter)) && !bad(inside) && entry.state == State::Measured
        };
        let case = |name: &str| {
            let of = |s: &&stress::Sample| {
                s.case.as_deref().is_some_and(|c| c == name || c.starts_with(&format!("{name} (")))
            };
            entry.samples.iter().find(of).unwrap_or_else(|| panic!("no case {name}: {entry:#?}")).parameter
        };
        match self.kind {
            "safe" => safe(&|_| true),
            "fails" => bad(&|_| true),
            "safe-from" => safe(&|p| p >= self.number()),
            "safe-up-to" => safe(&|p| p <= self.number()),
            "fails-below" => bad(&|p| p <= self.number()),
            "fails-above" => bad(&|p| p >= self.number()),
            "safe-with" => safe(&|p| p == case(self.argument)),
            "fails-with" => bad(&|p| p == case(self.argument)),
            "worst" => {
                let (low, high) = self.argument.split_once("..").unwrap_or_else(|| panic!("worst LOW..HIGH"));
                let [low, high] = [low, high].map(|v| v.trim().parse::<f64>().expect("a number"));
                let worst = entry.samples.iter().map(|s| s.value).fold(f64::NEG_INFINITY, f64::max);
                (low..=high).contains(&worst)
            }
            "not-applicable" => entry.state == State::NotApplicable && !self.argument.is_empty(),
            other => panic!("unknown kind {other}"),
        }
    }

    /// Whether the line would notice if something that is safe no longer was.
    fn guards(&self) -> bool {
        self.kind.starts_with("safe") || self.kind == "worst"
    }

    /// Whether the line would notice if a failure was no longer seen.
    fn detects(&self) -> bool {
        self.kind.starts_with("fails") || self.kind == "worst"
    }
}

/// What is wrong with an entry and the lines about it: a line that does not hold, or something that no line says. A number
/// within this factor of its bound is neither clearly safe nor clearly failing, and needs no line.
fn wrongs(entry: &Entry, lines: &[&Known<'_>]) -> Vec<String> {
    const CLEAR: f64 = 1.5;
    let name = format!("{} | {} | {}", entry.method, entry.family, entry.variant);
    let values: Vec<String> = entry.samples.iter().map(|s| format!("{}: {:.4}", s.parameter, s.value)).collect();
    let broken = lines.iter().filter(|l| !l.holds(entry));
    let mut all: Vec<String> =
        broken.map(|l| format!("{name} | {} {}: {} {values:?}", l.kind, l.argument, entry.sentence)).collect();
    if lines.is_empty() {
        all.push(format!("{name}: no line says what is known: {} {values:?}", entry.sentence));
        return all;
    }
    let measured = entry.state == State::Measured;
    if measured && entry.samples.iter().any(|s| s.value > CLEAR * entry.bound) && !lines.iter().any(|l| l.detects()) {
        all.push(format!("{name}: it fails, and no line holds the detector to that: {} {values:?}", entry.sentence));
    }
    if measured && entry.samples.iter().any(|s| s.value * CLEAR <= entry.bound) && !lines.iter().any(|l| l.guards()) {
        all.push(format!("{name}: it is safe somewhere, and no line holds it to that: {} {values:?}", entry.sentence));
    }
    all
}

/// `known-ranges.txt` says what every method is known to do at its cheapest rung, entry by entry. What was safe must stay
/// safe, a failure must still be seen, and there is no entry that no line speaks of.
#[test]
fn known_ranges_hold_and_known_failures_are_still_seen() {
    let mut known = Known::all(KNOWN);
    known.retain(|l| l.kind != "with");
    let families: Vec<&str> = FAMILIES.iter().map(|f| f.key).collect();
    let mut wrong = Vec::new();
    let mut spoken_of = 0;
    for row in METHODS.iter().filter(|m| !m.control) {
        for entry in measure_with(row, &families, Effort::Ends) {
            let about =
                |l: &&Known<'_>| l.method == entry.method && l.family == entry.family && l.variant == entry.variant;
            let lines: Vec<&Known<'_>> = known.iter().filter(about).collect();
            spoken_of += lines.len();
            wrong.extend(wrongs(&entry, &lines));
        }
    }
    if spoken_of != known.len() {
        wrong.push(format!("{} of {} lines speak of an entry that there is not", known.len() - spoken_of, known.len()));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_known_must_be_said_and_must_hold() {
    let entry = only(&STEPS, "rotation", "");
    let wrong = |text: &str| {
        let known = Known::all(text);
        wrongs(&entry, &known.iter().collect::<Vec<_>>()).len()
    };
    assert_eq!(wrong(""), 1, "no line");
    assert_eq!(wrong("STEPS | rotation | | safe |"), 2, "a line that does not hold, and a failure not held");
    let both = "STEPS | rotation | | fails-above | 15\nSTEPS | rotation | | safe-up-to | 5";
    assert_eq!(wrong(both), 0, "{:?}", entry.samples);
    assert_eq!(wrong("STEPS | rotation | | fails-above | 15"), 1, "it is safe somewhere");
    assert_eq!(wrong("STEPS | rotation | | worst | 0.3..1"), 0, "{:?}", entry.samples);
    assert_eq!(wrong("STEPS | rotation | | worst | 0.0..0.3"), 1, "{:?}", entry.samples);
    assert_eq!(wrong("STEPS | rotation | | not-applicable | it has no grid"), 3);
    let not_applicable = only(&CONSTANT, "ringing", "per order: contrast");
    let excuse = |text: &str| wrongs(&not_applicable, &Known::all(text).iter().collect::<Vec<_>>()).len();
    assert_eq!(excuse("CONSTANT | ringing | per order: contrast | not-applicable | no order"), 0);
    assert_eq!(excuse("CONSTANT | ringing | per order: contrast | not-applicable |"), 1, "an excuse has a reason");
    assert_eq!(excuse("CONSTANT | ringing | per order: contrast | safe |"), 1, "nothing was measured");
}
