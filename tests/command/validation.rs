//! `plm-impact validate` as a process, also for a law that is made wrong on purpose. Its rows are compared with a
//! second, independent implementation of the law.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use plm_impact::validation::check::{Check, Group, Known, Tolerance, Verdict};
use plm_impact::validation::{self, report};

use crate::common::prelude::*;

const BUILT_IN: &str = include_str!("../../src/law/plm/coefficients.toml");

/// A row of a table, by column.
type Row = BTreeMap<String, String>;

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column} of {row:?}"))
}

#[test]
fn a_clean_checkout_passes_and_shows_it() {
    let desk = Desk::with("");
    let (table, _) = desk.ends(&["validate", "--out", "v"], 0);
    assert!(table.starts_with("quantity") && !table.contains("MISS"), "{table}");
    assert!(table.lines().all(|line| line.len() < 400), "{table}");
    // the known deviation is printed
    assert!(table.contains("known of the built-in law: load cycle: residual"), "{table}");

    let checks = records::<Row>(&desk.read("v/validation.csv"));
    // 4 quantities over 5 curves and 2 largest deviations each; 63 unloadings, of which 52 have a resolved dent and 59 a
    // known spent work; 3 impacts; 43 unloadings of metals that harden; 6 rebounds of Leeb devices; 8 tangential
    // restitutions, 7 spins, 9 angles and 14 slip speeds of oblique impacts; means and rms
    let expected = 30 + 4 * 63 + 52 + 2 * (59 + 2) + 3 * 8 + 5 * (43 + 1) + 6 + 1 + 8 + 7 + 9 + 14 + 4;
    assert_eq!(checks.len(), expected, "no group has vanished");
    for row in &checks {
        let (deviation, tolerance) = (number(row, "deviation"), number(row, "tolerance"));
        assert_eq!(row["verdict"] == "pass", deviation.abs() <= tolerance, "{row:?}");
        assert!(!row["reference"].is_empty() && !row["tolerance_source"].is_empty(), "{row:?}");
        if !row["expected"].is_empty() && !row["quantity"].contains("over peak") {
            let (expected, got) = (number(row, "expected"), number(row, "got"));
            // what may be 0, as a spin or a tangential restitution, is compared by difference
            let want = match row["quantity"].starts_with("oblique: ") {
                true => got - expected,
                false if expected == got => 0.0,
                false => got / expected - 1.0,
            };
            assert_relative_eq!(deviation, want, max_relative = 1e-9, epsilon = 1e-15);
        }
    }
    let page = desk.read("v/README.md");
    for row in &checks {
        // the statistics of a quantity stand in its row
        let quantity = row["quantity"].trim_end_matches(", mean").trim_end_matches(", rms");
        assert!(page.contains(&format!("| {quantity} |")), "{row:?}");
    }
    // every law stands beside the others, by how near its restitution is
    for law in LawChoice::all().iter().filter(|law| law.has_loading()) {
        assert!(page.contains(&format!("| {}", law.name())), "{}", law.name());
    }
    assert!(page.contains("| plm, pressure-shape | 62 |"), "{page}");
    // the files in the repository are those that the command writes
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/plots/validate")).unwrap() {
        let (name, kept) = (entry.as_ref().unwrap().file_name(), fs::read(entry.unwrap().path()).unwrap());
        let written = fs::read(desk.path("v").join(&name)).unwrap();
        assert!(kept == written, "{name:?} is stale: run `plm-impact validate --force`");
    }

    let is_picture = |name: &String| name.contains(".png");
    let pictures: Vec<String> = desk.files("v").into_iter().filter(is_picture).collect();
    for name in &pictures {
        let bytes = fs::read(desk.path("v").join(name)).unwrap();
        assert!(has_free_border(&bytes), "{name}");
        // there are blue points of the reference or of the first case
        let blue = pixels(&bytes).1.iter().filter(|pixel| **pixel == [0x00, 0x72, 0xb2]).count();
        assert!(blue > 100 || name == "error-restitution.png", "{name}: {blue}");
    }
    assert_eq!(pictures.len(), 11);
}

