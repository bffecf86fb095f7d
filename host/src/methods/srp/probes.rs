//! Where probes stand and how far they reach (SL17 §4.1).

use super::model::Receiver;
use super::reach::Space;
use super::world::World;
use glam::Vec3;
use interreflect_kernels::math::rng::hash;
use rayon::prelude::*;

/// Candidates at most; more would make the removal quadratic in earnest.
const MAX_CANDIDATES: usize = 6144;
/// Receivers at most by which the radius is judged.
const MAX_JUDGES: usize = 4096;
/// Receivers at most by which visibility is judged.
const MAX_WITNESSES: usize = 1 << 14;
/// Receivers at a time before which probes may be added.
const CANDIDATES: usize = 128;
/// How often probes are added and the radius fitted again.
const ROUNDS: u32 = 4;
/// Part of the radius within which the farthest receiver still lies: its weight is then not quite zero.
const RIM: f32 = 0.9;

/// Which open voxels are candidates.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Placement {
    /// Those beside a surface (SL17).
    Surface,
    /// All of them: probes stand farther from surfaces, whose angular detail is then coarser.
    #[default]
    Volume,
}

/// Weight of a probe at a distance, in units of the radius: `2t³ − 3t² + 1` (SL17 eq. 10).
pub fn weight(t: f32) -> f32 {
    if t < 1.0 { (2.0 * t - 3.0) * t * t + 1.0 } else { 0.0 }
}

/// Positions of about `count` probes: an overcomplete set of candidates, of which those in the densest places are removed
/// one after the other. Fewer where there are not as many candidates.
pub fn place(space: &Space, placement: Placement, count: u32) -> Vec<Vec3> {
    let candidate = |i: &usize| {
        let beside_surface = || space.beside(*i).any(|n| space.solid[n]);
        space.open[*i] && (placement == Placement::Volume || beside_surface())
    };
    let mut candidates: Vec<usize> = (0..space.open.len()).filter(candidate).collect();
    // An even choice among too many, the same on every run.
    candidates.sort_by_key(|i| hash(*i as u32));
    candidates.truncate(MAX_CANDIDATES.max(count as usize));
    candidates.sort_unstable();
    let points: Vec<Vec3> = candidates.iter().map(|i| space.centre(*i)).collect();
    thin(points, count.max(1) as usize)
}

/// Removes the point of highest kernel density until `count` are left: weighted sample elimination (Yuksel 2015, §3) with
/// its kernel `(1 − d/2r)⁸`. SL17's own kernel is flat near 0 and finds points at the border sparse, where it then
/// leaves them in heaps.
fn thin(points: Vec<Vec3>, count: usize) -> Vec<Vec3> {
    if points.len() <= count {
        return points;
    }
    let (low, high) = points.iter().fold((Vec3::MAX, Vec3::MIN), |(l, h), p| (l.min(*p), h.max(*p)));
    // Largest radius at which `count` balls fit the volume (Yuksel 2015, eq. 3).
    let volume = (high - low).max(Vec3::splat(1e-6)).element_product();
    let radius = (volume / (4.0 * 2f32.sqrt() * count as f32)).cbrt();
    let near = |p: Vec3, q: Vec3| (1.0 - (p - q).length() / (2.0 * radius)).max(0.0).powi(8);
    let mut density: Vec<f32> = points.par_iter().map(|p| points.iter().map(|q| near(*p, *q)).sum()).collect();
    let mut alive: Vec<usize> = (0..points.len()).collect();
    while alive.len() > count {
        let densest = (0..alive.len()).max_by(|a, b| density[alive[*a]].total_cmp(&density[alive[*b]]).then(b.cmp(a)));
        let gone = alive.remove(densest.unwrap_or(0));
        for i in &alive {
            density[*i] -= near(points[*i], points[gone]);
        }
    }
    alive.into_iter().map(|i| points[i]).collect()
}

/// Evenly chosen receivers to judge by, at most about so many.
fn judges(receivers: &[Receiver], most: usize) -> impl Iterator<Item = &Receiver> {
    receivers.iter().step_by(receivers.len().div_ceil(most).max(1))
}

