//! The program: every verb, every error, exit codes, and that files appear whole or not at all.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn interreflect(args: &[&str]) -> Output {
    let program = env!("CARGO_BIN_EXE_interreflect-under-test");
    Command::new(program).args(args).output().expect("the program starts")
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("temporary paths are text")
}

/// Runs a command that must succeed, and gives the JSON it prints.
fn json(args: &[&str]) -> serde_json::Value {
    let output = interreflect(args);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{args:?}: {error}");
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{args:?} printed no JSON: {e}"))
}

/// Runs a command that must fail with a code and name these things in its message.
fn fails(args: &[&str], code: i32, named: &[&str]) {
    let output = interreflect(args);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{args:?}: {error}");
    for name in named {
        assert!(error.contains(name), "{args:?}: the message does not name `{name}`: {error}");
    }
    assert!(!error.contains("panicked"), "{args:?} panicked: {error}");
}

fn files(folder: &Path) -> Vec<PathBuf> {
    std::fs::read_dir(folder).map(|entries| entries.flatten().map(|e| e.path()).collect()).unwrap_or_default()
}

#[test]
fn lists_are_complete_in_text_and_json() {
    let methods = json(&["methods", "--json"]);
    let names: Vec<&str> = methods.as_array().unwrap().iter().map(|m| m["name"].as_str().unwrap()).collect();
    for name in ["reference", "direct", "ambient", "vct"] {
        assert!(names.contains(&name), "{names:?}");
    }
    let scenes = json(&["scenes", "--json"]);
    assert!(
        scenes.as_array().unwrap().iter().any(|s| s["name"] == "cornell-box" && s["stats"]["triangle_count"] == 32)
    );
    let devices = json(&["devices", "--json"]);
    assert_eq!(devices["cpu"]["backend"], "cpu");
    for verb in ["methods", "scenes", "devices"] {
        let output = interreflect(&[verb]);
        assert!(output.status.success() && !output.stdout.is_empty(), "{verb}");
    }
}

#[test]
fn render_writes_pictures_and_a_report_that_agree() {
    let out = folder();
    let report = json(&[
        "render",
        "cornell-box",
        "--method",
        "direct",
        "--size",
        "24x16",
        "--backend",
        "cpu",
        "--json",
        "--out",
        text(out.path()),
    ]);
    assert_eq!(report["size"], serde_json::json!([24, 16]));
    assert_eq!(report["method"], "direct");
    let read = |name: &str| interreflect::image_io::read_exr(&out.path().join(name)).unwrap();
    let (direct, indirect, full) = (read("direct.exr"), read("indirect.exr"), read("full.exr"));
    assert!(indirect.pixels().iter().all(|p| *p == glam::Vec3::ZERO), "the control has no indirect light");
    assert!(direct.pixels().iter().any(|p| p.x > 1.0), "the lamp is in the picture");
    for (d, f) in direct.pixels().iter().zip(full.pixels()) {
        assert_eq!(d, f);
    }
    assert_eq!(read("irradiance.exr").size(), [24, 16]);
    assert_eq!(image::image_dimensions(out.path().join("full.png")).unwrap(), (24, 16));
    let written: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(out.path().join("report.json")).unwrap()).unwrap();
    assert_eq!(written["camera"], report["camera"]);
}

#[test]
fn reference_and_render_meet_in_the_error_of_a_report() {
    let (truth, out) = (folder(), folder());
    let common = ["cornell-box", "--size", "16x16", "--seed", "3"];
    let cache = folder();
    let mut args =
        vec!["reference", "--spp", "64", "--cache", text(cache.path()), "--json", "--out", text(truth.path())];
    args.extend(common);
    let reference = json(&args);
    assert_eq!(reference["picture"]["spp"], 64);
    let file = truth.path().join("irradiance.exr");
    let mut args = vec!["render", "--backend", "cpu", "--json", "--truth", text(&file), "--out", text(out.path())];
    args.extend(common);
    args.extend(["--method", "direct"]);
    let error = json(&args)["error"].clone();
    // No indirect light at all: nothing of the mean, and the root mean square is at least the mean.
    assert_eq!(error["bias"], 0.0);
    assert!(error["nrmse"].as_f64().unwrap() >= 1.0, "{error}");
    assert!(error["flip"].as_f64().unwrap() > 0.01, "{error}");
}

