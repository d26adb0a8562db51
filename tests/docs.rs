//! The pages of the repository: the commands in them run and leave git clean, the output in them is the output of the
//! commands, their links are valid, and their pictures are those that the program draws.

#![allow(clippy::unwrap_used)]

mod common;

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use common::command::text;
use common::golden::{assert_golden, is_updating};
use plm_impact::numerics::fft::magnitude_at;
use tempfile::TempDir;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const TUTORIAL: &str = "scenarios/tutorial.md";
const PAPER: &str = "scenarios/paper.md";
const PAGES: [&str; 18] = [
    "README.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "src/README.md",
    "scenarios/README.md",
    "scenarios/comparison.md",
    "scenarios/gallery.md",
    "scenarios/keys.md",
    PAPER,
    "scenarios/results.md",
    "scenarios/tables.md",
    "scenarios/trust.md",
    "scenarios/units.md",
    TUTORIAL,
    "plots/bench/README.md",
    "plots/bench/python.md",
    "plots/lammps/README.md",
    "plots/validate/README.md",
];

fn read(page: &str) -> String {
    fs::read_to_string(Path::new(ROOT).join(page)).unwrap()
}

/// A page may show this of the output of a block of commands.
enum Shown<'a> {
    Nothing,
    /// All that the last command prints, behind a paragraph that ends with "prints".
    All(&'a str),
    /// Some lines of that, right behind the block.
    Lines(&'a str),
}

impl Shown<'_> {
    /// Asserts that the block shows this output, or writes the block of the page anew.
    #[track_caller]
    fn assert_shows(&self, printed: &str, page: &str) {
        if is_updating() {
            return self.update(printed, page);
        }
        match self {
            Shown::Nothing => {}
            Shown::All(text) => assert_eq!(printed, *text, "{page}"),
            Shown::Lines(text) => text.lines().for_each(|row| {
                assert!(printed.lines().any(|line| line == row), "{page}: {row} is not in\n{printed}");
            }),
        }
    }

    /// A line that the output no longer has becomes the line of the output that is most like it.
    fn update(&self, printed: &str, page: &str) {
        let (old, new) = match self {
            Shown::Nothing => return,
            Shown::All(text) => (*text, printed.to_owned()),
            Shown::Lines(text) => {
                let likeness = |row: &str, line: &str| strsim::normalized_levenshtein(row, line);
                let nearest = |row| {
                    printed.lines().max_by(|a, b| likeness(row, a).total_cmp(&likeness(row, b))).unwrap_or_default()
                };
                (*text, text.lines().map(|row| nearest(row).to_owned() + "\n").collect())
            }
        };
        let whole = read(page).replace(&format!("```text\n{old}```"), &format!("```text\n{new}```"));
        fs::write(Path::new(ROOT).join(page), whole).unwrap();
    }
}

/// The blocks of commands of a page.
fn commands(page: &str) -> Vec<(&str, Shown<'_>)> {
    let parts: Vec<&str> = page.split("```").collect();
    let block = |at: usize, language: &str| parts.get(at).and_then(|part| part.strip_prefix(language));
    (1..parts.len())
        .step_by(2)
        .filter_map(|at| {
            let between = parts.get(at + 1).map_or("", |text| text.trim());
            let shown = match block(at + 2, "text\n") {
                Some(text) if between.is_empty() => Shown::Lines(text),
                Some(text) if between.ends_with("prints") => Shown::All(text),
                _ => Shown::Nothing,
            };
            Some((block(at, "sh\n")?, shown))
        })
        .collect()
}

fn copy(from: &Path, to: &Path) {
    if from.is_dir() {
        fs::create_dir_all(to).unwrap();
        for entry in fs::read_dir(from).unwrap() {
            let name = entry.unwrap().file_name();
            copy(&from.join(&name), &to.join(&name));
        }
    } else {
        fs::create_dir_all(to.parent().unwrap()).unwrap();
        fs::copy(from, to).unwrap();
    }
}

/// A fresh clone of what the commands of the pages need, with the program as `bin/plm-impact`.
struct Clone(TempDir);

