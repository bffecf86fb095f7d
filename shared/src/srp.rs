//! Parameters of the run-time kernels of sparse radiance probes (`kernels/src/srp`) and the layout of their buffers.
//!
//! A **slot** is a receiver's place in run time's buffers: receivers in the order of clusters, each cluster padded to
//! whole [`SRP_LANES`]. After the receivers' slots come special ones: one that is black, the environment, and one for
//! each dynamic occluder's own light.

use glam::Vec4;

/// Neighbours that lie side by side everywhere: one vector of a CPU, a quarter of a device's workgroup.
pub const SRP_LANES: u32 = 16;
/// Coefficients (of each colour channel) that one invocation of the projection owns.
pub const SRP_BLOCK: u32 = 8;
/// Ranks (rows of a projection matrix) that one invocation of the cluster projection owns.
pub const SRP_RANKS: u32 = 2;
/// Bit of a source of a light basis: the rest is an index of a probe coefficient that is the basis itself.
pub const SRP_IDENTITY: u32 = 1 << 31;
/// Word of the atlas map: no receiver.
pub const SRP_EMPTY: u32 = u32::MAX;
/// Bit of a word of the atlas map: the rest is an index of an [`SrpBlend`].
pub const SRP_BLENDED: u32 = 1 << 31;

crate::record! {
    /// Sizes of `srp_relight`.
    pub struct SrpRelightParams: 16 {
        /// Slots of receivers.
        pub slot_count: u32,
        /// Special slots after them.
        pub special_count: u32,
        /// Factor on indirect irradiance: 1, or less where the loop of bounces must be damped.
        pub feedback: f32,
        /// Zero.
        pub _pad0: u32,
    }
}

crate::record! {
    /// What a receiver's surface does with light; may change at run time.
    pub struct SrpSurface: 32 {
        /// Reflectance.
        pub albedo: [f32; 3],
        /// Zero.
        pub _pad0: u32,
        /// Emitted radiance, W/(sr m²).
        pub emission: [f32; 3],
        /// Zero.
        pub _pad1: u32,
    }
}

crate::record! {
    /// Sizes of the probes' relighting (`srp_gather`, `srp_project`, `srp_probe_sum`).
    pub struct SrpProbeParams: 32 {
        /// Probes.
        pub probe_count: u32,
        /// Relight rays of each probe.
        pub ray_count: u32,
        /// Coefficients of each probe and channel: (order + 1)².
        pub coefficient_count: u32,
        /// Rays of a slice: what one invocation of `srp_project` sums. Fewer: more invocations at once and a slice of the
        /// table and of the light that stays in a processor's cache; more: less to add up afterwards. A multiple of
        /// [`SRP_LANES`]. Default about 1024.
        pub slice_rays: u32,
        /// Factor of every coefficient: 4π/rays for evenly spread directions.
        pub weight: f32,
        /// First slice of this dispatch.
        pub first_slice: u32,
        /// Slices of this dispatch, which share one buffer of light with those of others.
        pub slice_count: u32,
        /// Zero.
        pub _pad0: u32,
    }
}

/// Where rays, partial coefficients and coefficients of probes lie.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SrpLayout {
    /// Probes.
    pub probes: u32,
    /// Coefficients of each.
    pub coefs: u32,
    /// Tiles of [`SRP_LANES`] probes.
    pub tiles: u32,
    /// Blocks of [`SRP_BLOCK`] coefficients.
    pub blocks: u32,
    /// Rays of a slice.
    pub slice_rays: u32,
    /// Slices of rays; the last one is padded.
    pub slices: u32,
}

