//! Tables: numbers compared with the reference, and edge cases of axes.

mod random;
mod refusals;

use std::path::Path;
use std::process::{Command, Output};

use approx::assert_relative_eq;
use plm_impact::scenario::Scenario;
use plm_impact::sweep::evaluator::{Evaluator, Rows};

use crate::common::STEEL;

fn rows(text: &str) -> Rows {
    let plan = Scenario::from_text("test", text, &[]).unwrap().plan().unwrap().unwrap();
    let mut rows = Rows::default();
    Evaluator::new(&plan).rows(0..plan.count(), &mut rows);
    rows
}

fn run(text: &str, directory: &Path) -> Output {
    let file = directory.join("scenario.toml");
    std::fs::write(&file, text).unwrap();
    let program = env!("CARGO_BIN_EXE_plm-impact");
    Command::new(program).arg("run").arg(file).arg("--out").arg(directory.join("out")).output().unwrap()
}

/// The message for a scenario that is refused with exit code 2; nothing may be written.
fn refusal(tables: &str) -> String {
    let directory = tempfile::tempdir().unwrap();
    let output = run(&format!("{STEEL}{tables}"), directory.path());
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{tables}: {text}");
    assert!(!directory.path().join("out").exists(), "{tables}");
    text
}

#[test]
fn rows_agree_with_the_reference() {
    let reference = include_str!("../../src/reference/oracle.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(reference.as_bytes());
    let mut count = 0;
    for record in reader.records().map(Result::unwrap) {
        let exponent = record[9].parse::<f64>().map_or_else(|_| format!("{:?}", &record[9]), |n| format!("{n:?}"));
        let text = format!(
            r#"
[sphere]
radius = {}
youngs_modulus = {}
poissons_ratio = {}
density = {}
[half_space]
youngs_modulus = {}
poissons_ratio = {}
yield_strength = {}
[impact]
speed = 1.0
[law.plm]
unloading_exponent = {exponent}
[sweep]
"impact.speed" = [{}]
"#,
            float(&record[1]),
            sphere_modulus(&record[2]),
            float(&record[3]),
            float(&record[4]),
            float(&record[5]),
            float(&record[6]),
            float(&record[7]),
            float(&record[8]),
        );
        let row = rows(&text).results[0].unwrap();
        let got = [row.restitution, row.contact_time, row.peak_force, row.peak_indentation, row.residual_indentation];
        for (got, column) in got.into_iter().zip([10, 11, 13, 14, 15]) {
            let want: f64 = record[column].parse().unwrap();
            // the closed form is accurate to 5e-14 (tests/physics/oracle.rs)
            assert!((got - want).abs() <= 1e-12 * want.abs(), "{}, column {column}: {got} against {want}", &record[0]);
        }
        count += 1;
    }
    assert!(count > 10);
}

fn float(text: &str) -> String {
    format!("{:?}", text.parse::<f64>().unwrap())
}

fn sphere_modulus(text: &str) -> String {
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => format!("{value:?}"),
        _ => "\"rigid\"".to_owned(),
    }
}

#[test]
fn axes_multiply_and_the_first_varies_slowest() {
    let sweep = r#"[sweep]
"impact.speed" = { linspace = ["3 m/s", "1 m/s"], points = 3 }
"half_space.yield_strength" = ["345 MPa", "900 MPa"]
"sphere.radius" = { linspace = ["2 mm", "5 mm"], points = 1 }
"#;
    let directory = tempfile::tempdir().unwrap();
    let output = run(&format!("{STEEL}{sweep}"), directory.path());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let table = std::fs::read_to_string(directory.path().join("out/table.csv")).unwrap();
    let swept: Vec<String> = table.lines().map(|line| line.split(',').take(4).collect::<Vec<_>>().join(",")).collect();
    // if the first limit is larger, the axis falls; with one point the axis has only the first limit
    let want = [
        "case,impact_speed_m_per_s,half_space_yield_strength_Pa,sphere_radius_m",
        "0,3.0,345000000.0,0.002",
        "1,3.0,900000000.0,0.002",
        "2,2.0,345000000.0,0.002",
        "3,2.0,900000000.0,0.002",
        "4,1.0,345000000.0,0.002",
        "5,1.0,900000000.0,0.002",
    ];
    assert_eq!(swept, want);
    let header = table.lines().next().unwrap();
    assert!(header.ends_with(
        "restitution,contact_time_s,peak_force_N,peak_indentation_m,residual_indentation_m,dent_radius_m,recovered_fraction,plastic_fraction,status"
    ));
    let first: Vec<&str> = table.lines().nth(1).unwrap().split(',').collect();
    let scene = Scenario::from_text("one", STEEL, &["impact.speed=3".to_owned(), "sphere.radius=0.002".to_owned()]);
    let scene = scene.unwrap().resolve().unwrap();
    let impact = scene.contact().unwrap().closed_form(3.0).unwrap();
    let number = |i: usize| first[i].parse::<f64>().unwrap();
    // the digits give exactly the numbers of a single impact
    assert_eq!(number(4), impact.restitution);
    assert_eq!(number(5), impact.contact_time);
    assert_eq!(number(9), impact.dent_radius.unwrap());
    assert_relative_eq!(number(10) + number(11), 1.0, max_relative = 1e-14);
    assert!(directory.path().join("out/restitution.png").exists());
}