impl Clone {
    fn new() -> Self {
        let clone = Self(TempDir::new().unwrap());
        let trace = "tests/reference/lammps_hooke.txt";
        for kept in ["README.md", ".gitignore", "scenarios", "plots", "src/contact/law/plm/coefficients.toml", trace] {
            copy(&Path::new(ROOT).join(kept), &clone.path().join(kept));
        }
        clone.shell("git init -q && git add -A && git clean -fdxq", 0);
        clone.shell("git -c user.name=test -c user.email=test@localhost commit -qm all", 0);
        fs::create_dir(clone.path().join(".git/bin")).unwrap();
        symlink(env!("CARGO_BIN_EXE_plm-impact"), clone.path().join(".git/bin/plm-impact")).unwrap();
        clone
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    /// The output of a command line, which has to end with this exit code.
    fn shell(&self, line: &str, code: i32) -> String {
        let path = format!("{}:{}", self.path().join(".git/bin").display(), std::env::var("PATH").unwrap());
        let output = Command::new("sh").args(["-c", line]).current_dir(self.path()).env("PATH", path).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{line}: {}", text(&output.stderr));
        text(&output.stdout)
    }
}

/// The page for who changes the program names files and folders that are there, by their path in the repository or in `src`.
#[test]
fn architecture_page_names_existing_files() {
    let page = read("src/README.md");
    let is_path = |name: &&str| name.contains('/') && !name.contains([' ', '{', '"']);
    let paths: Vec<_> = page.split('`').skip(1).step_by(2).filter(is_path).collect();
    assert!(paths.len() > 30);
    let is_missing = |path: &&str| !["", "src"].iter().any(|root| Path::new(ROOT).join(root).join(path).exists());
    assert_eq!(paths.into_iter().filter(is_missing).collect::<Vec<_>>(), <[&str; 0]>::default());
}

#[test]
fn command_table_names_existing_commands_and_options() {
    let clone = Clone::new();
    let page = read("README.md");
    let mut count = 0;
    for line in page.lines().filter(|line| line.starts_with("| `plm-impact ")) {
        for usage in line.split('`').filter_map(|code| code.strip_prefix("plm-impact ")) {
            let help = clone.shell(&format!("plm-impact {} --help", usage.split(' ').next().unwrap()), 0);
            for option in usage.split([' ', '[', ']']).filter(|word| word.starts_with('-')) {
                let is_known = help.split_whitespace().any(|word| word.trim_end_matches(',') == option);
                assert!(is_known, "{option} in {usage}");
            }
            count += 1;
        }
    }
    assert!(count > 5, "{count}");
}

/// Rows of the table of errors on the front page, and the quantities of the page of validation that they repeat.
const ERRORS: [(&str, &str); 5] = [
    ("e, unloading exponent `\"pressure-shape\"`", "load cycle: restitution, pressure-shape"),
    ("e, unloading exponent 3/2 of the paper", "load cycle: restitution, exponent 3/2"),
    ("e, `\"pressure-shape\"`, metal that strain-hardens (≤ 0.32 R)", "hardening: restitution, pressure-shape"),
    ("force while the contact loads", "loading: force"),
    (
        "dent depth, in % of the largest indentation",
        "load cycle: residual indentation, deviation over peak indentation",
    ),
];

/// The cells of the row of a table that begins with this cell.
fn row<'a>(page: &'a str, first: &str) -> Vec<&'a str> {
    let begin = format!("| {first} | ");
    let line = page.lines().find_map(|line| line.strip_prefix(&begin)).unwrap_or_else(|| panic!("{first}"));
    line.trim_end_matches(" |").split(" | ").collect()
}

#[test]
fn errors_on_front_page_are_those_of_validation() {
    let validation = read("plots/validate/README.md");
    for (shown, quantity) in ERRORS {
        let page = read("README.md");
        let [old, computed] = [row(&page, shown).join(" | "), row(&validation, quantity)[1..].join(" | ")];
        if is_updating() {
            let line = |errors: &str| format!("| {shown} | {errors} |");
            fs::write(Path::new(ROOT).join("README.md"), page.replace(&line(&old), &line(&computed))).unwrap();
        } else {
            assert_eq!(old, computed, "{shown}");
        }
    }
}