#[test]
fn compare_writes_one_folder_with_everything() {
    let (out, cache) = (folder(), folder());
    let comparison = json(&[
        "compare",
        "cornell-box",
        "--methods",
        "direct,ambient,reference",
        "--set",
        "reference.spp=64",
        "--size",
        "24x24",
        "--noise",
        "0.1",
        "--backend",
        "cpu",
        "--cache",
        text(cache.path()),
        "--json",
        "--out",
        text(out.path()),
    ]);
    let results = comparison["results"].as_array().unwrap();
    assert_eq!(results.len(), 3);
    let nrmse = |k: usize| results[k]["error"]["nrmse"].as_f64().unwrap();
    assert!(nrmse(1) < nrmse(0), "a fitted constant beats no light");
    assert!(nrmse(2) < nrmse(1), "path tracing beats a constant");
    let bias = results[1]["error"]["bias"].as_f64().unwrap();
    assert!((bias - 1.0).abs() < 0.01, "the constant is fitted to the mean: {bias}");
    for name in ["compare.json", "index.html", "chart.svg"] {
        assert!(out.path().join(name).is_file(), "{name} in {:?}", files(out.path()));
    }
    let page = std::fs::read_to_string(out.path().join("index.html")).unwrap();
    assert!(page.contains("ambient") && !page.contains("src=\"http"), "the page is self-contained");
}

#[test]
fn the_same_seed_gives_the_same_picture_with_any_number_of_threads() {
    let run = |threads: &str| {
        let out = folder();
        json(&[
            "render",
            "cornell-box",
            "--method",
            "reference",
            "--set",
            "spp=4",
            "--size",
            "20x20",
            "--backend",
            "cpu",
            "--threads",
            threads,
            "--json",
            "--out",
            text(out.path()),
        ]);
        std::fs::read(out.path().join("irradiance.exr")).unwrap()
    };
    assert!(run("1") == run("3"), "irradiance depends on the number of threads");
}

#[test]
fn wrong_use_says_what_is_right() {
    let out = folder();
    let o = text(out.path());
    fails(&["render", "cornel-box", "--method", "direct", "--out", o], 2, &["cornel-box", "cornell-box"]);
    fails(&["render", "cornell-box", "--method", "drect", "--out", o], 2, &["drect", "direct"]);
    fails(
        &["render", "cornell-box", "--method", "ambient", "--set", "irradianse=1,1,1", "--out", o],
        2,
        &["irradianse", "irradiance"],
    );
    fails(
        &["render", "cornell-box", "--method", "ambient", "--set", "irradiance=red", "--out", o],
        2,
        &["red", "r,g,b"],
    );
    fails(&["render", "cornell-box", "--method", "ambient", "--set", "irradiance", "--out", o], 2, &["key=value"]);
    fails(&["render", "cornell-box", "--method", "direct", "--camera", "nobody", "--out", o], 2, &["nobody"]);
    fails(
        &["render", "cornell-box", "--method", "direct", "--camera", "0,0,0,0,0,0,40", "--out", o],
        2,
        &["0,0,0,0,0,0,40"],
    );
    for size in ["0x10", "10x0", "99999x10", "10", "ax10", "1x-4"] {
        fails(&["render", "cornell-box", "--method", "direct", "--size", size, "--out", o], 2, &["--size"]);
    }
    for env in ["1,2", "1,2,x", "-1,0,0", "nan,0,0"] {
        fails(&["render", "cornell-box", "--method", "direct", "--env", env, "--out", o], 2, &["--env"]);
    }
    fails(&["render", "cornell-box", "--method", "direct", "--sun", "0,0,0,1,1,1", "--out", o], 2, &["direction"]);
    fails(&["compare", "--methods", "direct,nothing", "--out", o], 2, &["nothing"]);
    fails(&["compare", "--methods", "direct", "--set", "vct.resolution=64", "--out", o], 2, &["vct"]);
    fails(&["reference", "--noise", "0", "--out", o], 2, &["--noise"]);
    fails(&["reference", "--noise", "0.1", "--spp", "4", "--out", o], 2, &["--spp"]);
    fails(&["render", "cornell-box", "--method", "direct", "--backend", "quantum", "--out", o], 2, &["quantum"]);
    fails(&["fly"], 2, &["fly"]);
    fails(&[], 2, &["Usage"]);
    assert!(files(out.path()).is_empty(), "wrong use leaves nothing behind: {:?}", files(out.path()));
}

