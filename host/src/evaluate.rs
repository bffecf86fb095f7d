//! Runs a method on a view and times it: what `render`, `compare` and later charts are made of.

use crate::exec::{BufferId, DeviceInfo, ExecError, Executor, ExecutorExt, Mark};
use crate::image_io::Image;
use crate::methods::{Input, Method, MethodError, MethodRow, Phase, Settings, SharedParts, StageClock, Terms};
use crate::metrics::ErrorMetrics;
use crate::report::{self, Frame, MemoryBytes, MethodResult, TimeMs, TimeSpread};
use crate::scene::device::SceneBuffers;
use crate::scene::{Camera, Scene};
use crate::shading::{self, DirectSettings};
use glam::{Vec3, Vec4};
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use std::f32::consts::FRAC_1_PI;
use std::time::Instant;

/// What every method is given for a picture: the visible points and their direct light.
pub struct View {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// One [`Surfel`] per pixel, in the executor.
    pub gbuffer: BufferId,
    /// The same, read back.
    pub surfels: Vec<Surfel>,
    /// Emission, and light reflected once, towards the camera (W/(sr m²)).
    pub direct: Image,
    /// Time of the primary rays (ms).
    pub gbuffer_ms: f64,
    /// Time of the direct light (ms).
    pub direct_ms: f64,
}

impl View {
    /// Finds the visible points of a camera and lights them directly.
    ///
    /// # Errors
    /// What the executor says.
    pub fn new(
        exec: &mut dyn Executor,
        scene: &Scene,
        buffers: &SceneBuffers,
        camera: &Camera,
        (width, height): (u32, u32),
        seed: u32,
    ) -> Result<Self, ExecError> {
        let count = width * height;
        exec.begin();
        let gbuffer = shading::gbuffer(exec, buffers, camera, width, height, scene.environment)?;
        let gbuffer_ms = exec.end()?;
        exec.begin();
        let settings = DirectSettings { seed, ..DirectSettings::default() };
        let irradiance = shading::direct(exec, buffers, gbuffer, count, scene.environment, &settings)?;
        let direct_ms = exec.end()?;
        let no_indirect = exec.zeroed_slice::<Vec4>("no indirect light", count as usize)?;
        let radiance = shading::compose(exec, gbuffer, irradiance, no_indirect, count)?;
        let pixels: Vec<Vec4> = exec.read_slice(radiance)?;
        for buffer in [radiance, no_indirect, irradiance] {
            exec.free(buffer);
        }
        let direct = picture(width, height, |k| pixels[k].truncate());
        Ok(Self { width, height, gbuffer, surfels: exec.read_slice(gbuffer)?, direct, gbuffer_ms, direct_ms })
    }

    /// Which pixels show a surface.
    pub fn visible(&self) -> Vec<bool> {
        self.surfels.iter().map(|s| s.triangle != NO_SURFACE).collect()
    }

    /// A picture of one value per pixel.
    pub fn image(&self, value: impl Fn(usize) -> Vec3) -> Image {
        picture(self.width, self.height, value)
    }

    /// The pictures that an indirect irradiance makes: reflected towards the camera it is albedo/π times as much radiance.
    pub fn frame(&self, irradiance: &[Vec4]) -> Frame {
        let reflected = |k: usize| Vec3::from(self.surfels[k].albedo) * FRAC_1_PI * irradiance[k].truncate();
        Frame {
            direct: self.direct.clone(),
            indirect: self.image(reflected),
            full: self.image(|k| self.direct.pixels()[k] + reflected(k)),
            irradiance: self.image(|k| irradiance[k].truncate()),
        }
    }
}

fn picture(width: u32, height: u32, value: impl Fn(usize) -> Vec3) -> Image {
    let pixels = (0..width as usize * height as usize).map(value).collect();
    Image::new(width, height, pixels).expect("a view has at least one pixel, and one value for each")
}

/// How often each phase of a method runs.
#[derive(Clone, Copy, Debug)]
pub struct Repeats {
    /// Counted runs after one warm-up.
    pub count: u32,
    /// A phase stops repeating after this much time; the number of runs is reported.
    pub budget_ms: f64,
}

