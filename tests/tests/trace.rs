//! Rays of the kernels against closed meshes, against obvhs' own traversal, and against closed forms of light.

use glam::{DVec3, Vec2, Vec3};
use interreflect::exec::{CpuExecutor, ExecutorExt};
use interreflect::scene::device::{PackedScene, SceneBuffers};
use interreflect::scene::{Alpha, Camera, Light, LoadOptions, Material, Scene, Texture, Triangle, Wrap};
use interreflect::shading::{self, DirectSettings};
use interreflect_kernels::trace::light::{DirectSampling, environment_irradiance, lambert};
use interreflect_kernels::trace::{
    Hit, Ray, Receiver, SceneRef, any_hit, closest_hit, direct_irradiance, leave_surface, light_irradiance, surface,
};
use interreflect_shared::scene::{NO_SURFACE, Surfel};
use obvhs::BvhBuildParams;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use rayon::prelude::*;
use std::f32::consts::PI;

/// Numbers of a seeded sequence (PCG, O'Neill 2014).
struct Numbers(u64);

impl Numbers {
    fn bits(&mut self) -> u32 {
        let old = self.0;
        self.0 = old.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((((old >> 18) ^ old) >> 27) as u32).rotate_right((old >> 59) as u32)
    }
    fn new(seed: u64) -> Self {
        let mut numbers = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        numbers.bits();
        numbers
    }
    fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / 16_777_216.0
    }
    fn below(&mut self, count: usize) -> usize {
        ((u64::from(self.bits()) * count as u64) >> 32) as usize
    }
    fn in_cube(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
    fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.in_cube();
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

fn material(albedo: Vec3) -> Material {
    Material {
        name: "plain".into(),
        albedo,
        texture: None,
        wrap: [Wrap::Repeat; 2],
        alpha_factor: 1.0,
        alpha: Alpha::Opaque,
        emission: Vec3::ZERO,
        metallic: 0.0,
        roughness: 1.0,
    }
}

/// A scene of one material from corners and indices.
fn mesh(positions: Vec<Vec3>, triangles: &[[u32; 3]]) -> Scene {
    Scene {
        normals: vec![Vec3::Y; positions.len()],
        uvs: vec![Vec2::ZERO; positions.len()],
        positions,
        triangles: triangles.iter().map(|&vertices| Triangle { vertices, material: 0 }).collect(),
        materials: vec![material(Vec3::splat(0.5))],
        ..Scene::default()
    }
}

/// A closed box, two triangles to a side.
fn closed_box(low: Vec3, high: Vec3) -> Scene {
    let corner = |k: u32| {
        let pick = |bit: u32, axis: usize| if k & bit == 0 { low[axis] } else { high[axis] };
        Vec3::new(pick(1, 0), pick(2, 1), pick(4, 2))
    };
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles: Vec<[u32; 3]> = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    mesh((0..8).map(corner).collect(), &triangles)
}

/// A sphere of 20·4ⁿ triangles around a point.
fn icosphere(centre: Vec3, radius: f32, subdivisions: u32) -> Scene {
    let g = (1.0 + 5f32.sqrt()) / 2.0;
    let mut positions: Vec<Vec3> = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ]
    .map(|p| Vec3::from(p).normalize())
    .to_vec();
    let mut triangles: Vec<[u32; 3]> = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    for _ in 0..subdivisions {
        let mut middles = std::collections::HashMap::new();
        let mut middle = |a: u32, b: u32, positions: &mut Vec<Vec3>| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                positions.push((positions[a as usize] + positions[b as usize]).normalize());
                positions.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) =
                    (middle(a, b, &mut positions), middle(b, c, &mut positions), middle(c, a, &mut positions));
                [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
            })
            .collect();
    }
    mesh(positions.iter().map(|&p| centre + p * radius).collect(), &triangles)
}

