//! Pictures are read back as a reader does, by the labels of the axes: lines, markers and areas are the numbers of the tables
//! beside them, or of the references. Every function of the program that makes a picture is named here.

mod calibration;
mod kinds;
mod runs;
pub mod validation;

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::svg_reader::*;
use crate::common::prelude::*;

type Points = Vec<(f64, f64)>;
type TableRow = BTreeMap<String, String>;

/// How numbers are drawn, and in which colour.
#[derive(Debug, Clone, Copy)]
enum Form {
    /// A line from row to row.
    Line(&'static str),
    /// A line through all rows, which has more points than they.
    Through(&'static str),
    /// A marker on every row, and no other.
    Marks(&'static str),
    /// The outline of an area.
    Area(&'static str),
}

use Form::{Area, Line, Marks, Through};

/// The files that a run wrote, by name. Their folder is gone.
pub struct Results(BTreeMap<String, String>);

impl Results {
    /// The files of the folder `out`, all of which are text.
    fn of(desk: &Sandbox) -> Self {
        let read = |name: String| (name.clone(), desk.read(&format!("out/{name}")));
        Self(desk.files("out").into_iter().map(read).collect())
    }

    pub fn read(&self, name: &str) -> &str {
        self.0.get(name).unwrap_or_else(|| panic!("{name}"))
    }

    fn picture(&self, name: &str) -> SvgPicture {
        SvgPicture(self.read(&format!("{name}.svg")).to_owned())
    }

    fn summary(&self) -> Value {
        serde_json::from_str(self.read("summary.json")).unwrap()
    }

    /// The names of the pictures.
    fn pictures(&self) -> impl Iterator<Item = &str> {
        self.0.keys().filter_map(|name| name.strip_suffix(".svg"))
    }
}

/// The content of one box of a picture.
struct Shown {
    /// File and function that make the picture.
    kind: &'static str,
    picture: &'static str,
    panel: usize,
    form: Form,
    /// The places of the rows, from the results of the run, in SI units.
    rows: Box<dyn Fn(&Results) -> Points + Send + Sync>,
}

/// A run, and what its pictures show.
struct Drawing {
    results: Results,
    shown: Vec<Shown>,
}

fn shown(
    kind: &'static str,
    picture: &'static str,
    panel: usize,
    form: Form,
    rows: impl Fn(&Results) -> Points + Send + Sync + 'static,
) -> Shown {
    Shown { kind, picture, panel, form, rows: Box::new(rows) }
}

/// The rows of a table of a run, or of a reference, that have these words in these columns.
fn table(results: &Results, name: &str, only: &[(&str, &str)]) -> Vec<TableRow> {
    let reference = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("src/reference/{name}.csv"));
    let text = fs::read_to_string(reference).unwrap_or_else(|_| results.read(&format!("{name}.csv")).to_owned());
    let mut rows = records::<TableRow>(&text);
    rows.retain(|row| only.iter().all(|(column, word)| row[*column] == *word));
    rows
}

/// A number of a row, with angles in degrees as pictures have them.
fn cell(row: &TableRow, column: &str) -> f64 {
    let in_degrees = if column.ends_with("_rad") { 180.0 / std::f64::consts::PI } else { 1.0 };
    in_degrees * row[column].parse::<f64>().unwrap_or(f64::NAN)
}

/// Two columns of a table.
fn columns(
    name: &'static str,
    only: &'static [(&'static str, &'static str)],
    [x, y]: [&'static str; 2],
) -> impl Fn(&Results) -> Points + Send + Sync {
    move |results| table(results, name, only).iter().map(|row| (cell(row, x), cell(row, y))).collect()
}

/// How far a place is from a line through places.
fn distance((x, y): (f64, f64), line: &[(f64, f64)]) -> f64 {
    let from = |a: (f64, f64), b: (f64, f64)| {
        let (along, up) = (b.0 - a.0, b.1 - a.1);
        let share = ((x - a.0) * along + (y - a.1) * up) / (along * along + up * up).max(1e-300);
        let share = share.clamp(0.0, 1.0);
        (a.0 + share * along - x).hypot(a.1 + share * up - y)
    };
    line.windows(2).map(|pair| from(pair[0], pair[1])).fold(f64::INFINITY, f64::min)
}

/// How far a place is from the nearest of these.
fn nearest((x, y): (f64, f64), marks: &[(f64, f64)]) -> f64 {
    marks.iter().map(|at| (at.0 - x).hypot(at.1 - y)).fold(f64::INFINITY, f64::min)
}

/// The mistake in the content of a picture.
fn fault(results: &Results, Shown { picture, panel, form, rows, .. }: &Shown) -> Option<String> {
    let drawn = results.picture(picture);
    let (scales, panel) = (drawn.scales(*panel), *panel);
    // what lies beyond the axes is not drawn
    let is_in = drawn.is_in(panel);
    let seen = |points: Points| points.into_iter().filter(|at| is_in(*at)).collect::<Points>();
    let rows = seen(rows(results).into_iter().map(|(x, y)| (scales[0].place(x), scales[1].place(y))).collect());
    let far = |points: &Points, from: &dyn Fn((f64, f64)) -> f64| points.iter().map(|at| from(*at)).fold(0.0, nan_max);
    let (drawn, off) = match *form {
        Line(color) | Through(color) => {
            let line = seen(drawn.lines(color).concat());
            let back = if matches!(form, Line(_)) { far(&line, &|at| distance(at, &rows)) } else { 0.0 };
            (line.len(), far(&rows, &|at| distance(at, &line)).max(back))
        }
        Marks(color) => {
            let marks = seen(drawn.marks(color));
            (marks.len(), far(&rows, &|at| nearest(at, &marks)).max(far(&marks, &|at| nearest(at, &rows))))
        }
        Area(color) => {
            let outline = drawn.areas(color).concat();
            (outline.len(), far(&rows, &|at| distance(at, &outline)))
        }
    };
    // two pixels of 750
    let is_right = !rows.is_empty() && drawn > 0 && off < 2.0 * UNITS;
    (!is_right).then(|| format!("{picture} {panel} {form:?}: {} rows, {drawn} drawn, off by {off}", rows.len()))
}

/// Runs a scenario, with its pictures as SVG, in a folder that has the data of a calibration.
fn drawing(scenario: impl AsRef<[u8]>, shown: Vec<Shown>) -> Drawing {
    let desk = Sandbox::with(scenario);
    desk.write("d.csv", calibration::DATA);
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "svg"], 0);
    Drawing { results: Results::of(&desk), shown }
}

fn check(drawings: &[Drawing]) {
    let faults =
        drawings.iter().flat_map(|Drawing { results, shown }| shown.iter().filter_map(|one| fault(results, one)));
    let faults: Vec<String> = faults.collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

/// An oblique impact has the whole speed and the angle in the titles of all its pictures.
#[test]
fn titles_have_the_angle_and_the_whole_speed() {
    let desk =
        Sandbox::with(STEEL.replace("3 m/s\"", "3 m/s\"\nangle = \"30 deg\"") + "[friction]\ncoefficient = 0.1\n");
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "svg"], 0);
    for picture in ["force_indentation", "history", "friction"] {
        let texts = SvgPicture(desk.read(&format!("out/{picture}.svg"))).texts();
        assert!(texts.iter().any(|text| text.starts_with("Impact at 3 m/s and 30°: ")), "{picture}: {texts:?}");
    }
}
