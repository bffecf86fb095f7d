//! Where the flux is: sums over columns of cells, for stopping and for the proof that none is made or lost.
//!
//! One invocation adds up one channel of one column along y: flux that will be sent (stored), the part of it that will leave
//! the grid, the part that opacities will absorb, and the largest of what travels and of what has passed in a cell. Grid:
//! columns (x, z) of each channel, lanes along x: what one of them reads after another lies side by side in memory. The host
//! adds columns in double precision. Pass before: `propagate.rs`.

use super::lobe::outflow;
use super::propagate::open_ways;
use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::real::Real;
#[cfg(not(target_arch = "spirv"))]
use interreflect_shared::lpv::LEDGER_VALUES;
use interreflect_shared::lpv::{LpvLayout, LpvParams};

/// One row per z and channel.
pub fn columns(p: &LpvParams) -> Rows {
    Rows { count: 3 * p.dims.z, len: p.dims.x, pitch: p.dims.x, first: 0, plane: 3 * p.dims.x * p.dims.z }
}

/// Sums of a column: flux stored, leaving, absorbed; largest travelling, largest passed flux (times `Y₀₀`).
#[inline(always)]
pub fn column<R: Real>(at: At, p: &LpvParams, state: &[f32], opacity: &[f32]) -> [R; 5] {
    let l = LpvLayout::new(p.dims);
    let value = l.value() as usize;
    let channel = at.row / p.dims.z;
    let z = at.row - channel * p.dims.z;
    let (zero, one) = (R::splat(0.0), R::splat(1.0));
    let x = R::ramp(at.x as f32, 1.0);
    // 1 where the neighbour on that side is outside.
    let low_x = R::select(x.lt(R::splat(0.5)), one, zero);
    let high_x = R::select(R::splat(p.dims.x as f32 - 1.5).lt(x), one, zero);
    let low_z = R::splat(if z == 0 { 1.0 } else { 0.0 });
    let high_z = R::splat(if z + 1 == p.dims.z { 1.0 } else { 0.0 });
    let (mut stored, mut leaving, mut absorbed, mut largest, mut passed) = (zero, zero, zero, zero, zero);
    for y in 0..p.dims.y {
        let i = l.at(at.x, y, z) as usize;
        let j = (channel * l.plane) as usize + i;
        let low_y = R::splat(if y == 0 { 1.0 } else { 0.0 });
        let high_y = R::splat(if y + 1 == p.dims.y { 1.0 } else { 0.0 });
        let mut outside = [high_x; 6];
        outside[1] = low_x;
        outside[2] = high_y;
        outside[3] = low_y;
        outside[4] = high_z;
        outside[5] = low_z;
        let open = open_ways::<R>(i, &l, p, opacity);
        let b = [R::load(state, j + value), R::load(state, j + 2 * value), R::load(state, j + 3 * value)];
        let sent = outflow(R::load(state, j), b);
        unroll!(K in 0, 1, 2, 3, 4, 5 => {
            leaving = sent.to[K].mul_add(outside[K], leaving);
            absorbed = (sent.to[K] * (one - outside[K])).mul_add(one - open[K], absorbed);
        });
        stored = stored + sent.flux;
        largest = largest.max(sent.flux);
        passed = passed.max(R::load(state, 5 * value + j));
    }
    [stored, leaving, absorbed, largest, passed]
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let p = super::case::params(input, super::case::side(input));
    let state = super::case::state(input, &p);
    let opacity = super::case::opacity(input, &p);
    Case::default().uniform(&p).read(&state).read(&opacity).zeroed::<f32>((columns(&p).plane * LEDGER_VALUES) as usize)
}

kernel! {
    /// Sums of flux over columns.
    lanes mod lpv_ledger = super::column; entry "lpv_ledger" threads(64);
    uniform 0 params: LpvParams;
    read 1 state: f32;
    read 2 opacity: f32;
    write 3 out: f32 x 5;
    over super::columns;
    case super::case; tolerance Tolerance::RelAbs(1e-4, 1e-5), "sums of up to 15 cells of 30 faces each; opacities by differences";
}
