//! Whatever the bytes of a scene file are, loading gives a scene or an error: no panic, no endless allocation.
//!
//! `INTERREFLECT_FUZZ_SECONDS=600 cargo test --release -p interreflect-tests --test import_fuzz` searches for that long;
//! without it a few seconds. A file that fails is kept in `tests/fuzz-cases/`, whose files every run replays.

use interreflect::scene::{LoadOptions, load};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Bytes of address space that loading one small file may take on top of what the process had (512 MiB): the largest
/// picture, a megabyte's worth of instances, and the allocator's slack stay below it.
const MAX_GROWTH_BYTES: u64 = 512 << 20;

fn cases_folder() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/fuzz-cases"))
}

/// Peak of the process' address space; 0 where the system does not tell.
fn peak_bytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmPeak:"));
    line.and_then(|l| l.split_whitespace().nth(1)).and_then(|kib| kib.parse::<u64>().ok()).map_or(0, |kib| kib << 10)
}

/// Loads a file made of some bytes; what went wrong, if anything.
fn try_bytes(folder: &Path, extension: &str, bytes: &[u8]) -> Result<(), String> {
    let path = folder.join(format!("case.{extension}"));
    std::fs::write(&path, bytes).map_err(|e| e.to_string())?;
    let options = LoadOptions { max_triangles: 100_000, ..LoadOptions::default() };
    let before = peak_bytes();
    let outcome = std::panic::catch_unwind(|| match load(path.to_str().unwrap(), &options) {
        Ok(scene) => {
            assert!(!scene.triangles.is_empty() && scene.triangles.len() <= options.max_triangles);
            assert!(!scene.cameras.is_empty());
            assert!(scene.positions.iter().all(|p| p.is_finite()) && scene.normals.iter().all(|n| n.is_finite()));
        }
        Err(error) => assert!(error.to_string().contains("case."), "the error does not name the file: {error}"),
    });
    let growth = peak_bytes().saturating_sub(before);
    match outcome {
        Err(_) => Err("panic".into()),
        Ok(()) if growth > MAX_GROWTH_BYTES => Err(format!("allocated {growth} bytes")),
        Ok(()) => Ok(()),
    }
}

/// A valid `.gltf` that uses most of what is read: instances, strips, sparse accessors, lights, cameras, textures.
fn valid_gltf() -> String {
    let bytes: Vec<u8> = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0]
        .into_iter()
        .flat_map(f32::to_le_bytes)
        .chain([0, 0, 1, 0, 2, 0, 3, 0])
        .collect();
    let mut png = std::io::Cursor::new(Vec::new());
    let picture = image::RgbaImage::from_fn(3, 2, |x, y| image::Rgba([80 * x as u8, 90 * y as u8, 50, 128]));
    picture.write_to(&mut png, image::ImageFormat::Png).unwrap();
    let hex = |bytes: &[u8]| bytes.iter().map(|b| format!("%{b:02x}")).collect::<String>();
    let (buffer, picture) = (hex(&bytes), hex(png.get_ref()));
    format!(
        r#"{{"asset":{{"version":"2.0"}},"extensionsUsed":["KHR_lights_punctual","KHR_texture_transform"],
"scene":0,"scenes":[{{"nodes":[0,1,2]}}],
"nodes":[{{"mesh":0,"children":[3],"scale":[-1,2,1],"rotation":[0,0.7,0,0.7]}},{{"camera":0,"translation":[0,0,5]}},
{{"extensions":{{"KHR_lights_punctual":{{"light":0}}}}}},{{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,3,0,0,1]}}],
"extensions":{{"KHR_lights_punctual":{{"lights":[{{"type":"spot","intensity":3,"spot":{{"innerConeAngle":0.2,"outerConeAngle":0.5}}}}]}}}},
"cameras":[{{"type":"perspective","perspective":{{"yfov":0.8,"znear":0.1}}}}],
"materials":[{{"alphaMode":"MASK","emissiveFactor":[1,1,1],"emissiveTexture":{{"index":0}},
"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0,"extensions":{{"KHR_texture_transform":{{"scale":[2,2],"rotation":1}}}}}}}}}}],
"textures":[{{"source":0,"sampler":0}}],"samplers":[{{"wrapS":33071}}],"images":[{{"uri":"data:image/png,{picture}"}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":2}},"indices":1,"material":0,"mode":5}},
{{"attributes":{{"POSITION":3,"NORMAL":0}},"mode":4,"indices":1}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}},{{"bufferView":1,"componentType":5123,"count":4,"type":"SCALAR"}},
{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"}},
{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{{"count":1,"indices":{{"bufferView":1,"componentType":5123,"byteOffset":2}},"values":{{"bufferView":0,"byteOffset":12}}}}}}],
"bufferViews":[{{"buffer":0,"byteLength":48,"byteStride":12}},{{"buffer":0,"byteOffset":48,"byteLength":8}}],
"buffers":[{{"byteLength":56,"uri":"data:application/octet-stream,{buffer}"}}]}}"#
    )
}

