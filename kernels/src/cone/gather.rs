//! Diffuse gathering: indirect irradiance by a set of cones.
//!
//! `cone_gather`: one invocation gathers for one surface point of a picture. `cone_bounce`: one invocation gathers for one
//! side of one facet: light's next bounce among the voxels. Grid: receivers.
//!
//! Crassin et al. 2011, §7. Each cone's radiance counts with its exact share of the cosine (`set.rs`). Cones start above the
//! surface, so that its own voxels do not hide everything else: what is nearer than that is missed, and at a wall's foot the
//! wall is seen from a little higher. With a seed each cone points anywhere in its part of the hemisphere: the error of
//! few cones becomes noise that a filter or the eye averages, and its mean has none.
//!
//! Pass before: mipmaps of the voxels' radiance. Pass after: the shading of a picture, or `voxel_radiate`.

#[cfg(not(target_arch = "spirv"))]
use super::case::cone_params;
use super::march::{ConeMarch, trace_cone};
use crate::kernel::Rows;
use crate::kernel::fetch;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{max, sin_cos, sqrt};
use crate::math::frame::Frame;
use crate::math::rng::{rand, rand3};
#[cfg(not(target_arch = "spirv"))]
use crate::voxel::case::CasePyramid;
use crate::voxel::facet::facet_normal;
use crate::voxel::grid::{Grid, grid_from_world};
use crate::voxel::query::VoxelPyramid;
use core::f32::consts::{PI, TAU};
use glam::{UVec4, Vec3, Vec4};
use interreflect_shared::cone::ConeParams;
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use interreflect_shared::voxel::VoxelFacet;

impl Grid for ConeParams {
    #[inline(always)]
    fn origin_size(&self) -> Vec4 {
        self.origin_size
    }
    #[inline(always)]
    fn dims_levels(&self) -> UVec4 {
        self.dims_levels
    }
    #[inline(always)]
    fn level(&self, level: u32) -> UVec4 {
        *fetch(&self.levels, level as usize)
    }
    #[inline(always)]
    fn direction_count(&self) -> u32 {
        self.direction_count
    }
}

/// Rounds a size to the nearest level.
pub(super) const NEAREST: f32 = core::f32::consts::SQRT_2;

/// Receivers.
pub fn receivers(p: &ConeParams) -> Rows {
    Rows::all(p.count)
}

/// Random direction, with the density of the cosine, in a cone's part of the hemisphere (see [`ConeParams::parts`]).
#[inline(always)]
fn direction_in(part: Vec4, turn: f32, random: Vec3) -> Vec3 {
    let squared = part.y + (part.x - part.y) * random.x;
    let (sine, cosine) = sin_cos(TAU * (part.z + part.w * random.y + turn));
    let across = sqrt(max(1.0 - squared, 0.0));
    Vec3::new(across * cosine, across * sine, sqrt(squared))
}

/// Irradiance (W/m², w = 0) at a point with unit normals by the set of cones of `p`; `element` picks the random numbers.
#[inline(always)]
pub fn diffuse_irradiance(
    p: &ConeParams,
    pyramid: &VoxelPyramid<'_>,
    position: Vec3,
    normal: Vec3,
    geometric_normal: Vec3,
    element: u32,
) -> Vec4 {
    let start = grid_from_world(p, position) + geometric_normal * p.offset;
    let frame = Frame::new(normal);
    let turn = if p.seed == 0 { 0.0 } else { rand(p.seed, element, 0) };
    let mut sum = Vec3::ZERO;
    for k in 0..p.cone_count {
        let cone = p.cones[k as usize];
        let (local, rounding) = if p.seed == 0 {
            (cone.truncate(), NEAREST)
        } else {
            let random = rand3(p.seed, element, 1 + k);
            (direction_in(p.parts[k as usize], turn, random), 1.0 + random.z)
        };
        let march =
            ConeMarch { spread: p.spread, clear: p.clearance * p.offset, clear_slope: p.clearance * local.z, rounding };
        let found = trace_cone(p, pyramid, start, frame.world_from_local(local), &march);
        sum += (found.truncate() + p.beyond.truncate() * found.w) * cone.w;
    }
    (sum * PI).extend(0.0)
}

