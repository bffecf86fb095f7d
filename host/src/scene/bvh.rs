//! The bounding volume hierarchy that kernels walk: built by obvhs (PLOC with parallel reinsertion: Meister & Bittner
//! 2018, 2017), four children to a node.

use glam::{Vec3, Vec3A, Vec4};
use interreflect_shared::scene::{BVH_STACK_SIZE, BvhNode, CHILD_COUNT_BITS, MAX_LEAF_TRIANGLES};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::triangle::Triangle as BvhTriangle;
use std::time::Duration;

/// A BVH and the order of triangles that its leaves index.
#[derive(Clone, Debug)]
pub struct Bvh {
    /// Nodes; 0 is the root.
    pub nodes: Vec<BvhNode>,
    /// For each place in the leaves' order the index of the triangle that was given.
    pub order: Vec<u32>,
}

/// Triangles of a leaf at most. Few: a triangle costs a ray more than a quarter of a node.
const LEAF_TRIANGLES: u32 = 4;
/// Cost of a node's slab tests in triangle tests, for the choice of leaves.
const NODE_COST: f32 = 1.0;
/// Children of a node.
const WIDTH: usize = 4;

impl Bvh {
    /// Builds a BVH over triangles in world space. The same triangles give the same BVH. No triangles: a root without
    /// children.
    pub fn build(corners: &[[Vec3; 3]]) -> Self {
        if corners.is_empty() {
            return Self { nodes: vec![empty_node()], order: Vec::new() };
        }
        let bvh = Self::by_surface_area(corners);
        if bvh.stack_need() <= BVH_STACK_SIZE { bvh } else { Self::balanced(corners) }
    }

    /// obvhs' binary tree, folded to four children by opening the largest first.
    fn by_surface_area(corners: &[[Vec3; 3]]) -> Self {
        let triangles: Vec<BvhTriangle> = corners
            .iter()
            .map(|[a, b, c]| BvhTriangle { v0: Vec3A::from(*a), v1: Vec3A::from(*b), v2: Vec3A::from(*c) })
            .collect();
        let params = BvhBuildParams {
            max_prims_per_leaf: LEAF_TRIANGLES,
            collapse_traversal_cost: NODE_COST,
            ..BvhBuildParams::medium_build()
        };
        let binary = build_bvh2(&triangles, params, &mut Duration::default());
        let mut folding = Folding { binary: &binary.nodes, indices: &binary.primitive_indices, bvh: Self::empty() };
        folding.bvh.nodes.push(empty_node());
        folding.fold(0, 0);
        folding.bvh
    }

    fn empty() -> Self {
        Self { nodes: Vec::new(), order: Vec::new() }
    }

    /// Halves of equal count along the longest axis of the centres' box: the depth is the logarithm of the count, whatever
    /// the triangles.
    fn balanced(corners: &[[Vec3; 3]]) -> Self {
        let mut bvh = Self { nodes: vec![empty_node()], order: (0..corners.len() as u32).collect() };
        bvh.split(corners, 0, 0, corners.len());
        bvh
    }

    fn split(&mut self, corners: &[[Vec3; 3]], node: usize, first: usize, end: usize) {
        let middle = first + (end - first) / 2;
        halve(corners, &mut self.order[first..end]);
        halve(corners, &mut self.order[first..middle]);
        halve(corners, &mut self.order[middle..end]);
        let cuts = [first, first + (middle - first) / 2, middle, middle + (end - middle) / 2, end];
        for slot in 0..WIDTH {
            let (from, to) = (cuts[slot], cuts[slot + 1]);
            if from == to {
                continue;
            }
            let bounds = Bounds::of(self.order[from..to].iter().map(|&t| &corners[t as usize]));
            let child = if to - from <= LEAF_TRIANGLES as usize {
                leaf(from, to - from)
            } else {
                let child = self.nodes.len();
                self.nodes.push(empty_node());
                self.split(corners, child, from, to);
                inner(child)
            };
            set_child(&mut self.nodes[node], slot, bounds, child);
        }
        close(&mut self.nodes[node]);
    }

    /// Entries that a ray's stack needs at most, whichever children it meets in whichever order.
    pub fn stack_need(&self) -> usize {
        // Children lie behind their parents, so that a backward pass sees them first.
        let mut need = vec![0; self.nodes.len()];
        for (k, node) in self.nodes.iter().enumerate().rev() {
            let children = node.children.iter().filter(|&&c| c != 0);
            let below = children.clone().filter_map(|&c| as_inner(c)).map(|c| need[c]).max().unwrap_or(0);
            need[k] = below.max(1) + children.count().saturating_sub(1);
        }
        need[0]
    }

    /// Expected cost of a ray by the surface area heuristic (MacDonald & Booth 1990), in triangle tests: a node's four
    /// slab tests count as one.
    pub fn surface_area_cost(&self) -> f64 {
        let mut cost = 1.0;
        let root = self.nodes.first().map_or(0.0, |n| node_bounds(n).half_area());
        for (node, slot) in self.nodes.iter().flat_map(|n| (0..WIDTH).map(move |slot| (n, slot))) {
            let child = node.children[slot];
            if child != 0 {
                let tests = if as_inner(child).is_some() { 1 } else { child & MAX_LEAF_TRIANGLES };
                cost += f64::from(tests) * child_bounds(node, slot).half_area() / root;
            }
        }
        cost
    }
}

