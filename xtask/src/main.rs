//! Development tasks of Interreflect: `cargo xtask kernels | test | ci | bench`.

use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

mod bench;
mod browser;
mod ci;
mod compile;
mod kernels;
mod manifest;
mod source;
mod toolchain;
mod translate;
mod vulkan;
mod workspace;

/// What is timed has the memory of the program.
#[global_allocator]
static ALLOCATOR: interreflect::memory::LargePages = interreflect::memory::LargePages;

#[derive(Parser)]
#[command(name = "cargo xtask", about = "Compiles, checks and benchmarks Interreflect's kernels")]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Compile every kernel to SPIR-V and WGSL and write kernels/compiled
    Kernels {
        /// Write nothing; fail when kernels/compiled is not what today's source gives
        #[arg(long)]
        check: bool,
    },
    /// See to a Vulkan driver, then run every test, those on a device included
    Test {
        /// Arguments for `cargo test --release --workspace`
        #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
        args: Vec<String>,
    },
    /// What continuous integration runs before `test`: format, lints, documentation, kernels/compiled
    Ci,
    /// Time every kernel against this machine's limits and a software driver; table and target/bench/bench.json
    Bench {
        /// Only kernels whose name contains this, or only the section of this name
        #[arg(long)]
        filter: Option<String>,
    },
    /// One compile in a process of its own (see `compile.rs`)
    #[command(hide = true)]
    CompileModules {
        #[arg(long)]
        backend: PathBuf,
        #[arg(long)]
        out: PathBuf,
        #[arg(long)]
        together: bool,
    },
}

fn main() -> ExitCode {
    let done = match Cli::parse().task {
        Task::Kernels { check: false } => kernels::write(),
        Task::Kernels { check: true } => kernels::check(),
        Task::Test { args } => ci::test(&args),
        Task::Ci => ci::checks(),
        Task::Bench { filter } => bench::run(filter),
        Task::CompileModules { backend, out, together } => compile::modules(&backend, &out, together),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}
