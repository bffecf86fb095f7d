//! One cone through a voxel pyramid.
//!
//! Crassin et al. 2011, §7: a march along the axis, front to back, through voxels as large as the cone is wide.
//!
//! Deviation, the law of opacity. The usual march samples trilinearly and corrects each sample's opacity for its step of s
//! voxels, 1 − (1 − α)^s, as if a voxel held mist: a wall that two voxels share, half each, lets ¼ of the light through;
//! grazing light passes walls, because the weights dᵢ² of the stored directions shrink faster than the way through the wall
//! grows; and rays that leave a surface are darkened by its back, which the filter smears a voxel far. Here the ray collects
//! a layer of voxels, from the direction stored for the layer's axis, where it crosses the layer's middle
//! ([`VoxelPyramid::crossing`]), and within one surface coverages add up, as those of neighbouring pieces of one surface do.
//! A plane across an axis then covers exactly 1, at any angle and wherever it lies in its voxels, with no step to choose and
//! no opacity to correct; a small thing covers as much as its projected area. Once the ray has crossed a layer in which
//! nothing is, the next surface is independent of the last one: transmittances multiply.
//! A tilted plane covers 1 on average over rays; a single ray may meet more of its voxels or fewer, and what it meets beyond
//! 1 is lost, so that a tilted sheet lets some 7 % through (two sheets of a wall: the square).
//!
//! Layers come in order along each axis (Amanatides & Woo 1987). An axis changes to the next coarser level where it enters
//! one of that level's voxels, so that no layer is met twice or missed. Instead of a blend of two levels (quadrilinear), in
//! which a surface counts once where its fine and once where its coarse voxel lies, cones differ by a random share of a level.

use crate::math::float::{abs, ceil, floor, max, min, to_i32};
use crate::voxel::grid::{Grid, dominant_axis, of_axis};
use crate::voxel::query::VoxelPyramid;
use glam::{Vec3, Vec4};

/// How cones march; see [`interreflect_shared::cone::ConeParams`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeMarch {
    /// Size of the voxels read, per distance.
    pub spread: f32,
    /// Size of the voxels read, at most, at the start, in voxels of level 0.
    pub clear: f32,
    /// Growth of that bound per distance.
    pub clear_slope: f32,
    /// Factor from 1 to 2 on the size before it is rounded down to a level: √2 rounds to the nearest, a random number makes
    /// level changes invisible.
    pub rounding: f32,
}

impl ConeMarch {
    /// Size of the voxels to read at a distance: the cone's width, but no more than the height above the surface that the
    /// cone leaves allows.
    #[inline(always)]
    fn size(&self, t: f32) -> f32 {
        max(min(self.spread * t, self.clear + self.clear_slope * t), 1.0)
    }

    /// Level to read at a distance. The exponent of a float is the floor of its base-2 logarithm, exactly and on every target.
    #[inline(always)]
    fn level(&self, t: f32) -> u32 {
        ((self.size(t) * self.rounding).to_bits() >> 23) - 127
    }
}

/// Transmittance below which a cone has seen enough.
const OPAQUE: f32 = 1e-3;
/// Layers of one cone, at most: three times 512 voxels one by one, and some.
const MAX_LAYERS: u32 = 2048;

/// A ray along one axis.
#[derive(Clone, Copy)]
struct Along {
    origin: f32,
    slope: f32,
    /// Voxels of level 0.
    count: u32,
}

/// The layer that a ray meets next along one axis.
#[derive(Clone, Copy)]
struct Layer {
    level: u32,
    /// Index among those of its level.
    index: i32,
    /// Distance at which the ray crosses its middle; [`f32::MAX`] after the last one.
    t: f32,
}

impl Layer {
    #[inline(always)]
    fn first(along: &Along) -> Self {
        let below = to_i32(floor(along.origin - 0.5));
        let at_or_above = to_i32(ceil(along.origin - 0.5));
        let index = if along.slope < 0.0 { at_or_above - 1 } else { below + 1 };
        Self { level: 0, index, t: Self::distance(along, 0, index) }
    }

