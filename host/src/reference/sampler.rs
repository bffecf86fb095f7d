//! Owen-scrambled (0, 2)-sequences, padded: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020.
//!
//! A *batch* of samples of one element (pixel or receiver) is a prefix of a scrambled Sobol sequence in every pair of
//! dimensions; pairs are decorrelated by shuffling, batches and elements by their own scrambles. Every number depends
//! on (seed, element, batch, index, dimension pair) alone, so results do not depend on the number of threads.

/// Source of the random numbers of one sample.
#[derive(Clone, Copy, Debug)]
pub struct Sampler {
    scramble: u32,
    reversed_index: u32,
    index_mask: u32,
}

impl Sampler {
    /// Sample `index` of `count` in a batch. `count` need not be a power of two, but stratifies best if it is.
    pub fn new(seed: u32, element: u32, batch: u32, index: u32, count: u32) -> Self {
        let scramble = hash(hash(hash(seed ^ 0x9e37_79b9).wrapping_add(element)).wrapping_add(batch));
        let index_mask = count.max(1).next_power_of_two().wrapping_sub(1);
        Self { scramble, reversed_index: index.reverse_bits(), index_mask }
    }

    /// A stratified point of the unit square [0, 1)² in dimension pair `pair`.
    #[inline(always)]
    pub fn pair(&self, pair: u32) -> [f32; 2] {
        let seed = hash(self.scramble.wrapping_add(pair.wrapping_mul(0x85eb_ca6b)));
        // Shuffle within the batch only: the points stay the net's first ones.
        let i = laine_karras(self.reversed_index, seed).reverse_bits() & self.index_mask;
        let x = laine_karras(i, hash(seed ^ 0x68bc_21eb)).reverse_bits();
        let y = laine_karras(sobol_second_reversed(i), hash(seed ^ 0x02e5_be93)).reverse_bits();
        [unit(x), unit(y)]
    }

    /// The points of reflection number `reflection`: pairs 3, 4 and 5 are those of reflection 1.
    #[inline(always)]
    pub fn points(&self, reflection: u32) -> Points {
        let first = 3 * reflection;
        Points { direction: self.pair(first), place: self.pair(first + 1), choice: self.pair(first + 2) }
    }
}

/// The stratified points of a reflection.
#[derive(Clone, Copy, Debug)]
pub struct Points {
    /// For the direction that leads there.
    pub direction: [f32; 2],
    /// For the place on a light source.
    pub place: [f32; 2],
    /// Which light source, and whether the path goes on.
    pub choice: [f32; 2],
}

/// 32-bit finalizer with good avalanche (Wellons, "lowbias32").
#[inline(always)]
pub fn hash(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ (x >> 16)
}

/// Top 24 bits as a number in [0, 1).
#[inline(always)]
fn unit(x: u32) -> f32 {
    (x >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// Second Sobol dimension with its bits reversed: bit `j` is the parity of all index bits `k ⊇ j` (Pascal's triangle mod 2).
#[inline(always)]
fn sobol_second_reversed(mut index: u32) -> u32 {
    index ^= (index >> 1) & 0x5555_5555;
    index ^= (index >> 2) & 0x3333_3333;
    index ^= (index >> 4) & 0x0f0f_0f0f;
    index ^= (index >> 8) & 0x00ff_00ff;
    index ^ ((index >> 16) & 0x0000_ffff)
}

/// Permutation in which each bit depends on the bits below it, constants by Vegdahl (2021). Between two reversals of the bits
/// it is an Owen scramble: each bit flipped by a hash of the bits above it.
#[inline(always)]
fn laine_karras(mut x: u32, seed: u32) -> u32 {
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_elementary_interval_of_a_batch_holds_one_point() {
        for (seed, pair) in [(0, 0), (1, 5), (77, 3)] {
            let points: Vec<_> = (0..64).map(|i| Sampler::new(seed, 9, 2, i, 64).pair(pair)).collect();
            for log_width in 0..=6u32 {
                let (nx, ny) = (1usize << log_width, 64usize >> log_width);
                let mut seen = vec![0; 64];
                for [x, y] in &points {
                    seen[(x * nx as f32) as usize * ny + (y * ny as f32) as usize] += 1;
                }
                assert!(seen.iter().all(|&n| n == 1), "seed {seed}, pair {pair}, {nx}×{ny} cells: {seen:?}");
            }
        }
    }

    #[test]
    fn pairs_elements_and_batches_are_uncorrelated() {
        let correlation = |other: &dyn Fn(u32) -> f32| {
            let n = 4096;
            let sum: f64 = (0..n)
                .map(|i| f64::from(Sampler::new(3, i, 0, 0, 1).pair(0)[0] - 0.5) * f64::from(other(i) - 0.5))
                .sum();
            sum / f64::from(n) * 12.0
        };
        // The estimate's standard error is 1/√4096 = 0.016.
        assert!(correlation(&|i| Sampler::new(3, i, 0, 0, 1).pair(1)[0]).abs() < 0.065);
        assert!(correlation(&|i| Sampler::new(3, i + 1, 0, 0, 1).pair(0)[0]).abs() < 0.065);
        assert!(correlation(&|i| Sampler::new(3, i, 1, 0, 1).pair(0)[0]).abs() < 0.065);
        assert!(correlation(&|i| Sampler::new(4, i, 0, 0, 1).pair(0)[0]).abs() < 0.065);
        assert!(correlation(&|i| Sampler::new(3, i, 0, 0, 1).pair(0)[1]).abs() < 0.065);
    }
}
