//! Elastic waves in the results: where the half-space has a density, and only there.

use crate::common::prelude::*;

const SCENARIO: &str = include_str!("../../scenarios/alumina-on-aluminium-with-waves.toml");

#[test]
fn waves_are_reported_where_the_density_is_given_and_only_there() {
    let without = SCENARIO.replace("density = \"2700 kg/m^3\"\n", "");
    let swept = "[sweep]\n\"impact.speed\" = [\"1 mm/s\", 3]\n";
    for (scene, is_there) in [(SCENARIO, true), (without.as_str(), false)] {
        let desk = Desk::with(scene);
        let (printed, _) = desk.ends(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
        assert_eq!(printed.contains("waves take 1.317 % of the normal energy"), is_there, "{printed}");
        assert_eq!((printed + &desk.read("out/summary.json")).contains("wave"), is_there);
        let table = Desk::ran(format!("{scene}{swept}")).read("out/table.csv");
        assert_eq!(table.contains(",plastic_fraction,wave_loss_fraction,restitution_with_waves,status\n"), is_there);
        if is_there {
            let summary = desk.summary();
            for name in ["wave_loss_fraction", "restitution_with_waves"] {
                assert!(off(numbers(&table, name)[1], summary[name].as_f64().unwrap()) < 1e-8, "{name}");
            }
        }
    }
    // the density is an axis; W_rad is proportional to √ρ c_s^−3, and so to ρ² for given moduli
    let table = Desk::ran(format!("{without}[sweep]\n\"half_space.density\" = [2700, 10800]\n")).read("out/table.csv");
    let losses = numbers(&table, "wave_loss_fraction");
    assert!(off(losses[1], 2.0 * losses[0]) < 1e-13, "{losses:?}");
}

#[test]
fn bounces_report_what_waves_take() {
    let bouncing = SCENARIO.to_owned() + "[gravity]\nacceleration = 9.81\n[repeat]\nspot = \"same\"\nimpacts = 4\n";
    let desk = Desk::ran(bouncing);
    let (impacts, summary) = (desk.read("out/impacts.csv"), desk.summary());
    let all = |name: &str| numbers(&impacts, name);
    for (at, rebound) in all("rebound_speed_m_per_s").into_iter().enumerate() {
        let speed = all("restitution_with_waves")[at] * all("impact_speed_m_per_s")[at];
        assert!(off(rebound, speed) < 1e-14 && all("restitution_with_waves")[at] < all("restitution")[at]);
    }
    assert!(off(summary["energy"]["waves_J"].as_f64().unwrap(), all("waves_J").iter().sum()) < 1e-14);
    assert!(off(summary["final_restitution"].as_f64().unwrap(), all("restitution_with_waves")[3]) < 1e-14);
}
