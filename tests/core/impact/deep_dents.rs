//! Warnings of deep dents, of the target's inertia, and of Poisson's ratios without finite elements.

use crate::common::prelude::*;

/// A steel shot of 0.3 mm radius on steel of 800 MPa (`src/reference/fe_deep_impacts.csv`), with these keys in place of others.
fn shot(speed: &str, set: &[&str]) -> Impact {
    let speed = format!("impact.speed={speed}");
    let of_shot = ["sphere.radius=0.3 mm", "half_space.yield_strength=800 MPa", "half_space.density=7850", &speed];
    let keys = [&of_shot[..], set].concat();
    let input = scene(STEEL, &keys);
    input.contact().unwrap().impact(input.speed(), &Solver::AUTO, None).unwrap()
}

/// The size of the warning of this kind.
fn size_of(impact: &Impact, kind: WarningKind) -> Option<f64> {
    impact.warnings.iter().find(|warning| warning.kind == kind).map(|warning| warning.size)
}

#[test]
fn deep_dent_warns_only_without_hardening() {
    let hardens = "half_space.flow_stress.power.exponent=0.1";
    let relaxes = "half_space.rate.johnson_cook.c=0.014";
    // a/R = 0.36, 0.49 and 0.63
    for (speed, set, is_soft, is_deep) in [
        ("40 m/s", &[][..], false, false),
        ("70 m/s", &[], true, false),
        ("70 m/s", &[relaxes], true, false),
        ("70 m/s", &[hardens], false, false),
        ("120 m/s", &[], false, true),
        ("70 m/s", &["sphere.youngs_modulus=40 GPa"], false, false),
    ] {
        let impact = shot(speed, set);
        let found = [WarningKind::DeepSoftDent, WarningKind::DeepDent].map(|kind| size_of(&impact, kind).is_some());
        assert_eq!(found, [is_soft, is_deep], "{speed} {set:?}: a/R = {}", impact.row.radius_ratio);
    }
}

/// (1/π)(ρ_h/ρ_s)(a/R)³, from 2 % on and only for a half-space whose density is known.
#[test]
fn inertia_of_target_warns_with_its_size() {
    let impact = shot("80 m/s", &[]);
    let share = impact.row.radius_ratio.powi(3) / std::f64::consts::PI;
    assert!(relative_error(size_of(&impact, WarningKind::TargetInertia).unwrap(), share) < 1e-14);
    assert!(share > 0.03 && share < 0.06, "{share}");
    for set in [&["half_space.density=none"], &["half_space.density=2700"]] {
        assert!(size_of(&shot("80 m/s", set), WarningKind::TargetInertia).is_none_or(|size| size < 0.5 * share));
    }
    assert_eq!(size_of(&shot("20 m/s", &[]), WarningKind::TargetInertia), None);
}

#[test]
fn poissons_ratio_below_minus_0_1_warns() {
    for (ratio, is_warned) in [("-0.2", true), ("-0.05", false), ("0.03", false), ("0.45", false)] {
        let impact = shot("10 m/s", &[&*format!("half_space.poissons_ratio={ratio}")]);
        assert_eq!(size_of(&impact, WarningKind::NegativePoissonsRatio).is_some(), is_warned, "{ratio}");
    }
    // neither the elastic sphere nor another law
    for set in [&["sphere.poissons_ratio=-0.2"][..], &["half_space.poissons_ratio=-0.2", "law=thornton"]] {
        assert_eq!(size_of(&shot("10 m/s", set), WarningKind::NegativePoissonsRatio), None);
    }
}
