//! Time (or memory) against error as an SVG picture: logarithmic axes, one colour per method, the Pareto front, the
//! truth's noise, and what plain path tracing costs for the same error.
//!
//! Written by hand rather than through a plotting library: the picture follows the reader's light or dark theme, places
//! labels where they do not collide, and carries a description of every point for those who do not see it.

use super::table::{bytes, milliseconds, number};
use super::{Comparison, escape};
use std::fmt::Write;

/// One method with one set of settings.
#[derive(Clone, PartialEq, Debug)]
pub struct ChartPoint {
    /// Method: points of one series share a colour and are joined.
    pub series: String,
    /// Name of the point, in its description.
    pub label: String,
    /// Name drawn beside it; empty for none.
    pub mark: String,
    /// Where the point stands: time of a frame in which lights move, milliseconds, or memory in bytes.
    pub cost: f64,
    /// The end of the point's tail to the left: time of a frame in which nothing moves. Equal to `cost` for no tail.
    pub still_cost: f64,
    /// Smallest and largest cost of the repeated runs, where it was repeated.
    pub spread: Option<[f64; 2]>,
    /// Error.
    pub error: f64,
    /// Drawn as a diamond, and not part of the Pareto front.
    pub control: bool,
    /// Too close to the truth's own noise to be ranked: drawn hollow, and not part of the Pareto front.
    pub under_noise: bool,
    /// Where a click on the point leads on a page; empty for nowhere.
    pub link: String,
}

/// What the horizontal axis shows.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum Cost {
    /// Milliseconds.
    #[default]
    Time,
    /// Bytes.
    Memory,
}

impl Cost {
    /// A value with its unit.
    fn words(self, value: f64) -> String {
        match self {
            Self::Time => milliseconds(value),
            Self::Memory => bytes(value as u64),
        }
    }

    fn tick(self, value: f64) -> String {
        match self {
            Self::Time => tick_ms(value),
            Self::Memory => tick_bytes(value),
        }
    }

    fn axis(self, narrow: bool) -> &'static str {
        match (self, narrow) {
            (Self::Time, true) => "time per frame, lights moving",
            (Self::Time, false) => "time per frame with moving lights",
            (Self::Memory, _) => "memory of the method's buffers",
        }
    }

    fn title(self) -> &'static str {
        match self {
            Self::Time => "Time against error",
            Self::Memory => "Memory against error",
        }
    }
}

/// Time against error.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Chart {
    /// What is shown, for the description: `cornell-box, 512 x 512`.
    pub title: String,
    /// Points in the order of the table.
    pub points: Vec<ChartPoint>,
    /// Error of a perfect method, from the truth's own noise.
    pub noise_floor: Option<f64>,
    /// Error of path tracing for one millisecond: for `t` ms it is this over √t. Drawn as a line.
    pub path_tracing: Option<f64>,
    /// What the horizontal axis shows.
    pub cost: Cost,
    /// Whether points of a series stand alone, instead of being joined.
    pub scattered: bool,
    /// Largest error and cost that were asked for, drawn as lines.
    pub limits: [Option<f64>; 2],
}

/// Where the colours come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Theme {
    /// The reader's light or dark theme, by CSS variables.
    Reader,
    /// Light, as plain CSS: for programs that know no variables.
    Light,
}

/// Colours that keep apart from each other on white and on near black, in the order in which methods take them.
pub const PALETTE: [&str; 14] = [
    "#3f6fd8", "#e8743b", "#1aa37a", "#b65fcf", "#c9980a", "#d6457a", "#2a9fc4", "#7d9b2b", "#8a63e0", "#a8704c",
    "#d0584c", "#4f8f8b", "#94719f", "#7c8592",
];

/// Colour of each series in order of first appearance.
pub(crate) fn colours<'a>(series: impl Iterator<Item = &'a str>) -> Vec<(&'a str, &'static str)> {
    let mut seen: Vec<(&str, &str)> = Vec::new();
    for name in series {
        if !seen.iter().any(|(s, _)| *s == name) {
            seen.push((name, PALETTE[seen.len() % PALETTE.len()]));
        }
    }
    seen
}

/// Frame budgets that are marked where they lie within the axis.
const BUDGETS_MS: [(f64, &str); 2] = [(1000.0 / 60.0, "60 fps"), (1000.0 / 30.0, "30 fps")];