#[test]
fn failures_name_the_path_and_leave_nothing() {
    let out = folder();
    let o = text(out.path());
    fails(&["render", "no/such/scene.glb", "--method", "direct", "--out", o], 1, &["no/such/scene.glb"]);
    let broken = out.path().join("broken.glb");
    std::fs::write(&broken, b"glTF\x02\0\0\0\xff\xff\xff\xff").unwrap();
    fails(&["render", text(&broken), "--method", "direct", "--out", o], 1, &["broken.glb"]);
    assert_eq!(files(out.path()).len(), 1, "only the broken file itself: {:?}", files(out.path()));
    // A folder that cannot be made: a file stands in its way.
    let blocked = broken.join("deeper");
    fails(&["render", "cornell-box", "--method", "direct", "--out", text(&blocked)], 1, &["broken.glb"]);
    fails(
        &[
            "render",
            "cornell-box",
            "--method",
            "direct",
            "--size",
            "8x8",
            "--truth",
            "no/truth.exr",
            "--backend",
            "cpu",
            "--out",
            o,
        ],
        1,
        &["no/truth.exr"],
    );
    fails(
        &["render", "cornell-box", "--method", "direct", "--backend", "gpu", "--adapter", "Voodoo 2", "--out", o],
        1,
        &["Voodoo 2"],
    );
}

#[test]
fn errors_are_json_where_json_was_asked_for() {
    let output =
        interreflect(&["render", "nowhere.obj", "--method", "direct", "--json", "--out", text(folder().path())]);
    let value: serde_json::Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
    assert!(value["error"].as_str().unwrap().contains("nowhere.obj"));
}

