//! How good the search is: its choice beside the best that an exhaustive sweep of the same settings finds.
//!
//! The sweep runs every rung of every method, and around each rung every parameter's neighbouring values, each for the whole
//! picture, every phase up to three times after a warm-up until it has taken 150 ms, and judges them by the
//! truth of the whole picture, whose time counts. Trials share precomputation in both where settings allow it; what that
//! spared the sweep is reported, so that its time without sharing can be told. The search runs from nothing once per target,
//! with a cache of its own: loading the scene, tracing its truths, its trials and its confirmation count. Scene and executor
//! are loaded once in both.
//!
//! A sweep may have a time limit: it goes rung by rung through all methods, so that what a limit cuts off is what takes
//! longest. How much that is stands in every case; the search is then held to less time than the whole sweep would take.

use super::{Candidate, Care, Effort, Evidence, Goal, Live, axes, changed_settings, fit, step};
use crate::chart::trial::SceneSpec;
use crate::chart::{Judge, TruthPlan};
use crate::error::Error;
use crate::exec::Executor;
use crate::methods::{MethodRow, Settings};
use crate::reference::ReferenceSettings;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::time::Instant;

/// Largest ratio of the choice's cost to the sweep's best.
pub const MOST_COST: f64 = 1.3;
/// Largest ratio of the search's time to the sweep's.
pub const MOST_TIME: f64 = 0.2;
/// Least share of choices that keep the limit.
pub const LEAST_WITHIN: f64 = 0.9;

/// [`targets`] as parts of the sweep's settings that are better: wherever they lie, the sweep reaches them.
const QUANTILES: [f64; 5] = [0.1, 0.25, 0.4, 0.6, 0.75];
/// Errors from which on a target asks for nothing: without any indirect light it is about this.
const NO_LIGHT: f64 = 1.0;
/// What is asked for over the error at such a part.
const SLACK: f64 = 1.02;

/// One target on one scene.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Case {
    /// Scene.
    pub scene: String,
    /// Largest error asked for.
    pub target: f64,
    /// Method and settings of the choice, changed ones only.
    pub choice: String,
    /// The choice's error against the whole picture's truth; absent where the search found nothing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// Whether it keeps the limit.
    pub within: bool,
    /// The sweep's best for this target.
    pub best: String,
    /// Cost of the choice over that of the best, both timed in turn.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cost_ratio: Option<f64>,
    /// Seconds of the search.
    pub fit_s: f64,
    /// Seconds of the sweep, truth included.
    pub sweep_s: f64,
    /// Seconds that the sweep would take beyond that if no trial shared its precomputation.
    #[serde(default)]
    pub sweep_shared_s: f64,
    /// Sets of settings that the search ran.
    pub fit_trials: usize,
    /// Sets of settings that the sweep ran.
    pub sweep_trials: usize,
    /// Sets of settings that the sweep had no time for.
    #[serde(default)]
    pub sweep_left: usize,
}

/// A scene without cases.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Left {
    /// Scene.
    pub scene: String,
    /// Why.
    pub reason: String,
}

/// What bounds an evaluation.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Limits {
    /// Longest frame and precomputation of what the sweep takes for an answer.
    pub goal: Goal,
    /// Seconds of the sweep's trials.
    pub sweep_s: Option<f64>,
    /// Seconds of its truth.
    pub truth_s: Option<f64>,
}

impl std::fmt::Display for Case {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let number = |v: Option<f64>| v.map_or_else(|| "-".into(), |v| format!("{v:.3}"));
        let left = if self.sweep_left > 0 { format!(", {} sets not swept", self.sweep_left) } else { String::new() };
        write!(
            f,
            "{} error <= {:.3}: {} with {} {}, cost x {} of {}, time x {:.3} ({:.1} s, {} trials{left})",
            self.scene,
            self.target,
            self.choice,
            number(self.error),
            if self.within { "within" } else { "OVER" },
            number(self.cost_ratio),
            self.best,
            self.fit_s / self.sweep_s.max(1e-9),
            self.fit_s,
            self.fit_trials
        )
    }
}

