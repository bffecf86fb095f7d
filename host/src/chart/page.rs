//! `index.html` of a chart: which method to use, the charts, the pictures behind their points, every number.

use super::output::chart;
use super::{ChartReport, Charted, Row, SceneChart};
use crate::error::Error;
use crate::image_io::{Image, ImageError, Rgb8, ToneMap, error_map, png_bytes};
use crate::methods::METHODS;
use crate::metrics::{self, RELATIVE_GUARD};
use crate::report::{
    Chart, Cost, ERROR_RANGE, PALETTE, bytes, colours, data_uri, document, escape, milliseconds, number, what_error_is,
};
use std::fmt::Write;

/// Errors that the advice asks for.
const TARGETS: [f64; 5] = [0.5, 0.3, 0.2, 0.1, 0.05];
/// Frame times that the advice asks for (ms) and their names.
const BUDGETS: [(f64, &str); 4] = [
    (1000.0 / 60.0, "60 frames per second"),
    (1000.0 / 30.0, "30 frames per second"),
    (100.0, "0.1 s"),
    (1000.0, "1 s"),
];
/// Widest picture on the page (px); the charts' pictures are small anyway.
const PICTURE_PX: u32 = 320;
const SCRIPT: &str = include_str!("page.js");

/// The whole page.
pub fn page(report: &ChartReport, charted: &[Charted]) -> Result<String, Error> {
    let mut html = String::new();
    let scenes: Vec<&str> = report.scenes.iter().map(SceneChart::short_name).collect();
    let _ = write!(
        html,
        "<header>\n<p class=\"eyebrow\">Speed against accuracy</p>\n<h1>Which lighting method is good enough here, and what \
         does it cost?</h1>\n<p class=\"lead\">Every method with every set of its parameters, measured on the same points \
         of the same scene against path-traced truth. {}</p>\n{}<ul class=\"facts\">\n",
        escape(&first_advice(report)),
        what_error_is()
    );
    let mut facts = vec![("Scenes", scenes.join(", "))];
    if let Some(device) = &report.device {
        facts.push(("Device", format!("{} ({})", device.adapter, device.backend)));
    }
    let [w, h] = report.scenes.first().map_or([0, 0], |s| s.size);
    facts.push(("Pictures", format!("{w} × {h}")));
    for (name, value) in facts {
        let _ = writeln!(html, "<li><b>{name}</b> {}</li>", escape(&value));
    }
    html += "</ul>\n</header>\n";
    methods(&mut html, report);
    for (s, (scene, made)) in report.scenes.iter().zip(charted).enumerate() {
        section(&mut html, s, scene, made)?;
    }
    explanations(&mut html);
    let _ = writeln!(
        html,
        "<footer>Made by interreflect {}. Every number here is in chart.json and chart.csv beside this file.</footer>",
        escape(&report.version)
    );
    Ok(document("Speed against accuracy", &html, SCRIPT))
}

/// Error over the smallest up to which a faster rung is the better advice.
const AS_GOOD: f64 = 1.5;

/// The sentences at the top, from the first scene that has a ranked candidate: what is fast for what it gives, and what comes
/// closest.
fn first_advice(report: &ChartReport) -> String {
    for scene in &report.scenes {
        let Some((closest, slow_ms, least)) = candidates(scene).min_by(|a, b| a.2.total_cmp(&b.2)) else { continue };
        let near = candidates(scene).filter(|c| c.2 <= AS_GOOD * least);
        let Some((row, ms, error)) = near.min_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
        let pt = row.path_tracing_ms.map_or_else(String::new, |t| {
            let ratio = t / ms.max(1e-6);
            if ratio >= 1.0 {
                format!("; plain path tracing takes {ratio:.1} times as long for that error")
            } else {
                format!("; plain path tracing reaches that error {:.1} times as fast", 1.0 / ratio)
            }
        });
        let mut text = format!(
            "On {}, begin with {}: an error of {} in {} per frame with moving lights{pt}.",
            scene.short_name(),
            row.title(),
            percent(error),
            milliseconds(ms)
        );
        if closest.title() != row.title() {
            let (title, time) = (closest.title(), milliseconds(slow_ms));
            text += &format!(" {title} comes closest to the truth: {} in {time}.", percent(least));
        }
        return text;
    }
    "No candidate could be ranked.".into()
}

