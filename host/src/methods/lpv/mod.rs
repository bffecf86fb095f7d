//! Light propagation volumes.
//!
//! Kaplanyan & Dachsbacher 2010; Doghramachi 2013. Kernels and deviations: `interreflect_kernels::lpv`. Order: voxelize, block facets
//! (geometry changed); shadow maps, injection, opacity, propagation, and for each further bounce facets, propagation (lights changed); fetch (every frame).

pub mod maps;
pub mod volume;

use super::gaps::{Choice, Rule};
use super::settings::{auto_or, parse};
use super::voxels::{VoxelGrid, VoxelOptions, VoxelScene};
use super::{Input, Method, MethodError, MethodRow, SearchAxis, Setting, Settings, StageClock, Terms, Unit};
use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::scene::{Camera, Scene};
use glam::{IVec4, UVec4, Vec3, Vec4};
use interreflect_kernels::cone::glossy::cone_glossy;
use interreflect_kernels::cone::set::{cone_parts, diffuse_cones};
use interreflect_kernels::lpv::{bounce, gather};
use interreflect_kernels::math::pack::unpack_f16x2;
use interreflect_shared::cone::ConeParams;
use interreflect_shared::lpv::{LpvLayout, LpvParams, LpvQuery, MAX_CASCADES, PASSED_VALUES};
use interreflect_shared::voxel::VoxelFacet;
use maps::{Maps, flux_bound};
use serde_json::json;
use volume::{Ledger, Placement, Volume};

const NAME: &str = "lpv";
/// How fine cells are where nobody says.
///
/// Below 24 cells a furnace loses more than 10 % of its light; beyond 32 the error does not fall reliably (blue-orange box on blocks: 0.49 at 32, 1.20 at 48; louvres 0.54 and 0.80).
const RULE: Rule = Rule { cells_per_gap: 6.0, resolution: 24..=32 };

