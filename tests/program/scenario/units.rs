//! Spellings of quantities that are understood, and spellings that are refused with their messages.

use crate::common::prelude::*;
use plm_impact::scenario::keys::quantity::ANGLE;
use plm_impact::units::{Dimension, format_exact, format_input, format_result, format_si, format_si_and_short, parse};

#[test]
fn every_spelling_equals_its_si_digits() {
    let rows: Vec<(String, String, f64)> = records(include_str!("spellings.csv"));
    assert_eq!(rows.len(), 77);
    for (spelling, name, want) in rows {
        let dimension = *Dimension::ALL.iter().find(|dimension| format!("{dimension:?}") == name).unwrap();
        assert_eq!(parse(&spelling, dimension).ok(), Some(want), "{spelling}");
    }
}

/// The hint names the unit that is meant. A unit of few letters is not guessed from its letters, as one letter makes another unit
/// of a speed.
#[test]
fn unknown_unit_gets_suggestion_or_list() {
    use Dimension::{Length, Mass, MomentOfInertia, Pressure, Speed, Viscosity};
    let table = [
        ("5 kmh", Speed, Some("km/h")),
        ("5 km/hr", Speed, Some("km/h")),
        ("5 KPH", Speed, Some("kph")),
        ("5 m/sec", Speed, Some("m/s")),
        ("5 mpx", Speed, None),
        ("5 inches", Length, Some("in")),
        ("5 feet", Length, Some("ft")),
        ("5 mn", Length, None),
        ("5 lbs", Mass, Some("lb")),
        ("5 ounces", Mass, Some("oz")),
        ("5 mpa", Pressure, Some("MPa")),
        ("5 pa s", Viscosity, Some("Pa s")),
        ("5 kgm^2", MomentOfInertia, Some("kg m^2")),
    ];
    for (text, dimension, want) in table {
        let message = parse(text, dimension).unwrap_err().to_string();
        match want {
            Some(unit) => assert!(message.contains(&format!("did you mean \"{unit}\"?")), "{message}"),
            None => assert!(!message.contains("did you mean"), "{message}"),
        }
        assert!(message.contains(&format!("nits of {} are", dimension.name())), "{message}");
    }
    for text in ["1/2 mm", "1/0 in", "1 1/2 kg"] {
        assert!(parse(text, Length).is_err(), "{text}");
    }
    assert!(parse("1/2 in", Mass).is_err());
}

#[test]
fn command_lists_units_and_hardness_scales() {
    let output = Sandbox::with("").run(&["units"]);
    assert_eq!(output.status.code(), Some(0));
    let list = text(&output.stdout);
    for dimension in Dimension::ALL {
        for unit in dimension.unit_names() {
            assert!(list.contains(unit), "{unit}");
            let size = parse(&format!("1 {unit}"), *dimension);
            assert!(size.is_ok_and(|size| size > 0.0), "{unit}");
        }
    }
    assert!(list.contains("HV, HB (76 to 570), HRB (41 to 99.5), HRC (20.3 to 68)"), "{list}");
}

#[test]
fn an_angle_carries_its_unit() {
    for text in ["45 deg", "45°", "0.7853981633974483 rad"] {
        assert!((ANGLE.parse(text).unwrap() - std::f64::consts::FRAC_PI_4).abs() < 1e-15, "{text}");
    }
}

#[test]
fn values_are_shown_in_si_and_fitting_unit() {
    use Dimension::{Density, Force, Length, Pressure, Ratio, Speed};
    let table = [
        (0.005, Length, "0.005 m (5 mm)"),
        (1.0, Length, "1 m"),
        (0.0, Length, "0 m"),
        (2.870_168_549_901_595e-7, Length, "287.017 nm"),
        (1e-12, Length, "1e-12 m (0.001 nm)"),
        (210e9, Pressure, "2.1e11 Pa (210 GPa)"),
        (7850.0, Density, "7850 kg/m^3 (7.85 g/cm^3)"),
        (0.009_666_759_822_493_44, Speed, "9.66676 mm/s"),
        (1.672_756_582_264_761, Force, "1.67276 N"),
        (0.3, Ratio, "0.3"),
    ];
    for (value, dimension, want) in table {
        assert_eq!(format_si_and_short(value, dimension), want);
    }
}

proptest! {
    #![proptest_config(crate::common::proptest_config(256))]

    #[test]
    fn all_digits_read_back_exactly(value in proptest::num::f64::POSITIVE | proptest::num::f64::NORMAL) {
        for dimension in [Dimension::Length, Dimension::Pressure, Dimension::Density, Dimension::Speed, Dimension::Ratio] {
            prop_assert_eq!(parse(&format_si(value, dimension), dimension).ok(), Some(value));
            prop_assert_eq!(parse(&format_exact(value, dimension), dimension).ok(), Some(value));
        }
    }

    #[test]
    fn fitting_unit_keeps_six_digits(value in 1e-30..1e30_f64) {
        for dimension in [Dimension::Length, Dimension::Pressure, Dimension::Density, Dimension::Speed] {
            let read = parse(&format_input(value, dimension), dimension).unwrap();
            // half a unit in the sixth digit
            prop_assert!((read / value - 1.0).abs() <= 5.001e-6, "{value} {}", format_input(value, dimension));
        }
    }

    #[test]
    fn no_text_panics(text in "\\PC*") {
        let _ = parse(&text, Dimension::Length);
    }
}

#[test]
fn the_unit_is_that_of_the_rounded_value() {
    assert_eq!(format_input(0.999_999_9, Dimension::Length), "1 m");
    assert_eq!(format_input(0.999_99, Dimension::Length), "999.99 mm");
    assert_eq!(format_exact(0.999_999_9, Dimension::Length), "999.9999 mm");
}

#[test]
fn results_have_four_digits() {
    let table = [
        (3.6948e-5, Dimension::Length, "36.95 µm"),
        (1105.7, Dimension::Force, "1.106 kN"),
        (3.45e8, Dimension::Pressure, "345 MPa"),
        (0.0, Dimension::Force, "0 N"),
        (999.96, Dimension::Force, "1 kN"),
        (-2.5, Dimension::Speed, "-2.5 m/s"),
        (0.005, Dimension::Mass, "5 g"),
        (8850.0, Dimension::Density, "8.85 g/cm^3"),
        (1.2345e-300, Dimension::Length, "1.234e-291 nm"),
        (f64::INFINITY, Dimension::Pressure, "inf Pa"),
    ];
    for (value, dimension, text) in table {
        assert_eq!(format_result(value, dimension), text);
    }
}
