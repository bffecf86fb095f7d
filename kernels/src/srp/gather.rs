//! The radiance that every relight ray meets, by the index of what it meets.
//!
//! One invocation: three channels of one ray of one probe. Grid: tiles of 16 probes × rays × probes of the tile, in the
//! order in which [`super::project`] reads. Silvennoinen & Lehtinen 2017, §4.2: "consult the current radiance at the
//! appropriate uv coordinates". Rays that miss and rays that meet backs read a special slot: no branch. A receiver's
//! channels lie in one cache line; bound by the latency of reads at random places. Before: [`super::relight`].

use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::srp::{SRP_LANES, SrpLayout, SrpProbeParams};

/// One row per tile and sixteen rays.
pub fn rows(p: &SrpProbeParams) -> Rows {
    let len = SRP_LANES * SRP_LANES;
    let plane = SrpLayout::new(p).ray_plane();
    Rows { count: plane / len, len, pitch: len, first: 0, plane }
}

/// Light in planes `[channel]` of [`SrpLayout::ray`], from `hits` (slots, in the same layout) and `radiance` (four floats
/// per slot).
#[inline(always)]
pub fn light<R: Real>(at: At, _p: &SrpProbeParams, hits: &[u32], radiance: &[f32]) -> [R; 3] {
    [
        R::gather(radiance, hits, at.i, 4, 0),
        R::gather(radiance, hits, at.i, 4, 1),
        R::gather(radiance, hits, at.i, 4, 2),
    ]
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let p = super::case_probes(input, input.count as u32 / 64);
    let layout = SrpLayout::new(&p);
    let slots = 1 + input.bits() % 1000;
    let hits: alloc::vec::Vec<u32> = (0..layout.ray_plane()).map(|_| input.bits() % slots).collect();
    let radiance = input.floats(4 * slots as usize);
    Case::default().uniform(&p).read(&hits).read(&radiance).zeroed::<f32>(3 * layout.ray_plane() as usize)
}

kernel! {
    /// Radiance of receivers to radiance along relight rays.
    lanes mod srp_gather = super::light; entry "srp_gather" threads(64);
    uniform 0 params: SrpProbeParams;
    read 1 hits: u32;
    read 2 radiance: f32;
    write 3 light: f32 x 3;
    over super::rows;
    case super::case; tolerance Tolerance::Exact, "copies";
}
