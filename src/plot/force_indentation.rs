//! Force against the approach and its two shares, loading and unloading: the loops of Xie et al. (2024), Figs. 8 and 12.

use super::axis::Axis;
use super::canvas::Canvas;
use super::frame::Frame;
use super::key::{self, Entry};
use super::style::{DASHED, DOTTED, GREY, INK, Mark, SOLID, Stroke, series};
use super::{PlotError, SIZE};
use crate::impact::{Event, Impact, TraceRow};
use crate::report::human::{number, quantity};

/// One of the three loops.
struct Loop {
    name: &'static str,
    indentation: fn(&TraceRow) -> f64,
    width: f64,
    /// Where along each branch markers sit, so that loops on top of each other still show theirs.
    marks: [f64; 2],
}

/// The whole approach is drawn first and widest: with a rigid sphere the half-space's loop lies on it.
const LOOPS: [Loop; 3] = [
    Loop { name: "Approach δ", indentation: |row| row.indentation, width: 5.5, marks: [0.45, 0.85] },
    Loop { name: "Sphere δₛ", indentation: |row| row.sphere_indentation, width: 3.0, marks: [0.35, 0.75] },
    Loop { name: "Half-space δₕ", indentation: |row| row.half_space_indentation, width: 3.0, marks: [0.55, 0.65] },
];

/// The picture `force-indentation.png`. The trace is drawn as it is: some hundred samples make smooth curves.
///
/// # Errors
/// [`PlotError::Data`] for an impact without a trace; otherwise what drawing and encoding report.
pub fn force_indentation(impact: &Impact) -> Result<Vec<u8>, PlotError> {
    let trace = &impact.trace;
    let Some(turn) = trace.iter().position(|row| row.event == Some(Event::Peak)) else {
        return Err(PlotError::Data("force against indentation needs a trace: run the impact with samples".into()));
    };
    let (loading, unloading) = (&trace[..=turn], &trace[turn..]);
    let entries = entries(impact);
    let mut canvas = Canvas::try_new(SIZE)?;
    let frame = Frame {
        bounds: key::bounds(&entries)?,
        x: Axis::engineering("Indentation", "m")
            .between(0.0, 1.06 * impact.peak_indentation)
            .fitted(std::iter::empty()),
        y: Axis::engineering("Force", "N").between(0.0, 1.08 * impact.peak_force).fitted(std::iter::empty()),
    };
    frame.draw_axes(&mut canvas, true)?;

    let guide = Stroke { color: GREY, width: 2.0, dash: DOTTED };
    let peak = (impact.peak_indentation, impact.peak_force);
    frame.curve(&mut canvas, [(0.0, peak.1), peak, (peak.0, 0.0)].into_iter(), guide)?;
    frame.draw_outline(&mut canvas)?;
    for (i, one) in LOOPS.iter().enumerate() {
        let (stroke, mark) = series(i);
        for (part, dash) in [(loading, SOLID), (unloading, DASHED)] {
            let curve = part.iter().map(|row| ((one.indentation)(row), row.force));
            frame.curve(&mut canvas, curve, Stroke { dash, width: one.width, ..stroke })?;
            for share in one.marks {
                if let Some(row) = near_force(part, share * impact.peak_force) {
                    frame.mark(&mut canvas, ((one.indentation)(row), row.force), mark, 9.0, stroke.color)?;
                }
            }
        }
    }
    for row in trace.iter().filter(|row| matches!(row.event, Some(Event::Yield | Event::Knot))) {
        let is_yield = row.event == Some(Event::Yield);
        let (mark, radius) = if is_yield { (Mark::Diamond, 8.0) } else { (Mark::Circle, 4.0) };
        frame.mark(&mut canvas, (row.indentation, row.force), mark, radius, INK)?;
    }
    frame.mark(&mut canvas, peak, Mark::Square, 9.0, INK)?;
    if impact.has_dent() {
        frame.mark(&mut canvas, (impact.residual_indentation, 0.0), Mark::Inverted, 10.0, INK)?;
    }
    key::draw(&mut canvas, &entries, &frame)?;
    canvas.to_png()
}

/// The row of a branch whose force is nearest to `force`.
fn near_force(rows: &[TraceRow], force: f64) -> Option<&TraceRow> {
    rows.iter().min_by(|a, b| (a.force - force).abs().total_cmp(&(b.force - force).abs()))
}

fn entries(impact: &Impact) -> Vec<Entry> {
    let length = |value| quantity(value, "m");
    let mut entries: Vec<Entry> = LOOPS
        .iter()
        .enumerate()
        .map(|(i, one)| {
            let (stroke, mark) = series(i);
            let stroke = Stroke { dash: SOLID, width: one.width, ..stroke };
            Entry { mark: Some((mark, stroke.color)), ..Entry::line(one.name, stroke) }
        })
        .collect();
    let branch = |dash| Stroke { color: GREY, width: 3.0, dash };
    entries.push(Entry::line("loading", branch(SOLID)));
    entries.push(Entry::line("unloading", branch(DASHED)));
    let at_peak = format!("δₘ = {}", length(impact.peak_indentation));
    entries.push(
        Entry::mark("Peak", Mark::Square, INK).and(format!("Fₘ = {}", quantity(impact.peak_force, "N"))).and(at_peak),
    );
    if impact.has_dent() {
        let residual = format!("δᵣ = {}", length(impact.residual_indentation));
        entries.push(Entry::mark("Residual indentation", Mark::Inverted, INK).and(residual));
    }
    let has = |event| impact.trace.iter().any(|row| row.event == Some(event));
    if has(Event::Yield) {
        entries.push(Entry::mark("First yield", Mark::Diamond, INK));
    }
    if has(Event::Knot) {
        entries.push(Entry::mark("Knot of the law", Mark::Circle, INK));
    }
    let speed = format!("impact at {}", quantity(impact.speed, "m/s"));
    entries.push(Entry::text(&format!("Restitution e = {}", number(impact.restitution))).and(speed));
    entries
}
