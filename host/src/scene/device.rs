//! The scene packed into the buffers that kernels read (`interreflect_shared::scene`).

use crate::exec::BufferId;

/// Buffers of one scene in one executor.
#[derive(Clone, Copy, Debug)]
pub struct SceneBuffers {
    /// `[BvhNode]`.
    pub nodes: BufferId,
    /// `[SceneTriangle]`.
    pub triangles: BufferId,
    /// `[TriangleAttributes]`.
    pub attributes: BufferId,
    /// Words: `SceneMaterial`s, then texels.
    pub surfaces: BufferId,
    /// `[SceneLight]`: lights without a surface, then emissive triangles.
    pub lights: BufferId,
    /// Number of lights (the buffer of an unlit scene holds one zero light).
    pub light_count: u32,
    /// Number of triangles.
    pub triangle_count: u32,
}
