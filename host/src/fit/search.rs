//! The search itself: ladders are climbed, then single steps are explored beside whatever was tried, then finalists are
//! confirmed. It knows settings only by what its [`Source`] gave for them, and is tested on made-up ones.

use super::model::Prediction;
use super::{
    Axis, Candidate, Effect, Effort, Evidence, Goal, Neighbour, Reason, Rejected, Source, axes, finite, same, step,
    words,
};
use crate::error::Error;
use crate::methods::{MethodRow, SetUp, Settings};
use std::collections::BTreeMap;

/// Share of the cost that a step must leave at most: less is the clock's noise, and not worth an error.
const SAVES: f64 = 0.97;
/// How much faster a trial at the smallest size must be for the model to be asked there.
const CHEAP: f64 = 4.0;
/// Settings, the one in question among them, in which a place where an effect was learnt may differ.
const FAR: usize = 3;
/// Cost over the cheapest's up to which a candidate is timed again on the whole picture, and how many of them.
const FINALISTS: (f64, usize) = (1.15, 3);
/// Part of the error below which the light that all further terms carry is not worth a trial.
const NEGLIGIBLE: f64 = 0.1;
/// Blocks of the picture at which the truth of a finalist is traced at least: a few blocks may miss where the error is.
const CONFIRMED_BLOCKS: usize = 512;
/// Part of the time that a sweep of all rungs and their neighbours would take, as far as their times are known, after which a
/// search that has something that fits looks no further.
const PATIENCE: f64 = 0.25;
/// Part of the time of the ladders for which steps beside them are tried in any case: one slow trial must not leave what is
/// quick to ask unasked.
const EXPLORED: f64 = 0.3;
/// Part of that sweep's time that a finer truth may take.
const REFINING: f64 = 0.05;
/// Cost of what fits over that of what may fit, from which on a finer truth is traced to know.
const WORTH: f64 = 1.3;
/// Times as much as the patience with what fits, after which a search that has found nothing leaves ladders without hope,
/// and steps beside what comes nearest.
const HOPE: f64 = 2.0;
/// Overrun of a rung up to which one dearer parameter is tried before the next rung, and how many such.
const NARROW: f64 = 1.25;
const BESIDE: usize = 3;
/// Estimate of a precomputation over its limit from which on it is not tried.
const MISJUDGED: f64 = 1.25;
/// Ratio of times from rung to rung where only one is known.
const GROWTH: f64 = 2.0;
/// Least ratio of errors from rung to rung that a ladder is expected to go on with, and how much better than that it may
/// turn out to be.
const OPTIMISM: [f64; 2] = [0.6, 0.7];

/// Spread of the logarithm of an error by what the same step did to the same settings, and once more for each setting that
/// was another there; by nothing.
const SPREAD: f64 = 0.1;
const SPREAD_UNKNOWN: f64 = 0.5;
/// Ratio of times that a step is expected to make of which nothing is known.
const UNKNOWN: f64 = 1.3;
/// Probability of keeping the limit below which a step is not worth a trial.
const LEAST_CHANCE: f64 = 0.3;
/// Seconds that any trial takes at least, as far as its promise is concerned: quick is not the same as worth asking.
const LEAST_S: f64 = 0.1;

/// What the search remembers.
pub(super) struct Search<'a, S> {
    pub evidence: &'a mut Evidence<S>,
    goal: Goal,
    /// Part of a sweep's time that it takes at most; infinite: as long as there is something to try.
    patience: f64,
    methods: &'a [&'static MethodRow],
    news: &'a mut dyn FnMut(&Candidate),
    tried: Vec<Candidate>,
    rejected: Vec<Rejected>,
    /// Settings that their method refused.
    refused: Vec<(&'static str, Settings)>,
    /// By method: precomputation of its last trial over what it was estimated to take.
    misjudged: BTreeMap<&'static str, f64>,
    /// Whether steps beside what was tried had their turn, where no rung fits.
    explored: bool,
    /// Seconds after which the ladders were climbed.
    climbed_s: f64,
    /// What estimates spared, in words.
    pub spared: Vec<String>,
}

/// How far a method's ladder was climbed.
struct Ladder {
    row: &'static MethodRow,
    next: usize,
    /// Cost of the last rung: rungs are ordered by it.
    cost: f64,
    memory_bytes: u64,
    /// Seconds that the next rung's precomputation will take, as far as its method knows.
    set_up_s: f64,
    errors: Vec<f64>,
}

impl Ladder {
    /// Error of the last rung, if errors go on falling as they do, and somewhat faster; `None` before they are known to fall.
    fn expected(&self) -> Option<f64> {
        let [.., before, last] = self.errors.as_slice() else { return None };
        let left = self.row.ladder.len().saturating_sub(self.next) as i32;
        Some(OPTIMISM[1] * last * (last / before).clamp(OPTIMISM[0], 1.0).powi(left))
    }
}

