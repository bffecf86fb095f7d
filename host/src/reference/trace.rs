//! Ray queries: obvhs' traversal over an eight-wide BVH, with a watertight triangle test.
//!
//! The tree is obvhs' CWBVH (Ylitie, Karras & Laine 2017) and the walk its `traverse!`; the node test is ours, on
//! boxes unpacked to `f32`: faster where memory is not scarce, and free of the packed test's 10⁻⁴ minimum distance,
//! which would let light through corners of small scenes. Boxes are grown by the rounding error of the triangle test,
//! which is that of Woop, Benthin & Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: no ray passes
//! between two triangles that share an edge or a vertex.
//!
//! Closest hits do not depend on the tree: of equally distant triangles the one with the smallest index wins.

use super::ReferenceError;
use super::surface::alpha_passes;
use crate::scene::{Alpha, Scene};
use glam::{UVec2, Vec3, Vec3A, Vec4, Vec4Swizzles};
use obvhs::aabb::Aabb;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::cwbvh::bvh2_to_cwbvh::bvh2_to_cwbvh;
use obvhs::cwbvh::{CwBvh, node::CwBvhNode};
use obvhs::faststack::StackStack;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use obvhs::triangle::Triangle as ObvhsTriangle;

/// Deepest tree that a traversal can walk. Balanced trees of 10⁹ triangles have 10 levels.
const MAX_DEPTH: usize = 32;

/// Smallest magnitude of a direction's component in box tests, so that its inverse is finite and 0·∞ never arises.
const MIN_DIRECTION: f32 = 1e-20;

/// A box test may end this factor later than computed: 1 + 2γ₃, Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
const BOX_TMAX_SCALE: f32 = 1.000_000_4;

/// Scenes of fewer triangles are not pre-split: there is nothing to gain.
const PRESPLIT_FROM: usize = 64;

/// Share of the nodes that are tried elsewhere in the tree, for scenes of up to [`LARGE_SCENE`] triangles and beyond:
/// on 1.5 million triangles the larger share takes three times as long to build and gains 5 % of speed.
const REINSERTION_RATIO: [f32; 2] = [0.5, 0.1];
const LARGE_SCENE: usize = 400_000;

/// No triangle: nothing is excluded from a query.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// Closest intersection of a ray.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Hit {
    /// Distance in units of the direction's length.
    pub t: f32,
    /// Index into [`Scene::triangles`].
    pub triangle: u32,
    /// Weights of the three corners; they sum to 1.
    pub barycentric: Vec3,
}

/// A scene prepared for ray queries.
pub struct Tracer<'a> {
    /// The scene.
    pub scene: &'a Scene,
    bvh: WideBvh,
    /// Corners in leaf order: per axis the coordinates of the three corners (w unused).
    corners: Vec<[Vec4; 3]>,
    /// Scene triangle of each entry of `corners`; with pre-splitting a triangle has several entries.
    sources: Vec<u32>,
    /// Whether the scene's triangles' materials cut rays by alpha.
    masked: Vec<bool>,
    any_masked: bool,
}

/// obvhs' CWBVH with boxes in `f32`. Field names are those that `obvhs::traverse!` reads.
struct WideBvh {
    nodes: Vec<WideNode>,
}

/// Eight children's boxes and where they are.
#[derive(Clone, Copy)]
struct WideNode {
    /// `planes[2·axis + side][half]`: side 0 is the lower plane; four children per half.
    planes: [[Vec4; 2]; 6],
    child_base_idx: u32,
    primitive_base_idx: u32,
    child_meta: [u8; 8],
    imask: u8,
}

/// What `obvhs::traverse!` keeps, with a deeper stack than obvhs' own.
struct Walk {
    stack: StackStack<UVec2, MAX_DEPTH>,
    current_group: UVec2,
    primitive_group: UVec2,
    oct_inv4: u32,
    primitive_id: u32,
    hitmask: u32,
}

