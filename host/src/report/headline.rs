//! The sentence at the top of the page: which method came closest, and what it costs.

use super::table::{milliseconds, number};
use super::{Comparison, MethodResult};
use crate::metrics::ErrorMetrics;

/// Says which method is closest to the truth, at what time, against the best yardstick, and which is the fastest.
/// Compares `nrmse_block` and the time of a frame with moving lights; rows without an error take no part.
pub fn headline(comparison: &Comparison) -> String {
    let judged = |control: bool| {
        let rows = comparison.results.iter().filter(move |r| r.control == control);
        rows.filter_map(|r| r.error.map(|e| (r, e))).collect::<Vec<_>>()
    };
    let methods = judged(false);
    let Some(&(best, error)) = methods.iter().min_by(|a, b| a.1.nrmse_block.total_cmp(&b.1.nrmse_block)) else {
        return "No method could be compared with the truth.".into();
    };
    let yardsticks = judged(true);
    // A yardstick that is slower than the method (the truth itself) is no alternative to it.
    let rival = yardsticks
        .iter()
        .filter(|(r, _)| r.time_ms.dynamic_frame() <= best.time_ms.dynamic_frame())
        .min_by(|a, b| a.1.nrmse_block.total_cmp(&b.1.nrmse_block));
    let mut text = winner(best, &error, methods.len());
    if let Some((control, e)) = rival {
        text += &against(control, e, &error);
    }
    let fastest = methods.iter().min_by(|a, b| a.0.time_ms.dynamic_frame().total_cmp(&b.0.time_ms.dynamic_frame()));
    if let Some((fast, e)) = fastest.filter(|(r, _)| !std::ptr::eq(*r, best)) {
        let (name, ms) = (fast.title(), milliseconds(fast.time_ms.dynamic_frame()));
        text += &format!(" The fastest is {name}: {ms} at block NRMSE {}.", number(e.nrmse_block));
    }
    text
}

fn winner(best: &MethodResult, error: &ErrorMetrics, count: usize) -> String {
    let ms = milliseconds(best.time_ms.dynamic_frame());
    let block = number(error.nrmse_block);
    let name = best.title();
    let percent = 100.0 * (error.bias - 1.0);
    let bias = match percent.round() as i64 {
        0 => "as bright as the truth on average".to_string(),
        p if p > 0 => format!("{p} % too bright on average"),
        p => format!("{} % too dark on average", -p),
    };
    match count {
        1 => format!(
            "{name} lights this view with a block NRMSE of {block}, {bias}, in {ms} per frame with moving lights."
        ),
        _ => format!(
            "Of {count} candidates, {name} comes closest to the truth: block NRMSE {block}, {bias}, in {ms} per frame with \
             moving lights."
        ),
    }
}

fn against(control: &MethodResult, rival: &ErrorMetrics, error: &ErrorMetrics) -> String {
    let (name, block) = (control.title(), number(rival.nrmse_block));
    if rival.nrmse_block <= error.nrmse_block {
        return format!(" The control {name} does no worse ({block}): this view does not need more.");
    }
    let less = 100.0 * (1.0 - error.nrmse_block / rival.nrmse_block);
    format!(" That is {less:.0} % less error than the best control ({name}, {block}).")
}
