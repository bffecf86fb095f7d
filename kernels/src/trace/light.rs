//! Direct light at a receiver, with shadow rays.
//!
//! Lights without extent need one ray. An emissive triangle is the ratio estimator of Heitz, Hill & McGuire 2018
//! ("Combining Analytic Direct Illumination and Stochastic Shadows"): Lambert's exact irradiance of the triangle above
//! the horizon, times the visible share of area samples weighted by what each would give. Where the triangle is wholly
//! visible the result has no noise; where partly, its bias falls with the number of samples. Triangles that look small take the area samples themselves, whose weights then
//! hardly differ, while Lambert's sum would cancel. Sample points: the R2 sequence (Roberts 2018), shifted by a hash per
//! receiver and light, mapped to the triangle by Heitz 2019.

use super::ray::Ray;
use super::surface::{leave_surface, unit_or};
use super::{SceneRef, any_hit};
use crate::math::float::{abs, atan2, max, min, sqrt};
use crate::math::frame::Frame;
use crate::math::rng::{hash, rotate, unit};
use crate::math::sampling::{self, cosine_hemisphere};
use crate::math::vector::length;
use core::f32::consts::PI;
use glam::{Vec2, Vec3};
use interreflect_shared::scene::{LIGHT_DIRECTIONAL, LIGHT_SPOT, LIGHT_TRIANGLE, SceneLight, Surfel};

/// A point that receives light.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Receiver {
    /// Position (m).
    pub position: Vec3,
    /// Unit normal that cosines are taken with.
    pub normal: Vec3,
    /// Unit normal of the surface itself, either side: rays leave along it.
    pub geometric_normal: Vec3,
    /// How far shadow rays start off the surface (m): [`Surfel::error`], or 0 for a point in free space.
    pub error: f32,
}

impl Receiver {
    /// The viewer's side of a surface point.
    #[inline(always)]
    pub fn of(surfel: &Surfel) -> Self {
        Self {
            position: Vec3::from_array(surfel.position),
            normal: Vec3::from_array(surfel.normal),
            geometric_normal: Vec3::from_array(surfel.geometric_normal),
            error: surfel.error,
        }
    }

    /// Cosine towards a direction, in units of its length; 0 from behind.
    #[inline(always)]
    fn cosine(&self, towards: Vec3) -> f32 {
        max(self.normal.dot(towards), 0.0)
    }

    /// Where a ray in `direction` starts.
    #[inline(always)]
    fn start(&self, direction: Vec3) -> Vec3 {
        leave_surface(self.position, self.geometric_normal, self.error, direction)
    }
}

/// Shadow rays end this share of the way to their point: 8 roundings before it.
const BEFORE_THE_POINT: f32 = 1.0 - 4.768_371_6e-7;

/// Irradiance (W/m²) from one light, shadows included. `samples`: shadow rays to an emissive triangle or the environment
/// (others take one). `scramble`: any hash of receiver and light.
///
/// Every kind of light comes here as shadow rays with weights, so that kernels hold one walk through the scene.
#[inline(always)]
pub fn light_irradiance(scene: &SceneRef<'_>, light: &SceneLight, at: &Receiver, samples: u32, scramble: u32) -> Vec3 {
    let count = if light.kind == LIGHT_TRIANGLE || light.kind == ENVIRONMENT { samples } else { 1 };
    let (mut all, mut seen) = (0.0, 0.0);
    let mut nearest = f32::MAX;
    for k in 0..count {
        let sample = shadow_sample(light, at, k, scramble);
        all += sample.weight;
        nearest = min(nearest, sample.square);
        if sample.weight > 0.0 && !any_hit(scene, &sample.ray) {
            seen += sample.weight;
        }
    }
    if seen <= 0.0 {
        return Vec3::ZERO;
    }
    let mut form = seen;
    if light.kind == ENVIRONMENT {
        form = PI * seen / count as f32;
    }
    if light.kind == LIGHT_TRIANGLE {
        form = triangle_form(light, at, seen, all, nearest, count);
    }
    Vec3::from_array(light.radiance) * form
}

/// A constant environment as a light: a kind that no buffer holds.
const ENVIRONMENT: u32 = u32::MAX;

/// The environment as a light of radiance `radiance` (W/(sr m²)).
#[inline(always)]
pub fn environment_light(radiance: Vec3) -> SceneLight {
    SceneLight {
        a: [0.0; 3],
        kind: ENVIRONMENT,
        b: [0.0; 3],
        area: 0.0,
        c: [0.0; 3],
        probability: 1.0,
        radiance: radiance.to_array(),
        cumulative: 1.0,
    }
}

