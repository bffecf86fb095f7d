//! Pictures and reports: bits kept, keys as documented, files whole or not at all.

use glam::Vec3;
use interreflect::image_io::{
    Image, ImageError, Rgb8, ToneMap, colour_of_signed, error_map, read_exr, write_exr, write_png, write_whole,
};
use interreflect::methods::{Phase, Settings};
use interreflect::metrics::{ErrorMetrics, NoiseFloor};
use interreflect::report::{self, *};
use serde_json::{Value, json};
use std::path::Path;

fn image(width: u32, height: u32, f: impl Fn(u32, u32) -> Vec3) -> Image {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| f(x, y)).collect();
    Image::new(width, height, pixels).expect("a picture with pixels")
}

fn files_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn exr_keeps_every_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.exr");
    // Odd sides, denormals, negative zero, the largest float, and every exponent.
    let odd = [f32::MIN_POSITIVE / 8.0, -0.0, f32::MAX, 1.0 / 3.0, -7.5e-20];
    let truth = image(37, 19, |x, y| {
        let k = x + 37 * y;
        Vec3::new(odd[k as usize % 5], f32::from_bits((k % 250) << 23 | 0x12345), (k as f32).sin())
    });
    write_exr(&path, &truth).expect("written");
    let back = read_exr(&path).expect("read");
    assert_eq!(back.size(), [37, 19]);
    let bits = |p: &Image| p.pixels().iter().map(|v| v.to_array().map(f32::to_bits)).collect::<Vec<_>>();
    assert_eq!(bits(&truth), bits(&back));
    assert_eq!(files_in(folder.path()), ["a.exr"]);
    // Readers that know nothing of us see the same channels.
    let other = exr::prelude::read_first_flat_layer_from_file(&path).expect("another reader");
    let names: Vec<String> = other.layer_data.channel_data.list.iter().map(|c| c.name.to_string()).collect();
    assert_eq!(names, ["B", "G", "R"]);
    assert_eq!(other.attributes.chromaticities.expect("primaries").white.0, 0.3127);
}

#[test]
fn exr_refuses_what_is_not_finite_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let bad = image(5, 4, |x, y| Vec3::splat(if y == 2 && x > 2 { f32::INFINITY } else { 1.0 }));
    let error = write_exr(&folder.path().join("bad.exr"), &bad).expect_err("refused");
    assert!(matches!(error, ImageError::NonFinite { count: 2, x: 3, y: 2, .. }), "{error}");
    assert!(error.to_string().contains("bad.exr"), "{error}");
    assert!(files_in(folder.path()).is_empty());
}

#[test]
fn broken_exr_files_are_errors_with_their_path() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("broken.exr");
    let whole = folder.path().join("whole.exr");
    write_exr(&whole, &image(32, 32, |x, y| Vec3::splat((x * y) as f32))).expect("written");
    let good = std::fs::read(&whole).expect("bytes");
    let mut huge = good.clone();
    // The data window's largest corner (after the attribute's name, type, size and smallest corner) says 20,000².
    let at = good.windows(11).position(|w| w == b"dataWindow\0").expect("a data window") + 11 + 6 + 4 + 8;
    huge[at..at + 8].copy_from_slice(&[0x1f, 0x4e, 0, 0, 0x1f, 0x4e, 0, 0]);
    let cases: [&[u8]; 5] = [b"", b"not a picture at all", &good[..60], &good[..good.len() - 50], &huge];
    for bytes in cases {
        std::fs::write(&path, bytes).expect("written");
        let error = read_exr(&path).expect_err("broken");
        assert!(error.to_string().contains("broken.exr"), "{error}");
    }
    let huge = read_exr(&path).expect_err("huge");
    assert!(matches!(huge, ImageError::Size { width: 20_000, height: 20_000, .. }), "{huge}");
    let missing = read_exr(&folder.path().join("none.exr")).expect_err("missing");
    assert!(matches!(missing, ImageError::Io { .. }) && missing.to_string().contains("none.exr"), "{missing}");
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.txt");
    write_whole(&path, b"first").expect("written");
    write_whole(&path, b"second").expect("replaced");
    assert_eq!(std::fs::read(&path).expect("bytes"), b"second");
    assert_eq!(files_in(folder.path()), ["a.txt"]);
    // A folder of that name cannot be replaced: the error names it, and no partial file stays.
    let taken = folder.path().join("taken");
    std::fs::create_dir_all(taken.join("inside")).expect("a folder");
    let error = write_whole(&taken, b"x").expect_err("a folder is in the way");
    assert!(error.to_string().contains("taken"), "{error}");
    assert_eq!(files_in(folder.path()), ["a.txt", "taken"]);
    let nowhere = folder.path().join("no/such/folder/a.png");
    let error = write_png(&nowhere, &Rgb8::new(2, 2)).expect_err("no folder");
    assert!(error.to_string().contains("no/such/folder/a.png"), "{error}");
}

