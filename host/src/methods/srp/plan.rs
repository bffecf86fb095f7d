//! Precomputation from beginning to end. [`Plan`] is all that is quick: receivers, probes, clusters. Each cluster's transport
//! then depends on the plan alone, so that clusters can be computed in any order, on any number of threads and in several
//! runs with the same bits; [`Plan::finish`] puts them together.

use super::atlas::{Atlas, Lookup, free_receiver};
use super::charts::Patches;
use super::compress::{Block, Compression};
use super::memo::Memo;
use super::model::{Cluster, FREE, NO_RECEIVER, RAY_INVALID, RAY_MISS, Receiver, SrpBake};
use super::orders::{self, LeftOut, Whole};
use super::probes::{self, Coverage, Placement, Wish};
use super::reach::Reach;
use super::round_trip::{self, RoundTrip, Verdict};
use super::transport::{self, Estimate, Rays, Scratch, Transport};
use super::visibility::Visibility;
use super::world::{Seen, Structures, World, frame};
use crate::methods::MethodError;
use glam::Vec3;
use interreflect_kernels::math::sampling::{cosine_hemisphere, hammersley, spherical_fibonacci};
use interreflect_kernels::math::sh;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::sync::{Arc, OnceLock};

/// Rays by which receivers inside solids are found.
pub(super) const VALIDITY_RAYS: u32 = 64;
/// Receivers of which more than this share of rays meets the inside of solids are dropped.
const INSIDE_ALLOWED: f32 = 0.5;
/// Surfaces nearer than this many texels count as the inside of solids there.
const GAP: f32 = 0.2;
/// Probes have this order at least, where they are asked for it, for what else they light (`srp_probe_light`).
const LEAST_ORDER: u32 = 2;
/// One receiver in so many of a cluster says how much of its transport is noise.
const WITNESSES: usize = 8;
/// Sides this much shorter than the longest are as long.
const NEARLY: f32 = 0.99;
/// The middle of a side, beside which rows of texels do not lie.
const MIDDLE: f32 = 0.5013;
/// Chart overlaps are found at texels this much larger than the scene's area over the receivers allows for.
const PATCH_TEXEL: f32 = 1.0;

/// What is baked.
#[derive(Clone, PartialEq, Debug)]
pub struct BakeOptions {
    /// Lightmap texels with a receiver, about. More: finer shadows; precomputation and memory in proportion.
    pub receivers: u32,
    /// Receivers in free space beside them: position and unit normal.
    pub free: Vec<(Vec3, Vec3)>,
    /// Probes to place. More: less blur near small sources; the cost of projection in proportion.
    pub probes: u32,
    /// Probes at given places instead.
    pub probe_positions: Option<Vec<Vec3>>,
    /// Candidates of placement.
    pub placement: Placement,
    /// Order of the probes' spherical harmonics, 0 to 9.
    pub order: u32,
    /// Share of what reaches a cluster's receivers, as amplitude, that may be lost with the highest bands of its probes
    /// ([`super::orders`]); 0: all have the whole order. Higher: smaller matrices, quicker bakes, less contrast.
    pub order_error: f32,
    /// Window on the bands of what probes see, applied to the transport's columns: run time does not know of it.
    pub window: Window,
    /// Rays per receiver.
    pub rays: u32,
    /// Rays per probe at run time.
    pub relight_rays: u32,
    /// Probes in whose support a receiver lies, on average (SL17: 10).
    pub overlap: f32,
    /// Exponent of the solid angle per area at which a probe sees what a ray met, as a factor of its weight. 0: SL17's
    /// weights. Higher: probes that resolve the surface better count for more.
    pub sharpness: f32,
    /// Largest share of receivers that may see no probe in support before probes are added; those in gaps narrower than a
    /// texel, which are counted apart, are left out.
    pub unseen_bound: f32,
    /// Probes that may be added for that, as a share of those placed: no more are added than that takes.
    pub added_probes: f32,
    /// Ridge of the correction of transport by its round trip (see [`round_trip`]), relative to the mean of the diagonal; 0:
    /// not corrected. Lower: nearer to the truth for light like that which it is fitted to, more noise from other light.
    pub ridge: f32,
    /// Whether probes' visibility is decided once per texel where all of it agrees, instead of for every ray.
    pub texel_visibility: bool,
    /// 1: irradiance; 4: order 1 of radiance.
    pub rows: u32,
    /// Most receivers of a cluster (SL17: 1024).
    pub cluster_size: u32,
    /// Compression of transport.
    pub compression: Compression,
    /// Whether compression keeps what transport makes of light, instead of the matrix itself.
    pub light_metric: bool,
    /// Seed of the walks.
    pub seed: u32,
}

