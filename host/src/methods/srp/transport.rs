//! Local transport: how much each coefficient of each probe in support lights a receiver.
//!
//! Rays leave the receiver by the cosine law. What one meets is looked up at the probes that see it too, in the direction
//! from the probe (SL17 eq. 2 and 4), and their weights `w_i V_i` sum to one per ray. The sum over rays is the row `α_ij`
//! (SL17 eq. 7), or four rows for the coefficients of incident radiance of order 1 (eq. 8).
//!
//! Rules for rays (LE §5.6.4 and 5.6.5): a probe counts only where it lies before the surface that was met; rays that
//! meet the inside of solids count as not sent, so that the rest stand for them. For rays that meet what no probe sees,
//! a share `u` of all, the rest stand in part: it is scaled by `1 + u`. SL17 takes them as dark (no scale), LE as not sent
//! (scale `1/(1 − u)`, which lights crevices by the one ray in a hundred that leaves them). Rays that leave the
//! scene bring nothing: the environment, of constant radiance here, is lit exactly by its open share
//! (`SrpBake::sky`) instead of through the probes' few coefficients. All receivers use the same directions in the
//! frames of their normals: neighbours then err alike, and the error compresses with the signal instead of being noise.

use super::atlas::Atlas;
use super::model::Receiver;
use super::probes::weight;
use super::round_trip::RoundTrip;
use super::visibility::{Asked, NO_TEXEL, Visibility};
use super::world::{Seen, World, frame};
use glam::Vec3;
use interreflect_kernels::math::frame::Frame;
use interreflect_kernels::math::sampling::{cosine_hemisphere, hammersley, hemisphere};
use interreflect_kernels::math::sh;
use interreflect_kernels::real::{Lanes, Real, WIDTH};
use multiversion::multiversion;
use std::f32::consts::PI;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// What transport is computed with.
pub struct Transport<'a> {
    /// The scene.
    pub world: &'a World<'a>,
    /// Positions of the probes (m).
    pub probes: &'a [Vec3],
    /// Radius of their support (m).
    pub radius: f32,
    /// Order of their spherical harmonics.
    pub order: u32,
    /// 1 or 4.
    pub rows: u32,
    /// Exponent of the probes' resolution in their weights.
    pub sharpness: f32,
    /// Directions about +Z.
    pub directions: Vec<Vec3>,
    /// Whether a side of a triangle belongs to the world.
    pub exposed: &'a (dyn Fn(u32, bool) -> bool + Sync),
    /// The lightmap, which says what texel a ray met.
    pub atlas: &'a Atlas,
    /// Where given, the probes' visibility is decided by texel where that can be.
    pub visibility: Option<&'a Visibility>,
    /// Rays that were traced so far, those between surfaces and probes included: a count, of which nothing depends.
    pub traced: &'a AtomicU64,
}

/// Smallest cosine that counts for a probe before a surface.
const GRAZING: f32 = 1e-3;

/// Rays ahead for whose texels the kinds of light are asked for.
const AHEAD: usize = 4;

/// What became of a receiver's rays.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Rays {
    /// Irradiance (W/m²) under an environment of radiance 1.
    pub sky: f32,
    /// Share of rays that met what no probe in support sees.
    pub unseen: f32,
    /// Share of rays that met the inside of solids.
    pub inside: f32,
}

/// What of a receiver's rays is summed.
#[derive(Clone, Copy)]
struct Sum {
    /// What each ray stands for, as a factor of the integrand.
    per_ray: f32,
    /// The same without what stands for rays that no probe sees.
    per_factor: f32,
    /// Where the sum is over the difference of two halves: the mean sign of what was sent.
    halves: Option<f32>,
}

impl Sum {
    /// Weight of a ray: 1, or which half it belongs to. Neighbours among the directions, which lie one beside the other, belong
    /// to different halves: both are stratified like the whole.
    #[inline(always)]
    fn weight(&self, ray: u32) -> f32 {
        self.halves.map_or(1.0, |mean| sign(ray) - mean)
    }
}

/// 1 for rays of one half, −1 for those of the other.
fn sign(ray: u32) -> f32 {
    if ray.is_multiple_of(2) { 1.0 } else { -1.0 }
}

