//! `chart`: speed against accuracy.

use super::args::ChartArgs;
use super::progress::TruthBar;
use super::{print_json, setup};
use crate::chart::{self, ChartReport, News, Options, Row, trial::Runner};
use crate::error::Error;
use crate::methods::{METHODS, MethodRow, method};
use crate::reference;
use crate::report::{bytes, milliseconds, number};
use std::time::Duration;

/// Noise of a chart's truth where the user names none: as in `compare`.
const TRUTH_NOISE: f64 = 0.1;
/// Milliseconds after which a phase stops repeating.
const REPEAT_BUDGET_MS: f64 = 6_000.0;

/// Makes the charts and writes them after each scene.
pub fn run(args: &ChartArgs, threads: Option<u16>, as_json: bool) -> Result<(), Error> {
    let scenes = args.scenes.specs().map_err(Error::Usage)?;
    let methods = methods(&args.methods)?;
    // A wrong name is noticed before anything is traced.
    for spec in &scenes {
        spec.load()?;
    }
    let out = &args.scenes.out;
    let _folder = setup::output_folder(out)?;
    let options = Options {
        scenes,
        methods,
        size: args.scenes.size.into(),
        truth: setup::truth_settings(&args.truth, args.scenes.seed, TRUTH_NOISE),
        cache: args.scenes.cache.clone().unwrap_or_else(reference::default_dir),
        backend: args.device.backend.key().into(),
        adapter: args.device.adapter.clone(),
        threads,
        budget: args.budget_minutes.map(|m| Duration::from_secs_f64(60.0 * m)),
        rung_limit: Duration::from_secs_f64(args.rung_timeout),
        repeats: args.repeats,
        repeat_budget_ms: REPEAT_BUDGET_MS,
        runner: Runner { program: setup::program()?, folder: out.join("trials"), retry: args.retry },
    };
    let mut bar = None;
    let mut news = |news: News<'_>| match news {
        News::Scene(name) => tell!("{name}"),
        News::Truth(progress) => bar.get_or_insert_with(|| TruthBar::new("truth")).update(progress),
        News::Row(row) => {
            bar = None;
            tell!("  {}", line(row));
        }
    };
    let report = chart::run(&options, &mut news, &mut |report, charted| chart::write(out, report, charted))?;
    if as_json {
        print_json(&report);
    } else {
        print(&report);
        say!("{}", out.join("index.html").display());
    }
    Ok(())
}

/// The methods of a list, or all.
pub fn methods(list: &str) -> Result<Vec<&'static MethodRow>, Error> {
    if list.trim() == "all" {
        return Ok(METHODS.iter().collect());
    }
    Ok(list.split(',').map(|name| method(name.trim())).collect::<Result<_, _>>()?)
}

/// A row as a line of text.
fn line(row: &Row) -> String {
    let name = format!("{:<34}", row.title());
    let Some(result) = &row.result else {
        return format!("{name} {}: {}", row.status.words(), row.reason.as_deref().unwrap_or("no reason"));
    };
    let error = row.error().map_or_else(|| "-".into(), number);
    let mark = match (row.under_noise, row.pareto) {
        (true, _) => "  within the noise",
        (_, true) => "  on the front",
        _ => "",
    };
    let paths = row.path_tracing_ms.map_or_else(String::new, |ms| format!(", path tracing {}", milliseconds(ms)));
    format!(
        "{name} error {error:>7}, precompute {:>9}, light {:>9}, frame {:>9}, {:>9}{paths}{mark}",
        milliseconds(result.time_ms.precompute),
        milliseconds(result.time_ms.light_change),
        milliseconds(result.time_ms.frame),
        bytes(result.memory_bytes.total)
    )
}

fn print(report: &ChartReport) {
    for scene in &report.scenes {
        say!("{}: block NRMSE against the time of a frame with moving lights", scene.scene);
        for row in &scene.rows {
            say!("  {}", line(row));
        }
        if let Some(floor) = scene.truth.noise_floor {
            say!("  the truth's own noise: {} ({} spp)", number(floor.nrmse_block), scene.truth.spp);
        }
    }
}
