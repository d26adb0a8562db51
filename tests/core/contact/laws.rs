//! The published laws, compared with tables from independent programs of the same formulas, with their limits, and with
//! each other.

mod closed_forms;
mod every_law;
mod piece_intersections;
mod shallow_dents;
mod tabulated;
mod with_forces;
mod without_motion;

use crate::common::prelude::*;

fn bodies(scene: &Scene) -> YieldingPair {
    let (sphere, half_space) = scene.bodies();
    let pair = Pair::try_new(&sphere, &half_space).unwrap();
    YieldingPair::new(&pair).unwrap()
}

fn case_3() -> YieldingPair {
    bodies(&Scene::case_3())
}

/// C_ν of case 3. The tables are in units of the yield point with this factor, for every law except that of Stronge.
fn factor() -> f64 {
    case_3().yield_point.factor
}

fn law_of(law: &dyn ContactLaw) -> Law {
    law.law(&case_3()).unwrap()
}

/// Every whole law, and combinations of laws that have only loading or only unloading.
pub fn whole_laws() -> Vec<(String, LawChoice)> {
    let mut laws: Vec<LawChoice> = LawChoice::all().into_iter().filter(LawChoice::has_loading).collect();
    laws.push(LawChoice::JacksonGreen(JacksonGreen { hardness: HardnessFit::Cosine, yield_factor: None }));
    for pair in [
        "plm + thornton",
        "jackson_green + brake",
        "kogut_etsion + mesarovic_johnson",
        "jackson_green + yigit_christoforou",
        "plm + hertz",
        "jackson_green + johnson",
    ] {
        laws.push(LawChoice::from_name(pair).unwrap());
    }
    laws.into_iter().map(|law| (format!("{} {law:?}", law.name()), law)).collect()
}
