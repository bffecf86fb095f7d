//! The path tracer against closed forms: if one of these fails, the truth is not the truth.

use glam::{DVec3, Vec2, Vec3};
use interreflect::reference::trace::{Hit, KeptTree, NO_TRIANGLE, Tracer};
use interreflect::reference::{
    Irradiance, Receiver, ReferenceError, ReferenceSettings, Truth, cached, irradiance, render,
};
use interreflect::scene::{Alpha, Camera, Light, Material, Scene, Texture, Triangle, Wrap};
use rayon::prelude::*;
use std::f32::consts::PI;

/// Scenes by hand.
#[derive(Default)]
struct Build(Scene);

impl Build {
    fn new() -> Self {
        Self::default()
    }

    /// A Lambert material; its index.
    fn material(&mut self, albedo: f32, emission: f32) -> u32 {
        self.0.materials.push(Material {
            name: format!("material {}", self.0.materials.len()),
            albedo: Vec3::splat(albedo),
            texture: None,
            wrap: [Wrap::Repeat; 2],
            alpha_factor: 1.0,
            alpha: Alpha::Opaque,
            emission: Vec3::splat(emission),
            metallic: 0.0,
            roughness: 1.0,
        });
        self.0.materials.len() as u32 - 1
    }

    /// Triangles with one normal per corner.
    fn triangle(&mut self, corners: [Vec3; 3], normals: [Vec3; 3], uvs: [Vec2; 3], material: u32) {
        let first = self.0.positions.len() as u32;
        self.0.positions.extend(corners);
        self.0.normals.extend(normals);
        self.0.uvs.extend(uvs);
        self.0.triangles.push(Triangle { vertices: [first, first + 1, first + 2], material });
    }

    /// A flat parallelogram at `corner`; its front is on the side of `a × b`. uv runs along a and b.
    fn quad(&mut self, corner: Vec3, a: Vec3, b: Vec3, material: u32) -> &mut Self {
        let n = [a.cross(b).normalize(); 3];
        let (o, u, v) = (Vec2::ZERO, Vec2::X, Vec2::Y);
        self.triangle([corner, corner + a, corner + a + b], n, [o, u, u + v], material);
        self.triangle([corner, corner + a + b, corner + b], n, [o, u + v, v], material);
        self
    }

    /// A box of six quads whose fronts look inwards or outwards.
    fn cuboid(&mut self, lo: Vec3, hi: Vec3, inwards: bool, material: u32) -> &mut Self {
        let d = hi - lo;
        let (x, y, z) = (Vec3::X * d.x, Vec3::Y * d.y, Vec3::Z * d.z);
        for (corner, a, b) in [(lo, x, y), (lo, y, z), (lo, z, x), (hi, -y, -x), (hi, -z, -y), (hi, -x, -z)] {
            // At `lo` the product a × b looks into the box.
            let (a, b) = if inwards { (a, b) } else { (b, a) };
            self.quad(corner, a, b, material);
        }
        self
    }

    /// A sphere of rings × 2·rings facets; its front looks inwards.
    fn sphere(&mut self, radius: f32, rings: u32, smooth: bool, material: u32) -> &mut Self {
        let at = |i: u32, j: u32| {
            let (theta, phi) = (PI * i as f32 / rings as f32, PI * (j % (2 * rings)) as f32 / rings as f32);
            let s = if i == 0 || i == rings { 0.0 } else { theta.sin() };
            Vec3::new(s * phi.cos(), theta.cos(), s * phi.sin()) * radius
        };
        for i in 0..rings {
            for j in 0..2 * rings {
                let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
                for corners in [[a, c, d], [a, b, c]] {
                    let [p, q, r] = corners;
                    let n = (q - p).cross(r - p);
                    if n.length() < 1e-9 {
                        continue;
                    }
                    // Wind towards the centre.
                    let inwards = n.dot(p + q + r) < 0.0;
                    let corners = if inwards { corners } else { [p, r, q] };
                    let flat = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
                    let normals = if smooth { corners.map(|p| -p.normalize()) } else { [flat; 3] };
                    self.triangle(corners, normals, [Vec2::ZERO; 3], material);
                }
            }
        }
        self
    }
}

