//! `cargo xtask kernels`: compiles every kernel and writes `kernels/compiled`, or checks what is there.
//!
//! One module per entry point: a host parses only the ones that it runs, and loading all of them takes as long as one module
//! that holds them all (`cargo xtask bench --filter loading`).

use crate::manifest::{self, Compiled};
use crate::source::{Source, sha256};
use crate::toolchain::{self, Toolchain};
use crate::{compile, translate, workspace};
use anyhow::{Context, Result, bail};
use interreflect::exec::manifest::Manifest;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

const MANIFEST: &str = "manifest.json";

/// Compiles every kernel and writes the directory anew.
pub fn write() -> Result<()> {
    let Some(toolchain) = toolchain::find()? else { bail!(toolchain::how_to_get_one()) };
    let source = Source::read()?;
    let compiled = compile(&toolchain)?;
    let manifest = manifest::build(&compiled, &source, &toolchain.rustc)?;

    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    for (name, module) in compiled {
        files.insert(format!("{name}.spv"), module.spirv);
        files.insert(format!("{name}.wgsl"), module.wgsl.into_bytes());
    }
    files.insert(MANIFEST.into(), manifest::text(&manifest)?.into_bytes());

    let changed = replace(&files)?;
    let bytes: usize = files.iter().filter(|(name, _)| name.ends_with(".spv")).map(|(_, bytes)| bytes.len()).sum();
    println!(
        "{} kernels, {bytes} bytes of SPIR-V in kernels/compiled ({})",
        manifest.kernels.len(),
        if changed.is_empty() { "nothing changed".into() } else { format!("changed: {}", changed.join(", ")) }
    );
    Ok(())
}

/// Compiles, validates and translates every entry point, and holds them against the kernel table.
fn compile(toolchain: &Toolchain) -> Result<BTreeMap<String, Compiled>> {
    println!("compiling with {} (rust-gpu {}, {})", toolchain.origin, toolchain::RUST_GPU, toolchain.rustc);
    let modules = compile::all(toolchain)?;
    let declared: BTreeSet<&str> = interreflect_kernels::all().map(|kernel| kernel.desc.name).collect();
    if let Some(name) = modules.keys().find(|name| !declared.contains(name.as_str())) {
        bail!("kernel `{name}` is not in the kernel table: add it to its family's KERNELS");
    }
    if let Some(name) = declared.iter().find(|name| !modules.contains_key(**name)) {
        bail!("kernel `{name}` of the kernel table has no entry point on the device");
    }
    if workspace::on_path("spirv-val").is_none() {
        println!("no spirv-val on PATH: validated with naga alone (Debian: apt-get install spirv-tools)");
    }
    modules.into_iter().map(|(name, spirv)| validated(&name, spirv).map(|module| (name, module))).collect()
}

fn validated(name: &str, spirv: Vec<u8>) -> Result<Compiled> {
    if let Some(result) = translate::spirv_val(&spirv) {
        result.with_context(|| format!("kernel `{name}`"))?;
    }
    let wgsl = translate::wgsl(&spirv).with_context(|| format!("kernel `{name}`"))?;
    Ok(Compiled { spirv, wgsl })
}

/// Makes the directory hold these files and no others. Gives the names of the kernels and files that changed.
fn replace(files: &BTreeMap<String, Vec<u8>>) -> Result<Vec<String>> {
    let dir = workspace::compiled();
    fs::create_dir_all(&dir)?;
    let mut changed = BTreeSet::new();
    for name in names_in_compiled()? {
        if !files.contains_key(&name) {
            fs::remove_file(dir.join(&name))?;
            changed.insert(name);
        }
    }
    for (name, bytes) in files {
        let path = dir.join(name);
        if fs::read(&path).ok().as_ref() != Some(bytes) {
            // Whole or not at all: a build may read the directory meanwhile.
            let part = dir.join(format!("{name}.part"));
            fs::write(&part, bytes)?;
            fs::rename(part, path)?;
            changed.insert(name.trim_end_matches(".wgsl").trim_end_matches(".spv").to_owned());
        }
    }
    Ok(changed.into_iter().collect())
}

fn names_in_compiled() -> Result<BTreeSet<String>> {
    let mut names = BTreeSet::new();
    if let Ok(entries) = fs::read_dir(workspace::compiled()) {
        for entry in entries {
            names.insert(entry?.file_name().to_string_lossy().into_owned());
        }
    }
    Ok(names)
}

/// Fails with one line per kernel whose compiled file is not what the source gives.
pub fn check() -> Result<()> {
    let mut problems = Vec::new();
    match Manifest::read(workspace::compiled().join(MANIFEST)) {
        Ok(manifest) => {
            let compiled = check_files(&manifest, &mut problems)?;
            let source = Source::read()?;
            check_source(&manifest, &source, &mut problems)?;
            check_manifest(&manifest, &compiled, &mut problems)?;
            check_recompile(&manifest, &compiled, &mut problems)?;
        }
        Err(error) => problems.push(error.to_string()),
    }
    if problems.is_empty() {
        println!("kernels/compiled is what the source gives");
        return Ok(());
    }
    bail!("kernels/compiled is stale:\n  {}\nrun `cargo xtask kernels` and commit the result", problems.join("\n  "));
}

