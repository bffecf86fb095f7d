//! Sparse radiance probes against the truth at their own receivers.

use glam::Vec3;
use interreflect::methods::srp::{BakeOptions, Compression, Plan, SrpBake};
use interreflect::reference::{self, Receiver, ReferenceSettings};
use interreflect::scene::{Light, Scene, built_in};
use interreflect_kernels::math::rng::rand;

/// Direct irradiance at the receivers of a bake, by the path tracer: what the runtime's own direct light is not on trial for.
struct Lit {
    bake: SrpBake,
    direct: Vec<Vec3>,
    truth: Vec<Vec3>,
}

fn points(bake: &SrpBake) -> Vec<Receiver> {
    let of = |r: &interreflect::methods::srp::model::Receiver| Receiver {
        position: r.position,
        normal: r.normal,
        geometric_normal: r.geometric_normal,
    };
    bake.receivers.iter().map(of).collect()
}

fn baked(scene: &Scene, options: &BakeOptions) -> SrpBake {
    let plan = Plan::new(scene, options).unwrap();
    let bake = plan.bake().0;
    println!("{}", plan.report(&bake));
    bake
}

fn lit(scene: &Scene, bake: SrpBake, spp: u32) -> Lit {
    let settings = ReferenceSettings { spp: Some(spp), seed: 5, ..Default::default() };
    let values = reference::irradiance(scene, &points(&bake), &settings, &mut |_| {}).unwrap().values;
    Lit { direct: values.iter().map(|v| v.direct).collect(), truth: values.iter().map(|v| v.indirect).collect(), bake }
}

/// Root mean square error over means of 8 × 8 texels relative to the mean truth, and the ratio of means.
fn block_error(lit: &Lit, got: &[Vec3]) -> (f64, f64) {
    let mut blocks = std::collections::BTreeMap::<[u32; 2], (Vec3, Vec3, f32)>::new();
    for (i, [x, y]) in lit.bake.texel.iter().enumerate() {
        let block = blocks.entry([x / 8, y / 8]).or_default();
        *block = (block.0 + got[i], block.1 + lit.truth[i], block.2 + 1.0);
    }
    let (mut error, mut mean, mut sum, mut weight) = (0.0, 0.0, 0.0, 0.0);
    for (got, truth, n) in blocks.values() {
        error += f64::from((*got - *truth).length_squared() / n);
        mean += f64::from(truth.element_sum());
        sum += f64::from(got.element_sum());
        weight += f64::from(*n);
    }
    ((error / (3.0 * weight)).sqrt() / (mean / (3.0 * weight)), sum / mean)
}

/// Mean of all receivers' values, by area.
fn mean(bake: &SrpBake, values: &[Vec3]) -> Vec3 {
    let area: f32 = bake.receivers.iter().map(|r| r.area).sum();
    bake.receivers.iter().zip(values).map(|(r, v)| *v * r.area).sum::<Vec3>() / area
}

#[test]
fn furnace_keeps_its_energy() {
    // Radiance 1 from every wall: irradiance π directly, and π·(1/(1 − 0.8) − 1) = 4π after reflections.
    let scene = built_in::furnace(0.8, 1.0);
    let options = BakeOptions { receivers: 1500, probes: 8, rays: 256, ..BakeOptions::default() };
    let truth = 4.0 * std::f32::consts::PI;
    for order_error in [0.0, options.order_error] {
        let bake = baked(&scene, &BakeOptions { order_error, ..options.clone() });
        let direct = vec![Vec3::splat(std::f32::consts::PI); bake.receivers.len()];
        let got = bake.bounce(&direct, 80);
        let ratio = mean(&bake, &got) / truth;
        let worst = got.iter().map(|e| (e.x / truth - 1.0).abs()).fold(0.0, f32::max);
        println!("furnace 0.8, left out {order_error}: mean ratio {ratio}, worst receiver {worst}");
        assert!((ratio - 1.0).abs().max_element() < 0.002 && worst < 0.02, "{ratio} {worst}");
    }
}

