//! The final sum: radiance towards the camera from what a method and the direct light give.
//!
//! One invocation computes one pixel: emission + albedo/π · (direct + indirect irradiance), Lambert's law. Grid: pixels.
//! Last pass of every picture.

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use core::f32::consts::FRAC_1_PI;
use glam::{Vec3, Vec4};
use interreflect_shared::scene::Surfel;
use interreflect_shared::trace::CountParams;

/// Pixels.
pub fn pixels(p: &CountParams) -> Rows {
    Rows::all(p.count)
}

/// Radiance (W/(sr m²), w = 1) of pixel `i` towards the camera.
#[inline(always)]
pub fn compose(i: u32, _p: &CountParams, surfels: &[Surfel], direct: &[Vec4], indirect: &[Vec4]) -> Vec4 {
    let k = i as usize;
    let albedo = Vec3::from_array(surfels[k].albedo);
    let irradiance = (direct[k] + indirect[k]).truncate();
    (Vec3::from_array(surfels[k].emission) + albedo * irradiance * FRAC_1_PI).extend(1.0)
}

#[cfg(not(target_arch = "spirv"))]
fn compose_case(input: &mut CaseInput) -> Case {
    let count = input.count;
    let surfels: alloc::vec::Vec<Surfel> = (0..count)
        .map(|_| Surfel {
            albedo: [input.unit(), input.unit(), input.unit()],
            emission: [input.float().abs(), input.float().abs(), input.float().abs()],
            ..super::surface::no_surface()
        })
        .collect();
    let irradiance = |input: &mut CaseInput| -> alloc::vec::Vec<Vec4> {
        (0..count).map(|_| Vec4::new(input.float(), input.float(), input.float(), 0.0).abs()).collect()
    };
    let params = super::case::count(count);
    Case::default()
        .uniform(&params)
        .read(&surfels)
        .read(&irradiance(input))
        .read(&irradiance(input))
        .zeroed::<Vec4>(count)
}

kernel! {
    /// Surface points and irradiance to radiance.
    mod trace_compose = super::compose; entry "trace_compose" threads(64);
    uniform 0 params: CountParams;
    read 1 surfels: Surfel;
    read 2 direct: Vec4;
    read 3 indirect: Vec4;
    write 4 radiance: Vec4;
    over super::pixels;
    case super::compose_case; tolerance Tolerance::RelAbs(1e-5, 1e-6), "four roundings; radiance and irradiance are not negative, so that nothing cancels";
}
