//! Voxel cone tracing against path-traced truth, closed forms, and its own promises.

use glam::{Vec3, Vec4};
use interreflect::exec::{CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::voxels::{VoxelGrid, VoxelOptions, VoxelScene};
use interreflect::methods::{Input, Settings, StageClock, vct};
use interreflect::reference::{Receiver, ReferenceSettings, irradiance};
use interreflect::scene::built_in::{cornell_box, furnace, louvres, two_rooms};
use interreflect::scene::device::SceneBuffers;
use interreflect::scene::{Alpha, Camera, LoadOptions, Scene, load};
use interreflect_kernels::cone::gather::cone_gather;
use interreflect_kernels::cone::set::{CONE_COUNTS, cone_parts, diffuse_cones, half_angle_tangent};
use interreflect_kernels::trace::gbuffer::trace_gbuffer;
use interreflect_shared::cone::ConeParams;
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use interreflect_shared::trace::GBufferParams;
use interreflect_shared::voxel::VoxelFacet;
use std::f32::consts::PI;

/// Pixels along each side of the test pictures.
const SIZE: u32 = 64;
/// Pixels of a block of `nrmse_block`.
const BLOCK: u32 = 8;

/// Primary hits of a square picture.
fn surfels(exec: &mut CpuExecutor, scene: &Scene, buffers: &SceneBuffers, camera: &Camera) -> Vec<Surfel> {
    let half = (0.5 * camera.fovy_rad).tan();
    let params = GBufferParams {
        position: camera.position.extend(0.0),
        forward: camera.forward.extend(0.0),
        right: (camera.forward.cross(camera.up) * half).extend(0.0),
        up: (camera.up * half).extend(0.0),
        environment: scene.environment.extend(0.0),
        width: SIZE,
        height: SIZE,
        _pad0: 0,
        _pad1: 0,
    };
    let uniform = exec.upload_one("camera", &params).unwrap();
    let out = exec.zeroed_slice::<Surfel>("gbuffer", (SIZE * SIZE) as usize).unwrap();
    let [a, b, c, d] = buffers.trace_bindings();
    exec.run(&trace_gbuffer::KERNEL, &[uniform, a, b, c, d, out]).unwrap();
    exec.read_slice(out).unwrap()
}

struct Outcome {
    irradiance: Vec<Vec3>,
    stages: Vec<(String, f64)>,
    needs: serde_json::Value,
}

/// The method's irradiance at given surfels.
fn run(scene: &Scene, receivers: &[Surfel], changes: &[(&str, &str)]) -> Outcome {
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, scene).unwrap();
    let settings: Settings = changes.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect();
    let mut method = (vct::ROW.new)(&settings).unwrap();
    let input = Input { scene, buffers: &buffers, seed: 1, true_mean: None };
    let gbuffer = exec.upload_slice("gbuffer", receivers).unwrap();
    let out = exec.zeroed_slice::<Vec4>("irradiance", receivers.len()).unwrap();
    let mut clock = StageClock::default();
    method.precompute(&mut exec, &input, &mut clock).unwrap();
    method.light_change(&mut exec, &input, &mut clock).unwrap();
    let before = exec.buffers();
    method.light_change(&mut exec, &input, &mut clock).unwrap();
    method.frame(&mut exec, &input, gbuffer, out, &mut clock).unwrap();
    assert_eq!(exec.buffers(), before, "a frame or a light change made buffers");
    let irradiance = exec.read_slice::<Vec4>(out).unwrap().iter().map(|v| v.truncate()).collect();
    Outcome { irradiance, stages: clock.stages, needs: method.needs() }
}

fn truth(scene: &Scene, receivers: &[Surfel], spp: u32) -> Vec<Vec3> {
    let receivers: Vec<Receiver> = receivers.iter().map(Receiver::from).collect();
    let settings = ReferenceSettings { spp: Some(spp), seed: 5, ..Default::default() };
    let result = irradiance(scene, &receivers, &settings, &mut |_| {}).unwrap();
    result.values.iter().map(|v| v.indirect).collect()
}

