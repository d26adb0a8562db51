//! Pictures of `validate`, beside its table and its references.

use plm_impact::laws::{PlmCoefficients, UnloadingExponent};
use plm_impact::scenario::keys::interval::law_error::BodyClass;
use plm_impact::validate::law_error::cycle_errors;

use super::*;
use crate::validate::validation::rebound_of_device;

/// The first word of the case of a comparison, and the number behind the equals sign.
fn case(row: &TableRow) -> (&str, f64) {
    let (name, depth) = row["case"].split_once(", ").unwrap_or((&row["case"], ""));
    (name, depth.split_once("= ").map_or(f64::NAN, |(_, number)| number.parse().unwrap()))
}

/// The law of a quantity of the comparisons whose case begins so, each with its case.
fn of_law(results: &Results, quantity: &'static str, begin: &str) -> Vec<TableRow> {
    let mut rows = table(results, "validation", &[("quantity", quantity)]);
    rows.retain(|row| case(row).0.starts_with(begin));
    rows
}

/// The restitution of the law over the depth of load cycles.
fn cycles(quantity: &'static str, begin: &'static str) -> impl Fn(&Results) -> Points + Send + Sync {
    move |results| of_law(results, quantity, begin).iter().map(|row| (case(row).1, cell(row, "law"))).collect()
}

/// The restitution of the law over another of its results for the same cases.
fn crossed(
    across: &'static str,
    upward: &'static str,
    begin: &'static str,
) -> impl Fn(&Results) -> Points + Send + Sync {
    move |results| {
        let [x, y] = [across, upward].map(|quantity| of_law(results, quantity, begin));
        x.iter().zip(&y).map(|(x, y)| (cell(x, "law"), cell(y, "law"))).collect()
    }
}

const EXPONENTS: [&str; 2] = ["load cycle: restitution, exponent 3/2", "load cycle: restitution, pressure-shape"];

fn load_cycles() -> Vec<Shown> {
    let (off, by_depth) = ("pictures::restitution_error_against_depth", "pictures::restitution_against_depth");
    let cases = [("case1", BLUE), ("case2", VERMILLION), ("case3", GREEN), ("case4", PURPLE), ("case5", ORANGE)];
    let deviations = |(panel, quantity): (usize, &'static str)| {
        cases.map(|(name, color)| {
            shown(off, "error-restitution", panel, Marks(color), move |results| {
                of_law(results, quantity, name)
                    .iter()
                    .map(|row| (case(row).1, 100.0 * cell(row, "deviation")))
                    .collect()
            })
        })
    };
    let mut shown_there: Vec<Shown> = EXPONENTS.into_iter().enumerate().flat_map(deviations).collect();
    let law = |quantity, color| shown(by_depth, "restitution-case-3", 0, Through(color), cycles(quantity, "case3"));
    let elements = columns("fe_unloading", &[("case", "case3")], ["x", "restitution"]);
    shown_there.extend([
        shown(by_depth, "restitution-case-3", 0, Marks(BLUE), elements),
        law(EXPONENTS[0], VERMILLION),
        law(EXPONENTS[1], GREEN),
    ]);
    shown_there
}

/// The errors of e against the contact radius: one series for each class of bodies.
fn errors_by_radius() -> Vec<Shown> {
    let classes = [
        (BodyClass::PerfectlyPlastic, BLUE),
        (BodyClass::Hardening, VERMILLION),
        (BodyClass::YieldingSphere, GREEN),
        (BodyClass::OtherPoissonsRatio, PURPLE),
    ];
    let of_class = |(class, color)| {
        let kind = "pictures::restitution_error_against_radius";
        shown(kind, "error-restitution-contact-radius", 0, Marks(color), move |_| {
            let errors = cycle_errors(PlmCoefficients::built_in(), UnloadingExponent::PressureShape).unwrap();
            let of_class = errors.iter().filter(|(other, ..)| *other == class);
            of_class.map(|(_, radius_ratio, error)| (*radius_ratio, 100.0 * error)).collect()
        })
    };
    classes.map(of_class).into()
}

/// The peak of an unloading of case 3, and with its curve and its dent, in SI units.
fn unloading(run: &'static str, cycle: &'static str, results: &Results) -> [Points; 2] {
    let point = Scene::case_3().contact().pair().yield_point.unwrap();
    let only = [("run", run), ("cycle", cycle)];
    let peak = &table(results, "fe_unloading", &only)[0];
    let [x, force] = ["x", "f"].map(|column| cell(peak, column));
    let curve = table(results, "fe_unloading_curves", &only);
    let curve = curve.iter().map(|row| (cell(row, "x"), cell(row, "f")));
    let in_si = |(x, f): (f64, f64)| (x * point.indentation, f * point.force);
    let all = curve.chain([(x, force), (x * cell(peak, "residual_share"), 0.0)]);
    [vec![in_si((x, force))], all.map(in_si).collect()]
}

