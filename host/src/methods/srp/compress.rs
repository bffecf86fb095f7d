//! Clustered principal component analysis (Sloan, Hall, Hart & Snyder 2003; SL17 eq. 11): a cluster's transport matrix as
//! `U (Σ Vᵀ)` of few components.
//!
//! **Metric.** Where lights are given, what counts is not the matrix `T` but what it makes of light: `T L`, with a column of
//! `L` per light. The components are the singular vectors `U` of `T L`, and the projection is `Uᵀ T`. What no light can ask
//! of the matrix (high bands of far probes, mostly) then takes no components, at the same error of irradiance.
//!
//! The truncated singular value decomposition is the randomized one of Halko, Martinsson & Tropp 2011 (algorithms 4.4 and
//! 5.1): a random range finder with power iterations, then a small exact decomposition; `exact` checks it in tests. The
//! rank is the smallest that keeps the relative error `‖T − U Σ Vᵀ‖ / ‖T‖` (Frobenius) under the threshold; where the
//! largest rank does not, the cluster is halved like the first clusters were (adaptive refinement), while that can
//! save memory at all.
//!
//! **Threshold.** The error asked for, or the cluster's own noise where that is more: `T` comes from finitely many rays, and
//! what two halves of them disagree on ([`super::transport::Estimate::Noise`]) is not worth components.

use super::dictionary::{Dictionary, DictionaryOptions};
use super::model::{Cluster, Loss};
use super::plan::halve;
use faer::{Mat, MatRef};
use glam::Vec3;
use interreflect_kernels::math::rng::rand;

/// Columns of the random range beyond the rank.
const OVERSAMPLING: usize = 10;
/// Power iterations: each multiplies the separation of singular values.
const POWER_ITERATIONS: usize = 2;
/// Clusters of fewer receivers are not halved: a component of the projection is then shared by too few.
const SMALLEST_CLUSTER: usize = 128;

/// How transport is compressed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Compression {
    /// Not at all.
    None,
    /// Principal components per cluster.
    Cpca {
        /// Relative error at which to stop (SL17: 0.005).
        error: f32,
        /// Most components (SL17: 32).
        max_rank: u32,
        /// Also stop where the error is this many times what the transport errs by because its rays are finite in number:
        /// components beyond that hold noise. 0: not. Not in the papers.
        noise: f32,
    },
    /// A learnt dictionary per cluster ([`super::dictionary`]).
    Dictionary {
        /// Atoms of a cluster.
        atoms: u32,
        /// Atoms of a row.
        sparsity: u32,
    },
}

/// Iterations of learning a dictionary.
const DICTIONARY_ITERATIONS: u32 = 6;

/// What compression is judged by: coefficients of the cluster's probes, a row per column of its matrix.
#[derive(Clone, Debug)]
pub struct Lights {
    /// Lights whose effect is to be kept; none: the matrix itself is.
    pub metric: Option<Mat<f64>>,
    /// Lights by which [`Loss::light`] is measured.
    pub test: Mat<f64>,
}

impl Default for Compression {
    fn default() -> Self {
        Self::Cpca { error: 0.005, max_rank: 32, noise: 0.5 }
    }
}

/// A truncated decomposition.
#[derive(Clone, Debug)]
pub struct Factors {
    /// Orthonormal columns.
    pub u: Mat<f32>,
    /// Σ Vᵀ.
    pub sv: Mat<f32>,
    /// Singular values, descending.
    pub singular: Vec<f32>,
    /// `‖T − U Σ Vᵀ‖ / ‖T‖`, 0 for a zero matrix.
    pub error: f64,
}

