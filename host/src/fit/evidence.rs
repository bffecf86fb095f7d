//! What a method's settings are worth on a view, as cheaply as the question allows. A *glance* runs every phase about once,
//! and the frame for the pixels of a sample of the picture's blocks; the truth is traced on a few of these. Only where the
//! answer is close to the limit is the whole picture computed, and the truth traced on more of it.

use crate::chart::trial::SceneSpec;
use crate::error::Error;
use crate::evaluate::{Prepared, Repeats, View};
use crate::exec::{BufferId, Executor, ExecutorExt};
use crate::image_io::{Image, ImageError, ToneMap, png_bytes};
use crate::methods::{Input, MethodRow, Settings, SharedParts, StageClock, Terms};
use crate::metrics::BLOCK_PX;
use crate::reference::{self, Receiver, ReferenceSettings};
use crate::scene::Scene;
use crate::scene::device::SceneBuffers;
use glam::{DVec3, Vec3, Vec4};
use interreflect_shared::scene::Surfel;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;

/// Blocks at which the truth is known, by level: each level is asked only where the one before leaves the answer open.
const LEVELS: [usize; 4] = [64, SAMPLE_BLOCKS, 512, usize::MAX];
/// Blocks of a glance.
const SAMPLE_BLOCKS: usize = 128;
/// Samples per pixel of the truth. Over a block's 64 pixels its noise is an eighth of a pixel's, and what is left is known
/// and subtracted.
const TRUTH_SPP: u32 = 128;
/// Standard errors between an estimate and its bound for blocks that were not looked at: few settings are to be turned down,
/// or taken, for the blocks that the sample happened to hold.
const SAMPLING_CONFIDENCE: f64 = 2.0;
/// The same for the truth's noise: one side of eight in ten, for what lies right at the bound; most lies lower.
const NOISE_CONFIDENCE: f64 = 0.84;
/// How often the samples may be doubled, where every block is known and its noise alone leaves the answer open.
const DOUBLINGS: u32 = 2;
/// Runs of each phase of a whole picture, and milliseconds after which a phase is not repeated.
const REPEATS: Repeats = Repeats { count: 3, budget_ms: 150.0 };
/// The same of a glance: what is quick is run again, because the first run is slower and short times are noisy.
const GLANCE: Repeats = Repeats { count: 4, budget_ms: 50.0 };

/// Most and fewest rounds of a duel after its warm-up, and seconds after which it ends.
const DUEL_ROUNDS: u32 = 15;
const DUEL_LEAST: u32 = 3;
const DUEL_S: f64 = 4.0;

