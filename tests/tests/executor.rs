//! What executors promise beyond right results: order, reuse, typed errors, time. Most tests run on the CPU and on the
//! adapter both ways; those on an adapter are reported as ignored where there is none.

use interreflect::exec::gpu::ModuleSource;
use interreflect::exec::{
    Backend, CpuExecutor, ExecError, Executor, ExecutorExt, GpuExecutor, GpuOptions, SpirvPath, open, open_adapter,
};
use interreflect_kernels::kernel::{Kernel, KernelDesc};
use interreflect_kernels::smoke::{self, HISTOGRAM_BINS, smoke_axpy, smoke_fill, smoke_histogram};
use interreflect_shared::smoke::SmokeParams;
use interreflect_tests::{gpu, suite};
use libtest_mimic::{Arguments, Failed, Trial};
use std::borrow::Cow;
use std::process::ExitCode;
use std::time::{Duration, Instant};

type TestResult = Result<(), Failed>;
type OnAny = fn(&mut dyn Executor) -> TestResult;
type OnAdapter = fn(SpirvPath) -> TestResult;

/// Tests of every executor.
const ON_ANY: &[(&str, OnAny)] = &[
    ("bytes_come_back", bytes_come_back),
    ("wrong_sizes_are_errors", wrong_sizes_are_errors),
    ("wrong_bindings_are_errors", wrong_bindings_are_errors),
    ("freed_buffers_are_errors", freed_buffers_are_errors),
    ("an_output_too_small_for_its_rows_is_an_error", output_too_small),
    ("nothing_to_do_leaves_the_output", nothing_to_do),
    ("calls_take_effect_in_order", calls_take_effect_in_order),
    ("a_uniform_that_a_kernel_wrote", uniform_written_by_kernel),
    ("a_buffer_in_the_place_of_a_freed_one", buffer_in_place_of_freed),
    ("clear_zeroes_all", clear_zeroes_all),
    ("stages_take_time", stages_take_time),
    ("too_much_memory_is_an_error", too_much_memory),
    ("live_buffers_are_listed", live_buffers_are_listed),
];

/// The histogram's bins in bytes.
const BINS_BYTES: usize = 4 * HISTOGRAM_BINS as usize;

/// Tests that open an adapter of their own.
const ON_ADAPTER: &[(&str, OnAdapter)] = &[
    ("a_lost_device_is_an_error", lost_device),
    ("a_frame_loop_creates_nothing", frame_loop_creates_nothing),
    ("a_missing_module_names_the_kernel", missing_module),
    ("a_module_that_is_no_spirv_names_the_kernel", module_no_spirv),
    ("a_module_without_the_entry_point_names_the_kernel", module_without_entry),
    ("the_canary_finds_a_wrong_device", canary_finds_wrong_device),
    ("a_workgroup_beyond_the_limit_is_an_error", workgroup_beyond_limit),
    ("long_batches_and_large_reads", long_batches_and_large_reads),
];

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let mut trials = vec![
        Trial::test("an_adapter_that_is_not_there", adapter_not_there),
        Trial::test("auto_always_opens", auto_always_opens),
        Trial::test("options_are_checked", options_are_checked),
    ];
    for &(name, test) in ON_ANY {
        trials.push(Trial::test(format!("{name}::cpu"), move || test(&mut CpuExecutor::new())));
        for path in gpu::SPIRV_PATHS {
            let name = format!("{name}::{}", gpu::path_name(path));
            trials.push(suite::gpu_trial(name, path, move || test(&mut *gpu::lock(path)?)));
        }
    }
    for &(name, test) in ON_ADAPTER {
        for path in gpu::SPIRV_PATHS {
            trials.push(suite::gpu_trial(format!("{name}::{}", gpu::path_name(path)), path, move || test(path)));
        }
    }
    libtest_mimic::run(&arguments, trials).exit_code()
}

/// Fails with the text where the condition does not hold.
fn check(holds: bool, text: impl Into<String>) -> TestResult {
    if holds { Ok(()) } else { Err(text.into().into()) }
}

fn params(count: u32, seed: u32) -> SmokeParams {
    SmokeParams { count, seed, scale: 2.0, _pad: 0 }
}

fn leak(kernel: Kernel) -> &'static Kernel {
    Box::leak(Box::new(kernel))
}

