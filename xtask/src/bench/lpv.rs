//! Light propagation volumes: cells per second and what binds them, cost per light, and times per stage beside the papers'.

use super::kernels::{Load, moved, operations};
use super::{Bench, median};
use anyhow::{Context, Result};
use interreflect::exec::Executor;
use interreflect::methods::{Input, Settings, StageClock, lpv};
use interreflect::scene::Scene;
use interreflect::scene::built_in::{colonnade, cornell_box, many_lights};
use interreflect::scene::device::SceneBuffers;
use interreflect_kernels::kernel::{CaseInput, Flavour};
use interreflect_kernels::lpv::propagate::lpv_propagate;
use interreflect_shared::lpv::LpvParams;
use serde_json::{Value, json};

const REPEATS: usize = 7;
/// Steps of propagation in a row: half of a grid's 32 cells, the least that a light change takes.
const STEPS: u32 = 16;
/// Texels along each side of a light's map in the table of lights.
const MAP: &str = "32";
/// Numbers of lights: those of paper 000's tables, and 1.
const LIGHTS: [u32; 7] = [1, 5, 10, 25, 50, 100, 250];
/// Name of all that is computed once.
const PRECOMPUTE: &str = "precompute";

/// All tables.
pub fn run(bench: &mut Bench) -> Result<Value> {
    Ok(json!({ "propagation": propagation(bench)?, "lights": lights(bench)?, "stages": stages(bench)? }))
}

/// One step with occlusion on grids of 32³ and 64³ cells (and two more rows).
fn propagation(bench: &mut Bench) -> Result<Value> {
    let kernel = &lpv_propagate::KERNEL;
    println!(
        "\n{:<14} {:>10} {:>12} {:>12} {:>9} {:>11} {:>10}",
        "propagation", "cells", "CPU Mcells/s", "dev Mcells/s", "CPU wins", "arithmetic", "bandwidth"
    );
    let mut rows = Vec::new();
    for side in [32_usize, 64] {
        let case = (kernel.case)(&mut CaseInput::new(1, side * side * side, Flavour::Ordinary));
        let params: LpvParams = bytemuck::pod_read_unaligned(bytemuck::cast_slice(&case.buffers[0]));
        let cells = (params.dims.x * params.dims.y * params.dims.z) as f64;
        let on_cpu = Load::new(&mut bench.cpu, kernel, &case)?;
        let on_gpu = bench.gpu.as_mut().map(|gpu| Load::new(gpu, kernel, &case)).transpose()?;
        let (mut cpu, mut gpu) = (Vec::new(), Vec::new());
        for turn in 0..=REPEATS {
            let seconds = on_cpu.seconds(&mut bench.cpu, STEPS)?;
            let device = match (&on_gpu, &mut bench.gpu) {
                (Some(load), Some(executor)) => Some(load.seconds(executor, STEPS)?),
                _ => None,
            };
            // The first turn warms up.
            if turn > 0 {
                cpu.push(seconds);
                gpu.extend(device);
            }
        }
        on_cpu.free(&mut bench.cpu);
        if let (Some(load), Some(executor)) = (on_gpu, &mut bench.gpu) {
            load.free(executor);
        }
        let cpu = median(cpu);
        let device = (!gpu.is_empty()).then(|| median(gpu));
        let arithmetic =
            operations(kernel, &case).context("a lane kernel counts")? / cpu / bench.limits.operations_per_s;
        let bandwidth = bench.limits.least_seconds(moved(kernel, &case)) / cpu;
        let rate = |seconds: f64| cells / seconds * 1e-6;
        println!(
            "{:<14} {cells:>10} {:>12.1} {:>12} {:>9} {:>11} {:>10}",
            format!("{side}³"),
            rate(cpu),
            device.map_or_else(|| "–".into(), |s| format!("{:.1}", rate(s))),
            device.map_or_else(|| "–".into(), |s| format!("{:.2}×", s / cpu)),
            format!("{:.0} %", 100.0 * arithmetic),
            format!("{:.0} %", 100.0 * bandwidth),
        );
        rows.push(json!({
            "side": side, "cells": cells, "cpu_mcells_per_s": rate(cpu), "device_mcells_per_s": device.map(rate),
            "cpu_speedup": device.map(|s| s / cpu), "arithmetic_share": arithmetic, "bandwidth_share": bandwidth,
            "binds": if arithmetic > bandwidth { "arithmetic" } else { "bandwidth" },
        }));
    }
    Ok(Value::Array(rows))
}

