//! Run time of sparse radiance probes against the plain oracle of the bake, on the CPU and on a device.

use glam::{Vec3, Vec4};
use interreflect::exec::{CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::StageClock;
use interreflect::methods::srp::feedback::{Feedback, gain_bound};
use interreflect::methods::srp::model::{Blend, RAY_INVALID, RAY_MISS, SrpBake};
use interreflect::methods::srp::occluders::{Occluder, Shape};
use interreflect::methods::srp::runtime::{RuntimeOptions, SrpRuntime, TAIL_FROM};
use interreflect::methods::srp::synthetic::{self, Sizes};
use interreflect::scene::built_in::SceneBuilder;
use interreflect::scene::device::SceneBuffers;
use interreflect_kernels::math::sh;
use interreflect_kernels::srp::query::{dominant_light, ggx, schlick};
use interreflect_shared::scene::Surfel;
use interreflect_shared::srp::SrpGloss;
use interreflect_tests::gpu;
use std::f32::consts::PI;

const SIZES: Sizes = Sizes {
    probes: 21,
    order: 3,
    rays: 300,
    clusters: 9,
    mean_rank: 7.0,
    mean_probes: 6.0,
    receivers: 1100,
    rows_per_receiver: 1,
    atlas_side: 64,
};
/// A number that half floats round has 11 bits; of a sum of many rounded products the errors average out.
const HALF: f32 = 1.0 / 2048.0;

fn direct(bake: &SrpBake) -> Vec<Vec3> {
    (0..bake.receivers.len()).map(|i| Vec3::new(1.0, 2.0 + (i % 7) as f32, 0.25 * (i % 3) as f32)).collect()
}

fn runtime(exec: &mut dyn Executor, bake: &SrpBake, options: &RuntimeOptions, bounces: u32) -> Vec<Vec3> {
    let mut runtime = SrpRuntime::new(exec, bake, options).unwrap();
    runtime.set_direct(exec, &direct(bake)).unwrap();
    runtime.set_bounces(bounces);
    assert_eq!(runtime.update(exec, u32::MAX, &mut StageClock::default()).unwrap(), bounces);
    runtime.read_irradiance(exec).unwrap()
}

/// Root mean square difference over the root mean square of what is expected.
fn relative(got: &[Vec3], expected: &[Vec3]) -> f32 {
    assert_eq!(got.len(), expected.len());
    let square = |v: Vec3| f64::from(v.length_squared());
    let difference: f64 = got.iter().zip(expected).map(|(a, b)| square(*a - *b)).sum();
    let norm: f64 = expected.iter().map(|b| square(*b)).sum();
    assert!(norm > 0.0);
    (difference / norm).sqrt() as f32
}

#[test]
fn bounces_are_the_oracles() {
    for (sizes, bounces) in [
        (SIZES, 1),
        (SIZES, 3),
        (Sizes { order: 0, ..SIZES }, 2),
        (Sizes { order: 9, probes: 5, mean_probes: 3.0, ..SIZES }, 1),
        (Sizes { rows_per_receiver: 4, ..SIZES }, 2),
        (Sizes { mean_rank: 0.0, order: 2, ..SIZES }, 2),
        (Sizes { receivers: 17, clusters: 2, ..SIZES }, 2),
    ] {
        let bake = synthetic::bake(&sizes, 3);
        let expected = bake.bounce(&direct(&bake), bounces);
        let got = runtime(&mut CpuExecutor::new(), &bake, &RuntimeOptions::default(), bounces);
        let error = relative(&got, &expected);
        assert!(error < 2.0 * HALF, "{sizes:?}, {bounces} bounces: {error}");
        // Half floats alone must explain the difference.
        assert!(error > 1e-6, "{sizes:?}: matrices were not rounded to half floats: {error}");
    }
}

#[test]
fn splits_change_no_bit() {
    let bake = synthetic::bake(&SIZES, 4);
    let whole = runtime(&mut CpuExecutor::new(), &bake, &RuntimeOptions::default(), 2);
    // No part holds more than one cluster.
    let split = RuntimeOptions { binding_bytes: 4, ..RuntimeOptions::default() };
    assert_eq!(runtime(&mut CpuExecutor::new(), &bake, &split, 2), whole);
    // Other slices add in another order.
    let slices = RuntimeOptions { slice_rays: 16, ..RuntimeOptions::default() };
    assert!(relative(&runtime(&mut CpuExecutor::new(), &bake, &slices, 2), &whole) < 1e-5);
}

#[test]
fn devices_agree_with_the_processor() {
    for path in gpu::SPIRV_PATHS {
        if gpu::shared_availability(path) == gpu::Availability::Ignored {
            continue;
        }
        let mut exec = gpu::lock(path).unwrap();
        for sizes in [SIZES, Sizes { rows_per_receiver: 4, ..SIZES }, Sizes { mean_rank: 0.0, order: 2, ..SIZES }] {
            let bake = synthetic::bake(&sizes, 5);
            let expected = runtime(&mut CpuExecutor::new(), &bake, &RuntimeOptions::default(), 2);
            let mark = exec.mark();
            let got = runtime(&mut *exec, &bake, &RuntimeOptions::default(), 2);
            exec.free_since(mark);
            let error = relative(&got, &expected);
            assert!(error < 1e-5, "{sizes:?}: {error}");
        }
    }
}

#[test]
fn what_did_not_change_is_not_computed() {
    let bake = synthetic::bake(&SIZES, 6);
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
    let mut clock = StageClock::default();
    assert_eq!(runtime.update(&mut exec, 9, &mut clock).unwrap(), 0, "black light bounced");
    runtime.set_bounces(3);
    runtime.set_direct(&mut exec, &direct(&bake)).unwrap();
    let before = exec.buffers();
    // A bounce per frame until light has settled, then none.
    let made: Vec<u32> = (0..6).map(|_| runtime.update(&mut exec, 1, &mut clock).unwrap()).collect();
    assert_eq!(made, [1, 1, 1, 0, 0, 0]);
    assert_eq!((runtime.runs().bounces, runtime.is_settled(), clock.stages.len()), (3, true, 3 * 4));
    assert_eq!(runtime.read_irradiance(&mut exec).unwrap(), {
        let mut again = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
        again.set_bounces(3);
        again.set_direct(&mut exec, &direct(&bake)).unwrap();
        again.update(&mut exec, 9, &mut clock).unwrap();
        again.read_irradiance(&mut exec).unwrap()
    });
    assert_eq!(exec.buffers()[..before.len()], before, "an update made buffers");
    runtime.set_special(&mut exec, Vec3::ONE, &[]).unwrap();
    assert!(!runtime.is_settled());
    assert_eq!(runtime.update(&mut exec, 9, &mut clock).unwrap(), 3);
    assert!(runtime.set_special(&mut exec, Vec3::ONE, &[Vec3::ONE; 99]).is_err());
    assert!(runtime.set_direct(&mut exec, &[Vec3::ONE]).is_err());
}

#[test]
fn atlas_and_points_hold_the_receivers() {
    let bake = synthetic::bake(&SIZES, 7);
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
    runtime.set_bounces(1);
    runtime.set_direct(&mut exec, &direct(&bake)).unwrap();
    runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
    let irradiance = runtime.read_irradiance(&mut exec).unwrap();
    let atlas = runtime.atlas(&mut exec).unwrap();
    let texels: Vec<Vec4> = exec.read_slice(atlas).unwrap();
    let at = |[x, y]: [u32; 2]| texels[(y * SIZES.atlas_side + x) as usize];
    for (texel, e) in bake.texel.iter().zip(&irradiance) {
        // What rings below zero is cut off, here and in points.
        assert_eq!(at(*texel), e.max(Vec3::ZERO).extend(1.0));
    }
    assert!(bake.dilation.len() > 50 && irradiance.iter().any(|e| e.min_element() < 0.0));
    for (texel, blend) in &bake.dilation {
        assert!((at(*texel).truncate() - blend.of(&irradiance).max(Vec3::ZERO)).abs().max_element() < 1e-5);
        assert_eq!(at(*texel).w, 1.0);
    }
    let empty = texels.iter().filter(|t| **t == Vec4::ZERO).count();
    assert_eq!(empty, texels.len() - bake.texel.len() - bake.dilation.len());

    let blends = [
        Blend { receivers: [3, 4, 700, 1099], weights: [0.1, 0.2, 0.3, 0.4] },
        Blend { receivers: [9, u32::MAX, u32::MAX, u32::MAX], weights: [1.0, 0.0, 0.0, 0.0] },
        Blend::NONE,
    ];
    let points = runtime.points(&mut exec, &blends).unwrap();
    let out = exec.zeroed_slice::<Vec4>("out", blends.len()).unwrap();
    runtime.resolve(&mut exec, &points, out).unwrap();
    for (got, blend) in exec.read_slice::<Vec4>(out).unwrap().iter().zip(&blends) {
        assert!((got.truncate() - blend.of(&irradiance).max(Vec3::ZERO)).abs().max_element() < 1e-5);
    }
    let reversed = [blends[2], blends[1], blends[0]];
    runtime.set_points(&mut exec, &points, &reversed).unwrap();
    runtime.resolve(&mut exec, &points, out).unwrap();
    for (got, blend) in exec.read_slice::<Vec4>(out).unwrap().iter().zip(&reversed) {
        assert!((got.truncate() - blend.of(&irradiance).max(Vec3::ZERO)).abs().max_element() < 1e-5);
    }
    assert!(runtime.set_points(&mut exec, &points, &[Blend::NONE; 9]).is_err());
}

#[test]
fn light_settles_in_as_many_bounces_as_it_takes() {
    let bake = white_room(0.5);
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
    runtime.set_direct(&mut exec, &direct(&bake)).unwrap();
    let mut clock = StageClock::default();
    // Halved each time: 2⁻¹⁰ is the first below a thousandth of what has come together.
    let bounces = runtime.settle(&mut exec, 100, 1e-3, &mut clock).unwrap();
    assert!((9..=12).contains(&bounces), "{bounces}");
    assert!(runtime.is_settled());
    let expected = bake.bounce(&direct(&bake), 60);
    assert!(relative(&runtime.read_irradiance(&mut exec).unwrap(), &expected) < 2e-3);
    assert_eq!(runtime.settle(&mut exec, 3, 0.0, &mut clock).unwrap(), 3);
}

/// A bake with an open scene: every ray misses.
fn open_bake() -> SrpBake {
    let mut bake = synthetic::bake(&SIZES, 8);
    bake.ray_hits.fill(RAY_MISS);
    bake
}

#[test]
fn materials_change_at_run_time() {
    let bake = synthetic::bake(&SIZES, 9);
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
    runtime.set_direct(&mut exec, &direct(&bake)).unwrap();
    let mut changed = bake.clone();
    let surfaces: Vec<(Vec3, Vec3)> = (0..bake.receivers.len())
        .map(|i| (Vec3::new(0.1, 0.9, 0.5), if i % 9 == 0 { Vec3::new(3.0, 0.0, 1.0) } else { Vec3::ZERO }))
        .collect();
    changed.receivers.iter_mut().zip(&surfaces).for_each(|(r, s)| r.albedo = s.0);
    runtime.set_surfaces(&mut exec, &surfaces).unwrap();
    runtime.set_special(&mut exec, Vec3::new(0.5, 1.0, 2.0), &[]).unwrap();
    runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
    let emission: Vec<Vec3> = surfaces.iter().map(|s| s.1).collect();
    let radiance = changed.relight(&direct(&bake), &vec![Vec3::ZERO; bake.receivers.len()], &emission);
    let expected = changed.irradiance(&changed.reconstruct(&changed.project(&radiance, Vec3::new(0.5, 1.0, 2.0))));
    assert!(relative(&runtime.read_irradiance(&mut exec).unwrap(), &expected) < 2.0 * HALF);
}

/// Whether a ray meets a sphere or a box along the axes before a distance, in double precision.
fn blocked(origin: Vec3, direction: Vec3, until: f64, body: (Vec3, Vec3, bool)) -> bool {
    let (centre, half, sphere) = body;
    let (o, d) = ((origin - centre).as_dvec3() / half.as_dvec3(), direction.as_dvec3() / half.as_dvec3());
    if sphere {
        let (a, b, c) = (d.dot(d), o.dot(d), o.dot(o) - 1.0);
        let discriminant = b * b - a * c;
        return c <= 0.0 || (discriminant > 0.0 && b < 0.0 && (-b - discriminant.sqrt()) / a < until);
    }
    let (lo, hi) = ((-1.0 - o) / d, (1.0 - o) / d);
    let (near, far) = (lo.min(hi).max_element(), lo.max(hi).min_element());
    near <= far && far >= 0.0 && near.max(0.0) < until
}

#[test]
fn bodies_block_relight_rays() {
    let mut bake = synthetic::bake(&SIZES, 10);
    // What lies behind probes and rays is where receivers say.
    let rays = bake.ray_directions.len();
    for (i, hit) in bake.ray_hits.iter_mut().enumerate() {
        if *hit < RAY_INVALID {
            *hit = i as u32 % SIZES.receivers;
        }
    }
    let ball = (Vec3::new(5.0, 5.0, 5.0), Vec3::splat(2.0), true);
    // A box has an inside, a mesh only sides: no probe lies in it.
    let half = Vec3::new(1.0, 2.0, 1.5);
    let outside = |centre: &Vec3| bake.probes.iter().all(|p| ((*p - *centre).abs() / half).max_element() > 1.0);
    let centre = (2..9).map(|x| Vec3::new(x as f32, 6.0, 4.0)).find(outside).unwrap();
    let crate_ = (centre, half, false);
    let bodies = [Occluder::sphere(ball.0, ball.1.x), Occluder::cuboid(crate_.0, crate_.1)];
    let mut shadowed = bake.clone();
    let mut count = 0;
    for (i, hit) in shadowed.ray_hits.iter_mut().enumerate() {
        let (probe, direction) = (bake.probes[i / rays], bake.ray_directions[i % rays]);
        let until = match *hit {
            RAY_MISS => f64::MAX,
            RAY_INVALID => 0.0,
            receiver => f64::from(probe.distance(bake.receivers[receiver as usize].position)),
        };
        if [ball, crate_].iter().any(|&body| blocked(probe, direction, until, body)) {
            *hit = RAY_INVALID;
            count += 1;
        }
    }
    assert!(count > bake.ray_hits.len() / 50, "{count} rays are blocked");

    let mut exec = CpuExecutor::new();
    let options = RuntimeOptions { occluder_slots: 3, ..RuntimeOptions::default() };
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &options).unwrap();
    let mut lit = |exec: &mut CpuExecutor, bodies: &[Occluder<'_>]| {
        runtime.set_direct(exec, &direct(&bake)).unwrap();
        runtime.set_occluders(exec, Vec3::ZERO, bodies).unwrap();
        runtime.restart(exec).unwrap();
        let before = runtime.runs().occlusions;
        runtime.update(exec, 1, &mut StageClock::default()).unwrap();
        assert_eq!(runtime.runs().occlusions, before, "an update tested rays again");
        runtime.read_irradiance(exec).unwrap()
    };
    let open = lit(&mut exec, &[]);
    assert!(relative(&open, &bake.bounce(&direct(&bake), 1)) < 2.0 * HALF);
    let expected = shadowed.bounce(&direct(&bake), 1);
    let got = lit(&mut exec, &bodies);
    assert!(relative(&got, &expected) < 2.0 * HALF, "{}", relative(&got, &expected));
    assert!(relative(&open, &expected) > 0.02, "the bodies hardly matter");

    // A box made of triangles is a box.
    let mut builder = SceneBuilder::new("box");
    let grey = builder.diffuse("grey", Vec3::splat(0.5));
    builder.block(Vec3::splat(-1.0), Vec3::ONE, grey);
    let mesh = SceneBuffers::upload(&mut exec, &builder.finish()).unwrap();
    let as_mesh = Occluder { shape: Shape::Mesh(&mesh), ..bodies[1] };
    let meshed = lit(&mut exec, &[bodies[0], as_mesh]);
    // A grazing ray may be decided either way.
    assert!(relative(&meshed, &got) < 1e-3, "{}", relative(&meshed, &got));
    // Gone again.
    assert!(lit(&mut exec, &[]) == open);
    assert!(runtime.set_occluders(&mut exec, Vec3::ZERO, &[bodies[0]; 4]).is_err());
}

