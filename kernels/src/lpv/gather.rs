//! Light at surface points: one invocation is one receiver.
//!
//! `lpv_gather` reads floats, `lpv_gather_half` packed half floats ([`super::query`]). Up to four nested grids, finest first; near the border
//! of one the next takes over. `lpv_pack`: one invocation packs two coefficients. Grid: receivers. Pass before: `levels.rs`.

use super::query::{Coefficients, Floats, Grid, Halves, coverage, irradiance};
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::pack::pack_f16x2;
use glam::{Vec3, Vec4};
use interreflect_shared::lpv::{LpvLayout, LpvParams, LpvQuery};
use interreflect_shared::scene::{NO_SURFACE, Surfel};

#[inline(always)]
fn grid(p: &LpvQuery, cascade: usize) -> Grid {
    Grid { anchor_size: p.anchor_size[cascade], first_cell: p.first_cell[cascade], dims: p.dims[cascade] }
}

/// Adds a cascade's light with what is left of the weight.
#[inline(always)]
fn add<C: Coefficients>(p: &LpvQuery, cascade: usize, c: &C, s: &Surfel, sum: Vec4) -> Vec4 {
    if cascade as u32 >= p.cascade_count || sum.w <= 0.0 {
        return sum;
    }
    let g = grid(p, cascade);
    let (position, normal) = (Vec3::from_array(s.position), Vec3::from_array(s.normal));
    // The last one holds to its very border.
    let blend = if cascade as u32 + 1 == p.cascade_count { 0.0 } else { p.blend };
    let weight = sum.w * coverage(&g, position, blend);
    if weight <= 0.0 {
        return sum;
    }
    (sum.truncate() + irradiance(&g, c, position, normal, p.offset) * weight).extend(sum.w - weight)
}

/// Indirect irradiance (W/m², w = 0) at surface point `i`.
#[inline(always)]
pub fn gather(i: u32, p: &LpvQuery, a: &[f32], b: &[f32], c: &[f32], d: &[f32], surfels: &[Surfel]) -> Vec4 {
    let s = surfels[i as usize];
    if s.triangle == NO_SURFACE {
        return Vec4::ZERO;
    }
    let mut sum = add(p, 0, &Floats(a), &s, Vec4::W);
    sum = add(p, 1, &Floats(b), &s, sum);
    sum = add(p, 2, &Floats(c), &s, sum);
    sum = add(p, 3, &Floats(d), &s, sum);
    sum.truncate().extend(0.0)
}

/// The same from packed half floats.
#[inline(always)]
pub fn gather_half(i: u32, p: &LpvQuery, a: &[u32], b: &[u32], c: &[u32], d: &[u32], surfels: &[Surfel]) -> Vec4 {
    let s = surfels[i as usize];
    if s.triangle == NO_SURFACE {
        return Vec4::ZERO;
    }
    let scale = 1.0 / p.half_scale;
    let mut sum = add(p, 0, &Halves(a, scale), &s, Vec4::W);
    sum = add(p, 1, &Halves(b, scale), &s, sum);
    sum = add(p, 2, &Halves(c, scale), &s, sum);
    sum = add(p, 3, &Halves(d, scale), &s, sum);
    sum.truncate().extend(0.0)
}

/// Word `i`: coefficients 0 and 1, 2 and 3, or 4 and 5, of one channel of one cell.
#[inline(always)]
pub fn pack(i: u32, p: &LpvParams, coefs: &[f32]) -> u32 {
    let value = LpvLayout::new(p.dims).value();
    let pair = i / value;
    let first = (i + pair * value) as usize;
    pack_f16x2(coefs[first] * p.half_scale, coefs[first + value as usize] * p.half_scale)
}

#[cfg(not(target_arch = "spirv"))]
mod cases {
    use super::*;
    use crate::kernel::Flavour;
    use alloc::vec::Vec;
    use interreflect_shared::lpv::PASSED_VALUES;

