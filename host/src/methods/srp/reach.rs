//! Which sides of which charts light and views can reach, and which voxels are open air.
//!
//! Walks start at the cameras, at lamps and on the fronts of emissive triangles, and are reflected a few times: a chart's
//! side that is met belongs to the world, the inside of a wall and the underside of a box on the floor do not. By
//! reciprocity no side that these walks cannot reach sends light to what they reach. Voxels that walks pass, and the
//! empty voxels connected with them inside the scene's bounds, are where probes may stand (SL17 §4.1 floods from outside
//! in; a walk needs no closed geometry and no "outside").
//!
//! One walk in a million slips through the crack that rounding leaves where a box stands on the floor, and would open the inside
//! of the box. What one walk alone found therefore does not count: voxels take two, and sides of charts two, or one that came
//! through voxels which are open, or a way back to such voxels.

use super::charts::Patches;
use super::world::{Seen, World};
use crate::exec::{CpuExecutor, ExecutorExt};
use crate::methods::voxels::{VoxelGrid, VoxelOptions, VoxelScene};
use crate::methods::{MethodError, StageClock};
use crate::reference::trace::NO_TRIANGLE;
use crate::scene::Light;
use glam::{UVec3, Vec3};
use interreflect_kernels::math::frame::Frame;
use interreflect_kernels::math::rng::rand2;
use interreflect_kernels::math::sampling;
use interreflect_kernels::trace::leave_surface;
use interreflect_kernels::voxel::grid::place;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering::Relaxed};

/// Walks at least, and per chart.
pub(super) const WALKS: (u32, u32) = (1 << 15, 4);
/// Reflections of a walk.
pub(super) const REFLECTIONS: u32 = 8;
/// Ways by which what one walk alone met is tried to be left.
const ESCAPES: u32 = 16;
/// Voxels along the scene's longest side.
const RESOLUTION: u32 = 64;

/// What can be reached.
pub struct Reach {
    /// Per chart: front and back.
    pub exposed: Vec<[bool; 2]>,
    /// Voxels.
    pub space: Space,
}

/// A grid of voxels, some of them solid, some open.
pub struct Space {
    /// Where it lies.
    pub grid: VoxelGrid,
    /// Holds surface.
    pub solid: Vec<bool>,
    /// Empty and reached.
    pub open: Vec<bool>,
}

impl Space {
    /// Index of a voxel.
    pub fn index(&self, v: UVec3) -> usize {
        let d = self.grid.dims;
        ((v.z * d.y + v.y) * d.x + v.x) as usize
    }

    /// Voxel of an index.
    pub fn voxel(&self, i: usize) -> UVec3 {
        let d = self.grid.dims;
        let i = i as u32;
        UVec3::new(i % d.x, i / d.x % d.y, i / d.x / d.y)
    }

    /// Centre of a voxel (m).
    pub fn centre(&self, i: usize) -> Vec3 {
        self.grid.origin + (self.voxel(i).as_vec3() + 0.5) * self.grid.voxel_size
    }

    /// Voxel that holds a point, where the grid has one.
    pub fn at(&self, p: Vec3) -> Option<usize> {
        self.at_voxel((p - self.grid.origin) / self.grid.voxel_size)
    }

    /// The same of a point that is given in voxels from the grid's corner.
    pub fn at_voxel(&self, p: Vec3) -> Option<usize> {
        let v = p.floor();
        let inside = v.min_element() >= 0.0 && v.cmplt(self.grid.dims.as_vec3()).all();
        inside.then(|| self.index(v.as_uvec3()))
    }

    /// The six voxels next to one, where the grid has them.
    pub fn beside(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        let v = self.voxel(i).as_ivec3();
        let steps = [glam::IVec3::X, glam::IVec3::Y, glam::IVec3::Z];
        steps.into_iter().flat_map(|s| [s, -s]).filter_map(move |s| {
            let n = v + s;
            let inside = n.min_element() >= 0 && n.as_uvec3().cmplt(self.grid.dims).all();
            inside.then(|| self.index(n.as_uvec3()))
        })
    }
}

