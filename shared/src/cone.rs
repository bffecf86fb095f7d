//! Parameters of cone tracing (`kernels/src/cone`).

use glam::{UVec4, Vec4};

/// Cones of a diffuse set, at most.
pub const MAX_CONES: usize = 16;

crate::record! {
    /// A voxel pyramid, a set of cones, and how they march.
    pub struct ConeParams: 768 {
        /// As in [`crate::voxel::VoxelParams`].
        pub origin_size: Vec4,
        /// As in [`crate::voxel::VoxelParams`].
        pub dims_levels: UVec4,
        /// As in [`crate::voxel::VoxelParams`].
        pub levels: [UVec4; 10],
        /// Unit directions with the surface's normal as z; w: weights that add up to 1.
        pub cones: [Vec4; 16],
        /// Each cone's part of the hemisphere: squared cosines of its inner and outer edge, first azimuth and range of azimuths
        /// in turns.
        pub parts: [Vec4; 16],
        /// Radiance of what the cones find beyond the grid, W/(sr m²); w is unused. Zero for indirect light, whose first
        /// surface is never the sky.
        pub beyond: Vec4,
        /// Camera of `cone_glossy` (m); w: tangent of half the glossy cone's angle.
        pub camera: Vec4,
        /// Cones in use.
        pub cone_count: u32,
        /// Directions stored in levels ≥ 1.
        pub direction_count: u32,
        /// Receivers.
        pub count: u32,
        /// Mixed into the random direction of each receiver's cones; 0 leaves every cone in the middle of its part.
        pub seed: u32,
        /// Size of the voxels that a diffuse cone reads, per distance. A cone's width would be 2·tan(half angle); less
        /// sees finer detail and its own surface less, and takes more steps.
        pub spread: f32,
        /// Start of cones above the surface, in voxels. Less sees more of corners, and more of the surface itself.
        pub offset: f32,
        /// Size of the voxels read, at most, per height above the surface. Up to 1 no cone meets the middle of its own surface's
        /// voxels, behind which the surface would hide what low cones see.
        pub clearance: f32,
        /// Zero.
        pub _pad: f32,
    }
}