#[test]
fn another_law_misses_and_the_exit_code_says_so() {
    // the straight pieces are a tenth too steep
    let steeper = BUILT_IN.replace(
        "slope = [2.00, 2.29, 2.62, 3.04, 3.66, 4.32, 4.84, 5.60, 6.51]",
        "slope = [2.20, 2.52, 2.88, 3.34, 4.03, 4.75, 5.32, 6.16, 7.16]",
    );
    assert_ne!(steeper, BUILT_IN);
    let desk = Desk::with("");
    desk.put("steeper.toml", steeper);
    let arguments = ["validate", "--coefficients", "steeper.toml", "--out", "v", "--pictures", "none"];
    let (table, message) = desk.ends(&arguments, 3);
    assert!(table.contains("MISS: loading: force, rms over the curve: case 3"), "{table}");
    assert!(message.contains("checks missed their tolerance: see v/validation.csv"), "{message}");
    // the tables are written
    let checks = records::<Row>(&desk.read("v/validation.csv"));
    assert!(checks.iter().any(|row| row["verdict"] == "MISS"));
    // deviations that are known for the built-in law are misses for another law
    assert!(checks.iter().all(|row| row["verdict"] != "known"), "{table}");
    assert!(!table.contains("built-in law"), "{table}");
}

#[test]
fn a_deviation_that_is_no_number_is_the_largest_and_a_miss() {
    for place in 0..3 {
        let mut deviations = [0.1, -0.3, 0.2];
        assert_eq!(largest(deviations.into_iter()), -0.3);
        deviations[place] = f64::NAN;
        assert!(largest(deviations.into_iter()).is_nan(), "{place}");
        let worst = deviations.into_iter().fold(0.0, max_or_nan);
        assert!(worst.is_nan(), "{place}");
    }
    assert_eq!([0.1, 0.3, 0.2].into_iter().fold(0.0, max_or_nan), 0.3);
    let tolerance = Tolerance::stated(1e300, "none");
    let check = Group::of("mean", "none", "", tolerance).check_of(String::new(), f64::NAN);
    let known = Some(Known { limit: f64::INFINITY, remark: "" });
    assert_eq!(Check { known, ..check }.verdict(), Verdict::Miss);
}

#[test]
fn a_row_passes_up_to_its_tolerance_and_is_known_up_to_what_is_on_record() {
    let with = |got: f64, known: Option<Known>| Check {
        known,
        ..Group::of("q", "r", "N", Tolerance::stated(0.25, "test")).check("c".into(), [2.0, got])
    };
    let known = Some(Known { limit: 0.5, remark: "test" });
    for (got, known, want) in [
        (2.5, None, Verdict::Pass),
        (1.5, None, Verdict::Pass),
        (2.6, None, Verdict::Miss),
        (1.4, None, Verdict::Miss),
        (2.6, known, Verdict::Known),
        (1.0, known, Verdict::Known),
        (3.1, known, Verdict::Miss),
        (f64::NAN, known, Verdict::Miss),
    ] {
        assert_eq!(with(got, known).verdict(), want, "{got}");
    }
    let table = report::table(&[with(2.6, None), with(2.6, known)]);
    assert!(table.contains("MISS: 1") && table.contains("1 of 2 checks MISSED"), "{table}");
}

/// A second implementation of the PLM: plain sums, bisection instead of formulas for roots, the trapezoidal rule
/// instead of closed forms.
struct Second {
    table: toml::Table,
    /// Knots of the force, and the two parts of its slopes.
    force: [Vec<f64>; 3],
    kappa: f64,
    a_y: f64,
}

fn list(table: &toml::Table, of: &str, key: &str) -> Vec<f64> {
    table[of][key].as_array().unwrap().iter().map(|value| value.as_float().unwrap()).collect()
}

impl Second {
    /// The law of the bodies in the comment lines of a loading curve.
    fn of(curve: &str) -> Self {
        let value = |key: &str| -> f64 {
            let line = curve.lines().find_map(|line| line.strip_prefix(&format!("# {key} = "))).unwrap();
            line.split(' ').next().unwrap().parse().unwrap()
        };
        let [sphere, half_space] = ["sphere", "half_space"].map(|body| value(&format!("{body}.youngs_modulus")));
        Self::new(sphere, half_space, value("half_space.yield_strength"))
    }

    /// The law of these moduli \[GPa\] and this strength \[MPa\].
    fn new(sphere: f64, half_space: f64, strength: f64) -> Self {
        let (e_s, e_h) = (sphere / 0.91, half_space / 0.91);
        let e_star = e_s * e_h / (e_s + e_h);
        // C_ν = 1.61316 at ν = 0.3
        let a_y = std::f64::consts::PI * 1.613_160_7 * 1e-3 * strength / (2.0 * e_star);
        let table = toml::from_str(BUILT_IN).unwrap();
        let force = ["from", "slope", "slope_kappa_squared"].map(|key| list(&table, "force", key));
        Self { table, force, kappa: e_star / e_s, a_y }
    }

    fn one(&self, key: &str) -> f64 {
        self.table["elastic_approach"][key].as_float().unwrap()
    }

