//! What a method's settings are worth on a view, as cheaply as the question allows. A *glance* runs every phase about once,
//! and the frame for the pixels of a sample of the picture's blocks; the truth is traced on a few of these. Only where the
//! answer is close to the limit is the whole picture computed, and the truth traced on more of it, or with more samples.

use super::live::Live;
use super::truth::{BlockTruth, Truth};
use crate::error::Error;
use crate::methods::{MethodRow, SetUp, Settings, Terms};
use glam::{DVec3, Vec4};
use std::ops::Range;

/// Blocks at which the truth is known, by level: each level is asked only where the one before leaves the answer open.
const LEVELS: [usize; 4] = [64, SAMPLE_BLOCKS, 512, usize::MAX];
/// Blocks of a glance.
pub(super) const SAMPLE_BLOCKS: usize = 128;
/// Samples per pixel of the truth. Over a block's 64 pixels its noise is an eighth of a pixel's, and what is left is known
/// and subtracted.
const TRUTH_SPP: u32 = 128;
/// Samples per pixel up to which they are doubled, where every block is known and its noise alone leaves the answer open.
const MOST_SPP: u32 = 512;

/// How much of a picture is computed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Effort {
    /// Some blocks, about once.
    Glance,
    /// All pixels, the fastest of some runs.
    Whole,
}

/// Settings and what they gave.
#[derive(Clone, PartialEq, Debug)]
pub struct Candidate {
    /// Method.
    pub row: &'static str,
    /// Every setting.
    pub settings: Settings,
    /// Block NRMSE: best estimate.
    pub error: f64,
    /// Lower and upper bound of it.
    pub bounds: [f64; 2],
    /// Blocks behind the estimate.
    pub blocks: usize,
    /// Once per geometry (ms).
    pub precompute_ms: f64,
    /// A frame in which lights move (ms).
    pub dynamic_ms: f64,
    /// A frame in which nothing moves (ms).
    pub frame_ms: f64,
    /// The method's buffers.
    pub memory_bytes: u64,
    /// Seconds that the trial takes from nothing.
    pub wall_s: f64,
    /// Seconds that it took, what it shared with others not counted.
    pub took_s: f64,
    /// What terms beyond its settings would carry, as far as the method knows.
    pub terms: Vec<Terms>,
    /// Mean irradiance (W/m²) of each block that was computed, in the evidence's order of blocks.
    pub means: Vec<DVec3>,
    /// How it was run.
    pub effort: Effort,
    /// Per pixel, where the whole picture was computed; else empty.
    pub(super) irradiance: Vec<Vec4>,
}

impl Candidate {
    /// Before anything is known of it.
    pub fn unjudged(row: &'static str, settings: &Settings, effort: Effort) -> Self {
        Self {
            row,
            settings: settings.clone(),
            error: 0.0,
            bounds: [0.0; 2],
            blocks: 0,
            precompute_ms: 0.0,
            dynamic_ms: 0.0,
            frame_ms: 0.0,
            memory_bytes: 0,
            wall_s: 0.0,
            took_s: 0.0,
            terms: Vec::new(),
            means: Vec::new(),
            effort,
            irradiance: Vec::new(),
        }
    }
}

/// Where settings run and truths are traced.
pub trait Source {
    /// Blocks of the picture that show something.
    fn blocks(&self) -> usize;

    /// Runs settings, without judging them. A glance's time of a frame is that of its pixels, times the share that they are.
    ///
    /// # Errors
    /// What the method says.
    fn execute(&mut self, row: &'static MethodRow, settings: &Settings, effort: Effort) -> Result<Candidate, Error>;

    /// Whether settings can be asked without precomputing anything.
    fn is_prepared(&mut self, row: &MethodRow, settings: &Settings) -> bool;

    /// What precomputing settings will take, where their method knows it beforehand.
    fn set_up(&mut self, row: &MethodRow, settings: &Settings) -> Option<SetUp>;

    /// The truth of some blocks.
    ///
    /// # Errors
    /// What the path tracer says.
    fn traced(&mut self, blocks: Range<usize>, spp: u32, seed: u32) -> Result<Vec<BlockTruth>, Error>;

    /// Seconds since this began: loading the scene, truths, trials.
    fn elapsed_s(&self) -> f64;
}

/// A view with as much truth as was needed so far.
pub struct Evidence<S = Live> {
    /// Where settings run.
    pub source: S,
    pub(super) truth: Truth,
    /// Seconds of precomputation that needed not be repeated.
    pub shared_s: f64,
    /// Seconds that truths took.
    pub truth_s: f64,
    /// How many sets of settings were tried.
    pub trials: usize,
}

impl<S: Source> Evidence<S> {
    /// Nothing is known at first.
    pub fn new(source: S) -> Self {
        let truth = Truth { blocks: Vec::new(), spp: TRUTH_SPP, of: source.blocks() };
        Self { source, truth, shared_s: 0.0, truth_s: 0.0, trials: 0 }
    }

