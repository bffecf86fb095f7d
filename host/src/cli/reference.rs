//! `reference`: the truth's picture and irradiance.

use super::args::ReferenceArgs;
use super::{print_json, setup};
use crate::error::Error;
use crate::evaluate::View;
use crate::exec::CpuExecutor;
use crate::image_io::{Image, ToneMap, write_exr, write_png, write_whole};
use crate::reference::{DEFAULT_NOISE, Receiver};
use crate::report;
use crate::scene::device::SceneBuffers;
use serde_json::json;

/// Traces the truth and writes `direct.exr`, `indirect.exr`, `full.exr`, `irradiance.exr`, `full.png`, `report.json`.
pub fn run(args: &ReferenceArgs, as_json: bool) -> Result<(), Error> {
    let out = &args.scene.out;
    let _folder = setup::output_folder(out)?;
    let (scene, camera) = setup::load(&args.scene)?;
    let settings = setup::truth_settings(&args.truth, args.scene.seed, DEFAULT_NOISE);
    let truths = setup::Truths::new(&args.scene, &scene, settings);
    let truth = truths.picture(&camera)?;
    // Irradiance belongs to surface points, not to pixel areas: the points that every method is judged at.
    let mut exec = CpuExecutor::new();
    let buffers = SceneBuffers::upload(&mut exec, &scene)?;
    let view = View::new(&mut exec, &scene, &buffers, &camera, args.scene.size, args.scene.seed)?;
    let receivers: Vec<Receiver> = view.surfels.iter().map(Receiver::from).collect();
    let irradiance = truths.irradiance(&receivers)?;

    let image = |pixels: &[glam::Vec3]| Image::new(truth.width, truth.height, pixels.to_vec());
    let full = image(&truth.full)?;
    let tone_map = ToneMap::from_truth(&full, &view.visible());
    write_exr(&out.join("direct.exr"), &image(&truth.direct)?)?;
    write_exr(&out.join("indirect.exr"), &image(&truth.indirect)?)?;
    write_exr(&out.join("full.exr"), &full)?;
    write_exr(&out.join("irradiance.exr"), &view.image(|k| irradiance.values[k].indirect))?;
    write_png(&out.join("full.png"), &tone_map.apply(&full))?;
    let report = json!({
        "scene": scene.name,
        "camera": report::Camera::new(&scene, &camera),
        "size": [truth.width, truth.height],
        "seed": args.scene.seed,
        "max_bounces": args.truth.max_bounces.map_or_else(|| json!("any"), |n| json!(n)),
        "picture": { "noise": truth.noise, "spp": truth.spp, "ms": truth.ms, "rays": truth.rays },
        "irradiance": { "noise": irradiance.noise, "spp": irradiance.spp, "ms": irradiance.ms, "rays": irradiance.rays },
        "tone_map": tone_map.describe(),
        "notes": scene.notes,
        "version": report::version(),
    });
    write_whole(&out.join("report.json"), report::to_json(&report)?.as_bytes())?;
    if as_json {
        print_json(&report);
    } else {
        say!(
            "{}: {}x{}, {} paths per pixel, noise {:.2} %, {:.1} s, {:.2} Mrays/s -> {}",
            scene.name,
            truth.width,
            truth.height,
            truth.spp,
            truth.noise * 100.0,
            truth.ms / 1e3,
            truth.rays as f64 / truth.ms / 1e3,
            out.display()
        );
    }
    Ok(())
}
