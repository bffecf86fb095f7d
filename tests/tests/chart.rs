//! `chart`: every rung is a row whatever becomes of it, numbers agree across files, an earlier run is gone on with.

use interreflect::chart::trial::{Job, Outcome, Runner, SceneSpec, Status};
use interreflect::methods::METHODS;
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};
use std::time::Duration;

const PROGRAM: &str = env!("CARGO_BIN_EXE_interreflect-under-test");

fn chart(out: &Path, more: &[&str]) -> Output {
    let cache = out.join("cache");
    let mut command = Command::new(PROGRAM);
    command.args(["chart", "cornell-box", "--size", "24x24", "--backend", "cpu", "--repeats", "1", "--json"]);
    command.arg("--cache").arg(cache).arg("--out").arg(out).args(more);
    command.output().expect("the program starts")
}

fn json(output: &Output) -> Value {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("no JSON: {e}\n{said}"))
}

fn rows(report: &Value) -> &Vec<Value> {
    report["scenes"][0]["rows"].as_array().expect("rows")
}

fn block_error(row: &Value) -> f64 {
    row["result"]["error"]["nrmse_block"].as_f64().expect("an error")
}

#[test]
fn every_rung_of_every_method_is_a_measured_row_and_an_earlier_run_is_gone_on_with() {
    let out = tempfile::tempdir().expect("a folder");
    let first = json(&chart(out.path(), &["--spp", "256"]));
    let expected: usize = METHODS.iter().map(|m| m.ladder.len()).sum();
    assert_eq!(rows(&first).len(), expected);
    for row in rows(&first) {
        assert_eq!(row["status"], "done", "{row}");
        let result = &row["result"];
        let time = result["time_ms"]["light_change"].as_f64().unwrap() + result["time_ms"]["frame"].as_f64().unwrap();
        assert!(time > 0.0 && row["peak_memory_bytes"].as_u64().unwrap() > 1 << 20, "{row}");
        // Whatever a method decides by itself it says.
        let needs = result["needs"].as_object().map_or(0, serde_json::Map::len);
        assert!(row["control"] == true || needs >= 3, "{row}");
        let [low, high] = [0, 1].map(|k| result["time_ms"]["spread"]["frame"][k].as_f64().unwrap());
        let median = result["time_ms"]["frame"].as_f64().unwrap();
        assert!(low <= median && median <= high, "{low} {median} {high}");
        // Path tracing's time for this error, from the two numbers that the report gives.
        let p = &first["scenes"][0]["path_tracing"];
        let (ms, one) = (p["ms_per_sample"].as_f64().unwrap(), p["error_of_one_sample"].as_f64().unwrap());
        let expected = ms * (one / block_error(row)).powi(2);
        assert!((row["path_tracing_ms"].as_f64().unwrap() / expected - 1.0).abs() < 1e-9);
    }
    fronts_hold_what_nothing_beats(&first);
    path_tracing_lies_on_its_line(&first);
    files_agree(out.path(), &first);

    let again = json(&chart(out.path(), &["--spp", "256"]));
    for (a, b) in rows(&first).iter().zip(rows(&again)) {
        assert_eq!(b["earlier_run"], true);
        assert_eq!(a["result"], b["result"]);
    }
    // Another seed is another chart.
    let other = json(&chart(out.path(), &["--spp", "64", "--seed", "2", "--methods", "direct"]));
    assert_eq!(rows(&other)[0]["earlier_run"], false);
}

fn fronts_hold_what_nothing_beats(report: &Value) {
    let time = |r: &Value| {
        let t = &r["result"]["time_ms"];
        t["light_change"].as_f64().unwrap() + t["frame"].as_f64().unwrap()
    };
    let ranked: Vec<&Value> =
        rows(report).iter().filter(|r| r["control"] == false && r["under_noise"] == false).collect();
    assert!(ranked.iter().any(|r| r["pareto"] == true));
    for row in &ranked {
        let beaten = ranked.iter().any(|o| time(o) < time(row) && block_error(o) <= block_error(row));
        assert_eq!(row["pareto"].as_bool().unwrap(), !beaten, "{row}");
    }
    assert!(rows(report).iter().all(|r| r["control"] == false || r["pareto"] == false));
}

/// The path tracer as a control has the error that the line promises: the truth's noise floor is right.
fn path_tracing_lies_on_its_line(report: &Value) {
    let one = report["scenes"][0]["path_tracing"]["error_of_one_sample"].as_f64().unwrap();
    let mut checked = 0;
    for row in rows(report).iter().filter(|r| r["settings"]["spp"].is_string() && r["under_noise"] == false) {
        let spp: f64 = row["settings"]["spp"].as_str().unwrap().parse().unwrap();
        let promised = one / spp.sqrt();
        let ratio = block_error(row) / promised;
        assert!((0.6..1.8).contains(&ratio), "{spp} spp: error {}, promised {promised}", block_error(row));
        checked += 1;
    }
    assert!(checked >= 2, "{checked}");
}

