//! The pictures that runs write, and those of the repository: no text is cut off, and each kind of run writes the format
//! that it is asked for.

use std::collections::BTreeSet;

use crate::common::prelude::*;

fn is_png(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "png")
}

#[test]
fn pictures_of_the_program_keep_their_text() {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let long = "A half-space with the name of the alloy, of its heat treatment, of the laboratory and of the day";
    let material = |i: usize| {
        format!(
            "[[indentation.half_space]]\nname = \"{long}, {i}\"\nyoungs_modulus = 2e11\npoissons_ratio = 0.3\nyield_strength = 3e8\n"
        )
    };
    let materials: String = (0..12).map(material).collect();
    let bodiless = still.split("[half_space]").next().unwrap().to_owned();
    let laws = plm_impact::contact::law::LawChoice::all();
    let laws: Vec<String> =
        laws.iter().filter(|law| law.has_loading()).map(|law| format!("{:?}", law.name())).collect();
    let laws = format!("\"law\" = [{}, \"kogut_komvopoulos + mesarovic_johnson\"]\n", laws.join(", "));
    let scenes = [
        STEEL.to_owned(),
        format!("{STEEL}[gravity]\nacceleration = 9.81\n[damping]\nhunt_crossley = 0.1\n"),
        format!(
            "{STEEL}[sweep]\n\"impact.speed\" = {{ logspace = [1e-3, 10], points = 12 }}\n{laws}\"sphere.radius\" = {{ linspace = [1e-3, 2e-3], points = 12 }}\n"
        ),
        format!(
            "{STEEL}[sweep]\n\"impact.speed\" = {{ linspace = [1, 2], points = 30 }}\n\"half_space.youngs_modulus\" = {{ linspace = [1e11, 2e11], points = 30 }}\n\"half_space.poissons_ratio\" = [0.1, 0.2, 0.3]\n\"sphere.youngs_modulus\" = [1e11, 2e11]\n\"sphere.poissons_ratio\" = [0.1, 0.2]\n\"sphere.density\" = [7000, 7001]\n"
        ),
        format!(
            "{STEEL}[monte_carlo]\nsamples = 60\n\"half_space.yield_strength\" = {{ normal = {{ mean = 345e6, sd = 20e6 }} }}\n"
        ),
        format!("{STEEL}[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 4\nspot = \"same\"\n"),
        format!("{still}[repeat]\nspeeds = [1, 2, 3]\nspot = \"fresh\"\n"),
        format!("{still}[indentation]\nsteps = [{{ load = 100 }}, {{ load = 0 }}]\n"),
        format!("{bodiless}[indentation]\nsteps = [{{ load = 100 }}, {{ load = 0 }}]\n{materials}"),
    ];
    let mut drawn = BTreeSet::new();
    for scene in scenes {
        let desk = Sandbox::with(&scene);
        desk.run_expecting(&["run", "s.toml", "--out", "out"], 0);
        let names: Vec<String> = desk.files("out").into_iter().filter(|name| is_png(Path::new(name))).collect();
        assert!(!names.is_empty(), "no picture of\n{scene}");
        for name in names {
            assert!(has_free_border(&std::fs::read(desk.path("out").join(&name)).unwrap()), "{name} of\n{scene}");
            drawn.insert(name);
        }
    }
    // long axes get a map, and random values a histogram
    for name in ["restitution.png", "restitution_map.png", "restitution_histogram.png"] {
        assert!(drawn.contains(name), "{drawn:?}");
    }
}

#[test]
fn every_run_writes_requested_pictures() {
    for kind in Kind::ALL.map(Kind::name) {
        let desk = Sandbox::with("");
        let file = format!("{kind}.toml");
        desk.run_expecting(&["init", kind], 0);
        let run = |format: &str| {
            desk.run_expecting(&["run", &file, "--pictures", format, "--out", format], 0);
            let names = desk.files(format);
            let of = |ending: &str| -> Vec<String> {
                names.iter().filter_map(|name| Some(name.strip_suffix(ending)?.to_owned())).collect()
            };
            (of(".png"), of(".svg"), names.len())
        };
        let (png, svg, none) = (run("png"), run("svg"), run("none"));
        assert!(run("narrow-svg") == svg, "{kind}");
        // one measured number leaves nothing to draw
        assert!((kind == "calibrate") == png.0.is_empty() && png.0 == svg.1, "{kind}: {png:?} {svg:?}");
        assert!(png.1.is_empty() && svg.0.is_empty() && none.0.is_empty() && none.1.is_empty());
        // only pictures are left out
        assert_eq!(none.2, png.2 - png.0.len(), "{kind}");
        for name in &svg.1 {
            let drawn = desk.read(&format!("svg/{name}.svg"));
            let svg = Document::parse(&drawn).unwrap();
            let parts = |name: &str| svg.descendants().filter(|node| node.has_tag_name(name)).count();
            assert!(parts("text") > 5 && parts("polyline") > 2 && parts("image") == 0, "{kind}: {name}");
        }
    }
}

/// The line below the title says of the bodies that flow, and of no other, at which strength they yield.
#[test]
fn subtitle_names_yielding_body() {
    let yields = |sphere: &str, half_space: &str| {
        let text = crate::common::STEEL.replace("345 MPa", half_space);
        let desk = Sandbox::with(text.replace("[half_space]", &format!("yield_strength = \"{sphere}\"\n[half_space]")));
        desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "svg"], 0);
        let picture = desk.read("o/force_indentation.svg");
        picture.lines().find(|line| line.contains("law PLM")).unwrap().trim().to_owned()
    };
    let steel = "sphere R 5 mm, E 210 GPa";
    let of =
        |sphere: &str, half_space: &str| format!("{steel}{sphere}; half-space E 210 GPa{half_space}; law PLM, n = 3/2");
    assert_eq!(yields("345 MPa", "800 MPa"), of(", yields at 345 MPa", ""));
    assert_eq!(yields("800 MPa", "345 MPa"), of("", ", yields at 345 MPa"));
    assert_eq!(yields("345 MPa", "350 MPa"), of(", yields at 345 MPa", ", yields at 350 MPa"));
}
