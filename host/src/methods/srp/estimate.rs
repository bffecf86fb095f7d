//! What a bake will take, told before it: receivers, rays and multiply-adds are counted, a ray and a product of matrices are
//! timed on a sample.
//!
//! Charts are made in earnest, because the number of receivers follows from them, and left for the bake. Everything else is
//! a count times one of the two times; the constants were fitted to first rungs of four scenes, from 30 to 260,000 triangles,
//! and may be off by a half (`cargo xtask bench --filter set-up` prints by how much): who asks corrects it by what a bake
//! then took.

use super::atlas::SMALLEST_CHART;
use super::plan::{self, BakeOptions, VALIDITY_RAYS};
use super::reach::{REFLECTIONS, WALKS};
use super::round_trip::KINDS_FITTED;
use super::{Compression, Memo, charts::Patches};
use crate::exec::{Executor, ExecutorExt};
use crate::methods::{Input, MethodError, SetUp};
use faer::Mat;
use glam::Vec3;
use interreflect_kernels::math::frame::Frame;
use interreflect_kernels::math::rng::rand2;
use interreflect_kernels::math::{sampling, sh};
use interreflect_kernels::trace::{Ray, SceneRef, closest_hit};
use interreflect_shared::scene::SceneTriangle;
use rayon::prelude::*;
use std::time::Instant;

/// Rays that are timed.
const SAMPLE: u32 = 1 << 14;
/// Share of the time of a sampled ray, which is a kernel's, that the path tracer's takes, by which bakes trace.
const TRACER: f64 = 0.85;
/// Time of the acceleration structures over that of the charts.
const TREES: f64 = 2.8;

/// What a part takes in rays: of a walk's reflection, marking what it passes; of a receiver, to learn what lights it; of a
/// receiver, to find where probes must stand; of a ray of transport, with the probes that it is looked up at.
const REFLECTION: f64 = 1.7;
const KINDS: f64 = 300.0;
const COVER: f64 = 450.0;
const TRANSPORT: f64 = 2.8;
/// Probes whose rays take as long as preparing a round trip.
const PREPARED: f64 = 20.0;
/// Part of the most receivers of a cluster that one has.
const FILLED: f64 = 0.65;
/// Probes that support any receiver of a cluster, over those that support one.
const REACHED: f64 = 2.2;
/// Part of the columns that probes keep where they have orders of their own.
const KEPT: f64 = 0.5;
/// Products of a number of a cluster's matrix by which these are found: with all lights, twice.
const CHOSEN: f64 = 512.0;
/// Products of a number of a cluster's matrix in its compression.
const COMPRESSED: f64 = 1500.0;
/// Side of the matrices whose product is timed.
const PRODUCT: usize = 256;

/// What a bake will take.
///
/// # Errors
/// What reading the scene back returns.
pub(super) fn set_up(
    exec: &mut dyn Executor,
    input: &Input<'_>,
    options: &BakeOptions,
    memo: &Memo,
) -> Result<SetUp, MethodError> {
    let ray_s = *memo.ray_s.get((), &mut 0.0, || timed_ray(exec, input))?;
    // Charts that were made for other receivers tell as much: they differ only where a scene overlaps itself.
    let (patches, charts_ms) = match memo.patches.last() {
        Some(made) => made,
        None => {
            plan::patches(input.scene, options.receivers, memo, &mut 0.0)?;
            memo.patches.last().ok_or(MethodError::NotPrecomputed { method: super::NAME })?
        }
    };
    let charts_s = charts_ms / 1e3;
    let receivers = f64::from(patches.texels(options.receivers, SMALLEST_CHART)) + options.free.len() as f64;
    let product_s = *memo.product_s.get((), &mut 0.0, || Ok(timed_product()))?;
    let parts = Parts::new(&patches, options, receivers, [ray_s, product_s]);
    let shared = [
        (TREES * charts_s, memo.structures.holds(&())),
        (parts.ground_s, memo.ground.holds(&options.of_ground())),
        (parts.places_s, memo.places.holds(&options.of_places())),
        (parts.round_trip_s, memo.round_trips.holds(&options.of_round_trip())),
    ];
    let left_s: f64 = shared.iter().filter(|p| !p.1).map(|p| p.0).sum();
    let always_s = parts.transport_s + parts.algebra_s;
    Ok(SetUp { whole_s: charts_s + shared.iter().map(|p| p.0).sum::<f64>() + always_s, left_s: left_s + always_s })
}

