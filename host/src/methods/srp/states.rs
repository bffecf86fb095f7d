//! Lighting states: how light may fall on the receivers of a scene, for transport to be fitted to and judged by.
//!
//! Real light is neither even nor independent from place to place: suns and lamps light what lies open to them, at the same
//! time, and what is enclosed stays dark. States are drawn from what can happen: a sun above the horizon or a small lamp in open
//! air, with shadows, and one reflection by few rays. Each has a mean square of 1 over the surface, so that none that
//! lights a cranny outweighs the others. Every fifth state is kept back, to judge by.

use super::model::{NO_RECEIVER, Receiver};
use super::reach::Space;
use super::stand_in::StandIns;
use super::world::{World, frame};
use glam::Vec3;
use interreflect_kernels::kernel::prefetch;
use interreflect_kernels::math::rng::{rand, rand2};
use interreflect_kernels::math::sampling::{cosine_hemisphere, hammersley, sphere};
use rayon::prelude::*;

/// States to fit to.
pub(super) const FITTED: usize = 128;
/// States to judge by.
const JUDGES: usize = 32;
/// One in so many is a judge.
const STEP: usize = (FITTED + JUDGES) / JUDGES;
/// Receivers by which it is found out whether a sun lights anything.
const SCOUTS: usize = 512;
/// Share of surface that a state must light.
const LEAST_LIT: f32 = 1e-3;
/// Rays of a receiver for the reflection.
const RAYS: u32 = 32;
/// Reflectance of all surfaces.
const ALBEDO: f32 = 0.5;
/// Voxels that are tried for a lamp's place.
const TRIES: u32 = 256;
/// Lamps are not nearer to a receiver than this part of the scene's diagonal, as far as the falloff is concerned.
const NEAREST: f32 = 0.01;
/// Numbers that are read from memory at once.
const CACHE_LINE: usize = 16;
/// Variance (of 1) that places have which no state lights.
const LEAST_VARIANCE: f32 = 1e-4;

/// What the states make of the receivers' texels.
pub struct States {
    /// Number of states to fit to; the judges follow.
    pub fitted: usize,
    /// Number of states to judge by.
    pub judges: usize,
    /// Irradiance, `[texel][state]`; zero without a receiver.
    light: Vec<f32>,
    /// Root mean square of the states per texel.
    pub deviation: Vec<f32>,
}

impl States {
    /// No states: light is as likely everywhere.
    pub fn none(texels: usize) -> Self {
        Self { fitted: 0, judges: 0, light: Vec::new(), deviation: vec![1.0; texels] }
    }

    /// States of a scene at its `receivers` (with their texels, of `texels` in all). `stand_ins` find the texel of what a
    /// receiver sees; lamps stand in the open voxels of `space`.
    pub fn new(
        world: &World<'_>,
        space: &Space,
        stand_ins: &StandIns,
        receivers: &[(Receiver, u32)],
        texels: usize,
        seed: u32,
    ) -> Self {
        let receivers: Vec<&(Receiver, u32)> = receivers.iter().filter(|(_, t)| *t != NO_RECEIVER).collect();
        let sources = Sources::new(world, space, &receivers, seed);
        let of = |s: usize| sources.nth(s).map(|source| sources.lit(&source));
        let direct: Vec<Vec<f32>> = (0..FITTED + JUDGES).into_par_iter().filter_map(of).collect();
        let total: f32 = receivers.iter().map(|(r, _)| r.area).sum();
        let share = |e: &[f32], f: &dyn Fn(f32) -> f32| {
            e.iter().zip(&receivers).map(|(e, (r, _))| f(*e) * r.area).sum::<f32>() / total.max(f32::MIN_POSITIVE)
        };
        let direct: Vec<Vec<f32>> =
            direct.into_iter().filter(|e| share(e, &|e| f32::from(u8::from(e > 0.0))) >= LEAST_LIT).collect();
        if direct.len() < 2 * STEP {
            return Self::none(texels);
        }
        let mut light = reflected(world, stand_ins, &receivers, texels, &direct);
        let count = direct.len();
        let mut scale = vec![0.0f32; count];
        for (r, t) in &receivers {
            let own = &light[*t as usize * count..][..count];
            scale.iter_mut().zip(own).for_each(|(s, e)| *s += e * e * r.area);
        }
        scale.iter_mut().for_each(|s| *s = (total / s.max(f32::MIN_POSITIVE)).sqrt());
        light.par_chunks_exact_mut(count).for_each(|own| {
            own.iter_mut().zip(&scale).for_each(|(e, s)| *e *= s);
            let (judges, fitted): (Vec<_>, Vec<_>) = own.iter().enumerate().partition(|(i, _)| i % STEP == STEP - 1);
            let sorted: Vec<f32> = fitted.into_iter().chain(judges).map(|(_, e)| *e).collect();
            own.copy_from_slice(&sorted);
        });
        let judges = count / STEP;
        let fitted = count - judges;
        let deviation = light
            .par_chunks_exact(count)
            .map(|own| (own[..fitted].iter().map(|e| e * e).sum::<f32>() / fitted as f32 + LEAST_VARIANCE).sqrt())
            .collect();
        Self { fitted, judges, light, deviation }
    }

