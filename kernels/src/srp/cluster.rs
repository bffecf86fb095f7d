//! Cluster projection: every cluster's `Σ Vᵀ λ`, without the columns that are zero.
//!
//! One invocation: two ranks of one cluster, three channels, over every sixteenth column. Grid: pairs of ranks × 16.
//! Silvennoinen & Lehtinen 2017, §4.1 "Compression" and §4.2. The matrices are by far the largest thing that run time
//! reads, once per update: the kernel is bound by bandwidth. Columns come in blocks of 16 neighbouring probe coefficients
//! that start anywhere, so that vectors load without indices; probes that lie next to each other in memory share blocks
//! where their coefficients are no multiple of 16. Lanes hold columns and not ranks, because a cluster has hundreds of the
//! first and few of the second; [`super::light_basis`] adds them up. Before: [`super::probe_sum`].

use super::PREFETCH_WORDS;
use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::srp::{SRP_LANES, SrpRankPair, SrpTransportParams};

/// One row per pair of ranks of this dispatch.
pub fn rows(p: &SrpTransportParams) -> Rows {
    let (first, plane) = (p.first_row * SRP_LANES, p.total_rows * SRP_LANES);
    Rows { count: p.row_count, len: SRP_LANES, pitch: SRP_LANES, first, plane }
}

/// Two ranks of three channels: value `3·rank + channel`. `pairs` of all dispatches, `blocks`: index of each block's
/// first coefficient, `words`: matrices, `coefs`: λ in planes `[channel]`.
#[inline(always)]
pub fn project<R: Real>(
    at: At,
    p: &SrpTransportParams,
    pairs: &[SrpRankPair],
    blocks: &[u32],
    words: &[u32],
    coefs: &[f32],
) -> [R; 6] {
    let pair = pairs[(p.first_row + at.row) as usize];
    let plane = p.coef_plane as usize;
    let mut word = (pair.words_first + at.x) as usize;
    let mut block = pair.block_first as usize;
    let mut sum = [R::splat(0.0); 6];
    for _ in 0..pair.block_pairs {
        R::prefetch(words, word + PREFETCH_WORDS);
        R::prefetch(words, word + PREFETCH_WORDS + SRP_LANES as usize);
        let a = (blocks[block] + at.x) as usize;
        let b = (blocks[block + 1] + at.x) as usize;
        let [a0, b0] = R::load_f16x2(words, word);
        let [a1, b1] = R::load_f16x2(words, word + SRP_LANES as usize);
        unroll!(C in 0, 1, 2 => {
            let la = R::load(coefs, C * plane + a);
            let lb = R::load(coefs, C * plane + b);
            sum[C] = sum[C] + a0 * la + b0 * lb;
            sum[3 + C] = sum[3 + C] + a1 * la + b1 * lb;
        });
        word += 2 * SRP_LANES as usize;
        block += 2;
    }
    sum
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let total_rows = (input.count as u32).div_ceil(16);
    let first_row = if input.bits() & 1 == 0 { 0 } else { total_rows / 3 };
    // In a large case 150 probes of order 7, of which 20 on average support a cluster (Silvennoinen & Lehtinen 2017, Sponza).
    let any = 64 + input.bits() % 500;
    let coef_count = if input.is_large() { 150 * 64 } else { any };
    let coef_plane = coef_count + SRP_LANES;
    let p = SrpTransportParams {
        first_row,
        row_count: total_rows - first_row,
        total_rows,
        coef_plane,
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
        _pad3: 0,
    };
    let blocks: alloc::vec::Vec<u32> = (0..256).map(|_| input.bits() % coef_count).collect();
    let (mut pairs, mut word_count) = (alloc::vec![], 0);
    for _ in 0..total_rows {
        let any = input.bits();
        let block_pairs = if input.is_large() { 20 + any % 41 } else { any % 6 };
        let block_first = input.bits() % (256 - 2 * block_pairs);
        pairs.push(SrpRankPair { words_first: word_count, block_first, block_pairs, _pad0: 0 });
        word_count += block_pairs * 2 * SRP_LANES;
    }
    let words = super::case_halves(input, word_count as usize);
    let coefs = super::case_floats(input, 3 * coef_plane as usize);
    let case = Case::default().uniform(&p).read(&pairs).read(&blocks).read(&words).read(&coefs);
    case.zeroed::<f32>((6 * total_rows * SRP_LANES) as usize)
}

kernel! {
    /// Probe coefficients to sixteenths of light-basis components.
    lanes mod srp_cluster = super::project; entry "srp_cluster" threads(64);
    uniform 0 params: SrpTransportParams;
    read 1 pairs: SrpRankPair;
    read 2 blocks: u32;
    read 3 words: u32;
    read 4 coefs: f32;
    write 5 partial: f32 x 6;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(4e-6, 4e-6), "in small cases up to 10 multiply-adds of numbers below 1 that may cancel; a device may fuse each";
}
