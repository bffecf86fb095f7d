//! The sum of light's bounces among voxels, found in fewer steps than it has terms.
//!
//! Irradiance x that facets receive over bounces obeys x = K(d + x): d is direct irradiance, K what one pass of cones makes of
//! reflected light. A step computes K(d + x) from what is known of x. What comes out is then scaled until it is in balance: the
//! flux that it reflects is that of the first bounce, and what K keeps, λ, of its own. So one step already holds the whole
//! geometric series where all light spreads alike (two bounces in a plain room), and where it does not (light that turns
//! around corners) every further step mends the distribution, and not the sum. No step may make light: where more flux arrives
//! than was sent out (cones that see the lit backs of walls, small bright things that few cones meet too often), it is scaled to
//! what was. Steps end when they change little, or no less
//! than the one before: what is left then is the noise of few cones.

use glam::{DVec3, Vec3, Vec4};
use std::sync::Arc;

/// Largest share of light that a room keeps per bounce; a larger λ is noise.
const MAX_RATIO: f64 = 0.95;
/// Sides of facets (neighbours in space) whose light is compared from step to step together: cones that point elsewhere in
/// every step make each one's alone uncertain.
const GROUP: usize = 256;
/// Share of the mean light below which a change of darkness counts less.
const DARK: f64 = 0.1;
/// A change of more than this share of the one before is noise.
const FALLING: f64 = 0.7;

/// What a step says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Factor on the step's irradiance that balances flux, and that keeps it from making light.
    pub gain: Vec3,
    /// Mean share of the light on a surface that the step changed; of the first step, λ.
    pub change: f64,
    /// Whether the next steps would change less than the wanted share, or no less than this one.
    pub settled: bool,
}

/// Steps so far.
pub struct Series {
    /// Flux that each facet reflects per irradiance of either side, over the voxel's face.
    reflecting: Arc<[Vec3]>,
    /// Area of each facet, over the voxel's face.
    areas: Arc<[f32]>,
    /// Whether the bounces after the last are wanted too.
    balanced: bool,
    /// Change that a step may leave.
    converged: f64,
    /// Reflected flux that direct light makes.
    direct: DVec3,
    /// That of the first step, and of what the next one goes out from.
    first: Option<DVec3>,
    before: DVec3,
    /// Reflected flux per group of facets after the last step, and what that changed.
    groups: Vec<f64>,
    change: f64,
    /// λ.
    ratio: DVec3,
}

impl Series {
    /// A series that starts from direct irradiance, two sides per facet.
    pub fn new(reflecting: Arc<[Vec3]>, areas: Arc<[f32]>, direct: &[Vec4], balanced: bool, converged: f64) -> Self {
        let direct = fluxes(&reflecting, direct).into_iter().sum();
        let (before, ratio) = (DVec3::ZERO, DVec3::ZERO);
        let (first, groups, change) = (None, Vec::new(), f64::INFINITY);
        Self { reflecting, areas, balanced, converged, direct, first, before, groups, change, ratio }
    }

    /// Takes what cones gathered from direct light and the last step's irradiance times its gain.
    pub fn step(&mut self, irradiance: &[Vec4]) -> Step {
        let sent = self.direct + self.before;
        let conserving = divided(sent, arriving(&self.areas, irradiance), 1.0).min(DVec3::ONE);
        let fluxes: Vec<DVec3> = fluxes(&self.reflecting, irradiance).into_iter().map(|f| f * conserving).collect();
        let flux: DVec3 = fluxes.iter().sum();
        self.ratio = match self.first {
            None => divided(flux, self.direct, 0.0),
            Some(first) => divided(flux - first, self.before, 0.0),
        };
        let first = *self.first.get_or_insert(flux);
        let kept = DVec3::ONE - self.ratio.clamp(DVec3::ZERO, DVec3::splat(MAX_RATIO));
        let gain = if self.balanced { divided(first / kept, flux, 1.0) } else { DVec3::ONE };
        self.before = flux * gain;
        let groups: Vec<f64> = fluxes.iter().map(|flux| (*flux * gain).element_sum()).collect();
        // The first step has nothing to be compared with: its λ may be small because light starts where little leaves.
        let is_first = self.groups.is_empty();
        let change = if is_first { self.ratio.max_element() } else { change(&self.groups, &groups) };
        let falls_no_more = change > FALLING * self.change;
        // Without balance light would be missing: who asks for a number of bounces gets it.
        let may_end = self.balanced && self.converged > 0.0 && !is_first;
        let settled = may_end && (change < self.converged || falls_no_more);
        (self.groups, self.change) = (groups, if is_first { f64::INFINITY } else { change });
        Step { gain: (gain * conserving).as_vec3(), change, settled }
    }

