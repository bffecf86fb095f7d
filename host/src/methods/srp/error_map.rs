//! Where the probes do not suffice, whatever the light: the round trip's operator norm (SL17 §5.2, eq. 12).
//!
//! Incident radiance at a receiver, any of SH order 9, is carried to the probes that support it (each probe sees it at the
//! surfaces that both see), projected to their coefficients, and reconstructed. What is left of the irradiance that it
//! should give is a linear functional of the radiance; its norm is the largest error that radiance of norm 1 can make.

use super::model::SrpBake;
use super::world::World;
use crate::image_io::{Rgb8, magma};
use glam::Vec3;
use interreflect_kernels::math::sampling::spherical_fibonacci;
use interreflect_kernels::math::sh;
use interreflect_kernels::trace::leave_surface;
use rayon::prelude::*;
use std::f32::consts::PI;

/// Coefficients of the receiver's radiance (SL17: order 9).
const N: usize = sh::MAX_COUNT;

/// Norm of the error functional at some receivers of a bake with one row per receiver, relative to the norm of irradiance
/// itself: 0 is perfect, 1 is as bad as no light. `rays`: directions per probe by which it sees the receiver's surroundings.
pub fn error_map(world: &World<'_>, bake: &SrpBake, receivers: &[u32], rays: u32) -> Vec<f32> {
    let directions: Vec<Vec3> = (0..rays).map(|i| spherical_fibonacci(i, rays)).collect();
    let seen: Vec<Vec<_>> =
        bake.probes.par_iter().map(|p| directions.iter().map(|d| world.closest(*p, *d)).collect()).collect();
    let basis: Vec<[f32; N]> = directions.iter().map(|d| sh::basis(d.to_array())).collect();
    let map = |i: &u32| {
        let r = &bake.receivers[*i as usize];
        let mut error: [f32; N] = irradiance_functional(r.normal);
        let whole = norm(&error);
        for (probe, alpha) in rows(bake, *i) {
            for (hit, y) in seen[probe as usize].iter().zip(&basis) {
                // What the transport makes of radiance from this direction of the probe.
                let gain: f32 = alpha.iter().zip(y).map(|(a, y)| a * y).sum();
                // Radiance from outside the scene is not the probes' business.
                let Some(hit) = hit else { continue };
                let towards = hit.position - r.position;
                let from = leave_surface(r.position, r.geometric_normal, r.error, towards);
                if towards.dot(hit.normal) >= 0.0 || !world.sees(hit, from) {
                    continue;
                }
                let weight = -gain * 4.0 * PI / rays as f32;
                sh::accumulate(&mut error, towards.normalize_or(Vec3::Z).to_array(), weight);
            }
        }
        norm(&error) / whole
    };
    receivers.par_iter().map(map).collect()
}

/// The map as a picture of the lightmap: [`magma`] from 0 to 1, black where there is no receiver.
pub fn picture(bake: &SrpBake, receivers: &[u32], map: &[f32]) -> Rgb8 {
    let colour = magma();
    let mut picture = Rgb8::new(bake.atlas_size[0].max(1), bake.atlas_size[1].max(1));
    for (receiver, value) in receivers.iter().zip(map) {
        let [x, y] = bake.texel[*receiver as usize];
        if x < picture.width() && y < picture.height() {
            picture.put_pixel(x, y, image::Rgb(colour(*value)));
        }
    }
    picture
}

/// Coefficients of `λ ↦ ∫ λ cos⁺`: the clamped cosine about the normal.
fn irradiance_functional(normal: Vec3) -> [f32; N] {
    sh::zonal_lobe(&sh::factors(sh::clamped_cosine_factor), normal.to_array())
}

fn norm(x: &[f32]) -> f32 {
    x.iter().map(|x| x * x).sum::<f32>().sqrt()
}

/// A receiver's first row of the transport, by probe.
fn rows(bake: &SrpBake, receiver: u32) -> Vec<(u32, Vec<f32>)> {
    let k = bake.coefficient_count();
    let Some(cluster) = bake.clusters.iter().find(|c| c.receivers.contains(&receiver)) else { return Vec::new() };
    let rank = cluster.rank as usize;
    let row = (receiver - cluster.receivers.start) as usize * bake.rows_per_receiver as usize;
    let own = &cluster.reconstruction[row * rank..(row + 1) * rank];
    let mut by_probe: Vec<(u32, Vec<f32>)> = cluster.probes.iter().map(|p| (*p, vec![0.0; k])).collect();
    for (c, (slot, coefficient)) in cluster.columns.iter().enumerate() {
        let value = if cluster.projection.is_empty() {
            own[c]
        } else {
            own.iter().enumerate().map(|(r, u)| u * cluster.projection[r * cluster.columns.len() + c]).sum()
        };
        by_probe[*slot as usize].1[*coefficient as usize] = value;
    }
    by_probe.retain(|(_, row)| row.iter().any(|x| *x != 0.0));
    by_probe
}

#[cfg(test)]
mod tests {
    use super::super::{BakeOptions, Compression, Plan};
    use super::*;
    use crate::scene::built_in;

    #[test]
    fn more_probes_leave_less_to_chance() {
        let scene = built_in::cornell_box();
        let mean = |probes: u32, order: u32| {
            let options = BakeOptions {
                receivers: 400,
                probes,
                order,
                rays: 128,
                relight_rays: 64,
                compression: Compression::None,
                // Corrected transport serves light from patches, not any: this norm does not see what it gains.
                ridge: 0.0,
                ..BakeOptions::default()
            };
            let plan = Plan::new(&scene, &options).unwrap();
            let (bake, _) = plan.bake();
            let all: Vec<u32> = (0..bake.receivers.len() as u32).collect();
            let map = error_map(&plan.world, &bake, &all, 512);
            assert!(map.iter().all(|e| e.is_finite() && *e >= 0.0));
            map.iter().sum::<f32>() / map.len() as f32
        };
        let (two, many, coarse) = (mean(2, 7), mean(27, 7), mean(27, 1));
        println!("mean relative operator norm: 2 probes {two:.3}, 27 probes {many:.3}, 27 of order 1 {coarse:.3}");
        assert!(many < 0.9 * two && many < coarse, "{two} {many} {coarse}");
    }
}
