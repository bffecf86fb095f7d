//! Injection: lit texels become light in the cells in front of them.
//!
//! `lpv_inject`: one invocation adds one texel's reflected flux, albedo × flux, to the cell half a cell above it along its normal, as a
//! clamped-cosine lobe: flux Φ and first moment ⅔Φn (the spherical-harmonics coefficients of order 1, which are these two
//! times constants). The papers add lobes times an ad-hoc texel weight, grid size over map size (1/16 of 32 and 512 there), which depends on both
//! resolutions and on nothing that light does; with flux per texel the sum over a cell is the power that its surfaces
//! reflect, whatever the map's resolution. `lpv_resolve`: one invocation turns one word into watts.
//!
//! **Streams.** One lobe per cell merges beams that cross: light of a floor would carry that of the walls away with it. With `streams` = 6
//! the flux of a surface with normal n is shared out by n² among the six directions of the axes, and each share travels on its own.
//!
//! Fixed point through integer atomics: the same bits in any order. Flux is a sum of positive numbers, so that the word after the last
//! tells for certain whether a cell reached [`FLUX_LIMIT`]: then the host injects again on a coarser scale. Moments are at most as large.
//!
//! Pass before: `rsm.rs`, or `bounce.rs`. Pass after: `propagate.rs`.

use super::grid::{cell_of, cells_from_world, element, inside};
use crate::kernel::AtomicWords;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{floor, max, min};
use glam::Vec3;
use interreflect_shared::lpv::{FLUX_LIMIT, FLUX_VALUES, LpvLayout, LpvParams, RsmTexel};

/// First moment per flux of a clamped-cosine lobe: ∫ cos²θ / ∫ cos θ.
pub const LOBE_MOMENT: f32 = 2.0 / 3.0;
/// Start of light above the surface that reflects it, in cells (Kaplanyan & Dachsbacher 2010, §4.2).
pub const DISPLACEMENT: f32 = 0.5;
/// Where a surface lies on cells' centres, rounding would decide piece by piece on which side of them it blocks and in which
/// cells its light starts, and light would pass between the pieces. So light starts this much higher, in cells, and surfaces
/// block this much deeper: all of it on the same side.
pub const TIE: f32 = 1.0 / 64.0;

/// Texels of the pass.
pub fn items(p: &LpvParams) -> u32 {
    p.count
}

/// Adds a lobe of `flux` (W) around `normal`, from a surface at `position`.
#[inline(always)]
pub fn add_lobe(p: &LpvParams, position: Vec3, normal: Vec3, flux: Vec3, words: &mut impl AtomicWords) {
    let cell = cell_of(p.first_cell, cells_from_world(p.anchor_size, position) + normal * (DISPLACEMENT + TIE));
    if inside(p.dims, cell) {
        let layout = LpvLayout::new(p.dims);
        let i = element(&layout, cell);
        if p.streams <= 1 {
            add_colour(p, &layout, i, flux, normal, words);
        } else {
            let per_stream = FLUX_VALUES * layout.value();
            unroll!(AXIS in 0, 1, 2 => {
                let way = normal.to_array()[AXIS];
                let stream = 2 * AXIS as u32 + (way < 0.0) as u32;
                add_colour(p, &layout, stream * per_stream + i, flux * (way * way), normal, words);
            });
        }
    }
}

#[inline(always)]
fn add_colour(p: &LpvParams, layout: &LpvLayout, i: u32, flux: Vec3, normal: Vec3, words: &mut impl AtomicWords) {
    add_channel(p, layout, i, 0, flux.x, normal, words);
    add_channel(p, layout, i, 1, flux.y, normal, words);
    add_channel(p, layout, i, 2, flux.z, normal, words);
}

/// Words of all streams; the one after them tells of an overflow.
pub fn word_count(p: &LpvParams) -> u32 {
    FLUX_VALUES * LpvLayout::new(p.dims).value() * p.streams.max(1)
}

#[inline(always)]
fn add_channel(
    p: &LpvParams,
    layout: &LpvLayout,
    i: u32,
    channel: u32,
    flux: f32,
    normal: Vec3,
    words: &mut impl AtomicWords,
) {
    let units = min(max(flux * p.flux_scale, 0.0), FLUX_LIMIT as f32);
    let (first, value) = (channel * layout.plane + i, layout.value());
    let word = floor(units + 0.5) as u32;
    if word == 0 {
        return;
    }
    if words.add(first, word) >= FLUX_LIMIT - word.min(FLUX_LIMIT) {
        words.or(word_count(p), 1);
    }
    let moment = normal * (units * LOBE_MOMENT);
    words.add(first + value, floor(moment.x + 0.5) as i32 as u32);
    words.add(first + 2 * value, floor(moment.y + 0.5) as i32 as u32);
    words.add(first + 3 * value, floor(moment.z + 0.5) as i32 as u32);
}

/// Injects texel `i`.
#[inline(always)]
pub fn inject(i: u32, p: &LpvParams, texels: &[RsmTexel], words: &mut impl AtomicWords) {
    let t = &texels[i as usize];
    if t.hit == 1 {
        let flux = Vec3::from_array(t.flux) * Vec3::from_array(t.albedo);
        add_lobe(p, Vec3::from_array(t.position), Vec3::from_array(t.normal), flux, words);
    }
}

/// Flux or moment (W) of word `i` of the pass's stream.
pub fn resolve(i: u32, p: &LpvParams, words: &[u32]) -> f32 {
    let first = p.stream * FLUX_VALUES * LpvLayout::new(p.dims).value();
    words[(first + i) as usize] as i32 as f32 / p.flux_scale
}

#[cfg(not(target_arch = "spirv"))]
fn inject_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, 8);
    let texels = super::case::texels(input, &p);
    let words = word_count(&p) + 1;
    Case::default().uniform(&LpvParams { count: texels.len() as u32, ..p }).read(&texels).zeroed::<u32>(words as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn resolve_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let p = LpvParams { stream: p.streams / 2, ..p };
    let words: alloc::vec::Vec<u32> = (0..word_count(&p) + 1).map(|_| input.bits()).collect();
    Case::default().uniform(&p).read(&words).zeroed::<f32>((FLUX_VALUES * LpvLayout::new(p.dims).value()) as usize)
}

scatter! {
    /// Lit texels to light in cells.
    mod lpv_inject = super::inject; entry "lpv_inject" threads(64);
    uniform 0 params: LpvParams; items super::items;
    read 1 texels: RsmTexel;
    atomic 2 words;
    case super::inject_case; tolerance Tolerance::FixedPoint(4096), "a product of three factors, of up to 2^24 units, may differ in its last place; sums of dozens of them";
}

kernel! {
    /// Fixed point to watts.
    mod lpv_resolve = super::resolve; entry "lpv_resolve" threads(64);
    uniform 0 params: LpvParams;
    read 1 words: u32;
    write 2 out: f32;
    case super::resolve_case; tolerance Tolerance::RelAbs(1e-6, 1e-30), "a division may be off by two units in the last place on a device";
}