#[test]
fn tone_map_exposes_the_truth_and_is_shared() {
    // 100 lit pixels of luminance 1…100 and as many black ones: the 95th percentile of the lit ones is 95.
    let truth = image(200, 1, |x, _| Vec3::splat(if x < 100 { 0.0 } else { (x - 99) as f32 }));
    let tone = ToneMap::from_truth(&truth, &[]);
    assert!((1.0 / tone.exposure - 95.0).abs() < 0.01, "{tone:?}");
    // f(1) = (1 + 1/16)/2 = 0.53125; sRGB 0.7551; code 193. White at 4 times the percentile and beyond.
    let shown = tone.apply(&image(3, 1, |x, _| Vec3::splat([95.0, 380.0, 1e30][x as usize])));
    assert_eq!(shown.pixels().map(|p| p.0[0]).collect::<Vec<_>>(), [193, 255, 255]);
    assert_eq!(ToneMap::from_truth(&image(2, 2, |_, _| Vec3::ZERO), &[]).exposure, 1.0);
    // sRGB codes of linear 0, 0.002, 0.2159, 1 (IEC 61966-2-1).
    let linear = ToneMap::LINEAR.apply(&image(4, 1, |x, _| Vec3::splat([0.0, 0.002, 0.215_861, 1.0][x as usize])));
    assert_eq!(linear.pixels().map(|p| p.0[1]).collect::<Vec<_>>(), [0, 7, 128, 255]);
}

#[test]
fn error_maps_show_sign_size_and_background() {
    let truth = image(5, 1, |_, _| Vec3::ONE);
    let estimate = image(5, 1, |x, _| Vec3::splat([0.5, 0.9, 1.0, 1.5, 9.0][x as usize]));
    let map = error_map(&truth, &estimate, &[true, true, true, true, false], 0.01, 0.5);
    let [dark, slight, none, bright, background] = std::array::from_fn(|x| map.get_pixel(x as u32, 0).0);
    assert!(dark[2] > dark[0] + 60, "too dark is blue: {dark:?}");
    assert!(bright[0] > bright[2] + 60, "too bright is red: {bright:?}");
    assert!(none.iter().all(|&v| v > 235) && none.iter().max() == none.iter().min(), "right is near white: {none:?}");
    assert!(slight[2] > slight[0] && slight[0] > dark[0], "a small error is pale: {slight:?}");
    assert_eq!(background, [122; 3]);
    assert_eq!(colour_of_signed(-3.0), colour_of_signed(-1.0));
}

