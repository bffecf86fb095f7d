//! The page's parts, from top to bottom.

use super::{LAYERS, Picture, data_uri};
use crate::image_io::{DIVERGING_ENDS, colour_of_signed, magma};
use crate::metrics::{BLOCK_PX, ErrorMetrics};
use crate::report::chart::{PALETTE, colours};
use crate::report::table::{bytes, milliseconds, number};
use crate::report::{Comparison, ERROR_RANGE, MethodResult, escape};
use serde_json::Value;
use std::fmt::Write;

/// The picture viewer. It is hidden until its script runs; the gallery below needs none.
pub fn viewer(html: &mut String, comparison: &Comparison) {
    let [width, height] = comparison.size;
    let small = if width < 480 { " small" } else { "" };
    // Small pictures are shown larger, large ones at their size, none higher than a screen.
    let shown = f64::from(width.max(720)).min(f64::from(width) / f64::from(height) * 820.0);
    let layers: String = LAYERS.iter().map(|(key, name, _)| choice("layer", key, name)).collect();
    let modes: String = [("slider", "Slider"), ("side", "Side by side")].map(|(k, n)| choice("mode", k, n)).concat();
    let _ = write!(
        html,
        "<section aria-labelledby=\"h-view\">\n<h2 id=\"h-view\">Look</h2>\n\
         <p class=\"note\">All pictures of a kind share one exposure, chosen from the truth.</p>\n\
         <div class=\"card\" id=\"viewer\" hidden>\n<div class=\"bar\">\n\
         <fieldset><legend>Picture</legend><div class=\"seg\">{layers}</div></fieldset>\n\
         <fieldset><legend>View</legend><div class=\"seg\">{modes}</div></fieldset>\n\
         <label id=\"choose-left\"><span>Left</span><select id=\"left\">{}</select></label>\n\
         <label><span id=\"right-name\">Right</span><select id=\"right\">{}</select></label>\n</div>\n\
         <div class=\"stage{small}\" id=\"stage\" style=\"--w:{shown:.0}px;--ratio:{width}/{height}\">\
         <img class=\"under\" alt=\"\" draggable=\"false\"><img class=\"over\" alt=\"\" draggable=\"false\">\
         <span class=\"tag a\"></span><span class=\"tag b\"></span><i></i>\
         <input type=\"range\" id=\"split\" min=\"0\" max=\"100\" step=\"1\" value=\"50\" \
         aria-label=\"Where the left picture ends\"></div>\n\
         <div class=\"row{small}\" id=\"side\" hidden>{}</div>\n",
        options(comparison, "truth"),
        options(comparison, &format!("m{}", best_row(comparison))),
        "<figure><img alt=\"\"><figcaption></figcaption></figure>".repeat(3),
    );
    for (layer, _, meaning) in LAYERS {
        let _ = writeln!(html, "<div class=\"scale\" data-layer=\"{layer}\" hidden>{}</div>", scale(layer, meaning));
    }
    html.push_str("</div>\n</section>\n");
}

fn choice(name: &str, value: &str, words: &str) -> String {
    let checked = if value == "full" || value == "slider" { " checked" } else { "" };
    format!("<label><input type=\"radio\" name=\"{name}\" value=\"{value}\"{checked}><span>{words}</span></label>")
}

fn options(comparison: &Comparison, selected: &str) -> String {
    let option = |value: String, name: &str| {
        let mark = if value == selected { " selected" } else { "" };
        format!("<option value=\"{value}\"{mark}>{}</option>", escape(name))
    };
    let rows = || comparison.results.iter().enumerate();
    let methods: String = rows().map(|(k, r)| option(format!("m{k}"), &r.title())).collect();
    let maps: String = rows().map(|(k, r)| option(format!("e{k}"), &format!("error of {}", r.title()))).collect();
    format!(
        "{}<optgroup label=\"Methods\">{methods}</optgroup><optgroup label=\"Error maps\">{maps}</optgroup>",
        option("truth".into(), "truth")
    )
}

/// Row of the candidate that is closest to the truth; without one, the first row.
fn best_row(comparison: &Comparison) -> usize {
    let rows = comparison.results.iter().enumerate().filter(|(_, r)| !r.control);
    let rows = rows.filter_map(|(k, r)| r.error.map(|e| (k, e.nrmse_block)));
    rows.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(k, _)| k)
}

