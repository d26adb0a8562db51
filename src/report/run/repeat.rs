//! Impacts one after the other.

use super::impact::{can_be_traced, prepare, provenance};
use super::outcome::{Outcome, RunOptions, file, no_result, put_notes, texts, with_summary};
use crate::error::{Error, ErrorKind};
use crate::files::Counter;
use crate::impact::repeat::Repeat;
use crate::impact::{Contact, Method};
use crate::report::plot;
use crate::report::plot::{caption, captioned};
use crate::report::text::checked::of_contact;
use crate::report::text::inputs::Inputs;
use crate::report::text::notes as report_notes;
use crate::report::text::overview::overview;
use crate::report::text::repeat as report;
use crate::report::text::series::Series;
use crate::scenario::Scenario;
use crate::scenario::scene::{Input, Purpose, strength_notes};

/// The input of the first impact of a scenario, its contact, and the series to run.
pub fn prepare_repeat(scenario: &Scenario) -> Result<(Input, Contact, Repeat), Error> {
    let (mut input, contact) = prepare(scenario)?;
    let repeat = scenario.repeat(&input)?;
    // a series needs no steps where there is a closed form
    input.choose_method(Method::Auto);
    Ok((input, contact, repeat))
}

pub(super) fn outcome(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Outcome, Error> {
    let (input, contact, repeat) = prepare_repeat(scenario)?;
    can_be_traced(scenario, &input)?;
    let unwatched = Counter::default();
    let progress = options.map_or(&unwatched, |options| options.progress);
    let sequence = repeat.run(&contact, &input.solver(), input.samples(), Some(progress));
    let sequence = sequence.map_err(|reason| no_result(scenario, &reason))?;
    if progress.is_stopped() {
        return Err(Error::new(ErrorKind::Stopped(130), "the series was stopped"));
    }
    let mut idle = scenario.without_effect(std::slice::from_ref(&input), Purpose::Impact);
    idle.extend(input.flight_warnings());
    let of_impacts = sequence.warnings.iter().map(|(number, warning)| format!("impact {number}: {warning}"));
    let warnings = of_impacts.chain(texts(&idle)).collect();
    let has_dent = sequence.hits.iter().any(|hit| hit.has_dent());
    let notes = strength_notes(&input, &contact, has_dent, &[]);
    let Some(options) = options else {
        let text = report::repeat_lines(&repeat) + &overview(&input, &contact, &notes);
        return Ok(Outcome { notes, ..Outcome::checked(warnings, text, of_contact(&input, &contact)) });
    };
    let provenance = provenance(scenario, &input, sequence.method, options.command);
    let series = Series { contact: &contact, repeat: &repeat, sequence: &sequence, warnings: &warnings };
    let mut files = vec![
        file("impacts.csv", report::impacts(&sequence)?),
        file("trace.csv", report::trace(&sequence, input.samples())?),
    ];
    files.extend(options.pictures.files(|| {
        let loops = ("force_indentation", plot::repeat::loops(&repeat, &sequence)?);
        let mut drawn = vec![loops, ("impacts", plot::repeat::impacts(&repeat, &sequence))];
        drawn.extend(plot::repeat::height(&repeat, &sequence).map(|height| ("height", height)));
        drawn.extend(plot::repeat::path(&repeat, &sequence).map(|path| ("path", path)));
        Ok(captioned(drawn, &caption(&input, &["impact.speed"])))
    })?);
    let mut results = report::found(&series);
    put_notes(&mut results, &notes);
    let files = with_summary(files, provenance, results, &Inputs::new(&input))?;
    let text = report::table(&series, options.detail) + &report_notes(&notes);
    Ok(Outcome { notes, ..Outcome::done(warnings, text, files) })
}
