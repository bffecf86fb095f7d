//! Executors: where kernels run. They know buffers and kernels, and no method.

use interreflect_kernels::kernel::{Access, FOLD_WIDTH, Kernel, Rows};
use serde::Serialize;

pub mod cpu;
pub mod gpu;
pub mod manifest;

pub use cpu::{CpuExecutor, start_threads};
pub use gpu::{GpuExecutor, GpuOptions, SpirvPath, list_devices};

/// What can go wrong when kernels run.
#[derive(Debug, thiserror::Error)]
pub enum ExecError {
    /// No adapter of the requested kind.
    #[error("no {wanted}: {reason}")]
    NoAdapter {
        /// What was asked for.
        wanted: String,
        /// What was found instead.
        reason: String,
    },
    /// The canary dispatch did not write what it must.
    #[error("the device {adapter} does not run kernels: {reason}")]
    BrokenDevice {
        /// Adapter's name.
        adapter: String,
        /// What the canary saw.
        reason: String,
    },
    /// The device was lost.
    #[error("device lost during {during}: {reason}")]
    DeviceLost {
        /// What ran.
        during: String,
        /// The driver's words.
        reason: String,
    },
    /// A buffer is larger than the device allows, or memory ran out.
    #[error("buffer `{label}` of {bytes} bytes: {reason}")]
    OutOfMemory {
        /// Name of the buffer.
        label: String,
        /// Its size.
        bytes: u64,
        /// The limit, or the driver's words.
        reason: String,
    },
    /// A kernel was given the wrong buffers.
    #[error("kernel `{kernel}`, binding `{binding}`: expected {expected}, got {got}")]
    Binding {
        /// Entry point.
        kernel: &'static str,
        /// Name of the binding.
        binding: &'static str,
        /// What the declaration says.
        expected: String,
        /// What was passed.
        got: String,
    },
    /// A kernel needs more than the adapter has.
    #[error("kernel `{kernel}` needs {needed} {what}, {adapter} allows {allowed}")]
    Limit {
        /// Entry point.
        kernel: &'static str,
        /// What there is too little of.
        what: &'static str,
        /// How much the kernel needs.
        needed: u64,
        /// How much the adapter has.
        allowed: u64,
        /// Adapter's name.
        adapter: String,
    },
    /// A buffer was used in a way that it does not allow.
    #[error("buffer `{label}`: {reason}")]
    Buffer {
        /// Name of the buffer.
        label: String,
        /// What is wrong.
        reason: String,
    },
    /// The device reported an error of another kind.
    #[error("device error during {during}: {reason}")]
    Device {
        /// What ran.
        during: String,
        /// wgpu's or the driver's words.
        reason: String,
    },
    /// An option or environment variable has a value that it does not allow.
    #[error("{name}: `{value}` is not {allowed}")]
    Option {
        /// Option or variable.
        name: &'static str,
        /// What was given.
        value: String,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The driver rejected a compiled kernel.
    #[error("kernel `{kernel}` cannot be made into a pipeline: {reason}")]
    Pipeline {
        /// Entry point.
        kernel: String,
        /// The driver's or naga's words.
        reason: String,
    },
}

impl ExecError {
    pub(crate) fn buffer(label: &str, reason: String) -> Self {
        ExecError::Buffer { label: label.into(), reason }
    }
    pub(crate) fn freed() -> Self {
        Self::buffer("(freed)", "it was given back, or belongs to another executor".into())
    }
}

/// A buffer of an [`Executor`]; valid for that executor only.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct BufferId(pub(crate) u32);

/// A moment in an executor's life: the number of buffers made before it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Mark(pub(crate) u32);

/// Where kernels run, for reports.
#[derive(Clone, Debug, Serialize)]
pub struct DeviceInfo {
    /// `cpu`, `gpu` (naga) or `gpu-passthrough`.
    pub backend: String,
    /// Adapter or processor name.
    pub adapter: String,
    /// Driver name and version, or the vector instructions in use.
    pub driver: String,
    /// Processor name and number of threads.
    pub cpu: String,
    /// Whether the adapter is hardware (false for software Vulkan and for the CPU executor).
    pub hardware_gpu: bool,
}

/// Runs kernels on buffers. All calls take effect in order; only [`Executor::read`] and [`Executor::end`] wait.
pub trait Executor: Send {
    /// Where this executor runs.
    fn device(&self) -> DeviceInfo;

    /// A new buffer with the given bytes (a multiple of 4). An empty buffer is legal; a device sees one zero element.
    fn upload(&mut self, label: &str, bytes: &[u8]) -> Result<BufferId, ExecError>;

    /// A new buffer of zeros.
    fn zeroed(&mut self, label: &str, bytes: usize) -> Result<BufferId, ExecError>;

    /// Overwrites a buffer from its start on.
    fn write(&mut self, buffer: BufferId, bytes: &[u8]) -> Result<(), ExecError>;

