//! Projection of radiance in shared directions: `c_ek = weight · Σ_s table_ks L_es`, a matrix product.
//!
//! One invocation: four coefficients of three channels of one element. Grid: elements × blocks. Paper: the relighting
//! step of sparse radiance probes (Silvennoinen & Lehtinen 2017), whose table of basis functions per ray this is.
//! Good when all elements look in the same directions (probes with one ray set); otherwise [`super::project_rays`]. Per
//! sample a vector of elements loads three words and does twelve multiply-adds, so that the arithmetic binds. Before:
//! [`super::basis`]; after: [`super::filter`], [`super::irradiance`].

use super::{block_rows, load3, tile_and_block};
use crate::kernel::{At, Rows, fetch};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::sh::{SH_TILE, ShLayout, ShParams};

/// One row per tile and block.
pub fn rows(p: &ShParams) -> Rows {
    block_rows(&ShLayout::new(p.element_count, p.order))
}

/// Four coefficients of three channels: value `4·channel + j`. `table` from `sh_basis` with the same samples and order,
/// `radiance` as [`ShLayout::sample`] says.
#[inline(always)]
pub fn coefficients<R: Real>(at: At, p: &ShParams, table: &[f32], radiance: &[f32]) -> [R; 12] {
    let layout = ShLayout::new(p.element_count, p.order);
    let (tile, block) = tile_and_block(at, &layout);
    let samples = p.sample_count;
    let first = ShLayout::sample(tile * SH_TILE, 0, 0, samples) + at.x as usize;
    let (row, plane) = ((block * samples) as usize, (layout.blocks * samples) as usize);
    let mut sum = [R::splat(0.0); 12];
    for s in 0..samples as usize {
        let light: [R; 3] = load3(radiance, first + s * 3 * SH_TILE as usize);
        unroll!(J in 0, 1, 2, 3 => {
            let y = R::splat(*fetch(table, J * plane + row + s));
            sum[J] = light[0].mul_add(y, sum[J]);
            sum[4 + J] = light[1].mul_add(y, sum[4 + J]);
            sum[8 + J] = light[2].mul_add(y, sum[8 + J]);
        });
    }
    let weight = R::splat(p.weight);
    unroll!(J in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 => { sum[J] = sum[J] * weight; });
    sum
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let sample_count = super::case_samples(input, 32);
    let order = super::case_order(input);
    let weight = 4.0 * crate::math::float::PI / sample_count as f32;
    let p = ShParams { element_count: input.count as u32, sample_count, order, weight };
    let layout = ShLayout::new(p.element_count, order);
    let table: alloc::vec::Vec<f32> = (0..4 * layout.blocks * sample_count).map(|_| input.unit() * 2.0 - 1.0).collect();
    let radiance = super::case_radiance(input, &layout, sample_count);
    Case::default().uniform(&p).read(&table).read(&radiance).zeroed::<f32>(layout.len())
}

kernel! {
    /// Samples in shared directions to coefficients.
    lanes mod sh_project = super::coefficients; entry "sh_project" threads(64);
    uniform 0 params: ShParams;
    read 1 table: f32;
    read 2 radiance: f32;
    write 3 coefs: f32 x 12;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(1e-6, 1e-5), "up to 32 additions of numbers below 1 that may cancel, times a weight of 4π/count; a device may fuse each";
}
