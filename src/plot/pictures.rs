//! The file format of pictures.

use super::{Chart, PlotError};
use crate::output::OutputFile;
use crate::units::names::named;

named! {
    /// What pictures are written as. The name is also the ending of the files.
    pub enum Pictures {
        /// PNG: pixels.
        Png = "png",
        /// SVG: shapes and text, which stay sharp at any size.
        Svg = "svg",
        /// No pictures.
        None = "none",
    }
}

impl Pictures {
    /// The file of a picture; `None` if no pictures are wanted.
    pub fn file(self, name: &str, chart: &Chart) -> Result<Option<OutputFile>, PlotError> {
        let bytes = match self {
            Self::Png => chart.to_png()?,
            Self::Svg => chart.to_svg()?,
            Self::None => return Ok(None),
        };
        Ok(Some(OutputFile { name: format!("{name}.{}", self.name()), bytes }))
    }

    /// The files of pictures. If no pictures are wanted, `drawn` is not called.
    pub fn files<N: AsRef<str>>(
        self,
        drawn: impl FnOnce() -> Result<Vec<(N, Chart)>, PlotError>,
    ) -> Result<Vec<OutputFile>, PlotError> {
        if self == Self::None {
            return Ok(Vec::new());
        }
        drawn()?.iter().filter_map(|(name, chart)| self.file(name.as_ref(), chart).transpose()).collect()
    }
}
