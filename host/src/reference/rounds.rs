//! Rounds of batches: means and their variance without storing samples, and when to stop.
//!
//! A round gives every element the same number of samples, in [`BATCHES`] batches or more. Samples within a batch are
//! stratified against each other and so not independent; batches are. The variance of the mean therefore comes from
//! the spread of the batch means: with batches of `mᵢ` samples and means `xᵢ` in a round of `N` samples,
//! `Var(x̄) ≈ Σ mᵢ (xᵢ − x̄)² / ((R − 1) N)`, and rounds add up weighted by their squared share of all samples.

use super::{Progress, ReferenceError, ReferenceSettings};
use glam::DVec3;
use rayon::prelude::*;
use std::time::Instant;

/// Batches in a round, where there are samples enough: more give a better estimate of the variance, fewer and larger
/// ones better stratified samples.
const BATCHES: u32 = 4;
/// Batches of all elements together in a round, at least: for few elements the noise must still be known to 10 %, or
/// chance would end the work too soon.
const ALL_BATCHES: u32 = 256;
/// Most batches in a round.
const MAX_BATCHES: u32 = 64;
/// Samples of the first round when rendering to a noise.
const FIRST_ROUND: u32 = 32;
/// A round is at most this many times as large as all before it, so that a bad first estimate cannot overshoot much.
const GROWTH: u32 = 4;
/// Largest number of samples per element.
pub const MAX_SPP: u32 = 1 << 22;
/// Elements that one task works through.
const TASK: usize = 64;

/// What an element's batch yields: means over its samples.
#[derive(Clone, Copy, Default, Debug)]
pub struct BatchMean {
    /// Direct light.
    pub direct: DVec3,
    /// Indirect light.
    pub indirect: DVec3,
    /// Rays traced.
    pub rays: u64,
}

/// Sums of an element over all rounds.
#[derive(Clone, Copy, Default, Debug)]
pub struct Element {
    direct: DVec3,
    indirect: DVec3,
    variance_full: DVec3,
    variance_indirect: DVec3,
    rays: u64,
}

/// Which estimate must reach the requested noise.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Measure {
    /// Direct + indirect.
    Full,
    /// Indirect alone.
    Indirect,
}

/// All elements after the last round.
pub struct Rounds {
    elements: Vec<Element>,
    /// Samples per element.
    pub spp: u32,
    /// Relative noise reached.
    pub noise: f64,
    /// Rays traced.
    pub rays: u64,
    /// Wall-clock time.
    pub ms: f64,
}

impl Rounds {
    /// Means and variances of the means of element `i`: direct, indirect, full's variance, indirect's variance.
    pub fn result(&self, i: usize) -> (DVec3, DVec3, DVec3, DVec3) {
        let (e, n) = (&self.elements[i], f64::from(self.spp));
        (e.direct / n, e.indirect / n, e.variance_full / (n * n), e.variance_indirect / (n * n))
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.elements.len()
    }
}

/// Runs rounds until `settings` are met. `sample(element, batch, count)` returns the mean of one batch.
pub fn run(
    count: usize,
    settings: &ReferenceSettings,
    measure: Measure,
    sample: impl Fn(u32, u32, u32) -> BatchMean + Sync,
    progress: &mut dyn FnMut(Progress),
) -> Result<Rounds, ReferenceError> {
    let limit = settings.spp_limit()?;
    let target = settings.noise_target();
    let start = Instant::now();
    let mut state =
        Rounds { elements: vec![Element::default(); count], spp: 0, noise: f64::INFINITY, rays: 0, ms: 0.0 };
    let per_round = ALL_BATCHES.div_ceil(u32::try_from(count).unwrap_or(u32::MAX).max(1)).clamp(BATCHES, MAX_BATCHES);
    let first_round = FIRST_ROUND.max(2 * per_round);
    let mut first_batch = 0;
    let mut planned = target.map_or(limit, |_| first_round.min(limit));
    let mut expected = f64::from(planned);
    loop {
        let round = batches(planned, first_batch, per_round);
        let before = f64::from(state.spp);
        let mut report = |share: f64| {
            let fraction = ((before + share * f64::from(planned)) / expected).min(1.0);
            let elapsed_s = start.elapsed().as_secs_f64();
            let remaining_s = if fraction > 0.0 { elapsed_s * (1.0 / fraction - 1.0) } else { f64::INFINITY };
            progress(Progress { fraction, remaining_s, spp: state.spp, noise: state.noise });
        };
        run_round(&mut state.elements, &round, &sample, &mut report);
        first_batch += round.len() as u32;
        state.spp += planned;
        state.noise = relative_noise(&state.elements, state.spp, measure);
        let left = limit - state.spp;
        // Without a target, or without any light, one round is enough.
        let Some(target) = target.filter(|&t| state.noise > t && left > 0) else { break };
        // Variance falls at least as 1/n; a little more spares a further short round.
        let ratio = (state.noise / target).powi(2);
        expected = (f64::from(state.spp) * ratio * 1.03).min(f64::from(limit));
        let needed = (expected - f64::from(state.spp)).max(1.0);
        planned = (needed.ceil() as u32).clamp(2 * per_round, GROWTH * state.spp).min(left);
        // Whole batches of an even size are stratified better than uneven ones.
        planned = (planned.div_ceil(per_round).next_multiple_of(2) * per_round).min(left);
        if planned < 2 {
            break;
        }
    }
    state.rays = state.elements.iter().map(|e| e.rays).sum();
    state.ms = start.elapsed().as_secs_f64() * 1e3;
    progress(Progress { fraction: 1.0, remaining_s: 0.0, spp: state.spp, noise: state.noise });
    Ok(state)
}

