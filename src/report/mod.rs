//! From a result to its files. `run` has a file for each kind of scenario, which computes it and collects its files; `text` makes
//! summaries, tables and lines for the terminal; `plot` makes pictures.

pub mod chart;
pub mod pictures;
pub mod run;
pub mod text;
