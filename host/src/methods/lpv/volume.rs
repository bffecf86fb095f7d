//! One grid of light with its coarser levels: buffers, passes, and the ledger of flux.

use super::super::MethodError;
use super::Options;
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use glam::{DVec3, IVec4, UVec3, UVec4, Vec3, Vec4};
use interreflect_kernels::lpv::lobe::{ACROSS, ALONG};
use interreflect_kernels::lpv::{block, bounce, gather, inject, ledger, levels, propagate};
use interreflect_shared::lpv::{
    FLUX_LIMIT, FLUX_VALUES, LEDGER_VALUES, LpvLayout, LpvParams, OPACITY_PLANES, PASSED_VALUES, STATE_VALUES,
};

/// Cells' sides below and above the scene along the longest side: walls then lie between the centres of two cells, in
/// the middle of a voxel of half the side, and one cell lies behind them.
const PADDING: f32 = 0.75;
/// One cell may take one part in so many of all light before the fixed-point scale is made coarser.
const HEADROOM: f32 = 64.0;
/// Factor between two tries of the scale.
const SCALE_STEP: f32 = 1.0 / 16.0;
/// Tries: 2¹⁶ times the default.
const SCALE_TRIES: u32 = 5;
/// Light that comes from a finer level is somewhere in its coarser cell, and has half of it to pass.
const HALF_WAY: f32 = 0.5;
/// Steps between two looks at what still travels.
const STEPS_BETWEEN_CHECKS: u32 = 4;

/// Where a grid lies.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Placement {
    /// Point that cells are counted from (m) and side of a cell (m).
    pub anchor_size: Vec4,
    /// First cell.
    pub first_cell: IVec4,
    /// Cells along each axis.
    pub dims: UVec3,
    /// Grids: this one, and those that are each twice as coarse.
    pub levels: u32,
}

impl Placement {
    /// A grid around a box, `resolution` cells along its longest side, with whole coarser cells in as many `levels`.
    pub fn around((low, high): (Vec3, Vec3), resolution: u32, levels: u32) -> Self {
        let multiple = 1 << (levels - 1);
        let extent = high - low;
        let size = extent.max_element().max(f32::MIN_POSITIVE.sqrt()) / (resolution as f32 - 2.0 * PADDING);
        let needed = (extent / size + 2.0 * PADDING - 1e-3).ceil().as_uvec3().max(UVec3::ONE);
        let whole = UVec3::new(
            needed.x.next_multiple_of(multiple),
            needed.y.next_multiple_of(multiple),
            needed.z.next_multiple_of(multiple),
        );
        Self { anchor_size: (low - PADDING * size).extend(size), first_cell: IVec4::ZERO, dims: whole, levels }
    }

    /// A cube of cells of side `size` around a point, snapped to whole cells counted from the world's origin: it moves by
    /// whole cells only.
    pub fn snapped(centre: Vec3, size: f32, resolution: u32) -> Self {
        let first = (centre / size).floor().as_ivec3() - resolution as i32 / 2;
        Self {
            anchor_size: Vec3::ZERO.extend(size),
            first_cell: first.extend(0),
            dims: UVec3::splat(resolution),
            levels: 1,
        }
    }
}

/// Flux (W per channel) at one moment.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct Ledger {
    /// What travels.
    pub stored: DVec3,
    /// The part of it that leaves the grid in the next step.
    pub leaving: DVec3,
    /// The part of it that opacities absorb in the next step.
    pub absorbed: DVec3,
    /// Largest flux of one channel that travels from one cell.
    pub largest: f64,
    /// Largest flux of one channel that has passed one cell.
    pub largest_passed: f64,
}

/// One level: a grid, twice as coarse as the one before.
pub struct Level {
    /// Parameters of passes from the second step on.
    pub params: LpvParams,
    /// The first step's uniform: without occlusion.
    first_step: BufferId,
    /// Later steps' uniform.
    later: BufferId,
    /// Uniform of the passes that change parameters.
    scratch: BufferId,
    /// Two states; the current one is [`Level::state`].
    states: [BufferId; 2],
    current: usize,
    source: BufferId,
    opacity: BufferId,
    facet_area: BufferId,
    texel_area: BufferId,
    ledger: BufferId,
    /// Total of all that has passed, with the coarser levels' share; two, written in turns.
    totals: [BufferId; 2],
    total: usize,
    /// Steps of the last propagation.
    pub steps: u32,
}

