//! `index.html`: one file with everything in it, which needs no network, no library and no server.

mod sections;

use super::chart::Chart;
use super::headline::headline;
use super::{Comparison, escape};
use crate::metrics::BLOCK_PX;
use base64::Engine;
use std::fmt::Write;

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("script.js");
const SORT: &str = include_str!("sort.js");

/// A picture of the page: a PNG file's bytes and what it is.
pub(super) struct Picture {
    /// `full` or `irradiance`.
    pub layer: &'static str,
    /// `truth`, `m3` (row 3), `e3` (its error map).
    pub choice: String,
    /// Name for people.
    pub name: String,
    /// PNG file.
    pub png: Vec<u8>,
}

/// The two kinds of pictures: key, name, what their error map shows.
pub(super) const LAYERS: [(&str, &str, &str); 2] = [
    ("full", "Full picture", "FLIP: how much a person sees when flipping between method and truth"),
    ("irradiance", "Indirect irradiance", "signed relative error of the luminance of indirect irradiance"),
];

/// The whole page.
pub(super) fn page(comparison: &Comparison, pictures: &[Picture]) -> String {
    let mut html = String::new();
    let [width, height] = comparison.size;
    let scene = escape(&comparison.scene);
    let _ = write!(
        html,
        "<header>\n<p class=\"eyebrow\">Global illumination against path-traced truth</p>\n<h1>{scene}</h1>\n\
         <p class=\"lead\">{}</p>\n{}<ul class=\"facts\">\n",
        escape(&headline(comparison)),
        what_error_is()
    );
    let truth = &comparison.truth;
    let facts = [
        ("Truth", format!("{} samples per pixel, noise {:.2} %", truth.spp, 100.0 * truth.noise)),
        ("Device", format!("{} ({})", comparison.device.adapter, comparison.device.backend)),
        ("Picture", format!("{width} × {height}")),
    ];
    for (name, value) in facts {
        let _ = writeln!(html, "<li><b>{name}</b> {}</li>", escape(&value));
    }
    html += "</ul>\n</header>\n";
    sections::viewer(&mut html, comparison);
    chart(&mut html, comparison);
    sections::table(&mut html, comparison);
    sections::costs(&mut html, comparison);
    sections::gallery(&mut html, comparison, pictures);
    sections::setup(&mut html, comparison);
    sections::explanations(&mut html, comparison);
    let _ = writeln!(
        html,
        "<footer>Made by interreflect {}. Every number here is in compare.json beside this file.</footer>",
        escape(&comparison.version)
    );
    document(&format!("{}: lighting methods against path-traced truth", comparison.scene), &html, SCRIPT)
}

/// What the one number is that pages judge methods by, as a paragraph to stand before its first use or right below it.
pub(crate) fn what_error_is() -> String {
    format!(
        "<p class=\"note\">The error (block NRMSE) says how far a method's indirect light is from the path-traced truth, over \
         blocks of {BLOCK_PX} × {BLOCK_PX} pixels, as a part of the truth's average: 0 is perfect, 0.1 or 10 % is off by a tenth of \
         the average brightness; without any indirect light it would be 1 or more.</p>\n"
    )
}

/// A page that needs nothing else: its title (text), the inside of `main` (HTML), and its script; tables of class
/// `sortable` sort by a click on the buttons of their head.
pub(crate) fn document(title: &str, main: &str, script: &str) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<main>\n{main}</main>\n\
         <script>{SORT}{script}</script>\n</body>\n</html>\n",
        escape(title)
    )
}

/// A PNG file's bytes as the address of a picture.
pub(crate) fn data_uri(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", base64::engine::general_purpose::STANDARD.encode(png))
}

fn chart(html: &mut String, comparison: &Comparison) {
    let chart = Chart::from_comparison(comparison);
    let _ = write!(
        html,
        "<section aria-labelledby=\"h-chart\">\n<h2 id=\"h-chart\">Time against error</h2>\n\
         <p class=\"note\">A dot stands at the time of a frame in which the lights move; its tail ends at the time of a \
         frame in which nothing moves. Diamonds are controls. The broad line is the Pareto front: no other method is \
         both faster and closer to the truth. Below the dashed line, the truth's own noise decides.</p>\n\
         <div class=\"card chart\">\n<div class=\"wide\">{}</div>\n<div class=\"narrow\">{}</div>\n</div>\n</section>\n",
        chart.inline_svg(1130.0, 500.0, "-wide"),
        chart.inline_svg(400.0, 440.0, "-narrow"),
    );
}
