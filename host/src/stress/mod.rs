//! Where methods fail: an atlas of scene families, each with a number that grows when a method fails, a picture, and the
//! range of its parameter that is safe, found by bisection and said in a sentence.
//!
//! Every family runs every method of the table and knows none by name. What a family must know of a method it asks:
//! [`crate::methods::Method::unit`], [`crate::methods::Method::feedback_gain`], and settings by the names that methods
//! share (`bounces`, `iterations`, `order`, `aperture`, `tail`).

mod families;
mod lab;
mod page;

pub use families::{FAMILIES, Family};
pub use lab::{Effort, Lab, Measured, Session};
pub use page::page;

use crate::error::Error;
use crate::methods::Settings;
use crate::scene::Scene;
use serde::{Deserialize, Serialize};

/// Stands for a value that is not finite.
pub const NOT_FINITE: f64 = 1e30;

/// One parameter and the number there.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Sample {
    /// Value of the parameter, or the number of the case.
    pub parameter: f64,
    /// Name of the case, where the parameter is a list of cases.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub case: Option<String>,
    /// The number that grows when the method fails; [`NOT_FINITE`] for NaN and infinity.
    pub value: f64,
}

/// Which end of the parameter is dangerous.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Danger {
    /// Small values.
    Low,
    /// Large values.
    High,
    /// A list of cases without an order.
    Cases,
}

/// Where the number stays within its bound.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Safe {
    /// Wherever it was tested.
    Everywhere,
    /// Nowhere that it was tested.
    Nowhere,
    /// From this value on.
    From {
        /// The value.
        at: f64,
    },
    /// Up to this value.
    UpTo {
        /// The value.
        at: f64,
    },
    /// In some cases.
    Partly {
        /// In how many.
        safe: usize,
        /// Of how many.
        of: usize,
    },
}

/// State of an entry.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Measured.
    Measured,
    /// The method has no such thing.
    NotApplicable,
    /// The method refused or panicked.
    Broken,
}

/// One family, one method.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Entry {
    /// Key of the family: `leak`, `flicker`…
    pub family: String,
    /// What varies within the family: `light`, `object`; empty for families of one kind.
    pub variant: String,
    /// Method.
    pub method: String,
    /// Every setting.
    pub settings: Settings,
    /// State.
    pub state: State,
    /// Why it was not measured.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
    /// What the number is, as the subject of the sentence: `light through a sealed wall`.
    pub measure: String,
    /// The parameter: `wall thickness`.
    pub parameter: String,
    /// Its unit: `voxels`.
    pub unit: String,
    /// Largest safe number.
    pub bound: f64,
    /// Whether the number is a part of a whole: shown in per cent.
    pub percent: bool,
    /// Which end is dangerous.
    pub danger: Danger,
    /// Measurements by parameter.
    pub samples: Vec<Sample>,
    /// Where it is safe.
    pub safe: Safe,
    /// The same for people.
    pub sentence: String,
    /// PNG of the worst case, where there is one, and what it shows.
    #[serde(skip)]
    pub picture: Option<(Vec<u8>, String)>,
}

/// `stress.json`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Atlas {
    /// Entries by family, then method.
    pub entries: Vec<Entry>,
    /// What ran it.
    pub device: crate::report::Device,
    /// Version of this program.
    pub version: String,
}

/// What a family measures and how it is said.
#[derive(Clone, Debug)]
pub struct Question {
    /// Kind within the family.
    pub variant: &'static str,
    /// Subject of the sentence.
    pub measure: &'static str,
    /// Parameter.
    pub parameter: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Largest safe number.
    pub bound: f64,
    /// Whether the number is a part of a whole.
    pub percent: bool,
    /// Which end is dangerous.
    pub danger: Danger,
}

/// A number and, where it is the worst so far, what to show for it.
pub struct Answer {
    /// The number.
    pub value: f64,
    /// PNG and what it shows.
    pub picture: Option<(Vec<u8>, String)>,
}

