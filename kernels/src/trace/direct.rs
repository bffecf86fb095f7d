//! Direct light: irradiance at each surface point from all lights and the environment, with shadow rays.
//!
//! One invocation lights one pixel; grid: pixels. Light sampling: [`super::light`]. After `trace_gbuffer`, before
//! `trace_compose`. Good when lights are few or large; with hundreds of lights each pixel picks some by their power, and
//! noise remains.

#[cfg(not(target_arch = "spirv"))]
use super::case::{self, CaseScene};
use super::light::{DirectSampling, direct_irradiance};
use super::{Receiver, SceneRef};
use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::rng::hash;
use glam::Vec4;
use interreflect_shared::scene::{BvhNode, NO_SURFACE, SceneLight, SceneTriangle, Surfel, TriangleAttributes};
use interreflect_shared::trace::DirectParams;

/// Receivers.
pub fn receivers(p: &DirectParams) -> Rows {
    Rows::all(p.count)
}

/// Direct irradiance (W/m², w = 0) at surface point `i`; zero where there is no surface.
#[inline(always)]
pub fn direct(
    i: u32,
    p: &DirectParams,
    nodes: &[BvhNode],
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
    lights: &[SceneLight],
    surfels: &[Surfel],
) -> Vec4 {
    let scene = SceneRef { nodes, triangles, attributes, surfaces };
    let surfel = surfels[i as usize];
    if surfel.triangle == NO_SURFACE {
        return Vec4::ZERO;
    }
    let at = Receiver::of(&surfel);
    let sampling = DirectSampling {
        light_count: p.light_count,
        light_samples: p.light_samples,
        pick_above: p.pick_above,
        environment: p.environment.truncate(),
        environment_samples: p.environment_samples,
    };
    direct_irradiance(&scene, lights, &sampling, &at, hash(p.seed ^ hash(i))).extend(0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn direct_case(input: &mut CaseInput) -> Case {
    let scene = CaseScene::new(input);
    let surfels: alloc::vec::Vec<Surfel> = (0..input.count).map(|_| case::surfel(input)).collect();
    let params = DirectParams {
        environment: Vec4::new(0.5, 0.25, 0.125, 0.0),
        count: input.count as u32,
        light_count: scene.lights.len() as u32,
        light_samples: 4,
        environment_samples: 4,
        pick_above: if input.bits() & 1 == 0 { 0 } else { 64 },
        seed: input.bits(),
        _pad0: 0,
        _pad1: 0,
    };
    scene.bind(Case::default().uniform(&params)).read(&scene.lights).read(&surfels).zeroed::<Vec4>(input.count)
}

kernel! {
    /// Surface points to direct irradiance.
    mod trace_direct = super::direct; entry "trace_direct" threads(64);
    uniform 0 params: DirectParams;
    read 1 nodes: BvhNode;
    read 2 triangles: SceneTriangle;
    read 3 attributes: TriangleAttributes;
    read 4 surfaces: u32;
    read 5 lights: SceneLight;
    read 6 surfels: Surfel;
    write 7 irradiance: Vec4;
    over super::receivers;
    case super::direct_case; tolerance Tolerance::RelAbs(1e-4, 1e-5), "sine and cosine of sample directions, Lambert's sum of angles";
}
