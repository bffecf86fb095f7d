//! Inputs of the cone kernels' test cases.

use super::set::{cone_parts, diffuse_cones, half_angle_tangent};
use crate::kernel::CaseInput;
use crate::voxel::case::CasePyramid;
use glam::{UVec3, Vec3, Vec4};
use interreflect_shared::cone::ConeParams;
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use interreflect_shared::voxel::VoxelParams;

/// Six cones that end in a sky.
pub fn cone_params(input: &mut CaseInput, p: &VoxelParams) -> ConeParams {
    let camera = p.origin_size.truncate() + Vec3::splat(p.origin_size.w * 3.0);
    ConeParams {
        origin_size: p.origin_size,
        dims_levels: p.dims_levels,
        levels: p.levels,
        cones: diffuse_cones(6),
        parts: cone_parts(6),
        beyond: Vec4::new(0.25, 0.5, 1.0, 0.0),
        camera: camera.extend(0.1),
        cone_count: 6,
        direction_count: p.direction_count,
        count: 0,
        seed: input.bits() & 1,
        spread: half_angle_tangent(6),
        offset: 1.0,
        clearance: 1.0,
        _pad: 0.0,
    }
}

/// A receiver somewhere in the grid, now and then none.
pub fn surfel(input: &mut CaseInput, pyramid: &CasePyramid) -> Surfel {
    let p = &pyramid.params;
    let d = p.dims_levels;
    let dims = UVec3::new(d.x, d.y, d.z).as_vec3();
    let at = Vec3::new(input.unit(), input.unit(), input.unit()) * dims * p.origin_size.w;
    let normal = input.direction().to_array();
    Surfel {
        position: (p.origin_size.truncate() + at).to_array(),
        triangle: if input.bits().is_multiple_of(16) { NO_SURFACE } else { 0 },
        normal,
        geometric_normal: normal,
        ..crate::trace::surface::no_surface()
    }
}
