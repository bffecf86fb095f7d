//! The light transport estimator: one path, with next-event estimation and multiple importance sampling.
//!
//! Reflected radiance of a Lambert surface, Lₒ = ρ/π ∫ Lᵢ cos θ dω (Kajiya 1986), is estimated at every vertex by two
//! samples: a point on a light source (next-event estimation), and a direction by the cosine law, which also goes on
//! as the path. What both can find, light from emissive triangles, is weighted by the power heuristic (Veach & Guibas
//! 1995). Russian roulette divides by its survival probability, so that paths of every length count without bias;
//! nothing is clamped.

use super::light::Lights;
use super::sampler::{Points, Sampler};
use super::surface::{Surfaces, Vertex};
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
    surfaces: Surfaces<'a>,
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
    #[inline(always)]
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
        let (surfaces, lights) = (Surfaces::new(tracer.scene), Lights::new(tracer.scene));
        let environment = tracer.scene.environment;
        Self { tracer, surfaces, lights, environment, max_bounces: max_bounces.unwrap_or(u32::MAX) }
    }

    /// Light along one path.
    #[inline(always)]
    pub fn trace(&self, start: Start, sampler: &Sampler) -> PathLight {
        let mut light = PathLight::default();
        let mut throughput = Vec3::ONE;
        let mut reflections = 0;
        let mut points = sampler.points(0);
        let (mut origin, mut direction, mut exclude, mut pdf) = match start {
            Start::Ray(origin, direction) => (origin, direction, NO_TRIANGLE, None),
            Start::Receiver(vertex) => {
                if self.max_bounces == 0 {
                    return light;
                }
                self.next_event(&vertex, throughput, reflections, &points, &mut light);
                let (wi, pdf) = cosine_direction(vertex.normal, points.direction);
                (reflections, points) = (1, sampler.points(1));
                (vertex.leave(wi), wi, vertex.triangle, Some((vertex.position, pdf)))
            }
        };
        loop {
            light.rays += 1;
            // Before they are needed: a processor works on both at once.
            let next_points = sampler.points(reflections + 1);
            let Some(hit) = self.tracer.closest(origin, direction, f32::MAX, exclude) else {
                light.add(reflections, throughput * self.environment);
                return light;
            };
            let (vertex, emission) = self.surfaces.at(&hit, direction);
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
            self.next_event(&vertex, throughput, reflections, &points, &mut light);
            throughput *= vertex.albedo;
            reflections += 1;
            points = next_points;
            if reflections >= ROULETTE_FROM {
                let survival = throughput.max_element().min(ROULETTE_MAX);
                if points.choice[1] >= survival {
                    return light;
                }
                throughput /= survival;
            }
            let (wi, cosine_pdf) = cosine_direction(vertex.normal, points.direction);
            (origin, direction, exclude) = (vertex.leave(wi), wi, vertex.triangle);
            pdf = Some((vertex.position, cosine_pdf));
        }
    }

    /// Density over solid angle with which next-event estimation from `from` finds an emitter's point.
    #[inline(always)]
    fn emitter_pdf(&self, emission: Vec3, from: Vec3, direction: Vec3, on_light: &Vertex) -> f32 {
        let distance2 = (on_light.position - from).length_squared();
        self.lights.area_pdf(emission) * distance2 / direction.dot(on_light.geometric_normal).abs()
    }

    /// Adds what one sampled light source sends to `vertex` and on along the path.
    #[inline(always)]
    fn next_event(&self, vertex: &Vertex, throughput: Vec3, reflections: u32, points: &Points, light: &mut PathLight) {
        let sample = self.lights.sample(self.tracer.scene, vertex.position, points.choice[0], points.place);
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

    #[inline(always)]
    fn shadowed(&self, from: Vec3, target: Vec3, own: u32, light: u32) -> bool {
        self.tracer.occluded(from, target - from, SHADOW_LENGTH, [own, light])
    }
}

/// Irradiance from the radiance that a white receiver reflects.
pub const IRRADIANCE_PER_RADIANCE: f32 = PI;

