//! The search over made-up methods, whose errors, times and truths are formulas.

use super::{BlockTruth, Candidate, Care, Effort, Evidence, FitReport, Goal, Source, fit};
use crate::error::Error;
use crate::exec::{BufferId, Executor};
use crate::methods::{Input, Method, MethodError, MethodRow, SearchAxis, SetUp, Setting, Settings, StageClock};
use glam::DVec3;
use std::ops::Range;

/// Blocks of the made-up picture, the truth being 1 W/m² in each.
const BLOCKS: usize = 64;
/// Seconds that one sample of all blocks takes.
const SAMPLE_S: f64 = 1e-4;

/// What some settings give.
#[derive(Clone, Copy)]
struct Gives {
    error: f64,
    ms: f64,
    precompute_s: f64,
    /// Whether the method knows beforehand what precomputing takes.
    told: bool,
}

/// Runs formulas instead of methods, on a clock of its own.
struct Table {
    gives: fn(&str, &Settings) -> Option<Gives>,
    /// Variance (W²/m⁴) that each trace of a block's truth is said to have.
    variance: f64,
    clock_s: f64,
    asked: Vec<(String, Effort)>,
}

impl Table {
    fn new(gives: fn(&str, &Settings) -> Option<Gives>) -> Evidence<Self> {
        Evidence::new(Self { gives, variance: 0.0, clock_s: 0.0, asked: Vec::new() })
    }
}

impl Source for Table {
    fn blocks(&self) -> usize {
        BLOCKS
    }

    fn execute(&mut self, row: &'static MethodRow, settings: &Settings, effort: Effort) -> Result<Candidate, Error> {
        let Some(Gives { error, ms, precompute_s, .. }) = (self.gives)(row.name, settings) else {
            return Err(Error::Usage("does not like it".into()));
        };
        let changed = settings.iter().filter(|(k, v)| row.settings.iter().any(|s| s.key == *k && s.default != *v));
        let changed: Vec<String> = changed.map(|(k, v)| format!("{k}={v}")).collect();
        self.asked.push((format!("{} {}", row.name, changed.join(" ")).trim().into(), effort));
        let took_s = precompute_s + 4e-3 * ms;
        self.clock_s += took_s;
        Ok(Candidate {
            precompute_ms: 1e3 * precompute_s,
            dynamic_ms: ms,
            frame_ms: 0.5 * ms,
            memory_bytes: (1024.0 * ms) as u64,
            wall_s: took_s,
            took_s,
            means: vec![DVec3::splat(1.0 + error); BLOCKS],
            ..Candidate::unjudged(row.name, settings, effort)
        })
    }

    fn is_prepared(&mut self, _: &MethodRow, _: &Settings) -> bool {
        false
    }

    fn set_up(&mut self, row: &MethodRow, settings: &Settings) -> Option<SetUp> {
        let gives = (self.gives)(row.name, settings).filter(|g| g.told)?;
        Some(SetUp { whole_s: gives.precompute_s, left_s: gives.precompute_s })
    }

    fn traced(&mut self, blocks: Range<usize>, spp: u32, _: u32) -> Result<Vec<BlockTruth>, Error> {
        let (share, spp) = (blocks.len() as f64 / BLOCKS as f64, f64::from(spp));
        self.clock_s += share * spp * SAMPLE_S;
        let block = BlockTruth { mean: DVec3::ONE, variance: DVec3::splat(self.variance), count: 64.0 };
        Ok(vec![block; blocks.len()])
    }

    fn elapsed_s(&self) -> f64 {
        self.clock_s
    }
}

/// A method that only says what there is to search.
struct Axes(&'static [SearchAxis]);

impl Method for Axes {
    fn precompute(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Err(MethodError::NotPrecomputed { method: "made up" })
    }

    fn light_change(&mut self, _: &mut dyn Executor, _: &Input<'_>, _: &mut StageClock) -> Result<(), MethodError> {
        Err(MethodError::NotPrecomputed { method: "made up" })
    }

    fn frame(
        &mut self,
        _: &mut dyn Executor,
        _: &Input<'_>,
        _: BufferId,
        _: BufferId,
        _: &mut StageClock,
    ) -> Result<(), MethodError> {
        Err(MethodError::NotPrecomputed { method: "made up" })
    }

    fn search(&self) -> &'static [SearchAxis] {
        self.0
    }
}