impl Level {
    fn new(exec: &mut dyn Executor, params: LpvParams) -> Result<Self, ExecError> {
        let layout = LpvLayout::new(params.dims);
        let values = |exec: &mut dyn Executor, label: &str, count: u32| {
            exec.zeroed_slice::<f32>(label, (layout.value() * count) as usize)
        };
        let per_axis = |exec: &mut dyn Executor, label: &str| {
            exec.zeroed_slice::<f32>(label, (layout.plane * OPACITY_PLANES) as usize)
        };
        let first = LpvParams { occlusion: 0.0, ..params };
        Ok(Self {
            first_step: exec.upload_one("lpv first step", &first)?,
            later: exec.upload_one("lpv steps", &params)?,
            scratch: exec.upload_one("lpv pass", &params)?,
            states: [values(exec, "lpv state", STATE_VALUES)?, values(exec, "lpv state", STATE_VALUES)?],
            current: 0,
            source: values(exec, "lpv source", FLUX_VALUES)?,
            opacity: per_axis(exec, "lpv opacity")?,
            facet_area: per_axis(exec, "lpv facet area")?,
            texel_area: per_axis(exec, "lpv texel area")?,
            ledger: exec
                .zeroed_slice::<f32>("lpv ledger", (LEDGER_VALUES * 3 * params.dims.x * params.dims.z) as usize)?,
            totals: [values(exec, "lpv total", PASSED_VALUES)?, values(exec, "lpv total", PASSED_VALUES)?],
            total: 0,
            params,
            steps: 0,
        })
    }

    /// What travels and what has passed.
    pub fn state(&self) -> BufferId {
        self.states[self.current]
    }
    /// Opacities.
    pub fn opacity(&self) -> BufferId {
        self.opacity
    }
    /// Coefficients of all that has passed.
    pub fn total(&self) -> BufferId {
        self.totals[self.total]
    }

    /// The total before and the one to write, which then is the total.
    fn totals_in_turn(&mut self) -> [BufferId; 2] {
        let before = self.total();
        self.total = 1 - self.total;
        [before, self.total()]
    }

    fn run_with(
        &self,
        exec: &mut dyn Executor,
        kernel: &'static interreflect_kernels::kernel::Kernel,
        params: &LpvParams,
        buffers: &[BufferId],
    ) -> Result<(), ExecError> {
        exec.write(self.scratch, bytemuck::bytes_of(params))?;
        let all: Vec<BufferId> = [self.scratch].into_iter().chain(buffers.iter().copied()).collect();
        exec.run(kernel, &all)
    }

    /// Makes the source travel, beside what has passed before if that is to be kept.
    fn begin(&mut self, exec: &mut dyn Executor, weight: f32, keep: bool) -> Result<(), ExecError> {
        self.steps = 0;
        let params = LpvParams { weight, keep: if keep { 1.0 } else { 0.0 }, ..self.params };
        let [before, after] = [self.state(), self.states[1 - self.current]];
        self.current = 1 - self.current;
        self.run_with(exec, &propagate::lpv_begin::KERNEL, &params, &[self.source, before, after])
    }

    /// One step; the first one after injection without occlusion.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn step(&mut self, exec: &mut dyn Executor, first: bool) -> Result<(), ExecError> {
        let uniform = if first { self.first_step } else { self.later };
        let [from, to] = [self.current, 1 - self.current];
        exec.run(&propagate::lpv_propagate::KERNEL, &[uniform, self.states[from], self.opacity, self.states[to]])?;
        self.current = to;
        self.steps += 1;
        Ok(())
    }

    /// Reads where the flux is.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn ledger(&self, exec: &mut dyn Executor) -> Result<Ledger, ExecError> {
        exec.run(&ledger::lpv_ledger::KERNEL, &[self.later, self.state(), self.opacity, self.ledger])?;
        let columns = exec.read_slice::<f32>(self.ledger)?;
        let n = (self.params.dims.x * self.params.dims.z) as usize;
        let sum = |k: usize| columns[k * n..(k + 1) * n].iter().map(|&v| f64::from(v)).sum::<f64>();
        let sums = |value: usize| DVec3::new(sum(3 * value), sum(3 * value + 1), sum(3 * value + 2));
        let most = |value: usize| columns[3 * value * n..3 * (value + 1) * n].iter().copied().fold(0.0, f32::max);
        // A coefficient is flux times Y₀₀.
        let per_coefficient = (4.0 * std::f64::consts::PI).sqrt();
        Ok(Ledger {
            stored: sums(0),
            leaving: sums(1),
            absorbed: sums(2),
            largest: f64::from(most(3)),
            largest_passed: f64::from(most(4)) * per_coefficient,
        })
    }
}

