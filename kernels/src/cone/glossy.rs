//! Glossy reflection: one cone along the mirror direction.
//!
//! One invocation traces one cone from one surface point of a picture; grid: surface points. The cone's half angle stands
//! for the lobe of a material (the host sets its tangent). Crassin et al. 2011, §7: specular cones. For the light that lamps
//! send into mirrors inject with an emission weight of 1.
//!
//! Good when surfaces are rough: what is nearer than a voxel, or sharper than one, cannot be seen. Pass before: mipmaps.

#[cfg(not(target_arch = "spirv"))]
use super::case::cone_params;
use super::gather::NEAREST;
use super::march::{ConeMarch, trace_cone};
use crate::kernel::fetch;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::max;
use crate::math::vector::{normalize, reflect};
#[cfg(not(target_arch = "spirv"))]
use crate::voxel::case::CasePyramid;
use crate::voxel::grid::grid_from_world;
use crate::voxel::query::VoxelPyramid;
use glam::{Vec3, Vec4};
use interreflect_shared::cone::ConeParams;
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use interreflect_shared::voxel::VoxelFacet;

/// Reflected radiance (rgb, W/(sr m²)) towards the camera of `p` at surface point `i` for a reflectance of 1, and the share
/// of the cone that leaves the grid (w; its radiance, `p.beyond`, is in rgb already).
#[inline(always)]
pub fn glossy(
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
    let surfel = fetch(surfels, i as usize);
    if surfel.triangle == NO_SURFACE {
        return Vec4::ZERO;
    }
    let pyramid = VoxelPyramid { cells, facet_bits, facets, radiance, odd, even };
    let position = Vec3::from_array(surfel.position);
    let wo = normalize(p.camera.truncate() - position);
    let wi = reflect(wo, Vec3::from_array(surfel.normal));
    let start = grid_from_world(p, position) + Vec3::from_array(surfel.geometric_normal) * p.offset;
    let march = ConeMarch {
        spread: 2.0 * p.camera.w,
        clear: p.clearance * p.offset,
        clear_slope: p.clearance * max(wi.dot(Vec3::from_array(surfel.geometric_normal)), 0.0),
        rounding: NEAREST,
    };
    let found = trace_cone(p, &pyramid, start, wi, &march);
    (found.truncate() + p.beyond.truncate() * found.w).extend(found.w)
}

#[cfg(not(target_arch = "spirv"))]
fn glossy_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::lit(input);
    let surfels: alloc::vec::Vec<Surfel> = (0..input.count).map(|_| super::case::surfel(input, &pyramid)).collect();
    let params = cone_params(input, &pyramid.params);
    pyramid.bind(Case::default().uniform(&params)).read(&surfels).zeroed::<Vec4>(input.count)
}

kernel! {
    /// Surface points to radiance reflected towards the camera.
    mod cone_glossy = super::glossy; entry "cone_glossy" threads(64);
    uniform 0 params: ConeParams;
    read 1 cells: u32;
    read 2 facet_bits: u32;
    read 3 facets: VoxelFacet;
    read 4 radiance: Vec4;
    read 5 odd: Vec4;
    read 6 even: Vec4;
    read 7 surfels: Surfel;
    write 8 out: Vec4;
    case super::glossy_case; tolerance Tolerance::RelAbs(1e-3, 1e-6), "hundreds of samples whose positions differ in the last place; whether a sample of vanishing coverage ends a surface may differ";
}