/// What a receiver's rays met, in planes of equal length, a multiple of the lanes.
#[derive(Default)]
struct Met {
    seen: Vec<Seen>,
    texel: Vec<u32>,
    /// Number of the ray.
    ray: Vec<u32>,
    position: [Vec<f32>; 3],
    normal: [Vec<f32>; 3],
    /// Sum of the probes' weights.
    sum: Vec<f32>,
    /// Number of rays that left the scene, of those that met the inside of solids, and the sum of signs of all others.
    open: u32,
    inside: u32,
    signs: f32,
}

/// Points seen from one probe with their weights: planes of equal length, a multiple of the lanes.
#[derive(Default)]
struct Samples {
    /// From the probe.
    at: [Vec<f32>; 3],
    /// One plane per row.
    w: [Vec<f32>; 4],
}

/// Memory of one thread, kept between receivers.
#[derive(Default)]
pub struct Scratch {
    met: Met,
    /// Weights `[probe in support][met]`, 0 where the probe does not see it.
    weights: Vec<f32>,
    samples: Samples,
}

/// The directions that every receiver sends: by the cosine law for one row, uniform for four, whose weights do not hold the cosine.
pub fn directions(count: u32, rows: u32) -> Vec<Vec3> {
    let direction = |i| {
        let u = hammersley(i, count);
        if rows == 1 { cosine_hemisphere(u) } else { hemisphere(u) }
    };
    let mut directions: Vec<Vec3> = (0..count).map(direction).collect();
    // One beside the other: neighbours walk through the same part of the scene's tree.
    directions.sort_by_key(|d| interleaved((d.x + 1.0) * 511.5, (d.y + 1.0) * 511.5));
    directions
}

/// Morton number of two numbers below 1024.
fn interleaved(x: f32, y: f32) -> u32 {
    let spread = |v: f32| (0..10).fold(0, |bits, k| bits | (v as u32 >> k & 1) << (2 * k));
    spread(x) | spread(y) << 1
}

/// What is made of a receiver's rays.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Estimate {
    /// Their mean.
    Mean,
    /// What of the mean may be chance: half the difference of two halves of the rays, which varies as their mean does. It
    /// errs high (by up to two thirds in the Cornell box): the halves of an even set are each less even.
    Noise,
}

