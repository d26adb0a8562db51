//! States of a contact with their forces, by the law of this library: the vectors that a build of the header must reproduce.

use std::fmt::Write as _;

use crate::impact::{Contact, Memory};

/// The contacts, and the states of each.
const N_CONTACTS: u32 = 8;
/// The steps of each of the five ways of a contact.
const N_STEPS: u32 = 25;
/// The peaks of the first and the last contact, as fractions of the first yield and of the deepest state.
const FIRST_PEAK: f64 = 0.3;
/// Without a limit of the law, the deepest state as a fraction of the smaller radius.
const MAX_DEPTH: f64 = 0.5;

/// States with force, memory afterwards, energies and stiffness, at 17 digits. Each contact loads, unloads, reloads along the branch,
/// loads beyond its old peak, unloads, and separates; its memory is zero before its first state.
pub fn vectors_csv(contact: &Contact, name: &str) -> String {
    let mut text = format!(
        "# plm_{name}_vectors.csv: states of contacts by the law of plm_{name}.h; a contact ends where the indentation is 0 or less\n\
         indentation_m,force_N,peak_indentation_m,peak_force_N,elastic_approach_m,stored_energy_J,plastic_work_J,stiffness_N_per_m\n"
    );
    let deepest = contact.validated_indentation().min(MAX_DEPTH * contact.pair().smaller_radius);
    let yield_depth = contact.yield_indentation_and_force().map_or(1e-3 * deepest, |(indentation, _)| indentation);
    let first = (FIRST_PEAK * yield_depth).min(0.1 * deepest);
    for number in 0..N_CONTACTS {
        let share = f64::from(number) / f64::from(N_CONTACTS - 1);
        let peak = first * crate::numerics::functions::pow(deepest / first, share);
        let mut memory = Memory::default();
        for indentation in path(contact, peak) {
            let force = contact.force(indentation, &mut memory);
            let energy = contact.energy(indentation, force, &memory);
            let Memory { indentation: largest, force: peak_force, elastic_approach } = memory;
            let stiffness = contact.stiffness(indentation, &memory);
            let _ = writeln!(
                text,
                "{indentation:.16e},{force:.16e},{largest:.16e},{peak_force:.16e},{elastic_approach:.16e},{:.16e},{:.16e},{stiffness:.16e}",
                energy.stored, energy.plastic
            );
        }
    }
    text
}

/// The indentations of a contact: up to three quarters of the peak, back along its branch, up to the peak, down, and out.
fn path(contact: &Contact, peak: f64) -> Vec<f64> {
    let residual = |largest: f64| {
        let mut memory = Memory::default();
        contact.force(largest, &mut memory);
        memory.dent_depth()
    };
    let first = 0.75 * peak;
    let turn = residual(first) + 0.2 * (first - residual(first));
    let turns = [0.0, first, turn, peak, residual(peak) + 0.5 * (peak - residual(peak)), -0.02 * peak];
    let ways = turns.windows(2).flat_map(|ends| {
        let (from, to) = (ends[0], ends[1]);
        (1..=N_STEPS).map(move |step| from + f64::from(step) / f64::from(N_STEPS) * (to - from))
    });
    ways.collect()
}