/// A colour scale with its ends named.
fn scale(layer: &str, meaning: &str) -> String {
    const STOPS: usize = 24;
    let (flip, magma) = (layer == "full", magma());
    let stop = |k: usize| {
        let t = k as f32 / STOPS as f32;
        let [r, g, b] = if flip { magma(t) } else { colour_of_signed(2.0 * t - 1.0) };
        format!("rgb({r} {g} {b})")
    };
    let gradient = (0..=STOPS).map(stop).collect::<Vec<_>>().join(",");
    let range = (100.0 * ERROR_RANGE).round();
    let ends = if flip {
        "<span>0: none visible</span><span>0.5</span><span>1: largest</span>".to_string()
    } else {
        let [dark, bright] = DIVERGING_ENDS;
        format!("<span>−{range} % {dark}</span><span>0</span><span>+{range} % {bright}</span>")
    };
    let gray = if flip { "" } else { "; grey: no surface" };
    format!("<div style=\"background:linear-gradient(90deg,{gradient})\"></div><p>{ends}</p><p>{meaning}{gray}</p>")
}

type Column = (&'static str, &'static str, fn(&MethodResult) -> Option<f64>, fn(f64) -> String, fn(f64) -> f64);

/// Columns of the table: name, explanation, value, text, and what is best when smallest.
const COLUMNS: [Column; 9] = [
    ("block NRMSE", "error of 8×8 block means", |r| error(r, |e| Some(e.nrmse_block)), number, |v| v),
    ("NRMSE", "error of pixels", |r| error(r, |e| Some(e.nrmse)), number, |v| v),
    ("bias", "mean over the truth's mean", |r| error(r, |e| Some(e.bias)), number, |v| (v - 1.0).abs()),
    ("p95", "95th percentile of the relative error", |r| error(r, |e| Some(e.p95)), number, |v| v),
    ("FLIP", "visible difference of the full picture", |r| error(r, |e| e.flip), number, |v| v),
    ("precompute", "once per geometry", |r| Some(r.time_ms.precompute), milliseconds, |v| v),
    ("light change", "when lights move", |r| Some(r.time_ms.light_change), milliseconds, |v| v),
    ("frame", "every frame", |r| Some(r.time_ms.frame), milliseconds, |v| v),
    ("memory", "device buffers", |r| Some(r.memory_bytes.total as f64), |v| bytes(v as u64), |v| v),
];

fn error(result: &MethodResult, get: fn(&ErrorMetrics) -> Option<f64>) -> Option<f64> {
    result.error.as_ref().and_then(get)
}

