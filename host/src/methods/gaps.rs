//! How narrow a scene's spaces and walls are, which is what a grid must resolve: light leaks through walls thinner than its
//! cells, and does not pass gaps narrower than them.
//!
//! From points spread over all surfaces by area a ray leaves each side along the normal, through air or through a wall alike.
//! Where it meets something, the distance is the width of the gap (or wall) that this point borders on. The widths are told by
//! the share of surface that borders on less: what few square centimetres border on does not matter, nor does what is finer than
//! the finest grid that a method would take (pages of a book, a picture on its wall): no grid makes a difference to that.

use super::{Input, StageClock};
use crate::exec::{ExecError, Executor, ExecutorExt};
use crate::scene::Scene;
use glam::Vec3;
use interreflect_kernels::math::rng::rand2;
use interreflect_kernels::trace::rays::trace_rays;
use interreflect_shared::scene::NO_SURFACE;
use interreflect_shared::trace::{CountParams, TraceHit, TraceRay};
use serde::Serialize;
use std::ops::RangeInclusive;

/// Points on surfaces. The share of surface below a width is known to about the root of share/points: 0.3 % of 10 %.
const POINTS: u32 = 8192;
/// Rays start this share of the scene's longest side away from their surface: far above the rounding of 23 bits, and
/// nothing that a grid resolves.
const START: f32 = 1e-5;

/// Widths of gaps and walls.
#[derive(Clone, PartialEq, Debug)]
pub struct Gaps {
    /// Widths (m) of both sides of all points, ascending; infinite where nothing is met.
    widths: Vec<f32>,
}

impl Gaps {
    /// Measures a scene. The same points whatever its unit and place.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn measure(exec: &mut dyn Executor, input: &Input<'_>) -> Result<Self, ExecError> {
        let (low, high) = input.scene.bounds();
        let start = START * (high - low).max_element();
        let rays = rays(input.scene, start);
        if rays.is_empty() {
            return Ok(Self { widths: Vec::new() });
        }
        let mark = exec.mark();
        let hits = trace(exec, input, &rays);
        exec.free_since(mark);
        let width = |hit: &TraceHit| if hit.triangle == NO_SURFACE { f32::INFINITY } else { hit.t };
        let mut widths: Vec<f32> = hits?.iter().map(width).collect();
        widths.sort_by(f32::total_cmp);
        Ok(Self { widths })
    }

    /// Of the gaps that are no finer than `least` (m) the width that all but `share` of all surface border on at least; `None` where
    /// there is no such gap.
    pub fn narrowest(&self, share: f32, least: f32) -> Option<f32> {
        let index = self.finer(least) + (share * self.widths.len() as f32) as usize;
        self.widths.get(index).copied().filter(|w| w.is_finite())
    }

    /// Share of all surface that borders on gaps finer than `least` (m).
    pub fn share_finer(&self, least: f32) -> f32 {
        self.finer(least) as f32 / self.widths.len().max(1) as f32
    }

    fn finer(&self, least: f32) -> usize {
        self.widths.partition_point(|w| *w < least)
    }
}

/// How a method's grid follows from gaps.
pub struct Rule {
    /// Cells that a gap must have across it.
    pub cells_per_gap: f32,
    /// Least and most cells along the longest side.
    pub resolution: RangeInclusive<u32>,
}

/// Share of the surface that may border on narrower gaps.
const SHARE: f32 = 0.05;
/// Resolutions are multiples of this.
const STEP: u32 = 16;

/// A resolution, and why.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct Choice {
    /// Cells along the longest side.
    pub resolution: u32,
    /// Width of the narrowest gap that matters (m); absent where nothing is across from anything, or a user chose.
    pub narrowest_gap_m: Option<f32>,
    /// Share of the surface that borders on gaps too fine for any grid that would be chosen.
    pub finer_share: f32,
    /// Cells that the gap would have needed along the longest side, where that is more than allowed.
    pub wanted: Option<u32>,
}

impl Choice {
    /// What a user asked for.
    fn of_user(resolution: u32) -> Self {
        Self { resolution, narrowest_gap_m: None, finer_share: 0.0, wanted: None }
    }
}

impl Rule {
    /// The grid that a user `asked` for, else the coarsest one that resolves the narrowest gap that matters.
    ///
    /// # Errors
    /// What the executor returns.
    pub fn choose(
        &self,
        asked: Option<u32>,
        exec: &mut dyn Executor,
        input: &Input<'_>,
        clock: &mut StageClock,
    ) -> Result<Choice, ExecError> {
        if let Some(resolution) = asked {
            return Ok(Choice::of_user(resolution));
        }
        let mut gaps = Gaps { widths: Vec::new() };
        clock.stage(exec, "gaps", |exec| {
            gaps = Gaps::measure(exec, input)?;
            Ok::<(), ExecError>(())
        })?;
        let (low, high) = input.scene.bounds();
        Ok(self.over((high - low).max_element(), &gaps))
    }

    /// The same for a scene whose longest side is `extent` (m).
    fn over(&self, extent: f32, gaps: &Gaps) -> Choice {
        let (least, most) = (*self.resolution.start(), *self.resolution.end());
        let finest = extent / most as f32;
        let narrowest_gap_m = gaps.narrowest(SHARE, finest);
        // Without a gap the ratio is 0.
        let cells = narrowest_gap_m.map_or(0.0, |gap| extent / gap * self.cells_per_gap);
        let needed = (cells.ceil() as u32).checked_next_multiple_of(STEP).unwrap_or(u32::MAX);
        Choice {
            resolution: needed.clamp(least, most),
            narrowest_gap_m,
            finer_share: gaps.share_finer(finest),
            wanted: (needed > most).then_some(needed),
        }
    }
}