/// Irradiance at surface point `i` of a picture; zero where there is no surface.
#[inline(always)]
pub fn gather(
    i: u32,
    p: &ConeParams,
    cells: &[u32],
    facet_bits: &[u32],
    facets: &[VoxelFacet],
    radiance: &[Vec4],
    odd: &[Vec4],
    even: &[Vec4],
    surfels: &[Surfel],
) -> Vec4 {
    let surfel = surfels[i as usize];
    if surfel.triangle == NO_SURFACE {
        return Vec4::ZERO;
    }
    let pyramid = VoxelPyramid { cells, facet_bits, facets, radiance, odd, even };
    diffuse_irradiance(
        p,
        &pyramid,
        Vec3::from_array(surfel.position),
        Vec3::from_array(surfel.normal),
        Vec3::from_array(surfel.geometric_normal),
        i,
    )
}

/// Irradiance on side `i & 1` (0 front, 1 back) of facet `i / 2`.
#[inline(always)]
pub fn bounce(
    i: u32,
    p: &ConeParams,
    cells: &[u32],
    facet_bits: &[u32],
    facets: &[VoxelFacet],
    radiance: &[Vec4],
    odd: &[Vec4],
    even: &[Vec4],
) -> Vec4 {
    let facet = facets[(i / 2) as usize];
    let front = facet_normal(&facet);
    let normal = if i & 1 == 0 { front } else { -front };
    let pyramid = VoxelPyramid { cells, facet_bits, facets, radiance, odd, even };
    diffuse_irradiance(p, &pyramid, Vec3::from_array(facet.position), normal, normal, i)
}

#[cfg(not(target_arch = "spirv"))]
fn gather_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::lit(input);
    let surfels: alloc::vec::Vec<Surfel> = (0..input.count).map(|_| super::case::surfel(input, &pyramid)).collect();
    let params = ConeParams { count: input.count as u32, ..cone_params(input, &pyramid.params) };
    pyramid.bind(Case::default().uniform(&params)).read(&surfels).zeroed::<Vec4>(input.count)
}

#[cfg(not(target_arch = "spirv"))]
fn bounce_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::lit(input);
    let count = pyramid.radiance.len();
    let params = ConeParams { count: count as u32, ..cone_params(input, &pyramid.params) };
    pyramid.bind(Case::default().uniform(&params)).zeroed::<Vec4>(count)
}

kernel! {
    /// Surface points to indirect irradiance.
    mod cone_gather = super::gather; entry "cone_gather" threads(64);
    uniform 0 params: ConeParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 facets: VoxelFacet;
    read 4 radiance: Vec4;
    read 5 odd: Vec4;
    read 6 even: Vec4;
    read 7 surfels: Surfel;
    write 8 out: Vec4;
    over super::receivers;
    case super::gather_case; tolerance Tolerance::RelAbs(1e-3, 1e-6), "hundreds of samples whose positions differ in the last place; whether a sample of vanishing coverage ends a surface may differ";
}

kernel! {
    /// Facets to the irradiance of light's next bounce.
    mod cone_bounce = super::bounce; entry "cone_bounce" threads(64);
    uniform 0 params: ConeParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 facets: VoxelFacet;
    read 4 radiance: Vec4;
    read 5 odd: Vec4;
    read 6 even: Vec4;
    write 7 out: Vec4;
    over super::receivers;
    case super::bounce_case; tolerance Tolerance::RelAbs(1e-3, 1e-6), "hundreds of samples whose positions differ in the last place; whether a sample of vanishing coverage ends a surface may differ";
}
