//! What a ray finds: position, normals, reflectance and emission at a hit.
//!
//! Materials and texels are words of one buffer (`interreflect_shared::scene::SceneMaterial`). Textures go on beyond their sides
//! as glTF's samplers say and are filtered bilinearly, each texel decoded from sRGB before it is weighted; texel centres lie at half-integers and row 0
//! is at v = 0, as in glTF.

use super::SceneRef;
use super::ray::{Hit, Ray};
use crate::math::float::{abs, floor, max, min};
use crate::math::octahedral;
use crate::math::vector::length;
use glam::{Vec2, Vec3};
use interreflect_shared::scene::{
    MATERIAL_WORDS, NO_SURFACE, NO_TEXTURE, SRGB_TABLE_WORDS, SceneMaterial, Surfel, TEXTURE_FIRST_MASK,
    TriangleAttributes, WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT, WRAP_U_SHIFT, WRAP_V_SHIFT,
};

/// Reflectance and alpha at a point of a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BaseColour {
    /// Reflectance per channel.
    pub albedo: Vec3,
    /// Alpha.
    pub alpha: f32,
}

/// A material read from the `surfaces` buffer.
#[inline(always)]
pub fn material(surfaces: &[u32], index: u32) -> SceneMaterial {
    let w = (SRGB_TABLE_WORDS + index * MATERIAL_WORDS) as usize;
    SceneMaterial {
        albedo: [float(surfaces, w), float(surfaces, w + 1), float(surfaces, w + 2)],
        texture_first: surfaces[w + 3],
        emission: [float(surfaces, w + 4), float(surfaces, w + 5), float(surfaces, w + 6)],
        texture_size: surfaces[w + 7],
        alpha_factor: float(surfaces, w + 8),
        alpha_cutoff: float(surfaces, w + 9),
        metallic: float(surfaces, w + 10),
        roughness: float(surfaces, w + 11),
    }
}

#[inline(always)]
fn float(surfaces: &[u32], word: usize) -> f32 {
    f32::from_bits(surfaces[word])
}

/// Reflectance and alpha of a material at a point of a triangle.
#[inline(always)]
pub fn base_colour(surfaces: &[u32], m: &SceneMaterial, t: &TriangleAttributes, u: f32, v: f32) -> BaseColour {
    let colour = textured(surfaces, m, texture_coordinate(t, u, v));
    BaseColour { albedo: colour.albedo * vertex_colour(t, u, v), alpha: colour.alpha }
}

/// The factor of the vertex colours at a point of a triangle; they are interpolated in linear light.
#[inline(always)]
fn vertex_colour(t: &TriangleAttributes, u: f32, v: f32) -> Vec3 {
    if t.tints[0] | t.tints[1] | t.tints[2] == 0 {
        return Vec3::ONE;
    }
    untinted(t.tints[0]) * (1.0 - u - v) + untinted(t.tints[1]) * u + untinted(t.tints[2]) * v
}

/// The colour of a corner from what it takes away.
#[inline(always)]
fn untinted(tint: u32) -> Vec3 {
    let taken = Vec3::new((tint & 1023) as f32, ((tint >> 10) & 1023) as f32, ((tint >> 20) & 1023) as f32);
    let root = Vec3::ONE - taken * (1.0 / 1023.0);
    root * root
}

/// Word of [`TriangleAttributes::tints`] of a colour; what is outside 0…1 is brought there.
#[cfg(not(target_arch = "spirv"))]
pub fn tint(colour: Vec3) -> u32 {
    #[cfg(not(feature = "std"))]
    use spirv_std::num_traits::Float;
    let taken = colour.to_array().map(|c| ((1.0 - c.clamp(0.0, 1.0).sqrt()) * 1023.0 + 0.5) as u32);
    taken[0] | taken[1] << 10 | taken[2] << 20
}

/// Reflectance and alpha of a material at a texture coordinate.
fn textured(surfaces: &[u32], m: &SceneMaterial, uv: Vec2) -> BaseColour {
    let factor = Vec3::from_array(m.albedo);
    if m.texture_first == NO_TEXTURE {
        return BaseColour { albedo: factor, alpha: m.alpha_factor };
    }
    let taps = Taps::new(m, uv);
    let (a, b) = (surfaces[taps.i00 as usize], surfaces[taps.i10 as usize]);
    let (c, d) = (surfaces[taps.i01 as usize], surfaces[taps.i11 as usize]);
    let top = linear(surfaces, a) * (1.0 - taps.fx) + linear(surfaces, b) * taps.fx;
    let bottom = linear(surfaces, c) * (1.0 - taps.fx) + linear(surfaces, d) * taps.fx;
    BaseColour {
        albedo: factor * (top * (1.0 - taps.fy) + bottom * taps.fy),
        alpha: m.alpha_factor * taps.mix(alpha(a), alpha(b), alpha(c), alpha(d)),
    }
}

