//! The walk of a ray through the eight-wide tree of `tree.rs`.
//!
//! Children are visited by distance, and what lies behind a hit found meanwhile is left out when its turn comes. The walk is
//! compiled for AVX2 too, and the processor decides.

use super::ray::{Distances, Met, WalkRay};
use super::surface::alpha_passes;
use super::trace::{Hit, NO_TRIANGLE, Tracer};
use super::tree::{BLOCK, Block, LEAF, MASKED, Node, STACK, Tree, WIDTH};
use glam::Vec3;
use interreflect_kernels::kernel::prefetch;
use multiversion::{multiversion, target::match_target};
use std::cell::RefCell;

/// Closest hit with 0 < t < `tmax` on any triangle but `exclude`.
pub fn closest(tracer: &Tracer<'_>, origin: Vec3, direction: Vec3, tmax: f32, exclude: u32) -> Option<Hit> {
    if tracer.tree.nodes.is_empty() {
        return None;
    }
    let best = THREAD_STACK
        .with_borrow_mut(|stack| walk_to_closest(tracer, origin, direction, tmax, exclude, stack.emptied()));
    (best.triangle != NO_TRIANGLE).then_some(best)
}

/// Whether anything but the triangles `exclude` lies on the ray at 0 < t < `tmax`.
pub fn occluded(tracer: &Tracer<'_>, origin: Vec3, direction: Vec3, tmax: f32, exclude: [u32; 2]) -> bool {
    !tracer.tree.nodes.is_empty()
        && THREAD_STACK.with_borrow_mut(|stack| walk_to_any(tracer, origin, direction, tmax, exclude, stack.emptied()))
}

/// The boxes of a node that a ray meets, by the best instructions that the function around is compiled for.
macro_rules! boxes {
    ($node:expr, $ray:expr) => {
        match_target! {
            "x86_64+avx2+fma+bmi1+bmi2+lzcnt" => $ray.meets_by_avx2($node),
            _ => $ray.meets($node),
        }
    };
}

/// Closest hit; `triangle` is [`NO_TRIANGLE`] where there is none.
#[multiversion(targets("x86_64+avx2+fma+bmi1+bmi2+lzcnt"))]
fn walk_to_closest(
    tracer: &Tracer<'_>,
    origin: Vec3,
    direction: Vec3,
    tmax: f32,
    exclude: u32,
    stack: &mut Stack,
) -> Hit {
    let tree = &*tracer.tree;
    let mut ray = WalkRay::new(origin, direction, tmax);
    let mut best = Hit { t: tmax, triangle: NO_TRIANGLE, barycentric: Vec3::ZERO };
    let mut next = Some(0);
    while let Some(reference) = next {
        if reference & LEAF == 0 {
            let node = &tree.nodes[reference as usize];
            next = stack.enter::<true>(boxes!(node, ray), node, tree);
            if next.is_some() {
                continue;
            }
        } else {
            let block = &tree.blocks[(reference & !LEAF) as usize];
            let hits = ray.intersect(block);
            let mut lanes = hits.lanes;
            while lanes != 0 {
                let lane = lanes.trailing_zeros() as usize & (BLOCK - 1);
                lanes &= lanes - 1;
                let (t, triangle) = (hits.t[lane], block.triangles[lane] & !MASKED);
                // An equal distance goes to the smaller index, whatever the order of the walk.
                if (t < best.t || (t == best.t && triangle < best.triangle)) && triangle != exclude {
                    let barycentric = hits.barycentric(lane);
                    if !(block.is_masked(lane) && alpha_passes(tracer.scene, triangle, barycentric)) {
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
#[multiversion(targets("x86_64+avx2+fma+bmi1+bmi2+lzcnt"))]
fn walk_to_any(
    tracer: &Tracer<'_>,
    origin: Vec3,
    direction: Vec3,
    tmax: f32,
    exclude: [u32; 2],
    stack: &mut Stack,
) -> bool {
    let tree = &*tracer.tree;
    let ray = WalkRay::new(origin, direction, tmax);
    let mut next = Some(0);
    while let Some(reference) = next {
        if reference & LEAF == 0 {
            // The nearest first here too: what is close hides most. The order of the others does not pay for itself.
            let node = &tree.nodes[reference as usize];
            next = stack.enter::<false>(boxes!(node, ray), node, tree);
            if next.is_some() {
                continue;
            }
        } else {
            let block = &tree.blocks[(reference & !LEAF) as usize];
            let hits = ray.intersect(block);
            let mut lanes = hits.lanes;
            while lanes != 0 {
                let lane = lanes.trailing_zeros() as usize & (BLOCK - 1);
                lanes &= lanes - 1;
                let triangle = block.triangles[lane] & !MASKED;
                if hits.t[lane] < tmax
                    && !exclude.contains(&triangle)
                    && !(block.is_masked(lane) && alpha_passes(tracer.scene, triangle, hits.barycentric(lane)))
                {
                    return true;
                }
            }
        }
        next = stack.pop(tmax);
    }
    false
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

    /// The nearest of a node's children that a ray met, if any; pushes the others, `SORTED` by distance or not.
    #[inline(always)]
    fn enter<const SORTED: bool>(&mut self, met: Met, node: &Node, tree: &Tree) -> Option<u32> {
        let Met { mut slots, enter: Distances(enter) } = met;
        if slots == 0 {
            return None;
        }
        let mut take = || {
            let k = slots.trailing_zeros() as usize & (WIDTH - 1);
            slots &= slots - 1;
            (k, slots == 0)
        };
        let (k, mut last) = take();
        if last {
            return Some(node.children[k]);
        }
        let mut nearest = entry(enter[k], node.children[k]);
        let first = self.len;
        while !last {
            let k;
            (k, last) = take();
            let other = entry(enter[k], node.children[k]);
            let farther = nearest.max(other);
            tree.prefetch(farther as u32);
            self.push(farther);
            nearest = nearest.min(other);
        }
        if SORTED && self.len > first + 1 {
            self.sort_from(first);
        }
        Some(nearest as u32)
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

impl Tree {
    /// Asks for what a reference names before its turn comes.
    #[inline(always)]
    fn prefetch(&self, reference: u32) {
        // One address by a choice of numbers: a branch here is guessed wrong half of the time.
        let index = (reference & !LEAF) as usize;
        let nodes: &[Unit] = bytemuck::cast_slice(&self.nodes);
        let blocks: &[Unit] = bytemuck::cast_slice(&self.blocks);
        let (units, at) = if reference & LEAF == 0 {
            (nodes, index * (size_of::<Node>() / size_of::<Unit>()))
        } else {
            (blocks, index * (size_of::<Block>() / size_of::<Unit>()))
        };
        // Units of 32 bytes, cache lines of 64.
        for line in [0, 2, 4] {
            prefetch(units, at + line);
        }
    }
}

/// Of these nodes and blocks are multiples.
type Unit = [u64; 4];
