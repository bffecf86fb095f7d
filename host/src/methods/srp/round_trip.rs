//! Least-squares correction of local transport by its own round trip.
//!
//! Light that leaves a patch of surface reaches a receiver directly (`F`, its form factors as the receiver's rays found
//! them), and by way of the probes (`α Λ`: what the probes' coefficients see of the patch, times transport). Local transport
//! `α₀` evaluates a truncated series in single directions: its values are means over the angle that the order
//! resolves, and contrast is lost to it. `F − α₀ Λ` is that loss, known before any light is (SL17 §5.2 takes its norm as
//! the error of a receiver). The correction is the ridge regression
//!
//! `min ‖F − α Λ‖² + ε ‖α − α₀‖²`,  `α' = α₀ + (F − α₀ Λ) Λᵀ (Λ Λᵀ + ε)⁻¹`,
//!
//! over kinds of light (columns of `F` and `Λ`), each weighted by how much of it is to be expected:
//! - patches of several sizes, from a five-hundredth of the receivers up by fours, their texels lit as strongly as they are on
//!   average in the lighting states of [`super::states`];
//! - even light everywhere, which keeps the mean;
//! - the lighting states themselves, most of them.
//!
//! Patches alone, all alike, are not enough: where receivers see little but one dark corner, transport that tells that
//! corner from the sunlit ground beside it takes large coefficients, and the sun leaks through what is left of them.
//!
//! **Judged.** States that were kept back say per receiver how far to follow: `α = α₀ + √t (α' − α₀)`, `t` (0 to 1) the
//! share that would bring it nearest to what its own rays gather of these states. What does harm there is not done. The root,
//! because states are few and `t` errs low where it is not 0: it was found on scenes, and is nowhere worse. Not in the papers.

use super::atlas::Atlas;
use super::compress::Lights;
use super::model::Receiver;
use super::plan::split;
use super::reach::Space;
use super::stand_in::StandIns;
use super::states::States;
use super::world::{Seen, World};
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, Side};
use glam::Vec3;
use interreflect_kernels::math::rng::rand;
use interreflect_kernels::math::sh;
use multiversion::multiversion;
use rayon::prelude::*;
use std::sync::Arc;

/// Smallest patches at most, about.
const PATCHES: usize = 500;
/// Patches of one size that make one of the next.
const GROUP: usize = 4;
/// Kinds of light to fit to, about: patches of all sizes, even light, states.
pub(super) const KINDS_FITTED: usize = PATCHES * GROUP / (GROUP - 1) + 1 + super::states::FITTED;
/// Standard deviation of the light of patches of one size over the mean light of all.
const CONTRAST: f32 = 0.5;
/// Root of the sum of squares of the states' weights, over that of even light.
const STATES: f32 = 2.0;
/// Lights that stand for all in the metric of compression.
const LIGHTS: usize = 256;
/// Rays of a probe by which it sees the patches, at least: several per patch, where relight rays may pass small ones by.
pub const RAYS: u32 = 1 << 13;

/// Kinds of light and what the probes see of them. What does not depend on probes is shared by clones.
#[derive(Clone)]
pub struct RoundTrip {
    /// Smallest patch of each texel, [`NO_PATCH`] for those without a receiver.
    patch_of: Arc<Vec<u32>>,
    stand_ins: Arc<StandIns>,
    /// Number of the smallest patches.
    patches: usize,
    /// Larger patches: that of each smallest one, and their number.
    sizes: Vec<(Vec<u32>, usize)>,
    states: Arc<States>,
    /// `Λ`, a row per probe and coefficient; a column per kind of light to fit to, then one per judge.
    lambda: Mat<f32>,
    metric: Mat<f64>,
    k: usize,
    ridge: f64,
}

/// What the judges say of the correction of some receivers.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Verdict {
    /// Receivers that were judged.
    pub receivers: f32,
    /// Sum of the shares by which they follow the correction.
    pub followed: f32,
    /// Square of the judges' irradiance, summed over receivers and judges.
    pub light: f32,
    /// Square of the error before the correction.
    pub before: f32,
    /// Square of the error after it.
    pub after: f32,
}

impl std::ops::Add for Verdict {
    type Output = Self;

    fn add(self, b: Self) -> Self {
        Self {
            receivers: self.receivers + b.receivers,
            followed: self.followed + b.followed,
            light: self.light + b.light,
            before: self.before + b.before,
            after: self.after + b.after,
        }
    }
}

