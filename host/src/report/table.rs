//! The table that `compare` prints, and how numbers are written for people.

use super::{Comparison, MethodResult};
use std::fmt;

/// Prints a comparison as aligned columns: `println!("{}", Table(&comparison))`.
pub struct Table<'a>(pub &'a Comparison);

const HEADER: [&str; 10] =
    ["method", "nrmse", "nrmse_block", "bias", "p95", "flip", "precompute", "light change", "frame", "memory"];

impl fmt::Display for Table<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let header = HEADER.map(String::from);
        let rows: Vec<_> = std::iter::once(header).chain(self.0.results.iter().map(cells)).collect();
        let widths: [usize; 10] =
            std::array::from_fn(|c| rows.iter().map(|r| r[c].chars().count()).max().unwrap_or_default());
        for (k, row) in rows.iter().enumerate() {
            let line: Vec<String> = row.iter().enumerate().map(|(c, cell)| align(cell, c, widths[c])).collect();
            writeln!(f, "{}", line.join("  ").trim_end())?;
            if k == 0 {
                writeln!(f, "{}", "-".repeat(widths.iter().sum::<usize>() + 2 * (widths.len() - 1)))?;
            }
        }
        if let Some(floor) = self.0.truth.noise_floor {
            let (pixel, block) = (number(floor.nrmse), number(floor.nrmse_block));
            writeln!(f, "the truth's own noise: nrmse {pixel}, nrmse_block {block} ({} spp)", self.0.truth.spp)?;
        }
        Ok(())
    }
}

fn align(cell: &str, column: usize, width: usize) -> String {
    if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") }
}

fn cells(result: &MethodResult) -> [String; 10] {
    let error = |get: fn(&crate::metrics::ErrorMetrics) -> Option<f64>| {
        result.error.as_ref().and_then(get).map_or_else(|| "-".to_string(), number)
    };
    [
        result.title(),
        error(|e| Some(e.nrmse)),
        error(|e| Some(e.nrmse_block)),
        error(|e| Some(e.bias)),
        error(|e| Some(e.p95)),
        error(|e| e.flip),
        milliseconds(result.time_ms.precompute),
        milliseconds(result.time_ms.light_change),
        milliseconds(result.time_ms.frame),
        bytes(result.memory_bytes.total),
    ]
}

/// An error or ratio with three decimals, more where they say nothing.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else if value.abs() < 0.001 {
        format!("{value:.1e}")
    } else if value.abs() < 100.0 {
        format!("{value:.3}")
    } else {
        format!("{value:.0}")
    }
}

/// A time with its unit and about three digits.
pub(crate) fn milliseconds(ms: f64) -> String {
    match ms {
        0.0 => "0 ms".into(),
        _ if ms < 0.001 => "<0.001 ms".into(),
        _ if ms < 1.0 => format!("{ms:.3} ms"),
        _ if ms < 100.0 => format!("{} ms", digits(ms)),
        _ if ms < 1000.0 => format!("{ms:.0} ms"),
        _ if ms < 100_000.0 => format!("{} s", digits(ms / 1000.0)),
        _ => format!("{:.1} min", ms / 60_000.0),
    }
}

/// A size with its binary unit.
pub(crate) fn bytes(bytes: u64) -> String {
    const UNITS: [&str; 4] = ["B", "KiB", "MiB", "GiB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1024.0 && unit + 1 < UNITS.len() {
        value /= 1024.0;
        unit += 1;
    }
    if unit == 0 { format!("{bytes} B") } else { format!("{} {}", digits(value), UNITS[unit]) }
}

/// Three significant digits of a number in 1…1024.
fn digits(value: f64) -> String {
    let decimals = if value < 10.0 {
        2
    } else if value < 100.0 {
        1
    } else {
        0
    };
    format!("{value:.decimals$}")
}
