//! Raw rays: one invocation finds the closest hit of one ray. For tests, benchmarks and methods that shoot rays of their
//! own; grid: rays.

#[cfg(not(target_arch = "spirv"))]
use super::case::{self, CaseScene};
use super::ray::Ray;
use super::{SceneRef, closest_hit};
use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use glam::Vec3;
use interreflect_shared::scene::{BvhNode, SceneTriangle, TriangleAttributes};
use interreflect_shared::trace::{CountParams, TraceHit, TraceRay};

/// Elements.
pub fn elements(p: &CountParams) -> Rows {
    Rows::all(p.count)
}

/// The closest hit of ray `i`.
#[inline(always)]
pub fn closest(
    i: u32,
    _p: &CountParams,
    nodes: &[BvhNode],
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
    rays: &[TraceRay],
) -> TraceHit {
    let scene = SceneRef { nodes, triangles, attributes, surfaces };
    let ray = rays[i as usize];
    let hit = closest_hit(
        &scene,
        &Ray {
            origin: Vec3::from_array(ray.origin),
            direction: Vec3::from_array(ray.direction),
            t_min: ray.t_min,
            t_max: ray.t_max,
        },
    );
    TraceHit { t: hit.t, triangle: hit.triangle, u: hit.u, v: hit.v }
}

#[cfg(not(target_arch = "spirv"))]
fn closest_case(input: &mut CaseInput) -> Case {
    let scene = CaseScene::new(input);
    let rays: alloc::vec::Vec<TraceRay> = (0..input.count).map(|_| case::ray(input)).collect();
    scene.bind(Case::default().uniform(&case::count(input.count))).read(&rays).zeroed::<TraceHit>(input.count)
}

kernel! {
    /// Rays to closest hits.
    mod trace_rays = super::closest; entry "trace_rays" threads(64);
    uniform 0 params: CountParams;
    read 1 nodes: BvhNode;
    read 2 triangles: SceneTriangle;
    read 3 attributes: TriangleAttributes;
    read 4 surfaces: u32;
    read 5 rays: TraceRay;
    write 6 hits: TraceHit;
    over super::elements;
    case super::closest_case; tolerance Tolerance::RelAbs(1e-5, 1e-5), "about 20 roundings in coordinates up to 4";
}
