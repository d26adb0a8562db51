//! The tables of `scenarios/comparison.md`: one scenario at three speeds, by this law, by other laws and codes, and by finite
//! elements. `UPDATE=1` writes them anew.

use plm_impact::reference::quasi_static::load_cycles;
use plm_impact::reference::{IMPACTS, ReferenceRow};
use plm_impact::strings::markdown_table;

use crate::common::golden::assert_golden_part;
use crate::common::prelude::*;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/comparison.md");
const SCENARIO: &str = include_str!("../../../scenarios/steel-on-steel.toml");
/// Results of LAMMPS; `tests/lammps/test_mdr.py` writes and checks them.
const MDR: &str = include_str!("../../reference/mdr.csv");
const SPEEDS: [f64; 3] = [0.3, 3.0, 20.0];
/// The speed at which the two constants of the springs are fitted.
const FITTED: f64 = 3.0;
/// Load cycles of case 3 with the finest elements at each depth: run and cycle in `fe_unloading.csv`. Its sphere has 208 GPa.
const CYCLES: [(&str, f64); 5] = [
    ("case3_mini", 2.0),
    ("case3_small", 4.0),
    ("case3_small", 5.0),
    ("case3_large_finesteps", 1.0),
    ("case3_large_finesteps", 2.0),
];

/// One line of a table; some references lack a quantity.
struct Line {
    name: &'static str,
    restitution: f64,
    contact_time: Option<f64>,
    peak_force: f64,
    dent_depth: f64,
}

impl Line {
    fn of(name: &'static str, impact: &Impact) -> Self {
        let dent_depth = impact.row.residual_indentation;
        let (restitution, peak_force) = (impact.row.restitution, impact.row.peak_force);
        Self { name, restitution, contact_time: Some(impact.row.contact_time), peak_force, dent_depth }
    }

    fn cells(&self, reference: &Self) -> Vec<String> {
        let deviation = 100.0 * (self.restitution / reference.restitution - 1.0);
        let deviation = if deviation == 0.0 { "–".to_owned() } else { signed(deviation) };
        let time = self.contact_time.map_or("–".to_owned(), |time| format!("{:.1} µs", 1e6 * time));
        let [force, dent] = [self.peak_force, 1e6 * self.dent_depth].map(three_digits);
        let e = format!("{:.3}", self.restitution);
        vec![self.name.to_owned(), e, deviation, time, format!("{force} N"), format!("{dent} µm")]
    }
}

fn signed(percent: f64) -> String {
    let size = format!("{:.1} %", percent.abs());
    let sign = if percent < 0.0 { '−' } else { '+' };
    if size == "0.0 %" { size } else { format!("{sign}{size}") }
}

fn three_digits(value: f64) -> String {
    let unit = 10_f64.powf(value.log10().floor() - 2.0);
    let rounded = (value / unit).round() * unit;
    format!("{rounded:.*}", if rounded < 10.0 { 2 } else { usize::from(rounded < 100.0) })
}

/// The bodies of the scenario under a law.
fn contact_of(law: &dyn ContactLaw) -> Contact {
    let contact = contact(SCENARIO, NO_OVERRIDES);
    Contact::try_new(*contact.sphere(), *contact.half_space(), law).unwrap()
}

fn by_law(name: &'static str, law: &dyn ContactLaw, speed: f64) -> Line {
    Line::of(name, &contact_of(law).closed_form(speed).unwrap())
}

fn this_law() -> Plm {
    Plm { exponent: UnloadingExponent::PressureShape, ..Plm::default() }
}

/// This law, with the strength of the half-space given to the sphere.
fn ball_yields(name: &'static str, speed: f64) -> Line {
    let contact = contact_of(&this_law());
    let strength = contact.half_space().yield_strength;
    let sphere = Sphere { yield_strength: strength, ..*contact.sphere() };
    let half_space = HalfSpace { yield_strength: None, ..*contact.half_space() };
    let contact = Contact::try_new(sphere, half_space, &this_law()).unwrap();
    Line::of(name, &contact.closed_form(speed).unwrap())
}

/// A spring of two straight lines, k_1 δ and k_2 (δ − δ_0), with the peak force and e of this law at the fitted speed. LIGGGHTS
/// (`normal_model_hooke_hysteresis.h`, without adhesion and damping): k_2 rises linearly from k_1 with the largest overlap,
/// which is proportional to the speed; below its largest value k_2/k_1 = 1 + c v.
fn spring(name: &'static str, speed: f64, k2_rises: bool) -> Line {
    let contact = contact_of(&this_law());
    let fitted = contact.closed_form(FITTED).unwrap();
    let (yield_indentation, yield_force) = contact.yield_indentation_and_force().unwrap();
    let mass = contact.mass();
    let k1 = (fitted.row.peak_force / FITTED).powi(2) / mass;
    let excess = (fitted.row.restitution.powi(-2) - 1.0) * if k2_rises { speed / FITTED } else { 1.0 };
    let law =
        WaltonBraun { loading_stiffness: k1 * yield_indentation / yield_force, stiffness_ratio: 1.0 / (1.0 + excess) };
    let line = by_law(name, &law, speed);
    // closed form of two quarter waves
    let time = 0.5 * std::f64::consts::PI * (mass / k1).sqrt() * (1.0 + law.stiffness_ratio.sqrt());
    assert_relative_eq!(line.contact_time.unwrap(), time, max_relative = 1e-9);
    assert_relative_eq!(line.restitution, law.stiffness_ratio.sqrt(), max_relative = 1e-9);
    line
}

