//! A scene's voxel pyramid in an executor's buffers: what every method on voxels starts from.
//!
//! [`VoxelScene::build`] voxelizes and allocates; [`VoxelScene::inject`], [`VoxelScene::radiate`] and
//! [`VoxelScene::mipmap`] put light in and never allocate. Kernels: `interreflect_kernels::voxel`.

use super::{Input, MethodError, StageClock};
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::scene::device::SceneBuffers;
use glam::{UVec3, UVec4, Vec3, Vec4};
use interreflect_kernels::voxel::{cells, facet, grid, light, mark, mip, scan};
use interreflect_shared::voxel::{
    AREA_SCALE, FACET_KINDS, FACET_WORDS, SCAN_RADIX, ScanParams, VoxelFacet, VoxelParams,
};
use serde_json::json;

/// Largest storage buffer that every device allows: WebGPU's default limit.
const MAX_BINDING_BYTES: u64 = 128 << 20;
/// Voxels from the scene's bounds to the grid's side. Half a voxel more than one, so that an outer wall along the longest
/// side lies in the middle of its voxels, not between two.
const PADDING: f32 = 1.5;
/// Factor between two tries of the fixed-point scale.
const SCALE_STEP: f32 = 1.0 / 16.0;
/// Tries: 2¹⁶ times the default area per voxel.
const SCALE_TRIES: u32 = 5;

/// A grid of cubic voxels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct VoxelGrid {
    /// Smallest corner (m).
    pub origin: Vec3,
    /// Side of a voxel (m).
    pub voxel_size: f32,
    /// Voxels along each axis.
    pub dims: UVec3,
}

impl VoxelGrid {
    /// The grid around a box whose longest side is `resolution` voxels, padding of 1.5 voxels included.
    pub fn around((low, high): (Vec3, Vec3), resolution: u32) -> Self {
        let extent = high - low;
        let voxel_size = extent.max_element().max(f32::MIN_POSITIVE.sqrt()) / (resolution as f32 - 2.0 * PADDING);
        let needed = extent / voxel_size + 2.0 * PADDING;
        // A box as long as the longest side must not get one more by rounding.
        let dims = (needed - 1e-3).ceil().as_uvec3();
        Self { origin: low - PADDING * voxel_size, voxel_size, dims: dims.min(UVec3::splat(resolution)) }
    }
}

/// What a pyramid is made for.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct VoxelOptions {
    /// Method, for errors.
    pub method: &'static str,
    /// Six directions per voxel of the coarser levels instead of one.
    pub anisotropic: bool,
    /// Bytes that all buffers together may take.
    pub limit_bytes: u64,
    /// Largest component of any emitted radiance.
    pub emission_max: f32,
}

/// A pyramid and its buffers.
pub struct VoxelScene {
    /// Uniform of passes over everything.
    pub params: VoxelParams,
    /// Bits and ranks.
    pub cells: BufferId,
    /// Six words per cell of level 0.
    pub facet_bits: BufferId,
    /// Facets.
    pub facets: BufferId,
    /// Direct irradiance of both sides of every facet.
    pub direct: BufferId,
    /// Bounced irradiance of both sides of every facet; zero until a cone pass writes it.
    pub bounced: BufferId,
    /// Radiance of both sides of every facet.
    pub radiance: BufferId,
    /// Values of the odd levels.
    pub odd: BufferId,
    /// Values of the even levels.
    pub even: BufferId,
    /// Bytes of all buffers together while they are made: what is only needed for that is given back.
    pub memory_bytes: u64,
    /// Occupied voxels of level 0.
    pub voxel_count: u32,
    uniform: BufferId,
    odd_children: BufferId,
    even_children: BufferId,
    /// Per level from 1 on: its pass.
    level_passes: Vec<BufferId>,
}

/// Occupancy on the way to a pyramid.
struct Occupancy {
    tile_first: BufferId,
    facet_bits: BufferId,
    cells: BufferId,
    odd_records: u32,
    even_records: u32,
    voxel_count: u32,
}

