//! The results of a comparison of unloading laws: its peak, and a row for every law.

use super::entry::{Reported, file, results};
use crate::compare::{Comparison, Origin};
use crate::reference::unloading::Unloaded;

/// One law in the table; deviations are relative to the finite elements of the same peak.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The law, or `finite_elements`.
    pub law: String,
    /// Its unloading from the peak; `None` where the law has no answer.
    pub branch: Option<Branch>,
}

/// How a law unloads from the peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// Depth of the dent, δ_r \[m\].
    pub residual_indentation: f64,
    /// Depth of the dent over the indentation at the peak, δ_r/δ_m.
    pub residual_share: f64,
    /// Energy that unloading gives back \[J\].
    pub recovered_energy: f64,
    /// Restitution, √(recovered/spent).
    pub restitution: f64,
    /// How far the share, the energy and e are from the finite elements, relative; where there are some.
    pub deviations: Option<[f64; 3]>,
}

/// The rows: the finite elements first, where there are some, then the laws.
pub fn rows(comparison: &Comparison) -> Vec<Row> {
    let (point, peak) = (&comparison.bodies.yield_point, &comparison.peak);
    let reference = comparison.finite_elements();
    // shares of the peak, as the peaks differ by up to 1 %
    let recovered_share = |fe: &Unloaded| fe.restitution * fe.restitution * fe.spent / (fe.f * fe.x);
    let branch = |share: f64, recovered: f64, e: f64| Branch {
        residual_indentation: share * peak.indentation * point.indentation,
        residual_share: share,
        recovered_energy: recovered * (point.force * point.indentation),
        restitution: e,
        deviations: reference.map(|fe| {
            let of_recovered = recovered / (peak.force * peak.indentation);
            [share / fe.residual_share - 1.0, of_recovered / recovered_share(fe) - 1.0, e / fe.restitution - 1.0]
        }),
    };
    let finite_elements = reference.map(|fe| {
        let recovered = fe.restitution * fe.restitution * fe.spent;
        let scale = peak.force * peak.indentation / (fe.f * fe.x);
        let branch = branch(fe.residual_share, recovered * scale, fe.restitution);
        Row { law: "finite_elements".to_owned(), branch: Some(branch) }
    });
    let laws = comparison.compared().into_iter().map(|one| {
        let branch = one.unloading.ok().map(|unloading| {
            let share = unloading.peak.residual() / peak.indentation;
            branch(share, unloading.stored(peak.indentation), comparison.restitution(&unloading))
        });
        Row { law: one.name, branch }
    });
    finite_elements.into_iter().chain(laws).collect()
}

/// The results of one law, and the columns of `comparison.csv`.
pub fn row() -> Vec<Reported<Row>> {
    results! { |row: Row|
        /// The law, or `finite_elements`.
        "law" as "law": row.law.clone();
        /// Depth of the dent; `null` where the law has no answer, as for all that follows.
        "residual_indentation_m" in Length as "dent depth": row.branch.map(|branch| branch.residual_indentation);
        /// Depth of the dent over the indentation at the peak.
        "residual_share" as "share of peak": row.branch.map(|branch| branch.residual_share);
        /// Energy that unloading gives back.
        "recovered_energy_J" in Energy as "recovered": row.branch.map(|branch| branch.recovered_energy);
        /// Square root of the share of the spent work that comes back.
        "restitution" as "e": row.branch.map(|branch| branch.restitution);
        /// Relative difference of the share of the dent from the finite elements; `null` without these, as below.
        "residual_deviation" in Deviation as "depth against FE":
            row.branch.and_then(|branch| branch.deviations).map(|[share, _, _]| share);
        /// Relative difference of the recovered energy from the finite elements.
        "recovered_energy_deviation" in Deviation as "energy against FE":
            row.branch.and_then(|branch| branch.deviations).map(|[_, energy, _]| energy);
        /// Relative difference of the restitution from the finite elements.
        "restitution_deviation" in Deviation as "e against FE": row.branch.and_then(|branch| branch.deviations).map(|[_, _, e]| e);
        /// `ok`, or `outside_law`.
        "status" as "status": if row.branch.is_some() { "ok" } else { "outside_law" };
    }
}

/// The results of the peak, in the order of `summary.json`.
pub fn peak() -> Vec<Reported<Comparison>> {
    results! { |of: Comparison|
        /// Where the peak comes from: `plm` or `given`.
        "peak.origin": if of.origin == Origin::Plm { "plm" } else { "given" };
        /// Indentation.
        "peak.indentation_m" in Length: of.peak.indentation * of.bodies.yield_point.indentation;
        /// Indentation over that at first yield.
        "peak.indentation_over_yield": of.peak.indentation;
        /// Force.
        "peak.force_N" in Force: of.peak.force * of.bodies.yield_point.force;
        /// Contact radius.
        "peak.contact_radius_m" in Length: of.peak.radius * of.bodies.yield_point.contact_radius;
        /// The sphere's own indentation.
        "peak.sphere_indentation_m" in Length: of.peak.elastic_approach.map(|approach| {
            of.bodies.pair.sphere_compliance * approach * of.bodies.yield_point.indentation
        });
        /// Work of loading up to the peak.
        "peak.spent_work_J" in Energy: of.peak.spent * of.bodies.yield_point.force * of.bodies.yield_point.indentation;
    }
}

/// The files with these results, as Markdown.
pub(super) fn files() -> String {
    file("Comparison: the peak in `summary.json`", &peak())
        + &file("Comparison: every law in `summary.json`, and `comparison.csv`", &row())
}