/// Does not belong to a patch.
const NO_PATCH: u32 = u32::MAX;

/// Groups of neighbours among `points`, at most so many in each, that face the same of six ways: that of each, and their number.
fn groups(points: &[Receiver], most: usize) -> (Vec<u32>, usize) {
    let facing = |n: Vec3| {
        let a = n.abs();
        let axis = if a.x >= a.y && a.x >= a.z { 0 } else { 1 + usize::from(a.z > a.y) };
        2 * axis + usize::from(n[axis] < 0.0)
    };
    let (mut group_of, mut count) = (vec![0; points.len()], 0);
    for way in 0..6 {
        let own = |i: &u32| facing(points[*i as usize].geometric_normal) == way;
        let members: Vec<u32> = (0..points.len() as u32).filter(own).collect();
        for part in split(members, points, most) {
            part.iter().for_each(|i| group_of[*i as usize] = count);
            count += 1;
        }
    }
    (group_of, count as usize)
}

/// Larger and larger groups of the given ones, whose members are `points`.
fn larger(points: &[Receiver], patch_of: &[u32], patches: usize) -> Vec<(Vec<u32>, usize)> {
    // One point for each, in its middle.
    let mut middles: Vec<(Vec3, f32, Option<Receiver>)> = vec![(Vec3::ZERO, 0.0, None); patches];
    for (r, patch) in points.iter().zip(patch_of) {
        let middle = &mut middles[*patch as usize];
        *middle = (middle.0 + r.position, middle.1 + 1.0, Some(*r));
    }
    let middles: Vec<Receiver> =
        middles.into_iter().filter_map(|(sum, n, r)| r.map(|r| Receiver { position: sum / n, ..r })).collect();
    let mut sizes = Vec::new();
    let mut most = GROUP;
    while most * 6 < patches {
        sizes.push(groups(&middles, most));
        most *= GROUP;
    }
    sizes
}

/// `sums += weight · terms`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn add_scaled(sums: &mut [f32], terms: &[f32], weight: f32) {
    sums.iter_mut().zip(terms).for_each(|(s, t)| *s += weight * t);
}

impl RoundTrip {
    /// Kinds of light for the `receivers` (with their texels of `atlas`), seen by nobody yet.
    pub fn new(world: &World<'_>, space: &Space, atlas: Arc<Atlas>, receivers: &[(Receiver, u32)], seed: u32) -> Self {
        let texels = atlas.texels.len();
        let on_surface: Vec<&(Receiver, u32)> = receivers.iter().filter(|(_, t)| (*t as usize) < texels).collect();
        let points: Vec<Receiver> = on_surface.iter().map(|r| r.0).collect();
        let (patch_of_point, patches) = groups(&points, points.len().div_ceil(PATCHES).max(1));
        let sizes = larger(&points, &patch_of_point, patches);
        let mut patch_of = vec![NO_PATCH; texels];
        on_surface.iter().zip(&patch_of_point).for_each(|((_, t), patch)| patch_of[*t as usize] = *patch);
        let stand_ins = StandIns::new(world, atlas, |t| patch_of[t as usize] != NO_PATCH);
        let states = States::new(world, space, &stand_ins, receivers, texels, seed);
        Self {
            stand_ins: Arc::new(stand_ins),
            patch_of: Arc::new(patch_of),
            patches,
            sizes,
            states: Arc::new(states),
            lambda: Mat::zeros(0, 0),
            metric: Mat::zeros(0, 0),
            k: 0,
            ridge: 0.0,
        }
    }

    /// The texel with a receiver that stands for a point; `texel` is its own, if it has one.
    #[inline(always)]
    pub fn texel(&self, world: &World<'_>, seen: &Seen, texel: u32) -> u32 {
        self.stand_ins.of_texel(world, seen, texel)
    }

    /// Whether there is anything to correct.
    pub fn corrects(&self) -> bool {
        self.ridge > 0.0 && self.states.judges > 0
    }

    /// Numbers in a row of form factors: the smallest patches, even light, the states.
    pub fn factor_count(&self) -> usize {
        self.patches + 1 + self.states.count()
    }

    /// Adds a texel, seen with a weight, to a row of form factors.
    #[inline(always)]
    pub fn add(&self, factors: &mut [f32], texel: u32, weight: f32) {
        let Some(patch) = self.patch_of.get(texel as usize).filter(|p| **p != NO_PATCH) else { return };
        factors[*patch as usize] += weight * self.states.deviation[texel as usize];
        factors[self.patches] += weight;
        add_scaled(&mut factors[self.patches + 1..], self.states.of(texel), weight);
    }

