//! Executors: where kernels run. They know buffers and kernels, and no method.

use interreflect_kernels::kernel::{Access, Kernel};
use serde::Serialize;

pub mod cpu;
pub mod manifest;

pub use cpu::CpuExecutor;

/// What can go wrong when kernels run.
#[derive(Debug, thiserror::Error)]
pub enum ExecError {
    /// No adapter of the requested kind.
    #[error("no {wanted} adapter: {reason}")]
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
    /// The driver rejected a compiled kernel.
    #[error("kernel `{kernel}` cannot be made into a pipeline: {reason}")]
    Pipeline {
        /// Entry point.
        kernel: String,
        /// The driver's or naga's words.
        reason: String,
    },
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
    bytes: impl Fn(BufferId) -> u64,
) -> Result<u32, ExecError> {
    let desc = &kernel.desc;
    let error =
        |binding, expected: String, got: String| Err(ExecError::Binding { kernel: desc.name, binding, expected, got });
    if buffers.len() != desc.bindings.len() {
        return error("(all)", format!("{} buffers", desc.bindings.len()), format!("{}", buffers.len()));
    }
    let mut out_count = 0;
    for (k, (binding, &id)) in desc.bindings.iter().zip(buffers).enumerate() {
        let size = bytes(id);
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
            out_count = (size / stride) as u32;
        }
    }
    Ok(out_count)
}
