//! Building blocks of scenes made in code.

use crate::scene::{Camera, Light, Material, Scene, Triangle};
use glam::{Vec2, Vec3};

/// Collects the parts of a scene. Corners are given counter-clockwise as seen from the front.
pub struct SceneBuilder {
    scene: Scene,
}

impl SceneBuilder {
    /// An empty scene.
    pub fn new(name: &str) -> Self {
        SceneBuilder { scene: Scene { name: name.to_owned(), ..Scene::default() } }
    }

    /// Adds a material that reflects; its index.
    pub fn diffuse(&mut self, name: &str, albedo: impl Into<Vec3>) -> u32 {
        self.material(Material::diffuse(name, albedo.into()))
    }

    /// Adds a material that reflects and emits from its front; its index.
    pub fn emitter(&mut self, name: &str, albedo: impl Into<Vec3>, emission: impl Into<Vec3>) -> u32 {
        self.material(Material { emission: emission.into(), ..Material::diffuse(name, albedo.into()) })
    }

    /// Adds a material; its index.
    pub fn material(&mut self, material: Material) -> u32 {
        self.scene.materials.push(material);
        self.scene.materials.len() as u32 - 1
    }

    /// Adds a light without a surface.
    pub fn light(&mut self, light: Light) {
        self.scene.lights.push(light);
    }

    /// Sets the radiance of the environment.
    pub fn environment(&mut self, radiance: Vec3) {
        self.scene.environment = radiance;
    }

    /// Adds a camera; the first one is the default.
    pub fn camera(&mut self, name: &str, position: [f32; 3], target: [f32; 3], fovy_deg: f32) {
        let camera = Camera::look_at(name, position.into(), target.into(), fovy_deg.to_radians());
        self.scene.cameras.push(camera);
    }

    /// Adds a vertex; its index.
    pub fn vertex(&mut self, position: Vec3, normal: Vec3, uv: Vec2) -> u32 {
        self.scene.positions.push(position);
        self.scene.normals.push(normal);
        self.scene.uvs.push(uv);
        self.scene.positions.len() as u32 - 1
    }

    /// Adds a triangle of existing vertices.
    pub fn triangle(&mut self, vertices: [u32; 3], material: u32) {
        self.scene.triangles.push(Triangle { vertices, material });
    }

    /// Adds a flat polygon as a fan around its first corner, from which it must be wholly visible. The first three
    /// corners give its normal.
    pub fn polygon(&mut self, corners: &[Vec3], material: u32) {
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        let first = self.scene.positions.len() as u32;
        for &corner in corners {
            self.vertex(corner, normal, Vec2::ZERO);
        }
        for i in 1..corners.len() as u32 - 1 {
            self.triangle([first, first + i, first + i + 1], material);
        }
    }

    /// Adds a quadrilateral.
    pub fn quad(&mut self, corners: [impl Into<Vec3>; 4], material: u32) {
        self.polygon(&corners.map(Into::into), material);
    }

    /// Adds a parallelogram that spans `u` and `v` from a corner; its front is where `u × v` points.
    pub fn parallelogram(&mut self, corner: Vec3, u: Vec3, v: Vec3, material: u32) {
        self.polygon(&[corner, corner + u, corner + u + v, corner + v], material);
    }

    /// Adds an axis-aligned block, its six fronts outside.
    pub fn block(&mut self, min: impl Into<Vec3>, max: impl Into<Vec3>, material: u32) {
        let (min, max) = (min.into(), max.into());
        self.cuboid(min, Vec3::X * (max.x - min.x), Vec3::Y * (max.y - min.y), Vec3::Z * (max.z - min.z), material);
    }

    /// Adds a parallelepiped that spans the right-handed edges `u`, `v`, `w` from a corner, its six fronts outside.
    pub fn cuboid(&mut self, corner: Vec3, u: Vec3, v: Vec3, w: Vec3, material: u32) {
        let far = corner + u + v + w;
        for (a, b) in [(u, v), (v, w), (w, u)] {
            self.parallelogram(corner, b, a, material);
            self.parallelogram(far, -a, -b, material);
        }
    }

    /// Adds an axis-aligned room, its six fronts inside. Materials: −X, +X, −Y (floor), +Y (ceiling), −Z, +Z.
    pub fn room(&mut self, min: impl Into<Vec3>, max: impl Into<Vec3>, materials: [u32; 6]) {
        let (min, max) = (min.into(), max.into());
        let size = max - min;
        let (x, y, z) = (Vec3::X * size.x, Vec3::Y * size.y, Vec3::Z * size.z);
        self.parallelogram(min, y, z, materials[0]);
        self.parallelogram(max, -z, -y, materials[1]);
        self.parallelogram(min, z, x, materials[2]);
        self.parallelogram(max, -x, -z, materials[3]);
        self.parallelogram(min, x, y, materials[4]);
        self.parallelogram(max, -y, -x, materials[5]);
    }

    /// Adds a surface of revolution around the vertical axis through `centre`: `profile` lists (radius, height) in the
    /// order that leaves the outside on the right when the radius is drawn to the right and height upwards. Edges of
    /// the profile are smooth where it bends by less than 50°.
    pub fn lathe(&mut self, centre: Vec3, profile: &[(f32, f32)], segments: u32, material: u32) {
        const COS_SMOOTH: f32 = 0.64;
        let slopes: Vec<Vec2> =
            profile.windows(2).map(|p| Vec2::new(p[1].1 - p[0].1, p[0].0 - p[1].0).normalize()).collect();
        let blend = |a: Vec2, b: Option<&Vec2>| match b {
            Some(&b) if a.dot(b) > COS_SMOOTH => (a + b).normalize(),
            _ => a,
        };
        for (band, (&slope, ends)) in slopes.iter().zip(profile.windows(2)).enumerate() {
            let before = band.checked_sub(1).and_then(|i| slopes.get(i));
            let low = self.ring(centre, ends[0], blend(slope, before), segments);
            let high = self.ring(centre, ends[1], blend(slope, slopes.get(band + 1)), segments);
            for i in 0..segments {
                let next = (i + 1) % segments;
                if ends[0].0 > 0.0 {
                    self.triangle([low + next, low + i, high + i], material);
                }
                if ends[1].0 > 0.0 {
                    self.triangle([low + next, high + i, high + next], material);
                }
            }
        }
    }

    /// A ring of vertices; the index of its first. `normal` is (radial, vertical).
    fn ring(&mut self, centre: Vec3, (radius, height): (f32, f32), normal: Vec2, segments: u32) -> u32 {
        let first = self.scene.positions.len() as u32;
        for i in 0..segments {
            let (sin, cos) = (std::f32::consts::TAU * i as f32 / segments as f32).sin_cos();
            let position = centre + Vec3::new(radius * cos, height, radius * sin);
            self.vertex(position, Vec3::new(normal.x * cos, normal.y, normal.x * sin), Vec2::ZERO);
        }
        first
    }

    /// The scene.
    pub fn finish(self) -> Scene {
        self.scene
    }
}

/// A number in 0…1 that looks random, the same for the same `seed` everywhere (PCG hash: Jarzynski and Olano 2020).
pub fn hash_unit(seed: u32) -> f32 {
    let state = seed.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    ((word >> 22) ^ word) as f32 / u32::MAX as f32
}
