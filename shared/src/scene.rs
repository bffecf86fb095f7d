//! The scene as kernels see it: four read-only buffers (nodes, triangles, attributes, surfaces), lights, and the
//! surface points that primary rays find.

use glam::Vec4;

crate::record! {
    /// Node of a four-wide BVH: the boxes of its children, side by side, and what they are. Node 0 is the root and always
    /// exists. The boxes of absent children lie at `f32::MAX`, where no ray goes.
    pub struct BvhNode: 128 {
        /// Smallest x of the children's boxes (m).
        pub min_x: Vec4,
        /// Smallest y.
        pub min_y: Vec4,
        /// Smallest z.
        pub min_z: Vec4,
        /// Largest x.
        pub max_x: Vec4,
        /// Largest y.
        pub max_y: Vec4,
        /// Largest z.
        pub max_z: Vec4,
        /// Children: `first << 4 | count`. `count` 0 is inner node `first`; `count` > 0 is a leaf of triangles
        /// `first .. first + count`; 0 is no child (the root is nobody's child).
        pub children: [u32; 4],
        /// Centre of the box around all children, and its largest half side (m).
        pub centre_half: Vec4,
    }
}

/// Low bits of a child reference that hold a leaf's number of triangles.
pub const CHILD_COUNT_BITS: u32 = 4;
/// Triangles of a leaf, at most.
pub const MAX_LEAF_TRIANGLES: u32 = (1 << CHILD_COUNT_BITS) - 1;
/// Entries of a ray's traversal stack in kernels; the host builds no BVH that needs more.
pub const BVH_STACK_SIZE: usize = 64;

crate::record! {
    /// What a ray needs of a triangle. In the order of the BVH's leaves; counter-clockwise seen from the front.
    pub struct SceneTriangle: 48 {
        /// First corner (m).
        pub v0: [f32; 3],
        /// Index of the material.
        pub material: u32,
        /// Second corner.
        pub v1: [f32; 3],
        /// Bit 0: rays must test alpha. Bit 1: emits.
        pub flags: u32,
        /// Third corner.
        pub v2: [f32; 3],
        /// Index of the triangle in the host's scene.
        pub source: u32,
    }
}

/// Bit of [`SceneTriangle::flags`]: the material cuts rays by its alpha.
pub const TRIANGLE_MASKED: u32 = 1;
/// Bit of [`SceneTriangle::flags`]: the front face emits.
pub const TRIANGLE_EMITS: u32 = 2;

crate::record! {
    /// What shading needs of a triangle, beside [`SceneTriangle`] in the same order.
    pub struct TriangleAttributes: 48 {
        /// Texture coordinates of the three corners, v downwards.
        pub uv: [f32; 6],
        /// Unit vertex normals, octahedral, 2×16 bits signed normalized.
        pub normals: [u32; 3],
        /// What the corners' vertex colours take away, 10 bits per channel, red lowest: `q` stands for the factor
        /// (1 − q/1023)², so that dark colours are as exact as bright ones and 0 is white.
        pub tints: [u32; 3],
    }
}

crate::record! {
    /// Material, as 12 words of the `surfaces` buffer: after [`SRGB_TABLE_WORDS`] words of the sRGB table come the
    /// materials (material `m` at word `256 + 12·m`), then texels.
    pub struct SceneMaterial: 48 {
        /// Reflectance, multiplied with the texture.
        pub albedo: [f32; 3],
        /// Word of the first texel in the `surfaces` buffer, and how the texture goes on beyond its sides (`WRAP_…`, along u at
        /// [`WRAP_U_SHIFT`], along v at [`WRAP_V_SHIFT`]); [`NO_TEXTURE`] without. Texel: 0xAABBGGRR, RGB sRGB-coded.
        pub texture_first: u32,
        /// Radiance of the front face, W/(sr m²).
        pub emission: [f32; 3],
        /// Width in the low, height in the high 16 bits.
        pub texture_size: u32,
        /// Alpha, multiplied with the texture's.
        pub alpha_factor: f32,
        /// Rays pass where alpha is below; negative for opaque materials.
        pub alpha_cutoff: f32,
        /// glTF's metallic factor.
        pub metallic: f32,
        /// glTF's roughness factor.
        pub roughness: f32,
    }
}

