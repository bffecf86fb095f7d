//! The loop of bounces: how much light each bounce hands on, and what keeps the loop from growing.
//!
//! One bounce is `E' = M E + d`, linear in irradiance. It converges for every light exactly when the spectral radius of `M`
//! is below 1. [`SrpRuntime::spectral_radius`] measures it with the kernels themselves; [`gain_bound`] proves it from albedo and
//! transport, where the bound is below 1. Physically each bounce keeps at most the largest albedo, but band-limited
//! probes and clustered components are not physics: white rooms may exceed 1, and then
//! [`SrpRuntime::keep_below_one`] damps the light that is fed back.

use super::model::{Cluster, SrpBake};
use super::runtime::SrpRuntime;
use crate::exec::{Executor, ExecutorExt};
use crate::methods::{MethodError, StageClock};
use glam::Vec3;
use interreflect_kernels::math::sh;
use rayon::prelude::*;
use serde::Serialize;
use std::f64::consts::PI;

/// What is known about the loop of bounces.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Feedback {
    /// Spectral radius of one bounce with undamped feedback.
    pub spectral_radius: f64,
    /// Factor on the light that is fed back: below 1 where the loop would not converge by itself.
    pub damping: f32,
    /// Whether the spectral radius reached 1: the baked transport creates energy.
    pub alarm: bool,
}

/// Largest spectral radius of a damped loop.
pub const DAMPED_RADIUS: f64 = 0.98;

impl SrpRuntime {
    /// Spectral radius of one bounce, by power iteration from uniform light: the geometric mean of the growth over the
    /// second half of the iterations. Light, emission and the irradiance of the last update are as before afterwards.
    ///
    /// # Errors
    /// The executor's.
    pub fn spectral_radius(&mut self, exec: &mut dyn Executor, iterations: u32) -> Result<f64, MethodError> {
        let saved = self.darken(exec)?;
        let result = self.power_iteration(exec, iterations.max(2));
        self.relit(exec, &saved)?;
        result
    }

    fn power_iteration(&mut self, exec: &mut dyn Executor, iterations: u32) -> Result<f64, MethodError> {
        let (mut logs, mut counted) = (0.0, 0);
        let mut planes = vec![1f32; exec.size_bytes(self.irradiance_buffer()) as usize / 4];
        let mut clock = StageClock::default();
        for k in 0..iterations {
            let norm = norm(&planes);
            if norm == 0.0 {
                return Ok(0.0);
            }
            planes.iter_mut().for_each(|x| *x = (f64::from(*x) / norm) as f32);
            exec.write(self.irradiance_buffer(), bytemuck::cast_slice(&planes))?;
            self.bounce(exec, &mut clock)?;
            planes = exec.read_slice(self.irradiance_buffer())?;
            // The first half only turns towards the slowest mode.
            if k >= iterations / 2 {
                logs += self::norm(&planes).ln();
                counted += 1;
            }
        }
        Ok((logs / f64::from(counted)).exp())
    }

    /// Measures the spectral radius and, where it is 1 or more, damps the feedback to [`DAMPED_RADIUS`].
    ///
    /// # Errors
    /// The executor's.
    pub fn keep_below_one(&mut self, exec: &mut dyn Executor, iterations: u32) -> Result<Feedback, MethodError> {
        self.set_damping(exec, 1.0)?;
        let spectral_radius = self.spectral_radius(exec, iterations)?;
        let alarm = spectral_radius >= 1.0;
        let damping = if alarm { (DAMPED_RADIUS / spectral_radius) as f32 } else { 1.0 };
        self.set_damping(exec, damping)?;
        let feedback = Feedback { spectral_radius, damping, alarm };
        self.note_feedback(feedback);
        Ok(feedback)
    }
}

fn norm(values: &[f32]) -> f64 {
    values.iter().map(|x| f64::from(*x) * f64::from(*x)).sum::<f64>().sqrt()
}