    /// λ, the share of reflected flux that comes back, in the channel that keeps most; `None` where none does.
    pub fn ratio(&self) -> Option<f64> {
        (self.ratio.max_element() > 0.0).then(|| self.ratio.max_element())
    }
}

/// Channel by channel; `none` in a channel without light.
fn divided(a: DVec3, b: DVec3, none: f64) -> DVec3 {
    let divide = |a: f64, b: f64| if b > 0.0 { a / b } else { none };
    DVec3::new(divide(a.x, b.x), divide(a.y, b.y), divide(a.z, b.z))
}

/// Reflected flux of each group, up to a constant factor.
fn fluxes(reflecting: &[Vec3], sides: &[Vec4]) -> Vec<DVec3> {
    let group = |(sides, reflecting): (&[Vec4], &[Vec3])| {
        let pairs = sides.chunks_exact(2).zip(reflecting);
        pairs.map(|(e, weight)| ((e[0] + e[1]).truncate() * *weight).as_dvec3()).sum()
    };
    sides.chunks(GROUP).zip(reflecting.chunks(GROUP / 2)).map(group).collect()
}

/// Flux that arrives at all facets, up to the same factor.
fn arriving(areas: &[f32], sides: &[Vec4]) -> DVec3 {
    sides.chunks_exact(2).zip(areas).map(|(e, area)| ((e[0] + e[1]).truncate() * *area).as_dvec3()).sum()
}

