//! A run may replace or remove only its own results in its folder, and reports every such change.

use crate::common::prelude::*;

const RUN: [&str; 4] = ["run", "s.toml", "--out", "o"];

/// A PNG of another program: its first chunk is followed by a text.
fn other_png(program: Option<&str>) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder =
        png::Encoder::new(&mut file, plm_impact::report::chart::SIZE.0, plm_impact::report::chart::SIZE.1);
    encoder.set_color(png::ColorType::Rgb);
    if let Some(program) = program {
        encoder.add_text_chunk("Software".into(), program.into()).unwrap();
    }
    let pixels = vec![0; 3 * plm_impact::report::chart::SIZE.0 as usize * plm_impact::report::chart::SIZE.1 as usize];
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    file
}

#[test]
fn pictures_of_other_programs_are_kept() {
    for mine in [other_png(Some("another")), other_png(None), b"\x89PNG\r\n\x1a\nmine".to_vec()] {
        let desk = Sandbox::with(STEEL);
        desk.write("o/history.png", &mine);
        let said = desk.run_expecting(&RUN, 2).1;
        assert!(said.contains("o/history.png: already exists and was not written by this program"), "{said}");
        assert_eq!((fs::read(desk.path("o/history.png")).unwrap(), desk.files("o").len()), (mine, 1));
    }
    let desk = Sandbox::with(STEEL);
    desk.write("o/history.png", other_png(None));
    desk.run_expecting(&[&RUN[..], &["--force"]].concat(), 0);
    // without its summary, as after a kill, a picture of this program is known by its form
    fs::remove_file(desk.path("o/summary.json")).unwrap();
    desk.run_expecting(&RUN, 0);
}

#[test]
fn earlier_summary_protects_files_outside_its_list() {
    let desk = Sandbox::with(STEEL);
    desk.run_expecting(&[&RUN[..], &["--pictures", "none"]].concat(), 0);
    desk.write("o/history.png", "mine");
    let said = desk.run_expecting(&RUN, 2).1;
    assert!(said.contains("o/history.png: already exists and was not written by this program"), "{said}");
    assert_eq!(desk.read("o/history.png"), "mine");
    assert_eq!(desk.files("o"), ["history.png", "summary.json", "trace.csv"]);
}

#[test]
fn a_parquet_table_of_another_program_is_kept() {
    let desk = Sandbox::with(format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 2]\n"));
    let run = [&RUN[..], &["--format", "parquet", "--pictures", "none"]].concat();
    desk.run_expecting(&run, 0);
    let own = fs::read(desk.path("o/table.parquet")).unwrap();
    let begin = own.windows(10).rposition(|bytes| bytes == b"plm-impact").unwrap();
    let mut other = own.clone();
    other[begin..begin + 10].copy_from_slice(b"parquet-rs");
    for mine in [other, b"PAR1 mine".to_vec()] {
        fs::remove_dir_all(desk.path("o")).unwrap();
        desk.write("o/table.parquet", &mine);
        let said = desk.run_expecting(&run, 2).1;
        assert!(said.contains("o/table.parquet: already exists and was not written by this program"), "{said}");
        assert!(fs::read(desk.path("o/table.parquet")).unwrap() == mine);
    }
    fs::remove_dir_all(desk.path("o")).unwrap();
    desk.write("o/table.parquet", &own);
    desk.run_expecting(&run, 0);
}

#[test]
fn scenario_files_are_never_removed_or_replaced() {
    let desk = Sandbox::with(STEEL);
    desk.write("d.csv", "speed_m_per_s,restitution\n1,0.6\n2,0.53\n3,0.49\n");
    desk.run_expecting(&["calibrate", "s.toml", "d.csv", "--out", "o", "--pictures", "none"], 0);
    let scenario = desk.read("o/calibrated.toml");
    // the scenario is one of the results that give way
    desk.run_expecting(&["run", "o/calibrated.toml", "--out", "o", "--force", "--pictures", "none"], 0);
    assert_eq!(desk.read("o/calibrated.toml"), scenario);
    // a result of the same name
    let again = ["calibrate", "o/calibrated.toml", "d.csv", "--out", "o", "--force", "--pictures", "none"];
    let said = desk.run_expecting(&again, 2).1;
    assert!(said.contains("o/calibrated.toml: this file belongs to the scenario"), "{said}");
    assert_eq!(desk.read("o/calibrated.toml"), scenario);
    // data that the scenario reads
    let curve = "plastic_strain,stress_Pa\n0,345e6\n0.1,600e6\n";
    desk.write("p/trace.csv", curve);
    desk.write("p.toml", STEEL.replace("[impact]", "flow_stress = { table = \"p/trace.csv\" }\n\n[impact]"));
    let said = desk.run_expecting(&["run", "p.toml", "--out", "p", "--force", "--pictures", "none"], 2).1;
    assert!(said.contains("p/trace.csv: this file belongs to the scenario"), "{said}");
    assert_eq!(desk.read("p/trace.csv"), curve);
}

