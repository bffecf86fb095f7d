//! Scenes: triangles, materials, lights, cameras. World: right-handed, +Y up, metres, radiometric units.
//!
//! [`load`] reads a glTF or OBJ file, or makes one of the [`BUILT_IN`] scenes.

pub mod built_in;
pub mod bvh;
pub mod device;
mod error;
mod import;
mod origin;

pub use built_in::{BUILT_IN, BuiltIn};
pub use error::{FileError, SceneError};

use glam::{DVec3, Vec2, Vec3};
use interreflect_shared::scene::{WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT};
use sha2::{Digest, Sha256};
use std::path::Path;

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

/// How a texture goes on beyond its sides.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
#[repr(u32)]
pub enum Wrap {
    /// It repeats.
    #[default]
    Repeat = WRAP_REPEAT,
    /// The texels at its side go on.
    Clamp = WRAP_CLAMP,
    /// It repeats, mirrored every other time.
    Mirror = WRAP_MIRROR,
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
    /// How the texture goes on beyond its sides, along u and v.
    pub wrap: [Wrap; 2],
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
    /// Name of the file's node that holds it, by which it is known too; empty for other cameras.
    pub node: String,
    /// Position.
    pub position: Vec3,
    /// Unit view direction.
    pub forward: Vec3,
    /// Unit vector, perpendicular to `forward`, that is up in the picture.
    pub up: Vec3,
    /// Vertical field of view.
    pub fovy_rad: f32,
}

/// A scene in world space, counted from [`Scene::origin`].
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Built-in name or path.
    pub name: String,
    /// Where the coordinates are counted from (m, in the world): zero unless the scene lies far away (see [`Scene::recentre`]).
    pub origin: DVec3,
    /// Vertex positions.
    pub positions: Vec<Vec3>,
    /// Unit vertex normals, one per position.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one per position (zero where there are none); v downwards as in glTF.
    pub uvs: Vec<Vec2>,
    /// Vertex colours, linear factors of reflectance, empty (white) or one per position.
    pub colours: Vec<Vec3>,
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

/// How a scene is loaded.
#[derive(Clone, Debug)]
pub struct LoadOptions {
    /// A view as [`Scene::camera`] takes it. One of numbers becomes the scene's first camera, and none is made up for a file
    /// without; names and what is no camera are left to [`Scene::camera`].
    pub camera: Option<String>,
    /// Constant radiance of the environment, in place of the scene's own (files have none).
    pub environment: Option<Vec3>,
    /// Parallel light beside the scene's own: direction of travel and perpendicular irradiance (W/m²).
    pub sun: Option<(Vec3, Vec3)>,
    /// Most triangles that are accepted.
    pub max_triangles: usize,
}

impl Default for LoadOptions {
    fn default() -> Self {
        LoadOptions { camera: None, environment: None, sun: None, max_triangles: 1 << 24 }
    }
}

impl LoadOptions {
    fn sun_light(&self) -> Option<Light> {
        self.sun.map(|(direction, irradiance)| Light::Directional { direction, irradiance })
    }

    fn view(&self, scene: &Scene) -> Option<Camera> {
        self.camera.as_deref().filter(|spec| spec.contains(',')).and_then(|spec| scene.parse_camera(spec).ok())
    }
}

/// What a scene holds, for listings and reports.
#[derive(Clone, Copy, PartialEq, Debug, serde::Serialize)]
pub struct SceneStats {
    /// Triangles.
    pub triangle_count: usize,
    /// Triangles whose front face emits.
    pub emissive_triangle_count: usize,
    /// Lights without a surface.
    pub light_count: usize,
    /// Materials.
    pub material_count: usize,
    /// Textures.
    pub texture_count: usize,
    /// Smallest corner of the bounding box in the world (m).
    pub min: [f64; 3],
    /// Largest corner (m).
    pub max: [f64; 3],
}

