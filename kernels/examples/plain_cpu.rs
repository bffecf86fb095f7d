//! Kernels as plain CPU functions, from this crate and its records alone: a triangle is voxelized and its occupancy
//! mipmapped, as `host/examples/embed.rs` does on a device with the compiled forms of the same kernels.

use core::sync::atomic::{AtomicU32, Ordering::Relaxed};
use interreflect_kernels::voxel::cells::{voxel_coarsen, voxel_union};
use interreflect_kernels::voxel::{grid, mark::voxel_mark, tile::GridTriangle};
use interreflect_shared::{scene::SceneTriangle, voxel::FACET_KINDS, voxel::VoxelParams};

fn main() {
    let (v0, v1, v2) = ([0.1, 0.2, 0.1], [0.9, 0.5, 0.2], [0.3, 0.6, 0.9]);
    let triangle = SceneTriangle { v0, material: 0, v1, flags: 0, v2, source: 0 };
    let mut params = grid::pyramid(glam::Vec3::ZERO, 1.0 / 64.0, glam::UVec3::splat(64));
    params.triangle_count = 1;
    params.tile_count = GridTriangle::new(&params, &triangle).tiles();

    // Voxelize: atomics, so that several threads may run pieces of it.
    let facet_bits: Vec<AtomicU32> = (0..params.levels[0].w * FACET_KINDS).map(|_| AtomicU32::new(0)).collect();
    voxel_mark::cpu(&params, &[triangle], &[0], &facet_bits);
    let facet_bits: Vec<u32> = facet_bits.iter().map(|word| word.load(Relaxed)).collect();

    // Mipmap: the levels of even and odd number lie in two buffers.
    let mut even = vec![0; params.even_cells as usize];
    let mut odd = vec![0; (grid::cell_count(&params) - params.even_cells) as usize];
    for level in 0..params.dims_levels.w {
        let table = params.levels[level as usize];
        let first = table.z - (level & 1) * params.even_cells;
        let pass = VoxelParams { level, first, count: table.w, ..params };
        match level {
            0 => voxel_union::cpu(&pass, &facet_bits, &mut even),
            _ if level & 1 == 1 => voxel_coarsen::cpu(&pass, &even, &mut odd),
            _ => voxel_coarsen::cpu(&pass, &odd, &mut even),
        }
        let cells = if level & 1 == 1 { &odd } else { &even };
        let cells = &cells[first as usize..(first + table.w) as usize];
        println!("level {level}: {} occupied voxels", cells.iter().map(|word| word.count_ones()).sum::<u32>());
    }
}