/// Picture of a fixed size in SVG user units (CSS pixels).
struct Canvas {
    width: f64,
    height: f64,
    x: Axis,
    y: Axis,
}

/// A logarithmic axis. Zero has a place of its own beyond the low end.
struct Axis {
    lo: f64,
    hi: f64,
    /// Pixel of `lo` and `hi`.
    from: f64,
    to: f64,
    /// Pixel of zero, where a value is zero.
    zero: Option<f64>,
}

impl Axis {
    fn at(&self, value: f64) -> f64 {
        match self.zero {
            Some(zero) if value <= 0.0 => zero,
            _ => {
                let t = (value.max(self.lo) / self.lo).ln() / (self.hi / self.lo).ln();
                self.from + t * (self.to - self.from)
            }
        }
    }

    /// An axis over the positive values, at least one decade long, with a place for zero if one is zero.
    fn over(values: &[f64], from: f64, to: f64) -> Self {
        let positive = || values.iter().copied().filter(|v| *v > 0.0);
        let (mut lo, mut hi) = positive().fold((f64::MAX, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
        if hi == 0.0 {
            (lo, hi) = (0.1, 10.0);
        }
        (lo, hi) = (lo / 1.5, hi * 1.5);
        if hi / lo < 10.0 {
            let middle = (lo * hi).sqrt();
            (lo, hi) = (middle / 10.0_f64.sqrt(), middle * 10.0_f64.sqrt());
        }
        const GAP_PX: f64 = 30.0;
        let zero = values.iter().any(|v| *v <= 0.0).then_some(from + 8.0 * (to - from).signum());
        let from = if zero.is_some() { from + GAP_PX * (to - from).signum() } else { from };
        Self { lo, hi, from, to, zero }
    }

    /// Ticks: value, and whether it is a power of ten. Steps 1, 2, 5 where a decade has room for them.
    fn ticks(&self) -> Vec<(f64, bool)> {
        /// Where 1 and 2 stand far enough apart for the names of both.
        const ROOM_PX: f64 = 190.0;
        let decades = (self.hi / self.lo).log10();
        let px_per_decade = (self.to - self.from).abs() / decades;
        let steps: &[f64] = if px_per_decade > ROOM_PX { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let stride = (54.0 / px_per_decade).ceil().max(1.0) as i32;
        let (first, last) = (self.lo.log10().floor() as i32, self.hi.log10().ceil() as i32);
        let decade = |d: i32| steps.iter().map(move |s| (s * 10.0_f64.powi(d), *s == 1.0));
        let all = (first..=last).filter(|d| d.rem_euclid(stride) == 0).flat_map(decade);
        all.filter(|(v, _)| *v >= self.lo && *v <= self.hi).collect()
    }
}

impl Chart {
    /// `nrmse_block` against the time of a frame with moving lights, of every result that has an error.
    pub fn from_comparison(comparison: &Comparison) -> Self {
        let point = |r: &super::MethodResult| {
            Some(ChartPoint {
                series: r.method.clone(),
                label: r.title(),
                mark: r.title(),
                cost: r.time_ms.dynamic_frame(),
                still_cost: r.time_ms.frame,
                spread: r.time_ms.dynamic_spread(),
                error: r.error?.nrmse_block,
                control: r.control,
                under_noise: false,
                link: String::new(),
            })
        };
        let [width, height] = comparison.size;
        Self {
            title: format!("{}, {width} × {height} pixels", comparison.scene),
            points: comparison.results.iter().filter_map(point).collect(),
            noise_floor: comparison.truth.noise_floor.map(|f| f.nrmse_block),
            ..Self::default()
        }
    }

    /// Points that no other is both faster and closer to the truth than, fastest first. Controls take no part.
    pub fn pareto_front(&self) -> Vec<&ChartPoint> {
        let mut points: Vec<_> = self.points.iter().filter(|p| !p.control && !p.under_noise).collect();
        points.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)));
        let mut best = f64::INFINITY;
        points.retain(|p| {
            p.error < best && {
                best = p.error;
                true
            }
        });
        points
    }

    /// The picture, `width` × `height` CSS pixels. `id` is added to ids, for pages with more than one chart.
    pub fn svg(&self, width: f64, height: f64, id: &str) -> String {
        self.themed(width, height, id, Theme::Reader)
    }