fn files_agree(out: &Path, report: &Value) {
    let read = |name: &str| std::fs::read_to_string(out.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
    let written: Value = serde_json::from_str(&read("chart.json")).unwrap();
    assert_eq!(written["scenes"], report["scenes"]);
    let csv = read("chart.csv");
    assert_eq!(csv.lines().count(), rows(report).len() + 1);
    let columns = csv.lines().next().unwrap().split(',').count();
    for (line, row) in csv.lines().skip(1).zip(rows(report)) {
        assert!(
            line.contains(row["method"].as_str().unwrap()) && line.contains(&block_error(row).to_string()),
            "{line}"
        );
        assert!(line.split(',').count() >= columns);
    }
    for name in ["chart", "memory"] {
        let svg = read(&format!("{name}.svg"));
        assert!(svg.contains("<svg") && !svg.contains("NaN"), "{name}.svg");
        let png = image::open(out.join(format!("{name}.png"))).expect("a picture").to_rgb8();
        let inked = png.pixels().filter(|p| p.0.iter().any(|c| *c < 200)).count();
        assert!(png.width() >= 1900 && inked > 3000, "{name}.png: {} pixels drawn", inked);
    }
    let page = read("index.html");
    let pictures = page.matches("data:image/png;base64,").count();
    assert!(pictures >= 3 * rows(report).len() + 2, "{pictures} pictures");
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http"), "the page is self-contained");
}

#[test]
fn a_rung_that_takes_too_long_is_a_row_and_gets_another_chance_with_more_time() {
    let out = tempfile::tempdir().expect("a folder");
    let common = ["--spp", "16", "--methods", "ambient"];
    let short = json(&chart(out.path(), &[&common[..], &["--rung-timeout", "0.001"]].concat()));
    let row = &rows(&short)[0];
    assert_eq!(row["status"], "timed_out");
    assert!(row["reason"].as_str().unwrap().contains("0.0 s") && row["result"].is_null(), "{row}");
    let page = std::fs::read_to_string(out.path().join("index.html")).unwrap();
    assert!(page.contains("timed out"), "the page says so");
    let long = json(&chart(out.path(), &common));
    assert_eq!(rows(&long)[0]["status"], "done");
}

#[test]
fn a_budget_leaves_rungs_out_and_says_so() {
    let out = tempfile::tempdir().expect("a folder");
    let report = json(&chart(out.path(), &["--noise", "0.01", "--budget-minutes", "0.02"]));
    let left: Vec<&Value> = rows(&report).iter().filter(|r| r["status"] == "left_out").collect();
    assert!(!left.is_empty(), "{report}");
    for row in &left {
        let reason = row["reason"].as_str().unwrap();
        assert!(reason.contains("budget"), "{reason}");
    }
    // The truth gave way too: a noise of 1 % was asked for.
    assert!(report["scenes"][0]["truth"]["noise"].as_f64().unwrap() > 0.012, "{}", report["scenes"][0]["truth"]);
    assert!(report["spent_s"].as_f64().unwrap() < 15.0, "{}", report["spent_s"]);
}

fn job(settings: &[(&str, &str)], method: &str) -> Job {
    let row = interreflect::methods::method(method).unwrap();
    Job {
        scene: SceneSpec { scene: "cornell-box".into(), ..SceneSpec::default() },
        scene_hash: String::new(),
        size: [8, 8],
        seed: 1,
        method: method.into(),
        settings: row.with(settings.iter().copied()).unwrap(),
        backend: "cpu".into(),
        adapter: None,
        threads: None,
        true_mean: None,
        repeats: 1,
        repeat_budget_ms: 0.0,
        machine: String::new(),
    }
}

#[cfg(unix)]
#[test]
fn a_crash_ends_its_row_and_nothing_else() {
    use std::os::unix::fs::PermissionsExt;
    let out = tempfile::tempdir().expect("a folder");
    let script = out.path().join("crashes.sh");
    std::fs::write(&script, "#!/bin/sh\necho \"out of luck\" >&2\nkill -SEGV $$\n").unwrap();
    std::fs::set_permissions(&script, std::fs::Permissions::from_mode(0o755)).unwrap();
    let broken = Runner { program: script, folder: out.path().join("trials"), retry: false };
    let job = job(&[], "direct");
    let limit = Duration::from_secs(20);
    let Outcome::Bad(end) = broken.run(&job, limit).unwrap().outcome else { panic!("it crashes") };
    assert_eq!(end.status, Status::Crashed);
    assert!(end.reason.contains("signal") && end.reason.contains("out of luck"), "{}", end.reason);
    // The row stays as it is until a retry is asked for.
    let mended = Runner { program: PROGRAM.into(), ..broken };
    let kept = mended.run(&job, limit).unwrap();
    assert!(kept.earlier && matches!(kept.outcome, Outcome::Bad(_)));
    let retried = Runner { retry: true, ..mended }.run(&job, limit).unwrap();
    assert!(!retried.earlier && matches!(retried.outcome, Outcome::Done { .. }));
}

#[test]
fn a_method_that_refuses_is_a_failed_row_with_its_words() {
    let out = tempfile::tempdir().expect("a folder");
    let runner = Runner { program: PROGRAM.into(), folder: out.path().into(), retry: false };
    let job = job(&[("resolution", "512"), ("memory_limit_mb", "1")], "vct");
    let Outcome::Bad(end) = runner.run(&job, Duration::from_secs(60)).unwrap().outcome else { panic!("it refuses") };
    assert_eq!(end.status, Status::Failed);
    assert!(end.reason.contains("1048576"), "{}", end.reason);
}

#[test]
fn wrong_use_says_what_is_right() {
    let out = tempfile::tempdir().expect("a folder");
    let folder = out.path().join("new");
    for (args, named) in [
        (&["chart", "cornel-box"][..], "cornell-box"),
        (&["chart", "cornell-box", "--methods", "drect"], "direct"),
        (&["chart", "cornell-box?lens=3"], "lens=3"),
        (&["chart", "cornell-box", "--budget-minutes", "0"], "minutes"),
        (&["chart"], "SCENES"),
    ] {
        let output = Command::new(PROGRAM).args(args).arg("--out").arg(&folder).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        assert!(said.contains(named), "{args:?}: {said}");
        assert!(!folder.exists(), "{args:?} left a folder");
    }
}