impl Default for BakeOptions {
    fn default() -> Self {
        Self {
            receivers: 8192,
            free: Vec::new(),
            probes: 27,
            probe_positions: None,
            placement: Placement::default(),
            order: 7,
            order_error: 0.005,
            window: Window::None,
            rays: 512,
            relight_rays: 2048,
            overlap: 10.0,
            sharpness: 1.0,
            unseen_bound: 0.005,
            added_probes: 4.0,
            ridge: 1e-2,
            texel_visibility: true,
            rows: 1,
            cluster_size: 1024,
            compression: Compression::default(),
            light_metric: true,
            seed: 1,
        }
    }
}

/// Window on bands of spherical harmonics, as wide as the order (Sloan 2008).
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Window {
    /// None: sharpest, rings.
    #[default]
    None,
    /// Rings least, loses most contrast.
    Hanning,
    /// Between the two.
    Lanczos,
}

impl Window {
    /// Multiplies transport, of which each row holds all coefficients of one probe after the other.
    pub fn apply(self, matrix: &mut [f32], order: u32) {
        let width = (order + 1) as f32;
        let factor = |l: u32| match self {
            Self::None => 1.0,
            Self::Hanning => sh::hanning_window(l, width),
            Self::Lanczos => sh::lanczos_window(l, width),
        };
        if self != Self::None {
            let factors: Vec<f32> = (0..sh::count(order)).map(|c| factor(sh::band(c))).collect();
            matrix.par_chunks_exact_mut(factors.len()).for_each(|probe| {
                probe.iter_mut().zip(&factors).for_each(|(x, f)| *x *= f);
            });
        }
    }
}

/// Everything but transport.
pub struct Plan<'a> {
    /// What is baked.
    pub options: BakeOptions,
    /// The scene.
    pub world: World<'a>,
    /// Voxels and exposed sides.
    pub reach: Arc<Reach>,
    /// The lightmap.
    pub atlas: Arc<Atlas>,
    /// Receivers that count, with their texel ([`NO_RECEIVER`] in free space).
    pub receivers: Arc<Vec<(Receiver, u32)>>,
    /// Probes (m).
    pub probes: Vec<Vec3>,
    /// Radius of their support (m).
    pub radius: f32,
    /// What the probes leave unseen.
    pub coverage: Coverage,
    /// Texels dropped because they lie inside solids.
    pub dropped: usize,
    /// Receivers of each cluster.
    pub clusters: Vec<Vec<u32>>,
    /// What transport is corrected and compression judged by.
    round_trip: Arc<RoundTrip>,
    /// What was said of the correction of all clusters, and what is left out of them, once they are put together.
    verdict: OnceLock<(Verdict, LeftOut)>,
    /// What is known of mutual visibility; `None` where every ray asks for itself.
    visibility: Option<Visibility>,
    /// Rays of local transport so far.
    traced: AtomicU64,
    /// Milliseconds that its parts took which another plan had made.
    pub spared_ms: f64,
}

/// What of a plan depends on the scene and its receivers alone.
pub(super) struct Ground {
    reach: Arc<Reach>,
    atlas: Arc<Atlas>,
    receivers: Arc<Vec<(Receiver, u32)>>,
    /// Texels dropped because they lie inside solids.
    dropped: usize,
    /// Kinds of light that no probe has seen yet.
    kinds: RoundTrip,
    /// Milliseconds that `reach` took, where another made it.
    taken_ms: f64,
}

/// Probes for some [`Ground`].
pub(super) struct Places {
    probes: Vec<Vec3>,
    radius: f32,
    coverage: Coverage,
}