fn result(method: &str) -> MethodResult {
    let settings = Settings::from([("resolution".into(), "128".into()), ("mips".into(), "aniso".into())]);
    MethodResult {
        method: method.into(),
        label: None,
        summary: String::new(),
        control: false,
        settings: settings_json(&settings),
        backend: "cpu".into(),
        error: Some(ErrorMetrics { nrmse: 0.1, nrmse_block: 0.05, bias: 1.01, p95: 1.0 / 3.0, flip: Some(0.125) }),
        time_ms: TimeMs::from_stages([
            (Phase::Precompute, "voxelize".into(), 4.0),
            (Phase::LightChange, "inject".into(), 1.5),
            (Phase::LightChange, "mipmap".into(), 0.25),
            (Phase::LightChange, "mipmap".into(), 0.5),
            (Phase::Frame, "mipmap".into(), 0.125),
            (Phase::Frame, "cones".into(), 8.0),
        ]),
        memory_bytes: MemoryBytes::from_buffers([("voxels".into(), 4096), ("mips".into(), 512), ("mips".into(), 512)]),
        needs: json!({"levels": 8, "limit": null}),
    }
}

fn comparison() -> Comparison {
    Comparison {
        scene: "cornell-box".into(),
        camera: Camera {
            name: "front".into(),
            position: [0.1, 0.2, 0.3],
            forward: [0.0, 0.0, -1.0],
            up: [0.0, 1.0, 0.0],
            fovy_deg: 40.0,
        },
        size: [64, 48],
        truth: Truth {
            noise: 0.01,
            spp: 1024,
            ms: 12345.678,
            noise_floor: Some(NoiseFloor { nrmse: 0.01, nrmse_block: 0.002 }),
        },
        device: Device {
            backend: "cpu".into(),
            adapter: "A <b>\"quoted\"</b> & Co".into(),
            driver: "AVX2".into(),
            cpu: "2 threads".into(),
            hardware_gpu: false,
        },
        results: vec![result("alpha"), result("beta")],
        notes: vec!["3 triangles of zero area were dropped".into()],
        tone_map: "exposure 1".into(),
        peak_memory_bytes: 1 << 30,
        version: report::version(),
    }
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().expect("an object").keys().map(String::as_str).collect()
}

#[test]
fn compare_json_has_the_documented_keys_and_comes_back() {
    let before = comparison();
    let text = to_json(&before).expect("finite");
    let back: Comparison = serde_json::from_str(&text).expect("readable");
    assert_eq!(back, before);
    let json: Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(keys(&json)[..6], ["scene", "camera", "size", "truth", "device", "results"]);
    assert_eq!(json["size"], json!([64, 48]));
    assert_eq!(keys(&json["truth"])[..3], ["noise", "spp", "ms"]);
    assert_eq!(keys(&json["device"])[..4], ["backend", "adapter", "driver", "cpu"]);
    let row = &json["results"][1];
    for key in ["method", "settings", "backend", "error", "time_ms", "memory_bytes", "needs"] {
        assert!(row.get(key).is_some(), "{key} is missing");
    }
    assert_eq!(row["settings"], json!({"mips": "aniso", "resolution": 128}));
    assert_eq!(keys(&row["error"]), ["nrmse", "nrmse_block", "bias", "p95", "flip"]);
    assert_eq!(keys(&row["time_ms"])[..4], ["precompute", "light_change", "frame", "stages"]);
    let stages = json!({"voxelize": 4.0, "inject": 1.5, "mipmap": 0.75, "mipmap (frame)": 0.125, "cones": 8.0});
    assert_eq!(row["time_ms"]["stages"], stages);
    assert_eq!(keys(&row["time_ms"]["stages"]), keys(&stages), "stages keep their order");
    assert_eq!(row["time_ms"]["light_change"], json!(2.25));
    assert_eq!(row["time_ms"]["frame"], json!(8.125));
    assert_eq!(row["memory_bytes"], json!({"total": 5120, "buffers": {"voxels": 4096, "mips": 1024}}));
}