/// Row of the methods table.
pub const ROW: MethodRow = MethodRow {
    name: NAME,
    control: false,
    summary: "Light propagation volumes: lit surfaces as light in a grid that spreads from cell to cell.",
    good_when: "Moving lights and objects, smooth diffuse light, a small and constant budget whatever the scene.",
    fails_when: "Walls thinner than a cell (light leaks), small far sources and fine occlusion (order 1 blurs them).",
    settings: &[
        Setting {
            key: "resolution",
            default: "auto",
            allowed: "auto, or a whole number from 4 to 96",
            help: "Cells along the longest side. Higher: finer light and thinner walls; time and memory grow with the cube. \
                   auto: as many as the narrowest gap or wall that matters needs.",
        },
        Setting {
            key: "rsm",
            default: "0",
            allowed: "0 or an even number from 2 to 1024",
            help: "Texels along each side of a light's shadow map; 0 shares some 260,000 rays among the lights. Higher: less \
                   noise and flicker; time grows with the square and with the number of lights.",
        },
        Setting {
            key: "scheme",
            default: "moment",
            allowed: "moment or paper",
            help: "moment keeps the first moment of light in flight; paper makes flux through a face a clamped-cosine lobe \
                   around the face's axis, which throws most light back within a few cells.",
        },
        Setting {
            key: "focus",
            default: "0.69",
            allowed: "a number from 0 to 0.9",
            help: "Largest mean cosine of a cell's lobe. Up to a third: lobes are order-1 spherical harmonics as in the papers; \
                   two thirds: light of a diffuse surface leaves it as it should. Much more: beams draw together.",
        },
        Setting {
            key: "streams",
            default: "6",
            allowed: "1 or 6",
            help: "1 lets all light of a cell travel as one lobe, as in the papers; 6 keeps light apart by the way that the \
                   surface that it comes from faces, so that crossing beams do not merge. Propagation takes six times as long.",
        },
        Setting {
            key: "gain_correction",
            default: "1",
            allowed: "0 or 1",
            help: "1 makes every cell send exactly the flux that it holds; 0 lets the clamp of negative lobes add up to 14 % \
                   per step.",
        },
        Setting {
            key: "levels",
            default: "0",
            allowed: "a whole number from 0 to 5",
            help: "Grids, each twice as coarse as the one before, through which light passes on its way; 1 propagates on one \
                   grid alone, 0 adds levels until the coarsest has some 8 cells along the longest side or 4 along the \
                   shortest. More: faster, and light keeps its direction over more cells.",
        },
        Setting {
            key: "steps",
            default: "1",
            allowed: "a whole number from 1 to 64",
            help: "Steps on each grid but the coarsest before light moves to the next.",
        },
        Setting {
            key: "iterations",
            default: "0",
            allowed: "a whole number from 0 to 512",
            help: "Steps on the coarsest grid; 0: from half to twice its cells, until `tolerance` is reached.",
        },
        Setting {
            key: "tolerance",
            default: "0.001",
            allowed: "a number from 0 to 1",
            help: "Largest flux that still travels, over the largest that has passed, at which propagation ends.",
        },
        Setting {
            key: "geometry",
            default: "both",
            allowed: "both, voxels, texels or none",
            help: "What blocks light between cells: the voxelized scene, what the shadow maps see, both, or nothing (leaks).",
        },
        Setting {
            key: "bounces",
            default: "2",
            allowed: "a whole number from 1 to 16",
            help: "Reflections that light may make before it reaches a pixel. Each after the first propagates once more.",
        },
        Setting {
            key: "tail",
            default: "1",
            allowed: "0 or 1",
            help: "1 adds the bounces after the last as a geometric series. Needs 2 bounces to know its ratio.",
        },
        Setting {
            key: "storage",
            default: "f32",
            allowed: "f32 or f16",
            help: "Numbers that pixels read: f16 halves memory and bandwidth; the report tells the error that it costs.",
        },
        Setting {
            key: "cascades",
            default: "1",
            allowed: "a whole number from 1 to 4",
            help: "1: one grid around the scene. More: cubes of cells around `centre`, each twice as large as the one before, \
                   the largest as long as twice the scene.",
        },
        Setting {
            key: "centre",
            default: "camera",
            allowed: "camera or X:Y:Z in metres",
            help: "Point that cascades lie around: the scene's first camera, or a position.",
        },
        Setting {
            key: "offset",
            default: "0.5",
            allowed: "a number from 0 to 2",
            help: "Height above the surface at which light is fetched, in cells. Lower sees more of corners; higher sees less \
                   of what lies in the same cell.",
        },
        Setting {
            key: "memory_limit_mb",
            default: "2048",
            allowed: "a whole number from 1 to 1048576",
            help: "Memory that the method may take, in MiB; more is refused with a message.",
        },
    ],
    ladder: &[
        ("8, one bounce", &[("resolution", "8"), ("bounces", "1"), ("rsm", "64")]),
        ("16, two bounces", &[("resolution", "16"), ("bounces", "2"), ("rsm", "128")]),
        ("24", &[("resolution", "24")]),
        ("32", &[("resolution", "32")]),
        ("48", &[("resolution", "48")]),
        ("64", &[("resolution", "64")]),
    ],
    new: |settings| Ok(Box::new(Lpv::new(settings)?)),
};

/// Checked settings.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Options {
    /// `None`: as the scene needs.
    resolution: Option<u32>,
    rsm: u32,
    paper_scheme: bool,
    focus: f32,
    streams: u32,
    gain_correction: bool,
    levels: u32,
    steps: u32,
    iterations: Option<u32>,
    tolerance: f32,
    /// Bit 0 facets, bit 1 texels.
    opacity_sources: u32,
    bounces: u32,
    tail: bool,
    half: bool,
    cascades: u32,
    centre: Option<Vec3>,
    offset: f32,
    memory_limit_bytes: u64,
}

/// Cells along the longest side below which no coarser level is added.
const COARSEST: u32 = 8;
/// The same along the shortest: cells as large as a corridor is wide lead light around its walls.
const COARSEST_ACROSS: u32 = 4;
/// Cells over which a cascade fades into the next.
const BLEND: f32 = 2.0;
/// Largest storage buffer that every device allows: WebGPU's default limit.
const MAX_BINDING_BYTES: u64 = 128 << 20;
/// Largest ratio of one bounce's flux to the one before; a larger one is noise.
const MAX_RATIO: f64 = 0.95;

