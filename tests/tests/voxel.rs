//! Voxelization against a brute-force f64 oracle, conservation, determinism, and what mipmaps keep.

use glam::{DVec3, UVec3, Vec3, Vec4};
use interreflect::exec::{CpuExecutor, Executor, ExecutorExt};
use interreflect::methods::voxels::{VoxelGrid, VoxelOptions, VoxelScene, exclusive_scan};
use interreflect::methods::{MethodError, StageClock};
use interreflect::scene::device::SceneBuffers;
use interreflect_kernels::cone::query::{ConeMarch, VoxelPyramid, trace_cone};
use interreflect_kernels::kernel::{CaseInput, Flavour};
use interreflect_kernels::voxel::grid::{pyramid, voxel_of};
use interreflect_kernels::voxel::mark::{voxel_mark, voxel_tiles};
use interreflect_shared::scene::{NO_TEXTURE, SRGB_TABLE_WORDS, SceneMaterial, SceneTriangle, TriangleAttributes};
use interreflect_shared::voxel::{FACET_KINDS, TILE, VoxelFacet, VoxelParams};
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

type Corners = [Vec3; 3];

fn scene_triangle([a, b, c]: Corners) -> SceneTriangle {
    SceneTriangle { v0: a.to_array(), material: 0, v1: b.to_array(), flags: 0, v2: c.to_array(), source: 0 }
}

/// Voxels that the kernels mark, each with its facet kinds as bits.
fn marked(params: &VoxelParams, triangles: &[Corners]) -> Vec<(UVec3, u32)> {
    let triangles: Vec<SceneTriangle> = triangles.iter().copied().map(scene_triangle).collect();
    let mut p = VoxelParams { triangle_count: triangles.len() as u32, ..*params };
    let mut counts = vec![0; triangles.len()];
    voxel_tiles::cpu(&p, &triangles, &mut counts);
    let mut first = Vec::new();
    for n in &counts {
        first.push(p.tile_count);
        p.tile_count += n;
    }
    let bits: Vec<AtomicU32> = (0..p.levels[0].w * FACET_KINDS).map(|_| AtomicU32::new(0)).collect();
    voxel_mark::cpu(&p, &triangles, &first, &bits);
    let mut found = Vec::new();
    for cell in 0..p.levels[0].w {
        let words: Vec<u32> = (0..FACET_KINDS).map(|k| bits[(cell * FACET_KINDS + k) as usize].load(Relaxed)).collect();
        for bit in 0..32 {
            let kinds = (0..FACET_KINDS).fold(0, |kinds, k| kinds | (words[k as usize] >> bit & 1) << k);
            if kinds != 0 {
                found.push((voxel_of(p.levels[0], cell, bit), kinds));
            }
        }
    }
    found
}

/// Distance between a triangle and a closed unit cube along the axis that separates them most (f64; negative where they
/// overlap): Akenine-Möller's thirteen axes, normalized.
fn separation(corners: [DVec3; 3], centre: DVec3) -> f64 {
    let v = corners.map(|c| c - centre);
    let edges = [v[1] - v[0], v[2] - v[1], v[0] - v[2]];
    let mut axes = vec![DVec3::X, DVec3::Y, DVec3::Z, edges[0].cross(edges[1])];
    axes.extend(edges.iter().flat_map(|e| [DVec3::X, DVec3::Y, DVec3::Z].map(|a| a.cross(*e))));
    axes.into_iter()
        .filter(|a| a.length() > 1e-9)
        .map(|axis| {
            let axis = axis.normalize();
            let reach = 0.5 * (axis.x.abs() + axis.y.abs() + axis.z.abs());
            let p = v.map(|c| axis.dot(c));
            let (low, high) = (p[0].min(p[1]).min(p[2]), p[0].max(p[1]).max(p[2]));
            (low - reach).max(-reach - high)
        })
        .fold(f64::MIN, f64::max)
}

