//! An impact under gravity or damping from a contact and a speed to the numbers of a report.

use super::essentials::Essentials;
use super::forced::{self, Fate, ForcedOutcome, Load};
use super::forced_trace::{ForcedPoint, ForcedRecorder};
use super::forces::Damping;
use super::outcome::{Branch, Impact, TraceRow, not_finite};
use super::scales::Scales;
use super::validity;
use super::{Contact, ImpactError, Method, Solver, balance};
use crate::integrate::forced::ForcedIntegrator;
use crate::integrate::ode_forced::OdeForced;
use crate::integrate::ode_solvers;
use crate::integrate::pulled::Pulled;
use crate::integrate::{IntegrationError, Work};
use crate::law::{Law, Peak};
use crate::material::{OutOfFloatRange, normal};
use crate::power::{max_or_nan, power_turn};

/// What only an impact under gravity or damping has. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnderForces {
    /// Whether the sphere left.
    pub fate: Fate,
    /// Time of separation, or where the run of a captured sphere ends \[s\].
    pub end_time: f64,
    /// δ at that time \[m\].
    pub end_indentation: f64,
    /// δ at which the unloading branch carries the weight \[m\]: where a captured sphere comes to rest.
    pub static_indentation: Option<f64>,
    /// Taken by damping \[J\] until separation, or until the end of the run of a captured sphere.
    pub damping_loss: Option<f64>,
    /// Elastic energy left \[J\] where the sphere lifts off a contact that has not yet recovered, as it does under viscous
    /// damping: no force is left then, so the contact's own damping takes it afterwards. `None` where there is none by rule.
    pub stored_at_separation: Option<f64>,
    /// m g times the way since first touch \[J\].
    pub gravity_work: Option<f64>,
}

/// One impact to be computed: units, law, and what acts.
pub(super) struct Scene<'a> {
    scales: Scales,
    pub(super) law: &'a Law,
    pub(super) q: f64,
    pub(super) load: Load,
}

impl Contact {
    /// Units, law, q = v/V and forces of an impact: like [`Contact::scaled`], also for a sphere that is let go at rest. On
    /// a spot that was loaded before, by its law.
    pub(super) fn scene<'a>(&'a self, spot: Option<&'a Law>, speed: f64) -> Result<Scene<'a>, OutOfFloatRange> {
        let gravity = self.forces().gravity.unwrap_or(0.0);
        let weight = self.mass() * gravity;
        // what takes energy only makes the impact shallower: elastic without damping, elastic with it
        let yields = self.yielding.as_ref().filter(|(scales, law)| {
            let (q, least) = (speed / scales.speed, self.yield_speed / scales.speed);
            let until = law.elastic_until();
            // a law without an elastic regime yields at once
            spot.is_some() || until == 0.0 || 0.4 * q * q + weight / scales.force * until > 0.4 * least * least
        });
        let (scales, law, q) = match yields {
            Some((scales, law)) => {
                let ratio = speed / scales.speed;
                let energy = ratio * ratio + weight / scales.force;
                normal("kinetic energy and weight in units of those at first yield", energy)?;
                (*scales, spot.unwrap_or(law), ratio)
            }
            None if gravity > 0.0 => {
                let scales = self.scales_of_drop(speed, gravity)?;
                (scales, super::hertz(), speed / scales.speed)
            }
            None => (Scales::of_hertz(self.pair(), self.mass(), speed)?, super::hertz(), 1.0),
        };
        let damping = self.forces().damping.map(|damping| match damping {
            Damping::HuntCrossley(chi) => Damping::HuntCrossley(chi * scales.speed),
            viscous @ Damping::Viscous(_) => viscous,
        });
        Ok(Scene { scales, law, q, load: Load { weight: weight / scales.force, damping } })
    }

    /// Hertz scales of an elastic impact under gravity: L where (2/5) K L^2.5 = ½ m v² + m g L, Φ = K L^1.5, and
    /// ½ m V² = (2/5) Φ L.
    fn scales_of_drop(&self, speed: f64, gravity: f64) -> Result<Scales, OutOfFloatRange> {
        let stiffness = self.pair().hertz_stiffness();
        let per_mass = stiffness / self.mass();
        let length = normal("peak indentation (m)", power_turn(per_mass, 1.5, 0.5 * speed * speed, gravity))?;
        let force = normal("peak force (N)", stiffness * length * length.sqrt())?;
        let contact_radius = (self.pair().radius * length).sqrt();
        Ok(Scales { length, force, speed: (speed * speed + 2.0 * gravity * length).sqrt(), contact_radius })
    }

