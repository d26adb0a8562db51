//! Tests of reports and pictures.

pub mod charts;
pub mod files;
pub mod picture_numbers;
pub mod pictures;
pub mod svg_reader;