/// A ray prepared for box and triangle tests.
struct WalkRay {
    origin4: [Vec4; 3],
    inverse4: [Vec4; 3],
    /// Index of the near plane per axis in [`WideNode::planes`]; the far plane is this index ^ 1.
    near: [usize; 3],
    /// Axes (x, y, z) of the sheared space; z is the direction's largest.
    axes: [usize; 3],
    /// Shear (x, y) and scale (z).
    shear: Vec3,
    tmax: f32,
}

impl<'a> Tracer<'a> {
    /// Builds the tree: PLOC with pre-split large triangles and reinsertion, then eight-wide.
    ///
    /// # Errors
    /// [`ReferenceError::BadScene`] where an index is out of range or a vertex is not finite;
    /// [`ReferenceError::TooDeep`] where the geometry is so degenerate that the tree is deeper than the walk's stack.
    pub fn new(scene: &'a Scene) -> Result<Self, ReferenceError> {
        check(scene)?;
        let masked: Vec<bool> = scene
            .triangles
            .iter()
            .map(|t| matches!(scene.materials[t.material as usize].alpha, Alpha::Mask(_)))
            .collect();
        let any_masked = masked.iter().any(|&m| m);
        let boxes = boxes(scene);
        let packed = build_packed(scene, &boxes);
        let sources = packed.primitive_indices.clone();
        let corners = sources.iter().map(|&s| transposed(scene.corners(&scene.triangles[s as usize]))).collect();
        let bvh = WideBvh::unpack(&packed, &boxes)?;
        Ok(Self { scene, bvh, corners, sources, masked, any_masked })
    }

    /// Closest hit with 0 < t < `tmax` on any triangle but `exclude`.
    pub fn closest(&self, origin: Vec3, direction: Vec3, tmax: f32, exclude: u32) -> Option<Hit> {
        if self.bvh.nodes.is_empty() {
            return None;
        }
        let bvh = &self.bvh;
        let mut ray = WalkRay::new(origin, direction, tmax);
        let mut walk = Walk::new(direction);
        let mut best = Hit { t: tmax, triangle: NO_TRIANGLE, barycentric: Vec3::ZERO };
        let mut node;
        obvhs::traverse!(bvh, node, walk, node.hits(&ray, walk.oct_inv4), {
            let entry = walk.primitive_id as usize;
            if let Some((t, barycentric)) = ray.intersect(&self.corners[entry]) {
                let triangle = self.sources[entry];
                // An equal distance goes to the smaller index, whatever the order of the walk.
                let closer = t < best.t || (t == best.t && triangle < best.triangle);
                if closer && triangle != exclude && !self.passes(triangle, barycentric) {
                    best = Hit { t, triangle, barycentric };
                    ray.tmax = t;
                }
            }
        });
        (best.triangle != NO_TRIANGLE).then_some(best)
    }

    /// Whether anything but the triangles `exclude` lies on the ray at 0 < t < `tmax`.
    pub fn occluded(&self, origin: Vec3, direction: Vec3, tmax: f32, exclude: [u32; 2]) -> bool {
        if self.bvh.nodes.is_empty() {
            return false;
        }
        let bvh = &self.bvh;
        let ray = WalkRay::new(origin, direction, tmax);
        let mut walk = Walk::new(direction);
        let mut node;
        'walk: {
            obvhs::traverse!(bvh, node, walk, node.hits(&ray, walk.oct_inv4), {
                let entry = walk.primitive_id as usize;
                if let Some((t, barycentric)) = ray.intersect(&self.corners[entry]) {
                    let triangle = self.sources[entry];
                    if t < tmax && !exclude.contains(&triangle) && !self.passes(triangle, barycentric) {
                        break 'walk true;
                    }
                }
            });
            false
        }
    }

    /// Whether the triangle's alpha lets rays pass at a point.
    #[inline]
    pub fn passes(&self, triangle: u32, barycentric: Vec3) -> bool {
        self.any_masked && self.masked[triangle as usize] && alpha_passes(self.scene, triangle, barycentric)
    }
}