    /// Number of states.
    pub fn count(&self) -> usize {
        self.fitted + self.judges
    }

    /// Asks for what [`Self::of`] gives for a texel, which does not lie in a cache after another.
    #[inline(always)]
    pub fn prefetch(&self, texel: u32) {
        let first = texel as usize * self.count();
        (first..first + self.count()).step_by(CACHE_LINE).for_each(|i| prefetch(&self.light, i));
    }

    /// Irradiance of a texel in all states.
    #[inline(always)]
    pub fn of(&self, texel: u32) -> &[f32] {
        &self.light[texel as usize * self.count()..][..self.count()]
    }
}

/// A light.
enum Source {
    /// Direction towards it.
    Sun(Vec3),
    /// Its place.
    Lamp(Vec3),
}

/// Where lights may be.
struct Sources<'a> {
    world: &'a World<'a>,
    space: &'a Space,
    receivers: &'a [&'a (Receiver, u32)],
    /// The scene's diagonal (m).
    size: f32,
    seed: u32,
}

impl<'a> Sources<'a> {
    fn new(world: &'a World<'a>, space: &'a Space, receivers: &'a [&'a (Receiver, u32)], seed: u32) -> Self {
        let (low, high) = world.scene.bounds();
        Self { world, space, receivers, size: (high - low).length(), seed }
    }

    /// Suns and lamps by turns; a lamp where the sun lights nothing.
    fn nth(&self, s: usize) -> Option<Source> {
        let random = rand2(self.seed ^ 0x5757, s as u32, 0);
        let towards = sphere(random).with_y(sphere(random).y.abs());
        let sun = Source::Sun(towards);
        let scouts = || self.receivers.iter().step_by(self.receivers.len().div_ceil(SCOUTS).max(1));
        if s.is_multiple_of(2) && scouts().any(|(r, _)| self.at(&sun, r) > 0.0) {
            return Some(sun);
        }
        // By trial, so that a voxel more or less among the open ones moves no lamp but its own.
        let count = self.space.open.len();
        let voxel = |k: u32| (rand(self.seed ^ 0x5758, s as u32, k) * count as f32) as usize;
        let open = (0..TRIES).map(voxel).find(|v| self.space.open.get(*v) == Some(&true));
        open.map(|v| Source::Lamp(self.space.centre(v)))
    }

    fn lit(&self, source: &Source) -> Vec<f32> {
        self.receivers.iter().map(|(r, _)| self.at(source, r)).collect()
    }

    /// Irradiance of a receiver.
    fn at(&self, source: &Source, r: &Receiver) -> f32 {
        let towards = match source {
            Source::Sun(direction) => *direction * 2.0 * self.size,
            Source::Lamp(position) => *position - r.position,
        };
        let direction = towards.normalize_or_zero();
        let cosine = direction.dot(r.normal);
        if cosine <= 0.0
            || direction.dot(r.geometric_normal) <= 0.0
            || !self.world.sees(&r.into(), r.position + towards)
        {
            return 0.0;
        }
        match source {
            Source::Sun(_) => cosine,
            Source::Lamp(_) => cosine / towards.length_squared().max((NEAREST * self.size).powi(2)),
        }
    }
}

/// Adds the light of one reflection to `direct`, `[state][receiver]`, and gives all by texel, `[texel][state]`.
fn reflected(
    world: &World<'_>,
    stand_ins: &StandIns,
    receivers: &[&(Receiver, u32)],
    texels: usize,
    direct: &[Vec<f32>],
) -> Vec<f32> {
    let count = direct.len();
    let mut by_texel = vec![0.0f32; texels * count];
    for (i, (_, t)) in receivers.iter().enumerate() {
        let own = &mut by_texel[*t as usize * count..][..count];
        own.iter_mut().zip(direct).for_each(|(e, state)| *e = state[i]);
    }
    let gathered = |(r, t): &&(Receiver, u32)| {
        let about = frame(r.normal);
        let mut sum = by_texel[*t as usize * count..][..count].to_vec();
        for ray in 0..RAYS {
            let direction = about.world_from_local(cosine_hemisphere(hammersley(ray, RAYS)));
            let met = world.closest_from(r, direction).map(|seen| stand_ins.of(world, &seen));
            if let Some(met) = met.filter(|t| *t != NO_RECEIVER) {
                // Of irradiance E the radiance E·albedo/π leaves; a ray stands for π/RAYS.
                let light = &by_texel[met as usize * count..][..count];
                sum.iter_mut().zip(light).for_each(|(s, e)| *s += ALBEDO / RAYS as f32 * e);
            }
        }
        (*t, sum)
    };
    let sums: Vec<(u32, Vec<f32>)> = receivers.par_iter().map(gathered).collect();
    for (t, sum) in sums {
        by_texel[t as usize * count..][..count].copy_from_slice(&sum);
    }
    by_texel
}

#[cfg(test)]
mod tests {
    use super::super::atlas::Atlas;
    use super::super::charts::Patches;
    use super::super::reach::Reach;
    use super::*;
    use crate::scene::built_in;
    use std::sync::Arc;

