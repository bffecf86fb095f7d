//! Voxel cone tracing on a full grid, of which only occupied voxels hold light: directional mipmaps, a few cones per pixel.
//!
//! Crassin, Neyret, Sainz, Green & Eisemann 2011; thesis on voxel techniques, §4.2. Kernels and deviations:
//! `interreflect_kernels::{voxel, cone}`. Order: voxelize (geometry changed); inject, radiate, mipmap, and for each further
//! bounce cones between voxels, radiate, mipmap (lights changed); cones per pixel (every frame).

mod series;

use self::series::Series;
use super::gaps::{Choice, Rule};
use super::settings::{auto_or, parse};
use super::voxels::{VoxelGrid, VoxelOptions, VoxelScene};
use super::{Input, Method, MethodError, MethodRow, SearchAxis, Setting, Settings, StageClock, Terms, Unit};
use crate::exec::{BufferId, Executor, ExecutorExt};
use glam::{Vec3, Vec4};
use interreflect_kernels::cone::gather::{cone_bounce, cone_gather};
use interreflect_kernels::cone::set::{CONE_COUNTS, cone_parts, diffuse_cones, half_angle_tangent};
use interreflect_shared::cone::ConeParams;
use interreflect_shared::voxel::VoxelFacet;
use serde_json::json;
use std::sync::Arc;

const NAME: &str = "vct";
/// How fine voxels are where nobody says.
///
/// With 8 voxels per gap the error has mostly fallen (Cornell box, gap 0.12 m: 0.106 on blocks at 64, 0.096 at 128; louvres, gap 0.2 m:
/// 0.181 at 64, 0.153 at 128, 0.112 at 192); more than 160 is for users to ask for, because a change of light takes time with the
/// square.
const RULE: Rule = Rule { cells_per_gap: 8.0, resolution: 64..=160 };

/// Row of the methods table.
pub const ROW: MethodRow = MethodRow {
    name: NAME,
    control: false,
    summary: "Voxel cone tracing on a sparse pyramid over a full grid, with six-direction mipmaps and light's further bounces.",
    good_when: "Rooms and courtyards lit by large surfaces; moving lights; soft occlusion.",
    fails_when: "Walls thinner than a voxel, small bright secondary sources, contact shadows.",
    settings: &[
        Setting {
            key: "resolution",
            default: "auto",
            allowed: "auto, or a whole number from 16 to 512",
            help: "Voxels along the longest side. Higher: finer occlusion, less leaking; memory and injection grow with \
                   the square, cones with the logarithm. auto: as many as the narrowest gap or wall that matters needs.",
        },
        Setting {
            key: "mipmaps",
            default: "anisotropic",
            allowed: "anisotropic or isotropic",
            help: "Directions stored in the coarser levels: six keep the lit and the dark side of walls apart; one takes a \
                   sixth of the memory and leaks.",
        },
        Setting {
            key: "cones",
            default: "16",
            allowed: "5, 6, 9 or 16",
            help: "Cones per pixel. More: finer directions, time in proportion.",
        },
        Setting {
            key: "bounces",
            default: "16",
            allowed: "a whole number from 1 to 64",
            help: "Reflections that light makes before it reaches a pixel, at most; they end earlier when they change little \
                   (`converged`). Each after the first takes a pass of cones over all voxels when lights change.",
        },
        Setting {
            key: "converged",
            default: "0.1",
            allowed: "a number from 0 to 1",
            help: "Bounces end when one changes the light on surfaces by less than this share, or no less than the one before \
                   (noise), but for `tail=0`. 0: all of them are made.",
        },
        Setting {
            key: "tail",
            default: "1",
            allowed: "0 or 1",
            help: "1 scales bounced light until its flux is in balance, so that the bounces after the last are not missing; 0 \
                   leaves them out (and the picture too dark where surfaces are bright). Needs 2 bounces.",
        },
        Setting {
            key: "bounce_cones",
            default: "9",
            allowed: "5, 6, 9 or 16",
            help: "Cones per voxel side for further bounces. More: less light that leaks from bounce to bounce; a light change in \
                   proportion.",
        },
        Setting {
            key: "aperture",
            default: "0.3",
            allowed: "a number from 0.05 to 2",
            help: "Size of the voxels that a cone reads, in widths of the cone. Lower: less of a surface's own voxels and of what lies \
                   behind walls, more steps; higher: smoother and faster.",
        },
        Setting {
            key: "offset",
            default: "1",
            allowed: "a number from 0 to 4",
            help: "Start of cones above the surface, in voxels. Lower sees more of corners, and more of the surface itself.",
        },
        Setting {
            key: "clearance",
            default: "1",
            allowed: "a number from 0.05 to 10",
            help: "Size of the voxels that a cone reads, at most, in heights above the surface it leaves. Higher: faster, and \
                   flat cones are darkened by their own surface.",
        },
        Setting {
            key: "jitter",
            default: "1",
            allowed: "0 or 1",
            help: "1 points each cone anywhere in its part of the hemisphere: noise instead of bands, and right on average.",
        },
        Setting {
            key: "light_samples",
            default: "8",
            allowed: "a whole number from 1 to 1024",
            help: "Shadow rays per voxel and emissive triangle. More: less noise in penumbrae.",
        },
        Setting {
            key: "environment_samples",
            default: "8",
            allowed: "a whole number from 0 to 4096",
            help: "Rays per voxel to the environment. More: less noise where the sky is partly hidden; cones \
                   average over many voxels, so that few are enough (Crytek Sponza: the same error with 8 as with 32).",
        },
        Setting {
            key: "memory_limit_mb",
            default: "2048",
            allowed: "a whole number from 1 to 1048576",
            help: "Memory that the method may take, in MiB; more is refused with a message.",
        },
    ],
    ladder: &[
        (
            "32, 5 cones",
            &[("resolution", "32"), ("cones", "5"), ("bounces", "2"), ("bounce_cones", "5"), ("aperture", "1")],
        ),
        (
            "64, 6 cones",
            &[("resolution", "64"), ("cones", "6"), ("bounces", "2"), ("bounce_cones", "5"), ("aperture", "0.5")],
        ),
        (
            "128, 9 cones",
            &[("resolution", "128"), ("cones", "9"), ("bounces", "2"), ("bounce_cones", "6"), ("aperture", "0.5")],
        ),
        ("128, 16 cones", &[("resolution", "128"), ("cones", "16")]),
        ("256, 16 cones", &[("resolution", "256"), ("cones", "16")]),
    ],
    new: |settings| Ok(Box::new(Vct { options: Options::parse(settings)?, state: None })),
};

