//! Run time: schedules the kernels of `interreflect_kernels::srp` over a bake's buffers.
//!
//! Every pass runs only when something that it reads has changed. [`SrpRuntime::update`] makes as many bounces as are
//! asked for, starting from the light that was there; a scene in which nothing moves costs nothing after that.

use super::feedback::Feedback;
use super::model::{Blend, NO_RECEIVER, SrpBake};
use super::occluders::Occlusion;
use super::packed::{Packed, SLICE_RAYS};
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::methods::{MethodError, StageClock};
use crate::scene::device::SceneBuffers;
use bytemuck::Zeroable;
use glam::{Vec3, Vec4};
use interreflect_kernels::srp::cluster::srp_cluster;
use interreflect_kernels::srp::gather::srp_gather;
use interreflect_kernels::srp::glossy::srp_glossy;
use interreflect_kernels::srp::light_basis::srp_light_basis;
use interreflect_kernels::srp::normals::{srp_normal_mapped, srp_receiver_irradiance};
use interreflect_kernels::srp::probe_light::srp_probe_light;
use interreflect_kernels::srp::probe_sum::srp_probe_sum;
use interreflect_kernels::srp::project::srp_project;
use interreflect_kernels::srp::reconstruct::{srp_reconstruct, srp_reconstruct_directional};
use interreflect_kernels::srp::relight::srp_relight;
use interreflect_kernels::srp::resolve::{srp_atlas, srp_resolve};
use interreflect_kernels::trace::direct::trace_direct;
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use interreflect_shared::srp::{
    SRP_LANES, SrpBasisParams, SrpProbeLightParams, SrpProbeParams, SrpRelightParams, SrpResolveParams, SrpSurface,
    SrpTransportParams,
};
use interreflect_shared::trace::DirectParams;
use serde_json::json;

/// Largest binding that every device has: WebGPU's default limit.
pub const BINDING_BYTES: usize = 128 << 20;
/// Special slots before those of occluders: black, environment.
pub(super) const FIRST_SPECIAL: u32 = 2;

/// Sizes that do not come from the bake.
#[derive(Clone, Copy, Debug)]
pub struct RuntimeOptions {
    /// Rays of a slice of the projection ([`interreflect_shared::srp::SrpProbeParams::slice_rays`]).
    pub slice_rays: u32,
    /// Largest binding in bytes; matrices beyond it are split.
    pub binding_bytes: usize,
    /// Dynamic occluders that there is room for; 0 saves their buffers, three of the size of the relight rays'. Default 0.
    pub occluder_slots: u32,
    /// Whether the receivers' baked emission is lit by probes. False where emitters count as direct light.
    pub emission: bool,
}

impl Default for RuntimeOptions {
    fn default() -> Self {
        Self { slice_rays: SLICE_RAYS, binding_bytes: BINDING_BYTES, occluder_slots: 0, emission: false }
    }
}

/// How often each part ran, to see that nothing runs for nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Runs {
    /// Direct light at the receivers.
    pub direct: u32,
    /// What relight rays meet behind dynamic occluders.
    pub occlusions: u32,
    /// Bounces: all passes from relighting to reconstruction.
    pub bounces: u32,
}

/// Words of one dispatch with its uniform.
struct PartBuffers {
    uniform: BufferId,
    words: BufferId,
}

/// Fewest bounces with a tail: three to see what the loop hands on, and one that spreads it.
pub const TAIL_FROM: u32 = 4;
/// Largest part of a change that a bounce is believed to hand on.
const MOST_HANDED_ON: f64 = 0.999;

