//! Compiled kernels into pipelines, both ways: through naga, or as they are.

use super::fault::{one_line, scoped};
use super::{GpuContext, SpirvPath};
use crate::exec::ExecError;
use interreflect_kernels::compiled;
use interreflect_kernels::kernel::{Access, KernelDesc};
use std::borrow::Cow;
use std::collections::HashMap;
use std::num::NonZeroU64;
use std::path::PathBuf;
use std::sync::Arc;

/// Bindings of one kernel: one uniform and at most 8 storage buffers.
pub(super) const MAX_BINDINGS: usize = 9;

/// Buffers of a dispatch, as the key of its bind group; unused places hold `u32::MAX`.
pub(super) type BindKey = [u32; MAX_BINDINGS];

type LoadModule = dyn Fn(&str) -> Option<Cow<'static, [u8]>> + Send + Sync;

/// Where compiled kernels come from: the SPIR-V of an entry point, by its name.
#[derive(Clone)]
pub struct ModuleSource(Arc<LoadModule>);

impl ModuleSource {
    /// Modules from a function.
    pub fn new(load: impl Fn(&str) -> Option<Cow<'static, [u8]>> + Send + Sync + 'static) -> Self {
        Self(Arc::new(load))
    }

    /// The files `NAME.spv` of a folder: to try kernels without compiling the host again.
    pub fn folder(path: impl Into<PathBuf>) -> Self {
        let path = path.into();
        Self::new(move |name| std::fs::read(path.join(format!("{name}.spv"))).ok().map(Cow::Owned))
    }
}

impl Default for ModuleSource {
    /// The folder that `INTERREFLECT_KERNELS` names, otherwise the modules that were compiled into this program.
    fn default() -> Self {
        match std::env::var_os("INTERREFLECT_KERNELS") {
            Some(folder) => Self::folder(folder),
            None => Self::new(|name| compiled::module(name).map(|m| Cow::Borrowed(m.spirv))),
        }
    }
}

/// A kernel that is ready to run.
pub(super) struct Pipeline {
    pub(super) raw: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    /// One bind group for each combination of buffers that it ran on.
    pub(super) bind_groups: HashMap<BindKey, wgpu::BindGroup>,
}

impl Pipeline {
    /// Compiles a kernel for a device.
    pub(super) fn new(context: &GpuContext, desc: &KernelDesc) -> Result<Self, ExecError> {
        check_limits(context, desc)?;
        let error = |reason: String| ExecError::Pipeline { kernel: desc.name.into(), reason };
        let bytes = (context.modules.0)(desc.name)
            .ok_or_else(|| error("there is no compiled module of this name; run `cargo xtask kernels`".into()))?;
        let words = spirv_words(&bytes).ok_or_else(|| error("the compiled module is not SPIR-V".into()))?;
        if !has_entry_point(&words, desc.name) {
            return Err(error("the compiled module has no entry point of this name".into()));
        }
        let layout = bind_group_layout(&context.device, desc);
        scoped(&context.device, || {
            let pipeline_layout = context.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(desc.name),
                bind_group_layouts: &[Some(&layout)],
                immediate_size: 0,
            });
            context.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some(desc.name),
                layout: Some(&pipeline_layout),
                module: &shader_module(context, desc, &words),
                entry_point: Some(desc.name),
                compilation_options: Default::default(),
                cache: None,
            })
        })
        .map(|raw| Self { raw, layout, bind_groups: HashMap::new() })
        .map_err(|e| error(one_line(&e.to_string())))
    }

    /// A bind group of whole buffers. `buffers`: raw buffer and bytes to bind, in the order of the declaration.
    pub(super) fn bind<'a>(
        &self,
        device: &wgpu::Device,
        desc: &KernelDesc,
        buffers: impl Iterator<Item = (&'a wgpu::Buffer, u64)>,
    ) -> wgpu::BindGroup {
        let entries: Vec<wgpu::BindGroupEntry<'_>> = desc
            .bindings
            .iter()
            .zip(buffers)
            .map(|(binding, (buffer, bytes))| wgpu::BindGroupEntry {
                binding: binding.index,
                // A uniform buffer shows its one record; an empty buffer one zero element.
                resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer,
                    offset: 0,
                    size: NonZeroU64::new(if binding.access == Access::Uniform {
                        binding.stride_bytes as u64
                    } else {
                        bytes.max(binding.stride_bytes as u64)
                    }),
                }),
            })
            .collect();
        let descriptor = wgpu::BindGroupDescriptor { label: Some(desc.name), layout: &self.layout, entries: &entries };
        device.create_bind_group(&descriptor)
    }
}

/// What a kernel needs and what there is of it.
pub(super) struct Need {
    what: &'static str,
    needed: u64,
    allowed: u64,
}

impl Need {
    /// In words: `12 storage buffers (8 allowed)`.
    pub(super) fn text(&self) -> String {
        format!("{} {} ({} allowed)", self.needed, self.what, self.allowed)
    }
}