    /// Asks for what [`Self::add`] reads of a texel: texels are many, and each has some hundred numbers.
    #[inline(always)]
    pub fn prefetch(&self, texel: u32) {
        if (texel as usize) < self.patch_of.len() {
            self.states.prefetch(texel);
        }
    }

    /// Columns to fit to: all but the judges.
    fn fitted(&self) -> usize {
        self.patches + self.sizes.iter().map(|s| s.1).sum::<usize>() + 1 + self.states.fitted
    }

    /// Rows of all kinds of light with their weights, then of the judges, from rows of form factors.
    fn columns(&self, factors: &[f32]) -> Mat<f32> {
        let width = self.factor_count();
        let rows = factors.len() / width.max(1);
        let mut all = Mat::zeros(rows, self.fitted() + self.states.judges);
        let state = STATES / (self.states.fitted.max(1) as f32).sqrt();
        for (i, own) in factors.chunks_exact(width).enumerate() {
            let (patches, rest) = own.split_at(self.patches);
            let mut first = self.patches;
            patches.iter().enumerate().for_each(|(q, f)| all[(i, q)] = CONTRAST * f);
            for (group_of, count) in &self.sizes {
                patches.iter().zip(group_of).for_each(|(f, g)| all[(i, first + *g as usize)] += CONTRAST * f);
                first += count;
            }
            all[(i, first)] = rest[0];
            for (q, f) in rest[1..].iter().enumerate() {
                all[(i, first + 1 + q)] = if q < self.states.fitted { state * f } else { *f };
            }
        }
        all
    }

    /// Takes what the probes see: `met[probe · rays + ray]` is the texel that a relight ray meets. Corrects by `ridge` from now
    /// on; until then nothing.
    pub fn see(&mut self, directions: &[Vec3], met: &[u32], order: u32, ridge: f64) {
        (self.k, self.ridge) = (sh::count(order), ridge);
        let (rays, width) = (directions.len().max(1), self.factor_count());
        let weight = 4.0 * std::f32::consts::PI / rays as f32;
        let basis: Vec<[f32; sh::MAX_COUNT]> = directions.iter().map(|d| sh::basis(d.to_array())).collect();
        let probe = |met: &[u32]| {
            let mut seen = vec![0.0; self.k * width];
            for (texel, y) in met.iter().zip(&basis) {
                seen.chunks_exact_mut(width).zip(y).for_each(|(row, y)| self.add(row, *texel, weight * y));
            }
            self.columns(&seen)
        };
        let probes: Vec<Mat<f32>> = met.par_chunks(rays).map(probe).collect();
        let width = self.fitted() + self.states.judges;
        self.lambda = Mat::from_fn(probes.len() * self.k, width, |i, q| probes[i / self.k][(i % self.k, q)]);
        // Sums of random sign keep lengths (Johnson & Lindenstrauss 1984): a few stand for all.
        let scale = (1.0 / LIGHTS as f64).sqrt() as f32;
        let sign = |q: usize, n: usize| if rand(21, q as u32, n as u32) < 0.5 { -scale } else { scale };
        let metric = self.lambda.subcols(0, self.fitted()) * Mat::from_fn(self.fitted(), LIGHTS, sign);
        self.metric = Mat::from_fn(metric.nrows(), metric.ncols(), |i, j| f64::from(metric[(i, j)]));
    }

    /// Lights as the coefficients of `probes`: sums of random sign of all kinds for the metric of compression, and the judges to
    /// test by.
    pub fn lights(&self, probes: &[u32], metric: bool) -> Lights {
        let rows: Vec<usize> = (0..probes.len() * self.k).map(|j| self.row(probes, j)).collect();
        let test = |j: usize, q: usize| f64::from(self.lambda[(rows[j], self.fitted() + q)]);
        Lights {
            metric: metric.then(|| Mat::from_fn(rows.len(), LIGHTS, |j, q| self.metric[(rows[j], q)])),
            test: Mat::from_fn(rows.len(), self.states.judges, test),
        }
    }

    /// The row of `Λ` for a column of a cluster of some probes.
    fn row(&self, probes: &[u32], column: usize) -> usize {
        probes[column / self.k] as usize * self.k + column % self.k
    }

