//! No more than a scene needs: the cheapest method and settings whose measured error stays within a limit, or the most
//! accurate ones within a time or a memory.
//!
//! 1. Climb: the cheapest rung of every method, then always the next rung of the method whose last one was cheapest, as
//!    long as that can still win.
//! 2. Descend: from the best rung, one parameter at a time, to the next cheaper value while the limit holds (or to the
//!    next dearer one while the time allows and the error falls).
//! 3. Step: from every method's rungs that all but keep the limit and cost less than the best, each parameter's next dearer
//!    value; and descend from what is found, and from other methods' rungs that keep the limit and cost little more.
//! 4. Confirm: the winner's error on more blocks of the picture, until it is clear on which side of the limit it lies;
//!    where it is the wrong one, the next best takes its place.
//!
//! Cheap estimates come first: the truth is traced on a few blocks, and on more only where an answer is open
//! ([`Evidence`]). Nothing here knows a method by name.

mod evidence;
mod sweep;

pub use evidence::{Candidate, Evidence};
pub use sweep::{Case, LEAST_WITHIN, MOST_COST, MOST_TIME, Open, Verdict, evaluate_scene};

use crate::error::Error;
use crate::methods::{MethodRow, Settings};
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::time::Instant;

/// Error over the limit up to which a single dearer parameter may be enough.
const FAR_OFF: f64 = 2.5;
/// Rungs per method, of those that all but keep the limit, from which dearer parameters are tried.
const NEAR_MISSES: usize = 2;
/// Cost over the best's up to which another method's rung may still become cheaper than it, parameter by parameter.
const RIVAL: f64 = 2.0;
/// Overrun that a step must leave of the one before, where nothing fits yet.
const NEARER: f64 = 0.99;

/// What is asked for.
#[derive(Clone, Copy, PartialEq, Default, Debug, Serialize, Deserialize)]
pub struct Goal {
    /// Largest block NRMSE. Absent: as small as possible within the other limits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// Longest frame (ms).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ms: Option<f64>,
    /// Largest memory (bytes).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub memory_bytes: Option<u64>,
    /// Longest computation once per geometry (ms).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub precompute_ms: Option<f64>,
    /// Lights stand still: a frame costs no light change.
    #[serde(default)]
    pub still: bool,
}

impl Goal {
    /// Time of a frame under this goal (ms).
    pub fn cost(&self, c: &Candidate) -> f64 {
        if self.still { c.frame_ms } else { c.dynamic_ms }
    }

    /// Whether times and memory fit.
    fn affords(&self, c: &Candidate) -> bool {
        self.ms.is_none_or(|ms| self.cost(c) <= ms)
            && self.precompute_ms.is_none_or(|ms| c.precompute_ms <= ms)
            && self.memory_bytes.is_none_or(|bytes| c.memory_bytes <= bytes)
    }

    /// Whether the error fits: its upper bound, because an answer in doubt is no answer.
    fn accepts(&self, c: &Candidate) -> bool {
        self.error.is_none_or(|limit| c.bounds[1] <= limit)
    }

    /// How far a candidate is over the limit that it breaks most, as a ratio.
    fn overrun(&self, c: &Candidate) -> f64 {
        let error = self.error.map_or(0.0, |limit| c.bounds[1] / limit);
        let time = self.ms.map_or(0.0, |ms| self.cost(c) / ms);
        let memory = self.memory_bytes.map_or(0.0, |bytes| c.memory_bytes as f64 / bytes.max(1) as f64);
        let precompute = self.precompute_ms.map_or(0.0, |ms| c.precompute_ms / ms);
        error.max(time).max(memory).max(precompute)
    }

    /// Whether a is the better answer of two that fit.
    fn prefers(&self, a: &Candidate, b: &Candidate) -> bool {
        match self.error {
            Some(_) => self.cost(a) < self.cost(b),
            None => a.error < b.error,
        }
    }
}