/// Milliseconds of each stage of a light change, of `moving` lights or of such that stand still; a stage that runs several
/// times is added up.
fn stage_times(bench: &mut Bench, scene: &Scene, changes: &[(&str, &str)], moving: bool) -> Result<Vec<(String, f64)>> {
    let exec: &mut dyn Executor = &mut bench.cpu;
    let mark = exec.mark();
    let buffers = SceneBuffers::upload(exec, scene)?;
    let settings: Settings = changes.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect();
    let input = |seed| Input { scene, buffers: &buffers, seed, true_mean: None };
    let mut method = (lpv::ROW.new)(&settings)?;
    let mut clock = StageClock::default();
    method.precompute(exec, &input(0), &mut clock)?;
    let mut runs: Vec<Vec<(String, f64)>> = Vec::new();
    for turn in 0..=REPEATS as u32 {
        let mut clock = StageClock::default();
        // Another seed, so that every map is traced again.
        let seed = if moving { turn + 1 } else { 1 };
        method.light_change(exec, &input(seed), &mut clock)?;
        let mut sums: Vec<(String, f64)> = Vec::new();
        for (name, ms) in clock.stages {
            let name = if name.starts_with("bounce") { "bounce".to_string() } else { name };
            match sums.iter_mut().find(|(n, _)| *n == name) {
                Some(sum) => sum.1 += ms,
                None => sums.push((name, ms)),
            }
        }
        if turn > 0 {
            runs.push(sums);
        }
    }
    exec.free_since(mark);
    let names: Vec<String> = runs[0].iter().map(|(name, _)| name.clone()).collect();
    let medians = names.into_iter().enumerate().map(|(k, name)| (name, median(runs.iter().map(|r| r[k].1).collect())));
    let precompute: f64 = clock.stages.iter().map(|s| s.1).sum();
    Ok([(PRECOMPUTE.to_string(), precompute)].into_iter().chain(medians).collect())
}

/// Shadow maps and injection by number of lights, and all that is to do before a frame.
fn lights(bench: &mut Bench) -> Result<Value> {
    const HEAD: [&str; 6] = ["lights", "maps ms", "inject ms", "ms per light", "moving ms", "static ms"];
    println!("\n{:<10} {:>12} {:>12} {:>14} {:>12} {:>12}", HEAD[0], HEAD[1], HEAD[2], HEAD[3], HEAD[4], HEAD[5]);
    let mut rows = Vec::new();
    for count in LIGHTS {
        let scene = many_lights(count);
        let settings = [("resolution", "32"), ("rsm", MAP), ("bounces", "1"), ("geometry", "voxels")];
        let times = stage_times(bench, &scene, &settings, true)?;
        let ms = |name: &str| times.iter().filter(|(n, _)| n == name).map(|t| t.1).sum::<f64>();
        let (maps, inject) = (ms("shadow maps"), ms("inject"));
        let each = (maps + inject) / f64::from(count);
        let whole = |times: &[(String, f64)]| times.iter().filter(|t| t.0 != PRECOMPUTE).map(|t| t.1).sum::<f64>();
        let (moving, still) = (whole(&times), whole(&stage_times(bench, &scene, &settings, false)?));
        println!("{count:<10} {maps:>12.2} {inject:>12.2} {each:>14.3} {moving:>12.2} {still:>12.2}");
        rows.push(json!({ "lights": count, "maps_ms": maps, "inject_ms": inject, "ms_per_light": each,
                          "moving_ms": moving, "static_ms": still }));
    }
    println!("(static: the same lights again; only what changed is computed)");
    println!("paper 000 (GTX 780, i7-6700K, Sponza 32³, per frame): moving, 0/5/10/25 spots 6.1/18.2/71.4/111.1 ms;");
    println!("  static, 0/50/100/250 spots 2.4/7.1/20.0/50.0 ms");
    Ok(json!({
        "ours": rows,
        "paper_000": {
            "hardware": "GTX 780, i7-6700K, 1920x1080, Sponza",
            "dynamic_ms": { "0": 6.13, "5": 18.18, "10": 71.43, "15": 71.43, "20": 90.90, "25": 111.11 },
            "static_ms": { "0": 2.44, "50": 7.14, "100": 20.0, "150": 29.41, "200": 41.66, "250": 50.0 },
        },
    }))
}

/// Stages of a light change at 32 cells.
fn stages(bench: &mut Bench) -> Result<Value> {
    let mut tables = Vec::new();
    for scene in [cornell_box(), colonnade()] {
        let times = stage_times(bench, &scene, &[("resolution", "32"), ("bounces", "1"), ("rsm", "128")], true)?;
        println!("\n{:<22} {:>10}", format!("stages, {}", scene.name), "ms");
        times.iter().for_each(|(name, ms)| println!("{name:<22} {ms:>10.2}"));
        tables.push(json!({ "scene": scene.name, "stages_ms": times }));
    }
    println!(
        "paper 004 (GTX 750 Ti, Sponza, 2 × 32³ and 256³): voxelization 12.28, injection 0.11, propagation 1.79, \
         reflection grid 4.61, its mipmap 2.26, shading 7.86 ms"
    );
    Ok(json!({
        "ours": tables,
        "paper_004": {
            "hardware": "GTX 750 Ti, Sponza",
            "stages_ms": { "voxelization": 12.28, "direct light injection": 0.11, "direct light propagation": 1.79,
                           "reflection grid": 4.61, "reflection mipmap": 2.26, "global illumination": 7.86 },
        },
    }))
}