/// [`SceneMaterial::texture_first`] of a material without a texture.
pub const NO_TEXTURE: u32 = u32::MAX;
/// Bits of [`SceneMaterial::texture_first`] that hold the word: more than a binding has.
pub const TEXTURE_FIRST_MASK: u32 = (1 << WRAP_U_SHIFT) - 1;
/// Bit of [`SceneMaterial::texture_first`] where the two bits of the wrap mode along u begin.
pub const WRAP_U_SHIFT: u32 = 28;
/// The same along v.
pub const WRAP_V_SHIFT: u32 = 30;
/// The texture repeats.
pub const WRAP_REPEAT: u32 = 0;
/// The texels at its side go on.
pub const WRAP_CLAMP: u32 = 1;
/// It repeats, mirrored every other time.
pub const WRAP_MIRROR: u32 = 2;
/// Words of the sRGB table at the start of the `surfaces` buffer: the linear value (f32 bits) of each 8-bit code. A
/// table in a buffer gives every target the same bits, and costs less than a power per texel and channel.
pub const SRGB_TABLE_WORDS: u32 = 256;
/// Words of a [`SceneMaterial`] in the `surfaces` buffer.
pub const MATERIAL_WORDS: u32 = 12;

/// [`SceneLight::kind`]: point light at `a`, `radiance` is radiant intensity (W/sr).
pub const LIGHT_POINT: u32 = 0;
/// [`SceneLight::kind`]: spot at `a` along `b`, `radiance` is intensity on the axis, `c` = (cos inner, cos outer, 0).
pub const LIGHT_SPOT: u32 = 1;
/// [`SceneLight::kind`]: directional along `b`, `radiance` is perpendicular irradiance (W/m²).
pub const LIGHT_DIRECTIONAL: u32 = 2;
/// [`SceneLight::kind`]: emissive triangle with corners `a`, `b`, `c`, `radiance` of its front face (W/(sr m²)).
pub const LIGHT_TRIANGLE: u32 = 3;

crate::record! {
    /// A light of any kind; the constants `LIGHT_…` say what the vectors mean.
    pub struct SceneLight: 64 {
        /// Position or first corner.
        pub a: [f32; 3],
        /// One of the constants `LIGHT_…`.
        pub kind: u32,
        /// Unit direction of travel or second corner.
        pub b: [f32; 3],
        /// Area of an emissive triangle (m²), else 0.
        pub area: f32,
        /// Cone cosines or third corner.
        pub c: [f32; 3],
        /// Luminous power share of the lights up to and with this one: a cumulative distribution ending in 1.
        pub cumulative: f32,
        /// Intensity, irradiance or radiance.
        pub radiance: [f32; 3],
        /// Probability of this light in that distribution.
        pub probability: f32,
    }
}

crate::record! {
    /// A visible surface point (G-buffer pixel) or a free receiver.
    pub struct Surfel: 80 {
        /// Position (m).
        pub position: [f32; 3],
        /// Index of the triangle in the buffers, [`NO_SURFACE`] where the ray left the scene.
        pub triangle: u32,
        /// Unit shading normal on the viewer's side.
        pub normal: [f32; 3],
        /// Distance from the camera (m).
        pub distance: f32,
        /// Unit geometric normal on the viewer's side.
        pub geometric_normal: [f32; 3],
        /// 1 where the viewer sees the triangle's front.
        pub front: u32,
        /// Reflectance.
        pub albedo: [f32; 3],
        /// Index of the material.
        pub material: u32,
        /// Radiance emitted towards the viewer; the environment's radiance where the ray left the scene.
        pub emission: [f32; 3],
        /// Bound of the position's rounding error (m): how far a ray must start off the surface not to meet it again.
        pub error: f32,
    }
}

/// [`Surfel::triangle`] of a ray that left the scene.
pub const NO_SURFACE: u32 = u32::MAX;
