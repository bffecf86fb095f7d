//! The truth of one view, and what a method's picture is worth beside it.

use super::trial::{SceneSpec, scene_hash};
use crate::error::Error;
use crate::evaluate::View;
use crate::exec::CpuExecutor;
use crate::image_io::{Image, ToneMap, write_whole};
use crate::metrics::{self, BLOCK_PX, ErrorMetrics, MetricsError, NoiseFloor};
use crate::reference::trace::KeptTree;
use crate::reference::{self, Progress, Receiver, ReferenceSettings};
use crate::report::{self, Frame};
use crate::scene::device::SceneBuffers;
use crate::scene::{Camera, Scene};
use glam::{Vec3, Vec4};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// Samples of the trial run that tells what a truth will take; also the measure of path tracing's speed.
const PILOT_SPP: u32 = 8;
/// Fewest samples per pixel of a truth, however short the time.
const LEAST_SPP: u32 = 16;

/// How exact a truth must be, and what it may take.
#[derive(Clone, Debug)]
pub struct TruthPlan {
    /// Noise, samples, seed, bounces.
    pub settings: ReferenceSettings,
    /// Seconds that it may take; a truth that would take longer gets fewer samples. `None`: any.
    pub limit_s: Option<f64>,
    /// Folder of truths of earlier runs.
    pub cache: PathBuf,
    /// Folder in which the number of samples is kept that a limit led to, so that a resumed run asks for the same truth.
    pub notes: PathBuf,
}

/// What plain path tracing costs for an error: the error falls with the square root of the time.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub struct PathTracing {
    /// Time of one sample per pixel (ms), measured in this run.
    pub ms_per_sample: f64,
    /// Expected block NRMSE of one sample per pixel.
    pub error_of_one_sample: f64,
}

impl PathTracing {
    /// Time for an error (ms).
    pub fn ms_for(&self, error: f64) -> f64 {
        self.ms_per_sample * (self.error_of_one_sample / error).powi(2)
    }

    /// Error after one millisecond, if a fraction of a sample were possible.
    pub fn error_at_one_ms(&self) -> f64 {
        self.error_of_one_sample * self.ms_per_sample.sqrt()
    }
}

/// The truth of a view.
pub struct Judge {
    /// Scene.
    pub scene: Scene,
    /// Its content's hash.
    pub scene_hash: String,
    /// Camera.
    pub camera: Camera,
    /// Visible points and direct light.
    pub view: View,
    /// Which pixels show a surface.
    pub visible: Vec<bool>,
    /// Pictures.
    pub truth: Frame,
    /// What is said of the truth in reports.
    pub about: report::Truth,
    /// Tone map of full pictures.
    pub tone_map: ToneMap,
    /// Cost of plain path tracing; absent where the truth is black.
    pub path_tracing: Option<PathTracing>,
    /// Mean of the true indirect irradiance (W/m²).
    pub mean: Vec3,
}

