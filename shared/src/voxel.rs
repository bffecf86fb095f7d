//! Parameters and records of the sparse voxel pyramid (`kernels/src/voxel`).

use glam::{UVec4, Vec4};

/// Levels of a pyramid, at most: 512 voxels along the longest side and nine halvings.
pub const MAX_LEVELS: usize = 10;
/// Voxels of a brick along x, y and z: one word of occupancy bits.
pub const BRICK: [u32; 3] = [4, 4, 2];
/// Columns of voxels along each side of a tile, the share of a triangle that one invocation voxelizes.
pub const TILE: u32 = 4;
/// Elements that one invocation of a prefix sum adds up.
pub const SCAN_RADIX: u32 = 16;
/// Kinds of facet that a voxel may hold: one per axis and sign of the dominant component of the front face's normal.
pub const FACET_KINDS: u32 = 6;
/// Accumulated words of a facet: area, normal, centroid, albedo, emission.
pub const FACET_WORDS: u32 = 13;
/// Area, in voxel faces, whose sum in one facet the default fixed-point scale can hold.
pub const MAX_FACET_AREA: f32 = 2048.0;
/// Default units of accumulated area per voxel face. Every other sum is bounded by the area's.
pub const AREA_SCALE: f32 = 1_048_576.0;
/// First bit that a sum of area must not reach.
pub const AREA_LIMIT: u32 = 1 << 31;

crate::record! {
    /// A voxel pyramid and one pass over it: the uniform of every voxel kernel.
    pub struct VoxelParams: 288 {
        /// Corner of the grid (m) and, in w, the side of a voxel (m).
        pub origin_size: Vec4,
        /// Voxels along x, y, z of level 0 and, in w, the number of levels.
        pub dims_levels: UVec4,
        /// Per level: bricks along x, bricks of a layer of constant z, first cell, number of cells. The cells of the even
        /// levels lie before those of the odd levels.
        pub levels: [UVec4; 10],
        /// Triangles.
        pub triangle_count: u32,
        /// Tiles of all triangles together.
        pub tile_count: u32,
        /// Facets of all voxels together.
        pub facet_count: u32,
        /// Stored directions of levels ≥ 1: 6 (anisotropic) or 1 (isotropic).
        pub direction_count: u32,
        /// Units of accumulated area per voxel face.
        pub area_scale: f32,
        /// Emitted radiance that one unit of area at full scale stands for, W/(sr m²).
        pub emission_scale: f32,
        /// 1: facets' radiance includes what they emit (front only); 0: only what they reflect.
        pub emission_weight: f32,
        /// Cells of the even levels together.
        pub even_cells: u32,
        /// Level that this pass writes.
        pub level: u32,
        /// First element (cell, or record of levels ≥ 1) that this pass writes.
        pub first: u32,
        /// Elements that this pass writes.
        pub count: u32,
        /// Zero.
        pub _pad: u32,
        /// Radiance of the environment, W/(sr m²); w is unused.
        pub environment: Vec4,
        /// Factor per channel on bounced irradiance, for the light of bounces that are not traced; w is unused.
        pub bounce_gain: Vec4,
        /// Lights, samples per facet, environment rays per facet, seed.
        pub light: UVec4,
    }
}

crate::record! {
    /// The part of a scene's surfaces inside one voxel whose front normals share their dominant axis and sign.
    pub struct VoxelFacet: 64 {
        /// Centroid of the surface (m).
        pub position: [f32; 3],
        /// Area in voxel faces (voxel side squared).
        pub area: f32,
        /// Area-weighted sum of unit front normals in voxel faces: its projection on a direction is the projected area.
        pub normal: [f32; 3],
        /// Voxel of level 0 that holds the facet: x + dims.x·(y + dims.y·z).
        pub voxel: u32,
        /// Mean reflectance.
        pub albedo: [f32; 3],
        /// Zero.
        pub _pad0: u32,
        /// Mean radiance of the front face, W/(sr m²).
        pub emission: [f32; 3],
        /// Zero.
        pub _pad1: u32,
    }
}

crate::record! {
    /// What is seen of a voxel of levels ≥ 1 along +x, −x, +y, −y, +z, −z: premultiplied radiance and coverage.
    pub struct VoxelSides: 96 {
        /// One value per direction that the viewer looks along.
        pub sides: [Vec4; 6],
    }
}

crate::record! {
    /// Elements of a prefix sum.
    pub struct ScanParams: 16 {
        /// Elements of the finer array.
        pub count: u32,
        /// Elements before this one count as zero.
        pub first: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
    }
}
