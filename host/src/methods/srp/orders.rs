//! Which bands of each probe a cluster's transport keeps: the order per probe.
//!
//! Far probes light a receiver from a small solid angle, probes at the rim of their support by a small weight: what their
//! high bands bring is lost among what the others bring. The measure is that of [`super::compress`]: `T L`, what transport
//! makes of the lights. Probe `p` loses the bands from `n` on whose part of the light, `‖T_{p,≥n} L_{p,≥n}‖ / ‖T L‖`
//! (Frobenius), stays below a threshold, which is the same for all probes and the largest, in steps, at which all that is left
//! out together, `‖Σ_p T_{p,≥n_p} L_{p,≥n_p}‖ / ‖T L‖`, stays within the share asked for. Receivers that have no probe in
//! common, as on the two sides of a wall, are judged apart: light on one side is no reason to leave the other dark. A probe
//! may lose all bands, but not where it is the one that brings a receiver most: no receiver goes dark for being few.
//!
//! Whole bands only, so that the axes of the basis decide nothing. Run time reads columns in vectors of 16 (`srp_cluster`): a
//! probe keeps all bands that fill the vectors which it needs anyway, order 3 of one, 4 of two, 5 of three, 7 of four. Not in
//! the papers, which give all probes of a scene one order.
//!
//! Before [`super::round_trip`], whose correction then makes the best of the bands that are left; it is also quicker with fewer.
//! After it, a share of 0.02 saves half as much in the Cornell box for twice the error.
//!
//! **The share.** 128×128 pixels, all else by default, for shares of 0, 0.01, 0.02 and 0.05: `nrmse_block` in the Cornell box
//! 0.0209, 0.0217, 0.0223, 0.0242 with 1.80, 0.72, 0.56, 0.37 MB of projection matrices; with louvres 0.0400, 0.0368, 0.0370,
//! 0.0389 with 2.35, 1.04, 0.90, 0.59 MB; in a modern hall 0.1465, 0.1470, 0.1490 (0 to 0.02) with 2.73, 1.29, 1.13 MB. The
//! worst receiver of a furnace of albedo 0.8 is off by 0.0195 without, by 0.0204 with 0.01, the mean by 0.0004. By default half of
//! that, 0.005: the worst receiver stays within 0.02.

use super::compress::{Lights, squared_norm};
use super::model::{Cluster, SrpBake};
use super::round_trip::connected;
use faer::Mat;
use interreflect_kernels::math::sh;
use interreflect_shared::srp::SRP_LANES;
use rayon::prelude::*;
use std::f64::consts::FRAC_1_SQRT_2;

/// Transport of a cluster from all coefficients of its probes.
pub(super) struct Whole<'a> {
    /// Rows of `probes · (order + 1)²` numbers, `each` for every receiver, then others that are to lose the same columns.
    pub matrix: &'a mut [f32],
    /// Number of receivers.
    pub receivers: usize,
    /// Rows of each.
    pub each: usize,
    /// Number of probes.
    pub probes: usize,
    /// Order of their spherical harmonics.
    pub order: u32,
}

/// What was left out of some clusters' transport.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct LeftOut {
    /// Square of the light that all bands bring, in the metric of the choice.
    pub light: f32,
    /// Square of what those bring that were left out.
    pub left_out: f32,
    /// Columns of all bands.
    pub columns: u32,
    /// Columns that were left out.
    pub columns_left_out: u32,
    /// Bytes of the projection matrices that they would take as 16-bit floats, at the ranks that were found without them.
    pub bytes: u32,
}

impl std::ops::Add for LeftOut {
    type Output = Self;

    fn add(self, b: Self) -> Self {
        Self {
            light: self.light + b.light,
            left_out: self.left_out + b.left_out,
            columns: self.columns + b.columns,
            columns_left_out: self.columns_left_out + b.columns_left_out,
            bytes: self.bytes.saturating_add(b.bytes),
        }
    }
}

