//! Parts of plans that others for the same scene may take over: who looks for settings asks for many bakes that differ in
//! little. Each part is kept with all that it depends on, so that what is taken over is what would have been made.

use super::charts::Patches;
use super::plan::{BakeOptions, Ground, Places};
use super::reach::Reach;
use super::round_trip::RoundTrip;
use super::world::Structures;
use crate::methods::MethodError;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Instant;

/// Parts of a kind that are kept, those that were asked for last.
const KEPT: usize = 6;

/// Parts of plans for one scene.
#[derive(Default)]
pub struct Memo {
    /// Of the scene alone.
    pub(super) structures: Shelf<(), Structures>,
    /// By receivers.
    pub(super) patches: Shelf<u32, Patches>,
    /// Seconds of one ray; of the scene alone.
    pub(super) ray_s: Shelf<(), f64>,
    /// Seconds of a multiply-add.
    pub(super) product_s: Shelf<(), f64>,
    /// By seed, and chart of each triangle.
    pub(super) reach: Shelf<(u32, Vec<u32>), Reach>,
    pub(super) ground: Shelf<BakeOptions, Ground>,
    pub(super) places: Shelf<BakeOptions, Places>,
    pub(super) round_trips: Shelf<BakeOptions, RoundTrip>,
}

/// Parts of one kind by what they depend on, the last asked for first, each with the milliseconds that it took.
pub(super) struct Shelf<K, T>(Mutex<Vec<(K, Arc<T>, f64)>>);

impl<K, T> Default for Shelf<K, T> {
    fn default() -> Self {
        Self(Mutex::new(Vec::new()))
    }
}

impl<K: PartialEq, T> Shelf<K, T> {
    /// The part that was asked for last, and the milliseconds that it took.
    pub(super) fn last(&self) -> Option<(Arc<T>, f64)> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).first().map(|p| (p.1.clone(), p.2))
    }

    /// Whether the part of a key is there.
    pub(super) fn holds(&self, key: &K) -> bool {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).iter().any(|p| p.0 == *key)
    }

    /// The part of a key, found or made; what it took is added to `spared_ms` if it was found.
    pub(super) fn get(
        &self,
        key: K,
        spared_ms: &mut f64,
        make: impl FnOnce() -> Result<T, MethodError>,
    ) -> Result<Arc<T>, MethodError> {
        // A part is put there whole: a maker that panicked has left nothing behind.
        let mut parts = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (part, ms) = match parts.iter().position(|p| p.0 == key) {
            Some(at) => {
                let (_, part, ms) = parts.remove(at);
                *spared_ms += ms;
                (part, ms)
            }
            None => {
                let start = Instant::now();
                let part = Arc::new(make()?);
                (part, start.elapsed().as_secs_f64() * 1e3)
            }
        };
        parts.insert(0, (key, part.clone(), ms));
        parts.truncate(KEPT);
        Ok(part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_asked_for_stay_and_say_what_they_spare() {
        let shelf: Shelf<usize, usize> = Shelf::default();
        // What was spared, where it was found; `None` where it was made.
        let ask = |key: usize| {
            let (mut spared_ms, mut made) = (0.0, false);
            let make = || {
                made = true;
                Ok(10 * key)
            };
            assert_eq!(*shelf.get(key, &mut spared_ms, make).unwrap(), 10 * key);
            assert!(!made || spared_ms == 0.0);
            (!made).then_some(spared_ms)
        };
        assert!(!shelf.holds(&0) && shelf.last().is_none());
        for key in 0..KEPT {
            assert_eq!(ask(key), None, "{key}");
            assert!(shelf.holds(&key) && shelf.last().is_some_and(|(part, _)| *part == 10 * key));
        }
        let first = ask(0);
        assert!(first.is_some() && first == ask(0));
        // One more puts the one away that was asked for the longest ago.
        assert!(ask(KEPT).is_none() && ask(0).is_some() && ask(1).is_none());
        let failed = shelf.get(99, &mut 0.0, || Err(MethodError::NotPrecomputed { method: "srp" }));
        assert!(failed.is_err() && ask(99).is_none());
    }
}