/// A bake on an executor, with light.
pub struct SrpRuntime {
    slot_of_receiver: Vec<u32>,
    receiver_of_slot: Vec<u32>,
    pub(super) slot_count: u32,
    special_count: u32,
    rows: u32,
    relight_params: SrpRelightParams,
    texel_count: u32,
    relight_uniform: BufferId,
    probe_uniform: BufferId,
    slices: Vec<BufferId>,
    basis_uniform: BufferId,
    atlas_uniform: BufferId,
    surfels: BufferId,
    direct_uniform: BufferId,
    direct: BufferId,
    surfaces: BufferId,
    special: BufferId,
    radiance: BufferId,
    hits: BufferId,
    occlusion: Option<Occlusion>,
    probe_light: SrpProbeLightParams,
    probe_positions: BufferId,
    table: BufferId,
    light: BufferId,
    probe_partial: BufferId,
    coefs: BufferId,
    pairs: BufferId,
    blocks: BufferId,
    projection: Vec<PartBuffers>,
    rank_partial: BufferId,
    sources: BufferId,
    basis: BufferId,
    receiver_blocks: BufferId,
    reconstruction: Vec<PartBuffers>,
    normals: BufferId,
    radiance4: BufferId,
    irradiance: BufferId,
    atlas_map: BufferId,
    dilation: BufferId,
    atlas: BufferId,
    /// What was last measured about the loop of bounces.
    feedback: Option<Feedback>,
    /// Bounces that the last change still asks for.
    pending: u32,
    /// Bounces that a change asks for.
    bounces: u32,
    runs: Runs,
}

impl SrpRuntime {
    /// Uploads a bake; light is black.
    ///
    /// # Errors
    /// Buffers that the executor cannot hold.
    pub fn new(exec: &mut dyn Executor, bake: &SrpBake, options: &RuntimeOptions) -> Result<Self, MethodError> {
        let packed = Packed::new(bake, options.slice_rays, options.binding_bytes);
        let slot_count = packed.slot_count();
        let slots = slot_count as usize;
        let layout = packed.layout;
        let special_count = FIRST_SPECIAL + options.occluder_slots;
        let pair_count = packed.rank_pairs.len() as u32;
        let rows = bake.rows_per_receiver;
        let relight = SrpRelightParams { slot_count, special_count, feedback: 1.0, _pad0: 0 };
        let probe_light = SrpProbeLightParams {
            probe_count: layout.probes,
            coefficient_count: layout.coefs,
            coef_plane: layout.coef_plane(),
            radius: bake.radius,
            ..SrpProbeLightParams::zeroed()
        };
        let probe_positions: Vec<Vec4> = bake.probes.iter().map(|p| p.extend(0.0)).collect();
        let basis = SrpBasisParams {
            count: packed.sources.len() as u32,
            pair_count,
            coef_plane: layout.coef_plane(),
            _pad0: 0,
        };
        // A processor keeps the light of one slice in its cache between gathering and projection; a device wants as many
        // invocations as there are.
        let together = if exec.device().hardware_gpu { layout.slices } else { 1 }.max(1);
        let slices: Vec<_> = (0..layout.slices.div_ceil(together))
            .map(|k| {
                let first_slice = k * together;
                let slice_count = together.min(layout.slices - first_slice);
                let params = SrpProbeParams { first_slice, slice_count, ..packed.probes };
                exec.upload_one("srp slice parameters", &params)
            })
            .collect();
        let texel_count = packed.atlas.len() as u32;
        let resolve = SrpResolveParams { count: texel_count, slot_count, _pad0: 0, _pad1: 0 };
        let parts = |exec: &mut dyn Executor, name: &str, parts: &[super::packed::Part], total_rows: u32| {
            parts.iter().map(|part| part_buffers(exec, name, part, total_rows, layout.coef_plane())).collect()
        };
        let projection: Result<Vec<_>, ExecError> = parts(exec, "srp projection", &packed.projection, pair_count);
        let block_count = packed.receiver_blocks.len() as u32;
        let reconstruction: Result<Vec<_>, ExecError> =
            parts(exec, "srp reconstruction", &packed.reconstruction, block_count);
        Ok(Self {
            slot_count,
            special_count,
            rows,
            relight_params: relight,
            texel_count,
            relight_uniform: exec.upload_one("srp relight parameters", &relight)?,
            probe_uniform: exec.upload_one("srp probe parameters", &packed.probes)?,
            basis_uniform: exec.upload_one("srp basis parameters", &basis)?,
            atlas_uniform: exec.upload_one("srp atlas parameters", &resolve)?,
            surfels: exec.upload_slice("srp surfels", &surfels(bake, &packed))?,
            direct_uniform: exec.zeroed_slice::<DirectParams>("srp direct parameters", 1)?,
            direct: exec.zeroed_slice::<Vec4>("srp direct", slots)?,
            surfaces: exec.upload_slice("srp surfaces", &surfaces(bake, &packed, options.emission))?,
            special: exec.zeroed_slice::<Vec4>("srp special", special_count as usize)?,
            radiance: exec.zeroed_slice::<Vec4>("srp radiance", slots + special_count as usize)?,
            hits: exec.upload_slice("srp ray hits", &packed.hits)?,
            occlusion: match options.occluder_slots {
                0 => None,
                slots => Some(Occlusion::new(exec, bake, &packed, slots)?),
            },
            probe_light,
            probe_positions: exec.upload_slice("srp probes", &probe_positions)?,
            table: exec.upload_slice("srp basis functions", &packed.table)?,
            light: exec.zeroed_slice::<f32>("srp ray light", 3 * (together * layout.slice_plane()) as usize)?,
            slices: slices.into_iter().collect::<Result<_, _>>()?,
            probe_partial: exec
                .zeroed_slice::<f32>("srp partial coefficients", (24 * layout.partial_rows() * SRP_LANES) as usize)?,
            coefs: exec.zeroed_slice::<f32>("srp coefficients", 3 * layout.coef_plane() as usize)?,
            pairs: exec.upload_slice("srp rank pairs", &packed.rank_pairs)?,
            blocks: exec.upload_slice("srp column blocks", &packed.column_blocks)?,
            projection: projection?,
            rank_partial: exec.zeroed_slice::<f32>("srp partial bases", (6 * pair_count * SRP_LANES) as usize)?,
            sources: exec.upload_slice("srp basis sources", &packed.sources)?,
            basis: exec.zeroed_slice::<Vec4>("srp light bases", packed.sources.len())?,
            receiver_blocks: exec.upload_slice("srp receiver blocks", &packed.receiver_blocks)?,
            reconstruction: reconstruction?,
            normals: exec.upload_slice("srp normals", &normals(bake, &packed, rows))?,
            radiance4: exec.zeroed_slice::<f32>("srp order-1 radiance", if rows == 4 { 12 * slots } else { 0 })?,
            irradiance: exec.zeroed_slice::<f32>("srp irradiance", 3 * slots)?,
            atlas_map: exec.upload_slice("srp atlas map", &packed.atlas)?,
            dilation: exec.upload_slice("srp dilation", &packed.dilation)?,
            atlas: exec.zeroed_slice::<Vec4>("srp atlas", texel_count as usize)?,
            feedback: None,
            pending: 0,
            bounces: 1,
            runs: Runs::default(),
            slot_of_receiver: packed.slot_of_receiver,
            receiver_of_slot: packed.receiver_of_slot,
        })
    }

