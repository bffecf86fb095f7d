//! `report.json`, `compare.json`, the time-against-error chart and the self-contained page.
//!
//! Nothing here knows a method by name: a row is a row, and [`MethodResult::control`] marks the yardsticks. Every
//! number that a table, the chart or the page shows is in the JSON. Files appear whole or not at all.

mod chart;
mod headline;
mod json;
mod page;
mod table;
mod write;

pub(crate) use chart::colours;
pub use chart::{Chart, ChartPoint, Cost, PALETTE};
pub use headline::headline;
pub use json::{
    Camera, Comparison, Device, MemoryBytes, MethodResult, Ordered, RenderReport, TimeMs, TimeSpread, Truth,
    settings_json, to_json, version,
};
pub(crate) use page::{data_uri, document, what_error_is};
pub use table::Table;
pub(crate) use table::{bytes, milliseconds, number};
pub use write::{ERROR_RANGE, Frame, Pictures, flip_error, folder_names, tone_map, write_comparison, write_render};

use crate::image_io::ImageError;
use crate::metrics::MetricsError;

/// What can go wrong when a report is made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A file or picture.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A picture cannot be compared.
    #[error("{method}: {source}")]
    Metrics {
        /// Which method.
        method: String,
        /// Why.
        source: MetricsError,
    },
    /// Pictures and results do not belong together.
    #[error("the report does not fit its pictures: {what}")]
    Mismatch {
        /// What differs.
        what: String,
    },
    /// A number is NaN or infinite.
    #[error("the report's `{path}` is not a finite number")]
    NotFinite {
        /// Where in the JSON.
        path: String,
    },
    /// The report cannot be written as JSON.
    #[error("the report is not valid JSON: {reason}")]
    Json {
        /// serde_json's words.
        reason: String,
    },
}

/// Text for HTML and SVG, in elements and in quoted attributes.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            // Control characters are not allowed in XML.
            c if c.is_control() && !"\n\t".contains(c) => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}