impl Options {
    /// Checks settings; missing ones have their defaults.
    ///
    /// # Errors
    /// [`MethodError::BadValue`].
    pub fn parse(settings: &Settings) -> Result<Self, MethodError> {
        let flag = |key| Ok::<bool, MethodError>(parse(&ROW, settings, key, |n: &u32| *n <= 1)? == 1);
        let word = |key, words: &[&str]| {
            let text: String = parse(&ROW, settings, key, |t: &String| words.contains(&t.as_str()))?;
            Ok::<usize, MethodError>(words.iter().position(|w| *w == text).expect("checked"))
        };
        let resolution = auto_or(&ROW, settings, "resolution", |n| (4..=96).contains(n))?;
        let iterations: u32 = parse(&ROW, settings, "iterations", |n| *n <= 512)?;
        let centre: String = parse(&ROW, settings, "centre", |t: &String| t == "camera" || position(t).is_some())?;
        Ok(Self {
            resolution,
            rsm: parse(&ROW, settings, "rsm", |n| *n <= 1024 && n % 2 == 0)?,
            paper_scheme: word("scheme", &["moment", "paper"])? == 1,
            focus: parse(&ROW, settings, "focus", |x| (0.0..=0.9).contains(x))?,
            streams: [1, 6][word("streams", &["1", "6"])?],
            gain_correction: flag("gain_correction")?,
            levels: parse(&ROW, settings, "levels", |n| *n <= 5)?,
            steps: parse(&ROW, settings, "steps", |n| (1..=64).contains(n))?,
            iterations: (iterations > 0).then_some(iterations),
            tolerance: parse(&ROW, settings, "tolerance", |x| (0.0..=1.0).contains(x))?,
            opacity_sources: word("geometry", &["none", "voxels", "texels", "both"])? as u32,
            bounces: parse(&ROW, settings, "bounces", |n| (1..=16).contains(n))?,
            tail: flag("tail")?,
            half: word("storage", &["f32", "f16"])? == 1,
            cascades: parse(&ROW, settings, "cascades", |n| (1..=MAX_CASCADES as u32).contains(n))?,
            centre: position(&centre),
            offset: parse(&ROW, settings, "offset", |x| (0.0..=2.0).contains(x))?,
            memory_limit_bytes: parse(&ROW, settings, "memory_limit_mb", |n: &u64| (1..=1 << 20).contains(n))? << 20,
        })
    }

    /// Whether anything blocks light.
    pub fn occludes(&self) -> bool {
        self.opacity_sources > 0
    }

    /// Levels of a grid of so many cells along the longest side of a scene of this extent (m).
    fn level_count(&self, extent: Vec3, resolution: u32) -> u32 {
        let shortest = resolution as f32 * extent.min_element() / extent.max_element().max(f32::MIN_POSITIVE);
        let most = (resolution / COARSEST).min(shortest as u32 / COARSEST_ACROSS).max(1).ilog2() + 1;
        if self.levels == 0 { most } else { self.levels.min((resolution / 2).max(1).ilog2() + 1) }
    }

    fn placements(&self, scene: &Scene, resolution: u32) -> Vec<Placement> {
        let bounds = scene.bounds();
        if self.cascades == 1 {
            return vec![Placement::around(bounds, resolution, self.level_count(bounds.1 - bounds.0, resolution))];
        }
        let extent = (bounds.1 - bounds.0).max_element().max(f32::MIN_POSITIVE.sqrt());
        let centre = self.centre.or(scene.cameras.first().map(|c| c.position));
        let centre = centre.unwrap_or((bounds.0 + bounds.1) * 0.5);
        let largest = 2.0 * extent / resolution as f32;
        let size = |k: u32| largest / (1 << (self.cascades - 1 - k)) as f32;
        (0..self.cascades).map(|k| Placement::snapped(centre, size(k), resolution)).collect()
    }
}

/// A position written `X:Y:Z`.
fn position(text: &str) -> Option<Vec3> {
    let numbers: Vec<f32> =
        text.split(':').map(|part| part.trim().parse().ok().filter(|x: &f32| x.is_finite())).collect::<Option<_>>()?;
    <[f32; 3]>::try_from(numbers).ok().map(Vec3::from)
}

/// The method with its buffers.
pub struct Lpv {
    options: Options,
    state: Option<State>,
}

/// What [`Method::precompute`] makes.
struct State {
    resolution: Choice,
    volumes: Vec<Volume>,
    maps: Maps,
    voxels: Option<VoxelScene>,
    /// Largest share of its light that a surface reflects.
    brightest: f64,
    query: LpvQuery,
    query_uniform: BufferId,
    /// Packed totals of each grid (f16), and stand-ins for grids that are not there.
    packed: Vec<BufferId>,
    dummies: Vec<BufferId>,
    report: Report,
}