/// The first thing in the scene that a traversal could not stand.
fn check(scene: &Scene) -> Result<(), ReferenceError> {
    let bad = |what: String| Err(ReferenceError::BadScene { what });
    for (i, t) in scene.triangles.iter().enumerate() {
        if t.vertices.iter().any(|&v| v as usize >= scene.positions.len()) {
            return bad(format!("triangle {i} has a vertex beyond the last one ({})", scene.positions.len()));
        }
        if t.material as usize >= scene.materials.len() {
            return bad(format!("triangle {i} has material {} of {}", t.material, scene.materials.len()));
        }
    }
    if let Some(i) = scene.positions.iter().position(|p| !p.is_finite()) {
        return bad(format!("vertex {i} is not finite"));
    }
    if scene.normals.len() != scene.positions.len() || scene.uvs.len() != scene.positions.len() {
        return bad(format!(
            "{} positions, {} normals, {} texture coordinates: not one each",
            scene.positions.len(),
            scene.normals.len(),
            scene.uvs.len()
        ));
    }
    for (i, m) in scene.materials.iter().enumerate() {
        if m.texture.is_some_and(|t| t as usize >= scene.textures.len()) {
            return bad(format!("material {i} (`{}`) has a texture beyond the last one", m.name));
        }
    }
    for (i, t) in scene.textures.iter().enumerate() {
        let texels = t.width as usize * t.height as usize;
        if texels == 0 || t.srgba.len() != texels {
            return bad(format!("texture {i} has {} texels, not {}×{} > 0", t.srgba.len(), t.width, t.height));
        }
    }
    Ok(())
}

/// Corners with one vector per axis.
fn transposed(corners: [Vec3; 3]) -> [Vec4; 3] {
    let [a, b, c] = corners;
    [Vec4::new(a.x, b.x, c.x, 0.0), Vec4::new(a.y, b.y, c.y, 0.0), Vec4::new(a.z, b.z, c.z, 0.0)]
}

/// Room around a triangle for the rounding of its test: 4 units in the last place of the longest distance.
fn room(boxes: &[Aabb]) -> Vec3A {
    let all = boxes.iter().skip(1).fold(boxes[0], |a, b| a.union(b));
    let reach = all.diagonal().max_element() + all.min.abs().max_element().max(all.max.abs().max_element());
    Vec3A::splat(4.0 * f32::EPSILON * reach)
}

fn grown(b: &Aabb, room: Vec3A) -> Aabb {
    Aabb::new(b.min - room, b.max + room)
}

/// Exact boxes of the scene's triangles.
fn boxes(scene: &Scene) -> Vec<Aabb> {
    scene.triangles.iter().map(|t| Aabb::from_points(&scene.corners(t).map(Vec3A::from))).collect()
}

/// A tree of high quality: large triangles pre-split, PLOC, reinsertion.
fn build_packed(scene: &Scene, boxes: &[Aabb]) -> CwBvh {
    if boxes.is_empty() {
        return CwBvh::default();
    }
    let triangles: Vec<ObvhsTriangle> = scene
        .triangles
        .iter()
        .map(|t| {
            let [v0, v1, v2] = scene.corners(t).map(Vec3A::from);
            ObvhsTriangle { v0, v1, v2 }
        })
        .collect();
    let mut split = boxes.to_vec();
    let mut indices: Vec<u32> = (0..triangles.len() as u32).collect();
    if triangles.len() >= PRESPLIT_FROM {
        let mean = boxes.iter().map(Aabb::half_area).sum::<f32>() / boxes.len() as f32;
        let largest = boxes.iter().map(Aabb::half_area).fold(0.0, f32::max);
        obvhs::splits::split_aabbs_preset(&mut split, &mut indices, &triangles, mean, largest);
    }
    let room = room(boxes);
    let split: Vec<Aabb> = split.iter().map(|b| grown(b, room)).collect();
    let mut bvh2 = PlocBuilder::with_capacity(split.len()).build(
        PlocSearchDistance::High,
        &split,
        indices,
        SortPrecision::U128,
        2,
    );
    bvh2.uses_spatial_splits = true;
    ReinsertionOptimizer::default().run(&mut bvh2, REINSERTION_RATIO[usize::from(triangles.len() > LARGE_SCENE)], None);
    bvh2_to_cwbvh(&bvh2, 3, true, true)
}