/// Transport of one of the plan's clusters, perhaps split for compression.
#[derive(Clone, PartialEq, Debug)]
pub struct ClusterOutput {
    /// Parts, each with its receivers.
    pub parts: Vec<(Vec<u32>, Cluster)>,
    /// Per receiver of the plan's cluster.
    pub rays: Vec<Rays>,
    /// What is said of the correction of its transport.
    pub verdict: Verdict,
    /// What its probes' orders leave out.
    pub left_out: LeftOut,
}

/// What may be chance in the rows and in the form factors of a receiver.
type Chance = (Vec<f32>, Vec<f32>);

/// Transport of a cluster before anything is done with it.
struct Local {
    /// Probes that support any of its receivers.
    probes: Vec<u32>,
    /// Rows of all coefficients of the probes.
    matrix: Vec<f32>,
    /// Form factors of kinds of light, where transport is to be corrected.
    factors: Vec<f32>,
    /// Receivers of which it is known what may be chance in their rows and factors; that follows in both.
    witnesses: Vec<usize>,
    rays: Vec<Rays>,
}

impl<'a> Plan<'a> {
    /// Makes receivers, probes and clusters.
    ///
    /// # Errors
    /// What the voxel kernels return; a scene that the path tracer does not take.
    pub fn new(scene: &'a crate::scene::Scene, options: &BakeOptions) -> Result<Self, MethodError> {
        Self::sharing(scene, options, &Memo::default())
    }

    /// The same from those parts that other plans for the same scene left in `memo`, where what these depend on is alike, and
    /// bit for bit the same; leaves its own.
    ///
    /// # Errors
    /// As [`Plan::new`].
    pub fn sharing(scene: &'a crate::scene::Scene, options: &BakeOptions, memo: &Memo) -> Result<Self, MethodError> {
        let mut spared_ms = 0.0;
        let structures = memo.structures.get((), &mut spared_ms, || Structures::new(scene))?;
        let world = World::sharing(scene, structures)?;
        let key = options.of_ground();
        let ground = memo.ground.get(key, &mut spared_ms, || Ground::new(&world, options, memo))?;
        spared_ms += ground.taken_ms;
        let points: Vec<Receiver> = ground.receivers.iter().map(|r| r.0).collect();
        let key = options.of_places();
        let places = memo.places.get(key, &mut spared_ms, || Ok(Places::new(&world, &ground, &points, options)))?;
        let key = options.of_round_trip();
        let round_trip =
            memo.round_trips.get(key, &mut spared_ms, || Ok(seen_by_probes(&world, &ground, &places, options)))?;
        let clusters = split((0..points.len() as u32).collect(), &points, options.cluster_size.max(1) as usize);
        let (texels, probes) = (ground.atlas.texels.len(), places.probes.len());
        // Not shared: it fills while transport is computed, whose time would then be another's.
        let visibility = if options.texel_visibility { Visibility::new(texels, probes) } else { None };
        Ok(Self {
            round_trip,
            verdict: OnceLock::new(),
            visibility,
            traced: AtomicU64::new(0),
            options: options.clone(),
            world,
            reach: ground.reach.clone(),
            atlas: ground.atlas.clone(),
            receivers: ground.receivers.clone(),
            probes: places.probes.clone(),
            radius: places.radius,
            coverage: places.coverage,
            dropped: ground.dropped,
            clusters,
            spared_ms,
        })
    }

    /// Everything at once.
    pub fn bake(&self) -> (SrpBake, Lookup) {
        self.finish((0..self.clusters.len()).into_par_iter().map(|c| self.cluster(c)).collect())
    }