/// What the last light change found.
#[derive(Clone, Default)]
struct Report {
    /// Injected flux of each bounce.
    bounce_flux: Vec<f64>,
    ratio: Option<f64>,
    /// Steps of each level of the first grid, of the last propagation.
    steps: Vec<u32>,
    scale_tries: u32,
    half_error: Option<f64>,
    traced_maps: u32,
}

impl Lpv {
    /// From settings.
    ///
    /// # Errors
    /// [`MethodError::BadValue`].
    pub fn new(settings: &Settings) -> Result<Self, MethodError> {
        Ok(Self { options: Options::parse(settings)?, state: None })
    }

    fn state(&mut self) -> Result<&mut State, MethodError> {
        self.state.as_mut().ok_or(MethodError::NotPrecomputed { method: NAME })
    }

    /// Coefficients of the light that has passed, of every grid, finest first: six planes per channel in the layout of
    /// [`LpvLayout`]; and the grid's parameters.
    pub fn light(&self) -> Vec<(BufferId, LpvParams)> {
        let volumes = self.state.iter().flat_map(|s| &s.volumes);
        volumes.map(|v| (v.finest().total(), v.finest().params)).collect()
    }

    /// Radiance (W/(sr m²), `Vec4` per pixel) that a glossy lobe of half angle `half_angle_rad` reflects towards the camera at every surface
    /// of `gbuffer` for a reflectance of 1, into `out`: the reflection grid. Emitters themselves are not in it. After [`Method::light_change`].
    ///
    /// # Errors
    /// [`MethodError::BadValue`] with `geometry` none or texels and one bounce: there are no voxels then; what the executor returns.
    pub fn reflect(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        camera: &Camera,
        half_angle_rad: f32,
        (gbuffer, out): (BufferId, BufferId),
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let around_camera = self.options.cascades > 1;
        let state = self.state()?;
        let Some(voxels) = &mut state.voxels else {
            return Err(MethodError::BadValue {
                method: NAME,
                key: "geometry".into(),
                value: "without voxels".into(),
                expected: "voxels or both: reflections are read from voxels".into(),
            });
        };
        let level = state.volumes[0].finest();
        // A grid around the camera ends somewhere; one around the scene holds all that reflects.
        let range = level.params.anchor_size.w * level.params.dims.max_element() as f32;
        let radius = if around_camera { range } else { 1e6 * range };
        let mark = exec.mark();
        clock.stage(exec, "reflection grid", |exec| {
            voxels.inject(exec, input, 4, 8)?;
            let p = voxels.params;
            let params = LpvParams {
                count: 2 * p.facet_count,
                voxel_size: p.origin_size.w,
                fade: camera.position.extend(radius),
                ..level.params
            };
            let uniform = exec.upload_one("reflection", &params)?;
            let bound = [uniform, voxels.facets, level.total(), voxels.direct, voxels.radiance];
            exec.run(&bounce::lpv_reflect::KERNEL, &bound)
        })?;
        clock.stage(exec, "reflection mipmap", |exec| voxels.mipmap(exec))?;
        clock.stage(exec, "reflection cone", |exec| {
            let p = voxels.params;
            let cone = ConeParams {
                origin_size: p.origin_size,
                dims_levels: p.dims_levels,
                levels: p.levels,
                cones: diffuse_cones(6),
                parts: cone_parts(6),
                beyond: Vec4::ZERO,
                camera: camera.position.extend(half_angle_rad.tan()),
                cone_count: 1,
                direction_count: p.direction_count,
                count: (exec.size_bytes(out) / size_of::<Vec4>() as u64) as u32,
                seed: 0,
                spread: 0.0,
                offset: 1.0,
                clearance: 1.0,
                _pad: 0.0,
            };
            let uniform = exec.upload_one("reflection cone", &cone)?;
            let v = &*voxels;
            let bound = [uniform, v.cells, v.facet_bits, v.facets, v.radiance, v.odd, v.even, gbuffer, out];
            exec.run(&cone_glossy::KERNEL, &bound)
        })?;
        exec.free_since(mark);
        Ok(())
    }
}

