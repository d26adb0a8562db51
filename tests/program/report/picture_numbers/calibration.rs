//! Pictures of calibrations.

use super::runs::PALE_SKY;
use super::*;

/// Restitution and peak force near those of 345 MPa.
pub const DATA: &str = "speed_m_per_s,restitution,peak_force_N
0.5,0.6623,157.5\n1.2,0.5753,402.5\n2.5,0.527,928.9\n4,0.4871,1482\n5,0.4297,1830\n";

const SPEED: &str = "impact_speed_m_per_s";

/// The sum of squares of these keys over that of the best: 68.27 % and 95 % of two normal keys lie within.
const REGIONS: [f64; 2] = [2.295_75, 5.991_46];

fn calibration() -> Drawing {
    let scenario = STEEL.replace("yield_strength = \"345 MPa\"\n", "").replace("[impact]\nspeed = \"3 m/s\"\n", "")
        + "[calibrate]\ndata = \"d.csv\"\nlaws = [\"plm\", \"thornton\"]\nnoise = { restitution = 0.01, peak_force = 20 }\n"
        + "[calibrate.free]\n\"half_space.yield_strength\" = { from = \"100 MPa\", to = \"1 GPa\" }\n"
        + "\"half_space.youngs_modulus\" = { from = \"50 GPa\", to = \"500 GPa\" }\n";
    let of =
        |kind, picture, form, only, column| shown(kind, picture, 0, form, columns("residuals", only, [SPEED, column]));
    let (e, force) = (&[("quantity", "restitution")], &[("quantity", "peak_force")]);
    let bars = |results: &Results| -> Points {
        let ends = |row: TableRow| {
            [-1.0, 1.0].map(|side| (cell(&row, SPEED), cell(&row, "measured") + side * cell(&row, "sd")))
        };
        table(results, "residuals", &[("quantity", "restitution")]).into_iter().flat_map(ends).collect()
    };
    let (fitted, residuals, laws) = ("calibrate::fit_chart", "calibrate::residual_chart", "calibrate::law_chart");
    drawing(
        scenario,
        vec![
            of(fitted, "fit_restitution", Through(VERMILLION), e, "predicted"),
            of(fitted, "fit_restitution", Marks(BLUE), e, "measured"),
            shown(fitted, "fit_restitution", 0, Through(BLUE), bars),
            of(fitted, "fit_peak_force", Through(VERMILLION), force, "predicted"),
            of(fitted, "fit_peak_force", Marks(BLUE), force, "measured"),
            of(residuals, "residuals", Marks(BLUE), e, "residual_over_sd"),
            of(residuals, "residuals", Marks(VERMILLION), force, "residual_over_sd"),
            of(laws, "laws", Marks(BLACK), e, "measured"),
            of(laws, "laws", Through(BLUE), e, "predicted"),
            shown(laws, "laws", 0, Through(VERMILLION), |results| {
                let keys = &results.summary()["laws"][1];
                assert_eq!(keys["law"], "thornton");
                let law = "law=\"thornton\"".to_owned();
                computed([&keys["values"][0], &keys["values"][1]].map(|value| value.as_f64().unwrap()), &[law])
                    .into_iter()
                    .map(|[speed, e, _]| (speed, e))
                    .collect()
            }),
        ],
    )
}

/// Speed, restitution and peak force of the measured impacts with this strength and modulus.
fn computed([strength, modulus]: [f64; 2], set: &[String]) -> Vec<[f64; 3]> {
    let speeds = numbers(DATA, "speed_m_per_s");
    let keys = [
        format!("half_space.yield_strength={strength}"),
        format!("half_space.youngs_modulus={modulus}"),
        format!("sweep.\"impact.speed\"={speeds:?}"),
    ];
    let rows = rows_of(STEEL, &[&keys, set].concat()).results;
    let row = |(speed, row): (f64, Result<ImpactRow, RowFailure>)| {
        let row = row.unwrap();
        [speed, row.restitution, row.peak_force]
    };
    speeds.into_iter().zip(rows).map(row).collect()
}

fn sum_of_squares(keys: [f64; 2]) -> f64 {
    let measured = ["restitution", "peak_force_N"].map(|column| numbers(DATA, column));
    let square = |(i, [_, e, force]): (usize, [f64; 3])| {
        ((measured[0][i] - e) / 0.01).powi(2) + ((measured[1][i] - force) / 20.0).powi(2)
    };
    computed(keys, &[]).into_iter().enumerate().map(square).sum()
}

pub static ALL: LazyLock<Vec<Drawing>> = LazyLock::new(|| vec![calibration()]);

#[test]
fn calibration_pictures_show_numbers_of_tables() {
    check(&ALL);
    regions_end_where_the_sum_of_squares_has_risen_enough(&ALL[0].results);
}

/// At the outline of both regions the sum of squares, computed anew, is above the least one by what two normal keys give.
fn regions_end_where_the_sum_of_squares_has_risen_enough(results: &Results) {
    let drawn = results.picture("posterior");
    let [x, y] = drawn.scales(0);
    let summary = results.summary();
    let best = [0, 1].map(|key| summary["keys"][key]["estimate"].as_f64().unwrap());
    let least = sum_of_squares(best);
    assert_relative_eq!(least, summary["chi_square"].as_f64().unwrap(), max_relative = 1e-9);
    // a stroke of the cross has the best keys in its middle
    let is_in = drawn.is_in(0);
    let is_seen = |line: &Vec<(f64, f64)>| is_in(line[0]);
    let cross = drawn.lines(BLACK).into_iter().find(is_seen).unwrap();
    assert!(distance((x.place(best[0]), y.place(best[1])), &cross) < UNITS, "{cross:?}");
    let regions = drawn.areas(PALE_SKY);
    assert_eq!(regions.len(), 2);
    for (region, rise) in regions.into_iter().zip(REGIONS) {
        assert!(region.len() > 60, "{}", region.len());
        for (across, up) in region.into_iter().step_by(9) {
            let risen = sum_of_squares([x.value(across), y.value(up)]) - least;
            assert!((risen / rise - 1.0).abs() < 0.03, "{risen} for {rise}");
        }
    }
}
