//! Rays per second: of the truth on one thread, of the kernels on all threads and on the device; and how fast the truth's
//! error falls.

use super::kernels::Load;
use super::{Bench, median, scene};
use anyhow::Result;
use interreflect::exec::{Executor, ExecutorExt};
use interreflect::reference::bench::rays_per_second;
use interreflect::reference::{ReferenceSettings, render};
use interreflect::scene::device::SceneBuffers;
use interreflect::scene::{Camera, LoadOptions, Scene, load};
use interreflect::shading;
use interreflect_kernels::trace::gbuffer::trace_gbuffer;
use interreflect_shared::scene::Surfel;
use serde_json::{Value, json};
use std::time::Instant;

const SIDE_PX: u32 = 512;
const REPEATS: usize = 5;
/// Paths per pixel of the Cornell box.
const CORNELL_SPP: u32 = 64;

/// The three tables.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let (name, scene, camera) = scene::measured()?;
    let truth = rays_per_second(&scene, &camera, SIDE_PX, SIDE_PX)?;
    println!("\nrays on {name}, {SIDE_PX}×{SIDE_PX}");
    println!(
        "truth, one thread: {:.2} Mrays/s primary, {:.2} diffuse, {:.2} shadow (tree in {:.0} ms)",
        truth.primary_mrays, truth.diffuse_mrays, truth.shadow_mrays, truth.build_ms
    );
    let on_cpu = primary_mrays(&mut bench.cpu, &scene, &camera)?;
    let on_device = bench.gpu.as_mut().map(|gpu| primary_mrays(gpu, &scene, &camera)).transpose()?;
    println!("kernels, primary rays with surfaces: {on_cpu:.2} Mrays/s on all threads of the CPU");
    if let Some(on_device) = on_device {
        println!("the same on the device: {on_device:.2} Mrays/s ({:.2}× as long)", on_cpu / on_device);
    }
    let efficiency = cornell_efficiency()?;
    println!("truth, Cornell box 256×256, {CORNELL_SPP} paths per pixel: 1/(nrmse²·s) = {efficiency:.1}");
    Ok(json!({
        "scene": name,
        "truth": truth,
        "kernel_primary_mrays": { "cpu": on_cpu, "device": on_device },
        "cornell_inverse_square_error_per_s": efficiency,
    }))
}

fn primary_mrays(executor: &mut dyn Executor, scene: &Scene, camera: &Camera) -> Result<f64> {
    let mark = executor.mark();
    let buffers = SceneBuffers::upload(executor, scene)?;
    let params = shading::gbuffer_params(camera, SIDE_PX, SIDE_PX, scene.environment);
    let uniform = executor.upload_one("camera", &params)?;
    let out = executor.zeroed_slice::<Surfel>("gbuffer", (SIDE_PX * SIDE_PX) as usize)?;
    let [nodes, triangles, attributes, surfaces] = buffers.trace_bindings();
    let load = Load::of(&trace_gbuffer::KERNEL, vec![uniform, nodes, triangles, attributes, surfaces, out]);
    load.seconds(executor, 1)?;
    let seconds: Result<Vec<f64>> = (0..REPEATS).map(|_| load.seconds(executor, 1)).collect();
    executor.free_since(mark);
    Ok(f64::from(SIDE_PX * SIDE_PX) / median(seconds?) * 1e-6)
}

/// 1/(nrmse²·s) of a picture of the Cornell box: does not depend on the number of paths, and compares path tracers.
fn cornell_efficiency() -> Result<f64> {
    let scene = load("cornell-box", &LoadOptions::default())?;
    let camera = scene.camera(None)?;
    let settings = ReferenceSettings { spp: Some(CORNELL_SPP), ..ReferenceSettings::default() };
    let runs: Result<Vec<f64>> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            let truth = render(&scene, &camera, 256, 256, &settings, &mut |_| ())?;
            Ok(1.0 / (truth.noise * truth.noise * start.elapsed().as_secs_f64()))
        })
        .collect();
    Ok(median(runs?))
}
