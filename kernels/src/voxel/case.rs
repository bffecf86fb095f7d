//! Small voxel pyramids for the kernels' test cases, made by the kernels' own CPU functions.

use super::cells::{voxel_cells, voxel_children, voxel_coarsen, voxel_facet_count, voxel_popcount, voxel_union};
use super::facet::{voxel_accumulate, voxel_resolve};
use super::grid::{cell_count, pyramid};
use super::mark::{voxel_mark, voxel_tiles};
use super::mip::{voxel_mip, voxel_mip_base, voxel_mip_base_isotropic, voxel_mip_isotropic};
use crate::kernel::{Case, CaseInput, Flavour};
use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use glam::{UVec3, Vec3, Vec4};
use interreflect_shared::scene::{NO_TEXTURE, SRGB_TABLE_WORDS, SceneMaterial, SceneTriangle, TriangleAttributes};
use interreflect_shared::voxel::{FACET_KINDS, FACET_WORDS, VoxelFacet, VoxelParams};

/// A pyramid and everything on the way to it.
pub struct CasePyramid {
    /// Uniform with the counts filled in.
    pub params: VoxelParams,
    /// `count` triangles in and around the grid.
    pub triangles: Vec<SceneTriangle>,
    /// Texture coordinates.
    pub attributes: Vec<TriangleAttributes>,
    /// Two materials, one that emits.
    pub surfaces: Vec<u32>,
    /// Prefix sum of tiles.
    pub tile_first: Vec<u32>,
    /// Six words per cell of level 0.
    pub facet_bits: Vec<u32>,
    /// Bits of the even levels.
    pub even_bits: Vec<u32>,
    /// Bits of the odd levels.
    pub odd_bits: Vec<u32>,
    /// First facet of each cell of level 0.
    pub facet_ranks: Vec<u32>,
    /// First record of each cell of the even levels.
    pub even_ranks: Vec<u32>,
    /// First record of each cell of the odd levels.
    pub odd_ranks: Vec<u32>,
    /// Bits and ranks.
    pub cells: Vec<u32>,
    /// Children of the even levels' records.
    pub even_children: Vec<u32>,
    /// Children of the odd levels' records.
    pub odd_children: Vec<u32>,
    /// Fixed-point sums of the facets.
    pub sums: Vec<u32>,
    /// Facets.
    pub facets: Vec<VoxelFacet>,
    /// Radiance of fronts and backs.
    pub radiance: Vec<Vec4>,
    /// Values of the odd levels.
    pub odd_mips: Vec<Vec4>,
    /// Values of the even levels.
    pub even_mips: Vec<Vec4>,
}

/// Voxels of a small case's grid: no multiples of the bricks' sides.
const DIMS: UVec3 = UVec3::new(21, 13, 9);
/// Triangles that fill it.
const FILLING: usize = 1 << 12;

/// The grid grows with the triangles: a real mesh of more triangles is voxelized finer.
fn dims(count: usize) -> UVec3 {
    let scale = (count as f32 / FILLING as f32).cbrt().max(1.0);
    (DIMS.as_vec3() * scale).as_uvec3()
}

impl CasePyramid {
    /// Triangles of all sizes: points, slivers, voxel sides, and some that reach out of the grid.
    pub fn triangles(input: &mut CaseInput) -> Self {
        let size = match input.flavour {
            Flavour::Ordinary | Flavour::Zero => 0.25,
            Flavour::Tiny => 1.0 / 1_048_576.0,
            Flavour::Huge => 1_048_576.0,
        };
        let mut params = pyramid(Vec3::new(-1.0, 2.0, 0.5) * size, size, dims(input.count));
        params.triangle_count = input.count as u32;
        params.direction_count = if input.bits() & 1 == 0 { 6 } else { 1 };
        let triangles: Vec<SceneTriangle> = (0..input.count).map(|k| triangle(input, &params, k as u32)).collect();
        let attributes = (0..input.count)
            .map(|_| TriangleAttributes { uv: [(); 6].map(|()| input.unit()), normals: [0; 3], tints: [0; 3] })
            .collect();
        let empty = Vec::new;
        Self {
            params,
            triangles,
            attributes,
            surfaces: surfaces(),
            tile_first: empty(),
            facet_bits: empty(),
            even_bits: empty(),
            odd_bits: empty(),
            facet_ranks: empty(),
            even_ranks: empty(),
            odd_ranks: empty(),
            cells: empty(),
            even_children: empty(),
            odd_children: empty(),
            sums: empty(),
            facets: Vec::new(),
            radiance: Vec::new(),
            odd_mips: Vec::new(),
            even_mips: Vec::new(),
        }
    }

