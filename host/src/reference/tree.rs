//! The reference's tree: built by obvhs, folded to eight children per node, triangles in blocks of four.
//!
//! PLOC (Meister & Bittner 2018) over pre-split large triangles, then reinsertion (Meister & Bittner 2017), give a binary
//! tree; its nodes are opened, the largest first, into nodes of eight. What holds at most four triangles is one leaf: a
//! block is tested as fast as a single triangle.

use super::ReferenceError;
use crate::scene::{Alpha, Scene};
use bytemuck::{Pod, Zeroable};
use glam::{Vec3, Vec3A, Vec4};
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use obvhs::triangle::Triangle as ObvhsTriangle;

/// Children of a node.
pub const WIDTH: usize = 8;
/// Triangles of a leaf.
pub const BLOCK: usize = 4;
/// Entries of a walk's stack. A node leaves at most seven children on it; balanced trees of 10⁹ triangles have 10 levels,
/// those of 1.5 million triangles of very different sizes 16.
pub const STACK: usize = 1024;
/// Marks a reference to a block of triangles.
pub const LEAF: u32 = 1 << 31;
/// Marks a triangle that lets rays pass by its alpha, so that others need not be looked up.
pub const MASKED: u32 = 1 << 31;

/// Scenes of fewer triangles are not pre-split: there is nothing to gain.
const PRESPLIT_FROM: usize = 64;
/// Share of the nodes that are tried elsewhere in the tree, for scenes of up to [`LARGE_SCENE`] triangles and beyond:
/// on 1.5 million triangles the larger share takes three times as long to build and gains 5 % of speed.
const REINSERTION_RATIO: [f32; 2] = [0.5, 0.1];
const LARGE_SCENE: usize = 400_000;

/// Eight children's boxes and where they are.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C, align(32))]
pub struct Node {
    /// `planes[2·axis + side]`: side 0 is the lower plane. An empty slot's box is inverted: no ray enters it.
    pub planes: [[f32; WIDTH]; 6],
    /// Index of a node, or [`LEAF`] and the index of a block.
    pub children: [u32; WIDTH],
}

/// Four triangles, one per lane; a lane without one holds NaN, which no ray hits.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub struct Block {
    /// `corners[corner][axis]`.
    pub corners: [[Vec4; 3]; 3],
    /// Index into [`Scene::triangles`], and [`MASKED`].
    pub triangles: [u32; BLOCK],
}

impl Block {
    /// Whether the triangle in a lane lets rays pass by its alpha.
    #[inline(always)]
    pub fn is_masked(&self, lane: usize) -> bool {
        self.triangles[lane] & MASKED != 0
    }
}

/// Nodes and blocks. Node 0 is the root; a tree of no triangles has no node.
#[derive(Default)]
pub struct Tree {
    /// Nodes.
    pub nodes: Vec<Node>,
    /// Leaves. With pre-splitting a triangle is in several.
    pub blocks: Vec<Block>,
}

impl Tree {
    /// Builds the tree of a scene whose indices and vertices are valid. The same scene gives the same tree.
    ///
    /// # Errors
    /// [`ReferenceError::TooDeep`] where the geometry is so degenerate that a walk's stack would not suffice.
    pub fn build(scene: &Scene) -> Result<Self, ReferenceError> {
        if scene.triangles.is_empty() {
            return Ok(Self::default());
        }
        let boxes: Vec<Aabb> =
            scene.triangles.iter().map(|t| Aabb::from_points(&scene.corners(t).map(Vec3A::from))).collect();
        let binary = binary_tree(scene, &boxes);
        let counts = counts(&binary);
        let mut folding = Folding { scene, binary: &binary, counts, tree: Self::default() };
        folding.tree.nodes.push(Node::EMPTY);
        folding.fold();
        let need = folding.tree.stack_need();
        if need > STACK { Err(ReferenceError::TooDeep { need, limit: STACK }) } else { Ok(folding.tree) }
    }