/// The transport of one cluster.
#[derive(Clone, Copy, Debug)]
pub struct Block<'a> {
    /// Rows of `probes.len() · k` coefficients: `rows` for each of the points, then as many for each of the witnesses, which say
    /// what may be chance in theirs.
    pub matrix: &'a [f32],
    /// Places of the receivers (m).
    pub points: &'a [Vec3],
    /// Rows per receiver.
    pub rows: usize,
    /// Probes in support.
    pub probes: &'a [u32],
    /// Coefficients per probe.
    pub k: usize,
    /// Receivers whose noise is known, ascending.
    pub witnesses: &'a [usize],
    /// What compression is judged by.
    pub lights: &'a Lights,
}

impl Block<'_> {
    /// Compresses it. Gives the parts that it was halved into, each with its points. `receivers` of the clusters are left empty.
    pub fn compressed(&self, compression: &Compression) -> Vec<(Vec<u32>, Cluster)> {
        self.compress((0..self.points.len() as u32).collect(), compression)
    }

    fn compress(&self, members: Vec<u32>, compression: &Compression) -> Vec<(Vec<u32>, Cluster)> {
        let columns = self.columns(&members);
        let dense = self.dense(&members, &columns);
        let height = members.len() * self.rows;
        let view = MatRef::from_row_major_slice(&dense, height, columns.len());
        let noise = self.noise(view, &members, &columns);
        let factors = match *compression {
            Compression::None => {
                let (rank, left) = (columns.len(), dense.clone());
                return vec![(
                    members,
                    self.cluster(&columns, rank, Vec::new(), left, Loss { noise, ..Loss::default() }),
                )];
            }
            Compression::Cpca { error, max_rank, noise: stop } => {
                let error = f64::from(error.max(stop * noise));
                let factors = self.components(view, &columns, max_rank as usize, error);
                if factors.error > error && members.len() >= 2 * SMALLEST_CLUSTER {
                    let (near, far) = halve(members, |i| self.points[i as usize]);
                    let mut parts = self.compress(near, compression);
                    parts.extend(self.compress(far, compression));
                    return parts;
                }
                factors
            }
            Compression::Dictionary { atoms, sparsity } => dictionary(view, atoms as usize, sparsity as usize),
        };
        let light = self.light_error(view, &factors, &columns) as f32;
        let loss = Loss { transport: factors.error as f32, light, noise };
        let (sv, u) = (row_major(factors.sv.as_ref()), row_major(factors.u.as_ref()));
        vec![(members, self.cluster(&columns, factors.u.ncols(), sv, u, loss))]
    }

    fn cluster(&self, columns: &[usize], rank: usize, sv: Vec<f32>, u: Vec<f32>, loss: Loss) -> Cluster {
        let (probes, columns) = self.name(columns);
        let rank = rank as u32;
        Cluster { receivers: 0..0, probes, columns, rank, projection: sv, reconstruction: u, loss }
    }

    /// Components of the matrix in the metric of the lights, or in its own.
    fn components(&self, a: MatRef<'_, f32>, columns: &[usize], max_rank: usize, error: f64) -> Factors {
        let Some(lights) = &self.lights.metric else { return truncated(a, max_rank, error) };
        let a = Mat::from_fn(a.nrows(), a.ncols(), |i, j| f64::from(a[(i, j)]));
        let lit = &a * rows_of(lights, columns);
        let lit = Mat::from_fn(lit.nrows(), lit.ncols(), |i, j| lit[(i, j)] as f32);
        let factors = truncated(lit.as_ref(), max_rank, error);
        let u = Mat::from_fn(factors.u.nrows(), factors.u.ncols(), |i, j| f64::from(factors.u[(i, j)]));
        let sv = u.transpose() * &a;
        Factors { sv: Mat::from_fn(sv.nrows(), sv.ncols(), |i, j| sv[(i, j)] as f32), ..factors }
    }

    /// What may be chance in the matrix, relative to all of it, in the metric of [`Block::components`]. 0 without witnesses.
    fn noise(&self, a: MatRef<'_, f32>, members: &[u32], columns: &[usize]) -> f32 {
        let known = |i: &u32| self.witnesses.binary_search(&(*i as usize)).ok();
        let chance: Vec<u32> = members.iter().filter_map(known).map(|w| (self.points.len() + w) as u32).collect();
        let total = self.lit_norm(a, columns);
        if chance.is_empty() || total <= 0.0 {
            return 0.0;
        }
        let dense = self.dense(&chance, columns);
        let own = MatRef::from_row_major_slice(&dense, chance.len() * self.rows, columns.len());
        let share = members.len() as f64 / chance.len() as f64;
        (self.lit_norm(own, columns) * share / total).sqrt() as f32
    }

    /// Sum of squares in the metric of the lights.
    fn lit_norm(&self, a: MatRef<'_, f32>, columns: &[usize]) -> f64 {
        let Some(lights) = &self.lights.metric else { return squared_norm(a) };
        let lights = rows_of(lights, columns);
        let lights = Mat::from_fn(lights.nrows(), lights.ncols(), |i, j| lights[(i, j)] as f32);
        squared_norm((a * lights).as_ref())
    }

    /// Relative error of what the test lights give.
    fn light_error(&self, a: MatRef<'_, f32>, factors: &Factors, columns: &[usize]) -> f64 {
        let test = rows_of(&self.lights.test, columns);
        let test = Mat::from_fn(test.nrows(), test.ncols(), |i, j| test[(i, j)] as f32);
        let (wanted, got) = (a * &test, &factors.u * (&factors.sv * &test));
        let total = squared_norm(wanted.as_ref());
        if total > 0.0 { (squared_norm((wanted - got).as_ref()) / total).sqrt() } else { 0.0 }
    }

    /// Columns that are not zero for all members.
    fn columns(&self, members: &[u32]) -> Vec<usize> {
        let width = self.probes.len() * self.k;
        let mut used = vec![false; width];
        for i in members {
            let block = &self.matrix[*i as usize * self.rows * width..][..self.rows * width];
            block.iter().enumerate().filter(|(_, x)| **x != 0.0).for_each(|(c, _)| used[c % width] = true);
        }
        (0..width).filter(|c| used[*c]).collect()
    }

    fn dense(&self, members: &[u32], columns: &[usize]) -> Vec<f32> {
        let width = self.probes.len() * self.k;
        let rows = members.iter().flat_map(|i| (0..self.rows).map(move |r| *i as usize * self.rows + r));
        rows.flat_map(|row| columns.iter().map(move |c| self.matrix[row * width + c])).collect()
    }

    /// Probes that are left, and the columns in terms of them.
    fn name(&self, columns: &[usize]) -> (Vec<u32>, Vec<(u32, u32)>) {
        let mut slots: Vec<usize> = columns.iter().map(|c| c / self.k).collect();
        slots.dedup();
        let place = |c: &usize| (slots.partition_point(|s| *s < c / self.k) as u32, (c % self.k) as u32);
        (slots.iter().map(|s| self.probes[*s]).collect(), columns.iter().map(place).collect())
    }
}

