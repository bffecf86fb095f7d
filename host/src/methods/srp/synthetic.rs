//! Random bakes of given sizes: for benchmarks at the papers' dimensions, and for tests of run time alone.

use super::model::{Blend, Cluster, Loss, RAY_INVALID, RAY_MISS, Receiver, SrpBake};
use glam::Vec3;
use interreflect_kernels::math::rng::{hash, unit};
use interreflect_kernels::math::sampling::spherical_fibonacci;

/// Sizes of a random bake.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Probes.
    pub probes: u32,
    /// Order of their spherical harmonics.
    pub order: u32,
    /// Relight rays per probe.
    pub rays: u32,
    /// Clusters.
    pub clusters: u32,
    /// Mean of the clusters' ranks; 0 leaves clusters uncompressed.
    pub mean_rank: f64,
    /// Mean of the clusters' supporting probes.
    pub mean_probes: f64,
    /// Receivers.
    pub receivers: u32,
    /// Rows of the reconstruction per receiver, 1 or 4.
    pub rows_per_receiver: u32,
    /// Side of the lightmap in texels.
    pub atlas_side: u32,
}

/// Sponza in Silvennoinen & Lehtinen 2017, Table 1, with order 7 and 8000 relight rays.
pub const SPONZA: Sizes = Sizes {
    probes: 150,
    order: 7,
    rays: 8000,
    clusters: 935,
    mean_rank: 24.41,
    mean_probes: 20.17,
    receivers: 246_325,
    rows_per_receiver: 1,
    atlas_side: 1216,
};

/// Radiance that comes back as irradiance over π, at most, of the transport that [`bake`] makes.
const GAIN: f32 = 0.5;

struct Random(u32);
impl Random {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9);
        hash(self.0)
    }
    fn unit(&mut self) -> f32 {
        unit(self.bits())
    }
    fn signed(&mut self) -> f32 {
        2.0 * self.unit() - 1.0
    }
    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit())
    }
    fn direction(&mut self) -> Vec3 {
        spherical_fibonacci(self.bits() % 4096, 4096)
    }
}

/// A random bake with exactly these sizes (means to a thousandth). Relight rays meet neighbouring receivers in runs, as those
/// of a scene do: a third of all rays goes on where the last one hit. One in 64 misses, one in 128 meets a back.
pub fn bake(sizes: &Sizes, seed: u32) -> SrpBake {
    let mut random = Random(hash(seed));
    let receivers: Vec<Receiver> = (0..sizes.receivers).map(|_| receiver(&mut random)).collect();
    let texel = texels(sizes);
    let rays = u64::from(sizes.probes) * u64::from(sizes.rays);
    let mut last = 0;
    let ray_hits = (0..rays)
        .map(|_| {
            let bits = random.bits();
            last = if bits.is_multiple_of(3) { last + 1 } else { random.bits() } % sizes.receivers.max(1);
            match bits >> 8 {
                b if b % 64 == 0 => RAY_MISS,
                b if b % 128 == 1 => RAY_INVALID,
                _ => last,
            }
        })
        .collect();
    let ranks = spread(sizes.clusters, sizes.mean_rank, 32.0, &mut random);
    let supports = spread(sizes.clusters, sizes.mean_probes, f64::from(sizes.probes), &mut random);
    let clusters = (0..sizes.clusters as usize).map(|c| {
        let first = (c as u64 * u64::from(sizes.receivers) / u64::from(sizes.clusters)) as u32;
        let end = ((c as u64 + 1) * u64::from(sizes.receivers) / u64::from(sizes.clusters)) as u32;
        cluster(sizes, first..end, ranks[c], supports[c], &mut random)
    });
    SrpBake {
        order: sizes.order,
        rows_per_receiver: sizes.rows_per_receiver,
        clusters: clusters.collect(),
        dilation: dilation(sizes, &texel),
        texel,
        receivers,
        atlas_size: [sizes.atlas_side; 2],
        probes: (0..sizes.probes).map(|_| random.vector() * 10.0).collect(),
        radius: 4.0,
        ray_directions: (0..sizes.rays).map(|i| spherical_fibonacci(i, sizes.rays)).collect(),
        ray_hits,
        sky: vec![0.0; sizes.receivers as usize],
    }
}

fn receiver(random: &mut Random) -> Receiver {
    let normal = random.direction();
    Receiver {
        position: random.vector() * 10.0,
        normal,
        geometric_normal: normal,
        error: 1e-5,
        triangle: 0,
        front: true,
        area: 1e-3,
        albedo: random.vector(),
        emission: random.vector() * 0.1,
    }
}

