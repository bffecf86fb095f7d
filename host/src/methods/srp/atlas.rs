//! Lightmap texels as receivers, and the way from any surface point to the receivers around it.
//!
//! The lightmap has two layers of the same charts: fronts on top, and below them backs, where any can be reached. Coverage is
//! conservative: a texel that a chart touches at all is a receiver, at its centre where that lies on the chart, otherwise
//! at the middle of the largest piece inside it. Charts of less than `SMALLEST_CHART` texels have no receivers: points
//! on them take the nearest ones of similar orientation.

use super::charts::{Charts, Patches, barycentric, doubled_area};
use super::model::{Blend, FREE, NO_RECEIVER, Receiver};
use super::visibility::NO_TEXEL;
use super::world::{Seen, World};
use glam::{IVec2, Vec2, Vec3};
use rayon::prelude::*;
use rstar::RTree;
use rstar::primitives::GeomWithData;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Charts smaller than this (texels) have no receivers of their own.
pub(super) const SMALLEST_CHART: f32 = 0.25;
/// Texels of which less than this share is covered are left out where their chart has others.
const SMALLEST_SHARE: f32 = 0.02;
/// Points per side of a texel at which its reflectance is sampled.
const ALBEDO_SAMPLES: u32 = 4;
/// Receivers that a nearest-point search looks at for one of the right orientation.
const NEAREST: usize = 24;

/// A lightmap with its texels.
pub struct Atlas {
    /// Charts in texels.
    pub charts: Charts,
    /// Columns and rows, both layers.
    pub size: [u32; 2],
    /// Width of a texel (m).
    pub texel_size: f32,
    /// Texels with a receiver.
    pub texels: Vec<Texel>,
    /// Exposed sides of each chart that has texels.
    sides: Vec<[bool; 2]>,
    /// Per texel the outermost of the points that cover it. Not in files: only precomputation asks.
    spread: Vec<[Spot; 4]>,
    /// Index into `texels` per place in the lightmap, [`NO_TEXEL`] without, and its chart. Not in files either.
    index: Vec<(u32, u32)>,
}

/// A point of a triangle.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
struct Spot {
    triangle: u32,
    weights: [f32; 3],
}

/// A texel with a receiver.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Texel {
    /// Column and row.
    pub at: [u32; 2],
    /// Chart.
    pub chart: u32,
    /// The receiver.
    pub receiver: Receiver,
}

/// What lies in a texel while triangles are laid over it.
#[derive(Default)]
struct Cover {
    chart: u32,
    /// Covered part of the texel.
    area: f32,
    /// Surface on it (m²).
    surface: f32,
    centre: Option<(u32, [f32; 3])>,
    largest: (f32, u32, [f32; 3]),
    /// Triangle, weights and area of points for the reflectance.
    samples: Vec<(u32, [f32; 3], f32)>,
}

impl Atlas {
    /// Texels of all exposed sides, about `count` of them.
    pub fn new(world: &World<'_>, patches: &Patches, exposed: &[[bool; 2]], count: u32) -> Self {
        let area = chart_areas(world, patches);
        let total: f32 = area.iter().zip(exposed).map(|(a, e)| a * (u32::from(e[0]) + u32::from(e[1])) as f32).sum();
        let texel_size = (total / count.max(1) as f32).sqrt().max(f32::MIN_POSITIVE);
        let seen: Vec<bool> = exposed.iter().map(|e| e[0] || e[1]).collect();
        let large = |c: u32| area[c as usize] >= SMALLEST_CHART * texel_size * texel_size;
        // Where everything is small, small charts must do.
        let any_large = (0..patches.count).any(|c| seen[c as usize] && large(c));
        let used = |c: u32| seen[c as usize] && (large(c) || !any_large);
        let seen_area: f32 = area.iter().zip(&seen).filter(|(_, s)| **s).map(|(a, _)| a).sum();
        let charts = patches.pack(&used, texel_size, seen_area);
        let sides: Vec<[bool; 2]> =
            (0..patches.count).map(|c| if used(c) { exposed[c as usize] } else { [false; 2] }).collect();
        let covers = cover(world, &charts, &sides);
        let layers = if sides.iter().any(|s| s[1]) { 2 } else { 1 };
        let size = [charts.size[0], charts.size[1] * layers];
        let mut largest = vec![0.0f32; patches.count as usize];
        covers.iter().for_each(|(_, c)| largest[c.chart as usize] = largest[c.chart as usize].max(c.area));
        let found: Vec<(Texel, [Spot; 4])> = covers
            .par_iter()
            .filter(|(_, c)| c.area >= SMALLEST_SHARE.min(largest[c.chart as usize]))
            .flat_map_iter(|(at, c)| {
                let both = [true, false].into_iter().filter(|front| sides[c.chart as usize][usize::from(!front)]);
                let (rows, corners) = (charts.size[1], &charts.corners);
                both.map(move |front| {
                    let texel = Texel {
                        at: [at.x as u32, at.y as u32 + if front { 0 } else { rows }],
                        chart: c.chart,
                        receiver: receiver(world, c, front),
                    };
                    (texel, c.outermost(corners))
                })
            })
            .collect();
        let (texels, spread): (Vec<Texel>, Vec<[Spot; 4]>) = found.into_iter().unzip();
        let index = index(size, &texels);
        Self { charts, size, texel_size, texels, sides, spread, index }
    }

