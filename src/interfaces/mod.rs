//! The ways into the program: Python, C, the browser, and lines for other codes. An interface has a folder, with what it needs in
//! other languages. The command, `interfaces/cli`, belongs to the binary; the plug-in for LAMMPS stands on the functions for C.

#[cfg(feature = "capi")]
pub mod c;
pub mod export;
#[cfg(feature = "python")]
mod python;
#[cfg(all(feature = "web", target_arch = "wasm32"))]
mod web;
