//! Dictionary learning as another compressor: every receiver a combination of few atoms of one dictionary, instead of
//! clusters with components of their own. Partial marginal regression for the codes and the method of optimal directions for the
//! atoms (algorithms 5 to 7 of the comparison of light field probes, sparse radiance probes and light propagation volumes).
//!
//! Codes of a row: the `sparsity` atoms most correlated with it, by least squares. After the first iteration only atoms
//! that the row used before, and those most correlated with these, are candidates. Good where one scene is small; no cluster
//! borders. Fails where the matrix is sparse and large: every atom spans all columns.

use super::compress::squared_norm;
use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef, Side};
use interreflect_kernels::math::rng::hash;
use rayon::prelude::*;

/// Candidates per atom used before.
const NEIGHBOURS: usize = 8;
/// Share of the mean diagonal that is added to normal equations.
const RIDGE: f32 = 1e-5;

/// What is learnt with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DictionaryOptions {
    /// Atoms.
    pub atoms: usize,
    /// Atoms per row.
    pub sparsity: usize,
    /// Iterations of codes and atoms.
    pub iterations: u32,
}

/// A matrix as sparse codes times atoms.
#[derive(Clone, Debug)]
pub struct Dictionary {
    /// One atom per row.
    pub atoms: Mat<f32>,
    /// Atom and weight, `sparsity` per row of the matrix.
    pub codes: Vec<Vec<(u32, f32)>>,
    /// Relative error (Frobenius) after each iteration.
    pub errors: Vec<f64>,
}

impl Dictionary {
    /// Learns a dictionary of a matrix. Deterministic.
    pub fn learn(matrix: MatRef<'_, f32>, options: &DictionaryOptions) -> Self {
        let count = options.atoms.min(matrix.nrows()).max(1);
        let sparsity = options.sparsity.clamp(1, count);
        // Rows of the matrix to begin with, chosen by a hash.
        let mut rows: Vec<usize> = (0..matrix.nrows()).collect();
        rows.sort_by_key(|i| hash(*i as u32));
        let mut atoms = Mat::from_fn(count, matrix.ncols(), |i, j| matrix[(rows[i], j)]);
        let mut codes: Vec<Vec<(u32, f32)>> = Vec::new();
        let mut errors = Vec::new();
        for _ in 0..options.iterations.max(1) {
            normalize(&mut atoms);
            let gram = &atoms * atoms.transpose();
            let correlation = matrix * atoms.transpose();
            codes = regress(&gram, &correlation, &codes, sparsity);
            atoms = directions(matrix, &codes, &atoms);
            errors.push(relative_error(matrix, &atoms, &codes));
        }
        Self { atoms, codes, errors }
    }

    /// The matrix that it stands for.
    pub fn product(&self) -> Mat<f32> {
        product(&self.atoms, &self.codes)
    }

    /// Bytes with 16-bit weights, indices and atoms.
    pub fn bytes(&self) -> usize {
        2 * self.atoms.nrows() * self.atoms.ncols() + 4 * self.codes.iter().map(Vec::len).sum::<usize>()
    }
}

fn normalize(atoms: &mut Mat<f32>) {
    for i in 0..atoms.nrows() {
        let norm = (0..atoms.ncols()).map(|j| atoms[(i, j)].powi(2)).sum::<f32>().sqrt();
        let scale = if norm > 0.0 { 1.0 / norm } else { 0.0 };
        (0..atoms.ncols()).for_each(|j| atoms[(i, j)] *= scale);
    }
}

/// Partial marginal regression. Rows without a previous code consider all atoms.
fn regress(
    gram: &Mat<f32>,
    correlation: &Mat<f32>,
    previous: &[Vec<(u32, f32)>],
    sparsity: usize,
) -> Vec<Vec<(u32, f32)>> {
    let count = gram.nrows();
    let nearest: Vec<Vec<u32>> =
        (0..count).map(|i| largest((0..count as u32).collect(), NEIGHBOURS, |j| gram[(i, j as usize)])).collect();
    let code = |row: usize| {
        let candidates = match previous.get(row) {
            Some(used) if !used.is_empty() => {
                let mut all: Vec<u32> =
                    used.iter().flat_map(|(a, _)| nearest[*a as usize].iter().chain([a])).copied().collect();
                all.sort_unstable();
                all.dedup();
                all
            }
            _ => (0..count as u32).collect(),
        };
        let chosen = largest(candidates, sparsity, |a| correlation[(row, a as usize)]);
        let n = chosen.len();
        let trace: f32 = chosen.iter().map(|a| gram[(*a as usize, *a as usize)]).sum::<f32>() / n as f32;
        let normal = Mat::from_fn(n, n, |i, j| {
            gram[(chosen[i] as usize, chosen[j] as usize)] + if i == j { RIDGE * trace.max(1e-6) } else { 0.0 }
        });
        let right = Mat::from_fn(n, 1, |i, _| correlation[(row, chosen[i] as usize)]);
        let Ok(factor) = normal.llt(Side::Lower) else { return Vec::new() };
        let weights = factor.solve(&right);
        chosen.iter().enumerate().map(|(i, a)| (*a, weights[(i, 0)])).collect()
    };
    (0..correlation.nrows()).into_par_iter().map(code).collect()
}