fn camera(position: Vec3, target: Vec3, fovy_rad: f32) -> Camera {
    let forward = (target - position).normalize();
    let right = forward.cross(if forward.y.abs() > 0.99 { Vec3::X } else { Vec3::Y }).normalize();
    Camera { name: "test".into(), node: String::new(), position, forward, up: right.cross(forward), fovy_rad }
}

fn spp(spp: u32) -> ReferenceSettings {
    ReferenceSettings { spp: Some(spp), ..Default::default() }
}

fn noise(noise: f64) -> ReferenceSettings {
    ReferenceSettings { noise: Some(noise), ..Default::default() }
}

fn picture(scene: &Scene, camera: &Camera, size: u32, settings: &ReferenceSettings) -> Truth {
    render(scene, camera, size, size, settings, &mut |_| ()).unwrap()
}

fn at(scene: &Scene, receivers: &[Receiver], settings: &ReferenceSettings) -> Vec<Irradiance> {
    irradiance(scene, receivers, settings, &mut |_| ()).unwrap().values
}

fn mean(values: &[Vec3]) -> Vec3 {
    (values.iter().map(|v| v.as_dvec3()).sum::<glam::DVec3>() / values.len() as f64).as_vec3()
}

#[track_caller]
fn assert_relative(actual: f32, expected: f32, tolerance: f32, what: &str) {
    let error = (actual / expected - 1.0).abs();
    assert!(error <= tolerance, "{what}: {actual}, expected {expected}: {:.3} % off", 100.0 * error);
}

/// Inside a closed surface of albedo ρ that emits L everywhere, radiance is L/(1−ρ) in every direction.
#[test]
fn furnace() {
    for albedo in [0.2, 0.5, 0.8] {
        let mut b = Build::new();
        let m = b.material(albedo, 1.0);
        b.cuboid(Vec3::new(-1.0, -0.7, -1.3), Vec3::new(1.0, 0.7, 1.3), true, m);
        let view = camera(Vec3::new(0.3, 0.1, -0.4), Vec3::new(1.0, 0.2, 1.3), 1.2);
        let truth = picture(&b.0, &view, 16, &noise(0.01));
        assert_relative(mean(&truth.full).x, 1.0 / (1.0 - albedo), 0.002, &format!("albedo {albedo}"));
    }
}

/// A unit sphere of albedo 0.5 that emits 0.5: radiance 1.
#[test]
fn unit_sphere() {
    let mut b = Build::new();
    let m = b.material(0.5, 0.5);
    b.sphere(1.0, 32, false, m);
    let view = camera(Vec3::new(0.1, 0.2, -0.3), Vec3::new(0.9, -0.1, 0.5), 1.5);
    let truth = picture(&b.0, &view, 16, &noise(0.01));
    assert_relative(mean(&truth.full).x, 1.0, 0.002, "radiance");
    assert_relative(mean(&truth.direct).x, 0.75, 0.002, "emitted and reflected once");
}

/// Mean irradiance between two parallel unit squares one apart: π L F, F = 0.199825 (Howell's catalogue, C-11); and
/// at the point below the centre: four corner factors (C-3 of a differential element).
#[test]
fn parallel_squares() {
    let mut b = Build::new();
    let m = b.material(0.0, 3.0);
    b.quad(Vec3::new(0.0, 1.0, 0.0), Vec3::X, Vec3::Z, m);
    let n = 32;
    let receivers: Vec<Receiver> = (0..n * n)
        .map(|i| {
            let (x, z) = (((i % n) as f32 + 0.5) / n as f32, ((i / n) as f32 + 0.5) / n as f32);
            Receiver::new(Vec3::new(x, 0.0, z), Vec3::Y)
        })
        .collect();
    let values = at(&b.0, &receivers, &spp(256));
    let direct: Vec<Vec3> = values.iter().map(|v| v.direct).collect();
    assert_relative(mean(&direct).x, 3.0 * PI * 0.199_825, 0.002, "mean");
    let a = 0.5f32;
    let s = (1.0 + a * a).sqrt();
    let corner = 2.0 * (a / s) * (a / s).atan() / (2.0 * PI);
    let centre = at(&b.0, &[Receiver::new(Vec3::new(0.5, 0.0, 0.5), Vec3::Y)], &spp(1 << 15));
    assert_relative(centre[0].direct.x, 3.0 * PI * 4.0 * corner, 0.002, "centre");
    assert_eq!(centre[0].indirect, Vec3::ZERO, "a black lamp reflects nothing");
}

