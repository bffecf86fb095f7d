//! Kernels on a GPU (or a software driver of one) through wgpu.
//!
//! Calls are recorded and handed to the device in batches; [`Executor::read`] and [`Executor::end`] wait. Pipelines and
//! bind groups are made at their first use and kept, so that a frame loop creates nothing. Kernels run from the same
//! SPIR-V in either of two ways ([`SpirvPath`]).
//!
//! Through naga, wgpu's own checks of indices, loops and divisors stay on. Kernels would be sound without (safe Rust
//! checks every index), but switching them off gained nothing measurable: on lavapipe `trace_gbuffer` took 7.0 ms with
//! and 7.1 ms without, `trace_rays` 4.0 and 3.5 ms, `smoke_madd` 0.53 and 0.57 ms.

mod adapter;
mod fault;
mod pipeline;
mod transfer;

pub use adapter::{AdapterKind, AdapterReport, list_devices};
pub use pipeline::ModuleSource;

use super::{BufferId, DeviceInfo, ExecError, Executor, Mark, check_bindings, check_rows, check_write};
use fault::{Faults, NO_MEMORY, one_line, scoped};
use interreflect_kernels::kernel::{Access, Kernel, Rows};
use interreflect_kernels::smoke;
use interreflect_shared::smoke::SmokeParams;
use pipeline::{BindKey, MAX_BINDINGS, Pipeline};
use serde::Serialize;
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc;
use std::time::Instant;
use transfer::{DeviceClock, Readback};

/// How a kernel's SPIR-V reaches the driver.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SpirvPath {
    /// As it is (Vulkan with `PASSTHROUGH_SHADERS`).
    Passthrough,
    /// Parsed, validated and written again by naga, as on Metal, Direct3D and the web.
    Naga,
}

impl std::str::FromStr for SpirvPath {
    type Err = ExecError;
    fn from_str(text: &str) -> Result<Self, ExecError> {
        match text {
            "passthrough" => Ok(SpirvPath::Passthrough),
            "naga" => Ok(SpirvPath::Naga),
            _ => Err(ExecError::Option {
                name: "INTERREFLECT_SPIRV",
                value: text.into(),
                allowed: "passthrough or naga",
            }),
        }
    }
}

/// What [`GpuExecutor::open`] is asked for; the default is any adapter, hardware first.
#[derive(Clone, Default)]
pub struct GpuOptions {
    /// Any part of the adapter's name, whatever the case.
    pub adapter: Option<String>,
    /// Refuse software drivers.
    pub hardware_only: bool,
    /// Passthrough or naga; otherwise passthrough where the adapter has it.
    pub spirv: Option<SpirvPath>,
    /// Where compiled kernels come from.
    pub modules: ModuleSource,
}

/// Number of device objects that a [`GpuExecutor`] holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct GpuObjects {
    /// Live buffers.
    pub buffers: usize,
    /// Kernels that have run.
    pub pipelines: usize,
    /// Combinations of kernel and buffers that have run.
    pub bind_groups: usize,
    /// Size of the buffer that results are read through.
    pub staging_bytes: u64,
}

/// Device, queue and what pipelines need to know.
pub(crate) struct GpuContext {
    device: wgpu::Device,
    queue: wgpu::Queue,
    name: String,
    spirv: SpirvPath,
    modules: ModuleSource,
}

struct GpuBuffer {
    label: String,
    /// Size that was asked for; the device's buffer is larger where that is small.
    bytes: u64,
    raw: wgpu::Buffer,
    /// What a small buffer holds, while only the host has written to it: a kernel's rows follow from its uniform.
    shadow: Option<Vec<u32>>,
    /// The batch that last used it.
    batch: u64,
}

/// Commands that the device has not got yet.
struct Recording {
    encoder: wgpu::CommandEncoder,
    pass: Option<wgpu::ComputePass<'static>>,
    dispatches: u32,
}

/// Runs kernels on an adapter.
pub struct GpuExecutor {
    context: GpuContext,
    faults: Faults,
    info: DeviceInfo,
    max_bytes: u64,
    max_uniform_bytes: u64,
    buffers: Vec<Option<GpuBuffer>>,
    pipelines: HashMap<&'static str, Pipeline>,
    recording: Option<Recording>,
    batch: u64,
    pending_upload_bytes: u64,
    readback: Readback,
    clock: Option<DeviceClock>,
    started: Option<Instant>,
}

