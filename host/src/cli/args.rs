//! The command line's grammar.

use crate::chart::trial::SceneSpec;
use crate::exec::Backend;
use clap::{Args, Parser, Subcommand};
use glam::Vec3;
use std::path::PathBuf;

/// Global illumination, measured against path-traced truth.
#[derive(Parser, Debug)]
#[command(name = "interreflect", version, about, max_term_width = 100)]
pub struct Cli {
    /// Print the result as JSON on standard output, and nothing else there.
    #[arg(long, global = true)]
    pub json: bool,
    /// Worker threads of the CPU (default: one per core).
    #[arg(long, global = true, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
}

/// The verbs.
#[derive(Subcommand, Debug)]
pub enum Verb {
    /// Light a scene by several methods and measure each against the truth: pictures, errors, times, a page.
    Compare(CompareArgs),
    /// Light a scene by one method.
    Render(RenderArgs),
    /// Path-trace a scene: the truth.
    Reference(ReferenceArgs),
    /// Precompute a method's data for a scene into a file; goes on where it was interrupted.
    Bake(BakeArgs),
    /// Speed against accuracy: every method's ladder of settings on several scenes, charts, tables, a page.
    Chart(ChartArgs),
    /// Where methods fail: leaks, flicker, energy, feedback, ringing, thin geometry, scale, lights; safe ranges.
    Stress(StressArgs),
    /// The cheapest method and settings for an error, or the most accurate ones for a time or a memory.
    Fit(FitArgs),
    /// List the methods with their settings.
    Methods,
    /// List the built-in scenes.
    Scenes,
    /// List the adapters that kernels can run on.
    Devices,
    /// Do the job of a trial's folder (what `chart` starts for each rung).
    #[command(hide = true)]
    Trial {
        /// Folder with `job.json`.
        folder: PathBuf,
    },
}

/// What picture of what scene.
#[derive(Args, Debug, Clone)]
pub struct SceneArgs {
    /// Built-in name (see `scenes`) or path of a .glb, .gltf or .obj file.
    #[arg(default_value = "cornell-box")]
    pub scene: String,
    /// Name of a camera of the scene, or `px,py,pz,tx,ty,tz,fovy_deg`. Default: the first.
    #[arg(long, allow_hyphen_values = true)]
    pub camera: Option<String>,
    /// Width and height of the picture in pixels.
    #[arg(long, value_name = "WxH", default_value = "256x256", value_parser = size)]
    pub size: (u32, u32),
    /// Radiance of a constant environment, W/(sr m²) (default: the scene's own, usually none).
    #[arg(long, value_name = "R,G,B", value_parser = colour, allow_hyphen_values = true)]
    pub env: Option<Vec3>,
    /// Parallel light added to the scene: direction of travel and perpendicular irradiance (W/m²).
    #[arg(long, value_name = "DX,DY,DZ,R,G,B", value_parser = sun, allow_hyphen_values = true)]
    pub sun: Option<(Vec3, Vec3)>,
    /// Seed of every random number.
    #[arg(long, default_value_t = 1)]
    pub seed: u32,
    /// Folder for what the command writes.
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub out: PathBuf,
    /// Folder that truths are kept in between runs (default: the user's cache folder).
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Several scenes with one view each.
#[derive(Args, Debug, Clone)]
pub struct ScenesArgs {
    /// Built-in names or paths. A scene may carry its own view and light:
    /// `sponza.glb?camera=-11.5,1.7,-0.4,0,2.6,0,60&sun=0.12,-1,0.3,30,28.5,26&env=1.2,1.5,2`.
    #[arg(required = true)]
    pub scenes: Vec<String>,
    /// Camera of scenes that carry none: a name, or `px,py,pz,tx,ty,tz,fovy_deg`.
    #[arg(long, allow_hyphen_values = true)]
    pub camera: Option<String>,
    /// Radiance of a constant environment of scenes that carry none, W/(sr m²).
    #[arg(long, value_name = "R,G,B", value_parser = colour, allow_hyphen_values = true)]
    pub env: Option<Vec3>,
    /// Parallel light added to scenes that carry none: direction of travel and perpendicular irradiance (W/m²).
    #[arg(long, value_name = "DX,DY,DZ,R,G,B", value_parser = sun, allow_hyphen_values = true)]
    pub sun: Option<(Vec3, Vec3)>,
    /// Width and height of the pictures in pixels.
    #[arg(long, value_name = "WxH", default_value = "256x256", value_parser = size)]
    pub size: (u32, u32),
    /// Seed of every random number.
    #[arg(long, default_value_t = 1)]
    pub seed: u32,
    /// Folder for what the command writes.
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub out: PathBuf,
    /// Folder that truths are kept in between runs (default: the user's cache folder).
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

impl ScenesArgs {
    /// The scenes with their views.
    ///
    /// # Errors
    /// A part after `?` that is not `camera=…`, `sun=…` or `env=…`, in words.
    pub fn specs(&self) -> Result<Vec<SceneSpec>, String> {
        self.scenes.iter().map(|text| self.spec(text)).collect()
    }

