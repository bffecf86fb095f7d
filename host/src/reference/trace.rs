//! Ray queries: a walk over the eight-wide tree of `tree.rs`, with a watertight triangle test.
//!
//! Children are visited by distance, and what lies behind a hit found meanwhile is left out when its turn comes. Boxes are
//! grown by the rounding error of the triangle test, which is that of Woop, Benthin & Wald, "Watertight Ray/Triangle
//! Intersection", JCGT 2(1), 2013: no ray passes between two triangles that share an edge or a vertex. Both tests work on
//! arrays, eight boxes and four triangles at once; the walk is compiled for AVX2 too and the processor decides.
//!
//! Closest hits do not depend on the tree: of equally distant triangles the one with the smallest index wins.

use super::ReferenceError;
use super::surface::alpha_passes;
use super::tree::{BLOCK, Block, LEAF, Node, STACK, Tree, WIDTH};
use crate::scene::{Alpha, Scene};
use glam::{Vec3, Vec4};
use multiversion::multiversion;
use std::cell::RefCell;

/// Smallest magnitude of a direction's component in box tests, so that its inverse is finite and 0·∞ never arises.
const MIN_DIRECTION: f32 = 1e-20;

/// A box test may end this factor later than computed: 1 + 2γ₃, Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013.
const BOX_TMAX_SCALE: f32 = 1.000_000_4;

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
    tree: Tree,
    /// Whether the scene's triangles' materials cut rays by alpha.
    masked: Vec<bool>,
    any_masked: bool,
}

impl<'a> Tracer<'a> {
    /// Builds the tree.
    ///
    /// # Errors
    /// [`ReferenceError::BadScene`] where an index is out of range or a vertex is not finite;
    /// [`ReferenceError::TooDeep`] where the geometry is so degenerate that a walk's stack would not suffice.
    pub fn new(scene: &'a Scene) -> Result<Self, ReferenceError> {
        check(scene)?;
        let masked: Vec<bool> = scene
            .triangles
            .iter()
            .map(|t| matches!(scene.materials[t.material as usize].alpha, Alpha::Mask(_)))
            .collect();
        let any_masked = masked.iter().any(|&m| m);
        Ok(Self { scene, tree: Tree::build(scene)?, masked, any_masked })
    }

    /// Closest hit with 0 < t < `tmax` on any triangle but `exclude`.
    pub fn closest(&self, origin: Vec3, direction: Vec3, tmax: f32, exclude: u32) -> Option<Hit> {
        if self.tree.nodes.is_empty() {
            return None;
        }
        let ray = WalkRay::new(origin, direction, tmax);
        let best = THREAD_STACK.with_borrow_mut(|stack| walk_to_closest(self, ray, exclude, stack.emptied()));
        (best.triangle != NO_TRIANGLE).then_some(best)
    }

    /// Whether anything but the triangles `exclude` lies on the ray at 0 < t < `tmax`.
    pub fn occluded(&self, origin: Vec3, direction: Vec3, tmax: f32, exclude: [u32; 2]) -> bool {
        if self.tree.nodes.is_empty() {
            return false;
        }
        let ray = WalkRay::new(origin, direction, tmax);
        THREAD_STACK.with_borrow_mut(|stack| walk_to_any(self, ray, exclude, stack.emptied()))
    }

    /// Whether the triangle's alpha lets rays pass at a point.
    #[inline]
    pub fn passes(&self, triangle: u32, barycentric: Vec3) -> bool {
        self.any_masked && self.masked[triangle as usize] && alpha_passes(self.scene, triangle, barycentric)
    }
}

/// A child with the distance at which a ray enters it, ordered by that distance.
#[inline(always)]
fn entry(enter: f32, child: u32) -> u64 {
    // Distances are not negative, so that their bits are ordered as they are.
    u64::from(enter.to_bits()) << 32 | u64::from(child)
}

/// What a walk has yet to visit, as [`entry`]s.
struct Stack {
    entries: [u64; STACK],
    len: usize,
}

thread_local! {
    /// One for all walks of a thread: it is too large to be cleared for every ray.
    static THREAD_STACK: RefCell<Stack> = const { RefCell::new(Stack { entries: [0; STACK], len: 0 }) };
}

impl Stack {
    #[inline(always)]
    fn emptied(&mut self) -> &mut Self {
        self.len = 0;
        self
    }

    #[inline(always)]
    fn push(&mut self, entry: u64) {
        self.entries[self.len] = entry;
        self.len += 1;
    }

    /// Orders the entries from `first` on by falling distance: the nearest is the next to be visited.
    #[inline(always)]
    fn sort_from(&mut self, first: usize) {
        for i in first + 1..self.len {
            let entry = self.entries[i];
            let mut k = i;
            while k > first && self.entries[k - 1] < entry {
                self.entries[k] = self.entries[k - 1];
                k -= 1;
            }
            self.entries[k] = entry;
        }
    }