impl Method for Lpv {
    fn precompute(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let o = self.options;
        let resolution = RULE.choose(o.resolution, exec, input, clock)?;
        let placements = o.placements(input.scene, resolution.resolution);
        let maps = Maps::new(exec, input, o.rsm)?;
        check_memory(&o, &placements)?;
        let mut volumes = Vec::new();
        for at in &placements {
            volumes.push(Volume::new(exec, &o, at)?);
        }
        let voxels = if o.opacity_sources & 1 == 1 || o.bounces > 1 {
            Some(voxelize(exec, input, &o, (&placements, resolution.resolution), clock)?)
        } else {
            None
        };
        if let Some(v) = &voxels {
            clock.stage(exec, "block facets", |exec| {
                volumes.iter().try_for_each(|volume| {
                    volume.block_facets(exec, v.facets, v.params.facet_count, v.params.origin_size.w)
                })
            })?;
        }
        let brightest = brightest(exec, voxels.as_ref())?;
        let query = query(&o, &volumes);
        let mut packed = Vec::new();
        if o.half {
            for volume in &volumes {
                let value = LpvLayout::new(volume.finest().params.dims).value();
                packed.push(exec.zeroed_slice::<u32>("lpv packed", (PASSED_VALUES / 2 * value) as usize)?);
            }
        }
        let dummies = (volumes.len()..MAX_CASCADES)
            .map(|_| exec.zeroed_slice::<u32>("lpv no grid", 1))
            .collect::<Result<_, _>>()?;
        let query_uniform = exec.upload_one("lpv query", &query)?;
        let report = Report::default();
        self.state =
            Some(State { resolution, volumes, maps, voxels, brightest, query, query_uniform, packed, dummies, report });
        Ok(())
    }

    fn light_change(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let o = self.options;
        let state = self.state()?;
        if !state.maps.fit(input.scene) {
            state.maps = Maps::new(exec, input, o.rsm)?;
        }
        state.report = Report::default();
        state.inject(exec, input, &o, clock)?;
        for bounce in 1..=o.bounces {
            if bounce > 1 {
                state.reinject(exec, clock, bounce)?;
            }
            let gain = state.gain(&o, bounce);
            state.spread(exec, &o, clock, gain, bounce)?;
        }
        state.report.steps = state.volumes[0].levels.iter().map(|l| l.steps).collect();
        state.report.scale_tries = state.volumes.iter().map(|v| v.scale_tries).max().unwrap_or(0);
        state.report.traced_maps = state.maps.traced_count;
        state.maps.traced_count = 0;
        if o.half { state.pack(exec, clock) } else { Ok(()) }
    }

    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        _input: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let half = self.options.half;
        let state = self.state()?;
        state.query.count = (exec.size_bytes(irradiance) / size_of::<Vec4>() as u64) as u32;
        exec.write(state.query_uniform, bytemuck::bytes_of(&state.query))?;
        clock.stage(exec, "fetch", |exec| {
            let mut bound = vec![state.query_uniform];
            if half {
                bound.extend(&state.packed);
            } else {
                bound.extend(state.volumes.iter().map(|v| v.finest().total()));
            }
            bound.extend(&state.dummies);
            bound.extend([gbuffer, irradiance]);
            Ok(exec.run(if half { &gather::lpv_gather_half::KERNEL } else { &gather::lpv_gather::KERNEL }, &bound)?)
        })
    }

    fn needs(&self) -> serde_json::Value {
        let Some(state) = &self.state else { return serde_json::Value::Null };
        let level = state.volumes[0].finest();
        let report = &state.report;
        json!({
            "dims": level.params.dims.truncate().to_array(),
            "resolution": state.resolution,
            "cell_size_m": level.params.anchor_size.w,
            "cascades": state.volumes.len(),
            "levels": state.volumes[0].levels.len(),
            "steps_per_level": report.steps,
            "iterations": report.steps.iter().sum::<u32>(),
            "shadow_maps": state.maps.count(),
            "shadow_map_resolution": state.maps.resolution,
            "shadow_maps_traced": report.traced_maps,
            "bounces": self.options.bounces,
            "streams": self.options.streams,
            "streams_with_light": state.volumes[0].injected.iter().filter(|f| **f > 0.0).count(),
            "reflected_flux_per_bounce_w": report.bounce_flux,
            "bounce_ratio": report.ratio,
            "fixed_point_tries": report.scale_tries,
            "fixed_point_rescaled": report.scale_tries > 1,
            "half_float_error": report.half_error,
            "voxels": state.voxels.as_ref().map(VoxelScene::needs),
        })
    }

    fn unit(&self) -> Option<Unit> {
        let level = self.state.as_ref()?.volumes.first()?.finest();
        Some(Unit { name: "cells", metres: level.params.anchor_size.w })
    }

    fn feedback_gain(&self) -> Option<f64> {
        self.state.as_ref()?.report.ratio
    }

    fn terms(&self) -> Vec<Terms> {
        self.feedback_gain().map(|ratio| Terms::geometric("bounces", "bounces", ratio)).into_iter().collect()
    }

    fn search(&self) -> &'static [SearchAxis] {
        const AXES: &[SearchAxis] = &[
            SearchAxis { key: "resolution", values: &["8", "12", "16", "24", "32", "48", "64"] },
            SearchAxis { key: "bounces", values: &["1", "2", "3", "4", "6"] },
            SearchAxis { key: "rsm", values: &["32", "64", "128", "256", "512"] },
            SearchAxis { key: "streams", values: &["1", "6"] },
            SearchAxis { key: "steps", values: &["1", "2", "4"] },
            SearchAxis { key: "storage", values: &["f16", "f32"] },
        ];
        AXES
    }
}

