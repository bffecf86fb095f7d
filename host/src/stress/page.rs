//! `index.html` of the atlas: one table of safe ranges, one section per family with curves, sentences and pictures.

use super::{Atlas, Danger, Entry, FAMILIES, NOT_FINITE, State};
use crate::methods::METHODS;
use crate::report::{PALETTE, colours, data_uri, document, escape};
use std::fmt::Write;

/// The whole page.
pub fn page(atlas: &Atlas) -> String {
    let mut html = String::new();
    let measured = atlas.entries.iter().filter(|e| e.state == State::Measured);
    let total = measured.clone().count();
    let fine = measured.filter(|e| is_safe(e)).count();
    let _ = write!(
        html,
        "<header>\n<p class=\"eyebrow\">Failure atlas</p>\n<h1>Where each lighting method fails</h1>\n\
         <p class=\"lead\">Scenes made to break methods, each with one parameter and one number that grows when a method \
         fails. Of {total} tests {fine} stayed within their bound wherever they were tried; for the others the page says \
         from where on.</p>\n<ul class=\"facts\">\n<li><b>Device</b> {} ({})</li>\n</ul>\n</header>\n",
        escape(&atlas.device.adapter),
        escape(&atlas.device.backend)
    );
    methods(&mut html, atlas);
    glance(&mut html, atlas);
    for family in FAMILIES {
        let entries: Vec<&Entry> = atlas.entries.iter().filter(|e| e.family == family.key).collect();
        if entries.is_empty() {
            continue;
        }
        let _ = write!(
            html,
            "<section aria-labelledby=\"f-{0}\">\n<h2 id=\"f-{0}\" class=\"scene\">{1}</h2>\n<p class=\"note\">{2}</p>\n",
            family.key,
            escape(&sentence_case(family.title)),
            escape(family.what)
        );
        for entry in &entries {
            let class = if entry.state == State::Measured && !is_safe(entry) { "fails" } else { "holds" };
            let _ = writeln!(html, "<p class=\"{class}\">{}</p>", escape(&entry.sentence));
        }
        let mut variants: Vec<&str> = entries.iter().map(|e| e.variant.as_str()).collect();
        variants.dedup();
        variants.sort_unstable();
        variants.dedup();
        html.push_str("<div class=\"pictures\">\n");
        for variant in variants {
            let of: Vec<&Entry> =
                entries.iter().copied().filter(|e| e.variant == variant && e.state == State::Measured).collect();
            if !of.is_empty() {
                curves(&mut html, &of);
            }
        }
        for entry in entries {
            if let Some((png, words)) = &entry.picture {
                let _ = writeln!(
                    html,
                    "<figure class=\"card\"><figcaption><b>{}</b> {}</figcaption><img class=\"small\" loading=\"lazy\" \
                     alt=\"{}\" src=\"{}\"></figure>",
                    escape(&entry.method),
                    escape(words),
                    escape(words),
                    data_uri(png)
                );
            }
        }
        html.push_str("</div>\n</section>\n");
    }
    overview(&mut html, atlas);
    let _ = writeln!(
        html,
        "<footer>Made by interreflect {}. Every number here is in stress.json beside this file.</footer>",
        escape(&atlas.version)
    );
    document("Where each lighting method fails", &html, "")
}

fn sentence_case(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |c| c.to_uppercase().collect::<String>() + letters.as_str())
}

/// Whether every measurement is within the bound.
fn is_safe(entry: &Entry) -> bool {
    entry.samples.iter().all(|s| s.value <= entry.bound)
}

/// What was tried within a family: its title, and what varies.
fn subject(entry: &Entry) -> String {
    let title = FAMILIES.iter().find(|f| f.key == entry.family).map_or(entry.family.as_str(), |f| f.title);
    if entry.variant.is_empty() { sentence_case(title) } else { format!("{}: {}", sentence_case(title), entry.variant) }
}

/// Worst failures that a method's card names.
const NAMED_FAILURES: usize = 4;

