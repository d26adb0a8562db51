//! Tables: numbers compared with the reference, and edge cases of axes.

mod random;

use crate::common::prelude::*;

/// The table of a scenario that runs, and its summary.
fn table(text: &str) -> (String, serde_json::Value) {
    let desk = Sandbox::with_results(text);
    (desk.read("out/table.csv"), desk.summary())
}

fn summary(tables: &str) -> serde_json::Value {
    table(&format!("{STEEL}{tables}")).1
}

fn rows(text: &str) -> Rows {
    rows_of(text, NO_OVERRIDES)
}

#[test]
fn axes_multiply_and_the_first_varies_slowest() {
    let sweep = r#"[sweep]
"impact.speed" = { linspace = ["3 m/s", "1 m/s"], points = 3 }
"half_space.yield_strength" = ["345 MPa", "900 MPa"]
"sphere.radius" = { linspace = ["2 mm", "5 mm"], points = 1 }
"#;
    let (table, _) = table(&format!("{STEEL}{sweep}"));
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
        "restitution,contact_time_s,peak_force_N,peak_indentation_m,contact_radius_over_R,is_outside_validity,residual_indentation_m,dent_diameter_m,recovered_fraction,plastic_fraction,status"
    ));
    let first: Vec<&str> = table.lines().nth(1).unwrap().split(',').collect();
    let impact = contact(STEEL, &["impact.speed=3", "sphere.radius=0.002"]).closed_form(3.0).unwrap();
    let number = |i: usize| first[i].parse::<f64>().unwrap();
    // the digits give exactly the numbers of a single impact
    assert_eq!(number(4), impact.row.restitution);
    assert_eq!(number(5), impact.row.contact_time);
    assert_eq!((number(8), number(9)), (impact.row.peak_contact_radius / 0.002, 0.0));
    assert_eq!(number(11), 2.0 * impact.dent_radius.unwrap());
    assert_relative_eq!(number(12) + number(13), 1.0, max_relative = 1e-14);
}

/// The PLM holds up to a contact radius of 0.55 R, and no law beyond R: at 3 m/s steel is at 0.13 R, at 100 m/s at 0.8 R.
#[test]
fn rows_outside_the_law_have_a_status() {
    let sweep = "[sweep]\n\"impact.speed\" = [3, 10, 30, 60, 100, 1000]\n";
    let (table, _) = table(&format!("{STEEL}{sweep}"));
    let ratios = numbers(&table, "contact_radius_over_R");
    assert!(ratios[..5].is_sorted() && ratios[0] < 0.2 && ratios[5].is_nan(), "{ratios:?}");
    for (ratio, is_outside) in ratios.iter().zip(numbers(&table, "is_outside_validity")).take(5) {
        assert_eq!(is_outside, f64::from(u8::from(*ratio > 0.55)), "{ratio}");
    }
    assert_eq!(numbers(&table, "is_outside_validity").iter().filter(|is_outside| **is_outside == 1.0).count(), 2);
    assert_eq!(column(&table, "status"), ["ok", "ok", "ok", "ok", "ok", "outside_law"]);
}

/// The columns of a table by their names.
fn columns(text: &str) -> Vec<(String, Vec<String>)> {
    let (table, _) = table(text);
    let names: Vec<String> = table.lines().next().unwrap().split(',').map(str::to_owned).collect();
    names.into_iter().map(|name| (name.clone(), column(&table, &name))).collect()
}

#[test]
fn table_has_named_columns_and_same_digits() {
    let sweep = format!("{STEEL}[sweep]\n\"impact.speed\" = {{ logspace = [\"1 mm/s\", \"10 m/s\"], points = 21 }}\n");
    let few = columns(&format!("{sweep}[output]\ncolumns = [\"dent_diameter_m\", \"peak_force_N\"]\n"));
    let names: Vec<&str> = few.iter().map(|(name, _)| name.as_str()).collect();
    let want = ["case", "impact_speed_m_per_s", "restitution", "peak_force_N", "dent_diameter_m", "status"];
    assert_eq!(names, want);
    let whole = columns(&sweep);
    assert!(few.iter().all(|column| whole.contains(column)), "{few:?}");
}

/// Without air a sphere that leaves with e v rises to e² h, and waves take a part of e.
#[test]
fn table_over_drop_heights_has_rebound_heights() {
    let steel = STEEL.replace("speed = \"3 m/s\"", "drop_height = 1");
    let block = steel.replace("yield_strength", "density = 7850\nyield_strength");
    let axis = "[sweep]\n\"impact.drop_height\" = [0.1, 1, 10]\n";
    for (bodies, of) in [(steel.as_str(), "restitution"), (block.as_str(), "restitution_with_waves")] {
        let (table, _) = table(&format!("{bodies}{axis}"));
        for ((rise, height), e) in
            numbers(&table, "rebound_height_m").iter().zip([0.1, 1.0, 10.0]).zip(numbers(&table, of))
        {
            assert!((rise / (e * e * height) - 1.0).abs() < 1e-14, "{rise} {height} {e}");
        }
    }
    let speeds = STEEL.to_owned() + "[sweep]\n\"impact.speed\" = [1, 2]\n";
    assert!(!table(&speeds).0.contains("rebound_height_m"));
}

