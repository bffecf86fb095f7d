//! Sets of cones that share the hemisphere.
//!
//! The hemisphere is cut into rings of equal parts: every cone has the same solid angle 2π/n, its weight is the exact share
//! of its part in ∫ cos θ dω = π, and its axis the mean direction of that cosine. Weights add up to 1, so that a uniform
//! field of radiance L gives the irradiance πL exactly; the usual weights (Crassin et al. 2011: π/4 and 3π/20 for six
//! cones of 60°) do so too but with axes and overlaps chosen by eye.

use glam::{Vec3, Vec4};
use interreflect_shared::cone::MAX_CONES;
#[cfg(not(feature = "std"))]
use spirv_std::num_traits::Float;

/// Cones of the rings, from the normal outwards.
fn rings(count: u32) -> &'static [u32] {
    match count {
        5 => &[1, 4],
        6 => &[1, 5],
        9 => &[3, 6],
        _ => &[1, 5, 10],
    }
}

/// Numbers of cones for which there is a set.
pub const CONE_COUNTS: [u32; 4] = [5, 6, 9, 16];

/// Directions (z along the normal) and, in w, weights of a set of 5, 6, 9 or 16 cones; the rest are zero.
pub fn diffuse_cones(count: u32) -> [Vec4; MAX_CONES] {
    let mut cones = [Vec4::ZERO; MAX_CONES];
    let total = f64::from(rings(count).iter().sum::<u32>());
    let (mut next, mut before) = (0, 0.0);
    for (ring, &members) in rings(count).iter().enumerate() {
        // Equal solid angles: cosines of the ring's edges fall linearly with the number of cones inside.
        let inner = 1.0 - before / total;
        let outer = 1.0 - (before + f64::from(members)) / total;
        let weight = (inner * inner - outer * outer) / f64::from(members);
        let (cosine, sine) = mean_direction(inner, outer, members);
        for member in 0..members {
            // Every other ring is turned by half a part.
            let turn = (f64::from(member) + 0.5 * (ring & 1) as f64) / f64::from(members) * core::f64::consts::TAU;
            let axis = Vec3::new((sine * turn.cos()) as f32, (sine * turn.sin()) as f32, cosine as f32);
            cones[next] = axis.extend(weight as f32);
            next += 1;
        }
        before += f64::from(members);
    }
    cones
}

/// Cosine and sine of the polar angle of the cosine-weighted mean direction of a ring's part.
fn mean_direction(inner: f64, outer: f64, members: u32) -> (f64, f64) {
    if members == 1 && inner >= 1.0 {
        return (1.0, 0.0);
    }
    // ∫ cos·(cos, sin) dω over the polar angle, and the mean of cos φ over the part's azimuths.
    let along = (inner.powi(3) - outer.powi(3)) / 3.0;
    let sine_cubed = |cosine: f64| (1.0 - cosine * cosine).powf(1.5);
    let half = core::f64::consts::PI / f64::from(members);
    let across = (sine_cubed(outer) - sine_cubed(inner)) / 3.0 * half.sin() / half;
    let length = (along * along + across * across).sqrt();
    (along / length, across / length)
}

/// The parts of the hemisphere that the cones of a set stand for: squared cosines of the inner and the outer edge, first
/// azimuth and range of azimuths in turns. The weight of a cone is (inner − outer) · range.
pub fn cone_parts(count: u32) -> [Vec4; MAX_CONES] {
    let mut parts = [Vec4::ZERO; MAX_CONES];
    let total = rings(count).iter().sum::<u32>() as f32;
    let (mut next, mut before) = (0, 0.0);
    for (ring, &members) in rings(count).iter().enumerate() {
        let inner = 1.0 - before / total;
        let outer = 1.0 - (before + members as f32) / total;
        let range = 1.0 / members as f32;
        for member in 0..members {
            let middle = (member as f32 + 0.5 * (ring & 1) as f32) * range;
            parts[next] = Vec4::new(inner * inner, outer * outer, middle - 0.5 * range, range);
            next += 1;
        }
        before += members as f32;
    }
    parts
}

/// Tangent of half the angle of each cone of a set: a circular cone of solid angle 2π/n.
pub fn half_angle_tangent(count: u32) -> f32 {
    let cosine = 1.0 - 1.0 / f64::from(count);
    ((1.0 - cosine * cosine).sqrt() / cosine) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_a_partition_of_the_cosine_and_axes_average_to_its_mean_direction() {
        for count in CONE_COUNTS {
            let cones = diffuse_cones(count);
            let used = &cones[..count as usize];
            let sum: f32 = used.iter().map(|c| c.w).sum();
            assert!((sum - 1.0).abs() < 1e-6, "{count}: {sum}");
            let mean: Vec3 = used.iter().map(|c| c.truncate() * c.w).sum();
            // The cosine's mean direction is 2/3 along the normal; unit axes overshoot their parts' means a little.
            assert!(mean.truncate().length() < 1e-6 && (0.66..0.78).contains(&mean.z), "{count}: {mean}");
            assert!(used.iter().all(|c| (c.truncate().length() - 1.0).abs() < 1e-6 && c.z > 0.0), "{count}");
            for (part, cone) in cone_parts(count).iter().zip(used) {
                assert!(((part.x - part.y) * part.w - cone.w).abs() < 1e-6, "{count}: {part} {cone}");
                assert!(part.y <= cone.z * cone.z && cone.z * cone.z <= part.x + 1e-6, "{count}: {part} {cone}");
            }
            assert!(cones[count as usize..].iter().all(|c| *c == Vec4::ZERO));
        }
    }

    #[test]
    fn five_cones_of_a_fifth_of_the_hemisphere() {
        let cones = diffuse_cones(5);
        // The cap ends where cos = 4/5: its share is sin² = 9/25, the others' 4/25 each.
        assert!((cones[0].w - 0.36).abs() < 1e-6 && (cones[3].w - 0.16).abs() < 1e-6);
        assert!((half_angle_tangent(5) - 0.75).abs() < 1e-6);
    }
}