/// Compares the kernels' voxels of one triangle with the oracle's; voxels nearer than `epsilon` to touching may differ.
fn compare_with_oracle(params: &VoxelParams, triangle: Corners, epsilon: f64) -> Result<usize, String> {
    let got: BTreeSet<[u32; 3]> = marked(params, &[triangle]).iter().map(|(v, _)| v.to_array()).collect();
    let origin = params.origin_size.truncate().as_dvec3();
    let size = f64::from(params.origin_size.w);
    let corners = triangle.map(|c| (c.as_dvec3() - origin) / size);
    let d = params.dims_levels;
    for z in 0..d.z {
        for y in 0..d.y {
            for x in 0..d.x {
                let gap = separation(corners, DVec3::new(x.into(), y.into(), z.into()) + 0.5);
                let is = got.contains(&[x, y, z]);
                // Axes are normalized in the oracle: what touches exactly is off by its rounding.
                if (is && gap > epsilon.max(1e-12))
                    || (!is && gap <= -epsilon.max(1e-12))
                    || (!is && epsilon == 0.0 && gap <= 0.0)
                {
                    return Err(format!("voxel ({x}, {y}, {z}) {is}, separation {gap:e}, triangle {corners:?}"));
                }
            }
        }
    }
    Ok(got.len())
}

#[test]
fn voxels_are_those_of_a_brute_force_oracle() {
    let dims = UVec3::new(40, 26, 33);
    let params = pyramid(Vec3::new(-3.1, 0.7, 10.0), 0.137, dims);
    let mut input = CaseInput::new(7, 0, Flavour::Ordinary);
    let mut voxels = 0;
    for k in 0..1500 {
        let mut point = || Vec3::new(input.unit(), input.unit(), input.unit());
        let centre = point();
        let spread = [0.01, 0.1, 0.4, 2.0, 1.5][k % 5];
        let mut c = [(); 3].map(|()| centre + (point() - 0.5) * spread);
        if k % 5 == 4 {
            // Slivers: a corner all but on the opposite edge, or three nearly in line.
            c[2] = c[0].lerp(c[1], point().x) + (point() - 0.5) * 10f32.powi(-(k as i32 / 5 % 7) - 1);
        }
        let world = c.map(|c| params.origin_size.truncate() + c * dims.as_vec3() * params.origin_size.w);
        voxels += compare_with_oracle(&params, world, 2e-4).unwrap();
    }
    assert!(voxels > 100_000, "only {voxels} voxels compared");
}

#[test]
fn closed_voxels_touch_triangles_in_their_sides() {
    // Coordinates that f32 holds exactly: every touching voxel, and no other.
    let params = pyramid(Vec3::ZERO, 0.5, UVec3::splat(16));
    let quarter = |v: [i32; 3]| Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32) * 0.25;
    let mut input = CaseInput::new(11, 0, Flavour::Ordinary);
    for k in 0..600 {
        let mut corner = || [(); 3].map(|()| (input.bits() % 32) as i32);
        let mut c = [corner(), corner(), corner()];
        // In a plane between voxels, or anywhere.
        let axis = k % 3;
        let on = 2 * (c[0][axis] / 2);
        if k % 4 < 3 {
            c.iter_mut().for_each(|v| v[axis] = on);
        }
        let triangle = c.map(quarter);
        if area(triangle) > 0.0 {
            compare_with_oracle(&params, triangle, 0.0).unwrap();
        }
    }
}

