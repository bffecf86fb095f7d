//! `bake`: whole files, the same bits after an interruption, and what damaged files say.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_interreflect-under-test"))
}

fn interreflect(args: &[&str]) -> Output {
    program().args(args).output().expect("the program starts")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("temporary paths are text")
}

fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

const SMALL: [&str; 10] =
    ["--set", "receivers=600", "--set", "probes=4", "--set", "order=2", "--set", "rays=32", "--set", "relight_rays=64"];

fn bake(scene: &str, output: &Path, more: &[&str]) -> Output {
    interreflect(&[&["bake", scene, "-o", text(output)], &SMALL[..], more].concat())
}

fn baked(scene: &str, output: &Path, more: &[&str]) -> serde_json::Value {
    let done = bake(scene, output, &[more, &["--json"]].concat());
    assert!(done.status.success(), "{scene}: {}", String::from_utf8_lossy(&done.stderr));
    serde_json::from_slice(&done.stdout).expect("JSON")
}

#[test]
fn a_bake_reports_every_cluster_and_is_used() {
    let folder = folder();
    let (file, map) = (folder.path().join("box.safetensors"), folder.path().join("map.png"));
    let report = baked("cornell-box", &file, &["--error-map", text(&map)]);
    assert_eq!(report["file_bytes"].as_u64(), Some(std::fs::metadata(&file).unwrap().len()));
    let clusters = report["cluster_list"].as_array().unwrap();
    let sum = |key: &str| clusters.iter().map(|c| c[key].as_f64().unwrap()).sum::<f64>();
    assert_eq!(clusters.len() as u64, report["clusters"].as_u64().unwrap());
    assert_eq!(sum("receivers"), report["receivers"].as_f64().unwrap());
    assert_eq!(sum("bytes"), report["transport_f16_bytes"].as_f64().unwrap());
    // Components end at the larger of `error` and half the noise of the rays, the defaults.
    let end = |c: &serde_json::Value| (0.5 * c["noise"].as_f64().unwrap()).max(0.005) * 1.0001;
    assert!(clusters.iter().all(|c| c["transport_error"].as_f64().unwrap() <= end(c) || c["rank"] == 32));
    assert!(sum("noise") > 0.0);
    // A texel of the lightmap is a pixel of the map.
    let picture = image::open(&map).unwrap().into_rgb8();
    assert_eq!(serde_json::json!([picture.width(), picture.height()]), report["lightmap"]);
    let lit = picture.pixels().filter(|p| p.0 != [0, 0, 0]).count();
    assert!(lit as f64 > 0.9 * report["receivers"].as_f64().unwrap(), "{lit} pixels");
    let mean = report["error_map_mean"].as_f64().unwrap();
    assert!(mean > 0.0 && mean < 2.0, "{mean}");
    // Nothing is left beside it, and pictures come of it.
    assert!(!folder.path().join("box.safetensors.part").exists());
    let out = folder.path().join("out");
    let setting = format!("file={}", text(&file));
    let size = ["--size", "32x32", "--backend", "cpu", "--json"];
    let used = interreflect(
        &[&["render", "cornell-box", "--method", "srp", "--set", &setting, "--out", text(&out)], &size[..]].concat(),
    );
    assert!(used.status.success(), "{}", String::from_utf8_lossy(&used.stderr));
    let needs: serde_json::Value = serde_json::from_slice(&std::fs::read(out.join("report.json")).unwrap()).unwrap();
    assert_eq!(needs["needs"]["file"], text(&file));
    let by_order = needs["needs"]["probes_by_order"].as_array().unwrap();
    assert_eq!(by_order.len(), 3);
    assert_eq!(by_order.iter().map(|n| n.as_u64().unwrap()).sum::<u64>(), report["probes"].as_u64().unwrap());
}

#[test]
fn every_compressor_bakes_through_its_setting() {
    let folder = folder();
    let file = folder.path().join("box.safetensors");
    let bytes = |more: &[&str]| {
        let report = baked("cornell-box", &file, more);
        (report["transport_f16_bytes"].as_f64().unwrap(), report["light_error"].as_f64().unwrap())
    };
    let plain = bytes(&["--set", "compression=none"]);
    let cpca = bytes(&["--set", "compression=cpca"]);
    let learnt = bytes(&["--set", "compression=dictionary", "--set", "atoms=16", "--set", "sparsity=3"]);
    assert!(plain.1 == 0.0 && cpca.1 > 0.0 && learnt.1 > cpca.1, "{plain:?} {cpca:?} {learnt:?}");
    assert!(cpca.0 < plain.0 && learnt.0 < plain.0, "{plain:?} {cpca:?} {learnt:?}");
    let wrong = bake("cornell-box", &file, &["--set", "compression=zip"]);
    assert!(!wrong.status.success() && String::from_utf8_lossy(&wrong.stderr).contains("zip"));
}

/// Whether the first record of a journal is complete: a key of 32 bytes, then a length, as many bytes, and 8 of a checksum.
fn has_a_cluster(journal: &Path) -> bool {
    let bytes = std::fs::read(journal).unwrap_or_default();
    let length = bytes.get(32..40).map(|b| u64::from_le_bytes(b.try_into().expect("eight bytes")));
    length.is_some_and(|length| bytes.len() as u64 >= 48 + length)
}

