//! Pictures of impacts, sweeps, random cases, bounces and indentations.

use super::*;

/// The pale colours of areas: 35 % of blue, vermillion and sky blue on white.
const PALE_BLUE: &str = "#A6CEE4";
const PALE_VERMILLION: &str = "#F0C7A6";
pub const PALE_SKY: &str = "#C4E5F7";

const GRAVITY: &str = "[gravity]\nacceleration = 9.81\n";
const FRICTION: &str = "[friction]\ncoefficient = 0.1\n";

fn still() -> String {
    STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "")
}

fn oblique() -> String {
    STEEL.replace("3 m/s\"", "3 m/s\"\nangle = \"30 deg\"") + FRICTION
}

fn impacts() -> Vec<Drawing> {
    let loops = "force_indentation::force_indentation";
    let history = |panel, form, column| {
        shown("history::history", "history", panel, form, columns("trace", &[], ["time_s", column]))
    };
    let slip = |panel, form, column| {
        shown("friction::friction", "friction", panel, form, columns("trace", &[], ["time_s", column]))
    };
    let force = |panel, form, column| {
        shown(loops, "force_indentation", panel, form, columns("trace", &[], [column, "force_N"]))
    };
    vec![
        drawing(
            STEEL,
            vec![
                force(0, Line(BLUE), "indentation_m"),
                force(0, Line(GREEN), "half_space_indentation_m"),
                force(0, Line(VERMILLION), "sphere_indentation_m"),
                history(0, Line(PURPLE), "force_N"),
                history(1, Line(BLUE), "indentation_m"),
                history(1, Line(VERMILLION), "sphere_indentation_m"),
                history(1, Line(GREEN), "half_space_indentation_m"),
                history(2, Line(ORANGE), "speed_m_per_s"),
            ],
        ),
        drawing(
            oblique(),
            vec![
                slip(0, Line(PURPLE), "friction_force_N"),
                slip(1, Line(VERMILLION), "slip_speed_m_per_s"),
                slip(2, Line(GREEN), "spin_rad_per_s"),
            ],
        ),
    ]
}

/// The force of an impact over time and over frequency. The picture of the spectrum ends before the spectrum does.
fn pulses() -> Vec<Drawing> {
    let lines = |results: &Results| -> Points {
        let mut lines = columns("spectrum", &[], ["frequency_Hz", "force_spectrum_N_s"])(results);
        lines.retain(|(frequency, _)| (1.0..5e5).contains(frequency));
        lines
    };
    vec![drawing(
        format!("{STEEL}[output]\npulse = {{ step = \"50 ns\" }}\n"),
        vec![
            shown("pulse::pulse", "pulse", 0, Line(PURPLE), columns("pulse", &[], ["time_s", "force_N"])),
            shown("pulse::spectrum", "spectrum", 0, Through(PURPLE), lines),
        ],
    )]
}

/// The first curve is solid, and the second is dashed.
fn traces() -> Vec<Drawing> {
    let first = |kind, picture, column| {
        shown(kind, picture, 0, Line(BLUE), columns("traces", &[("case", "0")], [column, "force_N"]))
    };
    vec![drawing(
        format!("{STEEL}[output]\ntraces = true\n[sweep]\n\"impact.speed\" = [1, 3]\n"),
        vec![
            first("traces::charts", "force_time", "time_s"),
            first("traces::indentation_chart", "force_indentation", "indentation_m"),
        ],
    )]
}

