//! The kernels' source as one hash: every file of `kernels/src` and `shared/src`, the manifests of both crates, and the
//! versions of the crates that the compiled files depend on.

use crate::workspace;
use anyhow::{Context, Result};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::Path;

/// What is hashed: directories and files, from the workspace root.
const SOURCES: &[&str] = &["kernels/src", "kernels/Cargo.toml", "shared/src", "shared/Cargo.toml"];
/// Packages of Cargo.lock whose code ends up in kernels, or which write the compiled files.
const CRATES: &[&str] = &[
    "bytemuck",
    "bytemuck_derive",
    "glam",
    "libm",
    "naga",
    "num-traits",
    "rustc_codegen_spirv-types",
    "spirv-builder",
    "spirv-std",
    "spirv-std-macros",
    "spirv-std-types",
];
/// Not part of any kernel: what embeds the compiled files.
const EXCLUDED: &[&str] = &["kernels/src/compiled.rs"];

/// The kernels' source.
#[derive(PartialEq, Eq)]
pub struct Source {
    /// SHA-256 by path from the workspace root, with `/`.
    pub files: BTreeMap<String, String>,
    /// Version by crate.
    pub crates: BTreeMap<String, String>,
}

impl Source {
    /// Reads the checkout.
    pub fn read() -> Result<Self> {
        let mut files = BTreeMap::new();
        for source in SOURCES {
            add(&workspace::root().join(source), source, &mut files)?;
        }
        files.retain(|path, _| !EXCLUDED.contains(&path.as_str()));
        let lock = std::fs::read_to_string(workspace::root().join("Cargo.lock")).context("Cargo.lock")?;
        Ok(Self { files, crates: crate_versions(&lock) })
    }

    /// One hash over everything.
    pub fn sha256(&self) -> String {
        let mut text = String::new();
        for (key, value) in self.files.iter().chain(&self.crates) {
            text += &format!("{key} {value}\n");
        }
        sha256(text.as_bytes())
    }
}

/// SHA-256 in hexadecimal.
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn add(path: &Path, name: &str, files: &mut BTreeMap<String, String>) -> Result<()> {
    if path.is_dir() {
        for entry in std::fs::read_dir(path).with_context(|| name.to_owned())? {
            let entry = entry?;
            let child = entry.file_name();
            let child = child.to_str().with_context(|| format!("{name}: a file name is not UTF-8"))?;
            add(&entry.path(), &format!("{name}/{child}"), files)?;
        }
    } else if name.ends_with(".rs") || name.ends_with(".toml") {
        let text = std::fs::read_to_string(path).with_context(|| name.to_owned())?;
        // Git may check out \r\n: the same source.
        files.insert(name.into(), sha256(text.replace("\r\n", "\n").as_bytes()));
    }
    Ok(())
}

/// `name = "…"` and `version = "…"` of the packages in question.
fn crate_versions(lock: &str) -> BTreeMap<String, String> {
    let quoted =
        |line: &str, key: &str| Some(line.strip_prefix(key)?.strip_prefix(" = \"")?.strip_suffix('"')?.to_owned());
    let mut versions = BTreeMap::new();
    let mut name = None;
    for line in lock.lines() {
        name = quoted(line, "name").or(name);
        if let (Some(package), Some(version)) = (&name, quoted(line, "version")) {
            if CRATES.contains(&package.as_str()) {
                versions
                    .entry(package.clone())
                    .and_modify(|v: &mut String| *v = format!("{v}, {version}"))
                    .or_insert(version);
            }
            name = None;
        }
    }
    versions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn line_ends_do_not_matter_and_everything_else_does() {
        let dir = tempfile::tempdir().unwrap();
        let hash = |text: &str| {
            std::fs::write(dir.path().join("a.rs"), text).unwrap();
            std::fs::write(dir.path().join("notes.txt"), text).unwrap();
            let mut files = BTreeMap::new();
            add(dir.path(), "kernels/src", &mut files).unwrap();
            assert_eq!(files.keys().collect::<Vec<_>>(), ["kernels/src/a.rs"], "only sources count");
            Source { files, crates: BTreeMap::new() }.sha256()
        };
        assert_eq!(hash("fn a() {}\n"), hash("fn a() {}\r\n"));
        assert_ne!(hash("fn a() {}\n"), hash("fn b() {}\n"));
    }

    #[test]
    fn versions_come_from_the_lock_file() {
        let lock = "version = 4\n\n[[package]]\nname = \"glam\"\nversion = \"0.33.1\"\n\n\
                    [[package]]\nname = \"other\"\nversion = \"1.0.0\"\n\n\
                    [[package]]\nname = \"glam\"\nversion = \"0.34.0\"\n";
        let versions = crate_versions(lock);
        assert_eq!(versions.into_iter().collect::<Vec<_>>(), [("glam".into(), "0.33.1, 0.34.0".into())]);
        let source = Source::read().unwrap();
        assert!(
            source.files.contains_key("kernels/src/kernel.rs") && source.files.contains_key("shared/src/record.rs")
        );
        assert_eq!(source.crates["spirv-std"], crate::toolchain::RUST_GPU, "rust-gpu is one version throughout");
    }
}
