//! The second UV set: every triangle's place in a lightmap, in texels.
//!
//! The file's own set (TEXCOORD_1) where it has one without overlaps; otherwise charts made here. A chart is a connected
//! set of triangles whose normals lie within [`CHART_COSINE`] of the first one's, seen along that normal: lengths shrink
//! by at most that factor. A triangle that would cover a texel of its own chart at another depth starts a chart of its
//! own. `uvgen`, the crate that makes such charts, compares all pairs of triangles, which a scene of 10⁵ does not allow;
//! rectangles are packed by `etagere`.

use crate::scene::Scene;
use etagere::{AtlasAllocator, size2};
use glam::{IVec2, Vec2, Vec3};
use std::collections::{HashMap, HashSet, VecDeque};

/// Smallest cosine between a triangle's normal and its chart's direction.
pub const CHART_COSINE: f32 = 0.75;
/// Empty texels between charts.
const GUTTER: i32 = 1;
/// Sizes of triangles that are told apart when the largest is looked for, per doubling: rounding does not choose between the
/// halves of a rectangle.
const SIZES_PER_OCTAVE: f32 = 2.0;
/// Edges this much shorter than the longest are as long.
const NEARLY: f32 = 0.99;
/// Largest side of the lightmap in texels.
const MAX_SIDE: i32 = 16_384;
/// Most texels of a file's own UV set that two triangles at different places may claim.
const OVERLAP_ALLOWED: f32 = 0.01;

/// Where each triangle lies in the lightmap.
#[derive(Clone, PartialEq, Debug)]
pub struct Charts {
    /// Columns and rows of one layer.
    pub size: [u32; 2],
    /// Corners of each triangle of the scene, in texels.
    pub corners: Vec<[Vec2; 3]>,
    /// Chart of each triangle.
    pub chart: Vec<u32>,
    /// Number of charts.
    pub count: u32,
    /// Whether the file's own UV set is used.
    pub from_file: bool,
}

/// Connected triangles of similar orientation, before they have a place.
#[derive(Clone, PartialEq, Debug)]
pub struct Patches {
    /// Chart of each triangle.
    pub chart: Vec<u32>,
    /// Number of charts.
    pub count: u32,
    /// Corners of each triangle in its chart's plane (m); of the file's own set in 0..1.
    plane: Vec<[Vec2; 3]>,
    from_file: bool,
}

impl Patches {
    /// Groups the scene's triangles; `texel_size` (m) is the grain at which overlaps are found.
    pub fn new(scene: &Scene, texel_size: f32) -> Self {
        Self::of_file(scene).unwrap_or_else(|| Self::made(scene, texel_size))
    }

    /// The file's own set, if it has one that can serve.
    fn of_file(scene: &Scene) -> Option<Self> {
        if scene.lightmap_uvs.len() != scene.positions.len() || scene.triangles.is_empty() {
            return None;
        }
        let plane: Vec<[Vec2; 3]> =
            scene.triangles.iter().map(|t| t.vertices.map(|v| scene.lightmap_uvs[v as usize])).collect();
        let inside = |p: &Vec2| p.min_element() >= -1e-4 && p.max_element() <= 1.0001;
        if !plane.iter().flatten().all(inside) || overlap(&plane) > OVERLAP_ALLOWED {
            return None;
        }
        // Charts: triangles joined by corners that agree in place and in the set.
        let key = |v: u32| {
            let (p, uv) = (scene.positions[v as usize], scene.lightmap_uvs[v as usize]);
            [p.x.to_bits(), p.y.to_bits(), p.z.to_bits(), uv.x.to_bits(), uv.y.to_bits()]
        };
        let neighbours = Neighbours::new(scene, key);
        let (chart, count) = flood(scene.triangles.len(), |t| neighbours.of(t));
        Some(Self { chart, count, plane, from_file: true })
    }

