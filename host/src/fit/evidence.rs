//! What a method's settings are worth on a view, as cheaply as the question allows: whole frames are run, for their time,
//! but the truth is traced on a few of the picture's blocks only, more of them where the answer is close to the limit.

use crate::chart::trial::SceneSpec;
use crate::error::Error;
use crate::evaluate::{self, Repeats, View};
use crate::exec::Executor;
use crate::image_io::Image;
use crate::methods::{Input, MethodRow, Settings};
use crate::metrics::BLOCK_PX;
use crate::reference::{self, Receiver, ReferenceSettings};
use crate::scene::Scene;
use crate::scene::device::SceneBuffers;
use glam::{DVec3, Vec3, Vec4};
use std::path::PathBuf;
use std::time::Instant;

/// Blocks at which the truth is known, by level: each level is asked only where the one before leaves the answer open.
const LEVELS: [usize; 4] = [64, 192, 576, usize::MAX];
/// Samples per pixel of the truth. Over a block's 64 pixels its noise is an eighth of a pixel's, and what is left is known
/// and subtracted.
const TRUTH_SPP: u32 = 128;
/// Standard errors between an estimate and its bound: one side of nine in ten.
const CONFIDENCE: f64 = 1.28;
/// Runs of each phase, and milliseconds after which a phase is not repeated.
const REPEATS: Repeats = Repeats { count: 3, budget_ms: 150.0 };

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
    irradiance: Vec<Vec4>,
}

/// A view with as much truth as was needed so far.
pub struct Evidence {
    /// Scene.
    pub scene: Scene,
    /// Where methods run.
    pub exec: Box<dyn Executor>,
    buffers: SceneBuffers,
    view: View,
    seed: u32,
    cache: PathBuf,
    /// Pixels of each block that has visible ones, the blocks in random order.
    blocks: Vec<Vec<usize>>,
    truth: Vec<BlockTruth>,
    /// Seconds that truths took.
    pub truth_s: f64,
    /// Seconds that methods took.
    pub trials_s: f64,
    /// How many sets of settings were tried.
    pub trials: usize,
}

/// Truth of one block.
struct BlockTruth {
    mean: DVec3,
    /// Variance of that mean, from the path tracer's noise.
    variance: DVec3,
    count: f64,
}

impl Evidence {
    /// Loads a scene and finds its visible points.
    ///
    /// # Errors
    /// What loading and the executor say; a view of nothing.
    pub fn new(
        spec: &SceneSpec,
        size: [u32; 2],
        seed: u32,
        cache: PathBuf,
        mut exec: Box<dyn Executor>,
    ) -> Result<Self, Error> {
        let (scene, camera) = spec.load()?;
        let buffers = SceneBuffers::upload(exec.as_mut(), &scene)?;
        let view = View::new(exec.as_mut(), &scene, &buffers, &camera, size.into(), seed)?;
        let visible = view.visible();
        let across = size[0].div_ceil(BLOCK_PX);
        let mut blocks = vec![Vec::new(); (across * size[1].div_ceil(BLOCK_PX)) as usize];
        for (k, _) in visible.iter().enumerate().filter(|(_, v)| **v) {
            let (x, y) = (k as u32 % size[0], k as u32 / size[0]);
            blocks[(y / BLOCK_PX * across + x / BLOCK_PX) as usize].push(k);
        }
        blocks.retain(|b| !b.is_empty());
        if blocks.is_empty() {
            return Err(crate::metrics::MetricsError::NoVisiblePoint.into());
        }
        shuffle(&mut blocks, seed);
        Ok(Self {
            scene,
            exec,
            buffers,
            view,
            seed,
            cache,
            blocks,
            truth: Vec::new(),
            truth_s: 0.0,
            trials_s: 0.0,
            trials: 0,
        })
    }

    /// Runs settings; the error is judged on the first level of blocks.
    ///
    /// # Errors
    /// What the method says.
    pub fn try_settings(&mut self, row: &'static MethodRow, settings: &Settings) -> Result<Candidate, Error> {
        self.trace(LEVELS[0])?;
        let mut candidate = self.execute(row, settings)?;
        self.judge(&mut candidate);
        Ok(candidate)
    }