impl VoxelScene {
    /// Voxelizes a scene's triangles.
    ///
    /// # Errors
    /// [`MethodError::TooLarge`] before a buffer is made that breaks a limit; what the executor returns.
    pub fn build(
        exec: &mut dyn Executor,
        scene: &SceneBuffers,
        grid: &VoxelGrid,
        options: &VoxelOptions,
        clock: &mut StageClock,
    ) -> Result<Self, MethodError> {
        let mut params = grid::pyramid(grid.origin, grid.voxel_size, grid.dims);
        params.triangle_count = scene.triangle_count;
        params.direction_count = if options.anisotropic { 6 } else { 1 };
        params.emission_scale = if options.emission_max > 0.0 { options.emission_max } else { 1.0 };
        let cell_count = u64::from(grid::cell_count(&params));
        check(options, &[("cells", 8 * cell_count), ("facet bits", 24 * u64::from(params.levels[0].w))])?;

        let occupancy = Occupancy::build(exec, scene, &mut params, clock)?;
        let (facets, odd, even) =
            (u64::from(params.facet_count), u64::from(occupancy.odd_records), u64::from(occupancy.even_records));
        let value_bytes = 16 * u64::from(params.direction_count);
        let memory_bytes = check(
            options,
            &[
                ("cells", 8 * cell_count),
                ("facet bits", 24 * u64::from(params.levels[0].w)),
                ("facets", 64 * facets),
                ("facet sums", 4 * u64::from(FACET_WORDS) * facets),
                ("direct irradiance", 32 * facets),
                ("bounced irradiance", 32 * facets),
                ("radiance", 32 * facets),
                ("odd levels", odd * value_bytes),
                ("even levels", even * value_bytes),
                ("children", 4 * (odd + even)),
            ],
        )?;
        let facets = make_facets(exec, scene, &mut params, &occupancy, options, clock)?;
        exec.free(occupancy.tile_first);
        Self::allocate(exec, params, &occupancy, facets, memory_bytes, clock)
    }

    fn allocate(
        exec: &mut dyn Executor,
        params: VoxelParams,
        occupancy: &Occupancy,
        facets: BufferId,
        memory_bytes: u64,
        clock: &mut StageClock,
    ) -> Result<Self, MethodError> {
        let sides = 2 * params.facet_count as usize;
        let directions = params.direction_count as usize;
        let (odd_records, even_records) = (occupancy.odd_records as usize, occupancy.even_records as usize);
        let odd_children = exec.zeroed_slice::<u32>("voxel odd children", odd_records)?;
        let even_children = exec.zeroed_slice::<u32>("voxel even children", even_records)?;
        clock.stage(exec, "voxel children", |exec| {
            once(
                exec,
                &cells::voxel_children::KERNEL,
                &VoxelParams { level: 1, ..params },
                &[occupancy.cells, odd_children],
            )?;
            once(
                exec,
                &cells::voxel_children::KERNEL,
                &VoxelParams { level: 2, ..params },
                &[occupancy.cells, even_children],
            )
        })?;
        let level_passes = record_passes(exec, &params, occupancy)?;
        Ok(Self {
            params,
            cells: occupancy.cells,
            facet_bits: occupancy.facet_bits,
            facets,
            direct: exec.zeroed_slice::<Vec4>("voxel direct irradiance", sides)?,
            bounced: exec.zeroed_slice::<Vec4>("voxel bounced irradiance", sides)?,
            radiance: exec.zeroed_slice::<Vec4>("voxel radiance", sides)?,
            odd: exec.zeroed_slice::<Vec4>("voxel odd levels", odd_records * directions)?,
            even: exec.zeroed_slice::<Vec4>("voxel even levels", even_records * directions)?,
            memory_bytes,
            voxel_count: occupancy.voxel_count,
            uniform: exec.upload_one("voxel parameters", &params)?,
            odd_children,
            even_children,
            level_passes,
        })
    }

