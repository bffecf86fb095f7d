//! Light propagation volumes against path-traced truth, closed forms, and their own promises.

#![allow(unused_imports)]
use glam::{DVec3, UVec3, Vec3, Vec4};
use interreflect::exec::{CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::lpv::maps::Maps;
use interreflect::methods::lpv::volume::{Ledger, Placement, Volume};
use interreflect::methods::lpv::{self, Lpv, Options};
use interreflect::methods::{Input, Method, Settings, StageClock};
use interreflect::reference::{Receiver, ReferenceSettings, irradiance};
use interreflect::scene::built_in::{SceneBuilder, cornell_box, furnace, sphere_furnace, two_rooms};
use interreflect::scene::device::SceneBuffers;
use interreflect::scene::{Camera, Light, Scene};
use interreflect_kernels::trace::gbuffer::trace_gbuffer;
use interreflect_shared::lpv::{LpvLayout, RsmTexel};
use interreflect_shared::scene::Surfel;
use interreflect_shared::trace::GBufferParams;
use std::f32::consts::PI;

/// Pixels along each side of the test pictures.
const SIZE: u32 = 64;
/// Pixels of a block of `nrmse_block`.
const BLOCK: u32 = 8;

fn picture_surfels(scene: &Scene, camera: &Camera) -> Vec<Surfel> {
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, scene).unwrap();
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

fn settings(changes: &[(&str, &str)]) -> Settings {
    changes.iter().map(|(k, v)| (k.to_string(), v.to_string())).collect()
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
    let mut method = (lpv::ROW.new)(&settings(changes)).unwrap();
    let input = Input { scene, buffers: &buffers, seed: 1, true_mean: None };
    let gbuffer = exec.upload_slice("gbuffer", receivers).unwrap();
    let out = exec.zeroed_slice::<Vec4>("irradiance", receivers.len()).unwrap();
    let mut clock = StageClock::default();
    method.precompute(&mut exec, &input, &mut clock).unwrap();
    let before = exec.buffers();
    method.light_change(&mut exec, &input, &mut clock).unwrap();
    method.frame(&mut exec, &input, gbuffer, out, &mut clock).unwrap();
    assert_eq!(exec.buffers(), before, "a frame or a light change made buffers");
    let irradiance = exec.read_slice::<Vec4>(out).unwrap().iter().map(|v| v.truncate()).collect();
    Outcome { irradiance, stages: clock.stages, needs: method.needs() }
}

fn truth(scene: &Scene, receivers: &[Surfel], spp: u32, max_bounces: Option<u32>) -> Vec<Vec3> {
    let receivers: Vec<Receiver> = receivers.iter().map(Receiver::from).collect();
    let settings = ReferenceSettings { spp: Some(spp), seed: 5, max_bounces, ..Default::default() };
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

/// Block error and bias.
fn judge(got: &[Vec3], truth: &[Vec3]) -> (f32, f32) {
    (error(&block_means(got), &block_means(truth)).0, error(got, truth).1)
}

#[test]
fn experiment() {
    let scene = cornell_box();
    let receivers = picture_surfels(&scene, &scene.cameras[0]);
    // One bounce of light, and the receiver's own reflection.
    let one = truth(&scene, &receivers, 128, Some(2));
    let sets: Vec<String> = std::env::var("LPV_SETS").unwrap_or_default().split(';').map(|s| s.to_string()).collect();
    for set in sets {
        let changes: Vec<(&str, &str)> = set.split(',').filter_map(|kv| kv.split_once('=')).collect();
        for resolution in ["16", "32", "64"] {
            let mut all = vec![("resolution", resolution), ("bounces", "1")];
            all.extend(&changes);
            let result = run(&scene, &receivers, &all);
            let (block, bias) = judge(&result.irradiance, &one);
            println!(
                "{set} {resolution}: nrmse {:.3} nrmse_block {block:.3}, bias {bias:.3} {}",
                error(&result.irradiance, &one).0,
                result.needs["steps_per_level"]
            );
            if resolution == "32" {
                println!("{:?}", result.stages);
                for (axis, n) in [Vec3::X, -Vec3::X, Vec3::Y, -Vec3::Y, Vec3::Z].iter().enumerate() {
                    let picked: Vec<usize> =
                        (0..receivers.len()).filter(|&k| Vec3::from(receivers[k].normal).dot(*n) > 0.9).collect();
                    let sum = |v: &[Vec3]| {
                        picked.iter().map(|&k| v[k].element_sum()).sum::<f32>() / picked.len().max(1) as f32 / 3.0
                    };
                    println!(
                        "  normal {axis} {n}: {} pixels, got {:.3} truth {:.3}",
                        picked.len(),
                        sum(&result.irradiance),
                        sum(&one)
                    );
                }
            }
        }
    }
}
