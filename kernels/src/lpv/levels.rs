//! From a grid to the next coarser one, and back.
//!
//! Every step of propagation blurs light's direction by the same angle, however small the cells: on a fine grid light that crosses a
//! room has lost its way. So light that has gone a few cells moves over to cells twice as large, as often as needed: the number of steps across a room grows
//! with the logarithm of the resolution instead of the resolution, and costs an eighth per level. (The papers' cascades are nested around the camera; ours are nested in extent and, within each, in
//! distance from the source.)
//!
//! `lpv_restrict`: one invocation adds up what travels in the eight cells below one coarse cell: flux and first moment, kept exactly. `lpv_prolong`: one
//! invocation adds one number of what has passed on the coarser grid, trilinear and per area of a cell's face, to what has passed on the finer one.
//!
//! Pass before: `propagate.rs` on the finer (`lpv_restrict`) or coarser (`lpv_prolong`) grid. Pass after: `propagate.rs` on the coarser grid; `gather.rs`.

use super::grid::{cell_row, coarse_rows};
use super::lobe::outflow;
use crate::kernel::At;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use glam::UVec4;
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::lpv::{FLUX_VALUES, STATE_VALUES};
use interreflect_shared::lpv::{FRONT_VALUES, LpvLayout, LpvParams};

/// Flux and first moment of what travels in the eight cells below a coarse cell, in one channel.
#[inline(always)]
pub fn restrict<R: Real>(at: At, p: &LpvParams, state: &[f32]) -> [R; 4] {
    let fine = LpvLayout::new(p.dims);
    let value = fine.value() as usize;
    let row = cell_row(at, p.coarse_dims, &LpvLayout::new(p.coarse_dims));
    let mut out = [R::splat(0.0); 4];
    if row.real {
        let first = row.channel * fine.plane + fine.at(2 * at.x, 2 * row.y, 2 * row.z);
        for child in 0..8u32 {
            let i = (first + (child & 1) + (child >> 1 & 1) * fine.pitch + (child >> 2) * fine.layer) as usize;
            let a = R::load_strided(state, i, 2);
            let b = [
                R::load_strided(state, value + i, 2),
                R::load_strided(state, 2 * value + i, 2),
                R::load_strided(state, 3 * value + i, 2),
            ];
            let lit = R::splat(0.0).lt(a);
            // The faces receive the cell's flux; vector over constant is three times the mean direction.
            let flux = R::select(lit, outflow(a, b).flux, R::splat(0.0));
            let per_constant = flux / (R::select(lit, a, R::splat(1.0)) * R::splat(3.0));
            out[0] = out[0] + flux;
            out[1] = out[1] + b[0] * per_constant;
            out[2] = out[2] + b[1] * per_constant;
            out[3] = out[3] + b[2] * per_constant;
        }
    }
    out
}

/// Place of element `i` of a plane: cell, or the halo where `x` is the number of cells or more.
#[inline(always)]
fn cell_at(l: &LpvLayout, dims: UVec4, i: u32) -> [u32; 3] {
    let outside = [dims.x, dims.y, dims.z];
    if i < l.first {
        outside
    } else {
        let n = i - l.first;
        let z = n / l.layer;
        let rest = n - z * l.layer;
        let y = rest / l.pitch;
        let x = rest - y * l.pitch;
        if x < dims.x && y < dims.y && z < dims.z { [x, y, z] } else { outside }
    }
}

/// Number `i` of the finer grid's passed light: `keep` times an earlier total, its own, and the coarser grid's.
pub fn prolong(i: u32, p: &LpvParams, before: &[f32], state: &[f32], coarse: &[f32]) -> f32 {
    let l = LpvLayout::new(p.dims);
    let plane = i / l.plane;
    let [x, y, z] = cell_at(&l, p.dims, i - plane * l.plane);
    let mut sum = 0.0;
    if x < p.dims.x {
        sum = before[i as usize] * p.keep + state[(FRONT_VALUES * l.value() + i) as usize];
        if p.coarse_weight > 0.0 {
            sum += interpolated(p, coarse, plane, [x, y, z]) * p.coarse_weight;
        }
    }
    sum
}

/// Trilinear: ¾ of the cell around and ¼ of its neighbour on the nearer side, along each axis. `plane`: value and channel.
#[inline(always)]
fn interpolated(p: &LpvParams, coarse: &[f32], plane: u32, cell: [u32; 3]) -> f32 {
    let l = LpvLayout::new(p.coarse_dims);
    let x = taps(cell[0], p.coarse_dims.x);
    let y = taps(cell[1], p.coarse_dims.y);
    let z = taps(cell[2], p.coarse_dims.z);
    let value = |x: u32, y: u32, z: u32| coarse[(plane * l.plane + l.at(x, y, z)) as usize];
    let row = |y: u32, z: u32| value(x[0], y, z) * 0.75 + value(x[1], y, z) * 0.25;
    let layer = |z: u32| row(y[0], z) * 0.75 + row(y[1], z) * 0.25;
    layer(z[0]) * 0.75 + layer(z[1]) * 0.25
}

/// Coarse cell around a fine one and its nearer neighbour; at the border itself.
#[inline(always)]
fn taps(fine: u32, count: u32) -> [u32; 2] {
    let here = fine / 2;
    let other = if fine & 1 == 1 {
        (here + 1).min(count - 1)
    } else if here > 0 {
        here - 1
    } else {
        0
    };
    [here, other]
}

#[cfg(not(target_arch = "spirv"))]
fn restrict_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let state = super::case::state(input, &p);
    let value = LpvLayout::new(p.coarse_dims).value();
    Case::default().uniform(&p).read(&state).zeroed::<f32>((value * FLUX_VALUES) as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn prolong_case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let (fine, coarse) = (LpvLayout::new(p.dims).value(), LpvLayout::new(p.coarse_dims).value());
    let mut numbers = |n: u32| -> alloc::vec::Vec<f32> { (0..n).map(|_| input.float().abs()).collect() };
    let before = numbers(fine * FLUX_VALUES);
    let state = numbers(fine * STATE_VALUES);
    let coarse = numbers(coarse * FLUX_VALUES);
    Case::default().uniform(&p).read(&before).read(&state).read(&coarse).zeroed::<f32>(before.len())
}

kernel! {
    /// What travels, on the next coarser grid.
    lanes mod lpv_restrict = super::restrict; entry "lpv_restrict" threads(64);
    uniform 0 params: LpvParams;
    read 1 state: f32;
    write 2 out: f32 x 4;
    over super::coarse_rows;
    case super::restrict_case; tolerance Tolerance::RelAbs(1e-4, 1e-5), "moments are sums of eight numbers of both signs, each of 30 faces";
}

kernel! {
    /// What has passed, with the coarser grid's share.
    mod lpv_prolong = super::prolong; entry "lpv_prolong" threads(64);
    uniform 0 params: LpvParams;
    read 1 before: f32;
    read 2 state: f32;
    read 3 coarse: f32;
    write 4 out: f32;
    case super::prolong_case; tolerance Tolerance::RelAbs(1e-5, 1e-35), "ten products of positive numbers, which a device may fuse";
}