impl Whole<'_> {
    /// Sets the columns of the bands to zero that bring no more than the `share` of what reaches the receivers; all are kept
    /// for a share of 0. Gives the squares of [`LeftOut`], its counts are 0.
    pub fn truncate(&mut self, lights: &Lights, share: f32) -> LeftOut {
        let mut sum = LeftOut::default();
        if share <= 0.0 || self.matrix.is_empty() || self.probes == 0 {
            return sum;
        }
        let (k, width, each) = (sh::count(self.order), self.width(), self.each);
        let own = &self.matrix[..self.receivers * self.each * width];
        let mut kept = vec![self.order + 1; self.probes];
        for (receivers, slots) in connected(own, self.probes, k, each) {
            let rows: Vec<usize> = receivers.iter().flat_map(|r| (0..each).map(move |n| r * each + n)).collect();
            let group = Group::new(self, &rows, &slots, lights);
            let (bands, left_out) = group.choose(f64::from(share));
            slots.iter().zip(bands).for_each(|(slot, bands)| kept[*slot] = bands);
            sum = sum + LeftOut { light: group.light as f32, left_out: left_out as f32, ..LeftOut::default() };
        }
        self.matrix.par_chunks_exact_mut(width).for_each(|row| {
            row.chunks_exact_mut(k).zip(&kept).for_each(|(own, bands)| own[columns(*bands)..].fill(0.0));
        });
        sum
    }

    fn width(&self) -> usize {
        self.probes * sh::count(self.order)
    }

    /// Whether each receiver is lit by each probe, `[receiver][probe]`.
    pub fn support(&self) -> Vec<Vec<bool>> {
        let k = sh::count(self.order);
        let lit = |own: &[f32]| {
            let mut support = vec![false; self.probes];
            for row in own.chunks_exact(self.width()) {
                support.iter_mut().zip(row.chunks_exact(k)).for_each(|(s, own)| *s |= own.iter().any(|x| *x != 0.0));
            }
            support
        };
        let rows = self.each * self.width().max(1);
        self.matrix[..self.receivers * self.each * self.width()].par_chunks_exact(rows).map(lit).collect()
    }
}

impl LeftOut {
    /// Counts what a cluster of some receivers lacks of the coefficients, `k` each, of the probes that supported them.
    pub(super) fn count(support: &[Vec<bool>], members: &[u32], k: usize, cluster: &Cluster) -> Self {
        let probes = support.first().map_or(0, Vec::len);
        let supports = |p: &usize| members.iter().any(|m| support[*m as usize][*p]);
        let columns = (0..probes).filter(supports).count() * k;
        let columns_left_out = columns - cluster.columns.len().min(columns);
        // Without compression every row of the reconstruction has them.
        let rows = if cluster.projection.is_empty() {
            cluster.reconstruction.len() / cluster.columns.len().max(1)
        } else {
            cluster.rank as usize
        };
        let bytes = 2 * rows * columns_left_out;
        Self {
            columns: columns as u32,
            columns_left_out: columns_left_out as u32,
            bytes: u32::try_from(bytes).unwrap_or(u32::MAX),
            ..Self::default()
        }
    }
}

/// What the probes' orders are and what they leave out, for reports. Counts of probes by order, from 0 on, those of which no
/// band is kept apart; a probe of the scene has the highest order that it has in any cluster.
pub(super) fn report(bake: &SrpBake, order: u32, share: f32, left: &LeftOut) -> serde_json::Value {
    let mut highest: Vec<Option<u32>> = vec![None; bake.probes.len()];
    let mut in_clusters = vec![0u32; order as usize + 1];
    for cluster in &bake.clusters {
        let mut own: Vec<Option<u32>> = vec![None; cluster.probes.len()];
        cluster.columns.iter().for_each(|(slot, c)| own[*slot as usize] = Some(sh::band(*c as usize)));
        for (probe, own) in cluster.probes.iter().zip(own) {
            own.into_iter().for_each(|l| in_clusters[l as usize] += 1);
            highest[*probe as usize] = highest[*probe as usize].max(own);
        }
    }
    let mut probes = vec![0u32; order as usize + 1];
    highest.iter().flatten().for_each(|l| probes[*l as usize] += 1);
    serde_json::json!({
        "allowed": share,
        "left_out": (left.left_out / left.light.max(f32::MIN_POSITIVE)).sqrt(),
        "probes": probes,
        "probes_unused": highest.iter().filter(|h| h.is_none()).count(),
        "probes_in_clusters": in_clusters,
        "highest": bake.order,
        "columns": left.columns,
        "columns_left_out": left.columns_left_out,
        "bytes_left_out": left.bytes,
    })
}

