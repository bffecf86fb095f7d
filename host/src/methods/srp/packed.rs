//! A bake in the form of run time's buffers: half floats, receivers padded to vectors, columns in blocks.
//!
//! A pure function of the bake: what it does is tested without an executor. Layouts: `interreflect_shared::srp`.

use super::model::{Cluster, NO_RECEIVER, RAY_INVALID, RAY_MISS, SrpBake};
use interreflect_kernels::math::pack::pack_f16x2_flushed;
use interreflect_kernels::math::sh;
use interreflect_shared::srp::{
    SRP_BLENDED, SRP_EMPTY, SRP_IDENTITY, SRP_LANES, SRP_RANKS, SrpBasisSource, SrpBlend, SrpLayout, SrpProbeParams,
    SrpRankPair, SrpReceiverBlock,
};
use rayon::prelude::*;
use std::f32::consts::PI;
use std::ops::Range;

/// Vectors of receivers, ranks and columns.
const LANES: usize = SRP_LANES as usize;
/// Largest magnitude of a matrix row or column in half floats: well below their end, with 2²⁴ below it until they flush.
const HALF_TOP: f32 = 1024.0;
/// Rays of a slice of the projection, unless asked otherwise: with 64 coefficients the slice's table takes 256 KiB.
pub const SLICE_RAYS: u32 = 1024;

/// Matrix words of one dispatch, and the rows that they serve.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Rows (pairs of ranks, or blocks of receivers).
    pub rows: Range<u32>,
    /// Pairs of half floats.
    pub words: Vec<u32>,
}

/// Everything of a bake that kernels read.
#[derive(Clone, Debug)]
pub struct Packed {
    /// Sizes of the probes' passes, all slices in one dispatch.
    pub probes: SrpProbeParams,
    /// The same as a layout.
    pub layout: SrpLayout,
    /// Slot of each receiver.
    pub slot_of_receiver: Vec<u32>,
    /// Receiver of each slot, [`NO_RECEIVER`] in padding.
    pub receiver_of_slot: Vec<u32>,
    /// Slot that each relight ray meets ([`SrpLayout::ray`]).
    pub hits: Vec<u32>,
    /// Basis functions at the relight rays ([`SrpLayout::table`]).
    pub table: Vec<f32>,
    /// Pairs of ranks of all clusters.
    pub rank_pairs: Vec<SrpRankPair>,
    /// First probe coefficient of each block of columns.
    pub column_blocks: Vec<u32>,
    /// Projection matrices, in as many parts as bindings need.
    pub projection: Vec<Part>,
    /// Components of all light bases.
    pub sources: Vec<SrpBasisSource>,
    /// Blocks of receivers.
    pub receiver_blocks: Vec<SrpReceiverBlock>,
    /// Reconstruction matrices, in as many parts as bindings need.
    pub reconstruction: Vec<Part>,
    /// Texels of the lightmap: slot, blend, or nothing.
    pub atlas: Vec<u32>,
    /// Blends of dilated texels.
    pub dilation: Vec<SrpBlend>,
}

impl Packed {
    /// Packs a bake. `part_bytes`: largest binding, at least that of one cluster.
    pub fn new(bake: &SrpBake, slice_rays: u32, part_bytes: usize) -> Self {
        let probes = SrpProbeParams {
            probe_count: bake.probes.len() as u32,
            ray_count: bake.ray_directions.len() as u32,
            coefficient_count: bake.coefficient_count() as u32,
            slice_rays: even_slices(bake.ray_directions.len() as u32, slice_rays),
            weight: 4.0 * PI / bake.ray_directions.len().max(1) as f32,
            first_slice: 0,
            slice_count: 0,
            _pad0: 0,
        };
        let layout = SrpLayout::new(&probes);
        let probes = SrpProbeParams { slice_count: layout.slices, ..probes };
        let receiver_of_slot = slots(bake);
        let mut slot_of_receiver = vec![0; bake.receivers.len()];
        for (slot, &receiver) in receiver_of_slot.iter().enumerate().filter(|(_, r)| **r != NO_RECEIVER) {
            slot_of_receiver[receiver as usize] = slot as u32;
        }
        let mut packed = Self {
            hits: hits(bake, &layout, &slot_of_receiver, receiver_of_slot.len() as u32),
            table: table(bake, &layout),
            probes,
            layout,
            rank_pairs: Vec::new(),
            column_blocks: Vec::new(),
            projection: Vec::new(),
            sources: Vec::new(),
            receiver_blocks: Vec::new(),
            reconstruction: Vec::new(),
            atlas: Vec::new(),
            dilation: bake.dilation.iter().map(|(_, blend)| blend_of(blend, &slot_of_receiver)).collect(),
            slot_of_receiver,
            receiver_of_slot,
        };
        packed.add_clusters(bake, part_bytes / 4);
        packed.atlas = packed.atlas_of(bake);
        packed
    }