impl<'a, S: Source> Search<'a, S> {
    pub(super) fn new(
        evidence: &'a mut Evidence<S>,
        goal: Goal,
        thorough: bool,
        methods: &'a [&'static MethodRow],
        news: &'a mut dyn FnMut(&Candidate),
    ) -> Self {
        let patience = if thorough { f64::INFINITY } else { PATIENCE };
        let (tried, rejected, spared) = (Vec::new(), Vec::new(), Vec::new());
        Self {
            evidence,
            goal,
            patience,
            methods,
            news,
            tried,
            rejected,
            refused: Vec::new(),
            misjudged: BTreeMap::new(),
            explored: false,
            climbed_s: 0.0,
            spared,
        }
    }

    /// Seconds that a sweep of every rung and its neighbours would take at least: rungs that were not run as long as the last
    /// that was, up to the one that, as times grow from rung to rung, would not keep the limits. Its trials would share as much
    /// with each other as those of the search did.
    fn sweep_s(&mut self) -> f64 {
        let mut sum = 0.0;
        for row in self.methods {
            let own = || self.tried.iter().filter(|c| c.row == row.name);
            let own_share = own().map(|c| c.took_s).sum::<f64>() / own().map(|c| c.wall_s).sum::<f64>().max(1e-9);
            let mut each_s: f64 = 0.0;
            // Of precomputation and of a frame, rung by rung (ms).
            let mut times: Vec<[f64; 2]> = Vec::new();
            for (_, changes) in row.ladder {
                let Ok(rung) = row.with(changes.iter().copied()) else { continue };
                let ran = self.tried.iter().find(|c| c.row == row.name && c.settings == rung);
                let ran = ran.map(|c| ([c.precompute_ms, self.goal.cost(c)], c.wall_s));
                let (times_ms, wall_s) = ran.unwrap_or_else(|| {
                    let [precompute, frame] = [0, 1].map(|k| grown(times.iter().map(|t| t[k])));
                    let told_s = self.set_up(row, &rung).map(|told| told.whole_s);
                    ([told_s.map_or(precompute, |s| 1e3 * s), frame], each_s.max(told_s.unwrap_or(0.0)))
                });
                each_s = wall_s;
                times.push(times_ms);
                if self.goal.precompute_ms.is_some_and(|limit| times_ms[0] > limit)
                    || self.goal.ms.is_some_and(|limit| times_ms[1] > limit)
                {
                    // It is by asking this one that a sweep sees it.
                    sum += each_s;
                    break;
                }
                let beside = |axis: &Axis| [-1, 1].into_iter().filter(|d| step(&rung, axis, *d).is_some()).count();
                sum += each_s * (1.0 + own_share * axes(row, &rung).iter().map(beside).sum::<usize>() as f64);
            }
        }
        sum
    }

    /// Whether it has found nothing that fits for so long that what is left has little hope; says so once.
    fn is_given_up(&mut self) -> bool {
        const WORDS: &str = "nothing fits so far";
        if self.patience.is_infinite() || self.best().is_some() {
            return false;
        }
        let (spent_s, sweep_s) = (self.evidence.source.elapsed_s(), self.sweep_s());
        let over = spent_s > HOPE * self.patience * sweep_s;
        if over && !self.spared.iter().any(|s| s.starts_with(WORDS)) {
            self.spared.push(format!(
                "{WORDS}, after {spent_s:.1} s, and what is left has little hope, as errors fell (`--thorough` tries it all the \
                 same)"
            ));
        }
        over
    }

    /// Whether it has something that fits, and has looked long enough for something better; says so once.
    fn is_patience_over(&mut self) -> bool {
        const WORDS: &str = "the search ended";
        if self.patience.is_infinite() || self.best().is_none() {
            return false;
        }
        let (spent_s, sweep_s) = (self.evidence.source.elapsed_s(), self.sweep_s());
        let over = spent_s > self.patience * sweep_s && spent_s > (1.0 + EXPLORED) * self.climbed_s;
        if over && !self.spared.iter().any(|s| s.starts_with(WORDS)) {
            self.spared.push(format!(
                "{WORDS} after {spent_s:.1} s, because trying everything would take some {sweep_s:.0} s: what is left may save more \
                 (`--thorough` goes on)"
            ));
        }
        over
    }

    /// Seconds for which the search would go on at most, with what it has found.
    fn patience_left_s(&mut self) -> f64 {
        if self.patience.is_infinite() {
            return f64::INFINITY;
        }
        let hope = if self.best().is_some() { 1.0 } else { HOPE };
        let whole_s = (hope * self.patience * self.sweep_s()).max((1.0 + EXPLORED) * self.climbed_s);
        whole_s - self.evidence.source.elapsed_s()
    }

    /// What precomputing settings will take, where their method knows: by as much more than it says as it last did.
    fn set_up(&mut self, row: &MethodRow, settings: &Settings) -> Option<SetUp> {
        let SetUp { whole_s, left_s } = self.evidence.source.set_up(row, settings)?;
        let off = self.misjudged.get(row.name).copied().unwrap_or(1.0);
        Some(SetUp { whole_s: off * whole_s, left_s: off * left_s })
    }

    /// Whether precomputation would surely take longer than it may.
    fn is_too_long(&self, set_up: &SetUp) -> bool {
        self.goal.precompute_ms.is_some_and(|limit| 1e3 * set_up.whole_s > MISJUDGED * limit)
    }

    /// Seconds that a finer truth may take.
    fn refining_s(&mut self) -> f64 {
        if self.patience.is_infinite() { f64::INFINITY } else { REFINING * self.sweep_s() }
    }

    /// Sets of settings and seconds that the evidence has spent.
    pub(super) fn spent(&self) -> (usize, f64) {
        (self.evidence.trials, self.evidence.truth_s)
    }

    /// Everything that was run.
    pub(super) fn tried(&self) -> &[Candidate] {
        &self.tried
    }

    /// Seconds of precomputation that trials shared.
    pub(super) fn shared_s(&self) -> f64 {
        self.evidence.shared_s
    }

    pub(super) fn reject_all(&mut self, reason: &str) {
        self.rejected =
            self.methods.iter().map(|m| Rejected { method: m.name.into(), reason: reason.into() }).collect();
    }

    /// The best settings that keep the limits; `None` where none were found.
    pub(super) fn find(&mut self) -> Result<Option<Candidate>, Error> {
        let start = |row: &&'static MethodRow| Ladder {
            row,
            next: 0,
            cost: 0.0,
            memory_bytes: 0,
            set_up_s: 0.0,
            errors: Vec::new(),
        };
        let mut open: Vec<Ladder> = self.methods.iter().map(start).collect();
        loop {
            self.climb(&mut open)?;
            self.climbed_s = self.evidence.source.elapsed_s();
            self.explore()?;
            let found = self.confirmed()?;
            // Where a closer look turned everything down there may be rungs left that were too dear before.
            if found.is_some() || open.is_empty() {
                return found.map_or_else(|| self.doubtful(), |found| Ok(Some(found)));
            }
        }
    }

    /// Steps beside what was tried, those first that promise most for the time that they take, as long as they promise
    /// something.
    fn explore(&mut self) -> Result<(), Error> {
        while let Some((row, settings)) = self.most_promising() {
            if self.is_patience_over() || self.is_given_up() {
                break;
            }
            self.run_clear(row, &settings)?;
        }
        Ok(())
    }

    /// The step that promises most for its time; `None` where none promises anything.
    fn most_promising(&mut self) -> Option<(&'static MethodRow, Settings)> {
        let (best, left_s) = (self.best(), self.patience_left_s());
        let mut most: Option<(f64, Step)> = None;
        for step in self.steps() {
            let Some(promise) = self.promise(&step, best.as_ref(), left_s) else { continue };
            if most.as_ref().is_none_or(|m| promise > m.0) {
                most = Some((promise, step));
            }
        }
        most.map(|(_, step)| (step.row, step.to))
    }

    /// Every step beside what was tried that is not known yet, and not known to change nothing.
    fn steps(&mut self) -> Vec<Step> {
        let (pairs, mut steps, mut spared) = (self.pairs(), Vec::new(), Vec::new());
        for at in &self.tried {
            let Some(row) = self.row(at.row) else { continue };
            for axis in axes(row, &at.settings) {
                for direction in [-1, 1] {
                    let Some(to) = step(&at.settings, &axis, direction) else { continue };
                    if self.is_known(row, &to) {
                        continue;
                    }
                    if let Some(words) = carries_nothing(at, &axis.key).filter(|_| direction > 0) {
                        spared.push(words);
                        continue;
                    }
                    let expected = self.expected(&pairs, at, &axis.key, &to, direction);
                    let (cost, affordable) = (self.goal.cost(at), self.goal.affords(at));
                    steps.push(Step { row, to, expected, cost, affordable, wall_s: at.wall_s });
                }
            }
        }
        spared.into_iter().for_each(|words| self.spare_step(words));
        steps
    }

    /// What a step is expected to give: what the same step did to the settings that are most like these, or little where
    /// that is not known.
    fn expected(&self, pairs: &[[usize; 2]], at: &Candidate, key: &str, to: &Settings, direction: isize) -> Expected {
        let Some((distance, effect)) = self.nearest_effect(pairs, at, key, &to[key]) else {
            let factor = if direction < 0 { 1.0 / UNKNOWN } else { UNKNOWN };
            let (cost, memory_bytes) = (factor * self.goal.cost(at), factor * at.memory_bytes as f64);
            return Expected { error: at.error, cost, memory_bytes, spread: SPREAD_UNKNOWN };
        };
        let predicted = Prediction::measured(at).with(&effect);
        let error = self.evidence.error_of(&predicted.means);
        let (cost, memory_bytes) = (predicted.cost(&self.goal), predicted.memory_bytes);
        Expected { error, cost, memory_bytes, spread: SPREAD * (1 + distance) as f64 }
    }

    /// What a step promises for each second: the probability that it is good enough, times what it would then save. `None` where
    /// that is not worth a trial, or the trial takes longer than there is patience.
    fn promise(&mut self, step: &Step, best: Option<&Candidate>, left_s: f64) -> Option<f64> {
        let Step { expected, cost, .. } = step;
        // What is too slow or too large asks for less; what is not must not become so.
        let over = |limit: Option<f64>, value: f64| limit.is_some_and(|limit| value > limit);
        let too_large = over(self.goal.memory_bytes.map(|m| m as f64), expected.memory_bytes);
        let too_much = over(self.goal.ms, expected.cost) || too_large;
        if expected.cost >= *cost && (too_much || !step.affordable) {
            return None;
        }
        let (chance, gain) = match self.goal.error {
            Some(limit) => self.saving(expected, limit, best),
            None => self.improving(expected, too_much, best),
        };
        if gain <= 0.0 || chance < LEAST_CHANCE {
            return None;
        }
        let takes_s = self.takes_s(step)?;
        // Where nothing is known to fit, hope ends by other means.
        (best.is_none() || takes_s <= left_s).then(|| chance * gain / (takes_s + LEAST_S))
    }

    /// The probability that a step keeps the error, and the part of the best's cost that it would save (a logarithm).
    fn saving(&self, expected: &Expected, limit: f64, best: Option<&Candidate>) -> (f64, f64) {
        let gain = best.map_or(1.0, |best| (SAVES * self.goal.cost(best) / expected.cost.max(1e-6)).ln());
        (logistic((limit / expected.error).ln() / expected.spread), gain)
    }

    /// The probability that a step errs less than the best does, and how much less if so (a logarithm): what is not known to be
    /// better may be by its spread.
    fn improving(&self, expected: &Expected, too_much: bool, best: Option<&Candidate>) -> (f64, f64) {
        match best {
            _ if too_much && best.is_some() => (0.0, 0.0),
            Some(best) => {
                let gain = (SAVES * best.error / expected.error.max(1e-6)).ln();
                (logistic(gain / expected.spread), gain.max(expected.spread))
            }
            None => (1.0, 1.0),
        }
    }

    /// Seconds of a step's trial; `None` where precomputation would take longer than it may.
    fn takes_s(&mut self, step: &Step) -> Option<f64> {
        let runs_s = 4e-3 * step.expected.cost;
        if self.evidence.source.is_prepared(step.row, &step.to) {
            return Some(runs_s);
        }
        match self.set_up(step.row, &step.to) {
            Some(set_up) => (!self.is_too_long(&set_up)).then_some(set_up.left_s + runs_s),
            None => Some(step.wall_s * step.expected.cost / step.cost.max(1e-6)),
        }
    }

    /// Pairs of trials of one method that differ in one setting.
    fn pairs(&self) -> Vec<[usize; 2]> {
        let all = || self.tried.iter().enumerate();
        let differ = |a: &Candidate, b: &Candidate| a.row == b.row && differences(&a.settings, &b.settings) == 1;
        all().flat_map(|(n, a)| all().filter(move |(_, b)| differ(a, b)).map(move |(k, _)| [n, k])).collect()
    }

    /// What another value of a setting did to what is most like `at`, and in how many settings that differs from it.
    fn nearest_effect(&self, pairs: &[[usize; 2]], at: &Candidate, key: &str, value: &str) -> Option<(usize, Effect)> {
        let pairs = pairs.iter().map(|pair| pair.map(|k| &self.tried[k]));
        let alike = pairs.filter(|[before, after]| {
            let has = |c: &Candidate, value: &str| c.settings.get(key).is_some_and(|v| same(v, value));
            before.row == at.row && has(after, value) && has(before, &at.settings[key])
        });
        let distance = |before: &Candidate| differences(&before.settings, &at.settings);
        let [before, after] = alike.min_by_key(|[before, _]| distance(before))?;
        Some((distance(before), Effect::between(before, after, key, &at.settings)))
    }

    fn is_known(&self, row: &MethodRow, settings: &Settings) -> bool {
        self.tried.iter().any(|c| c.row == row.name && c.settings == *settings)
            || self.refused.iter().any(|r| r.0 == row.name && r.1 == *settings)
    }

    /// Where nothing is sure to keep the limit: what most likely does, by the whole picture.
    fn doubtful(&mut self) -> Result<Option<Candidate>, Error> {
        let Some(limit) = self.goal.error else { return Ok(None) };
        loop {
            let likely = self.tried.iter().filter(|c| self.goal.affords(c) && c.error <= limit);
            let Some(likely) = likely.min_by(|a, b| a.error.total_cmp(&b.error)).cloned() else { return Ok(None) };
            let Some(row) = self.row(likely.row).filter(|_| likely.effort == Effort::Glance) else {
                return Ok(Some(likely));
            };
            let mut whole = self.evidence.try_settings(row, &likely.settings, Effort::Whole)?;
            let refining_s = self.refining_s();
            self.evidence.settle(row, &mut whole, limit, CONFIRMED_BLOCKS, refining_s)?;
            self.remember(&whole);
        }
    }

    fn row(&self, name: &str) -> Option<&'static MethodRow> {
        self.methods.iter().find(|m| m.name == name).copied()
    }

    fn fits(&self, c: &Candidate) -> bool {
        self.goal.affords(c) && self.goal.accepts(c)
    }

    /// The best of all that were tried.
    fn best(&self) -> Option<Candidate> {
        let fitting = self.tried.iter().filter(|c| self.fits(c));
        let better = |a: &&Candidate, b: &&Candidate| match self.goal.error {
            Some(_) => self.goal.cost(a).total_cmp(&self.goal.cost(b)),
            None => a.error.total_cmp(&b.error),
        };
        fitting.min_by(better).cloned()
    }

    /// Glances at settings unless they were run; `None` where the method refuses, or has refused, with the reason kept.
    fn run(&mut self, row: &'static MethodRow, settings: &Settings) -> Option<Candidate> {
        if let Some(known) = self.tried.iter().find(|c| c.row == row.name && c.settings == *settings) {
            return Some(known.clone());
        }
        if self.is_known(row, settings) {
            return None;
        }
        let estimate = self.evidence.source.set_up(row, settings);
        let evidence = &mut *self.evidence;
        let work = || evidence.try_settings(row, settings, Effort::Glance);
        let reason = match std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)) {
            Ok(Ok(candidate)) => {
                (self.news)(&candidate);
                if let Some(estimate) = estimate.filter(|e| e.whole_s > 0.0) {
                    self.misjudged.insert(row.name, candidate.precompute_ms / 1e3 / estimate.whole_s);
                }
                self.tried.push(candidate.clone());
                return Some(candidate);
            }
            Ok(Err(error)) => error.to_string(),
            Err(_) => "it crashed".into(),
        };
        self.rejected.push(Rejected { method: row.name.into(), reason });
        self.refused.push((row.name, settings.clone()));
        None
    }

    /// [`Self::run`], until it is clear on which side of the limit the error lies.
    fn run_clear(&mut self, row: &'static MethodRow, settings: &Settings) -> Result<Option<Candidate>, Error> {
        let Some(mut candidate) = self.run(row, settings) else { return Ok(None) };
        if let Some(limit) = self.goal.error {
            // What would save little more than what is known to fit is not worth a finer truth.
            let worth = self.best().is_none_or(|b| WORTH * self.goal.cost(&candidate) < self.goal.cost(&b));
            let refining_s = if worth { self.refining_s() } else { 0.0 };
            self.evidence.settle(row, &mut candidate, limit, 0, refining_s)?;
            self.remember(&candidate);
        }
        Ok(Some(candidate))
    }

    fn remember(&mut self, candidate: &Candidate) {
        match self.tried.iter_mut().find(|c| c.row == candidate.row && c.settings == candidate.settings) {
            Some(known) => *known = candidate.clone(),
            None => self.tried.push(candidate.clone()),
        }
    }

    /// All methods' ladders, cheapest first, as far as a rung can still win.
    fn climb(&mut self, open: &mut Vec<Ladder>) -> Result<(), Error> {
        let limit = self.goal.error.unwrap_or(0.0);
        let hopeless = |l: &Ladder| limit > 0.0 && l.expected().is_some_and(|e| e > limit);
        loop {
            open.retain(|l| {
                let within = self.goal.ms.is_none_or(|ms| l.cost <= ms)
                    && self.goal.memory_bytes.is_none_or(|bytes| l.memory_bytes <= bytes);
                l.next < l.row.ladder.len() && within
            });
            self.ask_set_ups(open);
            // A ladder whose last rung costs more than what fits cannot win.
            let best = self.best().filter(|_| limit > 0.0).map_or(f64::INFINITY, |b| self.goal.cost(&b));
            let spent_s = self.evidence.source.elapsed_s();
            let order = |a: &usize, b: &usize| {
                let (a, b) = (&open[*a], &open[*b]);
                // Who takes longer to ask than all so far waits for those who do not.
                let key = |l: &Ladder| (hopeless(l), l.set_up_s > spent_s);
                key(a).cmp(&key(b)).then(a.cost.total_cmp(&b.cost))
            };
            let Some(at) = (0..open.len()).filter(|k| open[*k].cost < best).min_by(order) else { return Ok(()) };
            if hopeless(&open[at]) && best.is_finite() {
                open.iter().filter(|l| l.cost < best && hopeless(l)).for_each(|l| self.spare_ladder(l));
                return Ok(());
            }
            // A step beside what comes nearest is likelier to fit than a ladder without hope.
            if hopeless(&open[at]) && !std::mem::replace(&mut self.explored, true) {
                return Ok(());
            }
            if hopeless(&open[at]) && self.is_given_up() {
                open.iter().for_each(|l| self.spare_ladder(l));
                open.clear();
                return Ok(());
            }
            if open[at].set_up_s > spent_s && self.best().is_some() && open[at].set_up_s > self.patience_left_s() {
                let ladder = open.remove(at);
                self.spare_set_up(
                    ladder.row,
                    ladder.set_up_s,
                    "longer than there is patience for, with what fits already",
                );
                continue;
            }
            let ladder = &mut open[at];
            let row = ladder.row;
            let settings = row.with(row.ladder[ladder.next].1.iter().copied())?;
            ladder.next += 1;
            let Some(candidate) = self.run_clear(row, &settings)? else { continue };
            (ladder.cost, ladder.memory_bytes) = (self.goal.cost(&candidate), candidate.memory_bytes);
            ladder.errors.push(candidate.error);
            // Less than a rung may be missing.
            if let Some(beside) = self.beside(row, &candidate)? {
                ladder.cost = self.goal.cost(&beside);
            }
            if self.goal.precompute_ms.is_some_and(|ms| candidate.precompute_ms > ms) {
                // Its further rungs take longer to prepare.
                open.remove(at);
            }
        }
    }

    /// Something that fits one step beside a rung that all but does: less to ask for, and to run, than the next rung.
    fn beside(&mut self, row: &'static MethodRow, rung: &Candidate) -> Result<Option<Candidate>, Error> {
        let misses = self.goal.affords(rung) && !self.goal.accepts(rung) && self.goal.overrun(rung) <= NARROW;
        let axes = if misses { axes(row, &rung.settings) } else { Vec::new() };
        let mut asked = 0;
        // The size is what costs most to ask for.
        for axis in axes.into_iter().skip(1) {
            let Some(settings) = step(&rung.settings, &axis, 1) else { continue };
            if asked >= BESIDE {
                break;
            }
            if let Some(words) = carries_nothing(rung, &axis.key) {
                self.spare_step(words);
                continue;
            }
            asked += 1;
            if let Some(found) = self.run_clear(row, &settings)?.filter(|c| self.fits(c)) {
                return Ok(Some(found));
            }
        }
        Ok(None)
    }

    /// Learns what the next rungs' precomputation will take, and leaves those ladders where it would surely take too long.
    fn ask_set_ups(&mut self, open: &mut Vec<Ladder>) {
        open.retain_mut(|ladder| {
            let rung = ladder.row.with(ladder.row.ladder[ladder.next].1.iter().copied());
            let Some(set_up) = rung.ok().and_then(|rung| self.set_up(ladder.row, &rung)) else { return true };
            ladder.set_up_s = set_up.left_s;
            let too_long = self.is_too_long(&set_up);
            if too_long {
                self.spare_set_up(ladder.row, set_up.whole_s, "more than it may");
            }
            !too_long
        });
    }

    fn spare_set_up(&mut self, row: &MethodRow, seconds: f64, why: &str) {
        let name = row.name;
        let reason = format!("its next rung would take about {seconds:.1} s to precompute, {why}: not tried");
        self.spared.push(format!("{name}: {reason}"));
        self.rejected.push(Rejected { method: name.into(), reason });
    }

    fn spare_ladder(&mut self, ladder: &Ladder) {
        let (Some(expected), Some(last)) = (ladder.expected(), ladder.errors.last()) else { return };
        let (name, left) = (ladder.row.name, ladder.row.ladder.len() - ladder.next);
        let reason = format!(
            "its error is {last:.3} after {} rungs; as it falls, the {left} dearer ones would leave no less than {expected:.3}: \
             not tried",
            ladder.next
        );
        self.spared.push(format!("{name}: {reason}"));
        self.rejected.push(Rejected { method: name.into(), reason });
    }

    /// Where nothing fits: the smallest error of all that time and memory allow, or of all.
    pub(super) fn closest(&self) -> Option<Candidate> {
        let least = |all: &mut dyn Iterator<Item = &Candidate>| all.min_by(|a, b| a.error.total_cmp(&b.error)).cloned();
        least(&mut self.tried.iter().filter(|c| self.goal.affords(c))).or_else(|| least(&mut self.tried.iter()))
    }

    /// Says what is not tried, and why, unless it is said already.
    fn spare_step(&mut self, words: String) {
        let step = words.split(':').next().unwrap_or_default();
        if !self.spared.iter().any(|s| s.starts_with(step)) {
            self.spared.push(words);
        }
    }

    /// The same settings at the method's smallest size, where that is much faster: where effects are learnt.
    fn cheap_base(&mut self, row: &'static MethodRow, at: &Candidate) -> Option<Candidate> {
        let size = axes(row, &at.settings).into_iter().next()?;
        let smallest = row.with(row.ladder.first()?.1.iter().copied()).ok()?;
        let value = smallest.get(&size.key)?;
        if same(value, at.settings.get(&size.key)?) {
            return None;
        }
        let settings = changed(&at.settings, &size.key, value);
        let too_slow = |c: &Candidate| c.wall_s * CHEAP > at.wall_s;
        // The smallest rung is a lower bound of what it takes.
        if self.tried.iter().any(|c| c.row == row.name && c.settings == smallest && too_slow(c)) {
            return None;
        }
        self.run(row, &settings).filter(|c| !too_slow(c))
    }

    /// What another value of a setting does, from trials that differ in it alone, or asked for at the smallest size.
    fn effect(&mut self, row: &'static MethodRow, at: &Candidate, key: &str, value: &str) -> Option<Effect> {
        if let Some(known) = self.known_effect(at, key, value) {
            return Some(known);
        }
        if self.is_patience_over() {
            return None;
        }
        let base = self.cheap_base(row, at)?;
        let other = self.run(row, &changed(&base.settings, key, value))?;
        Some(Effect::between(&base, &other, key, &at.settings))
    }

    fn known_effect(&self, at: &Candidate, key: &str, value: &str) -> Option<Effect> {
        let nearest = self.nearest_effect(&self.pairs(), at, key, value);
        nearest.filter(|(distance, _)| *distance < FAR).map(|(_, effect)| effect)
    }

    /// The best of all tried that fits, the finalists being run for the whole picture and timed again.
    fn confirmed(&mut self) -> Result<Option<Candidate>, Error> {
        loop {
            let Some(best) = self.best() else { return Ok(None) };
            let close = |c: &&Candidate| match self.goal.error {
                Some(_) => self.goal.cost(c) <= FINALISTS.0 * self.goal.cost(&best),
                None => c.settings == best.settings && c.row == best.row,
            };
            let mut finalists: Vec<Candidate> =
                self.tried.iter().filter(|c| self.fits(c)).filter(close).cloned().collect();
            finalists.sort_by(|a, b| self.goal.cost(a).total_cmp(&self.goal.cost(b)));
            finalists.truncate(FINALISTS.1);
            let unsure: Vec<Candidate> = finalists.into_iter().filter(|c| c.effort == Effort::Glance).collect();
            if unsure.is_empty() {
                return Ok(Some(best));
            }
            for glance in unsure {
                let Some(row) = self.row(glance.row) else { continue };
                let mut whole = self.evidence.try_settings(row, &glance.settings, Effort::Whole)?;
                if let Some(limit) = self.goal.error {
                    let refining_s = self.refining_s();
                    self.evidence.settle(row, &mut whole, limit, CONFIRMED_BLOCKS, refining_s)?;
                }
                self.remember(&whole);
            }
        }
    }

    /// The neighbours of every parameter's chosen value: run, or estimated where that is much faster.
    pub(super) fn why(&mut self, chosen: &Candidate) -> Vec<Reason> {
        // Reasons are asked for whatever they take.
        self.patience = f64::INFINITY;
        let Some(row) = self.row(chosen.row) else { return Vec::new() };
        let mut reasons = Vec::new();
        for (k, axis) in axes(row, &chosen.settings).into_iter().enumerate() {
            let below = self.neighbour(row, chosen, &axis, -1, k == 0);
            let above = self.neighbour(row, chosen, &axis, 1, k == 0);
            let value = chosen.settings[&axis.key].clone();
            let words =
                words::explain(&axis.key, &value, chosen, (&below, &above), beyond(chosen, &axis.key), &self.goal);
            reasons.push(Reason { key: axis.key, value, below, above, words });
        }
        reasons
    }

    fn neighbour(
        &mut self,
        row: &'static MethodRow,
        chosen: &Candidate,
        axis: &Axis,
        direction: isize,
        is_size: bool,
    ) -> Option<Neighbour> {
        let settings = step(&chosen.settings, axis, direction)?;
        let value = settings[&axis.key].clone();
        let known = self.tried.iter().any(|c| c.row == row.name && c.settings == settings);
        if let (false, false, Some(effect)) = (known, is_size, self.effect(row, chosen, &axis.key, &value)) {
            let predicted = Prediction::measured(chosen).with(&effect);
            let (error, ms) = (self.evidence.error_of(&predicted.means), predicted.cost(&self.goal));
            // What an estimate would rather have chosen is no reason: it is run.
            let doubtful = self.goal.error.is_some_and(|limit| error <= limit) && ms <= SAVES * self.goal.cost(chosen);
            if !doubtful {
                let (error, ms) = (Some(finite(error)), Some(ms));
                return Some(Neighbour { value, error, ms, estimated_at: Some(effect.learnt_at) });
            }
        }
        let ran = self.run(row, &settings);
        let (error, ms) = (ran.as_ref().map(|c| finite(c.error)), ran.as_ref().map(|c| self.goal.cost(c)));
        Some(Neighbour { value, error, ms, estimated_at: None })
    }

    /// Why the other methods were not chosen.
    pub(super) fn rejections(&self, chosen: Option<&Candidate>) -> Vec<Rejected> {
        let others = self.methods.iter().filter(|m| chosen.is_none_or(|c| c.row != m.name));
        others.map(|row| Rejected { method: row.name.into(), reason: self.rejection(row) }).collect()
    }

    fn rejection(&self, row: &MethodRow) -> String {
        let own = || self.tried.iter().filter(|c| c.row == row.name);
        let best = own().min_by(|a, b| a.error.total_cmp(&b.error));
        let refused = self.rejected.iter().rev().find(|r| r.method == row.name);
        let fits = own().filter(|c| self.fits(c)).min_by(|a, b| self.goal.cost(a).total_cmp(&self.goal.cost(b)));
        match (fits, best, refused) {
            (Some(c), _, _) => {
                format!("error {:.3} in {:.1} ms fits, but costs more than the choice", c.error, self.goal.cost(c))
            }
            (None, _, Some(r)) => r.reason.clone(),
            (None, Some(c), _) => format!(
                "its best so far has an error of {:.3} in {:.1} ms, and better rungs would cost more than the choice or the \
                 limit",
                c.error,
                self.goal.cost(c)
            ),
            (None, None, None) => "even its cheapest rung costs more".into(),
        }
    }
}