    /// Computes the direct irradiance of every facet by shadow rays, and forgets bounced light.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn inject(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        light_samples: u32,
        environment_samples: u32,
    ) -> Result<(), ExecError> {
        let b = input.buffers;
        let environment = input.scene.environment;
        let environment_samples = if environment == Vec3::ZERO { 0 } else { environment_samples };
        self.params.environment = environment.extend(0.0);
        self.params.bounce_gain = Vec4::ONE;
        self.params.light = UVec4::new(b.light_count, light_samples, environment_samples, input.seed);
        exec.write(self.uniform, bytemuck::bytes_of(&self.params))?;
        let buffers =
            [self.uniform, b.nodes, b.triangles, b.attributes, b.surfaces, b.lights, self.facets, self.direct];
        exec.run(&light::voxel_inject::KERNEL, &buffers)?;
        exec.clear(self.bounced)
    }

    /// Sets the factor per channel on bounced irradiance.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn set_bounce_gain(&mut self, exec: &mut dyn Executor, gain: Vec3) -> Result<(), ExecError> {
        self.params.bounce_gain = gain.extend(0.0);
        exec.write(self.uniform, bytemuck::bytes_of(&self.params))
    }

    /// Turns direct and bounced irradiance into the facets' radiance.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn radiate(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        exec.run(&light::voxel_radiate::KERNEL, &[self.uniform, self.facets, self.direct, self.bounced, self.radiance])
    }

    /// Makes the coarser levels from the facets' radiance.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn mipmap(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        let (base, level) = if self.params.direction_count == 1 {
            (&mip::voxel_mip_base_isotropic::KERNEL, &mip::voxel_mip_isotropic::KERNEL)
        } else {
            (&mip::voxel_mip_base::KERNEL, &mip::voxel_mip::KERNEL)
        };
        for (k, &pass) in self.level_passes.iter().enumerate() {
            if k == 0 {
                let buffers =
                    [pass, self.cells, self.facet_bits, self.facets, self.radiance, self.odd_children, self.odd];
                exec.run(base, &buffers)?;
            } else if k % 2 == 0 {
                exec.run(level, &[pass, self.cells, self.odd_children, self.even, self.odd])?;
            } else {
                exec.run(level, &[pass, self.cells, self.even_children, self.odd, self.even])?;
            }
        }
        Ok(())
    }

    /// What was decided, for a report.
    pub fn needs(&self) -> serde_json::Value {
        let d = self.params.dims_levels;
        json!({
            "dims": [d.x, d.y, d.z],
            "levels": d.w,
            "voxel_size_m": self.params.origin_size.w,
            "occupied_voxels": self.voxel_count,
            "facets": self.params.facet_count,
            "triangle_tiles": self.params.tile_count,
            "peak_memory_bytes": self.memory_bytes,
        })
    }
}

impl Occupancy {
    fn build(
        exec: &mut dyn Executor,
        scene: &SceneBuffers,
        params: &mut VoxelParams,
        clock: &mut StageClock,
    ) -> Result<Self, MethodError> {
        let tile_counts = exec.zeroed_slice::<u32>("voxel tile counts", params.triangle_count as usize)?;
        let (tile_first, tile_count) = timed(exec, clock, "tiles", |exec| {
            once(exec, &mark::voxel_tiles::KERNEL, params, &[scene.triangles, tile_counts])?;
            exclusive_scan(exec, tile_counts, params.triangle_count, 0)
        })?;
        exec.free(tile_counts);
        params.tile_count = tile_count;

        let level0 = params.levels[0].w;
        let facet_bits = exec.zeroed_slice::<u32>("voxel facet bits", (level0 * FACET_KINDS) as usize)?;
        clock.stage(exec, "voxelize", |exec| {
            once(exec, &mark::voxel_mark::KERNEL, params, &[scene.triangles, tile_first, facet_bits])
        })?;
        timed(exec, clock, "scan", |exec| Self::rank(exec, params, tile_first, facet_bits))
    }

