//! Each check of the harness can fail: a fault is put in and must be found, under its own name.

use interreflect::exec::{BufferId, CpuExecutor, DeviceInfo, ExecError, Executor, Mark};
use interreflect_kernels::kernel::{Case, Flavour, Kernel, Piece, Tolerance};
use interreflect_kernels::smoke::{smoke_axpy, smoke_fill, smoke_histogram};
use interreflect_shared::smoke::SmokeParams;
use interreflect_tests::Failure;
use interreflect_tests::compare::{Allowed, compare};
use interreflect_tests::gpu::{Availability, availability};
use interreflect_tests::run::run_case;
use interreflect_tests::suite::{self, Request};
use std::process::Command;

/// A CPU executor whose results are tampered with when they are read.
struct Tampered {
    inner: CpuExecutor,
    tamper: fn(&mut Vec<u32>),
    skip_run: bool,
}

impl Tampered {
    fn new(tamper: fn(&mut Vec<u32>)) -> Self {
        Self { inner: CpuExecutor::new(), tamper, skip_run: false }
    }
}

impl Executor for Tampered {
    fn device(&self) -> DeviceInfo {
        DeviceInfo { backend: "tampered".into(), ..self.inner.device() }
    }
    fn upload(&mut self, label: &str, bytes: &[u8]) -> Result<BufferId, ExecError> {
        self.inner.upload(label, bytes)
    }
    fn zeroed(&mut self, label: &str, bytes: usize) -> Result<BufferId, ExecError> {
        self.inner.zeroed(label, bytes)
    }
    fn write(&mut self, buffer: BufferId, bytes: &[u8]) -> Result<(), ExecError> {
        self.inner.write(buffer, bytes)
    }
    fn clear(&mut self, buffer: BufferId) -> Result<(), ExecError> {
        self.inner.clear(buffer)
    }
    fn run(&mut self, kernel: &'static Kernel, buffers: &[BufferId]) -> Result<(), ExecError> {
        if self.skip_run { Ok(()) } else { self.inner.run(kernel, buffers) }
    }
    fn read(&mut self, buffer: BufferId) -> Result<Vec<u8>, ExecError> {
        let mut words: Vec<u32> = bytemuck::pod_collect_to_vec(&self.inner.read(buffer)?);
        (self.tamper)(&mut words);
        Ok(bytemuck::pod_collect_to_vec(&words))
    }
    fn free(&mut self, buffer: BufferId) {
        self.inner.free(buffer);
    }
    fn size_bytes(&self, buffer: BufferId) -> u64 {
        self.inner.size_bytes(buffer)
    }
    fn mark(&self) -> Mark {
        self.inner.mark()
    }
    fn free_since(&mut self, mark: Mark) {
        self.inner.free_since(mark);
    }
    fn begin(&mut self) {
        self.inner.begin();
    }
    fn end(&mut self) -> Result<f64, ExecError> {
        self.inner.end()
    }
    fn buffers(&self) -> Vec<(String, u64)> {
        self.inner.buffers()
    }
}

/// What the suite says of a kernel whose results were tampered with.
fn tampered(kernel: &'static Kernel, tamper: fn(&mut Vec<u32>)) -> Failure {
    let result = suite::same_as_cpu(&mut Tampered::new(tamper), kernel);
    result.expect_err("the fault was not found").failure
}

fn change_last(words: &mut [u32], change: impl Fn(u32) -> u32) {
    if let Some(word) = words.last_mut() {
        *word = change(*word);
    }
}

fn ordinary(kernel: &Kernel) -> Case {
    Request { seed: 1, count: 300, flavour: Flavour::Ordinary }.case(kernel)
}

fn leak(kernel: Kernel) -> &'static Kernel {
    Box::leak(Box::new(kernel))
}

#[test]
fn untampered_results_pass() {
    for kernel in [&smoke_fill::KERNEL, &smoke_axpy::KERNEL, &smoke_histogram::KERNEL] {
        suite::same_as_cpu(&mut Tampered::new(|_| ()), kernel).unwrap();
        suite::same_bits_on_cpu(kernel).unwrap();
    }
}

#[test]
fn an_integer_that_is_off_by_one() {
    let failure = tampered(&smoke_fill::KERNEL, |words| change_last(words, |w| w.wrapping_add(1)));
    assert!(matches!(&failure, Failure::Differs(d) if d.place.executor == "tampered"), "{failure}");
}

#[test]
fn an_atomic_word_that_is_off_by_one() {
    let failure = tampered(&smoke_histogram::KERNEL, |words| change_last(words, |w| w + 1));
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
}

#[test]
fn a_float_beyond_the_tolerance() {
    // Declared: 1e-6 relative. 64 units in the last place are more than that, 2 are not.
    let failure = tampered(&smoke_axpy::KERNEL, |words| change_last(words, |w| w.wrapping_add(64)));
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
    let within = |words: &mut Vec<u32>| change_last(words, |w| if w == 0 { 0 } else { w + 2 });
    suite::same_as_cpu(&mut Tampered::new(within), &smoke_axpy::KERNEL).unwrap();
}