/// Root mean square difference and mean ratio, over the mean of the truth.
fn error(got: &[Vec3], truth: &[Vec3]) -> (f32, f32) {
    let n = 3.0 * got.len() as f32;
    let mean = |v: &[Vec3]| v.iter().map(|x| x.element_sum()).sum::<f32>() / n;
    let square: f32 = got.iter().zip(truth).map(|(a, b)| (*a - *b).length_squared()).sum();
    ((square / n).sqrt() / mean(truth), mean(got) / mean(truth))
}

fn block_means(picture: &[Vec3]) -> Vec<Vec3> {
    let blocks = SIZE / BLOCK;
    (0..blocks * blocks)
        .map(|b| {
            let (x0, y0) = (b % blocks * BLOCK, b / blocks * BLOCK);
            let pixels = (0..BLOCK * BLOCK).map(|k| picture[((y0 + k / BLOCK) * SIZE + x0 + k % BLOCK) as usize]);
            pixels.sum::<Vec3>() / (BLOCK * BLOCK) as f32
        })
        .collect()
}

fn picture_surfels(scene: &Scene, camera: &Camera) -> Vec<Surfel> {
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, scene).unwrap();
    surfels(&mut exec, scene, &buffers, camera)
}

#[test]
fn cornell_box_converges_to_the_truth() {
    let scene = cornell_box();
    let receivers = picture_surfels(&scene, &scene.cameras[0]);
    let truth = truth(&scene, &receivers, 128);
    let mut errors = Vec::new();
    for resolution in ["32", "64", "128"] {
        let result = run(&scene, &receivers, &[("resolution", resolution), ("bounces", "2")]);
        let (nrmse, bias) = error(&result.irradiance, &truth);
        let (block, _) = error(&block_means(&result.irradiance), &block_means(&truth));
        println!("{resolution}: nrmse {nrmse:.3}, nrmse_block {block:.3}, bias {bias:.3}");
        println!("    {:?}\n    {}", result.stages, result.needs);
        errors.push((block, bias));
    }
    let [(e32, _), (e64, _), (e128, bias)] = errors[..] else { unreachable!() };
    assert!(e128 <= 0.25 && (0.85..=1.15).contains(&bias), "nrmse_block {e128}, bias {bias}");
    assert!(e128 < e64 && e64 < e32, "{e32} {e64} {e128}");
}

#[test]
fn a_furnace_keeps_its_energy() {
    let scene = furnace(0.5, 1.0);
    let receivers = picture_surfels(&scene, &scene.cameras[0]);
    let result = run(&scene, &receivers, &[("resolution", "64"), ("bounces", "10")]);
    // π·Lₑ·ρ/(1 − ρ): everything but the walls' own emission.
    let expected = vec![Vec3::splat(PI); receivers.len()];
    let (nrmse, ratio) = error(&result.irradiance, &expected);
    println!("furnace: {ratio:.4} of the closed form, nrmse {nrmse:.4}");
    assert!((ratio - 1.0).abs() < 0.1 && nrmse < 0.15, "{ratio} {nrmse}");
}

/// Sun falls on slats, and from them through a room: the second bounce says little of those after it.
#[test]
fn bounces_go_on_until_light_has_spread() {
    let scene = louvres();
    let receivers = picture_surfels(&scene, &scene.cameras[0]);
    let truth = block_means(&truth(&scene, &receivers, 128));
    let of = |changes: &[(&str, &str)]| {
        let result = run(&scene, &receivers, &[&[("resolution", "64")], changes].concat());
        let made = result.needs["bounces"].as_u64().unwrap();
        (error(&block_means(&result.irradiance), &truth), made)
    };
    let ((few, few_bias), two) = of(&[("bounces", "2")]);
    let ((enough, bias), made) = of(&[]);
    let ((all, _), most) = of(&[("converged", "0")]);
    println!("{few:.3} {few_bias:.3}, {made}: {enough:.3} {bias:.3}, {most}: {all:.3}");
    assert!(two == 2 && (3..=8).contains(&made) && most == 16, "{two} {made} {most}");
    assert!(enough < 0.7 * few && (bias - 1.0).abs() < (few_bias - 1.0).abs(), "{few} {enough} {bias}");
    assert!(enough < all + 0.05, "it ended too early: {enough} {all}");
}