#[test]
fn an_unlit_scene_is_black_and_says_so() {
    let out = folder();
    let obj = out.path().join("dark.obj");
    std::fs::write(&obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let output = interreflect(&[
        "render",
        text(&obj),
        "--method",
        "direct",
        "--size",
        "8x8",
        "--backend",
        "cpu",
        "--out",
        text(out.path()),
    ]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert!(said.contains("black"), "{said}");
    let full = interreflect::image_io::read_exr(&out.path().join("full.exr")).unwrap();
    assert!(full.pixels().iter().all(|p| *p == glam::Vec3::ZERO));
}

/// The frames of an animation of light propagation volumes.
fn animate(scene: &str, motion: &str) -> Vec<serde_json::Value> {
    let out = folder();
    let args = ["render", scene, "--method", "lpv", "--set", "resolution=8", "--frames", "3", "--animate", motion];
    let all: Vec<&str> =
        args.into_iter().chain(["--size", "24x24", "--backend", "cpu", "--json", "--out", text(out.path())]).collect();
    let frames = json(&all)["frames"].as_array().unwrap().clone();
    assert_eq!(frames.len(), 3);
    let pictures: Vec<Vec<u8>> =
        (0..3).map(|k| std::fs::read(out.path().join(format!("frame-{k:04}.png"))).unwrap()).collect();
    assert!(pictures[0] != pictures[1] && pictures[1] != pictures[2], "{motion}: nothing moved");
    frames
}

#[test]
fn a_moving_light_costs_its_own_map_and_a_moving_object_a_new_grid() {
    for (k, frame) in animate("many-lights", "light:3:0.4,0,0.2").iter().enumerate() {
        let (needs, times) = (&frame["needs"], &frame["time_ms"]);
        assert_eq!(times["precompute"].as_f64().unwrap() > 0.0, k == 0, "{times}");
        let traced = if k == 0 { needs["shadow_maps"].as_u64().unwrap() } else { 1 };
        assert_eq!(needs["shadow_maps_traced"], traced, "frame {k}");
    }
    let frames = animate("cornell-box", "object:red:0.06,0,0");
    for frame in &frames {
        assert!(frame["time_ms"]["precompute"].as_f64().unwrap() > 0.0, "geometry changed");
    }
    // A wall that stands further in keeps its size; the room's does not change.
    assert_eq!(frames[0]["needs"]["dims"], frames[2]["needs"]["dims"]);
}

#[test]
fn render_finds_the_truth_that_an_earlier_run_left_in_the_cache() {
    let (cache, out) = (folder(), folder());
    let common = ["cornell-box", "--size", "16x16", "--json", "--cache", text(cache.path()), "--out", text(out.path())];
    let render = || json(&[&["render", "--method", "ambient", "--backend", "cpu"], &common[..]].concat());
    assert!(render().get("error").is_none_or(serde_json::Value::is_null), "there is no truth yet");
    json(&[&["reference", "--spp", "16"], &common[..]].concat());
    json(&[&["reference", "--spp", "64", "--seed", "5"], &common[..]].concat());
    let report = render();
    assert_eq!(report["truth"]["spp"], 64, "the better one, whatever its seed");
    assert!(report["error"]["nrmse"].as_f64().unwrap() > 0.0 && report["error"]["flip"].as_f64().unwrap() > 0.0);
    assert!(report["truth"]["noise_floor"]["nrmse"].as_f64().unwrap() > 0.0);
    // Another view has another truth.
    let elsewhere =
        json(&[&["render", "--method", "ambient", "--camera", "0.3,0.3,-0.8,0.3,0.3,0,39"], &common[..]].concat());
    assert!(elsewhere.get("error").is_none_or(serde_json::Value::is_null));
}

#[test]
fn a_reader_who_leaves_is_no_error_and_a_full_disk_is() {
    let program = env!("CARGO_BIN_EXE_interreflect-under-test");
    for args in [&["methods"][..], &["methods", "--json"], &["scenes"], &["nonsense", "--json"], &["--help"]] {
        let mut child = Command::new(program)
            .args(args)
            .stdout(std::process::Stdio::piped())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let expected = if args[0] == "nonsense" { 2 } else { 0 };
        assert_eq!(output.status.code(), Some(expected), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
    let full = Path::new("/dev/full");
    if full.exists() {
        let stdout = std::fs::OpenOptions::new().write(true).open(full).unwrap();
        let output = Command::new(program).arg("methods").stdout(stdout).output().unwrap();
        let error = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{error}");
        assert!(error.contains("standard output") && !error.contains("panicked"), "{error}");
    }
}

#[test]
fn wrong_use_is_said_in_json_too() {
    for args in [&["nonsense", "--json"][..], &["render", "cornell-box", "--method", "vct", "--json", "--size", "0x0"]]
    {
        let output = interreflect(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let words = said["error"].as_str().unwrap();
        assert!(words.contains(if args[0] == "nonsense" { "nonsense" } else { "0x0" }), "{words}");
    }
}

#[test]
fn a_command_that_fails_leaves_no_folder_that_it_made() {
    let at = folder();
    let new = at.path().join("new/deeper");
    fails(&["render", "gone.glb", "--method", "vct", "--out", text(&new)], 1, &["gone.glb"]);
    assert_eq!(files(at.path()), Vec::<PathBuf>::new());
    // One that was there stays, with what is in it.
    std::fs::create_dir_all(&new).unwrap();
    fails(&["render", "gone.glb", "--method", "vct", "--out", text(&new)], 1, &["gone.glb"]);
    assert!(new.is_dir());
}
