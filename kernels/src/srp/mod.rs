//! Sparse radiance probes (SRP) at run time: light at receivers → what probes see → receivers again.
//!
//! Silvennoinen & Lehtinen 2017, "Real-time Global Illumination by Precomputed Local Reconstruction from Sparse Radiance
//! Probes", §4.2; the passes also follow the implementation study cited as "003" by its §5.1–5.5. What does not depend
//! on light is precomputed: the receiver that every relight ray of every probe meets, and per cluster of receivers a
//! matrix `U (Σ Vᵀ)` that takes probe coefficients to receivers, compressed by clustered principal components.
//!
//! Passes of one update (one bounce), with the paper's symbols:
//!
//! 1. [`relight`]: radiance that leaves every receiver, `ρ/π (E_direct + E_indirect) + L_e` ("scene relight").
//! 2. [`gather`]: the radiance that every relight ray meets, by index.
//! 3. [`project`]: `λ = weight · Y L`, a matrix product, in slices of rays; [`probe_sum`] adds the slices ("probe relight").
//! 4. [`cluster`]: `Σ Vᵀ λ` per cluster, of which only columns that are not zero exist; [`light_basis`] adds its lanes
//!    ("cluster SVD projection").
//! 5. [`reconstruct`]: `U` times that, one irradiance or four coefficients per receiver ("receiver irradiance").
//! 6. [`normals`], where receivers hold four coefficients: irradiance for normals; [`resolve`]: receivers to lightmap texels with dilation, and to arbitrary points.
//!
//! Beside them: [`occlude`] when bodies move, before step 2; [`glossy`] for highlights from four coefficients; [`probe_light`]
//! for dynamic objects, after step 3. [`query`] is for other renderers.
//!
//! Further bounces: step 1 takes the irradiance of step 5 in. Matrices are half floats, unpacked in lanes.
//!
//! Good when geometry stands still and light, albedo and emission move: soft indirect light with shadows at millions of
//! receivers per second. Fails where probes are too far apart for their order (small bright secondary sources next to a
//! receiver; the paper's Fig. 12), and for moving geometry, which only blocks relight rays.

#[cfg(not(target_arch = "spirv"))]
use crate::kernel::Kernel;

pub mod cluster;
pub mod gather;
pub mod glossy;
pub mod light_basis;
pub mod normals;
pub mod occlude;
pub mod probe_light;
pub mod probe_sum;
pub mod project;
pub mod query;
pub mod reconstruct;
pub mod relight;
pub mod resolve;

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&Kernel] = &[
    &relight::srp_relight::KERNEL,
    &gather::srp_gather::KERNEL,
    &project::srp_project::KERNEL,
    &probe_sum::srp_probe_sum::KERNEL,
    &cluster::srp_cluster::KERNEL,
    &light_basis::srp_light_basis::KERNEL,
    &reconstruct::srp_reconstruct::KERNEL,
    &reconstruct::srp_reconstruct_directional::KERNEL,
    &normals::srp_receiver_irradiance::KERNEL,
    &normals::srp_normal_mapped::KERNEL,
    &resolve::srp_atlas::KERNEL,
    &resolve::srp_resolve::KERNEL,
    &glossy::srp_glossy::KERNEL,
    &occlude::srp_occlude::KERNEL,
    &occlude::srp_occlude_mesh::KERNEL,
    &probe_light::srp_probe_light::KERNEL,
];

/// Words ahead of which matrices are asked for: a page of 4 KiB, at whose end processors stop fetching ahead by themselves.
const PREFETCH_WORDS: usize = 1024;

/// Sizes of probes for a test case.
#[cfg(not(target_arch = "spirv"))]
fn case_probes(input: &mut crate::kernel::CaseInput, probe_count: u32) -> interreflect_shared::srp::SrpProbeParams {
    let order = input.bits() % 10;
    let ray_count = 1 + input.bits() % 40;
    let slices = ray_count.div_ceil(interreflect_shared::srp::SRP_LANES);
    let first_slice = input.bits() % slices;
    interreflect_shared::srp::SrpProbeParams {
        probe_count,
        ray_count,
        coefficient_count: (order + 1) * (order + 1),
        slice_rays: interreflect_shared::srp::SRP_LANES,
        weight: 0.5,
        first_slice,
        slice_count: 1 + input.bits() % (slices - first_slice),
        _pad0: 0,
    }
}
/// Numbers of a test case; huge ones of one sign, because a sum of huge terms that cancel has no digit in common with the
/// same sum under a device's rounding.
#[cfg(not(target_arch = "spirv"))]
fn case_floats(input: &mut crate::kernel::CaseInput, count: usize) -> alloc::vec::Vec<f32> {
    let mut values = input.floats(count);
    if input.flavour == crate::kernel::Flavour::Huge {
        values.iter_mut().for_each(|x| *x = x.abs());
    }
    values
}
/// Factors of a test case in (−1, 1), without sign beside huge numbers.
#[cfg(not(target_arch = "spirv"))]
fn case_factor(input: &mut crate::kernel::CaseInput) -> f32 {
    let x = input.unit();
    if input.flavour == crate::kernel::Flavour::Huge { x } else { 2.0 * x - 1.0 }
}
/// Words of half floats for a test case.
#[cfg(not(target_arch = "spirv"))]
fn case_halves(input: &mut crate::kernel::CaseInput, count: usize) -> alloc::vec::Vec<u32> {
    (0..count).map(|_| crate::math::pack::pack_f16x2_flushed(case_factor(input), case_factor(input))).collect()
}
/// Order-1 radiance in planes `[3·coefficient + channel][slot]` for a test case; where it is huge, without the bands that may
/// cancel.
#[cfg(not(target_arch = "spirv"))]
fn case_radiance4(input: &mut crate::kernel::CaseInput, slot_count: u32) -> alloc::vec::Vec<f32> {
    let mut radiance = case_floats(input, 12 * slot_count as usize);
    if input.flavour == crate::kernel::Flavour::Huge {
        radiance[3 * slot_count as usize..].fill(0.0);
    }
    radiance
}
