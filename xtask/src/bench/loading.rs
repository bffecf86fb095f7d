//! Time to load the compiled kernels, which decides their form: one module per entry point against one module that holds
//! them all (where there is a compiler to make it).
//!
//! What is timed is the first dispatch of every kernel on a fresh device, on an input of a few elements: the module
//! parsed (through naga) or handed on (passthrough), and the pipeline made by the driver.

use super::kernels::Load;
use super::{Bench, median};
use crate::{compile, toolchain};
use anyhow::Result;
use interreflect::exec::gpu::ModuleSource;
use interreflect::exec::{Executor, GpuExecutor, GpuOptions, SpirvPath};
use interreflect_kernels::compiled::MODULES;
use interreflect_kernels::kernel::{CaseInput, Flavour};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::sync::Arc;
use std::time::Instant;

const REPEATS: usize = 3;

/// Milliseconds of all kernels, for both forms of module and both ways to the driver.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let Some(adapter) = bench.gpu.as_ref().map(|gpu| gpu.device().adapter) else { return Ok(Value::Null) };
    let bytes: usize = MODULES.iter().map(|module| module.spirv.len()).sum();
    let mut forms = vec![("per entry point", bytes, ModuleSource::default())];
    if let Some(toolchain) = toolchain::find()? {
        let module: Arc<[u8]> = compile::together(&toolchain)?.into();
        let bytes = module.len();
        forms.push(("together", bytes, ModuleSource::new(move |_| Some(Cow::Owned(module.to_vec())))));
    }
    println!("\n{:<26} {:>10} {:>16} {:>10}", "loading all kernels", "bytes", "passthrough ms", "naga ms");
    let mut rows = Vec::new();
    for (name, bytes, modules) in forms {
        let milliseconds = |spirv| -> Result<f64> {
            let options = GpuOptions {
                adapter: Some(adapter.clone()),
                spirv: Some(spirv),
                modules: modules.clone(),
                ..GpuOptions::default()
            };
            let times: Result<Vec<f64>> = (0..REPEATS).map(|_| first_runs(bench, &options)).collect();
            Ok(median(times?))
        };
        let (passthrough, naga) = (milliseconds(SpirvPath::Passthrough).ok(), milliseconds(SpirvPath::Naga)?);
        let shown = passthrough.map_or_else(|| "–".into(), |ms| format!("{ms:.1}"));
        println!("{name:<26} {bytes:>10} {shown:>16} {naga:>10.1}");
        rows.push(json!({ "form": name, "bytes": bytes, "passthrough_ms": passthrough, "naga_ms": naga }));
    }
    Ok(Value::Array(rows))
}

fn first_runs(bench: &Bench, options: &GpuOptions) -> Result<f64> {
    let mut gpu = GpuExecutor::open(options)?;
    let mut seconds = 0.0;
    for kernel in interreflect_kernels::all().filter(|kernel| bench.wants(kernel.desc.name)) {
        let case = (kernel.case)(&mut CaseInput::new(1, 64, Flavour::Ordinary));
        let load = Load::new(&mut gpu, kernel, &case)?;
        let start = Instant::now();
        load.seconds(&mut gpu, 1)?;
        seconds += start.elapsed().as_secs_f64();
        load.free(&mut gpu);
    }
    Ok(seconds * 1e3)
}