    /// Entries that a walk needs at most, in whatever order it visits children.
    fn stack_need(&self) -> usize {
        let mut need = vec![0; self.nodes.len()];
        // Children lie behind their parents.
        for (k, node) in self.nodes.iter().enumerate().rev() {
            let used = (0..WIDTH).filter(|&slot| node.is_used(slot));
            let below = used.clone().filter(|&s| node.children[s] & LEAF == 0).map(|s| need[node.children[s] as usize]);
            need[k] = below.max().unwrap_or(0).max(1) + used.count().saturating_sub(1);
        }
        need[0]
    }
}

impl Node {
    const EMPTY: Self = Self {
        planes: [
            [f32::MAX; WIDTH],
            [f32::MIN; WIDTH],
            [f32::MAX; WIDTH],
            [f32::MIN; WIDTH],
            [f32::MAX; WIDTH],
            [f32::MIN; WIDTH],
        ],
        children: [LEAF; WIDTH],
    };

    fn is_used(&self, slot: usize) -> bool {
        self.planes[0][slot] <= self.planes[1][slot]
    }

    fn set(&mut self, slot: usize, bounds: &Aabb, child: u32) {
        for axis in 0..3 {
            self.planes[2 * axis][slot] = bounds.min[axis];
            self.planes[2 * axis + 1][slot] = bounds.max[axis];
        }
        self.children[slot] = child;
    }
}

/// Room around a triangle for the rounding of its test: 4 units in the last place of the longest distance.
fn room(boxes: &[Aabb]) -> Vec3A {
    let all = boxes.iter().skip(1).fold(boxes[0], |a, b| a.union(b));
    let reach = all.diagonal().max_element() + all.min.abs().max_element().max(all.max.abs().max_element());
    Vec3A::splat(4.0 * f32::EPSILON * reach)
}

/// A binary tree of high quality: large triangles pre-split, PLOC, reinsertion. Leaves of one triangle.
fn binary_tree(scene: &Scene, boxes: &[Aabb]) -> Bvh2 {
    let mut split = boxes.to_vec();
    let mut indices: Vec<u32> = (0..boxes.len() as u32).collect();
    if boxes.len() >= PRESPLIT_FROM {
        let triangles: Vec<ObvhsTriangle> = scene
            .triangles
            .iter()
            .map(|t| {
                let [v0, v1, v2] = scene.corners(t).map(Vec3A::from);
                ObvhsTriangle { v0, v1, v2 }
            })
            .collect();
        let mean = boxes.iter().map(Aabb::half_area).sum::<f32>() / boxes.len() as f32;
        let largest = boxes.iter().map(Aabb::half_area).fold(0.0, f32::max);
        obvhs::splits::split_aabbs_preset(&mut split, &mut indices, &triangles, mean, largest);
    }
    let room = room(boxes);
    let split: Vec<Aabb> = split.iter().map(|b| Aabb::new(b.min - room, b.max + room)).collect();
    let mut tree = PlocBuilder::with_capacity(split.len()).build(
        PlocSearchDistance::High,
        &split,
        indices,
        SortPrecision::U128,
        2,
    );
    tree.uses_spatial_splits = true;
    ReinsertionOptimizer::default().run(&mut tree, REINSERTION_RATIO[usize::from(boxes.len() > LARGE_SCENE)], None);
    tree
}

/// Triangles below each node.
fn counts(binary: &Bvh2) -> Vec<u32> {
    let mut counts: Vec<u32> = binary.nodes.iter().map(|n| n.prim_count).collect();
    let mut stack = vec![(0, false)];
    while let Some((k, done)) = stack.pop() {
        let node = &binary.nodes[k];
        let first = node.first_index as usize;
        match (node.is_leaf(), done) {
            (true, _) => {}
            (false, true) => counts[k] = counts[first] + counts[first + 1],
            (false, false) => stack.extend([(k, true), (first, false), (first + 1, false)]),
        }
    }
    counts
}

struct Folding<'a> {
    scene: &'a Scene,
    binary: &'a Bvh2,
    counts: Vec<u32>,
    tree: Tree,
}