#[test]
fn report_json_is_one_result_with_its_surroundings() {
    let all = comparison();
    let mut report = RenderReport {
        scene: all.scene.clone(),
        camera: all.camera.clone(),
        size: all.size,
        device: all.device.clone(),
        result: result("alpha"),
        truth: None,
        notes: vec![],
        tone_map: String::new(),
        peak_memory_bytes: 0,
        version: report::version(),
    };
    report.result.error = None;
    let text = to_json(&report).expect("finite");
    assert_eq!(serde_json::from_str::<RenderReport>(&text).expect("readable"), report);
    let json: Value = serde_json::from_str(&text).expect("JSON");
    for key in
        ["scene", "camera", "size", "device", "method", "settings", "backend", "time_ms", "memory_bytes", "needs"]
    {
        assert!(json.get(key).is_some(), "{key} is missing");
    }
    assert!(json.get("error").is_none() && json.get("truth").is_none(), "no truth, no error");
}

#[test]
fn numbers_that_json_lacks_are_refused_by_name() {
    let mut bad = comparison();
    bad.results[1].time_ms.frame = f64::NAN;
    let error = to_json(&bad).expect_err("NaN");
    assert_eq!(error.to_string(), "the report's `results[1].time_ms.frame` is not a finite number");
}

#[test]
fn table_is_aligned_and_complete() {
    let mut all = comparison();
    all.results[1].error = None;
    all.results[1].label = Some("fine".into());
    let text = Table(&all).to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 5, "{text}");
    for name in
        ["method", "nrmse", "nrmse_block", "bias", "p95", "flip", "precompute", "light change", "frame", "memory"]
    {
        assert!(lines[0].contains(name), "{text}");
    }
    for cell in ["alpha", "0.100", "0.050", "1.010", "0.333", "0.125", "4.00 ms", "2.25 ms", "8.12 ms", "5.00 KiB"] {
        assert!(lines[2].contains(cell), "{cell}: {text}");
    }
    assert!(lines[3].starts_with("beta fine") && lines[3].contains(" -  "), "{text}");
    assert!(lines[0].len() == lines[2].len() && lines[2].len() == lines[3].len(), "{text}");
}

fn frame(factor: f32) -> Frame {
    let level = |scale: f32| image(64, 48, move |x, y| Vec3::new(0.2 + x as f32, 1.0 + y as f32, 8.0) * scale);
    Frame {
        direct: level(0.5),
        indirect: level(0.5 * factor),
        full: level(0.5 + 0.5 * factor),
        irradiance: level(factor),
    }
}

fn pictures() -> Pictures {
    let visible = (0..64 * 48).map(|k| k % 64 > 3).collect();
    Pictures { truth: frame(1.0), results: vec![frame(0.8), frame(1.1)], visible }
}

/// All files below a folder, as paths relative to it.
fn tree(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_path_buf()];
    while let Some(here) = open.pop() {
        for entry in std::fs::read_dir(&here).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else {
                found.push(path.strip_prefix(folder).expect("below").to_string_lossy().into_owned());
            }
        }
    }
    found.sort();
    found
}

#[test]
fn a_comparison_is_a_folder_with_everything() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("new/out");
    let mut all = comparison();
    all.results[1].method = "alpha".into();
    all.results[1].label = Some("fine/../x".into());
    write_comparison(&out, &all, &pictures()).expect("written");
    let per_result =
        ["full.exr", "full.png", "full_error.png", "irradiance.exr", "irradiance.png", "irradiance_error.png"];
    let mut expected: Vec<String> = ["chart.svg", "compare.json", "index.html"].map(String::from).into();
    for name in ["truth", "alpha", "alpha-fine-..-x"] {
        let files = per_result.iter().filter(|f| name != "truth" || !f.contains("error"));
        expected.extend(files.map(|f| format!("{name}/{f}")));
    }
    expected.sort();
    assert_eq!(tree(&out), expected);
    assert_eq!(read_exr(&out.join("alpha/irradiance.exr")).expect("read"), frame(0.8).irradiance);
    let json = std::fs::read_to_string(out.join("compare.json")).expect("read");
    assert_eq!(serde_json::from_str::<Comparison>(&json).expect("readable"), all);
    // A second run replaces what the first wrote, and nothing else.
    std::fs::write(out.join("notes.txt"), "mine").expect("written");
    write_comparison(&out, &all, &pictures()).expect("written again");
    expected.push("notes.txt".into());
    expected.sort();
    assert_eq!(tree(&out), expected);
}