/// Seconds of a bake's parts, but for charts and trees.
struct Parts {
    ground_s: f64,
    places_s: f64,
    round_trip_s: f64,
    transport_s: f64,
    /// Correction and compression.
    algebra_s: f64,
}

impl Parts {
    fn new(patches: &Patches, o: &BakeOptions, receivers: f64, [ray_s, product_s]: [f64; 2]) -> Self {
        let walks = f64::from(WALKS.0.max(WALKS.1 * patches.count));
        let probes = f64::from(o.probes) + PREPARED;
        Self {
            ground_s: ray_s
                * (walks * f64::from(REFLECTIONS) * REFLECTION + receivers * (f64::from(VALIDITY_RAYS) + KINDS)),
            places_s: ray_s * receivers * COVER,
            round_trip_s: ray_s * probes * f64::from(o.round_trip_rays()),
            transport_s: ray_s * receivers * f64::from(o.rays * o.rows) * TRANSPORT,
            algebra_s: product_s * algebra(o, receivers),
        }
    }
}

/// Multiply-adds of the probes' orders, the correction and the compression of all clusters; those in double precision count twice.
fn algebra(o: &BakeOptions, receivers: f64) -> f64 {
    let in_cluster = (FILLED * f64::from(o.cluster_size)).min(receivers).max(1.0);
    let height = in_cluster * f64::from(o.rows);
    let width = f64::from(o.probes).min(REACHED * f64::from(o.overlap)) * sh::count(o.order) as f64;
    let (chosen, width) = if o.order_error > 0.0 { (CHOSEN * height * width, KEPT * width) } else { (0.0, width) };
    let kinds = KINDS_FITTED as f64;
    // The normal matrix, its factors, a solution per row; before that, what each row is to be corrected by.
    let correction = width * (width * (kinds + width * 2.0 / 3.0 + 4.0 * height) + 2.0 * height * kinds);
    let correction = if o.ridge > 0.0 { correction } else { 0.0 };
    let compression = if o.compression == Compression::None { 0.0 } else { COMPRESSED * height * width };
    receivers / in_cluster * (chosen + correction + compression)
}

/// Seconds of a multiply-add in a product of matrices, on all threads together.
fn timed_product() -> f64 {
    let matrix = |seed: u32| Mat::from_fn(PRODUCT, PRODUCT, |i, j| rand2(seed, i as u32, j as u32).x);
    let (a, b) = (matrix(1), matrix(2));
    let each_s = least_of_three(|| {
        std::hint::black_box(&a * &b);
    });
    each_s / (PRODUCT as f64).powi(3) / rayon::current_num_threads() as f64
}

/// Seconds of the quickest of three runs: the first warms up.
fn least_of_three(work: impl Fn()) -> f64 {
    let run = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    (0..3).map(run).fold(f64::INFINITY, f64::min)
}

/// Seconds that one ray of the path tracer takes on all threads together.
fn timed_ray(exec: &mut dyn Executor, input: &Input<'_>) -> Result<f64, MethodError> {
    let (nodes, triangles) = (exec.read_slice(input.buffers.nodes)?, exec.read_slice(input.buffers.triangles)?);
    let (attributes, surfaces) = (exec.read_slice(input.buffers.attributes)?, exec.read_slice(input.buffers.surfaces)?);
    let scene = SceneRef { nodes: &nodes, triangles: &triangles, attributes: &attributes, surfaces: &surfaces };
    let rays = sample(&triangles, input.seed);
    let trace = || rays.par_iter().filter(|ray| closest_hit(&scene, ray).is_some()).count();
    let least_s = least_of_three(|| {
        std::hint::black_box(trace());
    });
    Ok(TRACER * least_s / rays.len().max(1) as f64)
}

