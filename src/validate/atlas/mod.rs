//! The atlas: one picture for each question, with every law, every set of finite elements and every measured set that answers it. The key
//! has the root mean square deviation of each law. `atlas.csv` has all points.

mod normal;
mod oblique;
mod plate;
mod question;
mod rate;

use std::fmt::Write as _;

use rayon::prelude::*;

pub use question::{AtlasSeries, Origin, Question};

use super::laws::LawDeviations;
use crate::contact::law::{LawChoice, Plm, PlmCoefficients};
use crate::error::Error;
use crate::files::{OutputFile, Progress};
use crate::report::chart::PictureFormat;
use crate::validate::comparison::EXPONENTS;

/// The section of the page.
pub const SECTION: &str = include_str!("page.md");

/// Every law with its default parameters, and the PLM with these coefficients, in the order of the laws of the table.
fn laws(coefficients: &PlmCoefficients, deviations: &[LawDeviations]) -> Vec<(String, LawChoice)> {
    let of_plm =
        EXPONENTS.map(|(exponent, name)| (format!("plm, {name}"), LawChoice::Plm(Plm::new(coefficients, exponent))));
    let law = |one: &LawDeviations| {
        let plm = of_plm.iter().find(|(name, _)| *name == one.name).map(|(_, law)| law.clone());
        Some((one.name.clone(), plm.or_else(|| LawChoice::from_name(&one.name))?))
    };
    deviations.iter().filter_map(law).collect()
}

/// All questions.
pub fn questions(coefficients: &PlmCoefficients, deviations: &[LawDeviations]) -> Result<Vec<Question>, Error> {
    let laws = laws(coefficients, deviations);
    let mut all = normal::questions(coefficients, deviations, &laws)?;
    all.push(oblique::question()?);
    all.push(plate::question(&laws)?);
    all.push(rate::question(&laws)?);
    Ok(all)
}

/// The points of all questions.
pub fn csv(questions: &[Question]) -> String {
    let mut text = "question,origin,series,rms,x,y\n".to_owned();
    for question in questions {
        for one in &question.series {
            for (x, y) in &one.points {
                let AtlasSeries { origin, name, deviation, .. } = one;
                let _ = writeln!(text, "{},{},\"{name}\",{deviation},{x},{y}", question.name, origin.name());
            }
        }
    }
    text
}

/// The pictures. `progress` counts them.
pub fn pictures(questions: &[Question], format: PictureFormat, progress: &Progress) -> Result<Vec<OutputFile>, Error> {
    progress.add_total(questions.len() as u64);
    let file = |question: &Question| {
        let name = format!("atlas-{}", question.name);
        format.to_file(&name, &question.chart()).inspect(|_| progress.advance())
    };
    let drawn: Result<Vec<Option<OutputFile>>, Error> = questions.par_iter().map(file).collect();
    Ok(drawn?.into_iter().flatten().collect())
}
