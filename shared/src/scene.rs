//! The scene as kernels see it: four read-only buffers (nodes, triangles, attributes, surfaces), lights, and the
//! surface points that primary rays find.

crate::record! {
    /// Node of a binary BVH. Inner: `count` is 0 and the children are nodes `first` and `first + 1`. Leaf: triangles
    /// `first .. first + count`. Node 0 is the root. An empty scene has one leaf of zero triangles with inverted bounds.
    pub struct BvhNode: 32 {
        /// Smallest corner (m).
        pub min: [f32; 3],
        /// First child or first triangle.
        pub first: u32,
        /// Largest corner (m).
        pub max: [f32; 3],
        /// Triangles of a leaf, 0 for an inner node.
        pub count: u32,
    }
}

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
        /// Zero.
        pub _pad: [u32; 3],
    }
}

crate::record! {
    /// Material, as 12 words at the start of the `surfaces` buffer (material `m` at word `12·m`); texels follow.
    pub struct SceneMaterial: 48 {
        /// Reflectance, multiplied with the texture.
        pub albedo: [f32; 3],
        /// Word of the first texel in the `surfaces` buffer, [`NO_TEXTURE`] without. Texel: 0xAABBGGRR, RGB sRGB-coded.
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
        /// Zero.
        pub _pad: u32,
    }
}

/// [`Surfel::triangle`] of a ray that left the scene.
pub const NO_SURFACE: u32 = u32::MAX;