    /// Like [`Contact::impact`], for a contact with forces.
    pub(super) fn impact_with_forces(
        &self,
        speed: f64,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<Impact, ImpactError> {
        self.impact_with_forces_on(None, speed, solver, samples).map(|(impact, ..)| impact)
    }

    /// The same on a spot, with the law of the spot after it, if it has another one then.
    pub(super) fn impact_with_forces_on(
        &self,
        spot: Option<&Law>,
        speed: f64,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, Option<Law>), ImpactError> {
        let scene = self.scene(spot, speed)?;
        let exact = balance::solve(scene.law, scene.q, &scene.load);
        let method = match (solver.method, samples) {
            (Method::Auto, None) if scene.load.is_conservative() && exact.is_some() => Method::ClosedForm,
            (Method::Auto, _) => Method::Rk8,
            (method, _) => method,
        };
        let solver = Solver { method, ..*solver };
        if method == Method::ClosedForm && (exact.is_none() || samples.is_some()) {
            return Err(ImpactError::NoClosedForm);
        }
        // a damped contact does not say beforehand how long it lasts: once to know, once to sample
        let (mut outcome, mut work) = run(&scene, exact.as_ref(), &solver, None)?;
        let mut recorder = samples.map(|samples| ForcedRecorder::new(samples, outcome.end.time));
        if recorder.is_some() {
            (outcome, work) = run(&scene, exact.as_ref(), &solver, recorder.as_mut())?;
        }
        let points = recorder.map_or_else(Vec::new, |recorder| recorder.points);
        let mut impact = self.assemble(speed, method, &scene, &outcome, exact.as_ref(), &points)?;
        impact.work = work;
        match (method, &exact) {
            (Method::Verlet, _) => {}
            (_, Some(_)) => validity::check_accuracy(&mut impact, solver.tolerance),
            (_, None) => validity::check_ledger(&mut impact, solver.tolerance),
        }
        Ok((impact, super::spot::after(scene.law, &outcome.unloading.peak)))
    }

    /// Whether double precision holds the impact that damping only makes shallower.
    pub(super) fn holds_with_forces(&self, speed: f64) -> Result<(), ImpactError> {
        let scene = self.scene(None, speed)?;
        let load = Load { damping: None, ..scene.load };
        if let Some(outcome) = balance::solve(scene.law, scene.q, &load) {
            match self.row(speed, &scene, &outcome) {
                // the shallower peak may be one that the law has an answer for
                Err(ImpactError::Law(_)) if scene.load.damping.is_some() => {}
                row => drop(row?),
            }
        }
        Ok(())
    }

    /// The exact outcome, without stepping.
    pub(super) fn closed_form_with_forces(&self, speed: f64) -> Result<Impact, ImpactError> {
        let scene = self.scene(None, speed)?;
        let exact = balance::solve(scene.law, scene.q, &scene.load).ok_or(ImpactError::NoClosedForm)?;
        self.assemble(speed, Method::ClosedForm, &scene, &exact, Some(&exact), &[])
    }

    /// What a table holds of an impact under forces, by this solver.
    pub(super) fn essentials_with_forces(&self, speed: f64, solver: &Solver) -> Result<Essentials, ImpactError> {
        let scene = self.scene(None, speed)?;
        let is_exact = match solver.method {
            Method::Auto => scene.load.is_conservative(),
            method => method == Method::ClosedForm,
        };
        // a fixed step is a part of the exact duration
        let needs_exact = is_exact || solver.method == Method::Verlet;
        let exact = needs_exact.then(|| balance::solve(scene.law, scene.q, &scene.load)).flatten();
        let outcome = match exact {
            Some(exact) if is_exact => exact,
            None if solver.method == Method::ClosedForm => return Err(ImpactError::NoClosedForm),
            _ => run(&scene, exact.as_ref(), solver, None)?.0,
        };
        self.row(speed, &scene, &outcome)
    }

    /// What a table holds of this outcome.
    pub(super) fn row(&self, speed: f64, scene: &Scene, outcome: &ForcedOutcome) -> Result<Essentials, ImpactError> {
        scene.law.accept(&outcome.unloading.peak)?;
        // the kinetic energy of a sphere at rest is 0, no number out of range
        let kinetic_in = 0.5 * self.mass() * speed * speed;
        let kinetic_in = if speed == 0.0 { 0.0 } else { normal("kinetic energy (J)", kinetic_in)? };
        let row = Essentials::with_kinetic(kinetic_in, &scene.scales, scene.law, &outcome.outcome())?;
        let is_captured = outcome.fate == Fate::Captured;
        Ok(Essentials { contact_time: if is_captured { f64::INFINITY } else { row.contact_time }, ..row })
    }

    fn assemble(
        &self,
        speed: f64,
        method: Method,
        scene: &Scene,
        outcome: &ForcedOutcome,
        exact: Option<&ForcedOutcome>,
        points: &[ForcedPoint],
    ) -> Result<Impact, ImpactError> {
        let Scene { scales, law, q, load } = scene;
        let essentials = self.row(speed, scene, outcome)?;
        let ledger = Ledger { law, load, outcome, q: *q };
        let mut impact = Impact::of_essentials(
            self,
            speed,
            method,
            scales,
            law,
            &outcome.unloading,
            outcome.loading_time,
            &essentials,
        );
        impact.trace = points.iter().map(|point| ledger.row(point, scales, self.pair().sphere_compliance)).collect();
        let rows = impact.trace.iter().map(|row| row.energy_drift);
        let drift =
            rows.chain([ledger.at_peak(), ledger.at_end()]).fold(0.0, |worst, d: f64| max_or_nan(worst, d.abs()));
        if !drift.is_finite() {
            return Err(not_finite(&impact.trace, scales.time(), outcome.end.time));
        }
        drop_twin_of_end(&mut impact.trace);
        let energy = scales.energy();
        impact.energy.plastic = self.pair().yield_point.map(|_| law.plastic(&outcome.unloading) * energy);
        impact.energy.drift = drift;
        let is_captured = outcome.fate == Fate::Captured;
        let lifts_off = !is_captured && load.drag().lifts_off();
        let at_rest = load.static_indentation(law, &outcome.unloading);
        impact.under_forces = Some(UnderForces {
            fate: outcome.fate,
            end_time: outcome.end.time * scales.time(),
            end_indentation: outcome.end.distance * scales.length,
            static_indentation: is_captured.then_some(at_rest * scales.length),
            damping_loss: self.forces().damping.map(|_| outcome.loss * energy),
            stored_at_separation: lifts_off.then(|| outcome.unloading.stored(outcome.end.distance) * energy),
            gravity_work: self.forces().gravity.map(|_| load.weight * (outcome.end.distance - law.touch()) * energy),
        });
        impact.accuracy = match exact {
            Some(exact) => super::Accuracy {
                closed_form_restitution: exact.restitution,
                restitution_error: relative(outcome.restitution, exact.restitution),
                contact_time_error: relative(outcome.end.time, exact.end.time),
            },
            None => super::Accuracy {
                closed_form_restitution: f64::NAN,
                restitution_error: f64::NAN,
                contact_time_error: f64::NAN,
            },
        };
        impact.warnings = validity::warnings(self, &impact, law, &outcome.unloading.peak);
        Ok(impact)
    }
}

/// A sample, or a peak, at the very time at which the run ends says nothing beside the end.
fn drop_twin_of_end(trace: &mut Vec<TraceRow>) {
    while let [.., before, end] = trace.as_slice()
        && before.time == end.time
    {
        trace.remove(trace.len() - 2);
    }
}

/// |got/want − 1|; 0 if both are 0.
fn relative(got: f64, want: f64) -> f64 {
    if got == want { 0.0 } else { (got / want - 1.0).abs() }
}

/// The outcome by any method, with its cost.
fn run(
    scene: &Scene,
    exact: Option<&ForcedOutcome>,
    solver: &Solver,
    recorder: Option<&mut ForcedRecorder>,
) -> Result<(ForcedOutcome, Work), IntegrationError> {
    fn with<I: ForcedIntegrator>(
        mut integrator: I,
        scene: &Scene,
        recorder: Option<&mut ForcedRecorder>,
    ) -> Result<(ForcedOutcome, Work), IntegrationError> {
        let outcome = forced::integrate(scene.law, scene.q, &scene.load, &mut integrator, recorder)?;
        Ok((outcome, integrator.work()))
    }
    let tolerance = solver.tolerance;
    match (solver.method, exact) {
        (Method::ClosedForm, Some(exact)) => Ok((*exact, Work::default())),
        (Method::Rk8 | Method::Auto | Method::ClosedForm, _) => with(Pulled::new(tolerance), scene, recorder),
        (Method::Dopri5, _) => with(OdeForced::new(ode_solvers::Method::Dopri5, tolerance), scene, recorder),
        (Method::Dop853, _) => with(OdeForced::new(ode_solvers::Method::Dop853, tolerance), scene, recorder),
        (Method::Verlet, _) => {
            // without a closed form, the step is a part of the undamped contact
            let conservative = Load { damping: None, ..scene.load };
            let reference = exact.copied().or_else(|| balance::solve(scene.law, scene.q, &conservative));
            let duration = reference.map_or(1.0, |reference| reference.end.time);
            let mut work = Work::default();
            let steps = solver.steps_per_contact.max(1);
            let outcome = super::forced_verlet::march(
                scene.law,
                scene.q,
                &scene.load,
                duration / f64::from(steps),
                100 * u64::from(steps) + 10,
                &mut work,
                recorder,
            )?;
            Ok((outcome, work))
        }
    }
}

/// The energy ledger of one impact, in units of Φ L: kinetic + stored + lost in dent and damping − m g δ = ½ m v².
struct Ledger<'a> {
    law: &'a Law,
    load: &'a Load,
    outcome: &'a ForcedOutcome,
    q: f64,
}

