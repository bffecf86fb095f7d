//! A courtyard with arcades.

use super::SceneBuilder;
use super::build::hash_unit;
use crate::scene::{Light, Scene};
use glam::Vec3;
use std::f32::consts::PI;

/// Half the distance between the arcades of opposite sides (m).
const ARCADE: f32 = 6.0;
/// Distance of the outer walls' inner faces from the centre.
const WALL: f32 = 9.4;
const WALL_HEIGHT: f32 = 6.0;
/// Bays of each side, and the distance between columns.
const BAYS: usize = 6;
const BAY: f32 = 2.0 * ARCADE / BAYS as f32;
/// Height at which arches spring, their radius, the top of the arcade wall and half its thickness.
const SPRINGING: f32 = 2.55;
const ARCH_RADIUS: f32 = 0.78;
const ARCADE_TOP: f32 = 3.9;
const HALF_THICKNESS: f32 = 0.2;
/// Height of the galleries' ceiling.
const CEILING: f32 = 3.65;
/// The court lies below the galleries.
const COURT_FLOOR: f32 = -0.15;

/// Materials by use.
struct Palette {
    stone: u32,
    pale_stone: u32,
    red_stone: u32,
    plaster: u32,
    dado: u32,
    wood: u32,
    roof: [u32; 3],
    tiles: [u32; 2],
    paving: [u32; 3],
    grass: u32,
    foliage: u32,
    water: u32,
}

impl Palette {
    fn new(b: &mut SceneBuilder) -> Self {
        Palette {
            stone: b.diffuse("stone", [0.62, 0.56, 0.47]),
            pale_stone: b.diffuse("pale stone", [0.74, 0.7, 0.62]),
            red_stone: b.diffuse("red stone", [0.5, 0.2, 0.13]),
            plaster: b.diffuse("plaster", [0.76, 0.68, 0.55]),
            dado: b.diffuse("painted dado", [0.16, 0.28, 0.42]),
            wood: b.diffuse("wood", [0.28, 0.17, 0.1]),
            roof: [
                b.diffuse("roof tile 1", [0.55, 0.22, 0.12]),
                b.diffuse("roof tile 2", [0.47, 0.19, 0.11]),
                b.diffuse("roof tile 3", [0.6, 0.3, 0.18]),
            ],
            tiles: [b.diffuse("light floor tile", [0.66, 0.6, 0.5]), b.diffuse("dark floor tile", [0.36, 0.15, 0.1])],
            paving: [
                b.diffuse("paving 1", [0.5, 0.47, 0.42]),
                b.diffuse("paving 2", [0.56, 0.52, 0.45]),
                b.diffuse("paving 3", [0.45, 0.43, 0.4]),
            ],
            grass: b.diffuse("grass", [0.12, 0.24, 0.06]),
            foliage: b.diffuse("foliage", [0.09, 0.2, 0.05]),
            water: b.diffuse("water", [0.06, 0.14, 0.16]),
        }
    }
}

/// One side of the courtyard: points are given along the side, up, and outwards from the centre.
#[derive(Clone, Copy)]
struct Side {
    along: Vec3,
    out: Vec3,
}

impl Side {
    /// The four sides; `along`, up and `out` are right-handed.
    fn all() -> [Side; 4] {
        [(Vec3::X, Vec3::Z), (Vec3::NEG_Z, Vec3::X), (Vec3::NEG_X, Vec3::NEG_Z), (Vec3::Z, Vec3::NEG_X)]
            .map(|(along, out)| Side { along, out })
    }

    fn point(&self, along: f32, up: f32, out: f32) -> Vec3 {
        self.along * along + Vec3::Y * up + self.out * out
    }

    /// A block between two corners in the side's coordinates.
    fn block(&self, b: &mut SceneBuilder, min: [f32; 3], max: [f32; 3], material: u32) {
        let corner = self.point(min[0], min[1], min[2]);
        let [u, v, w] = [self.along * (max[0] - min[0]), Vec3::Y * (max[1] - min[1]), self.out * (max[2] - min[2])];
        b.cuboid(corner, u, v, w, material);
    }
}

