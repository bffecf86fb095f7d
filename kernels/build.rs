//! Lists the compiled kernels (`compiled/*.spv` and their WGSL) for `src/compiled.rs`.
//!
//! A build script and not a committed list: the crate, and with it the tool that compiles the kernels, builds whatever
//! the directory holds, also nothing.

use std::{env, fmt::Write as _, fs, io, path::Path};

fn main() -> io::Result<()> {
    let dir = Path::new(&env::var("CARGO_MANIFEST_DIR").unwrap_or_default()).join("compiled");
    println!("cargo::rerun-if-changed=build.rs");
    // Cargo takes a directory that is not there for one that always changes.
    println!("cargo::rerun-if-changed={}", if dir.is_dir() { "compiled" } else { "." });

    let mut names: Vec<String> = fs::read_dir(&dir)
        .map(|entries| {
            entries.flatten().filter_map(|e| Some(e.file_name().to_str()?.strip_suffix(".spv")?.to_owned())).collect()
        })
        .unwrap_or_default();
    names.retain(|name| dir.join(name).with_extension("wgsl").is_file());
    names.sort();

    let mut code = String::from("&[\n");
    for name in &names {
        let path = dir.join(name);
        let (spirv, wgsl) = (path.with_extension("spv"), path.with_extension("wgsl"));
        let _ = writeln!(
            code,
            "Module {{ name: {name:?}, spirv: include_bytes!({spirv:?}), wgsl: include_str!({wgsl:?}) }},"
        );
    }
    code.push_str("]\n");
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    fs::write(Path::new(&out).join("modules.rs"), code)?;
    let manifest = dir.join("manifest.json");
    let manifest = if manifest.is_file() { format!("include_str!({manifest:?})\n") } else { String::from("\"\"\n") };
    fs::write(Path::new(&out).join("manifest.rs"), manifest)
}