/// An axis of the search: the method's own, or what occurs in its ladder.
#[derive(Clone, PartialEq, Debug)]
pub struct Axis {
    /// Key of the setting.
    pub key: String,
    /// Values from cheapest to dearest.
    pub values: Vec<String>,
}

/// The axes of a method, each with the current value among its values.
pub fn axes(row: &MethodRow, settings: &Settings) -> Vec<Axis> {
    let stated = (row.new)(settings).map(|m| m.search()).unwrap_or_default();
    let mut axes: Vec<Axis> = stated
        .iter()
        .map(|a| Axis { key: a.key.into(), values: a.values.iter().map(|v| (*v).to_string()).collect() })
        .collect();
    if axes.is_empty() {
        for (key, value) in row.ladder.iter().flat_map(|(_, changes)| changes.iter()) {
            match axes.iter_mut().find(|a| a.key == *key) {
                Some(axis) if axis.values.iter().any(|v| v == value) => {}
                Some(axis) => axis.values.push((*value).to_string()),
                None => axes.push(Axis { key: (*key).into(), values: vec![(*value).into()] }),
            }
        }
    }
    for axis in &mut axes {
        let Some(current) = settings.get(&axis.key) else { continue };
        if axis.values.iter().any(|v| same(v, current)) {
            continue;
        }
        // Among numbers it has its place; a word that no list knows stays what it is.
        let number = |v: &String| v.parse::<f64>().ok();
        if let (Some(x), Some(values)) = (number(current), axis.values.iter().map(number).collect::<Option<Vec<_>>>()) {
            let rising = values.first() <= values.last();
            let place = values.iter().position(|v| if rising { *v > x } else { *v < x }).unwrap_or(values.len());
            axis.values.insert(place, current.clone());
        }
    }
    axes.retain(|a| a.values.len() > 1 && settings.get(&a.key).is_some_and(|c| a.values.iter().any(|v| same(v, c))));
    axes
}

/// Whether two texts are the same value.
fn same(a: &str, b: &str) -> bool {
    a == b || matches!((a.parse::<f64>(), b.parse::<f64>()), (Ok(a), Ok(b)) if a == b)
}

/// What a neighbouring value of a parameter gave.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Neighbour {
    /// Value.
    pub value: String,
    /// Block NRMSE; absent where the method refused it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error: Option<f64>,
    /// Time of a frame (ms).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ms: Option<f64>,
}

/// Why a parameter has its value.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Reason {
    /// Parameter.
    pub key: String,
    /// Chosen value.
    pub value: String,
    /// The next cheaper value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub below: Option<Neighbour>,
    /// The next dearer value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub above: Option<Neighbour>,
    /// In words.
    pub words: String,
}

/// What became of a method that was not chosen.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Rejected {
    /// Method.
    pub method: String,
    /// Why.
    pub reason: String,
}

/// A settings file: what `render --settings` takes.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct SettingsFile {
    /// Method.
    pub method: String,
    /// Every setting.
    pub settings: Settings,
    /// Scene that it was fitted to.
    #[serde(default)]
    pub scene: String,
    /// What was asked for.
    #[serde(default)]
    pub goal: Goal,
    /// Block NRMSE.
    #[serde(default)]
    pub error: f64,
    /// Time of a frame with moving lights, and with still ones (ms).
    #[serde(default)]
    pub ms: [f64; 2],
    /// Memory of the method's buffers.
    #[serde(default)]
    pub memory_bytes: u64,
}

