//! Checks against the quasi-static finite elements of five pairs of materials: loading curves, unloadings from the peak of
//! the finite elements, and load cycles by the whole law.

use super::cases::{Case, Cycle, cases};
use super::check::{self, Check, Group, Known, MEAN, RMS, Tolerance, deviation, found};
use crate::error::Error;
use crate::fit::LoadingPoint;
use crate::law::{Law, Peak, PlmCoefficients, Unloading, UnloadingExponent};
use crate::reference::STATIC;
use crate::units::four_digits;

/// A quantity along the loading curve, in units of first yield.
struct OfLoading {
    /// The root mean square of its deviations along a curve, and the largest if that is checked.
    rms: Group,
    largest: Option<Group>,
    of_law: fn(&Case, &Law, f64) -> f64,
    of_point: fn(&Case, &LoadingPoint) -> Option<f64>,
}

const LOADING: [OfLoading; 4] = [
    OfLoading {
        rms: Group::of("loading: force, rms over the curve", STATIC, "", found(0.0144, 0.015)),
        largest: Some(Group::of("loading: force, largest over the curve", STATIC, "F_Y", found(0.0347, 0.036))),
        of_law: |_, law, x| law.loading.force(x),
        of_point: |_, point| Some(point.force),
    },
    OfLoading {
        rms: Group::of("loading: sphere indentation, rms over the curve", STATIC, "", found(0.0116, 0.013)),
        largest: None,
        of_law: |case, law, x| case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(case.sphere_compliance() * point.elastic_approach),
    },
    OfLoading {
        rms: Group::of("loading: half-space indentation, rms over the curve", STATIC, "", found(0.0063, 0.013)),
        largest: None,
        of_law: |case, law, x| x - case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(point.indentation - case.sphere_compliance() * point.elastic_approach),
    },
    OfLoading {
        rms: Group::of("loading: contact radius, rms over the curve", STATIC, "", found(0.0262, 0.027)),
        largest: Some(Group::of(
            "loading: contact radius, largest over the curve",
            STATIC,
            "a_Y",
            found(0.0522, 0.053),
        )),
        of_law: |_, law, x| law.contact_radius(&law.loaded_to(x)),
        of_point: |_, point| point.contact_radius,
    },
];

/// Checks of each curve from first yield on: the root mean square of the deviations along it, and the largest.
pub(super) fn loading(coefficients: &PlmCoefficients) -> Result<Vec<Check>, Error> {
    let (mut checks, cases) = (Vec::new(), cases()?);
    for OfLoading { rms, largest, of_law, of_point } in LOADING {
        let mut of_largest = Vec::new();
        for case in &cases {
            let law = case.law(coefficients, UnloadingExponent::Paper);
            let plastic = case.loading.points.iter().filter(|point| point.indentation >= 1.0);
            let pair = |point: &LoadingPoint| {
                let x = point.indentation;
                Some((x, [of_point(case, point)?, of_law(case, &law, x)]))
            };
            let points: Vec<(f64, [f64; 2])> = plastic.filter_map(pair).collect();
            let off = |(_, [expected, got]): &(f64, [f64; 2])| deviation(*expected, *got);
            let over = format!("{}, {} points", case.name, points.len());
            checks.push(rms.check_of(over, check::rms(&points.iter().map(off).collect::<Vec<_>>())));
            let worst = points.iter().max_by(|a, b| off(a).abs().total_cmp(&off(b).abs()));
            let worst = largest.zip(worst);
            of_largest.extend(
                worst.map(|(group, (x, numbers))| {
                    group.check(format!("{}, x = {}", case.name, four_digits(*x)), *numbers)
                }),
            );
        }
        checks.extend(of_largest);
    }
    Ok(checks)
}

/// The expected and the computed force over the peak force, where they differ most during unloading. The branch of the
/// law has peak and dent of the finite elements, so that only the shape is compared.
fn farthest(law: &Law, cycle: &Cycle) -> Option<[f64; 2]> {
    let elastic_approach = cycle.row.x - cycle.residual();
    let branch = Unloading::power(Peak { elastic_approach, ..cycle.peak }, law.unloading(cycle.peak).exponent);
    let pairs = cycle.points.iter().map(|(x, f)| [f / cycle.row.f, branch.force(*x) / cycle.row.f]);
    pairs.max_by(|a, b| (a[1] - a[0]).abs().total_cmp(&(b[1] - b[0]).abs()))
}

/// Residual radius of the dent, R_res/R = R_e/(R_e − R) (Eqs. 24-25), where enough elements resolve its shape.
fn residual_radius(_: &Law, cycle: &Cycle) -> Option<[f64; 2]> {
    let ratio = cycle.peak.unloading_radius_ratio();
    (cycle.row.elements >= RESOLVED).then(|| [cycle.row.residual_radius, ratio / (ratio - 1.0)])
}