    /// Slots of receivers, padding included.
    pub fn slot_count(&self) -> u32 {
        self.receiver_of_slot.len() as u32
    }

    /// A blend of receivers as one of slots.
    pub fn blend(&self, blend: &super::model::Blend) -> SrpBlend {
        blend_of(blend, &self.slot_of_receiver)
    }

    fn add_clusters(&mut self, bake: &SrpBake, part_words: usize) {
        let rows = bake.rows_per_receiver as usize;
        let packed: Vec<PackedCluster> =
            bake.clusters.par_iter().map(|c| PackedCluster::new(c, bake.coefficient_count() as u32, rows)).collect();
        let (mut projection, mut reconstruction) = (Parts::new(part_words), Parts::new(part_words));
        for cluster in packed {
            let pair_count = cluster.pairs(rows);
            let basis_first = self.sources.len() as u32;
            if cluster.identity {
                self.sources.extend(cluster.scales.iter().enumerate().map(|(rank, &scale)| {
                    // The odd rank's partner has weight 0: any coefficient will do.
                    let column = cluster.columns.get(rank).copied().unwrap_or(0);
                    SrpBasisSource { source: SRP_IDENTITY | column, scale }
                }));
            } else {
                let first_rank = self.rank_pairs.len() as u32 * SRP_RANKS;
                let scales = cluster.scales.iter().enumerate();
                self.sources.extend(scales.map(|(r, &scale)| SrpBasisSource { source: first_rank + r as u32, scale }));
                let words_first = projection.add(&cluster.projection, pair_count as u32);
                let block_pairs = cluster.blocks.len() as u32 / 2;
                self.rank_pairs.extend((0..pair_count as u32).map(|pair| SrpRankPair {
                    words_first: words_first + pair * block_pairs * SRP_RANKS * SRP_LANES,
                    block_first: self.column_blocks.len() as u32,
                    block_pairs,
                    _pad0: 0,
                }));
                self.column_blocks.extend(&cluster.blocks);
            }
            let words_first = reconstruction.add(&cluster.reconstruction, cluster.receiver_blocks as u32);
            self.receiver_blocks.extend((0..cluster.receiver_blocks as u32).map(|block| SrpReceiverBlock {
                words_first: words_first + block * (pair_count * rows * LANES) as u32,
                rank_pairs: pair_count as u32,
                basis_first,
                _pad0: 0,
            }));
        }
        self.projection = projection.parts;
        self.reconstruction = reconstruction.parts;
    }

    fn atlas_of(&self, bake: &SrpBake) -> Vec<u32> {
        let [width, height] = bake.atlas_size;
        let mut map = vec![SRP_EMPTY; width as usize * height as usize];
        let mut set = |[x, y]: [u32; 2], word: u32| {
            if x < width && y < height {
                map[(y * width + x) as usize] = word;
            }
        };
        for (i, (texel, _)) in bake.dilation.iter().enumerate() {
            set(*texel, SRP_BLENDED | i as u32);
        }
        for (texel, &slot) in bake.texel.iter().zip(&self.slot_of_receiver) {
            set(*texel, slot);
        }
        map
    }
}

/// Rays of a slice so that all slices are about as long, at most `most`, and whole vectors.
fn even_slices(rays: u32, most: u32) -> u32 {
    rays.div_ceil(rays.div_ceil(most.max(SRP_LANES)).max(1)).div_ceil(SRP_LANES).max(1) * SRP_LANES
}

/// Receivers in the order of clusters, each cluster padded to whole vectors.
fn slots(bake: &SrpBake) -> Vec<u32> {
    let mut slots = Vec::with_capacity(bake.receivers.len() + bake.clusters.len() * LANES);
    for cluster in &bake.clusters {
        slots.extend(cluster.receivers.clone());
        slots.resize(slots.len().next_multiple_of(LANES), NO_RECEIVER);
    }
    slots
}