    /// Bounces after which light counts as settled; each change asks for so many. At least 1; default 1.
    pub fn set_bounces(&mut self, bounces: u32) {
        self.bounces = bounces.max(1);
        self.changed();
    }

    /// Forgets all light that has bounced: the next [`SrpRuntime::update`] makes exactly the asked number of bounces.
    ///
    /// # Errors
    /// The executor's.
    pub fn restart(&mut self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        exec.clear(self.irradiance)?;
        self.changed();
        Ok(())
    }

    fn changed(&mut self) {
        self.pending = self.bounces;
    }

    /// Direct light at every receiver, by shadow rays. Call when lights or geometry of `scene` changed.
    ///
    /// # Errors
    /// The executor's.
    pub fn light(
        &mut self,
        exec: &mut dyn Executor,
        scene: &SceneBuffers,
        sampling: &DirectParams,
    ) -> Result<(), ExecError> {
        let params = DirectParams { count: self.slot_count, light_count: scene.light_count, ..*sampling };
        exec.write(self.direct_uniform, bytemuck::bytes_of(&params))?;
        let [a, b, c, d] = scene.trace_bindings();
        exec.run(&trace_direct::KERNEL, &[self.direct_uniform, a, b, c, d, scene.lights, self.surfels, self.direct])?;
        self.runs.direct += 1;
        self.changed();
        Ok(())
    }