/// Weight of a sample of density `a` that another strategy would have found with density `b` (β = 2).
#[inline(always)]
fn power_heuristic(a: f32, b: f32) -> f32 {
    // As a ratio: the squares of large densities overflow.
    let r = b / a;
    1.0 / (1.0 + r * r)
}

/// Direction by the cosine law around `normal` and its density over solid angle. Frame: Duff et al., "Building an
/// Orthonormal Basis, Revisited", 2017.
#[inline(always)]
pub fn cosine_direction(normal: Vec3, point: [f32; 2]) -> (Vec3, f32) {
    let [x, y] = concentric_disk(point);
    let z = (1.0 - (x * x + y * y)).max(1e-12).sqrt();
    let sign = 1f32.copysign(normal.z);
    let a = -1.0 / (sign + normal.z);
    let b = normal.x * normal.y * a;
    let tangent = Vec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    let bitangent = Vec3::new(b, sign + normal.y * normal.y * a, -normal.y);
    ((tangent * x + bitangent * y + normal * z).normalize(), z * FRAC_1_PI)
}

/// Maps the unit square to the unit disk, uniformly and with little distortion: Shirley & Chiu, "A Low Distortion Map
/// Between Disk and Square", 1997. Without branches, which chance would decide: half of the guesses would be wrong.
#[inline(always)]
fn concentric_disk([u, v]: [f32; 2]) -> [f32; 2] {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let along_x = x.abs() > y.abs();
    let (radius, other) = if along_x { (x, y) } else { (y, x) };
    let angle = FRAC_PI_4 * other / if radius == 0.0 { 1.0 } else { radius };
    let (near, far) = (radius * cos(angle), radius * sin(angle));
    if along_x { [near, far] } else { [far, near] }
}

/// Sine of an angle from −π/4 to π/4, to 1e-7: the polynomial of Moshier's Cephes library, `sinf.c`.
#[inline(always)]
fn sin(x: f32) -> f32 {
    let s = x * x;
    x + x * s * (-1.666_665_5e-1 + s * (8.332_161e-3 - s * 1.951_529_6e-4))
}

/// Cosine of such an angle, from the same source.
#[inline(always)]
fn cos(x: f32) -> f32 {
    let s = x * x;
    1.0 - 0.5 * s + s * s * (4.166_664_6e-2 + s * (-1.388_731_6e-3 + s * 2.443_315_7e-5))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    #[test]
    fn the_disk_is_that_of_the_published_map() {
        let mut worst: f64 = 0.0;
        for (i, j) in (0..=256).flat_map(|i| (0..=256).map(move |j| (i, j))) {
            let [u, v] = [i, j].map(|k| k as f32 / 256.0);
            let (x, y) = (2.0 * f64::from(u) - 1.0, 2.0 * f64::from(v) - 1.0);
            let (r, angle) = if x == 0.0 && y == 0.0 {
                (0.0, 0.0)
            } else if x.abs() > y.abs() {
                (x, FRAC_PI_4 * (y / x))
            } else {
                (y, FRAC_PI_2 - FRAC_PI_4 * (x / y))
            };
            let [px, py] = concentric_disk([u, v]).map(f64::from);
            worst = worst.max((px - r * angle.cos()).abs()).max((py - r * angle.sin()).abs());
        }
        assert!(worst < 2e-7, "{worst:e}");
    }

    #[test]
    fn directions_are_unit_and_follow_the_cosine_law() {
        let normals = [Vec3::X, -Vec3::Z, Vec3::new(0.6, -0.64, 0.48), Vec3::new(1e-4, 0.0, -1.0).normalize()];
        for normal in normals {
            let (mut mean, n) = (Vec3::ZERO, 256);
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let [u, v] = [i, j].map(|k| (k as f32 + 0.5) / n as f32);
                let (direction, pdf) = cosine_direction(normal, [u, v]);
                assert!((direction.length() - 1.0).abs() < 1e-6);
                assert!((direction.dot(normal) - pdf * PI).abs() < 1e-5, "{direction} {pdf}");
                mean += direction / (n * n) as f32;
            }
            // ∫ ω cos θ dω / π = 2/3 n.
            assert!((mean - normal * (2.0 / 3.0)).length() < 1e-3, "{mean} about {normal}");
        }
    }
}
