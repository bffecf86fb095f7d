//! What methods say beforehand that their precomputation will take, beside what it then took: by the first, `fit` decides what
//! it tries.

use super::{Bench, scene};
use anyhow::Result;
use interreflect::exec::Executor;
use interreflect::methods::{Input, METHODS, MethodRow, SharedParts, StageClock};
use interreflect::scene::device::SceneBuffers;
use interreflect::scene::{LoadOptions, Scene, load};
use serde_json::{Value, json};
use std::time::Instant;

/// Rungs of every ladder, from the cheapest: those that a search asks for first.
const RUNGS: usize = 3;
/// Scenes beside the large one.
const BUILT_IN: [&str; 3] = ["cornell-box", "two-rooms", "colonnade"];

/// The section.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let mut scenes: Vec<Scene> =
        BUILT_IN.iter().map(|name| load(name, &LoadOptions::default())).collect::<Result<_, _>>()?;
    let (_, large, _) = scene::measured()?;
    if scenes.iter().all(|s| s.name != large.name) {
        scenes.push(large);
    }
    println!("\n{:<14} {:<8} {:<34} {:>8} {:>8} {:>6}", "set-up", "method", "rung", "told s", "took s", "ratio");
    let mut rows = Vec::new();
    for scene in &scenes {
        for method in METHODS {
            for (name, changes) in method.ladder.iter().take(RUNGS) {
                let mark = bench.cpu.mark();
                let times = told_and_took(bench, scene, method, changes);
                bench.cpu.free_since(mark);
                let Some([told, took]) = times? else { break };
                let file = scene.name.rsplit('/').next().unwrap_or_default();
                println!("{file:<14.14} {:<8} {name:<34} {told:>8.2} {took:>8.2} {:>6.2}", method.name, told / took);
                rows.push(
                    json!({ "scene": scene.name, "method": method.name, "rung": name, "told_s": told, "took_s": took }),
                );
            }
        }
    }
    Ok(Value::Array(rows))
}

/// Seconds; nothing where the method does not say.
fn told_and_took(
    bench: &mut Bench,
    scene: &Scene,
    row: &MethodRow,
    changes: &[(&str, &str)],
) -> Result<Option<[f64; 2]>> {
    let buffers = SceneBuffers::upload(&mut bench.cpu, scene)?;
    let input = Input { scene, buffers: &buffers, seed: 1, true_mean: None };
    let settings = row.with(changes.iter().copied())?;
    let mut parts = SharedParts::default();
    let mut method = (row.new)(&settings)?;
    method.share(&mut parts);
    let Some(told) = method.set_up(&mut bench.cpu, &input)? else { return Ok(None) };
    // One that shares nothing makes even the charts again that the question was answered by.
    let mut method = (row.new)(&settings)?;
    let started = Instant::now();
    method.precompute(&mut bench.cpu, &input, &mut StageClock::default())?;
    Ok(Some([told.whole_s, started.elapsed().as_secs_f64()]))
}
