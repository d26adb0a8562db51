//! `plm-impact keys`

use clap::Args;
use plm_impact::error::Error;
use plm_impact::scenario::key_docs::{describe_keys, describe_result};
use plm_impact::scenario::keys::ALL_KEYS;
use plm_impact::strings::did_you_mean;

/// Explain scenario keys (meaning, unit, range, default)
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  plm-impact keys impact.angle
  plm-impact keys hardness")]
pub struct KeysArguments {
    /// A key with its table, or a part of several keys [default: all]
    #[arg(default_value = "", hide_default_value = true)]
    key: String,
}

pub fn keys(KeysArguments { key }: &KeysArguments) -> Result<(), Error> {
    let text = describe_keys(key).ok_or_else(|| {
        if let Some(about) = describe_result(key) {
            return Error::input(format!("\"{key}\" is a result, not a key: {about}"));
        }
        let known = "`plm-impact keys` prints all";
        let names = ALL_KEYS.iter().map(|known| known.path);
        Error::input(format!("unknown key \"{key}\"{}", did_you_mean(key, names, '"', known)))
    })?;
    super::terminal::print(&text)
}