impl Judge {
    /// Loads a scene and finds its truth.
    ///
    /// # Errors
    /// What loading and path tracing say.
    pub fn new(
        spec: &SceneSpec,
        size: [u32; 2],
        plan: &TruthPlan,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Self, Error> {
        let (scene, camera) = spec.load()?;
        let scene_hash = scene_hash(&scene);
        let mut exec = CpuExecutor::new();
        let buffers = SceneBuffers::upload(&mut exec, &scene)?;
        let seed = plan.settings.seed;
        let view = View::new(&mut exec, &scene, &buffers, &camera, size.into(), seed)?;
        let visible = view.visible();
        let receivers: Vec<Receiver> = view.surfels.iter().map(Receiver::from).collect();

        let pilot = ReferenceSettings { spp: Some(PILOT_SPP), noise: None, ..plan.settings };
        let tree = KeptTree::default();
        let pilot = reference::irradiance_by(&tree, &scene, &receivers, &pilot, &mut |_| {})?;
        let ms_per_sample = pilot.ms / f64::from(pilot.spp.max(1));
        let note = format!("{}-{}x{}-{seed}", &scene_hash[..16], size[0], size[1]);
        let settings = plan.affordable(ms_per_sample, pilot.noise, &note)?;
        let irradiance =
            reference::cached_irradiance(&plan.cache, &tree, &scene, &receivers, &settings, progress)?.truth;
        let picture = reference::cached(&plan.cache, &tree, &scene, &camera, size.into(), &settings, progress)?.truth;

        let image = |pixels: &[Vec3]| Image::new(size[0], size[1], pixels.to_vec());
        let truth = Frame {
            direct: image(&picture.direct)?,
            indirect: image(&picture.indirect)?,
            full: image(&picture.full)?,
            irradiance: view.image(|k| irradiance.values[k].indirect),
        };
        let variance = view.image(|k| irradiance.values[k].variance);
        let noise_floor = metrics::noise_floor(&truth.irradiance, &variance, &visible).ok();
        let spp = irradiance.spp;
        let path_tracing = noise_floor
            .filter(|f| f.nrmse_block > 0.0)
            .map(|floor| PathTracing { ms_per_sample, error_of_one_sample: floor.nrmse_block * f64::from(spp).sqrt() });
        let about = report::Truth { noise: irradiance.noise, spp: u64::from(spp), ms: irradiance.ms, noise_floor };
        let tone_map = report::tone_map(&truth, &visible);
        let seen = irradiance.values.iter().zip(&visible).filter(|(_, visible)| **visible).map(|(v, _)| v.indirect);
        let mean = seen.sum::<Vec3>() / visible.iter().filter(|v| **v).count().max(1) as f32;
        Ok(Self { scene, scene_hash, camera, view, visible, truth, about, tone_map, path_tracing, mean })
    }

    /// Error of a picture of indirect irradiance; `None` where the truth is black or nothing is seen.
    ///
    /// # Errors
    /// Pictures that do not fit.
    pub fn error(&self, irradiance: &Image) -> Result<Option<ErrorMetrics>, Error> {
        match metrics::compare_irradiance(&self.truth.irradiance, irradiance, &self.visible) {
            Ok(mut error) => {
                error.flip = Some(report::flip_error(&self.truth.full, &self.frame(irradiance).full, &self.tone_map)?);
                Ok(Some(error))
            }
            Err(MetricsError::ZeroTruth | MetricsError::NoVisiblePoint) => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    /// The pictures that an indirect irradiance makes.
    pub fn frame(&self, irradiance: &Image) -> Frame {
        let values: Vec<Vec4> = irradiance.pixels().iter().map(|p| p.extend(0.0)).collect();
        self.view.frame(&values)
    }

    /// Block NRMSE below which a picture cannot be told from a perfect one: two standard deviations above what the
    /// truth's noise gives a perfect method (a mean square over `n` values has a relative deviation of √(2/n)).
    pub fn rankable_above(&self) -> f64 {
        self.about.noise_floor.map_or(0.0, |floor| self.noise_bound(floor))
    }

    fn noise_bound(&self, floor: NoiseFloor) -> f64 {
        let blocks = f64::from(self.view.width.div_ceil(BLOCK_PX)) * f64::from(self.view.height.div_ceil(BLOCK_PX));
        floor.nrmse_block * (1.0 + 2.0 * (2.0 / (3.0 * blocks)).sqrt()).sqrt()
    }
}

impl TruthPlan {
    /// The settings, with fewer samples where they would take longer than the limit. Irradiance and picture both take
    /// about the same time.
    fn affordable(&self, ms_per_sample: f64, pilot_noise: f64, note: &str) -> Result<ReferenceSettings, Error> {
        let Some(limit_s) = self.limit_s else { return Ok(self.settings) };
        let path = self.notes.join(format!("truth-{note}.json"));
        if let Some(kept) = kept_spp(&path) {
            return Ok(ReferenceSettings { spp: Some(kept), noise: None, ..self.settings });
        }
        let wanted = match (self.settings.spp, self.settings.noise) {
            (Some(spp), _) => f64::from(spp),
            (None, noise) => {
                let ratio = pilot_noise / noise.unwrap_or(reference::DEFAULT_NOISE);
                (f64::from(PILOT_SPP) * ratio * ratio).ceil()
            }
        };
        let affordable = limit_s * 1e3 / (2.0 * ms_per_sample.max(1e-6));
        if wanted <= affordable {
            return Ok(self.settings);
        }
        let spp = (1_u32 << (affordable.max(1.0).log2() as u32).min(20)).max(LEAST_SPP);
        std::fs::create_dir_all(&self.notes)
            .map_err(|source| Error::OutputFolder { path: self.notes.clone(), source })?;
        write_whole(&path, format!("{{\"spp\": {spp}}}\n").as_bytes())?;
        Ok(ReferenceSettings { spp: Some(spp), noise: None, ..self.settings })
    }
}

fn kept_spp(path: &Path) -> Option<u32> {
    let value: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).ok()?).ok()?;
    value["spp"].as_u64()?.try_into().ok()
}
