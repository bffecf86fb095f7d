//! Global-illumination kernels, each written once: SPIR-V through rust-gpu and plain CPU functions.
//!
//! [`kernel`] is the declaration language, [`real`] the numbers of lane-generic bodies, [`math`] and [`trace`] what
//! every method may use. [`ALL`] lists every kernel with its test case.
#![cfg_attr(any(target_arch = "spirv", not(feature = "std")), no_std)]

#[cfg(not(target_arch = "spirv"))]
extern crate alloc;

#[macro_use]
pub mod real;
#[macro_use]
pub mod kernel;
#[cfg(not(target_arch = "spirv"))]
pub mod compiled;
pub mod cone;
pub mod lpv;
pub mod math;
pub mod sh;
pub mod smoke;
pub mod srp;
pub mod trace;
pub mod voxel;

/// Every kernel: the table that executors, tests, benchmarks and the manifest run over.
#[cfg(not(target_arch = "spirv"))]
pub const ALL: &[&[&kernel::Kernel]] =
    &[smoke::KERNELS, trace::KERNELS, sh::KERNELS, voxel::KERNELS, cone::KERNELS, srp::KERNELS, lpv::KERNELS];

/// Every kernel, flattened in table order.
#[cfg(not(target_arch = "spirv"))]
pub fn all() -> impl Iterator<Item = &'static kernel::Kernel> {
    ALL.iter().flat_map(|family| family.iter().copied())
}