/// However large a triangle is, its work is cut into pieces of bounded size, and there are not many more pieces than
/// voxels need.
#[test]
fn one_huge_triangle_is_split_into_its_share_of_work() {
    let params = pyramid(Vec3::ZERO, 1.0, UVec3::splat(256));
    let at = |u: f32, v: f32| Vec3::new(2.0 + 252.0 * u, 2.0 + 252.0 * v, 60.0 + 75.6 * u);
    let wall = |n: usize| -> Vec<Corners> {
        let corner = |i: usize, j: usize| at(i as f32 / n as f32, j as f32 / n as f32);
        let quads = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        quads
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect()
    };
    let work = |triangles: &[Corners]| {
        let packed: Vec<SceneTriangle> = triangles.iter().copied().map(scene_triangle).collect();
        let mut tiles = vec![0; packed.len()];
        voxel_tiles::cpu(&params, &packed, &mut tiles);
        (tiles.iter().sum::<u32>(), marked(&params, triangles).len() as u32)
    };
    let ((huge_tiles, huge_voxels), (fine_tiles, fine_voxels)) = (work(&wall(1)), work(&wall(100)));
    println!("two triangles: {huge_tiles} tiles for {huge_voxels} voxels; 20 000: {fine_tiles} for {fine_voxels}");
    assert!(huge_voxels >= 253 * 253, "the wall is there: {huge_voxels}");
    // Each tile is one invocation of at most 4 × 4 columns; half of a diagonal triangle's tiles are empty.
    assert!(huge_tiles * TILE * TILE >= 2 * 252 * 252 && huge_tiles <= huge_voxels / 4, "{huge_tiles}");
    assert!(u64::from(huge_tiles) * u64::from(fine_voxels) <= 2 * u64::from(fine_tiles) * u64::from(huge_voxels));
}

#[test]
fn a_triangle_of_the_grids_size_has_its_voxels_at_512() {
    let params = pyramid(Vec3::ZERO, 1.0, UVec3::new(512, 512, 8));
    // A plane between two layers, over half of the grid; and a long thin one across it.
    let plane = [Vec3::new(0.0, 0.0, 4.0), Vec3::new(512.0, 0.0, 4.0), Vec3::new(0.0, 512.0, 4.0)];
    let found = marked(&params, &[plane]);
    // Closed columns below the diagonal: x + y ≤ 512 touches, in two layers.
    let expected = 2 * (0..512u32).map(|y| (513 - y).min(512)).sum::<u32>();
    assert_eq!(found.len() as u32, expected);
    let sliver = [Vec3::new(0.3, 0.2, 0.5), Vec3::new(511.4, 511.2, 7.5), Vec3::new(511.4, 511.21, 7.5)];
    compare_with_oracle(&params, sliver, 2e-4).unwrap();
}

proptest! {
    #[test]
    fn any_triangle_has_the_oracles_voxels(c in prop::array::uniform3(prop::array::uniform3(-4.0f32..20.0))) {
        let params = pyramid(Vec3::ZERO, 1.0, UVec3::splat(16));
        let result = compare_with_oracle(&params, c.map(Vec3::from_array), 2e-5);
        prop_assert!(result.is_ok(), "{}", result.unwrap_err());
    }

    #[test]
    fn moving_by_whole_voxels_moves_the_voxels(
        c in prop::array::uniform3(prop::array::uniform3(0u32..4096)),
        by in prop::array::uniform3(0u32..8),
    ) {
        // Multiples of 2⁻⁸ stay exact when they move.
        let params = pyramid(Vec3::ZERO, 1.0, UVec3::splat(24));
        let triangle = c.map(|v| UVec3::from_array(v).as_vec3() / 256.0);
        let shift = UVec3::from_array(by);
        let moved = triangle.map(|v| v + shift.as_vec3());
        let set = |found: Vec<(UVec3, u32)>, shift: UVec3| -> BTreeSet<([u32; 3], u32)> {
            found.into_iter().map(|(v, kinds)| ((v + shift).to_array(), kinds)).collect()
        };
        // What lies at the grid's lower side is cut there before the move, and is not after it.
        let inside = triangle.iter().all(|v| v.min_element() > 0.0);
        if inside {
            prop_assert_eq!(set(marked(&params, &[triangle]), shift), set(marked(&params, &[moved]), UVec3::ZERO));
        }
    }

    #[test]
    fn prefix_sums_are_prefix_sums(values in prop::collection::vec(0u32..1000, 0..700)) {
        let mut exec = CpuExecutor::new();
        let buffer = exec.upload_slice("values", &values).unwrap();
        let (offsets, total) = exclusive_scan(&mut exec, buffer, values.len() as u32, 0).unwrap();
        let got = exec.read_slice::<u32>(offsets).unwrap();
        let mut sum = 0;
        for (k, v) in values.iter().enumerate() {
            prop_assert_eq!(got[k], sum);
            sum += v;
        }
        prop_assert_eq!(total, sum);
    }
}

