//! No more than a scene needs: the cheapest method and settings whose measured error stays within a limit, or the most
//! accurate ones within a time or a memory.
//!
//! 1. Climb: the cheapest rung of every method, then always the next rung of the method whose last one was cheapest, as
//!    long as that can still win. A ladder whose errors fall too slowly to reach the limit is left for later, and so is one
//!    whose next rung says that precomputing it takes longer than everything so far ([`crate::methods::Method::set_up`]).
//! 2. Explore: one parameter, one value beside anything that was tried, always the step that promises most for the time that
//!    its trial takes: the chance that it keeps the limit times the part of the cost that it would save; where no error is
//!    asked for, the chance that it errs less times how much. What it will give is told from what the same step did
//!    elsewhere, changes of pictures being added and times multiplied ([`Effect`]); where the step was never made, the chance
//!    is wide. Whatever a step gives is a place to step on from, so that parameters which are best between two worse values,
//!    or only together, are found.
//! 3. Confirm: the finalists on the whole picture, timed again; the error on more blocks of the picture, until it is clear
//!    on which side of the limit it lies.
//!
//! Cheap estimates come first: glances at a sample of the picture's blocks, and the truth traced on a few of them
//! ([`Evidence`]). Nothing here knows a method by name.

mod evidence;
mod live;
mod model;
mod page;
mod search;
#[cfg(test)]
mod search_tests;
mod sweep;
mod truth;
mod words;

pub use evidence::{Candidate, Effort, Evidence, Source};
pub use live::Live;
pub use model::Effect;
pub use page::page;
pub use sweep::{Case, LEAST_WITHIN, Left, Limits, MOST_COST, MOST_TIME, Open, Verdict, evaluate_scene};
pub use truth::BlockTruth;

use crate::error::Error;
use crate::methods::{MethodRow, Settings};
use search::Search;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::time::Instant;

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
    /// Where it was asked, if that was not with the chosen settings: the numbers are then estimates.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub estimated_at: Option<String>,
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

/// Settings that were asked for, and what they gave.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Tried {
    /// Method.
    pub method: String,
    /// Its settings that differ from its defaults, with its name.
    pub name: String,
    /// Block NRMSE.
    pub error: f64,
    /// Time of a frame with moving lights, and with still ones (ms).
    pub ms: [f64; 2],
    /// Once per geometry (ms).
    pub precompute_ms: f64,
    /// Memory of the method's buffers.
    pub memory_bytes: u64,
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct FitReport {
    /// Scene.
    pub scene: String,
    /// Options of `render` that give the view that was judged; empty where it is the scene's own.
    #[serde(default)]
    pub view: String,
    /// What was asked for.
    pub goal: Goal,
    /// Whether something fits.
    pub found: bool,
    /// Whether no indirect light is to be seen: the choice is then to compute none.
    #[serde(default)]
    pub dark: bool,
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
    /// Everything that was asked for.
    #[serde(default)]
    pub tried: Vec<Tried>,
    /// What estimates spared the search, and on what grounds.
    #[serde(default)]
    pub spared: Vec<String>,
    /// Sets of settings that were run.
    pub trials: usize,
    /// Seconds to the choice.
    pub search_s: f64,
    /// Seconds of the truths among them.
    pub truth_s: f64,
    /// Seconds to ask the choice's neighbours.
    pub why_s: f64,
    /// Seconds of precomputation that trials shared with others.
    #[serde(default)]
    pub shared_s: f64,
}

/// A method's name and those of its settings that differ from its defaults.
pub fn changed_settings(method: &str, settings: &Settings) -> String {
    let defaults = crate::methods::method(method).map(MethodRow::defaults).unwrap_or_default();
    let changed = settings.iter().filter(|(k, v)| defaults.get(*k) != Some(*v));
    let changed: Vec<String> = changed.map(|(k, v)| format!("{k}={v}")).collect();
    format!("{method} {}", changed.join(" ")).trim().to_string()
}

/// How much a search takes upon itself.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Care {
    /// Asks the neighbours of every parameter's chosen value.
    pub explain: bool,
    /// Goes on as long as there is something to try, instead of a small part of the time that a sweep would take.
    pub thorough: bool,
}

/// What is said of every method where there is nothing to compute.
pub const NOTHING_NEEDED: &str = "no indirect light reaches what the camera sees: nothing needs to be computed";

/// Finds the settings for a goal.
///
/// # Errors
/// What the truth says. A method that refuses is left out with its reason.
pub fn fit<S: Source>(
    evidence: &mut Evidence<S>,
    scene: &str,
    methods: &[&'static MethodRow],
    goal: Goal,
    care: Care,
    news: &mut dyn FnMut(&Candidate),
) -> Result<FitReport, Error> {
    let start = Instant::now();
    let (trials, truth_s, shared_s) = (evidence.trials, evidence.truth_s, evidence.shared_s);
    let dark = evidence.is_dark()?;
    let mut search = Search::new(evidence, goal, care.thorough, methods, news);
    let mut chosen = if dark {
        search.reject_all(NOTHING_NEEDED);
        Some(nothing_needed(search.evidence)?)
    } else {
        search.find()?
    };
    let search_s = start.elapsed().as_secs_f64();
    let found = chosen.is_some();
    if chosen.is_none() {
        chosen = search.closest();
    }
    let choice = chosen;
    // Why a value and not its neighbour is worth no trial where none of them is good enough.
    let why = match (&choice, care.explain && found) {
        (Some(c), true) => search.why(c),
        _ => Vec::new(),
    };
    let rejected = search.rejections(choice.as_ref());
    Ok(FitReport {
        scene: scene.into(),
        view: String::new(),
        goal,
        found,
        dark,
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
        tried: search.tried().iter().map(Tried::from).collect(),
        spared: std::mem::take(&mut search.spared),
        trials: search.spent().0 - trials,
        search_s,
        truth_s: search.spent().1 - truth_s,
        why_s: start.elapsed().as_secs_f64() - search_s,
        shared_s: search.shared_s() - shared_s,
    })
}

/// Where no indirect light is to be seen: the method that computes none, exact at no cost.
fn nothing_needed<S: Source>(evidence: &mut Evidence<S>) -> Result<Candidate, Error> {
    let row = &crate::methods::direct::ROW;
    let mut candidate = evidence.execute(row, &row.defaults(), Effort::Whole)?;
    // A black truth has no scale to state an error by.
    (candidate.error, candidate.bounds, candidate.blocks) = (0.0, [0.0; 2], candidate.means.len());
    Ok(candidate)
}

impl From<&Candidate> for Tried {
    fn from(c: &Candidate) -> Self {
        Self {
            method: c.row.into(),
            name: changed_settings(c.row, &c.settings),
            error: finite(c.error),
            ms: [c.dynamic_ms, c.frame_ms],
            precompute_ms: c.precompute_ms,
            memory_bytes: c.memory_bytes,
        }
    }
}

/// JSON has no infinity: a black truth has no relative error.
fn finite(value: f64) -> f64 {
    if value.is_finite() { value } else { f64::MAX }
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