/// A card for every method: what it is, how many tests it stands, and where it goes wrong most.
fn methods(html: &mut String, atlas: &Atlas) {
    let mut names: Vec<&str> = atlas.entries.iter().map(|e| e.method.as_str()).collect();
    let mut seen = Vec::new();
    names.retain(|n| {
        !seen.contains(n) && {
            seen.push(*n);
            true
        }
    });
    html.push_str(
        "<section aria-labelledby=\"h-methods\">\n<h2 id=\"h-methods\">Which method for which scene</h2>\n<p class=\"note\">Look for what \
         your scene has: thin walls, moving objects, tiny lights. How accurate and fast a method is where it works, the page of <code>chart</code> \
         says.</p>\n<div class=\"cards\">\n",
    );
    for name in names {
        let of = || atlas.entries.iter().filter(|e| e.method == name && e.state == State::Measured);
        let mut bad: Vec<&Entry> = of().filter(|e| !is_safe(e)).collect();
        bad.sort_by(|a, b| severity(b).total_cmp(&severity(a)));
        let _ = write!(
            html,
            "<div class=\"card\"><h3>{}</h3>\n<p>{} of {} tests hold.</p>",
            escape(name),
            of().count() - bad.len(),
            of().count()
        );
        if let Some(row) = METHODS.iter().find(|m| m.name == name) {
            let _ = write!(
                html,
                "<p class=\"note\"><b>Good when:</b> {}<br><b>Fails when:</b> {}</p>",
                escape(row.good_when),
                escape(row.fails_when)
            );
        }
        if !bad.is_empty() {
            html.push_str("<p class=\"note\"><b>Worst here:</b> ");
            let links: Vec<String> = bad
                .iter()
                .take(NAMED_FAILURES)
                .map(|e| format!("<a href=\"#f-{}\">{}</a>", escape(&e.family), escape(&subject(e).to_lowercase())))
                .collect();
            html.push_str(&links.join("; "));
            html.push_str("</p>");
        }
        html.push_str("</div>\n");
    }
    html.push_str("</div>\n</section>\n");
}

/// How many times over its bound an entry is at worst.
fn severity(entry: &Entry) -> f64 {
    if entry.bound > 0.0 { worst(entry) / entry.bound } else { NOT_FINITE }
}