/// A point of a triangle's inside, of an edge, or a corner.
fn target(scene: &Scene, numbers: &mut Numbers) -> Vec3 {
    let [a, b, c] = scene.corners(&scene.triangles[numbers.below(scene.triangles.len())]);
    match numbers.below(4) {
        0 => a,
        1 => a + (b - a) * numbers.unit(),
        2 => (a + b) * 0.5,
        _ => {
            let (u, v) = (numbers.unit(), numbers.unit());
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            a + (b - a) * u + (c - a) * v
        }
    }
}

/// Rays from inside a closed mesh that leave it: half in any direction, half aimed at corners, edges and faces.
fn leaks(scene: &Scene, rays: usize, inside: impl Fn(&mut Numbers) -> Vec3 + Sync) -> Vec<Ray> {
    const BATCH: usize = 10_000;
    let packed = PackedScene::new(scene);
    let view = packed.view();
    (0..rays / BATCH)
        .into_par_iter()
        .flat_map_iter(|batch| {
            let mut numbers = Numbers::new(batch as u64 + 1);
            (0..BATCH).filter_map(|k| leak(&view, scene, inside(&mut numbers), k, &mut numbers)).collect::<Vec<Ray>>()
        })
        .collect()
}

/// Ray `k` from a point inside, where it leaves the mesh.
fn leak(view: &SceneRef<'_>, scene: &Scene, origin: Vec3, k: usize, numbers: &mut Numbers) -> Option<Ray> {
    let direction = match k % 4 {
        0 => numbers.direction(),
        1 => (target(scene, numbers) - origin).normalize(),
        // Not normalized: the line meets the target as exactly as floats can say.
        2 => target(scene, numbers) - origin,
        // Along an axis, or in a plane of two: zero components.
        _ => {
            let plane = [Vec3::X, Vec3::Y, Vec3::new(1.0, 0.0, 1.0)][numbers.below(3)];
            (numbers.direction() * plane).try_normalize()?
        }
    };
    let ray = Ray::new(origin, direction);
    let closest = closest_hit(view, &ray).is_some();
    assert_eq!(closest, any_hit(view, &ray), "closest and any hit differ: {ray:?}");
    (!closest).then_some(ray)
}

#[test]
fn no_ray_leaves_a_closed_box() {
    let (low, high) = (Vec3::new(-1.0, -0.5, -2.0), Vec3::new(1.5, 0.75, 1.0));
    let scene = closed_box(low, high);
    let inside = |n: &mut Numbers| low + (high - low) * (n.in_cube() * 0.499 + 0.5);
    assert_eq!(leaks(&scene, 10_000_000, inside), []);
}

#[test]
fn no_ray_leaves_a_closed_sphere() {
    let scene = icosphere(Vec3::ZERO, 1.0, 4);
    assert_eq!(scene.triangles.len(), 5120);
    assert_eq!(leaks(&scene, 10_000_000, |n| n.direction() * (n.unit() * 0.99)), []);
}