/// The lowest order that holds all bands of which any cluster makes something, at least `least`.
pub(super) fn highest(bake: &SrpBake, least: u32) -> u32 {
    let columns = bake.clusters.iter().flat_map(|c| &c.columns);
    columns.map(|(_, c)| sh::band(*c as usize)).fold(least, u32::max)
}

/// Coefficients of so many bands.
fn columns(bands: u32) -> usize {
    (bands * bands) as usize
}

/// Numbers of bands to choose from, ascending: none, all, and the most that fill a number of vectors.
fn choices(order: u32) -> Vec<u32> {
    let vectors = |bands: u32| (bands * bands).div_ceil(SRP_LANES);
    (0..=order + 1).filter(|n| *n == 0 || *n == order + 1 || vectors(*n) < vectors(n + 1)).collect()
}

/// Receivers that share probes, with these.
struct Group {
    probes: Vec<Probe>,
    choices: Vec<u32>,
    /// Square of the light that all of them bring.
    light: f64,
}

/// One probe's transport to a group.
struct Probe {
    transport: Mat<f32>,
    /// Its coefficients in the lights; without, every number of the transport counts by itself.
    lights: Option<Mat<f32>>,
    /// By choice: the square of what the bands bring that it leaves out.
    beyond: Vec<f64>,
    /// The first choice that it may come to.
    least: usize,
}

impl Group {
    fn new(whole: &Whole<'_>, rows: &[usize], slots: &[usize], lights: &Lights) -> Self {
        let (k, width, choices) = (sh::count(whole.order), whole.width(), choices(whole.order));
        let probe = |slot: &usize| {
            let first = slot * k;
            let transport = Mat::from_fn(rows.len(), k, |i, c| whole.matrix[rows[i] * width + first + c]);
            let own = |l: &Mat<f64>| Mat::from_fn(k, l.ncols(), |c, q| l[(first + c, q)] as f32);
            let mut probe = Probe { transport, lights: lights.metric.as_ref().map(own), beyond: Vec::new(), least: 0 };
            let all = probe.measure(&choices);
            (probe, all)
        };
        let (mut probes, all): (Vec<Probe>, Vec<Option<Mat<f32>>>) = slots.par_iter().map(probe).unzip();
        let row = |(p, all): (&Probe, &Option<Mat<f32>>)| squared_rows(all.as_ref().unwrap_or(&p.transport));
        let brings: Vec<Vec<f32>> = probes.par_iter().zip(&all).map(row).collect();
        for row in 0..rows.len() {
            let most = (0..probes.len()).max_by(|a, b| brings[*a][row].total_cmp(&brings[*b][row]));
            most.into_iter().for_each(|p| probes[p].least = 1);
        }
        let apart = || probes.iter().map(|p| p.beyond[0]).sum();
        let light = sum_of(all).map_or_else(apart, |sum| squared_norm(sum.as_ref()));
        Self { probes, choices, light }
    }

    /// Bands that each probe keeps, and the square of the light that is left out.
    fn choose(&self, share: f64) -> (Vec<u32>, f64) {
        let allowed = share * share * self.light;
        let mut threshold = share;
        // At this threshold all that is left out is within the share whatever it is: a sum is no longer than its parts together.
        let last = share / self.probes.len().max(1) as f64;
        while threshold > last {
            let (chosen, apart) = self.at(threshold);
            if apart <= allowed {
                let left_out = self.left_out(&chosen);
                if left_out <= allowed {
                    return (self.bands(&chosen), left_out);
                }
            }
            threshold *= FRAC_1_SQRT_2;
        }
        let (chosen, _) = self.at(last);
        (self.bands(&chosen), self.left_out(&chosen))
    }

