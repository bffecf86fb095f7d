//! The scene packed into the buffers that kernels read (`interreflect_shared::scene`).

use super::bvh::Bvh;
use super::{Alpha, Light, Material, Scene};
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use glam::Vec3;
use interreflect_kernels::math::octahedral;
use interreflect_kernels::trace::surface::{srgb_table, tint};
use interreflect_shared::scene::{
    BvhNode, LIGHT_DIRECTIONAL, LIGHT_POINT, LIGHT_SPOT, LIGHT_TRIANGLE, MATERIAL_WORDS, NO_TEXTURE, SRGB_TABLE_WORDS,
    SceneLight, SceneMaterial, SceneTriangle, TRIANGLE_EMITS, TRIANGLE_MASKED, TriangleAttributes, WRAP_U_SHIFT,
    WRAP_V_SHIFT,
};

/// Buffers of one scene in one executor.
#[derive(Clone, Copy, Debug)]
pub struct SceneBuffers {
    /// `[BvhNode]`.
    pub nodes: BufferId,
    /// `[SceneTriangle]`.
    pub triangles: BufferId,
    /// `[TriangleAttributes]`.
    pub attributes: BufferId,
    /// Words: sRGB table, `SceneMaterial`s, texels.
    pub surfaces: BufferId,
    /// `[SceneLight]`: lights without a surface, then emissive triangles.
    pub lights: BufferId,
    /// Number of lights.
    pub light_count: u32,
    /// Number of triangles.
    pub triangle_count: u32,
}

impl SceneBuffers {
    /// Packs a scene and uploads it. Scenes without triangles or lights are legal.
    ///
    /// # Errors
    /// A buffer that the executor cannot hold.
    pub fn upload(exec: &mut dyn Executor, scene: &Scene) -> Result<Self, ExecError> {
        PackedScene::new(scene).upload(exec)
    }

    /// The buffers in the order in which every kernel of `trace` binds them.
    pub fn trace_bindings(&self) -> [BufferId; 4] {
        [self.nodes, self.triangles, self.attributes, self.surfaces]
    }
}

/// A scene in the form of its buffers, on the host: for kernels called as plain functions.
#[derive(Clone, Debug)]
pub struct PackedScene {
    /// Four-wide BVH.
    pub nodes: Vec<BvhNode>,
    /// Triangles in the order of the leaves.
    pub triangles: Vec<SceneTriangle>,
    /// Attributes in the same order.
    pub attributes: Vec<TriangleAttributes>,
    /// sRGB table, materials, texels.
    pub surfaces: Vec<u32>,
    /// Lights without a surface, then emissive triangles, both in the scene's order.
    pub lights: Vec<SceneLight>,
}

impl PackedScene {
    /// Builds the BVH and packs everything.
    pub fn new(scene: &Scene) -> Self {
        let corners: Vec<[Vec3; 3]> = scene.triangles.iter().map(|t| scene.corners(t)).collect();
        let bvh = Bvh::build(&corners);
        let triangles: Vec<SceneTriangle> = bvh.order.iter().map(|&source| pack_triangle(scene, source)).collect();
        let attributes = bvh.order.iter().map(|&source| pack_attributes(scene, source)).collect();
        let lights = pack_lights(scene, &triangles);
        Self { nodes: bvh.nodes, triangles, attributes, surfaces: pack_surfaces(scene), lights }
    }

