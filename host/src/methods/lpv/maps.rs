//! Reflective shadow maps of a scene's lights: which there are, what changed, and tracing them.

use super::super::{Input, MethodError};
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::scene::{Light, Scene};
use glam::{Vec3, Vec4};
use interreflect_kernels::lpv::rsm::lpv_rsm;
use interreflect_shared::lpv::{MAP_ENVIRONMENT, RsmMap, RsmParams, RsmTexel};
use interreflect_shared::scene::{LIGHT_DIRECTIONAL, LIGHT_POINT, LIGHT_SPOT, LIGHT_TRIANGLE};
use std::f32::consts::PI;

/// Rays of all maps together where the resolution is left to us.
const AUTOMATIC_RAYS: f32 = 262_144.0;
/// Smallest and largest automatic resolution.
const AUTOMATIC: [u32; 2] = [16, 512];
/// Texels that are kept at once, at most: 64 MiB. More maps are traced again whenever light changes.
const TEXELS_AT_ONCE: u32 = 1 << 20;

/// What a map was traced from.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Source {
    Light(Light),
    /// All emissive triangles: flux (W).
    Emitters(Vec3),
    Environment(Vec3),
}

/// The maps of a scene and their texels.
pub struct Maps {
    /// Texels along each side.
    pub resolution: u32,
    maps: Vec<RsmMap>,
    traced: Vec<Option<Source>>,
    seed: u32,
    maps_buffer: BufferId,
    /// Texels of as many maps as fit at once.
    pub texels: BufferId,
    uniform: BufferId,
    /// Maps that fit at once.
    at_once: u32,
    /// Maps that the last update traced.
    pub traced_count: u32,
}

impl Maps {
    /// Allocates for the lights of a scene; `resolution` 0 chooses.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn new(exec: &mut dyn Executor, input: &Input<'_>, resolution: u32) -> Result<Self, ExecError> {
        let sources = sources(input.scene);
        let (low, high) = input.scene.bounds();
        let centre_radius = ((low + high) * 0.5).extend(0.5 * (high - low).length() * 1.001);
        let maps: Vec<RsmMap> =
            sources.iter().enumerate().map(|(k, source)| map(source, k as u32, input.scene, centre_radius)).collect();
        let count = maps.len().max(1) as u32;
        let automatic = ((AUTOMATIC_RAYS / count as f32).sqrt() as u32).clamp(AUTOMATIC[0], AUTOMATIC[1]) & !1;
        let resolution = if resolution > 0 { resolution } else { automatic };
        let square = resolution * resolution;
        let maps: Vec<RsmMap> = maps.into_iter().map(|m| RsmMap { ray_count: square, ..m }).collect();
        let at_once = (TEXELS_AT_ONCE / square).clamp(1, count);
        Ok(Self {
            resolution,
            traced: vec![None; maps.len()],
            seed: input.seed,
            maps_buffer: exec.upload_slice("shadow maps", &maps)?,
            texels: exec.zeroed_slice::<RsmTexel>("shadow map texels", (at_once * square) as usize)?,
            uniform: exec.zeroed_slice::<RsmParams>("shadow map parameters", 1)?,
            maps,
            at_once,
            traced_count: 0,
        })
    }

    /// Maps.
    pub fn count(&self) -> u32 {
        self.maps.len() as u32
    }

    /// Groups of maps that fit at once.
    pub fn batches(&self) -> u32 {
        self.count().div_ceil(self.at_once)
    }

    /// Whether the lights are still the ones that the maps were made for, in number and kind.
    pub fn fit(&self, scene: &Scene) -> bool {
        let sources = sources(scene);
        sources.len() == self.maps.len() && sources.iter().zip(&self.maps).all(|(s, m)| kind(s) == m.kind)
    }

    /// Traces the maps of one batch whose light changed; gives the number of texels of the batch.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn trace(&mut self, exec: &mut dyn Executor, input: &Input<'_>, batch: u32) -> Result<u32, MethodError> {
        let sources = sources(input.scene);
        let first = batch * self.at_once;
        let end = (first + self.at_once).min(self.count());
        let square = self.resolution * self.resolution;
        let stale = self.batches() > 1 || self.seed != input.seed;
        self.seed = input.seed;
        for k in first..end {
            let source = Some(sources[k as usize]);
            if !stale && self.traced[k as usize] == source {
                continue;
            }
            self.traced[k as usize] = source;
            self.traced_count += 1;
            exec.write(self.maps_buffer, bytemuck::cast_slice(&self.maps[first as usize..end as usize]))?;
            let params = RsmParams {
                environment: input.scene.environment.extend(0.0),
                resolution: self.resolution,
                first: (k - first) * square,
                count: square,
                light_count: input.buffers.light_count,
                seed: input.seed,
                _pad0: 0,
                _pad1: 0,
                _pad2: 0,
            };
            exec.write(self.uniform, bytemuck::bytes_of(&params))?;
            let b = input.buffers;
            let bound =
                [self.uniform, b.nodes, b.triangles, b.attributes, b.surfaces, b.lights, self.maps_buffer, self.texels];
            exec.run(&lpv_rsm::KERNEL, &bound)?;
        }
        Ok((end - first) * square)
    }

    /// Forgets what was traced: the scene's geometry changed.
    pub fn forget(&mut self) {
        self.traced.fill(None);
    }
}

