//! Reasons, in words.

use super::{Candidate, Goal, Neighbour};

/// `resolution 64: at 48 the error is 0.231, over the limit; 96 would change it by 4.0 %: not needed`.
pub(super) fn explain(
    key: &str,
    value: &str,
    chosen: &Candidate,
    (below, above): (&Option<Neighbour>, &Option<Neighbour>),
    beyond: Option<(&str, f64)>,
    goal: &Goal,
) -> String {
    let mut parts = Vec::new();
    if let Some(n) = below {
        let source = source(n);
        parts.push(match (n.error, n.ms) {
            (Some(e), _) if goal.error.is_some_and(|limit| e > limit) => {
                format!("at {} the error is {e:.3}{source}, over the limit", n.value)
            }
            (Some(e), Some(ms)) if ms >= 0.97 * goal.cost(chosen) => {
                format!("at {} the error is {e:.3} and the time {ms:.1} ms{source}: nothing saved", n.value)
            }
            (Some(e), Some(ms)) => format!("at {} the error is {e:.3} in {ms:.1} ms{source}", n.value),
            _ => format!("{} is refused", n.value),
        });
    } else {
        parts.push("there is no cheaper value".into());
    }
    if let Some(n) = above {
        parts.push(match (n.error, n.ms) {
            (Some(e), Some(ms)) => {
                let change = change(chosen.error, e);
                let verdict = match goal.error {
                    Some(_) => "not needed",
                    None if goal.ms.is_some_and(|limit| ms > limit) => "too slow",
                    None if e < chosen.error => "better, but not by enough",
                    None => "no better",
                };
                let (value, source) = (&n.value, source(n));
                format!("{value} {change} in {ms:.1} ms{source}: {verdict}")
            }
            _ => format!("{} is refused", n.value),
        });
    }
    if let Some((terms, share)) = beyond {
        parts.push(format!("all {terms} beyond it carry {} of the light", percent(share)));
    }
    format!("{key} {value}: {}", parts.join("; "))
}

/// `12 %`, `0.2 %`.
pub(super) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent >= 10.0 { format!("{percent:.0} %") } else { format!("{percent:.2} %") }
}

/// What happens to an error: in relation to what it was, unless that was nothing.
fn change(before: f64, after: f64) -> String {
    if before > 0.0 && after.is_finite() {
        format!("changes the error by {:+.1} %", 100.0 * (after / before - 1.0))
    } else {
        format!("has an error of {after:.3}")
    }
}

/// Where an estimate comes from.
fn source(n: &Neighbour) -> String {
    n.estimated_at.as_ref().map_or_else(String::new, |at| format!(" (estimated with {at})"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_of_nothing_has_no_percentage() {
        assert_eq!(change(0.2, 0.21), "changes the error by +5.0 %");
        assert_eq!(change(0.0, 0.0), "has an error of 0.000");
        assert_eq!(change(0.0, 0.02), "has an error of 0.020");
    }
}
