//! From a result to its files: what a kind of scene computes and writes, its texts, and its pictures.

pub mod plot;
pub mod run;
pub mod text;