#[test]
fn pictures_that_are_removed_are_named() {
    let desk = Sandbox::with(STEEL);
    desk.run_expecting(&RUN, 0);
    let said = desk.run_expecting(&[&RUN[..], &["--pictures", "none"]].concat(), 0).1;
    assert!(said.contains("o: removed force_indentation.png, history.png of an earlier run"), "{said}");
    let said = desk.run_expecting(&[&RUN[..], &["--pictures", "none"]].concat(), 0).1;
    assert!(!said.contains("removed"), "{said}");
}

#[test]
fn table_stays_when_written_in_other_format() {
    let desk = Sandbox::with(format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 2]\n"));
    let run = [&RUN[..], &["--pictures", "none"]].concat();
    desk.run_expecting(&run, 0);
    let table = desk.read("o/table.csv");
    let said = desk.run_expecting(&[&run[..], &["--format", "parquet"]].concat(), 0).1;
    assert!(!said.contains("removed") && desk.read("o/table.csv") == table, "{said}");
    assert_eq!(desk.files("o"), ["summary.json", "table.csv", "table.parquet"]);
    assert_eq!(desk.json("o/summary.json")["provenance"]["files"], json!(["table.parquet", "table.csv"]));
    // a table with older numbers does not stay
    let older = desk.read("o/summary.json").replace("\"numbers_version\": ", "\"numbers_version\": 1000");
    desk.write("o/summary.json", older);
    let said = desk.run_expecting(&[&run[..], &["--format", "parquet"]].concat(), 0).1;
    assert!(said.contains("o: removed table.csv of an earlier run") && !desk.path("o/table.csv").exists(), "{said}");
    // an edited scenario has neither
    fs::write(desk.path("s.toml"), STEEL).unwrap();
    desk.run_expecting(&run, 0);
    assert_eq!(desk.files("o"), ["summary.json", "trace.csv"]);
}

/// The parts of a table have no name of their table: none of an older table may stay.
#[test]
fn foreign_files_stay_beside_parts_old_parts_go() {
    let desk = Sandbox::with(format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 2]\n"));
    let shard = [&RUN[..], &["--shard", "0/1", "--pictures", "none"]].concat();
    desk.run_expecting(&shard, 0);
    desk.write("o/parts/notes.txt", "mine");
    let older = desk.read("o/parts/part-00000.csv");
    fs::write(desk.path("s.toml"), desk.read("s.toml").replace("5 mm", "4 mm").replace("[1, 2]", "[3, 4]")).unwrap();
    desk.run_expecting(&[&shard[..], &["--force"]].concat(), 0);
    let newer = desk.read("o/parts/part-00000.csv");
    assert!(newer != older && newer.contains("\n0,3.0,"), "{newer}");
    // the parts become one file
    desk.run_expecting(&[&RUN[..], &["--pictures", "none"]].concat(), 0);
    assert_eq!(desk.read("o/table.csv"), newer);
    assert_eq!((desk.files("o/parts"), desk.read("o/parts/notes.txt")), (vec!["notes.txt".to_owned()], "mine".into()));
}

#[test]
fn part_read_by_scenario_is_not_removed() {
    let desk = Sandbox::with(format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 2]\n"));
    let curve = "plastic_strain,stress_Pa\n0,345e6\n0.1,600e6\n";
    desk.write("o/parts/part-00000.csv", curve);
    let scenario = STEEL.replace("[impact]", "flow_stress = { table = \"o/parts/part-00000.csv\" }\n\n[impact]");
    desk.write("s.toml", scenario);
    let said = desk.run_expecting(&[&RUN[..], &["--force"]].concat(), 2).1;
    assert!(said.contains("o/parts/part-00000.csv: this file belongs to the scenario"), "{said}");
    assert_eq!(desk.read("o/parts/part-00000.csv"), curve);
}

