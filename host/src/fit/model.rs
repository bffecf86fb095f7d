//! What one setting does to a method's picture and time, learnt where it is cheap to ask, and what several do together.
//!
//! Pictures add up: the change that a setting makes to the mean of each block at a small size is added to the picture at the
//! size in question, so that errors which cancel are seen to cancel. Times multiply, each phase's by its own ratio, and so does
//! memory. Both are guesses: they decide what is tried, never what is chosen.

use super::{Candidate, Goal};
use crate::methods::Settings;
use glam::DVec3;

/// Time below which a phase's ratio is not believed (ms).
const SHORTEST_MS: f64 = 1e-3;

/// What a setting's other value changed, everything else being equal.
#[derive(Clone, PartialEq, Debug)]
pub struct Effect {
    /// The setting.
    pub key: String,
    /// Its other value.
    pub value: String,
    /// Settings by which the place where it was learnt differs from the place in question; empty: by none.
    pub learnt_at: String,
    /// Change of each block's mean irradiance (W/m²).
    picture: Vec<DVec3>,
    /// Factors on the times of a light change and of a frame.
    ratios: [f64; 2],
    /// Factor on the bytes of the method's buffers.
    memory_ratio: f64,
}

impl Effect {
    /// From two candidates that differ in one setting, for settings that may differ in others.
    pub fn between(before: &Candidate, after: &Candidate, key: &str, at: &Settings) -> Self {
        let ratio = |a: f64, b: f64| if a.max(b) > SHORTEST_MS { b / a.max(SHORTEST_MS) } else { 1.0 };
        let elsewhere = before.settings.iter().filter(|(k, v)| at.get(*k) != Some(*v));
        let elsewhere: Vec<String> = elsewhere.map(|(k, v)| format!("{k}={v}")).collect();
        Self {
            key: key.into(),
            value: after.settings.get(key).cloned().unwrap_or_default(),
            learnt_at: elsewhere.join(" "),
            picture: before.means.iter().zip(&after.means).map(|(a, b)| *b - *a).collect(),
            ratios: [
                ratio(before.dynamic_ms - before.frame_ms, after.dynamic_ms - after.frame_ms),
                ratio(before.frame_ms, after.frame_ms),
            ],
            memory_ratio: after.memory_bytes.max(1) as f64 / before.memory_bytes.max(1) as f64,
        }
    }
}

/// What settings are expected to give.
#[derive(Clone, PartialEq, Debug)]
pub struct Prediction {
    /// Mean irradiance (W/m²) of each block.
    pub means: Vec<DVec3>,
    /// Times of a light change and of a frame (ms).
    pub times: [f64; 2],
    /// The method's buffers.
    pub memory_bytes: f64,
}

impl Prediction {
    /// What was measured.
    pub fn measured(c: &Candidate) -> Self {
        Self {
            means: c.means.clone(),
            times: [c.dynamic_ms - c.frame_ms, c.frame_ms],
            memory_bytes: c.memory_bytes as f64,
        }
    }

    /// With one more setting changed.
    pub fn with(&self, effect: &Effect) -> Self {
        let means = self.means.iter().zip(&effect.picture).map(|(m, d)| (*m + *d).max(DVec3::ZERO)).collect();
        let times = [0, 1].map(|k| self.times[k] * effect.ratios[k]);
        Self { means, times, memory_bytes: self.memory_bytes * effect.memory_ratio }
    }

    /// Time of a frame under a goal (ms).
    pub fn cost(&self, goal: &Goal) -> f64 {
        if goal.still { self.times[1] } else { self.times[0] + self.times[1] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::Effort;

    fn candidate(size: &str, cones: &str, mean: f64, [light, frame]: [f64; 2]) -> Candidate {
        let settings = [("size", size), ("cones", cones)].map(|(k, v)| (k.to_string(), v.to_string()));
        Candidate {
            dynamic_ms: light + frame,
            frame_ms: frame,
            memory_bytes: (1024.0 * frame) as u64,
            means: vec![DVec3::splat(mean)],
            ..Candidate::unjudged("m", &Settings::from(settings), Effort::Glance)
        }
    }

    #[test]
    fn pictures_add_and_times_multiply_phase_by_phase() {
        let (before, after) = (candidate("32", "9", 2.0, [10.0, 4.0]), candidate("32", "5", 1.5, [10.0, 2.0]));
        let large = candidate("128", "9", 3.0, [100.0, 8.0]);
        let effect = Effect::between(&before, &after, "cones", &large.settings);
        assert_eq!((effect.value.as_str(), effect.learnt_at.as_str()), ("5", "size=32"));
        let predicted = Prediction::measured(&large).with(&effect);
        assert_eq!(predicted.means, vec![DVec3::splat(2.5)]);
        assert_eq!(predicted.times, [100.0, 4.0]);
        assert_eq!(predicted.memory_bytes, 4096.0);
        assert_eq!(predicted.cost(&Goal::default()), 104.0);
        assert_eq!(predicted.cost(&Goal { still: true, ..Goal::default() }), 4.0);
    }

    #[test]
    fn light_is_not_predicted_to_be_negative() {
        let (before, after) = (candidate("32", "9", 2.0, [0.0, 4.0]), candidate("32", "5", 0.5, [0.0, 2.0]));
        let dark = candidate("64", "9", 1.0, [0.0, 4.0]);
        let predicted = Prediction::measured(&dark).with(&Effect::between(&before, &after, "cones", &dark.settings));
        assert_eq!(predicted.means, vec![DVec3::ZERO]);
        assert_eq!(predicted.times[0], 0.0);
    }
}
