//! The truth: a path tracer that shares no kernel with what it judges.
//!
//! # What is computed
//! - [`render`]: radiance towards a camera, area-averaged over each pixel (box filter), split into `direct` (emitters
//!   and environment seen, and light that was reflected once) and `indirect` (all the rest).
//! - [`irradiance()`]: direct and indirect irradiance (W/m²) at given points: what lighting methods are judged by.
//!
//! Both are unbiased estimates by full paths ([`path`](self) module docs name the sources): next-event estimation and
//! cosine sampling joined by the power heuristic, Russian roulette, no clamping, sums in f64, and a variance for every
//! value. The same seed gives the same bits, whatever the number of threads.
//!
//! # What light meets
//! Lambert surfaces that reflect on both sides, shaded with the interpolated normal on the viewer's side: as in other
//! renderers a sampled direction may lie below the true surface and then starts on that side of it. Emissive triangles
//! emit radiance from their front (counter-clockwise) side. Textures are bilinear after the sRGB curve was undone, and
//! repeat; `Alpha::Mask` lets rays pass where the bilinear alpha is below the cut-off. Lights: glTF's point, spot and
//! directional lights, and an environment of constant radiance.
//!
//! # Noise
//! The noise of a result is the root mean square over pixels and channels of the standard error of `full`, divided by
//! the mean of `full` over pixels and channels ([`irradiance()`]: of `indirect`). A picture without light has noise 0.
//!
//! # Deviations
//! Single precision along a path (double only for sums): errors of about 10⁻⁶ per reflection. The environment is found
//! by cosine sampling alone: exact for its radiance, noisy where it is seen through small openings.

pub mod bench;
mod cache;
mod light;
mod path;
mod ray;
mod rounds;
mod sampler;
mod surface;
pub mod trace;
mod tree;
mod walk;

pub use cache::{Cached, CachedIrradiance, best_irradiance, best_picture, cached, cached_irradiance, default_dir};
pub use light::spot_falloff;

use crate::scene::{Camera, Light, Scene};
use glam::{DVec3, Vec3};
use interreflect_shared::scene::Surfel;
use multiversion::multiversion;
use path::{IRRADIANCE_PER_RADIANCE, Paths, Start};
use rounds::{BatchMean, MAX_SPP, Measure, Rounds};
use sampler::Sampler;
use std::path::PathBuf;
use surface::Vertex;
use trace::KeptTree;

/// Largest width and height of a picture.
pub const MAX_SIZE: u32 = 16_384;
/// Relative noise when neither noise nor samples were asked for.
pub const DEFAULT_NOISE: f64 = 0.01;

/// What can go wrong.
#[derive(Debug, thiserror::Error)]
pub enum ReferenceError {
    /// A setting is out of its range.
    #[error("reference setting `{key}` = {value} is not {expected}")]
    BadSetting {
        /// Name of the setting.
        key: &'static str,
        /// What was given.
        value: String,
        /// What is allowed.
        expected: String,
    },
    /// The scene is inconsistent.
    #[error("the scene cannot be traced: {what}")]
    BadScene {
        /// Where and why.
        what: String,
    },
    /// The acceleration structure is too deep for the traversal's stack.
    #[error("the scene's geometry is too degenerate: its tree takes a stack of {need} entries, more than {limit}")]
    TooDeep {
        /// Entries that a walk may need.
        need: usize,
        /// Entries that there are.
        limit: usize,
    },
    /// The cache cannot be written.
    #[error("cannot write the cache at {}: {source}", path.display())]
    Cache {
        /// Directory or file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

/// How long and how deep to trace.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ReferenceSettings {
    /// Relative noise at which to stop (see the module's docs); a lower value takes quadratically longer. `None`:
    /// [`DEFAULT_NOISE`], or no bound where `spp` is given.
    pub noise: Option<f64>,
    /// Samples per pixel or receiver, at least 2 (one sample has no variance); with `noise` too, whichever is reached
    /// first ends it.
    pub spp: Option<u32>,
    /// Seed of every random choice.
    pub seed: u32,
    /// Most reflections along a path; 0: emitters seen alone, 1: no indirect light, `None`: any number. For
    /// [`irradiance()`] the reflection at the receiver counts as the first.
    pub max_bounces: Option<u32>,
}

impl ReferenceSettings {
    fn spp_limit(&self) -> Result<u32, ReferenceError> {
        let bad = |key, value: String, expected: String| Err(ReferenceError::BadSetting { key, value, expected });
        if let Some(noise) = self.noise
            && !(noise > 0.0 && noise.is_finite())
        {
            return bad("noise", noise.to_string(), "a positive number".into());
        }
        match self.spp {
            Some(0) => bad("spp", "0".into(), format!("from 1 to {MAX_SPP}")),
            Some(spp) if spp > MAX_SPP => bad("spp", spp.to_string(), format!("from 1 to {MAX_SPP}")),
            spp => Ok(spp.unwrap_or(MAX_SPP).max(2)),
        }
    }

