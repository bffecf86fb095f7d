//! Import of scene files, built-in scenes, and the errors of both.

use glam::{DVec3, Vec2, Vec3};
use interreflect::scene::{
    Alpha, BUILT_IN, FileError, Light, LoadOptions, Scene, SceneError, Triangle, Wrap, built_in, load,
};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

fn must_load(spec: &str) -> Scene {
    load(spec, &LoadOptions::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// A real scene; `None` (said) where the folder of real scenes is absent.
fn real_scene(name: &str) -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/scenes")).join(name);
    if !path.exists() {
        println!("skipped: {} is not there", path.display());
        return None;
    }
    Some(path)
}

/// Every scene is well formed, whatever made it.
fn check_consistency(scene: &Scene) {
    let count = scene.positions.len();
    assert_eq!(scene.normals.len(), count, "{}", scene.name);
    assert_eq!(scene.uvs.len(), count);
    assert!(scene.lightmap_uvs.is_empty() || scene.lightmap_uvs.len() == count);
    assert!(scene.colours.is_empty() || scene.colours.len() == count);
    assert!(!scene.cameras.is_empty());
    for triangle in &scene.triangles {
        assert!(triangle.vertices.iter().all(|&v| (v as usize) < count));
        assert!((triangle.material as usize) < scene.materials.len());
        let [a, b, c] = scene.corners(triangle);
        let normal = (b - a).cross(c - a);
        assert!(normal.length() > 0.0 && normal.is_finite(), "{}: {a} {b} {c}", scene.name);
    }
    for material in &scene.materials {
        assert!(material.texture.is_none_or(|t| (t as usize) < scene.textures.len()));
        assert!(material.albedo.min_element() >= 0.0 && material.albedo.max_element() <= 1.0);
        assert!(material.emission.is_finite() && material.emission.min_element() >= 0.0);
    }
    for (position, normal) in scene.positions.iter().zip(&scene.normals) {
        assert!(position.is_finite());
        assert!((normal.length() - 1.0).abs() < 1e-4, "{}: normal {normal}", scene.name);
    }
    for camera in &scene.cameras {
        assert!((camera.forward.length() - 1.0).abs() < 1e-5 && (camera.up.length() - 1.0).abs() < 1e-5);
        assert!(camera.forward.dot(camera.up).abs() < 1e-5);
        assert!(camera.fovy_rad > 0.0 && camera.fovy_rad < std::f32::consts::PI);
    }
}

#[test]
fn every_built_in_scene_is_well_formed() {
    for built_in in BUILT_IN {
        let scene = must_load(built_in.name);
        assert_eq!(scene.name, built_in.name);
        assert!(!built_in.summary.is_empty());
        assert!(scene.is_lit(), "{}", built_in.name);
        check_consistency(&scene);
    }
}

#[test]
fn real_scenes_load_with_the_documented_counts() {
    // Triangles, vertices, materials, textures, bounding box: from the README beside the scenes.
    #[rustfmt::skip]
    let documented = [
        ("crytek_sponza.glb", 262_266, 25, 21, [-19.21, -1.26, -11.83], [18.00, 14.29, 11.05]),
        ("living_room.glb", 142_973, 19, 4, [-0.51, 0.00, -3.64], [5.12, 2.88, 0.59]),
        ("modern_hall.glb", 28_655, 21, 3, [-21.72, -3.69, -3.08], [7.16, 11.39, 6.95]),
        ("house.glb", 1_571_040, 31, 1, [-28.67, -1.17, -39.51], [21.80, 11.93, 26.60]),
        ("concert_hall.glb", 32_120, 5, 0, [0.0, 0.0, -19.5], [50.7, 14.99, 0.0]),
        ("cornell_box.glb", 32, 4, 0, [0.0, 0.0, 0.0], [0.556, 0.549, 0.559]),
    ];
    for (name, triangles, materials, textures, min, max) in documented {
        let Some(path) = real_scene(name) else { continue };
        let scene = must_load(path.to_str().unwrap());
        check_consistency(&scene);
        println!("{name}: {:?} {:?}", scene.stats(), scene.notes);
        let glass = dropped(&scene, "glass");
        assert_eq!(dropped(&scene, "zero area"), 0, "{name}");
        assert_eq!(scene.triangles.len() + glass, triangles, "{name}");
        // glTF's default material comes on top of the file's.
        assert_eq!(scene.materials.len(), materials + 1, "{name}");
        assert_eq!(scene.textures.len(), textures, "{name}");
        if glass == 0 {
            let (lo, hi) = scene.bounds();
            assert!(lo.distance(Vec3::from_array(min)) < 0.01 && hi.distance(Vec3::from_array(max)) < 0.01, "{name}");
        }
    }
}

/// The number in the note on dropped triangles of some kind.
fn dropped(scene: &Scene, kind: &str) -> usize {
    let note = scene.notes.iter().find(|n| n.contains("dropped") && n.contains(kind));
    note.map_or(0, |n| n.split(' ').next().unwrap().parse().unwrap())
}

#[test]
fn the_built_in_cornell_box_is_the_published_one() {
    let built_in = must_load("cornell-box");
    let Some(path) = real_scene("cornell_box.glb") else { return };
    let file = must_load(path.to_str().unwrap());
    assert_eq!(built_in.triangles.len(), file.triangles.len());
    for a in &built_in.triangles {
        let corners = built_in.corners(a);
        let same_corners = |b: &&Triangle| corners.iter().zip(file.corners(b)).all(|(p, q)| p.distance(q) < 1e-6);
        let b = file.triangles.iter().find(same_corners).unwrap_or_else(|| panic!("{corners:?} is not in the file"));
        let (ma, mb) = (&built_in.materials[a.material as usize], &file.materials[b.material as usize]);
        assert_eq!(ma.name, mb.name);
        assert!(ma.albedo.distance(mb.albedo) < 1e-4 && ma.emission.distance(mb.emission) < 1e-3, "{ma:?} {mb:?}");
        for (va, vb) in a.vertices.iter().zip(b.vertices) {
            let (na, nb) = (built_in.normals[*va as usize], file.normals[vb as usize]);
            assert!(na.distance(nb) < 1e-4, "{na} {nb}");
        }
    }
}

/// Whether each edge of each triangle is met by exactly one other triangle that runs along it the other way.
fn is_closed(scene: &Scene) -> bool {
    let key = |p: Vec3| p.to_array().map(|c| (c * 1e4).round() as i64);
    let mut balance: HashMap<_, i32> = HashMap::new();
    for triangle in &scene.triangles {
        let corners = scene.corners(triangle).map(key);
        for i in 0..3 {
            let (a, b) = (corners[i], corners[(i + 1) % 3]);
            *balance.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    balance.values().all(|&sum| sum == 0)
}

#[test]
fn scenes_that_must_be_closed_are() {
    for scene in [built_in::furnace(0.5, 1.0), built_in::sphere_furnace(3, 0.5, 0.5), built_in::corridor()] {
        assert!(is_closed(&scene), "{}", scene.name);
    }
    assert!(!is_closed(&built_in::cornell_box()), "the Cornell box is open in front");
    let sphere = built_in::sphere_furnace(3, 0.5, 0.5);
    assert_eq!(sphere.triangles.len(), 20 * 64);
    for triangle in &sphere.triangles {
        let [a, b, c] = sphere.corners(triangle);
        assert!((b - a).cross(c - a).dot(a) < 0.0, "fronts are inside");
    }
}

#[test]
fn parameters_of_built_in_scenes_do_what_they_say() {
    assert_eq!(built_in::many_lights(37).lights.len(), 37);
    assert!(must_load("colonnade").triangles.len() >= 20_000);
    let wall = |scene: &Scene| {
        let inner = |t: &&Triangle| scene.materials[t.material as usize].name == "inner wall";
        let xs = scene.triangles.iter().filter(inner).flat_map(|t| scene.corners(t)).map(|p| p.x);
        xs.fold((f32::MAX, f32::MIN), |(lo, hi), x| (lo.min(x), hi.max(x)))
    };
    assert_eq!(wall(&built_in::two_rooms(0.2, 0.0)), (-0.1, 0.1));
    // A sealed wall is one block, one with a door two.
    let doors = [0.0, 0.5].map(|door| built_in::two_rooms(0.2, door).triangles.len());
    assert_eq!(doors[1] - doors[0], 12);
    let furnace = built_in::furnace(0.25, 3.0);
    assert_eq!((furnace.materials[0].albedo, furnace.materials[0].emission), (Vec3::splat(0.25), Vec3::splat(3.0)));
}

#[test]
fn the_environment_of_the_options_replaces_the_scenes_own() {
    let environment = Vec3::new(1.0, 2.0, 3.0);
    let options = LoadOptions { environment: Some(environment), ..LoadOptions::default() };
    assert_eq!(load("louvres", &options).unwrap().environment, environment);
    assert_ne!(must_load("louvres").environment, Vec3::ZERO);
}

#[test]
fn the_content_hash_follows_light_and_nothing_else() {
    let scene = must_load("cornell-box");
    let mut renamed = scene.clone();
    renamed.name = "other".into();
    renamed.materials[0].name = "other".into();
    renamed.cameras.clear();
    assert_eq!(scene.content_hash(), renamed.content_hash());
    let changes: [fn(&mut Scene); 8] = [
        |s| s.positions[0].x += 1e-6,
        |s| s.normals[0] = -s.normals[0],
        |s| s.uvs[0].x = 0.5,
        |s| s.triangles.swap(0, 1),
        |s| s.materials[0].albedo.x = 0.1,
        |s| s.materials[0].alpha = Alpha::Mask(0.0),
        |s| s.lights.push(Light::Point { position: Vec3::ONE, intensity: Vec3::ZERO }),
        |s| s.environment.z = 1e-3,
    ];
    for (i, change) in changes.iter().enumerate() {
        let mut changed = scene.clone();
        change(&mut changed);
        assert_ne!(scene.content_hash(), changed.content_hash(), "change {i}");
    }
}

#[test]
fn cameras_are_found_by_name_and_made_of_numbers() {
    let scene = must_load("two-rooms");
    assert_eq!(scene.camera(None).unwrap(), scene.cameras[0]);
    assert_eq!(scene.camera(Some("lit")).unwrap().name, "lit");
    let made = scene.camera(Some("1, 2,3, 1,2,-7, 90")).unwrap();
    assert_eq!((made.position, made.forward, made.up), (Vec3::new(1.0, 2.0, 3.0), Vec3::NEG_Z, Vec3::Y));
    assert!((made.fovy_rad - std::f32::consts::FRAC_PI_2).abs() < 1e-6);
    // The right edge of a square picture of 90° is 45° to the right.
    let (_, direction) = made.ray(100.0, 50.0, 100, 100);
    assert!(direction.distance(Vec3::new(1.0, 0.0, -1.0).normalize()) < 1e-6);
    for (bad, says) in [
        ("lid", "did you mean `lit`"),
        ("1,2,3", "3 are given"),
        ("1,2,3,4,5,6,7,8", "8 are given"),
        ("1,2,3,1,2,3,40", "same point"),
        ("1,2,3,4,5,six,40", "no number"),
        ("1,2,3,4,5,6,0", "field of view"),
        ("1,2,3,4,5,6,180", "field of view"),
        ("1,2,3,4,inf,6,40", "finite"),
        ("0,0,0,1e-30,0,0,40", "same point"),
    ] {
        let error = scene.camera(Some(bad)).unwrap_err().to_string();
        assert!(error.contains(says) && error.contains(bad), "{error}");
    }
    // Straight down there is no unique up: any will do, but not NaN.
    let down = scene.camera(Some("0,5,0,0,0,0,50")).unwrap();
    assert!(down.up.is_finite() && down.up.dot(down.forward).abs() < 1e-6);
}

#[test]
fn unknown_names_get_the_nearest_one_and_missing_files_their_path() {
    let error = |spec: &str| load(spec, &LoadOptions::default()).unwrap_err();
    assert!(matches!(error("cornel-bx"), SceneError::Unknown { nearest: Some(n), .. } if n == "cornell-box"));
    assert!(matches!(error("xyzzy"), SceneError::Unknown { nearest: None, .. }));
    assert!(matches!(error(""), SceneError::Unknown { .. }));
    assert!(matches!(error("no/such.glb"), SceneError::File { reason: FileError::NotFound, .. }));
    assert!(error("no/such.glb").to_string().starts_with("no/such.glb: "));
    assert!(matches!(error("such.obj"), SceneError::File { reason: FileError::NotFound, .. }));
    assert!(matches!(
        error(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml")),
        SceneError::File { reason: FileError::UnknownKind, .. }
    ));
    assert!(matches!(
        error(env!("CARGO_MANIFEST_DIR")),
        SceneError::File { reason: FileError::NotAFile("a folder"), .. }
    ));
}

/// A glTF document in the making: one buffer that grows.
struct Document {
    root: Value,
    buffer: Vec<u8>,
}

/// Component types of glTF.
const BYTE: u32 = 5120;
const UBYTE: u32 = 5121;
const USHORT: u32 = 5123;
const UINT: u32 = 5125;
const FLOAT: u32 = 5126;

impl Document {
    /// Mesh 0 of node 0 holds one primitive: the triangle (0,0,0) (1,0,0) (0,1,0) with its front towards +Z.
    fn triangle() -> Self {
        let mut document = Document::empty();
        let positions = document.floats("VEC3", &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        document.root["meshes"] = json!([{"name": "m", "primitives": [{"attributes": {"POSITION": positions}}]}]);
        document.root["nodes"] = json!([{"mesh": 0}]);
        document.root["scenes"] = json!([{"nodes": [0]}]);
        document
    }

    fn empty() -> Self {
        let lists = json!({"asset": {"version": "2.0"}, "accessors": [], "bufferViews": []});
        Document { root: lists, buffer: Vec::new() }
    }

    fn view(&mut self, bytes: &[u8]) -> usize {
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        let views = self.root["bufferViews"].as_array_mut().unwrap();
        views.push(json!({"buffer": 0, "byteOffset": self.buffer.len(), "byteLength": bytes.len()}));
        self.buffer.extend(bytes);
        views.len() - 1
    }

    fn accessor(&mut self, bytes: &[u8], component: u32, kind: &str, count: usize) -> usize {
        let view = self.view(bytes);
        let accessors = self.root["accessors"].as_array_mut().unwrap();
        accessors.push(json!({"bufferView": view, "componentType": component, "type": kind, "count": count}));
        accessors.len() - 1
    }

    fn floats(&mut self, kind: &str, values: &[f32]) -> usize {
        let components = match kind {
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            _ => 1,
        };
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        self.accessor(&bytes, FLOAT, kind, values.len() / components)
    }

    fn primitive(&mut self) -> &mut Value {
        &mut self.root["meshes"][0]["primitives"][0]
    }

    fn with_buffer_uri(mut self, uri: &str) -> String {
        self.root["buffers"] = json!([{"byteLength": self.buffer.len(), "uri": uri}]);
        self.root.to_string()
    }

    /// The document with its buffer as a data URI, percent-coded.
    fn text(self) -> String {
        let data: String = self.buffer.iter().map(|b| format!("%{b:02X}")).collect();
        self.with_buffer_uri(&format!("data:application/octet-stream,{data}"))
    }

    fn glb(mut self) -> Vec<u8> {
        self.root["buffers"] = json!([{"byteLength": self.buffer.len()}]);
        let mut text = self.root.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        let mut glb = b"glTF\x02\0\0\0".to_vec();
        glb.extend(((12 + 8 + text.len() + 8 + self.buffer.len()) as u32).to_le_bytes());
        for (kind, data) in [(b"JSON", &text), (b"BIN\0", &self.buffer)] {
            glb.extend((data.len() as u32).to_le_bytes());
            glb.extend(kind);
            glb.extend(data);
        }
        glb
    }

    fn load(self) -> Result<Scene, FileError> {
        load_bytes("gltf", self.text().as_bytes())
    }

    fn must_load(self) -> Scene {
        let scene = self.load().unwrap_or_else(|e| panic!("{e}"));
        check_consistency(&scene);
        scene
    }
}

fn load_in(folder: &Path, extension: &str, bytes: &[u8]) -> Result<Scene, FileError> {
    let path = folder.join(format!("scene.{extension}"));
    std::fs::write(&path, bytes).unwrap();
    load(path.to_str().unwrap(), &LoadOptions::default()).map_err(|e| match e {
        SceneError::File { path: named, reason } => {
            assert_eq!(named, path);
            reason
        }
        other => panic!("{other}"),
    })
}

fn load_bytes(extension: &str, bytes: &[u8]) -> Result<Scene, FileError> {
    load_in(tempfile::tempdir().unwrap().path(), extension, bytes)
}

/// The geometric normal of a triangle's front, and the mean of its vertex normals.
fn normals(scene: &Scene, i: usize) -> (Vec3, Vec3) {
    let triangle = &scene.triangles[i];
    let [a, b, c] = scene.corners(triangle);
    let vertex: Vec3 = triangle.vertices.iter().map(|&v| scene.normals[v as usize]).sum();
    ((b - a).cross(c - a).normalize(), vertex.normalize())
}

#[test]
fn gltf_buffers_may_be_embedded_external_or_binary() {
    let folder = tempfile::tempdir().unwrap();
    let expected = Document::triangle().must_load();
    let corners = expected.corners(&expected.triangles[0]);
    assert_eq!(corners, [Vec3::ZERO, Vec3::X, Vec3::Y]);
    let document = Document::triangle();
    std::fs::write(folder.path().join("a b.bin"), &document.buffer).unwrap();
    let external = load_in(folder.path(), "gltf", document.with_buffer_uri("a%20b.bin").as_bytes()).unwrap();
    assert_eq!(external.corners(&external.triangles[0]), corners);
    let binary = load_in(folder.path(), "glb", &Document::triangle().glb()).unwrap();
    assert_eq!(binary.corners(&binary.triangles[0]), corners);
    assert_eq!(expected.content_hash(), binary.content_hash());
    let base64 = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    let embedded = load_bytes("gltf", Document::triangle().with_buffer_uri(base64).as_bytes()).unwrap();
    assert_eq!(embedded.corners(&embedded.triangles[0]), corners);
}

#[test]
fn gltf_node_transforms_are_composed_and_meshes_instanced() {
    let mut document = Document::triangle();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    document.root["nodes"] = json!([
        {"translation": [10, 0, 0], "children": [1, 2]},
        // A quarter turn around Y takes +X to −Z; scale first, then rotation, then translation.
        {"mesh": 0, "scale": [2, 3, 1], "rotation": [0, half, 0, half], "translation": [0, 1, 0]},
        {"mesh": 0, "matrix": [1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 5, 1]},
        {"mesh": 0}
    ]);
    let scene = document.must_load();
    assert_eq!(scene.triangles.len(), 2, "node 3 is not in the scene");
    let near = |p: Vec3, q: [f32; 3]| assert!(p.distance(Vec3::from_array(q)) < 1e-5, "{p} {q:?}");
    let corners = scene.corners(&scene.triangles[0]);
    near(corners[0], [10.0, 1.0, 0.0]);
    near(corners[1], [10.0, 1.0, -2.0]);
    near(corners[2], [10.0, 4.0, 0.0]);
    near(scene.corners(&scene.triangles[1])[1], [11.0, 0.0, 5.0]);
}

/// Points of the world far from its origin: exact to a hundredth of a millimetre, though f32 steps by 31 mm there.
#[test]
fn scenes_far_away_lose_nothing() {
    let away = [300_000.25, -40.5, 123_456.125];
    let mut document = Document::triangle();
    document.root["nodes"] = json!([
        {"translation": away, "children": [1, 2]},
        {"mesh": 0, "scale": [3, 3, 3], "translation": [0.001, 0, 0.002]},
        {"camera": 0, "translation": [1, 2, 10], "extensions": {"KHR_lights_punctual": {"light": 0}}}
    ]);
    document.root["cameras"] = json!([{"type": "perspective", "perspective": {"yfov": 1.0, "znear": 0.1}}]);
    document.root["extensionsUsed"] = json!(["KHR_lights_punctual"]);
    document.root["extensions"] = json!({"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 2.0}]}});
    let scene = document.must_load();
    let near = |p: Vec3, offset: [f64; 3]| {
        let expected = DVec3::from(away) + DVec3::from(offset);
        assert!(scene.world(p).distance(expected) < 1e-5, "{} is not {expected}", scene.world(p));
    };
    assert!(scene.positions.iter().all(|p| p.length() < 10.0), "{:?}", scene.positions);
    let corners = scene.corners(&scene.triangles[0]);
    near(corners[0], [0.001, 0.0, 0.002]);
    near(corners[1], [3.001, 0.0, 0.002]);
    near(scene.cameras[0].position, [1.0, 2.0, 10.0]);
    let Light::Point { position, .. } = scene.lights[0] else { panic!("{:?}", scene.lights[0]) };
    near(position, [1.0, 2.0, 10.0]);
    assert!(scene.notes.iter().any(|n| n.contains("far from the origin")), "{:?}", scene.notes);
    let camera = scene.camera(Some("300001.375,-38.5,123466.125,300001.375,-38.5,0,60")).unwrap();
    near(camera.position, [1.125, 2.0, 10.0]);
    assert!(camera.forward.distance(Vec3::NEG_Z) < 1e-6);
    let (lo, hi) = (scene.stats().min, scene.stats().max);
    assert!((lo[0] - 300_000.251).abs() < 1e-5 && (hi[1] + 37.5).abs() < 1e-5, "{lo:?} {hi:?}");
}

#[test]
fn obj_files_in_map_coordinates_keep_their_millimetres() {
    let text = "v 500000.001 12 4649776.002\nv 500001.001 12 4649776.002\nv 500001.001 13.5 4649776.002\n\
                v 500000.001 13.5 4649776.002\nf 1 2 3 4\n";
    let scene = load_bytes("obj", text.as_bytes()).unwrap();
    check_consistency(&scene);
    let corners = scene.corners(&scene.triangles[0]);
    assert!(scene.world(corners[0]).distance(DVec3::new(500_000.001, 12.0, 4_649_776.002)) < 1e-5);
    assert!((corners[1].distance(corners[0]) - 1.0).abs() < 1e-6 && scene.triangles.len() == 2, "{corners:?}");
}

#[test]
fn gltf_fronts_stay_fronts_under_mirroring_and_normals_follow_the_inverse_transpose() {
    for scale in [[-1, 1, 1], [1, -2, 1], [1, 1, -1], [-1, -1, -1], [-1, -1, 1]] {
        let mut document = Document::triangle();
        let normal = document.floats("VEC3", &[0.0, 0.0, 1.0].repeat(3));
        document.primitive()["attributes"]["NORMAL"] = json!(normal);
        document.root["nodes"] = json!([{"mesh": 0, "scale": scale}]);
        let scene = document.must_load();
        let (front, shading) = normals(&scene, 0);
        // The front faces where the mirrored normal points.
        let expected = Vec3::new(0.0, 0.0, if scale[2] < 0 { -1.0 } else { 1.0 });
        assert!(front.distance(expected) < 1e-6 && shading.distance(expected) < 1e-6, "{scale:?}: {front} {shading}");
    }
    // A triangle that is neither parallel nor perpendicular to the axes, scaled unevenly: its normal stays perpendicular.
    let mut document = Document::empty();
    let positions = document.floats("VEC3", &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    let normal = document.floats("VEC3", &[1.0, 1.0, 1.0].repeat(3));
    document.root["meshes"] = json!([{"primitives": [{"attributes": {"POSITION": positions, "NORMAL": normal}}]}]);
    document.root["nodes"] = json!([{"mesh": 0, "scale": [1, 4, -0.5]}]);
    let scene = document.must_load();
    let (front, shading) = normals(&scene, 0);
    assert!(front.distance(shading) < 1e-5, "{front} {shading}");
}

#[test]
fn gltf_strips_fans_and_all_index_types_give_triangles_of_the_same_facing() {
    let square = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    let fan = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];
    for (mode, positions) in [(5, square), (6, fan)] {
        for component in [None, Some(UBYTE), Some(USHORT), Some(UINT)] {
            let mut document = Document::triangle();
            let positions = document.floats("VEC3", &positions);
            let indices = component.map(|component| {
                let size = [1, 0, 2, 0, 4][(component - UBYTE) as usize];
                let bytes: Vec<u8> = (0..4_u32).flat_map(|i| i.to_le_bytes()[..size].to_vec()).collect();
                document.accessor(&bytes, component, "SCALAR", 4)
            });
            *document.primitive() = json!({"attributes": {"POSITION": positions}, "mode": mode});
            if let Some(indices) = indices {
                document.primitive()["indices"] = json!(indices);
            }
            let scene = document.must_load();
            assert_eq!(scene.triangles.len(), 2, "mode {mode} {component:?}");
            let area: f32 = scene
                .triangles
                .iter()
                .map(|t| {
                    let [a, b, c] = scene.corners(t);
                    0.5 * (b - a).cross(c - a).z
                })
                .sum();
            assert_eq!(area, 1.0, "mode {mode} {component:?}: both face +Z");
        }
    }
    let mut document = Document::triangle();
    let primitive = document.primitive().clone();
    let mut lines = primitive.clone();
    lines["mode"] = json!(1);
    document.root["meshes"][0]["primitives"] = json!([primitive, lines]);
    let scene = document.must_load();
    assert_eq!(scene.triangles.len(), 1);
    assert!(scene.notes.iter().any(|n| n.contains("lines dropped")), "{:?}", scene.notes);
}

#[test]
fn gltf_sparse_strided_and_normalized_accessors_are_read() {
    // Sparse: vertex 1 is moved from (1,0,0) to (5,0,0).
    let mut document = Document::triangle();
    let index = document.view(&[1, 0]);
    let value = document.view(&[5.0_f32, 0.0, 0.0].iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>());
    document.root["accessors"][0]["sparse"] = json!({"count": 1, "indices": {"bufferView": index, "componentType": USHORT},
        "values": {"bufferView": value}});
    let scene = document.must_load();
    assert_eq!(scene.corners(&scene.triangles[0])[1], Vec3::new(5.0, 0.0, 0.0));
    // Sparse without a buffer view: zeros but for the listed elements.
    let mut document = Document::triangle();
    let index = document.view(&[1, 2]);
    let value =
        document.view(&[5.0_f32, 0.0, 0.0, 0.0, 6.0, 0.0].iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<_>>());
    document.root["accessors"][0] = json!({"componentType": FLOAT, "type": "VEC3", "count": 3, "sparse":
        {"count": 2, "indices": {"bufferView": index, "componentType": UBYTE}, "values": {"bufferView": value}}});
    let scene = document.must_load();
    assert_eq!(scene.corners(&scene.triangles[0]), [Vec3::ZERO, Vec3::X * 5.0, Vec3::Y * 6.0]);
    // Normalized signed bytes, four bytes apart (KHR_mesh_quantization).
    let mut document = Document::triangle();
    document.root["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    let positions = document.accessor(&[0, 0, 0, 9, 127, 0, 0, 9, 0, 129, 128, 9], BYTE, "VEC3", 3);
    document.root["accessors"][positions]["normalized"] = json!(true);
    document.root["bufferViews"][positions]["byteStride"] = json!(4);
    document.primitive()["attributes"]["POSITION"] = json!(positions);
    let scene = document.must_load();
    assert_eq!(scene.corners(&scene.triangles[0]), [Vec3::ZERO, Vec3::X, Vec3::new(0.0, -1.0, -1.0)]);
}

#[test]
fn gltf_lights_and_cameras_follow_their_nodes() {
    let mut document = Document::triangle();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let light = |i: u32| json!({"KHR_lights_punctual": {"light": i}});
    document.root["nodes"] = json!([
        {"mesh": 0},
        // A quarter turn around X by −90° takes −Z to −Y.
        {"rotation": [-half, 0, 0, half], "translation": [1, 2, 3], "scale": [5, 5, 5], "children": [2, 3, 4, 5]},
        {"extensions": light(0)}, {"extensions": light(1)}, {"extensions": light(2)},
        {"camera": 1, "name": "from above"},
        {"camera": 0}
    ]);
    document.root["scenes"] = json!([{"nodes": [6]}, {"nodes": [0, 1, 6]}]);
    document.root["scene"] = json!(1);
    document.root["extensionsRequired"] = json!(["KHR_lights_punctual"]);
    document.root["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": [1, 0.5, 0.25], "intensity": 8},
        {"type": "directional", "intensity": 3},
        {"type": "spot", "intensity": 2, "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.75}}
    ]}});
    document.root["cameras"] = json!([
        {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "zfar": 1, "znear": 0}},
        {"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1, "aspectRatio": 2}}
    ]);
    let scene = document.must_load();
    let position = Vec3::new(1.0, 2.0, 3.0);
    assert_eq!(scene.lights[0], Light::Point { position, intensity: Vec3::new(8.0, 4.0, 2.0) });
    let Light::Directional { direction, irradiance } = scene.lights[1] else { panic!("{:?}", scene.lights) };
    assert!(direction.distance(Vec3::NEG_Y) < 1e-6 && irradiance == Vec3::splat(3.0), "{direction}");
    let Light::Spot { position: at, direction, intensity, cos_inner, cos_outer } = scene.lights[2] else { panic!() };
    assert!(at == position && direction.distance(Vec3::NEG_Y) < 1e-6 && intensity == Vec3::splat(2.0));
    assert_eq!((cos_inner, cos_outer), (0.25_f32.cos(), 0.75_f32.cos()));
    assert_eq!(scene.cameras.len(), 1, "the orthographic one is left out: {:?}", scene.notes);
    let camera = &scene.cameras[0];
    assert_eq!((camera.name.as_str(), camera.position, camera.fovy_rad), ("from above", position, 0.7));
    // A camera is known by its own name and by its node's.
    let mut document = Document::triangle();
    document.root["nodes"] = json!([{"mesh": 0}, {"camera": 0, "name": "tripod"}]);
    document.root["scenes"] = json!([{"nodes": [0, 1]}]);
    document.root["cameras"] =
        json!([{"type": "perspective", "name": "lens", "perspective": {"yfov": 0.5, "znear": 0.1}}]);
    let by_names = document.must_load();
    for name in ["lens", "tripod"] {
        assert_eq!(by_names.camera(Some(name)).unwrap().fovy_rad, 0.5, "{name}");
    }
    assert!(camera.forward.distance(Vec3::NEG_Y) < 1e-6 && camera.up.distance(Vec3::NEG_Z) < 1e-6, "{camera:?}");
}

fn png(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> Vec<u8> {
    let picture = image::RgbaImage::from_fn(width, height, |x, y| image::Rgba(pixel(x, y)));
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// The triangle with a textured material.
fn textured(picture: &[u8], material: Value) -> Document {
    let mut document = Document::triangle();
    let uvs = document.floats("VEC2", &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let other_uvs = document.floats("VEC2", &[0.5, 0.5, 0.75, 0.5, 0.5, 0.75]);
    let view = document.view(picture);
    document.root["images"] = json!([{"bufferView": view, "mimeType": "image/png"}]);
    document.root["textures"] = json!([{"source": 0}]);
    document.root["materials"] = json!([material]);
    document.primitive()["attributes"]["TEXCOORD_0"] = json!(uvs);
    document.primitive()["attributes"]["TEXCOORD_1"] = json!(other_uvs);
    document.primitive()["material"] = json!(0);
    document
}

#[test]
fn gltf_materials_textures_and_their_transforms_are_read() {
    let picture = png(3, 2, |x, y| [x as u8 * 100, y as u8 * 200, 7, 255]);
    let scene = textured(&picture, json!({
        "name": "m",
        "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0.5, "roughnessFactor": 0.25,
            "baseColorTexture": {"index": 0, "extensions": {"KHR_texture_transform":
                {"offset": [0, 1], "rotation": std::f32::consts::FRAC_PI_2, "scale": [0.5, 0.5]}}}},
        "emissiveFactor": [1, 0.5, 0],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4}}
    }))
    .must_load();
    let material = &scene.materials[scene.triangles[0].material as usize];
    assert_eq!(material.albedo, Vec3::new(0.5, 0.25, 1.0));
    assert_eq!(material.emission, Vec3::new(4.0, 2.0, 0.0));
    assert_eq!((material.metallic, material.roughness, material.alpha), (0.5, 0.25, Alpha::Opaque));
    let texture = &scene.textures[material.texture.unwrap() as usize];
    assert_eq!((texture.width, texture.height), (3, 2));
    assert_eq!(texture.srgba[5], [200, 200, 7, 255]);
    // The example of KHR_texture_transform: the lower left quadrant, turned clockwise.
    let uvs = scene.triangles[0].vertices.map(|v| scene.uvs[v as usize]);
    for (uv, expected) in uvs.iter().zip([[0.0, 1.0], [0.0, 0.5], [0.5, 1.0]]) {
        assert!(uv.distance(Vec2::from_array(expected)) < 1e-6, "{uvs:?}");
    }
    let lightmap: Vec<Vec2> = scene.triangles[0].vertices.iter().map(|&v| scene.lightmap_uvs[v as usize]).collect();
    assert_eq!(lightmap[1], Vec2::new(0.75, 0.5));
    // The texture may take the second set.
    let second = textured(&picture, json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}}));
    let scene = second.must_load();
    assert_eq!(scene.uvs[scene.triangles[0].vertices[2] as usize], Vec2::new(0.5, 0.75));
}

#[test]
fn gltf_vertex_colours_and_wrap_modes_are_read() {
    let picture = png(2, 2, |_, _| [200; 4]);
    let plain = || textured(&picture, json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}));
    assert_eq!(plain().must_load().materials[0].wrap, [Wrap::Repeat; 2]);
    let mut document = plain();
    document.root["samplers"] = json!([{"wrapS": 33071, "wrapT": 33648}]);
    document.root["textures"][0]["sampler"] = json!(0);
    let colours = document.floats("VEC3", &[1.0, 0.5, 0.25, 0.0, 2.0, 1.0, 1.0, 1.0, 1.0]);
    document.primitive()["attributes"]["COLOR_0"] = json!(colours);
    let scene = document.must_load();
    assert_eq!(scene.materials[scene.triangles[0].material as usize].wrap, [Wrap::Clamp, Wrap::Mirror]);
    let [a, b, c] = scene.triangles[0].vertices.map(|v| scene.colours[v as usize]);
    // More than 1 would reflect more than arrives.
    assert_eq!([a, b, c], [Vec3::new(1.0, 0.5, 0.25), Vec3::new(0.0, 1.0, 1.0), Vec3::ONE]);
    // Four components; white colours are none.
    let mut document = Document::triangle();
    let white = document.floats("VEC4", &[1.0; 12]);
    document.primitive()["attributes"]["COLOR_0"] = json!(white);
    assert!(document.must_load().colours.is_empty());
    let mut document = Document::triangle();
    let few = document.floats("VEC4", &[1.0; 8]);
    document.primitive()["attributes"]["COLOR_0"] = json!(few);
    assert!(document.load().is_err());
}

