//! `index.html` of a fit: what to use, why each parameter has its value, why the other methods do not, and all that was tried.

use super::{FitReport, Goal, NOTHING_NEEDED, Neighbour, Reason, SettingsFile, Tried, changed_settings};
use crate::methods::METHODS;
use crate::report::{
    Chart, ChartPoint, Cost, Device, PALETTE, bytes, colours, data_uri, document, escape, milliseconds, number,
    what_error_is,
};
use std::fmt::Write;

/// The whole page. `pictures`: PNG files of the choice's picture and of its indirect light.
pub fn page(report: &FitReport, size: [u32; 2], device: &Device, pictures: Option<&[Vec<u8>; 2]>) -> String {
    let mut html = String::new();
    let scene = short(&report.scene);
    let (head, lead) = answer(report);
    let _ = write!(
        html,
        "<header>\n<p class=\"eyebrow\">No more light than the scene needs</p>\n<h1>{}</h1>\n<p class=\"lead\">{}</p>\n\
         {}<ul class=\"facts\">\n",
        escape(&head),
        escape(&lead),
        what_error_is()
    );
    let facts = [
        ("Scene", scene.to_string()),
        ("Asked for", asked(&report.goal)),
        ("Device", format!("{} ({})", device.adapter, device.backend)),
        ("Picture", format!("{} × {}", size[0], size[1])),
        ("Tried", format!("{} sets of settings in {:.0} s", report.trials, report.search_s + report.why_s)),
    ];
    for (name, value) in facts {
        let _ = writeln!(html, "<li><b>{name}</b> {}</li>", escape(&value));
    }
    html += "</ul>\n</header>\n";
    if let Some(choice) = &report.choice {
        chosen(&mut html, report, choice, pictures);
        parameters(&mut html, report);
    }
    others(&mut html, report);
    if !report.tried.is_empty() {
        everything(&mut html, report);
    }
    explanations(&mut html, report);
    let _ = writeln!(html, "<footer>Every number here is in fit.json beside this file.</footer>");
    document(&format!("{scene}: {head}"), &html, "")
}

/// A scene's name without its folder.
fn short(scene: &str) -> &str {
    std::path::Path::new(scene).file_name().and_then(|n| n.to_str()).unwrap_or(scene)
}

/// An error for people.
fn percent(error: f64) -> String {
    match 100.0 * error {
        e if e < 9.95 => format!("{e:.1} %"),
        e => format!("{e:.0} %"),
    }
}

