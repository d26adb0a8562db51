//! The readers of users' files, for the mutated files of `program/interfaces/mutated_files.rs` and for the targets in `fuzz`.

use std::fs;
use std::path::Path;

use plm_impact::calibrate::CalibrationTask;
use plm_impact::error::Error;
use plm_impact::scenario::{Kind, Scenario};

/// Bodies on which every reader below has something to read.
const BODIES: &str = "[sphere]\nradius = 5e-3\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\ndensity = 7850\n\
    [half_space]\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\nyield_strength = 3.45e8\n";

/// Measurements for a scenario of a calibration.
const DATA: &str = "drop_height_m,rebound_height_m,restitution\n0.1,0.04,\n0.5,,0.5\n";

/// Reads a scenario, up to the contact or the plan of its table.
pub fn read_scenario(text: &str) -> Result<(), Error> {
    let scenario = Scenario::from_text("s.toml", text, &[])?.with_data(DATA.to_owned());
    match scenario.kind()? {
        Kind::Sweep | Kind::MonteCarlo => scenario.plan().map(drop),
        Kind::Calibrate => scenario.calibration_request().map(drop),
        Kind::Indentation => scenario.indentation().map(drop),
        kind @ (Kind::Impact | Kind::Repeat) => {
            let input = scenario.resolve()?;
            // a contact without an answer is a result, and no error of reading
            drop(input.contact());
            if kind == Kind::Repeat { scenario.series(&input).map(drop) } else { Ok(()) }
        }
    }
}

/// Reads measurements.
pub fn read_measurements(text: &str) -> Result<(), Error> {
    let calibrate = "[calibrate]\ndata = \"d.csv\"\n\
        free = { \"half_space.yield_strength\" = { from = 1e8, to = 1e9 } }\n[gravity]\nacceleration = 9.81\n";
    let scenario = Scenario::from_text("s.toml", &format!("{BODIES}{calibrate}"), &[])?.with_data(text.to_owned());
    CalibrationTask::new(&scenario).map(drop)
}

/// Reads a flow curve, which is a file in this folder.
pub fn read_flow_curve(folder: &Path, text: &str) -> Result<(), Error> {
    let scenario = folder.join("s.toml");
    let table = "flow_stress = { table = \"flow.csv\" }\n[impact]\nspeed = 3\n";
    let failed = |error: std::io::Error| Error::failed(error.to_string());
    fs::write(folder.join("flow.csv"), text).map_err(failed)?;
    fs::write(&scenario, format!("{BODIES}{table}")).map_err(failed)?;
    let input = Scenario::load(&scenario, &[])?.resolve()?;
    drop(input.contact());
    Ok(())
}