/// Loads a scene: a built-in one by its name, or a `.glb`, `.gltf` or `.obj` file by its path.
///
/// # Errors
/// [`SceneError::Unknown`] for what is neither, [`SceneError::File`] for a file that cannot be read as a scene.
///
/// ```
/// use interreflect::scene::{LoadOptions, load};
/// let scene = load("cornell-box", &LoadOptions::default()).unwrap();
/// assert_eq!(scene.triangles.len(), 32);
/// assert!(load("cornel-box", &LoadOptions::default()).unwrap_err().to_string().contains("did you mean `cornell-box`?"));
/// ```
pub fn load(spec: &str, options: &LoadOptions) -> Result<Scene, SceneError> {
    if let Some(built_in) = BUILT_IN.iter().find(|b| b.name == spec) {
        let mut scene = (built_in.make)();
        scene.environment = options.environment.unwrap_or(scene.environment);
        scene.lights.extend(options.sun_light());
        let view = options.view(&scene);
        scene.cameras.splice(..0, view);
        return Ok(scene);
    }
    let path = Path::new(spec);
    let is_meant_as_path = path.extension().is_some() || path.components().count() > 1;
    if spec.is_empty() || (!is_meant_as_path && !path.exists()) {
        return Err(SceneError::Unknown {
            name: spec.to_owned(),
            nearest: error::nearest(spec, BUILT_IN.iter().map(|b| b.name)),
            known: BUILT_IN.iter().map(|b| b.name.to_owned()).collect(),
        });
    }
    import::load(path, options).map_err(|reason| SceneError::File { path: path.to_owned(), reason })
}

impl Scene {
    /// A camera by its name or as `px,py,pz,tx,ty,tz,fovy_deg` (world position, target, vertical field of view; +Y is up);
    /// the scene's first one without a specification.
    ///
    /// # Errors
    /// [`SceneError::Camera`] for an unknown name, or numbers that make no camera.
    pub fn camera(&self, spec: Option<&str>) -> Result<Camera, SceneError> {
        let fail = |spec: &str, reason: &str, nearest| SceneError::Camera {
            spec: spec.to_owned(),
            reason: reason.to_owned(),
            nearest,
        };
        let Some(spec) = spec else {
            return self.cameras.first().cloned().ok_or_else(|| fail("default", "the scene has none", None));
        };
        let by_node = || self.cameras.iter().find(|c| !c.node.is_empty() && c.node == spec);
        if let Some(camera) = self.cameras.iter().find(|c| c.name == spec).or_else(by_node) {
            return Ok(camera.clone());
        }
        if spec.contains(',') {
            return self.parse_camera(spec).map_err(|reason| fail(spec, &reason, None));
        }
        let names: Vec<&str> = self.cameras.iter().map(|c| c.name.as_str()).collect();
        let reason = format!("the scene's cameras are {}; or px,py,pz,tx,ty,tz,fovy_deg", names.join(", "));
        Err(fail(spec, &reason, error::nearest(spec, names.into_iter())))
    }

    /// A camera of seven numbers, or why they make none.
    fn parse_camera(&self, spec: &str) -> Result<Camera, String> {
        let numbers: Vec<f64> =
            spec.split(',').map(|word| word.trim().parse()).collect::<Result<_, _>>().map_err(|_| {
                "seven numbers px,py,pz,tx,ty,tz,fovy_deg are expected, and one of the words is no number".to_owned()
            })?;
        let &[px, py, pz, tx, ty, tz, fovy_deg] = numbers.as_slice() else {
            return Err(format!("seven numbers px,py,pz,tx,ty,tz,fovy_deg are expected, {} are given", numbers.len()));
        };
        let (position, target) = (self.local(DVec3::new(px, py, pz)), self.local(DVec3::new(tx, ty, tz)));
        if !position.is_finite() || !target.is_finite() {
            return Err("position and target must be finite".to_owned());
        }
        if !(target - position).length_squared().is_normal() {
            return Err("position and target are the same point, or absurdly far apart".to_owned());
        }
        if !(fovy_deg > 0.0 && fovy_deg < 180.0) {
            return Err("the field of view must be between 0 and 180 degrees".to_owned());
        }
        Ok(Camera::look_at(spec, position, target, fovy_deg.to_radians() as f32))
    }

    /// Whether anything gives light.
    pub fn is_lit(&self) -> bool {
        self.environment != Vec3::ZERO || !self.lights.is_empty() || self.stats().emissive_triangle_count > 0
    }

    /// Counts and bounds.
    pub fn stats(&self) -> SceneStats {
        let emits = |t: &&Triangle| self.materials[t.material as usize].emission != Vec3::ZERO;
        let (min, max) = self.bounds();
        SceneStats {
            triangle_count: self.triangles.len(),
            emissive_triangle_count: self.triangles.iter().filter(emits).count(),
            light_count: self.lights.len(),
            material_count: self.materials.len(),
            texture_count: self.textures.len(),
            min: self.world(min).to_array(),
            max: self.world(max).to_array(),
        }
    }