    /// Direct irradiance (W/m²) at every receiver from elsewhere, in the order of the bake's receivers.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] where the number of receivers is another.
    pub fn set_direct(&mut self, exec: &mut dyn Executor, direct: &[Vec3]) -> Result<(), ExecError> {
        let values = self.per_slot(direct, Vec4::ZERO, |v| v.extend(0.0))?;
        exec.write(self.direct, bytemuck::cast_slice(&values))?;
        self.changed();
        Ok(())
    }

    /// Reflectance and emitted radiance (W/(sr m²)) of every receiver: materials that change at run time.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] where the number of receivers is another.
    pub fn set_surfaces(&mut self, exec: &mut dyn Executor, surfaces: &[(Vec3, Vec3)]) -> Result<(), ExecError> {
        let values = self.per_slot(surfaces, SrpSurface::zeroed(), |&(albedo, emission)| surface(albedo, emission))?;
        exec.write(self.surfaces, bytemuck::cast_slice(&values))?;
        self.changed();
        Ok(())
    }

    /// Radiance (W/(sr m²)) that relight rays see beyond the scene, and that of dynamic occluders.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] for more occluders than there is room for.
    pub fn set_special(
        &mut self,
        exec: &mut dyn Executor,
        environment: Vec3,
        occluders: &[Vec3],
    ) -> Result<(), ExecError> {
        let mut values = vec![Vec4::ZERO, environment.extend(0.0)];
        values.extend(occluders.iter().map(|v| v.extend(0.0)));
        if values.len() > self.special_count as usize {
            let reason = format!("{} occluders, room for {}", occluders.len(), self.special_count - FIRST_SPECIAL);
            return Err(ExecError::buffer("srp special", reason));
        }
        exec.write(self.special, bytemuck::cast_slice(&values))?;
        self.changed();
        Ok(())
    }

