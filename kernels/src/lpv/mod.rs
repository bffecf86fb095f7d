//! Light propagation volumes: lit surfaces as light in a grid of cells, which spreads from cell to cell.
//!
//! **What.** Every light's reflective shadow map turns lit surfaces into virtual lights; a grid holds, per cell and colour channel, the flux
//! and its first moment (spherical harmonics of order 1); each step passes light to the six neighbours, less what the geometry volume between them
//! blocks; receivers read the sum of all that has passed.
//!
//! **Papers.** Kaplanyan 2009, "Light Propagation Volumes in CryEngine 3"; Kaplanyan & Dachsbacher 2010, "Cascaded Light Propagation Volumes for Real-Time Indirect
//! Illumination"; Doghramachi 2013 for voxelized scenes and the reflection grid. Where each pass deviates, its module says.
//!
//! **Good when** lights and objects move, light is diffuse and smooth, and a rough answer is enough: cost does not depend on the scene.
//! **Fails when** walls are thinner than a cell, sources are small and far, or occlusion is fine: order 1 cannot keep crossing beams apart.
//!
//! **Passes**, in order: [`rsm`]; [`block`] (facets when geometry changes, texels, opacity); [`inject`] (`lpv_inject`, `lpv_resolve`); [`propagate`] (`lpv_begin`,
//! `lpv_propagate` …, with [`ledger`] to know when to stop); [`levels`] (`lpv_restrict` and propagation on coarser grids, `lpv_prolong` back);
//! all from `lpv_resolve` to `lpv_restrict` for each stream of light; [`bounce`] for each further bounce; [`gather`] per frame.

pub mod block;
pub mod bounce;
#[cfg(not(target_arch = "spirv"))]
pub(crate) mod case;
pub mod gather;
pub mod grid;
pub mod inject;
pub mod ledger;
pub mod levels;
pub mod lobe;
pub mod propagate;
pub mod query;
pub mod rsm;

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&crate::kernel::Kernel] = &[
    &rsm::lpv_rsm::KERNEL,
    &inject::lpv_inject::KERNEL,
    &inject::lpv_resolve::KERNEL,
    &block::lpv_block_facets::KERNEL,
    &block::lpv_block_texels::KERNEL,
    &block::lpv_opacity::KERNEL,
    &propagate::lpv_begin::KERNEL,
    &propagate::lpv_propagate::KERNEL,
    &levels::lpv_restrict::KERNEL,
    &levels::lpv_prolong::KERNEL,
    &ledger::lpv_ledger::KERNEL,
    &bounce::lpv_bounce::KERNEL,
    &bounce::lpv_reflect::KERNEL,
    &gather::lpv_gather::KERNEL,
    &gather::lpv_gather_half::KERNEL,
    &gather::lpv_pack::KERNEL,
];
