//! The scene as precomputation asks it: rays through the kernels' own walk, hits in terms of the host's triangles.

use crate::scene::Scene;
use crate::scene::device::PackedScene;
use glam::Vec3;
use interreflect_kernels::trace::{self, Hit, Ray};
use interreflect_shared::scene::Surfel;

/// Rays to a point end this share of the way: 8 roundings before it.
const BEFORE_THE_POINT: f32 = 1.0 - 4.768_371_6e-7;

/// A scene with what rays need.
pub struct World<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// The same as kernels see it.
    pub packed: PackedScene,
    /// Device triangle of each of the scene's.
    device_triangle: Vec<u32>,
}

/// A point that a ray met.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Seen {
    /// Index of the scene's triangle.
    pub triangle: u32,
    /// Whether the ray met its front.
    pub front: bool,
    /// Weights of the triangle's corners.
    pub weights: [f32; 3],
    /// Place (m).
    pub position: Vec3,
    /// Unit normal of the surface on the ray's side.
    pub normal: Vec3,
    /// How far rays must start off it (m).
    pub error: f32,
}

impl<'a> World<'a> {
    /// Builds the acceleration structure.
    pub fn new(scene: &'a Scene) -> Self {
        let packed = PackedScene::new(scene);
        let mut device_triangle = vec![0; scene.triangles.len()];
        for (device, t) in packed.triangles.iter().enumerate() {
            device_triangle[t.source as usize] = device as u32;
        }
        Self { scene, packed, device_triangle }
    }

    /// What a ray meets first.
    pub fn closest(&self, origin: Vec3, direction: Vec3) -> Option<Seen> {
        let hit = trace::closest_hit(&self.packed.view(), &Ray::new(origin, direction));
        hit.is_some().then(|| self.seen(&hit, direction))
    }

    /// Geometry of a hit. Shading attributes are not fetched: transport does not ask for them.
    fn seen(&self, hit: &Hit, direction: Vec3) -> Seen {
        let t = &self.packed.triangles[hit.triangle as usize];
        let (a, b, c) = (Vec3::from(t.v0), Vec3::from(t.v1), Vec3::from(t.v2));
        let outward = (b - a).cross(c - a).normalize_or(Vec3::Y);
        let front = outward.dot(direction) < 0.0;
        let extent = (b - a).abs().max_element() + (c - a).abs().max_element();
        Seen {
            triangle: t.source,
            front,
            weights: [1.0 - hit.u - hit.v, hit.u, hit.v],
            position: a + (b - a) * hit.u + (c - a) * hit.v,
            normal: if front { outward } else { -outward },
            // As in the kernels' surface fetch: 8 roundings of the corner, 18 of the edges.
            error: a.abs().max_element() * 4.8e-7 + extent * 1.1e-6,
        }
    }

    /// Whether nothing lies between a surface point and a point in free space.
    pub fn sees(&self, from: &Seen, point: Vec3) -> bool {
        let start = trace::leave_surface(from.position, from.normal, from.error, point - from.position);
        !trace::any_hit(&self.packed.view(), &Ray::until(start, point - start, BEFORE_THE_POINT))
    }

    /// The point of a triangle with the given weights of its corners, seen from one side: shading normal, reflectance
    /// and emission as in pictures. `triangle` is the host's index, and stays so in the result.
    pub fn surface(&self, triangle: u32, weights: [f32; 3], front: bool) -> Surfel {
        let device = self.device_triangle[triangle as usize];
        let t = &self.packed.triangles[device as usize];
        let (a, b, c) = (Vec3::from(t.v0), Vec3::from(t.v1), Vec3::from(t.v2));
        let outward = (b - a).cross(c - a).normalize_or(Vec3::Y);
        let towards = if front { -outward } else { outward };
        let hit = Hit { t: 1.0, triangle: device, u: weights[1], v: weights[2] };
        Surfel { triangle, ..trace::surface(&self.packed.view(), &Ray::new(Vec3::ZERO, towards), &hit) }
    }

    /// The host's triangle of a device triangle.
    pub fn source(&self, device: u32) -> u32 {
        self.packed.triangles[device as usize].source
    }
}