#[test]
fn an_elastic_half_space_has_no_plastic_columns() {
    let elastic = STEEL.replace("yield_strength = \"345 MPa\"\n", "");
    let directory = tempfile::tempdir().unwrap();
    let output = run(&format!("{elastic}[sweep]\n\"impact.speed\" = [1, 2]\n"), directory.path());
    assert_eq!(output.status.code(), Some(0));
    let table = std::fs::read_to_string(directory.path().join("out/table.csv")).unwrap();
    let header = table.lines().next().unwrap();
    assert_eq!(
        header,
        "case,impact_speed_m_per_s,restitution,contact_time_s,peak_force_N,peak_indentation_m,recovered_fraction,status"
    );
}

#[test]
fn stepped_methods_can_be_swept() {
    let rows = rows(&format!(
        "{STEEL}[sweep]\n\"solver.method\" = [\"closed_form\", \"dopri5\", \"dop853\"]\n\"solver.tolerance\" = [1e-12]\n"
    ));
    let e: Vec<f64> = rows.results.iter().map(|row| row.unwrap().restitution).collect();
    assert_eq!(e.len(), 3);
    for stepped in &e[1..] {
        assert!(*stepped != e[0]);
        // a thousand times the tolerance
        assert_relative_eq!(*stepped, e[0], max_relative = 1e-9);
    }
}

#[test]
fn the_unloading_exponent_can_be_swept() {
    let rows = rows(&format!("{STEEL}[sweep]\n\"law.plm.unloading_exponent\" = [1.4, 1.5, 2]\n"));
    let e: Vec<f64> = rows.results.iter().map(|row| row.unwrap().restitution).collect();
    // e² = f ε/((n + 1) w), in which only n differs
    assert_relative_eq!(e[2] / e[1], (2.5f64 / 3.0).sqrt(), max_relative = 1e-14);
    assert!(e[0] > e[1]);
}

/// What identifies a row of a table whatever the order of the axes: its values by the names of their columns, and its results.
fn named_rows(bodies: &str, axes: &[&str]) -> Vec<String> {
    let directory = tempfile::tempdir().unwrap();
    let output = run(&format!("{bodies}[sweep]\n{}\n", axes.join("\n")), directory.path());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let mut reader = csv::Reader::from_path(directory.path().join("out/table.csv")).unwrap();
    let names = reader.headers().unwrap().clone();
    let row = |record: csv::StringRecord| {
        let mut fields: Vec<String> =
            names.iter().zip(&record).skip(1).map(|(name, field)| format!("{name}={field}")).collect();
        fields.sort();
        fields.join(" ")
    };
    let mut rows: Vec<String> = reader.records().map(|record| row(record.unwrap())).collect();
    rows.sort();
    rows
}

