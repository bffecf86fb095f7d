//! Import of scene files, built-in scenes, and the errors of both.

use glam::Vec3;
use interreflect::scene::{BUILT_IN, LoadOptions, Scene, Triangle, load};
use std::path::PathBuf;

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
