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

    /// Whether nothing lies between the receiver and a point.
    #[inline(always)]
    fn sees(&self, scene: &SceneRef<'_>, point: Vec3) -> bool {
        let start = self.start(point - self.position);
        !any_hit(scene, &Ray::until(start, point - start, BEFORE_THE_POINT))
    }
}

/// Shadow rays end this share of the way to their point: 8 roundings before it.
const BEFORE_THE_POINT: f32 = 1.0 - 4.768_371_6e-7;

/// Irradiance (W/m²) from one light, shadows included. `samples`: shadow rays to an emissive triangle (others take one).
/// `scramble`: any hash of receiver and light.
pub fn light_irradiance(scene: &SceneRef<'_>, light: &SceneLight, at: &Receiver, samples: u32, scramble: u32) -> Vec3 {
    let radiance = Vec3::from_array(light.radiance);
    let (a, b) = (Vec3::from_array(light.a), Vec3::from_array(light.b));
    if light.kind == LIGHT_TRIANGLE {
        return radiance * triangle_form(scene, light, at, samples, scramble);
    }
    if light.kind == LIGHT_DIRECTIONAL {
        let cosine = at.cosine(-b);
        if cosine > 0.0 && !any_hit(scene, &Ray::new(at.start(-b), -b)) {
            return radiance * cosine;
        }
        return Vec3::ZERO;
    }
    let towards = a - at.position;
    let distance = length(towards);
    let mut weight = at.cosine(towards) / max(distance * distance * distance, f32::MIN_POSITIVE);
    if light.kind == LIGHT_SPOT {
        weight *= spot_falloff(light, -towards.dot(b) / max(distance, f32::MIN_POSITIVE));
    }
    if weight > 0.0 && at.sees(scene, a) { radiance * weight } else { Vec3::ZERO }
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

/// Irradiance per radiance of an emissive triangle: ∫ cos⁺ dω over its visible part.
fn triangle_form(scene: &SceneRef<'_>, light: &SceneLight, at: &Receiver, samples: u32, scramble: u32) -> f32 {
    let (a, b, c) = (Vec3::from_array(light.a), Vec3::from_array(light.b), Vec3::from_array(light.c));
    let front = unit_or((b - a).cross(c - a), Vec3::ZERO);
    let height = front.dot(at.position - a);
    if height <= 0.0 {
        return 0.0;
    }
    let (mut all, mut seen) = (0.0, 0.0);
    let mut nearest = f32::MAX;
    for k in 0..samples {
        let weights = sampling::triangle(r2(k, scramble));
        let point = a + (b - a) * weights.x + (c - a) * weights.y;
        let towards = point - at.position;
        let square = towards.dot(towards);
        nearest = min(nearest, square);
        // cos · cos' / r² with both cosines in units of r.
        let weight = at.cosine(towards) * height / max(square * square, f32::MIN_POSITIVE);
        all += weight;
        // The far end leaves the lamp's surface too, so that the lamp does not shade itself.
        if weight > 0.0 && at.sees(scene, point + front * lamp_offset(light, point)) {
            seen += weight;
        }
    }
    if seen <= 0.0 {
        return 0.0;
    }
    // One sample's ratio would be the visible share of the area, without the weights.
    if samples == 1 || light.area < SMALL_TRIANGLE * nearest {
        return seen * light.area / samples as f32;
    }
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
}

/// Irradiance (W/m²) from all lights: each asked, or picked by power where there are many. Without the environment.
pub fn direct_irradiance(
    scene: &SceneRef<'_>,
    lights: &[SceneLight],
    sampling: &DirectSampling,
    at: &Receiver,
    scramble: u32,
) -> Vec3 {
    let mut sum = Vec3::ZERO;
    if sampling.light_count <= sampling.pick_above {
        for k in 0..sampling.light_count {
            let light = lights[k as usize];
            sum += light_irradiance(scene, &light, at, sampling.light_samples, hash(scramble ^ hash(k)));
        }
        return sum;
    }
    let offset = unit(hash(scramble));
    for k in 0..sampling.light_samples {
        let pick = picked(lights, sampling.light_count, (k as f32 + offset) / sampling.light_samples as f32);
        let light = lights[pick as usize];
        if light.probability > 0.0 {
            let share = 1.0 / (light.probability * sampling.light_samples as f32);
            sum += light_irradiance(scene, &light, at, 1, hash(scramble.wrapping_add(k))) * share;
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
    let frame = Frame::new(at.normal);
    let mut open = 0;
    for k in 0..samples {
        let direction = frame.world_from_local(cosine_hemisphere(r2(k, scramble)));
        if !any_hit(scene, &Ray::new(at.start(direction), direction)) {
            open += 1;
        }
    }
    PI * open as f32 / max(samples as f32, 1.0)
}

/// Point `k` of the R2 sequence, shifted by a hash.
#[inline(always)]
fn r2(k: u32, scramble: u32) -> Vec2 {
    let offset = Vec2::new(unit(hash(scramble)), unit(hash(scramble ^ 0x9E37_79B9)));
    rotate(sampling::r2(k), offset)
}