impl Transport<'_> {
    /// Probes whose support holds a point.
    pub fn support(&self, position: Vec3) -> Vec<u32> {
        let within = |p: &Vec3| (*p - position).length() < self.radius;
        (0..self.probes.len() as u32).filter(|i| within(&self.probes[*i as usize])).collect()
    }

    /// Sends a receiver's rays and asks what the probes of `support` see of what they meet; [`Transport::rows`] then says
    /// what comes of it.
    pub fn send(&self, r: &Receiver, support: &[u32], scratch: &mut Scratch) -> Rays {
        let asked = trace_and_weigh(self, r, support, scratch);
        self.traced.fetch_add(self.directions.len() as u64 + asked, Relaxed);
        let met = &scratch.met;
        let all = self.directions.len().max(1) as f32;
        let cosine_weighted = PI * met.open as f32 / met.sent();
        let sky = if self.rows == 1 { cosine_weighted } else { self.sky(r) };
        Rays { sky, unseen: met.unseen() as f32 / all, inside: met.inside as f32 / all }
    }

    /// Rows of the receiver that sent its rays last, or their noise, for the coefficients of `support`:
    /// `rows × support.len() × K`, row-major. Where `kinds` of light are given, its form factors (W/m² per unit of radiance)
    /// are added to their rows.
    pub fn rows(
        &self,
        r: &Receiver,
        support: &[u32],
        scratch: &mut Scratch,
        estimate: Estimate,
        kinds: Option<(&RoundTrip, &mut [f32])>,
    ) -> Vec<f32> {
        let frame = frame(r.normal);
        let met = &scratch.met;
        let sent = met.sent();
        let per_factor = if self.rows == 1 { PI } else { 2.0 * PI } / sent;
        let per_ray = per_factor * (1.0 + met.unseen() as f32 / sent);
        let sum = Sum { per_ray, per_factor, halves: (estimate == Estimate::Noise).then(|| met.signs / sent) };
        let k = sh::count(self.order);
        let mut rows = vec![0.0; self.rows as usize * support.len() * k];
        let stride = met.sum.len();
        for (slot, probe) in support.iter().enumerate() {
            let weights = &scratch.weights[slot * stride..(slot + 1) * stride];
            let position = self.probes[*probe as usize];
            sample_one(self, &scratch.met, weights, position, &frame, &sum, &mut scratch.samples);
            for row in 0..self.rows as usize {
                let at = (row * support.len() + slot) * k;
                scratch.samples.project(self.order, row, sum.per_ray, &mut rows[at..at + k]);
            }
        }
        if let Some((kinds, factors)) = kinds {
            form_factors(self, &scratch.met, &frame, &sum, kinds, factors);
        }
        rows
    }

    /// What a receiver's rays met, by kind of light.
    #[inline(always)]
    fn form_factors(&self, met: &Met, frame: &Frame, sum: &Sum, kinds: &RoundTrip, factors: &mut [f32]) {
        let count = kinds.factor_count();
        // Neighbours among the rays often meet the same texel: they are added together.
        let mut run = (NO_TEXEL, 0.0);
        for (i, ((seen, texel), ray)) in met.seen.iter().zip(&met.texel).zip(&met.ray).enumerate() {
            if let Some(later) = met.texel.get(i + AHEAD) {
                kinds.prefetch(*later);
            }
            let texel = kinds.texel(self.world, seen, *texel);
            if self.rows == 1 {
                if texel != run.0 {
                    kinds.add(factors, run.0, run.1 * sum.per_factor);
                    run = (texel, 0.0);
                }
                run.1 += sum.weight(*ray);
                continue;
            }
            let y: [f32; 4] = sh::basis(frame.world_from_local(self.directions[*ray as usize]).to_array());
            let rows = factors.chunks_exact_mut(count).zip(y);
            rows.for_each(|(row, y)| kinds.add(row, texel, sum.per_factor * sum.weight(*ray) * y));
        }
        if self.rows == 1 {
            kinds.add(factors, run.0, run.1 * sum.per_factor);
        }
    }

    /// Sends a receiver's rays.
    #[inline(always)]
    fn trace(&self, r: &Receiver, frame: &Frame, met: &mut Met) {
        met.clear();
        for (ray, local) in self.directions.iter().enumerate() {
            match self.world.closest_from(r, frame.world_from_local(*local)) {
                None => met.open(ray as u32),
                Some(seen) if !(self.exposed)(seen.triangle, seen.front) => met.inside += 1,
                Some(seen) => {
                    met.push(seen, self.atlas.texel_of(seen.triangle, seen.weights, seen.front), ray as u32);
                }
            }
        }
        met.pad();
    }

    /// Weights of the probes in support for everything that was met, and their sums. Gives the number of rays that it took.
    #[inline(always)]
    fn weigh(&self, r: &Receiver, support: &[u32], scratch: &mut Scratch) -> u64 {
        let mut asked = 0;
        let stride = scratch.met.sum.len();
        scratch.weights.clear();
        scratch.weights.resize(support.len() * stride, 0.0);
        for (slot, probe) in support.iter().enumerate() {
            let own = &mut scratch.weights[slot * stride..(slot + 1) * stride];
            let position = self.probes[*probe as usize];
            let falloff = weight((position - r.position).length() / self.radius);
            resolution(&scratch.met, position.to_array(), falloff, own);
            if self.sharpness != 1.0 {
                let sharper = |w: &mut f32| *w = falloff * (*w / falloff).powf(self.sharpness);
                own.iter_mut().filter(|w| **w > 0.0).for_each(sharper);
            }
            asked += self.hide(&mut scratch.met, own, *probe);
        }
        asked
    }

    /// Takes away the weights of what a probe does not see, and adds the others to the sums. Gives the number of rays that it took.
    #[inline(always)]
    fn hide(&self, met: &mut Met, weights: &mut [f32], probe: u32) -> u64 {
        let of = Asked { world: self.world, atlas: self.atlas, probes: self.probes };
        let mut asked = 0;
        for (i, seen) in met.seen.iter().enumerate() {
            if weights[i] <= 0.0 {
                weights[i] = 0.0;
                continue;
            }
            let sees = match (self.visibility, met.texel[i]) {
                (Some(known), texel) if texel != NO_TEXEL => known.sees(&of, texel, probe, seen, &mut asked),
                _ => of.sees(seen, probe, &mut asked),
            };
            if sees {
                met.sum[i] += weights[i];
            } else {
                weights[i] = 0.0;
            }
        }
        asked
    }

    /// What one probe contributes.
    #[inline(always)]
    fn sample(&self, met: &Met, weights: &[f32], probe: Vec3, frame: &Frame, sum: &Sum, samples: &mut Samples) {
        let count = met.seen.len();
        samples.resize(count, self.rows as usize);
        let ([x, y, z], [px, py, pz]) = (&met.position, probe.to_array());
        let mut n = 0;
        for i in 0..count {
            // What the probe does not see is overwritten by the next, or cut off: no branch, which nothing would foresee.
            let w = weights[i] / met.sum[i] * sum.weight(met.ray[i]);
            (samples.at[0][n], samples.at[1][n], samples.at[2][n]) = (x[i] - px, y[i] - py, z[i] - pz);
            samples.w[0][n] = w;
            if self.rows > 1 && weights[i] > 0.0 {
                let about: [f32; 4] =
                    sh::basis(frame.world_from_local(self.directions[met.ray[i] as usize]).to_array());
                samples.w.iter_mut().zip(about).for_each(|(plane, b)| plane[n] = w * b);
            }
            n += usize::from(weights[i] > 0.0);
        }
        samples.resize(n, self.rows as usize);
        samples.pad();
    }

    /// Open share of the sky by the cosine law, times π.
    fn sky(&self, r: &Receiver) -> f32 {
        let frame = frame(r.normal);
        let count = self.directions.len() as u32;
        let leaves = |i: &u32| {
            let direction = frame.world_from_local(cosine_hemisphere(hammersley(*i, count)));
            self.world.closest_from(r, direction).is_none()
        };
        PI * (0..count).filter(leaves).count() as f32 / count.max(1) as f32
    }
}

