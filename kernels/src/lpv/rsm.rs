//! Reflective shadow maps by ray casting: one invocation is one texel, the first surface that one ray from a light meets.
//!
//! Dachsbacher & Stamminger 2005, "Reflective Shadow Maps", with rays in place of a rasterizer, so that every kind of
//! light has one: directional lights a square across the scene, spot lights the cone in equal solid angles, point lights an octahedral map with the
//! exact solid angle of each texel, all emissive triangles together a set of cosine-distributed rays from points picked
//! by power, and the environment a set of lines through the scene's bounding sphere. What a texel carries is true flux (W): the sum
//! over a map is the flux of the light that hits the scene. Grid: texels of all maps.
//!
//! Good when lights are few: cost is one ray per texel. Fails when a lit surface is smaller than a texel, which then
//! flickers as the light moves. Pass before: none. Pass after: `inject.rs`, `block.rs`.

use crate::kernel::Rows;
#[cfg(not(target_arch = "spirv"))]
use crate::kernel::{Case, CaseInput, Tolerance};
use crate::math::float::{PI, max};
use crate::math::frame::Frame;
use crate::math::octahedral;
use crate::math::rng::{hash, rand2, rotate, unit};
use crate::math::sampling::{self, cosine_hemisphere};
#[cfg(not(target_arch = "spirv"))]
use crate::trace::case::CaseScene;
use crate::trace::light::spot_falloff;
use crate::trace::surface::{leave_surface, no_surface, unit_or};
use crate::trace::{Ray, SceneRef, closest_hit, surface};
use glam::{Vec2, Vec3};
use interreflect_shared::lpv::{MAP_ENVIRONMENT, RsmMap, RsmParams, RsmTexel};
use interreflect_shared::scene::{
    BvhNode, LIGHT_DIRECTIONAL, LIGHT_POINT, LIGHT_SPOT, SceneLight, SceneTriangle, TriangleAttributes,
};

/// A ray from a light.
struct LightRay {
    ray: Ray,
    /// Flux (W) along it.
    flux: Vec3,
    /// Area that it stands for on a surface that faces it: `area + solid_angle · t²`.
    area: f32,
    solid_angle: f32,
}

/// Cosine at which a surface counts as lit at a grazing angle: bounds the area of a texel.
const GRAZING: f32 = 0.05;

/// Flux (W) of a ray below which it counts as none: devices flush denormals.
const LEAST_FLUX: f32 = 1e-30;

/// Texels of the pass.
pub fn texels(p: &RsmParams) -> Rows {
    Rows::range(p.first, p.count)
}

/// Texel `p.first + invocation`: of map `i / resolution²`.
#[inline(always)]
pub fn texel(
    invocation: u32,
    p: &RsmParams,
    nodes: &[BvhNode],
    triangles: &[SceneTriangle],
    attributes: &[TriangleAttributes],
    surfaces: &[u32],
    lights: &[SceneLight],
    maps: &[RsmMap],
) -> RsmTexel {
    let scene = SceneRef { nodes, triangles, attributes, surfaces };
    let i = p.first + invocation;
    let per_map = p.resolution * p.resolution;
    let map = maps[(i / per_map) as usize];
    let from = light_ray(p, &map, lights, i - i / per_map * per_map);
    let hit = closest_hit(&scene, &from.ray);
    let surfel = if hit.is_some() { surface(&scene, &from.ray, &hit) } else { no_surface() };
    let normal = Vec3::from_array(surfel.geometric_normal);
    let lit = hit.is_some() && max(from.flux.x, max(from.flux.y, from.flux.z)) > LEAST_FLUX;
    let cosine = max(-normal.dot(from.ray.direction), GRAZING);
    RsmTexel {
        position: surfel.position,
        area: if lit { (from.area + from.solid_angle * surfel.distance * surfel.distance) / cosine } else { 0.0 },
        normal: surfel.geometric_normal,
        hit: lit as u32,
        flux: if lit { from.flux.to_array() } else { [0.0; 3] },
        _pad0: 0,
        albedo: if lit { surfel.albedo } else { [0.0; 3] },
        _pad1: 0,
    }
}

