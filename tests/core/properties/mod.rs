//! Random scenes of one impact: all bodies, laws, forces, methods and spots at once, and what holds for every one of them. The tests
//! of the other files have a closed form, a reference, a published number or an edge of their own.

mod balances;
mod equivalences;
mod generators;
mod law;
mod random_scenario;
mod surface;
mod trace;
mod units;

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::common::prelude::*;
use balances::Judgement;
use generators::any_scene;
use random_scenario::Run;

/// A name, what has to hold, and the least share of the scenes \[%\] in which it can be judged.
type Invariant = (&'static str, fn(&Run) -> Judgement, usize);

const SINGLE_IMPACT_INVARIANTS: [Invariant; 11] = [
    ("the ledger closes", balances::the_ledger_closes, 60),
    ("the reported energies add up", balances::the_reported_energies_add_up, 70),
    ("restitution is a ratio", balances::restitution_is_a_ratio, 60),
    ("sizes fit together", balances::sizes_fit_together, 70),
    ("rows are in order", trace::rows_are_in_order, 30),
    ("the trace is that of the summary", trace::the_trace_is_that_of_the_summary, 25),
    ("events are where the law has them", trace::events_are_where_the_law_has_them, 20),
    ("rows lie on the law", law::rows_lie_on_the_law, 25),
    ("momentum of both bodies stays", balances::momentum_of_both_bodies_stays, 5),
    ("friction keeps its ledger", balances::friction_keeps_its_ledger, 10),
    ("depth is warned of", law::an_impact_deeper_than_the_data_is_warned_of, 40),
];

const COMPARISON_INVARIANTS: [Invariant; 18] = [
    ("a row has the bits of the impact", equivalences::a_row_has_the_bits_of_the_impact, 60),
    ("a trace changes no bit", equivalences::a_trace_changes_no_bit, 50),
    ("spot and friction leave the normal motion", equivalences::spot_and_friction_leave_the_normal_motion, 60),
    ("methods agree", equivalences::methods_agree, 55),
    ("samples are as good as the tolerance", trace::samples_are_as_good_as_the_tolerance, 12),
    ("units do not matter", units::units_do_not_matter, 50),
    ("damping of nothing", equivalences::damping_of_nothing_changes_nothing, 40),
    ("fixed steps come near", equivalences::fixed_steps_come_near, 40),
    ("what has no effect", equivalences::what_has_no_effect_changes_nothing, 15),
    ("damping and a waveguide only take", equivalences::damping_and_a_waveguide_only_take, 15),
    ("a spot remembers", surface::a_spot_remembers, 5),
    ("the rate is that of the depth that it gives", surface::the_rate_is_that_of_the_depth_that_it_gives, 8),
    ("the law is orderly", surface::the_law_is_orderly, 50),
    ("exponent of unloading", law::the_exponent_gives_back_no_more_than_was_spent, 6),
    ("force with a memory", law::a_force_with_a_memory_goes_the_same_way, 40),
    ("slow indentation", law::a_slow_indentation_is_the_impact_without_motion, 40),
    ("Hunt and Crossley", law::hunt_and_crossley_need_no_steps, 1),
    ("waves", law::waves_take_the_integral, 1),
];

/// These must occur among the scenes that have a result, each in a hundredth of them at least.
const REQUIRED_KINDS: [&str; 22] = [
    "sphere.youngs_modulus=\"rigid\"",
    "sphere.yield_strength",
    "half_space.yield_strength",
    "half_space.radius=-",
    "half_space.mass=\"ball\"",
    "half_space.flow_stress.power",
    "half_space.flow_stress.voce",
    "half_space.flow_stress.linear",
    "half_space.flow_stress.points",
    "half_space.rate.johnson_cook",
    "half_space.rate.cowper_symonds",
    "half_space.thickness",
    "half_space.rod_diameter",
    "law=",
    "law.plm.unloading_exponent=\"pressure-shape\"",
    "law.plm.unloading_exponent=1",
    "gravity",
    "damping.hunt_crossley",
    "damping.viscous",
    "damping.viscoelastic_time",
    "friction",
    "earlier Some",
];

/// Checks that all invariants hold in `count` random scenes. A scene is computed, or refused for a reason that it has.
fn check_invariants(count: u32, invariants: &[Invariant]) {
    let counts = RefCell::new(BTreeMap::<&str, usize>::new());
    let add = |name| *counts.borrow_mut().entry(name).or_default() += 1;
    let computed = check_property(count, &any_scene(), |scene| {
        let run = match scene.run() {
            Ok(run) => run,
            Err(refused) => {
                prop_assert!(scene.explains(&refused), "{:?}", refused);
                return Ok(false);
            }
        };
        let text = format!("{scene:?}");
        REQUIRED_KINDS.into_iter().filter(|kind| text.contains(kind)).for_each(add);
        for (name, invariant, _) in invariants {
            if invariant(&run).map_err(|error| TestCaseError::fail(format!("{name}: {error}")))? {
                add(name);
            }
        }
        Ok(true)
    });
    let (all, counts) = (proptest_config(count).cases as usize, counts.into_inner());
    assert!(100 * computed > 70 * all, "only {computed} of {all} scenes have a result");
    let least = invariants.iter().map(|(name, _, share)| (*name, *share)).chain(REQUIRED_KINDS.map(|kind| (kind, 1)));
    for (name, share) in least {
        let found = counts.get(name).copied().unwrap_or(0);
        assert!(100 * found >= share * all, "{name}: {found} of {all} scenes");
    }
}

#[test]
fn single_impact_invariants_hold() {
    check_invariants(1500, &SINGLE_IMPACT_INVARIANTS);
}

#[test]
fn comparison_invariants_hold() {
    check_invariants(600, &COMPARISON_INVARIANTS);
}