impl Reach {
    /// Voxelizes with the voxel kernels, walks, and floods.
    ///
    /// # Errors
    /// What the voxel kernels return.
    pub fn new(world: &World<'_>, patches: &Patches, seed: u32) -> Result<Self, MethodError> {
        let (grid, solid) = solid(world)?;
        let mut space = Space { grid, open: vec![false; solid.len()], solid };
        let passed: Vec<Passed> = space.solid.iter().map(|_| Passed::default()).collect();
        let starts = starts(world);
        let walks = WALKS.0.max(WALKS.1 * patches.count);
        let met = (0..walks).into_par_iter().flat_map_iter(|walk| {
            let random = |dimension| rand2(seed, walk, dimension);
            let (mut from, normal) = starts[walk as usize % starts.len()].sample(world, random(0));
            let mut direction = match normal {
                Some(n) => Frame::new(n).world_from_local(sampling::cosine_hemisphere(random(1))),
                None => sampling::sphere(random(1)),
            };
            let mut own = NO_TRIANGLE;
            let mut met = Vec::with_capacity(REFLECTIONS as usize);
            for reflection in 0..REFLECTIONS {
                let Some(seen) = world.closest_but(from, direction, own) else { break };
                let mut by_way_of = None;
                for voxel in along(&space, from, seen.position).filter(|i| !space.solid[*i]) {
                    passed[voxel].mark(walk);
                    by_way_of = Some(voxel);
                }
                met.push(Met { walk, seen, by_way_of });
                (from, direction) = reflected(&seen, random(2 + reflection));
                own = seen.triangle;
            }
            met
        });
        let met: Vec<Met> = met.collect();
        let seeds = passed.iter().enumerate().filter(|(_, p)| p.twice.load(Relaxed)).map(|(i, _)| i);
        let seeds: Vec<usize> = seeds.collect();
        flood(&mut space, seeds, world.scene.bounds());
        let exposed = exposed(world, &space, patches, &met, seed);
        Ok(Self { exposed, space })
    }
}

/// What a walk met.
struct Met {
    walk: u32,
    seen: Seen,
    /// The last voxel without surface on the way there.
    by_way_of: Option<usize>,
}

/// Which walks passed a voxel.
#[derive(Default)]
struct Passed {
    /// Number of one of them plus 1; 0: none.
    by: AtomicU32,
    /// Whether there was another.
    twice: AtomicBool,
}

impl Passed {
    fn mark(&self, walk: u32) {
        if self.twice.load(Relaxed) {
            return;
        }
        if let Err(other) = self.by.compare_exchange(0, walk + 1, Relaxed, Relaxed)
            && other != walk + 1
        {
            self.twice.store(true, Relaxed);
        }
    }
}

/// A way on from a surface: where it starts and its direction.
fn reflected(seen: &Seen, random: glam::Vec2) -> (Vec3, Vec3) {
    let direction = Frame::new(seen.normal).world_from_local(sampling::cosine_hemisphere(random));
    (leave_surface(seen.position, seen.normal, seen.error, direction), direction)
}

/// Per chart: whether front and back were met by two walks, or by one that came through open voxels or could have.
fn exposed(world: &World<'_>, space: &Space, patches: &Patches, met: &[Met], seed: u32) -> Vec<[bool; 2]> {
    let mut first: Vec<[Option<&Met>; 2]> = vec![[None; 2]; patches.count as usize];
    let mut exposed = vec![[false; 2]; patches.count as usize];
    for m in met {
        let (chart, side) = (patches.chart[m.seen.triangle as usize] as usize, usize::from(!m.seen.front));
        let again = first[chart][side].is_some_and(|before| before.walk != m.walk);
        exposed[chart][side] |= again || m.by_way_of.is_some_and(|v| space.open[v]);
        first[chart][side].get_or_insert(m);
    }
    exposed.par_iter_mut().zip(&first).for_each(|(exposed, met)| {
        for side in 0..2 {
            exposed[side] = exposed[side] || met[side].is_some_and(|m| escapes(world, space, m, seed));
        }
    });
    exposed
}

