//! Settings run where they will run: the scene, an executor, a path tracer for the truth.

use super::evidence::{Candidate, Effort, SAMPLE_BLOCKS, Source};
use super::truth::BlockTruth;
use crate::chart::trial::SceneSpec;
use crate::error::Error;
use crate::evaluate::{Prepared, Repeats, View};
use crate::exec::{BufferId, Executor, ExecutorExt};
use crate::image_io::{Image, ImageError, ToneMap, png_bytes};
use crate::methods::{Input, MethodRow, SetUp, Settings, SharedParts, StageClock};
use crate::metrics::BLOCK_PX;
use crate::reference::trace::KeptTree;
use crate::reference::{self, Receiver, ReferenceSettings};
use crate::scene::Scene;
use crate::scene::device::SceneBuffers;
use glam::{DVec3, Vec3, Vec4};
use interreflect_shared::scene::Surfel;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;
use std::time::Instant;

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

/// A view of a scene, and what was precomputed for it.
pub struct Live {
    /// Scene.
    pub scene: Scene,
    /// Its tree, for the truth.
    tree: KeptTree,
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
    start: Instant,
}

impl Live {
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
            tree: KeptTree::default(),
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
            start,
        })
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

    /// Keeps what was precomputed, and gives back what was not asked for the longest.
    fn keep(&mut self, prepared: Prepared) {
        self.kept.insert(0, prepared);
        let (count, bytes) = KEPT;
        while self.kept.len() > count || self.kept.iter().map(Prepared::memory_bytes).sum::<u64>() > bytes {
            let Some(oldest) = self.kept.pop() else { return };
            oldest.free(self.exec.as_mut());
        }
    }
}

impl Source for Live {
    fn execute(&mut self, row: &'static MethodRow, settings: &Settings, effort: Effort) -> Result<Candidate, Error> {
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
            precompute_ms: run.times.precompute,
            dynamic_ms: light_ms + frame_ms,
            frame_ms,
            memory_bytes: run.buffers.iter().map(|b| b.1).sum(),
            wall_s,
            took_s,
            terms: run.terms,
            means,
            irradiance: if whole { run.irradiance } else { Vec::new() },
            ..Candidate::unjudged(row.name, settings, effort)
        })
    }

    fn is_prepared(&mut self, row: &MethodRow, settings: &Settings) -> bool {
        self.kept.iter_mut().any(|p| p.serves(row, settings))
    }

    fn set_up(&mut self, row: &MethodRow, settings: &Settings) -> Option<SetUp> {
        let input = Input { scene: &self.scene, buffers: &self.buffers, seed: self.seed, true_mean: None };
        let mut method = (row.new)(settings).ok()?;
        method.share(self.parts.entry(row.name).or_default());
        // Who fails here says why when it is run.
        method.set_up(self.exec.as_mut(), &input).ok()?
    }

    fn blocks(&self) -> usize {
        self.blocks.len()
    }

    fn traced(&mut self, blocks: Range<usize>, spp: u32, seed: u32) -> Result<Vec<BlockTruth>, Error> {
        let new = &self.blocks[blocks];
        let receivers: Vec<Receiver> = new.iter().flatten().map(|&k| Receiver::from(&self.view.surfels[k])).collect();
        let settings = ReferenceSettings { spp: Some(spp), seed: self.seed ^ seed, ..ReferenceSettings::default() };
        let truth =
            reference::cached_irradiance(&self.cache, &self.tree, &self.scene, &receivers, &settings, &mut |_| {})?
                .truth;
        let mut values = truth.values.iter();
        let block = |block: &Vec<usize>| {
            let n = block.len() as f64;
            let (mut mean, mut variance) = (DVec3::ZERO, DVec3::ZERO);
            for value in values.by_ref().take(block.len()) {
                mean += value.indirect.as_dvec3() / n;
                variance += value.variance.as_dvec3() / (n * n);
            }
            BlockTruth { mean, variance, count: n }
        };
        Ok(new.iter().map(block).collect())
    }

    fn elapsed_s(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
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
    fn a_glance_at_a_sample_has_the_means_of_the_whole_picture() {
        let cache = tempfile::tempdir().unwrap();
        let spec = SceneSpec { scene: "cornell-box".into(), ..SceneSpec::default() };
        let exec = Box::new(crate::exec::CpuExecutor::new());
        let mut live = Live::new(&spec, [128, 128], 1, cache.path().into(), exec).unwrap();
        assert!(live.blocks.len() > SAMPLE_BLOCKS);
        let row = crate::methods::method("lpv").unwrap();
        let settings = row.with(row.ladder[0].1.iter().copied()).unwrap();
        let [glance, whole] =
            [Effort::Glance, Effort::Whole].map(|effort| live.execute(row, &settings, effort).unwrap());
        assert_eq!((glance.means.len(), whole.means.len()), (SAMPLE_BLOCKS, live.blocks.len()));
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
