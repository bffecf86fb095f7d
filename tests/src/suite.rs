//! The cases of a kernel and the checks over them, and tests made from the kernel table.

use crate::compare::{Allowed, Output, compare};
use crate::failure::Failure;
use crate::gpu::{self, Availability};
use crate::run::run_case;
use interreflect::exec::{CpuExecutor, Executor, SpirvPath};
use interreflect_kernels::kernel::{Case, CaseInput, Flavour, Kernel};
use libtest_mimic::Trial;

/// What a case is made from.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// Seed.
    pub seed: u32,
    /// Elements.
    pub count: usize,
    /// Character of the numbers.
    pub flavour: Flavour,
}

impl Request {
    /// The case that a kernel makes of it.
    pub fn case(self, kernel: &Kernel) -> Case {
        (kernel.case)(&mut CaseInput::new(self.seed, self.count, self.flavour))
    }
}

/// Elements of the large case: many workgroups, the last one not full.
const MANY: usize = 2999;
/// Elements that the CPU cuts in another way for each number of threads.
const MANY_PIECES: usize = 9001;
/// Seeds of ordinary numbers.
const SEEDS: [u32; 3] = [1, 2, 3];

/// Every case that a kernel is tested with: no element, one, a workgroup less one, exactly, and one more, and many;
/// ordinary numbers under several seeds, zeros, denormals and huge numbers.
pub fn requests(kernel: &Kernel) -> Vec<Request> {
    let workgroup = kernel.desc.workgroup_size as usize;
    let mut requests = Vec::new();
    for count in [0, 1, workgroup - 1, workgroup, workgroup + 1, MANY] {
        requests.extend(SEEDS.map(|seed| Request { seed, count, flavour: Flavour::Ordinary }));
        let others = [Flavour::Zero, Flavour::Tiny, Flavour::Huge];
        requests.extend(others.map(|flavour| Request { seed: 4, count, flavour }));
    }
    requests
}

/// A failure and the case that showed it.
#[derive(Debug)]
pub struct CaseFailure {
    /// The case.
    pub request: Option<Request>,
    /// What is wrong.
    pub failure: Failure,
}

impl std::fmt::Display for CaseFailure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.request {
            Some(Request { seed, count, flavour }) => {
                write!(f, "{} (case: seed {seed}, count {count}, {flavour:?})", self.failure)
            }
            None => self.failure.fmt(f),
        }
    }
}

impl From<Failure> for CaseFailure {
    fn from(failure: Failure) -> Self {
        Self { request: None, failure }
    }
}

/// Runs `check` on the requested cases of a kernel; it gives the number of words that it compared.
///
/// # Errors
/// The first failure; [`Failure::NothingCompared`] where no case has an output.
pub fn for_each_case(
    kernel: &Kernel,
    requests: &[Request],
    mut check: impl FnMut(&Case) -> Result<usize, Failure>,
) -> Result<(), CaseFailure> {
    let mut compared = 0;
    for &request in requests {
        let case = request.case(kernel);
        compared += check(&case).map_err(|failure| CaseFailure { request: Some(request), failure })?;
    }
    if compared == 0 { Err(Failure::NothingCompared.into()) } else { Ok(()) }
}

/// The kernel on an executor gives what it gives on the CPU, within the declared tolerance.
///
/// # Errors
/// The first failure on either of them.
pub fn same_as_cpu(exec: &mut dyn Executor, kernel: &'static Kernel) -> Result<(), CaseFailure> {
    for_each_case(kernel, &requests(kernel), |case| {
        let expected = run_case(&mut CpuExecutor::new(), kernel, case)?;
        compare(&expected, &run_case(exec, kernel, case)?, Allowed::declared(kernel))
    })
}

/// Threads of the pools that must give the same bits.
const THREADS: [usize; 3] = [1, 2, 5];

/// The kernel on the CPU gives the same bits whatever the number of threads, and with lanes as without.
///
/// # Errors
/// The first failure.
pub fn same_bits_on_cpu(kernel: &'static Kernel) -> Result<(), CaseFailure> {
    let pools = THREADS.map(|threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build());
    // The table's row with the scalar body in the place of the other: executors know no difference.
    let scalar: Option<&'static Kernel> =
        kernel.scalar.map(|cpu| &*Box::leak(Box::new(Kernel { cpu, scalar: None, ..*kernel })));
    let mut requests = requests(kernel);
    requests.push(Request { seed: 5, count: MANY_PIECES, flavour: Flavour::Ordinary });
    for_each_case(kernel, &requests, |case| {
        let mut outputs: Vec<Vec<Output>> = Vec::new();
        for pool in &pools {
            let pool = pool.as_ref().map_err(|e| Failure::Exec { executor: "cpu".into(), error: e.to_string() })?;
            outputs.push(pool.install(|| run_case(&mut CpuExecutor::new(), kernel, case))?);
        }
        if let Some(scalar) = scalar {
            outputs.push(run_case(&mut CpuExecutor::new(), scalar, case)?);
        }
        let mut compared = 0;
        for other in &outputs[1..] {
            compared += compare(&outputs[0], other, Allowed::SameBits)?;
        }
        Ok(compared)
    })
}

/// The kernels of a table.
///
/// # Errors
/// [`Failure::EmptyTable`], [`Failure::TwiceInTable`].
pub fn kernels(table: &[&[&'static Kernel]]) -> Result<Vec<&'static Kernel>, Failure> {
    let all: Vec<&'static Kernel> = table.iter().flat_map(|family| family.iter().copied()).collect();
    if all.is_empty() {
        return Err(Failure::EmptyTable);
    }
    for (k, kernel) in all.iter().enumerate() {
        if all[..k].iter().any(|other| other.desc.name == kernel.desc.name) {
            return Err(Failure::TwiceInTable(kernel.desc.name));
        }
    }
    Ok(all)
}

/// A test on an adapter: ignored where there is none, failed where there must be one.
pub fn gpu_trial(
    name: String,
    path: SpirvPath,
    test: impl FnOnce() -> Result<(), libtest_mimic::Failed> + Send + 'static,
) -> Trial {
    match gpu::shared_availability(path) {
        Availability::Here => Trial::test(name, test),
        Availability::Ignored => Trial::test(name, || Err("no adapter".into())).with_ignored_flag(true),
        Availability::Failed(failure) => Trial::test(name, move || Err(failure.into())),
    }
}