#[test]
fn gltf_alpha_modes_and_emission_textures_are_followed() {
    let mask = |alpha: u8, cutoff: Option<f32>| {
        let mut material = json!({"alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}});
        if let Some(cutoff) = cutoff {
            material["alphaCutoff"] = json!(cutoff);
        }
        textured(&png(2, 1, |x, _| [255, 255, 255, if x == 0 { alpha } else { 255 }]), material).must_load()
    };
    assert_eq!(mask(0, None).materials[0].alpha, Alpha::Mask(0.5));
    assert_eq!(mask(100, Some(0.9)).materials[0].alpha, Alpha::Mask(0.9));
    assert_eq!(mask(200, None).materials[0].alpha, Alpha::Opaque, "nothing is cut");
    // Glass does not exist for light; alone it leaves nothing.
    let mut glass = Document::triangle();
    glass.root["materials"] = json!([{"alphaMode": "BLEND"}]);
    glass.primitive()["material"] = json!(0);
    assert!(matches!(glass.load(), Err(FileError::NoTriangles(why)) if why.contains("1 of glass")));
    // Half black, half white: the mean of the linear values is a half.
    let glow = json!({"emissiveFactor": [2, 2, 2], "emissiveTexture": {"index": 0}});
    let scene = textured(&png(2, 1, |x, _| [255 * x as u8, 255 * x as u8, 255 * x as u8, 255]), glow).must_load();
    assert_eq!(scene.materials[0].emission, Vec3::ONE);
    assert!(scene.notes.iter().any(|n| n.contains("emission texture")));
}

#[test]
fn what_is_missing_is_made_up_and_said() {
    let scene = Document::triangle().must_load();
    assert!(scene.notes.iter().any(|n| n.contains("no camera")) && scene.notes.iter().any(|n| n.contains("black")));
    // A sun that a command adds lights the scene, and nothing is said of black.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bare.obj");
    std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    let sun = Some((Vec3::NEG_Z, Vec3::ONE));
    let lit = load(path.to_str().unwrap(), &LoadOptions { sun, ..LoadOptions::default() }).unwrap();
    assert!(lit.is_lit() && lit.lights.len() == 1 && !lit.notes.iter().any(|n| n.contains("black")), "{:?}", lit.notes);
    // Nor is a camera made up where a view is given by numbers: it is the scene's first.
    let view = Some("3,0,5,0,0,0,40".to_string());
    for (spec, others) in [(path.to_str().unwrap(), 0), ("cornell-box", 1)] {
        let seen = load(spec, &LoadOptions { camera: view.clone(), ..LoadOptions::default() }).unwrap();
        assert!(!seen.notes.iter().any(|n| n.contains("camera")), "{:?}", seen.notes);
        assert_eq!((seen.cameras.len(), seen.cameras[0].position), (1 + others, Vec3::new(3.0, 0.0, 5.0)), "{spec}");
        assert_eq!(seen.camera(view.as_deref()).unwrap(), seen.cameras[0]);
    }
    let named = load("cornell-box", &LoadOptions { camera: Some("a name".into()), ..LoadOptions::default() }).unwrap();
    assert_eq!(named.cameras.len(), 1);
    let camera = scene.camera(None).unwrap();
    let to_centre = (Vec3::new(0.5, 0.5, 0.0) - camera.position).normalize();
    assert!(camera.forward.dot(to_centre) > 0.9, "the made-up camera looks at the scene");
    assert!(normals(&scene, 0).1.distance(Vec3::Z) < 1e-6, "flat normals are made");
    // Triangles of zero area: two corners in one place, and three on a line.
    let mut document = Document::triangle();
    let indices = document.accessor(&[0, 1, 2, 0, 0, 1, 1, 1, 1], UBYTE, "SCALAR", 9);
    document.primitive()["indices"] = json!(indices);
    let scene = document.must_load();
    assert_eq!((scene.triangles.len(), dropped(&scene, "zero area")), (1, 2), "{:?}", scene.notes);
}

#[test]
fn broken_gltf_gives_the_reason() {
    let broken = |change: &dyn Fn(&mut Document)| {
        let mut document = Document::triangle();
        change(&mut document);
        document.load().expect_err("must fail")
    };
    let nan = |value: f32| move |d: &mut Document| d.buffer[16..20].copy_from_slice(&value.to_le_bytes());
    for value in [f32::NAN, f32::INFINITY, 1e20] {
        let error = broken(&nan(value));
        assert!(matches!(&error, FileError::BadVertex { mesh, vertex: 1, .. } if mesh == "m"), "{error}");
    }
    let out_of_range = |change: &dyn Fn(&mut Document), what: &str, index: i64| {
        let error = broken(change);
        let fits = matches!(&error, FileError::OutOfRange { what: w, index: i, .. } if w.contains(what) && *i == index);
        assert!(fits, "{error}");
    };
    out_of_range(&|d| *d.primitive() = json!({"attributes": {"POSITION": 7}}), "POSITION: accessor", 7);
    out_of_range(&|d| d.primitive()["material"] = json!(3), "material", 3);
    out_of_range(&|d| d.root["nodes"][0]["mesh"] = json!(2), "mesh", 2);
    out_of_range(&|d| d.root["nodes"][0]["children"] = json!([9]), "node", 9);
    out_of_range(&|d| d.root["scene"] = json!(4), "scene", 4);
    out_of_range(&|d| d.root["accessors"][0]["bufferView"] = json!(5), "buffer view", 5);
    out_of_range(&|d| d.root["bufferViews"][0]["buffer"] = json!(6), "buffer", 6);
    out_of_range(&|d| d.root["nodes"][0]["camera"] = json!(1), "camera", 1);
    out_of_range(
        &|d| {
            let indices = d.accessor(&[0, 1, 3], UBYTE, "SCALAR", 3);
            d.primitive()["indices"] = json!(indices);
        },
        "vertex index",
        3,
    );
    let truncated = |change: &dyn Fn(&mut Document)| {
        let error = broken(change);
        assert!(matches!(error, FileError::Truncated { .. }), "{error}");
    };
    truncated(&|d| d.root["accessors"][0]["count"] = json!(4));
    truncated(&|d| d.root["accessors"][0]["byteOffset"] = json!(u64::MAX));
    truncated(&|d| d.root["bufferViews"][0]["byteLength"] = json!(u64::MAX));
    let error =
        broken(&|d| d.root["accessors"][0] = json!({"componentType": FLOAT, "type": "VEC3", "count": 1_u64 << 40}));
    assert!(matches!(error, FileError::TooLarge { .. }), "{error}");
    let error = broken(&|d| d.root["accessors"][0]["count"] = json!(u64::MAX));
    assert!(matches!(error, FileError::TooLarge { claimed: u64::MAX, .. }), "{error}");
    let malformed = |change: &dyn Fn(&mut Document), says: &str| {
        let error = broken(change);
        assert!(matches!(&error, FileError::Malformed(reason) if reason.contains(says)), "{error}");
    };
    malformed(&|d| d.root["nodes"][0]["children"] = json!([0]), "trees");
    malformed(&|d| d.root["asset"]["version"] = json!("1.0"), "version");
    malformed(&|d| d.root["nodes"][0]["matrix"] = json!([1, 2, 3]), "not valid");
    malformed(&|d| d.root["nodes"][0]["translation"] = json!([1e39, 0, 0]), "out of range");
    malformed(&|d| d.root["accessors"][0]["componentType"] = json!(1234), "component type");
    malformed(&|d| d.root["accessors"][0]["type"] = json!("VEC2"), "components");
    malformed(&|d| d.root["bufferViews"][0]["byteStride"] = json!(2), "stride");
    malformed(&|d| d.primitive()["mode"] = json!(12), "mode");
    malformed(&|d| d.root["materials"] = json!([{"alphaMode": "MAYBE"}]), "alphaMode");
    let error = broken(&|d| d.root["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]));
    assert_eq!(error, FileError::RequiredExtension { name: "KHR_draco_mesh_compression".into() });
    let error = textured(b"no picture", json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})).load();
    assert!(matches!(error, Err(FileError::Image { .. })), "{error:?}");
    assert!(matches!(broken(&|d| d.root["nodes"] = json!([{}])), FileError::NoTriangles(_)));
}

#[test]
fn broken_containers_and_missing_buffers_give_the_reason() {
    let glb = Document::triangle().glb();
    for length in 0..glb.len() {
        let error = load_bytes("glb", &glb[..length]).expect_err("a truncated file must fail");
        let fits = matches!(error, FileError::Truncated { .. })
            || (length < 4 && matches!(error, FileError::WrongMagic { .. }));
        assert!(fits, "{length}: {error}");
    }
    assert!(matches!(load_bytes("glb", b"PNG\0 no glTF at all"), Err(FileError::WrongMagic { .. })));
    let with_word = |at: usize, word: u32| {
        let mut bytes = glb.clone();
        bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
        load_bytes("glb", &bytes).expect_err("must fail")
    };
    assert!(matches!(with_word(4, 1), FileError::Malformed(r) if r.contains("version 1")));
    assert!(matches!(with_word(8, u32::MAX), FileError::Truncated { .. }));
    assert!(matches!(with_word(12, u32::MAX), FileError::Truncated { .. }));
    assert!(matches!(with_word(16, 0), FileError::Malformed(_)));
    assert!(matches!(load_bytes("gltf", b"{ not json"), Err(FileError::Malformed(_))));
    for uri in ["missing.bin", "http://example.org/a.bin", "data:;base64,%%%", "data:"] {
        let error = load_bytes("gltf", Document::triangle().with_buffer_uri(uri).as_bytes()).unwrap_err();
        assert!(matches!(&error, FileError::ExternalFile { uri: named, .. } if named == uri), "{error}");
    }
    let short = Document::triangle().with_buffer_uri("data:,abc");
    assert!(matches!(load_bytes("gltf", short.as_bytes()), Err(FileError::Truncated { needed: 36, available: 3, .. })));
    let options = LoadOptions { max_triangles: 1000, ..LoadOptions::default() };
    if let Some(path) = real_scene("concert_hall.glb") {
        let error = load(path.to_str().unwrap(), &options).unwrap_err();
        assert!(matches!(error, SceneError::File { reason: FileError::TooLarge { limit: 1000, .. }, .. }), "{error}");
    }
}

const OBJ: &str = "mtllib box.mtl\no box\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0.25\nvn 0 0 2\n";

fn load_obj(statements: &str, mtl: &str) -> Result<Scene, FileError> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("box.mtl"), mtl).unwrap();
    std::fs::write(folder.path().join("tile.png"), png(2, 2, |x, y| [9, 9, 9, 255 * ((x + y) % 2) as u8])).unwrap();
    load_in(folder.path(), "obj", format!("{OBJ}{statements}").as_bytes())
}