#[test]
fn other_settings_have_own_default_folder() {
    let desk = Sandbox::with(STEEL);
    let run = |more: &[&str]| desk.run_expecting(&[&["run", "s.toml", "--pictures", "none"], more].concat(), 0).1;
    let folders = [
        (vec![], "plots/s"),
        (vec!["--set", "impact.speed=2 m/s"], "plots/s,impact.speed=2m_s"),
        (vec!["--speed", "1 m/s", "--set", "law=thornton"], "plots/s,law=thornton,impact.speed=1m_s"),
    ];
    for (more, folder) in &folders {
        let said = run(more);
        assert!(said.contains(&format!("wrote summary.json, trace.csv to {folder}\n")), "{said}");
    }
    let summaries: Vec<String> =
        folders.iter().map(|(_, folder)| desk.read(&format!("{folder}/summary.json"))).collect();
    // the same command again has the same folder and nothing to say
    for (more, _) in &folders {
        assert!(!run(more).contains("replaced"));
    }
    for ((_, folder), before) in folders.iter().zip(&summaries) {
        assert_eq!(desk.read(&format!("{folder}/summary.json")), *before, "{folder}");
    }
    // a setting may be written in two ways
    assert!(run(&["--set", "impact.speed=\"2m/s\""]).contains("to plots/s,impact.speed=2m_s\n"));
    // a new folder that nobody asked for is announced once
    let elsewhere = Sandbox::with(STEEL);
    let first = elsewhere.run_expecting(&["run", "s.toml", "--pictures", "none"], 0).1;
    assert!(first.contains("plots is a new folder; --out names another folder"), "{first}");
    let second = elsewhere.run_expecting(&["run", "s.toml", "--pictures", "none"], 0).1;
    assert!(!second.contains("new folder"), "{second}");
    // one measurement is a setting too
    desk.run_expecting(&["calibrate", "s.toml", "--restitution", "0.49", "--pictures", "none"], 0);
    assert_eq!(desk.read("plots/s/summary.json"), summaries[0]);
    desk.write("data/d.csv", "speed_m_per_s,restitution\n1,0.6\n2,0.53\n3,0.49\n");
    let said = desk.run_expecting(&["calibrate", "s.toml", "data/d.csv", "--pictures", "none"], 0).1;
    assert!(said.contains("to plots/s,calibrate.data=d.csv\n"), "{said}");
    // long settings with the same beginning have two folders, whose names a file system takes
    let speeds = (2..90).map(|speed: u32| speed.to_string()).collect::<Vec<_>>().join(", ");
    let folders = ["100", "101"].map(|last| {
        let sweep = format!("sweep={{ \"impact.speed\" = [{speeds}, {last}] }}");
        let said = desk.run_expecting(&["run", "s.toml", "--set", &sweep, "--pictures", "none"], 0).1;
        said.split_once("plots/").and_then(|(_, path)| path.split_once('/')).unwrap().0.to_owned()
    });
    assert!(folders[0] != folders[1] && folders.iter().all(|name| name.len() < 200), "{folders:?}");
}

#[test]
fn folder_refuses_results_of_other_settings() {
    let desk = Sandbox::with(STEEL);
    let run = [&RUN[..], &["--pictures", "none"]].concat();
    let slow = [&run[..], &["--set", "impact.speed=1 m/s"]].concat();
    desk.run_expecting(&slow, 0);
    let before = desk.read("o/summary.json");
    for other in [run.clone(), [&run[..], &["--set", "impact.speed=2 m/s"]].concat()] {
        let said = desk.run_expecting(&other, 2).1;
        let made_by = "made by `plm-impact run s.toml --out o --pictures none --set 'impact.speed=1 m/s'`";
        assert!(
            said.contains("o: contains results of s.toml with other --set or options") && said.contains(made_by),
            "{said}"
        );
        assert!(said.contains("Choose another --out") && said.contains("--force"), "{said}");
        assert_eq!(desk.read("o/summary.json"), before);
    }
    assert!(!desk.run_expecting(&slow, 0).1.contains("replaced"));
    // an edited scenario with the same settings replaces its older results, and says so
    fs::write(desk.path("s.toml"), STEEL.replace("345 MPa", "350 MPa")).unwrap();
    assert!(desk.run_expecting(&slow, 0).1.contains("o: replaced the results of s.toml as it was"));
    assert!(desk.run_expecting(&[&run[..], &["--force"]].concat(), 0).1.contains("o: replaced the results of s.toml"));
}

#[test]
fn other_text_of_standard_input_is_named() {
    let desk = Sandbox::with("");
    let piped = |speed: &str| {
        let output =
            desk.run_with_stdin(&["run", "-", "--out", "w", "--pictures", "none"], &STEEL.replace("3 m/s", speed));
        (output.status.code(), text(&output.stderr))
    };
    assert_eq!(piped("1 m/s").0, Some(0));
    let (code, said) = piped("2 m/s");
    assert!(code == Some(2) && said.contains("w: contains results of another text from stdin"), "{said}");
}
