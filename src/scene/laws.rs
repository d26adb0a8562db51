//! `[law]`: one table, named by its law, with that law's own keys. The keys stand for fields of the laws themselves.

use std::sync::Arc;

use super::field::{Field, Held, show_word};
use super::key::AnyKey;
use super::key::Form::{self, Number, NumberOr, Text, Word};
use super::quantity::{AREA_FACTOR, EXPONENT, FACTOR, SHARE, STRENGTH, TRANSITION_RATIO};
use super::read::{Fault, Reader};
use super::table::{Numeric, Table as _, keys, numeric, tables};
use super::words::{HARDNESSES, JUMPS, LOADINGS, UNLOADINGS};
use super::written::{Node, Value};
use crate::law::catalogue::brake::Brake;
use crate::law::catalogue::hertz::Hertz;
use crate::law::catalogue::jackson_green::JacksonGreen;
use crate::law::catalogue::johnson::Johnson;
use crate::law::catalogue::kogut_etsion::KogutEtsion;
use crate::law::catalogue::kogut_komvopoulos::KogutKomvopoulos;
use crate::law::catalogue::ma_liu::MaLiu;
use crate::law::catalogue::mesarovic_johnson::MesarovicJohnson;
use crate::law::catalogue::stronge::Stronge;
use crate::law::catalogue::thornton::Thornton;
use crate::law::catalogue::walton_braun::WaltonBraun;
use crate::law::catalogue::yigit_christoforou::YigitChristoforou;
use crate::law::{Combined, LawChoice, Plm, PlmCoefficients};

keys! {
    Plm {
        /// Exponent of the unloading force, or "pressure-shape": the exponent that follows from the shape of the contact
        /// pressure at the peak. Other numbers than 1.5 are for comparison.
        unloading_exponent in exponent: NumberOr(&EXPONENT, "pressure-shape") => "1.5",
        /// File of coefficients of the loading curve, relative to the scenario.
        coefficients: Text("my.toml") => "built in",
    }
    Hertz {}
    Thornton {
        /// Contact pressure at which the straight part of the loading begins.
        yield_pressure: Number(&STRENGTH) => "largest Hertz pressure at first yield",
    }
    Stronge {
        /// Mean contact pressure at first yield over the yield strength.
        yield_pressure_ratio: Number(&FACTOR) => "1.1",
        /// Factor f_u of the recovered approach.
        unloading_factor: Number(&FACTOR) => "1",
    }
    JacksonGreen {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor: Number(&FACTOR) => "1.295 exp(0.736 nu)",
        /// Formula of the geometric hardness: exponential is that of 2005, cosine the later one.
        hardness: Word(&HARDNESSES) => "\"exponential\"",
        /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
        jumps: Word(&JUMPS) => "\"printed\"",
    }
    KogutEtsion {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor: Number(&FACTOR) => "(0.454 + 0.41 nu) x 2.8",
        /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
        jumps: Word(&JUMPS) => "\"printed\"",
    }
    KogutKomvopoulos {
        /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
        jumps: Word(&JUMPS) => "\"printed\"",
    }
    YigitChristoforou {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor: Number(&FACTOR) => "1.649",
    }
    MaLiu {
        /// Hardness over the yield strength.
        hardness_ratio: Number(&FACTOR) => "2.8",
        /// Indentation of full plasticity over that at first yield.
        transition_ratio: Number(&TRANSITION_RATIO) => "110",
    }
    Brake {}
    MesarovicJohnson {
        /// True contact area over the area in which the sphere cuts the original surface.
        area_factor: Number(&AREA_FACTOR) => "1.43",
    }
    WaltonBraun {
        /// Stiffness of loading, in units of force over indentation at first yield.
        loading_stiffness: Number(&FACTOR) => "1",
        /// Stiffness of loading over that of unloading; the restitution is the square root of this ratio.
        stiffness_ratio: Number(&SHARE) => "0.5",
    }
    Johnson {
        /// Mean contact pressure while the sphere goes in.
        dynamic_pressure: Number(&STRENGTH) => "3 yield strengths",
    }
}

tables! {
    /// `[law.combined]`: the loading of one law with the unloading of another.
    pub struct HalvesInput {
        /// Law of the loading.
        loading: Option<String> as Word(&LOADINGS),
        /// Law of the unloading.
        unloading: Option<String> as Word(&UNLOADINGS),
    }
}

