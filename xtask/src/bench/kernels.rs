//! Every kernel on the CPU against the same SPIR-V on a software driver of the same cores, and against the machine's limits.

use super::limits::Moved;
use super::{Bench, geometric_mean, median};
use anyhow::{Context, Result};
use interreflect::exec::{BufferId, Executor};
use interreflect_kernels::kernel::{Access, Case, CaseInput, Flavour, Kernel, Rows};
use serde::Serialize;
use serde_json::{Value, json};
use std::time::Instant;

/// Timed stages of each executor.
const REPEATS: usize = 7;
/// A case is large enough when a dispatch takes this long,
const WANTED_SECONDS: f64 = 20e-3;
/// or has this many elements,
const MAX_COUNT: usize = 1 << 24;
/// or a buffer this large, the most that every device binds,
const MAX_BUFFER_BYTES: usize = 128 << 20;
/// or when making it took this long.
const MAX_CASE_SECONDS: f64 = 8.0;

/// Name of the one row that is no kernel.
const CLEAR: &str = "clear";

/// A kernel's figures.
#[derive(Serialize)]
struct Row {
    kernel: &'static str,
    form: String,
    invocations: u32,
    moved: Moved,
    cpu_ns_per_invocation: f64,
    device_ns_per_invocation: Option<f64>,
    /// Device's time over the CPU's: above 1 the CPU is faster.
    cpu_speedup: Option<f64>,
    /// What memory takes at least ([`super::limits::Limits::least_seconds`]) over the time taken, when every byte of every
    /// buffer moves once.
    bandwidth_share: f64,
    /// Share of the multiply-add rate (lane-generic kernels, which count their operations).
    arithmetic_share: Option<f64>,
}

/// The table of kernels.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let mut rows = Vec::new();
    println!(
        "\n{:<26} {:>8} {:>10} {:>10} {:>11} {:>9} {:>10} {:>10}",
        "kernel", "form", "elements", "CPU ns", "device ns", "CPU wins", "bandwidth", "arithmetic"
    );
    for kernel in interreflect_kernels::all() {
        if !bench.wants(kernel.desc.name) {
            continue;
        }
        let row = measure(bench, kernel).with_context(|| kernel.desc.name)?;
        print_row(&row);
        rows.push(row);
    }
    if bench.wants(CLEAR) {
        let row = clear(bench)?;
        print_row(&row);
        rows.push(row);
    }
    let speedups: Vec<f64> = rows.iter().filter_map(|row| row.cpu_speedup).collect();
    let mean = geometric_mean(&speedups);
    let slower: Vec<&str> = rows.iter().filter(|r| r.cpu_speedup.is_some_and(|s| s < 1.0)).map(|r| r.kernel).collect();
    if !speedups.is_empty() {
        println!("CPU against device, geometric mean of {}: {mean:.2}", speedups.len());
        println!("slower on the CPU: {}", if slower.is_empty() { "none".into() } else { slower.join(", ") });
    }
    Ok(json!({ "rows": rows, "geometric_mean_cpu_speedup": mean, "slower_on_cpu": slower }))
}

fn print_row(row: &Row) {
    let or_dash = |value: Option<String>| value.unwrap_or_else(|| "–".into());
    println!(
        "{:<26} {:>8} {:>10} {:>10.2} {:>11} {:>9} {:>10} {:>10}",
        row.kernel,
        row.form,
        row.invocations,
        row.cpu_ns_per_invocation,
        or_dash(row.device_ns_per_invocation.map(|ns| format!("{ns:.2}"))),
        or_dash(row.cpu_speedup.map(|s| format!("{s:.2}×"))),
        format!("{:.0} %", 100.0 * row.bandwidth_share),
        or_dash(row.arithmetic_share.map(|share| format!("{:.0} %", 100.0 * share))),
    );
}