/// I cos θ / d² of point and spot, E cos θ of parallel light, and nothing behind an obstacle or outside the cone.
#[test]
fn lights_without_a_surface() {
    let one = |light: Light, position: Vec3| {
        let mut b = Build::new();
        let m = b.material(0.0, 0.0);
        b.quad(Vec3::new(10.0, 1.0, -5.0), Vec3::X * 5.0, Vec3::Z * 10.0, m);
        b.0.lights.push(light);
        at(&b.0, &[Receiver::new(position, Vec3::Y)], &spp(16))[0].direct
    };
    let intensity = Vec3::new(8.0, 4.0, 2.0);
    let point = Light::Point { position: Vec3::new(0.0, 2.0, 0.0), intensity };
    let slanted = Vec3::new(1.5, 0.0, 0.0);
    let slanted_cos = 2.0 / 2.5;
    assert!((one(point, slanted) - intensity * slanted_cos / 6.25).abs().max_element() < 1e-5);
    let spot = |cos_inner, cos_outer| Light::Spot {
        position: Vec3::new(0.0, 2.0, 0.0),
        direction: Vec3::NEG_Y,
        intensity,
        cos_inner,
        cos_outer,
    };
    let ramp = ((slanted_cos - 0.7) / 0.2f32).powi(2);
    let expected = intensity * ramp * slanted_cos / 6.25;
    assert!((one(spot(0.9, 0.7), slanted) - expected).abs().max_element() < 1e-5, "between the cones");
    assert!((one(spot(0.79, 0.7), slanted) - intensity * slanted_cos / 6.25).abs().max_element() < 1e-5, "inside");
    assert_eq!(one(spot(0.9, 0.81), slanted), Vec3::ZERO, "outside");
    let direction = Vec3::new(0.6, -0.8, 0.0);
    let sun = Light::Directional { direction, irradiance: intensity };
    assert!((one(sun, Vec3::ZERO) - intensity * 0.8).abs().max_element() < 1e-5);
    // The obstacle lies towards +x: under it the slanted point light is hidden, light from straight above too.
    assert_eq!(one(point, Vec3::new(24.0, 0.0, 0.0)), Vec3::ZERO, "shadow of a point light");
    let down = Light::Directional { direction: Vec3::NEG_Y, irradiance: intensity };
    assert_eq!(one(down, Vec3::new(12.0, 0.0, 0.0)), Vec3::ZERO, "shadow of parallel light");
    assert!((one(down, Vec3::ZERO) - intensity).abs().max_element() < 1e-5);
}

/// Shading normals bend the cosine and nothing else: an inclined normal per corner, equal or interpolated.
#[test]
fn smooth_normals_shade_by_their_own_cosine() {
    let tilted = |angle: f32| Vec3::new(angle.sin(), angle.cos(), 0.0);
    let floor = |left: f32, right: f32| {
        let mut b = Build::new();
        let m = b.material(0.5, 0.0);
        let corner = |x: f32, z: f32| Vec3::new(x, 0.0, z);
        let (l, r) = (tilted(left), tilted(right));
        let (a, b1, c, d) = (corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0));
        b.triangle([a, b1, c], [l, l, r], [Vec2::ZERO; 3], m);
        b.triangle([a, c, d], [l, r, r], [Vec2::ZERO; 3], m);
        b.0.lights.push(Light::Directional { direction: Vec3::NEG_Y, irradiance: Vec3::splat(3.0) });
        b.0
    };
    let seen = |scene: &Scene, x: f32| {
        let view = camera(Vec3::new(x, 2.0, 0.0), Vec3::new(x, 0.0, 0.001), 0.001);
        mean(&picture(scene, &view, 1, &spp(16)).full).x
    };
    let expected = |angle: f32| 0.5 / PI * 3.0 * angle.cos();
    for angle in [0.0, 0.4, 1.2] {
        let got = seen(&floor(angle, angle), 0.3);
        assert!((got - expected(angle)).abs() < 1e-5, "{angle}: {got} is not {}", expected(angle));
    }
    // Halfway between normals tilted to both sides, and at a quarter, where the mean of two unit vectors is renormalized.
    let between = floor(-0.6, 0.6);
    assert!((seen(&between, 0.0) - expected(0.0)).abs() < 1e-4);
    let quarter = (tilted(-0.6) * 0.25 + tilted(0.6) * 0.75).normalize().y;
    assert!((seen(&between, 0.5) - 0.5 / PI * 3.0 * quarter).abs() < 1e-4);
    // A normal on the far side of the viewer is turned over as a whole.
    assert!((seen(&floor(PI - 0.4, PI - 0.4), 0.3) - expected(0.4)).abs() < 1e-5);
}