impl Repeats {
    /// Once, not timed for comparison.
    pub const ONCE: Self = Self { count: 1, budget_ms: 0.0 };
    /// Median of five after a warm-up, as all times of methods are given; phases of more than six seconds are repeated less often.
    pub const MEDIAN: Self = Self { count: 5, budget_ms: 36_000.0 };
}

/// What a method gave.
#[derive(Clone, Debug)]
pub struct MethodRun {
    /// Indirect irradiance (W/m²) per pixel.
    pub irradiance: Vec<Vec4>,
    /// Median times.
    pub times: TimeMs,
    /// Counted runs of precompute, light change and frame.
    pub runs: [u32; 3],
    /// Label and bytes of the method's own buffers.
    pub buffers: Vec<(String, u64)>,
    /// What the method decided by itself.
    pub needs: serde_json::Value,
    /// What the terms that its settings cut off would carry.
    pub terms: Vec<Terms>,
}

/// Runs a method from nothing to irradiance at every pixel of a G-buffer; gives its buffers back.
///
/// # Errors
/// The method's own.
pub fn run(
    exec: &mut dyn Executor,
    input: &Input<'_>,
    row: &MethodRow,
    settings: &Settings,
    gbuffer: BufferId,
    pixel_count: usize,
    repeats: Repeats,
) -> Result<MethodRun, MethodError> {
    let mark = exec.mark();
    let result = run_marked(exec, input, row, settings, gbuffer, pixel_count, repeats);
    exec.free_since(mark);
    result
}

fn run_marked(
    exec: &mut dyn Executor,
    input: &Input<'_>,
    row: &MethodRow,
    settings: &Settings,
    gbuffer: BufferId,
    pixel_count: usize,
    repeats: Repeats,
) -> Result<MethodRun, MethodError> {
    let irradiance = exec.zeroed_slice::<Vec4>("irradiance", pixel_count)?;
    Prepared::new(exec, input, row, settings, repeats)?.run(exec, input, gbuffer, irradiance, repeats)
}

/// A method that was precomputed for a scene, to be run as often as there is something to run; its buffers stay until
/// [`Prepared::free`].
pub struct Prepared {
    method: Box<dyn Method>,
    /// Method and settings.
    name: String,
    settings: Settings,
    precompute: Repeated,
    /// Seconds that its making would take from nothing.
    pub wall_s: f64,
    /// Seconds of these that it was spared, because parts were there already.
    pub spared_s: f64,
    /// The executor's buffers that are its own: from the first mark to the second.
    made: Vec<[Mark; 2]>,
    /// Label and bytes of the buffers after the first run.
    buffers: Vec<(String, u64)>,
    before: usize,
}

impl Prepared {
    /// Precomputes a method.
    ///
    /// # Errors
    /// The method's own; its buffers are given back then.
    pub fn new(
        exec: &mut dyn Executor,
        input: &Input<'_>,
        row: &MethodRow,
        settings: &Settings,
        repeats: Repeats,
    ) -> Result<Self, MethodError> {
        Self::making(exec, input, row, settings, repeats, None)
    }

    /// The same with parts that others of its kind share. Its times are those from nothing.
    ///
    /// # Errors
    /// As [`Prepared::new`].
    pub fn sharing(
        exec: &mut dyn Executor,
        input: &Input<'_>,
        row: &MethodRow,
        settings: &Settings,
        repeats: Repeats,
        parts: &mut SharedParts,
    ) -> Result<Self, MethodError> {
        Self::making(exec, input, row, settings, repeats, Some(parts))
    }