const fn row(
    name: &'static str,
    settings: &'static [Setting],
    ladder: &'static [(&'static str, &'static [(&'static str, &'static str)])],
    new: fn(&Settings) -> Result<Box<dyn Method>, MethodError>,
) -> MethodRow {
    MethodRow { name, control: false, summary: "", good_when: "", fails_when: "", settings, ladder, new }
}

const fn setting(key: &'static str, default: &'static str) -> Setting {
    Setting { key, default, allowed: "", help: "" }
}

/// Cheap and rough.
static ROUGH: MethodRow = row(
    "rough",
    &[setting("size", "8"), setting("steps", "4"), setting("rays", "16")],
    &[
        ("8", &[("size", "8"), ("rays", "4")]),
        ("16", &[("size", "16"), ("rays", "4")]),
        ("32", &[("size", "32")]),
        ("64", &[("size", "64")]),
        ("128", &[("size", "128")]),
    ],
    |_| {
        Ok(Box::new(Axes(&[
            SearchAxis { key: "size", values: &["8", "16", "32", "64", "128"] },
            SearchAxis { key: "steps", values: &["1", "2", "4", "8"] },
            SearchAxis { key: "rays", values: &["4", "16", "64"] },
        ])))
    },
);

/// Slow and exact.
static EXACT: MethodRow = row(
    "exact",
    &[setting("rays", "4")],
    &[
        ("4", &[("rays", "4")]),
        ("16", &[("rays", "16")]),
        ("64", &[("rays", "64")]),
        ("256", &[("rays", "256")]),
        ("1024", &[("rays", "1024")]),
    ],
    |_| Ok(Box::new(Axes(&[SearchAxis { key: "rays", values: &["4", "16", "64", "256", "1024"] }]))),
);

fn number(settings: &Settings, key: &str) -> f64 {
    settings[key].parse().expect("a number")
}

/// The rough method's error falls with its size, two steps being better than one or four; the exact one's as one over the root
/// of its rays, which take long to prepare.
fn gives(row: &str, settings: &Settings) -> Option<Gives> {
    Some(if row == "rough" {
        let [size, steps, rays] = ["size", "steps", "rays"].map(|key| number(settings, key));
        let off = if steps == 2.0 { 0.0 } else { 0.15 };
        Gives {
            error: 0.05 + 2.0 / size + off + 0.2 / rays,
            ms: 0.02 * size * (steps + rays),
            precompute_s: 0.1,
            told: false,
        }
    } else {
        let rays = number(settings, "rays");
        Gives { error: 1.0 / rays.sqrt(), ms: 10.0 * rays, precompute_s: 0.01 * rays, told: false }
    })
}

/// What was asked for at a glance, in order.
fn glances(evidence: &Evidence<Table>) -> Vec<&str> {
    let glances = evidence.source.asked.iter().filter(|a| a.1 == Effort::Glance);
    glances.map(|a| a.0.as_str()).collect()
}

fn search(evidence: &mut Evidence<Table>, goal: Goal, thorough: bool) -> FitReport {
    let care = Care { explain: false, thorough };
    fit(evidence, "made up", &[&EXACT, &ROUGH], goal, care, &mut |_| {}).expect("nothing fails")
}

fn error(limit: f64) -> Goal {
    Goal { error: Some(limit), ..Goal::default() }
}

#[test]
fn ladders_are_climbed_by_cost_and_not_beyond_what_fits() {
    let mut evidence = Table::new(gives);
    let report = search(&mut evidence, error(0.35), false);
    assert!(report.found && report.error_bounds[1] <= 0.35);
    let glances = glances(&evidence);
    // The cheapest rung of each, then the next of the one that is cheaper.
    assert_eq!(glances[..3], ["exact", "rough rays=4", "rough rays=4 size=16"], "{glances:?}");
    // Its rungs cost more than what fits.
    assert!(!glances.iter().any(|g| ["exact rays=256", "exact rays=1024"].contains(g)), "{glances:?}");
}

#[test]
fn a_value_between_worse_ones_is_found() {
    for thorough in [false, true] {
        let mut evidence = Table::new(gives);
        let report = search(&mut evidence, error(0.3), thorough);
        let choice = report.choice.expect("a choice");
        assert_eq!(
            (choice.method.as_str(), choice.settings["steps"].as_str()),
            ("rough", "2"),
            "{:?}",
            glances(&evidence)
        );
        assert!(report.found && choice.error <= 0.3);
    }
}