    fn rank(
        exec: &mut dyn Executor,
        params: &mut VoxelParams,
        tile_first: BufferId,
        facet_bits: BufferId,
    ) -> Result<Self, MethodError> {
        let level0 = params.levels[0].w;
        let (even_count, all) = (params.even_cells, grid::cell_count(params));
        let even_bits = exec.zeroed_slice::<u32>("voxel even bits", even_count as usize)?;
        let odd_bits = exec.zeroed_slice::<u32>("voxel odd bits", (all - even_count) as usize)?;
        once(exec, &cells::voxel_union::KERNEL, &VoxelParams { count: level0, ..*params }, &[facet_bits, even_bits])?;
        for level in 1..params.dims_levels.w {
            let table = params.levels[level as usize];
            let first = if level & 1 == 1 { table.z - even_count } else { table.z };
            let pass = VoxelParams { level, first, count: table.w, ..*params };
            let (finer, coarser) = if level & 1 == 1 { (even_bits, odd_bits) } else { (odd_bits, even_bits) };
            once(exec, &cells::voxel_coarsen::KERNEL, &pass, &[finer, coarser])?;
        }

        let facet_counts = exec.zeroed_slice::<u32>("voxel facet counts", level0 as usize)?;
        once(exec, &cells::voxel_facet_count::KERNEL, params, &[facet_bits, facet_counts])?;
        let (facet_ranks, facet_count) = exclusive_scan(exec, facet_counts, level0, 0)?;
        let voxel_count = count_bits(exec, params, even_bits, even_count, 0)?.1;
        let (even_ranks, even_and_level0) = count_bits(exec, params, even_bits, even_count, level0)?;
        let (odd_ranks, odd_records) = count_bits(exec, params, odd_bits, all - even_count, 0)?;
        params.facet_count = facet_count;

        let cells = exec.zeroed_slice::<u32>("voxel cells", 2 * all as usize)?;
        let parts = [even_bits, odd_bits, facet_ranks, even_ranks, odd_ranks];
        let [a, b, c, d, e] = parts;
        once(exec, &cells::voxel_cells::KERNEL, params, &[a, b, c, d, e, cells])?;
        for buffer in parts.into_iter().chain([facet_counts]) {
            exec.free(buffer);
        }
        Ok(Self {
            tile_first,
            facet_bits,
            cells,
            odd_records,
            even_records: even_and_level0,
            voxel_count: voxel_count - even_and_level0,
        })
    }
}

/// Ranks and number of the set bits of the cells from `first` on.
fn count_bits(
    exec: &mut dyn Executor,
    params: &VoxelParams,
    bits: BufferId,
    cell_count: u32,
    first: u32,
) -> Result<(BufferId, u32), MethodError> {
    let counts = exec.zeroed_slice::<u32>("voxel counts", cell_count as usize)?;
    once(exec, &cells::voxel_popcount::KERNEL, &VoxelParams { first, ..*params }, &[bits, counts])?;
    let result = exclusive_scan(exec, counts, cell_count, 0)?;
    exec.free(counts);
    Ok(result)
}

/// Accumulates and resolves facets; repeats with a coarser fixed-point scale where an area does not fit.
fn make_facets(
    exec: &mut dyn Executor,
    scene: &SceneBuffers,
    params: &mut VoxelParams,
    occupancy: &Occupancy,
    options: &VoxelOptions,
    clock: &mut StageClock,
) -> Result<BufferId, MethodError> {
    let words = params.facet_count as usize * FACET_WORDS as usize + 1;
    let sums = exec.zeroed_slice::<u32>("voxel sums", words)?;
    let mut fits = false;
    for k in 0..SCALE_TRIES {
        params.area_scale = AREA_SCALE * SCALE_STEP.powi(k as i32);
        let p = &*params;
        clock.stage(exec, "accumulate", |exec| {
            exec.clear(sums)?;
            once(
                exec,
                &facet::voxel_accumulate::KERNEL,
                p,
                &[
                    scene.triangles,
                    scene.attributes,
                    scene.surfaces,
                    occupancy.tile_first,
                    occupancy.cells,
                    occupancy.facet_bits,
                    sums,
                ],
            )
        })?;
        fits = exec.read_slice::<u32>(sums)?[words - 1] == 0;
        if fits {
            break;
        }
    }
    if !fits {
        return Err(MethodError::TooLarge {
            method: options.method,
            needed_bytes: 8 * words as u64,
            limit_bytes: 4 * words as u64,
            hint: "one voxel holds millions of times its own area in surfaces: take a higher resolution".into(),
        });
    }
    let facets = exec.zeroed_slice::<VoxelFacet>("voxel facets", params.facet_count as usize)?;
    clock.stage(exec, "resolve", |exec| {
        once(exec, &facet::voxel_resolve::KERNEL, params, &[occupancy.cells, occupancy.facet_bits, sums, facets])
    })?;
    exec.free(sums);
    Ok(facets)
}

