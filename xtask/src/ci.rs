//! `cargo xtask test` and `cargo xtask ci`.

use crate::{browser, kernels, vulkan, workspace};
use anyhow::{Context, Result, bail};
use std::process::Command;
use std::time::Instant;

/// Every test, those on a device included: without an adapter they fail and are not ignored. Those in a browser are
/// ignored only where none can be had.
pub fn test(args: &[String]) -> Result<()> {
    vulkan::ensure_driver()?;
    let mut command = cargo(&["test", "--release", "--workspace"]);
    if browser::ensure() {
        command.env("INTERREFLECT_REQUIRE_BROWSER", "1");
    }
    run(command.args(args).env("INTERREFLECT_REQUIRE_GPU", "1"))
}

/// What continuous integration runs before the tests. One profile throughout, so that the steps share what they build.
pub fn checks() -> Result<()> {
    step("format", || run(&mut cargo(&["fmt", "--all", "--check"])))?;
    step("lints", || {
        run(&mut cargo(&["clippy", "--release", "--workspace", "--all-targets", "--", "-D", "warnings"]))
    })?;
    step("documentation", || {
        let mut doc = cargo(&["doc", "--release", "--workspace", "--no-deps"]);
        run(doc.env("RUSTDOCFLAGS", "-D warnings"))
    })?;
    step("compiled kernels", kernels::check)
}

fn step(name: &str, task: impl FnOnce() -> Result<()>) -> Result<()> {
    println!("== {name}");
    let start = Instant::now();
    task().with_context(|| name.to_owned())?;
    println!("== {name}: {:.0} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn cargo(args: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(args).current_dir(workspace::root());
    command
}

fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("cannot run {}", command.get_program().to_string_lossy()))?;
    if !status.success() {
        let args: Vec<_> = command.get_args().map(|arg| arg.to_string_lossy()).collect();
        bail!("cargo {}: {status}", args.join(" "));
    }
    Ok(())
}
