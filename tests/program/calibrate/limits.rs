//! Calibrations at the limits: readings without scatter, elastic rebounds, few values, kinks of the sum of squares.

use std::fmt::Write as _;

use crate::common::prelude::*;
use plm_impact::calibrate::CalibrationTask;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng as _, SeedableRng as _};

use super::fits::{STRENGTH, assert_close, run_calibration, scenario};

const STEEL: &str = include_str!("../../../scenarios/steel-on-steel.toml");

/// The strength that one restitution gives, with the summary, at this speed.
fn of_one(restitution: f64, speed: &str) -> (f64, Value) {
    let (_, summary) = run_calibration(STEEL, "", &["--restitution", &restitution.to_string(), "--speed", speed], 0);
    (summary["keys"][0]["estimate"].as_f64().unwrap(), summary)
}

/// e of the scenario at this strength.
fn restitution(strength: f64, speed: &str) -> f64 {
    let settings = [format!("half_space.yield_strength={strength}"), format!("impact.speed={speed}")];
    let scene = Scenario::from_text("steel", STEEL, &Override::list(&settings)).unwrap().resolve().unwrap();
    scene.contact().unwrap().closed_form(scene.speed()).unwrap().row.restitution
}

#[test]
fn strength_of_nearly_elastic_rebound_is_found() {
    for wanted in [0.998, 0.999, 0.9995, 0.9999, 0.99999] {
        let (strength, _) = of_one(wanted, "0.1 m/s");
        assert!((restitution(strength, "0.1 m/s") - wanted).abs() < 1e-8, "{wanted}: {strength}");
    }
}

#[test]
fn elastic_rebound_gives_lower_bound_of_strength() {
    // the yield speed is proportional to the strength to the power 5/2, and 9.66676 mm/s at 345 MPa by a run
    for (speed, least) in [("0.1 m/s", "878.4 MPa"), ("3 m/s", "3.424 GPa")] {
        let (strength, summary) = of_one(1.0, speed);
        assert!(
            restitution(strength, speed) > 1.0 - 1e-9 && restitution(0.999 * strength, speed) < 1.0 - 1e-6,
            "{strength}"
        );
        let refusal = summary["refusal"].as_str().unwrap();
        assert!(refusal.starts_with(&format!("every half_space.yield_strength from {least} to ")), "{refusal}");
        // a tenth of Young's modulus, the upper end of the range
        assert!(refusal.contains(" to 21 GPa fits equally well") && refusal.contains("elastic"), "{refusal}");
    }
}

/// Twenty impacts; the method of Levenberg and Marquardt stopped at a kink, 590.8 MPa, with the first range below.
const KINKED: &str = "0.8042298891,0.7507834666 1.049992641,0.7344917636 2.530164755,0.6558293253 0.2355599335,0.8739483039 \
    1.820923506,0.6949543897 0.7310727126,0.7676019802 0.5462823988,0.8016018985 2.26240936,0.6284181316 \
    0.2917735685,0.8718736551 3.756951237,0.6191112572 0.7310936336,0.7816023912 4.943361028,0.5671278239 \
    1.086485297,0.7253070375 2.02756342,0.6572582979 1.011677022,0.7367028022 0.9099655303,0.7578124888 \
    3.954696145,0.5834981023 0.6810721323,0.7738535256 0.3791040205,0.8480323904 0.3026317279,0.8565095456";

/// Impacts of another law; it stopped at 413.7 MPa.
const KINKED_TOO: &str = "0.2476450185,0.7988998404 1.530120559,0.5891670031 0.2006049693,0.80359361 0.2503447181,0.7883243871 \
    0.8504923176,0.6552061184 0.1494136478,0.8560760375 1.299178092,0.6179270466 1.858728561,0.5917104628 \
    0.1106104141,0.8825972591 4.147950723,0.5022207189 0.9750896261,0.6491391441 0.2667459277,0.7825295688 \
    1.279217902,0.6282859965 0.81350338,0.6800281161 2.823824679,0.5486356582 2.903040278,0.5183320724 \
    3.417856108,0.5199527295 3.464529911,0.5311805704 0.1657555692,0.8287024051 3.274237568,0.5409728683";