impl SettingsFile {
    /// Reads a settings file.
    ///
    /// # Errors
    /// [`Error::Usage`] with the path and what is wrong.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let wrong = |what: String| Error::Usage(format!("--settings {}: {what}", path.display()));
        let text = std::fs::read_to_string(path).map_err(|e| wrong(e.to_string()))?;
        serde_json::from_str(&text).map_err(|e| wrong(format!("not a settings file: {e}")))
    }
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct FitReport {
    /// Scene.
    pub scene: String,
    /// What was asked for.
    pub goal: Goal,
    /// Whether something fits.
    pub found: bool,
    /// The choice; what comes closest where nothing fits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub choice: Option<SettingsFile>,
    /// Lower and upper bound of the choice's error.
    pub error_bounds: [f64; 2],
    /// Blocks behind the error.
    pub blocks: usize,
    /// Every parameter.
    pub why: Vec<Reason>,
    /// Every other method.
    pub rejected: Vec<Rejected>,
    /// Sets of settings that were run.
    pub trials: usize,
    /// Seconds to the choice.
    pub search_s: f64,
    /// Seconds of the truths among them.
    pub truth_s: f64,
    /// Seconds to ask the choice's neighbours.
    pub why_s: f64,
}

/// What the search remembers.
struct Search<'a> {
    evidence: &'a mut Evidence,
    goal: Goal,
    tried: Vec<Candidate>,
    rejected: Vec<Rejected>,
}

/// Finds the settings for a goal.
///
/// # Errors
/// What the truth says. A method that refuses is left out with its reason.
pub fn fit(
    evidence: &mut Evidence,
    scene: &str,
    methods: &[&'static MethodRow],
    goal: Goal,
    explain: bool,
    news: &mut dyn FnMut(&Candidate),
) -> Result<FitReport, Error> {
    let start = Instant::now();
    let (trials, truth_s) = (evidence.trials, evidence.truth_s);
    let dark = evidence.is_dark()?;
    let mut search = Search { evidence, goal, tried: Vec::new(), rejected: Vec::new() };
    if dark {
        let reason = "no indirect light reaches what the camera sees: nothing needs to be computed";
        search.rejected = methods.iter().map(|m| Rejected { method: m.name.into(), reason: reason.into() }).collect();
    } else {
        search.climb(methods, news)?;
    }
    let mut chosen = search.confirmed()?;
    if chosen.is_none() && !dark {
        chosen = search.rescue(methods, news)?;
    }
    if let Some(best) = chosen.take() {
        chosen = Some(search.refine(best, methods, news)?);
    }
    let search_s = start.elapsed().as_secs_f64();
    let found = chosen.is_some();
    let choice = chosen.or_else(|| search.closest());
    let why = match (&choice, explain) {
        (Some(c), true) => search.why(c, methods)?,
        _ => Vec::new(),
    };
    let rejected = search.rejections(methods, choice.as_ref());
    Ok(FitReport {
        scene: scene.into(),
        goal,
        found,
        error_bounds: choice.as_ref().map_or([0.0; 2], |c| c.bounds.map(finite)),
        blocks: choice.as_ref().map_or(0, |c| c.blocks),
        choice: choice.map(|c| SettingsFile {
            method: c.row.into(),
            settings: c.settings,
            scene: scene.into(),
            goal,
            error: finite(c.error),
            ms: [c.dynamic_ms, c.frame_ms],
            memory_bytes: c.memory_bytes,
        }),
        why,
        rejected,
        trials: search.evidence.trials - trials,
        search_s,
        truth_s: search.evidence.truth_s - truth_s,
        why_s: start.elapsed().as_secs_f64() - search_s,
    })
}

/// JSON has no infinity: a black truth has no relative error.
fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { f64::MAX }
}