/// The least that any set of settings gives of what `of` says, where that is something.
fn least(of: impl Fn(&Gives) -> Option<f64>) -> f64 {
    let mut least = f64::INFINITY;
    for size in ["8", "16", "32", "64", "128"] {
        for steps in ["1", "2", "4", "8"] {
            for rays in ["4", "16", "64"] {
                let set = [("size", size), ("steps", steps), ("rays", rays)].map(|(k, v)| (k.into(), v.into()));
                let gives = gives("rough", &Settings::from(set)).expect("it gives");
                least = of(&gives).map_or(least, |value| least.min(value));
            }
        }
    }
    least
}

/// The time of the cheapest set of settings that keeps an error.
fn cheapest(limit: f64) -> f64 {
    least(|gives| (gives.error <= limit).then_some(gives.ms))
}

#[test]
fn a_thorough_search_costs_little_more_than_the_best_of_all() {
    for limit in [0.45, 0.36, 0.3] {
        let mut evidence = Table::new(gives);
        let report = search(&mut evidence, error(limit), true);
        let ms = report.choice.expect("a choice").ms[0];
        assert!(report.found && ms <= super::MOST_COST * cheapest(limit), "{limit}: {ms} of {}", cheapest(limit));
    }
}

#[test]
fn where_nothing_fits_it_says_so_and_what_comes_closest() {
    let mut evidence = Table::new(gives);
    let report = search(&mut evidence, error(0.01), true);
    assert!(!report.found);
    let choice = report.choice.expect("what comes closest");
    // The last rung of the exact method.
    assert_eq!((choice.method.as_str(), choice.settings["rays"].as_str()), ("exact", "1024"));
}

#[test]
fn where_the_noise_leaves_everything_in_doubt_the_likeliest_is_taken() {
    // Errors just below the limit or far above it, and a truth whose noise is larger than what lies between.
    let gives = |row: &str, settings: &Settings| {
        let at_limit = row == "exact" && settings["rays"] == "16";
        let error = if at_limit { 0.09995 } else { 0.5 };
        Some(Gives { error, ms: 10.0, precompute_s: 0.1, told: false })
    };
    let mut evidence = Table::new(gives);
    evidence.source.variance = 1e-5;
    let report = search(&mut evidence, error(0.1), false);
    let choice = report.choice.expect("a choice");
    assert!(report.error_bounds[0] < 0.1 && report.error_bounds[1] > 0.1, "{:?}", report.error_bounds);
    assert!(report.found && choice.settings["rays"] == "16", "{choice:?}");
    // It looked at it as closely as it may.
    assert!(evidence.source.asked.contains(&("exact rays=16".into(), Effort::Whole)));
}

#[test]
fn a_time_limit_is_kept_and_the_error_the_least_within_it() {
    let mut evidence = Table::new(gives);
    let report = search(&mut evidence, Goal { ms: Some(50.0), ..Goal::default() }, true);
    let choice = report.choice.expect("a choice");
    assert!(report.found && choice.ms[0] <= 50.0, "{choice:?}");
    // The exact method's first rung, 40 ms, has an error of 0.5.
    assert!(choice.method == "rough" && choice.error < 0.25, "{choice:?}");
    // Both limits: nothing that is exact enough is as quick.
    let mut evidence = Table::new(gives);
    assert!(!search(&mut evidence, Goal { ms: Some(50.0), ..error(0.06) }, true).found);
}

#[test]
fn a_slow_method_does_not_keep_quick_ones_from_being_explored() {
    let slow = |row: &str, settings: &Settings| {
        let gives = gives(row, settings)?;
        Some(if row == "exact" { Gives { precompute_s: 20.0, ..gives } } else { gives })
    };
    let mut evidence = Table::new(slow);
    let report = search(&mut evidence, error(0.3), false);
    let ms = report.choice.expect("a choice").ms[0];
    assert!(report.found && ms <= super::MOST_COST * cheapest(0.3), "{ms} of {}", cheapest(0.3));
}

/// The exact method's precomputation takes 30 s on each rung; it says so if it is `told`.
fn slow(row: &str, settings: &Settings, told: bool) -> Option<Gives> {
    let gives = gives(row, settings)?;
    Some(if row == "exact" { Gives { precompute_s: 30.0, told, ..gives } } else { gives })
}

