//! Lighting methods: one file each, and the [`METHODS`] table that the program, charts and tests run over.

pub mod ambient;
pub mod direct;
pub mod gaps;
pub mod lpv;
pub mod reference;
pub mod settings;
pub mod srp;
pub mod vct;
pub mod voxels;

use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::reference::{Receiver, ReferenceError};
use crate::scene::Scene;
use glam::Vec3;
use interreflect_shared::scene::Surfel;
use serde::{Deserialize, Serialize};
use std::any::Any;
use std::collections::BTreeMap;
use std::sync::Arc;

/// What can go wrong in a method.
#[derive(Debug, thiserror::Error)]
pub enum MethodError {
    /// A kernel or buffer failed.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// The path tracer failed.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// No method has this name; the nearest existing one.
    #[error("there is no method `{name}`; did you mean `{nearest}`? (there are: {known})")]
    UnknownMethod {
        /// What was given.
        name: String,
        /// Nearest name.
        nearest: String,
        /// All names.
        known: String,
    },
    /// A setting does not exist; the nearest existing name.
    #[error("method `{method}` has no setting `{key}`; did you mean `{nearest}`? (it has: {known})")]
    UnknownSetting {
        /// Method.
        method: &'static str,
        /// What was given.
        key: String,
        /// Nearest name.
        nearest: String,
        /// All names.
        known: String,
    },
    /// A setting's value is not allowed.
    #[error("setting `{key}` of method `{method}`: `{value}` is not {expected}")]
    BadValue {
        /// Method.
        method: &'static str,
        /// Setting.
        key: String,
        /// What was given.
        value: String,
        /// What is allowed.
        expected: String,
    },
    /// A bake file cannot be used.
    #[error(transparent)]
    BakeFile(#[from] srp::file::BakeFileError),
    /// A later phase was asked for before the first.
    #[error("method `{method}` has nothing computed yet: call precompute first")]
    NotPrecomputed {
        /// Method.
        method: &'static str,
    },
    /// The method's buffers would not fit.
    #[error("method `{method}` needs {needed_bytes} bytes with these settings, more than {limit_bytes}: {hint}")]
    TooLarge {
        /// Method.
        method: &'static str,
        /// Bytes needed.
        needed_bytes: u64,
        /// The limit.
        limit_bytes: u64,
        /// What to change.
        hint: String,
    },
}

/// Named values of a method's parameters, as text; sorted by name.
pub type Settings = BTreeMap<String, String>;

/// A parameter that a method takes from `--set key=value`.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Setting {
    /// Name.
    pub key: &'static str,
    /// Default value.
    pub default: &'static str,
    /// Allowed values, for messages: `a power of two from 16 to 512`.
    pub allowed: &'static str,
    /// What a higher and a lower value buys; unit.
    pub help: &'static str,
}

/// The scene in device buffers, with what a method may need of the host's.
pub struct Input<'a> {
    /// The host's scene.
    pub scene: &'a Scene,
    /// Its buffers.
    pub buffers: &'a crate::scene::device::SceneBuffers,
    /// Seed of every random choice.
    pub seed: u32,
    /// Mean of the true indirect irradiance (W/m²) over the visible points, where a truth is at hand: for controls that
    /// are fitted to it. A method that is to be judged must not look.
    pub true_mean: Option<Vec3>,
}

/// When a stage of a method runs.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Phase {
    /// Once per scene geometry.
    #[default]
    Precompute,
    /// When lights or materials change.
    LightChange,
    /// Every frame.
    Frame,
}

impl Phase {
    /// Name in reports: `precompute`, `light_change`, `frame`.
    pub fn key(self) -> &'static str {
        match self {
            Self::Precompute => "precompute",
            Self::LightChange => "light_change",
            Self::Frame => "frame",
        }
    }
}

/// Times stages: `clock.stage(exec, "mipmap", |exec| …)`.
#[derive(Default, Debug)]
pub struct StageClock {
    /// Stage name and milliseconds, in order; a stage that ran twice appears twice.
    pub stages: Vec<(String, f64)>,
    /// Milliseconds of what a method did not do itself, because it took it over from others ([`Method::share`]): from nothing it
    /// would have taken these too.
    pub spared_ms: f64,
}

