//! Speed against accuracy: every method's ladder of settings on every scene, in one run on one machine, against one truth
//! per scene.
//!
//! Each rung runs in a process of its own ([`trial`]); [`Judge`] holds the truth. Nothing here knows a method by name.
//! Output: `chart.json`, `chart.csv`, `chart.svg` and `.png`, `memory.svg` and `.png`, `index.html`.

mod judge;
mod output;
mod page;
pub mod trial;

pub use judge::{Judge, PathTracing, TruthPlan};
pub use output::write;

use crate::error::Error;
use crate::image_io::Image;
use crate::methods::{MethodRow, Settings};
use crate::reference::{Progress, ReferenceSettings};
use crate::report::{self, MethodResult};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use trial::{End, Job, Outcome, Runner, SceneSpec, Status, Trial};

/// Share of a scene's time that its truth may take.
const TRUTH_SHARE: f64 = 0.4;
/// How much longer a rung is expected to take than the one below it, where only one is known.
const GROWTH: f64 = 3.0;

/// What a chart is made of.
#[derive(Clone)]
pub struct Options {
    /// Scenes with their views.
    pub scenes: Vec<SceneSpec>,
    /// Methods.
    pub methods: Vec<&'static MethodRow>,
    /// Size of the pictures.
    pub size: [u32; 2],
    /// Noise, samples, bounces, seed of the truth; the seed is the methods' too.
    pub truth: ReferenceSettings,
    /// Folder of truths.
    pub cache: PathBuf,
    /// `auto`, `cpu`, `gpu`.
    pub backend: String,
    /// Part of an adapter's name.
    pub adapter: Option<String>,
    /// Worker threads.
    pub threads: Option<u16>,
    /// Time for everything; what does not fit is left out and said.
    pub budget: Option<Duration>,
    /// Time for one rung.
    pub rung_limit: Duration,
    /// Counted runs of each phase.
    pub repeats: u32,
    /// Milliseconds after which a phase stops repeating.
    pub repeat_budget_ms: f64,
    /// Where rungs run.
    pub runner: Runner,
}

/// `chart.json`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct ChartReport {
    /// One per scene.
    pub scenes: Vec<SceneChart>,
    /// Where it ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub device: Option<report::Device>,
    /// The budget (min).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub budget_minutes: Option<f64>,
    /// What this run took (s).
    pub spent_s: f64,
    /// Version of this program.
    pub version: String,
}

/// One scene.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct SceneChart {
    /// Built-in name or path.
    pub scene: String,
    /// The camera.
    pub camera: report::Camera,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// How good the truth is.
    pub truth: report::Truth,
    /// What plain path tracing costs for an error.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path_tracing: Option<PathTracing>,
    /// Block NRMSE below which points are not ranked.
    pub rankable_above: f64,
    /// Every rung of every method, in the order of the methods' table.
    pub rows: Vec<Row>,
    /// What was simplified, dropped or made up when the scene was loaded.
    pub notes: Vec<String>,
}

/// One rung of one method.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Row {
    /// Method.
    pub method: String,
    /// Name of the set of parameters.
    pub rung: String,
    /// Number of the rung, from 0, cheapest first.
    pub rung_idx: usize,
    /// A yardstick rather than a candidate.
    pub control: bool,
    /// What became of it.
    pub status: Status,
    /// Why it was not measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// Every setting.
    pub settings: Settings,
    /// Error, times, memory.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub result: Option<MethodResult>,
    /// Largest resident memory of its process.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub peak_memory_bytes: Option<u64>,
    /// Time of path tracing for the same block NRMSE (ms).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path_tracing_ms: Option<f64>,
    /// Its error lies within the truth's noise: it is not ranked.
    pub under_noise: bool,
    /// On the Pareto front of time and error.
    pub pareto: bool,
    /// Measured by an earlier run in the same folder.
    pub earlier_run: bool,
}

impl SceneChart {
    /// Name for people: a file without its folder.
    pub fn short_name(&self) -> &str {
        std::path::Path::new(&self.scene).file_name().and_then(|n| n.to_str()).unwrap_or(&self.scene)
    }
}

impl Row {
    /// Method and rung.
    pub fn title(&self) -> String {
        format!("{} {}", self.method, self.rung)
    }

    /// Block NRMSE.
    pub fn error(&self) -> Option<f64> {
        Some(self.result.as_ref()?.error?.nrmse_block)
    }

    /// Time of a frame with moving lights (ms).
    pub fn dynamic_ms(&self) -> Option<f64> {
        Some(self.result.as_ref()?.time_ms.dynamic_frame())
    }
}

/// A scene's chart with the pictures behind its points.
pub struct Charted {
    /// Numbers.
    pub chart: SceneChart,
    /// The truth.
    pub judge: Judge,
    /// Indirect irradiance of each row that was measured.
    pub pictures: Vec<Option<Image>>,
}