/// Checked settings.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Options {
    /// `None`: as the scene needs.
    resolution: Option<u32>,
    anisotropic: bool,
    cones: u32,
    bounces: u32,
    converged: f64,
    tail: bool,
    bounce_cones: u32,
    aperture: f32,
    offset: f32,
    clearance: f32,
    jitter: bool,
    light_samples: u32,
    environment_samples: u32,
    memory_limit_bytes: u64,
}

impl Options {
    fn parse(settings: &Settings) -> Result<Self, MethodError> {
        let cones = |n: &u32| CONE_COUNTS.contains(n);
        Ok(Self {
            resolution: auto_or(&ROW, settings, "resolution", |n| (16..=512).contains(n))?,
            anisotropic: parse(&ROW, settings, "mipmaps", |m: &String| m == "anisotropic" || m == "isotropic")?
                == "anisotropic",
            cones: parse(&ROW, settings, "cones", cones)?,
            bounces: parse(&ROW, settings, "bounces", |n| (1..=64).contains(n))?,
            converged: parse(&ROW, settings, "converged", |x| (0.0..=1.0).contains(x))?,
            tail: parse(&ROW, settings, "tail", |n: &u32| *n <= 1)? == 1,
            bounce_cones: parse(&ROW, settings, "bounce_cones", cones)?,
            aperture: parse(&ROW, settings, "aperture", |x| (0.05..=2.0).contains(x))?,
            offset: parse(&ROW, settings, "offset", |x| (0.0..=4.0).contains(x))?,
            clearance: parse(&ROW, settings, "clearance", |x| (0.05..=10.0).contains(x))?,
            jitter: parse(&ROW, settings, "jitter", |n: &u32| *n <= 1)? == 1,
            light_samples: parse(&ROW, settings, "light_samples", |n| (1..=1024).contains(n))?,
            environment_samples: parse(&ROW, settings, "environment_samples", |n| *n <= 4096)?,
            memory_limit_bytes: parse(&ROW, settings, "memory_limit_mb", |n: &u64| (1..=1 << 20).contains(n))? << 20,
        })
    }
}

struct Vct {
    options: Options,
    state: Option<State>,
}

/// What [`Method::precompute`] makes.
struct State {
    resolution: Choice,
    voxels: VoxelScene,
    gather: ConeParams,
    gather_uniform: BufferId,
    bounce: ConeParams,
    bounce_uniform: BufferId,
    /// Flux that each facet reflects per irradiance of either side, over the voxel's face.
    reflecting: Arc<[Vec3]>,
    /// Area of each facet, over the voxel's face.
    areas: Arc<[f32]>,
    bounces: Bounces,
}