/// The fit and the least sum on a fine grid about it.
fn fitted(data: &str, from: f64, to: f64, robust: &str) -> (f64, f64, f64) {
    let lines: String = data.split_whitespace().flat_map(|line| [line, "\n"]).collect();
    let request = format!(
        "data = \"d.csv\"\nfree = {{ \"half_space.yield_strength\" = {{ from = {from}, to = {to} }} }}\nnoise = {{ restitution = 0.01 }}\n{robust}"
    );
    let text = scenario(&request).replace("208 GPa", "210 GPa");
    let scenario = read(&text, NO_OVERRIDES).with_data(format!("speed_m_per_s,restitution\n{lines}"));
    let measured = CalibrationTask::new(&scenario).unwrap();
    let progress = Progress::default();
    let found = measured.calibrate(&progress).unwrap();
    let fit: &Fit = &found.fit;
    let grid = |i: i32| fit.problem.objective(&[fit.best().shares[0] + f64::from(i) * 1e-5]);
    let least = (-2000..=2000).map(grid).fold(f64::INFINITY, f64::min);
    (found.keys[0].estimate, found.keys[0].sd.unwrap(), fit.best().sum - least)
}

#[test]
fn estimate_is_minimum_behind_kink() {
    let robust = "robust = \"student-t\"";
    let ranges = [(50e6, 5e9), (60e6, 4e9), (500e6, 700e6)].map(|(from, to)| fitted(KINKED, from, to, robust));
    for (estimate, sd, above) in ranges {
        // the grid has steps of a few hundredths of the standard deviation
        assert!(above < 1e-3, "{estimate}: {above}");
        assert!((estimate - ranges[2].0).abs() < 0.02 * sd, "{ranges:?}");
    }
    let (estimate, _, above) = fitted(KINKED_TOO, 50e6, 5e9, "");
    assert!(above < 1e-3, "{estimate}: {above}");
}

/// The region of 95 % against a plane of 201 by 201 places: its area is the share of places whose sum is at most 5.9915 above
/// the least, the quantile of chi-square with 2 degrees of freedom (tables).
#[test]
fn region_of_two_keys_matches_plane_of_sums() {
    let text = scenario(&format!("data = \"d.csv\"\n{}noise = {{ restitution = 0.01 }}", super::fits::BOTH));
    let measured = CalibrationTask::new(&read(&text, NO_OVERRIDES).with_data(super::table::data("synthetic"))).unwrap();
    let progress = Progress::default();
    let found = measured.calibrate(&progress).unwrap();
    let fit: &Fit = &found.fit;
    let outline = fit.region(0.95).remove(0);
    let ends = |key: usize| {
        let all = outline.iter().map(|place| place[key]);
        (all.clone().fold(f64::INFINITY, f64::min), all.fold(0.0, f64::max))
    };
    let ([low_x, high_x], [low_y, high_y]) = (<[f64; 2]>::from(ends(0)), <[f64; 2]>::from(ends(1)));
    let mut inside = 0.0;
    for i in 0..=200 {
        for j in 0..=200 {
            let at = |low: f64, high: f64, i: i32| low + (high - low) * (1.2 * f64::from(i) / 200.0 - 0.1);
            let place = [at(low_x, high_x, i), at(low_y, high_y, j)];
            inside += f64::from(u8::from(fit.problem.objective(&place) - fit.best().sum <= 5.991_464_547));
        }
    }
    let of_plane = inside * (1.2 * (high_x - low_x) / 200.0) * (1.2 * (high_y - low_y) / 200.0);
    let cross = outline.windows(2).map(|at| at[0][0] * at[1][1] - at[1][0] * at[0][1]);
    let of_outline = 0.5 * cross.sum::<f64>();
    assert!((of_outline / of_plane - 1.0).abs() < 0.01, "{of_outline} {of_plane}");
}

