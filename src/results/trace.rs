//! The columns of the trace of one impact, `trace.csv`.

use super::{ResultSpec, result_specs};
use crate::impact::{CrossMotion, Event, FrictionState, TraceRow};

/// The columns, in their order.
pub fn trace_results() -> Vec<ResultSpec<TraceRow>> {
    result_specs! { |row: TraceRow|
        /// Time since first contact.
        "time_s" in Time: row.time;
        /// Indentation: approach of the two bodies.
        "indentation_m" in Length: row.indentation;
        /// Part of the indentation in the sphere, including its permanent flat.
        "sphere_indentation_m" in Length: row.sphere_indentation;
        /// Part of the indentation in the half-space.
        "half_space_indentation_m" in Length: row.half_space_indentation;
        /// Speed into the half-space; negative during the rebound.
        "speed_m_per_s" in Speed: row.speed;
        /// Speed of the sphere's centre: speed into the plate or rod plus its speed.
        "sphere_speed_m_per_s" in Speed if WAVEGUIDE: row.sphere_speed;
        /// Force on the sphere, including damping.
        "force_N" in Force: row.force;
        /// Force of the contact law alone.
        "elastic_force_N" in Force if DAMPING: row.elastic_force;
        /// Stress in the rod just behind its end: force over cross section. This pulse travels along the rod.
        "rod_stress_Pa" in Pressure if ROD: row.rod_stress;
        /// Slip speed of the contact point: tangential speed of the centre minus radius times spin. With a spin about the path it is the
        /// magnitude of this difference as a vector, negative backwards.
        "slip_speed_m_per_s" in Speed if OBLIQUE: friction_value(row, |friction| friction.slip_speed);
        /// Friction force on the sphere, along the line of the slip; negative against the path.
        "friction_force_N" in Force if OBLIQUE: friction_value(row, |friction| friction.friction_force);
        /// Tangential speed of the centre in the direction of the path.
        "tangential_speed_m_per_s" in Speed if OBLIQUE: friction_value(row, |friction| friction.tangential.speed);
        /// Spin; positive for rolling forward.
        "spin_rad_per_s" in AngularSpeed if OBLIQUE: friction_value(row, |friction| friction.tangential.spin);
        /// Speed of the centre across the path: positive to the left, seen from above.
        "cross_speed_m_per_s" in Speed if CROSS: cross_value(row, |cross| cross.speed);
        /// Spin about the direction of the path.
        "spin_about_path_rad_per_s" in AngularSpeed if CROSS: cross_value(row, |cross| cross.spin_about_path);
        /// Branch of the law: `elastic`, `plastic`, `reloading` or `unloading`.
        "branch": row.branch.name();
        /// Event in this row: `touch`, `yield`, `knot` (segment boundary of the loading curve), `peak`, `relaxation` (of a strength
        /// that depends on the strain rate), `separation` or `captured`; empty in other rows.
        "event": event_name(row.event);
    }
}

/// A value of friction, if the sphere came in at an angle, or spinning.
fn friction_value(row: &TraceRow, value: fn(&FrictionState) -> f64) -> Option<f64> {
    row.friction.as_ref().map(value)
}

/// A value of the motion out of the plane of incidence, if the sphere has a spin out of this plane.
fn cross_value(row: &TraceRow, value: fn(&CrossMotion) -> f64) -> Option<f64> {
    row.friction.as_ref().and_then(|friction| friction.tangential.cross).as_ref().map(value)
}

/// The word for an event; empty for an ordinary row.
pub fn event_name(event: Option<Event>) -> &'static str {
    match event {
        None => "",
        Some(Event::Touch) => "touch",
        Some(Event::Yield) => "yield",
        Some(Event::Knot) => "knot",
        Some(Event::Peak) => "peak",
        Some(Event::Relaxation) => "relaxation",
        Some(Event::Separation) => "separation",
        Some(Event::Captured) => "captured",
    }
}