#[test]
fn a_body_can_shine() {
    let bake = open_bake();
    let mut exec = CpuExecutor::new();
    let options = RuntimeOptions { occluder_slots: 1, ..RuntimeOptions::default() };
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &options).unwrap();
    // Around all probes: each sees its light everywhere.
    let lamp = Occluder { light: Vec3::new(1.0, 2.0, 3.0), ..Occluder::sphere(Vec3::splat(5.0), 100.0) };
    runtime.set_occluders(&mut exec, Vec3::ZERO, &[lamp]).unwrap();
    runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
    let coefs: Vec<f32> = exec.read_slice(runtime.coefficients_buffer()).unwrap();
    let plane = coefs.len() / 3;
    for channel in 0..3 {
        for probe in 0..bake.probes.len() {
            let first = channel * plane + probe * 16;
            let expected = (channel + 1) as f32 * (4.0 * PI).sqrt();
            assert!((coefs[first] - expected).abs() < 1e-4 * expected);
            assert!(coefs[first + 1..first + 16].iter().all(|c| c.abs() < 0.05 * expected));
        }
    }
}

#[test]
fn dynamic_objects_take_the_probes_light() {
    let bake = open_bake();
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
    let sky = Vec3::new(1.0, 2.0, 0.5);
    runtime.set_special(&mut exec, sky, &[]).unwrap();
    runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
    let at = |position: Vec3, normal: Vec3| Surfel {
        position: position.to_array(),
        normal: normal.to_array(),
        ..interreflect_kernels::trace::surface::no_surface()
    };
    let far = Vec3::splat(1e3);
    let surfels = [at(bake.probes[0], Vec3::X), at(bake.probes[3] + 0.5, Vec3::NEG_Z), at(far, Vec3::Y)];
    let points = exec.upload_slice("surfels", &surfels).unwrap();
    let params = runtime.object_points(&mut exec, 3).unwrap();
    let out = exec.zeroed_slice::<Vec4>("out", 3).unwrap();
    runtime.light_objects(&mut exec, params, points, out).unwrap();
    let got: Vec<Vec4> = exec.read_slice(out).unwrap();
    // Under a uniform sky: π times its radiance, from any probe, for any normal.
    for e in &got[..2] {
        assert!((e.truncate() - PI * sky).abs().max_element() < 2e-3 * PI, "{e}");
    }
    assert_eq!(got[2], Vec4::ZERO);
}

