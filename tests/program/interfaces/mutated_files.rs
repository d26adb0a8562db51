//! Files of users with random changes: each is read, or refused in words.

use std::fs;
use std::path::Path;

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use crate::common::prelude::*;
use crate::common::untrusted::{read_flow_curve, read_measurements, read_scenario};

/// Texts that a change puts in: ends of ranges, other types, broken syntax, other alphabets.
const FRAGMENTS: [&str; 32] = [
    "nan",
    "inf",
    "-inf",
    "-0",
    "0",
    "-1",
    "1e308",
    "1e-308",
    "1e999",
    "9223372036854775808",
    "true",
    "''",
    "\"",
    "[",
    "]]",
    "{",
    "}",
    "=",
    ",",
    "\n",
    "\r\n",
    "\t",
    "#",
    "\0",
    "\u{feff}",
    "µm",
    "\" mm\"",
    "'5 mm'",
    "\u{1b}[31m",
    "é",
    "1979-05-27",
    "[sweep]\n",
];

/// The text with up to four changes.
fn mutated(random: &mut ChaCha8Rng, seeds: &[String]) -> String {
    let below = |random: &mut ChaCha8Rng, end: usize| usize::try_from(random.next_u64() % end.max(1) as u64).unwrap();
    let mut bytes = seeds[below(random, seeds.len())].clone().into_bytes();
    for _ in 0..=below(random, 4) {
        let from = below(random, bytes.len() + 1);
        let to = (from + below(random, 40)).min(bytes.len());
        match below(random, 5) {
            0 => drop(bytes.drain(from..to)),
            1 => drop(bytes.splice(from..from, FRAGMENTS[below(random, FRAGMENTS.len())].bytes())),
            2 => drop(bytes.splice(from..to, FRAGMENTS[below(random, FRAGMENTS.len())].bytes())),
            // a piece of another file
            3 => {
                let other = seeds[below(random, seeds.len())].as_bytes();
                let begin = below(random, other.len());
                let end = (begin + below(random, 200)).min(other.len());
                drop(bytes.splice(from..from, other[begin..end].iter().copied()));
            }
            _ => {
                if let Some(byte) = bytes.get_mut(from) {
                    *byte ^= 1 << below(random, 8);
                }
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Reads this number of mutated files; returns how many were read without an error.
fn read_mutated(count: usize, seeds: &[String], read: impl Fn(&str) -> Result<(), Error>) -> usize {
    let mut random = ChaCha8Rng::seed_from_u64(20);
    let mut accepted = 0;
    for _ in 0..count {
        let text = mutated(&mut random, seeds);
        let result = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| read(&text)));
        match result.unwrap_or_else(|_| panic!("a panic on\n{text}")) {
            Ok(()) => accepted += 1,
            Err(error) => {
                // the command escapes control characters when it prints a message
                assert!(!error.to_string().is_empty(), "no message on\n{text}");
            }
        }
    }
    accepted
}

fn files(folder: &str, extension: &str) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut paths: Vec<_> = fs::read_dir(root).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.retain(|path| path.extension().is_some_and(|found| found == extension));
    paths.iter().map(|path| fs::read_to_string(path).unwrap()).collect()
}

#[test]
fn mutated_scenarios_are_read_or_refused() {
    let accepted = read_mutated(6000, &files("scenarios", "toml"), read_scenario);
    // both happen, so that the changes are neither too small nor too large
    assert!((600..5400).contains(&accepted), "{accepted}");
}

#[test]
fn mutated_measurements_are_read_or_refused() {
    let mut seeds = files("scenarios", "csv");
    seeds.push("speed_m_per_s,restitution,restitution_sd,note\n1,0.6,0.01,\"a, b\"\n2,0.5,,c\n".to_owned());
    seeds.push("# a test\nindentation_um;force_N\n1;0.5\n2;1.4\n".to_owned());
    let accepted = read_mutated(3000, &seeds, read_measurements);
    assert!((300..2700).contains(&accepted), "{accepted}");
}

#[test]
fn mutated_flow_curves_are_read_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    let seeds = [
        "plastic_strain,stress_Pa\n0,3.45e8\n0.01,3.6e8\n0.1,4.4e8\n".to_owned(),
        "# tensile test\nplastic_strain,stress_Pa\n0,3.45e8\n0.002,3.5e8\n0.02,3.8e8\n0.2,5e8\n1,6e8\n".to_owned(),
    ];
    let accepted = read_mutated(1500, &seeds, |text| read_flow_curve(folder.path(), text));
    // most changes leave no rising curve
    assert!((15..1350).contains(&accepted), "{accepted}");
}

/// The fuzzer is no part of CI, so a file that moves must be found here.
#[test]
fn fuzz_targets_find_the_readers() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/fuzz_targets");
    let targets: Vec<_> = fs::read_dir(&folder).unwrap().map(|target| target.unwrap().path()).collect();
    assert_eq!(targets.len(), 3);
    for target in targets {
        let text = fs::read_to_string(&target).unwrap();
        let (_, path) = text.split_once("#[path = \"").unwrap();
        let place = folder.join(path.split('"').next().unwrap());
        assert!(place.is_file(), "{}: {}", target.display(), place.display());
    }
}