/// Slots that relight rays meet; the two special slots after the receivers' are black and the environment.
fn hits(bake: &SrpBake, layout: &SrpLayout, slot_of_receiver: &[u32], slot_count: u32) -> Vec<u32> {
    let (black, environment) = (slot_count, slot_count + 1);
    let mut hits = vec![black; (layout.slices * layout.slice_plane()) as usize];
    let rays = bake.ray_directions.len();
    for (i, &hit) in bake.ray_hits.iter().enumerate() {
        hits[layout.ray((i / rays) as u32, (i % rays) as u32)] = match hit {
            RAY_MISS => environment,
            RAY_INVALID => black,
            receiver => slot_of_receiver[receiver as usize],
        };
    }
    hits
}

fn table(bake: &SrpBake, layout: &SrpLayout) -> Vec<f32> {
    let mut table = vec![0.0; layout.table_len()];
    for (ray, direction) in bake.ray_directions.iter().enumerate() {
        let values: [f32; sh::MAX_COUNT] = sh::basis(direction.to_array());
        for (k, value) in values.iter().enumerate().take(layout.coefs as usize) {
            table[layout.table(k as u32, ray as u32)] = *value;
        }
    }
    table
}

pub(super) fn blend_of(blend: &super::model::Blend, slot_of_receiver: &[u32]) -> SrpBlend {
    let slot = |r: u32| if r == NO_RECEIVER { 0 } else { slot_of_receiver[r as usize] };
    let weight = |k: usize| if blend.receivers[k] == NO_RECEIVER { 0.0 } else { blend.weights[k] };
    SrpBlend { slots: blend.receivers.map(slot), weights: std::array::from_fn(weight) }
}

/// Words in parts of at most a binding's size.
struct Parts {
    parts: Vec<Part>,
    words: usize,
}

impl Parts {
    fn new(words: usize) -> Self {
        Self { parts: vec![Part { rows: 0..0, words: Vec::new() }], words }
    }
    /// Adds a cluster's words, which serve so many rows; gives the index of the first in its part.
    fn add(&mut self, words: &[u32], rows: u32) -> u32 {
        let last = &self.parts[self.parts.len() - 1];
        let end = last.rows.end;
        if !last.words.is_empty() && last.words.len() + words.len() > self.words {
            self.parts.push(Part { rows: end..end, words: Vec::new() });
        }
        let k = self.parts.len() - 1;
        let part = &mut self.parts[k];
        let first = part.words.len() as u32;
        part.words.extend_from_slice(words);
        part.rows.end += rows;
        first
    }
}

/// One cluster's matrices in half floats.
struct PackedCluster {
    identity: bool,
    /// Index of each column's probe coefficient.
    columns: Vec<u32>,
    /// First coefficients of the blocks; an even number.
    blocks: Vec<u32>,
    projection: Vec<u32>,
    reconstruction: Vec<u32>,
    receiver_blocks: usize,
    /// What undoes the scaling of each rank, for an even number of ranks.
    scales: Vec<f32>,
}

impl PackedCluster {
    fn new(cluster: &Cluster, coefficients: u32, rows: usize) -> Self {
        let columns: Vec<u32> =
            cluster.columns.iter().map(|&(slot, k)| cluster.probes[slot as usize] * coefficients + k).collect();
        let rank = cluster.rank as usize;
        let pairs = rank.div_ceil(SRP_RANKS as usize);
        let identity = cluster.projection.is_empty();
        let (blocks, places) = column_blocks(&columns);
        let mut scales = vec![1.0; pairs * SRP_RANKS as usize];
        let rank_major = |values: &mut dyn Iterator<Item = f32>| power_of_two(values.map(f32::abs).fold(0.0, f32::max));
        let mut projection = Vec::new();
        if !identity {
            let row = |r: usize| &cluster.projection[r * columns.len()..(r + 1) * columns.len()];
            let up: Vec<f32> = (0..rank).map(|r| rank_major(&mut row(r).iter().copied())).collect();
            let mut dense = vec![0.0; SRP_RANKS as usize * blocks.len() * LANES];
            for pair in 0..pairs {
                dense.fill(0.0);
                for r in (0..2).filter(|r| 2 * pair + r < rank) {
                    for (&place, value) in places.iter().zip(row(2 * pair + r)) {
                        dense[r * blocks.len() * LANES + place] = value * up[2 * pair + r];
                    }
                }
                for block in (0..blocks.len()).step_by(2) {
                    for r in 0..2 {
                        let first = (r * blocks.len() + block) * LANES;
                        let halves = (0..LANES).map(|l| pack_f16x2_flushed(dense[first + l], dense[first + LANES + l]));
                        projection.extend(halves);
                    }
                }
            }
            scales.iter_mut().zip(&up).for_each(|(s, up)| *s /= up);
        }
        let count = cluster.receivers.len();
        let entry = |receiver: usize, row: usize, r: usize| {
            if receiver < count && r < rank { cluster.reconstruction[(receiver * rows + row) * rank + r] } else { 0.0 }
        };
        let column = |r: usize| rank_major(&mut (0..count * rows).map(|i| entry(i / rows, i % rows, r)));
        let up: Vec<f32> = (0..2 * pairs).map(|r| if r < rank { column(r) } else { 1.0 }).collect();
        scales.iter_mut().zip(&up).for_each(|(s, up)| *s /= up);
        let receiver_blocks = count.div_ceil(LANES);
        let mut reconstruction = Vec::with_capacity(receiver_blocks * pairs * rows * LANES);
        for block in 0..receiver_blocks {
            for pair in 0..pairs {
                for value in 0..rows {
                    let halves = (block * LANES..(block + 1) * LANES).map(|receiver| {
                        let half = |r: usize| entry(receiver, value, r) * up[r];
                        pack_f16x2_flushed(half(2 * pair), half(2 * pair + 1))
                    });
                    reconstruction.extend(halves);
                }
            }
        }
        let blocks = blocks.into_iter().collect();
        Self { identity, columns, blocks, projection, reconstruction, receiver_blocks, scales }
    }

