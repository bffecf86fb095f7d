//! Kernels on the CPU: pieces of rows on rayon's threads.

use super::{BufferId, DeviceInfo, ExecError, Executor, Mark, check_bindings, check_rows, check_write};
use bytemuck::{Pod, Zeroable};
use interreflect_kernels::kernel::{Access, Form, Kernel, Piece, Rows, Vectors, vectors};
use rayon::prelude::*;
use std::sync::atomic::AtomicU32;
use std::time::Instant;

/// 64 bytes: the alignment of every buffer, so that a slice of words is also a slice of any record or vector.
#[repr(C, align(64))]
#[derive(Clone, Copy, Pod, Zeroable)]
struct CacheLine([u32; 16]);

struct CpuBuffer {
    label: String,
    bytes: usize,
    lines: Vec<CacheLine>,
}

impl CpuBuffer {
    fn words(&self) -> &[u32] {
        &bytemuck::cast_slice(&self.lines)[..self.bytes / 4]
    }
    fn words_mut(&mut self) -> &mut [u32] {
        &mut bytemuck::cast_slice_mut(&mut self.lines)[..self.bytes / 4]
    }
}

/// Makes the calling thread one of the threads that CPU work runs on: as many as asked for, 0: one per processor. It then works with the
/// others instead of waiting for them, and a small dispatch is done before another thread is awake. For a program's main
/// thread; only the first call in a process has an effect.
pub fn start_threads(threads: usize) {
    let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).use_current_thread().build_global();
}

/// Runs kernels as native code on all threads of rayon's pool.
#[derive(Default)]
pub struct CpuExecutor {
    buffers: Vec<Option<CpuBuffer>>,
    started: Option<Instant>,
}

impl CpuExecutor {
    /// An executor without buffers.
    pub fn new() -> Self {
        Self::default()
    }

    fn buffer(&self, id: BufferId) -> Result<&CpuBuffer, ExecError> {
        self.buffers.get(id.0 as usize).and_then(Option::as_ref).ok_or_else(ExecError::freed)
    }

    fn buffer_mut(&mut self, id: BufferId) -> Result<&mut CpuBuffer, ExecError> {
        self.buffers.get_mut(id.0 as usize).and_then(Option::as_mut).ok_or_else(ExecError::freed)
    }

    /// The rows that a dispatch covers.
    fn rows(&self, kernel: &Kernel, buffers: &[BufferId], out_count: u32) -> Result<Rows, ExecError> {
        let mut uniform: &[u32] = &[];
        for (binding, &id) in kernel.desc.bindings.iter().zip(buffers) {
            if binding.access == Access::Uniform {
                uniform = &self.buffer(id)?.words()[..binding.stride_bytes / 4];
            }
        }
        check_rows(kernel, (kernel.rows)(uniform, out_count), out_count)
    }
}

impl Executor for CpuExecutor {
    fn device(&self) -> DeviceInfo {
        DeviceInfo {
            backend: "cpu".into(),
            adapter: processor_name(),
            driver: vector_instructions().into(),
            cpu: format!("{}, {} threads", processor_name(), rayon::current_num_threads()),
            hardware_gpu: false,
        }
    }

    fn upload(&mut self, label: &str, bytes: &[u8]) -> Result<BufferId, ExecError> {
        let id = self.zeroed(label, bytes.len())?;
        self.write(id, bytes)?;
        Ok(id)
    }

    fn zeroed(&mut self, label: &str, bytes: usize) -> Result<BufferId, ExecError> {
        if !bytes.is_multiple_of(4) {
            return Err(ExecError::buffer(label, format!("{bytes} bytes are not whole words")));
        }
        let count = bytes.div_ceil(64).max(1);
        let lines = bytemuck::try_zeroed_vec(count).map_err(|()| ExecError::OutOfMemory {
            label: label.into(),
            bytes: bytes as u64,
            reason: "the system has no such block of memory".into(),
        })?;
        self.buffers.push(Some(CpuBuffer { label: label.into(), bytes, lines }));
        Ok(BufferId(self.buffers.len() as u32 - 1))
    }

    fn write(&mut self, buffer: BufferId, bytes: &[u8]) -> Result<(), ExecError> {
        let buffer = self.buffer_mut(buffer)?;
        check_write(&buffer.label, buffer.bytes as u64, bytes.len())?;
        let words = buffer.words_mut();
        bytemuck::cast_slice_mut::<u32, u8>(words)[..bytes.len()].copy_from_slice(bytes);
        Ok(())
    }

    fn clear(&mut self, buffer: BufferId) -> Result<(), ExecError> {
        let buffer = self.buffer_mut(buffer)?;
        buffer.lines.par_chunks_mut(CLEAR_LINES).for_each(|lines| lines.fill(CacheLine([0; 16])));
        Ok(())
    }