#[test]
fn cornell_box_is_near_the_truth() {
    let scene = built_in::cornell_box();
    let plain = BakeOptions { receivers: 2500, rays: 256, compression: Compression::None, ..BakeOptions::default() };
    let exact = lit(&scene, baked(&scene, &plain), 256);
    let (plain_error, bias) = block_error(&exact, &exact.bake.bounce(&exact.direct, 24));
    println!("27 probes, order 7, 2500 receivers: nrmse_block {plain_error:.4}, bias {bias:.4}");
    assert!(plain_error < 0.08 && (0.97..1.03).contains(&bias), "{plain_error} {bias}");
}

/// The same receivers under other probes: truth and direct light once, one bake after the other.
fn curve(scene: &Scene, bakes: impl Iterator<Item = BakeOptions>, spp: u32) -> Vec<(f64, f64)> {
    let mut known: Option<Lit> = None;
    let mut errors = Vec::new();
    for options in bakes {
        let bake = baked(scene, &options);
        let now = match known.take() {
            None => lit(scene, bake, spp),
            Some(before) => {
                assert_eq!(before.bake.receivers, bake.receivers, "the receivers must not depend on the probes");
                Lit { bake, ..before }
            }
        };
        errors.push(block_error(&now, &now.bake.bounce(&now.direct, 24)));
        known = Some(now);
    }
    errors
}

fn small() -> BakeOptions {
    BakeOptions {
        receivers: 1200,
        rays: 128,
        relight_rays: 1024,
        compression: Compression::None,
        ..BakeOptions::default()
    }
}

#[test]
fn higher_orders_come_nearer_to_the_truth() {
    let scene = built_in::cornell_box();
    let errors = curve(&scene, (0..8).map(|order| BakeOptions { order, ..small() }), 256);
    errors.iter().enumerate().for_each(|(n, e)| println!("order {n}: nrmse_block {:.4}, bias {:.4}", e.0, e.1));
    // Each order at most 2 % of the first one's error worse than the one below, and 7 far better than 0.
    assert!(errors.windows(2).all(|w| w[1].0 < w[0].0 + 0.02 * errors[0].0), "{errors:?}");
    assert!(errors[7].0 < 0.4 * errors[0].0, "{errors:?}");
}

/// Bands that bring next to nothing are not kept: fewer columns, less memory, hardly more error. Where nothing may be lost all are.
#[test]
fn probes_have_the_order_that_their_light_takes() {
    let scene = built_in::cornell_box();
    let options = BakeOptions { order: 9, compression: Compression::default(), ..small() };
    let bake = |order_error| {
        let options = BakeOptions { order_error, ..options.clone() };
        let plan = Plan::new(&scene, &options).unwrap();
        let bake = plan.bake().0;
        let report = plan.report(&bake)["probe_orders"].clone();
        println!("{report}");
        (bake, report)
    };
    let number = |report: &serde_json::Value, key: &str| report[key].as_f64().unwrap();
    let (whole, nothing) = bake(0.0);
    let (cut, said) = bake(options.order_error);
    assert!(whole.clusters.iter().all(|c| c.columns.len() == c.probes.len() * 100) && whole.order == 9);
    assert_eq!((number(&nothing, "columns_left_out"), number(&nothing, "left_out")), (0.0, 0.0));
    let columns = |bake: &SrpBake| bake.clusters.iter().map(|c| c.columns.len()).sum::<usize>() as f64;
    assert!(columns(&cut) < 0.8 * columns(&whole), "{} of {}", columns(&cut), columns(&whole));
    assert_eq!(columns(&cut), number(&said, "columns") - number(&said, "columns_left_out"));
    assert!(number(&said, "left_out") > 0.0 && number(&said, "left_out") <= 1.0001 * f64::from(options.order_error));
    let probes: f64 = said["probes"].as_array().unwrap().iter().filter_map(|n| n.as_f64()).sum();
    assert_eq!(probes + number(&said, "probes_unused"), cut.probes.len() as f64);
    let with = lit(&scene, cut, 256);
    let (error, bias) = block_error(&with, &with.bake.bounce(&with.direct, 24));
    // The same receivers, in another order where other clusters were halved.
    let at: std::collections::HashMap<[u32; 2], usize> =
        with.bake.texel.iter().enumerate().map(|(i, t)| (*t, i)).collect();
    let own = |values: &[Vec3]| whole.texel.iter().map(|t| values[at[t]]).collect::<Vec<_>>();
    let before = Lit { direct: own(&with.direct), truth: own(&with.truth), bake: whole };
    let (whole_error, whole_bias) = block_error(&before, &before.bake.bounce(&before.direct, 24));
    println!("nrmse_block {whole_error:.4} -> {error:.4}, bias {whole_bias:.4} -> {bias:.4}");
    assert!(error < whole_error + 0.003 && (bias - whole_bias).abs() < 0.003);
    // Bands that no probe needs are not projected to.
    let (low, _) = bake(0.3);
    assert!(low.order < 9 && low.clusters.iter().all(|c| c.columns.iter().all(|k| k.1 < (low.order + 1).pow(2))));
    assert_eq!(low.coefficient_count(), ((low.order + 1) * (low.order + 1)) as usize);
}

