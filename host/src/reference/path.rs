//! The light transport estimator: one path, with next-event estimation and multiple importance sampling.
//!
//! Reflected radiance of a Lambert surface, Lₒ = ρ/π ∫ Lᵢ cos θ dω (Kajiya 1986), is estimated at every vertex by two
//! samples: a point on a light source (next-event estimation), and a direction by the cosine law, which also goes on
//! as the path. What both can find, light from emissive triangles, is weighted by the power heuristic (Veach & Guibas
//! 1995). Russian roulette divides by its survival probability, so that paths of every length count without bias;
//! nothing is clamped.

use super::light::Lights;
use super::sampler::Sampler;
use super::surface::{Vertex, surface};
use super::trace::{NO_TRIANGLE, Tracer};
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, FRAC_PI_4, PI};

/// Reflections after which Russian roulette may end a path.
const ROULETTE_FROM: u32 = 2;
/// Largest survival probability.
const ROULETTE_MAX: f32 = 0.97;
/// A shadow ray stops this fraction short of its target, more than the rounding of its direction.
const SHADOW_LENGTH: f32 = 1.0 - 4e-6;

/// A scene with its light sources, ready for paths.
pub struct Paths<'a> {
    /// Ray queries.
    pub tracer: Tracer<'a>,
    lights: Lights,
    environment: Vec3,
    max_bounces: u32,
}

/// Where a path starts.
#[derive(Clone, Copy, Debug)]
pub enum Start {
    /// A camera ray: origin and unit direction.
    Ray(Vec3, Vec3),
    /// A receiver as a white surface.
    Receiver(Vertex),
}

/// Radiance (W/(sr m²)) that one path found, by the number of its reflections.
#[derive(Clone, Copy, Default, Debug)]
pub struct PathLight {
    /// After none or one.
    pub direct: Vec3,
    /// After two or more.
    pub indirect: Vec3,
    /// Rays traced.
    pub rays: u32,
}

impl PathLight {
    #[inline]
    fn add(&mut self, reflections: u32, radiance: Vec3) {
        if reflections <= 1 {
            self.direct += radiance;
        } else {
            self.indirect += radiance;
        }
    }
}

impl<'a> Paths<'a> {
    /// Prepares paths of at most `max_bounces` reflections (`None`: of any number).
    pub fn new(tracer: Tracer<'a>, max_bounces: Option<u32>) -> Self {
        let lights = Lights::new(tracer.scene);
        let environment = tracer.scene.environment;
        Self { tracer, lights, environment, max_bounces: max_bounces.unwrap_or(u32::MAX) }
    }

    /// Light along one path.
    pub fn trace(&self, start: Start, sampler: &Sampler) -> PathLight {
        let mut light = PathLight::default();
        let mut throughput = Vec3::ONE;
        let mut reflections = 0;
        let (mut origin, mut direction, mut exclude, mut pdf) = match start {
            Start::Ray(origin, direction) => (origin, direction, NO_TRIANGLE, None),
            Start::Receiver(vertex) => {
                if self.max_bounces == 0 {
                    return light;
                }
                self.next_event(&vertex, throughput, reflections, sampler, &mut light);
                reflections = 1;
                let (wi, pdf) = cosine_direction(vertex.normal, sampler.pair(0));
                (vertex.leave(wi), wi, vertex.triangle, Some((vertex.position, pdf)))
            }
        };
        loop {
            light.rays += 1;
            let Some(hit) = self.tracer.closest(origin, direction, f32::MAX, exclude) else {
                light.add(reflections, throughput * self.environment);
                return light;
            };
            let (vertex, emission) = surface(self.tracer.scene, &hit, direction);
            if emission != Vec3::ZERO {
                // The camera's ray has no rival; a reflected ray competes with next-event estimation.
                let weight = pdf.map_or(1.0, |(from, pdf)| {
                    power_heuristic(pdf, self.emitter_pdf(emission, from, direction, &vertex))
                });
                light.add(reflections, throughput * emission * weight);
            }
            if reflections == self.max_bounces || vertex.albedo == Vec3::ZERO {
                return light;
            }
            self.next_event(&vertex, throughput, reflections, sampler, &mut light);
            throughput *= vertex.albedo;
            reflections += 1;
            let dimension = 3 * reflections;
            if reflections >= ROULETTE_FROM {
                let survival = throughput.max_element().min(ROULETTE_MAX);
                if sampler.pair(dimension + 2)[1] >= survival {
                    return light;
                }
                throughput /= survival;
            }
            let (wi, cosine_pdf) = cosine_direction(vertex.normal, sampler.pair(dimension));
            (origin, direction, exclude) = (vertex.leave(wi), wi, vertex.triangle);
            pdf = Some((vertex.position, cosine_pdf));
        }
    }