/// Whether there is a way from what a walk met to open voxels or out of the scene.
fn escapes(world: &World<'_>, space: &Space, met: &Met, seed: u32) -> bool {
    let escapes = |trial: u32| {
        let mut at = met.seen;
        (0..REFLECTIONS).any(|reflection| {
            let (from, direction) = reflected(&at, rand2(seed ^ 0x5759, met.walk * ESCAPES + trial, reflection));
            let Some(next) = world.closest_but(from, direction, at.triangle) else { return true };
            at = next;
            along(space, from, next.position).any(|v| space.open[v])
        })
    };
    (0..ESCAPES).any(escapes)
}

/// Where walks start.
enum Start {
    Point(Vec3),
    Triangle(u32),
}

impl Start {
    fn sample(&self, world: &World<'_>, u: glam::Vec2) -> (Vec3, Option<Vec3>) {
        match *self {
            Start::Point(p) => (p, None),
            Start::Triangle(t) => {
                let b = sampling::triangle(u);
                let s = world.surface(t, [1.0 - b.x - b.y, b.x, b.y], true);
                let n = Vec3::from(s.geometric_normal);
                (Vec3::from(s.position) + n * s.error, Some(n))
            }
        }
    }
}

/// Cameras and lamps; one of them per walk in turn, of emissive triangles up to as many as there are others and 64 more.
fn starts(world: &World<'_>) -> Vec<Start> {
    let scene = world.scene;
    let mut starts: Vec<Start> = scene.cameras.iter().map(|c| Start::Point(c.position)).collect();
    starts.extend(scene.lights.iter().filter_map(|light| match *light {
        Light::Point { position, .. } | Light::Spot { position, .. } => Some(Start::Point(position)),
        Light::Directional { .. } => None,
    }));
    let emits = |t: &crate::scene::Triangle| scene.materials[t.material as usize].emission.max_element() > 0.0;
    let lamps: Vec<u32> = (0..scene.triangles.len() as u32).filter(|t| emits(&scene.triangles[*t as usize])).collect();
    let step = lamps.len().div_ceil(starts.len() + 64).max(1);
    starts.extend(lamps.into_iter().step_by(step).map(Start::Triangle));
    if starts.is_empty() {
        let (low, high) = scene.bounds();
        starts.push(Start::Point(0.5 * (low + high)));
    }
    starts
}

/// The voxels along a segment, at steps of half a voxel.
fn along(space: &Space, from: Vec3, to: Vec3) -> impl Iterator<Item = usize> + '_ {
    let (low, size) = (space.grid.origin, space.grid.dims.as_vec3() * space.grid.voxel_size);
    let (enter, leave) = clip(from, to - from, low, low + size).unwrap_or((0.0, 0.0));
    let length = (to - from).length() * (leave - enter);
    let steps = (2.0 * length / space.grid.voxel_size).ceil() as u32;
    let at = move |k: u32| from + (to - from) * (enter + (leave - enter) * (k as f32 + 0.5) / steps as f32);
    (0..steps).filter_map(move |k| space.at(at(k)))
}