/// What was asked for, in words.
fn asked(goal: &Goal) -> String {
    let moving = if goal.still { "lights standing still" } else { "lights moving" };
    let parts = [
        goal.error.map(|e| format!("an error of at most {}", percent(e))),
        goal.ms.map(|t| format!("at most {} per frame", milliseconds(t))),
        goal.memory_bytes.map(|b| format!("at most {}", bytes(b))),
        goal.precompute_ms.map(|t| format!("at most {} once per geometry", milliseconds(t))),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().chain([moving.to_string()]).collect();
    parts.join(", ")
}

/// Headline and the sentence below it.
fn answer(report: &FitReport) -> (String, String) {
    let Some(c) = &report.choice else {
        let why = report.rejected.first().map_or("no method gave an answer", |r| r.reason.as_str());
        return ("Nothing is needed, or nothing works".into(), format!("{}: {why}.", short(&report.scene)));
    };
    if report.dark {
        let lead = format!("On {}, {NOTHING_NEEDED}. {} leaves it out.", short(&report.scene), c.method);
        return ("No indirect light to compute".into(), lead);
    }
    let cost = if report.goal.still { c.ms[1] } else { c.ms[0] };
    let what = match report.goal.error {
        Some(_) => "the cheapest that was found to keep the limits",
        None => "the most accurate that was found within the limits",
    };
    if report.found {
        let doubt = match report.goal.error {
            Some(limit) if report.error_bounds[1] > limit => " It may be over the limit: nothing is sure to keep it.",
            _ => "",
        };
        let lead = format!(
            "On {}, {} is {what}: an error of {} in {} per frame, {} of memory.{doubt}",
            short(&report.scene),
            c.method,
            percent(c.error),
            milliseconds(cost),
            bytes(c.memory_bytes)
        );
        return (format!("Use {}", c.method), lead);
    }
    let lead = format!(
        "On {} no method keeps {}. {} comes closest: an error of {} in {} per frame.",
        short(&report.scene),
        asked(&report.goal),
        c.method,
        percent(c.error),
        milliseconds(cost)
    );
    ("Nothing fits".into(), lead)
}

fn chosen(html: &mut String, report: &FitReport, choice: &SettingsFile, pictures: Option<&[Vec<u8>; 2]>) {
    let row = METHODS.iter().find(|m| m.name == choice.method);
    html.push_str("<section aria-labelledby=\"h-choice\">\n<h2 id=\"h-choice\">The choice</h2>\n<div class=\"row\">\n<div class=\"card\">");
    let _ = writeln!(html, "<h3>{}</h3><p>{}</p>", escape(&choice.method), escape(row.map_or("", |r| r.summary)));
    let [low, high] = report.error_bounds;
    let lines = [
        (
            "Error",
            format!("{} ({} to {}, from {} blocks)", percent(choice.error), percent(low), percent(high), report.blocks),
        ),
        ("Frame, lights moving", milliseconds(choice.ms[0])),
        ("Frame, lights still", milliseconds(choice.ms[1])),
        ("Memory", bytes(choice.memory_bytes)),
    ];
    html.push_str("<dl class=\"setup\">");
    for (name, value) in lines {
        let _ = write!(html, "<dt>{name}</dt><dd>{}</dd>", escape(&value));
    }
    let name = changed_settings(&choice.method, &choice.settings);
    let settings = name.strip_prefix(&choice.method).unwrap_or("").trim();
    let settings = if settings.is_empty() { "all at their defaults" } else { settings };
    let _ = write!(html, "<dt>Settings</dt><dd><code>{}</code></dd></dl>", escape(settings));
    if report.found {
        let view = if report.view.is_empty() { String::new() } else { format!(" {}", report.view) };
        let _ = write!(
            html,
            "<p class=\"note\">Use them: <code>interreflect render {}{} --settings settings.json</code></p>",
            escape(&report.scene),
            escape(&view)
        );
    }
    html.push_str("</div>\n");
    for (png, name) in pictures.into_iter().flatten().zip(["With direct light", "Its indirect light alone"]) {
        let _ = writeln!(
            html,
            "<figure class=\"card\"><img class=\"small\" alt=\"{name} of {0}\" src=\"{1}\"><figcaption>{name}</figcaption></figure>",
            escape(&choice.method),
            data_uri(png)
        );
    }
    html.push_str("</div>\n</section>\n");
}

/// Why each parameter has its value.
fn parameters(html: &mut String, report: &FitReport) {
    if report.why.is_empty() {
        return;
    }
    html.push_str(
        "<section aria-labelledby=\"h-why\">\n<h2 id=\"h-why\">Why these values</h2>\n<p class=\"note\">For each parameter: the \
         value that was chosen, and what the next cheaper and the next dearer one would do to error and time. ≈: an estimate, \
         from a smaller size of the same method. Click a column to sort.</p>\n\
         <div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Parameters\">\n<table class=\"sortable\">\n<thead><tr>",
    );
    for (name, words) in [
        ("parameter", ""),
        ("chosen", ""),
        ("cheaper", ""),
        ("its error", ""),
        ("its time", ""),
        ("dearer", ""),
        ("its error", ""),
        ("its time", ""),
        ("in words", " class=\"words\""),
    ] {
        let _ = write!(html, "<th scope=\"col\"{words}><button>{name}</button></th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for reason in &report.why {
        let _ = write!(
            html,
            "<tr><th scope=\"row\" data-v=\"{0}\">{0}</th><td data-v=\"{1}\"><b>{1}</b></td>",
            escape(&reason.key),
            escape(&reason.value)
        );
        neighbour(html, reason.below.as_ref(), report.goal.error);
        neighbour(html, reason.above.as_ref(), report.goal.error);
        let words = in_words(reason);
        let _ = writeln!(html, "<td class=\"words long\" data-v=\"{0}\">{0}</td></tr>", escape(words));
    }
    html.push_str("</tbody>\n</table>\n</div>\n</section>\n");
}

/// The reason without the parameter and value that stand before it in the table.
fn in_words(reason: &Reason) -> &str {
    let name = format!("{} {}: ", reason.key, reason.value);
    reason.words.strip_prefix(&name).unwrap_or(&reason.words)
}

fn neighbour(html: &mut String, n: Option<&Neighbour>, limit: Option<f64>) {
    let Some(n) = n else {
        html.push_str("<td>–</td><td>–</td><td>–</td>");
        return;
    };
    let about = if n.estimated_at.is_some() { "≈ " } else { "" };
    let _ = write!(html, "<td data-v=\"{0}\">{0}</td>", escape(&n.value));
    match n.error {
        Some(e) => {
            let over = if limit.is_some_and(|l| e > l) { " class=\"bad\" title=\"over the limit\"" } else { "" };
            let _ = write!(html, "<td data-v=\"{e}\"{over}>{about}{}</td>", percent(e));
        }
        None => html.push_str("<td>refused</td>"),
    }
    match n.ms {
        Some(ms) => _ = write!(html, "<td data-v=\"{ms}\">{about}{}</td>", escape(&milliseconds(ms))),
        None => html.push_str("<td>–</td>"),
    }
}

/// What became of the methods that were not chosen.
fn others(html: &mut String, report: &FitReport) {
    if report.rejected.is_empty() {
        return;
    }
    html.push_str(
        "<section aria-labelledby=\"h-not\">\n<h2 id=\"h-not\">Why not the others</h2>\n<div class=\"cards\">\n",
    );
    for other in &report.rejected {
        let row = METHODS.iter().find(|m| m.name == other.method);
        let _ = writeln!(
            html,
            "<div class=\"card\"><h3>{}</h3><p>{}</p><p class=\"note\">{}<br><b>Fails when:</b> {}</p></div>",
            escape(&other.method),
            escape(&sentence(&other.reason)),
            escape(row.map_or("", |r| r.summary)),
            escape(row.map_or("", |r| r.fails_when))
        );
    }
    html.push_str("</div>\n</section>\n");
}

/// With a capital letter and a full stop.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    let text = letters.next().map_or_else(String::new, |c| c.to_uppercase().collect::<String>() + letters.as_str());
    if text.ends_with(['.', '!', '?']) { text } else { text + "." }
}

/// All trials as a chart and a table.
fn everything(html: &mut String, report: &FitReport) {
    let cost = |t: &Tried| if report.goal.still { t.ms[1] } else { t.ms[0] };
    let is_choice = |t: &Tried| {
        let same = |c: &SettingsFile| c.method == t.method && changed_settings(&c.method, &c.settings) == t.name;
        report.choice.as_ref().is_some_and(same)
    };
    let point = |t: &Tried| ChartPoint {
        series: t.method.clone(),
        label: t.name.clone(),
        mark: if is_choice(t) { "the choice".into() } else { String::new() },
        cost: cost(t),
        still_cost: cost(t),
        spread: None,
        error: t.error,
        control: false,
        under_noise: false,
        link: String::new(),
    };
    let chart = Chart {
        title: format!("{}, everything that was tried", short(&report.scene)),
        points: report.tried.iter().filter(|t| t.error < f64::MAX).map(point).collect(),
        cost: Cost::Time,
        scattered: true,
        limits: [report.goal.error, report.goal.ms],
        ..Chart::default()
    };
    let colours = colours(chart.points.iter().map(|p| p.series.as_str()));
    let keys: String = colours
        .iter()
        .map(|(name, colour)| format!("<span class=\"key\" style=\"--c:{colour}\"></span>{} ", escape(name)))
        .collect();
    let _ = write!(
        html,
        "<section aria-labelledby=\"h-all\">\n<h2 id=\"h-all\">All that was tried</h2>\n<p class=\"note\">Each dot is a set of \
         settings; further left is faster, further down closer to the truth. {keys}</p>\n<div class=\"card chart\">\n\
         <div class=\"wide\">{}</div>\n<div class=\"narrow\">{}</div>\n</div>\n",
        chart.inline_svg(1130.0, 460.0, "-w"),
        chart.inline_svg(400.0, 420.0, "-n")
    );
    html.push_str(
        "<div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Everything that was tried\">\n<table class=\"sortable\">\n\
         <thead><tr><th scope=\"col\"><button>method</button></th><th scope=\"col\" class=\"words\"><button>settings</button></th>\
         <th scope=\"col\"><button>block NRMSE</button></th><th scope=\"col\"><button>lights moving</button></th>\
         <th scope=\"col\"><button>lights still</button></th><th scope=\"col\"><button>precompute</button></th>\
         <th scope=\"col\"><button>memory</button></th></tr></thead>\n<tbody>\n",
    );
    for t in &report.tried {
        let colour = colours.iter().find(|(m, _)| *m == t.method).map_or(PALETTE[0], |(_, c)| c);
        let settings = t.name.strip_prefix(&t.method).unwrap_or(&t.name).trim();
        let settings = if settings.is_empty() { "defaults" } else { settings };
        let badge = if is_choice(t) { "<span class=\"badge\">chosen</span>" } else { "" };
        let _ = write!(
            html,
            "<tr><th scope=\"row\" data-v=\"{0}\"><span class=\"key\" style=\"--c:{colour}\"></span>{0}{badge}</th>\
             <td class=\"words long\" data-v=\"{1}\">{1}</td><td data-v=\"{2}\">{3}</td>",
            escape(&t.method),
            escape(settings),
            t.error,
            if t.error < f64::MAX { number(t.error) } else { "–".into() }
        );
        for ms in [t.ms[0], t.ms[1], t.precompute_ms] {
            let _ = write!(html, "<td data-v=\"{ms}\">{}</td>", escape(&milliseconds(ms)));
        }
        let _ = writeln!(html, "<td data-v=\"{}\">{}</td></tr>", t.memory_bytes, escape(&bytes(t.memory_bytes)));
    }
    html.push_str("</tbody>\n</table>\n</div>\n</section>\n");
}

fn explanations(html: &mut String, report: &FitReport) {
    html.push_str(
        "<section aria-labelledby=\"h-words\">\n<h2 id=\"h-words\">What the numbers mean</h2>\n<div class=\"card\">\n",
    );
    let words = [
        (
            "Error: block NRMSE",
            "Root mean square error of indirect irradiance over 8 × 8 blocks of pixels, divided by the path-traced truth's mean. \
             0 is perfect, 0.1 an error of 10 % of the average brightness. The bounds hold what the truth's own noise, and blocks \
             that were not looked at, leave open; the choice keeps the limit with its upper bound.",
        ),
        (
            "Time",
            "Of a frame on this machine: what a change of the lights takes and the frame itself; with still lights the frame alone. \
             What is computed once per geometry is no part of it.",
        ),
        (
            "How it was found",
            "The ladder of each method's settings is climbed as far as a rung can still win; around what fits, every parameter is \
             lowered as long as the limit is kept. Dots above are glances at parts of the picture; the choice was confirmed on more \
             of it.",
        ),
    ];
    for (name, words) in words {
        let _ = writeln!(html, "<details><summary>{name}</summary><p>{words}</p></details>");
    }
    if !report.spared.is_empty() {
        html.push_str("<details><summary>What was not tried, and on what grounds</summary>");
        for line in &report.spared {
            let _ = writeln!(html, "<p>{}</p>", escape(&sentence(line)));
        }
        html.push_str("</details>\n");
    }
    html.push_str("</div>\n</section>\n");
}