    #[test]
    fn states_are_light_that_can_happen_and_weigh_the_same() {
        let scene = built_in::two_rooms(0.05, 0.0);
        let (world, patches) = (World::new(&scene).unwrap(), Patches::new(&scene, 0.1));
        let reach = Reach::new(&world, &patches, 1).unwrap();
        let atlas = Arc::new(Atlas::new(&world, &patches, &reach.exposed, 600));
        let receivers: Vec<(Receiver, u32)> = atlas.texels.iter().zip(0..).map(|(t, i)| (t.receiver, i)).collect();
        let stand_ins = StandIns::new(&world, atlas.clone(), |_| true);
        let states = States::new(&world, &reach.space, &stand_ins, &receivers, receivers.len(), 1);
        assert!(states.judges * 4 <= states.fitted && states.judges * 5 > states.fitted, "{}", states.judges);
        let middle = scene.bounds().0.midpoint(scene.bounds().1).x;
        let mut both = 0;
        for s in 0..states.count() {
            let (mut squares, mut area, mut sides) = (0.0, 0.0, [0.0f32; 2]);
            for (r, t) in &receivers {
                let light = states.of(*t)[s];
                assert!(light >= 0.0 && light.is_finite());
                squares += light * light * r.area;
                area += r.area;
                sides[usize::from(r.position.x > middle)] += light * r.area;
            }
            assert!((squares / area - 1.0).abs() < 1e-3, "state {s}: {}", squares / area);
            both += usize::from(sides[0] > 0.0 && sides[1] > 0.0);
        }
        // Rooms without a sun: every lamp stands in one of them, and its light stays there.
        assert_eq!(both, 0, "of {}", states.count());
        assert!(states.deviation.iter().all(|d| d.is_finite() && *d > 0.0));
    }
}
