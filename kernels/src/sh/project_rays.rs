//! Projection of radiance in each element's own directions: `c_ek = weight · Σ_s Y_k(d_es) L_es`.
//!
//! One invocation: four coefficients of three channels of one element; the basis functions are computed, not read. Grid:
//! elements × blocks. Good when directions differ between elements (rays jittered per probe, photons, receivers with
//! their own hemispheres); with shared directions [`super::project`] is several times faster. Samples without light
//! (radiance 0) may have any finite direction. After: [`super::filter`], [`super::irradiance`].

use super::{block_functions, block_rows, load3, tile_and_block};
use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::sh::{SH_TILE, ShLayout, ShParams};

/// One row per tile and block.
pub fn rows(p: &ShParams) -> Rows {
    block_rows(&ShLayout::new(p.element_count, p.order))
}

/// Four coefficients of three channels: value `4·channel + j`. Unit `directions` and `radiance` as
/// [`ShLayout::sample`] says.
#[inline(always)]
pub fn coefficients<R: Real>(at: At, p: &ShParams, directions: &[f32], radiance: &[f32]) -> [R; 12] {
    let layout = ShLayout::new(p.element_count, p.order);
    let (tile, block) = tile_and_block(at, &layout);
    let first = ShLayout::sample(tile * SH_TILE, 0, 0, p.sample_count) + at.x as usize;
    let functions = block_functions(block, p.order);
    let mut sum = [R::splat(0.0); 12];
    for s in 0..p.sample_count as usize {
        let i = first + s * 3 * SH_TILE as usize;
        let (direction, light): ([R; 3], [R; 3]) = (load3(directions, i), load3(radiance, i));
        unroll!(J in 0, 1, 2, 3 => {
            let y = functions[J].value(direction);
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
    let sample_count = super::case_samples(input, 16);
    let order = super::case_order(input);
    let weight = 4.0 * crate::math::float::PI / sample_count as f32;
    let p = ShParams { element_count: input.count as u32, sample_count, order, weight };
    let layout = ShLayout::new(p.element_count, order);
    let mut directions = alloc::vec![0.0; layout.samples_len(sample_count)];
    for i in 0..layout.padded_elements() * sample_count {
        let (element, sample) = (i / sample_count, i % sample_count);
        // Huge radiance goes with a direction in which no function is near a zero: only there are errors relative.
        let axis = if input.flavour == crate::kernel::Flavour::Huge { Some(glam::Vec3::Z) } else { None };
        let d = axis.unwrap_or_else(|| input.direction()).to_array();
        (0..3).for_each(|a| directions[ShLayout::sample(element, sample, a, sample_count)] = d[a as usize]);
    }
    let radiance = super::case_radiance(input, &layout, sample_count);
    Case::default().uniform(&p).read(&directions).read(&radiance).zeroed::<f32>(layout.len())
}

kernel! {
    /// Samples in directions of each element's own to coefficients.
    lanes mod sh_project_rays = super::coefficients; entry "sh_project_rays" threads(64);
    uniform 0 params: ShParams;
    read 1 directions: f32;
    read 2 radiance: f32;
    write 3 coefs: f32 x 12;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(1e-5, 4e-5), "recurrences of up to 9 steps and up to 16 additions that may cancel, times 4π/count; a device may fuse each";
}
