//! What an impact comes to: dimensionless, and in SI units as every report and plot reads it.

use super::course::{Event, Point};
use super::essentials::Essentials;
use super::forced::Fate;
use super::scales::Scales;
use super::validity::{self, Warning};
use super::with_forces::UnderForces;
use super::{Contact, ImpactError, Method};
use crate::integrate::{IntegrationError, Work};
use crate::law::{Law, Peak, Unloading};
use crate::power::max_or_nan;

/// The outcome of an impact in dimensionless form, however it was obtained.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// The unloading branch: peak state and exponent.
    pub unloading: Unloading,
    /// e: rebound speed over impact speed.
    pub restitution: f64,
    /// Time of compression.
    pub loading_time: f64,
    /// Time from first touch to separation.
    pub contact_time: f64,
}

/// Where the kinetic energy went \[J\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy {
    /// ½ m v².
    pub kinetic_in: f64,
    /// ½ m (e v)².
    pub recovered: f64,
    /// Spent on the dent, W(δ_m) − F_m δ_e/(n + 1); `None` for a half-space without a yield strength.
    pub plastic: Option<f64>,
    /// Largest |kinetic + stored + lost − ½ m v²| / ½ m v² at the peak, at separation and on every row of the trace: the
    /// error of the run as the run itself can see it.
    pub drift: f64,
}

/// The error of the integration against the closed form (both relative).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    /// e of the closed form.
    pub closed_form_restitution: f64,
    /// |e − e_exact| / e_exact.
    pub restitution_error: f64,
    /// |T − T_exact| / T_exact.
    pub contact_time_error: f64,
}

/// Which branch of the law a trace row is on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Branch {
    /// Loading without a dent so far.
    Elastic,
    /// Loading, dent growing.
    Plastic,
    /// Loading in a dent of an earlier impact, up its unloading branch.
    Reloading,
    /// Unloading.
    Unloading,
}

impl Branch {
    /// `elastic`, `plastic`, `reloading` or `unloading`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::Plastic => "plastic",
            Self::Reloading => "reloading",
            Self::Unloading => "unloading",
        }
    }
}

/// One row of a trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceRow {
    /// Since first touch \[s\].
    pub time: f64,
    /// δ \[m\].
    pub indentation: f64,
    /// δ_s \[m\], the sphere's share; 0 for a rigid sphere.
    pub sphere_indentation: f64,
    /// δ_h = δ − δ_s \[m\], the half-space's share.
    pub half_space_indentation: f64,
    /// δ' \[m/s\]: positive into the half-space, negative on the way out.
    pub speed: f64,
    /// F \[N\]: what the half-space exerts, with damping.
    pub force: f64,
    /// That of the law alone, where there is damping.
    pub elastic_force: Option<f64>,
    /// Where on the law.
    pub branch: Branch,
    /// The event, if the row is one.
    pub event: Option<Event>,
    /// (kinetic + stored + lost)/(½ m v²) − 1.
    pub energy_drift: f64,
}