/// Writes each row so that the order of the axes does not matter: its values with the names of their columns, and its results.
fn named_rows(bodies: &str, axes: &[&str]) -> Vec<String> {
    let (table, _) = table(&format!("{bodies}[sweep]\n{}\n", axes.join("\n")));
    let mut reader = csv::Reader::from_reader(table.as_bytes());
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
}

/// More than 10⁴ contacts are not kept, and each is made where a row needs it.
#[test]
fn rows_are_independent_of_threads_and_chunks() {
    let axes = r#""sphere.radius" = { linspace = [0.001, 0.02], points = 5000 }
law = ["plm", "thornton"]
"law.plm.unloading_exponent" = [1.3, 1.4]"#;
    let text = format!("{STEEL}[law.plm]\nunloading_exponent = 1.5\n[sweep]\n{axes}\n");
    let plan = Scenario::from_text("test", &text, &[]).unwrap().plan().unwrap();
    let evaluator = Evaluator::new(&plan);
    let whole = rows(&text);
    let mut single = Rows::default();
    (0..plan.n_cases()).for_each(|case| evaluator.append_rows(case..case + 1, &mut single));
    assert!(single.results == whole.results);
    let e = |case: usize| whole.results[case].unwrap().restitution;
    let radius = "sphere.radius=0.02";
    for (case, exponent) in [(19_996, "1.3"), (19_997, "1.4")] {
        let contact = contact(STEEL, &[radius, &format!("law.plm.unloading_exponent={exponent}")]);
        assert_eq!(e(case), contact.closed_form(3.0).unwrap().row.restitution, "{exponent}");
    }
    assert_eq!(e(19_999), contact(STEEL, &[radius, "law=thornton"]).closed_form(3.0).unwrap().row.restitution);
    let table = |threads: &str| {
        let desk = Sandbox::with(&text);
        desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none", "--threads", threads], 0);
        desk.read("out/table.csv")
    };
    let one = table("1");
    assert!(one == table("2") && one == table("3"));
}

#[test]
fn case_without_result_has_a_status() {
    let desk = Sandbox::with(format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 1e-250, 1e200]\n"));
    let (_, said) = desk.run_expecting(&["run", "s.toml", "--out", "out"], 1);
    assert!(said.contains("2 of 3 cases have no result"), "{said}");
    let table = desk.read("out/table.csv");
    let lines: Vec<&str> = table.lines().collect();
    assert!(lines[1].ends_with(",ok"));
    assert_eq!(lines[2], "1,1e-250,,,,,,,,,,,out_of_float_range");
    assert_eq!(lines[3], "2,1e+200,,,,,,,,,,,out_of_float_range");
}

#[test]
fn sphere_released_at_contact_has_no_restitution() {
    // gravity is so large that the sphere leaves a dent
    let tables = "[gravity]\nacceleration = 6e6\n[sweep]\n\"impact.drop_height\" = [0, \"1 mm\"]\n";
    let text = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "") + tables;
    let desk = Sandbox::with_results(&text);
    let whole = desk.read("out/table.csv");
    assert!(whole.lines().nth(1).unwrap().starts_with("0,0.0,,,"), "{whole}");
    for key in ["restitution", "recovered_fraction", "plastic_fraction"] {
        let fields = column(&whole, key);
        assert!(fields[0].is_empty() && !fields[1].is_empty(), "{key}: {fields:?}");
    }
    assert!(column(&whole, "status").iter().all(|status| status == "ok"));
    let residual = column(&whole, "residual_indentation_m");
    assert!(residual.iter().all(|depth| depth.parse::<f64>().unwrap() > 1e-3), "{residual:?}");
    // such a row counts among the existing rows when a run resumes
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--shard", "0/1"], 0);
    desk.run_expecting(&["run", "s.toml", "--out", "out"], 0);
    assert_eq!(desk.read("out/table.csv"), whole);
}

#[test]
fn values_beyond_double_precision_are_a_status() {
    // about 80 J of the work of gravity go into the dent, which is 10^309 times the kinetic energy
    let tables = "[gravity]\nacceleration = 8e6\n[sweep]\n\"impact.speed\" = [1e-152, 1e-3]\n";
    let results = rows(&format!("{STEEL}{tables}")).results;
    assert_eq!(results[0].unwrap_err().name(), "out_of_float_range");
    let share = results[1].unwrap().plastic_fraction;
    assert!(share > 1e6 && share.is_finite(), "{share}");
}

/// The corners of few axes are all computed; of 16 384, those on one axis and a sample. The speeds are the last axis, which a
/// search that only begins with the first corners would leave at its first value.
#[test]
fn corner_sample_finds_the_worst_and_reports_coverage() {
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
        let plan = Scenario::from_text("corners", &text, &[]).unwrap().plan().unwrap();
        plm_impact::table::corner_warnings::corner_warnings(&plan, None).warnings
    };
    let is_deep =
        |text: &String| text.contains("Contact radius / sphere radius") && text.contains("impact.speed = 100 m/s");
    let few = warnings("");
    assert!(few.iter().any(is_deep) && !few.iter().any(|text| text.contains("were checked")), "{few:?}");
    let many = warnings(
        r#"law = ["plm", "thornton", "stronge", "ma_liu", "jackson_green", "kogut_etsion", "yigit_christoforou", "hertz"]"#,
    );
    assert!(many.iter().any(is_deep), "{many:?}");
    assert!(
        many.iter().any(|text| text.contains("only 8192 of the 16384 corners of this table were checked")),
        "{many:?}"
    );
}

