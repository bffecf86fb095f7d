//! Orthonormal frame around a direction.

use super::float::copysign;
use glam::Vec3;

/// A right-handed orthonormal basis whose `z` axis is `normal`: `tangent × bitangent = normal`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Local x axis.
    pub tangent: Vec3,
    /// Local y axis.
    pub bitangent: Vec3,
    /// Local z axis.
    pub normal: Vec3,
}

impl Frame {
    /// Frame around a unit vector, without branches and without a singular direction (Duff et al. 2017, "Building an
    /// Orthonormal Basis, Revisited", listing 3). The tangents jump where `normal.z` changes its sign.
    #[inline(always)]
    pub fn new(normal: Vec3) -> Self {
        let sign = copysign(1.0, normal.z);
        let a = -1.0 / (sign + normal.z);
        let b = normal.x * normal.y * a;
        Self {
            tangent: Vec3::new(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x),
            bitangent: Vec3::new(b, sign + normal.y * normal.y * a, -normal.y),
            normal,
        }
    }

    /// A vector given in this frame, in the space of the frame's axes.
    #[inline(always)]
    pub fn world_from_local(&self, v: Vec3) -> Vec3 {
        self.tangent * v.x + self.bitangent * v.y + self.normal * v.z
    }

    /// The components of a vector along the frame's axes.
    #[inline(always)]
    pub fn local_from_world(&self, v: Vec3) -> Vec3 {
        Vec3::new(v.dot(self.tangent), v.dot(self.bitangent), v.dot(self.normal))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::sampling::spherical_fibonacci;

    #[test]
    fn frames_are_orthonormal_and_right_handed_everywhere() {
        let poles = [Vec3::Z, -Vec3::Z, Vec3::X, Vec3::new(0.0, 1e-7, -1.0), Vec3::new(1.0, 0.0, -0.0)];
        for n in (0..4096).map(|i| spherical_fibonacci(i, 4096)).chain(poles) {
            let f = Frame::new(n);
            let error = [
                f.tangent.length() - 1.0,
                f.bitangent.length() - 1.0,
                f.tangent.dot(f.bitangent),
                f.tangent.dot(n),
                f.bitangent.dot(n),
                (f.tangent.cross(f.bitangent) - n).length(),
            ];
            assert!(error.iter().all(|e| e.abs() < 1e-6), "{n}: {error:?}");
            let v = Vec3::new(0.3, -0.9, 2.0);
            assert!((f.local_from_world(f.world_from_local(v)) - v).length() < 2e-6, "{n}");
        }
    }
}