    fn made(scene: &Scene, texel_size: f32) -> Self {
        let key = |v: u32| scene.positions[v as usize].to_array().map(f32::to_bits);
        let neighbours = Neighbours::new(scene, key);
        let normals: Vec<Vec3> = scene.triangles.iter().map(|t| scaled_normal(scene.corners(t))).collect();
        let largest = normals.iter().map(|n| n.length()).fold(f32::MIN_POSITIVE, f32::max);
        let size = |t: usize| ((normals[t].length() / largest).log2() * SIZES_PER_OCTAVE + 0.4).floor();
        let mut largest_first: Vec<usize> = (0..scene.triangles.len()).collect();
        largest_first.sort_by(|a, b| size(*b).total_cmp(&size(*a)).then(a.cmp(b)));
        let mut chart = vec![u32::MAX; scene.triangles.len()];
        let mut plane = vec![[Vec2::ZERO; 3]; scene.triangles.len()];
        let mut count = 0;
        for seed in largest_first {
            if chart[seed] != u32::MAX {
                continue;
            }
            let mut sheet = Sheet::new(scene.corners(&scene.triangles[seed]), texel_size);
            let mut queue = VecDeque::from([seed]);
            while let Some(t) = queue.pop_front() {
                let normal = normals[t].normalize_or_zero();
                if chart[t] != u32::MAX || (t != seed && normal.dot(sheet.normal) < CHART_COSINE) {
                    continue;
                }
                let Some(corners) = sheet.place(scene.corners(&scene.triangles[t]), t == seed) else { continue };
                (chart[t], plane[t]) = (count, corners);
                queue.extend(neighbours.of(t).filter(|n| chart[*n] == u32::MAX));
            }
            count += 1;
        }
        Self { chart, count, plane, from_file: false }
    }

    /// About how many texels of a side they touch that let `count` of them cover their area: a chart touches some beyond its
    /// border, half as many as its box has along its sides. Charts of less than `smallest` texels are left out.
    pub fn texels(&self, count: u32, smallest: f32) -> f32 {
        let mut charts = vec![(0.0f32, Vec2::MAX, Vec2::MIN); self.count as usize];
        for (corners, chart) in self.plane.iter().zip(&self.chart) {
            let (area, low, high) = &mut charts[*chart as usize];
            *area += 0.5 * doubled_area(*corners).abs();
            (*low, *high) = corners.iter().fold((*low, *high), |(low, high), p| (low.min(*p), high.max(*p)));
        }
        let texel_area = charts.iter().map(|c| c.0).sum::<f32>() / count.max(1) as f32;
        let touched = |(area, low, high): &(f32, Vec2, Vec2)| {
            area / texel_area + 0.5 * (*high - *low).element_sum() / texel_area.sqrt()
        };
        charts.iter().filter(|c| c.0 >= smallest * texel_area).map(touched).sum()
    }

    /// Gives every chart that `used` names a place in a lightmap whose texels are `texel_size` (m) wide.
    /// `area`: surface of all used charts (m²), which sets the resolution of a file's own set.
    pub fn pack(&self, used: &dyn Fn(u32) -> bool, texel_size: f32, area: f32) -> Charts {
        if self.from_file {
            return self.scale_file(texel_size, area);
        }
        let mut low = vec![Vec2::MAX; self.count as usize];
        let mut high = vec![Vec2::MIN; self.count as usize];
        for (t, c) in self.chart.iter().enumerate() {
            for p in self.plane[t] {
                low[*c as usize] = low[*c as usize].min(p / texel_size);
                high[*c as usize] = high[*c as usize].max(p / texel_size);
            }
        }
        // Whole texels, the chart in their middle.
        let extent: Vec<IVec2> =
            low.iter().zip(&high).map(|(l, h)| (*h - *l - 1e-3).ceil().as_ivec2().max(IVec2::ONE)).collect();
        let (size, origin) = allocate(&extent, used);
        let place = |t: usize| {
            let c = self.chart[t] as usize;
            let slack = 0.5 * (extent[c].as_vec2() - (high[c] - low[c]));
            self.plane[t].map(|p| p / texel_size - low[c] + slack + origin[c])
        };
        let corners = (0..self.plane.len()).map(place).collect();
        Charts { size, corners, chart: self.chart.clone(), count: self.count, from_file: false }
    }

