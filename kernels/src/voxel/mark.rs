//! Conservative voxelization, first pass: which kinds of facet does each voxel hold?
//!
//! `voxel_tiles`: one invocation counts the tiles of one triangle. After a prefix sum, `voxel_mark`: one invocation walks
//! one tile and sets a bit for every voxel that the triangle touches, in the plane of bits of the triangle's facet kind.
//!
//! Schwarz & Seidel 2010 (conservative surface voxelization), with Akenine-Möller's test. Pass before: none. Pass after:
//! the pyramid's occupancy (`cells.rs`).

#[cfg(not(target_arch = "spirv"))]
use super::case::CasePyramid;
use super::grid::{facet_kind, last_at_most, place};
use super::tile::{GridTriangle, TileWalk};
use crate::kernel::AtomicWords;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use interreflect_shared::scene::SceneTriangle;
use interreflect_shared::voxel::{FACET_KINDS, VoxelParams};

/// Number of tiles of a triangle.
#[inline(always)]
pub fn tiles(i: u32, p: &VoxelParams, triangles: &[SceneTriangle]) -> u32 {
    GridTriangle::new(p, &triangles[i as usize]).tiles()
}

/// Invocations of passes over tiles.
pub fn tile_items(p: &VoxelParams) -> u32 {
    p.tile_count
}

/// Triangle that owns a tile. `tile_first`: exclusive prefix sum of [`tiles`].
#[inline(always)]
pub fn tile_owner(p: &VoxelParams, tile_first: &[u32], tile: u32) -> u32 {
    last_at_most(tile_first, 0, p.triangle_count, 1, 0, tile)
}

/// Sets the bits of the voxels of one tile. `facet_bits`: six words per cell of level 0, one per facet kind.
#[inline(always)]
pub fn mark(
    i: u32,
    p: &VoxelParams,
    triangles: &[SceneTriangle],
    tile_first: &[u32],
    facet_bits: &mut impl AtomicWords,
) {
    let owner = tile_owner(p, tile_first, i);
    let triangle = GridTriangle::new(p, &triangles[owner as usize]);
    let kind = facet_kind(triangle.normal);
    let mut walk = TileWalk::new(triangle, i - tile_first[owner as usize]);
    while walk.advance() {
        let voxel = walk.voxel();
        let at = place(p.levels[0], voxel.x, voxel.y, voxel.z);
        facet_bits.or(at.cell * FACET_KINDS + kind, 1 << at.bit);
    }
}

#[cfg(not(target_arch = "spirv"))]
fn tiles_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::triangles(input);
    Case::default().uniform(&pyramid.params).read(&pyramid.triangles).zeroed::<u32>(pyramid.triangles.len())
}

#[cfg(not(target_arch = "spirv"))]
fn mark_case(input: &mut CaseInput) -> Case {
    let pyramid = CasePyramid::tiles(input);
    let words = (pyramid.params.levels[0].w * FACET_KINDS) as usize;
    Case::default().uniform(&pyramid.params).read(&pyramid.triangles).read(&pyramid.tile_first).zeroed::<u32>(words)
}

kernel! {
    /// Tiles per triangle.
    mod voxel_tiles = super::tiles; entry "voxel_tiles" threads(64);
    uniform 0 params: VoxelParams;
    read 1 triangles: SceneTriangle;
    write 2 out: u32;
    case super::tiles_case; tolerance Tolerance::Exact, "integers from the same float operations";
}

scatter! {
    /// Occupancy per facet kind.
    mod voxel_mark = super::mark; entry "voxel_mark" threads(64);
    uniform 0 params: VoxelParams; items super::tile_items;
    read 1 triangles: SceneTriangle;
    read 2 tile_first: u32;
    atomic 3 facet_bits;
    case super::mark_case; tolerance Tolerance::Exact, "bits from the same float operations";
}
