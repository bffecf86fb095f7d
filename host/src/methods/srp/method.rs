//! SRP as a method: settings, precomputation, light change, pixels.

use super::atlas::Lookup;
use super::feedback::Feedback;
use super::model::{Blend, SrpBake};
use super::runtime::{Points, RuntimeOptions, SrpRuntime};
use super::{BakeOptions, Compression, Memo, NAME, Placement, Plan, Window, estimate, file};
use crate::exec::{BufferId, Executor, ExecutorExt};
use crate::methods::settings::parse;
use crate::methods::{
    Input, Method, MethodError, MethodRow, SearchAxis, SetUp, Setting, Settings, SharedParts, StageClock, Terms, Unit,
};
use glam::Vec3;
use interreflect_kernels::math::sh;
use interreflect_shared::scene::{NO_SURFACE, SceneTriangle, Surfel};
use interreflect_shared::trace::DirectParams;
use rayon::prelude::*;
use serde_json::json;
use std::path::Path;
use std::sync::Arc;

/// Row of the methods table.
pub const ROW: MethodRow = MethodRow {
    name: NAME,
    control: false,
    summary: "Sparse radiance probes: few probes gather light, precomputed local transport that knows what each of them \
              sees brings it to every lightmap texel.",
    good_when: "Static rooms with moving lights: soft indirect light and shadows near the truth at a small cost per frame.",
    fails_when: "Geometry moves; a small bright patch lies closer to its receivers than to a probe; there is no time to bake.",
    settings: &[
        Setting {
            key: "file",
            default: "",
            allowed: "a file that `bake` made, or nothing",
            help: "Baked transport to use; what follows up to `rows` is then the file's. Nothing: bake now.",
        },
        Setting {
            key: "receivers",
            default: "8192",
            allowed: "from 64 to 16777216",
            help: "Lightmap texels, about. More: finer indirect shadows; baking, memory and each update in proportion.",
        },
        Setting {
            key: "probes",
            default: "27",
            allowed: "from 1 to 65536",
            help: "Probes. More: less blur where light changes over short distances; projection in proportion.",
        },
        Setting {
            key: "order",
            default: "7",
            allowed: "from 0 to 9",
            help: "Order of the probes' spherical harmonics, (order + 1)² coefficients. Higher: sharper light from far probes.",
        },
        Setting {
            key: "order_error",
            default: "0.005",
            allowed: "from 0 to 1",
            help: "Share of what reaches a cluster's receivers that may be lost with the highest bands of its probes: each has the order \
                   that this takes. 0: all have the whole `order`. Higher: less memory, less contrast.",
        },
        Setting {
            key: "window",
            default: "none",
            allowed: "`none`, `hanning` or `lanczos`",
            help: "Window on the bands of what probes see. `lanczos`, and more so `hanning`: less ringing beside small bright \
                   lights, less contrast everywhere. The window widens with the order.",
        },
        Setting {
            key: "rays",
            default: "512",
            allowed: "from 16 to 65536",
            help: "Baking rays per receiver. More: less error of the transport; baking in proportion.",
        },
        Setting {
            key: "relight_rays",
            default: "2048",
            allowed: "from 16 to 65536",
            help: "Rays per probe that look up light at run time. More: small sources are not missed; projection in proportion.",
        },
        Setting {
            key: "overlap",
            default: "10",
            allowed: "from 1 to 64",
            help: "Probes in whose support a receiver lies on average. More: smoother, more of the surroundings seen; memory.",
        },
        Setting {
            key: "placement",
            default: "volume",
            allowed: "`volume` or `surface`",
            help: "Where probes may stand: anywhere open, or beside surfaces alone.",
        },
        Setting {
            key: "correction",
            default: "0.01",
            allowed: "from 0 to 1",
            help: "Ridge of the correction of transport by its own round trip; 0: none. Lower: more contrast near walls, and more \
                   noise; each receiver follows it as far as that helps in lighting that was kept back.",
        },
        Setting {
            key: "visibility",
            default: "texels",
            allowed: "`texels` or `rays`",
            help: "Whether probes see a lightmap texel is asked once where all of it agrees, or for every ray.",
        },
        Setting {
            key: "added_probes",
            default: "4",
            allowed: "from 0 to 16",
            help: "Most probes that may be added, as a share of `probes`, while more than one receiver in 200 sees none. More: \
                   fewer dark corners; projection in proportion to those that are added.",
        },
        Setting {
            key: "compression",
            default: "cpca",
            allowed: "`cpca`, `dictionary` or `none`",
            help: "Clustered principal components, a dictionary learnt per cluster, or the transport as it is.",
        },
        Setting {
            key: "metric",
            default: "light",
            allowed: "`light` or `matrix`",
            help: "What principal components keep: the light that reaches receivers, or every number of the transport.",
        },
        Setting {
            key: "atoms",
            default: "96",
            allowed: "from 1 to 256",
            help: "Atoms of a cluster's dictionary. More: less error; memory and projection in proportion.",
        },
        Setting {
            key: "sparsity",
            default: "8",
            allowed: "from 1 to 64",
            help: "Atoms of the dictionary that one row uses. More: less error; memory in proportion.",
        },
        Setting {
            key: "error",
            default: "0.005",
            allowed: "from 0 to 1",
            help: "Relative error of a cluster's transport at which components end. Lower: more of them.",
        },
        Setting {
            key: "max_rank",
            default: "32",
            allowed: "from 1 to 256",
            help: "Components per cluster at most; clusters that need more are halved.",
        },
        Setting {
            key: "noise",
            default: "0.5",
            allowed: "from 0 to 4",
            help: "Components also end where the error is this many times what a cluster's transport errs by for want of `rays`; 0: \
                   at `error` alone. Higher: less memory, faster updates.",
        },
        Setting {
            key: "rows",
            default: "1",
            allowed: "1 or 4",
            help: "1: irradiance. 4: order 1 of incident radiance, for normal maps, at four times the memory.",
        },
        Setting {
            key: "bounces",
            default: "32",
            allowed: "from 1 to 256",
            help: "Indirect bounces at most; it ends earlier when they change nothing.",
        },
        Setting {
            key: "tail",
            default: "1",
            allowed: "0 or 1",
            help: "1: where light would need more than `bounces` (at least 4), what all of them would add is told from the last. 0: cut off.",
        },
        Setting {
            key: "light_samples",
            default: "16",
            allowed: "from 1 to 1024",
            help: "Shadow rays to each emissive triangle at each receiver.",
        },
        Setting {
            key: "environment_samples",
            default: "64",
            allowed: "from 0 to 4096",
            help: "Rays to the environment at each receiver. More: less noise where it is partly hidden.",
        },
    ],
    ladder: &[
        ("4k texels, 8 probes, order 3", &[("receivers", "4096"), ("probes", "8"), ("order", "3"), ("rays", "256")]),
        ("8k texels, 27 probes, order 4", &[("order", "4"), ("rays", "256")]),
        ("8k texels, 27 probes, order 7", &[]),
        ("16k texels, 64 probes, order 7", &[("receivers", "16384"), ("probes", "64")]),
        (
            "40k texels, 64 probes, order 7",
            &[("receivers", "40960"), ("probes", "64"), ("rays", "1024"), ("relight_rays", "4096")],
        ),
        (
            "40k texels, 125 probes, order 9",
            &[("receivers", "40960"), ("probes", "125"), ("order", "9"), ("rays", "1024"), ("relight_rays", "8192")],
        ),
    ],
    new: |settings| Ok(Box::new(Srp { options: Options::parse(settings)?, state: None, memo: None })),
};

