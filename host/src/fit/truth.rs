//! What is known of the truth, and what candidates' errors against it are worth: an estimate and its bounds.

use super::Candidate;
use glam::DVec3;

/// Standard errors between an estimate and its bound for blocks that were not looked at: few settings are to be turned down,
/// or taken, for the blocks that the sample happened to hold.
const SAMPLING_CONFIDENCE: f64 = 2.0;
/// The same for the truth's noise: one side of eight in ten, for what lies right at the bound; most lies lower.
const NOISE_CONFIDENCE: f64 = 0.84;

/// Truth of one block of pixels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BlockTruth {
    /// Mean indirect irradiance (W/m²).
    pub mean: DVec3,
    /// Variance of that mean, from the path tracer's noise.
    pub variance: DVec3,
    /// Pixels that show something.
    pub count: f64,
}

/// The truth of a picture's first blocks, all with as many samples.
#[derive(Clone, PartialEq, Default, Debug)]
pub(super) struct Truth {
    pub blocks: Vec<BlockTruth>,
    /// Samples per pixel of each.
    pub spp: u32,
    /// Blocks of the picture.
    pub of: usize,
}

/// A mean square error (W²/m⁴).
struct Squares {
    mean: f64,
    /// Half of its confidence interval from blocks that were not looked at.
    sampling: f64,
    /// The same from the truth's noise.
    noise: f64,
    /// Blocks behind it.
    count: usize,
}

impl Truth {
    /// Mean over pixels and channels.
    pub fn mean(&self) -> f64 {
        let (sum, count) =
            self.blocks.iter().fold((0.0, 0.0), |(s, c), t| (s + t.mean.element_sum() * t.count, c + 3.0 * t.count));
        if count > 0.0 { sum / count } else { 0.0 }
    }

    /// Joins as many samples again of every block.
    pub fn join(&mut self, again: &[BlockTruth]) {
        for (old, new) in self.blocks.iter_mut().zip(again) {
            old.mean = old.mean.lerp(new.mean, 0.5);
            old.variance = 0.25 * (old.variance + new.variance);
        }
        self.spp *= 2;
    }

    /// Block NRMSE over the blocks that are known, without the part that the truth's noise adds, and its bounds.
    pub fn judge(&self, candidate: &mut Candidate) {
        let squares = self.squares(&candidate.means);
        let doubt = squares.sampling.hypot(squares.noise);
        candidate.error = self.relative(squares.mean);
        candidate.bounds = [squares.mean - doubt, squares.mean + doubt].map(|s| self.relative(s));
        candidate.blocks = squares.count;
    }

    /// Block NRMSE of block means, without the part that the truth's noise adds.
    pub fn error_of(&self, means: &[DVec3]) -> f64 {
        self.relative(self.squares(means).mean)
    }

    fn squares(&self, means: &[DVec3]) -> Squares {
        let mut squares = Vec::with_capacity(self.blocks.len());
        let (mut weight, mut noise) = (0.0, 0.0);
        for (value, truth) in means.iter().zip(&self.blocks) {
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
        let unknown = (1.0 - squares.len() as f64 / self.of as f64).max(0.0);
        Squares {
            mean,
            sampling: SAMPLING_CONFIDENCE * (spread * unknown).sqrt() / weight,
            noise: NOISE_CONFIDENCE * (noise * (1.0 - unknown)).sqrt() / weight,
            count: squares.len(),
        }
    }

    /// Root of a mean square over the truth's mean.
    fn relative(&self, square: f64) -> f64 {
        let scale = self.mean();
        if scale > 0.0 { square.max(0.0).sqrt() / scale } else { f64::INFINITY }
    }
}
#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::trial::SceneSpec;
    use crate::fit::{Effort, Evidence, Live};

    #[test]
    fn noise_of_the_truth_leaves_doubt_where_every_block_is_known() {
        let cache = tempfile::tempdir().unwrap();
        let spec = SceneSpec { scene: "cornell-box".into(), ..SceneSpec::default() };
        let exec = Box::new(crate::exec::CpuExecutor::new());
        let mut evidence = Evidence::new(Live::new(&spec, [16, 16], 1, cache.path().into(), exec).unwrap());
        let row = crate::methods::method("direct").unwrap();
        let mut candidate = evidence.try_settings(row, &row.defaults(), Effort::Glance).unwrap();
        assert_eq!((candidate.blocks, candidate.means.len()), (evidence.truth.of, evidence.truth.of));
        // Without indirect light the error is at least 1; the sampled truth says it only within its noise.
        assert!(
            candidate.bounds[0] < candidate.error && candidate.error < candidate.bounds[1],
            "{:?}",
            candidate.bounds
        );
        assert!(candidate.bounds[1] < 1.1 * candidate.error);
        for truth in &mut evidence.truth.blocks {
            truth.variance *= 100.0;
        }
        let before = candidate.bounds[1] - candidate.bounds[0];
        evidence.truth.judge(&mut candidate);
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
        let mut evidence = Evidence::new(Live::new(&spec, [64, 64], 1, cache.path().into(), exec).unwrap());
        let row = crate::methods::method("ambient").unwrap();
        let mut candidate = evidence.try_settings(row, &row.defaults(), Effort::Whole).unwrap();
        assert_eq!(evidence.truth.blocks.len(), evidence.truth.of, "meant to be all blocks");
        // A setting that is 0.3 away from every block of a truth of 1, which is known with a noise of 0.2.
        let (away, noise, turns) = (0.3, 0.2, 1000);
        candidate.means.fill(DVec3::splat(1.0 + away));
        let (mut above, mut below) = (0, 0);
        for turn in 0..turns {
            for (k, truth) in evidence.truth.blocks.iter_mut().enumerate() {
                let at = (turn * 1000 + k as u32) * 3;
                truth.mean = 1.0 + noise * DVec3::new(normal(at), normal(at + 1), normal(at + 2));
                truth.variance = DVec3::splat(noise * noise);
            }
            evidence.truth.judge(&mut candidate);
            above += u32::from(candidate.bounds[1] < away);
            below += u32::from(candidate.bounds[0] > away);
        }
        // A fifth of a normal distribution lies beyond 0.84 standard deviations, on each side.
        let share = |count: u32| f64::from(count) / f64::from(turns);
        assert!((0.15..0.25).contains(&share(above)) && (0.15..0.25).contains(&share(below)), "{above} {below}");
    }
}
