//! Small random scenes for the kernels' test cases: a room of triangles of the requested flavour's size, one textured
//! material, one that is masked, one that emits, and a light of each kind.

use super::surface::srgb_table;
use crate::kernel::{Case, CaseInput, Flavour};
use crate::math::octahedral;
use alloc::vec::Vec;
use glam::{Vec3, Vec4};
use interreflect_shared::scene::*;
use interreflect_shared::trace::{CountParams, GBufferParams, TraceRay};

/// Buffers of a small scene.
pub struct CaseScene {
    nodes: Vec<BvhNode>,
    triangles: Vec<SceneTriangle>,
    attributes: Vec<TriangleAttributes>,
    surfaces: Vec<u32>,
    /// One light of each kind.
    pub lights: Vec<SceneLight>,
}

/// Triangles of a case: several levels of nodes.
const TRIANGLES: usize = 96;
/// Width and height of the case's texture.
const TEXTURE_SIZE: u32 = 4;

/// Size of the scene.
fn scale(flavour: Flavour) -> f32 {
    match flavour {
        Flavour::Ordinary => 1.0,
        Flavour::Zero => 0.0,
        Flavour::Tiny => f32::MIN_POSITIVE * 2.0,
        Flavour::Huge => 1e15,
    }
}

impl CaseScene {
    /// A scene of the requested flavour.
    pub fn new(input: &mut CaseInput) -> Self {
        let scale = scale(input.flavour);
        let corners: Vec<[Vec3; 3]> = (0..TRIANGLES)
            .map(|_| {
                let centre = input.direction() * input.unit() * 2.0;
                [(); 3].map(|()| (centre + input.direction() * 0.7) * scale)
            })
            .collect();
        let mut triangles: Vec<SceneTriangle> = corners.iter().enumerate().map(|(k, c)| triangle(k, c)).collect();
        // Neighbours in one direction share leaves: enough of an order for a small tree.
        triangles.sort_by(|a, b| a.v0[0].total_cmp(&b.v0[0]));
        let attributes = triangles.iter().map(|t| attributes(input, t)).collect();
        let mut nodes = alloc::vec![empty_node()];
        build(&mut nodes, 0, &triangles, 0, triangles.len());
        Self { nodes, attributes, surfaces: surfaces(input), lights: lights(input, &triangles, scale), triangles }
    }

    /// Adds the four scene buffers.
    pub fn bind(&self, case: Case) -> Case {
        case.read(&self.nodes).read(&self.triangles).read(&self.attributes).read(&self.surfaces)
    }
}

/// Materials: 0 textured, 1 masked, 2 emits.
fn triangle(k: usize, corners: &[Vec3; 3]) -> SceneTriangle {
    let material = (k % 3) as u32;
    SceneTriangle {
        v0: corners[0].to_array(),
        material,
        v1: corners[1].to_array(),
        flags: [0, TRIANGLE_MASKED, TRIANGLE_EMITS][k % 3],
        v2: corners[2].to_array(),
        source: k as u32,
    }
}

fn attributes(input: &mut CaseInput, t: &SceneTriangle) -> TriangleAttributes {
    let (a, b, c) = (Vec3::from_array(t.v0), Vec3::from_array(t.v1), Vec3::from_array(t.v2));
    let n = super::surface::unit_or((b - a).cross(c - a), Vec3::Y);
    TriangleAttributes {
        uv: [(); 6].map(|()| input.unit() * 4.0 - 2.0),
        normals: [(); 3].map(|()| octahedral::pack(super::surface::unit_or(n + input.direction() * 0.3, n))),
        // Two thirds of the triangles have vertex colours.
        tints: [(); 3].map(|()| if t.source.is_multiple_of(3) { 0 } else { input.bits() >> 2 }),
    }
}

fn surfaces(input: &mut CaseInput) -> Vec<u32> {
    let texels = SRGB_TABLE_WORDS + 3 * MATERIAL_WORDS;
    let size = TEXTURE_SIZE | (TEXTURE_SIZE << 16);
    let plain = SceneMaterial {
        albedo: [0.75, 0.5, 0.25],
        texture_first: texels,
        emission: [0.0; 3],
        texture_size: size,
        alpha_factor: 1.0,
        alpha_cutoff: -1.0,
        metallic: 0.0,
        roughness: 1.0,
    };
    let masked = SceneMaterial { alpha_cutoff: 0.5, ..plain };
    let lamp = SceneMaterial { emission: [4.0, 3.0, 2.0], texture_first: NO_TEXTURE, ..plain };
    let mut words = srgb_table().to_vec();
    for material in [plain, masked, lamp] {
        words.extend_from_slice(bytemuck::cast_slice(&[material]));
    }
    words.extend((0..TEXTURE_SIZE * TEXTURE_SIZE).map(|_| input.bits()));
    words
}

