//! `report.json`, `compare.json`, the time-against-error chart and the self-contained page.