fn measure(bench: &mut Bench, kernel: &'static Kernel) -> Result<Row> {
    let case = large_case(bench, kernel)?;
    let on_cpu = Load::new(&mut bench.cpu, kernel, &case)?;
    let on_gpu = bench.gpu.as_mut().map(|gpu| Load::new(gpu, kernel, &case)).transpose()?;
    let repeat = repeats(on_cpu.seconds(&mut bench.cpu, 1)?);
    let (mut cpu, mut gpu) = (Vec::new(), Vec::new());
    for turn in 0..=REPEATS {
        let seconds = on_cpu.seconds(&mut bench.cpu, repeat)?;
        if let (Some(load), Some(executor)) = (&on_gpu, &mut bench.gpu) {
            let seconds = load.seconds(executor, repeat)?;
            // The first turn warms up.
            if turn > 0 {
                gpu.push(seconds);
            }
        }
        if turn > 0 {
            cpu.push(seconds);
        }
    }
    on_cpu.free(&mut bench.cpu);
    if let (Some(load), Some(executor)) = (on_gpu, &mut bench.gpu) {
        load.free(executor);
    }
    let cpu = median(cpu);
    let gpu = (!gpu.is_empty()).then(|| median(gpu));
    let invocations = rows(kernel, &case).invocations();
    let moved = moved(kernel, &case);
    let per_invocation = |seconds: f64| seconds * 1e9 / f64::from(invocations.max(1));
    Ok(Row {
        kernel: kernel.desc.name,
        form: format!("{:?}", kernel.form).to_lowercase(),
        invocations,
        moved,
        cpu_ns_per_invocation: per_invocation(cpu),
        device_ns_per_invocation: gpu.map(per_invocation),
        cpu_speedup: gpu.map(|gpu| gpu / cpu),
        bandwidth_share: bench.limits.least_seconds(moved) / cpu,
        arithmetic_share: operations(kernel, &case).map(|ops| ops / cpu / bench.limits.operations_per_s),
    })
}

/// Clearing a buffer as large as those that a frame of a large scene clears, on the CPU.
fn clear(bench: &mut Bench) -> Result<Row> {
    const BYTES: usize = 32 << 20;
    let id = bench.cpu.zeroed("cleared", BYTES)?;
    let mut seconds = Vec::new();
    for _ in 0..=REPEATS {
        bench.cpu.begin();
        bench.cpu.clear(id)?;
        seconds.push(bench.cpu.end()? * 1e-3);
    }
    bench.cpu.free(id);
    // The first turn warms up.
    let cpu = median(seconds.split_off(1));
    let moved = Moved { read: 0, written: BYTES };
    let words = BYTES / 4;
    Ok(Row {
        kernel: CLEAR,
        form: "words".into(),
        invocations: words as u32,
        moved,
        cpu_ns_per_invocation: cpu * 1e9 / words as f64,
        device_ns_per_invocation: None,
        cpu_speedup: None,
        bandwidth_share: bench.limits.least_seconds(moved) / cpu,
        arithmetic_share: None,
    })
}

/// Dispatches of a stage: enough for a clock.
pub fn repeats(seconds: f64) -> u32 {
    (1e-3 / seconds.max(1e-6)).ceil().clamp(1.0, 16.0) as u32
}

/// The kernel's own case, as large as is realistic.
pub fn large_case(bench: &mut Bench, kernel: &'static Kernel) -> Result<Case> {
    let mut count = 1 << 12;
    loop {
        let start = Instant::now();
        let case = (kernel.case)(&mut CaseInput::new(1, count, Flavour::Ordinary));
        let made_in = start.elapsed().as_secs_f64();
        let largest = case.buffers.iter().map(|words| 4 * words.len()).max().unwrap_or(0);
        let load = Load::new(&mut bench.cpu, kernel, &case)?;
        let seconds = load.seconds(&mut bench.cpu, 1)?;
        load.free(&mut bench.cpu);
        let next_is_too_large =
            4 * count > MAX_COUNT || 5 * largest > MAX_BUFFER_BYTES || 4.0 * made_in > MAX_CASE_SECONDS;
        // A little more than four times the size for what a case rounds up.
        if seconds > WANTED_SECONDS || next_is_too_large {
            return Ok(case);
        }
        count *= 4;
    }
}