#[inline(always)]
fn light_ray(p: &RsmParams, map: &RsmMap, lights: &[SceneLight], texel: u32) -> LightRay {
    let row = texel / p.resolution;
    let column = texel - row * p.resolution;
    let square = Vec2::new(column as f32 + 0.5, row as f32 + 0.5) / p.resolution as f32;
    if map.kind == MAP_ENVIRONMENT {
        return environment_ray(p, map, map.first + texel);
    }
    let light = lights[map.light as usize];
    if map.kind == LIGHT_POINT {
        point_ray(p, &light, square)
    } else if map.kind == LIGHT_SPOT {
        spot_ray(p, &light, square)
    } else if map.kind == LIGHT_DIRECTIONAL {
        directional_ray(p, map, &light, square)
    } else {
        emitter_ray(p, map, lights, map.first + texel)
    }
}

/// Octahedral map: texels have the exact solid angle of their two spherical triangles, which lie in one octant each.
#[inline(always)]
fn point_ray(p: &RsmParams, light: &SceneLight, square: Vec2) -> LightRay {
    let c = square * 2.0 - Vec2::ONE;
    let h = 1.0 / p.resolution as f32;
    let corner = |x: f32, y: f32| octahedral::decode(Vec2::new(c.x + x * h, c.y + y * h));
    let (a, b, d, e) = (corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0));
    let angle = |a: Vec3, b: Vec3, c: Vec3| crate::math::float::abs(sampling::triangle_solid_angle(a, b, c));
    // The fold between the halves runs along one of the diagonals.
    let solid_angle = if c.x * c.y > 0.0 { angle(a, b, e) + angle(b, d, e) } else { angle(a, b, d) + angle(a, d, e) };
    LightRay {
        ray: Ray::new(Vec3::from_array(light.a), octahedral::decode(c)),
        flux: Vec3::from_array(light.radiance) * solid_angle,
        area: 0.0,
        solid_angle,
    }
}

#[inline(always)]
fn spot_ray(p: &RsmParams, light: &SceneLight, square: Vec2) -> LightRay {
    let direction = Vec3::from_array(light.b);
    let spread = 1.0 - light.c[1];
    let local = sampling::cone(square, spread);
    let solid_angle = 2.0 * PI * spread / (p.resolution * p.resolution) as f32;
    LightRay {
        ray: Ray::new(Vec3::from_array(light.a), Frame::new(direction).world_from_local(local)),
        flux: Vec3::from_array(light.radiance) * (spot_falloff(light, local.z) * solid_angle),
        area: 0.0,
        solid_angle,
    }
}

/// A square that covers the scene's sphere as the light sees it.
#[inline(always)]
fn directional_ray(p: &RsmParams, map: &RsmMap, light: &SceneLight, square: Vec2) -> LightRay {
    let direction = Vec3::from_array(light.b);
    let radius = map.centre_radius.w;
    let frame = Frame::new(direction);
    let start = Vec3::new((square.x * 2.0 - 1.0) * radius, (square.y * 2.0 - 1.0) * radius, -radius);
    let side = 2.0 * radius / p.resolution as f32;
    LightRay {
        ray: Ray::new(map.centre_radius.truncate() + frame.world_from_local(start), direction),
        flux: Vec3::from_array(light.radiance) * (side * side),
        area: side * side,
        solid_angle: 0.0,
    }
}

/// Ray `k` of all emissive triangles: the triangle by its power, a point on it, a cosine-distributed direction.
#[inline(always)]
fn emitter_ray(p: &RsmParams, map: &RsmMap, lights: &[SceneLight], k: u32) -> LightRay {
    let before = if map.light > 0 { lights[(map.light - 1) as usize].cumulative } else { 0.0 };
    let share = 1.0 - before;
    let pick = picked(lights, map.light, p.light_count, before + share * ((k as f32 + 0.5) / map.ray_count as f32));
    let light = lights[pick as usize];
    let (a, b, c) = (Vec3::from_array(light.a), Vec3::from_array(light.b), Vec3::from_array(light.c));
    let normal = unit_or((b - a).cross(c - a), Vec3::Y);
    let weights = sampling::triangle(rand2(p.seed, k, 0));
    let point = a + (b - a) * weights.x + (c - a) * weights.y;
    let local = cosine_hemisphere(shifted(p, k));
    let direction = Frame::new(normal).world_from_local(local);
    let rays = max(map.ray_count as f32 * light.probability / max(share, f32::MIN_POSITIVE), f32::MIN_POSITIVE);
    // Leave the lamp by its rounding.
    let reach = max(crate::math::vector::max_component(a.abs()), crate::math::vector::max_component((b - a).abs()));
    let start = leave_surface(point, normal, reach * 1e-6, direction);
    LightRay {
        ray: Ray::new(start, direction),
        flux: Vec3::from_array(light.radiance) * (PI * light.area / rays),
        area: 0.0,
        solid_angle: PI / (map.ray_count as f32 * max(local.z, GRAZING)),
    }
}