    fn run(&mut self, kernel: &'static Kernel, buffers: &[BufferId]) -> Result<(), ExecError> {
        let out_count = check_bindings(kernel, buffers, |id| self.buffer(id).map(|b| b.bytes as u64))?;
        let rows = self.rows(kernel, buffers, out_count)?;
        // Take the written buffers out, so that the others can be borrowed beside them.
        let mut uniform: &[u32] = &[];
        let (mut reads, mut written, mut atomic_ids) = (Vec::new(), None, Vec::new());
        for (binding, &id) in kernel.desc.bindings.iter().zip(buffers) {
            match binding.access {
                Access::Write => written = Some((binding.stride_bytes / 4, id, self.buffers[id.0 as usize].take())),
                Access::Atomic => atomic_ids.push((id, self.buffers[id.0 as usize].take())),
                Access::Uniform | Access::Read => {}
            }
        }
        for (binding, &id) in kernel.desc.bindings.iter().zip(buffers) {
            match binding.access {
                Access::Uniform => uniform = &self.buffer(id)?.words()[..binding.stride_bytes / 4],
                Access::Read => reads.push(self.buffer(id)?.words()),
                Access::Write | Access::Atomic => {}
            }
        }
        match kernel.form {
            Form::Scatter => {
                let atomics: Vec<&[AtomicU32]> = atomic_ids
                    .iter_mut()
                    .map(|(_, b)| as_atomics(b.as_mut().expect("taken above").words_mut()))
                    .collect();
                scatter(kernel, rows.count, uniform, &reads, &atomics);
            }
            Form::Plain | Form::Lanes => {
                let (stride, _, buffer) = written.as_mut().expect("a gather kernel writes");
                gather(kernel, &rows, uniform, &reads, buffer.as_mut().expect("taken above").words_mut(), *stride);
            }
        }
        drop(reads);
        for (id, buffer) in written.into_iter().map(|(_, id, buffer)| (id, buffer)).chain(atomic_ids) {
            self.buffers[id.0 as usize] = buffer;
        }
        Ok(())
    }

    fn read(&mut self, buffer: BufferId) -> Result<Vec<u8>, ExecError> {
        Ok(bytemuck::cast_slice(self.buffer(buffer)?.words()).to_vec())
    }

    fn free(&mut self, buffer: BufferId) {
        if let Some(buffer) = self.buffers.get_mut(buffer.0 as usize) {
            *buffer = None;
        }
    }

    fn size_bytes(&self, buffer: BufferId) -> u64 {
        self.buffer(buffer).map_or(0, |b| b.bytes as u64)
    }

    fn mark(&self) -> Mark {
        Mark(self.buffers.len() as u32)
    }

    fn free_since(&mut self, mark: Mark) {
        self.buffers.truncate(mark.0 as usize);
    }

    fn begin(&mut self) {
        self.started = Some(Instant::now());
    }

    fn end(&mut self) -> Result<f64, ExecError> {
        Ok(self.started.take().map_or(0.0, |t| t.elapsed().as_secs_f64() * 1e3))
    }

    fn buffers(&self) -> Vec<(String, u64)> {
        self.buffers.iter().flatten().map(|b| (b.label.clone(), b.bytes as u64)).collect()
    }
}

/// Cache lines that one task clears: 256 KiB.
const CLEAR_LINES: usize = 4096;
/// Invocations of a piece, at least: below this a task costs more than it saves.
const MIN_PIECE: usize = 256;
/// Pieces per thread: enough to even out uneven work.
const PIECES_PER_THREAD: usize = 16;

fn rows_per_piece(rows: usize, len: usize) -> usize {
    let even = rows.div_ceil(rayon::current_num_threads() * PIECES_PER_THREAD);
    even.max(MIN_PIECE.div_ceil(len.max(1))).max(1)
}

fn scatter(kernel: &Kernel, count: u32, uniform: &[u32], reads: &[&[u32]], atomics: &[&[AtomicU32]]) {
    let step = rows_per_piece(count as usize, 1) as u32;
    (0..count.div_ceil(step)).into_par_iter().for_each(|k| {
        let first_row = k * step;
        let row_count = step.min(count - first_row);
        (kernel.cpu)(Piece { first_row, row_count, uniform, reads, planes: &mut [], atomics });
    });
}

/// Cuts every plane of the output into the pieces of rows and runs them side by side. `stride`: words of an element.
fn gather(kernel: &Kernel, rows: &Rows, uniform: &[u32], reads: &[&[u32]], out: &mut [u32], stride: usize) {
    if rows.count == 0 || rows.len == 0 {
        return;
    }
    let (count, len) = (rows.count as usize, rows.len as usize);
    let (pitch, first) = (rows.pitch as usize * stride, rows.first as usize * stride);
    let step = rows_per_piece(count, len);
    let mut pieces: Vec<(u32, u32, Vec<&mut [u32]>)> = (0..count.div_ceil(step))
        .map(|k| ((k * step) as u32, step.min(count - k * step) as u32, Vec::with_capacity(kernel.plane_count)))
        .collect();
    let plane_words = if kernel.plane_count == 1 { out.len() } else { rows.plane as usize * stride };
    for plane in out.chunks_exact_mut(plane_words).take(kernel.plane_count) {
        let mut rest = &mut plane[first..first + (count - 1) * pitch + len * stride];
        for (_, row_count, planes) in &mut pieces {
            let words = (*row_count as usize * pitch).min(rest.len());
            let (piece, after) = rest.split_at_mut(words);
            planes.push(piece);
            rest = after;
        }
    }
    pieces.into_par_iter().for_each(|(first_row, row_count, mut planes)| {
        (kernel.cpu)(Piece { first_row, row_count, uniform, reads, planes: &mut planes, atomics: &[] });
    });
}

#[expect(unsafe_code, reason = "a mutable slice of words seen as atomic words")]
fn as_atomics(words: &mut [u32]) -> &[AtomicU32] {
    // SAFETY: AtomicU32 has the size and alignment of u32, and the exclusive borrow lasts as long as the result.
    unsafe { &*(std::ptr::from_mut::<[u32]>(words) as *const [AtomicU32]) }
}

/// The processor's own name.
pub fn processor_name() -> String {
    std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| {
            text.lines().find(|l| l.starts_with("model name")).map(|l| l.split(": ").nth(1).unwrap_or("").to_string())
        })
        .unwrap_or_else(|| std::env::consts::ARCH.to_string())
}

fn vector_instructions() -> &'static str {
    match vectors() {
        Vectors::Avx512 => "avx512",
        Vectors::Avx2 => "avx2",
        Vectors::Baseline => "baseline",
    }
}