/// Bounces end when the slowest mode of the loop has fallen to this share.
const CONVERGED: f64 = 1e-4;
/// Share of a probe's energy that counts as all of it.
const ENERGY: f64 = 0.999;
/// Iterations by which the gain of the loop is measured.
const GAIN_ITERATIONS: u32 = 24;

/// What settings of the method mean for a bake.
///
/// # Errors
/// [`MethodError::BadValue`].
pub fn bake_options(settings: &Settings) -> Result<BakeOptions, MethodError> {
    Ok(Options::parse(settings)?.bake)
}

/// Checked settings.
struct Options {
    /// A baked file instead of baking.
    file: String,
    bake: BakeOptions,
    bounces: u32,
    tail: bool,
    light_samples: u32,
    environment_samples: u32,
}

impl Options {
    fn parse(settings: &Settings) -> Result<Self, MethodError> {
        let placement: String = parse(&ROW, settings, "placement", |p: &String| p == "volume" || p == "surface")?;
        let error = parse(&ROW, settings, "error", |x| (0.0..=1.0).contains(x))?;
        let max_rank = parse(&ROW, settings, "max_rank", |n| (1..=256).contains(n))?;
        let noise = parse(&ROW, settings, "noise", |x| (0.0..=4.0).contains(x))?;
        let compression: String =
            parse(&ROW, settings, "compression", |c: &String| ["cpca", "dictionary", "none"].contains(&c.as_str()))?;
        let metric: String = parse(&ROW, settings, "metric", |m: &String| m == "light" || m == "matrix")?;
        let atoms = parse(&ROW, settings, "atoms", |n| (1..=256).contains(n))?;
        let sparsity = parse(&ROW, settings, "sparsity", |n| (1..=64).contains(n))?;
        let window: String =
            parse(&ROW, settings, "window", |w: &String| ["none", "hanning", "lanczos"].contains(&w.as_str()))?;
        let visibility: String = parse(&ROW, settings, "visibility", |v: &String| v == "texels" || v == "rays")?;
        Ok(Self {
            file: parse(&ROW, settings, "file", |_: &String| true)?,
            bake: BakeOptions {
                receivers: parse(&ROW, settings, "receivers", |n| (64..=1 << 24).contains(n))?,
                probes: parse(&ROW, settings, "probes", |n| (1..=1 << 16).contains(n))?,
                order: parse(&ROW, settings, "order", |n| *n <= 9)?,
                order_error: parse(&ROW, settings, "order_error", |x| (0.0..=1.0).contains(x))?,
                window: match window.as_str() {
                    "hanning" => Window::Hanning,
                    "lanczos" => Window::Lanczos,
                    _ => Window::None,
                },
                rays: parse(&ROW, settings, "rays", |n| (16..=1 << 16).contains(n))?,
                relight_rays: parse(&ROW, settings, "relight_rays", |n| (16..=1 << 16).contains(n))?,
                overlap: parse(&ROW, settings, "overlap", |x| (1.0..=64.0).contains(x))?,
                placement: if placement == "volume" { Placement::Volume } else { Placement::Surface },
                compression: match compression.as_str() {
                    "none" => Compression::None,
                    "dictionary" => Compression::Dictionary { atoms, sparsity },
                    _ => Compression::Cpca { error, max_rank, noise },
                },
                ridge: parse(&ROW, settings, "correction", |x| (0.0..=1.0).contains(x))?,
                light_metric: metric == "light",
                texel_visibility: visibility == "texels",
                added_probes: parse(&ROW, settings, "added_probes", |x| (0.0..=16.0).contains(x))?,
                rows: parse(&ROW, settings, "rows", |n| *n == 1 || *n == 4)?,
                ..BakeOptions::default()
            },
            bounces: parse(&ROW, settings, "bounces", |n| (1..=256).contains(n))?,
            tail: parse(&ROW, settings, "tail", |n: &u32| *n <= 1)? == 1,
            light_samples: parse(&ROW, settings, "light_samples", |n| (1..=1024).contains(n))?,
            environment_samples: parse(&ROW, settings, "environment_samples", |n| *n <= 4096)?,
        })
    }
}