fn material(albedo: [f32; 3]) -> SceneMaterial {
    SceneMaterial {
        albedo,
        texture_first: NO_TEXTURE,
        emission: [0.0; 3],
        texture_size: 0,
        alpha_factor: 1.0,
        alpha_cutoff: -1.0,
        metallic: 0.0,
        roughness: 1.0,
    }
}

type Mesh = Vec<(Corners, [f32; 3])>;

/// Buffers of bare triangles with a material each; no BVH, no lights.
fn buffers(exec: &mut dyn Executor, mesh: &Mesh) -> SceneBuffers {
    let triangles: Vec<SceneTriangle> =
        mesh.iter().enumerate().map(|(k, (c, _))| SceneTriangle { material: k as u32, ..scene_triangle(*c) }).collect();
    let attributes = vec![TriangleAttributes { uv: [0.0; 6], normals: [0; 3], tints: [0; 3] }; mesh.len()];
    let mut surfaces = vec![0u32; SRGB_TABLE_WORDS as usize];
    for (_, albedo) in mesh {
        surfaces.extend_from_slice(bytemuck::cast_slice(&[material(*albedo)]));
    }
    SceneBuffers {
        nodes: exec.upload("nodes", &[]).unwrap(),
        triangles: exec.upload_slice("triangles", &triangles).unwrap(),
        attributes: exec.upload_slice("attributes", &attributes).unwrap(),
        surfaces: exec.upload_slice("surfaces", &surfaces).unwrap(),
        lights: exec.upload("lights", &[]).unwrap(),
        light_count: 0,
        triangle_count: mesh.len() as u32,
    }
}

const OPTIONS: VoxelOptions =
    VoxelOptions { method: "test", anisotropic: true, limit_bytes: 1 << 30, emission_max: 0.0 };

fn build(exec: &mut CpuExecutor, mesh: &Mesh, grid: &VoxelGrid) -> VoxelScene {
    let scene = buffers(exec, mesh);
    VoxelScene::build(exec, &scene, grid, &OPTIONS, &mut StageClock::default()).unwrap()
}

/// A closed sphere of `n` × 2n quads, front outwards.
fn sphere(n: u32, centre: Vec3, radius: f32) -> Mesh {
    let at = |i: u32, j: u32| {
        let (a, b) = (std::f32::consts::PI * i as f32 / n as f32, std::f32::consts::PI * j as f32 / n as f32);
        centre + radius * Vec3::new(a.sin() * b.cos(), a.cos(), a.sin() * b.sin())
    };
    let mut mesh = Vec::new();
    for (i, j) in (0..n).flat_map(|i| (0..2 * n).map(move |j| (i, j))) {
        let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        mesh.extend([([a, b, c], [0.5; 3]), ([a, c, d], [0.25; 3])].into_iter().filter(|(c, _)| area(*c) > 1e-9));
    }
    mesh
}

fn area([a, b, c]: Corners) -> f64 {
    0.5 * f64::from((b - a).cross(c - a).length())
}