fn sweeps() -> Vec<Drawing> {
    let speeds = "[sweep]\n\"impact.speed\" = { logspace = [0.01, 10], points = 9 }\n";
    let angles = "[sweep]\n\"impact.angle\" = { linspace = [\"5 deg\", \"85 deg\"], points = 17 }\n";
    let picture = "[output]\npicture = [\"restitution\", \"peak_force_N\"]\n";
    let curve = |picture, column| {
        shown("sweep::curve_chart", picture, 0, Line(BLUE), columns("table", &[], ["impact_speed_m_per_s", column]))
    };
    let rebound = |column| {
        shown("sweep::curve_chart", column, 0, Line(BLUE), columns("table", &[], ["impact_angle_rad", column]))
    };
    let rebounds = "[output]\npicture = [\"rebound_angle_deg\", \"rebound_spin_rad_per_s\"]\n";
    let bar = |at: f64, law: &'static str, color| {
        shown("sweep::column_chart", "restitution", 0, Area(color), move |results| {
            let rows = table(results, "table", &[("law", law)]);
            [at - 0.4, at, at + 0.4].map(|x| (x, cell(&rows[0], "restitution"))).into()
        })
    };
    let random = "[monte_carlo]\nsamples = 300\nseed = 3\n\"half_space.yield_strength\" = { normal = { mean = 345e6, sd = 20e6 } }\n";
    vec![
        drawing(
            format!("{STEEL}{speeds}{picture}"),
            vec![curve("restitution", "restitution"), curve("peak_force_N", "peak_force_N")],
        ),
        drawing(
            format!("{STEEL}{FRICTION}{angles}{rebounds}"),
            vec![rebound("rebound_angle_deg"), rebound("rebound_spin_rad_per_s")],
        ),
        drawing(
            format!("{STEEL}[sweep]\n\"law\" = [\"plm\", \"thornton\"]\n"),
            vec![bar(1.0, "plm", PALE_BLUE), bar(2.0, "thornton", PALE_VERMILLION)],
        ),
        drawing(
            format!("{STEEL}{random}"),
            vec![shown("histogram::histogram", "restitution_histogram", 0, Area(PALE_SKY), bins)],
        ),
    ]
}

/// The counts of e in 60 even bins from the least to the largest, at the middle of each.
fn bins(results: &Results) -> Points {
    let values = numbers(results.read("table.csv"), "restitution");
    let (low, high) = values.iter().fold((1.0_f64, 0.0_f64), |(low, high), e| (low.min(*e), high.max(*e)));
    let edge = |i: u32| low + (high - low) * f64::from(i) / 60.0;
    let count = |i: u32| values.iter().filter(|e| (edge(i)..edge(i + 1)).contains(e) || i == 59 && **e == high).count();
    #[allow(clippy::cast_precision_loss)] // a few hundred
    (0..60).map(|i| (0.5 * (edge(i) + edge(i + 1)), count(i) as f64)).collect()
}

fn repeats() -> Vec<Drawing> {
    let series = |panel, color, column| {
        shown("series::impacts_chart", "impacts", panel, Line(color), columns("impacts", &[], ["impact", column]))
    };
    let first_loop = |results: &Results| -> Points {
        let mut rows = table(results, "trace", &[("impact", "1")]);
        // a dashed line may end with a gap
        rows.retain(|row| cell(row, "force_N") > 20.0);
        rows.iter().map(|row| (-cell(row, "height_m"), cell(row, "force_N"))).collect()
    };
    // at rest on the way up and down: half the time of flight after the rebound, at the height of its energy
    let tops = |along: &'static str| {
        move |results: &Results| -> Points {
            let rows = table(results, "impacts", &[]);
            let top = |pair: &[TableRow]| {
                let speed = cell(&pair[0], "rebound_speed_m_per_s");
                (0.5 * (cell(&pair[0], along) + cell(&pair[1], along)), speed * speed / (2.0 * 9.81))
            };
            rows.windows(2).map(top).chain(rows.iter().map(|row| (cell(row, along), 0.0))).collect()
        }
    };
    let hits =
        |results: &Results| table(results, "impacts", &[]).iter().map(|row| (cell(row, "position_m"), 0.0)).collect();
    let places = |results: &Results| {
        let rows = table(results, "impacts", &[]);
        rows.iter().map(|row| (cell(row, "position_m"), cell(row, "cross_position_m"))).collect()
    };
    vec![
        drawing(
            format!("{}[repeat]\nspeeds = [1, 2, 5, 3]\nspot = \"fresh\"\n", still()),
            vec![
                series(0, ORANGE, "impact_speed_m_per_s"),
                series(1, BLUE, "restitution"),
                series(2, VERMILLION, "residual_indentation_m"),
                shown("series::loops_chart", "force_indentation", 0, Through(BLUE), first_loop),
            ],
        ),
        drawing(
            format!("{STEEL}{GRAVITY}[repeat]\nimpacts = 4\nspot = \"fresh\"\n"),
            vec![shown("series::height_chart", "height", 0, Through(BLUE), tops("time_s"))],
        ),
        drawing(
            format!("{}{GRAVITY}[repeat]\nimpacts = 4\nspot = \"fresh\"\n", oblique()),
            vec![
                shown("path::path_chart", "path", 0, Through(BLUE), tops("position_m")),
                shown("path::path_chart", "path", 0, Marks(VERMILLION), hits),
            ],
        ),
        drawing(
            format!(
                "{}{GRAVITY}[repeat]\nimpacts = 4\nspot = \"fresh\"\n",
                oblique().replacen("[sphere]\n", "[sphere]\nspin_about_path = 100\n", 1)
            ),
            vec![
                shown("path::path_from_above_chart", "path_from_above", 0, Through(BLUE), places),
                shown("path::path_from_above_chart", "path_from_above", 0, Marks(VERMILLION), places),
            ],
        ),
    ]
}

