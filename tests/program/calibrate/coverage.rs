//! Synthetic data of known strength: how often the interval contains the true value.

use crate::common::prelude::*;
use plm_impact::calibrate::data::{MeasuredValue, MeasurementData, MeasurementRow};
use plm_impact::calibrate::fit::NoiseModel;
use plm_impact::calibrate::problem::CalibrationProblem;
use plm_impact::numerics::functions::normal_quantile;
use plm_impact::scenario::input::measured::MeasuredQuantity;
use plm_impact::scenario::plan::free_key::FreeKey;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;

/// Normally distributed numbers with mean 0 and sd 1, the same in every run of the test. Every set is a stream of its own of
/// ChaCha, so the sets are independent.
fn normals(set: u64, count: usize) -> Vec<f64> {
    let mut generator = ChaCha8Rng::seed_from_u64(99);
    generator.set_stream(set);
    #[allow(clippy::cast_precision_loss)] // 53 bits
    let mut next = || normal_quantile(((generator.next_u64() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64);
    (0..count).map(|_| next()).collect()
}

/// How the data are made, and what is assumed of them.
#[derive(Debug, Clone, Copy)]
struct SyntheticData {
    sets: u64,
    readings: u32,
    /// Scatter, as a share of the value.
    sd: f64,
    /// True if the scatter is estimated; if not, it is given as a share of what the law gives.
    is_estimated: bool,
    is_robust: bool,
    quantities: &'static [&'static str],
    /// The keys with their true values.
    keys: &'static [(&'static str, f64)],
}

const STRENGTH: (&str, f64) = ("half_space.yield_strength", 345e6);
const MODULUS: (&str, f64) = ("half_space.youngs_modulus", 210e9);
/// The speed of a shot, which is fitted to dents.
const SPEED: (&str, f64) = ("impact.speed", 40.0);
const PLAIN: SyntheticData = SyntheticData {
    sets: 300,
    readings: 6,
    sd: 0.01,
    is_estimated: false,
    is_robust: false,
    quantities: &["restitution"],
    keys: &[STRENGTH],
};

/// For every key, the shares of the sets whose 68 % and 95 % intervals contain the true value.
fn coverage_shares(made: SyntheticData) -> Vec<[f64; 2]> {
    let SyntheticData { sets, readings, sd, is_estimated, is_robust, quantities, keys } = made;
    let mut scene = Scenario::from_text("steel", crate::common::STEEL, &[]).unwrap().resolve().unwrap();
    // by the closed form, as the command calibrates
    scene.set_default_method(Method::Auto);
    let contact = scene.contact().unwrap();
    // the speed of the readings is a column of the data, or the key that is fitted
    let fitted_speed = keys.iter().find(|(path, _)| *path == SPEED.0).map(|(_, speed)| *speed);
    let speed = |i| fitted_speed.unwrap_or(0.3 * 17_f64.powf(f64::from(i) / f64::from(readings - 1)));
    let speeds: Vec<f64> = (0..readings).map(speed).collect();
    let range = |(path, truth): &(&str, f64)| FreeKey {
        key: NumericKey::find(path).unwrap(),
        from: 0.5 * truth,
        to: 2.0 * truth,
        is_logarithmic: true,
        hardness: None,
    };
    let free: Vec<FreeKey> = keys.iter().map(range).collect();
    let exact = |(row, speed): (usize, &f64)| {
        let impact = contact.closed_form(*speed).unwrap();
        let value = |name: &&str| {
            let quantity = MeasuredQuantity::from_name(name).unwrap();
            MeasuredValue { row, quantity, value: quantity.predict(&impact.row, &scene).unwrap(), deviation: None }
        };
        quantities.iter().map(value).collect::<Vec<_>>()
    };
    let exact: Vec<MeasuredValue> = speeds.iter().enumerate().flat_map(exact).collect();
    let hits = (0..sets).into_par_iter().map(|set| {
        let noisy = exact.iter().zip(normals(set, exact.len()));
        let data = MeasurementData {
            name: "made".to_owned(),
            keys: NumericKey::find(SPEED.0).into_iter().filter(|_| fitted_speed.is_none()).collect(),
            rows: speeds
                .iter()
                .map(|speed| MeasurementRow {
                    keys: Some(*speed).into_iter().filter(|_| fitted_speed.is_none()).collect(),
                    ..MeasurementRow::default()
                })
                .collect(),
            values: noisy
                .map(|(value, noise)| MeasuredValue { value: value.value * (1.0 + sd * noise), ..*value })
                .collect(),
        };
        let share = if is_estimated { 1.0 } else { sd };
        let noise_model = NoiseModel { instrument: vec![0.0; exact.len()], share, is_estimated };
        let deviations = noise_model.deviations(&data.error_scales());
        let fit = Fit::new(CalibrationProblem::new(&scene, &free, &data, deviations, is_robust), &noise_model).unwrap();
        let of_key = |key: usize| {
            fit.intervals(key).map(|[low, high]| {
                let [low, high] = [
                    low.map_or(0.0, |end| free[key].value_at_share(end)),
                    high.map_or(f64::MAX, |end| free[key].value_at_share(end)),
                ];
                (low..=high).contains(&keys[key].1)
            })
        };
        (0..keys.len()).map(of_key).collect()
    });
    let hits: Vec<Vec<[bool; 2]>> = hits.collect();
    #[allow(clippy::cast_precision_loss)] // a few thousand
    let share = |key: usize| [0, 1].map(|level| hits.iter().filter(|hit| hit[key][level]).count() as f64 / sets as f64);
    (0..keys.len()).map(share).collect()
}