/// The next of some times, if they go on growing as the last two did.
fn grown(times: impl DoubleEndedIterator<Item = f64>) -> f64 {
    let mut last_first = times.rev();
    match (last_first.next(), last_first.next()) {
        (Some(last), Some(before)) => last * (last / before.max(1e-9)).max(1.0),
        (Some(last), None) => GROWTH * last,
        _ => 0.0,
    }
}

/// One setting changed beside something that was tried.
struct Step {
    row: &'static MethodRow,
    to: Settings,
    expected: Expected,
    /// Cost of what was tried, whether it keeps time and memory, and seconds of its trial.
    cost: f64,
    affordable: bool,
    wall_s: f64,
}

/// What a step is expected to give.
#[derive(Clone, Copy)]
struct Expected {
    error: f64,
    /// Time of a frame (ms).
    cost: f64,
    memory_bytes: f64,
    /// Spread of the logarithm of the error.
    spread: f64,
}

/// Distribution function of a normal distribution, as near as its logistic stand-in comes.
fn logistic(x: f64) -> f64 {
    1.0 / (1.0 + (-1.702 * x).exp())
}

/// Number of settings in which two sets differ.
fn differences(a: &Settings, b: &Settings) -> usize {
    a.iter().filter(|(key, value)| b.get(*key) != Some(*value)).count()
}