    /// SHA-256 of everything that light depends on: geometry, materials, textures, lights and environment, but no
    /// names, cameras or notes, nor where in the world all of it is. The key of caches.
    pub fn content_hash(&self) -> [u8; 32] {
        let mut hash = Sha256::new();
        let mut section = |tag: &[u8; 4], bytes: &[u8]| {
            hash.update(tag);
            hash.update((bytes.len() as u64).to_le_bytes());
            hash.update(bytes);
        };
        section(b"posi", bytemuck::cast_slice(&self.positions));
        section(b"norm", bytemuck::cast_slice(&self.normals));
        section(b"uv 0", bytemuck::cast_slice(&self.uvs));
        section(b"colo", bytemuck::cast_slice(&self.colours));
        section(b"uv 1", bytemuck::cast_slice(&self.lightmap_uvs));
        let indices: Vec<[u32; 4]> = self.triangles.iter().map(Triangle::words).collect();
        section(b"tris", bytemuck::cast_slice(&indices));
        let materials: Vec<[u32; 14]> = self.materials.iter().map(Material::words).collect();
        section(b"mate", bytemuck::cast_slice(&materials));
        for texture in &self.textures {
            section(b"size", bytemuck::cast_slice(&[texture.width, texture.height]));
            section(b"texe", bytemuck::cast_slice(&texture.srgba));
        }
        let lights: Vec<[f32; 12]> = self.lights.iter().map(Light::words).collect();
        section(b"ligh", bytemuck::cast_slice(&lights));
        section(b"envi", bytemuck::bytes_of(&self.environment));
        hash.finalize().into()
    }

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

impl Triangle {
    fn words(&self) -> [u32; 4] {
        let [a, b, c] = self.vertices;
        [a, b, c, self.material]
    }
}

impl Material {
    /// A material of constant reflectance that does not emit.
    pub fn diffuse(name: &str, albedo: Vec3) -> Self {
        Material {
            name: name.to_owned(),
            albedo,
            texture: None,
            wrap: [Wrap::Repeat; 2],
            alpha_factor: 1.0,
            alpha: Alpha::Opaque,
            emission: Vec3::ZERO,
            metallic: 0.0,
            roughness: 1.0,
        }
    }

    /// Everything but the name.
    fn words(&self) -> [u32; 14] {
        let (mode, cutoff) = match self.alpha {
            Alpha::Opaque => (0, 0.0),
            Alpha::Mask(cutoff) => (1, cutoff),
            Alpha::Blend => (2, 0.0),
        };
        let (a, e) = (self.albedo, self.emission);
        let floats = [a.x, a.y, a.z, e.x, e.y, e.z, self.alpha_factor, cutoff, self.metallic, self.roughness];
        let mut words = [0; 14];
        for (word, float) in words.iter_mut().zip(floats) {
            *word = float.to_bits();
        }
        words[10] = mode;
        words[11] = u32::from(self.texture.is_some());
        words[12] = self.texture.unwrap_or(0);
        words[13] = self.wrap[0] as u32 | (self.wrap[1] as u32) << 2;
        words
    }
}

impl Light {
    /// Where it is; a directional light is nowhere.
    pub fn position_mut(&mut self) -> Option<&mut Vec3> {
        match self {
            Light::Point { position, .. } | Light::Spot { position, .. } => Some(position),
            Light::Directional { .. } => None,
        }
    }

    fn words(&self) -> [f32; 12] {
        let pack = |kind: f32, a: Vec3, b: Vec3, c: Vec3, cosines: [f32; 2]| {
            [kind, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, cosines[0], cosines[1]]
        };
        match *self {
            Light::Point { position, intensity } => pack(0.0, position, Vec3::ZERO, intensity, [0.0; 2]),
            Light::Spot { position, direction, intensity, cos_inner, cos_outer } => {
                pack(1.0, position, direction, intensity, [cos_inner, cos_outer])
            }
            Light::Directional { direction, irradiance } => pack(2.0, Vec3::ZERO, direction, irradiance, [0.0; 2]),
        }
    }
}

impl Camera {
    /// A camera at `position` that looks at `target`, with +Y up in the picture (+Z where it looks straight up or down).
    pub fn look_at(name: &str, position: Vec3, target: Vec3, fovy_rad: f32) -> Self {
        let forward = (target - position).normalize();
        let world_up = if forward.y.abs() > 0.9999 { Vec3::Z } else { Vec3::Y };
        let right = forward.cross(world_up).normalize();
        Camera { name: name.to_owned(), node: String::new(), position, forward, up: right.cross(forward), fovy_rad }
    }

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
