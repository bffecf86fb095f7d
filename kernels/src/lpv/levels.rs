//! From a grid to the next coarser one, and back.
//!
//! Every step of propagation blurs light's direction by the same angle, however small the cells: on a fine grid light that crosses a
//! room has lost its way. So light that has gone a few cells moves over to cells twice as large, as often as needed: the number of steps across a room grows
//! with the logarithm of the resolution instead of the resolution, and costs an eighth per level. (The papers' cascades are nested around the camera; ours are nested in extent and, within each, in
//! distance from the source.)
//!
//! `lpv_restrict`: one invocation adds up what travels in the eight cells below one coarse cell: flux and first moment, kept exactly. `lpv_prolong`: one
//! invocation adds one number of what has passed on the coarser grid, trilinear (without cells behind walls) and per area of a cell's face, to what has passed on the finer one.
//!
//! Pass before: `propagate.rs` on the finer (`lpv_restrict`) or coarser (`lpv_prolong`) grid. Pass after: `propagate.rs` on the coarser grid; `gather.rs`.

use super::grid::{cell_row, coarse_rows};
use super::lobe::outflow;
use crate::kernel::At;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
use glam::{UVec3, UVec4, Vec3};
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::lpv::{FLUX_VALUES, PASSED_VALUES, STATE_VALUES};
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
            let sent = outflow(a, b);
            let factor = R::load_strided(state, 4 * value + i, 2);
            out[0] = out[0] + sent.flux;
            unroll!(K in 0, 1, 2 => { out[1 + K] = out[1 + K] + sent.moment[K] * factor; });
        }
    }
    out
}

/// Cell at element `i` of a plane; its `x` is the number of cells in the halo.
#[inline(always)]
fn cell_at(l: &LpvLayout, dims: UVec4, i: u32) -> UVec3 {
    let n = i.max(l.first) - l.first;
    let z = n / l.layer;
    let rest = n - z * l.layer;
    let y = rest / l.pitch;
    let x = rest - y * l.pitch;
    let real = i >= l.first && x < dims.x && y < dims.y && z < dims.z;
    UVec3::new(if real { x } else { dims.x }, y, z)
}

/// Number `i` of the finer grid's passed light: `keep` times an earlier total, its own, and the coarser grid's.
pub fn prolong(
    i: u32,
    p: &LpvParams,
    before: &[f32],
    state: &[f32],
    coarse: &[f32],
    opacity: &[f32],
    coarse_opacity: &[f32],
) -> f32 {
    let l = LpvLayout::new(p.dims);
    let plane = i / l.plane;
    let element = i - plane * l.plane;
    let cell = cell_at(&l, p.dims, element);
    let mut sum = 0.0;
    if cell.x < p.dims.x {
        sum = before[i as usize] * p.keep + state[(FRONT_VALUES * l.value() + i) as usize];
        if p.coarse_weight > 0.0 {
            let c = LpvLayout::new(p.coarse_dims);
            let (d, here) = (p.coarse_dims, cell / 2);
            let other = UVec3::new(nearer(cell.x, d.x), nearer(cell.y, d.y), nearer(cell.z, d.z));
            let at = c.at(here.x, here.y, here.z);
            let weight = Vec3::new(
                other_weight(cell.x, element, 1, at, 1, opacity, coarse_opacity),
                other_weight(cell.y, l.plane + element, l.pitch, c.plane + at, c.pitch, opacity, coarse_opacity),
                other_weight(
                    cell.z,
                    2 * l.plane + element,
                    l.layer,
                    2 * c.plane + at,
                    c.layer,
                    opacity,
                    coarse_opacity,
                ),
            );
            sum += interpolated(&c, coarse, plane * c.plane, here, other, weight) * p.coarse_weight;
        }
    }
    sum
}

/// Weight of the coarse neighbour along one axis: ¼ in the open. Where a wall stands between the two coarse centres only
/// one of them is on the cell's side: the neighbour if the wall is between the cell and its sibling, at whose common face the coarse cell's own
/// centre lies. `fine`, `coarse`: elements of the axis' opacities; they hold the face above.
#[inline(always)]
fn other_weight(
    cell: u32,
    fine: u32,
    step: u32,
    coarse: u32,
    coarse_step: u32,
    opacity: &[f32],
    coarse_opacity: &[f32],
) -> f32 {
    let upper = cell & 1 == 1;
    let wall = coarse_opacity[(if upper { coarse } else { coarse - coarse_step }) as usize];
    let between = opacity[(if upper { fine - step } else { fine }) as usize];
    0.25 * (1.0 - wall) + wall * between
}

/// Linear along each axis between a coarse cell and its neighbour.
#[inline(always)]
fn interpolated(l: &LpvLayout, coarse: &[f32], base: u32, here: UVec3, other: UVec3, w: Vec3) -> f32 {
    let near = row(l, coarse, base, here.x, other.x, w.x, here.y, here.z) * (1.0 - w.y)
        + row(l, coarse, base, here.x, other.x, w.x, other.y, here.z) * w.y;
    let far = row(l, coarse, base, here.x, other.x, w.x, here.y, other.z) * (1.0 - w.y)
        + row(l, coarse, base, here.x, other.x, w.x, other.y, other.z) * w.y;
    near * (1.0 - w.z) + far * w.z
}

#[inline(always)]
fn row(l: &LpvLayout, coarse: &[f32], base: u32, x: u32, other: u32, weight: f32, y: u32, z: u32) -> f32 {
    coarse[(base + l.at(x, y, z)) as usize] * (1.0 - weight) + coarse[(base + l.at(other, y, z)) as usize] * weight
}

/// Coarse neighbour on the side of a fine cell; at the border the coarse cell itself.
#[inline(always)]
fn nearer(fine: u32, count: u32) -> u32 {
    let here = fine / 2;
    let above = (here + 1).min(count - 1);
    let below = here.max(1) - 1;
    if fine & 1 == 1 { above } else { below }
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
    let before = numbers(fine * PASSED_VALUES);
    let state = numbers(fine * STATE_VALUES);
    let passed = numbers(coarse * PASSED_VALUES);
    let opacity = super::case::opacity(input, &p);
    let coarse_opacity = super::case::opacity(input, &LpvParams { dims: p.coarse_dims, ..p });
    Case::default()
        .uniform(&p)
        .read(&before)
        .read(&state)
        .read(&passed)
        .read(&opacity)
        .read(&coarse_opacity)
        .zeroed::<f32>(before.len())
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
    read 4 opacity: f32;
    read 5 coarse_opacity: f32;
    write 6 out: f32;
    case super::prolong_case; tolerance Tolerance::RelAbs(2e-5, 1e-35), "products of positive numbers with weights that are differences from 1, which a device may fuse";
}
