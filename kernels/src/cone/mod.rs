//! Cone tracing in the voxel pyramid: diffuse gathering, light's further bounces, glossy reflection.
//!
//! **Paper.** Crassin, Neyret, Sainz, Green & Eisemann 2011, "Interactive Indirect Illumination Using Voxel Cone Tracing",
//! §7. Deviations: exact weights ([`set`]) and the law of opacity ([`march`]).
//!
//! **Indirect light only.** Facets' radiance holds what they reflect, not what they emit, and cones that leave the grid find
//! nothing, so that lamps and sky, which light receivers directly, are not counted twice.
//!
//! **Good when** light is smooth: large lit surfaces, soft occlusion. **Fails when** a small bright spot lights its
//! neighbourhood (cones of 30° and more miss or smear it), and nearer than a voxel or two.
//!
//! **Passes**: `voxel_mip` → `cone_bounce` → `voxel_radiate` → `voxel_mip_base` … per bounce, then [`gather`]
//! (`cone_gather`) and [`glossy`] (`cone_glossy`) per frame.

#[cfg(not(target_arch = "spirv"))]
pub mod case;
pub mod gather;
pub mod glossy;
pub mod march;
pub mod query;
#[cfg(not(target_arch = "spirv"))]
pub mod set;

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&crate::kernel::Kernel] =
    &[&gather::cone_gather::KERNEL, &gather::cone_bounce::KERNEL, &glossy::cone_glossy::KERNEL];