    fn scale_file(&self, texel_size: f32, area: f32) -> Charts {
        let uv_area: f32 = self.plane.iter().map(|c| doubled_area(*c).abs() * 0.5).sum();
        let side = (area / (texel_size * texel_size) / uv_area.max(1e-6)).sqrt().ceil().clamp(1.0, MAX_SIDE as f32);
        let corners = self.plane.iter().map(|c| c.map(|p| p.clamp(Vec2::ZERO, Vec2::ONE) * side)).collect();
        Charts { size: [side as u32; 2], corners, chart: self.chart.clone(), count: self.count, from_file: true }
    }
}

/// A chart while it grows.
struct Sheet {
    axes: [Vec3; 2],
    normal: Vec3,
    origin: Vec3,
    texel_size: f32,
    depths: HashMap<IVec2, f32>,
}

impl Sheet {
    /// In the plane of its first triangle, along its longest edge: rectangles stay upright.
    fn new(corners: [Vec3; 3], texel_size: f32) -> Self {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or(Vec3::Y);
        let edges = [b - a, c - b, a - c];
        // A right angle's legs rather than the diagonal between two triangles of a rectangle.
        let square =
            (0..3).find(|&i| edges[i].normalize_or_zero().dot(edges[(i + 1) % 3].normalize_or_zero()).abs() < 1e-2);
        let most = edges.iter().map(|e| e.length()).fold(0.0, f32::max);
        let longest = edges.into_iter().find(|e| e.length() >= NEARLY * most).unwrap_or(Vec3::X);
        let along = square.map_or(longest, |i| edges[i]);
        let x = (along - normal * normal.dot(along)).normalize_or(normal.any_orthonormal_vector());
        Self { axes: [x, normal.cross(x)], normal, origin: a, texel_size, depths: HashMap::new() }
    }

    /// Corners in the plane, unless the triangle lies above or below what is there.
    fn place(&mut self, corners: [Vec3; 3], always: bool) -> Option<[Vec2; 3]> {
        let flat = corners.map(|p| Vec2::new((p - self.origin).dot(self.axes[0]), (p - self.origin).dot(self.axes[1])));
        let height = corners.map(|p| (p - self.origin).dot(self.normal));
        let mut claims = Vec::new();
        centres(flat.map(|p| p / self.texel_size), |at, [u, v, w]| {
            claims.push((at, u * height[0] + v * height[1] + w * height[2]));
        });
        let collides =
            |(at, h): &(IVec2, f32)| self.depths.get(at).is_some_and(|other| (other - h).abs() > self.texel_size);
        if !always && claims.iter().any(collides) {
            return None;
        }
        self.depths.extend(claims);
        Some(flat)
    }
}

/// Triangles across each edge.
struct Neighbours {
    edges: Vec<[u32; 3]>,
    by_edge: Vec<Vec<u32>>,
}

impl Neighbours {
    /// Corners with equal keys are one.
    fn new<K: std::hash::Hash + Eq>(scene: &Scene, key: impl Fn(u32) -> K) -> Self {
        let mut corners: HashMap<K, u32> = HashMap::new();
        let mut ids: HashMap<(u32, u32), u32> = HashMap::new();
        let mut by_edge: Vec<Vec<u32>> = Vec::new();
        let mut edges = Vec::with_capacity(scene.triangles.len());
        for (t, triangle) in scene.triangles.iter().enumerate() {
            let corner = triangle.vertices.map(|v| {
                let next = corners.len() as u32;
                *corners.entry(key(v)).or_insert(next)
            });
            edges.push([0, 1, 2].map(|i| {
                let (a, b) = (corner[i], corner[(i + 1) % 3]);
                let id = *ids.entry((a.min(b), a.max(b))).or_insert(by_edge.len() as u32);
                if id as usize == by_edge.len() {
                    by_edge.push(Vec::new());
                }
                by_edge[id as usize].push(t as u32);
                id
            }));
        }
        Self { edges, by_edge }
    }