/// Ranked candidates with time (ms) and error.
fn candidates(scene: &SceneChart) -> impl Iterator<Item = (&Row, f64, f64)> {
    scene.rows.iter().filter(|r| !r.control && !r.under_noise).filter_map(|r| Some((r, r.dynamic_ms()?, r.error()?)))
}

fn section(html: &mut String, s: usize, scene: &SceneChart, made: &Charted) -> Result<(), Error> {
    let name = escape(scene.short_name());
    let _ = write!(
        html,
        "<section aria-labelledby=\"scene-{s}\">\n<h2 id=\"scene-{s}\" class=\"scene\">{name}</h2>\n\
         <p class=\"note\">Camera {}, truth of {} samples per pixel.</p>\n",
        escape(&scene.camera.name),
        scene.truth.spp
    );
    advice(html, scene);
    let link = format!("s{s}-p");
    for (cost, title, note) in [
        (
            Cost::Time,
            "Time against error",
            "A dot stands at the time of a frame in which the lights move, its tail ends at the time of a frame in which \
             nothing moves, the pale bar shows the fastest and slowest run. Diamonds are controls. The broad line is the \
             Pareto front: nothing else is both faster and closer to the truth. The long dashes are plain path tracing: \
             below and left of them a method is worth having. Hollow dots lie within the truth's noise and are not \
             ranked. Click a dot for its picture.",
        ),
        (Cost::Memory, "Memory against error", "Memory of the method's own buffers."),
    ] {
        let c: Chart = chart(scene, cost, &link);
        let id = format!("{}{s}", if cost == Cost::Time { "t" } else { "m" });
        let _ = write!(
            html,
            "<h3>{title}</h3>\n<p class=\"note\">{note}</p>\n<div class=\"card chart\">\n<div class=\"wide\">{}</div>\n\
             <div class=\"narrow\">{}</div>\n</div>\n",
            c.inline_svg(1130.0, 500.0, &format!("-{id}w")),
            c.inline_svg(400.0, 440.0, &format!("-{id}n")),
        );
    }
    pictures(html, s, scene, made)?;
    table(html, s, scene);
    if !scene.notes.is_empty() {
        let _ = writeln!(html, "<p class=\"note\">{}</p>", escape(&scene.notes.join(" ")));
    }
    html.push_str("</section>\n");
    Ok(())
}

/// An error for people.
fn percent(error: f64) -> String {
    match 100.0 * error {
        e if e < 9.95 => format!("{e:.1} %"),
        e => format!("{e:.0} %"),
    }
}

/// From the least to the largest of what rows measured, each in words; one where they read the same.
fn span(values: impl Iterator<Item = f64>, words: impl Fn(f64) -> String) -> String {
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(l, h), v| (l.min(v), h.max(v)));
    match (words(low), words(high)) {
        (low, high) if low == high => low,
        (low, high) => format!("{low} to {high}"),
    }
}

/// A card for every candidate: what it is, in the words of the methods' table, and what it did on each scene.
fn methods(html: &mut String, report: &ChartReport) {
    let mut names: Vec<&str> = Vec::new();
    for row in report.scenes.iter().flat_map(|s| &s.rows).filter(|r| !r.control) {
        if !names.contains(&row.method.as_str()) {
            names.push(&row.method);
        }
    }
    let known: Vec<_> = names.iter().filter_map(|n| METHODS.iter().find(|m| m.name == *n)).collect();
    if known.is_empty() {
        return;
    }
    html.push_str(
        "<section aria-labelledby=\"h-methods\">\n<h2 id=\"h-methods\">The methods in short</h2>\n<p class=\"note\">From each \
         method's cheapest set of parameters to its best.</p>\n<div class=\"cards\">\n",
    );
    for method in known {
        let _ = write!(
            html,
            "<div class=\"card\"><h3>{}</h3>\n<p>{}</p>\n<p class=\"note\"><b>Good when:</b> {}<br><b>Fails when:</b> {}</p>\n",
            escape(method.name),
            escape(method.summary),
            escape(&lower_first(method.good_when)),
            escape(&lower_first(method.fails_when))
        );
        for scene in &report.scenes {
            let done = || scene.rows.iter().filter(|r| r.method == method.name && r.result.is_some());
            let _ = match done().next() {
                None => writeln!(html, "<p><b>{}</b>: not measured</p>", escape(scene.short_name())),
                Some(_) => writeln!(
                    html,
                    "<p><b>{}</b>: error {}, {} per frame with moving lights, {} once per geometry</p>",
                    escape(scene.short_name()),
                    span(done().filter_map(Row::error), percent),
                    span(done().filter_map(Row::dynamic_ms), milliseconds),
                    span(done().filter_map(|r| Some(r.result.as_ref()?.time_ms.precompute)), milliseconds)
                ),
            };
        }
        html.push_str("</div>\n");
    }
    html.push_str("</div>\n</section>\n");
}

fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |c| c.to_lowercase().collect::<String>() + letters.as_str())
}

/// What to use for an error or for a frame time.
fn advice(html: &mut String, scene: &SceneChart) {
    let describe = |row: &Row, ms: f64, error: f64| {
        let memory = row.result.as_ref().map_or(0, |r| r.memory_bytes.total);
        // Whoever bakes must know that it takes its time.
        let precompute = row.result.as_ref().map_or(0.0, |r| r.time_ms.precompute);
        let baked =
            if precompute > ms { format!("; {} once per geometry", milliseconds(precompute)) } else { "".into() };
        format!(
            "<b>{}</b> {}<br><span class=\"mute\">error {}, {} per frame, {}{baked}</span>",
            escape(&row.method),
            escape(&row.rung),
            percent(error),
            milliseconds(ms),
            bytes(memory)
        )
    };
    let mut errors = String::new();
    for target in TARGETS {
        let best = candidates(scene).filter(|c| c.2 <= target).min_by(|a, b| a.1.total_cmp(&b.1));
        let control = scene.rows.iter().filter(|r| r.control).filter_map(|r| Some((r, r.dynamic_ms()?, r.error()?)));
        let simplest = control.filter(|c| c.2 <= target).min_by(|a, b| a.1.total_cmp(&b.1));
        let paths = scene.path_tracing.map(|p| p.ms_for(target));
        let mut words = match best {
            Some((row, ms, error)) => describe(row, ms, error),
            None => "no rung of any method".into(),
        };
        if let Some((row, ms, _)) = simplest.filter(|c| best.is_none_or(|b| c.1 < b.1)) {
            let _ = write!(words, "<br>the control {} is enough, in {}", escape(&row.title()), milliseconds(ms));
        } else if let Some(ms) = paths.filter(|ms| best.is_none_or(|b| *ms < b.1)) {
            let _ = write!(words, "<br>plain path tracing is faster here: {}", milliseconds(ms));
        }
        let _ =
            writeln!(errors, "<tr><th scope=\"row\">at most {:.0}&nbsp;%</th><td>{words}</td></tr>", 100.0 * target);
    }
    let mut times = String::new();
    for (limit, name) in BUDGETS {
        let best = candidates(scene).filter(|c| c.1 <= limit).min_by(|a, b| a.2.total_cmp(&b.2));
        let words = best.map_or_else(|| "nothing is that fast here".into(), |(row, ms, e)| describe(row, ms, e));
        let _ = writeln!(times, "<tr><th scope=\"row\">{name}</th><td>{words}</td></tr>");
    }
    let _ = write!(
        html,
        "<div class=\"row advice\">\n<div class=\"card\"><h3>The cheapest for an error</h3><table>{errors}</table></div>\n\
         <div class=\"card\"><h3>The best for a frame time</h3><table>{times}</table></div>\n</div>\n\
         <p class=\"note\">Error: block NRMSE of indirect light. Time: a frame in which lights move.</p>\n"
    );
}

fn png(picture: &Rgb8) -> Result<String, Error> {
    let (width, height) = picture.dimensions();
    let encoded = if width > PICTURE_PX {
        let rows = (u64::from(height) * u64::from(PICTURE_PX) / u64::from(width)).max(1) as u32;
        png_bytes(&image::imageops::resize(picture, PICTURE_PX, rows, image::imageops::FilterType::Triangle))
    } else {
        png_bytes(picture)
    };
    Ok(data_uri(&encoded.map_err(|reason| ImageError::Encode { path: "index.html".into(), reason })?))
}

