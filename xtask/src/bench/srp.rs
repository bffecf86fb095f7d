//! Sparse radiance probes at run time, at the size of Sponza in Silvennoinen & Lehtinen 2017 (Tables 1 and 2): each stage
//! beside its limit, the cost against order, probes and receivers, and the CPU against a device.
//!
//! The bake is random with exactly the paper's sizes; two thirds of its relight rays meet receivers at random, which is
//! worse for caches than any scene. Limits and stages take turns. Shown are the least time of many, the median, and
//! processor time: what all threads together spent, over their number. On a machine that does nothing else the three
//! agree; on a busy one the clock counts the others' time too, and processor time is what a free machine would take, if
//! work is even.

use super::{Bench, limits, median};
use anyhow::Result;
use glam::Vec3;
use interreflect::exec::{CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::srp::runtime::{PASSES, RuntimeOptions, SrpRuntime};
use interreflect::methods::srp::synthetic::{self, SPONZA, Sizes};
use interreflect_kernels::sh::project::sh_project;
use interreflect_shared::sh::{ShLayout, ShParams};
use serde::Serialize;
use serde_json::{Value, json};
use std::time::Instant;

const REPEATS: usize = 40;
/// Repeats between two readings of processor time, which the system keeps in steps of milliseconds.
const PROCESSOR_REPEATS: usize = 40;
/// Repeats of a point of a curve.
const CURVE_REPEATS: usize = 9;
/// Side of the square matrices of the product that is the limit.
const PRODUCT_SIDE: usize = 1024;
/// The paper's times on a Titan X (Pascal), Table 2: scene relight, probe relight, cluster projection, receivers.
const PAPER_MS: [f64; 4] = [0.36, 1.01, 1.00, 0.13];
/// Sixty updates a second.
const BUDGET_MS: f64 = 1000.0 / 60.0;

/// Seconds of something done several times.
#[derive(Clone, Default)]
struct Times(Vec<f64>);

impl Times {
    fn add(&mut self, work: impl FnOnce() -> Result<()>) -> Result<()> {
        let start = Instant::now();
        work()?;
        self.0.push(start.elapsed().as_secs_f64());
        Ok(())
    }
    fn least_ms(&self) -> f64 {
        self.0.iter().copied().fold(f64::INFINITY, f64::min) * 1e3
    }
    fn median_ms(&self) -> f64 {
        median(self.0.clone()) * 1e3
    }
}

/// Nanoseconds that all threads of this program have run, where the system tells.
fn processor_ns() -> Option<u64> {
    let mut sum = 0;
    for task in std::fs::read_dir("/proc/self/task").ok()? {
        let text = std::fs::read_to_string(task.ok()?.path().join("schedstat")).ok()?;
        sum += text.split_whitespace().next()?.parse::<u64>().ok()?;
    }
    Some(sum)
}

/// Processor milliseconds of one piece of work on every thread, from [`PROCESSOR_REPEATS`] of them.
fn processor_ms(mut work: impl FnMut() -> Result<()>) -> Result<f64> {
    let before = processor_ns();
    for _ in 0..PROCESSOR_REPEATS {
        work()?;
    }
    let spent = processor_ns().zip(before).map_or(f64::NAN, |(after, before)| (after - before) as f64);
    Ok(spent * 1e-6 / PROCESSOR_REPEATS as f64 / rayon::current_num_threads() as f64)
}

/// A stage's figures.
#[derive(Serialize)]
struct Row {
    stage: &'static str,
    least_ms: f64,
    median_ms: f64,
    /// Of all threads, over their number.
    processor_ms: f64,
    /// What binds it: `product` or `reading`; empty where the stage stands beside no limit.
    limit: &'static str,
    /// Share of that limit: least time against least time, median against median, processor time against processor time.
    share: Option<[f64; 3]>,
}

impl Row {
    fn ms(&self) -> [f64; 3] {
        [self.least_ms, self.median_ms, self.processor_ms]
    }
}

/// The section.
pub fn run(bench: &mut Bench) -> Result<Value> {
    let update = paper_size(bench)?;
    let curves = curves(bench)?;
    let devices = against_device(bench)?;
    Ok(json!({ "update": update, "curves": curves, "device": devices }))
}

fn lit(exec: &mut dyn Executor, sizes: &Sizes, bounces: u32) -> Result<SrpRuntime> {
    let bake = synthetic::bake(sizes, 1);
    let mut runtime = SrpRuntime::new(exec, &bake, &RuntimeOptions::default())?;
    runtime.set_direct(exec, &vec![Vec3::ONE; bake.receivers.len()])?;
    runtime.set_bounces(bounces);
    Ok(runtime)
}

/// Something that is timed.
type Work<'a> = Box<dyn FnMut(&mut CpuExecutor) -> Result<()> + 'a>;

/// All stages at the paper's size, in turns with the limits.
fn paper_size(bench: &mut Bench) -> Result<Value> {
    let exec = &mut bench.cpu;
    let mark = exec.mark();
    let runtime = lit(exec, &SPONZA, 1)?;
    let unblocked = Unblocked::new(exec, &SPONZA)?;
    let coefs = (SPONZA.order + 1).pow(2) as usize;
    let mut product = Product::new(PRODUCT_SIDE, PRODUCT_SIDE, PRODUCT_SIDE);
    let mut same_shape = Product::new(coefs, SPONZA.rays as usize, 3 * SPONZA.probes as usize);
    let block = vec![1u32; limits::LARGE_BYTES / 4];
    let (projection_bytes, reconstruction_bytes) = runtime.matrix_bytes(exec);
    // Operations or bytes beside each piece of work, and its limit.
    let operations = 2.0 * coefs as f64 * f64::from(SPONZA.rays) * 3.0 * f64::from(SPONZA.probes);
    let product_operations = 2.0 * (PRODUCT_SIDE as f64).powi(3);
    let runtime = &runtime;
    let mut works: Vec<(&'static str, &'static str, f64, Work<'_>)> = vec![
        ("limit: product", "product", product_operations, Box::new(|_| product.run())),
        ("limit: reading", "reading", limits::LARGE_BYTES as f64, Box::new(|_| limits::read(&block))),
    ];
    for (name, pass) in PASSES {
        let (limit, size) = match name {
            "cluster projection" => ("reading", projection_bytes as f64),
            "reconstruction" => ("reading", reconstruction_bytes as f64),
            _ => ("", 0.0),
        };
        works.push((name, limit, size, Box::new(move |exec| Ok(pass(runtime, exec)?))));
    }
    let whole = move |exec: &mut CpuExecutor| PASSES.iter().try_for_each(|(_, pass)| Ok(pass(runtime, exec)?));
    works.push(("whole update", "", 0.0, Box::new(whole)));
    works.push(("- gathering alone", "", 0.0, Box::new(|exec| Ok(runtime.gather_alone(exec)?))));
    works.push(("- projection alone", "product", operations, Box::new(|exec| Ok(runtime.project_alone(exec)?))));
    works.push(("sh_project, same product", "product", operations, Box::new(|exec| unblocked.run(exec))));
    works.push(("gemm crate, same product", "product", operations, Box::new(|_| same_shape.run())));
    works.push((
        "lightmap with dilation",
        "",
        0.0,
        Box::new(|exec| runtime.atlas(exec).map(|_| ()).map_err(Into::into)),
    ));

    let mut times = vec![Times::default(); works.len()];
    for turn in 0..=REPEATS {
        for ((_, _, _, work), times) in works.iter_mut().zip(&mut times) {
            times.add(|| work(exec))?;
            if turn == 0 {
                // The first turn warms up.
                times.0.clear();
            }
        }
    }
    let mut rows: Vec<Row> = Vec::new();
    let mut rates: Vec<(&'static str, [f64; 3])> = Vec::new();
    for ((stage, limit, size, work), times) in works.iter_mut().zip(&times) {
        let processor_ms = processor_ms(|| work(exec))?;
        let mut row =
            Row { stage, least_ms: times.least_ms(), median_ms: times.median_ms(), processor_ms, limit, share: None };
        let rate = row.ms().map(|ms| *size / ms);
        if stage.starts_with("limit") {
            rates.push((limit, rate));
        } else if let Some((_, of)) = rates.iter().find(|(name, _)| name == limit) {
            row.share = Some(std::array::from_fn(|k| rate[k] / of[k]));
        }
        rows.push(row);
    }
    drop(works);
    print_update(&rows, &rates);
    exec.free_since(mark);
    let per_s = |limit: &str| rates.iter().find(|(name, _)| *name == limit).map(|(_, rate)| rate.map(|r| r * 1e3));
    Ok(json!({
        "sizes": SPONZA_TEXT,
        "rows": rows,
        "product_flops_per_s": per_s("product"),
        "read_bytes_per_s": per_s("reading"),
    }))
}

fn print_update(rows: &[Row], rates: &[(&str, [f64; 3])]) {
    println!("\nSparse radiance probes, {SPONZA_TEXT}");
    println!("{:<26} {:>9} {:>9} {:>12}   share of limit", "stage", "least ms", "median", "processor ms");
    for r in rows {
        let share = r.share.map_or_else(String::new, |[a, b, c]| {
            format!("{:.0} %, {:.0} %, {:.0} % of {}", 100.0 * a, 100.0 * b, 100.0 * c, r.limit)
        });
        println!("{:<26} {:>9.2} {:>9.2} {:>12.2}   {share}", r.stage, r.least_ms, r.median_ms, r.processor_ms);
    }
    for (limit, [a, b, c]) in rates {
        println!("{limit}: {:.1}, {:.1}, {:.1} G/s", a * 1e-6, b * 1e-6, c * 1e-6);
    }
    if let Some(whole) = rows.iter().find(|r| r.stage == "whole update") {
        let [least, median, processor] = whole.ms().map(verdict);
        println!(
            "budget {BUDGET_MS:.1} ms: {least} by the least, {median} by the median, {processor} by processor time; the \
             paper's GPU takes {:.2} ms",
            PAPER_MS.iter().sum::<f64>()
        );
    }
}

const SPONZA_TEXT: &str = "150 probes × 64 coefficients × 8000 rays, 935 clusters of 24.4 ranks and 20.2 probes, 246,325 \
     receivers, lightmap of 1216²";

fn verdict(ms: f64) -> &'static str {
    if ms <= BUDGET_MS { "within" } else { "beyond" }
}

/// A matrix product by a library that is made for it.
struct Product {
    size: [usize; 3],
    a: Vec<f32>,
    b: Vec<f32>,
    c: Vec<f32>,
}

impl Product {
    fn new(m: usize, k: usize, n: usize) -> Self {
        Self { size: [m, k, n], a: vec![1.0; m * k], b: vec![0.5; k * n], c: vec![0.0; m * n] }
    }
    #[expect(unsafe_code, reason = "the library takes pointers")]
    fn run(&mut self) -> Result<()> {
        let [m, k, n] = self.size;
        // SAFETY: the matrices are column-major and as large as the sizes and strides say.
        unsafe {
            gemm::gemm(
                m,
                n,
                k,
                self.c.as_mut_ptr(),
                m as isize,
                1,
                false,
                self.a.as_ptr(),
                m as isize,
                1,
                self.b.as_ptr(),
                k as isize,
                1,
                0.0,
                1.0,
                false,
                false,
                false,
                gemm::Parallelism::Rayon(0),
            );
        }
        anyhow::ensure!(self.c[0] == 0.5 * k as f32, "the product is wrong");
        Ok(())
    }
}

/// The same projection by the kernel that is not blocked.
struct Unblocked {
    buffers: [interreflect::exec::BufferId; 4],
}

impl Unblocked {
    fn new(exec: &mut dyn Executor, sizes: &Sizes) -> Result<Self> {
        let params =
            ShParams { element_count: sizes.probes, sample_count: sizes.rays, order: sizes.order, weight: 1.0 };
        let layout = ShLayout::new(params.element_count, params.order);
        let table = vec![0.5f32; (4 * layout.blocks * sizes.rays) as usize];
        let light = vec![0.25f32; layout.samples_len(sizes.rays)];
        Ok(Self {
            buffers: [
                exec.upload_one("params", &params)?,
                exec.upload_slice("table", &table)?,
                exec.upload_slice("radiance", &light)?,
                exec.zeroed_slice::<f32>("coefs", layout.len())?,
            ],
        })
    }
    fn run(&self, exec: &mut dyn Executor) -> Result<()> {
        Ok(exec.run(&sh_project::KERNEL, &self.buffers)?)
    }
}

/// Cost against order, probes and receivers, one at a time, as the implementation study varies them (§6.5).
fn curves(bench: &mut Bench) -> Result<Value> {
    let base = Sizes {
        probes: 20,
        order: 2,
        rays: 1024,
        clusters: 100,
        mean_rank: 16.0,
        mean_probes: 10.0,
        receivers: 50_784,
        rows_per_receiver: 1,
        atlas_side: 0,
    };
    // As many receivers per cluster everywhere.
    let receivers = |n: u32| Sizes { receivers: n, clusters: n / 500, ..base };
    let curves: [(&str, Vec<(u32, Sizes)>); 3] = [
        ("order", (0..=9).map(|order| (order, Sizes { order, ..base })).collect()),
        ("probes", [20, 50, 100, 150, 200].map(|probes| (probes, Sizes { probes, ..base })).to_vec()),
        ("receivers", [50_784, 100_000, 250_000, 500_000, 1_000_000].map(|n| (n, receivers(n))).to_vec()),
    ];
    let mut report = serde_json::Map::new();
    for (name, points) in curves {
        println!("\nupdate against {name} (others: order 2, 20 probes, 50,784 receivers; 1024 rays, rank 16)");
        let mut rows = Vec::new();
        for (x, sizes) in points {
            let (stages, whole) = update_ms(&mut bench.cpu, &sizes)?;
            println!("{x:>10} {whole:>9.3} ms  ({})", stages.join(", "));
            rows.push(json!({ name: x, "least_ms": whole }));
        }
        report.insert(name.into(), Value::Array(rows));
    }
    Ok(Value::Object(report))
}

/// Least milliseconds of each pass, as text, and of all together.
fn update_ms(exec: &mut CpuExecutor, sizes: &Sizes) -> Result<(Vec<String>, f64)> {
    let mark = exec.mark();
    let runtime = lit(exec, sizes, 1)?;
    let mut passes = vec![Times::default(); PASSES.len()];
    for _ in 0..CURVE_REPEATS {
        for ((_, pass), times) in PASSES.iter().zip(&mut passes) {
            times.add(|| Ok(pass(&runtime, exec)?))?;
        }
    }
    exec.free_since(mark);
    let text = PASSES.iter().zip(&passes).map(|((name, _), t)| format!("{name} {:.2}", t.least_ms())).collect();
    Ok((text, passes.iter().map(Times::least_ms).sum()))
}

/// Every pass on the CPU and on a device with the same bake, in turns.
fn against_device(bench: &mut Bench) -> Result<Value> {
    let Some(gpu) = &mut bench.gpu else { return Ok(Value::Null) };
    let cpu = &mut bench.cpu;
    let (cpu_mark, gpu_mark) = (cpu.mark(), gpu.mark());
    let on_cpu = lit(cpu, &SPONZA, 1)?;
    let on_gpu = lit(gpu, &SPONZA, 1)?;
    let mut times = vec![[Times::default(), Times::default()]; PASSES.len()];
    for turn in 0..=CURVE_REPEATS {
        for ((_, pass), times) in PASSES.iter().zip(&mut times) {
            let seconds = |exec: &mut dyn Executor, runtime: &SrpRuntime| -> Result<f64> {
                exec.begin();
                pass(runtime, exec)?;
                Ok(exec.end()? * 1e-3)
            };
            let both = [seconds(cpu, &on_cpu)?, seconds(gpu, &on_gpu)?];
            if turn > 0 {
                times.iter_mut().zip(both).for_each(|(t, s)| t.0.push(s));
            }
        }
    }
    println!("\n{:<24} {:>10} {:>12} {:>10}", "stage", "CPU ms", "device ms", "CPU wins");
    let mut rows = Vec::new();
    for ((name, _), [cpu, gpu]) in PASSES.iter().zip(&times) {
        let (cpu, gpu) = (cpu.median_ms(), gpu.median_ms());
        println!("{name:<24} {cpu:>10.2} {gpu:>12.2} {:>9.1}×", gpu / cpu);
        rows.push(json!({ "stage": name, "cpu_median_ms": cpu, "device_median_ms": gpu }));
    }
    cpu.free_since(cpu_mark);
    gpu.free_since(gpu_mark);
    Ok(Value::Array(rows))
}
