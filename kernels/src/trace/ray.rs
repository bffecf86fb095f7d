//! Rays, hits, and the watertight ray–triangle test.
//!
//! Woop, Benthin & Wald 2013, "Watertight Ray/Triangle Intersection": the corners are moved and sheared into a frame in
//! which the ray is the z axis, each in the same way whatever triangle it belongs to; the edge functions of two
//! neighbours are then exact opposites, so that no ray passes between them. Where a rounded edge function is zero the
//! paper repeats it in double precision; we take the exact remainders of its two products instead (Dekker 1971), since
//! kernels have no `f64`. Edges belong to both of their triangles.

use crate::math::float::{abs, max};
use glam::Vec3;
use interreflect_shared::scene::{NO_SURFACE, SceneTriangle};

/// Half-line `origin + t·direction`, of which hits with `t_min ≤ t < t_max` count.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Ray {
    /// Start (m).
    pub origin: Vec3,
    /// Direction of any non-zero length; distances are in units of it.
    pub direction: Vec3,
    /// Smallest distance that counts.
    pub t_min: f32,
    /// Distance from which on nothing counts.
    pub t_max: f32,
}

impl Ray {
    /// A ray without end.
    #[inline(always)]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction, t_min: 0.0, t_max: f32::MAX }
    }
    /// A ray that ends before `t_max`.
    #[inline(always)]
    pub fn until(origin: Vec3, direction: Vec3, t_max: f32) -> Self {
        Self { origin, direction, t_min: 0.0, t_max }
    }
}

/// Where a ray met the scene.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hit {
    /// Distance in units of the direction's length; the ray's `t_max` where it met nothing.
    pub t: f32,
    /// Index of the triangle, [`NO_SURFACE`] for none.
    pub triangle: u32,
    /// Weight of the second corner.
    pub u: f32,
    /// Weight of the third corner.
    pub v: f32,
}

impl Hit {
    /// No hit up to `t_max`.
    #[inline(always)]
    pub fn none(t_max: f32) -> Self {
        Self { t: t_max, triangle: NO_SURFACE, u: 0.0, v: 0.0 }
    }
    /// Whether the ray met a triangle.
    #[inline(always)]
    pub fn is_some(&self) -> bool {
        self.triangle != NO_SURFACE
    }
}

/// A ray's frame for triangle tests: the axis along which it mostly runs becomes z, and a shear puts it onto that axis.
#[derive(Clone, Copy)]
pub struct RayFrame {
    x: usize,
    y: usize,
    z: usize,
    shear_x: f32,
    shear_y: f32,
    scale_z: f32,
    origin_x: f32,
    origin_y: f32,
    origin_z: f32,
}

impl RayFrame {
    /// The frame of a ray.
    #[inline(always)]
    pub fn new(ray: &Ray) -> Self {
        let (ax, ay, az) = (abs(ray.direction.x), abs(ray.direction.y), abs(ray.direction.z));
        let z = if ax > ay {
            if ax > az { 0 } else { 2 }
        } else if ay > az {
            1
        } else {
            2
        };
        let x = if z == 2 { 0 } else { z + 1 };
        let y = if x == 2 { 0 } else { x + 1 };
        let d = ray.direction.to_array();
        let o = ray.origin.to_array();
        let scale_z = 1.0 / d[z];
        Self {
            x,
            y,
            z,
            shear_x: d[x] * scale_z,
            shear_y: d[y] * scale_z,
            scale_z,
            origin_x: o[x],
            origin_y: o[y],
            origin_z: o[z],
        }
    }

    /// Distance and the weights of the second and third corner where the ray meets the triangle; a negative distance
    /// where it does not (or behind the origin).
    #[inline(always)]
    pub fn intersect(&self, triangle: &SceneTriangle) -> [f32; 3] {
        let az = triangle.v0[self.z] - self.origin_z;
        let bz = triangle.v1[self.z] - self.origin_z;
        let cz = triangle.v2[self.z] - self.origin_z;
        let ax = triangle.v0[self.x] - self.origin_x - self.shear_x * az;
        let ay = triangle.v0[self.y] - self.origin_y - self.shear_y * az;
        let bx = triangle.v1[self.x] - self.origin_x - self.shear_x * bz;
        let by = triangle.v1[self.y] - self.origin_y - self.shear_y * bz;
        let cx = triangle.v2[self.x] - self.origin_x - self.shear_x * cz;
        let cy = triangle.v2[self.y] - self.origin_y - self.shear_y * cz;
        // Twice the signed areas between the axis and each edge.
        let a = difference_of_products(cx, by, cy, bx);
        let b = difference_of_products(ax, cy, ay, cx);
        let c = difference_of_products(bx, ay, by, ax);
        let outside = (a < 0.0 || b < 0.0 || c < 0.0) && (a > 0.0 || b > 0.0 || c > 0.0);
        let det = a + b + c;
        if outside || det == 0.0 {
            return [-1.0, 0.0, 0.0];
        }
        let z = Vec3::new(az, bz, cz) * self.scale_z;
        let [t, u, v] = interpolate(a, b, c, z);
        // The rounding of the products moves `t` by about 2⁻²² of this, which is large for long thin triangles, and next
        // to the plane, where it decides on which side the ray starts and whether it meets the surface that it left.
        let product = largest(ax, bx, cx) * largest(ay, by, cy) * largest(z.x, z.y, z.z);
        if product <= abs(det * t) * EXACT_ABOVE {
            return [t, u, v];
        }
        interpolate(
            exact_difference_of_products(cx, by, cy, bx),
            exact_difference_of_products(ax, cy, ay, cx),
            exact_difference_of_products(bx, ay, by, ax),
            z,
        )
    }
}