/// A courtyard of 12 × 12 m between arcades on columns, with vaulted openings, tiled galleries, pent roofs, garden beds
/// and a fountain, in the sun under a pale sky: about 98,000 triangles.
///
/// For: a large scene with fine detail and thin shadows. The sun falls on part of the court and of two galleries; what
/// one sees in the others came over two and more bounces, coloured by tiles, roofs and grass. The default camera stands
/// in a gallery; `court` looks across the courtyard.
pub fn colonnade() -> Scene {
    let mut b = SceneBuilder::new("colonnade");
    let palette = Palette::new(&mut b);
    for (i, side) in Side::all().into_iter().enumerate() {
        // Parts that meet at the corners belong to the first and third side whole, and end between them on the others.
        let is_long = i % 2 == 0;
        arcade(&mut b, side, &palette, is_long);
        gallery(&mut b, side, &palette, is_long);
        outer_wall(&mut b, side, &palette, is_long);
        roof(&mut b, side, &palette);
    }
    floors(&mut b, &palette);
    garden(&mut b, &palette);
    fountain(&mut b, &palette);
    let direction = Vec3::new(0.5, -0.78, 0.42).normalize();
    b.light(Light::Directional { direction, irradiance: Vec3::new(30.0, 28.0, 24.5) });
    b.environment(Vec3::new(1.2, 1.5, 2.0));
    b.camera("gallery", [-8.6, 1.65, 8.6], [3.0, 1.75, 5.4], 62.0);
    b.camera("court", [-5.2, 1.7, 0.9], [3.0, 1.9, -1.6], 70.0);
    b.camera("above", [-12.0, 13.0, 15.0], [0.0, 0.0, 0.0], 45.0);
    b.finish()
}

/// Columns, corner pier, arches and the wall above them.
fn arcade(b: &mut SceneBuilder, side: Side, p: &Palette, is_long: bool) {
    for i in 1..BAYS {
        column(b, side.point(-ARCADE + BAY * i as f32, 0.0, ARCADE), side, p);
    }
    let (inner, outer) = (ARCADE - HALF_THICKNESS, ARCADE + HALF_THICKNESS);
    // The pier at the side's far end: slightly thicker than the wall, so that no two faces lie in one plane.
    side.block(b, [inner - 0.06, 0.0, inner - 0.06], [outer + 0.06, ARCADE_TOP, outer + 0.06], p.stone);
    for i in 0..BAYS {
        bay(b, side, -ARCADE + BAY * (i as f32 + 0.5), p);
    }
    let end = if is_long { outer + 0.16 } else { inner - 0.16 };
    side.block(b, [-end, ARCADE_TOP, inner - 0.16], [end, ARCADE_TOP + 0.14, outer + 0.16], p.pale_stone);
    let step = if is_long { outer + 0.12 } else { inner - 0.12 };
    side.block(b, [-step, COURT_FLOOR, inner - 0.12], [step, 0.0, outer + 0.12], p.pale_stone);
}

/// A column with base and capital, 2.55 m high.
fn column(b: &mut SceneBuilder, foot: Vec3, side: Side, p: &Palette) {
    const SEGMENTS: u32 = 32;
    let slab = |b: &mut SceneBuilder, half: f32, low: f32, high: f32| {
        let corner = foot + Vec3::Y * low - (side.along + side.out) * half;
        b.cuboid(corner, side.along * (2.0 * half), Vec3::Y * (high - low), side.out * (2.0 * half), p.pale_stone);
    };
    slab(b, 0.24, 0.0, 0.12);
    slab(b, 0.23, 2.41, SPRINGING);
    let mut profile = Vec::new();
    // The base: a thick and a thin torus with a hollow between them.
    profile.extend(arc(0.185, 0.165, 0.045, -90.0, 90.0));
    profile.extend([(0.185, 0.215), (0.18, 0.235)]);
    profile.extend(arc(0.18, 0.26, 0.025, -90.0, 90.0));
    // The shaft tapers with a slight swelling.
    for i in 0..=8 {
        let t = i as f32 / 8.0;
        profile.push((0.165 - 0.03 * t + 0.012 * (PI * t).sin(), 0.3 + 1.78 * t));
    }
    profile.extend(arc(0.14, 2.12, 0.025, -90.0, 90.0));
    // The bell of the capital.
    for i in 0..=6 {
        let t = i as f32 / 6.0;
        profile.push((0.14 + 0.08 * t * t, 2.16 + 0.25 * t));
    }
    b.lathe(foot, &profile, SEGMENTS, p.stone);
}