/// The value at `at` of a power law through the two nodes around it.
fn interpolated(nodes: &[(f64, f64)], at: f64) -> f64 {
    let i = nodes.windows(2).position(|pair| (pair[0].0..=pair[1].0).contains(&at)).unwrap();
    let [(x0, y0), (x1, y1)] = [nodes[i], nodes[i + 1]];
    y0 * (y1 / y0).powf((at / x0).ln() / (x1 / x0).ln())
}

/// Finite elements: load cycles in which as much work is spent, in units of first yield, as the ball has energy at this speed.
fn load_cycle(name: &'static str, speed: f64) -> Line {
    let cycles: Vec<&ReferenceRow> = CYCLES
        .iter()
        .map(|(run, cycle)| {
            let is_it = |row: &&ReferenceRow| row.cell_text("run") == *run && row.number("cycle") == *cycle;
            load_cycles().map(|(_, _, row)| row).find(is_it).unwrap()
        })
        .collect();
    let contact = contact_of(&this_law());
    let (yield_indentation, yield_force) = contact.yield_indentation_and_force().unwrap();
    let (scale, mass) = (yield_force * yield_indentation, contact.mass());
    let spent = 0.5 * mass * speed * speed / scale;
    let at_speed = |value: &dyn Fn(&ReferenceRow) -> f64| {
        let nodes: Vec<_> = cycles.iter().map(|row| (row.number("spent"), value(row))).collect();
        interpolated(&nodes, spent)
    };
    // interpolation alone changes e of the law by less than 1 %
    let by_nodes = at_speed(&|row| {
        contact.closed_form((2.0 * row.number("spent") * scale / mass).sqrt()).unwrap().row.restitution
    });
    assert_relative_eq!(by_nodes, contact.closed_form(speed).unwrap().row.restitution, max_relative = 1e-2);
    Line {
        name,
        restitution: at_speed(&|row| row.number("restitution")),
        contact_time: None,
        peak_force: at_speed(&|row| row.number("f")) * yield_force,
        dent_depth: at_speed(&|row| row.number("residual_share") * row.number("x")) * yield_indentation,
    }
}

/// Explicit finite elements of the whole impact D1, at 3 m/s.
fn whole_impact(name: &'static str) -> Line {
    let rows = IMPACTS.rows().unwrap();
    let row = rows.iter().find(|row| row.cell_text("case") == "D1").unwrap();
    Line {
        name,
        restitution: row.number("restitution"),
        contact_time: Some(row.number("contact_time_s")),
        peak_force: row.number("peak_force_N"),
        dent_depth: row.number("residual_indentation_m"),
    }
}

fn mdr(name: &'static str, speed: f64) -> Line {
    let rows = crate::common::reference::rows(MDR);
    let row = rows.iter().find(|row| row.number("speed_m_per_s") == speed).unwrap();
    Line {
        name,
        restitution: row.number("restitution"),
        contact_time: Some(row.number("contact_time_s")),
        peak_force: row.number("peak_force_N"),
        dent_depth: row.number("dent_depth_m"),
    }
}

fn table(speed: f64) -> String {
    let reference = load_cycle("finite elements, load cycle of equal energy", speed);
    let mut lines = vec![
        by_law("this law (`plm`, `\"pressure-shape\"`)", &this_law(), speed),
        ball_yields("this law, if the ball yields instead of the block", speed),
        mdr("LAMMPS, `mdr` (the ball yields)", speed),
        by_law("Thornton (`thornton`)", &Thornton::default(), speed),
        spring("spring with constant k_2 (`walton_braun`)", speed, false),
        spring("spring with rising k_2 (LIGGGHTS, `hooke/hysteresis`)", speed, true),
    ];
    if speed == FITTED {
        lines.insert(0, whole_impact("finite elements, whole impact, with waves"));
    }
    let head = ["", "e", "e against the load cycle", "contact time", "peak force", "dent depth"].map(str::to_owned);
    let mut rows = vec![head.to_vec(), reference.cells(&reference)];
    rows.extend(lines.iter().map(|line| line.cells(&reference)));
    markdown_table(&rows)
}

#[test]
fn comparison_page_shows_computed_numbers() {
    let tables: Vec<String> = SPEEDS.iter().map(|speed| format!("### {speed} m/s\n\n{}", table(*speed))).collect();
    assert_golden_part(Path::new(PAGE), "comparison", &tables.join("\n"));
}