    /// From its parts, as a file keeps them.
    pub(super) fn from_parts(
        charts: Charts,
        size: [u32; 2],
        texel_size: f32,
        texels: Vec<Texel>,
        sides: Vec<[bool; 2]>,
    ) -> Self {
        Self { charts, size, texel_size, texels, sides, spread: Vec::new(), index: Vec::new() }
    }

    /// The texel that holds a point of a triangle, if it is of the triangle's chart: an index into `texels`. For
    /// precomputation: a lightmap from a file does not know.
    #[inline(always)]
    pub fn texel_of(&self, triangle: u32, weights: [f32; 3], front: bool) -> u32 {
        let at = self.place(triangle, weights, true).floor().as_ivec2();
        let [columns, rows] = self.charts.size.map(|s| s as i32);
        let row = if front { at.y } else { at.y + rows };
        if at.x < 0 || at.y < 0 || at.x >= columns || at.y >= rows || row >= self.size[1] as i32 {
            return NO_TEXEL;
        }
        match self.index.get((row * columns + at.x) as usize) {
            Some((texel, chart)) if *chart == self.charts.chart[triangle as usize] => *texel,
            _ => NO_TEXEL,
        }
    }

    /// Points of a texel's surface: its receiver and, while precomputing, the outermost four.
    pub fn points<'a>(&'a self, world: &'a World<'_>, texel: u32) -> impl Iterator<Item = Seen> + 'a {
        let r = &self.texels[texel as usize].receiver;
        let outer = self.spread.get(texel as usize).into_iter().flatten();
        std::iter::once(Seen::from(r)).chain(outer.map(|s| world.seen(s.triangle, s.weights, r.front)))
    }

    /// Per chart: whether front and back have receivers.
    pub fn sides(&self) -> &[[bool; 2]] {
        &self.sides
    }

    /// Whether a side of a triangle belongs to the world and has receivers.
    pub fn has(&self, triangle: u32, front: bool) -> bool {
        self.sides[self.charts.chart[triangle as usize] as usize][usize::from(!front)]
    }

    /// Place of a surface point in the lightmap, in texels.
    #[inline(always)]
    fn place(&self, triangle: u32, weights: [f32; 3], front: bool) -> Vec2 {
        let [a, b, c] = self.charts.corners[triangle as usize];
        let p = a * weights[0] + b * weights[1] + c * weights[2];
        if front { p } else { p + Vec2::new(0.0, self.charts.size[1] as f32) }
    }
}

/// From surface points to receivers, after those that count have been chosen and ordered.
pub struct Lookup {
    atlas: Arc<Atlas>,
    /// Per texel: receiver and chart.
    texel: Vec<(u32, u32)>,
    tree: RTree<GeomWithData<[f32; 3], u32>>,
    normals: Vec<Vec3>,
}