/// Points of a circular arc in a profile, from one angle to another (degrees, 0 = outwards, 90 = up).
fn arc(centre_radius: f32, centre_height: f32, radius: f32, from_deg: f32, to_deg: f32) -> Vec<(f32, f32)> {
    const STEPS: usize = 8;
    let angle = |i: usize| (from_deg + (to_deg - from_deg) * i as f32 / STEPS as f32).to_radians();
    (0..=STEPS).map(|i| (centre_radius + radius * angle(i).cos(), centre_height + radius * angle(i).sin())).collect()
}

/// The wall of one bay with its arch and a ring of voussoirs in two colours on either face.
fn bay(b: &mut SceneBuilder, side: Side, middle: f32, p: &Palette) {
    const SEGMENTS: usize = 26;
    let half_bay = 0.5 * BAY;
    let (inner, outer) = (ARCADE - HALF_THICKNESS, ARCADE + HALF_THICKNESS);
    let at = |x: f32, y: f32, out: f32| side.point(middle + x, y, out);
    let on_arch = |i: usize, radius: f32| {
        let angle = PI * i as f32 / SEGMENTS as f32;
        (-radius * angle.cos(), SPRINGING + radius * angle.sin())
    };
    // Both faces of a strip between two heights: seen from the court, `along` points to the left.
    let faces = |b: &mut SceneBuilder, low: [(f32, f32); 2], high: [(f32, f32); 2]| {
        let corner = |(x, y): (f32, f32), out: f32| at(x, y, out);
        b.quad(
            [corner(low[0], outer), corner(low[1], outer), corner(high[1], outer), corner(high[0], outer)],
            p.plaster,
        );
        b.quad(
            [corner(low[1], inner), corner(low[0], inner), corner(high[0], inner), corner(high[1], inner)],
            p.plaster,
        );
    };
    for x in [-half_bay, ARCH_RADIUS] {
        let far = x + half_bay - ARCH_RADIUS;
        faces(b, [(x, SPRINGING), (far, SPRINGING)], [(x, ARCADE_TOP), (far, ARCADE_TOP)]);
        let under =
            [at(x, SPRINGING, inner), at(far, SPRINGING, inner), at(far, SPRINGING, outer), at(x, SPRINGING, outer)];
        b.quad(under, p.plaster);
    }
    for i in 0..SEGMENTS {
        let (a, c) = (on_arch(i, ARCH_RADIUS), on_arch(i + 1, ARCH_RADIUS));
        faces(b, [a, c], [(a.0, ARCADE_TOP), (c.0, ARCADE_TOP)]);
        let voussoir = if (i / 2) % 2 == 0 { p.red_stone } else { p.pale_stone };
        b.quad([at(a.0, a.1, inner), at(c.0, c.1, inner), at(c.0, c.1, outer), at(a.0, a.1, outer)], voussoir);
        voussoir_ring(b, [(a, on_arch(i, ARCH_RADIUS + 0.2)), (c, on_arch(i + 1, ARCH_RADIUS + 0.2))], at, voussoir);
    }
}

/// A piece of the ring around an arch, 2 cm proud of both faces. `ends` are (inner, outer) points of either end.
fn voussoir_ring(
    b: &mut SceneBuilder,
    ends: [((f32, f32), (f32, f32)); 2],
    at: impl Fn(f32, f32, f32) -> Vec3,
    material: u32,
) {
    const PROUD: f32 = 0.02;
    let [(a, a_far), (c, c_far)] = ends;
    for (face, sign) in [(ARCADE + HALF_THICKNESS, 1.0), (ARCADE - HALF_THICKNESS, -1.0)] {
        let proud = face + sign * PROUD;
        let point = |(x, y): (f32, f32), out: f32| at(x, y, out);
        let mut front = [point(a, proud), point(c, proud), point(c_far, proud), point(a_far, proud)];
        let mut back = [point(a_far, face), point(a_far, proud), point(c_far, proud), point(c_far, face)];
        let mut below = [point(a, face), point(c, face), point(c, proud), point(a, proud)];
        if sign < 0.0 {
            front.reverse();
            back.reverse();
            below.reverse();
        }
        for quad in [front, back, below] {
            b.quad(quad, material);
        }
    }
}