    /// Runs settings; the error is judged on the blocks whose truth is known, the first level at least.
    ///
    /// # Errors
    /// What the method says.
    pub fn try_settings(
        &mut self,
        row: &'static MethodRow,
        settings: &Settings,
        effort: Effort,
    ) -> Result<Candidate, Error> {
        self.trace(LEVELS[0])?;
        let mut candidate = self.execute(row, settings, effort)?;
        self.truth.judge(&mut candidate);
        Ok(candidate)
    }

    /// Runs settings without judging them.
    ///
    /// # Errors
    /// What the method says.
    pub fn execute(
        &mut self,
        row: &'static MethodRow,
        settings: &Settings,
        effort: Effort,
    ) -> Result<Candidate, Error> {
        let candidate = self.source.execute(row, settings, effort)?;
        self.shared_s += candidate.wall_s - candidate.took_s;
        self.trials += 1;
        Ok(candidate)
    }

    /// Block NRMSE of block means that were not computed but estimated, without the part that the truth's noise adds.
    pub fn error_of(&self, means: &[DVec3]) -> f64 {
        self.truth.error_of(means)
    }

    /// Looks at more blocks until the error is clearly below or above a limit, or all are known; at `least` as many as that in
    /// any case. A finer truth, where only its noise leaves the answer open, may take `refining_s` (s).
    ///
    /// # Errors
    /// What the path tracer and the method say.
    pub fn settle(
        &mut self,
        row: &'static MethodRow,
        candidate: &mut Candidate,
        limit: f64,
        least: usize,
        refining_s: f64,
    ) -> Result<(), Error> {
        let (all, least) = (self.truth.of, least.min(self.truth.of));
        loop {
            self.truth.judge(candidate);
            let known = candidate.blocks;
            let is_open = candidate.bounds[0] <= limit && limit < candidate.bounds[1];
            // As many samples again take as long as all before.
            let can_double = is_open && known == all && self.truth.spp < MOST_SPP && self.truth_s < refining_s;
            if can_double {
                self.double_samples()?;
            } else if known < if is_open { all } else { least } {
                self.trace(LEVELS.into_iter().find(|level| *level > known).unwrap_or(all))?;
                if candidate.means.len() == known {
                    let glance_s = (candidate.wall_s, candidate.took_s);
                    *candidate = self.execute(row, &candidate.settings, Effort::Whole)?;
                    (candidate.wall_s, candidate.took_s) = glance_s;
                }
            } else {
                return Ok(());
            }
        }
    }

    /// Whether no indirect light reaches what is seen: the truth is black in all blocks.
    ///
    /// # Errors
    /// What the path tracer says.
    pub fn is_dark(&mut self) -> Result<bool, Error> {
        for level in LEVELS {
            self.trace(level)?;
            if self.truth.mean() > 0.0 {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Traces the truth of the first `count` blocks.
    fn trace(&mut self, count: usize) -> Result<(), Error> {
        let (known, count) = (self.truth.blocks.len(), count.min(self.truth.of));
        if known < count {
            // Its own seed: a method that samples by the same numbers must not look better than it is.
            let new = self.traced(known..count, 0x0F17)?;
            self.truth.blocks.extend(new);
        }
        Ok(())
    }

    /// Traces as many samples again of every block that is known.
    fn double_samples(&mut self) -> Result<(), Error> {
        let again = self.traced(0..self.truth.blocks.len(), 0xF17E + self.truth.spp)?;
        self.truth.join(&again);
        Ok(())
    }

    fn traced(&mut self, blocks: Range<usize>, seed: u32) -> Result<Vec<BlockTruth>, Error> {
        let before_s = self.source.elapsed_s();
        let traced = self.source.traced(blocks, self.truth.spp, seed);
        self.truth_s += self.source.elapsed_s() - before_s;
        traced
    }
}
