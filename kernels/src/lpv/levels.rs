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
use super::propagate::AHEAD;
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
            unroll!(K in 0, 1, 2 => { out[1 + K] = sent.moment[K].mul_add(factor, out[1 + K]); });
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
        unroll!(J in 0, 1, 2, 3, 4, 5 => {
            R::prefetch(before, J * value + i + AHEAD);
            R::prefetch(state, front + J * value + i + AHEAD);
        });
        let keep = R::splat(p.keep);
        unroll!(J in 0, 1, 2, 3, 4, 5 => {
            out[J] = R::load(before, J * value + i).mul_add(keep, R::load(state, front + J * value + i));
        });
        if p.coarse_weight > 0.0 {
            let around = CoarseCells::<R>::new(at, &row, p, &l, opacity, coarse_opacity);
            let (share, coarse_value) = (R::splat(p.coarse_weight), LpvLayout::new(p.coarse_dims).value() as usize);
            unroll!(J in 0, 1, 2, 3, 4, 5 => {
                out[J] = around.interpolated(coarse, J * coarse_value).mul_add(share, out[J]);
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
    /// Shares along each axis.
    shares: [Shares<R>; 3],
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
        let odd = R::splat(0.5).lt(R::parity(x));
        let sibling = R::select(odd, R::load(opacity, element - 1), R::load(opacity, element));
        let beyond = R::select(odd, R::load(opacity, element + 1), R::load(opacity, element - 2));
        let along_x = Shares::new(R::load_halved(coarse_opacity, here - 1, x + 1), sibling, beyond);
        let f = faces(row.y, l.pitch as usize, c.pitch as usize);
        let wall = R::load_halved(coarse_opacity, coarse_plane + here - f.wall, x);
        let next = plane + element + l.pitch as usize;
        let along_y = Shares::new(wall, R::load(opacity, next - f.sibling), R::load(opacity, next - f.beyond));
        let f = faces(row.z, l.layer as usize, c.layer as usize);
        let wall = R::load_halved(coarse_opacity, 2 * coarse_plane + here - f.wall, x);
        let next = 2 * plane + element + l.layer as usize;
        let along_z = Shares::new(wall, R::load(opacity, next - f.sibling), R::load(opacity, next - f.beyond));
        // At the border the coarse cell stands for its neighbour.
        let cell_x = R::ramp(at.x as f32, 1.0);
        let last = R::splat(2.0 * p.coarse_dims.x as f32 - 1.5);
        let along_x = along_x.here_alone(cell_x.lt(R::splat(0.5))).here_alone(last.lt(cell_x));
        let first = row.channel * c.plane;
        let near = [(first + c.at(0, y, z)) as usize, (first + c.at(0, beside_y, z)) as usize];
        let far = [(first + c.at(0, y, beside_z)) as usize, (first + c.at(0, beside_y, beside_z)) as usize];
        Self { x, near, far, shares: [along_x, along_y, along_z] }
    }

    /// A number of the coarser grid, whose elements begin at `base`: linear along each axis.
    #[inline(always)]
    fn interpolated(&self, coarse: &[f32], base: usize) -> R {
        let [x, y, z] = self.shares;
        let rows = [self.near[0], self.near[1], self.far[0], self.far[1]];
        let mut along_x = [x.here; 4];
        unroll!(K in 0, 1, 2, 3 => {
            let i = base + rows[K];
            let beside = R::load_beside(coarse, i, self.x) * x.beside;
            along_x[K] = R::load_halved(coarse, i, self.x).mul_add(x.here, beside);
        });
        let near = along_x[0].mul_add(y.here, along_x[1] * y.beside);
        let far = along_x[2].mul_add(y.here, along_x[3] * y.beside);
        near.mul_add(z.here, far * z.beside)
    }
}

/// Shares of a coarse cell and of its neighbour along one axis.
#[derive(Clone, Copy)]
struct Shares<R> {
    here: R,
    beside: R,
}

impl<R: Real> Shares<R> {
    /// The neighbour's is ¼ in the open. Where a wall stands between the two coarse centres (`wall`: its opacity) only one of
    /// them is on the cell's side: the neighbour if the wall is between the cell and its sibling (`sibling`), at whose
    /// common face the coarse cell's own centre lies. If another stands there in the neighbour (`beyond`), the cell is between
    /// the two faces of a wall, and neither centre is with it.
    #[inline(always)]
    fn new(wall: R, sibling: R, beyond: R) -> Self {
        let one = R::splat(1.0);
        let (open, over) = (R::splat(0.25) * (one - wall), wall * sibling);
        Self { here: one - (open + over), beside: open + over * (one - beyond) }
    }
    #[inline(always)]
    fn here_alone(self, mask: R::Mask) -> Self {
        Self { here: R::select(mask, R::splat(1.0), self.here), beside: R::select(mask, R::splat(0.0), self.beside) }
    }
}

/// Where the faces of [`Shares::new`] lie along an axis whose cells are `step` elements apart (`coarse_step` on the coarser
/// grid). Faces are kept by the cell below them.
struct Faces {
    /// Elements from the coarse cell back to the wall's face.
    wall: usize,
    /// Elements from the next cell back to the face to the sibling.
    sibling: usize,
    /// The same to the neighbour's own face between siblings; any other face where there is no neighbour.
    beyond: usize,
}

#[inline(always)]
fn faces(cell: u32, step: usize, coarse_step: usize) -> Faces {
    let odd = cell & 1 == 1;
    Faces {
        wall: if odd { 0 } else { coarse_step },
        sibling: if odd { 2 * step } else { step },
        beyond: if odd {
            0
        } else if cell >= 2 {
            3 * step
        } else {
            step
        },
    }
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