/// An upper bound of the largest factor by which one bounce can raise the largest irradiance of any receiver, and with it
/// of the spectral radius: `max_i Σ_p √(4π g) ‖t_ip‖ · max ρ/π`, with `t_ip` the transport from the coefficients of probe `p`
/// to the irradiance of receiver `i`, `g` the largest eigenvalue of the relight rays' Gram matrix (1 for evenly spread
/// ones), and `ρ` the albedos.
///
/// Proof: receiver `i` sees `Σ_p w Σ_r L(r) f_ip(r)` with `f_ip = Σ_k t_ipk Y_k` and `w` the solid angle of a ray; by
/// Cauchy–Schwarz over the sphere, `w Σ_r |f_ip(r)| ≤ √(4π) √(w Σ_r f_ip(r)²) ≤ √(4π g) ‖t_ip‖`. The bound is about
/// twice the truth for smooth transport, and larger the more probes light a receiver.
pub fn gain_bound(bake: &SrpBake) -> f64 {
    let albedo = bake.receivers.iter().map(|r| r.albedo.max_element()).fold(0.0, f32::max);
    let largest = bake.clusters.par_iter().map(|c| cluster_bound(bake, c)).reduce(|| 0.0, f64::max);
    largest * (4.0 * PI * gram_eigenvalue(&bake.ray_directions, bake.coefficient_count())).sqrt() * f64::from(albedo)
        / PI
}

/// The largest `Σ_p ‖t_ip‖` of a cluster's receivers.
fn cluster_bound(bake: &SrpBake, cluster: &Cluster) -> f64 {
    let (rank, rows) = (cluster.rank as usize, bake.rows_per_receiver as usize);
    let bound = |(i, receiver): (usize, u32)| {
        let u = &cluster.reconstruction[i * rows * rank..(i + 1) * rows * rank];
        let row = irradiance_row(u, rank, bake.receivers[receiver as usize].normal);
        let mut squares = vec![0f64; cluster.probes.len()];
        for (column, &(slot, _)) in cluster.columns.iter().enumerate() {
            let t = if cluster.projection.is_empty() {
                f64::from(row[column])
            } else {
                let products = row.iter().zip(cluster.projection[column..].iter().step_by(cluster.columns.len()));
                f64::from(products.map(|(u, p)| u * p).sum::<f32>())
            };
            squares[slot as usize] += t * t;
        }
        squares.into_iter().map(f64::sqrt).sum::<f64>()
    };
    cluster.receivers.clone().enumerate().map(bound).fold(0.0, f64::max)
}

/// The row of `U` that gives irradiance: the only one, or four rows of order-1 radiance for the receiver's normal.
fn irradiance_row(u: &[f32], rank: usize, normal: Vec3) -> Vec<f32> {
    if u.len() == rank {
        return u.to_vec();
    }
    let y: [f32; 4] = sh::basis(normal.to_array());
    let lobe: [f32; 4] = std::array::from_fn(|k| y[k] * sh::clamped_cosine_factor(sh::band(k)));
    (0..rank).map(|r| (0..4).map(|k| lobe[k] * u[k * rank + r]).sum()).collect()
}

/// Largest eigenvalue of `4π/rays Σ_r Y(r) Y(r)ᵀ`, bounded from above by the largest row sum of its fourth power.
fn gram_eigenvalue(directions: &[Vec3], count: usize) -> f64 {
    let mut gram = vec![0f64; count * count];
    for d in directions {
        let y: [f32; sh::MAX_COUNT] = sh::basis(d.to_array());
        for i in 0..count {
            for j in 0..count {
                gram[i * count + j] += f64::from(y[i]) * f64::from(y[j]);
            }
        }
    }
    let weight = 4.0 * PI / directions.len().max(1) as f64;
    gram.iter_mut().for_each(|x| *x *= weight);
    let square = |m: &[f64]| -> Vec<f64> {
        (0..count * count)
            .into_par_iter()
            .map(|ij| (0..count).map(|k| m[ij / count * count + k] * m[k * count + ij % count]).sum())
            .collect()
    };
    let fourth = square(&square(&gram));
    fourth.chunks(count).map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max).powf(0.25)
}

#[cfg(test)]
mod tests {
    use super::*;
    use interreflect_kernels::math::sampling::spherical_fibonacci;

    #[test]
    fn even_rays_have_a_gram_matrix_near_one() {
        let rays: Vec<Vec3> = (0..4000).map(|i| spherical_fibonacci(i, 4000)).collect();
        let g = gram_eigenvalue(&rays, 64);
        assert!((1.0 - 1e-6..1.05).contains(&g), "{g}");
        // One direction over and over: the eigenvalue is the addition theorem's count.
        let same = gram_eigenvalue(&[Vec3::Z; 7], 9);
        assert!((9.0 - 1e-3..9.0 * 9f64.powf(0.25)).contains(&same), "{same}");
    }
}