/// The same document as a `.glb`, its buffer still a data URI, with a binary chunk that nothing uses.
fn valid_glb() -> Vec<u8> {
    let mut json = valid_gltf().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut glb = b"glTF\x02\0\0\0".to_vec();
    glb.extend(((12 + 8 + json.len() + 8 + 4) as u32).to_le_bytes());
    glb.extend((json.len() as u32).to_le_bytes());
    glb.extend(b"JSON");
    glb.extend(json);
    glb.extend([4, 0, 0, 0, b'B', b'I', b'N', 0, 1, 2, 3, 4]);
    glb
}

fn valid_obj() -> String {
    "mtllib none.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.2 1\nvt 0 0\nvt 1 1\nvn 0 0 1\nusemtl a\n\
     f 1 2 3 4\nf 1/1 2/2 5/1\nf 1//1 3//1 -1//1\nf 1 2 3 4 5 \\\n 2\nl 1 2\ng other\nusemtl b\nf -1 -2 -3\n"
        .to_owned()
}

/// One change of a file.
#[derive(Clone, Debug)]
enum Mutation {
    SetByte(prop::sample::Index, u8),
    Truncate(prop::sample::Index),
    Delete(prop::sample::Index, u8),
    Repeat(prop::sample::Index, u8),
    Insert(prop::sample::Index, &'static str),
    /// Replaces the first number at or after a place.
    Number(prop::sample::Index, &'static str),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let words = prop::sample::select(vec![
        "-1",
        "0",
        "1",
        "2",
        "3",
        "5",
        "7",
        "255",
        "65535",
        "4294967295",
        "4294967296",
        "9007199254740993",
        "18446744073709551615",
        "1e38",
        "1e39",
        "-1e400",
        "nan",
        "inf",
        "5121",
        "5123",
        "5125",
        "5126",
        "0.5",
    ]);
    let fragments = prop::sample::select(vec![
        "{",
        "}",
        "[",
        "]",
        ",",
        "null",
        "\"\"",
        "%",
        "data:,",
        "../",
        "/dev/zero",
        "f 1 2 3\n",
        "v nan 1 2\n",
        "v 1 2\n",
        "f 0 1 2\n",
        "vt\n",
        "vn 0 0 0\n",
        "mtllib case.obj\n",
        "usemtl\n",
        "\\",
        "\0",
        "é",
        "\"mesh\":0,",
        "\"count\":1000000000,",
    ]);
    let at = any::<prop::sample::Index>;
    prop_oneof![
        (at(), any::<u8>()).prop_map(|(i, b)| Mutation::SetByte(i, b)),
        at().prop_map(Mutation::Truncate),
        (at(), any::<u8>()).prop_map(|(i, n)| Mutation::Delete(i, n)),
        (at(), any::<u8>()).prop_map(|(i, n)| Mutation::Repeat(i, n)),
        (at(), fragments).prop_map(|(i, s)| Mutation::Insert(i, s)),
        (at(), words.clone()).prop_map(|(i, s)| Mutation::Number(i, s)),
        (at(), words).prop_map(|(i, s)| Mutation::Number(i, s)),
    ]
}