/// All cases together.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Verdict {
    /// Cases.
    pub cases: Vec<Case>,
    /// Scenes without cases.
    #[serde(default)]
    pub left_out: Vec<Left>,
    /// Share of cases within the limit.
    pub within: f64,
    /// Share of cases whose cost is at most [`MOST_COST`] of the best.
    pub cheap: f64,
    /// Share of cases in at most [`MOST_TIME`] of the sweep's time.
    pub quick: f64,
    /// Whether all three hold: the first in [`LEAST_WITHIN`] of the cases, the others in as many.
    pub passed: bool,
}

impl Verdict {
    /// Adds cases up. Scenes that were left out count for nothing.
    pub fn of(cases: Vec<Case>, left_out: Vec<Left>) -> Self {
        let share =
            |f: &dyn Fn(&Case) -> bool| cases.iter().filter(|c| f(c)).count() as f64 / cases.len().max(1) as f64;
        let within = share(&|c| c.within);
        let cheap = share(&|c| c.cost_ratio.is_some_and(|r| r <= MOST_COST));
        let quick = share(&|c| c.fit_s <= MOST_TIME * c.sweep_s);
        let passed = !cases.is_empty() && [within, cheap, quick].iter().all(|s| *s >= LEAST_WITHIN);
        Self { within, cheap, quick, passed, cases, left_out }
    }
}

/// Opens an executor.
pub type Open<'a> = dyn Fn() -> Result<Box<dyn Executor>, Error> + 'a;

/// A set of settings of the sweep.
struct Swept {
    row: &'static MethodRow,
    settings: Settings,
    error: f64,
    cost: f64,
}

