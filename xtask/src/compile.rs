//! Rust to SPIR-V: one module per entry point, without names of functions or debug information.
//!
//! spirv-builder reads its surroundings (PATH, profile variables), so a compile runs in a child process whose
//! environment we choose: the toolchain first on PATH, and no debug information, which would put the whole source text and
//! the paths of this machine into every module.

use crate::toolchain::{self, Toolchain};
use crate::workspace;
use anyhow::{Context, Result, bail};
use spirv_builder::{ModuleResult, SpirvBuilder, SpirvMetadata};
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

/// SPIR-V target: Vulkan 1.2 is what wgpu's Vulkan adapters take.
pub const TARGET: &str = "spirv-unknown-vulkan1.2";

/// Compiles every entry point. Gives the modules by name of the entry point.
pub fn all(toolchain: &Toolchain) -> Result<BTreeMap<String, Vec<u8>>> {
    compile(toolchain, false)
}

/// Compiles every entry point into one module.
pub fn together(toolchain: &Toolchain) -> Result<Vec<u8>> {
    compile(toolchain, true)?.into_values().next().context("the compiler gave no module")
}

fn compile(toolchain: &Toolchain, together: bool) -> Result<BTreeMap<String, Vec<u8>>> {
    // Two compiles at a time would share this directory.
    let out = workspace::target().join(format!("xtask/modules-{}", std::process::id()));
    std::fs::create_dir_all(&out)?;
    let modules = run_child(toolchain, &out, together).and_then(|()| read_modules(&out));
    std::fs::remove_dir_all(&out)?;
    modules
}

fn run_child(toolchain: &Toolchain, out: &Path, together: bool) -> Result<()> {
    let mut child = Command::new(std::env::current_exe()?);
    child.arg("compile-modules").arg("--backend").arg(&toolchain.backend).arg("--out").arg(out);
    if together {
        child.arg("--together");
    }
    child.env("CARGO_PROFILE_RELEASE_DEBUG", "0");
    for variable in ["RUSTGPU_CODEGEN_ARGS", "RUSTGPU_RUSTFLAGS", "RUSTGPU_CARGOFLAGS"] {
        child.env_remove(variable);
    }
    let status = toolchain::with_toolchain(&mut child, &toolchain.sysroot)?.status()?;
    if !status.success() {
        bail!("the kernels do not compile to SPIR-V (compiler's words above)");
    }
    Ok(())
}

fn read_modules(dir: &Path) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut modules = BTreeMap::new();
    for entry in std::fs::read_dir(dir)? {
        let path = entry?.path();
        let name = path.file_stem().and_then(|stem| stem.to_str()).context("an entry point's name is not UTF-8")?;
        modules.insert(name.to_owned(), std::fs::read(&path)?);
    }
    Ok(modules)
}

/// The child process: compiles the kernels crate and puts a `.spv` per entry point, or one `together.spv`, into a directory.
pub fn modules(backend: &Path, out: &Path, together: bool) -> Result<()> {
    let mut builder = SpirvBuilder::new(workspace::root().join("kernels"), TARGET)
        .rustc_codegen_spirv_location(backend)
        .shader_crate_default_features(false)
        .multimodule(!together)
        // Names of the bindings only: they make the WGSL readable.
        .spirv_metadata(SpirvMetadata::NameVariables);
    builder.target_dir_path = Some(workspace::target().join("spirv-builder"));
    match builder.build()?.module {
        ModuleResult::SingleModule(path) => {
            std::fs::copy(path, out.join("together.spv"))?;
        }
        ModuleResult::MultiModule(modules) => {
            for (name, path) in modules {
                std::fs::copy(path, out.join(name).with_extension("spv"))?;
            }
        }
    }
    Ok(())
}
