//! Least-squares correction of local transport by its own round trip.
//!
//! Light that leaves a patch of surface reaches a receiver directly (`F`, its form factors as the receiver's rays found
//! them), and by way of the probes (`α Λ`: what the probes' coefficients see of the patch, times transport). Local transport
//! `α₀` evaluates a truncated series in single directions: its values are means over the angle that the order
//! resolves, and contrast is lost to it. `F − α₀ Λ` is that loss, known before any light is (SL17 §5.2 takes its norm as
//! the error of a receiver). The correction is the ridge regression
//!
//! `min ‖F − α Λ‖² + ε ‖α − α₀‖²`,  `α = α₀ + (F − α₀ Λ) Λᵀ (Λ Λᵀ + ε)⁻¹`,
//!
//! over the patches and, as one patch more, all of them together, which keeps the mean. `ε` stands for what light
//! does inside patches, of which `Λ` knows nothing: small ones fit the patches and make noise of the rest. Not in the papers.

use super::atlas::{Atlas, Lookup};
use super::compress::Lights;
use super::model::{NO_RECEIVER, Receiver};
use super::plan::split;
use super::world::Seen;
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use glam::Vec3;
use interreflect_kernels::math::rng::rand;
use interreflect_kernels::math::sh;
use std::sync::Arc;

/// Patches at most, about.
const PATCHES: usize = 1000;
/// Standard deviation of a patch's light over the mean light of all.
const CONTRAST: f64 = 0.5;
/// Lights that stand for all patches in the metric of compression.
const LIGHTS: usize = 256;
/// Lights by which compression is tested.
const TEST_LIGHTS: usize = 8;
/// Rays of a probe by which it sees the patches, at least: several per patch, where relight rays may pass small ones by.
pub const RAYS: u32 = 1 << 14;
/// Does not belong to a patch.
pub const NO_PATCH: u32 = u32::MAX;

/// Patches and what the probes see of them.
pub struct RoundTrip {
    /// Patch of each texel.
    patch_of: Vec<u32>,
    /// From points without a texel of their own to those that stand for them.
    lookup: Lookup,
    /// Number of patches.
    pub count: usize,
    /// `Λ`, a row per probe and coefficient; the last column is the sum of the others.
    lambda: Mat<f64>,
    metric: Mat<f64>,
    test: Mat<f64>,
    k: usize,
    ridge: f64,
}

/// Groups of neighbouring texels that face the same of six ways; `NO_PATCH` for those not among the `receivers`.
fn patches(receivers: &[(Receiver, u32)], texels: usize) -> (Vec<u32>, usize) {
    let points: Vec<Receiver> = receivers.iter().map(|r| r.0).collect();
    let facing = |n: Vec3| {
        let a = n.abs();
        let axis = if a.x >= a.y && a.x >= a.z { 0 } else { 1 + usize::from(a.z > a.y) };
        2 * axis + usize::from(n[axis] < 0.0)
    };
    let most = points.len().div_ceil(PATCHES).max(1);
    let (mut patch_of, mut count) = (vec![NO_PATCH; texels], 0);
    for way in 0..6 {
        let own = |i: &u32| facing(points[*i as usize].geometric_normal) == way;
        let members: Vec<u32> = (0..points.len() as u32).filter(own).collect();
        for part in split(members, &points, most) {
            part.iter().for_each(|i| {
                if let Some(patch) = patch_of.get_mut(receivers[*i as usize].1 as usize) {
                    *patch = count;
                }
            });
            count += 1;
        }
    }
    (patch_of, count as usize)
}

impl RoundTrip {
    /// Patches of about a thousandth of the `receivers` (with their texels of `atlas`), seen by nobody yet.
    pub fn new(atlas: Arc<Atlas>, receivers: &[(Receiver, u32)], ridge: f64) -> Self {
        let (patch_of, count) = patches(receivers, atlas.texels.len());
        let texels: Vec<u32> = (0..atlas.texels.len() as u32)
            .map(|t| if patch_of[t as usize] == NO_PATCH { NO_RECEIVER } else { t })
            .collect();
        let none = || Mat::zeros(0, 0);
        Self {
            lookup: Lookup::new(atlas, &texels),
            patch_of,
            count,
            lambda: none(),
            metric: none(),
            test: none(),
            k: 0,
            ridge,
        }
    }

    /// The patch that a point lies on; `texel` is its own, if it has one.
    pub fn patch(&self, seen: &Seen, texel: u32) -> u32 {
        match self.patch_of.get(texel as usize) {
            Some(patch) if *patch != NO_PATCH => *patch,
            _ => (self.lookup.one(seen.triangle, seen.weights, seen.front, seen.position, seen.normal))
                .map_or(NO_PATCH, |t| self.patch_of[t as usize]),
        }
    }

    /// Whether there is anything to correct.
    pub fn corrects(&self) -> bool {
        self.ridge > 0.0
    }