    fn making(
        exec: &mut dyn Executor,
        input: &Input<'_>,
        row: &MethodRow,
        settings: &Settings,
        repeats: Repeats,
        mut parts: Option<&mut SharedParts>,
    ) -> Result<Self, MethodError> {
        let start = Instant::now();
        let (mark, before) = (exec.mark(), exec.buffers().len());
        let mut method: Option<Box<dyn Method>> = None;
        let mut spared_s = 0.0;
        let precompute = repeat(exec, repeats, |exec, clock| {
            exec.free_since(mark);
            let mut fresh = (row.new)(settings)?;
            if let Some(parts) = &mut parts {
                fresh.share(parts);
            }
            fresh.precompute(exec, input, clock)?;
            spared_s += clock.spared_ms / 1e3;
            method = Some(fresh);
            Ok(())
        });
        let precompute = precompute.inspect_err(|_| exec.free_since(mark))?;
        Ok(Self {
            method: method.expect("a phase runs at least once"),
            name: row.name.into(),
            settings: settings.clone(),
            precompute,
            wall_s: start.elapsed().as_secs_f64() + spared_s,
            spared_s,
            made: vec![[mark, exec.mark()]],
            buffers: Vec::new(),
            before,
        })
    }

    /// Whether it serves a method with these settings: they are its own, or need nothing else precomputed.
    pub fn serves(&mut self, row: &MethodRow, settings: &Settings) -> bool {
        if self.name != row.name {
            return false;
        }
        if self.settings != *settings {
            if !self.method.retune(settings) {
                return false;
            }
            self.settings = settings.clone();
        }
        true
    }

    /// Changes its lights and makes frames of a G-buffer into `irradiance` (`Vec4` per pixel).
    ///
    /// # Errors
    /// The method's own.
    pub fn run(
        &mut self,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        gbuffer: BufferId,
        irradiance: BufferId,
        repeats: Repeats,
    ) -> Result<MethodRun, MethodError> {
        let (mark, method) = (exec.mark(), &mut self.method);
        let light = repeat(exec, repeats, |exec, clock| method.light_change(exec, input, clock));
        let frame = light.and_then(|light| {
            let frame = repeat(exec, repeats, |exec, clock| method.frame(exec, input, gbuffer, irradiance, clock))?;
            Ok((light, frame))
        });
        // What a method makes on its way belongs to it, whatever the end.
        self.made.push([mark, exec.mark()]);
        let (light, frame) = frame?;
        if self.buffers.is_empty() {
            self.buffers = exec.buffers().split_off(self.before);
        }
        Ok(MethodRun {
            irradiance: exec.read_slice(irradiance)?,
            times: times(&self.precompute, &light, &frame),
            runs: [self.precompute.runs, light.runs, frame.runs],
            buffers: self.buffers.clone(),
            needs: self.method.needs(),
            terms: self.method.terms(),
        })
    }

    /// Bytes of its buffers, once it has run.
    pub fn memory_bytes(&self) -> u64 {
        self.buffers.iter().map(|b| b.1).sum()
    }

    /// Gives its buffers back.
    pub fn free(self, exec: &mut dyn Executor) {
        for [from, to] in self.made {
            (from.0..to.0).for_each(|id| exec.free(BufferId(id)));
        }
    }
}

/// A phase's own time is measured around all of it: it holds what lies between its stages too.
fn times(precompute: &Repeated, light: &Repeated, frame: &Repeated) -> TimeMs {
    let phases = [(Phase::Precompute, precompute), (Phase::LightChange, light), (Phase::Frame, frame)];
    let stages = phases.iter().flat_map(|(phase, run)| run.stages.iter().map(|(name, ms)| (*phase, name.clone(), *ms)));
    TimeMs {
        precompute: precompute.median_ms,
        light_change: light.median_ms,
        frame: frame.median_ms,
        spread: Some(TimeSpread {
            precompute: precompute.spread_ms,
            light_change: light.spread_ms,
            frame: frame.spread_ms,
        }),
        ..TimeMs::from_stages(stages)
    }
}

/// What is said of a run in `report.json` and `compare.json`.
pub fn describe(
    row: &MethodRow,
    settings: &Settings,
    run: &MethodRun,
    device: &DeviceInfo,
    error: Option<ErrorMetrics>,
) -> MethodResult {
    let mut needs = match &run.needs {
        serde_json::Value::Object(map) => map.clone(),
        _ => serde_json::Map::new(),
    };
    needs.insert("timed_runs".into(), serde_json::json!(run.runs));
    MethodResult {
        method: row.name.into(),
        label: None,
        summary: row.summary.into(),
        control: row.control,
        settings: report::settings_json(settings),
        backend: device.backend.clone(),
        error,
        time_ms: run.times.clone(),
        memory_bytes: MemoryBytes::from_buffers(run.buffers.iter().cloned()),
        needs: needs.into(),
    }
}