/// An open plane under a constant environment receives π L and reflects ρ L.
#[test]
fn environment() {
    let mut b = Build::new();
    let m = b.material(0.4, 0.0);
    b.quad(Vec3::new(-50.0, 0.0, -50.0), Vec3::Z * 100.0, Vec3::X * 100.0, m);
    b.0.environment = Vec3::new(1.0, 2.0, 3.0);
    let e = at(&b.0, &[Receiver::new(Vec3::ZERO, Vec3::Y)], &spp(64))[0];
    assert!((e.direct - b.0.environment * PI).abs().max_element() < 1e-4, "{}", e.direct);
    assert_eq!(e.indirect, Vec3::ZERO);
    let down = picture(&b.0, &camera(Vec3::Y, Vec3::new(0.0, 0.0, -0.1), 0.5), 4, &spp(64));
    assert!((mean(&down.full) - b.0.environment * 0.4).abs().max_element() < 1e-5);
    let up = picture(&b.0, &camera(Vec3::Y, Vec3::new(0.0, 2.0, -0.1), 0.5), 4, &spp(4));
    assert!((mean(&up.direct) - b.0.environment).abs().max_element() < 1e-6, "seen directly");
    assert_eq!(mean(&up.indirect), Vec3::ZERO);
}

/// Surfaces reflect on both sides and emit on one.
#[test]
fn sides() {
    let mut b = Build::new();
    let m = b.material(0.6, 2.0);
    // Front up, lit from below.
    b.quad(Vec3::new(-1.0, 0.0, -1.0), Vec3::Z * 2.0, Vec3::X * 2.0, m);
    b.0.lights.push(Light::Directional { direction: Vec3::Y, irradiance: Vec3::splat(5.0) });
    let below = picture(&b.0, &camera(Vec3::NEG_Y, Vec3::new(0.0, 0.0, 0.1), 0.3), 4, &spp(4096));
    assert_relative(mean(&below.full).x, 5.0 * 0.6 / PI, 2e-3, "the back reflects and does not emit");
    let above = picture(&b.0, &camera(Vec3::Y, Vec3::new(0.0, 0.0, 0.1), 0.3), 4, &spp(4));
    assert_relative(mean(&above.full).x, 2.0, 1e-6, "the front emits, and light from behind does not pass");
    b.0.lights.clear();
    let receivers = [Vec3::Y, Vec3::NEG_Y].map(|side| Receiver::new(side * 0.5, -side));
    let e = at(&b.0, &receivers, &spp(1 << 12));
    let s = 5f32.sqrt();
    // The square seen from half its half-side: A = B = 2.
    let factor = 4.0 * 2.0 * (2.0 / s) * (2.0 / s).atan() / (2.0 * PI);
    assert_relative(e[0].direct.x, 2.0 * PI * factor, 0.003, "in front");
    assert_eq!(e[1].direct, Vec3::ZERO, "behind");
}

