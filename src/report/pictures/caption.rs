//! Texts of a scenario in a picture: the names of its keys, and the line below the title, which states the bodies and the law. A
//! picture without its folder still shows what it is about.

use crate::contact::body::Material;
use crate::contact::law::{LawChoice, UnloadingExponent};
use crate::contact::pair::Pair;
use crate::impact::Damping;
use crate::report::chart::{Axis, Chart};
use crate::scenario::input::{Body, Input, NumericKey};
use crate::scenario::kinds::indentation::IndentationRequest;
use crate::strings::capitalise;
use crate::units::{Dimension, format_four_digits, format_result};

/// The bodies and the law of a scenario, without the keys that vary in the picture.
pub fn caption(input: &Input, varied: &[&str]) -> String {
    let varies = |beginning: &str| varied.iter().any(|path| path.starts_with(beginning));
    let unless_varied = |path: &str, text: String| Some(text).filter(|_| !varies(path));
    let body = |body: Body, modulus: &str, material: &Material| {
        let named = input.materials().iter().find(|choice| choice.body == body);
        match named {
            Some(choice) => unless_varied(body.material(), choice.material.name.clone()),
            None => unless_varied(modulus, elastic_text(material)),
        }
    };
    let own_law = input.law();
    let (sphere, half_space) = input.bodies(&own_law);
    let radius = if varies("sphere.diameter") { "sphere.diameter" } else { "sphere.radius" };
    let varies_strength =
        |body: Body| [body.yield_strength(), body.hardness(), body.material()].into_iter().any(varies);
    // if a strength varies, the body that yields may differ within the picture
    let is_same = !Body::ALL.into_iter().any(varies_strength);
    let pair = Pair::try_new(&sphere, &half_space).ok().filter(|_| is_same);
    let flow = pair.and_then(|pair| pair.yield_point).map(|point| point.yield_partition);
    let strength = |body: Body, strength: Option<f64>| {
        let text = format_result(strength.filter(|_| !varies_strength(body))?, Dimension::Pressure);
        match flow {
            Some(flow) => {
                let yields = flow.is_shared() || flow.for_softer(Body::ALL) == body;
                yields.then(|| format!("yields at {text}"))
            }
            None => Some(format!("strength {text}")),
        }
    };
    let of_sphere = [
        unless_varied(radius, format!("R {}", format_result(sphere.radius, Dimension::Length))),
        body(Body::Sphere, "sphere.youngs_modulus", &sphere.material),
        strength(Body::Sphere, sphere.yield_strength),
    ];
    let curved = |radius| unless_varied("half_space.radius", format!("R {}", format_result(radius, Dimension::Length)));
    let of_half_space = [
        half_space.radius.and_then(curved),
        body(Body::HalfSpace, "half_space.youngs_modulus", &half_space.material),
        strength(Body::HalfSpace, half_space.yield_strength),
    ];
    let damping = input.forces().damping.and_then(|damping| match damping {
        Damping::Viscous(share) => unless_varied("damping.viscous", format!("viscous {}", format_four_digits(share))),
        Damping::HuntCrossley(chi) => unless_varied(
            "damping.hunt_crossley",
            format!("Hunt–Crossley {}", format_result(chi, Dimension::InverseSpeed)),
        ),
        Damping::Viscoelastic(time) => {
            unless_varied("damping.viscoelastic_time", format!("viscoelastic {}", format_result(time, Dimension::Time)))
        }
    });
    join_parts(&[
        ("sphere", &of_sphere),
        ("half-space", &of_half_space),
        ("law", &[unless_varied("law", law_text(&own_law))]),
        ("damping", &[damping]),
    ])
}

/// These pictures with this line below their titles.
pub fn with_captions<N>(pictures: Vec<(N, Chart)>, line: &str) -> Vec<(N, Chart)> {
    pictures.into_iter().map(|(name, chart)| (name, chart.with_caption(line))).collect()
}

/// The sphere and the law of an indentation; its half-spaces have names in the key.
pub fn indentation_caption(scene: &IndentationRequest) -> String {
    let sphere = [
        Some(format!("R {}", format_result(scene.sphere.radius, Dimension::Length))),
        Some(elastic_text(&scene.sphere.material)),
    ];
    join_parts(&[("sphere", &sphere), ("law", &[Some(law_text(&scene.law))])])
}

fn elastic_text(material: &Material) -> String {
    let modulus = material.youngs_modulus;
    if modulus.is_finite() { format!("E {}", format_result(modulus, Dimension::Pressure)) } else { "rigid".to_owned() }
}

fn law_text(law: &LawChoice) -> String {
    match law {
        LawChoice::Plm(law) => match law.exponent {
            UnloadingExponent::Paper => "PLM, n = 3/2".to_owned(),
            UnloadingExponent::Fixed(exponent) => format!("PLM, n = {exponent}"),
            UnloadingExponent::PressureShape => "PLM, pressure-shape".to_owned(),
        },
        other => law_title(&other.name()),
    }
}

/// The parts that have something to say.
fn join_parts(parts: &[(&str, &[Option<String>])]) -> String {
    let words = parts.iter().filter_map(|(name, values)| {
        let values: Vec<&str> = values.iter().flatten().map(String::as_str).collect();
        (!values.is_empty()).then(|| format!("{name} {}", values.join(", ")))
    });
    words.collect::<Vec<_>>().join("; ")
}

/// The path of a key, or the name of a result, in words, such as "half-space Young's modulus".
pub(crate) fn path_words(path: &str) -> String {
    let path = match path {
        "impact.speed" | "impact.angle" => path,
        "half_space.thickness" => "plate.thickness",
        "half_space.rod_diameter" => "rod.diameter",
        path => path.trim_start_matches("impact."),
    };
    let law = path.strip_prefix("law.").and_then(|rest| rest.split_once('.'));
    let (law, path) = law.map_or_else(|| (String::new(), path), |(law, rest)| (law_title(law) + " ", rest));
    let words = path.replace(['.', '_'], " ").replace("half space", "half-space");
    let names = [
        ("youngs", "Young's"),
        ("poissons", "Poisson's"),
        ("rate johnson cook", "Johnson–Cook"),
        ("rate cowper symonds", "Cowper–Symonds"),
    ];
    law + &names.iter().fold(words, |words, (plain, written)| words.replace(plain, written))
}

/// The name of a law as a reader writes it: "PLM", "Walton–Braun", or "PLM + Thornton".
pub(crate) fn law_title(name: &str) -> String {
    let title = |law: &str| match law.trim() {
        "plm" => "PLM".to_owned(),
        law => law.split('_').map(capitalise).collect::<Vec<_>>().join("–"),
    };
    name.split('+').map(title).collect::<Vec<_>>().join(" + ")
}

/// The path of a key, or the name of a result, as a title, such as "Half-space Young's modulus".
pub fn path_title(path: &str) -> String {
    capitalise(&path_words(path))
}

/// The axis of a key. Its values are those of [`crate::scenario::keys::Quantity::picture_unit`].
pub(crate) fn key_axis(key: NumericKey, is_logarithmic: bool) -> Axis {
    let axis = Axis::linear(&path_title(key.path()), key.quantity().picture_unit().0);
    if is_logarithmic { axis.logarithmic() } else { axis }
}