    /// The picture in its light colours, by plain CSS alone: for programs that make bitmaps of it.
    pub fn plain_svg(&self, width: f64, height: f64, id: &str) -> String {
        self.themed(width, height, id, Theme::Light)
    }

    fn themed(&self, width: f64, height: f64, id: &str, theme: Theme) -> String {
        let style = match theme {
            Theme::Reader => format!("{COLOURS}{STYLE}"),
            Theme::Light => plain_style(),
        };
        let canvas = self.canvas(width, height);
        let mut svg = String::new();
        let title = escape(&self.title);
        let _ = write!(
            svg,
            "<svg xmlns=\"{SVG_NAMESPACE}\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
             role=\"img\" aria-labelledby=\"chart-title{id} chart-desc{id}\" class=\"tae\">\n\
             <title id=\"chart-title{id}\">{}: {title}</title>\n\
             <desc id=\"chart-desc{id}\">{}</desc>\n<style>{style}</style>\n\
             <rect class=\"bg\" width=\"{width}\" height=\"{height}\" rx=\"8\"/>\n",
            self.cost.title(),
            escape(&self.description())
        );
        self.draw_axes(&mut svg, &canvas);
        self.draw_lines(&mut svg, &canvas);
        self.draw_points(&mut svg, &canvas);
        svg + "</svg>\n"
    }

    /// The picture as an element of an HTML page, where the namespace goes without saying.
    pub(crate) fn inline_svg(&self, width: f64, height: f64, id: &str) -> String {
        self.svg(width, height, id).replacen(&format!(" xmlns=\"{SVG_NAMESPACE}\""), "", 1)
    }

    fn canvas(&self, width: f64, height: f64) -> Canvas {
        let spreads = self.points.iter().flat_map(|p| p.spread.into_iter().flatten());
        let mut costs: Vec<f64> = self.points.iter().flat_map(|p| [p.cost, p.still_cost]).chain(spreads).collect();
        // A tail to zero is drawn to the edge; only a point at zero asks for a place there.
        if self.points.iter().all(|p| p.cost > 0.0) {
            costs.retain(|t| *t > 0.0);
        }
        let [error_limit, cost_limit] = self.limits;
        costs.extend(cost_limit);
        let errors = self.points.iter().map(|p| p.error).chain(self.noise_floor).chain(error_limit);
        let errors: Vec<f64> = errors.collect();
        Canvas { width, height, x: Axis::over(&costs, 58.0, width - 22.0), y: Axis::over(&errors, height - 56.0, 34.0) }
    }

    fn description(&self) -> String {
        let point = |p: &ChartPoint| format!("{}: {}, error {}", p.label, self.cost.words(p.cost), number(p.error));
        let points: Vec<_> = self.points.iter().map(point).collect();
        format!("Lower left is better. {}.", points.join("; "))
    }

    fn draw_axes(&self, svg: &mut String, c: &Canvas) {
        let (left, right, top, bottom) = (58.0, c.width - 22.0, 34.0, c.height - 56.0);
        for (value, major) in c.x.ticks() {
            let (x, class) = (c.x.at(value), if major { "grid" } else { "grid minor" });
            let _ = writeln!(svg, "<path class=\"{class}\" d=\"M{x:.1} {top}V{bottom}\"/>");
            text(svg, "tick mid", x, bottom + 18.0, &self.cost.tick(value));
        }
        for (value, major) in c.y.ticks() {
            let (y, class) = (c.y.at(value), if major { "grid" } else { "grid minor" });
            let _ = writeln!(svg, "<path class=\"{class}\" d=\"M{left} {y:.1}H{right}\"/>");
            text(svg, "tick end", left - 8.0, y + 4.0, &format!("{}", round_tick(value)));
        }
        for (axis_zero, vertical) in [(c.x.zero, true), (c.y.zero, false)] {
            match axis_zero {
                Some(x) if vertical => text(svg, "tick mid", x, bottom + 18.0, "0"),
                Some(y) => text(svg, "tick end", left - 8.0, y + 4.0, "0"),
                None => {}
            }
        }
        let _ = writeln!(svg, "<path class=\"axis\" d=\"M{left} {top}V{bottom}H{right}\"/>");
        text(svg, "name", left - 44.0, 20.0, "error (block NRMSE)");
        text(svg, "name end", right, c.height - 14.0, self.cost.axis(c.width < 600.0));
        text(svg, "hint", left - 44.0, c.height - 14.0, "lower left is better");
    }

