#![no_main]

use std::sync::LazyLock;

#[allow(dead_code)]
#[path = "../../common/untrusted.rs"]
mod untrusted;

static FOLDER: LazyLock<tempfile::TempDir> = LazyLock::new(|| tempfile::tempdir().expect("a folder for temporary files"));

libfuzzer_sys::fuzz_target!(|text: &str| drop(untrusted::read_flow_curve(FOLDER.path(), text)));