    /// Takes what the probes see: `met[probe · rays + ray]` is the patch that a relight ray meets.
    pub fn see(&mut self, directions: &[Vec3], met: &[u32], order: u32) {
        self.k = sh::count(order);
        let rays = directions.len().max(1);
        self.lambda = Mat::zeros(met.len() / rays * self.k, self.count + 1);
        let weight = 4.0 * std::f64::consts::PI / rays as f64;
        for (i, patch) in met.iter().enumerate().filter(|(_, patch)| **patch != NO_PATCH) {
            let y: [f32; sh::MAX_COUNT] = sh::basis(directions[i % rays].to_array());
            for (j, y) in y[..self.k].iter().enumerate() {
                self.lambda[(i / rays * self.k + j, *patch as usize)] += weight * f64::from(*y) * CONTRAST;
                self.lambda[(i / rays * self.k + j, self.count)] += weight * f64::from(*y);
            }
        }
        // Sums of random sign keep lengths (Johnson & Lindenstrauss 1984): a few stand for all patches.
        let scale = (1.0 / LIGHTS as f64).sqrt();
        let sign = |q: usize, n: usize| if rand(21, q as u32, n as u32) < 0.5 { -scale } else { scale };
        self.metric = &self.lambda * Mat::from_fn(self.count + 1, LIGHTS, sign);
        let shines = |q: usize, n: usize| q < self.count && rand(22, q as u32, n as u32) < 0.1;
        self.test = &self.lambda * Mat::from_fn(self.count + 1, TEST_LIGHTS, |q, n| f64::from(u8::from(shines(q, n))));
    }

    /// Lights of the patches, as the coefficients of `probes`: of random sign for the metric of compression, `LIGHTS` of
    /// them, and some in which a tenth of the patches shine, to test by.
    pub fn lights(&self, probes: &[u32], metric: bool) -> Lights {
        let rows: Vec<usize> = (0..probes.len() * self.k).map(|j| self.row(probes, j)).collect();
        let of = |m: &Mat<f64>| Mat::from_fn(rows.len(), m.ncols(), |j, q| m[(rows[j], q)]);
        Lights { metric: metric.then(|| of(&self.metric)), test: of(&self.test) }
    }

    /// The row of `Λ` for a column of a cluster of some probes.
    fn row(&self, probes: &[u32], column: usize) -> usize {
        probes[column / self.k] as usize * self.k + column % self.k
    }

    /// Corrects the transport of some receivers from the coefficients of `probes`, `matrix`: rows of `probes.len() · K`,
    /// by their form factors, rows of `count`. Receivers whose probes have nothing to do with each other, as on the two
    /// sides of a wall, are corrected apart: what a probe behind a wall sees is no evidence.
    pub fn correct(&self, matrix: &mut [f32], probes: &[u32], factors: &[f32]) {
        if matrix.is_empty() || probes.is_empty() || self.k == 0 || self.ridge <= 0.0 {
            return;
        }
        let width = probes.len() * self.k;
        for (rows, slots) in connected(matrix, probes.len(), self.k) {
            let own: Vec<u32> = slots.iter().map(|s| probes[*s]).collect();
            let blocks = |row: usize| slots.iter().map(move |s| row * width + s * self.k);
            let mut part = Vec::with_capacity(rows.len() * slots.len() * self.k);
            rows.iter().flat_map(|r| blocks(*r)).for_each(|at| part.extend_from_slice(&matrix[at..at + self.k]));
            let mut own_factors = Vec::with_capacity(rows.len() * self.count);
            rows.iter().for_each(|r| own_factors.extend_from_slice(&factors[r * self.count..(r + 1) * self.count]));
            self.correct_connected(&mut part, &own, &own_factors);
            for (at, block) in rows.iter().flat_map(|r| blocks(*r)).zip(part.chunks_exact(self.k)) {
                matrix[at..at + self.k].copy_from_slice(block);
            }
        }
    }

    fn correct_connected(&self, matrix: &mut [f32], probes: &[u32], factors: &[f32]) {
        let width = probes.len() * self.k;
        let rows = matrix.len() / width.max(1);
        let lambda = Mat::from_fn(width, self.count + 1, |j, q| self.lambda[(self.row(probes, j), q)]);
        let before = Mat::from_fn(rows, width, |i, j| f64::from(matrix[i * width + j]));
        let form = |i: usize, q: usize| f64::from(factors[i * self.count + q]);
        let mut rest =
            Mat::from_fn(rows, self.count + 1, |i, q| if q < self.count { form(i, q) * CONTRAST } else { 0.0 });
        for i in 0..rows {
            rest[(i, self.count)] = (0..self.count).map(|q| form(i, q)).sum();
        }
        rest -= &before * &lambda;
        let mut normal = &lambda * lambda.transpose();
        let mean = (0..width).map(|j| normal[(j, j)]).sum::<f64>() / width as f64;
        (0..width).for_each(|j| normal[(j, j)] += self.ridge * mean.max(f64::MIN_POSITIVE));
        let Ok(factor) = normal.llt(Side::Lower) else { return };
        let change = factor.solve(&(&lambda * rest.transpose()));
        for i in 0..rows {
            for j in 0..width {
                matrix[i * width + j] = (before[(i, j)] + change[(j, i)]) as f32;
            }
        }
    }
}

/// Rows that share probes, directly or through other rows, each group with the places of its probes in a row. Rows of
/// `probes` blocks of `k` numbers; a probe that a receiver does not use has a block of zeros.
fn connected(matrix: &[f32], probes: usize, k: usize) -> Vec<(Vec<usize>, Vec<usize>)> {
    let used: Vec<Vec<usize>> = matrix
        .chunks_exact(probes * k)
        .map(|row| (0..probes).filter(|s| row[s * k..(s + 1) * k].iter().any(|v| *v != 0.0)).collect())
        .collect();
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
        assert_eq!(connected(&matrix, 3, 2), [(vec![0, 1], vec![0, 1]), (vec![2], vec![2])]);
        // A row that uses all joins them.
        let joined = [matrix, vec![1.0; 6]].concat();
        assert_eq!(connected(&joined, 3, 2), [(vec![0, 1, 2, 4], vec![0, 1, 2])]);
    }
}
