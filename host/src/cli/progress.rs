//! Progress on a terminal; nothing in a pipe.

use crate::reference::Progress;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

const STEPS: u64 = 1000;

/// A bar on standard error while a truth is traced.
pub struct TruthBar(ProgressBar);

impl TruthBar {
    /// Shows itself where standard error is a terminal.
    pub fn new(what: &str) -> Self {
        let bar = ProgressBar::new(STEPS);
        if !std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        let style =
            ProgressStyle::with_template("{prefix:>12} {bar:30} {percent:>3} %  {msg}").expect("a fixed template");
        bar.set_style(style);
        bar.set_prefix(what.to_string());
        Self(bar)
    }

    /// Shows how far it is.
    pub fn update(&self, progress: Progress) {
        self.0.set_position((progress.fraction.clamp(0.0, 1.0) * STEPS as f64) as u64);
        let left = if progress.remaining_s.is_finite() {
            format!("{:.0} s left", progress.remaining_s)
        } else {
            String::from("measuring")
        };
        let noise =
            if progress.noise.is_finite() { format!(", noise {:.2} %", progress.noise * 100.0) } else { String::new() };
        self.0.set_message(format!("{left}, {} paths per pixel{noise}", progress.spp));
    }
}

/// A bar on standard error while clusters are baked.
pub struct BakeBar(ProgressBar);

impl BakeBar {
    /// Shows itself where standard error is a terminal.
    pub fn new(clusters: usize) -> Self {
        let bar = ProgressBar::new(clusters as u64);
        if !std::io::stderr().is_terminal() {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        let style = ProgressStyle::with_template("        bake {bar:30} {pos}/{len} clusters, {eta} left");
        bar.set_style(style.expect("a fixed template"));
        Self(bar)
    }

    /// Shows how many are done.
    pub fn update(&self, done: usize) {
        self.0.set_position(done as u64);
    }
}

impl Drop for BakeBar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

impl Drop for TruthBar {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