/// Mean irradiance in the dark room of `two_rooms` over that in the lit one. `grey`: reflectance of all surfaces, in place of
/// their own.
fn leak(resolution: u16, wall_voxels: f32, grey: Option<f32>, settings: &[(&str, &str)]) -> f32 {
    // The grid's longest side is both rooms, both their outer walls' padding, and the wall itself.
    let voxel = 6.0 / (f32::from(resolution) - 3.0 - wall_voxels);
    let mut scene = two_rooms(wall_voxels * voxel, 0.0);
    if let Some(albedo) = grey {
        scene.materials.iter_mut().for_each(|m| m.albedo = Vec3::splat(albedo));
    }
    let resolution = resolution.to_string();
    let settings = [&[("resolution", resolution.as_str())], settings].concat();
    let mean = |camera: &Camera| {
        let receivers = picture_surfels(&scene, camera);
        let result = run(&scene, &receivers, &settings);
        result.irradiance.iter().map(|v| v.element_sum()).sum::<f32>() / (3 * result.irradiance.len()) as f32
    };
    mean(&scene.cameras[0]) / mean(&scene.cameras[1])
}

#[test]
fn a_sealed_dark_room_stays_dark() {
    for wall in [0.5, 1.0, 2.0, 4.0] {
        let of = |mipmaps| 100.0 * leak(64, wall, None, &[("mipmaps", mipmaps), ("bounces", "3")]);
        let (six, one) = (of("anisotropic"), of("isotropic"));
        println!("wall of {wall} voxels: {six:.3} % leaks with anisotropic mipmaps, {one:.3} % with isotropic ones");
        assert!(wall < 2.0 || six <= 1.0, "{wall}: {six}");
    }
    // In bright rooms what leaks goes on from bounce to bounce.
    for wall in [2.0, 4.0] {
        let bright = 100.0 * leak(128, wall, Some(0.7), &[]);
        println!("wall of {wall} voxels between rooms of albedo 0.7: {bright:.3} %");
        assert!(bright <= 1.0, "{wall}: {bright}");
    }
}

#[test]
fn a_uniform_field_gives_its_own_irradiance() {
    // Open boxes and the sky, all of radiance 1, from anywhere and in any direction.
    let scene = two_rooms(0.3, 0.7);
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, &scene).unwrap();
    for anisotropic in [true, false] {
        let options = VoxelOptions { method: "test", anisotropic, limit_bytes: 1 << 30, emission_max: 1.0 };
        let grid = VoxelGrid::around(scene.bounds(), 48);
        let voxels = VoxelScene::build(&mut exec, &buffers, &grid, &options, &mut StageClock::default()).unwrap();
        exec.write(voxels.radiance, bytemuck::cast_slice(&vec![1.0f32; 8 * voxels.params.facet_count as usize]))
            .unwrap();
        voxels.mipmap(&mut exec).unwrap();
        for cones in CONE_COUNTS {
            let params = ConeParams {
                origin_size: voxels.params.origin_size,
                dims_levels: voxels.params.dims_levels,
                levels: voxels.params.levels,
                cones: diffuse_cones(cones),
                parts: cone_parts(cones),
                beyond: Vec4::ONE,
                camera: Vec4::ZERO,
                cone_count: cones,
                direction_count: voxels.params.direction_count,
                count: SIZE * SIZE,
                seed: 9,
                spread: half_angle_tangent(cones),
                offset: 0.5,
                clearance: 1.0,
                _pad: 0.0,
            };
            let receivers = surfels(&mut exec, &scene, &buffers, &scene.cameras[0]);
            assert!(receivers.iter().all(|s| s.triangle != NO_SURFACE));
            let uniform = exec.upload_one("cones", &params).unwrap();
            let gbuffer = exec.upload_slice("gbuffer", &receivers).unwrap();
            let out = exec.zeroed_slice::<Vec4>("irradiance", receivers.len()).unwrap();
            let v = &voxels;
            let bound = [uniform, v.cells, v.facet_bits, v.facets, v.radiance, v.odd, v.even, gbuffer, out];
            exec.run(&cone_gather::KERNEL, &bound).unwrap();
            for e in exec.read_slice::<Vec4>(out).unwrap() {
                assert!((e.truncate() / PI - 1.0).abs().max_element() < 1e-4, "{cones} cones: {e}");
            }
        }
    }
}

