//! Light on facets, and what they reflect.
//!
//! `voxel_inject`: one invocation computes the direct irradiance of one side of one facet by shadow rays from the facet's
//! centroid: every kind of light, emissive triangles and the environment included. `voxel_radiate`: one invocation turns a
//! side's direct and bounced irradiance into radiance, ρ/π·(direct + bounced), by default without emission: emitted light
//! that reaches a receiver is direct light, which methods compute apart.
//!
//! Shadow rays instead of a shadow map per light (Crassin et al. 2011, §5): no resolution, any light. Surfaces inside one
//! voxel are not flat: rays start off the centroid by the sag that the spread of the normals tells of, so that a curved
//! surface does not shade itself.
//!
//! Good when lights are few; each costs a ray per facet. Pass before: `facet.rs`, or `cone/bounce.rs` for further bounces.
//! Pass after: `mip.rs`.

#[cfg(not(target_arch = "spirv"))]
use super::case::CasePyramid;
use super::facet::facet_normal;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{abs, max, min, sqrt};
use crate::math::rng::hash;
use crate::math::vector::length;
use crate::trace::light::DirectSampling;
use crate::trace::{Receiver, SceneRef, direct_irradiance};
use core::f32::consts::FRAC_1_PI;
use glam::{Vec3, Vec4};
use interreflect_shared::scene::{BvhNode, SceneLight, SceneTriangle, TriangleAttributes};
use interreflect_shared::voxel::{VoxelFacet, VoxelParams};

/// Lights above which a facet picks some by power instead of asking all.
const PICK_ABOVE: u32 = 64;
/// Sag of a cap over a voxel, in voxels, per square root of its normals' shortfall: a sphere's cap of half angle φ has a
/// mean normal of 1 − φ²/6 and, one voxel wide, a sag of φ/4.
const SAG: f32 = 0.61;
/// Start of shadow rays off a flat facet, in voxels: ten times the rounding of a centroid.
const FLAT_OFFSET: f32 = 1e-3;

/// Rounding of a position, as a share of its largest coordinate: that of the sum of the grid's corner and the place in it,
/// and that of the corner.
const POSITION_ROUNDING: f32 = 2.0 * f32::EPSILON;

/// Offset of rays that leave a facet, in voxels.
#[inline(always)]
pub fn facet_sag(facet: &VoxelFacet) -> f32 {
    let mean = length(Vec3::from_array(facet.normal)) / max(facet.area, 1e-12);
    FLAT_OFFSET + SAG * sqrt(min(max(1.0 - mean, 0.0), 0.5))
}

/// How far a facet's stored position may lie off its plane (m): far from the origin that is more than any share of a voxel,
/// and a ray that started below its own surface would see no light.
#[inline(always)]
fn rounding(position: Vec3) -> f32 {
    POSITION_ROUNDING * max(max(abs(position.x), abs(position.y)), abs(position.z))
}

/// Direct irradiance (W/m², w = 0) on side `i & 1` (0 front, 1 back) of facet `i / 2`.
#[inline(always)]
pub fn inject(
    i: u32,
    p: &VoxelParams,
    nodes: &[BvhNode],
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
    lights: &[SceneLight],
    facets: &[VoxelFacet],
) -> Vec4 {
    let scene = SceneRef { nodes, triangles, attributes, surfaces };
    let facet = facets[(i / 2) as usize];
    let front = facet_normal(&facet);
    let normal = if i & 1 == 0 { front } else { -front };
    let at = Receiver {
        position: Vec3::from_array(facet.position),
        normal,
        geometric_normal: normal,
        error: facet_sag(&facet) * p.origin_size.w + rounding(Vec3::from_array(facet.position)),
    };
    let sampling = DirectSampling {
        light_count: p.light.x,
        light_samples: p.light.y,
        pick_above: PICK_ABOVE,
        environment: p.environment.truncate(),
        environment_samples: p.light.z,
    };
    direct_irradiance(&scene, lights, &sampling, &at, hash(p.light.w ^ hash(i))).extend(0.0)
}

/// Radiance (W/(sr m²), w = 0) of side `i & 1` of facet `i / 2`.
#[inline(always)]
pub fn radiate(i: u32, p: &VoxelParams, facets: &[VoxelFacet], direct: &[Vec4], bounced: &[Vec4]) -> Vec4 {
    let facet = &facets[(i / 2) as usize];
    let irradiance = direct[i as usize] + bounced[i as usize] * p.bounce_gain;
    let reflected = Vec3::from_array(facet.albedo) * irradiance.truncate() * FRAC_1_PI;
    let emitting = if i & 1 == 0 { p.emission_weight } else { 0.0 };
    (reflected + Vec3::from_array(facet.emission) * emitting).extend(0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn inject_case(input: &mut CaseInput) -> Case {
    let scene = crate::trace::case::CaseScene::new(input);
    let pyramid = CasePyramid::resolved(input);
    let params = VoxelParams {
        environment: Vec4::new(0.5, 0.25, 0.125, 0.0),
        light: glam::UVec4::new(scene.lights.len() as u32, 4, 4, input.bits()),
        ..pyramid.params
    };
    scene
        .bind(Case::default().uniform(&params))
        .read(&scene.lights)
        .read(&pyramid.facets)
        .zeroed::<Vec4>(pyramid.facets.len() * 2)
}

#[cfg(not(target_arch = "spirv"))]
fn radiate_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::lit(input);
    let params = VoxelParams { emission_weight: 1.0, bounce_gain: Vec4::new(1.5, 1.25, 1.0, 1.0), ..pyramid.params };
    let bounced: alloc::vec::Vec<Vec4> = pyramid.radiance.iter().map(|r| *r * 0.5).collect();
    Case::default()
        .uniform(&params)
        .read(&pyramid.facets)
        .read(&pyramid.radiance)
        .read(&bounced)
        .zeroed::<Vec4>(pyramid.radiance.len())
}

kernel! {
    /// Direct irradiance of both sides of every facet.
    mod voxel_inject = super::inject; entry "voxel_inject" threads(64);
    uniform 0 params: VoxelParams;
    read 1 nodes: BvhNode;
    read 2 triangles: SceneTriangle;
    read 3 attributes: TriangleAttributes;
    read 4 surfaces: u32;
    read 5 lights: SceneLight;
    read 6 facets: VoxelFacet;
    write 7 out: Vec4;
    case super::inject_case; tolerance Tolerance::RelAbs(1e-4, 1e-5), "sine and cosine of sample directions, Lambert's sum of angles";
}

kernel! {
    /// Radiance of both sides of every facet.
    mod voxel_radiate = super::radiate; entry "voxel_radiate" threads(64);
    uniform 0 params: VoxelParams;
    read 1 facets: VoxelFacet;
    read 2 direct: Vec4;
    read 3 bounced: Vec4;
    write 4 out: Vec4;
    case super::radiate_case; tolerance Tolerance::RelAbs(1e-6, 1e-35), "a multiply-add may be fused on a device";
}