/// Distance and weights of a ray's line with a triangle, in double precision (Möller & Trumbore 1997).
fn exact_hit(ray: &Ray, corners: [Vec3; 3]) -> (f64, [f64; 3]) {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    let (o, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let (e1, e2, s): (DVec3, DVec3, DVec3) = (b - a, c - a, o - a);
    let p = d.cross(e2);
    let det = e1.dot(p);
    let q = s.cross(e1);
    let (u, v) = (s.dot(p) / det, d.dot(q) / det);
    (e2.dot(q) / det, [1.0 - u - v, u, v])
}

/// What two walks of the same rays found.
#[derive(Default, Debug)]
struct Agreement {
    rays: usize,
    /// Both miss, or both hit at the same distance.
    same: usize,
    /// Ours is nearer, and double precision confirms that the ray meets that triangle or passes within rounding.
    ours_confirmed: usize,
    /// Theirs is nearer, and the ray passes its triangle's outline within rounding.
    theirs_on_edge: usize,
}

/// Compares closest hits with obvhs' own traversal and triangle test.
fn agreement(scene: &Scene, rays: &[Ray]) -> Agreement {
    const DISTANCE: f32 = 1e-4;
    const EDGE: f64 = 1e-4;
    let packed = PackedScene::new(scene);
    let corners: Vec<[Vec3; 3]> = scene.triangles.iter().map(|t| scene.corners(t)).collect();
    let theirs: Vec<obvhs::triangle::Triangle> = corners
        .iter()
        .map(|&[a, b, c]| obvhs::triangle::Triangle { v0: a.into(), v1: b.into(), v2: c.into() })
        .collect();
    let bvh = build_cwbvh_from_tris(&theirs, BvhBuildParams::medium_build(), &mut std::time::Duration::default());
    let mut result = Agreement { rays: rays.len(), ..Agreement::default() };
    for ray in rays {
        let hit = closest_hit(&packed.view(), ray);
        let mut other = RayHit::none();
        let other_ray = obvhs::ray::Ray::new_inf(ray.origin.into(), ray.direction.into());
        bvh.ray_traverse(other_ray, &mut other, |r, k| theirs[bvh.primitive_indices[k] as usize].intersect(r));
        let other_t = other.t.min(f32::MAX);
        if (hit.t - other_t).abs() <= DISTANCE * (1.0 + hit.t.min(other_t)) || hit.t == other_t {
            result.same += 1;
        } else if hit.t < other_t {
            let source = packed.triangles[hit.triangle as usize].source;
            let (t, weights) = exact_hit(ray, corners[source as usize]);
            let near = (t - f64::from(hit.t)).abs() < 1e-3 * (1.0 + t) && weights.iter().all(|&w| w > -EDGE);
            assert!(near, "a hit at {} that is none: {t} {weights:?} {ray:?}", hit.t);
            result.ours_confirmed += 1;
        } else {
            let source = bvh.primitive_indices[other.primitive_id as usize];
            let (t, weights) = exact_hit(ray, corners[source as usize]);
            let on_edge = weights.iter().any(|&w| w.abs() < EDGE) || t < 1e-4;
            assert!(on_edge, "missed a hit at {} by far: {t} {weights:?} {ray:?}", other.t);
            result.theirs_on_edge += 1;
        }
    }
    result
}

#[test]
fn hits_agree_with_another_traversal_on_random_triangles() {
    for (seed, size) in [(1, 0.02), (2, 0.2), (3, 2.0)] {
        let mut numbers = Numbers::new(seed);
        let positions: Vec<Vec3> = (0..5_000)
            .flat_map(|_| {
                let centre = numbers.in_cube();
                [(); 3].map(|()| centre + numbers.in_cube() * size)
            })
            .collect();
        let triangles: Vec<[u32; 3]> = (0..5_000).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
        let scene = mesh(positions, &triangles);
        let rays: Vec<Ray> = (0..100_000).map(|_| Ray::new(numbers.in_cube() * 1.5, numbers.direction())).collect();
        let result = agreement(&scene, &rays);
        println!("random triangles of size {size}: {result:?}");
        assert!(result.ours_confirmed + result.theirs_on_edge <= result.rays / 1000, "{result:?}");
    }
}

#[test]
fn hits_agree_with_another_traversal_on_sponza() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/scenes/crytek_sponza.glb");
    if !std::path::Path::new(path).exists() {
        println!("skipped: no {path}");
        return;
    }
    let mut scene = interreflect::scene::load(path, &LoadOptions::default()).expect("the scene loads");
    // The other walk knows no alpha.
    scene.materials.iter_mut().for_each(|m| m.alpha = Alpha::Opaque);
    let mut numbers = Numbers::new(5);
    let mut rays: Vec<Ray> = (0..60_000)
        .map(|_| {
            Ray::new(Vec3::new(numbers.unit() * 20.0 - 10.0, 0.5 + numbers.unit() * 8.0, 0.0), numbers.direction())
        })
        .collect();
    let packed = PackedScene::new(&scene);
    let bounced: Vec<Ray> = rays.iter().filter_map(|ray| bounce(&packed.view(), ray, &mut numbers)).collect();
    rays.extend(bounced);
    assert!(rays.len() >= 100_000);
    let result = agreement(&scene, &rays);
    println!("Sponza: {result:?}");
    assert!(result.ours_confirmed + result.theirs_on_edge <= result.rays / 2000, "{result:?}");
}