impl WideBvh {
    fn unpack(packed: &CwBvh, boxes: &[Aabb]) -> Result<Self, ReferenceError> {
        let nodes: Vec<WideNode> = if boxes.is_empty() {
            Vec::new()
        } else {
            let room = room(boxes);
            packed.nodes.iter().map(|n| WideNode::unpack(n, packed, boxes, room)).collect()
        };
        let bvh = Self { nodes };
        let depth = bvh.depth();
        if depth > MAX_DEPTH { Err(ReferenceError::TooDeep { depth, limit: MAX_DEPTH }) } else { Ok(bvh) }
    }

    /// Levels of the tree.
    fn depth(&self) -> usize {
        let mut deepest = 0;
        let mut open: Vec<(usize, usize)> = if self.nodes.is_empty() { vec![] } else { vec![(0, 1)] };
        while let Some((i, depth)) = open.pop() {
            deepest = deepest.max(depth);
            let node = &self.nodes[i];
            let inner = node.imask.count_ones() as usize;
            open.extend((0..inner).map(|k| (node.child_base_idx as usize + k, depth + 1)));
        }
        deepest
    }
}

impl WideNode {
    fn unpack(node: &CwBvhNode, packed: &CwBvh, boxes: &[Aabb], room: Vec3A) -> Self {
        // An empty slot's box is inverted: no ray enters it.
        let mut planes = [[Vec4::splat(f32::MAX); 2]; 6];
        for axis in 0..3 {
            planes[2 * axis + 1] = [Vec4::splat(f32::MIN); 2];
        }
        for child in (0..8).filter(|&c| !node.is_child_empty(c)) {
            let bounds = if node.is_leaf(child) {
                // Tighter than packed; the packed box is smaller only where a triangle was split.
                let (first, count) = node.child_primitives(child);
                let sources = &packed.primitive_indices[first as usize..(first + count) as usize];
                let exact = sources.iter().fold(Aabb::empty(), |a, &s| a.union(&boxes[s as usize]));
                grown(&exact, room).intersection(&node.child_aabb(child))
            } else {
                let exact = packed.exact_node_aabbs.as_ref();
                exact.map_or(node.child_aabb(child), |e| e[node.child_node_index(child) as usize])
            };
            for axis in 0..3 {
                planes[2 * axis][child / 4][child % 4] = bounds.min[axis];
                planes[2 * axis + 1][child / 4][child % 4] = bounds.max[axis];
            }
        }
        Self {
            planes,
            child_base_idx: node.child_base_idx,
            primitive_base_idx: node.primitive_base_idx,
            child_meta: node.child_meta,
            imask: node.imask,
        }
    }

    /// Children that the ray enters, as the hit mask of obvhs' traversal: inner children by priority in the top 8
    /// bits, primitives in the others.
    #[inline(always)]
    fn hits(&self, ray: &WalkRay, oct_inv4: u32) -> u32 {
        let mut entered = 0u32;
        for half in 0..2 {
            let near = |axis: usize| (self.planes[ray.near[axis]][half] - ray.origin4[axis]) * ray.inverse4[axis];
            let far = |axis: usize| (self.planes[ray.near[axis] ^ 1][half] - ray.origin4[axis]) * ray.inverse4[axis];
            let enter = near(0).max(near(1)).max(near(2).max(Vec4::ZERO));
            let leave = far(0).min(far(1)).min(far(2)) * BOX_TMAX_SCALE;
            let hit = enter.cmple(leave.min(Vec4::splat(ray.tmax)));
            entered |= hit.bitmask() << (4 * half);
        }
        let mut mask = 0;
        while entered != 0 {
            let child = entered.trailing_zeros();
            entered &= entered - 1;
            let meta = u32::from(self.child_meta[(child & 7) as usize]);
            // An inner child's priority is its slot, mirrored by the ray's octant; a leaf's bits are its primitives.
            let inner = (u32::from(self.imask) >> child) & 1;
            let shift = ((meta & 31) ^ ((oct_inv4 & 7) * inner)) & 31;
            mask |= (meta >> 5) << shift;
        }
        mask
    }
}