#[test]
fn any_order_of_axes_gives_the_same_rows() {
    let laws = r#"law = ["plm", "thornton"]"#;
    let exponents = r#""law.plm.unloading_exponent" = [1.3, 1.5, 1.7]"#;
    let speeds = r#""impact.speed" = [0.5, 3]"#;
    let falls = r#""impact.drop_height" = ["1 mm", "10 cm"]"#;
    let gravities = r#""gravity.acceleration" = [1.62, 9.81]"#;
    let metals = r#""half_space.material" = ["steel-304-annealed", "aluminium-6061-t6"]"#;
    let radii = r#""sphere.radius" = [0.002, 0.005]"#;
    let fallen = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let of_metal = STEEL.split("[half_space]").next().unwrap().to_owned() + "[half_space]\n[impact]\nspeed = 3\n";
    let hard = STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"180 HV\"");
    for (bodies, axes) in [
        (STEEL, [laws, exponents, speeds]),
        (&fallen, [laws, gravities, falls]),
        (&of_metal, [laws, metals, radii]),
        (&hard, [laws, exponents, r#""half_space.youngs_modulus" = ["70 GPa", "210 GPa"]"#]),
    ] {
        let [a, b, c] = axes;
        let wanted = named_rows(bodies, &[a, b, c]);
        for order in [[a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            assert_eq!(named_rows(bodies, &order), wanted, "{order:?}");
        }
    }
    // and each row is that of its own single case
    let rows = named_rows(STEEL, &[exponents, laws]);
    let e = |law: &str, exponent: &str| {
        let set = [format!("law={law}"), format!("law.plm.unloading_exponent={exponent}")];
        let given = if law == "plm" { &set[..] } else { &set[..1] };
        let scene = Scenario::from_text("one", STEEL, given).unwrap().resolve().unwrap();
        format!(" restitution={:?} ", scene.contact().unwrap().closed_form(3.0).unwrap().restitution)
    };
    for exponent in ["1.3", "1.5", "1.7"] {
        let found = |row: &&String| row.contains(&e("plm", exponent)) && row.contains(&format!("exponent={exponent}"));
        assert_eq!(rows.iter().filter(found).count(), 1, "{exponent}: {rows:?}");
    }
}

/// More than 10⁴ contacts are not kept, and each is made where a row needs it.
#[test]
fn rows_of_many_contacts_depend_neither_on_threads_nor_on_where_a_piece_begins() {
    let axes = r#""sphere.radius" = { linspace = [0.001, 0.02], points = 5000 }
law = ["plm", "thornton"]
"law.plm.unloading_exponent" = [1.3, 1.4]"#;
    let text = format!("{STEEL}[law.plm]\nunloading_exponent = 1.5\n[sweep]\n{axes}\n");
    let plan = Scenario::from_text("test", &text, &[]).unwrap().plan().unwrap().unwrap();
    let evaluator = Evaluator::new(&plan);
    let whole = rows(&text);
    let mut single = Rows::default();
    (0..plan.count()).for_each(|case| evaluator.rows(case..case + 1, &mut single));
    assert!(single.results == whole.results);
    let e = |case: usize| whole.results[case].unwrap().restitution;
    let contact = |given: &[&str]| {
        let given: Vec<String> = given.iter().map(|&key| key.to_owned()).collect();
        Scenario::from_text("one", STEEL, &given).unwrap().resolve().unwrap().contact().unwrap()
    };
    let radius = "sphere.radius=0.02";
    for (case, exponent) in [(19_996, "1.3"), (19_997, "1.4")] {
        let contact = contact(&[radius, &format!("law.plm.unloading_exponent={exponent}")]);
        assert_eq!(e(case), contact.closed_form(3.0).unwrap().restitution, "{exponent}");
    }
    assert_eq!(e(19_999), contact(&[radius, "law=thornton"]).closed_form(3.0).unwrap().restitution);
    let directory = tempfile::tempdir().unwrap();
    let table = |threads: &str| {
        let (file, out) = (directory.path().join("s.toml"), directory.path().join(threads));
        std::fs::write(&file, &text).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        let run = command.arg("run").args([&file]).arg("--out").arg(&out).args(["--threads", threads]).output();
        assert_eq!(run.unwrap().status.code(), Some(0));
        std::fs::read(out.join("table.csv")).unwrap()
    };
    let one = table("1");
    assert!(one == table("2") && one == table("3"));
}

#[test]
fn a_case_without_a_result_is_a_row_with_a_status() {
    let directory = tempfile::tempdir().unwrap();
    let output = run(&format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 1e-250, 1e200]\n"), directory.path());
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stderr).unwrap();
    assert!(text.contains("2 of 3 cases have no result"), "{text}");
    let table = std::fs::read_to_string(directory.path().join("out/table.csv")).unwrap();
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[1].ends_with(",ok"));
    assert_eq!(lines[2], "1,1e-250,,,,,,,,,out_of_float_range");
    assert_eq!(lines[3], "2,1e+200,,,,,,,,,out_of_float_range");
}