#[test]
fn summary_lists_shared_inputs_and_model_warnings() {
    let inside = summary("[sweep]\n\"impact.speed\" = [1, 3]\n\"sphere.diameter\" = [0.01, 0.02]\n");
    assert_eq!(inside["warnings"].as_array().unwrap().len(), 0);
    let inputs = inside["inputs"].as_object().unwrap();
    assert_eq!(inputs["half_space_yield_strength_Pa"], 345e6);
    assert_eq!(inputs["law"], "plm");
    assert!(!inputs.contains_key("impact_speed_m_per_s") && !inputs.contains_key("sphere_radius_m"), "{inputs:?}");
    // a/R = 0.55 is exceeded above about 45 m/s for the softer half-space; the warning names the worst corner
    let axes = "\"impact.speed\" = [1, 60, 2]\n\"half_space.yield_strength\" = [\"200 MPa\", \"2 GPa\"]\n";
    let beyond = summary(&format!("[sweep]\n{axes}"));
    let of_depth = |summary: &Value| {
        let mut warnings =
            summary["warnings"].as_array().unwrap().iter().map(|warning| warning.as_str().unwrap().to_owned());
        warnings.find(|warning| warning.contains("exceeds 0.55")).unwrap_or_else(|| panic!("{summary}"))
    };
    let warning = of_depth(&beyond);
    assert!(warning.contains("impact.speed = 60 m/s, half_space.yield_strength = 200 MPa"), "{warning}");
    let random = "[monte_carlo]\nsamples = 9\n\"impact.speed\" = { uniform = [1, 100] }\n";
    of_depth(&summary(random));
}

#[test]
fn varied_key_needs_no_own_table() {
    let same = |without: &str, tables: &str| {
        assert!(STEEL.contains(without), "{without}");
        let gap = STEEL.replacen(without, "", 1);
        // the same scenario with the key also in its own table
        let (short, full) = (rows(&format!("{gap}{tables}")), rows(&format!("{STEEL}{tables}")));
        assert_eq!((short.axis_values, short.results), (full.axis_values, full.results), "{tables}");
    };
    same("[impact]\nspeed = \"3 m/s\"\n", "[sweep]\n\"impact.speed\" = [\"3 m/s\", 4]\n");
    same("speed = \"3 m/s\"\n", "[sweep]\n\"impact.speed\" = { logspace = [\"3 m/s\", 4], points = 3 }\n");
    same("radius = \"5 mm\"\n", "[sweep]\n\"sphere.diameter\" = { linspace = [0.01, 0.02], points = 3 }\n");
    same("density = \"7850 kg/m^3\"\n", "[monte_carlo]\nsamples = 5\n\"sphere.density\" = { uniform = [7e3, 8e3] }\n");
    let modulus =
        "[monte_carlo]\nsamples = 5\n\"sphere.youngs_modulus\" = { normal = { mean = \"200 GPa\", sd = 1e9 } }\n";
    same("youngs_modulus = \"210 GPa\"\n", modulus);
    let strength = "[sweep]\n\"half_space.yield_strength\" = [\"200 MPa\", \"300 MPa\"]\n";
    same("yield_strength = \"345 MPa\"\n", strength);
    // so may a drop height and its gravity
    let fall = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let axes = "[sweep]\n\"impact.drop_height\" = [0.5, 1]\n\"gravity.acceleration\" = [9.81, 1.62]\n";
    assert!(rows(&format!("{fall}{axes}")).results.iter().all(Result::is_ok));
}

#[test]
fn tolerance_varies_only_where_auto_integrates() {
    // under gravity the restitution is that of the energy, and the times are integrated with the tolerance
    let table = "[sweep]\n\"solver.tolerance\" = [1e-3, 1e-9]\n";
    for law in ["", "[law.thornton]\n", "[law.stronge]\n", "[law.yigit_christoforou]\n"] {
        let results = rows(&format!("{STEEL}{law}[gravity]\nacceleration = 9.81\n{table}")).results;
        let [coarse, fine] = [0, 1].map(|row: usize| *results[row].as_ref().unwrap());
        assert_eq!(coarse.restitution, fine.restitution, "{law}");
        let (coarse, fine) = (coarse.contact_time, fine.contact_time);
        assert!(coarse != fine && (coarse / fine - 1.0).abs() < 1e-2, "{law}: {coarse} {fine}");
        let scenario = Scenario::from_text("test", &format!("{STEEL}{law}{table}"), &[]).unwrap();
        let text = scenario.plan().unwrap_err().to_string();
        assert!(text.contains("this table uses the closed form"), "{law}: {text}");
    }
}