fn rows_of(m: &Mat<f64>, rows: &[usize]) -> Mat<f64> {
    Mat::from_fn(rows.len(), m.ncols(), |i, j| m[(rows[i], j)])
}

/// Atoms and codes in the place of components.
fn dictionary(a: MatRef<'_, f32>, atoms: usize, sparsity: usize) -> Factors {
    if a.nrows() == 0 || a.ncols() == 0 {
        return Factors { u: Mat::zeros(a.nrows(), 0), sv: Mat::zeros(0, a.ncols()), singular: Vec::new(), error: 0.0 };
    }
    let learnt = Dictionary::learn(a, &DictionaryOptions { atoms, sparsity, iterations: DICTIONARY_ITERATIONS });
    let mut u = Mat::zeros(a.nrows(), learnt.atoms.nrows());
    for (row, code) in learnt.codes.iter().enumerate() {
        code.iter().for_each(|(atom, weight)| u[(row, *atom as usize)] = *weight);
    }
    let error = learnt.errors.last().copied().unwrap_or(1.0);
    Factors { u, sv: learnt.atoms, singular: Vec::new(), error }
}

fn row_major(m: MatRef<'_, f32>) -> Vec<f32> {
    (0..m.nrows()).flat_map(|i| (0..m.ncols()).map(move |j| m[(i, j)])).collect()
}