/// The sortable table of all results.
pub fn table(html: &mut String, comparison: &Comparison) {
    html.push_str(
        "<section aria-labelledby=\"h-table\">\n<h2 id=\"h-table\">Numbers</h2>\n\
         <p class=\"note\">Errors of indirect irradiance at the visible points; FLIP of the full picture. Bold: the best \
         candidate of a column. Click a column to sort.</p>\n\
         <div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Results\">\n<table class=\"sortable\">\n\
         <thead><tr><th scope=\"col\"><button>method</button></th>",
    );
    for (name, help, ..) in COLUMNS {
        let _ = write!(html, "<th scope=\"col\" title=\"{help}\"><button>{name}</button></th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    let best = COLUMNS.map(|(_, _, get, _, badness)| {
        let candidates = comparison.results.iter().filter(|r| !r.control).filter_map(get);
        candidates.map(badness).min_by(f64::total_cmp)
    });
    for result in &comparison.results {
        let title = escape(&result.title());
        let _ = write!(html, "<tr><th scope=\"row\" data-v=\"{title}\">{}</th>", name_with_key(comparison, result));
        for ((_, _, get, show, badness), best) in COLUMNS.into_iter().zip(best) {
            match get(result) {
                Some(value) => {
                    let class = if !result.control && Some(badness(value)) == best { " class=\"best\"" } else { "" };
                    let _ = write!(html, "<td data-v=\"{value}\"{class}>{}</td>", escape(&show(value)));
                }
                None => html.push_str("<td>–</td>"),
            }
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n");
    if let Some(floor) = comparison.truth.noise_floor {
        let (block, pixel) = (number(floor.nrmse_block), number(floor.nrmse));
        let _ = writeln!(
            html,
            "<tfoot><tr><th scope=\"row\">noise of the truth</th><td>{block}</td><td>{pixel}</td><td colspan=\"7\"></td></tr></tfoot>"
        );
    }
    html.push_str("</table>\n</div>\n</section>\n");
}

/// A method's name behind its mark from the chart.
fn name_with_key(comparison: &Comparison, result: &MethodResult) -> String {
    let colours = colours(comparison.results.iter().filter(|r| r.error.is_some()).map(|r| r.method.as_str()));
    let colour = colours.iter().find(|(s, _)| *s == result.method).map_or(PALETTE[PALETTE.len() - 1], |(_, c)| c);
    let (class, badge) =
        if result.control { ("key control", "<span class=\"badge\">control</span>") } else { ("key", "") };
    format!("<span class=\"{class}\" style=\"--c:{colour}\"></span>{}{badge}", escape(&result.title()))
}

/// One card per method: times by stage, memory by buffer, settings.
pub fn costs(html: &mut String, comparison: &Comparison) {
    html.push_str(
        "<section aria-labelledby=\"h-costs\">\n<h2 id=\"h-costs\">Where time and memory go</h2>\n\
         <p class=\"note\">Bars are relative to the largest of their list.</p>\n<p class=\"phases\">\
         <span class=\"precompute\">once per geometry</span><span class=\"light_change\">when lights move</span>\
         <span class=\"frame\">every frame</span></p>\n<div class=\"cards\">\n",
    );
    for result in &comparison.results {
        let _ = writeln!(html, "<article class=\"card\"><h3>{}</h3>", name_with_key(comparison, result));
        if !result.summary.is_empty() {
            let _ = writeln!(html, "<p class=\"note\">{}</p>", escape(&result.summary));
        }
        let t = &result.time_ms;
        let total = milliseconds(t.precompute + t.dynamic_frame());
        let stages: Vec<_> = t
            .stages
            .iter()
            .map(|(name, ms)| (name, *ms, milliseconds(*ms), t.stage_phases.get(name).map_or("", |p| p.key())))
            .collect();
        bars(html, "Time by stage", &total, &stages);
        let m = &result.memory_bytes;
        let buffers: Vec<_> = m.buffers.iter().map(|(name, b)| (name, *b as f64, bytes(*b), "")).collect();
        bars(html, "Memory by buffer", &bytes(m.total), &buffers);
        pairs(html, "Settings", result.settings.iter().map(|(k, v)| (k.as_str(), v)));
        pairs(
            html,
            "Decided by the method",
            result.needs.as_object().into_iter().flatten().map(|(k, v)| (k.as_str(), v)),
        );
        html.push_str("</article>\n");
    }
    html.push_str("</div>\n</section>\n");
}

fn bars(html: &mut String, name: &str, total: &str, rows: &[(&str, f64, String, &str)]) {
    let _ = writeln!(html, "<h4><span>{name}</span><span>{}</span></h4>", escape(total));
    let largest = rows.iter().map(|r| r.1).fold(0.0, f64::max);
    if largest == 0.0 {
        return;
    }
    html.push_str("<dl class=\"bars\">");
    for (label, value, words, class) in rows {
        let zero = if *value == 0.0 { " zero" } else { "" };
        let _ = write!(
            html,
            "<dt title=\"{0}\">{0}</dt><dd class=\"b {class}{zero}\" style=\"--v:{1:.1}%\"></dd><dd>{2}</dd>",
            escape(label),
            100.0 * value / largest,
            escape(words)
        );
    }
    html.push_str("</dl>\n");
}

fn pairs<'a>(html: &mut String, name: &str, pairs: impl Iterator<Item = (&'a str, &'a Value)>) {
    let show = |v: &Value| v.as_str().map_or_else(|| v.to_string(), String::from);
    let words: Vec<_> = pairs.map(|(k, v)| format!("<code>{} = {}</code>", escape(k), escape(&show(v)))).collect();
    if !words.is_empty() {
        let _ = writeln!(html, "<h4>{name}</h4><p class=\"note\">{}</p>", words.join(" · "));
    }
}

/// Every picture once, as data in the page; the viewer takes its pictures from here.
pub fn gallery(html: &mut String, comparison: &Comparison, pictures: &[Picture]) {
    let small = if comparison.size[0] < 480 { " class=\"small\"" } else { "" };
    html.push_str("<section aria-labelledby=\"h-all\">\n<h2 id=\"h-all\">All pictures</h2>\n<div class=\"gallery\">\n");
    for (layer, name, meaning) in LAYERS {
        for (maps, title) in [(false, name.to_string()), (true, format!("{name}: error maps"))] {
            let _ = write!(html, "<div><h3>{title}</h3><div class=\"row\">");
            for p in pictures.iter().filter(|p| p.layer == layer && p.choice.starts_with('e') == maps) {
                let _ = write!(
                    html,
                    "<figure><img{small} id=\"{layer}-{}\" data-name=\"{1}\" alt=\"{name}, {1}\" \
                     src=\"{2}\"><figcaption>{1}</figcaption></figure>",
                    p.choice,
                    escape(&p.name),
                    data_uri(&p.png)
                );
            }
            let _ = write!(html, "</div>");
            if maps {
                let _ = write!(html, "<div class=\"scale\">{}</div>", scale(layer, meaning));
            }
            html.push_str("</div>\n");
        }
    }
    html.push_str("</div>\n</section>\n");
}

/// What is needed to do it again: scene, camera, device, truth, tone map, notes.
pub fn setup(html: &mut String, comparison: &Comparison) {
    let (camera, device, truth) = (&comparison.camera, &comparison.device, &comparison.truth);
    let vector = |v: [f64; 3]| v.map(|x| format!("{x:.3}")).join(", ");
    let mut rows = vec![
        ("scene", comparison.scene.clone()),
        (
            "camera",
            format!(
                "{}: at ({}), looking along ({}), {:.1}° vertical field of view",
                camera.name,
                vector(camera.position),
                vector(camera.forward),
                camera.fovy_deg
            ),
        ),
        ("picture", format!("{} × {} pixels", comparison.size[0], comparison.size[1])),
        (
            "truth",
            format!(
                "path tracing, {} samples per pixel, relative noise {:.2} %, {}",
                truth.spp,
                100.0 * truth.noise,
                milliseconds(truth.ms)
            ),
        ),
        ("device", format!("{}, {} ({})", device.adapter, device.driver, device.backend)),
        ("processor", device.cpu.clone()),
        ("tone map", comparison.tone_map.clone()),
    ];
    if comparison.peak_memory_bytes > 0 {
        rows.push(("peak memory", bytes(comparison.peak_memory_bytes)));
    }
    rows.extend(comparison.notes.iter().map(|note| ("note on the scene", note.clone())));
    html.push_str(
        "<section aria-labelledby=\"h-setup\">\n<h2 id=\"h-setup\">Set-up</h2>\n<p></p>\n<div class=\"card\"><dl class=\"setup\">\n",
    );
    for (name, value) in rows.iter().filter(|(_, value)| !value.is_empty()) {
        let _ = writeln!(html, "<dt>{name}</dt><dd>{}</dd>", escape(value));
    }
    html.push_str("</dl></div>\n</section>\n");
}

/// What each number means.
pub fn explanations(html: &mut String, comparison: &Comparison) {
    let spp = comparison.truth.spp;
    let entries = [
        (
            "Indirect irradiance",
            "Light that arrives at a visible point after at least one reflection, in W/m², before the surface's own \
             colour is multiplied in. Comparing it rather than the picture keeps textures from hiding errors."
                .to_string(),
        ),
        (
            "NRMSE and block NRMSE",
            format!(
                "Root mean square error over all visible points and colour channels, divided by the truth's mean: 0 is \
                 perfect, 0.1 is an error of 10 % of the average brightness. Block NRMSE is the same on means over \
                 {BLOCK_PX} × {BLOCK_PX} pixels: noise averages out, light in the wrong place stays."
            ),
        ),
        (
            "Bias",
            "Mean of the method divided by mean of the truth. 1 is right on average, 1.1 is 10 % too bright.".to_string(),
        ),
        (
            "p95",
            "95 % of the visible points have a smaller relative error than this. The denominator is at least 1 % of the \
             truth's mean."
                .to_string(),
        ),
        (
            "FLIP",
            "What a person notices when the tone-mapped pictures are flipped on a screen, 0 to 1 (Andersson et al. 2020), \
             at 67 pixels per degree of the visual field; here the mean over the picture."
                .to_string(),
        ),
        (
            "Times",
            "Medians after warm-up. Precompute runs once per geometry, light change whenever lights or materials change, \
             frame every frame. A frame with moving lights costs light change plus frame."
                .to_string(),
        ),
        (
            "Truth and its noise",
            format!(
                "An unbiased path tracer that shares no kernel with the methods, {spp} samples per pixel. Its remaining \
                 noise would give a perfect method the error shown as noise of the truth; differences below that mean \
                 nothing."
            ),
        ),
        (
            "Controls",
            "Yardsticks rather than candidates: for example no indirect light at all, or a constant fitted to the truth. \
             A method that does not beat them is not worth its time here."
                .to_string(),
        ),
    ];
    html.push_str(
        "<section aria-labelledby=\"h-words\">\n<h2 id=\"h-words\">What the numbers mean</h2>\n<p></p>\n<div class=\"card\">\n",
    );
    for (name, words) in entries {
        let _ = writeln!(html, "<details><summary>{name}</summary><p>{words}</p></details>");
    }
    html.push_str("</div>\n</section>\n");
}
