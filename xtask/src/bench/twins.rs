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
const TWINS: &[(&str, &str)] = &[
    ("sh_project", include_str!("twins/sh_project.wgsl")),
    ("voxel_mip", include_str!("twins/voxel_mip.wgsl")),
    ("cone_glossy", include_str!("twins/cone_glossy.wgsl")),
];
const REPEATS: usize = 11;

/// The table of twins.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let Some(adapter) = bench.gpu.as_ref().map(|gpu| gpu.device().adapter) else { return Ok(Value::Null) };
    println!("\n{:<26} {:>12} {:>12} {:>8}", "twin (WGSL)", "WGSL ms", "ours ms", "speed");
    let mut rows = Vec::new();
    for (name, wgsl) in TWINS {
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
        let (theirs, ours) = compare(bench, &mut twin, kernel)?;
        let speed = theirs / ours;
        println!("{name:<26} {:>12.3} {:>12.3} {speed:>7.2}×", theirs * 1e3, ours * 1e3);
        rows.push(json!({ "kernel": name, "wgsl_ms": theirs * 1e3, "spirv_ms": ours * 1e3, "speed": speed }));
    }
    Ok(Value::Array(rows))
}

/// Seconds of the twin and of ours, in turns.
fn compare(bench: &mut Bench, twin: &mut GpuExecutor, kernel: &'static Kernel) -> Result<(f64, f64)> {
    let case = large_case(bench, kernel)?;
    let gpu = bench.gpu.as_mut().context("an adapter")?;
    let (on_twin, on_ours) = (Load::new(twin, kernel, &case)?, Load::new(gpu, kernel, &case)?);
    let repeat = repeats(on_ours.seconds(gpu, 1)?);
    on_twin.seconds(twin, 1)?;
    same(kernel, &on_twin.output(twin)?, &on_ours.output(gpu)?)?;
    let (mut theirs, mut ours) = (Vec::new(), Vec::new());
    for _ in 0..REPEATS {
        theirs.push(on_twin.seconds(twin, repeat)?);
        ours.push(on_ours.seconds(gpu, repeat)?);
    }
    on_ours.free(gpu);
    Ok((median(theirs), median(ours)))
}

/// Words, one in so many, that may lie further apart: rounding decides at which side of a voxel's face a march steps on.
const STRAYS: usize = 10_000;

/// Outputs of floats agree within the kernel's tolerance, but for a few of many.
fn same(kernel: &Kernel, a: &[u32], b: &[u32]) -> Result<()> {
    ensure!(a.len() == b.len(), "{}: the twin wrote {} words, ours {}", kernel.desc.name, a.len(), b.len());
    let differs = |(a, b): &(&u32, &u32)| !kernel.tolerance.accepts(f32::from_bits(**a), f32::from_bits(**b));
    let strays = a.iter().zip(b).filter(differs).count();
    if let Some((a, b)) = a.iter().zip(b).find(differs).filter(|_| strays > a.len() / STRAYS) {
        let [a, b] = [*a, *b].map(f32::from_bits);
        bail!("{}: {strays} words differ; the first is {a} by the twin and {b} by ours", kernel.desc.name);
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