/// Radius at which a receiver lies within `overlap` probes' supports on average, and every one in one at least.
pub fn radius(probes: &[Vec3], receivers: &[Receiver], overlap: f32) -> f32 {
    let mut distances: Vec<f32> =
        judges(receivers, MAX_JUDGES).flat_map(|r| probes.iter().map(|p| (r.position - *p).length())).collect();
    let nearest = receivers
        .par_iter()
        .map(|r| probes.iter().map(|p| (r.position - *p).length()).fold(f32::MAX, f32::min))
        .reduce(|| 0.0, f32::max);
    if distances.is_empty() || nearest == f32::MAX {
        return 1.0;
    }
    let farthest = distances.iter().copied().fold(0.0, f32::max);
    let wanted = (overlap / probes.len() as f32 * distances.len() as f32) as usize;
    if wanted >= distances.len() {
        // All probes everywhere; the farthest still counts.
        return farthest / RIM;
    }
    let (_, at, _) = distances.select_nth_unstable_by(wanted, f32::total_cmp);
    at.max(nearest / RIM)
}

/// What probes leave unseen.
#[derive(Clone, Copy, PartialEq, Debug, Default, serde::Serialize)]
pub struct Coverage {
    /// Probes that were added.
    pub added: u32,
    /// Share of receivers that no probe in support sees.
    pub unseen: f32,
    /// Share of receivers that saw none before probes were added.
    pub unseen_before: f32,
}

/// Adds probes, at most `limit`, until at most the share `bound` of the receivers sees no probe in support, and fits the
/// radius to each `overlap` (see [`radius`]); gives it. What is left unseen is judged by the radius that is given.
pub fn cover(
    world: &World<'_>,
    space: &Space,
    receivers: &[Receiver],
    probes: &mut Vec<Vec3>,
    (overlap, bound, limit): (f32, f32, u32),
) -> (f32, Coverage) {
    let judges: Vec<&Receiver> = judges(receivers, MAX_WITNESSES).collect();
    let mut coverage = Coverage::default();
    // More probes shrink the radius, and with it what each of them lights.
    for round in 0.. {
        let radius = radius(probes, receivers, overlap);
        let dark = |r: &Receiver| !probes.iter().any(|p| sees(world, r, *p, radius));
        let unseen: Vec<&Receiver> = judges.par_iter().filter(|r| dark(r)).copied().collect();
        coverage.unseen = unseen.len() as f32 / judges.len().max(1) as f32;
        if round == 0 {
            coverage.unseen_before = coverage.unseen;
        }
        let allowed = (bound * judges.len() as f32) as usize;
        let left = limit - coverage.added;
        let more =
            if round < ROUNDS { covering(world, space, unseen, radius, allowed, left as usize) } else { Vec::new() };
        if more.is_empty() {
            return (radius, coverage);
        }
        coverage.added += more.len() as u32;
        probes.extend(more);
    }
    unreachable!("a round without probes ends it")
}

/// Whether a receiver sees a point in support.
fn sees(world: &World<'_>, r: &Receiver, p: Vec3, radius: f32) -> bool {
    let towards = p - r.position;
    towards.length() < radius && towards.dot(r.geometric_normal) > 0.0 && world.sees(&r.into(), p)
}

/// Few places from which all but `allowed` of some receivers are seen, at most `most`: always the one next that most of
/// the remaining see (Johnson 1974).
fn covering(
    world: &World<'_>,
    space: &Space,
    mut unseen: Vec<&Receiver>,
    radius: f32,
    allowed: usize,
    most: usize,
) -> Vec<Vec3> {
    let mut chosen = Vec::new();
    while unseen.len() > allowed && chosen.len() < most {
        let step = unseen.len().div_ceil(CANDIDATES).max(1);
        let candidates: Vec<Vec3> =
            unseen.iter().step_by(step).flat_map(|r| before(world, r, space.grid.voxel_size)).collect();
        let seen_from = |p: &Vec3| unseen.iter().map(|r| sees(world, r, *p, radius)).collect::<Vec<bool>>();
        let seen_from: Vec<Vec<bool>> = candidates.par_iter().map(seen_from).collect();
        let mut left = vec![true; unseen.len()];
        let before = chosen.len();
        while chosen.len() < most && left.iter().filter(|l| **l).count() > allowed {
            let count = |c: &usize| seen_from[*c].iter().zip(&left).filter(|(s, l)| **s && **l).count();
            let counts: Vec<usize> = (0..candidates.len()).map(|c| count(&c)).collect();
            let Some(best) = (0..counts.len()).max_by_key(|c| (counts[*c], usize::MAX - c)) else { break };
            // A candidate whose receivers have been found others is no longer the best of all places.
            if counts[best] == 0
                || (chosen.len() > before && counts[best] * 2 < seen_from[best].iter().filter(|s| **s).count())
            {
                break;
            }
            chosen.push(candidates[best]);
            left.iter_mut().zip(&seen_from[best]).for_each(|(l, s)| *l &= !s);
        }
        if chosen.len() == before {
            break;
        }
        let mut left = left.into_iter();
        unseen.retain(|_| left.next() == Some(true));
    }
    chosen
}