impl Lookup {
    /// `order[i]` is the texel of receiver `i`, [`NO_RECEIVER`] for one without.
    pub fn new(atlas: Arc<Atlas>, order: &[u32]) -> Self {
        let mut texel = vec![(NO_RECEIVER, 0); atlas.size[0] as usize * atlas.size[1] as usize];
        let mut points = Vec::with_capacity(order.len());
        let mut normals = Vec::with_capacity(order.len());
        for (i, t) in order.iter().enumerate() {
            let Some(t) = atlas.texels.get(*t as usize) else {
                normals.push(Vec3::ZERO);
                continue;
            };
            texel[(t.at[1] * atlas.size[0] + t.at[0]) as usize] = (i as u32, t.chart);
            points.push(GeomWithData::new(t.receiver.position.to_array(), i as u32));
            normals.push(t.receiver.geometric_normal);
        }
        Self { atlas, texel, tree: RTree::bulk_load(points), normals }
    }

    /// The lightmap.
    pub fn atlas(&self) -> &Atlas {
        &self.atlas
    }

    /// The receivers around a point of a triangle (weights of its corners, side), bilinearly within its chart, the nearest
    /// one where the chart has none there. `position` and `normal` of the point are for that case.
    pub fn blend(&self, triangle: u32, weights: [f32; 3], front: bool, position: Vec3, normal: Vec3) -> Blend {
        if self.atlas.has(triangle, front) {
            let p = self.atlas.place(triangle, weights, front) - 0.5;
            let chart = self.atlas.charts.chart[triangle as usize];
            let blend = self.bilinear(p, chart, front);
            if let Some(blend) = blend {
                return blend;
            }
        }
        self.nearest(position, normal).map_or(Blend::NONE, |i| Blend {
            receivers: [i, NO_RECEIVER, NO_RECEIVER, NO_RECEIVER],
            weights: [1.0, 0.0, 0.0, 0.0],
        })
    }

    /// The receiver that stands for a point of a triangle.
    pub fn one(&self, triangle: u32, weights: [f32; 3], front: bool, position: Vec3, normal: Vec3) -> Option<u32> {
        let blend = self.blend(triangle, weights, front, position, normal);
        let best = (0..4).max_by(|a, b| blend.weights[*a].total_cmp(&blend.weights[*b]))?;
        (blend.weights[best] > 0.0).then_some(blend.receivers[best])
    }