/// Decomposition of the smallest rank, at most `max_rank`, whose relative error is at most `error`. In double precision:
/// the error is what differs between two nearly equal sums of squares.
pub fn truncated(a: MatRef<'_, f32>, max_rank: usize, error: f64) -> Factors {
    let (m, n) = (a.nrows(), a.ncols());
    let full = m.min(n);
    let width = (max_rank + OVERSAMPLING).min(full);
    if full == 0 {
        return Factors { u: Mat::zeros(m, 0), sv: Mat::zeros(0, n), singular: Vec::new(), error: 0.0 };
    }
    let a = Mat::from_fn(m, n, |i, j| f64::from(a[(i, j)]));
    // A range that holds the first singular vectors, kept orthonormal between iterations.
    let random = Mat::from_fn(n, width, |i, j| f64::from(2.0 * rand(1, i as u32, j as u32) - 1.0));
    let mut range = orthonormal(&a * &random);
    for _ in 0..POWER_ITERATIONS {
        let back = orthonormal(a.transpose() * &range);
        range = orthonormal(&a * &back);
    }
    let small = range.transpose() * &a;
    decompose(small.as_ref(), Some(&range), a.squared_norm_l2(), max_rank, error)
}

/// The same from the full decomposition.
pub fn exact(a: MatRef<'_, f32>, max_rank: usize, error: f64) -> Factors {
    let a = Mat::from_fn(a.nrows(), a.ncols(), |i, j| f64::from(a[(i, j)]));
    decompose(a.as_ref(), None, a.squared_norm_l2(), max_rank, error)
}

/// Full decomposition of `a`, cut off; its rows are coordinates in `range` where that is given. `total`: squared norm of the
/// matrix that `a` came from.
fn decompose(a: MatRef<'_, f64>, range: Option<&Mat<f64>>, total: f64, max_rank: usize, error: f64) -> Factors {
    // Of the taller shape, which the decomposition prefers.
    let wide = a.ncols() > a.nrows();
    let svd = if wide { a.transpose().thin_svd() } else { a.thin_svd() };
    let height = range.map_or(a.nrows(), Mat::nrows);
    let Ok(svd) = svd else {
        return Factors { u: Mat::zeros(height, 0), sv: Mat::zeros(0, a.ncols()), singular: Vec::new(), error: 1.0 };
    };
    let (left, right) = if wide { (svd.V(), svd.U()) } else { (svd.U(), svd.V()) };
    let s = svd.S().column_vector();
    let relative = |kept: f64| if total > 0.0 { ((total - kept) / total).max(0.0).sqrt() } else { 0.0 };
    let (mut kept, mut rank) = (0.0, 0);
    while rank < max_rank.min(s.nrows()) && relative(kept) > error {
        kept += s[rank] * s[rank];
        rank += 1;
    }
    let left = left.subcols(0, rank);
    let u = range.map_or_else(|| left.to_owned(), |range| range * left);
    Factors {
        u: Mat::from_fn(height, rank, |i, j| u[(i, j)] as f32),
        sv: Mat::from_fn(rank, a.ncols(), |i, j| (s[i] * right[(j, i)]) as f32),
        singular: (0..s.nrows()).map(|i| s[i] as f32).collect(),
        error: relative(kept),
    }
}

fn orthonormal(m: Mat<f64>) -> Mat<f64> {
    m.qr().compute_thin_Q()
}