#[test]
fn what_says_that_it_takes_too_long_to_prepare_is_not_asked() {
    let goal = Goal { precompute_ms: Some(4000.0), ..error(0.3) };
    let mut evidence = Table::new(|row, settings| slow(row, settings, true));
    let report = search(&mut evidence, goal, true);
    assert!(report.found && !glances(&evidence).iter().any(|g| g.starts_with("exact")), "{:?}", glances(&evidence));
    let rejected = report.rejected.iter().find(|r| r.method == "exact").expect("a reason");
    assert!(rejected.reason.contains("30.0 s to precompute"), "{rejected:?}");
    // Who does not say is asked once.
    let mut evidence = Table::new(|row, settings| slow(row, settings, false));
    assert!(search(&mut evidence, goal, true).found);
    assert_eq!(glances(&evidence).iter().filter(|g| g.starts_with("exact")).count(), 1);
}

#[test]
fn what_says_that_it_takes_long_waits_for_the_others() {
    // Where they fit, there is no patience for it.
    let mut evidence = Table::new(|row, settings| slow(row, settings, true));
    let report = search(&mut evidence, error(0.3), true);
    let glances_of = |evidence: &Evidence<Table>| glances(evidence).into_iter().map(String::from).collect::<Vec<_>>();
    let order = glances_of(&evidence);
    assert!(report.found && order[0].starts_with("rough"), "{order:?}");
    // Where they do not, it has its turn.
    let mut evidence = Table::new(|row, settings| slow(row, settings, true));
    let report = search(&mut evidence, error(0.04), false);
    let (order, choice) = (glances_of(&evidence), report.choice.expect("a choice"));
    assert!(report.found && choice.method == "exact" && order[0].starts_with("rough"), "{order:?}");
}

#[test]
fn a_time_limit_is_explored_beside_the_ladders() {
    // Within 3 ms no rung but the first two: what is best there lies beside them.
    let best = |limit: f64| least(|gives| (gives.ms <= limit).then_some(gives.error));
    for limit in [3.0, 5.0, 8.0, 20.0] {
        for goal in [
            Goal { ms: Some(limit), ..Goal::default() },
            // Bytes are 1024 times the milliseconds here.
            Goal { memory_bytes: Some((1024.0 * limit) as u64), ..Goal::default() },
        ] {
            let mut evidence = Table::new(gives);
            let report = search(&mut evidence, goal, true);
            let choice = report.choice.expect("a choice");
            assert!(report.found && choice.ms[0] <= limit, "{choice:?}");
            let best = best(limit);
            assert!(choice.error <= 1.05 * best, "{goal:?}: {} of {best}, {:?}", choice.error, glances(&evidence));
        }
    }
}

#[test]
fn a_search_without_hope_ends_early() {
    // Everything comes near the limit and nothing keeps it, so that there is always a step left to try.
    let near = |row: &str, settings: &Settings| {
        let gives = gives(row, settings).filter(|_| row == "rough")?;
        Some(Gives { error: 0.101, ..gives })
    };
    let took = |thorough: bool| {
        let mut evidence = Table::new(near);
        let report = search(&mut evidence, error(0.1), thorough);
        assert!(!report.found && report.choice.is_some());
        (evidence.source.clock_s, evidence.source.asked.len(), report)
    };
    let ((short_s, few, report), (long_s, many, thorough)) = (took(false), took(true));
    assert!(short_s < 0.4 * long_s && 2 * few < many, "{short_s} s of {long_s} s, {few} trials of {many}");
    // It says that it gave up; one that does not has tried all there is.
    let said = |report: &FitReport| report.spared.iter().any(|s| s.starts_with("nothing fits so far"));
    assert!(said(&report) && !said(&thorough), "{:?} {:?}", report.spared, thorough.spared);
    assert_eq!(many, 5 * 4 * 3, "every set of the method that is not refused");
}

#[test]
fn what_a_method_refuses_is_asked_once_and_named() {
    let picky = |row: &str, settings: &Settings| gives(row, settings).filter(|_| row != "exact");
    let mut evidence = Table::new(picky);
    let report = search(&mut evidence, error(0.3), true);
    assert!(report.found);
    assert_eq!(report.rejected.len(), 1);
    assert!(report.rejected[0].reason.contains("does not like it"), "{:?}", report.rejected);
}
