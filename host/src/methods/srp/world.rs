//! The scene as precomputation asks it: rays through the path tracer's eight-wide walk, which is twice as fast on a
//! processor as the kernels' own; surfaces as the kernels see them.

use super::model::Receiver;
use crate::methods::MethodError;
use crate::reference::trace::{KeptTree, NO_TRIANGLE, Tracer};
use crate::scene::Scene;
use crate::scene::device::PackedScene;
use glam::Vec3;
use interreflect_kernels::math::frame::Frame;
use interreflect_kernels::trace::{self, Hit, Ray, leave_surface};
use interreflect_shared::scene::Surfel;
use std::sync::Arc;

/// Rays to a point end this share of the way: 8 roundings before it.
const BEFORE_THE_POINT: f32 = 1.0 - 4.768_371_6e-7;

/// Cosine between a normal and an axis from which on the next axis is taken: of no slope that is common.
const ALONG: f32 = 0.77;

/// Frame around a normal for the rays of receivers. [`Frame::new`] jumps where `normal.z` changes its sign, and the normals of
/// upright walls lie there: rounding would decide which rays a wall sends. Here the tangent is the first axis that does not lie
/// along the normal, made perpendicular to it.
pub fn frame(normal: Vec3) -> Frame {
    let axis = if normal.x.abs() < ALONG { Vec3::X } else { Vec3::Z };
    let tangent = (axis - normal * normal.dot(axis)).normalize();
    Frame { tangent, bitangent: normal.cross(tangent), normal }
}

/// A scene with what rays need.
pub struct World<'a> {
    /// The scene.
    pub scene: &'a Scene,
    tracer: Tracer<'a>,
    structures: Arc<Structures>,
}

/// What is made of a scene's geometry for rays.
pub struct Structures {
    tree: KeptTree,
    /// The scene as kernels see it.
    packed: PackedScene,
    /// Device triangle of each of the scene's.
    device_triangle: Vec<u32>,
    faces: Vec<Face>,
}

impl Structures {
    /// Of a scene that the path tracer takes.
    ///
    /// # Errors
    /// As [`Tracer::new`].
    pub fn new(scene: &Scene) -> Result<Self, MethodError> {
        let tree = KeptTree::default();
        tree.tracer(scene)?;
        let packed = PackedScene::new(scene);
        let mut device_triangle = vec![0; scene.triangles.len()];
        for (device, t) in packed.triangles.iter().enumerate() {
            device_triangle[t.source as usize] = device as u32;
        }
        let faces = scene.triangles.iter().map(|t| Face::new(scene.corners(t))).collect();
        Ok(Self { tree, packed, device_triangle, faces })
    }
}

/// What of a triangle a hit needs.
struct Face {
    corner: Vec3,
    edges: [Vec3; 2],
    outward: Vec3,
    error: f32,
}

impl Face {
    fn new([a, b, c]: [Vec3; 3]) -> Self {
        let extent = (b - a).abs().max_element() + (c - a).abs().max_element();
        Self {
            corner: a,
            edges: [b - a, c - a],
            outward: (b - a).cross(c - a).normalize_or(Vec3::Y),
            // As in the kernels' surface fetch: 8 roundings of the corner, 18 of the edges.
            error: a.abs().max_element() * 4.8e-7 + extent * 1.1e-6,
        }
    }
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

impl From<&Receiver> for Seen {
    /// The surface of a receiver, whose place in its triangle nobody asks for.
    fn from(r: &Receiver) -> Self {
        Self {
            triangle: r.triangle,
            front: r.front,
            weights: [0.0; 3],
            position: r.position,
            normal: r.geometric_normal,
            error: r.error,
        }
    }
}

impl<'a> World<'a> {
    /// Builds the acceleration structures.
    ///
    /// # Errors
    /// As [`Tracer::new`].
    pub fn new(scene: &'a Scene) -> Result<Self, MethodError> {
        Self::sharing(scene, Arc::new(Structures::new(scene)?))
    }

    /// The same with structures of the same scene.
    ///
    /// # Errors
    /// As [`Tracer::new`].
    pub fn sharing(scene: &'a Scene, structures: Arc<Structures>) -> Result<Self, MethodError> {
        Ok(Self { scene, tracer: structures.tree.tracer(scene)?, structures })
    }