    fn force(&self, x: f64) -> f64 {
        let [from, slope, extra] = &self.force;
        let mut force = x.min(from[0]).powf(1.5);
        for i in 0..from.len() {
            let end = from.get(i + 1).copied().unwrap_or(f64::INFINITY);
            force += (slope[i] + self.kappa.powi(2) * extra[i]) * (x.min(end) - from[i]).max(0.0);
        }
        force
    }

    /// ε at A on the polyline, summed in small steps.
    fn line(&self, a: f64) -> f64 {
        let k2 = self.kappa.powi(2);
        let first =
            (self.one("first_slope") + self.one("first_slope_kappa_squared") * k2).min(self.one("first_slope_limit"));
        let plastic = self.one("plastic_slope") + self.one("plastic_slope_kappa_squared") * k2;
        let plastic_from = 1.0 + self.one("plastic_from_rho") * (1.0 - self.kappa);
        let [from, factor] = ["geometry_from", "geometry_factor"].map(|key| list(&self.table, "elastic_approach", key));
        let slope = |a: f64| {
            let base = if a < plastic_from { first } else { plastic };
            from.iter()
                .zip(&factor)
                .filter(|(from, _)| a * self.a_y >= **from)
                .fold(base, |slope, (_, factor)| slope * factor)
        };
        let knots = [plastic_from, from[0] / self.a_y, from[1] / self.a_y];
        let mut places: Vec<f64> = knots.into_iter().filter(|knot| *knot > 1.0 && *knot < a).chain([1.0, a]).collect();
        places.sort_by(f64::total_cmp);
        1.0 + places.windows(2).map(|pair| slope(0.5 * (pair[0] + pair[1])) * (pair[1] - pair[0])).sum::<f64>()
    }

    fn approach(&self, x: f64) -> f64 {
        let force = self.force(x);
        // ε = line(f/ε): the left side rises in ε, the right side falls
        let (mut low, mut high) = (0.0, x);
        if x <= 1.0 || self.line(force / x) >= x {
            return x;
        }
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if middle < self.line(force / middle) { low = middle } else { high = middle }
        }
        low
    }

    fn work(&self, x: f64) -> f64 {
        let n = 20_000;
        let step = x / f64::from(n);
        step * ((1..n).map(|i| self.force(f64::from(i) * step)).sum::<f64>() + 0.5 * self.force(x))
    }

    /// Λ(A).
    fn pressure_shape(a: f64) -> f64 {
        match a {
            a if a < 1.5 => 1.0,
            a if a < 4.0 => 1.0 + 0.15 * (a - 1.5) / 2.5,
            a if a < 8.0 => 1.15 + 0.04 * (a - 4.0) / 4.0,
            _ => 1.19,
        }
    }

    fn restitution(&self, x: f64, is_paper: bool) -> f64 {
        let (force, approach) = (self.force(x), self.approach(x));
        let lambda = Self::pressure_shape(force / approach);
        let n = if is_paper { 1.5 } else { 1.5 - 0.807_46 * (lambda - 1.0) };
        (force * approach / (n + 1.0) / self.work(x)).sqrt()
    }

    /// a/R, narrower than â/Λ from â/R = 0.105 on.
    fn contact_radius(&self, x: f64) -> f64 {
        let a = self.force(x) / self.approach(x);
        let geometry = 1.0 + (0.25 + 0.145 * self.kappa.powi(2)) * (a * self.a_y - 0.105).max(0.0);
        a * self.a_y / Self::pressure_shape(a) / geometry
    }
}

const CURVES: [&str; 5] = [
    include_str!("../../src/reference/fe_loading_case1.csv"),
    include_str!("../../src/reference/fe_loading_case2.csv"),
    include_str!("../../src/reference/fe_loading_case3.csv"),
    include_str!("../../src/reference/fe_loading_case4.csv"),
    include_str!("../../src/reference/fe_loading_case5.csv"),
];

static CHECKS: LazyLock<Vec<Check>> =
    LazyLock::new(|| validation::checks(PlmCoefficients::built_in(), &Counter::default()).unwrap());

