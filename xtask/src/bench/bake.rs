//! Precomputation of sparse radiance probes: rays per second of local transport beside the truth's own, seconds and memory.
//!
//! Rays are those that receivers send and those that ask probes whether they see what was met; what comes of each (weights,
//! spherical harmonics, the matrix) is part of its time. The truth's own rate is that of its paths, shadow rays, surfaces and
//! light included; beside it stand closest hits of diffuse rays alone, with nothing done with them, the limit of both. Both on as
//! many threads at once (threads may share a core), before transport and after it.

use super::{Bench, scene};
use anyhow::Result;
use interreflect::evaluate::peak_memory_bytes;
use interreflect::methods::srp::{BakeOptions, Plan};
use interreflect::reference::bench::rays_per_second;
use interreflect::reference::{ReferenceSettings, render};
use interreflect::scene::{Camera, LoadOptions, Scene, load};
use serde_json::{Value, json};
use std::time::Instant;

const SIDE_PX: u32 = 512;
/// Paths per pixel of the truth's picture.
const PATHS: u32 = 16;

/// A precomputation of the implementation study, with fewer rays per receiver than it has.
struct Case {
    receivers: u32,
    probes: u32,
    /// Rays per receiver that are sent, and that the study sends.
    rays: [u32; 2],
    relight_rays: u32,
}

/// The Cornell box of the study, and its Sponza.
const CASES: [Case; 2] = [
    Case { receivers: 40_564, probes: 27, rays: [256, 4096], relight_rays: 1024 },
    Case { receivers: 250_000, probes: 150, rays: [128, 512], relight_rays: 8000 },
];

/// The section.
pub fn run(_: &mut Bench) -> Result<Value> {
    let cornell = load("cornell-box", &LoadOptions::default())?;
    let camera = cornell.camera(None)?;
    let (_, large, view) = scene::measured()?;
    Ok(json!([measure(&cornell, &camera, &CASES[0])?, measure(&large, &view, &CASES[1])?]))
}

fn measure(scene: &Scene, camera: &Camera, case: &Case) -> Result<Value> {
    let before = truth_rates(scene, camera)?;
    let options = BakeOptions {
        receivers: case.receivers,
        probes: case.probes,
        rays: case.rays[0],
        relight_rays: case.relight_rays,
        ..BakeOptions::default()
    };
    let started = Instant::now();
    let plan = Plan::new(scene, &options)?;
    let plan_s = started.elapsed().as_secs_f64();
    let (traced, transport_s) = transport_alone(&plan)?;
    let after = truth_rates(scene, camera)?;
    let [truth, closest] = [0, 1].map(|k| 0.5 * (before[k] + after[k]));
    let started = Instant::now();
    let (bake, _) = plan.bake();
    let bake_s = started.elapsed().as_secs_f64();
    let threads = rayon::current_num_threads() as f64;
    let sent = bake.receivers.len() as f64 * f64::from(case.rays[0]);
    let [mrays, sent_mrays] = [traced as f64, sent].map(|rays| rays / transport_s / threads * 1e-6);
    let whole = plan_s + bake_s + transport_s * f64::from(case.rays[1]) / f64::from(case.rays[0]) - transport_s;
    println!("\nprecomputation, {}: {} receivers, {} probes", scene.name, bake.receivers.len(), bake.probes.len());
    println!(
        "transport: {mrays:.2} Mrays/s per thread with {} rays per receiver ({sent_mrays:.2} from receivers alone); \
         the truth: {truth:.2} along paths ({:.2}×), {closest:.2} closest hits alone ({:.2}×)",
        case.rays[0],
        truth / mrays,
        closest / mrays
    );
    println!("plan {plan_s:.1} s, transport {transport_s:.1} s, all clusters with compression {bake_s:.1} s");
    println!("with {} rays per receiver about {whole:.0} s; peak {} MiB", case.rays[1], peak_memory_bytes() >> 20);
    Ok(json!({
        "scene": scene.name,
        "receivers": bake.receivers.len(),
        "probes": bake.probes.len(),
        "rays_per_receiver": case.rays[0],
        "transport_mrays_per_s_and_thread": mrays,
        "receivers_mrays_per_s_and_thread": sent_mrays,
        "truth_mrays_per_s_and_thread": truth,
        "closest_hits_mrays_per_s_and_thread": closest,
        "plan_s": plan_s,
        "transport_s": transport_s,
        "clusters_s": bake_s,
        "extrapolated_to": { "rays_per_receiver": case.rays[1], "s": whole },
        "peak_memory_bytes": peak_memory_bytes(),
        "report": plan.report(&bake),
    }))
}

/// Rays of the truth's paths, and closest hits of diffuse rays alone: million per second and thread, while all threads trace.
fn truth_rates(scene: &Scene, camera: &Camera) -> Result<[f64; 2]> {
    let settings = ReferenceSettings { spp: Some(PATHS), ..ReferenceSettings::default() };
    let truth = render(scene, camera, SIDE_PX, SIDE_PX, &settings, &mut |_| ())?;
    let paths = truth.rays as f64 / truth.ms * 1e-3 / rayon::current_num_threads() as f64;
    let each = rayon::broadcast(|_| rays_per_second(scene, camera, SIDE_PX, SIDE_PX).map(|r| r.diffuse_mrays));
    let each = each.into_iter().collect::<Result<Vec<f64>, _>>()?;
    Ok([paths, each.iter().sum::<f64>() / each.len() as f64])
}

/// Rays and seconds of local transport without correction and compression.
fn transport_alone(plan: &Plan<'_>) -> Result<(u64, f64)> {
    let started = Instant::now();
    let rays = plan.transport_alone();
    anyhow::ensure!(rays > 0, "no receiver sent a ray");
    Ok((rays, started.elapsed().as_secs_f64()))
}
