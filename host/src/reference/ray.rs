//! A ray's tests: eight boxes and four triangles at once.
//!
//! Boxes are grown by the rounding of the tests. The triangle test is that of Woop, Benthin & Wald, "Watertight Ray/Triangle
//! Intersection", JCGT 2(1), 2013: no ray passes between two triangles that share an edge or a vertex.

use super::tree::{BLOCK, Block, Node, WIDTH};
use glam::{Vec3, Vec4};

/// Smallest magnitude of a direction's component in box tests, so that its inverse is finite and 0·∞ never arises.
const MIN_DIRECTION: f32 = 1e-20;

/// How much farther than computed a ray leaves a box at most, for the relative rounding errors of both distances, seven units
/// of half an ε in all (as in Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013), doubled.
const LEAVES_LATER: f32 = 1.0 + 7.0 * f32::EPSILON;

/// Error of `plane · inverse − origin · inverse`, beyond what is relative to their difference, in units of
/// `|origin · inverse|`: three roundings of half an ε, and some.
const ORIGIN_ERROR: f32 = 2.0 * f32::EPSILON;

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

/// A ray prepared for box and triangle tests.
pub struct WalkRay {
    origin: Vec3,
    /// A plane's distance is `plane · inverse + offset`. With room for rounding, near planes are taken nearer and far
    /// planes farther than they are.
    inverse: [Vec3; 2],
    offset: [Vec3; 2],
    /// Index of the near plane per axis in [`Node::planes`]; the far plane is this index ^ 1.
    near: [usize; 3],
    /// Axes (x, y, z) of the sheared space; z is the direction's largest.
    axes: [usize; 3],
    /// Shear (x, y) and scale (z).
    shear: Vec3,
    /// Where the ray ends.
    pub tmax: f32,
}

/// Which boxes of a node a ray meets.
pub struct Met {
    /// A bit per slot.
    pub slots: u32,
    /// Where the ray enters the boxes.
    pub enter: Distances,
}

/// Distances of eight boxes, aligned so that reading one of them need not wait until all are written to memory.
#[repr(align(32))]
pub struct Distances(pub [f32; WIDTH]);

/// What a ray hits of a block.
pub struct BlockHits {
    /// Bit per lane with 0 < t ≤ `tmax`.
    pub lanes: u32,
    /// Distance per lane.
    pub t: [f32; BLOCK],
    /// Edge functions per lane, and their sum.
    edges: [[f32; BLOCK]; 3],
    determinant: [f32; BLOCK],
}

impl BlockHits {
    #[inline(always)]
    pub fn barycentric(&self, lane: usize) -> Vec3 {
        Vec3::from(self.edges.map(|edge| edge[lane])) / self.determinant[lane]
    }
}

impl WalkRay {
    /// Prepares a ray.
    #[inline(always)]
    pub fn new(origin: Vec3, direction: Vec3, tmax: f32) -> Self {
        let d = direction.to_array();
        let a = direction.abs();
        let z = if a.x > a.y && a.x > a.z { 0 } else { usize::from(a.y <= a.z) + 1 };
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        // Keep the winding.
        if d[z] < 0.0 {
            std::mem::swap(&mut x, &mut y);
        }
        let inverse = |c: f32| 1.0 / if c.abs() < MIN_DIRECTION { MIN_DIRECTION.copysign(c) } else { c };
        let near = Vec3::new(inverse(d[0]), inverse(d[1]), inverse(d[2]));
        let far = near * LEAVES_LATER;
        let room = (origin * far).abs() * ORIGIN_ERROR;
        let scale = 1.0 / d[z];
        Self {
            origin,
            inverse: [near, far],
            offset: [-origin * near - room, -origin * far + room],
            // By sign bit, as the inverse: −0 counts as negative.
            near: [0, 1, 2].map(|axis| 2 * axis + usize::from(d[axis].is_sign_negative())),
            axes: [x, y, z],
            shear: Vec3::new(d[x] * scale, d[y] * scale, scale),
            tmax,
        }
    }

    /// Tests the eight boxes of a node.
    #[inline(always)]
    pub fn meets(&self, node: &Node) -> Met {
        let distance = |k: usize, axis: usize, side: usize| {
            node.planes[self.near[axis] ^ side][k] * self.inverse[side][axis] + self.offset[side][axis]
        };
        let (mut enter, mut slots) = ([0.0; WIDTH], 0);
        for k in 0..WIDTH {
            let [near, far] = [0, 1].map(|side| [0, 1, 2].map(|axis| distance(k, axis, side)));
            enter[k] = greater(greater(near[0], near[1]), greater(near[2], 0.0));
            let leave = lesser(lesser(far[0], far[1]), lesser(far[2], self.tmax));
            slots |= u32::from(enter[k] <= leave) << k;
        }
        Met { slots, enter: Distances(enter) }
    }