impl State {
    /// Shadow maps into every grid, until the fixed-point scale fits.
    fn inject(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        o: &Options,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let bound = flux_bound(input.scene);
        self.volumes.iter_mut().try_for_each(|v| v.begin_injection(exec, bound))?;
        let texels_block = o.opacity_sources & 2 == 2;
        self.volumes.iter().try_for_each(|v| v.clear_texels(exec))?;
        let mut first_try = true;
        loop {
            for batch in 0..self.maps.batches() {
                let mut count = 0;
                let maps = &mut self.maps;
                clock.stage(exec, "shadow maps", |exec| {
                    count = maps.trace(exec, input, batch)?;
                    Ok::<(), MethodError>(())
                })?;
                let (volumes, texels) = (&self.volumes, self.maps.texels);
                clock.stage(exec, "inject", |exec| volumes.iter().try_for_each(|v| v.inject(exec, texels, count)))?;
                if texels_block && first_try {
                    clock.stage(exec, "block texels", |exec| {
                        volumes.iter().try_for_each(|v| v.block_texels(exec, texels, count))
                    })?;
                }
            }
            first_try = false;
            let mut fit = true;
            for volume in &mut self.volumes {
                fit &= volume.injection_fits(exec)?;
            }
            if fit {
                break;
            }
            // One scale too fine: inject into every grid again.
            let scale = self.volumes.iter().map(|v| v.flux_scale).fold(f32::MAX, f32::min);
            for volume in &mut self.volumes {
                let tries = volume.scale_tries;
                volume.begin_injection(exec, 0.0)?;
                (volume.flux_scale, volume.scale_tries) = (scale, tries);
            }
        }
        clock.stage(exec, "opacity", |exec| self.volumes.iter().try_for_each(|v| v.make_opacity(exec)))?;
        Ok(())
    }

    /// What facets reflect of the last bounce.
    fn reinject(&mut self, exec: &mut dyn Executor, clock: &mut StageClock, bounce: u32) -> Result<(), MethodError> {
        let voxels = self.voxels.as_ref().expect("more than one bounce voxelizes");
        let (facets, p) = (voxels.facets, voxels.params);
        let volumes = &mut self.volumes;
        clock.stage(exec, &format!("bounce {bounce}"), |exec| {
            for volume in volumes {
                loop {
                    volume.clear_injection(exec)?;
                    volume.bounce(exec, facets, p.facet_count, p.origin_size.w)?;
                    if volume.injection_fits(exec)? {
                        break;
                    }
                }
            }
            Ok(())
        })
    }

