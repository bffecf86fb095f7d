//! Memory of the main job: `compare` on the larger scene, voxel cone tracing at 256, in a process of its own.

use super::{Bench, scene};
use crate::workspace;
use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};
use std::process::Command;

/// Peak memory of the process, and what the method's buffers take.
pub fn run(_: &mut Bench) -> Result<Value> {
    let out = tempfile::tempdir()?;
    let output = Command::new("cargo")
        .args(["run", "--quiet", "--release", "--package", "interreflect", "--", "compare"])
        .args(scene::arguments())
        .args(["--size", "64x64", "--spp", "4", "--methods", "vct", "--set", "vct.resolution=256", "--json"])
        .arg("--backend=cpu")
        .arg("--out")
        .arg(out.path())
        .arg("--cache")
        .arg(out.path())
        .current_dir(workspace::root())
        .output()
        .context("cannot run cargo")?;
    ensure!(output.status.success(), "compare failed: {}", String::from_utf8_lossy(&output.stderr));
    let report: Value = serde_json::from_slice(&output.stdout)?;
    let (peak, buffers) = (&report["peak_memory_bytes"], &report["results"][0]["memory_bytes"]);
    let mib = |bytes: &Value| bytes.as_f64().unwrap_or(f64::NAN) / f64::from(1 << 20);
    println!("\nmemory of `compare` on {}, vct at 256", report["scene"].as_str().unwrap_or("?"));
    println!("peak of the process {:.0} MiB, the method's buffers {:.0} MiB:", mib(peak), mib(&buffers["total"]));
    let parts = buffers["buffers"].as_object().context("buffers")?;
    let parts: Vec<String> = parts.iter().map(|(label, bytes)| format!("{label} {:.1} MiB", mib(bytes))).collect();
    println!("{}", parts.join(", "));
    Ok(json!({ "scene": report["scene"], "peak_bytes": peak, "buffers": buffers }))
}
