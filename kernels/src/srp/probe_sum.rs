//! Partial coefficients to the probe radiance vector λ.
//!
//! One invocation: one coefficient of one channel of one probe: the sum over slices of rays, times the weight of a ray.
//! Grid: channels × (probes × coefficients, and 16 zeros). Before: [`super::project`]; after: [`super::cluster`].

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use interreflect_shared::srp::{SrpLayout, SrpProbeParams};

/// Three channels of [`SrpLayout::coef_plane`].
pub fn elements(p: &SrpProbeParams) -> Rows {
    Rows::all(3 * SrpLayout::new(p).coef_plane())
}

/// Coefficient `i` of `[channel][probe][k]`; 0 beyond the last probe.
#[inline(always)]
pub fn sum(i: u32, p: &SrpProbeParams, partial: &[f32]) -> f32 {
    let layout = SrpLayout::new(p);
    let channel = i / layout.coef_plane();
    let coef = i - channel * layout.coef_plane();
    let probe = coef / layout.coefs;
    let mut sum = 0.0;
    if probe < layout.probes {
        for slice in 0..layout.slices {
            sum += partial[layout.partial(channel, coef - probe * layout.coefs, slice, probe)];
        }
    }
    sum * p.weight
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    let p = super::case_probes(input, input.count as u32 / 64);
    let layout = SrpLayout::new(&p);
    let partial =
        super::case_floats(input, (24 * layout.partial_rows() * interreflect_shared::srp::SRP_LANES) as usize);
    Case::default().uniform(&p).read(&partial).zeroed::<f32>(3 * layout.coef_plane() as usize)
}

kernel! {
    /// Partial coefficients to coefficients.
    mod srp_probe_sum = super::sum; entry "srp_probe_sum" threads(64);
    uniform 0 params: SrpProbeParams;
    read 1 partial: f32;
    write 2 coefs: f32;
    over super::elements;
    case super::case; tolerance Tolerance::RelAbs(1e-6, 1e-6), "three additions of numbers below 1 that may cancel";
}