    /// Factor of what was injected: the last bounce stands for all that follow it.
    ///
    /// Where cells are too coarse for what is in them, surfaces seem to reflect light that never reached them, and bounces
    /// would grow: at least half of what the brightest surface absorbs is lost in each.
    fn gain(&mut self, o: &Options, bounce: u32) -> f32 {
        // The largest grid sees all of the scene: its flux tells the ratio.
        let injected: f64 = self.volumes.last().map_or(0.0, |v| v.injected.iter().sum());
        let report = &mut self.report;
        let before = report.bounce_flux.last().copied().filter(|f| *f > 0.0);
        let most = 0.5 * (1.0 + self.brightest);
        let flux = before.map_or(injected, |before| injected.min(most * before));
        report.ratio = before.map(|before| flux / before);
        report.bounce_flux.push(flux);
        let kept = if injected > 0.0 { flux / injected } else { 1.0 };
        match report.ratio {
            Some(ratio) if o.tail && bounce == o.bounces => (kept / (1.0 - ratio.min(MAX_RATIO))) as f32,
            _ => kept as f32,
        }
    }

    /// Makes what was injected travel, stream by stream, and adds it to the total; what a further bounce needs is kept
    /// apart as well.
    fn spread(
        &mut self,
        exec: &mut dyn Executor,
        o: &Options,
        clock: &mut StageClock,
        gain: f32,
        bounce: u32,
    ) -> Result<(), MethodError> {
        let volumes = &mut self.volumes;
        let mut keep = false;
        for stream in 0..o.streams {
            // A stream without light costs nothing.
            if stream > 0 && volumes.iter().all(|v| v.injected[stream as usize] == 0.0) {
                continue;
            }
            clock
                .stage(exec, "begin", |exec| volumes.iter_mut().try_for_each(|v| v.start(exec, gain, stream, keep)))?;
            clock.stage(exec, "propagate", |exec| volumes.iter_mut().try_for_each(|v| v.propagate(exec, o, keep)))?;
            keep = true;
        }
        clock.stage(exec, "sum levels", |exec| {
            let keep = if bounce > 1 { 1.0 } else { 0.0 };
            Ok(volumes.iter_mut().try_for_each(|v| v.sum_levels(exec, keep, bounce < o.bounces))?)
        })
    }

    /// Half floats for pixels, and what they cost.
    fn pack(&mut self, exec: &mut dyn Executor, clock: &mut StageClock) -> Result<(), MethodError> {
        let ledgers: Vec<Ledger> = self.volumes.iter().map(|v| v.finest().ledger(exec)).collect::<Result<_, _>>()?;
        let largest = ledgers.iter().map(|l| l.largest_passed).fold(0.0, f64::max);
        // A quarter of the range for the largest: coarser levels and bounces add to it.
        let scale = if largest > 0.0 { (1024.0 / largest).log2().floor().exp2() as f32 } else { 1.0 };
        self.query.half_scale = scale;
        let (volumes, packed) = (&self.volumes, &self.packed);
        clock.stage(exec, "pack", |exec| volumes.iter().zip(packed).try_for_each(|(v, p)| v.pack(exec, scale, *p)))?;
        let (mut difference, mut all) = (0.0, 0.0);
        for (volume, &packed) in volumes.iter().zip(packed) {
            let exact = exec.read_slice::<f32>(volume.finest().total())?;
            let words = exec.read_slice::<u32>(packed)?;
            let value = LpvLayout::new(volume.finest().params.dims).value() as usize;
            for (k, number) in exact.iter().enumerate() {
                let (index, element) = (k / value, k % value);
                let (low, high) = unpack_f16x2(words[index / 2 * value + element]);
                let stored = if index % 2 == 0 { low } else { high } / scale;
                difference += f64::from(stored - number).powi(2);
                all += f64::from(*number).powi(2);
            }
        }
        self.report.half_error = (all > 0.0).then(|| (difference / all).sqrt());
        Ok(())
    }
}

/// The voxelized scene, with voxels of half a cell that lie inside cells where there is one grid.
fn voxelize(
    exec: &mut dyn Executor,
    input: &Input<'_>,
    o: &Options,
    (placements, resolution): (&[Placement], u32),
    clock: &mut StageClock,
) -> Result<VoxelScene, MethodError> {
    let emission_max = input.scene.materials.iter().map(|m| m.emission.max_element()).fold(0.0, f32::max);
    let options = VoxelOptions { method: NAME, anisotropic: true, limit_bytes: o.memory_limit_bytes, emission_max };
    let grid = match placements {
        [one] => {
            VoxelGrid { origin: one.anchor_size.truncate(), voxel_size: one.anchor_size.w * 0.5, dims: one.dims * 2 }
        }
        _ => VoxelGrid::around(input.scene.bounds(), 2 * resolution),
    };
    VoxelScene::build(exec, input.buffers, &grid, &options, clock)
}

