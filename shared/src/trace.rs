//! Parameters of the kernels that every method shares (`kernels/src/trace`): primary rays, direct light, raw rays and
//! the final sum.

use glam::Vec4;

crate::record! {
    /// Pinhole camera and picture of `trace_gbuffer`; pixel `i` lies at column `i % width` and row `i / width`.
    pub struct GBufferParams: 96 {
        /// Position (m); w is unused.
        pub position: Vec4,
        /// Unit view direction; w is unused.
        pub forward: Vec4,
        /// Right, times the tangent of half the horizontal field of view; w is unused.
        pub right: Vec4,
        /// Up, times the tangent of half the vertical field of view; w is unused.
        pub up: Vec4,
        /// Radiance of the environment, W/(sr m²); w is unused.
        pub environment: Vec4,
        /// Width in pixels.
        pub width: u32,
        /// Height in pixels.
        pub height: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
    }
}

crate::record! {
    /// Light and sampling of `trace_direct`.
    pub struct DirectParams: 48 {
        /// Radiance of the environment, W/(sr m²); w is unused.
        pub environment: Vec4,
        /// Receivers.
        pub count: u32,
        /// Lights in the buffer.
        pub light_count: u32,
        /// Shadow rays to each emissive triangle, and picks where there are many lights. More: less noise in
        /// penumbrae, time in proportion. Default 16.
        pub light_samples: u32,
        /// Rays to the environment per receiver; 0 leaves the environment out. More: less noise where it is partly
        /// hidden. Default 64.
        pub environment_samples: u32,
        /// With more lights than this each receiver picks `light_samples` of them by power instead of asking all.
        /// Higher: less noise; lower: less time. Default 64.
        pub pick_above: u32,
        /// Mixed into every random choice.
        pub seed: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
    }
}

crate::record! {
    /// Number of rays of `trace_rays` or of pixels of `trace_compose`.
    pub struct CountParams: 16 {
        /// Elements.
        pub count: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Zero.
        pub _pad2: u32,
    }
}

crate::record! {
    /// A ray to trace.
    pub struct TraceRay: 32 {
        /// Start (m).
        pub origin: [f32; 3],
        /// Hits nearer than this do not count.
        pub t_min: f32,
        /// Direction; distances are in units of its length.
        pub direction: [f32; 3],
        /// Hits at or beyond this do not count.
        pub t_max: f32,
    }
}

crate::record! {
    /// Where a ray met the scene.
    pub struct TraceHit: 16 {
        /// Distance in units of the direction's length; the ray's `t_max` where it met nothing.
        pub t: f32,
        /// Index of the triangle in the buffers, [`crate::scene::NO_SURFACE`] where the ray met nothing.
        pub triangle: u32,
        /// Weight of the second corner.
        pub u: f32,
        /// Weight of the third corner.
        pub v: f32,
    }
}