struct Srp {
    options: Options,
    state: Option<State>,
    /// Parts of bakes that it shares with others; without it they are gone once baking is done.
    memo: Option<Arc<Memo>>,
}

/// What [`Method::precompute`] makes.
struct State {
    lookup: Lookup,
    runtime: SrpRuntime,
    /// The scene's triangle of each device triangle, and its corners.
    triangles: Vec<(u32, [Vec3; 3])>,
    /// Pixels of the last frame.
    points: Option<(usize, Points)>,
    feedback: Feedback,
    texel_m: f32,
    report: serde_json::Value,
    /// SH coefficients per probe.
    coefficient_count: usize,
    /// By order: part of the probes' light, as amplitude, that the bands beyond it carry.
    beyond_order: Vec<(u32, f64)>,
    /// Frames for which nothing but their own pixels was computed.
    idle_frames: u32,
    /// Whether light has changed since the last frame.
    changed: bool,
}

impl Method for Srp {
    fn precompute(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let (bake, lookup, report) = self.baked(exec, input, clock)?;
        let triangle = |t: &SceneTriangle| (t.source, input.scene.corners(&input.scene.triangles[t.source as usize]));
        let triangles = exec.read_slice::<SceneTriangle>(input.buffers.triangles)?.iter().map(triangle).collect();
        let mut runtime = SrpRuntime::new(exec, &bake, &RuntimeOptions::default())?;
        let feedback = runtime.keep_below_one(exec, GAIN_ITERATIONS)?;
        if feedback.alarm {
            let gain = feedback.spectral_radius;
            tell!("warning: srp: bounces would gain light ({gain:.3} per bounce); the loop is damped");
        }
        let texel_m = lookup.atlas().texel_size;
        let coefficient_count = bake.coefficient_count();
        self.state = Some(State {
            lookup,
            runtime,
            triangles,
            points: None,
            feedback,
            texel_m,
            report,
            coefficient_count,
            beyond_order: Vec::new(),
            idle_frames: 0,
            changed: true,
        });
        Ok(())
    }

