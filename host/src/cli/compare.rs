//! `compare`: every method against one truth, in one run on one machine.

use super::args::CompareArgs;
use super::render::key_value;
use super::{print_json, setup};
use crate::error::Error;
use crate::evaluate::{self, Repeats, View};
use crate::exec::Executor;
use crate::image_io::{Image, ToneMap};
use crate::methods::{Input, METHODS, MethodRow, Settings, method};
use crate::metrics::{self, MetricsError};
use crate::reference::{IrradianceTruth, Receiver};
use crate::report::{self, Comparison, Frame, MethodResult, Pictures};
use crate::scene::device::SceneBuffers;
use glam::Vec3;

/// Noise of a comparison's truth where the user names none: a tenth in a pixel is a hundredth in a block of 8×8, well
/// under the error of the methods; the noise floor is printed beside them.
const TRUTH_NOISE: f64 = 0.1;
/// Paths per pixel at which that truth ends all the same: scenes whose light comes through a chink would take hours.
const MOST_PATHS: u32 = 4096;

/// Compares methods and writes the comparison's folder.
pub fn run(args: &CompareArgs, as_json: bool) -> Result<(), Error> {
    let chosen = chosen(args)?;
    let out = &args.scene.out;
    let _folder = setup::output_folder(out)?;
    let (scene, camera) = setup::load(&args.scene)?;
    let mut exec = setup::executor(&args.device)?;
    let exec: &mut dyn Executor = exec.as_mut();
    let device = exec.device();
    let buffers = SceneBuffers::upload(exec, &scene)?;
    let view = View::new(exec, &scene, &buffers, &camera, args.scene.size, args.scene.seed)?;
    let visible = view.visible();

    let mut settings = setup::truth_settings(&args.truth, args.scene.seed, TRUTH_NOISE);
    let asked = settings.spp.is_some() || args.truth.noise.is_some();
    if !asked {
        settings.spp = Some(MOST_PATHS);
    }
    let truths = setup::Truths::new(&args.scene, &scene, settings);
    let picture = truths.picture(&camera)?;
    let receivers: Vec<Receiver> = view.surfels.iter().map(Receiver::from).collect();
    let irradiance = truths.irradiance(&receivers)?;
    if !asked && irradiance.noise > TRUTH_NOISE {
        let noise = 100.0 * irradiance.noise;
        tell!("note: the truth ends at {MOST_PATHS} paths per pixel, with {noise:.0} % of noise: `--noise` goes on");
    }
    let image = |pixels: &[Vec3]| Image::new(view.width, view.height, pixels.to_vec());
    let truth = Frame {
        direct: image(&picture.direct)?,
        indirect: image(&picture.indirect)?,
        full: image(&picture.full)?,
        irradiance: view.image(|k| irradiance.values[k].indirect),
    };
    let tone_map = report::tone_map(&truth, &visible);

    let input = Input {
        scene: &scene,
        buffers: &buffers,
        seed: args.scene.seed,
        true_mean: Some(mean_irradiance(&irradiance, &visible)),
    };
    let (mut results, mut frames) = (Vec::new(), Vec::new());
    for (row, settings) in &chosen {
        let run = evaluate::run(exec, &input, row, settings, view.gbuffer, visible.len(), Repeats::MEDIAN)?;
        let frame = view.frame(&run.irradiance);
        let mut result = evaluate::describe(row, settings, &run, &device, None);
        judge(&mut result, &frame, &truth, &visible, &tone_map)?;
        results.push(result);
        frames.push(frame);
    }
    let variance = view.image(|k| irradiance.values[k].variance);
    let comparison = Comparison {
        scene: scene.name.clone(),
        camera: report::Camera::new(&scene, &camera),
        size: [view.width, view.height],
        truth: report::Truth {
            noise: irradiance.noise,
            spp: u64::from(irradiance.spp),
            ms: irradiance.ms,
            noise_floor: metrics::noise_floor(&truth.irradiance, &variance, &visible).ok(),
        },
        device: (&device).into(),
        results,
        notes: scene.notes.clone(),
        tone_map: tone_map.describe(),
        peak_memory_bytes: evaluate::peak_memory_bytes(),
        version: report::version(),
    };
    report::write_comparison(out, &comparison, &Pictures { truth, results: frames, visible })?;
    if as_json {
        print_json(&comparison);
    } else {
        say!("{}", report::Table(&comparison).to_string().trim_end());
        say!("{}", out.join("index.html").display());
    }
    Ok(())
}

/// The methods with their settings, checked before anything is loaded.
fn chosen(args: &CompareArgs) -> Result<Vec<(&'static MethodRow, Settings)>, Error> {
    let rows: Vec<&'static MethodRow> = if args.methods.trim() == "all" {
        METHODS.iter().collect()
    } else {
        args.methods.split(',').map(|name| method(name.trim())).collect::<Result<_, _>>()?
    };
    let mut changes = Vec::new();
    for text in &args.set {
        let (target, value) = key_value(text)?;
        let (name, key) = target
            .split_once('.')
            .ok_or_else(|| Error::Usage(format!("--set `{text}`: not of the form method.key=value")))?;
        let row = method(name)?;
        if !rows.iter().any(|r| r.name == row.name) {
            return Err(Error::Usage(format!("--set `{text}`: method `{name}` is not among those compared")));
        }
        changes.push((row.name, key, value));
    }
    rows.into_iter()
        .map(|row| {
            let own = changes.iter().filter(|(name, ..)| *name == row.name).map(|(_, key, value)| (*key, *value));
            let settings = row.with(own)?;
            (row.new)(&settings)?;
            Ok((row, settings))
        })
        .collect()
}

/// Adds a result's error; a black truth has none, and neither has a view of nothing.
fn judge(
    result: &mut MethodResult,
    frame: &Frame,
    truth: &Frame,
    visible: &[bool],
    tone_map: &ToneMap,
) -> Result<(), Error> {
    match metrics::compare_irradiance(&truth.irradiance, &frame.irradiance, visible) {
        Ok(mut error) => {
            error.flip = Some(report::flip_error(&truth.full, &frame.full, tone_map)?);
            result.error = Some(error);
            Ok(())
        }
        Err(error @ (MetricsError::ZeroTruth | MetricsError::NoVisiblePoint)) => {
            tell!("note: {}: no error can be given: {error}", result.method);
            Ok(())
        }
        Err(error) => Err(error.into()),
    }
}

fn mean_irradiance(truth: &IrradianceTruth, visible: &[bool]) -> Vec3 {
    let seen = truth.values.iter().zip(visible).filter(|(_, visible)| **visible).map(|(value, _)| value.indirect);
    let (sum, count) = seen.fold((Vec3::ZERO, 0_u32), |(sum, count), e| (sum + e, count + 1));
    sum / count.max(1) as f32
}
