//! Occupancy of the pyramid: bits and ranks of every level, and where each record's children lie.
//!
//! `voxel_union`: one invocation joins the six kinds of one cell of level 0. `voxel_coarsen`: one invocation makes the bits
//! of one cell of a level from the eight cells below it. `voxel_facet_count` and `voxel_popcount` count what each cell
//! owns; prefix sums make ranks of them; `voxel_cells` interleaves bits and ranks. `voxel_children`: one invocation finds
//! the byte of bits below one record.
//!
//! The bits of even and of odd levels lie in two buffers, so that a pass reads one and writes the other.

#[cfg(not(target_arch = "spirv"))]
use super::case::CasePyramid;
use super::grid::{Grid, last_at_most, level_dims, nth_set_bit, place, voxel_of};
use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use glam::UVec3;
use interreflect_shared::voxel::{FACET_KINDS, VoxelParams};

/// Elements that a pass over a range writes.
pub fn pass_rows(p: &VoxelParams) -> Rows {
    Rows::range(p.first, p.count)
}

/// Bits of one cell of level 0: voxels that hold any facet.
#[inline(always)]
pub fn union(i: u32, _p: &VoxelParams, facet_bits: &[u32]) -> u32 {
    let first = (i * FACET_KINDS) as usize;
    let mut bits = 0;
    for kind in 0..FACET_KINDS as usize {
        bits |= facet_bits[first + kind];
    }
    bits
}

/// Bits of cell `i` of level `p.level` from the cells of the level below (`finer`: the buffer that holds its parity).
#[inline(always)]
pub fn coarsen(i: u32, p: &VoxelParams, finer: &[u32]) -> u32 {
    let level = p.level(p.level);
    let below = p.level(p.level - 1);
    // Cells of odd levels are counted from the first odd one.
    let base = if p.level & 1 == 1 { 0 } else { p.even_cells };
    let corner = voxel_of(level, i, 0) * 2;
    let dims = level_dims(p, p.level - 1);
    let mut bits = 0;
    for cell in 0..8u32 {
        let (dx, dy, dz) = (cell & 1, cell >> 1 & 1, cell >> 2);
        let (x, y, z) = (corner.x + dx * 4, corner.y + dy * 4, corner.z + dz * 2);
        if x < dims.x && y < dims.y && z < dims.z {
            let word = finer[(place(below, x, y, z).cell - base) as usize];
            // Four bytes below make four voxels: x, y of the byte are bits 0, 1 of the place, z comes from the cell.
            let quad = (word & 0xFF != 0) as u32
                | ((word >> 8 & 0xFF != 0) as u32) << 1
                | ((word >> 16 & 0xFF != 0) as u32) << 2
                | ((word >> 24 != 0) as u32) << 3;
            bits |= quad << (8 * (dx + 2 * dy) + 4 * dz);
        }
    }
    bits
}

/// Facets of one cell of level 0; nothing beyond the last one.
#[inline(always)]
pub fn facet_count(i: u32, p: &VoxelParams, facet_bits: &[u32]) -> u32 {
    if i >= p.levels[0].w {
        return 0;
    }
    let first = (i * FACET_KINDS) as usize;
    let mut count = 0;
    for kind in 0..FACET_KINDS as usize {
        count += facet_bits[first + kind].count_ones();
    }
    count
}

/// Occupied voxels of one cell of level ≥ 1; nothing for the cells before `p.first` (level 0 among the even levels).
#[inline(always)]
pub fn popcount(i: u32, p: &VoxelParams, bits: &[u32]) -> u32 {
    if i < p.first { 0 } else { bits[i as usize].count_ones() }
}

/// Word `i` of the cells: bits in even words, rank in odd ones. The rank is the number of the cell's first facet on level
/// 0 and of its first record within the levels ≥ 1 of its parity otherwise.
#[inline(always)]
pub fn cells(
    i: u32,
    p: &VoxelParams,
    even_bits: &[u32],
    odd_bits: &[u32],
    facet_ranks: &[u32],
    even_ranks: &[u32],
    odd_ranks: &[u32],
) -> u32 {
    let cell = i / 2;
    let is_rank = i & 1 == 1;
    if cell >= p.even_cells {
        let k = (cell - p.even_cells) as usize;
        return if is_rank { odd_ranks[k] } else { odd_bits[k] };
    }
    let k = cell as usize;
    if !is_rank {
        even_bits[k]
    } else if cell < p.levels[0].w {
        facet_ranks[k]
    } else {
        even_ranks[k]
    }
}