/// A grid with its coarser levels.
pub struct Volume {
    /// Finest first.
    pub levels: Vec<Level>,
    words: BufferId,
    light: BufferId,
    /// Flux (W, all channels) of each stream of the last injection.
    pub injected: Vec<f64>,
    /// Tries of the fixed-point scale in the last injection: 1 where the first fit.
    pub scale_tries: u32,
    /// Fixed-point units per watt.
    pub flux_scale: f32,
}

impl Volume {
    /// Allocates a grid.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn new(exec: &mut dyn Executor, options: &Options, at: &Placement) -> Result<Self, ExecError> {
        let mut levels = Vec::new();
        for k in 0..at.levels {
            levels.push(Level::new(exec, params(options, at, k))?);
        }
        let value = LpvLayout::new(levels[0].params.dims).value();
        let words = exec.zeroed_slice::<u32>("lpv injection", inject::word_count(&levels[0].params) as usize + 1)?;
        let light = exec.zeroed_slice::<f32>("lpv light", (PASSED_VALUES * value) as usize)?;
        Ok(Self { levels, words, light, injected: Vec::new(), scale_tries: 0, flux_scale: 1.0 })
    }

    /// The finest level.
    pub fn finest(&self) -> &Level {
        &self.levels[0]
    }

    /// Adds the voxelized scene to the geometry volume of every level. `facets` of side `voxel_size`.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn block_facets(
        &self,
        exec: &mut dyn Executor,
        facets: BufferId,
        facet_count: u32,
        voxel_size: f32,
    ) -> Result<(), ExecError> {
        for level in &self.levels {
            exec.clear(level.facet_area)?;
            let params = LpvParams { count: facet_count, voxel_size, ..level.params };
            level.run_with(exec, &block::lpv_block_facets::KERNEL, &params, &[facets, level.facet_area])?;
        }
        Ok(())
    }

    /// Forgets the areas of lit texels.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn clear_texels(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        self.levels.iter().try_for_each(|level| exec.clear(level.texel_area))
    }

    /// Adds lit texels to the geometry volume of every level.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn block_texels(&self, exec: &mut dyn Executor, texels: BufferId, count: u32) -> Result<(), ExecError> {
        for level in &self.levels {
            let params = LpvParams { count, ..level.params };
            level.run_with(exec, &block::lpv_block_texels::KERNEL, &params, &[texels, level.texel_area])?;
        }
        Ok(())
    }

    /// Makes opacities of the areas.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn make_opacity(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        for level in &self.levels {
            exec.run(&block::lpv_opacity::KERNEL, &[level.later, level.facet_area, level.texel_area, level.opacity])?;
        }
        Ok(())
    }

    /// Forgets what was injected and prepares for at most `flux` (W) in all.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn begin_injection(&mut self, exec: &mut dyn Executor, flux: f32) -> Result<(), ExecError> {
        self.scale_tries = 0;
        self.flux_scale = if flux > 0.0 { (FLUX_LIMIT as f32 * HEADROOM / flux).min(f32::MAX) } else { 1.0 };
        self.restart_injection(exec)
    }

    fn restart_injection(&mut self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        self.scale_tries += 1;
        exec.clear(self.words)
    }

    /// Adds lit texels.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn inject(&self, exec: &mut dyn Executor, texels: BufferId, count: u32) -> Result<(), ExecError> {
        let params = LpvParams { count, flux_scale: self.flux_scale, ..self.finest().params };
        self.finest().run_with(exec, &inject::lpv_inject::KERNEL, &params, &[texels, self.words])
    }

    /// Adds what facets reflect of the last propagation's light ([`Volume::light`]).
    ///
    /// # Errors
    /// What the executor returns.
    pub fn bounce(
        &self,
        exec: &mut dyn Executor,
        facets: BufferId,
        facet_count: u32,
        voxel_size: f32,
    ) -> Result<(), ExecError> {
        let params =
            LpvParams { count: 2 * facet_count, flux_scale: self.flux_scale, voxel_size, ..self.finest().params };
        self.finest().run_with(exec, &bounce::lpv_bounce::KERNEL, &params, &[facets, self.light(), self.words])
    }

    /// Forgets what was injected, at the same scale.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn clear_injection(&self, exec: &mut dyn Executor) -> Result<(), ExecError> {
        exec.clear(self.words)
    }

    /// Packs the total of the finest level, times `scale`, into half floats.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn pack(&self, exec: &mut dyn Executor, scale: f32, packed: BufferId) -> Result<(), ExecError> {
        let level = self.finest();
        let params = LpvParams { half_scale: scale, ..level.params };
        level.run_with(exec, &gather::lpv_pack::KERNEL, &params, &[level.total(), packed])
    }

    /// Whether no cell took more than the fixed-point scale holds; if one did, makes the scale coarser and forgets what was
    /// injected: inject again.
    ///
    /// # Errors
    /// [`MethodError::TooLarge`] where not even the coarsest scale holds; what the executor returns.
    pub fn injection_fits(&mut self, exec: &mut dyn Executor) -> Result<bool, MethodError> {
        let words = exec.read_slice::<u32>(self.words)?;
        if words.last() == Some(&0) {
            let value = LpvLayout::new(self.finest().params.dims).value() as usize;
            let flux = |stream: &[u32]| stream[..value].iter().map(|&w| f64::from(w)).sum::<f64>();
            let streams = words.chunks_exact(FLUX_VALUES as usize * value);
            self.injected = streams.map(|stream| flux(stream) / f64::from(self.flux_scale)).collect();
            return Ok(true);
        }
        if self.scale_tries >= SCALE_TRIES {
            return Err(MethodError::TooLarge {
                method: super::NAME,
                needed_bytes: 8 * words.len() as u64,
                limit_bytes: 4 * words.len() as u64,
                hint: "one cell receives more light than all lights send: the scene's lights are inconsistent".into(),
            });
        }
        self.flux_scale *= SCALE_STEP;
        self.restart_injection(exec)?;
        Ok(false)
    }

    /// Makes one stream of what was injected, times `gain`, travel on the finest level; `keep`s what other streams have left.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn start(&mut self, exec: &mut dyn Executor, gain: f32, stream: u32, keep: bool) -> Result<(), ExecError> {
        let words = self.words;
        let level = &mut self.levels[0];
        let params = LpvParams { flux_scale: self.flux_scale / gain, stream, ..level.params };
        level.run_with(exec, &inject::lpv_resolve::KERNEL, &params, &[words, level.source])?;
        level.begin(exec, 1.0, keep)
    }

    /// Propagates from level to level; on the coarsest until the largest flux that travels is below `tolerance` of the
    /// largest that has passed, or `most` steps.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn propagate(&mut self, exec: &mut dyn Executor, options: &Options, keep: bool) -> Result<(), ExecError> {
        let last = self.levels.len() - 1;
        for k in 0..last {
            for step in 0..options.steps {
                self.levels[k].step(exec, k == 0 && step == 0)?;
            }
            let (fine, coarse) = self.levels.split_at_mut(k + 1);
            let (fine, coarse) = (&fine[k], &mut coarse[0]);
            exec.run(&levels::lpv_restrict::KERNEL, &[fine.later, fine.state(), coarse.source])?;
            coarse.begin(exec, HALF_WAY, keep)?;
        }
        let level = &mut self.levels[last];
        let longest = level.params.dims.max_element();
        let most = options.iterations.unwrap_or(2 * longest);
        let least = if options.iterations.is_some() { most } else { (longest / 2).max(1) };
        for step in 0..most {
            level.step(exec, last == 0 && step == 0)?;
            let done = step + 1;
            if done >= least && done < most && done % STEPS_BETWEEN_CHECKS == 0 {
                let now = level.ledger(exec)?;
                if now.largest <= f64::from(options.tolerance) * now.largest_passed {
                    break;
                }
            }
        }
        Ok(())
    }

    /// Adds up the levels from the coarsest: the light of this bounce on the finest, added to `keep` times the total
    /// before; and, where a further bounce needs it, alone ([`Volume::light`]).
    ///
    /// # Errors
    /// What the executor returns.
    pub fn sum_levels(&mut self, exec: &mut dyn Executor, keep: f32, alone: bool) -> Result<(), ExecError> {
        for k in (1..self.levels.len()).rev() {
            let turn = self.levels[k].totals_in_turn();
            self.prolong(exec, k, 0.0, turn)?;
        }
        if alone {
            let light = self.light;
            self.prolong(exec, 0, 0.0, [self.levels[0].total(), light])?;
        }
        let turn = self.levels[0].totals_in_turn();
        self.prolong(exec, 0, keep, turn)
    }

    fn prolong(
        &self,
        exec: &mut dyn Executor,
        k: usize,
        keep: f32,
        [before, target]: [BufferId; 2],
    ) -> Result<(), ExecError> {
        let level = &self.levels[k];
        let coarse = self.levels.get(k + 1);
        let coarse_weight = if coarse.is_some() { 0.25 } else { 0.0 };
        let params = LpvParams { keep, coarse_weight, ..level.params };
        // Where there is no coarser level any buffer does: its weight is zero.
        let (total, opacity) = coarse.map_or((level.source, level.facet_area), |c| (c.total(), c.opacity));
        let bound = [before, level.state(), total, level.opacity, opacity, target];
        level.run_with(exec, &levels::lpv_prolong::KERNEL, &params, &bound)
    }

    /// Light of the last propagation alone, if it was asked for.
    pub fn light(&self) -> BufferId {
        self.light
    }
}