    fn spec(&self, text: &str) -> Result<SceneSpec, String> {
        let pair = |(a, b): (Vec3, Vec3)| (a.to_array(), b.to_array());
        let mut spec = SceneSpec {
            scene: text.to_string(),
            camera: self.camera.clone(),
            env: self.env.map(|e| e.to_array()),
            sun: self.sun.map(pair),
        };
        // A file may have a question mark in its name.
        let Some((scene, view)) = text.split_once('?').filter(|_| !std::path::Path::new(text).exists()) else {
            return Ok(spec);
        };
        spec.scene = scene.to_string();
        for part in view.split('&').filter(|part| !part.is_empty()) {
            match part.split_once('=') {
                Some(("camera", value)) => spec.camera = Some(value.to_string()),
                Some(("env", value)) => spec.env = Some(colour(value)?.to_array()),
                Some(("sun", value)) => spec.sun = Some(pair(sun(value)?)),
                _ => return Err(format!("`{part}` of `{text}` is not camera=…, sun=… or env=…")),
            }
        }
        Ok(spec)
    }
}

/// Arguments of `chart`.
#[derive(Args, Debug)]
pub struct ChartArgs {
    #[command(flatten)]
    pub scenes: ScenesArgs,
    #[command(flatten)]
    pub device: DeviceArgs,
    #[command(flatten)]
    pub truth: TruthArgs,
    /// Methods, separated by commas, or `all`.
    #[arg(long, default_value = "all")]
    pub methods: String,
    /// Minutes for everything: a coarser truth and fewer rungs where that is too little, and what was left out is said.
    #[arg(long, value_name = "M", value_parser = minutes)]
    pub budget_minutes: Option<f64>,
    /// Seconds after which a single rung is ended, and its row says so.
    #[arg(long, value_name = "S", default_value = "900", value_parser = seconds)]
    pub rung_timeout: f64,
    /// Counted runs of each phase after a warm-up; their median, fastest and slowest are reported.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub repeats: u32,
    /// Run rungs again that failed, crashed or timed out in an earlier run in the same folder.
    #[arg(long)]
    pub retry: bool,
}

/// Arguments of `stress`.
#[derive(Args, Debug)]
pub struct StressArgs {
    #[command(flatten)]
    pub device: DeviceArgs,
    /// Methods, separated by commas, or `all` (which leaves the controls out).
    #[arg(long, default_value = "all")]
    pub methods: String,
    /// Families, separated by commas, or `all`.
    #[arg(long, default_value = "all")]
    pub families: String,
    /// Rung of each method's ladder, from 0, cheapest first: ranges are in the method's own unit, so a cheap one will do.
    #[arg(long, default_value_t = 1)]
    pub rung: usize,
    /// Only the ends and the middle of every range, without the bisection between them.
    #[arg(long)]
    pub quick: bool,
    /// Seed of every random number.
    #[arg(long, default_value_t = 1)]
    pub seed: u32,
    /// Folder for what the command writes.
    #[arg(long, value_name = "DIR", default_value = "out")]
    pub out: PathBuf,
    /// Folder that truths are kept in between runs (default: the user's cache folder).
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Arguments of `fit`.
#[derive(Args, Debug)]
pub struct FitArgs {
    #[command(flatten)]
    pub scenes: ScenesArgs,
    #[command(flatten)]
    pub device: DeviceArgs,
    #[command(flatten)]
    pub truth: TruthArgs,
    /// Largest error (block NRMSE of indirect light). Without it: the smallest error within the other limits.
    #[arg(long, value_name = "E", value_parser = error_limit)]
    pub error: Option<f64>,
    /// Longest frame in milliseconds.
    #[arg(long, value_name = "T", value_parser = milliseconds)]
    pub ms: Option<f64>,
    /// Largest memory of the method's buffers, MiB.
    #[arg(long, value_name = "MIB", value_parser = mebibytes)]
    pub memory: Option<f64>,
    /// Longest precomputation in milliseconds, once per geometry.
    #[arg(long, value_name = "T", value_parser = milliseconds)]
    pub precompute_ms: Option<f64>,
    /// Lights stand still: a frame does not pay for a change of light.
    #[arg(long)]
    pub still: bool,
    /// Methods, separated by commas, or `all` (which leaves the controls out).
    #[arg(long, default_value = "all")]
    pub methods: String,
    /// Judge the search instead: on every scene its choices for five errors, at parts of those of an exhaustive sweep, beside
    /// the sweep's best; with `--ms` and `--precompute-ms`, of what takes no longer.
    #[arg(long, conflicts_with_all = ["error", "memory", "still"])]
    pub evaluate: bool,
    /// With `--evaluate`: minutes for each scene's truth and for its sweep; what there was no time for is said.
    #[arg(long, value_name = "M", value_parser = minutes)]
    pub budget_minutes: Option<f64>,
    /// Goes on as long as there is something to try. Otherwise a search ends after a seventh of the time that trying everything
    /// would take, once something fits.
    #[arg(long)]
    pub thorough: bool,
}

/// Where kernels run.
#[derive(Args, Debug, Clone)]
pub struct DeviceArgs {
    /// `auto`: a hardware GPU where there is one, otherwise the CPU. `gpu` also takes a software Vulkan driver.
    #[arg(long, default_value = "auto", value_parser = backend)]
    pub backend: Backend,
    /// Any part of the name of the adapter to use (see `devices`), hardware or not.
    #[arg(long, value_name = "NAME")]
    pub adapter: Option<String>,
}

/// How exact a truth must be.
#[derive(Args, Debug, Clone)]
pub struct TruthArgs {
    /// Noise at which the truth stops: standard error of the picture relative to its mean.
    #[arg(long, value_parser = noise)]
    pub noise: Option<f64>,
    /// Paths per pixel, instead of a noise level.
    #[arg(long, conflicts_with = "noise", value_parser = clap::value_parser!(u32).range(1..=1_048_576))]
    pub spp: Option<u32>,
    /// Reflections that a path may have: 0 sees emitters only, 1 adds direct light, 2 one indirect bounce.
    #[arg(long)]
    pub max_bounces: Option<u32>,
}

/// Arguments of `compare`.
#[derive(Args, Debug)]
pub struct CompareArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub device: DeviceArgs,
    #[command(flatten)]
    pub truth: TruthArgs,
    /// Methods, separated by commas, or `all`.
    #[arg(long, default_value = "all")]
    pub methods: String,
    /// A setting of a method: `method.key=value`.
    #[arg(long = "set", value_name = "METHOD.KEY=VALUE")]
    pub set: Vec<String>,
}

/// Arguments of `render`.
#[derive(Args, Debug)]
pub struct RenderArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub device: DeviceArgs,
    /// Method (see `methods`).
    #[arg(long, required_unless_present = "settings")]
    pub method: Option<String>,
    /// File with a method and its settings, as `fit` writes it; `--set` changes single ones.
    #[arg(long, value_name = "FILE", conflicts_with = "method")]
    pub settings: Option<PathBuf>,
    /// A setting of the method: `key=value`.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// The truth's `irradiance.exr` (from `reference` with the same scene, camera and size): the report then has errors.
    #[arg(long, value_name = "FILE.exr")]
    pub truth: Option<PathBuf>,
    /// Frames of an animation: writes frame-0000.png … and frames.json with each frame's times.
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=10_000), conflicts_with = "truth")]
    pub frames: u32,
    /// What moves from the first frame to the last, on a straight line (m): `light:INDEX:DX,DY,DZ` (a directional light's
    /// direction changes by the offset) or `object:MATERIAL:DX,DY,DZ`.
    #[arg(long, value_name = "WHAT:DX,DY,DZ", allow_hyphen_values = true)]
    pub animate: Vec<super::animate::Motion>,
}