/// Floor tiles, ceiling and beams of a gallery.
fn gallery(b: &mut SceneBuilder, side: Side, p: &Palette, is_long: bool) {
    const TILE: f32 = 0.47;
    let start = ARCADE + HALF_THICKNESS + 0.12;
    let half_length = if is_long { WALL } else { start };
    let columns = (2.0 * half_length / TILE).round() as u32;
    let rows = ((WALL - start) / TILE).round() as u32;
    let (width, depth) = (2.0 * half_length / columns as f32, (WALL - start) / rows as f32);
    for row in 0..rows {
        for column in 0..columns {
            let corner = side.point(-half_length + width * column as f32, 0.0, start + depth * row as f32);
            let tile = p.tiles[((row + column) % 2) as usize];
            b.parallelogram(corner, side.out * depth, side.along * width, tile);
        }
    }
    let ceiling_start = ARCADE - HALF_THICKNESS + 0.1;
    let half_length = if is_long { WALL } else { ceiling_start };
    let corner = side.point(-half_length, CEILING, ceiling_start);
    b.parallelogram(corner, side.along * (2.0 * half_length), side.out * (WALL - ceiling_start), p.wood);
    let beams = if is_long { 24 } else { 16 };
    for i in 0..beams {
        let x = -half_length + 2.0 * half_length * (i as f32 + 0.5) / beams as f32;
        let (from, to) = (ARCADE + HALF_THICKNESS + 0.03, WALL - 0.001);
        side.block(b, [x - 0.06, CEILING - 0.16, from], [x + 0.06, CEILING - 0.001, to], p.wood);
    }
}

/// An outer wall with a painted dado, pilasters and a door.
fn outer_wall(b: &mut SceneBuilder, side: Side, p: &Palette, is_long: bool) {
    const THICKNESS: f32 = 0.4;
    const DOOR: f32 = 0.75;
    let half_length = if is_long { WALL + THICKNESS } else { WALL };
    side.block(b, [-half_length, COURT_FLOOR, WALL], [half_length, WALL_HEIGHT, WALL + THICKNESS], p.plaster);
    let end = if is_long { half_length + 0.12 } else { WALL - 0.12 };
    side.block(b, [-end, WALL_HEIGHT, WALL - 0.12], [end, WALL_HEIGHT + 0.18, WALL + THICKNESS + 0.12], p.pale_stone);
    for (from, to) in [(-WALL + 0.001, -DOOR - 0.15), (DOOR + 0.15, WALL - 0.001)] {
        side.block(b, [from, 0.0, WALL - 0.03], [to, 1.1, WALL - 0.001], p.dado);
        side.block(b, [from, 1.1, WALL - 0.05], [to, 1.16, WALL - 0.001], p.red_stone);
    }
    for i in 0..=BAYS {
        let x = -ARCADE + BAY * i as f32;
        if x.abs() > DOOR + 0.3 {
            side.block(b, [x - 0.16, 0.0, WALL - 0.1], [x + 0.16, CEILING - 0.2, WALL - 0.002], p.stone);
            side.block(
                b,
                [x - 0.2, CEILING - 0.35, WALL - 0.14],
                [x + 0.2, CEILING - 0.19, WALL - 0.003],
                p.pale_stone,
            );
        }
    }
    for x in [-DOOR - 0.15, DOOR] {
        side.block(b, [x, 0.0, WALL - 0.12], [x + 0.15, 2.4, WALL - 0.001], p.pale_stone);
    }
    side.block(b, [-DOOR - 0.22, 2.4, WALL - 0.15], [DOOR + 0.22, 2.62, WALL - 0.001], p.pale_stone);
    side.block(b, [-DOOR, 0.0, WALL - 0.05], [DOOR, 2.4, WALL - 0.001], p.wood);
}

