//! Voxelization of a whole scene: time per stage, triangles and voxels per second, memory per buffer, and whether the work
//! of one huge triangle is spread as evenly as that of many small ones.

use super::{Bench, median, scene};
use anyhow::Result;
use glam::Vec3;
use interreflect::exec::{CpuExecutor, Executor};
use interreflect::methods::StageClock;
use interreflect::methods::voxels::{VoxelGrid, VoxelOptions, VoxelScene};
use interreflect::scene::Scene;
use interreflect::scene::built_in::SceneBuilder;
use interreflect::scene::device::SceneBuffers;
use serde_json::{Value, json};
use std::collections::BTreeMap;

const RESOLUTION: u32 = 256;
const REPEATS: usize = 5;

/// The figures.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let (name, scene, _) = scene::measured()?;
    let built = build(&mut bench.cpu, &scene)?;
    let triangles = scene.triangles.len() as f64;
    let per_s = |count: f64| count / built.total_ms * 1e-3;
    let (mtriangles, mvoxels) = (per_s(triangles), per_s(f64::from(built.voxels)));
    println!("\nvoxelization of {name} at {RESOLUTION}, six directions");
    println!("{:.1} ms: {mtriangles:.2} Mtriangles/s, {mvoxels:.2} Mvoxels/s", built.total_ms);
    println!("stages: {}", joined(built.stages.iter().map(|(stage, ms)| format!("{stage} {ms:.1} ms"))));
    let mib = |bytes: u64| bytes as f64 / (1 << 20) as f64;
    let total: u64 = built.buffers.iter().map(|b| b.1).sum();
    println!("memory: {:.1} MiB in all", mib(total));
    println!(
        "buffers: {}",
        joined(built.buffers.iter().map(|(label, bytes)| format!("{label} {:.1} MiB", mib(*bytes))))
    );

    let (huge, fine) = (build(&mut bench.cpu, &wall(1))?, build(&mut bench.cpu, &wall(100))?);
    let per_voxel = |b: &Built| b.stages.get("voxelize").copied().unwrap_or(f64::NAN) / f64::from(b.voxels);
    let balance = per_voxel(&huge) / per_voxel(&fine);
    println!("a wall of 2 triangles costs {balance:.2}× as much per voxel as one of 20 000");
    Ok(json!({
        "scene": name,
        "resolution": RESOLUTION,
        "ms": built.total_ms,
        "stages_ms": built.stages,
        "mtriangles_per_s": mtriangles,
        "mvoxels_per_s": mvoxels,
        "buffers_bytes": built.buffers.into_iter().collect::<BTreeMap<_, _>>(),
        "huge_triangle_cost_per_voxel": balance,
    }))
}

fn joined(parts: impl Iterator<Item = String>) -> String {
    parts.collect::<Vec<_>>().join(", ")
}

struct Built {
    total_ms: f64,
    stages: BTreeMap<String, f64>,
    voxels: u32,
    buffers: Vec<(String, u64)>,
}

fn build(exec: &mut CpuExecutor, scene: &Scene) -> Result<Built> {
    let options = VoxelOptions { method: "bench", anisotropic: true, limit_bytes: 8 << 30, emission_max: 0.0 };
    let grid = VoxelGrid::around(scene.bounds(), RESOLUTION);
    let scene_mark = exec.mark();
    let buffers = SceneBuffers::upload(exec, scene)?;
    let mut times: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    let (mut totals, mut voxels, mut held) = (Vec::new(), 0, Vec::new());
    for _ in 0..REPEATS {
        let (mark, before) = (exec.mark(), exec.buffers().len());
        let mut clock = StageClock::default();
        voxels = VoxelScene::build(exec, &buffers, &grid, &options, &mut clock)?.voxel_count;
        held = exec.buffers().split_off(before);
        exec.free_since(mark);
        totals.push(clock.stages.iter().map(|s| s.1).sum());
        let mut of_run: BTreeMap<String, f64> = BTreeMap::new();
        clock.stages.into_iter().for_each(|(stage, ms)| *of_run.entry(stage).or_default() += ms);
        of_run.into_iter().for_each(|(stage, ms)| times.entry(stage).or_default().push(ms));
    }
    exec.free_since(scene_mark);
    let stages = times.into_iter().map(|(stage, ms)| (stage, median(ms))).collect();
    Ok(Built { total_ms: median(totals), stages, voxels, buffers: held })
}

/// An inclined wall of `2 n²` triangles.
fn wall(n: u32) -> Scene {
    let mut b = SceneBuilder::new("wall");
    let m = b.diffuse("wall", [0.5; 3]);
    let at = |i: u32, j: u32| Vec3::new(i as f32, j as f32, 0.3 * i as f32) / n as f32;
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        b.quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)], m);
    }
    b.finish()
}
