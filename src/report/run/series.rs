//! Impacts one after the other.

use super::impact::{check_trace_method, prepare, provenance};
use super::outcome::{Outcome, RunOptions, output_file, put_notes, warning_texts, with_summary};
use crate::error::{Error, ErrorKind};
use crate::files::Progress;
use crate::impact::series::ImpactSeries;
use crate::impact::{Contact, Method};
use crate::report::pictures;
use crate::report::pictures::{caption, with_captions};
use crate::report::text::check::contact_fields;
use crate::report::text::inputs::Inputs;
use crate::report::text::note_blocks;
use crate::report::text::overview::overview;
use crate::report::text::series as report;
use crate::results::series::SeriesReport;
use crate::scenario::input::Input;
use crate::scenario::keys::strength_notes;
use crate::scenario::{Kind, Scenario, no_result_error};

/// The input of the first impact of a scenario, its contact, and the series to run.
pub fn prepare_series(scenario: &Scenario) -> Result<(Input, Contact, ImpactSeries), Error> {
    let (mut input, contact) = prepare(scenario)?;
    let repeat = scenario.series(&input)?;
    // a series needs no steps where there is a closed form
    input.set_default_method(Method::Auto);
    Ok((input, contact, repeat))
}

pub(super) fn run(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Outcome, Error> {
    let (input, contact, repeat) = prepare_series(scenario)?;
    check_trace_method(scenario, &input)?;
    let unwatched = Progress::default();
    let progress = options.map_or(&unwatched, |options| options.progress);
    let sequence = repeat.run(&contact, &input.solver(), input.samples(), Some(progress));
    let sequence = sequence.map_err(|reason| no_result_error(scenario, &reason))?;
    if progress.is_stopped() {
        return Err(Error::new(ErrorKind::Stopped(130), "the series was stopped"));
    }
    let mut idle = scenario.unused_key_warnings(std::slice::from_ref(&input), Kind::Repeat);
    idle.extend(input.flight_warnings());
    let of_impacts = sequence.warnings.iter().map(|(number, warning)| format!("impact {number}: {warning}"));
    let warnings = of_impacts.chain(warning_texts(&idle)).collect();
    let has_dent = sequence.impacts.iter().any(|hit| hit.impact.row.has_dent());
    let notes = strength_notes(&input, &contact, has_dent, &[]);
    let Some(options) = options else {
        let blocks = [report::check_blocks(&repeat), overview(&input, &contact, &notes)].concat();
        return Ok(Outcome { notes, ..Outcome::from_check(warnings, blocks, contact_fields(&input, &contact)) });
    };
    let provenance = provenance(scenario, &input, sequence.method, options.command);
    let series = SeriesReport { contact: &contact, repeat: &repeat, sequence: &sequence, warnings: &warnings };
    let mut files = vec![
        output_file("impacts.csv", report::impacts_csv(&sequence)?),
        output_file("trace.csv", report::trace_csv(&sequence, input.samples())?),
    ];
    files.extend(options.pictures.to_files(|| {
        let loops = ("force_indentation", pictures::series::loops_chart(&repeat, &sequence)?);
        let mut drawn = vec![loops, ("impacts", pictures::series::impacts_chart(&repeat, &sequence))];
        drawn.extend(pictures::series::height_chart(&repeat, &sequence).map(|height| ("height", height)));
        drawn.extend(pictures::path::path_chart(&repeat, &sequence).map(|path| ("path", path)));
        let from_above = pictures::path::path_from_above_chart(&repeat, &sequence);
        drawn.extend(from_above.map(|path| ("path_from_above", path)));
        Ok(with_captions(drawn, &caption(&input, &["impact.speed"])))
    })?);
    let mut results = report::summary_fields(&series);
    put_notes(&mut results, &notes);
    let files = with_summary(files, provenance, results, &Inputs::new(&input))?;
    let blocks = [report::result_blocks(&series, options.detail), note_blocks(&notes)].concat();
    Ok(Outcome { notes, ..Outcome::from_run(warnings, blocks, files) })
}