fn bytes_come_back(exec: &mut dyn Executor) -> TestResult {
    for count in [0, 1, 3, 15, 16, 17, 255, 256, 257, 100_003] {
        let words: Vec<u32> = (0..count).map(|i: u32| i.wrapping_mul(0x9E37_79B9)).collect();
        let buffer = exec.upload_slice("words", &words)?;
        check(exec.read_slice::<u32>(buffer)? == words, format!("{count} words"))?;
        check(exec.size_bytes(buffer) == u64::from(count) * 4, "size")?;
        let zeros = exec.zeroed_slice::<u32>("zeros", count as usize)?;
        check(exec.read_slice::<u32>(zeros)? == vec![0; count as usize], format!("{count} zeros"))?;
        exec.write(zeros, bytemuck::cast_slice(&words[..count as usize / 2]))?;
        let half = exec.read_slice::<u32>(zeros)?;
        check(half[..count as usize / 2] == words[..count as usize / 2], "the written half")?;
        check(half[count as usize / 2..].iter().all(|&w| w == 0), "the other half")?;
        exec.free(buffer);
        exec.free(zeros);
    }
    Ok(())
}

fn wrong_sizes_are_errors(exec: &mut dyn Executor) -> TestResult {
    let is_buffer_error = |result: Result<_, ExecError>| matches!(result, Err(ExecError::Buffer { .. }));
    check(is_buffer_error(exec.upload("odd", &[1, 2, 3]).map(drop)), "3 bytes")?;
    check(is_buffer_error(exec.zeroed("odd", 6).map(drop)), "6 bytes")?;
    let buffer = exec.zeroed("eight", 8)?;
    check(is_buffer_error(exec.write(buffer, &[0; 12])), "12 bytes into 8")?;
    check(is_buffer_error(exec.write(buffer, &[0; 3])), "3 bytes into 8")
}

fn wrong_bindings_are_errors(exec: &mut dyn Executor) -> TestResult {
    let uniform = exec.upload_one("params", &params(64, 1))?;
    let out = exec.zeroed("out", 256)?;
    let short = exec.zeroed("short", 8)?;
    let mut fails_at = |buffers: &[_], wanted: &str| match exec.run(&smoke_fill::KERNEL, buffers) {
        Err(ExecError::Binding { kernel: "smoke_fill", binding, .. }) => check(binding == wanted, binding),
        other => Err(format!("{wanted}: {other:?}").into()),
    };
    fails_at(&[uniform], "(all)")?;
    fails_at(&[uniform, out, short], "(all)")?;
    fails_at(&[short, out], "params")?;
    fails_at(&[uniform, uniform], "out")
}

fn freed_buffers_are_errors(exec: &mut dyn Executor) -> TestResult {
    let uniform = exec.upload_one("params", &params(64, 1))?;
    let out = exec.zeroed("out", 256)?;
    exec.free(out);
    let freed = |result: Result<_, ExecError>| matches!(result, Err(ExecError::Buffer { .. }));
    check(freed(exec.read(out).map(drop)), "read")?;
    check(freed(exec.write(out, &[0; 4])), "write")?;
    check(freed(exec.clear(out)), "clear")?;
    check(freed(exec.run(&smoke_fill::KERNEL, &[uniform, out])), "run")?;
    check(exec.size_bytes(out) == 0, "size")?;
    exec.free(out);
    Ok(())
}

fn output_too_small(exec: &mut dyn Executor) -> TestResult {
    // 300 elements are two rows of 256: the output must hold 512.
    let uniform = exec.upload_one("params", &params(300, 1))?;
    let [x, y] = [exec.zeroed("x", 2048)?, exec.zeroed("y", 2048)?];
    let out = exec.zeroed("out", 2044)?;
    match exec.run(&smoke_axpy::KERNEL, &[uniform, x, y, out]) {
        Err(ExecError::Binding { binding: "out", .. }) => Ok(()),
        other => Err(format!("{other:?}").into()),
    }
}

fn nothing_to_do(exec: &mut dyn Executor) -> TestResult {
    let uniform = exec.upload_one("params", &params(0, 1))?;
    let empty = exec.zeroed("empty", 0)?;
    exec.run(&smoke_fill::KERNEL, &[uniform, empty])?;
    check(exec.read(empty)?.is_empty(), "empty output")?;
    let bins = exec.upload_slice("bins", &[7u32; HISTOGRAM_BINS as usize])?;
    exec.run(&smoke_histogram::KERNEL, &[uniform, empty, bins])?;
    check(exec.read_slice::<u32>(bins)? == [7; HISTOGRAM_BINS as usize], "no invocation, no change")
}