/// The page on limits repeats the rms and largest error of e, to the digits that the page shows.
#[test]
fn errors_on_page_of_limits_are_those_of_validation() {
    let (limits, validation) = (read("scenarios/trust.md").replace('\n', " "), read("plots/validate/README.md"));
    let percent = |text: &str| text.replace('−', "-").trim_end_matches(" %").parse::<f64>().unwrap();
    let [_, mean, rms, largest] = row(&validation, "load cycle: restitution, pressure-shape")[..] else { panic!() };
    let sentence = format!("the error of e is {:.1} % rms and at most {:.1} %", percent(rms), percent(largest).abs());
    assert!(limits.contains(&sentence) && percent(mean).abs() < 0.5, "{sentence}");
    let [_, mean, ..] = row(&validation, "load cycle: restitution, exponent 3/2")[..] else { panic!() };
    let sentence = format!("e is {:.1} % too low on average", -percent(mean));
    assert!(limits.contains(&sentence), "{sentence}");
}

/// The page on limits shows the errors of e by contact radius as the table of the interval of e has them.
#[test]
fn errors_of_deep_dents_are_those_of_the_interval() {
    let (limits, errors) = (read("scenarios/trust.md"), read("src/scenario/keys/interval/law_errors.csv"));
    let cell = |class: &str, to: &str| {
        let begin = format!("{class},pressure_shape,{to},");
        let row = errors.lines().find_map(|line| line.strip_prefix(&begin)).unwrap();
        let percent = |share: &str| {
            let value = format!("{:+.1}", 100.0 * share.parse::<f64>().unwrap());
            value.replace('-', "−")
        };
        let [_, mean, low, high] = row.split(',').collect::<Vec<_>>()[..] else { panic!("{row}") };
        format!("{} % ({} to {} %)", percent(mean), percent(low), percent(high))
    };
    for (range, to) in [("up to 0.3", "0.3"), ("0.3 to 0.4", "0.4"), ("0.4 to 0.58", "0.58")] {
        let row = format!("| {range} | {} | {} |", cell("perfectly_plastic", to), cell("hardening", to));
        assert!(limits.contains(&row), "{row}");
    }
}

/// The guide states the largest representative plastic strain of the first scenario at three speeds, from a formula that it gives.
#[test]
fn strains_in_guide_are_those_of_the_first_scenario() {
    let (clone, guide) = (Clone::new(), read("scenarios/README.md"));
    let strain = |speed: &str| {
        let run =
            format!("plm-impact run scenarios/steel-on-steel.toml --json --pictures none --set impact.speed='{speed}'");
        let summary: serde_json::Value = serde_json::from_str(&clone.shell(&run, 0)).unwrap();
        let root = |key: &str| (summary[key].as_f64().unwrap() / 5e-3).sqrt();
        format!("{:.1} % at {speed}", 37.0 * (root("peak_indentation_m") - root("yield_indentation_m")))
    };
    let [slow, middle, fast] = ["0.1 m/s", "3 m/s", "10 m/s"].map(strain);
    let sentence = format!("In the half-space of `steel-on-steel.toml` this strain is {slow}, {middle} and {fast}.");
    assert!(guide.replace('\n', " ").contains(&sentence), "{sentence}");
}

/// The guide compares the pulse of the gallery with the pulse of elastic steel, and the exact pulse of Hertz with sin^(3/2).
#[test]
fn numbers_of_pulses_in_guide_are_computed() {
    let clone = Clone::new();
    let run = |out: &str, more: &str| {
        let line =
            format!("plm-impact run scenarios/ball-drop-as-source.toml --json --pictures none --out {out}{more}");
        let summary: serde_json::Value = serde_json::from_str(&clone.shell(&line, 0)).unwrap();
        let csv = fs::read_to_string(clone.path().join(out).join("pulse.csv")).unwrap();
        let forces = csv.lines().skip(1).map(|line| line.split_once(',').unwrap().1.parse::<f64>().unwrap());
        let names = ["impulse_N_s", "corner_frequency_Hz", "first_minimum_Hz"];
        let [impulse, corner, minimum] = names.map(|name| summary["pulse"][name].as_f64().unwrap());
        (forces.collect::<Vec<_>>(), summary["contact_time_s"].as_f64().unwrap(), impulse, corner, minimum)
    };
    let (forces, _, impulse, corner, minimum) = run("dented", "");
    let (exact, time, elastic_impulse, elastic_corner, elastic_minimum) =
        run("elastic", " --set half_space.yield_strength=none");
    let lowest = 1e-8 * magnitude_at(&forces, 1e-8 * minimum) / impulse;
    let sine = |k: usize| (PI * (1e-8 * k as f64 / time).min(1.0)).sin().max(0.0).powf(1.5);
    let sines: Vec<f64> = (0..exact.len()).map(sine).collect();
    let peak = exact.iter().copied().fold(0.0, f64::max);
    let most = sines.iter().zip(&exact).map(|(sine, force)| sine - force / peak).fold(0.0, f64::max);
    let excess = sines.iter().sum::<f64>() * peak / exact.iter().sum::<f64>() - 1.0;
    // the corner is between these two
    let share = |product: f64| magnitude_at(&sines, 1e-8 * product / time) / magnitude_at(&sines, 0.0);
    assert!(share(0.6595) > 0.5_f64.sqrt() && share(0.6605) < 0.5_f64.sqrt() && share(1.7495) > share(1.75));
    let guide = read("scenarios/README.md").replace("\n  ", " ");
    for sentence in [
        format!("here by {:.0} %", 100.0 * (1.0 - impulse / elastic_impulse)),
        format!("here of {:.1} % of the impulse", 100.0 * lowest),
        format!("at a frequency {:.1} % lower", 100.0 * (1.0 - minimum / elastic_minimum)),
        format!("The corner frequency falls by {:.1} %", 100.0 * (1.0 - corner / elastic_corner)),
        format!(
            "too high by up to {:.1} % of the peak, and its impulse is {:.1} % too high",
            100.0 * most,
            100.0 * excess
        ),
        format!("the exact pulse of Hertz has {:.3} and {:.3}", time * elastic_corner, time * elastic_minimum),
        "is 0.660 over the contact time and its first zero 1.750 over".to_owned(),
    ] {
        assert!(guide.contains(&sentence), "{sentence}");
    }
}

