//! Curves in pictures are read back as a reader does, by the labels of the axes, and are the numbers of the table beside them.

use super::drawn::*;
use crate::common::prelude::*;

/// One curve: the scenario that draws it, its picture, box and colour, and its table and columns.
struct Curve {
    scenario: String,
    picture: &'static str,
    panel: usize,
    color: &'static str,
    table: &'static str,
    columns: [&'static str; 2],
}

fn curves() -> Vec<Curve> {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let sweep = format!("{STEEL}[sweep]\n\"impact.speed\" = {{ logspace = [0.01, 10], points = 9 }}\n");
    let friction = "[friction]\ncoefficient = 0.1\n";
    let angle = STEEL.replace("3 m/s\"", "3 m/s\"\nangle = \"30 deg\"") + friction;
    let angles =
        format!("{STEEL}{friction}[sweep]\n\"impact.angle\" = {{ linspace = [\"5 deg\", \"85 deg\"], points = 17 }}\n");
    let shots = format!("{still}[repeat]\nspeeds = [1, 2, 5, 3]\nspot = \"fresh\"\n");
    let cycles = format!(
        "{still}[indentation]\nsteps = [{{ load = 100 }}, {{ load = 20 }}, {{ load = 150 }}, {{ load = 0 }}]\n"
    );
    let drops = still.replace("yield_strength = \"345 MPa\"\n", "")
        + "[calibrate]\ndata = \"d.csv\"\n[calibrate.free]\n\"half_space.yield_strength\" = { from = \"100 MPa\", to = \"1 GPa\" }\n";
    let curve = |scenario: &str, picture, panel, color, table, columns| Curve {
        scenario: scenario.to_owned(),
        picture,
        panel,
        color,
        table,
        columns,
    };
    vec![
        curve(&sweep, "restitution", 0, BLUE, "table", ["impact_speed_m_per_s", "restitution"]),
        curve(&angles, "rebound", 0, BLUE, "table", ["impact_angle_rad", "rebound_angle_deg"]),
        curve(&angles, "rebound", 1, BLUE, "table", ["impact_angle_rad", "rebound_spin_rad_per_s"]),
        curve(&shots, "impacts", 0, ORANGE, "impacts", ["impact", "impact_speed_m_per_s"]),
        curve(&shots, "impacts", 1, BLUE, "impacts", ["impact", "restitution"]),
        curve(&shots, "impacts", 2, VERMILLION, "impacts", ["impact", "residual_indentation_m"]),
        curve(STEEL, "force_indentation", 0, BLUE, "trace", ["indentation_m", "force_N"]),
        curve(STEEL, "force_indentation", 0, GREEN, "trace", ["half_space_indentation_m", "force_N"]),
        curve(STEEL, "force_indentation", 1, VERMILLION, "trace", ["sphere_indentation_m", "force_N"]),
        curve(STEEL, "history", 0, PURPLE, "trace", ["time_s", "force_N"]),
        curve(STEEL, "history", 1, BLUE, "trace", ["time_s", "indentation_m"]),
        curve(STEEL, "history", 1, VERMILLION, "trace", ["time_s", "sphere_indentation_m"]),
        curve(STEEL, "history", 1, GREEN, "trace", ["time_s", "half_space_indentation_m"]),
        curve(STEEL, "history", 2, ORANGE, "trace", ["time_s", "speed_m_per_s"]),
        curve(&angle, "friction", 0, PURPLE, "trace", ["time_s", "friction_force_N"]),
        curve(&angle, "friction", 1, VERMILLION, "trace", ["time_s", "slip_speed_m_per_s"]),
        curve(&angle, "friction", 2, GREEN, "trace", ["time_s", "spin_rad_per_s"]),
        curve(&cycles, "force_indentation", 0, BLUE, "trace", ["indentation_m", "force_N"]),
        curve(&drops, "fit_restitution", 0, VERMILLION, "residuals", ["impact_speed_m_per_s", "predicted"]),
    ]
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

#[test]
fn curves_show_the_numbers_of_their_tables() {
    let mut wrong = Vec::new();
    for Curve { scenario, picture, panel, color, table, columns } in curves() {
        let desk = Desk::with(scenario);
        desk.put("d.csv", "speed_m_per_s,restitution\n0.5,0.72\n1,0.63\n2,0.55\n4,0.47\n");
        desk.ends(&["run", "s.toml", "--out", "out", "--pictures", "svg"], 0);
        let drawn = Drawn(desk.read(&format!("out/{picture}.svg")));
        let scales = drawn.scales(panel);
        let text = desk.read(&format!("out/{table}.csv"));
        let [across, upward] = [0, 1].map(|axis| -> Vec<f64> {
            let in_degrees = if columns[axis].ends_with("_rad") { 180.0 / std::f64::consts::PI } else { 1.0 };
            numbers(&text, columns[axis]).iter().map(|value| scales[axis].place(value * in_degrees)).collect()
        });
        let rows: Vec<(f64, f64)> = across.into_iter().zip(upward).collect();
        let [left, top, right, bottom] = drawn.boxes()[panel];
        let curve: Vec<(f64, f64)> = drawn
            .shares_of(color, panel)
            .into_iter()
            .map(|(x, y)| (left + x * (right - left), bottom - y * (bottom - top)))
            .filter(|(_, y)| (top - 1.0..bottom + 1.0).contains(y))
            .collect();
        assert!(rows.len() > 3 && curve.len() > 3, "{picture} {panel} {columns:?}: {} {}", rows.len(), curve.len());
        // every row is on the curve; the law of a calibration has more points than the data
        let far =
            |rows: &[(f64, f64)], line: &[(f64, f64)]| rows.iter().map(|at| distance(*at, line)).fold(0.0, max_or_nan);
        let off = if table == "residuals" { far(&rows, &curve) } else { far(&rows, &curve).max(far(&curve, &rows)) };
        // two pixels of 750
        wrong.extend((off >= 2.0 * UNITS).then(|| format!("{picture} {panel} {columns:?}: {off}")));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// An oblique impact has the whole speed and the angle in the titles of all its pictures.
#[test]
fn titles_have_the_angle_and_the_whole_speed() {
    let desk = Desk::with(STEEL.replace("3 m/s\"", "3 m/s\"\nangle = \"30 deg\"") + "[friction]\ncoefficient = 0.1\n");
    desk.ends(&["run", "s.toml", "--out", "out", "--pictures", "svg"], 0);
    for picture in ["force_indentation", "history", "friction"] {
        let texts = Drawn(desk.read(&format!("out/{picture}.svg"))).texts();
        assert!(texts.iter().any(|text| text.starts_with("Impact at 3 m/s and 30°: ")), "{picture}: {texts:?}");
    }
}