impl StageClock {
    /// Runs and times one stage.
    ///
    /// # Errors
    /// What `work` or the executor's clock returns.
    pub fn stage<E: From<ExecError>>(
        &mut self,
        exec: &mut dyn Executor,
        name: &str,
        work: impl FnOnce(&mut dyn Executor) -> Result<(), E>,
    ) -> Result<(), E> {
        exec.begin();
        let result = work(exec);
        let ms = exec.end()?;
        self.stages.push((name.to_string(), ms));
        result
    }
}

/// A length that a method's errors scale with.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Unit {
    /// Plural, for sentences: `voxels`, `cells`, `probe spacings`.
    pub name: &'static str,
    /// Length (m).
    pub metres: f32,
}

/// What a setting cuts off that ends a series: bands of spherical harmonics, bounces.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Terms {
    /// Key of the setting, a whole number.
    pub key: &'static str,
    /// What is cut off, for sentences: `bands`, `bounces`.
    pub name: &'static str,
    /// By value of the setting, ascending: the part of the light's amplitude that all terms beyond it carry.
    pub beyond: Vec<(u32, f64)>,
}

impl Terms {
    /// A series whose every term is `ratio` times the one before, the first being number 1.
    pub fn geometric(key: &'static str, name: &'static str, ratio: f64) -> Self {
        let beyond = (1..=MOST_TERMS).map(|n| (n, ratio.clamp(0.0, 1.0).powi(n as i32))).collect();
        Self { key, name, beyond }
    }

    /// The part of the light that a value leaves out, where it is known.
    pub fn left_out(&self, value: &str) -> Option<f64> {
        let value: u32 = value.parse().ok()?;
        self.beyond.iter().find(|(v, _)| *v == value).map(|(_, share)| *share)
    }
}

/// Terms of a geometric series that are listed.
const MOST_TERMS: u32 = 64;

/// Values of one setting, cheapest first, that a search may try.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct SearchAxis {
    /// Key of the setting.
    pub key: &'static str,
    /// Values from cheapest to dearest; at least two.
    pub values: &'static [&'static str],
}

/// Seconds that [`Method::precompute`] is expected to take.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SetUp {
    /// From nothing.
    pub whole_s: f64,
    /// Without what others left in shared parts ([`Method::share`]).
    pub left_s: f64,
}

/// What methods of one kind share ([`Method::share`]); nothing until the first of them puts something there.
pub type SharedParts = Option<Arc<dyn Any + Send + Sync>>;