/// Numbers around a mean, at least 1 and at most `most`, whose sum is that of the mean.
fn spread(count: u32, mean: f64, most: f64, random: &mut Random) -> Vec<u32> {
    let width = (most - mean).min(mean - 1.0).max(0.0);
    let total = (f64::from(count) * mean).round() as i64;
    let mut values: Vec<i64> = (0..count).map(|_| (mean + width * f64::from(random.signed())).round() as i64).collect();
    let mut rest = total - values.iter().sum::<i64>();
    // What rounding left, one by one where there is room.
    let mut i = 0;
    while rest != 0 && count > 0 && i < 64 * values.len() {
        let k = i % values.len();
        let changed = values[k] + rest.signum();
        if (1..=most as i64).contains(&changed) {
            values[k] = changed;
            rest -= rest.signum();
        }
        i += 1;
    }
    values.into_iter().map(|v| v.max(0) as u32).collect()
}

fn cluster(sizes: &Sizes, receivers: std::ops::Range<u32>, rank: u32, support: u32, random: &mut Random) -> Cluster {
    let coefs = (sizes.order + 1) * (sizes.order + 1);
    // Neighbouring probes mostly lie next to each other.
    let mut probes: Vec<u32> = Vec::new();
    let mut next = random.bits() % sizes.probes.max(1);
    while (probes.len() as u32) < support.min(sizes.probes) {
        if !probes.contains(&next) {
            probes.push(next);
        }
        next = if random.bits().is_multiple_of(4) { random.bits() } else { next + 1 } % sizes.probes;
    }
    probes.sort_unstable();
    let columns: Vec<(u32, u32)> =
        (0..probes.len() as u32).flat_map(|slot| (0..coefs).map(move |k| (slot, k))).collect();
    let rows = receivers.len() * sizes.rows_per_receiver as usize;
    let identity = sizes.mean_rank == 0.0;
    let rank = if identity { columns.len() as u32 } else { rank };
    // Small enough that bounces fade: transport of a smooth lobe per supporting probe.
    let share = GAIN / (f32::from(probes.len().max(1) as u16) * (rank.max(1) as f32).sqrt());
    let projection = if identity { Vec::new() } else { numbers(rank as usize * columns.len(), 0.1, random) };
    let reconstruction = numbers(rows * rank as usize, if identity { share * 0.1 } else { share }, random);
    Cluster { receivers, probes, columns, rank, projection, reconstruction, loss: Loss::default() }
}

fn numbers(count: usize, scale: f32, random: &mut Random) -> Vec<f32> {
    (0..count).map(|_| scale * random.signed()).collect()
}

/// Side of a chart of the lightmap in texels, and of the gap to the next.
const CHART: u32 = 24;
const GAP: u32 = 2;

/// Texels in square charts; the last charts overlap nothing, but a lightmap that is too small holds only the first.
fn texels(sizes: &Sizes) -> Vec<[u32; 2]> {
    let across = (sizes.atlas_side / (CHART + GAP)).max(1);
    let place = |i: u32| {
        let (chart, at) = (i / (CHART * CHART), i % (CHART * CHART));
        [chart % across * (CHART + GAP) + at % CHART, chart / across * (CHART + GAP) + at / CHART]
    };
    (0..sizes.receivers).map(place).collect()
}

/// The free texels around receivers.
fn dilation(sizes: &Sizes, texel: &[[u32; 2]]) -> Vec<([u32; 2], Blend)> {
    let side = sizes.atlas_side;
    let mut taken = vec![false; side as usize * side as usize];
    texel.iter().filter(|t| t[0] < side && t[1] < side).for_each(|[x, y]| taken[(y * side + x) as usize] = true);
    let mut dilation = Vec::new();
    for (receiver, &[x, y]) in texel.iter().enumerate() {
        for (dx, dy) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
            let (x, y) = (x.wrapping_add_signed(dx), y.wrapping_add_signed(dy));
            if x < side && y < side && !taken[(y * side + x) as usize] {
                taken[(y * side + x) as usize] = true;
                let receivers = [receiver as u32; 4];
                dilation.push(([x, y], Blend { receivers, weights: [0.25; 4] }));
            }
        }
    }
    dilation
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_exact() {
        let sizes = Sizes {
            probes: 12,
            order: 2,
            rays: 64,
            clusters: 40,
            mean_rank: 9.3,
            mean_probes: 5.5,
            receivers: 1003,
            rows_per_receiver: 1,
            atlas_side: 64,
        };
        let bake = bake(&sizes, 1);
        let total = |f: fn(&Cluster) -> usize| bake.clusters.iter().map(f).sum::<usize>();
        assert_eq!((bake.receivers.len(), bake.probes.len(), bake.ray_hits.len()), (1003, 12, 12 * 64));
        assert_eq!((total(|c| c.rank as usize), total(|c| c.probes.len())), (372, 220));
        assert_eq!(total(|c| c.receivers.len()), 1003);
        let mut texels = bake.texel.clone();
        texels.sort_unstable();
        texels.dedup();
        assert_eq!(texels.len(), 1003);
        assert!(bake.clusters.iter().all(|c| c.columns.len() == 9 * c.probes.len()));
        assert_eq!(super::bake(&sizes, 1), bake);
    }
}
