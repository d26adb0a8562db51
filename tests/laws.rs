//! The published laws against tables computed from their printed formulas by other means, their limits, and each other.

mod common;

use common::{STEPPING, Scene, off, run, worst};
use plm_impact::impact::{Contact, Method, closed_form};
use plm_impact::law::combined::Combined;
use plm_impact::law::jackson_green::{Hardness, JacksonGreen, Jumps};
use plm_impact::law::kogut_etsion::KogutEtsion;
use plm_impact::law::kogut_komvopoulos::KogutKomvopoulos;
use plm_impact::law::published::{Loaded, Recovered};
use plm_impact::law::stronge::Stronge;
use plm_impact::law::thornton::{self, Thornton};
use plm_impact::law::yigit_christoforou::YigitChristoforou;
use plm_impact::law::{Bodies, ContactLaw, Law, LawChoice, Peak, Unloading};
use plm_impact::material::{HalfSpace, Pair, Sphere};

/// The six depths of the tables, in units of the yield indentation.
const DEPTHS: [f64; 6] = [5.2, 13.5, 83.4, 105.1, 683.4, 843.1];

fn parts(scene: &Scene) -> (Sphere, HalfSpace) {
    let sphere = Sphere { radius: scene.radius, material: scene.sphere, density: scene.density, yield_strength: None };
    let half_space = HalfSpace { material: scene.half_space, yield_strength: scene.yield_strength, density: None };
    (sphere, half_space)
}

fn bodies(scene: &Scene) -> Bodies {
    let (sphere, half_space) = parts(scene);
    let pair = Pair::try_new(sphere.radius, &sphere.material, &half_space).unwrap();
    Bodies::new(&pair, &half_space).unwrap()
}

fn case_3() -> Bodies {
    bodies(&Scene::case_3())
}

/// C_ν of case 3: the tables are in units of the yield point by this factor, for every law but Stronge's.
fn factor() -> Option<f64> {
    Some(case_3().yield_point.factor)
}

fn law_of(law: &dyn ContactLaw) -> Law {
    law.law(&case_3()).unwrap()
}

/// F/F_Y, δ_r/δ_m and quasi-static e at a depth in units of the law's own yield indentation `s` δ_Y.
fn native(law: &Law, s: f64, depth: f64) -> (f64, f64, f64) {
    let x = s * depth;
    let peak = law.loaded_to(x);
    let unloading = law.unloading(peak);
    let e = (unloading.stored(x) / law.loading.work(x)).sqrt();
    (peak.force / (s * s.sqrt()), peak.residual() / x, e)
}

#[test]
fn show_11a() {
    let s = case_3().yield_at(1.65);
    let laws: Vec<(&str, Law, f64)> = vec![
        ("JG", law_of(&JacksonGreen { yield_factor: factor(), ..Default::default() }), 1.0),
        ("JG cos", law_of(&JacksonGreen { yield_factor: factor(), hardness: Hardness::Cosine, ..Default::default() }), 1.0),
        ("KE", law_of(&KogutEtsion { yield_factor: factor(), ..Default::default() }), 1.0),
        ("Thornton", law_of(&Thornton::default()), 1.0),
        ("Stronge", law_of(&Stronge::default()), s),
        ("YC", law_of(&YigitChristoforou { yield_factor: factor() }), 1.0),
        ("SMJ", law_of(LawChoice::from_name("mesarovic_johnson").unwrap().get()), 1.0),
        ("KK", law_of(&KogutKomvopoulos::default()), 1.0),
        ("ML", law_of(LawChoice::from_name("ma_liu").unwrap().get()), 1.0),
        ("PLM", law_of(LawChoice::from_name("plm").unwrap().get()), 1.0),
        ("Johnson", law_of(LawChoice::from_name("johnson").unwrap().get()), 1.0),
    ];
    for (name, law, s) in laws {
        print!("{name:9}");
        for depth in DEPTHS {
            let (f, r, e) = native(&law, s, depth);
            print!(" | {f:.4} {r:.4} {e:.4} {:.5}", law.contact_radius(&law.loaded_to(s * depth)) * case_3().yield_radius_ratio());
        }
        println!();
    }
}
