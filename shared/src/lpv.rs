//! Parameters and records of light propagation volumes (`kernels/src/lpv`).

use glam::{IVec4, UVec4, Vec4};

/// Values of what travels: a constant and a vector of the intensity, and the moment's factor.
pub const FRONT_VALUES: u32 = 5;
/// Values of what is injected: flux and first moment.
pub const FLUX_VALUES: u32 = 4;
/// Values of what has passed: spherical-harmonics coefficients of order 1, then the two of band 2 that tell the axes
/// apart (3z² − 1 and x² − y²).
pub const PASSED_VALUES: u32 = 6;
/// Values of a grid's state: what travels, then what has passed.
pub const STATE_VALUES: u32 = FRONT_VALUES + PASSED_VALUES;
/// Sums of a column of the ledger.
pub const LEDGER_VALUES: u32 = 5;
/// Planes of opacity: one per axis.
pub const OPACITY_PLANES: u32 = 3;
/// Sum of flux in one cell, in units of the fixed-point scale, that is told as an overflow.
pub const FLUX_LIMIT: u32 = 1 << 30;
/// Nested grids, at most.
pub const MAX_CASCADES: usize = 4;
/// Units of area per cell face in the geometry volume.
pub const AREA_UNITS: f32 = 65_536.0;
/// Largest area, in cell faces, that one texel or facet adds: sums of 4096 of them fit a word.
pub const AREA_MOST: f32 = 16.0;

crate::record! {
    /// A grid of cubic cells and one pass over it.
    pub struct LpvParams: 160 {
        /// Point that cell corners are counted from (m); w: side of a cell (m).
        pub anchor_size: Vec4,
        /// Cell, counted from the anchor, that is cell 0 of the grid; w: zero.
        pub first_cell: IVec4,
        /// Cells along x, y, z; w: zero.
        pub dims: UVec4,
        /// Cells along x, y, z of the next coarser grid; w: zero.
        pub coarse_dims: UVec4,
        /// How flux through a face is made a lobe again: moment per flux of a facing face, of a side face along and
        /// across the way of travel; w: 1 restores the first moment, 0 leaves it.
        pub lobe: Vec4,
        /// Texels, facet sides or elements.
        pub count: u32,
        /// Largest mean cosine of lobes; up to a third: order-1 spherical harmonics.
        pub focus: f32,
        /// Fixed-point units per watt.
        pub flux_scale: f32,
        /// Strength of occlusion: 0 none, 1 full.
        pub occlusion: f32,
        /// 1: a cell sends exactly the flux that it holds; 0: what its clamped lobe gives.
        pub gain: f32,
        /// Weight of what is injected among what has passed.
        pub weight: f32,
        /// Weight of an earlier total.
        pub keep: f32,
        /// Factor from the coarser grid's sums to this grid's.
        pub coarse_weight: f32,
        /// Side of a voxel whose facets are read (m).
        pub voxel_size: f32,
        /// Factor of numbers stored as half floats.
        pub half_scale: f32,
        /// Which opacities count: bit 0 facets, bit 1 texels.
        pub opacity_sources: u32,
        /// Streams of light that are kept apart: 1, or 6 by the way that the surface that it comes from faces.
        pub streams: u32,
        /// Stream of this pass.
        pub stream: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Zero.
        pub _pad2: u32,
        /// Centre of the fade of reflected light (m) and, in w, its radius (m).
        pub fade: Vec4,
    }
}

crate::record! {
    /// Nested grids, finest first, and how they are read.
    pub struct LpvQuery: 224 {
        /// As [`LpvParams::anchor_size`].
        pub anchor_size: [Vec4; 4],
        /// As [`LpvParams::first_cell`].
        pub first_cell: [IVec4; 4],
        /// As [`LpvParams::dims`].
        pub dims: [UVec4; 4],
        /// Grids in use.
        pub cascade_count: u32,
        /// Receivers.
        pub count: u32,
        /// Cells over which a grid fades into the next coarser one.
        pub blend: f32,
        /// Start above the surface, in cells.
        pub offset: f32,
        /// Numbers stored as half floats are this many times too large.
        pub half_scale: f32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Zero.
        pub _pad2: u32,
    }
}

/// [`RsmMap::kind`] of the environment's map; lights' maps have the constants of `scene::LIGHT_…`.
pub const MAP_ENVIRONMENT: u32 = 4;