/// Lights without a surface in the scene's order, then emissive triangles and the environment, where there are any.
fn sources(scene: &Scene) -> Vec<Source> {
    let mut sources: Vec<Source> = scene.lights.iter().map(|l| Source::Light(*l)).collect();
    let emitted = emitted_flux(scene);
    if emitted != Vec3::ZERO {
        sources.push(Source::Emitters(emitted));
    }
    if scene.environment != Vec3::ZERO {
        sources.push(Source::Environment(scene.environment));
    }
    sources
}

/// Flux (W) of all emissive triangles: π · radiance · area.
fn emitted_flux(scene: &Scene) -> Vec3 {
    if scene.materials.iter().all(|m| m.emission == Vec3::ZERO) {
        return Vec3::ZERO;
    }
    let flux = |t: &crate::scene::Triangle| {
        let [a, b, c] = scene.corners(t);
        scene.materials[t.material as usize].emission * (0.5 * PI * (b - a).cross(c - a).length())
    };
    scene.triangles.iter().map(flux).sum()
}

fn kind(source: &Source) -> u32 {
    match source {
        Source::Light(Light::Point { .. }) => LIGHT_POINT,
        Source::Light(Light::Spot { .. }) => LIGHT_SPOT,
        Source::Light(Light::Directional { .. }) => LIGHT_DIRECTIONAL,
        Source::Emitters(_) => LIGHT_TRIANGLE,
        Source::Environment(_) => MAP_ENVIRONMENT,
    }
}

fn map(source: &Source, k: u32, scene: &Scene, centre_radius: Vec4) -> RsmMap {
    let light = if matches!(source, Source::Light(_)) { k } else { scene.lights.len() as u32 };
    RsmMap { centre_radius, kind: kind(source), light, first: 0, ray_count: 0 }
}

/// Bound of the flux (W) that all lights send into a scene of a bounding sphere of `radius`: the largest channel.
pub fn flux_bound(scene: &Scene) -> f32 {
    let (low, high) = scene.bounds();
    let radius = 0.5 * (high - low).length();
    let flux = |light: &Light| match *light {
        Light::Point { intensity, .. } => intensity * (4.0 * PI),
        Light::Spot { intensity, cos_outer, .. } => intensity * (2.0 * PI * (1.0 - cos_outer)),
        Light::Directional { irradiance, .. } => irradiance * (4.0 * radius * radius),
    };
    let lights: Vec3 = scene.lights.iter().map(flux).sum();
    (lights + emitted_flux(scene) + scene.environment * (4.0 * PI * PI * radius * radius)).max_element()
}
