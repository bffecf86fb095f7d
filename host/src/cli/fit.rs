//! `fit`: no more than the scene needs.

use super::args::FitArgs;
use super::{print_json, setup};
use crate::error::Error;
use crate::fit::{self, Care, Evidence, FitReport, Goal, Left, Limits, Live, Verdict, evaluate_scene};
use crate::image_io::write_whole;
use crate::methods::{MethodRow, method};
use crate::reference;
use crate::report::{self, bytes, milliseconds, number};

/// Finds settings for a scene and writes `settings.json`, `fit.json` and `index.html`; or judges the search itself.
pub fn run(args: &FitArgs, as_json: bool) -> Result<(), Error> {
    let scenes = args.scenes.specs().map_err(Error::Usage)?;
    let methods = candidates(&args.methods)?;
    let goal = Goal {
        error: args.error,
        ms: args.ms,
        memory_bytes: args.memory.map(|mib| (mib * 1048576.0) as u64),
        precompute_ms: args.precompute_ms,
        still: args.still,
    };
    if !args.evaluate && goal == (Goal { still: args.still, precompute_ms: args.precompute_ms, ..Goal::default() }) {
        return Err(Error::Usage("fit needs a limit: --error E, --ms T or --memory M".into()));
    }
    if args.budget_minutes.is_some() && !args.evaluate {
        return Err(Error::Usage("--budget-minutes bounds --evaluate: a search ends by itself".into()));
    }
    let out = &args.scenes.out;
    if args.evaluate {
        let _folder = setup::output_folder(out)?;
        return evaluate(args, &scenes, &methods, as_json);
    }
    let [spec] = scenes.as_slice() else {
        return Err(Error::Usage("fit takes one scene; several only with --evaluate".into()));
    };
    let cache = args.scenes.cache.clone().unwrap_or_else(reference::default_dir);
    let exec = setup::executor(&args.device)?;
    let mut evidence = Evidence::new(Live::new(spec, args.scenes.size.into(), args.scenes.seed, cache, exec)?);
    let _folder = setup::output_folder(out)?;
    let mut news = |c: &fit::Candidate| {
        let (name, took) = (fit::changed_settings(c.row, &c.settings), milliseconds(1e3 * c.wall_s));
        tell!("  {name}: error {}, {} (asked in {took})", number(c.error), milliseconds(goal.cost(c)));
    };
    let mut report = fit::fit(
        &mut evidence,
        &spec.scene,
        &methods,
        goal,
        Care { explain: true, thorough: args.thorough },
        &mut news,
    )?;
    report.view = spec.arguments();
    write_whole(&out.join("fit.json"), report::to_json(&report)?.as_bytes())?;
    let pictures = match report.choice.as_ref().map(|c| (method(&c.method), c)) {
        Some((Ok(row), choice)) => Some(evidence.source.pictures(row, &choice.settings)?),
        _ => None,
    };
    let device = (&evidence.source.exec.device()).into();
    let page = fit::page(&report, args.scenes.size.into(), &device, pictures.as_ref());
    write_whole(&out.join("index.html"), page.as_bytes())?;
    if let (Some(choice), true) = (&report.choice, report.found) {
        write_whole(&out.join("settings.json"), report::to_json(choice)?.as_bytes())?;
    }
    if as_json {
        print_json(&report);
    } else {
        print(&report, args);
    }
    match report.found {
        true => Ok(()),
        false => Err(Error::NothingFits(report.choice.map_or_else(
            || "no method gave an answer".into(),
            |c| format!("{} comes closest: error {}, {}", c.method, number(c.error), milliseconds(c.ms[0])),
        ))),
    }
}

/// The methods of a list; of all, the candidates.
fn candidates(list: &str) -> Result<Vec<&'static MethodRow>, Error> {
    let mut methods = super::chart::methods(list)?;
    if list.trim() == "all" {
        methods.retain(|m| !m.control);
    }
    Ok(methods)
}