impl Answer {
    /// The number, or that the method gave something that is none.
    fn value_of(&self, lab: &Lab) -> f64 {
        if lab.not_finite || !self.value.is_finite() { NOT_FINITE } else { self.value }
    }
}

impl From<f64> for Answer {
    fn from(value: f64) -> Self {
        Self { value, picture: None }
    }
}

/// What to show for an entry: the picture of the worst answer that has one, else the scene in which the method did worst.
#[derive(Default)]
struct Worst {
    shown: Option<(f64, (Vec<u8>, String))>,
    scene: Option<(f64, (Settings, Scene), String)>,
}

impl Worst {
    fn see(&mut self, lab: &Lab, value: f64, picture: Option<(Vec<u8>, String)>, at: impl Fn() -> String) {
        match (picture, &lab.last) {
            (Some(picture), _) if self.shown.as_ref().is_none_or(|s| value > s.0) => {
                self.shown = Some((value, picture))
            }
            (None, Some(last)) if self.scene.as_ref().is_none_or(|s| value > s.0) => {
                self.scene = Some((value, last.clone(), at()));
            }
            _ => {}
        }
    }

    fn picture(self, lab: &mut Lab) -> Option<(Vec<u8>, String)> {
        if let Some((_, picture)) = self.shown {
            return Some(picture);
        }
        let (_, last, at) = self.scene?;
        Some((lab.snapshot(&last)?, format!("Indirect light of the scene, as it is shown at {}.", at.trim_end())))
    }
}

impl Question {
    /// Measures at `grid` (ascending), then halves the interval in which the method begins to fail `halvings` times.
    ///
    /// # Errors
    /// What `measure` returns.
    pub fn sweep(
        &self,
        lab: &mut Lab,
        family: &str,
        grid: &[f64],
        halvings: u32,
        mut measure: impl FnMut(&mut Lab, f64) -> Result<Answer, Error>,
    ) -> Result<Entry, Error> {
        let (mut samples, mut worst) = (Vec::new(), Worst::default());
        let mut ask = |lab: &mut Lab, parameter: f64| -> Result<f64, Error> {
            lab.not_finite = false;
            let answer = measure(lab, parameter)?;
            let value = answer.value_of(lab);
            worst.see(lab, value, answer.picture, || format!("{} {} {}", self.parameter, short(parameter), self.unit));
            samples.push(Sample { parameter, case: None, value });
            Ok(value)
        };
        let (mut order, halvings) = match lab.effort {
            Effort::Full => (grid.to_vec(), halvings),
            Effort::Ends => (ends(grid), 0),
        };
        // From the safe end to the dangerous one.
        if self.danger == Danger::Low {
            order.reverse();
        }
        let (mut last_safe, mut first_bad) = (None, None);
        for &parameter in &order {
            let value = ask(lab, parameter)?;
            match value <= self.bound {
                true if first_bad.is_none() => last_safe = Some(parameter),
                true => {}
                false => first_bad = first_bad.or(Some(parameter)),
            }
        }
        if let (Some(mut good), Some(mut bad)) = (last_safe, first_bad) {
            for _ in 0..halvings {
                let middle = if good > 0.0 && bad > 0.0 { (good * bad).sqrt() } else { 0.5 * (good + bad) };
                if ask(lab, middle)? <= self.bound { good = middle } else { bad = middle }
            }
            last_safe = Some(good);
        }
        samples.sort_by(|a, b| a.parameter.total_cmp(&b.parameter));
        let safe = match (last_safe, first_bad) {
            (_, None) => Safe::Everywhere,
            (None, _) => Safe::Nowhere,
            (Some(at), _) if self.danger == Danger::Low => Safe::From { at },
            (Some(at), _) => Safe::UpTo { at },
        };
        let picture = worst.picture(lab);
        Ok(self.entry(lab, family, samples, safe, picture))
    }