    /// The choice of each probe for a threshold, and the sum of squares of what each leaves out.
    fn at(&self, threshold: f64) -> (Vec<usize>, f64) {
        let most = threshold * threshold * self.light;
        let choice =
            |p: &Probe| p.beyond.iter().position(|b| *b <= most).unwrap_or(self.choices.len() - 1).max(p.least);
        let chosen: Vec<usize> = self.probes.iter().map(choice).collect();
        let apart = self.probes.iter().zip(&chosen).map(|(p, c)| p.beyond[*c]).sum();
        (chosen, apart)
    }

    fn bands(&self, chosen: &[usize]) -> Vec<u32> {
        chosen.iter().map(|c| self.choices[*c]).collect()
    }

    /// Square of the light that all probes together leave out.
    fn left_out(&self, chosen: &[usize]) -> f64 {
        let last = self.choices.len() - 1;
        let beyond = |(p, c): (&Probe, &usize)| p.light(self.choices[*c], self.choices[last]);
        let parts = self.probes.par_iter().zip(chosen).map(beyond).collect();
        let apart = || self.probes.iter().zip(chosen).map(|(p, c)| p.beyond[*c]).sum();
        sum_of(parts).map_or_else(apart, |sum| squared_norm(sum.as_ref()))
    }
}

impl Probe {
    /// Measures what each of the choices leaves out; gives the light of all bands.
    fn measure(&mut self, choices: &[u32]) -> Option<Mat<f32>> {
        let mut sum: Option<Mat<f32>> = None;
        self.beyond = vec![0.0; choices.len()];
        for (at, ends) in choices.windows(2).enumerate().rev() {
            let part = self.light(ends[0], ends[1]);
            sum = sum_of(vec![part, sum]);
            let apart = || {
                let first = columns(ends[0]);
                squared_norm(self.transport.subcols(first, columns(ends[1]) - first)) + self.beyond[at + 1]
            };
            self.beyond[at] = sum.as_ref().map_or_else(apart, |sum| squared_norm(sum.as_ref()));
        }
        sum
    }

    /// What the bands from the first to before the end bring: a row per row of transport, a column per light. `None` without
    /// such bands, or without lights.
    fn light(&self, first: u32, end: u32) -> Option<Mat<f32>> {
        let (first, end) = (columns(first), columns(end));
        let lights = self.lights.as_ref().filter(|_| first < end)?;
        Some(self.transport.subcols(first, end - first) * lights.subrows(first, end - first))
    }
}

/// Sum of squares of each row.
fn squared_rows(m: &Mat<f32>) -> Vec<f32> {
    (0..m.nrows()).map(|i| (0..m.ncols()).map(|j| m[(i, j)].powi(2)).sum()).collect()
}