#[test]
fn four_rows_give_normals_and_highlights() {
    let bake = synthetic::bake(&Sizes { rows_per_receiver: 4, ..SIZES }, 11);
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, &bake, &RuntimeOptions::default()).unwrap();
    runtime.set_direct(&mut exec, &direct(&bake)).unwrap();
    runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
    let dark = vec![Vec3::ZERO; bake.receivers.len()];
    let radiance = bake.relight(&direct(&bake), &dark, &[]);
    let rows = bake.reconstruct(&bake.project(&radiance, Vec3::ZERO));

    let count = 40;
    let blends: Vec<Blend> = (0..count)
        .map(|i| Blend { receivers: [i * 20, i * 20 + 1, i * 20 + 7, i], weights: [0.4, 0.3, 0.2, 0.1] })
        .collect();
    let direction = |i: u32, n: u32| interreflect_kernels::math::sampling::spherical_fibonacci(i, n);
    let surfels: Vec<Surfel> = (0..count)
        .map(|i| Surfel {
            normal: direction(i, count).to_array(),
            ..interreflect_kernels::trace::surface::no_surface()
        })
        .collect();
    let gloss: Vec<SrpGloss> = (0..count)
        .map(|i| SrpGloss {
            wo: direction(7 * i % count, count).to_array(),
            alpha: 0.5,
            f0: [0.04, 0.5, 1.0],
            _pad0: 0,
        })
        .collect();
    let points = runtime.points(&mut exec, &blends).unwrap();
    let (surfel_buffer, gloss_buffer) =
        (exec.upload_slice("surfels", &surfels).unwrap(), exec.upload_slice("gloss", &gloss).unwrap());
    let out = exec.zeroed_slice::<Vec4>("out", count as usize).unwrap();

    let scale = rows.iter().map(|r| r.abs().max_element()).fold(0.0, f32::max);
    let coefs = |blend: &Blend, channel: usize| -> [f32; 4] {
        std::array::from_fn(|k| {
            let terms = blend.receivers.iter().zip(blend.weights).map(|(r, w)| w * rows[4 * *r as usize + k][channel]);
            terms.sum()
        })
    };
    runtime.normal_mapped(&mut exec, &points, surfel_buffer, out).unwrap();
    for (i, got) in exec.read_slice::<Vec4>(out).unwrap().iter().enumerate() {
        for channel in 0..3 {
            let expected = sh::irradiance(&coefs(&blends[i], channel), surfels[i].normal).max(0.0);
            assert!((got[channel] - expected).abs() < 4.0 * HALF * scale, "{i}: {} {expected}", got[channel]);
        }
    }
    runtime.glossy(&mut exec, &points, surfel_buffer, gloss_buffer, out).unwrap();
    let mut lit = 0;
    for (i, got) in exec.read_slice::<Vec4>(out).unwrap().iter().enumerate() {
        let [r, g, b] = [0, 1, 2].map(|channel| coefs(&blends[i], channel));
        let (wi, irradiance) = dominant_light(r, g, b);
        let (lobe, cosine) = ggx(wi, Vec3::from_array(gloss[i].wo), Vec3::from_array(surfels[i].normal), 0.5);
        let expected = irradiance * schlick(Vec3::from_array(gloss[i].f0), cosine) * lobe;
        assert!((got.truncate() - expected).abs().max_element() < 0.02 * scale, "{i}: {got} {expected}");
        lit += u32::from(expected.max_element() > 0.0);
    }
    assert!(lit > 5, "{lit} points shine");

    let one_row = synthetic::bake(&SIZES, 11);
    let other = SrpRuntime::new(&mut exec, &one_row, &RuntimeOptions::default()).unwrap();
    assert!(other.normal_mapped(&mut exec, &points, surfel_buffer, out).is_err());
}