    /// Corrects the transport of some receivers (of `each` rows) from the coefficients of `probes`, `matrix`: rows of
    /// `probes.len() · K`, by their form factors, rows of [`RoundTrip::factor_count`]. Receivers whose probes have nothing to do
    /// with each other, as on the two sides of a wall, are corrected apart: what a probe behind a wall sees is no evidence.
    ///
    /// After the receivers' rows come those of what may be chance in the rows and factors of some of them, the `witnesses`:
    /// the correction is linear, so that it makes of them what may be chance in the corrected rows.
    pub fn correct(
        &self,
        matrix: &mut [f32],
        probes: &[u32],
        factors: &[f32],
        each: usize,
        witnesses: &[usize],
    ) -> Verdict {
        if matrix.is_empty() || probes.is_empty() || self.k == 0 || !self.corrects() {
            return Verdict::default();
        }
        let (width, count) = (probes.len() * self.k, self.factor_count());
        let mut verdict = Verdict::default();
        let own_count = matrix.len() / (each * width) - witnesses.len();
        for (mut receivers, slots) in connected(&matrix[..own_count * each * width], probes.len(), self.k, each) {
            let judged = receivers.len();
            let (chance, of): (Vec<usize>, Vec<usize>) = (witnesses.iter().enumerate())
                .filter_map(|(w, i)| Some((own_count + w, receivers.binary_search(i).ok()?)))
                .unzip();
            receivers.extend(chance);
            let rows: Vec<usize> = receivers.iter().flat_map(|r| (0..each).map(move |n| r * each + n)).collect();
            let columns = self.filled(matrix, &rows[..judged * each], &slots, width);
            let seen: Vec<usize> = columns.iter().map(|c| self.row(probes, *c)).collect();
            let mut part: Vec<f32> =
                rows.iter().flat_map(|r| columns.iter().map(move |c| r * width + c)).map(|at| matrix[at]).collect();
            let mut own_factors = Vec::with_capacity(rows.len() * count);
            rows.iter().for_each(|r| own_factors.extend_from_slice(&factors[r * count..(r + 1) * count]));
            verdict = verdict + self.correct_connected(&mut part, &seen, &own_factors, (each, judged), &of);
            for (row, corrected) in rows.iter().zip(part.chunks_exact(columns.len())) {
                columns.iter().zip(corrected).for_each(|(c, x)| matrix[row * width + c] = *x);
            }
        }
        verdict
    }

    /// Columns of some of the probes that are not zero in all of some rows: bands that were left out stay so.
    fn filled(&self, matrix: &[f32], rows: &[usize], slots: &[usize], width: usize) -> Vec<usize> {
        let mut filled = vec![false; width];
        for row in rows {
            let own = &matrix[row * width..(row + 1) * width];
            filled.iter_mut().zip(own).for_each(|(f, x)| *f |= *x != 0.0);
        }
        slots.iter().flat_map(|s| s * self.k..(s + 1) * self.k).filter(|c| filled[*c]).collect()
    }

    /// The same for rows that belong together: of `judged` receivers, then of chance in some of them, `of`. `seen`: the row of
    /// `Λ` of each column.
    fn correct_connected(
        &self,
        matrix: &mut [f32],
        seen: &[usize],
        factors: &[f32],
        (each, judged): (usize, usize),
        of: &[usize],
    ) -> Verdict {
        let width = seen.len();
        let lambda = Mat::from_fn(width, self.lambda.ncols(), |j, q| self.lambda[(seen[j], q)]);
        let wanted = self.columns(factors);
        let rest = &wanted - MatRef::from_row_major_slice(matrix, wanted.nrows(), width) * &lambda;
        let fitted = self.fitted();
        let Some(change) = regression(lambda.subcols(0, fitted), rest.subcols(0, fitted), self.ridge) else {
            return Verdict::default();
        };
        let judges = fitted..lambda.ncols();
        let made = change.transpose() * lambda.subcols(fitted, judges.len());
        let (rest, light) = (rest.subcols(fitted, judges.len()), wanted.subcols(fitted, judges.len()));
        let mut verdict = Verdict::default();
        let follow_by = |t: f32, i: usize, row: &mut [f32]| {
            row.iter_mut().enumerate().for_each(|(j, a)| *a += t * change[(j, i)]);
        };
        let (matrix, chance) = matrix.split_at_mut(judged * each * width);
        let mut followed = Vec::with_capacity(judged);
        for (receiver, own) in matrix.chunks_exact_mut(each * width).enumerate() {
            let rows = receiver * each..(receiver + 1) * each;
            let sum = |f: &dyn Fn(usize, usize) -> f32| -> f32 {
                rows.clone().flat_map(|i| (0..judges.len()).map(move |q| f(i, q))).sum()
            };
            let best =
                sum(&|i, q| rest[(i, q)] * made[(i, q)]) / sum(&|i, q| made[(i, q)].powi(2)).max(f32::MIN_POSITIVE);
            let follow = best.clamp(0.0, 1.0).sqrt();
            rows.clone().zip(own.chunks_exact_mut(width)).for_each(|(i, row)| follow_by(follow, i, row));
            followed.push(follow);
            verdict = verdict
                + Verdict {
                    receivers: 1.0,
                    followed: follow,
                    light: sum(&|i, q| light[(i, q)].powi(2)),
                    before: sum(&|i, q| rest[(i, q)].powi(2)),
                    after: sum(&|i, q| (rest[(i, q)] - follow * made[(i, q)]).powi(2)),
                };
        }
        for (n, row) in chance.chunks_exact_mut(width).enumerate() {
            follow_by(followed[of[n / each]], judged * each + n, row);
        }
        verdict
    }
}