/// Mean over the groups of how much of their light is new: dark walls count as much as bright ones, because somebody may look at
/// either, but for what is all but black.
fn change(before: &[f64], after: &[f64]) -> f64 {
    let dark = DARK * after.iter().sum::<f64>() / after.len().max(1) as f64;
    let share =
        |(before, after): (&f64, &f64)| (after - before).abs() / (before.max(*after) + dark).max(f64::MIN_POSITIVE);
    before.iter().zip(after).map(share).sum::<f64>() / after.len().max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps on facets in groups that hand light on to each other by a matrix (rows: receivers).
    fn steps(matrix: &[&[f32]], direct: &[f32], balanced: bool, count: usize) -> (Vec<f32>, Vec<Step>) {
        let per_group = |values: &[f32]| -> Vec<Vec4> {
            values.iter().flat_map(|v| std::iter::repeat_n(Vec3::splat(*v).extend(0.0), GROUP)).collect()
        };
        let facets = direct.len() * GROUP / 2;
        let (reflecting, areas) = (vec![Vec3::ONE; facets].into(), vec![1.0; facets].into());
        let mut series = Series::new(reflecting, areas, &per_group(direct), balanced, 0.01);
        let (mut x, mut made) = (vec![0.0; direct.len()], Vec::new());
        for _ in 0..count {
            let from: Vec<f32> = direct.iter().zip(&x).map(|(d, x)| d + x).collect();
            x = matrix.iter().map(|row| row.iter().zip(&from).map(|(k, f)| k * f).sum()).collect();
            let step = series.step(&per_group(&x));
            x.iter_mut().for_each(|x| *x *= step.gain.x);
            made.push(step);
        }
        (x, made)
    }

    #[test]
    fn one_step_holds_the_series_where_light_spreads_alike() {
        let (x, made) = steps(&[&[0.25, 0.25], &[0.25, 0.25]], &[8.0, 8.0], true, 2);
        assert!(x.iter().all(|x| (x - 8.0).abs() < 1e-5), "{x:?}");
        assert!((made[0].change - 0.5).abs() < 1e-6 && !made[0].settled, "{made:?}");
        assert!(made[1].change < 1e-6 && made[1].settled, "{made:?}");
        let (x, _) = steps(&[&[0.25, 0.25], &[0.25, 0.25]], &[8.0, 8.0], false, 2);
        assert!(x.iter().all(|x| (x - 6.0).abs() < 1e-5), "two bounces of an endless series: {x:?}");
    }

    #[test]
    fn balanced_steps_come_nearer_than_bounces_alone() {
        // Three rooms in a row, light in the first: x = K(d + x) by elimination is (22.0, 13.6, 9.07) for d = (10, 0, 0).
        let matrix: [&[f32]; 3] = [&[0.5, 0.2, 0.0], &[0.2, 0.4, 0.2], &[0.0, 0.2, 0.7]];
        let exact = {
            let mut x = [0.0f32; 3];
            for _ in 0..2000 {
                let from = [10.0 + x[0], x[1], x[2]];
                x = std::array::from_fn(|r| matrix[r].iter().zip(&from).map(|(k, f)| k * f).sum());
            }
            x
        };
        let error = |x: &[f32]| x.iter().zip(&exact).map(|(x, e)| (x / e - 1.0).abs()).sum::<f32>();
        let mut last = f32::MAX;
        for count in [2, 4, 8, 16] {
            let (balanced, made) = steps(&matrix, &[10.0, 0.0, 0.0], true, count);
            let (plain, _) = steps(&matrix, &[10.0, 0.0, 0.0], false, count);
            assert!(error(&balanced) < 0.7 * error(&plain), "{count}: {balanced:?} {plain:?} {exact:?}");
            assert!(error(&balanced) < last);
            // It ends neither before it is near nor long after.
            let settled = made.iter().position(|step| step.settled);
            assert!(settled.is_none_or(|k| k >= 4) && (count < 16 || settled.is_some()), "{made:?}");
            last = error(&balanced);
        }
    }

    #[test]
    fn a_step_that_makes_light_is_held_back() {
        let grey = |value: f32| vec![Vec4::new(value, value, value, 0.0); 2];
        for balanced in [false, true] {
            let mut series = Series::new([Vec3::splat(0.5)].into(), [1.0].into(), &grey(8.0), balanced, 0.01);
            // 8 is reflected of 16, and 40 arrive: a fifth of it is what can be there, and half of that is reflected again.
            let step = series.step(&grey(20.0));
            assert!((step.gain.x - if balanced { 0.4 } else { 0.2 }).abs() < 1e-6, "{step:?}");
            assert!((series.ratio().unwrap() - 0.5).abs() < 1e-9);
        }
    }

    #[test]
    fn darkness_stays_dark() {
        let (x, made) = steps(&[&[0.5]], &[0.0], true, 3);
        assert_eq!(x, [0.0]);
        assert!(made[1].change == 0.0 && made[1].settled, "{made:?}");
        let mut series = Series::new([].into(), [].into(), &[], true, 0.0);
        assert_eq!(series.step(&[]).gain, Vec3::ONE);
        assert_eq!(series.ratio(), None);
    }

    #[test]
    fn a_red_lamp_says_nothing_of_green() {
        let red = |value: f32| vec![Vec4::new(value, 0.0, 0.0, 0.0); 2];
        let mut series = Series::new([Vec3::splat(0.5)].into(), [1.0].into(), &red(8.0), true, 0.01);
        assert_eq!(series.step(&red(4.0)).gain, Vec3::new(2.0, 1.0, 1.0));
        assert_eq!(series.ratio(), Some(0.5));
    }
}