/// A lighting method with its buffers. The three phases are called in order; a later frame or light change calls only
/// its own phase again and must not allocate.
pub trait Method: Send {
    /// Allocates, and computes what depends on geometry alone.
    fn precompute(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError>;

    /// Takes other settings after [`Method::precompute`], where those need nothing else of it: true. False, and nothing
    /// changes, where what was precomputed does not serve them (the default).
    fn retune(&mut self, _: &Settings) -> bool {
        false
    }

    /// Before [`Method::precompute`]: from now on parts of it may be taken over from others of the same method, for the same
    /// scene and seed, that were given the same `parts`, and are left there for them. What is taken over is bit for bit what
    /// would have been computed, and its time is told to the clock ([`StageClock::spared_ms`]). Nothing by default.
    fn share(&mut self, _parts: &mut SharedParts) {}

    /// Before [`Method::precompute`]: what that will take in this scene, told without doing it, from what is to be counted and
    /// a short measured sample of the work. `fit` asks it of everything that it might try: all questions together after the
    /// first must cost little, which is what shared parts can be used for. `None` (the default): quick, or not known.
    ///
    /// # Errors
    /// What reading back returns.
    fn set_up(&self, _: &mut dyn Executor, _: &Input<'_>) -> Result<Option<SetUp>, MethodError> {
        Ok(None)
    }

    /// Computes what depends on lights and materials.
    fn light_change(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError>;

    /// Indirect irradiance (W/m², `Vec4` per pixel, w = 0) at each [`interreflect_shared::scene::Surfel`] of
    /// `gbuffer`, into `irradiance` of the same length. Indirect: arriving after at least one reflection.
    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        clock: &mut StageClock,
    ) -> Result<(), MethodError>;

    /// What the method decided by itself (resolution, bounces, ranks…), for `report.json`.
    fn needs(&self) -> serde_json::Value {
        serde_json::Value::Null
    }

    /// The length that the method resolves in the scene it was precomputed for; leaks and flicker are stated in it.
    /// `None` (the default): none, or not known yet.
    ///
    /// ```ignore
    /// fn unit(&self) -> Option<Unit> {
    ///     Some(Unit { name: "cells", metres: self.state.as_ref()?.cell_size })
    /// }
    /// ```
    fn unit(&self) -> Option<Unit> {
        None
    }

    /// Part of its light that each further bounce kept in the last light change or frame: the largest eigenvalue of
    /// the method's feedback loop as it measured or bounds it. 1 or more: the loop grows without bound. `None` (the
    /// default): the method has no further bounces, or does not know.
    fn feedback_gain(&self) -> Option<f64> {
        None
    }

    /// Least irradiance (W/m²) that the method holds before it cuts off what is negative, and the mean of all that it holds: what
    /// a cut-off hides. `None` (the default): nothing is cut off.
    ///
    /// # Errors
    /// What reading back returns.
    fn lowest_uncut(&self, _: &mut dyn Executor) -> Result<Option<[f64; 2]>, MethodError> {
        Ok(None)
    }

    /// What the terms carry that settings cut off, as the last light change found: by this `fit` knows what not to try. Empty
    /// (the default): not known.
    fn terms(&self) -> Vec<Terms> {
        Vec::new()
    }

    /// Settings that `fit` changes from the rung that it found, each with its values from cheapest to dearest. The first is
    /// the method's size, which time depends on most: what the others do is learnt at its smallest value. Empty (the
    /// default): the values that occur in the ladder.
    fn search(&self) -> &'static [SearchAxis] {
        &[]
    }
}

/// One row of [`METHODS`].
pub struct MethodRow {
    /// Name on the command line.
    pub name: &'static str,
    /// True for a yardstick (no indirect light, a fitted constant, the truth itself), false for a candidate.
    pub control: bool,
    /// One sentence.
    pub summary: &'static str,
    /// When to use it.
    pub good_when: &'static str,
    /// When not to.
    pub fails_when: &'static str,
    /// Parameters.
    pub settings: &'static [Setting],
    /// Settings from cheapest to best, for charts and searches: name and changed values. At least five for a candidate.
    pub ladder: &'static [(&'static str, &'static [(&'static str, &'static str)])],
    /// Makes the method from checked settings (every key of `settings` is present).
    pub new: fn(&Settings) -> Result<Box<dyn Method>, MethodError>,
}

/// Every method.
pub const METHODS: &[MethodRow] = &[reference::ROW, direct::ROW, ambient::ROW, vct::ROW, lpv::ROW, srp::ROW];

/// The method of a name.
///
/// # Errors
/// [`MethodError::UnknownMethod`] with the nearest name.
pub fn method(name: &str) -> Result<&'static MethodRow, MethodError> {
    METHODS.iter().find(|row| row.name == name).ok_or_else(|| MethodError::UnknownMethod {
        name: name.to_string(),
        nearest: settings::nearest(name, METHODS.iter().map(|row| row.name)).unwrap_or("none").to_string(),
        known: METHODS.iter().map(|row| row.name).collect::<Vec<_>>().join(", "),
    })
}

/// Reads a G-buffer back as receivers, one per pixel; where the pixel shows no surface, one with a zero normal.
///
/// # Errors
/// What reading back returns.
pub fn receivers(exec: &mut dyn Executor, gbuffer: BufferId) -> Result<Vec<Receiver>, ExecError> {
    Ok(exec.read_slice::<Surfel>(gbuffer)?.iter().map(Receiver::from).collect())
}