    /// Runs settings without judging them.
    ///
    /// # Errors
    /// What the method says.
    pub fn execute(&mut self, row: &'static MethodRow, settings: &Settings) -> Result<Candidate, Error> {
        let start = Instant::now();
        let input = Input { scene: &self.scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        let count = self.view.surfels.len();
        let run = evaluate::run(self.exec.as_mut(), &input, row, settings, self.view.gbuffer, count, REPEATS)?;
        self.trials_s += start.elapsed().as_secs_f64();
        self.trials += 1;
        Ok(Candidate {
            row: row.name,
            settings: settings.clone(),
            error: 0.0,
            bounds: [0.0; 2],
            blocks: 0,
            precompute_ms: run.times.precompute,
            // The fastest of the runs: the one that other work on the machine disturbed least.
            dynamic_ms: run.times.dynamic_spread().map_or(run.times.dynamic_frame(), |s| s[0]),
            frame_ms: run.times.spread.map_or(run.times.frame, |s| s.frame[0]),
            memory_bytes: run.buffers.iter().map(|b| b.1).sum(),
            irradiance: run.irradiance,
        })
    }

    /// A candidate's picture of indirect irradiance.
    pub fn image(&self, candidate: &Candidate) -> Image {
        self.view.image(|k| candidate.irradiance[k].truncate())
    }

    /// Looks at more blocks until the error is clearly below or above a limit, or all levels are used.
    ///
    /// # Errors
    /// What the path tracer says.
    pub fn settle(&mut self, candidate: &mut Candidate, limit: f64) -> Result<(), Error> {
        for level in LEVELS {
            if candidate.blocks < self.truth.len() {
                self.judge(candidate);
            }
            let open = candidate.bounds[0] <= limit && limit < candidate.bounds[1];
            if !open {
                break;
            }
            self.trace(level)?;
            self.judge(candidate);
        }
        Ok(())
    }

    /// Whether no indirect light reaches the first level of blocks.
    ///
    /// # Errors
    /// What the path tracer says.
    pub fn is_dark(&mut self) -> Result<bool, Error> {
        self.trace(LEVELS[0])?;
        Ok(self.mean() <= 0.0)
    }

    /// Traces the truth of the first `count` blocks.
    fn trace(&mut self, count: usize) -> Result<(), Error> {
        let count = count.min(self.blocks.len());
        if self.truth.len() >= count {
            return Ok(());
        }
        let start = Instant::now();
        let new = &self.blocks[self.truth.len()..count];
        let receivers: Vec<Receiver> = new.iter().flatten().map(|&k| Receiver::from(&self.view.surfels[k])).collect();
        // Its own seed: a method that samples by the same numbers must not look better than it is.
        let settings =
            ReferenceSettings { spp: Some(TRUTH_SPP), seed: self.seed ^ 0x0F17, ..ReferenceSettings::default() };
        let truth = reference::cached_irradiance(&self.cache, &self.scene, &receivers, &settings, &mut |_| {})?.truth;
        let mut values = truth.values.iter();
        for block in new {
            let n = block.len() as f64;
            let (mut mean, mut variance) = (DVec3::ZERO, DVec3::ZERO);
            for value in values.by_ref().take(block.len()) {
                mean += value.indirect.as_dvec3() / n;
                variance += value.variance.as_dvec3() / (n * n);
            }
            self.truth.push(BlockTruth { mean, variance, count: n });
        }
        self.truth_s += start.elapsed().as_secs_f64();
        Ok(())
    }

    /// Mean of the truth over pixels and channels.
    fn mean(&self) -> f64 {
        let (sum, count) =
            self.truth.iter().fold((0.0, 0.0), |(s, c), t| (s + t.mean.element_sum() * t.count, c + 3.0 * t.count));
        if count > 0.0 { sum / count } else { 0.0 }
    }

    /// Block NRMSE over the blocks that are known, without the part that the truth's noise adds, and its bounds.
    fn judge(&self, candidate: &mut Candidate) {
        let scale = self.mean();
        let mut squares = Vec::with_capacity(self.truth.len());
        let mut weight = 0.0;
        for (block, truth) in self.blocks.iter().zip(&self.truth) {
            let sum: Vec3 = block.iter().map(|&k| candidate.irradiance[k].truncate()).sum();
            let difference = sum.as_dvec3() / truth.count - truth.mean;
            let square = difference.length_squared() - truth.variance.element_sum();
            squares.push((square / 3.0, truth.count));
            weight += truth.count;
        }
        let mean = squares.iter().map(|(s, w)| s * w).sum::<f64>() / weight.max(1.0);
        let deviation: f64 =
            squares.iter().map(|(s, w)| ((s - mean) * w).powi(2)).sum::<f64>().sqrt() / weight.max(1.0);
        // The known blocks are a sample of all without replacement: all of them leave no doubt.
        let unknown = 1.0 - squares.len() as f64 / self.blocks.len() as f64;
        let doubt = CONFIDENCE * deviation * unknown.max(0.0).sqrt();
        let relative = |square: f64| if scale > 0.0 { square.max(0.0).sqrt() / scale } else { f64::INFINITY };
        candidate.error = relative(mean);
        candidate.bounds = [relative(mean - doubt), relative(mean + doubt)];
        candidate.blocks = squares.len();
    }
}

/// Fisher and Yates' shuffle with hashed numbers: the same order for the same seed.
fn shuffle<T>(items: &mut [T], seed: u32) {
    use crate::scene::built_in::hash_unit;
    for k in (1..items.len()).rev() {
        let at = (f64::from(hash_unit(seed.wrapping_mul(0x9E37_79B9) ^ k as u32)) * (k + 1) as f64) as usize;
        items.swap(k, at.min(k));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shuffles_keep_every_item_and_move_most() {
        let mut items: Vec<u32> = (0..100).collect();
        shuffle(&mut items, 5);
        assert!(items.iter().enumerate().filter(|(k, v)| *k as u32 == **v).count() < 10);
        items.sort_unstable();
        assert_eq!(items, (0..100).collect::<Vec<_>>());
    }
}