    fn query(input: &mut CaseInput) -> (LpvQuery, Vec<Surfel>) {
        let p = super::super::case::params(input, 6);
        let dims = if input.count == 0 { glam::UVec4::new(2, 2, 2, 0) } else { p.dims };
        let anchors = [0, 1, 2, 3].map(|k| p.anchor_size.truncate().extend(p.anchor_size.w * (1 << k) as f32));
        let query = LpvQuery {
            anchor_size: anchors,
            first_cell: [p.first_cell; 4],
            dims: [dims; 4],
            cascade_count: 1 + input.bits() % 4,
            count: input.count as u32,
            blend: 1.5,
            offset: 0.5,
            half_scale: 64.0,
            _pad0: 0,
            _pad1: 0,
            _pad2: 0,
        };
        let surfels = (0..input.count)
            .map(|k| {
                let normal = input.direction().to_array();
                let at = Vec3::new(input.unit(), input.unit(), input.unit()) * 2.5 - 1.2;
                Surfel {
                    position: at.to_array(),
                    triangle: if k % 9 == 8 { NO_SURFACE } else { 0 },
                    normal,
                    geometric_normal: normal,
                    ..crate::trace::surface::no_surface()
                }
            })
            .collect();
        (query, surfels)
    }
    /// Coefficients of one element: huge ones are isotropic, since sums of huge numbers of both signs differ everywhere.
    fn coefficients(input: &mut CaseInput, q: &LpvQuery) -> Vec<f32> {
        let value = LpvLayout::new(q.dims[0]).value() as usize;
        (0..value * PASSED_VALUES as usize)
            .map(|i| match input.flavour {
                Flavour::Huge if i >= value => 0.0,
                _ if i < value => input.float().abs(),
                _ => input.float(),
            })
            .collect()
    }
    pub fn gather(input: &mut CaseInput) -> Case {
        let (query, surfels) = query(input);
        let mut case = Case::default().uniform(&query);
        for _ in 0..4 {
            case = case.read(&coefficients(input, &query));
        }
        case.read(&surfels).zeroed::<Vec4>(surfels.len())
    }
    pub fn gather_half(input: &mut CaseInput) -> Case {
        let (query, surfels) = query(input);
        let mut case = Case::default().uniform(&query);
        for _ in 0..4 {
            let c = coefficients(input, &query);
            let words: Vec<u32> =
                (0..c.len() / 2).map(|k| pack_f16x2(c[2 * k].min(6e4), c[2 * k + 1].min(6e4))).collect();
            case = case.read(&words);
        }
        case.read(&surfels).zeroed::<Vec4>(surfels.len())
    }
    pub fn pack(input: &mut CaseInput) -> Case {
        let p = super::super::case::params(input, super::super::case::side(input));
        let value = LpvLayout::new(p.dims).value() as usize;
        let coefs: Vec<f32> = (0..value * PASSED_VALUES as usize).map(|_| input.float().clamp(-900.0, 900.0)).collect();
        Case::default().uniform(&p).read(&coefs).zeroed::<u32>(value * 3)
    }
}

kernel! {
    /// Surface points to indirect irradiance.
    mod lpv_gather = super::gather; entry "lpv_gather" threads(64);
    uniform 0 params: LpvQuery;
    read 1 a: f32;
    read 2 b: f32;
    read 3 c: f32;
    read 4 d: f32;
    read 5 surfels: Surfel;
    write 6 irradiance: Vec4;
    case super::cases::gather; tolerance Tolerance::RelAbs(1e-4, 1e-4), "weights near cells' planes lose digits to differences of positions; irradiances up to 100";
}

kernel! {
    /// Surface points to indirect irradiance, from half floats.
    mod lpv_gather_half = super::gather_half; entry "lpv_gather_half" threads(64);
    uniform 0 params: LpvQuery;
    read 1 a: u32;
    read 2 b: u32;
    read 3 c: u32;
    read 4 d: u32;
    read 5 surfels: Surfel;
    write 6 irradiance: Vec4;
    case super::cases::gather_half; tolerance Tolerance::RelAbs(1e-4, 1e-4), "as lpv_gather";
}

kernel! {
    /// Coefficients to pairs of half floats.
    mod lpv_pack = super::pack; entry "lpv_pack" threads(64);
    uniform 0 params: LpvParams;
    read 1 coefs: f32;
    write 2 out: u32;
    case super::cases::pack; tolerance Tolerance::Exact, "a product with a power of two, and integers";
}