/// Rays from both sides of points that are spread over the surfaces by area.
fn rays(scene: &Scene, start: f32) -> Vec<TraceRay> {
    let mut area_before = Vec::with_capacity(scene.triangles.len());
    let mut area = 0.0_f64;
    for triangle in &scene.triangles {
        area_before.push(area);
        let [a, b, c] = scene.corners(triangle).map(Vec3::as_dvec3);
        area += (b - a).cross(c - a).length();
    }
    if area <= 0.0 {
        return Vec::new();
    }
    (0..POINTS)
        .flat_map(|k| {
            let place = (f64::from(k) + 0.5) / f64::from(POINTS) * area;
            let triangle = &scene.triangles[area_before.partition_point(|before| *before <= place).max(1) - 1];
            let [a, b, c] = scene.corners(triangle);
            let r = rand2(0, k, 0);
            let root = r.x.sqrt();
            let point = a * (1.0 - root) + b * (root * (1.0 - r.y)) + c * (root * r.y);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            [normal, -normal].map(|direction| TraceRay {
                origin: point.to_array(),
                t_min: start,
                direction: direction.to_array(),
                t_max: f32::MAX,
            })
        })
        .collect()
}

fn trace(exec: &mut dyn Executor, input: &Input<'_>, rays: &[TraceRay]) -> Result<Vec<TraceHit>, ExecError> {
    let count = CountParams { count: rays.len() as u32, _pad0: 0, _pad1: 0, _pad2: 0 };
    let uniform = exec.upload_one("gap count", &count)?;
    let rays = exec.upload_slice("gap rays", rays)?;
    let hits = exec.zeroed_slice::<TraceHit>("gap widths", count.count as usize)?;
    let [nodes, triangles, attributes, surfaces] = input.buffers.trace_bindings();
    exec.run(&trace_rays::KERNEL, &[uniform, nodes, triangles, attributes, surfaces, rays, hits])?;
    exec.read_slice(hits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exec::CpuExecutor;
    use crate::scene::built_in::two_rooms;
    use crate::scene::device::SceneBuffers;

    fn gaps(scene: &Scene) -> Gaps {
        let mut exec = CpuExecutor::new();
        let buffers = SceneBuffers::upload(&mut exec, scene).unwrap();
        Gaps::measure(&mut exec, &Input { scene, buffers: &buffers, seed: 1, true_mean: None }).unwrap()
    }

    #[test]
    fn a_wall_is_as_narrow_as_it_is_thick_whatever_the_unit() {
        for thickness in [0.05, 0.4] {
            let scene = two_rooms(thickness, 0.0);
            let narrowest = gaps(&scene).narrowest(SHARE, 0.0).unwrap();
            assert!((narrowest / thickness - 1.0).abs() < 1e-3, "{narrowest} of {thickness}");
            let mut larger = scene.clone();
            larger.positions.iter_mut().for_each(|p| *p *= 1024.0);
            assert_eq!(gaps(&larger).narrowest(SHARE, 0.0), Some(narrowest * 1024.0));
        }
    }

    #[test]
    fn small_things_do_not_matter() {
        // A crack of a millimetre between two tiles of a hundredth of the rooms' surface.
        let mut scene = two_rooms(0.4, 0.0);
        let first = scene.positions.len() as u32;
        let (low, high) = scene.bounds();
        let centre = low.lerp(high, 0.25);
        for y in [0.0, 0.001] {
            for (x, z) in [(0.0, 0.0), (0.3, 0.0), (0.3, 0.3), (0.0, 0.3)] {
                scene.positions.push(centre + Vec3::new(x, y, z));
                scene.normals.push(Vec3::Y);
                scene.uvs.push(glam::Vec2::ZERO);
            }
        }
        for vertices in [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]] {
            scene.triangles.push(crate::scene::Triangle { vertices: vertices.map(|v| first + v), material: 0 });
        }
        let gaps = gaps(&scene);
        assert!((gaps.narrowest(SHARE, 0.0).unwrap() / 0.4 - 1.0).abs() < 1e-3);
        assert!((gaps.narrowest(0.0, 0.0).unwrap() / 0.001 - 1.0).abs() < 0.05, "it is seen all the same");
    }

    #[test]
    fn grids_follow_gaps_within_their_limits() {
        let rule = Rule { cells_per_gap: 4.0, resolution: 32..=128 };
        let choice = |gaps: &[f32]| rule.over(10.0, &Gaps { widths: gaps.to_vec() });
        assert_eq!(choice(&[0.5]).resolution, 80);
        assert_eq!(choice(&[0.49]).resolution, 96, "in steps");
        assert_eq!((choice(&[5.0]).resolution, choice(&[]).resolution), (32, 32));
        assert_eq!((choice(&[0.1]).resolution, choice(&[0.1]).wanted), (128, Some(400)));
        // Too fine for 128 cells: half of the surface is passed over, and the rest decides.
        let passed_over = choice(&[0.001, 0.07, 0.5, f32::INFINITY]);
        assert_eq!((passed_over.resolution, passed_over.finer_share, passed_over.wanted), (80, 0.5, None));
        assert_eq!(gaps(&Scene::default()).narrowest(SHARE, 0.0), None);
    }
}