/// Rays that leave surfaces as those of receivers do: each triangle as often as its area says.
fn sample(triangles: &[SceneTriangle], seed: u32) -> Vec<Ray> {
    let corners = |t: &SceneTriangle| [t.v0, t.v1, t.v2].map(Vec3::from);
    let mut sum = 0.0f64;
    let normal = |[a, b, c]: [Vec3; 3]| (b - a).cross(c - a);
    let sums: Vec<f64> = triangles
        .iter()
        .map(|t| {
            sum += f64::from(normal(corners(t)).length());
            sum
        })
        .collect();
    let ray = |i: u32| {
        let (pick, place, turn) = (rand2(seed, i, 0), rand2(seed, i, 1), rand2(seed, i, 2));
        let at = sums.partition_point(|s| *s < f64::from(pick.x) * sum).min(triangles.len() - 1);
        let [a, b, c] = corners(&triangles[at]);
        let w = sampling::triangle(place);
        let n = normal([a, b, c]).normalize_or(Vec3::Y);
        let off = 1e-4 * (a.abs().max_element() + (b - a).length());
        let origin = a + (b - a) * w.x + (c - a) * w.y + n * off;
        Ray::new(origin, Frame::new(n).world_from_local(sampling::cosine_hemisphere(turn)))
    };
    if triangles.is_empty() { Vec::new() } else { (0..SAMPLE).map(ray).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exec::CpuExecutor;
    use crate::methods::{self, Method, StageClock};
    use crate::scene::built_in;
    use crate::scene::device::SceneBuffers;

    #[test]
    fn rays_and_receivers_are_paid_for_and_what_is_shared_is_left_out() {
        let scene = built_in::cornell_box();
        let mut exec = CpuExecutor::new();
        let buffers = SceneBuffers::upload(&mut exec, &scene).expect("it fits");
        let input = Input { scene: &scene, buffers: &buffers, seed: 1, true_mean: None };
        let row = methods::method("srp").expect("a method");
        let mut parts = None;
        let mut made = |receivers: &'static str, rays: &'static str, order: &'static str, error: &'static str| {
            let set = [("receivers", receivers), ("rays", rays), ("order", order), ("order_error", error)];
            let mut method = (row.new)(&row.with(set).expect("settings")).expect("a method");
            method.share(&mut parts);
            method
        };
        // All by one timing of a ray and of a product: what other work does to the clock does not matter.
        let mut first = made("2048", "128", "1", "0.01");
        let told = |method: &dyn Method, exec: &mut CpuExecutor| {
            method.set_up(exec, &input).expect("it reads").expect("it knows")
        };
        let before = told(first.as_ref(), &mut exec);
        // Nothing but charts is there at first.
        assert!(before.whole_s > 0.0 && before.left_s > 0.9 * before.whole_s, "{before:?}");
        first.precompute(&mut exec, &input, &mut StageClock::default()).expect("it bakes");
        // Then trees, ground, probes and what they see are, and what rays bring is not.
        let after = told(first.as_ref(), &mut exec);
        assert!(after.whole_s == before.whole_s && after.left_s < 0.6 * after.whole_s, "{before:?} {after:?}");
        let rays = told(made("2048", "512", "1", "0.01").as_ref(), &mut exec);
        assert!(rays.whole_s > before.whole_s && rays.left_s > 3.0 * after.left_s, "{after:?} {rays:?}");
        let receivers = told(made("8192", "512", "1", "0.01").as_ref(), &mut exec);
        assert!(receivers.left_s > 3.0 * rays.left_s, "{rays:?} {receivers:?}");
        // Sixteen times as many coefficients: the square of that in the matrices of the correction. Less where probes keep fewer.
        let mut order = |error| told(made("2048", "128", "7", error).as_ref(), &mut exec).whole_s;
        let (all, own) = (order("0"), order("0.01"));
        assert!(all > 1.5 * before.whole_s && own > before.whole_s && own < all, "{before:?} {own} {all}");
    }

    #[test]
    fn as_many_receivers_are_counted_as_there_will_be() {
        for scene in [built_in::cornell_box(), built_in::two_rooms(0.2, 0.0)] {
            let options = BakeOptions { receivers: 2048, ..BakeOptions::default() };
            let memo = Memo::default();
            let plan = super::super::Plan::sharing(&scene, &options, &memo).expect("it plans");
            let (patches, _) = memo.patches.last().expect("charts");
            let counted = f64::from(patches.texels(options.receivers, SMALLEST_CHART));
            // Those inside solids and on hidden sides are not known beforehand.
            let ratio = counted / plan.receivers.len() as f64;
            assert!((0.7..1.4).contains(&ratio), "{counted} for {}", plan.receivers.len());
        }
    }
}
