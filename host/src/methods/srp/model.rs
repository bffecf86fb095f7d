//! What the precomputation of sparse radiance probes hands to run time, and run time itself in plain code: the oracle that
//! the kernels are tested against.
//!
//! One update: direct light at the receivers → radiance that leaves them ([`SrpBake::relight`]) → spherical harmonics of
//! what each probe sees ([`SrpBake::project`]) → irradiance at the receivers ([`SrpBake::reconstruct`]) → picture points
//! ([`Blend`]). Several bounces: the irradiance goes back into the next `relight`.
//!
//! **What counts as indirect.** Direct light (lamps without a surface, emissive triangles, environment, each arriving
//! without a reflection) is lit at the receivers by other means. `emission` and `environment` given to the functions here
//! are therefore zero where those are lit directly, and the radiance where probes are to light with them (SL17 §5.1).

use glam::Vec3;
use interreflect_kernels::math::sh;
use interreflect_shared::scene::Surfel;
use rayon::prelude::*;
use std::f64::consts::PI;
use std::ops::Range;

/// [`SrpBake::ray_hits`] of a ray that leaves the scene: it sees the environment.
pub const RAY_MISS: u32 = u32::MAX;
/// [`SrpBake::ray_hits`] of a ray that meets what no receiver lies on: it brings no light.
pub const RAY_INVALID: u32 = u32::MAX - 1;
/// [`Receiver::triangle`] of a receiver in free space.
pub const FREE: u32 = u32::MAX - 1;
/// [`Blend::receivers`] of an unused place; its weight is 0.
pub const NO_RECEIVER: u32 = u32::MAX;

/// A point at which irradiance is reconstructed: a lightmap texel, or a free point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Receiver {
    /// Position on the surface (m).
    pub position: Vec3,
    /// Unit shading normal, on the side that the receiver lights.
    pub normal: Vec3,
    /// Unit normal of the surface, on the same side.
    pub geometric_normal: Vec3,
    /// How far rays must start off the surface (m), as [`Surfel::error`].
    pub error: f32,
    /// Index into the scene's triangles, [`FREE`] without a surface. Rays must not take it for one of device buffers.
    pub triangle: u32,
    /// Whether it lies on the triangle's front.
    pub front: bool,
    /// Surface that it stands for (m²); 0 in free space.
    pub area: f32,
    /// Mean reflectance of that surface as baked; may be replaced at run time.
    pub albedo: Vec3,
    /// Radiance that it emits as baked, W/(sr m²), zero on backs.
    pub emission: Vec3,
}

impl Receiver {
    /// As the direct-light kernel takes it.
    pub fn surfel(&self) -> Surfel {
        Surfel {
            position: self.position.to_array(),
            triangle: self.triangle,
            normal: self.normal.to_array(),
            distance: 0.0,
            geometric_normal: self.geometric_normal.to_array(),
            front: u32::from(self.front),
            albedo: self.albedo.to_array(),
            material: 0,
            emission: self.emission.to_array(),
            error: self.error,
        }
    }
}

/// Everything that run time needs, as baked. Host memory, `f32`; run time packs matrices to 16-bit floats.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct SrpBake {
    /// Order of the probes' spherical harmonics, 0 to 9; `K = (order + 1)²` coefficients.
    pub order: u32,
    /// Numbers that are reconstructed at a receiver: 1 (irradiance) or 4 (order 1 of incident radiance).
    pub rows_per_receiver: u32,
    /// Lightmap texels and free points, in the order of clusters: a cluster owns a contiguous range.
    pub receivers: Vec<Receiver>,
    /// Texel of each receiver, column and row; `[u32::MAX; 2]` for free points.
    pub texel: Vec<[u32; 2]>,
    /// Columns and rows of the lightmap.
    pub atlas_size: [u32; 2],
    /// Texels without a receiver that a bilinear lookup next to one may touch, and the receivers that fill them.
    pub dilation: Vec<([u32; 2], Blend)>,
    /// Positions of the probes (m).
    pub probes: Vec<Vec3>,
    /// Radius of the probes' support (m); SL17 §4.1.
    pub radius: f32,
    /// Unit directions of the relight rays, shared by all probes; each stands for the solid angle `4π / rays`.
    pub ray_directions: Vec<Vec3>,
    /// What each relight ray meets, `[probe][ray]`: a receiver, [`RAY_MISS`] or [`RAY_INVALID`].
    pub ray_hits: Vec<u32>,
    /// Irradiance (W/m²) at each receiver under an environment of radiance 1: π times the open share of its sky.
    pub sky: Vec<f32>,
    /// Clusters of receivers with their transport.
    pub clusters: Vec<Cluster>,
}