    fn draw_lines(&self, svg: &mut String, c: &Canvas) {
        let (left, right, top, bottom) = (58.0, c.width - 22.0, 34.0, c.height - 56.0);
        for (k, (ms, name)) in BUDGETS_MS.into_iter().enumerate() {
            if self.cost == Cost::Time && ms > c.x.lo && ms < c.x.hi {
                let x = c.x.at(ms);
                let _ = writeln!(svg, "<path class=\"budget\" d=\"M{x:.1} {top}V{bottom}\"/>");
                // The two budgets lie close together: their names go to either side.
                let (class, x) = if k == 0 { ("hint end", x - 4.0) } else { ("hint", x + 4.0) };
                text(svg, class, x, top + 11.0, name);
            }
        }
        if let Some(floor) = self.noise_floor {
            let y = c.y.at(floor);
            let _ = writeln!(svg, "<path class=\"floor\" d=\"M{left} {y:.1}H{right}\"/>");
            // Without path tracing's line the right end is free, and controls stand at the left one.
            let (class, x) = if self.path_tracing.is_some() { ("hint", left + 6.0) } else { ("hint end", right - 6.0) };
            text(svg, class, x, y - 5.0, "noise of the truth");
        }
        let [error_limit, cost_limit] = self.limits;
        if let Some(y) = error_limit.map(|e| c.y.at(e)) {
            let _ = writeln!(svg, "<path class=\"limit\" d=\"M{left} {y:.1}H{right}\"/>");
            text(svg, "hint end", right - 6.0, y - 5.0, "largest error asked for");
        }
        if let Some(x) = cost_limit.map(|t| c.x.at(t)) {
            let _ = writeln!(svg, "<path class=\"limit\" d=\"M{x:.1} {top}V{bottom}\"/>");
            text(svg, "hint end", x - 4.0, top + 27.0, "most time asked for");
        }
        if let Some(at_one_ms) = self.path_tracing {
            draw_path_tracing(svg, c, at_one_ms);
        }
        let front = self.pareto_front();
        if front.len() > 1 {
            let path: String = front
                .iter()
                .enumerate()
                .map(|(k, p)| {
                    let (x, y) = (c.x.at(p.cost), c.y.at(p.error));
                    if k == 0 { format!("M{x:.1} {y:.1}") } else { format!("H{x:.1}V{y:.1}") }
                })
                .collect();
            let _ = writeln!(svg, "<path class=\"front\" d=\"{path}\"><title>Pareto front</title></path>");
        }
    }

    fn draw_points(&self, svg: &mut String, c: &Canvas) {
        let colours = colours(self.points.iter().map(|p| p.series.as_str()));
        for (series, colour) in &colours {
            let of_series: Vec<_> = self.points.iter().filter(|p| p.series == *series).collect();
            let path: Vec<_> =
                of_series.iter().map(|p| format!("{:.1} {:.1}", c.x.at(p.cost), c.y.at(p.error))).collect();
            if path.len() > 1 && !self.scattered {
                let _ = writeln!(svg, "<path class=\"series\" stroke=\"{colour}\" d=\"M{}\"/>", path.join("L"));
            }
        }
        let mut taken: Vec<Rect> =
            self.points.iter().flat_map(|p| [Rect::of_point(p, c), Rect::of_tail(p, c)]).collect();
        for p in &self.points {
            let colour = colours.iter().find(|(s, _)| *s == p.series).map_or(PALETTE[0], |(_, colour)| colour);
            let (x, y) = (c.x.at(p.cost), c.y.at(p.error));
            let tail = c.x.at(p.still_cost).max(58.0);
            let _ = writeln!(svg, "<g><title>{}</title>", escape(&self.tip(p)));
            if !p.link.is_empty() {
                let _ = writeln!(svg, "<a href=\"{}\">", escape(&p.link));
            }
            if x - tail > 8.0 && !p.control {
                let _ = writeln!(
                    svg,
                    "<path class=\"tail\" stroke=\"{colour}\" d=\"M{tail:.1} {:.1}v8m0 -4H{x:.1}\"/>",
                    y - 4.0
                );
            }
            if let Some([low, high]) = p.spread {
                let (low, high) = (c.x.at(low).max(58.0), c.x.at(high));
                let _ = writeln!(svg, "<path class=\"spread\" stroke=\"{colour}\" d=\"M{low:.1} {y:.1}H{high:.1}\"/>");
            }
            let _ = if p.control {
                writeln!(
                    svg,
                    "<path class=\"control\" stroke=\"{colour}\" d=\"M{x:.1} {:.1}l6 6l-6 6l-6 -6z\"/>",
                    y - 6.0
                )
            } else if p.under_noise {
                writeln!(svg, "<circle class=\"unranked\" stroke=\"{colour}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\"/>")
            } else {
                writeln!(svg, "<circle class=\"dot\" fill=\"{colour}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"6\"/>")
            };
            if !p.link.is_empty() {
                svg.push_str("</a>");
            }
            if !p.mark.is_empty() {
                place_label(svg, &mut taken, c, (x, y), &p.mark);
            }
            svg.push_str("</g>\n");
        }
    }

