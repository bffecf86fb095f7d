//! What a ray finds: position, normals, reflectance, emission.

use super::trace::Hit;
use crate::scene::{Alpha, Scene, Texture, Triangle, Wrap};
use glam::{Vec2, Vec3, Vec4};
use std::sync::LazyLock;

/// A point from which light is reflected.
#[derive(Clone, Copy, Debug)]
pub struct Vertex {
    /// Position (m).
    pub position: Vec3,
    /// Bound of the position's rounding error, with which rays leave along the geometric normal (m).
    pub offset: f32,
    /// Unit geometric normal; either side.
    pub geometric_normal: Vec3,
    /// Unit shading normal on the viewer's side.
    pub normal: Vec3,
    /// Reflectance.
    pub albedo: Vec3,
    /// Triangle that rays which leave cannot hit, [`super::trace::NO_TRIANGLE`] for a free receiver.
    pub triangle: u32,
}

impl Vertex {
    /// Origin of a ray that leaves towards `direction`.
    #[inline(always)]
    pub fn leave(&self, direction: Vec3) -> Vec3 {
        let side = if direction.dot(self.geometric_normal) < 0.0 { -self.offset } else { self.offset };
        self.position + self.geometric_normal * side
    }
}

/// Rounding error of a point that is interpolated from a triangle's corners, relative to its largest coordinate:
/// γ₇ of Pharr, Jakob & Humphreys, *Physically Based Rendering*, 3rd ed., §3.9.4, doubled for the test's own error.
const POSITION_ERROR: f32 = 14.0 * 0.5 * f32::EPSILON;

/// The unit geometric normal of a triangle's front.
#[inline(always)]
pub fn geometric_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    let n = (b - a).cross(c - a);
    // The cross product of a tiny triangle underflows in f32.
    n.try_normalize().unwrap_or_else(|| (b - a).as_dvec3().cross((c - a).as_dvec3()).normalize_or_zero().as_vec3())
}

/// Largest error of a position on a triangle (m).
#[inline(always)]
pub fn position_error([a, b, c]: [Vec3; 3]) -> f32 {
    POSITION_ERROR * a.abs().max(b.abs()).max(c.abs()).max_element()
}

/// What paths ask of a triangle again and again, in one line of a processor's cache.
#[repr(align(64))]
struct Face {
    corners: [Vec3; 3],
    /// Unit geometric normal of the front.
    normal: Vec3,
    /// Largest error of a position (m).
    offset: f32,
    material: u32,
    /// Whether the shading normal is another than the geometric one.
    smooth: bool,
}

/// A scene's surfaces, ready to be looked up.
pub struct Surfaces<'a> {
    scene: &'a Scene,
    faces: Vec<Face>,
}

impl<'a> Surfaces<'a> {
    /// Prepares a scene's triangles, whose indices are valid.
    pub fn new(scene: &'a Scene) -> Self {
        let face = |triangle: &Triangle| {
            let corners = scene.corners(triangle);
            let normal = geometric_normal(corners);
            let along =
                |side: Vec3| triangle.vertices.iter().all(|v| scene.normals[*v as usize].abs_diff_eq(side, 1e-6));
            let smooth = !along(normal) && !along(-normal);
            Face { corners, normal, offset: position_error(corners), material: triangle.material, smooth }
        };
        Self { scene, faces: scene.triangles.iter().map(face).collect() }
    }

    /// The surface at a hit of a ray along `direction`, and the radiance that it emits against it.
    #[inline(always)]
    pub fn at(&self, hit: &Hit, direction: Vec3) -> (Vertex, Vec3) {
        let face = &self.faces[hit.triangle as usize];
        let material = &self.scene.materials[face.material as usize];
        let ([a, b, c], w) = (face.corners, hit.barycentric);
        let shading = if face.smooth { self.shading_normal(hit).unwrap_or(face.normal) } else { face.normal };
        let albedo = match material.texture {
            Some(texture) => material.albedo * self.texel(texture, material.wrap, hit).truncate(),
            None => material.albedo,
        };
        let albedo = if self.scene.colours.is_empty() { albedo } else { albedo * self.vertex_colour(hit) };
        let vertex = Vertex {
            position: a * w.x + b * w.y + c * w.z,
            offset: face.offset,
            geometric_normal: face.normal,
            normal: if shading.dot(direction) > 0.0 { -shading } else { shading },
            albedo,
            triangle: hit.triangle,
        };
        let emission = if face.normal.dot(direction) < 0.0 { material.emission } else { Vec3::ZERO };
        (vertex, emission)
    }