#[test]
fn more_probes_come_nearer_to_the_truth() {
    let scene = built_in::cornell_box();
    let counts = [2, 8, 27, 64];
    let options = |probes| BakeOptions { probes, added_probes: 0.0, ..small() };
    let errors = curve(&scene, counts.into_iter().map(options), 256);
    counts.iter().zip(&errors).for_each(|(n, e)| println!("{n} probes: nrmse_block {:.4}, bias {:.4}", e.0, e.1));
    assert!(errors.windows(2).all(|w| w[1].0 < w[0].0 + 0.02 * errors[0].0), "{errors:?}");
    assert!(errors[3].0 < 0.7 * errors[0].0, "{errors:?}");
}

#[test]
fn a_strip_beside_its_receivers_is_blurred_and_coefficients_or_probes_heal_it() {
    let scene = built_in::slit();
    let base = BakeOptions { receivers: 3000, ridge: 0.0, ..small() };
    let bakes = [
        BakeOptions { order: 3, ..base.clone() },
        BakeOptions { order: 9, ..base.clone() },
        BakeOptions { probes: 125, relight_rays: 4096, ..base.clone() },
        BakeOptions { order: 9, ridge: 1e-3, ..base },
    ];
    let errors = curve(&scene, bakes.into_iter(), 128);
    println!(
        "slit, nrmse_block: 27 probes of order 3 {:.3}, of order 9 {:.3}, 125 of order 7 {:.3}; corrected, of order 9 {:.3}",
        errors[0].0, errors[1].0, errors[2].0, errors[3].0
    );
    assert!(errors[0].0 > 0.5, "the published failure does not show: {errors:?}");
    // Higher orders heal a fifth of it, more probes two fifths at least (how much depends on how they happen to stand to the
    // strip: 0.53 is left here, 0.45 to 0.64 with other placements), and the correction some of the rest.
    assert!(errors[1].0 < 0.82 * errors[0].0 && errors[2].0 < 0.6 * errors[0].0, "{errors:?}");
    assert!(errors[3].0 < errors[1].0, "{errors:?}");
}

/// Where sunlit ground lies beside corners that it does not reach, correction must not bring it there: not under the scene's own
/// sun, nor under one from elsewhere.
#[test]
fn the_default_correction_does_no_harm_in_the_sun() {
    for (mut scene, receivers) in [(built_in::colonnade(), 4000), (built_in::louvres(), 2500)] {
        let options = BakeOptions { receivers, ..small() };
        let corrected = baked(&scene, &options);
        let plain = baked(&scene, &BakeOptions { ridge: 0.0, ..options });
        for turned in [false, true] {
            if turned {
                scene.lights.iter_mut().for_each(|light| {
                    if let Light::Directional { direction, .. } = light {
                        *direction = Vec3::new(-direction.z, direction.y, 0.6 * direction.x).normalize();
                    }
                });
            }
            let with = lit(&scene, corrected.clone(), 64);
            let error = block_error(&with, &with.bake.bounce(&with.direct, 24)).0;
            let before = block_error(&with, &plain.bounce(&with.direct, 24)).0;
            println!("{}, sun turned {turned}: nrmse_block {before:.3} plain, {error:.3} corrected", scene.name);
            assert!(error < 1.02 * before, "{}, sun turned {turned}: {before} -> {error}", scene.name);
        }
    }
}

