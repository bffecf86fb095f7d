//! The files of a chart.

use super::{ChartReport, Charted, SceneChart, page};
use crate::error::Error;
use crate::image_io::{ImageError, write_whole};
use crate::report::{self, Chart, ChartPoint, Cost, escape};
use std::fmt::Write;
use std::path::Path;

/// Size of one scene's chart in `chart.svg`, in CSS pixels.
const PANEL: (f64, f64) = (960.0, 520.0);
/// Pixels of `chart.png` per CSS pixel.
const PNG_SCALE: f32 = 2.0;

/// Writes `chart.json`, `chart.csv`, `chart.svg`, `chart.png`, `memory.svg`, `memory.png` and `index.html` into `folder`.
///
/// # Errors
/// A number that is not finite, a file that cannot be written.
pub fn write(folder: &Path, report: &ChartReport, charted: &[Charted]) -> Result<(), Error> {
    let file = |name: &str, bytes: &[u8]| write_whole(&folder.join(name), bytes);
    file("chart.json", report::to_json(report)?.as_bytes())?;
    file("chart.csv", csv(report).as_bytes())?;
    for (name, cost) in [("chart", Cost::Time), ("memory", Cost::Memory)] {
        let charts: Vec<Chart> = report.scenes.iter().map(|s| chart(s, cost, "")).collect();
        file(&format!("{name}.svg"), panels(&charts, Chart::svg).as_bytes())?;
        let path = folder.join(format!("{name}.png"));
        let png = png(&panels(&charts, Chart::plain_svg)).map_err(|reason| ImageError::Encode { path, reason })?;
        file(&format!("{name}.png"), &png)?;
    }
    file("index.html", page::page(report, charted)?.as_bytes())?;
    Ok(())
}

/// A scene's chart. `link` is put before the number of a row to make the address of its pictures on a page; empty: none.
pub fn chart(scene: &SceneChart, cost: Cost, link: &str) -> Chart {
    let [width, height] = scene.size;
    let mut points = Vec::new();
    for (k, row) in scene.rows.iter().enumerate() {
        let Some(result) = &row.result else { continue };
        let Some(error) = result.error else { continue };
        let (place, still, spread) = match cost {
            Cost::Time => (result.time_ms.dynamic_frame(), result.time_ms.frame, result.time_ms.dynamic_spread()),
            Cost::Memory => (result.memory_bytes.total as f64, result.memory_bytes.total as f64, None),
        };
        // One name per method, at its best rung: a name at every point would hide the points.
        let last = scene.rows[k + 1..].iter().all(|r| r.method != row.method || r.error().is_none());
        points.push(ChartPoint {
            series: row.method.clone(),
            label: row.title(),
            mark: if last { row.method.clone() } else { String::new() },
            cost: place,
            still_cost: still,
            spread,
            error: error.nrmse_block,
            control: row.control,
            under_noise: row.under_noise,
            link: if link.is_empty() { String::new() } else { format!("#{link}{k}") },
        });
    }
    Chart {
        title: format!("{}, {width} × {height} pixels", scene.short_name()),
        points,
        noise_floor: scene.truth.noise_floor.map(|f| f.nrmse_block),
        path_tracing: scene.path_tracing.filter(|_| cost == Cost::Time).map(|p| p.error_at_one_ms()),
        cost,
        ..Chart::default()
    }
}

/// Charts one above the other, each under its title.
fn panels(charts: &[Chart], draw: impl Fn(&Chart, f64, f64, &str) -> String) -> String {
    const TITLE_PX: f64 = 34.0;
    let (width, height) = (PANEL.0, (PANEL.1 + TITLE_PX) * charts.len().max(1) as f64);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    for (k, chart) in charts.iter().enumerate() {
        let y = k as f64 * (PANEL.1 + TITLE_PX);
        let panel = draw(chart, PANEL.0, PANEL.1, &format!("-{k}"));
        let panel = panel.replacen("<svg ", &format!("<svg x=\"0\" y=\"{}\" ", y + TITLE_PX), 1);
        let _ = writeln!(
            svg,
            "<text x=\"14\" y=\"{}\" font-family=\"system-ui,'Segoe UI',Roboto,Ubuntu,sans-serif\" font-size=\"16\" \
             font-weight=\"600\" fill=\"#1c2026\">{}</text>\n{panel}",
            y + 23.0,
            escape(&chart.title)
        );
    }
    svg + "</svg>\n"
}

/// A PNG file of an SVG picture, with a font that comes with the program: the same on every machine.
pub(crate) fn png(svg: &str) -> Result<Vec<u8>, String> {
    use resvg::{tiny_skia, usvg};
    let mut options = usvg::Options { font_family: "Ubuntu".into(), ..Default::default() };
    let fonts = options.fontdb_mut();
    fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
    let family = fonts.faces().next().map_or_else(String::new, |f| f.families[0].0.clone());
    fonts.set_sans_serif_family(family.clone());
    options.font_family = family;
    let tree = usvg::Tree::from_str(svg, &options).map_err(|e| e.to_string())?;
    let size = tree.size().to_int_size().scale_by(PNG_SCALE).ok_or("the picture is empty")?;
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height()).ok_or("the picture is too large")?;
    pixels.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::from_scale(PNG_SCALE, PNG_SCALE), &mut pixels.as_mut());
    pixels.encode_png().map_err(|e| e.to_string())
}

/// Every row as a line. Texts are quoted as RFC 4180 asks.
fn csv(report: &ChartReport) -> String {
    let mut csv = String::from(
        "scene,method,rung,control,status,reason,nrmse,nrmse_block,bias,p95,flip,precompute_ms,light_change_ms,frame_ms,\
         dynamic_ms,dynamic_min_ms,dynamic_max_ms,memory_bytes,peak_memory_bytes,path_tracing_ms,under_noise,pareto,\
         earlier_run,settings\r\n",
    );
    let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\"").replace(['\r', '\n'], " "));
    let some = |value: Option<f64>| value.map_or_else(String::new, |v| v.to_string());
    for scene in &report.scenes {
        for row in &scene.rows {
            let result = row.result.as_ref();
            let error = result.and_then(|r| r.error);
            let time = result.map(|r| &r.time_ms);
            let spread = time.and_then(|t| t.dynamic_spread());
            let settings: Vec<String> = row.settings.iter().map(|(k, v)| format!("{k}={v}")).collect();
            let cells = [
                quoted(&scene.scene),
                quoted(&row.method),
                quoted(&row.rung),
                row.control.to_string(),
                quoted(row.status.words()),
                quoted(row.reason.as_deref().unwrap_or("")),
                some(error.map(|e| e.nrmse)),
                some(error.map(|e| e.nrmse_block)),
                some(error.map(|e| e.bias)),
                some(error.map(|e| e.p95)),
                some(error.and_then(|e| e.flip)),
                some(time.map(|t| t.precompute)),
                some(time.map(|t| t.light_change)),
                some(time.map(|t| t.frame)),
                some(time.map(|t| t.dynamic_frame())),
                some(spread.map(|s| s[0])),
                some(spread.map(|s| s[1])),
                result.map_or_else(String::new, |r| r.memory_bytes.total.to_string()),
                row.peak_memory_bytes.map_or_else(String::new, |b| b.to_string()),
                some(row.path_tracing_ms),
                row.under_noise.to_string(),
                row.pareto.to_string(),
                row.earlier_run.to_string(),
                quoted(&settings.join(" ")),
            ];
            csv += &cells.join(",");
            csv += "\r\n";
        }
    }
    csv
}
