//! Where probes stand and how far they reach (SL17 §4.1).

use super::model::{FREE, Receiver};
use super::reach::Space;
use super::world::{World, frame};
use glam::{DVec3, Vec3};
use interreflect_kernels::math::rng::hash;
use interreflect_kernels::math::sampling::{cosine_hemisphere, hammersley};
use rayon::prelude::*;
use rstar::RTree;
use rstar::primitives::GeomWithData;

/// Candidates at most; more would make the removal quadratic in earnest.
const MAX_CANDIDATES: usize = 6144;
/// The same where nothing is removed.
const MAX_MEMBERS: usize = 1 << 15;
/// Steps by which probes come to stand in the middle of what is nearest to them. Many carry what rounding changes far.
const RELAXATIONS: usize = 16;
/// Receivers at most by which the radius is judged.
const MAX_JUDGES: usize = 4096;
/// Receivers at most by which visibility is judged.
const MAX_WITNESSES: usize = 1 << 14;
/// Receivers at a time before which probes may be added.
const CANDIDATES: usize = 128;
/// Rays of a receiver by which places that see it, and gaps, are found.
const LOOKS: u32 = 32;
/// Of these the longest, along which candidates lie, at these parts of the way.
const LONGEST: usize = 3;
const ALONG: [f32; 3] = [0.25, 0.5, 0.9];
/// How often probes are added and the radius fitted again.
const ROUNDS: usize = 4;
/// Part of the bound down to which probes are added: receivers that none was added for are covered less well.
const AIM: f32 = 0.5;
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

/// Positions of about `count` probes; fewer where there are not as many candidates.
///
/// [`Placement::Surface`]: of an overcomplete set of candidates those in the densest places are removed one after the other
/// (SL17 §4.1). [`Placement::Volume`]: each in the middle of what is nearest to it (Lloyd 1982). One candidate more or less, as
/// rounding makes them, changes all that removal does afterwards; a middle it hardly moves.
pub fn place(space: &Space, placement: Placement, count: u32) -> Vec<Vec3> {
    let candidate = |i: &usize| {
        let beside_surface = || space.beside(*i).any(|n| space.solid[n]);
        space.open[*i] && (placement == Placement::Volume || beside_surface())
    };
    let count = count.max(1) as usize;
    let most = if placement == Placement::Volume { MAX_MEMBERS } else { MAX_CANDIDATES };
    let mut candidates: Vec<usize> = (0..space.open.len()).filter(candidate).collect();
    // An even choice among too many, the same on every run.
    candidates.sort_by_key(|i| hash(*i as u32));
    candidates.truncate(most.max(count));
    candidates.sort_unstable();
    // In voxels, which are the same numbers whatever the scene's unit and place.
    let points: Vec<Vec3> = candidates.iter().map(|i| space.voxel(*i).as_vec3() + 0.5).collect();
    let chosen = match placement {
        Placement::Surface => thin(points, count),
        Placement::Volume => relax(points, count, &|p| space.at_voxel(p).is_some_and(|v| space.open[v])),
    };
    chosen.into_iter().map(|p| space.grid.origin + p * space.grid.voxel_size).collect()
}

/// `count` points of which each lies in the middle of those of `points` that are nearest to it, or at the nearest of them where
/// the middle is not `free`: halves of halves, then [`RELAXATIONS`] steps of Lloyd's.
fn relax(points: Vec<Vec3>, count: usize, free: &dyn Fn(Vec3) -> bool) -> Vec<Vec3> {
    if points.len() <= count {
        return points;
    }
    let mut chosen = Vec::with_capacity(count);
    portions(points.clone(), count, &mut chosen);
    let mut owner = nearest_of(&points, &chosen);
    for _ in 0..RELAXATIONS {
        chosen = middles(&points, &owner, chosen);
        owner = nearest_of(&points, &chosen);
    }
    // A middle may lie inside a solid.
    let mut nearest: Vec<(f32, Vec3)> = chosen.iter().map(|p| (f32::MAX, *p)).collect();
    for (p, o) in points.iter().zip(&owner) {
        let distance = (*p - chosen[*o as usize]).length_squared();
        if distance < nearest[*o as usize].0 {
            nearest[*o as usize] = (distance, *p);
        }
    }
    chosen.iter().zip(nearest).map(|(p, n)| if free(*p) { *p } else { n.1 }).collect()
}

