//! Mutual visibility of probes and surfaces, kept per lightmap texel: what all of a texel agrees on need not be asked of
//! every ray that ends there.
//!
//! A texel is asked at its receiver and at the four outermost points of what covers it. Where all of them see a probe, or
//! none does, so is the whole texel taken; elsewhere (borders of shadows) each point is asked for itself. What is finer than
//! a texel and lies between these points is missed, as it is by light, which a texel holds once. Answers are found when
//! they are first wanted, and depend on texel and probe alone: neither threads nor order change a bit.

use super::atlas::Atlas;
use super::world::{Seen, World};
use glam::Vec3;
use std::sync::atomic::{AtomicU8, Ordering::Relaxed};

/// Not asked yet.
const UNKNOWN: u8 = 0;
const SEEN: u8 = 1;
const HIDDEN: u8 = 2;
/// Some of it is seen.
const MIXED: u8 = 3;
/// Texels times probes beyond which nothing is kept: a byte each.
const LIMIT_BYTES: usize = 1 << 30;
/// No texel.
pub const NO_TEXEL: u32 = u32::MAX;

/// Which probes see which texels.
pub struct Visibility {
    probe_count: usize,
    /// `[texel][probe]`.
    known: Vec<AtomicU8>,
}

impl Visibility {
    /// Nothing is known yet. `None` where there would be too much to know.
    pub fn new(texels: usize, probes: usize) -> Option<Self> {
        let bytes = texels.checked_mul(probes).filter(|bytes| *bytes <= LIMIT_BYTES)?;
        Some(Self { probe_count: probes, known: (0..bytes).map(|_| AtomicU8::new(UNKNOWN)).collect() })
    }

    /// Whether a probe sees a point of a texel (an index into [`Atlas::texels`]). Adds the rays that it took to `asked`.
    #[inline(always)]
    pub fn sees(&self, of: &Asked<'_>, texel: u32, probe: u32, at: &Seen, asked: &mut u64) -> bool {
        let place = &self.known[texel as usize * self.probe_count + probe as usize];
        let mut state = place.load(Relaxed);
        if state == UNKNOWN {
            // Two threads may find the same answer at the same time.
            state = of.ask(texel, probe, asked);
            place.store(state, Relaxed);
        }
        match state {
            SEEN => true,
            HIDDEN => false,
            _ => of.sees(at, probe, asked),
        }
    }

    /// Shares of the texels and probes that were asked which agree, and which do not.
    pub fn shares(&self) -> [f64; 2] {
        let count = |f: &dyn Fn(u8) -> bool| self.known.iter().filter(|s| f(s.load(Relaxed))).count() as f64;
        let asked = count(&|s| s != UNKNOWN).max(1.0);
        [count(&|s| s == SEEN || s == HIDDEN) / asked, count(&|s| s == MIXED) / asked]
    }
}

/// What is asked: surfaces and probes.
pub struct Asked<'a> {
    /// The scene.
    pub world: &'a World<'a>,
    /// The lightmap.
    pub atlas: &'a Atlas,
    /// Positions of the probes (m).
    pub probes: &'a [Vec3],
}

impl Asked<'_> {
    /// Whether a probe sees a point.
    #[inline(always)]
    pub fn sees(&self, at: &Seen, probe: u32, asked: &mut u64) -> bool {
        *asked += 1;
        self.world.sees(at, self.probes[probe as usize])
    }

    /// What a texel's points say of a probe.
    fn ask(&self, texel: u32, probe: u32, asked: &mut u64) -> u8 {
        let (mut seen, mut hidden) = (false, false);
        let from = self.probes[probe as usize];
        for point in self.atlas.points(self.world, texel) {
            // A point that faces away says nothing: no ray that ends beside it asks for this probe.
            if (point.position - from).dot(point.normal) < 0.0 {
                let sees = self.sees(&point, probe, asked);
                (seen, hidden) = (seen || sees, hidden || !sees);
                if seen && hidden {
                    break;
                }
            }
        }
        match (seen, hidden) {
            (true, false) => SEEN,
            (false, true) => HIDDEN,
            _ => MIXED,
        }
    }
}