/// A ray in a random direction from where `ray` hits.
fn bounce(view: &SceneRef<'_>, ray: &Ray, numbers: &mut Numbers) -> Option<Ray> {
    let hit = closest_hit(view, ray);
    hit.is_some().then(|| {
        let s = surface(view, ray, &hit);
        let (position, normal) = (Vec3::from(s.position), Vec3::from(s.geometric_normal));
        let direction = (normal + numbers.direction() * 0.999).normalize();
        Ray::new(leave_surface(position, normal, s.error, direction), direction)
    })
}

#[test]
fn rays_that_leave_a_surface_do_not_meet_it_again() {
    let mut numbers = Numbers::new(7);
    // Size of the triangle and its distance from the world's origin, from millimetres to 100 km.
    for (size, away) in [(1e-3, 0.0), (1.0, 0.0), (1e-3, 1.0), (1.0, 1e3), (100.0, 0.0), (10.0, 1e5), (1e5, 0.0)] {
        let mut again = 0;
        for _ in 0..20_000 {
            let centre = numbers.in_cube() * away;
            // Every third triangle is a needle.
            let thin = if numbers.below(3) == 0 { 1e-3 } else { 1.0 };
            let (e1, e2) = (numbers.direction() * size, numbers.direction() * size * thin);
            let packed = PackedScene::new(&mesh(vec![centre, centre + e1, centre + e2], &[[0, 1, 2]]));
            if packed.triangles[0].v0 == packed.triangles[0].v2 {
                continue; // too thin for floats at this place
            }
            let (u, v) = (numbers.unit() * 0.5, numbers.unit() * 0.5);
            let hit = Hit { t: 1.0, triangle: 0, u, v };
            let s = surface(&packed.view(), &Ray::new(centre, numbers.direction()), &hit);
            let normal = Vec3::from(s.geometric_normal);
            // Grazing directions too.
            let tilt = normal * numbers.unit() * if numbers.below(2) == 0 { 1.0 } else { 0.01 };
            let direction = (normal.any_orthonormal_vector() * (numbers.unit() - 0.5) + tilt).normalize_or(normal);
            let start = leave_surface(Vec3::from(s.position), normal, s.error, direction);
            again += u32::from(closest_hit(&packed.view(), &Ray::new(start, direction)).is_some());
            // The offset stays small: at most two hundred-thousandths of the triangle and of its place.
            assert!(s.error <= 2e-5 * (size + away * 1.8), "{} at size {size}, {away} away", s.error);
        }
        assert_eq!(again, 0, "size {size}, {away} away");
    }
}

#[test]
fn weights_give_the_position_and_the_normal_faces_the_viewer() {
    let scene = icosphere(Vec3::new(1.0, 2.0, 3.0), 2.0, 2);
    let packed = PackedScene::new(&scene);
    let mut numbers = Numbers::new(11);
    for k in 0..10_000 {
        // From inside and from outside.
        let origin = Vec3::new(1.0, 2.0, 3.0) + numbers.direction() * if k % 2 == 0 { 1.5 } else { 4.0 };
        let ray = Ray::new(origin, (Vec3::new(1.0, 2.0, 3.0) + numbers.in_cube() - origin).normalize());
        let hit = closest_hit(&packed.view(), &ray);
        assert!(hit.is_some());
        let s = surface(&packed.view(), &ray, &hit);
        let along = ray.origin + ray.direction * hit.t;
        assert!((Vec3::from(s.position) - along).length() < 3e-6 * (1.0 + hit.t));
        assert!(Vec3::from(s.geometric_normal).dot(ray.direction) < 0.0);
        assert!(Vec3::from(s.normal).dot(ray.direction) <= 0.0);
        assert_eq!(s.front == 1, k % 2 == 1, "the front is outside");
    }
}