/// The `n` candidates of largest magnitude, in ascending order.
fn largest(mut candidates: Vec<u32>, n: usize, value: impl Fn(u32) -> f32) -> Vec<u32> {
    let by = |a: &u32, b: &u32| value(*b).abs().total_cmp(&value(*a).abs()).then(a.cmp(b));
    if candidates.len() > n {
        candidates.select_nth_unstable_by(n, by);
        candidates.truncate(n);
    }
    candidates.sort_unstable();
    candidates
}

/// Method of optimal directions: the atoms that fit the codes best. Atoms that no row uses stay.
fn directions(matrix: MatRef<'_, f32>, codes: &[Vec<(u32, f32)>], atoms: &Mat<f32>) -> Mat<f32> {
    let count = atoms.nrows();
    let mut normal = Mat::<f32>::zeros(count, count);
    let mut right = Mat::<f32>::zeros(count, matrix.ncols());
    for code in codes {
        for (a, x) in code {
            code.iter().for_each(|(b, y)| normal[(*a as usize, *b as usize)] += x * y);
        }
    }
    // Column by column, as the matrix lies in memory.
    for j in 0..matrix.ncols() {
        for (row, code) in codes.iter().enumerate() {
            let value = matrix[(row, j)];
            code.iter().for_each(|(a, x)| right[(*a as usize, j)] += x * value);
        }
    }
    let mean = (0..count).map(|i| normal[(i, i)]).sum::<f32>() / count as f32;
    for i in 0..count {
        // Towards the atom as it was, where the codes say little of it.
        let ridge = RIDGE * mean.max(1e-12);
        normal[(i, i)] += ridge;
        (0..matrix.ncols()).for_each(|j| right[(i, j)] += ridge * atoms[(i, j)]);
    }
    match normal.llt(Side::Lower) {
        Ok(factor) => factor.solve(&right),
        Err(_) => atoms.clone(),
    }
}

fn product(atoms: &Mat<f32>, codes: &[Vec<(u32, f32)>]) -> Mat<f32> {
    Mat::from_fn(codes.len(), atoms.ncols(), |i, j| codes[i].iter().map(|(a, w)| w * atoms[(*a as usize, j)]).sum())
}

fn relative_error(matrix: MatRef<'_, f32>, atoms: &Mat<f32>, codes: &[Vec<(u32, f32)>]) -> f64 {
    let rest = matrix - product(atoms, codes);
    (squared_norm(rest.as_ref()) / squared_norm(matrix).max(f64::MIN_POSITIVE)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use interreflect_kernels::math::rng::rand;

    #[test]
    fn sparse_combinations_are_found_again() {
        // 400 rows, each two of 24 well separated atoms.
        let (rows, columns, count) = (400usize, 96usize, 24usize);
        let truth =
            Mat::from_fn(count, columns, |i, j| if j / 4 == i { 1.0 + rand(1, i as u32, j as u32) } else { 0.0 });
        let pick = |row: usize, n: u32| (hash(row as u32 * 2 + n) % count as u32) as usize;
        let matrix = Mat::from_fn(rows, columns, |i, j| {
            truth[(pick(i, 0), j)] + (0.5 + rand(2, i as u32, 0)) * truth[(pick(i, 1), j)]
        });
        let options = DictionaryOptions { atoms: 64, sparsity: 6, iterations: 20 };
        let learnt = Dictionary::learn(matrix.as_ref(), &options);
        let (first, last) = (learnt.errors[0], *learnt.errors.last().unwrap());
        println!("relative error {first:.4} at first, {last:.4} at last");
        assert!(last < 0.5 * first && last < 0.2, "{:?}", learnt.errors);
        assert!(learnt.codes.iter().all(|c| c.len() == 6));
        assert_eq!(learnt.bytes(), 2 * 64 * 96 + 4 * 6 * 400);
        // As many atoms as rows: each row is one of them.
        let all = Dictionary::learn(matrix.as_ref(), &DictionaryOptions { atoms: 400, sparsity: 1, iterations: 1 });
        assert!(all.errors[0] < 0.02, "{:?}", all.errors);
    }
}