    /// The clusters that are not among those `found`; each is given to `keep` when it is finished, and their number to
    /// `progress`.
    ///
    /// # Errors
    /// The first of `keep`'s.
    pub fn resume<E: Send>(
        &self,
        mut found: BTreeMap<usize, ClusterOutput>,
        keep: &(dyn Fn(usize, &ClusterOutput) -> Result<(), E> + Sync),
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<(SrpBake, Lookup), E> {
        let left: Vec<usize> = (0..self.clusters.len()).filter(|c| !found.contains_key(c)).collect();
        let done = AtomicUsize::new(self.clusters.len() - left.len());
        let compute = |c: usize| {
            let output = self.cluster(c);
            keep(c, &output)?;
            progress(done.fetch_add(1, Relaxed) + 1);
            Ok((c, output))
        };
        found.extend(left.into_par_iter().map(compute).collect::<Result<Vec<_>, E>>()?);
        Ok(self.finish(found.into_values().collect()))
    }

    /// Transport of one cluster, corrected and compressed as asked.
    pub fn cluster(&self, index: usize) -> ClusterOutput {
        let (o, members) = (&self.options, &self.clusters[index]);
        let Local { probes, mut matrix, factors, witnesses, rays } = self.local(index);
        let lights = self.round_trip.lights(&probes, o.light_metric);
        let mut whole = Whole {
            matrix: &mut matrix,
            receivers: members.len(),
            each: o.rows as usize,
            probes: probes.len(),
            order: o.order,
        };
        let support = whole.support();
        // Before the correction, which makes up for most of it.
        let left_out = whole.truncate(&lights, o.order_error);
        let verdict = self.round_trip.correct(&mut matrix, &probes, &factors, o.rows as usize, &witnesses);
        // After the correction, which would otherwise undo it.
        o.window.apply(&mut matrix, o.order);
        let points: Vec<Vec3> = members.iter().map(|r| self.receivers[*r as usize].0.position).collect();
        let (rows, k) = (o.rows as usize, sh::count(o.order));
        let block = Block {
            matrix: &matrix,
            points: &points,
            rows,
            probes: &probes,
            k,
            witnesses: &witnesses,
            lights: &lights,
        };
        let local = block.compressed(&o.compression);
        let named = |own: Vec<u32>| own.iter().map(|i| members[*i as usize]).collect();
        let left_out = local.iter().fold(left_out, |sum, (own, c)| sum + LeftOut::count(&support, own, k, c));
        let parts = local.into_iter().map(|(own, cluster)| (named(own), cluster)).collect();
        ClusterOutput { parts, rays, verdict, left_out }
    }

    /// Local transport of all clusters, thrown away, for benchmarks: gives the number of rays that it traced, from receivers
    /// and between probes and what these rays met.
    pub fn transport_alone(&self) -> u64 {
        let before = self.traced.load(Relaxed);
        (0..self.clusters.len()).into_par_iter().for_each(|c| drop(self.local(c)));
        self.traced.load(Relaxed) - before
    }

    /// What the rays of one cluster's receivers find.
    fn local(&self, index: usize) -> Local {
        let chart = &self.atlas.charts.chart;
        let exposed = |t: u32, front: bool| self.reach.exposed[chart[t as usize] as usize][usize::from(!front)];
        let o = &self.options;
        let transport = Transport {
            world: &self.world,
            probes: &self.probes,
            radius: self.radius,
            order: o.order,
            rows: o.rows,
            sharpness: o.sharpness,
            directions: transport::directions(o.rays, o.rows),
            exposed: &exposed,
            atlas: &self.atlas,
            visibility: self.visibility.as_ref(),
            traced: &self.traced,
        };
        let members = &self.clusters[index];
        let supports: Vec<Vec<u32>> =
            members.iter().map(|r| transport.support(self.receivers[*r as usize].0.position)).collect();
        let mut probes: Vec<u32> = supports.concat();
        probes.sort_unstable();
        probes.dedup();
        let (k, rows) = (sh::count(o.order), o.rows as usize);
        let width = probes.len() * k;
        let mut matrix = vec![0.0f32; members.len() * rows * width];
        let factor_count = if self.round_trip.corrects() { self.round_trip.factor_count() } else { 0 };
        let factor_width = (rows * factor_count).max(1);
        let mut factors = vec![0.0f32; members.len() * factor_width];
        let place = |i: usize, own: &[f32], block: &mut [f32]| {
            for (n, coefs) in own.chunks_exact(k.max(1)).enumerate() {
                let (row, probe) = (n / supports[i].len(), supports[i][n % supports[i].len()]);
                let slot = probes.binary_search(&probe).unwrap_or(0);
                block[row * width + slot * k..][..k].copy_from_slice(coefs);
            }
        };
        let kinds = self.round_trip.corrects().then_some(&*self.round_trip);
        let fill = |scratch: &mut Scratch, (i, (block, factors)): (usize, (&mut [f32], &mut [f32]))| {
            let (receiver, support) = (&self.receivers[members[i] as usize].0, &supports[i]);
            let rays = transport.send(receiver, support, scratch);
            place(i, &transport.rows(receiver, support, scratch, Estimate::Mean, kinds.map(|k| (k, factors))), block);
            let chance = i.is_multiple_of(WITNESSES).then(|| {
                let (mut block, mut factors) = (vec![0.0; rows * width], vec![0.0; factor_width]);
                let kinds = kinds.map(|k| (k, &mut factors[..]));
                place(i, &transport.rows(receiver, support, scratch, Estimate::Noise, kinds), &mut block);
                (block, factors)
            });
            (rays, chance)
        };
        let found: Vec<(Rays, Option<Chance>)> = if width == 0 {
            vec![Default::default(); members.len()]
        } else {
            matrix
                .par_chunks_mut(rows * width)
                .zip(factors.par_chunks_mut(factor_width))
                .enumerate()
                .map_init(Scratch::default, fill)
                .collect()
        };
        let mut witnesses = Vec::new();
        for (i, (block, chance)) in found.iter().enumerate().filter_map(|(i, f)| Some((i, f.1.as_ref()?))) {
            witnesses.push(i);
            matrix.extend_from_slice(block);
            factors.extend_from_slice(chance);
        }
        Local { probes, matrix, factors, witnesses, rays: found.into_iter().map(|f| f.0).collect() }
    }

    /// Puts all clusters together: the order of receivers, relight rays, dilation; and the way from
    /// surface points to receivers.
    pub fn finish(&self, outputs: Vec<ClusterOutput>) -> (SrpBake, Lookup) {
        let mut bake = SrpBake {
            order: self.options.order,
            rows_per_receiver: self.options.rows,
            atlas_size: self.atlas.size,
            probes: self.probes.clone(),
            radius: self.radius,
            ray_directions: relight_directions(self.options.relight_rays),
            ..SrpBake::default()
        };
        // The same on every call: clusters depend on the plan alone.
        let none = (Verdict::default(), LeftOut::default());
        self.verdict.get_or_init(|| outputs.iter().fold(none, |sum, o| (sum.0 + o.verdict, sum.1 + o.left_out)));
        let mut sky = vec![0.0; self.receivers.len()];
        let mut order = Vec::with_capacity(self.receivers.len());
        for (members, output) in self.clusters.iter().zip(outputs) {
            members.iter().zip(&output.rays).for_each(|(m, rays)| sky[*m as usize] = rays.sky);
            for (own, mut cluster) in output.parts {
                let first = order.len() as u32;
                cluster.receivers = first..first + own.len() as u32;
                order.extend(own);
                bake.clusters.push(cluster);
            }
        }
        // Bands that no cluster makes anything of are not projected to.
        bake.order = orders::highest(&bake, self.options.order.min(LEAST_ORDER));
        let texels: Vec<u32> = order.iter().map(|r| self.receivers[*r as usize].1).collect();
        let place = |t: &u32| self.atlas.texels.get(*t as usize).map_or([u32::MAX; 2], |t| t.at);
        bake.receivers = order.iter().map(|r| self.receivers[*r as usize].0).collect();
        bake.sky = order.iter().map(|r| sky[*r as usize]).collect();
        bake.texel = texels.iter().map(place).collect();
        let lookup = Lookup::new(self.atlas.clone(), &texels);
        bake.ray_hits = self.relight_hits(&bake.ray_directions, &lookup);
        bake.dilation = lookup.dilation();
        (bake, lookup)
    }

    /// What every relight ray of every probe meets.
    fn relight_hits(&self, directions: &[Vec3], lookup: &Lookup) -> Vec<u32> {
        let chart = &self.atlas.charts.chart;
        let hit = |i: usize| {
            let (probe, direction) = (self.probes[i / directions.len()], directions[i % directions.len()]);
            let Some(seen) = self.world.closest(probe, direction) else { return RAY_MISS };
            let exposed = self.reach.exposed[chart[seen.triangle as usize] as usize];
            if !exposed[usize::from(!seen.front)] {
                return RAY_INVALID;
            }
            lookup.one(seen.triangle, seen.weights, seen.front, seen.position, seen.normal).unwrap_or(RAY_INVALID)
        };
        (0..self.probes.len() * directions.len()).into_par_iter().map(hit).collect()
    }
}

impl BakeOptions {
    /// Only what [`Ground`] depends on: everything else is as by default.
    pub(super) fn of_ground(&self) -> Self {
        Self { receivers: self.receivers, free: self.free.clone(), seed: self.seed, ..Self::default() }
    }

