//! Speed of the reference's ray queries.

use super::ReferenceError;
use super::path::cosine_direction;
use super::sampler::Sampler;
use super::surface::Surfaces;
use super::trace::{NO_TRIANGLE, Tracer};
use crate::scene::{Camera, Scene};
use glam::Vec3;
use serde::Serialize;
use std::hint::black_box;
use std::time::Instant;

/// Closest-hit queries per second of one thread, with what was traced.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct RaysPerSecond {
    /// Camera rays in scan order, million per second.
    pub primary_mrays: f64,
    /// Cosine-distributed rays from the points that camera rays hit, in scan order, million per second.
    pub diffuse_mrays: f64,
    /// Occlusion queries along the same diffuse rays, million per second.
    pub shadow_mrays: f64,
    /// Time to build the acceleration structure with all threads (ms).
    pub build_ms: f64,
    /// Camera rays per pass.
    pub primary_rays: u32,
    /// Diffuse rays per pass: camera rays that hit something.
    pub diffuse_rays: u32,
}

/// Passes over the picture; the median counts.
const PASSES: usize = 5;

/// Measures one thread on `width · height` camera rays and one diffuse bounce of each.
///
/// # Errors
/// As [`Tracer::new`].
pub fn rays_per_second(
    scene: &Scene,
    camera: &Camera,
    width: u32,
    height: u32,
) -> Result<RaysPerSecond, ReferenceError> {
    let start = Instant::now();
    let tracer = Tracer::new(scene)?;
    let build_ms = start.elapsed().as_secs_f64() * 1e3;
    let surfaces = Surfaces::new(scene);
    let primary: Vec<(Vec3, Vec3, u32)> = (0..width * height)
        .map(|i| {
            let (o, d) = camera.ray((i % width) as f32 + 0.5, (i / width) as f32 + 0.5, width, height);
            (o, d, NO_TRIANGLE)
        })
        .collect();
    let diffuse: Vec<(Vec3, Vec3, u32)> = primary
        .iter()
        .enumerate()
        .filter_map(|(i, &(origin, direction, _))| {
            let hit = tracer.closest(origin, direction, f32::MAX, NO_TRIANGLE)?;
            let (vertex, _) = surfaces.at(&hit, direction);
            let (wi, _) = cosine_direction(vertex.normal, Sampler::new(0, i as u32, 0, 0, 1).pair(0));
            Some((vertex.leave(wi), wi, vertex.triangle))
        })
        .collect();
    let closest = |rays: &[(Vec3, Vec3, u32)]| {
        median_mrays(rays, |o, d, exclude| tracer.closest(o, d, f32::MAX, exclude).is_some())
    };
    Ok(RaysPerSecond {
        primary_mrays: closest(&primary),
        diffuse_mrays: closest(&diffuse),
        shadow_mrays: median_mrays(&diffuse, |o, d, own| tracer.occluded(o, d, f32::MAX, [own, NO_TRIANGLE])),
        build_ms,
        primary_rays: primary.len() as u32,
        diffuse_rays: diffuse.len() as u32,
    })
}

fn median_mrays(rays: &[(Vec3, Vec3, u32)], query: impl Fn(Vec3, Vec3, u32) -> bool) -> f64 {
    let mut speeds: Vec<f64> = (0..PASSES)
        .map(|_| {
            let start = Instant::now();
            let hits = rays.iter().filter(|&&(o, d, exclude)| query(o, d, exclude)).count();
            black_box(hits);
            rays.len() as f64 / start.elapsed().as_secs_f64() * 1e-6
        })
        .collect();
    speeds.sort_by(f64::total_cmp);
    speeds[PASSES / 2]
}