/// What a setting cuts off, and the part of the light that it carries, where the method knows.
fn beyond(at: &Candidate, key: &str) -> Option<(&'static str, f64)> {
    let terms = at.terms.iter().find(|t| t.key == key)?;
    Some((terms.name, terms.left_out(at.settings.get(key)?)?))
}

/// Says so where the terms beyond a setting's value carry too little to matter for the error.
fn carries_nothing(at: &Candidate, key: &str) -> Option<String> {
    let (terms, share) = beyond(at, key).filter(|(_, share)| *share < NEGLIGIBLE * at.error)?;
    let (value, share) = (&at.settings[key], words::percent(share));
    Some(format!("{} {key} {value}: all {terms} beyond it carry {share} of the light: higher values not tried", at.row))
}

/// Settings with one value changed.
fn changed(settings: &Settings, key: &str, value: &str) -> Settings {
    let mut changed = settings.clone();
    changed.insert(key.into(), value.into());
    changed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_go_on_as_they_grew() {
        assert_eq!(grown([].into_iter()), 0.0);
        assert_eq!(grown([3.0].into_iter()), GROWTH * 3.0);
        assert_eq!(grown([1.0, 2.0, 6.0].into_iter()), 18.0);
        // What falls by chance is not expected to go on falling.
        assert_eq!(grown([6.0, 2.0].into_iter()), 2.0);
    }
}