    fn share(&mut self, parts: &mut SharedParts) {
        let memo = parts.get_or_insert_with(|| Arc::new(Memo::default()));
        self.memo = memo.clone().downcast().ok();
    }

    fn set_up(&self, exec: &mut dyn Executor, input: &Input<'_>) -> Result<Option<SetUp>, MethodError> {
        if !self.options.file.is_empty() {
            return Ok(None);
        }
        let options = BakeOptions { seed: input.seed, ..self.options.bake.clone() };
        let own = Memo::default();
        estimate::set_up(exec, input, &options, self.memo.as_deref().unwrap_or(&own)).map(Some)
    }

    fn retune(&mut self, settings: &Settings) -> bool {
        let baked_alike = |o: &Options| o.file == self.options.file && o.bake == self.options.bake;
        match Options::parse(settings) {
            Ok(options) if baked_alike(&options) => {
                self.options = options;
                true
            }
            _ => false,
        }
    }

    fn light_change(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let (most, tail, params) = (self.options.bounces, self.options.tail, self.direct_params(input));
        // A file has an order of its own.
        let asked = if self.options.file.is_empty() { self.options.bake.order } else { 0 };
        let state = self.state()?;
        // As many bounces as the slowest mode needs to fall below what is seen.
        let gain = state.feedback.spectral_radius.clamp(1e-3, 0.999);
        let bounces = (CONVERGED.ln() / gain.ln()).ceil().max(1.0) as u32;
        state.runtime.set_bounces(bounces.min(most));
        state.runtime.restart(exec)?;
        clock.stage(exec, "direct", |exec| state.runtime.light(exec, input.buffers, &params))?;
        let handed_on = if tail && bounces > most {
            Some(state.runtime.update_with_tail(exec, clock)?)
        } else {
            state.runtime.update(exec, most, clock)?;
            None
        };
        state.report["bounces"] = json!(bounces.min(most));
        state.report["handed_on_by_later_bounces"] = json!(handed_on);
        let coefs: Vec<f32> = exec.read_slice(state.runtime.coefficients_buffer())?;
        state.report["probes_by_order"] = json!(probes_by_order(&coefs, state.coefficient_count, asked));
        state.beyond_order = beyond_order(&coefs, state.coefficient_count, asked);
        state.changed = true;
        Ok(())
    }

    fn frame(
        &mut self,
        exec: &mut dyn Executor,
        _: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        clock: &mut StageClock,
    ) -> Result<(), MethodError> {
        let state = self.state()?;
        state.idle_frames += u32::from(!std::mem::replace(&mut state.changed, false));
        clock.stage(exec, "texels of pixels", |exec| {
            let surfels = exec.read_slice::<Surfel>(gbuffer)?;
            let blends: Vec<Blend> = surfels.par_iter().map(|s| state.blend(s)).collect();
            match &state.points {
                Some((count, points)) if *count == blends.len() => state.runtime.set_points(exec, points, &blends),
                _ => {
                    state.points = Some((blends.len(), state.runtime.points(exec, &blends)?));
                    Ok(())
                }
            }
        })?;
        clock.stage(exec, "resolve", |exec| match &state.points {
            Some((_, points)) => state.runtime.resolve(exec, points, irradiance),
            None => Ok(()),
        })?;
        Ok(())
    }

    fn unit(&self) -> Option<Unit> {
        Some(Unit { name: "texels", metres: self.state.as_ref()?.texel_m })
    }

    fn feedback_gain(&self) -> Option<f64> {
        Some(self.state.as_ref()?.feedback.spectral_radius)
    }

