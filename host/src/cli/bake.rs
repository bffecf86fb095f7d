//! `bake`: precomputes a method's data for a scene into a file.

use super::args::BakeArgs;
use super::progress::BakeBar;
use super::render::key_value;
use super::{print_json, setup};
use crate::error::Error;
use crate::image_io::write_png;
use crate::methods::{MethodError, method, srp};
use std::path::Path;

/// Bakes, or goes on with a bake that was interrupted.
pub fn run(args: &BakeArgs, as_json: bool) -> Result<(), Error> {
    let row = method(&args.method)?;
    let changes = args.set.iter().map(|text| key_value(text)).collect::<Result<Vec<_>, _>>()?;
    let settings = row.with(changes)?;
    (row.new)(&settings)?;
    if row.name != srp::NAME {
        return Err(Error::Usage(format!("method `{}` has nothing to bake; `{}` has", row.name, srp::NAME)));
    }
    let (scene, _) = setup::load(&args.scene)?;
    let options = srp::BakeOptions { seed: args.scene.seed, ..srp::bake_options(&settings)? };
    if args.error_map.is_some() && options.rows != 1 {
        return Err(Error::Usage("`--error-map` is for bakes of irradiance: set `rows=1`".into()));
    }
    let (journal, found) = srp::file::Journal::open(&args.output, &scene, &options).map_err(MethodError::from)?;
    if !found.is_empty() && !as_json {
        say!("going on: {} clusters are done", found.len());
    }
    let started = std::time::Instant::now();
    let plan = srp::Plan::new(&scene, &options)?;
    let plan_s = started.elapsed().as_secs_f64();
    let bar = BakeBar::new(plan.clusters.len());
    let keep = |index, output: &_| journal.add(index, output);
    let (bake, lookup) = plan.resume(found, &keep, &|done| bar.update(done)).map_err(MethodError::from)?;
    drop(bar);
    srp::file::save(&args.output, &bake, lookup.atlas(), &scene).map_err(MethodError::from)?;
    journal.remove().map_err(MethodError::from)?;
    let seconds = started.elapsed().as_secs_f64();
    let mut report = plan.report(&bake);
    if let Some(path) = &args.error_map {
        report["error_map_mean"] = write_error_map(path, &plan, &bake)?.into();
    }
    report["plan_s"] = plan_s.into();
    report["seconds"] = seconds.into();
    report["peak_memory_bytes"] = crate::evaluate::peak_memory_bytes().into();
    report["file_bytes"] = std::fs::metadata(&args.output).map_or(0, |m| m.len()).into();
    if as_json {
        report["cluster_list"] = srp::plan::cluster_report(&bake);
        print_json(&report);
        return Ok(());
    }
    say!("{}: {} by {}", args.output.display(), scene.name, row.name);
    for (key, value) in report.as_object().into_iter().flatten() {
        say!("  {key}: {value}");
    }
    Ok(())
}

/// Directions per probe by which the error map sees the surroundings.
const ERROR_MAP_RAYS: u32 = 128;

/// Writes the map, and gives its mean.
fn write_error_map(path: &Path, plan: &srp::Plan<'_>, bake: &srp::SrpBake) -> Result<f64, Error> {
    let receivers: Vec<u32> = (0..bake.receivers.len() as u32).collect();
    let map = srp::error_map::error_map(&plan.world, bake, &receivers, ERROR_MAP_RAYS);
    write_png(path, &srp::error_map::picture(bake, &receivers, &map))?;
    Ok(map.iter().map(|e| f64::from(*e)).sum::<f64>() / map.len().max(1) as f64)
}