#[test]
fn fixed_point_words_too_far_apart() {
    assert!(Tolerance::FixedPoint(2).accepts_words(u32::MAX, 1), "-1 and 1 are two units apart");
    assert!(!Tolerance::FixedPoint(2).accepts_words(u32::MAX, 2));
    assert!(!Tolerance::RelAbs(1.0, 10.0).accepts_words(5, 6), "other integers exactly");
}

#[test]
fn a_float_that_is_infinite_on_one_side() {
    let failure = tampered(&smoke_axpy::KERNEL, |words| change_last(words, |_| f32::INFINITY.to_bits()));
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
    assert!(!Tolerance::RelAbs(1e-3, 1e-3).accepts(1.0, f32::INFINITY));
    assert!(!Tolerance::RelAbs(1e-3, 1e-3).accepts(f32::NEG_INFINITY, f32::INFINITY));
    assert!(Tolerance::RelAbs(0.0, 0.0).accepts(f32::INFINITY, f32::INFINITY));
}

#[test]
fn zeros_in_the_place_of_results() {
    let failure = tampered(&smoke_axpy::KERNEL, |words| words.fill(0));
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
}

#[test]
fn a_nan() {
    let failure = tampered(&smoke_axpy::KERNEL, |words| change_last(words, |_| f32::NAN.to_bits()));
    assert!(matches!(failure, Failure::NotANumber(_)), "{failure}");
}

#[test]
fn the_same_nan_on_both_sides() {
    fn nan(job: Piece<'_>) {
        job.planes[0].fill(f32::NAN.to_bits());
    }
    let kernel = leak(Kernel { cpu: nan, ..smoke_axpy::KERNEL });
    let failure = suite::same_as_cpu(&mut CpuExecutor::new(), kernel).expect_err("NaN passed").failure;
    assert!(matches!(failure, Failure::NotANumber(_)), "{failure}");
    assert!(!Tolerance::RelAbs(1.0, 1.0).accepts(f32::NAN, f32::NAN));
    assert!(!Tolerance::Exact.accepts(f32::NAN, f32::NAN));
}

#[test]
fn a_short_output() {
    let failure = tampered(&smoke_fill::KERNEL, |words| {
        words.pop();
    });
    assert!(matches!(failure, Failure::Length { .. }), "{failure}");
}

#[test]
fn a_long_output() {
    let failure = tampered(&smoke_fill::KERNEL, |words| words.push(0));
    assert!(matches!(failure, Failure::Length { .. }), "{failure}");
}

#[test]
fn outputs_of_different_length() {
    let case = ordinary(&smoke_fill::KERNEL);
    let long = run_case(&mut CpuExecutor::new(), &smoke_fill::KERNEL, &case).unwrap();
    let mut short = long.clone();
    short[0].words.pop();
    let failure = compare(&long, &short, Allowed::SameBits).unwrap_err();
    assert!(matches!(failure, Failure::Length { .. }), "{failure}");
}

#[test]
fn a_dispatch_that_did_not_run() {
    let mut exec = Tampered { skip_run: true, ..Tampered::new(|_| ()) };
    let failure = suite::same_as_cpu(&mut exec, &smoke_fill::KERNEL).expect_err("not found").failure;
    assert!(matches!(failure, Failure::Unwritten(_)), "{failure}");
}

#[test]
fn one_element_that_was_not_written() {
    fn skips_one(job: Piece<'_>) {
        let (first, uniform) = (job.first_row, bytemuck::cast_slice::<u32, SmokeParams>(job.uniform)[0]);
        for (k, word) in job.planes[0].iter_mut().enumerate() {
            let i = first + k as u32;
            if i + 1 != uniform.count {
                *word = interreflect_kernels::smoke::fill(i, &uniform);
            }
        }
    }
    let kernel = leak(Kernel { cpu: skips_one, ..smoke_fill::KERNEL });
    let failure = suite::same_as_cpu(&mut CpuExecutor::new(), kernel).expect_err("not found").failure;
    assert!(matches!(failure, Failure::Unwritten(_)), "{failure}");
}

#[test]
fn a_halo_that_was_overwritten() {
    // The rows say that the last element belongs to nobody; the body writes it all the same.
    let kernel = leak(Kernel {
        rows: |uniform, count| {
            let mut rows = (smoke_fill::KERNEL.rows)(uniform, count);
            rows.count = rows.count.saturating_sub(1);
            rows
        },
        ..smoke_fill::KERNEL
    });
    let write_all = |words: &mut Vec<u32>| change_last(words, |_| 0);
    let failure = run_case(&mut Tampered::new(write_all), kernel, &ordinary(kernel)).unwrap_err();
    assert!(matches!(failure, Failure::Overwritten(_)), "{failure}");
    // Left alone it passes.
    run_case(&mut CpuExecutor::new(), kernel, &ordinary(kernel)).unwrap();
}

