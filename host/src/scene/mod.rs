//! Scenes: triangles in world space, materials, lights, cameras. World: right-handed, +Y up, metres, radiometric units.

pub mod device;

use glam::{Vec2, Vec3};

/// One triangle: three vertices and a material.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Triangle {
    /// Indices into [`Scene::positions`] (and `normals`, `uvs`), counter-clockwise seen from the front.
    pub vertices: [u32; 3],
    /// Index into [`Scene::materials`].
    pub material: u32,
}

/// A base-colour image, linear.
#[derive(Clone, PartialEq, Debug)]
pub struct Texture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Linear RGB reflectance and alpha, 8 bits each: RGB is stored as sRGB codes, alpha as is; row 0 on top.
    pub srgba: Vec<[u8; 4]>,
}

/// How a material's alpha is used.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Alpha {
    /// Ignored.
    Opaque,
    /// Rays pass where alpha is below the cut-off.
    Mask(f32),
    /// Glass: the surface does not exist for light (such triangles are dropped at import, and said).
    Blend,
}

/// A Lambert surface that may emit. Reflects on both sides; emits on its front side only.
#[derive(Clone, PartialEq, Debug)]
pub struct Material {
    /// Name in the file.
    pub name: String,
    /// Reflectance per channel, multiplied with the texture.
    pub albedo: Vec3,
    /// Index into [`Scene::textures`].
    pub texture: Option<u32>,
    /// Alpha of the base-colour factor, multiplied with the texture's.
    pub alpha_factor: f32,
    /// Use of alpha.
    pub alpha: Alpha,
    /// Radiance that the front face emits, W/(sr m²).
    pub emission: Vec3,
    /// glTF's metallic factor (shaded as Lambert unless a method says otherwise).
    pub metallic: f32,
    /// glTF's roughness factor.
    pub roughness: f32,
}

/// A light without a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Light {
    /// Radiant intensity (W/sr) from a point.
    Point {
        /// Position.
        position: Vec3,
        /// W/sr.
        intensity: Vec3,
    },
    /// A point light with glTF's cone falloff.
    Spot {
        /// Position.
        position: Vec3,
        /// Unit direction of the light's travel.
        direction: Vec3,
        /// W/sr on the axis.
        intensity: Vec3,
        /// Cosine of the inner cone's half angle: full intensity inside.
        cos_inner: f32,
        /// Cosine of the outer cone's half angle: no light outside.
        cos_outer: f32,
    },
    /// Parallel light.
    Directional {
        /// Unit direction of the light's travel.
        direction: Vec3,
        /// Irradiance on a surface that faces it, W/m².
        irradiance: Vec3,
    },
}

/// A pinhole camera.
#[derive(Clone, PartialEq, Debug)]
pub struct Camera {
    /// Name.
    pub name: String,
    /// Position.
    pub position: Vec3,
    /// Unit view direction.
    pub forward: Vec3,
    /// Unit vector, perpendicular to `forward`, that is up in the picture.
    pub up: Vec3,
    /// Vertical field of view.
    pub fovy_rad: f32,
}

/// A scene in world space.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Built-in name or path.
    pub name: String,
    /// Vertex positions.
    pub positions: Vec<Vec3>,
    /// Unit vertex normals, one per position.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one per position (zero where there are none); v downwards as in glTF.
    pub uvs: Vec<Vec2>,
    /// Second UV set (lightmaps), empty or one per position.
    pub lightmap_uvs: Vec<Vec2>,
    /// Triangles of non-zero area.
    pub triangles: Vec<Triangle>,
    /// Materials.
    pub materials: Vec<Material>,
    /// Textures.
    pub textures: Vec<Texture>,
    /// Lights without a surface.
    pub lights: Vec<Light>,
    /// Cameras; never empty after loading.
    pub cameras: Vec<Camera>,
    /// Radiance of the environment from every direction, W/(sr m²).
    pub environment: Vec3,
    /// What was simplified, dropped or made up at import: for the user, said once.
    pub notes: Vec<String>,
}

impl Scene {
    /// Smallest and largest corner of all triangles' vertices; zeros for an empty scene.
    pub fn bounds(&self) -> (Vec3, Vec3) {
        let used = self.triangles.iter().flat_map(|t| t.vertices).map(|v| self.positions[v as usize]);
        let (lo, hi) = used.fold((Vec3::MAX, Vec3::MIN), |(lo, hi), p| (lo.min(p), hi.max(p)));
        if lo.x > hi.x { (Vec3::ZERO, Vec3::ZERO) } else { (lo, hi) }
    }

    /// Positions of a triangle's corners.
    pub fn corners(&self, triangle: &Triangle) -> [Vec3; 3] {
        triangle.vertices.map(|v| self.positions[v as usize])
    }
}

impl Camera {
    /// Primary ray through a point of the picture: origin and unit direction. `x_px`, `y_px` count from the top left
    /// corner; pixel centres lie at half-integers.
    pub fn ray(&self, x_px: f32, y_px: f32, width: u32, height: u32) -> (Vec3, Vec3) {
        let half_height = (0.5 * self.fovy_rad).tan();
        let half_width = half_height * width as f32 / height as f32;
        let right = self.forward.cross(self.up);
        let x = (2.0 * x_px / width as f32 - 1.0) * half_width;
        let y = (1.0 - 2.0 * y_px / height as f32) * half_height;
        (self.position, (self.forward + right * x + self.up * y).normalize())
    }
}