/// [`Transport::trace`], then [`Transport::weigh`]: what is inlined here and below is compiled for AVX2 too, the same bits.
#[multiversion(targets("x86_64+avx2+fma+bmi1+bmi2+lzcnt"))]
fn trace_and_weigh(transport: &Transport<'_>, r: &Receiver, support: &[u32], scratch: &mut Scratch) -> u64 {
    transport.trace(r, &frame(r.normal), &mut scratch.met);
    transport.weigh(r, support, scratch)
}

/// [`Transport::sample`].
#[multiversion(targets("x86_64+avx2+fma+bmi1+bmi2+lzcnt"))]
fn sample_one(
    transport: &Transport<'_>,
    met: &Met,
    weights: &[f32],
    probe: Vec3,
    frame: &Frame,
    sum: &Sum,
    samples: &mut Samples,
) {
    transport.sample(met, weights, probe, frame, sum, samples);
}

/// [`Transport::form_factors`].
#[multiversion(targets("x86_64+avx2+fma+bmi1+bmi2+lzcnt"))]
fn form_factors(
    transport: &Transport<'_>,
    met: &Met,
    frame: &Frame,
    sum: &Sum,
    kinds: &RoundTrip,
    factors: &mut [f32],
) {
    transport.form_factors(met, frame, sum, kinds, factors);
}

/// How finely a probe resolves the surface at each point: solid angle per area, `cos θ / d²`, times `scale`; 0 or less
/// where it lies behind the surface. The cosine is at least [`GRAZING`] before it.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn resolution(met: &Met, probe: [f32; 3], scale: f32, out: &mut [f32]) {
    type L = Lanes<WIDTH>;
    for i in (0..out.len()).step_by(WIDTH) {
        let d: [L; 3] = std::array::from_fn(|a| L::splat(probe[a]) - L::load(&met.position[a], i));
        let n: [L; 3] = std::array::from_fn(|a| L::load(&met.normal[a], i));
        let facing = d[0] * n[0] + d[1] * n[1] + d[2] * n[2];
        let square = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).max(L::splat(f32::MIN_POSITIVE));
        let cosine = (facing / square.sqrt()).max(L::splat(GRAZING));
        let w = cosine / square * L::splat(scale);
        L::select(L::splat(0.0).lt(facing), w, L::splat(0.0)).store(out, i);
    }
}