/// A quad of two triangles at height `z`, facing +z, with texture coordinates from 0 to 1.
fn quad(scene: &mut Scene, half: f32, z: f32, material: u32) {
    let first = scene.positions.len() as u32;
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        scene.positions.push(Vec3::new(x * half, y * half, z));
        scene.normals.push(Vec3::Z);
        scene.uvs.push(Vec2::new((x + 1.0) * 0.5, (1.0 - y) * 0.5));
    }
    for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
        scene.triangles.push(Triangle { vertices: [first + a, first + b, first + c], material });
    }
}

#[test]
fn masked_texels_let_rays_pass_and_textures_are_filtered_in_linear_light() {
    let mut scene = Scene::default();
    // Left half opaque red, right half transparent green; a plain white wall behind.
    scene.textures.push(Texture { width: 2, height: 1, srgba: vec![[188, 0, 0, 255], [0, 188, 0, 0]] });
    let leaf = Material { texture: Some(0), alpha: Alpha::Mask(0.5), ..material(Vec3::ONE) };
    scene.materials = vec![leaf, material(Vec3::ONE)];
    quad(&mut scene, 1.0, 0.0, 0);
    quad(&mut scene, 2.0, -1.0, 1);
    let packed = PackedScene::new(&scene);
    let mut numbers = Numbers::new(3);
    for _ in 0..10_000 {
        let (x, y) = (numbers.unit() * 1.98 - 0.99, numbers.unit() * 1.98 - 0.99);
        let ray = Ray::new(Vec3::new(x, y, 3.0), -Vec3::Z);
        let hit = closest_hit(&packed.view(), &ray);
        // Alpha is 1 at the left texel's centre u = 0.25, 0 at 0.75, linear between, and wraps around.
        let u = (x + 1.0) * 0.5;
        let alpha = if u < 0.25 {
            0.5 + 2.0 * u
        } else if u < 0.75 {
            1.5 - 2.0 * u
        } else {
            2.0 * u - 1.5
        };
        if (alpha - 0.5f32).abs() < 1e-4 {
            continue;
        }
        assert_eq!((hit.t - 3.0).abs() < 1e-5, alpha > 0.5, "{x}: alpha {alpha}, distance {}", hit.t);
        if alpha > 0.5 {
            let albedo = Vec3::from(surface(&packed.view(), &ray, &hit).albedo);
            // sRGB 188 is 0.5029 in linear light.
            assert!((albedo - Vec3::new(0.5029 * alpha, 0.5029 * (1.0 - alpha), 0.0)).abs().max_element() < 2e-4);
        }
        let shadow = Ray::until(Vec3::new(x, y, 3.0), -Vec3::Z, 3.5);
        assert_eq!(any_hit(&packed.view(), &shadow), alpha > 0.5);
    }
}