    /// The interpolated normal, where there is one.
    fn shading_normal(&self, hit: &Hit) -> Option<Vec3> {
        let vertices = self.scene.triangles[hit.triangle as usize].vertices;
        let ([a, b, c], w) = (vertices.map(|v| self.scene.normals[v as usize]), hit.barycentric);
        (a * w.x + b * w.y + c * w.z).try_normalize()
    }

    fn texel(&self, texture: u32, wrap: [Wrap; 2], hit: &Hit) -> Vec4 {
        sample(&self.scene.textures[texture as usize], wrap, uv(self.scene, hit))
    }

    /// The interpolated vertex colour.
    fn vertex_colour(&self, hit: &Hit) -> Vec3 {
        let vertices = self.scene.triangles[hit.triangle as usize].vertices;
        let ([a, b, c], w) = (vertices.map(|v| self.scene.colours[v as usize]), hit.barycentric);
        a * w.x + b * w.y + c * w.z
    }
}

/// Whether the material's alpha lets a ray pass at a hit.
pub fn alpha_passes(scene: &Scene, triangle: u32, barycentric: Vec3) -> bool {
    let material = &scene.materials[scene.triangles[triangle as usize].material as usize];
    let Alpha::Mask(cutoff) = material.alpha else { return false };
    let alpha = match material.texture {
        Some(texture) => {
            let hit = Hit { t: 0.0, triangle, barycentric };
            sample_alpha(&scene.textures[texture as usize], material.wrap, uv(scene, &hit))
        }
        None => 1.0,
    };
    material.alpha_factor * alpha < cutoff
}

#[inline(always)]
fn uv(scene: &Scene, hit: &Hit) -> Vec2 {
    let [a, b, c] = scene.triangles[hit.triangle as usize].vertices.map(|v| scene.uvs[v as usize]);
    a * hit.barycentric.x + b * hit.barycentric.y + c * hit.barycentric.z
}

/// Bilinear sample of a texture: linear RGB and alpha. `uv` = (0, 0) is the upper left corner of the upper
/// left texel; texels are filtered after the sRGB curve was undone.
#[inline(always)]
pub fn sample(texture: &Texture, wrap: [Wrap; 2], uv: Vec2) -> Vec4 {
    let (texels, f) = around(texture, wrap, uv);
    let [top, bottom] = texels.map(|[left, right]| linear(left).lerp(linear(right), f.x));
    top.lerp(bottom, f.y)
}

/// Alpha of [`sample`]: the same bits without the colours.
fn sample_alpha(texture: &Texture, wrap: [Wrap; 2], uv: Vec2) -> f32 {
    let (texels, f) = around(texture, wrap, uv);
    let lerp = |a: f32, b: f32, s: f32| a * (1.0 - s) + b * s;
    let [top, bottom] = texels.map(|[left, right]| lerp(unit(left[3]), unit(right[3]), f.x));
    lerp(top, bottom, f.y)
}

/// The four texels around a point, `[row][column]`, and where it lies between them.
#[inline(always)]
fn around(texture: &Texture, wrap: [Wrap; 2], uv: Vec2) -> ([[[u8; 4]; 2]; 2], Vec2) {
    // A coordinate that is not finite reads the corner.
    let uv = if uv.is_finite() { uv } else { Vec2::ZERO };
    let (columns, x) = along(uv.x, texture.width, wrap[0]);
    let (rows, y) = along(uv.y, texture.height, wrap[1]);
    let texel = |row: usize, column: usize| texture.srgba[row * texture.width as usize + column];
    (rows.map(|row| columns.map(|column| texel(row, column))), Vec2::new(x, y))
}

/// The two texels of a row around a coordinate, and where it lies between them.
#[inline(always)]
fn along(coordinate: f32, size: u32, wrap: Wrap) -> ([usize; 2], f32) {
    let inside = match wrap {
        Wrap::Repeat => coordinate - coordinate.floor(),
        Wrap::Clamp => coordinate.clamp(0.0, 1.0),
        // A triangle wave: up from 0 to 1, and down again from 1 to 2.
        Wrap::Mirror => 1.0 - (coordinate.rem_euclid(2.0) - 1.0).abs(),
    };
    let p = inside * size as f32 - 0.5;
    let base = p.floor();
    // From −1 to the size: one step beyond either end.
    let step = |k: i32| {
        let i = base as i32 + k;
        match wrap {
            Wrap::Repeat if i < 0 => size as usize - 1,
            Wrap::Repeat => i as usize % size as usize,
            Wrap::Clamp | Wrap::Mirror => i.clamp(0, size as i32 - 1) as usize,
        }
    };
    ([step(0), step(1)], p - base)
}