impl SrpLayout {
    /// Layout for given sizes.
    #[inline(always)]
    pub const fn new(p: &SrpProbeParams) -> Self {
        let slice_rays = if p.slice_rays == 0 { SRP_LANES } else { p.slice_rays };
        Self {
            probes: p.probe_count,
            coefs: p.coefficient_count,
            tiles: p.probe_count.div_ceil(SRP_LANES),
            blocks: p.coefficient_count.div_ceil(SRP_BLOCK),
            slice_rays,
            slices: p.ray_count.div_ceil(slice_rays),
        }
    }
    /// Index of a ray of a probe in the buffer of hits, `[slice][tile][ray of slice][probe % 16]`; light has the same
    /// layout for the slices of one dispatch, in a plane for each channel.
    #[inline(always)]
    pub const fn ray(&self, probe: u32, ray: u32) -> usize {
        let slice = ray / self.slice_rays;
        let row = (slice * self.tiles + probe / SRP_LANES) * self.slice_rays + ray - slice * self.slice_rays;
        (row * SRP_LANES + probe % SRP_LANES) as usize
    }
    /// Entries of a slice in the buffer of hits, and in a plane of light.
    #[inline(always)]
    pub const fn slice_plane(&self) -> u32 {
        self.tiles * self.slice_rays * SRP_LANES
    }
    /// Index of a basis function at a ray in the table: `[k / 8][ray][k % 8]`. Functions beyond the last and rays beyond
    /// the last are 0.
    #[inline(always)]
    pub const fn table(&self, k: u32, ray: u32) -> usize {
        ((k / SRP_BLOCK * self.slices * self.slice_rays + ray) * SRP_BLOCK + k % SRP_BLOCK) as usize
    }
    /// Floats of the table.
    pub const fn table_len(&self) -> usize {
        (self.blocks * self.slices * self.slice_rays * SRP_BLOCK) as usize
    }
    /// Rows of partial coefficients, in the order slice, tile, block.
    #[inline(always)]
    pub const fn partial_rows(&self) -> u32 {
        self.slices * self.tiles * self.blocks
    }
    /// Index of a partial coefficient of a channel: `[channel][k % 8][slice][tile][k / 8][probe % 16]`.
    #[inline(always)]
    pub const fn partial(&self, channel: u32, k: u32, slice: u32, probe: u32) -> usize {
        let row = (slice * self.tiles + probe / SRP_LANES) * self.blocks + k / SRP_BLOCK;
        let plane = channel * SRP_BLOCK + k % SRP_BLOCK;
        ((plane * self.partial_rows() + row) * SRP_LANES + probe % SRP_LANES) as usize
    }
    /// Floats of a channel of coefficients, `[probe][k]`, with [`SRP_LANES`] zeros at its end so that a vector may start
    /// anywhere.
    #[inline(always)]
    pub const fn coef_plane(&self) -> u32 {
        self.probes * self.coefs + SRP_LANES
    }
}

crate::record! {
    /// Rows of a dispatch of `srp_cluster` or `srp_reconstruct`, and sizes of what they read.
    pub struct SrpTransportParams: 32 {
        /// First row of the dispatch. Matrices larger than a binding are split over several dispatches.
        pub first_row: u32,
        /// Rows of the dispatch.
        pub row_count: u32,
        /// Rows of all dispatches.
        pub total_rows: u32,
        /// Floats of a channel of probe coefficients, as [`SrpLayout::coef_plane`].
        pub coef_plane: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Zero.
        pub _pad2: u32,
        /// Zero.
        pub _pad3: u32,
    }
}

crate::record! {
    /// Two rows of a cluster's projection matrix: words `[pair of blocks][row][column % 16]`, each word the halves of two
    /// columns, of the first block of the pair in the low bits.
    pub struct SrpRankPair: 16 {
        /// First word of the matrix in this dispatch's buffer.
        pub words_first: u32,
        /// First of the cluster's blocks of columns: each the index of 16 neighbouring probe coefficients.
        pub block_first: u32,
        /// Pairs of blocks.
        pub block_pairs: u32,
        /// Zero.
        pub _pad0: u32,
    }
}

crate::record! {
    /// Where a component of a cluster's light basis comes from.
    pub struct SrpBasisSource: 8 {
        /// Row of `srp_cluster` (of one rank), or [`SRP_IDENTITY`] and a probe coefficient.
        pub source: u32,
        /// Factor: undoes the scaling of the half floats.
        pub scale: f32,
    }
}

crate::record! {
    /// Components of all light bases of `srp_light_basis`.
    pub struct SrpBasisParams: 16 {
        /// Components.
        pub count: u32,
        /// Rank pairs of all clusters.
        pub pair_count: u32,
        /// Floats of a channel of probe coefficients.
        pub coef_plane: u32,
        /// Zero.
        pub _pad0: u32,
    }
}

crate::record! {
    /// Sixteen neighbouring receivers of a cluster: words `[pair of ranks][value][receiver % 16]`, each word the halves of
    /// two ranks, of the first of the pair in the low bits.
    pub struct SrpReceiverBlock: 16 {
        /// First word of the reconstruction matrix in this dispatch's buffer.
        pub words_first: u32,
        /// Pairs of ranks.
        pub rank_pairs: u32,
        /// First component of the cluster's light basis.
        pub basis_first: u32,
        /// Zero.
        pub _pad0: u32,
    }
}

