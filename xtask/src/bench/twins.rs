//! Device code quality: our SPIR-V against WGSL that a person wrote for the same buffers, on the same adapter.
//!
//! The twin goes the way of every WGSL kernel: naga makes SPIR-V of it with wgpu's settings, which leave the bounds of
//! buffers to adapters that check them by themselves, as lavapipe does (ours has the checks of Rust). Both then run from SPIR-V on the same executor; their outputs must agree within the
//! kernel's own tolerance, or they would not be twins.

use super::kernels::{Load, large_case, repeats};
use super::{Bench, median};
use anyhow::{Context, Result, anyhow, bail, ensure};
use interreflect::exec::gpu::ModuleSource;
use interreflect::exec::{Executor, GpuExecutor, GpuOptions};
use interreflect_kernels::kernel::Kernel;
use naga::back::spv;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use serde_json::{Value, json};
use std::borrow::Cow;

/// Kernel and its twin.
const TWINS: &[Twin] = &[
    Twin { name: "sh_project", wgsl: include_str!("twins/sh_project.wgsl"), marches: false },
    Twin { name: "voxel_mip", wgsl: include_str!("twins/voxel_mip.wgsl"), marches: false },
    Twin { name: "cone_glossy", wgsl: include_str!("twins/cone_glossy.wgsl"), marches: true },
];

/// A kernel written again by hand.
struct Twin {
    name: &'static str,
    wgsl: &'static str,
    /// Whether it marches: then rounding decides now and then on which side of a voxel's face a step ends, and one word in
    /// [`STRAYS`] may lie further off than the kernel's tolerance.
    marches: bool,
}

/// See [`Twin::marches`].
const STRAYS: usize = 10_000;

const REPEATS: usize = 11;

/// The table of twins.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let Some(adapter) = bench.gpu.as_ref().map(|gpu| gpu.device().adapter) else { return Ok(Value::Null) };
    println!("\n{:<26} {:>12} {:>12} {:>8}", "twin (WGSL)", "WGSL ms", "ours ms", "speed");
    let mut rows = Vec::new();
    for Twin { name, wgsl, marches } in TWINS {
        let kernel =
            interreflect_kernels::all().find(|k| k.desc.name == *name).with_context(|| format!("no {name}"))?;
        let module = spirv_of(wgsl).with_context(|| format!("twin of {name}"))?;
        let load = move |_: &str| Some(Cow::Owned(module.clone()));
        // The canary is another kernel, so the twin's executor keeps the real modules for every other name.
        let modules = ModuleSource::new(move |entry| {
            if entry == *name {
                load(entry)
            } else {
                interreflect_kernels::compiled::module(entry).map(|m| Cow::Borrowed(m.spirv))
            }
        });
        let mut twin =
            GpuExecutor::open(&GpuOptions { adapter: Some(adapter.clone()), modules, ..GpuOptions::default() })?;
        let (theirs, ours) = compare(bench, &mut twin, kernel, if *marches { STRAYS } else { usize::MAX })?;
        let speed = theirs / ours;
        println!("{name:<26} {:>12.3} {:>12.3} {speed:>7.2}×", theirs * 1e3, ours * 1e3);
        rows.push(json!({ "kernel": name, "wgsl_ms": theirs * 1e3, "spirv_ms": ours * 1e3, "speed": speed }));
    }
    Ok(Value::Array(rows))
}

/// Seconds of the twin and of ours, in turns. `strays`: as in [`same`].
fn compare(bench: &mut Bench, twin: &mut GpuExecutor, kernel: &'static Kernel, strays: usize) -> Result<(f64, f64)> {
    let case = large_case(bench, kernel)?;
    let gpu = bench.gpu.as_mut().context("an adapter")?;
    let (on_twin, on_ours) = (Load::new(twin, kernel, &case)?, Load::new(gpu, kernel, &case)?);
    let repeat = repeats(on_ours.seconds(gpu, 1)?);
    on_twin.seconds(twin, 1)?;
    same(kernel, strays, &on_twin.output(twin)?, &on_ours.output(gpu)?)?;
    let (mut theirs, mut ours) = (Vec::new(), Vec::new());
    for _ in 0..REPEATS {
        theirs.push(on_twin.seconds(twin, repeat)?);
        ours.push(on_ours.seconds(gpu, repeat)?);
    }
    on_ours.free(gpu);
    Ok((median(theirs), median(ours)))
}

/// Outputs of floats agree within the kernel's tolerance, but for one word in `strays`.
fn same(kernel: &Kernel, strays: usize, a: &[u32], b: &[u32]) -> Result<()> {
    ensure!(a.len() == b.len(), "{}: the twin wrote {} words, ours {}", kernel.desc.name, a.len(), b.len());
    let differs = |(a, b): &(&u32, &u32)| !kernel.tolerance.accepts(f32::from_bits(**a), f32::from_bits(**b));
    let count = a.iter().zip(b).filter(differs).count();
    if let Some((a, b)) = a.iter().zip(b).find(differs).filter(|_| count > a.len() / strays) {
        let [a, b] = [*a, *b].map(f32::from_bits);
        bail!("{}: {count} words differ; the first is {a} by the twin and {b} by ours", kernel.desc.name);
    }
    Ok(())
}

/// WGSL to SPIR-V as wgpu does it.
fn spirv_of(wgsl: &str) -> Result<Vec<u8>> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|e| anyhow!("{}", e.emit_to_string(wgsl)))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|e| anyhow!("{}", e.emit_to_string(wgsl)))?;
    let checked = BoundsCheckPolicies {
        index: BoundsCheckPolicy::Restrict,
        buffer: BoundsCheckPolicy::Unchecked,
        ..BoundsCheckPolicies::default()
    };
    let options = spv::Options { lang_version: (1, 3), bounds_check_policies: checked, ..spv::Options::default() };
    let words = spv::write_vec(&module, &info, &options, None)?;
    Ok(words.iter().flat_map(|word| word.to_le_bytes()).collect())
}