/// The middles of as many portions, of as many points each as can be, cut across the longest side.
fn portions(mut points: Vec<Vec3>, count: usize, middles: &mut Vec<Vec3>) {
    if count <= 1 || points.len() <= 1 {
        middles.push(points.iter().sum::<Vec3>() / points.len().max(1) as f32);
        return;
    }
    let (low, high) = points.iter().fold((Vec3::MAX, Vec3::MIN), |(l, h), p| (l.min(*p), h.max(*p)));
    let extent = high - low;
    // Of nearly equal sides the first: a voxel more or less does not turn the cut.
    let axis = (0..3).find(|a| extent[*a] >= 0.8 * extent.max_element()).unwrap_or(0);
    let order = |p: &Vec3| [axis, (axis + 1) % 3, (axis + 2) % 3].map(|a| p[a] as u32);
    points.sort_by_key(order);
    let first = count / 2;
    let rest = points.split_off((points.len() * first / count).max(1));
    portions(points, first, middles);
    portions(rest, count - first, middles);
}

/// The nearest of `chosen` to each point.
fn nearest_of(points: &[Vec3], chosen: &[Vec3]) -> Vec<u32> {
    let places = chosen.iter().zip(0..).map(|(p, i)| GeomWithData::new(p.to_array(), i)).collect();
    let tree: RTree<GeomWithData<[f32; 3], u32>> = RTree::bulk_load(places);
    points.par_iter().map(|p| tree.nearest_neighbor(p.to_array()).map_or(0, |n| n.data)).collect()
}

/// The middles of the points of each owner; who owns nothing stays.
fn middles(points: &[Vec3], owner: &[u32], chosen: Vec<Vec3>) -> Vec<Vec3> {
    let mut sums = vec![(DVec3::ZERO, 0.0); chosen.len()];
    for (p, o) in points.iter().zip(owner) {
        let sum = &mut sums[*o as usize];
        *sum = (sum.0 + p.as_dvec3(), sum.1 + 1.0);
    }
    let middle = |(stays, (sum, n)): (Vec3, (DVec3, f64))| if n > 0.0 { (sum / n).as_vec3() } else { stays };
    chosen.into_iter().zip(sums).map(middle).collect()
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

/// Evenly chosen receivers to judge by, at most about so many; others for every `turn` of all, where there are enough.
fn judges(receivers: &[Receiver], most: usize, turn: usize) -> impl Iterator<Item = &Receiver> {
    let step = receivers.len().div_ceil(most).max(1);
    receivers.iter().skip(turn * step / (ROUNDS + 1)).step_by(step)
}

/// Radius at which a receiver lies within `overlap` probes' supports on average, and every one in one at least.
pub fn radius(probes: &[Vec3], receivers: &[Receiver], overlap: f32) -> f32 {
    let farthest = receivers.par_iter().map(|r| nearest(probes, r)).reduce(|| 0.0, f32::max);
    if probes.is_empty() || receivers.is_empty() {
        return 1.0;
    }
    overlapping(probes, receivers, overlap).max(farthest / RIM)
}

/// Distance of a receiver's nearest probe.
fn nearest(probes: &[Vec3], r: &Receiver) -> f32 {
    probes.iter().map(|p| (r.position - *p).length()).fold(f32::MAX, f32::min)
}

/// Radius at which a receiver lies within `overlap` probes' supports on average.
fn overlapping(probes: &[Vec3], receivers: &[Receiver], overlap: f32) -> f32 {
    let mut distances: Vec<f32> =
        judges(receivers, MAX_JUDGES, 0).flat_map(|r| probes.iter().map(|p| (r.position - *p).length())).collect();
    let wanted = (overlap / probes.len() as f32 * distances.len() as f32) as usize;
    if wanted >= distances.len() {
        // All probes everywhere; the farthest still counts.
        return distances.iter().copied().fold(0.0, f32::max) / RIM;
    }
    *distances.select_nth_unstable_by(wanted, f32::total_cmp).1
}

/// What probes leave unseen.
#[derive(Clone, Copy, PartialEq, Debug, Default, serde::Serialize)]
pub struct Coverage {
    /// Probes that were added.
    pub added: u32,
    /// Probes that could have been: where as many were, it is their number that leaves receivers unseen.
    pub limit: u32,
    /// Share of receivers that no probe in support sees, those in gaps left out.
    pub unseen: f32,
    /// Share of receivers that saw none before probes were added, those in gaps left out.
    pub unseen_before: f32,
    /// Share of receivers that no probe in support sees and that lie in gaps narrower than a texel: between the leaves of a
    /// plant, behind a banner on a wall. The lightmap does not resolve what light does there; no probes are added for them.
    pub unseen_in_gaps: f32,
}

/// What probes are to be added for.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Wish {
    /// Probes in whose support a receiver lies on average.
    pub overlap: f32,
    /// Share of receivers that may see no probe.
    pub bound: f32,
    /// Probes that may be added.
    pub limit: u32,
    /// Width of a texel (m).
    pub texel_size: f32,
}