fn indentations() -> Vec<Drawing> {
    let steps = "[indentation]\nsteps = [{ load = 100 }, { load = 20 }, { load = 150 }, { load = 0 }]\n";
    let material = |name: &str, strength: &str| {
        format!(
            "[[indentation.half_space]]\nname = \"{name}\"\nyoungs_modulus = 2e11\npoissons_ratio = 0.3\nyield_strength = {strength}\n"
        )
    };
    let sphere = still().split("[half_space]").next().unwrap().to_owned();
    let of = |color, only| {
        shown(
            "indentation::indentation",
            "force_indentation",
            0,
            Line(color),
            columns("trace", only, ["indentation_m", "force_N"]),
        )
    };
    vec![
        drawing(still() + steps, vec![of(BLUE, &[])]),
        drawing(
            sphere + steps + &material("soft", "3e8") + &material("hard", "5e8"),
            vec![of(BLUE, &[("half_space", "soft")]), of(VERMILLION, &[("half_space", "hard")])],
        ),
    ]
}

pub static ALL: LazyLock<Vec<Drawing>> = LazyLock::new(|| {
    [impacts(), pulses(), traces(), sweeps(), repeats(), indentations()].into_iter().flatten().collect()
});

#[test]
fn run_pictures_show_numbers_of_tables() {
    check(&ALL);
}

/// The colour of each cell is that of its value on the bar beside the map.
#[test]
fn map_colours_are_values_of_table() {
    let axes = "\"impact.speed\" = { linspace = [1, 5], points = 9 }\n\"half_space.yield_strength\" = { linspace = [2e8, 6e8], points = 9 }\n";
    let Drawing { results, .. } = drawing(format!("{STEEL}[sweep]\n{axes}"), Vec::new());
    let drawn = results.picture("restitution_map");
    let ([x, y], scale, [left, _, right, _]) = (drawn.scales(0), drawn.upward(1), drawn.boxes()[1]);
    let steps: Vec<([f64; 4], [u8; 3])> =
        drawn.rectangles().into_iter().filter(|(ends, _)| ends[0] > left - 10.0 && ends[2] < right + 10.0).collect();
    assert_eq!(steps.len(), 256);
    // the value of the step of the bar with the nearest colour
    let value = |color: [u8; 3]| {
        let off = |step: &[u8; 3]| step.iter().zip(color).map(|(a, b)| u32::from(a.abs_diff(b))).sum::<u32>();
        let (ends, _) = steps.iter().min_by_key(|(_, step)| off(step)).unwrap();
        scale.value(0.5 * (ends[1] + ends[3]))
    };
    let rows = table(&results, "table", &[]);
    for row in &rows {
        let place = (x.place(cell(row, "impact_speed_m_per_s")), y.place(cell(row, "half_space_yield_strength_Pa")));
        let (e, shown) = (cell(row, "restitution"), value(drawn.fill_at(place)));
        // e goes over 1.05 in 256 steps
        assert!((shown - e).abs() < 1.5 * 1.05 / 256.0, "{row:?}: {shown}");
    }
    assert_eq!(rows.len(), 81);
}
