//! Sparse voxel pyramid: conservative voxelization, light on voxels, directional mipmaps.
//!
//! **What.** A full grid of cubic voxels over the scene in which only occupied voxels carry data: one bit per voxel and
//! kind of facet, and a rank per 32 voxels that finds the data of each. On every coarser level likewise. Addresses are
//! computed, not searched as in an octree; empty space costs one word per 32 voxels to see; and 512³ voxels of a room take
//! some hundred megabytes instead of the 13 GB of six dense grids.
//!
//! **Papers.** Crassin, Neyret, Sainz, Green & Eisemann 2011, "Interactive Indirect Illumination Using Voxel Cone
//! Tracing"; Schwarz & Seidel 2010 for the voxelization; full grids as in the thesis on voxel techniques (§4.2). Where each
//! pass deviates, its module says.
//!
//! **Good when** lighting is diffuse and detail is larger than two voxels. **Fails when** walls are thinner than a voxel and
//! both sides matter from far away, or when a scene is much larger than what is looked at.
//!
//! **Passes**, in order: [`mark`] (`voxel_tiles`, prefix sum, `voxel_mark`), [`cells`] (`voxel_union`, `voxel_coarsen` per
//! level, counts, prefix sums, `voxel_cells`, `voxel_children`), [`facet`] (`voxel_accumulate`, `voxel_resolve`), [`light`]
//! (`voxel_inject`, `voxel_radiate`), [`mip`] (`voxel_mip_base`, `voxel_mip` per level); then the cones.

#[cfg(not(target_arch = "spirv"))]
pub mod case;
pub mod cells;
pub mod facet;
pub mod grid;
pub mod light;
pub mod mark;
pub mod mip;
pub mod overlap;
pub mod query;
pub mod scan;
pub mod tile;
pub mod view;

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&crate::kernel::Kernel] = &[
    &scan::scan_sum::KERNEL,
    &scan::scan_prefix::KERNEL,
    &mark::voxel_tiles::KERNEL,
    &mark::voxel_mark::KERNEL,
    &cells::voxel_union::KERNEL,
    &cells::voxel_coarsen::KERNEL,
    &cells::voxel_facet_count::KERNEL,
    &cells::voxel_popcount::KERNEL,
    &cells::voxel_cells::KERNEL,
    &cells::voxel_children::KERNEL,
    &facet::voxel_accumulate::KERNEL,
    &facet::voxel_resolve::KERNEL,
    &light::voxel_inject::KERNEL,
    &light::voxel_radiate::KERNEL,
    &mip::voxel_mip_base::KERNEL,
    &mip::voxel_mip_base_isotropic::KERNEL,
    &mip::voxel_mip::KERNEL,
    &mip::voxel_mip_isotropic::KERNEL,
];
