//! Validates SPIR-V (spirv-val and naga) and translates it to WGSL.

use crate::compile::TARGET;
use crate::workspace;
use anyhow::{Result, anyhow, bail};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

/// Parses and validates a module with naga, as a device without any extra feature sees it.
pub fn naga_module(spirv: &[u8]) -> Result<(naga::Module, ModuleInfo)> {
    // The compiled kernels have no positions: no coordinate space to adjust.
    let options = naga::front::spv::Options { adjust_coordinate_space: false, ..Default::default() };
    let module = naga::front::spv::parse_u8_slice(spirv, &options).map_err(|e| anyhow!("naga cannot parse it: {e}"))?;
    let info = validate(&module)?;
    Ok((module, info))
}

fn validate(module: &naga::Module) -> Result<ModuleInfo> {
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(module)
        .map_err(|e| anyhow!("naga finds it invalid: {}", e.emit_to_string("")))
}

/// The module as WGSL, which parses and validates again.
pub fn wgsl(spirv: &[u8]) -> Result<String> {
    let (module, info) = naga_module(spirv)?;
    let text = naga::back::wgsl::write_string(&module, &info, naga::back::wgsl::WriterFlags::empty())?;
    let again = naga::front::wgsl::parse_str(&text)
        .map_err(|e| anyhow!("its WGSL does not parse: {}", e.emit_to_string(&text)))?;
    validate(&again)?;
    Ok(text)
}

/// Runs `spirv-val` on a module. `None` when the program is not there.
pub fn spirv_val(spirv: &[u8]) -> Option<Result<()>> {
    let program = workspace::on_path("spirv-val")?;
    Some(run_spirv_val(&program, spirv))
}

fn run_spirv_val(program: &Path, spirv: &[u8]) -> Result<()> {
    let environment = TARGET.rsplit('-').next().unwrap_or_default();
    let mut child = Command::new(program)
        .args(["--target-env", environment, "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    if let Some(mut stdin) = child.stdin.take() {
        stdin.write_all(spirv)?;
    }
    let output = child.wait_with_output()?;
    if !output.status.success() {
        let words = [output.stdout, output.stderr].concat();
        bail!("spirv-val finds it invalid: {}", String::from_utf8_lossy(&words).trim_end());
    }
    Ok(())
}