    /// Density over solid angle with which next-event estimation from `from` finds an emitter's point.
    fn emitter_pdf(&self, emission: Vec3, from: Vec3, direction: Vec3, on_light: &Vertex) -> f32 {
        let distance2 = (on_light.position - from).length_squared();
        self.lights.area_pdf(emission) * distance2 / direction.dot(on_light.geometric_normal).abs()
    }

    /// Adds what one sampled light source sends to `vertex` and on along the path.
    fn next_event(
        &self,
        vertex: &Vertex,
        throughput: Vec3,
        reflections: u32,
        sampler: &Sampler,
        light: &mut PathLight,
    ) {
        let dimension = 3 * reflections;
        let select = sampler.pair(dimension + 2)[0];
        let sample = self.lights.sample(&self.tracer, vertex.position, select, sampler.pair(dimension + 1));
        let Some(sample) = sample else { return };
        let cos = sample.wi.dot(vertex.normal);
        if cos <= 0.0 {
            return;
        }
        light.rays += 1;
        let from = vertex.leave(sample.wi);
        let blocked = match sample.target {
            Some(target) => self.shadowed(from, target, vertex.triangle, sample.triangle),
            None => self.tracer.occluded(from, sample.wi, f32::MAX, [vertex.triangle, NO_TRIANGLE]),
        };
        if blocked {
            return;
        }
        let weight =
            if sample.pdf_solid_angle > 0.0 { power_heuristic(sample.pdf_solid_angle, cos * FRAC_1_PI) } else { 1.0 };
        let brdf = vertex.albedo * FRAC_1_PI;
        light.add(reflections + 1, throughput * brdf * cos * sample.estimate * weight);
    }

    fn shadowed(&self, from: Vec3, target: Vec3, own: u32, light: u32) -> bool {
        self.tracer.occluded(from, target - from, SHADOW_LENGTH, [own, light])
    }
}

/// Irradiance from the radiance that a white receiver reflects.
pub const IRRADIANCE_PER_RADIANCE: f32 = PI;

/// Weight of a sample of density `a` that another strategy would have found with density `b` (β = 2).
fn power_heuristic(a: f32, b: f32) -> f32 {
    // As a ratio: the squares of large densities overflow.
    let r = b / a;
    1.0 / (1.0 + r * r)
}

/// Direction by the cosine law around `normal` and its density over solid angle. Concentric disk map: Shirley & Chiu,
/// "A Low Distortion Map Between Disk and Square", 1997; frame: Duff et al., "Building an Orthonormal Basis,
/// Revisited", 2017.
pub fn cosine_direction(normal: Vec3, [u, v]: [f32; 2]) -> (Vec3, f32) {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let (r, phi) = if x == 0.0 && y == 0.0 {
        (0.0, 0.0)
    } else if x.abs() > y.abs() {
        (x, FRAC_PI_4 * (y / x))
    } else {
        (y, 2.0 * FRAC_PI_4 - FRAC_PI_4 * (x / y))
    };
    let (sin, cos) = phi.sin_cos();
    let z = (1.0 - r * r).max(1e-12).sqrt();
    let sign = 1f32.copysign(normal.z);
    let a = -1.0 / (sign + normal.z);
    let b = normal.x * normal.y * a;
    let tangent = Vec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    let bitangent = Vec3::new(b, sign + normal.y * normal.y * a, -normal.y);
    ((tangent * (r * cos) + bitangent * (r * sin) + normal * z).normalize(), z * FRAC_1_PI)
}
