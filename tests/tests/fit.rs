//! `fit`: its choice keeps the limits, its file is a render's settings, its reasons are measurements.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};

fn run(args: &[&str], out: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_interreflect-under-test"))
        .args(args)
        .args(if args[0] == "reference" { &[][..] } else { &["--backend", "cpu"] })
        .args(["--size", "64x64", "--json", "--cache"])
        .arg(out.join("cache"))
        .arg("--out")
        .arg(out)
        .output()
        .expect("the program starts")
}

fn json(output: &Output) -> Value {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("no JSON: {e}\n{said}"))
}

#[test]
fn the_choice_keeps_the_error_and_renders_from_its_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path();
    let report = json(&run(&["fit", "cornell-box", "--error", "0.25"], out));
    assert_eq!(report["found"], true);
    let choice = &report["choice"];
    let error = choice["error"].as_f64().unwrap();
    assert!(error <= 0.25, "{error}");

    // Every parameter has a reason, made of what its neighbours were measured to do.
    let why = report["why"].as_array().unwrap();
    assert!(why.len() >= 3, "{why:#?}");
    for reason in why {
        let sides: Vec<&Value> = ["below", "above"].map(|k| &reason[k]).into_iter().filter(|n| !n.is_null()).collect();
        assert!(!sides.is_empty(), "{reason:#}");
        let words = reason["words"].as_str().unwrap();
        assert!(words.starts_with(reason["key"].as_str().unwrap()), "{words}");
        for side in sides {
            assert!(words.contains(side["value"].as_str().unwrap()), "{words}");
            assert!(side["error"].is_null() == side["ms"].is_null(), "{reason:#}");
        }
    }

    // The file is what `render` takes, and the picture's error is what was promised.
    let truth = out.join("truth");
    json(&run(&["reference", "cornell-box", "--spp", "1024"], &truth));
    let file = out.join("settings.json");
    let (file, picture) = (file.to_str().unwrap(), truth.join("irradiance.exr"));
    let args = ["render", "cornell-box", "--settings", file, "--truth", picture.to_str().unwrap()];
    let render = json(&run(&args, &out.join("render")));
    assert_eq!(render["method"], choice["method"]);
    let measured = render["error"]["nrmse_block"].as_f64().unwrap();
    let [low, high] = [0, 1].map(|k| report["error_bounds"][k].as_f64().unwrap());
    assert!(low * 0.85 <= measured && measured <= high * 1.15, "promised {low} to {high}, measured {measured}");
    for (key, value) in choice["settings"].as_object().unwrap() {
        let used = &render["settings"][key];
        let used = used.as_str().map_or_else(|| used.to_string(), String::from);
        assert_eq!(used, value.as_str().unwrap(), "{key}");
    }
}

#[test]
fn a_smaller_error_takes_more() {
    let folder = tempfile::tempdir().expect("a folder");
    // One method, because what is quicker among several need not be smaller.
    let fit = |error| json(&run(&["fit", "cornell-box", "--methods", "vct", "--error", error], folder.path()));
    let (cheap, dear) = (fit("0.6"), fit("0.15"));
    // Memory does not depend on what else the machine does.
    let number = |r: &Value, key: &str| r["choice"][key].as_f64().unwrap();
    assert!(number(&cheap, "memory_bytes") <= number(&dear, "memory_bytes"), "{cheap:#} {dear:#}");
    assert!(number(&cheap, "error") <= 0.6 && number(&dear, "error") <= 0.15);
    assert!(number(&dear, "error") < number(&cheap, "error"), "{cheap:#} {dear:#}");
}

#[test]
fn a_memory_limit_is_kept_and_the_error_is_the_smallest_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["fit", "cornell-box", "--memory", "4", "--ms", "2000", "--precompute-ms", "2000"];
    let report = json(&run(&args, folder.path()));
    let choice = &report["choice"];
    assert!(choice["memory_bytes"].as_u64().unwrap() <= 4 << 20);
    assert!(choice["error"].as_f64().unwrap() < 0.5, "{choice}");
}

#[test]
fn what_cannot_be_had_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = run(&["fit", "cornell-box", "--error", "0.001", "--ms", "0.01"], folder.path());
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("nothing fits") && said.contains("closest"), "{said}");
    assert!(!folder.path().join("settings.json").exists());
    let report: Value =
        serde_json::from_str(&std::fs::read_to_string(folder.path().join("fit.json")).unwrap()).unwrap();
    assert_eq!(report["found"], false);
}

#[test]
fn wrong_use_says_what_is_right() {
    let folder = tempfile::tempdir().expect("a folder");
    let broken = folder.path().join("broken.json");
    std::fs::write(&broken, "{\"method\": 3}").unwrap();
    let unknown = folder.path().join("unknown.json");
    std::fs::write(&unknown, "{\"method\": \"vtc\", \"settings\": {}}").unwrap();
    let (broken, unknown) = (broken.to_str().unwrap(), unknown.to_str().unwrap());
    for (args, named) in [
        (&["fit", "cornell-box"][..], "--error"),
        (&["fit", "cornell-box", "furnace", "--error", "0.1"], "one scene"),
        (&["fit", "cornell-box", "--error", "-1"], "error"),
        (&["fit", "cornell-box", "--memory", "none"], "MiB"),
        (&["render", "cornell-box", "--settings", broken], "broken.json"),
        (&["render", "cornell-box", "--settings", unknown], "vct"),
        (&["render", "cornell-box", "--settings", "nowhere.json"], "nowhere.json"),
        (&["render", "cornell-box"], "--method"),
    ] {
        let output = run(args, &folder.path().join("out"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{args:?}: {said}");
        assert!(said.contains(named), "{args:?}: {said}");
    }
}
