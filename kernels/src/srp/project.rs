//! Projection of the relight rays' radiance to spherical harmonics: `λ_k = Σ_ray Y_k(ray) L(ray)`, a matrix product.
//!
//! One invocation: eight coefficients of three channels of one probe, over one slice of the rays. Grid: slices × tiles of
//! 16 probes × blocks of coefficients. Silvennoinen & Lehtinen 2017, §4.2 (eq. 3 with precomputed basis functions).
//! [`crate::sh::project`] does the same for samples in whole; here the product is blocked: per ray a vector of probes
//! loads three words and eight numbers of the table for 24 multiply-adds, a slice of the table (128 KiB at order 7) and of
//! a tile's light (192 KiB) stay in a processor's cache while all blocks are computed, and slices give a device enough
//! invocations. Before: [`super::gather`]; after: [`super::probe_sum`].

use crate::kernel::{At, Rows, fetch};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::srp::{SRP_BLOCK, SRP_LANES, SrpLayout, SrpProbeParams};

/// One row per slice of this dispatch, tile and block.
pub fn rows(p: &SrpProbeParams) -> Rows {
    let layout = SrpLayout::new(p);
    let slice_rows = layout.tiles * layout.blocks;
    Rows {
        count: p.slice_count * slice_rows,
        len: SRP_LANES,
        pitch: SRP_LANES,
        first: p.first_slice * slice_rows * SRP_LANES,
        plane: layout.partial_rows() * SRP_LANES,
    }
}

/// Eight coefficients of three channels: value `8·channel + j`, to be stored as [`SrpLayout::partial`] says. `table` as
/// [`SrpLayout::table`], `light` as `srp_gather` leaves it.
#[inline(always)]
pub fn coefficients<R: Real>(at: At, p: &SrpProbeParams, table: &[f32], light: &[f32]) -> [R; 24] {
    let layout = SrpLayout::new(p);
    let slice_tile = at.row / layout.blocks;
    let block = at.row - slice_tile * layout.blocks;
    let slice = slice_tile / layout.tiles;
    let plane = (layout.slice_plane() * p.slice_count) as usize;
    let mut i = (slice_tile * layout.slice_rays * SRP_LANES + at.x) as usize;
    let mut y = layout.table(block * SRP_BLOCK, (p.first_slice + slice) * layout.slice_rays);
    let mut sum = [R::splat(0.0); 24];
    for _ in 0..layout.slice_rays {
        let red = R::load(light, i);
        let green = R::load(light, plane + i);
        let blue = R::load(light, 2 * plane + i);
        unroll!(J in 0, 1, 2, 3, 4, 5, 6, 7 => {
            let y = R::splat(*fetch(table, y + J));
            sum[J] = sum[J] + red * y;
            sum[8 + J] = sum[8 + J] + green * y;
            sum[16 + J] = sum[16 + J] + blue * y;
        });
        i += SRP_LANES as usize;
        y += SRP_BLOCK as usize;
    }
    sum
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let p = super::case_probes(input, input.count as u32 / 8);
    let layout = SrpLayout::new(&p);
    let table: alloc::vec::Vec<f32> = (0..layout.table_len()).map(|_| super::case_factor(input)).collect();
    let light = super::case_floats(input, (3 * layout.slice_plane() * p.slice_count) as usize);
    let len = 24 * (layout.partial_rows() * SRP_LANES) as usize;
    Case::default().uniform(&p).read(&table).read(&light).zeroed::<f32>(len)
}

kernel! {
    /// Radiance along relight rays to partial coefficients of probes.
    lanes mod srp_project = super::coefficients; entry "srp_project" threads(64);
    uniform 0 params: SrpProbeParams;
    read 1 table: f32;
    read 2 light: f32;
    write 3 partial: f32 x 24;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(4e-6, 4e-6), "16 multiply-adds of numbers below 1 that may cancel; a device may fuse each";
}