/// Every probe sees every receiver equally often, and each receiver's irradiance is π times the mean radiance.
fn white_room(albedo: f32) -> SrpBake {
    let mut bake = synthetic::bake(&Sizes { receivers: 400, clusters: 5, ..SIZES }, 12);
    bake.ray_hits.iter_mut().enumerate().for_each(|(i, hit)| *hit = i as u32 % 400);
    bake.receivers.iter_mut().for_each(|r| r.albedo = Vec3::splat(albedo));
    for cluster in &mut bake.clusters {
        cluster.columns = vec![(0, 0)];
        cluster.rank = 1;
        cluster.projection = Vec::new();
        cluster.reconstruction = vec![0.5 * PI.sqrt(); cluster.receivers.len()];
    }
    bake
}

fn feedback(bake: &SrpBake) -> (CpuExecutor, SrpRuntime, Feedback) {
    let mut exec = CpuExecutor::new();
    let mut runtime = SrpRuntime::new(&mut exec, bake, &RuntimeOptions::default()).unwrap();
    runtime.set_direct(&mut exec, &direct(bake)).unwrap();
    let feedback = runtime.keep_below_one(&mut exec, 40).unwrap();
    (exec, runtime, feedback)
}

#[test]
fn the_spectral_radius_of_a_room_is_its_albedo() {
    for albedo in [0.0, 0.3, 0.8] {
        let bake = white_room(albedo);
        let found = feedback(&bake).2;
        assert!((found.spectral_radius - f64::from(albedo)).abs() < 1e-3, "{albedo}: {found:?}");
        assert!(!found.alarm && found.damping == 1.0);
        // One lobe of a constant: the bound is tight but for the sides of the sphere.
        let bound = gain_bound(&bake);
        assert!(bound >= f64::from(albedo) * 0.999 && bound < f64::from(albedo) * 1.2 + 1e-9, "{albedo}: {bound}");
    }
}