/// The first thing that a device has too little of for a kernel.
pub(super) fn shortcoming(limits: &wgpu::Limits, desc: &KernelDesc) -> Option<Need> {
    let storage = desc.bindings.iter().filter(|b| b.access != Access::Uniform).count() as u64;
    let (workgroup, x) = (limits.max_compute_invocations_per_workgroup, limits.max_compute_workgroup_size_x);
    let needs = [
        ("storage buffers", storage, u64::from(limits.max_storage_buffers_per_shader_stage)),
        ("bindings", desc.bindings.len() as u64, MAX_BINDINGS as u64),
        ("invocations in a workgroup", u64::from(desc.workgroup_size), u64::from(workgroup.min(x))),
    ];
    needs
        .into_iter()
        .map(|(what, needed, allowed)| Need { what, needed, allowed })
        .find(|need| need.needed > need.allowed)
}

/// Whether the device can run such a kernel at all.
fn check_limits(context: &GpuContext, desc: &KernelDesc) -> Result<(), ExecError> {
    if let Some(Need { what, needed, allowed }) = shortcoming(&context.device.limits(), desc) {
        return Err(ExecError::Limit { kernel: desc.name, what, needed, allowed, adapter: context.name.clone() });
    }
    // Passthrough does not renumber bindings as naga does: wgpu numbers them 0, 1, … in the order of the layout.
    if desc.bindings.iter().enumerate().any(|(k, b)| b.index as usize != k) {
        let reason = "bindings must be numbered 0, 1, 2, … in the order of the declaration".into();
        return Err(ExecError::Pipeline { kernel: desc.name.into(), reason });
    }
    Ok(())
}

const HEADER_WORDS: usize = 5;

/// SPIR-V words of a file in this machine's byte order, or nothing where the file is not SPIR-V.
fn spirv_words(bytes: &[u8]) -> Option<Vec<u32>> {
    const MAGIC: u32 = 0x0723_0203;
    let (words, rest) = bytes.as_chunks::<4>();
    let words: Vec<u32> = words.iter().map(|&word| u32::from_le_bytes(word)).collect();
    (rest.is_empty() && words.len() > HEADER_WORDS && words[0] == MAGIC).then_some(words)
}

/// Whether a module has an entry point of this name: a driver that gets such a module as it is may crash without.
fn has_entry_point(words: &[u32], name: &str) -> bool {
    const OP_ENTRY_POINT: u32 = 15;
    let mut rest = &words[HEADER_WORDS..];
    while let Some(&first) = rest.first() {
        let (length, op) = ((first >> 16) as usize, first & 0xFFFF);
        if length == 0 || length > rest.len() {
            return false;
        }
        // Operands: execution model, function, then the name as text that ends with a zero byte.
        if op == OP_ENTRY_POINT && length > 3 {
            let text = rest[3..length].iter().flat_map(|word| word.to_le_bytes()).take_while(|&byte| byte != 0);
            if text.eq(name.bytes()) {
                return true;
            }
        }
        rest = &rest[length..];
    }
    false
}

fn bind_group_layout(device: &wgpu::Device, desc: &KernelDesc) -> wgpu::BindGroupLayout {
    let entries: Vec<wgpu::BindGroupLayoutEntry> = desc
        .bindings
        .iter()
        .map(|binding| wgpu::BindGroupLayoutEntry {
            binding: binding.index,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: match binding.access {
                    Access::Uniform => wgpu::BufferBindingType::Uniform,
                    Access::Read => wgpu::BufferBindingType::Storage { read_only: true },
                    Access::Write | Access::Atomic => wgpu::BufferBindingType::Storage { read_only: false },
                },
                has_dynamic_offset: false,
                min_binding_size: NonZeroU64::new(binding.stride_bytes as u64),
            },
            count: None,
        })
        .collect();
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(desc.name), entries: &entries })
}

#[expect(unsafe_code, reason = "SPIR-V that wgpu does not check")]
fn shader_module(context: &GpuContext, desc: &KernelDesc, words: &[u32]) -> wgpu::ShaderModule {
    let label = Some(desc.name);
    match context.spirv {
        SpirvPath::Naga => {
            let source = wgpu::ShaderSource::SpirV(Cow::Borrowed(words));
            context.device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source })
        }
        SpirvPath::Passthrough => {
            let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
                label,
                entry_points: Cow::Owned(vec![wgpu::PassthroughShaderEntryPoint {
                    name: Cow::Borrowed(desc.name),
                    workgroup_size: (desc.workgroup_size, 1, 1),
                }]),
                spirv: Some(Cow::Borrowed(words)),
                ..Default::default()
            };
            // SAFETY: the module comes from rust-gpu and passed spirv-val and the reflection test; every index in it
            // is checked against the length of its buffer, because kernels are safe Rust.
            unsafe { context.device.create_shader_module_passthrough(descriptor) }
        }
    }
}
