//! Octahedral map of the unit sphere onto a square (Cigolle et al. 2014, "A Survey of Efficient Representations for
//! Independent Unit Vectors"): +Z is the centre, −Z the four corners.

use super::float::{abs, copysign, max};
use super::pack::{pack_snorm16x2, unpack_snorm16x2};
use super::vector::normalize;
use glam::{Vec2, Vec3};

/// A direction (any length above zero) as a point of [−1, 1]²; the zero vector gives the centre.
#[inline(always)]
pub fn encode(v: Vec3) -> Vec2 {
    let norm = abs(v.x) + abs(v.y) + abs(v.z);
    let scale = if norm > 0.0 { 1.0 / norm } else { 0.0 };
    let (x, y) = (v.x * scale, v.y * scale);
    if v.z < 0.0 {
        // The lower half unfolds over the diagonals.
        Vec2::new(copysign(1.0 - abs(y), x), copysign(1.0 - abs(x), y))
    } else {
        Vec2::new(x, y)
    }
}

/// The unit vector of a point of [−1, 1]².
#[inline(always)]
pub fn decode(p: Vec2) -> Vec3 {
    let z = 1.0 - abs(p.x) - abs(p.y);
    let fold = max(-z, 0.0);
    normalize(Vec3::new(p.x - copysign(fold, p.x), p.y - copysign(fold, p.y), z))
}

/// A direction in 32 bits: x in the low, y in the high half, each signed normalized. Angular error below 6.5e-5 rad.
#[inline(always)]
pub fn pack(v: Vec3) -> u32 {
    let p = encode(v);
    pack_snorm16x2(p.x, p.y)
}

/// The unit vector that [`pack`] stored.
#[inline(always)]
pub fn unpack(word: u32) -> Vec3 {
    let (x, y) = unpack_snorm16x2(word);
    decode(Vec2::new(x, y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::sampling::spherical_fibonacci;

    fn directions() -> impl Iterator<Item = Vec3> {
        let axes = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z, Vec3::new(0.6, -0.8, 0.0)];
        (0..20_000).map(|i| spherical_fibonacci(i, 20_000)).chain(axes)
    }

    #[test]
    fn decoding_an_encoded_direction_returns_it() {
        for v in directions() {
            let p = encode(v);
            assert!(p.abs().max_element() <= 1.0 && (decode(p) - v).length() < 4e-7, "{v} -> {p} -> {}", decode(p));
            assert!((decode(encode(v * 17.0)) - v).length() < 5e-7, "the length does not matter");
        }
    }

    #[test]
    fn packing_keeps_directions_to_the_stated_angle() {
        let worst = directions().map(|v| (unpack(pack(v)) - v).length()).fold(0.0, f32::max);
        assert!(worst < 6.5e-5, "{worst}");
        for v in [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z] {
            assert_eq!(unpack(pack(v)), v, "axes are exact");
        }
    }

    #[test]
    fn words_hold_x_low_and_y_high() {
        assert_eq!((pack(Vec3::X), pack(Vec3::Y), pack(Vec3::Z)), (0x0000_7FFF, 0x7FFF_0000, 0));
        assert_eq!(pack(-Vec3::X), 0x0000_8001);
        assert!((unpack(pack(Vec3::ZERO)) - Vec3::Z).length() == 0.0);
    }
}
