//! The table of limits on `scenarios/trust.md` is made of the limits of the laws and of the warnings, and other texts repeat them.
//! `UPDATE=1` writes the table anew.

use plm_impact::contact::law::published::{MAX_CLIPPING, MAX_PARABOLOID_RADIUS_RATIO};
use plm_impact::contact::pair::ALONE_FROM;
use plm_impact::impact::limits::*;
use plm_impact::impact::problem::waveguide::MAX_ZENER_NUMBER;
use plm_impact::strings::markdown_table;

use crate::common::golden::assert_golden_part;
use crate::common::prelude::*;

/// a/R up to which the law of the default scenario with these keys holds.
fn widest(keys: &[&str]) -> f64 {
    contact(STEEL, keys).scaling(1.0).unwrap().1.validity.max_radius_ratio
}

fn of_half_space() -> f64 {
    widest(&[])
}

fn with_hardening() -> f64 {
    widest(&["half_space.flow_stress.power.exponent=0.2"])
}

fn of_ball() -> f64 {
    widest(&["half_space.yield_strength=none", "sphere.yield_strength=345 MPa"])
}

fn of_both() -> f64 {
    widest(&["sphere.yield_strength=345 MPa"])
}

fn percent(fraction: f64) -> String {
    format!("{} %", 100.0 * fraction)
}

const ESTIMATE: &str = "warns: force, dent and e are estimates";

/// Limited quantity, limit, and reaction of the program beyond the limit.
fn rows() -> Vec<[String; 3]> {
    let row = |what: &str, limit: String, beyond: &str| [what, &limit, beyond].map(str::to_owned);
    let at_most = |limit: f64| format!("at most {limit}");
    let at_least = |limit: f64| format!("at least {limit}");
    vec![
        row("limited quantity", "limit".to_owned(), "beyond the limit the program"),
        row("a/R, the half-space yields", at_most(of_half_space()), ESTIMATE),
        row(
            "a/R, the half-space yields, the scenario has no flow curve, and Young's modulus of the ball is at least a third of the modulus of the half-space",
            at_most(MAX_SOFT_RADIUS_RATIO),
            "warns: e may be up to 6 % too high",
        ),
        row("a/R, the ball yields", at_most(of_ball()), ESTIMATE),
        row("a/R, both bodies yield (strength ratio q below 1.25)", at_most(of_both()), ESTIMATE),
        row(
            "a/R, other contact laws, unless their authors state another limit",
            at_most(MAX_PARABOLOID_RADIUS_RATIO),
            ESTIMATE,
        ),
        row("δ/R", at_most(1.0), "stops: no result"),
        row(
            "Poisson's ratio of the body that yields",
            at_least(MIN_POISSONS_RATIO),
            "warns: force, dent and e are extrapolations",
        ),
        row(
            "estimated reduction of the peak force by the inertia of the target (not modelled)",
            format!("at most {}", percent(MAX_INERTIA_SHARE)),
            "warns: the peak force is too high",
        ),
        row("σ_Y/E* of a ball that yields", at_least(MIN_FITTED_YIELD_STRAIN), "warns: force and e are too low"),
        row(
            "a/R of two unequal balls that both yield (R of the smaller ball)",
            at_most(MAX_UNEQUAL_BALLS_RATIO),
            "warns: e has an additional error",
        ),
        row(
            "contact time over 2 R/c, the time of a longitudinal wave through the ball",
            at_least(MIN_TRANSITS),
            "warns: e is too high",
        ),
        row(
            "impact speed over sticking speed",
            at_least(ADHESION_RANGE),
            "warns: e is too high, because adhesion is not modelled",
        ),
        row(
            "energy radiated as waves over recovered energy",
            format!("at most {}", percent(MAX_WAVE_LOSS)),
            "warns: e with waves is a rough value",
        ),
        row(
            "a/R at more than 45° from the normal",
            at_most(MAX_PLOUGHING_RATIO),
            "warns: tangential speed and spin are estimates",
        ),
        row(
            "absolute value of Dundurs' β, with partial slip",
            at_most(MAX_DUNDURS_BETA),
            "warns: the tangential rebound has an error",
        ),
        row("`plate_wave_transits` of a plate", at_least(MIN_THIN_PLATE_TRANSITS), "warns: e is too high"),
        row("the same with `plate = \"thick\"`", at_least(MIN_THICK_PLATE_TRANSITS), "warns: e is too high"),
        row("`plate_wave_transits` of any plate", at_least(MIN_WAVE_TRANSITS), "warns: use a half-space"),
        row("contact radius over thickness", at_most(MAX_CONTACT_OVER_THICKNESS), "warns: the result is an estimate"),
        row(
            "deflection over thickness",
            at_most(MAX_DEFLECTION_OVER_THICKNESS),
            "warns: the plate is stiffer than computed",
        ),
        row("`rod_wave_transits` of a rod", at_least(MIN_ROD_TRANSITS), "warns: e and the stress are estimates"),
        row(
            "contact radius over the radius of a rod",
            at_most(MAX_CONTACT_OVER_ROD_RADIUS),
            "warns: the result is an estimate",
        ),
        row("Zener's number λ", at_most(MAX_MEASURED_ZENER_NUMBER), "warns: e is close to 0 and uncertain"),
        row("Zener's number λ", at_most(MAX_ZENER_NUMBER), "stops: no measurable rebound"),
        row(
            "excess of the recovered energy over the loading work, by the formulas of a published law",
            format!("at most {}", percent(MAX_CLIPPING)),
            "stops: no result",
        ),
    ]
}

#[test]
fn page_of_limits_shows_limits_of_program() {
    assert_eq!(ALONE_FROM, 1.25);
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/scenarios/trust.md");
    assert_golden_part(Path::new(page), "limits", &markdown_table(&rows()));
}

/// Texts outside of the table that state a limit of the contact radius.
#[test]
fn other_texts_repeat_limits_of_contact_radius() {
    let read = |name: &str| fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name)).unwrap();
    let (flat, soft, ball, both) = (of_half_space(), MAX_SOFT_RADIUS_RATIO, of_ball(), of_both());
    assert_eq!(with_hardening(), flat);
    let of_soft = "for e of a perfectly plastic metal under a stiff sphere";
    for (page, sentence) in [
        ("src/contact/law/facts.csv", format!("a/R <= {flat} ({soft} {of_soft})")),
        ("src/registry.md", format!("radius of {flat} R ({soft} R {of_soft}, {ball} R if the sphere yields)")),
        ("scenarios/README.md", format!("| a/R = {ball} ({flat} for a half-space) |")),
        ("scenarios/README.md", format!("| a/R = {both}; for the separate depths of dent and flat, a/R = 0.11 |")),
        ("scenarios/README.md", format!("Validated up to a/R = {flat}.")),
    ] {
        assert!(read(page).replace('\n', " ").contains(&sentence), "{page} lacks: {sentence}");
    }
    // no page states any other limit of the contact radius
    for page in
        ["README.md", "scenarios/README.md", "scenarios/trust.md", "plots/validate/README.md", "plots/lammps/README.md"]
    {
        let text = read(page).replace('\n', " ");
        for (_, rest) in text.match_indices("up to a/R = ").map(|(at, begin)| text.split_at(at + begin.len())) {
            let number = rest.split([' ', ',', ':']).next().unwrap().trim_end_matches('.');
            let limit: f64 = number.parse().unwrap_or_else(|_| panic!("{page}: {number}"));
            assert!([flat, ball, both].contains(&limit), "{page}: up to a/R = {limit}");
        }
    }
}
