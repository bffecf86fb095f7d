//! Spherical harmonics of many elements at once: samples to coefficients, filters, coefficients to irradiance.
//!
//! Orders 0 to 9 by a parameter. An **element** is whatever has its own expansion: a probe, a cell, a receiver. Coefficients
//! follow the convention of [`crate::math::sh`] and the layout of [`ShLayout`]: elements in tiles of 64, coefficients in
//! blocks of four; an invocation owns one block of one element for three colour channels. So one kernel serves every
//! order with little padding (order 9: none), neighbouring invocations touch neighbouring words, and a tile's samples stay
//! in a CPU's cache while all its blocks are computed.
//!
//! - [`basis`]: directions to a table of basis functions, once per set of directions.
//! - [`project`]: radiance in directions that all elements share, a matrix product with that table.
//! - [`project_rays`]: radiance in directions of each element's own.
//! - [`filter`]: band factors: convolution with a lobe, windowing.
//! - [`irradiance`]: one normal per element.
//!
//! Good when light varies slowly with direction (diffuse receivers: order 2 has an error of 1 % for distant light); fails
//! for sharp light, where expansions ring: window them ([`crate::math::sh`]). Sources: Ramamoorthi & Hanrahan 2001, "An
//! Efficient Representation for Irradiance Environment Maps"; Sloan, Kautz & Snyder 2002, "Precomputed Radiance Transfer".
//!
//! Pass order: `sh_basis` → `sh_project` (or `sh_project_rays` alone) → `sh_filter` where wanted → `sh_irradiance`.

use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{CaseInput, Flavour, Kernel};
use crate::math::sh::Function;
use crate::real::Real;
use interreflect_shared::sh::{SH_BLOCK, SH_TILE, ShLayout};

pub mod basis;
pub mod filter;
pub mod irradiance;
pub mod project;
pub mod project_rays;

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&Kernel] = &[
    &basis::sh_basis::KERNEL,
    &project::sh_project::KERNEL,
    &project_rays::sh_project_rays::KERNEL,
    &filter::sh_filter::KERNEL,
    &irradiance::sh_irradiance::KERNEL,
];

/// One row per tile and block of coefficients.
#[inline(always)]
fn block_rows(layout: &ShLayout) -> Rows {
    Rows { count: layout.tiles * layout.blocks, len: SH_TILE, pitch: SH_TILE, first: 0, plane: layout.plane() }
}
/// Tile and block of a row of [`block_rows`].
#[inline(always)]
fn tile_and_block(at: At, layout: &ShLayout) -> (u32, u32) {
    let tile = at.row / layout.blocks;
    (tile, at.row - tile * layout.blocks)
}
/// Three components of one sample, from index `i` on: the layout of [`ShLayout::sample`].
#[inline(always)]
fn load3<R: Real>(samples: &[f32], i: usize) -> [R; 3] {
    let tile = SH_TILE as usize;
    [R::load(samples, i), R::load(samples, i + tile), R::load(samples, i + 2 * tile)]
}
/// The four basis functions of a block.
#[inline(always)]
fn block_functions(block: u32, order: u32) -> [Function; 4] {
    let k = block * SH_BLOCK;
    [Function::new(k, order), Function::new(k + 1, order), Function::new(k + 2, order), Function::new(k + 3, order)]
}

/// Order of a test case.
#[cfg(not(target_arch = "spirv"))]
fn case_order(input: &mut CaseInput) -> u32 {
    input.bits() % 10
}
/// Samples of a test case: up to `most`, in a large case as many as a probe has rays.
#[cfg(not(target_arch = "spirv"))]
fn case_samples(input: &mut CaseInput, most: u32) -> u32 {
    let any = 1 + input.bits() % most;
    if input.is_large() { 256 } else { any }
}
/// Radiance samples of a test case. Huge ones stand alone in their element: a sum of huge terms that cancel has no digit
/// in common with the same sum under a device's rounding.
#[cfg(not(target_arch = "spirv"))]
fn case_radiance(input: &mut CaseInput, layout: &ShLayout, sample_count: u32) -> alloc::vec::Vec<f32> {
    let mut radiance = input.floats(layout.samples_len(sample_count));
    if input.flavour == Flavour::Huge {
        for element in 0..layout.padded_elements() {
            for sample in (0..sample_count).filter(|s| *s != element % sample_count) {
                for channel in 0..3 {
                    radiance[ShLayout::sample(element, sample, channel, sample_count)] = 0.0;
                }
            }
        }
    }
    radiance
}

#[cfg(test)]
mod tests;