/// One impact: every report and every picture reads this. SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Impact {
    /// Impact speed v \[m/s\].
    pub speed: f64,
    /// How it was computed: never `Auto`, but what that chose.
    pub method: Method,
    /// e \[1\].
    pub restitution: f64,
    /// 2 W_rad/(m v²) \[1\]: share of the energy radiated as elastic waves, to first order; `None` where the half-space's
    /// density is not known, under gravity or damping, and where the force of the law jumps on the way.
    pub wave_loss_fraction: Option<f64>,
    /// √(e² − loss) \[1\], not below 0; `None` as above.
    pub restitution_with_waves: Option<f64>,
    /// e v \[m/s\].
    pub rebound_speed: f64,
    /// First touch to separation \[s\]; infinite for a captured sphere.
    pub contact_time: f64,
    /// First touch to maximum compression \[s\].
    pub loading_time: f64,
    /// F_m \[N\].
    pub peak_force: f64,
    /// δ_m \[m\].
    pub peak_indentation: f64,
    /// δ_sm \[m\].
    pub peak_sphere_indentation: f64,
    /// δ_e = δ_m − δ_r \[m\].
    pub elastic_approach: f64,
    /// n of the unloading branch.
    pub unloading_exponent: f64,
    /// δ_r \[m\]: depth of the dent; 0 without one.
    pub residual_indentation: f64,
    /// R_e \[m\] of the peak that shaped the dent, (3 F_m/4E*)²/δ_e³ (Eq. 24) also where the branch is no 3/2 power; R
    /// without a dent.
    pub unloading_radius: f64,
    /// R_res \[m\] (Eq. 25): radius of curvature of the dent; `None` without one.
    pub residual_radius: Option<f64>,
    /// a_m \[m\]: how good it is, [`Law::contact_radius`] says.
    pub peak_contact_radius: f64,
    /// F_m/(π a_m²) \[Pa\].
    pub peak_mean_pressure: f64,
    /// Radius of the dent's rim \[m\]: the contact radius at the peak that shaped it; `None` without a dent.
    pub dent_radius: Option<f64>,
    /// Where the energy went.
    pub energy: Energy,
    /// What it cost.
    pub work: Work,
    /// Error against the closed form; not a number where damping leaves none.
    pub accuracy: Accuracy,
    /// Fate, losses and work under gravity or damping, if the scene names them.
    pub under_forces: Option<UnderForces>,
    /// Where the model or the run is doubtful.
    pub warnings: Vec<Warning>,
    /// The trace, empty if none was asked for; rows rise in time.
    pub trace: Vec<TraceRow>,
}

impl Impact {
    #[allow(clippy::too_many_arguments)]
    pub(super) fn new(
        contact: &Contact,
        speed: f64,
        method: Method,
        scales: &Scales,
        law: &Law,
        outcome: &Outcome,
        exact: &Outcome,
        work: Work,
        points: &[Point],
    ) -> Result<Self, ImpactError> {
        let Outcome { unloading, restitution, loading_time, contact_time } = *outcome;
        let peak = unloading.peak;
        let essentials = Essentials::new(contact, speed, scales, law, outcome)?;
        // kinetic energy in units of Φ L
        let kinetic = essentials.kinetic_in / scales.energy();
        let lost = law.spent(&unloading);
        let ledger = Ledger { law, unloading: &unloading, kinetic, unit_of_speed: scales.speed / speed, lost };
        let sphere_compliance = contact.pair().sphere_compliance;
        let trace: Vec<TraceRow> = points.iter().map(|point| ledger.row(point, scales, sphere_compliance)).collect();
        let at_peak = law.work_to(&peak) / kinetic - 1.0;
        let at_separation = restitution * restitution + lost / kinetic - 1.0;
        let drift = trace
            .iter()
            .map(|row| row.energy_drift)
            .chain([at_peak, at_separation])
            .fold(0.0, |worst, d: f64| max_or_nan(worst, d.abs()));
        if !drift.is_finite() {
            return Err(not_finite(&trace, scales.time(), outcome.contact_time));
        }
        let mut impact =
            Self::of_essentials(contact, speed, method, scales, law, &unloading, loading_time, &essentials);
        impact.energy.drift = drift;
        impact.work = work;
        impact.accuracy = Accuracy {
            closed_form_restitution: exact.restitution,
            restitution_error: (restitution / exact.restitution - 1.0).abs(),
            contact_time_error: (contact_time / exact.contact_time - 1.0).abs(),
        };
        impact.trace = trace;
        impact.warnings = validity::warnings(contact, &impact, law, &peak);
        Ok(impact)
    }