#[test]
fn a_loop_that_grows_alarms_and_is_damped() {
    let bake = white_room(1.25);
    let (mut exec, mut runtime, found) = feedback(&bake);
    assert!(found.alarm && (found.spectral_radius - 1.25).abs() < 2e-3, "{found:?}");
    assert!((f64::from(found.damping) * found.spectral_radius - 0.98).abs() < 1e-5);
    assert_eq!(runtime.needs()["feedback"]["alarm"], true);
    // A thousand bounces stay finite and settle.
    runtime.set_bounces(1000);
    runtime.restart(&mut exec).unwrap();
    runtime.update(&mut exec, 999, &mut StageClock::default()).unwrap();
    let before = runtime.read_irradiance(&mut exec).unwrap();
    runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
    let after = runtime.read_irradiance(&mut exec).unwrap();
    assert!(relative(&before, &after) < 1e-4, "{}", relative(&before, &after));
    // Undamped the same loop grows without end.
    let wild = bake.bounce(&direct(&bake), 60);
    assert!(wild[0].x > 1e5, "{}", wild[0]);
}

#[test]
fn a_tail_stands_for_the_bounces_that_are_left_out() {
    for (albedo, bounces) in [(0.5, TAIL_FROM), (0.9, TAIL_FROM), (0.97, 12), (0.99, 12)] {
        let bake = white_room(albedo);
        let (mut exec, mut runtime, _) = feedback(&bake);
        runtime.set_bounces(bounces);
        runtime.restart(&mut exec).unwrap();
        let handed_on = runtime.update_with_tail(&mut exec, &mut StageClock::default()).unwrap();
        assert!(runtime.is_settled(), "{albedo}");
        assert!(handed_on.iter().all(|h| (h - f64::from(albedo)).abs() < 1e-2), "{albedo}: {handed_on:?}");
        let got = runtime.read_irradiance(&mut exec).unwrap();
        let all = bake.bounce(&direct(&bake), 2000);
        // What half floats take from each bounce adds up over all of them.
        let allowed = 2.0 * HALF / (1.0 - albedo);
        let cut = relative(&bake.bounce(&direct(&bake), bounces), &all);
        assert!(relative(&got, &all) < allowed, "{albedo}: {} > {allowed}, cut off {cut}", relative(&got, &all));
        assert!(cut > 2.0 * allowed, "{albedo}: {cut}");
    }
    // Too few bounces to see what the loop hands on: as many as asked for, and no more.
    let bake = white_room(0.9);
    let (mut exec, mut runtime, _) = feedback(&bake);
    runtime.set_bounces(TAIL_FROM - 1);
    runtime.restart(&mut exec).unwrap();
    assert_eq!(runtime.update_with_tail(&mut exec, &mut StageClock::default()).unwrap(), [0.0; 3]);
    let expected = bake.bounce(&direct(&bake), TAIL_FROM - 1);
    assert!(relative(&runtime.read_irradiance(&mut exec).unwrap(), &expected) < 2e-3);
}

