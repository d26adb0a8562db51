//! What pictures are written as.

use super::{Canvas, PlotError};
use crate::output::OutputFile;

/// What pictures are written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pictures {
    /// Pixels.
    Png,
    /// Shapes and text, which stay sharp in any size.
    Svg,
    /// Not at all.
    None,
}

impl Pictures {
    /// All ways.
    pub const ALL: [Self; 3] = [Self::Png, Self::Svg, Self::None];

    /// Its name on the command line, which is the ending of the files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Svg => "svg",
            Self::None => "none",
        }
    }

    /// The file of a picture; `None` where no pictures are wanted.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn file(self, name: &str, canvas: &Canvas) -> Result<Option<OutputFile>, PlotError> {
        let bytes = match self {
            Self::Png => canvas.to_png()?,
            Self::Svg => canvas.to_svg()?,
            Self::None => return Ok(None),
        };
        Ok(Some(OutputFile { name: format!("{name}.{}", self.name()), bytes }))
    }

    /// The files of pictures; where none are wanted, nothing is drawn.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn files<N: AsRef<str>>(
        self,
        drawn: impl FnOnce() -> Result<Vec<(N, Canvas)>, PlotError>,
    ) -> Result<Vec<OutputFile>, PlotError> {
        if self == Self::None {
            return Ok(Vec::new());
        }
        drawn()?.iter().filter_map(|(name, canvas)| self.file(name.as_ref(), canvas).transpose()).collect()
    }
}