    /// The scene as kernels see it.
    pub fn view(&self) -> interreflect_kernels::trace::SceneRef<'_> {
        interreflect_kernels::trace::SceneRef {
            nodes: &self.nodes,
            triangles: &self.triangles,
            attributes: &self.attributes,
            surfaces: &self.surfaces,
        }
    }

    /// Packs the lights again: what moved is nothing but lights without a surface, as many as before.
    pub fn relight(&mut self, scene: &Scene) {
        self.lights = pack_lights(scene, &self.triangles);
    }

    /// Uploads every buffer.
    ///
    /// # Errors
    /// A buffer that the executor cannot hold.
    pub fn upload(&self, exec: &mut dyn Executor) -> Result<SceneBuffers, ExecError> {
        Ok(SceneBuffers {
            nodes: exec.upload_slice("scene nodes", &self.nodes)?,
            triangles: exec.upload_slice("scene triangles", &self.triangles)?,
            attributes: exec.upload_slice("scene attributes", &self.attributes)?,
            surfaces: exec.upload_slice("scene surfaces", &self.surfaces)?,
            lights: exec.upload_slice("scene lights", &self.lights)?,
            light_count: self.lights.len() as u32,
            triangle_count: self.triangles.len() as u32,
        })
    }
}

fn pack_triangle(scene: &Scene, source: u32) -> SceneTriangle {
    let triangle = &scene.triangles[source as usize];
    let [v0, v1, v2] = scene.corners(triangle).map(|p| p.to_array());
    let material = &scene.materials[triangle.material as usize];
    let masked = if matches!(material.alpha, Alpha::Mask(_)) { TRIANGLE_MASKED } else { 0 };
    let emits = if material.emission.max_element() > 0.0 { TRIANGLE_EMITS } else { 0 };
    SceneTriangle { v0, material: triangle.material, v1, flags: masked | emits, v2, source }
}

fn pack_attributes(scene: &Scene, source: u32) -> TriangleAttributes {
    let vertices = scene.triangles[source as usize].vertices;
    let [a, b, c] = vertices.map(|v| scene.uvs.get(v as usize).copied().unwrap_or_default());
    let normals = vertices.map(|v| octahedral::pack(scene.normals.get(v as usize).copied().unwrap_or(Vec3::Y)));
    let tints = vertices.map(|v| scene.colours.get(v as usize).map_or(0, |colour| tint(*colour)));
    TriangleAttributes { uv: [a.x, a.y, b.x, b.y, c.x, c.y], normals, tints }
}

/// The sRGB table, the materials, then each texture once.
fn pack_surfaces(scene: &Scene) -> Vec<u32> {
    let mut next = SRGB_TABLE_WORDS + scene.materials.len() as u32 * MATERIAL_WORDS;
    let texture_first: Vec<u32> = scene
        .textures
        .iter()
        .map(|t| {
            let first = next;
            next += t.srgba.len() as u32;
            first
        })
        .collect();
    let mut words = Vec::with_capacity(next as usize);
    words.extend(srgb_table());
    for material in &scene.materials {
        words.extend_from_slice(bytemuck::cast_slice(&[pack_material(scene, material, &texture_first)]));
    }
    words.extend(scene.textures.iter().flat_map(|t| t.srgba.iter().map(|&texel| u32::from_le_bytes(texel))));
    words
}

fn pack_material(scene: &Scene, material: &Material, texture_first: &[u32]) -> SceneMaterial {
    let texture = material.texture.map(|t| (&scene.textures[t as usize], texture_first[t as usize]));
    let wrap = (material.wrap[0] as u32) << WRAP_U_SHIFT | (material.wrap[1] as u32) << WRAP_V_SHIFT;
    let (first, size) = texture.map_or((NO_TEXTURE, 0), |(t, first)| (first | wrap, t.width | (t.height << 16)));
    SceneMaterial {
        albedo: material.albedo.to_array(),
        texture_first: first,
        emission: material.emission.to_array(),
        texture_size: size,
        alpha_factor: material.alpha_factor,
        alpha_cutoff: if let Alpha::Mask(cutoff) = material.alpha { cutoff } else { -1.0 },
        metallic: material.metallic,
        roughness: material.roughness,
    }
}