#[test]
fn bounces_converge_as_fast_as_the_bound_promises() {
    for (seed, rows_per_receiver) in [(13, 1), (14, 4)] {
        let mut bake = synthetic::bake(&Sizes { rows_per_receiver, ..SIZES }, seed);
        // Scale the transport until the proof holds.
        let shrink = (0.7 / gain_bound(&bake)) as f32;
        for cluster in &mut bake.clusters {
            cluster.reconstruction.iter_mut().for_each(|u| *u *= shrink);
        }
        let bound = gain_bound(&bake);
        assert!((bound - 0.7).abs() < 1e-3, "{bound}");
        let (mut exec, mut runtime, found) = feedback(&bake);
        assert!(found.spectral_radius <= bound * (1.0 + 1e-3), "{found:?} above the bound {bound}");
        runtime.set_bounces(40);
        runtime.restart(&mut exec).unwrap();
        let mut steps: Vec<Vec<Vec3>> = vec![vec![Vec3::ZERO; bake.receivers.len()]];
        for _ in 0..40 {
            runtime.update(&mut exec, 1, &mut StageClock::default()).unwrap();
            steps.push(runtime.read_irradiance(&mut exec).unwrap());
        }
        let distance =
            |a: &[Vec3], b: &[Vec3]| a.iter().zip(b).map(|(a, b)| (*a - *b).abs().max_element()).fold(0.0, f32::max);
        let first = f64::from(distance(&steps[1], &steps[0]));
        for n in 1..30 {
            let now = f64::from(distance(&steps[n + 1], &steps[n]));
            let promised = bound * f64::from(distance(&steps[n], &steps[n - 1])) + 1e-6 * first;
            assert!(now <= promised * (1.0 + 4.0 * f64::from(HALF)), "bounce {n}: {now} > {promised}");
            let left = f64::from(distance(&steps[n], &steps[40]));
            assert!(left <= bound.powi(n as i32) / (1.0 - bound) * first + 1e-5 * first, "bounce {n}: {left}");
        }
    }
}
