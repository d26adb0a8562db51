//! No picture cuts off its text: text beyond the picture would leave dark pixels at the border.

use std::path::Path;

use plm_impact::plot::{Axis, Heatmap, Lines, Panel, Series, Stack};

use crate::common::STEEL;
use crate::common::command::{Desk, text};
use crate::common::picture::has_free_border;

const LONG: &str = "A title of forty words that somebody wrote who had much to say about the sphere, the half-space, the speed \
                    and the law, and who would like to read all of it above the picture and not only its middle part";

fn curves(names: impl Iterator<Item = String>) -> Vec<Series> {
    names.map(|name| Series::line(name, vec![(1.0, 1.0), (2.0, 3.0)])).collect()
}

fn lines(title: &str, axis: &str, names: impl Iterator<Item = String>, notes: &[&str]) -> Vec<u8> {
    let notes = notes.iter().map(ToString::to_string).collect();
    let (x, y) = (Axis::engineering(axis, "m/s"), Axis::engineering(axis, "N"));
    Lines { title: title.into(), x, y, series: curves(names), guides: Vec::new(), notes }
        .draw()
        .unwrap()
        .to_png()
        .unwrap()
}

#[test]
fn a_border_is_seen_to_be_inked() {
    let bytes = lines("", "x", std::iter::empty(), &[]);
    assert!(has_free_border(&bytes));
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    // one dark pixel in the last column, half-way down
    let at = 3 * (info.width as usize * (info.height as usize / 2) + info.width as usize - 1);
    pixels[at] = 0;
    let mut inked = Vec::new();
    let mut encoder = png::Encoder::new(&mut inked, info.width, info.height);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&pixels).unwrap();
    writer.finish().unwrap();
    assert!(!has_free_border(&inked));
}

#[test]
fn long_titles_names_and_notes_stay_on_the_sheet() {
    let endless = "word".repeat(200);
    let names = |count: usize, name: &str| (0..count).map(|i| format!("{name} {i}")).collect::<Vec<_>>().into_iter();
    for title in ["short", LONG, &endless] {
        for axis in ["v", LONG, &endless] {
            assert!(has_free_border(&lines(title, axis, names(2, "curve"), &[])), "{title} / {axis}");
        }
        assert!(has_free_border(&lines(title, "v", names(3, title), &[title, LONG])), "{title} in the key");
    }
    for count in [1, 17, 40, 300] {
        assert!(has_free_border(&lines(LONG, "v", names(count, "curve"), &[LONG])), "{count} curves");
    }
    let heat = Heatmap {
        title: LONG.into(),
        x: Axis::linear(LONG, ""),
        y: Axis::linear(LONG, ""),
        x_values: vec![1.0, 2.0],
        y_values: vec![1e-9, 2e-9],
        values: vec![0.0, 0.1, 0.2, 123_456.0],
        color: Axis::linear(LONG, ""),
    };
    assert!(has_free_border(&heat.draw().unwrap().to_png().unwrap()));
    let panel = |axis: &str| Panel { y: Axis::linear(axis, ""), share: 1.0, series: curves(names(2, LONG)) };
    let stack =
        Stack { title: LONG.into(), x: Axis::linear(LONG, ""), panels: vec![panel(LONG), panel("y")], notes: vec![] };
    assert!(has_free_border(&stack.draw().unwrap().to_png().unwrap()));
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
    let laws = plm_impact::law::LawChoice::all();
    let laws: Vec<String> =
        laws.iter().filter(|law| law.has_loading()).map(|law| format!("{:?}", law.name())).collect();
    let laws = format!("[sweep]\n\"law\" = [{}, \"kogut_komvopoulos + mesarovic_johnson\"]\n", laws.join(", "));
    let scenes = [
        STEEL.to_owned(),
        format!("{STEEL}[gravity]\nacceleration = 9.81\n[damping]\nhunt_crossley = 0.1\n"),
        format!("{STEEL}{laws}\"impact.speed\" = [1, 2]\n"),
        format!(
            "{STEEL}{laws}\"impact.speed\" = {{ logspace = [1e-3, 10], points = 12 }}\n\"sphere.radius\" = {{ linspace = [1e-3, 2e-3], points = 12 }}\n"
        ),
        format!(
            "{STEEL}[sweep]\n\"impact.speed\" = {{ linspace = [1, 2], points = 30 }}\n\"half_space.youngs_modulus\" = {{ linspace = [1e11, 2e11], points = 30 }}\n\"half_space.poissons_ratio\" = [0.1, 0.2, 0.3]\n\"sphere.youngs_modulus\" = [1e11, 2e11]\n\"sphere.poissons_ratio\" = [0.1, 0.2]\n\"sphere.density\" = [7000, 7001]\n"
        ),
        format!(
            "{STEEL}[monte_carlo]\nsamples = 60\n\"half_space.yield_strength\" = {{ normal = {{ mean = 345e6, sd = 20e6 }} }}\n"
        ),
        format!("{STEEL}[gravity]\nacceleration = 9.81\n[repeat]\nimpacts = 4\nspot = \"same\"\n"),
        format!("{still}[repeat]\nspeeds = [1, 2, 3]\nspot = \"fresh\"\n"),
        format!("{still}[compare]\npeak_indentation_ratio = 105.1\n"),
        format!("{still}[indentation]\nsteps = [{{ load = 100 }}, {{ load = 0 }}]\n"),
        format!("{bodiless}[indentation]\nsteps = [{{ load = 100 }}, {{ load = 0 }}]\n{materials}"),
    ];
    let mut pictures = 0;
    for scene in scenes {
        let desk = Desk::with(&scene);
        let output = desk.call(&["run", "s.toml", "--out", "out", "--quiet"]);
        assert_eq!(output.status.code(), Some(0), "{scene}\n{}", text(&output.stderr));
        for name in desk
            .files("out")
            .iter()
            .filter(|name| Path::new(name).extension().is_some_and(|extension| extension == "png"))
        {
            assert!(has_free_border(&std::fs::read(desk.path("out").join(name)).unwrap()), "{name} of\n{scene}");
            pictures += 1;
        }
    }
    assert_eq!(pictures, 15);
}

#[test]
fn pictures_of_the_repository_keep_their_text() {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("plots")];
    let mut pictures = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                // the picture of a run in LAMMPS is drawn by Matplotlib, not by this program
                if !path.ends_with("plots/lammps") {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|extension| extension == "png") {
                assert!(has_free_border(&std::fs::read(&path).unwrap()), "{}", path.display());
                pictures += 1;
            }
        }
    }
    assert!(pictures > 20, "{pictures}");
}