    /// Irradiance at the receivers, of which pixels cut off what is negative.
    fn lowest_uncut(&self, exec: &mut dyn Executor) -> Result<Option<[f64; 2]>, MethodError> {
        let Some(state) = &self.state else { return Ok(None) };
        let values = state.runtime.read_irradiance(exec)?;
        let lowest = values.iter().map(|v| f64::from(v.min_element())).fold(0.0, f64::min);
        let sum: f64 = values.iter().map(|v| f64::from(v.element_sum())).sum();
        Ok(Some([lowest, sum / (3 * values.len().max(1)) as f64]))
    }

    fn terms(&self) -> Vec<Terms> {
        let Some(state) = &self.state else { return Vec::new() };
        let bounces = Terms::geometric("bounces", "bounces", state.feedback.spectral_radius);
        let bands = Terms { key: "order", name: "bands", beyond: state.beyond_order.clone() };
        vec![bounces, bands]
    }

    fn search(&self) -> &'static [SearchAxis] {
        const AXES: &[SearchAxis] = &[
            SearchAxis { key: "receivers", values: &["2048", "4096", "8192", "16384", "40960"] },
            SearchAxis { key: "probes", values: &["8", "27", "64", "125"] },
            SearchAxis { key: "order", values: &["2", "3", "4", "5", "7", "9"] },
            SearchAxis { key: "relight_rays", values: &["512", "1024", "2048", "4096", "8192"] },
            SearchAxis { key: "error", values: &["0.02", "0.01", "0.005", "0.002"] },
            SearchAxis { key: "light_samples", values: &["4", "8", "16"] },
            SearchAxis { key: "rays", values: &["128", "256", "512", "1024"] },
            SearchAxis { key: "overlap", values: &["5", "10", "20"] },
        ];
        AXES
    }

    fn needs(&self) -> serde_json::Value {
        let Some(state) = &self.state else { return serde_json::Value::Null };
        let mut needs = state.report.clone();
        needs["run_time"] = state.runtime.needs();
        needs["frames_without_update"] = json!(state.idle_frames);
        needs
    }
}

impl Srp {
    fn state(&mut self) -> Result<&mut State, MethodError> {
        self.state.as_mut().ok_or(MethodError::NotPrecomputed { method: NAME })
    }

