//! What another renderer imports to light surfaces from a voxel pyramid.
//!
//! [`diffuse_irradiance`] gathers at any point with any set of cones; [`trace_cone`] is one cone, for reflections or
//! ambient occlusion (w of its result).

pub use super::gather::diffuse_irradiance;
pub use super::march::{ConeMarch, trace_cone};
pub use crate::voxel::query::VoxelPyramid;
