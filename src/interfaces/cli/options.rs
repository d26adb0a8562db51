//! Commands whose options are the keys of a scenario that nobody wrote: messages with the options in place of the keys.

use std::fmt::Write as _;

use plm_impact::error::Error;

/// The options of a command with the keys that they give.
#[derive(Debug, Clone, Copy)]
pub struct OptionKeys {
    pub command: &'static str,
    /// Keys and options.
    pub options: &'static [(&'static str, &'static str)],
}

impl OptionKeys {
    /// The name of the scenario in messages.
    pub fn scenario_name(&self) -> String {
        format!("the options of {}", self.command)
    }

    /// A text with the options in place of the keys that they give.
    pub fn with_options(&self, text: &str) -> String {
        self.options.iter().fold(text.to_owned(), |text, (key, option)| text.replace(key, option))
    }

    /// The error with options in place of lines and keys of the scenario.
    pub fn error_at_options(&self, error: Error) -> Error {
        error.with_texts(|details, _| {
            let (key, message) = (details.key.as_deref()?, details.message.as_deref()?);
            let path = ["sweep.", "monte_carlo."].iter().find_map(|table| key.strip_prefix(table)).unwrap_or(key);
            let option = self.options.iter().find(|(known, _)| *known == path).map(|(_, option)| (*option).to_owned());
            Some(format!("{}: {}", option.unwrap_or_else(|| self.scenario_name()), self.with_options(message)))
        })
    }
}

/// Appends a key and its value as TOML, if the value is given.
pub fn push_key(text: &mut String, key: &str, value: Option<&str>) {
    let _ = value.map(|value| writeln!(text, "{key} = {}", toml::Value::from(value)));
}

/// Appends the unloading exponent that the program recommends.
pub fn push_recommended_exponent(text: &mut String) {
    text.push_str(
        "\n[law.plm]\n# recommended: rms error of e 1 % (with 1.5, the exponent of the paper, e is 3 % too low)\n",
    );
    push_key(text, "unloading_exponent", Some("pressure-shape"));
}
