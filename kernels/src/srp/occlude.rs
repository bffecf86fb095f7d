//! Moving bodies between probes and what their relight rays meet.
//!
//! One invocation: what one relight ray of one probe meets, as a slot. Grid: entries of the buffer of hits. Silvennoinen &
//! Lehtinen 2017, §5.1 "Dynamic Occluders": a blocked ray sees the body instead of the receiver; here the body may have a
//! light of its own (black by default). `srp_occlude` tests spheres and cubes under affine transformations, the nearest
//! one wins; `srp_occlude_mesh` any mesh through a BVH in the mesh's own coordinates, after it. Runs when a body moves,
//! not every update.
//!
//! Good for doors, vehicles, large bodies: blocks at the probes alone. Bodies smaller than the spacing of probes cast hardly a
//! shadow, and no body blocks light between receivers and what the baked transport lets them see.

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{abs, max, min, sqrt};
use crate::trace::{Ray, SceneRef, any_hit};
use glam::{Vec3, Vec4};
use interreflect_shared::scene::{BvhNode, SceneTriangle, TriangleAttributes};
use interreflect_shared::srp::{SRP_CUBE, SRP_LANES, SrpOccludeParams, SrpOccluder};

/// Entries of the buffer of hits.
pub fn entries(p: &SrpOccludeParams) -> Rows {
    Rows::all(p.entry_count)
}

/// Probe and ray of an entry, as [`interreflect_shared::srp::SrpLayout::ray`] lays them out; either may be padding.
#[inline(always)]
fn probe_and_ray(i: u32, p: &SrpOccludeParams) -> (u32, u32) {
    let tiles = p.probe_count.div_ceil(SRP_LANES);
    let row = i / SRP_LANES;
    let slice_tile = row / p.slice_rays;
    let slice = slice_tile / tiles;
    let probe = (slice_tile - slice * tiles) * SRP_LANES + i - row * SRP_LANES;
    (probe, slice * p.slice_rays + row - slice_tile * p.slice_rays)
}

/// A row of an affine matrix times a point (`w` 1) or a direction (`w` 0).
#[inline(always)]
fn row_times(row: Vec4, v: Vec3, w: f32) -> f32 {
    row.x * v.x + row.y * v.y + row.z * v.z + row.w * w
}
/// An affine matrix times a point (`w` 1) or a direction (`w` 0).
#[inline(always)]
fn transformed(rows: &[Vec4; 3], v: Vec3, w: f32) -> Vec3 {
    Vec3::new(row_times(rows[0], v, w), row_times(rows[1], v, w), row_times(rows[2], v, w))
}

/// Distance at which a ray enters the unit sphere; 0 from inside, `f32::MAX` where it does not.
#[inline(always)]
fn sphere_entry(origin: Vec3, direction: Vec3) -> f32 {
    let (a, b, c) = (direction.dot(direction), origin.dot(direction), origin.dot(origin) - 1.0);
    let discriminant = b * b - a * c;
    let entry = (-b - sqrt(max(discriminant, 0.0))) / max(a, f32::MIN_POSITIVE);
    let meets = c <= 0.0 || (discriminant > 0.0 && b < 0.0);
    if meets { max(entry, 0.0) } else { f32::MAX }
}

/// Distance at which a ray enters the cube from −1 to 1; 0 from inside, `f32::MAX` where it does not.
#[inline(always)]
fn cube_entry(origin: Vec3, direction: Vec3) -> f32 {
    let (near_x, far_x) = slab(origin.x, direction.x);
    let (near_y, far_y) = slab(origin.y, direction.y);
    let (near_z, far_z) = slab(origin.z, direction.z);
    let near = max(max(near_x, near_y), near_z);
    let far = min(min(far_x, far_y), far_z);
    if near <= far && far >= 0.0 { max(near, 0.0) } else { f32::MAX }
}
/// Where a ray lies between −1 and 1 along one axis.
#[inline(always)]
fn slab(origin: f32, direction: f32) -> (f32, f32) {
    // A ray along the slab never leaves it, or never enters.
    let step = if abs(direction) < SMALLEST_SLOPE { SMALLEST_SLOPE } else { direction };
    let (a, b) = ((-1.0 - origin) / step, (1.0 - origin) / step);
    (min(a, b), max(a, b))
}
/// Directions below this count as this.
const SMALLEST_SLOPE: f32 = 1e-12;

