//! From a grid to the next coarser one, and back.
//!
//! Every step of propagation blurs light's direction by the same angle, however small the cells: on a fine grid light that crosses a
//! room has lost its way. So light that has gone a few cells moves over to cells twice as large, as often as needed: the number of steps across a room grows
//! with the logarithm of the resolution instead of the resolution, and costs an eighth per level. (The papers' cascades are nested around the camera; ours are nested in extent and, within each, in
//! distance from the source.)
//!
//! `lpv_restrict`: one invocation adds up what travels in the eight cells below one coarse cell: flux and first moment, kept exactly. `lpv_prolong`: one
//! invocation adds what has passed through one channel on the coarser grid, trilinear (without cells behind walls) and per area of a cell's face, to what has passed on the finer one.
//!
//! Pass before: `propagate.rs` on the finer (`lpv_restrict`) or coarser (`lpv_prolong`) grid. Pass after: `propagate.rs` on the coarser grid; `gather.rs`.

use super::grid::{CellRow, cell_row, coarse_rows, rows};
use super::lobe::outflow;
use crate::kernel::At;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
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

/// What has passed through one channel of a cell: `keep` times an earlier total, its own, and the coarser grid's.
#[inline(always)]
pub fn prolong<R: Real>(
    at: At,
    p: &LpvParams,
    before: &[f32],
    state: &[f32],
    coarse: &[f32],
    opacity: &[f32],
    coarse_opacity: &[f32],
) -> [R; 6] {
    let l = LpvLayout::new(p.dims);
    let (i, value, front) = (at.i, l.value() as usize, (FRONT_VALUES * l.value()) as usize);
    let row = cell_row(at, p.dims, &l);
    let mut out = [R::splat(0.0); 6];
    if row.real {
        let keep = R::splat(p.keep);
        unroll!(J in 0, 1, 2, 3, 4, 5 => {
            out[J] = R::load(before, J * value + i) * keep + R::load(state, front + J * value + i);
        });
        if p.coarse_weight > 0.0 {
            let around = CoarseCells::<R>::new(at, &row, p, &l, opacity, coarse_opacity);
            let (share, coarse_value) = (R::splat(p.coarse_weight), LpvLayout::new(p.coarse_dims).value() as usize);
            unroll!(J in 0, 1, 2, 3, 4, 5 => {
                out[J] = out[J] + around.interpolated(coarse, J * coarse_value) * share;
            });
        }
    }
    out
}

/// The coarse cell around a fine one and its neighbours on the fine one's side.
struct CoarseCells<R> {
    /// Cell along x on the finer grid.
    x: usize,
    /// Elements of x = 0 in the cell's own layer: its own row and the one beside it.
    near: [usize; 2],
    /// The same in the layer beside it.
    far: [usize; 2],
    /// Weight of the neighbour along each axis.
    weight: [R; 3],
}

impl<R: Real> CoarseCells<R> {
    #[inline(always)]
    fn new(at: At, row: &CellRow, p: &LpvParams, l: &LpvLayout, opacity: &[f32], coarse_opacity: &[f32]) -> Self {
        let c = LpvLayout::new(p.coarse_dims);
        let (x, plane, coarse_plane) = (at.x as usize, l.plane as usize, c.plane as usize);
        let [y, z] = [row.y / 2, row.z / 2];
        let [beside_y, beside_z] = [nearer(row.y, p.coarse_dims.y), nearer(row.z, p.coarse_dims.z)];
        let element = at.i - row.channel as usize * plane;
        let here = c.at(0, y, z) as usize;
        // Faces are kept by the cell below them: the coarse one on the fine cell's side, and the one to its sibling.
        let odd = R::splat(0.5).lt(R::parity(x));
        let sibling = R::select(odd, R::load(opacity, element - 1), R::load(opacity, element));
        let along_x = other_weight(R::load_halved(coarse_opacity, here - 1, x + 1), sibling);
        let wall = coarse_plane + here - if row.y & 1 == 1 { 0 } else { c.pitch as usize };
        let sibling = plane + element - if row.y & 1 == 1 { l.pitch as usize } else { 0 };
        let along_y = other_weight(R::load_halved(coarse_opacity, wall, x), R::load(opacity, sibling));
        let wall = 2 * coarse_plane + here - if row.z & 1 == 1 { 0 } else { c.layer as usize };
        let sibling = 2 * plane + element - if row.z & 1 == 1 { l.layer as usize } else { 0 };
        let along_z = other_weight(R::load_halved(coarse_opacity, wall, x), R::load(opacity, sibling));
        // At the border the coarse cell stands for its neighbour.
        let cell_x = R::ramp(at.x as f32, 1.0);
        let last = R::splat(2.0 * p.coarse_dims.x as f32 - 1.5);
        let inside = R::select(cell_x.lt(R::splat(0.5)), R::splat(0.0), along_x);
        let along_x = R::select(last.lt(cell_x), R::splat(0.0), inside);
        let first = row.channel * c.plane;
        let near = [(first + c.at(0, y, z)) as usize, (first + c.at(0, beside_y, z)) as usize];
        let far = [(first + c.at(0, y, beside_z)) as usize, (first + c.at(0, beside_y, beside_z)) as usize];
        Self { x, near, far, weight: [along_x, along_y, along_z] }
    }

    /// A number of the coarser grid, whose elements begin at `base`: linear along each axis.
    #[inline(always)]
    fn interpolated(&self, coarse: &[f32], base: usize) -> R {
        let [x, y, z] = self.weight;
        let one = R::splat(1.0);
        let rows = [self.near[0], self.near[1], self.far[0], self.far[1]];
        let mut along_x = [x; 4];
        unroll!(K in 0, 1, 2, 3 => {
            along_x[K] = R::load_halved(coarse, base + rows[K], self.x) * (one - x) + R::load_beside(coarse, base + rows[K], self.x) * x;
        });
        let near = along_x[0] * (one - y) + along_x[1] * y;
        let far = along_x[2] * (one - y) + along_x[3] * y;
        near * (one - z) + far * z
    }
}

/// Weight of the coarse neighbour along one axis: ¼ in the open. Where a wall stands between the two coarse centres (`wall`:
/// its opacity) only one of them is on the cell's side: the neighbour if the wall is between the cell and its sibling
/// (`sibling`), at whose common face the coarse cell's own centre lies.
#[inline(always)]
fn other_weight<R: Real>(wall: R, sibling: R) -> R {
    R::splat(0.25) * (R::splat(1.0) - wall) + wall * sibling
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
    lanes mod lpv_prolong = super::prolong; entry "lpv_prolong" threads(64);
    uniform 0 params: LpvParams;
    read 1 before: f32;
    read 2 state: f32;
    read 3 coarse: f32;
    read 4 opacity: f32;
    read 5 coarse_opacity: f32;
    write 6 out: f32 x 6;
    over super::rows;
    case super::prolong_case; tolerance Tolerance::RelAbs(2e-5, 1e-35), "products of positive numbers with weights that are differences from 1, which a device may fuse";
}
