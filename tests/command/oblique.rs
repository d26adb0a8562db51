//! Oblique impacts in scenarios. Which results and columns an angle adds is in `holds.toml`, their numbers are in
//! tests/same_numbers (oblique.toml), and the balances of energy and momentum in tests/physics.

use crate::common::prelude::*;

#[test]
fn e_of_an_oblique_impact_is_that_of_the_normal_speed() {
    let angle = STEEL.replace("3 m/s\"", "3 m/s\"\nangle = \"20 deg\"") + "[friction]\ncoefficient = 0.15\n";
    for (scene, speed) in [(STEEL.to_owned(), 3.0), (angle, 3.0 * 20_f64.to_radians().cos())] {
        let summary = Desk::ran(scene).summary();
        let number = |name: &str| summary[name].as_f64().unwrap();
        assert!(off(number("rebound_speed_m_per_s"), number("restitution") * speed) < 1e-12, "{summary}");
    }
}