fn unloadings() -> Vec<Shown> {
    let of = |(picture, run, cycle): (&'static str, &'static str, &'static str)| {
        let rows = move |which: usize| move |results: &Results| unloading(run, cycle, results)[which].clone();
        // the law of the paper unloads from the peak of the finite elements
        [(Through(BLUE), 0), (Marks(BLACK), 1)]
            .map(|(form, which)| shown("figure_10::chart", picture, 0, form, rows(which)))
    };
    let pictures = [
        ("figure-10-at-13", "case3_mini", "2"),
        ("figure-10-at-105", "case3_fs", "1"),
        ("figure-10-at-843", "case3_large_finesteps", "2"),
    ];
    pictures.into_iter().flat_map(of).collect()
}

fn impacts() -> Vec<Shown> {
    let of = |(name, picture): (&'static str, &'static str)| {
        let parts = [
            (0, BLUE, "indentation_m"),
            (0, VERMILLION, "sphere_indentation_m"),
            (0, GREEN, "half_space_indentation_m"),
        ];
        parts.into_iter().flat_map(move |(panel, color, column)| {
            let elements = move |results: &Results| -> Points {
                let rows = table(results, "fe_dynamic_curves", &[("case", name)]);
                rows.iter().step_by(4).map(|row| (cell(row, column), cell(row, "force_N"))).collect()
            };
            // the scenario of this impact
            let law = move |_: &Results| -> Points {
                let text = format!("scenarios/dynamic-fe-{}.toml", name.to_lowercase());
                let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(text);
                let trace =
                    text_of_file(&outcome(&read(&fs::read_to_string(path).unwrap(), NO_OVERRIDES)), "trace.csv");
                numbers(&trace, column).into_iter().zip(numbers(&trace, "force_N")).collect()
            };
            [
                shown("pictures::impact", picture, panel, Marks(color), elements),
                shown("pictures::impact", picture, panel, Through(color), law),
            ]
        })
    };
    let pictures = [
        ("D1", "impact-d1-force-indentation"),
        ("D2", "impact-d2-force-indentation"),
        ("D5", "impact-d5-force-indentation"),
    ];
    pictures.into_iter().flat_map(of).collect()
}

fn metals() -> Vec<Shown> {
    let (hardening, yielding) = ("pictures::hardening", "pictures::yielding");
    let (hard, yields) = ("hardening-restitution", "yielding-restitution");
    let (peak, e) = ("hardening: peak indentation", "hardening: restitution, pressure-shape");
    let (radius, of_yielding) =
        ("sphere or both yield: contact radius at the same depth", "sphere or both yield: restitution, pressure-shape");
    let elements = |only| columns("fe_hardening", only, ["x", "restitution"]);
    let of_pair = |only| columns("fe_yielding", only, ["contact_radius_over_R", "e"]);
    let of_case_3 = columns("fe_unloading", &[("case", "case3")], ["contact_radius_over_R", "restitution"]);
    vec![
        shown(hardening, hard, 0, Marks(BLUE), elements(&[("material", "c3n10")])),
        shown(hardening, hard, 0, Marks(VERMILLION), elements(&[("material", "alvoce")])),
        shown(hardening, hard, 0, Marks(GREEN), elements(&[("material", "cun30")])),
        shown(hardening, hard, 0, Through(BLUE), crossed(peak, e, "c3n10")),
        shown(hardening, hard, 0, Through(VERMILLION), crossed(peak, e, "alvoce")),
        shown(hardening, hard, 0, Through(GREEN), crossed(peak, e, "cun30")),
        shown(yielding, yields, 0, Marks(BLUE), of_case_3),
        shown(yielding, yields, 0, Marks(VERMILLION), of_pair(&[("case", "S1")])),
        shown(yielding, yields, 0, Marks(GREEN), of_pair(&[("case", "S3")])),
        shown(yielding, yields, 0, Through(VERMILLION), crossed(radius, of_yielding, "S1")),
        shown(yielding, yields, 0, Through(GREEN), crossed(radius, of_yielding, "S3")),
    ]
}