    fn of(&self, triangle: usize) -> impl Iterator<Item = usize> + '_ {
        let edges = self.edges[triangle].iter();
        edges.flat_map(|e| &self.by_edge[*e as usize]).map(|t| *t as usize).filter(move |t| *t != triangle)
    }
}

/// Connected components.
fn flood<I: Iterator<Item = usize>>(count: usize, neighbours: impl Fn(usize) -> I) -> (Vec<u32>, u32) {
    let mut part = vec![u32::MAX; count];
    let mut parts = 0;
    for seed in 0..count {
        if part[seed] != u32::MAX {
            continue;
        }
        part[seed] = parts;
        let mut queue = vec![seed];
        while let Some(t) = queue.pop() {
            for n in neighbours(t) {
                if part[n] == u32::MAX {
                    part[n] = parts;
                    queue.push(n);
                }
            }
        }
        parts += 1;
    }
    (part, parts)
}

/// Places rectangles in the smallest lightmap found, as near a square as they allow.
fn allocate(extent: &[IVec2], used: &dyn Fn(u32) -> bool) -> ([u32; 2], Vec<Vec2>) {
    let mut order: Vec<usize> = (0..extent.len()).filter(|c| used(*c as u32)).collect();
    order.sort_by_key(|c| (-extent[*c].y, -extent[*c].x, *c));
    let area: i64 = order.iter().map(|c| i64::from(extent[*c].x + GUTTER) * i64::from(extent[*c].y + GUTTER)).sum();
    let widest = order.iter().map(|c| extent[*c].max_element() + GUTTER).max().unwrap_or(1);
    let mut side = ((area as f64 * 1.05).sqrt().ceil() as i32).max(widest);
    loop {
        let mut allocator = AtlasAllocator::new(size2(side, side));
        let mut origin = vec![Vec2::ZERO; extent.len()];
        let fits = order.iter().all(|c| {
            let wanted = size2(extent[*c].x + GUTTER, extent[*c].y + GUTTER);
            let place = allocator.allocate(wanted);
            place.is_some_and(|p| {
                origin[*c] = Vec2::new(p.rectangle.min.x as f32, p.rectangle.min.y as f32);
                true
            })
        });
        if fits || side >= MAX_SIDE {
            return ([side as u32; 2], origin);
        }
        side = (side + side / 16 + 1).min(MAX_SIDE);
    }
}

/// Texels whose centres lie in a triangle, with the weights of its corners there.
pub fn centres(corners: [Vec2; 3], mut found: impl FnMut(IVec2, [f32; 3])) {
    let [a, b, c] = corners;
    let area = doubled_area(corners);
    if area == 0.0 || !area.is_finite() {
        return;
    }
    let low = (a.min(b).min(c) - 0.5).ceil().as_ivec2();
    let high = (a.max(b).max(c) - 0.5).floor().as_ivec2();
    for y in low.y..=high.y {
        for x in low.x..=high.x {
            let weights = barycentric(corners, Vec2::new(x as f32 + 0.5, y as f32 + 0.5));
            if weights.iter().all(|w| *w >= 0.0) {
                found(IVec2::new(x, y), weights);
            }
        }
    }
}

/// Weights of a triangle's corners at a point of its plane; of the first corner alone where the triangle has no area.
pub fn barycentric(corners: [Vec2; 3], p: Vec2) -> [f32; 3] {
    let [a, b, c] = corners;
    let area = doubled_area(corners);
    let (v, w) = ((p - a).perp_dot(c - a) / area, (b - a).perp_dot(p - a) / area);
    if v.is_finite() && w.is_finite() { [1.0 - v - w, v, w] } else { [1.0, 0.0, 0.0] }
}

/// Twice the signed area.
pub fn doubled_area([a, b, c]: [Vec2; 3]) -> f32 {
    (b - a).perp_dot(c - a)
}

fn scaled_normal([a, b, c]: [Vec3; 3]) -> Vec3 {
    (b - a).cross(c - a)
}

