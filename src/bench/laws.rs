//! How long a row of a table takes under each law: one contact, many speeds; and how long the contact takes to make.

use std::hint::black_box;

use super::measure::time_call;
use super::problems::steel_on_steel;
use crate::contact::law::{LawChoice, Plm, UnloadingExponent};
use crate::contact::strength::flow_curve::FlowCurve;
use crate::impact::Approach;
use crate::impact::{ImpactError, Solver};
use crate::numerics::functions::pow;

/// The measured times of a law.
#[derive(Debug, Clone, PartialEq)]
pub struct LawTiming {
    /// Its name, with what is more.
    pub law: String,
    /// Best time of one row \[ns\].
    pub ns_per_row: f64,
    /// Best time of making the contact \[ns\].
    pub ns_per_contact: f64,
}

/// 20 degrees \[rad\], and a coefficient of friction at which the contact slips in part.
const OBLIQUE: [f64; 2] = [0.349_065_850_398_865_9, 0.15];

/// Rows from 5 cm/s to 10 m/s.
const ROWS: u32 = 1000;

/// Contacts that are timed together, because the clock is too coarse for one, behind one that is not timed: code and data of this
/// law are then in the caches, as they are for the rows.
const CONTACTS: u32 = 20;

/// Times every law that loads, a steel ball of 5 mm radius on steel of 345 MPa; the PLM also with the other exponent of unloading and
/// on a half-space that hardens, and at an angle. The laws take turns.
pub fn law_timings(rounds: u32) -> Result<Vec<LawTiming>, ImpactError> {
    let shaped = Plm { exponent: UnloadingExponent::PressureShape, ..Plm::default() };
    let hardened = Plm { flow: [None, Some(FlowCurve::Power { exponent: 0.2 })], ..Plm::default() };
    let named = LawChoice::all().into_iter().filter(LawChoice::has_loading).map(|law| (law.name(), law, None));
    let more = [
        ("plm, pressure-shape", shaped, None),
        ("plm, hardened", hardened, None),
        ("plm, at 20 deg with friction", Plm::default(), Some(OBLIQUE)),
    ];
    let more = more.map(|(name, plm, oblique)| (name.to_owned(), LawChoice::Plm(plm), oblique));
    let laws: Vec<(String, LawChoice, Option<[f64; 2]>)> = named.chain(more).collect();
    let mut rates: Vec<LawTiming> = laws
        .iter()
        .map(|(law, ..)| LawTiming { law: law.clone(), ns_per_row: f64::INFINITY, ns_per_contact: f64::INFINITY })
        .collect();
    let speeds: Vec<f64> = (0..ROWS).map(|row| 0.05 * pow(200.0, f64::from(row) / f64::from(ROWS))).collect();
    for _ in 0..rounds {
        for (rate, (_, law, oblique)) in rates.iter_mut().zip(&laws) {
            let contact = steel_on_steel(law.as_contact_law())?;
            let ((), ns) = time_call(|| {
                for _ in 0..CONTACTS {
                    black_box(steel_on_steel(black_box(law.as_contact_law())).ok());
                }
            });
            rate.ns_per_contact = rate.ns_per_contact.min(ns / f64::from(CONTACTS));
            // a law may refuse some of the speeds
            let ((), ns) = time_call(|| {
                for &speed in &speeds {
                    let approach = oblique
                        .map_or(speed.into(), |[angle, friction]| Approach::at_angle(speed, angle, 0.0, friction));
                    black_box(contact.row(black_box(approach), &Solver::AUTO).ok());
                }
            });
            rate.ns_per_row = rate.ns_per_row.min(ns / f64::from(ROWS));
        }
    }
    Ok(rates)
}