    /// Takes the next entry that the ray enters before `tmax`.
    #[inline(always)]
    fn pop(&mut self, tmax: f32) -> Option<u32> {
        while self.len > 0 {
            self.len -= 1;
            let entry = self.entries[self.len];
            if f32::from_bits((entry >> 32) as u32) <= tmax {
                return Some(entry as u32);
            }
        }
        None
    }
}

/// Closest hit; `triangle` is [`NO_TRIANGLE`] where there is none.
#[multiversion(targets("x86_64+avx2+bmi1+bmi2+lzcnt"))]
fn walk_to_closest(tracer: &Tracer<'_>, mut ray: WalkRay, exclude: u32, stack: &mut Stack) -> Hit {
    let mut best = Hit { t: ray.tmax, triangle: NO_TRIANGLE, barycentric: Vec3::ZERO };
    let mut next = Some(0);
    while let Some(reference) = next {
        if reference & LEAF == 0 {
            next = tracer.tree.nodes[reference as usize].enter(&ray, stack);
            if next.is_some() {
                continue;
            }
        } else {
            let block = &tracer.tree.blocks[(reference & !LEAF) as usize];
            let hits = ray.intersect(block);
            let mut lanes = hits.lanes;
            while lanes != 0 {
                let lane = lanes.trailing_zeros() as usize & (BLOCK - 1);
                lanes &= lanes - 1;
                let (t, triangle) = (hits.t[lane], block.triangles[lane]);
                // An equal distance goes to the smaller index, whatever the order of the walk.
                if (t < best.t || (t == best.t && triangle < best.triangle)) && triangle != exclude {
                    let barycentric = hits.barycentric(lane);
                    if !tracer.passes(triangle, barycentric) {
                        best = Hit { t, triangle, barycentric };
                        ray.tmax = t;
                    }
                }
            }
        }
        next = stack.pop(ray.tmax);
    }
    best
}