#[test]
fn a_render_is_a_folder_with_its_light() {
    let folder = tempfile::tempdir().expect("a folder");
    let all = comparison();
    let (scene, camera, device) = (all.scene.clone(), all.camera.clone(), all.device.clone());
    let report = RenderReport {
        scene,
        camera,
        size: all.size,
        device,
        result: result("alpha"),
        truth: Some(all.truth),
        notes: vec![],
        tone_map: ToneMap::LINEAR.describe(),
        peak_memory_bytes: 0,
        version: report::version(),
    };
    write_render(folder.path(), &report, &frame(1.0), &ToneMap::LINEAR).expect("written");
    let files = ["direct.exr", "full.exr", "full.png", "indirect.exr", "irradiance.exr", "report.json"];
    assert_eq!(tree(folder.path()), files);
}

#[test]
fn the_page_needs_nothing_but_itself() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut all = comparison();
    all.results[0].control = true;
    all.results[1].summary = "<script>alert('x')</script>".into();
    write_comparison(folder.path(), &all, &pictures()).expect("written");
    let html = std::fs::read_to_string(folder.path().join("index.html")).expect("read");
    for outside in ["http:", "https:", "//cdn", "@import", "url(", "<link", "<iframe", "src=\"/", "href="] {
        assert!(!html.contains(outside), "the page refers to something outside: {outside}");
    }
    for (k, _) in html.match_indices("src=\"") {
        assert!(html[k..].starts_with("src=\"data:image/png;base64,"), "{}", &html[k..k + 60]);
    }
    // Truth and two results, two layers, and an error map of each result in both layers: each picture once.
    assert_eq!(html.matches("src=\"data:image/png;base64,").count(), 3 * 2 + 2 * 2);
    assert!(!html.contains("<script>alert") && !html.contains("A <b>"), "text is escaped");
    assert!(html.contains("A &lt;b&gt;&quot;quoted&quot;&lt;/b&gt; &amp; Co"));
    assert_eq!(html.matches("<img").count(), html.matches(" alt=\"").count(), "every picture has a description");
    // What is shown comes from the report.
    for text in [
        headline(&all).as_str(),
        "1.010",
        "0.333",
        "0.125",
        "mipmap (frame)",
        "resolution = 128",
        "levels = 8",
        "1024 samples per pixel",
        "3 triangles of zero area were dropped",
        "noise of the truth",
    ] {
        assert!(html.contains(text), "{text} is missing");
    }
    let svg = std::fs::read_to_string(folder.path().join("chart.svg")).expect("read");
    assert!(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\"") && svg.ends_with("</svg>\n"));
    assert_eq!(svg.matches("class=\"dot\"").count() + svg.matches("class=\"control\"").count(), 2);
}

#[test]
fn nothing_is_left_when_a_comparison_cannot_be_written() {
    let folder = tempfile::tempdir().expect("a folder");
    // A picture with NaN in the last result: found before anything is written.
    let mut bad = pictures();
    bad.results[1].irradiance = image(64, 48, |x, _| Vec3::splat(if x == 9 { f32::NAN } else { 1.0 }));
    let error = write_comparison(&folder.path().join("out"), &comparison(), &bad).expect_err("NaN");
    assert!(error.to_string().contains("beta") && error.to_string().contains("48 pixels"), "{error}");
    assert!(files_in(folder.path()).is_empty());
    let mut few = pictures();
    few.results.pop();
    assert!(matches!(write_comparison(folder.path(), &comparison(), &few), Err(ReportError::Mismatch { .. })));
    // A file where the folder should be.
    let taken = folder.path().join("taken");
    std::fs::write(&taken, "mine").expect("written");
    let error =
        write_comparison(&taken.join("deep/out"), &comparison(), &pictures()).expect_err("a file is in the way");
    assert!(error.to_string().contains("taken"), "{error}");
    assert_eq!(files_in(folder.path()), ["taken"]);
}