/// Whether a masked triangle lets a ray pass at a hit.
pub fn alpha_cuts(scene: &SceneRef<'_>, triangle: u32, u: f32, v: f32) -> bool {
    let m = material(scene.surfaces, scene.triangles[triangle as usize].material);
    if m.texture_first == NO_TEXTURE {
        return m.alpha_factor < m.alpha_cutoff;
    }
    let taps = Taps::new(&m, texture_coordinate(&scene.attributes[triangle as usize], u, v));
    let (a, b) = (scene.surfaces[taps.i00 as usize], scene.surfaces[taps.i10 as usize]);
    let (c, d) = (scene.surfaces[taps.i01 as usize], scene.surfaces[taps.i11 as usize]);
    m.alpha_factor * taps.mix(alpha(a), alpha(b), alpha(c), alpha(d)) < m.alpha_cutoff
}

/// Texture coordinate at a point of a triangle.
#[inline(always)]
pub fn texture_coordinate(t: &TriangleAttributes, u: f32, v: f32) -> Vec2 {
    let w = 1.0 - u - v;
    Vec2::new(t.uv[0] * w + t.uv[2] * u + t.uv[4] * v, t.uv[1] * w + t.uv[3] * u + t.uv[5] * v)
}

/// The four texels around a texture coordinate and the weights of the right and lower ones.
#[derive(Clone, Copy)]
struct Taps {
    i00: u32,
    i10: u32,
    i01: u32,
    i11: u32,
    fx: f32,
    fy: f32,
}

impl Taps {
    #[inline(always)]
    fn new(m: &SceneMaterial, uv: Vec2) -> Self {
        let (width, height) = (m.texture_size & 0xFFFF, m.texture_size >> 16);
        let (x0, x1, fx) = neighbours(uv.x, width, (m.texture_first >> WRAP_U_SHIFT) & 3);
        let (y0, y1, fy) = neighbours(uv.y, height, (m.texture_first >> WRAP_V_SHIFT) & 3);
        let first = m.texture_first & TEXTURE_FIRST_MASK;
        let (row0, row1) = (first + y0 * width, first + y1 * width);
        Self { i00: row0 + x0, i10: row0 + x1, i01: row1 + x0, i11: row1 + x1, fx, fy }
    }
    #[inline(always)]
    fn mix(&self, a: f32, b: f32, c: f32, d: f32) -> f32 {
        let top = a * (1.0 - self.fx) + b * self.fx;
        let bottom = c * (1.0 - self.fx) + d * self.fx;
        top * (1.0 - self.fy) + bottom * self.fy
    }
}

/// Two neighbouring texels of a row around a coordinate, and the weight of the second. A coordinate that is no number counts
/// as 0.
#[inline(always)]
fn neighbours(coordinate: f32, size: u32, wrap: u32) -> (u32, u32, f32) {
    let last = size - 1;
    let x = inside(coordinate, wrap) * size as f32 - 0.5;
    let below = floor(x);
    let before_first = below < 0.0;
    let first = if before_first { 0 } else { (below as u32).min(last) };
    let second = if before_first { 0 } else { (first + 1).min(last) };
    // Beyond the first and the last texel a row that repeats goes on at its other end.
    let repeats = wrap == WRAP_REPEAT;
    let first = if repeats && before_first { last } else { first };
    let second = if repeats && !before_first && first == last { 0 } else { second };
    (first, second, x - below)
}

/// The coordinate in 0…1 that stands for another.
#[inline(always)]
fn inside(coordinate: f32, wrap: u32) -> f32 {
    let period = if wrap == WRAP_MIRROR { 2.0 } else { 1.0 };
    let turned = coordinate - floor(coordinate / period) * period;
    let folded = if turned > 1.0 { period - turned } else { turned };
    let coordinate = if wrap == WRAP_CLAMP { min(max(coordinate, 0.0), 1.0) } else { folded };
    // False for what is no number.
    if abs(coordinate - 0.5) <= 0.5 { coordinate } else { 0.0 }
}

#[inline(always)]
fn linear(surfaces: &[u32], texel: u32) -> Vec3 {
    Vec3::new(
        float(surfaces, (texel & 0xFF) as usize),
        float(surfaces, ((texel >> 8) & 0xFF) as usize),
        float(surfaces, ((texel >> 16) & 0xFF) as usize),
    )
}

#[inline(always)]
fn alpha(texel: u32) -> f32 {
    (texel >> 24) as f32 * (1.0 / 255.0)
}

