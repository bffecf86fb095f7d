//! Radiance that leaves every receiver: `L = ρ/π (E_direct + E_indirect) + L_e`.
//!
//! One invocation: one slot. Grid: slots, then special slots (black, environment, light of occluders), which are copied
//! in so that a relight ray needs no branch. Silvennoinen & Lehtinen 2017, §4.2, where this is a direct-light map.
//! Bound by bandwidth. Linear: negative irradiance, which band-limited probes can give, stays negative, so that the loop of
//! bounces has a spectral radius; whoever shows irradiance clamps it. Before: `trace_direct`
//! when lights change, [`super::reconstruct`] of the last bounce; after: [`super::gather`].

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::PI;
use glam::{Vec3, Vec4};
use interreflect_shared::srp::{SrpRelightParams, SrpSurface};

/// Slots and special slots.
pub fn slots(p: &SrpRelightParams) -> Rows {
    Rows::all(p.slot_count + p.special_count)
}

/// Radiance W/(sr m²) of slot `i`, w = 0. `direct`: irradiance (W/m²) per slot; `indirect` the same in planes
/// `[channel][slot]`; `special`: radiance of the special slots.
#[inline(always)]
pub fn relight(
    i: u32,
    p: &SrpRelightParams,
    direct: &[Vec4],
    indirect: &[f32],
    surfaces: &[SrpSurface],
    special: &[Vec4],
) -> Vec4 {
    let (at, slots) = (i as usize, p.slot_count as usize);
    if at >= slots {
        return special[at - slots];
    }
    let (direct, surface) = (direct[at], surfaces[at]);
    let arriving = Vec3::new(
        direct.x + p.feedback * indirect[at],
        direct.y + p.feedback * indirect[slots + at],
        direct.z + p.feedback * indirect[2 * slots + at],
    );
    let reflected = arriving * Vec3::from_array(surface.albedo) * (1.0 / PI);
    (reflected + Vec3::from_array(surface.emission)).extend(0.0)
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let special_count = (input.count as u32).min(3);
    let slot_count = input.count as u32 - special_count;
    let p = SrpRelightParams { slot_count, special_count, feedback: 0.5 + 0.5 * input.unit(), _pad0: 0 };
    let slots = slot_count as usize;
    let vector = |v: alloc::vec::Vec<f32>| -> alloc::vec::Vec<Vec4> {
        v.chunks_exact(3).map(|v| Vec4::new(v[0], v[1], v[2], 0.0)).collect()
    };
    let direct = vector(super::case_floats(input, 3 * slots));
    let indirect = super::case_floats(input, 3 * slots);
    let surface = |input: &mut CaseInput| SrpSurface {
        albedo: [input.unit(), input.unit(), input.unit()],
        _pad0: 0,
        emission: [input.unit(), input.unit(), input.unit()],
        _pad1: 0,
    };
    let surfaces: alloc::vec::Vec<SrpSurface> = (0..slots).map(|_| surface(input)).collect();
    let special = vector(super::case_floats(input, 3 * special_count as usize));
    let case = Case::default().uniform(&p).read(&direct).read(&indirect).read(&surfaces).read(&special);
    case.zeroed::<Vec4>(input.count)
}

kernel! {
    /// Irradiance at receivers to radiance that leaves them.
    mod srp_relight = super::relight; entry "srp_relight" threads(64);
    uniform 0 params: SrpRelightParams;
    read 1 direct: Vec4;
    read 2 indirect: f32;
    read 3 surfaces: SrpSurface;
    read 4 special: Vec4;
    write 5 radiance: Vec4;
    over super::slots;
    case super::case; tolerance Tolerance::RelAbs(1e-6, 1e-6), "a sum of products that may cancel and a multiply-add, which a device may fuse";
}