    /// Measures a list of cases; a case that cannot be measured, or in which the method panics, is the worst.
    pub fn cases(
        &self,
        lab: &mut Lab,
        family: &str,
        names: &[&str],
        mut measure: impl FnMut(&mut Lab, usize) -> Result<Answer, Error>,
    ) -> Entry {
        let (mut samples, mut worst) = (Vec::new(), Worst::default());
        for (k, name) in names.iter().enumerate() {
            lab.not_finite = false;
            let answer = unwound(|| measure(lab, k)).unwrap_or_else(|words| Err(Error::Panic(words)));
            let said = answer.as_ref().err().map(|e| format!(" ({e})")).unwrap_or_default();
            let answer = answer.unwrap_or(Answer { value: NOT_FINITE, picture: None });
            let value = answer.value_of(lab);
            worst.see(lab, value, answer.picture, || (*name).to_string());
            samples.push(Sample { parameter: k as f64, case: Some(format!("{name}{said}")), value });
        }
        let good = samples.iter().filter(|s| s.value <= self.bound).count();
        let safe = match good {
            n if n == samples.len() => Safe::Everywhere,
            0 => Safe::Nowhere,
            safe => Safe::Partly { safe, of: samples.len() },
        };
        let picture = worst.picture(lab);
        self.entry(lab, family, samples, safe, picture)
    }

    /// An entry for a method that has no such thing.
    pub fn not_applicable(&self, lab: &Lab, family: &str, reason: &str) -> Entry {
        let mut entry = self.entry(lab, family, Vec::new(), Safe::Everywhere, None);
        entry.state = State::NotApplicable;
        entry.sentence = format!("{}: {reason}.", lab.row.name);
        entry.reason = Some(reason.into());
        entry
    }

    fn entry(
        &self,
        lab: &Lab,
        family: &str,
        samples: Vec<Sample>,
        safe: Safe,
        picture: Option<(Vec<u8>, String)>,
    ) -> Entry {
        let mut entry = Entry {
            family: family.into(),
            variant: self.variant.into(),
            method: lab.row.name.into(),
            settings: lab.settings.clone(),
            state: State::Measured,
            reason: None,
            measure: self.measure.into(),
            parameter: self.parameter.into(),
            unit: self.unit.into(),
            bound: self.bound,
            percent: self.percent,
            danger: self.danger,
            samples,
            safe,
            sentence: String::new(),
            picture,
        };
        entry.sentence = entry.say();
        entry
    }
}

impl Entry {
    /// The safe range as a sentence.
    fn say(&self) -> String {
        let (method, measure) = (&self.method, &self.measure);
        let bound = self.amount(self.bound);
        let place = |at: f64| match self.unit.as_str() {
            "" => format!("{} {}", self.parameter, short(at)),
            unit => format!("{} {unit} of {}", short(at), self.parameter),
        };
        let span = || match (self.samples.first(), self.samples.last()) {
            (Some(a), Some(b)) if self.unit.is_empty() => {
                format!("{} {} to {}", self.parameter, short(a.parameter), short(b.parameter))
            }
            (Some(a), Some(b)) => format!("{} to {}", short(a.parameter), place(b.parameter)),
            _ => "nothing".into(),
        };
        let worst = self.samples.iter().max_by(|a, b| a.value.total_cmp(&b.value));
        let peak = worst.map_or_else(String::new, |s| format!(" (at worst {})", self.amount(s.value)));
        if self.danger == Danger::Cases {
            let bad: Vec<String> = self
                .samples
                .iter()
                .filter(|s| s.value > self.bound)
                .map(|s| format!("{} ({})", s.case.as_deref().unwrap_or(""), self.amount(s.value)))
                .collect();
            return match bad.is_empty() {
                true => format!("{method}: {measure} stays within {bound} in all {} cases{peak}.", self.samples.len()),
                false => format!("{method}: {measure} exceeds {bound} with {}.", bad.join(", ")),
            };
        }
        match self.safe {
            Safe::Everywhere => format!("{method}: {measure} stays within {bound} from {}{peak}.", span()),
            Safe::Nowhere => format!("{method}: {measure} exceeds {bound} everywhere from {}{peak}.", span()),
            Safe::From { at } => {
                format!("{method}: {measure} exceeds {bound} below {}{}{peak}.", place(at), self.tried_next(at))
            }
            Safe::UpTo { at } => {
                format!("{method}: {measure} exceeds {bound} above {}{}{peak}.", place(at), self.tried_next(at))
            }
            Safe::Partly { safe, of } => format!("{method}: {measure} stays within {bound} in {safe} of {of} cases."),
        }
    }