    /// The bake of the scene, from its file or made now, and what is said of it.
    fn baked(
        &self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<(SrpBake, Lookup, serde_json::Value), MethodError> {
        let (mut plan, mut baked) = (None, None);
        if !self.options.file.is_empty() {
            clock.stage(exec, "file", |_| {
                let (bake, lookup) = file::load(Path::new(&self.options.file), input.scene)?;
                let about = json!({ "file": self.options.file, "receivers": bake.receivers.len(), "probes": bake.probes.len() });
                baked = Some((bake, lookup, about));
                Ok::<(), MethodError>(())
            })?;
        } else {
            let options = BakeOptions { seed: input.seed, ..self.options.bake.clone() };
            clock.stage(exec, "plan", |_| {
                plan = Some(match &self.memo {
                    Some(memo) => Plan::sharing(input.scene, &options, memo)?,
                    None => Plan::new(input.scene, &options)?,
                });
                Ok::<(), MethodError>(())
            })?;
            clock.spared_ms += plan.as_ref().map_or(0.0, |plan| plan.spared_ms);
            clock.stage(exec, "transport", |_| {
                baked = plan.as_ref().map(|plan| {
                    let (bake, lookup) = plan.bake();
                    let report = plan.report(&bake);
                    (bake, lookup, report)
                });
                Ok::<(), MethodError>(())
            })?;
        }
        Ok(baked.expect("one of the two stages ran"))
    }

    fn direct_params(&self, input: &Input<'_>) -> DirectParams {
        let lit = input.scene.environment.max_element() > 0.0;
        DirectParams {
            environment: input.scene.environment.extend(0.0),
            count: 0,
            light_count: input.buffers.light_count,
            light_samples: self.options.light_samples,
            environment_samples: if lit { self.options.environment_samples } else { 0 },
            pick_above: 64,
            seed: input.seed,
            _pad0: 0,
            _pad1: 0,
        }
    }
}

/// Number of probes by the lowest order that holds [`ENERGY`] of their light's energy: what an order per probe would need.
/// `coefs` in planes `[channel][probe][k]`; probes without light are left out. Up to the `asked` order, though no more than `k`
/// coefficients are projected to.
fn probes_by_order(coefs: &[f32], k: usize, asked: u32) -> Vec<u32> {
    let plane = coefs.len() / 3;
    let mut counts = vec![0; sh::band(k.max(1) - 1).max(asked) as usize + 1];
    for probe in (0..plane / k.max(1)).map(|p| p * k) {
        let energy =
            |c: usize| (0..3).map(|channel| f64::from(coefs[channel * plane + probe + c]).powi(2)).sum::<f64>();
        let total: f64 = (0..k).map(energy).sum();
        let mut sum = 0.0;
        let needed = (0..k).find(|c| {
            sum += energy(*c);
            sum >= ENERGY * total
        });
        if let Some(c) = needed.filter(|_| total > 0.0) {
            counts[sh::band(c) as usize] += 1;
        }
    }
    counts
}

/// By order, up to the `asked` one: the part of the probes' light, as amplitude over all probes, that the bands beyond it carry.
/// Of what lies beyond the last band nothing is known; bands fall, so that the last one's share stands for the next.
fn beyond_order(coefs: &[f32], k: usize, asked: u32) -> Vec<(u32, f64)> {
    let order = sh::band(k.max(1) - 1);
    let mut energies = vec![0.0; order as usize + 1];
    for (c, value) in coefs.iter().enumerate() {
        energies[sh::band(c % k.max(1)) as usize] += f64::from(*value).powi(2);
    }
    let total: f64 = energies.iter().sum();
    if total <= 0.0 {
        return Vec::new();
    }
    let beyond = |l: u32| energies.iter().skip(l as usize + 1).sum::<f64>();
    let last = energies[order as usize];
    (0..=order.max(asked)).map(|l| (l, (if l < order { beyond(l) } else { last } / total).sqrt())).collect()
}

impl State {
    /// The receivers around a pixel's surface point.
    fn blend(&self, s: &Surfel) -> Blend {
        if s.triangle == NO_SURFACE {
            return Blend::NONE;
        }
        let (source, [a, b, c]) = self.triangles[s.triangle as usize];
        let position = Vec3::from(s.position);
        let (e1, e2, p) = (b - a, c - a, position - a);
        let n = e1.cross(e2);
        let scale = 1.0 / n.length_squared().max(f32::MIN_POSITIVE);
        let (v, w) = (p.cross(e2).dot(n) * scale, e1.cross(p).dot(n) * scale);
        self.lookup.blend(source, [1.0 - v - w, v, w], s.front == 1, position, s.geometric_normal.into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn probes_are_counted_by_the_order_they_need() {
        // One probe of constant light, one with a band of its own, one dark; a channel each.
        let mut coefs = vec![0.0; 3 * 3 * 9];
        coefs[0] = 2.0;
        coefs[27 + 9 + 5] = 1.0;
        assert_eq!(probes_by_order(&coefs, 9, 2), [1, 0, 1]);
        assert_eq!(probes_by_order(&coefs, 9, 3), [1, 0, 1, 0]);
    }

    #[test]
    fn what_lies_beyond_an_order_is_the_energy_of_its_bands() {
        // One probe, one channel: band 0 carries 16 parts, band 1 8, band 2 1.
        let mut coefs = vec![0.0; 27];
        (coefs[0], coefs[2], coefs[5]) = (4.0, 8f32.sqrt(), 1.0);
        let beyond = beyond_order(&coefs, 9, 2);
        for ((order, got), expected) in beyond.iter().zip([9.0 / 25.0_f64, 1.0 / 25.0, 1.0 / 25.0]) {
            assert!((got - expected.sqrt()).abs() < 1e-6, "{order}: {got}");
        }
        assert!(beyond_order(&[0.0; 27], 9, 2).is_empty());
        // Bands that were not projected to are as the last one.
        assert_eq!(beyond_order(&coefs, 9, 4)[3..], [(3, beyond[2].1), (4, beyond[2].1)]);
    }

    #[test]
    fn settings_are_checked() {
        assert!(Options::parse(&Settings::new()).is_ok());
        for (key, value) in [("order", "10"), ("probes", "0"), ("rows", "2"), ("placement", "grid"), ("error", "NaN")] {
            let settings = Settings::from([(key.to_string(), value.to_string())]);
            let error = Options::parse(&settings).err().map(|e| e.to_string()).unwrap_or_default();
            assert!(error.contains(key) && error.contains(value), "{error}");
        }
    }
}