#[test]
fn area_albedo_and_normals_are_conserved() {
    for resolution in [16, 61, 128] {
        let centre = Vec3::new(3.0, -1.0, 2.0);
        let mesh = sphere(40, centre, 1.7);
        let grid = VoxelGrid::around((centre - 1.7, centre + 1.7), resolution);
        let mut exec = CpuExecutor::new();
        let voxels = build(&mut exec, &mesh, &grid);
        let facets = exec.read_slice::<VoxelFacet>(voxels.facets).unwrap();
        let face = f64::from(grid.voxel_size).powi(2);
        let total: f64 = facets.iter().map(|f| f64::from(f.area) * face).sum();
        let expected: f64 = mesh.iter().map(|(c, _)| area(*c)).sum();
        assert!((total / expected - 1.0).abs() < 1e-4, "{resolution}: {total} {expected}");
        let reflecting: f64 = facets.iter().map(|f| f64::from(f.albedo[0] * f.area) * face).sum();
        let expected: f64 = mesh.iter().map(|(c, albedo)| area(*c) * f64::from(albedo[0])).sum();
        assert!((reflecting / expected - 1.0).abs() < 1e-4, "{resolution}: {reflecting} {expected}");
        for f in facets.iter().filter(|f| f.area > 1e-3) {
            let outwards = Vec3::from_array(f.position) - centre;
            let sag = 0.01 + 0.25 * grid.voxel_size.powi(2);
            assert!((outwards.length() - 1.7).abs() < sag, "{resolution}: a centroid off the sphere, {outwards}");
            let normal = Vec3::from_array(f.normal);
            assert!(normal.normalize().dot(outwards.normalize()) > 0.9, "{resolution}: a normal aside, {f:?}");
        }
    }
}

#[test]
fn thin_walls_keep_a_side_per_sheet() {
    // Two sheets, 0.3 voxels apart, with their fronts outwards.
    let quad = |x: f32, flip: bool| {
        let [a, b, c, d] =
            [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(|[y, z]| Vec3::new(x, y + 2.0, z + 2.0));
        if flip { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] }
    };
    let mut mesh: Mesh = quad(3.6, false).map(|c| (c, [1.0, 0.0, 0.0])).to_vec();
    mesh.extend(quad(3.3, true).map(|c| (c, [0.0, 0.0, 1.0])));
    let grid = VoxelGrid { origin: Vec3::ZERO, voxel_size: 1.0, dims: UVec3::splat(8) };
    let mut exec = CpuExecutor::new();
    let voxels = build(&mut exec, &mesh, &grid);
    let facets = exec.read_slice::<VoxelFacet>(voxels.facets).unwrap();
    let inside: Vec<&VoxelFacet> = facets.iter().filter(|f| f.voxel == 3 + 8 * (4 + 8 * 4)).collect();
    let [front, back] = inside[..] else { panic!("{inside:?}") };
    assert_eq!((front.normal, front.albedo), ([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]));
    assert_eq!((back.normal, back.albedo), ([-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]));
    assert!((front.position[0] - 3.6).abs() < 1e-5 && (back.position[0] - 3.3).abs() < 1e-5);
}

#[test]
fn sums_beyond_the_fixed_point_scale_are_repeated_with_a_coarser_one() {
    // Copies of a triangle in one voxel: 0.32 voxel faces each, three times what the default scale holds.
    let t = [Vec3::new(2.1, 2.1, 2.5), Vec3::new(2.9, 2.1, 2.5), Vec3::new(2.1, 2.9, 2.5)];
    let mesh = vec![(t, [0.5; 3]); 20_000];
    let grid = VoxelGrid { origin: Vec3::ZERO, voxel_size: 1.0, dims: UVec3::splat(8) };
    let mut exec = CpuExecutor::new();
    let voxels = build(&mut exec, &mesh, &grid);
    let facets = exec.read_slice::<VoxelFacet>(voxels.facets).unwrap();
    let [facet] = facets[..] else { panic!("{facets:?}") };
    assert!(voxels.params.area_scale < 1e5, "the scale was not changed");
    assert!((facet.area / 6400.0 - 1.0).abs() < 1e-4 && (facet.albedo[1] - 0.5).abs() < 1e-4, "{facet:?}");
}

#[test]
fn bits_do_not_depend_on_the_number_of_threads() {
    let mesh = sphere(60, Vec3::splat(5.0), 4.0);
    let grid = VoxelGrid::around((Vec3::splat(1.0), Vec3::splat(9.0)), 96);
    let run = |threads: usize| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
            let mut exec = CpuExecutor::new();
            let voxels = build(&mut exec, &mesh, &grid);
            let radiance: Vec<f32> = (0..voxels.params.facet_count * 8).map(|k| (k % 97) as f32).collect();
            exec.write(voxels.radiance, bytemuck::cast_slice(&radiance)).unwrap();
            voxels.mipmap(&mut exec).unwrap();
            [voxels.cells, voxels.facets, voxels.odd, voxels.even].map(|b| exec.read(b).unwrap())
        })
    };
    let one = run(1);
    assert!(one == run(2) && one == run(7));
}

