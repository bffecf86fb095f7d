//! Receiver reconstruction: `U` times the light basis of the receiver's cluster.
//!
//! One invocation: one receiver, three channels; `srp_reconstruct` one row of `U` (irradiance, W/m²), `srp_reconstruct_directional`
//! four (order-1 coefficients of incident radiance, for normal mapping). Grid: blocks of 16 receivers × 16. Silvennoinen
//! & Timonen 2017, §4.2. The light basis is the same for all receivers of a block, so that each half float of `U` is read
//! once, next to its neighbours': bound by bandwidth. Before: [`super::light_basis`]; after: [`super::relight`] of the
//! next bounce, [`super::resolve`].

use super::PREFETCH_WORDS;
use crate::kernel::{At, Rows, fetch};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use interreflect_shared::srp::{SRP_LANES, SrpReceiverBlock, SrpTransportParams};

/// One row per block of this dispatch.
pub fn rows(p: &SrpTransportParams) -> Rows {
    let (first, plane) = (p.first_row * SRP_LANES, p.total_rows * SRP_LANES);
    Rows { count: p.row_count, len: SRP_LANES, pitch: SRP_LANES, first, plane }
}

/// Three channels of a receiver. `blocks` of all dispatches, `words`: matrices, `basis`: four floats per component.
#[inline(always)]
pub fn irradiance<R: Real>(
    at: At,
    p: &SrpTransportParams,
    blocks: &[SrpReceiverBlock],
    words: &[u32],
    basis: &[f32],
) -> [R; 3] {
    let block = blocks[(p.first_row + at.row) as usize];
    let mut word = (block.words_first + at.x) as usize;
    let mut b = 4 * block.basis_first as usize;
    let mut sum = [R::splat(0.0); 3];
    for _ in 0..block.rank_pairs {
        R::prefetch(words, word + PREFETCH_WORDS);
        let [u0, u1] = R::load_f16x2(words, word);
        unroll!(C in 0, 1, 2 => {
            sum[C] = sum[C] + u0 * R::splat(*fetch(basis, b + C)) + u1 * R::splat(*fetch(basis, b + 4 + C));
        });
        word += SRP_LANES as usize;
        b += 8;
    }
    sum
}

/// Four coefficients of three channels of a receiver: value `3·coefficient + channel`. Buffers as for [`irradiance`].
#[inline(always)]
pub fn radiance<R: Real>(
    at: At,
    p: &SrpTransportParams,
    blocks: &[SrpReceiverBlock],
    words: &[u32],
    basis: &[f32],
) -> [R; 12] {
    let block = blocks[(p.first_row + at.row) as usize];
    let mut word = (block.words_first + at.x) as usize;
    let mut b = 4 * block.basis_first as usize;
    let mut sum = [R::splat(0.0); 12];
    for _ in 0..block.rank_pairs {
        unroll!(K in 0, 1, 2, 3 => {
            R::prefetch(words, word + PREFETCH_WORDS + K * SRP_LANES as usize);
            let [u0, u1] = R::load_f16x2(words, word + K * SRP_LANES as usize);
            unroll!(C in 0, 1, 2 => {
                sum[3 * K + C] = sum[3 * K + C] + u0 * R::splat(*fetch(basis, b + C)) + u1 * R::splat(*fetch(basis, b + 4 + C));
            });
        });
        word += 4 * SRP_LANES as usize;
        b += 8;
    }
    sum
}

#[cfg(not(target_arch = "spirv"))]
fn case_of(input: &mut CaseInput, values: u32) -> Case {
    let total_rows = (input.count as u32).div_ceil(SRP_LANES);
    let first_row = if input.bits() & 1 == 0 { 0 } else { total_rows / 3 };
    let p = SrpTransportParams {
        first_row,
        row_count: total_rows - first_row,
        total_rows,
        coef_plane: 0,
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
        _pad3: 0,
    };
    let (mut blocks, mut word_count) = (alloc::vec![], 0);
    for _ in 0..total_rows {
        // In a large case 24 components and no more than 32 (Silvennoinen & Lehtinen 2017, Sponza).
        let any = input.bits();
        let rank_pairs = if input.is_large() { 8 + any % 9 } else { any % 8 };
        let basis_first = input.bits() % (64 - 2 * rank_pairs);
        blocks.push(SrpReceiverBlock { words_first: word_count, rank_pairs, basis_first, _pad0: 0 });
        word_count += rank_pairs * values * SRP_LANES;
    }
    let words = super::case_halves(input, word_count as usize);
    let basis = super::case_floats(input, 4 * 64);
    let case = Case::default().uniform(&p).read(&blocks).read(&words).read(&basis);
    case.zeroed::<f32>((3 * values * total_rows * SRP_LANES) as usize)
}
#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    case_of(input, 1)
}
#[cfg(not(target_arch = "spirv"))]
fn case4(input: &mut CaseInput) -> Case {
    case_of(input, 4)
}

kernel! {
    /// Light bases to irradiance at receivers.
    lanes mod srp_reconstruct = super::irradiance; entry "srp_reconstruct" threads(64);
    uniform 0 params: SrpTransportParams;
    read 1 blocks: SrpReceiverBlock;
    read 2 words: u32;
    read 3 basis: f32;
    write 4 irradiance: f32 x 3;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(4e-6, 4e-6), "in small cases up to 14 multiply-adds of numbers below 1 that may cancel; a device may fuse each";
}

kernel! {
    /// Light bases to order-1 radiance at receivers.
    lanes mod srp_reconstruct_directional = super::radiance; entry "srp_reconstruct_directional" threads(64);
    uniform 0 params: SrpTransportParams;
    read 1 blocks: SrpReceiverBlock;
    read 2 words: u32;
    read 3 basis: f32;
    write 4 radiance: f32 x 12;
    over super::rows;
    case super::case4; tolerance Tolerance::RelAbs(4e-6, 4e-6), "in small cases up to 14 multiply-adds of numbers below 1 that may cancel; a device may fuse each";
}
