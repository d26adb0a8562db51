//! `plm-impact reference`

use std::path::PathBuf;

use clap::Args;
use plm_impact::error::Error;
use plm_impact::scene::reference;

use super::terminal::other;

/// Print the tables of all keys and results, or write them into a page between its marks
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact reference > keys.md
  plm-impact reference scenarios/README.md")]
pub struct Arguments {
    /// Markdown page to write them into, such as scenarios/README.md
    #[arg(value_name = "PAGE")]
    page: Option<PathBuf>,
}

pub fn reference(arguments: &Arguments) -> Result<(), Error> {
    let Some(page) = &arguments.page else {
        return super::terminal::print(&reference::page());
    };
    let name = page.display();
    let text = std::fs::read_to_string(page).map_err(other(format!("{name}: cannot be read")))?;
    let renewed = reference::renewed(&text).map_err(|[begin, end]| {
        Error::Option(format!("{name}: has no marks to write between; put in \"{begin}\" and \"{end}\""))
    })?;
    std::fs::write(page, renewed).map_err(other(format!("{name}: cannot be written")))
}