/// Arguments of `bake`.
#[derive(Args, Debug)]
pub struct BakeArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Method whose data is baked.
    #[arg(long, default_value = "srp")]
    pub method: String,
    /// A setting of the method: `key=value`.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Also writes a picture of the lightmap that shows where the probes do not suffice, whatever the light (PNG): black
    /// where they do, bright where as much is lost as without any.
    #[arg(long, value_name = "FILE")]
    pub error_map: Option<PathBuf>,
    /// File to write (safetensors); `--set file=FILE` uses it. While it is made, finished parts are kept in `FILE.part`.
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
}

/// Arguments of `reference`.
#[derive(Args, Debug)]
pub struct ReferenceArgs {
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub truth: TruthArgs,
}

/// Largest side of a picture in pixels.
pub const MAX_SIDE_PX: u32 = 16_384;

fn size(text: &str) -> Result<(u32, u32), String> {
    let parsed =
        text.split_once(['x', 'X', '×']).and_then(|(w, h)| Some((w.trim().parse().ok()?, h.trim().parse().ok()?)));
    match parsed {
        Some((w, h)) if (1..=MAX_SIDE_PX).contains(&w) && (1..=MAX_SIDE_PX).contains(&h) => Ok((w, h)),
        Some((w, h)) => Err(format!("{w}x{h}: each side must be from 1 to {MAX_SIDE_PX} pixels")),
        None => Err(format!("`{text}` is not WIDTHxHEIGHT")),
    }
}