    /// The scene as kernels see it.
    pub fn packed(&self) -> &PackedScene {
        &self.structures.packed
    }

    /// What a ray from free space meets first.
    pub fn closest(&self, origin: Vec3, direction: Vec3) -> Option<Seen> {
        self.closest_but(origin, direction, NO_TRIANGLE)
    }

    /// What a ray that leaves a receiver meets first.
    #[inline(always)]
    pub fn closest_from(&self, r: &Receiver, direction: Vec3) -> Option<Seen> {
        let from = leave_surface(r.position, r.geometric_normal, r.error, direction);
        // No triangle has the number of a receiver in free space.
        self.closest_but(from, direction, r.triangle)
    }

    /// What a ray meets first, but for one triangle.
    #[inline(always)]
    pub fn closest_but(&self, origin: Vec3, direction: Vec3, own: u32) -> Option<Seen> {
        let hit = self.tracer.closest(origin, direction, f32::MAX, own)?;
        Some(self.on_side(hit.triangle, hit.barycentric.to_array(), |outward| outward.dot(direction) < 0.0))
    }

    /// The point of a triangle with the given weights of its corners, on one side. Shading attributes are not fetched:
    /// transport does not ask for them.
    pub fn seen(&self, triangle: u32, weights: [f32; 3], front: bool) -> Seen {
        self.on_side(triangle, weights, |_| front)
    }

    #[inline(always)]
    fn on_side(&self, triangle: u32, weights: [f32; 3], is_front: impl Fn(Vec3) -> bool) -> Seen {
        let f = &self.structures.faces[triangle as usize];
        let front = is_front(f.outward);
        Seen {
            triangle,
            front,
            weights,
            position: f.corner + f.edges[0] * weights[1] + f.edges[1] * weights[2],
            normal: if front { f.outward } else { -f.outward },
            error: f.error,
        }
    }

    /// Whether nothing lies between a surface point and a point in free space.
    #[inline(always)]
    pub fn sees(&self, from: &Seen, point: Vec3) -> bool {
        let start = leave_surface(from.position, from.normal, from.error, point - from.position);
        !self.tracer.occluded(start, point - start, BEFORE_THE_POINT, [from.triangle, NO_TRIANGLE])
    }

    /// The point of a triangle with the given weights of its corners, seen from one side: shading normal, reflectance
    /// and emission as in pictures. `triangle` is the host's index, and stays so in the result.
    pub fn surface(&self, triangle: u32, weights: [f32; 3], front: bool) -> Surfel {
        let packed = self.packed();
        let device = self.structures.device_triangle[triangle as usize];
        let t = &packed.triangles[device as usize];
        let (a, b, c) = (Vec3::from(t.v0), Vec3::from(t.v1), Vec3::from(t.v2));
        let outward = (b - a).cross(c - a).normalize_or(Vec3::Y);
        let towards = if front { -outward } else { outward };
        let hit = Hit { t: 1.0, triangle: device, u: weights[1], v: weights[2] };
        Surfel { triangle, ..trace::surface(&packed.view(), &Ray::new(Vec3::ZERO, towards), &hit) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use interreflect_kernels::math::sampling::spherical_fibonacci;

    #[test]
    fn frames_do_not_follow_the_rounding_of_upright_and_level_normals() {
        for i in 0..4096 {
            let f = frame(spherical_fibonacci(i, 4096));
            let error = [
                f.tangent.length() - 1.0,
                f.bitangent.length() - 1.0,
                f.tangent.dot(f.bitangent),
                f.tangent.dot(f.normal),
            ];
            assert!(
                error.iter().all(|e| e.abs() < 1e-6) && f.tangent.cross(f.bitangent).dot(f.normal) > 0.999,
                "{error:?}"
            );
        }
        for step in 0..27 {
            let n = Vec3::new((step % 3) as f32, (step / 3 % 3) as f32, (step / 9) as f32) - 1.0;
            if n != Vec3::ZERO {
                let f = frame(n.normalize());
                for k in 0..100 {
                    let g = frame((n + 1e-6 * spherical_fibonacci(k, 100)).normalize());
                    assert!(
                        (f.tangent - g.tangent).length() < 1e-5 && (f.bitangent - g.bitangent).length() < 1e-5,
                        "{n}"
                    );
                }
            }
        }
    }
}
