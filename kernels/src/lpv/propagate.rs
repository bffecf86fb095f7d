//! Propagation: one step of light from every cell to its six neighbours.
//!
//! `lpv_propagate`: one invocation gathers what the six neighbours of one cell send through its faces, one facing and
//! four sides each (Kaplanyan & Dachsbacher 2010, §4.3), makes the flux through each face a lobe again, and adds what now travels
//! to what has passed. `lpv_begin`: one invocation makes injected flux travel. Grid: cells of each colour channel, lanes along x;
//! values in planes with a halo of zeros.
//!
//! **State.** What travels (constant and vector of the intensity, factor of the moment: [`super::lobe`]), then the spherical
//! harmonics of all that has passed: order 1, and of band 2 what tells the axes apart. With order 1 alone strong light upwards
//! would take light downwards away: six coefficients hold the flux through the six faces, none of which is negative.
//!
//! **Energy.** Solid angles of the 30 faces add up to 4π exactly, so an intensity that is nowhere negative sends exactly its flux. An order-1 lobe that is
//! narrower is clamped at zero and sends more: up to 1.1382 times for a clamped cosine along an axis. With `gain` = 1 each
//! cell is scaled to send what it holds: stored + left + absorbed = injected.
//!
//! **Direction.** In the paper the flux through a face becomes a clamped-cosine lobe around the face's axis (`lobe` = ⅔, 0, ⅔): half of
//! the light that a wall reflects is turned around within a few cells and falls back on it, more so the finer the grid. By default the lobe stands
//! around the direction of travel and keeps the first moment (`lobe` = 1, 2/√5, 1/√5 and a factor against the clamp): free flight changes neither
//! flux nor moment. Both are one kernel.
//!
//! **Occlusion.** Light from cell to cell is multiplied with 1 − the opacity between their centres ([`super::block`]); none in the first step, so
//! that a surface does not block the light that was injected in front of it.
//!
//! Good when light is smooth; fails when walls are thinner than a cell, and far from small sources: beams that cross in one stream merge, and
//! thirty faces spread a lobe a little further at every step. Pass before: `inject.rs`. Pass after: `levels.rs`, `gather.rs`.

use super::grid::{cell_row, rows};
use super::lobe::{FACING_SR, Lobes, SIDE_SR, Sent, Travelling, travel};
use crate::kernel::At;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::lpv::{FLUX_VALUES, STATE_VALUES};
use interreflect_shared::lpv::{LpvLayout, LpvParams};

/// Flux and moment that arrive at the cell at `i`.
#[inline(always)]
fn arriving<R: Real>(i: usize, l: &LpvLayout, p: &LpvParams, state: &[f32], open: &[R; 6]) -> [R; 4] {
    let value = l.value() as usize;
    // Moment along and across the way of travel of an intensity towards a face.
    let facing = R::splat(p.lobe.x * FACING_SR);
    let (along, across) = (R::splat(p.lobe.y * SIDE_SR), R::splat(p.lobe.z * SIDE_SR));
    let mut flux = R::splat(0.0);
    let mut moment = [R::splat(0.0); 3];
    unroll!(K in 0, 1, 2, 3, 4, 5 => {
        const AXIS: usize = K / 2;
        const NEXT: usize = (AXIS + 1) % 3;
        const LAST: usize = (AXIS + 2) % 3;
        let step = if AXIS == 0 { 1 } else if AXIS == 1 { l.pitch as usize } else { l.layer as usize };
        // From the neighbour above light comes down the axis.
        let j = if K & 1 == 0 { i + step } else { i - step };
        let b = [R::load(state, j + value), R::load(state, j + 2 * value), R::load(state, j + 3 * value)];
        let forward = if K & 1 == 0 { -b[AXIS] } else { b[AXIS] };
        let sent = Sent::new(R::load(state, j), forward, b[NEXT], b[LAST]);
        let kept = open[K] * R::load(state, j + 4 * value);
        flux = sent.flux().mul_add(open[K], flux);
        let m = sent.facing.mul_add(facing, sent.sides * along);
        moment[AXIS] = m.mul_add(if K & 1 == 0 { -kept } else { kept }, moment[AXIS]);
        let kept_across = kept * across;
        moment[NEXT] = sent.next.mul_add(kept_across, moment[NEXT]);
        moment[LAST] = sent.last.mul_add(kept_across, moment[LAST]);
    });
    [flux, moment[0], moment[1], moment[2]]
}

/// Share of light that passes a face.
#[inline(always)]
fn open_way<R: Real>(j: usize, p: &LpvParams, opacity: &[f32]) -> R {
    R::load(opacity, j).mul_add(R::splat(-p.occlusion), R::splat(1.0))
}