fn lights(input: &mut CaseInput, triangles: &[SceneTriangle], scale: f32) -> Vec<SceneLight> {
    let mut lights: Vec<SceneLight> = [LIGHT_POINT, LIGHT_SPOT, LIGHT_DIRECTIONAL]
        .into_iter()
        .map(|kind| SceneLight {
            a: (input.direction() * 2.5 * scale).to_array(),
            kind,
            b: input.direction().to_array(),
            area: 0.0,
            c: [0.9, 0.2, 0.0],
            cumulative: 0.0,
            radiance: [3.0, 2.0, 1.0],
            probability: 0.0,
        })
        .collect();
    for t in triangles.iter().filter(|t| t.flags == TRIANGLE_EMITS).take(3) {
        let (a, b, c) = (Vec3::from_array(t.v0), Vec3::from_array(t.v1), Vec3::from_array(t.v2));
        let cross = (b - a).cross(c - a) / scale.max(f32::MIN_POSITIVE);
        lights.push(SceneLight {
            a: t.v0,
            kind: LIGHT_TRIANGLE,
            b: t.v1,
            area: 0.5 * crate::math::vector::length(cross) * scale,
            c: t.v2,
            radiance: [4.0, 3.0, 2.0],
            ..lights[0]
        });
    }
    let count = lights.len();
    for (k, light) in lights.iter_mut().enumerate() {
        light.probability = 1.0 / count as f32;
        light.cumulative = (k + 1) as f32 / count as f32;
    }
    lights
}

fn empty_node() -> BvhNode {
    let far = Vec4::splat(f32::MAX);
    BvhNode {
        min_x: far,
        min_y: far,
        min_z: far,
        max_x: far,
        max_y: far,
        max_z: far,
        children: [0; 4],
        centre_half: Vec4::ZERO,
    }
}

/// Splits triangles `first..end` into four equal runs until a run fits a leaf.
fn build(nodes: &mut Vec<BvhNode>, node: usize, triangles: &[SceneTriangle], first: usize, end: usize) {
    let bounds = |first: usize, end: usize| {
        let corners = triangles[first..end].iter().flat_map(|t| [t.v0, t.v1, t.v2]).map(Vec3::from_array);
        corners.fold((Vec3::MAX, Vec3::MIN), |(lo, hi), p| (lo.min(p), hi.max(p)))
    };
    for k in 0..4 {
        let (from, to) = (first + (end - first) * k / 4, first + (end - first) * (k + 1) / 4);
        if from == to {
            continue;
        }
        let (lo, hi) = bounds(from, to);
        let child = if to - from <= 3 {
            (from as u32) << CHILD_COUNT_BITS | (to - from) as u32
        } else {
            nodes.push(empty_node());
            let child = nodes.len() - 1;
            build(nodes, child, triangles, from, to);
            (child as u32) << CHILD_COUNT_BITS
        };
        let n = &mut nodes[node];
        (n.min_x[k], n.min_y[k], n.min_z[k]) = lo.into();
        (n.max_x[k], n.max_y[k], n.max_z[k]) = hi.into();
        n.children[k] = child;
    }
    let (lo, hi) = bounds(first, end);
    nodes[node].centre_half = ((lo + hi) * 0.5).extend((hi - lo).max_element() * 0.5);
}

/// A picture of `count` pixels or a few more, from in front of the scene.
pub fn camera(count: usize) -> (GBufferParams, usize) {
    let width = count.clamp(1, 61);
    let height = count.div_ceil(width);
    let params = GBufferParams {
        position: Vec4::new(0.0, 0.0, 3.5, 0.0),
        forward: Vec4::new(0.0, 0.0, -1.0, 0.0),
        right: Vec4::new(0.8, 0.0, 0.0, 0.0),
        up: Vec4::new(0.0, 0.8, 0.0, 0.0),
        environment: Vec4::new(0.25, 0.5, 1.0, 0.0),
        width: width as u32,
        height: height as u32,
        _pad0: 0,
        _pad1: 0,
    };
    (params, width * height)
}

/// A ray from somewhere in the scene in any direction.
pub fn ray(input: &mut CaseInput) -> TraceRay {
    TraceRay {
        origin: (input.direction() * 3.0 * scale(input.flavour)).to_array(),
        t_min: 0.0,
        direction: (input.direction() + input.direction() * 0.5).to_array(),
        t_max: f32::MAX,
    }
}

/// A receiver in free space among the triangles.
pub fn surfel(input: &mut CaseInput) -> Surfel {
    let normal = input.direction().to_array();
    Surfel {
        position: (input.direction() * 1.5 * scale(input.flavour)).to_array(),
        triangle: 0,
        normal,
        geometric_normal: normal,
        ..super::surface::no_surface()
    }
}

/// Parameters of `count` elements.
pub fn count(count: usize) -> CountParams {
    CountParams { count: count as u32, _pad0: 0, _pad1: 0, _pad2: 0 }
}