/// The surface point at a hit of `ray`. The normals lie on the side that the ray comes from; emission is the front
/// face's. A miss gives a surfel with [`NO_SURFACE`], all else zero: the caller adds its environment.
pub fn surface(scene: &SceneRef<'_>, ray: &Ray, hit: &Hit) -> Surfel {
    if !hit.is_some() {
        return no_surface();
    }
    let triangle = &scene.triangles[hit.triangle as usize];
    let (v0, v1, v2) = (Vec3::from_array(triangle.v0), Vec3::from_array(triangle.v1), Vec3::from_array(triangle.v2));
    let (e1, e2) = (v1 - v0, v2 - v0);
    // From the weights, not from the distance: the error depends on the triangle's size, not on the ray's length.
    let position = v0 + e1 * hit.u + e2 * hit.v;
    let outward = unit_or(e1.cross(e2), Vec3::Y);
    let front = outward.dot(ray.direction) < 0.0;
    let geometric_normal = if front { outward } else { -outward };
    let attributes = &scene.attributes[hit.triangle as usize];
    let m = material(scene.surfaces, triangle.material);
    let colour = base_colour(scene.surfaces, &m, attributes, hit.u, hit.v);
    Surfel {
        position: position.to_array(),
        triangle: hit.triangle,
        normal: shading_normal(attributes, hit, ray.direction, geometric_normal).to_array(),
        distance: hit.t * length(ray.direction),
        geometric_normal: geometric_normal.to_array(),
        front: front as u32,
        albedo: colour.albedo.to_array(),
        material: triangle.material,
        emission: if front { m.emission } else { [0.0; 3] },
        error: position_error(v0, e1, e2),
    }
}

/// The surfel of a ray that left the scene.
#[inline(always)]
pub fn no_surface() -> Surfel {
    Surfel {
        position: [0.0; 3],
        triangle: NO_SURFACE,
        normal: [0.0; 3],
        distance: 0.0,
        geometric_normal: [0.0; 3],
        front: 0,
        albedo: [0.0; 3],
        material: 0,
        emission: [0.0; 3],
        error: 0.0,
    }
}

/// Interpolated vertex normal on the viewer's side; the geometric one where the sum vanishes.
#[inline(always)]
fn shading_normal(t: &TriangleAttributes, hit: &Hit, direction: Vec3, geometric_normal: Vec3) -> Vec3 {
    let sum = octahedral::unpack(t.normals[0]) * (1.0 - hit.u - hit.v)
        + octahedral::unpack(t.normals[1]) * hit.u
        + octahedral::unpack(t.normals[2]) * hit.v;
    let n = unit_or(sum, geometric_normal);
    if n.dot(direction) > 0.0 { -n } else { n }
}

/// Roundings (2⁻²⁴) of the first corner that [`Surfel::error`] allows for: one of the position in each coordinate, one of
/// the ray's start, with a reserve of two.
const POSITION_ROUNDINGS: f32 = 8.0 * 5.960_464_5e-8;
/// Roundings of the edges: three of the sum, five of the next ray's sheared corners, with a reserve of two.
const EDGE_ROUNDINGS: f32 = 18.0 * 5.960_464_5e-8;

/// How far a ray must start off a triangle not to meet it again.
#[inline(always)]
fn position_error(v0: Vec3, e1: Vec3, e2: Vec3) -> f32 {
    largest(v0) * POSITION_ROUNDINGS + (largest(e1) + largest(e2)) * EDGE_ROUNDINGS
}

/// Start of a ray that leaves a surface point in `direction`: off the surface by the error bound of its position, on the
/// direction's side.
///
/// Wächter & Binder 2019 ("A Fast and Robust Method for Avoiding Self-Intersection") move by 256 units in the last place
/// with a floor near the world's origin, which fits scenes of one scale. We move by a bound of the actual error (after
/// Pharr, Jakob & Humphreys 2016, §3.9), which follows the triangle's size and place from millimetres to 100 km.
#[inline(always)]
pub fn leave_surface(position: Vec3, geometric_normal: Vec3, error: f32, direction: Vec3) -> Vec3 {
    let side = if geometric_normal.dot(direction) < 0.0 { -error } else { error };
    position + geometric_normal * side
}

/// The sRGB table at the start of the `surfaces` buffer (IEC 61966-2-1).
#[cfg(not(target_arch = "spirv"))]
pub fn srgb_table() -> [u32; SRGB_TABLE_WORDS as usize] {
    #[cfg(not(feature = "std"))]
    use spirv_std::num_traits::Float;
    core::array::from_fn(|code| {
        let c = code as f64 / 255.0;
        let linear = if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
        (linear as f32).to_bits()
    })
}

#[inline(always)]
fn largest(v: Vec3) -> f32 {
    max(max(abs(v.x), abs(v.y)), abs(v.z))
}

/// `v` at unit length, `otherwise` where it has none. Scaled first, so that tiny and huge vectors keep their direction.
#[inline(always)]
pub(crate) fn unit_or(v: Vec3, otherwise: Vec3) -> Vec3 {
    let scale = largest(v);
    if scale > f32::MIN_POSITIVE && scale < f32::MAX {
        let v = v / scale;
        v / length(v)
    } else {
        otherwise
    }
}
