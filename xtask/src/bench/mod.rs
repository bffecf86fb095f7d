//! `cargo xtask bench`: how fast the kernels are, on this machine, against what this machine can do.
//!
//! Every figure of one report comes from one run. Times are medians; CPU and device take turns, so that whatever else the
//! machine does slows both. The report is a table on standard output and `target/bench/bench.json`.
//!
//! A further section is a file here and a row of [`SECTIONS`].

mod bake;
mod kernels;
mod limits;
mod loading;
mod lpv;
mod memory;
mod rays;
mod scene;
mod set_up;
mod srp;
mod twins;
mod voxels;

use crate::workspace;
use anyhow::{Context, Result};
use interreflect::exec::gpu::AdapterKind;
use interreflect::exec::{CpuExecutor, Executor, GpuExecutor, GpuOptions, list_devices, start_threads};
use serde_json::{Value, json};

/// What every section may use.
pub struct Bench {
    /// The processor.
    pub cpu: CpuExecutor,
    /// A software Vulkan driver on the same processor, or another adapter where there is none; nothing without a driver.
    pub gpu: Option<GpuExecutor>,
    /// What this machine can do at best.
    pub limits: limits::Limits,
    /// Only kernels whose name contains this.
    pub filter: Option<String>,
}

impl Bench {
    /// Whether the filter lets a name pass.
    pub fn wants(&self, name: &str) -> bool {
        self.filter.as_deref().is_none_or(|part| name.contains(part))
    }
}

/// One part of the report: prints its table and gives the same as JSON.
type Section = fn(&mut Bench) -> Result<Value>;

const SECTIONS: &[(&str, Section)] = &[
    ("kernels", kernels::run),
    ("twins", twins::run),
    ("loading", loading::run),
    ("rays", rays::run),
    ("voxels", voxels::run),
    ("memory", memory::run),
    ("lpv", lpv::run),
    ("srp", srp::run),
    ("bake", bake::run),
    ("set-up", set_up::run),
];

/// Runs all sections, or the one that the filter names, or of the kernels those whose name contains it.
pub fn run(filter: Option<String>) -> Result<()> {
    start_threads(0);
    let mut cpu = CpuExecutor::new();
    let gpu = software_driver()?;
    let limits = limits::measure(&mut cpu)?;
    let mut bench = Bench { cpu, gpu, limits, filter };
    println!("processor  {}", bench.cpu.device().cpu);
    if let Some(gpu) = &bench.gpu {
        println!("device     {} ({})", gpu.device().adapter, gpu.device().driver);
    } else {
        println!("device     none: no Vulkan driver");
    }
    println!("limits     {}", bench.limits);

    let mut report = json!({
        "cpu": bench.cpu.device(),
        "device": bench.gpu.as_ref().map(|gpu| gpu.device()),
        "limits": bench.limits,
    });
    // A filter that names a section is no filter of kernels.
    let section = bench.filter.take_if(|filter| SECTIONS.iter().any(|(name, _)| filter == name));
    let wanted = section.or_else(|| bench.filter.is_some().then(|| "kernels".into()));
    for (name, run) in SECTIONS.iter().filter(|(name, _)| wanted.as_deref().is_none_or(|wanted| wanted == *name)) {
        report[*name] = run(&mut bench).with_context(|| format!("section `{name}`"))?;
    }
    write(&report)
}

/// Software Vulkan runs the same SPIR-V on the same cores; any other adapter is better than none.
fn software_driver() -> Result<Option<GpuExecutor>> {
    let devices = list_devices();
    let Some(device) = devices.iter().find(|d| d.kind == AdapterKind::Software).or(devices.first()) else {
        return Ok(None);
    };
    let options = GpuOptions { adapter: Some(device.name.clone()), ..GpuOptions::default() };
    Ok(Some(GpuExecutor::open(&options)?))
}

fn write(report: &Value) -> Result<()> {
    let dir = workspace::target().join("bench");
    std::fs::create_dir_all(&dir)?;
    let path = dir.join("bench.json");
    let part = dir.join("bench.json.part");
    std::fs::write(&part, serde_json::to_string_pretty(report)? + "\n")?;
    std::fs::rename(&part, &path)?;
    println!("\nwritten to {}", path.display());
    Ok(())
}

/// Median; the lower one of an even number.
pub fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len().saturating_sub(1) / 2).copied().unwrap_or(f64::NAN)
}

/// Geometric mean; NaN of nothing.
pub fn geometric_mean(values: &[f64]) -> f64 {
    (values.iter().map(|v| v.ln()).sum::<f64>() / values.len() as f64).exp()
}