fn query(o: &Options, volumes: &[Volume]) -> LpvQuery {
    let params = |k: usize| volumes.get(k).map(|v| v.finest().params);
    LpvQuery {
        anchor_size: [0, 1, 2, 3].map(|k| params(k).map_or(Vec4::W, |p| p.anchor_size)),
        first_cell: [0, 1, 2, 3].map(|k| params(k).map_or(IVec4::ZERO, |p| p.first_cell)),
        dims: [0, 1, 2, 3].map(|k| params(k).map_or(UVec4::ZERO, |p| p.dims)),
        cascade_count: volumes.len() as u32,
        count: 0,
        blend: BLEND,
        offset: o.offset,
        half_scale: 1.0,
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
    }
}

/// Largest share of its light that a voxelized surface reflects, in any channel; 1 where nothing is voxelized.
fn brightest(exec: &mut dyn Executor, voxels: Option<&VoxelScene>) -> Result<f64, ExecError> {
    let Some(voxels) = voxels else { return Ok(1.0) };
    let facets = exec.read_slice::<VoxelFacet>(voxels.facets)?;
    let brightest = facets.iter().filter(|f| f.area > 0.0).flat_map(|f| f.albedo).fold(0.0, f32::max);
    Ok(f64::from(brightest))
}

fn check_memory(o: &Options, placements: &[Placement]) -> Result<(), MethodError> {
    let too_large = |needed_bytes, limit_bytes, hint: &str| {
        Err(MethodError::TooLarge { method: NAME, needed_bytes, limit_bytes, hint: hint.into() })
    };
    let largest = placements.iter().map(|at| volume::largest_buffer(at, o.streams)).max().unwrap_or(0);
    if largest > MAX_BINDING_BYTES {
        return too_large(
            largest,
            MAX_BINDING_BYTES,
            "one grid exceeds what a binding may hold; lower `resolution` or `streams`",
        );
    }
    let all: u64 = placements.iter().map(|at| volume::bytes(at, o.streams)).sum();
    if all > o.memory_limit_bytes {
        return too_large(
            all,
            o.memory_limit_bytes,
            "lower `resolution`, `streams` or `cascades`, or raise `memory_limit_mb`",
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_checked() {
        assert!(Options::parse(&Settings::new()).is_ok());
        let bad = [
            ("resolution", "0"),
            ("resolution", "1"),
            ("resolution", "1000"),
            ("rsm", "3"),
            ("iterations", "100000"),
            ("iterations", "-1"),
            ("tolerance", "NaN"),
            ("scheme", "fast"),
            ("centre", "1:2"),
            ("centre", "1:2:inf"),
            ("cascades", "5"),
            ("storage", "f8"),
        ];
        for (key, value) in bad {
            let settings = Settings::from([(key.to_string(), value.to_string())]);
            let error = Options::parse(&settings).unwrap_err().to_string();
            assert!(error.contains(key) && error.contains(value), "{error}");
        }
    }

    #[test]
    fn levels_halve_whole_cells() {
        for (resolution, cube, flat) in
            [(4, 1, 1), (8, 1, 1), (16, 2, 1), (24, 2, 2), (32, 3, 2), (64, 4, 3), (96, 4, 4)]
        {
            let settings = Settings::from([("resolution".to_string(), resolution.to_string())]);
            let o = Options::parse(&settings).unwrap();
            assert_eq!(o.level_count(Vec3::ONE, resolution), cube, "{resolution}");
            let extent = Vec3::new(3.0, 1.0, 2.2);
            assert_eq!(o.level_count(extent, resolution), flat, "{resolution}");
            let at = Placement::around((Vec3::ZERO, extent), resolution, flat);
            assert_eq!(at.dims % (1 << (flat - 1)), glam::UVec3::ZERO);
            let high = at.anchor_size.truncate() + at.dims.as_vec3() * at.anchor_size.w;
            assert!(high.cmpge(Vec3::new(3.0, 1.0, 2.2)).all() && at.anchor_size.truncate().cmplt(Vec3::ZERO).all());
        }
    }
}