#[test]
fn a_result_that_depends_on_what_was_there() {
    fn adds(job: Piece<'_>) {
        for word in job.planes[0].iter_mut() {
            *word = word.wrapping_add(1);
        }
    }
    let kernel = leak(Kernel { cpu: adds, ..smoke_fill::KERNEL });
    let failure = run_case(&mut CpuExecutor::new(), kernel, &ordinary(kernel)).unwrap_err();
    assert!(matches!(failure, Failure::DependsOnBefore(_)), "{failure}");
}

#[test]
fn lanes_that_differ_from_the_scalar_body() {
    fn one_bit_off(job: Piece<'_>) {
        let mut plane = job.planes[0].to_vec();
        (smoke_axpy::KERNEL.cpu)(Piece { planes: &mut [&mut plane], ..job });
        plane[0] ^= 1;
        job.planes[0].copy_from_slice(&plane);
    }
    let kernel = leak(Kernel { scalar: Some(one_bit_off), ..smoke_axpy::KERNEL });
    let failure = suite::same_bits_on_cpu(kernel).expect_err("not found").failure;
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
}

#[test]
fn results_that_depend_on_the_number_of_threads() {
    fn counts_threads(job: Piece<'_>) {
        job.planes[0].fill(rayon::current_num_threads() as u32);
    }
    let kernel = leak(Kernel { cpu: counts_threads, ..smoke_fill::KERNEL });
    let failure = suite::same_bits_on_cpu(kernel).expect_err("not found").failure;
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
}

#[test]
fn results_that_depend_on_the_cut_into_pieces() {
    fn counts_rows(job: Piece<'_>) {
        job.planes[0].fill(job.row_count);
    }
    let kernel = leak(Kernel { cpu: counts_rows, ..smoke_fill::KERNEL });
    let failure = suite::same_bits_on_cpu(kernel).expect_err("not found").failure;
    assert!(matches!(failure, Failure::Differs(_)), "{failure}");
}

#[test]
fn an_executor_that_returns_an_error() {
    // A case with a buffer missing.
    let mut case = ordinary(&smoke_fill::KERNEL);
    case.buffers.pop();
    let failure = run_case(&mut CpuExecutor::new(), &smoke_fill::KERNEL, &case).unwrap_err();
    assert!(matches!(failure, Failure::Exec { .. }), "{failure}");
}

#[test]
fn a_case_without_output() {
    let kernel = leak(Kernel {
        case: |_| {
            let params = SmokeParams { count: 0, seed: 0, scale: 0.0, _pad: 0 };
            Case::default().uniform(&params).zeroed::<u32>(0)
        },
        ..smoke_fill::KERNEL
    });
    let failure = suite::same_as_cpu(&mut CpuExecutor::new(), kernel).expect_err("nothing was compared").failure;
    assert_eq!(failure, Failure::NothingCompared);
}

#[test]
fn an_empty_table() {
    assert_eq!(suite::kernels(&[]).err(), Some(Failure::EmptyTable));
    assert_eq!(suite::kernels(&[&[], &[]]).err(), Some(Failure::EmptyTable));
}

#[test]
fn a_kernel_that_is_in_the_table_twice() {
    let family: &[&'static Kernel] = &[&smoke_fill::KERNEL];
    assert_eq!(suite::kernels(&[family, family]).err(), Some(Failure::TwiceInTable("smoke_fill")));
}

#[test]
fn a_missing_adapter() {
    let missing = || -> Result<(), _> {
        Err(ExecError::NoAdapter { wanted: "GPU".into(), reason: "this machine has none".into() })
    };
    assert_eq!(availability(&missing(), false), Availability::Ignored);
    assert!(matches!(availability(&missing(), true), Availability::Failed(Failure::NoAdapter(_))));
}

#[test]
fn a_broken_adapter_is_never_ignored() {
    let broken = || -> Result<(), _> {
        Err(ExecError::BrokenDevice { adapter: "x".into(), reason: "the canary is dead".into() })
    };
    assert!(matches!(availability(&broken(), false), Availability::Failed(Failure::Exec { .. })));
    assert!(matches!(availability(&broken(), true), Availability::Failed(Failure::Exec { .. })));
}

/// Set in the process that [`a_machine_without_driver`] starts.
const CHILD: &str = "INTERREFLECT_TEST_CHILD";

/// The whole way on a machine without driver: this test again, in a process that finds none.
#[test]
fn a_machine_without_driver() {
    if std::env::var_os(CHILD).is_some() {
        println!("{:?}", interreflect_tests::gpu::shared_availability(interreflect::exec::SpirvPath::Naga));
        return;
    }
    for (required, expected) in [("0", "Ignored"), ("1", "Failed(NoAdapter")] {
        let output = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "a_machine_without_driver", "--nocapture"])
            .env(CHILD, "1")
            .env(interreflect_tests::gpu::REQUIRE_GPU, required)
            // Names of the Vulkan loader's lists of drivers, new and old.
            .env("VK_DRIVER_FILES", "/nonexistent.json")
            .env("VK_ICD_FILENAMES", "/nonexistent.json")
            .output()
            .unwrap();
        let text = String::from_utf8_lossy(&output.stdout);
        assert!(cfg!(not(target_os = "linux")) || text.contains(expected), "{required}: {text}");
    }
}
