//! Directions to a table of basis functions.
//!
//! One invocation: four basis functions `k = 4·block … 4·block + 3` at one direction, times that direction's weight.
//! Grid: directions × blocks. The table is `[k % 4][k / 4][direction]`; functions beyond the order are 0.
//! Next pass: [`super::project`].

use super::block_functions;
use crate::kernel::{At, Rows};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Flavour, Tolerance};
use crate::real::Real;
use interreflect_shared::sh::{SH_BLOCK, ShLayout, ShParams};

/// One row per block, as long as there are directions.
pub fn rows(p: &ShParams) -> Rows {
    let (count, len) = (ShLayout::new(1, p.order).blocks, p.sample_count);
    Rows { count, len, pitch: len, first: 0, plane: count * len }
}

/// Index of basis function `k` at a direction in the table.
#[inline(always)]
pub const fn table_index(k: u32, direction: u32, p: &ShParams) -> usize {
    let blocks = ShLayout::new(1, p.order).blocks;
    (((k % SH_BLOCK) * blocks + k / SH_BLOCK) * p.sample_count + direction) as usize
}

/// Four basis functions at one direction. `directions`: unit vectors and weights in planes `[x, y, z, weight][direction]`.
#[inline(always)]
pub fn table<R: Real>(at: At, p: &ShParams, directions: &[f32]) -> [R; 4] {
    let (n, i) = (p.sample_count as usize, at.x as usize);
    let direction = [R::load(directions, i), R::load(directions, n + i), R::load(directions, 2 * n + i)];
    let weight = R::load(directions, 3 * n + i);
    let y = block_functions(at.row, p.order);
    [
        weight * y[0].value(direction),
        weight * y[1].value(direction),
        weight * y[2].value(direction),
        weight * y[3].value(direction),
    ]
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    // A large case is what a probe's rays need at the papers' sizes; no table is larger.
    let (count, any) = (input.count.min(8192), super::case_order(input));
    let order = if input.is_large() { 7 } else { any };
    let p = ShParams { element_count: 0, sample_count: count as u32, order, weight: 0.0 };
    let mut directions = alloc::vec![0.0; 4 * count];
    for i in 0..count {
        let d = input.direction().to_array();
        (0..3).for_each(|axis| directions[axis * count + i] = d[axis]);
        // Not huge: near a zero of a function only its absolute error is small.
        directions[3 * count + i] = if input.flavour == Flavour::Huge { input.unit() } else { input.float() };
    }
    let len = rows(&p).plane as usize * SH_BLOCK as usize;
    Case::default().uniform(&p).read(&directions).zeroed::<f32>(len)
}

kernel! {
    /// Directions to basis functions.
    lanes mod sh_basis = super::table; entry "sh_basis" threads(64);
    uniform 0 params: ShParams;
    read 1 directions: f32;
    write 2 table: f32 x 4;
    over super::rows;
    case super::case; tolerance Tolerance::RelAbs(1e-5, 4e-6), "up to 9 steps of a recurrence, each of which a device may fuse, with values up to 3";
}