/// The uniform of each level's mipmap pass, from level 1 on.
fn record_passes(
    exec: &mut dyn Executor,
    params: &VoxelParams,
    occupancy: &Occupancy,
) -> Result<Vec<BufferId>, MethodError> {
    let words = exec.read_slice::<u32>(occupancy.cells)?;
    let rank = |level: u32| words[2 * params.levels[level as usize].z as usize + 1];
    (1..params.dims_levels.w)
        .map(|level| {
            let all = if level & 1 == 1 { occupancy.odd_records } else { occupancy.even_records };
            let end = if level + 2 < params.dims_levels.w { rank(level + 2) } else { all };
            let first = rank(level);
            let pass = VoxelParams { level, first, count: end - first, ..*params };
            Ok(exec.upload_one("voxel level parameters", &pass)?)
        })
        .collect()
}

/// Runs a kernel with a uniform of its own.
fn once(
    exec: &mut dyn Executor,
    kernel: &'static interreflect_kernels::kernel::Kernel,
    params: &VoxelParams,
    buffers: &[BufferId],
) -> Result<(), MethodError> {
    let uniform = exec.upload_one("voxel pass", params)?;
    let all: Vec<BufferId> = [uniform].into_iter().chain(buffers.iter().copied()).collect();
    exec.run(kernel, &all)?;
    exec.free(uniform);
    Ok(())
}

/// A stage that gives a result.
fn timed<T>(
    exec: &mut dyn Executor,
    clock: &mut StageClock,
    name: &str,
    work: impl FnOnce(&mut dyn Executor) -> Result<T, MethodError>,
) -> Result<T, MethodError> {
    let mut result = None;
    clock.stage(exec, name, |exec| {
        result = Some(work(exec)?);
        Ok::<(), MethodError>(())
    })?;
    Ok(result.expect("a stage that succeeded has run"))
}

/// Exclusive prefix sum of `count` words (those before `first` count as zero) and their total.
///
/// # Errors
/// What the executor returns.
pub fn exclusive_scan(
    exec: &mut dyn Executor,
    values: BufferId,
    count: u32,
    first: u32,
) -> Result<(BufferId, u32), MethodError> {
    // Sums of groups, of groups of groups, … up to one.
    let mut levels = vec![(values, count, exec.upload_one("scan", &ScanParams { count, first, _pad0: 0, _pad1: 0 })?)];
    loop {
        let &(finer, n, uniform) = levels.last().expect("never empty");
        let groups = n.div_ceil(SCAN_RADIX).max(1);
        let sums = exec.zeroed_slice::<u32>("scan sums", groups as usize)?;
        exec.run(&scan::scan_sum::KERNEL, &[uniform, finer, sums])?;
        let params = ScanParams { count: groups, first: 0, _pad0: 0, _pad1: 0 };
        levels.push((sums, groups, exec.upload_one("scan", &params)?));
        if groups == 1 {
            break;
        }
    }
    let total = exec.read_slice::<u32>(levels.last().expect("never empty").0)?[0];
    // Offsets back down: the topmost group starts at zero.
    let mut parents = exec.zeroed_slice::<u32>("scan offsets", 1)?;
    for &(finer, n, uniform) in levels[..levels.len() - 1].iter().rev() {
        let offsets = exec.zeroed_slice::<u32>("scan offsets", n as usize)?;
        exec.run(&scan::scan_prefix::KERNEL, &[uniform, finer, parents, offsets])?;
        exec.free(parents);
        parents = offsets;
    }
    for (k, &(buffer, _, uniform)) in levels.iter().enumerate() {
        exec.free(uniform);
        if k > 0 {
            exec.free(buffer);
        }
    }
    Ok((parents, total))
}

/// Sum of the buffers' sizes, if each fits a binding and all fit the limit.
fn check(options: &VoxelOptions, buffers: &[(&str, u64)]) -> Result<u64, MethodError> {
    let too_large = |needed_bytes, limit_bytes, hint: String| {
        Err(MethodError::TooLarge { method: options.method, needed_bytes, limit_bytes, hint })
    };
    for &(name, bytes) in buffers {
        if bytes > MAX_BINDING_BYTES {
            let hint = format!("{name} alone exceed what one binding of a device may hold; lower `resolution`");
            return too_large(bytes, MAX_BINDING_BYTES, hint);
        }
    }
    let total = buffers.iter().map(|b| b.1).sum();
    if total > options.limit_bytes {
        let hint = "lower `resolution`, set `mipmaps=isotropic`, or raise `memory_limit_mb`".to_string();
        return too_large(total, options.limit_bytes, hint);
    }
    Ok(total)
}
