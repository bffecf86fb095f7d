//! Finding adapters: what there is, which one `auto` and `gpu` mean, and what each can do.

use super::SpirvPath;
use super::pipeline::shortcoming;
use crate::exec::ExecError;
use serde::Serialize;

/// What an adapter is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AdapterKind {
    /// A graphics card of its own.
    Discrete,
    /// Part of the processor, or sharing its memory.
    Integrated,
    /// A share of a graphics card in a virtual machine.
    Virtual,
    /// The driver does not say.
    Unknown,
    /// A driver that runs on the processor (lavapipe, SwiftShader, WARP).
    Software,
}

impl AdapterKind {
    /// Whether `auto` may take it.
    pub fn is_hardware(self) -> bool {
        matches!(self, AdapterKind::Discrete | AdapterKind::Integrated | AdapterKind::Virtual)
    }
}

/// What an adapter is and what it allows: one row of `interreflect devices`.
#[derive(Clone, Debug, Serialize)]
pub struct AdapterReport {
    /// Name; `--adapter` takes any part of it.
    pub name: String,
    /// What it is.
    pub kind: AdapterKind,
    /// Graphics interface: `vulkan`, `metal` or `dx12`.
    pub interface: String,
    /// Driver name and version.
    pub driver: String,
    /// Whether it takes SPIR-V as it is.
    pub spirv_passthrough: bool,
    /// Whether it measures time by itself.
    pub timestamps: bool,
    /// Largest buffer that a kernel may bind, in bytes.
    pub max_binding_bytes: u64,
    /// Largest buffer in bytes.
    pub max_buffer_bytes: u64,
    /// Storage buffers that one kernel may bind.
    pub max_storage_buffers: u32,
    /// Invocations of one workgroup.
    pub max_workgroup_size: u32,
    /// Kernels that it cannot run, each with what there is too little of; empty on any WebGPU adapter.
    pub cannot_run: Vec<String>,
}

impl AdapterReport {
    fn of(adapter: &wgpu::Adapter) -> Self {
        let (info, limits) = (adapter.get_info(), adapter.limits());
        Self {
            name: info.name.clone(),
            kind: match info.device_type {
                wgpu::DeviceType::DiscreteGpu => AdapterKind::Discrete,
                wgpu::DeviceType::IntegratedGpu => AdapterKind::Integrated,
                wgpu::DeviceType::VirtualGpu => AdapterKind::Virtual,
                wgpu::DeviceType::Cpu => AdapterKind::Software,
                wgpu::DeviceType::Other => AdapterKind::Unknown,
            },
            interface: info.backend.to_string(),
            driver: format!("{} {}", info.driver, info.driver_info).trim().to_string(),
            // On other interfaces passthrough means their own shader languages.
            spirv_passthrough: info.backend == wgpu::Backend::Vulkan
                && adapter.features().contains(wgpu::Features::PASSTHROUGH_SHADERS),
            timestamps: adapter.features().contains(wgpu::Features::TIMESTAMP_QUERY),
            max_binding_bytes: limits.max_storage_buffer_binding_size,
            max_buffer_bytes: limits.max_buffer_size,
            max_storage_buffers: limits.max_storage_buffers_per_shader_stage,
            max_workgroup_size: limits.max_compute_invocations_per_workgroup,
            cannot_run: interreflect_kernels::all()
                .filter_map(|k| Some(format!("{}: {}", k.desc.name, shortcoming(&limits, &k.desc)?.text())))
                .collect(),
        }
    }
}

/// An adapter with its report.
pub(super) struct Found {
    pub(super) adapter: wgpu::Adapter,
    pub(super) report: AdapterReport,
}

/// Every adapter, the fastest kind first.
fn enumerate() -> Vec<Found> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12;
    let instance = wgpu::Instance::new(descriptor);
    let adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    let mut found: Vec<Found> =
        adapters.into_iter().map(|adapter| Found { report: AdapterReport::of(&adapter), adapter }).collect();
    found.sort_by_key(|f| f.report.kind as u32);
    found
}

/// Every adapter of this machine, the fastest kind first.
pub fn list_devices() -> Vec<AdapterReport> {
    enumerate().into_iter().map(|f| f.report).collect()
}

/// Which adapter is wanted.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Wanted<'a> {
    /// Any part of its name, whatever the case.
    pub(super) name: Option<&'a str>,
    /// No software driver.
    pub(super) hardware_only: bool,
    /// How it must take SPIR-V.
    pub(super) spirv: Option<SpirvPath>,
}

/// The first adapter of the wanted kind.
pub(super) fn find(wanted: Wanted<'_>) -> Result<Found, ExecError> {
    let found = enumerate();
    let names: Vec<String> = found.iter().map(|f| format!("{} ({:?})", f.report.name, f.report.kind)).collect();
    let fits = |f: &Found| {
        let named = wanted.name.is_none_or(|name| f.report.name.to_lowercase().contains(&name.to_lowercase()));
        let takes = wanted.spirv != Some(SpirvPath::Passthrough) || f.report.spirv_passthrough;
        named && takes && (!wanted.hardware_only || f.report.kind.is_hardware())
    };
    found.into_iter().find(fits).ok_or_else(|| ExecError::NoAdapter {
        wanted: wanted.describe(),
        reason: if names.is_empty() {
            "this machine has no Vulkan, Metal or Direct3D 12 driver".into()
        } else {
            format!("found {}", names.join(", "))
        },
    })
}

impl Wanted<'_> {
    fn describe(&self) -> String {
        let mut text = String::from(if self.hardware_only { "hardware GPU" } else { "GPU" });
        if let Some(name) = self.name {
            text += &format!(" named `{name}`");
        }
        if self.spirv == Some(SpirvPath::Passthrough) {
            text += " with SPIR-V passthrough";
        }
        text
    }
}
