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
/// Cost of a node's slab tests in triangle tests, for the choice of leaves. On Crytek Sponza 1 gives half as many nodes
/// more and rays no faster, 3 slower primary rays.
const NODE_COST: f32 = 2.0;
/// Children of a node.
const WIDTH: usize = 4;

impl Bvh {
    /// Builds a BVH over triangles in world space: obvhs' binary tree, folded to four children by opening the largest
    /// first. The same triangles give the same BVH. No triangles: a root without children.
    ///
    /// A ray's stack of [`BVH_STACK_SIZE`] entries always suffices: subtrees that would go too deep are built anew with
    /// halves of equal count.
    pub fn build(corners: &[[Vec3; 3]]) -> Self {
        Self::with_stack(corners, BVH_STACK_SIZE)
    }

    /// [`Bvh::build`] for a stack of another size, which must hold a balanced tree: about 3 entries for each factor of
    /// four in the number of triangles.
    fn with_stack(corners: &[[Vec3; 3]], stack: usize) -> Self {
        let mut bvh = Self { nodes: vec![empty_node()], order: Vec::new() };
        if corners.is_empty() {
            return bvh;
        }
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
        let counts = triangle_counts(&binary.nodes);
        let mut folding = Folding { corners, binary: &binary.nodes, indices: &binary.primitive_indices, counts, bvh };
        folding.fold(0, 0, stack);
        bvh = folding.bvh;
        debug_assert!(bvh.stack_need() <= stack);
        bvh
    }

    /// Fills node `node` with a balanced tree over places `first..end` of the order: halves of equal count along the
    /// longest axis of the centres' box.
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
        // Children lie behind their parents: a backward pass sees them first.
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

/// Stack entries of a balanced tree over a number of triangles: three more for each level.
fn balanced_need(triangles: usize) -> usize {
    let (mut need, mut count) = (4, triangles);
    while count > WIDTH * LEAF_TRIANGLES as usize {
        // Halved twice, rounded up.
        count = count.div_ceil(2).div_ceil(2);
        need += WIDTH - 1;
    }
    need
}

/// Triangles below each node of a binary tree. Children lie behind their parents.
fn triangle_counts(binary: &[Bvh2Node]) -> Vec<u32> {
    let mut counts: Vec<u32> = binary.iter().map(|n| n.prim_count).collect();
    let mut stack = vec![(0, false)];
    while let Some((k, done)) = stack.pop() {
        let first = binary[k].first_index as usize;
        match (binary[k].is_leaf(), done) {
            (true, _) => {}
            (false, true) => counts[k] = counts[first] + counts[first + 1],
            (false, false) => stack.extend([(k, true), (first, false), (first + 1, false)]),
        }
    }
    counts
}

struct Folding<'a> {
    corners: &'a [[Vec3; 3]],
    binary: &'a [Bvh2Node],
    indices: &'a [u32],
    counts: Vec<u32>,
    bvh: Bvh,
}

