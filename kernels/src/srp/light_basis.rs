//! The lanes of [`super::cluster`] to components of each cluster's light basis.
//!
//! One invocation: one component, three channels (w = 0). Grid: components of all clusters. Clusters that are not compressed
//! have probe coefficients themselves for components. Before: [`super::cluster`]; after: [`super::reconstruct`].

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use glam::Vec4;
use interreflect_shared::srp::{SRP_IDENTITY, SRP_LANES, SRP_RANKS, SrpBasisParams, SrpBasisSource};

/// Components.
pub fn components(p: &SrpBasisParams) -> Rows {
    Rows::all(p.count)
}

/// Component `i`. `partial` as `srp_cluster` writes it, `coefs`: λ in planes `[channel]`.
#[inline(always)]
pub fn component(i: u32, p: &SrpBasisParams, sources: &[SrpBasisSource], partial: &[f32], coefs: &[f32]) -> Vec4 {
    let SrpBasisSource { source, scale } = sources[i as usize];
    if source & SRP_IDENTITY != 0 {
        let at = (source & !SRP_IDENTITY) as usize;
        let plane = p.coef_plane as usize;
        return Vec4::new(coefs[at], coefs[plane + at], coefs[2 * plane + at], 0.0) * scale;
    }
    let (pair, rank) = (source / SRP_RANKS, source % SRP_RANKS);
    let plane = p.pair_count * SRP_LANES;
    let first = ((rank * 3) * plane + pair * SRP_LANES) as usize;
    let plane = plane as usize;
    let (mut red, mut green, mut blue) = (0.0, 0.0, 0.0);
    unroll!(LANE in 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15 => {
        red += partial[first + LANE];
        green += partial[first + plane + LANE];
        blue += partial[first + 2 * plane + LANE];
    });
    Vec4::new(red, green, blue, 0.0) * scale
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let count = input.count as u32;
    let pair_count = 1 + count / 4;
    let coef_plane = 100;
    let p = SrpBasisParams { count, pair_count, coef_plane, _pad0: 0 };
    let source = |input: &mut CaseInput| {
        let identity = input.bits().is_multiple_of(3);
        let source = if identity { SRP_IDENTITY | (input.bits() % 100) } else { input.bits() % (2 * pair_count) };
        SrpBasisSource { source, scale: 0.25 + input.unit() }
    };
    let sources: alloc::vec::Vec<SrpBasisSource> = (0..count).map(|_| source(input)).collect();
    let partial = super::case_floats(input, (6 * pair_count * SRP_LANES) as usize);
    let coefs = super::case_floats(input, 300);
    Case::default().uniform(&p).read(&sources).read(&partial).read(&coefs).zeroed::<Vec4>(input.count)
}

kernel! {
    /// Sixteenths of light-basis components to components.
    mod srp_light_basis = super::component; entry "srp_light_basis" threads(64);
    uniform 0 params: SrpBasisParams;
    read 1 sources: SrpBasisSource;
    read 2 partial: f32;
    read 3 coefs: f32;
    write 4 basis: Vec4;
    over super::components;
    case super::case; tolerance Tolerance::RelAbs(2e-6, 4e-6), "16 additions of numbers below 1 that may cancel, in the same order everywhere, and a multiplication that a device may fuse";
}
