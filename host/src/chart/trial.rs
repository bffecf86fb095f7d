//! One method with one set of settings on one view, run in a process of its own: a crash, an endless loop or a memory
//! that runs out ends the trial and nothing else, and the peak memory is the trial's alone.
//!
//! A trial is a folder: `job.json` (what to do), `irradiance.exr` and `result.json` (what came of it; `result.json` is
//! written last), `end.json` (how it ended where it did not end well), `log.txt`. A job whose folder is there is not run
//! again: that is what makes charts resumable.

use crate::error::Error;
use crate::evaluate::{self, Repeats, View};
use crate::exec::{self, Backend};
use crate::image_io::{Image, ImageError, read_exr, write_exr, write_whole};
use crate::methods::{Input, Settings, method};
use crate::report::{self, MethodResult};
use crate::scene::device::SceneBuffers;
use crate::scene::{self, Camera, LoadOptions, Scene};
use glam::Vec3;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::time::{Duration, Instant};

/// A scene with a view and its light, as the command line names them.
#[derive(Clone, PartialEq, Default, Debug, Serialize, Deserialize)]
pub struct SceneSpec {
    /// Built-in name or path.
    pub scene: String,
    /// Camera, as for [`Scene::camera`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub camera: Option<String>,
    /// Radiance of a constant environment, W/(sr m²).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub env: Option<[f32; 3]>,
    /// Added parallel light: direction of travel, perpendicular irradiance (W/m²).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sun: Option<([f32; 3], [f32; 3])>,
}

impl SceneSpec {
    /// Options of `render` and `compare` that give this view and light; empty where the scene's own are meant.
    pub fn arguments(&self) -> String {
        let numbers = |values: &[f32]| values.iter().map(f32::to_string).collect::<Vec<_>>().join(",");
        let camera = self.camera.as_ref().map(|camera| format!("--camera={camera}"));
        let sun = self.sun.map(|(travel, light)| format!("--sun={}", numbers(&[travel, light].concat())));
        let env = self.env.map(|env| format!("--env={}", numbers(&env)));
        camera.into_iter().chain(sun).chain(env).collect::<Vec<_>>().join(" ")
    }

    /// The scene and its camera.
    ///
    /// # Errors
    /// What loading says.
    pub fn load(&self) -> Result<(Scene, Camera), Error> {
        let sun = self.sun.map(|(direction, irradiance)| (direction.into(), irradiance.into()));
        let environment = self.env.map(Vec3::from);
        let options = LoadOptions { camera: self.camera.clone(), environment, sun, ..LoadOptions::default() };
        let scene = scene::load(&self.scene, &options)?;
        let camera = scene.camera(self.camera.as_deref())?;
        Ok((scene, camera))
    }
}

/// What a trial does. Equal jobs give equal pictures, and times of one machine.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Job {
    /// Scene and view.
    pub scene: SceneSpec,
    /// SHA-256 of the scene's content, in hexadecimal: a changed file is another job.
    pub scene_hash: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Seed of every random number.
    pub seed: u32,
    /// Name of the method.
    pub method: String,
    /// Every setting.
    pub settings: Settings,
    /// `auto`, `cpu` or `gpu`.
    pub backend: String,
    /// Part of the adapter's name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adapter: Option<String>,
    /// Worker threads; absent: one per core.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub threads: Option<u16>,
    /// Mean of the true indirect irradiance, for controls that are fitted to it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub true_mean: Option<[f32; 3]>,
    /// Counted runs of each phase after a warm-up.
    pub repeats: u32,
    /// Milliseconds after which a phase stops repeating.
    pub repeat_budget_ms: f64,
    /// Processor and program: times of another machine or version are not these.
    pub machine: String,
}

/// `result.json` of a trial.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Done {
    /// Times, memory, settings; without an error: the parent has the truth.
    pub result: MethodResult,
    /// What ran it.
    pub device: report::Device,
    /// Largest resident memory of the process.
    pub peak_memory_bytes: u64,
}