#[test]
fn a_sphere_let_go_at_first_touch_has_a_row_without_restitution() {
    // gravity is so large that the sphere leaves a dent
    let tables = "[gravity]\nacceleration = 1e7\n[sweep]\n\"impact.drop_height\" = [0, \"1 mm\", 0]\n";
    let text = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "") + tables;
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("scenario.toml");
    std::fs::write(&file, &text).unwrap();
    let out = directory.path().join("out");
    let table = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        let output = command.arg("run").arg(&file).arg("--out").arg(&out).args(more).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    };
    table(&[]);
    let whole = std::fs::read_to_string(out.join("table.csv")).unwrap();
    assert!(whole.lines().nth(1).unwrap().starts_with("0,0.0,,,"), "{whole}");
    for key in ["restitution", "recovered_fraction", "plastic_fraction"] {
        let fields = crate::common::command::column(&whole, key);
        assert!(fields[0].is_empty() && !fields[1].is_empty() && fields[2].is_empty(), "{key}: {fields:?}");
    }
    assert!(crate::common::command::column(&whole, "status").iter().all(|status| status == "ok"));
    let residual = crate::common::command::column(&whole, "residual_indentation_m");
    assert!(residual.iter().all(|depth| depth.parse::<f64>().unwrap() > 1e-3), "{residual:?}");
    // such a row counts among those that are there when a run goes on
    table(&["--shard", "0/1"]);
    table(&[]);
    assert_eq!(std::fs::read_to_string(out.join("table.csv")).unwrap(), whole);
}

#[test]
fn shares_beyond_double_precision_are_a_status_and_no_number() {
    // about 80 J of the work of gravity go into the dent, which is 10^309 times the kinetic energy
    let tables = "[gravity]\nacceleration = 1e7\n[sweep]\n\"impact.speed\" = [1e-152, 1e-3]\n";
    let results = rows(&format!("{STEEL}{tables}")).results;
    assert_eq!(results[0].unwrap_err().name(), "out_of_float_range");
    let share = results[1].unwrap().plastic_fraction;
    assert!(share > 1e6 && share.is_finite(), "{share}");
}

fn summary(tables: &str) -> serde_json::Value {
    let directory = tempfile::tempdir().unwrap();
    let output = run(&format!("{STEEL}{tables}"), directory.path());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&std::fs::read(directory.path().join("out/summary.json")).unwrap()).unwrap()
}

#[test]
fn long_axes_get_a_map_and_random_values_a_histogram() {
    let directory = tempfile::tempdir().unwrap();
    let axes = "\"impact.speed\" = { logspace = [1e-3, 10], points = 20 }\n\"sphere.radius\" = { linspace = [1e-3, 1e-2], points = 9 }\n";
    assert_eq!(run(&format!("{STEEL}[sweep]\n{axes}"), directory.path()).status.code(), Some(0));
    for name in ["restitution.png", "restitution_map.png"] {
        let bytes = std::fs::read(directory.path().join("out").join(name)).unwrap();
        let info = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap().info().size();
        assert_eq!(info, plm_impact::plot::SIZE, "{name}");
    }
    let random = "[monte_carlo]\nsamples = 50\n\"impact.speed\" = { uniform = [1, 2] }\n";
    assert_eq!(run(&format!("{STEEL}{random}"), directory.path()).status.code(), Some(0));
    assert!(directory.path().join("out/restitution_histogram.png").exists());
}