    /// The layer after this one, of the next coarser level where that is wanted and begins here.
    #[inline(always)]
    fn next(&self, along: &Along, wanted: u32) -> Self {
        let down = along.slope < 0.0;
        let coarser = (((self.index & 1 == 0) == down) & (wanted > self.level)) as u32;
        let index = if down { self.index - 1 } else { self.index + 1 };
        // Arithmetic shift: rounds down for the layer before the first, too.
        let (level, index) = (self.level + coarser, index >> coarser);
        Self { level, index, t: Self::distance(along, level, index) }
    }

    #[inline(always)]
    fn distance(along: &Along, level: u32, index: i32) -> f32 {
        let count = (along.count + (1 << level) - 1) >> level;
        let outwards = if along.slope < 0.0 { index < 0 } else { index >= count as i32 };
        let middle = (index as f32 + 0.5) * (1u32 << level) as f32;
        let t = (middle - along.origin) / along.slope;
        if outwards | (abs(along.slope) < FLATTEST) { f32::MAX } else { t }
    }

    /// `self` or another layer, by fields: as a choice between records it would be branches on a device.
    #[inline(always)]
    fn or(self, other: Self, takes_other: bool) -> Self {
        Self {
            level: if takes_other { other.level } else { self.level },
            index: if takes_other { other.index } else { self.index },
            t: if takes_other { other.t } else { self.t },
        }
    }
}

/// Axis on which the next layer lies, and that layer.
#[inline(always)]
fn nearest(x: Layer, y: Layer, z: Layer) -> (u32, Layer) {
    let (x_first, y_first) = ((x.t <= y.t) & (x.t <= z.t), y.t <= z.t);
    let axis = if y_first { 1 } else { 2 };
    (if x_first { 0 } else { axis }, z.or(y, y_first).or(x, x_first))
}

/// Slopes below this meet no layer within any grid.
const FLATTEST: f32 = 1e-6;

/// Radiance that a cone gathers (rgb, W/(sr m²)) and the share of it that leaves the grid (w). `origin` in voxels of level
/// 0 from the grid's corner, `direction` unit.
#[inline(always)]
pub fn trace_cone<G: Grid>(
    grid: &G,
    pyramid: &VoxelPyramid<'_>,
    origin: Vec3,
    direction: Vec3,
    march: &ConeMarch,
) -> Vec4 {
    let d = grid.dims_levels();
    let main = dominant_axis(direction);
    let along_x = Along { origin: origin.x, slope: direction.x, count: d.x };
    let along_y = Along { origin: origin.y, slope: direction.y, count: d.y };
    let along_z = Along { origin: origin.z, slope: direction.z, count: d.z };
    let (mut x, mut y, mut z) = (Layer::first(&along_x), Layer::first(&along_y), Layer::first(&along_z));
    let (mut axis, mut layer) = nearest(x, y, z);
    let mut radiance = Vec3::ZERO;
    // Transmittance up to the surface being crossed, and how much of the beam that surface has covered.
    let (mut reaching, mut covered) = (1.0, 0.0);
    let mut layers_met = 0;
    while (layers_met < MAX_LAYERS) & (layer.t < f32::MAX) & (reaching * (1.0 - covered) >= OPAQUE) {
        layers_met += 1;
        let along = Along {
            origin: of_axis(axis, origin.x, origin.y, origin.z),
            slope: of_axis(axis, direction.x, direction.y, direction.z),
            count: of_axis(axis, d.x, d.y, d.z),
        };
        let position = origin + direction * layer.t;
        let seen = pyramid.crossing(grid, layer.level, axis, layer.index, along.slope < 0.0, position);
        if seen.w > 0.0 {
            let fresh = min(seen.w, 1.0 - covered);
            radiance += seen.truncate() * (reaching * fresh / seen.w);
            covered += fresh;
        } else if axis == main {
            reaching *= 1.0 - covered;
            covered = 0.0;
        }
        let next = layer.next(&along, march.level(layer.t).min(d.w - 1));
        (x, y, z) = (x.or(next, axis == 0), y.or(next, axis == 1), z.or(next, axis == 2));
        (axis, layer) = nearest(x, y, z);
    }
    radiance.extend(reaching * (1.0 - covered))
}
