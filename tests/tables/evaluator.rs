//! Rows computed one by one, from lists, and for e alone have the same numbers.

use plm_impact::law::LawChoice;
use plm_impact::plan::{Cases, places};
use plm_impact::scenario::Scenario;
use plm_impact::scene::{Input, Key};
use plm_impact::sweep::evaluator::{Evaluator, Rows};

#[test]
fn listed_cases_have_the_results_of_a_grid() {
    let bodies = r#"
        sphere = { radius = "5 mm", youngs_modulus = "210 GPa", poissons_ratio = 0.3, density = 7850 }
        half_space = { youngs_modulus = "210 GPa", poissons_ratio = 0.3, yield_strength = "345 MPa" }
    "#;
    // closed form, with damping, an axis that changes the contact, and a yield strength that follows from a hardness
    let sweeps = [
        ("", "\"impact.speed\" = [0.001, 0.5, 1.0, 3.0, 4.0]"),
        ("damping.viscous = 0.1", "\"impact.speed\" = [0.5, 1.0, 3.0, 4.0]"),
        ("", "\"half_space.yield_strength\" = [200e6, 345e6, 900e6]\n\"impact.speed\" = [0.5, 1.0, 3.0, 4.0]"),
        (
            "gravity.acceleration = 9.81",
            "\"half_space.hardness\" = [\"100 HV\", \"300 HV\"]\n\"impact.speed\" = [0.5, 1.0]",
        ),
    ];
    for (more, axes) in sweeps {
        let given = if axes.contains("hardness") {
            bodies.replace(", yield_strength = \"345 MPa\"", "")
        } else {
            bodies.to_owned()
        };
        let text = format!("{given}\n{more}\n[sweep]\n{axes}");
        let plan = Scenario::from_text("listed", &text, &[]).unwrap().plan().unwrap().unwrap();
        let Cases::Grid(axes) = &plan.cases else { panic!("{text}") };
        let count = plan.count();
        let evaluator = Evaluator::new(&plan);
        let (mut grid, mut listed) = (Rows::default(), Rows::default());
        evaluator.rows(0..count, &mut grid);
        let values: Vec<Vec<f64>> =
            (0..axes.len()).map(|k| (0..count).map(|case| axes[k].number(places(axes, case)[k])).collect()).collect();
        let keys: Vec<_> = axes.iter().map(|axis| Key::find(axis.path()).unwrap()).collect();
        let keys: Vec<(&Key, &[f64])> = keys.into_iter().zip(values.iter().map(Vec::as_slice)).collect();
        let count = usize::try_from(count).unwrap();
        evaluator.listed(&keys, 0..1, &mut listed);
        evaluator.listed(&keys, 1..count, &mut listed);
        assert_eq!(listed.results, grid.results, "{text}");
        assert!(listed.results.iter().all(Result::is_ok), "{text}");
    }
}

#[test]
fn e_alone_is_that_of_a_row() {
    for (law, name) in LawChoice::all().into_iter().map(|law| (law.clone(), law.name())) {
        let mut input = Input { law, ..Input::default() };
        for (path, value) in [
            ("sphere.radius", 5e-3),
            ("sphere.youngs_modulus", 210e9),
            ("sphere.poissons_ratio", 0.3),
            ("sphere.density", 7850.0),
            ("half_space.youngs_modulus", 210e9),
            ("half_space.poissons_ratio", 0.3),
            ("half_space.yield_strength", 345e6),
        ] {
            (Key::find(path).unwrap().set)(&mut input, Some(value));
        }
        let Ok(contact) = input.resolve().contact() else { continue };
        for k in -80..40 {
            let speed = 10_f64.powf(0.05 * f64::from(k));
            let (alone, row) = (contact.restitution(speed), contact.essentials(speed));
            assert_eq!(alone.ok(), row.ok().map(|row| row.restitution), "{name} at {speed}");
        }
    }
}