/// Largest resident memory of this process so far, in bytes; 0 where the system does not say.
pub fn peak_memory_bytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let kib = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok());
    kib.unwrap_or(0) * 1024
}

struct Repeated {
    median_ms: f64,
    spread_ms: [f64; 2],
    runs: u32,
    stages: Vec<(String, f64)>,
}

/// Repeats a phase: one warm-up, then up to `count` runs within the budget. A phase that exhausts the budget with its
/// first run counts that run: nothing that slow needs a warm-up.
fn repeat(
    exec: &mut dyn Executor,
    repeats: Repeats,
    mut work: impl FnMut(&mut dyn Executor, &mut StageClock) -> Result<(), MethodError>,
) -> Result<Repeated, MethodError> {
    let mut runs: Vec<(f64, Vec<(String, f64)>)> = Vec::new();
    let started = Instant::now();
    let warm_up = usize::from(repeats.count > 1);
    let mut spared_ms = 0.0;
    loop {
        let mut clock = StageClock::default();
        let begin = Instant::now();
        work(exec, &mut clock)?;
        flush(exec)?;
        spared_ms += clock.spared_ms;
        runs.push((begin.elapsed().as_secs_f64() * 1e3 + clock.spared_ms, clock.stages));
        let spent_ms = started.elapsed().as_secs_f64() * 1e3 + spared_ms;
        if runs.len() >= repeats.count as usize + warm_up || spent_ms >= repeats.budget_ms {
            break;
        }
    }
    if runs.len() > warm_up {
        runs.drain(..warm_up);
    }
    let stage_names: Vec<String> = runs[0].1.iter().map(|(name, _)| name.clone()).collect();
    let stages = stage_names
        .into_iter()
        .enumerate()
        .map(|(k, name)| (name, median(runs.iter().filter_map(|(_, stages)| stages.get(k).map(|s| s.1)).collect())))
        .collect();
    let spread_ms = runs.iter().fold([f64::INFINITY, 0.0], |[low, high], r| [low.min(r.0), high.max(r.0)]);
    let median_ms = median(runs.iter().map(|r| r.0).collect());
    Ok(Repeated { median_ms, spread_ms, runs: runs.len() as u32, stages })
}

/// Waits until everything that was asked for is done.
fn flush(exec: &mut dyn Executor) -> Result<(), ExecError> {
    exec.begin();
    exec.end().map(drop)
}