/// With two values more than keys, Student's distribution has 2 degrees of freedom: the region of 95 % ends where the sum has
/// risen by 2 F = 38, or at an end of a range (F(2, 2) of 95 % is 19, from tables).
#[test]
fn region_of_two_keys_reflects_few_values() {
    let data = "speed_m_per_s,restitution,peak_force_N\n1,0.60,330\n3,0.49,1130\n".to_owned();
    let text = scenario(&format!("data = \"d.csv\"\n{}noise = \"estimate\"", super::fits::BOTH));
    let measured = CalibrationTask::new(&read(&text, NO_OVERRIDES).with_data(data)).unwrap();
    let progress = Progress::default();
    let found = measured.calibrate(&progress).unwrap();
    let rise = |place: &[f64; 2]| found.fit.problem.objective(place) - found.fit.best().sum;
    let outline = found.fit.region(0.95).remove(0);
    let is_at_an_end = |place: &[f64; 2]| place.iter().any(|share| !(1e-9..1.0 - 1e-9).contains(share));
    let free: Vec<f64> = outline.iter().filter(|place| !is_at_an_end(place)).map(rise).collect();
    assert!(free.len() > 20 && free.iter().all(|rise| (rise / 38.0 - 1.0).abs() < 0.01), "{free:?}");
}

/// The region ends where the range of a key ends.
#[test]
fn region_of_two_keys_stays_within_ranges() {
    let free = super::fits::BOTH.replace("3 GPa", "350 MPa").replace("500 GPa", "210 GPa");
    let text = scenario(&format!("data = \"d.csv\"\n{free}noise = {{ restitution = 0.01 }}"));
    let measured = CalibrationTask::new(&read(&text, NO_OVERRIDES).with_data(super::table::data("synthetic"))).unwrap();
    let progress = Progress::default();
    let found = measured.calibrate(&progress).unwrap();
    let outline = found.fit.region(0.95).remove(0);
    for key in 0..2 {
        let shares: Vec<f64> = outline.iter().map(|place| place[key]).collect();
        assert!(shares.iter().all(|share| (0.0..=1.0 + 1e-9).contains(share)), "{shares:?}");
        assert!(shares.iter().any(|share| *share > 1.0 - 1e-9), "{shares:?}");
    }
}

/// Two of ten impacts are of a harder material. The sum at the minimum of these two is more than 5.99 larger, the quantile of chi-square with
/// 2 degrees of freedom, so the region of 95 % lies around the other minimum alone.
#[test]
fn region_of_two_keys_leaves_out_worse_minimum() {
    let mut data = "speed_m_per_s,restitution,peak_force_N\n".to_owned();
    for (strength, impacts) in [(200e6, 8), (800e6, 2)] {
        let steel = crate::common::contact(crate::common::STEEL, &[format!("half_space.yield_strength={strength}")]);
        for i in 0..impacts {
            let speed = 0.5 * 10_f64.powf(f64::from(i) / 7.0);
            let row = steel.closed_form(speed).unwrap().row;
            writeln!(data, "{speed},{},{}", row.restitution, row.peak_force).unwrap();
        }
    }
    let noise = "noise = { restitution = 0.002, peak_force = \"2 N\" }\nrobust = \"student-t\"";
    let text = scenario(&format!("data = \"d.csv\"\n{}{noise}", super::fits::BOTH));
    let measured = CalibrationTask::new(&read(&text, NO_OVERRIDES).with_data(data)).unwrap();
    let progress = Progress::default();
    let found = measured.calibrate(&progress).unwrap();
    let excess: Vec<f64> = found.fit.minima.iter().map(|place| place.sum - found.fit.best().sum).collect();
    assert!(excess.len() == 2 && excess[1] > 5.991_464_547, "{excess:?}");
    let outlines = found.fit.region(0.95);
    assert_eq!(outlines.len(), 1);
    let best = &found.fit.best().shares;
    let distance = |place: &[f64; 2]| (place[0] - best[0]).abs().max((place[1] - best[1]).abs());
    assert!(outlines[0].iter().all(|place| distance(place) < 0.05), "{outlines:?} {best:?}");
}

