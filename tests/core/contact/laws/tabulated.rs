//! Forces, dents and restitutions of the published laws, compared with the tables of `reference/laws.csv` for case 3. A number
//! has to agree to half a unit of its last printed digit: forces one decimal, dents and e three.

use plm_impact::contact::law::catalogue::yigit_christoforou::YigitChristoforou;
use plm_impact::contact::law::published::LoadedState;

use super::{case_3, factor, law_of};
use crate::common::prelude::*;
use crate::common::reference::{Row, rows};

/// The rows of one table.
fn table(name: &str) -> impl Iterator<Item = Row> {
    let all = rows(include_str!("../../../reference/laws.csv")).into_iter();
    let rows: Vec<Row> = all.filter(|row| row.cell_text("table") == name).collect();
    assert!(rows.len() >= 12, "{name}: {} rows", rows.len());
    rows.into_iter()
}

/// The law of a name, with C_ν where the law has a yield factor.
fn with_factor(name: &str) -> LawChoice {
    let yield_factor = Some(factor());
    match name {
        "jackson_green" => LawChoice::JacksonGreen(JacksonGreen { yield_factor, ..Default::default() }),
        "kogut_etsion" => LawChoice::KogutEtsion(KogutEtsion { yield_factor }),
        "yigit_christoforou" => LawChoice::YigitChristoforou(YigitChristoforou { yield_factor }),
        name => LawChoice::from_name(name).unwrap(),
    }
}

fn assert_near(row: &Row, [force, dent, e]: [f64; 3]) {
    // the table has the work of the printed force of Kogut and Etsion, whose pieces do not meet
    let of_work = if row.cell_text("law") == "kogut_etsion" { 1e-3 } else { 5.1e-4 };
    for (name, got, allowed) in [("force", force, 0.051), ("residual", dent, 5.1e-4), ("restitution", e, of_work)] {
        if let Some(want) = row.optional_number(name) {
            assert!((got - want).abs() < allowed, "{row:?}: {name} {got}");
        }
    }
}

#[test]
fn whole_laws_match_tabulated_values() {
    let bodies = case_3();
    for row in table("whole") {
        // ω_c of Kogut and Etsion differs by 0.3 % from δ_Y; Stronge has the factor 1.5 ϑ = 1.65
        let (law, unit) = match row.cell_text("law") {
            "kogut_etsion" => {
                (LawChoice::from_name("kogut_etsion"), bodies.yield_indentation_ratio(2.8 * (0.454 + 0.41 * 0.3)))
            }
            "stronge" => (LawChoice::from_name("stronge"), bodies.yield_indentation_ratio(1.65)),
            name => (Some(with_factor(name)), 1.0),
        };
        let law = law_of(law.unwrap().as_contact_law());
        let x = unit * row.number("depth");
        let peak = law.loaded_state(x);
        let e = (law.unload(peak).stored_energy(x) / law.loading.work(x)).sqrt();
        assert_near(&row, [peak.force / unit.powf(1.5), peak.residual() / x, e]);
    }
}

#[test]
fn other_loadings_and_radii_match_the_table() {
    for row in table("loading") {
        let force = law_of(with_factor(row.cell_text("law")).as_contact_law()).loading.force(row.number("depth"));
        // Kogut and Komvopoulos are printed with three digits, the second with one unit too many in the last (34.25)
        let allowed = if row.cell_text("law") == "kogut_komvopoulos" { 2e-3 * force } else { 0.051 };
        assert!((force - row.number("force")).abs() < allowed, "{row:?}: {force}");
    }
    for row in table("radius") {
        let law = law_of(with_factor(row.cell_text("law")).as_contact_law());
        let radius = law.contact_radius(&law.loaded_state(row.number("depth"))) * case_3().yield_radius_ratio();
        let allowed = match row.cell_text("law") {
            "jackson_green" => 5.1e-5,
            "kogut_etsion" => 1.1e-4,
            _ => 0.02 * radius,
        };
        assert!((radius - row.number("radius")).abs() < allowed, "{row:?}: {radius}");
    }
}

/// The state of a peak as an unloading law gets it. The work of loading does not matter for the dent.
fn loaded(peak: &ContactState, radius: f64) -> LoadedState {
    let ContactState { indentation, force, .. } = *peak;
    LoadedState { indentation, force, contact_radius: radius, elastic_approach: None, loading_work: f64::INFINITY }
}

/// The table has δ_r/δ_m = 0.229, 0.690, 0.724, 0.892, 0.902 for the fully plastic law with its own loading. These
/// follow from a² = 4c² R δ, which is a mean pressure of 1.5 σ_Y under the same force, not the 3 σ_Y of the law. With
/// a² = 2c² R δ the pressure is 3 σ_Y and the dents are shallower; the program uses this.
#[test]
fn tabulated_fully_plastic_dents_use_half_the_pressure() {
    let choice = LawChoice::from_name("mesarovic_johnson").unwrap();
    let (bodies, law) = (case_3(), law_of(choice.as_contact_law()));
    let recovery = choice.as_contact_law().build_parts(&bodies).recovery;
    for (depth, tabulated) in [(13.5, 0.229), (83.4, 0.690), (105.1, 0.724), (683.4, 0.892), (843.1, 0.902)] {
        let peak = law.loaded_state(depth);
        let radius = law.contact_radius(&peak);
        let dent = |radius| 1.0 - recovery(loaded(&peak, radius)).elastic_approach / depth;
        assert!((dent(2f64.sqrt() * radius) - tabulated).abs() < 5.1e-4);
        assert!(dent(radius) < tabulated - 0.03);
        let pressure = peak.force * bodies.yield_point.force
            / (std::f64::consts::PI * (radius * bodies.yield_point.contact_radius).powi(2));
        assert!(relative_error(pressure, 3.0 * bodies.yield_point.strength) < 1e-12);
    }
}

/// All unloading laws from the same state.
#[test]
fn unloading_from_one_state_gives_tabulated_dents() {
    let (bodies, loading) = (case_3(), law_of(with_factor("jackson_green").as_contact_law()));
    for row in table("from jackson_green") {
        let choice = match row.cell_text("law") {
            // the table takes the yield indentation of this law as δ_Y of C_ν
            "stronge" => LawChoice::Stronge(Stronge {
                yield_pressure_ratio: bodies.yield_point.factor / 1.5,
                unloading_factor: 1.0,
            }),
            "yigit_christoforou" => LawChoice::from_name("yigit_christoforou").unwrap(),
            name => with_factor(name),
        };
        let peak = loading.loaded_state(row.number("depth"));
        let Recovery { elastic_approach, shape } =
            (choice.as_contact_law().build_parts(&bodies).recovery)(loaded(&peak, loading.contact_radius(&peak)));
        let unloading = Unloading::new(ContactState { elastic_approach, ..peak }, shape);
        let e = (unloading.stored_energy(peak.indentation) / loading.loading.work(peak.indentation)).sqrt();
        assert_near(&row, [peak.force, 1.0 - elastic_approach / peak.indentation, e]);
    }
}