/// Whether there is any hit.
#[multiversion(targets("x86_64+avx2+bmi1+bmi2+lzcnt"))]
fn walk_to_any(tracer: &Tracer<'_>, ray: WalkRay, exclude: [u32; 2], stack: &mut Stack) -> bool {
    let mut next = Some(0);
    while let Some(reference) = next {
        if reference & LEAF == 0 {
            // The nearest first here too: what is close hides most.
            next = tracer.tree.nodes[reference as usize].enter(&ray, stack);
            if next.is_some() {
                continue;
            }
        } else {
            let block = &tracer.tree.blocks[(reference & !LEAF) as usize];
            let hits = ray.intersect(block);
            let mut lanes = hits.lanes;
            while lanes != 0 {
                let lane = lanes.trailing_zeros() as usize & (BLOCK - 1);
                lanes &= lanes - 1;
                let triangle = block.triangles[lane];
                if hits.t[lane] < ray.tmax
                    && !exclude.contains(&triangle)
                    && !tracer.passes(triangle, hits.barycentric(lane))
                {
                    return true;
                }
            }
        }
        next = stack.pop(ray.tmax);
    }
    false
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

/// The greater of two numbers, as one instruction: neither is NaN.
#[inline(always)]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The lesser of two numbers, as one instruction: neither is NaN.
#[inline(always)]
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

impl Node {
    /// The child that the ray enters first, if any; pushes the others that it enters before its end.
    #[inline(always)]
    fn enter(&self, ray: &WalkRay, stack: &mut Stack) -> Option<u32> {
        let [near_x, near_y, near_z] = ray.near;
        let (low_x, low_y, low_z) = (&self.planes[near_x], &self.planes[near_y], &self.planes[near_z]);
        let (high_x, high_y, high_z) = (&self.planes[near_x ^ 1], &self.planes[near_y ^ 1], &self.planes[near_z ^ 1]);
        let (mut enter, mut bits) = ([0.0; WIDTH], [0u32; WIDTH]);
        for k in 0..WIDTH {
            let near_x = (low_x[k] - ray.origin.x) * ray.inverse.x;
            let near_y = (low_y[k] - ray.origin.y) * ray.inverse.y;
            let near_z = (low_z[k] - ray.origin.z) * ray.inverse.z;
            let far_x = (high_x[k] - ray.origin.x) * ray.inverse.x;
            let far_y = (high_y[k] - ray.origin.y) * ray.inverse.y;
            let far_z = (high_z[k] - ray.origin.z) * ray.inverse.z;
            enter[k] = greater(greater(near_x, near_y), greater(near_z, 0.0));
            let leave = lesser(lesser(far_x, far_y), far_z) * BOX_TMAX_SCALE;
            bits[k] = u32::from(enter[k] <= lesser(leave, ray.tmax)) << k;
        }
        let mut entered = bits.iter().fold(0, |all, bit| all | bit);
        if entered == 0 {
            return None;
        }
        let mut take = || {
            let k = entered.trailing_zeros() as usize & (WIDTH - 1);
            entered &= entered - 1;
            (entry(enter[k], self.children[k]), entered == 0)
        };
        let (mut nearest, mut last) = take();
        let first = stack.len;
        while !last {
            let other;
            (other, last) = take();
            stack.push(nearest.max(other));
            nearest = nearest.min(other);
        }
        if stack.len > first + 1 {
            stack.sort_from(first);
        }
        Some(nearest as u32)
    }
}

/// A ray prepared for box and triangle tests.
struct WalkRay {
    origin: Vec3,
    inverse: Vec3,
    /// Index of the near plane per axis in [`Node::planes`]; the far plane is this index ^ 1.
    near: [usize; 3],
    /// Axes (x, y, z) of the sheared space; z is the direction's largest.
    axes: [usize; 3],
    /// Shear (x, y) and scale (z).
    shear: Vec3,
    tmax: f32,
}

/// What a ray hits of a block.
struct BlockHits {
    /// Bit per lane with 0 < t ≤ `tmax`.
    lanes: u32,
    /// Distance per lane.
    t: [f32; BLOCK],
    /// Edge functions per lane, and their sum.
    edges: [Vec4; 3],
    determinant: Vec4,
}

impl BlockHits {
    #[inline(always)]
    fn barycentric(&self, lane: usize) -> Vec3 {
        Vec3::new(self.edges[0][lane], self.edges[1][lane], self.edges[2][lane]) / self.determinant[lane]
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
            origin,
            inverse: Vec3::new(inverse(d[0]), inverse(d[1]), inverse(d[2])),
            // By sign bit, as the inverse: −0 counts as negative.
            near: [0, 1, 2].map(|axis| 2 * axis + usize::from(d[axis].is_sign_negative())),
            axes: [x, y, z],
            shear: Vec3::new(d[x] * scale, d[y] * scale, scale),
            tmax,
        }
    }

    #[inline(always)]
    fn intersect(&self, block: &Block) -> BlockHits {
        let [kx, ky, kz] = self.axes;
        let origin = |axis: usize| Vec4::splat(self.origin[axis]);
        let (ox, oy, oz) = (origin(kx), origin(ky), origin(kz));
        let [a, b, c] = &block.corners;
        // Shear the corners, relative to the origin, so that the ray is the z axis.
        let (az, bz, cz) = (a[kz] - oz, b[kz] - oz, c[kz] - oz);
        let (ax, bx, cx) =
            (a[kx] - ox - self.shear.x * az, b[kx] - ox - self.shear.x * bz, c[kx] - ox - self.shear.x * cz);
        let (ay, by, cy) =
            (a[ky] - oy - self.shear.y * az, b[ky] - oy - self.shear.y * bz, c[ky] - oy - self.shear.y * cz);
        // Edge functions: the (signed, doubled) areas opposite the corners.
        let mut edges = [cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax];
        let zero = Vec4::ZERO;
        let on_edge = edges[0].cmpeq(zero) | edges[1].cmpeq(zero) | edges[2].cmpeq(zero);
        if on_edge.any() {
            let corners = [[ax, ay], [bx, by], [cx, cy]];
            exact_edges(&mut edges, &corners, on_edge.bitmask());
        }
        let negative = edges[0].cmplt(zero) | edges[1].cmplt(zero) | edges[2].cmplt(zero);
        let positive = edges[0].cmpgt(zero) | edges[1].cmpgt(zero) | edges[2].cmpgt(zero);
        let determinant = edges[0] + edges[1] + edges[2];
        let t = (edges[0] * az + edges[1] * bz + edges[2] * cz) * self.shear.z / determinant;
        // Written so that NaN (a triangle seen edge on, a lane without one) is a miss.
        let hit = !(negative & positive) & t.cmpgt(zero) & t.cmple(Vec4::splat(self.tmax));
        BlockHits { lanes: hit.bitmask(), t: t.to_array(), edges, determinant }
    }
}

/// Edge functions where one of them rounds to zero: products of two f32 are exact in f64, so the signs are right.
#[cold]
#[inline(never)]
fn exact_edges(edges: &mut [Vec4; 3], corners: &[[Vec4; 2]; 3], lanes: u32) {
    for lane in (0..BLOCK).filter(|lane| lanes >> lane & 1 == 1) {
        let [[ax, ay], [bx, by], [cx, cy]] = corners.map(|corner| corner.map(|axis| f64::from(axis[lane])));
        let exact = [cx * by - cy * bx, ax * cy - ay * cx, bx * ay - by * ax];
        // A sign must survive the return to f32.
        let single = |e: f64| if e == 0.0 { 0.0 } else { (e as f32).abs().max(f32::MIN_POSITIVE).copysign(e as f32) };
        for (to, from) in edges.iter_mut().zip(exact) {
            to[lane] = single(from);
        }
    }
}