impl Met {
    fn clear(&mut self) {
        self.seen.clear();
        self.texel.clear();
        self.ray.clear();
        self.position.iter_mut().chain(&mut self.normal).for_each(Vec::clear);
        self.sum.clear();
        (self.open, self.inside, self.signs) = (0, 0, 0.0);
    }

    /// A ray that left the scene.
    fn open(&mut self, ray: u32) {
        self.open += 1;
        self.signs += sign(ray);
    }

    /// Rays that count as sent, at least 1.
    fn sent(&self) -> f32 {
        (self.open as usize + self.seen.len()).max(1) as f32
    }

    /// Rays that met what no probe sees.
    fn unseen(&self) -> usize {
        (0..self.seen.len()).filter(|i| self.sum[*i] <= 0.0).count()
    }

    #[inline(always)]
    fn push(&mut self, seen: Seen, texel: u32, ray: u32) {
        for axis in 0..3 {
            self.position[axis].push(seen.position[axis]);
            self.normal[axis].push(seen.normal[axis]);
        }
        self.seen.push(seen);
        self.texel.push(texel);
        self.ray.push(ray);
        self.signs += sign(ray);
    }

    /// Fills up to whole lanes with what no probe can face.
    fn pad(&mut self) {
        let length = self.seen.len().next_multiple_of(WIDTH);
        self.position.iter_mut().chain(&mut self.normal).for_each(|plane| plane.resize(length, 0.0));
        self.sum.resize(length, 0.0);
    }
}

impl Samples {
    /// Makes room for so many samples, or drops the others.
    fn resize(&mut self, count: usize, rows: usize) {
        self.at.iter_mut().chain(&mut self.w[..rows]).for_each(|plane| plane.resize(count, 0.0));
    }

    /// Fills up to whole lanes with samples of no weight.
    fn pad(&mut self) {
        let length = self.at[0].len().next_multiple_of(WIDTH);
        self.at.iter_mut().chain(&mut self.w).filter(|p| !p.is_empty()).for_each(|plane| plane.resize(length, 0.0));
    }

    /// `scale · Σ w Y_j` for every coefficient.
    fn project(&self, order: u32, row: usize, scale: f32, out: &mut [f32]) {
        match order {
            0 => sum_0(self, row, scale, out),
            1 => sum_1(self, row, scale, out),
            2 => sum_2(self, row, scale, out),
            3 => sum_3(self, row, scale, out),
            4 => sum_4(self, row, scale, out),
            5 => sum_5(self, row, scale, out),
            6 => sum_6(self, row, scale, out),
            7 => sum_7(self, row, scale, out),
            8 => sum_8(self, row, scale, out),
            _ => sum_9(self, row, scale, out),
        }
    }
}

/// One function per order, each compiled for wide registers too.
macro_rules! sums {
    ($($name:ident $count:literal),*) => { $(
        #[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
        fn $name(samples: &Samples, row: usize, scale: f32, out: &mut [f32]) {
            sum::<$count>(samples, row, scale, out);
        }
    )* };
}
sums!(sum_0 1, sum_1 4, sum_2 9, sum_3 16, sum_4 25, sum_5 36, sum_6 49, sum_7 64, sum_8 81, sum_9 100);

#[inline(always)]
fn sum<const N: usize>(samples: &Samples, row: usize, scale: f32, out: &mut [f32]) {
    type L = Lanes<WIDTH>;
    let mut sums = [L::splat(0.0); N];
    for i in (0..samples.at[0].len()).step_by(WIDTH) {
        let [x, y, z] = std::array::from_fn(|axis| L::load(&samples.at[axis], i));
        let square = x * x + y * y + z * z;
        // Not 0 / 0 where samples only fill up.
        let inverse = L::splat(1.0) / square.max(L::splat(f32::MIN_POSITIVE)).sqrt();
        let w = L::load(&samples.w[row], i);
        sh::accumulate(&mut sums, [x * inverse, y * inverse, z * inverse], w);
    }
    out.iter_mut().zip(&sums).for_each(|(o, s)| *o = scale * s.0.iter().sum::<f32>());
}
