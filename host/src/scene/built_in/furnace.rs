//! Scenes with a closed-form answer.

use super::SceneBuilder;
use crate::scene::Scene;
use glam::{Vec2, Vec3};
use std::collections::HashMap;

/// A closed cube of side 1 m whose walls all emit `emission` and reflect `albedo`.
///
/// For: energy. With `k` bounces the radiance seen anywhere is `emission·(1 + albedo + … + albedoᵏ)`, and
/// `emission / (1 − albedo)` in the limit.
pub fn furnace(albedo: f32, emission: f32) -> Scene {
    let mut b = SceneBuilder::new("furnace");
    let wall = b.emitter("wall", [albedo; 3], [emission; 3]);
    b.room([0.0; 3], [1.0; 3], [wall; 6]);
    b.camera("inside", [0.5, 0.5, 0.9], [0.45, 0.4, 0.0], 70.0);
    b.finish()
}

/// A closed sphere of radius 1 m around the origin, its front inside, that emits `emission` and reflects `albedo`.
///
/// An icosahedron, each triangle split in four `subdivisions` times: `20·4ⁿ` triangles, corners on the sphere.
///
/// For: energy as in [`furnace`], on many small curved triangles; a closed mesh against light leaks.
pub fn sphere_furnace(subdivisions: u32, albedo: f32, emission: f32) -> Scene {
    let mut b = SceneBuilder::new("sphere-furnace");
    let wall = b.emitter("wall", [albedo; 3], [emission; 3]);
    let (corners, triangles) = icosphere(subdivisions);
    for corner in corners {
        b.vertex(corner, -corner, Vec2::ZERO);
    }
    for [i, j, k] in triangles {
        b.triangle([i, k, j], wall);
    }
    b.camera("inside", [0.0, 0.0, 0.5], [0.0, -0.2, -1.0], 70.0);
    b.finish()
}

/// Corners on the unit sphere and triangles whose fronts are outside.
fn icosphere(subdivisions: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let golden = 0.5 * (1.0 + 5.0_f32.sqrt());
    let mut corners = Vec::new();
    for (one, phi) in [(-1.0, golden), (1.0, golden), (-1.0, -golden), (1.0, -golden)] {
        corners.push(Vec3::new(one, phi, 0.0).normalize());
    }
    for i in 0..4 {
        corners.push(Vec3::new(corners[i].z, corners[i].x, corners[i].y));
    }
    for i in 0..4 {
        corners.push(Vec3::new(corners[i].y, corners[i].z, corners[i].x));
    }
    #[rustfmt::skip]
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
        [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..subdivisions {
        let mut middles = HashMap::new();
        let mut split = Vec::with_capacity(4 * triangles.len());
        for [i, j, k] in triangles {
            let mut middle = |a: u32, b: u32| {
                *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                    corners.push((corners[a as usize] + corners[b as usize]).normalize());
                    corners.len() as u32 - 1
                })
            };
            let (ij, jk, ki) = (middle(i, j), middle(j, k), middle(k, i));
            split.extend([[i, ij, ki], [j, jk, ij], [k, ki, jk], [ij, jk, ki]]);
        }
        triangles = split;
    }
    (corners, triangles)
}

/// Two squares of side 1 m that face each other, `distance` m apart: the lower one (y = 0) emits `emission` upwards and
/// reflects nothing, the upper one reflects `albedo`.
///
/// For: the analytic form factor of parallel squares. Everything is black elsewhere.
pub fn parallel_squares(distance: f32, albedo: f32, emission: f32) -> Scene {
    let mut b = SceneBuilder::new("parallel-squares");
    let lamp = b.emitter("lamp", [0.0; 3], [emission; 3]);
    let receiver = b.diffuse("receiver", [albedo; 3]);
    b.parallelogram(Vec3::ZERO, Vec3::Z, Vec3::X, lamp);
    b.parallelogram(Vec3::new(0.0, distance, 0.0), Vec3::X, Vec3::Z, receiver);
    b.camera("from below", [0.5, 0.5 * distance, 0.5], [0.5, distance, 0.5], 60.0);
    b.finish()
}