#[test]
fn the_loop_gains_what_albedo_keeps() {
    // In a furnace all light stays: the gain is the albedo.
    let options = BakeOptions { receivers: 1000, probes: 8, rays: 128, relight_rays: 1024, ..BakeOptions::default() };
    let gain = baked(&built_in::furnace(0.8, 1.0), &options).feedback_gain(30);
    println!("furnace of albedo 0.8: gain {gain:.4}");
    assert!((gain - 0.8).abs() < 0.02 * 0.8, "{gain}");
    // An open box loses light: below its largest albedo.
    let gain = baked(&built_in::cornell_box(), &options).feedback_gain(30);
    println!("Cornell box: gain {gain:.4}");
    assert!(gain > 0.2 && gain < 0.74, "{gain}");
    // Walls that reflect more than arrives: the alarm.
    let mut bake = baked(&built_in::furnace(0.8, 1.0), &options);
    bake.receivers.iter_mut().for_each(|r| r.albedo = Vec3::splat(1.05));
    assert!(bake.feedback_gain(30) > 1.0);
}

/// Compression changes the light by little, no more across borders of clusters than the light itself jumps there.
#[test]
fn compression_adds_little_and_shows_no_borders() {
    let scene = built_in::cornell_box();
    let plain = BakeOptions { receivers: 4000, rays: 256, ..small() };
    let plan = Plan::new(&scene, &plain).unwrap();
    let exact = lit(&scene, plan.bake().0, 128);
    let truth = exact.bake.bounce(&exact.direct, 24);
    let (plain_error, _) = block_error(&exact, &truth);
    let at = |bake: &SrpBake| -> std::collections::HashMap<[u32; 2], usize> {
        bake.texel.iter().enumerate().map(|(i, t)| (*t, i)).collect()
    };
    let exact_at = at(&exact.bake);
    let mut before = f64::MAX;
    for max_rank in [4, 8, 16, 32] {
        let compressed =
            BakeOptions { compression: Compression::Cpca { error: 0.005, max_rank, noise: 0.0 }, ..plain.clone() };
        let plan = Plan::new(&scene, &compressed).unwrap();
        let bake = plan.bake().0;
        let report = plan.report(&bake);
        // The order of receivers follows the clusters: pair by texel.
        let pair: Vec<usize> = bake.texel.iter().map(|t| exact_at[t]).collect();
        let direct: Vec<Vec3> = pair.iter().map(|i| exact.direct[*i]).collect();
        let same: Vec<Vec3> = pair.iter().map(|i| exact.truth[*i]).collect();
        let wanted: Vec<Vec3> = pair.iter().map(|i| truth[*i]).collect();
        let lit = Lit { bake, direct, truth: same };
        let got = lit.bake.bounce(&lit.direct, 24);
        let (error, _) = block_error(&lit, &got);
        let added = relative(&got, &wanted);
        let (across, inside) = jumps(&lit.bake, &got, &wanted);
        println!(
            "rank ≤ {max_rank}: added error {added:.5}, nrmse_block {error:.4} ({plain_error:.4} plain), compression {:.1}, \
             jump across borders {across:.5}, inside {inside:.5}",
            report["compression"]
        );
        assert!(added < before, "more components must not err more");
        before = added;
        if max_rank == 32 {
            assert!(error < plain_error + 0.005, "{error} {plain_error}");
            // What compression changes jumps from texel to texel; across borders of clusters not much more than within.
            assert!(across < 2.0 * inside, "{across} {inside}");
        }
    }
    assert!(before < 0.05, "{before}");
}

/// What a bake says of the noise of its rays is how far it lies from one of very many rays.
#[test]
fn the_noise_of_rays_is_known() {
    let scene = built_in::cornell_box();
    for ridge in [0.0, 1e-2] {
        let options = BakeOptions { receivers: 800, rays: 64, ridge, light_metric: false, ..small() };
        let plan = Plan::new(&scene, &options).unwrap();
        let few = plan.bake().0;
        let said = plan.report(&few)["transport_noise"].as_f64().unwrap();
        let many = baked(&scene, &BakeOptions { rays: 4096, ..options });
        assert_eq!(few.receivers, many.receivers);
        // Random coefficients weigh all of the matrix alike.
        let (mut differs, mut total) = (0.0, 0.0);
        for seed in 0..16 {
            let random = |i: usize| f64::from(rand(seed, i as u32, 0)) - 0.5;
            let coefs: Vec<[f64; 3]> = (0..few.probes.len() * few.coefficient_count())
                .map(|i| [3 * i, 3 * i + 1, 3 * i + 2].map(random))
                .collect();
            for (a, b) in few.reconstruct(&coefs).iter().zip(many.reconstruct(&coefs)) {
                differs += f64::from((*a - b).length_squared());
                total += f64::from(b.length_squared());
            }
        }
        let is = (differs / total).sqrt();
        println!("ridge {ridge}: noise of 64 rays {is:.4}, said {said:.4}");
        assert!(said > 0.6 * is && said < 1.7 * is, "{said} {is}");
    }
}