/// Neighbouring receivers with the matrix that takes probe coefficients to them: `U (Σ Vᵀ)` (SL17 eq. 11).
#[derive(Clone, PartialEq, Debug)]
pub struct Cluster {
    /// Its receivers.
    pub receivers: Range<u32>,
    /// Probes that light any of them, ascending.
    pub probes: Vec<u32>,
    /// Columns that are not zero: place in `probes`, and SH coefficient. Ascending.
    pub columns: Vec<(u32, u32)>,
    /// Rows of the projection. `columns.len()` where nothing is compressed.
    pub rank: u32,
    /// Σ Vᵀ, `rank × columns.len()`, row-major. Empty: the identity (nothing is compressed).
    pub projection: Vec<f32>,
    /// U, `receivers.len() · rows_per_receiver × rank`, row-major; a receiver's rows lie one after the other.
    pub reconstruction: Vec<f32>,
    /// What compression changed.
    pub loss: Loss,
}

/// What compression changed of a cluster's transport; 0 where nothing is compressed.
#[derive(Clone, Copy, PartialEq, Debug, Default, serde::Serialize)]
pub struct Loss {
    /// Relative error in the metric by which the rank was chosen (root of sums of squares).
    pub transport: f32,
    /// Relative error of what reaches the receivers in lighting states that nothing was fitted to.
    pub light: f32,
    /// Relative error that the transport had already, for its rays are finite in number, in the metric of `transport`.
    pub noise: f32,
}

impl Cluster {
    /// Bytes of its matrices as 16-bit floats; a reconstruction of which most is zero, as codes of a dictionary are,
    /// with 16-bit indices.
    pub fn f16_bytes(&self) -> usize {
        let filled = self.reconstruction.iter().filter(|u| **u != 0.0).count();
        2 * self.projection.len() + (4 * filled).min(2 * self.reconstruction.len())
    }

    /// Bytes of the matrix that it stands for as 16-bit floats, columns of zeros left out.
    pub fn plain_f16_bytes(&self, rows_per_receiver: u32) -> usize {
        2 * self.receivers.len() * rows_per_receiver as usize * self.columns.len()
    }
}

/// A weighted mean of up to four receivers; weights sum to 1, or are all 0 where there is none.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Blend {
    /// Receivers, [`NO_RECEIVER`] where fewer than four.
    pub receivers: [u32; 4],
    /// Their weights.
    pub weights: [f32; 4],
}

impl Blend {
    /// No receiver at all.
    pub const NONE: Self = Self { receivers: [NO_RECEIVER; 4], weights: [0.0; 4] };

    /// The mean of values of all receivers.
    pub fn of(&self, values: &[Vec3]) -> Vec3 {
        let pairs = self.receivers.iter().zip(self.weights);
        pairs.filter(|(r, _)| **r != NO_RECEIVER).map(|(r, w)| values[*r as usize] * w).sum()
    }
}

/// Coefficients of all probes, `[probe][coefficient]` with three colours.
pub type ProbeRadiance = Vec<[f64; 3]>;

impl SrpBake {
    /// SH coefficients per probe.
    pub fn coefficient_count(&self) -> usize {
        sh::count(self.order)
    }

    /// Radiance (W/(sr m²)) that leaves each receiver: `albedo/π · (direct + indirect) + emission`. `emission` is empty
    /// where emitters count as direct light; irradiances in W/m².
    pub fn relight(&self, direct: &[Vec3], indirect: &[Vec3], emission: &[Vec3]) -> Vec<Vec3> {
        let leaving = |(i, r): (usize, &Receiver)| {
            let reflected = r.albedo * (direct[i] + indirect[i]) / std::f32::consts::PI;
            reflected + emission.get(i).copied().unwrap_or(Vec3::ZERO)
        };
        self.receivers.iter().enumerate().map(leaving).collect()
    }