#[test]
fn textures_beyond_their_sides_and_vertex_colours_reflect_as_they_are_told_to() {
    // Texture coordinates from −1 to 2 over the quad, of a texture that is black on its left and 1 on its right.
    let mut scene = Scene::default();
    scene.textures.push(Texture { width: 2, height: 1, srgba: vec![[0, 0, 0, 255], [255, 255, 255, 255]] });
    scene.materials.push(material(Vec3::ONE));
    quad(&mut scene, 1.0, 0.0, 0);
    scene.uvs.iter_mut().for_each(|uv| *uv = *uv * 3.0 - 1.0);
    // A texel's centre is at 0.25, the other's at 0.75; between them it is a straight line.
    let within = |u: f32| (2.0 * u - 0.5).clamp(0.0, 1.0);
    let expected = |wrap: Wrap, u: f32| match wrap {
        Wrap::Clamp => within(u.clamp(0.0, 1.0)),
        Wrap::Mirror => within(if u < 0.0 {
            -u
        } else if u > 1.0 {
            2.0 - u
        } else {
            u
        }),
        Wrap::Repeat => {
            let u = u - u.floor();
            if u < 0.25 {
                0.5 - 2.0 * u
            } else if u > 0.75 {
                2.5 - 2.0 * u
            } else {
                within(u)
            }
        }
    };
    let mut numbers = Numbers::new(5);
    for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror] {
        scene.materials[0] = Material { texture: Some(0), wrap: [wrap, Wrap::Clamp], ..material(Vec3::ONE) };
        let packed = PackedScene::new(&scene);
        for _ in 0..2000 {
            let (x, y) = (numbers.unit() * 1.98 - 0.99, numbers.unit() * 1.98 - 0.99);
            let ray = Ray::new(Vec3::new(x, y, 3.0), -Vec3::Z);
            let albedo = surface(&packed.view(), &ray, &closest_hit(&packed.view(), &ray)).albedo;
            let u = (x + 1.0) * 1.5 - 1.0;
            assert!((albedo[0] - expected(wrap, u)).abs() < 1e-4, "{wrap:?} at {u}: {albedo:?}");
        }
    }
    // Colours grow from the left to the right in every channel, in linear light.
    scene.materials[0] = material(Vec3::new(1.0, 0.5, 1.0));
    let (left, right) = (Vec3::new(0.0, 1.0, 0.02), Vec3::new(1.0, 0.2, 0.06));
    scene.colours = scene.positions.iter().map(|p| if p.x < 0.0 { left } else { right }).collect();
    let packed = PackedScene::new(&scene);
    for _ in 0..2000 {
        let (x, y) = (numbers.unit() * 1.98 - 0.99, numbers.unit() * 1.98 - 0.99);
        let ray = Ray::new(Vec3::new(x, y, 3.0), -Vec3::Z);
        let albedo = Vec3::from(surface(&packed.view(), &ray, &closest_hit(&packed.view(), &ray)).albedo);
        let expected = left.lerp(right, (x + 1.0) * 0.5) * Vec3::new(1.0, 0.5, 1.0);
        let off = (albedo - expected).abs();
        assert!(off.max_element() < 1e-3 && off.z < 3e-4, "{albedo} is not {expected}");
    }
}

fn facing_up(position: Vec3) -> Receiver {
    Receiver { position, normal: Vec3::Z, geometric_normal: Vec3::Z, error: 0.0 }
}

#[test]
fn lights_without_extent_follow_their_laws_and_cast_shadows() {
    let mut scene = Scene { materials: vec![material(Vec3::ONE)], ..Scene::default() };
    quad(&mut scene, 1.0, 1.0, 0); // a shade over |x|, |y| < 1
    let intensity = Vec3::new(4.0, 2.0, 1.0);
    let at = Vec3::new(0.0, 0.0, 2.0);
    scene.lights = vec![
        Light::Point { position: at, intensity },
        Light::Spot { position: at, direction: -Vec3::Z, intensity, cos_inner: 0.9, cos_outer: 0.5 },
        Light::Directional { direction: Vec3::new(0.6, 0.0, -0.8), irradiance: intensity },
    ];
    let packed = PackedScene::new(&scene);
    let irradiance = |k: usize, x: f32| {
        light_irradiance(&packed.view(), &packed.lights[k], &facing_up(Vec3::new(x, 0.0, 0.0)), 4, 1)
    };
    // The point light's shadow reaches to x = 2; the sun's lies over -0.25 .. 1.75.
    assert_eq!((irradiance(0, 1.9), irradiance(1, 1.9), irradiance(2, 1.7)), (Vec3::ZERO, Vec3::ZERO, Vec3::ZERO));
    let (d2, cos) = (4.0 + 2.1f32 * 2.1, 2.0 / (4.0 + 2.1f32 * 2.1).sqrt());
    assert!((irradiance(0, 2.1) / (intensity * cos / d2) - 1.0).abs().max_element() < 1e-5);
    let ramp = (cos - 0.5) / 0.4;
    assert!((irradiance(1, 2.1) / (intensity * cos / d2 * ramp * ramp) - 1.0).abs().max_element() < 1e-4);
    assert_eq!(irradiance(1, 4.0), Vec3::ZERO, "outside the cone");
    assert!((irradiance(2, 1.8) / (intensity * 0.8) - 1.0).abs().max_element() < 1e-5);
}