/// Root mean square difference relative to the mean.
fn relative(got: &[Vec3], wanted: &[Vec3]) -> f64 {
    let error: f64 = got.iter().zip(wanted).map(|(a, b)| f64::from((*a - *b).length_squared())).sum();
    let mean: f64 = wanted.iter().map(|e| f64::from(e.element_sum())).sum();
    (error / (3.0 * got.len() as f64)).sqrt() / (mean / (3.0 * got.len() as f64))
}

/// Mean jump of the error between neighbouring texels, where they belong to two clusters and where to one, relative to the mean.
fn jumps(bake: &SrpBake, got: &[Vec3], wanted: &[Vec3]) -> (f64, f64) {
    let mut owner = vec![0; bake.receivers.len()];
    for (c, cluster) in bake.clusters.iter().enumerate() {
        cluster.receivers.clone().for_each(|r| owner[r as usize] = c);
    }
    let at: std::collections::HashMap<[u32; 2], usize> = bake.texel.iter().enumerate().map(|(i, t)| (*t, i)).collect();
    let mean = wanted.iter().map(|e| f64::from(e.element_sum())).sum::<f64>() / wanted.len() as f64;
    let mut sums = [(0.0f64, 0.0f64); 2];
    for (i, [x, y]) in bake.texel.iter().enumerate() {
        for beside in [[x + 1, *y], [*x, y + 1]] {
            // Neighbours of one wall only: charts meet at gutters.
            let Some(j) = at.get(&beside) else { continue };
            let jump = (got[i] - wanted[i]) - (got[*j] - wanted[*j]);
            let sum = &mut sums[usize::from(owner[i] == owner[*j])];
            *sum = (sum.0 + f64::from(jump.abs().element_sum()), sum.1 + 1.0);
        }
    }
    (sums[0].0 / sums[0].1.max(1.0) / mean, sums[1].0 / sums[1].1.max(1.0) / mean)
}

#[test]
fn dictionary_and_components_side_by_side() {
    let scene = built_in::cornell_box();
    let options = BakeOptions { receivers: 1200, order: 4, cluster_size: 512, ..small() };
    let plain = baked(&scene, &options);
    let direct = |bake: &SrpBake| bake.receivers.iter().map(|r| Vec3::splat(1.0 + r.position.y)).collect::<Vec<_>>();
    let wanted: std::collections::HashMap<[u32; 2], Vec3> =
        plain.texel.iter().copied().zip(plain.bounce(&direct(&plain), 8)).collect();
    let dictionary = |atoms, sparsity| Compression::Dictionary { atoms, sparsity };
    let components = |max_rank| Compression::Cpca { error: 0.005, max_rank, noise: 0.0 };
    println!("| compressor | bytes | matrix or metric error | irradiance error | seconds |");
    let mut rows = Vec::new();
    for compression in
        [dictionary(32, 4), dictionary(64, 8), dictionary(128, 12), components(4), components(8), components(32)]
    {
        let plan = Plan::new(&scene, &BakeOptions { compression, ..options.clone() }).unwrap();
        let started = std::time::Instant::now();
        let bake = plan.bake().0;
        let seconds = started.elapsed().as_secs_f64();
        let report = plan.report(&bake);
        let same: Vec<Vec3> = bake.texel.iter().map(|t| wanted[t]).collect();
        let error = relative(&bake.bounce(&direct(&bake), 8), &same);
        let (bytes, matrix) = (&report["transport_f16_bytes"], &report["transport_error"]);
        println!("| {compression:?} | {bytes} | {matrix} | {error:.4} | {seconds:.2} |");
        rows.push((bytes.as_f64().unwrap(), error));
    }
    // More of either is better and larger; components give less error at fewer bytes.
    for kind in [&rows[..3], &rows[3..]] {
        assert!(kind.windows(2).all(|w| w[1].0 > w[0].0 && w[1].1 < w[0].1), "{rows:?}");
    }
    assert!(rows[5].1 < 0.05 && rows[5].0 < rows[2].0 && rows[5].1 < rows[2].1, "{rows:?}");
}