    /// Moving bodies that block relight rays, each with the radiance (W/(sr m²)) that a blocked ray sees instead, and that of
    /// the environment as for [`SrpRuntime::set_special`]. Costs a test per ray and body now, and nothing per update.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] for more bodies than there is room for.
    pub fn set_occluders(
        &mut self,
        exec: &mut dyn Executor,
        environment: Vec3,
        occluders: &[super::occluders::Occluder<'_>],
    ) -> Result<(), ExecError> {
        let light: Vec<Vec3> = occluders.iter().map(|o| o.light).collect();
        self.set_special(exec, environment, &light)?;
        if let Some(occlusion) = &mut self.occlusion {
            occlusion.update(exec, self.hits, self.slot_count + FIRST_SPECIAL, occluders)?;
            self.runs.occlusions += 1;
        }
        Ok(())
    }

    fn per_slot<T, U: Copy>(&self, values: &[T], padding: U, of: impl Fn(&T) -> U) -> Result<Vec<U>, ExecError> {
        if values.len() != self.slot_of_receiver.len() {
            let reason = format!("{} values for {} receivers", values.len(), self.slot_of_receiver.len());
            return Err(ExecError::buffer("srp receivers", reason));
        }
        let slot = |&r: &u32| if r == NO_RECEIVER { padding } else { of(&values[r as usize]) };
        Ok(self.receiver_of_slot.iter().map(slot).collect())
    }

    /// Whether [`SrpRuntime::update`] would do anything.
    pub fn is_settled(&self) -> bool {
        self.pending == 0
    }

    /// Makes up to `most` of the bounces that the last changes ask for. Gives the number made: 0 where nothing changed.
    ///
    /// # Errors
    /// The executor's.
    pub fn update(&mut self, exec: &mut dyn Executor, most: u32, clock: &mut StageClock) -> Result<u32, MethodError> {
        let count = self.pending.min(most);
        for _ in 0..count {
            self.bounce(exec, clock)?;
        }
        self.pending -= count;
        Ok(count)
    }

    /// [`SrpRuntime::update`] after [`SrpRuntime::restart`], all of it, with what bounces beyond the asked number would add: what the
    /// last but one changed is taken to go on falling as it did, and the last spreads it. Gives, for each colour, the part of
    /// a change that the next bounce hands on; 0 for fewer than [`TAIL_FROM`] bounces.
    ///
    /// After many bounces what is missing is the loop's slowest mode (Aitken's extrapolation of it); where light has settled
    /// nothing changes any more, and nothing is added.
    ///
    /// # Errors
    /// The executor's.
    pub fn update_with_tail(
        &mut self,
        exec: &mut dyn Executor,
        clock: &mut StageClock,
    ) -> Result<[f64; 3], MethodError> {
        let count = self.pending;
        if count < TAIL_FROM {
            self.update(exec, count, clock)?;
            return Ok([0.0; 3]);
        }
        let mut after = |bounces: u32| -> Result<Vec<f32>, MethodError> {
            self.update(exec, bounces, clock)?;
            Ok(exec.read_slice(self.irradiance)?)
        };
        let [first, before, mut now] = [after(count - 3)?, after(1)?, after(1)?];
        let length = now.len() / 3;
        let mut handed_on = [0.0; 3];
        for (c, part) in handed_on.iter_mut().enumerate() {
            let colour = c * length..(c + 1) * length;
            let change = |a: &[f32], b: &[f32]| -> f64 {
                colour.clone().map(|i| (f64::from(b[i]) - f64::from(a[i])).abs()).sum()
            };
            let (last, this) = (change(&first, &before), change(&before, &now));
            *part = if last > 0.0 { (this / last).min(MOST_HANDED_ON) } else { 0.0 };
            let further = (*part / (1.0 - *part)) as f32;
            colour.for_each(|i| now[i] += (now[i] - before[i]) * further);
        }
        exec.write(self.irradiance, bytemuck::cast_slice(&now))?;
        self.update(exec, 1, clock)?;
        Ok(handed_on)
    }

    /// Bounces until one changes no receiver's irradiance by more than `change` of the mean, at most `most`. Gives the
    /// number made; light counts as settled then. Reads irradiance back after every bounce: for changes of light, not for
    /// every frame.
    ///
    /// # Errors
    /// The executor's.
    pub fn settle(
        &mut self,
        exec: &mut dyn Executor,
        most: u32,
        change: f32,
        clock: &mut StageClock,
    ) -> Result<u32, MethodError> {
        let mut before: Vec<f32> = exec.read_slice(self.irradiance)?;
        for bounce in 1..=most {
            self.bounce(exec, clock)?;
            let now: Vec<f32> = exec.read_slice(self.irradiance)?;
            let moved = now.iter().zip(&before).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            let mean =
                now.iter().map(|x| f64::from(x.abs())).sum::<f64>() / (3 * self.slot_of_receiver.len()).max(1) as f64;
            before = now;
            if f64::from(moved) <= f64::from(change) * mean {
                self.pending = 0;
                return Ok(bounce);
            }
        }
        self.pending = 0;
        Ok(most)
    }

    /// One bounce: all passes once, each a stage.
    pub(super) fn bounce(&mut self, exec: &mut dyn Executor, clock: &mut StageClock) -> Result<(), MethodError> {
        for (name, pass) in PASSES {
            clock.stage(exec, name, |exec| pass(self, exec))?;
        }
        self.runs.bounces += 1;
        Ok(())
    }

    fn relight(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        let buffers = [self.relight_uniform, self.direct, self.irradiance, self.surfaces, self.special, self.radiance];
        exec.run(&srp_relight::KERNEL, &buffers)
    }

    fn probe_relight(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        for &slice in &self.slices {
            self.gather(exec, slice)?;
            self.project(exec, slice)?;
        }
        self.sum(exec)
    }

    fn gather(&self, exec: &mut dyn Executor, slice: BufferId) -> Result<(), ExecError> {
        let hits = self.occlusion.as_ref().and_then(Occlusion::seen).unwrap_or(self.hits);
        exec.run(&srp_gather::KERNEL, &[slice, hits, self.radiance, self.light])
    }

    fn project(&self, exec: &mut dyn Executor, slice: BufferId) -> Result<(), ExecError> {
        exec.run(&srp_project::KERNEL, &[slice, self.table, self.light, self.probe_partial])
    }

    fn sum(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        exec.run(&srp_probe_sum::KERNEL, &[self.probe_uniform, self.probe_partial, self.coefs])
    }

    /// The gathering of probe relight alone, for benchmarks: the light of the last slices is left.
    ///
    /// # Errors
    /// The executor's.
    pub fn gather_alone(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        self.slices.iter().try_for_each(|&slice| self.gather(exec, slice))
    }

    /// The matrix product of probe relight alone, for benchmarks: with the light that is left, for all slices.
    ///
    /// # Errors
    /// The executor's.
    pub fn project_alone(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        self.slices.iter().try_for_each(|&slice| self.project(exec, slice))?;
        self.sum(exec)
    }

    fn cluster(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        for part in &self.projection {
            let buffers = [part.uniform, self.pairs, self.blocks, part.words, self.coefs, self.rank_partial];
            exec.run(&srp_cluster::KERNEL, &buffers)?;
        }
        let buffers = [self.basis_uniform, self.sources, self.rank_partial, self.coefs, self.basis];
        exec.run(&srp_light_basis::KERNEL, &buffers)
    }

    fn reconstruct(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        let (kernel, out) = if self.rows == 4 {
            (&srp_reconstruct_directional::KERNEL, self.radiance4)
        } else {
            (&srp_reconstruct::KERNEL, self.irradiance)
        };
        for part in &self.reconstruction {
            exec.run(kernel, &[part.uniform, self.receiver_blocks, part.words, self.basis, out])?;
        }
        if self.rows == 4 {
            let buffers = [self.atlas_uniform, self.normals, self.radiance4, self.irradiance];
            exec.run(&srp_receiver_irradiance::KERNEL, &buffers)?;
        }
        Ok(())
    }

    /// Irradiance as a lightmap with dilation: `Vec4` per texel, row by row, w = 1 where there is any.
    ///
    /// # Errors
    /// The executor's.
    pub fn atlas(&self, exec: &mut dyn Executor) -> Result<BufferId, ExecError> {
        if self.texel_count > 0 {
            let buffers = [self.atlas_uniform, self.atlas_map, self.dilation, self.irradiance, self.atlas];
            exec.run(&srp_atlas::KERNEL, &buffers)?;
        }
        Ok(self.atlas)
    }

    /// Buffers of points to read irradiance at; for [`SrpRuntime::resolve`].
    ///
    /// # Errors
    /// The executor's.
    pub fn points(&self, exec: &mut dyn Executor, blends: &[Blend]) -> Result<Points, ExecError> {
        let params = SrpResolveParams { count: blends.len() as u32, slot_count: self.slot_count, _pad0: 0, _pad1: 0 };
        let blends: Vec<_> = blends.iter().map(|b| super::packed::blend_of(b, &self.slot_of_receiver)).collect();
        Ok(Points {
            uniform: exec.upload_one("srp point parameters", &params)?,
            blends: exec.upload_slice("srp points", &blends)?,
        })
    }

    /// Other blends for as many points.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] for more points than there were.
    pub fn set_points(&self, exec: &mut dyn Executor, points: &Points, blends: &[Blend]) -> Result<(), ExecError> {
        let blends: Vec<_> = blends.iter().map(|b| super::packed::blend_of(b, &self.slot_of_receiver)).collect();
        exec.write(points.blends, bytemuck::cast_slice(&blends))
    }

    /// Irradiance (W/m²) at points, `Vec4` each.
    ///
    /// # Errors
    /// The executor's.
    pub fn resolve(&self, exec: &mut dyn Executor, points: &Points, out: BufferId) -> Result<(), ExecError> {
        exec.run(&srp_resolve::KERNEL, &[points.uniform, points.blends, self.irradiance, out])
    }

    /// Irradiance (W/m²) at points for the normals of their [`Surfel`]s, `Vec4` each. For bakes of four rows.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] for a bake of one row.
    pub fn normal_mapped(
        &self,
        exec: &mut dyn Executor,
        points: &Points,
        surfels: BufferId,
        out: BufferId,
    ) -> Result<(), ExecError> {
        self.needs_four_rows()?;
        exec.run(&srp_normal_mapped::KERNEL, &[points.uniform, points.blends, self.radiance4, surfels, out])
    }

    /// Glossy reflection (radiance, W/(sr m²)) at points towards their viewers, `Vec4` each. `gloss`:
    /// [`interreflect_shared::srp::SrpGloss`] per point. For bakes of four rows.
    ///
    /// # Errors
    /// The executor's; [`ExecError::Buffer`] for a bake of one row.
    pub fn glossy(
        &self,
        exec: &mut dyn Executor,
        points: &Points,
        surfels: BufferId,
        gloss: BufferId,
        out: BufferId,
    ) -> Result<(), ExecError> {
        self.needs_four_rows()?;
        exec.run(&srp_glossy::KERNEL, &[points.uniform, points.blends, self.radiance4, surfels, gloss, out])
    }

    /// Parameters of [`SrpRuntime::light_objects`] for a number of points.
    ///
    /// # Errors
    /// The executor's.
    pub fn object_points(&self, exec: &mut dyn Executor, count: u32) -> Result<BufferId, ExecError> {
        exec.upload_one("srp object parameters", &SrpProbeLightParams { count, ..self.probe_light })
    }

    /// Irradiance (W/m²) of the probes at points of dynamic objects ([`Surfel`] each), `Vec4` each. `params` from
    /// [`SrpRuntime::object_points`].
    ///
    /// # Errors
    /// The executor's.
    pub fn light_objects(
        &self,
        exec: &mut dyn Executor,
        params: BufferId,
        surfels: BufferId,
        out: BufferId,
    ) -> Result<(), ExecError> {
        exec.run(&srp_probe_light::KERNEL, &[params, self.probe_positions, self.coefs, surfels, out])
    }

    fn needs_four_rows(&self) -> Result<(), ExecError> {
        if self.rows != 4 {
            return Err(ExecError::buffer("srp order-1 radiance", "the bake holds one row per receiver".into()));
        }
        Ok(())
    }

    /// Irradiance (W/m²) at each receiver, in the order of the bake's receivers.
    ///
    /// # Errors
    /// The executor's.
    pub fn read_irradiance(&self, exec: &mut dyn Executor) -> Result<Vec<Vec3>, ExecError> {
        let planes: Vec<f32> = exec.read_slice(self.irradiance)?;
        let n = self.slot_count as usize;
        let at = |&slot: &u32| {
            let slot = slot as usize;
            Vec3::new(planes[slot], planes[n + slot], planes[2 * n + slot])
        };
        Ok(self.slot_of_receiver.iter().map(at).collect())
    }

    /// Irradiance at receivers in planes `[channel][slot]`, for kernels of other renderers.
    pub fn irradiance_buffer(&self) -> BufferId {
        self.irradiance
    }

    /// Probe coefficients λ in planes `[channel][probe][k]`.
    pub fn coefficients_buffer(&self) -> BufferId {
        self.coefs
    }

    /// Turns off all light but that which is fed back; gives what [`SrpRuntime::relit`] needs.
    pub(super) fn darken(&mut self, exec: &mut dyn Executor) -> Result<Saved, ExecError> {
        let saved = Saved {
            direct: exec.read(self.direct)?,
            special: exec.read(self.special)?,
            surfaces: exec.read(self.surfaces)?,
            irradiance: exec.read(self.irradiance)?,
            runs: self.runs,
        };
        let mut surfaces: Vec<SrpSurface> = bytemuck::pod_collect_to_vec(&saved.surfaces);
        surfaces.iter_mut().for_each(|s| s.emission = [0.0; 3]);
        exec.write(self.surfaces, bytemuck::cast_slice(&surfaces))?;
        exec.clear(self.direct)?;
        exec.clear(self.special)?;
        Ok(saved)
    }

    /// Undoes [`SrpRuntime::darken`]. What lies between light and irradiance is computed anew by the next bounce.
    pub(super) fn relit(&mut self, exec: &mut dyn Executor, saved: &Saved) -> Result<(), ExecError> {
        exec.write(self.direct, &saved.direct)?;
        exec.write(self.special, &saved.special)?;
        exec.write(self.surfaces, &saved.surfaces)?;
        exec.write(self.irradiance, &saved.irradiance)?;
        self.runs = saved.runs;
        // Probe coefficients and order-1 radiance are those of the measurement: one bounce makes them right.
        self.pending = self.pending.max(1);
        Ok(())
    }

    /// Factor on the light that is fed back.
    pub(super) fn set_damping(&mut self, exec: &mut dyn Executor, damping: f32) -> Result<(), ExecError> {
        self.relight_params.feedback = damping;
        exec.write(self.relight_uniform, bytemuck::bytes_of(&self.relight_params))?;
        self.changed();
        Ok(())
    }

    /// Remembers a measurement for reports.
    pub(super) fn note_feedback(&mut self, feedback: Feedback) {
        self.feedback = Some(feedback);
    }

    /// Bytes of the projection and of the reconstruction matrices, which every bounce reads once.
    pub fn matrix_bytes(&self, exec: &dyn Executor) -> (u64, u64) {
        let sum = |parts: &[PartBuffers]| parts.iter().map(|part| exec.size_bytes(part.words)).sum();
        (sum(&self.projection), sum(&self.reconstruction))
    }

    /// How often each part ran.
    pub fn runs(&self) -> Runs {
        self.runs
    }

    /// Sizes and what ran, for reports.
    pub fn needs(&self) -> serde_json::Value {
        json!({
            "slots": self.slot_count,
            "rows_per_receiver": self.rows,
            "projection_dispatches": self.projection.len(),
            "reconstruction_dispatches": self.reconstruction.len(),
            "direct_runs": self.runs.direct,
            "bounce_runs": self.runs.bounces,
            "occlusion_runs": self.runs.occlusions,
            "feedback": self.feedback,
            "settled": self.is_settled(),
        })
    }
}

/// One pass of a bounce.
pub type Pass = fn(&SrpRuntime, &mut dyn Executor) -> Result<(), ExecError>;
/// Stages of a bounce in order, with the names that reports use.
pub const PASSES: [(&str, Pass); 4] = [
    ("scene relight", SrpRuntime::relight),
    ("probe relight", SrpRuntime::probe_relight),
    ("cluster projection", SrpRuntime::cluster),
    ("reconstruction", SrpRuntime::reconstruct),
];

/// Light that was turned off.
pub(super) struct Saved {
    direct: Vec<u8>,
    special: Vec<u8>,
    surfaces: Vec<u8>,
    irradiance: Vec<u8>,
    runs: Runs,
}

/// Points to read irradiance at.
pub struct Points {
    uniform: BufferId,
    blends: BufferId,
}

fn part_buffers(
    exec: &mut dyn Executor,
    name: &str,
    part: &super::packed::Part,
    total_rows: u32,
    coef_plane: u32,
) -> Result<PartBuffers, ExecError> {
    let params = SrpTransportParams {
        first_row: part.rows.start,
        row_count: part.rows.len() as u32,
        total_rows,
        coef_plane,
        ..SrpTransportParams::zeroed()
    };
    Ok(PartBuffers {
        uniform: exec.upload_one("srp transport parameters", &params)?,
        words: exec.upload_slice(name, &part.words)?,
    })
}

fn surface(albedo: Vec3, emission: Vec3) -> SrpSurface {
    SrpSurface { albedo: albedo.to_array(), _pad0: 0, emission: emission.to_array(), _pad1: 0 }
}

fn surfaces(bake: &SrpBake, packed: &Packed, emission: bool) -> Vec<SrpSurface> {
    let of = |&r: &u32| match bake.receivers.get(r as usize) {
        Some(receiver) => surface(receiver.albedo, if emission { receiver.emission } else { Vec3::ZERO }),
        None => SrpSurface::zeroed(),
    };
    packed.receiver_of_slot.iter().map(of).collect()
}

/// Receivers as the direct-light kernel takes them; padding shows no surface.
fn surfels(bake: &SrpBake, packed: &Packed) -> Vec<Surfel> {
    let of = |&r: &u32| match bake.receivers.get(r as usize) {
        Some(receiver) => receiver.surfel(),
        None => Surfel { triangle: NO_SURFACE, ..Surfel::zeroed() },
    };
    packed.receiver_of_slot.iter().map(of).collect()
}

/// Receivers' normals in planes, where they are needed.
fn normals(bake: &SrpBake, packed: &Packed, rows: u32) -> Vec<f32> {
    if rows != 4 {
        return Vec::new();
    }
    let axis = |axis: usize| {
        let of = move |&r: &u32| bake.receivers.get(r as usize).map_or(0.0, |receiver| receiver.normal[axis]);
        packed.receiver_of_slot.iter().map(of)
    };
    (0..3).flat_map(axis).collect()
}