fn calls_take_effect_in_order(exec: &mut dyn Executor) -> TestResult {
    const COUNT: u32 = 1000;
    let uniform = exec.upload_one("params", &params(COUNT, 0))?;
    let mut outputs = Vec::new();
    // The same parameter buffer, written between dispatches that nothing waits for.
    for seed in 1..80 {
        exec.write(uniform, bytemuck::bytes_of(&params(COUNT, seed)))?;
        let out = exec.zeroed_slice::<u32>("out", COUNT as usize)?;
        exec.run(&smoke_fill::KERNEL, &[uniform, out])?;
        outputs.push((seed, out));
    }
    for (seed, out) in outputs {
        let expected: Vec<u32> = (0..COUNT).map(|i| smoke::fill(i, &params(COUNT, seed))).collect();
        check(exec.read_slice::<u32>(out)? == expected, format!("dispatch {seed}"))?;
    }
    // Each sees what the one before left: y = 2y + x over and over, then cleared, then written.
    let x = exec.upload_slice("x", &[1.0f32; 256])?;
    let [mut a, mut b] = [exec.zeroed("a", 1024)?, exec.zeroed("b", 1024)?];
    let step = exec.upload_one("params", &params(256, 0))?;
    for _ in 0..10 {
        exec.run(&smoke_axpy::KERNEL, &[step, a, x, b])?;
        std::mem::swap(&mut a, &mut b);
    }
    check(exec.read_slice::<f32>(a)? == [1023.0; 256], "ten dependent dispatches")?;
    exec.clear(a)?;
    check(exec.read_slice::<f32>(a)? == [0.0; 256], "cleared")
}

fn uniform_written_by_kernel(exec: &mut dyn Executor) -> TestResult {
    let made = exec.zeroed("made by a kernel", 16)?;
    // Element 0 of the canary is its seed: read as parameters, the count.
    let uniform = exec.upload_one("params", &params(4, 5))?;
    exec.run(&smoke_fill::KERNEL, &[uniform, made])?;
    let values = exec.zeroed("values", 20)?;
    let bins = exec.zeroed("bins", BINS_BYTES)?;
    exec.run(&smoke_histogram::KERNEL, &[made, values, bins])?;
    let counted: u32 = exec.read_slice::<u32>(bins)?.iter().sum();
    check(counted == 5, format!("{counted} invocations instead of 5"))
}

fn buffer_in_place_of_freed(exec: &mut dyn Executor) -> TestResult {
    let uniform = exec.upload_one("params", &params(64, 9))?;
    let expected: Vec<u32> = (0..64).map(|i| smoke::fill(i, &params(64, 9))).collect();
    for round in 0..3 {
        let mark = exec.mark();
        let out = exec.zeroed("out", 256)?;
        exec.run(&smoke_fill::KERNEL, &[uniform, out])?;
        check(exec.read_slice::<u32>(out)? == expected, format!("round {round}"))?;
        exec.free_since(mark);
    }
    Ok(())
}

fn clear_zeroes_all(exec: &mut dyn Executor) -> TestResult {
    for count in [0usize, 1, 5, 300, 300_000] {
        let buffer = exec.upload_slice("ones", &vec![1u32; count])?;
        exec.clear(buffer)?;
        check(exec.read_slice::<u32>(buffer)? == vec![0; count], format!("{count} words"))?;
    }
    Ok(())
}

fn stages_take_time(exec: &mut dyn Executor) -> TestResult {
    const COUNT: u32 = 1 << 20;
    let uniform = exec.upload_one("params", &params(COUNT, 0))?;
    let out = exec.zeroed_slice::<u32>("out", COUNT as usize)?;
    exec.run(&smoke_fill::KERNEL, &[uniform, out])?;
    let mut stage = |dispatches: usize| -> Result<(f64, Duration), Failed> {
        let start = Instant::now();
        exec.begin();
        for _ in 0..dispatches {
            exec.run(&smoke_fill::KERNEL, &[uniform, out])?;
        }
        Ok((exec.end()?, start.elapsed()))
    };
    stage(1)?;
    let fastest = |runs: Vec<f64>| runs.into_iter().fold(f64::MAX, f64::min);
    let one = fastest((0..5).map(|_| stage(1).map(|t| t.0)).collect::<Result<_, _>>()?);
    let (forty, wall) = stage(40)?;
    check(one > 0.0, format!("one dispatch took {one} ms"))?;
    check(forty > 4.0 * one, format!("40 dispatches took {forty} ms, one {one} ms"))?;
    let wall_ms = wall.as_secs_f64() * 1e3;
    check(forty <= wall_ms, format!("the stage took {forty} ms of the {wall_ms} ms that passed"))?;
    check(exec.end()? == 0.0, "a stage that did not begin")
}