/// Slot that entry `i` sees behind the bodies. `hits`: without them; `distances` (m): of what the rays meet, `f32::MAX` of
/// those that miss; `rays`: positions of probes, then directions (w unused).
#[inline(always)]
pub fn occlude(
    i: u32,
    p: &SrpOccludeParams,
    hits: &[u32],
    distances: &[f32],
    rays: &[Vec4],
    occluders: &[SrpOccluder],
) -> u32 {
    let (probe, ray) = probe_and_ray(i, p);
    let (mut slot, mut nearest) = (hits[i as usize], distances[i as usize]);
    if probe < p.probe_count && ray < p.ray_count {
        let origin = rays[probe as usize].truncate();
        let direction = rays[(p.probe_count + ray) as usize].truncate();
        for k in 0..p.occluder_count {
            let occluder = occluders[k as usize];
            let o = transformed(&occluder.local_from_world, origin, 1.0);
            let d = transformed(&occluder.local_from_world, direction, 0.0);
            let entry = if occluder.kind == SRP_CUBE { cube_entry(o, d) } else { sphere_entry(o, d) };
            if entry < nearest {
                nearest = entry;
                slot = occluder.slot;
            }
        }
    }
    slot
}

/// Slot that entry `i` sees behind the mesh; the other buffers as for [`occlude`].
#[inline(always)]
pub fn occlude_mesh(
    i: u32,
    p: &SrpOccludeParams,
    hits: &[u32],
    distances: &[f32],
    rays: &[Vec4],
    nodes: &[BvhNode],
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
) -> u32 {
    let (probe, ray) = probe_and_ray(i, p);
    let mut slot = hits[i as usize];
    if probe < p.probe_count && ray < p.ray_count {
        let origin = transformed(&p.local_from_world, rays[probe as usize].truncate(), 1.0);
        let direction = transformed(&p.local_from_world, rays[(p.probe_count + ray) as usize].truncate(), 0.0);
        let mesh = SceneRef { nodes, triangles, attributes, surfaces };
        if any_hit(&mesh, &Ray::until(origin, direction, distances[i as usize])) {
            slot = p.slot;
        }
    }
    slot
}

#[cfg(not(target_arch = "spirv"))]
struct CaseRays {
    params: SrpOccludeParams,
    hits: alloc::vec::Vec<u32>,
    distances: alloc::vec::Vec<f32>,
    rays: alloc::vec::Vec<Vec4>,
}
#[cfg(not(target_arch = "spirv"))]
fn case_rays(input: &mut CaseInput, occluder_count: u32) -> CaseRays {
    let (ray_count, slice_rays) = (16 * (1 + input.bits() % 2) - 5, 16);
    let slices = ray_count.div_ceil(slice_rays);
    let probe_count = (input.count as u32 / 64).min(40);
    let entry_count = probe_count.div_ceil(SRP_LANES) * SRP_LANES * slices * slice_rays;
    let params = SrpOccludeParams {
        local_from_world: [Vec4::X, Vec4::Y, Vec4::Z],
        probe_count,
        ray_count,
        slice_rays,
        occluder_count,
        slot: 77,
        entry_count,
        _pad0: 0,
        _pad1: 0,
    };
    let distance = |input: &mut CaseInput| {
        if input.bits().is_multiple_of(4) { f32::MAX } else { 6.0 * input.unit() }
    };
    let probe = |input: &mut CaseInput| (input.direction() * 2.0 * input.unit()).extend(0.0);
    CaseRays {
        params,
        hits: (0..entry_count).map(|_| input.bits() % 50).collect(),
        distances: (0..entry_count).map(|_| distance(input)).collect(),
        rays: (0..probe_count)
            .map(|_| probe(input))
            .chain((0..ray_count).map(|i| crate::math::sampling::spherical_fibonacci(i, ray_count).extend(0.0)))
            .collect(),
    }
}
#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let count = input.bits() % 6;
    let CaseRays { params, hits, distances, rays } = case_rays(input, count);
    let occluder = |input: &mut CaseInput| {
        let row = |axis: Vec3, input: &mut CaseInput| {
            (axis * (0.5 + 2.0 * input.unit()) + 0.2 * input.direction()).extend(2.0 * input.unit() - 1.0)
        };
        SrpOccluder {
            local_from_world: [row(Vec3::X, input), row(Vec3::Y, input), row(Vec3::Z, input)],
            kind: input.bits() % 2,
            slot: 60 + input.bits() % 8,
            _pad0: 0,
            _pad1: 0,
        }
    };
    let occluders: alloc::vec::Vec<SrpOccluder> = (0..count).map(|_| occluder(input)).collect();
    let case = Case::default().uniform(&params).read(&hits).read(&distances).read(&rays).read(&occluders);
    case.zeroed::<u32>(params.entry_count as usize)
}
#[cfg(not(target_arch = "spirv"))]
fn case_mesh(input: &mut CaseInput) -> Case {
    let CaseRays { params, hits, distances, rays } = case_rays(input, 0);
    let scene = crate::trace::case::CaseScene::new(input);
    let case = Case::default().uniform(&params).read(&hits).read(&distances).read(&rays);
    scene.bind(case).zeroed::<u32>(params.entry_count as usize)
}

