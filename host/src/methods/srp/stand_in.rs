//! Which lightmap texel with a receiver stands for a surface point, while precomputing: its own, or the nearest one of a
//! similar orientation for points on charts too small for texels and on texels that lie inside solids.
//!
//! The search for the nearest takes longer than a ray. It is done once for a whole texel, and once for a whole side of a
//! triangle whose chart has no texels: such charts are smaller than a texel.

use super::atlas::{Atlas, Lookup, Texel};
use super::model::NO_RECEIVER;
use super::world::{Seen, World};
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Not looked for yet.
const NOT_ASKED: u32 = u32::MAX - 1;

/// From points to texels with a receiver.
pub struct StandIns {
    lookup: Lookup,
    /// Of each texel.
    texel: Vec<u32>,
    /// Of each side of triangles whose charts have no texels, [`NOT_ASKED`] until it is wanted.
    side: Vec<AtomicU32>,
}

impl StandIns {
    /// `kept` says which texels have a receiver.
    pub fn new(world: &World<'_>, atlas: Arc<Atlas>, kept: impl Fn(u32) -> bool + Sync) -> Self {
        let order: Vec<u32> = (0..atlas.texels.len() as u32).map(|t| if kept(t) { t } else { NO_RECEIVER }).collect();
        let lookup = Lookup::new(atlas.clone(), &order);
        let stand_in = |(texel, own): (&Texel, &u32)| {
            let r = &texel.receiver;
            let nearest = || lookup.nearest(r.position, r.geometric_normal).unwrap_or(NO_RECEIVER);
            if *own == NO_RECEIVER { nearest() } else { *own }
        };
        let texel = atlas.texels.par_iter().zip(&order).map(stand_in).collect();
        let side = (0..2 * world.scene.triangles.len()).map(|_| AtomicU32::new(NOT_ASKED)).collect();
        Self { lookup, texel, side }
    }

    /// The texel that stands for a point, [`NO_RECEIVER`] without any.
    pub fn of(&self, world: &World<'_>, seen: &Seen) -> u32 {
        self.of_texel(world, seen, self.lookup.atlas().texel_of(seen.triangle, seen.weights, seen.front))
    }

    /// The same of a point whose own texel is known (an index into [`Atlas::texels`]).
    pub fn of_texel(&self, world: &World<'_>, seen: &Seen, texel: u32) -> u32 {
        if let Some(stands_in) = self.texel.get(texel as usize) {
            return *stands_in;
        }
        if self.lookup.atlas().has(seen.triangle, seen.front) {
            let own = self.lookup.one(seen.triangle, seen.weights, seen.front, seen.position, seen.normal);
            return own.unwrap_or(NO_RECEIVER);
        }
        let place = &self.side[2 * seen.triangle as usize + usize::from(seen.front)];
        let known = place.load(Relaxed);
        if known != NOT_ASKED {
            return known;
        }
        // Of the middle of the triangle: the same whichever ray comes first.
        let middle = world.seen(seen.triangle, [1.0 / 3.0; 3], seen.front);
        let found = self.lookup.nearest(middle.position, middle.normal).unwrap_or(NO_RECEIVER);
        place.store(found, Relaxed);
        found
    }
}

#[cfg(test)]
mod tests {
    use super::super::charts::Patches;
    use super::super::reach::Reach;
    use super::*;
    use crate::scene::built_in;

    #[test]
    fn every_point_has_a_texel_with_a_receiver_nearby_that_faces_the_same_way() {
        let scene = built_in::cornell_box();
        let (world, patches) = (World::new(&scene).unwrap(), Patches::new(&scene, 0.02));
        let reach = Reach::new(&world, &patches, 1).unwrap();
        let atlas = Arc::new(Atlas::new(&world, &patches, &reach.exposed, 2000));
        // Every third texel is lost.
        let stand_ins = StandIns::new(&world, atlas.clone(), |t| !t.is_multiple_of(3));
        let mut own = 0;
        for triangle in 0..scene.triangles.len() as u32 {
            for weights in [[0.4, 0.3, 0.3], [0.9, 0.05, 0.05], [0.1, 0.1, 0.8]] {
                for front in [true, false] {
                    let seen = world.seen(triangle, weights, front);
                    let found = stand_ins.of(&world, &seen);
                    assert!(!found.is_multiple_of(3) && (found as usize) < atlas.texels.len(), "{found}");
                    let r = &atlas.texels[found as usize].receiver;
                    if front {
                        assert!((r.position - seen.position).length() < 2.5 * atlas.texel_size);
                        assert!(r.geometric_normal.dot(seen.normal) > 0.5);
                    }
                    own += u32::from(found == atlas.texel_of(triangle, weights, front));
                    assert_eq!(found, stand_ins.of(&world, &seen));
                }
            }
        }
        // Fronts of 32 triangles at three points, of which two thirds still have their own.
        assert!((40..90).contains(&own), "{own}");
    }
}