    /// What follows from a row of a table and the unloading branch: no trace, cost, drift or errors yet.
    #[allow(clippy::too_many_arguments)]
    pub(super) fn of_essentials(
        contact: &Contact,
        speed: f64,
        method: Method,
        scales: &Scales,
        law: &Law,
        unloading: &Unloading,
        loading_time: f64,
        essentials: &Essentials,
    ) -> Self {
        let pair = contact.pair();
        let peak = &unloading.peak;
        let Essentials { restitution, kinetic_in, peak_force, peak_contact_radius, .. } = *essentials;
        let has_dent = essentials.has_dent();
        let dent = law.dent(peak);
        let radius_ratio = dent.unloading_radius_ratio();
        let residual_radius =
            (has_dent && radius_ratio > 1.0).then(|| pair.radius * (radius_ratio / (radius_ratio - 1.0)));
        Self {
            speed,
            method,
            restitution,
            wave_loss_fraction: essentials.wave_loss_fraction,
            restitution_with_waves: essentials.restitution_with_waves(),
            rebound_speed: restitution * speed,
            contact_time: essentials.contact_time,
            loading_time: loading_time * scales.time(),
            peak_force,
            peak_indentation: essentials.peak_indentation,
            peak_sphere_indentation: pair.sphere_compliance * peak.elastic_approach * scales.length,
            elastic_approach: peak.elastic_approach * scales.length,
            unloading_exponent: unloading.exponent,
            residual_indentation: essentials.residual_indentation,
            unloading_radius: if has_dent { pair.radius * radius_ratio } else { pair.radius },
            residual_radius,
            peak_contact_radius,
            peak_mean_pressure: peak_force / (std::f64::consts::PI * peak_contact_radius) / peak_contact_radius,
            dent_radius: has_dent.then(|| scales.contact_radius * law.contact_radius(&dent)),
            energy: Energy {
                kinetic_in,
                recovered: kinetic_in * essentials.recovered_fraction(),
                plastic: pair.yield_point.map(|_| essentials.plastic_fraction * kinetic_in),
                drift: 0.0,
            },
            work: Work::default(),
            accuracy: Accuracy {
                closed_form_restitution: restitution,
                restitution_error: 0.0,
                contact_time_error: 0.0,
            },
            under_forces: None,
            warnings: Vec::new(),
            trace: Vec::new(),
        }
    }

    /// What became of a sphere that stays, if it does.
    #[must_use]
    pub fn captured(&self) -> Option<&UnderForces> {
        self.under_forces.as_ref().filter(|under| under.fate == Fate::Captured)
    }

    /// How long the impact was followed \[s\]: the contact time, or to where the run of a captured sphere ends.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.captured().map_or(self.contact_time, |under| under.end_time)
    }

    /// Whether the impact left a dent.
    #[must_use]
    pub fn has_dent(&self) -> bool {
        self.dent_radius.is_some()
    }
}

/// Why an impact whose ledger is no number has no result: from the first row of its trace on, or from its end \[1\].
pub(super) fn not_finite(trace: &[TraceRow], unit_of_time: f64, end: f64) -> ImpactError {
    let row = trace.iter().find(|row| !row.energy_drift.is_finite());
    IntegrationError::NotFinite { time: row.map_or(end, |row| row.time / unit_of_time) }.into()
}

/// The energy ledger of one impact, in units of Φ L.
struct Ledger<'a> {
    law: &'a Law,
    unloading: &'a Unloading,
    kinetic: f64,
    unit_of_speed: f64,
    lost: f64,
}

impl Ledger<'_> {
    /// While loading: kinetic + W; while unloading: kinetic + stored + what the dent has cost.
    fn row(&self, point: &Point, scales: &Scales, sphere_compliance: f64) -> TraceRow {
        let speed_ratio = point.speed * self.unit_of_speed;
        let potential = if point.is_unloading {
            self.unloading.stored_after(point.elastic_approach, point.force) + self.lost
        } else {
            let Point { indentation, force, elastic_approach, .. } = *point;
            self.law.work_to(&Peak { indentation, force, elastic_approach })
        };
        let branch = match point {
            Point { is_unloading: true, .. } => Branch::Unloading,
            Point { indentation, .. } if self.law.branch_at(*indentation).is_some() => Branch::Reloading,
            Point { indentation, elastic_approach, .. } if elastic_approach < indentation => Branch::Plastic,
            _ => Branch::Elastic,
        };
        let indentation = point.indentation * scales.length;
        let sphere_indentation = sphere_compliance * point.elastic_approach * scales.length;
        TraceRow {
            time: point.time * scales.time(),
            indentation,
            sphere_indentation,
            half_space_indentation: indentation - sphere_indentation,
            speed: point.speed * scales.speed,
            force: point.force * scales.force,
            elastic_force: None,
            branch,
            event: point.event,
            energy_drift: speed_ratio * speed_ratio + potential / self.kinetic - 1.0,
        }
    }
}
