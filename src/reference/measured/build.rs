//! The build script of the crate: it lists the data files of this folder, so that a new measured set is a file and no code.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/reference/measured");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(&folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        names.extend(Some(name).filter(|name| name.ends_with(".csv")));
    }
    names.sort();
    let mut list = "[\n".to_owned();
    for name in &names {
        let _ = writeln!(list, "({name:?}, include_str!({:?})),", folder.join(name));
    }
    let out = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("Cargo gave no folder for the output"))?;
    fs::write(Path::new(&out).join("measured_sets.rs"), list + "]\n")
}
