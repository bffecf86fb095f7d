//! Light sources and how a path samples them.

use super::surface::{alpha_passes, geometric_normal, position_error};
use crate::scene::{Alpha, Light, Scene};
use glam::Vec3;
use std::f32::consts::PI;

/// The sources of a scene, chosen in proportion to their power. The constant environment is not among them: cosine
/// sampling of the surface already follows it exactly.
pub struct Lights {
    sources: Vec<Source>,
    /// Probability of each source up to and with itself; ends in 1.
    cumulative: Vec<f32>,
    probability: Vec<f32>,
    /// Power of all sources, in the units of [`Lights::area_pdf`].
    total_power: f32,
}

enum Source {
    /// Front side of a triangle.
    Triangle { index: u32, corners: [Vec3; 3], normal: Vec3, area: f32, radiance: Vec3, offset: f32, masked: bool },
    /// A light without a surface.
    Delta(Light),
}

/// Light towards a point from one sampled place.
pub struct LightSample {
    /// Where a shadow ray starts from is the vertex's business; it ends here (m); `None` for parallel light.
    pub target: Option<Vec3>,
    /// Unit direction towards the light.
    pub wi: Vec3,
    /// Radiance divided by the probability density (over solid angle) of this sample; for lights without a surface
    /// the perpendicular irradiance divided by the probability of the light.
    pub estimate: Vec3,
    /// Density over solid angle, 0 for lights without a surface (nothing else can sample them).
    pub pdf_solid_angle: f32,
    /// Triangle sampled, so that its own surface does not shadow it.
    pub triangle: u32,
}

impl Lights {
    /// Collects the sources of a scene.
    pub fn new(scene: &Scene) -> Self {
        let (lo, hi) = scene.bounds();
        let radius = 0.5 * (hi - lo).length().max(1e-6);
        let mut sources = Vec::new();
        let mut powers = Vec::new();
        for light in &scene.lights {
            sources.push(Source::Delta(*light));
            powers.push(luminance(power(light, radius)));
        }
        for (i, triangle) in scene.triangles.iter().enumerate() {
            let material = &scene.materials[triangle.material as usize];
            let (radiance, masked) = (material.emission, matches!(material.alpha, Alpha::Mask(_)));
            let corners = scene.corners(triangle);
            let area = 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).length();
            if radiance.max_element() > 0.0 && area > 0.0 {
                let (normal, offset) = (geometric_normal(corners), position_error(corners));
                sources.push(Source::Triangle { index: i as u32, corners, normal, area, radiance, offset, masked });
                powers.push(PI * luminance(radiance) * area);
            }
        }
        let total: f64 = powers.iter().map(|&p| f64::from(p)).sum();
        let probability: Vec<f32> = powers.iter().map(|&p| (f64::from(p) / total) as f32).collect();
        let mut running = 0.0;
        let mut cumulative: Vec<f32> = powers
            .iter()
            .map(|&p| {
                running += f64::from(p) / total;
                running as f32
            })
            .collect();
        if let Some(last) = cumulative.last_mut() {
            *last = 1.0;
        }
        Self { sources, cumulative, probability, total_power: total as f32 }
    }

    /// Density over area with which [`Lights::sample`] chooses a point of an emissive triangle of this radiance.
    #[inline(always)]
    pub fn area_pdf(&self, radiance: Vec3) -> f32 {
        PI * luminance(radiance) / self.total_power
    }

    /// Samples one source as seen from `position`; `select` chooses the source, `point` the place on it. `None` where
    /// the chosen one sends no light there.
    #[inline(always)]
    pub fn sample(&self, scene: &Scene, position: Vec3, select: f32, point: [f32; 2]) -> Option<LightSample> {
        let i = self.cumulative.partition_point(|&c| c <= select);
        let source = self.sources.get(i)?;
        let probability = self.probability[i];
        match source {
            Source::Delta(light) => delta_sample(light, position, probability),
            Source::Triangle { index, corners, normal, radiance, offset, area, masked } => {
                let barycentric = uniform_barycentric(point);
                let [a, b, c] = *corners;
                let on_light = a * barycentric.x + b * barycentric.y + c * barycentric.z;
                let to_light = on_light - position;
                let distance2 = to_light.length_squared();
                let wi = to_light / distance2.sqrt();
                let cos_light = -wi.dot(*normal);
                // Back side, grazing, or a point on the light itself.
                if cos_light <= 0.0 || distance2 == 0.0 || (*masked && alpha_passes(scene, *index, barycentric)) {
                    return None;
                }
                let pdf = probability / area * distance2 / cos_light;
                (pdf.is_finite() && pdf > 0.0).then(|| LightSample {
                    target: Some(on_light + *normal * *offset),
                    wi,
                    estimate: *radiance / pdf,
                    pdf_solid_angle: pdf,
                    triangle: *index,
                })
            }
        }
    }
}

/// Flux of a light without a surface (W); of parallel light through a disk as large as the scene.
fn power(light: &Light, scene_radius: f32) -> Vec3 {
    match *light {
        Light::Point { intensity, .. } => 4.0 * PI * intensity,
        Light::Spot { intensity, cos_inner, cos_outer, .. } => {
            // Between the cones the squared ramp has the mean 1/3.
            2.0 * PI * intensity * ((1.0 - cos_inner) + (cos_inner - cos_outer).max(0.0) / 3.0)
        }
        Light::Directional { irradiance, .. } => PI * scene_radius * scene_radius * irradiance,
    }
}

/// glTF's recommended cone falloff (KHR_lights_punctual): the squared ramp between the cones' cosines.
pub fn spot_falloff(cos: f32, cos_inner: f32, cos_outer: f32) -> f32 {
    let scale = 1.0 / (cos_inner - cos_outer).max(0.001);
    let ramp = ((cos - cos_outer) * scale).clamp(0.0, 1.0);
    ramp * ramp
}

fn delta_sample(light: &Light, position: Vec3, probability: f32) -> Option<LightSample> {
    let (target, wi, irradiance) = match *light {
        Light::Directional { direction, irradiance } => (None, -direction, irradiance),
        Light::Point { position: at, intensity } => {
            let to_light = at - position;
            (Some(at), to_light.try_normalize()?, intensity / to_light.length_squared())
        }
        Light::Spot { position: at, direction, intensity, cos_inner, cos_outer } => {
            let to_light = at - position;
            let wi = to_light.try_normalize()?;
            let falloff = spot_falloff(-wi.dot(direction), cos_inner, cos_outer);
            (Some(at), wi, intensity * falloff / to_light.length_squared())
        }
    };
    let estimate = irradiance / probability;
    (estimate.is_finite() && estimate.max_element() > 0.0).then_some(LightSample {
        target,
        wi,
        estimate,
        pdf_solid_angle: 0.0,
        triangle: super::trace::NO_TRIANGLE,
    })
}

/// Maps the unit square to corner weights, uniformly over the area, with little distortion: Heitz, "A Low-Distortion
/// Map Between Triangle and Square", 2019.
#[inline(always)]
fn uniform_barycentric([u, v]: [f32; 2]) -> Vec3 {
    // By the smaller one, without a branch that chance would decide.
    let half = 0.5 * if v > u { u } else { v };
    let (x, y) = (u - half, v - half);
    Vec3::new(x, y, 1.0 - x - y)
}

/// Rec. 709 luminance of a spectrum, the measure by which sources are chosen; never 0 for a light that emits.
#[inline(always)]
fn luminance(rgb: Vec3) -> f32 {
    rgb.dot(Vec3::new(0.2126, 0.7152, 0.0722)).max(1e-3 * rgb.max_element())
}