/// Parameters of level `k` of a grid.
fn params(options: &Options, at: &Placement, k: u32) -> LpvParams {
    let dims = |k: u32| UVec4::new(at.dims.x >> k, at.dims.y >> k, at.dims.z >> k, 0);
    let size = at.anchor_size.w * (1 << k) as f32;
    LpvParams {
        anchor_size: at.anchor_size.truncate().extend(size),
        first_cell: IVec4::new(at.first_cell.x >> k, at.first_cell.y >> k, at.first_cell.z >> k, 0),
        dims: dims(k),
        coarse_dims: if k + 1 < at.levels { dims(k + 1) } else { UVec4::ZERO },
        lobe: if options.paper_scheme {
            Vec4::new(inject::LOBE_MOMENT, 0.0, inject::LOBE_MOMENT, 0.0)
        } else {
            Vec4::new(1.0, ALONG, ACROSS, 1.0)
        },
        count: 0,
        focus: if options.paper_scheme { 0.0 } else { options.focus },
        flux_scale: 1.0,
        occlusion: if options.occludes() { 1.0 } else { 0.0 },
        gain: if options.gain_correction { 1.0 } else { 0.0 },
        weight: 1.0,
        keep: 0.0,
        coarse_weight: 0.0,
        voxel_size: 0.0,
        half_scale: 1.0,
        opacity_sources: options.opacity_sources,
        streams: options.streams,
        stream: 0,
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
        fade: Vec4::ZERO,
    }
}

/// Bytes of a grid with its levels.
pub fn bytes(at: &Placement, streams: u32) -> u64 {
    let plane = |k: u32| u64::from(LpvLayout::new(UVec4::new(at.dims.x >> k, at.dims.y >> k, at.dims.z >> k, 0)).plane);
    let per_cell = u64::from(3 * (2 * STATE_VALUES + 2 * PASSED_VALUES + FLUX_VALUES) + 3 * OPACITY_PLANES);
    let levels: u64 = (0..at.levels).map(|k| plane(k) * per_cell).sum();
    4 * levels + 4 * 3 * u64::from(streams * FLUX_VALUES + PASSED_VALUES) * plane(0)
}

/// Bytes of the largest buffer.
pub fn largest_buffer(at: &Placement, streams: u32) -> u64 {
    4 * u64::from(STATE_VALUES.max(streams * FLUX_VALUES)) * u64::from(LpvLayout::new(at.dims.extend(0)).value())
}