    /// The nearest parameter at which the method was seen to fail, where what lies between it and the safe one is not known.
    fn tried_next(&self, safe: f64) -> String {
        /// Ratio of two parameters between which a bisection stops asking.
        const NEAR: f64 = 1.5;
        let beyond = |s: &&Sample| s.value > self.bound && (s.parameter > safe) == (self.danger == Danger::High);
        let distance = |s: &Sample| (s.parameter - safe).abs();
        let failing = self.samples.iter().filter(beyond).min_by(|a, b| distance(a).total_cmp(&distance(b)));
        match failing.map(|s| s.parameter) {
            Some(next) if next.max(safe) > NEAR * next.min(safe) => format!(", tried next: {}", short(next)),
            _ => String::new(),
        }
    }

    /// Every measured number with its parameter: `0.5: 1.2 %, 1: 0.4 %`; empty where the sentence names its cases.
    pub fn numbers(&self) -> String {
        let number = |s: &Sample| format!("{}: {}", short(s.parameter), self.amount(s.value));
        let all = if self.danger == Danger::Cases { &[] } else { self.samples.as_slice() };
        all.iter().map(number).collect::<Vec<_>>().join(", ")
    }

    /// A value of the number for people.
    pub fn amount(&self, value: f64) -> String {
        match (self.percent, value) {
            (_, v) if v >= NOT_FINITE => "no finite number".into(),
            (true, v) => format!("{} %", short(100.0 * v)),
            (false, v) => short(v),
        }
    }
}

/// The first, the middle and the last of a range.
fn ends(grid: &[f64]) -> Vec<f64> {
    let mut kept = vec![0, grid.len() / 2, grid.len().saturating_sub(1)];
    kept.dedup();
    kept.iter().filter_map(|k| grid.get(*k).copied()).collect()
}

/// About three digits.
fn short(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        v if (0.99..1.0).contains(&v) => format!("{value:.3}"),
        v if !(0.001..1e5).contains(&v) => format!("{value:.1e}"),
        v if v < 0.1 => format!("{value:.3}"),
        v if v < 10.0 => format!("{}", (value * 100.0).round() / 100.0),
        v if v < 100.0 => format!("{}", (value * 10.0).round() / 10.0),
        _ => format!("{}", value.round()),
    }
}

/// Runs families on one method. A family that fails or panics is an entry that says so.
pub fn run(lab: &mut Lab, families: &[&Family], news: &mut dyn FnMut(&Entry)) -> Vec<Entry> {
    let mut all = Vec::new();
    for family in families {
        lab.last = None;
        let entries = match unwound(|| (family.run)(lab)) {
            Ok(Ok(entries)) => entries,
            Ok(Err(error)) => vec![broken(lab, family, error.to_string())],
            Err(words) => vec![broken(lab, family, Error::Panic(words).to_string())],
        };
        entries.iter().for_each(&mut *news);
        all.extend(entries);
    }
    all
}

/// What `work` gives, or the words of its panic.
fn unwound<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)).map_err(|panic| {
        let words = panic.downcast_ref::<String>().cloned();
        words.or_else(|| panic.downcast_ref::<&str>().map(|s| s.to_string())).unwrap_or_default()
    })
}

fn broken(lab: &Lab, family: &Family, reason: String) -> Entry {
    let question = Question {
        variant: "",
        measure: family.title,
        parameter: "",
        unit: "",
        bound: 0.0,
        percent: false,
        danger: Danger::Cases,
    };
    let mut entry = question.not_applicable(lab, family.key, &reason);
    entry.state = State::Broken;
    entry
}