    /// Fills a buffer with zeros.
    fn clear(&mut self, buffer: BufferId) -> Result<(), ExecError>;

    /// Runs a kernel. `buffers` in the order of the declaration (uniform, reads, writes), no buffer twice.
    fn run(&mut self, kernel: &'static Kernel, buffers: &[BufferId]) -> Result<(), ExecError>;

    /// Waits and copies a buffer back.
    fn read(&mut self, buffer: BufferId) -> Result<Vec<u8>, ExecError>;

    /// Gives a buffer back.
    fn free(&mut self, buffer: BufferId);

    /// Size of a buffer in bytes.
    fn size_bytes(&self, buffer: BufferId) -> u64;

    /// The present moment, for [`Executor::free_since`].
    fn mark(&self) -> Mark;

    /// Gives back every buffer that was made after the mark.
    fn free_since(&mut self, mark: Mark);

    /// Starts a timed stage.
    fn begin(&mut self);

    /// Waits for the stage that [`Executor::begin`] started and gives its time in milliseconds: the device's own
    /// timestamps where the adapter has them, wall-clock otherwise.
    fn end(&mut self) -> Result<f64, ExecError>;

    /// Label and size in bytes of every live buffer, in order of creation.
    fn buffers(&self) -> Vec<(String, u64)>;
}

/// Where to run: `--backend`.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Backend {
    /// A hardware GPU where there is one that works, otherwise the processor.
    #[default]
    Auto,
    /// The processor.
    Cpu,
    /// An adapter, a software driver where there is no other.
    Gpu,
}

impl Backend {
    /// The word of the command line.
    pub fn key(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Cpu => "cpu",
            Self::Gpu => "gpu",
        }
    }
}

impl std::str::FromStr for Backend {
    type Err = ExecError;
    fn from_str(text: &str) -> Result<Self, ExecError> {
        match text {
            "auto" => Ok(Backend::Auto),
            "cpu" => Ok(Backend::Cpu),
            "gpu" => Ok(Backend::Gpu),
            _ => Err(ExecError::Option { name: "--backend", value: text.into(), allowed: "auto, cpu or gpu" }),
        }
    }
}

/// Opens an executor; [`open_adapter`] without a wish for an adapter.
///
/// # Errors
/// As [`open_adapter`].
pub fn open(backend: Backend, warn: &mut dyn FnMut(String)) -> Result<Box<dyn Executor>, ExecError> {
    open_adapter(backend, None, warn)
}

/// Opens an executor. `adapter`: any part of an adapter's name, which is then used whatever it is; `warn` hears why
/// `auto` does not take a GPU that is there. `INTERREFLECT_SPIRV=passthrough|naga` chooses how kernels reach the driver.
///
/// # Errors
/// [`ExecError::NoAdapter`] where an adapter was asked for that is not there, [`ExecError::BrokenDevice`] and others
/// where it does not run kernels. `auto` without a wish always succeeds.
pub fn open_adapter(
    backend: Backend,
    adapter: Option<&str>,
    warn: &mut dyn FnMut(String),
) -> Result<Box<dyn Executor>, ExecError> {
    if backend == Backend::Cpu {
        return match adapter {
            None => Ok(Box::new(CpuExecutor::new())),
            Some(name) => Err(ExecError::NoAdapter {
                wanted: format!("GPU named `{name}`"),
                reason: "the backend is `cpu`, which uses none".into(),
            }),
        };
    }
    let spirv = std::env::var("INTERREFLECT_SPIRV").ok().map(|text| text.parse()).transpose()?;
    let options = GpuOptions {
        adapter: adapter.map(str::to_string),
        hardware_only: backend == Backend::Auto && adapter.is_none(),
        spirv,
        ..GpuOptions::default()
    };
    let opened = GpuExecutor::open_or_naga(&options, warn).map(|executor| Box::new(executor) as Box<dyn Executor>);
    if options.hardware_only { Ok(or_cpu(opened, warn)) } else { opened }
}

/// What `auto` makes of its attempt to open a hardware GPU.
fn or_cpu(opened: Result<Box<dyn Executor>, ExecError>, warn: &mut dyn FnMut(String)) -> Box<dyn Executor> {
    opened.unwrap_or_else(|error| {
        // Without a hardware GPU the processor is what `auto` means; one that fails deserves a word.
        if !matches!(error, ExecError::NoAdapter { .. }) {
            warn(format!("{error}; going on with the CPU"));
        }
        Box::new(CpuExecutor::new())
    })
}

