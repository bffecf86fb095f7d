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
use crate::voxel::grid::{Grid, dominant_axis};
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

/// The layers that a ray meets along one axis.
#[derive(Clone, Copy)]
struct Layers {
    origin: f32,
    slope: f32,
    level: u32,
    /// Next layer of that level.
    next: i32,
    /// Distance at which the ray crosses its middle; [`f32::MAX`] after the last one.
    t: f32,
}

impl Layers {
    #[inline(always)]
    fn new(origin: f32, slope: f32, count: u32) -> Self {
        let below = to_i32(floor(origin - 0.5));
        let at_or_above = to_i32(ceil(origin - 0.5));
        let next = if slope < 0.0 { at_or_above - 1 } else { below + 1 };
        let mut layers = Self { origin, slope, level: 0, next, t: 0.0 };
        layers.find(count);
        layers
    }

    /// Goes on to the next layer, of the next coarser level where that is wanted and begins here.
    #[inline(always)]
    fn advance(&mut self, wanted: u32, count_of_finest: u32) {
        let down = self.slope < 0.0;
        let at_border = (self.next & 1 == 0) == down;
        self.next = if down { self.next - 1 } else { self.next + 1 };
        if at_border & (wanted > self.level) {
            self.level += 1;
            // Arithmetic shift: rounds down for the layer before the first, too.
            self.next >>= 1;
        }
        self.find(count_of_finest);
    }

    #[inline(always)]
    fn find(&mut self, count_of_finest: u32) {
        let count = (count_of_finest + (1 << self.level) - 1) >> self.level;
        let outwards = ((self.slope < 0.0) & (self.next < 0)) | ((self.slope >= 0.0) & (self.next >= count as i32));
        let middle = (self.next as f32 + 0.5) * (1u32 << self.level) as f32;
        self.t = if outwards | (abs(self.slope) < FLATTEST) { f32::MAX } else { (middle - self.origin) / self.slope };
    }
}

/// Slopes below this meet no layer within any grid.
const FLATTEST: f32 = 1e-6;

/// Radiance that a cone gathers (rgb, W/(sr m²)) and the share of it that leaves the grid (w). `origin` in voxels of level
/// 0 from the grid's corner, `direction` unit.
pub fn trace_cone<G: Grid>(
    grid: &G,
    pyramid: &VoxelPyramid<'_>,
    origin: Vec3,
    direction: Vec3,
    march: &ConeMarch,
) -> Vec4 {
    let d = grid.dims_levels();
    let main = dominant_axis(direction);
    let mut x = Layers::new(origin.x, direction.x, d.x);
    let mut y = Layers::new(origin.y, direction.y, d.y);
    let mut z = Layers::new(origin.z, direction.z, d.z);
    let mut radiance = Vec3::ZERO;
    // Transmittance up to the surface being crossed, and how much of the beam that surface has covered.
    let (mut reaching, mut covered) = (1.0, 0.0);
    let mut layers_met = 0;
    while layers_met < MAX_LAYERS {
        layers_met += 1;
        let axis = if (x.t <= y.t) & (x.t <= z.t) {
            0
        } else if y.t <= z.t {
            1
        } else {
            2
        };
        let layer = if axis == 0 {
            x
        } else if axis == 1 {
            y
        } else {
            z
        };
        if (layer.t >= f32::MAX) | (reaching * (1.0 - covered) < OPAQUE) {
            break;
        }
        let position = origin + direction * layer.t;
        let seen = pyramid.crossing(grid, layer.level, axis, layer.next, layer.slope < 0.0, position);
        if seen.w > 0.0 {
            let fresh = min(seen.w, 1.0 - covered);
            radiance += seen.truncate() * (reaching * fresh / seen.w);
            covered += fresh;
        } else if axis == main {
            reaching *= 1.0 - covered;
            covered = 0.0;
        }
        let wanted = march.level(layer.t).min(d.w - 1);
        if axis == 0 {
            x.advance(wanted, d.x);
        } else if axis == 1 {
            y.advance(wanted, d.y);
        } else {
            z.advance(wanted, d.z);
        }
    }
    radiance.extend(reaching * (1.0 - covered))
}
