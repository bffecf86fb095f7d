//! Parameters of the spherical-harmonics kernels (`kernels/src/sh`) and the layout of their buffers.

use glam::Vec4;

/// Elements side by side in a tile: a workgroup of a device, four vectors of a CPU.
pub const SH_TILE: u32 = 64;
/// Coefficients (of each colour channel) that one invocation owns.
pub const SH_BLOCK: u32 = 4;

crate::record! {
    /// Size of a projection or an evaluation. Buffers are padded to whole tiles of elements and whole blocks of
    /// coefficients; the padding of elements is computed like the rest, the padding of coefficients is 0.
    pub struct ShParams: 16 {
        /// Elements (probes, cells, receivers).
        pub element_count: u32,
        /// Samples of each element.
        pub sample_count: u32,
        /// Order, 0 to 9: more bands hold sharper light and cost (order + 1)² coefficients. Default 2.
        pub order: u32,
        /// Factor of every coefficient: 4π/samples for evenly spread directions.
        pub weight: f32,
    }
}

crate::record! {
    /// Size and band factors of `sh_filter`.
    pub struct ShFilterParams: 64 {
        /// Elements.
        pub element_count: u32,
        /// Order, 0 to 9.
        pub order: u32,
        /// Zero.
        pub _pad0: u32,
        /// Zero.
        pub _pad1: u32,
        /// Factor of band `l` in component `l % 4` of vector `l / 4`.
        pub factors: [Vec4; 3],
    }
}

impl ShFilterParams {
    /// Parameters with a factor for each band.
    pub fn new(element_count: u32, order: u32, factors: &[f32; 10]) -> Self {
        let f = |l: usize| if l < 10 { factors[l] } else { 0.0 };
        let vector = |l: usize| Vec4::new(f(l), f(l + 1), f(l + 2), f(l + 3));
        Self { element_count, order, _pad0: 0, _pad1: 0, factors: [vector(0), vector(4), vector(8)] }
    }
}

/// Where the coefficients of elements lie: `[channel][k % 4][tile][k / 4][element % 64]`, so that an invocation owns four
/// neighbouring coefficients of three channels and a tile's coefficients lie together.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ShLayout {
    /// Tiles of elements.
    pub tiles: u32,
    /// Blocks of coefficients.
    pub blocks: u32,
}

impl ShLayout {
    /// Layout of `element_count` elements of an order (above 9 counts as 9).
    #[inline(always)]
    pub const fn new(element_count: u32, order: u32) -> Self {
        let order = if order > 9 { 9 } else { order };
        Self { tiles: element_count.div_ceil(SH_TILE), blocks: ((order + 1) * (order + 1)).div_ceil(SH_BLOCK) }
    }
    /// Elements with padding.
    #[inline(always)]
    pub const fn padded_elements(&self) -> u32 {
        self.tiles * SH_TILE
    }
    /// Floats of a plane: of every fourth coefficient of one channel.
    #[inline(always)]
    pub const fn plane(&self) -> u32 {
        self.tiles * self.blocks * SH_TILE
    }
    /// Floats of the whole buffer.
    pub const fn len(&self) -> usize {
        (3 * SH_BLOCK * self.plane()) as usize
    }
    /// Whether there are no elements.
    pub const fn is_empty(&self) -> bool {
        self.tiles == 0
    }
    /// Index of coefficient `k` of a channel of an element.
    #[inline(always)]
    pub const fn coef(&self, channel: u32, k: u32, element: u32) -> usize {
        let row = element / SH_TILE * self.blocks + k / SH_BLOCK;
        ((channel * SH_BLOCK + k % SH_BLOCK) * self.plane() + row * SH_TILE + element % SH_TILE) as usize
    }
    /// Index in a buffer of samples (radiance or directions) of component `axis` of a sample of an element:
    /// `[tile][sample][axis][element % 64]`.
    #[inline(always)]
    pub const fn sample(element: u32, sample: u32, axis: u32, sample_count: u32) -> usize {
        (((element / SH_TILE * sample_count + sample) * 3 + axis) * SH_TILE + element % SH_TILE) as usize
    }
    /// Floats of a buffer of samples.
    pub const fn samples_len(&self, sample_count: u32) -> usize {
        (self.tiles * sample_count * 3 * SH_TILE) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_coefficient_has_a_place_of_its_own() {
        let layout = ShLayout::new(70, 2);
        let mut seen = vec![0; layout.len()];
        for channel in 0..3 {
            for k in 0..9 {
                for element in 0..70 {
                    seen[layout.coef(channel, k, element)] += 1;
                }
            }
        }
        assert_eq!((layout.len(), seen.iter().sum::<i32>(), seen.iter().max()), (3 * 12 * 128, 3 * 9 * 70, Some(&1)));
        let mut seen = vec![0; layout.samples_len(5)];
        (0..128 * 5 * 3).for_each(|i| seen[ShLayout::sample(i / 15, i / 3 % 5, i % 3, 5)] += 1);
        assert!(seen.iter().all(|&n| n == 1));
        assert_eq!(ShLayout::new(1, 12), ShLayout::new(1, 9));
    }

    #[test]
    fn band_factors_fill_the_vectors_in_order() {
        let p = ShFilterParams::new(1, 9, &core::array::from_fn(|l| l as f32));
        assert_eq!((p.factors[0].y, p.factors[1].x, p.factors[2].y, p.factors[2].w), (1.0, 4.0, 9.0, 0.0));
    }
}
