//! Adapters of this machine, opened once and shared by all tests.

use crate::failure::Failure;
use interreflect::exec::{ExecError, GpuExecutor, GpuOptions, SpirvPath};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

/// Set to 1 where a missing adapter must fail the tests; otherwise they are reported as ignored.
pub const REQUIRE_GPU: &str = "INTERREFLECT_REQUIRE_GPU";

/// Both ways of a kernel to the driver.
pub const SPIRV_PATHS: [SpirvPath; 2] = [SpirvPath::Passthrough, SpirvPath::Naga];

/// Name of a way in the names of tests.
pub fn path_name(path: SpirvPath) -> &'static str {
    match path {
        SpirvPath::Passthrough => "passthrough",
        SpirvPath::Naga => "naga",
    }
}

/// Whether tests on an adapter can run.
#[derive(Debug, PartialEq)]
pub enum Availability {
    /// There is one.
    Here,
    /// There is none and none is required: such tests are reported as ignored.
    Ignored,
    /// There is none and one is required, or it is there and broken.
    Failed(Failure),
}

/// What the attempt to open an adapter means for the tests.
pub fn availability<T>(opened: &Result<T, ExecError>, required: bool) -> Availability {
    match opened {
        Ok(_) => Availability::Here,
        Err(ExecError::NoAdapter { .. }) if !required => Availability::Ignored,
        Err(error @ ExecError::NoAdapter { .. }) => Availability::Failed(Failure::NoAdapter(error.to_string())),
        Err(error) => Availability::Failed(Failure::Exec { executor: "gpu".into(), error: error.to_string() }),
    }
}

/// Whether [`REQUIRE_GPU`] is set.
pub fn required() -> bool {
    std::env::var_os(REQUIRE_GPU).is_some_and(|value| value != "0" && !value.is_empty())
}

/// An adapter of its own for a test that breaks it.
///
/// # Errors
/// As [`GpuExecutor::open`].
pub fn open(path: SpirvPath) -> Result<GpuExecutor, ExecError> {
    GpuExecutor::open(&GpuOptions { spirv: Some(path), ..GpuOptions::default() })
}

type Shared = Result<Mutex<GpuExecutor>, ExecError>;

fn shared(path: SpirvPath) -> &'static Shared {
    static PASSTHROUGH: OnceLock<Shared> = OnceLock::new();
    static NAGA: OnceLock<Shared> = OnceLock::new();
    let slot = match path {
        SpirvPath::Passthrough => &PASSTHROUGH,
        SpirvPath::Naga => &NAGA,
    };
    slot.get_or_init(|| open(path).map(Mutex::new))
}

/// Whether the shared adapter can be used.
pub fn shared_availability(path: SpirvPath) -> Availability {
    availability(shared(path), required())
}

/// The shared adapter, for one test at a time.
///
/// # Errors
/// [`Failure`] where there is none or it does not work.
pub fn lock(path: SpirvPath) -> Result<MutexGuard<'static, GpuExecutor>, Failure> {
    match shared(path) {
        Ok(executor) => Ok(executor.lock().unwrap_or_else(PoisonError::into_inner)),
        Err(error) => Err(Failure::NoAdapter(error.to_string())),
    }
}
