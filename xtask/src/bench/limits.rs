//! What the machine can do at best: copying, and multiplying and adding.

use super::kernels::{self, Load};
use anyhow::{Context, Result};
use interreflect::exec::CpuExecutor;
use interreflect_kernels::kernel::{CaseInput, Flavour};
use interreflect_kernels::smoke;
use rayon::prelude::*;
use serde::Serialize;
use std::fmt;
use std::time::Instant;

/// Measured limits of the processor, all threads together.
#[derive(Clone, Copy, Serialize)]
pub struct Limits {
    /// Bytes read plus bytes written per second by a copy of large buffers.
    pub copy_bytes_per_s: f64,
    /// Multiplications plus additions per second of independent numbers in registers. Multiply and add are two
    /// instructions: Rust never fuses them.
    pub operations_per_s: f64,
}

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (copy, operations) = (self.copy_bytes_per_s * 1e-9, self.operations_per_s * 1e-9);
        write!(f, "copy {copy:.1} GB/s (read + written), multiply-add {operations:.1} Gop/s")
    }
}

/// Bytes of a copy: far more than any cache holds.
const COPY_BYTES: usize = 256 << 20;
const REPEATS: usize = 15;

/// Measures both.
pub fn measure(cpu: &mut CpuExecutor) -> Result<Limits> {
    Ok(Limits { copy_bytes_per_s: copy(), operations_per_s: multiply_add(cpu)? })
}

/// The shortest time: a limit is what the machine does when nothing else runs on it.
fn least(seconds: &[f64]) -> f64 {
    seconds.iter().copied().fold(f64::INFINITY, f64::min)
}

fn copy() -> f64 {
    let from = vec![1u8; COPY_BYTES];
    let mut to = vec![0u8; COPY_BYTES];
    let piece = COPY_BYTES / rayon::current_num_threads();
    let seconds: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let start = Instant::now();
            to.par_chunks_mut(piece).zip(from.par_chunks(piece)).for_each(|(to, from)| to.copy_from_slice(from));
            start.elapsed().as_secs_f64()
        })
        .collect();
    2.0 * COPY_BYTES as f64 / least(&seconds)
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