impl Ledger<'_> {
    /// The sum over ½ m v² + m g δ_m, less what it should be. While loading W(x) is stored and plastic together.
    fn drift(&self, speed: f64, potential: f64, loss: f64, indentation: f64) -> f64 {
        let kinetic = 0.4 * self.q * self.q;
        let sunk = |x: f64| self.load.weight * (x - self.law.touch());
        let put_in = kinetic + sunk(self.outcome.unloading.peak.indentation);
        (0.4 * speed * speed + potential + loss - sunk(indentation) - kinetic) / put_in
    }

    fn plastic(&self) -> f64 {
        self.law.spent(&self.outcome.unloading)
    }

    /// By the loss at the end: the way back takes from it what it takes.
    fn at_end(&self) -> f64 {
        let end = &self.outcome.end;
        let potential = self.plastic() + self.outcome.unloading.stored(end.distance);
        self.drift(end.speed, potential, self.outcome.loss, end.distance)
    }

    /// Without damping the peak is a balance of its own.
    fn at_peak(&self) -> f64 {
        if !self.load.is_conservative() {
            return 0.0;
        }
        let peak = &self.outcome.unloading.peak;
        self.drift(0.0, self.law.work_to(peak), 0.0, peak.indentation)
    }

    fn row(&self, point: &ForcedPoint, scales: &Scales, sphere_compliance: f64) -> TraceRow {
        let x = point.state.distance;
        let unloading = &self.outcome.unloading;
        let potential = if point.is_unloading {
            unloading.stored_after(point.elastic_approach, point.force) + self.plastic()
        } else {
            let ForcedPoint { force, elastic_approach, .. } = *point;
            self.law.work_to(&Peak { indentation: x, force, elastic_approach })
        };
        let branch = match point {
            ForcedPoint { is_unloading: true, .. } => Branch::Unloading,
            _ if self.law.branch_at(x).is_some() => Branch::Reloading,
            ForcedPoint { elastic_approach, .. } if *elastic_approach < x => Branch::Plastic,
            _ => Branch::Elastic,
        };
        let indentation = x * scales.length;
        let sphere_indentation = sphere_compliance * point.elastic_approach * scales.length;
        TraceRow {
            time: point.state.time * scales.time(),
            indentation,
            sphere_indentation,
            half_space_indentation: indentation - sphere_indentation,
            speed: point.state.speed * scales.speed,
            force: point.total_force * scales.force,
            elastic_force: self.load.damping.map(|_| point.force * scales.force),
            branch,
            event: point.event,
            energy_drift: self.drift(point.state.speed, potential, point.loss, x),
        }
    }
}
