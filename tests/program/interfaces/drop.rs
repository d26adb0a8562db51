//! `plm-impact drop`, and the words of the bench: rebound height, dent diameter, marks of e, and help on one key.

use crate::common::prelude::*;

const DROP: [&str; 9] =
    ["drop", "--ball", "steel-52100-hardened", "--diameter", "10 mm", "--on", "aluminium-6061-t6", "--from", "1 m"];

fn json(desk: &Sandbox, more: &[&str]) -> Value {
    serde_json::from_str(&desk.run_expecting(&[&DROP[..], &["--json"], more].concat(), 0).0).unwrap()
}

fn number(summary: &Value, name: &str) -> f64 {
    summary[name].as_f64().unwrap_or_else(|| panic!("{name}: {summary}"))
}

#[test]
fn drop_matches_its_scenario() {
    let desk = Sandbox::with("");
    let direct = json(&desk, &["--save", "d.toml"]);
    desk.run_expecting(&["run", "d.toml", "--out", "out", "--pictures", "none"], 0);
    let run = desk.summary();
    for name in ["restitution", "restitution_with_waves", "rebound_height_m", "dent_diameter_m", "peak_force_N"] {
        assert_eq!(direct[name], run[name], "{name}");
    }
    // h = (e v)^2/(2 g) with v^2 = 2 g h_0, after the waves have taken their part
    let e = number(&run, "restitution_with_waves");
    assert!(relative_error(number(&run, "rebound_height_m"), e * e) < 1e-12);
    assert_eq!(number(&run, "dent_diameter_m"), 2.0 * number(&run, "peak_contact_radius_m"));
    // a ball that bounces on needs gravity, and the refusal has the option to copy
    let (_, said) = desk.run_expecting(&["run", "d.toml", "--set", "repeat.impacts=5", "--out", "r"], 2);
    assert!(said.contains("--set gravity.acceleration=\"9.80665 m/s^2\""), "{said}");
    let bounces = "run d.toml --set repeat.impacts=5 --set repeat.spot=fresh --out r --pictures none";
    let gravity = " --set gravity.acceleration=9.80665";
    desk.run_expecting(&(bounces.to_owned() + gravity).split(' ').collect::<Vec<_>>(), 0);
    // a file that is there stays as it is
    let before = desk.read("d.toml");
    let (_, said) = desk.run_expecting(&[&DROP[..], &["--save", "d.toml", "--thickness", "5 mm"]].concat(), 2);
    assert!(said.contains("d.toml") && desk.read("d.toml") == before, "{said}");
}

#[test]
fn drop_prints_main_results_and_writes_nothing() {
    let desk = Sandbox::with("");
    let (printed, _) = desk.run_expecting(&DROP, 0);
    for name in
        ["restitution", "restitution without waves", "rebound height", "dent diameter", "peak force", "contact time"]
    {
        assert!(printed.lines().any(|line| line.starts_with(name)), "{name}: {printed}");
    }
    // the interval is that of the restitution that is measured
    let first = printed.lines().next().unwrap();
    let e = number(&json(&desk, &[]), "restitution_with_waves");
    assert!(
        first.contains(&plm_impact::units::format_four_digits(e))
            && first.contains(": hardness 99 HV to 113 HV, strain rate 0 to +10 %, law "),
        "{printed}"
    );
    assert_eq!(desk.files("."), ["s.toml"]);
}

/// A warning speaks of no key that nobody gave.
#[test]
fn elastic_drop_warns_of_no_law() {
    let desk = Sandbox::with("");
    let dropped = |more: &[&str]| {
        let drop = ["drop", "--ball", "nylon-66", "--diameter", "5 mm", "--on", "glass-soda-lime", "--speed", "1 m/s"];
        desk.run_expecting(&[&drop, more].concat(), 0)
    };
    let warned = dropped(&[]).1;
    assert!(warned.contains("e = 1 is the elastic limit") && !warned.contains("has no effect"), "{warned}");
    let warned = dropped(&["--strength", "3 GPa", "--save", "d.toml"]).1;
    assert!(!warned.contains("has no effect") && desk.read("d.toml").contains("[law.plm]"), "{warned}");
}

#[test]
fn part_of_name_finds_keys_and_materials() {
    let desk = Sandbox::with("");
    let (angle, _) = desk.run_expecting(&["keys", "impact.angle"], 0);
    assert!(
        angle.starts_with("impact.angle\n") && angle.contains("default: 0 deg") && angle.lines().count() == 5,
        "{angle}"
    );
    let (all, _) = desk.run_expecting(&["keys"], 0);
    assert!(ALL_KEYS.iter().all(|key| all.contains(key.path)));
    assert!(
        all.contains("which `plm-impact materials` lists") && !all.contains("]("),
        "a terminal has no links: {all}"
    );
    for (text, name) in [("304", "steel-304-annealed"), ("100cr6", "steel-52100-hardened"), ("1.4301", "steel-304")] {
        let (found, _) = desk.run_expecting(&["materials", text], 0);
        assert!(found.contains(name) && !found.contains("nylon"), "{text}: {found}");
    }
}