    /// With the work list.
    pub fn tiles(input: &mut CaseInput) -> Self {
        let mut c = Self::triangles(input);
        let mut counts = alloc::vec![0; c.triangles.len()];
        voxel_tiles::cpu(&c.params, &c.triangles, &mut counts);
        (c.tile_first, c.params.tile_count) = exclusive_sum(&counts);
        c
    }

    /// With occupancy, ranks and children.
    pub fn marked(input: &mut CaseInput) -> Self {
        let mut c = Self::tiles(input);
        let p = &c.params;
        let bits = atomics((p.levels[0].w * FACET_KINDS) as usize);
        voxel_mark::cpu(p, &c.triangles, &c.tile_first, &bits);
        c.facet_bits = plain(&bits);
        c.even_bits = alloc::vec![0; p.even_cells as usize];
        c.odd_bits = alloc::vec![0; (cell_count(p) - p.even_cells) as usize];
        voxel_union::cpu(&VoxelParams { count: p.levels[0].w, ..*p }, &c.facet_bits, &mut c.even_bits);
        for level in 1..p.dims_levels.w {
            let pass = c.level_pass(level);
            if level & 1 == 1 {
                voxel_coarsen::cpu(&pass, &c.even_bits, &mut c.odd_bits);
            } else {
                voxel_coarsen::cpu(&pass, &c.odd_bits, &mut c.even_bits);
            }
        }
        c.rank();
        c
    }

    fn rank(&mut self) {
        let p = self.params;
        let mut counts = alloc::vec![0; p.levels[0].w as usize];
        voxel_facet_count::cpu(&p, &self.facet_bits, &mut counts);
        (self.facet_ranks, self.params.facet_count) = exclusive_sum(&counts);
        let mut counts = alloc::vec![0; self.even_bits.len()];
        voxel_popcount::cpu(&VoxelParams { first: p.levels[0].w, ..p }, &self.even_bits, &mut counts);
        let even_count;
        (self.even_ranks, even_count) = exclusive_sum(&counts);
        let mut counts = alloc::vec![0; self.odd_bits.len()];
        voxel_popcount::cpu(&VoxelParams { first: 0, ..p }, &self.odd_bits, &mut counts);
        let odd_count;
        (self.odd_ranks, odd_count) = exclusive_sum(&counts);
        self.cells = alloc::vec![0; 2 * cell_count(&p) as usize];
        voxel_cells::cpu(
            &p,
            &self.even_bits,
            &self.odd_bits,
            &self.facet_ranks,
            &self.even_ranks,
            &self.odd_ranks,
            &mut self.cells,
        );
        self.even_children = alloc::vec![0; even_count as usize];
        self.odd_children = alloc::vec![0; odd_count as usize];
        voxel_children::cpu(&VoxelParams { level: 2, ..p }, &self.cells, &mut self.even_children);
        voxel_children::cpu(&VoxelParams { level: 1, ..p }, &self.cells, &mut self.odd_children);
    }

    /// With facets.
    pub fn resolved(input: &mut CaseInput) -> Self {
        let mut c = Self::marked(input);
        let sums = atomics((c.params.facet_count * FACET_WORDS + 1) as usize);
        voxel_accumulate::cpu(
            &c.params,
            &c.triangles,
            &c.attributes,
            &c.surfaces,
            &c.tile_first,
            &c.cells,
            &c.facet_bits,
            &sums,
        );
        c.sums = plain(&sums);
        c.facets = alloc::vec![bytemuck::Zeroable::zeroed(); c.params.facet_count as usize];
        voxel_resolve::cpu(&c.params, &c.cells, &c.facet_bits, &c.sums, &mut c.facets);
        c
    }

    /// With random radiance of the requested flavour (no less than zero) in every level.
    pub fn lit(input: &mut CaseInput) -> Self {
        let c = Self::resolved(input);
        c.with_light(input)
    }

    /// As [`Self::lit`], in six directions or in one.
    pub fn lit_along(input: &mut CaseInput, direction_count: u32) -> Self {
        let mut c = Self::resolved(input);
        c.params.direction_count = direction_count;
        c.with_light(input)
    }

    fn with_light(mut self, input: &mut CaseInput) -> Self {
        self.radiance = (0..2 * self.facets.len())
            .map(|_| Vec4::new(input.float().abs(), input.float().abs(), input.float().abs(), 0.0))
            .collect();
        let directions = self.params.direction_count as usize;
        self.odd_mips = alloc::vec![Vec4::ZERO; self.odd_children.len() * directions];
        self.even_mips = alloc::vec![Vec4::ZERO; self.even_children.len() * directions];
        self.make_base();
        for level in 2..self.params.dims_levels.w {
            let pass = self.record_pass(level);
            let (children, finer, out) = if level & 1 == 1 {
                (&self.odd_children, &self.even_mips, &mut self.odd_mips)
            } else {
                (&self.even_children, &self.odd_mips, &mut self.even_mips)
            };
            if directions == 1 {
                voxel_mip_isotropic::cpu(&pass, &self.cells, children, finer, out);
            } else {
                voxel_mip::cpu(&pass, &self.cells, children, finer, bytemuck::cast_slice_mut(out));
            }
        }
        self
    }