#[test]
fn rows_of_load_cycles_follow_from_a_second_implementation() {
    let mut compared = 0;
    for cycle in records::<Row>(include_str!("../../src/reference/fe_unloading.csv")) {
        let case: usize = cycle["case"].trim_start_matches("case").parse().unwrap();
        let second = Second::of(CURVES[case - 1]);
        let x = number(&cycle, "x");
        let row = |quantity: &str| {
            let is_this = |check: &&Check| {
                let (run, depth) = check.case.split_once(", x = ").unwrap_or(("", ""));
                // the depth has four digits; rows that belong to no cycle have none
                let depth: f64 = depth.parse().unwrap_or(0.0);
                check.quantity() == quantity && run == cycle["run"] && (depth / x - 1.0).abs() < 1e-3
            };
            CHECKS.iter().find(is_this)
        };
        for (quantity, is_paper) in
            [("load cycle: restitution, exponent 3/2", true), ("load cycle: restitution, pressure-shape", false)]
        {
            // not all rows of the reference have a restitution
            let Ok(expected) = cycle["restitution"].parse::<f64>() else { continue };
            let check = row(quantity).unwrap();
            let [of_reference, got] = check.numbers.unwrap();
            assert_eq!(of_reference, expected);
            // the trapezoidal rule with 20 000 steps
            assert_relative_eq!(got, second.restitution(x, is_paper), max_relative = 2e-6);
            compared += 1;
        }
        // Eq. 23 with the peak of the reference
        let dent = row("unloading: residual indentation from the reference's peak (Eq. 23)").unwrap();
        let residual = x * (1.0 - number(&cycle, "sphere_share") / second.kappa);
        let [of_reference, got] = dent.numbers.unwrap();
        assert_relative_eq!(got, residual, max_relative = 1e-9);
        assert_relative_eq!(of_reference, x * number(&cycle, "residual_share"), max_relative = 1e-12);
        // Eqs. 24 and 25
        if let Some(curvature) = row("unloading: residual radius from the reference's peak (Eq. 25)") {
            let approach = x * number(&cycle, "sphere_share") / second.kappa;
            let r_e = number(&cycle, "f").powi(2) / approach.powi(3);
            assert_relative_eq!(curvature.numbers.unwrap()[1], 1.0 / (1.0 - 1.0 / r_e), max_relative = 1e-9);
            assert!(number(&cycle, "elements_in_contact") >= 10.0);
        }
    }
    assert_eq!(compared, 2 * 59);
}

#[test]
fn rows_of_loading_follow_from_a_second_implementation() {
    for (case, curve) in (1..).zip(CURVES) {
        let second = Second::of(curve);
        let mut squares = [0.0; 3];
        let mut n = 0.0;
        for row in records::<Row>(curve) {
            let x = number(&row, "delta_over_deltaY");
            if x < 1.0 {
                continue;
            }
            let force = second.force(x) / number(&row, "F_over_FY") - 1.0;
            let sphere = second.kappa * second.approach(x) / x / number(&row, "delta_s_over_delta") - 1.0;
            let radius = second.contact_radius(x) / number(&row, "a_over_R") - 1.0;
            for (square, off) in squares.iter_mut().zip([force, sphere, radius]) {
                *square += off * off;
            }
            n += 1.0;
        }
        for (quantity, square) in ["force", "sphere indentation", "contact radius"].into_iter().zip(squares) {
            let name = format!("loading: {quantity}, rms over the curve");
            let check = CHECKS
                .iter()
                .find(|check| check.quantity() == name && check.case.starts_with(&format!("case {case},")));
            assert_relative_eq!(check.unwrap().deviation, (square / n).sqrt(), max_relative = 1e-5);
        }
    }
}

#[test]
fn whole_impacts_are_those_of_the_scenarios() {
    // e from the energy balance of the second implementation, for the bodies of D1 (scenarios/dynamic-fe-d1.toml)
    let second = Second::new(208.0, 210.0, 345.0);
    // kinetic energy in units of first yield: (1/2)(4/3)π R³ ρ v² = W F_Y δ_Y, F_Y δ_Y = (2/3) E* a_Y^5 R³ × 2, a_Y in
    // units of R
    let e_star = 208e9 * 210e9 / 0.91 / (208e9 + 210e9);
    let kinetic = 0.5 * 4.0 / 3.0 * std::f64::consts::PI * 7850.0 * 9.0 / (4.0 / 3.0 * e_star * second.a_y.powi(5));
    let (mut low, mut high) = (1.0, 1e4);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if second.work(middle) < kinetic { low = middle } else { high = middle }
    }
    for (name, is_paper) in [("exponent 3/2", true), ("pressure-shape", false)] {
        let quantity = format!("impact: restitution, {name}");
        let check = CHECKS.iter().find(|check| check.quantity() == quantity && check.case == "D1").unwrap();
        let [expected, got] = check.numbers.unwrap();
        assert_relative_eq!(got, second.restitution(low, is_paper), max_relative = 1e-5);
        // src/reference/fe_dynamic.csv
        assert_eq!(expected, 0.5030);
    }
}
