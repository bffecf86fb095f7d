//! Coefficients of radiance to irradiance (Ramamoorthi & Hanrahan 2001, eq. 10).
//!
//! One invocation: the irradiance (W/m²) of one element with its own unit normal, three channels. Grid: elements. The
//! clamped cosine's factors are folded in; its odd bands above the first are 0 and not read. Good for diffuse
//! receivers; where the expansion rings the result can be negative, and the consumer clamps. Before: [`super::project`] or
//! [`super::filter`].

use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Flavour, Tolerance};
use crate::math::sh::{Sink, band, clamped_cosine_factor, walk};
use crate::real::Real;
use interreflect_shared::sh::{SH_TILE, ShLayout, ShParams};

/// One row per tile.
pub fn rows(p: &ShParams) -> Rows {
    let layout = ShLayout::new(p.element_count, p.order);
    Rows { count: layout.tiles, len: SH_TILE, pitch: SH_TILE, first: 0, plane: layout.padded_elements() }
}

struct CosineTerms<'a> {
    coefs: &'a [f32],
    /// Index of coefficient 0 of the first channel.
    first: usize,
    plane: usize,
}
impl<R: Real> Sink<R> for CosineTerms<'_> {
    type Result = [R; 3];
    #[inline(always)]
    fn take<const K: usize>(&self, y: R, sum: &mut [R; 3]) {
        let factor = const { clamped_cosine_factor(band(K)) };
        if factor != 0.0 {
            let y = y * R::splat(factor);
            let i = self.first + const { K % 4 } * self.plane + const { K / 4 * SH_TILE as usize };
            sum[0] = sum[0] + R::load(self.coefs, i) * y;
            sum[1] = sum[1] + R::load(self.coefs, i + 4 * self.plane) * y;
            sum[2] = sum[2] + R::load(self.coefs, i + 8 * self.plane) * y;
        }
    }
}

/// Irradiance of three channels, times `weight`. `normals` in planes `[axis][element]`, padded to whole tiles.
#[inline(always)]
pub fn irradiance<R: Real>(at: At, p: &ShParams, coefs: &[f32], normals: &[f32]) -> [R; 3] {
    let layout = ShLayout::new(p.element_count, p.order);
    let n = layout.padded_elements() as usize;
    let normal = [R::load(normals, at.i), R::load(normals, n + at.i), R::load(normals, 2 * n + at.i)];
    let first = layout.coef(0, 0, at.row * SH_TILE) + at.x as usize;
    let terms = CosineTerms { coefs, first, plane: layout.plane() as usize };
    let mut sum = [R::splat(0.0); 3];
    walk(p.order, normal, &terms, &mut sum);
    let weight = R::splat(p.weight);
    [sum[0] * weight, sum[1] * weight, sum[2] * weight]
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let order = super::case_order(input);
    let p = ShParams { element_count: input.count as u32, sample_count: 0, order, weight: 1.0 };
    let layout = ShLayout::new(p.element_count, order);
    let mut coefs = input.floats(layout.len());
    if input.flavour == Flavour::Huge {
        // Only band 0: a sum of huge terms that cancel is different on every device.
        for i in 0..coefs.len() {
            let row = i % layout.plane() as usize / SH_TILE as usize;
            let in_band_0 = (i / layout.plane() as usize) & 3 == 0 && row.is_multiple_of(layout.blocks as usize);
            coefs[i] *= if in_band_0 { 1.0 } else { 0.0 };
        }
    }
    let n = layout.padded_elements() as usize;
    let mut normals = alloc::vec![0.0; 3 * n];
    for i in 0..n {
        let d = input.direction().to_array();
        (0..3).for_each(|axis| normals[axis * n + i] = d[axis]);
    }
    Case::default().uniform(&p).read(&coefs).read(&normals).zeroed::<f32>(3 * n)
}

kernel! {
    /// Coefficients to irradiance.
    lanes mod sh_irradiance = super::irradiance; entry "sh_irradiance" threads(64);
    uniform 0 params: ShParams;
    read 1 coefs: f32;
    read 2 normals: f32;
    write 3 irradiance: f32 x 3;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(1e-5, 1e-5), "up to 51 terms of both signs below 3 each, which a device may fuse";
}