    fn noise_target(&self) -> Option<f64> {
        self.noise.or(if self.spp.is_none() { Some(DEFAULT_NOISE) } else { None })
    }
}

/// How far a computation is.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Progress {
    /// Part done, 0 to 1. It may fall back a little after a round of samples, when more is found to be needed.
    pub fraction: f64,
    /// Estimated time left (s); infinite before anything is known.
    pub remaining_s: f64,
    /// Samples per element in complete rounds.
    pub spp: u32,
    /// Relative noise of the complete rounds; infinite before the first.
    pub noise: f64,
}

/// A path-traced picture. Rows from the top, `width · height` values each, linear Rec. 709, W/(sr m²).
#[derive(Clone, PartialEq, Debug)]
pub struct Truth {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Emitters and environment seen, and light reflected once.
    pub direct: Vec<Vec3>,
    /// Light reflected twice or more often.
    pub indirect: Vec<Vec3>,
    /// Sum of the two.
    pub full: Vec<Vec3>,
    /// Variance of the mean of `full`.
    pub variance_full: Vec<Vec3>,
    /// Variance of the mean of `indirect`.
    pub variance_indirect: Vec<Vec3>,
    /// Samples per pixel.
    pub spp: u32,
    /// Relative noise reached (see the module's docs).
    pub noise: f64,
    /// Wall-clock time of rendering (ms).
    pub ms: f64,
    /// Rays traced, shadow rays included.
    pub rays: u64,
}

/// A point at which irradiance is wanted.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Receiver {
    /// Position (m).
    pub position: Vec3,
    /// Unit normal of the hemisphere from which light arrives. Zero: no surface, and zeros come back.
    pub normal: Vec3,
    /// Unit normal of the true surface, to leave it on the right side; equal to `normal` in free space.
    pub geometric_normal: Vec3,
}

impl Receiver {
    /// A receiver with no other surface than its own plane.
    pub fn new(position: Vec3, normal: Vec3) -> Self {
        Self { position, normal, geometric_normal: normal }
    }
}

impl From<&Surfel> for Receiver {
    fn from(s: &Surfel) -> Self {
        let normal =
            if s.triangle == interreflect_shared::scene::NO_SURFACE { Vec3::ZERO } else { Vec3::from(s.normal) };
        Self { position: s.position.into(), normal, geometric_normal: s.geometric_normal.into() }
    }
}

/// Irradiance at a [`Receiver`], W/m².
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Irradiance {
    /// Arriving after at least one reflection.
    pub indirect: Vec3,
    /// Arriving from emitters, lights and the environment.
    pub direct: Vec3,
    /// Variance of the mean `indirect`.
    pub variance: Vec3,
}

/// Irradiance at all receivers, with what it took.
#[derive(Clone, PartialEq, Debug)]
pub struct IrradianceTruth {
    /// One per receiver.
    pub values: Vec<Irradiance>,
    /// Samples per receiver.
    pub spp: u32,
    /// Relative noise of `indirect` reached.
    pub noise: f64,
    /// Wall-clock time (ms).
    pub ms: f64,
    /// Rays traced, shadow rays included.
    pub rays: u64,
}

/// Renders the truth of a camera's picture.
///
/// # Errors
/// [`ReferenceError::BadSetting`] for a size, noise or sample count out of range; what [`trace::Tracer::new`] returns.
pub fn render(
    scene: &Scene,
    camera: &Camera,
    width: u32,
    height: u32,
    settings: &ReferenceSettings,
    progress: &mut dyn FnMut(Progress),
) -> Result<Truth, ReferenceError> {
    render_by(&KeptTree::default(), scene, camera, (width, height), settings, progress)
}

/// The same with the scene's tree, which is built unless it is there.
fn render_by(
    tree: &KeptTree,
    scene: &Scene,
    camera: &Camera,
    (width, height): (u32, u32),
    settings: &ReferenceSettings,
    progress: &mut dyn FnMut(Progress),
) -> Result<Truth, ReferenceError> {
    for (key, size) in [("width", width), ("height", height)] {
        if !(1..=MAX_SIZE).contains(&size) {
            let expected = format!("from 1 to {MAX_SIZE}");
            return Err(ReferenceError::BadSetting { key, value: size.to_string(), expected });
        }
    }
    check_lights(scene)?;
    let paths = Paths::new(tree.tracer(scene)?, settings.max_bounces);
    let sample = |pixel: u32, batch: u32, count: u32| {
        let (x, y) = ((pixel % width) as f32, (pixel / width) as f32);
        batch_mean(&paths, settings.seed, pixel, batch, count, 1.0, &|sampler| {
            let [dx, dy] = sampler.pair(0);
            let (origin, direction) = camera.ray(x + dx, y + dy, width, height);
            Start::Ray(origin, direction)
        })
    };
    let rounds = rounds::run(width as usize * height as usize, settings, Measure::Full, sample, progress)?;
    Ok(Truth::collect(width, height, &rounds))
}

/// Computes direct and indirect irradiance at free receivers.
///
/// # Errors
/// As [`render`].
pub fn irradiance(
    scene: &Scene,
    receivers: &[Receiver],
    settings: &ReferenceSettings,
    progress: &mut dyn FnMut(Progress),
) -> Result<IrradianceTruth, ReferenceError> {
    irradiance_by(&KeptTree::default(), scene, receivers, settings, progress)
}