/// A point light in the middle of a sphere: irradiance E = I/R² everywhere, and after k reflections ρᵏ E.
#[test]
fn direct_and_indirect_of_a_sphere() {
    let (radius, rho) = (2.0f32, 0.6f32);
    let mut b = Build::new();
    let m = b.material(rho, 0.0);
    b.sphere(radius, 48, false, m);
    b.0.lights.push(Light::Point { position: Vec3::ZERO, intensity: Vec3::splat(4.0) });
    let e = 4.0 / (radius * radius);
    // A facet's points lie a little inside the sphere; 48 rings make that 0.1 %.
    let towards = Vec3::new(0.3, -0.8, 0.52).normalize();
    let receiver = [Receiver::new(towards * radius * 0.998, -towards)];
    let full = at(&b.0, &receiver, &noise(0.001))[0];
    assert_relative(full.direct.x, e, 0.006, "direct irradiance");
    assert_relative(full.indirect.x, e * rho / (1.0 - rho), 0.006, "indirect irradiance");
    let mut geometric = 0.0;
    for bounces in 2..5u32 {
        geometric += rho.powi(bounces as i32 - 1);
        let settings = ReferenceSettings { max_bounces: Some(bounces), ..noise(0.001) };
        assert_relative(at(&b.0, &receiver, &settings)[0].indirect.x, e * geometric, 0.006, "up to some bounces");
    }
    let view = camera(Vec3::new(0.2, 0.1, 0.3), Vec3::NEG_Y * radius, 1.0);
    let truth = picture(&b.0, &view, 8, &noise(0.005));
    assert_relative(mean(&truth.direct).x, e * rho / PI, 0.006, "direct radiance");
    assert_relative(mean(&truth.indirect).x, e * rho / PI * rho / (1.0 - rho), 0.006, "indirect radiance");
    let once = picture(&b.0, &view, 8, &ReferenceSettings { max_bounces: Some(1), ..spp(16) });
    assert_eq!(mean(&once.indirect), Vec3::ZERO);
    let none = picture(&b.0, &view, 8, &ReferenceSettings { max_bounces: Some(0), ..spp(16) });
    assert_eq!(mean(&none.full), Vec3::ZERO, "no reflection, no emitter in sight");
}

/// A room with a lamp, a blocker, a sun and a sky: everything at once.
fn room() -> Scene {
    let mut b = Build::new();
    let white = b.material(0.7, 0.0);
    let lamp = b.material(0.1, 6.0);
    b.cuboid(Vec3::ZERO, Vec3::splat(2.0), true, white);
    b.cuboid(Vec3::new(0.4, 0.0, 0.5), Vec3::new(1.0, 0.9, 1.2), false, white);
    b.quad(Vec3::new(0.7, 1.98, 0.7), Vec3::X * 0.6, Vec3::Z * 0.6, lamp);
    // A window: the wall x = 0 goes.
    b.0.triangles.retain(|t| !t.vertices.iter().all(|&v| b.0.positions[v as usize].x == 0.0));
    b.0.lights.push(Light::Directional { direction: Vec3::new(0.8, -0.6, 0.0), irradiance: Vec3::splat(2.0) });
    b.0.lights.push(Light::Point { position: Vec3::new(1.6, 1.4, 0.3), intensity: Vec3::splat(0.4) });
    b.0.environment = Vec3::splat(0.5);
    b.0
}

fn room_view() -> Camera {
    camera(Vec3::new(1.8, 1.2, 1.9), Vec3::new(0.4, 0.6, 0.3), 1.2)
}

#[test]
fn same_bits_for_any_number_of_threads() {
    let scene = room();
    let run = |threads: usize, seed: u32| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let settings = ReferenceSettings { seed, ..noise(0.2) };
        pool.install(|| {
            let t = picture(&scene, &room_view(), 24, &settings);
            (t.direct, t.indirect, t.variance_full, t.variance_indirect, t.spp, t.noise.to_bits(), t.rays)
        })
    };
    let one = run(1, 7);
    assert!(one == run(2, 7), "two threads differ from one");
    assert!(one == run(5, 7), "five threads differ from one");
    assert!(one.0 != run(1, 8).0, "another seed must give other noise");
}

/// The variance that a picture states is that of its pixels over many seeds.
#[test]
fn stated_variance_is_the_variance_between_seeds() {
    let scene = room();
    let runs: Vec<Truth> =
        (0..64u32).map(|seed| picture(&scene, &room_view(), 8, &ReferenceSettings { seed, ..spp(32) })).collect();
    let check = |value: fn(&Truth) -> &Vec<Vec3>, stated: fn(&Truth) -> &Vec<Vec3>, what: &str| {
        let (mut empirical, mut told) = (0.0, 0.0);
        for pixel in 0..64 {
            let values: Vec<f64> = runs.iter().map(|r| f64::from(value(r)[pixel].x)).collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            empirical += values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (values.len() - 1) as f64;
            told += runs.iter().map(|r| f64::from(stated(r)[pixel].x)).sum::<f64>() / runs.len() as f64;
        }
        // 64 pixels × 63 degrees of freedom: about 2–3 % standard error, more for the heavy tails.
        let ratio = told / empirical;
        assert!((0.85..1.18).contains(&ratio), "{what}: stated {told:.3e}, found {empirical:.3e}");
    };
    check(|t| &t.full, |t| &t.variance_full, "full");
    check(|t| &t.indirect, |t| &t.variance_indirect, "indirect");
}

