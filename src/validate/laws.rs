//! Every law on the same impacts by finite elements: the table that helps to choose a law.
//!
//! Three of the impacts were computed as such. The others are load cycles, which stand for impacts with the same energy;
//! they have no contact time.

use super::comparison::{EXPONENTS, deviation, rms};
use super::dynamic::dynamic_scenarios;
use crate::contact::body::{HalfSpace, Sphere};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients};
use crate::error::Error;
use crate::impact::{Contact, ImpactRow, Solver};
use crate::reference::quasi_static;

/// The deviations of a law from the finite elements, as root mean squares.
#[derive(Debug, Clone)]
pub struct LawDeviations {
    pub name: String,
    /// Number of the impacts for which the law has an answer.
    pub impacts: usize,
    /// The values belong to restitution, peak force, dent depth (over the peak indentation) and contact time.
    pub rms: [f64; 4],
}

/// An impact by finite elements.
struct ReferenceImpact {
    sphere: Sphere,
    half_space: HalfSpace,
    speed: f64,
    restitution: f64,
    peak_force: f64,
    peak_indentation: f64,
    residual_indentation: f64,
    contact_time: Option<f64>,
}

impl ReferenceImpact {
    /// Deviations of a result of a law, in the order of [`LawDeviations::rms`].
    fn deviations(&self, by_law: &ImpactRow) -> [Option<f64>; 4] {
        let restitution = by_law.measured_restitution();
        [
            Some(deviation(self.restitution, restitution)),
            Some(deviation(self.peak_force, by_law.peak_force)),
            Some((by_law.residual_indentation - self.residual_indentation) / self.peak_indentation),
            self.contact_time.map(|time| deviation(time, by_law.contact_time)),
        ]
    }
}

/// All impacts on half-spaces that do not harden.
fn reference_impacts() -> Result<Vec<ReferenceImpact>, Error> {
    let mut all = Vec::new();
    for (input, row, samples) in dynamic_scenarios()? {
        all.push(ReferenceImpact {
            sphere: input.sphere(),
            half_space: input.half_space(),
            speed: input.speed(),
            restitution: row.number("restitution"),
            peak_force: row.number("peak_force_N"),
            peak_indentation: samples.iter().map(|sample| sample.number("indentation_m")).fold(0.0, f64::max),
            residual_indentation: row.number("residual_indentation_m"),
            contact_time: row.optional_number("contact_time_s"),
        });
    }
    for (sphere, half_space, row) in quasi_static::load_cycles() {
        let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
        let Some(unit) = contact.pair().yield_point else { continue };
        let [x, f, spent] = ["x", "f", "spent"].map(|column| row.number(column));
        all.push(ReferenceImpact {
            sphere,
            half_space,
            speed: (2.0 * spent * unit.force * unit.indentation / contact.reduced_mass()).sqrt(),
            restitution: row.number("restitution"),
            peak_force: f * unit.force,
            peak_indentation: x * unit.indentation,
            residual_indentation: row.number("residual_share") * x * unit.indentation,
            contact_time: None,
        });
    }
    Ok(all)
}

/// Every law of the program with its default parameters, and the PLM with these coefficients; the nearest restitution first.
pub fn law_deviations(coefficients: &PlmCoefficients) -> Result<Vec<LawDeviations>, Error> {
    let of_plm = |(exponent, name)| (format!("plm, {name}"), LawChoice::Plm(Plm::new(coefficients, exponent)));
    // the law of Brake only unloads
    let published = LawChoice::all().into_iter().chain(LawChoice::from_name("jackson_green + brake"));
    let published = published.filter(|law| law.has_loading() && !matches!(law, LawChoice::Plm(_)));
    let references = reference_impacts()?;
    let of_law = |(name, law): (String, LawChoice)| {
        let answer = |one: &ReferenceImpact| {
            let contact = Contact::try_new(one.sphere, one.half_space, law.as_contact_law()).ok()?;
            Some(one.deviations(&contact.row(one.speed, &Solver::AUTO).ok()?))
        };
        let off: Vec<[Option<f64>; 4]> = references.iter().filter_map(answer).collect();
        let rms_of = |column: usize| rms(&off.iter().filter_map(|off| off[column]).collect::<Vec<_>>());
        LawDeviations { name, impacts: off.len(), rms: [0, 1, 2, 3].map(rms_of) }
    };
    let all = EXPONENTS.into_iter().map(of_plm).chain(published.map(|law| (law.name(), law)));
    let mut laws: Vec<LawDeviations> = all.map(of_law).collect();
    laws.sort_by(|a, b| a.rms[0].total_cmp(&b.rms[0]));
    Ok(laws)
}
