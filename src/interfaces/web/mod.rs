//! The program in a web page, for JavaScript: functions that take texts and return JSON. `src/interfaces/web/build.sh` makes the page.
//!
//! A result has the files and the warnings of the command, and its text as blocks; an error is `{"error", "exit_code", "details"}` with
//! the words of the command and what `--error-format json` says. Only the curve of e beside an impact is the page's own.

mod fields;
mod reply;

use serde_json::{Map, Value, json};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::error::{Error, ErrorKind};
use crate::report::chart::PictureFormat;
use crate::scenario::document::edit;
use crate::scenario::{Scenario, TEMPLATES};

/// Tells JavaScript why the program stopped. After that this instance of it is of no use.
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| wasm_bindgen::throw_str(&panic.to_string())));
}

/// Runs a scenario. `name` stands for its file; `data` are measurements in place of the file that `calibrate.data` names.
/// Besides the files, an impact has a `curve`: e against its speed, as a picture and as CSV. `pictures` is the format of the pictures,
/// as in the command; any other word means SVG. Without pictures a run is fast enough to follow a slider.
#[wasm_bindgen]
pub fn run(name: &str, text: &str, data: Option<String>, pictures: &str) -> String {
    let pictures = PictureFormat::from_name(pictures).unwrap_or(PictureFormat::Svg);
    reply(scenario(name, text, data).and_then(|scenario| reply::run(&scenario, pictures)))
}

/// Reads a scenario, and gives its inputs and warnings without a run.
#[wasm_bindgen]
pub fn check(name: &str, text: &str, data: Option<String>) -> String {
    let checked = scenario(name, text, data).and_then(|scenario| crate::report::run::check(&scenario));
    reply(checked.map(|outcome| json!({ "warnings": outcome.warnings, "text": outcome.terminal_text() })))
}

/// The JSON Schema of a scenario.
#[wasm_bindgen]
pub fn schema() -> String {
    crate::scenario::schema::schema().to_string()
}

/// The materials: name, what it is, the keys that take a value from it, and the page about it.
#[wasm_bindgen]
pub fn materials() -> String {
    fields::materials().to_string()
}

/// Scenarios to begin with, by name.
#[wasm_bindgen]
pub fn templates() -> String {
    Value::Object(TEMPLATES.into_iter().map(|(name, text)| (name.to_owned(), json!(text))).collect()).to_string()
}

/// The keys that are one value, for a form, in the order of the reference page.
#[wasm_bindgen]
pub fn fields() -> String {
    fields::fields().to_string()
}

/// The keys that a text gives, with their values as they are typed.
#[wasm_bindgen]
pub fn given_values(text: &str) -> String {
    let values = edit::given_values(text).map_err(|error| Error::caused_by(ErrorKind::Input, &error));
    reply(
        values.map(|values| {
            Value::Object(values.into_iter().map(|(key, value)| (key, json!(value))).collect::<Map<_, _>>())
        }),
    )
}

/// The text with another value of a key, as it is typed; an empty one takes the key away. A text that is no TOML stays.
#[wasm_bindgen]
pub fn with_value(text: &str, key: &str, value: &str) -> String {
    edit::with_value(text, key, value).unwrap_or_else(|_| text.to_owned())
}

fn scenario(name: &str, text: &str, data: Option<String>) -> Result<Scenario, Error> {
    let scenario = Scenario::from_text(name, text, &[])?;
    Ok(match data {
        Some(csv) => scenario.with_data(csv),
        None => scenario,
    })
}

fn reply(result: Result<Value, Error>) -> String {
    let reply = result.unwrap_or_else(
        |error| json!({ "error": error.to_string(), "exit_code": error.exit_code(), "details": error.details }),
    );
    reply.to_string()
}