    /// [`WalkRay::meets`] by this instruction set: what the compiler makes of that one takes 20 % more of all rays' time.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2", enable = "fma")]
    #[inline]
    pub fn meets_by_avx2(&self, node: &Node) -> Met {
        use std::arch::x86_64::*;
        let distance = |axis: usize, side: usize| {
            let plane: __m256 = bytemuck::cast(node.planes[self.near[axis] ^ side]);
            _mm256_fmadd_ps(plane, _mm256_set1_ps(self.inverse[side][axis]), _mm256_set1_ps(self.offset[side][axis]))
        };
        let near = _mm256_max_ps(distance(0, 0), distance(1, 0));
        let enter = _mm256_max_ps(near, _mm256_max_ps(distance(2, 0), _mm256_setzero_ps()));
        let far = _mm256_min_ps(distance(0, 1), distance(1, 1));
        let leave = _mm256_min_ps(far, _mm256_min_ps(distance(2, 1), _mm256_set1_ps(self.tmax)));
        let slots = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(enter, leave));
        Met { slots: slots as u32, enter: Distances(bytemuck::cast(enter)) }
    }

    /// Tests the four triangles of a block.
    #[inline(always)]
    pub fn intersect(&self, block: &Block) -> BlockHits {
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
        let least = edges[0].min(edges[1]).min(edges[2]);
        let greatest = edges[0].max(edges[1]).max(edges[2]);
        let determinant = edges[0] + edges[1] + edges[2];
        let t = (edges[0] * az + edges[1] * bz + edges[2] * cz) * self.shear.z / determinant;
        // Written so that NaN (a triangle seen edge on, a lane without one) is a miss.
        let hit = !(least.cmplt(zero) & greatest.cmpgt(zero)) & t.cmpgt(zero) & t.cmple(Vec4::splat(self.tmax));
        let edges = edges.map(|edge| edge.to_array());
        BlockHits { lanes: hit.bitmask(), t: t.to_array(), edges, determinant: determinant.to_array() }
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

#[cfg(test)]
mod tests {
    use super::super::sampler::hash;
    use super::*;
    use glam::DVec3;

    /// Numbers from −1 to 1.
    struct Random(u32);

    impl Random {
        fn next(&mut self) -> f32 {
            self.0 += 1;
            hash(self.0) as f32 / 2_147_483_648.0 - 1.0
        }

        fn vector(&mut self) -> Vec3 {
            Vec3::new(self.next(), self.next(), self.next())
        }
    }

    /// Where a ray enters and leaves a box, in f64; it meets the box where it enters it before it leaves it, and not behind.
    fn exact([low, high]: [Vec3; 2], origin: Vec3, direction: Vec3) -> [f64; 2] {
        let (o, d) = (origin.as_dvec3(), direction.as_dvec3());
        let [a, b] = [low, high].map(|p| (p.as_dvec3() - o) / d);
        [a.min(b).max(DVec3::ZERO).max_element(), a.max(b).min_element()]
    }

    fn node(boxes: &[[Vec3; 2]; WIDTH]) -> Node {
        let plane = |side: usize, axis: usize| boxes.map(|b| b[side][axis]);
        let planes = [plane(0, 0), plane(1, 0), plane(0, 1), plane(1, 1), plane(0, 2), plane(1, 2)];
        Node { planes, children: [0; WIDTH] }
    }

    /// What each way of testing boxes finds.
    fn ways(ray: &WalkRay, node: &Node) -> Vec<Met> {
        let mut ways = vec![ray.meets(node)];
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            // SAFETY: the processor was asked.
            #[allow(unsafe_code)]
            ways.push(unsafe { ray.meets_by_avx2(node) });
        }
        ways
    }

    #[test]
    fn no_box_is_missed_and_few_are_met_in_vain() {
        let mut random = Random(1);
        let (mut met, mut in_vain, mut missed_exactly) = (0, 0, 0);
        for trial in 0..200_000 {
            // Thin boxes, and origins near to them and far away: where rounding shows.
            let distance = [1.0, 30.0, 1e4][trial % 3];
            let boxes: [[Vec3; 2]; WIDTH] = std::array::from_fn(|_| {
                let (centre, half) = (random.vector(), random.vector().abs() * Vec3::new(1.0, 1e-3, 0.3));
                [centre - half, centre + half]
            });
            let origin = random.vector() * distance;
            // Towards a corner of one of the boxes, which the ray hits or misses by rounding alone.
            let towards = boxes[trial % WIDTH][trial / 8 % 2] - origin;
            let direction = if trial % 5 == 0 { towards * Vec3::new(1.0, 1.0, 0.0) } else { towards };
            if direction.min_element() == 0.0 && direction.max_element() == 0.0 {
                continue;
            }
            let ray = WalkRay::new(origin, direction, f32::MAX);
            let node = node(&boxes);
            for way in ways(&ray, &node) {
                for (k, bounds) in boxes.iter().enumerate() {
                    let [enter, leave] = exact(*bounds, origin, direction);
                    let found = way.slots >> k & 1 == 1;
                    if enter <= leave {
                        assert!(found, "{bounds:?} from {origin} along {direction}: {enter} to {leave}");
                        assert!(
                            f64::from(way.enter.0[k]) <= enter * (1.0 + 1e-6) + 1e-30,
                            "{} > {enter}",
                            way.enter.0[k]
                        );
                        met += 1;
                    } else {
                        missed_exactly += 1;
                        in_vain += u32::from(found);
                    }
                }
            }
        }
        assert!(met > 100_000 && missed_exactly > 1_000_000, "{met} met, {missed_exactly} not");
        // One corner in sixteen boxes is aimed at; half of those are missed by less than rounding.
        assert!(in_vain < missed_exactly / 10, "{in_vain} of {missed_exactly} met in vain");
    }

    #[test]
    fn boxes_behind_or_beyond_the_end_are_not_met() {
        let unit = [Vec3::splat(-1.0), Vec3::ONE];
        let boxes = node(&[unit; WIDTH]);
        let slots = |x: f32, tmax: f32| {
            let ray = WalkRay::new(Vec3::new(x, 0.1, 0.2), Vec3::X, tmax);
            ways(&ray, &boxes).iter().map(|m| m.slots).collect::<Vec<_>>()
        };
        assert!(slots(-3.0, 10.0).iter().all(|&s| s == 255));
        assert!(slots(0.0, 0.1).iter().all(|&s| s == 255), "from inside");
        assert!(slots(-3.0, 1.9).iter().all(|&s| s == 0), "ends before");
        assert!(slots(1.1, 10.0).iter().all(|&s| s == 0), "behind");
    }
}