crate::record! {
    /// A reflective shadow map: `resolution²` texels of one light, or a share of the rays from all emissive triangles or
    /// from the environment.
    pub struct RsmMap: 32 {
        /// Centre (m) and radius (m) of a sphere around the scene.
        pub centre_radius: Vec4,
        /// Kind of light.
        pub kind: u32,
        /// Index of the light; of the first emissive triangle among the lights.
        pub light: u32,
        /// Rays of this kind before this map.
        pub first: u32,
        /// Rays of this kind in all maps.
        pub ray_count: u32,
    }
}

crate::record! {
    /// Maps and their size.
    pub struct RsmParams: 48 {
        /// Radiance of the environment, W/(sr m²); w is unused.
        pub environment: Vec4,
        /// Texels along each side of a map; even.
        pub resolution: u32,
        /// First texel that this pass traces.
        pub first: u32,
        /// Texels that this pass traces.
        pub count: u32,
        /// Lights in the buffer.
        pub light_count: u32,
        /// Seed.
        pub seed: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Zero.
        pub _pad2: u32,
    }
}

crate::record! {
    /// Where a light's ray met a surface.
    pub struct RsmTexel: 64 {
        /// Position (m).
        pub position: [f32; 3],
        /// Area of surface that the texel stands for (m²).
        pub area: f32,
        /// Unit normal on the lit side.
        pub normal: [f32; 3],
        /// 1 where a surface was met, else 0 and all is zero.
        pub hit: u32,
        /// Flux that arrives (W).
        pub flux: [f32; 3],
        /// Zero.
        pub _pad0: u32,
        /// Reflectance.
        pub albedo: [f32; 3],
        /// Zero.
        pub _pad1: u32,
    }
}

/// Where the cells of a grid lie in a plane: rows of x with one halo element after each, layers of y with one halo row
/// after each, one halo layer before and after. A neighbour across the border is always a halo element, which stays
/// zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LpvLayout {
    /// Elements from row to row.
    pub pitch: u32,
    /// Elements from layer to layer.
    pub layer: u32,
    /// Element of cell (0, 0, 0).
    pub first: u32,
    /// Elements of one channel of one value: a whole number of rows.
    pub plane: u32,
}

impl LpvLayout {
    /// Elements of one value: three channels, one after the other. A buffer holds its values one after the other.
    #[inline(always)]
    pub fn value(&self) -> u32 {
        3 * self.plane
    }
    /// Rows of a channel, halo included.
    #[inline(always)]
    pub fn rows(&self) -> u32 {
        self.plane / self.pitch
    }
    /// Layout of a grid of these dimensions.
    #[inline(always)]
    pub fn new(dims: UVec4) -> Self {
        let pitch = dims.x + 1;
        let layer = (dims.y + 1) * pitch;
        let first = layer + pitch;
        Self { pitch, layer, first, plane: first + (dims.z + 1) * layer }
    }
    /// Element of a cell.
    #[inline(always)]
    pub fn at(&self, x: u32, y: u32, z: u32) -> u32 {
        self.first + x + y * self.pitch + z * self.layer
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_have_places_of_their_own_and_neighbours_inside_the_plane() {
        let dims = UVec4::new(3, 4, 2, 0);
        let l = LpvLayout::new(dims);
        let mut seen = vec![false; l.plane as usize];
        for (z, y, x) in (0..2).flat_map(|z| (0..4).flat_map(move |y| (0..3).map(move |x| (z, y, x)))) {
            let i = l.at(x, y, z);
            assert!(!std::mem::replace(&mut seen[i as usize], true));
            assert!(i >= l.layer && i + l.layer < l.plane);
        }
        for (z, y, x) in (0..2).flat_map(|z| (0..4).flat_map(move |y| (0..3).map(move |x| (z, y, x)))) {
            let i = l.at(x, y, z);
            let border = [
                (x == 0, i - 1),
                (x == 2, i + 1),
                (y == 0, i - l.pitch),
                (y == 3, i + l.pitch),
                (z == 0, i - l.layer),
                (z == 1, i + l.layer),
            ];
            for (is_border, neighbour) in border {
                assert_eq!(seen[neighbour as usize], !is_border, "{x} {y} {z}");
            }
        }
    }
}