/// The first light from `first` on whose share of the cumulative power holds `u`.
fn picked(lights: &[SceneLight], first: u32, count: u32, u: f32) -> u32 {
    let (mut low, mut high) = (first, count - 1);
    while low < high {
        let middle = (low + high) / 2;
        if lights[middle as usize].cumulative > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    low
}

/// Line `k` through the scene's sphere: lines of uniform density carry radiance · 4π · πr² together.
#[inline(always)]
fn environment_ray(p: &RsmParams, map: &RsmMap, k: u32) -> LightRay {
    let radius = map.centre_radius.w;
    let direction = sampling::sphere(shifted(p, k));
    let disk = sampling::disk(rand2(p.seed, k, 1)) * radius;
    let start = Frame::new(direction).world_from_local(Vec3::new(disk.x, disk.y, -radius));
    let each = 1.0 / map.ray_count as f32;
    LightRay {
        ray: Ray::new(map.centre_radius.truncate() + start, direction),
        flux: p.environment.truncate() * (4.0 * PI * PI * radius * radius * each),
        // Lines meet every side of a surface with π of their measure per area: independent of the angle.
        area: 4.0 * PI * radius * radius * each * GRAZING,
        solid_angle: 0.0,
    }
}

/// Point `k` of the R2 sequence, shifted by the seed.
#[inline(always)]
fn shifted(p: &RsmParams, k: u32) -> Vec2 {
    rotate(sampling::r2(k), Vec2::new(unit(hash(p.seed)), unit(hash(p.seed ^ 0x9E37_79B9))))
}

#[cfg(not(target_arch = "spirv"))]
fn case(input: &mut CaseInput) -> Case {
    use glam::Vec4;
    let scene = CaseScene::new(input);
    let resolution = 4;
    let count = input.count.next_multiple_of(16);
    let emitters = 3;
    let radius = match input.flavour {
        crate::kernel::Flavour::Ordinary => 3.0,
        crate::kernel::Flavour::Zero => 0.0,
        crate::kernel::Flavour::Tiny => f32::MIN_POSITIVE * 8.0,
        crate::kernel::Flavour::Huge => 3e15,
    };
    let maps: alloc::vec::Vec<RsmMap> = (0..count as u32 / 16)
        .map(|k| {
            let kind = [LIGHT_POINT, LIGHT_SPOT, LIGHT_DIRECTIONAL, 3, MAP_ENVIRONMENT][k as usize % 5];
            RsmMap {
                centre_radius: Vec3::ZERO.extend(radius),
                kind,
                light: kind.min(emitters),
                first: k / 5 * 16,
                ray_count: count as u32,
            }
        })
        .collect();
    let params = RsmParams {
        environment: Vec4::new(0.5, 0.25, 0.125, 0.0),
        resolution,
        first: if count > 16 { 16 } else { 0 },
        count: if count > 16 { count as u32 - 16 } else { count as u32 },
        light_count: scene.lights.len() as u32,
        seed: input.bits(),
        _pad0: 0,
        _pad1: 0,
        _pad2: 0,
    };
    scene.bind(Case::default().uniform(&params)).read(&scene.lights).read(&maps).zeroed::<RsmTexel>(count)
}

kernel! {
    /// Rays from lights to lit surface points.
    mod lpv_rsm = super::texel; entry "lpv_rsm" threads(64);
    uniform 0 params: RsmParams;
    read 1 nodes: BvhNode;
    read 2 triangles: SceneTriangle;
    read 3 attributes: TriangleAttributes;
    read 4 surfaces: u32;
    read 5 lights: SceneLight;
    read 6 maps: RsmMap;
    write 7 out: RsmTexel;
    over super::texels;
    case super::case; tolerance Tolerance::RelAbs(2e-3, 2e-5), "solid angles of small texels by atan2 (2e-5 on devices, of angles down to 0.02 sr); about 50 roundings in coordinates up to 4";
}