/// Linear values of the 256 sRGB codes (IEC 61966-2-1).
static SRGB_TO_LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|code| {
        let s = code as f64 / 255.0;
        (if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }) as f32
    })
});

#[inline(always)]
fn linear([r, g, b, a]: [u8; 4]) -> Vec4 {
    let curve = &*SRGB_TO_LINEAR;
    Vec4::new(curve[r as usize], curve[g as usize], curve[b as usize], unit(a))
}

#[inline(always)]
fn unit(code: u8) -> f32 {
    f32::from(code) / 255.0
}

#[cfg(test)]
mod tests {
    use super::*;

    const REPEAT: [Wrap; 2] = [Wrap::Repeat; 2];

    fn checker() -> Texture {
        Texture {
            width: 2,
            height: 2,
            srgba: vec![[255, 0, 0, 255], [0, 255, 0, 0], [0, 0, 255, 255], [188, 188, 188, 255]],
        }
    }

    #[test]
    fn texel_centres_read_their_texel_with_v_downwards() {
        let t = checker();
        assert_eq!(sample(&t, REPEAT, Vec2::new(0.25, 0.25)), Vec4::new(1.0, 0.0, 0.0, 1.0));
        assert_eq!(sample(&t, REPEAT, Vec2::new(0.75, 0.25)), Vec4::new(0.0, 1.0, 0.0, 0.0));
        assert_eq!(sample(&t, REPEAT, Vec2::new(0.25, 0.75)), Vec4::new(0.0, 0.0, 1.0, 1.0));
        // sRGB 188 is a linear 0.5029 (IEC 61966-2-1).
        assert!((sample(&t, REPEAT, Vec2::new(0.75, 0.75)).x - 0.5029).abs() < 1e-4);
    }

    #[test]
    fn texels_blend_linearly_and_repeat() {
        let t = checker();
        let half = sample(&t, REPEAT, Vec2::new(0.5, 0.25));
        assert!((half - Vec4::new(0.5, 0.5, 0.0, 0.5)).abs().max_element() < 1e-6);
        let across_the_border = sample(&t, REPEAT, Vec2::new(0.0, 0.25));
        assert!((across_the_border - half).abs().max_element() < 1e-6);
        for k in 0..100 {
            let uv = Vec2::new(0.037 * k as f32 - 1.0, 2.0 - 0.051 * k as f32);
            assert_eq!(sample_alpha(&t, REPEAT, uv), sample(&t, REPEAT, uv).w, "{uv}");
        }
        let far = sample(&t, REPEAT, Vec2::new(-2.75, 5.25));
        assert!((far - sample(&t, REPEAT, Vec2::new(0.25, 0.25))).abs().max_element() < 1e-5);
        assert!(sample(&t, REPEAT, Vec2::new(f32::NAN, 0.0)).is_finite());
    }

    #[test]
    fn textures_stop_or_turn_back_at_their_sides_where_they_are_told_to() {
        let t = checker();
        let at = |wrap: Wrap, x: f32| sample(&t, [wrap, Wrap::Repeat], Vec2::new(x, 0.25)).x;
        // Red on the left, none on the right.
        for x in [0.0, 0.1, 0.25, -0.2, -7.0] {
            assert_eq!(at(Wrap::Clamp, x), 1.0, "{x}");
        }
        for x in [1.0, 0.8, 3.0] {
            assert_eq!(at(Wrap::Clamp, x), 0.0, "{x}");
        }
        for k in 0..40 {
            let x = 0.05 * k as f32;
            for turned in [2.0 - x, -x, x + 2.0, x - 4.0] {
                assert!((at(Wrap::Mirror, x) - at(Wrap::Mirror, turned)).abs() < 1e-5, "{x} {turned}");
            }
            if x <= 1.0 {
                assert!((at(Wrap::Mirror, x) - at(Wrap::Clamp, x)).abs() < 1e-5, "{x}");
            }
        }
    }
}