/// What the last change of light took.
#[derive(Clone, Copy, Default)]
struct Bounces {
    /// Passes of cones between voxels.
    passes: u32,
    /// What the last of them changed.
    change: Option<f64>,
    /// Share of light that a bounce keeps.
    ratio: Option<f64>,
}

impl State {
    /// Light's further bounces, until they change little.
    fn further_bounces(
        &mut self,
        exec: &mut dyn Executor,
        o: &Options,
        cone_seed: u32,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let direct = exec.read_slice::<Vec4>(self.voxels.direct)?;
        let mut series =
            Series::new(Arc::clone(&self.reflecting), Arc::clone(&self.areas), &direct, o.tail, o.converged);
        for bounce in 2..=o.bounces {
            // Every bounce points the cones anew, so that their errors do not add up.
            let params = ConeParams { seed: cone_seed.wrapping_mul(bounce), ..self.bounce };
            exec.write(self.bounce_uniform, bytemuck::bytes_of(&params))?;
            let mut settled = false;
            clock.stage(exec, &format!("bounce {bounce}"), |exec| {
                let [a, b, c, d, e, f] = self.pyramid();
                exec.run(&cone_bounce::KERNEL, &[self.bounce_uniform, a, b, c, d, e, f, self.voxels.bounced])?;
                let step = series.step(&exec.read_slice::<Vec4>(self.voxels.bounced)?);
                self.voxels.set_bounce_gain(exec, step.gain)?;
                settled = step.settled;
                self.bounces = Bounces { passes: bounce - 1, change: Some(step.change), ratio: series.ratio() };
                self.voxels.radiate(exec)
            })?;
            clock.stage(exec, "mipmap", |exec| self.voxels.mipmap(exec))?;
            if settled {
                break;
            }
        }
        Ok(())
    }

    fn pyramid(&self) -> [BufferId; 6] {
        let v = &self.voxels;
        [v.cells, v.facet_bits, v.facets, v.radiance, v.odd, v.even]
    }
}

impl Vct {
    fn cone_params(&self, voxels: &VoxelScene, cones: u32) -> ConeParams {
        let o = &self.options;
        ConeParams {
            origin_size: voxels.params.origin_size,
            dims_levels: voxels.params.dims_levels,
            levels: voxels.params.levels,
            cones: diffuse_cones(cones),
            parts: cone_parts(cones),
            beyond: Vec4::ZERO,
            camera: Vec4::ZERO,
            cone_count: cones,
            direction_count: voxels.params.direction_count,
            count: 2 * voxels.params.facet_count,
            seed: 0,
            spread: 2.0 * half_angle_tangent(cones) * o.aperture,
            offset: o.offset,
            clearance: o.clearance,
            _pad: 0.0,
        }
    }

    /// A seed that is not 0, which would leave the cones in place.
    fn cone_seed(&self, seed: u32) -> u32 {
        if self.options.jitter { seed | 1 << 31 } else { 0 }
    }

    fn state(&mut self) -> Result<&mut State, MethodError> {
        self.state.as_mut().ok_or(MethodError::NotPrecomputed { method: NAME })
    }
}

impl Method for Vct {
    fn precompute(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let o = self.options;
        let emission_max = input.scene.materials.iter().map(|m| m.emission.max_element()).fold(0.0, f32::max);
        let options =
            VoxelOptions { method: NAME, anisotropic: o.anisotropic, limit_bytes: o.memory_limit_bytes, emission_max };
        let resolution = RULE.choose(o.resolution, exec, input, clock)?;
        let grid = VoxelGrid::around(input.scene.bounds(), resolution.resolution);
        let voxels = VoxelScene::build(exec, input.buffers, &grid, &options, clock)?;
        let gather = self.cone_params(&voxels, o.cones);
        let bounce = self.cone_params(&voxels, o.bounce_cones);
        let facets = exec.read_slice::<VoxelFacet>(voxels.facets)?;
        let reflecting = facets.iter().map(|f| Vec3::from(f.albedo) * f.area).collect();
        let areas = facets.iter().map(|f| f.area).collect();
        let gather_uniform = exec.upload_one("cone parameters", &gather)?;
        let bounce_uniform = exec.upload_one("bounce parameters", &bounce)?;
        self.state = Some(State {
            resolution,
            voxels,
            gather,
            gather_uniform,
            bounce,
            bounce_uniform,
            reflecting,
            areas,
            bounces: Bounces::default(),
        });
        Ok(())
    }