/// Uncompressed, four rows give the irradiance that one row gives: the same light by other rays.
#[test]
fn four_rows_agree_with_one() {
    let scene = built_in::cornell_box();
    let options = BakeOptions { rays: 1024, ..small() };
    let one = baked(&scene, &options);
    let four = baked(&scene, &BakeOptions { rows: 4, ..options });
    assert_eq!(one.receivers, four.receivers);
    let direct: Vec<Vec3> = one.receivers.iter().map(|r| Vec3::splat(1.0 + r.position.y)).collect();
    let (a, b) = (one.bounce(&direct, 4), four.bounce(&direct, 4));
    let (error, bias) = (relative(&b, &a), mean(&four, &b) / mean(&one, &a));
    println!("order-1 radiance against irradiance: {error:.4}, means {bias}");
    assert!(error < 0.15 && (bias - 1.0).abs().max_element() < 0.05, "{error} {bias}");
}

/// What all of a texel sees is what its points see: asking each ray changes next to nothing.
#[test]
fn visibility_by_texel_is_visibility_by_ray() {
    let scene = built_in::cornell_box();
    let options = BakeOptions { receivers: 2500, ridge: 0.0, ..small() };
    let (texels, rays) = (baked(&scene, &options), baked(&scene, &BakeOptions { texel_visibility: false, ..options }));
    let direct: Vec<Vec3> = texels.receivers.iter().map(|r| Vec3::splat(1.0 + r.position.y)).collect();
    let error = relative(&texels.bounce(&direct, 4), &rays.bounce(&direct, 4));
    println!("visibility by texel against by ray: {error:.5}");
    assert!(error > 0.0 && error < 0.005, "{error}");
}

/// Floor under the blocks is inside of them: no texel there counts, and none elsewhere is lost.
#[test]
fn receivers_inside_geometry_are_dropped() {
    let scene = built_in::cornell_box();
    let plan = Plan::new(&scene, &BakeOptions { receivers: 6000, ..small() }).unwrap();
    let floor = |p: Vec3| p.y < 1e-4;
    let kept = plan.receivers.iter().filter(|(r, _)| floor(r.position)).count();
    let all = plan.atlas.texels.iter().filter(|t| floor(t.receiver.position)).count();
    // The blocks' feet are squares of about 0.165 m on a floor of about 0.55 × 0.56 m: 18 % of it.
    let share = 1.0 - kept as f64 / all as f64;
    println!("{share:.3} of the floor's texels lie under blocks");
    assert!((0.12..0.22).contains(&share), "{share}");
    for inside in [Vec3::new(0.185, 0.0, 0.169), Vec3::new(0.368, 0.0, 0.351)] {
        let near = |(r, _): &(interreflect::methods::srp::model::Receiver, u32)| (r.position - inside).length() < 0.05;
        assert!(!plan.receivers.iter().any(near), "a receiver within the block at {inside}");
    }
}

/// The papers' size: more than 40,000 receivers under 27 probes of order 7.
#[test]
fn cornell_box_at_the_papers_size() {
    let scene = built_in::cornell_box();
    let options = BakeOptions { receivers: 41_500, rays: 256, ..BakeOptions::default() };
    let bake = baked(&scene, &options);
    assert!(bake.receivers.len() >= 40_000 && bake.probes.len() == 27, "{}", bake.receivers.len());
    let lit = lit(&scene, bake, 96);
    let (error, bias) = block_error(&lit, &lit.bake.bounce(&lit.direct, 24));
    println!("{} receivers, compressed: nrmse_block {error:.4}, bias {bias:.4}", lit.bake.receivers.len());
    assert!(error <= 0.05 && (0.97..1.03).contains(&bias), "{error} {bias}");
}