/// Sum of matrices; none where there is none.
fn sum_of(parts: Vec<Option<Mat<f32>>>) -> Option<Mat<f32>> {
    // One after the other: the same bits on any number of threads.
    parts.into_iter().flatten().reduce(|sum, part| sum + part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use interreflect_kernels::math::rng::rand;

    const ORDER: u32 = 7;
    const K: usize = 64;
    const PROBES: usize = 3;
    const RECEIVERS: usize = 40;

    /// Half of the receivers see probes 0 and 1, of which the second hardly has bands beyond the third; the others, far darker,
    /// see the last probe alone. A last row is to lose what they lose.
    fn transport(scale: f32) -> Vec<f32> {
        let value = |i: usize| {
            let (receiver, probe, c) = (i / (PROBES * K), i / K % PROBES, i % K);
            let size = match (receiver < RECEIVERS / 2, probe) {
                _ if receiver == RECEIVERS => 1.0,
                (true, 0) => 1.0,
                (true, 1) => {
                    if sh::band(c) > 3 {
                        1e-4
                    } else {
                        1.0
                    }
                }
                (false, 2) => 1e-5,
                _ => 0.0,
            };
            scale * size * (rand(3, receiver as u32, (probe * K + c) as u32) - 0.5)
        };
        (0..(RECEIVERS + 1) * PROBES * K).map(value).collect()
    }

    fn lights(scale: f64) -> Lights {
        let random = |i: usize, q: usize| scale * (f64::from(rand(4, i as u32, q as u32)) - 0.5);
        Lights { metric: Some(Mat::from_fn(PROBES * K, 32, random)), test: Mat::zeros(PROBES * K, 1) }
    }

    fn truncated(matrix: &mut [f32], lights: &Lights, share: f32) -> LeftOut {
        Whole { matrix, receivers: RECEIVERS, each: 1, probes: PROBES, order: ORDER }.truncate(lights, share)
    }

    /// Whether any row of all has a number in each column.
    fn filled(matrix: &[f32]) -> Vec<usize> {
        (0..PROBES * K).filter(|c| matrix.iter().skip(*c).step_by(PROBES * K).any(|x| *x != 0.0)).collect()
    }

    #[test]
    fn probes_keep_the_bands_that_bring_light_and_no_more() {
        let (lights, whole) = (lights(1.0), transport(1.0));
        let mut matrix = whole.clone();
        let left = truncated(&mut matrix, &lights, 0.01);
        let expected: Vec<usize> = (0..K).chain(K..K + 16).chain(2 * K..3 * K).collect();
        assert_eq!(filled(&matrix), expected);
        // What is gone is within what is allowed, and is what is said.
        let lit = |m: &[f32]| {
            let own = Mat::from_fn(RECEIVERS, PROBES * K, |i, c| f64::from(m[i * PROBES * K + c]));
            (own * lights.metric.as_ref().unwrap()).squared_norm_l2()
        };
        let gone: Vec<f32> = whole.iter().zip(&matrix).map(|(a, b)| a - b).collect();
        let (gone, light) = (lit(&gone), lit(&whole));
        assert!(gone > 0.0 && gone <= 1e-4 * light, "{gone} of {light}");
        assert!(
            (f64::from(left.left_out) / gone - 1.0).abs() < 1e-3 && (f64::from(left.light) / light - 1.0).abs() < 1e-3
        );
        // With 0 all is kept; what is kept is as it was.
        let mut all = whole.clone();
        assert_eq!((truncated(&mut all, &lights, 0.0), &all), (LeftOut::default(), &whole));
        assert!(matrix.iter().zip(&whole).all(|(a, b)| *a == 0.0 || a == b));
    }

    #[test]
    fn units_change_no_order() {
        let mut matrix = transport(1.0);
        truncated(&mut matrix, &lights(1.0), 0.5);
        let before = filled(&matrix);
        assert_eq!(before, (0..K).chain(2 * K..3 * K).collect::<Vec<_>>());
        for (transport_unit, light_unit) in [(1e-6, 1.0), (1e4, 3e-3), (0.7, 1e5)] {
            let mut matrix = transport(transport_unit);
            truncated(&mut matrix, &lights(light_unit), 0.5);
            assert_eq!(filled(&matrix), before);
        }
    }

    #[test]
    fn what_brings_a_receiver_most_stays() {
        // Of all receivers but one, which is dark, the second probe brings nothing.
        let dark = |c: usize| (1e-5 * (1 + c % 7) as f32) * if c < K { 1e-2 } else { 1.0 };
        let value = |i: usize| {
            let (receiver, c) = (i / (PROBES * K), i % (PROBES * K));
            match (receiver, c / K) {
                (0, 0 | 1) => dark(c),
                (_, 0) => rand(5, receiver as u32, c as u32) - 0.5,
                _ => 0.0,
            }
        };
        let mut matrix: Vec<f32> = (0..(RECEIVERS + 1) * PROBES * K).map(value).collect();
        truncated(&mut matrix, &lights(1.0), 0.01);
        assert_eq!(filled(&matrix), (0..K + 16).collect::<Vec<_>>());
    }

    #[test]
    fn without_lights_the_transport_itself_counts() {
        let lights = Lights { metric: None, ..lights(1.0) };
        let mut matrix = transport(1.0);
        let left = truncated(&mut matrix, &lights, 0.01);
        assert_eq!(filled(&matrix).len(), 2 * K + 16);
        assert!(left.left_out > 0.0 && left.left_out <= 1e-4 * left.light, "{left:?}");
    }

    #[test]
    fn bands_are_chosen_by_the_vectors_that_they_fill() {
        assert_eq!(choices(9), [0, 4, 5, 6, 8, 9, 10]);
        assert_eq!(choices(7), [0, 4, 5, 6, 8]);
        assert_eq!(choices(2), [0, 3]);
        assert_eq!(choices(0), [0, 1]);
    }
}