    fn make_base(&mut self) {
        let p = self.record_pass(1);
        let (cells, bits, facets) = (&self.cells, &self.facet_bits, &self.facets);
        let (radiance, children, out) = (&self.radiance, &self.odd_children, &mut self.odd_mips);
        if p.direction_count == 1 {
            voxel_mip_base_isotropic::cpu(&p, cells, bits, facets, radiance, children, out);
        } else {
            voxel_mip_base::cpu(&p, cells, bits, facets, radiance, children, bytemuck::cast_slice_mut(out));
        }
    }

    /// A level from `first` on; in a large case the first, which most of the work is on.
    pub fn some_level(&self, input: &mut CaseInput, first: u32) -> u32 {
        let any = first + input.bits() % (self.params.dims_levels.w - first);
        if input.count > FILLING { first } else { any }
    }

    /// The pass over a level's cells.
    pub fn level_pass(&self, level: u32) -> VoxelParams {
        level_pass(&self.params, level)
    }

    /// The pass over a level's records.
    pub fn record_pass(&self, level: u32) -> VoxelParams {
        let table = self.params.levels[level as usize];
        let rank = |cell: u32| self.cells[(2 * cell + 1) as usize];
        let first = rank(table.z);
        // The next level of the same parity, or the end of all.
        let next = level + 2;
        let end = if next < self.params.dims_levels.w {
            rank(self.params.levels[next as usize].z)
        } else if level & 1 == 1 {
            self.odd_children.len() as u32
        } else {
            self.even_children.len() as u32
        };
        VoxelParams { level, first, count: end - first, ..self.params }
    }

    /// Adds the six buffers of a `VoxelPyramid`.
    pub fn bind(&self, case: Case) -> Case {
        case.read(&self.cells)
            .read(&self.facet_bits)
            .read(&self.facets)
            .read(&self.radiance)
            .read(&self.odd_mips)
            .read(&self.even_mips)
    }
}

/// The pass over a level's cells, in the buffer of its parity.
pub fn level_pass(p: &VoxelParams, level: u32) -> VoxelParams {
    let table = p.levels[level as usize];
    let first = if level & 1 == 1 { table.z - p.even_cells } else { table.z };
    VoxelParams { level, first, count: table.w, ..*p }
}

fn exclusive_sum(counts: &[u32]) -> (Vec<u32>, u32) {
    let mut total = 0;
    let firsts = counts
        .iter()
        .map(|n| {
            let first = total;
            total += n;
            first
        })
        .collect();
    (firsts, total)
}

fn atomics(count: usize) -> Vec<AtomicU32> {
    (0..count).map(|_| AtomicU32::new(0)).collect()
}

fn plain(words: &[AtomicU32]) -> Vec<u32> {
    words.iter().map(|w| w.load(Relaxed)).collect()
}

fn triangle(input: &mut CaseInput, p: &VoxelParams, k: u32) -> SceneTriangle {
    let dims = Vec3::new(p.dims_levels.x as f32, p.dims_levels.y as f32, p.dims_levels.z as f32);
    let kind = input.bits() % 4;
    let mut point = || Vec3::new(input.unit(), input.unit(), input.unit());
    let centre = point() * dims * 1.2 - 0.1 * dims;
    let spread = [0.2, 3.0, 30.0, 12.0][kind as usize];
    let mut corners = [(); 3].map(|()| centre + (point() - 0.5) * spread);
    if kind == 2 {
        // Thin: two corners all but coincide.
        corners[1] = corners[0] + (corners[1] - corners[0]) * 1e-3;
    }
    if kind == 3 {
        // In a plane between voxels.
        corners = corners.map(|c| Vec3::new(c.x, 4.0, c.z));
    }
    let [a, b, c] = corners.map(|c| (p.origin_size.truncate() + c * p.origin_size.w).to_array());
    SceneTriangle { v0: a, material: k & 1, v1: b, flags: 0, v2: c, source: k }
}

fn surfaces() -> Vec<u32> {
    let mut words = alloc::vec![0; SRGB_TABLE_WORDS as usize];
    for emission in [[0.0; 3], [1.0, 0.5, 0.25]] {
        let material = SceneMaterial {
            albedo: [0.75, 0.5, 0.25],
            texture_first: NO_TEXTURE,
            emission,
            texture_size: 0,
            alpha_factor: 1.0,
            alpha_cutoff: -1.0,
            metallic: 0.0,
            roughness: 1.0,
        };
        words.extend_from_slice(bytemuck::cast_slice(&[material]));
    }
    words
}
