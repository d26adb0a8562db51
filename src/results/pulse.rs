//! The columns of the files of a pulse: `pulse.csv` and `spectrum.csv`.

use super::{ResultSpec, result_specs};

/// The columns of the pulse; a row is a time and a force.
pub fn pulse_results() -> Vec<ResultSpec<(f64, f64)>> {
    result_specs! { |row: (f64, f64)|
        /// Time since first contact.
        "time_s" in Time: row.0;
        /// Force on the sphere, including damping.
        "force_N" in Force: row.1;
    }
}

/// The columns of the spectrum; a row is a frequency and a magnitude.
pub fn spectrum_results() -> Vec<ResultSpec<(f64, f64)>> {
    result_specs! { |row: (f64, f64)|
        /// Frequency.
        "frequency_Hz" in Frequency: row.0;
        /// Magnitude of the Fourier transform of the force.
        "force_spectrum_N_s" in Impulse: row.1;
    }
}