/// Restitution of a load cycle to x: √(recovered/spent work).
pub(super) fn restitution(law: &Law, x: f64) -> f64 {
    (law.unloading(law.loaded_to(x)).stored(x) / law.loading.work(x)).sqrt()
}

/// Smallest number of elements across the contact radius for which the shape of the dent is compared.
const RESOLVED: f64 = 10.0;

/// A quantity of every cycle: its checks, the exponent of the law, and the expected and the computed number, if the
/// reference has one.
type OfCycle = (Group, UnloadingExponent, fn(&Law, &Cycle) -> Option<[f64; 2]>);

const PAPER: UnloadingExponent = UnloadingExponent::Paper;
const SHAPE: UnloadingExponent = UnloadingExponent::PressureShape;
const EQ_23: &str = "unloading: residual indentation from the reference's peak (Eq. 23)";
const FORCE: &str = "unloading: force, largest deviation over peak force, exponent 3/2";
const FORCE_OF_SHAPE: &str = "unloading: force, largest deviation over peak force, pressure-shape";
const EQ_25: &str = "unloading: residual radius from the reference's peak (Eq. 25)";
const DENT: &str = "load cycle: residual indentation, deviation over peak indentation";
const FIGURE_6: Tolerance =
    Tolerance::stated(0.02, "Xie et al. 2024, Fig. 6: 3 % from 3 delta_Y on, 2 % from 6 delta_Y on");
const TABLE_2: Tolerance = Tolerance::stated(
    0.0139 + 0.002,
    "Xie et al. 2024, Table 2: 1.39 %, 0.2 % for its digits, and the difference of fits within a and 0.7 a",
);

const CYCLES: [OfCycle; 7] = [
    (Group::of(EQ_23, STATIC, "delta_Y", FIGURE_6), PAPER, |_, cycle| Some([cycle.residual(), cycle.peak.residual()])),
    (Group::of(FORCE, STATIC, "F_m", found(0.0509, 0.052)).of_differences(), PAPER, farthest),
    (Group::of(FORCE_OF_SHAPE, STATIC, "F_m", found(0.0307, 0.040)).of_differences(), SHAPE, farthest),
    (Group::of(EQ_25, STATIC, "R", TABLE_2), PAPER, residual_radius),
    (Group::of(DENT, STATIC, "delta_m", found(0.0182, 0.022)).of_differences(), PAPER, |law, cycle| {
        let x = cycle.row.x;
        Some([cycle.residual() / x, law.loaded_to(x).residual() / x])
    }),
    (
        Group::of("load cycle: restitution, exponent 3/2", STATIC, "", found(0.0557, 0.057))
            .with_overall(&[(MEAN, found(0.0294, 0.031)), (RMS, found(0.0308, 0.032))]),
        PAPER,
        of_restitution,
    ),
    (
        Group::of("load cycle: restitution, pressure-shape", STATIC, "", found(0.0253, 0.027))
            .with_overall(&[(MEAN, found(0.0035, 0.006)), (RMS, found(0.0100, 0.0115))]),
        SHAPE,
        of_restitution,
    ),
];

fn of_restitution(law: &Law, cycle: &Cycle) -> Option<[f64; 2]> {
    Some([cycle.row.restitution?, restitution(law, cycle.row.x)])
}

/// Known deviation of the dent depth, found by this validation.
const UNFITTED: Known = Known {
    limit: 0.024,
    remark: "for the softest sphere (case 1) below 30 delta_Y, where there was no loading curve to fit the law to",
};

/// Every cycle: the dent and the force from the peak of the finite elements; dent and restitution by the whole law.
pub(super) fn cycles(coefficients: &PlmCoefficients) -> Result<Vec<Check>, Error> {
    let (mut checks, cases) = (Vec::new(), cases()?);
    for (group, exponent, numbers) in CYCLES {
        let laws: Vec<Law> = cases.iter().map(|case| case.law(coefficients, exponent)).collect();
        let all =
            cases.iter().zip(&laws).flat_map(|(case, law)| case.cycles.iter().map(move |cycle| (case, law, cycle)));
        let compared: Vec<_> = all.filter_map(|(case, law, cycle)| Some((case, cycle, numbers(law, cycle)?))).collect();
        let mut own = group.checks(compared.iter().map(|(_, cycle, numbers)| (cycle.name(), *numbers)), "cycles");
        for (check, (case, cycle, _)) in own.iter_mut().zip(&compared) {
            match group.quantity {
                EQ_23 if cycle.row.x < 6.0 => check.tolerance.limit = 0.03,
                // if the dent is not a circle, the fitted radius depends on the range of the fit
                EQ_25 => {
                    check.tolerance.limit += (cycle.row.inner_residual_radius / cycle.row.residual_radius - 1.0).abs();
                }
                DENT => {
                    let first = case.loading.points.first().map_or(1.0, |point| point.indentation);
                    check.known = (cycle.row.x < first).then_some(UNFITTED);
                }
                _ => {}
            }
        }
        checks.extend(own);
    }
    Ok(checks)
}
