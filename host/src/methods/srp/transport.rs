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

use super::model::Receiver;
use super::probes::weight;
use super::world::World;
use glam::Vec3;
use interreflect_kernels::math::frame::Frame;
use interreflect_kernels::math::sampling::{cosine_hemisphere, hammersley, hemisphere};
use interreflect_kernels::math::sh;
use interreflect_kernels::real::{Lanes, Real, WIDTH};
use interreflect_kernels::trace::leave_surface;
use std::f32::consts::PI;

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
    /// Exponent of `resolution` in the probes' weights.
    pub sharpness: f32,
    /// Directions about +Z.
    pub directions: Vec<Vec3>,
    /// Whether a side of a triangle belongs to the world.
    pub exposed: &'a (dyn Fn(u32, bool) -> bool + Sync),
}

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

/// Directions from one probe with their weights: planes of equal length, a multiple of the lanes.
#[derive(Clone, Default)]
struct Samples {
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    /// One plane per row.
    w: [Vec<f32>; 4],
}

/// Memory of one thread, kept between receivers.
#[derive(Default)]
pub struct Scratch {
    samples: Vec<Samples>,
    visible: Vec<(usize, Vec3, f32)>,
}

/// The directions that every receiver sends: by the cosine law for one row, uniform for four, whose weights do not hold the cosine.
pub fn directions(count: u32, rows: u32) -> Vec<Vec3> {
    let direction = |i| {
        let u = hammersley(i, count);
        if rows == 1 { cosine_hemisphere(u) } else { hemisphere(u) }
    };
    (0..count).map(direction).collect()
}

/// How finely a probe resolves the surface at a point: solid angle per area, `cos θ / d²`, to the power `sharpness`.
fn resolution(from_probe: Vec3, normal: Vec3, sharpness: f32) -> f32 {
    let square = from_probe.length_squared().max(f32::MIN_POSITIVE);
    let cosine = -from_probe.dot(normal) / square.sqrt();
    (cosine.max(1e-3) / square).powf(sharpness)
}

impl Transport<'_> {
    /// Probes whose support holds a point.
    pub fn support(&self, position: Vec3) -> Vec<u32> {
        let within = |p: &Vec3| (*p - position).length() < self.radius;
        (0..self.probes.len() as u32).filter(|i| within(&self.probes[*i as usize])).collect()
    }

    /// Rows of a receiver for the coefficients of `support`: `rows × support.len() × K`, row-major.
    pub fn rows(&self, r: &Receiver, support: &[u32], scratch: &mut Scratch) -> (Vec<f32>, Rays) {
        let weights: Vec<f32> =
            support.iter().map(|p| weight((self.probes[*p as usize] - r.position).length() / self.radius)).collect();
        scratch.samples.resize_with(scratch.samples.len().max(support.len()), Samples::default);
        scratch.samples.iter_mut().for_each(Samples::clear);
        let (mut open, mut seen_count, mut unseen, mut inside) = (0u32, 0u32, 0u32, 0u32);
        let frame = Frame::new(r.normal);
        for local in &self.directions {
            let direction = frame.world_from_local(*local);
            let Some(seen) =
                self.world.closest(leave_surface(r.position, r.geometric_normal, r.error, direction), direction)
            else {
                open += 1;
                continue;
            };
            if !(self.exposed)(seen.triangle, seen.front) {
                inside += 1;
                continue;
            }
            scratch.visible.clear();
            let mut sum = 0.0;
            for (slot, probe) in support.iter().enumerate() {
                let probe = self.probes[*probe as usize];
                let from_probe = seen.position - probe;
                if from_probe.dot(seen.normal) < 0.0 && self.world.sees(&seen, probe) {
                    let w = weights[slot] * resolution(from_probe, seen.normal, self.sharpness);
                    scratch.visible.push((slot, from_probe, w));
                    sum += w;
                }
            }
            if sum <= 0.0 {
                unseen += 1;
                continue;
            }
            seen_count += 1;
            let about: [f32; 4] = if self.rows == 1 { [1.0; 4] } else { sh::basis(direction.to_array()) };
            for (slot, from_probe, w) in &scratch.visible {
                scratch.samples[*slot].push(from_probe.normalize_or(Vec3::Z), w / sum, &about[..self.rows as usize]);
            }
        }
        let sent = (open + seen_count + unseen).max(1) as f32;
        let per_ray = if self.rows == 1 { PI } else { 2.0 * PI } * (1.0 + unseen as f32 / sent) / sent;
        let k = sh::count(self.order);
        let mut rows = vec![0.0; self.rows as usize * support.len() * k];
        for (slot, samples) in scratch.samples[..support.len()].iter_mut().enumerate() {
            samples.pad();
            for row in 0..self.rows as usize {
                let at = (row * support.len() + slot) * k;
                samples.project(self.order, row, per_ray, &mut rows[at..at + k]);
            }
        }
        let all = self.directions.len().max(1) as f32;
        let cosine_weighted = PI * open as f32 / sent;
        let sky = if self.rows == 1 { cosine_weighted } else { self.sky(r) };
        (rows, Rays { sky, unseen: unseen as f32 / all, inside: inside as f32 / all })
    }

    /// Open share of the sky by the cosine law, times π.
    fn sky(&self, r: &Receiver) -> f32 {
        let frame = Frame::new(r.normal);
        let count = self.directions.len() as u32;
        let leaves = |i: &u32| {
            let direction = frame.world_from_local(cosine_hemisphere(hammersley(*i, count)));
            self.world.closest(leave_surface(r.position, r.geometric_normal, r.error, direction), direction).is_none()
        };
        PI * (0..count).filter(leaves).count() as f32 / count.max(1) as f32
    }
}