/// Adds probes, at most `limit`, until at most the share `bound` of the receivers sees no probe in support, and fits the
/// radius to each `overlap`; gives it. Probes are added first where receivers would lie in no support of that radius: [`radius`]
/// would else widen all for the sake of one remote corner. What is left unseen is judged by the radius that is given.
pub fn cover(
    world: &World<'_>,
    space: &Space,
    receivers: &[Receiver],
    probes: &mut Vec<Vec3>,
    wish: &Wish,
) -> (f32, Coverage) {
    let first = radius(probes, receivers, wish.overlap);
    let before = Unseen::new(world, receivers, probes, first, ROUNDS, wish.texel_size);
    let placed = probes.len();
    // More probes shrink the radius, and with it what each of them lights.
    for round in 0..ROUNDS {
        let left = placed + wish.limit as usize - probes.len();
        if left == 0 || probes.is_empty() {
            break;
        }
        let mut tight = overlapping(probes, receivers, wish.overlap);
        let mut outlying: Vec<&Receiver> = receivers.par_iter().filter(|r| nearest(probes, r) > RIM * tight).collect();
        // So many are no remote corners: the overlap is too small for so few probes.
        if outlying.len() as f32 > wish.bound * receivers.len() as f32 {
            outlying.clear();
            tight = radius(probes, receivers, wish.overlap);
        }
        let near = |r: &Receiver, p: Vec3| (r.position - p).length() < RIM * tight;
        probes.extend(covering(world, space, outlying, &near, tight, (0, left)));
        let dark = Unseen::new(world, receivers, probes, tight, round, wish.texel_size);
        let allowed = (AIM * wish.bound * dark.judges as f32) as usize;
        let left = placed + wish.limit as usize - probes.len();
        let sees = |r: &Receiver, p: Vec3| sees(world, r, p, tight);
        probes.extend(covering(world, space, dark.elsewhere, &sees, tight, (allowed, left)));
    }
    let radius = radius(probes, receivers, wish.overlap);
    // By receivers that no probe was added for.
    let after = Unseen::new(world, receivers, probes, radius, ROUNDS, wish.texel_size);
    let coverage = Coverage {
        added: (probes.len() - placed) as u32,
        limit: wish.limit,
        unseen: after.share(after.elsewhere.len()),
        unseen_before: before.share(before.elsewhere.len()),
        unseen_in_gaps: after.share(after.in_gaps),
    };
    (radius, coverage)
}

/// Receivers that see no probe in support.
struct Unseen<'a> {
    /// Number of those that were asked.
    judges: usize,
    /// Number of those in gaps.
    in_gaps: usize,
    /// The others.
    elsewhere: Vec<&'a Receiver>,
}

impl<'a> Unseen<'a> {
    fn new(
        world: &World<'_>,
        receivers: &'a [Receiver],
        probes: &[Vec3],
        radius: f32,
        turn: usize,
        texel_size: f32,
    ) -> Self {
        let judges: Vec<&Receiver> = judges(receivers, MAX_WITNESSES, turn).collect();
        let dark = |r: &&Receiver| !probes.iter().any(|p| sees(world, r, *p, radius));
        let dark: Vec<&Receiver> = judges.par_iter().copied().filter(dark).collect();
        let (in_gaps, elsewhere): (Vec<&Receiver>, Vec<&Receiver>) =
            dark.into_par_iter().partition(|r| is_in_gap(world, r, texel_size));
        Self { judges: judges.len(), in_gaps: in_gaps.len(), elsewhere }
    }