/// A square lamp of half side 1 at height 1 that shines down, and a shade of half side `shade` at height 0.5.
fn lamp_scene(shade: f32) -> Scene {
    let mut scene = Scene::default();
    let lamp = Material { emission: Vec3::new(3.0, 2.0, 1.0), ..material(Vec3::ZERO) };
    scene.materials = vec![lamp, material(Vec3::ONE)];
    quad(&mut scene, 1.0, 1.0, 0);
    for t in &mut scene.triangles {
        t.vertices.swap(1, 2);
    }
    if shade > 0.0 {
        quad(&mut scene, shade, 0.5, 1);
    }
    scene
}

/// Form factor of a parallel rectangle a × b with a corner above the receiver, at height 1 (Howell's catalogue, C-11).
fn form_factor(a: f32, b: f32) -> f32 {
    let (ra, rb) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
    (a / ra * (b / ra).atan() + b / rb * (a / rb).atan()) / (2.0 * PI)
}

#[test]
fn an_unshadowed_lamp_gives_its_form_factor_without_noise() {
    let packed = PackedScene::new(&lamp_scene(0.0));
    let expected = Vec3::new(3.0, 2.0, 1.0) * PI * 4.0 * form_factor(1.0, 1.0);
    for scramble in 0..50 {
        let all: Vec3 = packed
            .lights
            .iter()
            .map(|l| light_irradiance(&packed.view(), l, &facing_up(Vec3::ZERO), 4, scramble))
            .sum();
        assert!((all / expected - 1.0).abs().max_element() < 1e-5, "{all} {expected}");
    }
    let behind = Receiver { position: Vec3::new(0.0, 0.0, 2.0), normal: -Vec3::Z, ..facing_up(Vec3::ZERO) };
    let back: Vec3 = packed.lights.iter().map(|l| light_irradiance(&packed.view(), l, &behind, 16, 3)).sum();
    assert_eq!(back, Vec3::ZERO, "a lamp shines on its front alone");
}

#[test]
fn a_distant_lamp_and_a_half_set_one_agree_with_area_integration() {
    let (a, b, c) = (Vec3::new(-1.0, -1.0, 1.0), Vec3::new(1.0, 1.0, 1.0), Vec3::new(1.0, -1.0, 1.0));
    let packed = PackedScene::new(&lamp_scene(0.0));
    // Far below (area samples), and tilted so that the horizon cuts the lamp (Lambert's sum).
    for (position, normal) in [
        (Vec3::new(3.0, 2.0, -40.0), Vec3::Z),
        (Vec3::ZERO, Vec3::new(1.0, 0.3, 0.05).normalize()),
        (Vec3::new(0.3, 0.2, -1.0), Vec3::new(-0.9, 0.1, 0.4).normalize()),
    ] {
        let mut sum = 0.0;
        const STEPS: usize = 1000;
        for i in 0..STEPS {
            for j in 0..STEPS {
                let p = DVec3::new(
                    (i as f64 + 0.5) / STEPS as f64 * 2.0 - 1.0,
                    (j as f64 + 0.5) / STEPS as f64 * 2.0 - 1.0,
                    1.0,
                ) - position.as_dvec3();
                let r2 = p.length_squared();
                sum += (p.dot(normal.as_dvec3())).max(0.0) * p.z / (r2 * r2) * 4.0 / (STEPS * STEPS) as f64;
            }
        }
        let at = Receiver { position, normal, geometric_normal: normal, error: 0.0 };
        let all: f32 = packed.lights.iter().map(|l| light_irradiance(&packed.view(), l, &at, 64, 9).z).sum();
        assert!((f64::from(all) / sum - 1.0).abs() < 2e-3, "{all} against {sum}");
    }
    let whole = lambert(Vec3::ZERO, Vec3::Z, a, b, c);
    assert!((whole / (2.0 * PI * form_factor(1.0, 1.0)) - 1.0).abs() < 1e-5);
}