/// One row per test, one column per method: where to look at all.
fn glance(html: &mut String, atlas: &Atlas) {
    let (mut methods, mut rows): (Vec<&str>, Vec<(&str, &str, String)>) = Default::default();
    for entry in &atlas.entries {
        if !methods.contains(&entry.method.as_str()) {
            methods.push(&entry.method);
        }
        let key = (entry.family.as_str(), entry.variant.as_str(), subject(entry));
        // What applies to none of the methods is no row.
        if entry.state != State::NotApplicable && !rows.contains(&key) {
            rows.push(key);
        }
    }
    html.push_str(
        "<section aria-labelledby=\"h-glance\">\n<h2 id=\"h-glance\">At a glance</h2>\n<p class=\"note\">✓ within its bound \
         wherever it was tried; × how many times over the bound at worst; – does not apply. A click on a row leads to its \
         curves and safe ranges.</p>\n<div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"At a glance\">\n\
         <table class=\"sortable\">\n<thead><tr><th scope=\"col\"><button>what may fail</button></th>",
    );
    for method in &methods {
        let _ = write!(html, "<th scope=\"col\"><button>{}</button></th>", escape(method));
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for (family, variant, subject) in &rows {
        let _ = write!(
            html,
            "<tr><th scope=\"row\" class=\"wrap\" data-v=\"{0}\"><a href=\"#f-{1}\">{0}</a></th>",
            escape(subject),
            escape(family)
        );
        for method in &methods {
            let of = |e: &&Entry| e.family == *family && e.variant == *variant && e.method == *method;
            let _ = match atlas.entries.iter().find(of).map(|e| (e, worst(e))) {
                Some((e, _)) if e.state == State::Broken => {
                    write!(html, "<td class=\"bad\" data-v=\"{NOT_FINITE}\">broken</td>")
                }
                Some((e, _)) if e.state == State::Measured && is_safe(e) => write!(html, "<td data-v=\"0\">✓</td>"),
                Some((e, w)) if e.state == State::Measured => {
                    let ratio = if e.bound > 0.0 { w / e.bound } else { NOT_FINITE };
                    let words = if ratio < NOT_FINITE { format!("× {}", super::short(ratio)) } else { "fails".into() };
                    write!(html, "<td class=\"bad\" data-v=\"{ratio}\">{words}</td>")
                }
                _ => write!(html, "<td data-v=\"-1\">–</td>"),
            };
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table>\n</div>\n</section>\n");
}

/// The largest number of an entry.
fn worst(entry: &Entry) -> f64 {
    entry.samples.iter().map(|s| s.value).fold(f64::NEG_INFINITY, f64::max)
}

/// One row per entry.
fn overview(html: &mut String, atlas: &Atlas) {
    html.push_str(
        "<section aria-labelledby=\"h-all\">\n<h2 id=\"h-all\" class=\"scene\">All safe ranges</h2>\n\
         <p class=\"note\">Click a column to sort.</p>\n\
         <div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Safe ranges\">\n<table class=\"sortable\">\n\
         <thead><tr><th scope=\"col\"><button>method</button></th><th scope=\"col\" class=\"words\"><button>what fails</button></th>\
         <th scope=\"col\"><button>state</button></th><th scope=\"col\"><button>worst over bound</button></th>\
         <th scope=\"col\" class=\"words\"><button>in words</button></th></tr></thead>\n<tbody>\n",
    );
    for entry in &atlas.entries {
        let what = if entry.variant.is_empty() {
            entry.family.clone()
        } else {
            format!("{}: {}", entry.family, entry.variant)
        };
        let state = match entry.state {
            State::NotApplicable => "does not apply",
            State::Broken => "broken",
            State::Measured if is_safe(entry) => "holds",
            State::Measured => "fails",
        };
        let (ratio, words) = match worst(entry) {
            w if w >= NOT_FINITE => (format!(" data-v=\"{NOT_FINITE}\""), "not finite".to_string()),
            w if w.is_finite() && entry.bound > 0.0 => {
                (format!(" data-v=\"{}\"", w / entry.bound), format!("{:.2}", w / entry.bound))
            }
            _ => (String::new(), "–".into()),
        };
        let _ = writeln!(
            html,
            "<tr><th scope=\"row\" data-v=\"{0}\">{0}</th><td class=\"words\" data-v=\"{1}\"><a href=\"#f-{2}\">{1}</a></td>\
             <td data-v=\"{state}\">{state}</td><td{ratio}>{words}</td><td class=\"words long\" data-v=\"{3}\">{3}</td></tr>",
            escape(&entry.method),
            escape(&what),
            escape(&entry.family),
            escape(&entry.sentence)
        );
    }
    html.push_str("</tbody>\n</table>\n</div>\n</section>\n");
}

/// The number against the parameter for every method, with the bound; cases as a table.
fn curves(html: &mut String, entries: &[&Entry]) {
    let first = entries[0];
    let title = if first.variant.is_empty() { first.measure.clone() } else { first.variant.clone() };
    if first.danger == Danger::Cases {
        let _ = write!(html, "<figure class=\"card\"><figcaption><b>{}</b></figcaption><table>", escape(&title));
        for entry in entries {
            for sample in &entry.samples {
                let class = if sample.value > entry.bound { " class=\"bad\"" } else { "" };
                let _ = write!(
                    html,
                    "<tr><th scope=\"row\" class=\"words\">{}: {}</th><td{class}>{}</td></tr>",
                    escape(&entry.method),
                    escape(sample.case.as_deref().unwrap_or("")),
                    escape(&entry.amount(sample.value))
                );
            }
        }
        html.push_str("</table></figure>\n");
        return;
    }
    let _ = writeln!(
        html,
        "<figure class=\"card\"><figcaption><b>{}</b> against {}{}</figcaption>{}<p class=\"note\">{}</p></figure>",
        escape(&title),
        escape(&first.parameter),
        if first.unit.is_empty() { String::new() } else { format!(" ({})", escape(&first.unit)) },
        plot(entries),
        legend(entries)
    );
}

fn legend(entries: &[&Entry]) -> String {
    let colours = colours(entries.iter().map(|e| e.method.as_str()));
    let key =
        |(name, colour): &(&str, &str)| format!("<span class=\"key\" style=\"--c:{colour}\"></span>{} ", escape(name));
    colours.iter().map(key).collect::<String>() + "· dashed: the bound"
}

/// Logarithmic curves in a small SVG picture.
fn plot(entries: &[&Entry]) -> String {
    const W: f64 = 400.0;
    const H: f64 = 220.0;
    const LEFT: f64 = 58.0;
    const BOTTOM: f64 = 30.0;
    let samples = || entries.iter().flat_map(|e| &e.samples);
    let positive = |v: f64| v.is_finite() && v > 0.0 && v < NOT_FINITE;
    let range = |values: &mut dyn Iterator<Item = f64>| {
        let (lo, hi) = values.filter(|v| positive(*v)).fold((f64::MAX, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
        if hi == 0.0 { (0.1, 10.0) } else { (lo / 1.3, (hi * 1.3).max(lo * 4.0)) }
    };
    let bound = entries[0].bound;
    let (x0, x1) = range(&mut samples().map(|s| s.parameter));
    let (y0, y1) = range(&mut samples().map(|s| s.value).chain([bound]));
    // Below a thousandth of the largest everything is as good as nothing.
    let y0 = y0.max(y1 * 1e-4);
    let x = |v: f64| LEFT + (v.max(x0) / x0).ln() / (x1 / x0).ln() * (W - LEFT - 12.0);
    let y = |v: f64| H - BOTTOM - (v.clamp(y0, y1) / y0).ln() / (y1 / y0).ln() * (H - BOTTOM - 12.0);
    let mut svg = format!(
        "<svg viewBox=\"0 0 {W} {H}\" class=\"tae plot\" role=\"img\" aria-label=\"{}\">",
        escape(&format!("{} against {}", entries[0].measure, entries[0].parameter))
    );
    let grid: Vec<f64> = entries[0].samples.iter().map(|s| s.parameter).filter(|v| positive(*v)).collect();
    let mut last = f64::NEG_INFINITY;
    for v in grid {
        if x(v) - last > 44.0 {
            last = x(v);
            let _ = write!(
                svg,
                "<text x=\"{last:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                H - 10.0,
                super::short(v)
            );
        }
    }
    let mut decade = 10.0_f64.powf(y0.log10().ceil());
    while decade <= y1 {
        let _ = write!(
            svg,
            "<path class=\"line\" d=\"M{LEFT} {0:.1}H{W}\"/><text x=\"{1}\" y=\"{2:.1}\" text-anchor=\"end\">{3}</text>",
            y(decade),
            LEFT - 6.0,
            y(decade) + 4.0,
            escape(&entries[0].amount(decade))
        );
        decade *= 10.0;
    }
    if positive(bound) {
        let _ = write!(svg, "<path class=\"bound\" d=\"M{LEFT} {0:.1}H{W}\"/>", y(bound));
    }
    let colours = colours(entries.iter().map(|e| e.method.as_str()));
    for entry in entries {
        let colour = colours.iter().find(|(m, _)| *m == entry.method).map_or(PALETTE[0], |(_, c)| c);
        let points: Vec<String> =
            entry.samples.iter().map(|s| format!("{:.1} {:.1}", x(s.parameter), y(s.value.max(y0)))).collect();
        if points.is_empty() {
            continue;
        }
        let _ = write!(svg, "<path class=\"curve\" stroke=\"{colour}\" d=\"M{}\"/>", points.join("L"));
        for (point, sample) in points.iter().zip(&entry.samples) {
            let (cx, cy) = point.split_once(' ').unwrap_or(("0", "0"));
            let _ = write!(
                svg,
                "<circle cx=\"{cx}\" cy=\"{cy}\" r=\"4\" fill=\"{colour}\"><title>{} at {}: {}</title></circle>",
                escape(&entry.method),
                super::short(sample.parameter),
                escape(&entry.amount(sample.value))
            );
        }
    }
    svg + "</svg>"
}