fn rebounds() -> Vec<Shown> {
    let leeb =
        |form, rows: fn(&Results) -> Points| shown("pictures::leeb", "measured-leeb-tensile-strength", 0, form, rows);
    let oblique = |form, rows: Box<dyn Fn(&Results) -> Points + Send + Sync>| {
        shown("pictures::oblique", "oblique-alumina-on-glass", 0, form, rows)
    };
    let law = |results: &Results| -> Points {
        let rows = table(results, "validation", &[("quantity", "oblique: tangential restitution")]);
        rows.iter().map(|row| (row["case"].trim_end_matches(" deg").parse().unwrap(), cell(row, "law"))).collect()
    };
    let measured = columns("kharaz", &[("quantity", "tangential_restitution")], ["angle_deg", "value"]);
    vec![
        leeb(Through(BLUE), |results| {
            let end = |row: &TableRow, which: &str| {
                (1e6 * cell(row, &format!("{which}_tensile_strength_MPa")), cell(row, &format!("{which}_HLD")))
            };
            let rows = table(results, "leeb_tensile", &[]);
            rows.iter().flat_map(|row| ["low", "high"].map(|which| end(row, which))).collect()
        }),
        leeb(Through(VERMILLION), |_| {
            [5e8, 1e9, 2e9].map(|strength| (strength, 1e3 * rebound_of_device(strength))).into()
        }),
        leeb(Through(GREEN), |_| {
            [5e8, 1e9, 2e9].map(|strength| (strength, 1e3 * rebound_of_device(0.65 * strength))).into()
        }),
        oblique(Marks(BLACK), Box::new(measured)),
        oblique(Through(BLUE), Box::new(law)),
    ]
}

/// ψ over slip speed over μ v_n: 4 G*/E*, with the moduli and Poisson's ratios of two bodies.
fn psi_factor(bodies: [[f64; 2]; 2]) -> f64 {
    let shear: f64 = bodies.iter().map(|[e, nu]| 2.0 * (1.0 + nu) * (2.0 - nu) / e).sum();
    let normal: f64 = bodies.iter().map(|[e, nu]| (1.0 - nu * nu) / e).sum();
    4.0 * normal / shear
}

/// The measured slips of the atlas, from their files, and a law over the speed.
fn atlas() -> Vec<Shown> {
    let chart = "question::chart";
    let glass = |_: &Results| -> Points {
        let factor = psi_factor([[70e9, 0.22]; 2]) / 0.092;
        let collision = |row: &TableRow| {
            let angle = row["impact.angle"].trim_end_matches(" deg").parse::<f64>().unwrap().to_radians();
            let normal = cell(row, "impact.speed") * angle.cos();
            (factor * angle.tan(), factor * cell(row, "slip_after_m_per_s") / normal)
        };
        records::<TableRow>(include_str!("../../../../src/reference/measured/foerster_1994.csv"))
            .iter()
            .map(collision)
            .collect()
    };
    let alumina = |results: &Results| -> Points {
        let factor = psi_factor([[380e9, 0.23], [70e9, 0.25]]) / 0.092;
        let rebound = |row: &TableRow| {
            let psi = factor * cell(row, "angle_deg").to_radians().tan();
            (psi, psi * (1.0 + 3.5 * (cell(row, "value") - 1.0)))
        };
        table(results, "kharaz", &[("quantity", "tangential_restitution")]).iter().map(rebound).collect()
    };
    let law = |question: &'static str, picture, series: &'static str, form| {
        let rows = move |results: &Results| -> Points {
            let rows = table(results, "atlas", &[("question", question), ("series", series)]);
            rows.iter().map(|row| (cell(row, "x"), cell(row, "y"))).collect()
        };
        shown(chart, picture, 0, form, rows)
    };
    vec![
        shown(chart, "atlas-oblique", 0, Marks(BLACK), move |results| [glass(results), alumina(results)].concat()),
        law("restitution", "atlas-restitution", "plm, pressure-shape", Through(BLUE)),
        law("dent", "atlas-dent", "plm, pressure-shape", Through(BLUE)),
        law("contact-time", "atlas-contact-time", "plm, pressure-shape", Through(BLUE)),
        law("plate", "atlas-plate", "plm, pressure-shape", Through(BLUE)),
        // each impact has its own rate, so the laws are points; after the thirteenth law the first colours come again
        law("rate", "atlas-rate", "plm, exponent 3/2, no rate", Marks(PURPLE)),
    ]
}

pub(super) static ALL: LazyLock<Vec<Drawing>> = LazyLock::new(|| {
    let desk = Sandbox::with("");
    desk.run_expecting(&["validate", "--out", "out", "--pictures", "svg"], 0);
    let shown = [load_cycles(), unloadings(), impacts(), metals(), rebounds(), errors_by_radius(), atlas()]
        .into_iter()
        .flatten()
        .collect();
    vec![Drawing { results: Results::of(&desk), shown }]
});

/// The files of `validate` with pictures as SVG.
pub fn with_svg() -> &'static Results {
    &ALL[0].results
}

#[test]
fn validation_pictures_show_rows_and_references() {
    check(&ALL);
}