    /// Only what [`Places`] depend on.
    pub(super) fn of_places(&self) -> Self {
        Self {
            probes: self.probes,
            probe_positions: self.probe_positions.clone(),
            placement: self.placement,
            overlap: self.overlap,
            unseen_bound: self.unseen_bound,
            added_probes: self.added_probes,
            ..self.of_ground()
        }
    }

    /// Only what the round trip depends on.
    pub(super) fn of_round_trip(&self) -> Self {
        Self { order: self.order, ridge: self.ridge, relight_rays: self.round_trip_rays(), ..self.of_places() }
    }

    /// Rays of a probe by which it sees kinds of light.
    pub(super) fn round_trip_rays(&self) -> u32 {
        self.relight_rays.max(round_trip::RAYS)
    }
}

/// The scene's charts, as fine as so many receivers need them.
pub(super) fn patches(
    scene: &crate::scene::Scene,
    receivers: u32,
    memo: &Memo,
    spared_ms: &mut f64,
) -> Result<Arc<Patches>, MethodError> {
    let texel = PATCH_TEXEL * (area(scene) / receivers.max(1) as f32).sqrt();
    memo.patches.get(receivers, spared_ms, || Ok(Patches::new(scene, texel)))
}

/// Surface of a scene (m²), one side of each triangle.
fn area(scene: &crate::scene::Scene) -> f32 {
    let doubled = |[a, b, c]: [Vec3; 3]| (b - a).cross(c - a).length();
    scene.triangles.iter().map(|t| 0.5 * doubled(scene.corners(t))).sum()
}

impl Ground {
    fn new(world: &World<'_>, options: &BakeOptions, memo: &Memo) -> Result<Self, MethodError> {
        let mut taken_ms = 0.0;
        let patches = patches(world.scene, options.receivers, memo, &mut taken_ms)?;
        let key = (options.seed, patches.chart.clone());
        let reach = memo.reach.get(key, &mut taken_ms, || Reach::new(world, &patches, options.seed))?;
        let atlas = Arc::new(Atlas::new(world, &patches, &reach.exposed, options.receivers));
        let valid: Vec<bool> = atlas
            .texels
            .par_iter()
            .map(|t| is_outside(world, &patches, &reach, &t.receiver, atlas.texel_size))
            .collect();
        let mut receivers: Vec<(Receiver, u32)> =
            (atlas.texels.iter().enumerate()).filter(|(i, _)| valid[*i]).map(|(i, t)| (t.receiver, i as u32)).collect();
        let dropped = atlas.texels.len() - receivers.len();
        receivers.extend(options.free.iter().map(|(p, n)| (free_receiver(*p, *n), NO_RECEIVER)));
        let kinds = RoundTrip::new(world, &reach.space, atlas.clone(), &receivers, options.seed);
        Ok(Self { reach, atlas, receivers: Arc::new(receivers), dropped, kinds, taken_ms })
    }
}

impl Places {
    fn new(world: &World<'_>, ground: &Ground, points: &[Receiver], options: &BakeOptions) -> Self {
        let space = &ground.reach.space;
        let manual = options.probe_positions.clone();
        let share = if manual.is_some() { 0.0 } else { options.added_probes };
        let mut probes = manual.unwrap_or_else(|| probes::place(space, options.placement, options.probes));
        let wish = Wish {
            overlap: options.overlap,
            bound: options.unseen_bound,
            limit: (share * probes.len() as f32) as u32,
            texel_size: ground.atlas.texel_size,
        };
        let (radius, coverage) = probes::cover(world, space, points, &mut probes, &wish);
        Self { probes, radius, coverage }
    }
}

/// What the probes see of the kinds of light on the receivers' surfaces.
fn seen_by_probes(world: &World<'_>, ground: &Ground, places: &Places, options: &BakeOptions) -> RoundTrip {
    let (atlas, probes, mut round_trip) = (&ground.atlas, &places.probes, ground.kinds.clone());
    let directions = relight_directions(options.round_trip_rays());
    let chart = &atlas.charts.chart;
    let texel = |i: usize| {
        let seen = world.closest(probes[i / directions.len()], directions[i % directions.len()]);
        let exposed = |s: &Seen| ground.reach.exposed[chart[s.triangle as usize] as usize][usize::from(!s.front)];
        let own = |s: &Seen| atlas.texel_of(s.triangle, s.weights, s.front);
        seen.filter(exposed).map_or(NO_RECEIVER, |s| round_trip.texel(world, &s, own(&s)))
    };
    let met: Vec<u32> = (0..probes.len() * directions.len()).into_par_iter().map(texel).collect();
    round_trip.see(&directions, &met, options.order, f64::from(options.ridge));
    round_trip
}

/// Directions of the relight rays.
pub fn relight_directions(count: u32) -> Vec<Vec3> {
    (0..count).map(|i| spherical_fibonacci(i, count)).collect()
}

/// Whether a receiver lies in the world, not inside a solid: most of what it sees does, and is not so near that it lies in
/// a gap which texels cannot resolve.
fn is_outside(world: &World<'_>, patches: &Patches, reach: &Reach, r: &Receiver, texel_size: f32) -> bool {
    if r.triangle == FREE {
        return true;
    }
    let about = frame(r.geometric_normal);
    let meets_inside = |i: &u32| {
        let direction = about.world_from_local(cosine_hemisphere(hammersley(*i, VALIDITY_RAYS)));
        world.closest_from(r, direction).is_some_and(|seen| {
            let exposed = reach.exposed[patches.chart[seen.triangle as usize] as usize][usize::from(!seen.front)];
            !exposed || (seen.position - r.position).length() < GAP * texel_size
        })
    };
    let inside = (0..VALIDITY_RAYS).filter(meets_inside).count();
    inside as f32 <= INSIDE_ALLOWED * VALIDITY_RAYS as f32
}

/// Halves the box of the points along its longest side until none holds more than `most` (SL17 §4.1, LE §5.6.6).
pub fn split(members: Vec<u32>, points: &[Receiver], most: usize) -> Vec<Vec<u32>> {
    if members.is_empty() {
        return Vec::new();
    }
    if members.len() <= most {
        return vec![members];
    }
    let position = |i: u32| points[i as usize].position;
    let (near, far) = halve(members, position);
    let mut parts = split(near, points, most);
    parts.extend(split(far, points, most));
    parts
}

/// Two non-empty halves: by the middle of the box's longest side, by number where all lie on one side. Rounding decides
/// neither which of equal sides is the longest, nor on which side of the middle a point lies that lies in it.
pub fn halve(mut members: Vec<u32>, position: impl Fn(u32) -> Vec3) -> (Vec<u32>, Vec<u32>) {
    let (low, high) =
        members.iter().fold((Vec3::MAX, Vec3::MIN), |(l, h), i| (l.min(position(*i)), h.max(position(*i))));
    let extent = high - low;
    let axis = (0..3).find(|a| extent[*a] >= NEARLY * extent.max_element()).unwrap_or(0);
    let middle = low[axis] + MIDDLE * extent[axis];
    let (near, far): (Vec<u32>, Vec<u32>) = members.iter().partition(|i| position(**i)[axis] < middle);
    if near.is_empty() || far.is_empty() {
        let far = members.split_off(members.len() / 2);
        return (members, far);
    }
    (near, far)
}

/// Clusters by rank in steps of eight: how many need 1 to 8 components, 9 to 16, and so on.
fn histogram(ranks: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut counts = Vec::new();
    for rank in ranks {
        let step = (rank.max(1) as usize - 1) / 8;
        counts.resize(counts.len().max(step + 1), 0);
        counts[step] += 1;
    }
    counts
}

/// Size, rank, bytes and errors of every cluster.
pub fn cluster_report(bake: &SrpBake) -> serde_json::Value {
    let cluster = |c: &Cluster| {
        serde_json::json!({
            "receivers": c.receivers.len(),
            "probes": c.probes.len(),
            "columns": c.columns.len(),
            "rank": c.rank,
            "bytes": c.f16_bytes(),
            "transport_error": c.loss.transport,
            "noise": c.loss.noise,
            "light_error": c.loss.light,
        })
    };
    bake.clusters.iter().map(cluster).collect()
}

impl Plan<'_> {
    /// How far the correction is followed, and relative errors in lighting states that it was not fitted to; null without one.
    fn correction_report(&self) -> serde_json::Value {
        let Some(v) = self.verdict.get().map(|v| v.0).filter(|v| v.receivers > 0.0) else {
            return serde_json::Value::Null;
        };
        let error = |square: f32| (square / v.light.max(f32::MIN_POSITIVE)).sqrt();
        serde_json::json!({
            "ridge": self.options.ridge,
            "followed": v.followed / v.receivers,
            "light_error_before": error(v.before),
            "light_error_after": error(v.after),
        })
    }

