//! Makes `manifest.json` from the kernels' declarations, the compiled modules and the source.

use crate::compile::TARGET;
use crate::source::{Source, sha256};
use crate::toolchain::RUST_GPU;
use anyhow::{Result, bail};
use interreflect::exec::manifest::{
    AccessKind, BindingEntry, Compilers, FORMAT, FieldLayout, KernelEntry, Manifest, RecordLayout,
};
use interreflect_kernels::kernel::{Access, Binding, FOLD_WIDTH, Form, Kernel};
use interreflect_shared::Word;
use std::collections::BTreeMap;

/// A compiled entry point.
pub struct Compiled {
    /// SPIR-V.
    pub spirv: Vec<u8>,
    /// WGSL.
    pub wgsl: String,
}

/// The manifest of all kernels. Fails when two records share a name but not a layout.
pub fn build(compiled: &BTreeMap<String, Compiled>, source: &Source, rustc: &str) -> Result<Manifest> {
    let mut manifest = Manifest {
        format: FORMAT,
        source_sha256: source.sha256(),
        compilers: Compilers {
            rustc: rustc.into(),
            rust_gpu: RUST_GPU.into(),
            target: TARGET.into(),
            naga: source.crates.get("naga").cloned().unwrap_or_default(),
        },
        fold_width: FOLD_WIDTH,
        kernels: Vec::new(),
        records: BTreeMap::new(),
        sources: source.files.clone(),
        crates: source.crates.clone(),
        directory: None,
    };
    for kernel in interreflect_kernels::all() {
        let Some(module) = compiled.get(kernel.desc.name) else { continue };
        manifest.kernels.push(entry(kernel, module));
        for binding in kernel.desc.bindings {
            let layout = layout(binding);
            let known = manifest.records.entry(binding.record.into()).or_insert_with(|| layout.clone());
            if *known != layout {
                bail!("kernel `{}`: two records are called `{}`", kernel.desc.name, binding.record);
            }
        }
    }
    manifest.kernels.sort_by(|a, b| a.entry.cmp(&b.entry));
    Ok(manifest)
}

/// The manifest's text.
pub fn text(manifest: &Manifest) -> Result<String> {
    Ok(serde_json::to_string_pretty(manifest)? + "\n")
}

fn entry(kernel: &Kernel, module: &Compiled) -> KernelEntry {
    let name = kernel.desc.name;
    KernelEntry {
        entry: name.into(),
        form: match kernel.form {
            Form::Plain => "plain",
            Form::Lanes => "lanes",
            Form::Scatter => "scatter",
        }
        .into(),
        workgroup: [kernel.desc.workgroup_size, 1, 1],
        planes: kernel.plane_count as u32,
        spirv: format!("{name}.spv"),
        spirv_sha256: sha256(&module.spirv),
        wgsl: format!("{name}.wgsl"),
        wgsl_sha256: sha256(module.wgsl.as_bytes()),
        bindings: kernel.desc.bindings.iter().map(binding).collect(),
    }
}

fn binding(binding: &Binding) -> BindingEntry {
    BindingEntry {
        binding: binding.index,
        name: binding.name.into(),
        access: match binding.access {
            Access::Uniform => AccessKind::Uniform,
            Access::Read => AccessKind::Read,
            Access::Write => AccessKind::Write,
            Access::Atomic => AccessKind::Atomic,
        },
        stride_bytes: binding.stride_bytes as u32,
        record: binding.record.into(),
    }
}

fn layout(binding: &Binding) -> RecordLayout {
    let fields = binding.fields.iter().map(|field| FieldLayout {
        name: field.name.into(),
        offset_bytes: field.offset_bytes as u32,
        words: field.word_count as u32,
        word: match field.word {
            Word::F32 => "f32",
            Word::U32 => "u32",
            Word::I32 => "i32",
        }
        .into(),
    });
    RecordLayout { size_bytes: binding.stride_bytes as u32, fields: fields.collect() }
}