/// Methods that stay precomputed, and bytes of their buffers: the same settings are asked again for the whole picture, and
/// others that need the same precomputation.
const KEPT: (usize, u64) = (8, 1 << 30);

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
    /// Surface points of the first [`SAMPLE_BLOCKS`] blocks' pixels, one block after the other, and their number.
    sample: (BufferId, usize),
    /// Where frames of the sample and of the whole picture go.
    irradiance: [BufferId; 2],
    /// What was precomputed last, the last first.
    kept: Vec<Prepared>,
    /// Parts of precomputation by method.
    parts: BTreeMap<&'static str, SharedParts>,
    /// Seconds of precomputation that needed not be repeated.
    pub shared_s: f64,
    start: Instant,
    truth: Vec<BlockTruth>,
    /// How often its samples were doubled.
    doublings: u32,
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
        let start = Instant::now();
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
        let sample: Vec<Surfel> = blocks.iter().take(SAMPLE_BLOCKS).flatten().map(|k| view.surfels[*k]).collect();
        let sample = (exec.upload_slice("sample of surface points", &sample)?, sample.len());
        let mut irradiance = |count: usize| exec.zeroed_slice::<Vec4>("irradiance", count);
        let irradiance = [irradiance(sample.1)?, irradiance(view.surfels.len())?];
        Ok(Self {
            scene,
            exec,
            buffers,
            view,
            seed,
            cache,
            blocks,
            sample,
            irradiance,
            kept: Vec::new(),
            parts: BTreeMap::new(),
            shared_s: 0.0,
            start,
            truth: Vec::new(),
            doublings: 0,
            truth_s: 0.0,
            trials_s: 0.0,
            trials: 0,
        })
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
        self.judge(&mut candidate);
        Ok(candidate)
    }

    /// Times (ms) of a frame in which lights move, of two sets of settings in turn, so that whatever else the machine does
    /// meets both: the least of each.
    ///
    /// # Errors
    /// What the methods say.
    pub fn duel(&mut self, sides: [(&'static MethodRow, &Settings); 2]) -> Result<[f64; 2], Error> {
        let mark = self.exec.mark();
        let times = self.duel_marked(sides);
        self.exec.free_since(mark);
        times
    }

    fn duel_marked(&mut self, sides: [(&'static MethodRow, &Settings); 2]) -> Result<[f64; 2], Error> {
        let input = Input { scene: &self.scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        let exec = self.exec.as_mut();
        let irradiance = exec.zeroed_slice::<Vec4>("irradiance", self.view.surfels.len())?;
        let mut methods = Vec::new();
        for (row, settings) in sides {
            let mut method = (row.new)(settings)?;
            method.precompute(exec, &input, &mut StageClock::default())?;
            methods.push(method);
        }
        let mut least = [f64::INFINITY; 2];
        let start = Instant::now();
        // The first round is a warm-up.
        for round in 0..=DUEL_ROUNDS {
            for (method, least) in methods.iter_mut().zip(&mut least) {
                let begin = Instant::now();
                method.light_change(exec, &input, &mut StageClock::default())?;
                method.frame(exec, &input, self.view.gbuffer, irradiance, &mut StageClock::default())?;
                exec.begin();
                exec.end()?;
                let ms = begin.elapsed().as_secs_f64() * 1e3;
                *least = if round == 0 { *least } else { least.min(ms) };
            }
            if round >= DUEL_LEAST && start.elapsed().as_secs_f64() > DUEL_S {
                break;
            }
        }
        Ok(least)
    }

    /// Runs settings without judging them. A glance's time of a frame is that of its pixels, times the share that they are.
    ///
    /// # Errors
    /// What the method says.
    pub fn execute(
        &mut self,
        row: &'static MethodRow,
        settings: &Settings,
        effort: Effort,
    ) -> Result<Candidate, Error> {
        let start = Instant::now();
        let pixels = self.view.surfels.len();
        let whole = effort == Effort::Whole || self.blocks.len() <= SAMPLE_BLOCKS;
        let (points, count) = if whole { (self.view.gbuffer, pixels) } else { self.sample };
        let repeats = if effort == Effort::Whole { REPEATS } else { GLANCE };
        let (mut prepared, is_kept) = self.prepared(row, settings, repeats)?;
        let input = Input { scene: &self.scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        let irradiance = self.irradiance[usize::from(whole)];
        let run = prepared.run(self.exec.as_mut(), &input, points, irradiance, repeats);
        let shared_s = if is_kept { prepared.wall_s } else { prepared.spared_s };
        self.keep(prepared);
        let run = run?;
        let took_s = start.elapsed().as_secs_f64();
        let wall_s = took_s + shared_s;
        self.shared_s += shared_s;
        self.trials_s += took_s;
        self.trials += 1;
        // The fastest of the runs: the one that other work on the machine disturbed least.
        let light_ms = run.times.spread.map_or(run.times.light_change, |s| s.light_change[0]);
        let frame_ms = run.times.spread.map_or(run.times.frame, |s| s.frame[0]) * pixels as f64 / count.max(1) as f64;
        let means = if whole {
            let pixel = |k: &usize| run.irradiance[*k].truncate();
            self.blocks.iter().map(|b| mean_of(b.len(), b.iter().map(pixel))).collect()
        } else {
            let mut values = run.irradiance.iter().map(|v| v.truncate());
            let known = self.blocks.iter().take(SAMPLE_BLOCKS);
            known.map(|b| mean_of(b.len(), values.by_ref().take(b.len()))).collect()
        };
        Ok(Candidate {
            row: row.name,
            settings: settings.clone(),
            error: 0.0,
            bounds: [0.0; 2],
            blocks: 0,
            precompute_ms: run.times.precompute,
            dynamic_ms: light_ms + frame_ms,
            frame_ms,
            memory_bytes: run.buffers.iter().map(|b| b.1).sum(),
            wall_s,
            took_s,
            terms: run.terms,
            means,
            effort,
            irradiance: if whole { run.irradiance } else { Vec::new() },
        })
    }

    /// The method precomputed for these settings, and whether it was so before.
    fn prepared(
        &mut self,
        row: &'static MethodRow,
        settings: &Settings,
        repeats: Repeats,
    ) -> Result<(Prepared, bool), Error> {
        if let Some(at) = self.kept.iter_mut().position(|p| p.serves(row, settings)) {
            return Ok((self.kept.remove(at), true));
        }
        let input = Input { scene: &self.scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        let parts = self.parts.entry(row.name).or_default();
        Ok((Prepared::sharing(self.exec.as_mut(), &input, row, settings, repeats, parts)?, false))
    }

    /// Whether settings can be asked without precomputing anything.
    pub fn is_prepared(&mut self, row: &MethodRow, settings: &Settings) -> bool {
        self.kept.iter_mut().any(|p| p.serves(row, settings))
    }

    /// Keeps what was precomputed, and gives back what was not asked for the longest.
    fn keep(&mut self, prepared: Prepared) {
        self.kept.insert(0, prepared);
        let (count, bytes) = KEPT;
        while self.kept.len() > count || self.kept.iter().map(Prepared::memory_bytes).sum::<u64>() > bytes {
            let Some(oldest) = self.kept.pop() else { return };
            oldest.free(self.exec.as_mut());
        }
    }

    /// Seconds since this began: loading the scene, truths, trials.
    pub fn elapsed_s(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// The picture that settings make, as PNG files: full, and indirect irradiance alone.
    ///
    /// # Errors
    /// What the method says.
    pub fn pictures(&mut self, row: &'static MethodRow, settings: &Settings) -> Result<[Vec<u8>; 2], Error> {
        let candidate = self.execute(row, settings, Effort::Whole)?;
        let frame = self.view.frame(&candidate.irradiance);
        let visible = self.view.visible();
        let png = |image: &Image| {
            let encoded = png_bytes(&ToneMap::from_truth(image, &visible).apply(image));
            encoded.map_err(|reason| ImageError::Encode { path: "index.html".into(), reason })
        };
        Ok([png(&frame.full)?, png(&frame.irradiance)?])
    }

    /// A candidate's picture of indirect irradiance; black where it was not computed.
    pub fn image(&self, candidate: &Candidate) -> Image {
        self.view.image(|k| candidate.irradiance.get(k).map_or(Vec3::ZERO, |v| v.truncate()))
    }

    /// Block NRMSE of block means that were not computed but estimated, without the part that the truth's noise adds.
    pub fn error_of(&self, means: &[DVec3]) -> f64 {
        self.relative(self.squares(means).0)
    }

    /// Looks at more blocks until the error is clearly below or above a limit, or all levels are used; at `least` as many as
    /// that in any case. A finer truth, where only its noise leaves the answer open, may take `refining_s` (s) more.
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
        let least = least.min(self.blocks.len());
        for level in LEVELS {
            if candidate.blocks < self.truth.len().min(candidate.means.len()) {
                self.judge(candidate);
            }
            let open = candidate.bounds[0] <= limit && limit < candidate.bounds[1];
            if !open && candidate.blocks >= least {
                break;
            }
            self.trace(level)?;
            if candidate.means.len() < level.min(self.blocks.len()) {
                let glance_s = (candidate.wall_s, candidate.took_s);
                *candidate = self.execute(row, &candidate.settings, Effort::Whole)?;
                (candidate.wall_s, candidate.took_s) = glance_s;
            }
            self.judge(candidate);
        }
        let is_open = |c: &Candidate| c.bounds[0] <= limit && limit < c.bounds[1];
        // As many samples again take as long as all before.
        let affordable = |evidence: &Self| evidence.doublings < DOUBLINGS && evidence.truth_s < refining_s;
        while is_open(candidate) && candidate.blocks == self.blocks.len() && affordable(self) {
            self.double_samples()?;
            self.judge(candidate);
        }
        Ok(())
    }

    /// Traces as many samples again of every block, all of which are known.
    fn double_samples(&mut self) -> Result<(), Error> {
        self.doublings += 1;
        let old = std::mem::take(&mut self.truth);
        let samples = TRUTH_SPP << (self.doublings - 1);
        self.truth = self.traced(0..self.blocks.len(), samples, 0xF17E + self.doublings)?;
        for (new, old) in self.truth.iter_mut().zip(old) {
            new.mean = old.mean.lerp(new.mean, 0.5);
            new.variance = 0.25 * (new.variance + old.variance);
        }
        Ok(())
    }

    /// Whether no indirect light reaches what is seen: the truth is black in all blocks.
    ///
    /// # Errors
    /// What the path tracer says.
    pub fn is_dark(&mut self) -> Result<bool, Error> {
        for level in LEVELS {
            self.trace(level)?;
            if self.mean() > 0.0 {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Traces the truth of the first `count` blocks.
    fn trace(&mut self, count: usize) -> Result<(), Error> {
        let count = count.min(self.blocks.len());
        if self.truth.len() >= count {
            return Ok(());
        }
        // Its own seed: a method that samples by the same numbers must not look better than it is.
        let new = self.traced(self.truth.len()..count, TRUTH_SPP, 0x0F17)?;
        self.truth.extend(new);
        Ok(())
    }

    /// The truth of some blocks.
    fn traced(&mut self, blocks: Range<usize>, spp: u32, seed: u32) -> Result<Vec<BlockTruth>, Error> {
        let start = Instant::now();
        let new = &self.blocks[blocks];
        let receivers: Vec<Receiver> = new.iter().flatten().map(|&k| Receiver::from(&self.view.surfels[k])).collect();
        let settings = ReferenceSettings { spp: Some(spp), seed: self.seed ^ seed, ..ReferenceSettings::default() };
        let truth = reference::cached_irradiance(&self.cache, &self.scene, &receivers, &settings, &mut |_| {})?.truth;
        let mut values = truth.values.iter();
        let mut found = Vec::with_capacity(new.len());
        for block in new {
            let n = block.len() as f64;
            let (mut mean, mut variance) = (DVec3::ZERO, DVec3::ZERO);
            for value in values.by_ref().take(block.len()) {
                mean += value.indirect.as_dvec3() / n;
                variance += value.variance.as_dvec3() / (n * n);
            }
            found.push(BlockTruth { mean, variance, count: n });
        }
        self.truth_s += start.elapsed().as_secs_f64();
        Ok(found)
    }

    /// Mean of the truth over pixels and channels.
    fn mean(&self) -> f64 {
        let (sum, count) =
            self.truth.iter().fold((0.0, 0.0), |(s, c), t| (s + t.mean.element_sum() * t.count, c + 3.0 * t.count));
        if count > 0.0 { sum / count } else { 0.0 }
    }

    /// Block NRMSE over the blocks that are known, without the part that the truth's noise adds, and its bounds.
    fn judge(&self, candidate: &mut Candidate) {
        let (mean, doubt, count) = self.squares(&candidate.means);
        candidate.error = self.relative(mean);
        candidate.bounds = [self.relative(mean - doubt), self.relative(mean + doubt)];
        candidate.blocks = count;
    }

    /// Mean square error (W²/m⁴) over the blocks that are known, half of its confidence interval, and their number.
    fn squares(&self, means: &[DVec3]) -> (f64, f64, usize) {
        let mut squares = Vec::with_capacity(self.truth.len());
        let (mut weight, mut noise) = (0.0, 0.0);
        for (value, truth) in means.iter().zip(&self.truth) {
            let (difference, variance) = (*value - truth.mean, truth.variance);
            let square = difference.length_squared() - variance.element_sum();
            squares.push((square / 3.0, truth.count));
            weight += truth.count;
            // Variance of a noisy difference's square, were the noise normal: 4d²v + 2v².
            let of_square = 4.0 * difference * difference * variance + 2.0 * variance * variance;
            noise += of_square.element_sum() * (truth.count / 3.0).powi(2);
        }
        let weight = weight.max(1.0);
        let mean = squares.iter().map(|(s, w)| s * w).sum::<f64>() / weight;
        let spread = squares.iter().map(|(s, w)| ((s - mean) * w).powi(2)).sum::<f64>();
        // The known blocks are a sample of all without replacement: all of them leave no doubt but the truth's noise.
        let unknown = (1.0 - squares.len() as f64 / self.blocks.len() as f64).max(0.0);
        let (sampling, noise) = (spread * unknown, noise * (1.0 - unknown));
        let doubt = (SAMPLING_CONFIDENCE.powi(2) * sampling + NOISE_CONFIDENCE.powi(2) * noise).sqrt() / weight;
        (mean, doubt, squares.len())
    }

    /// Root of a mean square over the truth's mean.
    fn relative(&self, square: f64) -> f64 {
        let scale = self.mean();
        if scale > 0.0 { square.max(0.0).sqrt() / scale } else { f64::INFINITY }
    }
}

/// Mean of some values.
fn mean_of(count: usize, values: impl Iterator<Item = Vec3>) -> DVec3 {
    values.map(|v| v.as_dvec3()).sum::<DVec3>() / count.max(1) as f64
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
    fn noise_of_the_truth_leaves_doubt_where_every_block_is_known() {
        let cache = tempfile::tempdir().unwrap();
        let spec = SceneSpec { scene: "cornell-box".into(), ..SceneSpec::default() };
        let exec = Box::new(crate::exec::CpuExecutor::new());
        let mut evidence = Evidence::new(&spec, [16, 16], 1, cache.path().into(), exec).unwrap();
        let row = crate::methods::method("direct").unwrap();
        let mut candidate = evidence.try_settings(row, &row.defaults(), Effort::Glance).unwrap();
        assert_eq!((candidate.blocks, candidate.means.len()), (evidence.blocks.len(), evidence.blocks.len()));
        // Without indirect light the error is at least 1; the sampled truth says it only within its noise.
        assert!(
            candidate.bounds[0] < candidate.error && candidate.error < candidate.bounds[1],
            "{:?}",
            candidate.bounds
        );
        assert!(candidate.bounds[1] < 1.1 * candidate.error);
        for truth in &mut evidence.truth {
            truth.variance *= 100.0;
        }
        let before = candidate.bounds[1] - candidate.bounds[0];
        evidence.judge(&mut candidate);
        assert!(candidate.bounds[1] - candidate.bounds[0] > 3.0 * before);
    }

    /// A normal number from two hashed ones (Box & Muller).
    fn normal(seed: u32) -> f64 {
        use crate::scene::built_in::hash_unit;
        let [u, v] = [hash_unit(2 * seed), hash_unit(2 * seed + 1)].map(f64::from);
        (-2.0 * (1.0 - u).ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }

    #[test]
    fn bounds_hold_the_error_as_often_as_their_confidence_says() {
        let cache = tempfile::tempdir().unwrap();
        let spec = SceneSpec { scene: "cornell-box".into(), ..SceneSpec::default() };
        let exec = Box::new(crate::exec::CpuExecutor::new());
        let mut evidence = Evidence::new(&spec, [64, 64], 1, cache.path().into(), exec).unwrap();
        let row = crate::methods::method("ambient").unwrap();
        let mut candidate = evidence.try_settings(row, &row.defaults(), Effort::Whole).unwrap();
        assert_eq!(evidence.truth.len(), evidence.blocks.len(), "meant to be all blocks");
        // A setting that is 0.3 away from every block of a truth of 1, which is known with a noise of 0.2.
        let (away, noise, turns) = (0.3, 0.2, 1000);
        candidate.means.fill(DVec3::splat(1.0 + away));
        let (mut above, mut below) = (0, 0);
        for turn in 0..turns {
            for (k, truth) in evidence.truth.iter_mut().enumerate() {
                let at = (turn * 1000 + k as u32) * 3;
                truth.mean = 1.0 + noise * DVec3::new(normal(at), normal(at + 1), normal(at + 2));
                truth.variance = DVec3::splat(noise * noise);
            }
            evidence.judge(&mut candidate);
            above += u32::from(candidate.bounds[1] < away);
            below += u32::from(candidate.bounds[0] > away);
        }
        // A fifth of a normal distribution lies beyond 0.84 standard deviations, on each side.
        let share = |count: u32| f64::from(count) / f64::from(turns);
        assert!((0.15..0.25).contains(&share(above)) && (0.15..0.25).contains(&share(below)), "{above} {below}");
    }

    #[test]
    fn a_glance_at_a_sample_has_the_means_of_the_whole_picture() {
        let cache = tempfile::tempdir().unwrap();
        let spec = SceneSpec { scene: "cornell-box".into(), ..SceneSpec::default() };
        let exec = Box::new(crate::exec::CpuExecutor::new());
        let mut evidence = Evidence::new(&spec, [128, 128], 1, cache.path().into(), exec).unwrap();
        assert!(evidence.blocks.len() > SAMPLE_BLOCKS);
        let row = crate::methods::method("lpv").unwrap();
        let settings = row.with(row.ladder[0].1.iter().copied()).unwrap();
        let [glance, whole] =
            [Effort::Glance, Effort::Whole].map(|effort| evidence.execute(row, &settings, effort).unwrap());
        assert_eq!((glance.means.len(), whole.means.len()), (SAMPLE_BLOCKS, evidence.blocks.len()));
        assert!(whole.means[0].min_element() > 0.0);
        for (a, b) in glance.means.iter().zip(&whole.means) {
            assert!(a.distance(*b) <= 1e-5 * b.length(), "{a} {b}");
        }
    }

    #[test]
    fn shuffles_keep_every_item_and_move_most() {
        let mut items: Vec<u32> = (0..100).collect();
        shuffle(&mut items, 5);
        assert!(items.iter().enumerate().filter(|(k, v)| *k as u32 == **v).count() < 10);
        items.sort_unstable();
        assert_eq!(items, (0..100).collect::<Vec<_>>());
    }
}
