//! A hall full of small lights.

use super::SceneBuilder;
use super::build::hash_unit;
use crate::scene::{Light, Scene};
use glam::Vec3;

/// Size of the hall (m), and radius and pitch of its pillars.
const SIZE: Vec3 = Vec3::new(24.0, 6.0, 12.0);
const PILLAR: f32 = 0.35;
const PITCH: f32 = 4.0;

/// A closed hall of 24 × 6 × 12 m with two rows of pillars and `count` point lights of saturated colours, spread as if
/// at random (the same for the same `count`). Their total intensity does not depend on their number.
///
/// For: the cost of many lights, and methods that sample lights one by one.
pub fn many_lights(count: u32) -> Scene {
    let mut b = SceneBuilder::new("many-lights");
    let stone = b.diffuse("stone", [0.7, 0.68, 0.64]);
    let floor = b.diffuse("floor", [0.4, 0.4, 0.42]);
    let pillar = b.diffuse("pillar", [0.75, 0.75, 0.75]);
    b.room(Vec3::ZERO, SIZE, [stone, stone, floor, stone, stone, stone]);
    let profile = [(PILLAR, 0.0), (PILLAR * 0.9, 0.5 * SIZE.y), (PILLAR, SIZE.y)];
    for foot in pillar_feet() {
        b.lathe(foot, &profile, 24, pillar);
    }
    /// Sum of the lights' intensities (W/sr).
    const TOTAL: f32 = 400.0;
    for i in 0..count {
        let hue = hash_unit(7 * i + 3);
        let intensity = hue_colour(hue) * (TOTAL / count as f32);
        b.light(Light::Point { position: light_position(i), intensity });
    }
    b.camera("along", [1.2, 1.7, 1.5], [20.0, 2.2, 8.5], 65.0);
    b.finish()
}

fn pillar_feet() -> impl Iterator<Item = Vec3> {
    (1..6).flat_map(|i| [0.28, 0.72].map(|z| Vec3::new(PITCH * i as f32, 0.0, z * SIZE.z)))
}

/// Inside the hall, at least 0.4 m from everything.
fn light_position(i: u32) -> Vec3 {
    const CLEARANCE: f32 = 0.4;
    let candidates = (0..).map(|attempt: u32| {
        let random = |dimension: u32| hash_unit(i.wrapping_mul(4001).wrapping_add(17 * attempt + dimension));
        Vec3::splat(CLEARANCE) + Vec3::new(random(0), random(1), random(2)) * (SIZE - 2.0 * CLEARANCE)
    });
    let is_free = |p: &Vec3| pillar_feet().all(|f| (*p - f).with_y(0.0).length() > PILLAR + CLEARANCE);
    candidates.into_iter().find(is_free).expect("most of the hall is free")
}

/// A saturated colour whose channels sum to 1.
fn hue_colour(hue: f32) -> Vec3 {
    let channel = |offset: f32| (0.5 + 0.5 * (std::f32::consts::TAU * (hue + offset)).cos()).powi(2) + 0.02;
    let colour = Vec3::new(channel(0.0), channel(1.0 / 3.0), channel(2.0 / 3.0));
    colour / colour.element_sum()
}