#[test]
fn intervals_cover_truth_at_stated_rate() {
    // with shares of the readings in place of shares of what the law gives, half of the sets with much noise were in their
    // 68 %, whether the noise is given or estimated
    let much = SyntheticData { readings: 16, sd: 0.12, ..PLAIN };
    for made in [
        PLAIN,
        SyntheticData { is_estimated: true, ..PLAIN },
        much,
        SyntheticData { is_estimated: true, ..much },
        SyntheticData { quantities: &["peak_force"], ..PLAIN },
        SyntheticData { sets: 100, quantities: &["restitution", "peak_force"], keys: &[STRENGTH, MODULUS], ..PLAIN },
    ] {
        for key in coverage_shares(made) {
            // within 3.5 standard deviations of the share in `made.sets` independent sets
            for (share, level) in key.into_iter().zip([0.682_69, 0.95]) {
                #[allow(clippy::cast_precision_loss)]
                let deviation = f64::sqrt(level * (1.0 - level) / made.sets as f64);
                assert!((share - level).abs() < 3.5 * deviation, "{made:?}: {share} for {level}");
            }
        }
    }
}

/// Ten dents of one shot, whose diameters scatter by 3 %.
#[test]
fn speed_intervals_from_dents_cover_truth() {
    let made = SyntheticData {
        sets: 200,
        readings: 10,
        sd: 0.03,
        is_estimated: true,
        quantities: &["dent_diameter"],
        keys: &[SPEED],
        ..PLAIN
    };
    for key in coverage_shares(made) {
        for (share, level) in key.into_iter().zip([0.682_69, 0.95]) {
            // within 3.5 standard deviations of the share in 200 independent sets
            let deviation = f64::sqrt(level * (1.0 - level) / 200.0);
            assert!((share - level).abs() < 3.5 * deviation, "{share} for {level}");
        }
    }
}

/// The likelihood with long tails is wider than normal noise needs: it covers at least as often.
#[test]
fn robust_intervals_cover_truth_at_least_as_often() {
    let [[narrow, wide]] = coverage_shares(SyntheticData { readings: 12, is_robust: true, ..PLAIN })[..] else {
        panic!()
    };
    assert!((0.6..0.9).contains(&narrow) && (0.92..=1.0).contains(&wide), "{narrow} {wide}");
}
