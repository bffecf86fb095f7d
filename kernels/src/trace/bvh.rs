//! Closest hit and any hit through the four-wide BVH.

use super::SceneRef;
use super::ray::{Hit, Ray, RayFrame, SlabRay};
use super::surface::alpha_cuts;
use crate::math::float::{abs, max};
use glam::Vec4;
use interreflect_shared::scene::{BVH_STACK_SIZE, CHILD_COUNT_BITS, MAX_LEAF_TRIANGLES, TRIANGLE_MASKED};

/// Reference of the root: inner node 0.
const ROOT: u32 = 0;
/// Distance of a child that the ray does not meet.
const MISS: f32 = f32::MAX;

/// The nearest triangle that the ray meets; of triangles at the same distance the one that the walk finds first.
#[inline(always)]
pub fn closest_hit(scene: &SceneRef<'_>, ray: &Ray) -> Hit {
    let frame = RayFrame::new(ray);
    let slabs = SlabRay::new(ray, reach(scene, ray));
    let mut hit = Hit::none(ray.t_max);
    let mut stack = [0u32; BVH_STACK_SIZE];
    let mut stack_t = [0f32; BVH_STACK_SIZE];
    let mut top = 0;
    let mut child = ROOT;
    loop {
        let count = child & MAX_LEAF_TRIANGLES;
        let first = child >> CHILD_COUNT_BITS;
        // Children that the ray meets come next, the nearest first.
        let mut next = ROOT;
        if count == 0 {
            let c = sorted(children(scene, first, &slabs, ray.t_min, hit.t));
            if c.t3 < MISS {
                stack[top] = c.r3;
                stack_t[top] = c.t3;
                top += 1;
            }
            if c.t2 < MISS {
                stack[top] = c.r2;
                stack_t[top] = c.t2;
                top += 1;
            }
            if c.t1 < MISS {
                stack[top] = c.r1;
                stack_t[top] = c.t1;
                top += 1;
            }
            if c.t0 < MISS {
                next = c.r0;
            }
        } else {
            for i in first..first + count {
                hit = nearer(scene, &frame, ray, i, hit);
            }
        }
        // What lies behind a hit found since it was pushed is left out.
        while next == ROOT && top > 0 {
            top -= 1;
            if stack_t[top] <= hit.t {
                next = stack[top];
            }
        }
        if next == ROOT {
            return hit;
        }
        child = next;
    }
}

/// Whether the ray meets any triangle between its `t_min` and `t_max`.
#[inline(always)]
pub fn any_hit(scene: &SceneRef<'_>, ray: &Ray) -> bool {
    let frame = RayFrame::new(ray);
    let slabs = SlabRay::new(ray, reach(scene, ray));
    let none = Hit::none(ray.t_max);
    let mut stack = [0u32; BVH_STACK_SIZE];
    let mut top = 0;
    let mut child = ROOT;
    loop {
        let count = child & MAX_LEAF_TRIANGLES;
        let first = child >> CHILD_COUNT_BITS;
        if count == 0 {
            let c = children(scene, first, &slabs, ray.t_min, ray.t_max);
            if c.t3 < MISS {
                stack[top] = c.r3;
                top += 1;
            }
            if c.t2 < MISS {
                stack[top] = c.r2;
                top += 1;
            }
            if c.t1 < MISS {
                stack[top] = c.r1;
                top += 1;
            }
            if c.t0 < MISS {
                stack[top] = c.r0;
                top += 1;
            }
        } else {
            for i in first..first + count {
                if nearer(scene, &frame, ray, i, none).is_some() {
                    return true;
                }
            }
        }
        if top == 0 {
            return false;
        }
        top -= 1;
        child = stack[top];
    }
}

/// The hit with triangle `i` where it is nearer than `hit`.
#[inline(always)]
fn nearer(scene: &SceneRef<'_>, frame: &RayFrame, ray: &Ray, i: u32, hit: Hit) -> Hit {
    let [t, u, v] = frame.intersect(&scene.triangles[i as usize]);
    let found = t >= ray.t_min && t < hit.t && t >= 0.0;
    if !found {
        return hit;
    }
    if scene.triangles[i as usize].flags & TRIANGLE_MASKED != 0 && alpha_cuts(scene, i, u, v) {
        return hit;
    }
    Hit { t, triangle: i, u, v }
}

/// Entry distances ([`MISS`] without) and references of a node's children.
#[derive(Clone, Copy)]
struct Children {
    t0: f32,
    t1: f32,
    t2: f32,
    t3: f32,
    r0: u32,
    r1: u32,
    r2: u32,
    r3: u32,
}

/// Slab test of a node's four children (Kay & Kajiya 1986).
#[inline(always)]
fn children(scene: &SceneRef<'_>, node: u32, slabs: &SlabRay, t_min: f32, t_max: f32) -> Children {
    let n = &scene.nodes[node as usize];
    let (x, y, z) = (slabs.inverse.x, slabs.inverse.y, slabs.inverse.z);
    let (x0, x1) = ((n.min_x - Vec4::splat(slabs.low.x)) * x, (n.max_x - Vec4::splat(slabs.high.x)) * x);
    let (y0, y1) = ((n.min_y - Vec4::splat(slabs.low.y)) * y, (n.max_y - Vec4::splat(slabs.high.y)) * y);
    let (z0, z1) = ((n.min_z - Vec4::splat(slabs.low.z)) * z, (n.max_z - Vec4::splat(slabs.high.z)) * z);
    let near = x0.min(x1).max(y0.min(y1)).max(z0.min(z1)).max(Vec4::splat(t_min));
    let far = x0.max(x1).min(y0.max(y1)).min(z0.max(z1)).min(Vec4::splat(t_max));
    Children {
        t0: if near.x <= far.x { near.x } else { MISS },
        t1: if near.y <= far.y { near.y } else { MISS },
        t2: if near.z <= far.z { near.z } else { MISS },
        t3: if near.w <= far.w { near.w } else { MISS },
        r0: n.children[0],
        r1: n.children[1],
        r2: n.children[2],
        r3: n.children[3],
    }
}

/// Nearest first: a sorting network of five comparisons.
#[inline(always)]
fn sorted(c: Children) -> Children {
    let Children { mut t0, mut t1, mut t2, mut t3, mut r0, mut r1, mut r2, mut r3 } = c;
    (t0, r0, t1, r1) = ordered(t0, r0, t1, r1);
    (t2, r2, t3, r3) = ordered(t2, r2, t3, r3);
    (t0, r0, t2, r2) = ordered(t0, r0, t2, r2);
    (t1, r1, t3, r3) = ordered(t1, r1, t3, r3);
    (t1, r1, t2, r2) = ordered(t1, r1, t2, r2);
    Children { t0, t1, t2, t3, r0, r1, r2, r3 }
}

#[inline(always)]
fn ordered(ta: f32, ra: u32, tb: f32, rb: u32) -> (f32, u32, f32, u32) {
    if tb < ta { (tb, rb, ta, ra) } else { (ta, ra, tb, rb) }
}

/// At least the largest coordinate difference between the ray's origin and a corner of the scene's box.
#[inline(always)]
fn reach(scene: &SceneRef<'_>, ray: &Ray) -> f32 {
    let bounds = scene.nodes[ROOT as usize].centre_half;
    let o = ray.origin;
    max(max(abs(o.x - bounds.x), abs(o.y - bounds.y)), abs(o.z - bounds.z)) + bounds.w
}