#[test]
fn obj_faces_materials_and_textures_are_read() {
    let mtl = "newmtl lamp # a comment\nKd 0.5 0.25 0.125\nKe 3 2 1\n\nnewmtl tiles\nKd 1\nmap_Kd -s 1 1 1 tile.png\n\
        newmtl leaf\nmap_d tile.png\nnewmtl glass\nd 0.2\n";
    let faces = "usemtl lamp\nf 1/1/1 2/2/1 3//1 4//1\nusemtl tiles\nf -4/1 -3/2 -2/2\nusemtl leaf\nf 1 2 3\n\
        usemtl glass\nf 1 2 \\\n 3\nl 1 2\n";
    let scene = load_obj(faces, mtl).unwrap_or_else(|e| panic!("{e}"));
    check_consistency(&scene);
    assert_eq!(scene.triangles.len(), 4);
    assert_eq!(dropped(&scene, "glass"), 1);
    let material = |i: usize| &scene.materials[scene.triangles[i].material as usize];
    assert_eq!((material(0).albedo, material(0).emission), (Vec3::new(0.5, 0.25, 0.125), Vec3::new(3.0, 2.0, 1.0)));
    assert_eq!((material(2).albedo, material(2).alpha), (Vec3::ONE, Alpha::Opaque));
    assert!(material(2).texture.is_some());
    assert_eq!(material(3).alpha, Alpha::Mask(0.5));
    assert_eq!(scene.uvs[scene.triangles[0].vertices[1] as usize], Vec2::new(1.0, 0.75), "v points up in OBJ");
    assert_eq!(normals(&scene, 0), (Vec3::Z, Vec3::Z));
    assert_eq!(scene.corners(&scene.triangles[2]), [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0)]);
    assert!(scene.notes.iter().any(|n| n.contains("lines")), "{:?}", scene.notes);
}

