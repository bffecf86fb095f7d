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

    // The page says the same: the choice, every parameter, every other method.
    let page = std::fs::read_to_string(out.join("index.html")).expect("a page");
    assert!(page.contains(&format!("<h1>Use {}</h1>", choice["method"].as_str().unwrap())));
    // What the numbers are is said before they come in tables.
    let explained = page.find("The error (block NRMSE) says how far").expect("words for people who never saw it");
    assert!(explained < page.find("<h2").unwrap());
    for other in report["rejected"].as_array().unwrap() {
        assert!(page.contains(&format!("<h3>{}</h3>", other["method"].as_str().unwrap())), "{other}");
        assert!(other["reason"].as_str().is_some_and(|r| r.len() > 10), "{other}");
    }
    assert!(why.iter().all(|w| page.contains(&format!("data-v=\"{}\"", w["key"].as_str().unwrap()))));
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http"), "the page is self-contained");
    // Times are those of sets that were run, and a set is run once per amount of effort.
    let tried = report["tried"].as_array().unwrap();
    assert!(tried.len() <= report["trials"].as_u64().unwrap() as usize + why.len() * 2, "{}", tried.len());

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

/// What a method decides by itself is in `needs`, and follows what it decides by.
#[test]
fn what_methods_decide_is_reported_and_follows_the_light() {
    let folder = tempfile::tempdir().expect("a folder");
    let needs = |method: &str, set: &[&str]| {
        let set: Vec<String> = set.iter().flat_map(|s| ["--set".to_string(), (*s).to_string()]).collect();
        let mut args = vec!["render", "cornell-box", "--method", method];
        args.extend(set.iter().map(String::as_str));
        json(&run(&args, folder.path()))["needs"].clone()
    };
    let number = |v: &Value, key: &str| v[key].as_f64().unwrap_or_else(|| panic!("no {key}: {v:#}"));

    // The rank of a cluster by the energy that its components carry; the order that each probe's light would need.
    let small = ["receivers=1024", "probes=8", "rays=64", "order=5", "relight_rays=512"];
    let srp = |error: &str| needs("srp", &[&small[..], &[&format!("error={error}")]].concat());
    let (coarse, fine) = (srp("0.1"), srp("0.001"));
    assert!(number(&coarse, "mean_rank") < 0.8 * number(&fine, "mean_rank"), "{coarse:#} {fine:#}");
    let by_order: Vec<f64> = fine["probes_by_order"].as_array().unwrap().iter().filter_map(Value::as_f64).collect();
    assert_eq!((by_order.len(), by_order.iter().sum::<f64>()), (6, number(&fine, "probes")), "{fine:#}");
    // Bounces until the slowest part of light has died down, fewer than are allowed.
    let most = number(&fine, "bounces");
    assert!(most > 1.0 && most < 32.0, "{fine:#}");

    // Light takes as many steps through the grid as there are cells to cross.
    let lpv = |resolution: &str| needs("lpv", &[&format!("resolution={resolution}"), "rsm=32", "bounces=1"]);
    let (coarse, fine) = (lpv("8"), lpv("32"));
    assert!(number(&coarse, "iterations") < number(&fine, "iterations"), "{coarse:#} {fine:#}");
    // One bounce of light from below a lamp leaves surfaces of some facings dark: those streams carry nothing.
    let lit = number(&fine, "streams_with_light");
    assert!(1.0 <= lit && lit <= number(&fine, "streams"), "{fine:#}");

    // What each further bounce keeps, and the voxels that surfaces need.
    let vct = |resolution: &str| needs("vct", &[&format!("resolution={resolution}"), "bounces=3"]);
    let (coarse, fine) = (vct("16"), vct("32"));
    let grown = number(&fine, "occupied_voxels") / number(&coarse, "occupied_voxels");
    // Surfaces, not volume: four times as many, not eight.
    assert!((3.0..6.0).contains(&grown), "{coarse:#} {fine:#}");
    let kept = number(&fine, "bounce_ratio");
    assert!(kept > 0.2 && kept < 0.8, "{kept}");
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

/// A square in the dark, and a camera that looks down on it.
fn unlit(folder: &Path) -> String {
    let file = folder.join("dark.obj");
    std::fs::write(&file, "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nf 1 3 4 2\n").unwrap();
    format!("{}?camera=0.5,1,0.5,0.5,0,0.51,60", file.display())
}

#[test]
fn where_no_light_is_nothing_is_computed() {
    let folder = tempfile::tempdir().expect("a folder");
    let (out, scene) = (folder.path(), unlit(folder.path()));
    let report = json(&run(&["fit", &scene, "--error", "0.1"], out));
    assert_eq!((&report["found"], &report["dark"]), (&true.into(), &true.into()), "{report:#}");
    // No method that could be had was run for it.
    assert_eq!(report["trials"], 1);
    for other in report["rejected"].as_array().unwrap() {
        assert!(other["reason"].as_str().unwrap().contains("no indirect light"), "{other}");
    }
    let page = std::fs::read_to_string(out.join("index.html")).expect("a page");
    assert!(page.contains("No indirect light to compute"));
    // What the page says to run is what runs.
    let (file, settings) = scene.split_once("?camera=").unwrap();
    let said = format!("interreflect render {file} --camera={settings} --settings settings.json");
    assert!(page.contains(&said), "{said}");
    let settings = [format!("--camera={settings}"), format!("--settings={}", out.join("settings.json").display())];
    let render = json(&run(&["render", file, &settings[0], &settings[1]], &out.join("render")));
    assert_eq!(render["method"], report["choice"]["method"]);

    // A search cannot be judged there: a row says so.
    let verdict = json(&run(&["fit", &scene, "--evaluate", "--budget-minutes", "1", "--methods", "lpv"], out));
    assert_eq!((verdict["cases"].as_array().unwrap().len(), &verdict["passed"]), (0, &false.into()), "{verdict:#}");
    assert!(verdict["left_out"][0]["reason"].as_str().is_some_and(|r| r.contains("no indirect light")), "{verdict:#}");
}

#[test]
fn reasons_have_words_where_there_is_no_error() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["fit", "furnace", "--methods", "srp", "--error", "0.05"];
    let report = json(&run(&args, folder.path()));
    assert!(report["choice"]["error"].as_f64().unwrap() < 0.05, "{report:#}");
    let lines =
        report["why"].as_array().unwrap().iter().map(|w| &w["words"]).chain(report["spared"].as_array().unwrap());
    for words in lines {
        let words = words.as_str().unwrap();
        assert!(!words.contains("NaN") && !words.contains("inf"), "{words}");
    }
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
        (&["fit", "cornell-box", "--error", "0.1", "--budget-minutes", "1"], "--evaluate"),
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