crate::record! {
    /// A weighted mean of up to four slots.
    pub struct SrpBlend: 32 {
        /// Slots; any valid one where the weight is 0.
        pub slots: [u32; 4],
        /// Weights.
        pub weights: [f32; 4],
    }
}

crate::record! {
    /// Sizes of what is read from slots: `srp_atlas`, `srp_resolve`, `srp_normals`.
    pub struct SrpResolveParams: 16 {
        /// Texels or points.
        pub count: u32,
        /// Slots of receivers.
        pub slot_count: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
    }
}

/// [`SrpOccluder::kind`]: the unit sphere.
pub const SRP_SPHERE: u32 = 0;
/// [`SrpOccluder::kind`]: the cube from −1 to 1.
pub const SRP_CUBE: u32 = 1;

crate::record! {
    /// A moving body that blocks relight rays: a sphere or a cube under any affine transformation (ellipsoids, boxes).
    pub struct SrpOccluder: 64 {
        /// Rows of the matrix that takes world to the body's own coordinates; w is the translation.
        pub local_from_world: [Vec4; 3],
        /// One of the constants `SRP_SPHERE`, `SRP_CUBE`.
        pub kind: u32,
        /// Slot whose radiance a blocked ray sees.
        pub slot: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
    }
}

crate::record! {
    /// Rays and bodies of `srp_occlude` and `srp_occlude_mesh`.
    pub struct SrpOccludeParams: 80 {
        /// Rows of the matrix that takes world to the mesh's own coordinates (`srp_occlude_mesh`).
        pub local_from_world: [Vec4; 3],
        /// Probes.
        pub probe_count: u32,
        /// Relight rays of each probe.
        pub ray_count: u32,
        /// Rays of a slice.
        pub slice_rays: u32,
        /// Bodies.
        pub occluder_count: u32,
        /// Slot whose radiance rays see that the mesh blocks.
        pub slot: u32,
        /// Entries of the buffer of hits.
        pub entry_count: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
    }
}

crate::record! {
    /// A point on a glossy surface and its viewer.
    pub struct SrpGloss: 32 {
        /// Unit direction to the viewer.
        pub wo: [f32; 3],
        /// Width α of the GGX distribution: roughness squared. From 0.01 to 1; narrower counts as that.
        pub alpha: f32,
        /// Reflectance at normal incidence.
        pub f0: [f32; 3],
        /// Zero.
        pub _pad0: u32,
    }
}

crate::record! {
    /// Sizes of `srp_probe_light`.
    pub struct SrpProbeLightParams: 32 {
        /// Points.
        pub count: u32,
        /// Probes.
        pub probe_count: u32,
        /// Coefficients of each probe and channel.
        pub coefficient_count: u32,
        /// Floats of a channel of probe coefficients.
        pub coef_plane: u32,
        /// Radius of the probes' support (m). Larger: smoother, and light from farther away.
        pub radius: f32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Zero.
        pub _pad2: u32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_element_has_a_place_of_its_own() {
        let p = SrpProbeParams {
            probe_count: 19,
            ray_count: 37,
            coefficient_count: 9,
            slice_rays: 16,
            weight: 1.0,
            first_slice: 0,
            slice_count: 3,
            _pad0: 0,
        };
        let layout = SrpLayout::new(&p);
        assert_eq!((layout.tiles, layout.blocks, layout.slices), (2, 2, 3));
        let mut rays = vec![0; (layout.slices * layout.slice_plane()) as usize];
        (0..19 * 37).for_each(|i| rays[layout.ray(i / 37, i % 37)] += 1);
        let mut table = vec![0; layout.table_len()];
        (0..9 * 37).for_each(|i| table[layout.table(i / 37, i % 37)] += 1);
        let mut partial = vec![0; (3 * SRP_BLOCK * layout.partial_rows() * SRP_LANES) as usize];
        for i in 0..3 * 9 * 3 * 19 {
            partial[layout.partial(i / (9 * 3 * 19), i / (3 * 19) % 9, i / 19 % 3, i % 19)] += 1;
        }
        for counts in [&rays, &table, &partial] {
            assert!(counts.iter().all(|&n| n <= 1));
        }
        assert_eq!(rays.iter().sum::<u32>(), 19 * 37);
        assert_eq!(table.iter().sum::<u32>(), 9 * 37);
        assert_eq!(partial.iter().sum::<u32>(), 3 * 9 * 3 * 19);
    }
}