#[test]
fn front_page_is_short() {
    let size = read("README.md").len();
    assert!(size <= 9 * 1024, "{size} bytes");
}

/// The file that stands in a block of this language.
fn file_in<'a>(page: &'a str, language: &str) -> &'a str {
    let (_, rest) = page.split_once(&format!("```{language}\n")).unwrap();
    rest.split_once("```").unwrap().0
}

#[test]
fn tutorial_runs_from_heights_to_dem_input() {
    let clone = Clone::new();
    let page = read(TUTORIAL);
    clone.shell("mkdir plots/empty", 0);
    let folder = clone.path().join("plots/empty");
    fs::write(folder.join("heights.csv"), file_in(&page, "csv")).unwrap();
    let mut all = String::new();
    for (at, (block, shown)) in commands(&page).into_iter().enumerate() {
        // what the page adds to the scenario stands behind the first command
        if at == 1 {
            let scenario = fs::read_to_string(folder.join("block.toml")).unwrap();
            fs::write(folder.join("block.toml"), scenario + "\n" + file_in(&page, "toml")).unwrap();
        }
        let printed: String = block.lines().map(|line| clone.shell(&format!("cd plots/empty && {line}"), 0)).collect();
        assert!(!matches!(shown, Shown::Nothing), "{block} shows nothing of its output");
        shown.assert_shows(&printed, TUTORIAL);
        all += &printed;
    }
    // files and numbers that its sentences name
    let sentences: String = page.split("```").step_by(2).collect();
    let is_file = |code: &&str| Path::new(code).extension().is_some_and(|ending| ending == "png" || ending == "toml");
    for name in sentences.split('`').skip(1).step_by(2).filter(is_file) {
        let is_there = folder.join(name).exists() || folder.join("plots/block").join(name).exists();
        assert!(is_there, "{name}");
    }
    all += &clone.shell("plm-impact materials aluminium-6061-t6", 0);
    assert!(sentences.contains("99 HV to 113 HV") && all.contains("from 99 HV to 113 HV"), "{all}");
}

/// The heights of the tutorial are those of the law at 118 HV, within three times the scatter that it names: 1 mm and 1 %.
#[test]
fn tutorial_heights_match_its_hardness() {
    let clone = Clone::new();
    let page = read(TUTORIAL);
    clone.shell(
        "cd plots && plm-impact drop --ball steel-52100-hardened --diameter '10 mm' --on aluminium-6061-t6 --hardness '118 HV' \
         --from '1 m' --save block.toml",
        0,
    );
    for line in file_in(&page, "csv").lines().skip(2) {
        let (from, measured) = line.split_once(',').unwrap();
        let printed = clone.shell(
            &format!("plm-impact run plots/block.toml --json --pictures none --set impact.drop_height='{from} mm'"),
            0,
        );
        let height =
            1e3 * serde_json::from_str::<serde_json::Value>(&printed).unwrap()["rebound_height_m"].as_f64().unwrap();
        let off = measured.parse::<f64>().unwrap() - height;
        assert!(off.abs() < 3.0 * 1_f64.hypot(0.01 * height), "{line} {height}");
    }
}