/// Lights without a surface in the scene's order, then emissive triangles, with the distribution to pick them by power.
fn pack_lights(scene: &Scene, triangles: &[SceneTriangle]) -> Vec<SceneLight> {
    let mut lights: Vec<SceneLight> = scene.lights.iter().map(pack_light).collect();
    // The order of the leaves hangs on rounding; with it every method that samples lights would.
    let mut emissive: Vec<&SceneTriangle> = triangles.iter().filter(|t| t.flags & TRIANGLE_EMITS != 0).collect();
    emissive.sort_by_key(|t| t.source);
    lights.extend(emissive.into_iter().map(|t| pack_emitter(t, scene.materials[t.material as usize].emission)));
    let (lo, hi) = scene.bounds();
    let radius = (hi - lo).length() * 0.5;
    distribute(&mut lights, radius);
    lights
}

fn pack_light(light: &Light) -> SceneLight {
    let none = SceneLight {
        a: [0.0; 3],
        kind: LIGHT_POINT,
        b: [0.0; 3],
        area: 0.0,
        c: [0.0; 3],
        cumulative: 0.0,
        radiance: [0.0; 3],
        probability: 0.0,
    };
    match *light {
        Light::Point { position, intensity } => {
            SceneLight { a: position.to_array(), radiance: intensity.to_array(), ..none }
        }
        Light::Spot { position, direction, intensity, cos_inner, cos_outer } => SceneLight {
            a: position.to_array(),
            kind: LIGHT_SPOT,
            b: direction.to_array(),
            c: [cos_inner, cos_outer, 0.0],
            radiance: intensity.to_array(),
            ..none
        },
        Light::Directional { direction, irradiance } => {
            SceneLight { kind: LIGHT_DIRECTIONAL, b: direction.to_array(), radiance: irradiance.to_array(), ..none }
        }
    }
}

fn pack_emitter(triangle: &SceneTriangle, radiance: Vec3) -> SceneLight {
    let [a, b, c] = [triangle.v0, triangle.v1, triangle.v2].map(Vec3::from_array);
    SceneLight {
        a: triangle.v0,
        kind: LIGHT_TRIANGLE,
        b: triangle.v1,
        area: 0.5 * (b - a).as_dvec3().cross((c - a).as_dvec3()).length() as f32,
        c: triangle.v2,
        cumulative: 0.0,
        radiance: radiance.to_array(),
        probability: 0.0,
    }
}

/// Fills in probabilities in proportion to luminous power. `radius`: of the scene's bounding sphere, across which a
/// directional light arrives.
fn distribute(lights: &mut [SceneLight], radius: f32) {
    let powers: Vec<f64> = lights.iter().map(|light| power(light, radius)).collect();
    let total: f64 = powers.iter().sum();
    let even = 1.0 / lights.len().max(1) as f64;
    let last_lit = powers.iter().rposition(|&p| p > 0.0);
    let mut sum = 0.0;
    for (k, (light, power)) in lights.iter_mut().zip(&powers).enumerate() {
        let probability = if total > 0.0 { power / total } else { even };
        sum += probability;
        light.probability = probability as f32;
        // Rounding must not leave a gap behind the last light that gives any.
        light.cumulative = if last_lit.is_none_or(|last| k >= last) && total > 0.0 { 1.0 } else { sum as f32 };
    }
    if let (Some(last), false) = (lights.last_mut(), total > 0.0) {
        last.cumulative = 1.0;
    }
}

/// Luminous flux (W, weighted) that a light sends into the scene.
fn power(light: &SceneLight, radius: f32) -> f64 {
    use std::f64::consts::PI;
    let [r, g, b] = light.radiance.map(f64::from);
    let luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    let measure = match light.kind {
        LIGHT_POINT => 4.0 * PI,
        // Between the cones the squared ramp has the mean 1/3.
        LIGHT_SPOT => 2.0 * PI * f64::from(1.0 - light.c[0] + (light.c[0] - light.c[1]).max(0.0) / 3.0),
        LIGHT_DIRECTIONAL => PI * f64::from(radius).powi(2),
        _ => PI * f64::from(light.area),
    };
    (luminance * measure).max(0.0)
}