#[test]
fn obj_without_its_library_or_material_is_grey_and_says_so() {
    let scene = load_bytes("obj", b"mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl x\nf 1 2 3\n").unwrap();
    check_consistency(&scene);
    let said = |what: &str| assert!(scene.notes.iter().any(|n| n.contains(what)), "{what}: {:?}", scene.notes);
    said("gone.mtl");
    said("`x` is not defined");
    said("no camera");
    let scene = load_obj("usemtl t\nf 1 2 3\n", "newmtl t\nmap_Kd tile.png\n").unwrap();
    assert_eq!(
        scene.materials[scene.triangles[0].material as usize].albedo,
        Vec3::ONE,
        "a picture alone is the colour"
    );
    let scene = load_obj("usemtl t\nf 1 2 3\n", "newmtl t\nmap_Kd gone.png\n").unwrap();
    assert!(scene.notes.iter().any(|n| n.contains("gone.png")), "{:?}", scene.notes);
}

#[test]
fn obj_takes_several_libraries_on_one_line_and_names_with_blanks() {
    let at = tempfile::tempdir().unwrap();
    std::fs::write(at.path().join("a.mtl"), "newmtl one\nKd 0.1 0.2 0.3\n").unwrap();
    std::fs::write(at.path().join("b.mtl"), "newmtl two\nKd 0.4 0.5 0.6\n").unwrap();
    std::fs::write(at.path().join("my box.mtl"), "newmtl three\nKd 0.7 0.8 0.9\n").unwrap();
    let text = "mtllib a.mtl b.mtl\nmtllib my box.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n\
                usemtl one\nf 1 2 3\nusemtl two\nf 1 2 3\nusemtl three\nf 1 2 3\n";
    let scene = load_in(at.path(), "obj", text.as_bytes()).unwrap();
    let albedo: Vec<f32> = scene.triangles.iter().map(|t| scene.materials[t.material as usize].albedo.x).collect();
    assert_eq!(albedo, [0.1, 0.4, 0.7], "{:?}", scene.notes);
}