kernel! {
    /// What relight rays meet behind moving spheres and cubes.
    mod srp_occlude = super::occlude; entry "srp_occlude" threads(64);
    uniform 0 params: SrpOccludeParams;
    read 1 hits: u32;
    read 2 distances: f32;
    read 3 rays: Vec4;
    read 4 occluders: SrpOccluder;
    write 5 seen: u32;
    over super::entries;
    case super::case; tolerance Tolerance::Exact, "integers; a ray that grazes a body may be decided either way where a device fuses, which no ray of the case does";
}

kernel! {
    /// What relight rays meet behind a moving mesh.
    mod srp_occlude_mesh = super::occlude_mesh; entry "srp_occlude_mesh" threads(64);
    uniform 0 params: SrpOccludeParams;
    read 1 hits: u32;
    read 2 distances: f32;
    read 3 rays: Vec4;
    read 4 nodes: BvhNode;
    read 5 triangles: SceneTriangle;
    read 6 attributes: TriangleAttributes;
    read 7 surfaces: u32;
    write 8 seen: u32;
    over super::entries;
    case super::case_mesh; tolerance Tolerance::Exact, "integers; a ray that grazes an edge may be decided either way where a device fuses, which no ray of the case does";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_entered_where_they_begin() {
        let along = |x: f32| (Vec3::new(x, 0.25, 0.0), Vec3::X);
        let (o, d) = along(-3.0);
        let rim = (1.0f32 - 0.0625).sqrt();
        assert!((sphere_entry(o, d) - (3.0 - rim)).abs() < 1e-6);
        assert!((cube_entry(o, d) - 2.0).abs() < 1e-6);
        // Twice the direction, half the distance.
        assert!((sphere_entry(o, 2.0 * d) - 0.5 * (3.0 - rim)).abs() < 1e-6);
        // From inside, behind, and beside.
        let (o, d) = along(0.0);
        assert_eq!((sphere_entry(o, d), cube_entry(o, d)), (0.0, 0.0));
        let (o, d) = along(3.0);
        assert_eq!((sphere_entry(o, d), cube_entry(o, d)), (f32::MAX, f32::MAX));
        let beside = Vec3::new(-3.0, 1.25, 0.0);
        assert_eq!((sphere_entry(beside, Vec3::X), cube_entry(beside, Vec3::X)), (f32::MAX, f32::MAX));
        // A corner of the cube that the sphere leaves out.
        let corner = Vec3::new(-3.0, 0.9, 0.9);
        assert_eq!(sphere_entry(corner, Vec3::X), f32::MAX);
        assert!(cube_entry(corner, Vec3::X) < 2.1);
    }

    #[test]
    fn entries_are_the_layouts() {
        use interreflect_shared::srp::{SrpLayout, SrpProbeParams};
        let probes = SrpProbeParams {
            probe_count: 21,
            ray_count: 37,
            coefficient_count: 4,
            slice_rays: 16,
            weight: 1.0,
            first_slice: 0,
            slice_count: 3,
            _pad0: 0,
        };
        let p = SrpOccludeParams {
            local_from_world: [Vec4::X, Vec4::Y, Vec4::Z],
            probe_count: 21,
            ray_count: 37,
            slice_rays: 16,
            occluder_count: 0,
            slot: 0,
            entry_count: 0,
            _pad0: 0,
            _pad1: 0,
        };
        for probe in 0..21 {
            for ray in 0..37 {
                let i = SrpLayout::new(&probes).ray(probe, ray) as u32;
                assert_eq!(probe_and_ray(i, &p), (probe, ray));
            }
        }
    }
}