/// Index of the inner node that a child reference means, `None` for a leaf or no child.
fn as_inner(child: u32) -> Option<usize> {
    (child != 0 && child & MAX_LEAF_TRIANGLES == 0).then_some((child >> CHILD_COUNT_BITS) as usize)
}

fn inner(node: usize) -> u32 {
    (node as u32) << CHILD_COUNT_BITS
}

fn leaf(first: usize, count: usize) -> u32 {
    (first as u32) << CHILD_COUNT_BITS | count as u32
}

/// Orders triangles so that those with smaller centres along the longest axis come into the first half.
fn halve(corners: &[[Vec3; 3]], order: &mut [u32]) {
    if order.len() < 2 {
        return;
    }
    let centre = |t: u32| corners[t as usize].iter().sum::<Vec3>();
    let (lo, hi) = order.iter().fold((Vec3::MAX, Vec3::MIN), |(lo, hi), &t| (lo.min(centre(t)), hi.max(centre(t))));
    let axis = (hi - lo).max_position();
    let middle = order.len() / 2;
    order.select_nth_unstable_by(middle, |&a, &b| centre(a)[axis].total_cmp(&centre(b)[axis]).then(a.cmp(&b)));
}

struct Folding<'a> {
    binary: &'a [Bvh2Node],
    indices: &'a [u32],
    bvh: Bvh,
}

impl Folding<'_> {
    /// Makes wide node `to` from binary node `from`: its children are opened, the largest first, until there are four.
    fn fold(&mut self, from: usize, to: usize) {
        let mut children = vec![from];
        while children.len() < WIDTH {
            let area = |&k: &usize| self.binary[k].aabb().half_area();
            let openable = (0..children.len()).filter(|&k| !self.binary[children[k]].is_leaf());
            let Some(k) = openable.max_by(|&a, &b| area(&children[a]).total_cmp(&area(&children[b]))) else { break };
            let first = self.binary[children[k]].first_index as usize;
            children[k] = first;
            children.push(first + 1);
        }
        // Inner children get neighbouring places before any of their own children.
        let mut next = self.bvh.nodes.len();
        let inner_count = children.iter().filter(|&&c| !self.binary[c].is_leaf()).count();
        self.bvh.nodes.resize(next + inner_count, empty_node());
        for (slot, &c) in children.iter().enumerate() {
            let node = &self.binary[c];
            let bounds = Bounds { lo: node.aabb().min.into(), hi: node.aabb().max.into() };
            let child = if node.is_leaf() {
                self.leaf(node)
            } else {
                next += 1;
                inner(next - 1)
            };
            set_child(&mut self.bvh.nodes[to], slot, bounds, child);
        }
        close(&mut self.bvh.nodes[to]);
        for (slot, &c) in children.iter().enumerate() {
            if let Some(child) = as_inner(self.bvh.nodes[to].children[slot]) {
                self.fold(c, child);
            }
        }
    }

    fn leaf(&mut self, node: &Bvh2Node) -> u32 {
        let first = self.bvh.order.len();
        let range = node.first_index as usize..(node.first_index + node.prim_count) as usize;
        self.bvh.order.extend_from_slice(&self.indices[range]);
        leaf(first, node.prim_count as usize)
    }
}

#[derive(Clone, Copy)]
struct Bounds {
    lo: Vec3,
    hi: Vec3,
}

impl Bounds {
    fn of<'a>(triangles: impl Iterator<Item = &'a [Vec3; 3]>) -> Self {
        let nothing = Self { lo: Vec3::MAX, hi: Vec3::MIN };
        triangles.flatten().fold(nothing, |b, &p| Self { lo: b.lo.min(p), hi: b.hi.max(p) })
    }
    fn join(self, other: Self) -> Self {
        Self { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }
    fn half_area(self) -> f64 {
        let d = (self.hi - self.lo).as_dvec3();
        d.x * d.y + d.y * d.z + d.z * d.x
    }
}

/// A node without children: boxes where no ray goes.
fn empty_node() -> BvhNode {
    let far = Vec4::splat(f32::MAX);
    BvhNode {
        min_x: far,
        min_y: far,
        min_z: far,
        max_x: far,
        max_y: far,
        max_z: far,
        children: [0; WIDTH],
        centre_half: Vec4::ZERO,
    }
}

fn set_child(node: &mut BvhNode, slot: usize, bounds: Bounds, child: u32) {
    (node.min_x[slot], node.min_y[slot], node.min_z[slot]) = bounds.lo.into();
    (node.max_x[slot], node.max_y[slot], node.max_z[slot]) = bounds.hi.into();
    node.children[slot] = child;
}

/// Box of one child.
fn child_bounds(node: &BvhNode, slot: usize) -> Bounds {
    Bounds {
        lo: Vec3::new(node.min_x[slot], node.min_y[slot], node.min_z[slot]),
        hi: Vec3::new(node.max_x[slot], node.max_y[slot], node.max_z[slot]),
    }
}

/// Box around a node's children.
fn node_bounds(node: &BvhNode) -> Bounds {
    let children = (0..WIDTH).filter(|&slot| node.children[slot] != 0).map(|slot| child_bounds(node, slot));
    children.fold(Bounds { lo: Vec3::MAX, hi: Vec3::MIN }, Bounds::join)
}

/// Fills in the size of a node whose children are set.
fn close(node: &mut BvhNode) {
    let Bounds { lo, hi } = node_bounds(node);
    let centre = (lo + hi) * 0.5;
    node.centre_half = centre.extend((hi - centre).max(centre - lo).max_element());
}