/// Share of a coarse grid's points that more than one triangle covers.
fn overlap(plane: &[[Vec2; 3]]) -> f32 {
    const SIDE: f32 = 1024.0;
    let mut seen = HashSet::new();
    let mut twice = 0;
    for corners in plane {
        // A hair smaller, so that triangles that share an edge do not share its points.
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let shrunk = corners.map(|p| (middle + (p - middle) * 0.999) * SIDE);
        centres(shrunk, |at, _| {
            if !seen.insert(at) {
                twice += 1;
            }
        });
    }
    twice as f32 / seen.len().max(1) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{BUILT_IN, built_in};

    fn checked(scene: &Scene, texel_size: f32) -> Charts {
        let area: f32 = scene.triangles.iter().map(|t| 0.5 * scaled_normal(scene.corners(t)).length()).sum();
        let charts = Patches::new(scene, texel_size).pack(&|_| true, texel_size, area);
        // No texel belongs to two charts, and lengths are kept within the cosine.
        let mut owner = HashMap::new();
        for (t, corners) in charts.corners.iter().enumerate() {
            assert!(corners.iter().all(|p| p.min_element() > -1e-3 && p.max_element() < charts.size[0] as f32 + 1e-3));
            centres(*corners, |at, _| {
                assert_eq!(*owner.entry(at).or_insert(charts.chart[t]), charts.chart[t], "{} {at}", scene.name);
            });
            let real = scaled_normal(scene.corners(&scene.triangles[t])).length() / (texel_size * texel_size);
            let flat = doubled_area(*corners).abs();
            assert!(flat <= real * 1.01 + 1e-3 && flat >= real * (CHART_COSINE - 0.01) - 1e-3, "{flat} of {real}");
        }
        charts
    }

    #[test]
    fn charts_of_every_built_in_scene_are_apart_and_nearly_true_to_length() {
        for b in BUILT_IN {
            let scene = (b.make)();
            let extent = scene.bounds().1 - scene.bounds().0;
            checked(&scene, extent.max_element() / 100.0);
        }
    }

    #[test]
    fn walls_are_one_chart_and_curved_surfaces_few() {
        // 12 quads of walls, blocks without a bottom (5 faces each) and lamp.
        assert_eq!(checked(&built_in::cornell_box(), 0.01).count, 16);
        let sphere = checked(&built_in::sphere_furnace(4, 0.5, 1.0), 0.05);
        assert!(sphere.count < 60, "{} charts of 5120 triangles", sphere.count);
    }

    #[test]
    fn a_screw_does_not_lie_above_itself() {
        // A flat ramp of two turns: connected, all normals nearly up.
        let mut b = built_in::SceneBuilder::new("ramp");
        let m = b.diffuse("ramp", [0.5; 3]);
        let at = |i: usize, r: f32| {
            let phi = i as f32 * 0.2;
            Vec3::new(r * phi.cos(), 0.02 * i as f32, r * phi.sin())
        };
        for i in 0..63 {
            b.quad([at(i, 1.0), at(i, 2.0), at(i + 1, 2.0), at(i + 1, 1.0)], m);
        }
        assert!(checked(&b.finish(), 0.05).count >= 2);
    }

    #[test]
    fn a_files_own_set_is_used_unless_it_overlaps() {
        let mut scene = built_in::cornell_box();
        let made = checked(&scene, 0.01);
        // Vertices of the built-in scene are not shared between charts: the charts as made are a UV set.
        let mut uvs = vec![Vec2::ZERO; scene.positions.len()];
        for (t, triangle) in scene.triangles.iter().enumerate() {
            for (v, p) in triangle.vertices.iter().zip(made.corners[t]) {
                uvs[*v as usize] = p / made.size[0] as f32;
            }
        }
        scene.lightmap_uvs = uvs;
        let own = Patches::new(&scene, 0.01);
        assert!(own.from_file);
        assert_eq!(own.count, 16);
        scene.lightmap_uvs.fill(Vec2::ZERO);
        for triangle in scene.triangles.clone() {
            for (v, p) in triangle.vertices.iter().zip([Vec2::ZERO, Vec2::X, Vec2::ONE]) {
                scene.lightmap_uvs[*v as usize] = p;
            }
        }
        assert!(!Patches::new(&scene, 0.01).from_file);
    }
}