/// Cornell's surfaces lit by a lamp: flux that facets reflect, and its truth, Σ albedo·E·A over both sides.
#[test]
fn injected_flux_is_the_truths() {
    let scene = cornell_box();
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, &scene).unwrap();
    let options = VoxelOptions { method: "test", anisotropic: true, limit_bytes: 1 << 30, emission_max: 100.0 };
    let grid = VoxelGrid::around(scene.bounds(), 96);
    let mut voxels = VoxelScene::build(&mut exec, &buffers, &grid, &options, &mut StageClock::default()).unwrap();
    voxels.inject(&mut exec, &Input { scene: &scene, buffers: &buffers, seed: 3, true_mean: None }, 16, 0).unwrap();
    let facets = exec.read_slice::<VoxelFacet>(voxels.facets).unwrap();
    let direct = exec.read_slice::<Vec4>(voxels.direct).unwrap();
    let face = grid.voxel_size * grid.voxel_size;
    let got: Vec3 = facets
        .iter()
        .enumerate()
        .map(|(k, f)| Vec3::from(f.albedo) * (direct[2 * k] + direct[2 * k + 1]).truncate() * f.area * face)
        .sum();

    // Points spread over every triangle, both sides.
    let (mut receivers, mut weights) = (Vec::new(), Vec::new());
    for t in &scene.triangles {
        let [a, b, c] = scene.corners(t);
        let cross = (b - a).cross(c - a);
        let n = cross.normalize();
        let count = 400;
        for k in 0..count {
            let (u, v) = ((k as f32 + 0.5) / count as f32, (k as f32 * 0.618_034).fract());
            let s = u.sqrt();
            let p = a * (1.0 - s) + b * (s * (1.0 - v)) + c * (s * v);
            for side in [n, -n] {
                receivers.push(Receiver::new(p, side));
                weights.push(scene.materials[t.material as usize].albedo * (0.5 * cross.length() / count as f32));
            }
        }
    }
    let settings = ReferenceSettings { spp: Some(64), seed: 2, max_bounces: Some(1), ..Default::default() };
    let values = irradiance(&scene, &receivers, &settings, &mut |_| {}).unwrap().values;
    let expected: Vec3 = values.iter().zip(&weights).map(|(v, w)| v.direct * *w).sum();
    println!("injected flux {got}, truth {expected}, ratio {}", got / expected);
    assert!((got / expected - 1.0).abs().max_element() < 0.005, "{got} {expected}");
}

#[test]
fn sponza_voxelizes_with_all_its_area() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/scenes/crytek_sponza.glb");
    if !std::path::Path::new(path).exists() {
        println!("skipped: {path} is absent");
        return;
    }
    let scene = load(path, &LoadOptions::default()).unwrap();
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, &scene).unwrap();
    let options = VoxelOptions { method: "test", anisotropic: true, limit_bytes: 4 << 30, emission_max: 0.0 };
    let grid = VoxelGrid::around(scene.bounds(), 256);
    let mut clock = StageClock::default();
    let voxels = VoxelScene::build(&mut exec, &buffers, &grid, &options, &mut clock).unwrap();
    let ms: f64 = clock.stages.iter().map(|s| s.1).sum();
    println!(
        "Sponza at 256: {ms:.0} ms, {:.2} Mtriangles/s, {:.2} Mvoxels/s; {:?}\n{}",
        scene.triangles.len() as f64 / ms / 1e3,
        f64::from(voxels.voxel_count) / ms / 1e3,
        clock.stages,
        voxels.needs()
    );
    let facets = exec.read_slice::<VoxelFacet>(voxels.facets).unwrap();
    let total: f64 = facets.iter().map(|f| f64::from(f.area)).sum::<f64>() * f64::from(grid.voxel_size).powi(2);
    // Cut-out leaves and chains lose area; everything else is conserved.
    let area = |t: &interreflect::scene::Triangle| {
        let [a, b, c] = scene.corners(t);
        0.5 * f64::from((b - a).cross(c - a).length())
    };
    let cut_out = |t: &interreflect::scene::Triangle| scene.materials[t.material as usize].alpha != Alpha::Opaque;
    let all: f64 = scene.triangles.iter().map(area).sum();
    let masked: f64 = scene.triangles.iter().filter(|t| cut_out(t)).map(area).sum();
    assert!(total > (all - masked) * 0.999 && total < all * 1.001, "{} ≤ {total} ≤ {all}", all - masked);
}