/// The picture and the error map behind each point; the script shows the chosen one beside the truth.
fn pictures(html: &mut String, s: usize, scene: &SceneChart, made: &Charted) -> Result<(), Error> {
    let judge = &made.judge;
    let guard = metrics::truth_mean(&judge.truth.irradiance, &judge.visible).unwrap_or(0.0) * RELATIVE_GUARD;
    let tone = ToneMap::from_truth(&judge.truth.irradiance, &judge.visible);
    let small = if scene.size[0] < 480 { " class=\"small\"" } else { "" };
    let _ = write!(
        html,
        "<h3>Pictures</h3>\n<p class=\"note\">Left the picture, in the middle indirect light alone, right its error: blue \
         too dark, red too bright, ±{:.0} % at the ends. All share the truth's exposure.</p>\n<div class=\"pictures\">\n",
        100.0 * ERROR_RANGE
    );
    let figure = |id: &str, name: &str, words: &str, images: [Option<String>; 3]| {
        let images: String = images
            .into_iter()
            .zip(["picture", "indirect light", "error"])
            .filter_map(|(data, what)| {
                let data = data?;
                Some(format!("<img{small} loading=\"lazy\" alt=\"{what} of {name}\" src=\"{data}\">"))
            })
            .collect();
        format!(
            "<figure class=\"card\" id=\"{id}\"><figcaption><b>{name}</b> {words}</figcaption><div class=\"three\">{images}</div></figure>\n"
        )
    };
    let truth =
        [Some(png(&judge.tone_map.apply(&judge.truth.full))?), Some(png(&tone.apply(&judge.truth.irradiance))?), None];
    *html += &figure(&format!("s{s}-truth"), "truth", "path traced", truth);
    // What can be chosen before the yardsticks.
    let mut rows: Vec<_> = scene.rows.iter().zip(&made.pictures).enumerate().collect();
    rows.sort_by_key(|(_, (row, _))| row.control);
    for (k, (row, irradiance)) in rows {
        let (Some(irradiance), Some(ms)) = (irradiance, row.dynamic_ms()) else { continue };
        let error = row.error().map_or_else(|| "no error".into(), |e| format!("block NRMSE {}", number(e)));
        let words = format!("{}: {error}, {}", escape(&row.rung), milliseconds(ms));
        let images = [
            Some(png(&judge.tone_map.apply(&judge.frame(irradiance).full))?),
            Some(png(&tone.apply(irradiance))?),
            Some(png(&error_of(judge, irradiance, guard))?),
        ];
        *html += &figure(&format!("s{s}-p{k}"), &escape(&row.method), &words, images);
    }
    html.push_str("</div>\n");
    Ok(())
}

fn error_of(judge: &super::Judge, irradiance: &Image, guard: f64) -> Rgb8 {
    error_map(&judge.truth.irradiance, irradiance, &judge.visible, guard as f32, ERROR_RANGE)
}

const COLUMNS: [(&str, &str); 13] = [
    ("rung", "name of the set of parameters"),
    ("state", "what became of it"),
    ("block NRMSE", "error of 8×8 block means"),
    ("NRMSE", "error of pixels"),
    ("bias", "mean over the truth's mean"),
    ("p95", "95th percentile of the relative error"),
    ("FLIP", "visible difference of the full picture"),
    ("precompute", "once per geometry"),
    ("light change", "when lights move: median"),
    ("frame", "every frame: median"),
    ("spread", "slowest over fastest run of a frame with moving lights"),
    ("memory", "the method's buffers"),
    ("path tracing", "plain path tracing's time for the same error"),
];