/// Index and size of each batch of a round.
fn batches(samples: u32, first: u32, count: u32) -> Vec<(u32, u32)> {
    let count = count.min(samples);
    (0..count).map(|i| (first + i, samples / count + u32::from(i < samples % count))).collect()
}

fn run_round(
    elements: &mut [Element],
    round: &[(u32, u32)],
    sample: &(impl Fn(u32, u32, u32) -> BatchMean + Sync),
    report: &mut dyn FnMut(f64),
) {
    let total = elements.len().max(1);
    // About a hundred reports per round, each over enough work to hide the threads' meeting.
    let stretch = total.div_ceil(100).max(16 * TASK);
    for (s, elements) in elements.chunks_mut(stretch).enumerate() {
        report((s * stretch) as f64 / total as f64);
        elements.par_chunks_mut(TASK).enumerate().for_each(|(task, elements)| {
            for (k, element) in elements.iter_mut().enumerate() {
                element.add_round(round, |batch, count| sample((s * stretch + task * TASK + k) as u32, batch, count));
            }
        });
    }
}

impl Element {
    /// Adds one round's batches.
    fn add_round(&mut self, round: &[(u32, u32)], sample: impl Fn(u32, u32) -> BatchMean) {
        let (mut samples, mut full, mut indirect) = (0.0, Moments::default(), Moments::default());
        for &(batch, count) in round {
            let mean = sample(batch, count);
            let weight = f64::from(count);
            self.direct += mean.direct * weight;
            self.indirect += mean.indirect * weight;
            self.rays += mean.rays;
            full.add(mean.direct + mean.indirect, weight);
            indirect.add(mean.indirect, weight);
            samples += weight;
        }
        // Squared share of the round times the variance of its mean; `Rounds::result` divides by N².
        let scale = samples / (round.len() as f64 - 1.0);
        self.variance_full += full.squared_deviations * scale;
        self.variance_indirect += indirect.squared_deviations * scale;
    }
}

/// Weighted mean and squared deviations from it (West 1979): no cancellation.
#[derive(Default)]
struct Moments {
    weight: f64,
    mean: DVec3,
    squared_deviations: DVec3,
}

impl Moments {
    fn add(&mut self, x: DVec3, weight: f64) {
        self.weight += weight;
        let delta = x - self.mean;
        self.mean += delta * (weight / self.weight);
        self.squared_deviations += delta * (x - self.mean) * weight;
    }
}

/// Root mean square standard error over all elements and channels, divided by the mean; 0 where there is no light.
fn relative_noise(elements: &[Element], spp: u32, measure: Measure) -> f64 {
    let (mut sum, mut variance) = (DVec3::ZERO, DVec3::ZERO);
    for e in elements {
        match measure {
            Measure::Full => {
                sum += e.direct + e.indirect;
                variance += e.variance_full;
            }
            Measure::Indirect => {
                sum += e.indirect;
                variance += e.variance_indirect;
            }
        }
    }
    let values = 3.0 * elements.len() as f64;
    let mean = sum.element_sum() / values / f64::from(spp);
    let error = (variance.element_sum() / values).sqrt() / f64::from(spp);
    if mean > 0.0 { error / mean } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variance_of_independent_batches_is_unbiased() {
        // Uniform numbers of variance 1/12 in batches of unequal size; mean of 22 samples: 1/264.
        let uniform = |n: u32| f64::from(super::super::sampler::hash(n)) / 4_294_967_296.0;
        let round = batches(22, 0, 4);
        assert_eq!(round.iter().map(|b| b.1).sum::<u32>(), 22);
        let mut sum = 0.0;
        for trial in 0..4000u32 {
            let mut e = Element::default();
            e.add_round(&round, |batch, count| {
                let x = (0..count).map(|i| uniform(trial * 1000 + batch * 50 + i)).sum::<f64>() / f64::from(count);
                BatchMean { direct: DVec3::splat(x), indirect: DVec3::ZERO, rays: 0 }
            });
            sum += e.variance_full.x / 484.0;
        }
        let variance = sum / 4000.0;
        // The estimate over 4000 trials of 4 batches has a standard error of about √(2/3/4000) = 1.3 %.
        assert!((variance * 264.0 - 1.0).abs() < 0.06, "{variance} for {}", 1.0 / 264.0);
    }

    #[test]
    fn noise_target_is_reached_and_not_overshot_by_much() {
        let uniform = |n: u32| f64::from(super::super::sampler::hash(n)) / 4_294_967_296.0;
        let settings = ReferenceSettings { noise: Some(0.01), ..Default::default() };
        let sample = |e: u32, b: u32, n: u32| {
            let x = (0..n).map(|i| uniform((e << 20) + (b << 12) + i)).sum::<f64>() / f64::from(n);
            BatchMean { direct: DVec3::splat(x), indirect: DVec3::ZERO, rays: u64::from(n) }
        };
        let mut fractions = Vec::new();
        let r = run(50, &settings, Measure::Full, sample, &mut |p| fractions.push(p.fraction)).unwrap();
        assert!(r.noise <= 0.01, "{}", r.noise);
        // Relative deviation 1/√12/0.5 per sample: (0.577/0.01)² = 3333 samples.
        assert!((3000..5000).contains(&r.spp), "{}", r.spp);
        assert_eq!(r.rays, u64::from(r.spp) * 50);
        assert_eq!(fractions.last(), Some(&1.0));
    }
}
