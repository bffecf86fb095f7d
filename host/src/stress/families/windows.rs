//! (f) What windows save and cost, order by order, for a small bright light: the representation alone, in closed form,
//! whoever uses it. A lobe of [`HALF_ANGLE_DEG`] is cut off after an order, windowed, and its irradiance looked at from
//! every side: below zero it rings, and what the window takes is contrast.

use crate::stress::{Danger, Entry, Lab, Question};
use interreflect_kernels::math::sh::{
    self, BANDS, MAX_COUNT, clamped_cosine_factor, cone_factor, hanning_window, lambda_for_positivity, lanczos_window,
    laplacian_window, zonal_lobe,
};

/// Half angle of the light.
const HALF_ANGLE_DEG: f32 = 5.0;
/// Angles between normal and light at which irradiance is asked.
const ANGLES: usize = 361;

/// Windows, as factors per band for an expansion of an order.
type Window = fn(order: u32, irradiance: &[f32; MAX_COUNT]) -> [f32; BANDS];

const WINDOWS: [(&str, Window); 4] = [
    ("no window", |_, _| sh::factors(|_| 1.0)),
    ("Hanning", |order, _| sh::factors(|l| hanning_window(l, (order + 1) as f32))),
    ("Lanczos", |order, _| sh::factors(|l| lanczos_window(l, (order + 1) as f32))),
    ("least Laplacian that rings no more", |_, irradiance| {
        let lambda = lambda_for_positivity(irradiance).unwrap_or(0.0);
        sh::factors(|l| laplacian_window(l, lambda))
    }),
];

/// The two numbers of an order and a window: most negative irradiance over the mean, and the contrast lost.
fn numbers(order: u32, window: Window) -> (f64, f64) {
    let kept = |l: u32| if l <= order { cone_factor(l, HALF_ANGLE_DEG.to_radians()) } else { 0.0 };
    let light: [f32; MAX_COUNT] = zonal_lobe(&sh::factors(kept), [0.0, 1.0, 0.0]);
    let irradiance = sh::convolve(&light, &sh::factors(clamped_cosine_factor));
    let windowed = sh::convolve(&irradiance, &window(order, &irradiance));
    let at = |k: usize| {
        let angle = std::f32::consts::PI * k as f32 / (ANGLES - 1) as f32;
        f64::from(sh::evaluate(&windowed, [angle.sin(), angle.cos(), 0.0]))
    };
    let (low, high) = (0..ANGLES).map(at).fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
    // The mean over all normals is a quarter of the flux through a facing one, whatever the order and the window.
    let mean = f64::from(windowed[0]) * 0.5 / std::f64::consts::PI.sqrt();
    let truth = 4.0;
    ((-low / mean).max(0.0), (1.0 - (high - low) / mean / truth).max(0.0))
}

/// Two entries: what rings, and what contrast is lost.
pub fn run(lab: &mut Lab, orders: &[u32]) -> Vec<Entry> {
    let negative = Question {
        variant: "windows: most negative",
        measure: "the most negative irradiance over the mean, of the representation",
        parameter: "",
        unit: "",
        bound: 0.001,
        percent: true,
        danger: Danger::Cases,
    };
    let contrast = Question {
        variant: "windows: contrast",
        measure: "the contrast lost by the representation",
        bound: 0.25,
        ..negative.clone()
    };
    if orders.is_empty() {
        let reason = "the method has no order to set";
        return [negative, contrast].map(|q| q.not_applicable(lab, "ringing", reason)).into();
    }
    let cases: Vec<(u32, &str, Window)> =
        orders.iter().flat_map(|o| WINDOWS.iter().map(|(name, w)| (*o, *name, *w))).collect();
    let names: Vec<String> = cases.iter().map(|(order, name, _)| format!("order {order}, {name}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let values: Vec<(f64, f64)> = cases.iter().map(|(order, _, window)| numbers(*order, *window)).collect();
    vec![
        negative.cases(lab, "ringing", &names, |_, k| Ok(values[k].0.into())),
        contrast.cases(lab, "ringing", &names, |_, k| Ok(values[k].1.into())),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_light_at_order_two_rings_as_in_closed_form() {
        // Irradiance of a distant light at order 2 over its mean: 1 + 2 cos + (5/4)(3cos² − 1)/2, lowest at cos = −8/15.
        let c: f64 = -8.0 / 15.0;
        let lowest = 1.0 + 2.0 * c + 1.25 * 0.5 * (3.0 * c * c - 1.0);
        let (negative, _) = numbers(2, WINDOWS[0].1);
        assert!((negative + lowest).abs() < 0.01, "{negative} against {}", -lowest);
        assert!(numbers(9, WINDOWS[0].1).0 < 0.5 * negative, "higher orders ring less");
    }

    #[test]
    fn windows_trade_ringing_for_contrast() {
        for order in [2, 4, 7] {
            let of = |k: usize| numbers(order, WINDOWS[k].1);
            let (plain, hanning, lanczos, least) = (of(0), of(1), of(2), of(3));
            // Judged in 4096 directions, which may miss the very bottom.
            assert!(least.0 < 5e-4 && plain.0 > 0.01, "{order}: {least:?} {plain:?}");
            assert!(hanning.1 > lanczos.1 && lanczos.1 > plain.1, "{order}: {hanning:?} {lanczos:?} {plain:?}");
        }
    }
}
