//! Primary rays: the surface point that each pixel's centre sees.
//!
//! One invocation finds the [`Surfel`] of one pixel; grid: pixels, row by row from the top left. Where the ray leaves the
//! scene the surfel has no triangle and the environment's radiance as emission. First pass of every picture; before
//! `trace_direct` and each method's own query.

#[cfg(not(target_arch = "spirv"))]
use super::case::{self, CaseScene};
use super::ray::Ray;
use super::surface::unit_or;
use super::{SceneRef, closest_hit, surface};
use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use glam::Vec3;
use interreflect_shared::scene::{BvhNode, SceneTriangle, Surfel, TriangleAttributes};
use interreflect_shared::trace::GBufferParams;

/// Pixels.
pub fn pixels(p: &GBufferParams) -> Rows {
    Rows::all(p.width * p.height)
}

/// The ray through the centre of pixel `i`: of unit length.
#[inline(always)]
pub fn primary_ray(i: u32, p: &GBufferParams) -> Ray {
    let row = i / p.width;
    let column = i - row * p.width;
    let x = (2 * column + 1) as f32 / p.width as f32 - 1.0;
    let y = 1.0 - (2 * row + 1) as f32 / p.height as f32;
    let direction = p.forward.truncate() + p.right.truncate() * x + p.up.truncate() * y;
    Ray::new(p.position.truncate(), unit_or(direction, Vec3::Z))
}

/// The surface point that pixel `i` sees.
#[inline(always)]
pub fn gbuffer(
    i: u32,
    p: &GBufferParams,
    nodes: &[BvhNode],
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
) -> Surfel {
    let scene = SceneRef { nodes, triangles, attributes, surfaces };
    let ray = primary_ray(i, p);
    let hit = closest_hit(&scene, &ray);
    let mut surfel = surface(&scene, &ray, &hit);
    if !hit.is_some() {
        surfel.emission = p.environment.truncate().to_array();
    }
    surfel
}

#[cfg(not(target_arch = "spirv"))]
fn gbuffer_case(input: &mut CaseInput) -> Case {
    let scene = CaseScene::new(input);
    let (params, count) = case::camera(input.count);
    scene.bind(Case::default().uniform(&params)).zeroed::<Surfel>(count)
}

kernel! {
    /// Primary rays to surface points.
    mod trace_gbuffer = super::gbuffer; entry "trace_gbuffer" threads(64);
    uniform 0 params: GBufferParams;
    read 1 nodes: BvhNode;
    read 2 triangles: SceneTriangle;
    read 3 attributes: TriangleAttributes;
    read 4 surfaces: u32;
    write 5 surfels: Surfel;
    over super::pixels;
    case super::gbuffer_case; tolerance Tolerance::RelAbs(2e-5, 1e-5), "texture weights and normals: about 30 roundings in coordinates up to 4";
}