    /// Mean of the four texels around a point, those of other charts and without a receiver left out.
    fn bilinear(&self, p: Vec2, chart: u32, front: bool) -> Option<Blend> {
        let base = p.floor();
        let f = p - base;
        let mut blend = Blend::NONE;
        let weights = [(1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y];
        for k in 0..4 {
            let at = base.as_ivec2() + IVec2::new(k & 1, k >> 1);
            if let Some(i) = self.of_texel(at, chart, front) {
                (blend.receivers[k as usize], blend.weights[k as usize]) = (i, weights[k as usize]);
            }
        }
        let sum: f32 = blend.weights.iter().sum();
        // Next to nothing of a mean is noise: rather the nearest receiver.
        (sum > 1e-3).then(|| Blend { weights: blend.weights.map(|w| w / sum), ..blend })
    }

    fn of_texel(&self, at: IVec2, chart: u32, front: bool) -> Option<u32> {
        let rows = self.atlas.charts.size[1] as i32;
        let layer = if front { 0..rows } else { rows..2 * rows };
        let inside = at.x >= 0 && at.x < self.atlas.size[0] as i32 && layer.contains(&at.y);
        let (receiver, owner) =
            if inside { self.texel[(at.y * self.atlas.size[0] as i32 + at.x) as usize] } else { (NO_RECEIVER, 0) };
        (receiver != NO_RECEIVER && owner == chart).then_some(receiver)
    }

    /// The nearest receiver, preferably one that faces the same way.
    pub fn nearest(&self, position: Vec3, normal: Vec3) -> Option<u32> {
        let around: Vec<u32> =
            self.tree.nearest_neighbor_iter(position.to_array()).take(NEAREST).map(|p| p.data).collect();
        let facing = around.iter().find(|i| self.normals[**i as usize].dot(normal) > 0.5);
        facing.or(around.first()).copied()
    }

    /// Texels without a receiver beside one with: what fills them, so that bilinear lookups across a chart's border see
    /// the chart's own light.
    pub fn dilation(&self) -> Vec<([u32; 2], Blend)> {
        let [width, height] = self.atlas.size.map(|s| s as i32);
        let at = |x: i32, y: i32| {
            let inside = x >= 0 && x < width && y >= 0 && y < height;
            if inside { self.texel[(y * width + x) as usize].0 } else { NO_RECEIVER }
        };
        let fill = |i: i32| {
            let (x, y) = (i % width, i / width);
            if at(x, y) != NO_RECEIVER {
                return None;
            }
            // The four sides first; corners count only where no side has a receiver.
            for ring in [[(-1, 0), (1, 0), (0, -1), (0, 1)], [(-1, -1), (1, -1), (-1, 1), (1, 1)]] {
                let receivers = ring.map(|(dx, dy)| at(x + dx, y + dy));
                let count = receivers.iter().filter(|r| **r != NO_RECEIVER).count();
                if count > 0 {
                    let weights = receivers.map(|r| if r == NO_RECEIVER { 0.0 } else { 1.0 / count as f32 });
                    return Some(([x as u32, y as u32], Blend { receivers, weights }));
                }
            }
            None
        };
        (0..width * height).filter_map(fill).collect()
    }
}

/// Surface of each chart (m²).
fn chart_areas(world: &World<'_>, patches: &Patches) -> Vec<f32> {
    let mut area = vec![0.0; patches.count as usize];
    for (t, triangle) in world.scene.triangles.iter().enumerate() {
        let [a, b, c] = world.scene.corners(triangle);
        area[patches.chart[t] as usize] += 0.5 * (b - a).cross(c - a).length();
    }
    area
}

/// Lays all triangles of charts with an exposed side over the texels.
fn cover(world: &World<'_>, charts: &Charts, sides: &[[bool; 2]]) -> Vec<(IVec2, Cover)> {
    let mut covers: BTreeMap<(i32, i32), Cover> = BTreeMap::new();
    for (t, corners) in charts.corners.iter().enumerate() {
        let chart = charts.chart[t];
        if sides[chart as usize] == [false; 2] {
            continue;
        }
        let [a, b, c] = world.scene.corners(&world.scene.triangles[t]);
        let stretch = (b - a).cross(c - a).length() / doubled_area(*corners).abs().max(1e-12);
        let low = corners[0].min(corners[1]).min(corners[2]).floor().as_ivec2().max(IVec2::ZERO);
        let last = IVec2::new(charts.size[0] as i32 - 1, charts.size[1] as i32 - 1);
        let high = corners[0].max(corners[1]).max(corners[2]).floor().as_ivec2().min(last);
        for y in low.y..=high.y {
            for x in low.x..=high.x {
                let Some((area, middle)) = piece(*corners, Vec2::new(x as f32, y as f32)) else { continue };
                let cover = covers.entry((y, x)).or_insert_with(|| Cover { chart, ..Cover::default() });
                if cover.chart != chart {
                    continue;
                }
                cover.add(t as u32, *corners, Vec2::new(x as f32, y as f32), area, middle, stretch);
            }
        }
    }
    covers.into_iter().map(|((y, x), c)| (IVec2::new(x, y), c)).collect()
}

impl Cover {
    /// Of the sampled points those that lie farthest along the diagonals of the texel.
    fn outermost(&self, corners: &[[Vec2; 3]]) -> [Spot; 4] {
        [Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0), Vec2::new(-1.0, 1.0), Vec2::new(-1.0, -1.0)].map(|diagonal| {
            let along = |&(t, w, _): &(u32, [f32; 3], f32)| {
                let [a, b, c] = corners[t as usize];
                (a * w[0] + b * w[1] + c * w[2]).dot(diagonal)
            };
            let most = self.samples.iter().max_by(|a, b| along(a).total_cmp(&along(b)));
            most.map_or(Spot::default(), |&(triangle, weights, _)| Spot { triangle, weights })
        })
    }