/// How a trial ended.
#[derive(Clone, PartialEq, Debug)]
pub enum Outcome {
    /// With a picture.
    Done {
        /// Times and memory.
        done: Box<Done>,
        /// Indirect irradiance of every pixel.
        irradiance: Image,
    },
    /// Not well.
    Bad(End),
}

/// How a trial ended that did not end well.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct End {
    /// What happened.
    pub status: Status,
    /// In words, for a table.
    pub reason: String,
    /// The limit that it ran under (s).
    pub limit_s: f64,
}

/// State of a row of a chart.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Measured.
    Done,
    /// The method refused: settings or limits.
    Failed,
    /// The process died.
    Crashed,
    /// The process was ended at its limit.
    TimedOut,
    /// Not run, for want of time.
    LeftOut,
}

impl Status {
    /// For people.
    pub fn words(self) -> &'static str {
        match self {
            Self::Done => "measured",
            Self::Failed => "failed",
            Self::Crashed => "crashed",
            Self::TimedOut => "timed out",
            Self::LeftOut => "left out",
        }
    }
}

/// Where trials run.
#[derive(Clone, Debug)]
pub struct Runner {
    /// The program that knows the verb `trial`: this one.
    pub program: PathBuf,
    /// Folder of the trials' folders.
    pub folder: PathBuf,
    /// Whether trials that ended badly before are tried again.
    pub retry: bool,
}

/// A trial's outcome and what it took.
#[derive(Clone, PartialEq, Debug)]
pub struct Trial {
    /// How it ended.
    pub outcome: Outcome,
    /// Wall-clock time of the process (s); of an earlier run, 0.
    pub wall_s: f64,
    /// Whether an earlier run's outcome was taken.
    pub earlier: bool,
}

