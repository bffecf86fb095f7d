//! Finds a rust-gpu compiler: a rustc that has the nightly API of one date, and the code generator built for it.

use crate::workspace;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Version of rust-gpu: spirv-std, spirv-builder and the code generator are one version.
pub const RUST_GPU: &str = "0.10.0";
/// The nightly that this rust-gpu is written for.
const NIGHTLY: &str = "nightly-2026-07-03";
/// Environment variable that names a toolchain.
const VARIABLE: &str = "INTERREFLECT_RUST_GPU";

/// A compiler for kernels.
pub struct Toolchain {
    /// Where it came from, for people.
    pub origin: String,
    /// Directory with `bin/rustc` and `bin/cargo`.
    pub sysroot: PathBuf,
    /// The code generator.
    pub backend: PathBuf,
    /// `rustc -V`.
    pub rustc: String,
}

impl Toolchain {
    fn new(origin: String, backend: PathBuf, sysroot: PathBuf) -> Result<Self> {
        if !backend.is_file() {
            bail!("{origin}: there is no {}", backend.display());
        }
        let rustc = sysroot.join("bin/rustc");
        let version = output(Command::new(&rustc).arg("-V")).with_context(|| origin.clone())?;
        Ok(Self { origin, sysroot, backend, rustc: version })
    }
}

/// The first toolchain found: the environment variable, the install script beside the checkout, rustup's nightly.
/// `None` when there is none; an error when one was named but does not work.
pub fn find() -> Result<Option<Toolchain>> {
    if let Some(path) = std::env::var_os(VARIABLE) {
        return from_variable(Path::new(&path)).map(Some);
    }
    let script = workspace::root().join("../shared/toolchain/install.sh");
    if script.is_file() {
        return from_script(&script).map(Some);
    }
    from_rustup()
}

/// How to get a toolchain.
pub fn how_to_get_one() -> String {
    format!(
        "no rust-gpu {RUST_GPU} toolchain found. Get one in one of these ways:\n  \
         1. with rustup (the code generator is then built once, some minutes):\n       \
         rustup toolchain install {NIGHTLY} --component rust-src,rustc-dev,llvm-tools\n       \
         cargo xtask kernels\n  \
         2. from a prebuilt toolchain: put its installer at ../shared/toolchain/install.sh (from the workspace root);\n     \
         it must print the path of {} last\n  \
         3. name one: {VARIABLE}=DIR, a directory with bin/rustc, bin/cargo and lib/{}, or the path of that library",
        library_name(),
        library_name()
    )
}

fn library_name() -> String {
    format!("{}rustc_codegen_spirv{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

/// `path`: a sysroot, or the code generator in a sysroot's `lib`.
fn from_variable(path: &Path) -> Result<Toolchain> {
    let origin = format!("{VARIABLE}={}", path.display());
    let path = std::path::absolute(path)?;
    if path.is_dir() {
        return Toolchain::new(origin, path.join("lib").join(library_name()), path);
    }
    match path.parent().and_then(Path::parent).filter(|sysroot| sysroot.join("bin/rustc").is_file()) {
        Some(sysroot) => Toolchain::new(origin, path.clone(), sysroot.into()),
        // A library of its own goes with rustup's nightly.
        None => match nightly_sysroot() {
            Some(sysroot) => Toolchain::new(origin, path, sysroot),
            None => bail!("{origin}: beside the library there is no ../bin/rustc, and rustup has no {NIGHTLY}"),
        },
    }
}

/// Runs an installer that prints the code generator's path last.
fn from_script(script: &Path) -> Result<Toolchain> {
    let printed = output(Command::new("bash").arg(script)).with_context(|| format!("{}", script.display()))?;
    let backend = PathBuf::from(printed.lines().last().unwrap_or_default());
    let sysroot = backend.parent().and_then(Path::parent).context("the installer printed no path")?.to_path_buf();
    Toolchain::new("../shared/toolchain/install.sh".into(), backend, sysroot)
}

/// rustup's nightly with the compiler's private crates; builds the code generator on first use.
fn from_rustup() -> Result<Option<Toolchain>> {
    let Some(sysroot) = nightly_sysroot() else { return Ok(None) };
    let origin = format!("rustup's {NIGHTLY}");
    let dir = workspace::target().join("rust-gpu-backend");
    let backend = dir.join("target/release").join(library_name());
    if !backend.is_file() {
        build_backend(&dir, &sysroot).with_context(|| {
            format!("{origin}: building rust-gpu {RUST_GPU} (needs the components rust-src, rustc-dev, llvm-tools)")
        })?;
    }
    Toolchain::new(origin, backend, sysroot).map(Some)
}

fn nightly_sysroot() -> Option<PathBuf> {
    let toolchain = format!("+{NIGHTLY}");
    // Without RUSTUP_AUTO_INSTALL=0 rustup would download half a gigabyte that nobody asked for.
    let mut rustc = Command::new("rustc");
    rustc
        .args([toolchain.as_str(), "--print", "sysroot"])
        .env("RUSTUP_AUTO_INSTALL", "0")
        .env_remove("RUSTUP_TOOLCHAIN");
    output(&mut rustc).ok().map(PathBuf::from)
}

/// Builds the code generator as the only dependency of an empty crate.
fn build_backend(dir: &Path, sysroot: &Path) -> Result<()> {
    std::fs::create_dir_all(dir.join("src"))?;
    std::fs::write(dir.join("src/lib.rs"), "")?;
    std::fs::write(
        dir.join("Cargo.toml"),
        format!(
            "[package]\nname = \"rust-gpu-backend\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
             [dependencies]\nrustc_codegen_spirv = \"={RUST_GPU}\"\n\n[workspace]\n"
        ),
    )?;
    eprintln!("building rust-gpu {RUST_GPU} in {} (once)", dir.display());
    let mut cargo = Command::new(sysroot.join("bin/cargo"));
    cargo.args(["build", "--release", "--target-dir", "target"]).current_dir(dir);
    let status = with_toolchain(&mut cargo, sysroot)?.status()?;
    if !status.success() {
        bail!("cargo build: {status}");
    }
    Ok(())
}

/// Makes a command use this toolchain's rustc and cargo, with rustup and without.
pub fn with_toolchain<'a>(command: &'a mut Command, sysroot: &Path) -> Result<&'a mut Command> {
    let old = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths([sysroot.join("bin")].into_iter().chain(std::env::split_paths(&old)))?;
    Ok(command.env("PATH", path).env_remove("RUSTUP_TOOLCHAIN").env_remove("RUSTC").env_remove("CARGO"))
}

/// Standard output of a command that must succeed, without the last line end.
pub fn output(command: &mut Command) -> Result<String> {
    let run = command.output().with_context(|| format!("cannot run {}", command.get_program().to_string_lossy()))?;
    if !run.status.success() {
        let program = command.get_program().to_string_lossy().into_owned();
        bail!("{program}: {}\n{}", run.status, String::from_utf8_lossy(&run.stderr).trim_end());
    }
    Ok(String::from_utf8(run.stdout)?.trim_end().to_owned())
}