    fn add(&mut self, t: u32, corners: [Vec2; 3], texel: Vec2, area: f32, middle: Vec2, stretch: f32) {
        let at_middle = inside(barycentric(corners, middle));
        self.area += area;
        self.surface += area * stretch;
        if area > self.largest.0 {
            self.largest = (area, t, at_middle);
        }
        let centre = barycentric(corners, texel + 0.5);
        if self.centre.is_none() && centre.iter().all(|w| *w >= 0.0) {
            self.centre = Some((t, centre));
        }
        let step = 1.0 / ALBEDO_SAMPLES as f32;
        let mut found = 0;
        let before = self.samples.len();
        for k in 0..ALBEDO_SAMPLES * ALBEDO_SAMPLES {
            let offset = Vec2::new((k % ALBEDO_SAMPLES) as f32 + 0.5, (k / ALBEDO_SAMPLES) as f32 + 0.5) * step;
            let weights = barycentric(corners, texel + offset);
            if weights.iter().all(|w| *w >= 0.0) {
                self.samples.push((t, weights, 0.0));
                found += 1;
            }
        }
        if found == 0 {
            self.samples.push((t, at_middle, 0.0));
            found = 1;
        }
        self.samples[before..].iter_mut().for_each(|s| s.2 = area / found as f32);
    }
}

/// Where in the lightmap which texel lies.
fn index(size: [u32; 2], texels: &[Texel]) -> Vec<(u32, u32)> {
    let mut index = vec![(NO_TEXEL, NO_TEXEL); size[0] as usize * size[1] as usize];
    for (i, t) in texels.iter().enumerate() {
        if let Some(place) = index.get_mut((t.at[1] * size[0] + t.at[0]) as usize) {
            *place = (i as u32, t.chart);
        }
    }
    index
}

/// Weights without what rounding put outside.
fn inside(weights: [f32; 3]) -> [f32; 3] {
    let positive = weights.map(|w| w.max(0.0));
    let sum: f32 = positive.iter().sum();
    if sum > 0.0 { positive.map(|w| w / sum) } else { [1.0, 0.0, 0.0] }
}

/// Area and centroid of the part of a triangle inside the unit square at `corner` (Sutherland & Hodgman 1974).
fn piece(corners: [Vec2; 3], corner: Vec2) -> Option<(f32, Vec2)> {
    let mut polygon: Vec<Vec2> = corners.iter().map(|p| *p - corner).collect();
    for (axis, keep_below) in [(0, false), (0, true), (1, false), (1, true)] {
        let distance = |p: Vec2| if keep_below { 1.0 - p[axis] } else { p[axis] };
        let mut cut = Vec::with_capacity(polygon.len() + 1);
        for (i, p) in polygon.iter().enumerate() {
            let q = polygon[(i + 1) % polygon.len()];
            let (dp, dq) = (distance(*p), distance(q));
            if dp >= 0.0 {
                cut.push(*p);
            }
            if (dp > 0.0 && dq < 0.0) || (dp < 0.0 && dq > 0.0) {
                cut.push(*p + (q - *p) * (dp / (dp - dq)));
            }
        }
        polygon = cut;
        if polygon.is_empty() {
            return None;
        }
    }
    let origin = polygon[0];
    let (mut area, mut moment) = (0.0, Vec2::ZERO);
    for pair in polygon[1..].windows(2) {
        let doubled = (pair[0] - origin).perp_dot(pair[1] - origin);
        area += doubled;
        moment += (pair[0] + pair[1] + origin) / 3.0 * doubled;
    }
    if area.abs() < 1e-9 {
        // A sliver, but it is there.
        let mean = polygon.iter().sum::<Vec2>() / polygon.len() as f32;
        return Some((0.0, corner + mean));
    }
    Some((0.5 * area.abs(), corner + moment / area))
}