/// The same with the scene's tree, which is built unless it is there.
pub(crate) fn irradiance_by(
    tree: &KeptTree,
    scene: &Scene,
    receivers: &[Receiver],
    settings: &ReferenceSettings,
    progress: &mut dyn FnMut(Progress),
) -> Result<IrradianceTruth, ReferenceError> {
    check_lights(scene)?;
    let paths = Paths::new(tree.tracer(scene)?, settings.max_bounces);
    let (lo, hi) = scene.bounds();
    let extent = (hi - lo).max_element();
    let sample = |i: u32, batch: u32, count: u32| {
        let receiver = &receivers[i as usize];
        if receiver.normal == Vec3::ZERO {
            return BatchMean::default();
        }
        let vertex = receiver.vertex(extent);
        batch_mean(&paths, settings.seed, i, batch, count, IRRADIANCE_PER_RADIANCE, &|_| Start::Receiver(vertex))
    };
    let rounds = rounds::run(receivers.len(), settings, Measure::Indirect, sample, progress)?;
    let value = |i| {
        let (direct, indirect, _, variance) = rounds.result(i);
        Irradiance { indirect: indirect.as_vec3(), direct: direct.as_vec3(), variance: variance.as_vec3() }
    };
    let Rounds { spp, noise, rays, ms, .. } = rounds;
    Ok(IrradianceTruth { values: (0..rounds.len()).map(value).collect(), spp, noise, ms, rays })
}

impl Receiver {
    /// The receiver as a white surface. Its position is a ray's hit in f32, less exact than one between corners.
    fn vertex(&self, extent: f32) -> Vertex {
        const RELATIVE_ERROR: f32 = 4e-6;
        Vertex {
            position: self.position,
            offset: RELATIVE_ERROR * (self.position.abs().max_element() + extent),
            geometric_normal: self.geometric_normal,
            normal: self.normal,
            albedo: Vec3::ONE,
            triangle: trace::NO_TRIANGLE,
        }
    }
}

/// Mean of one batch of paths from an element. What is inlined here is compiled for AVX2 too: the same bits, as nothing is
/// contracted.
#[multiversion(targets("x86_64+avx2+fma+bmi1+bmi2+lzcnt"))]
fn batch_mean(
    paths: &Paths<'_>,
    seed: u32,
    element: u32,
    batch: u32,
    count: u32,
    scale: f32,
    start: &dyn Fn(&Sampler) -> Start,
) -> BatchMean {
    let mut mean = BatchMean::default();
    for i in 0..count {
        let sampler = Sampler::new(seed, element, batch, i, count);
        let light = paths.trace(start(&sampler), &sampler);
        mean.direct += light.direct.as_dvec3();
        mean.indirect += light.indirect.as_dvec3();
        mean.rays += u64::from(light.rays);
    }
    let scale = f64::from(scale) / f64::from(count);
    mean.direct *= scale;
    mean.indirect *= scale;
    mean
}

impl Truth {
    fn collect(width: u32, height: u32, rounds: &Rounds) -> Self {
        let each = |f: &dyn Fn((DVec3, DVec3, DVec3, DVec3)) -> DVec3| -> Vec<Vec3> {
            (0..rounds.len()).map(|i| f(rounds.result(i)).as_vec3()).collect()
        };
        let direct = each(&|r| r.0);
        let indirect = each(&|r| r.1);
        Self {
            width,
            height,
            full: direct.iter().zip(&indirect).map(|(d, i)| *d + *i).collect(),
            direct,
            indirect,
            variance_full: each(&|r| r.2),
            variance_indirect: each(&|r| r.3),
            spp: rounds.spp,
            noise: rounds.noise,
            ms: rounds.ms,
            rays: rounds.rays,
        }
    }
}

/// Lights and emission must be finite and not negative; an average over the picture would hide a single NaN.
fn check_lights(scene: &Scene) -> Result<(), ReferenceError> {
    let fine = |v: Vec3| v.is_finite() && v.min_element() >= 0.0;
    let bad = |what: String| Err(ReferenceError::BadScene { what });
    for (i, light) in scene.lights.iter().enumerate() {
        let (place, value) = match *light {
            Light::Point { position, intensity } => (position, intensity),
            Light::Spot { position, intensity, direction, .. } => (position + direction, intensity),
            Light::Directional { direction, irradiance } => (direction, irradiance),
        };
        if !place.is_finite() || !fine(value) {
            return bad(format!("light {i} is not finite or is negative: {light:?}"));
        }
    }
    for (i, m) in scene.materials.iter().enumerate() {
        if !fine(m.emission) || !fine(m.albedo) {
            return bad(format!("material {i} (`{}`) has a colour that is not finite or is negative", m.name));
        }
        if m.albedo.max_element() > 1.0 {
            return bad(format!("material {i} (`{}`) reflects more light than arrives: albedo {}", m.name, m.albedo));
        }
    }
    if !fine(scene.environment) {
        return bad(format!("the environment's radiance is not finite or is negative: {}", scene.environment));
    }
    Ok(())
}