/// The part of `from + t·step`, 0 ≤ t ≤ 1, that lies in a box.
fn clip(from: Vec3, step: Vec3, low: Vec3, high: Vec3) -> Option<(f32, f32)> {
    let (mut enter, mut leave) = (0.0f32, 1.0f32);
    for axis in 0..3 {
        if step[axis] == 0.0 {
            if from[axis] < low[axis] || from[axis] > high[axis] {
                return None;
            }
            continue;
        }
        let (a, b) = ((low[axis] - from[axis]) / step[axis], (high[axis] - from[axis]) / step[axis]);
        (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
    }
    (enter < leave).then_some((enter, leave))
}

/// Opens the empty voxels that are connected with the seeds and whose centres lie within bounds, by a quarter of a voxel at
/// least: there are always centres on the bounds themselves, and rounding is not to decide.
fn flood(space: &mut Space, mut queue: Vec<usize>, (low, high): (Vec3, Vec3)) {
    let margin = 0.25 * space.grid.voxel_size;
    let inside = |p: Vec3| p.cmpge(low + margin).all() && p.cmple(high - margin).all();
    queue.retain(|i| inside(space.centre(*i)));
    queue.iter().for_each(|i| space.open[*i] = true);
    while let Some(i) = queue.pop() {
        let next: Vec<usize> =
            space.beside(i).filter(|n| !space.open[*n] && !space.solid[*n] && inside(space.centre(*n))).collect();
        next.iter().for_each(|n| space.open[*n] = true);
        queue.extend(next);
    }
}

/// Voxels that any triangle touches, by the voxel kernels.
fn solid(world: &World<'_>) -> Result<(VoxelGrid, Vec<bool>), MethodError> {
    let grid = VoxelGrid::around(world.scene.bounds(), RESOLUTION);
    let mut exec = CpuExecutor::new();
    let buffers = world.packed().upload(&mut exec)?;
    let options = VoxelOptions { method: super::NAME, anisotropic: false, limit_bytes: 1 << 30, emission_max: 0.0 };
    let voxels = VoxelScene::build(&mut exec, &buffers, &grid, &options, &mut StageClock::default())?;
    let cells = exec.read_slice::<u32>(voxels.cells)?;
    let d = grid.dims;
    let bit = |i: u32| {
        let p = place(voxels.params.levels[0], i % d.x, i / d.x % d.y, i / d.x / d.y);
        cells[2 * p.cell as usize] >> p.bit & 1 == 1
    };
    Ok((grid, (0..d.x * d.y * d.z).map(bit).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::built_in;

    fn reach(scene: &crate::scene::Scene) -> (Reach, Patches) {
        let patches = Patches::new(scene, 0.02);
        (Reach::new(&World::new(scene).unwrap(), &patches, 1).unwrap(), patches)
    }

    #[test]
    fn insides_of_boxes_and_outsides_of_rooms_are_not_of_this_world() {
        let scene = built_in::cornell_box();
        let (reach, _) = reach(&scene);
        // Every front is reached but no back, save the lamp's, half a millimetre below the ceiling.
        let backs = reach.exposed.iter().filter(|e| e[1]).count();
        assert!(reach.exposed.iter().all(|e| e[0]) && backs <= 1, "{:?}", reach.exposed);
        // Open air: the box without its blocks. The published blocks take 8.4 and 4.4 litres... of 171.
        let voxel = reach.space.grid.voxel_size.powi(3);
        let open = reach.space.open.iter().filter(|o| **o).count() as f32 * voxel;
        assert!(open > 0.11 && open < 0.16, "{open} m³");
        for inside_block in [Vec3::new(0.185, 0.08, 0.17), Vec3::new(0.37, 0.16, 0.35)] {
            assert!(!reach.space.open[reach.space.at(inside_block).unwrap()]);
        }
        assert!(reach.space.open[reach.space.at(Vec3::new(0.3, 0.45, 0.1)).unwrap()]);
    }

    #[test]
    fn rooms_behind_doors_are_reached_and_walls_are_not() {
        let scene = built_in::two_rooms(0.05, 0.3);
        let (reach, _) = reach(&scene);
        assert!(reach.exposed.iter().filter(|e| e[0]).count() >= 10);
        let (low, high) = scene.bounds();
        let open = reach.space.open.iter().filter(|o| **o).count() as f32 * reach.space.grid.voxel_size.powi(3);
        let all = (high - low).element_product();
        assert!(open > 0.6 * all && open < all, "{open} of {all}");
    }
}