/// Products this many times larger than what they add up to are computed exactly: a relative error of 2⁻¹⁴ without.
const EXACT_ABOVE: f32 = 256.0;

#[inline(always)]
fn largest(a: f32, b: f32, c: f32) -> f32 {
    max(max(abs(a), abs(b)), abs(c))
}

/// Distance and the weights of the second and third corner from the three areas and the corners' distances.
#[inline(always)]
fn interpolate(a: f32, b: f32, c: f32, z: Vec3) -> [f32; 3] {
    let inverse = 1.0 / (a + b + c);
    let (u, v) = (b * inverse, c * inverse);
    // The weights before the distances: no overflow.
    [a * inverse * z.x + u * z.y + v * z.z, u, v]
}

/// `a·b − c·d` with the right sign, zero only where it is zero.
#[inline(always)]
fn difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let p = a * b;
    let q = c * d;
    // Comparing the rounded products, instead of the sign of their difference, holds where a device fuses the
    // subtraction with one of the multiplications.
    if p != q { p - q } else { product_remainder(a, b, p) - product_remainder(c, d, q) }
}

/// `a·b − c·d` to about two units in its last place.
fn exact_difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let p = a * b;
    let q = c * d;
    (p - q) + (product_remainder(a, b, p) - product_remainder(c, d, q))
}

/// `a·b − p` exactly, for `p` = `a·b` rounded (Dekker 1971, with Veltkamp's splitting; no overflow below 1e34).
fn product_remainder(a: f32, b: f32, p: f32) -> f32 {
    let (a_high, b_high) = (high_half(a), high_half(b));
    let (a_low, b_low) = (a - a_high, b - b_high);
    ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low
}

/// The leading 12 bits of a float's significand.
#[inline(always)]
fn high_half(x: f32) -> f32 {
    let c = x * 4097.0;
    c - (c - x)
}

/// A ray prepared for slab tests against padded boxes.
///
/// Boxes grow by the rounding errors of the triangle test and of the slab test itself (Ize 2013, "Robust BVH Ray
/// Traversal"; Woop et al. 2013, §3.3), as the origin moves towards each plane: at most 2⁻²⁰ of the distance to the
/// scene's farthest corner, which bounds both (6 and 3 roundings of 2⁻²⁴), and one unit in the origin's last place.
#[derive(Clone, Copy)]
pub struct SlabRay {
    /// Origin as seen from the smallest planes.
    pub low: Vec3,
    /// Origin as seen from the largest planes.
    pub high: Vec3,
    /// Reciprocal direction, finite.
    pub inverse: Vec3,
}

/// Share of the distance to the farthest corner by which boxes grow: 2⁻²⁰.
const BOX_PADDING: f32 = 9.536_743e-7;
/// Two units of rounding: moving by this share of a number always changes it.
const TWO_ROUNDINGS: f32 = 2.384_185_8e-7;
/// Direction components below this share of the largest one count as this share: reciprocals stay finite, and the error
/// is below the padding.
const SMALLEST_SLOPE: f32 = 1e-12;

impl SlabRay {
    /// Prepares a ray for a scene whose farthest corner lies `reach` away from the ray's origin (largest coordinate
    /// difference).
    #[inline(always)]
    pub fn new(ray: &Ray, reach: f32) -> Self {
        let padding = Vec3::splat(reach * BOX_PADDING)
            + Vec3::new(abs(ray.origin.x), abs(ray.origin.y), abs(ray.origin.z)) * TWO_ROUNDINGS;
        let d = ray.direction;
        let smallest = max(max(abs(d.x), abs(d.y)), abs(d.z)) * SMALLEST_SLOPE;
        Self {
            low: ray.origin + padding,
            high: ray.origin - padding,
            inverse: Vec3::new(
                finite_reciprocal(d.x, smallest),
                finite_reciprocal(d.y, smallest),
                finite_reciprocal(d.z, smallest),
            ),
        }
    }
}

#[inline(always)]
fn finite_reciprocal(x: f32, smallest: f32) -> f32 {
    if abs(x) > smallest { 1.0 / x } else { 1.0 / smallest }
}