/// Share of light that passes from each neighbour (+x, −x, +y, …) of the cell at `i` of a plane of opacity.
#[inline(always)]
pub fn open_ways<R: Real>(i: usize, l: &LpvLayout, p: &LpvParams, opacity: &[f32]) -> [R; 6] {
    let (plane, pitch, layer) = (l.plane as usize, l.pitch as usize, l.layer as usize);
    let mut open = [R::splat(1.0); 6];
    open[0] = open_way(i, p, opacity);
    open[1] = open_way(i - 1, p, opacity);
    open[2] = open_way(plane + i, p, opacity);
    open[3] = open_way(plane + i - pitch, p, opacity);
    open[4] = open_way(2 * plane + i, p, opacity);
    open[5] = open_way(2 * plane + i - layer, p, opacity);
    open
}

/// What travels, and what passed times `weight`.
#[inline(always)]
fn values<R: Real>(t: &Travelling<R>, weight: R) -> [R; 11] {
    let mut out = [t.a, t.b[0], t.b[1], t.b[2], t.moment_factor, t.a, t.a, t.a, t.a, t.a, t.a];
    unroll!(J in 0, 1, 2, 3, 4, 5 => { out[5 + J] = t.passed[J] * weight; });
    out
}

/// Elements ahead that are asked for: a plane's rows lie on pages of their own, and twenty planes are read at once.
pub(super) const AHEAD: usize = 128;

/// Asks for what a later row reads first: what travels in the layer above it, and what has passed.
#[inline(always)]
fn prefetch<R: Real>(i: usize, l: &LpvLayout, state: &[f32]) {
    let value = l.value() as usize;
    unroll!(J in 0, 1, 2, 3, 4 => { R::prefetch(state, J * value + i + l.layer as usize); });
    unroll!(J in 5, 6, 7, 8, 9, 10 => { R::prefetch(state, J * value + i); });
}

/// The state of one channel of one cell after a step.
#[inline(always)]
pub fn propagate<R: Real>(at: At, p: &LpvParams, state: &[f32], opacity: &[f32]) -> [R; 11] {
    let l = LpvLayout::new(p.dims);
    let value = l.value() as usize;
    let row = cell_row(at, p.dims, &l);
    let mut out = [R::splat(0.0); 11];
    if row.real {
        prefetch::<R>(at.i + AHEAD, &l, state);
        let open = open_ways::<R>(at.i - (row.channel * l.plane) as usize, &l, p, opacity);
        let t = travel(arriving(at.i, &l, p, state, &open), &Lobes::of(p));
        out = values(&t, R::splat(1.0));
        unroll!(J in 5, 6, 7, 8, 9, 10 => { out[J] = out[J] + R::load(state, J * value + at.i); });
    }
    out
}

/// The state of one channel of one cell that holds injected flux and moment (`source`: four values); what had passed in
/// `before` is kept, times `keep`.
#[inline(always)]
pub fn begin<R: Real>(at: At, p: &LpvParams, source: &[f32], before: &[f32]) -> [R; 11] {
    let l = LpvLayout::new(p.dims);
    let (i, value) = (at.i, l.value() as usize);
    let mut out = [R::splat(0.0); 11];
    if cell_row(at, p.dims, &l).real {
        let moment = [R::load(source, i + value), R::load(source, i + 2 * value), R::load(source, i + 3 * value)];
        let t = travel([R::load(source, i), moment[0], moment[1], moment[2]], &Lobes::of(p));
        out = values(&t, R::splat(p.weight));
        let keep = R::splat(p.keep);
        unroll!(J in 5, 6, 7, 8, 9, 10 => { out[J] = R::load(before, J * value + i).mul_add(keep, out[J]); });
    }
    out
}

#[cfg(not(target_arch = "spirv"))]
fn propagate_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let state = super::case::state(input, &p);
    let opacity = super::case::opacity(input, &p);
    Case::default().uniform(&p).read(&state).read(&opacity).zeroed::<f32>(state.len())
}

#[cfg(not(target_arch = "spirv"))]
fn begin_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let source = super::case::source(input, &p);
    let before = super::case::state(input, &p);
    debug_assert_eq!(before.len(), source.len() / FLUX_VALUES as usize * STATE_VALUES as usize);
    Case::default().uniform(&p).read(&source).read(&before).zeroed::<f32>(before.len())
}

kernel! {
    /// One step of light, with occlusion.
    lanes mod lpv_propagate = super::propagate; entry "lpv_propagate" threads(64);
    uniform 0 params: LpvParams;
    read 1 state: f32;
    read 2 opacity: f32;
    write 3 out: f32 x 11;
    over super::rows;
    case super::propagate_case; tolerance Tolerance::RelAbs(1e-4, 2e-5), "moments and net fluxes are sums of some hundred terms up to 3 of both signs; roots and divisions of devices";
}

kernel! {
    /// Injected flux to light that travels.
    lanes mod lpv_begin = super::begin; entry "lpv_begin" threads(64);
    uniform 0 params: LpvParams;
    read 1 source: f32;
    read 2 before: f32;
    write 3 out: f32 x 11;
    over super::rows;
    case super::begin_case; tolerance Tolerance::RelAbs(1e-4, 1e-5), "net fluxes are differences of sums of 60 terms; roots and divisions of devices";
}