/// What is done with the charts so far.
pub type Made<'a> = dyn FnMut(&ChartReport, &[Charted]) -> Result<(), Error> + 'a;

/// What is told while a chart is made.
pub enum News<'a> {
    /// A scene begins.
    Scene(&'a str),
    /// The truth is being traced.
    Truth(Progress),
    /// A rung is done.
    Row(&'a Row),
}

/// Makes the charts of all scenes; `made` is called after each, with all so far.
///
/// # Errors
/// Scenes that cannot be loaded, truths that cannot be traced, folders that cannot be written; what `made` returns. A
/// rung that fails is a row.
pub fn run(options: &Options, news: &mut dyn FnMut(News<'_>), made: &mut Made<'_>) -> Result<ChartReport, Error> {
    let start = Instant::now();
    let mut charted: Vec<Charted> = Vec::new();
    let mut device = None;
    loop {
        let report = ChartReport {
            scenes: charted.iter().map(|c| c.chart.clone()).collect(),
            device: device.clone(),
            budget_minutes: options.budget.map(|b| b.as_secs_f64() / 60.0),
            spent_s: start.elapsed().as_secs_f64(),
            version: report::version(),
        };
        if !charted.is_empty() {
            made(&report, &charted)?;
        }
        let Some(spec) = options.scenes.get(charted.len()) else { return Ok(report) };
        news(News::Scene(&spec.scene));
        let left = options.scenes.len() - charted.len();
        let share = options.budget.map(|b| b.saturating_sub(start.elapsed()) / left as u32);
        charted.push(one(options, spec, share, &mut device, news)?);
    }
}

/// The chart of one scene within a share of the budget.
fn one(
    options: &Options,
    spec: &SceneSpec,
    share: Option<Duration>,
    device: &mut Option<report::Device>,
    news: &mut dyn FnMut(News<'_>),
) -> Result<Charted, Error> {
    let start = Instant::now();
    let plan = TruthPlan {
        settings: options.truth,
        limit_s: share.map(|s| s.as_secs_f64() * TRUTH_SHARE),
        cache: options.cache.clone(),
        notes: options.runner.folder.clone(),
    };
    let judge = Judge::new(spec, options.size, &plan, &mut |p| news(News::Truth(p)))?;
    let mut rungs = all_rungs(&options.methods)?;
    // Every method's cheapest rung first, then every method's next: a short budget still compares all methods.
    rungs.sort_by_key(|r| r.rung_idx);
    let mut walls: Vec<(String, f64)> = Vec::new();
    let mut done: Vec<(Row, Option<Image>)> = Vec::new();
    for mut row in rungs {
        let left = share.map(|s| s.saturating_sub(start.elapsed()));
        let expected_s = expected(&walls, &row.method);
        let limit = left.map_or(options.rung_limit, |l| l.min(options.rung_limit));
        let job = options.job(spec, &judge, &row);
        let trial = match left {
            Some(left) if left.is_zero() || expected_s > left.as_secs_f64() => left_out(expected_s, left),
            _ => options.runner.run(&job, limit)?,
        };
        row.earlier_run = trial.earlier;
        if trial.wall_s > 0.0 {
            walls.push((row.method.clone(), trial.wall_s));
        }
        let picture = settle(&mut row, trial, &judge, device)?;
        news(News::Row(&row));
        done.push((row, picture));
    }
    let order = |row: &Row| options.methods.iter().position(|m| m.name == row.method);
    done.sort_by_key(|(row, _)| (order(row), row.rung_idx));
    let (mut rows, pictures): (Vec<Row>, Vec<Option<Image>>) = done.into_iter().unzip();
    mark_front(&mut rows);
    let chart = SceneChart {
        scene: spec.scene.clone(),
        camera: report::Camera::new(&judge.scene, &judge.camera),
        size: options.size,
        truth: judge.about,
        path_tracing: judge.path_tracing,
        rankable_above: judge.rankable_above(),
        rows,
        notes: judge.scene.notes.clone(),
    };
    Ok(Charted { chart, judge, pictures })
}

/// A rung that is not run, for want of time.
fn left_out(expected_s: f64, left: Duration) -> Trial {
    let left_s = left.as_secs_f64();
    let reason = match left.is_zero() {
        true => "the budget was spent".to_string(),
        false => format!("about {expected_s:.1} s were expected, and {left_s:.1} s of the budget were left"),
    };
    let end = End { status: Status::LeftOut, reason, limit_s: left_s };
    Trial { outcome: Outcome::Bad(end), wall_s: 0.0, earlier: false }
}

impl Options {
    fn job(&self, spec: &SceneSpec, judge: &Judge, row: &Row) -> Job {
        Job {
            scene: spec.clone(),
            scene_hash: judge.scene_hash.clone(),
            size: self.size,
            seed: self.truth.seed,
            method: row.method.clone(),
            settings: row.settings.clone(),
            backend: self.backend.clone(),
            adapter: self.adapter.clone(),
            threads: self.threads,
            // Only a control may know the truth.
            true_mean: row.control.then(|| judge.mean.to_array()),
            repeats: self.repeats,
            repeat_budget_ms: self.repeat_budget_ms,
            machine: machine(),
        }
    }
}

/// Processor and version of the program.
pub fn machine() -> String {
    use crate::exec::Executor;
    format!("{}; interreflect {}", crate::exec::CpuExecutor::new().device().cpu, report::version())
}

/// Every rung of every method, not yet run.
///
/// # Errors
/// A ladder with an unknown setting.
pub fn all_rungs(methods: &[&'static MethodRow]) -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    for method in methods {
        for (rung_idx, (rung, changes)) in method.ladder.iter().enumerate() {
            rows.push(Row {
                method: method.name.into(),
                rung: (*rung).into(),
                rung_idx,
                control: method.control,
                status: Status::LeftOut,
                reason: None,
                settings: method.with(changes.iter().copied())?,
                result: None,
                peak_memory_bytes: None,
                path_tracing_ms: None,
                under_noise: false,
                pareto: false,
                earlier_run: false,
            });
        }
    }
    Ok(rows)
}

/// Seconds that a method's next rung will take, going on as the last two went; 0 where nothing is known.
fn expected(walls: &[(String, f64)], method: &str) -> f64 {
    let mut last = walls.iter().rev().filter(|(m, _)| m == method).map(|(_, s)| *s);
    match (last.next(), last.next()) {
        (Some(b), Some(a)) => b * (b / a).clamp(1.0, 8.0),
        (Some(b), None) => b * GROWTH,
        _ => 0.0,
    }
}

/// Fills in what became of a row; gives its picture.
fn settle(
    row: &mut Row,
    trial: Trial,
    judge: &Judge,
    device: &mut Option<report::Device>,
) -> Result<Option<Image>, Error> {
    match trial.outcome {
        Outcome::Done { done, irradiance } => {
            let mut result = done.result;
            result.label = Some(row.rung.clone());
            result.error = judge.error(&irradiance)?;
            row.status = Status::Done;
            row.peak_memory_bytes = Some(done.peak_memory_bytes);
            device.get_or_insert(done.device);
            if let Some(error) = result.error {
                row.under_noise = error.nrmse_block <= judge.rankable_above();
                row.path_tracing_ms = judge.path_tracing.map(|p| p.ms_for(error.nrmse_block));
            }
            row.result = Some(result);
            Ok(Some(irradiance))
        }
        Outcome::Bad(end) => {
            row.status = end.status;
            row.reason = Some(end.reason);
            Ok(None)
        }
    }
}

/// Marks the rows that no other is both faster and closer to the truth than. Controls and unranked rows take no part.
fn mark_front(rows: &mut [Row]) {
    let mut order: Vec<(usize, f64, f64)> = rows
        .iter()
        .enumerate()
        .filter(|(_, r)| !r.control && !r.under_noise)
        .filter_map(|(k, r)| Some((k, r.dynamic_ms()?, r.error()?)))
        .collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.2.total_cmp(&b.2)));
    let mut best = f64::INFINITY;
    for (k, _, error) in order {
        if error < best {
            best = error;
            rows[k].pareto = true;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_next_rung_is_expected_to_go_on_as_the_last_two_went() {
        let walls: Vec<(String, f64)> = [("a", 1.0), ("b", 9.0), ("a", 2.0)].map(|(m, s)| (m.into(), s)).into();
        assert_eq!(expected(&walls, "a"), 4.0);
        assert_eq!(expected(&walls, "b"), 27.0);
        assert_eq!(expected(&walls, "c"), 0.0);
    }

    #[test]
    fn path_tracing_takes_four_times_as_long_for_half_the_error() {
        let p = PathTracing { ms_per_sample: 4.0, error_of_one_sample: 0.8 };
        assert!((p.ms_for(0.4) - 16.0).abs() < 1e-12 && (p.ms_for(0.2) - 64.0).abs() < 1e-12);
        assert!((p.error_at_one_ms() - 1.6).abs() < 1e-12);
    }

    #[test]
    fn every_candidate_has_a_ladder_of_five_rungs_with_names_of_their_own() {
        for method in crate::methods::METHODS.iter().filter(|m| !m.control) {
            let rows = all_rungs(&[method]).unwrap();
            assert!(rows.len() >= 5, "{}", method.name);
            let mut names: Vec<&str> = rows.iter().map(|r| r.rung.as_str()).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), rows.len(), "{}", method.name);
        }
    }
}