fn too_much_memory(exec: &mut dyn Executor) -> TestResult {
    let bytes = 1usize << 60;
    match exec.zeroed("monster", bytes) {
        Err(ExecError::OutOfMemory { label, bytes: told, reason }) => {
            check(
                label == "monster" && told == bytes as u64 && !reason.is_empty(),
                format!("{label} {told} {reason}"),
            )?;
        }
        other => return Err(format!("{other:?}").into()),
    }
    // It goes on working.
    bytes_come_back(exec)
}

fn live_buffers_are_listed(exec: &mut dyn Executor) -> TestResult {
    let before = exec.buffers().len();
    let mark = exec.mark();
    let a = exec.zeroed("first", 8)?;
    exec.zeroed("second", 12)?;
    check(exec.buffers()[before..] == [("first".to_string(), 8), ("second".to_string(), 12)], "both")?;
    exec.free(a);
    check(exec.buffers()[before..] == [("second".to_string(), 12)], "the second")?;
    exec.free_since(mark);
    check(exec.buffers().len() == before, "none")
}

fn lost_device(path: SpirvPath) -> TestResult {
    let mut exec = gpu::open(path)?;
    let uniform = exec.upload_one("params", &params(64, 1))?;
    let out = exec.zeroed("out", 256)?;
    exec.run(&smoke_fill::KERNEL, &[uniform, out])?;
    exec.destroy_device();
    let lost = |result: Result<_, ExecError>| match result {
        Err(ExecError::DeviceLost { .. }) => Ok(()),
        other => Err(Failed::from(format!("{other:?}"))),
    };
    for _ in 0..2 {
        lost(exec.run(&smoke_fill::KERNEL, &[uniform, out]))?;
        lost(exec.run(&smoke_histogram::KERNEL, &[uniform, out, out]))?;
        lost(exec.read(out).map(drop))?;
        lost(exec.write(out, &[0; 4]))?;
        lost(exec.clear(out))?;
        lost(exec.upload("new", &[0; 4]).map(drop))?;
        exec.begin();
        lost(exec.end().map(drop))?;
    }
    exec.free(out);
    Ok(())
}

fn frame_loop_creates_nothing(path: SpirvPath) -> TestResult {
    let mut exec = gpu::open(path)?;
    let uniform = exec.upload_one("params", &params(256, 1))?;
    let [x, a, b] = [exec.zeroed("x", 1024)?, exec.zeroed("a", 1024)?, exec.zeroed("b", 1024)?];
    let frame = |exec: &mut GpuExecutor, seed| -> TestResult {
        exec.write(uniform, bytemuck::bytes_of(&params(256, seed)))?;
        exec.begin();
        exec.clear(a)?;
        for _ in 0..50 {
            exec.run(&smoke_axpy::KERNEL, &[uniform, x, a, b])?;
            exec.run(&smoke_axpy::KERNEL, &[uniform, x, b, a])?;
        }
        exec.end()?;
        exec.read(a)?;
        Ok(())
    };
    frame(&mut exec, 0)?;
    let made = exec.objects();
    for seed in 1..20 {
        frame(&mut exec, seed)?;
    }
    check(exec.objects() == made, format!("{made:?} before, {:?} after", exec.objects()))
}

/// An adapter whose kernels come from `load`.
fn with_modules(path: SpirvPath, load: fn(&str) -> Option<Cow<'static, [u8]>>) -> Result<GpuExecutor, ExecError> {
    GpuExecutor::open(&GpuOptions { spirv: Some(path), modules: ModuleSource::new(load), ..Default::default() })
}

fn compiled(name: &str) -> Option<Cow<'static, [u8]>> {
    interreflect_kernels::compiled::module(name).map(|m| Cow::Borrowed(m.spirv))
}

/// The error of the first histogram on an adapter with these modules.
fn histogram_error(path: SpirvPath, load: fn(&str) -> Option<Cow<'static, [u8]>>) -> TestResult {
    let mut exec = with_modules(path, load)?;
    let uniform = exec.upload_one("params", &params(64, 1))?;
    let [values, bins] = [exec.zeroed("values", 256)?, exec.zeroed("bins", BINS_BYTES)?];
    for _ in 0..2 {
        match exec.run(&smoke_histogram::KERNEL, &[uniform, values, bins]) {
            Err(ExecError::Pipeline { kernel, reason }) => {
                check(kernel == "smoke_histogram" && !reason.is_empty() && !reason.contains('\n'), reason)?;
            }
            other => return Err(format!("{other:?}").into()),
        }
    }
    // Other kernels go on.
    exec.run(&smoke_fill::KERNEL, &[uniform, bins])?;
    check(exec.read_slice::<u32>(bins)?[1] == smoke::fill(1, &params(64, 1)), "the next kernel")
}

