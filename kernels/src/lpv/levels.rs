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
use glam::{UVec3, UVec4};
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
            // The faces receive the cell's flux; vector over constant is three times the mean direction,
            // times the sharpness.
            let flux = R::select(lit, outflow(a, b).flux, R::splat(0.0));
            let per_constant = flux / (R::select(lit, a, R::splat(1.0)) * R::splat(3.0 * p.sharpness));
            out[0] = out[0] + flux;
            out[1] = out[1] + b[0] * per_constant;
            out[2] = out[2] + b[1] * per_constant;
            out[3] = out[3] + b[2] * per_constant;
        }
    }
    out
}

/// Cell at element `i` of a plane; its `x` is the number of cells in the halo.
#[inline(always)]
fn cell_at(l: &LpvLayout, dims: UVec4, i: u32) -> UVec3 {
    let n = if i < l.first { 0 } else { i - l.first };
    let z = n / l.layer;
    let rest = n - z * l.layer;
    let y = rest / l.pitch;
    let x = rest - y * l.pitch;
    let real = i >= l.first && x < dims.x && y < dims.y && z < dims.z;
    UVec3::new(if real { x } else { dims.x }, y, z)
}

/// Number `i` of the finer grid's passed light: `keep` times an earlier total, its own, and the coarser grid's.
pub fn prolong(i: u32, p: &LpvParams, before: &[f32], state: &[f32], coarse: &[f32]) -> f32 {
    let l = LpvLayout::new(p.dims);
    let plane = i / l.plane;
    let cell = cell_at(&l, p.dims, i - plane * l.plane);
    let mut sum = 0.0;
    if cell.x < p.dims.x {
        sum = before[i as usize] * p.keep + state[(FRONT_VALUES * l.value() + i) as usize];
        if p.coarse_weight > 0.0 {
            let c = LpvLayout::new(p.coarse_dims);
            sum += interpolated(&c, coarse, plane * c.plane, cell, p.coarse_dims) * p.coarse_weight;
        }
    }
    sum
}

/// Trilinear: ¾ of the coarse cell around and ¼ of its neighbour on the nearer side, along each axis.
#[inline(always)]
fn interpolated(l: &LpvLayout, coarse: &[f32], base: u32, cell: UVec3, dims: UVec4) -> f32 {
    let (x, y, z) = (cell.x / 2, cell.y / 2, cell.z / 2);
    let (u, v, w) = (nearer(cell.x, dims.x), nearer(cell.y, dims.y), nearer(cell.z, dims.z));
    let near = row(l, coarse, base, x, u, y, z) * 0.75 + row(l, coarse, base, x, u, v, z) * 0.25;
    let far = row(l, coarse, base, x, u, y, w) * 0.75 + row(l, coarse, base, x, u, v, w) * 0.25;
    near * 0.75 + far * 0.25
}

#[inline(always)]
fn row(l: &LpvLayout, coarse: &[f32], base: u32, x: u32, u: u32, y: u32, z: u32) -> f32 {
    coarse[(base + l.at(x, y, z)) as usize] * 0.75 + coarse[(base + l.at(u, y, z)) as usize] * 0.25
}

/// Coarse neighbour on the side of a fine cell; at the border the coarse cell itself.
#[inline(always)]
fn nearer(fine: u32, count: u32) -> u32 {
    let here = fine / 2;
    let up = fine & 1;
    let other = here + up;
    let below = if here > 0 { here - 1 } else { 0 };
    if up == 0 { below } else { other.min(count - 1) }
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