impl Runner {
    /// Runs a job, or takes what an earlier run of the same job left.
    ///
    /// # Errors
    /// Where the folder cannot be written, or the program not started. How the trial itself ends is no error.
    pub fn run(&self, job: &Job, limit: Duration) -> Result<Trial, Error> {
        let folder = self.folder.join(format!("{}-{}", job.method, &job.hash()[..12]));
        if let Some(outcome) = self.earlier(&folder, job, limit) {
            return Ok(Trial { outcome, wall_s: 0.0, earlier: true });
        }
        let io = |source| ImageError::io("write", &folder, source);
        // Whatever a broken run left must not be taken for this one's.
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).map_err(io)?;
        write_whole(&folder.join("job.json"), report::to_json(job)?.as_bytes())?;
        let start = Instant::now();
        let status = self.watch(job, &folder, limit)?;
        let wall_s = start.elapsed().as_secs_f64();
        let limit_s = limit.as_secs_f64();
        let bad = |status, reason| Outcome::Bad(End { status, reason, limit_s });
        let outcome = match status {
            Some(status) if status.success() => {
                read_done(&folder).unwrap_or_else(|| bad(Status::Crashed, "it ended without a result".into()))
            }
            Some(status) => {
                let (status, reason) = end_of(status, &folder);
                bad(status, reason)
            }
            None => bad(Status::TimedOut, format!("it took more than {limit_s:.1} s")),
        };
        if let Outcome::Bad(end) = &outcome {
            write_whole(&folder.join("end.json"), report::to_json(end)?.as_bytes())?;
        }
        Ok(Trial { outcome, wall_s, earlier: false })
    }

    /// The process's end, `None` where it was ended at its limit.
    fn watch(&self, job: &Job, folder: &Path, limit: Duration) -> Result<Option<ExitStatus>, Error> {
        let io = |source| ImageError::io("write", folder, source);
        let log = File::create(folder.join("log.txt")).map_err(io)?;
        let mut command = Command::new(&self.program);
        if let Some(threads) = job.threads {
            command.args(["--threads", &threads.to_string()]);
        }
        command.arg("trial").arg(folder).stdin(Stdio::null()).stdout(Stdio::null()).stderr(log);
        let start = Instant::now();
        let mut child = command.spawn().map_err(|source| ImageError::io("start", &self.program, source))?;
        loop {
            if let Some(status) = child.try_wait().map_err(io)? {
                return Ok(Some(status));
            }
            if start.elapsed() >= limit {
                // It may have ended by itself in between: either way it is gone after this.
                let _ = child.kill();
                let _ = child.wait();
                return Ok(None);
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    /// What an earlier run of the same job left. One that ran out of time under a smaller limit gets another chance.
    fn earlier(&self, folder: &Path, job: &Job, limit: Duration) -> Option<Outcome> {
        let text = std::fs::read_to_string(folder.join("job.json")).ok()?;
        if serde_json::from_str::<Job>(&text).ok()? != *job {
            return None;
        }
        if let Some(outcome) = read_done(folder) {
            return Some(outcome);
        }
        let end: End = serde_json::from_str(&std::fs::read_to_string(folder.join("end.json")).ok()?).ok()?;
        let more_time = end.status == Status::TimedOut && end.limit_s < limit.as_secs_f64();
        (!self.retry && !more_time).then_some(Outcome::Bad(end))
    }
}

impl Job {
    fn hash(&self) -> String {
        let text = serde_json::to_string(self).expect("a job is text and numbers");
        Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

fn read_done(folder: &Path) -> Option<Outcome> {
    let done = serde_json::from_str(&std::fs::read_to_string(folder.join("result.json")).ok()?).ok()?;
    let irradiance = read_exr(&folder.join("irradiance.exr")).ok()?;
    Some(Outcome::Done { done: Box::new(done), irradiance })
}

/// A process's end: the program's own error, or the signal or panic that ended it.
fn end_of(status: ExitStatus, folder: &Path) -> (Status, String) {
    let log = std::fs::read_to_string(folder.join("log.txt")).unwrap_or_default();
    let line = |start: &str| log.lines().rev().find_map(|l| l.trim().strip_prefix(start).map(str::to_string));
    if let (Some(1 | 2), Some(reason)) = (status.code(), line("error: ")) {
        return (Status::Failed, reason);
    }
    let last = log.lines().rev().map(str::trim).find(|l| !l.is_empty()).unwrap_or_default();
    let said = if last.is_empty() { String::new() } else { format!(": {last}") };
    (Status::Crashed, format!("{status}{said}"))
}

/// Does the job of a trial's folder: what the child process does.
///
/// # Errors
/// An unreadable job; what the scene, the executor and the method say.
pub fn execute(folder: &Path) -> Result<(), Error> {
    let path = folder.join("job.json");
    let unreadable = |reason: String| Error::Usage(format!("{}: {reason}", path.display()));
    let text = std::fs::read_to_string(&path).map_err(|e| unreadable(e.to_string()))?;
    let job: Job = serde_json::from_str(&text).map_err(|e| unreadable(e.to_string()))?;
    let (scene, camera) = job.scene.load()?;
    let row = method(&job.method)?;
    let backend: Backend = job.backend.parse()?;
    let mut exec = exec::open_adapter(backend, job.adapter.as_deref(), &mut |warning| tell!("warning: {warning}"))?;
    let exec = exec.as_mut();
    let buffers = SceneBuffers::upload(exec, &scene)?;
    let view = View::new(exec, &scene, &buffers, &camera, job.size.into(), job.seed)?;
    let true_mean = job.true_mean.map(Vec3::from);
    let input = Input { scene: &scene, buffers: &buffers, seed: job.seed, true_mean };
    let repeats = Repeats { count: job.repeats, budget_ms: job.repeat_budget_ms };
    let run = evaluate::run(exec, &input, row, &job.settings, view.gbuffer, view.surfels.len(), repeats)?;
    let irradiance = view.image(|k| run.irradiance[k].truncate());
    irradiance.check_finite(row.name)?;
    write_exr(&folder.join("irradiance.exr"), &irradiance)?;
    let result = evaluate::describe(row, &job.settings, &run, &exec.device(), None);
    let device = (&exec.device()).into();
    let done = Done { result, device, peak_memory_bytes: evaluate::peak_memory_bytes() };
    write_whole(&folder.join("result.json"), report::to_json(&done)?.as_bytes())?;
    Ok(())
}

/// SHA-256 of a scene's content in hexadecimal.
pub fn scene_hash(scene: &Scene) -> String {
    scene.content_hash().iter().map(|byte| format!("{byte:02x}")).collect()
}
