//! The radiance that every relight ray meets, by the index of what it meets.
//!
//! One invocation: three channels of one ray of one probe. Grid: slices × tiles of 16 probes × rays × probes of the tile, in the
//! order in which [`super::project`] reads. Silvennoinen & Lehtinen 2017, §4.2: "consult the current radiance at the
//! appropriate uv coordinates". Rays that miss and rays that meet backs read a special slot: no branch. A receiver's
//! channels lie in one cache line; bound by the latency of reads at random places. Before: [`super::relight`].

use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::srp::{SRP_LANES, SrpLayout, SrpProbeParams};

/// One row per sixteen rays of a tile.
pub fn rows(p: &SrpProbeParams) -> Rows {
    let len = SRP_LANES * SRP_LANES;
    let plane = SrpLayout::new(p).slice_plane() * p.slice_count;
    Rows { count: plane / len, len, pitch: len, first: 0, plane }
}

/// Light of the dispatch's slices in planes `[channel]`, from `hits` (slots, as [`SrpLayout::ray`] says) and `radiance`
/// (four floats per slot).
#[inline(always)]
pub fn light<R: Real>(at: At, p: &SrpProbeParams, hits: &[u32], radiance: &[f32]) -> [R; 3] {
    R::gather3(radiance, hits, (p.first_slice * SrpLayout::new(p).slice_plane()) as usize + at.i)
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let p = super::case_probes(input, input.count as u32 / 64);
    let layout = SrpLayout::new(&p);
    let slots = 1 + input.bits() % 1000;
    let hits: alloc::vec::Vec<u32> = (0..layout.slices * layout.slice_plane()).map(|_| input.bits() % slots).collect();
    let radiance = input.floats(4 * slots as usize);
    let len = (3 * layout.slice_plane() * p.slice_count) as usize;
    Case::default().uniform(&p).read(&hits).read(&radiance).zeroed::<f32>(len)
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