    /// Coefficients of the radiance that arrives at the probes: `λ = 4π/rays · Σ L(hit) Y(direction)` (SL17 §4.2).
    pub fn project(&self, radiance: &[Vec3], environment: Vec3) -> ProbeRadiance {
        let (k, rays) = (self.coefficient_count(), self.ray_directions.len());
        let basis: Vec<[f32; sh::MAX_COUNT]> = self.ray_directions.iter().map(|d| sh::basis(d.to_array())).collect();
        let weight = 4.0 * PI / rays.max(1) as f64;
        let mut coefs = vec![[0.0; 3]; self.probes.len() * k];
        coefs.par_chunks_mut(k).enumerate().for_each(|(probe, coefs)| {
            for (ray, y) in basis.iter().enumerate() {
                let seen = match self.ray_hits[probe * rays + ray] {
                    RAY_MISS => environment,
                    RAY_INVALID => Vec3::ZERO,
                    hit => radiance[hit as usize],
                };
                let seen = seen.as_dvec3() * weight;
                for (c, y) in coefs.iter_mut().zip(y) {
                    let y = f64::from(*y);
                    *c = [c[0] + seen.x * y, c[1] + seen.y * y, c[2] + seen.z * y];
                }
            }
        });
        coefs
    }

    /// What the transport makes of probe coefficients: `rows_per_receiver` values per receiver. One row: irradiance (W/m²).
    /// Four rows: coefficients of incident radiance, of which [`SrpBake::irradiance`] makes irradiance for any normal.
    pub fn reconstruct(&self, coefs: &[[f64; 3]]) -> Vec<Vec3> {
        let k = self.coefficient_count();
        let rows = self.rows_per_receiver as usize;
        let parts: Vec<Vec<Vec3>> = self
            .clusters
            .par_iter()
            .map(|cluster| {
                let inputs: Vec<[f64; 3]> = (cluster.columns.iter())
                    .map(|&(slot, c)| coefs[cluster.probes[slot as usize] as usize * k + c as usize])
                    .collect();
                let basis = if cluster.projection.is_empty() {
                    inputs
                } else {
                    multiply(&cluster.projection, &inputs, cluster.rank as usize)
                };
                let outputs = multiply(&cluster.reconstruction, &basis, cluster.receivers.len() * rows);
                outputs.iter().map(|&[r, g, b]| Vec3::new(r as f32, g as f32, b as f32)).collect()
            })
            .collect();
        parts.concat()
    }

    /// Irradiance (W/m²) at each receiver for its own normal, from what [`SrpBake::reconstruct`] gives.
    pub fn irradiance(&self, reconstructed: &[Vec3]) -> Vec<Vec3> {
        if self.rows_per_receiver == 1 {
            return reconstructed.to_vec();
        }
        let of = |(r, rows): (&Receiver, &[Vec3])| {
            let channel =
                |c: usize| sh::irradiance(&[rows[0][c], rows[1][c], rows[2][c], rows[3][c]], r.normal.to_array());
            Vec3::new(channel(0), channel(1), channel(2))
        };
        self.receivers.iter().zip(reconstructed.chunks_exact(4)).map(of).collect()
    }

    /// Indirect irradiance (W/m²) at each receiver after a number of bounces, from direct irradiance there.
    pub fn bounce(&self, direct: &[Vec3], bounces: u32) -> Vec<Vec3> {
        let mut indirect = vec![Vec3::ZERO; self.receivers.len()];
        for _ in 0..bounces {
            let radiance = self.relight(direct, &indirect, &[]);
            indirect = self.irradiance(&self.reconstruct(&self.project(&radiance, Vec3::ZERO)));
        }
        indirect
    }
}

