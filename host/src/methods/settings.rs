//! Settings of methods: from `key=value` text to checked values.

use super::{MethodError, MethodRow, Settings};
use std::str::FromStr;

impl MethodRow {
    /// Every setting's default.
    pub fn defaults(&self) -> Settings {
        self.settings.iter().map(|s| (s.key.to_string(), s.default.to_string())).collect()
    }

    /// Defaults overridden by the given pairs.
    ///
    /// # Errors
    /// [`MethodError::UnknownSetting`] with the nearest name. Values are checked by [`MethodRow::new`].
    pub fn with<'a>(&self, changes: impl IntoIterator<Item = (&'a str, &'a str)>) -> Result<Settings, MethodError> {
        let mut settings = self.defaults();
        for (key, value) in changes {
            match settings.get_mut(key) {
                Some(slot) => *slot = value.to_string(),
                None => return Err(self.unknown(key)),
            }
        }
        Ok(settings)
    }

    fn unknown(&self, key: &str) -> MethodError {
        let names: Vec<&str> = self.settings.iter().map(|s| s.key).collect();
        MethodError::UnknownSetting {
            method: self.name,
            key: key.to_string(),
            nearest: nearest(key, names.iter().copied()).unwrap_or("none").to_string(),
            known: if names.is_empty() { "no settings".to_string() } else { names.join(", ") },
        }
    }
}

/// The candidate that is spelt most like `name`.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    candidates
        .into_iter()
        .map(|c| (strsim::jaro_winkler(&name.to_lowercase(), c), c))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, c)| c)
}

/// Parses one setting and checks it.
///
/// # Errors
/// [`MethodError::BadValue`] naming what is allowed.
pub fn parse<T: FromStr>(
    row: &MethodRow,
    settings: &Settings,
    key: &'static str,
    valid: impl Fn(&T) -> bool,
) -> Result<T, MethodError> {
    let setting = row.settings.iter().find(|s| s.key == key);
    let text = settings.get(key).map_or_else(|| setting.map_or("", |s| s.default), String::as_str);
    text.trim().parse().ok().filter(valid).ok_or_else(|| MethodError::BadValue {
        method: row.name,
        key: key.to_string(),
        value: text.to_string(),
        expected: setting.map_or("known", |s| s.allowed).to_string(),
    })
}

/// The same for a setting that may be `auto`: `None`.
///
/// # Errors
/// As [`parse`].
pub fn auto_or<T: FromStr>(
    row: &MethodRow,
    settings: &Settings,
    key: &'static str,
    valid: impl Fn(&T) -> bool,
) -> Result<Option<T>, MethodError> {
    let text: String = parse(row, settings, key, |_| true)?;
    if text == "auto" { Ok(None) } else { parse(row, settings, key, valid).map(Some) }
}

#[cfg(test)]
mod tests {
    use crate::methods::{METHODS, method};

    #[test]
    fn unknown_keys_name_the_nearest() {
        let row = method("reference").unwrap();
        let error = row.with([("sppp", "3")]).unwrap_err().to_string();
        assert!(error.contains("`sppp`") && error.contains("`spp`"), "{error}");
    }

    #[test]
    fn values_out_of_range_say_what_is_allowed() {
        let row = method("reference").unwrap();
        for bad in ["0", "-1", "many", ""] {
            let error = (row.new)(&row.with([("spp", bad)]).unwrap()).err().expect("must be refused").to_string();
            assert!(error.contains(row.settings[0].allowed), "{error}");
        }
    }

    #[test]
    fn every_method_starts_with_its_defaults_and_every_rung() {
        for row in METHODS {
            (row.new)(&row.defaults()).unwrap_or_else(|e| panic!("{}: {e}", row.name));
            for (rung, changes) in row.ladder {
                let settings = row.with(changes.iter().copied()).unwrap_or_else(|e| panic!("{} {rung}: {e}", row.name));
                (row.new)(&settings).unwrap_or_else(|e| panic!("{} {rung}: {e}", row.name));
            }
        }
    }
}
