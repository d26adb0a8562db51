//! Unloading along a Hertz curve that is shifted by the dent, for dents from half the indentation down to the size of
//! rounding.

use std::sync::Arc;

use plm_impact::contact::law::published::{LawParts, LoadedState, Loading};
use plm_impact::numerics::curve::LoadingCurve;
use plm_impact::numerics::curve::unloading_curve::UnloadingCurveKind;

use crate::common::prelude::*;

/// A law that loads along the curve of Hertz; the dent is this share of the indentation.
#[derive(Debug)]
struct Dented(f64);

impl ContactLaw for Dented {
    fn build_parts(&self, _: &YieldingPair) -> LawParts {
        let recovered = 1.0 - self.0;
        let recovery = move |peak: LoadedState| Recovery {
            elastic_approach: recovered * peak.indentation,
            shape: UnloadingShape::Curve(UnloadingCurveKind::ShiftedHertz),
        };
        LawParts::new(Loading::new(LoadingCurve::hertz(), 1.0, |x, _| x.sqrt()), Arc::new(recovery))
    }
}

/// e² = ((2/5) (1 − r^2.5) − r^1.5 (1 − r))/((2/5) (1 − r^1.5)) for a dent r, from the area under the shifted curve.
#[test]
fn a_dent_however_shallow_is_landed_on() {
    for halves in 0..34 {
        let r = 0.5 * 10f64.powf(-0.5 * f64::from(halves));
        let contact = Scene::case_3().contact_by(&Dented(r));
        let root = r.sqrt();
        let square = (0.4 * (1.0 - r * r * root) - r * root * (1.0 - r)) / (0.4 * (1.0 - r * root));
        for times in [2.0, 2.37, 7.5, 16.0] {
            let speed = times * contact.yield_speed().unwrap();
            let exact = contact.closed_form(speed).unwrap();
            assert!(relative_error(exact.row.restitution, square.sqrt()) < 1e-13, "{r}: {}", exact.row.restitution);
            for (method, factor) in STEPPING {
                for tolerance in [1e-3, 1e-6, 1e-10, 1e-13] {
                    let impact = contact.impact(speed, &solver(method, tolerance), None).unwrap();
                    let error = plm_impact::numerics::power::nan_max(
                        relative_error(impact.row.restitution, exact.row.restitution),
                        relative_error(impact.row.contact_time, exact.row.contact_time),
                    );
                    assert!(error < factor * tolerance, "{r} {method:?} {tolerance}: {error}");
                }
            }
        }
    }
}