/// Every kernel has both files, as the manifest's hashes say, with the WGSL that belongs to the SPIR-V; nothing else is
/// there. Gives the sound modules.
fn check_files(manifest: &Manifest, problems: &mut Vec<String>) -> Result<BTreeMap<String, Compiled>> {
    let mut expected = BTreeSet::from([MANIFEST.to_owned()]);
    let mut compiled = BTreeMap::new();
    for kernel in interreflect_kernels::all() {
        let name = kernel.desc.name;
        expected.extend([format!("{name}.spv"), format!("{name}.wgsl")]);
        let Ok(entry) = manifest.kernel(name) else {
            problems.push(format!("kernel `{name}` has not been compiled"));
            continue;
        };
        let dir = workspace::compiled();
        let (Ok(spirv), Ok(wgsl)) = (fs::read(dir.join(&entry.spirv)), fs::read_to_string(dir.join(&entry.wgsl)))
        else {
            problems.push(format!("kernel `{name}`: its .spv or .wgsl cannot be read"));
            continue;
        };
        if sha256(&spirv) != entry.spirv_sha256 {
            problems.push(format!("kernel `{name}`: {} is not the file that the manifest tells of", entry.spirv));
        } else {
            match validated(name, spirv.clone()) {
                Ok(again) if again.wgsl != wgsl => {
                    problems.push(format!("kernel `{name}`: {} is not the translation of its SPIR-V", entry.wgsl));
                }
                Ok(_) => {}
                Err(error) => problems.push(format!("{error:#}")),
            }
        }
        compiled.insert(name.to_owned(), Compiled { spirv, wgsl });
    }
    for name in names_in_compiled()?.difference(&expected) {
        problems.push(format!("{name}: there is no such kernel"));
    }
    Ok(compiled)
}

/// The source is the one that was compiled.
fn check_source(manifest: &Manifest, source: &Source, problems: &mut Vec<String>) -> Result<()> {
    if manifest.source_sha256 == source.sha256() {
        return Ok(());
    }
    let files = differences(&manifest.sources, &source.files);
    let crates = differences(&manifest.crates, &source.crates);
    let changed = files.iter().chain(&crates).map(String::as_str).collect::<Vec<_>>().join(", ");
    let mut declared = Vec::new();
    for kernel in interreflect_kernels::all() {
        let entry = format!("entry \"{}\"", kernel.desc.name);
        for file in &files {
            let text = fs::read_to_string(workspace::root().join(file)).unwrap_or_default();
            if text.contains(&entry) {
                declared.push(kernel.desc.name);
            }
        }
    }
    // Any kernel may use any file, but the ones declared in a changed file are the likely ones.
    let all: Vec<&str> = interreflect_kernels::all().map(|kernel| kernel.desc.name).collect();
    problems.push(format!(
        "older than its source, which changed in {}: {}",
        if changed.is_empty() { "the manifest's own hash" } else { &changed },
        if declared.is_empty() {
            format!("kernels `{}`", all.join("`, `"))
        } else {
            format!("kernels `{}`", declared.join("`, `"))
        }
    ));
    Ok(())
}

/// Keys whose values differ or that only one side has.
fn differences(a: &BTreeMap<String, String>, b: &BTreeMap<String, String>) -> Vec<String> {
    a.keys()
        .chain(b.keys())
        .filter(|key| a.get(*key) != b.get(*key))
        .cloned()
        .collect::<BTreeSet<_>>()
        .into_iter()
        .collect()
}

/// The manifest says what the declarations say.
fn check_manifest(
    manifest: &Manifest,
    compiled: &BTreeMap<String, Compiled>,
    problems: &mut Vec<String>,
) -> Result<()> {
    let source = Source { files: manifest.sources.clone(), crates: manifest.crates.clone() };
    let expected = manifest::build(compiled, &source, &manifest.compilers.rustc)?;
    for kernel in &expected.kernels {
        if manifest.kernel(&kernel.entry).ok() != Some(kernel) {
            problems
                .push(format!("kernel `{}`: its entry in {MANIFEST} is not what its declaration gives", kernel.entry));
        }
    }
    let text = fs::read_to_string(workspace::compiled().join(MANIFEST))?;
    if text.replace("\r\n", "\n") != manifest::text(&expected)? {
        problems.push(format!("{MANIFEST} is not what `cargo xtask kernels` writes"));
    }
    Ok(())
}

/// A recompile gives the same modules, where there is a compiler.
fn check_recompile(
    manifest: &Manifest,
    compiled: &BTreeMap<String, Compiled>,
    problems: &mut Vec<String>,
) -> Result<()> {
    let Some(toolchain) = toolchain::find()? else {
        println!("no recompile, only the hash of the source: {}", toolchain::how_to_get_one());
        return Ok(());
    };
    let other = if toolchain.rustc == manifest.compilers.rustc {
        String::new()
    } else {
        format!(" (this compiler is {}, that one was {})", toolchain.rustc, manifest.compilers.rustc)
    };
    for (name, module) in compile(&toolchain)? {
        if compiled.get(&name).is_some_and(|old| old.spirv != module.spirv) {
            problems.push(format!("kernel `{name}`: a recompile gives another module{other}"));
        }
    }
    Ok(())
}