impl Folding<'_> {
    fn fold(&mut self) {
        let mut open = vec![(0, 0)];
        while let Some((from, to)) = open.pop() {
            let children = self.opened(from);
            for (slot, &child) in children.iter().enumerate() {
                let reference = if self.is_small(child) {
                    self.block(child)
                } else {
                    let next = self.tree.nodes.len() as u32;
                    self.tree.nodes.push(Node::EMPTY);
                    open.push((child, next as usize));
                    next
                };
                self.tree.nodes[to].set(slot, self.binary.nodes[child].aabb(), reference);
            }
        }
    }

    fn is_small(&self, k: usize) -> bool {
        self.counts[k] as usize <= BLOCK || self.binary.nodes[k].is_leaf()
    }

    /// Up to eight binary nodes that together cover `from`.
    fn opened(&self, from: usize) -> Vec<usize> {
        let mut children = vec![from];
        while children.len() < WIDTH {
            let area = |k: usize| self.binary.nodes[children[k]].aabb().half_area();
            let openable = (0..children.len()).filter(|&k| !self.is_small(children[k]));
            let Some(k) = openable.max_by(|&a, &b| area(a).total_cmp(&area(b))) else { break };
            let first = self.binary.nodes[children[k]].first_index as usize;
            children[k] = first;
            children.push(first + 1);
        }
        children
    }

    /// The block of the triangles below a binary node.
    fn block(&mut self, k: usize) -> u32 {
        let mut triangles = Vec::with_capacity(BLOCK);
        let mut open = vec![k];
        while let Some(k) = open.pop() {
            let node = &self.binary.nodes[k];
            let first = node.first_index as usize;
            if node.is_leaf() {
                triangles.extend_from_slice(&self.binary.primitive_indices[first..first + node.prim_count as usize]);
            } else {
                open.extend([first, first + 1]);
            }
        }
        // Parts of one split triangle are one triangle.
        triangles.sort_unstable();
        triangles.dedup();
        let mut block = Block { corners: [[Vec4::ZERO; 3]; 3], triangles: [super::trace::NO_TRIANGLE; BLOCK] };
        for lane in 0..BLOCK {
            let corners = match triangles.get(lane) {
                Some(&t) => {
                    let triangle = &self.scene.triangles[t as usize];
                    let material = &self.scene.materials[triangle.material as usize];
                    block.triangles[lane] = if matches!(material.alpha, Alpha::Mask(_)) { t | MASKED } else { t };
                    self.scene.corners(triangle)
                }
                None => [Vec3::NAN; 3],
            };
            for (to, from) in block.corners.iter_mut().zip(corners) {
                (to[0][lane], to[1][lane], to[2][lane]) = from.into();
            }
        }
        self.tree.blocks.push(block);
        LEAF | (self.tree.blocks.len() - 1) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::super::trace::{NO_TRIANGLE, Tracer};
    use super::*;
    use crate::scene::built_in::SceneBuilder;

    /// Sheets across the x axis, each nearer to the origin and smaller than the one before.
    fn shrinking(count: i32) -> Scene {
        let mut b = SceneBuilder::new("shrinking");
        let grey = b.diffuse("grey", [0.5; 3]);
        for k in 0..count {
            let x = 0.93_f32.powi(k);
            b.quad([[x, -x, -x], [x, x, -x], [x, x, x], [x, -x, x]], grey);
        }
        b.finish()
    }

    #[test]
    fn deep_trees_are_walked() {
        let count = 300;
        let scene = shrinking(count);
        let tree = Tree::build(&scene).unwrap();
        assert!(tree.stack_need() > 100, "meant to be deep: {}", tree.stack_need());
        let tracer = Tracer::new(&scene).unwrap();
        // From just before a sheet: the smaller ones lie behind.
        for k in 0..count {
            let half = 0.93_f32.powi(k);
            let hit =
                tracer.closest(Vec3::new(0.97 * half, 0.3 * half, 0.2 * half), Vec3::X, 10.0, NO_TRIANGLE).unwrap();
            assert_eq!(hit.triangle / 2, k as u32, "{hit:?}");
        }
    }
}