fn receiver(world: &World<'_>, cover: &Cover, front: bool) -> Receiver {
    let (triangle, weights) = cover.centre.unwrap_or((cover.largest.1, cover.largest.2));
    let s = world.surface(triangle, weights, front);
    let (mut albedo, mut emission, mut total) = (Vec3::ZERO, Vec3::ZERO, 0.0);
    for (t, weights, area) in &cover.samples {
        let s = world.surface(*t, *weights, front);
        albedo += Vec3::from(s.albedo) * *area;
        emission += Vec3::from(s.emission) * *area;
        total += area;
    }
    let scale = if total > 0.0 { 1.0 / total } else { 0.0 };
    Receiver {
        position: s.position.into(),
        normal: s.normal.into(),
        geometric_normal: s.geometric_normal.into(),
        error: s.error,
        triangle,
        front,
        area: cover.surface,
        albedo: if total > 0.0 { albedo * scale } else { s.albedo.into() },
        emission: if total > 0.0 { emission * scale } else { s.emission.into() },
    }
}

/// A receiver in free space, such as a point of a grid for moving objects.
pub fn free_receiver(position: Vec3, normal: Vec3) -> Receiver {
    Receiver {
        position,
        normal,
        geometric_normal: normal,
        error: 0.0,
        triangle: FREE,
        front: true,
        area: 0.0,
        albedo: Vec3::ZERO,
        emission: Vec3::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::super::reach::Reach;
    use super::*;
    use crate::scene::{Scene, built_in};

    fn atlas(scene: &Scene, count: u32) -> (Atlas, Vec<[bool; 2]>) {
        let world = World::new(scene).unwrap();
        let patches = Patches::new(scene, 0.02);
        let reach = Reach::new(&world, &patches, 1).unwrap();
        (Atlas::new(&world, &patches, &reach.exposed, count), reach.exposed)
    }

    #[test]
    fn texels_cover_all_surface_once() {
        for (scene, count) in [(built_in::cornell_box(), 4000), (built_in::sphere_furnace(3, 0.5, 1.0), 3000)] {
            let (atlas, exposed) = atlas(&scene, count);
            let mut area = 0.0;
            for (t, triangle) in scene.triangles.iter().enumerate() {
                let [a, b, c] = scene.corners(triangle);
                let sides = exposed[atlas.charts.chart[t] as usize];
                area += 0.5 * (b - a).cross(c - a).length() * (u32::from(sides[0]) + u32::from(sides[1])) as f32;
            }
            let covered: f32 = atlas.texels.iter().map(|t| t.receiver.area).sum();
            assert!((covered / area - 1.0).abs() < 0.01, "{}: {covered} of {area} m²", scene.name);
            let ratio = atlas.texels.len() as f32 / count as f32;
            assert!(ratio > 0.9 && ratio < 1.6, "{}: {} texels for {count}", scene.name, atlas.texels.len());
        }
    }

    #[test]
    fn lookups_interpolate_positions() {
        let scene = built_in::cornell_box();
        let (atlas, _) = atlas(&scene, 8000);
        let order: Vec<u32> = (0..atlas.texels.len() as u32).rev().collect();
        let atlas = Arc::new(atlas);
        let lookup = Lookup::new(atlas.clone(), &order);
        let positions: Vec<Vec3> = order.iter().map(|t| atlas.texels[*t as usize].receiver.position).collect();
        for (t, triangle) in scene.triangles.iter().enumerate() {
            let corners = scene.corners(triangle);
            for weights in [[0.4, 0.3, 0.3], [0.98, 0.01, 0.01], [0.05, 0.9, 0.05], [1.0, 0.0, 0.0]] {
                let p = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
                let n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
                let blend = lookup.blend(t as u32, weights, true, p, n);
                assert!((blend.weights.iter().sum::<f32>() - 1.0).abs() < 1e-5);
                let off = (blend.of(&positions) - p).length();
                let allowed = if weights[0] == 0.4 { 0.3 } else { 1.0 } * atlas.texel_size;
                assert!(off < allowed, "triangle {t} {weights:?}: {off} m, texel {}", atlas.texel_size);
                let one = lookup.one(t as u32, weights, true, p, n).unwrap();
                assert!((positions[one as usize] - p).length() < atlas.texel_size);
            }
        }
        // Gutters are filled from the chart beside them.
        let dilation = lookup.dilation();
        assert!(!dilation.is_empty());
        for (at, blend) in &dilation {
            assert!((blend.weights.iter().sum::<f32>() - 1.0).abs() < 1e-5, "{at:?}");
        }
    }
}