#[cfg(feature = "parquet")]
#[test]
fn a_parquet_table_holds_what_the_csv_table_holds() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    let directory = tempfile::tempdir().unwrap();
    let sweep = "[sweep]\n\"solver.method\" = [\"closed_form\", \"dopri5\"]\n\"impact.speed\" = [1e-3, 1, 1e200]\n";
    assert_eq!(run(&format!("{STEEL}{sweep}"), directory.path()).status.code(), Some(1));
    let (file, out) = (directory.path().join("scenario.toml"), directory.path().join("out"));
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
    assert_eq!(
        command.args(["run", "--format", "parquet", "--out"]).args([&out, &file]).status().unwrap().code(),
        Some(1)
    );
    let mut csv = csv::Reader::from_path(out.join("table.csv")).unwrap();
    let names: Vec<String> = csv.headers().unwrap().iter().map(str::to_owned).collect();
    let reader = SerializedFileReader::new(std::fs::File::open(out.join("table.parquet")).unwrap()).unwrap();
    let mut count = 0;
    for (row, record) in reader.get_row_iter(None).unwrap().map(Result::unwrap).zip(csv.records().map(Result::unwrap)) {
        for ((name, field), (column, text)) in row.get_column_iter().zip(names.iter().zip(&record)) {
            assert_eq!(name, column);
            let same = match field {
                parquet::record::Field::Null => text.is_empty(),
                parquet::record::Field::Double(value) => text.parse() == Ok(*value),
                parquet::record::Field::Long(value) => text.parse() == Ok(*value),
                parquet::record::Field::Str(value) => text == value,
                _ => false,
            };
            assert!(same, "{name}: {field} against {text}");
        }
        count += 1;
    }
    assert_eq!(count, 6);
}

/// The corners of few axes are all computed; of 16 384, those on one axis and a sample. The speeds are the last axis, which a
/// search that only begins with the first corners would leave at its first value.
#[test]
fn of_very_many_corners_the_worst_is_found_and_what_was_not_looked_at_is_said() {
    let eleven = r#"
"sphere.radius" = [0.005, 0.006]
"sphere.youngs_modulus" = [2.0e11, 2.1e11]
"sphere.poissons_ratio" = [0.29, 0.3]
"sphere.density" = [7800, 7850]
"half_space.youngs_modulus" = [2.0e11, 2.1e11]
"half_space.poissons_ratio" = [0.29, 0.3]
"half_space.yield_strength" = [3.4e8, 3.5e8]
"gravity.acceleration" = [1.6, 9.8]
"damping.viscous" = [0.001, 0.01]
"solver.tolerance" = [1e-9, 1e-10]
"impact.speed" = [0.001, 100]
"#;
    let warnings = |words: &str| {
        let text = format!("{STEEL}[sweep]\n{words}{eleven}");
        let plan = Scenario::from_text("corners", &text, &[]).unwrap().plan().unwrap().unwrap();
        plm_impact::sweep::caution::at_corners(&plan).0
    };
    let is_deep =
        |text: &String| text.contains("contact radius / sphere radius") && text.contains("impact.speed = 100 m/s");
    let few = warnings("");
    assert!(few.iter().any(is_deep) && !few.iter().any(|text| text.contains("looked at")), "{few:?}");
    let many = warnings(
        r#"law = ["plm", "thornton", "stronge", "ma_liu", "jackson_green", "kogut_etsion", "yigit_christoforou", "hertz"]"#,
    );
    assert!(many.iter().any(is_deep), "{many:?}");
    assert!(
        many.iter().any(|text| text.contains("of the 16384 corners of this table 8222 were looked at")),
        "{many:?}"
    );
}

#[test]
fn a_summary_says_what_all_rows_share_and_where_the_table_leaves_the_model() {
    let inside = summary("[sweep]\n\"impact.speed\" = [1, 3]\n\"sphere.diameter\" = [0.01, 0.02]\n");
    assert_eq!(inside["warnings"].as_array().unwrap().len(), 0);
    let inputs = inside["inputs"].as_object().unwrap();
    assert_eq!(inputs["half_space_yield_strength_Pa"], 345e6);
    assert_eq!(inputs["law"], "plm");
    assert!(!inputs.contains_key("impact_speed_m_per_s") && !inputs.contains_key("sphere_radius_m"), "{inputs:?}");
    // a/R = 0.45 is exceeded above about 20 m/s for the softer half-space; the warning names the worst corner
    let axes = "\"impact.speed\" = [1, 40, 2]\n\"half_space.yield_strength\" = [\"200 MPa\", \"2 GPa\"]\n";
    let beyond = summary(&format!("[sweep]\n{axes}"));
    let warning = beyond["warnings"][0].as_str().unwrap();
    for wanted in ["impact.speed = 40 m/s, half_space.yield_strength = 200 MPa", "is beyond 0.45"] {
        assert!(warning.contains(wanted), "{warning}");
    }
    let random = "[monte_carlo]\nsamples = 9\n\"impact.speed\" = { uniform = [1, 100] }\n";
    assert!(summary(random)["warnings"][0].as_str().unwrap().contains("is beyond 0.45"));
}
