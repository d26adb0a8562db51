//! The text and the JSON of a contact that another code computed, beside the law of a scenario.

use serde_json::{Map, Value, json};

use crate::contact_trace::TraceMeasures;
use crate::impact::Impact;
use crate::strings::align_columns;
use crate::units::{Dimension, format_four_digits, format_result};

/// Number of a trace, and of an impact by the law.
type Row = (&'static str, &'static str, Option<Dimension>, Option<f64>, fn(&Impact) -> f64);

fn rows(measures: &TraceMeasures) -> Vec<Row> {
    use Dimension::{Force, Length, Speed, Time};
    let given = Some;
    vec![
        ("impact speed", "speed_m_per_s", Some(Speed), given(measures.speed), |law| law.speed),
        ("restitution by the speeds", "restitution", None, given(measures.restitution()), |law| law.row.restitution),
        ("restitution by work and mass", "restitution_by_work", None, measures.restitution_by_work, |law| {
            law.row.restitution
        }),
        ("contact time", "contact_time_s", Some(Time), given(measures.contact_time), |law| law.row.contact_time),
        ("peak force", "peak_force_N", Some(Force), given(measures.peak_force), |law| law.row.peak_force),
        ("peak indentation", "peak_indentation_m", Some(Length), given(measures.peak_indentation), |law| {
            law.row.peak_indentation
        }),
    ]
}

fn number(value: f64, dimension: Option<Dimension>) -> String {
    dimension.map_or_else(|| format_four_digits(value), |dimension| format_result(value, dimension))
}

/// The numbers of the trace, those of the law with their ratio if there is one, and the energies.
pub fn contact_trace_text(measures: &TraceMeasures, law: Option<&Impact>) -> String {
    let mut lines: Vec<Vec<String>> = Vec::new();
    if law.is_some() {
        lines.push(["", "trace", "law", "trace/law"].map(str::to_owned).to_vec());
    }
    for (label, _, dimension, value, of_law) in rows(measures) {
        let Some(value) = value else { continue };
        let mut line = vec![label.to_owned(), number(value, dimension)];
        if let Some(law) = law {
            let by_law = of_law(law);
            line.extend([number(by_law, dimension), format_four_digits(value / by_law)]);
        }
        lines.push(line);
    }
    let energy = |value: f64| format_result(value, Dimension::Energy);
    let only = |label: &str, text: String| vec![label.to_owned(), text];
    lines.push(only("steps in contact", measures.n_steps.to_string()));
    lines.push(only("work of loading", energy(measures.loading_work)));
    lines.push(only("work absorbed by the contact", energy(measures.net_work)));
    align_columns(&lines, |column| column == 0)
}

/// These numbers as JSON.
pub fn contact_trace_json(measures: &TraceMeasures, law: Option<&Impact>, warnings: &[String]) -> Value {
    let rows = rows(measures);
    let values = |value: &dyn Fn(&Row) -> Option<f64>| {
        let fields = rows.iter().filter_map(|row| Some((row.1.to_owned(), json!(value(row)?))));
        Value::Object(fields.collect::<Map<_, _>>())
    };
    let mut trace = values(&|row| row.3);
    for (key, value) in [
        ("n_steps", json!(measures.n_steps)),
        ("loading_work_J", json!(measures.loading_work)),
        ("net_work_J", json!(measures.net_work)),
        ("work_error_J", json!(measures.work_error)),
        ("largest_pull_N", json!(measures.pull.map_or(0.0, |(force, _)| force))),
        ("largest_force_jump_N", json!(measures.largest_jump.0)),
        ("first_overlap_in_steps", json!(measures.first_overlap_in_steps)),
        ("made_energy", json!(measures.made_energy())),
    ] {
        trace[key] = value;
    }
    let law = law.map_or(Value::Null, |law| values(&|row| (row.1 != "restitution_by_work").then(|| row.4(law))));
    json!({ "trace": trace, "law": law, "warnings": warnings })
}