impl Folding<'_> {
    /// Makes wide node `to` from binary node `from`: its children are opened, the largest first, until there are four.
    /// `stack`: entries that the subtree may need.
    fn fold(&mut self, from: usize, to: usize, stack: usize) {
        // The last level at which a balanced subtree still fits.
        let left = stack.saturating_sub(WIDTH - 1);
        if balanced_need(self.counts[from] as usize) > left {
            return self.balance(from, to);
        }
        let children = self.opened(from);
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
                self.fold(c, child, left);
            }
        }
    }

    /// Up to four binary nodes that together cover `from`.
    fn opened(&self, from: usize) -> Vec<usize> {
        let mut children = vec![from];
        while children.len() < WIDTH {
            let area = |k: usize| self.binary[children[k]].aabb().half_area();
            let openable = (0..children.len()).filter(|&k| !self.binary[children[k]].is_leaf());
            let Some(k) = openable.max_by(|&a, &b| area(a).total_cmp(&area(b))) else { break };
            let first = self.binary[children[k]].first_index as usize;
            children[k] = first;
            children.push(first + 1);
        }
        children
    }

    /// Makes wide node `to` from all triangles below binary node `from`, whatever their places.
    fn balance(&mut self, from: usize, to: usize) {
        let first = self.bvh.order.len();
        let mut stack = vec![from];
        while let Some(k) = stack.pop() {
            let node = self.binary[k];
            if node.is_leaf() {
                self.leaf(&node);
            } else {
                stack.extend([node.first_index as usize, node.first_index as usize + 1]);
            }
        }
        self.bvh.split(self.corners, to, first, self.bvh.order.len());
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Seeded numbers in [0, 1) (PCG hash of a counter).
    fn numbers(seed: u32) -> impl FnMut() -> f32 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
            (((word >> 22) ^ word) >> 8) as f32 / 16_777_216.0
        }
    }

    fn soup(count: usize, size: impl Fn(f32) -> f32) -> Vec<[Vec3; 3]> {
        let mut next = numbers(count as u32 + 1);
        let mut point = move || Vec3::new(next(), next(), next());
        (0..count)
            .map(|k| {
                let (centre, scale) = (point(), size(k as f32 / count as f32));
                [centre, centre + point() * scale, centre + point() * scale]
            })
            .collect()
    }

    /// Every triangle in one leaf, every box around what it holds, every node reached once.
    fn check(bvh: &Bvh, corners: &[[Vec3; 3]]) {
        let mut seen = vec![0; corners.len()];
        bvh.order.iter().for_each(|&t| seen[t as usize] += 1);
        assert!(seen.iter().all(|&n| n == 1));
        let (mut places, mut reached) = (vec![0; corners.len()], vec![0; bvh.nodes.len()]);
        let mut stack = vec![0];
        while let Some(k) = stack.pop() {
            reached[k] += 1;
            let node = &bvh.nodes[k];
            let all = node_bounds(node);
            for slot in 0..WIDTH {
                let (child, bounds) = (node.children[slot], child_bounds(node, slot));
                if child == 0 {
                    assert!(bounds.lo.min_element() == f32::MAX && bounds.hi.min_element() == f32::MAX);
                    continue;
                }
                let inside = if let Some(inner) = as_inner(child) {
                    assert!(inner > k, "children lie behind their parents");
                    stack.push(inner);
                    node_bounds(&bvh.nodes[inner])
                } else {
                    let first = (child >> CHILD_COUNT_BITS) as usize;
                    let range = first..first + (child & MAX_LEAF_TRIANGLES) as usize;
                    range.clone().for_each(|place| places[place] += 1);
                    Bounds::of(bvh.order[range].iter().map(|&t| &corners[t as usize]))
                };
                assert!(bounds.lo.cmple(inside.lo).all() && bounds.hi.cmpge(inside.hi).all());
                let reach = (bounds.lo - node.centre_half.truncate()).abs();
                let reach = reach.max((bounds.hi - node.centre_half.truncate()).abs()).max_element();
                assert!(reach <= node.centre_half.w * 1.000_001 && all.lo.cmple(bounds.lo).all());
            }
        }
        assert!(places.iter().all(|&n| n == 1) && reached.iter().all(|&n| n == 1));
    }

    #[test]
    fn every_triangle_is_in_one_leaf_and_every_box_holds_its_own() {
        for count in [0, 1, 2, 4, 5, 16, 17, 100, 5_000] {
            let corners = soup(count, |_| 0.05);
            let bvh = Bvh::build(&corners);
            check(&bvh, &corners);
            assert!(bvh.stack_need() <= BVH_STACK_SIZE);
        }
    }

    #[test]
    fn the_same_triangles_give_the_same_tree() {
        let corners = soup(20_000, |x| 0.3 * x * x);
        let (a, b) = (Bvh::build(&corners), Bvh::build(&corners));
        assert!(a.nodes == b.nodes && a.order == b.order);
    }

    #[test]
    fn coincident_triangles_and_sizes_of_all_scales_do_not_overflow_the_stack() {
        let coincident = vec![[Vec3::ZERO, Vec3::X, Vec3::Y]; 3000];
        // Nested: each triangle half as large as the one before.
        let nested: Vec<[Vec3; 3]> =
            (0..100).map(|k| [Vec3::ZERO, Vec3::X, Vec3::Y].map(|p| p * 0.5f32.powi(k))).collect();
        for corners in [coincident, nested, soup(10_000, |x| (-30.0 * x).exp2())] {
            let need = balanced_need(corners.len()) + WIDTH - 1;
            for stack in [BVH_STACK_SIZE, need] {
                let bvh = Bvh::with_stack(&corners, stack);
                check(&bvh, &corners);
                assert!(bvh.stack_need() <= stack, "{} of {stack}", bvh.stack_need());
            }
        }
    }

    #[test]
    fn surface_area_cost_is_below_that_of_a_balanced_tree() {
        let corners = soup(20_000, |x| (-12.0 * x).exp2());
        let mut balanced = Bvh { nodes: vec![empty_node()], order: (0..20_000).collect() };
        balanced.split(&corners, 0, 0, corners.len());
        check(&balanced, &corners);
        let (built, even) = (Bvh::build(&corners).surface_area_cost(), balanced.surface_area_cost());
        assert!(built < 0.8 * even, "{built} against {even}");
    }
}
