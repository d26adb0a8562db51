//! Restitution of half-spaces whose strength rises with the strain rate: each law beside explicit finite elements of ten impacts.

use super::question::{AtlasSeries, Origin, Question};
use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::impact::Contact;
use crate::reference::{RATE_IMPACTS, ReferenceRow};
use crate::report::chart::Axis;
use crate::scenario::input::Input;
use crate::validate::comparison::{deviation, rms};
use crate::validate::rate::input_of;

/// The deviation of e in per cent over e of the finite elements. A law without a strain rate uses the strength of the slow test.
fn points(law: &LawChoice, impacts: &[(ReferenceRow, Input)], has_rate: bool) -> Vec<(f64, f64)> {
    let point = |(row, input): &(ReferenceRow, Input)| {
        let (sphere, half_space) = input.bodies(law);
        let contact = if has_rate {
            input.contact_of(sphere, half_space, law).ok()?
        } else {
            Contact::try_new(sphere, half_space, law.as_contact_law()).ok()?
        };
        let e = contact.closed_form(input.speed()).ok()?.row.measured_restitution();
        let reference = row.number("restitution");
        Some((reference, 100.0 * deviation(reference, e)))
    };
    impacts.iter().filter_map(point).collect()
}

pub(super) fn question(laws: &[(String, LawChoice)]) -> Result<Question, Error> {
    let with_input = |row: ReferenceRow| input_of(&row).map(|input| (row, input));
    let impacts = RATE_IMPACTS.rows()?.into_iter().map(with_input).collect::<Result<Vec<_>, Error>>()?;
    let mut series = Vec::new();
    for (name, law) in laws {
        let is_plm = matches!(law, LawChoice::Plm(_));
        let kinds: &[(bool, &str)] =
            if is_plm { &[(true, " with rate"), (false, ", no rate")] } else { &[(false, "")] };
        for (has_rate, kind) in kinds {
            let points = points(law, &impacts, *has_rate);
            let off: Vec<f64> = points.iter().map(|(_, off)| *off).collect();
            let deviation = format!("{:.1} %", rms(&off));
            series.push(AtlasSeries { deviation, ..AtlasSeries::new(Origin::Law, format!("{name}{kind}"), points) });
        }
    }
    series.retain(|one| !one.points.is_empty());
    Ok(Question {
        name: "rate",
        title: "Error of the restitution with a strain rate",
        caption: "% rms over ten impacts; laws without rate use the strength of the slow test; no measurements",
        axes: [
            Axis::linear("Restitution of finite elements", ""),
            Axis::linear("Error of e", "%").with_range(-60.0, 60.0),
        ],
        has_points_of_laws: true,
        series,
    })
}