    fn retune(&mut self, settings: &Settings) -> bool {
        let voxels_of = |o: &Options| (o.resolution, o.anisotropic, o.memory_limit_bytes);
        let Ok(options) = Options::parse(settings) else { return false };
        let Some(mut state) = self.state.take() else { return false };
        let alike = voxels_of(&options) == voxels_of(&self.options);
        if alike {
            self.options = options;
            state.gather = self.cone_params(&state.voxels, options.cones);
            state.bounce = self.cone_params(&state.voxels, options.bounce_cones);
        }
        self.state = Some(state);
        alike
    }

    fn light_change(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let o = self.options;
        let cone_seed = self.cone_seed(input.seed);
        let state = self.state()?;
        state.bounces = Bounces::default();
        clock.stage(exec, "inject", |exec| {
            state.voxels.inject(exec, input, o.light_samples, o.environment_samples)?;
            state.voxels.radiate(exec)
        })?;
        clock.stage(exec, "mipmap", |exec| state.voxels.mipmap(exec))?;
        if o.bounces > 1 { state.further_bounces(exec, &o, cone_seed, clock) } else { Ok(()) }
    }

    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let seed = self.cone_seed(input.seed);
        let state = self.state()?;
        let count = (exec.size_bytes(irradiance) / size_of::<Vec4>() as u64) as u32;
        exec.write(state.gather_uniform, bytemuck::bytes_of(&ConeParams { count, seed, ..state.gather }))?;
        clock.stage(exec, "cones", |exec| {
            let [a, b, c, d, e, f] = state.pyramid();
            Ok(exec.run(&cone_gather::KERNEL, &[state.gather_uniform, a, b, c, d, e, f, gbuffer, irradiance])?)
        })
    }

    fn needs(&self) -> serde_json::Value {
        let Some(state) = &self.state else { return serde_json::Value::Null };
        let mut needs = state.voxels.needs();
        needs["resolution"] = json!(state.resolution);
        needs["bounces"] = json!(1 + state.bounces.passes);
        needs["last_bounce_changed"] = json!(state.bounces.change);
        needs["bounce_ratio"] = json!(state.bounces.ratio);
        needs["cone_half_angle_rad"] = json!(half_angle_tangent(self.options.cones).atan());
        needs
    }

    fn unit(&self) -> Option<Unit> {
        Some(Unit { name: "voxels", metres: self.state.as_ref()?.voxels.params.origin_size.w })
    }

    fn feedback_gain(&self) -> Option<f64> {
        self.state.as_ref()?.bounces.ratio
    }

    fn terms(&self) -> Vec<Terms> {
        self.feedback_gain().map(|ratio| Terms::geometric("bounces", "bounces", ratio)).into_iter().collect()
    }

    fn search(&self) -> &'static [SearchAxis] {
        const AXES: &[SearchAxis] = &[
            SearchAxis {
                key: "resolution",
                values: &["24", "32", "48", "64", "96", "128", "192", "256", "384", "512"],
            },
            SearchAxis { key: "bounces", values: &["1", "2", "3", "4", "6", "16"] },
            SearchAxis { key: "cones", values: &["5", "6", "9", "16"] },
            SearchAxis { key: "bounce_cones", values: &["5", "6", "9", "16"] },
            SearchAxis { key: "aperture", values: &["2", "1", "0.5", "0.3", "0.2"] },
            SearchAxis { key: "light_samples", values: &["1", "2", "4", "8", "16"] },
            SearchAxis { key: "environment_samples", values: &["4", "8", "16", "32", "64"] },
            SearchAxis { key: "mipmaps", values: &["isotropic", "anisotropic"] },
            SearchAxis { key: "tail", values: &["0", "1"] },
        ];
        AXES
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_checked() {
        assert!(Options::parse(&Settings::new()).is_ok());
        for (key, value) in [("resolution", "8"), ("cones", "7"), ("mipmaps", "trilinear"), ("offset", "NaN")] {
            let settings = Settings::from([(key.to_string(), value.to_string())]);
            let error = Options::parse(&settings).unwrap_err().to_string();
            assert!(error.contains(key) && error.contains(value), "{error}");
        }
        for (_, changes) in ROW.ladder {
            let settings: Settings = changes.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect();
            assert!(Options::parse(&settings).is_ok());
            assert!(changes.iter().all(|(k, _)| ROW.settings.iter().any(|s| s.key == *k)));
        }
    }
}