#[test]
fn a_killed_bake_goes_on_with_the_same_bits() {
    let folder = folder();
    let (whole, killed) = (folder.path().join("whole.safetensors"), folder.path().join("killed.safetensors"));
    let part = folder.path().join("killed.safetensors.part");
    // Long enough to be killed between two of its clusters.
    let long = ["--set", "receivers=12000", "--set", "rays=1024"];
    baked("cornell-box", &whole, &long);
    let args = [&["bake", "cornell-box", "-o", text(&killed)], &SMALL[..], &long[..]].concat();
    let mut child = program().args(&args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
    let limit = Instant::now() + Duration::from_secs(300);
    while !has_a_cluster(&part) {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it could be killed");
        assert!(Instant::now() < limit, "no cluster was kept");
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(part.exists() && !killed.exists(), "it was done before it was killed");
    let resumed = bake("cornell-box", &killed, &long);
    let said = String::from_utf8_lossy(&resumed.stdout).to_string();
    assert!(resumed.status.success() && said.contains("going on"), "{said}");
    assert!(std::fs::read(&whole).unwrap() == std::fs::read(&killed).unwrap(), "the bits differ");
    assert!(!part.exists());
}

/// Renders with a bake file that must be refused, naming the file and a reason.
fn refused(scene: &str, file: &Path, reason: &str) {
    let setting = format!("file={}", text(file));
    let out = file.with_extension("out");
    let output =
        interreflect(&["render", scene, "--method", "srp", "--set", &setting, "--size", "16x16", "--out", text(&out)]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains(text(file)) && said.contains(reason) && !said.contains("panicked"), "{reason}: {said}");
}

#[test]
fn damaged_and_foreign_files_are_refused() {
    let folder = folder();
    let file = folder.path().join("box.safetensors");
    baked("cornell-box", &file, &[]);
    let whole = std::fs::read(&file).unwrap();
    let other = |name: &str, bytes: &[u8]| -> PathBuf {
        let path = folder.path().join(name);
        std::fs::File::create(&path).and_then(|mut f| f.write_all(bytes)).unwrap();
        path
    };
    refused("cornell-box", &other("short", &whole[..whole.len() / 2]), "cut short");
    let mut flipped = whole.clone();
    let last = flipped.len() - 100;
    flipped[last] ^= 4;
    refused("cornell-box", &other("flipped", &flipped), "damaged");
    let mut older = whole.clone();
    let at = older.windows(8).position(|w| w == b"version ").unwrap() + 8;
    older[at] = b'0';
    refused("cornell-box", &other("older", &older), "version 0");
    refused("furnace", &file, "another scene");
    refused("cornell-box", &folder.path().join("absent"), "cannot access");
}

#[test]
fn what_cannot_be_written_or_baked_is_said() {
    let folder = folder();
    let absent = folder.path().join("no").join("folder").join("box.safetensors");
    let output = bake("cornell-box", &absent, &[]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(1) && said.contains(text(&absent)) && !said.contains("panicked"), "{said}");
    let file = folder.path().join("box.safetensors");
    let output = bake("cornell-box", &file, &["--method", "vct"]);
    assert!(!output.status.success() && !file.exists());
    let output = bake("cornell-box", &file, &["--set", "rows=4", "--error-map", text(&folder.path().join("map.png"))]);
    assert!(output.status.code() == Some(2) && !file.exists(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// A square of two triangles under a lamp, as glTF; with or without a second UV set that halves its first one.
fn square(second_set: bool) -> (String, Vec<u8>) {
    let floats = |values: &[f32]| values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
    let positions = floats(&[-1., 0., -1., -1., 0., 1., 1., 0., 1., 1., 0., -1.]);
    let uvs = floats(&[0., 0., 0., 0.5, 0.5, 0.5, 0.5, 0.]);
    let indices: Vec<u8> = [0u16, 1, 2, 0, 2, 3].iter().flat_map(|i| i.to_le_bytes()).collect();
    let bytes = [positions, uvs, indices].concat();
    let mut attributes = serde_json::json!({ "POSITION": 0 });
    if second_set {
        attributes["TEXCOORD_1"] = 1.into();
    }
    let document = serde_json::json!({
        "asset": { "version": "2.0" },
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": { "KHR_lights_punctual": { "lights": [{ "type": "point", "intensity": 5.0 }] } },
        "scenes": [{ "nodes": [0, 1] }], "scene": 0,
        "nodes": [
            { "mesh": 0 },
            { "translation": [0, 1, 0], "extensions": { "KHR_lights_punctual": { "light": 0 } } }
        ],
        "meshes": [{ "primitives": [{ "attributes": attributes, "indices": 2 }] }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, 0, -1], "max": [1, 0, 1] },
            { "bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2" },
            { "bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR" }
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 32 },
            { "buffer": 0, "byteOffset": 80, "byteLength": 12 }
        ],
        "buffers": [{ "byteLength": 92, "uri": "square.bin" }]
    });
    (document.to_string(), bytes)
}

#[test]
fn gltf_files_bring_their_second_uv_set_or_get_one() {
    let folder = folder();
    for second_set in [true, false] {
        let scene = folder.path().join("square.gltf");
        let (document, bytes) = square(second_set);
        std::fs::write(&scene, document).unwrap();
        std::fs::write(folder.path().join("square.bin"), bytes).unwrap();
        let report = baked(text(&scene), &folder.path().join("square.safetensors"), &[]);
        assert_eq!(report["own_uv_set"], second_set, "{report}");
        let receivers = report["receivers"].as_u64().unwrap();
        assert!((500..900).contains(&receivers), "{receivers}");
        // A quarter of the file's own lightmap is used.
        let texels = report["lightmap"][0].as_u64().unwrap() * report["lightmap"][1].as_u64().unwrap();
        let share = receivers as f64 / texels as f64;
        assert!(if second_set { (0.2..0.3).contains(&share) } else { share > 0.7 }, "{share}");
    }
}