/// Typed convenience over [`Executor`].
pub trait ExecutorExt: Executor {
    /// A buffer of records.
    fn upload_slice<T: bytemuck::NoUninit>(&mut self, label: &str, values: &[T]) -> Result<BufferId, ExecError> {
        self.upload(label, bytemuck::cast_slice(values))
    }
    /// A buffer of one record (uniform).
    fn upload_one<T: bytemuck::NoUninit>(&mut self, label: &str, value: &T) -> Result<BufferId, ExecError> {
        self.upload(label, bytemuck::bytes_of(value))
    }
    /// A buffer of `count` zero records.
    fn zeroed_slice<T>(&mut self, label: &str, count: usize) -> Result<BufferId, ExecError> {
        self.zeroed(label, count * size_of::<T>())
    }
    /// Reads records back.
    fn read_slice<T: bytemuck::Pod>(&mut self, buffer: BufferId) -> Result<Vec<T>, ExecError> {
        Ok(bytemuck::pod_collect_to_vec(&self.read(buffer)?))
    }
}
impl<E: Executor + ?Sized> ExecutorExt for E {}

/// Checks what both executors need: number of bindings, sizes, no buffer twice. Gives the element count of the written
/// binding (0 for scatter kernels).
pub(crate) fn check_bindings(
    kernel: &Kernel,
    buffers: &[BufferId],
    bytes: impl Fn(BufferId) -> Result<u64, ExecError>,
) -> Result<u32, ExecError> {
    let desc = &kernel.desc;
    let error =
        |binding, expected: String, got: String| Err(ExecError::Binding { kernel: desc.name, binding, expected, got });
    if buffers.len() != desc.bindings.len() {
        return error("(all)", format!("{} buffers", desc.bindings.len()), format!("{}", buffers.len()));
    }
    let mut out_count = 0;
    for (k, (binding, &id)) in desc.bindings.iter().zip(buffers).enumerate() {
        let size = bytes(id)?;
        let stride = binding.stride_bytes as u64;
        if binding.access == Access::Uniform && size < stride {
            return error(binding.name, format!("one {} of {stride} bytes", binding.record), format!("{size} bytes"));
        }
        if !size.is_multiple_of(stride) && binding.access != Access::Uniform {
            return error(binding.name, format!("a multiple of {stride} bytes"), format!("{size} bytes"));
        }
        if buffers[..k].contains(&id) {
            return error(binding.name, "a buffer of its own".into(), "one that is bound already".into());
        }
        if binding.access == Access::Write {
            out_count = u32::try_from(size / stride).unwrap_or(u32::MAX);
        }
    }
    Ok(out_count)
}

/// Checks that every invocation's element lies in the written binding of `out_count` elements.
pub(crate) fn check_rows(kernel: &Kernel, rows: Rows, out_count: u32) -> Result<Rows, ExecError> {
    let (count, len) = (u64::from(rows.count), u64::from(rows.len));
    let error = |expected: String, got: String| {
        let written = kernel.desc.bindings.iter().find(|b| matches!(b.access, Access::Write | Access::Atomic));
        let binding = written.map_or("(none)", |b| b.name);
        Err(ExecError::Binding { kernel: kernel.desc.name, binding, expected, got })
    };
    // The last workgroups of a folded dispatch must not wrap around to the first elements.
    let most = u64::from(u32::MAX) - u64::from(kernel.desc.workgroup_size) * u64::from(FOLD_WIDTH);
    if count * len > most {
        return error(format!("at most {most} invocations"), format!("{}", count * len));
    }
    if kernel.plane_count == 0 || count * len == 0 {
        return Ok(rows);
    }
    let reach = u64::from(rows.first) + (count - 1) * u64::from(rows.pitch) + len;
    let planes = kernel.plane_count as u64;
    if kernel.plane_count > 1 && reach > u64::from(rows.plane) {
        return error(format!("planes of at least {reach} elements"), format!("{}", rows.plane));
    }
    let needed = reach.max(if planes > 1 { u64::from(rows.plane) * planes } else { 0 });
    if needed > u64::from(out_count) {
        return error(format!("at least {needed} elements"), format!("{out_count}"));
    }
    Ok(rows)
}

/// Checks that `written` bytes fit into a buffer.
pub(crate) fn check_write(label: &str, bytes: u64, written: usize) -> Result<(), ExecError> {
    if written as u64 > bytes || !written.is_multiple_of(4) {
        return Err(ExecError::buffer(label, format!("{written} bytes do not fit into its {bytes}, word by word")));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn auto_after(error: ExecError) -> (String, Vec<String>) {
        let mut warnings = Vec::new();
        let exec = or_cpu(Err(error), &mut |text| warnings.push(text));
        (exec.device().backend, warnings)
    }

    #[test]
    fn auto_goes_on_with_the_cpu() {
        let (backend, warnings) = auto_after(ExecError::NoAdapter { wanted: "GPU".into(), reason: "none".into() });
        assert_eq!((backend.as_str(), warnings.len()), ("cpu", 0));
        let broken = ExecError::BrokenDevice { adapter: "Some GPU".into(), reason: "dead canary".into() };
        let (backend, warnings) = auto_after(broken);
        assert_eq!(backend, "cpu");
        assert!(warnings.len() == 1 && warnings[0].contains("Some GPU") && warnings[0].contains("dead canary"));
    }
}