#[test]
fn a_half_hidden_lamp_converges_to_what_is_seen_of_it() {
    // From the origin the shade of half side 0.25 at 0.5 hides the middle square of half side 0.5.
    let packed = PackedScene::new(&lamp_scene(0.25));
    let expected = PI * 4.0 * (form_factor(1.0, 1.0) - form_factor(0.5, 0.5));
    let environment = Vec3::ZERO;
    let sampling =
        DirectSampling { light_count: 2, light_samples: 256, pick_above: 64, environment, environment_samples: 0 };
    let picking = DirectSampling { light_samples: 4096, pick_above: 0, ..sampling };
    for sampling in [sampling, picking] {
        let e = direct_irradiance(&packed.view(), &packed.lights, &sampling, &facing_up(Vec3::ZERO), 5);
        assert!((e.z / expected - 1.0).abs() < 0.02, "{} against {expected}", e.z);
    }
}

#[test]
fn the_environment_is_seen_where_nothing_hides_it() {
    let open = PackedScene::new(&Scene::default());
    assert!((environment_irradiance(&open.view(), &facing_up(Vec3::ZERO), 16, 1) / PI - 1.0).abs() < 1e-6);
    let mut scene = Scene { materials: vec![material(Vec3::ONE)], ..Scene::default() };
    quad(&mut scene, 1.0, 1.0, 0);
    let packed = PackedScene::new(&scene);
    let e = environment_irradiance(&packed.view(), &facing_up(Vec3::ZERO), 4096, 1);
    assert!((e / (PI * (1.0 - 4.0 * form_factor(1.0, 1.0))) - 1.0).abs() < 0.01, "{e}");
}

#[test]
fn scenes_without_triangles_or_lights_are_legal() {
    let mut exec = CpuExecutor::new();
    let scene = Scene { environment: Vec3::new(1.0, 2.0, 3.0), ..Scene::default() };
    let buffers = SceneBuffers::upload(&mut exec, &scene).expect("an empty scene uploads");
    assert_eq!((buffers.triangle_count, buffers.light_count), (0, 0));
    let camera = Camera {
        name: "c".into(),
        node: String::new(),
        position: Vec3::ZERO,
        forward: -Vec3::Z,
        up: Vec3::Y,
        fovy_rad: 1.0,
    };
    let surfels = shading::gbuffer(&mut exec, &buffers, &camera, 5, 3, scene.environment).expect("runs");
    let settings = DirectSettings::default();
    let direct = shading::direct(&mut exec, &buffers, surfels, 15, scene.environment, &settings).expect("runs");
    let radiance = shading::compose(&mut exec, surfels, direct, direct, 15);
    assert!(radiance.is_err(), "one buffer bound twice");
    let indirect = exec.zeroed_slice::<glam::Vec4>("indirect", 15).expect("fits");
    let radiance = shading::compose(&mut exec, surfels, direct, indirect, 15).expect("runs");
    assert!(exec.read_slice::<Surfel>(surfels).expect("reads").iter().all(|s| s.triangle == NO_SURFACE));
    let radiance = exec.read_slice::<glam::Vec4>(radiance).expect("reads");
    assert!(radiance.iter().all(|p| p.truncate() == scene.environment));
}

#[test]
fn primary_rays_are_the_cameras() {
    let camera = Camera {
        name: "c".into(),
        node: String::new(),
        position: Vec3::new(1.0, 2.0, 3.0),
        forward: Vec3::new(0.6, 0.0, -0.8),
        up: Vec3::Y,
        fovy_rad: 0.9,
    };
    let params = shading::gbuffer_params(&camera, 7, 5, Vec3::ZERO);
    for i in 0..35 {
        let ray = interreflect_kernels::trace::gbuffer::primary_ray(i, &params);
        let (origin, direction) = camera.ray((i % 7) as f32 + 0.5, (i / 7) as f32 + 0.5, 7, 5);
        assert!(ray.origin == origin && (ray.direction - direction).length() < 2e-7);
    }
}