/// Middle value (mean of the two middle ones); 0 for none.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    if n == 0 { 0.0 } else { 0.5 * (values[(n - 1) / 2] + values[n / 2]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exec::CpuExecutor;

    /// What is kept between trials must not show: the same picture, bit for bit, as from nothing.
    #[test]
    fn a_method_that_takes_other_settings_gives_what_a_new_one_gives() {
        let scene = crate::scene::built_in::cornell_box();
        let mut exec = CpuExecutor::new();
        let exec: &mut dyn Executor = &mut exec;
        let buffers = SceneBuffers::upload(exec, &scene).unwrap();
        let view = View::new(exec, &scene, &buffers, &scene.cameras[0], (12, 12), 1).unwrap();
        let input = Input { scene: &scene, buffers: &buffers, seed: 1, true_mean: None };
        let irradiance = exec.zeroed_slice::<Vec4>("irradiance", view.surfels.len()).unwrap();
        let run = |exec: &mut dyn Executor, p: &mut Prepared| {
            p.run(exec, &input, view.gbuffer, irradiance, Repeats::ONCE).unwrap().irradiance
        };
        let mut retuned = Vec::new();
        for row in crate::methods::METHODS.iter().filter(|m| !m.control) {
            // As little as the method takes, so that this is quick.
            let least = [("receivers", "512"), ("rays", "32"), ("relight_rays", "128")];
            let known = least.into_iter().filter(|(key, _)| row.settings.iter().any(|s| s.key == *key));
            let settings = row.with(row.ladder[0].1.iter().copied().chain(known)).unwrap();
            let mut kept = Prepared::new(exec, &input, row, &settings, Repeats::ONCE).unwrap();
            let first = run(exec, &mut kept);
            for axis in crate::fit::axes(row, &settings) {
                let mut other = settings.clone();
                other.insert(axis.key.clone(), axis.values.last().cloned().unwrap());
                if other == settings || !kept.serves(row, &other) {
                    continue;
                }
                let mut fresh = Prepared::new(exec, &input, row, &other, Repeats::ONCE).unwrap();
                assert_eq!(run(exec, &mut kept), run(exec, &mut fresh), "{} {}", row.name, axis.key);
                fresh.free(exec);
                retuned.push(axis.key);
                assert!(kept.serves(row, &settings), "{}", row.name);
            }
            assert_eq!(run(exec, &mut kept), first, "{}: there and back", row.name);
            let live = exec.buffers().len();
            kept.free(exec);
            assert!(exec.buffers().len() < live);
        }
        assert!(retuned.len() >= 3, "{retuned:?}");
    }

    /// What is taken over from others must not show either.
    #[test]
    fn a_method_that_takes_parts_of_another_gives_what_it_gives_alone() {
        let scene = crate::scene::built_in::cornell_box();
        let mut exec = CpuExecutor::new();
        let exec: &mut dyn Executor = &mut exec;
        let buffers = SceneBuffers::upload(exec, &scene).unwrap();
        let view = View::new(exec, &scene, &buffers, &scene.cameras[0], (12, 12), 1).unwrap();
        let input = Input { scene: &scene, buffers: &buffers, seed: 1, true_mean: None };
        let irradiance = exec.zeroed_slice::<Vec4>("irradiance", view.surfels.len()).unwrap();
        let mut sharing = Vec::new();
        for row in crate::methods::METHODS.iter().filter(|m| !m.control) {
            let least = [("receivers", "512"), ("rays", "32"), ("relight_rays", "128")];
            let known = least.into_iter().filter(|(key, _)| row.settings.iter().any(|s| s.key == *key));
            let settings = row.with(row.ladder[0].1.iter().copied().chain(known)).unwrap();
            let axes = crate::fit::axes(row, &settings);
            let other = |axis: &crate::fit::Axis| {
                let mut other = settings.clone();
                other.insert(
                    axis.key.clone(),
                    axis.values.iter().find(|v| **v != settings[&axis.key]).cloned().unwrap(),
                );
                other
            };
            let mut parts = SharedParts::default();
            // Twice the first: the second time all that can be taken over is.
            for asked in [settings.clone(), settings.clone()].into_iter().chain(axes.iter().map(other)) {
                let mut run = |parts: Option<&mut SharedParts>| {
                    let mut own = Prepared::making(exec, &input, row, &asked, Repeats::ONCE, parts).unwrap();
                    let made = own.run(exec, &input, view.gbuffer, irradiance, Repeats::ONCE).unwrap();
                    let spared = own.spared_s > 0.0 && made.times.precompute >= 1e3 * own.spared_s;
                    own.free(exec);
                    (made.irradiance, spared)
                };
                let (with, spared) = run(Some(&mut parts));
                assert_eq!(with, run(None).0, "{} {asked:?}", row.name);
                sharing.extend(spared.then_some(row.name));
            }
        }
        assert!(sharing.len() >= 4, "{sharing:?}");
    }

    #[test]
    fn median_of_even_and_odd() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), 2.5);
        assert_eq!(median(vec![]), 0.0);
    }

    #[test]
    fn a_phase_runs_once_over_budget_and_five_times_after_a_warm_up_below() {
        let mut exec = CpuExecutor::new();
        for (repeats, calls, counted) in
            [(Repeats::ONCE, 1, 1), (Repeats::MEDIAN, 6, 5), (Repeats { count: 5, budget_ms: 0.0 }, 1, 1)]
        {
            let mut n = 0;
            let phase = repeat(&mut exec, repeats, |_, clock| {
                n += 1;
                clock.stages.push(("stage".into(), f64::from(n)));
                Ok(())
            })
            .unwrap();
            assert_eq!((n, phase.runs), (calls, counted));
            assert_eq!(phase.stages.len(), 1);
        }
    }
}