/// A pent roof of curved tiles from the outer wall down to the arcade, mitred with its neighbours.
fn roof(b: &mut SceneBuilder, side: Side, p: &Palette) {
    const ROWS: usize = 9;
    const TILES: i32 = 72;
    const PARTS: i32 = 4;
    let (eave, ridge) = (ARCADE - 0.55, WALL);
    let (eave_height, ridge_height) = (ARCADE_TOP + 0.1, ARCADE_TOP + 1.35);
    let point = |step: i32, row: usize| {
        let x = ridge * step as f32 / (TILES * PARTS / 2) as f32;
        // Beyond the eave's end a course of tiles begins at the mitre.
        let start = (x.abs() - eave).max(0.0) / (ridge - eave);
        let t = start + (1.0 - start) * row as f32 / ROWS as f32;
        let swell = 0.05 * (PI * step as f32 / PARTS as f32).sin().abs();
        side.point(x, eave_height + (ridge_height - eave_height) * t + swell, eave + (ridge - eave) * t)
    };
    for step in -TILES * PARTS / 2..TILES * PARTS / 2 {
        for row in 0..ROWS {
            let seed = (step.div_euclid(PARTS) + 1000) as u32 * 31 + row as u32;
            let tile = p.roof[(hash_unit(seed) * 2.999) as usize];
            let quad = [point(step, row), point(step, row + 1), point(step + 1, row + 1), point(step + 1, row)];
            if quad[0] == quad[1] || quad[2] == quad[3] {
                continue;
            }
            // Not flat: two triangles with their own normals.
            b.polygon(&[quad[0], quad[1], quad[2]], tile);
            b.polygon(&[quad[0], quad[2], quad[3]], tile);
        }
    }
}

/// The paving of the court.
fn floors(b: &mut SceneBuilder, p: &Palette) {
    const SLABS: u32 = 22;
    let edge = ARCADE - HALF_THICKNESS - 0.12;
    let size = 2.0 * edge / SLABS as f32;
    for row in 0..SLABS {
        for column in 0..SLABS {
            let corner = Vec3::new(-edge + size * column as f32, COURT_FLOOR, -edge + size * row as f32);
            let paving = p.paving[(hash_unit(row * 97 + column) * 2.999) as usize];
            b.parallelogram(corner, Vec3::Z * size, Vec3::X * size, paving);
        }
    }
}

/// Four beds with kerbs, each with a tree.
fn garden(b: &mut SceneBuilder, p: &Palette) {
    const FROM: f32 = 1.7;
    const TO: f32 = 4.6;
    const KERB: f32 = 0.15;
    for (sx, sz) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
        let (x0, x1) = if sx > 0.0 { (FROM, TO) } else { (-TO, -FROM) };
        let (z0, z1) = if sz > 0.0 { (FROM, TO) } else { (-TO, -FROM) };
        let (low, high) = (COURT_FLOOR, COURT_FLOOR + 0.2);
        b.block([x0, low, z0], [x1, high, z0 + KERB], p.pale_stone);
        b.block([x0, low, z1 - KERB], [x1, high, z1], p.pale_stone);
        b.block([x0, low, z0 + KERB], [x0 + KERB, high, z1 - KERB], p.pale_stone);
        b.block([x1 - KERB, low, z0 + KERB], [x1, high, z1 - KERB], p.pale_stone);
        b.block([x0 + KERB, low, z0 + KERB], [x1 - KERB, high - 0.05, z1 - KERB], p.grass);
        let foot = Vec3::new(0.5 * (x0 + x1), high - 0.05, 0.5 * (z0 + z1));
        b.lathe(foot, &[(0.09, -0.01), (0.06, 0.3), (0.055, 1.3)], 16, p.wood);
        b.lathe(
            foot,
            &arc(0.0, 1.75, 0.62, -90.0, 90.0).iter().map(|&(r, y)| (r.max(0.0), y)).collect::<Vec<_>>(),
            28,
            p.foliage,
        );
    }
}

/// A round basin with a bowl on a foot.
fn fountain(b: &mut SceneBuilder, p: &Palette) {
    const SEGMENTS: u32 = 48;
    let centre = Vec3::new(0.0, COURT_FLOOR, 0.0);
    let basin =
        [(1.15, 0.0), (1.15, 0.08), (1.05, 0.12), (1.05, 0.42), (1.12, 0.46), (1.12, 0.52), (0.92, 0.52), (0.92, 0.1)];
    b.lathe(centre, &basin, SEGMENTS, p.pale_stone);
    b.lathe(centre, &[(0.921, 0.4), (0.1, 0.4)], SEGMENTS, p.water);
    let mut foot = vec![(0.2, 0.1), (0.2, 0.5), (0.12, 0.56), (0.09, 0.8), (0.1, 1.0), (0.16, 1.06)];
    foot.extend(arc(0.0, 1.56, 0.5, -70.0, -10.0));
    foot.extend([(0.46, 1.47), (0.3, 1.2), (0.0, 1.12)]);
    b.lathe(centre, &foot, SEGMENTS, p.stone);
    b.lathe(centre, &[(0.46, 1.42), (0.0, 1.42)], SEGMENTS, p.water);
}