/// Two materials in turn, at more than 1000 impacts: every second impact is of one of them, but the subsample has both. The order of the
/// lines does not change the result.
#[test]
fn order_of_many_impacts_does_not_hide_a_basin() {
    let steel = |strength: f64| {
        crate::common::contact(crate::common::STEEL, &[format!("half_space.yield_strength={strength}")])
    };
    let (soft, hard) = (steel(200e6), steel(800e6));
    let text =
        scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.005 }}\nrobust = \"student-t\""));
    let of_order = |order: [&plm_impact::Contact; 2]| {
        let mut data = "speed_m_per_s,restitution\n".to_owned();
        for i in 0..600 {
            let speed = 0.5 * 10_f64.powf(f64::from(i) / 599.0);
            for contact in order {
                writeln!(data, "{speed},{}", contact.closed_form(speed).unwrap().row.restitution).unwrap();
            }
        }
        run_calibration(&text, &data, &[], 3).1
    };
    let [first, second] = [[&soft, &hard], [&hard, &soft]].map(|order| of_order(order)["keys"][0]["estimate"].clone());
    // this one of the two basins is deeper
    assert_close(&first, 200e6, 0.01);
    assert_close(&second, first.as_f64().unwrap(), 1e-9);
}

/// A subsample of more than 1000 impacts finds the basins, and all impacts give the value. The minimum of the whole sum is found here by
/// a search of its own; that of every third impact lies beyond the tolerance.
#[test]
fn all_of_many_impacts_give_the_strength() {
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.01 }}"));
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let speeds: Vec<f64> = (0..2500).map(|i| 0.5 + 4.5 * f64::from(i) / 2499.0).collect();
    let restitutions = |strength: f64| {
        let steel = crate::common::contact(crate::common::STEEL, &[format!("half_space.yield_strength={strength}")]);
        speeds.iter().map(|speed| steel.closed_form(*speed).unwrap().row.restitution).collect::<Vec<_>>()
    };
    // uniform noise with this standard deviation
    let noise = || 0.01 * 12_f64.sqrt() * (random.next_u64() as f64 / 2_f64.powi(64) - 0.5);
    let measured: Vec<f64> =
        restitutions(345e6).into_iter().zip(std::iter::repeat_with(noise)).map(|(e, off)| e + off).collect();
    let mut data = "speed_m_per_s,restitution\n".to_owned();
    for (speed, e) in speeds.iter().zip(&measured) {
        writeln!(data, "{speed},{e}").unwrap();
    }
    let (_, summary) = run_calibration(&text, &data, &[], 0);
    // the vertex of a parabola through three sums of squares around the value
    let lowest = |step: usize| {
        let sum = |strength: f64| -> f64 {
            let all = restitutions(strength).into_iter().zip(&measured).step_by(step);
            all.map(|(law, e)| (law - e).powi(2)).sum()
        };
        let mut centre = 345e6;
        for width in [4e6, 1e6, 2e5] {
            let [low, middle, high] = [-width, 0.0, width].map(|off| sum(centre + off));
            centre += 0.5 * width * (low - high) / (low - 2.0 * middle + high);
        }
        centre
    };
    let (all, some) = (lowest(1), lowest(3));
    assert!((some / all - 1.0).abs() > 3e-5, "{some} {all}");
    assert_close(&summary["keys"][0]["estimate"], all, 1e-5);
}