/// `(Λ Λᵀ + ε)⁻¹ Λ Rᵀ`, `ε` relative to the mean of the diagonal; a column per row of `rest`. `None` where that is singular.
fn regression(lambda: MatRef<'_, f32>, rest: MatRef<'_, f32>, ridge: f64) -> Option<Mat<f32>> {
    let double = |m: Mat<f32>| Mat::from_fn(m.nrows(), m.ncols(), |i, j| f64::from(m[(i, j)]));
    let mut normal = double(lambda * lambda.transpose());
    let width = normal.nrows();
    let mean = (0..width).map(|j| normal[(j, j)]).sum::<f64>() / width.max(1) as f64;
    (0..width).for_each(|j| normal[(j, j)] += ridge * mean.max(f64::MIN_POSITIVE));
    let change = normal.llt(Side::Lower).ok()?.solve(&double(lambda * rest.transpose()));
    Some(Mat::from_fn(change.nrows(), change.ncols(), |i, j| change[(i, j)] as f32))
}

/// Receivers that share probes, directly or through others, each group with the places of its probes in a row. `each` rows per
/// receiver of `probes` blocks of `k` numbers; a probe that a receiver does not use has blocks of zeros.
pub(super) fn connected(matrix: &[f32], probes: usize, k: usize, each: usize) -> Vec<(Vec<usize>, Vec<usize>)> {
    let width = probes * k;
    let uses =
        |own: &[f32], s: usize| own.chunks_exact(width).any(|row| row[s * k..(s + 1) * k].iter().any(|v| *v != 0.0));
    let used: Vec<Vec<usize>> =
        matrix.chunks_exact(each * width).map(|own| (0..probes).filter(|s| uses(own, *s)).collect()).collect();
    // The lowest place that each is connected to.
    let mut group: Vec<usize> = (0..probes).collect();
    for slots in &used {
        let lowest = slots.iter().map(|s| group[*s]).min();
        let merged: Vec<usize> = slots.iter().map(|s| group[*s]).collect();
        group.iter_mut().filter(|g| merged.contains(g)).for_each(|g| *g = lowest.unwrap_or(*g));
    }
    (0..probes)
        .map(|g| {
            let rows = (0..used.len()).filter(|r| used[*r].first().is_some_and(|s| group[*s] == g)).collect::<Vec<_>>();
            let slots = (0..probes).filter(|s| group[*s] == g && rows.iter().any(|r| used[*r].contains(s))).collect();
            (rows, slots)
        })
        .filter(|(rows, _): &(Vec<usize>, Vec<usize>)| !rows.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_without_a_common_probe_are_apart() {
        // Four rows of three probes of two numbers: 0 and 1 share the first probe, 2 has the last, 3 has none.
        let matrix = [[1., 0., 0., 0., 0., 0.], [0., 2., 1., 0., 0., 0.], [0., 0., 0., 0., 0., 3.], [0.; 6]].concat();
        assert_eq!(connected(&matrix, 3, 2, 1), [(vec![0, 1], vec![0, 1]), (vec![2], vec![2])]);
        // A row that uses all joins them.
        let joined = [matrix, vec![1.0; 6]].concat();
        assert_eq!(connected(&joined, 3, 2, 1), [(vec![0, 1, 2, 4], vec![0, 1, 2])]);
    }
}