fn table(html: &mut String, s: usize, scene: &SceneChart) {
    let _ = write!(
        html,
        "<h3>Numbers</h3>\n<p class=\"note\">Click a column to sort; rows that were not measured say why.</p>\n\
         <div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Results\">\n<table class=\"sortable\">\n\
         <thead><tr><th scope=\"col\"><button>method</button></th>"
    );
    for (name, help) in COLUMNS {
        let _ = write!(html, "<th scope=\"col\" title=\"{help}\"><button>{name}</button></th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    let colours = colours(scene.rows.iter().filter(|r| r.error().is_some()).map(|r| r.method.as_str()));
    for (k, row) in scene.rows.iter().enumerate() {
        let colour = colours.iter().find(|(m, _)| *m == row.method).map_or(PALETTE[PALETTE.len() - 1], |(_, c)| c);
        let class = if row.control { "key control" } else { "key" };
        let _ = write!(
            html,
            "<tr><th scope=\"row\" data-v=\"{0}\"><span class=\"{class}\" style=\"--c:{colour}\"></span>{0}</th>\
             <td data-v=\"{1}\"><a href=\"#s{s}-p{k}\">{1}</a></td>{2}",
            escape(&row.method),
            escape(&row.rung),
            state(row)
        );
        let numbers: [Option<(f64, String)>; 11] = match &row.result {
            None => Default::default(),
            Some(r) => {
                let e = |get: fn(&metrics::ErrorMetrics) -> Option<f64>| {
                    r.error.as_ref().and_then(get).map(|v| (v, number(v)))
                };
                let t = &r.time_ms;
                let ms = |v: f64| Some((v, milliseconds(v)));
                let spread = t.dynamic_spread().filter(|s| s[0] > 0.0).map(|[low, high]| high / low);
                [
                    e(|e| Some(e.nrmse_block)),
                    e(|e| Some(e.nrmse)),
                    e(|e| Some(e.bias)),
                    e(|e| Some(e.p95)),
                    e(|e| e.flip),
                    ms(t.precompute),
                    ms(t.light_change),
                    ms(t.frame),
                    spread.map(|v| (v, format!("× {v:.2}"))),
                    Some((r.memory_bytes.total as f64, bytes(r.memory_bytes.total))),
                    row.path_tracing_ms.map(|v| (v, milliseconds(v))),
                ]
            }
        };
        for cell in numbers {
            match cell {
                Some((value, words)) => _ = write!(html, "<td data-v=\"{value}\">{}</td>", escape(&words)),
                None => html.push_str("<td>–</td>"),
            }
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n");
    if let Some(floor) = scene.truth.noise_floor {
        let (block, pixel) = (number(floor.nrmse_block), number(floor.nrmse));
        let _ = writeln!(
            html,
            "<tfoot><tr><th scope=\"row\">noise of the truth</th><td></td><td></td><td>{block}</td><td>{pixel}</td>\
             <td colspan=\"9\"></td></tr></tfoot>"
        );
    }
    html.push_str("</table>\n</div>\n");
}

fn state(row: &Row) -> String {
    let mut words = row.status.words().to_string();
    if row.under_noise {
        words += ", within the noise";
    } else if row.pareto {
        words += ", on the front";
    }
    if row.earlier_run {
        words += ", earlier run";
    }
    let reason = row.reason.as_deref().map_or_else(String::new, |r| {
        let short: String = r.chars().take(90).collect();
        format!(": {short}{}", if short.len() < r.len() { "…" } else { "" })
    });
    format!(
        "<td class=\"words\" data-v=\"{0}\" title=\"{1}\">{0}{2}</td>",
        escape(&words),
        escape(row.reason.as_deref().unwrap_or("")),
        escape(&reason)
    )
}

fn explanations(html: &mut String) {
    let entries = [
        (
            "Error: block NRMSE",
            "Root mean square error of indirect irradiance over 8 × 8 blocks of pixels, divided by the truth's mean. 0 is \
             perfect, 0.1 an error of 10 % of the average brightness. Noise averages out within a block, light in the \
             wrong place stays.",
        ),
        (
            "Time",
            "Median of several runs after a warm-up, each rung in a process of its own. A frame with moving lights costs \
             light change plus frame; precompute runs once per geometry and is in the table.",
        ),
        (
            "Plain path tracing",
            "What the truth's own path tracer takes for the same error: its error falls with the square root of the time. \
             Building its tree is not counted. \
             A method above and right of that line is not worth having on this machine. Its time grows with the number of \
             pixels, while methods that keep light in grids or probes pay for those whatever the size of the picture.",
        ),
        (
            "Noise of the truth",
            "The truth is itself an estimate. A perfect method would show the error at the dashed line; below two standard \
             deviations above it points are drawn hollow and take no part in rankings.",
        ),
        (
            "Controls",
            "No indirect light at all, a constant fitted to the truth, and path tracing with a fixed number of samples: \
             yardsticks. A method that does not beat them is not worth its time here.",
        ),
    ];
    html.push_str(
        "<section aria-labelledby=\"h-words\">\n<h2 id=\"h-words\">What the numbers mean</h2>\n<div class=\"card\">\n",
    );
    for (name, words) in entries {
        let _ = writeln!(html, "<details><summary>{name}</summary><p>{words}</p></details>");
    }
    html.push_str("</div>\n</section>\n");
}