/// The table of the paper has a row for each of its 13 figures and 3 tables. Every command of the table runs, and leaves git clean.
#[test]
fn commands_for_figures_of_paper_run() {
    let (clone, page) = (Clone::new(), read(PAPER));
    let rows: Vec<Vec<&str>> =
        page.lines().filter(|line| line.starts_with("| ")).skip(1).map(|line| line.split(" | ").collect()).collect();
    let has = |name: &str| {
        let is_end = |rest: &str| !rest.starts_with(|c: char| c.is_ascii_digit());
        rows.iter().any(|row| row[0].split(name).skip(1).any(is_end))
    };
    let names = (1..=13).map(|i| format!("Figure {i}")).chain((1..=3).map(|i| format!("Table {i}")));
    assert_eq!(names.filter(|name| !has(name)).collect::<Vec<_>>(), <[String; 0]>::default());
    let commands: BTreeSet<&str> = rows.iter().filter_map(|row| row[2].strip_prefix('`')?.strip_suffix('`')).collect();
    assert!(commands.len() > 8, "{commands:?}");
    for command in commands {
        clone.shell(command, 0);
        assert_eq!(clone.shell("git status --porcelain", 0), "", "after {command}");
    }
    // files that the last column names
    let pictures = ["figure-10-at-13.png", "figure-10-at-105.png", "figure-10-at-843.png", "validation.csv"];
    assert!(pictures.iter().all(|name| page.contains(name) && clone.path().join("plots/paper").join(name).exists()));
    let validation = fs::read_to_string(clone.path().join("plots/paper/validation.csv")).unwrap();
    assert!(validation.contains("unloading: residual indentation from the reference's peak (Eq. 23)"));
    let summary = clone
        .shell("plm-impact run scenarios/paper-case-3.toml --set impact.speed='2.719 m/s' --json --pictures none", 0);
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    assert!((1e3 * summary["residual_radius_m"].as_f64().unwrap() - 39.20).abs() < 0.005, "{summary}");
}

/// The anchor that GitHub gives a heading.
fn anchor(heading: &str) -> String {
    let kept = |c: &char| c.is_alphanumeric() || " -_".contains(*c);
    heading.trim().to_lowercase().chars().filter(kept).map(|c| if c == ' ' { '-' } else { c }).collect()
}

fn anchors(page: &str) -> BTreeSet<String> {
    page.lines().filter(|line| line.starts_with('#')).map(|line| anchor(line.trim_start_matches('#'))).collect()
}

#[test]
fn every_link_within_the_repository_leads_somewhere() {
    let mut count = 0;
    for page in PAGES {
        let body = read(page);
        let folder = Path::new(ROOT).join(page).parent().unwrap().to_owned();
        for link in body.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()) {
            if link.starts_with("https://") {
                continue;
            }
            let (file, place) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { Path::new(ROOT).join(page) } else { folder.join(file) };
            assert!(target.exists(), "{page}: {link}");
            if !place.is_empty() {
                assert!(anchors(&fs::read_to_string(target).unwrap()).contains(place), "{page}: {link}");
            }
            count += 1;
        }
    }
    assert!(count > 60, "{count}");
}

