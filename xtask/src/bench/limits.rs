//! What the machine can do at best: copying, reading, and multiplying and adding.

use super::kernels::{self, Load};
use anyhow::{Context, Result, ensure};
use interreflect::exec::CpuExecutor;
use interreflect_kernels::kernel::{CaseInput, Flavour};
use interreflect_kernels::smoke;
use multiversion::multiversion;
use rayon::prelude::*;
use serde::Serialize;
use std::fmt;
use std::time::Instant;

/// Measured limits of the processor, all threads together.
#[derive(Clone, Copy, Serialize)]
pub struct Limits {
    /// Bytes read plus bytes written per second by a copy of large buffers.
    pub copy_bytes_per_s: f64,
    /// Bytes per second that are read and not written: less than a copy's two directions together.
    pub read_bytes_per_s: f64,
    /// Multiplications plus additions per second of independent numbers in registers. Multiply and add are two
    /// instructions: Rust never fuses them.
    pub operations_per_s: f64,
}

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (copy, read) = (self.copy_bytes_per_s * 1e-9, self.read_bytes_per_s * 1e-9);
        let operations = self.operations_per_s * 1e-9;
        write!(f, "copy {copy:.1} GB/s (read + written), reading {read:.1} GB/s, multiply-add {operations:.1} Gop/s")
    }
}

impl Limits {
    /// Seconds that memory takes at least for so many bytes.
    pub fn least_seconds(&self, moved: Moved) -> f64 {
        let all = (moved.read + moved.written) as f64 / self.copy_bytes_per_s;
        all.max(moved.read as f64 / self.read_bytes_per_s)
    }
}

/// Bytes between memory and processor.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Moved {
    /// Read.
    pub read: usize,
    /// Written.
    pub written: usize,
}

/// Bytes that are copied, or read: far more than most caches hold.
pub const LARGE_BYTES: usize = 256 << 20;
const REPEATS: usize = 15;

/// Measures them.
pub fn measure(cpu: &mut CpuExecutor) -> Result<Limits> {
    Ok(Limits { copy_bytes_per_s: copy(), read_bytes_per_s: reading()?, operations_per_s: multiply_add(cpu)? })
}

/// The shortest time: a limit is what the machine does when nothing else runs on it.
fn least(seconds: &[f64]) -> f64 {
    seconds.iter().copied().fold(f64::INFINITY, f64::min)
}

fn copy() -> f64 {
    let from = vec![1u8; LARGE_BYTES];
    let mut to = vec![0u8; LARGE_BYTES];
    let piece = LARGE_BYTES / rayon::current_num_threads();
    let seconds: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            to.par_chunks_mut(piece).zip(from.par_chunks(piece)).for_each(|(to, from)| to.copy_from_slice(from));
            start.elapsed().as_secs_f64()
        })
        .collect();
    2.0 * LARGE_BYTES as f64 / least(&seconds)
}

fn reading() -> Result<f64> {
    let block = vec![1u32; LARGE_BYTES / 4];
    let mut seconds = Vec::new();
    for _ in 0..REPEATS {
        let start = Instant::now();
        read(&block)?;
        seconds.push(start.elapsed().as_secs_f64());
    }
    Ok(LARGE_BYTES as f64 / least(&seconds))
}

/// Reads every word of a block of ones once, on all threads.
pub fn read(block: &[u32]) -> Result<()> {
    let sum = block.par_chunks(1 << 20).map(sum).reduce(|| 0, u32::wrapping_add);
    ensure!(sum == block.len() as u32, "the block was read wrongly");
    Ok(())
}

/// In wide registers: narrow ones do not ask for as much as memory gives.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn sum(words: &[u32]) -> u32 {
    let mut sums = [0u32; 64];
    for line in words.chunks_exact(sums.len()) {
        for (sum, word) in sums.iter_mut().zip(line) {
            *sum = sum.wrapping_add(*word);
        }
    }
    let rest = words.chunks_exact(sums.len()).remainder();
    sums.iter().chain(rest).fold(0, |sum, &word| sum.wrapping_add(word))
}

fn multiply_add(cpu: &mut CpuExecutor) -> Result<f64> {
    let kernel = &smoke::smoke_madd::KERNEL;
    let case = (kernel.case)(&mut CaseInput::new(1, 1 << 16, Flavour::Ordinary));
    let operations = kernels::operations(kernel, &case).context("smoke_madd counts its operations")?;
    let load = Load::new(cpu, kernel, &case)?;
    let mut seconds = Vec::new();
    for _ in 0..REPEATS {
        seconds.push(load.seconds(cpu, 4)?);
    }
    load.free(cpu);
    Ok(operations / least(&seconds))
}
