//! Warnings about a run: its error is too large, or it creates energy.

use crate::impact::problem::contact::Contact;
use crate::impact::problem::waveguide::WaveguideKind;
use crate::impact::result::impact::Impact;
use crate::impact::result::warning::{Warning, WarningKind};
use crate::impact::solve::{Method, Solver};
use crate::numerics::power::nan_max;

/// A restitution above 1 by more than this is shown as more than 1 by a number with three digits.
const SHOWN_GAIN: f64 = 5e-4;

/// The warning of an impact that gains energy: e, or the fraction of energy that a plate or rod absorbs, exceeds 1 by more than rounding
/// and the error of the run, or by so much that a number with three digits shows it. By the work of gravity alone a sphere that
/// sinks into its dent may leave faster than it came.
pub(super) fn energy_gain_warning(contact: &Contact, impact: &Impact, method: Method) -> Option<Warning> {
    let (known, balance_error) = (impact.accuracy.restitution_error, impact.energy.balance_error);
    let gravity = contact.forces().gravity.unwrap_or(0.0);
    // the error of the balance is relative to all the energy put in, e to the kinetic energy of the impact
    let sunk = contact.mass() * gravity * impact.row.peak_indentation;
    let error = if known.is_nan() { balance_error * (1.0 + sunk / impact.energy.kinetic_in) } else { known };
    let of_kind = |kind| impact.row.waveguide_loss_fraction(kind).map(|share| (kind, share));
    let absorbed = of_kind(WaveguideKind::Plate).or_else(|| of_kind(WaveguideKind::Rod));
    let (name, share) = match absorbed.filter(|(_, share)| *share > 1.0 && method == Method::Verlet) {
        Some((WaveguideKind::Plate, share)) => ("The plate loss is too high: its fraction", share),
        Some((WaveguideKind::Rod, share)) => ("The rod loss is too high: its fraction", share),
        None => ("e is too high: restitution", impact.row.restitution),
    };
    let is_by_weight = gravity > 0.0 && impact.energy.plastic.is_none_or(|plastic| plastic >= 0.0);
    let is_gain = share > 1.0 + (1e-12 + 10.0 * error).min(SHOWN_GAIN) && !is_by_weight;
    Warning::new_if(is_gain, WarningKind::EnergyGain, share, || {
        let reason = match method {
            Method::Verlet => COARSE_STEPS_TEXT.to_owned(),
            _ => format!(
                "Use 1. Either the integration is too coarse (energy balance error {balance_error:.1e}); then reduce solver.tolerance or use another method. Or a second impact ended just beyond a segment boundary of the loading curve, where the law gains a little energy."
            ),
        };
        format!("{name} = {share:.6} exceeds 1. {reason}")
    })
}

/// An error of the energy balance of fixed steps above this one is warned of.
const MAX_BALANCE_ERROR: f64 = 1e-2;
/// Why a run in fixed steps is inaccurate, and the remedy.
const COARSE_STEPS_TEXT: &str = "The fixed steps are too long for this contact. Increase solver.steps_per_contact, or use another method than verlet.";

/// An energy drift above this multiple of the tolerance is warned of.
const MAX_TOLERANCES_OF_BALANCE: f64 = 1000.0;
/// A difference from the closed form above this multiple of the tolerance is warned of.
const MAX_TOLERANCES: f64 = 100.0;

/// The warning of a run that is further from the closed form than its tolerance allows or, without a closed form, of one
/// that has lost energy. Damping is not smooth at first contact, which costs the methods of `ode_solvers` up to three digits.
pub(super) fn run_warning(impact: &Impact, &Solver { method, tolerance, .. }: &Solver) -> Option<Warning> {
    let balance_error = impact.energy.balance_error;
    let error = nan_max(impact.accuracy.restitution_error, impact.accuracy.contact_time_error);
    let way_out = "Reduce solver.tolerance or use another method.";
    if method == Method::Verlet {
        Warning::new_if(
            balance_error > MAX_BALANCE_ERROR || balance_error.is_nan(),
            WarningKind::EnergyImbalance,
            balance_error,
            || {
                format!(
                    "The numerical error may be large: energy balance error {balance_error:.1e}. {COARSE_STEPS_TEXT}"
                )
            },
        )
    } else if impact.accuracy.closed_form_restitution.is_nan() {
        let is_open = balance_error > MAX_TOLERANCES_OF_BALANCE * tolerance || balance_error.is_nan();
        Warning::new_if(is_open, WarningKind::EnergyImbalance, balance_error, || {
            format!(
                "The numerical error may be large: energy balance error {balance_error:.1e}, more than {MAX_TOLERANCES_OF_BALANCE} x the tolerance {tolerance:.1e}. {way_out}"
            )
        })
    } else {
        let is_inaccurate = error > MAX_TOLERANCES * tolerance || error.is_nan();
        Warning::new_if(is_inaccurate, WarningKind::Inaccurate, error, || {
            format!(
                "The numerical error exceeds the tolerance: difference from the closed form {error:.1e}, more than {MAX_TOLERANCES} x the tolerance {tolerance:.1e}. {way_out}"
            )
        })
    }
}