fn numbers<const N: usize>(text: &str) -> Result<[f32; N], String> {
    let parsed: Vec<f32> = text
        .split(',')
        .map(|part| part.trim().parse::<f32>().ok().filter(|x| x.is_finite()))
        .collect::<Option<_>>()
        .ok_or_else(|| format!("`{text}` is not {N} finite numbers separated by commas"))?;
    parsed.try_into().map_err(|got: Vec<f32>| format!("`{text}` has {} numbers, not {N}", got.len()))
}

fn colour(text: &str) -> Result<Vec3, String> {
    let [r, g, b] = numbers::<3>(text)?;
    if r < 0.0 || g < 0.0 || b < 0.0 {
        Err(format!("`{text}`: radiance is not negative"))
    } else {
        Ok(Vec3::new(r, g, b))
    }
}

fn sun(text: &str) -> Result<(Vec3, Vec3), String> {
    let [x, y, z, r, g, b] = numbers::<6>(text)?;
    let direction = Vec3::new(x, y, z).try_normalize().ok_or_else(|| format!("`{text}`: the direction is zero"))?;
    if r < 0.0 || g < 0.0 || b < 0.0 {
        return Err(format!("`{text}`: irradiance is not negative"));
    }
    Ok((direction, Vec3::new(r, g, b)))
}

fn minutes(text: &str) -> Result<f64, String> {
    positive(text, 1e5).ok_or_else(|| format!("`{text}` is not a number of minutes above 0"))
}

fn seconds(text: &str) -> Result<f64, String> {
    positive(text, 1e7).ok_or_else(|| format!("`{text}` is not a number of seconds above 0"))
}

fn milliseconds(text: &str) -> Result<f64, String> {
    positive(text, 1e9).ok_or_else(|| format!("`{text}` is not a number of milliseconds above 0"))
}

fn mebibytes(text: &str) -> Result<f64, String> {
    positive(text, 1e9).ok_or_else(|| format!("`{text}` is not a number of MiB above 0"))
}

fn error_limit(text: &str) -> Result<f64, String> {
    positive(text, 1e3).ok_or_else(|| format!("`{text}` is not an error above 0 (0.1 is 10 %)"))
}

fn positive(text: &str, most: f64) -> Option<f64> {
    text.parse().ok().filter(|x: &f64| *x > 0.0 && *x <= most)
}

fn noise(text: &str) -> Result<f64, String> {
    text.parse()
        .ok()
        .filter(|x: &f64| *x >= 1e-4 && *x < 10.0)
        .ok_or_else(|| format!("`{text}` is not a number from 0.0001 to 10"))
}

fn backend(text: &str) -> Result<Backend, String> {
    text.parse().map_err(|error: crate::exec::ExecError| error.to_string())
}