impl Samples {
    fn clear(&mut self) {
        [&mut self.x, &mut self.y, &mut self.z].into_iter().chain(&mut self.w).for_each(Vec::clear);
    }

    fn push(&mut self, d: Vec3, weight: f32, about: &[f32]) {
        self.x.push(d.x);
        self.y.push(d.y);
        self.z.push(d.z);
        about.iter().zip(&mut self.w).for_each(|(b, w)| w.push(weight * b));
    }

    /// Fills up to whole lanes with samples of no weight.
    fn pad(&mut self) {
        let length = self.x.len().next_multiple_of(WIDTH);
        for plane in [&mut self.x, &mut self.y, &mut self.z].into_iter().chain(&mut self.w) {
            if !plane.is_empty() {
                plane.resize(length, 0.0);
            }
        }
    }

    /// `scale · Σ w Y_j` for every coefficient.
    fn project(&self, order: u32, row: usize, scale: f32, out: &mut [f32]) {
        match order {
            0 => self.sum::<1>(row, scale, out),
            1 => self.sum::<4>(row, scale, out),
            2 => self.sum::<9>(row, scale, out),
            3 => self.sum::<16>(row, scale, out),
            4 => self.sum::<25>(row, scale, out),
            5 => self.sum::<36>(row, scale, out),
            6 => self.sum::<49>(row, scale, out),
            7 => self.sum::<64>(row, scale, out),
            8 => self.sum::<81>(row, scale, out),
            _ => self.sum::<100>(row, scale, out),
        }
    }

    fn sum<const N: usize>(&self, row: usize, scale: f32, out: &mut [f32]) {
        let mut sums = [Lanes::<WIDTH>::splat(0.0); N];
        for i in (0..self.x.len()).step_by(WIDTH) {
            let load = |plane: &[f32]| Lanes::<WIDTH>::load(plane, i);
            sh::accumulate(&mut sums, [load(&self.x), load(&self.y), load(&self.z)], load(&self.w[row]));
        }
        out.iter_mut().zip(&sums).for_each(|(o, s)| *o = scale * s.0.iter().sum::<f32>());
    }
}