#[test]
fn noise_and_samples_end_a_render() {
    let scene = room();
    let truth = picture(&scene, &room_view(), 16, &noise(0.1));
    assert!(truth.noise <= 0.1);
    let (mut sum, mut variance) = (0.0, 0.0);
    for (f, v) in truth.full.iter().zip(&truth.variance_full) {
        sum += f64::from(f.element_sum());
        variance += f64::from(v.element_sum());
    }
    let n = 3.0 * truth.full.len() as f64;
    assert!(((variance / n).sqrt() / (sum / n) / truth.noise - 1.0).abs() < 1e-3, "noise is as documented");
    assert_eq!(picture(&scene, &room_view(), 4, &spp(37)).spp, 37);
    assert_eq!(picture(&scene, &room_view(), 4, &ReferenceSettings { noise: Some(1e-9), ..spp(64) }).spp, 64);
    for (d, (i, f)) in truth.direct.iter().zip(truth.indirect.iter().zip(&truth.full)) {
        assert_eq!(*d + *i, *f);
    }
}

/// Cut-outs let light and sight through where alpha is below the cut-off, and only there.
#[test]
fn alpha_mask() {
    let mut b = Build::new();
    let leaf = b.material(0.5, 0.0);
    b.0.textures.push(Texture { width: 2, height: 1, srgba: vec![[255, 255, 255, 255], [255, 255, 255, 0]] });
    b.0.materials[leaf as usize].texture = Some(0);
    b.0.materials[leaf as usize].alpha = Alpha::Mask(0.5);
    // u runs along +x: opaque for x in (0, ½), open for x in (½, 1), with the filter's half-way points at 0, ½, 1.
    b.quad(Vec3::new(0.0, 1.0, 0.0), Vec3::X, Vec3::Z, leaf);
    b.0.lights.push(Light::Directional { direction: Vec3::NEG_Y, irradiance: Vec3::ONE });
    let receivers = [0.05, 0.25, 0.45, 0.55, 0.75, 0.95].map(|x| Receiver::new(Vec3::new(x, 0.0, 0.5), Vec3::Y));
    let lit = at(&b.0, &receivers, &spp(8)).map_x();
    assert_eq!(lit, [0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    b.0.environment = Vec3::splat(7.0);
    let eye = camera(Vec3::new(0.75, 0.0, 0.5), Vec3::new(0.75, 1.0, 0.500_1), 0.1);
    assert_eq!(mean(&picture(&b.0, &eye, 2, &spp(4)).full), Vec3::splat(7.0), "the camera looks through");
    b.0.environment = Vec3::ZERO;
    b.0.materials[leaf as usize].alpha = Alpha::Opaque;
    assert_eq!(at(&b.0, &receivers, &spp(8)).map_x(), [0.0; 6], "alpha of an opaque material is ignored");
}

trait MapX {
    fn map_x(&self) -> Vec<f32>;
}

impl MapX for Vec<Irradiance> {
    fn map_x(&self) -> Vec<f32> {
        self.iter().map(|e| e.direct.x).collect()
    }
}

/// A generator for the rays of geometric tests.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / 16_777_216.0
    }

    fn cube(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }

    fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.cube();
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

/// Nearest hit in f64 over all triangles (Möller & Trumbore 1997), and whether the ray is so near to an edge or to
/// another surface that f32 may decide otherwise.
fn brute_force(scene: &Scene, origin: Vec3, direction: Vec3) -> (Option<(f64, u32)>, bool) {
    let (o, d) = (origin.as_dvec3(), direction.as_dvec3());
    let (mut best, mut doubtful): (Option<(f64, u32)>, bool) = (None, false);
    for (i, triangle) in scene.triangles.iter().enumerate() {
        let [a, b, c] = scene.corners(triangle).map(|p| p.as_dvec3());
        let (e1, e2, s) = (b - a, c - a, o - a);
        let p: DVec3 = d.cross(e2);
        let q = s.cross(e1);
        let det = e1.dot(p);
        let (u, v, t) = (s.dot(p) / det, d.dot(q) / det, e2.dot(q) / det);
        let w = 1.0 - u - v;
        let edge = u.min(v).min(w);
        if t > -1e-5 && edge > -1e-4 {
            doubtful |= edge < 1e-4 || t < 1e-5 || best.is_some_and(|(other, _)| (other - t).abs() < 1e-5);
            if t > 0.0 && edge >= 0.0 && best.is_none_or(|(other, _)| t < other) {
                best = Some((t, i as u32));
            }
        }
    }
    (best, doubtful)
}

#[test]
fn hits_equal_brute_force() {
    let mut random = Random(5);
    let mut compared = 0;
    for triangle_count in [1, 2, 3, 9, 60, 400] {
        let mut b = Build::new();
        let m = b.material(0.5, 0.0);
        for i in 0..triangle_count {
            let at = random.cube();
            // Some long and thin, some tiny, some axis-aligned.
            let size = [1.0, 0.2, 0.01][i % 3];
            let mut corners = [at, at + random.cube() * size, at + random.cube() * size];
            if i % 5 == 0 {
                corners[1].y = at.y;
                corners[2].y = at.y;
            }
            b.triangle(corners, [Vec3::Y; 3], [Vec2::ZERO; 3], m);
        }
        let tracer = Tracer::new(&b.0).unwrap();
        for i in 0..3000 {
            let origin = random.cube() * 1.5;
            // −X has components −0.
            let axis = [-Vec3::X, Vec3::NEG_Y, Vec3::Z][i % 3];
            let direction = if i % 4 == 0 { axis } else { random.direction() };
            let (expected, doubtful) = brute_force(&b.0, origin, direction);
            if doubtful {
                continue;
            }
            compared += 1;
            let hit: Option<Hit> = tracer.closest(origin, direction, f32::MAX, NO_TRIANGLE);
            assert_eq!(hit.map(|h| h.triangle), expected.map(|e| e.1), "{triangle_count} triangles, ray {i}");
            let occluded = |tmax| tracer.occluded(origin, direction, tmax, [NO_TRIANGLE; 2]);
            assert_eq!(occluded(f32::MAX), expected.is_some());
            if let (Some(hit), Some((t, triangle))) = (hit, expected) {
                assert!((f64::from(hit.t) - t).abs() < 1e-5 * (1.0 + t), "{} is not {t}", hit.t);
                let corners = b.0.corners(&b.0.triangles[triangle as usize]);
                let point =
                    corners[0] * hit.barycentric.x + corners[1] * hit.barycentric.y + corners[2] * hit.barycentric.z;
                assert!((point - origin - direction * hit.t).length() < 1e-5);
                assert!(!occluded(hit.t * 0.999) && occluded(hit.t * 1.001));
                let beyond = tracer.closest(origin, direction, f32::MAX, triangle);
                assert!(beyond.is_none_or(|h| h.triangle != triangle && h.t >= hit.t), "excluded");
            }
        }
    }
    assert!(compared > 15_000, "only {compared} rays were clear");
}

/// 10⁷ rays from inside a closed box and a closed sphere: random ones, and ones aimed at corners and edges.
#[test]
fn no_ray_leaks() {
    let mut b = Build::new();
    let m = b.material(0.5, 0.0);
    // Neither centred nor a power of two: coordinates that round.
    b.cuboid(Vec3::new(-0.9, 0.13, -1.7), Vec3::new(1.1, 1.47, 0.3), true, m);
    let cuboid = std::mem::take(&mut b.0);
    let m = b.material(0.5, 0.0);
    b.sphere(1.3, 40, false, m);
    for (scene, centre, half) in
        [(&cuboid, Vec3::new(0.1, 0.8, -0.7), Vec3::new(0.99, 0.66, 0.99)), (&b.0, Vec3::ZERO, Vec3::splat(0.7))]
    {
        let tracer = Tracer::new(scene).unwrap();
        let leaks: usize = (0..1000u64)
            .into_par_iter()
            .map(|task| {
                let mut random = Random(task * 7919 + 1);
                (0..5000)
                    .filter(|i| {
                        let origin = centre + random.cube() * half;
                        let triangle = &scene.triangles[(random.unit() * scene.triangles.len() as f32) as usize];
                        let [p, q, _] = scene.corners(triangle);
                        let direction = match i % 4 {
                            0 => p - origin,
                            1 => p.lerp(q, random.unit()) - origin,
                            _ => random.direction(),
                        };
                        tracer.closest(origin, direction, f32::MAX, NO_TRIANGLE).is_none()
                            || !tracer.occluded(origin, direction, f32::MAX, [NO_TRIANGLE; 2])
                    })
                    .count()
            })
            .sum();
        assert_eq!(leaks, 0, "of 5 million rays in {} triangles", scene.triangles.len());
    }
}

#[test]
fn cache_returns_the_same_bits_and_survives_damage() {
    let scene = room();
    let dir = tempfile::tempdir().unwrap();
    let get = |scene: &Scene, seed: u32| {
        let settings = ReferenceSettings { seed, ..spp(8) };
        cached(dir.path(), &KeptTree::default(), scene, &room_view(), (8, 6), &settings, &mut |_| ()).unwrap()
    };
    let first = get(&scene, 1);
    assert!(!first.from_cache && first.path.is_file());
    let again = get(&scene, 1);
    assert!(again.from_cache && again.truth == first.truth);
    assert!(!get(&scene, 2).from_cache, "another seed is another truth");
    let mut brighter = scene.clone();
    brighter.environment *= 2.0;
    assert!(!get(&brighter, 1).from_cache, "another light is another truth");
    let bytes = std::fs::read(&first.path).unwrap();
    let mut flipped = bytes.clone();
    flipped[200] ^= 1;
    for damaged in [&bytes[..bytes.len() - 1], &bytes[..20], &[], &flipped] {
        std::fs::write(&first.path, damaged).unwrap();
        let mended = get(&scene, 1);
        assert!(!mended.from_cache);
        assert_eq!(mended.truth.full, first.truth.full);
    }
    assert!(get(&scene, 1).from_cache);
    let names = std::fs::read_dir(dir.path()).unwrap().count();
    assert_eq!(names, 3, "no temporary file stays");
    let blocked = dir.path().join("file");
    std::fs::write(&blocked, "not a directory").unwrap();
    let failure = cached(&blocked, &KeptTree::default(), &scene, &room_view(), (8, 6), &spp(8), &mut |_| ());
    assert!(matches!(failure, Err(ReferenceError::Cache { .. })));
}

#[test]
fn mistakes_are_errors() {
    let view = room_view();
    let fails = |scene: &Scene, width: u32, settings: &ReferenceSettings| {
        render(scene, &view, width, 4, settings, &mut |_| ()).unwrap_err().to_string()
    };
    let scene = room();
    assert!(fails(&scene, 0, &spp(2)).contains("width"));
    assert!(fails(&scene, 1 << 20, &spp(2)).contains("16384"));
    assert!(fails(&scene, 4, &noise(0.0)).contains("noise"));
    assert!(fails(&scene, 4, &noise(f64::NAN)).contains("noise"));
    assert!(fails(&scene, 4, &spp(0)).contains("spp"));
    let broken = |change: &dyn Fn(&mut Scene)| {
        let mut scene = room();
        change(&mut scene);
        fails(&scene, 4, &spp(2))
    };
    assert!(broken(&|s| s.positions[3].y = f32::NAN).contains("vertex 3"));
    assert!(broken(&|s| s.triangles[2].vertices[1] = 1_000_000).contains("triangle 2"));
    assert!(broken(&|s| s.triangles[5].material = 9).contains("triangle 5"));
    assert!(broken(&|s| s.materials[1].emission.x = f32::INFINITY).contains("material 1"));
    assert!(broken(&|s| s.environment.x = -1.0).contains("environment"));
    let empty = Scene { environment: Vec3::ONE, ..Default::default() };
    let sky = render(&empty, &view, 4, 4, &noise(0.01), &mut |_| ()).unwrap();
    assert_eq!(mean(&sky.full), Vec3::ONE, "an empty scene shows the sky");
    let dark = render(&Scene::default(), &view, 4, 4, &noise(0.01), &mut |_| ()).unwrap();
    assert_eq!((mean(&dark.full), dark.noise), (Vec3::ZERO, 0.0));
}