fn print(report: &FitReport, args: &FitArgs) {
    if report.dark {
        say!("{}: {}", report.scene, fit::NOTHING_NEEDED);
    }
    if let Some(c) = &report.choice {
        let settings: Vec<String> = c.settings.iter().map(|(k, v)| format!("{k}={v}")).collect();
        let [low, high] = report.error_bounds;
        if report.found && report.goal.error.is_some_and(|limit| high > limit) {
            say!("{}: nothing is sure to keep the limit; this is likeliest to", report.scene);
        }
        say!("{}: {} {}", report.scene, c.method, settings.join(" "));
        say!(
            "  error {} ({} to {}, from {} blocks), {} with moving lights, {} with still ones, {}",
            number(c.error),
            number(low),
            number(high),
            report.blocks,
            milliseconds(c.ms[0]),
            milliseconds(c.ms[1]),
            bytes(c.memory_bytes)
        );
    }
    for reason in &report.why {
        say!("  {}", reason.words);
    }
    for line in &report.spared {
        say!("  {line}");
    }
    for other in &report.rejected {
        say!("  not {}: {}", other.method, other.reason);
    }
    say!(
        "  {} trials in {:.1} s (truth {:.1} s), and {:.1} s for the neighbours; shared precomputation spared {:.1} s",
        report.trials,
        report.search_s,
        report.truth_s,
        report.why_s,
        report.shared_s
    );
    if report.found {
        say!("{}", args.scenes.out.join("settings.json").display());
    }
    say!("{}", args.scenes.out.join("index.html").display());
}

/// The search beside an exhaustive sweep.
fn evaluate(
    args: &FitArgs,
    scenes: &[crate::chart::trial::SceneSpec],
    methods: &[&'static MethodRow],
    as_json: bool,
) -> Result<(), Error> {
    /// Noise of the sweep's truth: as in `compare`.
    const TRUTH_NOISE: f64 = 0.1;
    let truth = setup::truth_settings(&args.truth, args.scenes.seed, TRUTH_NOISE);
    let folder = args.scenes.cache.clone().unwrap_or_else(reference::default_dir);
    let seconds = args.budget_minutes.map(|m| 60.0 * m);
    let limits = Limits {
        goal: Goal { ms: args.ms, precompute_ms: args.precompute_ms, ..Goal::default() },
        sweep_s: seconds,
        truth_s: seconds,
    };
    let open = || setup::executor(&args.device);
    let (mut cases, mut left_out) = (Vec::new(), Vec::new());
    for spec in scenes {
        let mut news = |line: &str| tell!("{line}");
        let size = args.scenes.size.into();
        match evaluate_scene(spec, size, truth, limits, &folder, &open, methods, &mut news) {
            Ok(found) if found.is_empty() => {
                let reason = "there is no indirect light, or nothing that was swept is better than no indirect light"
                    .to_string();
                left_out.push(Left { scene: spec.scene.clone(), reason });
            }
            Ok(found) => cases.extend(found),
            // One scene that fails is a row that says so; a scene that does not exist is a mistake.
            Err(error) if error.exit_code() == 2 => return Err(error),
            Err(error) => left_out.push(Left { scene: spec.scene.clone(), reason: error.to_string() }),
        }
        // After each scene: what is known is not lost with the next.
        let verdict = Verdict::of(cases.clone(), left_out.clone());
        write_whole(&args.scenes.out.join("evaluate.json"), report::to_json(&verdict)?.as_bytes())?;
    }
    let verdict = Verdict::of(cases, left_out);
    if as_json {
        print_json(&verdict);
        return Ok(());
    }
    for case in &verdict.cases {
        say!("{case}");
    }
    for left in &verdict.left_out {
        say!("{}: no cases: {}", left.scene, left.reason);
    }
    say!(
        "{} cases: {:.0} % within the limit (90 % wanted), {:.0} % at no more than 1.3 times the best cost, {:.0} % in no more \
         than a fifth of the sweep's time: {}",
        verdict.cases.len(),
        100.0 * verdict.within,
        100.0 * verdict.cheap,
        100.0 * verdict.quick,
        if verdict.passed { "passed" } else { "not passed" }
    );
    Ok(())
}