impl Search<'_> {
    /// Runs settings unless they were run; `None` where the method refuses, with the reason kept.
    fn run(&mut self, row: &'static MethodRow, settings: &Settings) -> Option<Candidate> {
        if let Some(known) = self.tried.iter().find(|c| c.row == row.name && c.settings == *settings) {
            return Some(known.clone());
        }
        let evidence = &mut *self.evidence;
        let caught = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| evidence.try_settings(row, settings)));
        match caught {
            Ok(Ok(candidate)) => {
                self.tried.push(candidate.clone());
                Some(candidate)
            }
            Ok(Err(error)) => {
                self.rejected.push(Rejected { method: row.name.into(), reason: error.to_string() });
                None
            }
            Err(_) => {
                self.rejected.push(Rejected { method: row.name.into(), reason: "it crashed".into() });
                None
            }
        }
    }

    /// All methods' ladders, cheapest first, as far as a rung can still win.
    fn climb(&mut self, methods: &[&'static MethodRow], news: &mut dyn FnMut(&Candidate)) -> Result<(), Error> {
        // Next rung of each method, and the cost of the last: rungs are ordered by cost.
        let mut open: Vec<(&'static MethodRow, usize, f64)> = methods.iter().map(|m| (*m, 0, 0.0)).collect();
        let mut best_cost = f64::INFINITY;
        loop {
            open.retain(|(row, rung, last)| {
                *rung < row.ladder.len() && *last < best_cost && self.goal.ms.is_none_or(|ms| *last <= ms)
            });
            let Some(next) = (0..open.len()).min_by(|a, b| open[*a].2.total_cmp(&open[*b].2)) else { return Ok(()) };
            let (row, rung, _) = open[next];
            let settings = row.with(row.ladder[rung].1.iter().copied())?;
            open[next].1 += 1;
            let Some(mut candidate) = self.run(row, &settings) else { continue };
            if let Some(limit) = self.goal.error {
                self.settle(&mut candidate, limit)?;
            }
            news(&candidate);
            open[next].2 = self.goal.cost(&candidate);
            if self.goal.precompute_ms.is_some_and(|ms| candidate.precompute_ms > ms) {
                // Its further rungs take longer to prepare.
                open.remove(next);
                continue;
            }
            let fits = self.goal.affords(&candidate) && self.goal.accepts(&candidate);
            if fits && self.goal.error.is_some() {
                best_cost = best_cost.min(self.goal.cost(&candidate));
                // Its further rungs cost more.
                open.retain(|(r, ..)| r.name != row.name);
            }
        }
    }

    fn settle(&mut self, candidate: &mut Candidate, limit: f64) -> Result<(), Error> {
        self.evidence.settle(candidate, limit)?;
        if let Some(known) = self.tried.iter_mut().find(|c| c.row == candidate.row && c.settings == candidate.settings)
        {
            *known = candidate.clone();
        }
        Ok(())
    }

    /// The best of all tried that fits, its error confirmed.
    fn confirmed(&mut self) -> Result<Option<Candidate>, Error> {
        loop {
            let fitting = self.tried.iter().filter(|c| self.goal.affords(c) && self.goal.accepts(c));
            let best = fitting.fold(None::<&Candidate>, |best, c| match best {
                Some(b) if !self.goal.prefers(c, b) => Some(b),
                _ => Some(c),
            });
            let (Some(best), Some(limit)) = (best.cloned(), self.goal.error) else {
                return Ok(self.best_within());
            };
            let mut settled = best;
            self.settle(&mut settled, limit)?;
            if self.goal.accepts(&settled) {
                return Ok(Some(settled));
            }
        }
    }

    /// The most accurate of all tried that the limits allow, where no error was asked for.
    fn best_within(&self) -> Option<Candidate> {
        if self.goal.error.is_some() {
            return None;
        }
        self.tried.iter().filter(|c| self.goal.affords(c)).min_by(|a, b| a.error.total_cmp(&b.error)).cloned()
    }

    /// Where no rung fits: from each method's nearest one beyond the ladder's ends, parameter by parameter, as long as that
    /// brings it nearer.
    fn rescue(
        &mut self,
        methods: &[&'static MethodRow],
        news: &mut dyn FnMut(&Candidate),
    ) -> Result<Option<Candidate>, Error> {
        for row in methods.iter().copied() {
            let own = self.tried.iter().filter(|c| c.row == row.name);
            let nearest = own.min_by(|a, b| self.goal.overrun(a).total_cmp(&self.goal.overrun(b))).cloned();
            let Some(mut best) = nearest else { continue };
            for axis in axes(row, &best.settings) {
                // Too slow or too large asks for less, too wrong for more.
                let direction = if self.goal.affords(&best) { 1 } else { -1 };
                while let Some(settings) = step(&best.settings, &axis, direction) {
                    let Some(mut next) = self.run(row, &settings) else { break };
                    if let Some(limit) = self.goal.error {
                        self.settle(&mut next, limit)?;
                    }
                    news(&next);
                    if self.goal.overrun(&next) > NEARER * self.goal.overrun(&best) {
                        break;
                    }
                    best = next;
                    if self.goal.affords(&best) && self.goal.accepts(&best) {
                        return Ok(Some(best));
                    }
                }
            }
        }
        Ok(None)
    }

    /// Where nothing fits: the smallest error of all that time and memory allow, or of all.
    fn closest(&self) -> Option<Candidate> {
        let least = |all: &mut dyn Iterator<Item = &Candidate>| all.min_by(|a, b| a.error.total_cmp(&b.error)).cloned();
        least(&mut self.tried.iter().filter(|c| self.goal.affords(c))).or_else(|| least(&mut self.tried.iter()))
    }

    /// Something cheaper than the best rung: beside it, beside what all but fits, beside what fits and costs little more.
    fn refine(
        &mut self,
        best: Candidate,
        methods: &[&'static MethodRow],
        news: &mut dyn FnMut(&Candidate),
    ) -> Result<Candidate, Error> {
        let mut best = self.descend(best, methods, news)?;
        if self.goal.error.is_none() {
            return Ok(best);
        }
        for row in methods.iter().copied() {
            let cost = self.goal.cost(&best);
            let rival = self.tried.iter().filter(|c| c.row == row.name && c.row != best.row);
            let rival =
                rival.filter(|c| self.goal.accepts(c) && self.goal.affords(c) && self.goal.cost(c) < RIVAL * cost);
            let rival = rival.min_by(|a, b| self.goal.cost(a).total_cmp(&self.goal.cost(b))).cloned();
            let between = self.between_rungs(row, cost, news)?;
            for start in rival.into_iter().chain(between) {
                let found = self.descend(start, methods, news)?;
                if self.goal.prefers(&found, &best) {
                    best = found;
                }
            }
        }
        Ok(best)
    }

    /// What all but keeps the limit and costs less than `bar` (ms) may need one dearer parameter only, which is cheaper than
    /// the whole next rung: the cheapest that is found.
    fn between_rungs(
        &mut self,
        row: &'static MethodRow,
        bar: f64,
        news: &mut dyn FnMut(&Candidate),
    ) -> Result<Option<Candidate>, Error> {
        let Some(limit) = self.goal.error else { return Ok(None) };
        let missed = self.tried.iter().filter(|c| c.row == row.name && !self.goal.accepts(c) && self.goal.affords(c));
        // Something far off, or hardly cheaper, is not a step away.
        let near = missed.filter(|c| c.error <= FAR_OFF * limit && self.goal.cost(c) <= 0.8 * bar);
        let mut near: Vec<Candidate> = near.cloned().collect();
        near.sort_by(|a, b| a.error.total_cmp(&b.error));
        let mut best: Option<Candidate> = None;
        for below in near.into_iter().take(NEAR_MISSES) {
            for axis in axes(row, &below.settings) {
                let Some(settings) = step(&below.settings, &axis, 1) else { continue };
                let Some(mut next) = self.run(row, &settings) else { continue };
                if self.goal.cost(&next) >= best.as_ref().map_or(bar, |b| self.goal.cost(b)) {
                    continue;
                }
                self.settle(&mut next, limit)?;
                news(&next);
                if self.goal.accepts(&next) && self.goal.affords(&next) {
                    best = Some(next);
                }
            }
        }
        Ok(best)
    }

    /// One parameter at a time, down while the limit holds, or up while the time allows and the error falls.
    fn descend(
        &mut self,
        mut best: Candidate,
        methods: &[&'static MethodRow],
        news: &mut dyn FnMut(&Candidate),
    ) -> Result<Candidate, Error> {
        let Some(row) = methods.iter().find(|m| m.name == best.row).copied() else { return Ok(best) };
        let direction: isize = if self.goal.error.is_some() { -1 } else { 1 };
        let mut changed = true;
        let mut rounds = 0;
        // Parameters that cost nothing in a frame, such as those of the precomputation.
        let mut idle: Vec<String> = Vec::new();
        // A second round, because a parameter that was needed may not be once another is lower.
        while changed && rounds < 2 {
            changed = false;
            rounds += 1;
            for axis in axes(row, &best.settings) {
                while let Some(settings) = step(&best.settings, &axis, direction) {
                    if idle.contains(&axis.key) {
                        break;
                    }
                    let Some(mut next) = self.run(row, &settings) else { break };
                    // What saves less than the clock's noise is not worth an error.
                    let saves = self.goal.cost(&next) < 0.97 * self.goal.cost(&best);
                    if let Some(limit) = self.goal.error.filter(|_| saves) {
                        self.settle(&mut next, limit)?;
                    }
                    news(&next);
                    let gain = match self.goal.error {
                        Some(_) => saves,
                        None => next.error < 0.99 * best.error,
                    };
                    if !gain {
                        idle.push(axis.key.clone());
                    }
                    if !(gain && self.goal.affords(&next) && self.goal.accepts(&next)) {
                        break;
                    }
                    best = next;
                    changed = true;
                }
            }
        }
        Ok(best)
    }

    /// The neighbours of every parameter's chosen value.
    fn why(&mut self, chosen: &Candidate, methods: &[&'static MethodRow]) -> Result<Vec<Reason>, Error> {
        let Some(row) = methods.iter().find(|m| m.name == chosen.row).copied() else { return Ok(Vec::new()) };
        let mut reasons = Vec::new();
        for axis in axes(row, &chosen.settings) {
            let mut neighbour = |direction| {
                let settings = step(&chosen.settings, &axis, direction)?;
                let ran = self.run(row, &settings);
                Some(Neighbour {
                    value: settings[&axis.key].clone(),
                    error: ran.as_ref().map(|c| finite(c.error)),
                    ms: ran.as_ref().map(|c| self.goal.cost(c)),
                })
            };
            let (below, above) = (neighbour(-1), neighbour(1));
            let value = chosen.settings[&axis.key].clone();
            let words = explain(&axis.key, &value, chosen, &below, &above, &self.goal);
            reasons.push(Reason { key: axis.key, value, below, above, words });
        }
        Ok(reasons)
    }

    /// Why the other methods were not chosen.
    fn rejections(&self, methods: &[&'static MethodRow], chosen: Option<&Candidate>) -> Vec<Rejected> {
        let mut all = Vec::new();
        for row in methods.iter().filter(|m| chosen.is_none_or(|c| c.row != m.name)) {
            let best = self.tried.iter().filter(|c| c.row == row.name).min_by(|a, b| a.error.total_cmp(&b.error));
            let refused = self.rejected.iter().rev().find(|r| r.method == row.name);
            let fits = self
                .tried
                .iter()
                .filter(|c| c.row == row.name && self.goal.accepts(c) && self.goal.affords(c))
                .min_by(|a, b| self.goal.cost(a).total_cmp(&self.goal.cost(b)));
            let reason = match (fits, best, refused) {
                (Some(c), _, _) => format!("error {:.3} in {:.1} ms fits, but costs more", c.error, self.goal.cost(c)),
                (None, Some(c), _) => format!(
                    "its best so far has an error of {:.3} in {:.1} ms, and better rungs would cost more than the choice or \
                     the limit",
                    c.error,
                    self.goal.cost(c)
                ),
                (None, None, Some(r)) => r.reason.clone(),
                (None, None, None) => "even its cheapest rung costs more".into(),
            };
            all.push(Rejected { method: row.name.into(), reason });
        }
        all
    }
}

/// The settings with the next value of an axis.
fn step(settings: &Settings, axis: &Axis, direction: isize) -> Option<Settings> {
    let current = settings.get(&axis.key)?;
    let at = axis.values.iter().position(|v| same(v, current))?;
    let next = axis.values.get(at.checked_add_signed(direction)?)?;
    let mut changed = settings.clone();
    changed.insert(axis.key.clone(), next.clone());
    Some(changed)
}

/// `resolution 64: at 48 the error is 0.231, over the limit; 96 would change it by 4.0 %: not needed`.
fn explain(
    key: &str,
    value: &str,
    chosen: &Candidate,
    below: &Option<Neighbour>,
    above: &Option<Neighbour>,
    goal: &Goal,
) -> String {
    let mut parts = Vec::new();
    if let Some(n) = below {
        parts.push(match (n.error, n.ms) {
            (Some(e), _) if goal.error.is_some_and(|limit| e > limit) => {
                format!("at {} the error is {e:.3}, over the limit", n.value)
            }
            (Some(e), Some(ms)) if ms >= 0.97 * goal.cost(chosen) => {
                format!("at {} the error is {e:.3} and the time {ms:.1} ms: nothing saved", n.value)
            }
            (Some(e), Some(ms)) => format!("at {} the error is {e:.3} in {ms:.1} ms", n.value),
            _ => format!("{} is refused", n.value),
        });
    } else {
        parts.push("there is no cheaper value".into());
    }
    if let Some(n) = above {
        parts.push(match (n.error, n.ms) {
            (Some(e), Some(ms)) => {
                let change = 100.0 * (e / chosen.error - 1.0);
                let verdict = match goal.error {
                    Some(_) => "not needed",
                    None if goal.ms.is_some_and(|limit| ms > limit) => "too slow",
                    None if e < chosen.error => "better, but not by enough",
                    None => "no better",
                };
                format!("{} changes the error by {change:+.1} % in {ms:.1} ms: {verdict}", n.value)
            }
            _ => format!("{} is refused", n.value),
        });
    }
    format!("{key} {value}: {}", parts.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::methods::METHODS;

    #[test]
    fn every_method_has_axes_whose_every_value_it_takes() {
        for row in METHODS.iter().filter(|m| !m.control) {
            for (rung, changes) in row.ladder {
                let settings = row.with(changes.iter().copied()).unwrap();
                let axes = axes(row, &settings);
                assert!(!axes.is_empty(), "{}", row.name);
                for axis in axes {
                    assert!(
                        axis.values.iter().any(|v| same(v, &settings[&axis.key])),
                        "{} {rung} {}",
                        row.name,
                        axis.key
                    );
                    for value in &axis.values {
                        let changed = row.with(changes.iter().copied().chain([(axis.key.as_str(), value.as_str())]));
                        (row.new)(&changed.unwrap())
                            .unwrap_or_else(|e| panic!("{} {}={value}: {e}", row.name, axis.key));
                    }
                }
            }
        }
    }

    #[test]
    fn steps_go_to_the_neighbouring_value_and_end_at_the_ends() {
        let axis = Axis { key: "n".into(), values: vec!["1".into(), "2".into(), "4".into()] };
        let at = |v: &str| Settings::from([("n".to_string(), v.to_string())]);
        assert_eq!(step(&at("2.0"), &axis, -1).unwrap()["n"], "1");
        assert_eq!(step(&at("2"), &axis, 1).unwrap()["n"], "4");
        assert!(step(&at("1"), &axis, -1).is_none() && step(&at("4"), &axis, 1).is_none());
        assert!(step(&at("3"), &axis, 1).is_none());
    }
}