fn point(name: &str, ms: f64, error: f64, control: bool) -> ChartPoint {
    let name = name.to_string();
    ChartPoint {
        series: name.clone(),
        mark: name.clone(),
        label: name,
        cost: ms,
        still_cost: ms / 2.0,
        spread: None,
        error,
        control,
        under_noise: false,
        link: String::new(),
    }
}

#[test]
fn pareto_front_holds_what_nothing_beats() {
    let points = vec![
        point("slow-best", 50.0, 0.05, false),
        point("dominated", 20.0, 0.3, false),
        point("middle", 10.0, 0.2, false),
        point("same-time-worse", 10.0, 0.25, false),
        point("fast", 1.0, 0.4, false),
        point("free", 0.0, 0.01, true),
    ];
    let chart = Chart { title: "t".into(), points, noise_floor: Some(0.002), ..Chart::default() };
    let front: Vec<&str> = chart.pareto_front().iter().map(|p| p.label.as_str()).collect();
    assert_eq!(front, ["fast", "middle", "slow-best"]);
    let svg = chart.svg(800.0, 400.0, "");
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    // A tenth of the time is as far left at any place of a logarithmic axis: 50 → 10 is log 5, 10 → 1 is log 10.
    let x: Vec<f64> =
        svg.match_indices("cx=\"").filter_map(|(k, _)| svg[k + 4..].split('"').next()?.parse().ok()).collect();
    let (slow, middle, fast) = (x[0], x[2], x[4]);
    assert!(((slow - middle) / (middle - fast) - 5.0_f64.log10()).abs() < 0.01, "{x:?}");
    assert!(x.iter().all(|x| (0.0..800.0).contains(x)));
}

#[test]
fn charts_of_nothing_or_of_zeros_are_charts() {
    let empty = Chart { title: String::new(), points: vec![], noise_floor: None, ..Chart::default() };
    let points = vec![point("z", 0.0, 0.0, false)];
    let zero = Chart { title: "z".into(), points, noise_floor: Some(0.0), ..Chart::default() };
    for svg in [empty.svg(400.0, 300.0, ""), zero.svg(400.0, 300.0, "")] {
        assert!(svg.ends_with("</svg>\n") && !svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}

#[test]
fn headline_says_who_won_and_against_what() {
    let mut all = comparison();
    all.results = [("slow", 0.05, 80.0, false), ("quick", 0.2, 2.0, false), ("constant", 0.1, 0.5, true)]
        .map(|(name, block, ms, control)| {
            let mut row = result(name);
            row.control = control;
            row.error = row.error.map(|e| ErrorMetrics { nrmse_block: block, ..e });
            row.time_ms = TimeMs::from_stages([(Phase::Frame, "all".into(), ms)]);
            row
        })
        .into();
    assert_eq!(
        headline(&all),
        "Of 2 candidates, slow comes closest to the truth: block NRMSE 0.050, 1 % too bright on average, in 80.0 ms per \
         frame with moving lights. That is 50 % less error than the best control (constant, 0.100). The fastest is quick: \
         2.00 ms at block NRMSE 0.200."
    );
    all.results.remove(0);
    assert!(headline(&all).contains("The control constant does no worse (0.100)"), "{}", headline(&all));
    all.results.iter_mut().for_each(|r| r.error = None);
    assert_eq!(headline(&all), "No method could be compared with the truth.");
}
