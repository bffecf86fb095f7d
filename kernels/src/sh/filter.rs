//! Band factors: every coefficient times the factor of its band.
//!
//! One invocation: four coefficients of three channels of one element. Grid: elements × blocks. The factors are a
//! convolution with a zonal kernel (clamped cosine, Phong lobe, cone), a window against ringing, or their product; all are
//! in [`crate::math::sh`]. Bound by bandwidth: fold a filter into the next pass where that is possible. Before:
//! [`super::project`]; after: [`super::irradiance`].

use super::{block_rows, tile_and_block};
use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::sh::{SH_BLOCK, ShFilterParams, ShLayout};

/// One row per tile and block.
pub fn rows(p: &ShFilterParams) -> Rows {
    block_rows(&ShLayout::new(p.element_count, p.order))
}

/// Factor of the band of coefficient `k`. Comparisons instead of an index, for which a device would copy the table.
#[inline(always)]
fn factor_of(k: u32, p: &ShFilterParams) -> f32 {
    let mut factor = p.factors[0].x;
    unroll!(L in 1, 2, 3, 4, 5, 6, 7, 8, 9 => {
        if k >= (L * L) as u32 {
            let v = p.factors[L / 4];
            factor = match L % 4 { 0 => v.x, 1 => v.y, 2 => v.z, _ => v.w };
        }
    });
    factor
}

/// Four coefficients of three channels: value `4·channel + j`.
#[inline(always)]
pub fn filtered<R: Real>(at: At, p: &ShFilterParams, coefs: &[f32]) -> [R; 12] {
    let layout = ShLayout::new(p.element_count, p.order);
    let (_, block) = tile_and_block(at, &layout);
    let plane = layout.plane() as usize;
    let mut out = [R::splat(0.0); 12];
    unroll!(J in 0, 1, 2, 3 => {
        let factor = R::splat(factor_of(block * SH_BLOCK + J as u32, p));
        out[J] = R::load(coefs, J * plane + at.i) * factor;
        out[4 + J] = R::load(coefs, (4 + J) * plane + at.i) * factor;
        out[8 + J] = R::load(coefs, (8 + J) * plane + at.i) * factor;
    });
    out
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let order = super::case_order(input);
    let factors = core::array::from_fn(|_| input.unit() * 2.0 - 1.0);
    let p = ShFilterParams::new(input.count as u32, order, &factors);
    let len = ShLayout::new(p.element_count, order).len();
    Case::default().uniform(&p).read(&input.floats(len)).zeroed::<f32>(len)
}

kernel! {
    /// Coefficients times their bands' factors.
    lanes mod sh_filter = super::filtered; entry "sh_filter" threads(64);
    uniform 0 params: ShFilterParams;
    read 1 coefs: f32;
    write 2 out: f32 x 12;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(1e-6, 1e-37), "one multiplication; a device may flush denormals";
}