    fn share(&self, count: usize) -> f32 {
        count as f32 / self.judges.max(1) as f32
    }
}

/// Whether most of what a receiver sees is nearer than a texel is wide.
fn is_in_gap(world: &World<'_>, r: &Receiver, texel_size: f32) -> bool {
    r.triangle != FREE && 2 * looks(world, r).filter(|(_, open)| *open < texel_size).count() > LOOKS as usize
}

/// Directions about a receiver by the cosine law, and how far it sees there (m), [`f32::MAX`] out of the scene.
fn looks<'a>(world: &'a World<'_>, r: &'a Receiver) -> impl Iterator<Item = (Vec3, f32)> + 'a {
    let about = frame(r.geometric_normal);
    (0..LOOKS).map(move |i| {
        let direction = about.world_from_local(cosine_hemisphere(hammersley(i, LOOKS)));
        (direction, world.closest_from(r, direction).map_or(f32::MAX, |s| (s.position - r.position).length()))
    })
}

/// Whether a receiver sees a point in support.
fn sees(world: &World<'_>, r: &Receiver, p: Vec3, radius: f32) -> bool {
    let towards = p - r.position;
    towards.length() < radius && towards.dot(r.geometric_normal) > 0.0 && world.sees(&r.into(), p)
}

/// Few places that cover all but `allowed` of some receivers, at most `most`: always the one next that covers most of the
/// remaining (Johnson 1974).
fn covering(
    world: &World<'_>,
    space: &Space,
    mut receivers: Vec<&Receiver>,
    covers: &(dyn Fn(&Receiver, Vec3) -> bool + Sync),
    radius: f32,
    (allowed, most): (usize, usize),
) -> Vec<Vec3> {
    let mut chosen = Vec::new();
    while receivers.len() > allowed && chosen.len() < most {
        let step = receivers.len().div_ceil(CANDIDATES).max(1);
        let some: Vec<&Receiver> = receivers.iter().step_by(step).copied().collect();
        let places = |r: &Receiver| {
            let mut places: Vec<Vec3> = before(world, r, space.grid.voxel_size).collect();
            places.extend(along(world, r, radius));
            places
        };
        let candidates: Vec<Vec3> = some.par_iter().flat_map_iter(|r| places(r)).collect();
        let covered = |p: &Vec3| receivers.iter().map(|r| covers(r, *p)).collect::<Vec<bool>>();
        let covered: Vec<Vec<bool>> = candidates.par_iter().map(covered).collect();
        let mut left = vec![true; receivers.len()];
        let before = chosen.len();
        while chosen.len() < most && left.iter().filter(|l| **l).count() > allowed {
            let count = |c: &usize| covered[*c].iter().zip(&left).filter(|(s, l)| **s && **l).count();
            let counts: Vec<usize> = (0..candidates.len()).map(|c| count(&c)).collect();
            let Some(best) = (0..counts.len()).max_by_key(|c| (counts[*c], usize::MAX - c)) else { break };
            // A candidate whose receivers have been found others is no longer the best of all places.
            if counts[best] == 0
                || (chosen.len() > before && counts[best] * 2 < covered[best].iter().filter(|s| **s).count())
            {
                break;
            }
            chosen.push(candidates[best]);
            left.iter_mut().zip(&covered[best]).for_each(|(l, s)| *l &= !s);
        }
        if chosen.len() == before {
            break;
        }
        let mut left = left.into_iter();
        receivers.retain(|_| left.next() == Some(true));
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

/// Places along the ways that lead farthest out of where a receiver lies: what else lies there is seen from them too.
fn along(world: &World<'_>, r: &Receiver, radius: f32) -> Vec<Vec3> {
    let mut ways: Vec<(Vec3, f32)> = looks(world, r).collect();
    ways.sort_by(|a, b| b.1.total_cmp(&a.1));
    let place = |(direction, open): (Vec3, f32)| ALONG.map(|t| r.position + direction * open.min(radius) * t);
    ways.into_iter().take(LONGEST).flat_map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_and_relaxing_leave_points_evenly_apart() {
        let points: Vec<Vec3> =
            (0..1000).map(|i| Vec3::new((i % 10) as f32, (i / 10 % 10) as f32, (i / 100) as f32)).collect();
        for left in [thin(points.clone(), 27), relax(points, 27, &|_| true)] {
            assert_eq!(left.len(), 27);
            let nearest =
                |p: &Vec3| left.iter().filter(|q| *q != p).map(|q| (*q - *p).length()).fold(f32::MAX, f32::min);
            let closest = left.iter().map(nearest).fold(f32::MAX, f32::min);
            // A grid of 3 × 3 × 3 would stand 3 to 4.5 apart.
            assert!(closest >= 2.0, "{closest}");
        }
    }

    #[test]
    fn a_candidate_more_or_less_hardly_moves_what_is_relaxed() {
        // A room with a block in it, and the same without one in a hundred of the points beside the block.
        let all = (0..8000).map(|i| Vec3::new((i % 20) as f32, (i / 20 % 20) as f32, (i / 400) as f32) + 0.5);
        let block = |p: Vec3, side: f32| {
            p.y < side && (p - Vec3::new(8.0, 0.0, 12.0)).with_y(0.0).abs().max_element() < 0.4 * side
        };
        let points: Vec<Vec3> = all.filter(|p| !block(*p, 10.0)).collect();
        let fewer: Vec<Vec3> = points
            .iter()
            .copied()
            .filter(|p| !block(*p, 12.0) || !hash(p.dot(Vec3::new(1.0, 20.0, 400.0)) as u32).is_multiple_of(100))
            .collect();
        let gone = points.len() - fewer.len();
        assert!((3..20).contains(&gone), "{gone}");
        let free = |p: Vec3| !block(p, 10.0);
        let (a, b) = (relax(points, 27, &free), relax(fewer, 27, &free));
        let moved = a.iter().zip(&b).map(|(p, q)| (*p - *q).length()).fold(0.0, f32::max);
        // A quarter of the spacing; each step of relaxation lets differences grow.
        assert!(moved < 0.25 * 6.6, "{moved}");
        assert!(a.iter().chain(&b).all(|p| free(*p)));
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
    fn gaps_are_what_is_narrower_than_a_texel() {
        // Two plates of a metre, 3 cm apart.
        let mut b = crate::scene::built_in::SceneBuilder::new("plates");
        let m = b.diffuse("grey", [0.5; 3]);
        for y in [0.0, 0.03] {
            let corner = |x: f32, z: f32| Vec3::new(x, y, z);
            b.quad([corner(0.0, 0.0), corner(0.0, 1.0), corner(1.0, 1.0), corner(1.0, 0.0)], m);
        }
        let scene = b.finish();
        let world = World::new(&scene).unwrap();
        let at = |triangle, normal: Vec3| Receiver {
            triangle,
            error: 1e-6,
            ..super::super::atlas::free_receiver(world.seen(triangle, [0.3, 0.3, 0.4], true).position, normal)
        };
        assert!(is_in_gap(&world, &at(0, Vec3::Y), 0.1) && !is_in_gap(&world, &at(0, Vec3::Y), 0.02));
        // What sees nothing at all is in the open, and so is what lies on no surface.
        assert!(!is_in_gap(&world, &at(0, Vec3::NEG_Y), 0.1));
        assert!(!is_in_gap(&world, &super::super::atlas::free_receiver(Vec3::new(0.5, 0.01, 0.5), Vec3::Y), 0.1));
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
            let wish = Wish { overlap: 1.0, bound: 0.0, limit, texel_size: 0.05 };
            let (_, coverage) = cover(&world, &reach.space, &receivers, &mut probes, &wish);
            (coverage, probes.len())
        };
        let (none, _) = covered(0);
        assert!(none.unseen > 0.3 && none.unseen < 0.7 && none.unseen == none.unseen_before, "{none:?}");
        let (some, count) = covered(8);
        assert_eq!((some.unseen, some.unseen_before), (0.0, none.unseen));
        assert!(some.added >= 1 && some.added <= 3 && count == 1 + some.added as usize, "{some:?}");
    }
}