/// Buffers of a case on an executor.
pub struct Load {
    kernel: &'static Kernel,
    buffers: Vec<BufferId>,
}

impl Load {
    /// Buffers that are there already.
    pub fn of(kernel: &'static Kernel, buffers: Vec<BufferId>) -> Self {
        Self { kernel, buffers }
    }

    /// Uploads a case.
    pub fn new(executor: &mut dyn Executor, kernel: &'static Kernel, case: &Case) -> Result<Self> {
        let bindings = kernel.desc.bindings.iter().zip(&case.buffers);
        let buffers = bindings.map(|(binding, words)| executor.upload(binding.name, bytemuck::cast_slice(words)));
        Ok(Self { kernel, buffers: buffers.collect::<Result<_, _>>()? })
    }

    /// Seconds of one dispatch, when `repeat` of them follow each other.
    pub fn seconds(&self, executor: &mut dyn Executor, repeat: u32) -> Result<f64> {
        executor.begin();
        for _ in 0..repeat {
            executor.run(self.kernel, &self.buffers)?;
        }
        Ok(executor.end()? * 1e-3 / f64::from(repeat))
    }

    /// What the kernel wrote.
    pub fn output(&self, executor: &mut dyn Executor) -> Result<Vec<u32>> {
        let written = self.kernel.desc.bindings.iter().position(|b| matches!(b.access, Access::Write | Access::Atomic));
        let id = self.buffers[written.context("a kernel writes")?];
        Ok(bytemuck::pod_collect_to_vec(&executor.read(id)?))
    }

    /// Gives the buffers back.
    pub fn free(self, executor: &mut dyn Executor) {
        self.buffers.into_iter().for_each(|id| executor.free(id));
    }
}

/// The rows of a case.
fn rows(kernel: &Kernel, case: &Case) -> Rows {
    let binding = |access| kernel.desc.bindings.iter().zip(&case.buffers).find(|(b, _)| b.access == access);
    let uniform = binding(Access::Uniform).map_or(&[][..], |(_, words)| words);
    let out_count = binding(Access::Write).map_or(0, |(b, words)| 4 * words.len() / b.stride_bytes);
    (kernel.rows)(uniform, out_count as u32)
}

/// Bytes of all that is read, and of what the kernel's rows write.
pub fn moved(kernel: &Kernel, case: &Case) -> Moved {
    let mut moved = Moved::default();
    for (binding, words) in kernel.desc.bindings.iter().zip(&case.buffers) {
        let all = 4 * words.len();
        match binding.access {
            Access::Uniform | Access::Read => moved.read += all,
            Access::Atomic => moved.written += all,
            Access::Write => {
                let stored = rows(kernel, case).invocations() as usize * kernel.plane_count * binding.stride_bytes;
                moved.written += stored.min(all);
            }
        }
    }
    moved
}

/// Floating-point operations of a dispatch, from a sample of its elements; `None` for kernels that do not count.
pub fn operations(kernel: &Kernel, case: &Case) -> Option<f64> {
    let count = kernel.operations?;
    let with = |wanted: Access| {
        let bindings = kernel.desc.bindings.iter().zip(&case.buffers);
        bindings.filter(move |(b, _)| b.access == wanted).map(|(_, words)| words.as_slice())
    };
    let uniform = with(Access::Uniform).next()?;
    let reads: Vec<&[u32]> = with(Access::Read).collect();
    let (operations, elements) = count(uniform, &reads);
    Some(operations as f64 * f64::from(rows(kernel, case).invocations()) / elements.max(1) as f64)
}