    /// What a point says when it is pointed at.
    fn tip(&self, p: &ChartPoint) -> String {
        let noise = if p.under_noise { " (within the truth's noise: not ranked)" } else { "" };
        let error = format!("{}: block NRMSE {}{noise}", p.label, number(p.error));
        match self.cost {
            Cost::Memory => format!("{error}, {}", bytes(p.cost as u64)),
            Cost::Time => format!(
                "{error}, {} per frame with moving lights, {} with still ones",
                milliseconds(p.cost),
                milliseconds(p.still_cost)
            ),
        }
    }
}

/// The line of path tracing: four times the time for half the error.
fn draw_path_tracing(svg: &mut String, c: &Canvas, at_one_ms: f64) {
    // Within the picture in both directions.
    let time_of = |error: f64| (at_one_ms / error).powi(2);
    let (from, to) = (c.x.lo.max(time_of(c.y.hi)), c.x.hi.min(time_of(c.y.lo)));
    if at_one_ms > 0.0 && from < to {
        let at = |ms: f64| (c.x.at(ms), c.y.at(at_one_ms / ms.sqrt()));
        let ((x0, y0), (x1, y1)) = (at(from), at(to));
        let _ = writeln!(
            svg,
            "<path class=\"paths\" d=\"M{x0:.1} {y0:.1}L{x1:.1} {y1:.1}\"><title>plain path tracing: error for a time</title></path>"
        );
        // Below the names of the frame budgets, left of the line.
        const DOWN_PX: f64 = 34.0;
        let down = DOWN_PX.min((y1 - y0).abs());
        let along = if (y1 - y0).abs() > 1.0 { down / (y1 - y0).abs() } else { 0.0 };
        let x = x0 + along * (x1 - x0) - 8.0;
        let (class, x) = if x > 180.0 { ("hint end", x) } else { ("hint", x + 20.0) };
        text(svg, class, x, y0 + down, "plain path tracing");
    }
}

const SVG_NAMESPACE: &str = "http://www.w3.org/2000/svg";

/// Names of the colours, and their values on light and on dark ground.
const COLOUR_NAMES: [(&str, &str); 5] =
    [("--bg", "#ffffff"), ("--fg", "#1c2026"), ("--mute", "#667080"), ("--line", "#e4e7ec"), ("--front", "#9aa3b2")];

const COLOURS: &str = "\
.tae{--bg:#fff;--fg:#1c2026;--mute:#667080;--line:#e4e7ec;--front:#9aa3b2}\
@media(prefers-color-scheme:dark){.tae{--bg:#171a1f;--fg:#e8eaee;--mute:#98a1b0;--line:#2b3038;--front:#6b7585}}";

/// The style without variables.
fn plain_style() -> String {
    COLOUR_NAMES.iter().fold(STYLE.to_string(), |css, (name, value)| css.replace(&format!("var({name})"), value))
}