/// Sweeps a scene within the time limits of `limits`, and searches it once for each target error, within the same. No cases
/// where no indirect light is to be seen, or nothing is better than none.
///
/// # Errors
/// What loading and path tracing say.
pub fn evaluate_scene(
    spec: &SceneSpec,
    size: [u32; 2],
    truth: ReferenceSettings,
    limits: Limits,
    folder: &Path,
    open: &Open<'_>,
    methods: &[&'static MethodRow],
    news: &mut dyn FnMut(&str),
) -> Result<Vec<Case>, Error> {
    let plan = TruthPlan {
        settings: truth,
        limit_s: limits.truth_s,
        cache: folder.to_path_buf(),
        notes: folder.to_path_buf(),
    };
    let judge = Judge::new(spec, size, &plan, &mut |_| {})?;
    if judge.mean.max_element() <= 0.0 {
        return Ok(Vec::new());
    }
    let mut evidence = Evidence::new(Live::new(spec, size, truth.seed, folder.to_path_buf(), open()?)?);
    let start = Instant::now();
    let (swept, sweep_left) = sweep(&mut evidence, &judge, methods, limits)?;
    // The truth of a later run comes from the cache; its time is what it took to trace.
    let sweep_s = start.elapsed().as_secs_f64() + judge.about.ms / 1e3;
    let shared_s = evidence.shared_s;
    news(&format!(
        "{}: {} sets of settings swept in {sweep_s:.1} s ({:.1} s if none shared its precomputation), {sweep_left} not for want \
         of time; noise of the truth's blocks {:.3}",
        spec.scene,
        swept.len(),
        sweep_s + shared_s,
        judge.about.noise_floor.map_or(0.0, |f| f.nrmse_block)
    ));
    let mut cases = Vec::new();
    for target in targets(&swept, judge.about.noise_floor.map_or(0.0, |f| f.nrmse_block)) {
        let goal = Goal { error: Some(target), ..limits.goal };
        let mut case =
            one(spec, size, goal, &swept, &judge, &mut evidence, [sweep_s, shared_s], (open, methods, truth.seed))?;
        case.sweep_left = sweep_left;
        news(&format!("  {case}"));
        cases.push(case);
    }
    Ok(cases)
}

/// Errors that the search is asked for, the smallest first: none below the truth's own noise, where luck decides which settings
/// keep a limit.
fn targets(swept: &[Swept], noise: f64) -> Vec<f64> {
    let mut errors: Vec<f64> = swept.iter().map(|s| s.error).filter(|e| *e < NO_LIGHT).collect();
    errors.sort_by(f64::total_cmp);
    let at = |q: &f64| errors.get((q * errors.len() as f64) as usize);
    let mut targets: Vec<f64> = QUANTILES.iter().filter_map(at).map(|e| (SLACK * e).max(noise)).collect();
    targets.dedup();
    targets
}

/// A rung's settings and its neighbours'.
struct Rung {
    row: &'static MethodRow,
    /// Place in the ladder.
    place: usize,
    /// The rung's own first.
    sets: Vec<Settings>,
}

/// Every rung of every method, and every neighbour of every rung, each set once; only cheaper neighbours of a ladder's last.
/// The first rungs of all methods, then the second ones.
fn rungs(methods: &[&'static MethodRow]) -> Result<Vec<Rung>, Error> {
    let mut rungs: Vec<Rung> = Vec::new();
    for row in methods {
        for (place, (_, changes)) in row.ladder.iter().enumerate() {
            let own = row.with(changes.iter().copied())?;
            let directions: &[isize] = if place + 1 < row.ladder.len() { &[-1, 1] } else { &[-1] };
            let axes = axes(row, &own);
            let beside = axes.iter().flat_map(|axis| directions.iter().filter_map(|d| step(&own, axis, *d)));
            let mut sets: Vec<Settings> = Vec::new();
            for set in std::iter::once(own.clone()).chain(beside) {
                let known = rungs.iter().filter(|r| r.row.name == row.name).flat_map(|r| &r.sets).chain(&sets);
                // A rung is asked for itself, whoever's neighbour it is: by it the ladder is seen to be too slow.
                if sets.is_empty() || !known.into_iter().any(|s| *s == set) {
                    sets.push(set);
                }
            }
            rungs.push(Rung { row, place, sets });
        }
    }
    rungs.sort_by_key(|r| r.place);
    Ok(rungs)
}

/// Runs all [`rungs`], but none of a method after one whose frames or precomputation are longer than the limit. What kept the
/// limits, and how many sets there was no time for.
fn sweep(
    evidence: &mut Evidence,
    judge: &Judge,
    methods: &[&'static MethodRow],
    limits: Limits,
) -> Result<(Vec<Swept>, usize), Error> {
    let start = Instant::now();
    let mut swept: Vec<Swept> = Vec::new();
    let (mut too_slow, mut left): (Vec<&str>, usize) = (Vec::new(), 0);
    for Rung { row, sets, .. } in rungs(methods)? {
        for (n, settings) in sets.into_iter().enumerate() {
            let known = swept.iter().any(|s| s.row.name == row.name && s.settings == settings);
            if known || too_slow.contains(&row.name) {
                continue;
            }
            if limits.sweep_s.is_some_and(|most| start.elapsed().as_secs_f64() > most) {
                left += 1;
                continue;
            }
            // What a method refuses is no answer.
            let Ok(candidate) = evidence.execute(row, &settings, Effort::Whole) else { continue };
            if !limits.goal.affords(&candidate) {
                too_slow.extend((n == 0).then_some(row.name));
            } else if let Some(error) = full_error(evidence, judge, &candidate)? {
                swept.push(Swept { row, settings, error, cost: candidate.dynamic_ms });
            }
        }
    }
    Ok((swept, left))
}

/// Block NRMSE over the whole picture, without what the truth's noise adds.
fn full_error(evidence: &Evidence, judge: &Judge, candidate: &Candidate) -> Result<Option<f64>, Error> {
    let floor = judge.about.noise_floor.map_or(0.0, |f| f.nrmse_block);
    let error = judge.error(&evidence.source.image(candidate))?;
    Ok(error.map(|e| (e.nrmse_block * e.nrmse_block - floor * floor).max(0.0).sqrt()))
}

fn one(
    spec: &SceneSpec,
    size: [u32; 2],
    goal: Goal,
    swept: &[Swept],
    judge: &Judge,
    evidence: &mut Evidence,
    [sweep_s, sweep_shared_s]: [f64; 2],
    (open, methods, seed): (&Open<'_>, &[&'static MethodRow], u32),
) -> Result<Case, Error> {
    let cache = tempfile::tempdir().map_err(|e| crate::image_io::ImageError::io("create", Path::new("cache"), e))?;
    let start = Instant::now();
    let mut fresh = Evidence::new(Live::new(spec, size, seed, cache.path().to_path_buf(), open()?)?);
    let target = goal.error.unwrap_or(f64::MAX);
    let report = fit(&mut fresh, &spec.scene, methods, goal, Care::default(), &mut |_| {})?;
    let fit_s = start.elapsed().as_secs_f64();
    drop(fresh);
    let best = swept.iter().filter(|s| s.error <= target).min_by(|a, b| a.cost.total_cmp(&b.cost));
    let mut case = Case {
        scene: spec.scene.clone(),
        target,
        choice: "nothing".into(),
        error: None,
        within: false,
        best: best.map_or_else(|| "nothing".into(), |b| changed_settings(b.row.name, &b.settings)),
        cost_ratio: None,
        fit_s,
        sweep_s,
        sweep_shared_s,
        fit_trials: report.trials,
        sweep_trials: swept.len(),
        sweep_left: 0,
    };
    let chosen = report.choice.filter(|_| report.found);
    let (Some(choice), Some(best)) = (chosen, best) else { return Ok(case) };
    let Some(row) = methods.iter().find(|m| m.name == choice.method).copied() else { return Ok(case) };
    let candidate = evidence.execute(row, &choice.settings, Effort::Whole)?;
    case.error = full_error(evidence, judge, &candidate)?;
    let same = row.name == best.row.name && choice.settings == best.settings;
    case.cost_ratio = Some(if same {
        1.0
    } else {
        let [own, other] = evidence.source.duel([(row, &choice.settings), (best.row, &best.settings)])?;
        own / other.max(1e-9)
    });
    case.choice = changed_settings(row.name, &choice.settings);
    case.within = case.error.is_some_and(|e| e <= target);
    Ok(case)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_reached_by_the_sweep_and_not_drowned_in_noise() {
        let row = crate::methods::method("ambient").unwrap();
        let swept = |error: f64| Swept { row, settings: row.defaults(), error, cost: 1.0 };
        let all: Vec<Swept> = (1..=20).map(|k| swept(0.05 * f64::from(k))).collect();
        let found = targets(&all, 0.2);
        // A tenth, a quarter and so on of the 19 that are better than no light at all; the first lies in the noise.
        let wanted = [0.2, 0.25, 0.4, 0.6, 0.75].map(|e: f64| if e > 0.2 { SLACK * e } else { e });
        assert!(found.len() == 5 && found.iter().zip(wanted).all(|(f, w)| (f - w).abs() < 1e-9), "{found:?}");
        assert_eq!(targets(&all, 2.0), [2.0]);
        assert!(targets(&[], 0.1).is_empty());
    }

    #[test]
    fn a_verdict_needs_all_three() {
        let good = Case {
            scene: "s".into(),
            target: 0.2,
            choice: "a".into(),
            error: Some(0.19),
            within: true,
            best: "b".into(),
            cost_ratio: Some(1.2),
            fit_s: 1.0,
            sweep_s: 10.0,
            sweep_shared_s: 1.0,
            fit_trials: 5,
            sweep_trials: 50,
            sweep_left: 0,
        };
        assert!(Verdict::of(vec![good.clone(); 10], vec![]).passed);
        for bad in [
            Case { within: false, ..good.clone() },
            Case { cost_ratio: Some(1.4), ..good.clone() },
            Case { cost_ratio: None, error: None, ..good.clone() },
            Case { fit_s: 3.0, ..good.clone() },
        ] {
            let one_in_ten = |n: usize| [vec![bad.clone(); n], vec![good.clone(); 10 - n]].concat();
            let passed = |n: usize| Verdict::of(one_in_ten(n), vec![]).passed;
            assert!(passed(1) && !passed(2));
        }
        assert!(!Verdict::of(vec![], vec![]).passed);
    }
}