    fn orders_report(&self, bake: &SrpBake) -> serde_json::Value {
        let left = self.verdict.get().map(|v| v.1).unwrap_or_default();
        orders::report(bake, self.options.order, self.options.order_error, &left)
    }

    /// What was decided and what it takes, for reports.
    pub fn report(&self, bake: &SrpBake) -> serde_json::Value {
        let count = bake.clusters.len().max(1) as f64;
        let sum = |f: &dyn Fn(&Cluster) -> usize| bake.clusters.iter().map(f).sum::<usize>() as f64;
        let bytes = sum(&Cluster::f16_bytes);
        let plain = sum(&|c| c.plain_f16_bytes(bake.rows_per_receiver));
        let receivers = bake.receivers.len().max(1) as f64;
        let mean_square = |f: &dyn Fn(&Cluster) -> f32| {
            bake.clusters.iter().map(|c| c.receivers.len() as f64 * f64::from(f(c)).powi(2)).sum::<f64>() / receivers
        };
        let limited = match self.options.compression {
            Compression::Cpca { error, noise, .. } => sum(&|c| usize::from(noise * c.loss.noise > error)),
            _ => 0.0,
        };
        let agreeing = self.visibility.as_ref().map(|v| v.shares()[0]);
        serde_json::json!({
            "receivers": bake.receivers.len(),
            "receivers_inside_solids": self.dropped,
            "lightmap": bake.atlas_size,
            "texel_m": self.atlas.texel_size,
            "charts": self.atlas.charts.count,
            "own_uv_set": self.atlas.charts.from_file,
            "probes": bake.probes.len(),
            "probes_added": self.coverage.added,
            "probes_added_limit": self.coverage.limit,
            "receivers_without_probe": self.coverage.unseen,
            "receivers_without_probe_before": self.coverage.unseen_before,
            "receivers_without_probe_in_gaps": self.coverage.unseen_in_gaps,
            "support_radius_m": bake.radius,
            "clusters": bake.clusters.len(),
            "mean_rank": sum(&|c| c.rank as usize) / count,
            "mean_probes_per_cluster": sum(&|c| c.probes.len()) / count,
            "transport_f16_bytes": bytes,
            "compression": if bytes > 0.0 { plain / bytes } else { 1.0 },
            "transport_error": mean_square(&|c| c.loss.transport).sqrt(),
            "transport_noise": mean_square(&|c| c.loss.noise).sqrt(),
            "clusters_limited_by_noise": limited / count,
            "light_error": mean_square(&|c| c.loss.light).sqrt(),
            "visibility_known_by_texel": agreeing,
            "probe_orders": self.orders_report(bake),
            "correction": self.correction_report(),
            "rank_histogram": histogram(bake.clusters.iter().map(|c| c.rank)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_lower_high_bands_and_keep_the_mean() {
        // Two probes of order 3, every coefficient 1.
        let windowed = |window: Window| {
            let mut matrix = vec![1.0; 2 * sh::count(3)];
            window.apply(&mut matrix, 3);
            assert_eq!(matrix[..sh::count(3)], matrix[sh::count(3)..]);
            matrix
        };
        assert!(windowed(Window::None).iter().all(|x| *x == 1.0));
        let (hanning, lanczos) = (windowed(Window::Hanning), windowed(Window::Lanczos));
        assert_eq!((hanning[0], lanczos[0]), (1.0, 1.0));
        for c in 1..sh::count(3) {
            assert!(0.0 < hanning[c] && hanning[c] < lanczos[c] && lanczos[c] < 1.0, "{c}");
        }
        assert!(hanning[sh::count(2)] < hanning[sh::count(1)] && hanning[sh::count(1)] < hanning[1]);
    }
}