/// Device buffers are at least this long: the largest element that a kernel binds fits into an empty one.
const MIN_BUFFER_BYTES: u64 = 1024;
/// Buffers up to this size may be uniforms and keep a shadow.
const MAX_SHADOW_BYTES: u64 = 1024;
/// Dispatches that wait for others before the device gets them: enough to make a submission cheap, few enough that the
/// device starts early and no submission runs into a driver's time limit.
const MAX_BATCH: u32 = 32;
/// Uploads that wait for a submission, in bytes: each holds a staging buffer of its size until then.
const MAX_PENDING_UPLOAD_BYTES: u64 = 64 << 20;

impl GpuExecutor {
    /// Opens an adapter and proves by a canary dispatch that it writes what a kernel says.
    ///
    /// # Errors
    /// [`ExecError::NoAdapter`] where no adapter fits, [`ExecError::BrokenDevice`] where the device cannot be opened or
    /// the canary fails.
    pub fn open(options: &GpuOptions) -> Result<Self, ExecError> {
        let wanted = adapter::Wanted {
            name: options.adapter.as_deref(),
            hardware_only: options.hardware_only,
            spirv: options.spirv,
        };
        let found = adapter::find(wanted)?;
        let spirv = options.spirv.unwrap_or(if found.report.spirv_passthrough {
            SpirvPath::Passthrough
        } else {
            SpirvPath::Naga
        });
        let mut executor = Self::on(&found, spirv, options.modules.clone())?;
        executor.canary()?;
        Ok(executor)
    }

    /// As [`GpuExecutor::open`]; where nobody asked for passthrough and it does not work, tries naga's way.
    pub(crate) fn open_or_naga(options: &GpuOptions, warn: &mut dyn FnMut(String)) -> Result<Self, ExecError> {
        match Self::open(options) {
            Err(error @ (ExecError::BrokenDevice { .. } | ExecError::Pipeline { .. } | ExecError::Device { .. }))
                if options.spirv.is_none() =>
            {
                let naga = Self::open(&GpuOptions { spirv: Some(SpirvPath::Naga), ..options.clone() })?;
                warn(format!("{error}; going on with SPIR-V through naga"));
                Ok(naga)
            }
            other => other,
        }
    }

