//! The file format of pictures.

use super::Chart;
use crate::error::Error;
use crate::files::OutputFile;
use crate::strings::named_enum;

named_enum! {
    /// The file format of pictures.
    pub enum PictureFormat {
        Png = "png",
        /// SVG: shapes and text, which stay sharp at any size.
        Svg = "svg",
        /// SVG for a column of a paper or a narrow window: half as wide, with letters of the same size and the key below.
        NarrowSvg = "narrow-svg",
        /// No pictures.
        None = "none",
    }
}

impl PictureFormat {
    /// The file of a picture; `None` if no pictures are wanted.
    pub fn to_file(self, name: &str, chart: &Chart) -> Result<Option<OutputFile>, Error> {
        let (ending, bytes) = match self {
            Self::Png => ("png", chart.to_png()?),
            Self::Svg => ("svg", chart.to_svg()?),
            Self::NarrowSvg => ("svg", chart.to_narrow_svg()?),
            Self::None => return Ok(None),
        };
        Ok(Some(OutputFile { name: format!("{name}.{ending}"), bytes }))
    }

    /// The files of pictures. If no pictures are wanted, `drawn` is not called.
    pub fn to_files<N: AsRef<str>>(
        self,
        drawn: impl FnOnce() -> Result<Vec<(N, Chart)>, Error>,
    ) -> Result<Vec<OutputFile>, Error> {
        if self == Self::None {
            return Ok(Vec::new());
        }
        drawn()?.iter().filter_map(|(name, chart)| self.to_file(name.as_ref(), chart).transpose()).collect()
    }
}
