//! Scene access of kernels: the BVH walk, the surface fetch, the lights; and the passes that every method shares.
//!
//! - [`closest_hit`], [`any_hit`]: rays against the scene ([`SceneRef`]), watertight.
//! - [`surface()`]: position, normals, reflectance and emission at a hit; [`leave_surface`]: where the next ray starts.
//! - [`light_irradiance`], [`direct_irradiance`]: direct light at a receiver, with shadow rays.
//! - Kernels: [`gbuffer`] (primary rays), [`direct`] (direct light per pixel), [`rays`] (raw rays in, hits out) and
//!   [`compose`] (radiance towards the camera).

pub mod bvh;
#[cfg(not(target_arch = "spirv"))]
pub(crate) mod case;
pub mod compose;
pub mod direct;
pub mod gbuffer;
pub mod light;
pub mod ray;
pub mod rays;
pub mod surface;

pub use bvh::{any_hit, closest_hit};
pub use light::{Receiver, direct_irradiance, light_irradiance};
pub use ray::{Hit, Ray};
pub use surface::{leave_surface, surface};

use interreflect_shared::scene::{BvhNode, SceneTriangle, TriangleAttributes};

/// The scene's buffers.
#[derive(Clone, Copy)]
pub struct SceneRef<'a> {
    /// Four-wide BVH, node 0 is the root.
    pub nodes: &'a [BvhNode],
    /// Triangles in the order of the leaves.
    pub triangles: &'a [SceneTriangle],
    /// Attributes in the same order.
    pub attributes: &'a [TriangleAttributes],
    /// sRGB table, materials, texels.
    pub surfaces: &'a [u32],
}

/// This family's rows of the kernel table.
#[cfg(not(target_arch = "spirv"))]
pub const KERNELS: &[&crate::kernel::Kernel] = &[
    &gbuffer::trace_gbuffer::KERNEL,
    &direct::trace_direct::KERNEL,
    &rays::trace_rays::KERNEL,
    &compose::trace_compose::KERNEL,
];