    fn on(found: &adapter::Found, spirv: SpirvPath, modules: ModuleSource) -> Result<Self, ExecError> {
        let report = &found.report;
        let mut features = found.adapter.features() & wgpu::Features::TIMESTAMP_QUERY;
        if spirv == SpirvPath::Passthrough {
            features |= wgpu::Features::PASSTHROUGH_SHADERS;
        }
        let limits = found.adapter.limits();
        let (device, queue) = pollster::block_on(found.adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("interreflect"),
            required_features: features,
            required_limits: limits.clone(),
            ..Default::default()
        }))
        .map_err(|e| ExecError::BrokenDevice { adapter: report.name.clone(), reason: one_line(&e.to_string()) })?;
        let processor = super::cpu::processor_name();
        Ok(Self {
            faults: Faults::watch(&device),
            info: DeviceInfo {
                backend: if spirv == SpirvPath::Naga { "gpu" } else { "gpu-passthrough" }.into(),
                adapter: report.name.clone(),
                driver: report.driver.clone(),
                cpu: format!("{processor}, {} threads", rayon::current_num_threads()),
                hardware_gpu: report.kind.is_hardware(),
            },
            max_bytes: limits.max_buffer_size.min(limits.max_storage_buffer_binding_size),
            max_uniform_bytes: limits.max_uniform_buffer_binding_size,
            buffers: Vec::new(),
            pipelines: HashMap::new(),
            recording: None,
            batch: 0,
            pending_upload_bytes: 0,
            readback: Readback::default(),
            clock: DeviceClock::new(&device, &queue),
            started: None,
            context: GpuContext { device, queue, name: report.name.clone(), spirv, modules },
        })
    }

    /// Runs `smoke_fill` over a buffer of other words and looks at every one of them.
    fn canary(&mut self) -> Result<(), ExecError> {
        const COUNT: u32 = 1021;
        const BEFORE: u32 = 0xDEAD_BEEF;
        let params = SmokeParams { count: COUNT, seed: 0x5EED, scale: 0.0, _pad: 0 };
        let uniform = self.upload("canary parameters", bytemuck::bytes_of(&params))?;
        let out = self.upload("canary", bytemuck::cast_slice(&[BEFORE; COUNT as usize]))?;
        self.run(&smoke::smoke_fill::KERNEL, &[uniform, out])?;
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(&self.read(out)?);
        self.free(out);
        self.free(uniform);
        match (0..COUNT).find(|&i| words[i as usize] != smoke::fill(i, &params)) {
            None => Ok(()),
            Some(i) => Err(ExecError::BrokenDevice {
                adapter: self.context.name.clone(),
                reason: format!(
                    "word {i} of the canary is {:#x} and should be {:#x}",
                    words[i as usize],
                    smoke::fill(i, &params)
                ),
            }),
        }
    }

    /// How many device objects exist: what a frame loop must not change.
    pub fn objects(&self) -> GpuObjects {
        GpuObjects {
            buffers: self.buffers.iter().flatten().count(),
            pipelines: self.pipelines.len(),
            bind_groups: self.pipelines.values().map(|p| p.bind_groups.len()).sum(),
            staging_bytes: self.readback.bytes(),
        }
    }

    /// Loses the device on purpose: what follows must be [`ExecError::DeviceLost`]. For tests of a caller's handling.
    pub fn destroy_device(&mut self) {
        self.recording = None;
        self.context.device.destroy();
        // The loss is reported once the device is idle.
        let _ = self.wait("destroying the device");
    }

    fn buffer(&self, id: BufferId) -> Result<&GpuBuffer, ExecError> {
        self.buffers.get(id.0 as usize).and_then(Option::as_ref).ok_or_else(ExecError::freed)
    }

    fn buffer_mut(&mut self, id: BufferId) -> Result<&mut GpuBuffer, ExecError> {
        self.buffers.get_mut(id.0 as usize).and_then(Option::as_mut).ok_or_else(ExecError::freed)
    }

    /// The batch in which the next command is recorded, outside of any pass.
    fn encoder(&mut self) -> &mut wgpu::CommandEncoder {
        let recording = self.recording();
        recording.pass = None;
        &mut recording.encoder
    }

    fn recording(&mut self) -> &mut Recording {
        let device = &self.context.device;
        self.recording.get_or_insert_with(|| Recording {
            encoder: device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("kernels") }),
            pass: None,
            dispatches: 0,
        })
    }

    /// Hands what was recorded and uploaded to the device.
    fn submit(&mut self) {
        let commands = self.recording.take().map(|mut recording| {
            recording.pass = None;
            recording.encoder.finish()
        });
        self.context.queue.submit(commands);
        self.batch += 1;
        self.pending_upload_bytes = 0;
    }

    /// Waits until the device has done all that it got.
    fn wait(&mut self, during: &str) -> Result<(), ExecError> {
        let device = &self.context.device;
        // wgpu 30 panics in `poll` where the device is lost while it waits; that is an error like others here.
        match catch_unwind(AssertUnwindSafe(|| device.poll(wgpu::PollType::wait_indefinitely()))) {
            Ok(Ok(_)) => {}
            Ok(Err(error)) => self.faults.lose(error.to_string()),
            Err(_) => self.faults.lose("the driver failed while the host waited for it".into()),
        }
        self.faults.check(during)
    }

    /// Submits, waits and copies a staging buffer's first `bytes` to the end of `out`.
    fn fetch(&mut self, staging: &wgpu::Buffer, bytes: u64, during: &str, out: &mut Vec<u8>) -> Result<(), ExecError> {
        self.submit();
        let slice = staging.slice(..bytes);
        let (tell, told) = mpsc::channel();
        slice.map_async(wgpu::MapMode::Read, move |result| {
            let _ = tell.send(result);
        });
        self.wait(during)?;
        let error = |reason: String| ExecError::Device { during: during.into(), reason };
        match told.try_recv() {
            Ok(Ok(())) => {}
            Ok(Err(e)) => return Err(error(e.to_string())),
            Err(_) => return Err(error("the device never answered".into())),
        }
        let view = slice.get_mapped_range().map_err(|e| error(e.to_string()))?;
        out.extend_from_slice(&view);
        drop(view);
        staging.unmap();
        Ok(())
    }

    /// The rows that a dispatch covers.
    fn rows(&mut self, kernel: &'static Kernel, buffers: &[BufferId]) -> Result<Rows, ExecError> {
        let sizes = |id| self.buffer(id).map(|b| b.bytes);
        let out_count = check_bindings(kernel, buffers, sizes)?;
        let Some(k) = kernel.desc.bindings.iter().position(|b| b.access == Access::Uniform) else {
            return check_rows(kernel, (kernel.rows)(&[], out_count), out_count);
        };
        let id = buffers[k];
        if self.buffer(id)?.shadow.is_none() {
            // A kernel wrote it, or it is large: rare, and right all the same.
            let words = bytemuck::pod_collect_to_vec(&self.read(id)?);
            self.buffer_mut(id)?.shadow = Some(words);
        }
        let words = self.buffer(id)?.shadow.as_deref().unwrap_or_default();
        let uniform = &words[..kernel.desc.bindings[k].stride_bytes / 4];
        check_rows(kernel, (kernel.rows)(uniform, out_count), out_count)
    }

    /// Makes the pipeline and the bind group of a dispatch where they do not exist yet.
    fn prepare(&mut self, kernel: &'static Kernel, key: &BindKey, buffers: &[BufferId]) -> Result<(), ExecError> {
        let desc = &kernel.desc;
        if !self.pipelines.contains_key(desc.name) {
            let pipeline = Pipeline::new(&self.context, desc);
            self.faults.check(desc.name)?;
            self.pipelines.insert(desc.name, pipeline?);
        }
        let Some(pipeline) = self.pipelines.get_mut(desc.name) else { unreachable!("inserted above") };
        if !pipeline.bind_groups.contains_key(key) {
            let whole = buffers.iter().filter_map(|id| self.buffers[id.0 as usize].as_ref()).map(|b| (&b.raw, b.bytes));
            let device = &self.context.device;
            let group = scoped(device, || pipeline.bind(device, desc, whole))
                .map_err(|e| ExecError::Pipeline { kernel: desc.name.into(), reason: one_line(&e.to_string()) })?;
            pipeline.bind_groups.insert(*key, group);
        }
        Ok(())
    }

    fn record(&mut self, kernel: &'static Kernel, key: &BindKey, invocations: u32) {
        self.recording();
        let (Some(recording), Some(pipeline)) = (self.recording.as_mut(), self.pipelines.get(kernel.desc.name)) else {
            unreachable!("made by prepare and recording")
        };
        let encoder = &mut recording.encoder;
        let pass =
            recording.pass.get_or_insert_with(|| encoder.begin_compute_pass(&Default::default()).forget_lifetime());
        let [x, y] = kernel.desc.workgroups(invocations);
        pass.set_pipeline(&pipeline.raw);
        pass.set_bind_group(0, &pipeline.bind_groups[key], &[]);
        pass.dispatch_workgroups(x, y, 1);
        recording.dispatches += 1;
    }
}