/// A ray towards a light.
#[derive(Clone, Copy)]
struct ShadowSample {
    ray: Ray,
    /// What the light gives if nothing is in the ray's way, per its radiance (or intensity, or irradiance).
    weight: f32,
    /// Squared distance to a point on an emissive triangle.
    square: f32,
}

/// Ray `k` from a receiver to a light.
#[inline(always)]
fn shadow_sample(light: &SceneLight, at: &Receiver, k: u32, scramble: u32) -> ShadowSample {
    let (a, b) = (Vec3::from_array(light.a), Vec3::from_array(light.b));
    let mut target = a;
    let mut towards = a - at.position;
    let mut is_parallel = false;
    let (weight, square);
    if light.kind == LIGHT_TRIANGLE {
        let c = Vec3::from_array(light.c);
        let front = unit_or((b - a).cross(c - a), Vec3::ZERO);
        let height = max(front.dot(at.position - a), 0.0);
        let weights = sampling::triangle(r2(k, scramble));
        let point = a + (b - a) * weights.x + (c - a) * weights.y;
        // The far end leaves the lamp's surface too, so that the lamp does not shade itself.
        target = point + front * lamp_offset(light, point);
        towards = target - at.position;
        let to_point = point - at.position;
        square = to_point.dot(to_point);
        // cos · cos' / r² with both cosines in units of r.
        weight = at.cosine(to_point) * height / max(square * square, f32::MIN_POSITIVE);
    } else if light.kind == LIGHT_DIRECTIONAL {
        is_parallel = true;
        towards = -b;
        square = f32::MAX;
        weight = at.cosine(towards);
    } else if light.kind == ENVIRONMENT {
        is_parallel = true;
        towards = Frame::new(at.normal).world_from_local(cosine_hemisphere(r2(k, scramble)));
        square = f32::MAX;
        weight = 1.0;
    } else {
        let distance = length(towards);
        let mut intensity = at.cosine(towards) / max(distance * distance * distance, f32::MIN_POSITIVE);
        if light.kind == LIGHT_SPOT {
            intensity *= spot_falloff(light, -towards.dot(b) / max(distance, f32::MIN_POSITIVE));
        }
        square = f32::MAX;
        weight = intensity;
    }
    let start = at.start(towards);
    let ray = if is_parallel { Ray::new(start, towards) } else { Ray::until(start, target - start, BEFORE_THE_POINT) };
    ShadowSample { ray, weight, square }
}

/// glTF's recommended cone falloff (KHR_lights_punctual): squared ramp of the cosine between the cones.
#[inline(always)]
pub fn spot_falloff(light: &SceneLight, cosine: f32) -> f32 {
    let [cos_inner, cos_outer, _] = light.c;
    let ramp = (cosine - cos_outer) / max(cos_inner - cos_outer, SHARPEST_CONE);
    let ramp = min(max(ramp, 0.0), 1.0);
    ramp * ramp
}

/// Smallest difference of a spot's cone cosines (glTF's recommendation).
const SHARPEST_CONE: f32 = 1e-3;
/// Triangles whose area over squared distance is below this take plain area samples.
const SMALL_TRIANGLE: f32 = 0.01;

/// Irradiance per radiance of an emissive triangle: ∫ cos⁺ dω over its visible part. `seen` of the weights `all` of
/// `samples` rays were not blocked; the `nearest` sample's squared distance.
#[inline(always)]
fn triangle_form(light: &SceneLight, at: &Receiver, seen: f32, all: f32, nearest: f32, samples: u32) -> f32 {
    // One sample's ratio would be the visible share of the area, without the weights.
    if samples == 1 || light.area < SMALL_TRIANGLE * nearest {
        return seen * light.area / samples as f32;
    }
    let (a, b, c) = (Vec3::from_array(light.a), Vec3::from_array(light.b), Vec3::from_array(light.c));
    lambert(at.position, at.normal, a, b, c) * (seen / all)
}

/// How far shadow rays end before a lamp: the rounding of a point on it.
#[inline(always)]
fn lamp_offset(light: &SceneLight, point: Vec3) -> f32 {
    (max(max(abs(point.x), abs(point.y)), abs(point.z)) + sqrt(light.area)) * 16.0 * 5.960_464_5e-8
}

