//! Whole pictures: voxel cone tracing on a device must light every pixel as on the CPU, from voxelization to the gather.

use interreflect::evaluate::{self, Repeats, View};
use interreflect::exec::{CpuExecutor, Executor};
use interreflect::methods::{Input, method};
use interreflect::scene::device::SceneBuffers;
use interreflect::scene::{LoadOptions, load};
use interreflect_shared::scene::NO_SURFACE;
use interreflect_tests::{gpu, suite};
use libtest_mimic::{Arguments, Failed};
use std::process::ExitCode;

const SIDE_PX: u32 = 64;
/// Root mean square difference of two pictures, relative to the mean: float operations round differently on a device, and
/// where a sum of fixed point lies on the edge of a unit or a cone on the edge of a voxel, a few pixels show it.
const MOST_NRMSE: f32 = 3e-5;
/// Share of pixels that may differ by more than a hundredth of the mean.
const MOST_OUTLIERS: f32 = 2e-4;

fn main() -> ExitCode {
    let mut trials = Vec::new();
    for scene in ["cornell-box", "colonnade"] {
        for path in gpu::SPIRV_PATHS {
            let name = format!("vct_{scene}::{}", gpu::path_name(path));
            trials.push(suite::gpu_trial(name, path, move || {
                let cpu = picture(&mut CpuExecutor::new(), scene)?;
                let device = picture(&mut *gpu::lock(path)?, scene)?;
                alike(&cpu, &device)
            }));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

/// Indirect irradiance of every pixel's channels, and which pixel shows what triangle.
struct Picture {
    irradiance: Vec<f32>,
    triangles: Vec<u32>,
}

fn picture(exec: &mut dyn Executor, name: &str) -> Result<Picture, Failed> {
    let scene = load(name, &LoadOptions::default())?;
    let camera = scene.camera(None)?;
    let mark = exec.mark();
    let buffers = SceneBuffers::upload(exec, &scene)?;
    let view = View::new(exec, &scene, &buffers, &camera, (SIDE_PX, SIDE_PX), 1)?;
    let row = method("vct")?;
    let settings = row.with([("resolution", "64"), ("light_samples", "4"), ("environment_samples", "8")])?;
    let input = Input { scene: &scene, buffers: &buffers, seed: 1, true_mean: None };
    let run = evaluate::run(exec, &input, row, &settings, view.gbuffer, view.surfels.len(), Repeats::ONCE)?;
    exec.free_since(mark);
    Ok(Picture {
        irradiance: run.irradiance.iter().flat_map(|e| e.truncate().to_array()).collect(),
        triangles: view.surfels.iter().map(|s| s.triangle).collect(),
    })
}

fn alike(cpu: &Picture, device: &Picture) -> Result<(), Failed> {
    let shared = |k: usize| cpu.triangles[k] == device.triangles[k] && cpu.triangles[k] != NO_SURFACE;
    let pixels: Vec<usize> = (0..cpu.triangles.len()).filter(|&k| shared(k)).collect();
    let seen = cpu.triangles.iter().filter(|t| **t != NO_SURFACE).count();
    // A primary ray may take the other of two triangles at an edge; a picture of other triangles is no picture.
    if seen == 0 || pixels.len() * 100 < seen * 99 {
        return Err(format!("{} of {seen} visible pixels show the same triangle", pixels.len()).into());
    }
    let values = pixels.iter().flat_map(|&k| (3 * k..3 * k + 3).map(|c| (cpu.irradiance[c], device.irradiance[c])));
    let count = 3.0 * pixels.len() as f32;
    let mean = values.clone().map(|(a, _)| a).sum::<f32>() / count;
    let nrmse = (values.clone().map(|(a, b)| (a - b) * (a - b)).sum::<f32>() / count).sqrt() / mean;
    let outliers = values.filter(|(a, b)| (a - b).abs() > 0.01 * mean).count() as f32 / count;
    println!("mean {mean}, nrmse {nrmse:e}, off by more than 1 % of the mean: {outliers:e}");
    // Written so that a NaN fails.
    if mean > 0.0 && nrmse <= MOST_NRMSE && outliers <= MOST_OUTLIERS {
        Ok(())
    } else {
        Err(format!("mean {mean}, nrmse {nrmse:e}, share of pixels off by more than 1 %: {outliers:e}").into())
    }
}