/// Places in open air in front of a receiver: at a few distances, no farther than the middle of what is open there.
fn before<'a>(world: &'a World<'_>, r: &'a Receiver, voxel_size: f32) -> impl Iterator<Item = Vec3> + 'a {
    let open = world.closest_from(r, r.geometric_normal).map_or(f32::MAX, |s| (s.position - r.position).length());
    let distances = [0.5, 1.0, 2.0, 4.0].map(|d| (d * voxel_size).min(0.5 * open));
    let apart = (0..4).filter(move |k| *k == 0 || distances[*k] > 1.1 * distances[k - 1]);
    apart.map(move |k| r.position + r.geometric_normal * distances[k])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_leaves_points_evenly_apart() {
        let points: Vec<Vec3> =
            (0..1000).map(|i| Vec3::new((i % 10) as f32, (i / 10 % 10) as f32, (i / 100) as f32) * 0.1).collect();
        let left = thin(points, 27);
        assert_eq!(left.len(), 27);
        let nearest = |p: &Vec3| left.iter().filter(|q| *q != p).map(|q| (*q - *p).length()).fold(f32::MAX, f32::min);
        let closest = left.iter().map(nearest).fold(f32::MAX, f32::min);
        // A 3 × 3 × 3 grid in the unit cube would stand 0.3 to 0.45 apart.
        assert!(closest >= 0.2, "{closest}");
    }

    #[test]
    fn the_radius_gives_the_overlap_and_leaves_no_receiver_out() {
        let probes: Vec<Vec3> =
            (0..64).map(|i| Vec3::new((i % 4) as f32, (i / 4 % 4) as f32, (i / 16) as f32)).collect();
        let at = |p: Vec3| super::super::atlas::free_receiver(p, Vec3::Y);
        let receivers: Vec<Receiver> =
            (0..512).map(|i| at(Vec3::new((i % 8) as f32, (i / 8 % 8) as f32, (i / 64) as f32) * 0.42)).collect();
        let r = radius(&probes, &receivers, 10.0);
        let within = |x: &Receiver| probes.iter().filter(|p| (x.position - **p).length() < r).count();
        let mean = receivers.iter().map(within).sum::<usize>() as f32 / 512.0;
        assert!((mean - 10.0).abs() < 0.5, "{mean}");
        let far = [at(Vec3::splat(9.0)), at(Vec3::ZERO)];
        let r = radius(&probes, &far, 1.0);
        assert!(weight((Vec3::splat(9.0) - Vec3::splat(3.0)).length() / r) > 0.0);
        assert!(weight(0.0) == 1.0 && weight(1.0) == 0.0 && (weight(0.5) - 0.5).abs() < 1e-6);
    }

    #[test]
    fn probes_come_to_where_nobody_sees_one() {
        // Two sealed rooms and a probe in one of them.
        let scene = crate::scene::built_in::two_rooms(0.05, 0.0);
        let world = World::new(&scene).unwrap();
        let reach =
            super::super::reach::Reach::new(&world, &super::super::charts::Patches::new(&scene, 0.05), 1).unwrap();
        let (low, high) = scene.bounds();
        let inside = |t: Vec3| low + (high - low) * t;
        let receivers: Vec<Receiver> = (0..200)
            .map(|i| inside(Vec3::new(0.15 + 0.7 * (i % 20) as f32 / 19.0, 0.3, 0.2 + 0.06 * (i / 20) as f32)))
            .filter(|p| reach.space.at(*p).is_some_and(|v| reach.space.open[v]))
            .map(|p| super::super::atlas::free_receiver(p, Vec3::Y))
            .collect();
        let covered = |limit: u32| {
            let mut probes = vec![inside(Vec3::new(0.25, 0.6, 0.5))];
            let (_, coverage) = cover(&world, &reach.space, &receivers, &mut probes, (1.0, 0.0, limit));
            (coverage, probes.len())
        };
        let (none, _) = covered(0);
        assert!(none.unseen > 0.3 && none.unseen < 0.7 && none.unseen == none.unseen_before, "{none:?}");
        let (some, count) = covered(8);
        assert_eq!((some.unseen, some.unseen_before), (0.0, none.unseen));
        assert!(some.added >= 1 && some.added <= 3 && count == 1 + some.added as usize, "{some:?}");
    }
}