/// Irradiance of a uniform Lambertian triangle of radiance 1, unoccluded, above the horizon of `normal` (Lambert 1760;
/// Baum et al. 1989), counter-clockwise as the receiver sees it or not. W/m² per W/(sr m²).
pub fn lambert(position: Vec3, normal: Vec3, a: Vec3, b: Vec3, c: Vec3) -> f32 {
    let (a, b, c) = (a - position, b - position, c - position);
    let (ha, hb, hc) = (normal.dot(a), normal.dot(b), normal.dot(c));
    let mut clip = Clip { sum: 0.0, exit: Vec3::ZERO, entry: Vec3::ZERO };
    clip.edge(normal, a, b, ha, hb);
    clip.edge(normal, b, c, hb, hc);
    clip.edge(normal, c, a, hc, ha);
    // A cut triangle is closed along the horizon.
    clip.sum += edge_integral(normal, clip.exit, clip.entry);
    abs(clip.sum) * 0.5
}

/// Sum of the edges above the horizon, and where the outline leaves and enters it.
struct Clip {
    sum: f32,
    exit: Vec3,
    entry: Vec3,
}

impl Clip {
    #[inline(always)]
    fn edge(&mut self, normal: Vec3, a: Vec3, b: Vec3, ha: f32, hb: f32) {
        if ha <= 0.0 && hb <= 0.0 {
            return;
        }
        let (mut from, mut to) = (a, b);
        if ha <= 0.0 || hb <= 0.0 {
            let cut = a + (b - a) * (ha / (ha - hb));
            if ha <= 0.0 {
                from = cut;
                self.entry = cut;
            } else {
                to = cut;
                self.exit = cut;
            }
        }
        self.sum += edge_integral(normal, from, to);
    }
}

/// Angle between two vectors times the cosine between `normal` and the normal of their plane.
#[inline(always)]
fn edge_integral(normal: Vec3, a: Vec3, b: Vec3) -> f32 {
    let (a, b) = (unit_or(a, Vec3::ZERO), unit_or(b, Vec3::ZERO));
    let cross = a.cross(b);
    let sine = length(cross);
    if sine <= f32::MIN_POSITIVE {
        return 0.0;
    }
    normal.dot(cross) / sine * atan2(sine, a.dot(b))
}

/// How direct light is sampled; see [`interreflect_shared::trace::DirectParams`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DirectSampling {
    /// Lights in the buffer.
    pub light_count: u32,
    /// Shadow rays per emissive triangle, and picks.
    pub light_samples: u32,
    /// Pick lights by power when there are more than this.
    pub pick_above: u32,
    /// Radiance of the environment (W/(sr m²)).
    pub environment: Vec3,
    /// Rays to the environment; 0 leaves it out.
    pub environment_samples: u32,
}

/// Irradiance (W/m²) from all lights, each asked, or picked by power where there are many; and from the environment.
#[inline(always)]
pub fn direct_irradiance(
    scene: &SceneRef<'_>,
    lights: &[SceneLight],
    sampling: &DirectSampling,
    at: &Receiver,
    scramble: u32,
) -> Vec3 {
    let picking = sampling.light_count > sampling.pick_above;
    let picks = if picking { sampling.light_samples } else { sampling.light_count };
    let sources = picks + (sampling.environment_samples > 0) as u32;
    let offset = unit(hash(scramble));
    let mut sum = Vec3::ZERO;
    for k in 0..sources {
        let mut light = environment_light(sampling.environment);
        let (mut samples, mut share, mut seed) = (sampling.environment_samples, 1.0, hash(hash(scramble)));
        if k < picks && picking {
            light = lights[picked(lights, sampling.light_count, (k as f32 + offset) / picks as f32) as usize];
            samples = 1;
            share = if light.probability > 0.0 { 1.0 / (light.probability * picks as f32) } else { 0.0 };
            seed = hash(scramble.wrapping_add(k));
        } else if k < picks {
            light = lights[k as usize];
            samples = sampling.light_samples;
            seed = hash(scramble ^ hash(k));
        }
        if share > 0.0 {
            sum += light_irradiance(scene, &light, at, samples, seed) * share;
        }
    }
    sum
}

/// The light whose share of the cumulative power holds `u`.
fn picked(lights: &[SceneLight], count: u32, u: f32) -> u32 {
    let (mut low, mut high) = (0, count - 1);
    while low < high {
        let middle = (low + high) / 2;
        if lights[middle as usize].cumulative > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}

/// Irradiance (W/m²) from an environment of radiance 1 (W/(sr m²)): `samples` cosine-distributed rays.
pub fn environment_irradiance(scene: &SceneRef<'_>, at: &Receiver, samples: u32, scramble: u32) -> f32 {
    light_irradiance(scene, &environment_light(Vec3::ONE), at, samples, scramble).x
}

/// Point `k` of the R2 sequence, shifted by a hash.
#[inline(always)]
fn r2(k: u32, scramble: u32) -> Vec2 {
    let offset = Vec2::new(unit(hash(scramble)), unit(hash(scramble ^ 0x9E37_79B9)));
    rotate(sampling::r2(k), offset)
}
