//! Synthetic data of known strength: how often the interval contains the true value.

use crate::common::prelude::*;
use plm_impact::calibrate::data::{Data, Row, Value};
use plm_impact::calibrate::problem::Problem;
use plm_impact::math::functions::normal_quantile;
use plm_impact::plan::free::Free;
use plm_impact::scene::measured::Measured;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;

const TRUTH: f64 = 345e6;

/// Normally distributed numbers with mean 0 and sd 1, the same in every run of the test. Every set is a stream of its own of
/// ChaCha, so the sets are independent.
fn normals(set: u64, count: usize) -> Vec<f64> {
    let mut generator = ChaCha8Rng::seed_from_u64(99);
    generator.set_stream(set);
    #[allow(clippy::cast_precision_loss)] // 53 bits
    let mut next = || normal_quantile(((generator.next_u64() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64);
    (0..count).map(|_| next()).collect()
}

/// The shares of the sets whose 68 % and 95 % intervals contain the true value, where the readings scatter by `sd`.
fn covered(sets: u64, readings: u32, sd: f64, is_estimated: bool) -> [f64; 2] {
    let scene = Scenario::from_text("steel", crate::common::STEEL, &[]).unwrap().resolve().unwrap();
    let contact = scene.contact().unwrap();
    let speeds: Vec<f64> = (0..readings).map(|i| 0.3 * 17_f64.powf(f64::from(i) / f64::from(readings - 1))).collect();
    let exact: Vec<f64> = speeds.iter().map(|speed| contact.closed_form(*speed).unwrap().restitution).collect();
    let range = |path, from, to| Free { key: Key::find(path).unwrap(), from, to, is_logarithmic: true };
    let free = [range("half_space.yield_strength", 200e6, 600e6)];
    let what = Measured::find("restitution").unwrap();
    let hits = (0..sets).into_par_iter().map(|set| {
        let noise = normals(set, speeds.len());
        let value = |row: usize| Value { row, what, value: exact[row] * (1.0 + sd * noise[row]), deviation: None };
        let data = Data {
            name: "made".to_owned(),
            keys: vec![Key::find("impact.speed").unwrap()],
            rows: speeds.iter().map(|speed| Row { keys: vec![*speed], ..Row::default() }).collect(),
            values: (0..speeds.len()).map(value).collect(),
        };
        let deviations = if is_estimated {
            data.values.iter().map(|value| value.value).collect()
        } else {
            exact.iter().map(|e| sd * e).collect()
        };
        let fit = Fit::of(Problem::new(&scene, &free, &data, deviations, false), is_estimated).unwrap();
        fit.intervals(0).map(|ends| {
            let [low, high] = ends.map(|end| free[0].at(end.unwrap()));
            low <= TRUTH && TRUTH <= high
        })
    });
    let hits: Vec<[bool; 2]> = hits.collect();
    #[allow(clippy::cast_precision_loss)] // a few thousand
    [0, 1].map(|level| hits.iter().filter(|hit| hit[level]).count() as f64 / sets as f64)
}

#[test]
fn intervals_cover_the_truth_as_often_as_they_say() {
    // with a noise of shares of the readings in place of shares of what the law gives, half of the last sets were in their 68 %
    for (sets, readings, sd, is_estimated) in [(600, 6, 0.01, false), (300, 6, 0.01, true), (300, 16, 0.12, true)] {
        let [narrow, wide] = covered(sets, readings, sd, is_estimated);
        // within 3.5 standard deviations of the share of so many independent sets
        for (share, level) in [(narrow, 0.682_69), (wide, 0.95)] {
            #[allow(clippy::cast_precision_loss)]
            let deviation = f64::sqrt(level * (1.0 - level) / sets as f64);
            assert!((share - level).abs() < 3.5 * deviation, "{readings} readings: {share} for {level}");
        }
    }
}