/// Registries show this page, and know neither the files of the repository nor its address: a link on it is a whole address or a
/// place on the page. What it says to type runs in an empty folder. `tests/python` runs its lines of Python.
#[test]
fn the_page_for_registries_stands_alone() {
    const NAME: &str = "src/registry.md";
    let page = read(NAME);
    let links = |page: &str| -> Vec<String> {
        let inline = page.split("](").skip(1).map(|rest| rest.split(')').next().unwrap().to_owned());
        let defined =
            page.lines().filter_map(|line| Some(line.strip_prefix('[')?.split_once("]:")?.1.trim().to_owned()));
        let html = ["href=\"", "src=\""].iter().flat_map(|begin| page.split(begin).skip(1));
        inline.chain(defined).chain(html.map(|rest| rest.split('"').next().unwrap().to_owned())).collect()
    };
    let is_relative = |link: &String| !link.starts_with("https://") && !link.starts_with('#');
    assert_eq!(links(&page).into_iter().filter(is_relative).collect::<Vec<_>>(), <[String; 0]>::default());
    // the front page has such links, so this finds them
    assert!(links(&read("README.md")).iter().filter(|link| is_relative(link)).count() > 10);

    let (cargo, python): (toml::Table, toml::Table) =
        (read("Cargo.toml").parse().unwrap(), read("pyproject.toml").parse().unwrap());
    for readme in [&cargo["package"]["readme"], &python["project"]["readme"]] {
        assert_eq!(readme.as_str(), Some(NAME));
    }
    let listed = Command::new(env!("CARGO"))
        .current_dir(ROOT)
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .output()
        .unwrap();
    let packaged = text(&listed.stdout);
    let packaged: BTreeSet<&str> = packaged.lines().collect();
    assert!(packaged.contains(NAME), "{}", text(&listed.stderr));
    // what the front page links to is in the package too, and no test, whose files and features a package has not
    for link in links(&read("README.md")).iter().filter(|link| is_relative(link)) {
        let path = link.split('#').next().unwrap().trim_end_matches('/');
        let is_there = packaged.iter().any(|file| *file == path || file.starts_with(&format!("{path}/")));
        assert!(is_there, "{link} is not in the package");
    }
    assert!(!packaged.iter().any(|file| file.starts_with("tests/")));

    let clone = Clone::new();
    let blocks = commands(&page);
    assert_eq!(blocks.len(), 2);
    for (block, _) in blocks {
        clone.shell(&format!("mkdir -p empty && cd empty && {}", block.trim().replace('\n', " && ")), 0);
    }
}

/// Paths in the gallery: the pictures of one scenario, or the folders of all scenarios.
fn gallery(scenario: &str) -> Vec<PathBuf> {
    let folder = Path::new(ROOT).join("plots/gallery").join(scenario);
    fs::read_dir(folder).into_iter().flatten().map(|entry| entry.unwrap().path()).collect()
}

/// The pictures of the gallery are those that a run has just drawn. Look at the pictures that `UPDATE=1` writes anew.
fn compare_with_gallery(scenario: &str, clone: &Clone) {
    let shown = PAGES.map(read).concat();
    for picture in gallery(scenario) {
        let within = format!("{scenario}/{}", picture.file_name().unwrap().to_str().unwrap());
        assert!(shown.contains(&format!("plots/gallery/{within})")), "no page shows {within}");
        let drawn = fs::read(clone.path().join("plots").join(&within)).unwrap();
        assert_golden(&picture, &drawn);
        assert!(common::picture::has_free_border(&drawn), "{within}");
    }
}

#[test]
fn documented_commands_run_and_reproduce_the_gallery() {
    let clone = Clone::new();
    let mut run = BTreeSet::new();
    let mut count = 0;
    for page in PAGES.into_iter().filter(|page| *page != TUTORIAL) {
        for (block, shown) in commands(&read(page)) {
            let mut last = String::new();
            if ["big.toml", "--partition-by", "pip install", "cargo rustc", "cc -I", "pkg-config", "LAMMPS_PLUGIN_PATH"]
                .iter()
                .any(|tool| block.contains(tool))
            {
                // `tests/cluster` runs the recipes for clusters, `tests/python` reads the data set, and `tests/lammps` and
                // `tests/capi.rs` build and link
                continue;
            }
            for line in block.lines().filter(|line| *line != "cargo test") {
                let code = line.split_once("# exit code ").map_or(0, |(_, code)| code.parse().unwrap());
                let command = line.replacen("cargo run --release -- ", "plm-impact ", 1);
                let command = command.split(" #").next().unwrap().trim_end();
                let printed = clone.shell(command, code);
                last.clone_from(&printed);
                assert_eq!(clone.shell("git status --porcelain", 0), "", "after {line}");
                let scenario = ["plm-impact run scenarios/", "plm-impact calibrate scenarios/"]
                    .iter()
                    .find_map(|begin| command.strip_prefix(begin)?.strip_suffix(".toml"));
                if let Some(scenario) = scenario {
                    compare_with_gallery(scenario, &clone);
                    run.insert(scenario.to_owned());
                }
                count += 1;
            }
            shown.assert_shows(&last, page);
        }
    }
    assert!(count > 15, "{count}");
    for folder in gallery("") {
        let scenario = folder.file_name().unwrap().to_str().unwrap();
        assert!(run.contains(scenario), "no page shows how to draw plots/gallery/{scenario}");
    }
}
