//! Tests of reports and pictures.

pub mod charts;
pub mod external_pictures;
pub mod files;
pub mod limits_page;
pub mod picture_labels;
pub mod picture_numbers;
pub mod pictures;
pub mod svg_reader;
pub mod unreliable_results;