const STYLE: &str = "\
.tae{font-size:12px;font-family:system-ui,-apple-system,'Segoe UI',Roboto,Ubuntu,sans-serif}\
.tae .bg{fill:var(--bg)}.tae text{fill:var(--fg)}.tae .tick,.tae .hint{fill:var(--mute);font-size:11px}\
.tae .name{font-weight:600}.tae .mid{text-anchor:middle}.tae .end{text-anchor:end}\
.tae .label{font-weight:600;paint-order:stroke;stroke:var(--bg);stroke-width:4px;stroke-linejoin:round}\
.tae path{fill:none}.tae .grid{stroke:var(--line)}.tae .minor{stroke-dasharray:1 3}.tae .axis{stroke:var(--mute)}\
.tae .budget{stroke:var(--mute);stroke-dasharray:2 4}.tae .floor{stroke:var(--mute);stroke-dasharray:6 4}\
.tae .limit{stroke:var(--fg);stroke-dasharray:6 4}\
.tae .front{stroke:var(--front);stroke-width:8;stroke-linejoin:round;stroke-linecap:round;opacity:.3}\
.tae .series{stroke-width:1.5;opacity:.7}.tae .tail{stroke-width:1.5;opacity:.55}\
.tae .spread{stroke-width:5;opacity:.3;stroke-linecap:round}.tae .paths{stroke:var(--fg);stroke-dasharray:9 5;\
opacity:.55}.tae .unranked{fill:var(--bg);stroke-width:2;stroke-dasharray:3 2}\
.tae .dot{stroke:var(--bg);stroke-width:1.5}.tae .control{stroke-width:2;fill:var(--bg)}";

fn text(svg: &mut String, class: &str, x: f64, y: f64, words: &str) {
    let _ = writeln!(svg, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", escape(words));
}

#[derive(Clone, Copy)]
struct Rect {
    x0: f64,
    y0: f64,
    x1: f64,
    y1: f64,
}

impl Rect {
    fn of_point(p: &ChartPoint, c: &Canvas) -> Self {
        let (x, y) = (c.x.at(p.cost), c.y.at(p.error));
        Self { x0: x - 7.0, y0: y - 7.0, x1: x + 7.0, y1: y + 7.0 }
    }

    fn of_tail(p: &ChartPoint, c: &Canvas) -> Self {
        let y = c.y.at(p.error);
        let x0 = if p.control { c.x.at(p.cost) } else { c.x.at(p.still_cost) };
        Self { x0, y0: y - 3.0, x1: c.x.at(p.cost), y1: y + 3.0 }
    }

    fn overlap(&self, other: &Self) -> f64 {
        let w = self.x1.min(other.x1) - self.x0.max(other.x0);
        let h = self.y1.min(other.y1) - self.y0.max(other.y0);
        w.max(0.0) * h.max(0.0)
    }
}

/// Writes a label at the place around its point that hides the least of what is drawn already.
fn place_label(svg: &mut String, taken: &mut Vec<Rect>, c: &Canvas, (x, y): (f64, f64), label: &str) {
    const CHARACTER_PX: f64 = 7.0;
    let (w, h) = (label.chars().count() as f64 * CHARACTER_PX, 14.0);
    let corners = [
        (x + 10.0, y - 7.0),
        (x - 10.0 - w, y - 7.0),
        (x - w / 2.0, y - 24.0),
        (x - w / 2.0, y + 10.0),
        (x + 8.0, y - 22.0),
        (x + 8.0, y + 9.0),
        (x - 8.0 - w, y - 22.0),
        (x - 8.0 - w, y + 9.0),
    ];
    let inside = Rect { x0: 60.0, y0: 24.0, x1: c.width - 4.0, y1: c.height - 57.0 };
    let cost = |r: &Rect| {
        let outside = w * h - r.overlap(&inside);
        8.0 * outside + taken.iter().map(|t| t.overlap(r)).sum::<f64>()
    };
    let rects = corners.map(|(x0, y0)| Rect { x0, y0, x1: x0 + w, y1: y0 + h });
    if let Some(best) = rects.into_iter().min_by(|a, b| cost(a).total_cmp(&cost(b))) {
        text(svg, "label", best.x0, best.y0 + 11.0, label);
        taken.push(best);
    }
}

/// A tick's value without binary noise: 0.05, not 0.05000000000000001.
fn round_tick(value: f64) -> f64 {
    format!("{value:.0e}").parse().unwrap_or(value)
}

fn tick_ms(ms: f64) -> String {
    if ms < 1000.0 { format!("{} ms", round_tick(ms)) } else { format!("{} s", round_tick(ms / 1000.0)) }
}

fn tick_bytes(value: f64) -> String {
    const UNITS: [&str; 5] = ["B", "kB", "MB", "GB", "TB"];
    let unit = ((value.max(1.0).log10() / 3.0 + 1e-9) as usize).min(UNITS.len() - 1);
    format!("{} {}", round_tick(value / 1000.0_f64.powi(unit as i32)), UNITS[unit])
}