impl SrpBake {
    /// Part of its light that a further bounce keeps: the largest eigenvalue of relight, projection and reconstruction, of
    /// the colour channel that keeps most, by power iteration. At 1 or more, bounces grow without bound.
    pub fn feedback_gain(&self, iterations: u32) -> f64 {
        let none = vec![Vec3::ZERO; self.receivers.len()];
        let norm = |e: &[Vec3]| e.iter().fold(glam::DVec3::ZERO, |s, e| s + e.as_dvec3() * e.as_dvec3()).map(f64::sqrt);
        let mut light = vec![Vec3::ONE; self.receivers.len()];
        let mut gain = glam::DVec3::ZERO;
        for _ in 0..iterations {
            let next = self.irradiance(&self.reconstruct(&self.project(&self.relight(&none, &light, &[]), Vec3::ZERO)));
            let (before, after) = (norm(&light), norm(&next));
            gain = after / before.max(glam::DVec3::splat(f64::MIN_POSITIVE));
            // To norm 1 in every channel that has light.
            let scale = after.map(|n| if n > 0.0 { 1.0 / n } else { 0.0 }).as_vec3();
            light = next.into_iter().map(|e| e * scale).collect();
        }
        gain.max_element()
    }
}

/// A row-major matrix of `rows` rows times three columns.
fn multiply(matrix: &[f32], columns: &[[f64; 3]], rows: usize) -> Vec<[f64; 3]> {
    let row = |r: usize| {
        let weights = &matrix[r * columns.len()..(r + 1) * columns.len()];
        weights.iter().zip(columns).fold([0.0; 3], |sum, (&w, x)| {
            let w = f64::from(w);
            [sum[0] + w * x[0], sum[1] + w * x[1], sum[2] + w * x[2]]
        })
    };
    (0..rows).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One probe at the centre of a white, uniformly lit sphere of receivers: constant radiance arrives.
    #[test]
    fn uniform_radiance_has_one_coefficient() {
        let rays = 512;
        let receiver = Receiver {
            position: Vec3::X,
            normal: -Vec3::X,
            geometric_normal: -Vec3::X,
            error: 0.0,
            triangle: 0,
            front: true,
            area: 1.0,
            albedo: Vec3::splat(0.5),
            emission: Vec3::ZERO,
        };
        let spiral = |i: u32| {
            let z = 1.0 - (2.0 * i as f32 + 1.0) / rays as f32;
            let phi = i as f32 * 2.399_963_2;
            let r = (1.0 - z * z).sqrt();
            Vec3::new(r * phi.cos(), r * phi.sin(), z)
        };
        // The only column is Y₀, whose irradiance is π Y₀ = √π/2 times the coefficient.
        let cluster = Cluster {
            receivers: 0..1,
            probes: vec![0],
            columns: vec![(0, 0)],
            rank: 1,
            projection: Vec::new(),
            reconstruction: vec![0.5 * (PI as f32).sqrt()],
            loss: Loss::default(),
        };
        let bake = SrpBake {
            order: 2,
            rows_per_receiver: 1,
            receivers: vec![receiver],
            texel: vec![[0, 0]],
            atlas_size: [1, 1],
            probes: vec![Vec3::ZERO],
            radius: 2.0,
            ray_directions: (0..rays).map(spiral).collect(),
            ray_hits: vec![0; rays as usize],
            sky: vec![0.0],
            clusters: vec![cluster.clone()],
            ..SrpBake::default()
        };
        // Radiance 1/π·0.5·(2π) = 1 leaves the wall; π arrives back.
        let once = bake.bounce(&[Vec3::splat(2.0 * PI as f32)], 1);
        assert!((once[0] - Vec3::splat(PI as f32)).abs().max_element() < 1e-5, "{}", once[0]);
        // Bounces are a geometric series of ratio 1/2.
        let many = bake.bounce(&[Vec3::splat(2.0 * PI as f32)], 40);
        assert!((many[0] - Vec3::splat(2.0 * PI as f32)).abs().max_element() < 1e-4, "{}", many[0]);
        // The same through a factored matrix.
        let factored = Cluster { projection: vec![2.0], reconstruction: vec![0.25 * (PI as f32).sqrt()], ..cluster };
        let again = SrpBake { clusters: vec![factored], ..bake.clone() }.bounce(&[Vec3::splat(2.0 * PI as f32)], 1);
        assert_eq!(once, again);
        // Without receivers only the environment is left.
        let open = SrpBake { ray_hits: vec![RAY_MISS; rays as usize], ..bake };
        let coefs = open.project(&[Vec3::ONE], Vec3::new(1.0, 2.0, 3.0));
        assert!((coefs[0][2] - 3.0 * (4.0 * PI).sqrt()).abs() < 1e-5);
        assert!(coefs[1..].iter().flatten().all(|c| c.abs() < 0.02));
    }
}