    fn pairs(&self, _rows: usize) -> usize {
        self.scales.len() / SRP_RANKS as usize
    }
}

/// Covers ascending coefficients with blocks of 16 neighbours, an even number of blocks. Gives each block's first
/// coefficient, and each column's place among all lanes of all blocks.
fn column_blocks(columns: &[u32]) -> (Vec<u32>, Vec<usize>) {
    let (mut blocks, mut places): (Vec<u32>, Vec<usize>) = (Vec::new(), Vec::with_capacity(columns.len()));
    for &column in columns {
        if blocks.last().is_none_or(|first| column >= first + SRP_LANES) {
            blocks.push(column);
        }
        let last = blocks.len() - 1;
        places.push(last * LANES + (column - blocks[last]) as usize);
    }
    if blocks.len() % 2 == 1 {
        // Its words are 0.
        blocks.push(0);
    }
    (blocks, places)
}

/// The power of two that takes the largest magnitude of a row to just below [`HALF_TOP`]; 1 for a row of zeros.
fn power_of_two(largest: f32) -> f32 {
    if largest > 0.0 && largest.is_finite() {
        (HALF_TOP / largest).log2().floor().clamp(-100.0, 100.0).exp2()
    } else {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_every_column_once() {
        let columns = [3, 4, 18, 19, 40, 41, 55, 56];
        let (blocks, places) = column_blocks(&columns);
        assert_eq!(blocks, [3, 19, 40, 56]);
        let back: Vec<u32> = places.iter().map(|p| blocks[p / LANES] + (p % LANES) as u32).collect();
        assert_eq!(back, columns);
        assert_eq!(column_blocks(&[7]).0, [7, 0]);
        assert_eq!(column_blocks(&[]).0.len(), 0);
    }

    #[test]
    fn slices_are_even() {
        assert_eq!((even_slices(8000, 1024), even_slices(1024, 1024), even_slices(1025, 1024)), (1008, 1024, 528));
        assert_eq!((even_slices(0, 1024), even_slices(1, 0)), (16, 16));
    }

    #[test]
    fn rows_are_scaled_by_powers_of_two() {
        for largest in [1e-20f32, 1e-3, 0.7, 1024.0, 3e6] {
            let factor = power_of_two(largest);
            assert!(factor.to_bits() & 0x007F_FFFF == 0 && (512.0..=1024.0).contains(&(factor * largest)), "{largest}");
        }
        assert_eq!(power_of_two(0.0), 1.0);
    }

    #[test]
    fn parts_hold_whole_clusters() {
        let mut parts = Parts::new(100);
        assert_eq!((parts.add(&[1; 60], 3), parts.add(&[2; 60], 2), parts.add(&[3; 40], 1)), (0, 0, 60));
        let rows: Vec<_> = parts.parts.iter().map(|p| p.rows.clone()).collect();
        assert_eq!(rows, [0..3, 3..6]);
    }
}