fn apply(bytes: &mut Vec<u8>, mutation: &Mutation) {
    if bytes.is_empty() {
        return;
    }
    let len = bytes.len();
    match mutation {
        Mutation::SetByte(i, byte) => bytes[i.index(len)] = *byte,
        Mutation::Truncate(i) => bytes.truncate(i.index(len)),
        Mutation::Delete(i, n) => drop(bytes.drain(i.index(len)..(i.index(len) + usize::from(*n)).min(len))),
        Mutation::Repeat(i, n) => {
            let piece = bytes[i.index(len)..(i.index(len) + usize::from(*n)).min(len)].to_vec();
            bytes.splice(i.index(len)..i.index(len), piece);
        }
        Mutation::Insert(i, text) => drop(bytes.splice(i.index(len)..i.index(len), text.bytes())),
        Mutation::Number(i, text) => {
            let Some(start) = (i.index(len)..len).find(|&at| bytes[at].is_ascii_digit()) else { return };
            let end = (start..len).find(|&at| !bytes[at].is_ascii_digit()).unwrap_or(len);
            bytes.splice(start..end, text.bytes());
        }
    }
}

/// A file's extension and bytes: noise, or a valid file with some changes.
fn file() -> impl Strategy<Value = (&'static str, Vec<u8>)> {
    let mutated = |extension: &'static str, valid: Vec<u8>| {
        prop::collection::vec(mutation(), 0..6).prop_map(move |mutations| {
            let mut bytes = valid.clone();
            mutations.iter().for_each(|m| apply(&mut bytes, m));
            (extension, bytes)
        })
    };
    let noise = (prop::sample::select(vec!["glb", "gltf", "obj"]), prop::collection::vec(any::<u8>(), 0..400));
    prop_oneof![
        1 => noise,
        2 => mutated("glb", valid_glb()),
        5 => mutated("gltf", valid_gltf().into_bytes()),
        3 => mutated("obj", valid_obj().into_bytes()),
    ]
}

#[test]
fn the_valid_files_that_are_mutated_do_load() {
    let folder = tempfile::tempdir().unwrap();
    let mutated: [(&str, Vec<u8>); 3] =
        [("glb", valid_glb()), ("gltf", valid_gltf().into_bytes()), ("obj", valid_obj().into_bytes())];
    for (extension, bytes) in mutated {
        let path = folder.path().join(format!("valid.{extension}"));
        std::fs::write(&path, bytes).unwrap();
        let scene = load(path.to_str().unwrap(), &LoadOptions::default()).unwrap_or_else(|e| panic!("{e}"));
        assert!(scene.triangles.len() >= 4, "{extension}: {}", scene.triangles.len());
    }
}

#[test]
fn no_bytes_make_the_import_panic() {
    let seconds = std::env::var("INTERREFLECT_FUZZ_SECONDS").ok().and_then(|s| s.parse().ok()).unwrap_or(4);
    let end = Instant::now() + Duration::from_secs(seconds);
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    let mut seed = [0_u8; 32];
    while Instant::now() < end {
        // Each round goes on where the one before ended: the seed is the round's number.
        seed[..8].copy_from_slice(&(count as u64).to_le_bytes());
        let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &seed);
        let config = Config { cases: 200, failure_persistence: None, ..Config::default() };
        let result = TestRunner::new_with_rng(config, rng).run(&file(), |(extension, bytes)| {
            try_bytes(folder.path(), extension, &bytes).map_err(TestCaseError::fail)
        });
        if let Err(proptest::test_runner::TestError::Fail(reason, (extension, bytes))) = &result {
            let name = format!("{}-{count}.{extension}", reason.message().split(' ').next().unwrap_or("case"));
            std::fs::create_dir_all(cases_folder()).unwrap();
            std::fs::write(cases_folder().join(&name), bytes).unwrap();
            panic!("{reason}: kept as fuzz-cases/{name}");
        }
        result.unwrap();
        count += 200;
    }
    println!("{count} files in {seconds} s");
    assert!(count > 0);
}

#[test]
fn files_that_once_failed_do_not_fail_again() {
    let folder = tempfile::tempdir().unwrap();
    let kept: Vec<PathBuf> = std::fs::read_dir(cases_folder())
        .expect("tests/fuzz-cases is part of the repository")
        .map(|e| e.unwrap().path())
        .collect();
    let scenes = kept.iter().filter(|p| p.extension().is_some_and(|e| e != "md"));
    let mut count = 0;
    for path in scenes {
        let extension = path.extension().unwrap().to_str().unwrap();
        try_bytes(folder.path(), extension, &std::fs::read(path).unwrap())
            .unwrap_or_else(|reason| panic!("{}: {reason}", path.display()));
        count += 1;
    }
    assert!(count > 0, "no cases in {}", cases_folder().display());
}
