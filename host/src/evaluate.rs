//! Runs a method on a view and times it: what `render`, `compare` and later charts are made of.

use crate::exec::{BufferId, DeviceInfo, ExecError, Executor, ExecutorExt};
use crate::image_io::Image;
use crate::methods::{Input, Method, MethodError, MethodRow, Phase, Settings, StageClock, Terms};
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
    /// Median of five after a warm-up (DESIGN: time of a method), while a phase takes less than six seconds in all.
    pub const MEDIAN: Self = Self { count: 5, budget_ms: 6_000.0 };
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
    let (mark, before) = (exec.mark(), exec.buffers().len());
    let mut method: Option<Box<dyn Method>> = None;
    let precompute = repeat(exec, repeats, |exec, clock| {
        exec.free_since(mark);
        let mut fresh = (row.new)(settings)?;
        fresh.precompute(exec, input, clock)?;
        method = Some(fresh);
        Ok(())
    })?;
    let mut method = method.expect("a phase runs at least once");
    let light = repeat(exec, repeats, |exec, clock| method.light_change(exec, input, clock))?;
    let frame = repeat(exec, repeats, |exec, clock| method.frame(exec, input, gbuffer, irradiance, clock))?;
    Ok(MethodRun {
        irradiance: exec.read_slice(irradiance)?,
        times: times(&precompute, &light, &frame),
        runs: [precompute.runs, light.runs, frame.runs],
        buffers: exec.buffers().split_off(before),
        needs: method.needs(),
        terms: method.terms(),
    })
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
    loop {
        let mut clock = StageClock::default();
        let begin = Instant::now();
        work(exec, &mut clock)?;
        flush(exec)?;
        runs.push((begin.elapsed().as_secs_f64() * 1e3, clock.stages));
        let spent_ms = started.elapsed().as_secs_f64() * 1e3;
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
