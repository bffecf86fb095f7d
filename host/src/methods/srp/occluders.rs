//! Moving bodies between probes and what their relight rays meet (`interreflect_kernels::srp::occlude`).

use super::model::{RAY_INVALID, RAY_MISS, SrpBake};
use super::packed::Packed;
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::scene::device::SceneBuffers;
use bytemuck::Zeroable;
use glam::{Affine3A, Vec3, Vec4};
use interreflect_kernels::srp::occlude::{srp_occlude, srp_occlude_mesh};
use interreflect_shared::srp::{SRP_CUBE, SRP_SPHERE, SrpOccludeParams, SrpOccluder};

/// Form of a body in its own coordinates.
#[derive(Clone, Copy, Debug)]
pub enum Shape<'a> {
    /// The unit sphere.
    Sphere,
    /// The cube from −1 to 1.
    Cube,
    /// A mesh: the buffers of a scene that holds it alone.
    Mesh(&'a SceneBuffers),
}

/// A body that blocks relight rays.
#[derive(Clone, Copy, Debug)]
pub struct Occluder<'a> {
    /// Form.
    pub shape: Shape<'a>,
    /// Place, turn and size: takes the form's own coordinates to the world. One that cannot be inverted blocks nothing.
    pub world_from_local: Affine3A,
    /// Radiance that blocked rays see, W/(sr m²).
    pub light: Vec3,
}

impl Occluder<'_> {
    /// A black sphere (centre and radius in m).
    pub fn sphere(centre: Vec3, radius: f32) -> Self {
        Self {
            shape: Shape::Sphere,
            world_from_local: Affine3A::from_scale_rotation_translation(
                Vec3::splat(radius),
                glam::Quat::IDENTITY,
                centre,
            ),
            light: Vec3::ZERO,
        }
    }
    /// A black box along the axes (centre and half sides in m).
    pub fn cuboid(centre: Vec3, half: Vec3) -> Self {
        Self {
            shape: Shape::Cube,
            world_from_local: Affine3A::from_scale_rotation_translation(half, glam::Quat::IDENTITY, centre),
            light: Vec3::ZERO,
        }
    }
    /// Rows of the matrix that takes the world to the form's own coordinates.
    fn rows(&self) -> Option<[Vec4; 3]> {
        let inverse = self.world_from_local.inverse();
        if !inverse.is_finite() {
            return None;
        }
        let rows = inverse.matrix3.transpose();
        let t = inverse.translation;
        Some([rows.x_axis.extend(t.x), rows.y_axis.extend(t.y), rows.z_axis.extend(t.z)])
    }
}

/// Buffers of what relight rays meet behind bodies.
pub(super) struct Occlusion {
    params: SrpOccludeParams,
    shapes_uniform: BufferId,
    mesh_uniforms: Vec<BufferId>,
    rays: BufferId,
    distances: BufferId,
    occluders: BufferId,
    /// Written in turns.
    seen: [BufferId; 2],
    current: Option<BufferId>,
    room: u32,
}

impl Occlusion {
    pub(super) fn new(exec: &mut dyn Executor, bake: &SrpBake, packed: &Packed, room: u32) -> Result<Self, ExecError> {
        let params = SrpOccludeParams {
            probe_count: packed.layout.probes,
            ray_count: packed.probes.ray_count,
            slice_rays: packed.layout.slice_rays,
            entry_count: packed.hits.len() as u32,
            ..SrpOccludeParams::zeroed()
        };
        let rays: Vec<Vec4> = bake.probes.iter().chain(&bake.ray_directions).map(|v| v.extend(0.0)).collect();
        let uniforms: Result<Vec<_>, ExecError> =
            (0..room).map(|_| exec.upload_one("srp occluder parameters", &params)).collect();
        let seen = |exec: &mut dyn Executor| exec.zeroed_slice::<u32>("srp occluded hits", packed.hits.len());
        Ok(Self {
            params,
            shapes_uniform: exec.upload_one("srp occluder parameters", &params)?,
            mesh_uniforms: uniforms?,
            rays: exec.upload_slice("srp rays", &rays)?,
            distances: exec.upload_slice("srp ray distances", &distances(bake, packed))?,
            occluders: exec.zeroed_slice::<SrpOccluder>("srp occluders", room as usize)?,
            seen: [seen(exec)?, seen(exec)?],
            current: None,
            room,
        })
    }

    /// Slots that rays see behind the bodies; nothing where there are none.
    pub(super) fn seen(&self) -> Option<BufferId> {
        self.current
    }

    /// Tests every ray against the bodies. `first_slot`: that of the first body's light.
    pub(super) fn update(
        &mut self,
        exec: &mut dyn Executor,
        hits: BufferId,
        first_slot: u32,
        occluders: &[Occluder<'_>],
    ) -> Result<(), ExecError> {
        debug_assert!(occluders.len() <= self.room as usize, "checked with their light");
        self.current = None;
        let placed = || occluders.iter().zip(first_slot..).filter_map(|(o, slot)| Some((o, slot, o.rows()?)));
        let mut shapes = Vec::new();
        for (occluder, slot, local_from_world) in placed() {
            let kind = match occluder.shape {
                Shape::Sphere => SRP_SPHERE,
                Shape::Cube => SRP_CUBE,
                Shape::Mesh(_) => continue,
            };
            shapes.push(SrpOccluder { local_from_world, kind, slot, _pad0: 0, _pad1: 0 });
        }
        let mut turn = 0;
        if !shapes.is_empty() {
            let params = SrpOccludeParams { occluder_count: shapes.len() as u32, ..self.params };
            exec.write(self.shapes_uniform, bytemuck::bytes_of(&params))?;
            exec.write(self.occluders, bytemuck::cast_slice(&shapes))?;
            let out = self.seen[turn];
            let buffers = [self.shapes_uniform, hits, self.distances, self.rays, self.occluders, out];
            exec.run(&srp_occlude::KERNEL, &buffers)?;
            self.current = Some(out);
            turn = 1;
        }
        for ((occluder, slot, local_from_world), &uniform) in placed().zip(&self.mesh_uniforms) {
            let Shape::Mesh(mesh) = occluder.shape else { continue };
            let params = SrpOccludeParams { local_from_world, slot, ..self.params };
            exec.write(uniform, bytemuck::bytes_of(&params))?;
            let (from, out) = (self.current.unwrap_or(hits), self.seen[turn]);
            let [nodes, triangles, attributes, surfaces] = mesh.trace_bindings();
            let buffers = [uniform, from, self.distances, self.rays, nodes, triangles, attributes, surfaces, out];
            exec.run(&srp_occlude_mesh::KERNEL, &buffers)?;
            self.current = Some(out);
            turn = 1 - turn;
        }
        Ok(())
    }
}

/// Distance (m) from each probe to what its relight rays meet, `f32::MAX` where they miss.
fn distances(bake: &SrpBake, packed: &Packed) -> Vec<f32> {
    let mut distances = vec![0.0; packed.hits.len()];
    let rays = bake.ray_directions.len();
    for (i, &hit) in bake.ray_hits.iter().enumerate() {
        let (probe, ray) = (i / rays, i % rays);
        distances[packed.layout.ray(probe as u32, ray as u32)] = match hit {
            RAY_MISS => f32::MAX,
            // What a ray that brings no light sees is all the same.
            RAY_INVALID => 0.0,
            receiver => bake.probes[probe].distance(bake.receivers[receiver as usize].position),
        };
    }
    distances
}