/// Any result can be drawn over the axes; a name as first axis gives curves by name, and one speed with all laws gives a column
/// for each.
#[test]
fn pictures_are_those_that_are_chosen() {
    let desk = Sandbox::with("");
    let run = |sweep: &str| {
        std::fs::write(desk.path("s.toml"), format!("{STEEL}{sweep}")).unwrap();
        let _ = std::fs::remove_dir_all(desk.path("o"));
        desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "svg"], 0);
        desk.files("o")
            .into_iter()
            .filter(|name| Path::new(name).extension().is_some_and(|end| end == "svg"))
            .collect::<Vec<_>>()
    };
    let axes =
        "[sweep]\n\"sphere.radius\" = { linspace = [\"1 mm\", \"5 mm\"], points = 9 }\n\"impact.speed\" = [1, 2]\n";
    assert_eq!(run(axes), ["restitution.svg"]);
    let chosen = format!("{axes}[output]\npicture = [\"dent_diameter_m\", \"peak_force_N\"]\n");
    assert_eq!(run(&chosen), ["dent_diameter_m.svg", "peak_force_N.svg"]);
    let drawn = desk.read("o/dent_diameter_m.svg");
    assert!(drawn.contains("Dent diameter [mm]") && drawn.contains("Dent diameter by impact speed"), "{drawn}");
    // a name as first axis: curves run along the second
    assert_eq!(run("[sweep]\nlaw = [\"plm\", \"thornton\"]\n\"impact.speed\" = [1, 2, 3]\n"), ["restitution.svg"]);
    assert!(desk.read("o/restitution.svg").contains("Restitution by law"));
    // names alone: a column for each, with its value
    assert_eq!(run("[sweep]\nlaw = \"all\"\n"), ["restitution.svg"]);
    let (columns, table) = (desk.read("o/restitution.svg"), desk.read("o/table.csv"));
    for law in ["PLM", "Thornton", "Stronge", "Kogut–Etsion"] {
        assert!(columns.contains(law), "{law}");
    }
    for e in numbers(&table, "restitution").into_iter().filter(|e| e.is_finite()) {
        assert!(columns.contains(plm_impact::units::format_four_digits(e).as_str()), "{e}");
    }
    // its value is in the key, and its place below it and in the key
    let texts: Vec<&str> = columns.lines().map(str::trim).collect();
    for text in ["1\u{a0}PLM", "12\u{a0}Johnson", "1", "12"] {
        assert!(texts.contains(&text), "{text}: {columns}");
    }
    // an elastic law leaves no dent: an empty place
    run("[sweep]\nlaw = [\"plm\", \"hertz\"]\n[output]\npicture = [\"dent_diameter_m\"]\n");
    let dents = desk.read("o/dent_diameter_m.svg");
    assert!(dents.contains("none") && !dents.contains("NaN"), "{dents}");
    // a picture that is named twice would be one file twice
    std::fs::write(
        desk.path("s.toml"),
        format!("{STEEL}{}", chosen.replace("\"peak_force_N\"", "\"dent_diameter_m\"")),
    )
    .unwrap();
    let (_, said) = desk.run_expecting(&["run", "s.toml", "--out", "twice"], 2);
    assert!(said.contains("output.picture") && said.contains("named twice"), "{said}");
    // one impact has no axes
    std::fs::write(desk.path("s.toml"), format!("{STEEL}[output]\npicture = [\"restitution\"]\n")).unwrap();
    let (_, said) = desk.run_expecting(&["run", "s.toml", "--out", "one"], 2);
    assert!(said.contains("output.picture"), "{said}");
}

#[test]
fn integration_accuracy_is_printed_on_request() {
    let desk = Sandbox::with(STEEL);
    let run = |more: &[&str]| {
        desk.run_expecting(&[&["run", "s.toml", "--out", "o", "--pictures", "none"], more].concat(), 0).0
    };
    let (short, long) = (run(&[]), run(&["--verbose"]));
    for words in ["steps  ", "closed form", "energy balance error"] {
        assert!(!short.contains(words) && long.contains(words), "{words}: {long}");
    }
    assert!(short.contains("recovered") && desk.json("o/summary.json")["work"]["steps"].is_u64());
}

#[test]
fn several_files_are_run_one_after_the_other() {
    let desk = Sandbox::with(STEEL);
    desk.write("t.toml", STEEL.replace("3 m/s", "2 m/s"));
    let (printed, _) =
        desk.run_expecting(&["run", "s.toml", "t.toml", "--pictures", "none", "--set", "sphere.radius=1 mm"], 0);
    assert_eq!(printed.matches("impact speed").count(), 2, "{printed}");
    let e = |name: &str| number(&desk.json(&format!("plots/{name},sphere.radius=1mm/summary.json")), "restitution");
    assert!(e("s") < e("t"));
}