#[test]
fn pyramids_that_do_not_fit_say_so_before_they_are_made() {
    let mut exec = CpuExecutor::new();
    let scene = buffers(&mut exec, &sphere(8, Vec3::ZERO, 1.0));
    let grid = VoxelGrid::around((Vec3::splat(-1.0), Vec3::splat(1.0)), 256);
    let options = VoxelOptions { limit_bytes: 1 << 20, ..OPTIONS };
    let result = VoxelScene::build(&mut exec, &scene, &grid, &options, &mut StageClock::default());
    let Err(MethodError::TooLarge { needed_bytes, limit_bytes, .. }) = result else { panic!("it fits") };
    assert!(limit_bytes == 1 << 20 && needed_bytes > limit_bytes);
}

#[test]
fn planes_hide_beams_at_any_angle() {
    let mut input = CaseInput::new(3, 0, Flavour::Ordinary);
    let grid = VoxelGrid { origin: Vec3::ZERO, voxel_size: 1.0, dims: UVec3::splat(32) };
    let (mut open_sum, mut count) = (0.0, 0.0f32);
    for plane in 0..12 {
        let n = if plane < 3 { Vec3::AXES[plane] } else { input.direction() };
        let (u, v) = n.any_orthonormal_pair();
        let centre = Vec3::splat(16.0) + n * input.unit();
        let corner = |a: f32, b: f32| centre + u * (a * 60.0) + v * (b * 60.0);
        let mesh = vec![([corner(-1.0, -1.0), corner(3.0, -1.0), corner(-1.0, 3.0)], [0.5; 3])];
        let mut exec = CpuExecutor::new();
        let voxels = build(&mut exec, &mesh, &grid);
        let held = Held::read(&mut exec, &voxels);
        for _ in 0..60 {
            let direction = input.direction();
            if direction.dot(n).abs() < 0.3 {
                continue;
            }
            for spread in [0.0, 0.2] {
                let start = centre - direction * 10.0;
                let march = ConeMarch { spread, clear: 1e3, clear_slope: 0.0, rounding: 1.4 };
                let open = trace_cone(&voxels.params, &held.pyramid(), start, direction, &march).w;
                // Across an axis nothing passes; where a plane is tilted, single rays find gaps between its voxels.
                assert!(plane >= 3 || open < 1e-3, "plane {n}, direction {direction}, spread {spread}: {open} passes");
                open_sum += open;
                count += 1.0;
            }
        }
    }
    println!("planes let {:.4} of a beam through", open_sum / count);
    assert!(count > 700.0 && open_sum / count < 0.08, "planes let {} through", open_sum / count);
}

/// A pyramid read back.
struct Held {
    cells: Vec<u32>,
    facet_bits: Vec<u32>,
    facets: Vec<VoxelFacet>,
    radiance: Vec<Vec4>,
    odd: Vec<Vec4>,
    even: Vec<Vec4>,
}

impl Held {
    fn read(exec: &mut CpuExecutor, v: &VoxelScene) -> Self {
        v.mipmap(exec).unwrap();
        Self {
            cells: exec.read_slice(v.cells).unwrap(),
            facet_bits: exec.read_slice(v.facet_bits).unwrap(),
            facets: exec.read_slice(v.facets).unwrap(),
            radiance: exec.read_slice(v.radiance).unwrap(),
            odd: exec.read_slice(v.odd).unwrap(),
            even: exec.read_slice(v.even).unwrap(),
        }
    }
    fn pyramid(&self) -> VoxelPyramid<'_> {
        VoxelPyramid {
            cells: &self.cells,
            facet_bits: &self.facet_bits,
            facets: &self.facets,
            radiance: &self.radiance,
            odd: &self.odd,
            even: &self.even,
        }
    }
}
