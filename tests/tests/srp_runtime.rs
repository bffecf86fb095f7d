//! Run time of sparse radiance probes against the plain oracle of the bake, on the CPU and on a device.

use glam::{Vec3, Vec4};
use interreflect::exec::{CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::StageClock;
use interreflect::methods::srp::model::{Blend, SrpBake};
use interreflect::methods::srp::runtime::{RuntimeOptions, SrpRuntime};
use interreflect::methods::srp::synthetic::{self, Sizes};
use interreflect_tests::gpu;

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
        assert_eq!(at(*texel), e.extend(1.0));
    }
    assert!(bake.dilation.len() > 50);
    for (texel, blend) in &bake.dilation {
        assert!((at(*texel).truncate() - blend.of(&irradiance)).abs().max_element() < 1e-5);
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
        assert!((got.truncate() - blend.of(&irradiance)).abs().max_element() < 1e-5);
    }
}
