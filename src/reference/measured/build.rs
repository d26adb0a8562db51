//! The build script of the crate: it lists the data files of this folder, so that a new measured set is a file and no code.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/reference/measured");
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut paths = fs::read_dir(&folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "csv"));
    paths.sort();
    let mut list = "[\n".to_owned();
    for path in &paths {
        let [name, path] = [path.file_name().unwrap_or_default(), path.as_os_str()].map(|text| text.to_string_lossy());
        let _ = writeln!(list, "({name:?}, include_str!({path:?})),");
    }
    let out = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("Cargo gave no folder for the output"))?;
    fs::write(Path::new(&out).join("measured_sets.rs"), list + "]\n")
}