/// Sum of squares.
pub fn squared_norm(a: MatRef<'_, f32>) -> f64 {
    (0..a.ncols()).map(|j| (0..a.nrows()).map(|i| f64::from(a[(i, j)]).powi(2)).sum::<f64>()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A matrix of known singular values `0.6^k`, as smooth transport has them.
    fn smooth(m: usize, n: usize) -> Mat<f32> {
        let random = |seed, i, j| f64::from(rand(seed, i as u32, j as u32)) - 0.5;
        let q = |rows, seed| orthonormal(Mat::from_fn(rows, 60, |i, j| random(seed, i, j)));
        let (u, v) = (q(m, 2), q(n, 3));
        let scaled = Mat::from_fn(m, 60, |i, j| u[(i, j)] * 0.6f64.powi(j as i32));
        let product = scaled * v.transpose();
        Mat::from_fn(m, n, |i, j| product[(i, j)] as f32)
    }

    #[test]
    fn randomized_agrees_with_exact() {
        let a = smooth(300, 500);
        let total = squared_norm(a.as_ref());
        for (max_rank, error) in [(32, 0.0048), (8, 0.0), (60, 1e-3)] {
            let (fast, slow) = (truncated(a.as_ref(), max_rank, error), exact(a.as_ref(), max_rank, error));
            assert_eq!(fast.u.ncols(), slow.u.ncols());
            assert!((fast.error - slow.error).abs() < 2e-4, "{} {}", fast.error, slow.error);
            for k in 0..fast.u.ncols() {
                let relative = (fast.singular[k] / slow.singular[k] - 1.0).abs();
                assert!(relative < 1e-3, "singular value {k}: {relative}");
            }
            let rest = &a - &fast.u * &fast.sv;
            let left = (squared_norm(rest.as_ref()) / total).sqrt();
            assert!((left - fast.error).abs() < 2e-4, "residual {left}, said {}", fast.error);
        }
    }

    #[test]
    fn components_end_where_noise_begins() {
        // Five components and noise, which is known of every eighth row by other noise of the same size.
        let (count, k, size) = (256usize, 64usize, 0.3f32);
        let random = |seed, i: usize, j: usize| rand(seed, i as u32, j as u32) - 0.5;
        let signal = |i: usize, c: usize| (0..5).map(|r| random(31, i, r) * random(32, c, r)).sum::<f32>() * 2.0;
        let mut matrix: Vec<f32> =
            (0..count * k).map(|n| signal(n / k, n % k) + size * random(33, n / k, n % k)).collect();
        let norm = |f: &dyn Fn(usize, usize) -> f32| {
            (0..count * k).map(|n| f64::from(f(n / k, n % k)).powi(2)).sum::<f64>().sqrt()
        };
        let true_noise = norm(&|i, c| size * random(33, i, c)) / norm(&|i, c| matrix[i * k + c]);
        let witnesses: Vec<usize> = (0..count).step_by(8).collect();
        matrix.extend((0..witnesses.len() * k).map(|n| size * random(34, n / k, n % k)));
        let points: Vec<Vec3> = (0..count).map(|i| Vec3::new(i as f32, 0.0, 0.0)).collect();
        let lights = Lights { metric: None, test: Mat::from_fn(k, 1, |_, _| 1.0) };
        let block = Block {
            matrix: &matrix,
            points: &points,
            rows: 1,
            probes: &[0],
            k,
            witnesses: &witnesses,
            lights: &lights,
        };
        let parts = block.compressed(&Compression::Cpca { error: 0.005, max_rank: 32, noise: 1.0 });
        assert_eq!(parts.len(), 1);
        let cluster = &parts[0].1;
        assert!((f64::from(cluster.loss.noise) / true_noise - 1.0).abs() < 0.1, "{:?} {true_noise}", cluster.loss);
        assert_eq!(cluster.rank, 5);
        let rank = cluster.rank as usize;
        let made = |i: usize, c: usize| -> f32 {
            (0..rank).map(|r| cluster.reconstruction[i * rank + r] * cluster.projection[r * k + c]).sum()
        };
        // Noise that no component holds is gone.
        let left = norm(&|i, c| made(i, c) - signal(i, c)) / norm(&|i, c| size * random(33, i, c));
        assert!(left < 0.5, "{left}");
        // By its own error alone it would be halved, and still take all it may.
        let all = block.compressed(&Compression::Cpca { error: 0.005, max_rank: 32, noise: 0.0 });
        assert!(all.len() == 2 && all.iter().all(|p| p.1.rank == 32), "{}", all.len());
    }

    #[test]
    fn ranks_suffice_and_clusters_that_need_more_are_halved() {
        // Two halves of the points, some way apart, that see two different probes, each of 20 directions.
        let (count, k) = (600usize, 36usize);
        let far = |i: usize| if i < count / 2 { 0.0 } else { 20.0 };
        let points: Vec<Vec3> = (0..count).map(|i| Vec3::new(i as f32 + far(i), 0.0, 0.0)).collect();
        let mut matrix = vec![0.0; count * 2 * k];
        for i in 0..count {
            let probe = usize::from(i >= count / 2);
            for c in 0..20 {
                matrix[(i * 2 + probe) * k + c] = rand(7, i as u32, c as u32) - 0.5;
            }
        }
        let lights =
            Lights { metric: None, test: Mat::from_fn(2 * k, 3, |i, j| f64::from(rand(8, i as u32, j as u32))) };
        let pack = |c: &Compression, lights: &Lights| {
            Block { matrix: &matrix, points: &points, rows: 1, probes: &[4, 9], k, witnesses: &[], lights }
                .compressed(c)
        };
        let cpca = Compression::Cpca { error: 1e-3, max_rank: 32, noise: 0.5 };
        let parts = pack(&cpca, &lights);
        assert_eq!(parts.len(), 2);
        let mut seen = vec![false; count];
        for (members, cluster) in &parts {
            assert!(cluster.loss.transport <= 1e-3 && cluster.loss.light < 2e-3, "{:?}", cluster.loss);
            assert_eq!((cluster.rank, cluster.columns.len(), cluster.probes.len()), (20, 20, 1));
            for (row, i) in members.iter().enumerate() {
                seen[*i as usize] = true;
                for (c, (slot, coefficient)) in cluster.columns.iter().enumerate() {
                    let u = &cluster.reconstruction[row * 20..][..20];
                    let value: f32 = (0..20).map(|r| u[r] * cluster.projection[r * 20 + c]).sum();
                    let probe = if cluster.probes[*slot as usize] == 4 { 0 } else { 1 };
                    let wanted = matrix[(*i as usize * 2 + probe) * k + *coefficient as usize];
                    assert!((value - wanted).abs() < 1e-3, "{value} {wanted}");
                }
            }
        }
        assert!(seen.iter().all(|s| *s));
        // Uncompressed: the same matrix again, without its zero columns.
        let plain = pack(&Compression::None, &lights);
        assert_eq!((plain.len(), plain[0].1.rank, plain[0].1.projection.len()), (1, 40, 0));
        // Three lights can ask for three components of each half.
        let metric = Some(lights.test.clone());
        let lit = pack(&cpca, &Lights { metric, ..lights.clone() });
        assert_eq!((lit.len(), lit[0].1.rank), (1, 3));
        assert!(lit[0].1.loss.light < 1e-3, "{:?}", lit[0].1.loss);
        // As many atoms as rows lose nothing; few do.
        let learnt = |atoms| pack(&Compression::Dictionary { atoms, sparsity: 4 }, &lights)[0].1.clone();
        assert!(learnt(600).loss.transport < 0.05 && learnt(32).loss.transport > 0.1);
        assert!(learnt(32).f16_bytes() < learnt(600).f16_bytes());
    }
}
