//! Grids, texels and states for the kernels' test cases.

use super::inject::LOBE_MOMENT;
use super::lobe::{Lobes, travel};
use crate::kernel::{CaseInput, Flavour};
use alloc::vec::Vec;
use glam::{IVec4, UVec4, Vec3, Vec4};
use interreflect_shared::lpv::*;
use interreflect_shared::voxel::VoxelParams;

/// Side of a grid of about `count` cells.
pub fn side(input: &CaseInput) -> u32 {
    let mut side = 1;
    while (side * side * side) < input.count as u32 {
        side += 1;
    }
    // Even, so that there is a coarser grid; and rows that are no whole number of vectors.
    side + (side & 1)
}

/// A grid of `side` × (`side` + 2) × `side` cells, each of 2⁻⁴ of the scene of a case.
pub fn params(input: &mut CaseInput, side: u32) -> LpvParams {
    let moments = input.bits() & 1 == 0;
    LpvParams {
        anchor_size: Vec4::new(-1.0, -1.0, -1.0, 0.25),
        first_cell: IVec4::new(0, -1, 1, 0),
        dims: if input.count == 0 { UVec4::ZERO } else { UVec4::new(side, side + 2, side, 0) },
        coarse_dims: if input.count == 0 { UVec4::ZERO } else { UVec4::new(side / 2, side / 2 + 1, side / 2, 0) },
        lobe: if moments {
            Vec4::new(1.0, super::lobe::ALONG, super::lobe::ACROSS, 1.0)
        } else {
            Vec4::new(LOBE_MOMENT, 0.0, LOBE_MOMENT, 0.0)
        },
        count: input.count as u32,
        focus: if moments { 0.85 } else { 0.0 },
        flux_scale: 1e4,
        occlusion: 0.75,
        gain: (input.bits() & 1) as f32,
        weight: 0.5,
        keep: 0.5,
        coarse_weight: 0.25,
        voxel_size: 0.125,
        half_scale: 64.0,
        opacity_sources: 3,
        streams: if moments { 6 } else { 1 },
        stream: 0,
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
        fade: Vec4::new(0.0, 0.0, 0.0, 3.0),
    }
}

/// A grid of cells of two voxels over most of a voxelized scene, some of it on each side left out.
pub fn params_over(input: &mut CaseInput, voxels: &VoxelParams) -> LpvParams {
    let side = (voxels.dims_levels.x * 3 / 8).next_multiple_of(2);
    let p = params(input, side);
    let grid = voxels.origin_size;
    LpvParams { anchor_size: grid.truncate().extend(grid.w * 2.0), voxel_size: grid.w, ..p }
}

/// `count` texels in and around a grid.
pub fn texels(input: &mut CaseInput, p: &LpvParams) -> Vec<RsmTexel> {
    (0..input.count)
        .map(|_| {
            let at = Vec3::new(input.unit(), input.unit(), input.unit()) * 1.2 - 0.1;
            let extent = Vec3::new(p.dims.x as f32, p.dims.y as f32, p.dims.z as f32) * p.anchor_size.w;
            RsmTexel {
                position: (p.anchor_size.truncate() + at * extent).to_array(),
                area: input.unit() * 0.1,
                normal: input.direction().to_array(),
                hit: (input.bits() & 3 > 0) as u32,
                flux: [(); 3].map(|()| input.float().abs().min(1e9)),
                _pad0: 0,
                albedo: [(); 3].map(|()| input.unit()),
                _pad1: 0,
            }
        })
        .collect()
}

/// Whether a cell is lit: in huge cases such that no cell has two lit neighbours, since sums of huge numbers of both
/// signs have no digit in common on two devices.
fn lit(input: &CaseInput, x: u32, y: u32, z: u32) -> bool {
    input.flavour != Flavour::Huge || (x + 2 * y + 3 * z).is_multiple_of(7)
}

/// Flux and moments of the cells of a grid, zero in the halo.
pub fn source(input: &mut CaseInput, p: &LpvParams) -> Vec<f32> {
    let l = LpvLayout::new(p.dims);
    let value = l.value() as usize;
    let mut source = alloc::vec![0.0; FLUX_VALUES as usize * value];
    let d = p.dims;
    for (z, y, x) in (0..d.z).flat_map(|z| (0..d.y).flat_map(move |y| (0..d.x).map(move |x| (z, y, x)))) {
        for channel in 0..3 {
            let flux = input.float().abs();
            let f = match input.flavour {
                // No component near zero.
                Flavour::Huge => Vec3::new(0.5, -0.35, 0.4),
                _ => input.direction() * input.unit(),
            };
            if lit(input, x, y, z) {
                let i = (channel * l.plane + l.at(x, y, z)) as usize;
                source[i] = flux;
                (0..3).for_each(|k| source[i + (k + 1) * value] = flux * f[k]);
            }
        }
    }
    source
}

/// Light that travels and has passed.
pub fn state(input: &mut CaseInput, p: &LpvParams) -> Vec<f32> {
    let value = LpvLayout::new(p.dims).value() as usize;
    let source = source(input, p);
    let mut state = alloc::vec![0.0; STATE_VALUES as usize * value];
    for i in (0..value).filter(|&i| source[i] > 0.0) {
        let flux = [source[i], source[i + value], source[i + 2 * value], source[i + 3 * value]];
        let t = travel::<f32>(flux, &Lobes::of(p));
        let front = [t.a, t.b[0], t.b[1], t.b[2], t.moment_factor];
        front.iter().chain(&t.passed).enumerate().for_each(|(k, v)| state[k * value + i] = *v);
    }
    state
}

/// Opacities.
pub fn opacity(input: &mut CaseInput, p: &LpvParams) -> Vec<f32> {
    (0..OPACITY_PLANES * LpvLayout::new(p.dims).plane).map(|_| input.unit()).collect()
}