impl Walk {
    #[inline(always)]
    fn new(direction: Vec3) -> Self {
        let octant = |negative: bool, bit: u32| if negative { 0 } else { bit };
        let oct = octant(direction.x < 0.0, 4) | octant(direction.y < 0.0, 2) | octant(direction.z < 0.0, 1);
        Self {
            stack: StackStack::default(),
            current_group: UVec2::new(0, 0x8000_0000),
            primitive_group: UVec2::ZERO,
            oct_inv4: oct * 0x0101_0101,
            primitive_id: 0,
            hitmask: 0,
        }
    }
}

impl WalkRay {
    #[inline(always)]
    fn new(origin: Vec3, direction: Vec3, tmax: f32) -> Self {
        let d = direction.to_array();
        let a = direction.abs();
        let z = if a.x > a.y && a.x > a.z { 0 } else { usize::from(a.y <= a.z) + 1 };
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        // Keep the winding.
        if d[z] < 0.0 {
            std::mem::swap(&mut x, &mut y);
        }
        let inverse = |c: f32| 1.0 / if c.abs() < MIN_DIRECTION { MIN_DIRECTION.copysign(c) } else { c };
        let scale = 1.0 / d[z];
        Self {
            origin4: [Vec4::splat(origin.x), Vec4::splat(origin.y), Vec4::splat(origin.z)],
            inverse4: [Vec4::splat(inverse(d[0])), Vec4::splat(inverse(d[1])), Vec4::splat(inverse(d[2]))],
            // By sign bit, as the inverse: −0 counts as negative.
            near: [0, 1, 2].map(|axis| 2 * axis + usize::from(d[axis].is_sign_negative())),
            axes: [x, y, z],
            shear: Vec3::new(d[x] * scale, d[y] * scale, scale),
            tmax,
        }
    }

    /// Distance and corner weights where 0 < t ≤ `tmax`.
    #[inline(always)]
    fn intersect(&self, corners: &[Vec4; 3]) -> Option<(f32, Vec3)> {
        let [kx, ky, kz] = self.axes;
        // Shear the corners, relative to the origin, so that the ray is the z axis.
        let z = corners[kz] - self.origin4[kz];
        let x = (corners[kx] - self.origin4[kx]) - self.shear.x * z;
        let y = (corners[ky] - self.origin4[ky]) - self.shear.y * z;
        // Edge functions: lane i is the (signed, doubled) area opposite corner i.
        let e = x.zxyw() * y.yzxw() - y.zxyw() * x.yzxw();
        let negative = e.cmplt(Vec4::ZERO).bitmask() & 7;
        let positive = e.cmpgt(Vec4::ZERO).bitmask() & 7;
        if negative != 0 && positive != 0 {
            return None;
        }
        let e = if negative | positive == 7 { e.xyz() } else { exact_edges(x, y)? };
        let det = e.x + e.y + e.z;
        let t = e.dot(z.xyz()) * self.shear.z / det;
        // Written so that NaN (a triangle seen edge on) is a miss.
        if t > 0.0 && t <= self.tmax { Some((t, e / det)) } else { None }
    }
}

/// Edge functions where one of them rounds to zero: products of two f32 are exact in f64, so the signs are right.
#[cold]
fn exact_edges(x: Vec4, y: Vec4) -> Option<Vec3> {
    let (x, y) = (x.as_dvec4(), y.as_dvec4());
    let e = [x.z * y.y - y.z * x.y, x.x * y.z - y.x * x.z, x.y * y.x - y.y * x.x];
    let outside = e.iter().any(|&e| e < 0.0) && e.iter().any(|&e| e > 0.0);
    (!outside).then(|| Vec3::new(e[0] as f32, e[1] as f32, e[2] as f32))
}
