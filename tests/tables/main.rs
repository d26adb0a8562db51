//! Tests of tables: rows, files, shards, interruptions, and the same bytes on every machine.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod files;
mod limits;
mod machines;
mod one_row;
mod parquet;
mod parts;

mod sweep;