/// The law that is named, PLM if none is.
#[derive(Debug, Clone, Default)]
pub struct LawInput {
    /// The law with its parameters, but for a flow curve of the half-space.
    pub choice: LawChoice,
    /// The halves of a combined law.
    pub halves: Option<HalvesInput>,
}

/// The laws by their names, with the table of each.
macro_rules! laws {
    ($($name:literal $law:ident),* $(,)?) => {
        /// Takes the keys of the table of this law.
        fn take(choice: &mut LawChoice, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
            match choice {
                $(LawChoice::$law(law) => law.take(node, reader),)*
                LawChoice::Combined(_) => Ok(()),
            }
        }

        /// Adds what the keys of this law have, for reports.
        pub(super) fn show(choice: &LawChoice, into: &mut Vec<Held>) {
            match choice {
                $(LawChoice::$law(law) => law.show_keys(concat!("law.", $name), into),)*
                LawChoice::Combined(_) => {}
            }
        }

        /// The keys of all laws.
        pub fn keys(path: &str, into: &mut Vec<AnyKey>) {
            $(<$law>::keys(&format!("{path}.{}", $name), into);)*
            HalvesInput::keys(&format!("{path}.{COMBINED}"), into);
        }

        /// The numeric keys of all laws.
        pub(super) fn numeric_keys() -> Vec<Numeric<LawChoice>> {
            let mut keys = Vec::new();
            $(keys.extend(numeric::<LawChoice, $law>(
                concat!("law.", $name),
                |choice| if let LawChoice::$law(law) = choice { Some(law) } else { None },
                |choice| if let LawChoice::$law(law) = choice { Some(law) } else { None },
            ));)*
            keys
        }
    };
}

laws!(
    "plm" Plm,
    "hertz" Hertz,
    "thornton" Thornton,
    "stronge" Stronge,
    "jackson_green" JacksonGreen,
    "kogut_etsion" KogutEtsion,
    "kogut_komvopoulos" KogutKomvopoulos,
    "yigit_christoforou" YigitChristoforou,
    "ma_liu" MaLiu,
    "brake" Brake,
    "mesarovic_johnson" MesarovicJohnson,
    "walton_braun" WaltonBraun,
    "johnson" Johnson,
);

/// The law of two halves.
pub const COMBINED: &str = "combined";
const ONE_LAW: &str = "write one table such as [law.plm], or leave [law] out";

impl Field for LawInput {
    fn read(&mut self, _: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let Value::Table(laws) = &node.value else {
            return Err(Fault::at(node, format!("not a table; {ONE_LAW}")));
        };
        let [law] = &laws.0[..] else {
            let found: Vec<&str> = laws.0.iter().map(|law| law.name.as_str()).collect();
            let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
            return Err(Fault::at(node, format!("a scenario has exactly one law, found {found}; {ONE_LAW}")));
        };
        if law.name == COMBINED {
            let mut halves = HalvesInput::default();
            reader.within(COMBINED, |reader| halves.take(&law.node, reader));
            if let (Some(loading), Some(unloading)) = (&halves.loading, &halves.unloading) {
                let half = |name: &str| LawChoice::from_name(name).unwrap_or_default().into();
                self.choice = LawChoice::Combined(Combined { loading: half(loading), unloading: half(unloading) });
            }
            self.halves = Some(halves);
        } else if let Some(choice) = LawChoice::all().into_iter().find(|choice| choice.about().name == law.name) {
            self.choice = choice;
            reader.within(&law.name, |reader| take(&mut self.choice, &law.node, reader));
        } else {
            let known: Vec<&str> = LawChoice::names().into_iter().chain([COMBINED]).collect();
            reader.unknown(&law.name, law.span.clone(), &known);
        }
        Ok(())
    }
}

/// Coefficients of a file.
impl Field for Arc<PlmCoefficients> {
    fn read(&mut self, _: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let [path, text] = reader.file(node, "my.toml")?;
        let table = PlmCoefficients::from_toml(&text);
        let table = table.map_err(|error| Fault::at(node, format!("{path}: {}", error.to_string().trim_end())))?;
        *self = Self::new(table);
        Ok(())
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        show_word(format!("{} ({})", self.provenance.name, self.provenance.source), path, into);
    }
}
