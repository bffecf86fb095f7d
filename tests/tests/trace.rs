//! Rays of the kernels against closed meshes, against obvhs' own traversal, and against closed forms of light.

use glam::{DVec3, Vec2, Vec3};
use interreflect::scene::device::PackedScene;
use interreflect::scene::{Alpha, Material, Scene, Texture, Triangle};
use interreflect_kernels::trace::{Ray, any_hit, closest_hit};
use interreflect_shared::scene::NO_SURFACE;
use rayon::prelude::*;

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
        (u64::from(self.bits()) * count as u64 >> 32) as usize
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
fn leaks(scene: &Scene, rays: usize, inside: impl Fn(&mut Numbers) -> Vec3 + Sync) -> usize {
    const BATCH: usize = 10_000;
    let packed = PackedScene::new(scene);
    let view = packed.view();
    (0..rays / BATCH)
        .into_par_iter()
        .map(|batch| {
            let mut numbers = Numbers::new(batch as u64 + 1);
            (0..BATCH)
                .filter(|k| {
                    let origin = inside(&mut numbers);
                    let direction = match k % 4 {
                        0 => numbers.direction(),
                        1 => (target(scene, &mut numbers) - origin).normalize(),
                        // Not normalized: the line meets the target as exactly as floats can say.
                        2 => target(scene, &mut numbers) - origin,
                        // Along an axis, or in a plane of two: zero components.
                        _ => numbers.direction() * [Vec3::X, Vec3::Y, Vec3::new(1.0, 0.0, 1.0)][numbers.below(3)],
                    };
                    let ray = Ray::new(origin, direction);
                    let closest = closest_hit(&view, &ray).is_some();
                    let any = any_hit(&view, &ray);
                    assert_eq!(closest, any, "closest and any hit differ: {ray:?}");
                    !closest
                })
                .count()
        })
        .sum()
}

#[test]
fn no_ray_leaves_a_closed_box() {
    let (low, high) = (Vec3::new(-1.0, -0.5, -2.0), Vec3::new(1.5, 0.75, 1.0));
    let scene = closed_box(low, high);
    let inside = |n: &mut Numbers| low + (high - low) * (n.in_cube() * 0.499 + 0.5);
    assert_eq!(leaks(&scene, 10_000_000, inside), 0);
}

#[test]
fn no_ray_leaves_a_closed_sphere() {
    let scene = icosphere(Vec3::ZERO, 1.0, 4);
    assert_eq!(scene.triangles.len(), 5120);
    assert_eq!(leaks(&scene, 10_000_000, |n| n.direction() * (n.unit() * 0.99)), 0);
}