/// Cell and byte below record `p.first + i` of the levels ≥ 1 of one parity: `4·cell + byte`. `p.level` is 2 for even, 1
/// for odd levels; `cells` as made by [`cells`].
#[inline(always)]
pub fn children(i: u32, p: &VoxelParams, cells: &[u32]) -> u32 {
    let first = p.level(p.level).z;
    let end = if p.level & 1 == 1 { (cells.len() / 2) as u32 } else { p.even_cells };
    let cell = last_at_most(cells, first, end - first, 2, 1, i);
    let bit = nth_set_bit(cells[(2 * cell) as usize], i - cells[(2 * cell + 1) as usize]);
    let mut level = p.level;
    while level + 2 < p.dims_levels.w && p.level(level + 2).z <= cell {
        level += 2;
    }
    let table = p.level(level);
    let voxel: UVec3 = voxel_of(table, cell - table.z, bit) * 2;
    let below = place(p.level(level - 1), voxel.x, voxel.y, voxel.z);
    below.cell * 4 + below.bit / 8
}

#[cfg(not(target_arch = "spirv"))]
fn union_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    let cells = pyramid.params.levels[0].w;
    let params = VoxelParams { count: cells, ..pyramid.params };
    Case::default().uniform(&params).read(&pyramid.facet_bits).zeroed::<u32>(params.even_cells as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn coarsen_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    let level = pyramid.some_level(input, 1);
    let params = pyramid.level_pass(level);
    let (finer, coarser) =
        if level & 1 == 1 { (&pyramid.even_bits, &pyramid.odd_bits) } else { (&pyramid.odd_bits, &pyramid.even_bits) };
    Case::default().uniform(&params).read(finer).zeroed::<u32>(coarser.len())
}

#[cfg(not(target_arch = "spirv"))]
fn facet_count_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    Case::default()
        .uniform(&pyramid.params)
        .read(&pyramid.facet_bits)
        .zeroed::<u32>(pyramid.params.levels[0].w as usize)
}

#[cfg(not(target_arch = "spirv"))]
fn popcount_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    let params = VoxelParams { first: pyramid.params.levels[0].w, ..pyramid.params };
    Case::default().uniform(&params).read(&pyramid.even_bits).zeroed::<u32>(pyramid.even_bits.len())
}

#[cfg(not(target_arch = "spirv"))]
fn cells_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    Case::default()
        .uniform(&pyramid.params)
        .read(&pyramid.even_bits)
        .read(&pyramid.odd_bits)
        .read(&pyramid.facet_ranks)
        .read(&pyramid.even_ranks)
        .read(&pyramid.odd_ranks)
        .zeroed::<u32>(pyramid.cells.len())
}

#[cfg(not(target_arch = "spirv"))]
fn children_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::marked(input);
    let level = 1 + input.bits() % 2;
    let count = if level == 1 { pyramid.odd_children.len() } else { pyramid.even_children.len() };
    Case::default().uniform(&VoxelParams { level, ..pyramid.params }).read(&pyramid.cells).zeroed::<u32>(count)
}

kernel! {
    /// Occupancy of level 0.
    mod voxel_union = super::union; entry "voxel_union" threads(64);
    uniform 0 params: VoxelParams;
    read 1 facet_bits: u32;
    write 2 out: u32;
    over super::pass_rows;
    case super::union_case; tolerance Tolerance::Exact, "integers";
}

kernel! {
    /// Occupancy of a level from the level below.
    mod voxel_coarsen = super::coarsen; entry "voxel_coarsen" threads(64);
    uniform 0 params: VoxelParams;
    read 1 finer: u32;
    write 2 out: u32;
    over super::pass_rows;
    case super::coarsen_case; tolerance Tolerance::Exact, "integers";
}

kernel! {
    /// Facets per cell of level 0.
    mod voxel_facet_count = super::facet_count; entry "voxel_facet_count" threads(64);
    uniform 0 params: VoxelParams;
    read 1 facet_bits: u32;
    write 2 out: u32;
    case super::facet_count_case; tolerance Tolerance::Exact, "integers";
}

kernel! {
    /// Occupied voxels per cell.
    mod voxel_popcount = super::popcount; entry "voxel_popcount" threads(64);
    uniform 0 params: VoxelParams;
    read 1 bits: u32;
    write 2 out: u32;
    case super::popcount_case; tolerance Tolerance::Exact, "integers";
}

kernel! {
    /// Bits and ranks of every cell.
    mod voxel_cells = super::cells; entry "voxel_cells" threads(64);
    uniform 0 params: VoxelParams;
    read 1 even_bits: u32;
    read 2 odd_bits: u32;
    read 3 facet_ranks: u32;
    read 4 even_ranks: u32;
    read 5 odd_ranks: u32;
    write 6 out: u32;
    case super::cells_case; tolerance Tolerance::Exact, "integers";
}

kernel! {
    /// Where each record's children lie.
    mod voxel_children = super::children; entry "voxel_children" threads(64);
    uniform 0 params: VoxelParams;
    read 1 cells: u32;
    write 2 out: u32;
    case super::children_case; tolerance Tolerance::Exact, "integers";
}