#[test]
fn broken_obj_gives_the_line_and_the_reason() {
    for (statements, index) in
        [("f 1 2 5\n", 5), ("f 0 1 2\n", 0), ("f -5 1 2\n", -5), ("f 1/3 2 3\n", 3), ("f 1//9 2 3\n", 9)]
    {
        let error = load_obj(statements, "").unwrap_err();
        assert!(
            matches!(&error, FileError::OutOfRange { what, index: i, .. } if what.starts_with("line 10") && *i == index),
            "{error}"
        );
    }
    for (statements, says) in [
        ("v 1 2\n", "3 numbers"),
        ("v one 2 3\n", "`one` is not a number"),
        ("f a b c\n", "`a` is not an index"),
        ("f /1 2 3\n", "corner"),
        ("f 1/1/1/1 2 3\n", "corner"),
        ("vn 1\n", "3 numbers"),
    ] {
        let error = load_obj(statements, "").unwrap_err();
        assert!(matches!(&error, FileError::Malformed(r) if r.starts_with("line 10") && r.contains(says)), "{error}");
    }
    let error = load_obj("f 1 2 3\n", "newmtl a\nKd 1 2\n").unwrap_err();
    assert!(matches!(&error, FileError::Malformed(r) if r.contains("box.mtl") && r.contains("colour")), "{error}");
    let error = load_obj("v nan 0 0\nf 1 2 3\n", "").unwrap_err();
    assert!(matches!(&error, FileError::BadVertex { mesh, vertex: 4, .. } if mesh == "box"), "{error}");
    assert!(matches!(load_obj("", ""), Err(FileError::NoTriangles(_))));
}
