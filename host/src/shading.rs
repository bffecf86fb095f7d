//! The passes that every picture shares: primary rays, direct light, and the final sum (`kernels::trace`).

use crate::exec::{BufferId, ExecError, Executor, ExecutorExt};
use crate::scene::Camera;
use crate::scene::device::SceneBuffers;
use glam::Vec3;
use interreflect_kernels::kernel::Kernel;
use interreflect_kernels::trace::{compose, direct, gbuffer};
use interreflect_shared::scene::Surfel;
use interreflect_shared::trace::{CountParams, DirectParams, GBufferParams};

/// Sampling of the direct light; see [`DirectParams`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DirectSettings {
    /// Shadow rays to each emissive triangle.
    pub light_samples: u32,
    /// Shadow rays to lights picked by their power, where there are many.
    pub picks: u32,
    /// Rays to the environment per receiver, where there is one.
    pub environment_samples: u32,
    /// Lights above which each receiver picks some by their power.
    pub pick_above: u32,
    /// Mixed into every random choice.
    pub seed: u32,
}

impl Default for DirectSettings {
    fn default() -> Self {
        Self { light_samples: 16, picks: 128, environment_samples: 64, pick_above: 64, seed: 0 }
    }
}

/// Camera and picture as `trace_gbuffer` takes them.
pub fn gbuffer_params(camera: &Camera, width: u32, height: u32, environment: Vec3) -> GBufferParams {
    let tangent = (0.5 * camera.fovy_rad).tan();
    let right = camera.forward.cross(camera.up) * (tangent * width as f32 / height as f32);
    GBufferParams {
        position: camera.position.extend(0.0),
        forward: camera.forward.extend(0.0),
        right: right.extend(0.0),
        up: (camera.up * tangent).extend(0.0),
        environment: environment.extend(0.0),
        width,
        height,
        _pad0: 0,
        _pad1: 0,
    }
}

/// The surface point that each pixel's centre sees: a new buffer of `width · height` [`Surfel`]s.
///
/// # Errors
/// What the executor says.
pub fn gbuffer(
    exec: &mut dyn Executor,
    scene: &SceneBuffers,
    camera: &Camera,
    width: u32,
    height: u32,
    environment: Vec3,
) -> Result<BufferId, ExecError> {
    let surfels = exec.zeroed_slice::<Surfel>("gbuffer", (width * height) as usize)?;
    let params = gbuffer_params(camera, width, height, environment);
    let [nodes, triangles, attributes, surfaces] = scene.trace_bindings();
    let reads = [nodes, triangles, attributes, surfaces, surfels];
    run_once(exec, &gbuffer::trace_gbuffer::KERNEL, &params, &reads)?;
    Ok(surfels)
}

/// Direct irradiance (W/m², `Vec4`, w = 0) at `count` surfels: a new buffer.
///
/// # Errors
/// What the executor says.
pub fn direct(
    exec: &mut dyn Executor,
    scene: &SceneBuffers,
    surfels: BufferId,
    count: u32,
    environment: Vec3,
    settings: &DirectSettings,
) -> Result<BufferId, ExecError> {
    let irradiance = exec.zeroed_slice::<glam::Vec4>("direct irradiance", count as usize)?;
    let lit_by_environment = environment.max_element() > 0.0;
    let params = DirectParams {
        environment: environment.extend(0.0),
        count,
        light_count: scene.light_count,
        light_samples: if scene.light_count > settings.pick_above { settings.picks } else { settings.light_samples },
        environment_samples: if lit_by_environment { settings.environment_samples } else { 0 },
        pick_above: settings.pick_above,
        seed: settings.seed,
        _pad0: 0,
        _pad1: 0,
    };
    let [nodes, triangles, attributes, surfaces] = scene.trace_bindings();
    let bindings = [nodes, triangles, attributes, surfaces, scene.lights, surfels, irradiance];
    run_once(exec, &direct::trace_direct::KERNEL, &params, &bindings)?;
    Ok(irradiance)
}

/// Radiance (W/(sr m²), `Vec4`, w = 1) of `count` surfels towards the camera: a new buffer.
///
/// # Errors
/// What the executor says.
pub fn compose(
    exec: &mut dyn Executor,
    surfels: BufferId,
    direct: BufferId,
    indirect: BufferId,
    count: u32,
) -> Result<BufferId, ExecError> {
    let radiance = exec.zeroed_slice::<glam::Vec4>("radiance", count as usize)?;
    let params = CountParams { count, _pad0: 0, _pad1: 0, _pad2: 0 };
    run_once(exec, &compose::trace_compose::KERNEL, &params, &[surfels, direct, indirect, radiance])?;
    Ok(radiance)
}

/// Runs a kernel with a uniform record that lives for this run only.
fn run_once<T: bytemuck::NoUninit>(
    exec: &mut dyn Executor,
    kernel: &'static Kernel,
    params: &T,
    rest: &[BufferId],
) -> Result<(), ExecError> {
    let uniform = exec.upload_one("parameters", params)?;
    let bindings: Vec<BufferId> = std::iter::once(uniform).chain(rest.iter().copied()).collect();
    let result = exec.run(kernel, &bindings);
    exec.free(uniform);
    result
}
