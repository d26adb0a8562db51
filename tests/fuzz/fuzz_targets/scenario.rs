#![no_main]

#[allow(dead_code)]
#[path = "../../common/untrusted.rs"]
mod untrusted;

libfuzzer_sys::fuzz_target!(|text: &str| drop(untrusted::read_scenario(text)));