impl Executor for GpuExecutor {
    fn device(&self) -> DeviceInfo {
        self.info.clone()
    }

    fn upload(&mut self, label: &str, bytes: &[u8]) -> Result<BufferId, ExecError> {
        let id = self.zeroed(label, bytes.len())?;
        self.write(id, bytes)?;
        Ok(id)
    }

    fn zeroed(&mut self, label: &str, bytes: usize) -> Result<BufferId, ExecError> {
        let bytes = bytes as u64;
        let no_memory = |reason: String| ExecError::OutOfMemory { label: label.into(), bytes, reason };
        if !bytes.is_multiple_of(4) {
            return Err(ExecError::buffer(label, format!("{bytes} bytes are not whole words")));
        }
        if bytes > self.max_bytes {
            return Err(no_memory(format!("{} allows {} bytes", self.context.name, self.max_bytes)));
        }
        let mut usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST;
        if bytes <= self.max_uniform_bytes {
            usage |= wgpu::BufferUsages::UNIFORM;
        }
        let size = bytes.max(MIN_BUFFER_BYTES);
        let descriptor = wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false };
        let raw = scoped(&self.context.device, || self.context.device.create_buffer(&descriptor)).map_err(|e| {
            no_memory(match e {
                wgpu::Error::OutOfMemory { .. } => NO_MEMORY.into(),
                other => one_line(&other.to_string()),
            })
        })?;
        self.faults.check(label)?;
        let shadow = (bytes <= MAX_SHADOW_BYTES).then(|| vec![0; bytes as usize / 4]);
        self.buffers.push(Some(GpuBuffer { label: label.into(), bytes, raw, shadow, batch: 0 }));
        Ok(BufferId(self.buffers.len() as u32 - 1))
    }

    fn write(&mut self, id: BufferId, bytes: &[u8]) -> Result<(), ExecError> {
        let batch = self.batch;
        let buffer = self.buffer_mut(id)?;
        check_write(&buffer.label, buffer.bytes, bytes.len())?;
        if let Some(shadow) = &mut buffer.shadow {
            bytemuck::cast_slice_mut::<u32, u8>(shadow)[..bytes.len()].copy_from_slice(bytes);
        }
        let in_use = self.recording.is_some() && self.buffer(id)?.batch == batch;
        // A queue writes before the commands of the next submission, so what was recorded on this buffer goes first.
        if in_use || self.pending_upload_bytes + bytes.len() as u64 > MAX_PENDING_UPLOAD_BYTES {
            self.submit();
        }
        self.pending_upload_bytes += bytes.len() as u64;
        let buffer = self.buffer(id)?;
        self.context.queue.write_buffer(&buffer.raw, 0, bytes);
        self.faults.check(&buffer.label)
    }

    fn clear(&mut self, id: BufferId) -> Result<(), ExecError> {
        let batch = self.batch;
        let buffer = self.buffer_mut(id)?;
        if let Some(shadow) = &mut buffer.shadow {
            shadow.fill(0);
        }
        buffer.batch = batch;
        let raw = buffer.raw.clone();
        self.encoder().clear_buffer(&raw, 0, None);
        self.faults.check("a clear")
    }

    fn run(&mut self, kernel: &'static Kernel, buffers: &[BufferId]) -> Result<(), ExecError> {
        self.faults.check(kernel.desc.name)?;
        let rows = self.rows(kernel, buffers)?;
        if rows.invocations() == 0 {
            return Ok(());
        }
        let mut key = [u32::MAX; MAX_BINDINGS];
        for (place, id) in key.iter_mut().zip(buffers) {
            *place = id.0;
        }
        self.prepare(kernel, &key, buffers)?;
        let batch = self.batch;
        for (binding, &id) in kernel.desc.bindings.iter().zip(buffers) {
            let buffer = self.buffer_mut(id)?;
            buffer.batch = batch;
            if matches!(binding.access, Access::Write | Access::Atomic) {
                buffer.shadow = None;
            }
        }
        self.record(kernel, &key, rows.invocations());
        if self.recording.as_ref().is_some_and(|r| r.dispatches >= MAX_BATCH) {
            self.submit();
        }
        Ok(())
    }

    fn read(&mut self, id: BufferId) -> Result<Vec<u8>, ExecError> {
        let buffer = self.buffer(id)?;
        let (raw, bytes, label) = (buffer.raw.clone(), buffer.bytes, buffer.label.clone());
        let mut out = Vec::with_capacity(bytes as usize);
        while (out.len() as u64) < bytes {
            let done = out.len() as u64;
            let staging = self.readback.staging(&self.context.device, bytes);
            let piece = staging.size().min(bytes - done);
            self.encoder().copy_buffer_to_buffer(&raw, done, &staging, 0, piece);
            self.fetch(&staging, piece, &format!("reading `{label}`"), &mut out)?;
        }
        Ok(out)
    }

    fn free(&mut self, id: BufferId) {
        for pipeline in self.pipelines.values_mut() {
            pipeline.bind_groups.retain(|key, _| !key.contains(&id.0));
        }
        if let Some(buffer) = self.buffers.get_mut(id.0 as usize) {
            *buffer = None;
        }
    }

    fn size_bytes(&self, id: BufferId) -> u64 {
        self.buffer(id).map_or(0, |b| b.bytes)
    }

    fn mark(&self) -> Mark {
        Mark(self.buffers.len() as u32)
    }

    fn free_since(&mut self, mark: Mark) {
        for pipeline in self.pipelines.values_mut() {
            pipeline.bind_groups.retain(|key, _| key.iter().all(|&id| id == u32::MAX || id < mark.0));
        }
        self.buffers.truncate(mark.0 as usize);
    }

    fn begin(&mut self) {
        // Uploads of the stage must not slip in front of its first timestamp: give the device what came before.
        if let Some(clock) = self.clock.take() {
            clock.start(self.encoder());
            self.clock = Some(clock);
            self.submit();
        } else {
            self.submit();
            let _ = self.wait("the start of a stage"); // an error stays recorded or happens again in `end`
        }
        self.started = Some(Instant::now());
    }

    fn end(&mut self) -> Result<f64, ExecError> {
        const DURING: &str = "the end of a stage";
        let Some(started) = self.started.take() else { return Ok(0.0) };
        let Some(clock) = self.clock.take() else {
            self.submit();
            self.wait(DURING)?;
            return Ok(started.elapsed().as_secs_f64() * 1e3);
        };
        let staging = clock.stop(self.encoder());
        let mut timestamps = Vec::with_capacity(16);
        let result = self.fetch(&staging, 16, DURING, &mut timestamps);
        let by_device = result.is_ok().then(|| clock.milliseconds(&timestamps)).flatten();
        self.clock = Some(clock);
        result?;
        Ok(by_device.unwrap_or_else(|| started.elapsed().as_secs_f64() * 1e3))
    }

    fn buffers(&self) -> Vec<(String, u64)> {
        self.buffers.iter().flatten().map(|b| (b.label.clone(), b.bytes)).collect()
    }
}
