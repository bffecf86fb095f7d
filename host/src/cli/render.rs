//! `render`: one method, its pictures and its report.

use super::args::RenderArgs;
use super::{print_json, setup};
use crate::error::Error;
use crate::evaluate::{self, Repeats, View};
use crate::exec::Executor;
use crate::fit::SettingsFile;
use crate::image_io::{ToneMap, read_exr};
use crate::methods::{Input, MethodRow, Settings, method};
use crate::metrics::{self, ErrorMetrics};
use crate::reference::{self, Receiver};
use crate::report::{self, Frame, RenderReport};
use crate::scene::device::SceneBuffers;
use crate::scene::{Camera, Scene};

/// Lights the scene and writes `direct.exr`, `indirect.exr`, `full.exr`, `irradiance.exr`, `full.png`, `report.json`.
pub fn run(args: &RenderArgs, as_json: bool) -> Result<(), Error> {
    let (row, settings) = chosen(args)?;
    if args.frames > 1 || !args.animate.is_empty() {
        return super::animate::run(args, row, &settings, as_json);
    }
    let out = &args.scene.out;
    let _folder = setup::output_folder(out)?;
    let (scene, camera) = setup::load(&args.scene)?;
    let mut exec = setup::executor(&args.device)?;
    let exec: &mut dyn Executor = exec.as_mut();
    let buffers = SceneBuffers::upload(exec, &scene)?;
    let view = View::new(exec, &scene, &buffers, &camera, args.scene.size, args.scene.seed)?;
    let input = Input { scene: &scene, buffers: &buffers, seed: args.scene.seed, true_mean: None };
    let run = evaluate::run(exec, &input, row, &settings, view.gbuffer, view.surfels.len(), Repeats::MEDIAN)?;

    let frame = view.frame(&run.irradiance);
    let (error, truth) = match &args.truth {
        Some(path) => (Some(error_against(path, &view, &frame)?), None),
        None => error_at_hand(args, &scene, &camera, &view, &frame)?,
    };
    let tone_map = report::tone_map(&frame, &view.visible());
    let device = exec.device();
    let report = RenderReport {
        scene: scene.name.clone(),
        camera: report::Camera::new(&scene, &camera),
        size: [view.width, view.height],
        device: (&device).into(),
        result: evaluate::describe(row, &settings, &run, &device, error),
        truth,
        notes: scene.notes.clone(),
        tone_map: tone_map.describe(),
        peak_memory_bytes: evaluate::peak_memory_bytes(),
        version: report::version(),
    };
    report::write_render(out, &report, &frame, &tone_map)?;
    if as_json {
        print_json(&report);
    } else {
        let times = &report.result.time_ms;
        say!(
            "{} by {} on {} ({}): precompute {:.1} ms, light change {:.1} ms, frame {:.1} ms -> {}",
            report.scene,
            row.name,
            device.adapter,
            device.backend,
            times.precompute,
            times.light_change,
            times.frame,
            out.display()
        );
        if let Some(error) = &report.result.error {
            say!(
                "nrmse {:.4}, on blocks {:.4}, bias {:.4}, p95 {:.4}",
                error.nrmse,
                error.nrmse_block,
                error.bias,
                error.p95
            );
        }
    }
    Ok(())
}

/// The method and its settings, checked before anything is loaded.
fn chosen(args: &RenderArgs) -> Result<(&'static MethodRow, Settings), Error> {
    let changes = args.set.iter().map(|text| key_value(text)).collect::<Result<Vec<_>, _>>()?;
    let file = args.settings.as_deref().map(SettingsFile::read).transpose()?;
    let name = file.as_ref().map(|f| f.method.as_str()).or(args.method.as_deref()).unwrap_or_default();
    let row = method(name)?;
    let fitted = file.iter().flat_map(|f| f.settings.iter().map(|(k, v)| (k.as_str(), v.as_str())));
    let settings = row.with(fitted.chain(changes))?;
    (row.new)(&settings)?;
    Ok((row, settings))
}

/// Splits `key=value`.
pub fn key_value(text: &str) -> Result<(&str, &str), Error> {
    text.split_once('=')
        .filter(|(key, _)| !key.trim().is_empty())
        .map(|(key, value)| (key.trim(), value.trim()))
        .ok_or_else(|| Error::Usage(format!("--set `{text}`: not of the form key=value")))
}

/// Error against the truth that an earlier run left in the cache, if one did, and how good that is.
fn error_at_hand(
    args: &RenderArgs,
    scene: &Scene,
    camera: &Camera,
    view: &View,
    frame: &Frame,
) -> Result<(Option<ErrorMetrics>, Option<report::Truth>), Error> {
    let folder = setup::cache_folder(&args.scene);
    let receivers: Vec<Receiver> = view.surfels.iter().map(Receiver::from).collect();
    let Some(truth) = reference::best_irradiance(&folder, scene, &receivers) else { return Ok((None, None)) };
    let visible = view.visible();
    let irradiance = view.image(|k| truth.values[k].indirect);
    // A black truth has no relative error.
    let Ok(mut error) = metrics::compare_irradiance(&irradiance, &frame.irradiance, &visible) else {
        return Ok((None, None));
    };
    if let Some(picture) = reference::best_picture(&folder, scene, camera, args.scene.size) {
        let picture = view.image(|k| picture.full[k]);
        let tone_map = ToneMap::from_truth(&picture, &visible);
        error.flip = Some(report::flip_error(&picture, &frame.full, &tone_map)?);
    }
    let variance = view.image(|k| truth.values[k].variance);
    let noise_floor = metrics::noise_floor(&irradiance, &variance, &visible).ok();
    Ok((Some(error), Some(report::Truth { noise: truth.noise, spp: u64::from(truth.spp), ms: truth.ms, noise_floor })))
}

/// Error of the irradiance against a truth's file; FLIP needs the truth's picture, `full.exr` beside it.
fn error_against(path: &std::path::Path, view: &View, frame: &Frame) -> Result<ErrorMetrics, Error> {
    let mut error = metrics::compare_irradiance(&read_exr(path)?, &frame.irradiance, &view.visible())?;
    let picture = path.with_file_name("full.exr");
    if picture.is_file() {
        let truth = read_exr(&picture)?;
        let tone_map = ToneMap::from_truth(&truth, &view.visible());
        error.flip = Some(report::flip_error(&truth, &frame.full, &tone_map)?);
    }
    Ok(error)
}