fn missing_module(path: SpirvPath) -> TestResult {
    histogram_error(path, |name| if name == "smoke_histogram" { None } else { compiled(name) })
}

fn module_no_spirv(path: SpirvPath) -> TestResult {
    histogram_error(
        path,
        |name| if name == "smoke_histogram" { Some(Cow::Borrowed(b"GIF89a..")) } else { compiled(name) },
    )
}

fn module_without_entry(path: SpirvPath) -> TestResult {
    histogram_error(path, |name| compiled(if name == "smoke_histogram" { "smoke_axpy" } else { name }))
}

fn canary_finds_wrong_device(path: SpirvPath) -> TestResult {
    // The canary's hash with another factor: what a device would give that computes wrong.
    let wrong = |name: &str| {
        let mut bytes = compiled(name)?.into_owned();
        let factor = 747_796_405u32.to_le_bytes();
        for word in bytes.as_chunks_mut::<4>().0 {
            if *word == factor {
                *word = 747_796_407u32.to_le_bytes();
            }
        }
        Some(Cow::Owned(bytes))
    };
    match with_modules(path, wrong) {
        Err(ExecError::BrokenDevice { reason, .. }) => check(reason.contains("word 1 "), reason),
        Err(other) => Err(other.to_string().into()),
        Ok(_) => Err("the canary passed".into()),
    }
}

fn workgroup_beyond_limit(path: SpirvPath) -> TestResult {
    let desc = KernelDesc { name: "too_large", workgroup_size: 1 << 16, ..smoke_fill::DESC };
    let kernel = leak(Kernel { desc, ..smoke_fill::KERNEL });
    let mut exec = gpu::open(path)?;
    let uniform = exec.upload_one("params", &params(64, 1))?;
    let out = exec.zeroed("out", 256)?;
    match exec.run(kernel, &[uniform, out]) {
        Err(ExecError::Limit { kernel: "too_large", needed: 65_536, .. }) => Ok(()),
        other => Err(format!("{other:?}").into()),
    }
}

fn long_batches_and_large_reads(path: SpirvPath) -> TestResult {
    // More than one piece of the staging buffer (64 MiB).
    const COUNT: u32 = (80 << 20) / 4;
    let mut exec = gpu::open(path)?;
    let uniform = exec.upload_one("params", &params(COUNT, 3))?;
    let out = exec.zeroed_slice::<u32>("out", COUNT as usize)?;
    exec.run(&smoke_fill::KERNEL, &[uniform, out])?;
    let words = exec.read_slice::<u32>(out)?;
    check(words.len() == COUNT as usize, "length")?;
    let wrong = (0..COUNT).find(|&i| words[i as usize] != smoke::fill(i, &params(COUNT, 3)));
    check(wrong.is_none(), format!("word {wrong:?}"))
}

fn adapter_not_there() -> TestResult {
    let name = "no such adapter";
    for backend in [Backend::Auto, Backend::Gpu, Backend::Cpu] {
        match open_adapter(backend, Some(name), &mut |_| ()) {
            Err(ExecError::NoAdapter { wanted, .. }) => check(wanted.contains(name), wanted)?,
            Err(other) => return Err(other.to_string().into()),
            Ok(_) => return Err(format!("{backend:?} opened something").into()),
        }
    }
    Ok(())
}

fn auto_always_opens() -> TestResult {
    let mut warnings = Vec::new();
    let exec = open(Backend::Auto, &mut |text| warnings.push(text))?;
    let device = exec.device();
    let hardware = interreflect::exec::list_devices().iter().any(|d| d.kind.is_hardware());
    // Without hardware the processor, and no word about it; a software driver is never taken.
    check(device.backend == "cpu" || device.hardware_gpu, format!("{device:?}"))?;
    check(hardware || (device.backend == "cpu" && warnings.is_empty()), format!("{device:?} {warnings:?}"))?;
    check(open(Backend::Cpu, &mut |_| ())?.device().backend == "cpu", "cpu")
}

fn options_are_checked() -> TestResult {
    let bad = |result: Result<(), ExecError>| matches!(result, Err(ExecError::Option { value, .. }) if value == "x");
    check(bad("x".parse::<Backend>().map(drop)), "backend")?;
    check(bad("x".parse::<SpirvPath>().map(drop)), "SPIR-V path")?;
    check(matches!("gpu".parse(), Ok(Backend::Gpu)) && matches!("naga".parse(), Ok(SpirvPath::Naga)), "good ones")
}
